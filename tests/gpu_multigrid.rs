//! The multigrid on the card against the processor's.

#[path = "common/card.rs"]
mod card;
mod common;
#[path = "common/operators.rs"]
mod operators;
#[path = "common/solids.rs"]
mod solids;

use card::card;
use common::apply;
use operators::{curves, energy_norm, fill_sobolev, hessian, noise, surfaces};
use std::rc::Rc;
use thinshell::assemble::{Gpu, GpuMultigrid};
use thinshell::grid::Grid;
use thinshell::multigrid::Multigrid;
use thinshell::ready::ready;
use thinshell::stencil::StencilOperator;

fn on_card<const D: usize>(gpu: &Rc<Gpu>, operator: &StencilOperator<D>, tolerance: f32) -> GpuMultigrid<D> {
    GpuMultigrid::new(gpu.clone(), operator, tolerance).expect("it fits")
}

/// The factor by which one cycle reduces the error in the energy norm, after the first cycles.
fn contraction<const D: usize>(gpu: &Rc<Gpu>, cells: usize) -> f64 {
    let mut operator = StencilOperator::zero(Grid::<D>::new(cells));
    fill_sobolev(&mut operator, 1.0);
    let multigrid = on_card(gpu, &operator, 0.0);
    let mut error = noise(operator.grid().node_count() * D);
    let mut correction = vec![0.0; error.len()];
    let mut factor = 0.0;
    for _ in 0..6 {
        let before = energy_norm(&operator, &error);
        ready(multigrid.v_cycle(&apply(&operator, &error), &mut correction)).expect("a card that answers");
        error.iter_mut().zip(&correction).for_each(|(e, c)| *e -= c);
        let after = energy_norm(&operator, &error);
        factor = after / before;
        error.iter_mut().for_each(|e| *e /= after);
    }
    factor
}

#[test]
fn a_cycle_on_the_card_converges_on_every_level_as_the_processors() {
    let Some(gpu) = card() else { return };
    for cells in [4, 8, 32, 64] {
        let factor = contraction::<2>(&gpu, cells);
        assert!(factor < 0.2, "{cells}² cells: {factor}");
    }
    for cells in [4, 16] {
        let factor = contraction::<3>(&gpu, cells);
        assert!(factor < 0.2, "{cells}³ cells: {factor}");
    }
}

fn is_symmetric<const D: usize>(gpu: &Rc<Gpu>, (mut processor, gradient): (Multigrid<D>, Vec<f64>)) {
    let multigrid = on_card(gpu, processor.operator_mut(), 0.0);
    let count = gradient.len();
    let (a, b) = (noise(count), noise(count + 7)[7..].to_vec());
    let (mut from_a, mut from_b) = (vec![0.0; count], vec![0.0; count]);
    ready(multigrid.v_cycle(&a, &mut from_a)).expect("a card that answers");
    ready(multigrid.v_cycle(&b, &mut from_b)).expect("a card that answers");
    let product = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(p, q)| p * q).sum::<f64>();
    let (left, right) = (product(&b, &from_a), product(&a, &from_b));
    let size = (product(&a, &from_a) * product(&b, &from_b)).sqrt();
    assert!((left - right).abs() < 1e-4 * size, "D = {D}: {left} is not {right}, of {size}");
}

#[test]
fn the_cycle_on_the_card_is_symmetric() {
    let Some(gpu) = card() else { return };
    is_symmetric(&gpu, hessian(5, curves(5)));
    is_symmetric(&gpu, hessian(4, surfaces(4)));
}

/// The same system to the same residual, in about as many steps.
fn is_solved_alike<const D: usize>(gpu: &Rc<Gpu>, (mut processor, gradient): (Multigrid<D>, Vec<f64>), what: &str) {
    for tolerance in [1e-1, 1e-3] {
        let operator = processor.operator_mut().clone();
        let mut solution = gradient.clone();
        let expected = processor.solve(&mut solution, f64::from(tolerance), 40);
        let multigrid = on_card(gpu, &operator, tolerance);
        let found = ready(multigrid.solve(&gradient, 24, &mut solution)).expect("a card that answers");
        let error: Vec<f64> = apply(&operator, &solution).iter().zip(&gradient).map(|(a, b)| a - b).collect();
        let norm = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let residual = norm(&error) / norm(&gradient);
        eprintln!("{what}, {tolerance}: {expected:?} {found:?} {residual}");
        assert!(residual <= 1.05 * f64::from(tolerance), "{what}: residual {residual}");
        assert!((found.relative_residual - residual).abs() < 0.05 * residual, "{what}: {found:?}, not {residual}");
        assert!(found.iterations <= expected.iterations + 2, "{what}: {found:?} for {expected:?}");
    }
}

#[test]
fn real_hessians_are_solved_on_the_card_as_on_the_processor() {
    let Some(gpu) = card() else { return };
    for level in [4, 6] {
        is_solved_alike(&gpu, hessian(level, curves(level)), &format!("curves on level {level}"));
    }
    is_solved_alike(&gpu, hessian(4, surfaces(4)), "surfaces");
}
