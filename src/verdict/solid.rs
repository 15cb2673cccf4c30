//! The same for surfaces.

use super::{CLOSE, COVERED, CRUMPLED, LEFT_OUT, SHAPES, capital, counted, fitting};
use crate::distance::SignedDistance;
use crate::hypersurface::Hypersurface;
use crate::report::Report;
use crate::words::fixed;

/// A part of a surface that lies farther than this outside of what the grid sees is thinner than the grid, in cells.
const UNSEEN: f64 = 0.5;

/// What is to be known of a pair of surfaces before it is matched.
#[derive(Clone, Debug)]
pub struct SolidPair {
    /// Reference and template.
    topologies: [Topology; 2],
    unseen: Option<Unseen>,
}

/// What no deformation changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Topology {
    /// Closed surfaces.
    pub parts: usize,
    /// Of all parts together: one of a torus, none of a sphere.
    pub handles: usize,
}

/// The place of a shape that its grid sees least of.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Unseen {
    shape: &'static str,
    at: [f64; 3],
}

impl SolidPair {
    pub fn new(reference: &SignedDistance<3>, template: &SignedDistance<3>) -> Self {
        let shapes = [(SHAPES[0], reference), (SHAPES[1], template)];
        let unseen = |(name, shape): (&'static str, &SignedDistance<3>)| {
            let (at, cells) = shape.least_seen()?;
            (cells > UNSEEN).then_some((cells, Unseen { shape: name, at }))
        };
        let worst = shapes.into_iter().filter_map(unseen).max_by(|a, b| a.0.total_cmp(&b.0));
        Self {
            topologies: shapes.map(|(_, shape)| Topology::of(&Hypersurface::zero_set(shape.grid(), shape.values()))),
            unseen: worst.map(|(_, unseen)| unseen),
        }
    }

    /// Of reference and template, as their grid sees them.
    pub fn topologies(&self) -> [Topology; 2] {
        self.topologies
    }

    /// A sentence, if the grid of the shapes does not resolve them.
    pub fn unresolved(&self) -> Option<String> {
        let Unseen { shape, at } = self.unseen?;
        Some(format!("The {shape} is thinner than the grid at {}; choose a finer one.", place(&at)))
    }

    /// What a match came to.
    pub fn verdict(&self, report: &Report<3>) -> String {
        let [from, to] = self.topologies;
        let (mismatch, cover) = (&report.mismatch, &report.cover);
        let different = |from: usize, to: usize, noun: &str| {
            format!(
                "{} against {}: no deformation takes the one shape to the other. {}",
                capital(counted(from, noun)),
                counted(to, noun),
                distances(report),
            )
        };
        if from.parts != to.parts {
            return different(from.parts, to.parts, "part");
        }
        if from.handles != to.handles {
            return different(from.handles, to.handles, "handle");
        }
        let close = mismatch.max <= CLOSE;
        if close && cover.max > COVERED {
            let hint = self.unresolved().map_or_else(String::new, |sentence| format!(" {sentence}"));
            let (at, away) = (place(&cover.at), fixed(cover.max, 1));
            return format!("Fits but the surface at {at} was not reached: it is {away} cells away.{hint}");
        }
        let fits = close && cover.max <= COVERED;
        if fits && report.measure > CRUMPLED || !fits && report.measure > 1.2 {
            return format!("Crumpled (measure {}). {}", fixed(report.measure, 2), distances(report));
        }
        if fits && report.measure >= LEFT_OUT {
            return fitting(mismatch.max.max(cover.max));
        }
        match self.unresolved() {
            Some(sentence) => format!("Not resolved by this grid. {sentence} {}", distances(report)),
            None => format!("Does not fit. {}", distances(report)),
        }
    }
}

impl Topology {
    /// Of a surface without rim.
    fn of(surface: &Hypersurface<3>) -> Self {
        let mut parents: Vec<u32> = (0..surface.points().len() as u32).collect();
        let mut parts = parents.len();
        for [a, b, c] in surface.simplices() {
            for other in [b, c] {
                let (one, other) = (root(&mut parents, *a), root(&mut parents, *other));
                if one != other {
                    parents[one as usize] = other;
                    parts -= 1;
                }
            }
        }
        // Euler: V − E + F = 2 (parts − handles), with E = 3F/2.
        let twice = 2 * surface.points().len() as i64 - surface.simplices().len() as i64;
        Self { parts, handles: (parts as i64 - twice / 4).max(0) as usize }
    }
}

fn root(parents: &mut [u32], mut number: u32) -> u32 {
    while parents[number as usize] != number {
        parents[number as usize] = parents[parents[number as usize] as usize];
        number = parents[number as usize];
    }
    number
}

fn distances(report: &Report<3>) -> String {
    let (mismatch, cover) = (&report.mismatch, &report.cover);
    if cover.max > mismatch.max {
        let (most, at) = (fixed(cover.max, 2), place(&cover.at));
        return format!("The largest distance is {most} cells: the surface at {at} was not reached.");
    }
    format!("The largest distance is {} cells, at {}.", fixed(mismatch.max, 2), place(&mismatch.at))
}

fn place(at: &[f64; 3]) -> String {
    let [x, y, z] = at.map(|x| fixed(x, 2));
    format!("({x}, {y}, {z})")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Grid;
    use crate::report::report;
    use glam::{DVec2, DVec3};

    fn shape(value: impl Fn(DVec3) -> f64) -> SignedDistance<3> {
        let grid = Grid::new(32);
        let values = (0..grid.node_count()).map(|node| value(DVec3::from(grid.position(node)))).collect();
        SignedDistance::from_nodal(grid, values)
    }

    fn ball(centre: [f64; 3], radius: f64) -> impl Fn(DVec3) -> f64 {
        move |x| x.distance(DVec3::from(centre)) - radius
    }

    fn torus(x: DVec3) -> f64 {
        let x = x - 0.5;
        DVec2::new(DVec2::new(x.x, x.y).length() - 0.25, x.z).length() - 0.1
    }

    /// Of a displacement that is the same everywhere.
    fn shifted(from: &SignedDistance<3>, to: &SignedDistance<3>, shift: [f64; 3]) -> String {
        let displacement: Vec<f64> = (0..from.grid().node_count()).flat_map(|_| shift).collect();
        SolidPair::new(from, to).verdict(&report(from, to, &displacement))
    }

    #[test]
    fn parts_and_handles_are_counted() {
        let two = |x| ball([0.3, 0.5, 0.5], 0.12)(x).min(ball([0.7, 0.5, 0.5], 0.12)(x));
        let hollow = |x| ball([0.5; 3], 0.3)(x).max(-ball([0.5; 3], 0.15)(x));
        let pair = SolidPair::new(&shape(torus), &shape(two));
        let [ring, pieces] = pair.topologies();
        assert_eq!((ring, pieces), (Topology { parts: 1, handles: 1 }, Topology { parts: 2, handles: 0 }));
        let [shell, body] = SolidPair::new(&shape(hollow), &shape(ball([0.5; 3], 0.3))).topologies();
        assert_eq!((shell, body), (Topology { parts: 2, handles: 0 }, Topology { parts: 1, handles: 0 }));
    }

    #[test]
    fn a_ball_fits_itself_and_not_itself_a_cell_away() {
        let body = shape(ball([0.5; 3], 0.3));
        assert!(shifted(&body, &body, [0.0; 3]).starts_with("Fits: nowhere more than 0.0"));
        let words = shifted(&body, &body, [1.0 / 32.0, 0.0, 0.0]);
        assert!(words.starts_with("Does not fit. The largest distance is 1.0"), "{words}");
    }

    #[test]
    fn a_torus_is_no_ball() {
        let words = shifted(&shape(torus), &shape(ball([0.5; 3], 0.3)), [0.0; 3]);
        assert!(words.starts_with("One handle against no handles: no deformation"), "{words}");
    }
}
