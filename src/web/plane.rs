//! Curves.

use super::memory;
use super::settings::Chosen;
use super::shape::Given;
use super::state::{Judge, Shown, State};
use super::status::object;
use crate::contour::zero_set;
use crate::distance::SignedDistance;
use crate::error::{Error, ShapeError};
use crate::hypersurface::image;
use crate::report::Report;
use crate::settings::Settings;
use crate::verdict::{Pair, Verdict};
use glam::DVec2;
use js_sys::{Array, Float64Array};
use wasm_bindgen::prelude::*;

/// Closed polylines.
pub(super) struct Curves(Vec<Vec<DVec2>>);

impl Shown<2> for Curves {
    fn settings(chosen: &Chosen) -> Result<Settings, Error> {
        memory::check(&chosen.settings)?;
        Ok(chosen.settings)
    }

    fn distance(given: &Given, level: u32) -> Result<SignedDistance<2>, ShapeError> {
        match given {
            Given::Plane(shape) => shape.distance(level),
            #[cfg(feature = "surfaces")]
            Given::Space(_) => Err(ShapeError::Unsupported(
                "is a surface, but the other shape is a curve; both must be alike in dimension".into(),
            )),
        }
    }

    fn of(shape: &SignedDistance<2>) -> Self {
        Self(zero_set(shape.grid(), shape.values()))
    }
}

impl Judge<2> for Pair {
    fn of(reference: &SignedDistance<2>, template: &SignedDistance<2>) -> Self {
        Self::new(reference, template)
    }

    fn judge(&self, level: u32, report: &Report<2>) -> Verdict {
        self.verdict(level, report)
    }
}

impl<J: Judge<2>> State<2, Curves, J> {
    pub fn curves(&mut self) -> JsValue {
        self.follow();
        let (grid, displacement) = (self.search.grid(), self.search.displacement());
        let moved = |point: &DVec2| DVec2::from(image(grid, displacement, &point.to_array()));
        let [Curves(reference), Curves(template)] = self.shown();
        let matched: Vec<Vec<DVec2>> = reference.iter().map(|polyline| polyline.iter().map(moved).collect()).collect();
        let arrays = |polylines: &[Vec<DVec2>]| -> JsValue {
            let arrays: Array = polylines
                .iter()
                .map(|polyline| {
                    let flat: Vec<f64> = polyline.iter().flat_map(|point| point.to_array()).collect();
                    JsValue::from(Float64Array::from(flat.as_slice()))
                })
                .collect();
            arrays.into()
        };
        object(&[("reference", arrays(reference)), ("template", arrays(template)), ("matched", arrays(&matched))])
    }
}
