//! The nearest of many segments, exactly.

use crate::order::ascending;
use glam::DVec2;

/// A tree over consecutive runs of segments, each run bounded by a capsule: its chord and how far it strays from it.
///
/// A run that stays within `deviation` of its chord is at least |p − chord| − deviation away from p. Segments come in
/// the order of the outline, so runs are nearly straight and the bound is tight where a box would be fat.
pub(super) struct Nearest {
    /// In depth-first order; a run's capsules are followed by those of its parts.
    capsules: Vec<Capsule>,
}

struct Capsule {
    start: DVec2,
    along: DVec2,
    /// 1 / |along|², 0 for a point.
    per_square: f64,
    deviation: f64,
    /// Where to go on when this run is out of reach; a leaf's is its own successor.
    next: u32,
}

impl Capsule {
    fn new([a, b]: [DVec2; 2]) -> Self {
        let along = b - a;
        let square = along.length_squared();
        let per_square = if square > f64::MIN_POSITIVE { 1.0 / square } else { 0.0 };
        Self { start: a, along, per_square, deviation: 0.0, next: 0 }
    }

    #[inline]
    fn distance_squared(&self, point: DVec2) -> f64 {
        let offset = point - self.start;
        let t = (offset.dot(self.along) * self.per_square).clamp(0.0, 1.0);
        (offset - self.along * t).length_squared()
    }
}

impl Nearest {
    pub fn new(segments: &[[DVec2; 2]]) -> Self {
        assert!(!segments.is_empty(), "an outline has segments");
        let mut tree = Self { capsules: Vec::with_capacity(2 * segments.len()) };
        tree.add(&neighbouring(segments));
        tree
    }

    fn add(&mut self, run: &[[DVec2; 2]]) {
        let place = self.capsules.len();
        let mut capsule = Capsule::new([run[0][0], run[run.len() - 1][1]]);
        if run.len() > 1 {
            // Distance to the chord is convex along a segment: its ends have the greatest.
            let greatest = run.iter().flatten().map(|&end| capsule.distance_squared(end)).fold(0.0, f64::max);
            // Rounding must not make the bound exceed the truth.
            capsule.deviation = greatest.sqrt() + 1e-14;
        }
        self.capsules.push(capsule);
        if run.len() > 1 {
            let (left, right) = run.split_at(run.len() / 2);
            self.add(left);
            self.add(right);
        }
        self.capsules[place].next = self.capsules.len() as u32;
    }

    /// The leaf of the last segment: a hint for the first query.
    pub fn any_leaf(&self) -> usize {
        self.capsules.len() - 1
    }

    /// The distance to the nearest segment and its leaf. `hints` are leaves likely to be near, as those of
    /// neighbouring points; they bound the search and do not change the distance.
    pub fn query(&self, point: DVec2, hints: [usize; 2]) -> (f64, usize) {
        let mut leaf = hints[0];
        let mut square = self.capsules[leaf].distance_squared(point);
        let other = self.capsules[hints[1]].distance_squared(point);
        if other < square {
            (leaf, square) = (hints[1], other);
        }
        let mut best = square.sqrt();
        let mut place = 0;
        while let Some(capsule) = self.capsules.get(place) {
            let found = capsule.distance_squared(point);
            let reach = best + capsule.deviation;
            if found >= reach * reach {
                place = capsule.next as usize;
                continue;
            }
            if capsule.next as usize == place + 1 {
                (leaf, best) = (place, found.sqrt());
            }
            place += 1;
        }
        (best, leaf)
    }
}

/// The segments with curves that lie near each other near each other in the list, along a Z-shaped curve through the
/// plane: the runs of thousands of specks in the order of their rows would be as wide as the picture.
fn neighbouring(segments: &[[DVec2; 2]]) -> Vec<[DVec2; 2]> {
    let curves: Vec<&[[DVec2; 2]]> = segments.chunk_by(|before, after| before[1] == after[0]).collect();
    let codes: Vec<f64> = curves.iter().map(|curve| f64::from(interleaved(curve[0][0]))).collect();
    let mut sorted = Vec::with_capacity(segments.len());
    ascending(&codes).into_iter().for_each(|curve| sorted.extend_from_slice(curves[curve as usize]));
    sorted
}

/// The bits of both coordinates by turns.
fn interleaved(point: DVec2) -> u32 {
    let spread = |x: f64| {
        let bits = (x.clamp(0.0, 1.0) * 65535.0) as u32;
        (0..16).fold(0, |code, k| code | (bits >> k & 1) << (2 * k))
    };
    spread(point.x) | spread(point.y) << 1
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_tree_agrees_with_trying_every_segment(
            ends in prop::collection::vec(prop::array::uniform4(0.0..1.0f64), 1..60),
            point in prop::array::uniform2(-0.5..1.5f64),
            hint in 0usize..1000,
        ) {
            let segments: Vec<_> = ends.iter().map(|e| [DVec2::new(e[0], e[1]), DVec2::new(e[2], e[3])]).collect();
            let tree = Nearest::new(&segments);
            let leaves: Vec<_> =
                (0..tree.capsules.len()).filter(|&place| tree.capsules[place].next as usize == place + 1).collect();
            prop_assert_eq!(leaves.len(), segments.len());
            let point = DVec2::from(point);
            let all = segments.iter().map(|&s| Capsule::new(s).distance_squared(point)).fold(f64::INFINITY, f64::min);
            let (found, _) = tree.query(point, [tree.any_leaf(), leaves[hint % leaves.len()]]);
            prop_assert!((found - all.sqrt()).abs() < 1e-15);
        }
    }
}
