//! Settings from and to JavaScript, by their declarations.

use super::read::{described, names, numbers, property};
use crate::settings::{Group, Kind, PINS, SETTINGS, Settings, Value, Words, named};
use js_sys::{Array, Float64Array, Object, Reflect};
use wasm_bindgen::prelude::*;

// Both are written from `describeSettings` when the package is built.
#[wasm_bindgen(typescript_custom_section)]
const SETTINGS_TYPE: &str = r#"
import type { Setting, Settings } from "./settings.js";
export type { Setting, Settings };
"#;

/// Settings and pins.
#[derive(Clone, Default)]
pub(super) struct Chosen {
    pub settings: Settings,
    /// As they came: the dimension is the shapes'.
    pub pins: Vec<f64>,
    /// Whether the finest level was chosen: what is usual depends on the dimension.
    pub is_finest_chosen: bool,
}

impl Chosen {
    /// The same with what `change` names; a field set to undefined is one left out.
    pub fn with(&self, change: &JsValue) -> Result<Self, JsError> {
        let mut chosen = self.clone();
        if change.is_undefined() || change.is_null() {
            return Ok(chosen);
        }
        if !change.is_object() || change.is_instance_of::<Array>() {
            let found = described(change);
            return Err(JsError::new(&format!("settings is {found}, but must be an object, every field optional")));
        }
        for name in names("settings", change)? {
            let value = property("settings", change, &name)?;
            if value.is_undefined() {
                continue;
            }
            if name == PINS.name {
                chosen.pins = numbers(PINS.name, &value)?;
                continue;
            }
            chosen.is_finest_chosen |= name == "finest";
            let words = described(&value);
            let text = value.as_string();
            let value = match (value.as_f64(), value.as_bool(), &text) {
                (Some(number), ..) => Value::Number(number),
                (_, Some(flag), _) => Value::Flag(flag),
                (.., Some(text)) => Value::Text(text),
                _ => Value::Other(&words),
            };
            chosen.settings.set(named(&name)?, value)?;
        }
        chosen.settings.validate()?;
        Ok(chosen)
    }

    pub fn to_js(&self) -> JsValue {
        let object = Object::new();
        for setting in SETTINGS {
            put(&object, setting.words.name, &to_js(self.settings.get(setting)));
        }
        put(&object, PINS.name, &Float64Array::from(self.pins.as_slice()));
        object.into()
    }
}

/// Every setting: its words, its kind, its default and what it can be.
#[wasm_bindgen(js_name = describeSettings, unchecked_return_type = "Setting[]")]
pub fn describe_settings() -> Array {
    let defaults = Settings::default();
    let described = SETTINGS.iter().map(|setting| {
        let object = describe(&setting.words);
        put(&object, "initial", &to_js(defaults.get(setting)));
        let options = |options: &mut dyn Iterator<Item = (JsValue, &str)>| {
            let list: Array = options
                .map(|(value, label)| {
                    let option = Object::new();
                    put(&option, "value", &value);
                    put(&option, "label", &label.into());
                    option
                })
                .collect();
            put(&object, "kind", &"choice".into());
            put(&object, "options", &list);
        };
        match &setting.kind {
            Kind::Number(range) => {
                put(&object, "kind", &"number".into());
                put(&object, "least", &range.least.into());
                put(&object, "most", &range.most.into());
                put(&object, "why", &range.why.into());
                put(&object, "usual", &pair(range.usual.0, range.usual.1));
                put(&object, "unit", &range.unit.into());
            }
            Kind::Level { least, most, usual } => {
                put(&object, "kind", &"level".into());
                put(&object, "least", &(*least).into());
                put(&object, "most", &(*most).into());
                put(&object, "usual", &pair(usual.0, usual.1));
            }
            Kind::Choice(names) => options(&mut names.iter().map(|(name, label)| ((*name).into(), *label))),
            Kind::Flag(labels) => options(&mut [true.into(), false.into()].into_iter().zip(*labels)),
        }
        object
    });
    let pins = describe(&PINS);
    put(&pins, "kind", &"pins".into());
    described.chain([pins]).collect()
}

fn describe(words: &Words) -> Object {
    let object = Object::new();
    let group = match words.group {
        Group::Energies => "Energies",
        Group::Grid => "Grid",
        Group::Method => "Method",
    };
    let texts = [("name", words.name), ("symbol", words.symbol), ("group", group), ("label", words.label)];
    for (key, text) in texts.into_iter().chain([("help", words.help)]) {
        put(&object, key, &text.into());
    }
    put(&object, "onPage", &words.on_page.into());
    object
}

fn to_js(value: Value) -> JsValue {
    match value {
        Value::Number(value) => value.into(),
        Value::Flag(value) => value.into(),
        Value::Text(text) | Value::Other(text) => text.into(),
    }
}

fn pair(low: impl Into<JsValue>, high: impl Into<JsValue>) -> JsValue {
    Array::of2(&low.into(), &high.into()).into()
}

pub(super) fn put(object: &Object, key: &str, value: &JsValue) {
    // Setting a property of a fresh plain object cannot fail.
    let _ = Reflect::set(object, &key.into(), value);
}
