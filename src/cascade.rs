//! Coarse to fine: Algorithm 1 of the paper, one iteration at a time.

use crate::align::similarities;
use crate::assemble::{Assembler, CpuAssembler, Evaluation};
use crate::distance::SignedDistance;
use crate::error::Error;
use crate::grid::Grid;
use crate::minimize::{Minimizer, Ncg, Newton, Progress, Stop};
use crate::prolongation::prolongate;
use crate::settings::{Alignment, MinimizerKind, Settings};

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
}

/// What one level needs.
struct Level<const D: usize> {
    number: u32,
    reference: SignedDistance<D>,
    template: SignedDistance<D>,
    assembler: CpuAssembler<D>,
    minimizer: AnyMinimizer<D>,
}

enum AnyMinimizer<const D: usize> {
    Newton(Newton<D>),
    Ncg(Ncg<D>),
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
    /// Both shapes on the finest level's grid.
    ///
    /// # Errors
    /// A setting out of range.
    pub async fn new(
        reference: SignedDistance<D>,
        template: SignedDistance<D>,
        settings: Settings,
    ) -> Result<Self, Error> {
        settings.validate()?;
        assert_eq!(reference.grid(), Grid::of_level(settings.finest), "the shapes live on the finest level");
        assert_eq!(template.grid(), reference.grid());
        let grid = Grid::<D>::of_level(settings.coarsest);
        let mut start = vec![0.0; grid.node_count() * D];
        let mut level = Level::new(settings.coarsest, &settings, &reference, &template, start.clone());
        let mut evaluation = level.assembler.energy(&start).await;
        let mut evaluations = 1;
        if settings.alignment == Alignment::Similarity {
            for candidate in similarities(grid, &reference, &template) {
                let other = level.assembler.energy(&candidate).await;
                evaluations += 1;
                if other.total() < evaluation.total() {
                    (evaluation, start) = (other, candidate);
                }
            }
            level.restart(&settings, start);
        }
        let progress = Progress { evaluation, iterations: 0, evaluations: 0, stop: None };
        Ok(Self { settings, reference, template, level, past_evaluations: evaluations, progress })
    }

    /// One iteration, on the next level if this one has ended; nothing once the finest has.
    pub async fn step(&mut self) -> CascadeProgress {
        if self.progress.stop.is_some() && self.level.number < self.settings.finest {
            self.past_evaluations += self.progress.evaluations;
            let displacement = prolongate(self.grid(), self.displacement());
            let next = self.level.number + 1;
            self.level = Level::new(next, &self.settings, &self.reference, &self.template, displacement);
            self.unfold().await;
        }
        self.progress = self.level.step().await;
        self.progress()
    }

    /// Starts this level a little nearer to the identity if its first deformation is not admissible.
    ///
    /// A level may end within rounding of a fold, and the interpolant's determinants are rounded differently.
    async fn unfold(&mut self) {
        let given = self.displacement().to_vec();
        let mut displacement = given.clone();
        let mut share = f64::EPSILON;
        while !self.level.assembler.energy(&displacement).await.is_admissible() {
            share = (4.0 * share).min(1.0);
            displacement = given.iter().map(|u| (1.0 - share) * u).collect();
        }
        if share > f64::EPSILON {
            self.level.restart(&self.settings, displacement);
        }
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
        self.level.reference.grid()
    }

    /// u = φ − x at the nodes of the current level.
    pub fn displacement(&self) -> &[f64] {
        match &self.level.minimizer {
            AnyMinimizer::Newton(minimizer) => minimizer.displacement(),
            AnyMinimizer::Ncg(minimizer) => minimizer.displacement(),
        }
    }

    /// The shapes on the current level.
    pub fn reference(&self) -> &SignedDistance<D> {
        &self.level.reference
    }

    pub fn template(&self) -> &SignedDistance<D> {
        &self.level.template
    }

    /// Energies and gradient of the current level at any displacement.
    pub async fn evaluate(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
        self.level.assembler.gradient(displacement, gradient).await
    }
}

impl<const D: usize> Level<D> {
    fn new(
        number: u32,
        settings: &Settings,
        reference: &SignedDistance<D>,
        template: &SignedDistance<D>,
        displacement: Vec<f64>,
    ) -> Self {
        let cells = 1 << number;
        let (reference, template) = (reference.to_cells(cells), template.to_cells(cells));
        let assembler = CpuAssembler::new(&settings.functional(number), &reference, &template);
        let minimizer = AnyMinimizer::new(settings, reference.grid(), displacement);
        Self { number, reference, template, assembler, minimizer }
    }

    fn restart(&mut self, settings: &Settings, displacement: Vec<f64>) {
        self.minimizer = AnyMinimizer::new(settings, self.reference.grid(), displacement);
    }

    async fn step(&mut self) -> Progress {
        match &mut self.minimizer {
            AnyMinimizer::Newton(minimizer) => minimizer.step(&mut self.assembler).await,
            AnyMinimizer::Ncg(minimizer) => minimizer.step(&mut self.assembler).await,
        }
    }
}

impl<const D: usize> AnyMinimizer<D> {
    fn new(settings: &Settings, grid: Grid<D>, displacement: Vec<f64>) -> Self {
        match settings.minimizer {
            MinimizerKind::Newton => Self::Newton(Newton::new(grid, displacement, settings.tolerance)),
            MinimizerKind::Ncg => Self::Ncg(Ncg::new(grid, displacement, settings.sobolev, settings.tolerance)),
        }
    }
}
