//! The edges of triangles.

use crate::numbers::Numbers;
use glam::DVec3;

/// The squared sine of an angle of a triangle below which it is a line: its edges stand for it.
const LINE: f64 = 1e-12;

pub(super) struct Edge {
    pub ends: [u32; 2],
    /// One at it.
    pub triangle: u32,
    /// Unit vectors from the edge into two triangles at most, that are no lines.
    inward: [DVec3; 2],
    count: usize,
}

/// The edges of triangles, and which there are at each corner.
pub(super) struct Edges {
    pub edges: Vec<Edge>,
    /// By corner, the place of its first number; one more at the end.
    firsts: Vec<u32>,
    numbers: Vec<u32>,
}

impl Edge {
    pub fn inward(&self) -> &[DVec3] {
        &self.inward[..self.count]
    }
}

impl Edges {
    pub fn of(triangles: &[[u32; 3]], points: &[DVec3]) -> Self {
        let (mut seen, mut edges) = (Numbers::default(), Vec::new());
        for (triangle, corners) in triangles.iter().enumerate() {
            let places = corners.map(|corner| points[corner as usize]);
            let is_line = is_line(places);
            for k in 0..3 {
                let [(from, a), (to, b), (_, c)] =
                    [0, 1, 2].map(|next| (k + next) % 3).map(|k| (corners[k], places[k]));
                let ends = [from.min(to), from.max(to)];
                let number = seen.of(ends.map(i64::from)) as usize;
                if number == edges.len() {
                    edges.push(Edge { ends, triangle: triangle as u32, inward: [DVec3::ZERO; 2], count: 0 });
                }
                let edge = &mut edges[number];
                if !is_line && edge.count < 2 {
                    edge.inward[edge.count] = (c - a).reject_from(b - a).normalize();
                    edge.count += 1;
                }
            }
        }
        let mut firsts = vec![0; points.len() + 1];
        edges.iter().flat_map(|edge| edge.ends).for_each(|end| firsts[end as usize + 1] += 1);
        for corner in 0..points.len() {
            firsts[corner + 1] += firsts[corner];
        }
        let (mut numbers, mut next) = (vec![0; 2 * edges.len()], firsts.clone());
        for (number, end) in edges.iter().enumerate().flat_map(|(number, edge)| edge.ends.map(|end| (number, end))) {
            numbers[next[end as usize] as usize] = number as u32;
            next[end as usize] += 1;
        }
        Self { edges, firsts, numbers }
    }

    /// Those at a corner.
    pub fn at(&self, corner: usize) -> impl Iterator<Item = &Edge> {
        let numbers = self.firsts[corner] as usize..self.firsts[corner + 1] as usize;
        self.numbers[numbers].iter().map(|&number| &self.edges[number as usize])
    }
}

/// Whether a triangle has no normal that rounding would not change.
pub(super) fn is_line([a, b, c]: [DVec3; 3]) -> bool {
    let (u, v, w) = (b - a, c - b, a - c);
    let longest = u.length_squared().max(v.length_squared()).max(w.length_squared());
    u.cross(v).length_squared() <= LINE * longest * longest
}
