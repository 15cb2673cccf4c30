//! Curves in the plane and surfaces in space as simplices: segments, triangles.

mod loops;
mod march;
mod tree;

pub use loops::Loop;
pub(crate) use tree::foot;
pub use tree::{Nearest, Tree};

use crate::field::interpolate;
use crate::grid::Grid;
use crate::numbers::Numbers;
use glam::{DVec2, DVec3};

/// Simplices of D corners each, in domain units; neighbours share their corners.
#[derive(Clone, Debug, Default)]
pub struct Hypersurface<const D: usize> {
    points: Vec<[f64; D]>,
    simplices: Vec<[u32; D]>,
}

impl<const D: usize> Hypersurface<D> {
    /// # Panics
    ///
    /// If a simplex has a corner that is not among the points.
    pub fn new(points: Vec<[f64; D]>, simplices: Vec<[u32; D]>) -> Self {
        assert!(simplices.iter().flatten().all(|&corner| (corner as usize) < points.len()), "corners are points");
        Self { points, simplices }
    }

    /// The zero set of nodal values, linear on the Kuhn simplices of each cell; a zero counts as positive. What is
    /// negative at the border of the box is left open there.
    pub fn zero_set(grid: Grid<D>, values: &[f64]) -> Self {
        march::zero_set(grid, values)
    }

    pub fn is_empty(&self) -> bool {
        self.simplices.is_empty()
    }

    pub fn points(&self) -> &[[f64; D]] {
        &self.points
    }

    pub fn simplices(&self) -> &[[u32; D]] {
        &self.simplices
    }

    /// The corners of each simplex.
    pub fn all_corners(&self) -> impl Iterator<Item = [[f64; D]; D]> {
        (0..self.simplices.len()).map(|simplex| self.corners(simplex))
    }

    fn corners(&self, simplex: usize) -> [[f64; D]; D] {
        self.simplices[simplex].map(|corner| self.points[corner as usize])
    }

    /// The point of a simplex in which its corners have these shares.
    pub fn point_at(&self, simplex: usize, shares: &[f64; D]) -> [f64; D] {
        let corners = self.corners(simplex);
        std::array::from_fn(|axis| (0..D).map(|k| shares[k] * corners[k][axis]).sum())
    }

    /// The middle and the measure of each simplex.
    pub fn middles(&self) -> impl Iterator<Item = ([f64; D], f64)> {
        (0..self.simplices.len()).map(|simplex| {
            let corners = self.corners(simplex);
            let middle = std::array::from_fn(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / D as f64);
            (middle, measure(&corners))
        })
    }

    /// Length or area.
    pub fn measure(&self) -> f64 {
        (0..self.simplices.len()).map(|simplex| measure(&self.corners(simplex))).sum()
    }

    /// The image under φ = x + u, corner by corner; u at the nodes of a grid, D numbers a node.
    pub fn moved(&self, grid: Grid<D>, displacement: &[f64]) -> Self {
        let points = self.points.iter().map(|point| image(grid, displacement, point)).collect();
        Self { points, simplices: self.simplices.clone() }
    }
}

impl Hypersurface<3> {
    /// The same surface with triangles whose edges are no longer than `longest`, each cut across its longest edge until they
    /// are, and of which triangle each is a part. Neighbours cut a common edge alike. The points there are come first.
    pub fn cut(&self, longest: f64) -> (Self, Vec<u32>) {
        let mut points = self.points.clone();
        let mut middles = Numbers::default();
        let first_middle = points.len();
        let (mut simplices, mut wholes) = (Vec::with_capacity(self.simplices.len()), Vec::new());
        let mut rest: Vec<([u32; 3], u32)> = self.simplices.iter().copied().zip(0..).collect();
        while let Some((corners, whole)) = rest.pop() {
            let square = |k: usize| {
                let [a, b] = [corners[k], corners[(k + 1) % 3]].map(|corner| DVec3::from(points[corner as usize]));
                a.distance_squared(b)
            };
            let along = (0..3).max_by(|&a, &b| square(a).total_cmp(&square(b))).unwrap_or(0);
            if square(along) <= longest * longest {
                simplices.push(corners);
                wholes.push(whole);
                continue;
            }
            let [a, b, c] = [0, 1, 2].map(|k| corners[(along + k) % 3]);
            let middle = first_middle + middles.of([a.min(b), a.max(b)].map(i64::from)) as usize;
            if middle == points.len() {
                let [a, b] = [a, b].map(|corner| DVec3::from(points[corner as usize]));
                points.push(a.midpoint(b).to_array());
            }
            rest.extend([[a, middle as u32, c], [middle as u32, b, c]].map(|part| (part, whole)));
        }
        (Self { points, simplices }, wholes)
    }
}

impl Hypersurface<2> {
    /// Segments in the order of the outlines, cut to pieces no longer than `longest`; consecutive ones that are together
    /// shorter than `shortest` become one.
    pub fn from_segments(segments: &[[DVec2; 2]], shortest: f64, longest: f64) -> Self {
        let mut surface = Self::default();
        for run in segments.chunk_by(|before, after| before[1] == after[0]) {
            let mut from = run[0][0];
            let last = run[run.len() - 1][1];
            let mut pushed = false;
            for &[_, to] in run {
                if from.distance(to) >= shortest {
                    surface.push(from, to, longest);
                    (from, pushed) = (to, true);
                }
            }
            if from != last || !pushed {
                surface.push(from, last, longest);
            }
        }
        surface
    }

    fn push(&mut self, from: DVec2, to: DVec2, longest: f64) {
        if self.points.last() != Some(&from.to_array()) {
            self.points.push(from.to_array());
        }
        // Rounding must not make one piece more.
        let count = (from.distance(to) / longest - 1e-9).ceil().max(1.0);
        for k in 1..=count as usize {
            let end = self.points.len() as u32;
            self.points.push(from.lerp(to, k as f64 / count).to_array());
            self.simplices.push([end - 1, end]);
        }
    }
}

/// φ(x).
pub fn image<const D: usize>(grid: Grid<D>, displacement: &[f64], point: &[f64; D]) -> [f64; D] {
    let u = interpolate::<D, D>(grid, displacement, point);
    std::array::from_fn(|axis| point[axis] + u[axis])
}

/// √det G / (D − 1)! with the Gram matrix G of the edges from the first corner.
pub fn measure<const D: usize>(corners: &[[f64; D]; D]) -> f64 {
    let edge = |k: usize| -> [f64; D] { std::array::from_fn(|axis| corners[k][axis] - corners[0][axis]) };
    let product = |a: &[f64; D], b: &[f64; D]| -> f64 { (0..D).map(|axis| a[axis] * b[axis]).sum() };
    match D {
        2 => product(&edge(1), &edge(1)).sqrt(),
        3 => {
            let (a, b) = (edge(1), edge(2));
            0.5 * (product(&a, &a) * product(&b, &b) - product(&a, &b).powi(2)).max(0.0).sqrt()
        }
        _ => unreachable!("curves and surfaces"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn ball<const D: usize>(cells: usize, radius: f64) -> Hypersurface<D> {
        let grid = Grid::<D>::new(cells);
        let distance = |x: [f64; D]| x.iter().map(|a| (a - 0.47).powi(2)).sum::<f64>().sqrt() - radius;
        let values: Vec<f64> = (0..grid.node_count()).map(|node| distance(grid.position(node))).collect();
        Hypersurface::zero_set(grid, &values)
    }

    #[test]
    fn the_zero_set_of_a_ball_has_its_measure() {
        let circle = ball::<2>(128, 0.3).measure() / (2.0 * PI * 0.3);
        assert!((circle - 1.0).abs() < 1e-4, "{circle}");
        let sphere = ball::<3>(48, 0.3).measure() / (4.0 * PI * 0.09);
        assert!((sphere - 1.0).abs() < 2e-3, "{sphere}");
    }

    /// Euler's characteristic: 0 for a closed curve, 2 for a sphere.
    #[test]
    fn the_zero_set_of_a_ball_is_closed() {
        let circle = ball::<2>(32, 0.3);
        assert_eq!(circle.points().len(), circle.simplices().len());
        let sphere = ball::<3>(24, 0.3);
        let edges: std::collections::BTreeSet<[u32; 2]> = sphere
            .simplices()
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        assert_eq!(sphere.points().len() + sphere.simplices().len() - edges.len(), 2);
    }

    #[test]
    fn a_field_of_one_sign_has_an_empty_zero_set() {
        let grid = Grid::<2>::new(4);
        assert!(Hypersurface::zero_set(grid, &vec![1.0; grid.node_count()]).is_empty());
        assert!(Hypersurface::zero_set(grid, &vec![-1.0; grid.node_count()]).is_empty());
    }

    #[test]
    fn a_translation_keeps_the_measure() {
        let grid = Grid::<3>::new(8);
        let displacement: Vec<f64> = (0..grid.node_count()).flat_map(|_| [0.1, -0.05, 0.2]).collect();
        let sphere = ball::<3>(24, 0.2);
        assert!((sphere.moved(grid, &displacement).measure() / sphere.measure() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn segments_are_cut_and_joined_to_the_lengths_asked_for() {
        let square = [[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.2, 0.8]].map(DVec2::from);
        let edges: Vec<[DVec2; 2]> = (0..4).map(|k| [square[k], square[(k + 1) % 4]]).collect();
        let cut = Hypersurface::from_segments(&edges, 0.0, 0.1);
        assert_eq!(cut.simplices().len(), 24);
        assert!((cut.measure() - 2.4).abs() < 1e-12);

        let angle = |k: i32| DVec2::splat(0.5) + 0.3 * DVec2::from_angle(2.0 * PI * f64::from(k) / 1000.0);
        let dense: Vec<[DVec2; 2]> = (0..1000).map(|k| [angle(k), angle((k + 1) % 1000)]).collect();
        let joined = Hypersurface::from_segments(&dense, 0.01, 0.1);
        assert!(joined.simplices().len() <= 190 && joined.middles().all(|(_, length)| length < 0.02));
        assert!((joined.measure() / (2.0 * PI * 0.3) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn two_outlines_are_not_joined_and_a_speck_stays() {
        let speck = [[0.1, 0.1], [0.1001, 0.1], [0.1, 0.1001]].map(DVec2::from);
        let other = speck.map(|point| point + 0.5);
        let edges: Vec<[DVec2; 2]> =
            [speck, other].iter().flat_map(|loop_| (0..3).map(|k| [loop_[k], loop_[(k + 1) % 3]])).collect();
        let surface = Hypersurface::from_segments(&edges, 0.01, 0.1);
        assert_eq!(surface.simplices().len(), 2);
        assert!(surface.measure() < 1e-3);
    }
}
