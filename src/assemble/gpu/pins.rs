//! Pins of a level whose displacement stays on the card.

use super::buffer::Buffer;
use super::device::Gpu;
use super::kernels::{GROUP, Kernel, Solver, binding};
use crate::assemble::CpuAssembler;
use crate::grid::Grid;
use crate::stencil::StencilOperator;
use std::collections::BTreeMap;
use wgpu::{BindGroup, BufferUsages, ComputePass};

pub(super) struct Pins {
    /// By step tried; of the first, none, the gradient as well.
    pull: Vec<BindGroup>,
    stiffen: BindGroup,
    knots: usize,
    // Bound, and kept for that.
    _buffers: [Buffer; 3],
}

impl Pins {
    /// None where nothing is tied. `results`: where the energies of each step go; `buffer`: what else is bound.
    pub fn new<'a, const D: usize>(
        gpu: &Gpu,
        solver: &Solver,
        twin: &CpuAssembler<D>,
        results: &[&Buffer],
        buffer: impl Fn(u32) -> &'a wgpu::Buffer,
    ) -> Option<Self> {
        if twin.pins.is_empty() {
            return None;
        }
        let (cells, offsets) = (twin.grid.cells() as f64, twin.grid.corner_offsets());
        let neighbours = StencilOperator::<D>::corner_neighbours();
        let (mut rows, mut ties, mut knots) = (Vec::new(), Vec::new(), BTreeMap::new());
        for (number, pin) in twin.pins.iter().enumerate() {
            rows.push(pin.base as u32);
            rows.extend(pin.shares[..Grid::<D>::CORNERS].iter().map(|&share| (share as f32).to_bits()));
            rows.extend(pin.offset.map(|offset| ((offset * cells) as f32).to_bits()));
            for a in 0..Grid::<D>::CORNERS {
                let (node, pull) = (pin.base + offsets[a], pin.weight * pin.shares[a]);
                let numbers = [pull / (cells * cells), 2.0 * pull / cells].map(|x| (x as f32).to_bits());
                ties.push([node as u32, number as u32, numbers[0], numbers[1]]);
                for b in a..Grid::<D>::CORNERS {
                    let slot = neighbours[a][b] - StencilOperator::<D>::CENTRE;
                    *knots.entry((node as u32, slot as u32)).or_insert(0.0) += 2.0 * pull * pin.shares[b];
                }
            }
        }
        ties.sort_by_key(|tie| tie[0]);
        let knots: Vec<_> =
            knots.into_iter().map(|((node, slot), stiffness)| [node, slot, (stiffness as f32).to_bits(), 0]).collect();
        let stored = |numbers: &[u32]| Buffer::filled(gpu, BufferUsages::STORAGE, numbers);
        let buffers = [stored(&rows), stored(ties.as_flattened()), stored(knots.as_flattened())];
        let bind = |kernel: &Kernel, results: &Buffer| {
            kernel.bind(&gpu.device, |number| match number {
                binding::PINS => &buffers[0],
                binding::TIES => &buffers[1],
                binding::KNOTS => &buffers[2],
                binding::RESULTS => results,
                _ => buffer(number),
            })
        };
        let pull = |(number, &results)| bind(&solver.pull_pins[usize::from(number == 0)], results);
        Some(Self {
            pull: results.iter().enumerate().map(pull).collect(),
            stiffen: bind(&solver.stiffen_pins, results[0]),
            knots: knots.len(),
            _buffers: buffers,
        })
    }

    /// Energy, into the results of that step, which the other terms have had; forces, if it is none.
    pub fn pull(&self, gpu: &Gpu, solver: &Solver, pass: &mut ComputePass<'_>, step: usize) {
        solver.pull_pins[usize::from(step == 0)].dispatch(gpu, pass, &self.pull[step], GROUP);
    }

    /// Adds to the hessian.
    pub fn stiffen(&self, gpu: &Gpu, solver: &Solver, pass: &mut ComputePass<'_>) {
        solver.stiffen_pins.dispatch(gpu, pass, &self.stiffen, self.knots);
    }
}
