//! The uniform grid on the unit box: indexing of nodes, cells and corners.

/// n cells a side on `[0,1]^D`, hence (n+1)^D nodes. Node and cell numbers run x fastest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid<const D: usize> {
    cells: usize,
}

/// Upper bound of 2^D, the corners of a cell, for the dimensions in use.
pub const MAX_CORNERS: usize = 8;

impl<const D: usize> Grid<D> {
    /// Corners of a cell. Corner c lies at the upper end of axis k if bit k of c is set.
    pub const CORNERS: usize = 1 << D;

    pub fn new(cells: usize) -> Self {
        assert!(cells >= 1, "a grid has at least one cell a side");
        Self { cells }
    }

    /// 2^level cells a side.
    pub fn of_level(level: u32) -> Self {
        Self::new(1 << level)
    }

    /// Cells a side.
    pub fn cells(self) -> usize {
        self.cells
    }

    /// Nodes a side.
    pub fn side(self) -> usize {
        self.cells + 1
    }

    /// The width h of a cell.
    pub fn spacing(self) -> f64 {
        1.0 / self.cells as f64
    }

    pub fn node_count(self) -> usize {
        self.side().pow(D as u32)
    }

    pub fn cell_count(self) -> usize {
        self.cells.pow(D as u32)
    }

    /// Distance in node numbers between neighbours along `axis`.
    pub fn stride(self, axis: usize) -> usize {
        self.side().pow(axis as u32)
    }

    pub fn node(self, index: [usize; D]) -> usize {
        index.iter().rev().fold(0, |number, &i| number * self.side() + i)
    }

    pub fn node_index(self, node: usize) -> [usize; D] {
        Self::split(node, self.side())
    }

    pub fn cell_index(self, cell: usize) -> [usize; D] {
        Self::split(cell, self.cells)
    }

    pub fn cell(self, index: [usize; D]) -> usize {
        index.iter().rev().fold(0, |number, &i| number * self.cells + i)
    }

    fn split(mut number: usize, side: usize) -> [usize; D] {
        std::array::from_fn(|_| {
            let i = number % side;
            number /= side;
            i
        })
    }

    /// The position of a node in the box.
    pub fn position(self, node: usize) -> [f64; D] {
        self.node_index(node).map(|i| i as f64 * self.spacing())
    }

    /// The node at the lowest corner of a cell.
    pub fn lowest_node(self, cell: usize) -> usize {
        self.node(self.cell_index(cell))
    }

    /// Node numbers of the corners relative to the lowest one; the first 2^D entries count.
    pub fn corner_offsets(self) -> [usize; MAX_CORNERS] {
        std::array::from_fn(|corner| (0..D).map(|axis| ((corner >> axis) & 1) * self.stride(axis)).sum())
    }

    /// The cell that holds `point`, or the nearest one, and the coordinate in it (outside 0..1 beyond the box).
    pub fn locate(self, point: &[f64; D]) -> ([usize; D], [f64; D]) {
        let mut cell = [0; D];
        let mut local = [0.0; D];
        for axis in 0..D {
            let scaled = point[axis] * self.cells as f64;
            cell[axis] = (scaled.max(0.0).min(self.cells as f64) as usize).min(self.cells - 1);
            local[axis] = scaled - cell[axis] as f64;
        }
        (cell, local)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbering_round_trips<const D: usize>() {
        let grid = Grid::<D>::new(3);
        for node in 0..grid.node_count() {
            assert_eq!(grid.node(grid.node_index(node)), node);
        }
        for cell in 0..grid.cell_count() {
            assert_eq!(grid.cell(grid.cell_index(cell)), cell);
            let corners = grid.corner_offsets();
            let top = grid.lowest_node(cell) + corners[Grid::<D>::CORNERS - 1];
            assert_eq!(grid.node_index(top), grid.cell_index(cell).map(|i| i + 1));
        }
    }

    #[test]
    fn numbering_round_trips_in_both_dimensions() {
        numbering_round_trips::<2>();
        numbering_round_trips::<3>();
    }

    #[test]
    fn points_beyond_the_box_belong_to_the_boundary_cell() {
        let grid = Grid::<2>::new(4);
        assert_eq!(grid.locate(&[1.125, -0.125]), ([3, 0], [1.5, -0.5]));
        assert_eq!(grid.locate(&[1.0, 0.5]), ([3, 2], [1.0, 0.0]));
    }
}
