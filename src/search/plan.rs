//! Which approaches a search takes, in which order, and what it is content with.

use crate::align::boundary_measure;
use crate::distance::SignedDistance;
use crate::report::Report;
use crate::settings::Settings;
use std::collections::VecDeque;
use std::fmt;

/// A shell compressed to less than this share of its size crumples rather than shrinks (the paper's Fig. 5): such pairs
/// are tried the other way round first.
const SHORTER: f64 = 0.9;

/// A match is good if no point of the shell is farther from its aim, and no point of the aim farther from the shell, than
/// this, in cells; and if the shell is hardly longer than its aim.
const GOOD_MISMATCH: f64 = 0.5;
const GOOD_COVER: f64 = 1.0;
const GOOD_MEASURE: f64 = 1.1;
/// One round of sharpening is worth its while if it is farther than this, though good.
const FINE_MISMATCH: f64 = 0.25;
const FINE_COVER: f64 = 0.5;
/// In cells of the level before the finest.
const HOPELESS_COST: f64 = 2.0;
/// An exchanged match is worth inverting if it is as close as this: errors of φ⁻¹ are stretched by φ.
const INVERTED_MISMATCH: f64 = 1.0;
const INVERTED_COVER: f64 = 2.0;
/// A round of sharpening takes the thickness and the penalty of a grid with an eighth of the spacing; those after it of
/// an eighth of that.
const SHARPER: f64 = 8.0;
const SHARPEST: i32 = 2;
const SHARPENINGS: u8 = 3;
/// Matches that are worse than this are not sharpened: what they miss is not detail, or they have crumpled.
const SHARPENED_COST: f64 = 6.0;
const SHARPENED_MEASURE: f64 = 1.25;

/// One way to look for a match.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Approach {
    /// From the reference to the template, coarse to fine.
    Direct,
    /// From the template to the reference.
    Exchanged,
    /// The inverse of an exchanged match, refined.
    Inverted,
    /// The best match so far, drawn to the template as on a much finer grid, and most where it has missed it; the
    /// number tells the round.
    Sharpened(u8),
    /// The same for an exchanged match that is not yet worth inverting.
    SharpenedExchanged,
    /// From the reference to the template, led by corresponding points of both outlines.
    Guided,
    /// From the template to the reference, led likewise.
    GuidedExchanged,
}

impl Approach {
    /// Whether the template is the shell and the reference its aim.
    pub fn is_exchanged(self) -> bool {
        matches!(self, Self::Exchanged | Self::GuidedExchanged | Self::SharpenedExchanged)
    }

    pub(super) fn is_guided(self) -> bool {
        matches!(self, Self::Guided | Self::GuidedExchanged)
    }

    /// The settings that it runs with.
    pub(super) fn settings(self, settings: &Settings) -> Settings {
        match self {
            Self::Sharpened(_) | Self::SharpenedExchanged => {
                let rounds = if let Self::Sharpened(rounds) = self { rounds } else { 1 };
                let sharper = SHARPER.powi(i32::from(rounds).min(SHARPEST));
                Settings { penalty: sharper * settings.penalty, thickness: settings.thickness / sharper, ..*settings }
            }
            Self::Direct | Self::Exchanged | Self::Inverted | Self::Guided | Self::GuidedExchanged => *settings,
        }
    }
}

impl fmt::Display for Approach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Direct => "Matching the reference with the template",
            Self::Exchanged => "Matching the other way round: the template with the reference",
            Self::Inverted => "Refining the inverse of the match found the other way round",
            Self::Sharpened(_) => "Sharpening: the template pulls more strongly, most where it was missed",
            Self::Guided => "Matching along corresponding points of both outlines",
            Self::GuidedExchanged => "Matching the other way round, along corresponding points of both outlines",
            Self::SharpenedExchanged => "Sharpening the match found the other way round",
        })
    }
}

/// How good a match is, in cells of the finest level.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit {
    pub approach: Approach,
    mismatch: f64,
    cover: f64,
    measure: f64,
}

impl Fit {
    pub fn of<const D: usize>(approach: Approach, report: &Report<D>) -> Self {
        Self { approach, mismatch: report.mismatch.max, cover: report.cover.max, measure: report.measure }
    }

    /// The least is the best.
    pub fn cost(&self) -> f64 {
        self.mismatch.max(0.5 * self.cover).max(5.0 * (self.measure - 1.0))
    }

    fn is_close(&self) -> bool {
        self.mismatch <= GOOD_MISMATCH && self.cover <= GOOD_COVER
    }

    fn is_good(&self) -> bool {
        self.is_close() && self.measure <= GOOD_MEASURE
    }

    fn is_fine(&self) -> bool {
        self.mismatch <= FINE_MISMATCH && self.cover <= FINE_COVER
    }

    /// What it misses is detail.
    pub fn is_worth_sharpening(&self) -> bool {
        self.measure <= SHARPENED_MEASURE && self.cost() <= SHARPENED_COST
    }

    /// On the level before the finest: what is farther away there is not brought near by one level more.
    pub fn is_hopeless(&self) -> bool {
        self.cost() > HOPELESS_COST
    }

    pub fn is_worth_inverting(&self) -> bool {
        self.mismatch <= INVERTED_MISMATCH && self.cover <= INVERTED_COVER
    }
}

/// The approaches that are left.
pub(super) struct Plan {
    left: VecDeque<Approach>,
    /// What it began with was all.
    single: bool,
    /// Rounds since the last other approach.
    sharpened: u8,
}

impl Plan {
    /// One direct run.
    pub fn single() -> Self {
        Self { left: [Approach::Direct].into(), single: true, sharpened: 0 }
    }

    /// Nothing: the run there is is the last.
    pub fn none() -> Self {
        Self { left: VecDeque::new(), single: true, sharpened: 0 }
    }

    pub fn of<const D: usize>(reference: &SignedDistance<D>, template: &SignedDistance<D>) -> Self {
        let shorter = boundary_measure(template) < SHORTER * boundary_measure(reference);
        let left = if shorter {
            [Approach::Exchanged, Approach::GuidedExchanged, Approach::Direct, Approach::Guided]
        } else {
            [Approach::Direct, Approach::Guided, Approach::Exchanged, Approach::GuidedExchanged]
        };
        Self { left: left.into(), single: false, sharpened: 0 }
    }

    /// Whether the same direction is still to be tried along corresponding points.
    pub fn will_lead(&self, approach: Approach) -> bool {
        let led = match approach {
            Approach::Direct => Approach::Guided,
            Approach::Exchanged => Approach::GuidedExchanged,
            _ => return false,
        };
        self.left.contains(&led)
    }

    pub fn is_single(&self) -> bool {
        self.single
    }

    /// The next approach; none if the best match so far is good, and fine where that is cheap, or nothing is left to try.
    pub fn next(&mut self, best: Option<&Fit>) -> Option<Approach> {
        if let Some(best) = best {
            if best.is_good() {
                let sharpen = self.sharpened == 0 && !best.is_fine();
                self.sharpened += u8::from(sharpen);
                return sharpen.then_some(Approach::Sharpened(self.sharpened));
            }
            // What crumples would crumple more.
            if best.is_worth_sharpening() && self.sharpened < SHARPENINGS {
                self.sharpened += 1;
                return Some(Approach::Sharpened(self.sharpened));
            }
            self.sharpened = 0;
        }
        self.left.pop_front()
    }
}
