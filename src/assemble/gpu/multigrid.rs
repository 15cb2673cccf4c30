use super::buffer::Buffer;
use super::device::Gpu;
use super::gradients::Gradients;
use super::hierarchy::{Hierarchy, SCALARS};
use super::kernels::Kernels;
use crate::grid::Grid;
use crate::multigrid::Solve;
use crate::stencil::StencilOperator;
use bytemuck::cast_slice;
use std::rc::Rc;
use wgpu::BufferUsages;

/// The multigrid on a graphics card, usable by itself: [`Multigrid`](crate::multigrid::Multigrid) with the sweeps' nodes in
/// the order of 2^D colours.
pub struct GpuMultigrid<const D: usize> {
    gpu: Rc<Gpu>,
    kernels: Rc<Kernels>,
    grid: Grid<D>,
    gradient: Buffer,
    gradients: Gradients<D>,
}

impl<const D: usize> GpuMultigrid<D> {
    /// With the derived operators of an operator. Conjugate gradients end at this relative residual. None if the operators
    /// are larger than what the device lets a shader see.
    pub fn new(gpu: Rc<Gpu>, operator: &StencilOperator<D>, tolerance: f32) -> Option<Self> {
        let (kernels, grid) = (gpu.kernels::<D>(), operator.grid());
        let gradient = Buffer::empty(&gpu, BufferUsages::STORAGE | BufferUsages::COPY_DST, grid.node_count() * D * 4);
        let hierarchy = Hierarchy::new(&gpu, kernels.solver(&gpu), grid, tolerance)?;
        let gradients = Gradients::new(&gpu, kernels.solver(&gpu), grid, hierarchy, &gradient);
        let this = Self { gpu, kernels, grid, gradient, gradients };
        this.load(operator);
        Some(this)
    }

    fn load(&self, operator: &StencilOperator<D>) {
        let (nodes, size) = (self.grid.node_count(), StencilOperator::<D>::BLOCK);
        let mut numbers = vec![0.0_f32; nodes * StencilOperator::<D>::ROW];
        operator.for_each_block(|node, other, block| {
            if node <= other {
                let (from, to) = (self.grid.node_index(node), self.grid.node_index(other));
                let offset = std::array::from_fn(|k| to[k] as isize - from[k] as isize);
                let slot = StencilOperator::<D>::neighbour(offset) - StencilOperator::<D>::CENTRE;
                for (k, entry) in block.as_flattened().iter().enumerate() {
                    numbers[(slot * size + k) * nodes + node] = *entry;
                }
            }
        });
        let (near, far) = numbers.split_at(nodes * Hierarchy::<D>::NEAR * size);
        let hierarchy = &self.gradients.hierarchy;
        self.gpu.queue.write_buffer(&hierarchy.near, 0, cast_slice(near));
        self.gpu.queue.write_buffer(&hierarchy.far, 0, cast_slice(far));
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        hierarchy.prepare(&self.gpu, self.kernels.solver(&self.gpu), &mut pass);
        drop(pass);
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// Solves A x = b in at most so many steps from x = 0. None if the device fails.
    pub async fn solve(&self, b: &[f64], steps: usize, x: &mut [f64]) -> Option<Solve> {
        self.gpu.queue.write_buffer(&self.gradient, 0, cast_slice(&rounded(b)));
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        self.gradients.solve(&self.gpu, self.kernels.solver(&self.gpu), &mut pass, steps);
        drop(pass);
        let scalars = self.read(encoder, &self.gradients.direction, x).await?;
        let relative_residual = f64::from((scalars[4] / scalars[3]).sqrt());
        let product = b.iter().zip(x.iter()).map(|(b, x)| b * x).sum();
        Some(Solve { iterations: scalars[5].to_bits() as usize, relative_residual, product })
    }

    /// One V-cycle for A x = b from x = 0. None if the device fails.
    pub async fn v_cycle(&self, b: &[f64], x: &mut [f64]) -> Option<()> {
        let hierarchy = &self.gradients.hierarchy;
        self.gpu.queue.write_buffer(&hierarchy.right, 0, cast_slice(&rounded(b)));
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        encoder.clear_buffer(&hierarchy.solution, 0, None);
        encoder.clear_buffer(&hierarchy.scalars, 0, None);
        let mut pass = encoder.begin_compute_pass(&Default::default());
        hierarchy.cycle(&self.gpu, self.kernels.solver(&self.gpu), &mut pass);
        drop(pass);
        self.read(encoder, &hierarchy.solution, x).await.map(|_| ())
    }

    /// Submits, and reads the scalars and the beginning of a vector.
    async fn read(&self, mut encoder: wgpu::CommandEncoder, vector: &Buffer, x: &mut [f64]) -> Option<[f32; SCALARS]> {
        let (head, bytes) = (SCALARS * 4, (SCALARS + x.len()) * 4);
        let staging = Buffer::empty(&self.gpu, BufferUsages::MAP_READ | BufferUsages::COPY_DST, bytes);
        encoder.copy_buffer_to_buffer(&self.gradients.hierarchy.scalars, 0, &staging, 0, head as u64);
        encoder.copy_buffer_to_buffer(vector, 0, &staging, head as u64, x.len() as u64 * 4);
        self.gpu.queue.submit([encoder.finish()]);
        let take = |bytes: &[u8]| {
            let (scalars, found) = cast_slice::<u8, f32>(bytes).split_at(SCALARS);
            for (x, &number) in x.iter_mut().zip(found) {
                *x = f64::from(number);
            }
            std::array::from_fn(|k| scalars[k])
        };
        self.gpu.read(&staging, bytes as u64, take).await
    }
}

fn rounded(numbers: &[f64]) -> Vec<f32> {
    numbers.iter().map(|&number| number as f32).collect()
}
