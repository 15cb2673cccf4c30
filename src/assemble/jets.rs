//! Jets of a distance at nodes. In space they are made where they are asked for: the shell is looked at near the surface, and
//! few of the nodes are there. In the plane, where there are few nodes anyway, all of them are, and found faster.

use crate::distance::SignedDistance;
use crate::field::QuadraticFit;
use crate::grid::{Grid, MAX_CORNERS};
use std::cell::OnceCell;

/// Cells a side of a brick, whose nodes get their jets together; it has one node more a side.
const BRICK: usize = 4;
const SIDE: usize = BRICK + 1;

/// A signed distance with the quadratics fitted to it.
pub(super) struct Jets<const D: usize> {
    distance: SignedDistance<D>,
    fit: QuadraticFit<D>,
    /// In the plane, the numbers of all nodes.
    plane: Vec<f64>,
    /// In space, by brick, the numbers of its nodes: the distance, its gradient, then the second derivative's upper triangle.
    bricks: Vec<OnceCell<Box<[f64]>>>,
    /// From a cell's lowest node to its corners, in a brick or the plane.
    offsets: [usize; MAX_CORNERS],
}

/// The nodes of a cell.
#[derive(Clone, Copy)]
pub(super) struct Cell<'a> {
    /// Or the plane.
    brick: &'a [f64],
    lowest: usize,
}

impl<const D: usize> Jets<D> {
    /// Numbers a node.
    pub const STRIDE: usize = 1 + D + D * (D + 1) / 2;

    /// # Panics
    /// If the grid's cells are no multiple of four a side.
    pub fn new(distance: &SignedDistance<D>, fit_radius: f64) -> Self {
        let grid = distance.grid();
        assert_eq!(grid.cells() % BRICK, 0, "bricks fill the grid");
        let brick_count = if D == 2 { 0 } else { Self::grid_of_bricks(grid).cell_count() };
        let mut jets = Self {
            distance: distance.clone(),
            fit: QuadraticFit::new(grid, fit_radius),
            plane: Vec::new(),
            bricks: (0..brick_count).map(|_| OnceCell::new()).collect(),
            offsets: if D == 2 { grid } else { Grid::new(BRICK) }.corner_offsets(),
        };
        if D == 2 {
            let mut numbers = Vec::with_capacity(grid.node_count() * Self::STRIDE);
            for node in 0..grid.node_count() {
                jets.push(grid.node_index(node), &mut numbers);
            }
            jets.plane = numbers;
        }
        jets
    }

    pub fn grid(&self) -> Grid<D> {
        self.distance.grid()
    }

    /// The numbers of all nodes, `STRIDE` a node.
    #[cfg(feature = "gpu")]
    pub fn all(&self) -> impl Iterator<Item = f64> {
        let grid = self.grid();
        (0..grid.node_count()).flat_map(move |node| {
            let mut row = Vec::with_capacity(Self::STRIDE);
            self.push(grid.node_index(node), &mut row);
            row
        })
    }

    /// The cell with this index.
    #[inline(always)]
    pub fn cell(&self, index: [usize; D]) -> Cell<'_> {
        if D == 2 {
            return Cell { brick: &self.plane, lowest: self.grid().node(index) * Self::STRIDE };
        }
        let (mut number, mut lowest) = (0, 0);
        for i in index.into_iter().rev() {
            number = number * (self.grid().cells() / BRICK) + i / BRICK;
            lowest = lowest * SIDE + i % BRICK;
        }
        let brick = self.bricks[number].get().map(Box::as_ref);
        Cell { brick: brick.unwrap_or_else(|| self.made(number)), lowest: lowest * Self::STRIDE }
    }

    /// The numbers of a corner of it.
    #[inline(always)]
    pub fn corner<'a>(&self, cell: Cell<'a>, corner: usize) -> &'a [f64] {
        &cell.brick[cell.lowest + self.offsets[corner] * Self::STRIDE..][..Self::STRIDE]
    }

    fn grid_of_bricks(grid: Grid<D>) -> Grid<D> {
        Grid::new(grid.cells() / BRICK)
    }

    #[cold]
    #[inline(never)]
    fn made(&self, number: usize) -> &[f64] {
        self.bricks[number].get_or_init(|| {
            let (nodes, first) = (Grid::<D>::new(BRICK), Self::grid_of_bricks(self.grid()).cell_index(number));
            let mut numbers = Vec::with_capacity(nodes.node_count() * Self::STRIDE);
            for node in 0..nodes.node_count() {
                let within = nodes.node_index(node);
                self.push(std::array::from_fn(|axis| first[axis] * BRICK + within[axis]), &mut numbers);
            }
            numbers.into_boxed_slice()
        })
    }

    #[inline(never)]
    fn push(&self, index: [usize; D], numbers: &mut Vec<f64>) {
        let jet = self.fit.at(self.distance.values(), index);
        numbers.push(jet.value);
        numbers.extend_from_slice(&jet.gradient);
        for a in 0..D {
            numbers.extend_from_slice(&jet.curvature[a][a..]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::quadratic_fit;

    const RADIUS: f64 = 2.0;

    fn ball<const D: usize>() -> SignedDistance<D> {
        let grid = Grid::<D>::new(8);
        let away = |x: [f64; D]| x.iter().map(|x| (x - 0.45).powi(2)).sum::<f64>().sqrt() - 0.3;
        SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|node| away(grid.position(node))).collect())
    }

    fn jets_are_those_of_the_fit<const D: usize>() {
        let distance = ball::<D>();
        let (grid, jets) = (distance.grid(), Jets::new(&distance, RADIUS));
        let fit = quadratic_fit(grid, distance.values(), RADIUS);
        let offsets = grid.corner_offsets();
        for cell in 0..grid.cell_count() {
            for corner in 0..Grid::<D>::CORNERS {
                let found = jets.corner(jets.cell(grid.cell_index(cell)), corner);
                let jet = &fit[grid.lowest_node(cell) + offsets[corner]];
                let upper = (0..D).flat_map(|a| jet.curvature[a][a..].to_vec());
                let expected: Vec<f64> = [jet.value].into_iter().chain(jet.gradient).chain(upper).collect();
                assert_eq!(found, expected, "corner {corner} of cell {cell}");
            }
        }
    }

    #[test]
    fn the_jets_of_a_cell_are_those_of_the_fit_at_its_corners() {
        jets_are_those_of_the_fit::<2>();
        jets_are_those_of_the_fit::<3>();
    }

    #[test]
    fn bricks_are_made_where_they_are_asked_for() {
        let jets = Jets::new(&ball::<3>(), RADIUS);
        let made = |jets: &Jets<3>| jets.bricks.iter().filter(|brick| brick.get().is_some()).count();
        assert_eq!(made(&jets), 0);
        for index in [[0, 0, 0], [3, 3, 3], [4, 0, 0], [0, 0, 7]] {
            jets.cell(index);
        }
        assert_eq!(made(&jets), 3);
    }
}
