//! `tribos laws`: what laws there are, and curves of the local ones.

mod curve;

use crate::command::suggestions::unknown;
use crate::failure::Failure;
use serde_json::{Value, json};
use std::path::PathBuf;
use tribos::friction::{LAWS, Law, LawEntry, find};

/// List the friction laws with formula, parameters, units and source, or draw a local one.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Names of laws to show; all if left out.
    names: Vec<String>,
    /// Output format.
    #[arg(long, default_value = "text")]
    format: Format,
    /// Draw this local law over speed; may be repeated.
    #[arg(long, value_name = "NAME:KEY=VALUE,…", requires = "out")]
    curve: Vec<Law>,
    /// Slowest speed of the curve [m/s].
    #[arg(long, default_value = "1e-6", value_parser = super::number::positive)]
    from: f64,
    /// Fastest speed of the curve [m/s].
    #[arg(long, default_value = "10", value_parser = super::number::positive)]
    to: f64,
    /// File for the curve: FILE.svg, FILE.png or FILE.csv.
    #[arg(long, value_name = "FILE", requires = "curve")]
    out: Option<PathBuf>,
}

/// Format of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    Text,
    Json,
}

const EXAMPLES: &str = "\
Examples:
  tribos laws
  tribos laws stribeck lugre --format json
  tribos laws --curve stribeck:mu_s=0.15,mu_d=0.1,vs=0.01,k=0.5 --from 1e-4 --to 1 --out stribeck.svg
Local laws couple with any contact:
  tribos wrench --law stribeck:mu_s=0.15,mu_d=0.1,vs=0.01 --patch hertz --radius 0.01 --speed 0.1 --spin 5";

impl Arguments {
    /// Lists, or draws.
    pub fn execute(self) -> Result<(), Failure> {
        if let Some(path) = &self.out {
            curve::write(path, &self.curve, [self.from, self.to])?;
            return super::print(&format!("written to    {}\n", path.display()));
        }
        let chosen = chosen(&self.names)?;
        let text = match self.format {
            Format::Text => chosen
                .iter()
                .map(|law| text(law))
                .collect::<Vec<_>>()
                .join("\n"),
            Format::Json => {
                let list: Vec<Value> = chosen.iter().map(|law| json(law)).collect();
                format!("{:#}\n", Value::Array(list))
            }
        };
        super::print(&text)
    }
}

fn chosen(names: &[String]) -> Result<Vec<&'static LawEntry>, Failure> {
    if names.is_empty() {
        return Ok(LAWS.iter().collect());
    }
    let known = |name: &String| {
        find(name).ok_or_else(|| {
            let all = LAWS.iter().map(|law| law.name);
            Failure::input(unknown(&format!("unknown law `{name}`"), name, all))
        })
    };
    names.iter().map(known).collect()
}

fn text(law: &LawEntry) -> String {
    let local = if law.local.is_some() { " (local)" } else { "" };
    let mut text = format!(
        "{}{local}\n  {}\n  {}\n",
        law.name, law.summary, law.formula
    );
    for parameter in law.parameters {
        let default = parameter
            .default
            .map_or(String::new(), |value| format!(" (default {value})"));
        text += &format!(
            "    {:<8} [{}] {}{default}\n",
            parameter.name, parameter.unit, parameter.meaning
        );
    }
    text + &format!("  source: {}\n", law.source)
}

fn json(law: &LawEntry) -> Value {
    let parameters: Vec<Value> = law
        .parameters
        .iter()
        .map(
            |p| json!({"name": p.name, "unit": p.unit, "meaning": p.meaning, "default": p.default}),
        )
        .collect();
    json!({
        "name": law.name,
        "summary": law.summary,
        "formula": law.formula,
        "parameters": parameters,
        "source": law.source,
        "local": law.local.is_some(),
    })
}
