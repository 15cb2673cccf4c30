//! Positive semi-definite second derivatives of the isotropic law for D = 3, by singular values.
//!
//! For Ψ(σ) = μ/2 Σσ_i² + k(J), J = Πσ_i, F = Σ σ_i u_i ⊗ v_i, the second derivative has the modes
//!
//! | mode | direction | eigenvalue |
//! |---|---|---|
//! | twist | (u_i v_j − u_j v_i)/√2 | (Ψ_i + Ψ_j)/(σ_i + σ_j) |
//! | flip | (u_i v_j + u_j v_i)/√2 | (Ψ_i − Ψ_j)/(σ_i − σ_j) |
//! | scaling | span of u_i v_i | the matrix Ψ_ij |
//! | normal (surfaces only) | u_3 v_i | Ψ_i/σ_i |
//!
//! whose quotients are polynomial in J, so that equal singular values do no harm.
//! Source: Smith, de Goes, Kim, "Analytic Eigensystems for Isotropic Distortion Energies", ACM TOG 38(1), 2019.

use super::Material;
use crate::small::{Matrix, Scalar, Vector, dot};

type Slots<const D: usize> = [Vector<f64, D>; D];
type Blocks<const D: usize> = [[[[f64; D]; D]; D]; D];

/// Evaluates a scalar hessian lane by lane.
pub(super) fn by_lane<S: Scalar, const D: usize>(
    slots: &[Vector<S, D>; D],
    hessian: impl Fn(&Slots<D>) -> Blocks<D>,
) -> [[Matrix<S, D>; D]; D] {
    let mut lanes = [[[[[0.0; D]; D]; D]; D]; 4];
    for (lane, blocks) in lanes.iter_mut().enumerate().take(S::LANES) {
        *blocks = hessian(&slots.map(|v| v.map(|x| x.lane(lane))));
    }
    std::array::from_fn(|p| {
        std::array::from_fn(|q| {
            std::array::from_fn(|a| std::array::from_fn(|b| S::gather(|lane| lanes[lane][p][q][a][b])))
        })
    })
}

/// k′ and k″ of k(J) = g(J²).
fn dilation_of_j(material: &Material, j: f64) -> (f64, f64) {
    let (_, slope, bend) = material.dilation(j * j);
    (2.0 * j * slope, 2.0 * slope + 4.0 * j * j * bend)
}

/// The projected hessian of the volume density at F (by slots), D = 3.
pub(super) fn volume_hessian<const D: usize>(material: &Material, f: &Slots<D>) -> Blocks<D> {
    let mut gram = [[0.0; 3]; 3];
    for a in 0..3 {
        for b in 0..3 {
            gram[a][b] = (0..3).map(|k| f[k][a] * f[k][b]).sum();
        }
    }
    let (squares, right) = eigen(gram);
    let sigma = squares.map(|s| s.max(0.0).sqrt());
    // f by slots is a matrix by rows: f = Σ σ_i left_i ⊗ right_i.
    let left: [[f64; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|k| (0..3).map(|a| f[k][a] * right[i][a]).sum::<f64>() / sigma[i]));
    let j = sigma[0] * sigma[1] * sigma[2];
    let (first, second) = dilation_of_j(material, j);
    let mut scaling = [[0.0; 3]; 3];
    for i in 0..3 {
        for k in 0..3 {
            let own = if i == k { material.mu } else { first * sigma[3 - i - k] };
            scaling[i][k] = own + second * (j / sigma[i]) * (j / sigma[k]);
        }
    }
    let mut blocks = [[[[0.0; D]; D]; D]; D];
    add_scaling(&mut blocks, scaling, &left, &right);
    for i in 0..3 {
        for k in i + 1..3 {
            let rest = first * sigma[3 - i - k];
            add_pair(&mut blocks, material.mu + rest, material.mu - rest, [&left[i], &left[k]], [&right[i], &right[k]]);
        }
    }
    blocks
}

/// The projected hessian of the membrane density at the two tangential slots, D = 3.
pub(super) fn membrane_hessian<const D: usize>(material: &Material, slots: &Slots<D>) -> Blocks<D> {
    let v = [&slots[0], &slots[1]];
    let mut gram = [[0.0; 3]; 3];
    for i in 0..2 {
        for k in 0..2 {
            gram[i][k] = dot(v[i], v[k]);
        }
    }
    let (squares, frame) = eigen(gram);
    // The third row and column are empty: its eigenvalue 0 is left out by its eigenvector, the third axis.
    let kept: Vec<usize> = (0..3).filter(|&i| frame[i][2].abs() < 0.5).collect();
    let sigma: [f64; 2] = std::array::from_fn(|i| squares[kept[i]].max(0.0).sqrt());
    let left: [[f64; 3]; 2] = std::array::from_fn(|i| frame[kept[i]]);
    let right: [[f64; 3]; 2] =
        std::array::from_fn(|i| std::array::from_fn(|a| (left[i][0] * v[0][a] + left[i][1] * v[1][a]) / sigma[i]));
    let normal: [f64; 3] = std::array::from_fn(|a| {
        let (b, c) = ((a + 1) % 3, (a + 2) % 3);
        right[0][b] * right[1][c] - right[0][c] * right[1][b]
    });
    let j = sigma[0] * sigma[1];
    let (first, second) = dilation_of_j(material, j);
    let mut scaling = [[0.0; 3]; 3];
    for i in 0..2 {
        scaling[i][i] = material.mu + second * sigma[1 - i] * sigma[1 - i];
        scaling[i][1 - i] = first + second * j;
    }
    let mut blocks = [[[[0.0; D]; D]; D]; D];
    add_scaling(&mut blocks, scaling, &left, &right);
    add_pair(&mut blocks, material.mu + first, material.mu - first, [&left[0], &left[1]], [&right[0], &right[1]]);
    for i in 0..2 {
        let out = material.mu + first * sigma[1 - i] / sigma[i];
        add_mode(&mut blocks, out, &[(1.0, &left[i], &normal)]);
    }
    blocks
}

/// Adds eigenvalue⁺ · M ⊗ M for the mode M = Σ factor · left ⊗ right.
fn add_mode<const D: usize>(blocks: &mut Blocks<D>, eigenvalue: f64, mode: &[(f64, &[f64; 3], &[f64; 3])]) {
    if eigenvalue <= 0.0 {
        return;
    }
    let mut m = [[0.0; 3]; 3];
    for (factor, left, right) in mode {
        for p in 0..3 {
            for a in 0..3 {
                m[p][a] += factor * left[p] * right[a];
            }
        }
    }
    for p in 0..D {
        for q in p..D {
            for a in 0..D {
                for b in 0..D {
                    blocks[p][q][a][b] += eigenvalue * m[p][a] * m[q][b];
                }
            }
        }
    }
}

fn add_pair<const D: usize>(
    blocks: &mut Blocks<D>,
    twist: f64,
    flip: f64,
    left: [&[f64; 3]; 2],
    right: [&[f64; 3]; 2],
) {
    let root = std::f64::consts::FRAC_1_SQRT_2;
    add_mode(blocks, twist, &[(root, left[0], right[1]), (-root, left[1], right[0])]);
    add_mode(blocks, flip, &[(root, left[0], right[1]), (root, left[1], right[0])]);
}

fn add_scaling<const D: usize>(blocks: &mut Blocks<D>, scaling: [[f64; 3]; 3], left: &[[f64; 3]], right: &[[f64; 3]]) {
    let (values, vectors) = eigen(scaling);
    for (value, vector) in values.iter().zip(&vectors) {
        let mode: Vec<_> = (0..left.len()).map(|i| (vector[i], &left[i], &right[i])).collect();
        add_mode(blocks, *value, &mode);
    }
}

/// Eigenvalues and eigenvectors (`vectors[i]` is the i-th) of a symmetric matrix by cyclic Jacobi rotations.
fn eigen(mut m: [[f64; 3]; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
    let mut vectors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // Convergence is quadratic: six sweeps are beyond rounding for any 3×3 matrix.
    for _ in 0..6 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if m[p][q] == 0.0 {
                continue;
            }
            let ratio = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            let t = ratio.signum() / (ratio.abs() + (1.0 + ratio * ratio).sqrt());
            let c = 1.0 / (1.0 + t * t).sqrt();
            let s = t * c;
            for k in 0..3 {
                let (x, y) = (m[k][p], m[k][q]);
                (m[k][p], m[k][q]) = (c * x - s * y, s * x + c * y);
            }
            for k in 0..3 {
                let (x, y) = (m[p][k], m[q][k]);
                (m[p][k], m[q][k]) = (c * x - s * y, s * x + c * y);
            }
            for k in 0..3 {
                let (x, y) = (vectors[p][k], vectors[q][k]);
                (vectors[p][k], vectors[q][k]) = (c * x - s * y, s * x + c * y);
            }
        }
    }
    ([m[0][0], m[1][1], m[2][2]], vectors)
}
