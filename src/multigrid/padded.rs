//! Nodal f32 vectors with a ring of zeros around the grid, so that a stencil needs no case for the boundary.

use crate::grid::Grid;
use crate::stencil::{MAX_NEIGHBOURS, StencilOperator};
use wide::f32x4;

/// Share of the Gauss–Seidel correction that is applied, in the inverse diagonal blocks. On the Sobolev operator a cycle reduces the error by 0.20 with
/// 1, 0.19 with 0.95, 0.17 with 0.9 and 0.23 with 1.1, at worst over the levels.
pub(super) const DAMPING: f32 = 0.9;

/// D interleaved components a node; the node with index i sits at index i + 1.
#[derive(Clone, Copy)]
pub(super) struct Layout<const D: usize> {
    grid: Grid<D>,
    /// Positions of a node's neighbours relative to it, in f32s.
    shifts: [isize; MAX_NEIGHBOURS],
    /// How much larger the number of a node's neighbour is than its own, by the stored half.
    strides: [usize; MAX_NEIGHBOURS],
}

impl<const D: usize> Layout<D> {
    pub fn new(grid: Grid<D>) -> Self {
        let padded = grid.side() as isize + 2;
        let mut shifts = [0; MAX_NEIGHBOURS];
        for (neighbour, shift) in shifts.iter_mut().enumerate().take(StencilOperator::<D>::NEIGHBOURS) {
            let offset = StencilOperator::<D>::offset(neighbour);
            *shift = offset.iter().rev().fold(0, |sum, &o| sum * padded + o) * D as isize;
        }
        let mut strides = [0; MAX_NEIGHBOURS];
        for (slot, stride) in strides.iter_mut().enumerate().take(StencilOperator::<D>::HALF) {
            let offset = StencilOperator::<D>::offset(StencilOperator::<D>::CENTRE + slot);
            *stride = offset.iter().rev().fold(0, |sum, &o| sum * grid.side() as isize + o) as usize;
        }
        Self { grid, shifts, strides }
    }

    pub fn len(&self) -> usize {
        (self.grid.side() + 2).pow(D as u32) * D
    }

    /// Lines of nodes along x.
    fn rows(&self) -> usize {
        self.grid.node_count() / self.grid.side()
    }

    /// The position of the first node of a row.
    fn row_start(&self, row: usize) -> usize {
        let (side, padded) = (self.grid.side(), self.grid.side() + 2);
        let (mut rest, mut stride, mut place) = (row, padded, 1);
        for _ in 1..D {
            place += (rest % side + 1) * stride;
            rest /= side;
            stride *= padded;
        }
        place * D
    }

    pub fn store(&self, values: &[f64], scale: f64, padded: &mut [f32]) {
        let width = self.grid.side() * D;
        for (row, values) in values.chunks_exact(width).enumerate() {
            for (p, v) in padded[self.row_start(row)..][..width].iter_mut().zip(values) {
                *p = (v * scale) as f32;
            }
        }
    }

    pub fn load(&self, padded: &[f32], scale: f64, values: &mut [f64]) {
        let width = self.grid.side() * D;
        for (row, values) in values.chunks_exact_mut(width).enumerate() {
            for (v, p) in values.iter_mut().zip(&padded[self.row_start(row)..][..width]) {
                *v = f64::from(*p) * scale;
            }
        }
    }

    /// Σ A_ij x_j over the neighbours FROM.. in the stored half: 0 the node itself, 1 the next along x, 2 the ones in later
    /// rows. `blocks` is the node's row.
    #[inline(always)]
    fn product_after<const FROM: usize>(&self, blocks: &[f32], x: &[f32], place: usize) -> [f32; D] {
        let mut sum = [0.0; D];
        let shifts = &self.shifts[StencilOperator::<D>::CENTRE..];
        if D == 2 {
            // A block is a register: (a00 a01 a10 a11)·(x0 x1 x0 x1).
            let mut total = f32x4::ZERO;
            for slot in FROM..StencilOperator::<2>::HALF {
                let pair = &x[(place as isize + shifts[slot]) as usize..][..2];
                total += block_of(blocks, slot) * f32x4::from([pair[0], pair[1], pair[0], pair[1]]);
            }
            let total = total.to_array();
            sum[0] = total[0] + total[1];
            sum[1] = total[2] + total[3];
        } else {
            for slot in FROM..StencilOperator::<D>::HALF {
                let block = &blocks[slot * D * D..][..D * D];
                let values = &x[(place as isize + shifts[slot]) as usize..][..D];
                for i in 0..D {
                    for j in 0..D {
                        sum[i] += block[i * D + j] * values[j];
                    }
                }
            }
        }
        sum
    }

    /// Σ A_ij x_j over the neighbours in earlier rows and, if FROM is 1, not 2, the one before along x. Theirs are the
    /// blocks, transposed; `padded_blocks` with its margin, `node` counted from the margin's end.
    #[inline(always)]
    fn product_before<const FROM: usize>(
        &self,
        operator: &StencilOperator<D>,
        node: usize,
        x: &[f32],
        place: usize,
    ) -> [f32; D] {
        let mut sum = [0.0; D];
        let (blocks, node) = (operator.padded_blocks(), node + operator.margin());
        let shifts = &self.shifts[StencilOperator::<D>::CENTRE..];
        let row = |slot: usize| &blocks[(node - self.strides[slot]) * StencilOperator::<D>::ROW..];
        if D == 2 {
            let mut total = f32x4::ZERO;
            for slot in FROM..StencilOperator::<2>::HALF {
                let pair = &x[(place as isize - shifts[slot]) as usize..][..2];
                total += block_of(row(slot), slot) * f32x4::from([pair[0], pair[0], pair[1], pair[1]]);
            }
            let total = total.to_array();
            sum[0] = total[0] + total[2];
            sum[1] = total[1] + total[3];
        } else {
            for slot in FROM..StencilOperator::<D>::HALF {
                let block = &row(slot)[slot * D * D..][..D * D];
                let values = &x[(place as isize - shifts[slot]) as usize..][..D];
                for i in 0..D {
                    for j in 0..D {
                        sum[i] += block[j * D + i] * values[j];
                    }
                }
            }
        }
        sum
    }

    /// image = A x.
    pub fn apply(&self, operator: &StencilOperator<D>, x: &[f32], image: &mut [f32]) {
        self.for_each_node(operator, |node, blocks, place| {
            let after = self.product_after::<0>(blocks, x, place);
            let before = self.product_before::<1>(operator, node, x, place);
            for k in 0..D {
                image[place + k] = after[k] + before[k];
            }
        });
    }

    /// Calls `visit` with every node, its row of blocks and its position in the padded vectors.
    #[inline(always)]
    fn for_each_node(&self, operator: &StencilOperator<D>, mut visit: impl FnMut(usize, &[f32], usize)) {
        let side = self.grid.side();
        let mut rows = operator.blocks().chunks_exact(StencilOperator::<D>::ROW).enumerate();
        for row in 0..self.rows() {
            let start = self.row_start(row);
            for (column, (node, blocks)) in rows.by_ref().take(side).enumerate() {
                visit(node, blocks, start + column * D);
            }
        }
    }

    /// One block Gauss–Seidel sweep for A x = b from x = 0, in the order of the nodes, and the residual it leaves. With
    /// zeros ahead, the sweep needs the lower half of A only, and what it has not used by then is the upper half.
    pub fn sweep_from_zero(
        &self,
        operator: &StencilOperator<D>,
        inverse: &[f32],
        right: &[f32],
        x: &mut [f32],
        residual: &mut [f32],
    ) {
        let beside = StencilOperator::<D>::BLOCK;
        let mut left = [0.0; D];
        let mut towards_left = [[0.0; D]; D];
        self.for_each_node(operator, |node, blocks, place| {
            let before = self.product_before::<2>(operator, node, x, place);
            let rest = std::array::from_fn(|k| right[place + k] - before[k]);
            // The neighbour just computed comes in last, its block multiplied beforehand: it is what all waits for.
            let inverse = block_at::<D>(&inverse[node * D * D..]);
            let (own, coupled) = (times(&inverse, &rest), multiply(&inverse, &towards_left));
            let waited = times(&coupled, &left);
            let defect = times(&towards_left, &left);
            for k in 0..D {
                left[k] = own[k] - waited[k];
                x[place + k] = left[k];
                residual[place + k] = rest[k] - defect[k];
            }
            towards_left = transposed(&block_at::<D>(&blocks[beside..]));
        });
        self.for_each_node(operator, |_, blocks, place| {
            let after = self.product_after::<0>(blocks, x, place);
            for k in 0..D {
                residual[place + k] -= after[k];
            }
        });
    }

    /// One block Gauss–Seidel sweep against the order of the nodes.
    pub fn sweep_backward(&self, operator: &StencilOperator<D>, inverse: &[f32], right: &[f32], x: &mut [f32]) {
        let side = self.grid.side();
        for row in (0..self.rows()).rev() {
            let start = self.row_start(row);
            let mut beside = [0.0; D];
            for column in (0..side).rev() {
                let (node, place) = (row * side + column, start + column * D);
                let blocks = &operator.blocks()[node * StencilOperator::<D>::ROW..][..StencilOperator::<D>::ROW];
                let before = self.product_before::<1>(operator, node, x, place);
                let after = self.product_after::<2>(blocks, x, place);
                let now = std::array::from_fn(|k| x[place + k]);
                let centre = times(&block_at::<D>(blocks), &now);
                let rest = std::array::from_fn(|k| right[place + k] - before[k] - after[k] - centre[k]);
                let inverse = block_at::<D>(&inverse[node * D * D..]);
                let own = times(&inverse, &rest);
                let coupled = multiply(&inverse, &block_at::<D>(&blocks[D * D..]));
                let waited = times(&coupled, &beside);
                for k in 0..D {
                    beside[k] = (now[k] + own[k]) - waited[k];
                    x[place + k] = beside[k];
                }
            }
        }
    }

    /// coarse = Pᵀ fine.
    pub fn restrict(&self, fine: &[f32], coarse_layout: &Layout<D>, coarse: &mut [f32]) {
        let side = coarse_layout.grid.side();
        let shares = shares::<D>();
        for row in 0..coarse_layout.rows() {
            let (target, source) = (coarse_layout.row_start(row), self.fine_row_start(row, side));
            for column in 0..side {
                let place = source + 2 * column * D;
                let mut sum = [0.0; D];
                for neighbour in 0..StencilOperator::<D>::NEIGHBOURS {
                    let values = &fine[(place as isize + self.shifts[neighbour]) as usize..][..D];
                    for k in 0..D {
                        sum[k] += shares[neighbour] * values[k];
                    }
                }
                coarse[target + column * D..][..D].copy_from_slice(&sum);
            }
        }
    }

    /// fine += P coarse. What would fall beyond the grid is left out.
    pub fn prolongate_add(&self, coarse: &[f32], coarse_layout: &Layout<D>, fine: &mut [f32]) {
        let side = coarse_layout.grid.side();
        let shares = shares::<D>();
        for row in 0..coarse_layout.rows() {
            let (source, target) = (coarse_layout.row_start(row), self.fine_row_start(row, side));
            let index = row_index::<D>(row, side);
            for column in 0..side {
                let place = target + 2 * column * D;
                let values = &coarse[source + column * D..][..D];
                for neighbour in 0..StencilOperator::<D>::NEIGHBOURS {
                    let offset = StencilOperator::<D>::offset(neighbour);
                    let beyond = (0..D).any(|axis| {
                        let i = if axis == 0 { column } else { index[axis] };
                        (i == 0 && offset[axis] < 0) || (i == side - 1 && offset[axis] > 0)
                    });
                    if beyond {
                        continue;
                    }
                    let fine = &mut fine[(place as isize + self.shifts[neighbour]) as usize..][..D];
                    for k in 0..D {
                        fine[k] += shares[neighbour] * values[k];
                    }
                }
            }
        }
    }

    /// The position of the fine node under the first node of a coarse row.
    fn fine_row_start(&self, coarse_row: usize, coarse_side: usize) -> usize {
        let index = row_index::<D>(coarse_row, coarse_side);
        let row = index.iter().skip(1).rev().fold(0, |sum, &i| sum * self.grid.side() + 2 * i);
        self.row_start(row)
    }
}

/// The index of a row's first node.
fn row_index<const D: usize>(row: usize, side: usize) -> [usize; D] {
    let mut rest = row;
    std::array::from_fn(|axis| {
        if axis == 0 {
            return 0;
        }
        let i = rest % side;
        rest /= side;
        i
    })
}

/// The hat function's values at the neighbours of its centre.
fn shares<const D: usize>() -> [f32; MAX_NEIGHBOURS] {
    std::array::from_fn(|neighbour| {
        StencilOperator::<D>::offset(neighbour).iter().map(|&o| if o == 0 { 1.0 } else { 0.5 }).product()
    })
}

#[inline(always)]
fn block_of(blocks: &[f32], slot: usize) -> f32x4 {
    let block: &[f32; 4] = blocks[slot * 4..][..4].try_into().expect("a block has four numbers");
    f32x4::from(*block)
}

type Block<const D: usize> = [[f32; D]; D];

#[inline(always)]
fn block_at<const D: usize>(numbers: &[f32]) -> Block<D> {
    let numbers = &numbers[..D * D];
    std::array::from_fn(|i| std::array::from_fn(|j| numbers[i * D + j]))
}

#[inline(always)]
fn transposed<const D: usize>(block: &Block<D>) -> Block<D> {
    std::array::from_fn(|i| std::array::from_fn(|j| block[j][i]))
}

#[inline(always)]
fn times<const D: usize>(block: &Block<D>, x: &[f32; D]) -> [f32; D] {
    std::array::from_fn(|i| (0..D).map(|j| block[i][j] * x[j]).sum())
}

#[inline(always)]
fn multiply<const D: usize>(a: &Block<D>, b: &Block<D>) -> Block<D> {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..D).map(|k| a[i][k] * b[k][j]).sum()))
}
