//! A step length that satisfies the strong Wolfe conditions.

/// Sufficient decrease and curvature: E(τ) ≤ E(0) + c₁ τ E′(0) and |E′(τ)| ≤ c₂ |E′(0)|.
///
/// c₂ = 0.1 because Fletcher–Reeves needs a nearly exact search.
/// Source: Nocedal, Wright, "Numerical Optimization", algorithms 3.5 and 3.6.
const DECREASE: f64 = 1e-4;
const CURVATURE: f64 = 0.1;

/// Trials before the search takes the best point it has seen.
const MAX_TRIALS: usize = 25;

/// The energy along the direction: step length, value, derivative. An infinite value means the step folds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trial {
    pub step: f64,
    pub value: f64,
    pub slope: f64,
}

/// The search as an object that asks for trials, so that it does not need to know how they are evaluated.
pub(super) struct StrongWolfe {
    start: Trial,
    /// The best point with sufficient decrease; the interval runs from here.
    low: Trial,
    high: Option<Trial>,
    trials: usize,
}

pub(super) enum Next {
    /// Evaluate at this step length.
    Try(f64),
    /// Go this far.
    Accept(f64),
    /// Nothing lowers the energy.
    Fail,
}

impl StrongWolfe {
    /// `value` and `slope` at step 0; the slope is negative.
    pub fn new(value: f64, slope: f64) -> Self {
        let start = Trial { step: 0.0, value, slope };
        Self { start, low: start, high: None, trials: 0 }
    }

    /// Takes the trial last asked for and says what to do next.
    pub fn next(&mut self, trial: Trial) -> Next {
        self.trials += 1;
        let enough = self.start.value + DECREASE * trial.step * self.start.slope;
        // The negation also catches a value that is not a number.
        if !(trial.value <= enough && (trial.value < self.low.value || self.low.step == 0.0)) {
            self.high = Some(trial);
        } else if trial.slope.abs() <= -CURVATURE * self.start.slope {
            return Next::Accept(trial.step);
        } else {
            let towards_high = trial.slope * self.high.map_or(1.0, |high| high.step - self.low.step);
            if towards_high >= 0.0 {
                self.high = Some(self.low);
            }
            self.low = trial;
        }
        if self.trials >= MAX_TRIALS {
            return if self.low.step > 0.0 { Next::Accept(self.low.step) } else { Next::Fail };
        }
        match self.high {
            None => Next::Try(2.0 * self.low.step),
            Some(high) => {
                let width = (high.step - self.low.step).abs();
                if width <= 1e-14 * self.low.step.max(f64::MIN_POSITIVE) {
                    return if self.low.step > 0.0 { Next::Accept(self.low.step) } else { Next::Fail };
                }
                Next::Try(between(self.low, high))
            }
        }
    }
}

/// The minimiser of the cubic through both trials, kept away from the ends; the middle where there is no cubic.
fn between(a: Trial, b: Trial) -> f64 {
    let middle = 0.5 * (a.step + b.step);
    if !(b.value.is_finite() && b.slope.is_finite()) {
        return middle;
    }
    let width = b.step - a.step;
    let d1 = a.slope + b.slope - 3.0 * (b.value - a.value) / width;
    let square = d1 * d1 - a.slope * b.slope;
    if square < 0.0 {
        return middle;
    }
    let d2 = square.sqrt() * width.signum();
    let step = b.step - width * (b.slope + d2 - d1) / (b.slope - a.slope + 2.0 * d2);
    let (low, high) = (a.step.min(b.step), a.step.max(b.step));
    let margin = 0.1 * (high - low);
    if step.is_finite() { step.max(low + margin).min(high - margin) } else { middle }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn search(f: impl Fn(f64) -> (f64, f64), first: f64) -> Option<f64> {
        let (value, slope) = f(0.0);
        let mut wolfe = StrongWolfe::new(value, slope);
        let mut step = first;
        loop {
            let (value, slope) = f(step);
            match wolfe.next(Trial { step, value, slope }) {
                Next::Try(next) => step = next,
                Next::Accept(step) => return Some(step),
                Next::Fail => return None,
            }
        }
    }

    #[test]
    fn a_parabola_is_minimised_from_far_too_short_and_far_too_long_steps() {
        for first in [1e-6, 0.3, 1.0, 50.0, 1e6] {
            let step = search(|t| ((t - 1.0) * (t - 1.0), 2.0 * (t - 1.0)), first).unwrap();
            assert!((step - 1.0).abs() <= CURVATURE, "from {first}: {step}");
        }
    }

    #[test]
    fn a_wall_of_infinity_is_backed_away_from() {
        let f = |t: f64| if t >= 0.7 { (f64::INFINITY, f64::NAN) } else { (-t, -1.0) };
        let step = search(f, 8.0).unwrap();
        assert!(step < 0.7 && step > 0.6, "{step}");
    }

    #[test]
    fn an_ascent_direction_in_disguise_fails() {
        assert!(search(|t| (t, if t == 0.0 { -1.0 } else { 1.0 }), 1.0).is_none());
    }
}
