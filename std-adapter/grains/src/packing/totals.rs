//! What the steps of a run add up to, beside the state of its packing.

use serde_json::{Map, Value};
use tribos_base::record::CheckpointError;
use tribos_base::record::checkpoint::{damaged, hex, one};
use tribos_contacts::cd::StepReport;

/// Totals of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Totals {
    /// Sweeps of the solver.
    pub iterations: u64,
    /// Steps in which any tolerance or rule was not met.
    pub unmet: u64,
    /// Those in which the solver missed its stopping rule.
    pub solver_unmet: u64,
    /// Steps that sweeps handed over to a solver with factorisations.
    pub handed_over: u64,
    /// Those in which the impacts were cut off.
    pub cut: u64,
    /// Those in which a part of the impacts missed its tolerance.
    pub impacts_unmet: u64,
    /// Deepest overlap, a length.
    pub overlap: f64,
    /// Wall-clock time in s, up to the last start.
    pub wall_seconds: f64,
}

impl Totals {
    /// Adds a step.
    pub fn add(&mut self, report: &StepReport) {
        self.iterations += report.iterations.sweeps as u64;
        self.unmet += u64::from(!report.is_met());
        self.solver_unmet += u64::from(!report.iterations.met);
        self.handed_over += u64::from(report.handed_over);
        self.cut += u64::from(report.impacts_cut);
        self.impacts_unmet += u64::from(report.impacts_unmet > 0);
        self.overlap = self.overlap.max(report.overlap);
    }

    /// Adds the totals to a checkpoint.
    pub fn put(&self, map: &mut Map<String, Value>) {
        map.insert("wall_seconds".into(), hex(&[self.wall_seconds]).into());
        map.insert("overlap".into(), hex(&[self.overlap]).into());
        for (name, count) in [
            ("iterations", self.iterations),
            ("unmet", self.unmet),
            ("solver_unmet", self.solver_unmet),
            ("handed_over", self.handed_over),
            ("cut", self.cut),
            ("impacts_unmet", self.impacts_unmet),
        ] {
            map.insert(name.into(), count.into());
        }
    }

    /// Reads the totals from a checkpoint.
    pub fn read(value: &Value) -> Result<Self, CheckpointError> {
        let whole = |name: &str| value[name].as_u64().ok_or_else(|| damaged(name));
        Ok(Self {
            iterations: whole("iterations")?,
            unmet: whole("unmet")?,
            solver_unmet: whole("solver_unmet")?,
            // Checkpoints of earlier versions have no such numbers.
            handed_over: value["handed_over"].as_u64().unwrap_or(0),
            overlap: one(value, "overlap").unwrap_or(0.0),
            cut: whole("cut")?,
            impacts_unmet: whole("impacts_unmet")?,
            wall_seconds: one(value, "wall_seconds")?,
        })
    }
}
