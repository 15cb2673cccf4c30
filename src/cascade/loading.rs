//! Incremental loading: a far aim is approached in steps that the shell can follow.

use super::level::Level;
use crate::distance::SignedDistance;
use crate::field::interpolate;
use crate::inverse::invert;
use crate::minimize::Progress;
use crate::settings::Settings;

/// The first level on which it is done, 33 nodes a side: coarser ones make large moves by themselves.
const FIRST_LEVEL: u32 = 5;
/// How far from the shell's present place a load lies at most, in cells.
/// Less than half of a gap that the grid resolves, so that its bottom is nearer than its walls.
const REACH: f64 = 1.5;
/// Iterations a load, and loads a level.
const ITERATIONS: usize = 5;
const LOADS: usize = 20;

/// A shell is there when none of it is farther off than this, in cells.
const THERE: f64 = 1.0;

/// How far loading has come on a level.
///
/// Straight towards a far aim every point of the shell takes the shortest way, and where the aim has a limb that the shell
/// has not, the whole neighbourhood goes to its foot. A load's aim is the template as far as it lies within a reach of the
/// present shell: d = max(min(d2, s + r), s − r), s the distance to φ(M1). It grows into the limb step by step.
#[derive(Default)]
pub(super) struct Loading {
    loads: usize,
    /// Iterations on this level when the present load began; none once the level aims at the template itself.
    since: Option<usize>,
    done: bool,
}

impl Loading {
    /// On the next level.
    pub fn restart(&mut self) {
        *self = Self::default();
    }

    /// Sets the next load if it is time for it.
    pub fn advance<const D: usize>(&mut self, level: &mut Level<D>, settings: &Settings, progress: &Progress) {
        if self.done || level.number < FIRST_LEVEL {
            return;
        }
        if self.since.is_some_and(|since| progress.iterations < since + ITERATIONS) {
            return;
        }
        let far = farthest(level) >= THERE && self.loads < LOADS;
        if let Some(aim) = far.then(|| load(level)).flatten() {
            level.aim_at(&aim, settings, progress);
            self.loads += 1;
            self.since = Some(progress.iterations);
        } else {
            self.done = true;
            if self.loads > 0 {
                let template = level.shapes()[1].clone();
                level.aim_at(&template, settings, progress);
            }
        }
    }
}

/// |d2(φ)| at the farthest of the zeros of d1 on the edges of the grid, in cells.
fn farthest<const D: usize>(level: &Level<D>) -> f64 {
    let [shell, aim] = level.shapes();
    let (grid, d1, u) = (shell.grid(), shell.values(), level.displacement());
    let mut farthest = 0.0_f64;
    for node in 0..grid.node_count() {
        let index = grid.node_index(node);
        for axis in (0..D).filter(|&axis| index[axis] < grid.cells()) {
            let (a, b) = (node, node + grid.stride(axis));
            if (d1[a] < 0.0) == (d1[b] < 0.0) {
                continue;
            }
            let t = d1[a] / (d1[a] - d1[b]);
            let mut point = grid.position(a);
            point[axis] += t * grid.spacing();
            let y: [f64; D] = std::array::from_fn(|k| point[k] + (1.0 - t) * u[a * D + k] + t * u[b * D + k]);
            let [d] = interpolate::<D, 1>(grid, aim.values(), &y);
            farthest = farthest.max(d.abs());
        }
    }
    farthest * grid.cells() as f64
}

/// The template as far as it is within reach of the shell; none where φ cannot be inverted.
fn load<const D: usize>(level: &Level<D>) -> Option<SignedDistance<D>> {
    let [shell, aim] = level.shapes();
    let grid = shell.grid();
    let inverse = invert(grid, level.displacement())?;
    let place: Vec<f64> = (0..grid.node_count())
        .map(|node| {
            let y = grid.position(node);
            let x: [f64; D] = std::array::from_fn(|k| y[k] + inverse[node * D + k]);
            interpolate::<D, 1>(grid, shell.values(), &x)[0]
        })
        .collect();
    let place = SignedDistance::redistance(grid, &place).ok()?;
    let reach = REACH * grid.spacing();
    let near: Vec<f64> =
        aim.values().iter().zip(place.values()).map(|(d, s)| d.min(s + reach).max(s - reach)).collect();
    SignedDistance::redistance(grid, &near).ok()
}
