//! How a match ended, in words: what fits, and if something does not, what and where.

mod solid;

pub use solid::{SolidPair, Topology};

use crate::distance::SignedDistance;
use crate::grid::Grid;
use crate::hypersurface::Loop;
use crate::narrow::{Narrowest, narrowest};
use crate::report::Report;
use crate::words::fixed;
use glam::DVec2;
use std::fmt;

/// A match fits if the moved reference lies this close to the template everywhere, and the template that close to it, in
/// cells.
const CLOSE: f64 = 0.5;
const COVERED: f64 = 1.0;
/// Length of the matched curve over the template's beyond which it crumples, and below which it leaves out parts.
const CRUMPLED: f64 = 1.1;
const LEFT_OUT: f64 = 0.9;
/// Cells that a neck or gap must be wide for a grid to tell its two sides from one.
pub const RESOLVED: f64 = 2.0;
/// The finest grid that is offered: the next one takes minutes.
const FINEST_OFFERED: u32 = 9;

/// What sentences call the two shapes: the template of the interface is the target for people.
const SHAPES: [&str; 2] = ["reference", "target"];

/// Numbers of a verdict's facts, and of those of [`Unresolved`].
pub const FACTS: usize = 6 + NARROW;
pub const NARROW: usize = 6;
/// Where a list of facts has nothing to say, its first number is this one.
pub const NO_FACT: f64 = -1.0;

/// What is to be known of a pair of shapes before it is matched.
#[derive(Clone, Debug)]
pub struct Pair {
    /// Reference and template.
    shapes: [Shape; 2],
}

#[derive(Clone, Debug)]
struct Shape {
    loops: Vec<Loop>,
    /// Where the grid of the shapes does not resolve it.
    narrowest: Option<Narrowest>,
}

/// Bodies and holes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    pub bodies: usize,
    pub holes: usize,
}

/// A neck or gap that a grid does not resolve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unresolved {
    /// "reference" or "target".
    pub shape: &'static str,
    /// In cells of the grid.
    pub width: f64,
    pub at: DVec2,
    pub is_gap: bool,
    /// The level of the least fine grid that resolves it, if there is one.
    pub level: Option<u32>,
}

/// What a match came to: in words, and for those who say it in another language.
#[derive(Clone, Debug)]
pub struct Verdict {
    pub words: String,
    /// What the words are made of, besides what the report holds: the kind, what is counted of both shapes, then where
    /// the largest distance is (0 hole, 1 part, 2 outline of the template, 3 the moved reference; x, y), then what
    /// [`Unresolved::facts`] gives; [`NO_FACT`] stands for what the words do not say.
    pub facts: [f64; FACTS],
}

/// What a match can come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Parts,
    NotReached,
    Holes,
    Crumpled,
    Fits,
    Unresolved,
    Misfit,
}

/// What the match missed of the template.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Missed {
    Hole(DVec2),
    Part(DVec2),
    Outline(DVec2),
}

impl Pair {
    pub fn new(reference: &SignedDistance<2>, template: &SignedDistance<2>) -> Self {
        // A narrow part is looked for up to the width that the grid of the shapes just resolves.
        let limit = RESOLVED * reference.grid().spacing();
        let shape = |shape: &SignedDistance<2>| {
            let loops = shape.outline().loops();
            let points: Vec<Vec<DVec2>> = loops.iter().map(|found| found.points.clone()).collect();
            Shape { narrowest: narrowest(&points, limit), loops }
        };
        Self { shapes: [shape(reference), shape(template)] }
    }

    /// Of reference and template.
    pub fn parts(&self) -> [Parts; 2] {
        self.shapes.each_ref().map(|shape| {
            let holes = shape.loops.iter().filter(|found| found.is_hole).count();
            Parts { bodies: shape.loops.len() - holes, holes }
        })
    }

    /// The narrowest neck or gap of both shapes, if the grid of `level` does not resolve it.
    pub fn unresolved(&self, level: u32) -> Option<Unresolved> {
        let cells = |level: u32| Grid::<2>::of_level(level).cells() as f64;
        let named = SHAPES.into_iter().zip(&self.shapes);
        named
            .filter_map(|(shape, Shape { narrowest, .. })| {
                let Narrowest { width, at, is_gap } = (*narrowest)?;
                let resolves = |level: &u32| width * cells(*level) >= RESOLVED;
                let finer = (level..=FINEST_OFFERED).find(resolves);
                let unresolved = Unresolved { shape, width: width * cells(level), at, is_gap, level: finer };
                (!resolves(&level)).then_some(unresolved)
            })
            .min_by(|a, b| a.width.total_cmp(&b.width))
    }

    /// What a match on the grid of `level` came to.
    pub fn verdict(&self, level: u32, report: &Report<2>) -> Verdict {
        let kind = self.kind(level, report);
        let [from, to] = self.parts();
        let (mismatch, cover) = (&report.mismatch, &report.cover);
        let counts = if kind == Kind::Holes { [from.holes, to.holes] } else { [from.bodies, to.bodies] };
        let unlike = |noun| {
            let [from, to] = counts.map(|count| counted(count, noun));
            let distances = self.distances(report);
            format!("{} against {to}: no deformation takes the one shape to the other. {distances}", capital(from))
        };
        let hint = match kind {
            Kind::NotReached | Kind::Unresolved => self.unresolved(level),
            _ => None,
        };
        let words = match (kind, hint) {
            (Kind::Parts, _) => unlike("part"),
            (Kind::Holes, _) => unlike("hole"),
            (Kind::NotReached, hint) => {
                let missed = self.missed(DVec2::from(cover.at));
                let hint = hint.map_or_else(String::new, |unresolved| format!(" {}", unresolved.sentence()));
                format!("Fits but {missed} was not reached: it is {} cells away.{hint}", fixed(cover.max, 1))
            }
            (Kind::Crumpled, _) => {
                format!("Crumpled (measure {}). {}", fixed(report.measure, 2), self.distances(report))
            }
            (Kind::Fits, _) => fitting(mismatch.max.max(cover.max)),
            (_, Some(unresolved)) => format!("Not resolved by this grid: {unresolved}. {}", self.distances(report)),
            (_, None) => format!("Does not fit. {}", self.distances(report)),
        };
        let (place, at) = if cover.max > mismatch.max {
            self.missed(DVec2::from(cover.at)).facts()
        } else {
            (3.0, DVec2::from(mismatch.at))
        };
        let [shape, width, x, y, part, finer] = Unresolved::facts(hint.as_ref());
        let [from, to] = counts.map(|count| count as f64);
        Verdict { words, facts: [f64::from(kind as u8), from, to, place, at.x, at.y, shape, width, x, y, part, finer] }
    }

    fn kind(&self, level: u32, report: &Report<2>) -> Kind {
        let [from, to] = self.parts();
        let (mismatch, cover) = (&report.mismatch, &report.cover);
        let close = mismatch.max <= CLOSE;
        let fits = close && cover.max <= COVERED;
        if from.bodies != to.bodies {
            Kind::Parts
        } else if close && cover.max > COVERED {
            Kind::NotReached
        } else if from.holes != to.holes {
            Kind::Holes
        } else if fits && report.measure > CRUMPLED || !fits && report.measure > 1.2 {
            Kind::Crumpled
        } else if fits && report.measure >= LEFT_OUT {
            Kind::Fits
        } else if self.unresolved(level).is_some() {
            Kind::Unresolved
        } else {
            Kind::Misfit
        }
    }

    fn distances(&self, report: &Report<2>) -> String {
        let (mismatch, cover) = (&report.mismatch, &report.cover);
        if cover.max > mismatch.max {
            let missed = self.missed(DVec2::from(cover.at));
            return format!("The largest distance is {} cells: {missed} was not reached.", fixed(cover.max, 2));
        }
        format!("The largest distance is {} cells, at {}.", fixed(mismatch.max, 2), place(DVec2::from(mismatch.at)))
    }

    /// What the point of the template's outline belongs to.
    fn missed(&self, at: DVec2) -> Missed {
        let loops = &self.shapes[1].loops;
        let away = |found: &Loop| found.points.iter().map(|point| point.distance(at)).fold(f64::INFINITY, f64::min);
        let Some(nearest) = loops.iter().min_by(|a, b| away(a).total_cmp(&away(b))) else {
            return Missed::Outline(at);
        };
        if nearest.is_hole {
            return Missed::Hole(nearest.middle());
        }
        if loops.iter().filter(|found| !found.is_hole).count() > 1 {
            return Missed::Part(nearest.middle());
        }
        Missed::Outline(at)
    }
}

impl Unresolved {
    pub fn sentence(&self) -> String {
        format!("{}.", capital(self.to_string()))
    }

    /// What the words are made of: whether it is the template's, the width in cells, x, y, whether it is a gap, the level
    /// or 0.
    pub fn facts(found: Option<&Self>) -> [f64; NARROW] {
        let Some(Self { shape, width, at, is_gap, level }) = found else { return [NO_FACT; NARROW] };
        let flag = |flag: bool| f64::from(u8::from(flag));
        [flag(*shape == SHAPES[1]), *width, at.x, at.y, flag(*is_gap), f64::from(level.unwrap_or(0))]
    }
}

impl Missed {
    fn facts(self) -> (f64, DVec2) {
        match self {
            Self::Hole(at) => (0.0, at),
            Self::Part(at) => (1.0, at),
            Self::Outline(at) => (2.0, at),
        }
    }
}

impl fmt::Display for Missed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hole(at) => write!(f, "the hole at {}", place(*at)),
            Self::Part(at) => write!(f, "the part at {}", place(*at)),
            Self::Outline(at) => write!(f, "the outline at {}", place(*at)),
        }
    }
}

/// Reads on after "…: ", without a full stop.
impl fmt::Display for Unresolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { shape, width, at, is_gap, level } = self;
        if *width < 0.05 {
            write!(f, "the {shape} touches itself at {}", place(*at))?;
        } else {
            let part = if *is_gap { "gap" } else { "neck" };
            write!(f, "the {shape}'s narrowest {part}, at {}, is {} cells wide", place(*at), fixed(*width, 1))?;
        }
        match level {
            Some(level) => write!(f, "; a grid of {}² resolves it", Grid::<2>::of_level(*level).side()),
            None => {
                let side = Grid::<2>::of_level(FINEST_OFFERED).side();
                write!(f, "; not even a grid of {side}² resolves it, make it wider")
            }
        }
    }
}

/// Rounded upwards: "nowhere more" is to be true of the numbers beside it, too.
fn fitting(most: f64) -> String {
    format!("Fits: nowhere more than {} cells off.", fixed((100.0 * most).ceil() / 100.0, 2))
}

fn place(at: DVec2) -> String {
    format!("({}, {})", fixed(at.x, 2), fixed(at.y, 2))
}

fn counted(count: usize, noun: &str) -> String {
    const WORDS: [&str; 7] = ["no", "one", "two", "three", "four", "five", "six"];
    let number = WORDS.get(count).map_or_else(|| count.to_string(), ToString::to_string);
    format!("{number} {noun}{}", if count == 1 { "" } else { "s" })
}

fn capital(mut text: String) -> String {
    if let Some(first) = text.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::report;
    use std::f64::consts::TAU;

    const LEVEL: u32 = 7;

    fn shape(loops: &[Vec<DVec2>]) -> SignedDistance<2> {
        SignedDistance::from_loops(Grid::of_level(LEVEL), loops).expect("a valid shape")
    }

    fn circle(centre: [f64; 2], radius: f64) -> Vec<DVec2> {
        let angles = (0..512).map(|k| TAU * f64::from(k) / 512.0);
        angles.map(|angle| DVec2::from(centre) + radius * DVec2::from_angle(angle)).collect()
    }

    /// A square with a slit of the given width from the right to its middle.
    fn slit(width: f64) -> Vec<DVec2> {
        let half = 0.5 * width;
        let corners =
            [[0.3, 0.3], [0.7, 0.3], [0.7, 0.5 - half], [0.5, 0.5 - half], [0.5, 0.5 + half], [0.7, 0.5 + half]];
        corners.into_iter().chain([[0.7, 0.7], [0.3, 0.7]]).map(DVec2::from).collect()
    }

    /// Of the displacement `u`.
    fn moved(from: &[Vec<DVec2>], to: &[Vec<DVec2>], u: impl Fn([f64; 2]) -> [f64; 2]) -> String {
        judged(from, to, u).words
    }

    fn judged(from: &[Vec<DVec2>], to: &[Vec<DVec2>], u: impl Fn([f64; 2]) -> [f64; 2]) -> Verdict {
        let (from, to) = (shape(from), shape(to));
        let displacement: Vec<f64> =
            (0..from.grid().node_count()).flat_map(|node| u(from.grid().position(node))).collect();
        Pair::new(&from, &to).verdict(LEVEL, &report(&from, &to, &displacement))
    }

    fn still(from: &[Vec<DVec2>], to: &[Vec<DVec2>]) -> String {
        moved(from, to, |_| [0.0; 2])
    }

    #[test]
    fn what_fits_is_nowhere_farther_off_than_is_said() {
        for (most, said) in [(0.0, "0.00"), (0.0017, "0.01"), (0.05, "0.05"), (0.0506, "0.06"), (0.4901, "0.50")] {
            assert_eq!(fitting(most), format!("Fits: nowhere more than {said} cells off."));
        }
    }

    #[test]
    fn a_shape_fits_itself() {
        let disc = [circle([0.5; 2], 0.3)];
        assert!(still(&disc, &disc).starts_with("Fits: nowhere more than 0.0"), "{}", still(&disc, &disc));
    }

    #[test]
    fn a_shift_by_a_cell_does_not_fit() {
        let disc = [circle([0.5; 2], 0.3)];
        let words = moved(&disc, &disc, |_| [1.0 / 128.0, 0.0]);
        assert!(words.starts_with("Does not fit. The largest distance is 1.0"), "{words}");
    }

    #[test]
    fn a_hole_that_was_not_reached_is_named() {
        let words = still(&[circle([0.5; 2], 0.3)], &[circle([0.5; 2], 0.3), circle([0.55, 0.5], 0.1)]);
        assert_eq!(words, "Fits but the hole at (0.55, 0.50) was not reached: it is 32.0 cells away.");
    }

    #[test]
    fn a_spike_that_was_not_reached_is_named() {
        let disc = circle([0.5; 2], 0.2);
        // The first point lies on the right.
        let spiked: Vec<DVec2> = disc.iter().skip(1).copied().chain([DVec2::new(0.85, 0.5)]).collect();
        let words = still(&[disc], &[spiked]);
        assert!(words.starts_with("Fits but the outline at (0.85, 0.50) was not reached: it is 19."), "{words}");
    }

    #[test]
    fn parts_are_counted_against_each_other() {
        let discs = [[0.25, 0.5], [0.5, 0.5], [0.75, 0.5]].map(|centre| circle(centre, 0.1));
        let words = still(&discs[..2], &discs);
        assert!(words.starts_with("Two parts against three parts: no deformation"), "{words}");
        assert!(words.contains("the part at (0.75, 0.50) was not reached"), "{words}");
    }

    #[test]
    fn holes_are_counted_against_each_other() {
        let ring = [circle([0.5; 2], 0.3), circle([0.5; 2], 0.15)];
        let words = still(&ring, &ring[..1]);
        assert!(words.starts_with("One hole against no holes: no deformation"), "{words}");
    }

    #[test]
    fn a_curve_that_is_too_long_is_crumpled() {
        let bar = [[[0.2, 0.45], [0.8, 0.45], [0.8, 0.55], [0.2, 0.55]].map(DVec2::from).to_vec()];
        let words = moved(&bar, &bar, |x| [0.0, 0.0036 * (TAU * 42.0 * x[0]).sin()]);
        assert!(words.starts_with("Crumpled (measure 1."), "{words}");
    }

    #[test]
    fn a_gap_that_the_grid_does_not_resolve_is_named_with_the_grid_that_does() {
        let (square, cut) = (slit(0.25), slit(0.8 / 128.0));
        let words = still(&[square], &[cut]);
        assert!(words.starts_with("Not resolved by this grid: the target's narrowest gap"), "{words}");
        assert!(words.contains("is 0.8 cells wide; a grid of 513² resolves it"), "{words}");
        let pair = Pair::new(&shape(&[circle([0.5; 2], 0.3)]), &shape(&[slit(0.3 / 128.0)]));
        let unresolved = pair.unresolved(LEVEL).unwrap();
        assert_eq!(unresolved.level, None);
        assert!(unresolved.to_string().contains("not even a grid of 513² resolves it"), "{unresolved}");
    }

    #[test]
    fn facts_tell_what_the_words_tell() {
        let (square, cut) = (slit(0.25), slit(0.8 / 128.0));
        let Verdict { words, facts } = judged(&[square], &[cut], |_| [0.0; 2]);
        let [kind, from, to, _, x, y, shape, width, _, _, part, level] = facts;
        assert_eq!([kind, from, to, shape, part, level], [5.0, 1.0, 1.0, 1.0, 1.0, 9.0], "{words}");
        assert!((0.75..0.85).contains(&width) && words.contains(&place(DVec2::new(x, y))), "{facts:?}: {words}");

        let disc = [circle([0.5; 2], 0.3)];
        let Verdict { facts, .. } = judged(&disc, &disc, |_| [0.0; 2]);
        assert_eq!((facts[0], &facts[6..]), (4.0, &[NO_FACT; NARROW][..]));

        let ring = [circle([0.5; 2], 0.3), circle([0.5; 2], 0.1)];
        let Verdict { words, facts } = judged(&ring[..1], &ring, |_| [0.0; 2]);
        assert_eq!(facts[3], 0.0, "the hole was missed: {words}");
        assert!((facts[4] - 0.5).hypot(facts[5] - 0.5) < 0.01, "{facts:?}");
    }

    #[test]
    fn what_is_wide_enough_is_resolved() {
        let pair = Pair::new(&shape(&[circle([0.5; 2], 0.3)]), &shape(&[slit(2.1 / 128.0)]));
        assert_eq!(pair.unresolved(LEVEL), None);
    }
}
