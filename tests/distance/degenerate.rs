//! Random loops full of repeats, shared edges and corners, and triple crossings.

use std::f64::consts::TAU;
use std::mem::discriminant;

use glam::DVec2;
use proptest::prelude::*;
use thinshell::distance::SignedDistance;
use thinshell::error::ShapeError;
use thinshell::grid::Grid;

use crate::support::{position, reversed, segment_distance};

/// |d(p) − d(q)| ≤ |p − q|: the outline separates every inner node from every outer one. (Signs count from 1e-8 on.)
fn is_lipschitz(distance: &SignedDistance<2>) -> bool {
    let (grid, d) = (distance.grid(), distance.values());
    (0..grid.node_count()).all(|node| {
        let [x, y] = grid.node_index(node);
        let right = x == grid.cells() || (d[node] - d[node + 1]).abs() <= grid.spacing() + 1e-8;
        let above = y == grid.cells() || (d[node] - d[node + grid.stride(1)]).abs() <= grid.spacing() + 1e-8;
        right && above
    })
}

/// Points on a lattice of tenths: repeats, shared edges and corners, and triple crossings all the time.
fn lattice_loop() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec((2u8..=8, 2u8..=8), 3..12)
        .prop_map(|points| points.into_iter().map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)) / 10.0).collect())
}

/// The winding number by summing angles: slow, and nothing like the code under test.
fn winding(points: &[DVec2], p: DVec2) -> i32 {
    let turn: f64 = (0..points.len()).map(|k| (points[k] - p).angle_to(points[(k + 1) % points.len()] - p)).sum();
    (turn / TAU).round() as i32
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_loops_however_degenerate_break_the_distance(loops in prop::collection::vec(lattice_loop(), 1..5)) {
        match SignedDistance::from_loops(Grid::new(24), &loops) {
            Ok(distance) => {
                prop_assert!(distance.values().iter().all(|d| d.is_finite()));
                prop_assert!(is_lipschitz(&distance));
            }
            Err(error) => {
                let expected = matches!(
                    error,
                    ShapeError::NoArea
                        | ShapeError::TooFewPoints { .. }
                        | ShapeError::TooSmall { .. }
                        | ShapeError::TooThin { .. }
                );
                prop_assert!(expected, "{}", error);
            }
        }
    }

    #[test]
    fn turning_loops_round_or_starting_elsewhere_changes_nothing(
        points in lattice_loop(), start in 0usize..12, wobble in prop::collection::vec(-1.0..1.0f64, 24),
    ) {
        let moved: Vec<_> =
            points.iter().zip(wobble.chunks(2)).map(|(p, w)| *p + 0.04 * DVec2::new(w[0], w[1])).collect();
        let mut other = reversed(&moved);
        other.rotate_left(start % moved.len());
        let make = |points| SignedDistance::from_loops(Grid::new(24), &[points]);
        match (make(moved), make(other)) {
            (Ok(one), Ok(two)) => for (a, b) in one.values().iter().zip(two.values()) {
                prop_assert!((a - b).abs() < 1e-8);
            },
            // The share of an outline that a grid sees may be rounded differently.
            (one, two) => prop_assert_eq!(one.err().as_ref().map(discriminant), two.err().as_ref().map(discriminant)),
        }
    }

    #[test]
    fn a_loop_is_the_outline_of_its_non_zero_winding(turns in prop::collection::vec(2u8..=8, 4..16)) {
        // Every other number moves along x, the others along y; the last corner leads back at a right angle.
        let mut corners = Vec::new();
        let (mut x, mut y) = (turns[0], turns[1]);
        for (k, &turn) in turns.iter().enumerate().skip(2) {
            corners.push(DVec2::new(f64::from(x), f64::from(y)) / 10.0);
            if k % 2 == 0 { x = turn } else { y = turn }
        }
        corners.push(DVec2::new(f64::from(x), f64::from(y)) / 10.0);
        let last = corners[corners.len() - 1];
        corners.push(DVec2::new(last.x, corners[0].y));

        let filled = |i: i32, j: i32| winding(&corners, DVec2::new(f64::from(i) + 0.5, f64::from(j) + 0.5) / 10.0) != 0;
        let node = |i: i32, j: i32| DVec2::new(f64::from(i), f64::from(j)) / 10.0;
        let outline: Vec<_> = (0..10)
            .flat_map(|i| (0..10).map(move |j| (i, j)))
            .flat_map(|(i, j)| {
                let upright = (filled(i, j) != filled(i - 1, j)).then(|| [node(i, j), node(i, j + 1)]);
                let level = (filled(i, j) != filled(i, j - 1)).then(|| [node(i, j), node(i + 1, j)]);
                [upright, level]
            })
            .flatten()
            .collect();
        match SignedDistance::from_loops(Grid::new(24), std::slice::from_ref(&corners)) {
            Ok(distance) => {
                let unsigned = |p: DVec2| {
                    outline.iter().map(|&[a, b]| segment_distance(p, a, b)).fold(f64::INFINITY, f64::min)
                };
                for (node, value) in distance.values().iter().enumerate() {
                    let p = position(distance.grid(), node);
                    prop_assert!((value.abs() - unsigned(p)).abs() < 1e-12);
                    if unsigned(p) > 1e-6 {
                        // Off the strokes: on them no angle is defined.
                        prop_assert_eq!(*value < 0.0, winding(&corners, p + DVec2::new(3e-7, 2e-7)) != 0);
                    }
                }
            }
            Err(ShapeError::NoArea | ShapeError::TooFewPoints { .. }) => prop_assert!(outline.is_empty()),
            Err(other) => prop_assert!(false, "{}", other),
        }
    }
}
