//! The assembled second derivative against the gradient, in both dimensions.

mod common;

use common::{Random, apply};
use thinshell::assemble::{Assembler, CpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::energy::{BendingModel, Functional, MembraneModel};
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::settings::Settings;
use thinshell::stencil::StencilOperator;

/// An ellipsoid-like level set, smooth where the band is.
fn shape<const D: usize>(level: u32) -> SignedDistance<D> {
    let grid = Grid::<D>::of_level(level);
    let value = |x: [f64; D]| {
        let stretched = (0..D).map(|k| ((x[k] - 0.5) * if k == 0 { 0.8 } else { 1.0 }).powi(2)).sum::<f64>();
        stretched.sqrt() - 0.25
    };
    SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|node| value(grid.position(node))).collect())
}

fn norm(a: &[f64]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// H d and (∇E(u + εd) − ∇E(u − εd)) / 2ε.
fn both<const D: usize>(
    functional: &Functional,
    shapes: [&SignedDistance<D>; 2],
    u: &[f64],
    d: &[f64],
) -> [Vec<f64>; 2] {
    let mut assembler: CpuAssembler<D> = CpuAssembler::new(functional, shapes[0], shapes[1]);
    let mut operator = StencilOperator::zero(shapes[0].grid());
    let mut gradient = vec![0.0; u.len()];
    ready(assembler.hessian(u, &mut gradient, &mut operator));
    let step = 1e-5 / d.iter().fold(0.0_f64, |most, x| most.max(x.abs())) * shapes[0].grid().spacing();
    let [ahead, behind] = [step, -step].map(|step| {
        let moved: Vec<f64> = u.iter().zip(d).map(|(u, d)| u + step * d).collect();
        let mut gradient = vec![0.0; u.len()];
        ready(assembler.gradient(&moved, &mut gradient));
        gradient
    });
    let quotient = ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * step)).collect();
    [apply(&operator, d), quotient]
}

/// A shape against itself at the identity: no residual, nothing clipped, and Gauss points exact for all terms.
fn is_exact_at_zero_residual<const D: usize>(level: u32, change: impl Fn(&mut Functional)) {
    let shape = shape::<D>(level);
    let mut functional = Functional { vertex_share: 0.0, ..Settings::default().functional(level) };
    change(&mut functional);
    let count = shape.grid().node_count() * D;
    let mut random = Random(23);
    for _ in 0..3 {
        let d: Vec<f64> = (0..count).map(|_| random.between(-1.0, 1.0)).collect();
        let [found, expected] = both(&functional, [&shape, &shape], &vec![0.0; count], &d);
        let error: Vec<f64> = found.iter().zip(&expected).map(|(a, b)| a - b).collect();
        // The operator is f32, the quotient of order ε²; a wrong factor in any term is far beyond.
        assert!(norm(&error) < 1e-4 * norm(&expected), "{} of {}", norm(&error), norm(&expected));
    }
}

#[test]
fn at_zero_residual_the_operator_is_the_derivative_of_the_gradient() {
    type Change = fn(&mut Functional);
    // Each term alone with next to no volume energy, so that none hides behind another; then all together.
    let alone: [Change; 6] = [
        |f| (f.bending, f.penalty, f.volume) = (0.0, 1e-9, 1e-12),
        |f| (f.bending, f.penalty, f.volume, f.membrane_model) = (0.0, 1e-9, 1e-12, MembraneModel::Projected),
        |f| (f.membrane, f.penalty, f.volume) = (0.0, 1e-9, 1e-12),
        |f| (f.membrane, f.penalty, f.volume, f.bending_model) = (0.0, 1e-9, 1e-12, BendingModel::MeanCurvature),
        |f| (f.membrane, f.bending, f.tangency, f.volume) = (0.0, 0.0, 0.0, 1e-12),
        |f| (f.membrane, f.bending, f.volume, f.tangency) = (0.0, 0.0, 1e-12, 10.0),
    ];
    for change in alone {
        is_exact_at_zero_residual::<2>(5, change);
        is_exact_at_zero_residual::<3>(4, change);
    }
    is_exact_at_zero_residual::<2>(5, |f| (f.membrane, f.bending, f.penalty) = (0.0, 0.0, 1e-12));
    is_exact_at_zero_residual::<3>(4, |f| (f.membrane, f.bending, f.penalty) = (0.0, 0.0, 1e-12));
    is_exact_at_zero_residual::<2>(5, |_| ());
    is_exact_at_zero_residual::<3>(4, |_| ());
    is_exact_at_zero_residual::<3>(4, |f| f.gauss_points = 2);
}

/// Where one corner is about to fold, the energy's second derivative along its determinant's gradient is known to the
/// operator within a factor of two; by Gauss points alone it is too small by orders of magnitude.
fn folding_corners_are_seen<const D: usize>() {
    let shape = shape::<D>(4);
    let grid = shape.grid();
    let functional = Functional { membrane: 0.0, bending: 0.0, penalty: 1e-12, ..Settings::default().functional(4) };
    let count = grid.node_count() * D;
    let corner = grid.node([8; D]);
    // The corner is pushed along the diagonal of its cell, so that the determinant there is 0.08.
    let mut u = vec![0.0; count];
    let push = (1.0 - 0.08) / D as f64 * grid.spacing();
    u[corner * D..][..D].fill(push);
    let mut d = vec![0.0; count];
    d[corner * D..][..D].fill(1.0);
    let [found, expected] = both(&functional, [&shape, &shape], &u, &d);
    let along = |h: &[f64]| h.iter().zip(&d).map(|(a, b)| a * b).sum::<f64>();
    let ratio = along(&found) / along(&expected);
    assert!((0.5..2.0).contains(&ratio), "{ratio}");
}

#[test]
fn the_operator_sees_folding_corners() {
    folding_corners_are_seen::<2>();
    folding_corners_are_seen::<3>();
}
