//! Bits of wrenches in the plane, of tall bodies and of whole motions.

use crate::ARGUMENTS;
use crate::hash::Fnv;
use crate::inputs::{Lcg, speed};
use tribos_core::coupling::closed::CoulombHertz;
use tribos_core::coupling::load_transfer::{
    FullGradient, LoadTransferFriction, LongitudinalGradient, PressureGradient,
};
use tribos_core::coupling::table::{self, DiskTable64};
use tribos_core::coupling::{LateralFriction, ReducedFriction, RoundFriction};
use tribos_core::real::Real;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_core::twist::Twist;

/// Hash of wrenches and their Jacobians in the plane.
pub fn wrenches() -> u64 {
    let mut hash = Fnv::new();
    let puck = RoundFriction::new(table::CoulombDisk, 0.3, 0.04).expect("a coefficient");
    let mut rng = Lcg::new(11);
    for _ in 0..ARGUMENTS {
        let [x, y, spin] = [(); 3].map(|()| speed::<f64>(&mut rng) - speed::<f64>(&mut rng));
        let twist = Twist::new(x, y, spin);
        let wrench = puck.wrench(1.7, &twist);
        for v in [wrench.force.x, wrench.force.y, wrench.torque] {
            hash.number(v);
        }
        for &v in puck.wrench_jacobian(1.7, &twist).iter() {
            hash.number(v);
        }
    }
    hash.0
}

/// Hash of the wrenches of tall bodies, upright to tipping.
pub fn tall() -> u64 {
    let mut hash = Fnv::new();
    for height in [0.0, 0.04, 0.16, 0.5] {
        leaning::<f64, _, FullGradient>(&mut hash, table::CoulombDisk, height);
        leaning::<f64, _, LongitudinalGradient>(&mut hash, CoulombHertz, height);
        leaning::<f32, _, FullGradient>(&mut hash, table::CoulombDisk, height);
        let power = DiskTable64::new(0.5).expect("in range");
        leaning::<f64, _, FullGradient>(&mut hash, power, height);
    }
    hash.0
}

fn leaning<R: Real, C: LateralFriction<R>, L: PressureGradient>(
    hash: &mut Fnv,
    coupling: C,
    height: f64,
) {
    let [coefficient, radius] = [0.25, 0.0625].map(R::from_f64);
    let foot = RoundFriction::new(coupling, coefficient, radius).expect("in range");
    let body = LoadTransferFriction::<R, C, L>::new(foot, R::from_f64(height)).expect("in range");
    let mut rng = Lcg::new(29);
    for _ in 0..ARGUMENTS / 4 {
        let [x, y, spin] = [(); 3].map(|()| speed::<R>(&mut rng) - speed::<R>(&mut rng));
        let got = body.wrench(R::from_f64(1.7), &Twist::new(x, y, spin));
        for v in [
            got.wrench.force.x,
            got.wrench.force.y,
            got.wrench.torque,
            got.lean.x,
            got.lean.y,
        ] {
            hash.number(v);
        }
        hash.feed(u64::from(got.whole().is_ok()));
    }
}

/// Hash of whole motions: 200 steps and the rest, f64 and f32, α = 0 and 1/2.
pub fn sliders() -> u64 {
    let mut hash = Fnv::new();
    motion(&mut hash, table::CoulombDisk, 1.0_f64, 5.0);
    motion(&mut hash, table::CoulombDisk, 1.0_f32, 5.0);
    motion(
        &mut hash,
        DiskTable64::new(0.5).expect("in range"),
        1.0,
        -20.0,
    );
    hash.0
}

fn motion<R, P>(hash: &mut Fnv, profile: P, speed: R, spin: R)
where
    R: Real,
    P: tribos_core::coupling::PowerLawFriction<R> + ReducedFriction<R>,
{
    let radius = R::from_f64(0.08);
    let puck = Slider::new(
        profile,
        SliderParameters {
            deceleration: R::from_f64(2.943),
            radius,
            inertia_ratio: R::HALF,
        },
    )
    .expect("in range");
    let mut state = SliderState::launched(speed, spin);
    let mut fixed = state;
    for _ in 0..200 {
        state = puck.advance(&state, R::from_f64(1.0 / 512.0)).motion;
        fixed = puck.verlet_step(&fixed, R::from_f64(1.0 / 512.0));
        for m in [state, fixed] {
            for x in [m.time, m.speed, m.spin, m.distance, m.angle] {
                hash.number(x);
            }
        }
    }
    let rest = puck.to_rest(&SliderState::launched(speed, spin));
    let rest = rest.expect("an exponent below one");
    for x in [
        rest.motion.time,
        rest.motion.distance,
        rest.motion.angle,
        rest.ratio,
    ] {
        hash.number(x);
    }
    hash.feed(u64::from(rest.evaluations));
}
