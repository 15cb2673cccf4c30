//! The JavaScript interface: conversions only.

use crate::assemble::Evaluation as Evaluated;
use crate::cascade::Cascade;
use crate::contour::zero_set;
use crate::distance::SignedDistance;
use crate::energy::{BendingModel, Cutoff, Energies as Weighted, Material};
use crate::error::{Error, ShapeError};
use crate::field::interpolate;
use crate::ready::ready;
use crate::report::report;
use crate::settings::{Alignment, MinimizerKind, Settings as Chosen};
use crate::shape::Shape;
use glam::DVec2;
use js_sys::{Array, Float64Array, Object, Reflect, Uint8Array};
use serde::{Deserialize, Serialize};
use tsify::Tsify;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const SHAPE: &str = r#"
/** A closed curve or several, in domain units: the box is [0,1]², y up. */
export type Shape =
  /** Closed polygons, x y x y …, any orientation; a loop wholly inside another is a hole. */
  | { kind: "curves"; loops: Float64Array[] }
  /** Nodal values on (cells + 1)^dim nodes, x fastest, negative inside; cells is a power of two. */
  | { kind: "levelSet"; cells: number; dim: 2 | 3; values: Float64Array; redistance: boolean }
  /** A picture, row 0 on top, inside > 127; its longest side fills the box. */
  | { kind: "mask"; width: number; height: number; data: Uint8Array }
  /** A closed triangle mesh (3D; not supported yet). */
  | { kind: "mesh"; positions: Float64Array; indices: Uint32Array };

/** What to replace; the rest stays. */
export interface Update {
  reference?: Shape;
  template?: Shape;
  settings?: Partial<Settings>;
}

/** Closed polylines, x y x y …; `matched` is φ of `reference`, point by point. */
export interface Curves {
  reference: Float64Array[];
  template: Float64Array[];
  matched: Float64Array[];
}
"#;

/// Every field optional; lengths in domain units.
#[derive(Deserialize, Tsify)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct Settings {
    /// α_mem.
    membrane: f64,
    /// α_bend.
    bending: f64,
    #[tsify(type = "\"shape-operator\" | \"mean-curvature\"")]
    bending_model: Bending,
    /// δ on the coarsest level.
    thickness: f64,
    /// 1/ε on the coarsest level.
    penalty: f64,
    /// ξ.
    volume: f64,
    /// ζ, softness outside the reference.
    interior: f64,
    lambda: f64,
    mu: f64,
    /// σ; 0 is automatic.
    bandwidth: f64,
    #[tsify(type = "\"quartic\" | \"cosine\" | \"bump\"")]
    cutoff: Profile,
    /// r in cells.
    fit_radius: f64,
    /// θ.
    vertex_share: f64,
    /// First level l: (2^l + 1)^D nodes.
    coarsest: f64,
    /// Last level.
    finest: f64,
    /// Halve δ and ε from level to level.
    halving: bool,
    #[tsify(type = "\"none\" | \"similarity\"")]
    align: Align,
    #[tsify(type = "\"newton\" | \"ncg\"")]
    minimizer: Minimizer,
    /// β_max of the Sobolev metric ("ncg" only).
    sobolev: f64,
    /// Relative decrease of the energy at which a level ends.
    tolerance: f64,
    #[tsify(type = "\"cpu\" | \"auto\"")]
    backend: Backend,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Bending {
    ShapeOperator,
    MeanCurvature,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Profile {
    Quartic,
    Cosine,
    Bump,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Align {
    None,
    Similarity,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Minimizer {
    Newton,
    Ncg,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Backend {
    Cpu,
    Auto,
}

impl Default for Settings {
    fn default() -> Self {
        let chosen = Chosen::default();
        Self {
            membrane: chosen.membrane,
            bending: chosen.bending,
            bending_model: match chosen.bending_model {
                BendingModel::ShapeOperator => Bending::ShapeOperator,
                BendingModel::MeanCurvature => Bending::MeanCurvature,
            },
            thickness: chosen.thickness,
            penalty: chosen.penalty,
            volume: chosen.volume,
            interior: chosen.interior,
            lambda: chosen.material.lambda,
            mu: chosen.material.mu,
            bandwidth: chosen.bandwidth,
            cutoff: match chosen.cutoff {
                Cutoff::Quartic => Profile::Quartic,
                Cutoff::Cosine => Profile::Cosine,
                Cutoff::Bump => Profile::Bump,
            },
            fit_radius: chosen.fit_radius,
            vertex_share: chosen.vertex_share,
            coarsest: f64::from(chosen.coarsest),
            finest: f64::from(chosen.finest),
            halving: chosen.halving,
            align: match chosen.alignment {
                Alignment::None => Align::None,
                Alignment::Similarity => Align::Similarity,
            },
            minimizer: match chosen.minimizer {
                MinimizerKind::Newton => Minimizer::Newton,
                MinimizerKind::Ncg => Minimizer::Ncg,
            },
            sobolev: chosen.sobolev,
            tolerance: chosen.tolerance,
            backend: Backend::Auto,
        }
    }
}

impl Settings {
    fn chosen(self) -> Result<Chosen, Error> {
        // One CPU backend serves both names for now.
        let (Backend::Cpu | Backend::Auto) = self.backend;
        let settings = Chosen {
            membrane: self.membrane,
            bending: self.bending,
            bending_model: match self.bending_model {
                Bending::ShapeOperator => BendingModel::ShapeOperator,
                Bending::MeanCurvature => BendingModel::MeanCurvature,
            },
            thickness: self.thickness,
            penalty: self.penalty,
            volume: self.volume,
            interior: self.interior,
            material: Material { lambda: self.lambda, mu: self.mu },
            bandwidth: self.bandwidth,
            cutoff: match self.cutoff {
                Profile::Quartic => Cutoff::Quartic,
                Profile::Cosine => Cutoff::Cosine,
                Profile::Bump => Cutoff::Bump,
            },
            fit_radius: self.fit_radius,
            vertex_share: self.vertex_share,
            coarsest: level("coarsest", self.coarsest)?,
            finest: level("finest", self.finest)?,
            halving: self.halving,
            alignment: match self.align {
                Align::None => Alignment::None,
                Align::Similarity => Alignment::Similarity,
            },
            minimizer: match self.minimizer {
                Minimizer::Newton => MinimizerKind::Newton,
                Minimizer::Ncg => MinimizerKind::Ncg,
            },
            sobolev: self.sobolev,
            tolerance: self.tolerance,
        };
        settings.validate()?;
        Ok(settings)
    }
}

fn level(name: &'static str, value: f64) -> Result<u32, Error> {
    if (0.0..=30.0).contains(&value) && value.fract() == 0.0 {
        Ok(value as u32)
    } else {
        Err(Error::Setting { name, value: value.to_string(), range: "a whole number of halvings of the box".into() })
    }
}

/// Weighted energies.
#[derive(Serialize, Tsify)]
pub struct Energies {
    membrane: f64,
    bending: f64,
    mismatch: f64,
    volume: f64,
    total: f64,
}

/// |d2(φ)| along M1, in cells of the current level.
#[derive(Serialize, Tsify)]
pub struct Mismatch {
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
    level: u32,
    /// Iterations on this level.
    iteration: usize,
    /// Evaluations of the energy on all levels.
    evaluations: usize,
    energies: Energies,
    /// The least determinant of Dφ over the corners of all cells; > 0 always.
    least_determinant: f64,
    mismatch: Mismatch,
    stretch: Stretch,
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
        let Weighted { membrane, bending, mismatch, volume } = if evaluated.is_admissible() {
            evaluated.energies
        } else {
            Weighted { membrane: infinite, bending: infinite, mismatch: infinite, volume: infinite }
        };
        Self { membrane, bending, mismatch, volume, total: evaluated.total() }
    }
}

/// The registration of a reference shape with a template.
#[wasm_bindgen]
pub struct Registration {
    cascade: Cascade<2>,
    source: Source,
    /// The zero sets of reference and template, and the level they were extracted on.
    curves: [Vec<Vec<DVec2>>; 2],
    curves_level: u32,
}

/// What a registration was made of, so that a part of it can be replaced.
#[derive(Clone)]
struct Source {
    reference: Shape,
    template: Shape,
    /// The settings as given.
    settings: Object,
}

#[wasm_bindgen]
impl Registration {
    /// Prepares a registration; rejects with an Error that says what is wrong and what to do.
    pub async fn create(
        #[wasm_bindgen(unchecked_param_type = "Shape")] reference: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Shape")] template: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "Partial<Settings>")] settings: JsValue,
    ) -> Result<Registration, JsError> {
        let source = Source {
            reference: read_shape("reference", &reference)?,
            template: read_shape("template", &template)?,
            settings: merged(&Object::new(), settings)?,
        };
        let (settings, [reference, template]) = source.prepare()?;
        let cascade = Cascade::new(reference, template, settings).await?;
        let mut registration = Self { cascade, source, curves: Default::default(), curves_level: 0 };
        registration.extract_curves();
        Ok(registration)
    }

    /// Goes on from the present deformation with other shapes or settings; what is not given stays. Continues on the
    /// current level, or the nearest one of the new settings, so that a small change costs a few iterations only.
    /// Rejects like `create`, and then nothing has changed.
    #[wasm_bindgen(unchecked_return_type = "Status")]
    pub async fn update(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Update")] change: JsValue,
    ) -> Result<JsValue, JsError> {
        let mut source = self.source.clone();
        for (name, shape) in [("reference", &mut source.reference), ("template", &mut source.template)] {
            let given = property("update", &change, name)?;
            if !given.is_undefined() {
                *shape = read_shape(name, &given)?;
            }
        }
        source.settings = merged(&source.settings, property("update", &change, "settings")?)?;
        let (settings, [reference, template]) = source.prepare()?;
        self.cascade.update(reference, template, settings).await?;
        self.source = source;
        self.extract_curves();
        self.status()
    }

    /// Does up to `iterations` iterations; nothing once finished.
    #[wasm_bindgen(unchecked_return_type = "Status")]
    pub async fn step(&mut self, iterations: u32) -> Result<JsValue, JsError> {
        for _ in 0..iterations {
            if self.cascade.progress().stop.is_some() {
                break;
            }
            self.cascade.step().await;
        }
        self.status()
    }

    /// φ at the nodes of the current level: x y x y …, x fastest, domain units.
    pub fn deformation(&self) -> Vec<f64> {
        let grid = self.cascade.grid();
        let positions = (0..grid.node_count()).flat_map(|node| grid.position(node));
        positions.zip(self.cascade.displacement()).map(|(x, u)| x + u).collect()
    }

    /// Energies and gradient of the current level at a deformation of the same form as `deformation()`.
    #[wasm_bindgen(unchecked_return_type = "Evaluation")]
    pub fn evaluate(&mut self, deformation: Vec<f64>) -> Result<JsValue, JsError> {
        let grid = self.cascade.grid();
        check_array("deformation", &deformation, 2 * grid.node_count(), || {
            format!("x and y at the {} nodes of level {}", grid.node_count(), self.cascade.progress().level)
        })?;
        let positions = (0..grid.node_count()).flat_map(|node| grid.position(node));
        let displacement: Vec<f64> = deformation.iter().zip(positions).map(|(y, x)| y - x).collect();
        let mut gradient = vec![0.0; displacement.len()];
        let evaluated = ready(self.cascade.evaluate(&displacement, &mut gradient));
        if !evaluated.is_admissible() {
            gradient.fill(f64::NAN);
        }
        to_js(&Evaluation {
            energies: Energies::from(&evaluated),
            gradient: Float64Array::from(gradient.as_slice()),
            least_determinant: evaluated.least_determinant,
        })
    }

    /// The zero sets on the current level, and φ of the reference's.
    #[wasm_bindgen(unchecked_return_type = "Curves")]
    pub fn curves(&mut self) -> JsValue {
        self.update_curves();
        let [reference, template] = &self.curves;
        let matched: Vec<Vec<DVec2>> =
            reference.iter().map(|polyline| polyline.iter().map(|&point| self.move_point(point)).collect()).collect();
        let curves = Object::new();
        for (name, polylines) in [("reference", reference), ("template", template), ("matched", &matched)] {
            let arrays: Array = polylines
                .iter()
                .map(|polyline| {
                    let flat: Vec<f64> = polyline.iter().flat_map(|point| point.to_array()).collect();
                    JsValue::from(Float64Array::from(flat.as_slice()))
                })
                .collect();
            // Setting a property of a fresh plain object cannot fail.
            let _ = Reflect::set(&curves, &name.into(), &arrays);
        }
        curves.into()
    }

    /// φ at points x y x y …, domain units; beyond the box the boundary cell's polynomial goes on.
    pub fn map(&self, points: Vec<f64>) -> Result<Vec<f64>, JsError> {
        check_array("points", &points, points.len().next_multiple_of(2), || "x and y of every point".into())?;
        Ok(points.chunks_exact(2).flat_map(|p| self.move_point(DVec2::new(p[0], p[1])).to_array()).collect())
    }
}

impl Registration {
    fn move_point(&self, point: DVec2) -> DVec2 {
        point + DVec2::from(interpolate::<2, 2>(self.cascade.grid(), self.cascade.displacement(), &point.to_array()))
    }

    fn update_curves(&mut self) {
        if self.curves_level != self.cascade.progress().level {
            self.extract_curves();
        }
    }

    fn extract_curves(&mut self) {
        self.curves_level = self.cascade.progress().level;
        self.curves =
            [self.cascade.reference(), self.cascade.template()].map(|shape| zero_set(shape.grid(), shape.values()));
    }

    fn status(&mut self) -> Result<JsValue, JsError> {
        self.update_curves();
        let progress = self.cascade.progress();
        let quality =
            report(self.cascade.grid(), &self.curves[0], self.cascade.template().values(), self.cascade.displacement());
        to_js(&Status {
            finished: progress.stop.is_some(),
            stop: progress.stop.map(|stop| stop.to_string()),
            level: progress.level,
            iteration: progress.iteration,
            evaluations: progress.evaluations,
            energies: Energies::from(&progress.evaluation),
            least_determinant: progress.evaluation.least_determinant,
            mismatch: Mismatch { mean: quality.mismatch_mean, max: quality.mismatch_max },
            stretch: Stretch { mean: quality.stretch_mean, deviation: quality.stretch_deviation },
        })
    }
}

/// Reports panics to the console with their message and place.
#[wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
}

fn to_js(value: &impl Serialize) -> Result<JsValue, JsError> {
    let serializer = serde_wasm_bindgen::Serializer::new().serialize_missing_as_null(true);
    value.serialize(&serializer).map_err(|error| JsError::new(&error.to_string()))
}

impl Source {
    fn prepare(&self) -> Result<(Chosen, [SignedDistance<2>; 2]), JsError> {
        let settings = read_settings(&self.settings)?.chosen()?;
        let distance = |name, shape: &Shape| {
            shape.distance(settings.finest).map_err(|problem| Error::Shape { shape: name, problem })
        };
        Ok((settings, [distance("reference", &self.reference)?, distance("template", &self.template)?]))
    }
}

/// The fields of both; where both have one, the change's.
fn merged(settings: &Object, change: JsValue) -> Result<Object, JsError> {
    let fresh = Object::assign(&Object::new(), settings);
    if change.is_undefined() || change.is_null() {
        return Ok(fresh);
    }
    let Ok(change) = change.dyn_into::<Object>() else {
        return Err(JsError::new("the settings must be an object, every field optional"));
    };
    let fresh = Object::assign(&fresh, &change);
    for key in Object::keys(&fresh).iter() {
        // A field set to undefined is one left out.
        if Reflect::get(&fresh, &key).is_ok_and(|value| value.is_undefined()) {
            let _ = Reflect::delete_property(&fresh, &key);
        }
    }
    Ok(fresh)
}

fn read_settings(settings: &Object) -> Result<Settings, JsError> {
    let deserializer = serde_wasm_bindgen::Deserializer::from(JsValue::from(settings));
    serde_path_to_error::deserialize(deserializer).map_err(|error| {
        let name = error.path().to_string();
        let problem = error.into_inner();
        JsError::new(&if name == "." { format!("settings: {problem}") } else { format!("{name}: {problem}") })
    })
}

fn check_array(name: &'static str, values: &[f64], expected: usize, why: impl FnOnce() -> String) -> Result<(), Error> {
    if values.len() != expected {
        return Err(Error::Length { name, found: values.len(), expected, why: why() });
    }
    match values.iter().position(|x| !x.is_finite()) {
        Some(position) => Err(Error::NotFinite { name, position }),
        None => Ok(()),
    }
}

fn read_shape(name: &'static str, shape: &JsValue) -> Result<Shape, JsError> {
    let unsupported =
        |problem: String| Err(Error::Shape { shape: name, problem: ShapeError::Unsupported(problem) }.into());
    match text(name, shape, "kind")?.as_str() {
        "curves" => Ok(Shape::Curves(read_loops(name, &property(name, shape, "loops")?)?)),
        "mask" => {
            let data: Uint8Array = typed(name, shape, "data", "a Uint8Array")?;
            let (width, height) = (count(name, shape, "width")?, count(name, shape, "height")?);
            Ok(Shape::Mask { width, height, data: data.to_vec() })
        }
        "levelSet" => {
            let values: Float64Array = typed(name, shape, "values", "a Float64Array")?;
            let (cells, dim) = (count(name, shape, "cells")?, count(name, shape, "dim")?);
            let Some(redistance) = property(name, shape, "redistance")?.as_bool() else {
                return Err(wrong(name, "redistance", "true or false"));
            };
            if dim != 2 {
                return unsupported(format!("has dimension {dim}; only 2D shapes can be registered so far"));
            }
            Ok(Shape::LevelSet { cells, values: values.to_vec(), redistance })
        }
        "mesh" => unsupported("is a mesh; only 2D shapes can be registered so far".into()),
        other => {
            unsupported(format!("has the unknown kind \"{other}\"; use \"curves\", \"levelSet\", \"mask\" or \"mesh\""))
        }
    }
}

fn read_loops(name: &'static str, loops: &JsValue) -> Result<Vec<Vec<DVec2>>, JsError> {
    if !Array::is_array(loops) {
        return Err(wrong(name, "loops", "an array of Float64Arrays"));
    }
    let mut result = Vec::new();
    for item in Array::from(loops).iter() {
        let Ok(array) = item.dyn_into::<Float64Array>() else {
            return Err(wrong(name, "loops", "an array of Float64Arrays"));
        };
        let numbers = array.to_vec();
        if numbers.len() % 2 == 1 {
            return Err(wrong(name, "loops", "made of an even count of numbers, x and y of every point"));
        }
        result.push(numbers.chunks_exact(2).map(|p| DVec2::new(p[0], p[1])).collect());
    }
    Ok(result)
}

fn wrong(shape: &str, field: &str, needed: &str) -> JsError {
    JsError::new(&format!("the {shape}'s {field} must be {needed}"))
}

fn property(shape: &str, object: &JsValue, field: &str) -> Result<JsValue, JsError> {
    Reflect::get(object, &field.into())
        .map_err(|_| JsError::new(&format!("the {shape} must be an object of type Shape")))
}

fn text(shape: &str, object: &JsValue, field: &str) -> Result<String, JsError> {
    property(shape, object, field)?.as_string().ok_or_else(|| wrong(shape, field, "a string"))
}

fn count(shape: &str, object: &JsValue, field: &str) -> Result<usize, JsError> {
    match property(shape, object, field)?.as_f64() {
        Some(value) if (0.0..=1e9).contains(&value) && value.fract() == 0.0 => Ok(value as usize),
        _ => Err(wrong(shape, field, "a whole number from 0 up")),
    }
}

fn typed<T: JsCast>(shape: &str, object: &JsValue, field: &str, needed: &str) -> Result<T, JsError> {
    property(shape, object, field)?.dyn_into().map_err(|_| wrong(shape, field, needed))
}
