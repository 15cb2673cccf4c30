//! The signed distance of what closed polygons enclose.

use glam::DVec2;

use super::SignedDistance;
use super::nearest::Nearest;
use super::outline::{COINCIDENT, outline};
use super::winding::Region;
use crate::error::ShapeError;
use crate::grid::Grid;
use crate::hypersurface::Hypersurface;
use crate::numbers::Numbers;
use std::sync::Arc;

/// Pieces of an outline shorter than this, in cells, are joined: its true place is needed to a small part of a cell.
const SHORTEST: f64 = 0.1;

/// More points than any clean outline has; more would exhaust the memory of a page.
pub(super) const MOST_POINTS: usize = 2_000_000;

impl SignedDistance<2> {
    /// The exact signed distance of the nodes to the outline of what `loops` enclose.
    ///
    /// Loops are closed polygons in `[0,1]²`, y up, of any orientation; the first point may stand again at the end.
    /// A loop encloses what it winds around (non-zero winding, so a loop that crosses itself is filled). A loop that
    /// lies wholly inside an odd number of the others is a hole, any other adds its inside; loops that partly overlap
    /// unite; equal loops count once. Only the outline of the result counts: strokes inside it have no distance of their own.
    ///
    /// # Errors
    ///
    /// No loop, fewer than three different points, a coordinate that is not finite, less than
    /// [`CLEARANCE`](super::CLEARANCE) cells to the border, no area, no node of the grid inside or
    /// too few along thin parts, or very many crossings.
    pub fn from_loops(grid: Grid<2>, loops: &[Vec<DVec2>]) -> Result<Self, ShapeError> {
        let contours = distinct(clean(loops)?);
        check_box(grid, &contours)?;
        let (region, segments) = outline(&contours)?;
        Self::of_region(grid, &region, &segments)
    }

    pub(super) fn of_region(grid: Grid<2>, region: &Region, segments: &[[DVec2; 2]]) -> Result<Self, ShapeError> {
        if segments.is_empty() {
            return Err(ShapeError::NoArea);
        }
        let side = grid.side();
        let inside = region.classify_nodes(side, grid.spacing());
        if !inside.contains(&true) {
            return Err(ShapeError::TooSmall { cells: grid.cells() });
        }
        let outline = Hypersurface::from_segments(segments, SHORTEST * grid.spacing(), grid.spacing());
        let values = Arc::new(distances(grid, segments, &inside));
        let distance = Self { grid, values, outline: Some(Arc::new(outline)) };
        distance.check_resolved(segments.iter().map(|[a, b]| (*b - *a).abs().element_sum()).sum())?;
        Ok(distance)
    }
}

/// Exact at every node: with the neighbours' nearest segments as hints the search costs about as much as marching
/// would, and leaves no seam where an exact zone ends.
fn distances(grid: Grid<2>, segments: &[[DVec2; 2]], inside: &[bool]) -> Vec<f64> {
    let (side, spacing) = (grid.side(), grid.spacing());
    let nearest = Nearest::new(segments);
    let mut values = Vec::with_capacity(side * side);
    let mut below = vec![nearest.any_leaf(); side];
    for (row, signs) in inside.chunks_exact(side).enumerate() {
        let mut left = below[0];
        for (column, (&inside, below)) in signs.iter().zip(&mut below).enumerate() {
            let point = DVec2::new(column as f64, row as f64) * spacing;
            let (distance, leaf) = nearest.query(point, [left, *below]);
            (left, *below) = (leaf, leaf);
            values.push(if inside && distance > 0.0 { -distance } else { distance });
        }
    }
    values
}

/// Each contour once, wherever it starts and whichever way it goes: the same curve drawn twice is one curve.
fn distinct(mut contours: Vec<Vec<DVec2>>) -> Vec<Vec<DVec2>> {
    // Numbers of points, and of their sequences: each is a sequence seen before and one more point.
    let (mut places, mut sequences, mut seen) = (Numbers::default(), Numbers::default(), Numbers::default());
    contours.retain(|points| {
        let count = points.len();
        let first =
            (0..count).min_by(|&a, &b| points[a].x.total_cmp(&points[b].x).then(points[a].y.total_cmp(&points[b].y)));
        let first = first.unwrap_or(0);
        let walk =
            |step: usize| (0..count).map(move |k| points[(first + k * step) % count].to_array().map(f64::to_bits));
        let (forth, back): (Vec<_>, Vec<_>) = (walk(1).collect(), walk(count - 1).collect());
        let sequence = forth.min(back).into_iter().fold(-1, |before, point| {
            let place = i64::from(places.of(point.map(|bits| bits as i64)));
            i64::from(sequences.of([before, place]))
        });
        seen.is_new([sequence, 0])
    });
    contours
}

/// The loops without repeated points.
fn clean(loops: &[Vec<DVec2>]) -> Result<Vec<Vec<DVec2>>, ShapeError> {
    if loops.iter().all(Vec::is_empty) {
        return Err(ShapeError::Empty);
    }
    if loops.iter().map(Vec::len).sum::<usize>() > MOST_POINTS {
        return Err(ShapeError::TooManyPoints { most: MOST_POINTS });
    }
    let mut contours = Vec::with_capacity(loops.len());
    for (index, points) in loops.iter().enumerate() {
        if let Some(point) = points.iter().position(|p| !p.is_finite()) {
            return Err(ShapeError::NotFinite { index, point });
        }
        let mut contour: Vec<DVec2> = Vec::with_capacity(points.len());
        for &point in points {
            if contour.last().is_none_or(|last| !same(*last, point)) {
                contour.push(point);
            }
        }
        while contour.len() > 1 && same(contour[0], contour[contour.len() - 1]) {
            contour.pop();
        }
        if contour.len() < 3 {
            return Err(ShapeError::TooFewPoints { index, points: contour.len() });
        }
        contours.push(contour);
    }
    Ok(contours)
}

/// Closer than ten times what counts as coincident, so that no edge is as short as that.
fn same(a: DVec2, b: DVec2) -> bool {
    a.distance_squared(b) <= (10.0 * COINCIDENT).powi(2)
}

pub(super) fn check_box(grid: Grid<2>, contours: &[Vec<DVec2>]) -> Result<(), ShapeError> {
    let (low, high) = contours
        .iter()
        .flatten()
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    super::check_clearance(low.to_array(), high.to_array(), grid.cells())
}
