//! Geometric multigrid for symmetric positive (semi-)definite stencil operators, usable by itself.
//!
//! Multilinear prolongation, its transpose as restriction, Galerkin coarse operators, one forward block Gauss–Seidel
//! sweep before and one backward sweep after the coarse correction: the cycle is symmetric as a whole and so serves as
//! a preconditioner for conjugate gradients. All in f32: the cycle only has to find a direction.

mod galerkin;
mod padded;
mod sweep;

use crate::grid::Grid;
use crate::stencil::{LANES, StencilOperator};
use galerkin::Galerkin;
use padded::{Layout, Nodes};
use sweep::Scratch;
use wide::f32x4;

/// Cells a side of the grid that is solved directly.
const COARSEST_CELLS: usize = 2;

/// A hierarchy of operators with everything a cycle needs; nothing is allocated after construction.
pub struct Multigrid<const D: usize> {
    /// Finest first.
    levels: Vec<Level<D>>,
    direct: Cholesky,
    search: Vec<f32>,
    solution: Vec<f32>,
}

struct Level<const D: usize> {
    operator: StencilOperator<D>,
    /// To the next level.
    galerkin: Galerkin<D>,
    layout: Layout<D>,
    right: Vec<f32>,
    solution: Vec<f32>,
    residual: Vec<f32>,
    scratch: Scratch<D>,
}

/// How a solve went.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solve {
    pub iterations: usize,
    /// |r| / |b| at the end.
    pub relative_residual: f64,
    /// ⟨b, x⟩.
    pub product: f64,
}

impl<const D: usize> Multigrid<D> {
    /// # Panics
    /// Unless the grid has a power of two cells a side.
    pub fn new(grid: Grid<D>) -> Self {
        assert!(grid.cells().is_power_of_two() && grid.cells() >= COARSEST_CELLS, "grids are halved down to 2 cells");
        let mut levels = vec![Level::new(grid)];
        let mut cells = grid.cells();
        while cells > COARSEST_CELLS {
            cells /= 2;
            levels.push(Level::new(Grid::new(cells)));
        }
        let count = levels[0].layout.len();
        let unknowns = Grid::<D>::new(COARSEST_CELLS).node_count() * D;
        Self { levels, direct: Cholesky::new(unknowns), search: vec![0.0; count], solution: vec![0.0; count] }
    }

    /// The finest operator, to be filled before [`prepare`](Self::prepare).
    pub fn operator_mut(&mut self) -> &mut StencilOperator<D> {
        &mut self.levels[0].operator
    }

    /// Derives the coarse operators from the finest one.
    pub fn prepare(&mut self) {
        for fine in 0..self.levels.len() {
            let (finer, coarser) = self.levels.split_at_mut(fine + 1);
            finer[fine].operator.complete();
            if let Some(coarse) = coarser.first_mut() {
                let finer = &mut finer[fine];
                finer.galerkin.coarsen(&finer.operator, &mut coarse.operator);
            }
        }
        self.direct.factor(&self.levels[self.levels.len() - 1].operator);
    }

    /// Solves A x = b by preconditioned conjugate gradients until the residual has fallen by `tolerance`;
    /// overwrites b with x, D interleaved components a node.
    pub fn solve(&mut self, vector: &mut [f64], tolerance: f64, max_iterations: usize) -> Solve {
        // f32 keeps clear of the smallest numbers near 1.
        let scale = vector.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        if scale == 0.0 {
            return Solve { iterations: 0, relative_residual: 0.0, product: 0.0 };
        }
        // A cycle leaves the right side alone: there the residual stays. Between cycles their scratch holds A·search.
        let layout = self.levels[0].layout;
        layout.store(vector, 1.0 / scale, &mut self.levels[0].right);
        self.solution.fill(0.0);
        self.cycle();
        self.search.copy_from_slice(&self.levels[0].solution);
        let mut square = dot(&self.levels[0].right, &self.search);
        let first = dot(&self.levels[0].right, &self.levels[0].right);
        let mut rest = first;
        let mut iterations = 0;
        while iterations < max_iterations {
            let Level { operator, right: residual, residual: image, scratch, .. } = &mut self.levels[0];
            layout.apply(operator, &self.search, image, scratch);
            let curvature = dot(&self.search, image);
            // No curvature left along the search direction: f32 is at its end, or the operator is singular there.
            if !(curvature > 0.0 && square.is_finite()) {
                break;
            }
            let step = (square / curvature) as f32;
            add_scaled(&mut self.solution, step, &self.search);
            add_scaled(residual, -step, image);
            iterations += 1;
            rest = dot(residual, residual);
            if rest <= tolerance * tolerance * first {
                break;
            }
            self.cycle();
            let Level { right: residual, solution, .. } = &self.levels[0];
            let next = dot(residual, solution);
            let gamma = (next / square) as f32;
            for (s, z) in self.search.iter_mut().zip(solution) {
                *s = z + gamma * *s;
            }
            square = next;
        }
        let product = layout.replace(&self.solution, scale, vector);
        Solve { iterations, relative_residual: (rest / first).sqrt(), product }
    }

    /// One V-cycle for A x = b from x = 0: `b` and `x` with D interleaved components a node.
    pub fn v_cycle(&mut self, b: &[f64], x: &mut [f64]) {
        let layout = self.levels[0].layout;
        layout.store(b, 1.0, &mut self.levels[0].right);
        self.cycle();
        layout.load(&self.levels[0].solution, 1.0, x);
    }

    /// One V-cycle from zero on the finest level's right side, into its solution.
    fn cycle(&mut self) {
        let last = self.levels.len() - 1;
        for fine in 0..last {
            let (finer, coarser) = self.levels.split_at_mut(fine + 1);
            let (level, coarse) = (&mut finer[fine], &mut coarser[0]);
            level.layout.sweep_from_zero(
                &level.operator,
                &level.right,
                &mut level.solution,
                &mut level.residual,
                &mut level.scratch,
            );
            level.layout.restrict(&level.residual, &coarse.layout, &mut coarse.right, &mut level.scratch.line);
        }
        let coarsest = &mut self.levels[last];
        self.direct.solve(coarsest.layout, &coarsest.right, &mut coarsest.solution);
        for fine in (0..last).rev() {
            let (finer, coarser) = self.levels.split_at_mut(fine + 1);
            let (level, coarse) = (&mut finer[fine], &coarser[0]);
            level.layout.prolongate_add(&coarse.solution, &coarse.layout, &mut level.solution, &mut level.scratch.line);
            level.layout.sweep_backward(
                &level.operator,
                &level.right,
                &mut level.solution,
                &mut level.residual,
                &mut level.scratch,
            );
        }
    }
}

impl<const D: usize> Level<D> {
    fn new(grid: Grid<D>) -> Self {
        let layout = Layout::new(grid);
        let count = layout.len();
        Self {
            operator: if D == 3 { StencilOperator::rounded(grid) } else { StencilOperator::zero(grid) },
            galerkin: Galerkin::new(grid),
            right: vec![0.0; count],
            solution: vec![0.0; count],
            residual: vec![0.0; count],
            scratch: Scratch::new(&layout),
            layout,
        }
    }
}

fn dot(a: &Nodes, b: &Nodes) -> f64 {
    // Short runs in f32 lanes, their sums in f64: as fast as f64, as exact as needed.
    let mut total = 0.0;
    for (x, y) in a.chunks(256).zip(b.chunks(256)) {
        let mut sums = [0.0_f32; 8];
        let (x8, y8) = (x.chunks_exact(8), y.chunks_exact(8));
        let rest: f32 = x8.remainder().iter().zip(y8.remainder()).map(|(x, y)| x * y).sum();
        for (x, y) in x8.zip(y8) {
            for k in 0..8 {
                sums[k] += x[k] * y[k];
            }
        }
        total += f64::from(sums.iter().sum::<f32>() + rest);
    }
    total
}

/// a += s b.
#[inline(never)]
fn add_scaled(a: &mut Nodes, s: f32, b: &Nodes) {
    let ((groups, rest), (other_groups, other_rest)) = (a.as_chunks_mut::<LANES>(), b.as_chunks::<LANES>());
    for (x, y) in groups.iter_mut().zip(other_groups) {
        *x = (f32x4::from(*x) + s * f32x4::from(*y)).to_array();
    }
    for (x, y) in rest.iter_mut().zip(other_rest) {
        *x += s * y;
    }
}

/// The dense Cholesky factor of the coarsest operator.
struct Cholesky {
    unknowns: usize,
    /// Lower triangle by rows.
    factor: Vec<f64>,
    vector: Vec<f64>,
}

impl Cholesky {
    fn new(unknowns: usize) -> Self {
        Self { unknowns, factor: vec![0.0; unknowns * unknowns], vector: vec![0.0; unknowns] }
    }

    fn factor<const D: usize>(&mut self, operator: &StencilOperator<D>) {
        let n = self.unknowns;
        self.factor.fill(0.0);
        operator.for_each_block(|node, other, block| {
            for i in 0..D {
                for j in 0..D {
                    self.factor[(node * D + i) * n + other * D + j] = f64::from(block[i][j]);
                }
            }
        });
        let trace: f64 = (0..n).map(|k| self.factor[k * n + k]).sum();
        // The rigid motions that nothing resists have no curvature; f64 rounding would decide their sign.
        let floor = 1e-6 * trace / n as f64 + f64::MIN_POSITIVE;
        for column in 0..n {
            for row in column..n {
                let mut sum = self.factor[row * n + column];
                for k in 0..column {
                    sum -= self.factor[row * n + k] * self.factor[column * n + k];
                }
                self.factor[row * n + column] = if row == column {
                    (sum + floor).max(floor).sqrt()
                } else {
                    sum / self.factor[column * n + column]
                };
            }
        }
    }

    fn solve<const D: usize>(&mut self, layout: Layout<D>, right: &Nodes, solution: &mut Nodes) {
        let n = self.unknowns;
        layout.load(right, 1.0, &mut self.vector);
        for row in 0..n {
            let mut sum = self.vector[row];
            for k in 0..row {
                sum -= self.factor[row * n + k] * self.vector[k];
            }
            self.vector[row] = sum / self.factor[row * n + row];
        }
        for row in (0..n).rev() {
            let mut sum = self.vector[row];
            for k in row + 1..n {
                sum -= self.factor[k * n + row] * self.vector[k];
            }
            self.vector[row] = sum / self.factor[row * n + row];
        }
        layout.store(&self.vector, 1.0, solution);
    }
}
