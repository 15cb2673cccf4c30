//! The coarse operator Pᵀ A P of multilinear prolongation P, one axis after the other: P is a product of prolongations
//! along the axes, and the operators between are coarse along some of them only. Of these no more is kept than the next
//! axis needs at a time: a plane, then a row.

use crate::grid::Grid;
use crate::stencil::{Group, LANES, StencilOperator};
use wide::f32x4;

/// How one operator is made from the next finer one, and the memory for what lies between.
pub(super) struct Galerkin<const D: usize> {
    fine: Grid<D>,
    /// By axis.
    passes: [Pass; D],
    /// Rows of nodes that are coarse along z, of one plane; and one that is coarse along y and z. With a group of zeros
    /// first and last.
    plane: Vec<f32>,
    row: Vec<f32>,
}

/// Coarsening along one axis: by slot, for the first coarse node along the axis, those between, and the last.
struct Pass([Vec<Recipe>; 3]);

/// The fine blocks whose weighted sum is a coarse block.
#[derive(Default)]
struct Recipe {
    as_stored: Vec<Route>,
    /// Their transposes are meant.
    transposed: Vec<Route>,
}

struct Route {
    /// From the row and the column of the fine node under the coarse node.
    rows: isize,
    columns: isize,
    slot: usize,
    share: f32,
}

impl<const D: usize> Galerkin<D> {
    /// From an operator on `fine` to one on the grid of twice the spacing.
    pub fn new(fine: Grid<D>) -> Self {
        let groups = fine.side() / LANES + 1;
        let memory = |groups: usize| vec![0.0; (groups + 2) * StencilOperator::<D>::ROW * LANES];
        Self {
            fine,
            passes: std::array::from_fn(|axis| Pass::new(axis, fine)),
            plane: memory(if D == 3 { fine.side() * groups } else { 0 }),
            row: memory(groups),
        }
    }

    /// Overwrites `coarse` with Pᵀ · `fine` · P.
    pub fn coarsen(&mut self, fine: &StencilOperator<D>, coarse: &mut StencilOperator<D>) {
        match D {
            2 => self.coarsen_blocks::<4, 5>(fine, coarse),
            3 => self.coarsen_blocks::<9, 14>(fine, coarse),
            _ => unreachable!("curves and surfaces live in 2 or 3 dimensions"),
        }
    }

    fn coarsen_blocks<const B: usize, const H: usize>(
        &mut self,
        fine: &StencilOperator<D>,
        coarse: &mut StencilOperator<D>,
    ) {
        let (side, coarse_side) = (self.fine.side(), coarse.grid().side());
        let (groups, coarse_groups) = (fine.groups(), coarse.groups());
        let (margin, coarse_margin) = (fine.margin(), coarse.margin());
        let source = fine.padded::<B, H>();
        let target = coarse.padded_mut::<B, H>();
        let plane = groups_of::<B, H>(&mut self.plane);
        let row = groups_of::<B, H>(&mut self.row);
        let planes = if D == 3 { coarse_side } else { 1 };
        for k in 0..planes {
            if D == 3 {
                let recipes = self.passes[D - 1].at(k, coarse_side);
                for j in 0..side {
                    let under = (margin + 2 * k * side + j) * groups;
                    combine::<D, B, H>(recipes, source, under, groups, side, &mut plane[1 + j * groups..][..groups]);
                }
            }
            for j in 0..coarse_side {
                let recipes = self.passes[1].at(j, coarse_side);
                let (source, under) =
                    if D == 3 { (&*plane, 1 + 2 * j * groups) } else { (source, (margin + 2 * j) * groups) };
                combine::<D, B, H>(recipes, source, under, groups, side, &mut row[1..][..groups]);
                let target = &mut target[(coarse_margin + k * coarse_side + j) * coarse_groups..][..coarse_groups];
                for i in 0..coarse_side {
                    let group = &mut target[i / LANES];
                    for (sum, recipe) in group.iter_mut().zip(self.passes[0].at(i, coarse_side)) {
                        let block = recipe.sum_at::<D, B, H>(row, LANES + 2 * i);
                        for (sum, entry) in sum.iter_mut().zip(block) {
                            sum[i % LANES] = entry;
                        }
                    }
                }
            }
        }
    }
}

fn groups_of<const B: usize, const H: usize>(numbers: &mut [f32]) -> &mut [Group<B, H>] {
    numbers.as_chunks_mut().0.as_chunks_mut().0.as_chunks_mut().0
}

/// A row that is coarse along one axis, another than x, from the rows around `under`, the place of the first group of the
/// fine row under it.
fn combine<const D: usize, const B: usize, const H: usize>(
    recipes: &[Recipe],
    source: &[Group<B, H>],
    under: usize,
    groups: usize,
    side: usize,
    target: &mut [Group<B, H>],
) {
    for (group, target) in target.iter_mut().enumerate() {
        for (block, recipe) in target.iter_mut().zip(recipes) {
            let mut sum = [f32x4::ZERO; B];
            let place = |route: &Route| (under + group).wrapping_add_signed(route.rows * groups as isize);
            for route in &recipe.as_stored {
                let (block, share) = (&source[place(route)][route.slot], f32x4::splat(route.share));
                for (sum, entry) in sum.iter_mut().zip(block) {
                    *sum += share * f32x4::from(*entry);
                }
            }
            for route in &recipe.transposed {
                let (place, share) = (place(route), f32x4::splat(route.share));
                let block = match route.columns {
                    0 => source[place][route.slot],
                    1 => moved(&source[place][route.slot], &source[place + 1][route.slot], |now, next| {
                        [now[1], now[2], now[3], next[0]]
                    }),
                    _ => moved(&source[place - 1][route.slot], &source[place][route.slot], |last, now| {
                        [last[3], now[0], now[1], now[2]]
                    }),
                };
                for i in 0..D {
                    for j in 0..D {
                        sum[i * D + j] += share * f32x4::from(block[j * D + i]);
                    }
                }
            }
            *block = sum.map(|lanes| lanes.to_array());
        }
    }
    // What was moved in from the next row.
    for entry in target[groups - 1].as_flattened_mut() {
        entry[side % LANES..].fill(0.0);
    }
}

#[inline(always)]
fn moved<const B: usize>(
    first: &[[f32; LANES]; B],
    second: &[[f32; LANES]; B],
    lanes: impl Fn(&[f32; LANES], &[f32; LANES]) -> [f32; LANES],
) -> [[f32; LANES]; B] {
    std::array::from_fn(|k| lanes(&first[k], &second[k]))
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
        let mut recipe = Self::default();
        for (e, f) in (-1..=1).flat_map(|e| (-1..=1).map(move |f| (e, f))) {
            let mut towards = offset;
            towards[axis] = 2 * offset[axis] + f - e;
            if towards[axis].abs() > 1 || !on_grid(e) || !on_grid(2 * offset[axis] + f) {
                continue;
            }
            let neighbour = StencilOperator::<D>::neighbour(towards);
            let as_stored = neighbour >= StencilOperator::<D>::CENTRE;
            let mut node = [0; D];
            node[axis] = e;
            if !as_stored {
                // The other of the two nodes stores the block.
                node = std::array::from_fn(|k| node[k] + towards[k]);
            }
            let routes = if as_stored { &mut recipe.as_stored } else { &mut recipe.transposed };
            routes.push(Route {
                rows: node[1..].iter().rev().fold(0, |rows, &o| rows * fine.side() as isize + o),
                columns: node[0],
                slot: neighbour.abs_diff(StencilOperator::<D>::CENTRE),
                share: 0.5_f32.powi((e.abs() + f.abs()) as i32),
            });
        }
        recipe
    }

    /// The block of the coarse node over a column of a row, the row with a group of zeros first.
    fn sum_at<const D: usize, const B: usize, const H: usize>(&self, row: &[Group<B, H>], column: usize) -> [f32; B] {
        let mut sum = [0.0; B];
        let place = |route: &Route| column.wrapping_add_signed(route.columns);
        for route in &self.as_stored {
            let (block, lane) = (&row[place(route) / LANES][route.slot], place(route) % LANES);
            for (sum, entry) in sum.iter_mut().zip(block) {
                *sum += route.share * entry[lane];
            }
        }
        for route in &self.transposed {
            let (block, lane) = (&row[place(route) / LANES][route.slot], place(route) % LANES);
            for i in 0..D {
                for j in 0..D {
                    sum[i * D + j] += route.share * block[j * D + i][lane];
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
