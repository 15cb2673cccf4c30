//! Symmetric block operators on nodal vectors that couple a node with its 3^D neighbours.

use crate::grid::{Grid, MAX_CORNERS};

/// Upper bound of 3^D.
pub const MAX_NEIGHBOURS: usize = 27;

/// One D×D block for each node and each of its 3^D neighbours (itself included), f32.
///
/// f32 is enough because the operator only serves to find a direction to a relative 0.1 or so; energies and
/// gradients stay f32. Blocks of neighbours beyond the grid are zero.
#[derive(Clone)]
pub struct StencilOperator<const D: usize> {
    grid: Grid<D>,
    /// `blocks[((node·3^D + neighbour)·D + row)·D + column]`.
    blocks: Vec<f32>,
}

impl<const D: usize> StencilOperator<D> {
    pub const NEIGHBOURS: usize = 3_usize.pow(D as u32);
    pub const BLOCK: usize = D * D;
    /// Numbers a node.
    pub const ROW: usize = Self::NEIGHBOURS * Self::BLOCK;
    /// The neighbour that is the node itself.
    pub const CENTRE: usize = Self::NEIGHBOURS / 2;

    pub fn zero(grid: Grid<D>) -> Self {
        Self { grid, blocks: vec![0.0; grid.node_count() * Self::ROW] }
    }

    pub fn grid(&self) -> Grid<D> {
        self.grid
    }

    pub fn clear(&mut self) {
        self.blocks.fill(0.0);
    }

    pub fn blocks(&self) -> &[f32] {
        &self.blocks
    }

    pub fn blocks_mut(&mut self) -> &mut [f32] {
        &mut self.blocks
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

    /// Calls `visit` with every node, its neighbour's node, and their block by rows, where both are on the grid.
    pub fn for_each_block(&self, mut visit: impl FnMut(usize, usize, &[f32])) {
        for (node, row) in self.blocks.chunks_exact(Self::ROW).enumerate() {
            let index = self.grid.node_index(node);
            for (neighbour, block) in row.chunks_exact(Self::BLOCK).enumerate() {
                let offset = Self::offset(neighbour);
                let place: [isize; D] = std::array::from_fn(|k| index[k] as isize + offset[k]);
                if place.iter().all(|&i| i >= 0 && (i as usize) < self.grid.side()) {
                    visit(node, self.grid.node(place.map(|i| i as usize)), block);
                }
            }
        }
    }

    /// The block of `node` and `neighbour`, by rows.
    #[inline(always)]
    pub fn block_mut(&mut self, node: usize, neighbour: usize) -> &mut [f32] {
        &mut self.blocks[node * Self::ROW + neighbour * Self::BLOCK..][..Self::BLOCK]
    }

    /// The mean of all diagonal entries.
    pub fn mean_diagonal(&self) -> f32 {
        let sum: f64 = self
            .blocks
            .chunks_exact(Self::ROW)
            .map(|row| (0..D).map(|k| f64::from(row[Self::CENTRE * Self::BLOCK + k * (D + 1)])).sum::<f64>())
            .sum();
        (sum / (self.grid.node_count() * D) as f64) as f32
    }

    /// Adds to every diagonal entry.
    pub fn add_to_diagonal(&mut self, amount: f32) {
        for row in self.blocks.chunks_exact_mut(Self::ROW) {
            for k in 0..D {
                row[Self::CENTRE * Self::BLOCK + k * (D + 1)] += amount;
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
}
