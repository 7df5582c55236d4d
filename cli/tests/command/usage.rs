//! Scenes of fitted laws run as they are.

use crate::program::{Outcome, succeed};
use tribos::fit::{FittedLaw, Usage, UsageTarget};

type Parameters = &'static [(&'static str, f64)];

const BRISTLES: Parameters = &[
    ("fc", 1.0),
    ("fs", 1.5),
    ("vs", 0.01),
    ("s2", 0.4),
    ("s0", 1e4),
    ("s1", 31.0),
];
const ROCK: Parameters = &[
    ("mu0", 0.6),
    ("a", 0.015),
    ("b", 0.01),
    ("v0", 1e-6),
    ("dc", 1e-5),
];

/// Laws, whether friction is per load, and the line that the run begins with.
const LAWS: [(&str, Parameters, bool, &str); 12] = [
    ("coulomb", &[("mu", 0.3)], true, "steady"),
    ("viscous", &[("mu", 30.0), ("k", 2.5)], false, "steady"),
    (
        "stribeck",
        &[("mu_s", 0.4), ("mu_d", 0.2), ("vs", 0.02)],
        true,
        "stick-slip",
    ),
    ("tanh", &[("mu", 0.8), ("vt", 0.01)], true, "steady"),
    (
        "rising",
        &[("mu_s", 0.04), ("mu_f", 0.12), ("vr", 0.04)],
        true,
        "steady",
    ),
    ("power", &[("gamma", 0.3), ("alpha", 0.5)], true, "steady"),
    (
        "amontons",
        &[("mu", 0.3), ("adhesion", 1.5)],
        false,
        "steady",
    ),
    ("dahl", &[("fc", 1.5), ("s0", 1e4)], false, "steady"),
    ("lugre", BRISTLES, false, "steady"),
    (
        "lugre",
        &[("fc", 0.2), ("fs", 0.2), ("vs", 0.1)],
        true,
        "steady",
    ),
    ("rate-state", ROCK, true, "creeps"),
    ("rate-state-slip", ROCK, true, "creeps"),
];

#[test]
fn scenes_of_fitted_laws_run() -> Outcome {
    let folder = tempfile::tempdir()?;
    for (law, parameters, is_per_load, _) in LAWS {
        let fitted = FittedLaw {
            law,
            parameters,
            is_per_load,
        };
        let Usage::Text(scene) = fitted.usage(UsageTarget::Scene)? else {
            return Err(format!("{law} has no scene").into());
        };
        std::fs::write(folder.path().join("fitted.toml"), &scene)?;
        let [told, _] = succeed(folder.path(), "run fitted.toml")?;
        println!("{law}\n{scene}{told}");
    }
    Ok(())
}
