//! What may have been meant by a word that is not known, and by a text that is not a number.

/// Jaro–Winkler similarity from which a known word counts as meant.
const SIMILAR: f64 = 0.8;

/// The known word nearest to `word`, if one is near enough to be meant.
///
/// ```
/// use tribos::scene::{LIBRARY, nearest};
/// let names = || LIBRARY.iter().map(|scene| scene.name);
/// assert_eq!(nearest("compaction-smal", names()), Some("compaction-small"));
/// assert_eq!(nearest("xyzzy", names()), None);
/// ```
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_lowercase();
    known
        .into_iter()
        .map(|known| (strsim::jaro_winkler(&word, &known.to_lowercase()), known))
        .filter(|(similarity, _)| *similarity >= SIMILAR)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, known)| known)
}

/// Why a text in the place of a number is none in a scene, where that can be told: a unit after the number,
/// a decimal comma, or a form that TOML does not have.
///
/// ```
/// use tribos::scene::number_hint;
/// assert_eq!(number_hint("1kPa").as_deref(), Some("numbers carry no units"));
/// assert_eq!(number_hint("0,5").as_deref(), Some("write a decimal point: 0.5"));
/// assert_eq!(number_hint(".5").as_deref(), Some("write 0.5"));
/// assert_eq!(number_hint("high"), None);
/// ```
pub fn number_hint(text: &str) -> Option<String> {
    let text = text.trim();
    let is_number = |text: &str| text.parse::<f64>().is_ok_and(f64::is_finite);
    if is_number(text) {
        // As in Rust: with digits before and after the point.
        let is_read = toml::de::DeValue::parse(text).is_ok();
        let value = text.parse::<f64>().ok().filter(|_| !is_read)?;
        return Some(format!("write {value:?}"));
    }
    let pointed = text.replacen(',', ".", 1);
    if is_number(&pointed) && pointed != text {
        return Some(format!("write a decimal point: {pointed}"));
    }
    let ends = text.char_indices().map(|(at, _)| at).skip(1);
    let mut parts = ends.map(|at| text.split_at(at));
    let is_unit = |rest: &str| {
        rest.trim_start()
            .starts_with(|c: char| c.is_alphabetic() || "%°".contains(c))
    };
    parts
        .any(|(number, rest)| is_number(number.trim_end()) && is_unit(rest))
        .then(|| "numbers carry no units".into())
}

/// A finite number, or why a text is none and what to write instead.
pub fn finite_number(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(x) if x.is_finite() => Ok(x),
        Ok(x) => Err(format!("give a finite number, not {x}")),
        Err(_) => Err(match number_hint(text) {
            Some(hint) => format!("got {}; {hint}", text.trim()),
            None => "give a number such as 0.5 or 1e-3".into(),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_and_commas_are_told_from_words() {
        for (text, hint) in [
            ("5 m/s", "no units"),
            ("-1e3N", "no units"),
            ("90°", "no units"),
            ("12%", "no units"),
            ("0,5", "0.5"),
            ("-1,5e-3", "-1.5e-3"),
        ] {
            assert!(
                number_hint(text).is_some_and(|told| told.contains(hint)),
                "{text}"
            );
        }
        for text in ["", "1", "-2.5e7", "big", "1,2,3", "0:5:10", "é"] {
            assert_eq!(number_hint(text), None, "{text}");
        }
    }
}
