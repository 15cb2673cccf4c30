//! Surfaces: kernels a cell, and whole matches: `cargo bench --bench solid [-- cells [part of a name]]`, 32 cells by default.

#[path = "../tests/common/clock.rs"]
mod clock;
#[path = "../tests/common/solids.rs"]
mod solids;

use clock::seconds;
use glam::{DQuat, DVec3};
use solids::{CENTRE, ellipsoid, mesh, octahedron, solid, sphere};
use std::hint::black_box;
use thinshell::assemble::{Assembler, CpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::multigrid::Multigrid;
use thinshell::ready::ready;
use thinshell::report::report;
use thinshell::search::Search;
use thinshell::settings::{Alignment, Settings};

/// Time that a kernel is repeated for.
const BUDGET_SECONDS: f64 = 0.5;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let cells = words.first().and_then(|word| word.parse().ok()).unwrap_or(32_usize);
    let wanted = words.get(1).cloned().unwrap_or_default();
    assert!(cells.is_power_of_two() && (8..=128).contains(&cells), "a power of two of cells, 8 to 128");
    let level = cells.ilog2();

    let pairs: [(&str, [SignedDistance<3>; 2]); 2] = [
        ("sphere → ellipsoid", [solid(level, sphere(0.22)), solid(level, ellipsoid([0.3, 0.24, 0.19]))]),
        (
            "octahedron by 30°",
            [DQuat::IDENTITY, DQuat::from_axis_angle(DVec3::Z, 30_f64.to_radians())]
                .map(|turn| solid(level, octahedron(0.33, turn))),
        ),
    ];
    println!("{:44} {:>10}   {:>9}", format!("{}³ nodes, processor time", cells + 1), "ms", "ns a cell");
    for (name, mut kernel) in kernels(level, &pairs[0].1) {
        if name.contains(&wanted) {
            kernel();
            let milliseconds = repeated(kernel);
            let share = milliseconds * 1e6 / Grid::<3>::new(cells).cell_count() as f64;
            println!("{name:44} {milliseconds:10.2}   {share:9.1}");
        }
    }
    println!("\n{:44} {:>10} {:>6} {:>9} {:>9} {:>6} {:>7}", "", "ms", "iter.", "mean h", "max h", "det", "turn °");
    for (name, shapes) in pairs {
        if name.contains(&wanted) {
            matched(name, level, &shapes);
        }
    }
}

/// Mean milliseconds.
fn repeated(mut run: impl FnMut()) -> f64 {
    let (begin, mut runs) = (seconds(), 0);
    while seconds() - begin < BUDGET_SECONDS {
        run();
        runs += 1;
    }
    (seconds() - begin) * 1e3 / f64::from(runs)
}

/// A smooth deformation on the way to the match.
fn displacement(grid: Grid<3>) -> Vec<f64> {
    (0..grid.node_count())
        .flat_map(|node| {
            let [x, y, z] = grid.position(node).map(|x| x - 0.5);
            [0.2 * x + 0.01 * (9.0 * y).sin(), 0.05 * y + 0.01 * (7.0 * z).cos(), -0.1 * z + 0.01 * (8.0 * x).sin()]
        })
        .collect()
}

type Kernels<'a> = Vec<(&'static str, Box<dyn FnMut() + 'a>)>;

fn kernels(level: u32, shapes: &[SignedDistance<3>; 2]) -> Kernels<'_> {
    let grid = Grid::<3>::of_level(level);
    let functional = Settings::default().thrifty_functional::<3>(level);
    let assembler = move || -> CpuAssembler<3> { CpuAssembler::new(&functional, &shapes[0], &shapes[1]) };
    let u = displacement(grid);
    let mut kernels: Kernels = Vec::new();
    let (mut own, at) = (assembler(), u.clone());
    kernels.push(("energy", Box::new(move || _ = black_box(ready(own.energy(&at))))));
    let (mut own, at, mut gradient) = (assembler(), u.clone(), vec![0.0; u.len()]);
    kernels.push(("energy + gradient", Box::new(move || _ = black_box(ready(own.gradient(&at, &mut gradient))))));
    let (mut own, at, mut gradient, mut multigrid) = (assembler(), u.clone(), vec![0.0; u.len()], Multigrid::new(grid));
    kernels.push((
        "energy + gradient + curvature",
        Box::new(move || _ = black_box(ready(own.hessian(&at, &mut gradient, multigrid.operator_mut())))),
    ));
    let prepared = move || {
        let (mut multigrid, mut gradient) = (Multigrid::new(grid), vec![0.0; u.len()]);
        ready(assembler().hessian(&u, &mut gradient, multigrid.operator_mut()));
        multigrid.prepare();
        (multigrid, gradient)
    };
    let (mut multigrid, gradient) = prepared();
    kernels.push((
        "coarse operators",
        Box::new({
            let (mut multigrid, _) = prepared();
            move || multigrid.prepare()
        }),
    ));
    let mut solution = vec![0.0; gradient.len()];
    kernels.push(("V-cycle", Box::new(move || multigrid.v_cycle(&gradient, &mut solution))));
    let (mut multigrid, gradient) = prepared();
    let mut vector = gradient.clone();
    kernels.push((
        "linear solve to 0.1",
        Box::new(move || {
            vector.copy_from_slice(&gradient);
            _ = black_box(multigrid.solve(&mut vector, 0.1, 40))
        }),
    ));
    // 8192 triangles, about as many as the meshes that people bring.
    let (positions, triangles) = mesh(5, |direction| {
        CENTRE + (0.27 + 0.05 * (5.0 * direction.x).sin() * direction.y + 0.04 * (9.0 * direction.z).cos()) * direction
    });
    kernels.push((
        "distance to a mesh",
        Box::new(move || {
            _ = black_box(SignedDistance::from_mesh(grid, &positions, &triangles).expect("a closed mesh"))
        }),
    ));
    kernels.push(("band and jets of a level", Box::new(move || _ = black_box(assembler().band_cells()))));
    kernels
}

/// One match from the identity to the finest level, without a search: what changes in it is the solver's.
fn matched(name: &str, level: u32, shapes: &[SignedDistance<3>; 2]) {
    let settings = Settings { coarsest: 3, finest: level, alignment: Alignment::None, ..Settings::default() };
    let mut iterations = 0;
    let mut end = None;
    let begin = seconds();
    let [reference, template] = shapes.clone();
    let mut search = ready(Search::new(reference, template, settings)).expect("valid settings");
    while end.is_none() {
        let progress = ready(search.step());
        iterations += 1;
        end = progress.stop.map(|_| progress);
    }
    let milliseconds = (seconds() - begin) * 1e3;
    let [reference, template] = search.shapes();
    let found = report(reference, template, search.displacement());
    println!(
        "{name:44} {milliseconds:10.0} {iterations:6} {:9.3} {:9.3} {:6.3} {:7.2}",
        found.mismatch.mean,
        found.mismatch.max,
        end.expect("the loop ends with one").evaluation.least_determinant,
        turn(search.grid(), search.displacement(), reference).to_degrees()
    );
}

/// The angle about z by which the shell is turned on average: the polar decomposition of its first moments.
fn turn(grid: Grid<3>, displacement: &[f64], reference: &SignedDistance<3>) -> f64 {
    let (mut cos, mut sin) = (0.0, 0.0);
    for (node, u) in displacement.chunks_exact(3).enumerate() {
        if reference.values()[node].abs() < 1.5 * grid.spacing() {
            let [x, y, _] = grid.position(node).map(|x| x - 0.5);
            let (moved_x, moved_y) = (x + u[0], y + u[1]);
            cos += x * moved_x + y * moved_y;
            sin += x * moved_y - y * moved_x;
        }
    }
    sin.atan2(cos)
}
