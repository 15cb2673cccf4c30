//! The shell's hessian of a cell in space with two Gauss points an axis.
//!
//! In coordinates ξ that are ±1 at the points the modes of a cell are ξ^α = Π_{k ∈ α} ξ_k, for the sets α of axes. ∂_k takes
//! ξ^α to ξ^(α ∖ k), or to zero without k, and since ξ_k² = 1 at the points, there the product of two modes is a mode: that of
//! the axes in one set alone, α △ β. So of a second derivative H_pq by ∂_pφ and φ, with its moments Ĥ_pq(γ) = Σ ξ^γ H_pq over
//! the points, two modes couple by sums
//!
//! Σ_pq Ĥ_pq((α ∖ p) △ (β ∖ q)),
//!
//! p an axis of α or, for φ itself, none. The corners lie at ξ_k = ±√3, their shape functions are Π (1 ± ξ_k/√3)/2. A set of
//! axes is a number of bits, as a corner and a point are.

use super::element::Pairs;
use crate::energy::{MAX_SLOTS, Response, normal_slot, position_slot};
use crate::quadrature::edge_ends;
use crate::small::{Scalar, Vector};

/// Numbers by points, or by modes, and C = 2^D of them: `[p][q][i][j]` for the axes p ≤ q and φ.
pub(super) struct PointHessians<S, const D: usize, const C: usize>([[[[[S; C]; D]; D]; MAX_SLOTS]; MAX_SLOTS]);

impl<S: Scalar, const D: usize, const C: usize> PointHessians<S, D, C> {
    pub fn zero() -> Self {
        Self([[[[[S::zero(); C]; D]; D]; MAX_SLOTS]; MAX_SLOTS])
    }

    /// Overwrites a point's: from the reference's frame to the axes, in a grid of `cells` a side.
    #[inline(always)]
    pub fn put(&mut self, point: usize, frame: &[Vector<S, D>; D], response: &Response<S, D>, cells: f64) {
        let (hessian, n, y) = (&response.hessian, normal_slot::<D>(), position_slot::<D>());
        // ∂ξ/∂x = 2√3 cells.
        let scale = S::splat(2.0 * 3.0_f64.sqrt() * cells);
        let frame = frame.map(|vector| vector.map(|entry| scale * entry));
        for p in 0..D {
            for i in 0..D {
                for j in 0..D {
                    let along = [
                        frame[0][p] * hessian[0][0][i][j] + frame[1][p] * hessian[0][1][j][i],
                        frame[0][p] * hessian[0][1][i][j] + frame[1][p] * hessian[1][1][i][j],
                    ];
                    let across = frame[n][p] * hessian[n][n][i][j];
                    for q in p..D {
                        self.0[p][q][i][j][point] =
                            frame[0][q] * along[0] + frame[1][q] * along[1] + frame[n][q] * across;
                    }
                    self.0[p][y][i][j][point] = frame[0][p] * hessian[0][y][i][j]
                        + frame[1][p] * hessian[1][y][i][j]
                        + frame[n][p] * hessian[n][y][i][j];
                }
            }
        }
        for i in 0..D {
            for j in 0..D {
                self.0[y][y][i][j][point] = hessian[y][y][i][j];
            }
        }
    }

    /// Overwrites the blocks of corners a ≤ b.
    pub fn integrate(&mut self, pairs: &mut Pairs<S, D, C>) {
        for p in 0..=D {
            for q in p..=D {
                self.0[p][q].as_flattened_mut().iter_mut().for_each(to_modes);
            }
        }
        for i in 0..D {
            for j in i..D {
                let mut coupled = self.coupled(i, j);
                for (first, row) in coupled.iter_mut().enumerate() {
                    for (second, entry) in row.iter_mut().enumerate() {
                        *entry = *entry * S::splat(share(first) * share(second));
                    }
                    to_corners(row);
                }
                for b in 0..C {
                    let mut column: [S; C] = std::array::from_fn(|first| coupled[first][b]);
                    to_corners(&mut column);
                    for a in 0..C {
                        if a <= b {
                            pairs[a][b][i][j] = column[a];
                        }
                        if a >= b {
                            pairs[b][a][j][i] = column[a];
                        }
                    }
                }
            }
        }
    }

    /// What couples the modes' components i and j.
    #[inline(always)]
    fn coupled(&self, i: usize, j: usize) -> [[S; C]; C] {
        let y = position_slot::<D>();
        let moments = &self.0[y][y][i][j];
        let mut coupled: [[S; C]; C] = std::array::from_fn(|a| std::array::from_fn(|b| moments[a ^ b]));
        for p in 0..D {
            for e in 0..C / 2 {
                let (without, with) = edge_ends(p, e);
                let (left, right) = (&self.0[p][y][i][j], &self.0[p][y][j][i]);
                for other in 0..C {
                    coupled[with][other] += left[without ^ other];
                    coupled[other][with] += right[without ^ other];
                }
                for q in 0..D {
                    let moments = if p <= q { &self.0[p][q][i][j] } else { &self.0[q][p][j][i] };
                    for f in 0..C / 2 {
                        let (other_without, other_with) = edge_ends(q, f);
                        coupled[with][other_with] += moments[without ^ other_without];
                    }
                }
            }
        }
        coupled
    }
}

/// Of a mode in a shape function, but for its sign.
fn share(mode: usize) -> f64 {
    const ROOT: f64 = 0.577_350_269_189_625_8;
    [0.125, 0.125 * ROOT, 0.125 / 3.0, 0.125 / 3.0 * ROOT][mode.count_ones() as usize]
}

/// Σ ξ^γ over the points, in their place.
#[inline(always)]
fn to_modes<S: Scalar, const C: usize>(numbers: &mut [S; C]) {
    butterflies(numbers, |low, high| [low + high, high - low]);
}

/// The transpose.
#[inline(always)]
fn to_corners<S: Scalar, const C: usize>(numbers: &mut [S; C]) {
    butterflies(numbers, |without, with| [without - with, without + with]);
}

#[inline(always)]
fn butterflies<S: Scalar, const C: usize>(numbers: &mut [S; C], of: impl Fn(S, S) -> [S; 2]) {
    for axis in 0..C.ilog2() as usize {
        for edge in 0..C / 2 {
            let (low, high) = edge_ends(axis, edge);
            [numbers[low], numbers[high]] = of(numbers[low], numbers[high]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::shell::add_point_pairs;
    use super::*;
    use crate::quadrature::Rule;
    use crate::small::normal_to;

    #[test]
    fn corners_couple_as_the_points_do_one_by_one() {
        let mut number = 0;
        let mut next = || {
            number += 1;
            (1.7 * f64::from(number * number)).sin()
        };
        let (cells, rule) = (4.0, Rule::<3, 2>::gauss2());
        let mut expected = [[[[0.0; 3]; 3]; 8]; 8];
        let mut hessians = PointHessians::<f64, 3, 8>::zero();
        for point in 0..8 {
            let mut frame: [[f64; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| next()));
            frame[2] = normal_to(&frame);
            let mut response = Response::<f64, 3>::zero();
            // No term couples a tangent with the normal.
            for (p, q) in [(0, 0), (0, 1), (1, 1), (2, 2), (0, 3), (1, 3), (2, 3), (3, 3)] {
                for (i, j) in (0..9).map(|k| (k / 3, k % 3)).filter(|(i, j)| p != q || i <= j) {
                    response.hessian[p][q][i][j] = next();
                    if p == q {
                        response.hessian[p][q][j][i] = response.hessian[p][q][i][j];
                    }
                }
            }
            add_point_pairs(&rule, &mut expected, point, &frame, &response, cells);
            hessians.put(point, &frame, &response, cells);
        }
        let mut found = [[[[f64::NAN; 3]; 3]; 8]; 8];
        hessians.integrate(&mut found);
        for b in 0..8 {
            for a in 0..=b {
                for (found, expected) in found[a][b].as_flattened().iter().zip(expected[a][b].as_flattened()) {
                    assert!((found - expected).abs() < 1e-12, "{a} and {b}: {found} is not {expected}");
                }
            }
        }
    }
}
