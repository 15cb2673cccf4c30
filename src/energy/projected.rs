use super::membrane::{Strain, projected_hessian};
use super::{GRADIENT, HESSIAN, Material, Point, Response, Term, position_slot};
use crate::small::{Scalar, Vector, dot};

/// κ: the share of a tangent vector's square across the template that its compression still counts.
const SHARE_ACROSS: f64 = 0.02;

/// The membrane energy with the compression measured along the template.
///
/// Under [`Membrane`](super::Membrane) a shell that is to become shorter escapes: it leaves the template in waves and is
/// long again. Here the part of v_i = Dφ t_i across the template, p_i = g·v_i with g = ∇d₂(φ), does not count as length
/// where length is wanted:
///
/// W = μ/2 tr G + a det G + b / det G̃,  G_ij = v_i·v_j,  G̃_ij = w_i·w_j,  w_i = v_i − c p_i g,
/// a = (λ−2μ)/8, b = (λ+2μ)/8, c = 2(1−√κ)/(1+γ²), γ = |g|².
///
/// Where γ = 1, |w|² = |v|² − (1−κ) p²; c γ ≤ 1−√κ for every γ, so that det G̃ > 0 wherever det G > 0, also where the
/// fitted g is longer or shorter than a unit vector. Equals [`Membrane`](super::Membrane) where p = 0, as at an exact match.
///
/// Hessian: det G = det G̃ + q pᵀ cof(G̃) p with q = 2c − c²γ, hence
/// W = W_mem(G̃) + q pᵀ (μ/2 1 + a cof G̃) p, a membrane energy of w and a residual p. The first is projected as that of
/// [`Membrane`](super::Membrane) and taken from w to v, the second is Gauss–Newton with ∇p_i = (g, ∂_k g·v_i);
/// λ ≥ 2μ makes it positive.
/// Units: none.  Source: the authors' later remedy, derivatives projected onto both tangent spaces (Iglesias, Rumpf,
/// Scherzer, "Shape-aware matching of implicit surfaces based on thin shell energies", FoCM 2018).
pub struct ProjectedMembrane(pub Material);

impl<const D: usize> Term<D> for ProjectedMembrane {
    #[inline(always)]
    fn add<S: Scalar, const ORDER: u8>(&self, weight: S, point: &Point<S, D>, response: &mut Response<S, D>) -> S {
        let (material, g, g_slope) = (&self.0, &point.template.normal, &point.template.normal_slope);
        let y = position_slot::<D>();
        let v: [Vector<S, D>; D] = std::array::from_fn(|i| point.slots[i]);
        let (one, two) = (S::splat(1.0), S::splat(2.0));

        let gamma = dot(g, g);
        let rest = one / (one + gamma * gamma);
        let c = S::splat(2.0 * (1.0 - SHARE_ACROSS.sqrt())) * rest;
        let p: [S; D] = std::array::from_fn(|i| dot(g, &v[i]));
        let along: [Vector<S, D>; D] = std::array::from_fn(|i| std::array::from_fn(|k| v[i][k] - c * p[i] * g[k]));
        let (plain, projected) = (Strain::of(&v), Strain::of(&along));

        let mu = S::splat(material.mu);
        let a = S::splat((material.lambda - 2.0 * material.mu) / 8.0);
        let b = S::splat((material.lambda + 2.0 * material.mu) / 8.0);
        let inverse = one / projected.det;
        if ORDER >= GRADIENT {
            let (stretching, squeezing) = (plain.forces(&v), projected.forces(&along));
            let slope = -(b * inverse * inverse);
            // c depends on g through γ = |g|².
            let c_slope = -(two * gamma * rest) * c;
            let mut by_g = [S::zero(); D];
            for i in 0..D - 1 {
                let force = &squeezing[i];
                let across = dot(force, g);
                for k in 0..D {
                    response.gradient[i][k] +=
                        weight * (mu * v[i][k] + a * stretching[i][k] + slope * (force[k] - c * across * g[k]));
                    by_g[k] += two * c_slope * p[i] * across * g[k] + c * (across * v[i][k] + p[i] * force[k]);
                }
            }
            for k in 0..D {
                response.gradient[y][k] -= weight * slope * dot(&by_g, &g_slope[k]);
            }
        }
        if ORDER >= HESSIAN {
            let blocks = projected_hessian(material, &along, &projected);
            let q = weight * (two * c - c * c * gamma);
            let by_position: [Vector<S, D>; D] =
                std::array::from_fn(|i| std::array::from_fn(|k| dot(&g_slope[k], &v[i])));
            for i in 0..D - 1 {
                for j in 0..D - 1 {
                    let own = if i == j { mu } else { S::zero() };
                    let stiffness = q * (own + two * a * projected.cof[i][j]);
                    for k in 0..D {
                        for l in 0..D {
                            if i <= j {
                                response.hessian[i][j][k][l] += stiffness * g[k] * g[l];
                            }
                            response.hessian[i][y][k][l] += stiffness * g[k] * by_position[j][l];
                            response.hessian[y][y][k][l] += stiffness * by_position[i][k] * by_position[j][l];
                        }
                    }
                    if i > j {
                        continue;
                    }
                    // From w to v: (1 − c g ⊗ g) B (1 − c g ⊗ g).
                    let block = &blocks[i][j];
                    let right: Vector<S, D> = std::array::from_fn(|k| dot(&block[k], g));
                    let left: Vector<S, D> = std::array::from_fn(|l| {
                        let mut sum = g[0] * block[0][l];
                        for k in 1..D {
                            sum += g[k] * block[k][l];
                        }
                        sum
                    });
                    let both = c * dot(g, &right);
                    for k in 0..D {
                        for l in 0..D {
                            response.hessian[i][j][k][l] +=
                                weight * (block[k][l] - c * (g[k] * (left[l] - both * g[l]) + right[k] * g[l]));
                        }
                    }
                }
            }
        }
        S::splat(0.5) * mu * plain.trace + a * plain.det + b * inverse
    }
}
