//! One pair.

use super::family::Pair;
use glam::DVec2;
use std::fmt;
use std::time::Instant;
use thinshell::cascade::Cascade;
use thinshell::contour::zero_set;
use thinshell::distance::SignedDistance;
use thinshell::field::interpolate;
use thinshell::grid::Grid;
use thinshell::narrow::narrowest;
use thinshell::ready::ready;
use thinshell::report::report;
use thinshell::settings::Settings;

/// Narrower necks and gaps, in cells, a grid cannot tell from none.
const RESOLVED: f64 = 2.0;

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
    let mut cascade = ready(Cascade::new(reference, template, settings)).expect("valid settings");
    let mut cost = 0.0;
    let end = loop {
        let progress = ready(cascade.step());
        cost += 0.25_f64.powi((level - progress.level) as i32);
        if progress.stop.is_some() {
            break progress;
        }
    };
    let millis = start.elapsed().as_secs_f64() * 1e3;

    let curves = shapes.each_ref().map(|shape| zero_set(grid, shape.values()));
    let moved = |x: DVec2| x + DVec2::from(interpolate::<2, 2>(grid, cascade.displacement(), &x.to_array()));
    let matched: Vec<Vec<DVec2>> = curves[0].iter().map(|points| points.iter().map(|&x| moved(x)).collect()).collect();
    let quality = report(grid, &curves[0], shapes[1].values(), cascade.displacement());
    Outcome {
        name: pair.name.clone(),
        narrowest: [&pair.reference, &pair.template]
            .iter()
            .filter_map(|loops| narrowest(loops, 8.0 / cells))
            .map(|narrowest| narrowest.width * cells)
            .min_by(f64::total_cmp),
        mismatch_max: quality.mismatch_max,
        cover_max: cover(&pair.template, &matched) * cells,
        measure: length(&matched) / length(&curves[1]),
        least_determinant: end.evaluation.least_determinant,
        cost,
        millis,
    }
}

fn segments(loops: &[Vec<DVec2>]) -> impl Iterator<Item = [DVec2; 2]> {
    loops.iter().flat_map(|points| (0..points.len()).map(|k| [points[k], points[(k + 1) % points.len()]]))
}

fn length(loops: &[Vec<DVec2>]) -> f64 {
    segments(loops).map(|[a, b]| a.distance(b)).sum()
}

/// The greatest distance of the template's vertices and middles to the matched curve.
fn cover(template: &[Vec<DVec2>], matched: &[Vec<DVec2>]) -> f64 {
    let to_matched = |point: DVec2| {
        segments(matched)
            .map(|[a, b]| {
                let along = b - a;
                let t = ((point - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
                point.distance(a + t * along)
            })
            .min_by(f64::total_cmp)
            .unwrap_or(f64::INFINITY)
    };
    segments(template)
        .flat_map(|[a, b]| [a, 0.5 * (a + b)])
        .map(to_matched)
        .max_by(f64::total_cmp)
        .unwrap_or(f64::INFINITY)
}
