//! Collects the runs of the sweeps behind section 5.2 into the table that the exhibit reads.
//!
//! ```text
//! cargo run -p tribos-thesis --example outlook_table -- \
//!     thesis/src/exhibits/outlook/runs.csv out/a1 out/b1 out/a2 out/b2
//! ```
//!
//! The first argument is the table, all others are folders of sweeps, finished or not; runs that have not
//! ended are left out. The table's head names the sweeps.

use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::path::Path;
use tribos::record::write_atomically;
use tribos::scene::with_present_names;

/// Keys of a run's scene, then keys of its summary.
const SCENE: [&str; 6] = [
    "seed",
    "radius_spread",
    "pressure",
    "mu_rolling",
    "mu_torsion",
    "coupling",
];
const SUMMARY: [&str; 10] = [
    "ending",
    "porosity_initial",
    "porosity_final",
    "contacts",
    "steps",
    "steps_unmet",
    "iterations_total",
    "stress_zz_plus",
    "stress_zz_minus",
    "wall_seconds",
];

const HEAD: &str = "\
# Final states of compactions, for section 5.2. The first deposit at all pressures and widths:
#   SWEEP=\"tribos sweep scenes/compaction-small.toml --set blocked_criterion=piston\"
#   $SWEEP --set seed=1 --set mu_rolling=0,1 --set mu_torsion=0
#     --set pressure=0.000625,0.0025,0.01,0.04,0.16,0.64 --set radius_spread=0,0.2,0.4,0.6 --out out/a1
#   $SWEEP --set seed=1 --set mu_rolling=0,1 --set mu_torsion=1 --set coupling=independent,ellipsoid,exact
#     --set pressure=0.000625,0.0025,0.01,0.04,0.16,0.64 --set radius_spread=0,0.2,0.4,0.6 --out out/b1
# and for each seed S from 2 to 5 (the second also as the first without torsion):
#   $SWEEP --set seed=S --set mu_rolling=0,1 --set mu_torsion=0
#     --set pressure=0.0025,0.04,0.64 --set radius_spread=0,0.4 --out out/aS
#   $SWEEP --set seed=S --set mu_rolling=0,1 --set mu_torsion=1 --set coupling=independent,exact
#     --set pressure=0.0025,0.04,0.64 --set radius_spread=0,0.4 --out out/bS
# and then
#   cargo run -p tribos-thesis --example outlook_table -- thesis/src/exhibits/outlook/runs.csv out/a* out/b*
";

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let table = arguments.next().context("name the table and the sweeps")?;
    let mut lines = Vec::new();
    for sweep in arguments {
        let runs = Path::new(&sweep).join("runs");
        let entries = std::fs::read_dir(&runs).with_context(|| format!("{}", runs.display()))?;
        for entry in entries {
            lines.extend(line(&entry?.path())?);
        }
    }
    ensure!(!lines.is_empty(), "no run of these sweeps has ended");
    lines.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
    let columns = [&SCENE[..], &SUMMARY[..]].concat().join(",");
    let lines: String = lines.into_iter().map(|(_, line)| line + "\n").collect();
    write_atomically(
        Path::new(&table),
        format!("{HEAD}{columns}\n{lines}").as_bytes(),
    )?;
    Ok(())
}

/// The seed and the line of a run's folder, if the run has ended.
fn line(run: &Path) -> Result<Option<(f64, String)>> {
    let Ok(text) = std::fs::read_to_string(run.join("summary.json")) else {
        return Ok(None);
    };
    let summary: Value =
        serde_json::from_str(&text).with_context(|| format!("{} cannot be read", run.display()))?;
    let word = |value: &Value| {
        value
            .as_str()
            .map_or_else(|| value.to_string(), String::from)
    };
    let scene = with_present_names(&summary["scene"]);
    let mut words: Vec<String> = SCENE.map(|key| word(&scene[key])).to_vec();
    words.extend(SUMMARY.map(|key| word(&summary[key])));
    let seed = summary["scene"]["seed"].as_f64().unwrap_or(f64::NAN);
    Ok(Some((seed, words.join(","))))
}
