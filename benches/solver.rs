//! Newton against the gradient method, side by side: `cargo bench --bench solver`.
//!
//! Gap: from the 65² solution, the time until the energy at 129² is within 1e-3 of the least either method reaches.
//! End: the energy at which the default stops leave each, over the whole cascade.

#[path = "kernels/mod.rs"]
mod kernels;

use kernels::{GAP, assembler_of, distances, lowest, pairs, start_from_65};
use std::time::Instant;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::minimize::{Minimizer, Ncg, Newton};
use thinshell::ready::ready;
use thinshell::report::{Report, report};
use thinshell::search::Search;
use thinshell::settings::{MinimizerKind, Settings};

const RUNS: usize = 5;

fn main() {
    println!(
        "{:22} {:>10} {:>10} {:>6} {:>6} {:>7}   {:>12} {:>12} {:>10}",
        "to a gap of 1e-3", "newton ms", "ncg ms", "iter.", "iter.", "ratio", "end newton", "end ncg", "difference"
    );
    for (name, pair) in pairs() {
        let shapes = distances(7, &pair);
        let start = start_from_65(&pair);
        let least = lowest(&shapes, &start);
        let mut ratios = Vec::new();
        let (mut newton, mut ncg) = (Vec::new(), Vec::new());
        let mut iterations = [0; 2];
        for _ in 0..RUNS {
            let grid = Grid::of_level(7);
            let (fast, fast_steps) = race(&shapes, least, || Newton::new(grid, start.clone(), 1e-12));
            let (slow, slow_steps) = race(&shapes, least, || Ncg::new(grid, start.clone(), 0.5, 1e-12));
            ratios.push(slow / fast);
            newton.push(fast);
            ncg.push(slow);
            iterations = [fast_steps, slow_steps];
        }
        let ends = [MinimizerKind::Newton, MinimizerKind::Ncg]
            .map(|minimizer| whole(&shapes, Settings { minimizer, ..Settings::default() }).energy);
        println!(
            "{name:22} {:10.1} {:10.1} {:6} {:6} {:7.1}   {:12.6e} {:12.6e} {:+10.1e}",
            median(&mut newton),
            median(&mut ncg),
            iterations[0],
            iterations[1],
            median(&mut ratios),
            ends[0],
            ends[1],
            ends[0] / ends[1] - 1.0
        );
    }

    println!(
        "\n{:22} {:>10} {:>11} {:>11} {:>8} {:>20}",
        "17² → 129²", "ms", "mean cells", "most cells", "det", "deviation/mean"
    );
    for (name, pair) in pairs() {
        let shapes = distances(7, &pair);
        let mut times = Vec::new();
        let mut end = whole(&shapes, Settings::default());
        for _ in 0..RUNS {
            let begin = Instant::now();
            end = whole(&distances(7, &pair), Settings::default());
            times.push(begin.elapsed().as_secs_f64() * 1e3);
        }
        println!(
            "{name:22} {:10.1} {:11.4} {:11.4} {:8.3} {:20.3}",
            median(&mut times),
            end.report.mismatch.mean,
            end.report.mismatch.max,
            end.least_determinant,
            end.report.stretch.deviation / end.report.stretch.mean
        );
    }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Milliseconds and iterations to the gap; everything a minimiser prepares counts.
fn race<M: Minimizer<2>>(shapes: &[SignedDistance<2>; 2], least: f64, make: impl Fn() -> M) -> (f64, usize) {
    let mut assembler = assembler_of(shapes);
    let begin = Instant::now();
    let mut minimizer = make();
    loop {
        let progress = ready(minimizer.step(&mut assembler));
        if progress.evaluation.total() <= least * (1.0 + GAP) || progress.stop.is_some() {
            return (begin.elapsed().as_secs_f64() * 1e3, progress.iterations);
        }
    }
}

struct End {
    energy: f64,
    least_determinant: f64,
    report: Report<2>,
}

fn whole(shapes: &[SignedDistance<2>; 2], settings: Settings) -> End {
    let [reference, template] = shapes.clone();
    let mut cascade = ready(Search::new(reference, template, settings)).expect("valid settings");
    let end = loop {
        let progress = ready(cascade.step());
        if progress.stop.is_some() {
            break progress;
        }
    };
    End {
        energy: end.evaluation.total(),
        least_determinant: end.evaluation.least_determinant,
        report: report(&shapes[0], &shapes[1], cascade.displacement()),
    }
}
