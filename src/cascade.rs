//! Coarse to fine: Algorithm 1 of the paper, one iteration at a time.

mod level;
mod start;

use crate::assemble::{Assembler, CpuAssembler, Evaluation};
use crate::distance::SignedDistance;
use crate::energy::Energies;
use crate::error::Error;
use crate::grid::Grid;
use crate::inverse::invert;
use crate::minimize::{Progress, Stop};
use crate::prolongation::{coarsen, prolongate};
use crate::settings::{Alignment, Settings};
use level::Level;
use std::cell::OnceCell;

/// The multigrid works in single precision: energies, and with them squares of residuals, beyond this would overflow.
const GREATEST_ENERGY: f64 = 1e18;

/// A match with exchanged roles is kept if it is this close, root mean square in cells.
const MISMATCH_KEPT: f64 = 0.5;

/// A registration under way.
pub struct Cascade<const D: usize> {
    settings: Settings,
    /// Both shapes on the finest level.
    reference: SignedDistance<D>,
    template: SignedDistance<D>,
    level: Level<D>,
    /// Evaluations before this level.
    past_evaluations: usize,
    progress: Progress,
    /// u of φ while the level works on φ⁻¹.
    inverse: OnceCell<Vec<f64>>,
}

/// Where a cascade stands.
#[derive(Clone, Copy, Debug)]
pub struct CascadeProgress {
    pub level: u32,
    /// Iterations on this level.
    pub iteration: usize,
    /// Evaluations of the energy on all levels.
    pub evaluations: usize,
    /// While the roles are exchanged: the energies of φ⁻¹ with the template as the shell.
    pub evaluation: Evaluation,
    /// Set once the finest level has ended.
    pub stop: Option<Stop>,
}

impl<const D: usize> Cascade<D> {
    /// Both shapes on the finest level's grid. Starts on the first level that carries both shapes, with the thickness and penalty that this level would have had
    /// after the coarser ones.
    ///
    /// # Errors
    /// A setting out of range, or no finite energy to begin with.
    pub async fn new(
        reference: SignedDistance<D>,
        template: SignedDistance<D>,
        settings: Settings,
    ) -> Result<Self, Error> {
        settings.validate()?;
        assert_eq!(reference.grid(), Grid::of_level(settings.finest), "the shapes live on the finest level");
        assert_eq!(template.grid(), reference.grid());
        let aligned = settings.alignment == Alignment::Similarity;
        let exchanged = aligned && start::is_shorter(&template, &reference);
        let cascade = Self::begin(reference, template, settings, exchanged).await;
        check_energy(&cascade.progress.evaluation)?;
        Ok(cascade)
    }

    async fn begin(
        reference: SignedDistance<D>,
        template: SignedDistance<D>,
        settings: Settings,
        exchanged: bool,
    ) -> Self {
        let first = first_level(&settings, [&reference, &template]);
        let mut level = Level::new(first, &settings, [&reference, &template], exchanged, None);
        let mut evaluations = 0;
        if settings.alignment == Alignment::Similarity {
            let shapes = if exchanged { [&template, &reference] } else { [&reference, &template] };
            let displacement = start::find(&mut level.assembler, shapes, &settings, &mut evaluations).await;
            level.restart(&settings, displacement);
        }
        let evaluation = level.energy().await;
        let progress = Progress { evaluation, iterations: 0, evaluations: 0, stop: None };
        let past_evaluations = evaluations + 1;
        Self { settings, reference, template, level, past_evaluations, progress, inverse: OnceCell::new() }
    }

    /// Goes on with other shapes or settings from the deformation there is, on its level or the nearest one of the new
    /// settings. The cascade is unchanged if this fails.
    ///
    /// # Errors
    /// A setting out of range, or no finite energy to begin with.
    pub async fn update(
        &mut self,
        reference: SignedDistance<D>,
        template: SignedDistance<D>,
        settings: Settings,
    ) -> Result<(), Error> {
        settings.validate()?;
        assert_eq!(reference.grid(), Grid::of_level(settings.finest), "the shapes live on the finest level");
        assert_eq!(template.grid(), reference.grid());
        let first = first_level(&settings, [&reference, &template]);
        let number = self.level.number.clamp(first, settings.finest);
        let mut grid = self.grid();
        let mut displacement = self.displacement().to_vec();
        while grid.cells() < 1 << number {
            displacement = prolongate(grid, &displacement);
            grid = Grid::new(2 * grid.cells());
        }
        while grid.cells() > 1 << number {
            displacement = coarsen(grid, &displacement);
            grid = Grid::new(grid.cells() / 2);
        }
        let mut level = Level::new(number, &settings, [&reference, &template], false, Some(displacement));
        level.unfold(&settings).await;
        let evaluation = level.energy().await;
        check_energy(&evaluation)?;
        self.past_evaluations += self.progress.evaluations + 1;
        self.level = level;
        (self.reference, self.template, self.settings) = (reference, template, settings);
        self.inverse.take();
        self.progress = Progress { evaluation, iterations: 0, evaluations: 0, stop: None };
        Ok(())
    }

    /// One iteration, on the next level if this one has ended; nothing once the finest has.
    pub async fn step(&mut self) -> CascadeProgress {
        self.inverse.take();
        if self.progress.stop.is_some() {
            if self.level.number < self.settings.finest {
                let displacement = prolongate(self.grid(), self.level.displacement());
                self.enter(self.level.number + 1, self.level.exchanged, displacement).await;
            } else if self.level.exchanged {
                self.return_roles().await;
            }
        }
        self.progress = self.level.step().await;
        self.progress()
    }

    async fn enter(&mut self, number: u32, exchanged: bool, displacement: Vec<f64>) {
        self.past_evaluations += self.progress.evaluations;
        let shapes = [&self.reference, &self.template];
        self.level = Level::new(number, &self.settings, shapes, exchanged, Some(displacement));
        self.level.unfold(&self.settings).await;
    }

    /// From φ⁻¹, found with the template as the shell, to φ on the finest level. Should it not match, or its nodal
    /// inverse fold, the cascade starts afresh without exchange.
    async fn return_roles(&mut self) {
        let mismatch = self.level.assembler.mismatch_in_cells(&self.progress.evaluation.energies);
        if mismatch < MISMATCH_KEPT
            && let Some(displacement) = invert(self.grid(), self.level.displacement())
        {
            self.enter(self.level.number, false, displacement.clone()).await;
            if self.level.displacement() == displacement.as_slice() {
                self.level.limit_to_refinement();
                return;
            }
        }
        let evaluations = self.past_evaluations + self.progress.evaluations;
        *self = Self::begin(self.reference.clone(), self.template.clone(), self.settings, false).await;
        self.past_evaluations += evaluations;
    }

    /// The state after the last step, or at the start.
    pub fn progress(&self) -> CascadeProgress {
        let last = self.level.number == self.settings.finest && !self.level.exchanged;
        CascadeProgress {
            level: self.level.number,
            iteration: self.progress.iterations,
            evaluations: self.past_evaluations + self.progress.evaluations,
            evaluation: self.progress.evaluation,
            stop: self.progress.stop.filter(|_| last),
        }
    }

    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The current level's grid.
    pub fn grid(&self) -> Grid<D> {
        self.level.assembler.grid()
    }

    /// u = φ − x at the nodes of the current level.
    pub fn displacement(&self) -> &[f64] {
        let displacement = self.level.displacement();
        if !self.level.exchanged {
            return displacement;
        }
        // Where the inverse cannot be found yet, nothing is shown to move.
        let inverse = || invert(self.grid(), displacement).unwrap_or_else(|| vec![0.0; displacement.len()]);
        self.inverse.get_or_init(inverse)
    }

    /// The shapes on the finest level.
    pub fn shapes(&self) -> [&SignedDistance<D>; 2] {
        [&self.reference, &self.template]
    }

    /// The reference on the current level.
    pub fn reference(&self) -> SignedDistance<D> {
        self.reference.to_cells(self.grid().cells())
    }

    /// The template on the current level.
    pub fn template(&self) -> SignedDistance<D> {
        self.template.to_cells(self.grid().cells())
    }

    /// Energies and gradient of the current level at any displacement.
    pub async fn evaluate(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
        if !self.level.exchanged {
            return self.level.assembler.gradient(displacement, gradient).await;
        }
        let functional = self.settings.functional(self.level.number);
        let mut assembler: CpuAssembler<D> = CpuAssembler::new(&functional, &self.reference(), &self.template());
        assembler.gradient(displacement, gradient).await
    }
}

/// The first level whose grid carries both shapes: on a coarser one there would be nothing to match.
fn first_level<const D: usize>(settings: &Settings, shapes: [&SignedDistance<D>; 2]) -> u32 {
    let carries = |level: &u32| shapes.iter().all(|shape| shape.is_carried_by(1 << level));
    (settings.coarsest..settings.finest).find(carries).unwrap_or(settings.finest)
}

fn check_energy(evaluation: &Evaluation) -> Result<(), Error> {
    let Energies { membrane, bending, mismatch, volume } = evaluation.energies;
    let most = GREATEST_ENERGY;
    let terms = [("membrane", membrane), ("bending", bending), ("mismatch", mismatch), ("volume", volume)];
    match terms.into_iter().find(|(_, value)| value.is_nan() || *value > most) {
        Some((term, value)) => Err(Error::NoEnergy { term, value, most }),
        None => Ok(()),
    }
}
