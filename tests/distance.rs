//! What is true of signed distances, whatever makes them.

use std::f64::consts::{PI, TAU};

use glam::DVec2;
use proptest::prelude::*;
use thinshell::contour::zero_set;
use thinshell::distance::SignedDistance;
use thinshell::error::ShapeError;
use thinshell::grid::Grid;

const CENTRE: DVec2 = DVec2::splat(0.5);

fn regular(points: usize, centre: DVec2, radius: f64) -> Vec<DVec2> {
    (0..points).map(|k| centre + radius * DVec2::from_angle(TAU * k as f64 / points as f64)).collect()
}

fn rectangle(low: [f64; 2], high: [f64; 2]) -> Vec<DVec2> {
    [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]].map(DVec2::from).to_vec()
}

fn reversed(points: &[DVec2]) -> Vec<DVec2> {
    points.iter().rev().copied().collect()
}

fn from_loops(cells: usize, loops: &[Vec<DVec2>]) -> SignedDistance<2> {
    SignedDistance::from_loops(Grid::new(cells), loops).unwrap()
}

fn position(grid: Grid<2>, node: usize) -> DVec2 {
    DVec2::from(grid.position(node))
}

/// The greatest |d − exact| over the nodes where `counts(exact)`.
fn error_where(distance: &SignedDistance<2>, exact: impl Fn(DVec2) -> f64, counts: impl Fn(f64) -> bool) -> f64 {
    (0..distance.grid().node_count())
        .map(|node| (distance.values()[node], exact(position(distance.grid(), node))))
        .filter(|(_, exact)| counts(*exact))
        .map(|(found, exact)| (found - exact).abs())
        .fold(0.0, f64::max)
}

fn error(distance: &SignedDistance<2>, exact: impl Fn(DVec2) -> f64) -> f64 {
    error_where(distance, exact, |_| true)
}

fn rectangle_distance(p: DVec2, low: [f64; 2], high: [f64; 2]) -> f64 {
    let (low, high) = (DVec2::from(low), DVec2::from(high));
    let q = (low - p).max(p - high);
    q.max(DVec2::ZERO).length() + q.max_element().min(0.0)
}

fn segment_distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    p.distance(a + (b - a) * t)
}

fn area(points: &[DVec2]) -> f64 {
    (0..points.len()).map(|k| 0.5 * points[k].perp_dot(points[(k + 1) % points.len()])).sum()
}

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

fn at(distance: &SignedDistance<2>, point: [f64; 2]) -> f64 {
    let grid = distance.grid();
    distance.values()[grid.node(point.map(|x| (x * grid.cells() as f64).round() as usize))]
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
                // Order 1.3: halving the spacing divides by 2 to 4, and the coarsest grids are not yet asymptotic.
                assert!(fine * 2.4 < *coarse, "{errors:?}");
            }
        }
    }
    check(&[32, 64, 128, 256].map(redistancing_errors::<2>));
    let space = [16, 32, 64].map(redistancing_errors::<3>);
    check(&space.map(|[_, everywhere]| [everywhere; 2]));
    // One hundredth of a cell at the band of the energies.
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

#[test]
fn a_coarser_grid_takes_the_common_nodes_and_a_finer_one_interpolates() {
    let distance = from_loops(64, &[regular(200, CENTRE, 0.25)]);
    let coarse = distance.to_cells(16);
    for (node, value) in coarse.values().iter().enumerate() {
        let index = coarse.grid().node_index(node).map(|i| 4 * i);
        assert_eq!(*value, distance.values()[distance.grid().node(index)]);
    }
    assert_eq!(distance.to_cells(256).to_cells(64).values(), distance.values());

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

fn refusal(loops: &[Vec<DVec2>]) -> ShapeError {
    SignedDistance::from_loops(Grid::new(64), loops).err().unwrap()
}

#[test]
fn loops_that_are_no_shape_are_refused_with_the_reason() {
    let square = rectangle([0.3, 0.3], [0.7, 0.7]);
    assert_eq!(refusal(&[]), ShapeError::Empty);
    assert_eq!(refusal(&[vec![], vec![]]), ShapeError::Empty);
    assert_eq!(refusal(&[square.clone(), vec![]]), ShapeError::TooFewPoints { index: 1, points: 0 });
    let twice = vec![CENTRE, CENTRE, square[0], square[0], CENTRE];
    assert_eq!(refusal(&[twice]), ShapeError::TooFewPoints { index: 0, points: 2 });
    for poison in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut broken = square.clone();
        broken[2].y = poison;
        assert_eq!(refusal(&[square.clone(), broken]), ShapeError::NotFinite { index: 1, point: 2 });
    }
    let line = vec![DVec2::new(0.2, 0.3), DVec2::new(0.8, 0.6), DVec2::new(0.4, 0.4)];
    assert_eq!(refusal(&[line]), ShapeError::NoArea);
    assert_eq!(refusal(&[rectangle([0.501, 0.501], [0.505, 0.505])]), ShapeError::TooSmall { cells: 64 });
}

#[test]
fn shapes_at_the_border_are_refused_with_the_side() {
    let sides = [
        ([0.01, 0.3], [0.5, 0.7], "left", "x", 0.01),
        ([0.3, 0.3], [0.99, 0.7], "right", "x", 0.99),
        ([0.3, 0.01], [0.5, 0.7], "bottom", "y", 0.01),
        ([0.3, 0.3], [0.5, 0.99], "top", "y", 0.99),
    ];
    for (low, high, side, coordinate, value) in sides {
        let ShapeError::NearBorder { side: found, coordinate: axis, value: place, cells, needed } =
            refusal(&[rectangle(low, high)])
        else {
            panic!("not refused for the border")
        };
        assert_eq!((found, axis, place, needed), (side, coordinate, value, 2.0));
        assert!((cells - 0.64).abs() < 1e-12);
    }
    let refused = refusal(&[rectangle([0.3, 0.3], [1.04, 0.7])]);
    assert_eq!(refused, ShapeError::OutsideBox { side: "right", coordinate: "x", value: 1.04 });
    assert!(refused.to_string().contains("leaves the box on the right (x = 1.040)"));
    // Two cells are enough, and on a coarser grid the same room is fewer.
    let close = from_loops(64, &[rectangle([2.0 / 64.0, 0.3], [0.5, 0.7])]);
    assert_eq!(close.check_clearance(64), Ok(()));
    assert!(matches!(close.check_clearance(16), Err(ShapeError::NearBorder { side: "left", .. })));
}

#[test]
fn level_sets_and_masks_that_do_not_fit_are_refused_with_the_reason() {
    let grid = Grid::<3>::new(8);
    let ball: Vec<_> = (0..grid.node_count())
        .map(|node| grid.position(node).iter().map(|x| (x - 0.5) * (x - 0.5)).sum::<f64>().sqrt() - 0.2)
        .collect();
    for make in
        [|grid, values: &[f64]| SignedDistance::<3>::from_level_set(grid, values.to_vec()), SignedDistance::redistance]
    {
        assert!(make(grid, &ball).is_ok());
        assert_eq!(
            make(grid, &ball[1..]).err().unwrap(),
            ShapeError::LevelSetLength { found: 728, expected: 729, cells: 8, dim: 3 }
        );
        let mut broken = ball.clone();
        broken[77] = f64::NAN;
        assert_eq!(make(grid, &broken).err().unwrap(), ShapeError::LevelSetNotFinite { node: 77 });
        let outside: Vec<_> = ball.iter().map(|d| d.abs() + 1.0).collect();
        assert_eq!(make(grid, &outside).err().unwrap(), ShapeError::NoSignChange);
        let inverted: Vec<_> = ball.iter().map(|d| -d).collect();
        assert!(matches!(make(grid, &inverted).err().unwrap(), ShapeError::NearBorder { cells: 0.0, .. }));
        let shifted: Vec<_> = (0..grid.node_count())
            .map(|node| {
                let [x, y, z] = grid.position(node);
                ((x - 0.5).powi(2) + (y - 0.5).powi(2) + (z - 0.7).powi(2)).sqrt() - 0.2
            })
            .collect();
        assert!(matches!(
            make(grid, &shifted).err().unwrap(),
            ShapeError::NearBorder { side: "back", coordinate: "z", .. }
        ));
    }

    let from =
        |width, height, data: &[u8]| SignedDistance::from_mask(Grid::new(64), width, height, data).err().unwrap();
    assert_eq!(from(3, 2, &[255; 5]), ShapeError::MaskLength { found: 5, width: 3, height: 2, expected: 6 });
    assert_eq!(from(0, 5, &[]), ShapeError::Empty);
    assert_eq!(from(4, 4, &[127; 16]), ShapeError::NoArea);
    assert!(matches!(from(4, 4, &[255; 16]), ShapeError::NearBorder { cells: 0.0, .. }));
    let noise: Vec<u8> = (0..2000 * 2000).map(|i| if (i % 2000 + i / 2000) % 2 == 0 { 255 } else { 0 }).collect();
    assert!(matches!(from(2000, 2000, &noise), ShapeError::Unsupported(_)));
}

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
                    ShapeError::NoArea | ShapeError::TooFewPoints { .. } | ShapeError::TooSmall { .. }
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
            (one, two) => prop_assert_eq!(one.err(), two.err()),
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
