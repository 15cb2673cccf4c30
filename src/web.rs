//! The JavaScript interface: conversions only.

mod memory;
mod plane;
mod queue;
mod read;
mod settings;
mod shape;
#[cfg(feature = "surfaces")]
mod space;
mod state;
mod status;

#[cfg(feature = "surfaces")]
use crate::verdict::{NARROW, NO_FACT, SolidPair};
use crate::verdict::{Pair, Unresolved};
use js_sys::Promise;
use plane::Curves;
use queue::{Queue, promise};
use read::{numbers, property, snapshot, whole, wrong};
use settings::Chosen;
use shape::{Given, read_shape};
#[cfg(feature = "surfaces")]
use space::Nets;
use state::{Source, State};
use status::inspection;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const SHAPE: &str = r#"
/**
 * Closed curves or surfaces, in domain units: the box is [0,1]² or [0,1]³, y up. Both shapes of a registration are alike in
 * dimension; surfaces are registered by the package wasm-solid.
 */
export type Shape =
  /** Closed polygons, x y x y …, any orientation; a loop wholly inside another is a hole. */
  | { kind: "curves"; loops: Float64Array[] }
  /** Nodal values on (cells + 1)^dim nodes, x fastest, negative inside; cells is a power of two. */
  | { kind: "levelSet"; cells: number; dim: 2 | 3; values: Float64Array; redistance: boolean }
  /** A picture, row 0 on top, inside > 127; its longest side fills the box. */
  | { kind: "mask"; width: number; height: number; data: Uint8Array }
  /** A closed triangle mesh in space, x y z x y z …, and triples of its vertices. */
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

/** Triangles with a normal a vertex, x y z x y z …. */
export interface Surface {
  positions: Float32Array;
  normals: Float32Array;
  indices: Uint32Array;
}

/** `matched` is φ of `reference`, with its triangles. */
export interface Surfaces {
  reference: Surface;
  template: Surface;
  matched: Surface;
}
"#;

/// The registration of a reference shape with a template.
#[wasm_bindgen]
pub struct Registration {
    queue: Queue<Any>,
}

/// What is worked on, by one at a time.
enum Any {
    Plane(Box<State<2, Curves, Pair>>),
    #[cfg(feature = "surfaces")]
    Space(Box<State<3, Nets, SolidPair>>),
}

/// The same of a registration of either dimension.
macro_rules! of_any {
    ($any:expr, $state:ident => $answer:expr) => {
        match $any {
            Any::Plane($state) => $answer,
            #[cfg(feature = "surfaces")]
            Any::Space($state) => $answer,
        }
    };
}

/// A change as it was read.
struct Change {
    reference: Option<Given>,
    template: Option<Given>,
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
        let source = read_source(&reference, &template, &settings);
        promise(async move {
            let source = source?;
            #[cfg(feature = "surfaces")]
            if source.is_solid() {
                let state = Any::Space(Box::new(State::new(source).await?));
                return Ok(Self { queue: Queue::new(state) }.into());
            }
            let state = Any::Plane(Box::new(State::new(source).await?));
            Ok(Self { queue: Queue::new(state) }.into())
        })
    }

    /// Goes on from the present deformation with other shapes or settings; what is not given stays. Continues on the
    /// current level, or the nearest one of the new settings, so that a small change costs a few iterations only.
    /// Rejects like `create`, and then nothing has changed. Waits for steps and updates under way.
    #[wasm_bindgen(unchecked_return_type = "Promise<Status>")]
    pub fn update(&self, #[wasm_bindgen(unchecked_param_type = "Update")] change: JsValue) -> Promise {
        let change = Change::read(&change);
        self.queue.enqueue(async move |any: &mut Any| of_any!(any, state => state.update(change?).await))
    }

    /// Does up to `iterations` iterations, a whole number from 1 up; nothing once finished. Waits for steps and updates
    /// under way.
    #[wasm_bindgen(unchecked_return_type = "Promise<Status>")]
    pub fn step(&self, #[wasm_bindgen(unchecked_param_type = "number")] iterations: JsValue) -> Promise {
        let needed = "a whole number from 1 up, as in step(5)";
        let iterations = whole(&iterations, 1.0).ok_or_else(|| wrong("the number of steps", &iterations, needed));
        self.queue.enqueue(async move |any: &mut Any| of_any!(any, state => state.step(iterations?).await))
    }

    /// The settings in force, defaults filled in.
    #[wasm_bindgen(unchecked_return_type = "Settings")]
    pub fn settings(&self) -> Result<JsValue, JsError> {
        self.queue.now(|any| of_any!(any, state => Ok(state.settings())))
    }

    /// φ at the nodes of the current level: x y x y … or x y z x y z …, x fastest, domain units.
    pub fn deformation(&self) -> Result<Vec<f64>, JsError> {
        self.queue.now(|any| of_any!(any, state => Ok(state.deformation())))
    }

    /// Energies and gradient of the current level at a deformation of the same form as `deformation()`.
    #[wasm_bindgen(unchecked_return_type = "Evaluation")]
    pub fn evaluate(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Float64Array")] deformation: JsValue,
    ) -> Result<JsValue, JsError> {
        let deformation = numbers("the deformation", &deformation)?;
        self.queue.now(|any| of_any!(any, state => state.evaluate(&deformation)))
    }

    /// The zero sets on the current level, and φ of the reference's.
    #[wasm_bindgen(unchecked_return_type = "Curves")]
    pub fn curves(&self) -> Result<JsValue, JsError> {
        self.queue.now(|any| match any {
            Any::Plane(state) => Ok(state.curves()),
            #[cfg(feature = "surfaces")]
            Any::Space(_) => Err(JsError::new("this registration is of surfaces; ask for surfaces()")),
        })
    }

    /// The same for surfaces, as triangles.
    #[wasm_bindgen(unchecked_return_type = "Surfaces")]
    pub fn surfaces(&self) -> Result<JsValue, JsError> {
        self.queue.now(|any| match any {
            Any::Plane(_) => Err(JsError::new("this registration is of curves; ask for curves()")),
            #[cfg(feature = "surfaces")]
            Any::Space(state) => Ok(state.surfaces()),
        })
    }

    /// φ at points, as many numbers each as there are dimensions, domain units; beyond the box the boundary cell's
    /// polynomial goes on.
    pub fn map(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Float64Array")] points: JsValue,
    ) -> Result<Vec<f64>, JsError> {
        let points = numbers("points", &points)?;
        self.queue.now(|any| of_any!(any, state => state.map(&points)))
    }

    /// φ⁻¹ at points of the image of the box; NaN outside of it. Where the image lies over itself, one of the preimages.
    #[wasm_bindgen(js_name = inverseMap)]
    pub fn inverse_map(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Float64Array")] points: JsValue,
    ) -> Result<Vec<f64>, JsError> {
        let points = numbers("points", &points)?;
        self.queue.now(|any| of_any!(any, state => state.inverse_map(&points)))
    }

    /// Lets go of the memory. A step that has begun to compute still answers; what waits, or is asked afterwards, is refused.
    pub fn free(&self) {
        self.queue.close();
    }
}

/// Whether the finest grid of the settings resolves two shapes, before they are matched; refuses like `create`.
#[wasm_bindgen(unchecked_return_type = "Inspection")]
pub fn inspect(
    #[wasm_bindgen(unchecked_param_type = "Shape")] reference: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Shape")] template: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "Partial<Settings>")] settings: JsValue,
) -> Result<JsValue, JsError> {
    let source = read_source(&reference, &template, &settings)?;
    #[cfg(feature = "surfaces")]
    if source.is_solid() {
        let (_, _, [reference, template]) = source.prepare::<3, Nets>()?;
        return Ok(inspection(SolidPair::new(&reference, &template).unresolved(), None, [NO_FACT; NARROW]));
    }
    let (settings, _, [reference, template]) = source.prepare::<2, Curves>()?;
    let unresolved = Pair::new(&reference, &template).unresolved(settings.finest);
    let (words, level) = (unresolved.map(|found| found.sentence()), unresolved.and_then(|found| found.level));
    Ok(inspection(words, level, Unresolved::facts(unresolved.as_ref())))
}

/// Reports panics to the console with their message and place.
#[wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
    #[cfg(feature = "gpu")]
    crate::assemble::set_clock(now);
}

#[cfg(feature = "gpu")]
#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

fn read_source(reference: &JsValue, template: &JsValue, settings: &JsValue) -> Result<Source, JsError> {
    let shapes = [read_shape("reference", reference)?, read_shape("template", template)?];
    Ok(Source::new(shapes, Chosen::default().with(settings)?))
}

impl Change {
    fn read(change: &JsValue) -> Result<Self, JsError> {
        let shape = |name| -> Result<Option<Given>, JsError> {
            let given = property("the change", change, name)?;
            if given.is_undefined() { Ok(None) } else { read_shape(name, &given).map(Some) }
        };
        let (reference, template) = (shape("reference")?, shape("template")?);
        let settings = snapshot("settings", &property("the change", change, "settings")?)?;
        Ok(Self { reference, template, settings })
    }
}
