//! The default minimiser: projected Gauss–Newton, each system solved loosely by multigrid.

use super::{Decrease, Minimizer, Progress, Stop, inner};
use crate::assemble::{Assembler, Evaluation};
use crate::energy::Energies;
use crate::grid::Grid;
use crate::multigrid::Multigrid;

/// Iterations over which the relative decrease is judged.
const WINDOW: usize = 3;
const MAX_ITERATIONS: usize = 200;
/// Iterations in which the energy must fall by this share: what goes slower than that is no longer Newton's method.
const CREEP_WINDOW: usize = 20;
const CREEP: f64 = 0.01;
/// The linear system is solved to this relative residual: a more exact direction of an inexact model does not pay.
const FORCING: f64 = 0.1;
const MAX_LINEAR_ITERATIONS: usize = 40;
/// Sufficient decrease, as a share of the slope.
const ARMIJO: f64 = 1e-4;
/// Halvings of a step before the direction is given up for a shorter, more cautious one.
const MAX_HALVINGS: usize = 6;
/// A step leaves at least this share of the least determinant: next to a fold the quadratic model is worthless, and
/// a weak volume energy would not keep the iterates away from there.
const DETERMINANT_KEPT: f64 = 0.2;
/// Relative decrease of the energy below which the next iteration keeps the hessian there is: assembling it anew costs
/// more than everything else in an iteration and would change the direction by no more than that.
const SETTLED: f64 = 1e-3;
/// Levenberg shifts, in units of the mean diagonal entry; none at first.
const FIRST_SHIFT: f32 = 1e-3;
/// One nearly folded cell can be this much stiffer than the mean; only its own hessian makes its step short enough.
const LAST_SHIFT: f32 = 1e12;

/// Solves (H + s·I) d = ∇E, H the positive semi-definite hessian, and goes against d as far as the energy falls.
pub struct Newton<const D: usize> {
    multigrid: Multigrid<D>,
    displacement: Vec<f64>,
    trial: Vec<f64>,
    gradient: Vec<f64>,
    direction: Vec<f64>,
    shift: f32,
    /// The hessian of an iteration before still serves.
    settled: bool,
    decrease: Decrease,
    creep: Decrease,
    progress: Option<Progress>,
}

impl<const D: usize> Newton<D> {
    /// `tolerance` is the relative decrease over three iterations below which the minimiser stops.
    pub fn new(grid: Grid<D>, displacement: Vec<f64>, tolerance: f64) -> Self {
        let count = displacement.len();
        Self {
            multigrid: Multigrid::new(grid),
            displacement,
            trial: vec![0.0; count],
            gradient: vec![0.0; count],
            direction: vec![0.0; count],
            shift: 0.0,
            settled: false,
            decrease: Decrease::new(WINDOW, tolerance),
            creep: Decrease::new(CREEP_WINDOW, CREEP),
            progress: None,
        }
    }

    /// Begins again from another displacement, with all the memory there is.
    pub fn restart(&mut self, displacement: Vec<f64>) {
        assert_eq!(displacement.len(), self.displacement.len());
        self.displacement = displacement;
        self.shift = 0.0;
        self.settled = false;
        self.decrease.restart();
        self.creep.restart();
        self.progress = None;
    }

    /// Solves for the direction and goes along it: the whole step, or halved until the energy falls enough. None, and
    /// nothing has moved, if it does not. `gradient` holds ∇E.
    async fn advance(
        &mut self,
        assembler: &mut impl Assembler<D>,
        before: Evaluation,
        progress: &mut Progress,
    ) -> Option<Step> {
        progress.evaluations += 1;
        self.multigrid.solve(&self.gradient, FORCING, MAX_LINEAR_ITERATIONS, &mut self.direction);
        // `direction` solves H d = +∇E: the way down is against it.
        let slope = -inner(&self.gradient, &self.direction);
        if slope >= 0.0 || slope.is_nan() {
            return None;
        }
        let mut step = 1.0;
        for _ in 0..=MAX_HALVINGS {
            for (t, (u, d)) in self.trial.iter_mut().zip(self.displacement.iter().zip(&self.direction)) {
                *t = u - step * d;
            }
            let evaluation = assembler.energy(&self.trial).await;
            progress.evaluations += 1;
            let enough = evaluation.total() <= before.total() + ARMIJO * step * slope;
            if enough && evaluation.least_determinant >= DETERMINANT_KEPT * before.least_determinant {
                std::mem::swap(&mut self.displacement, &mut self.trial);
                progress.evaluation = evaluation;
                return Some(Step { whole: step == 1.0, decrease: before.total() - evaluation.total() });
            }
            step *= 0.5;
        }
        None
    }
}

/// A step that was taken.
struct Step {
    whole: bool,
    /// Of the energy.
    decrease: f64,
}

impl<const D: usize> Minimizer<D> for Newton<D> {
    async fn step(&mut self, assembler: &mut impl Assembler<D>) -> Progress {
        if let Some(progress) = self.progress
            && progress.stop.is_some()
        {
            return progress;
        }
        let mut progress = self.progress.unwrap_or(Progress {
            evaluation: Evaluation { energies: Energies::default(), least_determinant: 0.0 },
            iterations: 0,
            evaluations: 0,
            stop: None,
        });
        progress.iterations += 1;
        let mut moved = None;
        if self.settled {
            let before = assembler.gradient(&self.displacement, &mut self.gradient).await;
            moved = self.advance(assembler, before, &mut progress).await;
        }
        if moved.is_none() {
            let operator = self.multigrid.operator_mut();
            let before = assembler.hessian(&self.displacement, &mut self.gradient, operator).await;
            progress.evaluation = before;
            let mut mean = None;
            let mut added = 0.0;
            while moved.is_none() && self.shift <= LAST_SHIFT {
                if self.shift > 0.0 {
                    let wanted =
                        self.shift * *mean.get_or_insert_with(|| self.multigrid.operator_mut().mean_diagonal());
                    self.multigrid.operator_mut().add_to_diagonal(wanted - added);
                    added = wanted;
                }
                self.multigrid.prepare();
                moved = self.advance(assembler, before, &mut progress).await;
                if moved.is_none() {
                    self.shift = (10.0 * self.shift).max(FIRST_SHIFT);
                }
            }
        }
        match moved {
            None => progress.stop = Some(Stop::NoDescent),
            Some(Step { whole, decrease }) => {
                let total = progress.evaluation.total();
                self.settled = whole && self.shift == 0.0 && decrease <= SETTLED * total;
                if whole {
                    self.shift = if self.shift > FIRST_SHIFT { 0.1 * self.shift } else { 0.0 };
                }
                let creeping = self.creep.is_small(total);
                if self.decrease.is_small(total) {
                    progress.stop = Some(Stop::Converged);
                } else if creeping {
                    progress.stop = Some(Stop::Creeping);
                }
            }
        }
        if progress.stop.is_none() && progress.iterations >= MAX_ITERATIONS {
            progress.stop = Some(Stop::IterationLimit);
        }
        self.progress = Some(progress);
        progress
    }

    fn displacement(&self) -> &[f64] {
        &self.displacement
    }
}
