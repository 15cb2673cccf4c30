//! The Sobolev metric, inverted exactly by cosine transforms.

use crate::fourier::{Complex, transform, turns};
use crate::grid::Grid;

/// The inner product ⟨u, v⟩ = ∫ u·v + β²/2 ∇u:∇v on multilinear nodal fields, natural boundary.
///
/// The gradient of an energy in this metric solves (M + β²/2 L) g = ∂E/∂u with the mass matrix M and the stiffness
/// matrix L. Both are sums of Kronecker products of the one-dimensional ones, which share the eigenvectors
/// cos(πjk/n): with c = cos(πk/n) and the weights w = (1/2, 1, …, 1, 1/2),
/// M₁ v = h (2 + c)/3 · w v,  L₁ v = (2 − 2c)/h · w v.  The type-I cosine transform therefore inverts the metric
/// exactly.  Source: the paper's (1 − β²/2 Δ)⁻¹.
pub struct SobolevMetric<const D: usize> {
    grid: Grid<D>,
    /// exp(−iπk/n).
    turns: Vec<Complex>,
    /// A line of the field, made even.
    line: Vec<Complex>,
    scratch: Vec<Complex>,
    /// A field as complex numbers, two components at once.
    field: Vec<Complex>,
    turned: Vec<Complex>,
    mass: Vec<f64>,
    stiffness: Vec<f64>,
}

impl<const D: usize> SobolevMetric<D> {
    /// # Panics
    /// Unless the grid has a power of two cells a side.
    pub fn new(grid: Grid<D>) -> Self {
        let n = grid.cells();
        assert!(n.is_power_of_two(), "the cosine transform needs 2^l cells");
        let turns = turns(n);
        let cosines = turns.iter().map(|turn| turn.re).chain([-1.0]);
        Self {
            grid,
            line: vec![Complex::default(); 2 * n],
            scratch: vec![Complex::default(); 2 * n],
            field: vec![Complex::default(); grid.node_count()],
            turned: vec![Complex::default(); grid.node_count()],
            mass: cosines.clone().map(|c| (2.0 + c) / (3.0 * n as f64)).collect(),
            stiffness: cosines.map(|c| (2.0 - 2.0 * c) * n as f64).collect(),
            turns,
        }
    }

    /// Solves (M + β²/2 L) x = b in place, for D interleaved components.
    pub fn solve(&mut self, beta: f64, values: &mut [f64]) {
        assert_eq!(values.len(), self.grid.node_count() * D);
        let side = self.grid.side();
        let ends = |index: usize| if index == 0 || index == side - 1 { 2.0 } else { 1.0 };
        // A real transform takes the real and the imaginary part for two components at no extra cost.
        for first in (0..D).step_by(2) {
            let paired = first + 1 < D;
            for (row, line) in self.field.chunks_exact_mut(side).enumerate() {
                // The end nodes carry half a cell, so dividing by the weights doubles them.
                let index = self.grid.node_index(row * side);
                let outer: f64 = index[1..].iter().map(|&i| ends(i)).product();
                for (column, c) in line.iter_mut().enumerate() {
                    let node = row * side + column;
                    let weight = outer * ends(column);
                    let imaginary = if paired { values[node * D + first + 1] } else { 0.0 };
                    *c = Complex::new(values[node * D + first] * weight, imaginary * weight);
                }
            }
            for _ in 0..D {
                self.transform_and_turn();
            }
            let scale = 1.0 / (2.0 * self.grid.cells() as f64).powi(D as i32);
            for (node, c) in self.field.iter_mut().enumerate() {
                let index = self.grid.node_index(node);
                let mass: f64 = index.iter().map(|&i| self.mass[i]).product();
                let stiffness: f64 =
                    (0..D).map(|axis| self.stiffness[index[axis]] * mass / self.mass[index[axis]]).sum();
                let factor = scale / (mass + 0.5 * beta * beta * stiffness);
                *c = Complex::new(factor * c.re, factor * c.im);
            }
            for _ in 0..D {
                self.transform_and_turn();
            }
            for (node, c) in self.field.iter().enumerate() {
                values[node * D + first] = c.re;
                if paired {
                    values[node * D + first + 1] = c.im;
                }
            }
        }
    }

    /// The type-I cosine transform along the fastest axis, unnormalised (twice it is 2n); then that axis becomes the
    /// slowest, so that D calls transform all axes and restore their order.
    fn transform_and_turn(&mut self) {
        let (n, side) = (self.grid.cells(), self.grid.side());
        let rows = self.grid.node_count() / side;
        for row in 0..rows {
            let values = &self.field[row * side..][..side];
            self.line[..side].copy_from_slice(values);
            for k in 1..n {
                self.line[2 * n - k] = values[k];
            }
            transform(&self.turns, &mut self.line, &mut self.scratch);
            for k in 0..side {
                self.turned[k * rows + row] = self.line[k];
            }
        }
        std::mem::swap(&mut self.field, &mut self.turned);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::Rule;

    /// (M + β²/2 L) u, integrated cell by cell.
    fn apply<const D: usize>(grid: Grid<D>, beta: f64, u: &[f64]) -> Vec<f64> {
        let (rule, h) = (Rule::<D, 3>::gauss3(), grid.spacing());
        let offsets = grid.corner_offsets();
        let mut result = vec![0.0; u.len()];
        for cell in 0..grid.cell_count() {
            let base = grid.lowest_node(cell);
            for point in 0..Rule::<D, 3>::POINTS {
                let weight = rule.weight[point] * h.powi(D as i32);
                let local = std::array::from_fn::<f64, D, _>(|axis| {
                    (0..Grid::<D>::CORNERS).map(|c| rule.shape[point][c] * (c >> axis & 1) as f64).sum()
                });
                let shapes = crate::field::CornerWeights::at(&local);
                for a in 0..Grid::<D>::CORNERS {
                    for b in 0..Grid::<D>::CORNERS {
                        let slope: f64 =
                            (0..D).map(|k| shapes.derivative[a][k] * shapes.derivative[b][k] / (h * h)).sum();
                        let entry = weight * (shapes.value[a] * shapes.value[b] + 0.5 * beta * beta * slope);
                        for k in 0..D {
                            result[(base + offsets[a]) * D + k] += entry * u[(base + offsets[b]) * D + k];
                        }
                    }
                }
            }
        }
        result
    }

    fn solve_inverts_the_metric<const D: usize>(cells: usize) {
        let grid = Grid::<D>::new(cells);
        let mut metric = SobolevMetric::new(grid);
        for beta in [0.0, 0.05, 1.0] {
            let u: Vec<f64> = (0..grid.node_count() * D).map(|k| ((k * k) as f64 * 0.37).sin()).collect();
            let mut b = apply(grid, beta, &u);
            metric.solve(beta, &mut b);
            let error = u.iter().zip(&b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            assert!(error < 1e-11, "D = {D}, {cells} cells, β = {beta}: error {error}");
        }
    }

    #[test]
    fn the_cosine_transform_inverts_the_assembled_metric() {
        solve_inverts_the_metric::<2>(2);
        solve_inverts_the_metric::<2>(16);
        solve_inverts_the_metric::<3>(8);
    }
}
