//! The distance to the nearest of many simplices, exactly.

use super::Hypersurface;
use crate::order::ascending;
use crate::small::{add_scaled, dot};
use std::sync::Arc;

/// Simplices that are tried one by one. In space, where one takes as long as many boxes and a thicker box is looked into from
/// farther away, fewer.
const fn leaf<const D: usize>() -> usize {
    if D == 2 { 4 } else { 1 }
}

/// Boxes around simplices, halved again and again along their longest side.
pub struct Tree<const D: usize> {
    surface: Arc<Hypersurface<D>>,
    /// The simplices, those of a box next to each other.
    order: Vec<u32>,
    /// In depth-first order.
    boxes: Vec<Bounds<D>>,
}

/// The point of a surface that is nearest to another.
#[derive(Clone, Copy, Debug)]
pub struct Nearest<const D: usize> {
    pub distance: f64,
    /// The simplex on which it lies,
    pub simplex: usize,
    /// and the shares of its corners in it.
    pub shares: [f64; D],
}

#[derive(Clone, Copy)]
struct Bounds<const D: usize> {
    low: [f64; D],
    high: [f64; D],
    /// The part of `order` inside.
    first: u32,
    count: u32,
    /// The second half; the first one follows directly. Zero for a leaf.
    second: u32,
}

impl<const D: usize> Tree<D> {
    pub fn new(surface: impl Into<Arc<Hypersurface<D>>>) -> Self {
        let surface = surface.into();
        let centres: Vec<[f64; D]> = surface.middles().map(|(middle, _)| middle).collect();
        let mut tree = Self { surface, order: (0..centres.len() as u32).collect(), boxes: Vec::new() };
        if !centres.is_empty() {
            tree.add(&centres, 0, centres.len());
        }
        tree
    }

    fn add(&mut self, centres: &[[f64; D]], first: usize, count: usize) {
        let place = self.boxes.len();
        let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
        for &simplex in &self.order[first..first + count] {
            for corner in self.surface.corners(simplex as usize) {
                for axis in 0..D {
                    low[axis] = low[axis].min(corner[axis]);
                    high[axis] = high[axis].max(corner[axis]);
                }
            }
        }
        self.boxes.push(Bounds { low, high, first: first as u32, count: count as u32, second: 0 });
        if count > leaf::<D>() {
            let extent = |axis: usize| high[axis] - low[axis];
            let longest = (0..D).max_by(|&a, &b| extent(a).total_cmp(&extent(b))).unwrap_or(0);
            let half = count / 2;
            let part = &mut self.order[first..first + count];
            let places: Vec<f64> = part.iter().map(|&simplex| centres[simplex as usize][longest]).collect();
            let sorted: Vec<u32> = ascending(&places).into_iter().map(|place| part[place as usize]).collect();
            part.copy_from_slice(&sorted);
            self.add(centres, first, half);
            self.boxes[place].second = self.boxes.len() as u32;
            self.add(centres, first + half, count - half);
        }
    }

    /// The distance of a point to the surface; infinite if there is none, or if the point or all of it is not finite.
    pub fn distance(&self, point: &[f64; D]) -> f64 {
        self.nearest(point).map_or(f64::INFINITY, |nearest| nearest.distance)
    }

    /// The nearest point of the surface.
    pub fn nearest(&self, point: &[f64; D]) -> Option<Nearest<D>> {
        self.nearer(point, f64::INFINITY)
    }

    /// The nearest point of the surface if its squared distance is below `square`.
    pub fn nearer(&self, point: &[f64; D], square: f64) -> Option<Nearest<D>> {
        let (mut least, mut found) = (square, None);
        if let Some(bounds) = self.boxes.first() {
            self.search(0, bounds.distance_squared(point), point, &mut least, &mut found);
        }
        found
    }

    fn search(&self, place: usize, away: f64, point: &[f64; D], least: &mut f64, found: &mut Option<Nearest<D>>) {
        if away >= *least {
            return;
        }
        let bounds = &self.boxes[place];
        if bounds.second == 0 {
            let part = bounds.first as usize..(bounds.first + bounds.count) as usize;
            for &simplex in &self.order[part] {
                let (square, shares) = foot(point, &self.surface.corners(simplex as usize));
                if square < *least {
                    *least = square;
                    *found = Some(Nearest { distance: square.sqrt(), simplex: simplex as usize, shares });
                }
            }
            return;
        }
        let halves = [place + 1, bounds.second as usize].map(|half| (half, self.boxes[half].distance_squared(point)));
        let [near, far] = if halves[1].1 < halves[0].1 { [halves[1], halves[0]] } else { halves };
        self.search(near.0, near.1, point, least, found);
        self.search(far.0, far.1, point, least, found);
    }
}

impl<const D: usize> Bounds<D> {
    #[inline]
    fn distance_squared(&self, point: &[f64; D]) -> f64 {
        let mut square = 0.0;
        for axis in 0..D {
            let outside = (self.low[axis] - point[axis]).max(point[axis] - self.high[axis]).max(0.0);
            square += outside * outside;
        }
        square
    }
}

/// The squared distance to a simplex, and the shares of its corners in the point that is nearest.
pub(crate) fn foot<const D: usize>(point: &[f64; D], corners: &[[f64; D]; D]) -> (f64, [f64; D]) {
    if D == 2 {
        return on_edge(point, corners, 0, 1);
    }
    let offset = add_scaled(point, -1.0, &corners[0]);
    let [a, b] = [1, 2].map(|k| add_scaled(&corners[k], -1.0, &corners[0]));
    let (aa, ab, bb) = (dot(&a, &a), dot(&a, &b), dot(&b, &b));
    let (oa, ob) = (dot(&offset, &a), dot(&offset, &b));
    let det = aa * bb - ab * ab;
    // The shares of the second and of the third corner in the foot on the plane, times the determinant.
    let (s, t) = (oa * bb - ob * ab, ob * aa - oa * ab);
    // A triangle that is hardly more than a line has no side that could be told.
    let is_line = det <= LINE * aa * bb;
    if !is_line && s >= 0.0 && t >= 0.0 && s + t <= det {
        let (s, t) = (s / det, t / det);
        let away = add_scaled(&add_scaled(&offset, -s, &a), -t, &b);
        let shares = [1.0 - s - t, s, t];
        return (dot(&away, &away), std::array::from_fn(|k| shares[k]));
    }
    // The nearest point lies on an edge that is seen from here.
    let mut nearest = (f64::INFINITY, [0.0; D]);
    for (is_seen, i, j) in [(t < 0.0, 0, 1), (s + t > det, 1, 2), (s < 0.0, 2, 0)] {
        if is_seen || is_line {
            let found = on_edge(point, corners, i, j);
            if found.0 < nearest.0 {
                nearest = found;
            }
        }
    }
    nearest
}

/// The squared sine of an angle of a triangle below which it is a line to [`foot`].
const LINE: f64 = 1e-10;

/// The same for the edge between two corners.
fn on_edge<const D: usize>(point: &[f64; D], corners: &[[f64; D]; D], i: usize, j: usize) -> (f64, [f64; D]) {
    let (offset, along) = (add_scaled(point, -1.0, &corners[i]), add_scaled(&corners[j], -1.0, &corners[i]));
    let square = dot(&along, &along);
    let t = if square > 0.0 { (dot(&offset, &along) / square).clamp(0.0, 1.0) } else { 0.0 };
    let away = add_scaled(&offset, -t, &along);
    let mut shares = [0.0; D];
    (shares[i], shares[j]) = (1.0 - t, t);
    (dot(&away, &away), shares)
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The least distance to a fine sampling of each simplex.
    fn sampled<const D: usize>(surface: &Hypersurface<D>, point: [f64; D]) -> f64 {
        const STEPS: usize = 40;
        let mut least = f64::INFINITY;
        for simplex in 0..surface.simplices().len() {
            let corners = surface.corners(simplex);
            for i in 0..=STEPS {
                for j in 0..=(if D == 3 { STEPS - i } else { 0 }) {
                    let weights = [(STEPS - i - j) as f64, i as f64, j as f64].map(|w| w / STEPS as f64);
                    let square: f64 = (0..D)
                        .map(|axis| (0..D).map(|k| weights[k] * corners[k][axis]).sum::<f64>() - point[axis])
                        .map(|x| x * x)
                        .sum();
                    least = least.min(square);
                }
            }
        }
        least.sqrt()
    }

    fn agrees<const D: usize>(points: Vec<[f64; D]>, point: [f64; D]) -> Result<(), TestCaseError> {
        let simplices = (0..points.len() / D).map(|k| std::array::from_fn(|i| (k * D + i) as u32)).collect();
        let surface = Hypersurface::new(points, simplices);
        let (found, expected) = (Tree::new(surface.clone()).distance(&point), sampled(&surface, point));
        prop_assert!(found <= expected + 1e-12 && expected - found < 0.05, "{found} is not {expected}");
        Ok(())
    }

    proptest! {
        #[test]
        fn the_tree_agrees_with_trying_many_points(
            plane in prop::collection::vec(prop::array::uniform2(0.0..1.0f64), 2..60),
            space in prop::collection::vec(prop::array::uniform3(0.0..1.0f64), 3..60),
            point in prop::array::uniform3(-0.5..1.5f64),
        ) {
            agrees(plane, [point[0], point[1]])?;
            agrees(space, point)?;
        }
    }

    #[test]
    fn nothing_is_infinitely_far_away() {
        assert_eq!(Tree::new(Hypersurface::<2>::default()).distance(&[0.5, 0.5]), f64::INFINITY);
        let surface = Hypersurface::new(vec![[0.0, 0.0], [1.0, 0.0]], vec![[0, 1]]);
        assert_eq!(Tree::new(surface).distance(&[f64::NAN, 0.5]), f64::INFINITY);
    }
}
