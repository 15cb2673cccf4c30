//! Zero sets in space as meshes to be drawn.

use crate::field::{interpolate, interpolate_derivative};
use crate::grid::Grid;
use crate::hypersurface::Hypersurface;
use crate::small::dot;
use glam::DVec3;

/// The corners at the ends of a cell's edges.
const EDGES: [[usize; 2]; 12] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
const NONE: u32 = u32::MAX;

/// The zero set of nodal values by one vertex a cell, seen counter-clockwise from outside: fewer and better triangles than
/// by marching. A zero counts as positive; what is negative at the border of the box is left open there.
///
/// Source: S. F. F. Gibson, "Constrained elastic surface nets", MICCAI 1998.
pub fn net(grid: Grid<3>, values: &[f64]) -> Hypersurface<3> {
    assert_eq!(values.len(), grid.node_count(), "one value a node");
    let offsets = grid.corner_offsets();
    let mut points = Vec::new();
    let mut numbers = vec![NONE; grid.cell_count()];
    for (cell, number) in numbers.iter_mut().enumerate() {
        let base = grid.lowest_node(cell);
        let corners: [f64; 8] = std::array::from_fn(|corner| values[base + offsets[corner]]);
        let inside = corners.iter().filter(|value| **value < 0.0).count();
        if inside != 0 && inside != 8 {
            *number = points.len() as u32;
            let place = vertex(&corners);
            points.push(std::array::from_fn(|k| (grid.cell_index(cell)[k] as f64 + place[k]) * grid.spacing()));
        }
    }
    let mut triangles = Vec::new();
    for node in 0..values.len() {
        let index = grid.node_index(node);
        for axis in 0..3 {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let is_around = |k: usize| (1..grid.cells()).contains(&index[k]);
            if index[axis] == grid.cells() || !is_around(u) || !is_around(v) {
                continue;
            }
            let is_inside = values[node] < 0.0;
            if is_inside == (values[node + grid.stride(axis)] < 0.0) {
                continue;
            }
            let cell = |du: usize, dv: usize| {
                let mut index = index;
                (index[u], index[v]) = (index[u] - 1 + du, index[v] - 1 + dv);
                numbers[grid.cell(index)]
            };
            let around = [cell(0, 0), cell(1, 0), cell(1, 1), cell(0, 1)];
            let [a, b, c, d] = if is_inside { around } else { [around[0], around[3], around[2], around[1]] };
            let apart = |a: u32, b: u32| {
                DVec3::from(points[a as usize] as [f64; 3]).distance_squared(DVec3::from(points[b as usize]))
            };
            if apart(a, c) <= apart(b, d) {
                triangles.extend([[a, b, c], [a, c, d]]);
            } else {
                triangles.extend([[b, c, d], [b, d, a]]);
            }
        }
    }
    Hypersurface::new(points, triangles)
}

/// The mean of the zeros on a cell's edges, and from there a step of Newton's method onto the zero set.
fn vertex(corners: &[f64; 8]) -> [f64; 3] {
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for [a, b] in EDGES {
        if (corners[a] < 0.0) != (corners[b] < 0.0) {
            let t = corners[a] / (corners[a] - corners[b]);
            for (k, sum) in sum.iter_mut().enumerate() {
                *sum += (1.0 - t) * (a >> k & 1) as f64 + t * (b >> k & 1) as f64;
            }
            count += 1.0;
        }
    }
    let mean = sum.map(|sum| sum / count);
    let cell = Grid::<3>::new(1);
    let [value] = interpolate::<3, 1>(cell, corners, &mean);
    let [slope] = interpolate_derivative::<3, 1>(cell, corners, &mean);
    let square = dot(&slope, &slope);
    if square == 0.0 {
        return mean;
    }
    std::array::from_fn(|k| (mean[k] - value / square * slope[k]).clamp(0.0, 1.0))
}

/// A unit normal a point: the mean of its triangles', by area.
pub fn normals(surface: &Hypersurface<3>) -> Vec<[f64; 3]> {
    let mut sums = vec![DVec3::ZERO; surface.points().len()];
    for (corners, places) in surface.simplices().iter().zip(surface.all_corners()) {
        let [a, b, c] = places.map(DVec3::from);
        for corner in corners {
            sums[*corner as usize] += (b - a).cross(c - a);
        }
    }
    sums.into_iter().map(|sum| sum.normalize_or_zero().to_array()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn sphere(cells: usize, radius: f64) -> (Grid<3>, Hypersurface<3>) {
        let grid = Grid::<3>::new(cells);
        let away = |x: [f64; 3]| DVec3::from(x).distance(DVec3::new(0.5, 0.49, 0.51)) - radius;
        let values: Vec<f64> = (0..grid.node_count()).map(|node| away(grid.position(node))).collect();
        (grid, net(grid, &values))
    }

    #[test]
    fn a_sphere_is_a_closed_net_seen_from_outside() {
        let (_, net) = sphere(32, 0.3);
        assert!((net.measure() / (4.0 * PI * 0.09) - 1.0).abs() < 0.01, "{}", net.measure());
        // V − E + F of a sphere, with E = 3F/2.
        assert_eq!(2 * net.points().len() - net.simplices().len(), 4);
        for (point, normal) in net.points().iter().zip(normals(&net)) {
            let out = DVec3::from(*point) - DVec3::new(0.5, 0.49, 0.51);
            assert!((out.length() - 0.3).abs() < 0.002 && out.normalize().dot(DVec3::from(normal)) > 0.98);
        }
        let volume: f64 =
            net.all_corners().map(|corners| corners.map(DVec3::from)).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum();
        assert!((volume / (4.0 / 3.0 * PI * 0.027) - 1.0).abs() < 0.02, "{volume}");
    }
}
