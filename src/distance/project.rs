//! Closest points on the zero set of the cubic interpolant of nodal values.

use crate::grid::Grid;
use crate::small::{add_scaled, dot};

/// Piecewise cubic interpolation: in each cell, the tensor product of the cubics through the four nodes around it on
/// every axis; along the border the neighbouring cell's cubic goes on. Lengths are in cells.
pub(super) struct Cubic<'a, const D: usize> {
    grid: Grid<D>,
    values: &'a [f64],
}

impl<'a, const D: usize> Cubic<'a, D> {
    pub fn new(grid: Grid<D>, values: &'a [f64]) -> Self {
        Self { grid, values }
    }

    /// The distance from a node to the zero set, `None` if the search does not converge.
    ///
    /// D. L. Chopp's iteration: a Newton step onto the zero set along the gradient, and a step along the level set
    /// towards the foot of the perpendicular from the node.
    pub fn distance(&self, node: [usize; D]) -> Option<f64> {
        if self.grid.cells() < 3 {
            return None;
        }
        let start = node.map(|i| i as f64);
        let mut foot = start;
        for _ in 0..20 {
            let (value, gradient) = self.evaluate(&foot);
            let square = dot(&gradient, &gradient);
            let back: [f64; D] = std::array::from_fn(|k| start[k] - foot[k]);
            // Back to the node, less the part along the gradient, and on to the zero set.
            let along = -(value + dot(&back, &gradient)) / square;
            let step = add_scaled(&back, along, &gradient);
            let length = dot(&step, &step).sqrt();
            if !length.is_finite() || length > 2.0 {
                return None;
            }
            foot = add_scaled(&foot, 1.0, &step);
            if length < 1e-9 {
                let offset = add_scaled(&foot, -1.0, &start);
                return Some(dot(&offset, &offset).sqrt());
            }
        }
        None
    }

    fn evaluate(&self, point: &[f64; D]) -> (f64, [f64; D]) {
        let last = (self.grid.cells() - 2) as f64;
        let lowest = point.map(|x| (x.floor().max(1.0).min(last) as usize) - 1);
        let axes: [_; D] = std::array::from_fn(|k| cubic_weights(point[k] - (lowest[k] + 1) as f64));
        let (mut value, mut gradient) = (0.0, [0.0; D]);
        for corner in 0..1usize << (2 * D) {
            let part = |axis: usize| corner >> (2 * axis) & 3;
            let nodal = self.values[self.grid.node(std::array::from_fn(|k| lowest[k] + part(k)))];
            value += nodal * (0..D).map(|k| axes[k].0[part(k)]).product::<f64>();
            for (direction, derivative) in gradient.iter_mut().enumerate() {
                let weight = |k: usize| if k == direction { axes[k].1[part(k)] } else { axes[k].0[part(k)] };
                *derivative += nodal * (0..D).map(weight).product::<f64>();
            }
        }
        (value, gradient)
    }
}

/// The Lagrange polynomials of the nodes −1, 0, 1, 2 at t, and their derivatives.
fn cubic_weights(t: f64) -> ([f64; 4], [f64; 4]) {
    let s = t * t;
    (
        [
            -t * (t - 1.0) * (t - 2.0) / 6.0,
            (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
            -(t + 1.0) * t * (t - 2.0) / 2.0,
            (t + 1.0) * t * (t - 1.0) / 6.0,
        ],
        [
            -(3.0 * s - 6.0 * t + 2.0) / 6.0,
            (3.0 * s - 4.0 * t - 1.0) / 2.0,
            -(3.0 * s - 2.0 * t - 2.0) / 2.0,
            (3.0 * s - 1.0) / 6.0,
        ],
    )
}
