//! What can be wrong with the input, in words that say what to do.

use crate::words::{fixed, number, quoted, scientific};
use thiserror::Error;

#[derive(Clone, Debug, PartialEq, Error)]
pub enum Error {
    /// A shape that cannot be registered; `shape` is "reference" or "template".
    #[error("the {shape} {problem}")]
    Shape { shape: &'static str, problem: ShapeError },
    /// A setting out of its range.
    #[error("{name} is {value}, but must be {range}")]
    Setting { name: &'static str, value: String, range: String },
    /// A setting that there is not, with the one that may have been meant, or all.
    #[error("settings has no field {}; {hint}", quoted(name))]
    UnknownSetting { name: String, hint: String },
    /// An array whose length does not fit.
    #[error("{name} holds {found} numbers, but {expected} are needed ({why})")]
    Length { name: &'static str, found: usize, expected: usize, why: String },
    /// An array with a NaN or an infinity.
    #[error("{name} has a value that is not finite at position {position}; replace or remove it")]
    NotFinite { name: &'static str, position: usize },
    /// More memory than there is.
    #[error(
        "finest = {finest} with these settings needs up to {} GB of memory, more than there is; choose a smaller coarsest or finest level",
        fixed(*gigabytes, 1)
    )]
    Memory { gigabytes: f64, finest: u32 },
    /// A graphics card is insisted on.
    #[error("backend is \"gpu\", but {reason}; choose \"auto\" or \"cpu\"")]
    NoCard { reason: String },
    /// Weights, or a level set, out of all proportion.
    #[error(
        "the {term} energy is {} before anything has moved, more than numbers of this precision can balance ({} at most); choose smaller weights, or level sets that are distances",
        number(*value), number(*most)
    )]
    NoEnergy { term: &'static str, value: f64, most: f64 },
}

/// What is wrong with one shape. Reads on after "the reference …".
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ShapeError {
    #[error("has no points; draw or load a closed curve")]
    Empty,
    #[error("has a loop of only {points} points (loop {index}); a closed curve needs at least three")]
    TooFewPoints { index: usize, points: usize },
    #[error("has a coordinate that is not finite (loop {index}, point {point}); remove that point")]
    NotFinite { index: usize, point: usize },
    #[error("encloses no area; draw a curve that goes around something")]
    NoArea,
    #[error("holds no node of the grid of {cells} cells a side; make it larger or choose a finer grid")]
    TooSmall { cells: usize },
    #[error(
        "is too thin for the grid of {cells} cells a side, which sees {} % of its outline; make it thicker or choose a finer grid",
        fixed(100.0 * share, 0)
    )]
    TooThin { share: f64, cells: usize },
    #[error(
        "leaves the box on the {side} ({coordinate} = {}); make it smaller or move it inwards (\"Fit\" does both)",
        place(*value)
    )]
    OutsideBox { side: &'static str, coordinate: &'static str, value: f64 },
    #[error(
        "comes within {} cells of the {side} border (at {coordinate} = {}), at least {} are needed; make it smaller or move it inwards (\"Fit\" does both)",
        fixed(*cells, 1), fixed(*value, 3), number(*needed)
    )]
    NearBorder { side: &'static str, coordinate: &'static str, value: f64, cells: f64, needed: f64 },
    #[error("has a level set of {found} values, but {cells} cells a side in {dim}D make {expected} nodes")]
    LevelSetLength { found: usize, expected: usize, cells: usize, dim: usize },
    #[error("has a level set of {cells} cells a side; a power of two from {least} to {most} is needed")]
    LevelSetCells { cells: usize, least: usize, most: usize },
    #[error("has a level set value that is not finite at node {node}; replace it")]
    LevelSetNotFinite { node: usize },
    #[error("has a level set without a sign change; it must be negative inside and positive outside")]
    NoSignChange,
    #[error(
        "has a level set that is no distance: it climbs {} a unit of length at its zero set and reaches {}, a distance 1 and less than 2; set redistance to true, or scale it",
        scientific(*slope), scientific(*greatest)
    )]
    LevelSetSlope { slope: f64, greatest: f64 },
    #[error("has a mask of {found} pixels, but {width} × {height} = {expected} are needed")]
    MaskLength { found: usize, width: usize, height: usize, expected: usize },
    #[error(
        "has too many strokes that cross or lie close together (at most {most} crossings are handled); draw a simpler curve"
    )]
    Tangled { most: usize },
    #[error("has an outline of more than {most} points; smooth it, or make the picture smaller")]
    TooManyPoints { most: usize },
    #[error("{0}")]
    Unsupported(String),
}

/// What is wrong with a mesh. Reads on after "the reference …".
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MeshError {
    #[error(
        "is too thin for the grid of {cells} cells a side, which sees {} % of its surface and least of it at {}; make it thicker or choose a finer grid",
        fixed(100.0 * share, 0), place_in_space(at)
    )]
    TooThin { share: f64, cells: usize, at: [f64; 3] },
    #[error("has no triangles; load a closed mesh")]
    NoTriangles,
    #[error("has more than {most} triangles; simplify the mesh")]
    TooManyTriangles { most: usize },
    #[error("has a vertex with a coordinate that is not finite (vertex {vertex}); remove or replace it")]
    VertexNotFinite { vertex: usize },
    #[error(
        "has a triangle with vertex {index} (triangle {triangle}), but there are only {vertices} vertices, numbered from 0"
    )]
    NoSuchVertex { triangle: usize, index: u32, vertices: usize },
    #[error("holds {found} numbers as its {name}, but {needed}")]
    Length { name: &'static str, found: usize, needed: &'static str },
    #[error(
        "is open: {edges} edges belong to one triangle only, the largest hole is at {}; close it, only small holes are closed by themselves",
        place_in_space(at)
    )]
    Open { edges: usize, at: [f64; 3] },
    #[error("encloses no volume; load a mesh that goes around something")]
    NoVolume,
    #[error(transparent)]
    Shape(#[from] ShapeError),
}

/// A coordinate, with an exponent where it lies so far off that its digits would fill the page.
fn place(value: f64) -> String {
    if value.abs() < 1e6 { fixed(value, 3) } else { scientific(value) }
}

fn place_in_space(at: &[f64; 3]) -> String {
    let [x, y, z] = at.map(|x| fixed(x, 2));
    format!("({x}, {y}, {z})")
}
