//! What a registration answers.

use crate::assemble::Evaluation as Evaluated;
use crate::energy::Energies as Weighted;
use crate::report::{Report, Spread as Measured};
use crate::search::SearchProgress;
use crate::verdict::Unresolved;
use js_sys::Float64Array;
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// Weighted energies.
#[derive(Serialize, Tsify)]
pub struct Energies {
    membrane: f64,
    bending: f64,
    mismatch: f64,
    volume: f64,
    pins: f64,
    total: f64,
}

/// A distance along an outline, in cells of the current level.
#[derive(Serialize, Tsify)]
pub struct Spread {
    mean: f64,
    max: f64,
}

/// |Dφ t| along M1.
#[derive(Serialize, Tsify)]
pub struct Stretch {
    mean: f64,
    deviation: f64,
}

/// Where a registration stands.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Status {
    finished: bool,
    /// Why it ended, a sentence; null while it goes on.
    #[tsify(type = "string | null")]
    stop: Option<String>,
    /// What the search is trying at present, in words.
    approach: String,
    level: u32,
    /// Iterations on this level.
    iteration: usize,
    /// Evaluations of the energy on all levels.
    evaluations: usize,
    energies: Energies,
    /// The least determinant of Dφ over the corners of all cells; > 0 always.
    least_determinant: f64,
    /// |d2(φ)| along M1, the outline of the reference as it was given.
    mismatch: Spread,
    /// The distance of points of M2, the outline of the template as it was given, to φ(M1).
    cover: Spread,
    /// The length of φ(M1) over M2's: 1, more where it crumples, less where parts are missed.
    measure: f64,
    stretch: Stretch,
    /// What the match came to, in words; null while it goes on.
    #[tsify(type = "string | null")]
    verdict: Option<String>,
}

/// The narrowest neck or gap of two shapes where their finest grid does not resolve it.
#[derive(Serialize, Tsify)]
pub struct Inspection {
    /// A sentence; null where the grid resolves both shapes.
    #[tsify(type = "string | null")]
    words: Option<String>,
    /// The least `finest` that resolves them; null where none that is worth its time does.
    #[tsify(type = "number | null")]
    level: Option<u32>,
}

/// Energies and gradient at a deformation. Where it folds (leastDeterminant ≤ 0), energies are Infinity and the
/// gradient is NaN.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Evaluation {
    energies: Energies,
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float64Array")]
    gradient: Float64Array,
    least_determinant: f64,
}

impl From<&Evaluated> for Energies {
    fn from(evaluated: &Evaluated) -> Self {
        let infinite = f64::INFINITY;
        let Weighted { membrane, bending, mismatch, volume, pins } = if evaluated.is_admissible() {
            evaluated.energies
        } else {
            Weighted { membrane: infinite, bending: infinite, mismatch: infinite, volume: infinite, pins: infinite }
        };
        Self { membrane, bending, mismatch, volume, pins, total: evaluated.total() }
    }
}

impl From<&Measured<2>> for Spread {
    fn from(measured: &Measured<2>) -> Self {
        Self { mean: measured.mean, max: measured.max }
    }
}

impl Status {
    pub(super) fn new(progress: &SearchProgress, report: &Report<2>, verdict: Option<String>) -> Self {
        Self {
            finished: progress.stop.is_some(),
            stop: progress.stop.map(|stop| stop.to_string()),
            approach: progress.approach.to_string(),
            level: progress.level,
            iteration: progress.iteration,
            evaluations: progress.evaluations,
            energies: Energies::from(&progress.evaluation),
            least_determinant: progress.evaluation.least_determinant,
            mismatch: Spread::from(&report.mismatch),
            cover: Spread::from(&report.cover),
            measure: report.measure,
            stretch: Stretch { mean: report.stretch.mean, deviation: report.stretch.deviation },
            verdict,
        }
    }
}

impl Inspection {
    pub(super) fn new(unresolved: Option<Unresolved>) -> Self {
        Self { words: unresolved.map(|found| found.sentence()), level: unresolved.and_then(|found| found.level) }
    }
}

impl Evaluation {
    pub(super) fn new(evaluated: &Evaluated, mut gradient: Vec<f64>) -> Self {
        if !evaluated.is_admissible() {
            gradient.fill(f64::NAN);
        }
        Self {
            energies: Energies::from(evaluated),
            gradient: Float64Array::from(gradient.as_slice()),
            least_determinant: evaluated.least_determinant,
        }
    }
}
