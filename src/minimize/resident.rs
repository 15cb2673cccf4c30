//! Newton's method where the displacement stays with who computes: a graphics card.

use super::newton::{Course, Step};
use super::{Minimizer, Newton, Progress};
use crate::assemble::Assembler;
use crate::assemble::step::{Ask, Renewal};
use crate::grid::Grid;
use std::mem::swap;

/// [`Newton`] with its displacement left to the assembler as long as that keeps it; it takes the same steps.
pub struct Resident<const D: usize> {
    grid: Grid<D>,
    course: Course,
    /// The last that was here.
    displacement: Vec<f64>,
    is_away: bool,
    /// Made when an iteration is to be made here.
    here: Option<Box<Newton<D>>>,
}

impl<const D: usize> Resident<D> {
    /// As [`Newton::new`].
    pub fn new(grid: Grid<D>, displacement: Vec<f64>, tolerance: f64) -> Self {
        Self { grid, course: Course::new(tolerance), displacement, is_away: false, here: None }
    }

    /// Begins again from another displacement, with all the memory there is.
    pub fn restart(&mut self, displacement: Vec<f64>) {
        assert_eq!(displacement.len(), self.displacement.len());
        self.displacement = displacement;
        self.is_away = false;
        self.course.restart();
    }

    /// Gives back what only further iterations would need.
    pub fn rest(&mut self) {
        self.here = None;
    }

    /// An iteration with the assembler; None, with nothing changed but the shift, if it does not keep the displacement.
    async fn step_away(&mut self, assembler: &mut impl Assembler<D>) -> Option<Progress> {
        let mut progress = self.course.progress();
        progress.iterations += 1;
        let mut renewal = if self.course.settled { Renewal::Gradient } else { Renewal::Hessian };
        let mut moved = None;
        while moved.is_none() && self.course.may_go_on() {
            let start = (!self.is_away).then_some(self.displacement.as_slice());
            let attempt = assembler.attempt(start, &Ask { renewal, shift: self.course.shift }).await?;
            self.is_away = true;
            progress.evaluations += attempt.evaluations;
            progress.evaluation = attempt.before;
            if let Some((length, after)) = attempt.taken {
                progress.evaluation = after;
                moved = Some(Step { whole: length == 1.0, decrease: attempt.before.total() - after.total() });
            } else if renewal == Renewal::Gradient {
                renewal = Renewal::Hessian;
            } else {
                self.course.raise_shift();
                renewal = Renewal::Shift;
            }
        }
        Some(self.course.after(moved, progress))
    }

    async fn step_here(&mut self, assembler: &mut impl Assembler<D>) -> Progress {
        if std::mem::take(&mut self.is_away) {
            // What is lost with a device are the steps since the displacement was last asked for.
            let _ = assembler.fetch(&mut self.displacement).await;
            self.course.settled = false;
        }
        let new = || Box::new(Newton::new(self.grid, self.displacement.clone(), 0.0));
        let newton = self.here.get_or_insert_with(new);
        swap(&mut newton.course, &mut self.course);
        swap(&mut newton.displacement, &mut self.displacement);
        let progress = newton.step(assembler).await;
        swap(&mut newton.course, &mut self.course);
        swap(&mut newton.displacement, &mut self.displacement);
        progress
    }

    /// Brings the displacement up to date. None if it is lost with who kept it: then the next step goes on from the last
    /// one that was known.
    pub async fn fetch(&mut self, assembler: &mut impl Assembler<D>) -> Option<()> {
        if self.is_away { assembler.fetch(&mut self.displacement).await } else { Some(()) }
    }
}

impl<const D: usize> Minimizer<D> for Resident<D> {
    async fn step(&mut self, assembler: &mut impl Assembler<D>) -> Progress {
        if self.course.progress().stop.is_some() {
            return self.course.progress();
        }
        let mut progress = match self.step_away(assembler).await {
            Some(progress) => progress,
            None => self.step_here(assembler).await,
        };
        if progress.stop.is_some() && self.fetch(assembler).await.is_none() {
            self.is_away = false;
            progress = self.course.resume();
        }
        progress
    }

    /// The last that was fetched; once stopped, the present one.
    fn displacement(&self) -> &[f64] {
        &self.displacement
    }
}
