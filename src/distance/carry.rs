//! Which grids carry a shape: a sliver, a speck or a thin ring falls between the nodes of a coarse one.

use super::SignedDistance;
use crate::error::ShapeError;

/// A grid carries a shape if the outline's measure that it sees is within this factor of the truth. A quarter of the
/// thinnest parts may be missing from a coarse level (the next ones bring them); half of everything may not.
const FACTOR: f64 = 2.0;

/// The least share of the outline that must be seen by the grid on which a shape is to be matched in the end.
const LEAST_SHARE: f64 = 1.0 / 3.0;

/// A shape nowhere deeper than this, in cells, is a line to the grid: its outline's two sides would be told apart by
/// rounding.
const LEAST_DEPTH: f64 = 1e-3;

impl<const D: usize> SignedDistance<D> {
    /// Whether the outline, looked at on `cells` cells a side, still is what it is on this grid.
    ///
    /// # Panics
    ///
    /// Unless `cells` divides this grid's number of cells.
    pub fn is_carried_by(&self, cells: usize) -> bool {
        assert!(self.grid.cells().is_multiple_of(cells), "{cells} cells are not nested in {}", self.grid.cells());
        let step = self.grid.cells() / cells;
        let (seen, whole) = (self.outline_measure(step), self.outline_measure(1));
        self.depth(step) >= LEAST_DEPTH && FACTOR * seen >= whole && seen <= FACTOR * whole
    }

    /// Whether this grid holds nodes inside the shape, and enough of them. `whole` is the measure of the true outline in
    /// the sense of [`outline_measure`](Self::outline_measure).
    ///
    /// # Errors
    ///
    /// [`ShapeError::TooSmall`], [`ShapeError::TooThin`].
    pub(super) fn check_resolved(&self, whole: f64) -> Result<(), ShapeError> {
        let cells = self.grid.cells();
        if self.depth(1) < LEAST_DEPTH {
            return Err(ShapeError::TooSmall { cells });
        }
        let share = self.outline_measure(1) / whole;
        if share < LEAST_SHARE { Err(ShapeError::TooThin { share, cells }) } else { Ok(()) }
    }

    /// How deep in the shape a node of the grid lies that has every `step`-th node, in cells of that grid.
    fn depth(&self, step: usize) -> f64 {
        let deepest = self.nodes_of(step).fold(0.0_f64, |least, node| least.min(self.values[node]));
        -deepest * (self.grid.cells() / step) as f64
    }

    /// The nodes of the grid that has every `step`-th.
    fn nodes_of(&self, step: usize) -> impl Iterator<Item = usize> {
        (0..self.values.len()).filter(move |&node| self.grid.node_index(node).iter().all(|i| i % step == 0))
    }

    /// Σ_axis ∫ |n_axis| over the outline, by Cauchy and Crofton: the edges that change sign of the grid that has every
    /// `step`-th node, times what an edge stands for.
    pub(super) fn outline_measure(&self, step: usize) -> f64 {
        let negative = |node: usize| self.values[node] < 0.0;
        let mut crossed = 0_usize;
        for node in self.nodes_of(step) {
            let index = self.grid.node_index(node);
            let ahead = (0..D).filter(|&axis| index[axis] < self.grid.cells());
            crossed += ahead.filter(|&axis| negative(node) != negative(node + step * self.grid.stride(axis))).count();
        }
        crossed as f64 * (step as f64 * self.grid.spacing()).powi(D as i32 - 1)
    }
}
