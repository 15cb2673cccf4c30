//! Energies and gradients agree with an independent implementation of the same discretisation.
//!
//! The files in `fixtures/` carry their conventions inside (key `conventions`); each term's energy is to agree to
//! 1e-10 relative, each gradient entry to 1e-9 absolute.

use serde::Deserialize;
use thinshell::assemble::{Assembler, CpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::energy::{BendingModel, Cutoff, Energies, Functional, Material, MembraneModel};
use thinshell::field::quadratic_fit;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::small::{F64x2, Scalar};

#[derive(Deserialize)]
struct Params {
    a_mem: f64,
    a_bend: f64,
    delta: f64,
    inv_eps: f64,
    xi: f64,
    lambda: f64,
    mu: f64,
    sigma: f64,
    eta: u32,
    fit_r: f64,
    zeta: f64,
    theta: f64,
}

#[derive(Deserialize)]
struct TermEnergies {
    mem: f64,
    bend: f64,
    sbend: f64,
    mis: f64,
    vol: f64,
}

#[derive(Deserialize)]
struct TermGradients {
    mem: Vec<f64>,
    bend: Vec<f64>,
    sbend: Vec<f64>,
    mis: Vec<f64>,
    vol: Vec<f64>,
    total: Vec<f64>,
}

#[derive(Deserialize)]
struct Fixture {
    n: usize,
    dim: usize,
    params: Params,
    d1: Vec<f64>,
    d2: Vec<f64>,
    u: Vec<f64>,
    energies: TermEnergies,
    gradient_terms: TermGradients,
    grad_d1: Vec<f64>,
    hess_d1: Vec<f64>,
    min_det_corner: f64,
}

fn load<const D: usize>(text: &str) -> Fixture {
    let fixture: Fixture = serde_json::from_str(text).unwrap();
    assert_eq!(fixture.dim, D);
    fixture
}

fn functional(params: &Params) -> Functional {
    Functional {
        membrane: params.a_mem,
        membrane_model: MembraneModel::Intrinsic,
        bending: params.a_bend,
        bending_model: BendingModel::ShapeOperator,
        thickness: params.delta,
        penalty: params.inv_eps,
        tangency: 0.0,
        volume: params.xi,
        softness: params.zeta,
        material: Material { lambda: params.lambda, mu: params.mu },
        bandwidth: params.sigma,
        cutoff: [Cutoff::Quartic, Cutoff::Cosine, Cutoff::Bump][params.eta as usize],
        fit_radius: params.fit_r,
        vertex_share: params.theta,
        gauss_points: 3,
    }
}

fn check_gradient(name: &str, found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (k, (a, b)) in found.iter().zip(expected).enumerate() {
        assert!((a - b).abs() <= 1e-9, "{name}[{k}]: {a} against {b}");
    }
}

fn check_energy(name: &str, found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-10 * expected.abs(), "{name}: {found} against {expected}");
}

fn agrees<const D: usize, S: Scalar>(text: &str) {
    let fixture = load::<D>(text);
    let grid = Grid::<D>::new(fixture.n);
    let fit = quadratic_fit(grid, &fixture.d1, fixture.params.fit_r);
    let gradients: Vec<f64> = fit.iter().flat_map(|jet| jet.gradient).collect();
    let curvatures: Vec<f64> = fit.iter().flat_map(|jet| jet.curvature.into_iter().flatten()).collect();
    check_gradient("fitted gradient", &gradients, &fixture.grad_d1);
    check_gradient("fitted curvature", &curvatures, &fixture.hess_d1);

    let reference = SignedDistance::from_nodal(grid, fixture.d1.clone());
    let template = SignedDistance::from_nodal(grid, fixture.d2.clone());
    let functional = functional(&fixture.params);
    let only = |functional: Functional| {
        let mut gradient = vec![0.0; fixture.u.len()];
        let mut assembler = CpuAssembler::<D, S>::new(&functional, &reference, &template);
        let evaluation = ready(assembler.gradient(&fixture.u, &mut gradient));
        assert_eq!(ready(assembler.energy(&fixture.u)), evaluation, "value alone and with derivative are one number");
        assert!((evaluation.least_determinant - fixture.min_det_corner).abs() < 1e-12);
        (evaluation.energies, gradient)
    };
    let none = Functional { membrane: 0.0, bending: 0.0, penalty: 0.0, volume: 0.0, ..functional };

    let (energies, gradient) = only(functional);
    let Energies { membrane, bending, mismatch, volume, .. } = energies;
    check_energy("membrane", membrane, fixture.energies.mem);
    check_energy("bending", bending, fixture.energies.bend);
    check_energy("mismatch", mismatch, fixture.energies.mis);
    check_energy("volume", volume, fixture.energies.vol);
    check_gradient("total", &gradient, &fixture.gradient_terms.total);

    let terms = &fixture.gradient_terms;
    check_gradient("membrane", &only(Functional { membrane: functional.membrane, ..none }).1, &terms.mem);
    check_gradient("bending", &only(Functional { bending: functional.bending, ..none }).1, &terms.bend);
    check_gradient("mismatch", &only(Functional { penalty: functional.penalty, ..none }).1, &terms.mis);
    check_gradient("volume", &only(Functional { volume: functional.volume, ..none }).1, &terms.vol);
    let simple = Functional { bending: functional.bending, bending_model: BendingModel::MeanCurvature, ..none };
    let (energies, gradient) = only(simple);
    check_energy("mean curvature", energies.bending, fixture.energies.sbend);
    check_gradient("mean curvature", &gradient, &terms.sbend);
}

#[test]
fn a_circle_on_9_nodes_agrees() {
    agrees::<2, F64x2>(include_str!("fixtures/fx2d_9_circle.json"));
    agrees::<2, f64>(include_str!("fixtures/fx2d_9_circle.json"));
}

#[test]
fn a_rounded_square_on_17_nodes_agrees() {
    agrees::<2, F64x2>(include_str!("fixtures/fx2d_17_rbox.json"));
    agrees::<2, f64>(include_str!("fixtures/fx2d_17_rbox.json"));
}

#[test]
fn a_sphere_on_5_nodes_agrees() {
    agrees::<3, F64x2>(include_str!("fixtures/fx3d_5_sphere.json"));
    agrees::<3, f64>(include_str!("fixtures/fx3d_5_sphere.json"));
}
