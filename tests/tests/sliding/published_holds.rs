//! Published cases of creep: what friction holds keeps its place to the last bit, and is let go at the
//! right load. `examples/hold.rs` follows them for ten million steps.

use tribos_core::coupling::{DryReducedFriction, coulomb::CoulombDisk};
use tribos_core::real::Real;
use tribos_tests::holds::{BREAK, cases};

const STEPS: u64 = 20_000;

fn nothing_drifts<R: Real + 'static>(close: f64)
where
    CoulombDisk: DryReducedFriction<R>,
{
    for case in cases::<R>() {
        for dt in [1e-3, 1.0 / 240.0, 1.0 / 60.0].map(R::from_f64) {
            let held = case.held(dt, STEPS);
            assert!(held.anchored, "{}", case.name);
            assert_eq!(held.drift.map(R::to_f64), [0.0, 0.0], "{}", case.name);
            // A straight pull of the force limit is a displacement of BREAK; bodies rest within some rounding
            // errors of that.
            let force = case.push.force.x.hypot(case.push.force.y).to_f64();
            let elastic = BREAK * force / case.set.force_limit().to_f64();
            let off = (held.elastic.to_f64() - elastic).abs();
            assert!(off <= close * BREAK, "{}: {off:e} m", case.name);
        }
    }
}

#[test]
fn what_friction_holds_does_not_drift_by_a_bit() {
    nothing_drifts::<f64>(1e-14);
}

#[test]
fn what_friction_holds_does_not_drift_by_a_bit_in_single_precision() {
    nothing_drifts::<f32>(1e-5);
}

#[test]
fn bonds_break_within_1e_9_of_the_load_that_friction_carries() {
    for case in cases::<f64>() {
        let right = case.margin();
        for dt in [1e-3, 1.0 / 60.0] {
            let [below, above] = [-1e-9, 1e-9].map(|off| case.is_released(right * (1.0 + off), dt));
            assert!(!below && above, "{} at steps of {dt} s", case.name);
        }
    }
}
