//! Level sets as they are given, and what is checked of them.

use std::ops::RangeInclusive;

use super::SignedDistance;
use super::march;
use crate::error::ShapeError;
use crate::grid::Grid;

/// How steep a level set that is used as it is may be where it changes sign; a distance has slope 1. The band, the
/// mismatch and the normals take its values for lengths.
const SLOPES: RangeInclusive<f64> = 0.1..=10.0;

/// The same for its values: no distance in the box is longer than its diagonal.
const GREATEST_VALUE: f64 = 100.0;

/// Values in this range are not scaled before they are re-distanced, so that no bit of them changes.
const SAFE: RangeInclusive<f64> = 1e-100..=1e100;

impl<const D: usize> SignedDistance<D> {
    /// Nodal values used as they are, a signed distance or not.
    ///
    /// # Errors
    ///
    /// A wrong number of values, one that is not finite, values all of one sign, or a zero set that comes within
    /// [`CLEARANCE`](super::CLEARANCE) cells of the border.
    pub fn from_level_set(grid: Grid<D>, values: Vec<f64>) -> Result<Self, ShapeError> {
        check_level_set(grid, &values)?;
        let level_set = Self::from_nodal(grid, values);
        level_set.check_clearance(grid.cells())?;
        Ok(level_set)
    }

    /// The signed distance to the zero set of a level set, negative where the level set is.
    ///
    /// # Errors
    ///
    /// As [`from_level_set`](Self::from_level_set).
    pub fn redistance(grid: Grid<D>, values: &[f64]) -> Result<Self, ShapeError> {
        let level_set = Self::redistanced(grid, values)?;
        level_set.check_clearance(grid.cells())?;
        Ok(level_set)
    }

    /// A level set on a grid of its own, carried to the grid `onto` and checked there; re-distanced before, or used as
    /// it is.
    ///
    /// # Errors
    ///
    /// As [`from_level_set`](Self::from_level_set), with the clearance in cells of `onto`; values that are no lengths and
    /// are to be used as they are; what `onto` does not resolve.
    ///
    /// # Panics
    ///
    /// Unless one number of cells divides the other.
    pub fn from_level_set_on(
        onto: Grid<D>,
        grid: Grid<D>,
        values: &[f64],
        redistance: bool,
    ) -> Result<Self, ShapeError> {
        let level_set = if redistance {
            Self::redistanced(grid, values)?
        } else {
            check_level_set(grid, values)?;
            let level_set = Self::from_nodal(grid, values.to_vec());
            level_set.check_slope()?;
            level_set
        };
        level_set.check_clearance(onto.cells())?;
        let distance = level_set.to_cells(onto.cells());
        // Injection to a coarser grid, or interpolation on a finer one, must not have lost the shape.
        if onto.cells() < grid.cells() {
            distance.check_resolved(level_set.outline_measure(1))?;
        } else {
            distance.check_resolved(0.0)?;
        }
        Ok(distance)
    }

    fn redistanced(grid: Grid<D>, values: &[f64]) -> Result<Self, ShapeError> {
        check_level_set(grid, values)?;
        let greatest = greatest(values);
        let values = if SAFE.contains(&greatest) {
            march::redistance(grid, values)
        } else {
            march::redistance(grid, &values.iter().map(|value| value / greatest).collect::<Vec<_>>())
        };
        Ok(Self::from_nodal(grid, values))
    }

    fn check_slope(&self) -> Result<(), ShapeError> {
        let (mut sum, mut count) = (0.0, 0_usize);
        for (node, &value) in self.values.iter().enumerate() {
            let index = self.grid.node_index(node);
            for axis in (0..D).filter(|&axis| index[axis] < self.grid.cells()) {
                let ahead = self.values[node + self.grid.stride(axis)];
                if (value < 0.0) != (ahead < 0.0) {
                    sum += (ahead - value).abs();
                    count += 1;
                }
            }
        }
        let slope = sum / (count as f64 * self.grid.spacing());
        let greatest = greatest(&self.values);
        if SLOPES.contains(&slope) && greatest <= GREATEST_VALUE {
            Ok(())
        } else {
            Err(ShapeError::LevelSetSlope { slope, greatest })
        }
    }
}

fn greatest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

fn check_level_set<const D: usize>(grid: Grid<D>, values: &[f64]) -> Result<(), ShapeError> {
    if values.len() != grid.node_count() {
        return Err(ShapeError::LevelSetLength {
            found: values.len(),
            expected: grid.node_count(),
            cells: grid.cells(),
            dim: D,
        });
    }
    if let Some(node) = values.iter().position(|value| !value.is_finite()) {
        return Err(ShapeError::LevelSetNotFinite { node });
    }
    let negative = values.iter().filter(|value| **value < 0.0).count();
    if negative == 0 || negative == values.len() {
        return Err(ShapeError::NoSignChange);
    }
    Ok(())
}
