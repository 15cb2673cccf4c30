//! Distances around a surface, exactly: each of its triangles, edges and corners tells the nodes that it may be nearest to.
//!
//! The point of a surface that is nearest to x lies inside a triangle, inside an edge, or in a corner, and x in its region, an
//! intersection of half-spaces:
//!
//! - the prism over a triangle, on the inner side of its edges;
//! - the wedge of an edge from a to b, between these, m · (x − a) ≤ 0 with m from the edge into each triangle at it;
//! - the cone of a corner v, e · (x − v) ≤ 0 with e along each edge from it.
//!
//! Around a smooth surface these hardly overlap, so that together they cost what there are nodes. The surface need be neither
//! closed nor free of crossings: a half-space that is left out makes a region larger, and no distance wrong.
//!
//! Source: S. Mauch, "Efficient algorithms for solving static Hamilton–Jacobi equations", thesis, Caltech (2003).

use super::edges::{Edge, Edges, is_line};
use super::scan::{Foot, Nearest, Scan};
use crate::grid::Grid;
use crate::hypersurface::Hypersurface;
use glam::DVec3;

/// The sine of the angle between two triangles below which what is nearest to their edge is nearest to them.
const FLAT: f64 = 1e-12;

/// More than what rounding adds to the product of two unit vectors.
const ROUNDING: f64 = 1e-7;

/// Corners of more edges are not looked at closely.
const MOST_EDGES: usize = 12;

/// The least cosine between rays and their mean for them to bound what is between better than a box does.
const NARROW: f64 = 0.5;

/// The nodes no farther from a surface than this.
pub(super) fn within(grid: Grid<3>, surface: &Hypersurface<3>, radius: f64) -> Nearest {
    let points: Vec<DVec3> = surface.points().iter().map(|point| DVec3::from(*point)).collect();
    let edges = Edges::of(surface.simplices(), &points);
    let mut scan = Scan::new(grid, radius);
    for (triangle, corners) in surface.simplices().iter().enumerate() {
        scan.triangle = triangle as u32;
        prism(&mut scan, corners.map(|corner| points[corner as usize]));
    }
    for edge in &edges.edges {
        scan.triangle = edge.triangle;
        wedge(&mut scan, edge, edge.ends.map(|end| points[end as usize]));
    }
    let mut away = Vec::new();
    for (corner, point) in points.iter().enumerate() {
        away.clear();
        for edge in edges.at(corner) {
            scan.triangle = edge.triangle;
            let other = if edge.ends[0] as usize == corner { edge.ends[1] } else { edge.ends[0] };
            away.push((points[other as usize] - point).normalize());
        }
        if !away.is_empty() {
            cone(&mut scan, *point, &away);
        }
    }
    scan.nearest
}

fn prism(scan: &mut Scan, corners: [DVec3; 3]) {
    if is_line(corners) {
        return;
    }
    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
    for k in 0..3 {
        let outward = (corners[(k + 1) % 3] - corners[k]).cross(normal).normalize();
        scan.planes.push((outward, corners[k]));
    }
    scan.core.extend(corners);
    scan.rays.extend([normal, -normal]);
    scan.run(corners[0], &Foot::Plane { normal });
}

fn wedge(scan: &mut Scan, edge: &Edge, [a, b]: [DVec3; 2]) {
    let along = (b - a).normalize();
    let mut is_bounded = false;
    if let &[one, other] = edge.inward() {
        // Across the edge and one of the triangles, on the side away from the other.
        let beside = |one: DVec3, other: DVec3| {
            let across = along.cross(one);
            if across.dot(other) > 0.0 { -across } else { across }
        };
        let rays = [beside(one, other), beside(other, one)];
        if rays[0].dot(other) <= -FLAT {
            scan.rays.extend(rays);
            is_bounded = bound(&mut scan.rays);
        } else if one.dot(other) < 0.0 {
            return;
        }
    }
    if !is_bounded {
        let disc = (DVec3::ONE - along * along).max(DVec3::ZERO).map(f64::sqrt);
        scan.rays.extend(corners_of(disc));
    }
    scan.planes.extend([(along, b), (-along, a)]);
    scan.planes.extend(edge.inward().iter().map(|&inward| (inward, a)));
    scan.core.extend([a, b]);
    scan.run(a, &Foot::Line { along });
}

fn cone(scan: &mut Scan, corner: DVec3, away: &[DVec3]) {
    let mut is_bounded = false;
    if (3..=MOST_EDGES).contains(&away.len()) {
        // The cone's own edges are across two of the surface's, on the side away from all.
        let mut is_line = true;
        for (k, one) in away.iter().enumerate() {
            for other in &away[..k] {
                let across = one.cross(*other);
                let length = across.length();
                is_line &= length < ROUNDING;
                for ray in [across, -across] {
                    if length > 0.0 && away.iter().all(|edge| edge.dot(ray) <= ROUNDING * length) {
                        scan.rays.push(ray / length);
                    }
                }
            }
        }
        if scan.rays.is_empty() && !is_line {
            return;
        }
        is_bounded = bound(&mut scan.rays);
    }
    if !is_bounded {
        scan.rays.extend(corners_of(DVec3::ONE));
    }
    scan.planes.extend(away.iter().map(|&edge| (edge, corner)));
    scan.core.push(corner);
    scan.run(corner, &Foot::Point);
}

/// Makes of unit rays the corners of a body that holds what of their cone is no farther than one away, if they are [`NARROW`];
/// none if not.
fn bound(rays: &mut Vec<DVec3>) -> bool {
    let middle = rays.iter().sum::<DVec3>().normalize_or_zero();
    let is_narrow = !rays.is_empty() && rays.iter().all(|ray| ray.dot(middle) >= NARROW);
    if is_narrow {
        // What is before a plane across the middle.
        rays.iter_mut().for_each(|ray| *ray /= ray.dot(middle));
        rays.push(DVec3::ZERO);
    } else {
        rays.clear();
    }
    is_narrow
}

/// The corners of the box from −`high` to `high`.
fn corners_of(high: DVec3) -> [DVec3; 8] {
    let signs = [-1.0, 1.0];
    std::array::from_fn(|corner| high * DVec3::new(signs[corner & 1], signs[corner >> 1 & 1], signs[corner >> 2]))
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::super::scan::NONE;
    use super::*;
    use crate::hypersurface::foot;
    use proptest::prelude::*;

    /// A distance is off by no more than a part of what regions overlap by, and the height of a triangle that is a line.
    const TOLERANCE: f64 = 1e-6;

    proptest! {
        /// Triangles of all sizes that share corners and edges, any number at each, some flat on each other or without area,
        /// their corners on nodes or between them.
        #[test]
        fn nodes_within_the_radius_know_their_distance_and_others_nothing(
            points in prop::collection::vec(prop::array::uniform3(0.0..1.0f64), 4..40),
            corners in prop::collection::vec(prop::array::uniform3(0..1000_usize), 1..60),
            raster in prop::sample::select(vec![0.0, 4.0, 8.0]),
            depth in prop::sample::select(vec![0.0, 1e-9, 1.0]),
            cells in 2..13_usize,
            radius in 0.05..2.0f64,
        ) {
            let place = |[x, y, z]: [f64; 3]| {
                let place = if raster > 0.0 { [x, y, z].map(|x| (x * raster).round() / raster) } else { [x, y, z] };
                [place[0], place[1], depth * place[2]]
            };
            let points: Vec<[f64; 3]> = points.into_iter().map(place).collect();
            let triangles: Vec<[u32; 3]> = corners
                .into_iter()
                .map(|corners| corners.map(|corner| (corner % points.len()) as u32))
                .filter(|&[a, b, c]| [[a, b], [b, c], [c, a]].iter().all(|ends| points[ends[0] as usize] != points[ends[1] as usize]))
                .collect();
            let surface = Hypersurface::new(points, triangles);
            let grid = Grid::new(cells);
            let found = within(grid, &surface, radius);
            for node in 0..grid.node_count() {
                let away = |corners| foot(&grid.position(node), &corners).0.sqrt();
                let least = surface.all_corners().map(away).fold(f64::INFINITY, f64::min);
                let (distance, triangle) = (found.squares[node].sqrt(), found.triangles[node]);
                if least < radius - TOLERANCE {
                    prop_assert!((distance - least).abs() < TOLERANCE, "{distance} is not {least}");
                    let told = away(surface.all_corners().nth(triangle as usize).expect("one of the triangles"));
                    prop_assert!((told - least).abs() < TOLERANCE, "the triangle is {told} away, not {least}");
                } else if least > radius + TOLERANCE {
                    prop_assert_eq!(triangle, NONE);
                }
            }
        }
    }
}
