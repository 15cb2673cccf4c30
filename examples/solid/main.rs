//! Families of surfaces, and pairs of meshes whose correspondence is known:
//!
//! `cargo run --release --example solid -- [pairs] [finest level]` registers random bumpy spheres with turned and changed
//! copies of themselves; `cargo run --release --example solid -- one.ply other.ply [finest level]` registers meshes of the
//! same numbering and tells how far each vertex ends from its namesake. Seconds are processor time.

#[path = "../../tests/common/clock.rs"]
mod clock;
#[path = "../../tests/common/mod.rs"]
mod common;
mod ply;
#[path = "../../tests/common/solids.rs"]
mod solids;
mod turn;

use clock::seconds;
use common::Random;
use glam::{DQuat, DVec3};
use solids::{Bumpy, solid};
use thinshell::distance::SignedDistance;
use thinshell::field::interpolate;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::report::{Report, report};
use thinshell::search::Search;
use thinshell::settings::Settings;
use turn::mean_turn;

/// Largest angle by which a copy is turned.
const TURN_DEGREES: f64 = 40.0;
/// … and by which the angle found may be off to be right.
const RIGHT_DEGREES: f64 = 15.0;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if words.len() >= 2 && words[0].ends_with(".ply") {
        let finest = words.get(2).and_then(|word| word.parse().ok()).unwrap_or(5);
        known_correspondence(&words[0], &words[1], finest);
    } else {
        let number = |place: usize, usual: u32| words.get(place).and_then(|word| word.parse().ok()).unwrap_or(usual);
        family(number(0, 20), number(1, 5));
    }
}

/// What a registration came to.
struct End {
    seconds: f64,
    iterations: usize,
    least_determinant: f64,
    report: Report<3>,
    grid: Grid<3>,
    displacement: Vec<f64>,
}

fn register(reference: SignedDistance<3>, template: SignedDistance<3>, finest: u32) -> End {
    let begin = seconds();
    let settings = Settings { coarsest: 4, finest, ..Settings::default() };
    let mut search = ready(Search::new(reference, template, settings)).expect("valid settings");
    let mut iterations = 0;
    let end = loop {
        let progress = ready(search.step());
        iterations += 1;
        if progress.stop.is_some() {
            break progress;
        }
    };
    let seconds = seconds() - begin;
    let [reference, template] = search.shapes();
    End {
        seconds,
        iterations,
        least_determinant: end.evaluation.least_determinant,
        report: report(reference, template, search.displacement()),
        grid: search.grid(),
        displacement: search.displacement().to_vec(),
    }
}

fn family(count: u32, finest: u32) {
    println!("pair   turn °  found off °   mean h   max h  cover h     det  iter.  seconds");
    let (mut close, mut covered, mut certified, mut right) = (0, 0, 0, 0);
    let mut seconds = Vec::new();
    for number in 0..count {
        let mut random = Random(u64::from(number) + 1);
        let (reference, template, turn) = pair(&mut random);
        let angle = turn.to_axis_angle().1.to_degrees();
        let shapes = [solid(finest, reference.turned(DQuat::IDENTITY)), solid(finest, template.turned(turn))];
        let [reference, template] = shapes;
        let shell = reference.clone();
        let end = register(reference, template, finest);
        let off = mean_turn(&shell, &end.displacement).angle_between(turn).to_degrees();
        let Report { mismatch, cover, .. } = end.report;
        println!(
            "{number:4} {angle:8.1} {off:12.1} {:8.3} {:7.3} {:8.3} {:7.3} {:6} {:8.2}",
            mismatch.mean, mismatch.max, cover.max, end.least_determinant, end.iterations, end.seconds
        );
        close += u32::from(mismatch.max <= 0.5);
        covered += u32::from(cover.max <= 1.0);
        certified += u32::from(end.least_determinant > 0.0);
        right += u32::from(off <= RIGHT_DEGREES);
        seconds.push(end.seconds);
    }
    seconds.sort_by(f64::total_cmp);
    println!(
        "{count} pairs: {close} within half a cell, {covered} covered within one, {certified} certified, {right} turned right; \
         median {:.2} s, worst {:.2} s",
        seconds[seconds.len() / 2],
        seconds[seconds.len() - 1]
    );
}

/// A sphere with bumps, and a copy with bumps of other heights a little beside, turned about any axis.
fn pair(random: &mut Random) -> (Bumpy, Bumpy, DQuat) {
    let bumps: Vec<(DVec3, f64)> =
        (0..5).map(|_| (direction(random), random.between(0.25, 0.6) * sign(random))).collect();
    let changed = bumps
        .iter()
        .map(|(towards, height)| ((*towards + 0.15 * direction(random)).normalize(), height * random.between(0.8, 1.2)))
        .collect();
    let turn = DQuat::from_axis_angle(direction(random), random.between(0.0, TURN_DEGREES).to_radians());
    (Bumpy::reaching(bumps, 0.32), Bumpy::reaching(changed, 0.32), turn)
}

/// Hollows are shallower than bumps are high, but there are some.
fn sign(random: &mut Random) -> f64 {
    if random.between(0.0, 1.0) < 0.3 { -0.5 } else { 1.0 }
}

/// Even on the sphere.
fn direction(random: &mut Random) -> DVec3 {
    loop {
        let point = DVec3::from_array(std::array::from_fn(|_| random.between(-1.0, 1.0)));
        if (0.01..1.0).contains(&point.length_squared()) {
            return point.normalize();
        }
    }
}

fn known_correspondence(from: &str, to: &str, finest: u32) {
    let [(mut positions, triangles), (mut target, others)] = [from, to].map(|path| match ply::read(path) {
        Ok(mesh) => mesh,
        Err(problem) => panic!("{path}: {problem}"),
    });
    assert_eq!(positions.len(), target.len(), "both meshes have as many vertices");
    fit([&mut positions, &mut target]);
    let grid = Grid::of_level(finest);
    let begin = seconds();
    let shapes = [(&positions, &triangles), (&target, &others)]
        .map(|(positions, triangles)| SignedDistance::from_mesh(grid, positions, triangles));
    let [reference, template] = shapes.map(|shape| shape.unwrap_or_else(|problem| panic!("a mesh {problem}")));
    println!("distances: {:.3} s", seconds() - begin);
    let end = register(reference, template, finest);
    let errors = |moved: &dyn Fn(&[f64; 3]) -> DVec3| {
        let errors = positions.iter().zip(&target).map(|(from, to)| moved(from).distance(DVec3::from(*to)));
        let (sum, most) = errors.fold((0.0, 0.0_f64), |(sum, most), error| (sum + error, most.max(error)));
        (sum / positions.len() as f64, most)
    };
    let before = errors(&|x| DVec3::from(*x));
    let after = errors(&|x| DVec3::from(*x) + DVec3::from(interpolate::<3, 3>(end.grid, &end.displacement, x)));
    let Report { mismatch, cover, .. } = end.report;
    println!("{}³ nodes, {} iterations, {:.1} s", end.grid.side(), end.iterations, end.seconds);
    println!(
        "from its namesake, mean / largest: {:.4} / {:.4} at first, {:.4} / {:.4} in the end",
        before.0, before.1, after.0, after.1
    );
    println!(
        "mismatch {:.3} / {:.3} h, cover {:.3} / {:.3} h, least determinant {:.3}",
        mismatch.mean, mismatch.max, cover.mean, cover.max, end.least_determinant
    );
}

/// Moves and scales both alike, so that the box around them is in the middle and has room at the border.
fn fit(shapes: [&mut Vec<[f64; 3]>; 2]) {
    const LONGEST: f64 = 0.72;
    let all = || shapes.iter().flat_map(|shape| shape.iter()).map(|point| DVec3::from(*point));
    let (low, high) = (all().fold(DVec3::INFINITY, DVec3::min), all().fold(DVec3::NEG_INFINITY, DVec3::max));
    let scale = LONGEST / (high - low).max_element();
    for point in shapes.into_iter().flatten() {
        *point = (0.5 + scale * (DVec3::from(*point) - low.midpoint(high))).to_array();
    }
}
