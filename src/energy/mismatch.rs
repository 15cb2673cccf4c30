use super::{GRADIENT, HESSIAN, Point, Response, Term, position_slot};
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
        let direction = [(position_slot::<D>(), point.template.gradient)];
        let twice = weight + weight;
        if ORDER >= GRADIENT {
            response.add_gradient(twice * residual, &direction);
        }
        if ORDER >= HESSIAN {
            response.add_outer(twice, &direction);
        }
        residual * residual
    }
}
