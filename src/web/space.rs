//! Surfaces.

use super::memory;
use super::settings::Chosen;
use super::shape::Given;
use super::state::{Judge, Shown, State};
use super::status::object;
use crate::distance::SignedDistance;
use crate::error::{Error, ShapeError};
use crate::hypersurface::Hypersurface;
use crate::report::Report;
use crate::settings::Settings;
use crate::surface::{net, normals};
use crate::verdict::{FACTS, NO_FACT, SolidPair, Verdict};
use js_sys::{Float32Array, Uint32Array};
use wasm_bindgen::prelude::*;

/// The zero set by one vertex a cell.
pub(super) struct Nets(Hypersurface<3>);

impl Shown<3> for Nets {
    fn settings(chosen: &Chosen) -> Result<Settings, Error> {
        let mut settings = chosen.settings;
        if !chosen.is_finest_chosen {
            settings.finest = settings.coarsest.max(Settings::USUAL_SOLID_LEVEL);
        }
        settings.validate_for_surfaces()?;
        Ok(settings)
    }

    fn check(settings: &Settings, shapes: &[SignedDistance<3>; 2]) -> Result<(), Error> {
        memory::check_solid(settings, shapes)
    }

    fn distance(given: &Given, level: u32) -> Result<SignedDistance<3>, ShapeError> {
        match given {
            Given::Space(solid) => solid.distance(level),
            Given::Plane(_) => Err(ShapeError::Unsupported(
                "is a curve, but the other shape is a surface; both must be alike in dimension".into(),
            )),
        }
    }

    fn of(shape: &SignedDistance<3>) -> Self {
        Self(net(shape.grid(), shape.values()))
    }
}

impl Judge<3> for SolidPair {
    fn of(reference: &SignedDistance<3>, template: &SignedDistance<3>) -> Self {
        Self::new(reference, template)
    }

    fn judge(&self, _: u32, report: &Report<3>) -> Verdict {
        Verdict { words: self.verdict(report), facts: [NO_FACT; FACTS] }
    }
}

impl<J: Judge<3>> State<3, Nets, J> {
    pub fn surfaces(&mut self) -> JsValue {
        self.follow();
        let [Nets(reference), Nets(template)] = self.shown();
        let matched = reference.moved(self.search.grid(), self.search.displacement());
        object(&[("reference", surface(reference)), ("template", surface(template)), ("matched", surface(&matched))])
    }
}

fn surface(surface: &Hypersurface<3>) -> JsValue {
    let numbers = |vectors: &[[f64; 3]]| {
        let numbers: Vec<f32> = vectors.as_flattened().iter().map(|x| *x as f32).collect();
        Float32Array::from(numbers.as_slice()).into()
    };
    object(&[
        ("positions", numbers(surface.points())),
        ("normals", numbers(&normals(surface))),
        ("indices", Uint32Array::from(surface.simplices().as_flattened()).into()),
    ])
}
