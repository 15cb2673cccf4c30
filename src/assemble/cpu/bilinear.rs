//! A bilinear cell of the plane as three vectors, and quadrature along its edges.

use super::element::Corners;
use crate::grid::MAX_CORNERS;
use crate::quadrature::Rule;
use crate::small::{Matrix, Scalar, Vector};

/// The derivative of a bilinear map on one cell a lane; also what is conjugate to it.
pub(super) struct Cell<S, const D: usize> {
    pub a: Vector<S, D>,
    pub b: Vector<S, D>,
    pub c: Vector<S, D>,
}

/// u × v.
#[inline(always)]
fn cross<S: Scalar, const D: usize>(u: &Vector<S, D>, v: &Vector<S, D>) -> S {
    u[0] * v[1] - u[1] * v[0]
}

/// ∂(u × v)/∂u.
#[inline(always)]
pub(super) fn turned<S: Scalar, const D: usize>(v: &Vector<S, D>) -> Vector<S, D> {
    std::array::from_fn(|k| if k == 0 { v[1] } else { -v[0] })
}

#[inline(always)]
pub(super) fn combined<S: Scalar, const D: usize>(p: S, u: &Vector<S, D>, q: S, v: &Vector<S, D>) -> Vector<S, D> {
    std::array::from_fn(|k| p * u[k] + q * v[k])
}

#[inline(always)]
pub(super) fn transposed<S: Scalar, const D: usize>(m: &Matrix<S, D>) -> Matrix<S, D> {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

impl<S: Scalar, const D: usize> Cell<S, D> {
    /// Of φ = x + u, from differences of u divided by h: along the lower and the upper edge, the left and the right.
    #[inline(always)]
    pub(super) fn of_edges(
        lower: &Vector<S, D>,
        upper: &Vector<S, D>,
        left: &Vector<S, D>,
        right: &Vector<S, D>,
    ) -> Self {
        let half = S::splat(0.5);
        let mut a: Vector<S, D> = std::array::from_fn(|k| half * (lower[k] + upper[k]));
        let mut b: Vector<S, D> = std::array::from_fn(|k| half * (left[k] + right[k]));
        a[0] += S::splat(1.0);
        b[1] += S::splat(1.0);
        Self { a, b, c: std::array::from_fn(|k| upper[k] - lower[k]) }
    }

    #[inline(always)]
    pub(super) fn of_corners(corners: &Corners<S, D>, inverse: S) -> Self {
        let edge = |low: usize, high: usize| -> Vector<S, D> {
            std::array::from_fn(|k| (corners[high][k] - corners[low][k]) * inverse)
        };
        Self::of_edges(&edge(0, 1), &edge(2, 3), &edge(0, 2), &edge(1, 3))
    }

    /// det Dφ = `[0]` + s `[1]` + t `[2]`.
    #[inline(always)]
    pub(super) fn determinant(&self) -> [S; 3] {
        [cross(&self.a, &self.b), cross(&self.a, &self.c), cross(&self.c, &self.b)]
    }

    /// An affine function is least at a corner.
    #[inline(always)]
    pub(super) fn least_determinant(&self) -> S {
        let [middle, by_s, by_t] = self.determinant();
        middle - S::splat(0.5) * (by_s.abs() + by_t.abs())
    }

    /// Forces on the corners from those on a, b and c.
    #[inline(always)]
    pub(super) fn corner_forces(&self, inverse: S) -> Corners<S, D> {
        let half = S::splat(0.5) * inverse;
        let mut corners = [[S::zero(); D]; MAX_CORNERS];
        for k in 0..D {
            let forces = to_corners(half * self.a[k], half * self.b[k], inverse * self.c[k]);
            for (corner, force) in corners.iter_mut().zip(forces) {
                corner[k] = force;
            }
        }
        corners
    }
}

/// The transpose of how corners move 2ha, 2hb and hc: by ±1 as they lie on the axes, and by the product.
#[inline(always)]
pub(super) fn to_corners<S: Scalar>(a: S, b: S, c: S) -> [S; 4] {
    let (sum, difference) = (a + b, a - b);
    [c - sum, difference - c, -(difference + c), sum + c]
}

/// Points and weights of a rule along one axis, centred.
#[derive(Clone, Copy)]
pub(super) struct Line<S, const M: usize> {
    pub place: [S; M],
    pub weight: [S; M],
}

impl<S: Scalar, const M: usize> Line<S, M> {
    pub(super) fn of<const D: usize>(rule: &Rule<D, M>) -> Self {
        // In the plane a column of Dφ is a point of the other axis, and the share of its second edge its coordinate.
        let weight = |i: usize| (0..Rule::<D, M>::POINTS).filter(|p| p % M == i).map(|p| rule.weight[p]).sum();
        Self {
            place: std::array::from_fn(|i| S::splat(rule.edge[i][1] - 0.5)),
            weight: std::array::from_fn(|i| S::splat(weight(i))),
        }
    }

    /// Σ w s²: the second moment of the cell by this rule.
    pub(super) fn second_moment(&self) -> S {
        let mut sum = S::zero();
        for i in 0..M {
            sum += self.weight[i] * self.place[i] * self.place[i];
        }
        sum
    }
}
