//! Shapes from JavaScript.

use super::read::property as property_of;
use crate::error::{Error, ShapeError};
use crate::shape::Shape;
use glam::DVec2;
use js_sys::{Array, Float64Array, Uint8Array};
use wasm_bindgen::prelude::*;

pub(super) fn read_shape(name: &'static str, shape: &JsValue) -> Result<Shape, JsError> {
    let unsupported =
        |problem: String| Err(Error::Shape { shape: name, problem: ShapeError::Unsupported(problem) }.into());
    match text(name, shape, "kind")?.as_str() {
        "curves" => Ok(Shape::Curves(read_loops(name, &property(name, shape, "loops")?)?)),
        "mask" => {
            let data: Uint8Array = typed(name, shape, "data", "a Uint8Array")?;
            let (width, height) = (count(name, shape, "width")?, count(name, shape, "height")?);
            Ok(Shape::Mask { width, height, data: data.to_vec() })
        }
        "levelSet" => {
            let values: Float64Array = typed(name, shape, "values", "a Float64Array")?;
            let (cells, dim) = (count(name, shape, "cells")?, count(name, shape, "dim")?);
            let Some(redistance) = property(name, shape, "redistance")?.as_bool() else {
                return Err(wrong(name, "redistance", "true or false"));
            };
            if dim != 2 {
                return unsupported(format!("has dimension {dim}; only 2D shapes can be registered so far"));
            }
            Ok(Shape::LevelSet { cells, values: values.to_vec(), redistance })
        }
        "mesh" => unsupported("is a mesh; only 2D shapes can be registered so far".into()),
        other => {
            unsupported(format!("has the unknown kind \"{other}\"; use \"curves\", \"levelSet\", \"mask\" or \"mesh\""))
        }
    }
}

fn read_loops(name: &'static str, loops: &JsValue) -> Result<Vec<Vec<DVec2>>, JsError> {
    if !Array::is_array(loops) {
        return Err(wrong(name, "loops", "an array of Float64Arrays"));
    }
    let mut result = Vec::new();
    for item in Array::from(loops).iter() {
        let Ok(array) = item.dyn_into::<Float64Array>() else {
            return Err(wrong(name, "loops", "an array of Float64Arrays"));
        };
        let numbers = array.to_vec();
        if numbers.len() % 2 == 1 {
            return Err(wrong(name, "loops", "made of an even count of numbers, x and y of every point"));
        }
        result.push(numbers.chunks_exact(2).map(|p| DVec2::new(p[0], p[1])).collect());
    }
    Ok(result)
}

fn wrong(shape: &str, field: &str, needed: &str) -> JsError {
    JsError::new(&format!("the {shape}'s {field} must be {needed}"))
}

fn property(shape: &str, object: &JsValue, field: &str) -> Result<JsValue, JsError> {
    property_of(&format!("the {shape}"), object, field)
}

fn text(shape: &str, object: &JsValue, field: &str) -> Result<String, JsError> {
    property(shape, object, field)?.as_string().ok_or_else(|| wrong(shape, field, "a string"))
}

fn count(shape: &str, object: &JsValue, field: &str) -> Result<usize, JsError> {
    match property(shape, object, field)?.as_f64() {
        Some(value) if (0.0..=1e9).contains(&value) && value.fract() == 0.0 => Ok(value as usize),
        _ => Err(wrong(shape, field, "a whole number from 0 up")),
    }
}

fn typed<T: JsCast>(shape: &str, object: &JsValue, field: &str, needed: &str) -> Result<T, JsError> {
    property(shape, object, field)?.dyn_into().map_err(|_| wrong(shape, field, needed))
}
