//! Which approaches the search takes, and what each is for.

mod common;

use common::{circle, ellipse, polar, star};
use glam::DVec2;
use std::f64::consts::TAU;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::report::{Report, report};
use thinshell::search::{Approach, Search};
use thinshell::settings::{Alignment, MinimizerKind, Settings};

const CENTRE: [f64; 2] = [0.5, 0.5];

struct Outcome {
    /// In their order.
    approaches: Vec<Approach>,
    /// Those that took iterations on the finest level, with the most that one run took.
    refined: Vec<(Approach, usize)>,
    report: Report<2>,
    least_determinant: f64,
}

fn run(settings: Settings, reference: &[Vec<DVec2>], template: &[Vec<DVec2>]) -> Outcome {
    let grid = Grid::of_level(settings.finest);
    let [from, to] = [reference, template].map(|loops| SignedDistance::from_loops(grid, loops).expect("a valid shape"));
    let mut search = ready(Search::new(from.clone(), to.clone(), settings)).expect("valid settings");
    let mut approaches = vec![search.progress().approach];
    let mut refined: Vec<(Approach, usize)> = Vec::new();
    loop {
        let progress = ready(search.step());
        if progress.level == settings.finest && progress.iteration > 0 {
            match refined.iter_mut().find(|(approach, _)| *approach == progress.approach) {
                Some((_, most)) => *most = progress.iteration.max(*most),
                None => refined.push((progress.approach, progress.iteration)),
            }
        }
        if progress.stop.is_some() {
            let report = report(&from, &to, search.displacement());
            return Outcome { approaches, refined, report, least_determinant: progress.evaluation.least_determinant };
        }
        if *approaches.last().expect("begun above") != progress.approach {
            approaches.push(progress.approach);
        }
    }
}

fn finest(finest: u32) -> Settings {
    Settings { finest, ..Settings::default() }
}

fn is_good(outcome: &Outcome) -> bool {
    let Report { mismatch, cover, measure, .. } = outcome.report;
    outcome.least_determinant > 0.0 && mismatch.max <= 0.5 && cover.max <= 1.0 && measure <= 1.1
}

#[test]
fn an_easy_pair_takes_one_run() {
    let outcome = run(finest(6), &[circle(CENTRE, 0.15)], &[ellipse(CENTRE, 0.3, 0.2)]);
    assert_eq!(outcome.approaches, [Approach::Direct]);
    assert!(is_good(&outcome), "{:?}", outcome.report);
    assert!((outcome.report.measure - 1.0).abs() < 0.005, "{}", outcome.report.measure);
}

#[test]
fn a_much_shorter_template_is_matched_the_other_way_round_and_inverted() {
    let outcome = run(finest(6), &[circle(CENTRE, 0.3)], &[circle(CENTRE, 0.15)]);
    assert_eq!(outcome.approaches, [Approach::Exchanged, Approach::Inverted]);
    assert!(is_good(&outcome), "{:?}", outcome.report);
    assert!(outcome.report.measure < 1.03, "{}", outcome.report.measure);
}

#[test]
fn shrinking_by_any_ratio_of_fig_5_keeps_the_length() {
    for ratio in [1.2, 1.5, 2.0, 2.5] {
        let outcome = run(finest(5), &[circle(CENTRE, 0.3)], &[circle(CENTRE, 0.3 / ratio)]);
        assert!(outcome.report.measure <= 1.03, "ratio {ratio}: {}", outcome.report.measure);
    }
}

/// A disc with a gap from the right to its middle, as wide as `width`.
fn gap_disc(width: f64) -> Vec<DVec2> {
    let half = 0.5 * width;
    let opening = (half / 0.25_f64).asin();
    let count = 200;
    let mut points: Vec<DVec2> = (0..=count)
        .map(|k| {
            let angle = opening + (TAU - 2.0 * opening) * f64::from(k) / f64::from(count);
            DVec2::from(CENTRE) + 0.25 * DVec2::from_angle(angle)
        })
        .collect();
    points.extend([DVec2::new(0.5, 0.5 - half), DVec2::new(0.5, 0.5 + half)]);
    points
}

#[test]
fn a_deep_gap_is_entered_along_corresponding_points() {
    let outcome = run(finest(7), &[circle(CENTRE, 0.25)], &[gap_disc(0.1)]);
    assert_eq!(outcome.approaches[..2], [Approach::Direct, Approach::Guided]);
    assert_eq!(outcome.refined[0].0, Approach::Guided, "the finest level is not wasted on a shell that stays out");
    assert!(outcome.report.cover.max < 2.0, "{:?}", outcome.report);
    assert!(outcome.least_determinant > 0.0);
}

#[test]
fn a_gap_closes_by_the_inverse_of_its_opening() {
    // Where the gap was, φ⁻¹ varies within a cell: its nodal interpolant has to be unfolded.
    let outcome = run(finest(7), &[gap_disc(0.1)], &[circle(CENTRE, 0.25)]);
    assert!(outcome.approaches.contains(&Approach::Inverted), "{:?}", outcome.approaches);
    assert!(is_good(&outcome), "{:?} {:?}", outcome.report, outcome.approaches);
}

#[test]
fn sharp_tips_are_reached() {
    // Each point of a shell that rounds a tip off is near the template; the tip is not near the shell.
    let tips: Vec<DVec2> =
        (0..10).map(|k| DVec2::from(CENTRE) + [0.4, 0.12][k % 2] * DVec2::from_angle(TAU * k as f64 / 10.0)).collect();
    let outcome = run(finest(6), &[circle(CENTRE, 0.2)], &[tips]);
    assert!(outcome.approaches.contains(&Approach::Sharpened(1)), "{:?}", outcome.approaches);
    assert!(is_good(&outcome), "{:?} {:?}", outcome.report, outcome.approaches);
}

#[test]
fn details_are_sharpened() {
    // A gear's corners are more than half a cell away from what the energies' balance gives.
    let gear = polar(CENTRE, 0.0, 2048, |theta| if (14.0 * theta).cos() > 0.0 { 0.27 } else { 0.21 });
    let outcome = run(finest(6), &[circle(CENTRE, 0.24)], &[gear]);
    let rounds = (1..outcome.approaches.len() as u8).map(Approach::Sharpened);
    assert_eq!(outcome.approaches, [Approach::Direct].into_iter().chain(rounds).collect::<Vec<_>>());
    assert!(outcome.approaches.len() > 1, "{:?}", outcome.approaches);
    assert!(is_good(&outcome), "{:?}", outcome.report);
}

#[test]
fn a_round_of_sharpening_ends_when_nothing_is_left_to_sharpen() {
    for (depth, iterations) in [(0.25, 4), (0.3, 8)] {
        let outcome = run(finest(6), &[circle(CENTRE, 0.24)], &[star(CENTRE, 0.24, 8, depth, 0.1)]);
        assert_eq!(outcome.refined.last(), Some(&(Approach::Sharpened(1), iterations)), "depth {depth}");
        let Report { mismatch, cover, .. } = outcome.report;
        assert!(mismatch.max <= 0.25 && cover.max <= 0.5, "depth {depth}: {mismatch:?} {cover:?}");
    }
}

#[test]
fn the_paper_s_start_is_a_single_run() {
    let settings = Settings { alignment: Alignment::None, ..finest(5) };
    let outcome = run(settings, &[circle(CENTRE, 0.3)], &[circle(CENTRE, 0.12)]);
    assert_eq!(outcome.approaches, [Approach::Direct]);
}

#[test]
fn the_gradient_method_takes_no_newton_step() {
    /// Iterations that the gradient method looks back over before it ends; Newton's method has ended a level by then.
    const WINDOW: usize = 10;
    let stars = [0.0, 0.3].map(|turn| [star(CENTRE, 0.2, 5, 0.2, turn)]);
    let grid = Grid::of_level(5);
    let [from, to] = stars.each_ref().map(|star| SignedDistance::from_loops(grid, star).expect("a valid shape"));
    // The iterations of each level, and what the starts cost before.
    let work = |minimizer| {
        let settings = Settings { minimizer, ..finest(5) };
        let mut search = ready(Search::new(from.clone(), to.clone(), settings)).expect("valid settings");
        let (mut levels, mut starts) = (Vec::new(), None);
        loop {
            let progress = ready(search.step());
            starts.get_or_insert(progress.evaluations);
            if progress.iteration == 1 {
                levels.push(0);
            }
            *levels.last_mut().expect("begun above") = progress.iteration;
            if progress.stop.is_some() {
                return (levels, starts.expect("a step was done"));
            }
        }
    };
    let ((newton, newton_starts), (gradient, gradient_starts)) =
        (work(MinimizerKind::Newton), work(MinimizerKind::Ncg));
    assert!(newton.iter().all(|&iterations| iterations < WINDOW), "{newton:?}");
    assert!(gradient.len() >= 2 && gradient.iter().all(|&iterations| iterations > WINDOW), "{gradient:?}");
    assert!(gradient_starts > 4 * newton_starts, "{gradient_starts} {newton_starts}");
    let outcome = run(Settings { minimizer: MinimizerKind::Ncg, ..finest(5) }, &stars[0], &stars[1]);
    assert!(is_good(&outcome), "{:?}", outcome.report);
}

#[test]
fn a_circle_is_not_turned_without_gain() {
    let grid = Grid::of_level(6);
    let of = |curve| SignedDistance::from_loops(grid, &[curve]).expect("a valid curve");
    for template in [ellipse(CENTRE, 0.3, 0.2), ellipse(CENTRE, 0.2, 0.3), ellipse(CENTRE, 0.25, 0.22)] {
        let mut search = ready(Search::new(of(circle(CENTRE, 0.2)), of(template), finest(6))).expect("valid settings");
        while ready(search.step()).stop.is_none() {}
        let turned = (0..64).map(|k| {
            let x = DVec2::from(CENTRE) + 0.2 * DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 64.0);
            let u = thinshell::field::interpolate::<2, 2>(search.grid(), search.displacement(), &x.to_array());
            (x - DVec2::from(CENTRE)).angle_to(x + DVec2::from(u) - DVec2::from(CENTRE)).abs()
        });
        let most = turned.fold(0.0, f64::max).to_degrees();
        assert!(most < 45.0, "turned by {most} degrees");
    }
}
