//! Symmetric block operators on nodal vectors that couple a node with its 3^D neighbours.

mod rounded;

use crate::grid::{Grid, MAX_CORNERS};
use crate::small::F32x4;
use rounded::Rounding;

/// Upper bound of 3^D.
pub const MAX_NEIGHBOURS: usize = 27;

/// Nodes of a row that lie side by side in memory, so that a register takes a number of each.
pub const LANES: usize = 4;

/// A number of each of [`LANES`] nodes.
pub type Quad = [f32; LANES];

/// The upper half of a symmetric operator: a D×D block, f32, for each node and each neighbour that does not come before
/// it in the order of the nodes. The blocks of the neighbours before it are theirs, transposed.
///
/// f32 is enough because the operator only serves to find a direction to a relative 0.1 or so; energies and
/// gradients stay f64. Blocks of neighbours beyond the grid are zero.
///
/// In space, where a sweep is bound by memory, an operator may be [`rounded`](Self::rounded): then blocks of two nodes have
/// 16 bits an entry.
#[derive(Clone)]
pub struct StencilOperator<const D: usize> {
    grid: Grid<D>,
    /// Rows of zeros before the first and after the last.
    margin: usize,
    /// Groups a row.
    groups: usize,
    /// By groups, row by row, the last of a row filled up with zeros, at least one: the nodes' blocks with themselves.
    own: Vec<f32>,
    /// With later neighbours, see [`Blocks`].
    later: Vec<f32>,
    rounding: Option<Rounding>,
}

/// The numbers of an operator: B = D² entries a block, which take W [`Quad`]s where they lie, and E rows of nodes next to a
/// row and later than it, (3^(D−1) − 1) / 2, which the type system cannot compute. By group of nodes,
/// [`margin`](StencilOperator::margin) rows of zeros first and last.
///
/// What couples two rows lies apart from the rest: a sweep asks for it once from either row, and memory is quick where what is
/// asked for lies side by side.
#[derive(Clone, Copy)]
pub struct Blocks<'a, const B: usize, const W: usize, const E: usize> {
    /// Nodes with themselves.
    pub own: &'a [[Quad; B]],
    /// With the next one of the row.
    pub next: &'a [[Quad; W]],
    /// With the three next to a node in a later row, along x.
    pub rows: [&'a [[[Quad; W]; A_ROW]]; E],
}

/// The same, to be written, unrounded.
pub struct BlocksMut<'a, const B: usize, const E: usize> {
    pub own: &'a mut [[Quad; B]],
    pub next: &'a mut [[Quad; B]],
    pub rows: [&'a mut [[[Quad; B]; A_ROW]]; E],
}

/// Neighbours in another row.
pub const A_ROW: usize = 3;

/// Where the block of a group with its later neighbours of a number lies among those of so many groups.
#[inline(always)]
fn place(group: usize, later: usize, groups: usize) -> usize {
    match later.checked_sub(1) {
        None => group,
        Some(other) => groups * (1 + other / A_ROW * A_ROW) + group * A_ROW + other % A_ROW,
    }
}

/// How much further the block of the next group lies.
#[inline(always)]
fn distance(later: usize) -> usize {
    if later == 0 { 1 } else { A_ROW }
}

impl<'a, const B: usize, const W: usize, const E: usize> Blocks<'a, B, W, E> {
    pub fn of(own: &'a [f32], later: &'a [f32]) -> Self {
        let (own, later): (&[[Quad; B]], &[[Quad; W]]) =
            (own.as_chunks().0.as_chunks().0, later.as_chunks().0.as_chunks().0);
        let groups = own.len();
        assert_eq!(later.len(), groups * (1 + A_ROW * E));
        let rows = |row: usize| later[groups * (1 + A_ROW * row)..][..groups * A_ROW].as_chunks().0;
        Self { own, next: &later[..groups], rows: std::array::from_fn(rows) }
    }

    /// The blocks of a slot other than the first, and from group to group how many further.
    pub fn later(&self, slot: usize) -> (&'a [[Quad; W]], usize) {
        match slot.checked_sub(2) {
            None => (self.next, 1),
            Some(other) => (&self.rows[other / A_ROW].as_flattened()[other % A_ROW..], A_ROW),
        }
    }
}

impl<'a, const B: usize, const E: usize> Blocks<'a, B, B, E> {
    /// The blocks of a slot, of which the first is that of the nodes with themselves, and from group to group how many further.
    pub fn slot(&self, slot: usize) -> (&'a [[Quad; B]], usize) {
        if slot == 0 { (self.own, 1) } else { self.later(slot) }
    }
}

impl<'a, const B: usize, const E: usize> BlocksMut<'a, B, E> {
    /// Of so many groups from one on, of all there are.
    #[inline(never)]
    pub fn of(own: &'a mut [f32], later: &'a mut [f32], first: usize, count: usize) -> Self {
        let later = later.as_chunks_mut().0.as_chunks_mut().0;
        let groups = later.len() / (1 + A_ROW * E);
        let (next, mut rest) = later.split_at_mut(groups);
        let rows = |_| {
            let (row, later) = std::mem::take(&mut rest).split_at_mut(groups * A_ROW);
            rest = later;
            &mut row.as_chunks_mut().0[first..][..count]
        };
        let rows = std::array::from_fn(rows);
        Self { own: &mut own.as_chunks_mut().0.as_chunks_mut().0[..count], next: &mut next[first..][..count], rows }
    }

    /// As [`Blocks::slot`].
    pub fn slot(&mut self, slot: usize) -> (&mut [[Quad; B]], usize) {
        match slot {
            0 => (self.own, 1),
            1 => (self.next, 1),
            _ => (&mut self.rows[(slot - 2) / A_ROW].as_flattened_mut()[(slot - 2) % A_ROW..], A_ROW),
        }
    }
}

/// The entries of a block from where they lie: each by itself, or rounded, two in one.
#[inline(always)]
pub fn entries<const B: usize, const W: usize>(block: &[Quad; W]) -> [F32x4; B] {
    if B == W { std::array::from_fn(|k| F32x4::from(block[k])) } else { rounded::entries(block) }
}

impl<const D: usize> StencilOperator<D> {
    pub const NEIGHBOURS: usize = 3_usize.pow(D as u32);
    /// The neighbour that is the node itself; those from here on are stored.
    pub const CENTRE: usize = Self::NEIGHBOURS / 2;
    /// Blocks a node.
    pub const HALF: usize = Self::NEIGHBOURS - Self::CENTRE;
    /// Of these, with other nodes.
    pub const LATER: usize = Self::HALF - 1;
    pub const BLOCK: usize = D * D;
    /// Numbers a node.
    pub const ROW: usize = Self::HALF * Self::BLOCK;
    /// Numbers of a block in a group.
    const QUADS: usize = Self::BLOCK * LANES;

    pub fn zero(grid: Grid<D>) -> Self {
        Self::with(grid, Self::BLOCK, None)
    }

    /// One whose blocks of two nodes are rounded to 16 bits an entry, for D = 3. What they lose by that is added to the nodes'
    /// blocks with themselves, so that a translation costs what it did.
    ///
    /// Blocks are rounded once all is added to them: those of a plane as soon as something is added two planes further on. What
    /// is added later is rounded by itself.
    pub fn rounded(grid: Grid<D>) -> Self {
        assert!(D == 3, "what is rounded are the nine entries of a block in space");
        Self::with(grid, rounded::QUADS, Some(Rounding::new(grid.side(), grid.side() / LANES + 1)))
    }

    fn with(grid: Grid<D>, quads: usize, rounding: Option<Rounding>) -> Self {
        let margin = (0..D - 1).map(|axis| grid.stride(axis)).sum();
        let groups = grid.side() / LANES + 1;
        let rows = grid.node_count() / grid.side() + 2 * margin;
        let numbers = |count: usize| vec![0.0; rows * groups * count * LANES];
        Self { grid, margin, groups, own: numbers(Self::BLOCK), later: numbers(Self::LATER * quads), rounding }
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

    /// [`Quad`]s that a block of two nodes takes.
    pub fn quads(&self) -> usize {
        if D == 3 && self.rounding.is_some() { rounded::QUADS } else { Self::BLOCK }
    }

    pub fn clear(&mut self) {
        self.own.fill(0.0);
        match &mut self.rounding {
            // All of these will be overwritten.
            Some(rounding) if D == 3 => rounding.restart(),
            _ => self.later.fill(0.0),
        }
    }

    /// Rounds what is not rounded yet, if this is a rounded operator.
    pub fn complete(&mut self) {
        self.round_before(self.grid.node_count() / self.grid.side() + self.grid.stride(1));
    }

    /// All numbers, once they are [complete](Self::complete).
    pub fn blocks<const B: usize, const W: usize, const E: usize>(&self) -> Blocks<'_, B, W, E> {
        assert!(B == Self::BLOCK && W == self.quads());
        Blocks::of(&self.own, &self.later)
    }

    /// All numbers of an operator that is not rounded, and zeros.
    pub fn numbers(&self) -> impl Iterator<Item = f32> {
        assert!(self.rounding.is_none());
        self.own.iter().chain(&self.later).copied()
    }

    /// Those of a row, to be overwritten: from the first row to the last.
    pub fn row_mut<const B: usize, const E: usize>(&mut self, row: usize) -> BlocksMut<'_, B, E> {
        assert!(B == Self::BLOCK);
        if D == 3
            && row == 0
            && let Some(rounding) = &mut self.rounding
        {
            rounding.restart();
        }
        self.round_before(row);
        let first = (self.margin + row) * self.groups;
        let own = &mut self.own[first * Self::QUADS..];
        match &mut self.rounding {
            Some(rounding) if D == 3 => {
                let first = rounding.first_group(row).expect("rows are overwritten in their order");
                BlocksMut::of(own, rounding.exact_mut(), first, self.groups)
            }
            _ => BlocksMut::of(own, &mut self.later, first, self.groups),
        }
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

    /// The block of a node, the one in a column of a row, and a neighbour that does not come before it.
    fn block(&self, [row, column]: [usize; 2], neighbour: usize) -> [[f32; D]; D] {
        let (group, lane) = ((self.margin + row) * self.groups + column / LANES, column % LANES);
        let mut numbers = (&self.own[..], group);
        if let Some(later) = (neighbour - Self::CENTRE).checked_sub(1) {
            numbers = (&self.later, place(group, later, self.all_groups()));
            if D == 3
                && let Some(rounding) = &self.rounding
            {
                let Some(first) = rounding.first_group(row) else {
                    let entries = rounded::entries::<9, { rounded::QUADS }>(&rounded::blocks(numbers.0)[numbers.1]);
                    return std::array::from_fn(|i| std::array::from_fn(|j| entries[i * D + j].to_array()[lane]));
                };
                numbers = (rounding.exact(), place(first + column / LANES, later, rounding.groups()));
            }
        }
        let first = numbers.1 * Self::QUADS + lane;
        std::array::from_fn(|i| std::array::from_fn(|j| numbers.0[first + (i * D + j) * LANES]))
    }

    /// Groups, with those of the margins.
    #[inline(always)]
    fn all_groups(&self) -> usize {
        self.own.len() / Self::QUADS
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
                    let block = self.block([node / side, node % side], neighbour);
                    visit(node, other, block);
                    if other != node {
                        visit(other, node, std::array::from_fn(|i| std::array::from_fn(|j| block[j][i])));
                    }
                }
            }
        }
    }

    /// Rounds what comes two planes before a row.
    #[inline(always)]
    fn round_before(&mut self, row: usize) {
        if D == 3
            && let Some(rounding) = &mut self.rounding
            && rounding.is_beyond(row)
        {
            rounding.round_before(row, &mut self.own, &mut self.later);
        }
    }

    /// Where the numbers of a block are added to, from the first one of a node on, [`LANES`] apart, and how much further those
    /// of the next group are. None where they are rounded already.
    #[inline(always)]
    fn room(&mut self, [row, column]: [usize; 2], neighbour: usize) -> Option<(&mut [f32], usize)> {
        let (group, lane) = (column / LANES, column % LANES);
        let first = (self.margin + row) * self.groups + group;
        let Some(later) = (neighbour - Self::CENTRE).checked_sub(1) else {
            return Some((&mut self.own[first * Self::QUADS + lane..], Self::QUADS));
        };
        let next = distance(later) * Self::QUADS;
        let (block, numbers) = match &mut self.rounding {
            Some(rounding) if D == 3 => {
                (place(rounding.first_group(row)? + group, later, rounding.groups()), rounding.exact_mut())
            }
            _ => (place(first, later, self.own.len() / Self::QUADS), &mut self.later[..]),
        };
        Some((&mut numbers[block * Self::QUADS + lane..], next))
    }

    /// Adds to the block of a node, the one in a column of a row, and a neighbour that does not come before it.
    #[inline(never)]
    pub fn add(&mut self, place: [usize; 2], neighbour: usize, block: &[[f32; D]; D]) {
        self.round_before(place[0]);
        if let Some((numbers, _)) = self.room(place, neighbour) {
            let numbers = &mut numbers[..(Self::BLOCK - 1) * LANES + 1];
            for (k, entry) in block.as_flattened().iter().enumerate() {
                numbers[k * LANES] += entry;
            }
        } else if D == 3
            && let Some(rounding) = &self.rounding
        {
            rounding.add(place, neighbour - Self::CENTRE - 1, block.as_flattened(), &mut self.own, &mut self.later);
        }
    }

    /// The same for [`LANES`] nodes from a column on that is a multiple of them, or the next one.
    #[inline(never)]
    pub fn add_lanes(&mut self, [row, column]: [usize; 2], neighbour: usize, block: &[[F32x4; D]; D]) {
        let ahead = column % LANES == 1;
        self.round_before(row);
        let Some((numbers, next)) = self.room([row, column - usize::from(ahead)], neighbour) else {
            for lane in 0..LANES {
                let block = block.map(|row| row.map(|entry| entry.to_array()[lane]));
                self.add([row, column + lane], neighbour, &block);
            }
            return;
        };
        if ahead {
            let (own, next) = numbers[..next + Self::QUADS].split_at_mut(next);
            add_to(own, block, |[a, b, c, _]| [0.0, a, b, c]);
            add_to(next, block, |[_, _, _, d]| [d, 0.0, 0.0, 0.0]);
        } else {
            add_to(numbers, block, |lanes| lanes);
        }
    }

    /// The mean of all diagonal entries.
    pub fn mean_diagonal(&self) -> f32 {
        let sum: f64 = self
            .own
            .chunks_exact(Self::QUADS)
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
                let first = ((self.margin + row) * self.groups + column / LANES) * Self::QUADS + column % LANES;
                for k in 0..D {
                    self.own[first + k * (D + 1) * LANES] += amount;
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
        let mut sum = 0.0;
        operator.for_each_block(|_, _, block| sum += block.as_flattened().iter().sum::<f32>());
        assert_eq!(sum, 7.0 + 2.0 * 27.0 * 3.0);
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
        for (neighbour, column) in
            [StencilOperator::<2>::CENTRE, up].into_iter().flat_map(|n| [0, 1, 4, 5].map(|c| (n, c)))
        {
            let [mut together, mut apart] = [0, 1].map(|_| StencilOperator::zero(grid));
            let entry = |i: usize, j: usize, lane: usize| (100 * i + 10 * j + lane) as f32;
            let lanes = |i, j| F32x4::from([0, 1, 2, 3].map(|lane| entry(i, j, lane)));
            together.add_lanes([3, column], neighbour, &[0, 1].map(|i| [0, 1].map(|j| lanes(i, j))));
            for lane in 0..LANES {
                apart.add([3, column + lane], neighbour, &[0, 1].map(|i| [0, 1].map(|j| entry(i, j, lane))));
            }
            assert_eq!((&together.own, &together.later), (&apart.own, &apart.later));
            assert!(together.own.iter().chain(&together.later).any(|&x| x == 113.0));
        }
    }
}
