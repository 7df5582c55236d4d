//! Pairs of runs that differ in one mode.

use tribos::event::Tangential;
use tribos::powder::cost;
use tribos::run::PackingRunError;
use tribos::scene::{Scene, ThermostatKind, library_scene};

/// A scene of the library, and the keys that the run has of its own.
type RunKeys = (&'static str, &'static [&'static str]);

/// Two runs with the same result, of which one leaves a mode out.
#[derive(Clone, Copy, Debug)]
pub struct ModePair {
    pub body: &'static str,
    pub mode: &'static str,
    pub left_out: RunKeys,
    pub present: RunKeys,
    /// Keys of both runs.
    pub both: &'static [&'static str],
    pub has_seed: bool,
    /// Quantity of the summary that is compared.
    pub result: &'static str,
}

/// A deposit of 20 R, of about 140 spheres.
const POWDER: ModePair = ModePair {
    body: "powder",
    mode: "rolling and torsion",
    left_out: ("compaction-small", &[]),
    present: (
        "compaction-small",
        &["mu_rolling=1e-12", "mu_torsion=1e-12"],
    ),
    both: &["height=20"],
    has_seed: true,
    result: "porosity_final",
};

/// A tip of a few hundred atoms on a substrate, for 1000 steps.
const TIP: ModePair = ModePair {
    body: "tip",
    mode: "Nose-Hoover thermostat",
    left_out: ("tip-reversible", &["thermostat=\"none\""]),
    present: ("tip-reversible", &["thermostat_time=1e9"]),
    both: &[
        "substrate_columns=14",
        "substrate_rows=14",
        "tip_side_atoms=5",
        "equilibration=2",
        "drive_time=3",
        "rest_time=0",
        // The same freedoms with a thermostat and without one.
        "spin=\"counts\"",
    ],
    has_seed: true,
    result: "tip_temperature",
};

/// The tall cylinder, flat or as good as flat.
const CYLINDER: ModePair = ModePair {
    body: "cylinder",
    mode: "lean",
    left_out: ("cylinder", &["height=0"]),
    present: ("cylinder", &["height=1e-12"]),
    both: &[],
    has_seed: false,
    result: "end_time",
};

/// All pairs.
pub const PAIRS: [ModePair; 11] = [
    POWDER,
    ModePair {
        mode: "rolling",
        present: ("compaction-small", &["mu_rolling=1e-12"]),
        ..POWDER
    },
    ModePair {
        mode: "torsion",
        present: ("compaction-small", &["mu_torsion=1e-12"]),
        ..POWDER
    },
    ModePair {
        mode: "sliding",
        left_out: ("compaction-small", &["mu=0"]),
        present: ("compaction-small", &["mu=1e-12"]),
        ..POWDER
    },
    ModePair {
        body: "powder of soft spheres",
        left_out: ("compaction-soft", &[]),
        present: ("compaction-soft", &["mu_rolling=1e-12", "mu_torsion=1e-12"]),
        both: &["width=10", "height=20"],
        ..POWDER
    },
    ModePair {
        body: "gas",
        mode: "friction and spin",
        left_out: ("gas-haff", &[]),
        present: ("gas-haff", &["mu=1e-12"]),
        both: &["collisions=5", "count=1000"],
        has_seed: true,
        result: "temperature",
    },
    ModePair {
        body: "disk",
        mode: "spin",
        left_out: ("disk", &["spin=0"]),
        present: ("disk", &["spin=1e-12"]),
        both: &[],
        has_seed: false,
        result: "distance",
    },
    CYLINDER,
    ModePair {
        mode: "lean under Stribeck's law",
        both: &["law=\"stribeck:mu_s=0.4,mu_d=0.2,vs=0.05\""],
        ..CYLINDER
    },
    TIP,
    ModePair {
        mode: "Langevin thermostat",
        present: (
            "tip-reversible",
            &["thermostat=\"langevin\"", "langevin_rate=1e-12"],
        ),
        ..TIP
    },
];

impl ModePair {
    /// The run without the mode and that with it; a scene without a seed is the same every time.
    pub fn scenes(&self, seed: u64) -> Result<[Scene; 2], String> {
        let seed = self.has_seed.then(|| format!("seed={seed}"));
        let read = |(name, own): RunKeys| {
            let known = library_scene(name).ok_or(format!("no scene {name}"))?;
            let keys = self.both.iter().chain(own).map(ToString::to_string);
            let keys: Vec<String> = keys.chain(seed.clone()).collect();
            Scene::parse(name, known.text, &keys).map_err(|error| error.to_string())
        };
        Ok([read(self.left_out)?, read(self.present)?])
    }

    /// Keys that switch the mode on, without the quotes of their words.
    pub fn switch(&self) -> String {
        self.present.1.join(" ").replace('"', "")
    }
}

/// What a scene carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodySize {
    pub unknowns: usize,
    /// Bytes of a contact; none of a body without stored contacts.
    pub bytes: Option<usize>,
}

impl BodySize {
    /// Unknowns of a contact, of a sphere of a gas, of a sliding body, or of all atoms and their thermostats.
    pub fn by(scene: &Scene) -> Result<Self, PackingRunError> {
        let free = |unknowns| Self {
            unknowns,
            bytes: None,
        };
        Ok(match scene {
            Scene::Powder(scene) => {
                let cost = cost(scene)?;
                Self {
                    unknowns: cost.unknowns,
                    bytes: Some(cost.bytes),
                }
            }
            Scene::Gas(scene) => {
                let smooth = scene.impact()?.tangential() == Tangential::Smooth;
                free(if smooth { 3 } else { 6 })
            }
            Scene::Tip(scene) => {
                let baths = match scene.thermostat {
                    ThermostatKind::NoseHoover => scene.thermostat_groups(),
                    ThermostatKind::Langevin | ThermostatKind::None => 0,
                };
                free(scene.freedoms() + baths)
            }
            // On a straight path: speed and spin.
            Scene::Disk(_) => free(2),
            _ => free(3),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_has_scenes_and_contacts_carry_no_mode_that_is_left_out() {
        for pair in PAIRS {
            let carried = pair
                .scenes(1)
                .unwrap()
                .map(|scene| BodySize::by(&scene).unwrap());
            let [left_out, present] = carried;
            assert!(left_out.unknowns <= present.unknowns, "{pair:?}");
            assert!(left_out.bytes <= present.bytes, "{pair:?}");
            let is_contact = present.bytes.is_some();
            assert!(!is_contact || left_out != present, "{pair:?}");
        }
    }
}
