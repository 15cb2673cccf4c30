//! Closed polygons: simple, nested, crossing, overlapping.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use crate::support::{CENTRE, at, error, from_loops, position, rectangle, rectangle_distance, regular, reversed};

#[test]
fn a_polygon_with_many_corners_has_the_distance_of_its_circle() {
    let (radius, corners) = (0.3, 512);
    let distance = from_loops(128, &[regular(corners, CENTRE, radius)]);
    let sagitta = radius * (1.0 - (PI / corners as f64).cos());
    assert!(error(&distance, |p| p.distance(CENTRE) - radius) <= sagitta + 1e-14);
}

#[test]
fn a_rectangle_has_its_exact_distance_everywhere() {
    let (low, high) = ([0.2, 0.31], [0.71, 0.8]);
    let distance = from_loops(64, &[rectangle(low, high)]);
    assert!(error(&distance, |p| rectangle_distance(p, low, high)) < 1e-14);
}

#[test]
fn a_square_with_a_hole_is_the_square_less_the_hole_whatever_the_orientations() {
    let (outer, inner) = (([0.2, 0.2], [0.8, 0.8]), ([0.4, 0.45], [0.6, 0.55]));
    let exact = |p| {
        let (outside, hole) = (rectangle_distance(p, outer.0, outer.1), rectangle_distance(p, inner.0, inner.1));
        outside.max(-hole)
    };
    let (outer, inner) = (rectangle(outer.0, outer.1), rectangle(inner.0, inner.1));
    for loops in [
        [outer.clone(), inner.clone()],
        [outer.clone(), reversed(&inner)],
        [reversed(&outer), inner.clone()],
        [inner.clone(), outer.clone()],
    ] {
        let distance = from_loops(64, &loops);
        assert!(error(&distance, exact) < 1e-14);
    }
}

#[test]
fn nested_loops_alternate_between_body_and_hole() {
    let radii = [0.4, 0.3, 0.2, 0.1];
    let loops = radii.map(|radius| regular(400, CENTRE, radius));
    let distance = from_loops(64, &loops);
    for (node, value) in distance.values().iter().enumerate() {
        let r = position(distance.grid(), node).distance(CENTRE);
        let nearest = radii.iter().map(|radius| (r - radius).abs()).fold(f64::INFINITY, f64::min);
        let inside = radii.iter().filter(|radius| r < **radius).count() % 2 == 1;
        if nearest > 1e-4 {
            assert_eq!(*value < 0.0, inside, "at radius {r}");
        }
        assert!((value.abs() - nearest).abs() < 1e-4);
    }
}

#[test]
fn a_figure_of_eight_fills_both_its_lobes() {
    let eight = [[0.2, 0.3], [0.8, 0.7], [0.8, 0.3], [0.2, 0.7]].map(DVec2::from);
    let explicit = [[0.2, 0.3], [0.5, 0.5], [0.8, 0.7], [0.8, 0.3], [0.5, 0.5], [0.2, 0.7]].map(DVec2::from);
    let lobes = [[0, 1, 5], [2, 3, 1]].map(|corners| corners.map(|corner| explicit[corner]).to_vec());
    let apart = from_loops(64, &lobes);
    for sketch in [eight.to_vec(), explicit.to_vec(), reversed(&eight)] {
        let distance = from_loops(64, &[sketch]);
        assert!(at(&distance, [0.25, 0.5]) < 0.0 && at(&distance, [0.75, 0.5]) < 0.0);
        assert!(at(&distance, [0.5, 0.25]) > 0.0 && at(&distance, [0.5, 0.75]) > 0.0);
        for (found, expected) in distance.values().iter().zip(apart.values()) {
            assert!((found - expected).abs() < 1e-12);
        }
    }
}

#[test]
fn a_pentagram_is_filled_and_its_inner_strokes_have_no_distance() {
    let corners = regular(5, CENTRE, 0.35).iter().map(|p| CENTRE + (*p - CENTRE).perp()).collect::<Vec<_>>();
    let star: Vec<_> = (0..5).map(|k| corners[2 * k % 5]).collect();
    // The outline alternates between the corners and the crossings, which lie at 1/φ² of the radius.
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let outline: Vec<_> = (0..5)
        .flat_map(|k| {
            let between = (corners[k] + corners[(k + 1) % 5]) * 0.5 - CENTRE;
            [corners[k], CENTRE + between.normalize() * 0.35 / (golden * golden)]
        })
        .collect();
    let (crossed, simple) = (from_loops(128, &[star]), from_loops(128, &[outline]));
    for (found, expected) in crossed.values().iter().zip(simple.values()) {
        assert!((found - expected).abs() < 1e-12);
    }
    assert!(at(&crossed, [0.5, 0.5]) < -0.13);
}

#[test]
fn loops_that_partly_overlap_unite() {
    let parts = [rectangle([0.2, 0.2], [0.6, 0.6]), rectangle([0.4, 0.4], [0.8, 0.8])];
    let union = [[0.2, 0.2], [0.6, 0.2], [0.6, 0.4], [0.8, 0.4], [0.8, 0.8], [0.4, 0.8], [0.4, 0.6], [0.2, 0.6]];
    let (found, expected) = (from_loops(64, &parts), from_loops(64, &[union.map(DVec2::from).to_vec()]));
    for (found, expected) in found.values().iter().zip(expected.values()) {
        assert!((found - expected).abs() < 1e-12);
    }
}

#[test]
fn loops_that_share_an_edge_or_repeat_each_other_unite_without_a_seam() {
    let whole = from_loops(64, &[rectangle([0.2, 0.2], [0.8, 0.6])]);
    let (left, right) = (rectangle([0.2, 0.2], [0.5, 0.6]), rectangle([0.5, 0.2], [0.8, 0.6]));
    let outer = rectangle([0.2, 0.2], [0.8, 0.6]);
    for loops in [
        vec![left.clone(), right.clone()],
        vec![left.clone(), reversed(&right)],
        vec![outer.clone(), outer.clone()],
        vec![outer.clone(), reversed(&outer)],
    ] {
        let distance = from_loops(64, &loops);
        for (found, expected) in distance.values().iter().zip(whole.values()) {
            assert!((found - expected).abs() < 1e-12);
        }
    }
}

#[test]
fn an_outline_that_loops_share_is_as_long_as_one() {
    let square = rectangle([0.2, 0.2], [0.8, 0.6]);
    // The same square again with a corner more, so that the loops are not equal.
    let mut other = square.clone();
    other.insert(1, DVec2::new(0.5, 0.2));
    let distance = from_loops(64, &[square, other]);
    assert!((distance.outline().measure() - 2.0).abs() < 1e-9, "{}", distance.outline().measure());
}

#[test]
fn strokes_that_enclose_nothing_leave_no_trace() {
    let plain = rectangle([0.3, 0.3], [0.7, 0.7]);
    let mut haired = plain.clone();
    // Out along a hair and back, and once along an edge to and fro.
    haired.splice(1..1, [[0.5, 0.3], [0.5, 0.1], [0.5, 0.3], [0.6, 0.3], [0.4, 0.3]].map(DVec2::from));
    let repeated: Vec<_> = plain.iter().flat_map(|p| [*p, *p, *p]).chain([plain[0]]).collect();
    let expected = from_loops(64, &[plain]);
    for sketch in [haired, repeated] {
        let distance = from_loops(64, &[sketch]);
        for (found, expected) in distance.values().iter().zip(expected.values()) {
            assert!((found - expected).abs() < 1e-12);
        }
    }
}

#[test]
fn moving_a_shape_by_whole_cells_moves_its_values() {
    let blob: Vec<_> = (0..200)
        .map(|k| TAU * k as f64 / 200.0)
        .map(|t| CENTRE + (0.2 + 0.05 * (3.0 * t).cos()) * DVec2::from_angle(t))
        .collect();
    let moved: Vec<_> = blob.iter().map(|p| *p + DVec2::new(5.0, -3.0) / 64.0).collect();
    let (before, after) = (from_loops(64, &[blob]), from_loops(64, &[moved]));
    let grid = before.grid();
    for y in 3..=64 {
        for x in 0..=59 {
            let (old, new) = (before.values()[grid.node([x, y])], after.values()[grid.node([x + 5, y - 3])]);
            assert!((old - new).abs() < 1e-14);
        }
    }
}

#[test]
fn the_gradient_has_length_one_away_from_the_skeleton() {
    let distance = from_loops(128, &[regular(512, CENTRE, 0.3)]);
    let (grid, d) = (distance.grid(), distance.values());
    let mut greatest: f64 = 0.0;
    for y in 1..128 {
        for x in 1..128 {
            let node = grid.node([x, y]);
            if position(grid, node).distance(CENTRE) > 0.1 {
                let slope = |stride: usize| (d[node + stride] - d[node - stride]) / (2.0 * grid.spacing());
                greatest = greatest.max((slope(grid.stride(0)).hypot(slope(grid.stride(1))) - 1.0).abs());
            }
        }
    }
    assert!(greatest < 2e-3, "{greatest}");
}
