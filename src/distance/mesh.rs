//! The signed distance of what a triangle mesh encloses.

mod closed;
mod edges;

mod inside;
mod regions;
mod scan;
mod spread;

use super::SignedDistance;
use crate::error::{MeshError, ShapeError};
use crate::field::interpolate;
use crate::grid::Grid;
use crate::hypersurface::Hypersurface;
use closed::closed;
use glam::DVec3;
use inside::inside;
use spread::distances;
use std::sync::Arc;

/// More triangles than any mesh that a page should take; more would exhaust its memory.
const MOST_TRIANGLES: usize = 4_000_000;

/// Six times its volume over the area to the power of 3/2 below which a mesh encloses nothing; of a ball it is 0.56.
const LEAST_VOLUME: f64 = 1e-6;

impl SignedDistance<3> {
    /// The signed distance of the nodes to a closed mesh: exact up to a twentieth of the box and three cells, beyond to a triangle
    /// that nodes of a coarser grid are nearest to, which may be a part of a cell too far.
    ///
    /// `indices` are triples of positions. Positions that coincide are one, so that triangles need not share theirs. Where
    /// all edges are passed as often one way as the other, the inside is what the mesh winds around, so that bodies which
    /// cross unite and a cavity is a surface that faces inwards; if not, the inside is what lies behind an odd number of
    /// triangles. Small holes are closed.
    ///
    /// # Errors
    ///
    /// No triangle, an index without position, a coordinate that is not finite, a mesh that is open, encloses no volume,
    /// comes within [`CLEARANCE`](super::CLEARANCE) cells of the border, or is too thin for the grid.
    pub fn from_mesh(grid: Grid<3>, positions: &[[f64; 3]], indices: &[[u32; 3]]) -> Result<Self, MeshError> {
        check(grid, positions, indices)?;
        let mesh = closed(positions, indices)?;
        let volume = volume(&mesh.surface);
        if mesh.is_oriented && volume.abs() < LEAST_VOLUME * mesh.surface.measure().powf(1.5) {
            return Err(MeshError::NoVolume);
        }
        let inside = inside(grid, &mesh);
        if !inside.contains(&true) {
            return Err(ShapeError::TooSmall { cells: grid.cells() }.into());
        }
        let [outline, surface] = without_inner_parts(&mesh.surface, grid, &inside);
        let mut values = distances(grid, &surface);
        for (value, inside) in values.iter_mut().zip(inside) {
            if inside && *value > 0.0 {
                *value = -*value;
            }
        }
        let whole = shadows(&outline);
        let distance = Self { grid, values: Arc::new(values), outline: Some(Arc::new(outline)) };
        distance.check_resolved(whole).map_err(|problem| distance.with_place(problem))?;
        Ok(distance)
    }

    /// Where the grid sees least of a thin mesh.
    fn with_place(&self, problem: ShapeError) -> MeshError {
        match (&problem, self.least_seen()) {
            (&ShapeError::TooThin { share, cells }, Some((at, _))) => MeshError::TooThin { share, cells, at },
            _ => problem.into(),
        }
    }

    /// The place of the outline that lies farthest outside of what the grid sees, and how far, in cells. Zero where the grid
    /// sees it.
    pub fn least_seen(&self) -> Option<([f64; 3], f64)> {
        let outline = self.outline.as_ref()?;
        let farther = |best: Option<([f64; 3], f64)>, middle: [f64; 3]| {
            let [value] = interpolate::<3, 1>(self.grid, &self.values, &middle);
            let cells = value * self.grid.cells() as f64;
            if best.is_none_or(|(_, most)| cells > most) { Some((middle, cells)) } else { best }
        };
        outline.middles().map(|(middle, _)| middle).fold(None, farther)
    }
}

/// What can be said before anything is computed.
fn check(grid: Grid<3>, positions: &[[f64; 3]], indices: &[[u32; 3]]) -> Result<(), MeshError> {
    if positions.is_empty() || indices.is_empty() {
        return Err(MeshError::NoTriangles);
    }
    if indices.len() > MOST_TRIANGLES {
        return Err(MeshError::TooManyTriangles { most: MOST_TRIANGLES });
    }
    if let Some(vertex) = positions.iter().position(|position| !position.iter().all(|x| x.is_finite())) {
        return Err(MeshError::VertexNotFinite { vertex });
    }
    let is_broken = |triangle: &[u32; 3]| triangle.iter().any(|&index| index as usize >= positions.len());
    if let Some(triangle) = indices.iter().position(is_broken) {
        let index = indices[triangle].iter().copied().max().unwrap_or(0);
        return Err(MeshError::NoSuchVertex { triangle, index, vertices: positions.len() });
    }
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for corner in indices.iter().flatten() {
        for axis in 0..3 {
            let x = positions[*corner as usize][axis];
            (low[axis], high[axis]) = (low[axis].min(x), high[axis].max(x));
        }
    }
    Ok(super::check_clearance(low, high, grid.cells())?)
}

/// The pieces, no longer than cells, around which some node lies outside: where bodies cross, what one has inside the other is no
/// part of the outline and has no distance of its own. And the same with the triangles as they were where all of them is left.
fn without_inner_parts(surface: &Hypersurface<3>, grid: Grid<3>, inside: &[bool]) -> [Hypersurface<3>; 2] {
    let (pieces, wholes) = surface.cut(grid.spacing());
    let is_outer = |middle: [f64; 3]| {
        let (cell, _) = grid.locate(&middle);
        // From one node before the cell to one behind it.
        let first = cell.map(|i| i.saturating_sub(1));
        let last = cell.map(|i| (i + 2).min(grid.cells()));
        (first[2]..=last[2])
            .any(|k| (first[1]..=last[1]).any(|j| (first[0]..=last[0]).any(|i| !inside[grid.node([i, j, k])])))
    };
    let mut is_whole = vec![true; surface.simplices().len()];
    let mut kept = Vec::with_capacity(wholes.len());
    for (((middle, _), corners), whole) in pieces.middles().zip(pieces.simplices()).zip(wholes) {
        if is_outer(middle) {
            kept.push((*corners, whole));
        } else {
            is_whole[whole as usize] = false;
        }
    }
    let wholes =
        surface.simplices().iter().zip(&is_whole).filter(|(_, is_whole)| **is_whole).map(|(corners, _)| *corners);
    let parts = kept.iter().filter(|(_, whole)| !is_whole[*whole as usize]).map(|(corners, _)| *corners);
    let points = pieces.points().to_vec();
    [kept.iter().map(|(corners, _)| *corners).collect(), wholes.chain(parts).collect()]
        .map(|simplices| Hypersurface::new(points.clone(), simplices))
}

/// Σ_axis ∫ |n_axis|.
fn shadows(surface: &Hypersurface<3>) -> f64 {
    let normals = surface.all_corners().map(|corners| {
        let [a, b, c] = corners.map(DVec3::from);
        (b - a).cross(c - a)
    });
    normals.map(|normal| 0.5 * normal.abs().element_sum()).sum()
}

/// Six times the volume.
fn volume(surface: &Hypersurface<3>) -> f64 {
    surface.all_corners().map(|corners| corners.map(DVec3::from)).map(|[a, b, c]| a.dot(b.cross(c))).sum()
}
