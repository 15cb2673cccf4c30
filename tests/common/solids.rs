//! Closed surfaces by formula, for tests, benchmarks and examples.
#![allow(dead_code, reason = "each user takes some of the shapes")]

use glam::{DMat3, DQuat, DVec3};
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;

pub const CENTRE: DVec3 = DVec3::splat(0.5);

/// The signed distance to the zero set of a function, negative inside.
pub fn solid(level: u32, value: impl Fn(DVec3) -> f64) -> SignedDistance<3> {
    let grid = Grid::of_level(level);
    let values: Vec<f64> = (0..grid.node_count()).map(|node| value(DVec3::from(grid.position(node)))).collect();
    SignedDistance::redistance(grid, &values).expect("a valid level set")
}

/// About the distance to the sphere of this radius around the middle of the box.
pub fn sphere(radius: f64) -> impl Fn(DVec3) -> f64 {
    move |x| (x - CENTRE).length() - radius
}

/// About the distance to an ellipsoid around the middle of the box.
pub fn ellipsoid(axes: [f64; 3]) -> impl Fn(DVec3) -> f64 {
    move |x| {
        let scaled = (x - CENTRE) / DVec3::from(axes);
        let (length, slope) = (scaled.length(), (scaled / DVec3::from(axes)).length());
        if slope > 0.0 { length * (length - 1.0) / slope } else { -axes[0].min(axes[1]).min(axes[2]) }
    }
}

/// An octahedron with rounded edges: the l1 ball of a smoothed absolute value, turned by `turn`.
pub fn octahedron(radius: f64, turn: DQuat) -> impl Fn(DVec3) -> f64 {
    const ROUNDING: f64 = 0.03;
    let back = DMat3::from_quat(turn.inverse());
    move |x| {
        let local = back * (x - CENTRE);
        let soft = |t: f64| (t * t + ROUNDING * ROUNDING).sqrt() - ROUNDING;
        (soft(local.x) + soft(local.y) + soft(local.z) - radius) / 3_f64.sqrt()
    }
}

/// A sphere with bumps towards directions of its own, turned by `turn`: r(n) = radius (1 + Σ height exp(sharpness (n·d − 1))).
#[derive(Clone)]
pub struct Bumpy {
    pub radius: f64,
    pub bumps: Vec<(DVec3, f64)>,
}

impl Bumpy {
    const SHARPNESS: f64 = 6.0;

    /// With the radius that takes the farthest bump to `reach`.
    pub fn reaching(bumps: Vec<(DVec3, f64)>, reach: f64) -> Self {
        let farthest = bumps.iter().map(|(towards, _)| Self::bulge(&bumps, *towards)).fold(0.0, f64::max);
        Self { radius: reach / (1.0 + farthest), bumps }
    }

    fn bulge(bumps: &[(DVec3, f64)], direction: DVec3) -> f64 {
        bumps.iter().map(|(towards, height)| height * (Self::SHARPNESS * (direction.dot(*towards) - 1.0)).exp()).sum()
    }

    pub fn turned(self, turn: DQuat) -> impl Fn(DVec3) -> f64 {
        let back = DMat3::from_quat(turn.inverse());
        move |x| {
            let local = back * (x - CENTRE);
            let length = local.length();
            if length < 1e-9 {
                return -self.radius;
            }
            let direction = local / length;
            let bulge = Self::bulge(&self.bumps, direction);
            length - self.radius * (1.0 + bulge)
        }
    }
}

/// Positions and triangles.
pub type Mesh = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// An octahedron whose triangles are cut in four `rounds` times, each corner moved to `place` of its direction. Outward.
pub fn mesh(rounds: u32, place: impl Fn(DVec3) -> DVec3) -> Mesh {
    let mut directions = vec![DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
    let mut triangles: Vec<[u32; 3]> =
        vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    for _ in 0..rounds {
        let mut middles = std::collections::HashMap::new();
        triangles = triangles
            .into_iter()
            .flat_map(|[a, b, c]| {
                let mut middle = |a: u32, b: u32| {
                    *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                        directions.push((directions[a as usize] + directions[b as usize]).normalize());
                        directions.len() as u32 - 1
                    })
                };
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    (directions.into_iter().map(|direction| place(direction).to_array()).collect(), triangles)
}

pub fn ball_mesh(rounds: u32, centre: DVec3, radius: f64) -> Mesh {
    mesh(rounds, |direction| centre + radius * direction)
}

/// Both, without joining anything.
pub fn together((mut positions, mut triangles): Mesh, (more, faces): Mesh) -> Mesh {
    let first = positions.len() as u32;
    positions.extend(more);
    triangles.extend(faces.into_iter().map(|triangle| triangle.map(|corner| corner + first)));
    (positions, triangles)
}

/// Seen from the other side.
pub fn inside_out((positions, triangles): Mesh) -> Mesh {
    (positions, triangles.into_iter().map(|[a, b, c]| [a, c, b]).collect())
}
