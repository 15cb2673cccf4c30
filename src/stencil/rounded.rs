//! Blocks of two nodes in space, rounded to 16 bits an entry: the upper half of an f32, with 8 of its 24 digits.

use super::{LANES, Quad, StencilOperator, place};
use crate::small::F32x4;

/// Entries of a block.
const ENTRIES: usize = 9;
/// What they take rounded: two in one, and the last by itself, which then need not be rounded.
pub(super) const QUADS: usize = ENTRIES.div_ceil(2);
/// Neighbours that come later.
const LATER: usize = StencilOperator::<3>::LATER;

type Exact = [Quad; ENTRIES];
pub(super) type Rounded = [Quad; QUADS];

/// The upper half of a number's bits.
const UPPER: u32 = 0xffff_0000;
/// Half of what the lower half counts.
const ROUND: u32 = 0x8000;

/// The entries of a block.
#[inline(always)]
pub(super) fn entries<const B: usize, const W: usize>(block: &[Quad; W]) -> [F32x4; B] {
    std::array::from_fn(|k| {
        let quad = block[k / 2];
        F32x4::from(match k % 2 {
            0 if k + 1 == B => quad,
            0 => quad.map(|pair| f32::from_bits(pair.to_bits() & UPPER)),
            _ => quad.map(|pair| f32::from_bits(pair.to_bits() << 16)),
        })
    })
}

#[inline(always)]
fn rounded(block: &Exact) -> Rounded {
    std::array::from_fn(|k| {
        if 2 * k + 1 == ENTRIES {
            return block[2 * k];
        }
        let bits = |entry: usize, lane: usize| block[entry][lane].to_bits().wrapping_add(ROUND);
        std::array::from_fn(|lane| f32::from_bits(bits(2 * k, lane) & UPPER | bits(2 * k + 1, lane) >> 16))
    })
}

pub(super) fn blocks(numbers: &[f32]) -> &[Rounded] {
    numbers.as_chunks().0.as_chunks().0
}

/// How far an operator is rounded, and the blocks of the two planes of nodes that follow, which are still added to.
#[derive(Clone)]
pub(super) struct Rounding {
    /// Rows a plane, and groups a row.
    side: usize,
    groups: usize,
    /// The first row that is not rounded, the first of a plane.
    first: usize,
    /// Where it lies, 0 or after the other plane.
    turn: usize,
    exact: Vec<f32>,
}

impl Rounding {
    pub fn new(side: usize, groups: usize) -> Self {
        Self { side, groups, first: 0, turn: 0, exact: vec![0.0; 2 * side * groups * LATER * ENTRIES * LANES] }
    }

    pub fn restart(&mut self) {
        // What has been rounded is zero again.
        if self.first < self.side * self.side {
            self.exact.fill(0.0);
        }
        (self.first, self.turn) = (0, 0);
    }

    /// Whether planes have to be rounded before a row can be added to.
    #[inline(always)]
    pub fn is_beyond(&self, row: usize) -> bool {
        row >= self.first + 2 * self.side
    }

    /// The number of a row's first group among those not rounded yet. None if it is rounded.
    #[inline(always)]
    pub fn first_group(&self, row: usize) -> Option<usize> {
        let number = row.checked_sub(self.first)? + self.turn;
        Some(if number < 2 * self.side { number } else { number - 2 * self.side } * self.groups)
    }

    /// How many of these there are.
    #[inline(always)]
    pub fn groups(&self) -> usize {
        2 * self.side * self.groups
    }

    /// Their blocks.
    pub fn exact(&self) -> &[f32] {
        &self.exact
    }

    #[inline(always)]
    pub fn exact_mut(&mut self) -> &mut [f32] {
        &mut self.exact
    }

    /// Rounds planes until a row can be added to.
    #[inline(never)]
    pub fn round_before(&mut self, row: usize, own: &mut [f32], later: &mut [f32]) {
        let own: &mut [Exact] = own.as_chunks_mut().0.as_chunks_mut().0;
        let later: &mut [Rounded] = later.as_chunks_mut().0.as_chunks_mut().0;
        let exact_groups = self.groups();
        while self.is_beyond(row) && self.first < self.side * self.side {
            let exact_first = self.first_group(self.first).expect("it is not rounded yet");
            let first = (self.margin() + self.first) * self.groups;
            let exact: &mut [Exact] = self.exact.as_chunks_mut().0.as_chunks_mut().0;
            for number in 0..self.side * self.groups {
                let group = first + number;
                let mut lost = [F32x4::ZERO; ENTRIES];
                for slot in 0..LATER {
                    let exact = &mut exact[place(exact_first + number, slot, exact_groups)];
                    later[place(group, slot, own.len())] = round(exact, &mut lost);
                    *exact = [[0.0; LANES]; ENTRIES];
                }
                give_back(&lost, &mut own[group]);
            }
            self.first += self.side;
            self.turn = self.side - self.turn;
        }
    }

    /// Rows of zeros before an operator's first.
    fn margin(&self) -> usize {
        self.side + 1
    }

    /// Adds to a block that is rounded already.
    pub fn add(&self, [row, column]: [usize; 2], slot: usize, block: &[f32], own: &mut [f32], later: &mut [f32]) {
        let own: &mut [Exact] = own.as_chunks_mut().0.as_chunks_mut().0;
        let later: &mut [Rounded] = later.as_chunks_mut().0.as_chunks_mut().0;
        let group = (self.margin() + row) * self.groups + column / LANES;
        let later = &mut later[place(group, slot, own.len())];
        let mut exact = entries::<ENTRIES, QUADS>(later).map(|entry| entry.to_array());
        for (quad, entry) in exact.iter_mut().zip(block) {
            quad[column % LANES] += entry;
        }
        let mut lost = [F32x4::ZERO; ENTRIES];
        *later = round(&exact, &mut lost);
        give_back(&lost, &mut own[group]);
    }
}

/// A block rounded; adds to what is lost by it.
#[inline(always)]
fn round(exact: &Exact, lost: &mut [F32x4; ENTRIES]) -> Rounded {
    let rounded = rounded(exact);
    let kept = entries::<ENTRIES, QUADS>(&rounded);
    for ((lost, exact), kept) in lost.iter_mut().zip(exact).zip(kept) {
        *lost += F32x4::from(*exact) - kept;
    }
    rounded
}

/// Adds to the nodes' blocks with themselves what their blocks with later nodes have lost, once for each of its two places in
/// the operator: then a translation costs what it did.
#[inline(always)]
fn give_back(lost: &[F32x4; ENTRIES], own: &mut Exact) {
    for i in 0..3 {
        for j in 0..3 {
            let sum = &mut own[3 * i + j];
            *sum = (F32x4::from(*sum) + lost[3 * i + j] + lost[3 * j + i]).to_array();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Grid;

    const CENTRE: usize = StencilOperator::<3>::CENTRE;

    fn entry(node: usize, neighbour: usize, i: usize, j: usize) -> f32 {
        let number = ((node * 27 + neighbour) * 9 + 3 * i.min(j) + i.max(j)) as f32;
        // Symmetric for the nodes themselves, otherwise not, and of many sizes.
        let turned = if neighbour == CENTRE || i <= j { 1.0 } else { -0.7 };
        turned * (0.37 * number).sin() * (0.11 * number).cos().exp2()
    }

    /// Blocks of all nodes and their neighbours on the grid, added plane by plane, and `late` once more at the end.
    fn filled(mut operator: StencilOperator<3>, late: &[usize]) -> StencilOperator<3> {
        let grid = operator.grid();
        let side = grid.side();
        for node in (0..grid.node_count()).chain(late.iter().copied()) {
            let index = grid.node_index(node);
            for neighbour in CENTRE..27 {
                let offset = StencilOperator::<3>::offset(neighbour);
                if (0..3).all(|k| (0..side as isize).contains(&(index[k] as isize + offset[k]))) {
                    let block = std::array::from_fn(|i| std::array::from_fn(|j| entry(node, neighbour, i, j)));
                    operator.add([node / side, node % side], neighbour, &block);
                }
            }
        }
        operator
    }

    /// Σ over all blocks of cᵀ A c with the same c at all nodes: what a translation costs.
    fn translation(operator: &StencilOperator<3>, c: [f64; 3]) -> f64 {
        let mut sum = 0.0;
        operator.for_each_block(|_, _, block| {
            for i in 0..3 {
                for j in 0..3 {
                    sum += c[i] * f64::from(block[i][j]) * c[j];
                }
            }
        });
        sum
    }

    #[test]
    fn blocks_keep_eight_binary_digits_and_a_translation_costs_what_it_did() {
        let grid = Grid::<3>::new(8);
        // Of a plane long rounded, of the last one, and one after the other.
        for late in [&[][..], &[3, 100, 101, 9 * 81 - 1]] {
            let exact = filled(StencilOperator::zero(grid), late);
            let mut rounded = filled(StencilOperator::rounded(grid), late);
            rounded.complete();
            let mut blocks = Vec::new();
            exact.for_each_block(|node, other, block| blocks.push((node, other, block)));
            let mut expected = blocks.into_iter();
            let (mut count, mut changed) = (0, 0);
            rounded.for_each_block(|node, other, block| {
                let (expected_node, expected_other, expected) = expected.next().expect("as many blocks");
                assert_eq!((node, other), (expected_node, expected_other));
                count += 1;
                for (found, expected) in block.as_flattened().iter().zip(expected.as_flattened()) {
                    // Twice where a block was rounded, added to, and rounded again.
                    let most = if node == other { 0.1 } else { 2.0_f32.powi(-9) * 2.1 * expected.abs().max(0.1) };
                    assert!((found - expected).abs() <= most, "{node} {other}: {found} is not {expected}");
                    changed += usize::from(found != expected);
                }
            });
            assert!(
                expected.next().is_none() && 2 * changed > 9 * count,
                "{changed} of {count} blocks' entries differ"
            );
            for c in [[1.0, 0.0, 0.0], [0.3, -0.8, 0.5]] {
                let (cost, found) = (translation(&exact, c), translation(&rounded, c));
                assert!((cost - found).abs() < 1e-5 * grid.node_count() as f64, "{found} is not {cost}");
            }
        }
    }

    #[test]
    fn what_is_not_rounded_yet_is_exact_and_what_was_cleared_is_gone() {
        let grid = Grid::<3>::new(4);
        let mut operator = filled(StencilOperator::rounded(grid), &[]);
        let last = grid.node_count() - 2;
        let mut seen = 0;
        operator.for_each_block(|node, other, block| {
            if node == last && other == last + 1 {
                assert_eq!(block[0][1], entry(last, CENTRE + 1, 0, 1));
                seen += 1;
            }
        });
        assert_eq!(seen, 1);
        operator.clear();
        operator.complete();
        operator.for_each_block(|_, _, block| assert_eq!(block, [[0.0; 3]; 3]));
    }
}
