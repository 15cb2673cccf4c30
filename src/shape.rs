//! Shapes as they are given: curves, level sets, masks, meshes.

use crate::distance::SignedDistance;
use crate::error::{MeshError, ShapeError};
use crate::grid::Grid;
use glam::DVec2;

/// A shape in the plane, from which a signed distance can be made on any grid.
#[derive(Clone, Debug)]
pub enum Shape {
    /// Closed polygons in domain units, any orientation; a loop wholly inside another is a hole.
    Curves(Vec<Vec<DVec2>>),
    /// Nodal values on (cells + 1)² nodes, x fastest, negative inside.
    LevelSet { cells: usize, values: Vec<f64>, redistance: bool },
    /// Pixels, row 0 on top, inside > 127; the longest side fills the box.
    Mask { width: usize, height: usize, data: Vec<u8> },
}

/// A shape in space.
#[derive(Clone, Debug)]
pub enum Solid {
    /// A closed mesh: positions, and triples of them.
    Mesh { positions: Vec<[f64; 3]>, triangles: Vec<[u32; 3]> },
    /// Nodal values on (cells + 1)³ nodes, x fastest, negative inside.
    LevelSet { cells: usize, values: Vec<f64>, redistance: bool },
}

/// Cells a side a level set may have, in the plane and in space.
const LEVEL_SET_CELLS: std::ops::RangeInclusive<usize> = 4..=4096;
const SOLID_CELLS: std::ops::RangeInclusive<usize> = 4..=256;

impl Solid {
    /// The signed distance on the grid of a level.
    ///
    /// # Errors
    /// What is wrong with the shape and what to do.
    pub fn distance(&self, level: u32) -> Result<SignedDistance<3>, ShapeError> {
        let grid = Grid::of_level(level);
        match self {
            Solid::Mesh { positions, triangles } => {
                SignedDistance::from_mesh(grid, positions, triangles).map_err(|problem| match problem {
                    MeshError::Shape(problem) => problem,
                    problem => ShapeError::Unsupported(problem.to_string()),
                })
            }
            Solid::LevelSet { cells, values, redistance } => {
                check_cells(*cells, SOLID_CELLS)?;
                SignedDistance::from_level_set_on(grid, Grid::new(*cells), values, *redistance)
            }
        }
    }
}

fn check_cells(cells: usize, range: std::ops::RangeInclusive<usize>) -> Result<(), ShapeError> {
    if cells.is_power_of_two() && range.contains(&cells) {
        return Ok(());
    }
    Err(ShapeError::LevelSetCells { cells, least: *range.start(), most: *range.end() })
}

impl Shape {
    /// The signed distance on the grid of a level.
    ///
    /// # Errors
    /// What is wrong with the shape and what to do.
    pub fn distance(&self, level: u32) -> Result<SignedDistance<2>, ShapeError> {
        let grid = Grid::of_level(level);
        match self {
            Shape::Curves(loops) => SignedDistance::from_loops(grid, loops),
            Shape::Mask { width, height, data } => SignedDistance::from_mask(grid, *width, *height, data),
            Shape::LevelSet { cells, values, redistance } => {
                check_cells(*cells, LEVEL_SET_CELLS)?;
                SignedDistance::from_level_set_on(grid, Grid::new(*cells), values, *redistance)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_set_serves_coarser_and_finer_levels() {
        let grid = Grid::<2>::new(32);
        let values: Vec<f64> = (0..grid.node_count())
            .map(|node| DVec2::from(grid.position(node)).distance(DVec2::splat(0.5)) - 0.25)
            .collect();
        for redistance in [false, true] {
            let shape = Shape::LevelSet { cells: 32, values: values.clone(), redistance };
            for level in [4, 5, 6] {
                let distance = shape.distance(level).expect("a valid level set");
                let centre = distance.grid().node([distance.grid().cells() / 2; 2]);
                assert!((distance.values()[centre] + 0.25).abs() < 0.02);
            }
        }
    }

    #[test]
    fn a_level_set_needs_a_power_of_two() {
        let problem = Shape::LevelSet { cells: 12, values: vec![0.0; 169], redistance: false }.distance(5).err();
        assert_eq!(problem, Some(ShapeError::LevelSetCells { cells: 12, least: 4, most: 4096 }));
    }
}
