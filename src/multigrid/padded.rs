//! Nodal f32 vectors with a ring of zeros around the grid, so that a stencil needs no case for the boundary.

use crate::grid::Grid;
use crate::stencil::{MAX_NEIGHBOURS, StencilOperator};

/// A padded vector: D components a node; the node with index i sits at index i + 1.
pub(super) type Nodes<const D: usize> = [[f32; D]];

/// Where a grid's nodes sit in a padded vector.
#[derive(Clone, Copy)]
pub(super) struct Layout<const D: usize> {
    grid: Grid<D>,
    /// How much further than a node its neighbour in a slot of the stored half sits.
    pub shifts: [usize; MAX_NEIGHBOURS],
    /// How much larger its number is.
    pub strides: [usize; MAX_NEIGHBOURS],
}

impl<const D: usize> Layout<D> {
    pub fn new(grid: Grid<D>) -> Self {
        let further = |slot: usize, side: usize| {
            let offset = StencilOperator::<D>::offset(StencilOperator::<D>::CENTRE + slot);
            offset.iter().rev().fold(0, |sum, &o| sum * side as isize + o) as usize
        };
        let (mut shifts, mut strides) = ([0; MAX_NEIGHBOURS], [0; MAX_NEIGHBOURS]);
        for slot in 0..StencilOperator::<D>::HALF {
            shifts[slot] = further(slot, grid.side() + 2);
            strides[slot] = further(slot, grid.side());
        }
        Self { grid, shifts, strides }
    }

    /// Nodes of the grid and its ring.
    pub fn len(&self) -> usize {
        (self.grid.side() + 2).pow(D as u32)
    }

    /// Nodes a row.
    pub fn side(&self) -> usize {
        self.grid.side()
    }

    /// Lines of nodes along x.
    pub fn rows(&self) -> usize {
        self.grid.node_count() / self.grid.side()
    }

    /// The position of the first node of a row.
    pub fn row_start(&self, row: usize) -> usize {
        self.start_of(&row_index(row, self.side()))
    }

    /// The position of the node with an index.
    fn start_of(&self, index: &[usize; D]) -> usize {
        index.iter().rev().fold(0, |sum, &i| sum * (self.side() + 2) + i + 1)
    }

    pub fn store(&self, values: &[f64], scale: f64, padded: &mut Nodes<D>) {
        for (row, values) in values.chunks_exact(self.side() * D).enumerate() {
            let padded = padded[self.row_start(row)..][..self.side()].as_flattened_mut();
            for (p, v) in padded.iter_mut().zip(values) {
                *p = (v * scale) as f32;
            }
        }
    }

    pub fn load(&self, padded: &Nodes<D>, scale: f64, values: &mut [f64]) {
        for (row, values) in values.chunks_exact_mut(self.side() * D).enumerate() {
            let padded = padded[self.row_start(row)..][..self.side()].as_flattened();
            for (v, p) in values.iter_mut().zip(padded) {
                *v = f64::from(*p) * scale;
            }
        }
    }

    /// coarse = Pᵀ fine.
    pub fn restrict(&self, fine: &Nodes<D>, coarse_layout: &Layout<D>, coarse: &mut Nodes<D>) {
        let side = coarse_layout.side();
        for row in 0..coarse_layout.rows() {
            let coarse = &mut coarse[coarse_layout.row_start(row)..][..side];
            coarse.fill([0.0; D]);
            for (share, start) in self.fine_rows(&row_index(row, side)) {
                // From the ring's node before the row to the one after it.
                let (pairs, _) = fine[start - 1..][..2 * side + 1].as_chunks::<2>();
                let rights = fine[start + 1..].iter().step_by(2);
                for ((coarse, [left, under]), right) in coarse.iter_mut().zip(pairs).zip(rights) {
                    for k in 0..D {
                        coarse[k] += share * (under[k] + 0.5 * (left[k] + right[k]));
                    }
                }
            }
        }
    }

    /// fine += P coarse. What would fall beyond the grid is left out.
    pub fn prolongate_add(&self, coarse: &Nodes<D>, coarse_layout: &Layout<D>, fine: &mut Nodes<D>) {
        let side = coarse_layout.side();
        for row in 0..coarse_layout.rows() {
            let coarse = &coarse[coarse_layout.row_start(row)..][..side];
            for (share, start) in self.fine_rows(&row_index(row, side)) {
                let fine = &mut fine[start..][..self.side()];
                let (pairs, last) = fine.as_chunks_mut::<2>();
                for ([under, right], values) in pairs.iter_mut().zip(coarse.windows(2)) {
                    for k in 0..D {
                        under[k] += share * values[0][k];
                        right[k] += share * 0.5 * (values[0][k] + values[1][k]);
                    }
                }
                for k in 0..D {
                    last[0][k] += share * coarse[side - 1][k];
                }
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
