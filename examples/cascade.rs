//! Runs the cascade on a few pairs and prints, level by level, how it went: `cargo run --release --example cascade`.

#[path = "../tests/common/mod.rs"]
mod shapes;

use glam::DVec2;
use std::time::Instant;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::report::report;
use thinshell::search::Search;
use thinshell::settings::Settings;

fn main() {
    let settings = Settings::default();
    let centre = [0.5, 0.5];
    let pairs: [(&str, Vec<DVec2>, Vec<DVec2>); 3] = [
        ("circle → ellipse", shapes::circle(centre, 0.15), shapes::ellipse(centre, 0.45, 0.25)),
        ("star → rotated star", shapes::star(centre, 0.25, 5, 0.25, 0.0), shapes::star(centre, 0.25, 5, 0.25, 0.35)),
        ("leaf → leaf", shapes::leaf(centre, 0.2, 0.12, 0.0), shapes::leaf(centre, 0.2, 0.22, 0.3)),
    ];
    for (name, reference, template) in pairs {
        println!("{name}");
        run(&settings, reference, template);
    }
}

fn run(settings: &Settings, reference: Vec<DVec2>, template: Vec<DVec2>) {
    let start = Instant::now();
    let grid = Grid::of_level(settings.finest);
    let reference = SignedDistance::from_loops(grid, &[reference]).expect("a valid shape");
    let template = SignedDistance::from_loops(grid, &[template]).expect("a valid shape");
    let mut cascade = ready(Search::new(reference, template, *settings)).expect("valid settings");
    println!("  start    {:7.1} ms", start.elapsed().as_secs_f64() * 1e3);
    let mut level_start = Instant::now();
    let mut last = None;
    loop {
        let progress = ready(cascade.step());
        let ended = progress.stop.is_some();
        let next = last.replace(progress);
        if let Some(before) = next.filter(|before| before.level != progress.level || ended) {
            let shown = if ended { progress } else { before };
            let report = report(cascade.reference(), cascade.template(), cascade.displacement());
            println!(
                "  level {} {:7.1} ms  {:4} iterations {:5} evaluations  E {:.6e}  det {:.3}{}",
                shown.level,
                level_start.elapsed().as_secs_f64() * 1e3,
                shown.iteration,
                shown.evaluations,
                shown.evaluation.total(),
                shown.evaluation.least_determinant,
                if ended {
                    format!(
                        "  mismatch {:.3}/{:.3} h  stretch {:.3} ± {:.3}  {}",
                        report.mismatch.mean,
                        report.mismatch.max,
                        report.stretch.mean,
                        report.stretch.deviation,
                        progress.stop.map(|stop| stop.to_string()).unwrap_or_default()
                    )
                } else {
                    String::new()
                }
            );
            level_start = Instant::now();
        }
        if ended {
            println!("  in all   {:7.1} ms", start.elapsed().as_secs_f64() * 1e3);
            return;
        }
    }
}
