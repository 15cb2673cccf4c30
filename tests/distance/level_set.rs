//! Level sets: re-distancing, and going to other grids.

use glam::DVec2;
use thinshell::contour::zero_set;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;

use crate::support::{CENTRE, error, error_where, from_loops, position, regular};

/// A level set of a ball that is no distance, with slope 2 at the surface and kinked nowhere.
fn bulging<const D: usize>(grid: Grid<D>, radius: f64) -> Vec<f64> {
    (0..grid.node_count())
        .map(|node| {
            let square: f64 = grid.position(node).iter().map(|x| (x - 0.47) * (x - 0.47)).sum();
            (square - radius * radius) / radius * (1.0 + 0.5 * (7.0 * grid.position(node)[0]).sin())
        })
        .collect()
}

/// Errors of redistancing: greatest within 0.1 of the surface, and greatest farther than 0.1 from the centre.
fn redistancing_errors<const D: usize>(cells: usize) -> [f64; 2] {
    let (grid, radius) = (Grid::<D>::new(cells), 0.25);
    let distance = SignedDistance::redistance(grid, &bulging(grid, radius)).unwrap();
    let mut errors = [0.0f64; 2];
    for (node, value) in distance.values().iter().enumerate() {
        let r = grid.position(node).iter().map(|x| (x - 0.47) * (x - 0.47)).sum::<f64>().sqrt();
        let error = (value - (r - radius)).abs();
        if (r - radius).abs() < 0.1 {
            errors[0] = errors[0].max(error);
        }
        if r > 0.1 {
            errors[1] = errors[1].max(error);
        }
    }
    errors
}

#[test]
fn redistancing_converges_faster_than_first_order_in_the_plane_and_in_space() {
    fn check(errors: &[[f64; 2]]) {
        for pair in errors.windows(2) {
            for (coarse, fine) in pair[0].iter().zip(pair[1]) {
                // Order 1.26: halving the spacing divides by 2 to 4, and the coarsest grids are not yet asymptotic.
                assert!(fine * 2.4 < *coarse, "{errors:?}");
            }
        }
    }
    check(&[32, 64, 128, 256].map(redistancing_errors::<2>));
    let space = [16, 32, 64].map(redistancing_errors::<3>);
    check(&space.map(|[_, everywhere]| [everywhere; 2]));
    // A few hundredths of a cell within the band of the energies.
    assert!(space[2][0] < 0.03 / 64.0, "{space:?}");
}

#[test]
fn redistancing_keeps_the_zero_set() {
    let grid = Grid::<2>::new(128);
    let values = bulging(grid, 0.25);
    let distance = SignedDistance::redistance(grid, &values).unwrap();
    for (before, after) in values.iter().zip(distance.values()) {
        assert_eq!(*before < 0.0, *after < 0.0);
    }
    let (before, after) = (zero_set(grid, &values), zero_set(grid, distance.values()));
    assert_eq!((before.len(), after.len()), (1, 1));
    assert_eq!(before[0].len(), after[0].len());
    for (old, new) in before[0].iter().zip(&after[0]) {
        // Both lie on the same edge of the grid; linear interpolation is off by h²/8 times the second derivative.
        assert!(old.distance(*new) < 0.05 * grid.spacing());
    }
}

#[test]
fn redistancing_a_distance_changes_little_near_the_shape() {
    let grid = Grid::<2>::new(128);
    let exact = |p: DVec2| p.distance(CENTRE) - 0.3;
    let values: Vec<_> = (0..grid.node_count()).map(|node| exact(position(grid, node))).collect();
    let distance = SignedDistance::redistance(grid, &values).unwrap();
    assert!(error_where(&distance, exact, |d| d.abs() < 0.05) < 0.01 * grid.spacing());
}

#[test]
fn redistancing_rough_data_still_finds_its_steps() {
    // ±1 knows the outline to half a cell only.
    let grid = Grid::<2>::new(64);
    let exact = |p: DVec2| p.distance(CENTRE) - 0.3;
    let values: Vec<_> = (0..grid.node_count()).map(|node| exact(position(grid, node)).signum()).collect();
    let distance = SignedDistance::redistance(grid, &values).unwrap();
    assert!(error(&distance, exact) < grid.spacing());
}

#[test]
fn a_coarser_grid_takes_the_common_nodes_and_a_finer_one_interpolates() {
    let distance = from_loops(64, &[regular(200, CENTRE, 0.25)]);
    let coarse = distance.to_cells(16);
    for (node, value) in coarse.values().iter().enumerate() {
        let index = coarse.grid().node_index(node).map(|i| 4 * i);
        assert_eq!(*value, distance.values()[distance.grid().node(index)]);
    }
    assert_eq!(distance.to_cells(256).to_cells(64).values(), distance.values());
    assert!(std::ptr::eq(distance.to_cells(64).values(), distance.values()), "the values of the same grid are shared");

    let grid = Grid::<3>::new(8);
    let trilinear = |p: [f64; 3]| (p[0] - 0.5) * (p[1] - 0.4) + p[2] - 0.5 + 0.1 * p[0] * p[1] * p[2];
    let on = |grid: Grid<3>| (0..grid.node_count()).map(|node| trilinear(grid.position(node))).collect::<Vec<_>>();
    // Not a shape that fits the box, so the border is pushed outside.
    let closed = |grid: Grid<3>, values: Vec<f64>| -> Vec<f64> {
        let outer =
            |node: usize| grid.node_index(node).iter().any(|&i| i * 8 < 3 * grid.cells() || i * 8 > 5 * grid.cells());
        values.into_iter().enumerate().map(|(node, value)| if outer(node) { 1.0 } else { value }).collect()
    };
    let level_set = SignedDistance::from_level_set(grid, closed(grid, on(grid))).unwrap();
    let (fine, expected) = (level_set.to_cells(16), on(Grid::new(16)));
    for node in 0..fine.grid().node_count() {
        if fine.grid().node_index(node).iter().all(|&i| (6..=10).contains(&i)) {
            assert!((fine.values()[node] - expected[node]).abs() < 1e-15);
        }
    }
}

#[test]
fn zero_is_outside_whatever_its_sign() {
    let grid = Grid::<2>::new(16);
    // A disc through many nodes, and as many zeros of both signs.
    let value = |zero: f64| {
        move |node: usize| {
            let [x, y] = grid.node_index(node).map(|i| i as f64 - 8.0);
            let value = (x * x + y * y - 25.0) / 160.0;
            if value == 0.0 { zero } else { value }
        }
    };
    let with = |zero: f64| -> Vec<f64> { (0..grid.node_count()).map(value(zero)).collect() };
    let (positive, negative) = (with(0.0), with(-0.0));
    assert!(positive.iter().filter(|value| **value == 0.0).count() > 10);
    let distances = [&positive, &negative].map(|values| SignedDistance::redistance(grid, values).unwrap());
    assert_eq!(distances[0].values(), distances[1].values());
    for (before, after) in positive.iter().zip(distances[0].values()) {
        assert_eq!(*before < 0.0, *after < 0.0);
    }
    assert_eq!(zero_set(grid, &positive), zero_set(grid, &negative));
}
