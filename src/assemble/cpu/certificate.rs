//! A lower bound of det Dφ over a trilinear cell.
//!
//! With corners positive det Dφ may still be negative between them, and the volume energy would not notice: it depends on
//! the square. ∂φ/∂x, ∂φ/∂y and ∂φ/∂z are of degrees (0,1,1), (1,0,1) and (1,1,0), with the edges as coefficients in
//! Bernstein's basis, so that their triple product is of degree (2,2,2) with 27 coefficients, between which it lies:
//!
//! B_α = Σ e^x_{j k}·(e^y_{i′k′} × e^z_{i″j″}) / (C(2,α₀) C(2,α₁) C(2,α₂)),  i′+i″ = α₀, j+j″ = α₁, k+k′ = α₂.
//!
//! At the corners they are its values. Source: Johnen, Weill, Remacle, "Robust and efficient validation of the linear
//! hexahedral element", Procedia Engineering 203, 2017.

use super::element::Edges;
use super::trilinear::Modes;
use crate::small::{Scalar, Vector, dot};

/// The coefficient of α stands at α₀ + 3 α₁ + 9 α₂.
#[inline(always)]
pub(super) fn coefficients<S: Scalar, const D: usize>(edges: &Edges<S, D>) -> [S; 27] {
    let (zero, half) = (S::zero(), S::splat(0.5));
    let edge = |axis: usize, number: usize| -> Vector<S, D> {
        let mut edge = edges[axis][number];
        edge[axis] += S::splat(1.0);
        edge
    };
    // By α₀, k′ and j″; the mean of two where α₀ = 1.
    let mut crosses = [[[[zero; D]; 2]; 2]; 3];
    for k in 0..2 {
        for j in 0..2 {
            let of = |first: usize, second: usize| cross(&edge(1, first + 2 * k), &edge(2, second + 2 * j));
            let between = (of(0, 1), of(1, 0));
            crosses[0][k][j] = of(0, 0);
            crosses[1][k][j] = std::array::from_fn(|axis| half * (between.0[axis] + between.1[axis]));
            crosses[2][k][j] = of(1, 1);
        }
    }
    let mut result = [zero; 27];
    for (first, crosses) in crosses.iter().enumerate() {
        for j in 0..2 {
            for k in 0..2 {
                let along = edge(0, j + 2 * k);
                for (other_k, crosses) in crosses.iter().enumerate() {
                    for (other_j, cross) in crosses.iter().enumerate() {
                        let share =
                            S::splat(if j == other_j { 1.0 } else { 0.5 } * if k == other_k { 1.0 } else { 0.5 });
                        result[first + 3 * (j + other_j) + 9 * (k + other_k)] += share * dot(&along, cross);
                    }
                }
            }
        }
    }
    result
}

/// A quick bound below all coefficients: the determinant at the middle, less what triple products can change by when each
/// vector changes by no more than its edges do.
#[inline(always)]
pub(super) fn quick_bound<S: Scalar, const D: usize>(edges: &Edges<S, D>, modes: &Modes<S, D>) -> S {
    let middles: [Vector<S, D>; D] = std::array::from_fn(|axis| modes[axis][0]);
    let (mut lengths, mut reaches) = (S::splat(1.0), S::splat(1.0));
    for axis in 0..D {
        let middle = &middles[axis];
        let mut farthest = S::zero();
        for edge in &edges[axis] {
            let mut offset: Vector<S, D> = std::array::from_fn(|k| edge[k] - middle[k]);
            offset[axis] += S::splat(1.0);
            farthest = farthest.max(dot(&offset, &offset));
        }
        let length = dot(middle, middle).sqrt();
        lengths = lengths * length;
        reaches = reaches * (length + farthest.sqrt());
    }
    dot(&middles[0], &cross(&middles[1], &middles[2])) - (reaches - lengths)
}

#[inline(always)]
fn cross<S: Scalar, const D: usize>(a: &Vector<S, D>, b: &Vector<S, D>) -> Vector<S, D> {
    std::array::from_fn(|k| {
        let (k1, k2) = ((k + 1) % D, (k + 2) % D);
        a[k1] * b[k2] - a[k2] * b[k1]
    })
}

#[cfg(test)]
mod tests {
    use super::super::element::edge_differences;
    use super::super::trilinear::modes_of;
    use super::*;
    use crate::field::interpolate_derivative;
    use crate::grid::Grid;
    use crate::small::determinant;

    /// The displacements of the corners of a cell of width 1, up to `size` each way.
    fn corners(seed: u64, size: f64) -> [[f64; 3]; 8] {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            size * ((state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
        };
        std::array::from_fn(|_| std::array::from_fn(|_| next()))
    }

    fn determinant_at(corners: &[[f64; 3]; 8], point: [f64; 3]) -> f64 {
        let mut slope = interpolate_derivative::<3, 3>(Grid::new(1), corners.as_flattened(), &point);
        (0..3).for_each(|k| slope[k][k] += 1.0);
        determinant(&slope)
    }

    #[test]
    fn the_coefficients_are_the_determinants_own_in_bernsteins_basis() {
        let basis = |i: usize, t: f64| [(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t][i];
        for seed in 0..50 {
            let corners = corners(seed, 0.5);
            let coefficients = coefficients(&edge_differences::<f64, 3>(&corners, 1.0));
            for point in [[0.0, 1.0, 0.0], [0.5, 0.5, 0.5], [0.2, 0.7, 0.4], [1.0, 0.3, 0.9]] {
                let sum: f64 = (0..27)
                    .map(|a| {
                        coefficients[a] * basis(a % 3, point[0]) * basis(a / 3 % 3, point[1]) * basis(a / 9, point[2])
                    })
                    .sum();
                let expected = determinant_at(&corners, point);
                assert!((sum - expected).abs() < 1e-12, "{sum} is not {expected}");
            }
        }
    }

    #[test]
    fn the_quick_bound_is_below_all_coefficients_and_sharp_for_affine_cells() {
        let least = |edges: &Edges<f64, 3>| coefficients(edges).into_iter().fold(f64::INFINITY, f64::min);
        for seed in 0..200 {
            for size in [0.01, 0.1, 0.5] {
                let edges = edge_differences::<f64, 3>(&corners(seed, size), 1.0);
                assert!(quick_bound(&edges, &modes_of(&edges)) <= least(&edges) + 1e-14);
            }
        }
        let edges: Edges<f64, 3> = std::array::from_fn(|axis| [[0.1 * axis as f64, -0.2, 0.05]; 4]);
        assert!((quick_bound(&edges, &modes_of(&edges)) - least(&edges)).abs() < 1e-14);
    }

    #[test]
    fn cells_with_positive_corners_may_fold_inside() {
        let mut folded = 0;
        for seed in 0..3000 {
            let corners = corners(seed, 0.6);
            let coefficients = coefficients(&edge_differences::<f64, 3>(&corners, 1.0));
            let at_corners = (0..8).map(|c| determinant_at(&corners, std::array::from_fn(|k| (c >> k & 1) as f64)));
            if at_corners.fold(f64::INFINITY, f64::min) > 0.0 {
                let inside = (0..1000)
                    .map(|k| determinant_at(&corners, [k % 10, k / 10 % 10, k / 100].map(|i| f64::from(i) / 9.0)));
                let least = inside.fold(f64::INFINITY, f64::min);
                assert!(coefficients.iter().any(|&c| c <= least + 1e-12), "a coefficient lies below all values");
                folded += usize::from(least < -1e-3);
            }
        }
        assert!(folded > 0, "there are such cells");
    }
}
