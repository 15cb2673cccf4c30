//! The inverse of a deformation.

mod points;

pub use points::Inverse;

use crate::field::{interpolate, interpolate_derivative};
use crate::grid::Grid;
use crate::small::{apply, cofactor, determinant, dot};

/// Newton steps for one node, and the residual (in cells) below which it is found.
const MAX_STEPS: usize = 50;
const ACCURACY: f64 = 1e-8;

/// Sweeps of smoothing that may unfold a nodal inverse, and after how many of them the next ring of nodes joins in.
const MAX_SWEEPS: usize = 400;
const SWEEPS_OF_RING: usize = 40;

/// The displacement of φ⁻¹ at the nodes, φ = x + u; none if φ folds, or the inverse does.
///
/// Where φ⁻¹ varies strongly within a cell, its nodal interpolant may fold though φ⁻¹ does not; nodes of such cells, and
/// ever more around those that stay folded, are moved to the mean of their neighbours until no cell folds.
pub fn invert<const D: usize>(grid: Grid<D>, displacement: &[f64]) -> Option<Vec<f64>> {
    let is_folded = nodes_of_folds(grid, displacement).contains(&true);
    if is_folded { None } else { smooth_folds(grid, nodal_inverse(grid, displacement)) }
}

fn smooth_folds<const D: usize>(grid: Grid<D>, mut displacement: Vec<f64>) -> Option<Vec<f64>> {
    for sweep in 0..MAX_SWEEPS {
        let mut moving = nodes_of_folds(grid, &displacement);
        if !moving.contains(&true) {
            return Some(displacement);
        }
        for _ in 0..sweep / SWEEPS_OF_RING {
            moving = with_neighbours(grid, &moving);
        }
        let before = displacement.clone();
        for node in (0..grid.node_count()).filter(|&node| moving[node]) {
            let (mut sum, mut count) = ([0.0; D], 0.0);
            for neighbour in neighbours(grid, node) {
                count += 1.0;
                for k in 0..D {
                    sum[k] += before[neighbour * D + k];
                }
            }
            for k in 0..D {
                displacement[node * D + k] = sum[k] / count;
            }
        }
    }
    None
}

fn neighbours<const D: usize>(grid: Grid<D>, node: usize) -> impl Iterator<Item = usize> {
    let index = grid.node_index(node);
    (0..D).flat_map(move |axis| {
        let (i, stride) = (index[axis], grid.stride(axis));
        [(i > 0).then(|| node - stride), (i < grid.cells()).then(|| node + stride)].into_iter().flatten()
    })
}

fn with_neighbours<const D: usize>(grid: Grid<D>, nodes: &[bool]) -> Vec<bool> {
    (0..nodes.len()).map(|node| nodes[node] || neighbours(grid, node).any(|other| nodes[other])).collect()
}

/// The nodes of all cells with a determinant at some corner that is not positive.
fn nodes_of_folds<const D: usize>(grid: Grid<D>, displacement: &[f64]) -> Vec<bool> {
    let offsets = grid.corner_offsets();
    let mut nodes = vec![false; grid.node_count()];
    for cell in 0..grid.cell_count() {
        let base = grid.lowest_node(cell);
        let folds = (0..Grid::<D>::CORNERS).any(|corner| {
            let jacobian: [[f64; D]; D] = std::array::from_fn(|axis| {
                let low = base + offsets[corner & !(1 << axis)];
                let high = low + grid.stride(axis);
                std::array::from_fn(|k| {
                    let slope = (displacement[high * D + k] - displacement[low * D + k]) * grid.cells() as f64;
                    slope + if k == axis { 1.0 } else { 0.0 }
                })
            });
            determinant(&jacobian) <= 0.0
        });
        if folds {
            (0..Grid::<D>::CORNERS).for_each(|corner| nodes[base + offsets[corner]] = true);
        }
    }
    nodes
}

/// The displacement of φ⁻¹ at each node.
///
/// Beyond φ's image of the box the boundary cell's polynomial goes on, as it does in [`interpolate`]. Where it leads
/// nowhere a node moves with the one before it: what is out there only has to stay in order.
fn nodal_inverse<const D: usize>(grid: Grid<D>, displacement: &[f64]) -> Vec<f64> {
    let preimages = Inverse::new(grid, displacement);
    let mut inverse = vec![0.0; displacement.len()];
    for node in 0..grid.node_count() {
        let target = grid.position(node);
        let before = [1, grid.side()].into_iter().find(|&back| node >= back && (back > 1 || node % grid.side() != 0));
        let shift: [f64; D] = before.map_or([0.0; D], |back| std::array::from_fn(|k| inverse[(node - back) * D + k]));
        let guess = std::array::from_fn(|k| target[k] + shift[k]);
        let preimage = preimages.at(&target).or_else(|| solve(grid, displacement, &target, guess));
        for k in 0..D {
            inverse[node * D + k] = preimage.map_or(shift[k], |preimage| preimage[k] - target[k]);
        }
    }
    inverse
}

fn solve<const D: usize>(grid: Grid<D>, displacement: &[f64], target: &[f64; D], mut x: [f64; D]) -> Option<[f64; D]> {
    let residual = |x: &[f64; D]| -> [f64; D] {
        let u = interpolate::<D, D>(grid, displacement, x);
        std::array::from_fn(|k| x[k] + u[k] - target[k])
    };
    let mut defect = residual(&x);
    for _ in 0..MAX_STEPS {
        let size = dot(&defect, &defect);
        if size.sqrt() * grid.cells() as f64 <= ACCURACY {
            return Some(x);
        }
        let mut jacobian = interpolate_derivative::<D, D>(grid, displacement, &x);
        for (k, row) in jacobian.iter_mut().enumerate() {
            row[k] += 1.0;
        }
        let cof = cofactor(&jacobian);
        let det = dot(&jacobian[0], &cof[0]);
        // J⁻¹ = cofᵀ/det.
        let transposed: [[f64; D]; D] = std::array::from_fn(|i| std::array::from_fn(|j| cof[j][i] / det));
        let step = apply(&transposed, &defect);
        let mut length = 1.0;
        loop {
            let trial: [f64; D] = std::array::from_fn(|k| x[k] - length * step[k]);
            let next = residual(&trial);
            if dot(&next, &next) < size {
                (x, defect) = (trial, next);
                break;
            }
            length *= 0.5;
            if length < 1e-6 {
                return None;
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inverse_undoes<const D: usize>() {
        let grid = Grid::<D>::new(16);
        let wave = |x: f64| 0.04 * (5.0 * x).sin();
        let displacement: Vec<f64> = (0..grid.node_count())
            .flat_map(|node| {
                let x = grid.position(node);
                std::array::from_fn::<f64, D, _>(|k| wave(x[(k + 1) % D]) + 0.2 * (x[k] - 0.5))
            })
            .collect();
        let inverse = invert(grid, &displacement).expect("a bijection");
        for node in 0..grid.node_count() {
            let y = grid.position(node);
            let x: [f64; D] = std::array::from_fn(|k| y[k] + inverse[node * D + k]);
            let u = interpolate::<D, D>(grid, &displacement, &x);
            for k in 0..D {
                assert!((x[k] + u[k] - y[k]).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn the_inverse_undoes_the_deformation_at_the_nodes() {
        inverse_undoes::<2>();
        inverse_undoes::<3>();
    }

    #[test]
    fn a_collapsed_deformation_has_no_inverse() {
        let grid = Grid::<2>::new(4);
        let displacement: Vec<f64> =
            (0..grid.node_count()).flat_map(|node| grid.position(node).map(|x| 0.5 - x)).collect();
        assert!(invert(grid, &displacement).is_none());
    }
}
