//! Between nodal arrays and the lanes of a pack of cells.

use super::CpuAssembler;
use super::element::{Corners, Pairs};
use crate::grid::{Grid, MAX_CORNERS};
use crate::small::Scalar;
use crate::stencil::StencilOperator;

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    #[inline(always)]
    pub(super) fn gather(&self, displacement: &[f64], nodes: [usize; 2]) -> Corners<S, D> {
        let offsets = self.grid.corner_offsets();
        let mut corners = [[S::zero(); D]; MAX_CORNERS];
        for corner in 0..Grid::<D>::CORNERS {
            let rows: [&[f64]; 2] = nodes.map(|node| &displacement[(node + offsets[corner]) * D..][..D]);
            for k in 0..D {
                corners[corner][k] = S::gather(|lane| rows[lane][k]);
            }
        }
        corners
    }

    #[inline(always)]
    pub(super) fn scatter(&self, forces: &Corners<S, D>, nodes: [usize; 2], gradient: &mut [f64]) {
        let offsets = self.grid.corner_offsets();
        for corner in 0..Grid::<D>::CORNERS {
            for lane in 0..S::LANES {
                let row = &mut gradient[(nodes[lane] + offsets[corner]) * D..][..D];
                for k in 0..D {
                    row[k] += forces[corner][k].lane(lane);
                }
            }
        }
    }

    #[inline(always)]
    pub(super) fn scatter_pairs<T: Scalar, const C: usize>(
        &self,
        pairs: &Pairs<T, D, C>,
        node: impl Fn(usize) -> usize,
        operator: &mut StencilOperator<D>,
    ) {
        for lane in 0..T::LANES {
            let places = self.corner_places::<C>(node(lane));
            for a in 0..C {
                for b in a..C {
                    let block = pairs[a][b].map(|row| row.map(|entry| entry.lane(lane) as f32));
                    operator.add(places[a], self.corner_neighbours[a][b], &block);
                }
            }
        }
    }

    /// Rows and columns of the corners of the cell with this lowest node.
    #[inline(always)]
    pub(super) fn corner_places<const C: usize>(&self, node: usize) -> [[usize; 2]; C] {
        let side = self.grid.side();
        let (row, column) = (node / side, node % side);
        std::array::from_fn(|corner| {
            let rows: usize = (1..D).map(|axis| (corner >> axis & 1) * self.grid.stride(axis - 1)).sum();
            [row + rows, column + (corner & 1)]
        })
    }
}
