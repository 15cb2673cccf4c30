//! The coarse operator Pᵀ A P of multilinear prolongation P, one axis after the other: P is a product of prolongations
//! along the axes, and the operators between are coarse along some of them only.

use crate::grid::Grid;
use crate::stencil::StencilOperator;

/// How one operator is made from the next finer one, and the memory for what lies between.
pub(super) struct Galerkin<const D: usize> {
    passes: Vec<Pass<D>>,
    /// What all passes but the last write.
    between: Vec<Vec<f32>>,
}

/// Coarsening along one axis. Operators are stored as in [`StencilOperator`], margins included.
struct Pass<const D: usize> {
    axis: usize,
    fine: Extent<D>,
    coarse: Extent<D>,
    /// By slot, for the first coarse node along the axis, those between, and the last.
    recipes: [Vec<Recipe>; 3],
}

/// The fine blocks whose weighted sum is a coarse block.
#[derive(Default)]
struct Recipe {
    as_stored: Vec<Route>,
    /// Their transposes are meant.
    transposed: Vec<Route>,
}

struct Route {
    /// In blocks, from the first one of the fine node under the coarse node.
    place: isize,
    share: f32,
}

/// Nodes a side by axis.
#[derive(Clone, Copy)]
struct Extent<const D: usize>([usize; D]);

impl<const D: usize> Extent<D> {
    fn stride(&self, axis: usize) -> usize {
        self.0[..axis].iter().product()
    }

    fn nodes(&self) -> usize {
        self.0.iter().product()
    }

    /// Nodes of zeros at either end.
    fn margin(&self) -> usize {
        (0..D).map(|axis| self.stride(axis)).sum()
    }
}

impl<const D: usize> Galerkin<D> {
    /// From an operator on `fine` to one on the grid of twice the spacing.
    pub fn new(fine: Grid<D>) -> Self {
        let mut extent = Extent([fine.side(); D]);
        let passes: Vec<Pass<D>> = (0..D)
            .map(|axis| {
                let mut coarse = extent;
                coarse.0[axis] = fine.cells() / 2 + 1;
                let pass = Pass::new(axis, extent, coarse);
                extent = coarse;
                pass
            })
            .collect();
        let size = |extent: &Extent<D>| (extent.nodes() + 2 * extent.margin()) * StencilOperator::<D>::ROW;
        let between = passes[..D - 1].iter().map(|pass| vec![0.0; size(&pass.coarse)]).collect();
        Self { passes, between }
    }

    /// Overwrites `coarse` with Pᵀ · `fine` · P.
    pub fn coarsen(&mut self, fine: &StencilOperator<D>, coarse: &mut StencilOperator<D>) {
        for (axis, pass) in self.passes.iter().enumerate() {
            let (done, ahead) = self.between.split_at_mut(axis);
            let source = done.last().map_or(fine.padded_blocks(), Vec::as_slice);
            let target = ahead.first_mut().map_or_else(|| coarse.padded_blocks_mut(), Vec::as_mut_slice);
            match D {
                2 => pass.run::<4>(source, target),
                3 => pass.run::<9>(source, target),
                _ => unreachable!("curves and surfaces live in 2 or 3 dimensions"),
            }
        }
    }
}

impl<const D: usize> Pass<D> {
    fn new(axis: usize, fine: Extent<D>, coarse: Extent<D>) -> Self {
        let slots = || 0..StencilOperator::<D>::HALF;
        let recipes = [[true, false], [true, true], [false, true]]
            .map(|[above, below]| slots().map(|slot| Recipe::new(axis, slot, &fine, below, above)).collect());
        Self { axis, fine, coarse, recipes }
    }

    /// With B = D² numbers a block, so that one is summed in registers.
    fn run<const B: usize>(&self, source: &[f32], target: &mut [f32]) {
        let half = StencilOperator::<D>::HALF;
        let (source, _) = source.as_chunks::<B>();
        let (target, _) = target.as_chunks_mut::<B>();
        let target = &mut target[self.coarse.margin() * half..][..self.coarse.nodes() * half];
        let width = self.coarse.0[0];
        for (row, target) in target.chunks_exact_mut(width * half).enumerate() {
            let mut under = self.fine.margin();
            let (mut rest, mut recipes) = (row, &self.recipes[1]);
            for k in 1..D {
                let (i, side) = (rest % self.coarse.0[k], self.coarse.0[k]);
                rest /= side;
                under += self.fine.stride(k) * if k == self.axis { 2 * i } else { i };
                if k == self.axis {
                    recipes = self.recipes_at(i);
                }
            }
            let step = if self.axis == 0 { 2 } else { 1 };
            for (column, sums) in target.chunks_exact_mut(half).enumerate() {
                let recipes = if self.axis == 0 { self.recipes_at(column) } else { recipes };
                let under = ((under + step * column) * half) as isize;
                for (sum, recipe) in sums.iter_mut().zip(recipes) {
                    *sum = Recipe::sum_of(&recipe.as_stored, source, under);
                    let turned = Recipe::sum_of(&recipe.transposed, source, under);
                    for i in 0..D {
                        for j in 0..D {
                            sum[i * D + j] += turned[j * D + i];
                        }
                    }
                }
            }
        }
    }

    fn recipes_at(&self, i: usize) -> &Vec<Recipe> {
        &self.recipes[if i == 0 { 0 } else { 1 + usize::from(i == self.coarse.0[self.axis] - 1) }]
    }
}

impl Recipe {
    /// A coarse block couples I with I + O along the axis: it is the sum over the fine nodes 2I + e and 2(I + O) + f of
    /// their blocks, each by its share in both. `below` and `above`: the grid goes on beyond I.
    fn new<const D: usize>(axis: usize, slot: usize, fine: &Extent<D>, below: bool, above: bool) -> Self {
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
            let mut node = e * fine.stride(axis) as isize;
            if !as_stored {
                // The other of the two nodes stores the block.
                node += (0..D).map(|k| towards[k] * fine.stride(k) as isize).sum::<isize>();
            }
            let slot = neighbour.abs_diff(StencilOperator::<D>::CENTRE);
            let place = node * StencilOperator::<D>::HALF as isize + slot as isize;
            let share = 0.5_f32.powi((e.abs() + f.abs()) as i32);
            let routes = if as_stored { &mut recipe.as_stored } else { &mut recipe.transposed };
            routes.push(Route { place, share });
        }
        recipe
    }

    #[inline(always)]
    fn sum_of<const B: usize>(routes: &[Route], source: &[[f32; B]], under: isize) -> [f32; B] {
        let mut sum = [0.0; B];
        for route in routes {
            let block = &source[(under + route.place) as usize];
            for k in 0..B {
                sum[k] += route.share * block[k];
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::super::padded::Layout;
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
                    let block = operator.block_mut(node, StencilOperator::<D>::CENTRE + slot);
                    for i in 0..D {
                        for j in 0..D {
                            number = (number + 0.37) % 1.0;
                            block[i * D + j] = if slot == 0 && i > j { block[j * D + i] } else { number };
                        }
                    }
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
        let mut small = vec![[0.0; D]; coarse_layout.len()];
        let (mut large, mut image) = (vec![[0.0; D]; layout.len()], vec![[0.0; D]; layout.len()]);
        coarse_layout.store(&values, 1.0, &mut small);
        layout.prolongate_add(&small, &coarse_layout, &mut large);
        layout.apply(&operator, &large, &mut image);
        let mut expected = vec![[0.0; D]; coarse_layout.len()];
        layout.restrict(&image, &coarse_layout, &mut expected);
        let mut found = vec![[0.0; D]; coarse_layout.len()];
        coarse_layout.apply(&coarsened, &small, &mut found);
        let (expected, found) = (expected.as_flattened(), found.as_flattened());
        let size = expected.iter().fold(0.0_f32, |most, value| most.max(value.abs()));
        assert!(size > 0.1);
        for (a, b) in expected.iter().zip(found) {
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
