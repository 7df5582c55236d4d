//! Rate-and-state friction against extended precision, and what theory says of its stability.

use tribos_core::law::{
    AgeingLaw, LocalLaw, RateState, RateStateParameters, SlipLaw, StateEvolution, StateVariable,
    SteadyRateState,
};
use tribos_tests::laws;
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

fn rock<E: StateEvolution>() -> RateState<f64, E> {
    RateState::new(ROCK).unwrap()
}

fn age(theta: f64) -> StateVariable<f64> {
    StateVariable { theta }
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
    let single = laws::rate_state::<f32>(0.01, 0.015, 2.0);
    for (v, theta, mu, slope) in exact {
        let law = rock::<AgeingLaw>();
        let place = || format!("V = {v:e}, theta = {theta:e}");
        worst.see((law.coefficient(v, age(theta)) / mu - 1.0).abs(), place);
        worst.see((law.slope(v, age(theta)) / slope - 1.0).abs(), place);
        // Far from the transition the logarithm is the same.
        let log = law.logarithmic(v, age(theta));
        assert!((log - mu).abs() < 1e-14 || v <= 1e-30);
        // The last exponent overflows f32; the law does not.
        let theta = StateVariable {
            theta: theta as f32,
        };
        let got = f64::from(single.coefficient(v as f32, theta));
        assert!((got / mu - 1.0).abs() < 3e-5, "f32: {got} for {mu}");
    }
    worst.assert_within(&tolerance::LAW);
}

#[test]
fn rate_and_state_vanishes_at_rest_and_passes_nan_on() {
    let law = rock::<SlipLaw>();
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
                let ageing = rock::<AgeingLaw>().advance(age(theta), v, dt).theta;
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
        let got = rock::<AgeingLaw>().advance(age(theta), v, dt).theta;
        worst.see((got / ageing - 1.0).abs(), place);
        let got = rock::<SlipLaw>().advance(age(theta), v, dt).theta;
        worst.see((got / slip - 1.0).abs(), place);
    }
    worst.assert_within(&tolerance::AGE);
    // At rest one law ages and the other waits; from nothing likewise.
    assert_eq!(rock::<AgeingLaw>().advance(age(3.0), 0.0, 2.0).theta, 5.0);
    assert_eq!(rock::<SlipLaw>().advance(age(3.0), 0.0, 2.0).theta, 3.0);
    assert_eq!(rock::<SlipLaw>().advance(age(0.0), 1e-6, 2.0).theta, 0.0);
    for v in [1e-320, 1e-300, 1e-30] {
        assert_eq!(rock::<AgeingLaw>().advance(age(3.0), v, 2.0).theta, 5.0);
    }
}

/// The age after `dt` in one step against the age after `parts` steps.
fn see_parts<E: StateEvolution>(worst: &mut Worst, name: &str) {
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
    see_parts::<AgeingLaw>(&mut worst, "ageing law");
    see_parts::<SlipLaw>(&mut worst, "slip law");
    worst.assert_within(&tolerance::PARTS_OF_A_STEP);
}

#[test]
fn single_precision_ages_agree() {
    let mut rng = Lcg::new(79);
    let mut worst = Worst::of("ageing law in f32");
    for _ in 0..2000 {
        let v = rng.log_between(1e-6, 1.0) as f32;
        let theta = rng.log_between(1e-3, 1e3) as f32;
        let dt = (rng.log_between(1e-3, 1e3) * SLIP_DISTANCE) as f32 / v;
        let single = laws::rate_state::<f32>(0.01, 0.015, 2.0);
        let got = single.advance(StateVariable { theta }, v, dt).theta;
        let wanted = rock::<AgeingLaw>().advance(age(theta.into()), v.into(), dt.into());
        let error = (f64::from(got) / wanted.theta - 1.0).abs();
        worst.see(error, || {
            format!("theta = {theta:e}, v = {v:e}, dt = {dt:e}")
        });
    }
    worst.assert_within(&tolerance::STEP_SINGLE);
}

#[test]
fn steady_sliding_is_where_the_age_rests() {
    let mut rng = Lcg::new(67);
    let mut worst = Worst::of("steady rate-and-state friction");
    for _ in 0..500 {
        let (v, theta) = (rng.log_between(1e-9, 1.0), rng.log_between(1e-6, 1e6));
        let long = 60.0 * SLIP_DISTANCE / v;
        let steady = rock::<AgeingLaw>().steady().friction(v);
        for end in [
            rock::<AgeingLaw>().advance(age(theta), v, long),
            rock::<SlipLaw>().advance(age(theta), v, long),
            rock::<SlipLaw>().steady_age(v),
        ] {
            let error = (rock::<SlipLaw>().coefficient(v, end) / steady - 1.0).abs();
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
    RateState::<f64, AgeingLaw>::new(parameters)
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
fn growth_of_disturbance<E: StateEvolution>(stiffness: f64, v: f64) -> f64 {
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
fn speed_of<E: StateEvolution>(
    law: &RateState<f64, E>,
    spring: f64,
    state: StateVariable<f64>,
    guess: f64,
) -> f64 {
    (0..4).fold(guess, |v, _| {
        v - (law.coefficient(v, state) - spring) / law.slope(v, state)
    })
}

#[test]
fn a_spring_pulls_steadily_above_the_critical_stiffness_only() {
    let law = rock::<AgeingLaw>().steady();
    // Slow, where k_c = N(b − a)/D_c, and halfway to the minimum, where viscosity halves it.
    for (v, share) in [(1e-8, 1.0), (1.25e-3, 0.5)] {
        let critical = law.critical_stiffness_at(1.0, v);
        let wanted = share * law.critical_stiffness(1.0);
        assert!((critical / wanted - 1.0).abs() < 1e-5);
        for (factor, stable) in [(1.03, true), (0.97, false)] {
            let ageing = growth_of_disturbance::<AgeingLaw>(factor * critical, v);
            let slip = growth_of_disturbance::<SlipLaw>(factor * critical, v);
            assert_eq!(ageing < 1.0, stable, "V = {v:e}, {factor} k_c: {ageing}");
            assert_eq!(slip < 1.0, stable, "V = {v:e}, {factor} k_c: {slip}");
        }
    }
    assert!(law.critical_stiffness_at(1.0, 1.0) < 0.0);
}
