//! Operators to solve with, for tests.

use crate::common::{Random, apply, circle, ellipse};
use crate::solids::{ellipsoid, solid, sphere};
use thinshell::assemble::{Assembler, CpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::multigrid::Multigrid;
use thinshell::quadrature::Rule;
use thinshell::ready::ready;
use thinshell::settings::Settings;
use thinshell::stencil::StencilOperator;

/// The mass matrix plus β²/2 times the stiffness matrix, for each component by itself.
pub fn fill_sobolev<const D: usize>(operator: &mut StencilOperator<D>, beta: f64) {
    let grid = operator.grid();
    let (rule, h, offsets) = (Rule::<D, 3>::gauss3(), grid.spacing(), grid.corner_offsets());
    let neighbours = StencilOperator::<D>::corner_neighbours();
    operator.clear();
    for cell in 0..grid.cell_count() {
        let base = grid.lowest_node(cell);
        for a in 0..Grid::<D>::CORNERS {
            for b in a..Grid::<D>::CORNERS {
                let mut entry = 0.0;
                for point in 0..Rule::<D, 3>::POINTS {
                    let local: [f64; D] = std::array::from_fn(|axis| {
                        (0..Grid::<D>::CORNERS).map(|c| rule.shape[point][c] * (c >> axis & 1) as f64).sum()
                    });
                    let weights = thinshell::field::CornerWeights::at(&local);
                    let slopes: f64 =
                        (0..D).map(|k| weights.derivative[a][k] * weights.derivative[b][k] / (h * h)).sum();
                    entry += rule.weight[point] * (weights.value[a] * weights.value[b] + 0.5 * beta * beta * slopes);
                }
                let node = base + offsets[a];
                let diagonal = (entry * h.powi(D as i32)) as f32;
                let block = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { diagonal } else { 0.0 }));
                operator.add([node / grid.side(), node % grid.side()], neighbours[a][b], &block);
            }
        }
    }
}

pub fn noise(count: usize) -> Vec<f64> {
    let mut random = Random(17);
    (0..count).map(|_| random.between(-1.0, 1.0)).collect()
}

pub fn energy_norm<const D: usize>(operator: &StencilOperator<D>, x: &[f64]) -> f64 {
    apply(operator, x).iter().zip(x).map(|(a, b)| a * b).sum::<f64>().sqrt()
}

pub fn curves(level: u32) -> [SignedDistance<2>; 2] {
    [circle([0.5; 2], 0.15), ellipse([0.5; 2], 0.3, 0.2)]
        .map(|curve| SignedDistance::from_loops(Grid::of_level(level), &[curve]).expect("a valid curve"))
}

pub fn surfaces(level: u32) -> [SignedDistance<3>; 2] {
    [solid(level, sphere(0.2)), solid(level, ellipsoid([0.3, 0.22, 0.18]))]
}

/// The hessian of a pair under a stretch of the box, and the gradient there.
pub fn hessian<const D: usize>(level: u32, [reference, template]: [SignedDistance<D>; 2]) -> (Multigrid<D>, Vec<f64>) {
    let grid = Grid::<D>::of_level(level);
    let mut assembler: CpuAssembler<D> =
        CpuAssembler::new(&Settings::default().functional(level), &reference, &template);
    let displacement: Vec<f64> = (0..grid.node_count())
        .flat_map(|node| {
            let x: [f64; D] = grid.position(node);
            std::array::from_fn::<f64, D, _>(|k| [0.4, 0.3, 0.2][k] * (x[k] - 0.5))
        })
        .collect();
    let mut multigrid = Multigrid::new(grid);
    let mut gradient = vec![0.0; displacement.len()];
    let evaluation = ready(assembler.hessian(&displacement, &mut gradient, multigrid.operator_mut()));
    assert!(evaluation.is_admissible());
    multigrid.prepare();
    (multigrid, gradient)
}
