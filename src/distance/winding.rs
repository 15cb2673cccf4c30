//! What a set of closed contours encloses: non-zero winding, bodies and holes.

use std::cell::Cell;

use crate::order::ascending;
use glam::DVec2;

/// A step off the nodes in a direction that edges hardly have, the golden section's.
const ASIDE: DVec2 = DVec2::new(1e-9, 0.618_033_988_749_894_9e-9);

/// A directed edge of a contour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub a: DVec2,
    pub b: DVec2,
    pub contour: usize,
}

/// The set { x : Σ_i o_i [winding_i(x) ≠ 0] > 0 }, where o_i = +1 for a body and −1 for a hole.
#[derive(Debug)]
pub(super) struct Region {
    /// Grouped by contour.
    pub edges: Vec<Edge>,
    /// o_i, one for each contour.
    pub signs: Vec<i32>,
}

impl Region {
    /// The edges of closed contours, each counted by itself and as a body.
    pub fn of_contours(contours: &[Vec<DVec2>]) -> Self {
        let mut edges = Vec::with_capacity(contours.iter().map(Vec::len).sum());
        for (contour, points) in contours.iter().enumerate() {
            let ends = points.iter().skip(1).chain(points.first());
            edges.extend(points.iter().zip(ends).map(|(&a, &b)| Edge { a, b, contour }));
        }
        Self { edges, signs: vec![1; contours.len()] }
    }

    /// Whether each of the `side`² nodes at spacing `spacing` lies inside, x fastest.
    ///
    /// A node on a stroke that is no outline would be told apart from its surroundings by rounding alone. So it is
    /// the point [`ASIDE`] of each node that is looked up; the sign of a distance smaller than that may be either.
    pub fn classify_nodes(&self, side: usize, spacing: f64) -> Vec<bool> {
        // (x, contour, direction) wherever an edge crosses the row; the lower end belongs to the edge, the upper does not.
        let mut crossings: Vec<Vec<(f64, usize, i32)>> = vec![Vec::new(); side];
        for edge in &self.edges {
            let (low, high, direction) = if edge.a.y <= edge.b.y { (edge.a, edge.b, 1) } else { (edge.b, edge.a, -1) };
            let first = ((low.y - ASIDE.y) / spacing).floor().max(0.0) as usize;
            for (row, hits) in crossings.iter_mut().enumerate().skip(first) {
                let y = row as f64 * spacing + ASIDE.y;
                if y >= high.y {
                    break;
                }
                if y >= low.y {
                    let x = low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x);
                    hits.push((x, edge.contour, direction));
                }
            }
        }

        let mut inside = vec![false; side * side];
        let mut winding = vec![0; self.signs.len()];
        for (hits, nodes) in crossings.iter().zip(inside.chunks_exact_mut(side)) {
            let order = ascending(&hits.iter().map(|hit| hit.0).collect::<Vec<_>>());
            let mut hits = order.into_iter().map(|hit| hits[hit as usize]).peekable();
            winding.fill(0);
            let mut sum = 0;
            for (i, node) in nodes.iter_mut().enumerate() {
                let x = i as f64 * spacing + ASIDE.x;
                while let Some((_, contour, direction)) = hits.next_if(|hit| hit.0 <= x) {
                    let before: i32 = winding[contour];
                    winding[contour] += direction;
                    sum += self.signs[contour] * (i32::from(winding[contour] != 0) - i32::from(before != 0));
                }
                *node = sum > 0;
            }
        }
        inside
    }
}

/// Edges sorted into horizontal strips, so that a ray meets few of them.
pub(super) struct Strips<'a> {
    region: &'a Region,
    low: f64,
    per_length: f64,
    /// Members of strip s: `members[starts[s]..starts[s + 1]]`, in the order of the edges, hence grouped by contour.
    starts: Vec<usize>,
    members: Vec<u32>,
    /// Edges that all rays so far have looked at.
    scanned: Cell<usize>,
}

impl<'a> Strips<'a> {
    pub fn new(region: &'a Region) -> Self {
        let count = region.edges.len().clamp(1, 4096);
        let (low, high) = region
            .edges
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), edge| (low.min(edge.a.y), high.max(edge.a.y)));
        let per_length = if high > low { count as f64 / (high - low) } else { 0.0 };
        let mut strips =
            Self { region, low, per_length, starts: vec![0; count + 1], members: Vec::new(), scanned: Cell::new(0) };
        for edge in &region.edges {
            for strip in strips.span(edge) {
                strips.starts[strip + 1] += 1;
            }
        }
        for strip in 0..count {
            strips.starts[strip + 1] += strips.starts[strip];
        }
        strips.members = vec![0; strips.starts[count]];
        let mut cursor = strips.starts.clone();
        for (number, edge) in region.edges.iter().enumerate() {
            for strip in strips.span(edge) {
                strips.members[cursor[strip]] = number as u32;
                cursor[strip] += 1;
            }
        }
        strips
    }

    fn strip(&self, y: f64) -> usize {
        // The cast sends what lies below to strip 0.
        (((y - self.low) * self.per_length) as usize).min(self.starts.len() - 2)
    }

    fn span(&self, edge: &Edge) -> std::ops::RangeInclusive<usize> {
        self.strip(edge.a.y.min(edge.b.y))..=self.strip(edge.a.y.max(edge.b.y))
    }

    /// What the rays so far have cost, in edges.
    pub fn scanned(&self) -> usize {
        self.scanned.get()
    }

    /// Calls `found` with every contour that winds around `point`, in ascending order.
    pub fn enclosing(&self, point: DVec2, mut found: impl FnMut(usize)) {
        let strip = self.strip(point.y);
        let (mut contour, mut winding) = (usize::MAX, 0);
        let members = &self.members[self.starts[strip]..self.starts[strip + 1]];
        self.scanned.set(self.scanned.get() + members.len());
        for &member in members {
            let edge = &self.region.edges[member as usize];
            if edge.contour != contour {
                if winding != 0 {
                    found(contour);
                }
                (contour, winding) = (edge.contour, 0);
            }
            let upward = edge.a.y <= point.y;
            if upward != (edge.b.y <= point.y) {
                let left_of_edge = (edge.b - edge.a).perp_dot(point - edge.a);
                if upward && left_of_edge > 0.0 {
                    winding += 1;
                } else if !upward && left_of_edge < 0.0 {
                    winding -= 1;
                }
            }
        }
        if winding != 0 {
            found(contour);
        }
    }

    /// Whether the region with these signs holds `point`.
    pub fn inside(&self, signs: &[i32], point: DVec2) -> bool {
        let mut sum = 0;
        self.enclosing(point, |contour| sum += signs[contour]);
        sum > 0
    }
}
