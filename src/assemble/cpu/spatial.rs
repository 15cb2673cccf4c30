//! The volume's hessian in space, four cells at a time.
//!
//! Of μ 1 + t k′ ∂²J + k″ ∂J ⊗ ∂J (see [`Volume`](crate::energy::Volume)) the first two parts are integrated exactly for the
//! coefficients at the middle of the cell: with M_AB = ∫ ∇N_A·∇N_B and g_AB = ∫ ∇N_A × ∇N_B, the same for all cells, their
//! blocks of corners A and B are μ M_AB 1 and d_A·(d_B × t k′ F g_AB). The third is taken at the 2³ Gauss points: fewer leave
//! modes of a cell without it, and the minimiser then needs two to three times as many iterations.

use super::CpuAssembler;
use super::element::{Columns, Edges, MAX_EDGES, columns_of, slots_at};
use super::trilinear::least_at_corners;
use crate::energy::{Material, shortened};
use crate::grid::{Grid, MAX_CORNERS};
use crate::quadrature::{Rule, edge_ends};
use crate::small::{F32x4, Matrix, Scalar, Vector, cofactor, determinant, dot};
use crate::stencil::StencilOperator;

/// Determinants below this are taken as this: k″ must stay within f32.
const LEAST: f64 = 1e-4;

const LANES: usize = F32x4::LANES;

/// ∫ over the unit cell, by corners A and B. In the plane, where they are not needed, zero.
pub(super) struct CellIntegrals<const D: usize> {
    /// ∇N_A·∇N_B.
    dots: [[f64; MAX_CORNERS]; MAX_CORNERS],
    /// ∇N_A × ∇N_B.
    crosses: [[Vector<f64, D>; MAX_CORNERS]; MAX_CORNERS],
}

impl<const D: usize> CellIntegrals<D> {
    pub fn new(rule: &Rule<D, 2>) -> Self {
        let mut integrals =
            Self { dots: [[0.0; MAX_CORNERS]; MAX_CORNERS], crosses: [[[0.0; D]; MAX_CORNERS]; MAX_CORNERS] };
        if D != 3 {
            return integrals;
        }
        for point in 0..Rule::<D, 2>::POINTS {
            let mut slopes = [[0.0; D]; MAX_CORNERS];
            for axis in 0..D {
                for edge in 0..Rule::<D, 2>::EDGES {
                    let (low, high) = edge_ends(axis, edge);
                    let share = rule.edge[rule.column[point][axis]][edge];
                    slopes[low][axis] = -share;
                    slopes[high][axis] = share;
                }
            }
            for (a, left) in slopes.iter().enumerate().take(Grid::<D>::CORNERS) {
                for (b, right) in slopes.iter().enumerate().take(Grid::<D>::CORNERS) {
                    integrals.dots[a][b] += rule.weight[point] * dot(left, right);
                    for k in 0..D {
                        let (k1, k2) = ((k + 1) % D, (k + 2) % D);
                        integrals.crosses[a][b][k] +=
                            rule.weight[point] * (left[k1] * right[k2] - left[k2] * right[k1]);
                    }
                }
            }
        }
        integrals
    }
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
            let columns = columns_of(&self.gauss2, &edges);
            let slopes: [[Vector<F32x4, D>; C]; C] =
                std::array::from_fn(|point| self.slopes_of_dilation(material, scaled, &columns, point));
            let middle = middle_of(&edges);
            let places = self.corner_places::<C>(base);
            let twist = shortened_twist(material, &middle);
            let (mu, twist) = (scaled * all(material.mu), scaled * twist);
            for a in 0..C {
                for b in a..C {
                    let mut block = [[F32x4::zero(); D]; D];
                    for slopes in &slopes {
                        for i in 0..D {
                            for j in 0..D {
                                block[i][j] += slopes[a][i] * slopes[b][j];
                            }
                        }
                    }
                    let own = mu * all(self.integrals.dots[a][b]);
                    for (i, row) in block.iter_mut().enumerate() {
                        row[i] += own;
                    }
                    if a != b {
                        let cross = self.integrals.crosses[a][b].map(all);
                        for k in 0..D {
                            let (i, j) = ((k + 1) % D, (k + 2) % D);
                            let mut turn = middle[0][k] * cross[0];
                            for axis in 1..D {
                                turn += middle[axis][k] * cross[axis];
                            }
                            let turn = twist * turn;
                            block[i][j] += turn;
                            block[j][i] -= turn;
                        }
                    }
                    operator.add_lanes(places[a], self.corner_neighbours[a][b], &block);
                }
            }
            let least = least_at_corners(&edges);
            self.stiffen_corners::<F32x4, C>(least, base, weights, displacement, operator);
        }
    }

    /// √(w k″) ∂J by the corners' displacements at a Gauss point of weight w.
    #[inline(always)]
    fn slopes_of_dilation<const C: usize>(
        &self,
        material: &Material,
        weight: F32x4,
        columns: &Columns<F32x4, D>,
        point: usize,
    ) -> [Vector<F32x4, D>; C] {
        let rule = &self.gauss2;
        let derivative = slots_at(rule, columns, point);
        let cof = cofactor(&derivative);
        let det = dot(&derivative[0], &cof[0]).max(all(LEAST));
        let (_, slope, bend) = material.dilation(det * det);
        let second = slope + slope + all(4.0) * det * det * bend;
        let root = (weight * all(rule.weight[point]) * second).sqrt();
        let mut slopes = [[F32x4::zero(); D]; C];
        for axis in 0..D {
            let cof = cof[axis].map(|c| root * c);
            for edge in 0..Rule::<D, 2>::EDGES {
                let share = all(rule.edge[rule.column[point][axis]][edge]);
                let (low, high) = edge_ends(axis, edge);
                for k in 0..D {
                    let part = share * cof[k];
                    slopes[high][k] += part;
                    slopes[low][k] -= part;
                }
            }
        }
        slopes
    }
}

#[inline(always)]
fn all(number: f64) -> F32x4 {
    <F32x4 as Scalar>::splat(number)
}

/// Dφ at the middle of the cells, by columns.
#[inline(always)]
fn middle_of<const D: usize>(edges: &Edges<F32x4, D>) -> Matrix<F32x4, D> {
    let count = Rule::<D, 2>::EDGES;
    std::array::from_fn(|axis| {
        std::array::from_fn(|k| {
            let sum = edges[axis][1..count].iter().fold(edges[axis][0][k], |sum, edge| sum + edge[k]);
            all(if axis == k { 1.0 } else { 0.0 }) + all(1.0 / count as f64) * sum
        })
    })
}

/// t k′ there.
#[inline(always)]
fn shortened_twist<const D: usize>(material: &Material, middle: &Matrix<F32x4, D>) -> F32x4 {
    let det = determinant(middle).max(all(LEAST));
    let (_, slope, _) = material.dilation(det * det);
    shortened((det + det) * slope, middle, det, all(material.mu))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::distance::SignedDistance;
    use crate::settings::Settings;

    /// At an affine deformation, the same in all cells, both ways sample the same coefficients.
    #[test]
    fn the_hessian_at_an_affine_deformation_is_that_of_the_term() {
        let grid = Grid::<3>::new(8);
        let sphere = |x: [f64; 3]| x.iter().map(|x| (x - 0.5).powi(2)).sum::<f64>().sqrt() - 0.2;
        let shape =
            SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|k| sphere(grid.position(k))).collect());
        let mut functional = Settings::default().functional(4);
        functional.vertex_share = 0.0;
        let assembler: CpuAssembler<3> = CpuAssembler::new(&functional, &shape, &shape);
        let slopes = [[0.1, 0.3, -0.2], [-0.2, -0.3, 0.1], [0.15, 0.2, 0.05]];
        let displacement: Vec<f64> = (0..grid.node_count())
            .flat_map(|node| {
                let x = grid.position(node);
                slopes.map(|row| dot(&row, &x))
            })
            .collect();
        let [mut found, mut expected] = [0, 1].map(|_| StencilOperator::zero(grid));
        (0..grid.cells()).for_each(|layer| assembler.spatial_hessian_pass::<8>(layer, &displacement, &mut found));
        assembler.volume_hessian_pass::<f64, 8>(&displacement, &mut expected);
        let size = expected.numbers().fold(0.0_f32, |most, x| most.max(x.abs()));
        for (a, b) in found.numbers().zip(expected.numbers()) {
            assert!((a - b).abs() <= 1e-5 * size, "{a} is not {b}");
        }
    }
}
