//! What runs of powders and grains leave alike.

use super::long::{Export, write_state};
use super::request::RunRequest;
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::powder::{Dissipation, PackingEnergy};
use tribos::record::{Snapshot, contacts_vtp, extended_xyz, particles_vtp};
use tribos::results::Summary;
use tribos::run::folder::OutputFolder;

/// Endings of the names of a state's files, and what they hold.
const EXPORTS: [(&str, Export); 3] = [
    (".xyz", extended_xyz),
    (".vtp", particles_vtp),
    ("-contacts.vtp", contacts_vtp),
];

/// The states at both ends in all formats.
pub fn states(
    first: &Snapshot<'_>,
    last: &Snapshot<'_>,
    (folder, order): (&OutputFolder, &RunRequest<'_>),
) -> Result<(), Failure> {
    write_state(first, ("initial", &EXPORTS), folder, order)?;
    write_state(last, ("final", &EXPORTS), folder, order)
}

/// Where the work went; `unit` follows the energies.
pub fn budget(energy: &PackingEnergy, losses: &Dissipation, unit: &str) -> String {
    let work = energy.work;
    let mut text = format!("work          {}{unit}, of which\n", shown(work));
    for (name, lost) in losses.entries() {
        let lost = lost.as_f64().unwrap_or(f64::NAN);
        let percent = 100.0 * lost / work;
        // No work, no share of it.
        let share = if percent.is_finite() {
            format!(" ({percent:.1} %)")
        } else {
            String::new()
        };
        text += &format!("  {name:<11} {}{share}\n", shown(lost));
    }
    if let Some(elastic) = energy.elastic.filter(|elastic| *elastic != 0.0) {
        text += &format!("  elastic     {}\n", shown(elastic));
    }
    text + &format!("  imbalance   {:.1e}\n", energy.imbalance)
}
