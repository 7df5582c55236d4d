//! The stepper against closed forms, the fixed-step method and f32 against the stepper.

use tribos_core::coupling::table::Coulomb;
use tribos_core::slider::{Motion, Slider};
use tribos_tests::pucks::{MU_G, RADIUS, coulomb, power, relative};
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

#[test]
fn laws_from_the_linear_one_up_never_rest_and_decay_as_equation_3_34() {
    let mut worst = Worst::of("free decay, 3.34");
    for alpha in [1.0, 1.5, 3.0] {
        let puck = power(alpha);
        assert!(puck.to_rest(&Motion::launched(1.0, 5.0)).is_none());
        for time in [0.01, 0.3, 2.0, 10.0] {
            for speed in [0.2_f64, 1.0, 6.0] {
                let step = puck.advance(&Motion::launched(speed, 0.0), time);
                assert!(step.rest.is_none() && step.motion.spin == 0.0);
                let wanted = if alpha == 1.0 {
                    speed * (-MU_G * time).exp()
                } else {
                    let beta = 1.0 - alpha;
                    (speed.powf(beta) - beta * MU_G * time).powf(1.0 / beta)
                };
                let place = || format!("alpha {alpha}, v0 {speed}, t {time}");
                worst.see(relative(step.motion.speed, wanted), place);
            }
        }
    }
    // Sliding under the linear law covers v0/κ in infinite time.
    let far = power(1.0).advance(&Motion::launched(1.0, 0.0), 20.0).motion;
    worst.see(relative(far.distance, 1.0 / MU_G), || {
        "distance of alpha 1".into()
    });
    worst.assert_within(&tolerance::DECAY);
}

#[test]
fn falling_and_constant_laws_slide_as_equation_3_34() {
    for alpha in [-0.5, 0.0, 0.5, 0.9] {
        let puck = power(alpha);
        let rest = puck.to_rest(&Motion::launched(2.0, 0.0)).unwrap();
        let (beta, gamma) = (1.0 - alpha, 2.0 - alpha);
        let time = 2.0_f64.powf(beta) / (beta * MU_G);
        assert!(relative(rest.motion.time, time) <= tolerance::PURE_SLIDING.limit);
        assert!(
            relative(rest.motion.distance, 2.0_f64.powf(gamma) / (gamma * MU_G))
                <= tolerance::PURE_SLIDING.limit
        );
        let half = puck.advance(&Motion::launched(2.0, 0.0), 0.5 * time).motion;
        assert!(relative(half.speed, 2.0 * 0.5_f64.powf(1.0 / beta)) <= tolerance::DECAY.limit);
    }
}

/// Velocity at a fixed time and time of rest by the fixed-step method.
fn verlet(dt: f64) -> ([f64; 2], f64) {
    let puck = coulomb();
    let mut motion = Motion::launched(1.0, 5.0);
    let mut middle = [0.0; 2];
    for n in 1.. {
        motion = puck.verlet_step(&motion, dt);
        if n == (0.2 / dt).round() as u64 {
            middle = [motion.speed, motion.spin];
        }
        if motion.is_at_rest() || n > 10_000_000 {
            break;
        }
    }
    (middle, motion.time)
}

#[test]
fn the_fixed_step_method_converges_to_the_exact_motion() {
    let exact = coulomb().advance(&Motion::launched(1.0, 5.0), 0.2).motion;
    let stop = coulomb()
        .to_rest(&Motion::launched(1.0, 5.0))
        .unwrap()
        .motion
        .time;
    let errors = [4e-3, 2e-3, 1e-3, 5e-4].map(|dt| {
        let ([speed, spin], time) = verlet(dt);
        let velocity = (speed - exact.speed).abs() + RADIUS * (spin - exact.spin).abs();
        assert!(
            (time - stop).abs() <= tolerance::VERLET_STEPS.limit * dt,
            "{dt}: {time} against {stop}"
        );
        velocity
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!(
            (order - 2.0).abs() < tolerance::ORDER.limit,
            "order {order}"
        );
    }
}

#[test]
fn single_precision_stops_at_the_same_place() {
    let mut worst = Worst::of("f32 stop against f64");
    let mut rng = Lcg::new(31);
    for _ in 0..200 {
        let (speed, spin) = (
            rng.log_between(0.01, 10.0) as f32,
            rng.log_between(0.1, 100.0) as f32,
        );
        let inertia = rng.log_between(0.01, 100.0) as f32;
        let single = Slider::new(Coulomb, MU_G as f32, RADIUS as f32, inertia).unwrap();
        let wide = Slider::new(
            Coulomb,
            f64::from(MU_G as f32),
            f64::from(RADIUS as f32),
            f64::from(inertia),
        )
        .unwrap();
        let got = single.to_rest(&Motion::launched(speed, spin)).unwrap();
        let wanted = wide
            .to_rest(&Motion::launched(f64::from(speed), f64::from(spin)))
            .unwrap();
        let place = || format!("v0 {speed}, spin {spin}, C {inertia}");
        for (got, wanted) in [
            (got.motion.time, wanted.motion.time),
            (got.motion.distance, wanted.motion.distance),
            (got.motion.angle, wanted.motion.angle),
        ] {
            worst.see(relative(f64::from(got), wanted), place);
        }
    }
    worst.assert_within(&tolerance::SINGLE_STOP);
}
