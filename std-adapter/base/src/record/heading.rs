//! Names of columns and the units that stand beside them.

use super::units::any_unit;

/// Brackets around units.
const BRACKETS: [(char, char); 4] = [('[', ']'), ('(', ')'), ('<', '>'), ('{', '}')];

/// The heading of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Heading {
    /// The text of the file.
    pub text: String,
    /// The name without the unit.
    pub name: String,
    /// The unit, if the heading or the line under it has one.
    pub unit: Option<String>,
    /// Whether its numbers change their sign.
    pub is_negated: bool,
}

impl Heading {
    /// Takes `Speed [mm/s]`, `Force (N)`, `Time/s`, `speed_mm_s`, `x in mm` apart; what is none of these is a name.
    pub fn of(text: &str) -> Self {
        let text = text.trim();
        let parts = in_brackets(text).or_else(|| behind_a_mark(text));
        let (name, unit) = match parts {
            Some((name, unit)) => (name, Some(unit)),
            None => (text, None),
        };
        Self {
            text: text.to_owned(),
            name: name.trim().trim_end_matches([',', ':']).trim().to_owned(),
            unit,
            is_negated: false,
        }
    }
}

/// The text inside of brackets around the whole of it, or the text itself.
pub(super) fn without_brackets(text: &str) -> &str {
    let text = text.trim();
    let inside = BRACKETS
        .iter()
        .find_map(|(open, close)| text.strip_prefix(*open)?.strip_suffix(*close));
    inside.unwrap_or(text).trim()
}

/// Name and unit where the unit stands in brackets at the end.
fn in_brackets(text: &str) -> Option<(&str, String)> {
    BRACKETS.iter().find_map(|(open, close)| {
        let (name, unit) = text.strip_suffix(*close)?.rsplit_once(*open)?;
        // `Time/(s)` and `v / [m/s]` have both signs.
        let name = name.trim_end().trim_end_matches('/');
        let is_named = !name.trim().is_empty();
        is_named.then(|| (name, unit.trim().to_owned()))
    })
}

/// Name and unit where a known unit follows a slash, an underscore, a blank, or the word in.
fn behind_a_mark(text: &str) -> Option<(&str, String)> {
    let marks = text
        .char_indices()
        .filter(|(_, letter)| matches!(letter, '/' | '_' | ' ' | ','));
    let mut found = marks.filter_map(|(at, letter)| {
        let (name, rest) = text.split_at(at);
        let rest = rest.get(letter.len_utf8()..)?.trim();
        let name = name.strip_suffix(" in").unwrap_or(name);
        let is_plausible = !name.trim().is_empty() && !is_bare_number(rest);
        let unit = spelled(rest, letter).filter(|_| is_plausible)?;
        Some((name, unit))
    });
    found.next()
}

/// A known unit; after an underscore the next one is a stroke, as in `mm_s`.
fn spelled(rest: &str, mark: char) -> Option<String> {
    let rest = rest.strip_prefix("in ").unwrap_or(rest);
    let is_unit = |text: &str| !text.is_empty() && any_unit(text).is_some();
    if is_unit(rest) {
        return Some(rest.to_owned());
    }
    let parted = rest.replacen('_', "/", 1);
    (mark == '_' && is_unit(&parted)).then_some(parted)
}

/// Whether it numbers a column, as in `force 1`.
fn is_bare_number(text: &str) -> bool {
    matches!(text, "-" | "--" | "–") || text.chars().all(|letter| letter.is_ascii_digit())
}

/// A name for comparison: small letters and digits alone.
pub(super) fn plain_name(name: &str) -> String {
    let letters = name.chars().filter(|letter| letter.is_alphanumeric());
    letters.collect::<String>().to_lowercase().replace('μ', "µ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_taken_from_names() {
        for (text, name, unit) in [
            ("Speed [mm/s]", "Speed", Some("mm/s")),
            ("Force (N)", "Force", Some("N")),
            ("Time/s", "Time", Some("s")),
            ("v / mm/s", "v", Some("mm/s")),
            ("v/(mm/s)", "v", Some("mm/s")),
            ("speed_mm_s", "speed", Some("mm/s")),
            ("sliding_speed_um_s", "sliding_speed", Some("um/s")),
            ("time_ms", "time", Some("ms")),
            ("Weg in mm", "Weg", Some("mm")),
            ("Weg, mm", "Weg", Some("mm")),
            ("Force N", "Force", Some("N")),
            ("Displ(microns)", "Displ", Some("microns")),
            ("Force (filtered)", "Force", Some("filtered")),
            ("COF", "COF", None),
            ("sliding_speed", "sliding_speed", None),
            ("force 1", "force 1", None),
            ("Input 1", "Input 1", None),
            ("[N]", "[N]", None),
            ("µ", "µ", None),
            ("", "", None),
        ] {
            let made = Heading::of(text);
            assert_eq!(
                (made.name.as_str(), made.unit.as_deref()),
                (name, unit),
                "{text}"
            );
        }
        assert_eq!(without_brackets(" [mm/s] "), "mm/s");
        assert_eq!(plain_name("Sliding_Speed 2"), "slidingspeed2");
        assert_eq!(plain_name("μ"), plain_name("µ"));
    }
}
