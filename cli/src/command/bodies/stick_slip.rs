//! Bodies that hold, let go and hold again.

use super::kind::{RunKind, told};
use super::{Commands, NoResult, at_once};
use crate::command::explain::{held as text, patience::within};
use crate::command::interrupt;
use crate::command::run::held;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::run::folder::Lock;
use tribos::stick::StickSlipScene;

/// A body that holds and slips.
pub struct StickSlipBody<'a> {
    scene: &'a dyn StickSlipScene,
    kind: &'static RunKind,
}

impl<'a> StickSlipBody<'a> {
    /// A scene and what a sweep makes of it.
    pub fn new(scene: &'a dyn StickSlipScene, kind: &'static RunKind) -> Self {
        Self { scene, kind }
    }
}

/// A body on a spring.
pub static SPRING: RunKind = RunKind {
    quantities: &[
        ("amplitude", "/amplitude"),
        ("mean_force", "/mean_force"),
        ("least_force", "/least_force"),
        ("most_force", "/most_force"),
        ("most_speed", "/most_speed"),
        ("period", "/period"),
        ("slips", "/slips"),
        ("slip_share", "/slip_share"),
        ("distance", "/distance"),
        ("work", "/work"),
        ("critical_stiffness", "/critical_stiffness"),
        ("steps", "/steps"),
    ],
    drawn: ["Amplitude of the spring force", "amplitude [N]"],
    share: ["stick_slip", "/regime", "stick-slip"],
    told: &[
        told("amplitude [N]", 0, 1.0),
        told("mean [N]", 1, 1.0),
        told("period [s]", 5, 1.0),
        told("slip share", 7, 1.0),
    ],
};

/// A block on an incline.
pub static INCLINE: RunKind = RunKind {
    quantities: &[
        ("release_angle", "/release_angle"),
        ("release_slope", "/release_slope"),
        ("release_time", "/release_time"),
        ("release_acceleration", "/release_acceleration"),
        ("distance", "/distance"),
        ("speed", "/speed"),
        ("end_angle", "/end_angle"),
    ],
    drawn: ["Angle at which the block lets go", "angle [rad]"],
    share: ["slides", "/ending", "slides"],
    told: &[
        told("angle [rad]", 0, 1.0),
        told("slope", 1, 1.0),
        told("time [s]", 2, 1.0),
    ],
};

/// A body on a turntable.
pub static TURNTABLE: RunKind = RunKind {
    quantities: &[
        ("release_rate", "/release_rate"),
        ("release_share", "/release_share"),
        ("release_time", "/release_time"),
        ("leave_time", "/leave_time"),
        ("x", "/x"),
        ("y", "/y"),
        ("speed", "/speed"),
        ("angle", "/angle"),
    ],
    drawn: ["Rate at which the body lets go", "rate [rad/s]"],
    share: ["leaves", "/ending", "leaves"],
    told: &[
        told("rate [rad/s]", 0, 1.0),
        told("omega^2 r/(mu_s g)", 1, 1.0),
        told("leaves [s]", 3, 1.0),
    ],
};

/// A body in a pinch.
pub static CLAMP: RunKind = RunKind {
    quantities: &[
        ("loss_per_cycle", "/loss_per_cycle"),
        ("heat", "/heat"),
        ("drift_per_cycle", "/drift_per_cycle"),
        ("least_position", "/least_position"),
        ("most_position", "/most_position"),
        ("release_time", "/release_time"),
    ],
    drawn: ["Heat of a cycle", "loss [J]"],
    share: ["lets_go", "/ending", "lets go"],
    told: &[
        told("loss [J]", 0, 1.0),
        told("drift [m]", 2, 1.0),
        told("release [s]", 5, 1.0),
    ],
};

impl Commands for StickSlipBody<'_> {
    fn is_long(&self) -> bool {
        false
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        held::run(self.scene, order)
    }

    fn kind(&self) -> &'static RunKind {
        self.kind
    }

    fn summarize(&self, _: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        let run = self.scene.follow(&mut |_| !interrupt::is_asked())?;
        let told = run.told.first();
        let told = told.map_or(String::new(), |(head, text)| format!("{head} {text}"));
        Ok((run.json(self.scene), told))
    }

    fn explanation(&self) -> Result<String, Failure> {
        Ok(text::lines(&self.scene.carried()))
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        at_once(out)?;
        Ok(match within(|go_on| self.scene.follow(go_on)) {
            Ok(run) => text::lines(&run?.told),
            Err(text) => text,
        })
    }
}
