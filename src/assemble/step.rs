//! A step of Newton's method, as a minimiser asks for it.

use super::Evaluation;

/// The linear system is solved to this relative residual: a more exact direction of an inexact model does not pay.
pub const FORCING: f64 = 0.1;
pub const MOST_LINEAR_STEPS: usize = 40;
/// Halvings of a step before the direction is given up for a shorter, more cautious one.
pub const MOST_HALVINGS: usize = 6;
/// Sufficient decrease, as a share of the slope.
const ARMIJO: f64 = 1e-4;
/// A step leaves at least this share of the least determinant: next to a fold the quadratic model is worthless, and
/// a weak volume energy would not keep the iterates away from there.
const DETERMINANT_KEPT: f64 = 0.2;

/// What has changed since the last step was tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Renewal {
    /// The displacement; the hessian of one before still serves.
    Gradient,
    /// The displacement, and the hessian is to be that of the new one.
    Hessian,
    /// The shift alone.
    Shift,
}

/// What is asked for: to solve (H + s·I) d = ∇E, and to go against d as far as the energy falls.
#[derive(Clone, Copy, Debug)]
pub struct Ask {
    pub renewal: Renewal,
    /// s in units of the mean diagonal entry of H.
    pub shift: f32,
}

/// What has come of it.
#[derive(Clone, Copy, Debug)]
pub struct Attempt {
    pub before: Evaluation,
    /// The length of the step and the state after it; None, and nothing has moved, if no step was good enough.
    pub taken: Option<(f64, Evaluation)>,
    pub evaluations: usize,
}

/// Whether a step of this length along a direction of that slope is good enough.
pub fn is_enough(before: &Evaluation, after: &Evaluation, length: f64, slope: f64) -> bool {
    after.total() <= before.total() + ARMIJO * length * slope
        && after.least_determinant >= DETERMINANT_KEPT * before.least_determinant
}
