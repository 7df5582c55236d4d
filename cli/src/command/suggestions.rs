//! Words that are not known: what was meant, or what there is.

use tribos::scene::nearest;

/// "no scene `dsk`; did you mean `disk`?", or the list of all where none is near.
pub fn unknown<'a>(said: &str, word: &str, all: impl IntoIterator<Item = &'a str>) -> String {
    let all: Vec<&str> = all.into_iter().collect();
    match nearest(word, all.iter().copied()) {
        Some(meant) => format!("{said}; did you mean `{meant}`?"),
        None => match all[..] {
            [only] => format!("{said}; there is {only}"),
            _ => format!("{said}; there are {}", all.join(", ")),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::unknown;

    #[test]
    fn the_nearest_word_or_all_of_them() {
        let all = ["disk", "ring", "hertz"];
        assert_eq!(
            unknown("no `hetrz`", "hetrz", all),
            "no `hetrz`; did you mean `hertz`?"
        );
        assert_eq!(
            unknown("no `xyz`", "xyz", all),
            "no `xyz`; there are disk, ring, hertz"
        );
    }
}
