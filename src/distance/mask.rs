//! The signed distance of what a picture shows.

use glam::DVec2;

use super::SignedDistance;
use super::polygon::{MOST_POINTS, check_box};
use super::winding::Region;
use crate::contour::trace;
use crate::error::ShapeError;
use crate::grid::Grid;

/// Midway between the greatest grey value outside and the least inside.
const THRESHOLD: f64 = 127.5;

impl SignedDistance<2> {
    /// The exact signed distance to the outline of the pixels above 127, row 0 on top, one byte a pixel.
    ///
    /// The longest side of the picture spans `[0,1]`, the shorter one is centred. Grey values belong to the pixels'
    /// centres; the outline is where their bilinear interpolant passes 127.5, so that smooth edges are found to a
    /// fraction of a pixel. All components and holes count, and what lies beyond the picture is outside.
    ///
    /// # Errors
    ///
    /// A wrong number of pixels, an outline of more than two million points, and what [`from_loops`](Self::from_loops) refuses.
    pub fn from_mask(grid: Grid<2>, width: usize, height: usize, data: &[u8]) -> Result<Self, ShapeError> {
        let expected = width.saturating_mul(height);
        if data.len() != expected {
            return Err(ShapeError::MaskLength { found: data.len(), width, height, expected });
        }
        if expected == 0 {
            return Err(ShapeError::Empty);
        }
        let value = |column: usize, row: usize| THRESHOLD - f64::from(data[(height - 1 - row) * width + column]);
        let Some(mut contours) = trace(width, height, value, THRESHOLD, MOST_POINTS) else {
            return Err(ShapeError::TooManyPoints { most: MOST_POINTS });
        };
        if contours.is_empty() {
            return Err(ShapeError::NoArea);
        }
        let longest = width.max(height) as f64;
        let size = DVec2::new(width as f64, height as f64);
        let margin = DVec2::splat(0.5) + (longest - size) * 0.5;
        for point in contours.iter_mut().flatten() {
            *point = (*point + margin) / longest;
        }
        check_box(grid, &contours)?;

        // The contours never cross and run counter-clockwise around what they enclose and clockwise around holes:
        // together they wind once around the inside, as one contour would.
        let mut region = Region::of_contours(&contours);
        for edge in &mut region.edges {
            edge.contour = 0;
        }
        region.signs = vec![1];
        let segments: Vec<_> = region.edges.iter().map(|edge| [edge.a, edge.b]).collect();
        Self::of_region(grid, &region, &segments)
    }
}
