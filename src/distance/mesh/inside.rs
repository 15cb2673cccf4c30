//! Which nodes a closed mesh encloses, by what the lines of the grid cross.

use super::closed::Mesh;
use crate::grid::Grid;

/// Whether each node lies inside. Every line of nodes along an axis counts the triangles that it crosses, each axis has a
/// vote, and the majority decides: they differ only where rounding, or a mesh that is not quite closed, misleads one.
pub(super) fn inside(grid: Grid<3>, mesh: &Mesh) -> Vec<bool> {
    let mut votes = vec![0_u8; grid.node_count()];
    let mut crossings = vec![0_i32; grid.node_count()];
    for axis in 0..3 {
        crossings.fill(0);
        count_crossings(grid, mesh, axis, &mut crossings);
        let stride = grid.stride(axis);
        for line in 0..grid.side() * grid.side() {
            let first = first_node(grid, axis, line);
            let mut beyond = 0;
            for place in (0..grid.side()).rev() {
                let node = first + place * stride;
                beyond += crossings[node];
                let is_inside = if mesh.is_oriented { beyond != 0 } else { beyond % 2 != 0 };
                votes[node] += u8::from(is_inside);
            }
        }
    }
    votes.into_iter().map(|votes| votes >= 2).collect()
}

/// The node at the low end of a line along an axis.
fn first_node(grid: Grid<3>, axis: usize, line: usize) -> usize {
    // Neighbouring lines follow each other in memory.
    let (fast, slow) = [(1, 2), (0, 2), (0, 1)][axis];
    let mut index = [0; 3];
    (index[fast], index[slow]) = (line % grid.side(), line / grid.side());
    grid.node(index)
}

/// Adds ±1, by the side that is seen, at the last node before each crossing.
fn count_crossings(grid: Grid<3>, mesh: &Mesh, axis: usize, crossings: &mut [i32]) {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let cells = grid.cells() as f64;
    for triangle in mesh.surface.simplices() {
        let corners = triangle.map(|corner| mesh.surface.points()[corner as usize].map(|x| x * cells));
        let flat = corners.map(|corner| [corner[u], corner[v]]);
        let range = |k: usize| {
            let low = flat.iter().map(|corner| corner[k]).fold(f64::INFINITY, f64::min);
            let high = flat.iter().map(|corner| corner[k]).fold(f64::NEG_INFINITY, f64::max);
            low.ceil().max(0.0) as usize..=high.floor().min(cells) as usize
        };
        for j in range(1) {
            for i in range(0) {
                let line = [i as f64, j as f64];
                let sides: [f64; 3] = std::array::from_fn(|k| {
                    side([triangle[k], triangle[(k + 1) % 3]], [flat[k], flat[(k + 1) % 3]], line)
                });
                if sides[0] != sides[1] || sides[1] != sides[2] {
                    continue;
                }
                let Some(height) = height(&corners, &flat, axis, line) else { continue };
                // Nodes below see the crossing ahead; one that lies on the surface does not.
                let below = height.ceil() - 1.0;
                if below >= 0.0 {
                    let mut index = [0; 3];
                    (index[u], index[v]) = (i, j);
                    index[axis] = (below as usize).min(grid.cells());
                    crossings[grid.node(index)] += sides[0] as i32;
                }
            }
        }
    }
}

/// On which side of a directed edge a point lies, ±1. A point on the edge is taken as moved by a little along the first axis,
/// and by less along the second: of two triangles that share an edge it lies in one.
fn side(ends: [u32; 2], [a, b]: [[f64; 2]; 2], point: [f64; 2]) -> f64 {
    // Always computed in one direction, so that both triangles get the same number.
    if ends[0] > ends[1] {
        return -side([ends[1], ends[0]], [b, a], point);
    }
    let along = [b[0] - a[0], b[1] - a[1]];
    let area = along[0] * (point[1] - a[1]) - along[1] * (point[0] - a[0]);
    let decisive = [area, -along[1], along[0]].into_iter().find(|&x| x != 0.0);
    decisive.map_or(1.0, f64::signum)
}

/// Where the line crosses the plane of the triangle, held between its corners.
fn height(corners: &[[f64; 3]; 3], flat: &[[f64; 2]; 3], axis: usize, line: [f64; 2]) -> Option<f64> {
    let area = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let whole = area(flat[0], flat[1], flat[2]);
    if whole == 0.0 {
        return None;
    }
    let shares = [area(line, flat[1], flat[2]), area(flat[0], line, flat[2]), area(flat[0], flat[1], line)];
    let place: f64 = (0..3).map(|k| shares[k] / whole * corners[k][axis]).sum();
    let (low, high) = corners
        .iter()
        .map(|corner| corner[axis])
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    Some(place.max(low).min(high))
}
