//! Laws with a state: rate-and-state friction and LuGre bristles against extended precision,
//! Runge-Kutta and what theory says of their stability.

use tribos_core::law::{
    Bristle, ContactAge, Dieterich, Evolution, LocalLaw, LuGre, LuGreParameters, RateState,
    RateStateParameters, Ruina, SteadyRateState,
};
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const SLIP_DISTANCE: f64 = 1e-5;
const ROCK: RateStateParameters<f64> = RateStateParameters {
    mu: 0.6,
    a: 0.01,
    b: 0.015,
    reference_speed: 1e-6,
    slip_distance: SLIP_DISTANCE,
    viscous: 2.0,
};

fn rock<E: Evolution>() -> RateState<f64, E> {
    RateState::new(ROCK).unwrap()
}

fn age(theta: f64) -> ContactAge<f64> {
    ContactAge { theta }
}

#[test]
fn rate_and_state_keeps_its_formula() {
    // V, θ, μ and ∂μ/∂V of the regularised law in 40 digits, above and below the transition.
    let exact = [
        (1e-6, 10.0, 0.6000019999999999, 10002.0),
        (1e-3, 0.01, 0.5674612236050893, 12.0),
        (1e-33, 1e3, 0.047380344358062154, 9.998466823052081e30),
        (1e-30, 1.0, 0.013531921056797524, 8.748046244687522e27),
        (1e-32, 0.01, 1.805672228182543e-07, 1.8056722279862993e25),
        (10.0, 1e-6, 20.51940952174521, 2.001),
        (1e-31, 1e3, 0.09343127961798639, 9.999999846647042e28),
        (1e-30, 1e4, 0.15099590686616182, 9.999999999998467e27),
        (10.0, 1e6, 20.933874838484137, 2.001),
    ];
    let mut worst = Worst::of("rate-and-state friction");
    let single = RateState::<f32, Ruina>::new(RateStateParameters {
        mu: 0.6,
        a: 0.01,
        b: 0.015,
        reference_speed: 1e-6,
        slip_distance: 1e-5,
        viscous: 2.0,
    })
    .unwrap();
    for (v, theta, mu, slope) in exact {
        let law = rock::<Dieterich>();
        let place = || format!("V = {v:e}, theta = {theta:e}");
        worst.see((law.coefficient(v, age(theta)) / mu - 1.0).abs(), place);
        worst.see((law.slope(v, age(theta)) / slope - 1.0).abs(), place);
        // Far from the transition the logarithm is the same.
        let log = law.logarithmic(v, age(theta));
        assert!((log - mu).abs() < 1e-14 || v <= 1e-30);
        // The last exponent overflows f32; the law does not.
        let theta = ContactAge {
            theta: theta as f32,
        };
        let got = f64::from(single.coefficient(v as f32, theta));
        assert!((got / mu - 1.0).abs() < 3e-5, "f32: {got} for {mu}");
    }
    worst.assert_within(&tolerance::LAW);
}

#[test]
fn rate_and_state_vanishes_at_rest_and_passes_nan_on() {
    let law = rock::<Ruina>();
    assert_eq!(law.coefficient(0.0, age(10.0)), 0.0);
    assert!(law.slope(0.0, age(10.0)).is_finite());
    assert_eq!(law.logarithmic(0.0, age(10.0)), f64::NEG_INFINITY);
    assert_eq!(law.coefficient(1e-6, age(0.0)), 2e-6);
    assert!(law.coefficient(f64::NAN, age(1.0)).is_nan());
    assert!(law.coefficient(1.0, age(f64::NAN)).is_nan());
    for v in special_f64() {
        for theta in special_f64() {
            let _ = law.coefficient(v, age(theta));
            for dt in special_f64() {
                let ageing = rock::<Dieterich>().advance(age(theta), v, dt).theta;
                let slip = law.advance(age(theta), v, dt).theta;
                if [v, theta, dt].iter().any(|x| x.is_nan()) {
                    assert!(
                        ageing.is_nan() && slip.is_nan(),
                        "({theta:e}, {v:e}, {dt:e})"
                    );
                }
            }
        }
    }
}

#[test]
fn ages_evolve_by_their_exact_solution() {
    // V, θ, dt; ageing law, slip law in 40 digits.
    let exact = [
        (1e-6, 3.0, 2.0, 4.268884728454127, 3.7316687968528224),
        (1e-4, 3.0, 0.01, 2.7240285123042827, 2.1704739721761883),
        (1e-4, 3.0, 5.0, 0.1, 0.1),
        (1e-9, 100.0, 1.0, 100.98995050164996, 100.04606000371513),
    ];
    let mut worst = Worst::of("age after a step");
    for (v, theta, dt, ageing, slip) in exact {
        let place = || format!("V = {v:e}, dt = {dt}");
        let got = rock::<Dieterich>().advance(age(theta), v, dt).theta;
        worst.see((got / ageing - 1.0).abs(), place);
        let got = rock::<Ruina>().advance(age(theta), v, dt).theta;
        worst.see((got / slip - 1.0).abs(), place);
    }
    worst.assert_within(&tolerance::AGE);
    // At rest one law ages and the other waits; from nothing likewise.
    assert_eq!(rock::<Dieterich>().advance(age(3.0), 0.0, 2.0).theta, 5.0);
    assert_eq!(rock::<Ruina>().advance(age(3.0), 0.0, 2.0).theta, 3.0);
    assert_eq!(rock::<Ruina>().advance(age(0.0), 1e-6, 2.0).theta, 0.0);
    for v in [1e-320, 1e-300, 1e-30] {
        assert_eq!(rock::<Dieterich>().advance(age(3.0), v, 2.0).theta, 5.0);
    }
}

/// The age after `dt` in one step against the age after `parts` steps.
fn see_parts<E: Evolution>(worst: &mut Worst, name: &str) {
    let mut rng = Lcg::new(61);
    for _ in 0..500 {
        let (v, theta) = (rng.log_between(1e-9, 1.0), rng.log_between(1e-6, 1e6));
        // Up to ten times the memory length.
        let (dt, parts) = (rng.log_between(1e-3, 10.0) * SLIP_DISTANCE / v, 64);
        let once = rock::<E>().advance(age(theta), v, dt).theta;
        let many = (0..parts).fold(age(theta), |age, _| {
            rock::<E>().advance(age, v, dt / f64::from(parts))
        });
        let place = || format!("{name}, V = {v:e}, theta = {theta:e}, dt = {dt:e}");
        worst.see((many.theta / once - 1.0).abs(), place);
    }
}

#[test]
fn ages_do_not_depend_on_the_step() {
    let mut worst = Worst::of("age in parts of a step");
    see_parts::<Dieterich>(&mut worst, "ageing law");
    see_parts::<Ruina>(&mut worst, "slip law");
    worst.assert_within(&tolerance::PARTS_OF_A_STEP);
}

#[test]
fn steady_sliding_is_where_the_age_rests() {
    let mut rng = Lcg::new(67);
    let mut worst = Worst::of("steady rate-and-state friction");
    for _ in 0..500 {
        let (v, theta) = (rng.log_between(1e-9, 1.0), rng.log_between(1e-6, 1e6));
        let long = 60.0 * SLIP_DISTANCE / v;
        let steady = rock::<Dieterich>().steady().friction(v);
        for end in [
            rock::<Dieterich>().advance(age(theta), v, long),
            rock::<Ruina>().advance(age(theta), v, long),
            rock::<Ruina>().steady_age(v),
        ] {
            let error = (rock::<Ruina>().coefficient(v, end) / steady - 1.0).abs();
            worst.see(error, || format!("V = {v:e}, theta = {theta:e}"));
        }
    }
    worst.assert_within(&tolerance::LAW);
}

fn steady(mu: f64, viscous: f64) -> SteadyRateState<f64> {
    let parameters = RateStateParameters {
        mu,
        viscous,
        ..ROCK
    };
    RateState::<f64, Dieterich>::new(parameters)
        .unwrap()
        .steady()
}

#[test]
fn friction_weakens_up_to_the_minimum_and_strengthens_beyond() {
    for viscous in [0.2, 2.0, 2e3] {
        // Large μ₀: the regularisation is out of sight and the minimum (b − a)/η.
        let law = steady(0.6, viscous);
        let slowest = law.minimum().unwrap();
        assert!((slowest * viscous / 0.005 - 1.0).abs() < 1e-12);
        // Small μ₀: it is in sight, and the minimum lower.
        let soft = steady(0.03, viscous);
        let lowest = soft.minimum().unwrap();
        assert!(lowest * viscous < 0.005 * (1.0 - 1e-6));
        for (law, v) in [(law, slowest), (soft, lowest)] {
            assert!(law.slope(0.999 * v) < 0.0 && law.slope(1.001 * v) > 0.0);
            assert!(law.friction(0.9 * v) > law.friction(v));
            assert!(law.friction(1.1 * v) > law.friction(v));
        }
    }
    assert_eq!(steady(0.6, 0.0).minimum(), None);
    // Three decades of weakening, b − a per e-fold (fig. 2.7).
    let fall = steady(0.6, 0.0).friction(1e-7) - steady(0.6, 0.0).friction(1e-4);
    assert!((fall - 0.005 * 1e3_f64.ln()).abs() < 1e-14);
}

/// Growth of a small disturbance of steady sliding at `v` by a spring of `stiffness` without
/// mass, per unit load: ratio of the largest |ln(V/v)| late and early.
fn growth_of_disturbance<E: Evolution>(stiffness: f64, v: f64) -> f64 {
    let law = rock::<E>();
    let (mut state, mut sliding) = (law.steady_age(v), 1.01 * v);
    let mut spring = law.coefficient(sliding, state);
    let dt = 1e-3 * SLIP_DISTANCE / v;
    let (mut early, mut late) = (0.0_f64, 0.0_f64);
    let steps = 200_000;
    for i in 0..steps {
        // Midpoint rule: age by exact steps, spring by its balance, speed from the friction law.
        let middle_age = law.advance(state, sliding, dt / 2.0);
        let middle_spring = spring + stiffness * (v - sliding) * dt / 2.0;
        let middle = speed_of(&law, middle_spring, middle_age, sliding);
        state = law.advance(state, middle, dt);
        spring += stiffness * (v - middle) * dt;
        sliding = speed_of(&law, spring, state, middle);
        let size = (sliding / v).ln().abs();
        if i < steps / 4 {
            early = early.max(size);
        } else if i >= steps - steps / 4 {
            late = late.max(size);
        }
        if size > 1.0 {
            return f64::INFINITY;
        }
    }
    late / early
}

/// The speed with which the law resists as much as the spring pulls, by Newton's method.
fn speed_of<E: Evolution>(
    law: &RateState<f64, E>,
    spring: f64,
    state: ContactAge<f64>,
    guess: f64,
) -> f64 {
    (0..4).fold(guess, |v, _| {
        v - (law.coefficient(v, state) - spring) / law.slope(v, state)
    })
}

#[test]
fn a_spring_pulls_steadily_above_the_critical_stiffness_only() {
    let law = rock::<Dieterich>().steady();
    // Slow, where k_c = N(b − a)/D_c, and halfway to the minimum, where viscosity halves it.
    for (v, share) in [(1e-8, 1.0), (1.25e-3, 0.5)] {
        let critical = law.critical_stiffness_at(1.0, v);
        let wanted = share * law.critical_stiffness(1.0);
        assert!((critical / wanted - 1.0).abs() < 1e-5);
        for (factor, stable) in [(1.03, true), (0.97, false)] {
            let ageing = growth_of_disturbance::<Dieterich>(factor * critical, v);
            let slip = growth_of_disturbance::<Ruina>(factor * critical, v);
            assert_eq!(ageing < 1.0, stable, "V = {v:e}, {factor} k_c: {ageing}");
            assert_eq!(slip < 1.0, stable, "V = {v:e}, {factor} k_c: {slip}");
        }
    }
    assert!(law.critical_stiffness_at(1.0, 1.0) < 0.0);
}

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
    let single = LuGre::new(LuGreParameters {
        coulomb_force: 1.0_f32,
        static_force: 1.5,
        stribeck_speed: 1e-3,
        stiffness: 1e5,
        bristle_damping: 316.0,
        viscous_damping: 0.4,
    })
    .unwrap();
    let double = lugre(1.5, 316.0, 0.4);
    let rock_single = RateState::<f32, Dieterich>::new(RateStateParameters {
        mu: 0.6,
        a: 0.01,
        b: 0.015,
        reference_speed: 1e-6,
        slip_distance: 1e-5,
        viscous: 2.0,
    })
    .unwrap();
    let mut rng = Lcg::new(79);
    let mut worst = Worst::of("steps of laws with memory in f32");
    for _ in 0..2000 {
        let v = rng.log_between(1e-6, 1.0) as f32;
        let z = rng.between(-1.5e-5, 1.5e-5) as f32;
        let dt = (rng.log_between(1e-3, 1e3) * 1e-5) as f32 / v;
        let place = || format!("z or theta = {z:e}, v = {v:e}, dt = {dt:e}");
        let (end, force) = single.step(Bristle { deflection: z }, v, dt);
        let [v64, z64, dt64] = [v, z, dt].map(f64::from);
        let (wanted, wanted_force) = double.step(Bristle { deflection: z64 }, v64, dt64);
        let error = f64::from(end.deflection) - wanted.deflection;
        worst.see(error.abs() / 1e-5, place);
        let error = f64::from(force) - wanted_force;
        worst.see(error.abs() / (1.0 + 316.0 * v64), place);
        let theta = z.abs() * 1e6;
        let got = rock_single.advance(ContactAge { theta }, v, dt).theta;
        let wanted = rock::<Dieterich>().advance(age(f64::from(theta)), v64, dt64);
        worst.see((f64::from(got) / wanted.theta - 1.0).abs(), place);
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
