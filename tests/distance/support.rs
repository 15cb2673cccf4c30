//! Shapes with known distances, and how far a distance is from known.

use std::f64::consts::TAU;

use glam::DVec2;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;

pub const CENTRE: DVec2 = DVec2::splat(0.5);

pub fn regular(points: usize, centre: DVec2, radius: f64) -> Vec<DVec2> {
    (0..points).map(|k| centre + radius * DVec2::from_angle(TAU * k as f64 / points as f64)).collect()
}

pub fn rectangle(low: [f64; 2], high: [f64; 2]) -> Vec<DVec2> {
    [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]].map(DVec2::from).to_vec()
}

pub fn reversed(points: &[DVec2]) -> Vec<DVec2> {
    points.iter().rev().copied().collect()
}

pub fn from_loops(cells: usize, loops: &[Vec<DVec2>]) -> SignedDistance<2> {
    SignedDistance::from_loops(Grid::new(cells), loops).unwrap()
}

pub fn position(grid: Grid<2>, node: usize) -> DVec2 {
    DVec2::from(grid.position(node))
}

/// The greatest |d − exact| over the nodes where `counts(exact)`.
pub fn error_where(distance: &SignedDistance<2>, exact: impl Fn(DVec2) -> f64, counts: impl Fn(f64) -> bool) -> f64 {
    (0..distance.grid().node_count())
        .map(|node| (distance.values()[node], exact(position(distance.grid(), node))))
        .filter(|(_, exact)| counts(*exact))
        .map(|(found, exact)| (found - exact).abs())
        .fold(0.0, f64::max)
}

pub fn error(distance: &SignedDistance<2>, exact: impl Fn(DVec2) -> f64) -> f64 {
    error_where(distance, exact, |_| true)
}

pub fn rectangle_distance(p: DVec2, low: [f64; 2], high: [f64; 2]) -> f64 {
    let (low, high) = (DVec2::from(low), DVec2::from(high));
    let q = (low - p).max(p - high);
    q.max(DVec2::ZERO).length() + q.max_element().min(0.0)
}

pub fn segment_distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    p.distance(a + (b - a) * t)
}

pub fn area(points: &[DVec2]) -> f64 {
    (0..points.len()).map(|k| 0.5 * points[k].perp_dot(points[(k + 1) % points.len()])).sum()
}

pub fn at(distance: &SignedDistance<2>, point: [f64; 2]) -> f64 {
    let grid = distance.grid();
    distance.values()[grid.node(point.map(|x| (x * grid.cells() as f64).round() as usize))]
}
