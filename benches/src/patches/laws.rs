//! The laws of the front in both precisions, and their values in f64.
//!
//! Every parameter is a binary fraction, so that f32 and f64 mean the same law. Speeds that mark a
//! law are within the range of speeds on the patch, or far below it where nature has them there.

use super::Refused;
use tribos_core::law::{
    AgeingLaw, CoulombLaw, DryFriction, LocalLaw, LuGre, LuGreParameters, PlateauPowerLaw,
    PlateauPowerLawParameters, PowerLaw, RateState, RateStateParameters, Stribeck,
    StribeckParameters,
};
use tribos_core::real::Real;

/// Exponents of the power laws of the front, with their names.
pub const POWERS: [(f64, &str); 4] = [
    (0.0, "Coulomb"),
    (0.5, "power 0.5"),
    (-0.5, "power -0.5"),
    (3.0, "power 3"),
];

/// Speed that marks the Stribeck and the LuGre law.
const STRIBECK_SPEED: f64 = 0.5;
/// Plateau and drop of the plateau law.
const PLATEAU_SPEEDS: [f64; 2] = [1.0 / 64.0, 1.0 / 65536.0];
/// Reference speed of rate and state, a micrometre a second.
const REFERENCE_SPEED: f64 = 1.0 / 1048576.0;

/// Something that is done with every law.
pub trait ForLaw<R: Real> {
    /// Does it.
    fn with<L: LocalLaw<R> + Copy + 'static>(&mut self, name: &'static str, law: L);
}

/// Power laws, then laws without closed form.
pub fn each<R: Real>(task: &mut impl ForLaw<R>) -> Result<(), Refused> {
    let real = R::from_f64;
    for (alpha, name) in POWERS {
        if alpha == 0.0 {
            task.with(name, CoulombLaw::new(R::ONE)?);
        } else {
            task.with(name, PowerLaw::new(real(alpha), R::ONE)?);
        }
    }
    let speed = real(STRIBECK_SPEED);
    let dry = DryFriction::new(real(1.5), R::ONE)?;
    task.with(
        "Stribeck",
        Stribeck::new(StribeckParameters {
            dry,
            speed,
            exponent: R::TWO,
            viscous: real(0.0625),
        })?,
    );
    let [plateau, drop] = PLATEAU_SPEEDS.map(real);
    let law = PlateauPowerLaw::new(PlateauPowerLawParameters {
        alpha: real(-0.5),
        coefficient: R::ONE,
        plateau_speed: plateau,
        drop_speed: drop,
        rest_share: R::HALF,
    })?;
    task.with("plateau", law);
    let rock = RateState::<R, AgeingLaw>::new(RateStateParameters {
        mu: real(0.625),
        a: real(0.0078125),
        b: real(0.01171875),
        reference_speed: real(REFERENCE_SPEED),
        slip_distance: real(REFERENCE_SPEED),
        viscous: R::ZERO,
    })?;
    task.with("rate-state steady", rock.steady());
    let joint = LuGre::new(LuGreParameters {
        coulomb_force: R::ONE,
        static_force: real(1.5),
        stribeck_speed: speed,
        stiffness: real(65536.0),
        bristle_damping: real(256.0),
        viscous_damping: real(0.0625),
    })?;
    task.with("LuGre steady", joint.steady_per_load(R::ONE)?);
    Ok(())
}

/// Friction over speed of one law.
pub type Friction = Box<dyn Fn(f64) -> f64>;

struct List(Vec<(&'static str, Friction)>);

impl ForLaw<f64> for List {
    fn with<L: LocalLaw<f64> + Copy + 'static>(&mut self, name: &'static str, law: L) {
        self.0
            .push((name, Box::new(move |speed| law.friction(speed))));
    }
}

/// All laws as functions in f64, for judges.
pub fn frictions() -> Result<Vec<(&'static str, Friction)>, Refused> {
    let mut list = List(Vec::new());
    each(&mut list)?;
    Ok(list.0)
}
