//! The paper's minimiser: Fletcher–Reeves in a Sobolev metric that sharpens as it goes.

use super::line_search::{Next, StrongWolfe, Trial};
use super::{Decrease, Minimizer, Progress, Stop, inner};
use crate::assemble::{Assembler, Evaluation};
use crate::grid::Grid;
use crate::metric::SobolevMetric;

/// Iterations over which the relative decrease is judged: single steps of a gradient method vary too much.
const WINDOW: usize = 10;
const MAX_ITERATIONS: usize = 4000;

/// Nonlinear conjugate gradients, s = (1 − β²/2 Δ)⁻¹ ∇E.
///
/// d ← −s + γ d with Fletcher–Reeves' γ = ⟨∇E, s⟩ / ⟨∇E, s⟩_before; a strong Wolfe line search; a restart whenever d is
/// no descent direction. A large β moves large regions together; once the energy stalls, β is halved, down to h.
pub struct Ncg<const D: usize> {
    metric: SobolevMetric<D>,
    beta: f64,
    spacing: f64,
    displacement: Vec<f64>,
    trial: Vec<f64>,
    gradient: Vec<f64>,
    trial_gradient: Vec<f64>,
    direction: Vec<f64>,
    smooth: Vec<f64>,
    /// ⟨∇E, s⟩ at the iteration before, none after a restart.
    square: Option<f64>,
    step: f64,
    decrease: Decrease,
    progress: Option<Progress>,
}

impl<const D: usize> Ncg<D> {
    /// `beta` is the largest β in domain units; `tolerance` the relative decrease over ten iterations below which β is
    /// halved and, once β has reached h, the minimiser stops.
    pub fn new(grid: Grid<D>, displacement: Vec<f64>, beta: f64, tolerance: f64) -> Self {
        let zero = vec![0.0; displacement.len()];
        Self {
            metric: SobolevMetric::new(grid),
            beta: beta.max(grid.spacing()),
            spacing: grid.spacing(),
            displacement,
            trial: zero.clone(),
            gradient: zero.clone(),
            trial_gradient: zero.clone(),
            direction: zero.clone(),
            smooth: zero,
            square: None,
            step: 1.0,
            decrease: Decrease::new(WINDOW, tolerance),
            progress: None,
        }
    }

    fn restart(&mut self) {
        self.square = None;
        self.decrease.restart();
    }

    /// Sets the search direction; returns its slope.
    fn choose_direction(&mut self) -> f64 {
        self.smooth.copy_from_slice(&self.gradient);
        self.metric.solve(self.beta, &mut self.smooth);
        let square = inner(&self.gradient, &self.smooth);
        let gamma = self.square.map_or(0.0, |before| square / before);
        for (d, s) in self.direction.iter_mut().zip(&self.smooth) {
            *d = gamma * *d - s;
        }
        let mut slope = inner(&self.gradient, &self.direction);
        if gamma != 0.0 && slope >= 0.0 {
            for (d, s) in self.direction.iter_mut().zip(&self.smooth) {
                *d = -s;
            }
            slope = -square;
        }
        self.square = Some(square);
        slope
    }

    /// Moves along the direction; none if no step lowers the energy.
    async fn search(
        &mut self,
        assembler: &mut impl Assembler<D>,
        value: f64,
        slope: f64,
    ) -> (usize, Option<Evaluation>) {
        let mut wolfe = StrongWolfe::new(value, slope);
        let mut evaluations = 0;
        let mut tried = f64::NAN;
        let mut step = self.step;
        let mut evaluation = None;
        loop {
            for (t, (u, d)) in self.trial.iter_mut().zip(self.displacement.iter().zip(&self.direction)) {
                *t = u + step * d;
            }
            if tried != step {
                evaluation = Some(assembler.gradient(&self.trial, &mut self.trial_gradient).await);
                evaluations += 1;
                tried = step;
            }
            let value = evaluation.map_or(f64::INFINITY, |e| e.total());
            let slope = if value.is_finite() { inner(&self.trial_gradient, &self.direction) } else { f64::NAN };
            match wolfe.next(Trial { step, value, slope }) {
                Next::Try(next) => step = next,
                Next::Fail => return (evaluations, None),
                Next::Accept(accepted) => {
                    if accepted != tried {
                        for (t, (u, d)) in self.trial.iter_mut().zip(self.displacement.iter().zip(&self.direction)) {
                            *t = u + accepted * d;
                        }
                        evaluation = Some(assembler.gradient(&self.trial, &mut self.trial_gradient).await);
                        evaluations += 1;
                    }
                    std::mem::swap(&mut self.displacement, &mut self.trial);
                    std::mem::swap(&mut self.gradient, &mut self.trial_gradient);
                    self.step = accepted;
                    return (evaluations, evaluation);
                }
            }
        }
    }
}

impl<const D: usize> Minimizer<D> for Ncg<D> {
    async fn step(&mut self, assembler: &mut impl Assembler<D>) -> Progress {
        let mut progress = match self.progress {
            Some(progress) => progress,
            None => {
                let evaluation = assembler.gradient(&self.displacement, &mut self.gradient).await;
                Progress { evaluation, iterations: 0, evaluations: 1, stop: None }
            }
        };
        if progress.stop.is_none() {
            let slope = self.choose_direction();
            let (evaluations, moved) = self.search(assembler, progress.evaluation.total(), slope).await;
            progress.evaluations += evaluations;
            progress.iterations += 1;
            let exhausted = match moved {
                Some(evaluation) => {
                    progress.evaluation = evaluation;
                    self.decrease.is_small(evaluation.total())
                }
                None => true,
            };
            if progress.iterations >= MAX_ITERATIONS {
                progress.stop = Some(Stop::IterationLimit);
            } else if exhausted && self.beta > self.spacing {
                self.beta = (0.5 * self.beta).max(self.spacing);
                self.step = 1.0;
                self.restart();
            } else if exhausted && moved.is_some() {
                progress.stop = Some(Stop::Converged);
            } else if exhausted {
                progress.stop = Some(Stop::NoDescent);
            }
        }
        self.progress = Some(progress);
        progress
    }

    fn displacement(&self) -> &[f64] {
        &self.displacement
    }
}
