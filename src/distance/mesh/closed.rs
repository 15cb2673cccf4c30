//! Triangles as they come, made a closed surface.

use crate::error::MeshError;
use crate::hypersurface::{Hypersurface, measure};
use crate::numbers::Numbers;
use glam::DVec3;
use std::sync::Arc;

/// Positions that agree when rounded to this are one, domain units: files keep six or seven digits.
const COINCIDENT: f64 = 1e-6;

/// The length of the rims of all holes, in units of the root of the area, beyond which a mesh is open. On a sphere it is that
/// of a hole of a sixth of its radius.
const LONGEST_RIM: f64 = 0.3;

/// A surface without rim.
pub(super) struct Mesh {
    pub surface: Arc<Hypersurface<3>>,
    /// Whether every edge is passed as often one way as the other.
    pub is_oriented: bool,
}

/// Joins positions, drops triangles without area, and closes small holes by cones.
pub(super) fn closed(positions: &[[f64; 3]], indices: &[[u32; 3]]) -> Result<Mesh, MeshError> {
    let (mut points, numbers) = joined(positions);
    let mut triangles: Vec<[u32; 3]> = indices
        .iter()
        .map(|triangle| triangle.map(|index| numbers[index as usize]))
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    let edges = Edges::of(&triangles);
    let rim = edges.rim();
    if !rim.is_empty() {
        close(&mut points, &mut triangles, &rim)?;
    }
    // What was closed is passed both ways by construction.
    let is_oriented = edges.is_oriented();
    Ok(Mesh { surface: Arc::new(Hypersurface::new(points, triangles)), is_oriented })
}

/// The positions that differ, and the number of each position among them.
fn joined(positions: &[[f64; 3]]) -> (Vec<[f64; 3]>, Vec<u32>) {
    let (mut columns, mut places, mut points) = (Numbers::default(), Numbers::default(), Vec::new());
    let numbers = positions
        .iter()
        .map(|position| {
            let [x, y, z] = position.map(|x| (x / COINCIDENT).round() as i64);
            let number = places.of([i64::from(columns.of([x, y])), z]);
            if number as usize == points.len() {
                points.push(*position);
            }
            number
        })
        .collect();
    (points, numbers)
}

/// How often each edge is passed, by its ends in ascending order.
struct Edges {
    ends: Vec<[u32; 2]>,
    /// Passages from the lower end to the higher, and back.
    passages: Vec<[u32; 2]>,
}

impl Edges {
    fn of(triangles: &[[u32; 3]]) -> Self {
        let mut numbers = Numbers::default();
        let mut edges = Self { ends: Vec::new(), passages: Vec::new() };
        for triangle in triangles {
            for k in 0..3 {
                let (from, to) = (triangle[k], triangle[(k + 1) % 3]);
                let ends = [from.min(to), from.max(to)];
                let number = numbers.of(ends.map(i64::from)) as usize;
                if number == edges.ends.len() {
                    edges.ends.push(ends);
                    edges.passages.push([0; 2]);
                }
                edges.passages[number][usize::from(from > to)] += 1;
            }
        }
        edges
    }

    /// The edges of an odd number of triangles, in the direction that closes them.
    fn rim(&self) -> Vec<[u32; 2]> {
        let open = self.ends.iter().zip(&self.passages).filter(|(_, [forth, back])| (forth + back) % 2 == 1);
        open.map(|(&[low, high], [forth, back])| if forth > back { [high, low] } else { [low, high] }).collect()
    }

    /// Of the edges that are not open.
    fn is_oriented(&self) -> bool {
        self.passages.iter().all(|[forth, back]| forth == back || (forth + back) % 2 == 1 && forth.abs_diff(*back) == 1)
    }
}

/// Adds a cone over each rim, if they are short.
fn close(points: &mut Vec<[f64; 3]>, triangles: &mut Vec<[u32; 3]>, rim: &[[u32; 2]]) -> Result<(), MeshError> {
    let place = |number: u32| DVec3::from(points[number as usize]);
    let length = |edge: &[u32; 2]| place(edge[0]).distance(place(edge[1]));
    let area: f64 = triangles.iter().map(|triangle| measure(&triangle.map(|corner| points[corner as usize]))).sum();
    let holes = holes(points.len(), rim);
    let whole: f64 = rim.iter().map(length).sum();
    if whole > LONGEST_RIM * area.sqrt() {
        let rim_of = |hole: &&Vec<[u32; 2]>| hole.iter().map(length).sum::<f64>();
        let largest = holes.iter().max_by(|a, b| rim_of(a).total_cmp(&rim_of(b)));
        let at = largest.map_or([0.5; 3], |hole| middle(points, hole));
        return Err(MeshError::Open { edges: rim.len(), at });
    }
    for hole in holes {
        let tip = points.len() as u32;
        points.push(middle(points, &hole));
        triangles.extend(hole.iter().map(|&[from, to]| [from, to, tip]));
    }
    Ok(())
}

fn middle(points: &[[f64; 3]], rim: &[[u32; 2]]) -> [f64; 3] {
    let sum: DVec3 = rim.iter().map(|[from, _]| DVec3::from(points[*from as usize])).sum();
    (sum / rim.len() as f64).to_array()
}

/// The rims of single holes: edges that hang together.
fn holes(points: usize, rim: &[[u32; 2]]) -> Vec<Vec<[u32; 2]>> {
    let mut parents: Vec<u32> = (0..points as u32).collect();
    fn root(parents: &mut [u32], mut number: u32) -> u32 {
        while parents[number as usize] != number {
            parents[number as usize] = parents[parents[number as usize] as usize];
            number = parents[number as usize];
        }
        number
    }
    for &[from, to] in rim {
        let (a, b) = (root(&mut parents, from), root(&mut parents, to));
        parents[a as usize] = b;
    }
    let mut numbers = Numbers::default();
    let mut holes: Vec<Vec<[u32; 2]>> = Vec::new();
    for &edge in rim {
        let number = numbers.of([i64::from(root(&mut parents, edge[0])), 0]) as usize;
        if number == holes.len() {
            holes.push(Vec::new());
        }
        holes[number].push(edge);
    }
    holes
}
