//! Whether a card is faster than the processor, for grids of one size.

use std::cell::Cell;
use std::fmt;

/// Milliseconds since some moment.
pub type Clock = fn() -> f64;

thread_local! {
    static CLOCK: Cell<Option<Clock>> = const { Cell::new(None) };
}

/// Gives this thread a clock. The solver has none of its own, so that the same input has the same output; without one,
/// where both may compute the processor does.
pub fn set_clock(clock: Clock) {
    CLOCK.set(Some(clock));
}

pub(super) fn clock() -> Option<Clock> {
    CLOCK.get()
}

pub(super) const NO_CLOCK: &str = "without a clock nobody knows whether the graphics card is faster";

/// In browsers a card's answer comes after 5 to 15 ms, whatever was asked, and derivatives are two answers: where the
/// processor takes less than that, there is nothing to try.
const LEAST_MILLIS: f64 = 10.0;
/// A card that is hardly faster is not worth what f32 makes of the last digits.
const SHARE: f64 = 0.8;

/// How long the first derivatives on a grid took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    pub cpu_millis: f64,
    /// None where it was not tried.
    pub gpu_millis: Option<f64>,
}

impl Pace {
    pub(super) fn is_worth_a_trial(&self) -> bool {
        self.cpu_millis >= LEAST_MILLIS
    }

    pub fn is_card_faster(&self) -> bool {
        self.gpu_millis.is_some_and(|millis| millis < SHARE * self.cpu_millis)
    }
}

/// Why the processor computes where the card could. Reads on after "cpu: ".
impl fmt::Display for Pace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.gpu_millis {
            Some(gpu_millis) => write!(
                f,
                "on this grid the graphics card takes {gpu_millis:.0} ms for what takes the processor {:.0} ms",
                self.cpu_millis
            ),
            None => f.write_str("on this grid the processor is done before a graphics card would answer"),
        }
    }
}
