//! The JavaScript interface: conversions only.

mod read;
mod settings;
mod shape;
mod status;

use crate::contour::zero_set;
use crate::distance::SignedDistance;
use crate::error::Error;
use crate::field::interpolate;
use crate::ready::ready;
use crate::report::report;
use crate::search::Search;
use crate::settings::{Pin, Settings};
use crate::shape::Shape;
use glam::DVec2;
use js_sys::{Array, Float64Array, Object, Reflect};
use read::property;
use serde::Serialize;
use settings::Chosen;
use shape::read_shape;
use status::{Evaluation, Status};
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

/// The registration of a reference shape with a template.
#[wasm_bindgen]
pub struct Registration {
    search: Search<2>,
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
    chosen: Chosen,
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
            chosen: Chosen::default().with(&settings)?,
        };
        let (settings, [reference, template]) = source.prepare()?;
        let search = Search::new(reference, template, settings).await?;
        let mut registration = Self { search, source, curves: Default::default(), curves_level: 0 };
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
            let given = property("the change", &change, name)?;
            if !given.is_undefined() {
                *shape = read_shape(name, &given)?;
            }
        }
        source.chosen = source.chosen.with(&property("the change", &change, "settings")?)?;
        let (settings, [reference, template]) = source.prepare()?;
        self.search.update(reference, template, settings).await?;
        self.source = source;
        self.extract_curves();
        self.status()
    }

    /// Does up to `iterations` iterations; nothing once finished.
    #[wasm_bindgen(unchecked_return_type = "Status")]
    pub async fn step(&mut self, iterations: u32) -> Result<JsValue, JsError> {
        for _ in 0..iterations {
            if self.search.progress().stop.is_some() {
                break;
            }
            self.search.step().await;
        }
        self.status()
    }

    /// The settings in force, defaults filled in.
    #[wasm_bindgen(unchecked_return_type = "Settings")]
    pub fn settings(&self) -> JsValue {
        self.source.chosen.to_js()
    }

    /// φ at the nodes of the current level: x y x y …, x fastest, domain units.
    pub fn deformation(&self) -> Vec<f64> {
        let grid = self.search.grid();
        let positions = (0..grid.node_count()).flat_map(|node| grid.position(node));
        positions.zip(self.search.displacement()).map(|(x, u)| x + u).collect()
    }

    /// Energies and gradient of the current level at a deformation of the same form as `deformation()`.
    #[wasm_bindgen(unchecked_return_type = "Evaluation")]
    pub fn evaluate(&mut self, deformation: Vec<f64>) -> Result<JsValue, JsError> {
        let grid = self.search.grid();
        check_array("deformation", &deformation, 2 * grid.node_count(), || {
            format!("x and y at the {} nodes of level {}", grid.node_count(), self.search.progress().level)
        })?;
        let positions = (0..grid.node_count()).flat_map(|node| grid.position(node));
        let displacement: Vec<f64> = deformation.iter().zip(positions).map(|(y, x)| y - x).collect();
        let mut gradient = vec![0.0; displacement.len()];
        let evaluated = ready(self.search.evaluate(&displacement, &mut gradient));
        to_js(&Evaluation::new(&evaluated, gradient))
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
        point + DVec2::from(interpolate::<2, 2>(self.search.grid(), self.search.displacement(), &point.to_array()))
    }

    fn update_curves(&mut self) {
        if self.curves_level != self.search.progress().level {
            self.extract_curves();
        }
    }

    fn extract_curves(&mut self) {
        self.curves_level = self.search.progress().level;
        self.curves =
            [self.search.reference(), self.search.template()].map(|shape| zero_set(shape.grid(), shape.values()));
    }

    fn status(&self) -> Result<JsValue, JsError> {
        let progress = self.search.progress();
        let quality = report(self.search.reference(), self.search.template(), self.search.displacement());
        to_js(&Status::new(&progress, &quality))
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
    fn prepare(&self) -> Result<(Settings, [SignedDistance<2>; 2]), JsError> {
        let settings = self.chosen.settings;
        // The functional does not know them yet.
        Pin::<2>::read(&self.chosen.pins)?;
        let distance = |name, shape: &Shape| {
            shape.distance(settings.finest).map_err(|problem| Error::Shape { shape: name, problem })
        };
        Ok((settings, [distance("reference", &self.reference)?, distance("template", &self.template)?]))
    }
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
