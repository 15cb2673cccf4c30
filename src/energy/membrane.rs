use super::spectral::{by_lane, membrane_hessian};
use super::{GRADIENT, HESSIAN, Material, Point, Response, Term};
use crate::small::{Scalar, dot};

/// Penalises stretching and squeezing within the shell.
///
/// W = μ/2 tr G + g(det G), G_ij = v_i·v_j (Cauchy–Green strain in the tangent frame), v_i = Dφ t_i,
/// ∂W/∂v_i = μ v_i + 2 g′(det G) Σ_j cof(G)_ij v_j.
///
/// Curvature, D = 2, with s = |v|²: the eigenvalue along v is μ + 2g′ + 4s g″, always positive; the one across is
/// μ + 2g′, negative under compression and clipped at 0 (a compressed bar buckles).  D = 3: see `spectral`.
/// Units: none.  Source: eq. (2).
pub struct Membrane(pub Material);

impl<const D: usize> Term<D> for Membrane {
    #[inline(always)]
    fn add<S: Scalar, const ORDER: u8>(&self, weight: S, point: &Point<S, D>, response: &mut Response<S, D>) -> S {
        let (material, v) = (&self.0, &point.slots);
        let mut gram = [[S::zero(); 2]; 2];
        let mut trace = S::zero();
        for i in 0..D - 1 {
            for j in 0..D - 1 {
                gram[i][j] = dot(&v[i], &v[j]);
            }
            trace += gram[i][i];
        }
        let one = S::splat(1.0);
        let (det, cof) = if D == 2 {
            (gram[0][0], [[one, S::zero()], [S::zero(), one]])
        } else {
            let cof = [[gram[1][1], -gram[1][0]], [-gram[0][1], gram[0][0]]];
            (gram[0][0] * gram[1][1] - gram[0][1] * gram[1][0], cof)
        };
        let mu = S::splat(material.mu);
        let (g, slope, bend) = material.dilation(det);
        if ORDER >= GRADIENT {
            let twice = slope + slope;
            for i in 0..D - 1 {
                for a in 0..D {
                    let mut sum = mu * v[i][a];
                    for j in 0..D - 1 {
                        sum += twice * cof[i][j] * v[j][a];
                    }
                    response.gradient[i][a] += weight * sum;
                }
            }
        }
        if ORDER >= HESSIAN {
            if D == 2 {
                let across = (mu + slope + slope).max(S::zero());
                let along = mu + slope + slope + S::splat(4.0) * det * bend;
                let difference = weight * (along - across) / det;
                for a in 0..D {
                    response.hessian[0][0][a][a] += weight * across;
                    for b in 0..D {
                        response.hessian[0][0][a][b] += difference * v[0][a] * v[0][b];
                    }
                }
            } else {
                by_lane(weight, v, response, |v| membrane_hessian(material, v));
            }
        }
        S::splat(0.5) * mu * trace + g
    }
}
