//! Distances to triangle meshes.

use crate::solids::{CENTRE, Mesh, ball_mesh, inside_out, mesh, together};
use glam::DVec3;
use thinshell::distance::SignedDistance;
use thinshell::error::{MeshError, ShapeError};
use thinshell::grid::Grid;

const CELLS: usize = 32;

fn distance((positions, triangles): &Mesh) -> SignedDistance<3> {
    SignedDistance::from_mesh(Grid::new(CELLS), positions, triangles).expect("a valid mesh")
}

fn refusal((positions, triangles): &Mesh) -> MeshError {
    SignedDistance::from_mesh(Grid::new(CELLS), positions, triangles).expect_err("no valid mesh")
}

/// The largest difference from a function near its zero set, in cells, and whether all signs agree, and distances far away
/// are within a third of a cell.
fn difference(found: &SignedDistance<3>, expected: impl Fn(DVec3) -> f64) -> (f64, bool) {
    let grid = found.grid();
    let mut largest = 0.0_f64;
    let mut agrees = true;
    for (node, value) in found.values().iter().enumerate() {
        let expected = expected(DVec3::from(grid.position(node)));
        let difference = (value - expected).abs() * CELLS as f64;
        if expected.abs() < 0.1 {
            largest = largest.max(difference);
        }
        agrees &= difference < 1.0 / 3.0;
        agrees &= (*value < 0.0) == (expected < 0.0) || expected.abs() * (CELLS as f64) < 0.1;
    }
    (largest, agrees)
}

fn ball(centre: DVec3, radius: f64) -> impl Fn(DVec3) -> f64 {
    move |x| x.distance(centre) - radius
}

/// A box by twelve triangles, far larger than cells.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Mesh {
    let corner = |c: usize| std::array::from_fn(|k| if c >> k & 1 == 1 { high[k] } else { low[k] });
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    ((0..8).map(corner).collect(), faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
}

fn to_box(x: DVec3, low: DVec3, high: DVec3) -> f64 {
    let off = (low - x).max(x - high);
    off.max(DVec3::ZERO).length() + off.max_element().min(0.0)
}

#[test]
fn the_distance_to_a_box_is_exact() {
    // Faces through nodes, and between them.
    for (low, high) in [([0.25; 3], [0.75; 3]), ([0.21, 0.3, 0.33], [0.74, 0.61, 0.8])] {
        let found = distance(&cuboid(low, high));
        let (largest, agrees) = difference(&found, |x| to_box(x, DVec3::from(low), DVec3::from(high)));
        assert!(largest < 1e-9 && agrees, "{largest}, {agrees}");
    }
}

#[test]
fn the_distance_to_a_ball_is_as_good_as_its_triangles() {
    let found = distance(&ball_mesh(4, DVec3::new(0.47, 0.52, 0.5), 0.3));
    let (largest, agrees) = difference(&found, ball(DVec3::new(0.47, 0.52, 0.5), 0.3));
    // The middle of a triangle with edges of 0.05 lies 0.0016 below the sphere.
    assert!(largest < 0.055 && agrees, "{largest}, {agrees}");
}

#[test]
fn the_order_of_triangles_and_the_numbering_of_vertices_do_not_matter() {
    let (positions, triangles) = ball_mesh(3, CENTRE, 0.3);
    // Each triangle with vertices of its own, the last one first, starting elsewhere.
    let soup: Vec<[f64; 3]> =
        triangles.iter().rev().flat_map(|[a, b, c]| [b, c, a].map(|k| positions[*k as usize])).collect();
    let apart: Vec<[u32; 3]> = (0..triangles.len() as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let (found, other) = (distance(&(positions, triangles)), distance(&(soup, apart)));
    let (largest, agrees) = difference(&other, |x| found.values()[node_at(x)]);
    assert!(largest < 1e-9 && agrees, "{largest}, {agrees}");
}

fn node_at(x: DVec3) -> usize {
    Grid::<3>::new(CELLS).node((x * CELLS as f64).to_array().map(|i| i.round() as usize))
}

#[test]
fn a_mirrored_mesh_has_the_mirrored_distance() {
    let bumpy = |direction: DVec3| CENTRE + (0.25 + 0.06 * direction.x * direction.y + 0.03 * direction.z) * direction;
    let flip = |x: DVec3| DVec3::new(1.0 - x.x, x.y, x.z);
    let (plain, mirrored) = (mesh(3, bumpy), inside_out(mesh(3, |direction| flip(bumpy(direction)))));
    let (plain, mirrored) = (distance(&plain), distance(&mirrored));
    let (largest, agrees) = difference(&mirrored, |x| plain.values()[node_at(flip(x))]);
    assert!(largest < 1e-9 && agrees, "{largest}, {agrees}");
}

#[test]
fn bodies_that_cross_unite_and_cavities_are_hollow() {
    let (left, right) = (DVec3::new(0.4, 0.5, 0.5), DVec3::new(0.6, 0.52, 0.5));
    let crossing = distance(&together(ball_mesh(4, left, 0.2), ball_mesh(4, right, 0.22)));
    let union = |x| ball(left, 0.2)(x).min(ball(right, 0.22)(x));
    for (node, value) in crossing.values().iter().enumerate() {
        let expected = union(DVec3::from(crossing.grid().position(node)));
        assert!((*value < 0.0) == (expected < 0.0) || expected.abs() < 0.003, "{value} is not {expected}");
    }
    // On the one sphere, inside the other: the outline is far, about at the circle where they cross.
    let within = crossing.values()[node_at(DVec3::new(0.59375, 0.5, 0.5))];
    assert!(within < -0.1, "{within}");
    let hollow = distance(&together(ball_mesh(4, CENTRE, 0.35), inside_out(ball_mesh(4, CENTRE, 0.2))));
    assert!(difference(&hollow, |x| ball(CENTRE, 0.35)(x).max(-ball(CENTRE, 0.2)(x))).1);
}

#[test]
fn triangles_that_face_any_way_enclose_by_parity() {
    let (positions, triangles) = ball_mesh(4, CENTRE, 0.3);
    let mixed = triangles.into_iter().enumerate().map(|(k, [a, b, c])| if k % 3 == 0 { [a, c, b] } else { [a, b, c] });
    assert!(difference(&distance(&(positions, mixed.collect())), ball(CENTRE, 0.3)).1);
}

#[test]
fn a_small_hole_is_closed() {
    let (positions, mut triangles) = ball_mesh(4, CENTRE, 0.3);
    triangles.remove(100);
    triangles.remove(1500);
    let (largest, agrees) = difference(&distance(&(positions, triangles)), ball(CENTRE, 0.3));
    assert!(largest < 0.1 && agrees, "{largest}, {agrees}");
}

#[test]
fn an_open_mesh_is_refused_with_the_place_of_its_hole() {
    let (positions, mut triangles) = ball_mesh(3, CENTRE, 0.3);
    triangles.retain(|triangle| triangle.iter().any(|&corner| positions[corner as usize][2] < 0.7));
    let open = refusal(&(positions, triangles));
    let MeshError::Open { at, edges } = &open else { panic!("{open}") };
    assert!(*edges > 10 && at[2] > 0.65 && (at[0] - 0.5).abs() < 0.01, "{open}");
    assert!(open.to_string().starts_with("is open: "), "{open}");
}

#[test]
fn what_is_no_mesh_is_refused_with_the_reason() {
    let (positions, triangles) = ball_mesh(3, CENTRE, 0.3);
    assert_eq!(refusal(&(vec![], vec![])), MeshError::NoTriangles);
    assert_eq!(refusal(&(positions.clone(), vec![])), MeshError::NoTriangles);
    for poison in [f64::NAN, f64::INFINITY] {
        let mut broken = positions.clone();
        broken[17][1] = poison;
        assert_eq!(refusal(&(broken, triangles.clone())), MeshError::VertexNotFinite { vertex: 17 });
    }
    let mut wild = triangles.clone();
    wild[5][1] = 1_000_000;
    let vertices = positions.len();
    let expected = MeshError::NoSuchVertex { triangle: 5, index: 1_000_000, vertices };
    assert_eq!(refusal(&(positions.clone(), wild)), expected);
    // A ball seen from both sides, and a sheet.
    let both = together((positions.clone(), triangles.clone()), inside_out((positions.clone(), triangles)));
    assert_eq!(refusal(&both), MeshError::NoVolume);
    let sheet = vec![[0.2, 0.2, 0.5], [0.8, 0.2, 0.5], [0.5, 0.8, 0.5]];
    assert_eq!(refusal(&(sheet, vec![[0, 1, 2], [0, 2, 1]])), MeshError::NoVolume);
    assert_eq!(refusal(&ball_mesh(2, CENTRE + 0.01, 0.004)), ShapeError::TooSmall { cells: CELLS }.into());
    let border = refusal(&ball_mesh(3, CENTRE, 0.48));
    assert!(matches!(border, MeshError::Shape(ShapeError::NearBorder { needed: 2.0, .. })), "{border}");
    let outside = refusal(&ball_mesh(3, DVec3::new(0.5, 0.5, 0.9), 0.2));
    assert!(
        matches!(outside, MeshError::Shape(ShapeError::OutsideBox { side: "back", coordinate: "z", .. })),
        "{outside}"
    );
}

#[test]
fn a_plate_between_the_nodes_is_refused_where_it_is_thinnest() {
    let thin = refusal(&together(
        cuboid([0.2, 0.2, 0.51], [0.8, 0.8, 0.525]),
        ball_mesh(3, DVec3::new(0.2, 0.2, 0.515), 0.05),
    ));
    let MeshError::TooThin { share, at, .. } = &thin else { panic!("{thin}") };
    assert!(*share < 1.0 / 3.0 && at[0] + at[1] > 0.6, "{thin}");
}
