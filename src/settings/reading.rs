//! Settings by name, as they come from outside.

use super::{Kind, PINS, Range, SETTINGS, Setting, Settings, Value};
use crate::error::Error;
use crate::words::{edits, number};

impl Settings {
    /// The setting's value.
    pub fn get(&self, setting: &Setting) -> Value<'static> {
        let mut copy = *self;
        (setting.field)(&mut copy).value()
    }

    /// Changes one setting.
    ///
    /// # Errors
    /// A value that the setting cannot have; nothing has changed then.
    pub fn set(&mut self, setting: &Setting, value: Value) -> Result<(), Error> {
        let mut changed = *self;
        if !(setting.field)(&mut changed).take(value) {
            return Err(setting.refusal(value));
        }
        setting.check(value)?;
        *self = changed;
        Ok(())
    }
}

impl Setting {
    pub(super) fn check(&self, value: Value) -> Result<(), Error> {
        let fits = match (&self.kind, value) {
            (Kind::Number(range), Value::Number(value)) => (range.least..=range.most).contains(&value),
            (Kind::Level { least, most, .. }, Value::Number(value)) => {
                (f64::from(*least)..=f64::from(*most)).contains(&value)
            }
            (Kind::Choice(names), Value::Text(name)) => names.iter().any(|(known, _)| *known == name),
            (Kind::Flag(_), Value::Flag(_)) => true,
            _ => false,
        };
        if fits { Ok(()) } else { Err(self.refusal(value)) }
    }

    fn refusal(&self, value: Value) -> Error {
        Error::Setting { name: self.words.name, value: value.to_string(), range: self.kind.to_string() }
    }
}

/// Reads on after "must be".
impl std::fmt::Display for Kind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(Range { least, most, why, .. }) => {
                write!(f, "a number from {} to {} ({why})", number(*least), number(*most))
            }
            Self::Level { least, most, .. } => write!(f, "a level from {least} to {most} (2^level cells a side)"),
            Self::Choice(names) => {
                let quoted: Vec<String> = names.iter().map(|(name, _)| format!("\"{name}\"")).collect();
                write!(f, "one of {}", quoted.join(", "))
            }
            Self::Flag(_) => f.write_str("true or false"),
        }
    }
}

/// Typing errors that a name may be off by.
const NEAR: usize = 2;

/// The setting of a name.
///
/// # Errors
/// Says which name may have been meant.
pub fn named(name: &str) -> Result<&'static Setting, Error> {
    SETTINGS.iter().find(|setting| setting.words.name == name).ok_or_else(|| unknown(name))
}

fn unknown(name: &str) -> Error {
    let names = || SETTINGS.iter().map(|setting| &setting.words).chain([&PINS]).map(|words| words.name);
    // Comparing is quadratic in length, and a name twice as long as another is not meant for it.
    let alike = names().filter(|known| name.len() <= 2 * known.len());
    let hint = match alike.map(|known| (edits(name, known), known)).min() {
        Some((edits, known)) if edits <= NEAR => format!("did you mean \"{known}\"?"),
        _ => format!("its fields are {}", names().collect::<Vec<_>>().join(", ")),
    };
    Error::UnknownSetting { name: name.into(), hint }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn changed(name: &str, value: Value) -> Result<Settings, String> {
        let mut settings = Settings::default();
        let result = named(name).and_then(|setting| settings.set(setting, value));
        result.map(|()| settings).map_err(|error| error.to_string())
    }

    #[test]
    fn every_value_that_is_set_is_got_again() {
        for setting in SETTINGS {
            let values: Vec<Value> = match &setting.kind {
                Kind::Number(range) => [range.least, range.most, range.usual.1].map(Value::Number).to_vec(),
                Kind::Level { least, most, .. } => [*least, *most].map(|l| Value::Number(f64::from(l))).to_vec(),
                Kind::Choice(names) => names.iter().map(|(name, _)| Value::Text(name)).collect(),
                Kind::Flag(_) => [true, false].map(Value::Flag).to_vec(),
            };
            for value in values {
                let settings = changed(setting.words.name, value).unwrap();
                assert_eq!(settings.get(setting), value, "{}", setting.words.name);
            }
        }
    }

    #[test]
    fn refusals_name_the_field_and_what_it_can_be() {
        let cases = [
            ("cutoff", Value::Text("round"), r#"cutoff is "round", but must be one of "quartic", "cosine", "bump""#),
            ("halving", Value::Text("yes"), r#"halving is "yes", but must be true or false"#),
            ("align", Value::Flag(true), r#"align is true, but must be one of "similarity", "none""#),
            ("finest", Value::Number(6.5), "finest is 6.5, but must be a level from 3 to 10 (2^level cells a side)"),
            (
                "finest",
                Value::Number(f64::NAN),
                "finest is NaN, but must be a level from 3 to 10 (2^level cells a side)",
            ),
            (
                "vertexShare",
                Value::Other("an array"),
                "vertexShare is an array, but must be a number from 0 to 1 (it is a share)",
            ),
        ];
        for (name, value, message) in cases {
            assert_eq!(changed(name, value).unwrap_err(), message);
        }
        let message = changed("membrane", Value::Number(1e308)).unwrap_err();
        assert!(message.starts_with("membrane is 1e308, but must be a number from 0 to 1e6 ("), "{message}");
    }

    #[test]
    fn a_mistyped_name_is_put_right_and_a_foreign_one_answered_by_all() {
        let message = |name: &str| changed(name, Value::Number(1.0)).unwrap_err();
        assert_eq!(message("bendign"), r#"settings has no field "bendign"; did you mean "bending"?"#);
        assert_eq!(message("Pin"), r#"settings has no field "Pin"; did you mean "pins"?"#);
        assert!(message("colour").contains(r#"no field "colour"; its fields are membrane, membraneModel"#));
        assert!(message(&"x".repeat(1_000_000)).len() < 500);
    }
}
