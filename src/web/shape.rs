//! Shapes from JavaScript.

#[cfg(feature = "surfaces")]
use super::read::indices;
use super::read::{bytes, items, numbers, property, whole, wrong};
#[cfg(feature = "surfaces")]
use crate::error::MeshError;
use crate::error::{Error, ShapeError};
use crate::shape::Shape;
#[cfg(feature = "surfaces")]
use crate::shape::Solid;
use crate::words::quoted;
use glam::DVec2;
use wasm_bindgen::prelude::*;

/// This module is the first that a page loads: what surfaces need is in another.
#[cfg(not(feature = "surfaces"))]
const ELSEWHERE: &str = "surfaces are registered by the module for surfaces, this one is for curves";

const KINDS: &str = "\"curves\", \"levelSet\", \"mask\" or \"mesh\"";

/// A shape of either dimension.
#[derive(Clone)]
pub(super) enum Given {
    Plane(Shape),
    #[cfg(feature = "surfaces")]
    Space(Solid),
}

pub(super) fn read_shape(name: &'static str, shape: &JsValue) -> Result<Given, JsError> {
    let owner = format!("the {name}");
    let unsupported =
        |problem: String| Err(Error::Shape { shape: name, problem: ShapeError::Unsupported(problem) }.into());
    let field = |field: &str| property(&owner, shape, field);
    let count = |name: &str| -> Result<usize, JsError> {
        let value = field(name)?;
        whole(&value, 0.0).ok_or_else(|| wrong(&format!("{owner}'s {name}"), &value, "a whole number from 0 up"))
    };
    let kind = field("kind")?;
    let Some(kind) = kind.as_string() else {
        return Err(wrong(&format!("{owner}'s kind"), &kind, KINDS));
    };
    match kind.as_str() {
        "curves" => Ok(Given::Plane(Shape::Curves(read_loops(&owner, &field("loops")?)?))),
        "mask" => {
            let (width, height) = (count("width")?, count("height")?);
            let data = bytes(&format!("{owner}'s data"), &field("data")?)?;
            Ok(Given::Plane(Shape::Mask { width, height, data }))
        }
        "levelSet" => {
            let (cells, dim, redistance) = (count("cells")?, count("dim")?, field("redistance")?);
            let Some(redistance) = redistance.as_bool() else {
                return Err(wrong(&format!("{owner}'s redistance"), &redistance, "true or false"));
            };
            let values = || numbers(&format!("{owner}'s values"), &field("values")?);
            match dim {
                2 => Ok(Given::Plane(Shape::LevelSet { cells, values: values()?, redistance })),
                #[cfg(feature = "surfaces")]
                3 => Ok(Given::Space(Solid::LevelSet { cells, values: values()?, redistance })),
                #[cfg(not(feature = "surfaces"))]
                3 => unsupported(format!("has dimension 3; {ELSEWHERE}")),
                _ => unsupported(format!("has dimension {dim}; it must be 2 or 3")),
            }
        }
        #[cfg(feature = "surfaces")]
        "mesh" => {
            let positions = numbers(&format!("{owner}'s positions"), &field("positions")?)?;
            let triangles = indices(&format!("{owner}'s indices"), &field("indices")?)?;
            let length = |array: &'static str, found: usize, needed: &'static str| -> Result<(), JsError> {
                let problem = ShapeError::Unsupported(MeshError::Length { name: array, found, needed }.to_string());
                if found.is_multiple_of(3) { Ok(()) } else { Err(Error::Shape { shape: name, problem }.into()) }
            };
            length("positions", positions.len(), "every vertex has three, x, y and z")?;
            length("indices", triangles.len(), "every triangle has three")?;
            Ok(Given::Space(Solid::Mesh {
                positions: positions.as_chunks::<3>().0.to_vec(),
                triangles: triangles.as_chunks::<3>().0.to_vec(),
            }))
        }
        #[cfg(not(feature = "surfaces"))]
        "mesh" => unsupported(format!("is a mesh; {ELSEWHERE}")),
        other => unsupported(format!("has the unknown kind {}; use {KINDS}", quoted(other))),
    }
}

fn read_loops(owner: &str, loops: &JsValue) -> Result<Vec<Vec<DVec2>>, JsError> {
    let mut result = Vec::new();
    let loops = items(&format!("{owner}'s loops"), loops, "an array of Float64Arrays")?;
    for (index, item) in loops.iter().enumerate() {
        let what = format!("{owner}'s loops[{index}]");
        let numbers = numbers(&what, &item)?;
        if numbers.len() % 2 == 1 {
            let count = numbers.len();
            return Err(JsError::new(&format!("{what} holds {count} numbers, but every point needs two, x and y")));
        }
        result.push(numbers.chunks_exact(2).map(|p| DVec2::new(p[0], p[1])).collect());
    }
    Ok(result)
}
