//! A step of Newton's method that stays on the card: displacement, gradient, hessian, direction. What comes back are sums,
//! by which the step's length is chosen.

use super::buffer::Buffer;
use super::device::Gpu;
use super::forces::{Forces, ROW, Sums, sum_of_rows};
use super::gradients::Gradients;
use super::hessian::Pairs;
use super::hierarchy::{Hierarchy, SCALARS, SHIFT};
use super::kernels::{GROUP, Kernels, Solver, binding};
use super::level::Level;
use super::pins::Pins;
use super::slab::Slab;
use super::upload::LARGEST;
use crate::assemble::CpuAssembler;
use crate::assemble::step::{FORCING, MOST_LINEAR_STEPS, Renewal};
use crate::grid::Grid;
use crate::stencil::StencilOperator;
use bytemuck::cast_slice;
use std::ops::Range;
use wgpu::{BindGroup, BufferUsages, ComputePass};

/// Steps that are tried: none, and the whole one and its halves.
pub(super) const STEPS: [f64; 8] = [0.0, 1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625];
/// As many of them are evaluated along with the derivatives; the others once these are refused.
pub(super) const EAGER: usize = 4;
/// Rows of sums for each. With all that are evaluated in an iteration they are less than 4 kB.
const ROWS: usize = 12;
/// Steps of conjugate gradients at first, of which mostly fewer are needed.
const LINEAR_STEPS: usize = 4;
/// More than there were, for the next time.
const SPARE: usize = 2;

pub(super) struct Resident<const D: usize> {
    grid: Grid<D>,
    pairs: Pairs,
    gradients: Gradients<D>,
    coordinates: Buffer,
    tries: Vec<Try>,
    gather: Vec<BindGroup>,
    weigh: BindGroup,
    stiffen: BindGroup,
    pins: Option<Pins>,
    staging: Buffer,
    is_reading: bool,
    rows: usize,
    /// The displacement and the operator are those of an iteration.
    pub is_there: bool,
    /// The step that has been chosen and is still to be gone.
    chosen: Option<usize>,
    /// What has been added to the operator's diagonal, in units of its mean.
    shift: f32,
    linear_steps: usize,
}

/// What belongs to a step's length.
struct Try {
    place: BindGroup,
    go: BindGroup,
    reduce: BindGroup,
    results: Buffer,
    _length: Buffer,
}

/// What a submission tells.
pub(super) struct Told {
    /// By steps tried.
    pub sums: Vec<Sums>,
    /// ∇E·d.
    pub slope: f64,
}

impl<const D: usize> Resident<D> {
    /// None where a level is too large to stay on the card.
    pub fn new(
        gpu: &Gpu,
        kernels: &Kernels,
        level: &Level,
        forces: &Forces,
        pairs: Pairs,
        twin: &CpuAssembler<D>,
    ) -> Option<Self> {
        let (solver, grid) = (kernels.solver(gpu), twin.grid);
        let hierarchy = Hierarchy::new(gpu, solver, grid, FORCING as f32)?;
        let gradients = Gradients::new(gpu, solver, grid, hierarchy, &forces.gradient);
        let (stored, copied) = (BufferUsages::STORAGE, BufferUsages::COPY_SRC | BufferUsages::COPY_DST);
        let coordinates = Buffer::empty(gpu, stored | copied, grid.node_count() * D * 8);
        let rows = forces.groups.min(ROWS);
        let tries: Vec<Try> = STEPS
            .iter()
            .map(|&step| {
                let length = Buffer::filled(gpu, BufferUsages::UNIFORM, &[step as f32]);
                let results = Buffer::empty(gpu, stored | copied, rows * ROW * 4);
                let buffer = |number| match number {
                    binding::LEVEL => &level.functional,
                    binding::DIRECTION => &gradients.direction,
                    binding::COORDINATES => &coordinates,
                    binding::TRIAL => &length,
                    binding::ROWS => &forces.rows,
                    binding::RESULTS => &results,
                    _ => &level.nodes,
                };
                Try {
                    place: solver.place_nodes.bind(&gpu.device, |number| buffer(number)),
                    go: solver.move_nodes.bind(&gpu.device, |number| buffer(number)),
                    reduce: kernels.reduce.bind(&gpu.device, |number| buffer(number)),
                    results,
                    _length: length,
                }
            })
            .collect();
        let hierarchy = &gradients.hierarchy;
        let buffer = |number| match number {
            binding::LEVEL => &level.functional,
            binding::PLACE => &hierarchy.place,
            binding::NEAR => &hierarchy.near,
            binding::FAR => &hierarchy.far,
            binding::SCALARS => &hierarchy.scalars,
            binding::PAIRS => &pairs.pairs,
            binding::NODES => &level.nodes,
            binding::GRADIENT => &forces.gradient,
            _ => &gradients.partials,
        };
        let gather = |slab: &Slab| {
            let of_slab = |number| if number == binding::SLAB { &slab.place } else { buffer(number) };
            solver.gather_stencil.bind(&gpu.device, |number| of_slab(number))
        };
        let results: Vec<_> = tries.iter().map(|step| &step.results).collect();
        let staging_bytes = (STEPS.len() * rows * ROW + SCALARS) * 4;
        Some(Self {
            gather: pairs.slabs().map(gather).collect(),
            weigh: solver.weigh.bind(&gpu.device, |number| buffer(number)),
            stiffen: solver.stiffen.bind(&gpu.device, |number| buffer(number)),
            pins: Pins::new(gpu, solver, twin, &results, |number| buffer(number)),
            staging: Buffer::empty(gpu, BufferUsages::MAP_READ | BufferUsages::COPY_DST, staging_bytes),
            grid,
            pairs,
            gradients,
            coordinates,
            tries,
            is_reading: false,
            rows,
            is_there: false,
            chosen: None,
            shift: 0.0,
            linear_steps: LINEAR_STEPS,
        })
    }

    /// Takes a displacement over. None if a number is none, or too large.
    pub fn put(&mut self, gpu: &Gpu, displacement: &[f64]) -> Option<()> {
        let cells = self.grid.cells() as f64;
        let mut numbers = Vec::with_capacity(2 * displacement.len());
        for u in displacement {
            let moved = u * cells;
            if moved.is_nan() || moved.abs() >= LARGEST {
                return None;
            }
            let whole = moved.round();
            numbers.extend([(whole as i32).cast_unsigned(), ((moved - whole) as f32).to_bits()]);
        }
        gpu.queue.write_buffer(&self.coordinates, 0, cast_slice(&numbers));
        self.chosen = None;
        self.is_there = true;
        Some(())
    }

    /// The step that was tried as this number is gone before the next one is looked for.
    pub fn choose(&mut self, step: usize) {
        self.chosen = Some(step);
    }

    /// Derivatives at the displacement, as far as they are to be renewed, a direction, and the first steps along it.
    pub async fn search(
        &mut self,
        gpu: &Gpu,
        kernels: &Kernels,
        forces: &Forces,
        renewal: Renewal,
        shift: f32,
    ) -> Option<Told> {
        let solver = kernels.solver(gpu);
        let hierarchy = &self.gradients.hierarchy;
        if renewal == Renewal::Hessian {
            self.shift = 0.0;
        }
        if shift != self.shift {
            let more = [shift - self.shift];
            gpu.queue.write_buffer(&hierarchy.scalars, SHIFT as u64 * 4, cast_slice(&more));
        }
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        if renewal != Renewal::Shift {
            encoder.clear_buffer(&forces.gradient, 0, None);
        }
        if renewal == Renewal::Hessian {
            encoder.clear_buffer(&hierarchy.near, 0, None);
            encoder.clear_buffer(&hierarchy.far, 0, None);
        }
        let mut pass = encoder.begin_compute_pass(&Default::default());
        if let Some(step) = self.chosen.take() {
            solver.move_nodes.dispatch(gpu, &mut pass, &self.tries[step].go, self.grid.node_count() * D);
        }
        if renewal != Renewal::Shift {
            self.evaluate(gpu, kernels, forces, &mut pass, 0);
        }
        if renewal == Renewal::Hessian {
            self.assemble(gpu, kernels, solver, &mut pass);
        }
        if shift != self.shift {
            solver.stiffen.dispatch(gpu, &mut pass, &self.stiffen, self.grid.node_count());
        }
        if renewal == Renewal::Hessian || shift != self.shift {
            hierarchy.prepare(gpu, solver, &mut pass);
        }
        self.shift = shift;
        self.gradients.solve(gpu, solver, &mut pass, self.linear_steps);
        for number in 1..EAGER {
            self.evaluate(gpu, kernels, forces, &mut pass, number);
        }
        drop(pass);
        self.tell(gpu, encoder, 0..EAGER).await
    }

    /// The steps that are left to try.
    pub async fn search_on(&mut self, gpu: &Gpu, kernels: &Kernels, forces: &Forces) -> Option<Told> {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        for number in EAGER..STEPS.len() {
            self.evaluate(gpu, kernels, forces, &mut pass, number);
        }
        drop(pass);
        self.tell(gpu, encoder, EAGER..STEPS.len()).await
    }

    /// The energies of a step, and the gradient if it is none.
    fn evaluate(&self, gpu: &Gpu, kernels: &Kernels, forces: &Forces, pass: &mut ComputePass<'_>, number: usize) {
        let solver = kernels.solver(gpu);
        solver.place_nodes.dispatch(gpu, pass, &self.tries[number].place, self.grid.node_count());
        forces.encode(gpu, kernels, pass, number == 0);
        kernels.reduce.dispatch(gpu, pass, &self.tries[number].reduce, self.rows * GROUP);
        if let Some(pins) = &self.pins {
            pins.pull(gpu, solver, pass, number);
        }
    }

    fn assemble(&self, gpu: &Gpu, kernels: &Kernels, solver: &Solver, pass: &mut ComputePass<'_>) {
        for (number, gather) in self.gather.iter().enumerate() {
            let nodes = self.pairs.encode(gpu, kernels, pass, number);
            solver.gather_stencil.dispatch(gpu, pass, gather, nodes * StencilOperator::<D>::HALF);
        }
        if let Some(pins) = &self.pins {
            pins.stiffen(gpu, solver, pass);
        }
        solver.weigh.dispatch(gpu, pass, &self.weigh, self.grid.node_count());
        solver.weighed.dispatch(gpu, pass, &self.gradients.sum, GROUP);
    }

    /// Submits, and waits for the sums of these steps.
    async fn tell(&mut self, gpu: &Gpu, mut encoder: wgpu::CommandEncoder, numbers: Range<usize>) -> Option<Told> {
        if std::mem::replace(&mut self.is_reading, true) {
            self.staging.unmap();
        }
        let scalars = &self.gradients.hierarchy.scalars;
        encoder.copy_buffer_to_buffer(scalars, 0, &self.staging, 0, SCALARS as u64 * 4);
        let mut bytes = SCALARS as u64 * 4;
        for Try { results, .. } in &self.tries[numbers] {
            encoder.copy_buffer_to_buffer(results, 0, &self.staging, bytes, results.size());
            bytes += results.size();
        }
        gpu.queue.submit([encoder.finish()]);
        let row_numbers = self.rows * ROW;
        let take = |bytes: &[u8]| {
            let (scalars, rows) = cast_slice::<u8, f32>(bytes).split_at(SCALARS);
            let told = Told { sums: rows.chunks(row_numbers).map(sum_of_rows).collect(), slope: f64::from(scalars[7]) };
            (told, scalars[5].to_bits() as usize, scalars[6].to_bits() != 0)
        };
        let (told, steps, is_done) = gpu.read(&self.staging, bytes, take).await?;
        self.is_reading = false;
        let next = if is_done { (steps + SPARE).max(LINEAR_STEPS) } else { 2 * self.linear_steps };
        self.linear_steps = next.min(MOST_LINEAR_STEPS);
        Some(told)
    }

    /// The displacement, moved by the step that was tried as this number, or by the one that has been chosen.
    pub async fn fetch(&self, gpu: &Gpu, step: Option<usize>, displacement: &mut [f64]) -> Option<()> {
        let step = step.or(self.chosen).map_or(0.0, |number| STEPS[number]);
        let direction = &self.gradients.direction;
        let (own, all) = (self.coordinates.size(), self.coordinates.size() + direction.size());
        let staging = Buffer::empty(gpu, BufferUsages::MAP_READ | BufferUsages::COPY_DST, all as usize);
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(&self.coordinates, 0, &staging, 0, own);
        encoder.copy_buffer_to_buffer(direction, 0, &staging, own, direction.size());
        gpu.queue.submit([encoder.finish()]);
        let cells = self.grid.cells() as f64;
        let take = |bytes: &[u8]| {
            let (coordinates, direction) = bytes.split_at(own as usize);
            let (coordinates, direction) = (cast_slice::<u8, [u32; 2]>(coordinates), cast_slice::<u8, f32>(direction));
            for ((u, [whole, rest]), &d) in displacement.iter_mut().zip(coordinates).zip(direction) {
                *u = (f64::from(whole.cast_signed()) + f64::from(f32::from_bits(*rest))) / cells;
                // No step is none, whatever the direction is.
                if step > 0.0 {
                    *u -= step * f64::from(d);
                }
            }
        };
        gpu.read(&staging, all, take).await
    }
}
