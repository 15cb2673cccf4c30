//! Convex regions, and the nodes of a grid in them.

use crate::grid::Grid;
use glam::DVec3;
use std::ops::Range;

/// What is known of each node: the squared distance, and the triangle that is so far away.
pub(super) struct Nearest {
    pub squares: Vec<f64>,
    /// Or [`NONE`].
    pub triangles: Vec<u32>,
}

pub(super) const NONE: u32 = u32::MAX;

/// Regions are larger by this, so that rounding leaves no node between two; in domain units.
const OVERLAP: f64 = 1e-10;

/// More than what rounding changes places by, in cells.
const ROUNDING: f64 = 1e-8;

/// What a region's nodes are nearest to, through its origin.
pub(super) enum Foot {
    Plane { normal: DVec3 },
    Line { along: DVec3 },
    Point,
}

/// A region that is filled in and run through, one after the other: x with n · (x − p) ≤ 0 for all `planes`, and no farther from
/// what it belongs to than the radius.
pub(super) struct Scan {
    grid: Grid<3>,
    radius: f64,
    pub nearest: Nearest,
    /// To which the next region belongs.
    pub triangle: u32,
    /// Normals and points.
    pub planes: Vec<(DVec3, DVec3)>,
    /// The region lies between all c + r g, c of `core`, g of `rays`.
    pub core: Vec<DVec3>,
    pub rays: Vec<DVec3>,
    /// These, y and z in cells.
    points: Vec<[f64; 2]>,
    /// By layer of nodes, the least and the greatest y between them.
    rows: Vec<[f64; 2]>,
    /// n and b of n · x ≤ b.
    halves: Vec<(DVec3, f64)>,
}

impl Scan {
    pub fn new(grid: Grid<3>, radius: f64) -> Self {
        let count = grid.node_count();
        Self {
            grid,
            radius,
            nearest: Nearest { squares: vec![radius * radius; count], triangles: vec![NONE; count] },
            triangle: NONE,
            planes: Vec::new(),
            core: Vec::new(),
            rays: Vec::new(),
            points: Vec::new(),
            rows: Vec::new(),
            halves: Vec::new(),
        }
    }

    /// Tells the nodes of the region, and empties it.
    pub fn run(&mut self, origin: DVec3, foot: &Foot) {
        // s |x − o|² + t (a · (x − o))².
        let (s, axis, t) = match *foot {
            Foot::Plane { normal } => (0.0, normal, 1.0),
            Foot::Line { along } => (1.0, along, -1.0),
            Foot::Point => (1.0, DVec3::ZERO, 0.0),
        };
        let (grid, spacing) = (self.grid, self.grid.spacing());
        self.halves.clear();
        self.halves.extend(self.planes.drain(..).map(|(normal, on)| (normal, normal.dot(on) + OVERLAP)));
        let first = self.bound_rows();
        for (layer, &[low, high]) in self.rows.iter().enumerate() {
            let k = first + layer;
            for j in self.nodes_between(low, high) {
                let (y, z) = (j as f64 * spacing, k as f64 * spacing);
                let (mut from, mut to) = (0.0_f64, grid.cells() as f64);
                for &(normal, offset) in &self.halves {
                    // Infinite where the plane is along the row, all of which it holds, or nothing.
                    let end = (offset - normal.y * y - normal.z * z) / normal.x * grid.cells() as f64;
                    let is_upper = normal.x.is_sign_positive();
                    to = to.min(if is_upper { end } else { f64::INFINITY });
                    from = from.max(if is_upper { f64::NEG_INFINITY } else { end });
                }
                let row = grid.node([0, j, k]);
                for i in self.nodes_between(from, to) {
                    let offset = DVec3::new(i as f64 * spacing, y, z) - origin;
                    let along = axis.dot(offset);
                    let square = s * offset.dot(offset) + t * along * along;
                    if square < self.nearest.squares[row + i] {
                        self.nearest.squares[row + i] = square.max(0.0);
                        self.nearest.triangles[row + i] = self.triangle;
                    }
                }
            }
        }
        self.core.clear();
        self.rays.clear();
    }

    /// Finds the rows; the number of their first layer.
    fn bound_rows(&mut self) -> usize {
        let cells = self.grid.cells() as f64;
        let reach = cells * self.radius;
        let Self { core, rays, points, .. } = self;
        points.clear();
        points.extend(
            core.iter().flat_map(|c| rays.iter().map(move |g| [cells * c.y + reach * g.y, cells * c.z + reach * g.z])),
        );
        let (low, high) =
            points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), [_, z]| (low.min(*z), high.max(*z)));
        let layers = self.nodes_between(low, high);
        self.rows.clear();
        self.rows.resize(layers.len(), [f64::INFINITY, f64::NEG_INFINITY]);
        // An edge of the sum of two bodies is an edge of one and a corner of the other.
        let count = self.rays.len();
        for point in 0..self.points.len() {
            for other in (point / count * count..point).chain((point % count..point).step_by(count)) {
                self.add_edge(layers.start, self.points[point], self.points[other]);
            }
        }
        layers.start
    }

    /// Makes the rows hold what is between two points.
    fn add_edge(&mut self, first: usize, one: [f64; 2], other: [f64; 2]) {
        let [below, above] = if one[1] < other[1] { [one, other] } else { [other, one] };
        let layers = self.nodes_between(below[1], above[1]);
        if layers.is_empty() {
            return;
        }
        let slope = (above[0] - below[0]) / (above[1] - below[1]).max(f64::MIN_POSITIVE);
        let (low, high) = (below[0].min(above[0]), below[0].max(above[0]));
        for layer in layers {
            let y = (below[0] + slope * (layer as f64 - below[1])).max(low).min(high);
            let row = &mut self.rows[layer - first];
            *row = [row[0].min(y), row[1].max(y)];
        }
    }

    /// The nodes of a line from one place to another, in cells, and those next to these but for rounding.
    #[inline]
    fn nodes_between(&self, low: f64, high: f64) -> Range<usize> {
        let (low, high) = ((low - ROUNDING).max(0.0), (high + ROUNDING).min(self.grid.cells() as f64));
        if high < low {
            return 0..0;
        }
        let down = low as i32;
        let up = down + i32::from(f64::from(down) < low);
        up as usize..high as usize + 1
    }
}
