//! Unsigned distances to triangles: exact around them, beyond by what is nearest to other nodes.

use super::regions::within;
use super::scan::{NONE, Nearest};
use crate::grid::Grid;
use crate::hypersurface::{Hypersurface, foot};
use glam::DVec3;

/// Distances below this are exact: the usual half width of the bands in which the shell terms look at them,
const EXACT: f64 = 0.05;
/// and as many cells more, for the fits at the bands' borders.
const EXACT_CELLS: f64 = 3.0;

/// No distance in the box is longer.
const LONGEST: f64 = 2.0;
/// On grids of no more cells a side all distances are exact.
const FEW_CELLS: usize = 8;

/// Times that all nodes ask their neighbours, forth, back and forth again: then they know, wherever the surface is.
const ROUNDS: usize = 3;

/// Feet of neighbours that are so many of their cells apart, as on both sides of a node in the middle of a body, say little of
/// the node between: then all their triangles are tried.
const APART: f64 = 2.0;

/// The distance of every node: exact up to [`EXACT`] and [`EXACT_CELLS`]. Beyond, every second node along each axis asks its
/// neighbours among these for the triangle that they are nearest to, again and again, and then the nodes between do.
pub(super) fn distances(grid: Grid<3>, surface: &Hypersurface<3>) -> Vec<f64> {
    let is_coarse = grid.cells() <= FEW_CELLS || !grid.cells().is_multiple_of(2);
    let radius = if is_coarse { LONGEST } else { EXACT + EXACT_CELLS * grid.spacing() };
    let mut nearest = within(grid, surface, radius);
    if !is_coarse {
        let known = Known::spread(grid, &nearest, surface);
        known.fill(grid, &mut nearest);
    }
    let Nearest { squares: mut distances, .. } = nearest;
    distances.iter_mut().for_each(|square| *square = square.sqrt());
    distances
}

/// The nearest triangles of a grid's nodes, as far as is known.
struct Known {
    grid: Grid<3>,
    corners: Vec<[[f64; 3]; 3]>,
    triangles: Vec<u32>,
    /// The points that are nearest.
    feet: Vec<DVec3>,
}

impl Known {
    /// Of every second node of a grid along each axis.
    fn spread(finer: Grid<3>, nearest: &Nearest, surface: &Hypersurface<3>) -> Self {
        let grid = Grid::new(finer.cells() / 2);
        let count = grid.node_count();
        let triangles: Vec<u32> =
            (0..count).map(|node| nearest.triangles[finer.node(grid.node_index(node).map(|i| 2 * i))]).collect();
        let corners = surface.all_corners().collect();
        let mut known = Self { grid, corners, triangles, feet: vec![DVec3::INFINITY; count] };
        let mut unknown = Vec::new();
        for node in 0..count {
            match known.triangles[node] {
                NONE => unknown.push(node as u32),
                triangle => known.feet[node] = known.foot(triangle, DVec3::from(grid.position(node))),
            }
        }
        for round in 0..ROUNDS {
            for place in 0..unknown.len() {
                known.ask(unknown[if round % 2 == 0 { place } else { unknown.len() - 1 - place }] as usize);
            }
        }
        known
    }

    /// The neighbour whose foot is nearest tells its triangle.
    fn ask(&mut self, node: usize) {
        let index = self.grid.node_index(node);
        let point = DVec3::from(index.map(|i| i as f64 * self.grid.spacing()));
        let (mut least, mut told) = (f64::INFINITY, node);
        let range = |axis: usize| index[axis].saturating_sub(1)..(index[axis] + 2).min(self.grid.side());
        for k in range(2) {
            for j in range(1) {
                for i in range(0) {
                    let neighbour = self.grid.node([i, j, k]);
                    let square = self.feet[neighbour].distance_squared(point);
                    if square < least {
                        (least, told) = (square, neighbour);
                    }
                }
            }
        }
        let triangle = self.triangles[told];
        if triangle != self.triangles[node] {
            let foot = self.foot(triangle, point);
            if foot.distance_squared(point) < self.feet[node].distance_squared(point) {
                (self.triangles[node], self.feet[node]) = (triangle, foot);
            }
        }
    }

    /// The nodes of a grid of half the spacing that know nothing take the triangle of the nearest foot.
    fn fill(&self, finer: Grid<3>, nearest: &mut Nearest) {
        let mut node = 0;
        for k in 0..finer.side() {
            for j in 0..finer.side() {
                for i in 0..finer.side() {
                    if nearest.triangles[node] == NONE {
                        nearest.squares[node] = self.square([i, j, k], finer.spacing());
                    }
                    node += 1;
                }
            }
        }
    }

    fn square(&self, [i, j, k]: [usize; 3], spacing: f64) -> f64 {
        let point = DVec3::from([i, j, k].map(|i| i as f64 * spacing));
        // Those around the cell or edge that the node lies in, and as many beyond.
        let neighbours = |beyond: usize| {
            let last = self.grid.cells();
            let range = move |i: usize| (i / 2).saturating_sub(beyond)..=(i.div_ceil(2) + beyond).min(last);
            range(k).flat_map(move |k| range(j).flat_map(move |j| range(i).map(move |i| self.grid.node([i, j, k]))))
        };
        let (mut least, mut triangle) = (f64::INFINITY, NONE);
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for neighbour in neighbours(0) {
            let foot = self.feet[neighbour];
            let square = foot.distance_squared(point);
            if square < least {
                (least, triangle) = (square, self.triangles[neighbour]);
            }
            (low, high) = (low.min(foot), high.max(foot));
        }
        let square = |triangle: u32| self.foot(triangle, point).distance_squared(point);
        if (high - low).max_element() <= APART * self.grid.spacing() {
            return square(triangle);
        }
        neighbours(1).map(|neighbour| square(self.triangles[neighbour])).fold(f64::INFINITY, f64::min)
    }

    /// The point of a triangle that is nearest to another.
    fn foot(&self, triangle: u32, point: DVec3) -> DVec3 {
        let corners = &self.corners[triangle as usize];
        let (_, shares) = foot(&point.to_array(), corners);
        (0..3).map(|k| shares[k] * DVec3::from(corners[k])).sum()
    }
}
