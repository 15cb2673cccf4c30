//! Vectors and matrices of the dimension D, over a scalar or over lanes of it.
//!
//! `[S; D]` is a vector, `[[S; D]; D]` a matrix stored by rows: `m[row][column]`.
//! [`Scalar`] is implemented for `f64` and for lanes of several numbers, so every formula written
//! against it is at once the reference and the fast path.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Two lanes of f64: one SSE2 or wasm `simd128` register.
pub type F64x2 = wide::f64x2;

/// Four lanes of f32 in one such register, for what need not be exact.
pub type F32x4 = wide::f32x4;

pub type Vector<S, const D: usize> = [S; D];
pub type Matrix<S, const D: usize> = [[S; D]; D];

/// The arithmetic that energies need: a field, a square root, and comparison by lane.
pub trait Scalar:
    Copy
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + 'static
{
    const LANES: usize;

    fn splat(value: f64) -> Self;
    /// Lane k holds `f(k)`.
    fn gather(f: impl Fn(usize) -> f64) -> Self;
    fn lane(self, k: usize) -> f64;
    fn sqrt(self) -> Self;
    fn max(self, other: Self) -> Self;
    fn min(self, other: Self) -> Self;

    fn zero() -> Self {
        Self::splat(0.0)
    }
    fn abs(self) -> Self {
        self.max(-self)
    }
    fn square(self) -> Self {
        self * self
    }
    /// The sum over the lanes.
    fn sum(self) -> f64 {
        (0..Self::LANES).map(|k| self.lane(k)).sum()
    }
    /// The least lane; NaN in any lane gives NaN, so a broken point cannot hide.
    fn least(self) -> f64 {
        (0..Self::LANES).map(|k| self.lane(k)).fold(f64::INFINITY, |a, b| if b.is_nan() || b < a { b } else { a })
    }
}

impl Scalar for f64 {
    const LANES: usize = 1;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn gather(f: impl Fn(usize) -> f64) -> Self {
        f(0)
    }
    #[inline(always)]
    fn lane(self, _: usize) -> f64 {
        self
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
}

impl Scalar for F64x2 {
    const LANES: usize = 2;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        F64x2::from([value; 2])
    }
    #[inline(always)]
    fn gather(f: impl Fn(usize) -> f64) -> Self {
        F64x2::from([f(0), f(1)])
    }
    #[inline(always)]
    fn lane(self, k: usize) -> f64 {
        self.to_array()[k]
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        F64x2::sqrt(self)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.fast_max(other)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.fast_min(other)
    }
}

impl Scalar for F32x4 {
    const LANES: usize = 4;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        F32x4::from([value as f32; 4])
    }
    #[inline(always)]
    fn gather(f: impl Fn(usize) -> f64) -> Self {
        F32x4::from([f(0) as f32, f(1) as f32, f(2) as f32, f(3) as f32])
    }
    #[inline(always)]
    fn lane(self, k: usize) -> f64 {
        f64::from(self.to_array()[k])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        F32x4::sqrt(self)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.fast_max(other)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.fast_min(other)
    }
}

#[inline(always)]
pub fn dot<S: Scalar, const D: usize>(a: &Vector<S, D>, b: &Vector<S, D>) -> S {
    let mut sum = a[0] * b[0];
    for k in 1..D {
        sum += a[k] * b[k];
    }
    sum
}

/// a + s·b.
#[inline(always)]
pub fn add_scaled<S: Scalar, const D: usize>(a: &Vector<S, D>, s: S, b: &Vector<S, D>) -> Vector<S, D> {
    std::array::from_fn(|k| a[k] + s * b[k])
}

/// M·v.
#[inline(always)]
pub fn apply<S: Scalar, const D: usize>(m: &Matrix<S, D>, v: &Vector<S, D>) -> Vector<S, D> {
    std::array::from_fn(|row| dot(&m[row], v))
}

/// The sum of the squares of all entries.
#[inline(always)]
pub fn frobenius<S: Scalar, const D: usize>(m: &Matrix<S, D>) -> S {
    let mut sum = S::zero();
    for row in m {
        sum += dot(row, row);
    }
    sum
}

/// The matrix of cofactors, so that det m = Σ_k m₀ₖ cof₀ₖ and ∂det/∂m = cof m.
#[inline(always)]
pub fn cofactor<S: Scalar, const D: usize>(m: &Matrix<S, D>) -> Matrix<S, D> {
    let mut cof = [[S::zero(); D]; D];
    match D {
        1 => cof[0][0] = S::splat(1.0),
        2 => {
            cof[0][0] = m[1][1];
            cof[0][1] = -m[1][0];
            cof[1][0] = -m[0][1];
            cof[1][1] = m[0][0];
        }
        3 => {
            for i in 0..3 {
                let (i1, i2) = ((i + 1) % 3, (i + 2) % 3);
                for j in 0..3 {
                    let (j1, j2) = ((j + 1) % 3, (j + 2) % 3);
                    cof[i][j] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
                }
            }
        }
        _ => unreachable!("dimensions are 1, 2 and 3"),
    }
    cof
}

#[inline(always)]
pub fn determinant<S: Scalar, const D: usize>(m: &Matrix<S, D>) -> S {
    dot(&m[0], &cofactor(m)[0])
}

#[inline(always)]
pub fn identity<S: Scalar, const D: usize>() -> Matrix<S, D> {
    std::array::from_fn(|i| std::array::from_fn(|j| S::splat(if i == j { 1.0 } else { 0.0 })))
}

/// An orthonormal frame whose last column is the unit vector `normal`; the columns before it are tangents.
///
/// D = 2: the tangent is the normal turned by +90°; around a body with outward normals it runs counter-clockwise.
/// Stored by columns: `frame[k]` is the k-th vector.
pub fn frame<const D: usize>(normal: &[f64; D]) -> [[f64; D]; D] {
    let mut frame = [[0.0; D]; D];
    frame[D - 1] = *normal;
    match D {
        2 => {
            frame[0][0] = -normal[1];
            frame[0][1] = normal[0];
        }
        3 => {
            // The axis least aligned with the normal keeps the cross product away from zero.
            let axis = (0..3).min_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs())).unwrap_or(0);
            let mut first = [0.0; D];
            first[axis] = 1.0;
            let first = add_scaled(&first, -normal[axis], normal);
            let length = dot(&first, &first).sqrt();
            frame[0] = first.map(|x| x / length);
            for k in 0..3 {
                let (k1, k2) = ((k + 1) % 3, (k + 2) % 3);
                frame[1][k] = normal[k1] * frame[0][k2] - normal[k2] * frame[0][k1];
            }
        }
        _ => unreachable!("curves and surfaces live in 2 or 3 dimensions"),
    }
    frame
}

/// The last vector of a [`frame`] from those before it.
#[inline(always)]
pub fn normal_to<S: Scalar, const D: usize>(frame: &[Vector<S, D>; D]) -> Vector<S, D> {
    std::array::from_fn(|k| match D {
        2 if k == 0 => frame[0][1],
        2 => -frame[0][0],
        _ => {
            let (k1, k2) = ((k + 1) % D, (k + 2) % D);
            frame[0][k1] * frame[1][k2] - frame[0][k2] * frame[1][k1]
        }
    })
}
