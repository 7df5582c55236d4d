//! Text as HTML.

use std::fmt::Write as _;

/// Text with HTML's special characters escaped.
pub(super) fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '&' => safe.push_str("&amp;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            other => safe.push(other),
        }
    }
    safe
}

/// Escaped text: parts between backticks are code, between two stars strong, `[words](target)` a link.
pub(super) fn inline(text: &str) -> String {
    let mut html = String::new();
    for (at, part) in text.split('`').enumerate() {
        if at % 2 == 1 {
            let _ = write!(html, "<code>{}</code>", escape(part));
        } else {
            html += &strong(part);
        }
    }
    html
}

fn strong(text: &str) -> String {
    let Some((before, [inside, after])) = text.split_once("**").and_then(|(before, rest)| {
        let (inside, after) = rest.split_once("**")?;
        Some((before, [inside, after]))
    }) else {
        return links(text);
    };
    let [before, inside] = [before, inside].map(links);
    format!("{before}<b>{inside}</b>{}", strong(after))
}

fn links(text: &str) -> String {
    let found = text.find("](").and_then(|middle| {
        let open = text[..middle].rfind('[')?;
        let close = middle + text[middle..].find(')')?;
        Some([open, middle, close])
    });
    let Some([open, middle, close]) = found else {
        return escape(text);
    };
    let words = escape(&text[open + 1..middle]);
    let target = escape(&text[middle + 2..close]);
    let (before, after) = (escape(&text[..open]), links(&text[close + 1..]));
    format!("{before}<a href=\"{target}\">{words}</a>{after}")
}

#[cfg(test)]
mod tests {
    use super::inline;

    #[test]
    fn code_strong_words_and_links_are_told_from_brackets_and_products() {
        let cases = [
            ("a*b* ** c", "a*b* ** c"),
            ("**a <b>** `c`", "<b>a &lt;b&gt;</b> <code>c</code>"),
            (
                "in [0, 1) see [b & c](d.html#e) (f)",
                "in [0, 1) see <a href=\"d.html#e\">b &amp; c</a> (f)",
            ),
            ("x](y", "x](y"),
        ];
        for (text, html) in cases {
            assert_eq!(inline(text), html);
        }
    }
}
