//! What a Newton iteration asks of a graphics card: `npm run bench -- gpu`, or
//! `cargo bench --profile dev --features gpu --bench card`. Counts, which are the same on every card; a processor may play it.
//! `npm run bench -- gpu 65` adds an iteration on 65³ nodes, which takes a processor minutes.

#[path = "../tests/common/mod.rs"]
mod common;
#[path = "kernels/operations.rs"]
mod operations;
#[path = "../src/assemble/shaders.rs"]
#[allow(dead_code, reason = "tests of its own")]
mod shaders;
#[path = "../tests/common/solids.rs"]
mod solids;
#[path = "kernels/values.rs"]
mod values;

use common::star;
use glam::DQuat;
use operations::Kernels;
use solids::{octahedron, solid};
use std::rc::Rc;
use thinshell::assemble::{Assembler, Counts, CpuAssembler, Gpu, GpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::energy::{BendingModel, Functional, GRADIENT, HESSIAN, Material, MembraneModel, VALUE};
use thinshell::grid::Grid;
use thinshell::minimize::{Minimizer, Resident};
use thinshell::ready::ready;
use thinshell::settings::Settings;
use thinshell::stencil::StencilOperator;

/// What a dispatch costs in a browser: 24 to 71 µs (arXiv 2604.02344).
const DISPATCH_MILLIS: f64 = 0.05;
const ITERATIONS: usize = 6;

fn main() -> Result<(), String> {
    let gpu = ready(Gpu::open())?;
    eprintln!("{}", gpu.name());
    println!("| grid | iterations | readbacks, at most | bytes read, at most | dispatches | at 50 µs each |");
    println!("|---|---|---|---|---|---|");
    for level in [5, 6, 7] {
        let shape = |curve| SignedDistance::from_loops(Grid::of_level(level), &[curve]).expect("a valid curve");
        let curves = [star([0.5; 2], 0.2, 5, 0.1, 0.0), star([0.52, 0.49], 0.24, 5, 0.15, 0.1)];
        count(&gpu, &curves.map(shape), ITERATIONS);
    }
    let octahedra = |level| [0.0, 0.2].map(|angle| solid(level, octahedron(0.3, DQuat::from_rotation_z(angle))));
    count(&gpu, &octahedra(4), ITERATIONS);
    if std::env::args().any(|argument| argument == "65") {
        count(&gpu, &octahedra(6), 1);
    }
    tell_operations(&octahedra(FINE));
    Ok(())
}

/// The level of which operations are counted: 65³ nodes.
const FINE: u32 = 6;
/// Nodes that are looked at, evenly among all; cells do the same everywhere.
const SAMPLES: usize = 97;
/// Operations a nanosecond of an Apple M1 and an NVIDIA RTX 3060.
const SPEEDS: [f64; 2] = [2600.0, 12700.0];

/// Prints the operations of each kernel on a fine level.
fn tell_operations([reference, template]: &[SignedDistance<3>; 2]) {
    let (grid, functional) = (reference.grid(), Settings::default().thrifty_functional::<3>(FINE));
    let band = CpuAssembler::<3>::new(&functional, reference, template).band_cells();
    let (cells, nodes, half) = (grid.cell_count(), grid.node_count(), StencilOperator::<3>::HALF);
    let coarse = Grid::<3>::new(grid.cells() / 2);
    let mut kernels = Kernels::new(&shaders::source::<3>());
    let [side, coarse_side] = [grid, coarse].map(|grid| grid.side() as f64);
    let Material { lambda, mu } = functional.material;
    let level = [side - 1.0, side, 1.0, 1.0, 1.0, functional.tangency, models(&functional)[0], models(&functional)[1]];
    let rest = [lambda, mu, functional.vertex_share, functional.gauss_points as f64];
    kernels.set("level", &[&level[..], &rest].concat());
    kernels.set("slab", &[0.0, cells as f64, 0.0, side - 1.0, band as f64, 0.0, 0.0]);
    kernels.set("place", &[side, 0.0, coarse_side, nodes as f64, 0.0, 0.01]);
    kernels.set("trial", &[1.0]);
    println!("\n{}³ nodes, {band} of {cells} cells in the band:\n", grid.side());
    println!("| kernel | invocations | operations of each | of all | M1 | RTX 3060 |");
    println!("|---|---|---|---|---|---|");
    let tell = |entry, order, count: usize, samples: usize| {
        let invocations = (0..samples).map(|sample| (2 * sample + 1) * count / (2 * samples));
        let each = invocations.map(|number| kernels.operations(entry, order, number)).sum::<u64>() as f64;
        let (each, order) = (each / samples as f64, ["", ", with gradient", ""][usize::from(order)]);
        let all = each * count as f64;
        let [slow, fast] = SPEEDS.map(|speed| all / speed / 1e6);
        println!("| `{entry}`{order} | {count} | {each:.0} | {:.3} G | {slow:.3} ms | {fast:.3} ms |", all / 1e9);
    };
    for order in [VALUE, GRADIENT] {
        tell("volume_cells", order, cells, 1);
        tell("shell_cells", order, band, 1);
    }
    tell("volume_pairs", HESSIAN, cells, 1);
    tell("shell_pairs", HESSIAN, band, 1);
    for (entry, count) in [
        ("place_nodes", nodes),
        ("gather_gradient", nodes),
        ("gather_stencil", nodes * half),
        ("coarsen", coarse.node_count() * half),
        ("invert_diagonal", nodes),
        ("sweep", coarse.node_count()),
        ("leave_residual", nodes),
        ("restrict_residual", coarse.node_count()),
        ("prolongate", nodes),
        ("apply", nodes),
        ("advance", nodes * 3),
    ] {
        tell(entry, VALUE, count, SAMPLES);
    }
}

/// As the shaders have them.
fn models(functional: &Functional) -> [f64; 2] {
    let projected = functional.membrane_model == MembraneModel::Projected;
    let mean = functional.bending_model == BendingModel::MeanCurvature;
    [projected, mean].map(|is| f64::from(u8::from(is)))
}

/// Prints the row of the first iterations on a level.
fn count<const D: usize>(gpu: &Rc<Gpu>, [reference, template]: &[SignedDistance<D>; 2], iterations: usize) {
    let grid = reference.grid();
    let functional = Settings::default().thrifty_functional::<D>(grid.cells().ilog2());
    let mut assembler = GpuAssembler::new(gpu.clone(), CpuAssembler::new(&functional, reference, template));
    assert_eq!(assembler.grid(), grid);
    let mut minimizer = Resident::new(grid, vec![0.0; grid.node_count() * D], 0.0);
    let mut counts: Vec<Counts> = Vec::new();
    for _ in 0..iterations {
        let before = gpu.counts();
        let progress = ready(minimizer.step(&mut assembler));
        if progress.stop.is_some() {
            break;
        }
        counts.push(gpu.counts().since(before));
    }
    let readbacks = counts.iter().map(|count| count.readbacks).max().unwrap_or(0);
    let bytes = counts.iter().map(|count| count.bytes_read).max().unwrap_or(0);
    let dispatches = counts.iter().map(|count| count.dispatches).sum::<usize>() / counts.len().max(1);
    println!(
        "| {}{} | {} | {readbacks} | {bytes} | {dispatches} | {:.1} ms |",
        grid.side(),
        if D == 2 { "²" } else { "³" },
        counts.len(),
        dispatches as f64 * DISPATCH_MILLIS
    );
}
