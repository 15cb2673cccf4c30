//! The search for a match: runs of the cascade, one after the other, until one is good.
//!
//! One run is good for most pairs, and then the search costs nothing but a look at the result. It ends short of that where
//! the shell must be compressed more than it bears (the other way round it is stretched), where the energies' balance
//! keeps it out of details, or where the aim has limbs too far from its own. For each there is a step.

mod guide;
mod missed;
mod plan;

pub use plan::Approach;

use crate::assemble::{Assembler, CpuAssembler, Device, Evaluation};
use crate::cascade::{Cascade, Ties};
use crate::distance::SignedDistance;
use crate::energy::Pin;
use crate::error::Error;
use crate::grid::Grid;
use crate::inverse::invert;
use crate::minimize::Stop;
use crate::report::report;
use crate::settings::{Alignment, Settings};
use guide::{can_guide, guide};
use missed::{have_as_many_outlines, missed};
use plan::{Fit, Plan};
use std::cell::OnceCell;
use std::rc::Rc;

/// Iterations that refine the inverse of an exchanged match: more would start to crumple the shell, which is what the
/// exchange avoids.
const REFINEMENT: usize = 5;
/// Iterations of a round of sharpening: then it is looked again for what is still missed.
const SHARPENING: usize = 12;
/// Iterations between two looks whether a match is sharp enough already.
const LOOK: usize = 4;
/// A run is given up before each of so many of the finest levels, if it is hopeless.
const HOPELESS_LEVELS: u32 = 2;
/// Iterations on the finest level after which a run is judged: those that take more creep, and sharpening gets farther.
const EXPLORATION: usize = 28;

/// A registration under way.
pub struct Search<const D: usize> {
    settings: Settings,
    device: Device,
    /// Reference and template on the finest level.
    shapes: [Rc<SignedDistance<D>>; 2],
    pins: Rc<[Pin<D>]>,
    approach: Approach,
    /// The run of the present approach; from the template to the reference if that is the approach.
    run: Cascade<D>,
    plan: Plan,
    /// The best so far: u on the finest level.
    best: Option<(Fit, Vec<f64>)>,
    /// What sharpening draws the shell to.
    missed: Vec<Pin<D>>,
    /// Evaluations of the runs before this one.
    past_evaluations: usize,
    stop: Option<Stop>,
    /// u of φ while the run works on φ⁻¹.
    inverse: OnceCell<Vec<f64>>,
}

/// Where a search stands.
#[derive(Clone, Copy, Debug)]
pub struct SearchProgress {
    pub approach: Approach,
    pub level: u32,
    /// Iterations on this level.
    pub iteration: usize,
    /// Evaluations of the energy in all.
    pub evaluations: usize,
    /// While the roles are exchanged: the energies of φ⁻¹ with the template as the shell.
    pub evaluation: Evaluation,
    /// Set once the search has ended.
    pub stop: Option<Stop>,
}

impl<const D: usize> Search<D> {
    /// Both shapes on the finest level's grid. With `align: none` a single run from the identity, as in the paper.
    ///
    /// # Errors
    /// A setting out of range, or no finite energy to begin with.
    pub async fn new(
        reference: SignedDistance<D>,
        template: SignedDistance<D>,
        settings: Settings,
    ) -> Result<Self, Error> {
        Self::with_pins(reference, template, settings, &[]).await
    }

    /// With points of the reference tied to points of the template.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub async fn with_pins(
        reference: SignedDistance<D>,
        template: SignedDistance<D>,
        settings: Settings,
        pins: &[Pin<D>],
    ) -> Result<Self, Error> {
        settings.validate()?;
        let device = Device::open(settings.backend).await?;
        let pins: Rc<[Pin<D>]> = pins.into();
        let shapes = [Rc::new(reference), Rc::new(template)];
        let mut plan = match settings.alignment {
            Alignment::None => Plan::single(),
            Alignment::Similarity => Plan::of(&shapes[0], &shapes[1]),
        };
        let approach = plan.next(None, None).expect("a plan has a first approach");
        let mut run =
            Cascade::begin(in_direction(&shapes, approach), tied(&pins, approach), settings, device.clone()).await?;
        if !plan.is_single() {
            run.limit(settings.minimizer.iterations(EXPLORATION));
        }
        Ok(Self {
            settings,
            device,
            shapes,
            pins,
            approach,
            run,
            plan,
            best: None,
            missed: Vec::new(),
            past_evaluations: 0,
            stop: None,
            inverse: OnceCell::new(),
        })
    }

    /// Goes on with other shapes or settings from the deformation there is, on its level or the nearest one of the new
    /// settings, in a single run. Nothing is changed if this fails.
    ///
    /// # Errors
    /// A setting out of range, or no finite energy to begin with.
    pub async fn update(
        &mut self,
        reference: SignedDistance<D>,
        template: SignedDistance<D>,
        settings: Settings,
        pins: &[Pin<D>],
    ) -> Result<(), Error> {
        settings.validate()?;
        let device = Device::open(settings.backend).await?;
        let shapes = [Rc::new(reference), Rc::new(template)];
        #[cfg(feature = "gpu")]
        self.fetch().await;
        let displacement = self.displacement().to_vec();
        let pins: Rc<[Pin<D>]> = pins.into();
        let (ties, level) = (Ties::of(pins.clone()), self.progress().level);
        let run =
            Cascade::resume(shapes.clone(), ties, settings, device.clone(), level, self.grid(), displacement).await?;
        self.past_evaluations = self.progress().evaluations;
        self.inverse.take();
        (self.shapes, self.pins, self.settings, self.device, self.run) = (shapes, pins, settings, device, run);
        (self.approach, self.plan, self.best, self.stop) = (Approach::Direct, Plan::none(), None, None);
        Ok(())
    }

    /// One iteration; nothing once the search has ended.
    pub async fn step(&mut self) -> SearchProgress {
        if self.stop.is_none() {
            self.inverse.take();
            #[cfg(feature = "gpu")]
            if matches!(self.approach, Approach::Sharpened(_)) {
                self.fetch().await;
            }
            if self.is_hopeless() || self.is_sharp() {
                self.run.end();
            }
            if let Some(stop) = self.run.step().await.stop {
                self.conclude(stop).await;
            }
        }
        self.progress()
    }

    /// Whether the finest levels would be wasted on a shell that is far from its aim, and can be led instead.
    fn is_hopeless(&self) -> bool {
        let [shell, aim] = self.run.shapes();
        self.run.is_about_to_refine()
            && self.run.levels_left() <= HOPELESS_LEVELS
            && self.plan.will_lead(self.approach)
            && can_guide(&self.shapes)
            && Fit::of(self.approach, &report(shell, aim, self.run.displacement())).is_hopeless()
    }

    /// Whether nothing is left to sharpen.
    fn is_sharp(&self) -> bool {
        let iteration = self.run.progress().iteration;
        matches!(self.approach, Approach::Sharpened(_))
            && iteration > 0
            && iteration.is_multiple_of(LOOK)
            && self.fit().is_fine()
    }

    /// Brings the displacement up to date: between steps it may stay on a graphics card. Once the search has ended it is.
    #[cfg(feature = "gpu")]
    pub async fn fetch(&mut self) {
        self.run.fetch().await;
    }

    /// Judges the run that has ended and begins the next one, or ends the search.
    async fn conclude(&mut self, stop: Stop) {
        if self.plan.is_single() {
            self.stop = Some(stop);
            return;
        }
        let mut last = None;
        if self.approach.is_exchanged() {
            if self.continue_exchanged().await {
                return;
            }
        } else {
            last = Some(self.consider());
        }
        while let Some(approach) = self.plan.next(last.as_ref(), self.best.as_ref().map(|(fit, _)| fit)) {
            if self.begin(approach).await {
                return;
            }
        }
        self.finish(stop).await;
    }

    /// Inverts an exchanged match, or sharpens it first; false if it is given up.
    async fn continue_exchanged(&mut self) -> bool {
        let fit = self.fit();
        if fit.is_worth_inverting()
            && let Some(displacement) = invert(self.run.grid(), self.run.displacement())
            && self.begin_from(Approach::Inverted, self.settings, displacement).await
        {
            // Refinement may also make it worse.
            self.consider();
            self.limit(REFINEMENT);
            return true;
        }
        let sharper = Approach::SharpenedExchanged;
        if self.approach == sharper || !fit.is_worth_sharpening() {
            return false;
        }
        let displacement = self.run.displacement().to_vec();
        self.sharpen(sharper, displacement).await
    }

    /// Judges the present run's result, and keeps it if it is the best so far.
    fn consider(&mut self) -> Fit {
        let fit = self.fit();
        if self.best.as_ref().is_none_or(|(best, _)| fit.cost() < best.cost()) {
            self.best = Some((fit, self.run.displacement().to_vec()));
        }
        fit
    }

    /// Whether the approach could be begun.
    async fn begin(&mut self, approach: Approach) -> bool {
        let settings = approach.settings(&self.settings);
        if let Approach::Sharpened(_) = approach {
            // Of the last run, even if an earlier one was better: a round may lose by one measure what the next one mends.
            let displacement = self.run.displacement().to_vec();
            return self.sharpen(approach, displacement).await;
        }
        if approach.is_guided() && !can_guide(&self.shapes) {
            return false;
        }
        match self.start(approach, settings).await {
            Ok(mut run) => {
                run.limit(self.settings.minimizer.iterations(EXPLORATION));
                self.enter(approach, run);
                true
            }
            Err(_) => false,
        }
    }

    async fn start(&self, approach: Approach, settings: Settings) -> Result<Cascade<D>, Error> {
        let mut ties = tied(&self.pins, approach);
        if approach.is_guided() {
            let best = self.best.as_ref().map(|(_, u)| u.as_slice());
            let pins = guide(&self.shapes, approach.is_as_drawn(), best);
            ties.guide =
                pins.into_iter().map(|pin| if approach.is_exchanged() { pin.reversed() } else { pin }).collect();
        }
        Cascade::begin(in_direction(&self.shapes, approach), ties, settings, self.device.clone()).await
    }

    /// Begins a run on the finest level. A deformation that has no finite energy under other settings is no beginning.
    async fn begin_from(&mut self, approach: Approach, settings: Settings, displacement: Vec<f64>) -> bool {
        self.begin_tied(approach, settings, displacement, tied(&self.pins, approach)).await
    }

    /// Begins to sharpen a match.
    async fn sharpen(&mut self, approach: Approach, displacement: Vec<f64>) -> bool {
        let mut ties = tied(&self.pins, approach);
        if !matches!(self.approach, Approach::Sharpened(_)) {
            self.missed.clear();
        }
        // What one shape has and the other lacks cannot be reached: the shell would only be torn towards it.
        if have_as_many_outlines(&self.shapes) {
            self.missed = missed(&in_direction(&self.shapes, approach), &displacement, &self.missed);
        }
        ties.missed = self.missed.as_slice().into();
        let begun = self.begin_tied(approach, approach.settings(&self.settings), displacement, ties).await;
        self.limit(SHARPENING);
        begun
    }

    async fn begin_tied(
        &mut self,
        approach: Approach,
        settings: Settings,
        displacement: Vec<f64>,
        ties: Ties<D>,
    ) -> bool {
        let shapes = in_direction(&self.shapes, approach);
        let grid = Grid::of_level(settings.finest);
        let device = self.device.clone();
        match Cascade::resume(shapes, ties, settings, device, settings.finest, grid, displacement).await {
            Ok(run) => {
                self.enter(approach, run);
                true
            }
            Err(_) => false,
        }
    }

    /// Ends the present run after this many iterations of Newton's method on the finest level.
    fn limit(&mut self, iterations: usize) {
        self.run.limit(self.settings.minimizer.iterations(iterations));
    }

    fn enter(&mut self, approach: Approach, run: Cascade<D>) {
        self.past_evaluations += self.run.progress().evaluations;
        self.inverse.take();
        (self.approach, self.run) = (approach, run);
    }

    /// Ends with the best there is, looked at with the settings as they are.
    async fn finish(&mut self, stop: Stop) {
        self.stop = Some(stop);
        let Some((fit, displacement)) = self.best.take() else { return };
        let is_there = !self.approach.is_exchanged()
            && self.approach.settings(&self.settings) == self.settings
            && self.run.displacement() == displacement.as_slice();
        if !is_there {
            let origin = fit.approach;
            if self.begin_from(origin, self.settings, displacement).await {
                self.stop = Some(Stop::BestOf);
            }
        }
    }

    /// How good the present run's result is, in its own direction.
    fn fit(&self) -> Fit {
        let [shell, aim] = in_direction(&self.shapes, self.approach);
        Fit::of(self.approach, &report(&shell, &aim, self.run.displacement()))
    }

    /// The state after the last step, or at the start.
    pub fn progress(&self) -> SearchProgress {
        let run = self.run.progress();
        SearchProgress {
            approach: self.approach,
            level: run.level,
            iteration: run.iteration,
            evaluations: self.past_evaluations + run.evaluations,
            evaluation: run.evaluation,
            stop: self.stop,
        }
    }

    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// What computes: "cpu", "gpu: " and the card's name, or "cpu: " and why it is not the card.
    pub fn backend(&self) -> String {
        self.run.backend()
    }

    /// The current level's grid.
    pub fn grid(&self) -> Grid<D> {
        self.run.grid()
    }

    /// u = φ − x at the nodes of the current level.
    pub fn displacement(&self) -> &[f64] {
        let displacement = self.run.displacement();
        if !self.approach.is_exchanged() {
            return displacement;
        }
        // Where the inverse cannot be found yet, nothing is shown to move.
        let inverse = || invert(self.grid(), displacement).unwrap_or_else(|| vec![0.0; displacement.len()]);
        self.inverse.get_or_init(inverse)
    }

    /// The shapes on the finest level.
    pub fn shapes(&self) -> [&SignedDistance<D>; 2] {
        [&self.shapes[0], &self.shapes[1]]
    }

    /// The reference on the current level.
    pub fn reference(&self) -> &SignedDistance<D> {
        self.run.shapes()[usize::from(self.approach.is_exchanged())]
    }

    /// The template on the current level.
    pub fn template(&self) -> &SignedDistance<D> {
        self.run.shapes()[usize::from(!self.approach.is_exchanged())]
    }

    /// Energies and gradient of the current level at any displacement, with the settings as they are.
    pub async fn evaluate(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
        if !self.approach.is_exchanged() && *self.run.settings() == self.settings {
            return self.run.evaluate(displacement, gradient).await;
        }
        let functional = self.settings.functional(self.run.progress().level);
        let mut assembler: CpuAssembler<D> = CpuAssembler::new(&functional, self.reference(), self.template());
        assembler.tie(&self.pins, self.settings.pin_weight);
        assembler.gradient(displacement, gradient).await
    }
}

/// The pins in the direction of the approach.
fn tied<const D: usize>(pins: &Rc<[Pin<D>]>, approach: Approach) -> Ties<D> {
    Ties::of(if approach.is_exchanged() { pins.iter().map(|pin| pin.reversed()).collect() } else { pins.clone() })
}

/// The shell and its aim.
fn in_direction<const D: usize>(
    [reference, template]: &[Rc<SignedDistance<D>>; 2],
    approach: Approach,
) -> [Rc<SignedDistance<D>>; 2] {
    if approach.is_exchanged() { [template.clone(), reference.clone()] } else { [reference.clone(), template.clone()] }
}
