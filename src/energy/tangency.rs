use super::{GRADIENT, HESSIAN, Point, Response, Term, normal_slot, position_slot};
use crate::small::{Scalar, Vector, dot};

/// Penalises the derivative of the mismatch d₂∘φ − d₁: what a wave finer than a cell costs, though it stays near the
/// template.
///
/// W = Σ_i r_i² + r_n²,  r_i = g(y)·Dφ t_i (zero where the moved shell is tangential to the template),
/// r_n = g(y)·Dφ n − |∇d₁| (zero where it runs straight through; Z-folds with reversed tangents are seen by it alone),
/// g the fitted ∇d₂, whose interpolant is differentiated exactly, and |∇d₁| fitted likewise, so that a shape costs nothing
/// against itself:
/// ∂r/∂(Dφ t_i) = g, ∂r_i/∂y_k = ∂_k g·Dφ t_i, hessian (Gauss–Newton) 2 Σ ∇r ⊗ ∇r.
/// Units: none.  With the weight ρ²/ε it makes the mismatch an H¹ norm in the length ρ.
pub struct Tangency;

impl<const D: usize> Term<D> for Tangency {
    #[inline(always)]
    fn add<S: Scalar, const ORDER: u8>(&self, weight: S, point: &Point<S, D>, response: &mut Response<S, D>) -> S {
        let template = &point.template;
        let mut value = S::zero();
        for i in 0..D {
            let column = &point.slots[i];
            let mut residual = dot(&template.normal, column);
            if i == normal_slot::<D>() {
                residual -= point.reference.steepness;
            }
            value += residual * residual;
            if ORDER >= GRADIENT {
                let by_position: Vector<S, D> = std::array::from_fn(|k| dot(&template.normal_slope[k], column));
                let direction = [(i, template.normal), (position_slot::<D>(), by_position)];
                let twice = weight + weight;
                response.add_gradient(twice * residual, &direction);
                if ORDER >= HESSIAN {
                    response.add_outer(twice, &direction);
                }
            }
        }
        value
    }
}
