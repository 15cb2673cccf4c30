//! What a registration answers.

use super::settings::put;
use crate::assemble::Evaluation;
use crate::energy::Energies;
use crate::report::{Report, Spread};
use crate::search::SearchProgress;
use crate::verdict::{FACTS, NARROW, NO_FACT, Verdict};
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
  /**
   * The least determinant of Dφ: of curves over the corners of all cells, which is exact; of surfaces the least coefficient in
   * Bernstein's basis, a lower bound. > 0 always.
   */
  leastDeterminant: number;
  /** |d2(φ)| along M1, both outlines as they were given. */
  mismatch: Spread;
  /** The distance of points of M2, the outline of the template as it was given, to φ(M1). */
  cover: Spread;
  /** The length (area) of φ(M1) over M2's: 1, more where it crumples, less where parts are missed. */
  measure: number;
  stretch: Stretch;
  /** What computed the last step: "cpu", "gpu: " and the card's name, or "cpu: " and why it is not the card. */
  backend: string;
  /** What the match came to, in words; null while it goes on. */
  verdict: string | null;
  /**
   * What these words are made of besides the numbers above, for those who say them in another language: why it ended
   * (-1 while it goes on), what is tried, and of the verdict what www/words/facts.ts tells.
   */
  facts: Float64Array;
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

/** |Dφ t| along M1; of surfaces the ratio of areas. */
export interface Stretch {
  mean: number;
  deviation: number;
}

/** The narrowest neck or gap of two curves, or the thinnest part of two surfaces, where the finest grid does not resolve it. */
export interface Inspection {
  /** A sentence; null where the grid resolves both shapes. */
  words: string | null;
  /** The least `finest` that resolves them; null where none that is worth its time does. */
  level: number | null;
  /** What the words are made of; -1 where there are none, or none but these. */
  facts: Float64Array;
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

pub(super) fn status<const D: usize>(
    progress: &SearchProgress,
    report: &Report<D>,
    verdict: Option<Verdict>,
    backend: String,
) -> JsValue {
    let mut facts = [NO_FACT; 2 + FACTS];
    facts[0] = progress.stop.map_or(NO_FACT, |stop| f64::from(stop as u8));
    facts[1] = progress.approach.fact();
    if let Some(Verdict { facts: own, .. }) = &verdict {
        facts[2..].copy_from_slice(own);
    }
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
        ("backend", backend.into()),
        ("verdict", or_null(verdict.map(|verdict| verdict.words))),
        ("facts", list(&facts)),
    ])
}

/// What is not resolved, in a sentence, the level that resolves it, and what the sentence is made of.
pub(super) fn inspection(words: Option<String>, level: Option<u32>, facts: [f64; NARROW]) -> JsValue {
    object(&[("words", or_null(words)), ("level", or_null(level)), ("facts", list(&facts))])
}

pub(super) fn evaluation(evaluated: &Evaluation, mut gradient: Vec<f64>) -> JsValue {
    if !evaluated.is_admissible() {
        gradient.fill(f64::NAN);
    }
    object(&[
        ("energies", energies(evaluated)),
        ("gradient", list(&gradient)),
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

fn spread<const D: usize>(measured: &Spread<D>) -> JsValue {
    object(&[("mean", measured.mean.into()), ("max", measured.max.into())])
}

pub(super) fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (name, value) in fields {
        put(&object, name, value);
    }
    object.into()
}

fn list(numbers: &[f64]) -> JsValue {
    Float64Array::from(numbers).into()
}

fn number(count: usize) -> JsValue {
    (count as f64).into()
}

fn or_null(value: Option<impl Into<JsValue>>) -> JsValue {
    value.map_or(JsValue::NULL, Into::into)
}
