//! Shapes from JavaScript.

use super::read::{bytes, items, numbers, property, whole, wrong};
use crate::error::{Error, ShapeError};
use crate::shape::Shape;
use crate::words::quoted;
use glam::DVec2;
use wasm_bindgen::prelude::*;

const KINDS: &str = "\"curves\", \"levelSet\", \"mask\" or \"mesh\"";

pub(super) fn read_shape(name: &'static str, shape: &JsValue) -> Result<Shape, JsError> {
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
        "curves" => Ok(Shape::Curves(read_loops(&owner, &field("loops")?)?)),
        "mask" => {
            let (width, height) = (count("width")?, count("height")?);
            let data = bytes(&format!("{owner}'s data"), &field("data")?)?;
            Ok(Shape::Mask { width, height, data })
        }
        "levelSet" => {
            let (cells, dim, redistance) = (count("cells")?, count("dim")?, field("redistance")?);
            let Some(redistance) = redistance.as_bool() else {
                return Err(wrong(&format!("{owner}'s redistance"), &redistance, "true or false"));
            };
            if dim != 2 {
                return unsupported(format!("has dimension {dim}; only 2D shapes can be registered so far"));
            }
            let values = numbers(&format!("{owner}'s values"), &field("values")?)?;
            Ok(Shape::LevelSet { cells, values, redistance })
        }
        "mesh" => unsupported("is a mesh; only 2D shapes can be registered so far".into()),
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
