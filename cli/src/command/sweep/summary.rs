//! Summaries of runs, which carry a digest of their bytes: a table is made of what the runs left.

use serde_json::Value;
use tribos::record::digest;

/// The last member, before its digits, and what follows them.
const KEY: &str = ",\n  \"digest\": \"";
const END: &str = "\"\n}\n";

/// A summary as text, sealed by its last member.
pub fn sealed(summary: &Value) -> String {
    let text = format!("{summary:#}");
    let head = text.strip_suffix("\n}").unwrap_or(&text);
    let digits = digits(head);
    format!("{head}{KEY}{digits}{END}")
}

/// The summary of a sealed text; none if a byte of it is not as it was written.
pub fn unsealed(text: &str) -> Option<Value> {
    let (head, digits_there) = text.strip_suffix(END)?.rsplit_once(KEY)?;
    let is_whole = digits_there == digits(head);
    let mut summary: Value = is_whole.then(|| serde_json::from_str(text).ok())??;
    summary.as_object_mut()?.remove("digest");
    Some(summary)
}

fn digits(head: &str) -> String {
    format!("{:032x}", digest(head.as_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_changed_summary_is_none() {
        let summary = json!({"porosity": 0.5, "scene": {"body": "powder"}});
        let text = sealed(&summary);
        assert_eq!(unsealed(&text), Some(summary));
        assert_eq!(unsealed(&text.replace("0.5", "0.6")), None);
        assert_eq!(unsealed("{\n  \"porosity\": 0.5\n}\n"), None);
    }
}
