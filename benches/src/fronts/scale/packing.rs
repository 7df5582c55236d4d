//! Deposits of any size, their worlds, and the order of their spheres.

use crate::mix::Lcg;
use nalgebra::Vector3;
use tribos::cd::internals::Coefficients;
use tribos::cd::{
    ContactSolver, IterationOrder as Visits, SolverMethod, StepLimits, StopRule, Wall, World,
    WorldMaterials, WorldSetup, solid,
};
use tribos::powder::deposit::{Ballistic, Deposit, DepositTarget};
use tribos_core::contact::{Attraction, Cohesion, ContactFriction, NormalLaw};

/// Seed of the deposit and of the velocities.
const SEED: u64 = 1;
/// Capture radius of the deposit (thesis, section 4.5).
const CAPTURE: f64 = 3.0;
/// Width of the base over the cube root of the number of spheres: the deposit is about as high as wide.
const WIDTH: f64 = 4.0;
/// Range of cohesion, which itself is 1.
const RANGE: f64 = 1e-2;
/// Largest velocity component of the shaken spheres: cohesion stops some contacts of a step and not others.
const SHAKEN: f64 = 0.05;
/// Load of the piston on an area R², and its mass over that of all spheres.
const PRESSURE: f64 = 1e-2;
const PISTON: f64 = 1.0;
/// Longest step, and motion of a step.
pub const STEP: f64 = 0.2;
pub const MOTION: f64 = 0.05;

/// Numbers of the spheres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// As they fell.
    Fallen,
    /// Along Morton's curve.
    Curve,
}

impl Order {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Fallen, Self::Curve];

    /// Name in tables and pictures.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fallen => "as fallen",
            Self::Curve => "curve",
        }
    }

    /// The deposit with its spheres in this order.
    pub fn of(self, deposit: &Deposit) -> Deposit {
        match self {
            Self::Fallen => deposit.clone(),
            Self::Curve => deposit.clone().along_curve(),
        }
    }
}

/// A deposit of `count` spheres.
pub fn deposit(count: usize) -> Result<Deposit, String> {
    let ballistic = Ballistic::new(WIDTH * (count as f64).cbrt(), 1.0, CAPTURE);
    let ballistic = ballistic.map_err(|error| error.to_string())?;
    let grown = ballistic.grow(DepositTarget::Count(count), SEED);
    grown.map_err(|error| error.to_string())
}

/// A shaken deposit of cohesive spheres under a piston, whose steps take a fixed number of sweeps.
pub fn world<F>(deposit: &Deposit, friction: F, sweeps: usize) -> Result<World<F>, String>
where
    F: ContactFriction<f64> + Coefficients,
{
    let cohesive = Cohesion::new(1.0, RANGE, Attraction::Pull)
        .and_then(|cohesion| NormalLaw::new(cohesion, 0.0))
        .map_err(|error| error.to_string())?;
    // The velocity belongs to the place, not to the number: all orders have the same problem.
    let shaken = |place: &Vector3<f64>| {
        let bits = place
            .iter()
            .fold(SEED, |all, x| all.rotate_left(21) ^ x.to_bits());
        let mut random = Lcg::new(bits);
        Vector3::from_fn(|_, _| random.uniform(-SHAKEN, SHAKEN))
    };
    let mut spheres: Vec<_> = deposit.radii.iter().map(|&r| solid(r, 1.0)).collect();
    for (sphere, place) in spheres.iter_mut().zip(&deposit.positions) {
        sphere.velocity = shaken(place);
    }
    let mass: f64 = spheres.iter().map(|sphere| 1.0 / sphere.inv_mass).sum();
    let (up, load) = (Vector3::z(), PRESSURE * deposit.width * deposit.width);
    let setup = WorldSetup {
        space: deposit.space,
        spheres,
        positions: deposit.positions.clone(),
        radii: deposit.radii.clone(),
        walls: vec![
            Wall::fixed(up, 0.0),
            Wall::piston(-up, -deposit.height, PISTON * mass, load),
        ],
        step_limits: StepLimits {
            longest: STEP,
            motion: MOTION,
        },
        solver: ContactSolver {
            method: SolverMethod::GaussSeidel {
                order: Visits::Fixed,
                stop: StopRule::Fixed,
            },
            most_sweeps: sweeps,
            warm_start: 1.0,
        },
        sleep_speed: 0.0,
        ..WorldSetup::new(WorldMaterials::uniform(cohesive, friction))
    };
    World::new(setup).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_core::contact::IndependentFriction;

    #[test]
    fn all_orders_have_the_same_problem() {
        let fallen = deposit(500).unwrap();
        let contacts = Order::ALL.map(|order| {
            let mut world = world(&order.of(&fallen), IndependentFriction::none(), 1).unwrap();
            world.step().unwrap().contacts
        });
        assert_eq!(contacts[0], contacts[1]);
        assert!(contacts[0] >= 500, "{contacts:?}");
        let sorted = Order::Curve.of(&fallen);
        assert_ne!(sorted.positions, fallen.positions);
    }
}
