//! A curve in the plane as the closed loops it consists of.

use super::Hypersurface;
use crate::numbers::Numbers;
use glam::DVec2;

/// Corners closer than this are one: where outlines cross, the same point comes out of several formulas.
const COINCIDENT: f64 = 1e-10;

/// A loop of an outline.
#[derive(Clone, Debug)]
pub struct Loop {
    pub points: Vec<DVec2>,
    /// Around a hole rather than a body.
    pub is_hole: bool,
}

impl Loop {
    /// Of the box around it.
    pub fn middle(&self) -> DVec2 {
        let low = self.points.iter().fold(DVec2::INFINITY, |low, &point| low.min(point));
        let high = self.points.iter().fold(DVec2::NEG_INFINITY, |high, &point| high.max(point));
        0.5 * (low + high)
    }
}

impl Hypersurface<2> {
    /// The loops, if the curve is the whole outline of some body: what lies inside an odd number of others is a hole.
    pub fn loops(&self) -> Vec<Loop> {
        let mut loops = self.chains();
        let starts: Vec<DVec2> = loops.iter().map(|points| middle_of_first(points)).collect();
        // A loop holds a point if a ray from there crosses it an odd number of times; all loops but the point's own count.
        let depth = |number: usize| {
            let crossings = |points: &Vec<DVec2>| edges(points).filter(|&[a, b]| crosses(starts[number], a, b)).count();
            loops
                .iter()
                .enumerate()
                .filter(|(other, _)| *other != number)
                .map(|(_, points)| crossings(points))
                .sum::<usize>()
        };
        let holes: Vec<bool> = (0..loops.len()).map(|number| depth(number) % 2 == 1).collect();
        loops.drain(..).zip(holes).map(|(points, is_hole)| Loop { points, is_hole }).collect()
    }

    /// Segments joined at their ends, in their order where several would do.
    fn chains(&self) -> Vec<Vec<DVec2>> {
        let mut numbers = Numbers::default();
        let places: Vec<u32> = self.points.iter().map(|&point| place(&mut numbers, DVec2::from(point))).collect();
        let mut at_place: Vec<Vec<u32>> = vec![Vec::new(); numbers.len()];
        for (segment, ends) in self.simplices.iter().enumerate() {
            for end in ends {
                at_place[places[*end as usize] as usize].push(segment as u32);
            }
        }
        let mut used = vec![false; self.simplices.len()];
        let mut chains = Vec::new();
        for first in 0..self.simplices.len() {
            if used[first] {
                continue;
            }
            let [start, mut corner] = self.simplices[first];
            let mut chain = vec![DVec2::from(self.points[start as usize])];
            used[first] = true;
            while places[corner as usize] != places[start as usize] {
                chain.push(DVec2::from(self.points[corner as usize]));
                let place = places[corner as usize];
                let Some(&next) = at_place[place as usize].iter().find(|&&next| !used[next as usize]) else { break };
                used[next as usize] = true;
                let [a, b] = self.simplices[next as usize];
                corner = if places[a as usize] == place { b } else { a };
            }
            chains.push(chain);
        }
        chains
    }
}

fn middle_of_first(points: &[DVec2]) -> DVec2 {
    0.5 * (points[0] + points[1 % points.len()])
}

fn edges(points: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> {
    (0..points.len()).map(|k| [points[k], points[(k + 1) % points.len()]])
}

/// Whether the ray from a point to the right crosses the edge.
fn crosses(from: DVec2, a: DVec2, b: DVec2) -> bool {
    (a.y > from.y) != (b.y > from.y) && from.x < a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x)
}

/// The number of a place, the same for points that coincide.
fn place(numbers: &mut Numbers, point: DVec2) -> u32 {
    let key = |dx: f64, dy: f64| [point.x + dx, point.y + dy].map(|x| (x / (4.0 * COINCIDENT)).floor() as i64);
    let around = [0.0, -COINCIDENT, COINCIDENT];
    let known = around.iter().find_map(|&dx| around.iter().find_map(|&dy| numbers.get(key(dx, dy))));
    known.unwrap_or_else(|| numbers.of(key(0.0, 0.0)))
}

#[cfg(test)]
mod tests {
    use crate::distance::SignedDistance;
    use crate::grid::Grid;
    use glam::DVec2;

    fn square(centre: [f64; 2], half: f64) -> Vec<DVec2> {
        [[-half, -half], [half, -half], [half, half], [-half, half]]
            .map(|offset| DVec2::from(centre) + DVec2::from(offset))
            .to_vec()
    }

    /// Bodies and holes of what squares enclose.
    fn counts(squares: &[([f64; 2], f64)]) -> [usize; 2] {
        let loops: Vec<Vec<DVec2>> = squares.iter().map(|&(centre, half)| square(centre, half)).collect();
        let shape = SignedDistance::from_loops(Grid::new(64), &loops).expect("a valid shape");
        let loops = shape.outline().loops();
        let holes = loops.iter().filter(|found| found.is_hole).count();
        [loops.len() - holes, holes]
    }

    #[test]
    fn bodies_and_holes_are_counted_by_what_holds_them() {
        assert_eq!(counts(&[([0.5, 0.5], 0.2)]), [1, 0]);
        assert_eq!(counts(&[([0.3, 0.5], 0.1), ([0.7, 0.5], 0.1)]), [2, 0]);
        assert_eq!(counts(&[([0.5, 0.5], 0.3), ([0.5, 0.5], 0.2)]), [1, 1]);
        assert_eq!(counts(&[([0.5, 0.5], 0.3), ([0.5, 0.5], 0.2), ([0.5, 0.5], 0.1)]), [2, 1]);
    }

    #[test]
    fn crossing_loops_are_one_body() {
        assert_eq!(counts(&[([0.4, 0.45], 0.15), ([0.6, 0.55], 0.15)]), [1, 0]);
        // Four bars around a square hole.
        let bars = [[0.5, 0.3], [0.5, 0.7], [0.3, 0.5], [0.7, 0.5]].map(|centre| (centre, 0.11));
        assert_eq!(counts(&bars), [1, 1]);
    }
}
