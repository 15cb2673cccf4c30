//! What a registration answers.

use super::settings::put;
use crate::assemble::Evaluation;
use crate::energy::Energies;
use crate::report::{Report, Spread};
use crate::search::SearchProgress;
use crate::verdict::Unresolved;
use js_sys::{Float64Array, Object};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const STATUS: &str = r#"
/** Where a registration stands. */
export interface Status {
  finished: boolean;
  /** Why it ended, a sentence; null while it goes on. */
  stop: string | null;
  /** What the search is trying at present, in words. */
  approach: string;
  level: number;
  /** Iterations on this level. */
  iteration: number;
  /** Evaluations of the energy on all levels. */
  evaluations: number;
  energies: Energies;
  /** The least determinant of Dφ over the corners of all cells; > 0 always. */
  leastDeterminant: number;
  /** |d2(φ)| along M1, both outlines as they were given. */
  mismatch: Spread;
  /** The distance of points of M2, the outline of the template as it was given, to φ(M1). */
  cover: Spread;
  /** The length of φ(M1) over M2's: 1, more where it crumples, less where parts are missed. */
  measure: number;
  stretch: Stretch;
  /** What the match came to, in words; null while it goes on. */
  verdict: string | null;
}

/** Weighted energies. */
export interface Energies {
  membrane: number;
  bending: number;
  mismatch: number;
  volume: number;
  pins: number;
  total: number;
}

/** A distance along an outline, in cells of the current level. */
export interface Spread {
  mean: number;
  max: number;
}

/** |Dφ t| along M1. */
export interface Stretch {
  mean: number;
  deviation: number;
}

/** The narrowest neck or gap of two shapes where their finest grid does not resolve it. */
export interface Inspection {
  /** A sentence; null where the grid resolves both shapes. */
  words: string | null;
  /** The least `finest` that resolves them; null where none that is worth its time does. */
  level: number | null;
}

/**
 * Energies and gradient at a deformation. Where it folds (leastDeterminant ≤ 0), energies are Infinity and the
 * gradient is NaN.
 */
export interface Evaluation {
  energies: Energies;
  gradient: Float64Array;
  leastDeterminant: number;
}
"#;

pub(super) fn status(progress: &SearchProgress, report: &Report<2>, verdict: Option<String>) -> JsValue {
    object(&[
        ("finished", progress.stop.is_some().into()),
        ("stop", or_null(progress.stop.map(|stop| stop.to_string()))),
        ("approach", progress.approach.to_string().into()),
        ("level", progress.level.into()),
        ("iteration", number(progress.iteration)),
        ("evaluations", number(progress.evaluations)),
        ("energies", energies(&progress.evaluation)),
        ("leastDeterminant", progress.evaluation.least_determinant.into()),
        ("mismatch", spread(&report.mismatch)),
        ("cover", spread(&report.cover)),
        ("measure", report.measure.into()),
        ("stretch", object(&[("mean", report.stretch.mean.into()), ("deviation", report.stretch.deviation.into())])),
        ("verdict", or_null(verdict)),
    ])
}

pub(super) fn inspection(unresolved: Option<Unresolved>) -> JsValue {
    object(&[
        ("words", or_null(unresolved.map(|found| found.sentence()))),
        ("level", or_null(unresolved.and_then(|found| found.level))),
    ])
}

pub(super) fn evaluation(evaluated: &Evaluation, mut gradient: Vec<f64>) -> JsValue {
    if !evaluated.is_admissible() {
        gradient.fill(f64::NAN);
    }
    object(&[
        ("energies", energies(evaluated)),
        ("gradient", Float64Array::from(gradient.as_slice()).into()),
        ("leastDeterminant", evaluated.least_determinant.into()),
    ])
}

fn energies(evaluated: &Evaluation) -> JsValue {
    let Energies { membrane, bending, mismatch, volume, pins } = evaluated.energies;
    let fields = [
        ("membrane", membrane),
        ("bending", bending),
        ("mismatch", mismatch),
        ("volume", volume),
        ("pins", pins),
        ("total", evaluated.total()),
    ];
    let defined = |value: f64| if evaluated.is_admissible() { value } else { f64::INFINITY };
    object(&fields.map(|(name, value)| (name, defined(value).into())))
}

fn spread(measured: &Spread<2>) -> JsValue {
    object(&[("mean", measured.mean.into()), ("max", measured.max.into())])
}

fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (name, value) in fields {
        put(&object, name, value);
    }
    object.into()
}

fn number(count: usize) -> JsValue {
    (count as f64).into()
}

fn or_null(value: Option<impl Into<JsValue>>) -> JsValue {
    value.map_or(JsValue::NULL, Into::into)
}
