//! What a declaration of a setting consists of.

use super::Settings;
use crate::words::{number, quoted};
use std::fmt;

/// A setting: its words, what it can be, and where it is kept.
pub struct Setting {
    pub words: Words,
    pub kind: Kind,
    pub(super) field: fn(&mut Settings) -> &mut dyn Field,
}

/// What people read of a setting.
pub struct Words {
    /// In JavaScript.
    pub name: &'static str,
    /// In formulas; empty where there is none.
    pub symbol: &'static str,
    pub group: Group,
    /// Whether the page offers it.
    pub on_page: bool,
    /// In plain words.
    pub label: &'static str,
    /// A sentence or two: what it does.
    pub help: &'static str,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    Energies,
    Grid,
    Method,
}

/// What a setting can be.
pub enum Kind {
    Number(Range),
    /// A level l of the grid: 2^l cells a side.
    Level {
        least: u32,
        most: u32,
        /// What the page offers.
        usual: (u32, u32),
    },
    /// Names with their labels.
    Choice(&'static [(&'static str, &'static str)]),
    /// Labels of true and false.
    Flag([&'static str; 2]),
}

/// The numbers from `least` to `most`.
#[derive(Clone, Copy)]
pub struct Range {
    pub least: f64,
    pub most: f64,
    /// Why not beyond them.
    pub why: &'static str,
    /// What the page offers.
    pub usual: (f64, f64),
    pub unit: &'static str,
}

impl Range {
    pub(super) const fn new(least: f64, most: f64, why: &'static str) -> Self {
        Self { least, most, why, usual: (least, most), unit: "" }
    }

    pub(super) const fn usual(self, least: f64, most: f64) -> Self {
        Self { usual: (least, most), ..self }
    }

    pub(super) const fn unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }
}

/// A value of any kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'a> {
    Number(f64),
    Flag(bool),
    Text(&'a str),
    /// Nothing that a setting can be, in words.
    Other(&'a str),
}

impl fmt::Display for Value<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => f.write_str(&number(*value)),
            Self::Flag(value) => value.fmt(f),
            Self::Text(text) => f.write_str(&quoted(text)),
            Self::Other(words) => f.write_str(words),
        }
    }
}

/// Where a setting is kept.
pub(super) trait Field {
    fn value(&self) -> Value<'static>;

    /// False, and nothing changed, for a value of another kind.
    fn take(&mut self, value: Value) -> bool;
}

impl Field for f64 {
    fn value(&self) -> Value<'static> {
        Value::Number(*self)
    }

    fn take(&mut self, value: Value) -> bool {
        if let Value::Number(number) = value {
            *self = number;
        }
        matches!(value, Value::Number(_))
    }
}

impl Field for u32 {
    fn value(&self) -> Value<'static> {
        Value::Number(f64::from(*self))
    }

    fn take(&mut self, value: Value) -> bool {
        let Value::Number(number) = value else { return false };
        let whole = number as u32;
        if f64::from(whole) == number {
            *self = whole;
        }
        f64::from(whole) == number
    }
}

impl Field for bool {
    fn value(&self) -> Value<'static> {
        Value::Flag(*self)
    }

    fn take(&mut self, value: Value) -> bool {
        if let Value::Flag(flag) = value {
            *self = flag;
        }
        matches!(value, Value::Flag(_))
    }
}

/// The names and labels of an enum's variants, and the enum as a [`Field`].
macro_rules! choices {
    ($($kind:ident: $names:ident { $($variant:ident = $name:literal, $label:literal;)* })*) => { $(
        const $names: &[(&str, &str)] = &[$(($name, $label)),*];

        impl Field for $kind {
            fn value(&self) -> Value<'static> {
                Value::Text(match self { $(Self::$variant => $name),* })
            }

            fn take(&mut self, value: Value) -> bool {
                match value {
                    $(Value::Text($name) => *self = Self::$variant,)*
                    _ => return false,
                }
                true
            }
        }
    )* };
}

/// The struct `Settings`, its defaults and the list of its declarations.
macro_rules! declare {
    ($($field:ident: $type:ty = $default:expr => {
        name: $name:literal, symbol: $symbol:literal, group: $group:ident, on_page: $on_page:literal,
        label: $label:literal,
        help: $help:literal,
        kind: $kind:expr $(,)?
    })*) => {
        /// The settings of a registration. Lengths are domain units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Settings {
            $(#[doc = concat!($symbol, " ", $label, ". ", $help)] pub $field: $type,)*
        }

        impl Default for Settings {
            fn default() -> Self {
                Self { $($field: $default),* }
            }
        }

        /// All settings but the pins, in the order in which they are shown.
        pub const SETTINGS: &[Setting] = &[$(Setting {
            words: Words {
                name: $name,
                symbol: $symbol,
                group: Group::$group,
                on_page: $on_page,
                label: $label,
                help: $help,
            },
            kind: $kind,
            field: |settings| &mut settings.$field,
        }),*];
    };
}

pub(super) use {choices, declare};
