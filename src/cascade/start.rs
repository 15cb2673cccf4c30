//! The initial deformation: several starts, ranked by the energy a few iterations reach on the coarsest level.

use crate::align::{boundary_measure, similarities};
use crate::assemble::Assembler;
use crate::distance::SignedDistance;
use crate::minimize::{Minimizer, Newton};
use crate::settings::Settings;

/// Similarities that are tried beside the identity.
const CANDIDATES: usize = 4;
/// Iterations in each round of trials and how many starts stay in after it. The first energy does not tell a turned star
/// from a folded one; the energy after some iterations does, and the hopeless need not be followed to the end.
const ROUNDS: [(usize, usize); 3] = [(5, 3), (5, 2), (10, 1)];
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

    let mut trials: Vec<(f64, Newton<D>)> = starts
        .into_iter()
        .map(|(energy, displacement)| (energy, Newton::new(grid, displacement, settings.tolerance)))
        .collect();
    for (iterations, remaining) in ROUNDS {
        for (energy, minimizer) in &mut trials {
            for _ in 0..iterations {
                let progress = minimizer.step(assembler).await;
                *energy = progress.evaluation.total();
                if progress.stop.is_some() {
                    break;
                }
            }
            *evaluations += iterations;
        }
        trials.sort_by(|a, b| a.0.total_cmp(&b.0));
        trials.truncate(remaining);
    }
    trials[0].1.displacement().to_vec()
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
