//! The stepper against closed forms, the fixed-step method and f32 against the stepper.

use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::coulomb::CoulombHertz;
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_tests::pucks::{MU_G, RADIUS, coulomb, power, relative};
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

#[test]
fn laws_from_the_linear_one_up_never_rest_and_decay_as_equation_3_34() {
    let mut worst = Worst::of("free decay, 3.34");
    for alpha in [1.0, 1.5, 3.0] {
        let puck = power(alpha);
        assert!(puck.to_rest(&SliderState::launched(1.0, 5.0)).is_none());
        for time in [0.01, 0.3, 2.0, 10.0] {
            for speed in [0.2_f64, 1.0, 6.0] {
                let step = puck.advance(&SliderState::launched(speed, 0.0), time);
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
    let far = power(1.0)
        .advance(&SliderState::launched(1.0, 0.0), 20.0)
        .motion;
    worst.see(relative(far.distance, 1.0 / MU_G), || {
        "distance of alpha 1".into()
    });
    worst.assert_within(&tolerance::DECAY);
}

#[test]
fn falling_and_constant_laws_slide_as_equation_3_34() {
    for alpha in [-0.5, 0.0, 0.5, 0.9] {
        let puck = power(alpha);
        let rest = puck.to_rest(&SliderState::launched(2.0, 0.0)).unwrap();
        let (beta, gamma) = (1.0 - alpha, 2.0 - alpha);
        let time = 2.0_f64.powf(beta) / (beta * MU_G);
        assert!(relative(rest.motion.time, time) <= tolerance::PURE_SLIDING.limit);
        assert!(
            relative(rest.motion.distance, 2.0_f64.powf(gamma) / (gamma * MU_G))
                <= tolerance::PURE_SLIDING.limit
        );
        let half = puck
            .advance(&SliderState::launched(2.0, 0.0), 0.5 * time)
            .motion;
        assert!(relative(half.speed, 2.0 * 0.5_f64.powf(1.0 / beta)) <= tolerance::DECAY.limit);
    }
}

/// Velocity at a fixed time and time of rest by the fixed-step method.
fn verlet(dt: f64) -> ([f64; 2], f64) {
    let puck = coulomb();
    let mut motion = SliderState::launched(1.0, 5.0);
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
    let exact = coulomb()
        .advance(&SliderState::launched(1.0, 5.0), 0.2)
        .motion;
    let stop = coulomb()
        .to_rest(&SliderState::launched(1.0, 5.0))
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
        let single = Slider::new(
            CoulombDisk,
            SliderParameters {
                deceleration: MU_G as f32,
                radius: RADIUS as f32,
                inertia_ratio: inertia,
            },
        )
        .unwrap();
        let wide = Slider::new(
            CoulombDisk,
            SliderParameters {
                deceleration: f64::from(MU_G as f32),
                radius: f64::from(RADIUS as f32),
                inertia_ratio: f64::from(inertia),
            },
        )
        .unwrap();
        let got = single.to_rest(&SliderState::launched(speed, spin)).unwrap();
        let wanted = wide
            .to_rest(&SliderState::launched(f64::from(speed), f64::from(spin)))
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

/// Sees how far single precision is from double after random times from random launches.
fn see_advances<P, Q>(single: &P, double: &Q, worst: &mut Worst)
where
    P: PowerLawFriction<f32> + ReducedFriction<f32>,
    Q: PowerLawFriction<f64> + ReducedFriction<f64>,
{
    let mut rng = Lcg::new(37);
    let (mu_g, radius) = (MU_G as f32, RADIUS as f32);
    for launch in 0..4000 {
        let inertia = rng.log_between(0.01, 100.0) as f32;
        let speed = rng.log_between(0.01, 10.0);
        // Any, alike, nearly equal and far apart.
        let rim = match launch % 4 {
            0 => rng.log_between(0.01, 10.0),
            1 => speed * rng.log_between(0.1, 10.0),
            2 => speed * (1.0 + rng.between(-0.5, 0.5) * rng.log_between(1e-7, 1.0)),
            _ => speed * rng.log_between(1e-6, 1e6),
        };
        let start = SliderState::launched(speed as f32, (rim / RADIUS) as f32);
        let wide_start = SliderState::launched(f64::from(start.speed), f64::from(start.spin));
        let wide = Slider::new(
            double,
            SliderParameters {
                deceleration: f64::from(mu_g),
                radius: f64::from(radius),
                inertia_ratio: f64::from(inertia),
            },
        );
        let (narrow, wide) = (
            Slider::new(
                single,
                SliderParameters {
                    deceleration: mu_g,
                    radius,
                    inertia_ratio: inertia,
                },
            ),
            wide.unwrap(),
        );
        let scale = match wide.to_rest(&wide_start) {
            Some(rest) => rest.motion.time,
            None => speed.max(rim).powf(1.0 - double.exponent()) / MU_G,
        };
        // Steps of a controller up to nearly rest.
        let duration = (scale * rng.log_between(1e-4, 0.99)) as f32;
        let got = narrow.unwrap().advance(&start, duration).motion;
        let wanted = wide.advance(&wide_start, f64::from(duration)).motion;
        let wrench = double.reduced_wrench(wanted.speed, wanted.spin * f64::from(radius));
        let place = || format!("{start:?}, C {inertia}, {duration} s: {got:?}");
        // A dying speed is as uncertain as what is left of its time.
        let time = MU_G * f64::from(duration);
        let rim = wanted.spin * f64::from(radius) * f64::from(inertia);
        let condition = 1.0 + time * (wrench.force / wanted.speed + wrench.torque / rim);
        for (got, wanted, condition) in [
            (got.speed, wanted.speed, condition),
            (got.spin, wanted.spin, condition),
            (got.distance, wanted.distance, 1.0),
            (got.angle, wanted.angle, 1.0),
        ] {
            // Speeds that fade to nothing first leave the numbers of f32.
            if wanted > f64::from(f32::MIN_POSITIVE) && condition.is_finite() {
                let error = relative(f64::from(got), wanted) / condition;
                worst.see(error / f64::from(f32::EPSILON), place);
            }
        }
    }
}

#[test]
fn single_precision_goes_the_same_way_in_any_time() {
    let mut worst = Worst::of("f32 motion after a time against f64, over its condition");
    see_advances(&CoulombDisk, &CoulombDisk, &mut worst);
    see_advances(&CoulombHertz, &CoulombHertz, &mut worst);
    for alpha in [-0.5, 0.5, 1.0, 2.0] {
        let single = DiskTable32::new(alpha as f32).unwrap();
        let double = DiskTable64::new(alpha).unwrap();
        see_advances(&single, &double, &mut worst);
    }
    worst.assert_within(&tolerance::SINGLE_ADVANCE_ULPS);
}

#[test]
fn a_controller_s_step_costs_seven_wrenches_in_single_precision() {
    let puck = Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration: 3.0_f32,
            radius: 0.08,
            inertia_ratio: 0.5,
        },
    )
    .unwrap();
    for (duration, most) in [(1e-4, 7.5), (1e-3, 9.0)] {
        for spin in [2.0, 5.0, 12.0, 30.0] {
            let mut motion = SliderState::launched(1.0, spin);
            let (mut evaluations, mut steps) = (0, 0);
            while !motion.is_at_rest() {
                let step = puck.advance(&motion, duration);
                (motion, evaluations, steps) =
                    (step.motion, evaluations + step.evaluations, steps + 1);
            }
            let mean = f64::from(evaluations) / f64::from(steps);
            assert!(mean <= most, "{spin} rad/s, steps of {duration} s: {mean}");
        }
    }
}
