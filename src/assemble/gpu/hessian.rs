//! The hessian, slab by slab: a grid of 65³ nodes has more of it than a shader may see at once.

use super::buffer::Buffer;
use super::device::Gpu;
use super::kernels::{GROUP, Kernels, binding};
use super::level::Level;
use super::slab::{BandRows, Slab};
use crate::assemble::CpuAssembler;
use crate::stencil::StencilOperator;
use bytemuck::cast_slice;
use wgpu::{BindGroup, BufferUsages, ComputePass};

/// What the corners of each cell have with each other, of which the hessian is gathered.
pub(super) struct Pairs {
    slabs: Vec<PairsSlab>,
    pub pairs: Buffer,
}

struct PairsSlab {
    slab: Slab,
    volume: BindGroup,
    shell: BindGroup,
}

impl Pairs {
    pub fn new<const D: usize>(
        gpu: &Gpu,
        kernels: &Kernels,
        level: &Level,
        twin: &CpuAssembler<D>,
        band: &BandRows,
    ) -> Self {
        let corners = 1 << D;
        let cell_bytes = corners * (corners + 1) / 2 * D * D * 4;
        let slabs = band.slabs(gpu, twin, cell_bytes, GROUP);
        let most_cells = slabs.iter().map(|slab| slab.cells.len()).max().unwrap_or(0);
        let pairs = Buffer::empty(gpu, BufferUsages::STORAGE, most_cells * cell_bytes);
        let slabs = slabs
            .into_iter()
            .map(|slab| {
                let buffer = |number| level.input(&slab, number).unwrap_or(&pairs);
                PairsSlab {
                    volume: kernels.volume_pairs.bind(&gpu.device, buffer),
                    shell: kernels.shell_pairs.bind(&gpu.device, buffer),
                    slab,
                }
            })
            .collect();
        Self { slabs, pairs }
    }

    pub fn slabs(&self) -> impl Iterator<Item = &Slab> {
        self.slabs.iter().map(|PairsSlab { slab, .. }| slab)
    }

    /// Those of the cells of a slab, at the displacement that is uploaded. Returns how many nodes they have.
    pub fn encode(&self, gpu: &Gpu, kernels: &Kernels, pass: &mut ComputePass<'_>, number: usize) -> usize {
        let PairsSlab { slab, volume, shell } = &self.slabs[number];
        kernels.volume_pairs.dispatch(gpu, pass, volume, slab.cells.len());
        kernels.shell_pairs.dispatch(gpu, pass, shell, slab.band);
        slab.nodes.len()
    }
}

pub(super) struct Hessian {
    pairs: Pairs,
    /// By slab.
    gather: Vec<BindGroup>,
    blocks: Buffer,
    staging: Buffer,
    is_reading: bool,
}

impl Hessian {
    pub fn new<const D: usize>(gpu: &Gpu, kernels: &Kernels, level: &Level, pairs: Pairs) -> Self {
        let most_nodes = pairs.slabs().map(|slab| slab.nodes.len()).max().unwrap_or(0);
        let block_bytes = most_nodes * StencilOperator::<D>::ROW * 4;
        let blocks = Buffer::empty(gpu, BufferUsages::STORAGE | BufferUsages::COPY_SRC, block_bytes);
        let staging = Buffer::empty(gpu, BufferUsages::MAP_READ | BufferUsages::COPY_DST, block_bytes);
        let gather = |slab: &Slab| {
            let output = |number| if number == binding::PAIRS { &*pairs.pairs } else { &*blocks };
            let buffer = |number| level.input(slab, number).unwrap_or_else(|| output(number));
            kernels.gather_blocks.bind(&gpu.device, buffer)
        };
        Self { gather: pairs.slabs().map(gather).collect(), pairs, blocks, staging, is_reading: false }
    }

    /// Overwrites the operator with the hessian at the displacement that was uploaded last. None if the device fails.
    pub async fn evaluate<const D: usize>(
        &mut self,
        gpu: &Gpu,
        kernels: &Kernels,
        operator: &mut StencilOperator<D>,
    ) -> Option<()> {
        operator.clear();
        for (number, (slab, gather)) in self.pairs.slabs().zip(&self.gather).enumerate() {
            if std::mem::replace(&mut self.is_reading, true) {
                self.staging.unmap();
            }
            let bytes = (slab.nodes.len() * StencilOperator::<D>::ROW * 4) as u64;
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            let mut pass = encoder.begin_compute_pass(&Default::default());
            let nodes = self.pairs.encode(gpu, kernels, &mut pass, number);
            kernels.gather_blocks.dispatch(gpu, &mut pass, gather, nodes * StencilOperator::<D>::HALF);
            drop(pass);
            encoder.copy_buffer_to_buffer(&self.blocks, 0, &self.staging, 0, bytes);
            gpu.queue.submit([encoder.finish()]);
            let take = |bytes: &[u8]| add_blocks(slab.nodes.start, cast_slice(bytes), operator);
            gpu.read(&self.staging, bytes, take).await?;
            self.is_reading = false;
        }
        Some(())
    }
}

/// Adds the blocks of nodes from `first` on. Nodes between two slabs have some of theirs in each.
fn add_blocks<const D: usize>(first: usize, numbers: &[f32], operator: &mut StencilOperator<D>) {
    let side = operator.grid().side();
    let size = StencilOperator::<D>::BLOCK;
    for (number, row) in numbers.chunks_exact(StencilOperator::<D>::ROW).enumerate() {
        let node = first + number;
        for (half, block) in row.chunks_exact(size).enumerate() {
            if block.iter().all(|&entry| entry == 0.0) {
                continue;
            }
            let block = std::array::from_fn(|i| std::array::from_fn(|j| block[i * D + j]));
            operator.add([node / side, node % side], StencilOperator::<D>::CENTRE + half, &block);
        }
    }
}
