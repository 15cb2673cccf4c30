//! The nearest of many triangles: exactly, and fast where a good bound is known.

use crate::hypersurface::{Hypersurface, foot};
use crate::order::ascending;
use crate::small::{add_scaled, dot};
use glam::DVec3;
use wide::f32x4;

/// Coins around parts of a surface, {x : |n · (x − c)| ≤ t, |x − c|² − (n · (x − c))² ≤ r²}. A surface is cut in four, across
/// the longest side of the box around its triangles' middles and again, and each part likewise, down to single triangles.
///
/// What is nearly flat is a thin coin: none but those around the foot reach farther than it towards the point that is looked
/// from, where boxes would be fat.
pub(super) struct Coins {
    corners: Vec<[[f64; 3]; 3]>,
    /// The first four hold all.
    fours: Vec<Four>,
}

/// The point of a surface that is nearest to another, as far as is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    /// Squared distance.
    pub square: f64,
    pub foot: [f64; 3],
    pub triangle: u32,
}

/// Four coins side by side.
struct Four {
    /// c,
    centres: [f32x4; 3],
    /// n, of length one or zero: then the coin is a ball,
    normals: [f32x4; 3],
    /// r,
    radii: f32x4,
    /// t: −∞ where there is no coin, which is infinitely far away.
    thicknesses: f32x4,
    /// Triangles, and from [`DEEPER`] on further fours.
    parts: [u32; 4],
}

const DEEPER: u32 = 1 << 31;

/// Parts that a search leaves to be looked into: three at most of each of sixteen fours in each other, and one more.
const OPEN: usize = 64;

/// More than what rounding to f32 changes coordinates in the box by, and squares relatively.
const ROUNDING: f64 = 1e-6;

impl Coins {
    pub fn new(surface: &Hypersurface<3>) -> Self {
        let middles: Vec<[f64; 3]> = surface.middles().map(|(middle, _)| middle).collect();
        let mut coins = Self { corners: surface.all_corners().collect(), fours: Vec::new() };
        coins.add(&middles, &mut (0..middles.len() as u32).collect::<Vec<_>>());
        coins
    }

    /// Cuts triangles in four; their place among the fours.
    fn add(&mut self, middles: &[[f64; 3]], triangles: &mut [u32]) -> u32 {
        let place = self.fours.len();
        self.fours.push(Four::none());
        let (left, right) = halves(middles, triangles);
        let ((a, b), (c, d)) = (halves(middles, left), halves(middles, right));
        for (lane, part) in [a, b, c, d].into_iter().enumerate().filter(|(_, part)| !part.is_empty()) {
            self.fours[place].put(lane, &self.corners, part);
            self.fours[place].parts[lane] = if part.len() == 1 { part[0] } else { DEEPER + self.add(middles, part) };
        }
        place as u32
    }

    /// The foot of a point on one triangle.
    pub fn on(&self, triangle: u32, point: &[f64; 3]) -> Near {
        let corners = &self.corners[triangle as usize];
        let (square, shares) = foot(point, corners);
        let foot = std::array::from_fn(|axis| (0..3).map(|k| shares[k] * corners[k][axis]).sum());
        Near { square, foot, triangle }
    }

    /// The foot of a point on the nearest of all triangles, if its squared distance is below `square`.
    pub fn nearer(&self, point: &[f64; 3], square: f64) -> Option<Near> {
        let rounded = point.map(|x| f32x4::splat(x as f32));
        let above = |square: f64| (square * (1.0 + ROUNDING)) as f32;
        let (mut least, mut bound, mut found) = (square, above(square), None);
        // What is to be looked into, and its squared distance or less: of those added together the nearest on top.
        let mut open = [(DEEPER, 0.0_f32); OPEN];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (part, away) = open[count];
            if away >= bound {
                continue;
            }
            if part < DEEPER {
                let near = self.on(part, point);
                if near.square < least {
                    (least, bound, found) = (near.square, above(near.square), Some(near));
                }
                continue;
            }
            let four = &self.fours[(part - DEEPER) as usize];
            let squares = four.squares_to(&rounded);
            let first = count;
            let mut lanes = squares.simd_lt(f32x4::splat(bound)).to_bitmask();
            while lanes != 0 {
                let lane = lanes.trailing_zeros() as usize;
                lanes &= lanes - 1;
                open[count] = (four.parts[lane], squares.as_array()[lane]);
                if count > first && open[count - 1].1 < open[count].1 {
                    open.swap(count - 1, count);
                }
                count += 1;
            }
        }
        found
    }
}

/// Triangles on one side and on the other of the box around their middles, along its longest side; as many on either.
fn halves<'a>(middles: &[[f64; 3]], triangles: &'a mut [u32]) -> (&'a mut [u32], &'a mut [u32]) {
    if triangles.len() < 2 {
        return (triangles, &mut []);
    }
    let middle = |triangle: &u32| middles[*triangle as usize];
    let [low, high] = extent(triangles.iter().map(middle));
    let side = DVec3::from(high) - DVec3::from(low);
    let longest = side.max_position();
    let places: Vec<f64> = triangles.iter().map(|triangle| middle(triangle)[longest]).collect();
    let sorted: Vec<u32> = ascending(&places).into_iter().map(|place| triangles[place as usize]).collect();
    triangles.copy_from_slice(&sorted);
    triangles.split_at_mut(sorted.len() / 2)
}

/// The lowest and the highest corner of the box around points.
fn extent(points: impl Iterator<Item = [f64; 3]>) -> [[f64; 3]; 2] {
    let points = points.map(DVec3::from);
    let (low, high) =
        points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)));
    [low.to_array(), high.to_array()]
}

impl Four {
    fn none() -> Self {
        let zero = f32x4::splat(0.0);
        let thicknesses = f32x4::splat(f32::NEG_INFINITY);
        Self { centres: [zero; 3], normals: [zero; 3], radii: zero, thicknesses, parts: [0; 4] }
    }

    /// Lays a coin around triangles, across the mean of their normals.
    fn put(&mut self, lane: usize, corners: &[[[f64; 3]; 3]], triangles: &[u32]) {
        let all = || triangles.iter().map(|&triangle| corners[triangle as usize]);
        let sum: DVec3 = all().map(normal).sum();
        // Rounded before it is used: what follows holds for any direction.
        let normal = sum.normalize_or_zero().to_array().map(|x| f64::from(x as f32));
        let [low, high] = extent(all().flatten());
        let middle = DVec3::from(low).midpoint(DVec3::from(high)).to_array();
        let (mut lowest, mut highest, mut square) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
        for offset in all().flatten().map(|corner| add_scaled(&corner, -1.0, &middle)) {
            let along = dot(&offset, &normal);
            (lowest, highest) = (lowest.min(along), highest.max(along));
            square = square.max(dot(&offset, &offset) - along * along);
        }
        let centre = add_scaled(&middle, 0.5 * (lowest + highest), &normal);
        let set = |lanes: &mut f32x4, value: f64| lanes.as_mut_array()[lane] = value as f32;
        for axis in 0..3 {
            set(&mut self.centres[axis], centre[axis]);
            set(&mut self.normals[axis], normal[axis]);
        }
        set(&mut self.radii, square.sqrt() + ROUNDING);
        set(&mut self.thicknesses, 0.5 * (highest - lowest) + ROUNDING);
    }

    /// The squared distances of a point to the coins, but for [`ROUNDING`].
    #[inline]
    fn squares_to(&self, point: &[f32x4; 3]) -> f32x4 {
        let zero = f32x4::splat(0.0);
        let offset: [f32x4; 3] = std::array::from_fn(|axis| point[axis] - self.centres[axis]);
        let along = dot(&offset, &self.normals);
        let across = (dot(&offset, &offset) - along * along).max(zero).sqrt();
        let (up, out) = ((along.abs() - self.thicknesses).max(zero), (across - self.radii).max(zero));
        up * up + out * out
    }
}

/// Normal to a triangle, the longer the larger it is.
fn normal(corners: [[f64; 3]; 3]) -> DVec3 {
    let [a, b, c] = corners.map(DVec3::from);
    (b - a).cross(c - a)
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use crate::hypersurface::Tree;
    use proptest::prelude::*;

    proptest! {
        /// Triangles of all sizes, some of them flat on each other or without area.
        #[test]
        fn the_nearest_of_all_triangles_is_found_from_any_bound(
            points in prop::collection::vec(prop::array::uniform3(0.0..1.0f64), 3..150),
            size in 0.01..1.0f64,
            depth in prop::sample::select(vec![0.0, 1e-9, 1.0]),
            point in prop::array::uniform3(0.0..1.0f64),
            slack in 1e-9..1.0f64,
        ) {
            let place = |k: usize| {
                let [x, y, z] = std::array::from_fn(|axis| points[k - k % 3][axis] + size * (points[k][axis] - 0.5));
                [x, y, depth * z]
            };
            let count = points.len() / 3;
            let triangles = (0..count as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
            let surface = Hypersurface::new((0..points.len()).map(place).collect(), triangles);
            let coins = Coins::new(&surface);
            let nearest = |k: u32| coins.on(k, &point).square;
            let least = (0..count as u32).map(nearest).fold(f64::INFINITY, f64::min);
            for square in [f64::INFINITY, least * (1.0 + slack) + 1e-12] {
                let found = coins.nearer(&point, square).map(|near| near.square);
                prop_assert_eq!(found, Some(least));
            }
            prop_assert!(coins.nearer(&point, least).is_none());
            let expected = Tree::new(surface).distance(&point);
            prop_assert!((least.sqrt() - expected).abs() < 1e-12);
        }
    }
}
