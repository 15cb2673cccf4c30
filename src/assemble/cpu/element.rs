//! A cell of multilinear elements: what its corners do along its edges, and back.

use crate::grid::MAX_CORNERS;
use crate::quadrature::{Rule, edge_ends};
use crate::small::{Matrix, Scalar, Vector, add_scaled};

pub(super) const MAX_EDGES: usize = 4;
pub(super) const MAX_COLUMNS: usize = 9;

/// Differences of a cell's displacements along its edges, and what hangs on them.
pub(super) type Edges<S, const D: usize> = [[Vector<S, D>; MAX_EDGES]; D];
pub(super) type Columns<S, const D: usize> = [[Vector<S, D>; MAX_COLUMNS]; D];
pub(super) type Corners<S, const D: usize> = [Vector<S, D>; MAX_CORNERS];
/// The hessian of a cell: `pairs[a][b]` is the block of corners a ≤ b.
pub(super) type Pairs<S, const D: usize, const C: usize> = [[Matrix<S, D>; C]; C];

/// (u_high − u_low)/h along every edge.
#[inline(always)]
pub(super) fn edge_differences<S: Scalar, const D: usize>(corners: &Corners<S, D>, inverse: S) -> Edges<S, D> {
    let mut edges = [[[S::zero(); D]; MAX_EDGES]; D];
    for (axis, edges) in edges.iter_mut().enumerate() {
        for (edge, difference) in edges.iter_mut().enumerate().take(1 << (D - 1)) {
            let (low, high) = edge_ends(axis, edge);
            for k in 0..D {
                difference[k] = (corners[high][k] - corners[low][k]) * inverse;
            }
        }
    }
    edges
}

/// The distinct columns ∂φ/∂x_k of a rule.
#[inline(always)]
pub(super) fn columns_of<S: Scalar, const D: usize, const M: usize>(
    rule: &Rule<D, M>,
    edges: &Edges<S, D>,
) -> Columns<S, D> {
    let mut columns = [[[S::zero(); D]; MAX_COLUMNS]; D];
    for axis in 0..D {
        for column in 0..Rule::<D, M>::COLUMNS {
            let sum = &mut columns[axis][column];
            sum[axis] = S::splat(1.0);
            for edge in 0..Rule::<D, M>::EDGES {
                *sum = add_scaled(sum, S::splat(rule.edge[column][edge]), &edges[axis][edge]);
            }
        }
    }
    columns
}

#[inline(always)]
pub(super) fn slots_at<S: Scalar, const D: usize, const M: usize>(
    rule: &Rule<D, M>,
    columns: &Columns<S, D>,
    point: usize,
) -> [Vector<S, D>; D] {
    std::array::from_fn(|k| columns[k][rule.column[point][k]])
}

/// The transpose of [`columns_of`].
#[inline(always)]
pub(super) fn stress_to_edges<S: Scalar, const D: usize, const M: usize>(
    rule: &Rule<D, M>,
    stress: &Columns<S, D>,
    forces: &mut Edges<S, D>,
) {
    for axis in 0..D {
        for edge in 0..Rule::<D, M>::EDGES {
            for column in 0..Rule::<D, M>::COLUMNS {
                let share = S::splat(rule.edge[column][edge]);
                forces[axis][edge] = add_scaled(&forces[axis][edge], share, &stress[axis][column]);
            }
        }
    }
}

/// The transpose of [`edge_differences`].
#[inline(always)]
pub(super) fn edge_forces_to_corners<S: Scalar, const D: usize>(
    forces: &Edges<S, D>,
    inverse: S,
    corners: &mut Corners<S, D>,
) {
    for (axis, forces) in forces.iter().enumerate() {
        for (edge, force) in forces.iter().enumerate().take(1 << (D - 1)) {
            let (low, high) = edge_ends(axis, edge);
            corners[high] = add_scaled(&corners[high], inverse, force);
            corners[low] = add_scaled(&corners[low], -inverse, force);
        }
    }
}

/// Adds the block of two edges to the blocks of their ends; (p, e) against (q, f) stands for its mirror image too.
#[cfg(test)]
pub(super) fn add_edge_pair<S: Scalar, const D: usize, const C: usize>(
    pairs: &mut Pairs<S, D, C>,
    (p, e): (usize, usize),
    (q, f): (usize, usize),
    block: &Matrix<S, D>,
) {
    let mut add = |a: usize, b: usize, positive: bool, transposed: bool| {
        if a > b {
            return;
        }
        for i in 0..D {
            for j in 0..D {
                let entry = if transposed { block[j][i] } else { block[i][j] };
                pairs[a][b][i][j] += if positive { entry } else { -entry };
            }
        }
    };
    let (first, second) = (edge_ends(p, e), edge_ends(q, f));
    for (a, a_high) in [(first.0, false), (first.1, true)] {
        for (b, b_high) in [(second.0, false), (second.1, true)] {
            add(a, b, a_high == b_high, false);
            if p != q {
                add(b, a, a_high == b_high, true);
            }
        }
    }
}
