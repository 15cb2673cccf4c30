//! The energy densities, one a file, and their weighted sum.
//!
//! A term sees one quadrature point and knows no grid. Its unknowns there are D + 1 vectors of length D, the *slots*:
//!
//! | terms | slots 0 … D−2 | slot D−1 ([`normal_slot`]) | slot D ([`position_slot`]) |
//! |---|---|---|---|
//! | of the shell | Dφ t_1, …, Dφ t_{D−1} (t: orthonormal tangents of the reference) | Dφ n | φ |
//! | volume | ∂φ/∂x_1, …, ∂φ/∂x_{D−1} | ∂φ/∂x_D | – |
//!
//! One function gives value, derivative and a positive semi-definite hessian, so they cannot drift apart.

mod bending;
mod membrane;
mod mismatch;
mod pin;
mod projected;
mod tangency;
mod volume;

pub use bending::{Bending, MeanCurvature};
pub use membrane::Membrane;
pub use mismatch::Mismatch;
pub use pin::Pin;
pub use projected::ProjectedMembrane;
pub use tangency::Tangency;
pub use volume::Volume;
pub(crate) use volume::shortened;

use crate::small::{Matrix, Scalar, Vector};

/// What the reference contributes at a quadrature point, in its tangent frame.
#[derive(Clone, Copy)]
pub struct ReferenceJet<S, const D: usize> {
    /// d1, the signed distance.
    pub distance: S,
    /// t_iᵀ D²d1 t_j; the first D−1 rows and columns count.
    pub curvature: Matrix<S, D>,
    /// |D²d1|² less the tangential part's: what of eq. (3) no deformation can change.
    pub off_tangential: S,
    /// tr D²d1.
    pub trace: S,
    /// |∇d1|, fitted: about 1, less near the skeleton.
    pub steepness: S,
}

/// The template at the moved point y = φ(x).
#[derive(Clone, Copy)]
pub struct TemplateJet<S, const D: usize> {
    /// d2(y) and its derivative.
    pub distance: S,
    pub gradient: Vector<S, D>,
    /// The fitted ∇d2(y), smoother than `gradient`, and its derivatives: `normal_slope[axis]`.
    pub normal: Vector<S, D>,
    pub normal_slope: [Vector<S, D>; D],
    /// D²d2(y) and its derivatives: `curvature_slope[axis]`.
    pub curvature: Matrix<S, D>,
    pub curvature_slope: [Matrix<S, D>; D],
}

/// Upper bound of D + 1.
pub const MAX_SLOTS: usize = 4;

/// One vector a slot; the first D + 1 count.
pub type Slots<S, const D: usize> = [Vector<S, D>; MAX_SLOTS];

/// The slot of Dφ n.
pub const fn normal_slot<const D: usize>() -> usize {
    D - 1
}

/// The slot of φ.
pub const fn position_slot<const D: usize>() -> usize {
    D
}

/// A quadrature point: the slots and both shapes' jets.
#[derive(Clone, Copy)]
pub struct Point<S, const D: usize> {
    pub slots: Slots<S, D>,
    pub reference: ReferenceJet<S, D>,
    pub template: TemplateJet<S, D>,
}

impl<S: Scalar, const D: usize> Point<S, D> {
    /// A point for a term that looks at Dφ alone, given by its columns.
    #[inline(always)]
    pub fn of_derivative(columns: [Vector<S, D>; D]) -> Self {
        let zero = S::zero();
        let matrix = [[zero; D]; D];
        let mut slots = [[zero; D]; MAX_SLOTS];
        slots[..D].copy_from_slice(&columns);
        Self {
            slots,
            reference: ReferenceJet {
                distance: zero,
                curvature: matrix,
                off_tangential: zero,
                trace: zero,
                steepness: zero,
            },
            template: TemplateJet {
                distance: zero,
                gradient: [zero; D],
                normal: [zero; D],
                normal_slope: [[zero; D]; D],
                curvature: matrix,
                curvature_slope: [matrix; D],
            },
        }
    }
}

/// Derivatives by the slots, summed over terms.
#[derive(Clone, Copy)]
pub struct Response<S, const D: usize> {
    /// `gradient[slot][component]`.
    pub gradient: Slots<S, D>,
    /// `hessian[p][q][a][b]`: slot p, component a against slot q, component b; filled for p ≤ q.
    pub hessian: [[Matrix<S, D>; MAX_SLOTS]; MAX_SLOTS],
}

impl<S: Scalar, const D: usize> Response<S, D> {
    #[inline(always)]
    pub fn zero() -> Self {
        let zero = S::zero();
        Self { gradient: [[zero; D]; MAX_SLOTS], hessian: [[[[zero; D]; D]; MAX_SLOTS]; MAX_SLOTS] }
    }

    /// gradient += weight · direction, the direction given in some of the slots.
    #[inline(always)]
    pub fn add_gradient<const N: usize>(&mut self, weight: S, direction: &[(usize, Vector<S, D>); N]) {
        for (slot, part) in direction {
            for a in 0..D {
                self.gradient[*slot][a] += weight * part[a];
            }
        }
    }

    /// hessian += weight · direction ⊗ direction, the direction given in some of the slots, in their order.
    #[inline(always)]
    pub fn add_outer<const N: usize>(&mut self, weight: S, direction: &[(usize, Vector<S, D>); N]) {
        for p in 0..N {
            let (first, part) = &direction[p];
            for a in 0..D {
                let scaled = weight * part[a];
                for (second, other) in &direction[p..] {
                    for b in 0..D {
                        self.hessian[*first][*second][a][b] += scaled * other[b];
                    }
                }
            }
        }
    }
}

/// Orders of differentiation that [`Term::add`] can be asked for.
pub const VALUE: u8 = 0;
pub const GRADIENT: u8 = 1;
pub const HESSIAN: u8 = 2;

/// An energy density.
pub trait Term<const D: usize> {
    /// Returns the density; adds `weight` times its derivatives up to `ORDER` to the response.
    ///
    /// The hessian is a positive semi-definite approximation of the second derivative.
    fn add<S: Scalar, const ORDER: u8>(&self, weight: S, point: &Point<S, D>, response: &mut Response<S, D>) -> S;
}

/// The isotropic law that membrane and volume share, on the tangent space and on the whole space.
///
/// W(A) = μ/2 tr A + g(det A), g(x) = (λ−2μ)/8 x + (λ+2μ)/8 / x.  Least at A = I; infinite at det A = 0.
/// λ ≥ 2μ is needed: below, the term in det A is negative, and since det A outgrows tr A, energies have no lower bound
/// (a volume enlarged beyond all bounds would be best). `Settings::validate` refuses it.
/// Source: eqs. (2) and (8). λ and μ are the Lamé coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    pub lambda: f64,
    pub mu: f64,
}

impl Material {
    /// g, g′ and g″ at x = det A.
    #[inline(always)]
    pub(crate) fn dilation<S: Scalar>(&self, x: S) -> (S, S, S) {
        let linear = S::splat((self.lambda - 2.0 * self.mu) / 8.0);
        let inverse = S::splat((self.lambda + 2.0 * self.mu) / 8.0);
        let q = S::splat(1.0) / x;
        let (first, second) = (inverse * q, inverse * q * q);
        (linear * x + first, linear - second, (second + second) * q)
    }
}

/// Which membrane energy is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MembraneModel {
    /// Eq. (2): of the Cauchy–Green strain within the moved shell, wherever it lies.
    Intrinsic,
    /// Its compression measured along the template, so that leaving the template relieves none.
    Projected,
}

/// Which bending energy is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BendingModel {
    /// Eq. (3): the relative shape operator.
    ShapeOperator,
    /// Eq. (10): the mean curvature alone.
    MeanCurvature,
}

/// The weight η of the distance to the reference, in units of the band's half width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cutoff {
    /// (1 − s²)².
    Quartic,
    /// (1 + cos πs)/2.
    Cosine,
    /// exp(1 − 1/(1−s²)).
    Bump,
}

impl Cutoff {
    /// η(s), zero for |s| ≥ 1.
    pub fn weight(self, s: f64) -> f64 {
        if s.abs() >= 1.0 {
            return 0.0;
        }
        let rest = 1.0 - s * s;
        match self {
            Cutoff::Quartic => rest * rest,
            Cutoff::Cosine => 0.5 * (1.0 + cosine_of_half_turns(s)),
            Cutoff::Bump => (1.0 - 1.0 / rest).exp(),
        }
    }
}

/// cos πs for |s| ≤ 1: by its series at a quarter of the angle, which is then doubled twice.
fn cosine_of_half_turns(s: f64) -> f64 {
    let square = (std::f64::consts::FRAC_PI_4 * s).powi(2);
    let series = (1..=9).rev().fold(1.0, |rest, k| 1.0 - square * rest / f64::from(2 * k * (2 * k - 1)));
    (0..2).fold(series, |cos, _| 2.0 * cos * cos - 1.0)
}

/// The functional E of a level: every weight, and the sum.
///
/// E = α_mem δ ∫η W_mem + α_bend δ³ ∫η |S_rel|² + 1/ε ∫η [(d2∘φ − d1)² + ρ² W_tan] + ξ ∫ (ζ + (1−ζ) χ_{d1<0}) W_vol
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Functional {
    /// α_mem.
    pub membrane: f64,
    pub membrane_model: MembraneModel,
    /// α_bend.
    pub bending: f64,
    pub bending_model: BendingModel,
    /// δ, domain units.
    pub thickness: f64,
    /// 1/ε.
    pub penalty: f64,
    /// ρ, the length of the H¹ residual, domain units; 0 leaves it out.
    pub tangency: f64,
    /// ξ.
    pub volume: f64,
    /// ζ, the softness outside the reference; 1 treats inside and outside alike.
    pub softness: f64,
    pub material: Material,
    /// σ, the half width of the band, domain units.
    pub bandwidth: f64,
    /// η.
    pub cutoff: Cutoff,
    /// r, the radius of the local quadratic fit, cells.
    pub fit_radius: f64,
    /// θ, the share of the volume energy integrated at the corners of the cells.
    pub vertex_share: f64,
    /// Gauss points an axis of a cell, 2 or 3; in the plane 3.
    pub gauss_points: usize,
}

/// Energies, each with its weight; the mismatch with its H¹ part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    pub membrane: f64,
    pub bending: f64,
    pub mismatch: f64,
    pub volume: f64,
    pub pins: f64,
}

impl Energies {
    pub fn total(&self) -> f64 {
        self.membrane + self.bending + self.mismatch + self.volume + self.pins
    }
}

impl Functional {
    /// Weighted shell densities at a point (membrane, bending, mismatch); adds weighted derivatives.
    #[inline(always)]
    pub fn shell<S: Scalar, const D: usize, const ORDER: u8>(
        &self,
        weight: S,
        point: &Point<S, D>,
        response: &mut Response<S, D>,
    ) -> [S; 3] {
        let membrane = weight * S::splat(self.membrane * self.thickness);
        let membrane_value = match self.membrane_model {
            MembraneModel::Intrinsic => Membrane(self.material).add::<S, ORDER>(membrane, point, response),
            MembraneModel::Projected => ProjectedMembrane(self.material).add::<S, ORDER>(membrane, point, response),
        };
        let (bending, bending_value) = match self.bending_model {
            BendingModel::ShapeOperator => {
                let bending = weight * S::splat(self.bending * self.thickness.powi(3));
                (bending, Bending.add::<S, ORDER>(bending, point, response))
            }
            BendingModel::MeanCurvature => {
                let bending = weight * S::splat(self.bending);
                (bending, MeanCurvature.add::<S, ORDER>(bending, point, response))
            }
        };
        let penalty = weight * S::splat(self.penalty);
        let mut mismatch = penalty * Mismatch.add::<S, ORDER>(penalty, point, response);
        if self.tangency > 0.0 {
            let tangency = penalty * S::splat(self.tangency * self.tangency);
            mismatch += tangency * Tangency.add::<S, ORDER>(tangency, point, response);
        }
        [membrane * membrane_value, bending * bending_value, mismatch]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cosine_of_half_turns_is_a_cosine() {
        for k in -100..=100 {
            let s = f64::from(k) / 100.0;
            assert!((cosine_of_half_turns(s) - (std::f64::consts::PI * s).cos()).abs() < 1e-14, "{s}");
        }
    }
}
