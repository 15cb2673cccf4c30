//! Signed distance functions on the nodes of a grid: the form in which shapes enter the energy.
//!
//! d(x) = ± dist(x, M), positive outside M and negative inside, in domain units (the box is `[0,1]^D`).
//! [`SignedDistance::from_loops`] makes one of polygons, [`SignedDistance::from_mask`] of a picture,
//! [`SignedDistance::from_mesh`] of triangles, [`SignedDistance::redistance`] of any level set; [`SignedDistance::from_level_set`] takes nodal values as they are.

mod carry;
mod level_set;
mod march;
mod mask;
mod mesh;
mod nearest;
mod outline;
mod polygon;
mod project;
mod winding;

use crate::error::ShapeError;
use crate::grid::Grid;
use crate::hypersurface::Hypersurface;
use std::sync::Arc;

/// Cells that a shape keeps from the border, so that fits and differences around it stay inside the box.
pub const CLEARANCE: f64 = 2.0;

/// Nodal signed distance on a grid: positive outside, negative inside, domain units, x fastest.
#[derive(Clone, Debug)]
pub struct SignedDistance<const D: usize> {
    grid: Grid<D>,
    /// Copies share them.
    values: Arc<Vec<f64>>,
    /// The outline as it was given, where it was; of nodal values it is their zero set.
    outline: Option<Arc<Hypersurface<D>>>,
}

impl<const D: usize> SignedDistance<D> {
    pub fn grid(&self) -> Grid<D> {
        self.grid
    }

    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Nodal values that are known to be in order; nothing is checked but their number.
    ///
    /// # Panics
    ///
    /// If there is not one value a node.
    pub fn from_nodal(grid: Grid<D>, values: Vec<f64>) -> Self {
        assert_eq!(values.len(), grid.node_count(), "one value a node");
        Self { grid, values: Arc::new(values), outline: None }
    }

    /// The outline: as it was given, or the zero set of the values where only these are known.
    pub fn outline(&self) -> Arc<Hypersurface<D>> {
        let zero_set = || Arc::new(Hypersurface::zero_set(self.grid, &self.values));
        self.outline.clone().unwrap_or_else(zero_set)
    }

    /// The same on `cells` cells a side, sharing the values if these are its own: injection at the common nodes if coarser, multilinear interpolation if finer.
    ///
    /// # Panics
    ///
    /// Unless one number of cells divides the other.
    pub fn to_cells(&self, cells: usize) -> Self {
        let (from, to) = (self.grid, Grid::<D>::new(cells));
        if cells == from.cells() {
            return self.clone();
        }
        if cells < from.cells() {
            assert!(from.cells().is_multiple_of(cells), "{cells} cells are not nested in {}", from.cells());
            let step = from.cells() / cells;
            let values = (0..to.node_count())
                .map(|node| self.values[from.node(to.node_index(node).map(|i| i * step))])
                .collect();
            // Details that a coarser grid does not see are no part of what it looks at.
            return Self { grid: to, values: Arc::new(values), outline: None };
        }
        assert!(cells.is_multiple_of(from.cells()), "{} cells are not nested in {cells}", from.cells());
        let step = cells / from.cells();
        let offsets = from.corner_offsets();
        let values = (0..to.node_count())
            .map(|node| {
                let index = to.node_index(node);
                let cell = index.map(|i| (i / step).min(from.cells() - 1));
                let lowest = from.node(cell);
                (0..Grid::<D>::CORNERS)
                    .map(|corner| {
                        let weight: f64 = (0..D)
                            .map(|axis| {
                                let t = (index[axis] - cell[axis] * step) as f64 / step as f64;
                                if corner >> axis & 1 == 1 { t } else { 1.0 - t }
                            })
                            .product();
                        weight * self.values[lowest + offsets[corner]]
                    })
                    .sum()
            })
            .collect();
        Self { grid: to, values: Arc::new(values), outline: self.outline.clone() }
    }

    /// Whether the body keeps [`CLEARANCE`] cells of a grid of `cells` cells a side from the border of the box.
    ///
    /// The grid asked about may be coarser than this one: there the same distance is fewer cells.
    pub fn check_clearance(&self, cells: usize) -> Result<(), ShapeError> {
        let (low, high) = self.extent();
        check_clearance(low, high, cells)
    }

    /// The lower and the upper corner of the box around the body: inner nodes and zeros on the grid's edges.
    fn extent(&self) -> ([f64; D], [f64; D]) {
        let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
        let spacing = self.grid.spacing();
        for (node, &value) in self.values.iter().enumerate().filter(|(_, value)| **value < 0.0) {
            let index = self.grid.node_index(node);
            for axis in 0..D {
                let stride = self.grid.stride(axis);
                let reach = |neighbour: usize| (value / (value - self.values[neighbour].max(0.0))).min(1.0);
                let below = if index[axis] > 0 { reach(node - stride) } else { 0.0 };
                let above = if index[axis] < self.grid.cells() { reach(node + stride) } else { 0.0 };
                low[axis] = low[axis].min((index[axis] as f64 - below) * spacing);
                high[axis] = high[axis].max((index[axis] as f64 + above) * spacing);
            }
        }
        (low, high)
    }
}

/// Whether the box from `low` to `high` keeps [`CLEARANCE`] cells from the border; names the worst side if not.
fn check_clearance<const D: usize>(low: [f64; D], high: [f64; D], cells: usize) -> Result<(), ShapeError> {
    const SIDES: [[&str; 2]; 3] = [["left", "right"], ["bottom", "top"], ["front", "back"]];
    const COORDINATES: [&str; 3] = ["x", "y", "z"];
    let worst = (0..D)
        .flat_map(|axis| [(axis, 0, low[axis], low[axis]), (axis, 1, high[axis], 1.0 - high[axis])])
        .min_by(|left, right| left.3.total_cmp(&right.3));
    let Some((axis, end, value, room)) = worst else { return Ok(()) };
    let (side, coordinate) = (SIDES[axis][end], COORDINATES[axis]);
    let in_cells = room * cells as f64;
    if in_cells < 0.0 {
        return Err(ShapeError::OutsideBox { side, coordinate, value });
    }
    // A shape placed at exactly this distance may be off by rounding.
    if in_cells < CLEARANCE - 1e-9 {
        return Err(ShapeError::NearBorder { side, coordinate, value, cells: in_cells, needed: CLEARANCE });
    }
    Ok(())
}
