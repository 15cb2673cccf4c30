//! The discrete Fourier transform of a power of two.

use std::ops::{Add, Mul, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex {
    pub re: f64,
    pub im: f64,
}

impl Complex {
    pub const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }
}

impl Add for Complex {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Complex {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Complex {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}

/// exp(−iπk/n) for k = 0, …, n − 1, n a power of two: by halving angles, without sines.
pub fn turns(n: usize) -> Vec<Complex> {
    let mut turns = vec![Complex::new(1.0, 0.0)];
    let mut root = Complex::new(0.0, -1.0);
    while turns.len() < n {
        turns = turns.iter().flat_map(|&turn| [turn, turn * root]).collect();
        let cos = (0.5 * (1.0 + root.re)).sqrt();
        root = Complex::new(cos, 0.5 * root.im / cos);
    }
    turns
}

/// Replaces x by Σ_j x_j exp(−2πijk/N), N = 2n its length, given [`turns`] of n; `scratch` is as long as `values`.
///
/// Source: Stockham's form of the fast transform, which leaves the result in order: R. C. Singleton, "On computing the
/// fast Fourier transform", Comm. ACM 10 (1967).
pub fn transform(turns: &[Complex], values: &mut Vec<Complex>, scratch: &mut Vec<Complex>) {
    assert!(values.len() == 2 * turns.len() && scratch.len() == values.len());
    let mut stride = 1;
    while stride <= turns.len() {
        let (low, high) = values.split_at(turns.len());
        let pairs = low.chunks_exact(stride).zip(high.chunks_exact(stride));
        let targets = scratch.chunks_exact_mut(2 * stride).zip(turns.iter().step_by(stride));
        for ((low, high), (target, &turn)) in pairs.zip(targets) {
            let (sums, differences) = target.split_at_mut(stride);
            for k in 0..stride {
                sums[k] = low[k] + high[k];
                differences[k] = (low[k] - high[k]) * turn;
            }
        }
        std::mem::swap(values, scratch);
        stride *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn turns_are_roots_of_unity() {
        for n in [1, 2, 8, 1024] {
            for (k, turn) in turns(n).into_iter().enumerate() {
                let (sin, cos) = (PI * k as f64 / n as f64).sin_cos();
                assert!((turn.re - cos).abs() < 1e-15 && (turn.im + sin).abs() < 1e-15, "{turn:?}, {k} of {n}");
            }
        }
    }

    #[test]
    fn the_fast_transform_is_the_slow_one() {
        for n in [1, 2, 4, 32] {
            let value = |j: usize| Complex::new(((j * j) as f64 * 0.7).sin(), (j as f64 * 1.3).cos());
            let mut values: Vec<Complex> = (0..2 * n).map(value).collect();
            transform(&turns(n), &mut values, &mut vec![Complex::default(); 2 * n]);
            for (k, &found) in values.iter().enumerate() {
                let turn = |j: usize| {
                    let (sin, cos) = (-PI * (j * k % (2 * n)) as f64 / n as f64).sin_cos();
                    Complex::new(cos, sin)
                };
                let sum = (0..2 * n).fold(Complex::default(), |sum, j| sum + value(j) * turn(j));
                assert!((found.re - sum.re).abs() < 1e-12 && (found.im - sum.im).abs() < 1e-12);
            }
        }
    }
}
