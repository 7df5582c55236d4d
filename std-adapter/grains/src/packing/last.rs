//! The report of the last step in a checkpoint: what a summary tells of it does not depend on where a run was
//! broken off.

use serde_json::{Map, Value};
use tribos_base::record::CheckpointError;
use tribos_base::record::checkpoint::{damaged, hex, numbers};
use tribos_contacts::cd::{ContactResidual, Iterations, StepReport};

/// Keys of the numbers and of the counts.
const NUMBERS: &str = "last_step";
const COUNTS: &str = "last_step_counts";

/// Adds the report of the last step to a checkpoint.
pub(super) fn put_report(report: &StepReport, map: &mut Map<String, Value>) {
    let ContactResidual {
        penetration,
        excess,
        complementarity,
        relative,
    } = report.residual;
    let numbers = [
        report.dt,
        report.overlap,
        penetration,
        excess,
        complementarity,
        relative,
    ];
    map.insert(NUMBERS.into(), hex(&numbers).into());
    let counts = [
        report.iterations.sweeps,
        usize::from(report.iterations.met),
        usize::from(report.handed_over),
        report.contacts,
        report.impacts,
        report.impact_rounds,
        usize::from(report.impacts_cut),
        report.impacts_unmet,
        report.awake,
    ];
    map.insert(COUNTS.into(), counts.to_vec().into());
}

/// Reads the report of the last step.
pub(super) fn read_report(value: &Value) -> Result<StepReport, CheckpointError> {
    let numbers = numbers(value, NUMBERS)?;
    let &[dt, overlap, penetration, excess, complementarity, relative] = numbers.as_slice() else {
        return Err(damaged(NUMBERS));
    };
    let counts = value[COUNTS].as_array().ok_or_else(|| damaged(COUNTS))?;
    let count = |count: &Value| usize::try_from(count.as_u64()?).ok();
    let counts: Option<Vec<usize>> = counts.iter().map(count).collect();
    let counts = counts.ok_or_else(|| damaged(COUNTS))?;
    let &[
        sweeps,
        met,
        handed_over,
        contacts,
        impacts,
        rounds,
        cut,
        unmet,
        awake,
    ] = counts.as_slice()
    else {
        return Err(damaged(COUNTS));
    };
    Ok(StepReport {
        dt,
        iterations: Iterations {
            sweeps,
            met: met == 1,
        },
        handed_over: handed_over == 1,
        residual: ContactResidual {
            penetration,
            excess,
            complementarity,
            relative,
        },
        contacts,
        impacts,
        impact_rounds: rounds,
        impacts_cut: cut == 1,
        impacts_unmet: unmet,
        awake,
        overlap,
    })
}
