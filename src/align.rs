//! The initial deformation.

use crate::distance::SignedDistance;
use crate::grid::Grid;

/// Angles tried by [`similarities`].
const ANGLES: usize = 36;

/// Displacements of the similarities x ↦ c₂ + s R (x − c₁) that take the reference's centroid and measure to the
/// template's, turned by multiples of 10° in the first two axes.
pub fn similarities<const D: usize>(
    grid: Grid<D>,
    reference: &SignedDistance<D>,
    template: &SignedDistance<D>,
) -> impl Iterator<Item = Vec<f64>> {
    let (from, to) = (Body::of(reference), Body::of(template));
    let scale = (to.measure / from.measure).powf(1.0 / D as f64);
    (0..ANGLES).map(move |k| {
        let (sin, cos) = (std::f64::consts::TAU * k as f64 / ANGLES as f64).sin_cos();
        let mut displacement = Vec::with_capacity(grid.node_count() * D);
        for node in 0..grid.node_count() {
            let x = grid.position(node);
            let offset: [f64; D] = std::array::from_fn(|axis| x[axis] - from.centroid[axis]);
            let mut turned = offset;
            turned[0] = cos * offset[0] - sin * offset[1];
            turned[1] = sin * offset[0] + cos * offset[1];
            displacement.extend((0..D).map(|axis| to.centroid[axis] + scale * turned[axis] - x[axis]));
        }
        displacement
    })
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
        let displacement = similarities(grid, &from, &to).next().unwrap();
        for node in 0..grid.node_count() {
            let x = grid.position(node);
            for (axis, (from, to)) in [(0.4, 0.55), (0.45, 0.5)].into_iter().enumerate() {
                let expected = to + 1.5 * (x[axis] - from);
                assert!((x[axis] + displacement[node * 2 + axis] - expected).abs() < 2e-3);
            }
        }
    }
}
