//! Friction laws: every one against differences, other precisions and the ends of the range, and
//! each against what it promises.

use std::f64::consts::PI;

use tribos_core::coupling::{Coupling, quadrature::DiskQuadrature};
use tribos_core::law::{
    Age, Ageing, BowdenTabor, Coulomb, Dieterich, DragRegime, DryFriction, GreenwoodWilliamson,
    Grip, HertzSphere, Incline, InertialDrag, LawError, LocalLaw, LuGre, LuGreParameters, Plastic,
    PlateauPower, PowerLaw, RateState, RateStateParameters, RealArea, Stokes, Stribeck,
    critical_angle, crossover_reynolds, reynolds,
};
use tribos_core::real::Real;
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

type Named<R> = (&'static str, Box<dyn LocalLaw<R>>);

fn rate_state<R: Real>(a: f64, b: f64, viscous: f64) -> RateState<R, Dieterich> {
    RateState::new(RateStateParameters {
        mu: R::from_f64(0.6),
        a: R::from_f64(a),
        b: R::from_f64(b),
        reference_speed: R::from_f64(1e-6),
        slip_distance: R::from_f64(1e-5),
        viscous: R::from_f64(viscous),
    })
    .unwrap()
}

fn stribeck<R: Real>(exponent: f64, viscous: f64) -> Stribeck<R> {
    let dry = DryFriction::new(R::from_f64(0.15), R::from_f64(0.1)).unwrap();
    Stribeck::new(
        dry,
        R::from_f64(0.01),
        R::from_f64(exponent),
        R::from_f64(viscous),
    )
    .unwrap()
}

fn plateau<R: Real>(alpha: f64, rest: f64) -> PlateauPower<R> {
    let [alpha, gamma, plateau, drop, rest] = [alpha, 0.008, 1e-4, 1e-7, rest].map(R::from_f64);
    PlateauPower::new(alpha, gamma, plateau, drop, rest).unwrap()
}

fn lugre<R: Real>() -> LuGre<R> {
    LuGre::new(LuGreParameters {
        coulomb_force: R::from_f64(1.0),
        static_force: R::from_f64(1.5),
        stribeck_speed: R::from_f64(1e-3),
        stiffness: R::from_f64(1e5),
        bristle_damping: R::from_f64(316.0),
        viscous_damping: R::from_f64(0.4),
    })
    .unwrap()
}

/// Every local law, at several parameters.
fn laws<R: Real + 'static>() -> Vec<Named<R>> {
    let number = R::from_f64;
    vec![
        (
            "dry",
            Box::new(DryFriction::new(number(0.5), number(0.3)).unwrap()),
        ),
        ("Stribeck 1/2", Box::new(stribeck(0.5, 0.5))),
        ("Stribeck 1", Box::new(stribeck(1.0, 0.5))),
        ("Stribeck 2", Box::new(stribeck(2.0, 0.0))),
        ("plateau -1/2", Box::new(plateau(-0.5, 0.5))),
        ("plateau -0.19", Box::new(plateau(-0.19, 0.0))),
        ("plateau 0", Box::new(plateau(0.0, 1.0))),
        (
            "rate-and-state, weakening",
            Box::new(rate_state(0.01, 0.015, 2.0).steady()),
        ),
        (
            "rate-and-state, strengthening",
            Box::new(rate_state(0.015, 0.01, 0.0).steady()),
        ),
        (
            "rate-and-state, neutral",
            Box::new(rate_state(0.01, 0.01, 0.0).steady()),
        ),
        (
            "rate-and-state, no state",
            Box::new(rate_state(0.02, 0.0, 0.0).steady()),
        ),
        (
            "LuGre",
            Box::new(lugre().steady_per_load(number(4.0)).unwrap()),
        ),
    ]
}

/// f' from central differences, extrapolated to sixth order.
fn differentiated(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let central = |h: f64| (f(x + h) - f(x - h)) / (2.0 * h);
    let h = x / 128.0;
    let (coarse, middle, fine) = (central(h), central(h / 2.0), central(h / 4.0));
    let (better, best) = ((4.0 * middle - coarse) / 3.0, (4.0 * fine - middle) / 3.0);
    (16.0 * best - better) / 15.0
}

#[test]
fn slopes_are_derivatives_of_friction() {
    let mut rng = Lcg::new(41);
    let mut worst = Worst::of("slope of local laws");
    for (name, law) in laws::<f64>() {
        for _ in 0..2000 {
            let v = rng.log_between(1e-9, 1e2);
            let slope = law.slope(v);
            let scale = slope.abs() + law.friction(v) / v;
            let error = (slope - differentiated(|v| law.friction(v), v)).abs() / scale;
            worst.see(error, || format!("{name}, v = {v:e}"));
        }
    }
    worst.assert_within(&tolerance::LAW_SLOPE);
}

#[test]
fn friction_is_never_negative() {
    let mut rng = Lcg::new(43);
    for (name, law) in laws::<f64>() {
        for _ in 0..2000 {
            let v = rng.log_between(1e-300, 1e300);
            assert!(law.friction(v) >= 0.0, "{name}, v = {v:e}");
            assert!(!law.slope(v).is_nan(), "{name}, v = {v:e}");
        }
    }
}

#[test]
fn limits_are_numbers_and_nan_stays_nan() {
    for (name, law) in laws::<f64>() {
        for v in special_f64().into_iter().filter(|v| !v.is_sign_negative()) {
            let (friction, slope) = (law.friction(v), law.slope(v));
            assert_eq!(friction.is_nan(), v.is_nan(), "{name}, v = {v:e}");
            assert_eq!(slope.is_nan(), v.is_nan(), "{name}, v = {v:e}");
        }
        // Negative speeds have no meaning, but do no harm.
        for v in special_f64() {
            let _ = (law.friction(v), law.slope(v));
        }
    }
    for (name, law) in laws::<f32>() {
        for v in [0.0, 1e-45, f32::MIN_POSITIVE, 1.0, f32::MAX, f32::INFINITY] {
            assert!(law.friction(v) >= 0.0, "{name}, v = {v:e}");
            assert!(!law.slope(v).is_nan(), "{name}, v = {v:e}");
        }
        assert!(law.friction(f32::NAN).is_nan() && law.slope(f32::NAN).is_nan());
    }
}

#[test]
fn both_precisions_agree() {
    let mut rng = Lcg::new(47);
    let mut worst = Worst::of("local laws in f32");
    for ((name, single), (_, double)) in laws::<f32>().into_iter().zip(laws::<f64>()) {
        for _ in 0..2000 {
            let v = rng.log_between(1e-9, 1e2) as f32;
            let (friction, slope) = (double.friction(f64::from(v)), double.slope(f64::from(v)));
            let error = (f64::from(single.friction(v)) - friction).abs() / friction;
            worst.see(error, || format!("{name}, friction at {v:e}"));
            let scale = slope.abs() + friction / f64::from(v);
            let error = (f64::from(single.slope(v)) - slope).abs() / scale;
            worst.see(error, || format!("{name}, slope at {v:e}"));
        }
    }
    worst.assert_within(&tolerance::LAW_SINGLE);
}

#[test]
fn laws_compose_with_the_disk() {
    // Purely viscous friction k v on a disk: force k v, torque k w/2 in reduced units.
    let dry = DryFriction::new(0.0_f64, 0.0).unwrap();
    let viscous = DiskQuadrature::new(Stribeck::new(dry, 1.0, 2.0, 0.7).unwrap());
    // Dry friction on a disk is Coulomb's.
    let dry = DiskQuadrature::new(DryFriction::new(0.5_f64, 0.3).unwrap());
    let coulomb = DiskQuadrature::new(Coulomb::new(0.3_f64).unwrap());
    // α = −1/2 far above the plateau is the power law.
    let ice = DiskQuadrature::new(plateau::<f64>(-0.5, 0.5));
    let power = DiskQuadrature::new(PowerLaw::new(-0.5_f64, 0.008).unwrap());
    let mut rng = Lcg::new(53);
    let mut worst = Worst::of("linear law on a disk");
    for _ in 0..200 {
        let (v, w) = (rng.log_between(0.1, 10.0), rng.log_between(0.1, 10.0));
        let got = viscous.reduced_wrench(v, w);
        for (got, wanted) in [(got.force, 0.7 * v), (got.torque, 0.35 * w)] {
            worst.see((got / wanted - 1.0).abs(), || format!("({v}, {w})"));
        }
        assert_eq!(dry.reduced_wrench(v, w), coulomb.reduced_wrench(v, w));
        let (ice, power) = (ice.reduced_wrench(v, 0.0), power.reduced_wrench(v, 0.0));
        assert!((ice.force / power.force - 1.0).abs() < 1e-6);
    }
    worst.assert_within(&tolerance::LINEAR_ON_DISK);
    for v in [0.0, 1e-9, 1.0] {
        let at_low = DiskQuadrature::new(plateau::<f64>(-0.5, 0.5)).reduced_jacobian(v, 0.0);
        assert!(at_low.force_per_slide > 0.0);
    }
}

/// F of a disk by 100,000 angles of its rim: v⟨2 sin²θ g(ρ)/ρ⟩.
fn force_by_the_rim(law: &impl LocalLaw<f64>, v: f64, w: f64) -> f64 {
    let count = 100_000;
    let sum: f64 = (0..count)
        .map(|i| {
            let (sin, cos) = (PI * (f64::from(i) + 0.5) / f64::from(count)).sin_cos();
            let speed = (v * v + w * w - 2.0 * v * w * cos).sqrt();
            2.0 * sin * sin * law.friction(speed) / speed
        })
        .sum();
    v * sum / f64::from(count)
}

fn see_disk(worst: &mut Worst, name: &str, law: impl LocalLaw<f64>, range: (f64, f64)) {
    let disk = DiskQuadrature::new(law);
    let mut rng = Lcg::new(83);
    for i in 0..40 {
        let mut speed = || rng.log_between(range.0, range.1);
        // Every fourth disk rolls off its rim, where one point of it is at rest.
        let (v, w) = (speed(), speed());
        let w = if i % 4 == 0 { v } else { w };
        let wanted = force_by_the_rim(disk.law(), v, w);
        let error = (disk.reduced_wrench(v, w).force / wanted - 1.0).abs();
        worst.see(error, || format!("{name}, ({v:e}, {w:e})"));
    }
}

#[test]
fn quadrature_serves_laws_with_several_regimes() {
    let mut worst = Worst::of("laws with several regimes on a disk");
    let weakening = rate_state(0.01, 0.015, 2.0).steady();
    see_disk(&mut worst, "rate-and-state", weakening, (1e-6, 1.0));
    see_disk(&mut worst, "Stribeck", stribeck(2.0, 0.5), (1e-3, 0.1));
    see_disk(&mut worst, "plateau", plateau(-0.5, 0.5), (1e-5, 1.0));
    let joint = lugre().steady_per_load(4.0).unwrap();
    see_disk(&mut worst, "LuGre", joint, (1e-4, 1e-2));
    worst.assert_within(&tolerance::REGIMES_ON_DISK);
}

#[test]
fn a_body_slips_beyond_static_friction_only() {
    let wood = DryFriction::new(0.5_f64, 0.3).unwrap();
    for drive in [0.5_f64, -0.5, 0.0, 0.49] {
        assert_eq!(wood.at_rest(drive), Grip::Stick);
        assert_eq!(wood.net_drive(drive), 0.0);
    }
    for drive in [0.5_f64.next_up(), -0.7, f64::INFINITY, f64::NAN] {
        assert_eq!(wood.at_rest(drive), Grip::Slip);
    }
    assert_eq!(wood.net_drive(0.75), 0.75 - 0.3);
    assert_eq!(wood.net_drive(-0.75), 0.3 - 0.75);
    assert!(wood.net_drive(f64::NAN).is_nan());
}

#[test]
fn euler_s_incline_holds_up_to_the_critical_angle() {
    let gravity = 9.81;
    let on = |angle: f64| Incline::new(angle.sin(), angle.cos()).unwrap();
    for mu in [0.0_f64, 0.1, 0.25, 1.0 / 3.0, 1.0, 5.0] {
        let law = DryFriction::new(mu, 0.6 * mu).unwrap();
        let critical = critical_angle(mu);
        assert!((critical.tan() - mu).abs() < 1e-14 * (1.0 + mu * mu));
        if mu > 0.0 {
            assert_eq!(on(critical - 1e-9).acceleration_at_rest(&law, gravity), 0.0);
        }
        // Just above it slides with what static friction exceeds dynamic by.
        let jump = gravity * 0.4 * mu * critical.cos();
        let got = on(critical + 1e-9).acceleration_at_rest(&law, gravity);
        assert!((got - jump).abs() < 1e-7 && got > 0.0, "{got} for {jump}");
    }
    let law = DryFriction::new(0.5, 0.3).unwrap();
    let incline = on(0.4);
    assert!((incline.angle() - 0.4).abs() < 1e-15);
    let (down, up) = (
        incline.acceleration_downhill(&law, gravity, 1.0),
        incline.acceleration_uphill(&law, gravity, 1.0),
    );
    assert!((down + up - 2.0 * gravity * 0.4_f64.sin()).abs() < 1e-14);
    assert!((up - down - 0.6 * gravity * 0.4_f64.cos()).abs() < 1e-14);
    // A wall, and grades that would overflow.
    let wall = Incline::new(1e200, 0.0).unwrap();
    assert_eq!(wall.acceleration_at_rest(&law, gravity), gravity);
    assert_eq!(
        Incline::new(1e-300, 1e300)
            .unwrap()
            .acceleration_at_rest(&law, gravity),
        0.0
    );
}

#[test]
fn static_friction_ages_with_the_logarithm_of_time() {
    let law = Ageing::new(0.4, 0.03, 2.0).unwrap();
    let of = |time| law.mu_static(Age { time });
    for time in [0.0, 0.3, 2.0] {
        assert_eq!(of(time), 0.4);
    }
    // The same gain for every decade, four days included.
    for time in [2.0, 7.0, 3.5e4] {
        let gain = of(10.0 * time) - of(time);
        assert!((gain - 0.03 * 10.0_f64.ln()).abs() < 1e-15);
        let rate = differentiated(of, 2.0 * time);
        assert!((law.rate(Age { time: 2.0 * time }) / rate - 1.0).abs() < 1e-9);
    }
    assert!((of(20.0) - (0.4 + 0.03 * 10.0_f64.ln())).abs() < 1e-15);
    assert!((of(f64::MAX) - (0.4 + 0.03 * (f64::MAX / 2.0).ln())).abs() < 1e-14);
    assert_eq!(of(f64::INFINITY), f64::INFINITY);
    assert!(of(f64::NAN).is_nan());
    // Rest adds up, sliding forgets.
    let age = Age::ZERO
        .advance(3.0, Grip::Stick)
        .advance(4.0, Grip::Stick);
    assert_eq!(age.time, 7.0);
    assert_eq!(age.advance(1.0, Grip::Slip), Age::ZERO);
    // A drive between young and old strength.
    assert_eq!(law.at_rest(Age::ZERO, 0.43), Grip::Slip);
    assert_eq!(law.at_rest(Age { time: 10.0 }, 0.43), Grip::Stick);
}

#[test]
fn plastic_junctions_give_coulomb_s_law() {
    // The thesis' cube: 100 N on steel rest on 0.1 mm².
    let friction = BowdenTabor::new(0.6e9_f64, Plastic::new(1e9).unwrap()).unwrap();
    assert!((friction.contact().area(100.0) / 1e-7 - 1.0).abs() < 1e-15);
    for load in [1e-6, 1.0, 1e6] {
        assert!((friction.force(load) / (0.6 * load) - 1.0).abs() < 1e-15);
        assert!((friction.effective_coefficient(load) - 0.6).abs() < 1e-15);
        assert!((friction.slope(load) - 0.6).abs() < 1e-15);
    }
    assert_eq!(friction.coulomb().unwrap(), Coulomb::new(0.6).unwrap());
    assert_eq!(friction.force(-1.0), 0.0);
    assert!(friction.force(f64::NAN).is_nan());
}

#[test]
fn a_sphere_indents_by_hertz() {
    let (radius, modulus) = (0.02_f64, 7e10);
    let sphere = HertzSphere::new(radius, modulus).unwrap();
    for load in [1e-9, 1e-3, 1.0, 1e4] {
        // Back from the contact radius: L = 4E*a³/(3R).
        let a = (sphere.area(load) / PI).sqrt();
        let back = 4.0 * modulus * a.powi(3) / (3.0 * radius);
        assert!((back / load - 1.0).abs() < 1e-13, "{back} for {load}");
        let per_load = sphere.area(load) / load;
        assert!((sphere.area_per_load(load) / per_load - 1.0).abs() < 1e-13);
        let slope = differentiated(|l| sphere.area(l), load);
        assert!((sphere.slope(load) / slope - 1.0).abs() < 1e-10);
    }
    assert_eq!(sphere.area(0.0), 0.0);
    assert_eq!(sphere.area_per_load(0.0), f64::INFINITY);
    assert_eq!((sphere.area(-1.0), sphere.slope(-1.0)), (0.0, 0.0));
    assert!(sphere.area(f64::NAN).is_nan() && sphere.slope(f64::NAN).is_nan());
}

/// ∫ f over [0, ∞) by the trapezoid of x = exp(t − e^(−t)), which dies twice exponentially at zero.
fn half_line(scale: f64, f: impl Fn(f64) -> f64) -> f64 {
    let step = 1.0 / 64.0;
    (-400..500)
        .map(|i| {
            let t = f64::from(i) * step;
            let x = (t - (-t).exp()).exp();
            f(scale * x) * scale * x * (1.0 + (-t).exp()) * step
        })
        .sum()
}

#[test]
fn exponential_asperities_make_area_proportional_to_load() {
    let (decay, tip, modulus) = (1e-6_f64, 2e-4, 1e11);
    let rough = GreenwoodWilliamson::new(decay, tip, modulus).unwrap();
    let sphere = HertzSphere::new(tip, modulus).unwrap();
    for separation in [0.0_f64, 2e-6, 1e-5] {
        // Sum of Hertz contacts of tips that reach `indent` beyond the separation.
        let density = |indent: f64| 1e9 * (-(separation + indent) / decay).exp();
        let load_of = |indent: f64| 4.0 / 3.0 * modulus * (tip * indent.powi(3)).sqrt();
        let sum = |of: &dyn Fn(f64) -> f64| half_line(decay, |z| density(z) * of(z));
        let (count, load) = (sum(&|_| 1.0), sum(&load_of));
        let area = sum(&|z| sphere.area(load_of(z)));
        assert!((rough.area(load) / area - 1.0).abs() < 1e-12);
        assert!((rough.junction_area() * count / area - 1.0).abs() < 1e-12);
        assert!((rough.mean_pressure() * area / load - 1.0).abs() < 1e-12);
    }
}

#[test]
fn stribeck_s_minimum_is_where_its_formula_says() {
    let drop = 0.15 - 0.1;
    // δ = 1: vₛ ln((μₛ − μ_d)/(k vₛ)); δ = 2 and 1/2: Lambert's W and a root, in 40 digits.
    let exact = [
        (1.0, 0.01 * (drop / (0.5_f64 * 0.01)).ln()),
        (2.0, 0.019084020979734697),
        (0.5, 0.017601983373620282),
    ];
    for (exponent, wanted) in exact {
        let law = stribeck::<f64>(exponent, 0.5);
        let got = law.minimum().unwrap();
        assert!((got / wanted - 1.0).abs() < 1e-13, "{got} for {wanted}");
        assert!(law.slope(0.999 * got) < 0.0 && law.slope(1.001 * got) > 0.0);
        let single = stribeck::<f32>(exponent, 0.5).minimum().unwrap();
        assert!((f64::from(single) / wanted - 1.0).abs() < 1e-5);
    }
    // No rise, no fall, or a film too stiff for the fall to show.
    assert_eq!(stribeck::<f64>(2.0, 0.0).minimum(), None);
    assert_eq!(stribeck::<f64>(1.0, 5.1).minimum(), None);
    assert_eq!(stribeck::<f64>(2.0, 5.0).minimum(), None);
    let flat = DryFriction::new(0.1, 0.1).unwrap();
    assert_eq!(Stribeck::new(flat, 0.01, 1.0, 0.5).unwrap().minimum(), None);
}

#[test]
fn stribeck_runs_from_boundary_to_hydrodynamic_friction() {
    for exponent in [0.5, 1.0, 2.0] {
        let law = stribeck::<f64>(exponent, 0.5);
        assert_eq!(law.friction(0.0), 0.15);
        let wanted = 0.1 + 0.05 * (-1.0_f64).exp() + 0.005;
        assert!((law.friction(0.01) - wanted).abs() < 1e-16);
        assert!((law.friction(1e3) - 500.1).abs() < 1e-12);
        assert_eq!(
            law.boundary(0.02) + law.hydrodynamic(0.02),
            law.friction(0.02)
        );
    }
    assert_eq!(stribeck::<f64>(0.5, 0.5).slope(0.0), f64::NEG_INFINITY);
    let drop = 0.15 - 0.1;
    assert!((stribeck::<f64>(1.0, 0.5).slope(0.0) - (0.5 - drop / 0.01)).abs() < 1e-14);
    assert_eq!(stribeck::<f64>(2.0, 0.5).slope(0.0), 0.5);
}

#[test]
fn drag_changes_from_viscous_to_inertial_where_the_forces_cross() {
    let (density, viscosity, radius, constant) = (1e3, 1e-3, 2e-3, 0.7);
    let slow = Stokes::new(viscosity, radius).unwrap();
    let fast = InertialDrag::new(constant, density, radius).unwrap();
    let crossover = crossover_reynolds(constant);
    assert!((crossover - 6.0 * PI / 0.7).abs() < 1e-13);
    for factor in [1e-3, 0.999, 1.001, 1e3] {
        let speed = factor * crossover * viscosity / (density * radius);
        let number = reynolds(density, speed, radius, viscosity);
        assert!((number / (factor * crossover) - 1.0).abs() < 1e-14);
        let regime = DragRegime::at(number, constant).unwrap();
        assert_eq!(
            regime == DragRegime::Viscous,
            slow.force(speed) > fast.force(speed)
        );
        // Eq. 2.3: forces are functions of Re alone in units of ρv²r².
        let unit = density * speed * speed * radius * radius;
        assert!((slow.force(speed) / unit * number - 6.0 * PI).abs() < 1e-13);
        assert!((fast.force(speed) / unit - constant).abs() < 1e-15);
        assert!((slow.slope(speed) * speed / slow.force(speed) - 1.0).abs() < 1e-15);
        assert!((fast.slope(speed) * speed / fast.force(speed) - 2.0).abs() < 1e-15);
    }
    assert_eq!(DragRegime::at(f64::NAN, constant), None);
    assert_eq!(reynolds(1.0, 0.0, 1.0, 0.0), 0.0);
    assert!(slow.force(f64::NAN).is_nan() && slow.slope(f64::NAN).is_nan());
}

#[test]
fn the_plateau_joins_ice_at_rest_to_fast_sliding() {
    for alpha in [-0.19, -0.5, -0.75] {
        for rest in [0.0, 0.5, 1.0] {
            let law = plateau::<f64>(alpha, rest);
            let top = 0.008 * 1e-4_f64.powf(alpha);
            assert!((law.friction(0.0) / top - rest).abs() < 1e-15);
            // Nowhere farther from the two branches than documented, and below both.
            let mut rng = Lcg::new(59);
            for _ in 0..500 {
                let v = rng.log_between(1e-4, 1e2);
                let gap = 1.0 - law.friction(v) / (0.008 * v.powf(alpha));
                let bound = -alpha / 2.0 * (1e-4 / v).powi(2) + (1.0 - rest) * 1e-7 / v;
                assert!((-1e-14..=bound * (1.0 + 1e-9) + 1e-14).contains(&gap));
                let v = rng.log_between(1e-7, 1e-4);
                let gap = 1.0 - law.friction(v) / top;
                let bound = -alpha / 2.0 * (v / 1e-4).powi(2) + (1.0 - rest) * 1e-7 / v;
                assert!((-1e-14..=bound * (1.0 + 1e-9) + 1e-14).contains(&gap));
            }
            // The two decades of fig. 3.19 are flat within (1 − r)/11.
            let flat = law.friction(1e-6) / top;
            assert!(1.0 - flat <= (1.0 - rest) / 11.0 + 1e-4);
        }
    }
    assert_eq!(plateau::<f64>(-0.5, 0.5).friction(f64::INFINITY), 0.0);
}

#[test]
fn senseless_laws_are_refused() {
    assert_eq!(
        DryFriction::new(0.3, 0.5),
        Err(LawError::Order {
            smaller: "dynamic coefficient",
            larger: "static coefficient"
        })
    );
    let dry = DryFriction::new(0.5, 0.3).unwrap();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Stribeck::new(dry, bad, 1.0, 0.0).is_err());
        assert!(Stribeck::new(dry, 1.0, bad, 0.0).is_err());
        assert!(Ageing::new(0.3, 0.1, bad).is_err());
        assert!(Plastic::new(bad).is_err());
        assert!(HertzSphere::new(bad, 1.0).is_err() && HertzSphere::new(1.0, bad).is_err());
        assert!(GreenwoodWilliamson::new(1.0, bad, 1.0).is_err());
        assert!(Stokes::new(1.0, bad).is_err() && InertialDrag::new(bad, 1.0, 1.0).is_err());
        assert!(PlateauPower::new(-0.5, 1.0, bad, 1e-9, 0.5).is_err());
        assert!(PlateauPower::new(-0.5, 1.0, 1e-4, bad, 0.5).is_err());
        assert!(lugre::<f64>().steady_per_load(bad).is_err());
        let parameters = *rate_state::<f64>(0.01, 0.02, 0.0).parameters();
        assert!(
            RateState::<_, Dieterich>::new(RateStateParameters {
                a: bad,
                ..parameters
            })
            .is_err()
        );
        let parameters = *lugre::<f64>().parameters();
        assert!(
            LuGre::new(LuGreParameters {
                coulomb_force: bad,
                ..parameters
            })
            .is_err()
        );
    }
    assert!(PlateauPower::new(-0.5, 1.0, 1e-4, 1e-3, 0.5).is_err());
    assert!(PlateauPower::new(-0.5, 1.0, 1e-4, 1e-6, 1.5).is_err());
    assert!(PlateauPower::new(0.5, 1.0, 1e-4, 1e-6, 0.5).is_err());
    assert!(Incline::new(0.0, 0.0).is_err() && Incline::new(-1.0, 1.0).is_err());
    let message = Plastic::new(-2.0).unwrap_err().to_string();
    assert_eq!(message, "the hardness must be positive and finite, not -2");
}
