//! Why runs of spheres end.

use serde_json::Value;
use tribos_base::record::CheckpointError;
use tribos_base::record::checkpoint::damaged;
use tribos_base::scene::words::{Word, words};

/// Why a run of a powder, of grains or of a gas ended.
///
/// ```
/// use tribos::grains::{GrainsSimulation, GrainsStopReason};
/// use tribos::run::run_to_end;
/// # use tribos::scene::GrainsScene;
/// let scene = GrainsScene { count: 5, rest_speed: Some(1e-3), duration: 10.0, ..Default::default() };
/// let mut beads = GrainsSimulation::new(&scene)?;
/// assert_eq!(beads.ending(), None);
/// run_to_end(&mut beads, |_, _| ())?;
/// assert_eq!(beads.ending(), Some(GrainsStopReason::Rest)); // they fall and stay where they are
/// assert_eq!(GrainsStopReason::Rest.name(), "rest");
/// # Ok::<(), tribos::run::PackingRunError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PackingStopReason {
    /// The powder is blocked under its piston.
    Blocked,
    /// The grains are at rest, or no sphere of a gas will meet another one.
    Rest,
    /// The scene's number of collisions was reached.
    Collisions,
    /// Inelastic collapse of a gas: time stands still while collisions go on.
    Collapse,
    /// The scene's duration elapsed.
    Time,
    /// The scene's number of steps was reached.
    Steps,
}

words!(PackingStopReason {
    Blocked = "blocked",
    Rest = "rest",
    Collisions = "collisions",
    Collapse = "collapse",
    Time = "time",
    Steps = "steps",
});

impl PackingStopReason {
    /// Name in summaries and checkpoints.
    pub fn name(self) -> &'static str {
        Word::word(self)
    }

    /// The entry of a checkpoint: null before the end, else the name of one of the reasons for which a body ends.
    pub(crate) fn read(value: &Value, reasons: &[Self]) -> Result<Option<Self>, CheckpointError> {
        let entry = &value["ending"];
        let mut reasons = reasons.iter().copied();
        let reason = reasons.find(|reason| entry.as_str() == Some(reason.name()));
        match reason {
            None if !entry.is_null() => Err(damaged("ending")),
            reason => Ok(reason),
        }
    }
}
