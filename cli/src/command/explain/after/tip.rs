//! A finished run of a tip.

use super::number;
use crate::command::explain::line;
use crate::command::explain::tip::unit;
use serde_json::Value;
use tribos::scene::TipScene;

/// What a drive needs after the tip has come to stand, in τ: a plateau and a mean.
const TO_TELL: f64 = 40.0;
/// Part of the drive that is worth sparing.
const WORTH: f64 = 0.25;

/// The account of the run with this summary.
pub fn text(scene: &TipScene, summary: &Value) -> String {
    let [tau, eps] = ["tau", "eps"].map(|of| unit(scene, of));
    let energy = |name: &str| number(summary, &format!("/drive_energy/{name}"));
    let mut text = line(
        "energy",
        format!(
            "the drive did {:.2} {eps} of work: {:.2} stored by the potential, {:.2} taken as heat by thermostats and damping; {:.2} given back after it; all but the work to +-{:.2}",
            energy("work"),
            energy("stored"),
            energy("heat"),
            energy("released"),
            energy("uncertainty")
        ),
    );
    text += &line(
        "slipped",
        format!(
            "while driven {}, for good {} (0 is the contact, k above the tip's layer k)",
            interfaces(&summary["slipped_interfaces_while_driven"]),
            interfaces(&summary["slipped_interfaces"])
        ),
    );
    text + &spare(summary, tau)
}

fn interfaces(list: &Value) -> String {
    let list = list.as_array().map(Vec::as_slice).unwrap_or_default();
    let names: Vec<String> = list.iter().map(Value::to_string).collect();
    if names.is_empty() {
        "none".into()
    } else {
        names.join(", ")
    }
}

/// A drive that goes on long after the tip stood still.
fn spare(summary: &Value, tau: &str) -> String {
    let plateaus = summary["plateaus"].as_array();
    let Some(last) = plateaus.and_then(|all| all.last()) else {
        return String::new();
    };
    let drive = number(summary, "/scene/drive_time");
    let enough = (number(last, "/from") + TO_TELL).ceil();
    let stands_to_the_end = number(last, "/to") > drive - 0.1 * TO_TELL;
    if !stands_to_the_end || enough > (1.0 - WORTH) * drive {
        return String::new();
    }
    line(
        "could go",
        format!(
            "the driven layers stayed at {:.2} degrees after {:.0} {tau}: --set drive_time={enough} shows the same",
            number(last, "/angle_degrees"),
            number(last, "/from")
        ),
    )
}
