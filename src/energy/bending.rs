use super::{GRADIENT, HESSIAN, Point, Response, Term, position_slot};
use crate::small::{Scalar, apply, dot};

/// Penalises the change of the shape operator under the deformation.
///
/// W = |S_rel|², S_rel = D_tgφᵀ D²d₂(φ) D_tgφ − D²d₁.  With v_i = Dφ t_i and κ_ij = t_iᵀ D²d₁ t_j,
///
/// W = Σ_ij r_ij² + const,  r_ij = v_iᵀ D²d₂(y) v_j − κ_ij,
/// ∂W/∂v_i = 4 Σ_j r_ij D²d₂ v_j,  ∂W/∂y_k = 2 Σ_ij r_ij v_iᵀ ∂_k D²d₂ v_j,
/// hessian (Gauss–Newton) 2 Σ_ij ∇r_ij ⊗ ∇r_ij.
/// The constant is the part of |D²d₁|² off the tangent space: the fitted D²d₁ is not exactly tangential.
/// Units: length⁻².  Source: eq. (3).
pub struct Bending;

impl<const D: usize> Term<D> for Bending {
    #[inline(always)]
    fn add<S: Scalar, const ORDER: u8>(&self, weight: S, point: &Point<S, D>, response: &mut Response<S, D>) -> S {
        let (v, tangents, y) = (&point.slots, D - 1, position_slot::<D>());
        let template = &point.template;
        let mut bent = [[S::zero(); D]; D];
        for j in 0..tangents {
            bent[j] = apply(&template.curvature, &v[j]);
        }
        let mut value = point.reference.off_tangential;
        for i in 0..tangents {
            for j in i..tangents {
                let residual = dot(&v[i], &bent[j]) - point.reference.curvature[i][j];
                // r_ij and r_ji are one number and count twice.
                let count = S::splat(if i == j { 1.0 } else { 2.0 });
                value += count * residual * residual;
                if ORDER < GRADIENT {
                    continue;
                }
                let mut moved = [S::zero(); D];
                for (k, slope) in template.curvature_slope.iter().enumerate() {
                    moved[k] = dot(&v[i], &apply(slope, &v[j]));
                }
                let twice = (weight + weight) * count;
                let slope = twice * residual;
                if i == j {
                    let direction = [(i, bent[i].map(|x| x + x)), (y, moved)];
                    response.add_gradient(slope, &direction);
                    if ORDER >= HESSIAN {
                        response.add_outer(twice, &direction);
                    }
                } else {
                    let direction = [(i, bent[j]), (j, bent[i]), (y, moved)];
                    response.add_gradient(slope, &direction);
                    if ORDER >= HESSIAN {
                        response.add_outer(twice, &direction);
                    }
                }
            }
        }
        value
    }
}

/// Penalises the change of the mean curvature alone, the simpler alternative to [`Bending`].
///
/// W(y) = (tr D²d₂(y) − tr D²d₁)²,  ∂W/∂y_k = 2 r tr ∂_k D²d₂,  hessian (Gauss–Newton) 2 ∇r ⊗ ∇r.
/// Units: length⁻².  Source: eq. (10).
pub struct MeanCurvature;

impl<const D: usize> Term<D> for MeanCurvature {
    #[inline(always)]
    fn add<S: Scalar, const ORDER: u8>(&self, weight: S, point: &Point<S, D>, response: &mut Response<S, D>) -> S {
        let trace = |m: &[[S; D]; D]| {
            let mut sum = m[0][0];
            for k in 1..D {
                sum += m[k][k];
            }
            sum
        };
        let residual = trace(&point.template.curvature) - point.reference.trace;
        if ORDER >= GRADIENT {
            let direction =
                [(position_slot::<D>(), std::array::from_fn(|k| trace(&point.template.curvature_slope[k])))];
            let twice = weight + weight;
            response.add_gradient(twice * residual, &direction);
            if ORDER >= HESSIAN {
                response.add_outer(twice, &direction);
            }
        }
        residual * residual
    }
}
