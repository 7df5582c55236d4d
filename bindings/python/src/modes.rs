//! Final motion: what is left of sliding and spinning just before rest.

use crate::arrays::refused;
use crate::law::Law;
use crate::patch::Patch;
use crate::slide::{power_of, round};
use pyo3::prelude::*;
use tribos::friction::{RoundPower, leaning, upright};
use tribos_core::coupling::PowerLawFriction;
use tribos_core::modes::{Stability, TerminalMode, TerminalMotion};

/// Friction that is a power of the speed on a round patch, for final motion and launches.
#[pyclass(frozen, module = "tribos._native")]
pub struct PowerLawProfile {
    /// On an upright body.
    pub profile: Box<dyn RoundPower<f64>>,
    /// γ, in (s/m)^α.
    pub coefficient: f64,
    /// In m.
    pub radius: f64,
    patch: tribos::friction::Patch,
    alpha: f64,
}

/// c_min and c_max, ratios of the fixed points with their stability, and the name and ratio of the last
/// motion where it is known.
type Answer = (
    (f64, f64),
    Vec<(f64, &'static str)>,
    Option<(&'static str, f64)>,
);

#[pymethods]
impl PowerLawProfile {
    #[new]
    fn new(patch: &Patch, law: &Law) -> PyResult<Self> {
        let (patch, radius) = round(&patch.0)?;
        let [coefficient, alpha] = power_of(&law.0)?;
        Ok(Self {
            profile: upright(patch, alpha).map_err(refused)?,
            coefficient,
            radius,
            patch: patch.clone(),
            alpha,
        })
    }

    /// α.
    fn alpha(&self) -> f64 {
        self.alpha
    }

    /// Fixed points and last motion of a body with this I/(M R²), which leans by a part from 0 to 1.
    #[pyo3(signature = (inertia_ratio, initial_ratio=None, lean=0.0))]
    fn modes(&self, inertia_ratio: f64, initial_ratio: Option<f64>, lean: f64) -> PyResult<Answer> {
        if lean == 0.0 {
            return answer(&*self.profile, inertia_ratio, initial_ratio);
        }
        if self.alpha != 0.0 {
            return Err(refused(
                "lean is for dry friction: leave alpha out, or lean = 0",
            ));
        }
        let leaning = leaning(&self.patch, lean).map_err(refused)?;
        answer(&*leaning, inertia_ratio, initial_ratio)
    }
}

fn answer<P: PowerLawFriction<f64>>(
    profile: P,
    inertia_ratio: f64,
    initial_ratio: Option<f64>,
) -> PyResult<Answer> {
    let modes = TerminalMotion::new(profile, inertia_ratio).map_err(refused)?;
    let points = modes.fixed_points();
    let mut all = vec![(0.0, in_words(points.spinning))];
    let finite = points.finite;
    all.extend(finite.map(|(ratio, stability)| (ratio, in_words(stability))));
    all.push((f64::INFINITY, in_words(points.sliding)));
    // Without a start the end is known only where it does not depend on it.
    let depends = match points.finite {
        Some((_, stability)) => stability != Stability::Stable,
        None => points.spinning == Stability::Semistable,
    };
    let start = initial_ratio.or((!depends).then_some(1.0));
    let last = start.map(|start| match modes.terminal_mode(start) {
        TerminalMode::Spinning => ("spinning", 0.0),
        TerminalMode::Sliding => ("sliding", f64::INFINITY),
        TerminalMode::Together { ratio } => ("together", ratio),
    });
    Ok((modes.inertia_interval(), all, last))
}

/// A stability in lower case.
fn in_words(stability: Stability) -> &'static str {
    match stability {
        Stability::Stable => "stable",
        Stability::Semistable => "semistable",
        Stability::Unstable => "unstable",
    }
}
