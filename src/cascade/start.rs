//! The initial deformation: several starts, ranked by the energy a few iterations reach on the coarsest level.

use super::level::AnyMinimizer;
use crate::align::{Similarity, neighbours, similarities};
use crate::assemble::Assembler;
use crate::distance::SignedDistance;
use crate::minimize::Minimizer;
use crate::settings::Settings;
use std::rc::Rc;

/// Turned similarities that are tried beside the one that does not turn and the identity.
const CANDIDATES: usize = 4;
/// Iterations in each round of trials and how many starts stay in after it. The first energy does not tell a turned star
/// from a folded one; the energy after some iterations does, and the hopeless need not be followed to the end. In space
/// an iteration takes fifty times as long, and fewer tell as much.
const fn rounds<const D: usize>() -> [(usize, usize); 3] {
    if D == 2 { [(5, 3), (5, 2), (10, 1)] } else { [(3, 3), (3, 2), (3, 1)] }
}
/// A similarity that moves nothing by more than this part of a cell is as good a start as the identity.
const STILL: f64 = 0.5;
/// By how much more energy a half turn must be beaten: among starts that are nearly as good the least rotation wins, for
/// a circle is any turned circle.
const TURN_PENALTY: f64 = 0.1;

/// A start, and how its energy ranks.
struct Trial<T> {
    rank: f64,
    turn: f64,
    state: T,
}

fn rank(energy: f64, turn: f64) -> f64 {
    energy * (1.0 + TURN_PENALTY * turn / std::f64::consts::PI)
}

/// Keeps the trials of least rank, best first.
fn keep_best<T>(trials: &mut Vec<Trial<T>>, count: usize) {
    for k in 0..count.min(trials.len()) {
        let best = (k..trials.len()).min_by(|&a, &b| trials[a].rank.total_cmp(&trials[b].rank)).unwrap_or(k);
        trials.swap(k, best);
    }
    trials.truncate(count);
}

/// The displacement that the best start reaches. `shapes` are the shell and its aim.
pub(super) async fn find<const D: usize>(
    assembler: &mut impl Assembler<D>,
    shapes: &[Rc<SignedDistance<D>>; 2],
    settings: &Settings,
    evaluations: &mut usize,
) -> Vec<f64> {
    let grid = assembler.grid();
    let number = grid.cells().ilog2();
    let all: Vec<Similarity<D>> = similarities(&shapes[0], &shapes[1]);
    let mut turned = Vec::new();
    for similarity in &all {
        let displacement = similarity.displacement(grid);
        let energy = assembler.energy(&displacement).await.total();
        turned.push(Trial { rank: rank(energy, similarity.turn()), turn: similarity.turn(), state: displacement });
        *evaluations += 1;
    }
    let ranks: Vec<f64> = turned.iter().map(|trial| trial.rank).collect();
    let is_minimum = |k: usize| ranks[k].is_finite() && neighbours(&all, k).all(|other| ranks[k] <= ranks[other]);
    // The first one does not turn.
    let minima: Vec<usize> = (1..all.len()).filter(|&k| is_minimum(k)).collect();
    let unturned = ranks[0].is_finite();
    let mut starts: Vec<Trial<Vec<f64>>> = Vec::new();
    let mut straight = Vec::new();
    for (k, trial) in turned.into_iter().enumerate() {
        if minima.contains(&k) {
            starts.push(trial);
        } else if k == 0 && unturned {
            straight.push(trial);
        }
    }
    keep_best(&mut starts, CANDIDATES);
    let moves = |trial: &Trial<Vec<f64>>| trial.state.iter().any(|u| u.abs() > STILL * grid.spacing());
    // In space, where each trial is dear, only what is another start.
    let tries_identity = D == 2 || straight.iter().all(moves);
    starts.extend(straight);
    if tries_identity {
        starts.push(Trial { rank: f64::INFINITY, turn: 0.0, state: vec![0.0; grid.node_count() * D] });
    }

    let mut trials: Vec<Trial<AnyMinimizer<D>>> = starts
        .into_iter()
        .map(|Trial { rank, turn, state }| Trial { rank, turn, state: AnyMinimizer::new(number, settings, state) })
        .collect();
    for (iterations, remaining) in rounds::<D>() {
        for trial in &mut trials {
            for _ in 0..settings.minimizer.iterations(iterations) {
                let progress = trial.state.step(assembler).await;
                trial.rank = rank(progress.evaluation.total(), trial.turn);
                *evaluations += 1;
                if progress.stop.is_some() {
                    break;
                }
            }
        }
        keep_best(&mut trials, remaining);
    }
    trials[0].state.displacement().to_vec()
}
