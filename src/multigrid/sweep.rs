//! Products of an operator with padded vectors, and the smoother made of them, one row of nodes after the other. Within a
//! row four nodes go at a time; only what couples a node with the one before it goes node by node.

use super::padded::{Layout, Nodes};
use crate::stencil::{A_ROW, Blocks, LANES, Quad, StencilOperator, entries};
use wide::f32x4;

/// Share of the Gauss–Seidel correction that is applied, within the inverse diagonal blocks. On the Sobolev operator a
/// cycle reduces the error by 0.20 with 1, 0.19 with 0.95, 0.17 with 0.9 and 0.23 with 1.1, at worst over the levels.
const DAMPING: f32 = 0.9;

/// The memory of a sweep, for one row.
pub(super) struct Scratch<const D: usize> {
    /// Σ A_jiᵀ x_j by the node j that stores the block, for neighbours i at −1, 0 and 1 along x.
    from_earlier: [[Vec<f32>; D]; A_ROW],
    /// What a node is without the one just computed, and the block that couples it with that one.
    alone: [Vec<f32>; D],
    coupled: [[Vec<f32>; D]; D],
    /// A line between two grids.
    pub line: Vec<f32>,
}

impl<const D: usize> Scratch<D> {
    pub fn new(layout: &Layout<D>) -> Self {
        // Shifted along x a line is read to beyond its ends.
        let line = || vec![0.0; layout.line + LANES];
        Self {
            from_earlier: std::array::from_fn(|_| std::array::from_fn(|_| line())),
            alone: std::array::from_fn(|_| line()),
            coupled: std::array::from_fn(|_| std::array::from_fn(|_| line())),
            line: line(),
        }
    }
}

/// The lanes one node on, the last of `before` first.
#[inline(always)]
fn shifted(before: f32x4, lanes: f32x4) -> f32x4 {
    let (before, lanes) = (before.to_array(), lanes.to_array());
    f32x4::from([before[3], lanes[0], lanes[1], lanes[2]])
}

type Lanes<const D: usize> = [f32x4; D];

/// sum += block · x.
#[inline(always)]
fn add_product<const D: usize, const B: usize>(sum: &mut Lanes<D>, block: [f32x4; B], x: &Lanes<D>) {
    for i in 0..D {
        for j in 0..D {
            sum[i] += block[i * D + j] * x[j];
        }
    }
}

/// sum += blockᵀ · x.
#[inline(always)]
fn add_turned_product<const D: usize, const B: usize>(sum: &mut Lanes<D>, block: [f32x4; B], x: &Lanes<D>) {
    for i in 0..D {
        for j in 0..D {
            sum[i] += block[j * D + i] * x[j];
        }
    }
}

/// ω (A + s I)⁻¹ of symmetric positive semi-definite blocks A, one a lane, by L D Lᵀ of A + s I; ω is the damping, and s, a
/// millionth of the trace, keeps the inverse bounded where clipping negative curvature has left A singular.
#[inline(always)]
fn damped_inverse<const D: usize, const B: usize>(block: [f32x4; B]) -> [f32x4; B] {
    let mut least = f32x4::splat(f32::MIN_POSITIVE);
    for k in 0..D {
        least += f32x4::splat(1e-6) * block[k * D + k];
    }
    let mut lower = [[f32x4::ZERO; D]; D];
    let (mut pivots, mut inverse_pivots) = ([f32x4::ZERO; D], [f32x4::ZERO; D]);
    for i in 0..D {
        let mut pivot = block[i * D + i] + least;
        for j in 0..i {
            let mut entry = block[i * D + j];
            for k in 0..j {
                entry -= lower[i][k] * pivots[k] * lower[j][k];
            }
            lower[i][j] = entry * inverse_pivots[j];
            pivot -= entry * lower[i][j];
        }
        pivots[i] = pivot.fast_max(least);
        inverse_pivots[i] = f32x4::ONE / pivots[i];
    }
    // L⁻¹.
    let mut solved = [[f32x4::ZERO; D]; D];
    for i in 0..D {
        solved[i][i] = f32x4::ONE;
        for j in 0..i {
            for k in j..i {
                solved[i][j] -= lower[i][k] * solved[k][j];
            }
        }
    }
    let mut inverse = [f32x4::ZERO; B];
    for k in 0..D {
        for i in 0..=k {
            let scaled = f32x4::splat(DAMPING) * inverse_pivots[k] * solved[k][i];
            for j in 0..=k {
                inverse[i * D + j] += scaled * solved[k][j];
            }
        }
    }
    inverse
}

/// Calls a method with the entries of a block, the [`Quad`]s it takes and the earlier rows next to a row
/// that D has, which the type system cannot compute. In space an operator may be rounded.
macro_rules! by_dimension {
    ($operator:expr, $layout:ident.$method:ident($($argument:expr),*)) => {
        match (D, $operator.quads()) {
            (2, 4) => $layout.$method::<4, 4, 1>($operator.blocks(), $($argument),*),
            (3, 5) => $layout.$method::<9, 5, 4>($operator.blocks(), $($argument),*),
            #[cfg(test)]
            (3, 9) => $layout.$method::<9, 9, 4>($operator.blocks(), $($argument),*),
            _ => unreachable!("curves and surfaces live in 2 or 3 dimensions, where what is swept is rounded"),
        }
    };
}

impl<const D: usize> Layout<D> {
    /// image = A x.
    pub fn apply(&self, operator: &StencilOperator<D>, x: &Nodes, image: &mut Nodes, scratch: &mut Scratch<D>) {
        by_dimension!(operator, self.apply_blocks(x, image, scratch));
    }

    fn apply_blocks<const B: usize, const W: usize, const E: usize>(
        &self,
        blocks: Blocks<B, W, E>,
        x: &Nodes,
        image: &mut Nodes,
        scratch: &mut Scratch<D>,
    ) {
        for row in 0..self.rows() {
            self.gather_earlier(blocks, row, x, scratch);
            self.put_earlier(row, None, image, scratch);
            self.add_rest(blocks, row, x, 1.0, image);
        }
    }

    /// One block Gauss–Seidel sweep for A x = b from x = 0, in the order of the nodes, and the residual it leaves. With
    /// zeros ahead, the sweep needs the lower half of A only, and what it has not used by then is the upper half.
    pub fn sweep_from_zero(
        &self,
        operator: &StencilOperator<D>,
        right: &Nodes,
        x: &mut Nodes,
        residual: &mut Nodes,
        scratch: &mut Scratch<D>,
    ) {
        by_dimension!(operator, self.sweep_blocks_from_zero(right, x, residual, scratch));
    }

    fn sweep_blocks_from_zero<const B: usize, const W: usize, const E: usize>(
        &self,
        blocks: Blocks<B, W, E>,
        right: &Nodes,
        x: &mut Nodes,
        residual: &mut Nodes,
        scratch: &mut Scratch<D>,
    ) {
        let (side, rows) = (self.side(), self.rows());
        // A row's residual waits for the rows that its neighbours lie in.
        let lag = rows / side + 1;
        for row in 0..rows + lag {
            if row < rows {
                let start = self.row_start(row);
                for k in 0..D {
                    x[start + k * self.line..][..side].fill(0.0);
                }
                self.gather_earlier(blocks, row, x, scratch);
                self.put_earlier(row, Some(right), residual, scratch);
                let mut before = [[f32x4::ZERO; D]; D];
                self.prepare(blocks, row, residual, scratch, |stored, i, j| {
                    let entry = stored[j * D + i];
                    shifted(std::mem::replace(&mut before[i][j], entry), entry)
                });
                self.substitute(0..side, scratch, start, x);
            }
            if row >= lag {
                self.add_rest(blocks, row - lag, x, -1.0, residual);
            }
        }
    }

    /// One block Gauss–Seidel sweep against the order of the nodes. `scrap` is memory for a vector.
    pub fn sweep_backward(
        &self,
        operator: &StencilOperator<D>,
        right: &Nodes,
        x: &mut Nodes,
        scrap: &mut Nodes,
        scratch: &mut Scratch<D>,
    ) {
        by_dimension!(operator, self.sweep_blocks_backward(right, x, scrap, scratch));
    }

    fn sweep_blocks_backward<const B: usize, const W: usize, const E: usize>(
        &self,
        blocks: Blocks<B, W, E>,
        right: &Nodes,
        x: &mut Nodes,
        scrap: &mut Nodes,
        scratch: &mut Scratch<D>,
    ) {
        for row in (0..self.rows()).rev() {
            self.gather_earlier(blocks, row, x, scratch);
            self.put_earlier(row, Some(right), scrap, scratch);
            self.add_rest(blocks, row, x, -1.0, scrap);
            self.prepare(blocks, row, scrap, scratch, |stored, i, j| stored[i * D + j]);
            self.substitute((0..self.side()).rev(), scratch, self.row_start(row), x);
        }
    }

    /// The groups of a row.
    #[inline(always)]
    fn own<'a, const B: usize, const W: usize, const E: usize>(
        &self,
        blocks: Blocks<'a, B, W, E>,
        row: usize,
    ) -> Blocks<'a, B, W, E> {
        let first = (self.margin + row) * self.groups;
        Blocks {
            own: &blocks.own[first..][..self.groups],
            next: &blocks.next[first..][..self.groups],
            rows: blocks.rows.map(|row| &row[first..][..self.groups]),
        }
    }

    /// Sums A_jiᵀ x_j over the earlier rows' nodes j into the scratch.
    #[inline(never)]
    fn gather_earlier<const B: usize, const W: usize, const E: usize>(
        &self,
        blocks: Blocks<B, W, E>,
        row: usize,
        x: &Nodes,
        scratch: &mut Scratch<D>,
    ) {
        let start = self.row_start(row);
        // The slot in the middle of a row's three does not move along x.
        let middle = |earlier: usize| 2 + A_ROW * earlier + 1;
        let rows: [_; E] = std::array::from_fn(|earlier| {
            &blocks.rows[earlier][(self.margin + row - self.strides[middle(earlier)]) * self.groups..][..self.groups]
        });
        let x: [_; E] = std::array::from_fn(|earlier| self.row(x, start - self.shifts[middle(earlier)]));
        let mut sums = scratch.from_earlier.each_mut().map(|lines| self.lines_mut(lines));
        for group in 0..self.groups {
            let mut sum = [[f32x4::ZERO; D]; A_ROW];
            for earlier in 0..E {
                let (stored, x) = (&rows[earlier][group], at(&x[earlier], group));
                for (along, sum) in sum.iter_mut().enumerate() {
                    add_turned_product(sum, entries::<B, W>(&stored[along]), &x);
                }
            }
            for (sum, sums) in sum.iter().zip(&mut sums) {
                put(sum, sums, group);
            }
        }
    }

    /// To a row of `target`: of these, what comes to its nodes; or what it leaves of the right side.
    #[inline(never)]
    fn put_earlier(&self, row: usize, right: Option<&Nodes>, target: &mut Nodes, scratch: &Scratch<D>) {
        let start = self.row_start(row);
        let [behind, under, ahead] = &scratch.from_earlier;
        let from =
            [(behind, LANES + 1), (under, LANES), (ahead, LANES - 1)].map(|(lines, first)| self.lines(lines, first));
        let right = right.map(|right| self.row(right, start));
        let mut target = self.row_mut(target, start);
        for group in 0..self.groups {
            let [behind, under, ahead] = from.each_ref().map(|lines| at(lines, group));
            let sum: Lanes<D> = std::array::from_fn(|k| behind[k] + under[k] + ahead[k]);
            let sum = match &right {
                Some(right) => {
                    let right = at(right, group);
                    std::array::from_fn(|k| right[k] - sum[k])
                }
                None => sum,
            };
            put(&sum, &mut target, group);
        }
    }

    /// Adds to a row of `target` the share of what A x has there from the row itself and the later ones.
    #[inline(never)]
    fn add_rest<const B: usize, const W: usize, const E: usize>(
        &self,
        blocks: Blocks<B, W, E>,
        row: usize,
        x: &Nodes,
        share: f32,
        target: &mut Nodes,
    ) {
        let (start, share) = (self.row_start(row), f32x4::splat(share));
        let own = self.own(blocks, row);
        let here = self.row(x, start);
        let next = self.row(x, start + self.shifts[1]);
        let x: [[_; A_ROW]; E] = std::array::from_fn(|later| {
            std::array::from_fn(|k| self.row(x, start + self.shifts[2 + A_ROW * later + k]))
        });
        let mut target = self.row_mut(target, start);
        let mut left = [f32x4::ZERO; D];
        for group in 0..self.groups {
            let here = at(&here, group);
            let mut sum = [f32x4::ZERO; D];
            add_product(&mut sum, entries::<B, B>(&own.own[group]), &here);
            add_product(&mut sum, entries::<B, W>(&own.next[group]), &at(&next, group));
            for (row, x) in own.rows.iter().zip(&x) {
                for (block, x) in row[group].iter().zip(x) {
                    add_product(&mut sum, entries::<B, W>(block), &at(x, group));
                }
            }
            // The node before each stores the block; the product of the last is for the next group.
            let mut product = [f32x4::ZERO; D];
            add_turned_product(&mut product, entries::<B, W>(&own.next[group]), &here);
            let there: Lanes<D> = std::array::from_fn(|k| f32x4::from(target[k][group]));
            let sum = std::array::from_fn(|k| there[k] + share * (sum[k] + shifted(left[k], product[k])));
            left = product;
            put(&sum, &mut target, group);
        }
    }

    /// The corrections of a row's nodes: what each is alone, and the block that couples it with the one corrected before.
    /// That one comes in last, its block multiplied beforehand: all waits for it. `coupling` gives entry (i, j) of A there,
    /// of the block that couples a node with the next.
    fn prepare<const B: usize, const W: usize, const E: usize>(
        &self,
        blocks: Blocks<B, W, E>,
        row: usize,
        residual: &Nodes,
        scratch: &mut Scratch<D>,
        mut coupling: impl FnMut(&[f32x4; B], usize, usize) -> f32x4,
    ) {
        let own = self.own(blocks, row);
        let residual = self.row(residual, self.row_start(row));
        let mut alone = self.lines_mut(&mut scratch.alone);
        let mut coupled = scratch.coupled.each_mut().map(|lines| self.lines_mut(lines));
        for group in 0..self.groups {
            let mut sum = [f32x4::ZERO; D];
            let inverse = damped_inverse::<D, B>(entries::<B, B>(&own.own[group]));
            let next = entries::<B, W>(&own.next[group]);
            add_product(&mut sum, inverse, &at(&residual, group));
            put(&sum, &mut alone, group);
            for j in 0..D {
                let column: Lanes<D> = std::array::from_fn(|i| coupling(&next, i, j));
                let mut sum = [f32x4::ZERO; D];
                add_product(&mut sum, inverse, &column);
                put(&sum, &mut coupled[j], group);
            }
        }
    }

    /// x_i += c_i with c_i = alone_i − coupled_i c_j, j the node before i in the order of the columns.
    #[inline(always)]
    fn substitute(&self, columns: impl Iterator<Item = usize>, scratch: &Scratch<D>, start: usize, x: &mut Nodes) {
        let side = self.side();
        let alone = scratch.alone.each_ref().map(|line| &line[LANES..][..side]);
        let coupled = scratch.coupled.each_ref().map(|lines| lines.each_ref().map(|line| &line[LANES..][..side]));
        let row = self.row_mut(x, start).map(|line| &mut line.as_flattened_mut()[..side]);
        let mut last = [0.0; D];
        for column in columns {
            let mut next: [f32; D] = std::array::from_fn(|k| alone[k][column]);
            for j in 0..D {
                for k in 0..D {
                    next[k] -= coupled[j][k][column] * last[j];
                }
            }
            last = next;
            for k in 0..D {
                row[k][column] += last[k];
            }
        }
    }

    /// The groups of a line from a number on: sliced once, so that no access is checked.
    #[inline(always)]
    fn groups_of<'a>(&self, line: &'a [f32], first: usize) -> &'a [Quad] {
        &line[first..].as_chunks().0[..self.groups]
    }

    /// The lines of a row of nodes, of which the first begins at `start`.
    #[inline(always)]
    fn row<'a>(&self, x: &'a Nodes, start: usize) -> [&'a [Quad]; D] {
        std::array::from_fn(|k| self.groups_of(x, start + k * self.line))
    }

    #[inline(always)]
    fn row_mut<'a>(&self, x: &'a mut Nodes, start: usize) -> [&'a mut [Quad]; D] {
        let mut rest = &mut x[start..];
        std::array::from_fn(|_| {
            let (line, next) = std::mem::take(&mut rest).split_at_mut(self.line);
            rest = next;
            &mut line.as_chunks_mut().0[..self.groups]
        })
    }

    #[inline(always)]
    fn lines<'a>(&self, lines: &'a [Vec<f32>; D], first: usize) -> [&'a [Quad]; D] {
        lines.each_ref().map(|line| self.groups_of(line, first))
    }

    #[inline(always)]
    fn lines_mut<'a>(&self, lines: &'a mut [Vec<f32>; D]) -> [&'a mut [Quad]; D] {
        lines.each_mut().map(|line| &mut line[LANES..].as_chunks_mut().0[..self.groups])
    }
}

#[inline(always)]
fn at<const D: usize>(lines: &[&[Quad]; D], group: usize) -> Lanes<D> {
    std::array::from_fn(|k| f32x4::from(lines[k][group]))
}

#[inline(always)]
fn put<const D: usize>(lanes: &Lanes<D>, lines: &mut [&mut [Quad]; D], group: usize) {
    for (lanes, line) in lanes.iter().zip(lines) {
        line[group] = lanes.to_array();
    }
}
