/// Two points that are tied together: φ(`reference`) is drawn to `template`. Domain units.
///
/// W = |φ(p) − q|², ∂W/∂φ(p) = 2 (φ(p) − q), hessian 2·1.  Units: length²; a pin of weight 1 pulls like a patch of the
/// band as large as the square of its half width does for its mismatch, so E_pins = w σ²/ε Σ_k |φ(p_k) − q_k|².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin<const D: usize> {
    pub reference: [f64; D],
    pub template: [f64; D],
}

impl<const D: usize> Pin<D> {
    /// For φ⁻¹.
    pub fn reversed(self) -> Self {
        Self { reference: self.template, template: self.reference }
    }
}
