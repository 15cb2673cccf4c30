//! Energies and gradient: from the displacement that is uploaded to the numbers that are read back.

use super::buffer::Buffer;
use super::device::Gpu;
use super::kernels::{GROUP, Kernels, binding};
use super::level::Level;
use super::slab::{BandRows, Slab};
use crate::assemble::CpuAssembler;
use bytemuck::cast_slice;
use wgpu::BufferUsages;

/// Numbers of a row of sums: four energies, two bounds, what pins cost, and what aligns it.
pub(super) const ROW: usize = 8;
/// Rows that are read back: 2 kB.
const MOST_RESULTS: usize = 64;

/// Sums over all cells.
pub(super) struct Sums {
    /// Membrane, bending, mismatch, volume.
    pub energies: [f64; 4],
    /// Of a displacement that stays on the card; else they are the twin's.
    pub pins: f64,
    /// The least determinant, and the least in units of what the edges of its cell could make.
    pub least: f64,
    pub ratio: f64,
}

pub(super) struct Forces {
    slabs: Vec<ForcesSlab>,
    pub gradient: Buffer,
    /// Sums over groups of cells.
    pub rows: Buffer,
    results: Buffer,
    staging: Buffer,
    reduce: wgpu::BindGroup,
    pub groups: usize,
    /// An answer was asked for and perhaps not waited for.
    is_reading: bool,
    // Bound, and kept for that.
    _forces: Buffer,
}

struct ForcesSlab {
    slab: Slab,
    /// For the value and for the gradient.
    volume: [wgpu::BindGroup; 2],
    shell: [wgpu::BindGroup; 2],
    gather: wgpu::BindGroup,
}

impl Forces {
    pub fn new<const D: usize>(
        gpu: &Gpu,
        kernels: &Kernels,
        level: &Level,
        twin: &CpuAssembler<D>,
        band: &BandRows,
    ) -> Self {
        let cell_bytes = (D << D) * 4;
        let slabs = band.slabs(gpu, twin, cell_bytes, GROUP);
        let row_count: usize = slabs.iter().map(|s| s.cells.len().div_ceil(GROUP) + s.band.div_ceil(GROUP)).sum();
        let groups = row_count.div_ceil(GROUP).min(MOST_RESULTS);
        let most_cells = slabs.iter().map(|slab| slab.cells.len()).max().unwrap_or(0);
        let (stored, copied) = (BufferUsages::STORAGE, BufferUsages::COPY_SRC | BufferUsages::COPY_DST);
        let gradient = Buffer::empty(gpu, stored | copied, twin.grid.node_count() * D * 4);
        let forces = Buffer::empty(gpu, stored, most_cells * cell_bytes);
        let rows = Buffer::empty(gpu, stored, row_count * ROW * 4);
        let results = Buffer::empty(gpu, stored | copied, groups * ROW * 4);
        let read_bytes = (results.size() + gradient.size()) as usize;
        let staging = Buffer::empty(gpu, BufferUsages::MAP_READ | BufferUsages::COPY_DST, read_bytes);
        let output = |number| match number {
            binding::FORCES => &forces,
            binding::GRADIENT => &gradient,
            binding::ROWS => &rows,
            _ => &results,
        };
        let slabs = slabs
            .into_iter()
            .map(|slab| {
                let buffer = |number| level.input(&slab, number).unwrap_or_else(|| output(number));
                ForcesSlab {
                    volume: kernels.volume.each_ref().map(|kernel| kernel.bind(&gpu.device, buffer)),
                    shell: kernels.shell.each_ref().map(|kernel| kernel.bind(&gpu.device, buffer)),
                    gather: kernels.gather_gradient.bind(&gpu.device, buffer),
                    slab,
                }
            })
            .collect();
        let reduce = kernels.reduce.bind(&gpu.device, |number| output(number));
        Self { slabs, reduce, gradient, rows, results, staging, groups, is_reading: false, _forces: forces }
    }

    /// At the displacement that was uploaded last; overwrites the gradient unless it is empty. None if the device fails.
    pub async fn evaluate(&mut self, gpu: &Gpu, kernels: &Kernels, gradient: &mut [f64]) -> Option<Sums> {
        if std::mem::replace(&mut self.is_reading, true) {
            self.staging.unmap();
        }
        let with_gradient = !gradient.is_empty();
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        if with_gradient {
            encoder.clear_buffer(&self.gradient, 0, None);
        }
        let mut pass = encoder.begin_compute_pass(&Default::default());
        self.encode(gpu, kernels, &mut pass, with_gradient);
        kernels.reduce.dispatch(gpu, &mut pass, &self.reduce, self.groups * GROUP);
        drop(pass);
        let result_bytes = self.results.size();
        let mut bytes = result_bytes;
        encoder.copy_buffer_to_buffer(&self.results, 0, &self.staging, 0, result_bytes);
        if with_gradient {
            encoder.copy_buffer_to_buffer(&self.gradient, 0, &self.staging, result_bytes, self.gradient.size());
            bytes += self.gradient.size();
        }
        gpu.queue.submit([encoder.finish()]);
        let take = |bytes: &[u8]| {
            let (rows, found) = cast_slice::<u8, f32>(bytes).split_at(result_bytes as usize / 4);
            for (entry, &number) in gradient.iter_mut().zip(found) {
                *entry = f64::from(number);
            }
            sum_of_rows(rows)
        };
        let sums = gpu.read(&self.staging, bytes, take).await?;
        self.is_reading = false;
        Some(sums)
    }

    /// The rows of sums, and the gradient into one that is zero.
    pub fn encode(&self, gpu: &Gpu, kernels: &Kernels, pass: &mut wgpu::ComputePass<'_>, with_gradient: bool) {
        let order = usize::from(with_gradient);
        for ForcesSlab { slab, volume, shell, gather } in &self.slabs {
            kernels.volume[order].dispatch(gpu, pass, &volume[order], slab.cells.len());
            kernels.shell[order].dispatch(gpu, pass, &shell[order], slab.band);
            if with_gradient {
                kernels.gather_gradient.dispatch(gpu, pass, gather, slab.nodes.len());
            }
        }
    }
}

/// The last stage, in f64.
pub(super) fn sum_of_rows(rows: &[f32]) -> Sums {
    let mut sums = Sums { energies: [0.0; 4], pins: 0.0, least: f64::INFINITY, ratio: f64::INFINITY };
    let mut is_broken = false;
    for row in rows.chunks_exact(ROW) {
        for (sum, &energy) in sums.energies.iter_mut().zip(row) {
            *sum += f64::from(energy);
        }
        sums.pins += f64::from(row[6]);
        is_broken |= row[4].is_nan() || row[5].is_nan();
        sums.least = sums.least.min(f64::from(row[4]));
        sums.ratio = sums.ratio.min(f64::from(row[5]));
    }
    if is_broken {
        sums.ratio = f64::NAN;
    }
    sums
}
