//! The JavaScript interface: conversions only.

mod memory;
mod queue;
mod read;
mod settings;
mod shape;
mod status;

use crate::contour::zero_set;
use crate::distance::SignedDistance;
use crate::error::Error;
use crate::field::interpolate;
use crate::inverse::Inverse;
use crate::ready::ready;
use crate::report::Outlines;
use crate::search::Search;
use crate::settings::{Pin, Settings};
use crate::shape::Shape;
use crate::verdict::Pair;
use glam::DVec2;
use js_sys::{Array, Float64Array, Object, Promise, Reflect};
use queue::{Queue, promise};
use read::{numbers, property, snapshot, whole, wrong};
use settings::Chosen;
use shape::read_shape;
use status::{evaluation, inspection, status};
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
    queue: Queue<State>,
}

/// What is worked on, by one at a time.
struct State {
    search: Search<2>,
    source: Source,
    /// The zero sets of reference and template, and the level they were extracted on.
    curves: [Vec<Vec<DVec2>>; 2],
    curves_level: u32,
    /// What matches are measured by on that level.
    outlines: Outlines<2>,
    /// What the verdict needs to know of the shapes; looked at when there is something to judge.
    pair: Option<Pair>,
}

/// What a registration was made of, so that a part of it can be replaced.
#[derive(Clone)]
struct Source {
    reference: Shape,
    template: Shape,
    chosen: Chosen,
}

/// A change as it was read.
struct Change {
    reference: Option<Shape>,
    template: Option<Shape>,
    settings: JsValue,
}

#[wasm_bindgen]
impl Registration {
    /// Prepares a registration; rejects with an Error that says what is wrong and what to do.
    #[wasm_bindgen(unchecked_return_type = "Promise<Registration>")]
    pub fn create(
        #[wasm_bindgen(unchecked_param_type = "Shape")] reference: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Shape")] template: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "Partial<Settings>")] settings: JsValue,
    ) -> Promise {
        // Read at once: the caller may change or transfer what was given as soon as this returns.
        let source = Source::read(&reference, &template, &settings);
        promise(async move {
            let state = State::new(source?).await?;
            Ok(Self { queue: Queue::new(state) }.into())
        })
    }

    /// Goes on from the present deformation with other shapes or settings; what is not given stays. Continues on the
    /// current level, or the nearest one of the new settings, so that a small change costs a few iterations only.
    /// Rejects like `create`, and then nothing has changed. Waits for steps and updates under way.
    #[wasm_bindgen(unchecked_return_type = "Promise<Status>")]
    pub fn update(&self, #[wasm_bindgen(unchecked_param_type = "Update")] change: JsValue) -> Promise {
        let change = Change::read(&change);
        self.queue.enqueue(async move |state: &mut State| state.update(change?).await)
    }

    /// Does up to `iterations` iterations, a whole number from 1 up; nothing once finished. Waits for steps and updates
    /// under way.
    #[wasm_bindgen(unchecked_return_type = "Promise<Status>")]
    pub fn step(&self, #[wasm_bindgen(unchecked_param_type = "number")] iterations: JsValue) -> Promise {
        let needed = "a whole number from 1 up, as in step(5)";
        let iterations = whole(&iterations, 1.0).ok_or_else(|| wrong("the number of steps", &iterations, needed));
        self.queue.enqueue(async move |state: &mut State| state.step(iterations?).await)
    }

    /// The settings in force, defaults filled in.
    #[wasm_bindgen(unchecked_return_type = "Settings")]
    pub fn settings(&self) -> Result<JsValue, JsError> {
        self.queue.now(|state| Ok(state.source.chosen.to_js()))
    }

    /// φ at the nodes of the current level: x y x y …, x fastest, domain units.
    pub fn deformation(&self) -> Result<Vec<f64>, JsError> {
        self.queue.now(|state| {
            let grid = state.search.grid();
            let positions = (0..grid.node_count()).flat_map(|node| grid.position(node));
            Ok(positions.zip(state.search.displacement()).map(|(x, u)| x + u).collect())
        })
    }

    /// Energies and gradient of the current level at a deformation of the same form as `deformation()`.
    #[wasm_bindgen(unchecked_return_type = "Evaluation")]
    pub fn evaluate(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Float64Array")] deformation: JsValue,
    ) -> Result<JsValue, JsError> {
        let deformation = numbers("the deformation", &deformation)?;
        self.queue.now(|state| state.evaluate(&deformation))
    }

    /// The zero sets on the current level, and φ of the reference's.
    #[wasm_bindgen(unchecked_return_type = "Curves")]
    pub fn curves(&self) -> Result<JsValue, JsError> {
        self.queue.now(|state| Ok(state.curves()))
    }

    /// φ at points x y x y …, domain units; beyond the box the boundary cell's polynomial goes on.
    pub fn map(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Float64Array")] points: JsValue,
    ) -> Result<Vec<f64>, JsError> {
        let points = read_points(&points)?;
        self.queue.now(|state| Ok(points.into_iter().flat_map(|point| state.move_point(point).to_array()).collect()))
    }

    /// φ⁻¹ at points x y x y … of the image of the box; NaN outside of it.
    #[wasm_bindgen(js_name = inverseMap)]
    pub fn inverse_map(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Float64Array")] points: JsValue,
    ) -> Result<Vec<f64>, JsError> {
        let points = read_points(&points)?;
        self.queue.now(|state| {
            let inverse = Inverse::new(state.search.grid(), state.search.displacement());
            let outside = [f64::NAN; 2];
            Ok(points.into_iter().flat_map(|point| inverse.at(&point.to_array()).unwrap_or(outside)).collect())
        })
    }

    /// Lets go of the memory. Steps under way still answer; whatever is asked afterwards is refused.
    pub fn free(&self) {
        self.queue.close();
    }
}

impl State {
    async fn new(source: Source) -> Result<Self, JsError> {
        let (settings, pins, [reference, template]) = source.prepare()?;
        let search = Search::with_pins(reference, template, settings, &pins).await?;
        let outlines = Outlines::new(search.reference(), search.template());
        let mut state = Self { search, source, curves: Default::default(), curves_level: 0, outlines, pair: None };
        state.extract_curves();
        Ok(state)
    }

    async fn update(&mut self, change: Change) -> Result<JsValue, JsError> {
        let mut source = self.source.clone();
        source.reference = change.reference.unwrap_or(source.reference);
        source.template = change.template.unwrap_or(source.template);
        source.chosen = source.chosen.with(&change.settings)?;
        let (settings, pins, [reference, template]) = source.prepare()?;
        self.search.update(reference, template, settings, &pins).await?;
        self.source = source;
        self.pair = None;
        self.extract_curves();
        Ok(self.status())
    }

    async fn step(&mut self, iterations: usize) -> Result<JsValue, JsError> {
        for _ in 0..iterations {
            if self.search.progress().stop.is_some() {
                break;
            }
            self.search.step().await;
        }
        Ok(self.status())
    }

    fn evaluate(&mut self, deformation: &[f64]) -> Result<JsValue, JsError> {
        let grid = self.search.grid();
        check_array("deformation", deformation, 2 * grid.node_count(), || {
            format!("x and y at the {} nodes of level {}", grid.node_count(), self.search.progress().level)
        })?;
        let positions = (0..grid.node_count()).flat_map(|node| grid.position(node));
        let displacement: Vec<f64> = deformation.iter().zip(positions).map(|(y, x)| y - x).collect();
        let mut gradient = vec![0.0; displacement.len()];
        let evaluated = ready(self.search.evaluate(&displacement, &mut gradient));
        Ok(evaluation(&evaluated, gradient))
    }

    fn curves(&mut self) -> JsValue {
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
        let shapes = [self.search.reference(), self.search.template()];
        self.outlines = Outlines::new(shapes[0], shapes[1]);
        self.curves = shapes.map(|shape| zero_set(shape.grid(), shape.values()));
    }

    fn status(&mut self) -> JsValue {
        self.update_curves();
        let report = self.outlines.report(self.search.displacement());
        let progress = self.search.progress();
        let verdict = progress.stop.map(|_| {
            let [reference, template] = self.search.shapes();
            self.pair.get_or_insert_with(|| Pair::new(reference, template)).verdict(progress.level, &report)
        });
        status(&progress, &report, verdict)
    }
}

/// Whether the finest grid of the settings resolves two shapes, before they are matched; refuses like `create`.
#[wasm_bindgen(unchecked_return_type = "Inspection")]
pub fn inspect(
    #[wasm_bindgen(unchecked_param_type = "Shape")] reference: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Shape")] template: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "Partial<Settings>")] settings: JsValue,
) -> Result<JsValue, JsError> {
    let source = Source::read(&reference, &template, &settings)?;
    let (settings, _, [reference, template]) = source.prepare()?;
    Ok(inspection(Pair::new(&reference, &template).unresolved(settings.finest)))
}

/// Reports panics to the console with their message and place.
#[wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
}

type Prepared = (Settings, Vec<Pin<2>>, [SignedDistance<2>; 2]);

impl Source {
    fn read(reference: &JsValue, template: &JsValue, settings: &JsValue) -> Result<Self, JsError> {
        Ok(Self {
            reference: read_shape("reference", reference)?,
            template: read_shape("template", template)?,
            chosen: Chosen::default().with(settings)?,
        })
    }

    fn prepare(&self) -> Result<Prepared, JsError> {
        let settings = self.chosen.settings;
        memory::check(&settings)?;
        let pins = Pin::read(&self.chosen.pins)?;
        let distance = |name, shape: &Shape| {
            shape.distance(settings.finest).map_err(|problem| Error::Shape { shape: name, problem })
        };
        Ok((settings, pins, [distance("reference", &self.reference)?, distance("template", &self.template)?]))
    }
}

impl Change {
    fn read(change: &JsValue) -> Result<Self, JsError> {
        let shape = |name| -> Result<Option<Shape>, JsError> {
            let given = property("the change", change, name)?;
            if given.is_undefined() { Ok(None) } else { read_shape(name, &given).map(Some) }
        };
        let (reference, template) = (shape("reference")?, shape("template")?);
        let settings = snapshot("settings", &property("the change", change, "settings")?)?;
        Ok(Self { reference, template, settings })
    }
}

fn read_points(points: &JsValue) -> Result<Vec<DVec2>, JsError> {
    let numbers = numbers("points", points)?;
    check_array("points", &numbers, numbers.len().next_multiple_of(2), || "x and y of every point".into())?;
    Ok(numbers.chunks_exact(2).map(|p| DVec2::new(p[0], p[1])).collect())
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
