//! Nodal fields from one level to the next.

use crate::grid::Grid;

/// The multilinear interpolant of D interleaved components on the grid with twice the cells a side.
///
/// The fine field is the same function as the coarse one. For D = 2 its determinant is linear along the edges of
/// a cell, so positive determinants at the corners stay positive; for D = 3 the Bernstein coefficients of the halves of a cell
/// are averages of the whole's, so positive ones stay positive.
pub fn prolongate<const D: usize>(coarse: Grid<D>, values: &[f64]) -> Vec<f64> {
    assert_eq!(values.len(), coarse.node_count() * D);
    let fine = Grid::<D>::new(2 * coarse.cells());
    let mut result = Vec::with_capacity(fine.node_count() * D);
    for node in 0..fine.node_count() {
        let index = fine.node_index(node);
        let base = coarse.node(index.map(|i| i / 2));
        let odd = index.map(|i| i % 2);
        let parents = 1 << odd.iter().sum::<usize>();
        let mut sum = [0.0; D];
        for parent in 0..parents {
            let (mut offset, mut bits) = (0, parent);
            for axis in 0..D {
                if odd[axis] == 1 {
                    offset += (bits & 1) * coarse.stride(axis);
                    bits >>= 1;
                }
            }
            for (k, s) in sum.iter_mut().enumerate() {
                *s += values[(base + offset) * D + k];
            }
        }
        result.extend(sum.map(|s| s / parents as f64));
    }
    result
}

/// The field on the grid with half the cells a side: its values at the nodes that remain.
pub fn coarsen<const D: usize>(fine: Grid<D>, values: &[f64]) -> Vec<f64> {
    assert_eq!(values.len(), fine.node_count() * D);
    let coarse = Grid::<D>::new(fine.cells() / 2);
    (0..coarse.node_count())
        .flat_map(|node| {
            let source = fine.node(coarse.node_index(node).map(|i| 2 * i)) * D;
            values[source..source + D].iter().copied()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::interpolate;

    fn is_the_same_function<const D: usize>() {
        let coarse = Grid::<D>::new(4);
        let values: Vec<f64> = (0..coarse.node_count() * D).map(|k| ((k * k) as f64).sin()).collect();
        let fine = Grid::<D>::new(8);
        let result = prolongate(coarse, &values);
        assert_eq!(coarsen(fine, &result), values);
        for node in 0..fine.node_count() {
            let expected = interpolate::<D, D>(coarse, &values, &fine.position(node));
            for k in 0..D {
                assert!((result[node * D + k] - expected[k]).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn prolongation_does_not_change_the_function() {
        is_the_same_function::<2>();
        is_the_same_function::<3>();
    }
}
