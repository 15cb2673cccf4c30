//! Looking into JavaScript's values. They may have getters or be proxies: whatever those throw becomes a sentence, since
//! an exception that passed through the solver would leave its promise pending.

use crate::words::{number, quoted};
#[cfg(feature = "surfaces")]
use js_sys::Uint32Array;
use js_sys::{Array, Float64Array, Function, Object, Reflect, Uint8Array};
use wasm_bindgen::prelude::*;

/// More numbers than any shape that can be handled has: a level set of 4096² cells.
const MOST_NUMBERS: u32 = 4097 * 4097;
/// Pixels of a mask at most; every one takes a byte of the four gigabytes there are.
const MOST_PIXELS: u32 = 200_000_000;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_name = Float64Array)]
    type CopiedNumbers;
    /// Throws for arrays whose memory is gone, which js-sys does not expect.
    #[wasm_bindgen(constructor, catch, js_class = "Float64Array")]
    fn new(source: &JsValue) -> Result<CopiedNumbers, JsValue>;

    #[wasm_bindgen(js_name = Uint8Array)]
    type CopiedBytes;
    #[wasm_bindgen(constructor, catch, js_class = "Uint8Array")]
    fn new(source: &JsValue) -> Result<CopiedBytes, JsValue>;

    #[cfg(feature = "surfaces")]
    #[wasm_bindgen(js_name = Uint32Array)]
    type CopiedIndices;
    #[cfg(feature = "surfaces")]
    #[wasm_bindgen(constructor, catch, js_class = "Uint32Array")]
    fn new(source: &JsValue) -> Result<CopiedIndices, JsValue>;

    /// True for typed arrays only, whatever else a value claims to be.
    #[wasm_bindgen(js_namespace = ArrayBuffer, js_name = isView)]
    fn is_view(value: &JsValue) -> bool;

    /// Throws for a proxy that was revoked.
    #[wasm_bindgen(catch, js_namespace = Array, js_name = isArray)]
    fn is_array(value: &JsValue) -> Result<bool, JsValue>;

    #[wasm_bindgen(catch, js_namespace = Array, js_name = from)]
    fn array_from(value: &JsValue) -> Result<Array, JsValue>;
}

/// A property of what must be an object; `owner` says whose.
pub(super) fn property(owner: &str, object: &JsValue, name: &str) -> Result<JsValue, JsError> {
    if !object.is_object() {
        return Err(wrong(owner, object, "an object"));
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
    if !(is_view(value) && value.is_instance_of::<Float64Array>()) {
        return Err(wrong(what, value, "a Float64Array"));
    }
    let copied = CopiedNumbers::new(value).map_err(|thrown| unreadable(what, &thrown))?;
    let copied = copied.unchecked_into::<Float64Array>();
    let mut numbers = room(what, copied.length(), MOST_NUMBERS)?;
    copied.copy_to(&mut numbers);
    Ok(numbers)
}

/// The bytes of what must be a Uint8Array.
pub(super) fn bytes(what: &str, value: &JsValue) -> Result<Vec<u8>, JsError> {
    if !(is_view(value) && value.is_instance_of::<Uint8Array>()) {
        return Err(wrong(what, value, "a Uint8Array"));
    }
    let copied = CopiedBytes::new(value).map_err(|thrown| unreadable(what, &thrown))?;
    let copied = copied.unchecked_into::<Uint8Array>();
    let mut bytes = room(what, copied.length(), MOST_PIXELS)?;
    copied.copy_to(&mut bytes);
    Ok(bytes)
}

/// The numbers of what must be a Uint32Array.
#[cfg(feature = "surfaces")]
pub(super) fn indices(what: &str, value: &JsValue) -> Result<Vec<u32>, JsError> {
    if !(is_view(value) && value.is_instance_of::<Uint32Array>()) {
        return Err(wrong(what, value, "a Uint32Array"));
    }
    let copied = CopiedIndices::new(value).map_err(|thrown| unreadable(what, &thrown))?;
    let copied = copied.unchecked_into::<Uint32Array>();
    let mut indices = room(what, copied.length(), MOST_NUMBERS)?;
    copied.copy_to(&mut indices);
    Ok(indices)
}

/// Zeros to be written over, or a refusal where there is no memory for them.
fn room<T: Default + Clone>(what: &str, length: u32, most: u32) -> Result<Vec<T>, JsError> {
    let mut room = Vec::new();
    if length > most || room.try_reserve_exact(length as usize).is_err() {
        return Err(JsError::new(&format!("{what} holds {length} numbers; there is room for {most} at most")));
    }
    room.resize(length as usize, T::default());
    Ok(room)
}

/// The items of what must be an array.
pub(super) fn items(what: &str, value: &JsValue, needed: &str) -> Result<Array, JsError> {
    if !is_array(value).map_err(|thrown| unreadable(what, &thrown))? {
        return Err(wrong(what, value, needed));
    }
    array_from(value).map_err(|thrown| unreadable(what, &thrown))
}

/// A whole number from `least` up that fits everywhere.
pub(super) fn whole(value: &JsValue, least: f64) -> Option<usize> {
    value.as_f64().filter(|value| (least..=1e9).contains(value) && value.fract() == 0.0).map(|value| value as usize)
}

/// An object with the same own properties, read once: later nobody's getter runs, and nothing changes any more.
/// What is no object stays what it is.
pub(super) fn snapshot(owner: &str, value: &JsValue) -> Result<JsValue, JsError> {
    if !value.is_object() || is_array(value).unwrap_or(true) || is_view(value) {
        return Ok(value.clone());
    }
    let copy = Object::new();
    for name in names(owner, value)? {
        // Properties of a fresh plain object can be defined freely.
        let _ = Reflect::define_property(&copy, &name.as_str().into(), &{
            let descriptor = Object::new();
            let _ = Reflect::set(&descriptor, &"value".into(), &property(owner, value, &name)?);
            let _ = Reflect::set(&descriptor, &"enumerable".into(), &true.into());
            descriptor
        });
    }
    Ok(copy.into())
}

/// What is no number, array and so on, with what is needed instead.
pub(super) fn wrong(what: &str, value: &JsValue, needed: &str) -> JsError {
    JsError::new(&format!("{what} is {}, but must be {needed}", described(value)))
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
    } else if is_array(value).unwrap_or(false) {
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
