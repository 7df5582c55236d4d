//! LuGre bristles against Runge-Kutta, their steady law, their limit and their energy.

use tribos_core::law::{Bristle, LocalLaw, LuGre, LuGreParameters};
use tribos_tests::laws;
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// The canonical parameters of the model, with a choice of static force and dampings.
fn lugre(static_force: f64, bristle_damping: f64, viscous_damping: f64) -> LuGre<f64> {
    LuGre::new(LuGreParameters {
        coulomb_force: 1.0,
        static_force,
        stribeck_speed: 1e-3,
        stiffness: 1e5,
        bristle_damping,
        viscous_damping,
    })
    .unwrap()
}

fn canonical() -> LuGre<f64> {
    lugre(1.5, 1e5_f64.sqrt(), 0.4)
}

/// z and ∫z dt after `dt` by Runge-Kutta of fourth order, with the velocity a function of time.
fn runge_kutta(law: &LuGre<f64>, z: f64, velocity: impl Fn(f64) -> f64, dt: f64) -> (f64, f64) {
    let steps = 4000;
    let h = dt / f64::from(steps);
    let rate = |z: f64, v: f64| {
        let g = 1.0 + (law.parameters().static_force - 1.0) * (-(v / 1e-3).powi(2)).exp();
        v - 1e5 * v.abs() * z / g
    };
    (0..steps).fold((z, 0.0), |(z, sum), i| {
        let t = f64::from(i) * h;
        let (v0, v1, v2) = (velocity(t), velocity(t + h / 2.0), velocity(t + h));
        let k1 = rate(z, v0);
        let k2 = rate(z + h / 2.0 * k1, v1);
        let k3 = rate(z + h / 2.0 * k2, v1);
        let k4 = rate(z + h * k3, v2);
        // Of z itself as an integrand, the same rule.
        let area = h * z + h * h / 6.0 * (k1 + k2 + k3);
        (z + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4), sum + area)
    })
}

#[test]
fn bristles_step_by_their_exact_solution() {
    let law = canonical();
    let mut rng = Lcg::new(71);
    let mut worst = Worst::of("LuGre step");
    for _ in 0..200 {
        let v = rng.log_between(1e-6, 1.0) * if rng.unit() < 0.5 { 1.0 } else { -1.0 };
        let z = rng.between(-1.5e-5, 1.5e-5);
        // Up to ten decay times, and not so short that the oracle rounds.
        let dt = rng.log_between(0.03, 10.0) * 1e-5 / v.abs();
        let (end, force) = law.step(Bristle { deflection: z }, v, dt);
        let (wanted, area) = runge_kutta(&law, z, |_| v, dt);
        let place = || format!("z = {z:e}, v = {v:e}, dt = {dt:e}");
        worst.see((end.deflection - wanted).abs() / 1e-5, place);
        // Impulse of the mean force: σ₀∫z + σ₁Δz + σ₂x.
        let damping = law.parameters().bristle_damping;
        let mean = 1e5 * area / dt + damping * (wanted - z) / dt + 0.4 * v;
        worst.see((force - mean).abs() / (1.0 + damping * v.abs()), place);
    }
    worst.assert_within(&tolerance::LAW_ODE);
}

#[test]
fn single_precision_steps_agree() {
    let (single, double) = (laws::lugre::<f32>(), laws::lugre::<f64>());
    let mut rng = Lcg::new(79);
    let mut worst = Worst::of("LuGre step in f32");
    for _ in 0..2000 {
        let v = rng.log_between(1e-6, 1.0) as f32;
        let z = rng.between(-1.5e-5, 1.5e-5) as f32;
        let dt = (rng.log_between(1e-3, 1e3) * 1e-5) as f32 / v;
        let place = || format!("z = {z:e}, v = {v:e}, dt = {dt:e}");
        let (end, force) = single.step(Bristle { deflection: z }, v, dt);
        let [v, z, dt] = [v, z, dt].map(f64::from);
        let (wanted, wanted_force) = double.step(Bristle { deflection: z }, v, dt);
        let error = f64::from(end.deflection) - wanted.deflection;
        worst.see(error.abs() / 1e-5, place);
        let error = f64::from(force) - wanted_force;
        worst.see(error.abs() / (1.0 + 316.0 * v), place);
    }
    worst.assert_within(&tolerance::STEP_SINGLE);
}

#[test]
fn bristles_follow_a_changing_velocity_to_second_order() {
    let law = canonical();
    let velocity = |t: f64| 1e-3 * (1.2 + (300.0 * t).sin());
    let start = Bristle { deflection: -1e-5 };
    for end in [0.005, 0.01, 0.02] {
        let (wanted, _) = runge_kutta(&law, start.deflection, velocity, end);
        let error = |steps: u32| {
            let dt = end / f64::from(steps);
            let last = (0..steps).fold(start, |bristle, i| {
                let middle = (f64::from(i) + 0.5) * dt;
                law.step(bristle, velocity(middle), dt).0
            });
            (last.deflection - wanted).abs()
        };
        let (coarse, fine) = (error(400), error(800));
        let order = (coarse / fine).log2();
        let place = format!("order {order} at {end} s, errors {coarse:e}, {fine:e}");
        assert!((order - 2.0).abs() < tolerance::ORDER.limit, "{place}");
    }
}

#[test]
fn bristles_stay_within_the_static_limit() {
    let law = canonical();
    let limit = law.largest_deflection() * (1.0 + 4.0 * f64::EPSILON);
    let mut rng = Lcg::new(73);
    let mut bristle = Bristle::RELAXED;
    let mut largest = 0.0_f64;
    for _ in 0..100_000 {
        let v = rng.log_between(1e-12, 1e6) * if rng.unit() < 0.5 { 1.0 } else { -1.0 };
        let (next, force) = law.step(bristle, v, rng.log_between(1e-9, 1e3));
        assert!(next.deflection.abs() <= limit && force.is_finite());
        bristle = next;
        largest = largest.max(bristle.deflection.abs());
    }
    // The limit is reached.
    assert!(largest > 0.99 * law.largest_deflection(), "{largest:e}");
}

#[test]
fn bristles_are_a_spring_before_they_slide() {
    let law = canonical();
    let v = 1e-9;
    let (bristle, _) = law.step(Bristle::RELAXED, v, 1.0);
    // Presliding stiffness σ₀, less what creeps at a share z/z_max of the way.
    let force = law.force(bristle, v);
    let share = 1e-9 / law.largest_deflection();
    assert!((force / 1e-4 - 1.0).abs() < share + 1e-2, "{force}");
    assert!((1e5 * bristle.deflection / 1e-4 - 1.0).abs() < share);
    // At rest nothing moves, however long.
    let (rested, held) = law.step(bristle, 0.0, 1e9);
    assert_eq!(rested, bristle);
    assert_eq!(held, 1e5 * bristle.deflection);
    // A tiny load that comes and goes drifts: the model's own creep, z of one sign only.
    let (back, _) = law.step(bristle, -v, 1.0);
    assert!(back.deflection.abs() < share * bristle.deflection);
}

#[test]
fn bristles_settle_on_the_steady_law() {
    let law = canonical();
    let per_load = law.steady_per_load(4.0).unwrap();
    for v in [1e-6, 1e-3, 0.1, 10.0] {
        let g = 1.0 + 0.5 * (-(v / 1e-3_f64).powi(2)).exp();
        for sign in [1.0, -1.0] {
            let settled = law.step(Bristle::RELAXED, sign * v, 1e3).0;
            let force = law.force(settled, sign * v);
            assert!(
                (force / (sign * (g + 0.4 * v)) - 1.0).abs() < 1e-11,
                "v = {v}"
            );
            assert!((law.steady_force(sign * v) / (sign * (g + 0.4 * v)) - 1.0).abs() < 1e-15);
        }
        assert!((per_load.friction(v) * 4.0 / law.steady_force(v) - 1.0).abs() < 1e-15);
    }
    let nan = law.step(Bristle::RELAXED, f64::NAN, 1.0);
    assert!(nan.0.deflection.is_nan() && nan.1.is_nan());
    let nan = law.step(
        Bristle {
            deflection: f64::NAN,
        },
        0.0,
        1.0,
    );
    assert!(nan.0.deflection.is_nan() && nan.1.is_nan());
    // No time: the force of this moment.
    let start = Bristle { deflection: 3e-6 };
    assert_eq!(law.step(start, 0.2, 0.0), (start, law.force(start, 0.2)));
    for z in special_f64() {
        for v in special_f64() {
            for dt in special_f64() {
                let (end, force) = law.step(Bristle { deflection: z }, v, dt);
                if [z, v, dt].iter().any(|x| x.is_nan()) {
                    assert!(end.deflection.is_nan() && force.is_nan());
                }
            }
        }
    }
}

/// Least dissipated power over v², F v/v² less what the bristles store, over all deflections.
fn least_dissipation(law: &LuGre<f64>, v: f64) -> f64 {
    (-1000..=1000)
        .map(|i| {
            let bristle = Bristle {
                deflection: law.largest_deflection() * f64::from(i) / 1000.0,
            };
            let stored = 1e5 * bristle.deflection * law.rate(bristle, v);
            (law.force(bristle, v) * v - stored) / (v * v)
        })
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn friction_dissipates_up_to_the_passive_speed() {
    // Little viscosity and a high static force: a bound, and beyond it power comes out.
    let active = lugre(3.0, 300.0, 0.0);
    let bound = active.passive_up_to();
    assert!((bound - 4.0 / 300.0).abs() < 1e-15);
    for factor in [0.01, 0.1, 0.5, 0.99] {
        assert!(least_dissipation(&active, factor * bound) >= 0.0);
        assert!(least_dissipation(&active, -factor * bound) >= 0.0);
    }
    assert!(least_dissipation(&active, 1.05 * bound) < 0.0);
    // σ₂ ≥ σ₁(Fₛ − F_c)/F_c: none.
    let passive = lugre(1.5, 10.0, 5.0);
    assert_eq!(passive.passive_up_to(), f64::INFINITY);
    for v in [1e-4, 1e-2, 1.0, 1e2, 1e4] {
        assert!(least_dissipation(&passive, v) >= 0.0);
    }
    let almost = lugre(1.5, 10.0, 4.9);
    assert!(almost.passive_up_to().is_finite());
    assert!(least_dissipation(&almost, 1e4) < 0.0);
    assert_eq!(lugre(1.5, 0.0, 0.0).passive_up_to(), f64::INFINITY);
}
