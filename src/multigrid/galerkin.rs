//! The coarse operator Pᵀ A P of multilinear prolongation P, one axis after the other: P is a product of prolongations
//! along the axes, and the operators between are coarse along some of them only. Of these no more is kept than the next
//! axis needs at a time: a plane, then a row.

use crate::grid::Grid;
use crate::stencil::{Blocks, BlocksMut, LANES, Quad, StencilOperator, entries};
use wide::f32x4;

/// How one operator is made from the next finer one, and the memory for what lies between.
pub(super) struct Galerkin<const D: usize> {
    fine: Grid<D>,
    /// By axis.
    passes: [Pass; D],
    /// Rows of nodes that are coarse along z, of one plane; and one that is coarse along y and z. With a group of zeros
    /// first and last.
    plane: Between<D>,
    row: Between<D>,
}

/// Blocks of an operator between two grids.
struct Between<const D: usize> {
    own: Vec<f32>,
    later: Vec<f32>,
}

/// Coarsening along one axis: by slot, for the first coarse node along the axis, those between, and the last.
struct Pass([Vec<Recipe>; 3]);

/// The fine blocks whose weighted sum is a coarse block.
struct Recipe(Vec<Route>);

struct Route {
    /// From the row and the column of the fine node under the coarse node.
    rows: isize,
    columns: isize,
    slot: usize,
    /// The other of the two nodes stores the block.
    is_transposed: bool,
    share: f32,
}

impl<const D: usize> Galerkin<D> {
    /// From an operator on `fine` to one on the grid of twice the spacing.
    pub fn new(fine: Grid<D>) -> Self {
        let groups = fine.side() / LANES + 1;
        Self {
            fine,
            passes: std::array::from_fn(|axis| Pass::new(axis, fine)),
            plane: Between::new(if D == 3 { fine.side() * groups } else { 0 }),
            row: Between::new(groups),
        }
    }

    /// Overwrites `coarse` with Pᵀ · `fine` · P.
    pub fn coarsen(&mut self, fine: &StencilOperator<D>, coarse: &mut StencilOperator<D>) {
        match (D, fine.quads()) {
            (2, 4) => self.coarsen_blocks::<4, 4, 1>(fine.blocks(), fine, coarse),
            (3, 5) => self.coarsen_blocks::<9, 5, 4>(fine.blocks(), fine, coarse),
            #[cfg(test)]
            (3, 9) => self.coarsen_blocks::<9, 9, 4>(fine.blocks(), fine, coarse),
            _ => unreachable!("curves and surfaces live in 2 or 3 dimensions, where what is coarsened is rounded"),
        }
    }

    fn coarsen_blocks<const B: usize, const W: usize, const E: usize>(
        &mut self,
        source: Blocks<B, W, E>,
        fine: &StencilOperator<D>,
        coarse: &mut StencilOperator<D>,
    ) {
        let (side, coarse_side) = (self.fine.side(), coarse.grid().side());
        let (groups, margin) = (fine.groups(), fine.margin());
        let planes = if D == 3 { coarse_side } else { 1 };
        for k in 0..planes {
            if D == 3 {
                let recipes = self.passes[D - 1].at(k, coarse_side);
                for j in 0..side {
                    let under = (margin + 2 * k * side + j) * groups;
                    combine::<D, B, W, E>(recipes, source, under, side, self.plane.groups_mut(1 + j * groups, groups));
                }
            }
            for j in 0..coarse_side {
                let recipes = self.passes[1].at(j, coarse_side);
                let row = self.row.groups_mut(1, groups);
                if D == 3 {
                    combine::<D, B, B, E>(recipes, self.plane.groups(), 1 + 2 * j * groups, side, row);
                } else {
                    combine::<D, B, W, E>(recipes, source, (margin + 2 * j) * groups, side, row);
                }
                let row = self.row.groups();
                let mut target = coarse.row_mut::<B, E>(k * coarse_side + j);
                for i in 0..coarse_side {
                    for (slot, recipe) in self.passes[0].at(i, coarse_side).iter().enumerate() {
                        let block = recipe.sum_at::<D, B, E>(&row, LANES + 2 * i);
                        let (target, step) = target.slot(slot);
                        for (sum, entry) in target[i / LANES * step].iter_mut().zip(block) {
                            sum[i % LANES] = entry;
                        }
                    }
                }
            }
        }
    }
}

impl<const D: usize> Between<D> {
    fn new(groups: usize) -> Self {
        let numbers = |blocks: usize| vec![0.0; (groups + 2) * blocks * StencilOperator::<D>::BLOCK * LANES];
        Self { own: numbers(1), later: numbers(StencilOperator::<D>::LATER) }
    }

    fn groups<const B: usize, const E: usize>(&self) -> Blocks<'_, B, B, E> {
        Blocks::of(&self.own, &self.later)
    }

    fn groups_mut<const B: usize, const E: usize>(&mut self, first: usize, count: usize) -> BlocksMut<'_, B, E> {
        let own = &mut self.own[first * StencilOperator::<D>::BLOCK * LANES..];
        BlocksMut::of(own, &mut self.later, first, count)
    }
}

/// A row that is coarse along one axis, another than x, from the rows around `under`, the place of the first group of the
/// fine row under it. Slot by slot: what is to be added is then known for the whole row.
fn combine<const D: usize, const B: usize, const W: usize, const E: usize>(
    recipes: &[Recipe],
    source: Blocks<B, W, E>,
    under: usize,
    side: usize,
    mut target: BlocksMut<B, E>,
) {
    let groups = target.own.len();
    for (slot, recipe) in recipes.iter().enumerate() {
        let (target, step) = target.slot(slot);
        target.iter_mut().step_by(step).for_each(|block| *block = [[0.0; LANES]; B]);
        for route in &recipe.0 {
            // From the group before the row's first on.
            let before = (under - 1).wrapping_add_signed(route.rows * groups as isize);
            if route.slot == 0 {
                add_row::<D, B, B>(target, step, &source.own[before..], 1, route);
            } else {
                let (blocks, stride) = source.later(route.slot);
                add_row::<D, B, W>(target, step, &blocks[before * stride..], stride, route);
            }
        }
        // What was moved in from the next row.
        for lanes in &mut target[(groups - 1) * step] {
            lanes[side % LANES..].fill(0.0);
        }
    }
}

/// Adds the share of a route to every `step`-th block of a row, from every `stride`-th one of `source`, which begins a group
/// earlier.
#[inline(never)]
fn add_row<const D: usize, const B: usize, const W: usize>(
    target: &mut [[Quad; B]],
    step: usize,
    source: &[[Quad; W]],
    stride: usize,
    route: &Route,
) {
    let share = f32x4::splat(route.share);
    let block = |number: usize| entries::<B, W>(&source[number * stride]);
    for (group, sum) in target.iter_mut().step_by(step).enumerate() {
        let block = match (route.is_transposed, route.columns) {
            (false, _) | (_, 0) => block(group + 1),
            (_, 1) => moved(block(group + 1), block(group + 2), |now, next| [now[1], now[2], now[3], next[0]]),
            _ => moved(block(group), block(group + 1), |last, now| [last[3], now[0], now[1], now[2]]),
        };
        for i in 0..D {
            for j in 0..D {
                let sum = &mut sum[i * D + j];
                let entry = block[if route.is_transposed { j * D + i } else { i * D + j }];
                *sum = (f32x4::from(*sum) + share * entry).to_array();
            }
        }
    }
}

#[inline(always)]
fn moved<const B: usize>(first: [f32x4; B], second: [f32x4; B], lanes: impl Fn(Quad, Quad) -> Quad) -> [f32x4; B] {
    std::array::from_fn(|k| f32x4::from(lanes(first[k].to_array(), second[k].to_array())))
}

impl Pass {
    fn new<const D: usize>(axis: usize, fine: Grid<D>) -> Self {
        let slots = || 0..StencilOperator::<D>::HALF;
        Self(
            [[true, false], [true, true], [false, true]]
                .map(|[above, below]| slots().map(|slot| Recipe::new(axis, slot, fine, below, above)).collect()),
        )
    }

    fn at(&self, i: usize, side: usize) -> &[Recipe] {
        &self.0[if i == 0 { 0 } else { 1 + usize::from(i == side - 1) }]
    }
}

impl Recipe {
    /// A coarse block couples I with I + O along the axis: it is the sum over the fine nodes 2I + e and 2(I + O) + f of
    /// their blocks, each by its share in both. `below` and `above`: the grid goes on beyond I.
    fn new<const D: usize>(axis: usize, slot: usize, fine: Grid<D>, below: bool, above: bool) -> Self {
        let offset = StencilOperator::<D>::offset(StencilOperator::<D>::CENTRE + slot);
        let on_grid = |place: isize| (place >= 0 || below) && (place <= 0 || above);
        let mut routes = Vec::new();
        let ends = || (-1..=1).flat_map(|e| (-1..=1).map(move |f| (e, f)));
        for (is_transposed, (e, f)) in ends().map(|ends| (false, ends)).chain(ends().map(|ends| (true, ends))) {
            let mut towards = offset;
            towards[axis] = 2 * offset[axis] + f - e;
            if towards[axis].abs() > 1 || !on_grid(e) || !on_grid(2 * offset[axis] + f) {
                continue;
            }
            let neighbour = StencilOperator::<D>::neighbour(towards);
            if is_transposed != (neighbour < StencilOperator::<D>::CENTRE) {
                continue;
            }
            let mut node = [0; D];
            node[axis] = e;
            if is_transposed {
                node = std::array::from_fn(|k| node[k] + towards[k]);
            }
            routes.push(Route {
                rows: node[1..].iter().rev().fold(0, |rows, &o| rows * fine.side() as isize + o),
                columns: node[0],
                slot: neighbour.abs_diff(StencilOperator::<D>::CENTRE),
                is_transposed,
                share: 0.5_f32.powi((e.abs() + f.abs()) as i32),
            });
        }
        Self(routes)
    }

    /// The block of the coarse node over a column of a row, the row with a group of zeros first.
    fn sum_at<const D: usize, const B: usize, const E: usize>(&self, row: &Blocks<B, B, E>, column: usize) -> [f32; B] {
        let mut sum = [0.0; B];
        for route in &self.0 {
            let place = column.wrapping_add_signed(route.columns);
            let (blocks, step) = row.slot(route.slot);
            let block = &blocks[place / LANES * step];
            for i in 0..D {
                for j in 0..D {
                    let entry = if route.is_transposed { j * D + i } else { i * D + j };
                    sum[i * D + j] += route.share * block[entry][place % LANES];
                }
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::super::padded::Layout;
    use super::super::sweep::Scratch;
    use super::*;

    /// A symmetric operator without any other structure.
    fn arbitrary<const D: usize>(grid: Grid<D>) -> StencilOperator<D> {
        let mut operator = StencilOperator::zero(grid);
        let mut number = 0.0_f32;
        for node in 0..grid.node_count() {
            for slot in 0..StencilOperator::<D>::HALF {
                let offset = StencilOperator::<D>::offset(StencilOperator::<D>::CENTRE + slot);
                let index = grid.node_index(node);
                if (0..D).all(|k| (0..grid.side() as isize).contains(&(index[k] as isize + offset[k]))) {
                    let mut block = [[0.0; D]; D];
                    for i in 0..D {
                        for j in 0..D {
                            number = (number + 0.37) % 1.0;
                            block[i][j] = if slot == 0 && i > j { block[j][i] } else { number };
                        }
                    }
                    let place = [node / grid.side(), node % grid.side()];
                    operator.add(place, StencilOperator::<D>::CENTRE + slot, &block);
                }
            }
        }
        operator
    }

    fn agrees_with_restriction_of_prolongations<const D: usize>(cells: usize) {
        let (fine, coarse) = (Grid::<D>::new(cells), Grid::<D>::new(cells / 2));
        let operator = arbitrary(fine);
        let mut coarsened = StencilOperator::zero(coarse);
        Galerkin::new(fine).coarsen(&operator, &mut coarsened);

        let (layout, coarse_layout) = (Layout::new(fine), Layout::new(coarse));
        let values: Vec<f64> = (0..coarse.node_count() * D).map(|k| (0.7 * k as f64).sin()).collect();
        let mut small = vec![0.0; coarse_layout.len()];
        let (mut large, mut image) = (vec![0.0; layout.len()], vec![0.0; layout.len()]);
        let (mut scratch, mut coarse_scratch) = (Scratch::new(&layout), Scratch::new(&coarse_layout));
        coarse_layout.store(&values, 1.0, &mut small);
        layout.prolongate_add(&small, &coarse_layout, &mut large, &mut scratch.line);
        layout.apply(&operator, &large, &mut image, &mut scratch);
        let mut expected = vec![0.0; coarse_layout.len()];
        layout.restrict(&image, &coarse_layout, &mut expected, &mut scratch.line);
        let mut found = vec![0.0; coarse_layout.len()];
        coarse_layout.apply(&coarsened, &small, &mut found, &mut coarse_scratch);
        let size = expected.iter().fold(0.0_f32, |most, value| most.max(value.abs()));
        assert!(size > 0.1);
        for (a, b) in expected.iter().zip(&found) {
            assert!((a - b).abs() < 1e-5 * size, "{a} is not {b}");
        }
    }

    #[test]
    fn the_coarse_operator_is_restriction_after_the_fine_one_after_prolongation() {
        for cells in [4, 6, 16] {
            agrees_with_restriction_of_prolongations::<2>(cells);
            agrees_with_restriction_of_prolongations::<3>(cells);
        }
    }
}
