use super::{GRADIENT, HESSIAN, Point, Response, Term};
use crate::small::Scalar;

/// Penalises the distance between the moved reference and the template.
///
/// W(y) = (d₂(y) − d₁)²,  ∂W/∂y = 2 (d₂ − d₁) ∇d₂,  hessian (Gauss–Newton) 2 ∇d₂ ⊗ ∇d₂.
/// Units: length².  Source: eq. (6).
pub struct Mismatch;

impl<const D: usize> Term<D> for Mismatch {
    #[inline(always)]
    fn add<S: Scalar, const ORDER: u8>(&self, weight: S, point: &Point<S, D>, response: &mut Response<S, D>) -> S {
        let residual = point.template.distance - point.reference.distance;
        let y = D - 1;
        if ORDER >= GRADIENT {
            let slope = (weight + weight) * residual;
            for a in 0..D {
                response.gradient[y][a] += slope * point.template.gradient[a];
            }
        }
        if ORDER >= HESSIAN {
            let twice = weight + weight;
            for a in 0..D {
                for b in 0..D {
                    response.hessian[y][y][a][b] += twice * point.template.gradient[a] * point.template.gradient[b];
                }
            }
        }
        residual * residual
    }
}
