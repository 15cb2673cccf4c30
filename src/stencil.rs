//! Symmetric block operators on nodal vectors that couple a node with its 3^D neighbours.

use crate::grid::{Grid, MAX_CORNERS};

/// Upper bound of 3^D.
pub const MAX_NEIGHBOURS: usize = 27;

/// The upper half of a symmetric operator: a D×D block, f32, for each node and each neighbour that does not come before
/// it in the order of the nodes. The blocks of the neighbours before it are theirs, transposed.
///
/// f32 is enough because the operator only serves to find a direction to a relative 0.1 or so; energies and
/// gradients stay f64. Blocks of neighbours beyond the grid are zero.
#[derive(Clone)]
pub struct StencilOperator<const D: usize> {
    grid: Grid<D>,
    /// `blocks[(((margin + node)·HALF + neighbour − CENTRE)·D + row)·D + column]`.
    blocks: Vec<f32>,
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

    pub fn zero(grid: Grid<D>) -> Self {
        Self { grid, blocks: vec![0.0; (grid.node_count() + 2 * Self::margin_of(grid)) * Self::ROW] }
    }

    /// Nodes of zeros before the first and after the last: a neighbour beyond the grid needs no case of its own. Across
    /// an edge of the box, its number is that of a node on the other side, whose block back across that edge is zero too.
    fn margin_of(grid: Grid<D>) -> usize {
        grid.node([1; D])
    }

    pub fn margin(&self) -> usize {
        Self::margin_of(self.grid)
    }

    pub fn grid(&self) -> Grid<D> {
        self.grid
    }

    pub fn clear(&mut self) {
        self.blocks.fill(0.0);
    }

    /// The stored blocks, [`margin`](Self::margin) nodes of zeros first and last.
    pub fn padded_blocks(&self) -> &[f32] {
        &self.blocks
    }

    pub fn padded_blocks_mut(&mut self) -> &mut [f32] {
        &mut self.blocks
    }

    /// The stored blocks of the nodes.
    pub fn blocks(&self) -> &[f32] {
        &self.blocks[self.margin() * Self::ROW..][..self.grid.node_count() * Self::ROW]
    }

    pub fn blocks_mut(&mut self) -> &mut [f32] {
        let first = self.margin() * Self::ROW;
        &mut self.blocks[first..][..self.grid.node_count() * Self::ROW]
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

    /// Calls `visit` with every node, its neighbour's node, and their block `[row][column]`, where both are on the grid.
    pub fn for_each_block(&self, mut visit: impl FnMut(usize, usize, [[f32; D]; D])) {
        for (node, row) in self.blocks().chunks_exact(Self::ROW).enumerate() {
            let index = self.grid.node_index(node);
            for (slot, block) in row.chunks_exact(Self::BLOCK).enumerate() {
                let offset = Self::offset(Self::CENTRE + slot);
                let place: [isize; D] = std::array::from_fn(|k| index[k] as isize + offset[k]);
                if place.iter().all(|&i| i >= 0 && (i as usize) < self.grid.side()) {
                    let other = self.grid.node(place.map(|i| i as usize));
                    visit(node, other, std::array::from_fn(|i| std::array::from_fn(|j| block[i * D + j])));
                    if other != node {
                        visit(other, node, std::array::from_fn(|i| std::array::from_fn(|j| block[j * D + i])));
                    }
                }
            }
        }
    }

    /// The block of `node` and `neighbour`, by rows. The neighbour does not come before the node.
    #[inline(always)]
    pub fn block_mut(&mut self, node: usize, neighbour: usize) -> &mut [f32] {
        let first = (self.margin() + node) * Self::ROW + (neighbour - Self::CENTRE) * Self::BLOCK;
        &mut self.blocks[first..][..Self::BLOCK]
    }

    /// The blocks of the nodes from `node` on with this neighbour of theirs, and how far apart they stand.
    #[inline(always)]
    pub fn blocks_along_mut(&mut self, node: usize, neighbour: usize) -> (&mut [f32], usize) {
        let first = (self.margin() + node) * Self::ROW + (neighbour - Self::CENTRE) * Self::BLOCK;
        (&mut self.blocks[first..], Self::ROW)
    }

    /// The mean of all diagonal entries.
    pub fn mean_diagonal(&self) -> f32 {
        let sum: f64 = self
            .blocks()
            .chunks_exact(Self::ROW)
            .map(|row| (0..D).map(|k| f64::from(row[k * (D + 1)])).sum::<f64>())
            .sum();
        (sum / (self.grid.node_count() * D) as f64) as f32
    }

    /// Adds to every diagonal entry.
    pub fn add_to_diagonal(&mut self, amount: f32) {
        for row in self.blocks_mut().chunks_exact_mut(Self::ROW) {
            for k in 0..D {
                row[k * (D + 1)] += amount;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_diagonal_is_the_centre_blocks_own() {
        let mut operator = StencilOperator::<3>::zero(Grid::new(2));
        operator.add_to_diagonal(2.0);
        operator.block_mut(0, StencilOperator::<3>::CENTRE)[1] = 7.0;
        assert_eq!(operator.mean_diagonal(), 2.0);
        assert_eq!(operator.blocks().iter().sum::<f32>(), 7.0 + 2.0 * 27.0 * 3.0);
    }

    #[test]
    fn every_pair_of_nodes_is_visited_in_both_orders_with_transposed_blocks() {
        let mut operator = StencilOperator::<2>::zero(Grid::new(2));
        let right = StencilOperator::<2>::neighbour([1, 0]);
        operator.block_mut(3, right).copy_from_slice(&[1.0, 2.0, 3.0, 4.0]);
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
}
