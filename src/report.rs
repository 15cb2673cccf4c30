//! How good a match is: both distances, and how much of the template's outline φ(M1) makes up.

use crate::distance::SignedDistance;
use crate::grid::Grid;
use crate::hypersurface::{Hypersurface, Tree, image};
use std::sync::Arc;

/// A distance along a curve or surface, in cells; infinite where it is not defined, never NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread<const D: usize> {
    /// By measure.
    pub mean: f64,
    pub max: f64,
    /// Where it is greatest: on the template's side, in domain units. The box's middle if that is nowhere.
    pub at: [f64; D],
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report<const D: usize> {
    /// The distance of points of φ(M1) to M2.
    pub mismatch: Spread<D>,
    /// The distance of points of M2 to φ(M1).
    pub cover: Spread<D>,
    /// The measure of φ(M1) over that of M2, both as the grid sees them: 1, more where φ(M1) crumples, less where it
    /// leaves out parts of M2. Infinite where the grid sees no M2.
    pub measure: f64,
    /// |Dφ t| along M1, for D = 3 the ratio of areas.
    pub stretch: Stretch,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    pub mean: f64,
    pub deviation: f64,
}

/// The outlines of both shapes on a grid, to measure displacements by.
///
/// Distances are looked at in the corners and the middles of the outlines' simplices, as they were given where that is
/// known: the grid's own zero sets lack their corners. Lengths are taken on the zero sets: what is finer than the grid
/// is nothing that a deformation could smooth.
pub struct Outlines<const D: usize> {
    grid: Grid<D>,
    given: [Arc<Hypersurface<D>>; 2],
    /// Of the template as given.
    aim: Tree<D>,
    seen: [Hypersurface<D>; 2],
    /// Of the template's zero set.
    measure: f64,
}

impl<const D: usize> Outlines<D> {
    pub fn new(reference: &SignedDistance<D>, template: &SignedDistance<D>) -> Self {
        assert_eq!(template.grid(), reference.grid(), "both shapes live on one grid");
        let seen = [reference, template].map(|shape| Hypersurface::zero_set(shape.grid(), shape.values()));
        let given = [reference.outline(), template.outline()];
        Self { grid: reference.grid(), aim: Tree::new(given[1].clone()), given, measure: seen[1].measure(), seen }
    }

    /// Measures φ = x + u, u at the nodes of the grid.
    pub fn report(&self, displacement: &[f64]) -> Report<D> {
        let Self { grid, aim, given: [from, to], seen, .. } = self;
        assert_eq!(displacement.len(), grid.node_count() * D, "D numbers a node");
        let cells = grid.cells() as f64;
        let mismatch = Spread::along(from, |x| {
            let y = image(*grid, displacement, x);
            (aim.distance(&y) * cells, y)
        });
        let matched = Tree::new(from.moved(*grid, displacement));
        let cover = Spread::along(to, |y| (matched.distance(y) * cells, *y));
        let matched = seen[0].moved(*grid, displacement);
        let measure = ratio(matched.measure(), self.measure);
        Report { mismatch, cover, measure, stretch: Stretch::of(&seen[0], &matched) }
    }
}

/// Measures one displacement on the grid of both shapes.
pub fn report<const D: usize>(
    reference: &SignedDistance<D>,
    template: &SignedDistance<D>,
    displacement: &[f64],
) -> Report<D> {
    Outlines::new(reference, template).report(displacement)
}

impl<const D: usize> Spread<D> {
    /// `distance` gives the distance of a point, and where on the template's side it is.
    fn along(surface: &Hypersurface<D>, distance: impl Fn(&[f64; D]) -> (f64, [f64; D])) -> Self {
        let mut greatest = (f64::NEG_INFINITY, [0.5; D]);
        // A comparison, or `f64::max`, would pass over NaN.
        let defined = |value: f64| if value.is_nan() { f64::INFINITY } else { value };
        let mut look = |point: &[f64; D]| {
            let (value, at) = distance(point);
            let value = defined(value);
            if value > greatest.0 {
                greatest = (value, if at.iter().all(|x| x.is_finite()) { at } else { [0.5; D] });
            }
            value
        };
        surface.points().iter().for_each(|point| {
            look(point);
        });
        let (mut sum, mut whole) = (0.0, 0.0);
        for (middle, measure) in surface.middles() {
            let value = look(&middle);
            if measure > 0.0 {
                sum += measure * value;
                whole += measure;
            }
        }
        if surface.is_empty() {
            return Self { mean: f64::INFINITY, max: f64::INFINITY, at: greatest.1 };
        }
        // An outline without measure is a point.
        Self { mean: if whole > 0.0 { sum / whole } else { greatest.0 }, max: greatest.0, at: greatest.1 }
    }
}

impl Stretch {
    /// By the measures of simplices before and after; 1 ± 0 where these are not defined.
    fn of<const D: usize>(before: &Hypersurface<D>, after: &Hypersurface<D>) -> Self {
        let (mut whole, mut sum, mut squares) = (0.0, 0.0, 0.0);
        for ((_, from), (_, to)) in before.middles().zip(after.middles()) {
            if from > 0.0 {
                whole += from;
                sum += to;
                squares += to * to / from;
            }
        }
        let mean = sum / whole;
        if mean.is_nan() {
            return Self { mean: 1.0, deviation: 0.0 };
        }
        Self { mean, deviation: (squares / whole - mean * mean).max(0.0).sqrt() }
    }
}

fn ratio(matched: f64, template: f64) -> f64 {
    let ratio = matched / template;
    if template > 0.0 && !ratio.is_nan() { ratio } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use std::f64::consts::TAU;

    fn ball<const D: usize>(cells: usize, centre: [f64; D], radius: f64) -> SignedDistance<D> {
        let grid = Grid::<D>::new(cells);
        let distance = |x: [f64; D]| x.iter().zip(&centre).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt() - radius;
        SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|node| distance(grid.position(node))).collect())
    }

    fn circle(centre: [f64; 2], radius: f64) -> Vec<DVec2> {
        let angles = (0..720).map(|k| TAU * f64::from(k) / 720.0);
        angles.map(|angle| DVec2::from(centre) + radius * DVec2::from_angle(angle)).collect()
    }

    fn of_loops(loops: &[Vec<DVec2>]) -> SignedDistance<2> {
        SignedDistance::from_loops(Grid::new(128), loops).expect("a valid shape")
    }

    fn displacement<const D: usize>(grid: Grid<D>, u: impl Fn([f64; D]) -> [f64; D]) -> Vec<f64> {
        (0..grid.node_count()).flat_map(|node| u(grid.position(node))).collect()
    }

    fn a_shift_is_measured<const D: usize>(cells: usize) {
        let (from, to) = (ball::<D>(cells, [0.45; D], 0.25), ball::<D>(cells, [0.5; D], 0.25));
        let onto = report(&from, &to, &displacement(from.grid(), |_| [0.05; D]));
        assert!(onto.mismatch.max < 0.05 && onto.cover.max < 0.05, "{onto:?}");
        assert!((onto.measure - 1.0).abs() < 1e-3 && (onto.stretch.mean - 1.0).abs() < 1e-12, "{onto:?}");
        let short = report(&from, &to, &displacement(from.grid(), |_| [0.05 - 0.5 / cells as f64; D]));
        let expected = 0.5 * (D as f64).sqrt();
        assert!((short.mismatch.max - expected).abs() < 0.05, "{short:?}");
        assert!((short.cover.max - expected).abs() < 0.05, "{short:?}");
        assert!(short.cover.mean < 0.75 * expected && short.mismatch.mean < 0.75 * expected, "{short:?}");
    }

    #[test]
    fn a_ball_that_stops_short_of_its_like_is_that_far_away_both_ways() {
        a_shift_is_measured::<2>(64);
        a_shift_is_measured::<3>(32);
    }

    #[test]
    fn a_dilation_stretches_curves_by_its_factor_and_surfaces_by_its_square() {
        fn stretch<const D: usize>() -> f64 {
            let shape = ball::<D>(32, [0.5; D], 0.2);
            let larger = displacement(shape.grid(), |x| x.map(|x| 0.2 * (x - 0.5)));
            let result = report(&shape, &ball(32, [0.5; D], 0.24), &larger);
            assert!(result.mismatch.max < 0.1 && result.stretch.deviation < 1e-9, "{result:?}");
            result.stretch.mean
        }
        assert!((stretch::<2>() - 1.2).abs() < 1e-9 && (stretch::<3>() - 1.44).abs() < 1e-9);
    }

    #[test]
    fn a_ring_is_half_covered_by_a_disc() {
        let (disc, ring) =
            (of_loops(&[circle([0.5; 2], 0.3)]), of_loops(&[circle([0.5; 2], 0.3), circle([0.5; 2], 0.2)]));
        let result = report(&disc, &ring, &displacement(disc.grid(), |_| [0.0; 2]));
        assert!(result.mismatch.max < 0.05, "{result:?}");
        assert!((result.cover.max - 12.8).abs() < 0.02, "{result:?}");
        assert!((result.cover.mean - 0.4 * 12.8).abs() < 0.02, "{result:?}");
        assert!((result.measure - 0.6).abs() < 1e-3, "{result:?}");
        assert!((DVec2::from(result.cover.at).distance(DVec2::splat(0.5)) - 0.2).abs() < 1e-5, "{result:?}");
    }

    #[test]
    fn a_corner_that_the_grid_loses_counts() {
        let half = 0.2 + 0.3 / 128.0;
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| DVec2::splat(0.5) + half * DVec2::new(x, y));
        let (square, disc) = (of_loops(&[square.to_vec()]), of_loops(&[circle([0.5; 2], 0.2)]));
        let still = displacement(disc.grid(), |_| [0.0; 2]);
        let expected = (half * 2_f64.sqrt() - 0.2) * 128.0;
        let [there, back] = [report(&square, &disc, &still), report(&disc, &square, &still)];
        assert!((there.mismatch.max - expected).abs() < 0.01, "{there:?}, not {expected}");
        assert!((back.cover.max - expected).abs() < 0.01, "{back:?}, not {expected}");
    }

    #[test]
    fn a_wave_along_the_outline_is_longer_than_the_template() {
        let disc = ball::<2>(128, [0.5; 2], 0.3);
        let wave = displacement(disc.grid(), |x| [0.0, 0.02 * (20.0 * TAU * x[0]).sin()]);
        // By quadrature of the curve (0.3 cos t, 0.3 sin t + wave).
        let measure = report(&disc, &disc, &wave).measure;
        assert!((measure - 1.461).abs() < 0.05, "{measure}");
    }

    #[test]
    fn what_is_not_defined_is_infinitely_far_and_never_nan() {
        let disc = ball::<2>(16, [0.5; 2], 0.3);
        let nothing = SignedDistance::from_nodal(disc.grid(), vec![1.0; disc.grid().node_count()]);
        let still = displacement(disc.grid(), |_| [0.0; 2]);
        let broken = vec![f64::NAN; still.len()];
        for result in [
            report(&disc, &nothing, &still),
            report(&nothing, &disc, &still),
            report(&nothing, &nothing, &still),
            report(&disc, &disc, &broken),
        ] {
            assert!(result.mismatch.max == f64::INFINITY || result.cover.max == f64::INFINITY, "{result:?}");
            let stretch = result.stretch.mean;
            let all = [result.mismatch.mean, result.mismatch.max, result.cover.mean, result.cover.max, result.measure];
            assert!(all.iter().chain([&stretch]).all(|value| !value.is_nan()), "{result:?}");
        }
        assert_eq!(report(&nothing, &disc, &still).measure, 0.0);
    }
}
