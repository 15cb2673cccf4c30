//! Tensor-product quadrature on a cell, laid out for multilinear elements.

use crate::grid::{Grid, MAX_CORNERS};

const MAX_POINTS: usize = 27;
const MAX_COLUMNS: usize = 9;
const MAX_EDGES: usize = 4;

/// M points an axis on `[0,1]^D`, x fastest.
///
/// The derivative ∂φ/∂x_k of a multilinear map does not depend on the k-th coordinate: it is an average of the
/// differences along the 2^(D−1) edges parallel to axis k. A rule therefore has only M^(D−1) distinct *columns*
/// of Dφ an axis, and each is formed once.
pub struct Rule<const D: usize, const M: usize> {
    pub weight: [f64; MAX_POINTS],
    /// Shape functions: `shape[point][corner]`.
    pub shape: [[f64; MAX_CORNERS]; MAX_POINTS],
    /// Which column of axis k a point uses: `column[point][k]`.
    pub column: [[usize; D]; MAX_POINTS],
    /// Shares of the edges in a column, the same for every axis: `edge[column][edge]`.
    pub edge: [[f64; MAX_EDGES]; MAX_COLUMNS],
}

impl<const D: usize, const M: usize> Rule<D, M> {
    pub const POINTS: usize = M.pow(D as u32);
    pub const COLUMNS: usize = M.pow(D as u32 - 1);
    pub const EDGES: usize = 1 << (D - 1);

    fn new(nodes: [f64; M], weights: [f64; M]) -> Self {
        let mut rule = Self {
            weight: [0.0; MAX_POINTS],
            shape: [[0.0; MAX_CORNERS]; MAX_POINTS],
            column: [[0; D]; MAX_POINTS],
            edge: [[0.0; MAX_EDGES]; MAX_COLUMNS],
        };
        let factor = |bit: usize, x: f64| if bit & 1 == 1 { x } else { 1.0 - x };
        for point in 0..Self::POINTS {
            let index: [usize; D] = std::array::from_fn(|axis| point / M.pow(axis as u32) % M);
            rule.weight[point] = index.iter().map(|&i| weights[i]).product();
            for corner in 0..Grid::<D>::CORNERS {
                rule.shape[point][corner] = (0..D).map(|axis| factor(corner >> axis, nodes[index[axis]])).product();
            }
            for axis in 0..D {
                let others = (0..D).filter(|&other| other != axis);
                rule.column[point][axis] = others.rev().fold(0, |column, other| column * M + index[other]);
            }
        }
        for column in 0..Self::COLUMNS {
            for edge in 0..Self::EDGES {
                rule.edge[column][edge] =
                    (0..D - 1).map(|k| factor(edge >> k, nodes[column / M.pow(k as u32) % M])).product();
            }
        }
        rule
    }

    /// Where the points of an axis lie between −1 and 1.
    #[inline(always)]
    pub fn place(&self, number: usize) -> f64 {
        2.0 * (self.edge[number][1] + self.edge[number][3]) - 1.0
    }
}

impl<const D: usize> Rule<D, 3> {
    /// Gauss, exact for polynomials of degree 5 an axis.
    pub fn gauss3() -> Self {
        let offset = 0.5 * 0.6_f64.sqrt();
        Self::new([0.5 - offset, 0.5, 0.5 + offset], [5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0])
    }
}

impl<const D: usize> Rule<D, 2> {
    /// Gauss, exact for polynomials of degree 3 an axis.
    pub fn gauss2() -> Self {
        let offset = 0.5 / 3.0_f64.sqrt();
        Self::new([0.5 - offset, 0.5 + offset], [0.5; 2])
    }

    /// The corners of the cell, equally weighted; point and corner numbers agree.
    pub fn vertices() -> Self {
        Self::new([0.0, 1.0], [0.5; 2])
    }
}

/// The corners at the ends of the edges parallel to `axis`: `(low, high)` of edge e.
#[inline(always)]
pub const fn edge_ends(axis: usize, edge: usize) -> (usize, usize) {
    let below = edge & ((1 << axis) - 1);
    let low = below | ((edge >> axis) << (axis + 1));
    (low, low | (1 << axis))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_run_along_their_axis() {
        for axis in 0..3 {
            let mut seen = [false; 8];
            for edge in 0..4 {
                let (low, high) = edge_ends(axis, edge);
                assert_eq!(low ^ high, 1 << axis);
                seen[low] = true;
                seen[high] = true;
            }
            assert!(seen.iter().all(|&s| s));
        }
    }

    fn columns_are_derivatives<const D: usize>() {
        // φ(x) = x₀·x_{D−1}: the derivative by x₀ is x_{D−1}.
        let rule = Rule::<D, 3>::gauss3();
        let corner_value = |corner: usize| ((corner & 1) * (corner >> (D - 1) & 1)) as f64;
        for point in 0..Rule::<D, 3>::POINTS {
            let mut derivative = 0.0;
            for edge in 0..Rule::<D, 3>::EDGES {
                let (low, high) = edge_ends(0, edge);
                derivative += rule.edge[rule.column[point][0]][edge] * (corner_value(high) - corner_value(low));
            }
            let last: f64 =
                (0..Grid::<D>::CORNERS).map(|corner| rule.shape[point][corner] * (corner >> (D - 1) & 1) as f64).sum();
            assert!((derivative - last).abs() < 1e-15);
        }
        let total: f64 = rule.weight.iter().sum();
        assert!((total - 1.0).abs() < 1e-15);
    }

    #[test]
    fn columns_of_a_rule_give_the_derivative() {
        columns_are_derivatives::<2>();
        columns_are_derivatives::<3>();
    }
}
