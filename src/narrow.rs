//! How narrow a shape gets: what a grid must resolve to see it.

use glam::DVec2;

/// Two points of an outline face each other across a neck or a gap if the way along the outline is this many times
/// the way across. At the tip of a wedge of 39° it is 3 times.
const RATIO: f64 = 3.0;
/// … and if it is this long: corners are no necks, however sharp.
const LEAST_WAY: f64 = 1.0 / 16.0;
/// Distance of the points that are looked at. The way across is exact between the corners of the outline and its edges.
const SAMPLING: f64 = 1.0 / 512.0;

/// The narrowest part of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Narrowest {
    /// The way across.
    pub width: f64,
    /// Its middle.
    pub at: DVec2,
    /// Between two outsides rather than two insides.
    pub is_gap: bool,
}

/// The narrowest neck or gap of what closed polygons outline, if it is below `limit`: the least way across between two
/// points of the outline whose way along it is much longer.
pub fn narrowest(loops: &[Vec<DVec2>], limit: f64) -> Option<Narrowest> {
    let samples = Samples::new(loops, limit);
    let mut best: Option<(f64, DVec2)> = None;
    let mut least = limit;
    for (number, sample) in samples.all.iter().enumerate() {
        samples.near(sample.point, |other| {
            let along = samples.all[other].to - samples.all[other].point;
            let square = along.length_squared();
            let offset = sample.point - samples.all[other].point;
            let t = if square > 0.0 { (offset.dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
            let width = (offset - t * along).length();
            if width < least && samples.way(number, other, t) >= (RATIO * width).max(LEAST_WAY) {
                least = width;
                best = Some((width, sample.point - 0.5 * (offset - t * along)));
            }
        });
    }
    best.map(|(width, at)| Narrowest { width, at, is_gap: !is_inside(loops, at) })
}

/// By the loops that a ray to the right crosses.
fn is_inside(loops: &[Vec<DVec2>], at: DVec2) -> bool {
    let crossed =
        |[a, b]: [DVec2; 2]| (a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x);
    let edges = |points: &Vec<DVec2>| {
        (0..points.len()).filter(|&k| crossed([points[k], points[(k + 1) % points.len()]])).count()
    };
    loops.iter().map(edges).sum::<usize>() % 2 == 1
}

/// A short piece of an outline.
struct Piece {
    point: DVec2,
    to: DVec2,
    outline: usize,
    /// Way along the outline from its beginning.
    way: f64,
}

struct Samples {
    all: Vec<Piece>,
    lengths: Vec<f64>,
    /// Buckets of the box, `side` a side, and the pieces that begin in each.
    side: usize,
    buckets: Vec<Vec<u32>>,
}

impl Samples {
    fn new(loops: &[Vec<DVec2>], reach: f64) -> Self {
        let (mut all, mut lengths) = (Vec::new(), Vec::new());
        for (outline, points) in loops.iter().enumerate() {
            let mut way = 0.0;
            for (k, &from) in points.iter().enumerate() {
                let to = points[(k + 1) % points.len()];
                let length = from.distance(to);
                let count = (length / SAMPLING).ceil().max(1.0);
                let at = |i: f64| from + (to - from) * (i / count);
                all.extend((0..count as usize).map(|i| {
                    let i = i as f64;
                    Piece { point: at(i), to: at(i + 1.0), outline, way: way + length * i / count }
                }));
                way += length;
            }
            lengths.push(way);
        }
        // A piece within reach begins in the same bucket or one beside it.
        let side = ((1.0 / (reach + SAMPLING)) as usize).clamp(1, 512);
        let mut buckets = vec![Vec::new(); side * side];
        for (number, piece) in all.iter().enumerate() {
            let [column, row] = bucket(piece.point, side);
            buckets[row * side + column].push(number as u32);
        }
        Self { all, lengths, side, buckets }
    }

    fn near(&self, point: DVec2, mut visit: impl FnMut(usize)) {
        let around = |i: usize| i.saturating_sub(1)..=(i + 1).min(self.side - 1);
        let [column, row] = bucket(point, self.side);
        for row in around(row) {
            for column in around(column) {
                self.buckets[row * self.side + column].iter().for_each(|&number| visit(number as usize));
            }
        }
    }

    /// The way along the outline from a piece's beginning to the share `t` of another; none leads to another outline.
    fn way(&self, from: usize, to: usize, t: f64) -> f64 {
        let (from, to) = (&self.all[from], &self.all[to]);
        if from.outline != to.outline {
            return f64::INFINITY;
        }
        let way = (to.way + t * to.point.distance(to.to) - from.way).abs();
        way.min(self.lengths[from.outline] - way)
    }
}

fn bucket(point: DVec2, side: usize) -> [usize; 2] {
    [point.x, point.y].map(|x| ((x * side as f64).max(0.0) as usize).min(side - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(points: &[[f64; 2]]) -> Vec<DVec2> {
        points.iter().map(|&point| DVec2::from(point)).collect()
    }

    fn circle(centre: [f64; 2], radius: f64) -> Vec<DVec2> {
        let angles = (0..256).map(|k| f64::from(k) * std::f64::consts::TAU / 256.0);
        angles.map(|angle| DVec2::from(centre) + radius * DVec2::from_angle(angle)).collect()
    }

    /// A square of side 0.4 with a slot of the given width and depth cut into its top.
    fn slotted(width: f64, depth: f64) -> Vec<DVec2> {
        let (left, right, floor) = (0.5 - 0.5 * width, 0.5 + 0.5 * width, 0.7 - depth);
        polygon(&[
            [0.3, 0.3],
            [0.7, 0.3],
            [0.7, 0.7],
            [right, 0.7],
            [right, floor],
            [left, floor],
            [left, 0.7],
            [0.3, 0.7],
        ])
    }

    #[test]
    fn a_disc_and_the_corners_of_a_square_are_not_narrow() {
        assert_eq!(narrowest(&[circle([0.5; 2], 0.3)], 0.2), None);
        assert_eq!(narrowest(&[polygon(&[[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.2, 0.8]])], 0.2), None);
    }

    #[test]
    fn a_gap_and_a_neck_are_as_narrow_as_they_are_wide() {
        let gap = narrowest(&[slotted(0.02, 0.2)], 0.1).unwrap();
        assert!((gap.width - 0.02).abs() < 1e-12 && (gap.at.x - 0.5).abs() < 1e-12 && gap.is_gap, "{gap:?}");
        let neck = narrowest(&[slotted(0.1, 0.37)], 0.1).unwrap();
        assert!((neck.width - 0.03).abs() < 1e-12 && (neck.at.y - 0.315).abs() < 1e-12 && !neck.is_gap, "{neck:?}");
    }

    #[test]
    fn two_outlines_are_narrow_where_they_come_close() {
        let [left, right] = [circle([0.3, 0.5], 0.15), circle([0.65, 0.5], 0.15)];
        let gap = narrowest(&[left, right], 0.1).unwrap();
        assert!((gap.width - 0.05).abs() < 1e-3 && gap.at.distance(DVec2::new(0.475, 0.5)) < 1e-2, "{gap:?}");
    }

    #[test]
    fn what_is_wider_than_asked_for_is_not_reported() {
        assert_eq!(narrowest(&[slotted(0.02, 0.2)], 0.019), None);
    }
}
