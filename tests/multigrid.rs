//! The multigrid cycle as a theorem: symmetric, and converging at a rate that does not depend on the level.

mod common;
#[path = "common/operators.rs"]
mod operators;
#[path = "common/solids.rs"]
mod solids;

use common::{apply, leaf};
use operators::{curves, energy_norm, fill_sobolev, hessian, noise, surfaces};
use thinshell::assemble::{Assembler, CpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::multigrid::Multigrid;
use thinshell::ready::ready;
use thinshell::settings::Settings;
use thinshell::stencil::StencilOperator;

/// The factor by which one cycle reduces the error in the energy norm, after the first cycles.
fn contraction<const D: usize>(multigrid: &mut Multigrid<D>, grid: Grid<D>) -> f64 {
    let operator = multigrid.operator_mut().clone();
    let mut error = noise(grid.node_count() * D);
    let mut correction = vec![0.0; error.len()];
    let mut factor = 0.0;
    for _ in 0..8 {
        let before = energy_norm(&operator, &error);
        multigrid.v_cycle(&apply(&operator, &error), &mut correction);
        error.iter_mut().zip(&correction).for_each(|(e, c)| *e -= c);
        let after = energy_norm(&operator, &error);
        factor = after / before;
        // f32 inside the cycle: scaled back, the error never meets rounding.
        error.iter_mut().for_each(|e| *e /= after);
    }
    factor
}

fn sobolev_factor<const D: usize>(cells: usize, beta: f64) -> f64 {
    let grid = Grid::<D>::new(cells);
    let mut multigrid = Multigrid::new(grid);
    fill_sobolev(multigrid.operator_mut(), beta);
    multigrid.prepare();
    contraction(&mut multigrid, grid)
}

#[test]
fn the_sobolev_operator_converges_by_a_factor_below_a_fifth_on_every_level() {
    for cells in [8, 16, 32, 64, 128] {
        for beta in [0.1, 1.0] {
            let factor = sobolev_factor::<2>(cells, beta);
            assert!(factor < 0.2, "{cells} cells, β = {beta}: {factor}");
        }
    }
    for cells in [4, 8, 16] {
        let factor = sobolev_factor::<3>(cells, 1.0);
        assert!(factor < 0.2, "{cells}³ cells: {factor}");
    }
}

fn is_solved_in_a_few_steps<const D: usize>((mut multigrid, gradient): (Multigrid<D>, Vec<f64>), what: &str) {
    let mut solution = gradient.clone();
    let solve = multigrid.solve(&mut solution, 1e-2, 40);
    assert!(solve.iterations <= 8, "{what}: {solve:?}");
    let product: f64 = gradient.iter().zip(&solution).map(|(b, x)| b * x).sum();
    assert!((solve.product - product).abs() <= 1e-12 * product, "{what}: {product}, not {solve:?}");
    let operator = multigrid.operator_mut();
    let residual: f64 =
        apply(operator, &solution).iter().zip(&gradient).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let size = gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
    assert!(residual < 0.1 * size, "{what}: residual {residual} of {size}");
}

#[test]
fn real_hessians_are_solved_in_a_few_steps_on_every_level() {
    for level in [4, 5, 6, 7] {
        is_solved_in_a_few_steps(hessian(level, curves(level)), &format!("curves on level {level}"));
    }
    for level in [4, 5] {
        is_solved_in_a_few_steps(hessian(level, surfaces(level)), &format!("surfaces on level {level}"));
    }
}

fn is_symmetric<const D: usize>((mut multigrid, gradient): (Multigrid<D>, Vec<f64>)) {
    let count = gradient.len();
    let (a, b) = (noise(count), noise(count + 7)[7..].to_vec());
    let (mut from_a, mut from_b) = (vec![0.0; count], vec![0.0; count]);
    multigrid.v_cycle(&a, &mut from_a);
    multigrid.v_cycle(&b, &mut from_b);
    let product = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(p, q)| p * q).sum::<f64>();
    let (left, right) = (product(&b, &from_a), product(&a, &from_b));
    let size = (product(&a, &from_a) * product(&b, &from_b)).sqrt();
    assert!((left - right).abs() < 1e-4 * size, "D = {D}: {left} is not {right}, of {size}");
}

#[test]
fn the_cycle_is_symmetric() {
    is_symmetric(hessian(5, curves(5)));
    is_symmetric(hessian(4, surfaces(4)));
}

#[test]
fn the_hessian_is_symmetric_and_its_gradient_consistent() {
    // A leaf pair, off the minimum: H d is the derivative of the gradient up to the dropped part of the residual,
    // and symmetric to f32.
    let grid = Grid::<2>::of_level(4);
    let shape = |curve| SignedDistance::from_loops(grid, &[curve]).expect("a valid curve");
    let (reference, template) = (shape(leaf([0.5; 2], 0.2, 0.1, 0.0)), shape(leaf([0.5; 2], 0.21, 0.12, 0.1)));
    let mut assembler: CpuAssembler<2> = CpuAssembler::new(&Settings::default().functional(4), &reference, &template);
    let displacement = vec![0.0; grid.node_count() * 2];
    let mut gradient = displacement.clone();
    let mut operator = StencilOperator::zero(grid);
    ready(assembler.hessian(&displacement, &mut gradient, &mut operator));
    let (a, b) = (noise(displacement.len()), noise(displacement.len() + 3)[3..].to_vec());
    let product = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(p, q)| p * q).sum::<f64>();
    let (left, right) = (product(&a, &apply(&operator, &b)), product(&b, &apply(&operator, &a)));
    assert!((left - right).abs() < 1e-5 * left.abs().max(right.abs()), "{left} is not {right}");
    assert!(product(&a, &apply(&operator, &a)) > 0.0);
}
