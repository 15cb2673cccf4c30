//! The default minimiser: projected Gauss–Newton, each system solved loosely by multigrid.

use super::{Decrease, Minimizer, Progress, Stop};
use crate::assemble::step::{FORCING, MOST_HALVINGS, MOST_LINEAR_STEPS, is_enough};
use crate::assemble::{Assembler, Evaluation};
use crate::grid::Grid;
use crate::multigrid::Multigrid;

/// Iterations over which the relative decrease is judged.
const WINDOW: usize = 3;
const MAX_ITERATIONS: usize = 200;
/// Iterations in which the energy must fall by this share: what goes slower than that is no longer Newton's method.
const CREEP_WINDOW: usize = 20;
const CREEP: f64 = 0.01;
/// Relative decrease of the energy below which the next iteration keeps the hessian there is: assembling it anew costs
/// more than everything else in an iteration and would change the direction by no more than that.
const SETTLED: f64 = 1e-3;
/// Levenberg shifts, in units of the mean diagonal entry; none at first.
const FIRST_SHIFT: f32 = 1e-3;
/// One nearly folded cell can be this much stiffer than the mean; only its own hessian makes its step short enough.
const LAST_SHIFT: f32 = 1e12;

/// A direction along which a node would move by more boxes than this is not followed. Even halved `MOST_HALVINGS` times it
/// leads far beyond the box, and the displacement that it was added to would not come back when it is taken away.
const LONGEST: f64 = 1e4;

/// Solves (H + s·I) d = ∇E, H the positive semi-definite hessian, and goes against d as far as the energy falls.
pub struct Newton<const D: usize> {
    multigrid: Multigrid<D>,
    pub(super) displacement: Vec<f64>,
    /// ∇E, then d.
    direction: Vec<f64>,
    pub(super) course: Course,
}

/// How the iterations have gone, whoever makes them.
pub(super) struct Course {
    /// s in units of the mean diagonal entry of H.
    pub shift: f32,
    /// The hessian of an iteration before still serves.
    pub settled: bool,
    decrease: Decrease,
    creep: Decrease,
    progress: Option<Progress>,
}

impl Course {
    pub fn new(tolerance: f64) -> Self {
        Self {
            shift: 0.0,
            settled: false,
            decrease: Decrease::new(WINDOW, tolerance),
            creep: Decrease::new(CREEP_WINDOW, CREEP),
            progress: None,
        }
    }

    pub fn restart(&mut self) {
        self.shift = 0.0;
        self.settled = false;
        self.decrease.restart();
        self.creep.restart();
        self.progress = None;
    }

    /// The state before the next iteration; the last one if it has stopped.
    pub fn progress(&self) -> Progress {
        self.progress.unwrap_or_default()
    }

    /// A direction was worth no step: for a more cautious one.
    pub fn raise_shift(&mut self) {
        self.shift = (10.0 * self.shift).max(FIRST_SHIFT);
    }

    /// Whether there is a more cautious one to be tried.
    pub fn may_go_on(&self) -> bool {
        self.shift <= LAST_SHIFT
    }

    /// Goes on after all, because the displacement was lost with the last steps.
    #[cfg(feature = "gpu")]
    pub fn resume(&mut self) -> Progress {
        self.settled = false;
        self.decrease.restart();
        self.creep.restart();
        let progress = Progress { stop: None, ..self.progress() };
        self.progress = Some(progress);
        progress
    }

    /// The state after an iteration that has made this step, or none.
    pub fn after(&mut self, moved: Option<Step>, mut progress: Progress) -> Progress {
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
}

impl<const D: usize> Newton<D> {
    /// `tolerance` is the relative decrease over three iterations below which the minimiser stops.
    pub fn new(grid: Grid<D>, displacement: Vec<f64>, tolerance: f64) -> Self {
        let count = displacement.len();
        Self {
            multigrid: Multigrid::new(grid),
            displacement,
            direction: vec![0.0; count],
            course: Course::new(tolerance),
        }
    }

    /// Begins again from another displacement, with all the memory there is.
    pub fn restart(&mut self, displacement: Vec<f64>) {
        assert_eq!(displacement.len(), self.displacement.len());
        self.displacement = displacement;
        self.course.restart();
    }

    /// Gives back what only further iterations would need.
    pub fn rest(&mut self) {
        self.multigrid = Multigrid::new(Grid::of_level(1));
        self.direction = Vec::new();
    }

    /// Solves for the direction and goes along it: the whole step, or halved until the energy falls enough. None, and
    /// nothing has moved but by rounding, if it does not. Where d will be, ∇E is.
    async fn advance(
        &mut self,
        assembler: &mut impl Assembler<D>,
        before: Evaluation,
        progress: &mut Progress,
    ) -> Option<Step> {
        progress.evaluations += 1;
        // This solves H d = +∇E: the way down is against it.
        let slope = -self.multigrid.solve(&mut self.direction, FORCING, MOST_LINEAR_STEPS).product;
        let is_too_long = self.direction.iter().any(|d| d.abs() > LONGEST);
        if slope >= 0.0 || slope.is_nan() || is_too_long {
            return None;
        }
        let mut step = 1.0;
        self.move_along(-step);
        for _ in 0..=MOST_HALVINGS {
            let evaluation = assembler.energy(&self.displacement).await;
            progress.evaluations += 1;
            if is_enough(&before, &evaluation, step, slope) {
                progress.evaluation = evaluation;
                return Some(Step { whole: step == 1.0, decrease: before.total() - evaluation.total() });
            }
            step *= 0.5;
            self.move_along(step);
        }
        self.move_along(step);
        None
    }

    /// u += s d.
    fn move_along(&mut self, step: f64) {
        for (u, d) in self.displacement.iter_mut().zip(&self.direction) {
            *u += step * d;
        }
    }
}

/// A step that was taken.
pub(super) struct Step {
    pub whole: bool,
    /// Of the energy.
    pub decrease: f64,
}

impl<const D: usize> Minimizer<D> for Newton<D> {
    async fn step(&mut self, assembler: &mut impl Assembler<D>) -> Progress {
        let mut progress = self.course.progress();
        if progress.stop.is_some() {
            return progress;
        }
        progress.iterations += 1;
        let mut moved = None;
        if self.course.settled {
            let before = assembler.gradient(&self.displacement, &mut self.direction).await;
            moved = self.advance(assembler, before, &mut progress).await;
        }
        if moved.is_none() {
            let operator = self.multigrid.operator_mut();
            let before = assembler.hessian(&self.displacement, &mut self.direction, operator).await;
            progress.evaluation = before;
            let mut mean = None;
            let mut added = 0.0;
            while moved.is_none() && self.course.may_go_on() {
                if self.course.shift > 0.0 {
                    let wanted =
                        self.course.shift * *mean.get_or_insert_with(|| self.multigrid.operator_mut().mean_diagonal());
                    self.multigrid.operator_mut().add_to_diagonal(wanted - added);
                    added = wanted;
                }
                self.multigrid.prepare();
                moved = self.advance(assembler, before, &mut progress).await;
                if moved.is_none() {
                    self.course.raise_shift();
                    assembler.gradient(&self.displacement, &mut self.direction).await;
                }
            }
        }
        self.course.after(moved, progress)
    }

    fn displacement(&self) -> &[f64] {
        &self.displacement
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::Energies;
    use crate::ready::ready;
    use crate::stencil::StencilOperator;

    /// A slope that hardly anything resists.
    struct Slide(Grid<2>);

    impl Assembler<2> for Slide {
        fn grid(&self) -> Grid<2> {
            self.0
        }

        async fn energy(&mut self, displacement: &[f64]) -> Evaluation {
            let energies = Energies { mismatch: displacement.iter().map(|u| u.abs()).sum(), ..Energies::default() };
            Evaluation { energies, least_determinant: 1.0 }
        }

        async fn gradient(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
            gradient.fill(1.0);
            self.energy(displacement).await
        }

        async fn hessian(
            &mut self,
            displacement: &[f64],
            gradient: &mut [f64],
            operator: &mut StencilOperator<2>,
        ) -> Evaluation {
            operator.clear();
            operator.add_to_diagonal(1e-20);
            self.gradient(displacement, gradient).await
        }
    }

    #[test]
    fn a_direction_beyond_all_measure_leaves_the_displacement_alone() {
        let grid = Grid::of_level(3);
        let displacement: Vec<f64> = (0..2 * grid.node_count()).map(|k| 0.1 * (k as f64).sin()).collect();
        let mut newton = Newton::new(grid, displacement.clone(), 1e-4);
        let progress = ready(newton.step(&mut Slide(grid)));
        assert_eq!(progress.stop, Some(Stop::NoDescent));
        assert_eq!(newton.displacement(), displacement);
    }
}
