//! Signed distances of polygons, pictures and level sets on grids of several sizes.

use std::f64::consts::TAU;

use divan::{Bencher, black_box};
use glam::DVec2;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;

fn main() {
    divan::main();
}

/// A star-shaped blob of `points` points.
fn blob(points: usize) -> Vec<DVec2> {
    (0..points)
        .map(|k| TAU * k as f64 / points as f64)
        .map(|t| 0.5 + (0.28 + 0.08 * (3.0 * t).cos() + 0.02 * (11.0 * t).sin()) * DVec2::from_angle(t))
        .collect()
}

/// A curve that crosses itself often: a closed Lissajous figure.
fn scribble(points: usize) -> Vec<DVec2> {
    (0..points)
        .map(|k| TAU * k as f64 / points as f64)
        .map(|t| 0.5 + 0.4 * DVec2::new((5.0 * t).sin(), (7.0 * t + 0.3).cos()))
        .collect()
}

#[divan::bench(args = [64, 128, 256, 512])]
fn polygon_of_512_points(bencher: Bencher, cells: usize) {
    let loops = [blob(512)];
    bencher.bench(|| SignedDistance::from_loops(Grid::new(cells), black_box(&loops)));
}

#[divan::bench(args = [64, 1024, 16384])]
fn polygon_on_128_cells(bencher: Bencher, points: usize) {
    let loops = [blob(points)];
    bencher.bench(|| SignedDistance::from_loops(Grid::new(128), black_box(&loops)));
}

#[divan::bench(args = [512, 4096])]
fn scribble_on_128_cells(bencher: Bencher, points: usize) {
    let loops = [scribble(points)];
    bencher.bench(|| SignedDistance::from_loops(Grid::new(128), black_box(&loops)));
}

#[divan::bench(args = [256, 1024, 4000])]
fn mask_on_128_cells(bencher: Bencher, pixels: usize) {
    let at = |i: usize| (i as f64 + 0.5) / pixels as f64 - 0.5;
    let inside = |x: f64, y: f64| {
        let (radius, angle) = (x.hypot(y), y.atan2(x));
        radius < 0.3 + 0.08 * (3.0 * angle).cos() && radius > 0.1
    };
    let data: Vec<_> = (0..pixels * pixels)
        .map(|pixel| if inside(at(pixel % pixels), at(pixel / pixels)) { 255 } else { 0 })
        .collect();
    bencher.bench(|| SignedDistance::from_mask(Grid::new(128), pixels, pixels, black_box(&data)));
}

#[divan::bench(args = [128, 512])]
fn level_set_in_the_plane(bencher: Bencher, cells: usize) {
    level_set::<2>(bencher, cells);
}

#[divan::bench(args = [32, 64])]
fn level_set_in_space(bencher: Bencher, cells: usize) {
    level_set::<3>(bencher, cells);
}

fn level_set<const D: usize>(bencher: Bencher, cells: usize) {
    let grid = Grid::<D>::new(cells);
    let values: Vec<_> = (0..grid.node_count())
        .map(|node| grid.position(node).iter().map(|x| (x - 0.5) * (x - 0.5)).sum::<f64>() - 0.09)
        .collect();
    bencher.bench(|| SignedDistance::redistance(grid, black_box(&values)));
}
