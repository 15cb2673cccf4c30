//! What a Newton iteration asks of a graphics card: `npm run bench -- gpu`, or
//! `cargo bench --profile dev --features gpu --bench card`. Counts, which are the same on every card; a processor may play it.

#[path = "../tests/common/mod.rs"]
mod common;
#[path = "../tests/common/solids.rs"]
mod solids;

use common::star;
use glam::DQuat;
use solids::{octahedron, solid};
use std::rc::Rc;
use thinshell::assemble::{Assembler, Counts, CpuAssembler, Gpu, GpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::minimize::{Minimizer, Resident};
use thinshell::ready::ready;
use thinshell::settings::Settings;

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
        count(&gpu, &[shape(star([0.5; 2], 0.2, 5, 0.1, 0.0)), shape(star([0.52, 0.49], 0.24, 5, 0.15, 0.1))]);
    }
    count(&gpu, &[0.0, 0.2].map(|angle| solid(4, octahedron(0.3, DQuat::from_rotation_z(angle)))));
    Ok(())
}

/// Prints the row of the first iterations on a level.
fn count<const D: usize>(gpu: &Rc<Gpu>, [reference, template]: &[SignedDistance<D>; 2]) {
    let grid = reference.grid();
    let functional = Settings::default().thrifty_functional::<D>(grid.cells().ilog2());
    let mut assembler = GpuAssembler::new(gpu.clone(), CpuAssembler::new(&functional, reference, template));
    assert_eq!(assembler.grid(), grid);
    let mut minimizer = Resident::new(grid, vec![0.0; grid.node_count() * D], 0.0);
    let mut counts: Vec<Counts> = Vec::new();
    for _ in 0..ITERATIONS {
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
