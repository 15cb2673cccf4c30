//! A registration in one dimension.

use super::Change;
use super::settings::Chosen;
use super::shape::Given;
use super::status::{evaluation, status};
use crate::distance::SignedDistance;
use crate::error::{Error, ShapeError};
use crate::hypersurface::image;
use crate::inverse::Inverse;
use crate::ready::ready;
use crate::report::{Outlines, Report};
use crate::search::Search;
use crate::settings::{Pin, Settings};
use crate::verdict::Verdict;
use wasm_bindgen::prelude::*;

/// How shapes of one dimension come in and are shown.
pub(super) trait Shown<const D: usize>: Sized {
    /// The settings as they are for shapes of this dimension, if they are possible.
    fn settings(chosen: &Chosen) -> Result<Settings, Error>;

    fn distance(given: &Given, level: u32) -> Result<SignedDistance<D>, ShapeError>;

    /// Refuses what would need more memory than there is, if that shows by the shapes only.
    fn check(_: &Settings, _: &[SignedDistance<D>; 2]) -> Result<(), Error> {
        Ok(())
    }

    /// The zero set.
    fn of(shape: &SignedDistance<D>) -> Self;
}

/// What judges matches in one dimension.
pub(super) trait Judge<const D: usize> {
    fn of(reference: &SignedDistance<D>, template: &SignedDistance<D>) -> Self;

    fn judge(&self, level: u32, report: &Report<D>) -> Verdict;
}

/// What is worked on.
pub(super) struct State<const D: usize, V, J> {
    pub search: Search<D>,
    source: Source,
    look: Look<D, V>,
    /// What the verdict needs to know of the shapes; looked at when there is something to judge.
    judge: Option<J>,
}

/// Reference and template on one level.
struct Look<const D: usize, V> {
    level: u32,
    shown: [V; 2],
    /// What matches are measured by.
    outlines: Outlines<D>,
}

/// What a registration was made of, so that a part of it can be replaced.
#[derive(Clone)]
pub(super) struct Source {
    /// Reference and template.
    shapes: [Given; 2],
    chosen: Chosen,
}

pub(super) type Prepared<const D: usize> = (Settings, Vec<Pin<D>>, [SignedDistance<D>; 2]);

impl Source {
    pub fn new(shapes: [Given; 2], chosen: Chosen) -> Self {
        Self { shapes, chosen }
    }

    /// By the reference; that the template is alike shows when it is prepared.
    #[cfg(feature = "surfaces")]
    pub fn is_solid(&self) -> bool {
        matches!(self.shapes[0], Given::Space(_))
    }

    pub fn prepare<const D: usize, V: Shown<D>>(&self) -> Result<Prepared<D>, JsError> {
        let settings = V::settings(&self.chosen)?;
        let pins = Pin::read(&self.chosen.pins)?;
        let distance = |name, given: &Given| {
            V::distance(given, settings.finest).map_err(|problem| Error::Shape { shape: name, problem })
        };
        let [reference, template] = &self.shapes;
        let shapes = [distance("reference", reference)?, distance("template", template)?];
        V::check(&settings, &shapes)?;
        Ok((settings, pins, shapes))
    }
}

impl<const D: usize, V: Shown<D>, J: Judge<D>> State<D, V, J> {
    pub async fn new(source: Source) -> Result<Self, JsError> {
        let (settings, pins, [reference, template]) = source.prepare::<D, V>()?;
        let search = Search::with_pins(reference, template, settings, &pins).await?;
        let look = Look::at(&search);
        Ok(Self { search, source, look, judge: None })
    }

    pub async fn update(&mut self, change: Change) -> Result<JsValue, JsError> {
        let mut source = self.source.clone();
        for (shape, changed) in source.shapes.iter_mut().zip([change.reference, change.template]) {
            if let Some(changed) = changed {
                *shape = changed;
            }
        }
        source.chosen = source.chosen.with(&change.settings)?;
        let (settings, pins, [reference, template]) = source.prepare::<D, V>()?;
        self.search.update(reference, template, settings, &pins).await?;
        self.source = source;
        self.judge = None;
        self.look = Look::at(&self.search);
        Ok(self.status())
    }

    pub async fn step(&mut self, iterations: usize) -> Result<JsValue, JsError> {
        for _ in 0..iterations {
            if self.search.progress().stop.is_some() {
                break;
            }
            self.search.step().await;
        }
        #[cfg(feature = "gpu")]
        self.search.fetch().await;
        Ok(self.status())
    }

    pub fn settings(&self) -> JsValue {
        Chosen { settings: *self.search.settings(), ..self.source.chosen.clone() }.to_js()
    }

    pub fn deformation(&self) -> Vec<f64> {
        let grid = self.search.grid();
        let positions = (0..grid.node_count()).flat_map(|node| grid.position(node));
        positions.zip(self.search.displacement()).map(|(x, u)| x + u).collect()
    }

    pub fn evaluate(&mut self, deformation: &[f64]) -> Result<JsValue, JsError> {
        let grid = self.search.grid();
        check_array("deformation", deformation, D * grid.node_count(), || {
            let (coordinates, level) = (coordinates::<D>(), self.search.progress().level);
            format!("{coordinates} at the {} nodes of level {level}", grid.node_count())
        })?;
        let positions = (0..grid.node_count()).flat_map(|node| grid.position(node));
        let displacement: Vec<f64> = deformation.iter().zip(positions).map(|(y, x)| y - x).collect();
        let mut gradient = vec![0.0; displacement.len()];
        let evaluated = ready(self.search.evaluate(&displacement, &mut gradient));
        Ok(evaluation(&evaluated, gradient))
    }

    pub fn map(&self, points: &[f64]) -> Result<Vec<f64>, JsError> {
        let (grid, displacement) = (self.search.grid(), self.search.displacement());
        Ok(checked_points::<D>(points)?.flat_map(|point| image(grid, displacement, &point)).collect())
    }

    pub fn inverse_map(&self, points: &[f64]) -> Result<Vec<f64>, JsError> {
        let points = checked_points::<D>(points)?;
        let inverse = Inverse::new(self.search.grid(), self.search.displacement());
        Ok(points.flat_map(|point| inverse.at(&point).unwrap_or([f64::NAN; D])).collect())
    }

    /// Takes reference and template from the current level.
    pub fn follow(&mut self) {
        if self.look.level != self.search.progress().level {
            self.look = Look::at(&self.search);
        }
    }

    /// Reference and template as they were last taken.
    pub fn shown(&self) -> &[V; 2] {
        &self.look.shown
    }

    fn status(&mut self) -> JsValue {
        self.follow();
        let report = self.look.outlines.report(self.search.displacement());
        let progress = self.search.progress();
        let verdict = progress.stop.map(|_| {
            let [reference, template] = self.search.shapes();
            self.judge.get_or_insert_with(|| J::of(reference, template)).judge(progress.level, &report)
        });
        status(&progress, &report, verdict, self.search.backend())
    }
}

impl<const D: usize, V: Shown<D>> Look<D, V> {
    #[inline(never)]
    fn at(search: &Search<D>) -> Self {
        let shapes = [search.reference(), search.template()];
        let outlines = Outlines::new(shapes[0], shapes[1]);
        Self { level: search.progress().level, shown: shapes.map(V::of), outlines }
    }
}

fn coordinates<const D: usize>() -> &'static str {
    if D == 2 { "x and y" } else { "x, y and z" }
}

fn checked_points<const D: usize>(numbers: &[f64]) -> Result<impl Iterator<Item = [f64; D]>, JsError> {
    let expected = numbers.len().next_multiple_of(D);
    check_array("points", numbers, expected, || format!("{} of every point", coordinates::<D>()))?;
    Ok(numbers.chunks_exact(D).map(|point| std::array::from_fn(|k| point[k])))
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
