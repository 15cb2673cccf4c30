//! One pair.

use super::family::Pair;
use std::fmt;
use std::time::Instant;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::narrow::narrowest;
use thinshell::ready::ready;
use thinshell::report::report;
use thinshell::search::Search;
use thinshell::settings::Settings;
use thinshell::verdict::{self, RESOLVED};

pub struct Outcome {
    name: String,
    /// Of necks and gaps of both shapes, in cells; none below 8 cells.
    narrowest: Option<f64>,
    pub mismatch_max: f64,
    pub cover_max: f64,
    pub measure: f64,
    pub least_determinant: f64,
    pub cost: f64,
    pub millis: f64,
    /// In words.
    pub verdict: String,
}

impl Outcome {
    pub const HEAD: &str = "   max  cover  measure  least det  narrowest  cost      ms";

    pub fn resolvable(&self) -> bool {
        self.narrowest.is_none_or(|cells| cells >= RESOLVED)
    }

    pub fn is_good(&self) -> bool {
        self.mismatch_max <= 0.5 && self.cover_max <= 1.0
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let narrowest = self.narrowest.map_or("–".into(), |cells| format!("{cells:.1}"));
        write!(
            f,
            "{:6.2} {:6.2}  {:7.3}  {:9.1e}  {narrowest:>9} {:5.0} {:7.0}  {}{}",
            self.mismatch_max,
            self.cover_max,
            self.measure,
            self.least_determinant,
            self.cost,
            self.millis,
            self.name,
            if self.resolvable() { "" } else { " (not resolvable)" },
        )
    }
}

pub fn run(pair: &Pair, level: u32) -> Outcome {
    let settings = Settings { finest: level, ..Settings::default() };
    let grid = Grid::of_level(level);
    let cells = grid.cells() as f64;
    let start = Instant::now();
    let distance = |loops| {
        SignedDistance::from_loops(grid, loops).unwrap_or_else(|problem| panic!("{}: a shape {problem}", pair.name))
    };
    let shapes = [&pair.reference, &pair.template].map(|loops| distance(loops));
    let [reference, template] = shapes.clone();
    let mut cascade = ready(Search::new(reference, template, settings)).expect("valid settings");
    let mut cost = 0.0;
    let end = loop {
        let progress = ready(cascade.step());
        cost += 0.25_f64.powi((level - progress.level) as i32);
        if progress.stop.is_some() {
            break progress;
        }
    };
    let millis = start.elapsed().as_secs_f64() * 1e3;

    let quality = report(&shapes[0], &shapes[1], cascade.displacement());
    Outcome {
        name: pair.name.clone(),
        narrowest: [&pair.reference, &pair.template]
            .iter()
            .filter_map(|loops| narrowest(loops, 8.0 / cells))
            .map(|narrowest| narrowest.width * cells)
            .min_by(f64::total_cmp),
        mismatch_max: quality.mismatch.max,
        cover_max: quality.cover.max,
        measure: quality.measure,
        least_determinant: end.evaluation.least_determinant,
        cost,
        millis,
        verdict: verdict::Pair::new(&shapes[0], &shapes[1]).verdict(level, &quality).words,
    }
}
