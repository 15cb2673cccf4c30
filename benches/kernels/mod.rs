//! The kernels that `cargo bench` times natively and `npm run bench` in the browser: the same code, the same input.

#![allow(dead_code, reason = "each benchmark uses a part")]

#[path = "../../tests/common/mod.rs"]
pub mod shapes;

use glam::DVec2;
use thinshell::assemble::{Assembler, CpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::metric::SobolevMetric;
use thinshell::minimize::{Minimizer, Ncg, Newton};
use thinshell::multigrid::Multigrid;
use thinshell::prolongation::prolongate;
use thinshell::ready::ready;
use thinshell::search::Search;
use thinshell::settings::Settings;
use thinshell::small::{F64x2, Scalar};

/// Something to be timed, and the number of cells its time is shared among.
pub struct Kernel {
    pub name: String,
    pub cells: usize,
    pub run: Box<dyn FnMut()>,
}

impl Kernel {
    fn new(name: impl Into<String>, cells: usize, run: impl FnMut() + 'static) -> Self {
        Self { name: name.into(), cells, run: Box::new(run) }
    }
}

const LEVEL: u32 = 7;
const CENTRE: [f64; 2] = [0.5, 0.5];

/// Circle → ellipse, star → rotated star, and a pair of leaves.
pub fn pairs() -> [(&'static str, [Vec<DVec2>; 2]); 3] {
    [
        ("circle → ellipse", [shapes::circle(CENTRE, 0.15), shapes::ellipse(CENTRE, 0.45, 0.25)]),
        ("star → rotated star", [shapes::star(CENTRE, 0.25, 5, 0.25, 0.0), shapes::star(CENTRE, 0.25, 5, 0.25, 0.35)]),
        ("leaf → leaf", [shapes::leaf(CENTRE, 0.2, 0.12, 0.0), shapes::leaf(CENTRE, 0.2, 0.22, 0.3)]),
    ]
}

pub fn distances(level: u32, pair: &[Vec<DVec2>; 2]) -> [SignedDistance<2>; 2] {
    [0, 1].map(|k| {
        SignedDistance::from_loops(Grid::of_level(level), std::slice::from_ref(&pair[k])).expect("a valid curve")
    })
}

/// Where the kernels are evaluated: a smooth deformation on the way to the match.
pub fn displacement(grid: Grid<2>) -> Vec<f64> {
    (0..grid.node_count())
        .flat_map(|node| {
            let [x, y] = grid.position(node);
            [0.8 * (x - 0.5) + 0.01 * (9.0 * y).sin(), 0.4 * (y - 0.5) + 0.01 * (7.0 * x).cos()]
        })
        .collect()
}

fn assembler<S: Scalar>(level: u32) -> CpuAssembler<2, S> {
    let [reference, template] = distances(level, &pairs()[0].1);
    CpuAssembler::new(&Settings::default().functional(level), &reference, &template)
}

fn energy_and_gradient<S: Scalar>(name: &str) -> Kernel {
    let grid = Grid::<2>::of_level(LEVEL);
    let (mut assembler, u) = (assembler::<S>(LEVEL), displacement(grid));
    let mut gradient = vec![0.0; u.len()];
    Kernel::new(name, grid.cell_count(), move || {
        std::hint::black_box(ready(assembler.gradient(&u, &mut gradient)));
    })
}

fn with_hessian<S: Scalar>(name: &str) -> Kernel {
    let grid = Grid::<2>::of_level(LEVEL);
    let (mut assembler, u) = (assembler::<S>(LEVEL), displacement(grid));
    let mut gradient = vec![0.0; u.len()];
    let mut multigrid = Multigrid::new(grid);
    Kernel::new(name, grid.cell_count(), move || {
        std::hint::black_box(ready(assembler.hessian(&u, &mut gradient, multigrid.operator_mut())));
    })
}

/// A hierarchy over a real hessian, with the gradient.
fn hessian(level: u32) -> (Multigrid<2>, Vec<f64>) {
    let grid = Grid::<2>::of_level(level);
    let (mut assembler, u) = (assembler::<F64x2>(level), displacement(grid));
    let mut gradient = vec![0.0; u.len()];
    let mut multigrid = Multigrid::new(grid);
    ready(assembler.hessian(&u, &mut gradient, multigrid.operator_mut()));
    multigrid.prepare();
    (multigrid, gradient)
}

fn newton_iteration(level: u32) -> Kernel {
    let grid = Grid::<2>::of_level(level);
    let (mut assembler, u) = (assembler::<F64x2>(level), displacement(grid));
    let mut minimizer = Newton::new(grid, u, 1e-14);
    let side = grid.side();
    // Always the first iteration from the same place, so that every run does the same.
    Kernel::new(format!("one Newton iteration at {side}²"), grid.cell_count(), move || {
        minimizer.restart(displacement(grid));
        std::hint::black_box(ready(minimizer.step(&mut assembler)));
    })
}

fn cascade(name: &str, pair: [Vec<DVec2>; 2]) -> Kernel {
    Kernel::new(format!("cascade 17² → 129², {name}"), 1, move || {
        let [reference, template] = distances(LEVEL, &pair);
        let mut cascade = ready(Search::new(reference, template, Settings::default())).expect("valid settings");
        while ready(cascade.step()).stop.is_none() {}
    })
}

/// Relative energy gap of the race between the minimisers.
pub const GAP: f64 = 1e-3;

/// The solution at 65², interpolated to 129².
pub fn start_from_65(pair: &[Vec<DVec2>; 2]) -> Vec<f64> {
    let settings = Settings { finest: 6, ..Settings::default() };
    let [reference, template] = distances(6, pair);
    let mut cascade = ready(Search::new(reference, template, settings)).expect("valid settings");
    while ready(cascade.step()).stop.is_none() {}
    prolongate(cascade.grid(), cascade.displacement())
}

pub fn assembler_of(shapes: &[SignedDistance<2>; 2]) -> CpuAssembler<2> {
    CpuAssembler::new(&Settings::default().functional(LEVEL), &shapes[0], &shapes[1])
}

/// The least energy that either minimiser reaches with a tight tolerance.
pub fn lowest(shapes: &[SignedDistance<2>; 2], start: &[f64]) -> f64 {
    let mut assembler = assembler_of(shapes);
    let grid = Grid::of_level(LEVEL);
    let mut newton = Newton::new(grid, start.to_vec(), 1e-10);
    let mut ncg = Ncg::new(grid, start.to_vec(), 0.5, 1e-8);
    let newton = loop {
        let progress = ready(newton.step(&mut assembler));
        if progress.stop.is_some() {
            break progress.evaluation.total();
        }
    };
    let ncg = loop {
        let progress = ready(ncg.step(&mut assembler));
        if progress.stop.is_some() {
            break progress.evaluation.total();
        }
    };
    newton.min(ncg)
}

/// From the 65² solution at 129² until the energy is within the gap of the least. The first run finds both.
fn race<M: Minimizer<2>>(name: String, pair: [Vec<DVec2>; 2], make: impl Fn(Vec<f64>) -> M + 'static) -> Kernel {
    let mut prepared = None;
    Kernel::new(name, 1, move || {
        let (assembler, start, least) = prepared.get_or_insert_with(|| {
            let shapes = distances(LEVEL, &pair);
            let start = start_from_65(&pair);
            let least = lowest(&shapes, &start);
            (assembler_of(&shapes), start, least)
        });
        let mut minimizer = make(start.clone());
        while ready(minimizer.step(assembler)).evaluation.total() > *least * (1.0 + GAP) {}
    })
}

/// All kernels, most of them on circle → ellipse at 129².
pub fn kernels() -> Vec<Kernel> {
    let grid = Grid::<2>::of_level(LEVEL);
    let cells = grid.cell_count();
    let mut kernels = vec![
        energy_and_gradient::<F64x2>("energy + gradient"),
        energy_and_gradient::<f64>("energy + gradient, one lane"),
        with_hessian::<F64x2>("energy + gradient + hessian"),
        with_hessian::<f64>("energy + gradient + hessian, one lane"),
    ];
    let (mut assembler, u) = (assembler::<F64x2>(LEVEL), displacement(grid));
    kernels.push(Kernel::new("energy", cells, move || {
        std::hint::black_box(ready(assembler.energy(&u)));
    }));
    let [reference, template] = distances(LEVEL, &pairs()[0].1);
    kernels.push(Kernel::new("band and jets of a level", cells, move || {
        let functional = Settings::default().functional(LEVEL);
        let assembler: CpuAssembler<2> = CpuAssembler::new(&functional, &reference, &template);
        std::hint::black_box(assembler.band_cells());
    }));
    let (mut multigrid, gradient) = hessian(LEVEL);
    let mut solution = vec![0.0; gradient.len()];
    kernels.push(Kernel::new("V-cycle", cells, move || multigrid.v_cycle(&gradient, &mut solution)));
    let (mut multigrid, gradient) = hessian(LEVEL);
    let mut vector = gradient.clone();
    kernels.push(Kernel::new("linear solve to 0.1", cells, move || {
        vector.copy_from_slice(&gradient);
        std::hint::black_box(multigrid.solve(&mut vector, 0.1, 40));
    }));
    let (mut multigrid, _) = hessian(LEVEL);
    kernels.push(Kernel::new("coarse operators", cells, move || multigrid.prepare()));
    let (mut metric, start) = (SobolevMetric::<2>::new(grid), displacement(grid));
    let mut field = start.clone();
    kernels.push(Kernel::new("metric solve", cells, move || {
        field.copy_from_slice(&start);
        metric.solve(0.1, &mut field);
    }));
    let polygon = [shapes::star(CENTRE, 0.25, 5, 0.25, 0.0)];
    kernels.push(Kernel::new("signed distance of 512 points", 1, move || {
        std::hint::black_box(SignedDistance::from_loops(grid, &polygon).expect("a valid curve"));
    }));
    kernels.push(newton_iteration(7));
    kernels.push(newton_iteration(9));
    for (name, pair) in pairs() {
        let of = |method: &str| format!("to a gap of 1e-3, {method}, {name}");
        kernels.push(race(of("newton"), pair.clone(), move |start| Newton::new(grid, start, 1e-12)));
        kernels.push(race(of("ncg"), pair.clone(), move |start| Ncg::new(grid, start, 0.5, 1e-12)));
        kernels.push(cascade(name, pair));
    }
    kernels
}
