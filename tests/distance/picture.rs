//! Masks, and contours there and back.

use glam::DVec2;
use thinshell::contour::zero_set;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;

use crate::support::{CENTRE, area, at, error, from_loops, regular};

#[test]
fn a_mask_of_a_disc_has_the_disc_s_distance_within_half_a_pixel() {
    let (width, height, radius) = (200usize, 120usize, 0.2);
    let centre = DVec2::new(0.46, 0.52);
    // The longest side spans [0,1], the shorter is centred, row 0 is on top.
    let pixel = 1.0 / width as f64;
    let offset = 0.5 * (1.0 - height as f64 * pixel);
    let depth = |i: usize| {
        let (column, row) = (i % width, i / width);
        let p = DVec2::new(column as f64 + 0.5, (height - 1 - row) as f64 + 0.5) * pixel + DVec2::new(0.0, offset);
        (radius - p.distance(centre)) / pixel
    };
    let exact = |p: DVec2| p.distance(centre) - radius;
    let from = |data: &[u8]| SignedDistance::from_mask(Grid::new(64), width, height, data).unwrap();
    let hard: Vec<_> = (0..width * height).map(|i| if depth(i) > 0.0 { 255 } else { 0 }).collect();
    assert!(error(&from(&hard), exact) < 0.5 * pixel);
    let smooth: Vec<_> = (0..width * height).map(|i| (127.5 + 255.0 * depth(i)).clamp(0.0, 255.0) as u8).collect();
    assert!(error(&from(&smooth), exact) < 0.1 * pixel);
}

#[test]
fn a_mask_keeps_its_holes_and_components() {
    let side = 100usize;
    let inside = |x: usize, y: usize| {
        let ring = (20..60).contains(&x) && (20..60).contains(&y) && !((30..50).contains(&x) && (30..50).contains(&y));
        let islet = (38..42).contains(&x) && (38..42).contains(&y);
        ring || islet || ((70..80).contains(&x) && (20..80).contains(&y))
    };
    // Written bottom row first, then turned: row 0 is on top.
    let rows: Vec<Vec<u8>> =
        (0..side).map(|y| (0..side).map(|x| if inside(x, y) { 200 } else { 40 }).collect()).collect();
    let data: Vec<u8> = rows.into_iter().rev().flatten().collect();
    let distance = SignedDistance::from_mask(Grid::new(50), side, side, &data).unwrap();
    let expected =
        [([0.24, 0.4], true), ([0.34, 0.4], false), ([0.4, 0.4], true), ([0.74, 0.7], true), ([0.4, 0.7], false)];
    for (point, within) in expected {
        assert_eq!(at(&distance, point) < 0.0, within, "at {point:?}");
    }
    // Between a pixel of 200 and one of 40 the grey of 127.5 is passed 0.453 of a pixel from the bright one.
    assert!((at(&distance, [0.6, 0.4]) - (0.6 - (0.595 + 0.01 * 72.5 / 160.0))).abs() < 1e-12);
}

#[test]
fn contours_give_back_the_loops_they_came_from() {
    let (outer, inner) = (regular(300, CENTRE, 0.35), regular(300, CENTRE, 0.15));
    let distance = from_loops(128, &[outer.clone(), inner.clone()]);
    let found = zero_set(distance.grid(), distance.values());
    assert_eq!(found.len(), 2);
    let mut areas: Vec<_> = found.iter().map(|points| area(points)).collect();
    areas.sort_by(f64::total_cmp);
    // Counter-clockwise around the body, clockwise around the hole.
    assert!((areas[0] + area(&inner)).abs() < 1e-4 && (areas[1] - area(&outer)).abs() < 1e-4, "{areas:?}");
    for point in found.iter().flatten() {
        let r = point.distance(CENTRE);
        assert!((r - 0.35).abs().min((r - 0.15).abs()) < 1e-4);
    }
    let again = from_loops(128, &found);
    for (first, second) in distance.values().iter().zip(again.values()) {
        assert!((first - second).abs() < 2e-4);
    }
}

#[test]
fn contours_close_along_the_border_and_tell_saddles_apart() {
    let grid = Grid::<2>::new(2);
    let negative = |nodes: &[usize], centre: f64| {
        let mut values = [1.0; 9];
        for &node in nodes {
            values[node] = -1.0;
        }
        values[4] = centre;
        values
    };
    // A corner: the triangle of its half edges, closed at the node itself.
    let corner = zero_set(grid, &negative(&[0], 1.0));
    assert_eq!(corner.len(), 1);
    assert!((area(&corner[0]) - 0.5 * 0.25 * 0.25).abs() < 1e-15);
    // Two negative nodes on a diagonal: apart if the saddle is positive, joined if it is negative.
    assert_eq!(zero_set(grid, &negative(&[3, 7], 2.0)).len(), 2);
    assert_eq!(zero_set(grid, &negative(&[3, 7], 0.5)).len(), 1);
    assert!(zero_set(grid, &[1.0; 9]).is_empty());
    assert!((area(&zero_set(grid, &[-1.0; 9])[0]) - 1.0).abs() < 1e-15);
}
