//! The volume's hessian in space, four cells at a time.
//!
//! μ 1 + t k′ ∂²J + k″ ∂J ⊗ ∂J (see [`Volume`](crate::energy::Volume)) is taken at the middle of the cell and integrated
//! exactly with it. With G_pq = ∫ ∂_pN_A ∂_qN_B, the same for all cells, and the columns f_k of F and c_k of its cofactors,
//! the block of corners A and B is
//!
//! Σ_k G_kk (μ 1 + k″ c_k ⊗ c_k) + G_pq k″ c_p ⊗ c_q + G_qp k″ c_q ⊗ c_p + (G_pq − G_qp) t k′ [f_k]×,
//!
//! p = k + 1 and q = k + 2, where [v]× takes d and e to v·(d × e). G_qp is G_pq or −G_pq, and
//! c_p ⊗ c_q − c_q ⊗ c_p = [c_p × c_q]× = J [f_k]×.
//!
//! A rule of one point would be another thing: it leaves modes of a cell without k″, and the minimiser then needs two to
//! three times as many iterations.

use super::CpuAssembler;
use super::element::{Edges, MAX_EDGES};
use super::trilinear::least_at_corners;
use crate::energy::{Material, shortened};
use crate::grid::{Grid, MAX_CORNERS};
use crate::quadrature::{Rule, edge_ends};
use crate::small::{F32x4, Matrix, Scalar, cofactor, dot};
use crate::stencil::StencilOperator;

/// Determinants below this are taken as this: k″ must stay within f32.
const LEAST: f64 = 1e-4;

const LANES: usize = F32x4::LANES;

/// ∫ ∂_pN_A ∂_qN_B over the unit cell, by corners A and B. In the plane, where they are not needed, zero.
pub(super) struct CellIntegrals<const D: usize> {
    /// For p = q, the same for all A and B that differ along the same axes: by A xor B.
    same: [[f32; D]; MAX_CORNERS],
    /// For p = k + 1 and q = k + 2, by k.
    mixed: [[[f32; D]; MAX_CORNERS]; MAX_CORNERS],
}

impl<const D: usize> CellIntegrals<D> {
    pub fn new() -> Self {
        let mut integrals = Self { same: [[0.0; D]; MAX_CORNERS], mixed: [[[0.0; D]; MAX_CORNERS]; MAX_CORNERS] };
        if D != 3 {
            return integrals;
        }
        let bit = |corner: usize, axis: usize| corner >> axis & 1;
        let sign = |corner: usize, axis: usize| if bit(corner, axis) == 1 { 1.0 } else { -1.0 };
        for a in 0..Grid::<D>::CORNERS {
            for b in 0..Grid::<D>::CORNERS {
                // Along an axis ∫ N N is 1/3 or 1/6, ∫ N′ N is ±1/2, ∫ N′ N′ is ±1.
                let mass = |axis: usize| if bit(a, axis) == bit(b, axis) { 1.0 / 3.0 } else { 1.0 / 6.0 };
                for k in 0..D {
                    let (p, q) = ((k + 1) % D, (k + 2) % D);
                    integrals.same[a ^ b][k] = sign(a, k) * sign(b, k) * mass(p) * mass(q);
                    integrals.mixed[a][b][k] = 0.25 * sign(a, p) * sign(b, q) * mass(k);
                }
            }
        }
        integrals
    }
}

/// Whether corners that differ along these axes differ along both p and q or along neither: then p and q may be exchanged in
/// their integral. Otherwise that changes its sign.
#[inline(always)]
fn is_even(axes: usize, p: usize, q: usize) -> bool {
    axes >> p & 1 == axes >> q & 1
}

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    /// Adds the volume's hessian over the cells of a layer, for D = 3.
    pub(super) fn spatial_hessian_pass<const C: usize>(
        &self,
        layer: usize,
        displacement: &[f64],
        operator: &mut StencilOperator<D>,
    ) {
        let material = &self.functional.material;
        let cells = self.grid.cells() as f64;
        let offsets = self.grid.corner_offsets();
        let a_layer = self.grid.cells().pow(D as u32 - 1);
        let first = layer * a_layer;
        for (pack, weights) in self.volume_weight[first..][..a_layer].chunks_exact(LANES).enumerate() {
            let base = self.grid.lowest_node(first + pack * LANES);
            // Differences are taken before the numbers are rounded.
            let mut edges: Edges<F32x4, D> = [[[F32x4::zero(); D]; MAX_EDGES]; D];
            for (axis, edges) in edges.iter_mut().enumerate() {
                for (edge, difference) in edges.iter_mut().enumerate().take(Rule::<D, 2>::EDGES) {
                    let (low, high) = edge_ends(axis, edge);
                    let (low, high) =
                        (&displacement[(base + offsets[low]) * D..], &displacement[(base + offsets[high]) * D..]);
                    for k in 0..D {
                        difference[k] = F32x4::gather(|lane| (high[lane * D + k] - low[lane * D + k]) * cells);
                    }
                }
            }
            let scaled = F32x4::gather(|lane| weights[lane] * cells * cells);
            let middle = Middle::of(material, scaled, &edges);
            let same: [Matrix<F32x4, D>; C] = std::array::from_fn(|axes| middle.same(&self.integrals.same[axes]));
            let places = self.corner_places::<C>(base);
            for a in 0..C {
                for b in a..C {
                    let block = middle.block(&same[a ^ b], a ^ b, &self.integrals.mixed[a][b]);
                    operator.add_lanes(places[a], self.corner_neighbours[a][b], &block);
                }
            }
            let least = least_at_corners(&edges);
            self.stiffen_corners::<F32x4, C>(least, base, weights, displacement, operator);
        }
    }
}

/// The second derivative at the middle of the cells. Of symmetric matrices the upper half counts.
struct Middle<const D: usize> {
    mu: F32x4,
    /// k″ c_k ⊗ c_k, by k.
    squares: [Matrix<F32x4, D>; D],
    /// k″ (c_p ⊗ c_q + c_q ⊗ c_p), by k.
    sums: [Matrix<F32x4, D>; D],
    /// (k″ J + 2 t k′) f_k, by k.
    turns: Matrix<F32x4, D>,
}

impl<const D: usize> Middle<D> {
    #[inline(always)]
    fn of(material: &Material, weight: F32x4, edges: &Edges<F32x4, D>) -> Self {
        let middle: Matrix<F32x4, D> = std::array::from_fn(|axis| {
            let [a, b, c, d] = &edges[axis];
            std::array::from_fn(|k| {
                all(if axis == k { 1.0 } else { 0.0 }) + all(0.25) * ((a[k] + b[k]) + (c[k] + d[k]))
            })
        });
        let cof = cofactor(&middle);
        let own = dot(&middle[0], &cof[0]);
        let det = own.max(all(LEAST));
        let (_, slope, bend) = material.dilation(det * det);
        let mu = all(material.mu);
        let twist = shortened((det + det) * slope, &middle, det, mu);
        let second = slope + slope + all(4.0) * det * det * bend;
        let scaled = cof.map(|column| column.map(|entry| weight * second * entry));
        let [mut squares, mut sums] = [[[[F32x4::zero(); D]; D]; D]; 2];
        for k in 0..D {
            let (p, q) = ((k + 1) % D, (k + 2) % D);
            for i in 0..D {
                for j in i..D {
                    squares[k][i][j] = scaled[k][i] * cof[k][j];
                    sums[k][i][j] = scaled[p][i] * cof[q][j] + scaled[q][i] * cof[p][j];
                }
            }
        }
        let turn = weight * (twist + twist + second * own);
        let turns = middle.map(|column| column.map(|entry| turn * entry));
        Self { mu: weight * mu, squares, sums, turns }
    }

    /// What ∂_pN_A ∂_pN_B have part in.
    #[inline(always)]
    fn same(&self, integrals: &[f32; D]) -> Matrix<F32x4, D> {
        let mut block = [[F32x4::zero(); D]; D];
        for (k, integral) in integrals.iter().enumerate() {
            for i in 0..D {
                for j in i..D {
                    block[i][j] += F32x4::splat(*integral) * self.squares[k][i][j];
                }
                block[i][i] += F32x4::splat(*integral) * self.mu;
            }
        }
        block
    }

    /// The block of two corners that differ along these axes.
    #[inline(always)]
    fn block(&self, same: &Matrix<F32x4, D>, axes: usize, mixed: &[f32; D]) -> Matrix<F32x4, D> {
        let (mut block, mut turn) = (*same, [F32x4::zero(); D]);
        for (k, integral) in mixed.iter().enumerate() {
            let integral = F32x4::splat(*integral);
            if is_even(axes, (k + 1) % D, (k + 2) % D) {
                for i in 0..D {
                    for j in i..D {
                        block[i][j] += integral * self.sums[k][i][j];
                    }
                }
            } else {
                for i in 0..D {
                    turn[i] += integral * self.turns[k][i];
                }
            }
        }
        for k in 0..D {
            let (i, j) = ((k + 1) % D, (k + 2) % D);
            let even = block[i.min(j)][i.max(j)];
            (block[i][j], block[j][i]) = (even + turn[k], even - turn[k]);
        }
        block
    }
}

#[inline(always)]
fn all(number: f64) -> F32x4 {
    <F32x4 as Scalar>::splat(number)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::distance::SignedDistance;
    use crate::settings::Settings;

    /// At an affine deformation, the same in all cells, both ways sample the same coefficients. A checkerboard leaves the middles of
    /// cells as they are.
    #[test]
    fn the_hessian_is_that_of_the_term_at_the_middle_of_a_cell() {
        let grid = Grid::<3>::new(8);
        let sphere = |x: [f64; 3]| x.iter().map(|x| (x - 0.5).powi(2)).sum::<f64>().sqrt() - 0.2;
        let shape =
            SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|k| sphere(grid.position(k))).collect());
        let mut functional = Settings::default().functional(4);
        functional.vertex_share = 0.0;
        let assembler: CpuAssembler<3> = CpuAssembler::new(&functional, &shape, &shape);
        let slopes = [[0.1, 0.3, -0.2], [-0.2, -0.3, 0.1], [0.15, 0.2, 0.05]];
        let displacement = |checkers: f64| -> Vec<f64> {
            let at = |node| {
                let (x, index) = (grid.position(node), grid.node_index(node));
                let sign = if index.iter().sum::<usize>() % 2 == 0 { 1.0 } else { -1.0 };
                slopes.map(|row| dot(&row, &x) + checkers * sign)
            };
            (0..grid.node_count()).flat_map(at).collect()
        };
        let [mut found, mut expected] = [0, 1].map(|_| StencilOperator::zero(grid));
        let bent = displacement(0.005);
        (0..grid.cells()).for_each(|layer| assembler.spatial_hessian_pass::<8>(layer, &bent, &mut found));
        assembler.volume_hessian_pass::<f64, 8>(&displacement(0.0), &mut expected);
        let size = expected.numbers().fold(0.0_f32, |most, x| most.max(x.abs()));
        for (a, b) in found.numbers().zip(expected.numbers()) {
            assert!((a - b).abs() <= 1e-5 * size, "{a} is not {b}");
        }
    }
}
