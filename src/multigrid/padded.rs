//! Nodal f32 vectors with a ring of zeros around the grid, so that a stencil needs no case for the boundary.

use super::add_scaled;
use crate::grid::Grid;
use crate::stencil::{LANES, MAX_NEIGHBOURS, StencilOperator};

/// A padded vector. A row of nodes, one with zeros before the first and after the last in each direction, is D lines of
/// equal length, one a component.
pub(super) type Nodes = [f32];

/// Zeros before the first number of a line; those before the next line come after the last.
const BEFORE: usize = LANES;

/// Where a grid's nodes sit in a padded vector.
#[derive(Clone, Copy)]
pub(super) struct Layout<const D: usize> {
    grid: Grid<D>,
    /// Numbers a line.
    pub line: usize,
    /// Rows of zeros before an operator's first, and groups of nodes a row.
    pub margin: usize,
    pub groups: usize,
    /// How much further than a node's numbers those of its neighbour in a slot of the stored half sit.
    pub shifts: [usize; MAX_NEIGHBOURS],
    /// How many rows of the grid later that neighbour's row comes.
    pub strides: [usize; MAX_NEIGHBOURS],
}

impl<const D: usize> Layout<D> {
    pub fn new(grid: Grid<D>) -> Self {
        let groups = grid.side() / LANES + 1;
        let line = BEFORE + groups * LANES;
        let margin = (0..D - 1).map(|axis| grid.stride(axis)).sum();
        // Rows between a node's and its neighbour's if there are `side` of them along an axis.
        let rows = |offset: &[isize; D], side: usize| {
            offset[1..].iter().rev().fold(0, |sum, &o| sum * side as isize + o) as usize
        };
        let (mut shifts, mut strides) = ([0; MAX_NEIGHBOURS], [0; MAX_NEIGHBOURS]);
        for slot in 0..StencilOperator::<D>::HALF {
            let offset = StencilOperator::<D>::offset(StencilOperator::<D>::CENTRE + slot);
            shifts[slot] = (rows(&offset, grid.side() + 2) * D * line).wrapping_add_signed(offset[0]);
            strides[slot] = rows(&offset, grid.side());
        }
        Self { grid, line, margin, groups, shifts, strides }
    }

    /// Numbers of a vector.
    pub fn len(&self) -> usize {
        // A last line may be read to beyond its end.
        (self.grid.side() + 2).pow(D as u32 - 1) * D * self.line + BEFORE
    }

    /// Nodes a row.
    pub fn side(&self) -> usize {
        self.grid.side()
    }

    /// Lines of nodes along x.
    pub fn rows(&self) -> usize {
        self.grid.node_count() / self.grid.side()
    }

    /// The position of the first component of the first node of a row.
    pub fn row_start(&self, row: usize) -> usize {
        self.start_of(&row_index(row, self.side()))
    }

    /// The same for the row with an index, of which the first does not count.
    fn start_of(&self, index: &[usize; D]) -> usize {
        let row = index[1..].iter().rev().fold(0, |sum, &i| sum * (self.side() + 2) + i + 1);
        row * D * self.line + BEFORE
    }

    pub fn store(&self, values: &[f64], scale: f64, padded: &mut Nodes) {
        for (row, values) in values.chunks_exact(self.side() * D).enumerate() {
            let start = self.row_start(row);
            for k in 0..D {
                for (p, v) in padded[start + k * self.line..].iter_mut().zip(values[k..].iter().step_by(D)) {
                    *p = (v * scale) as f32;
                }
            }
        }
    }

    pub fn load(&self, padded: &Nodes, scale: f64, values: &mut [f64]) {
        self.replace(padded, scale, values);
    }

    /// As `load`; returns the inner product of the values before and after.
    pub fn replace(&self, padded: &Nodes, scale: f64, values: &mut [f64]) -> f64 {
        let mut sums = [0.0; D];
        for (row, values) in values.chunks_exact_mut(self.side() * D).enumerate() {
            let start = self.row_start(row);
            for (k, sum) in sums.iter_mut().enumerate() {
                for (v, p) in values[k..].iter_mut().step_by(D).zip(&padded[start + k * self.line..]) {
                    let value = f64::from(*p) * scale;
                    *sum += *v * value;
                    *v = value;
                }
            }
        }
        sums.iter().sum()
    }

    /// coarse = Pᵀ fine. `line` is memory for one, zeros about it included.
    pub fn restrict(&self, fine: &Nodes, coarse_layout: &Layout<D>, coarse: &mut Nodes, line: &mut [f32]) {
        let side = coarse_layout.side();
        let sums = &mut line[..2 * side + 1];
        for number in 0..coarse_layout.rows() * D {
            let (row, k) = (number / D, number % D);
            // From the ring's node before the row to the one after it.
            sums.fill(0.0);
            for (share, start) in self.fine_rows(&row_index(row, side)) {
                add_scaled(sums, share, &fine[start + k * self.line - 1..][..2 * side + 1]);
            }
            let coarse = &mut coarse[coarse_layout.row_start(row) + k * coarse_layout.line..][..side];
            for (coarse, around) in coarse.iter_mut().zip(sums.windows(3).step_by(2)) {
                *coarse = around[1] + 0.5 * (around[0] + around[2]);
            }
        }
    }

    /// fine += P coarse. What would fall beyond the grid is left out. `line` is memory for one.
    pub fn prolongate_add(&self, coarse: &Nodes, coarse_layout: &Layout<D>, fine: &mut Nodes, line: &mut [f32]) {
        let side = coarse_layout.side();
        let line = &mut line[..self.side()];
        for number in 0..coarse_layout.rows() * D {
            let (row, k) = (number / D, number % D);
            let coarse = &coarse[coarse_layout.row_start(row) + k * coarse_layout.line..][..side];
            for (pair, values) in line.chunks_exact_mut(2).zip(coarse.windows(2)) {
                pair[0] = values[0];
                pair[1] = 0.5 * (values[0] + values[1]);
            }
            line[2 * side - 2] = coarse[side - 1];
            for (share, start) in self.fine_rows(&row_index(row, side)) {
                add_scaled(&mut fine[start + k * self.line..][..line.len()], share, line);
            }
        }
    }

    /// The fine rows around a coarse one that are on the grid: the value there of the coarse row's hat function, and the
    /// position of the first node.
    fn fine_rows(&self, coarse: &[usize; D]) -> impl Iterator<Item = (f32, usize)> {
        let around = 3_usize.pow(D as u32 - 1);
        let (layout, coarse) = (*self, *coarse);
        (0..around).filter_map(move |number| {
            // Of neighbours that differ from the coarse row's own first node in rows only.
            let offset = StencilOperator::<D>::offset(3 * number + 1);
            let mut index = [0; D];
            let mut share = 1.0;
            for axis in 1..D {
                index[axis] = (2 * coarse[axis]).checked_add_signed(offset[axis])?;
                share *= if offset[axis] == 0 { 1.0 } else { 0.5 };
            }
            index.iter().all(|&i| i < layout.side()).then(|| (share, layout.start_of(&index)))
        })
    }
}

/// The index of a row's first node.
fn row_index<const D: usize>(row: usize, side: usize) -> [usize; D] {
    let mut rest = row;
    std::array::from_fn(|axis| {
        if axis == 0 {
            return 0;
        }
        let i = rest % side;
        rest /= side;
        i
    })
}
