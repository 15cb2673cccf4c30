//! Unsigned distances to triangles: exact around them, beyond by what is nearest to the nodes of coarser grids.

use super::coins::{Coins, Near};
use crate::grid::Grid;
use crate::hypersurface::Hypersurface;
use glam::DVec3;

/// Distances below this are exact: the usual half width of the bands in which the shell terms look at them,
const EXACT: f64 = 0.05;
/// and as many cells more, for the fits at the bands' borders.
const EXACT_CELLS: f64 = 3.0;
/// Cells by which a distance may be too far before triangles are searched through.
const TOO_FAR: f64 = 0.25;

/// Feet of neighbours that are so many of their cells apart say little of the node between,
const APART: f64 = 2.0;
/// and where they do, as on all coarser grids, a triangle counts as the nearest if none is nearer by more than this share of its
/// distance.
const CLOSE: f64 = 1.0 / 256.0;

/// On grids of no more cells a side all distances are exact.
const COARSEST: usize = 8;

/// The distance of every node: exact up to [`EXACT`] and [`EXACT_CELLS`], beyond to a triangle that a neighbour on the grid of
/// twice the spacing is nearest to, and so on, but for [`CLOSE`] where these are [`APART`]. Triangles are no longer than cells.
pub(super) fn distances(grid: Grid<3>, surface: &Hypersurface<3>) -> Vec<f64> {
    let exact = EXACT + (EXACT_CELLS + TOO_FAR) * grid.spacing();
    let nodes = Nodes { coins: Coins::new(surface), exact: exact * exact };
    let mut distances = Vec::with_capacity(grid.node_count());
    nodes.each(grid, false, &mut |near| distances.push(near.square.sqrt()));
    distances
}

struct Nodes {
    coins: Coins,
    /// Squared distance below which no triangle may be nearer.
    exact: f64,
}

impl Nodes {
    /// Tells of each node what it is nearest to; if `closely`, then to within [`CLOSE`] everywhere.
    fn each(&self, grid: Grid<3>, closely: bool, tell: &mut dyn FnMut(Near)) {
        if grid.cells() <= COARSEST || !grid.cells().is_multiple_of(2) {
            return self.each_exactly(grid, tell);
        }
        let coarser = Grid::new(grid.cells() / 2);
        let mut known = Vec::with_capacity(coarser.node_count());
        self.each(coarser, true, &mut |near| known.push(near));
        for k in 0..grid.side() {
            for j in 0..grid.side() {
                for i in 0..grid.side() {
                    let index = [i, j, k];
                    if index.iter().all(|i| i % 2 == 0) {
                        tell(known[coarser.node(index.map(|i| i / 2))]);
                        continue;
                    }
                    let point = index.map(|i| i as f64 * grid.spacing());
                    let (near, is_apart) = self.as_neighbours(coarser, &known, index, &point);
                    if near.square < self.exact {
                        tell(self.nearer(&point, near, 1.0));
                    } else if closely || is_apart {
                        tell(self.nearer(&point, near, (1.0 - CLOSE).powi(2)));
                    } else {
                        tell(near);
                    }
                }
            }
        }
    }

    /// A node looks first at what the one before it is nearest to.
    fn each_exactly(&self, grid: Grid<3>, tell: &mut dyn FnMut(Near)) {
        let mut triangle = 0;
        for node in 0..grid.node_count() {
            let point = grid.position(node);
            let near = self.nearer(&point, self.coins.on(triangle, &point), 1.0);
            triangle = near.triangle;
            tell(near);
        }
    }

    /// Of a node's neighbours on the coarser grid that whose foot is nearest tells the triangle. Whether their feet are
    /// [`APART`], as on both sides of a node in the middle of a body.
    fn as_neighbours(&self, coarser: Grid<3>, known: &[Near], [i, j, k]: [usize; 3], point: &[f64; 3]) -> (Near, bool) {
        let (mut least, mut triangle) = (f64::INFINITY, 0);
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for k in k / 2..=k.div_ceil(2) {
            for j in j / 2..=j.div_ceil(2) {
                for i in i / 2..=i.div_ceil(2) {
                    let near = &known[coarser.node([i, j, k])];
                    let foot = DVec3::from(near.foot);
                    let square = foot.distance_squared(DVec3::from(*point));
                    if square < least {
                        (least, triangle) = (square, near.triangle);
                    }
                    (low, high) = (low.min(foot), high.max(foot));
                }
            }
        }
        (self.coins.on(triangle, point), (high - low).max_element() > APART * coarser.spacing())
    }

    /// The nearest of all, if its squared distance is less than this share of what is known.
    fn nearer(&self, point: &[f64; 3], known: Near, share: f64) -> Near {
        self.coins.nearer(point, share * known.square).unwrap_or(known)
    }
}
