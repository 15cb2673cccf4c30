//! Newton's method with its displacement on the card: where it stands, what it reads back, and what it leaves to the
//! processor.

#[path = "common/card.rs"]
mod card;
mod common;
#[path = "common/solids.rs"]
mod solids;

use card::card;
use common::star;
use glam::DQuat;
use solids::{octahedron, solid};
use std::rc::Rc;
use thinshell::assemble::{Assembler, Counts, CpuAssembler, Gpu, GpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::energy::Pin;
use thinshell::grid::Grid;
use thinshell::minimize::{Minimizer, Newton, Progress, Resident};
use thinshell::ready::ready;
use thinshell::settings::Settings;

/// Relative decrease at which minimisers stop.
const TOLERANCE: f64 = 1e-5;
/// Where so little is left both know where the minimum is.
const SETTLED: f64 = 1e-7;
/// In space, where a processor that plays the card is slow.
const SPATIAL_ITERATIONS: usize = 5;
/// Of energies, see tests/gpu.rs.
const ENERGY: f64 = 1e-5;
/// Between deformations, in cells.
const NEAR: f64 = 0.05;

fn stars(level: u32) -> [SignedDistance<2>; 2] {
    let shape = |curve| SignedDistance::from_loops(Grid::of_level(level), &[curve]).expect("a valid curve");
    [shape(star([0.5; 2], 0.2, 5, 0.1, 0.0)), shape(star([0.52, 0.49], 0.24, 5, 0.15, 0.1))]
}

fn octahedra() -> [SignedDistance<3>; 2] {
    [0.0, 0.2].map(|angle| solid(4, octahedron(0.3, DQuat::from_rotation_z(angle))))
}

fn processor<const D: usize>(shapes: &[SignedDistance<D>; 2]) -> CpuAssembler<D> {
    tied(shapes, &[])
}

fn tied<const D: usize>([reference, template]: &[SignedDistance<D>; 2], pins: &[Pin<D>]) -> CpuAssembler<D> {
    let level = reference.grid().cells().ilog2();
    let functional = Settings::default().thrifty_functional::<D>(level);
    let mut assembler = CpuAssembler::new(&functional, reference, template);
    assembler.tie(pins, 1.0);
    assembler
}

/// Two in one cell, one in the next, and one in the box's last.
fn pins<const D: usize>() -> [Pin<D>; 4] {
    [(0.401, 0.405), (0.415, 0.42), (0.43, 0.434), (0.999, 0.997)]
        .map(|(from, to)| Pin { reference: [from; D], template: [to; D] })
}

fn resident<const D: usize>(grid: Grid<D>) -> Resident<D> {
    Resident::new(grid, vec![0.0; grid.node_count() * D], TOLERANCE)
}

fn end<const D: usize>(minimizer: &mut impl Minimizer<D>, assembler: &mut impl Assembler<D>) -> Progress {
    loop {
        let progress = ready(minimizer.step(assembler));
        if progress.stop.is_some() {
            return progress;
        }
    }
}

/// What goes back from the card by iterations, so many or to the end; the first are what they are said to be.
fn read_by_iterations<const D: usize>(
    gpu: &Rc<Gpu>,
    shapes: &[SignedDistance<D>; 2],
    pins: &[Pin<D>],
    most: usize,
) -> Vec<Counts> {
    let mut assembler = GpuAssembler::new(gpu.clone(), tied(shapes, pins));
    let mut truth = tied(shapes, pins);
    let mut minimizer = resident(assembler.grid());
    let mut counts = Vec::new();
    while counts.len() < most {
        let before = gpu.counts();
        let progress = ready(minimizer.step(&mut assembler));
        if progress.stop.is_some() {
            // Then the displacement is read as well.
            break;
        }
        counts.push(gpu.counts().since(before));
        if progress.iterations <= 3 {
            ready(minimizer.fetch(&mut assembler)).expect("a card that answers");
            let expected = ready(truth.energy(minimizer.displacement()));
            let error = (progress.evaluation.total() - expected.total()).abs();
            assert!(error < ENERGY * expected.total(), "{progress:?} is said to be, {expected:?} is");
            let error = (progress.evaluation.energies.pins - expected.energies.pins).abs();
            assert!(error <= ENERGY * expected.energies.pins, "{progress:?} is said to be, {expected:?} is");
        }
    }
    counts
}

fn reads_little<const D: usize>(gpu: &Rc<Gpu>, shapes: &[SignedDistance<D>; 2], pins: &[Pin<D>], most: usize) {
    let counts = read_by_iterations(gpu, shapes, pins, most);
    eprintln!("D = {D}: {counts:?}");
    assert!(counts.len() >= 3, "it iterates");
    let most = |of: fn(&Counts) -> usize| counts.iter().map(of).max().unwrap_or(0);
    assert!(most(|count| count.readbacks) <= 2, "{counts:?}");
    assert!(most(|count| count.bytes_read as usize) <= 4096, "{counts:?}");
}

#[test]
fn an_iteration_reads_back_two_times_at_most_and_no_more_than_4_kb() {
    let Some(gpu) = card() else { return };
    reads_little(&gpu, &stars(5), &[], usize::MAX);
    reads_little(&gpu, &octahedra(), &[], SPATIAL_ITERATIONS);
}

#[test]
fn pins_stay_on_the_card_and_read_back_no_more() {
    let Some(gpu) = card() else { return };
    reads_little(&gpu, &stars(5), &pins(), usize::MAX);
    reads_little(&gpu, &octahedra(), &pins(), SPATIAL_ITERATIONS);
}

#[test]
fn a_match_with_pins_on_the_card_ends_as_on_the_processor() {
    let Some(gpu) = card() else { return };
    let shapes = stars(5);
    let [mut truth, twin] = [(), ()].map(|()| tied(&shapes, &pins()));
    let mut assembler = GpuAssembler::new(gpu, twin);
    let (grid, start) = (truth.grid(), vec![0.0; truth.grid().node_count() * 2]);
    let mut expected = Newton::new(grid, start.clone(), SETTLED);
    let mut found = Resident::new(grid, start, SETTLED);
    let ends = [end(&mut found, &mut assembler), end(&mut expected, &mut truth)];
    // Without the pins' hessian it would creep.
    assert_eq!(ends[0].stop, ends[1].stop);
    let farthest = farthest(expected.displacement(), found.displacement()) * grid.cells() as f64;
    assert!(farthest < NEAR, "{farthest} cells apart");
}

#[test]
fn a_device_lost_between_iterations_leaves_a_match_to_the_processor() {
    let Some(gpu) = card() else { return };
    let shapes = stars(5);
    let mut truth = processor(&shapes);
    let grid = truth.grid();
    let expected = end(&mut Newton::new(grid, vec![0.0; grid.node_count() * 2], TOLERANCE), &mut truth);
    let mut assembler = GpuAssembler::new(gpu.clone(), processor(&shapes));
    let mut minimizer = resident(assembler.grid());
    for _ in 0..3 {
        assert_eq!(ready(minimizer.step(&mut assembler)).stop, None);
    }
    assert!(minimizer.displacement().iter().all(|&u| u == 0.0), "it was not read yet");
    gpu.destroy();
    let found = end(&mut minimizer, &mut assembler);
    assert_eq!(found.stop, expected.stop);
    let [a, b] = [found, expected].map(|progress| progress.evaluation.total());
    assert!((a - b).abs() < 1e-3 * b, "{a} is not {b}");
    let at_end = ready(truth.energy(minimizer.displacement()));
    assert_eq!(at_end, found.evaluation, "to the bit: it is the processor's");
    assert_eq!(assembler.backend(), "cpu: the graphics device was given up");
}

/// A match with a card of which something fails is the processor's, to the bit, and says why.
fn is_left_to_the_processor(limits: wgpu::Limits, why: &str) {
    let gpu = ready(Gpu::open_within(limits)).expect("a card with lower limits");
    let shapes = stars(5);
    let (mut truth, mut assembler) = (processor(&shapes), GpuAssembler::new(gpu, processor(&shapes)));
    let grid = truth.grid();
    let mut expected = Newton::new(grid, vec![0.0; grid.node_count() * 2], TOLERANCE);
    let mut found = resident(grid);
    assert_eq!(end(&mut found, &mut assembler).stop, end(&mut expected, &mut truth).stop);
    assert_eq!(found.displacement(), expected.displacement());
    let backend = assembler.backend();
    assert!(backend.starts_with("cpu: the graphics device failed") && backend.contains(why), "{backend}");
}

#[test]
fn a_card_that_refuses_memory_leaves_a_match_to_the_processor() {
    if card().is_some() {
        let least = wgpu::Limits { max_buffer_size: 4096, ..wgpu::Limits::default() };
        is_left_to_the_processor(least, "4096");
    }
}

#[test]
fn a_card_that_makes_no_kernel_leaves_a_match_to_the_processor() {
    if card().is_some() {
        let least = wgpu::Limits { max_compute_invocations_per_workgroup: 32, ..wgpu::Limits::default() };
        is_left_to_the_processor(least, "32");
    }
}

fn farthest(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The first step of a minimiser from `start`, by both.
fn steps_alike(gpu: &Rc<Gpu>, shapes: &[SignedDistance<2>; 2], start: &[f64]) {
    let (mut truth, mut assembler) = (processor(shapes), GpuAssembler::new(gpu.clone(), processor(shapes)));
    let mut expected = Newton::new(truth.grid(), start.to_vec(), TOLERANCE);
    let mut found = Resident::new(truth.grid(), start.to_vec(), TOLERANCE);
    let a = ready(expected.step(&mut truth)).evaluation.total();
    let b = ready(found.step(&mut assembler)).evaluation.total();
    assert!((a - b).abs() < 1e-4 * a, "{b} is not {a}");
    ready(found.fetch(&mut assembler)).expect("a card that answers");
    let farthest = farthest(expected.displacement(), found.displacement()) * truth.grid().cells() as f64;
    assert!(farthest < NEAR, "{farthest} cells apart");
}

#[test]
fn what_f32_cannot_decide_is_the_processors_affair() {
    let Some(gpu) = card() else { return };
    let shapes = stars(5);
    let grid = shapes[0].grid();
    // A node along the diagonal of the cell below it, whose determinant is then 0.005.
    let mut folding = vec![0.0; grid.node_count() * 2];
    folding[grid.node([9, 9]) * 2..][..2].fill(0.4975 * grid.spacing());
    steps_alike(&gpu, &shapes, &folding);
}

#[test]
fn a_displacement_of_many_cells_keeps_its_digits() {
    let Some(gpu) = card() else { return };
    let shapes = stars(5);
    let grid = shapes[0].grid();
    let mut assembler = GpuAssembler::new(gpu.clone(), processor(&shapes));
    // Far away as a whole, and hardly anywhere else: in f32 u has no more than its first five digits after the point, in
    // cells, and the determinants would have no more.
    let start: Vec<f64> = (0..grid.node_count() * 2).map(|k| 0.9 + 1e-7 * (k as f64).sin() * grid.spacing()).collect();
    let mut minimizer = Resident::new(grid, start, TOLERANCE);
    let progress = ready(minimizer.step(&mut assembler));
    ready(minimizer.fetch(&mut assembler)).expect("a card that answers");
    let expected = ready(processor(&shapes).energy(minimizer.displacement()));
    let (a, b) = (progress.evaluation.energies.volume, expected.energies.volume);
    assert!((a - b).abs() < ENERGY * b, "{a} is not {b}");
}
