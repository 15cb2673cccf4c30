//! Minimisers of one level's energy. One object, one `step` an iteration: pausing is not calling it, cancelling is
//! dropping it.

mod line_search;
mod ncg;
mod newton;
#[cfg(feature = "gpu")]
mod resident;

pub use ncg::Ncg;
pub use newton::Newton;
#[cfg(feature = "gpu")]
pub use resident::Resident;

use crate::assemble::{Assembler, Evaluation};
use std::fmt;

/// Why a minimiser ended, as a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The energy no longer falls by more than the relative tolerance.
    Converged,
    /// The energy still falls, but hardly: the shell crumples or slides, which nothing is gained by following.
    Creeping,
    /// No step along a descent direction lowers the energy: rounding, or a fold in the way.
    NoDescent,
    /// The limit of iterations a level is reached.
    IterationLimit,
    /// The few iterations that were to refine a match are done.
    Refined,
    /// The best of several matches was taken.
    BestOf,
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Stop::Converged => "Converged: the energy falls by less than the tolerance.",
            Stop::Creeping => "Stopped: twenty iterations lower the energy by less than a hundredth.",
            Stop::NoDescent => "Stopped: no step along the descent direction lowers the energy any further.",
            Stop::Refined => "Done: a match found another way was refined by a few iterations.",
            Stop::BestOf => "Done: of several ways to match, the best.",
            Stop::IterationLimit => "Stopped: the limit of iterations on one level is reached.",
        })
    }
}

/// The state after an iteration.
#[derive(Clone, Copy, Debug, Default)]
pub struct Progress {
    pub evaluation: Evaluation,
    /// Iterations done so far.
    pub iterations: usize,
    /// Evaluations of the energy so far, with or without derivatives.
    pub evaluations: usize,
    pub stop: Option<Stop>,
}

/// Minimises over nodal displacements, starting from an admissible one.
#[allow(async_fn_in_trait, reason = "used by static dispatch within one thread only")]
pub trait Minimizer<const D: usize> {
    /// Does one iteration; does nothing once stopped.
    async fn step(&mut self, assembler: &mut impl Assembler<D>) -> Progress;

    fn displacement(&self) -> &[f64];
}

fn inner(a: &[f64], b: &[f64]) -> f64 {
    // Four accumulators: one would wait for itself at every addition.
    let mut sums = [0.0; 4];
    let (a4, b4) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a4.remainder().iter().zip(b4.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a4.zip(b4) {
        for k in 0..4 {
            sums[k] += x[k] * y[k];
        }
    }
    sums[0] + sums[1] + sums[2] + sums[3] + rest
}

/// The energies of past iterations: has the relative decrease over a window become small?
struct Decrease {
    window: usize,
    tolerance: f64,
    energies: Vec<f64>,
}

impl Decrease {
    fn new(window: usize, tolerance: f64) -> Self {
        Self { window, tolerance, energies: Vec::new() }
    }

    fn restart(&mut self) {
        self.energies.clear();
    }

    /// Takes the next energy; true once it lies within the tolerance of the one `window` iterations ago.
    fn is_small(&mut self, energy: f64) -> bool {
        self.energies.push(energy);
        if self.energies.len() > self.window + 1 {
            self.energies.remove(0);
        }
        self.energies.len() > self.window && self.energies[0] - energy <= self.tolerance * energy.abs()
    }
}
