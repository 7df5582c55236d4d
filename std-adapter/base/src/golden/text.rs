//! A golden file as text: the same bytes for the same results.

use super::quantity::{Quantity, hex};
use super::{FORMAT, Golden, Pinned};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Digests a line.
const PER_LINE: usize = 4;

impl Golden {
    /// The file.
    pub fn text(&self) -> String {
        let mut text = format!(
            "# What scenes computed, to the bit. Made by `tribos golden write`, checked by\n\
             # `tribos golden verify`. Numbers are the bits of their f64; comments show their values.\n\
             format = {FORMAT}\n\
             written_by = \"tribos {}\"\n",
            env!("CARGO_PKG_VERSION")
        );
        for scene in &self.scenes {
            text += &scene.text();
        }
        text
    }
}

impl Pinned {
    fn text(&self) -> String {
        let overrides: Vec<String> = self.overrides.iter().map(|item| quoted(item)).collect();
        let mut text = format!(
            "\n[[scene]]\npath = {}\nset = [{}]\nscene_digest = \"{}\"\nrows = {}\nblock_rows = {}\n",
            quoted(&self.path),
            overrides.join(", "),
            hex(self.scene_digest()),
            self.rows,
            self.block_rows,
        );
        text += &quantities("parameters", &self.parameters);
        text += &quantities("summary", &self.summary);
        text += "\n[scene.series]\n";
        for (name, digests) in &self.columns {
            text += &column(name, digests);
        }
        if !self.state.is_empty() {
            text += "\n[scene.state]\n";
            for (name, digest) in &self.state {
                // Writing to a String cannot fail.
                let _ = writeln!(text, "{} = \"{}\"", quoted(name), hex(*digest));
            }
        }
        text
    }
}

fn quantities(table: &str, all: &BTreeMap<String, Quantity>) -> String {
    let mut text = format!("\n[scene.{table}]\n");
    for (name, quantity) in all {
        let value = match quantity {
            Quantity::Number(value) => format!(" # {value:?}"),
            Quantity::Text(_) => String::new(),
        };
        let spelled = quoted(&quantity.spelled());
        let _ = writeln!(text, "{} = {spelled}{value}", quoted(name));
    }
    text
}

fn column(name: &str, digests: &[u64]) -> String {
    let mut text = format!("{} = [\n", quoted(name));
    for line in digests.chunks(PER_LINE) {
        let line: Vec<String> = line.iter().map(|&bits| quoted(&hex(bits))).collect();
        let _ = writeln!(text, "  {},", line.join(", "));
    }
    text + "]\n"
}

/// A TOML string: JSON's escapes are TOML's, which has one more character to escape.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text)
        .to_string()
        .replace('\u{7f}', "\\u007f")
}
