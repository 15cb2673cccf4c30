//! The assembler on a graphics card against the processor's, which is f64 and the truth.

#[path = "common/card.rs"]
mod card;
mod common;
#[path = "common/solids.rs"]
mod solids;

use card::card;
use common::{Random, apply, star};
use glam::DQuat;
use solids::{octahedron, solid};
use std::rc::Rc;
use thinshell::assemble::{Assembler, CpuAssembler, Evaluation, Gpu, GpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::energy::{BendingModel, Functional, MembraneModel, Pin};
use thinshell::grid::Grid;
use thinshell::minimize::{Minimizer, Ncg, Newton, Progress};
use thinshell::prolongation::prolongate;
use thinshell::ready::ready;
use thinshell::settings::Settings;
use thinshell::stencil::StencilOperator;

/// Of an energy: every density has some ten roundings of 2⁻²⁴ = 6e-8, which sums over many cells average, and the trees'
/// partial sums have a dozen more.
const ENERGY: f64 = 1e-5;
/// Of a gradient, relative to its norm: forces on a node are differences of its cells' stresses, which cancel to the extent
/// that the deformation is smooth.
const GRADIENT: f64 = 1e-4;
/// Of H d, relative to its norm: the processor's operator is f32 as well.
const HESSIAN: f64 = 1e-4;

/// The level set of an ellipsoid, turned a little: smooth where the band is, and no symmetry hides an error.
fn shape<const D: usize>(level: u32, centre: f64, axes: [f64; 3]) -> SignedDistance<D> {
    let grid = Grid::<D>::of_level(level);
    let value = |x: [f64; D]| {
        let (p, q) = (x[0] - centre, x[1] - 0.5);
        let mut from = [0.96 * p - 0.28 * q, 0.28 * p + 0.96 * q, 0.0];
        if D == 3 {
            from[2] = x[D - 1] - 0.48;
        }
        let scaled: [f64; 3] = std::array::from_fn(|k| from[k] / axes[k]);
        let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
        (length - 1.0) * 0.25
    };
    SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|node| value(grid.position(node))).collect())
}

/// A displacement with long waves, and noise in every mode of a cell.
fn displacement<const D: usize>(grid: Grid<D>, random: &mut Random) -> Vec<f64> {
    let phases: [f64; 3] = std::array::from_fn(|_| random.between(0.0, 6.0));
    (0..grid.node_count())
        .flat_map(|node| {
            let x = grid.position(node);
            let noise: [f64; D] = std::array::from_fn(|_| 0.07 * grid.spacing() * random.between(-1.0, 1.0));
            std::array::from_fn::<f64, D, _>(|k| {
                0.03 * (5.0 * x[(k + 1) % D] + 2.0 * x[k] + phases[k]).sin() + noise[k]
            })
        })
        .collect()
}

type Change = fn(&mut Functional);

/// Each term alone, then all together.
const TERMS: [(&str, Change); 8] = [
    ("membrane", |f| (f.bending, f.penalty, f.volume) = (0.0, 0.0, 0.0)),
    ("projected membrane", |f| {
        (f.bending, f.penalty, f.volume, f.membrane_model) = (0.0, 0.0, 0.0, MembraneModel::Projected);
    }),
    ("bending", |f| (f.membrane, f.penalty, f.volume) = (0.0, 0.0, 0.0)),
    ("mean curvature", |f| {
        (f.membrane, f.penalty, f.volume, f.bending_model) = (0.0, 0.0, 0.0, BendingModel::MeanCurvature);
    }),
    ("mismatch", |f| (f.membrane, f.bending, f.tangency, f.volume) = (0.0, 0.0, 0.0, 0.0)),
    ("tangency", |f| (f.membrane, f.bending, f.tangency, f.volume) = (0.0, 0.0, 10.0, 0.0)),
    ("volume", |f| (f.membrane, f.bending, f.penalty, f.softness) = (0.0, 0.0, 0.0, 0.3)),
    ("all", |f| f.membrane_model = MembraneModel::Projected),
];

fn assemblers<const D: usize>(
    gpu: &Rc<Gpu>,
    level: u32,
    functional: &Functional,
) -> (CpuAssembler<D>, GpuAssembler<D>) {
    let (truth, twin) = twins(level, functional);
    (truth, GpuAssembler::new(gpu.clone(), twin))
}

fn twins<const D: usize>(level: u32, functional: &Functional) -> (CpuAssembler<D>, CpuAssembler<D>) {
    let shapes = [shape::<D>(level, 0.5, [0.26, 0.22, 0.24]), shape::<D>(level, 0.52, [0.3, 0.2, 0.22])];
    let pin = |a: f64, b: f64| Pin { reference: [a; D], template: [b; D] };
    let [truth, twin] = [(), ()].map(|()| {
        let mut assembler = CpuAssembler::new(functional, &shapes[0], &shapes[1]);
        assembler.tie(&[pin(0.3, 0.33), pin(0.71, 0.66)], 2.0);
        assembler
    });
    (truth, twin)
}

fn functional<const D: usize>(level: u32, gauss_points: usize, change: Change) -> Functional {
    let mut functional = Functional { gauss_points, ..Settings::default().functional(level.max(4)) };
    change(&mut functional);
    functional
}

fn norm(a: &[f64]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn assert_near(found: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    let error: Vec<f64> = found.iter().zip(expected).map(|(a, b)| a - b).collect();
    let relative = norm(&error) / norm(expected);
    assert!(relative <= tolerance, "{what}: off by {relative:e}");
}

fn assert_same_energies(found: &Evaluation, expected: &Evaluation, what: &str) {
    let pairs = [
        ("membrane", found.energies.membrane, expected.energies.membrane),
        ("bending", found.energies.bending, expected.energies.bending),
        ("mismatch", found.energies.mismatch, expected.energies.mismatch),
        ("volume", found.energies.volume, expected.energies.volume),
        ("pins", found.energies.pins, expected.energies.pins),
    ];
    for (term, a, b) in pairs {
        assert!((a - b).abs() <= ENERGY * b.abs(), "{what}, {term}: {a} is not {b} ({:e})", (a - b) / b);
    }
    let (a, b) = (found.least_determinant, expected.least_determinant);
    assert!((a - b).abs() <= ENERGY, "{what}, least determinant: {a} is not {b}");
}

fn agree<const D: usize>(gpu: &Rc<Gpu>, level: u32, gauss_points: usize) {
    let mut random = Random(u64::from(level) + 7 * D as u64);
    let grid = Grid::<D>::of_level(level);
    for (term, change) in TERMS {
        let what = format!("{term}, {} nodes a side, D = {D}, {gauss_points} points", grid.side());
        let (mut truth, mut found) = assemblers::<D>(gpu, level, &functional::<D>(level, gauss_points, change));
        let u = displacement(grid, &mut random);
        let [mut expected, mut gradient] = [0, 1].map(|_| vec![0.0; u.len()]);
        let evaluation = ready(truth.gradient(&u, &mut expected));
        assert!(evaluation.least_determinant > 0.05, "{what}: the example is admissible");
        assert_same_energies(&ready(found.energy(&u)), &evaluation, &what);
        assert_same_energies(&ready(found.gradient(&u, &mut gradient)), &evaluation, &what);
        assert_near(&gradient, &expected, GRADIENT, &what);
        assert!(found.backend().starts_with("gpu: "), "{}", found.backend());
    }
}

#[test]
fn energies_and_gradients_of_curves_are_the_processors() {
    let Some(gpu) = card() else { return };
    for level in 5..=8 {
        agree::<2>(&gpu, level, 3);
    }
}

#[test]
fn energies_and_gradients_of_surfaces_are_the_processors() {
    let Some(gpu) = card() else { return };
    for level in [4, 5] {
        agree::<3>(&gpu, level, 2);
    }
    agree::<3>(&gpu, 4, 3);
}

fn hessians_agree<const D: usize>(gpu: &Rc<Gpu>, level: u32, gauss_points: usize, terms: &[(&str, Change)]) {
    let mut random = Random(u64::from(level) + 13 * D as u64);
    let grid = Grid::<D>::of_level(level);
    for &(term, change) in terms {
        let what = format!("{term}, {} nodes a side, D = {D}, {gauss_points} points", grid.side());
        let (mut truth, mut found) = assemblers::<D>(gpu, level, &functional::<D>(level, gauss_points, change));
        let u = displacement(grid, &mut random);
        let d: Vec<f64> = (0..u.len()).map(|_| random.between(-1.0, 1.0)).collect();
        let evaluate = |assembler: &mut dyn FnMut(&mut [f64], &mut StencilOperator<D>)| {
            let (mut gradient, mut operator) = (vec![0.0; u.len()], StencilOperator::zero(grid));
            assembler(&mut gradient, &mut operator);
            (gradient, apply(&operator, &d))
        };
        let expected = evaluate(&mut |gradient, operator| {
            ready(truth.hessian(&u, gradient, operator));
        });
        let computed = evaluate(&mut |gradient, operator| {
            ready(found.hessian(&u, gradient, operator));
        });
        assert_near(&computed.0, &expected.0, GRADIENT, &what);
        assert_near(&computed.1, &expected.1, HESSIAN, &what);
        assert!(found.backend().starts_with("gpu: "), "{}", found.backend());
    }
}

#[test]
fn hessians_are_the_processors() {
    let Some(gpu) = card() else { return };
    hessians_agree::<2>(&gpu, 5, 3, &TERMS);
    hessians_agree::<2>(&gpu, 7, 3, &TERMS);
    hessians_agree::<3>(&gpu, 4, 2, &TERMS);
    hessians_agree::<3>(&gpu, 4, 3, &TERMS);
}

#[test]
fn a_hessian_of_65_cubed_nodes_is_assembled_though_no_binding_may_hold_it() {
    let Some(gpu) = card() else { return };
    let grid = Grid::<3>::of_level(6);
    let bytes = grid.node_count() * StencilOperator::<3>::ROW * 4;
    assert!(bytes > wgpu::Limits::default().max_storage_buffer_binding_size as usize);
    hessians_agree::<3>(&gpu, 6, 2, &TERMS[7..]);
}

/// There the template's distance is a polynomial of a cell far away, which makes much of the rounding of its corners.
const FAR: &str = "far beyond the box";

/// What no deformation may be: folded, no number, beyond what f32 can hold; and what only nearly is.
fn poisons<const D: usize>(grid: Grid<D>, smooth: &[f64]) -> Vec<(&'static str, Vec<f64>)> {
    let middle = grid.node([grid.cells() / 2; D]) * D;
    let with = |change: &dyn Fn(&mut Vec<f64>)| {
        let mut u = smooth.to_vec();
        change(&mut u);
        u
    };
    // Moves a node along the diagonal of the cell below it: at −share/D·h its determinant is 1 − share.
    let pushed = |share: f64| {
        let mut u = vec![0.0; smooth.len()];
        u[middle..][..D].fill(share / D as f64 * grid.spacing());
        u
    };
    vec![
        ("none", smooth.to_vec()),
        ("not a number", with(&|u| u[middle] = f64::NAN)),
        ("infinite", with(&|u| u[middle + 1] = f64::INFINITY)),
        ("beyond f32", with(&|u| u[middle] = 1e300)),
        ("all beyond f32", with(&|u| u.iter_mut().for_each(|u| *u *= 1e60))),
        ("beyond the box", with(&|u| u.iter_mut().for_each(|u| *u += 0.15))),
        (FAR, with(&|u| u.iter_mut().for_each(|u| *u += 1.5))),
        (FAR, with(&|u| u.iter_mut().for_each(|u| *u += 1e5))),
        ("folded", pushed(1.5)),
        ("hardly folded", pushed(1.0 + 1e-9)),
        ("nearly folded", pushed(1.0 - 1e-9)),
        ("next to a fold", pushed(1.0 - 1e-4)),
        ("near a fold", pushed(1.0 - 0.02)),
        ("collapsed", (0..grid.node_count()).flat_map(|node| grid.position(node).map(|x| -x)).collect()),
        (
            "mirrored",
            (0..grid.node_count())
                .flat_map(|node| {
                    let x = grid.position(node);
                    std::array::from_fn::<f64, D, _>(|k| if k == 0 { -2.0 * x[0] } else { 0.0 })
                })
                .collect(),
        ),
    ]
}

fn judge_alike<const D: usize>(gpu: &Rc<Gpu>, level: u32) {
    let grid = Grid::<D>::of_level(level);
    let (mut truth, mut found) = assemblers::<D>(gpu, level, &functional::<D>(level, 3, |_| ()));
    let smooth = displacement(grid, &mut Random(3));
    for (poison, u) in poisons(grid, &smooth) {
        let mut unused = vec![0.0; u.len()];
        let expected = ready(truth.energy(&u));
        for evaluation in [ready(found.energy(&u)), ready(found.gradient(&u, &mut unused))] {
            let (a, b) = (evaluation.is_admissible(), expected.is_admissible());
            assert_eq!(a, b, "{poison}, D = {D}: {evaluation:?} against {expected:?}");
            if b && poison != FAR {
                let error = (evaluation.total() - expected.total()).abs();
                assert!(error <= ENERGY * expected.total(), "{poison}, D = {D}: {evaluation:?} against {expected:?}");
            }
        }
    }
    // It is none the worse for it.
    assert_same_energies(&ready(found.energy(&smooth)), &ready(truth.energy(&smooth)), "afterwards");
}

#[test]
fn what_is_not_admissible_is_so_on_both_sides() {
    let Some(gpu) = card() else { return };
    judge_alike::<2>(&gpu, 5);
    judge_alike::<3>(&gpu, 4);
}

/// How far apart both deformations may be anywhere, in cells; by a minimiser that creeps along a flat valley, farther.
const NEAR: f64 = 0.05;
const SLOWLY_NEAR: f64 = 0.5;

/// From coarse to fine, each level run to its end: the same verdict, energies and deformations.
fn match_alike<const D: usize, M: Minimizer<D>>(
    gpu: &Rc<Gpu>,
    shapes: &[SignedDistance<D>; 2],
    near: f64,
    minimizer: impl Fn(Grid<D>, Vec<f64>) -> M,
) {
    let finest = shapes[0].grid().cells().ilog2();
    let settings = Settings { finest, ..Settings::default() };
    let mut grid = Grid::<D>::of_level(4);
    let mut starts = [0, 1].map(|_| vec![0.0; grid.node_count() * D]);
    for level in 4..=finest {
        if level > 4 {
            starts = starts.map(|u| prolongate(grid, &u));
            grid = Grid::of_level(level);
        }
        let functional = settings.thrifty_functional::<D>(level);
        let [reference, template] = shapes.each_ref().map(|shape| shape.to_cells(1 << level));
        let [mut truth, twin] = [(), ()].map(|()| CpuAssembler::<D>::new(&functional, &reference, &template));
        let mut assembler = GpuAssembler::new(gpu.clone(), twin);
        let [mut expected, mut found] = starts.map(|u| minimizer(grid, u));
        let ends = [run(&mut expected, &mut truth), run(&mut found, &mut assembler)];
        assert_eq!(ends[0].stop, ends[1].stop);
        let totals = ends.map(|end| end.evaluation.total());
        assert!((totals[0] - totals[1]).abs() < 1e-3 * totals[0], "level {level}: {totals:?}");
        assert!(assembler.backend().starts_with("gpu: "), "{}", assembler.backend());
        starts = [expected.displacement().to_vec(), found.displacement().to_vec()];
    }
    let pairs = starts[0].iter().zip(&starts[1]);
    let farthest = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) * grid.cells() as f64;
    assert!(farthest < near, "{farthest} cells apart");
}

fn run<const D: usize>(minimizer: &mut impl Minimizer<D>, assembler: &mut impl Assembler<D>) -> Progress {
    loop {
        let progress = ready(minimizer.step(assembler));
        if progress.stop.is_some() {
            return progress;
        }
    }
}

/// Relative decrease at which minimisers stop: so little is left that both know where the minimum is.
const TOLERANCE: f64 = 1e-7;

#[test]
fn matches_of_curves_on_the_card_end_where_the_processors_end() {
    let Some(gpu) = card() else { return };
    let curves = |finest: u32| {
        let shape = |curve| SignedDistance::from_loops(Grid::of_level(finest), &[curve]).expect("a valid curve");
        [shape(star([0.5; 2], 0.2, 5, 0.1, 0.0)), shape(star([0.52, 0.49], 0.24, 5, 0.15, 0.1))]
    };
    match_alike(&gpu, &curves(6), NEAR, |grid, start| Newton::new(grid, start, TOLERANCE));
    match_alike(&gpu, &curves(5), SLOWLY_NEAR, |grid, start| Ncg::new(grid, start, 0.1, TOLERANCE));
}

#[test]
fn a_match_of_surfaces_on_the_card_ends_where_the_processors_ends() {
    let Some(gpu) = card() else { return };
    let shapes = [0.0, 0.2].map(|angle| solid(4, octahedron(0.3, DQuat::from_rotation_z(angle))));
    match_alike(&gpu, &shapes, NEAR, |grid, start| Newton::new(grid, start, TOLERANCE));
}

#[test]
fn when_the_device_is_lost_the_processor_goes_on() {
    let Some(gpu) = card() else { return };
    let (mut truth, mut found) = assemblers::<2>(&gpu, 5, &functional::<2>(5, 3, |_| ()));
    let u = displacement(Grid::<2>::of_level(5), &mut Random(5));
    ready(found.energy(&u));
    gpu.destroy();
    assert_eq!(ready(found.energy(&u)), ready(truth.energy(&u)), "to the bit: it is the processor's");
    assert_eq!(found.backend(), "cpu: the graphics device was given up");
    // So it is on a level begun afterwards.
    let (mut truth, mut later) = assemblers::<2>(&gpu, 5, &functional::<2>(5, 3, |_| ()));
    assert_eq!(ready(later.energy(&u)), ready(truth.energy(&u)));
    assert_eq!(later.backend(), "cpu: the graphics device was given up");
}

/// A clock that says what it is told to.
mod clock {
    use std::cell::RefCell;

    thread_local! {
        static TIMES: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
    }

    /// So many milliseconds for the processor, then for the card.
    pub fn set(millis: &[f64]) {
        let times = millis.iter().rev().flat_map(|millis| [*millis, 0.0]);
        TIMES.set(times.collect());
        thinshell::assemble::set_clock(|| TIMES.with_borrow_mut(|times| times.pop().expect("nobody looks more often")));
    }
}

/// What computes after the first hessian, if it takes processor and card so long.
fn chosen_after(gpu: &Rc<Gpu>, level: u32, millis: &[f64]) -> String {
    clock::set(millis);
    let (mut truth, twin) = twins::<2>(level, &functional::<2>(level, 3, |_| ()));
    let mut found = GpuAssembler::if_faster(gpu.clone(), twin);
    let grid = Grid::<2>::of_level(level);
    let u = displacement(grid, &mut Random(8));
    let [(mut expected, mut operator), (mut gradient, mut computed)] =
        [(), ()].map(|()| (vec![0.0; u.len()], StencilOperator::zero(grid)));
    let evaluation = ready(truth.hessian(&u, &mut expected, &mut operator));
    assert_same_energies(&ready(found.hessian(&u, &mut gradient, &mut computed)), &evaluation, "whoever computes");
    assert_near(&gradient, &expected, GRADIENT, "whoever computes");
    let d = vec![1.0; u.len()];
    assert_near(&apply(&computed, &d), &apply(&operator, &d), HESSIAN, "whoever computes");
    found.backend()
}

#[test]
fn whoever_is_faster_computes_and_is_asked_once_a_size() {
    let Some(gpu) = card() else { return };
    assert!(chosen_after(&gpu, 5, &[40.0, 20.0]).starts_with("gpu: "));
    assert!(chosen_after(&gpu, 5, &[]).starts_with("gpu: "), "known");
    let slower = "cpu: on this grid the graphics card takes 39 ms for what takes the processor 40 ms";
    assert_eq!(chosen_after(&gpu, 6, &[40.0, 39.0]), slower);
    assert_eq!(chosen_after(&gpu, 6, &[]), slower);
    let quick = "cpu: on this grid the processor is done before a graphics card would answer";
    assert_eq!(chosen_after(&gpu, 4, &[3.0]), quick);
}

#[test]
fn a_card_that_is_lost_before_it_is_timed_leaves_the_processor() {
    let Some(gpu) = card() else { return };
    gpu.destroy();
    assert_eq!(chosen_after(&gpu, 5, &[40.0]), "cpu: the graphics device was given up");
}
