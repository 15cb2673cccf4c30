//! Searches on a graphics card end as on the processor, whatever happens to the card.

#[path = "common/card.rs"]
mod card;
mod common;
#[path = "common/solids.rs"]
mod solids;

use card::card;
use common::{circle, ellipse, leaf, star};
use glam::DQuat;
use solids::{octahedron, solid};
use thinshell::assemble::Gpu;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::report::report;
use thinshell::search::{Search, SearchProgress};
use thinshell::settings::{Alignment, Backend, Settings};

/// In cells: between deformations, and between the greatest distances that they leave.
const NEAR: f64 = 0.05;
const NEARLY_AS_FAR: f64 = 0.02;
/// In cells, between a deformation and its mirror image; 5e-6 was found.
const SYMMETRIC: f64 = 1e-3;
/// Relative decrease at which searches stop: their energies agree no better.
const SETTLED: f64 = 1e-5;

fn stars(finest: u32) -> [SignedDistance<2>; 2] {
    let shape = |curve| SignedDistance::from_loops(Grid::of_level(finest), &[curve]).expect("a valid curve");
    [shape(star([0.5; 2], 0.2, 5, 0.1, 0.0)), shape(star([0.52, 0.49], 0.24, 5, 0.15, 0.1))]
}

fn search<const D: usize>([reference, template]: [SignedDistance<D>; 2], backend: Backend) -> Search<D> {
    let finest = reference.grid().cells().ilog2();
    let settings = Settings { finest, backend, ..Settings::default() };
    ready(Search::new(reference, template, settings)).expect("valid settings, and a card")
}

fn end<const D: usize>(search: &mut Search<D>) -> SearchProgress {
    loop {
        let progress = ready(search.step());
        if progress.stop.is_some() {
            return progress;
        }
    }
}

fn farthest(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The same mismatch and the same deformation, up to these parts of a cell.
fn assert_same_match<const D: usize>(found: &Search<D>, expected: &Search<D>) {
    let cells = expected.grid().cells() as f64;
    let apart = farthest(found.displacement(), expected.displacement()) * cells;
    assert!(apart < NEAR, "{apart} cells apart");
    assert_as_near(found, expected);
}

fn assert_as_near<const D: usize>(found: &Search<D>, expected: &Search<D>) {
    let mismatch = [found, expected]
        .map(|search| report(search.reference(), search.template(), search.displacement()).mismatch.max);
    assert!((mismatch[0] - mismatch[1]).abs() < NEARLY_AS_FAR, "{mismatch:?}");
}

fn octahedra() -> [SignedDistance<3>; 2] {
    [0.0, 0.2].map(|angle| solid(4, octahedron(0.3, DQuat::from_rotation_z(angle))))
}

fn ends_alike<const D: usize>(shapes: impl Fn() -> [SignedDistance<D>; 2]) {
    let [mut found, mut expected] = [Backend::Gpu, Backend::Cpu].map(|backend| search(shapes(), backend));
    assert_eq!(end(&mut found).approach, end(&mut expected).approach);
    assert!(found.backend().starts_with("gpu: "), "{}", found.backend());
    assert_eq!(expected.backend(), "cpu");
    assert_same_match(&found, &expected);
}

#[test]
fn a_search_on_the_card_ends_as_on_the_processor() {
    if card().is_some() {
        ends_alike(|| stars(6));
        ends_alike(octahedra);
    }
}

#[test]
fn a_search_whose_device_is_lost_in_the_middle_ends_as_on_the_processor() {
    if card().is_none() {
        return;
    }
    let [mut found, mut expected] = [Backend::Gpu, Backend::Cpu].map(|backend| search(stars(6), backend));
    for _ in 0..3 {
        ready(found.step());
    }
    ready(Gpu::shared()).expect("a card").destroy();
    assert_eq!(end(&mut found).approach, end(&mut expected).approach);
    assert_eq!(found.backend(), "cpu: the graphics device was given up");
    assert_same_match(&found, &expected);
    // The next one has a new device.
    assert!(search(stars(5), Backend::Gpu).backend().starts_with("gpu: "));
}

#[test]
fn two_searches_at_once_share_a_card_and_nothing_else() {
    if card().is_none() {
        return;
    }
    let [mut one, mut other] = [stars(6), stars(5)].map(|shapes| search(shapes, Backend::Gpu));
    let mut ends = [None; 2];
    while ends.iter().any(Option::is_none) {
        ends = [ready(one.step()).stop, ready(other.step()).stop];
    }
    for (search_on_card, finest) in [(&one, 6), (&other, 5)] {
        let mut alone = search(stars(finest), Backend::Cpu);
        end(&mut alone);
        assert_same_match(search_on_card, &alone);
    }
}

#[test]
fn the_pairs_of_the_benchmark_end_on_129_squared_nodes_as_on_the_processor() {
    if card().is_none() {
        return;
    }
    let centre = [0.5; 2];
    let pairs = [
        [star(centre, 0.25, 5, 0.25, 0.0), star(centre, 0.25, 5, 0.25, 0.35)],
        [leaf(centre, 0.2, 0.12, 0.0), leaf(centre, 0.2, 0.22, 0.3)],
    ];
    for pair in pairs {
        let shape = |curve: &Vec<_>| SignedDistance::from_loops(Grid::of_level(7), std::slice::from_ref(curve));
        ends_alike(|| pair.each_ref().map(|curve| shape(curve).expect("a valid curve")));
    }
}

/// The mirror image of a deformation, by an axis of the box.
fn mirrored(grid: Grid<2>, displacement: &[f64], axis: usize) -> Vec<f64> {
    let node = |node| {
        let mut index = grid.node_index(node);
        index[axis] = grid.cells() - index[axis];
        let mut u = [0, 1].map(|k| displacement[grid.node(index) * 2 + k]);
        u[axis] = -u[axis];
        u
    };
    (0..grid.node_count()).flat_map(node).collect()
}

/// A circle slides along itself at nearly no cost, and the processor, whose sweeps go from one corner of the box to the
/// other, lets it: far apart, both are as good. Where it belongs the pair's symmetry tells.
#[test]
fn a_circle_becomes_as_good_an_ellipse_on_129_squared_nodes_as_on_the_processor_and_a_symmetric_one() {
    if card().is_none() {
        return;
    }
    let shapes = || {
        let shape = |curve| SignedDistance::from_loops(Grid::of_level(7), &[curve]).expect("a valid curve");
        [shape(circle([0.5; 2], 0.15)), shape(ellipse([0.5; 2], 0.45, 0.25))]
    };
    let [mut found, mut expected] = [Backend::Gpu, Backend::Cpu].map(|backend| search(shapes(), backend));
    let ends = [end(&mut found), end(&mut expected)];
    assert_eq!(ends[0].approach, ends[1].approach);
    let energies = ends.map(|end| end.evaluation.total());
    assert!((energies[0] - energies[1]).abs() < SETTLED * energies[1], "{energies:?}");
    assert_as_near(&found, &expected);
    for axis in [0, 1] {
        let image = mirrored(found.grid(), found.displacement(), axis);
        let apart = farthest(&image, found.displacement()) * found.grid().cells() as f64;
        assert!(apart < SYMMETRIC, "it leans by {apart} cells");
    }
}

#[test]
fn a_card_that_a_processor_plays_is_none_unless_it_is_insisted_on() {
    let Some(gpu) = card() else { return };
    if !gpu.is_software() {
        return;
    }
    let expected = format!("cpu: the graphics card is none, the processor plays it ({})", gpu.name());
    assert_eq!(search(stars(5), Backend::Auto).backend(), expected);
    assert_eq!(search(stars(5), Backend::Gpu).backend(), format!("gpu: {}", gpu.name()));
}

#[test]
fn fifty_searches_leave_no_buffer_on_the_card() {
    if card().is_none() {
        return;
    }
    let gpu = ready(Gpu::shared()).expect("a card");
    for run in 0..50 {
        // Without comparing starts, which is a hundred evaluations a run.
        let settings = Settings { finest: 5, backend: Backend::Gpu, alignment: Alignment::None, ..Settings::default() };
        let [reference, template] = stars(5);
        let mut search = ready(Search::new(reference, template, settings)).expect("valid settings, and a card");
        ready(search.step());
        assert!(gpu.buffers() > 0, "it computes");
        drop(search);
        assert_eq!(gpu.buffers(), 0, "after run {run}");
    }
}
