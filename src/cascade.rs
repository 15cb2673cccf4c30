//! Coarse to fine: Algorithm 1 of the paper, one iteration at a time.

mod level;
mod start;

use crate::assemble::{Assembler, Device, Evaluation};
use crate::distance::SignedDistance;
use crate::energy::{Energies, Pin};
use crate::error::Error;
use crate::grid::Grid;
use crate::minimize::{Progress, Stop};
use crate::prolongation::{coarsen, prolongate};
use crate::settings::{Alignment, Settings};
use level::Level;
use std::rc::Rc;

/// The multigrid works in single precision: energies, and with them squares of residuals, beyond this would overflow.
const GREATEST_ENERGY: f64 = 1e18;

/// One run from the first level to the finest: a shell is drawn onto its aim.
pub struct Cascade<const D: usize> {
    settings: Settings,
    device: Device,
    /// The shell and its aim on the finest level.
    shapes: [Rc<SignedDistance<D>>; 2],
    ties: Ties<D>,
    level: Level<D>,
    /// Of iterations on the finest level.
    limit: usize,
    /// Evaluations before this level.
    past_evaluations: usize,
    progress: Progress,
}

/// Points of the shell that are tied to points of its aim.
#[derive(Clone, Default)]
pub(crate) struct Ties<const D: usize> {
    /// By the user.
    pub pins: Rc<[Pin<D>]>,
    /// To lead the shell on levels before the finest.
    pub guide: Rc<[Pin<D>]>,
    /// To draw it to what it has missed, on the finest level.
    pub missed: Rc<[Pin<D>]>,
}

impl<const D: usize> Ties<D> {
    pub fn of(pins: Rc<[Pin<D>]>) -> Self {
        Self { pins, guide: Rc::default(), missed: Rc::default() }
    }
}

/// Where a cascade stands.
#[derive(Clone, Copy, Debug)]
pub struct CascadeProgress {
    pub level: u32,
    /// Iterations on this level.
    pub iteration: usize,
    /// Evaluations of the energy on all levels.
    pub evaluations: usize,
    pub evaluation: Evaluation,
    /// Set once the finest level has ended.
    pub stop: Option<Stop>,
}

impl<const D: usize> Cascade<D> {
    /// Both shapes on the finest level's grid. Starts on the first level that carries both shapes, with the thickness
    /// and penalty that this level would have had after the coarser ones.
    ///
    /// # Errors
    /// A setting out of range, or no finite energy to begin with.
    pub async fn new(shell: SignedDistance<D>, aim: SignedDistance<D>, settings: Settings) -> Result<Self, Error> {
        settings.validate()?;
        Self::begin([Rc::new(shell), Rc::new(aim)], Ties::default(), settings, Device::default()).await
    }

    /// With valid settings, from the start that they ask for.
    pub(crate) async fn begin(
        shapes: [Rc<SignedDistance<D>>; 2],
        ties: Ties<D>,
        settings: Settings,
        device: Device,
    ) -> Result<Self, Error> {
        let mut level = Level::new(first_level(&settings, &shapes), &settings, &device, &shapes, &ties, None);
        let mut evaluations = 1;
        if settings.alignment == Alignment::Similarity {
            let displacement = start::find(&mut level.assembler, &shapes, &settings, &mut evaluations).await;
            level.restart(&settings, displacement);
        }
        Self::at(shapes, ties, settings, device, level, evaluations).await
    }

    /// From a displacement on a grid, taken to the level of that number or the nearest one that the settings have and
    /// that carries both shapes.
    pub(crate) async fn resume(
        shapes: [Rc<SignedDistance<D>>; 2],
        ties: Ties<D>,
        settings: Settings,
        device: Device,
        number: u32,
        mut grid: Grid<D>,
        mut displacement: Vec<f64>,
    ) -> Result<Self, Error> {
        let number = number.clamp(first_level(&settings, &shapes), settings.finest);
        while grid.cells() < 1 << number {
            displacement = prolongate(grid, &displacement);
            grid = Grid::new(2 * grid.cells());
        }
        while grid.cells() > 1 << number {
            displacement = coarsen(grid, &displacement);
            grid = Grid::new(grid.cells() / 2);
        }
        let mut level = Level::new(number, &settings, &device, &shapes, &ties, Some(displacement));
        level.unfold(&settings).await;
        Self::at(shapes, ties, settings, device, level, 1).await
    }

    async fn at(
        shapes: [Rc<SignedDistance<D>>; 2],
        ties: Ties<D>,
        settings: Settings,
        device: Device,
        mut level: Level<D>,
        past_evaluations: usize,
    ) -> Result<Self, Error> {
        for shape in &shapes {
            assert_eq!(shape.grid(), Grid::of_level(settings.finest), "the shapes live on the finest level");
        }
        let evaluation = level.energy().await;
        check_energy(&evaluation)?;
        let progress = Progress { evaluation, iterations: 0, evaluations: 0, stop: None };
        Ok(Self { settings, device, shapes, ties, level, limit: usize::MAX, past_evaluations, progress })
    }

    /// Ends the finest level after this many iterations.
    pub(crate) fn limit(&mut self, iterations: usize) {
        self.limit = iterations;
    }

    /// Whether the next step is the first one on another level.
    pub(crate) fn is_about_to_refine(&self) -> bool {
        self.progress.stop.is_some() && self.level.number < self.settings.finest
    }

    /// Levels that are left.
    pub(crate) fn levels_left(&self) -> u32 {
        self.settings.finest - self.level.number
    }

    /// Makes no more iterations: the deformation goes to the finest level as it is.
    pub(crate) fn end(&mut self) {
        self.limit = 0;
    }

    /// One iteration, on the next level if this one has ended; nothing once the finest has.
    pub async fn step(&mut self) -> CascadeProgress {
        if self.is_about_to_refine() {
            let displacement = prolongate(self.grid(), self.level.displacement());
            self.past_evaluations += self.progress.evaluations;
            self.level.rest();
            let number = self.level.number + 1;
            self.level = Level::new(number, &self.settings, &self.device, &self.shapes, &self.ties, Some(displacement));
            self.level.unfold(&self.settings).await;
            self.progress = Progress { iterations: 0, evaluations: 0, stop: None, ..self.progress };
        }
        let has_ended = self.limit == 0;
        if self.progress.stop.is_none() && !has_ended {
            self.progress = self.level.step().await;
        }
        let is_finest = self.level.number == self.settings.finest;
        if has_ended || is_finest && self.progress.iterations >= self.limit {
            #[cfg(feature = "gpu")]
            if !has_ended && self.level.fetch().await.is_none() {
                // What was done is lost, and as much is to be done again.
                self.limit += self.limit;
                return self.progress();
            }
            self.progress.stop = self.progress.stop.or(Some(Stop::Refined));
        }
        if self.progress().stop.is_some() {
            self.level.rest();
        }
        self.progress()
    }

    /// Brings the displacement up to date: between steps it may stay on a graphics card.
    #[cfg(feature = "gpu")]
    pub(crate) async fn fetch(&mut self) {
        // What is lost the next step finds again.
        let _ = self.level.fetch().await;
    }

    /// The state after the last step, or at the start.
    pub fn progress(&self) -> CascadeProgress {
        CascadeProgress {
            level: self.level.number,
            iteration: self.progress.iterations,
            evaluations: self.past_evaluations + self.progress.evaluations,
            evaluation: self.progress.evaluation,
            stop: self.progress.stop.filter(|_| self.level.number == self.settings.finest),
        }
    }

    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The current level's grid.
    pub fn grid(&self) -> Grid<D> {
        self.level.assembler.grid()
    }

    /// u = φ − x at the nodes of the current level, as it was fetched last or at the level's end.
    pub fn displacement(&self) -> &[f64] {
        self.level.displacement()
    }

    /// The shell and its aim on the current level.
    pub fn shapes(&self) -> [&SignedDistance<D>; 2] {
        self.level.shapes()
    }

    /// What computes the current level.
    pub fn backend(&self) -> String {
        self.level.assembler.backend()
    }

    /// Energies and gradient of the current level at any displacement, by the processor.
    pub async fn evaluate(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
        self.level.assembler.twin().gradient(displacement, gradient).await
    }
}

/// The first level whose grid carries both shapes: on a coarser one there would be nothing to match.
fn first_level<const D: usize>(settings: &Settings, shapes: &[Rc<SignedDistance<D>>; 2]) -> u32 {
    let carries = |level: &u32| shapes.iter().all(|shape| shape.is_carried_by(1 << level));
    (settings.coarsest..settings.finest).find(carries).unwrap_or(settings.finest)
}

fn check_energy(evaluation: &Evaluation) -> Result<(), Error> {
    let Energies { membrane, bending, mismatch, volume, pins } = evaluation.energies;
    let most = GREATEST_ENERGY;
    let terms =
        [("membrane", membrane), ("bending", bending), ("mismatch", mismatch), ("volume", volume), ("pins", pins)];
    match terms.into_iter().find(|(_, value)| value.is_nan() || *value > most) {
        Some((term, value)) => Err(Error::NoEnergy { term, value, most }),
        None => Ok(()),
    }
}
