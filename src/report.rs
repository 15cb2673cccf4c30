//! How good a match is, measured along the reference.

use crate::field::{interpolate, interpolate_derivative};
use crate::grid::Grid;
use glam::DVec2;

/// Mean and greatest |d2(φ)| along M1, in cells; mean and standard deviation of the stretch |Dφ t| along M1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report {
    pub mismatch_mean: f64,
    pub mismatch_max: f64,
    pub stretch_mean: f64,
    pub stretch_deviation: f64,
}

/// Measures on the polylines of M1, each segment at its ends and its middle, averages by length.
pub fn report(grid: Grid<2>, reference: &[Vec<DVec2>], template: &[f64], displacement: &[f64]) -> Report {
    let mismatch = |x: DVec2| {
        let u = interpolate::<2, 2>(grid, displacement, &x.to_array());
        let [d] = interpolate::<2, 1>(grid, template, &[x.x + u[0], x.y + u[1]]);
        d.abs() * grid.cells() as f64
    };
    let (mut length, mut mean, mut max, mut stretch, mut square) = (0.0, 0.0, 0.0_f64, 0.0, 0.0);
    for polyline in reference {
        for (k, &start) in polyline.iter().enumerate() {
            let end = polyline[(k + 1) % polyline.len()];
            let (middle, chord) = (0.5 * (start + end), end - start);
            let weight = chord.length();
            if weight == 0.0 {
                continue;
            }
            let tangent = chord / weight;
            let at_middle = mismatch(middle);
            max = max.max(at_middle).max(mismatch(start));
            let slope = interpolate_derivative::<2, 2>(grid, displacement, &middle.to_array());
            let image = tangent + DVec2::from(slope.map(|row| row[0] * tangent.x + row[1] * tangent.y));
            length += weight;
            mean += weight * at_middle;
            stretch += weight * image.length();
            square += weight * image.length_squared();
        }
    }
    let (mean, stretch, square) = (mean / length, stretch / length, square / length);
    Report {
        mismatch_mean: mean,
        mismatch_max: max,
        stretch_mean: stretch,
        stretch_deviation: (square - stretch * stretch).max(0.0).sqrt(),
    }
}
