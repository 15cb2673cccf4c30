//! Unsigned distances to triangles: exact around them, then handed on from node to node.

use crate::grid::Grid;
use crate::hypersurface::{Hypersurface, Tree, foot, square_to};
use std::sync::Arc;

/// Distances below this are exact: the usual half width of the bands in which the shell terms look at them,
const EXACT: f64 = 0.05;
/// and as many cells more, for the fits at the bands' borders.
const EXACT_CELLS: f64 = 3.0;

/// Cells around a triangle whose nodes look at it.
const REACH: f64 = 2.0;
/// Width of a bucket of the queue, in cells.
const BUCKET: f64 = 0.25;

/// The distance of every node: exact up to [`EXACT`] and [`EXACT_CELLS`], beyond to the triangle that the neighbour with the
/// nearest foot is nearest to. Triangles are no longer than cells, or their boxes would be empty for the most part.
pub(super) fn distances(grid: Grid<3>, surface: &Arc<Hypersurface<3>>) -> Vec<f64> {
    let tree = Tree::new(surface.clone());
    let mut field = Field {
        grid,
        corners: surface
            .all_corners()
            .map(|corners| corners.map(|corner| corner.map(|x| x * grid.cells() as f64)))
            .collect(),
        squares: vec![f64::INFINITY; grid.node_count()],
        nearest: vec![0; grid.node_count()],
    };
    for triangle in 0..field.corners.len() {
        field.look_around(triangle);
    }
    field.hand_on(&tree);
    field.squares.iter().map(|square| square.sqrt() * grid.spacing()).collect()
}

/// Lengths are in cells.
struct Field {
    grid: Grid<3>,
    corners: Vec<[[f64; 3]; 3]>,
    squares: Vec<f64>,
    nearest: Vec<u32>,
}

impl Field {
    /// Offers a triangle to the nodes around it.
    fn look_around(&mut self, triangle: usize) {
        let corners = self.corners[triangle];
        let bound = |axis: usize| {
            let low = corners.iter().map(|corner| corner[axis]).fold(f64::INFINITY, f64::min);
            let high = corners.iter().map(|corner| corner[axis]).fold(f64::NEG_INFINITY, f64::max);
            let last = self.grid.cells() as f64;
            (low - REACH).ceil().max(0.0) as usize..=(high + REACH).floor().min(last) as usize
        };
        let [columns, rows, layers] = [bound(0), bound(1), bound(2)];
        let plane = Plane::of(&corners);
        for k in layers {
            for j in rows.clone() {
                for i in columns.clone() {
                    let point = [i, j, k].map(|i| i as f64);
                    let node = self.grid.node([i, j, k]);
                    let off = plane.distance(&point);
                    if off * off < self.squares[node].min(REACH * REACH) {
                        let square = square_to(&point, &corners);
                        if square < self.squares[node] {
                            (self.squares[node], self.nearest[node]) = (square, triangle as u32);
                        }
                    }
                }
            }
        }
    }

    /// Looks for a nearer triangle among all; whether there is one.
    fn refine(&mut self, node: usize, tree: &Tree<3>) -> bool {
        let per_square = (self.grid.cells() as f64).powi(2);
        let nearer = tree.nearer(&self.grid.position(node), self.squares[node] / per_square);
        if let Some(nearer) = &nearer {
            self.nearest[node] = nearer.simplex as u32;
        }
        nearer.is_some()
    }

    /// The foot of a node on its triangle; its distance becomes that to this foot.
    fn foot(&mut self, node: usize, point: &[f64; 3]) -> [f64; 3] {
        let corners = &self.corners[self.nearest[node] as usize];
        let (square, shares) = foot(point, corners);
        self.squares[node] = square;
        std::array::from_fn(|axis| (0..3).map(|k| shares[k] * corners[k][axis]).sum())
    }

    /// Nodes in about the order of their distances offer their feet to their neighbours: the distance of a neighbour to a
    /// foot takes a fraction of that to a triangle, and tells which triangle is the nearest.
    fn hand_on(&mut self, tree: &Tree<3>) {
        let bucket_of = |square: f64| (square.sqrt() / BUCKET) as usize;
        let mut buckets: Vec<Vec<u32>> = Vec::new();
        let push = |buckets: &mut Vec<Vec<u32>>, square: f64, node: usize| {
            let bucket = bucket_of(square);
            if bucket >= buckets.len() {
                buckets.resize_with(bucket + 1, Vec::new);
            }
            buckets[bucket].push(node as u32);
        };
        for (node, &square) in self.squares.iter().enumerate().filter(|(_, square)| square.is_finite()) {
            push(&mut buckets, square, node);
        }
        // What is handed on is too far by less than a cell.
        let exact = EXACT * self.grid.cells() as f64 + EXACT_CELLS + 1.0;
        let mut is_done = vec![false; self.squares.len()];
        let mut number = 0;
        while number < buckets.len() {
            let bucket = std::mem::take(&mut buckets[number]);
            for node in bucket.into_iter().map(|node| node as usize) {
                // One that has become nearer since was there before.
                if std::mem::replace(&mut is_done[node], true) {
                    continue;
                }
                let index = self.grid.node_index(node);
                let point = index.map(|i| i as f64);
                let mut foot = self.foot(node, &point);
                if (REACH * REACH..exact * exact).contains(&self.squares[node]) && self.refine(node, tree) {
                    foot = self.foot(node, &point);
                }
                for axis in 0..3 {
                    for (step, at_border) in [(-1.0, 0), (1.0, self.grid.cells())] {
                        if index[axis] == at_border {
                            continue;
                        }
                        let stride = self.grid.stride(axis);
                        let other = if step < 0.0 { node - stride } else { node + stride };
                        // Nodes near the surface know their triangle already, and those nearer than this one too.
                        if is_done[other] || self.squares[other] <= REACH * REACH {
                            continue;
                        }
                        let mut offset: [f64; 3] = std::array::from_fn(|k| point[k] - foot[k]);
                        offset[axis] += step;
                        let square = offset.iter().map(|x| x * x).sum();
                        if square < self.squares[other] {
                            (self.squares[other], self.nearest[other]) = (square, self.nearest[node]);
                            push(&mut buckets, square, other);
                        }
                    }
                }
            }
            // Those that came back into the bucket under work are next.
            if buckets[number].is_empty() {
                number += 1;
            }
        }
    }
}

struct Plane {
    origin: [f64; 3],
    normal: [f64; 3],
}

impl Plane {
    fn of([a, b, c]: &[[f64; 3]; 3]) -> Self {
        let [a3, b3, c3] = [a, b, c].map(|corner| glam::DVec3::from(*corner));
        // A triangle without area has no plane: everything may be near.
        let normal = (b3 - a3).cross(c3 - a3).try_normalize().unwrap_or(glam::DVec3::ZERO);
        Self { origin: *a, normal: normal.to_array() }
    }

    fn distance(&self, point: &[f64; 3]) -> f64 {
        (0..3).map(|axis| (point[axis] - self.origin[axis]) * self.normal[axis]).sum()
    }
}
