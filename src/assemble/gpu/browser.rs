//! What a browser tells of its graphics card: wgpu asks for less, and panics where there is no browser.

use js_sys::{Function, Object, Promise, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;

pub(super) struct Told {
    pub name: String,
    /// Whether a processor plays the card.
    pub is_software: bool,
}

/// Chromium's, which older versions do not call a fallback.
const SOFTWARE: &str = "swiftshader";

/// # Errors
/// A sentence's part, if there is no card.
pub(super) async fn ask() -> Result<Told, String> {
    let global = js_sys::global().into();
    let is_browser = ["window", "WorkerGlobalScope"].iter().any(|name| !get(&global, name).is_undefined());
    let gpu = get(&get(&global, "navigator"), "gpu");
    if !is_browser || gpu.is_undefined() {
        return Err("there is no WebGPU here, which browsers reach graphics cards by".into());
    }
    let adapter = adapter_of(&gpu).await.unwrap_or(JsValue::NULL);
    if adapter.is_null() {
        return Err("the browser finds no graphics card to compute on".into());
    }
    let info = get(&adapter, "info");
    let text = |name| get(&info, name).as_string().unwrap_or_default();
    let is_fallback = get(&info, "isFallbackAdapter").is_truthy();
    let (vendor, architecture, description) = (text("vendor"), text("architecture"), text("description"));
    let words = if description.is_empty() { [vendor.as_str(), &architecture].join(" ") } else { description };
    let name = if words.trim().is_empty() { "a card without a name" } else { words.trim() };
    Ok(Told { name: name.into(), is_software: is_fallback || architecture == SOFTWARE })
}

async fn adapter_of(gpu: &JsValue) -> Result<JsValue, JsValue> {
    let options = Object::new();
    Reflect::set(&options, &"powerPreference".into(), &"high-performance".into())?;
    let request: Function = get(gpu, "requestAdapter").dyn_into()?;
    JsFuture::from(request.call1(gpu, &options)?.dyn_into::<Promise>()?).await
}

fn get(object: &JsValue, name: &str) -> JsValue {
    Reflect::get(object, &name.into()).unwrap_or(JsValue::UNDEFINED)
}
