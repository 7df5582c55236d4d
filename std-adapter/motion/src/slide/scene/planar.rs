//! What the scenes of sliding bodies have in common.

use crate::slide::planar::Gradient;
use tribos_base::scene::key::Domain;
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::words::words;
use tribos_core::patch::PowerPressure;
use tribos_friction::LARGEST_EXPONENT;

/// Fraction of its initial value below which a speed counts as rest where the motion never ends
/// (thesis, section 3.4.5).
pub(super) const STOP_FRACTION: f64 = 1e-4;
/// Exponents of the local law.
pub(super) const EXPONENT: Domain = Domain::Between {
    above: -1.0,
    up_to: LARGEST_EXPONENT,
};

/// What happens where a body would tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tipping {
    /// The run is refused.
    Refuse,
    /// The pressure gradient is held at its limit.
    Clamp,
}
words!(Tipping { Refuse = "refuse", Clamp = "clamp" });

/// Pressure under a cylinder at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FootPressure {
    /// The same everywhere.
    Uniform,
    /// All load on the rim.
    Ring,
    /// 1/√(1 − r²), under a rigid punch on an elastic floor.
    FlatPunch,
    /// √(1 − r²), Hertz' pressure.
    Hertz,
    /// 1 − r².
    Paraboloid,
}
words!(FootPressure {
    Uniform = "uniform",
    Ring = "ring",
    FlatPunch = "flat-punch",
    Hertz = "hertz",
    Paraboloid = "paraboloid",
});

impl FootPressure {
    /// The kernel's pressure of this name.
    pub fn pressure(self) -> PowerPressure {
        match self {
            Self::Uniform => PowerPressure::UNIFORM,
            Self::Ring => PowerPressure::RING,
            Self::FlatPunch => PowerPressure::FLAT_PUNCH,
            Self::Hertz => PowerPressure::HERTZ,
            Self::Paraboloid => PowerPressure::PARABOLOID,
        }
    }
}

words!(Gradient { AllRound = "all-round", FrontBack = "front-back" });

/// A body that neither slides nor spins has no scene.
pub(super) fn moves(speed: f64, spin: f64, judge: &mut SceneDiagnostics<'_>) {
    if speed == 0.0 && spin == 0.0 {
        let message = "nothing moves: give `speed` or `spin` a value other than 0";
        judge.refuse(&["speed", "spin"], message);
    }
}

/// Whether a key is a parameter of the power law, which another law takes the place of.
pub(super) fn is_of_power_law(key: &str) -> bool {
    key == "gamma" || key == "alpha"
}
