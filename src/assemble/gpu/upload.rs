use crate::grid::Grid;

/// Displacements and differences beyond this, in cells, are none that f32 can square and cube: the twin's affair.
pub(super) const LARGEST: f64 = 1e6;

/// Displacements as the shaders take them: by node u in cells, then its differences to the next node along each axis.
pub(super) struct Upload<const D: usize> {
    grid: Grid<D>,
    numbers: Vec<f32>,
}

impl<const D: usize> Upload<D> {
    pub const STRIDE: usize = D + D * D;

    pub fn new(grid: Grid<D>) -> Self {
        Self { grid, numbers: vec![0.0; grid.node_count() * Self::STRIDE] }
    }

    /// None if a number is none, or too large.
    pub fn of(&mut self, displacement: &[f64]) -> Option<&[f32]> {
        let cells = self.grid.cells() as f64;
        let mut fits = true;
        for (node, row) in self.numbers.chunks_exact_mut(Self::STRIDE).enumerate() {
            let own = &displacement[node * D..][..D];
            let index = self.grid.node_index(node);
            let mut put = |place: usize, value: f64| {
                // Not a number is not less, either.
                fits &= value.abs() < LARGEST;
                row[place] = value as f32;
            };
            for k in 0..D {
                put(k, own[k] * cells);
            }
            for axis in 0..D {
                if index[axis] == self.grid.cells() {
                    continue;
                }
                let next = &displacement[(node + self.grid.stride(axis)) * D..][..D];
                for k in 0..D {
                    // The difference is taken before it is rounded.
                    put(D + axis * D + k, (next[k] - own[k]) * cells);
                }
            }
        }
        fits.then_some(&self.numbers)
    }
}
