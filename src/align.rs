//! The initial deformation.

use crate::distance::SignedDistance;
use crate::grid::Grid;
use crate::small::{Matrix, apply, identity};
use glam::DVec2;

/// Rotations tried in the plane: every 10°, whose cosine and sine these are.
const ANGLES: usize = 36;
const STEP: DVec2 = DVec2::new(0.984_807_753_012_208_1, 0.173_648_177_666_930_35);
/// Rotations tried in space, besides none.
const ROTATIONS: usize = 120;

/// A similarity x ↦ c₂ + s R (x − c₁) that takes the reference's centroid and measure to the template's.
pub struct Similarity<const D: usize> {
    from: [f64; D],
    to: [f64; D],
    scale: f64,
    rotation: Matrix<f64, D>,
}

impl<const D: usize> Similarity<D> {
    /// The angle of the rotation, 0 to π.
    pub fn turn(&self) -> f64 {
        angle(&self.rotation)
    }

    /// Its displacement at the nodes.
    pub fn displacement(&self, grid: Grid<D>) -> Vec<f64> {
        let mut displacement = Vec::with_capacity(grid.node_count() * D);
        for node in 0..grid.node_count() {
            let x = grid.position(node);
            let turned = apply(&self.rotation, &std::array::from_fn(|axis| x[axis] - self.from[axis]));
            displacement.extend((0..D).map(|axis| self.to[axis] + self.scale * turned[axis] - x[axis]));
        }
        displacement
    }
}

/// The similarities with rotations spread evenly, the first without.
pub fn similarities<const D: usize>(reference: &SignedDistance<D>, template: &SignedDistance<D>) -> Vec<Similarity<D>> {
    let (from, to) = (Body::of(reference), Body::of(template));
    let scale = (to.measure / from.measure).powf(1.0 / D as f64);
    let of = |rotation| Similarity { from: from.centroid, to: to.centroid, scale, rotation };
    rotations().into_iter().map(of).collect()
}

/// The similarities whose rotations are next to that of number k.
pub fn neighbours<const D: usize>(all: &[Similarity<D>], k: usize) -> impl Iterator<Item = usize> {
    // A little more than the distance to the nearest ones.
    let reach = if D == 2 { 15_f64 } else { 50.0 }.to_radians();
    (0..all.len()).filter(move |&other| other != k && angle_between(&all[k].rotation, &all[other].rotation) < reach)
}

/// The angle of a rotation: tr R = D − 2 + 2 cos.
fn angle<const D: usize>(rotation: &Matrix<f64, D>) -> f64 {
    angle_between(rotation, &identity())
}

/// tr(Aᵀ B) is the sum of the products of the entries.
fn angle_between<const D: usize>(a: &Matrix<f64, D>, b: &Matrix<f64, D>) -> f64 {
    let trace: f64 = a.as_flattened().iter().zip(b.as_flattened()).map(|(x, y)| x * y).sum();
    (0.5 * (trace - (D as f64 - 2.0))).clamp(-1.0, 1.0).acos()
}

/// The identity, then rotations spread evenly: equal angles in the plane; in space points of a spiral on the sphere of unit
/// quaternions.
///
/// Source: M. Alexa, "Super-Fibonacci Spirals: Fast, Low-Discrepancy Sampling of SO(3)", CVPR 2022.
fn rotations<const D: usize>() -> Vec<Matrix<f64, D>> {
    use std::f64::consts::{SQRT_2, TAU};
    /// The real root of ψ⁴ = ψ + 4.
    const PSI: f64 = 1.533_751_168_755_204_3;
    let mut rotations = vec![identity()];
    if D == 2 {
        let turns = std::iter::successors(Some(STEP), |turn| Some(turn.rotate(STEP)));
        rotations.extend(turns.take(ANGLES - 1).map(|turn| {
            let entries = [turn.x, -turn.y, turn.y, turn.x];
            std::array::from_fn(|i| std::array::from_fn(|j| entries[2 * i + j]))
        }));
        return rotations;
    }
    rotations.extend((0..ROTATIONS).map(|k| {
        let place = k as f64 + 0.5;
        let height = place / ROTATIONS as f64;
        let (a, b) = (height.sqrt(), (1.0 - height).sqrt());
        let (alpha, beta) = (TAU * place / SQRT_2, TAU * place / PSI);
        of_quaternion([a * alpha.sin(), a * alpha.cos(), b * beta.sin(), b * beta.cos()])
    }));
    rotations
}

/// Of the unit quaternion x i + y j + z k + w.
fn of_quaternion<const D: usize>([x, y, z, w]: [f64; 4]) -> Matrix<f64, D> {
    let m = glam::DMat3::from_quat(glam::DQuat::from_xyzw(x, y, z, w));
    std::array::from_fn(|i| std::array::from_fn(|j| m.col(j)[i]))
}

/// Length (area for D = 3) of the boundary of what a distance function encloses.
pub fn boundary_measure<const D: usize>(shape: &SignedDistance<D>) -> f64 {
    let grid = shape.grid();
    // The measure of |d| < 2h, by nodes, over its thickness; inner and outer curvature cancel to first order.
    let width = 2.0 * grid.spacing();
    let near = shape.values().iter().filter(|value| value.abs() < width).count();
    near as f64 * grid.spacing().powi(D as i32) / (2.0 * width)
}

/// Measure (area, volume) and centroid of what a distance function encloses.
struct Body<const D: usize> {
    measure: f64,
    centroid: [f64; D],
}

impl<const D: usize> Body<D> {
    fn of(shape: &SignedDistance<D>) -> Self {
        let grid = shape.grid();
        let (mut total, mut moment) = (0.0, [0.0; D]);
        for (node, value) in shape.values().iter().enumerate() {
            // The part of the node's cell that lies inside, as if the boundary were straight across it.
            let share = (0.5 - value / grid.spacing()).clamp(0.0, 1.0);
            total += share;
            for (m, x) in moment.iter_mut().zip(grid.position(node)) {
                *m += share * x;
            }
        }
        Self { measure: total * grid.spacing().powi(D as i32), centroid: moment.map(|m| m / total) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ball<const D: usize>(grid: Grid<D>, centre: [f64; D], radius: f64) -> SignedDistance<D> {
        let distance = |x: [f64; D]| x.iter().zip(&centre).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt() - radius;
        SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|k| distance(grid.position(k))).collect())
    }

    #[test]
    fn the_boundary_of_a_ball_is_measured_to_two_per_cent() {
        let circle = boundary_measure(&ball(Grid::<2>::new(128), [0.5; 2], 0.3));
        assert!((circle / (std::f64::consts::TAU * 0.3) - 1.0).abs() < 0.02, "{circle}");
        let sphere = boundary_measure(&ball(Grid::<3>::new(64), [0.5; 3], 0.3));
        assert!((sphere / (4.0 * std::f64::consts::PI * 0.09) - 1.0).abs() < 0.02, "{sphere}");
    }

    #[test]
    fn a_ball_is_moved_onto_another_by_the_first_similarity() {
        let grid = Grid::<2>::new(64);
        let (from, to) = (ball(grid, [0.4, 0.45], 0.2), ball(grid, [0.55, 0.5], 0.3));
        let displacement = similarities(&from, &to)[0].displacement(grid);
        for node in 0..grid.node_count() {
            let x = grid.position(node);
            for (axis, (from, to)) in [(0.4, 0.55), (0.45, 0.5)].into_iter().enumerate() {
                let expected = to + 1.5 * (x[axis] - from);
                assert!((x[axis] + displacement[node * 2 + axis] - expected).abs() < 2e-3);
            }
        }
    }

    /// No rotation is farther than this from one that is tried.
    fn rotations_are_dense<const D: usize>(farthest_degrees: f64) {
        const TURNS: usize = 500;
        let all = rotations::<D>();
        for rotation in &all {
            let square: f64 = rotation.as_flattened().iter().map(|x| x * x).sum();
            assert!((square - D as f64).abs() < 1e-12 && (crate::small::determinant(rotation) - 1.0).abs() < 1e-12);
        }
        for k in 0..TURNS {
            // Another sequence of rotations: products of those tried with turns about axes of every direction.
            let turn: Matrix<f64, D> = {
                let height = if D == 2 { 1.0 } else { 1.0 - (2.0 * k as f64 + 1.0) / TURNS as f64 };
                let (across, along) = ((1.0 - height * height).sqrt(), glam::DVec2::from_angle(2.4 * k as f64));
                let (sin, cos) = (0.37 * k as f64).sin_cos();
                of_quaternion([sin * across * along.x, sin * across * along.y, sin * height, cos])
            };
            let other = &all[(7 * k) % all.len()];
            let product: Matrix<f64, D> =
                std::array::from_fn(|i| std::array::from_fn(|j| (0..D).map(|l| turn[i][l] * other[l][j]).sum()));
            let nearest = all.iter().map(|known| angle_between(known, &product)).fold(f64::INFINITY, f64::min);
            assert!(nearest.to_degrees() < farthest_degrees, "{} degrees from any", nearest.to_degrees());
        }
    }

    #[test]
    fn every_rotation_is_near_one_that_is_tried() {
        rotations_are_dense::<2>(5.01);
        rotations_are_dense::<3>(45.0);
    }
}
