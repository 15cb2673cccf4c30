//! Nothing gets stuck: what has no energy is refused, what falls between the nodes of a coarse grid starts on a finer one.

mod common;

use common::{circle, ellipse};
use glam::DVec2;
use thinshell::distance::SignedDistance;
use thinshell::error::Error;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::search::{Search, SearchProgress};
use thinshell::settings::{Alignment, MinimizerKind, Settings};

const CENTRE: [f64; 2] = [0.5, 0.5];

fn distance(level: u32, loops: &[Vec<DVec2>]) -> SignedDistance<2> {
    SignedDistance::from_loops(Grid::of_level(level), loops).expect("a valid shape")
}

fn end<const D: usize>(cascade: &mut Search<D>) -> SearchProgress {
    loop {
        let progress = ready(cascade.step());
        if progress.stop.is_some() {
            return progress;
        }
    }
}

#[test]
fn what_has_no_finite_energy_is_refused_by_the_name_of_the_term() {
    let (reference, template) = (distance(5, &[circle(CENTRE, 0.2)]), distance(5, &[ellipse(CENTRE, 0.3, 0.2)]));
    let stretched =
        |by: f64| SignedDistance::from_nodal(template.grid(), template.values().iter().map(|d| d * by).collect());
    let refused = |by: f64, settings: Settings| match ready(Search::new(reference.clone(), stretched(by), settings)) {
        Err(Error::NoEnergy { term, .. }) => term,
        other => panic!("{:?}", other.err()),
    };
    for minimizer in [MinimizerKind::Newton, MinimizerKind::Ncg] {
        for (bending, term) in [(0.03, "bending"), (0.0, "mismatch")] {
            // Aligned, the shapes are matched the other way round first, and then there is no shell.
            let settings =
                Settings { finest: 5, alignment: Alignment::None, minimizer, bending, ..Settings::default() };
            assert_eq!(refused(1e12, settings), term);
        }
    }
}

#[test]
fn an_update_without_finite_energy_is_refused_and_changes_nothing() {
    let (reference, template) = (distance(5, &[circle(CENTRE, 0.2)]), distance(5, &[ellipse(CENTRE, 0.3, 0.2)]));
    let settings = Settings { finest: 5, ..Settings::default() };
    let mut cascade = ready(Search::new(reference.clone(), template.clone(), settings)).expect("valid settings");
    ready(cascade.step());
    let before = (cascade.displacement().to_vec(), cascade.progress().evaluations);
    let huge = SignedDistance::from_nodal(template.grid(), template.values().iter().map(|d| d * 1e160).collect());
    let refused = ready(cascade.update(reference, huge, settings, &[])).err();
    assert!(matches!(refused, Some(Error::NoEnergy { .. })), "{refused:?}");
    assert_eq!((cascade.displacement().to_vec(), cascade.progress().evaluations), before);
    assert!(end(&mut cascade).evaluation.is_admissible());
}

#[test]
fn shapes_that_fall_between_coarse_nodes_start_on_the_first_level_that_carries_them() {
    let cell = |cells: f64| 1.0 / cells;
    let off_centre = [0.5 + 0.5 * cell(16.0), 0.5 + 0.5 * cell(16.0)];
    let sliver = |y: f64| {
        vec![
            DVec2::new(0.2, y - 0.001),
            DVec2::new(0.8, y - 0.001),
            DVec2::new(0.8, y + 0.001),
            DVec2::new(0.2, y + 0.001),
        ]
    };
    let ring = |radius: f64, width: f64| vec![circle(CENTRE, radius), circle(CENTRE, radius - width)];
    type Loops = Vec<Vec<DVec2>>;
    let cases: [(&str, Loops, Loops, u32); 5] = [
        ("large circles", vec![circle(CENTRE, 0.2)], vec![circle(CENTRE, 0.25)], 4),
        // The middle of a cell of 1/16 is a node of the next grid.
        ("small circles", vec![circle(off_centre, 0.02)], vec![circle(off_centre, 0.025)], 5),
        ("one of them small", vec![circle(CENTRE, 0.2)], vec![circle(off_centre, 0.02)], 5),
        ("slivers", vec![sliver(0.5 + cell(32.0))], vec![sliver(0.5 + 3.0 * cell(32.0))], 5),
        ("thin rings", ring(0.3, 0.024), ring(0.28, 0.024), 5),
    ];
    for (name, reference, template, level) in cases {
        let settings = Settings { finest: 6, ..Settings::default() };
        let (reference, template) = (distance(6, &reference), distance(6, &template));
        let mut cascade = ready(Search::new(reference, template, settings)).expect("valid settings");
        assert_eq!(cascade.progress().level, level, "{name}");
        for _ in 0..10 {
            let progress = ready(cascade.step());
            assert!(progress.evaluation.is_admissible(), "{name}: {progress:?}");
        }
    }
}

#[test]
fn a_shape_whose_coarse_nodes_all_lie_on_its_outline_starts_on_a_finer_level() {
    // What is inside between a row of nodes and a diagonal; one of them may be negative by rounding.
    let corners = [[0.6, 0.5], [0.5, 0.5], [0.3, 0.3], [0.7, 0.7], [0.6, 0.6]];
    let reference = distance(5, &[corners.map(DVec2::from).to_vec()]);
    assert!(!reference.is_carried_by(16));
    let settings = Settings { coarsest: 4, finest: 5, ..Settings::default() };
    let search = ready(Search::new(reference, distance(5, &[circle(CENTRE, 0.2)]), settings)).expect("valid settings");
    assert_eq!(search.progress().level, 5);
}

#[test]
fn an_update_to_a_small_shape_goes_on_where_it_is_carried() {
    let settings = Settings { finest: 6, ..Settings::default() };
    let reference = distance(6, &[circle(CENTRE, 0.2)]);
    let small = distance(6, &[circle([0.5 + 1.0 / 32.0, 0.5 + 1.0 / 32.0], 0.02)]);
    let mut cascade = ready(Search::new(reference.clone(), reference.clone(), settings)).expect("valid settings");
    assert_eq!(cascade.progress().level, 4);
    ready(cascade.update(reference, small, settings, &[])).expect("a valid update");
    assert_eq!(cascade.progress().level, 5);
}

#[test]
fn spheres_become_ellipsoids_by_either_minimiser() {
    let cells = 16;
    let grid = Grid::<3>::new(cells);
    let ellipsoid = |axes: [f64; 3]| {
        let value = |x: [f64; 3]| {
            let square: f64 = (0..3).map(|k| ((x[k] - 0.5) / axes[k]).powi(2)).sum();
            0.25 * (square.sqrt() - 1.0)
        };
        let values: Vec<f64> = (0..grid.node_count()).map(|node| value(grid.position(node))).collect();
        SignedDistance::redistance(grid, &values).expect("a valid level set")
    };
    let (sphere, target) = (ellipsoid([0.25; 3]), ellipsoid([0.3, 0.25, 0.2]));
    for minimizer in [MinimizerKind::Newton, MinimizerKind::Ncg] {
        let settings = Settings {
            coarsest: 3,
            finest: 4,
            minimizer,
            bending: 0.03,
            volume: 1e-2,
            tolerance: 1e-3,
            alignment: Alignment::None,
            ..Settings::default()
        };
        let mut cascade = ready(Search::<3>::new(sphere.clone(), target.clone(), settings)).expect("valid settings");
        let before = cascade.progress().evaluation;
        let end = end(&mut cascade);
        assert!(end.evaluation.is_admissible() && end.level == 4, "{minimizer:?}: {end:?}");
        // The functional of the finest level penalises more than that of the coarsest, and yet:
        assert!(end.evaluation.energies.mismatch < 0.05 * before.energies.mismatch, "{minimizer:?}: {end:?}");
        // Along the longest axis the sphere's pole moves outwards, along the shortest inwards.
        let pole = |axis: usize| {
            let mut index = [cells / 2; 3];
            index[axis] += cells / 4;
            cascade.displacement()[3 * grid.node(index) + axis]
        };
        assert!(
            (pole(0) - 0.05).abs() < 0.01 && (pole(2) + 0.05).abs() < 0.01,
            "{minimizer:?}: {} {}",
            pole(0),
            pole(2)
        );
    }
}
