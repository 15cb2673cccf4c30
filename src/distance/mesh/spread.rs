//! Unsigned distances to triangles: exact around them, then handed on from node to node.

use crate::grid::Grid;
use crate::hypersurface::{Hypersurface, Tree, square_to};
use std::sync::Arc;

/// Distances below this are exact: what the shell terms look at, whose bands are half as wide.
const EXACT: f64 = 0.1;

/// Cells around a triangle whose nodes look at it.
const REACH: f64 = 2.0;
/// Width of a bucket of the queue, in cells.
const BUCKET: f64 = 0.25;

/// The distance of every node: exact up to [`EXACT`], beyond to the nearest of the triangles that a neighbour closer to the
/// surface is nearest to. Triangles are no longer than cells, or their boxes would be empty for the most part.
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
                        self.offer(node, &point, triangle as u32);
                    }
                }
            }
        }
    }

    /// Whether the triangle is nearer than what the node knew.
    fn offer(&mut self, node: usize, point: &[f64; 3], triangle: u32) -> bool {
        let square = square_to(point, &self.corners[triangle as usize]);
        let is_nearer = square < self.squares[node];
        if is_nearer {
            (self.squares[node], self.nearest[node]) = (square, triangle);
        }
        is_nearer
    }

    /// Looks for a nearer triangle among all.
    fn refine(&mut self, node: usize, tree: &Tree<3>) {
        let per_square = (self.grid.cells() as f64).powi(2);
        if let Some(nearer) = tree.nearer(&self.grid.position(node), self.squares[node] / per_square) {
            self.nearest[node] = nearer.simplex as u32;
            self.squares[node] = nearer.distance.powi(2) * per_square;
        }
    }

    /// Nodes in about the order of their distances offer their nearest triangle to their neighbours.
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
        let exact = EXACT * self.grid.cells() as f64 + 1.0;
        let mut number = 0;
        while number < buckets.len() {
            let bucket = std::mem::take(&mut buckets[number]);
            for node in bucket.into_iter().map(|node| node as usize) {
                // One that has become nearer since was there before.
                if bucket_of(self.squares[node]) != number {
                    continue;
                }
                let index = self.grid.node_index(node);
                let square = self.squares[node];
                if (REACH * REACH..exact * exact).contains(&square) {
                    self.refine(node, tree);
                }
                let triangle = self.nearest[node];
                for axis in 0..3 {
                    for is_ahead in [false, true] {
                        let mut place = index;
                        if if is_ahead { index[axis] == self.grid.cells() } else { index[axis] == 0 } {
                            continue;
                        }
                        place[axis] = if is_ahead { index[axis] + 1 } else { index[axis] - 1 };
                        let other = self.grid.node(place);
                        let knew = self.squares[other];
                        // Nodes near the surface know their triangle already, and those nearer than this one too.
                        if self.nearest[other] == triangle && knew.is_finite()
                            || knew <= self.squares[node]
                            || knew <= REACH * REACH
                        {
                            continue;
                        }
                        if self.offer(other, &place.map(|i| i as f64), triangle) {
                            push(&mut buckets, self.squares[other], other);
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
