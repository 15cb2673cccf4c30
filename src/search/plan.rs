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
/// A good match is sharpened, in a few rounds at most, until it is as close as this.
const FINE_MISMATCH: f64 = 0.25;
const FINE_COVER: f64 = 0.5;
const FINE_SHARPENINGS: u8 = 3;
/// A round beyond the second is for a match of which the one before left at most this share of the cost.
const RAPID: f64 = 0.75;
/// In cells of the level that has ended.
const HOPELESS_COST: f64 = 2.0;
/// An exchanged match is worth inverting if it is as close as this: errors of φ⁻¹ are stretched by φ.
const INVERTED_MISMATCH: f64 = 1.0;
const INVERTED_COVER: f64 = 2.0;
/// The first round of sharpening takes the thickness and the penalty of a grid with so much finer a spacing, each one
/// after it of `SHARPER` times that, up to `SHARPEST`.
const SHARP: f64 = 32.0;
const SHARPER: f64 = 2.0;
const SHARPEST: f64 = 512.0;
const SHARPENINGS: u8 = 6;
/// Rounds beyond these, up to so many, as long as each leaves at most this share of the cost.
const MOST_SHARPENINGS: u8 = 16;
const STEADY: f64 = 0.9;
/// And up to so many for a match that costs no more than this, when a good one costs half a cell.
const NEAR_SHARPENINGS: u8 = 12;
const NEAR_COST: f64 = 0.75;
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
    /// Both again, by the outlines as they were drawn instead of the grid's: where one assignment leads astray, another may
    /// not.
    GuidedAsDrawn,
    GuidedExchangedAsDrawn,
}

impl Approach {
    /// Whether the template is the shell and the reference its aim.
    pub fn is_exchanged(self) -> bool {
        matches!(
            self,
            Self::Exchanged | Self::GuidedExchanged | Self::GuidedExchangedAsDrawn | Self::SharpenedExchanged
        )
    }

    pub(super) fn is_guided(self) -> bool {
        matches!(self, Self::Guided | Self::GuidedExchanged) || self.is_as_drawn()
    }

    pub(super) fn is_as_drawn(self) -> bool {
        matches!(self, Self::GuidedAsDrawn | Self::GuidedExchangedAsDrawn)
    }

    /// Its number, for those who say it in another language.
    pub fn fact(self) -> f64 {
        f64::from(match self {
            Self::Direct => 0_u8,
            Self::Exchanged => 1,
            Self::Inverted => 2,
            Self::Sharpened(_) => 3,
            Self::SharpenedExchanged => 4,
            Self::Guided | Self::GuidedAsDrawn => 5,
            Self::GuidedExchanged | Self::GuidedExchangedAsDrawn => 6,
        })
    }

    /// The settings that it runs with.
    pub(super) fn settings(self, settings: &Settings) -> Settings {
        match self {
            Self::Sharpened(_) | Self::SharpenedExchanged => {
                let round = if let Self::Sharpened(round) = self { round } else { 1 };
                let finer = (SHARP * SHARPER.powi(i32::from(round) - 1)).min(SHARPEST);
                Settings { penalty: finer * settings.penalty, thickness: settings.thickness / finer, ..*settings }
            }
            _ => *settings,
        }
    }
}

impl fmt::Display for Approach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Direct => "Matching the reference with the target",
            Self::Exchanged => "Matching the other way round: the target with the reference",
            Self::Inverted => "Refining the inverse of the match found the other way round",
            Self::Sharpened(_) => "Sharpening: the target pulls more strongly, most where it was missed",
            Self::Guided | Self::GuidedAsDrawn => "Matching along corresponding points of both outlines",
            Self::GuidedExchanged | Self::GuidedExchangedAsDrawn => {
                "Matching the other way round, along corresponding points of both outlines"
            }
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

    pub fn is_fine(&self) -> bool {
        self.mismatch <= FINE_MISMATCH && self.cover <= FINE_COVER
    }

    /// What it misses is detail.
    pub fn is_worth_sharpening(&self) -> bool {
        self.measure <= SHARPENED_MEASURE && self.cost() <= SHARPENED_COST
    }

    /// On a level before the finest: what is farther away there is not brought near by finer ones.
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
    /// What the result before the last round cost.
    before: f64,
}

impl Plan {
    /// One direct run.
    pub fn single() -> Self {
        Self { left: [Approach::Direct].into(), single: true, sharpened: 0, before: f64::INFINITY }
    }

    /// Nothing: the run there is is the last.
    pub fn none() -> Self {
        Self { left: VecDeque::new(), single: true, sharpened: 0, before: f64::INFINITY }
    }

    pub fn of<const D: usize>(reference: &SignedDistance<D>, template: &SignedDistance<D>) -> Self {
        let shorter = boundary_measure(template) < SHORTER * boundary_measure(reference);
        let direct = [Approach::Direct, Approach::Guided];
        let exchanged = [Approach::Exchanged, Approach::GuidedExchanged];
        let last = [Approach::GuidedAsDrawn, Approach::GuidedExchangedAsDrawn];
        let left = if shorter { [exchanged, direct, last] } else { [direct, exchanged, last] };
        Self { left: left.into_iter().flatten().collect(), single: false, sharpened: 0, before: f64::INFINITY }
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

    /// The next approach, after the last run's result and the best so far; none if that is good, and fine or no longer
    /// worth sharpening, or nothing is left to try.
    pub fn next(&mut self, last: Option<&Fit>, best: Option<&Fit>) -> Option<Approach> {
        let good = best.filter(|best| best.is_good());
        let sharpen = match (good, last) {
            (Some(best), last) => {
                let rapid = last.is_some_and(|last| last.cost() <= RAPID * self.before);
                !best.is_fine() && (self.sharpened < 2 || rapid && self.sharpened < FINE_SHARPENINGS)
            }
            // What crumples would crumple more.
            (None, Some(last)) => {
                let steady = last.cost() <= STEADY * self.before;
                let most = match last.cost() {
                    _ if steady => MOST_SHARPENINGS,
                    cost if cost <= NEAR_COST => NEAR_SHARPENINGS,
                    _ => SHARPENINGS,
                };
                last.is_worth_sharpening() && self.sharpened < most
            }
            (None, None) => false,
        };
        self.before = last.map_or(f64::INFINITY, Fit::cost);
        if sharpen {
            self.sharpened += 1;
            return Some(Approach::Sharpened(self.sharpened));
        }
        self.sharpened = 0;
        if good.is_some() { None } else { self.left.pop_front() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FINE: Fit = Fit { approach: Approach::Direct, mismatch: 0.1, cover: 0.1, measure: 1.0 };
    const GOOD: Fit = Fit { mismatch: 0.4, ..FINE };
    const BLUNT: Fit = Fit { cover: 3.0, ..GOOD };
    const CRUMPLED: Fit = Fit { measure: 1.5, ..BLUNT };

    fn plan() -> Plan {
        Plan {
            left: [Approach::Guided, Approach::Exchanged].into(),
            single: false,
            sharpened: 0,
            before: f64::INFINITY,
        }
    }

    #[test]
    fn a_fine_match_ends_the_search() {
        assert_eq!(plan().next(Some(&FINE), Some(&FINE)), None);
    }

    #[test]
    fn a_good_match_is_sharpened_twice_and_a_third_time_if_that_brought_it_much_nearer() {
        for (nearer, third) in [(0.45, None), (0.3, Some(Approach::Sharpened(3)))] {
            let mut plan = plan();
            let fits = [0.5, 0.45, nearer].map(|mismatch| Fit { mismatch, ..GOOD });
            let rounds = fits.map(|fit| plan.next(Some(&fit), Some(&fit)));
            assert_eq!(rounds, [Some(Approach::Sharpened(1)), Some(Approach::Sharpened(2)), third]);
            if third.is_some() {
                assert_eq!(plan.next(Some(&Fit { mismatch: 0.26, ..GOOD }), Some(&GOOD)), None, "no fourth");
            }
        }
    }

    #[test]
    fn sharpening_goes_on_as_long_as_each_round_brings_the_match_nearer() {
        let mut plan = plan();
        let mut cost = 5.0;
        let mut round = |plan: &mut Plan, share: f64| {
            cost *= share;
            let fit = Fit { mismatch: cost, ..FINE };
            plan.next(Some(&fit), Some(&fit))
        };
        for number in 1..=SHARPENINGS + 2 {
            assert_eq!(round(&mut plan, 0.85), Some(Approach::Sharpened(number)));
        }
        assert_eq!(round(&mut plan, 0.95), Some(Approach::Guided), "too slow to be worth more");
    }

    #[test]
    fn what_misses_detail_is_sharpened_before_something_else_is_tried() {
        let mut plan = plan();
        for round in 1..=SHARPENINGS {
            assert_eq!(plan.next(Some(&BLUNT), Some(&BLUNT)), Some(Approach::Sharpened(round)));
        }
        assert_eq!(plan.next(Some(&BLUNT), Some(&BLUNT)), Some(Approach::Guided));
        assert_eq!(plan.next(Some(&BLUNT), Some(&BLUNT)), Some(Approach::Sharpened(1)), "another run's result");
    }

    #[test]
    fn what_is_nearly_good_is_sharpened_for_longer() {
        let near = Fit { mismatch: NEAR_COST, ..FINE };
        let mut plan = plan();
        for round in 1..=NEAR_SHARPENINGS {
            assert_eq!(plan.next(Some(&near), Some(&near)), Some(Approach::Sharpened(round)));
        }
        assert_eq!(plan.next(Some(&near), Some(&near)), Some(Approach::Guided));
    }

    #[test]
    fn what_crumples_is_not_sharpened_even_if_an_earlier_result_was_better() {
        assert_eq!(plan().next(Some(&CRUMPLED), Some(&BLUNT)), Some(Approach::Guided));
    }

    #[test]
    fn each_round_of_sharpening_takes_twice_the_penalty_of_the_one_before_up_to_a_limit() {
        let settings = Settings::default();
        let penalty = |round| Approach::Sharpened(round).settings(&settings).penalty / settings.penalty;
        assert_eq!([1, 2, 3, 4, 5, 6].map(penalty), [32.0, 64.0, 128.0, 256.0, 512.0, 512.0]);
    }
}
