//! What of a level lies on the card.

use super::buffer::Buffer;
use super::device::Gpu;
use super::kernels::binding;
use super::slab::Slab;
use super::upload::Upload;
use crate::assemble::CpuAssembler;
use crate::energy::{BendingModel, MembraneModel};
use wgpu::BufferUsages;

/// What all kernels read.
pub(super) struct Level {
    pub functional: Buffer,
    pub nodes: Buffer,
    volume_weights: Buffer,
    template: Buffer,
}

impl Level {
    pub fn new<const D: usize>(gpu: &Gpu, twin: &CpuAssembler<D>) -> Self {
        let node_bytes = twin.grid.node_count() * Upload::<D>::STRIDE * 4;
        let template: Vec<f32> = twin.template.jets.all().map(|value| value as f32).collect();
        let weights: Vec<f32> = twin.volume_weight.iter().map(|&weight| weight as f32).collect();
        Self {
            functional: Buffer::filled(gpu, BufferUsages::UNIFORM, &functional_of(twin)),
            nodes: Buffer::empty(gpu, BufferUsages::STORAGE | BufferUsages::COPY_DST, node_bytes),
            volume_weights: Buffer::filled(gpu, BufferUsages::STORAGE, &weights),
            template: Buffer::filled(gpu, BufferUsages::STORAGE, &template),
        }
    }

    /// The buffer of a binding that is read, for a slab.
    pub fn input<'a>(&'a self, slab: &'a Slab, number: u32) -> Option<&'a wgpu::Buffer> {
        Some(match number {
            binding::LEVEL => &self.functional,
            binding::SLAB => &slab.place,
            binding::NODES => &self.nodes,
            binding::VOLUME_WEIGHTS => &self.volume_weights,
            binding::TEMPLATE => &self.template,
            binding::BAND => &slab.band_cells,
            binding::SAMPLES => &slab.samples,
            _ => return None,
        })
    }
}

/// The structure `Level` of `shaders/level.wgsl`.
fn functional_of<const D: usize>(twin: &CpuAssembler<D>) -> [u32; 12] {
    let functional = &twin.functional;
    let bending = match functional.bending_model {
        BendingModel::ShapeOperator => functional.bending * functional.thickness.powi(3),
        BendingModel::MeanCurvature => functional.bending,
    };
    let real = |value: f64| (value as f32).to_bits();
    [
        twin.grid.cells() as u32,
        twin.grid.side() as u32,
        real(functional.membrane * functional.thickness),
        real(bending),
        real(functional.penalty),
        real(functional.tangency * functional.tangency),
        u32::from(functional.membrane_model == MembraneModel::Projected),
        u32::from(functional.bending_model == BendingModel::MeanCurvature),
        real(functional.material.lambda),
        real(functional.material.mu),
        real(functional.vertex_share),
        functional.gauss_points as u32,
    ]
}
