//! Made pairs of which parts cannot be reached: the reference comes to lie on the template and yet does not fit.

mod common;

use common::circle;
use glam::DVec2;
use std::slice::from_ref;
use thinshell::distance::SignedDistance;
use thinshell::field::interpolate;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::report::report;
use thinshell::search::Search;
use thinshell::settings::Settings;
use thinshell::verdict::Pair;

const LEVEL: u32 = 6;
const CENTRE: [f64; 2] = [0.5, 0.5];

fn polygon(corners: &[[f64; 2]]) -> Vec<DVec2> {
    corners.iter().map(|&corner| DVec2::from(corner)).collect()
}

/// A match with default settings.
struct Match {
    reference: SignedDistance<2>,
    template: SignedDistance<2>,
    displacement: Vec<f64>,
}

impl Match {
    fn of(reference: &[Vec<DVec2>], template: &[Vec<DVec2>]) -> Self {
        let [reference, template] = [reference, template]
            .map(|loops| SignedDistance::from_loops(Grid::of_level(LEVEL), loops).expect("a valid shape"));
        let settings = Settings { finest: LEVEL, ..Settings::default() };
        let mut search = ready(Search::new(reference.clone(), template.clone(), settings)).expect("valid settings");
        while ready(search.step()).stop.is_none() {}
        Self { reference, template, displacement: search.displacement().to_vec() }
    }

    fn verdict(&self) -> String {
        let report = report(&self.reference, &self.template, &self.displacement);
        Pair::new(&self.reference, &self.template).verdict(LEVEL, &report).words
    }
}

fn verdict(reference: &[Vec<DVec2>], template: &[Vec<DVec2>]) -> String {
    Match::of(reference, template).verdict()
}

fn assert_no_fit(name: &str, words: &str) {
    assert!(!words.starts_with("Fits:"), "{name}: {words}");
}

#[test]
fn a_disc_fits_an_ellipse() {
    let words = verdict(&[circle(CENTRE, 0.2)], &[common::ellipse(CENTRE, 0.3, 0.2)]);
    assert!(words.starts_with("Fits: "), "{words}");
}

#[test]
fn a_circle_does_not_fit_a_ring() {
    let words = verdict(&[circle(CENTRE, 0.25)], &[circle(CENTRE, 0.3), circle(CENTRE, 0.15)]);
    assert_no_fit("circle → ring", &words);
    assert!(words.contains("hole"), "{words}");
}

#[test]
fn two_discs_do_not_fit_three() {
    let discs = [[0.25, 0.5], [0.5, 0.5], [0.75, 0.5]].map(|centre| circle(centre, 0.08));
    let words = verdict(&discs[..2], &discs);
    assert_no_fit("two discs → three", &words);
    assert!(words.starts_with("Two parts against three parts"), "{words}");
}

#[test]
fn a_disc_does_not_fit_a_disc_with_specks() {
    let disc = circle(CENTRE, 0.2);
    let [one, other] = [[0.15, 0.2], [0.85, 0.75]].map(|centre| circle(centre, 0.02));
    let words = verdict(from_ref(&disc), &[disc.clone(), one, other]);
    assert_no_fit("disc → disc with specks", &words);
    assert!(words.starts_with("One part against three parts"), "{words}");
}

#[test]
fn a_disc_fits_a_disc_with_a_thin_spike_only_if_it_reaches_the_tip() {
    let (disc, tip) = (circle(CENTRE, 0.2), DVec2::new(0.9, 0.5));
    // The first point lies on the right: two of 256 make way for a spike a third of a cell wide.
    let spiked: Vec<DVec2> = disc[1..].iter().copied().chain([tip]).collect();
    let matched = Match::of(&[disc], &[spiked]);
    let words = matched.verdict();
    let image = |angle: f64| {
        let x = DVec2::from(CENTRE) + 0.2 * DVec2::from_angle(angle);
        x + DVec2::from(interpolate::<2, 2>(matched.reference.grid(), &matched.displacement, &x.to_array()))
    };
    let away = (0..100_000).map(|k| image(1e-4 * f64::from(k)).distance(tip)).fold(f64::INFINITY, f64::min);
    let cells = away * matched.reference.grid().cells() as f64;
    assert_eq!(words.starts_with("Fits:"), cells <= 1.0, "{cells} cells from the tip: {words}");
}

#[test]
fn a_square_does_not_fit_a_square_with_a_thin_slit() {
    let square = polygon(&[[0.3, 0.3], [0.7, 0.3], [0.7, 0.7], [0.3, 0.7]]);
    let half = 0.002;
    let mut slit = square.clone();
    slit.splice(2..2, polygon(&[[0.7, 0.5 - half], [0.4, 0.5 - half], [0.4, 0.5 + half], [0.7, 0.5 + half]]));
    assert_no_fit("square → slit square", &verdict(&[square], &[slit]));
}

#[test]
fn overlapping_circles_do_not_fit_a_ring() {
    let overlapping = [circle([0.42, 0.5], 0.2), circle([0.58, 0.5], 0.2)];
    let words = verdict(&overlapping, &[circle(CENTRE, 0.3), circle(CENTRE, 0.12)]);
    assert_no_fit("overlapping circles → ring", &words);
}
