use super::buffer::Buffer;
use super::device::Gpu;
use crate::assemble::CpuAssembler;
use crate::small::Scalar;
use std::ops::Range;
use wgpu::BufferUsages;

/// Bytes of what a slab's cells write: half of what every device lets a shader see of one buffer.
const MOST_BYTES: usize = 1 << 26;

/// Whole layers of cells across the last axis: so many that what is written for each cell fits a buffer.
pub(super) struct Slab {
    /// The nodes of its cells.
    pub nodes: Range<usize>,
    pub cells: Range<usize>,
    /// How many of its cells are in the band.
    pub band: usize,
    /// For the shaders: where it is, its band, and the reference at the band's points.
    pub place: Buffer,
    pub band_cells: Buffer,
    pub samples: Buffer,
}

/// The band as the shaders take it: cells in ascending order, and the reference's rows at their quadrature points.
pub(super) struct BandRows {
    cells: Vec<u32>,
    samples: Vec<f32>,
    /// Numbers of a cell.
    stride: usize,
}

impl BandRows {
    pub fn of<const D: usize>(twin: &CpuAssembler<D>) -> Self {
        let (packs, samples) = (&twin.band.packs, &twin.band.samples);
        let stride = if packs.is_empty() { 1 } else { samples.len() / packs.len() };
        let mut rows = Self { cells: Vec::new(), samples: Vec::new(), stride };
        for (nodes, samples) in packs.iter().zip(samples.chunks_exact(stride)) {
            // A last pack that is not full repeats its last cell.
            let lanes = if nodes[0] == nodes[1] { 1 } else { 2 };
            for lane in 0..lanes {
                rows.cells.push(twin.grid.cell(twin.grid.node_index(nodes[lane])) as u32);
                rows.samples.extend(samples.iter().map(|sample| sample.lane(lane) as f32));
            }
        }
        rows
    }

    /// All cells in slabs, if each cell writes so many bytes. Each `group` of cells sums up to a row, the volume's of a slab
    /// before its shell's.
    pub fn slabs<const D: usize>(&self, gpu: &Gpu, twin: &CpuAssembler<D>, bytes: usize, group: usize) -> Vec<Slab> {
        let grid = twin.grid;
        let (layer, layer_nodes) = (grid.cell_count() / grid.cells(), grid.stride(D - 1));
        let most = (MOST_BYTES / (layer * bytes)).max(1);
        let mut row = 0;
        (0..grid.cells())
            .step_by(most)
            .map(|first| {
                let last = (first + most).min(grid.cells());
                let cells = first * layer..last * layer;
                let place = |cell: usize| self.cells.partition_point(|&other| (other as usize) < cell);
                let band = place(cells.start)..place(cells.end);
                let shell_row = row + cells.len().div_ceil(group);
                let numbers =
                    [cells.start, cells.len(), first, last - first, band.len(), row, shell_row].map(|x| x as u32);
                row = shell_row + band.len().div_ceil(group);
                let rows = band.start * self.stride..band.end * self.stride;
                Slab {
                    nodes: first * layer_nodes..(last + 1) * layer_nodes,
                    cells,
                    band: band.len(),
                    place: Buffer::filled(gpu, BufferUsages::UNIFORM, &numbers),
                    band_cells: Buffer::filled(gpu, BufferUsages::STORAGE, &self.cells[band]),
                    samples: Buffer::filled(gpu, BufferUsages::STORAGE, &self.samples[rows]),
                }
            })
            .collect()
    }
}
