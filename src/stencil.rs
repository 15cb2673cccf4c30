//! Symmetric block operators on nodal vectors that couple a node with its 3^D neighbours.

use crate::grid::{Grid, MAX_CORNERS};
use crate::small::F32x4;

/// Upper bound of 3^D.
pub const MAX_NEIGHBOURS: usize = 27;

/// Nodes of a row that lie side by side in memory, so that a register takes a number of each.
pub const LANES: usize = 4;

/// The blocks of [`LANES`] nodes: by neighbour from the node itself on, row and column of the block, and node. B = D²,
/// H = [`StencilOperator::HALF`], which the type system cannot compute.
pub type Group<const B: usize, const H: usize> = [[[f32; LANES]; B]; H];

/// The upper half of a symmetric operator: a D×D block, f32, for each node and each neighbour that does not come before
/// it in the order of the nodes. The blocks of the neighbours before it are theirs, transposed.
///
/// f32 is enough because the operator only serves to find a direction to a relative 0.1 or so; energies and
/// gradients stay f64. Blocks of neighbours beyond the grid are zero.
#[derive(Clone)]
pub struct StencilOperator<const D: usize> {
    grid: Grid<D>,
    /// Rows of zeros before the first and after the last.
    margin: usize,
    /// Groups a row.
    groups: usize,
    /// [`Group`]s, row by row; the last of a row is filled up with zeros, at least one.
    numbers: Vec<f32>,
}

impl<const D: usize> StencilOperator<D> {
    pub const NEIGHBOURS: usize = 3_usize.pow(D as u32);
    /// The neighbour that is the node itself; those from here on are stored.
    pub const CENTRE: usize = Self::NEIGHBOURS / 2;
    /// Blocks a node.
    pub const HALF: usize = Self::NEIGHBOURS - Self::CENTRE;
    pub const BLOCK: usize = D * D;
    /// Numbers a node.
    pub const ROW: usize = Self::HALF * Self::BLOCK;
    /// Numbers a group.
    const GROUP: usize = Self::ROW * LANES;

    pub fn zero(grid: Grid<D>) -> Self {
        let margin = (0..D - 1).map(|axis| grid.stride(axis)).sum();
        let groups = grid.side() / LANES + 1;
        let rows = grid.node_count() / grid.side() + 2 * margin;
        Self { grid, margin, groups, numbers: vec![0.0; rows * groups * Self::GROUP] }
    }

    pub fn grid(&self) -> Grid<D> {
        self.grid
    }

    /// Rows of zeros before the first and after the last: a neighbour beyond the grid needs no case of its own. Across
    /// an edge of the box, its row is one on the other side, whose blocks back across that edge are zero too.
    pub fn margin(&self) -> usize {
        self.margin
    }

    /// Groups of nodes a row.
    pub fn groups(&self) -> usize {
        self.groups
    }

    pub fn clear(&mut self) {
        self.numbers.fill(0.0);
    }

    /// All groups, [`margin`](Self::margin) rows of zeros first and last.
    pub fn padded<const B: usize, const H: usize>(&self) -> &[Group<B, H>] {
        assert!(B == Self::BLOCK && H == Self::HALF);
        self.numbers.as_chunks().0.as_chunks().0.as_chunks().0
    }

    pub fn padded_mut<const B: usize, const H: usize>(&mut self) -> &mut [Group<B, H>] {
        assert!(B == Self::BLOCK && H == Self::HALF);
        self.numbers.as_chunks_mut().0.as_chunks_mut().0.as_chunks_mut().0
    }

    /// All numbers that are stored, and zeros.
    pub fn numbers(&self) -> &[f32] {
        &self.numbers
    }

    /// The number of the neighbour at `offset`, each −1, 0 or 1.
    pub fn neighbour(offset: [isize; D]) -> usize {
        offset.iter().rev().fold(0, |number, &o| number * 3 + (o + 1) as usize)
    }

    /// The offset of a neighbour, each −1, 0 or 1.
    pub fn offset(neighbour: usize) -> [isize; D] {
        std::array::from_fn(|axis| (neighbour / 3_usize.pow(axis as u32) % 3) as isize - 1)
    }

    /// `corner_neighbours()[a][b]`: which neighbour corner b of a cell is to its corner a.
    pub fn corner_neighbours() -> [[usize; MAX_CORNERS]; MAX_CORNERS] {
        let bit = |corner: usize, axis: usize| (corner >> axis & 1) as isize;
        std::array::from_fn(|a| {
            std::array::from_fn(|b| Self::neighbour(std::array::from_fn(|axis| bit(b, axis) - bit(a, axis))))
        })
    }

    /// Where the numbers of a block begin, and those of the next neighbour's after them. They are LANES apart.
    #[inline(always)]
    fn place(&self, row: usize, column: usize, neighbour: usize) -> usize {
        let group = (self.margin + row) * self.groups + column / LANES;
        group * Self::GROUP + (neighbour - Self::CENTRE) * Self::BLOCK * LANES + column % LANES
    }

    /// Calls `visit` with every node, its neighbour's node, and their block `[row][column]`, where both are on the grid.
    pub fn for_each_block(&self, mut visit: impl FnMut(usize, usize, [[f32; D]; D])) {
        let side = self.grid.side();
        for node in 0..self.grid.node_count() {
            let index = self.grid.node_index(node);
            for neighbour in Self::CENTRE..Self::NEIGHBOURS {
                let offset = Self::offset(neighbour);
                let place: [isize; D] = std::array::from_fn(|k| index[k] as isize + offset[k]);
                if place.iter().all(|&i| i >= 0 && (i as usize) < side) {
                    let other = self.grid.node(place.map(|i| i as usize));
                    let first = self.place(node / side, node % side, neighbour);
                    let entry = |i: usize, j: usize| self.numbers[first + (i * D + j) * LANES];
                    visit(node, other, std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))));
                    if other != node {
                        visit(other, node, std::array::from_fn(|i| std::array::from_fn(|j| entry(j, i))));
                    }
                }
            }
        }
    }

    /// Adds to the block of a node, the one in a column of a row, and a neighbour that does not come before it.
    #[inline(never)]
    pub fn add(&mut self, [row, column]: [usize; 2], neighbour: usize, block: &[[f32; D]; D]) {
        let first = self.place(row, column, neighbour);
        let numbers = &mut self.numbers[first..][..(Self::BLOCK - 1) * LANES + 1];
        for (k, entry) in block.as_flattened().iter().enumerate() {
            numbers[k * LANES] += entry;
        }
    }

    /// The same for [`LANES`] nodes from a column on that is a multiple of them, or the next one.
    #[inline(never)]
    pub fn add_lanes(&mut self, [row, column]: [usize; 2], neighbour: usize, block: &[[F32x4; D]; D]) {
        let ahead = column % LANES == 1;
        let first = self.place(row, column - usize::from(ahead), neighbour);
        if ahead {
            let (own, next) = self.numbers[first..][..Self::GROUP + Self::BLOCK * LANES].split_at_mut(Self::GROUP);
            add_to(own, block, |[a, b, c, _]| [0.0, a, b, c]);
            add_to(next, block, |[_, _, _, d]| [d, 0.0, 0.0, 0.0]);
        } else {
            add_to(&mut self.numbers[first..], block, |lanes| lanes);
        }
    }

    /// The mean of all diagonal entries.
    pub fn mean_diagonal(&self) -> f32 {
        let sum: f64 = self
            .numbers
            .chunks_exact(Self::GROUP)
            .flat_map(|group| (0..D).map(|k| &group[k * (D + 1) * LANES..][..LANES]))
            .map(|lanes| lanes.iter().map(|&x| f64::from(x)).sum::<f64>())
            .sum();
        (sum / (self.grid.node_count() * D) as f64) as f32
    }

    /// Adds to every diagonal entry.
    pub fn add_to_diagonal(&mut self, amount: f32) {
        let side = self.grid.side();
        for row in 0..self.grid.node_count() / side {
            for column in 0..side {
                let first = self.place(row, column, Self::CENTRE);
                for k in 0..D {
                    self.numbers[first + k * (D + 1) * LANES] += amount;
                }
            }
        }
    }
}

/// Adds to the numbers of a block what is made of its lanes.
#[inline(always)]
fn add_to<const D: usize>(
    numbers: &mut [f32],
    block: &[[F32x4; D]; D],
    made_of: impl Fn([f32; LANES]) -> [f32; LANES],
) {
    let (numbers, _) = numbers.as_chunks_mut::<LANES>();
    for (sum, lanes) in numbers.iter_mut().zip(block.as_flattened()) {
        *sum = (F32x4::from(*sum) + F32x4::from(made_of(lanes.to_array()))).to_array();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_diagonal_is_the_centre_blocks_own() {
        let mut operator = StencilOperator::<3>::zero(Grid::new(2));
        operator.add_to_diagonal(2.0);
        let mut block = [[0.0; 3]; 3];
        block[0][1] = 7.0;
        operator.add([0, 0], StencilOperator::<3>::CENTRE, &block);
        assert_eq!(operator.mean_diagonal(), 2.0);
        assert_eq!(operator.numbers().iter().sum::<f32>(), 7.0 + 2.0 * 27.0 * 3.0);
    }

    #[test]
    fn every_pair_of_nodes_is_visited_in_both_orders_with_transposed_blocks() {
        let mut operator = StencilOperator::<2>::zero(Grid::new(2));
        let right = StencilOperator::<2>::neighbour([1, 0]);
        operator.add([1, 0], right, &[[1.0, 2.0], [3.0, 4.0]]);
        let mut seen = Vec::new();
        let mut visits = 0;
        operator.for_each_block(|node, other, block| {
            visits += 1;
            if block != [[0.0; 2]; 2] {
                seen.push((node, other, block));
            }
        });
        assert_eq!(seen, [(3, 4, [[1.0, 2.0], [3.0, 4.0]]), (4, 3, [[1.0, 3.0], [2.0, 4.0]])]);
        // A 3×3 grid: four corners with 4 blocks, four edges with 6, the middle with 9.
        assert_eq!(visits, 4 * 4 + 4 * 6 + 9);
    }

    #[test]
    fn lanes_go_to_nodes_side_by_side() {
        let grid = Grid::<2>::new(8);
        let up = StencilOperator::<2>::neighbour([0, 1]);
        for column in [0, 1, 4, 5] {
            let [mut together, mut apart] = [0, 1].map(|_| StencilOperator::zero(grid));
            let entry = |i: usize, j: usize, lane: usize| (100 * i + 10 * j + lane) as f32;
            let lanes = |i, j| F32x4::from([0, 1, 2, 3].map(|lane| entry(i, j, lane)));
            together.add_lanes([3, column], up, &[0, 1].map(|i| [0, 1].map(|j| lanes(i, j))));
            for lane in 0..LANES {
                apart.add([3, column + lane], up, &[0, 1].map(|i| [0, 1].map(|j| entry(i, j, lane))));
            }
            assert_eq!(together.numbers(), apart.numbers());
        }
    }
}
