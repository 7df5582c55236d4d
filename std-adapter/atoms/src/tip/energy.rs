//! Where the work of the drive went.

use serde_json::{Value, json};
use tribos_base::record::json_number;

/// Where the drive's energy went, in ε; NaN where a stage is missing.
///
/// ```
/// use tribos::tip::DriveEnergy;
/// let energy = DriveEnergy { work: 10.0, stored: 4.0, released: 3.5, uncertainty: 0.5 };
/// assert_eq!(energy.heat(), 6.0); // taken by thermostats and damping while driven
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriveEnergy {
    /// Work of the drive: its force on each driven atom times the atom's displacement, summed over all steps.
    pub work: f64,
    /// Rise of the potential energy while driven, between means over 20 τ at the ends of stages.
    /// Pairs that cross a cut-off without shift change it without work.
    pub stored: f64,
    /// Fall of the potential energy after the drive.
    pub released: f64,
    /// Standard error of `stored`, from the scatter of lines 0.5 τ apart, treated as independent.
    pub uncertainty: f64,
}

impl DriveEnergy {
    /// Heat absorbed by thermostats and damping while driven: the work that was not stored.
    pub fn heat(&self) -> f64 {
        self.work - self.stored
    }

    /// As JSON.
    pub(super) fn json(&self) -> Value {
        json!({
            "work": json_number(self.work),
            "stored": json_number(self.stored),
            "heat": json_number(self.heat()),
            "released": json_number(self.released),
            "uncertainty": json_number(self.uncertainty),
        })
    }
}
