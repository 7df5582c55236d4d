//! What holds for certain, what slips for certain, and what lies between.

use tribos_core::contact::TimeStep;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::holding::{Stiction, StictionBounds};
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::Lcg;

const RADIUS: f64 = 0.05;
const KINETIC: f64 = 3.0;
const STATIC: f64 = 5.0;

fn set(limit: f64) -> RoundLimitSurface<f64, CoulombDisk> {
    RoundLimitSurface::new(CoulombDisk, limit, RADIUS).expect("in range")
}

fn push(rng: &mut Lcg) -> Wrench<f64> {
    let size = 7.0 * rng.unit();
    let mut part = || 2.0 * rng.unit() - 1.0;
    Wrench::new(size * part(), size * part(), size * RADIUS * part())
}

/// The largest surplus of the push over friction of one coefficient, over many motions.
fn surplus(limit: f64, push: &Wrench<f64>) -> f64 {
    let set = set(limit);
    let along = Twist {
        velocity: push.force,
        spin: 0.0,
    };
    let size = along.speed();
    let mut most = f64::NEG_INFINITY;
    for n in 0..=4000 {
        let part = std::f64::consts::FRAC_PI_2 * f64::from(n) / 4000.0;
        let (sin, cos) = part.sin_cos();
        let twist = Twist {
            velocity: push.force * (cos / size),
            spin: sin.copysign(push.torque) / RADIUS,
        };
        most = most.max(push.power(&twist) - set.support(&twist));
    }
    most
}

#[test]
fn the_answer_is_that_of_all_motions() {
    let mut rng = Lcg::new(111);
    let mut seen = [0; 3];
    for _ in 0..300 {
        let push = push(&mut rng);
        let answer = StictionBounds::of(&set(KINETIC), &set(STATIC), &push);
        let [kinetic, at_rest] = [KINETIC, STATIC].map(|limit| surplus(limit, &push));
        if kinetic.abs() < 1e-5 || at_rest.abs() < 1e-5 {
            continue;
        }
        let expected = match (kinetic < 0.0, at_rest > 0.0) {
            (true, _) => Stiction::Holds,
            (_, true) => Stiction::Slips,
            _ => Stiction::Undecided,
        };
        assert_eq!(answer.stiction, expected, "{push:?}");
        seen[expected as usize] += 1;
    }
    assert!(seen.iter().all(|n| *n > 20), "{seen:?}");
}

#[test]
fn the_scales_lead_to_the_borders() {
    let mut rng = Lcg::new(112);
    for _ in 0..100 {
        let push = push(&mut rng);
        let ask = |factor: f64| StictionBounds::of(&set(KINETIC), &set(STATIC), &(push * factor));
        let answer = ask(1.0);
        let [held, slipping] = [answer.certain_scale(), answer.possible_scale()];
        assert!((slipping / held - STATIC / KINETIC).abs() < 1e-12);
        assert_eq!(ask(held * (1.0 - 1e-9)).stiction, Stiction::Holds);
        assert_eq!(ask(held * (1.0 + 1e-9)).stiction, Stiction::Undecided);
        assert_eq!(ask(slipping * (1.0 - 1e-9)).stiction, Stiction::Undecided);
        assert_eq!(ask(slipping * (1.0 + 1e-9)).stiction, Stiction::Slips);
    }
}

#[test]
fn a_body_under_kinetic_friction_stays_where_the_answer_is_certain() {
    let mut rng = Lcg::new(113);
    let body = PlanarBody::new(0.8, 7e-4).expect("positive");
    let dt = TimeStep::new(0.01).expect("positive");
    for _ in 0..200 {
        let push = push(&mut rng);
        let holds = |limit| body.step(&set(limit), &Twist::ZERO, &push, dt).is_at_rest;
        match StictionBounds::of(&set(KINETIC), &set(STATIC), &push).stiction {
            Stiction::Holds => assert!(holds(KINETIC)),
            Stiction::Slips => assert!(!holds(STATIC)),
            Stiction::Undecided => assert!(!holds(KINETIC) && holds(STATIC)),
        }
    }
}

#[test]
fn no_push_holds_an_infinite_one_slips_and_nan_is_undecided() {
    let ask = |w: Wrench<f64>| StictionBounds::of(&set(KINETIC), &set(STATIC), &w);
    let still = ask(Wrench::ZERO);
    assert_eq!(
        (still.stiction, still.certain_scale()),
        (Stiction::Holds, f64::INFINITY)
    );
    assert_eq!(
        ask(Wrench::new(f64::INFINITY, 0.0, 0.0)).stiction,
        Stiction::Slips
    );
    assert_eq!(
        ask(Wrench::new(0.0, 0.0, f64::NAN)).stiction,
        Stiction::Undecided
    );
    // Sets in the wrong order contradict each other between them.
    let between = Wrench::new(4.0, 0.0, 0.0);
    let swapped = StictionBounds::of(&set(STATIC), &set(KINETIC), &between);
    assert_eq!(swapped.stiction, Stiction::Undecided);
    assert!(!set(KINETIC).contains(&between) && set(STATIC).contains(&between));
}
