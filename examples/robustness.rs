//! Registers seeded random pairs of blobs and stars, turned, scaled and shifted, with default settings, and counts the
//! matches: `cargo run --release --example robustness [pairs] [finest level]`.

#[path = "../tests/common/mod.rs"]
mod common;

use common::{Random, random_pair};
use std::time::Instant;
use thinshell::cascade::Cascade;
use thinshell::contour::zero_set;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::report::report;
use thinshell::settings::Settings;

fn main() {
    let mut numbers = std::env::args().skip(1).map(|a| a.parse::<u64>().expect("a whole number"));
    let (pairs, finest) = (numbers.next().unwrap_or(500), numbers.next().unwrap_or(7) as u32);
    let settings = Settings { finest, ..Settings::default() };
    let (mut within, mut folded, mut times) = (0, 0, Vec::new());
    for seed in 0..pairs {
        let [reference, template] =
            random_pair(&mut Random(seed)).map(|curve| SignedDistance::from_loops(Grid::of_level(finest), &[curve]));
        let start = Instant::now();
        let cascade = Cascade::new(reference.expect("a valid shape"), template.expect("a valid shape"), settings);
        let mut cascade = ready(cascade).expect("valid settings");
        let (mut iterations, mut level) = (Vec::new(), 0);
        let end = loop {
            let progress = ready(cascade.step());
            if progress.level != level {
                level = progress.level;
                iterations.push(0);
            }
            *iterations.last_mut().expect("pushed above") = progress.iteration;
            if progress.stop.is_some() {
                break progress;
            }
        };
        let time = start.elapsed().as_secs_f64() * 1e3;
        times.push(time);
        let curve = zero_set(cascade.grid(), cascade.reference().values());
        let report = report(cascade.grid(), &curve, cascade.template().values(), cascade.displacement());
        folded += usize::from(end.evaluation.least_determinant <= 0.0);
        if report.mismatch_max <= 0.5 {
            within += 1;
        } else {
            println!(
                "seed {seed}: mismatch {:.2}/{:.2} h, det {:.2e}, stretch {:.2} ± {:.2}, iterations {iterations:?}, {time:.0} ms",
                report.mismatch_mean,
                report.mismatch_max,
                end.evaluation.least_determinant,
                report.stretch_mean,
                report.stretch_deviation,
            );
        }
    }
    times.sort_by(f64::total_cmp);
    println!(
        "{within} of {pairs} within 0.5 cells at level {finest}, {folded} folded, median {:.0} ms, worst {:.0} ms",
        times[times.len() / 2],
        times[times.len() - 1]
    );
}
