//! A trilinear cell by modes.
//!
//! ∂φ/∂x_k does not depend on x_k. With local coordinates s, t ∈ [−1, 1] for the other two it is
//!
//! ∂φ/∂x_k = m₀ + s m₁ + t m₂ + st m₃,
//!
//! and the m are the sums and differences of the cell's four edges along k, a quarter each.

use super::element::{Corners, Edges, MAX_EDGES};
use crate::grid::MAX_CORNERS;
use crate::quadrature::{Rule, edge_ends};
use crate::small::{Scalar, Vector, add_scaled, determinant};

/// m₀ to m₃ along each axis.
pub(super) type Modes<S, const D: usize> = [[Vector<S, D>; MAX_EDGES]; D];

/// The columns of Dφ at the places of a rule with M points an axis, by t and s.
pub(super) type Columns<S, const D: usize, const M: usize> = [[[Vector<S, D>; M]; M]; D];

/// The least determinant at the corners.
#[inline(always)]
pub(super) fn least_at_corners<S: Scalar, const D: usize>(edges: &Edges<S, D>) -> S {
    let columns = corner_columns(edges);
    let mut least = S::splat(f64::INFINITY);
    for corner in 0..Rule::<D, 2>::POINTS {
        let places = places_of::<D, 2>(corner);
        least = least.min(determinant(&derivative_at(&columns, &places)));
    }
    least
}

/// Dφ by columns, at a point with these [places](places_of).
#[inline(always)]
pub(super) fn derivative_at<S: Scalar, const D: usize, const M: usize>(
    columns: &Columns<S, D, M>,
    places: &[[usize; 2]; D],
) -> [Vector<S, D>; D] {
    std::array::from_fn(|axis| columns[axis][places[axis][1]][places[axis][0]])
}

/// For each axis, the places of a point along the other two.
#[inline(always)]
pub(super) fn places_of<const D: usize, const M: usize>(point: usize) -> [[usize; 2]; D] {
    let index = [point % M, point / M % M, point / (M * M)];
    std::array::from_fn(|axis| [index[usize::from(axis == 0)], index[2 - usize::from(axis == 2)]])
}

#[inline(always)]
pub(super) fn modes_of<S: Scalar, const D: usize>(edges: &Edges<S, D>) -> Modes<S, D> {
    let quarter = S::splat(0.25);
    let mut modes = [[[S::zero(); D]; MAX_EDGES]; D];
    for axis in 0..D {
        for k in 0..D {
            let [a, b, c, d] = edges[axis].map(|edge| edge[k]);
            let (low, high, low_slope, high_slope) = (a + b, c + d, b - a, d - c);
            let sums = [low + high, low_slope + high_slope, high - low, high_slope - low_slope];
            for (mode, sum) in modes[axis].iter_mut().zip(sums) {
                mode[k] = quarter * sum;
            }
        }
        modes[axis][0][axis] += S::splat(1.0);
    }
    modes
}

/// The transpose of [`modes_of`].
#[inline(always)]
pub(super) fn add_to_edges<S: Scalar, const D: usize>(modes: &Modes<S, D>, edges: &mut Edges<S, D>) {
    let quarter = S::splat(0.25);
    for axis in 0..D {
        for k in 0..D {
            let [a, b, c, d] = modes[axis].map(|mode| mode[k]);
            let (low, high, low_slope, high_slope) = (a - c, a + c, b - d, b + d);
            let sums = [low - low_slope, low + low_slope, high - high_slope, high + high_slope];
            for (edge, sum) in edges[axis].iter_mut().zip(sums) {
                edge[k] += quarter * sum;
            }
        }
    }
}

#[inline(always)]
pub(super) fn columns_of<S: Scalar, const D: usize, const M: usize>(
    rule: &Rule<D, M>,
    modes: &Modes<S, D>,
) -> Columns<S, D, M> {
    let place = |i: usize| S::splat(rule.place(i));
    let mut columns = [[[[S::zero(); D]; M]; M]; D];
    for axis in 0..D {
        let [mean, first, second, both] = &modes[axis];
        for j in 0..M {
            let (middle, slope) = (add_scaled(mean, place(j), second), add_scaled(first, place(j), both));
            for i in 0..M {
                columns[axis][j][i] = add_scaled(&middle, place(i), &slope);
            }
        }
    }
    columns
}

/// The transpose of [`columns_of`].
#[inline(always)]
pub(super) fn add_to_modes<S: Scalar, const D: usize, const M: usize>(
    rule: &Rule<D, M>,
    columns: &Columns<S, D, M>,
    modes: &mut Modes<S, D>,
) {
    let place = |i: usize| S::splat(rule.place(i));
    for axis in 0..D {
        let [mean, first, second, both] = &mut modes[axis];
        for j in 0..M {
            let (mut sum, mut slope) = ([S::zero(); D], [S::zero(); D]);
            for i in 0..M {
                let column = &columns[axis][j][i];
                for k in 0..D {
                    sum[k] += column[k];
                }
                slope = add_scaled(&slope, place(i), column);
            }
            for k in 0..D {
                mean[k] += sum[k];
                first[k] += slope[k];
            }
            *second = add_scaled(second, place(j), &sum);
            *both = add_scaled(both, place(j), &slope);
        }
    }
}

/// The columns of Dφ at the corners, which are the edges.
#[inline(always)]
pub(super) fn corner_columns<S: Scalar, const D: usize>(edges: &Edges<S, D>) -> Columns<S, D, 2> {
    let mut columns = [[[[S::zero(); D]; 2]; 2]; D];
    for axis in 0..D {
        for (column, edge) in columns[axis].as_flattened_mut().iter_mut().zip(&edges[axis]) {
            *column = *edge;
            column[axis] += S::splat(1.0);
        }
    }
    columns
}

/// Forces on the corners by those on the edges, times `scale`.
#[inline(always)]
pub(super) fn corner_forces<S: Scalar, const D: usize>(forces: &Edges<S, D>, scale: S) -> Corners<S, D> {
    let mut corners: [Vector<S, D>; MAX_CORNERS] = [[S::zero(); D]; MAX_CORNERS];
    for (axis, forces) in forces.iter().enumerate() {
        for (edge, force) in forces.iter().enumerate() {
            let (low, high) = edge_ends(axis, edge);
            for k in 0..D {
                corners[high][k] += force[k];
                corners[low][k] -= force[k];
            }
        }
    }
    corners.map(|corner| corner.map(|force| scale * force))
}
