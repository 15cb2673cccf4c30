//! The initial deformation: several starts, ranked by the energy a few iterations reach on the coarsest level.

use crate::align::{boundary_measure, similarities};
use crate::assemble::Assembler;
use crate::distance::SignedDistance;
use crate::minimize::{Minimizer, Newton};
use crate::settings::Settings;

/// Similarities that are tried beside the identity.
const CANDIDATES: usize = 4;
/// Iterations for each: enough to tell a turned star from a folded one, which the first energy does not.
const TRIAL_ITERATIONS: usize = 10;
/// A shell compressed to less than this share of its size crumples rather than shrinks (the paper's Fig. 5).
const SHORTER: f64 = 0.9;

/// Is the one shape so much shorter than the other that the roles are better exchanged?
pub(super) fn is_shorter<const D: usize>(shape: &SignedDistance<D>, other: &SignedDistance<D>) -> bool {
    boundary_measure(shape) < SHORTER * boundary_measure(other)
}

/// The displacement that the best start reaches. `shapes` are the shell and its aim.
pub(super) async fn find<const D: usize>(
    assembler: &mut impl Assembler<D>,
    shapes: [&SignedDistance<D>; 2],
    settings: &Settings,
    evaluations: &mut usize,
) -> Vec<f64> {
    let grid = assembler.grid();
    let mut turned = Vec::new();
    for displacement in similarities(grid, shapes[0], shapes[1]) {
        turned.push((assembler.energy(&displacement).await.total(), displacement));
        *evaluations += 1;
    }
    let mut starts: Vec<(f64, Vec<f64>)> = minima(turned);
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    starts.truncate(CANDIDATES);
    starts.push((f64::INFINITY, vec![0.0; grid.node_count() * D]));

    let mut best: Option<(f64, Vec<f64>)> = None;
    for (_, displacement) in starts {
        let mut minimizer = Newton::new(grid, displacement, settings.tolerance);
        let mut energy = f64::INFINITY;
        for _ in 0..TRIAL_ITERATIONS {
            let progress = minimizer.step(assembler).await;
            energy = progress.evaluation.total();
            if progress.stop.is_some() {
                break;
            }
        }
        *evaluations += TRIAL_ITERATIONS;
        if best.as_ref().is_none_or(|(least, _)| energy < *least) {
            best = Some((energy, minimizer.displacement().to_vec()));
        }
    }
    best.expect("the identity is always tried").1
}

/// Those entries of a ring whose neighbours have no less energy.
fn minima(ring: Vec<(f64, Vec<f64>)>) -> Vec<(f64, Vec<f64>)> {
    let energies: Vec<f64> = ring.iter().map(|entry| entry.0).collect();
    let n = energies.len();
    let is_minimum = |k: usize| {
        energies[k].is_finite() && energies[k] <= energies[(k + 1) % n] && energies[k] <= energies[(k + n - 1) % n]
    };
    ring.into_iter().enumerate().filter(|(k, _)| is_minimum(*k)).map(|(_, entry)| entry).collect()
}
