//! The contact that an answer belongs to, values that were left to defaults among them.

use super::Arguments;
use crate::command::digits::shown;
use crate::failure::Failure;
use serde_json::{Map, Value};
use tribos::friction::{Patch, Tier};
use tribos::record::json_number;

/// A named value of the contact.
#[derive(Clone, Debug, PartialEq)]
pub enum ContactParameter {
    /// A word such as a patch or a law.
    Word(&'static str, String),
    /// A number and its unit.
    Number(&'static str, f64, &'static str),
}

/// What `arguments` say of the contact, in the order of the help, and the tier that evaluates it.
pub fn contact(arguments: &Arguments, tier: Tier) -> Result<Vec<ContactParameter>, Failure> {
    let mut given = vec![ContactParameter::Word("patch", arguments.patch.to_string())];
    // Points bring their own lengths, unless the pressure leans over a radius.
    if !matches!(arguments.patch, Patch::Points(_)) || arguments.tilt.is_some() {
        given.push(ContactParameter::Number("radius", arguments.radius()?, "m"));
    }
    given.extend(
        arguments
            .tilt
            .map(|tilt| ContactParameter::Number("tilt", tilt, "")),
    );
    given.push(ContactParameter::Number("load", arguments.load()?, "N"));
    match &arguments.law {
        Some(law) => given.push(ContactParameter::Word("law", law.to_string())),
        None => {
            let unit = if arguments.alpha == 0.0 {
                ""
            } else {
                "(s/m)^alpha"
            };
            given.push(ContactParameter::Number(
                "coefficient",
                arguments.coefficient.largest(),
                unit,
            ));
            given.push(ContactParameter::Number("alpha", arguments.alpha, ""));
        }
    }
    given.push(ContactParameter::Word("tier", tier.to_string()));
    Ok(given)
}

/// One line a value.
pub fn lines(given: &[ContactParameter]) -> String {
    let line = |(name, value): (&str, String)| format!("{name:<15} {value}\n");
    given.iter().map(ContactParameter::text).map(line).collect()
}

/// All values in one line.
pub fn sentence(given: &[ContactParameter]) -> String {
    let parts: Vec<String> = given
        .iter()
        .map(ContactParameter::text)
        .map(|(name, value)| format!("{name} {value}"))
        .collect();
    parts.join(", ")
}

/// An object of all values, in SI units.
pub fn json(given: &[ContactParameter]) -> Value {
    let field = |given: &ContactParameter| match given {
        ContactParameter::Word(name, word) => ((*name).to_owned(), word.as_str().into()),
        ContactParameter::Number(name, value, _) => ((*name).to_owned(), json_number(*value)),
    };
    Value::Object(given.iter().map(field).collect::<Map<_, _>>())
}

impl ContactParameter {
    fn text(&self) -> (&'static str, String) {
        match self {
            Self::Word(name, word) => (name, word.clone()),
            Self::Number(name, value, unit) => {
                let text = format!("{} {unit}", shown(*value));
                (name, text.trim_end().to_owned())
            }
        }
    }
}
