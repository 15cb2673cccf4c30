//! The part of the volume's hessian that keeps corners from folding.

use super::CpuAssembler;
use crate::grid::{Grid, MAX_CORNERS};
use crate::small::{Scalar, cofactor, dot};
use crate::stencil::StencilOperator;

/// Determinants below this are taken as this: k″ must stay within f32.
const LEAST: f64 = 1e-4;

/// Corners with a lesser determinant are stiffened: above it the cell's hessian is near enough.
const STIFFENED: f64 = 0.7;

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    /// Adds, for each corner with J = det Dφ below [`STIFFENED`], w k″(J) ∇J ⊗ ∇J, where w is the corner's weight in the
    /// energy and k(J) = g(J²), k″ = (λ−2μ)/4 + 3 (λ+2μ)/4 · J⁻⁴.
    ///
    /// The energy integrates the share θ of the volume term at the corners, its hessian sees Gauss points or the middle of a
    /// cell. A corner about to fold is stiffer by orders of magnitude than they, and one such corner would hold up the whole
    /// plane: every step would fold it and be halved again and again.
    ///
    /// `least` are the least determinants of the `T::LANES` cells from the node `base` on, `weights` theirs.
    #[inline(always)]
    pub(super) fn stiffen_corners<T: Scalar, const C: usize>(
        &self,
        least: T,
        base: usize,
        weights: &[f64],
        displacement: &[f64],
        operator: &mut StencilOperator<D>,
    ) {
        for (lane, weight) in weights.iter().enumerate() {
            if least.lane(lane) < STIFFENED {
                self.stiffen_cell::<C>(base + lane, *weight, displacement, operator);
            }
        }
    }

    fn stiffen_cell<const C: usize>(
        &self,
        base: usize,
        weight: f64,
        displacement: &[f64],
        operator: &mut StencilOperator<D>,
    ) {
        let material = self.functional.material;
        let offsets: [usize; MAX_CORNERS] = self.grid.corner_offsets();
        let cells = self.grid.cells() as f64;
        let share = weight * self.functional.vertex_share / Grid::<D>::CORNERS as f64;
        let places = self.corner_places::<C>(base);
        let value = |corner: usize, k: usize| displacement[(base + offsets[corner]) * D + k];
        for corner in 0..C {
            // Columns ∂φ/∂x_k by the edges that meet in this corner.
            let ends = |axis: usize| (corner & !(1 << axis), corner | 1 << axis);
            let columns: [[f64; D]; D] = std::array::from_fn(|axis| {
                let (low, high) = ends(axis);
                std::array::from_fn(|k| (value(high, k) - value(low, k)) * cells + if k == axis { 1.0 } else { 0.0 })
            });
            let cofactors = cofactor(&columns);
            let det = dot(&columns[0], &cofactors[0]);
            if det >= STIFFENED {
                continue;
            }
            let second = (material.lambda - 2.0 * material.mu) / 4.0
                + 0.75 * (material.lambda + 2.0 * material.mu) / det.max(LEAST).powi(4);
            let mut slopes = [[0.0; D]; C];
            for (axis, cofactors) in cofactors.iter().enumerate() {
                let (low, high) = ends(axis);
                for k in 0..D {
                    slopes[high][k] += cofactors[k] * cells;
                    slopes[low][k] -= cofactors[k] * cells;
                }
            }
            for a in 0..C {
                for b in a..C {
                    let entry = |i: usize, j: usize| (share * second * slopes[a][i] * slopes[b][j]) as f32;
                    let block = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
                    operator.add(places[a], self.corner_neighbours[a][b], &block);
                }
            }
        }
    }
}
