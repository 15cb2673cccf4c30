//! Looking into JavaScript's values. They may have getters or be proxies: whatever those throw becomes a sentence, since
//! an exception that passed through the solver would leave its promise pending.

use crate::words::{number, quoted};
use js_sys::{Array, Float64Array, Function, Reflect};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_name = Float64Array)]
    type Copied;

    /// Throws for arrays whose memory is gone, which js-sys does not expect.
    #[wasm_bindgen(constructor, catch, js_class = "Float64Array")]
    fn new(source: &JsValue) -> Result<Copied, JsValue>;
}

/// A property of what must be an object; `owner` says whose.
pub(super) fn property(owner: &str, object: &JsValue, name: &str) -> Result<JsValue, JsError> {
    if !object.is_object() {
        return Err(JsError::new(&format!("{owner} is {}, but must be an object", described(object))));
    }
    Reflect::get(object, &name.into()).map_err(|thrown| unreadable(&format!("{owner}'s {name}"), &thrown))
}

/// The names of an object's own properties.
pub(super) fn names(owner: &str, object: &JsValue) -> Result<Vec<String>, JsError> {
    let keys = Reflect::own_keys(object).map_err(|thrown| unreadable(owner, &thrown))?;
    // Symbols name nothing that could be meant.
    Ok(keys.iter().filter_map(|key| key.as_string()).collect())
}

/// The numbers of what must be a Float64Array; `what` says what it is for.
pub(super) fn numbers(what: &str, value: &JsValue) -> Result<Vec<f64>, JsError> {
    if !value.is_instance_of::<Float64Array>() {
        return Err(JsError::new(&format!("{what} is {}, but must be a Float64Array", described(value))));
    }
    let copied = Copied::new(value).map_err(|thrown| unreadable(what, &thrown))?;
    Ok(copied.unchecked_into::<Float64Array>().to_vec())
}

/// What a value is, for a message.
pub(super) fn described(value: &JsValue) -> String {
    if let Some(text) = value.as_string() {
        return quoted(&text);
    }
    if let Some(value) = value.as_f64() {
        return number(value);
    }
    if let Some(flag) = value.as_bool() {
        return flag.to_string();
    }
    let words = if value.is_null() {
        "null"
    } else if value.is_undefined() {
        "undefined"
    } else if value.is_bigint() {
        "a bigint"
    } else if value.is_symbol() {
        "a symbol"
    } else if value.is_instance_of::<Function>() {
        "a function"
    } else if value.is_instance_of::<Array>() {
        "an array"
    } else {
        "an object"
    };
    words.into()
}

fn unreadable(what: &str, thrown: &JsValue) -> JsError {
    let message = Reflect::get(thrown, &"message".into()).unwrap_or(JsValue::UNDEFINED);
    let why = message.as_string().map_or_else(|| described(thrown), |message| quoted(&message));
    JsError::new(&format!("{what} cannot be read: it throws {why}"))
}
