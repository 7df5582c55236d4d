//! Records whose truth comes from other integrations: the state, the machine and the motion between the points.

use super::*;
use tribos_base::random::Random;

/// Normal deviates by the polar method of Marsaglia and Bray (1964).
fn normal(random: &mut Random) -> f64 {
    loop {
        let [x, y] = [(); 2].map(|()| 2.0 * random.unit() - 1.0);
        let square: f64 = x * x + y * y;
        if square > 0.0 && square < 1.0 {
            return x * (-2.0 * libm::log(square) / square).sqrt();
        }
    }
}

/// Asserts that intervals hold the truth.
fn assert_inside(fit: &Fit, truths: &[(&str, f64)]) {
    for (name, truth) in truths {
        let found = fit
            .parameters
            .iter()
            .find(|e| e.parameter.name == *name)
            .unwrap();
        let [low, high] = found.interval;
        assert!(
            low < *truth && *truth < high,
            "{name}: {truth} not in {low} to {high}"
        );
    }
}

fn found(law: FitLaw, data: &Measurements, machine: Apparatus, fixed: &[(&str, f64)]) -> Fit {
    let fixed = fixed
        .iter()
        .map(|(name, value)| ((*name).to_owned(), *value));
    let options = FitOptions {
        fixed: fixed.collect(),
        ..FitOptions::default()
    };
    let model = law.model_on(data, machine).unwrap();
    data.fit(model.as_ref(), &options).unwrap()
}

/// LuGre's joint, driven by a sine, by the classical method of Runge and Kutta in steps of a microsecond.
fn joint(points: usize, seed: u64) -> Measurements {
    const STEP: f64 = 1e-6;
    let velocity = |t: f64| 1.5 * (10.0 * std::f64::consts::PI * t).sin();
    let limit = |v: f64| 15.0 + 10.0 * (-(v / 0.25) * (v / 0.25)).exp();
    let rate = |z: f64, v: f64| v - 1e6 * v.abs() * z / limit(v);
    let (mut z, mut time, mut random) = (0.0, 0.0, Random::new(seed, 0));
    let (mut t, mut v, mut f) = (Vec::new(), Vec::new(), Vec::new());
    let every = 1_000_000 / points;
    for k in 0..=1_000_000_usize {
        let now = velocity(time);
        if k % every == 0 {
            t.push(time);
            v.push(now);
            f.push(1e6 * z + 25.0 * rate(z, now) + 0.1 * normal(&mut random));
        }
        let (middle, end) = (velocity(time + 0.5 * STEP), velocity(time + STEP));
        let one = rate(z, now);
        let two = rate(z + 0.5 * STEP * one, middle);
        let three = rate(z + 0.5 * STEP * two, middle);
        let four = rate(z + STEP * three, end);
        z += STEP / 6.0 * (one + 2.0 * two + 2.0 * three + four);
        time = (k + 1) as f64 * STEP;
    }
    Measurements::series(t, v, f, None).unwrap()
}

#[test]
fn bristles_are_right_however_coarse_the_record_is() {
    for (points, seed) in [(1000, 1), (4000, 2)] {
        let data = joint(points, seed);
        let fit = found(FitLaw::LuGre, &data, Apparatus::default(), &[]);
        let truth = [
            ("fc", 15.0),
            ("fs", 25.0),
            ("vs", 0.25),
            ("s0", 1e6),
            ("s1", 25.0),
        ];
        assert_inside(&fit, &truth);
        assert!(
            fit.at_best >= 3 && (fit.deviation() - 0.1).abs() < 0.01,
            "{}",
            fit.deviation()
        );
    }
}

/// Rock of a 0.010, b 0.012, D_c 10 µm on a spring of 3000/m, whose load point goes from 3 to 10 µm/s: Euler's method in
/// steps of 0.1 ms.
fn rock(seed: u64) -> Measurements {
    const STEP: f64 = 1e-4;
    let (mut random, mut theta, mut mu) = (Random::new(seed, 0), 1e-5 / 3e-6, 0.6);
    let (mut t, mut v, mut f) = (Vec::new(), Vec::new(), Vec::new());
    for k in 0..450_000_i32 {
        let time = f64::from(k) * STEP - 5.0;
        let load_point = if time < 0.0 { 3e-6 } else { 1e-5 };
        if k % 500 == 0 {
            t.push(time);
            v.push(load_point);
            f.push(mu + 2e-4 * normal(&mut random));
        }
        let slip = 3e-6 * ((mu - 0.6 - 0.012 * (theta * 3e-6 / 1e-5_f64).ln()) / 0.010).exp();
        theta += STEP * (1.0 - slip * theta / 1e-5);
        mu += STEP * 3000.0 * (load_point - slip);
    }
    Measurements::series(t, v, f, None).unwrap()
}

#[test]
fn the_spring_of_the_machine_is_told_from_the_direct_effect() {
    let data = rock(3);
    let spring = Apparatus {
        spring: true,
        ..Apparatus::default()
    };
    let truth = [("a", 0.010), ("b", 0.012), ("dc", 1e-5)];
    let given = found(FitLaw::RateState, &data, spring, &[("spring", 3000.0)]);
    assert_inside(&given, &truth);
    let fitted = found(FitLaw::RateState, &data, spring, &[]);
    assert_inside(&fitted, &truth);
    assert_inside(&fitted, &[("spring", 3000.0)]);
    // Taken for the slip rate, the load point gives another a, and residuals that tell.
    let bare = found(
        FitLaw::RateState,
        &data,
        Apparatus::default(),
        &[("eta", 0.0)],
    );
    assert!(bare.value("a").unwrap() < 0.0085, "{:?}", bare.value("a"));
    let told = |caution: &Caution| matches!(caution, Caution::Correlated { .. });
    assert!(bare.cautions.iter().any(told) && !given.cautions.iter().any(told));
}

/// A servo joint: f = 1.4 sgn v + 2.2 v + 0.57 a + 0.02.
fn servo(seed: u64) -> Measurements {
    let mut random = Random::new(seed, 0);
    let t: Vec<f64> = (0..2000).map(|k| 0.01 * f64::from(k) + 0.003).collect();
    let v: Vec<f64> = t
        .iter()
        .map(|t| 0.8 * (2.0 * t).sin() + 0.4 * (3.1 * t).sin())
        .collect();
    let force = |(t, v): (&f64, &f64)| {
        let a = 1.6 * (2.0 * t).cos() + 1.24 * (3.1 * t).cos();
        1.4 * v.signum() + 2.2 * v + 0.57 * a + 0.02 + 0.05 * normal(&mut random)
    };
    let f = t.iter().zip(&v).map(force).collect();
    Measurements::series(t, v, f, None).unwrap()
}

#[test]
fn a_drive_is_told_from_its_friction_and_missed_where_it_is_left_out() {
    let data = servo(5);
    let machine = Apparatus {
        inertia: true,
        offset: true,
        ..Apparatus::default()
    };
    let fit = found(FitLaw::Viscous, &data, machine, &[]);
    assert_inside(
        &fit,
        &[("mu", 1.4), ("k", 2.2), ("inertia", 0.57), ("offset", 0.02)],
    );
    assert!(fit.cautions.is_empty(), "{:?}", fit.cautions);
    let bare = found(FitLaw::Viscous, &data, Apparatus::default(), &[]);
    let told = |caution: &Caution| matches!(caution, Caution::Inertia { value } if (value - 0.57).abs() < 0.05);
    assert!(bare.cautions.iter().any(told), "{:?}", bare.cautions);
}

#[test]
fn laws_are_compared_and_those_that_the_data_cannot_tell_apart_are_named() {
    let mut random = Random::new(7, 0);
    let v: Vec<f64> = (1..=120).map(|k| 0.005 * f64::from(k)).collect();
    let f = v
        .iter()
        .map(|v| 0.2 + 0.4 * v + 0.002 * normal(&mut random))
        .collect();
    let data = Measurements::steady(v, f, None).unwrap();
    let options = FitOptions::default();
    let (all, left_out) = compare(&data, Apparatus::default(), &options, &mut |_, _| ());
    let one = |law: FitLaw| all.iter().find(|one| one.law == law).unwrap();
    // Stribeck's law holds the true one, and pays for three parameters more.
    assert_eq!((all[0].law, all[0].akaike), (FitLaw::Viscous, 0.0));
    assert!(!one(FitLaw::Stribeck).is_told_apart && one(FitLaw::Stribeck).akaike > 0.0);
    assert!(one(FitLaw::Coulomb).is_told_apart && one(FitLaw::Coulomb).akaike > 100.0);
    assert!((one(FitLaw::Viscous).foretold / 0.002 - 1.0).abs() < 0.2);
    assert!(left_out.iter().any(|(law, _)| *law == FitLaw::Dahl));
}

/// Steps of the velocity lie between the rows: the age after each follows the closed form of a constant velocity.
#[test]
fn steps_between_the_rows_are_found() {
    const ROW: f64 = 0.5;
    let mut random = Random::new(8, 0);
    let (mut age, mut time) = (10.0, 0.0);
    let (mut t, mut v, mut f) = (Vec::new(), Vec::new(), Vec::new());
    for level in 1..=40_u32 {
        let speed = if level % 2 == 1 { 1e-6 } else { 1e-5 };
        let end = 6.137 * f64::from(level);
        let after = |age: f64, dt: f64| {
            let steady = 1e-5 / speed;
            steady + (age - steady) * (-dt / steady).exp()
        };
        // Rows of this level.
        while let next = ROW * t.len() as f64
            && next <= end
        {
            age = after(age, next - time);
            time = next;
            t.push(time);
            v.push(speed);
            let friction = 0.6 + 0.010 * (speed / 1e-6_f64).ln() + 0.012 * (age / 10.0).ln();
            f.push(friction + 1e-4 * normal(&mut random));
        }
        age = after(age, end - time);
        time = end;
    }
    let data = Measurements::series(t, v, f, None).unwrap();
    let fixed = [("v0", 1e-6), ("eta", 0.0)];
    let fit = found(FitLaw::RateState, &data, Apparatus::default(), &fixed);
    assert_inside(
        &fit,
        &[("mu0", 0.6), ("a", 0.010), ("b", 0.012), ("dc", 1e-5)],
    );
    assert!((fit.deviation() - 1e-4).abs() < 1e-5, "{}", fit.deviation());
}

/// Three springs that yield at forces, moved by a sine in steps of 0.1 ms. What happens while the record pauses is
/// unknown to the fit.
#[test]
fn every_spring_begins_anew_after_a_gap() {
    const STEP: f64 = 1e-4;
    let springs = [[400.0, 1.0], [50.0, 0.8], [10.0, 0.6]];
    let (mut random, mut forces) = (Random::new(4, 0), [0.3, -0.2, 0.5]);
    let (mut t, mut v, mut f) = (Vec::new(), Vec::new(), Vec::new());
    for k in 0..60_000_u32 {
        let time = STEP * f64::from(k);
        let speed = 0.3 * (1.9 * time).sin() + 0.2 * (5.3 * time).sin();
        let is_pause = (2.0..2.4).contains(&time) || (4.1..4.3).contains(&time);
        if k % 100 == 0 && !is_pause {
            t.push(time);
            v.push(speed);
            f.push(forces.iter().sum::<f64>() + 0.01 * normal(&mut random));
        }
        let middle = time + 0.5 * STEP;
        let moved = STEP * (0.3 * (1.9 * middle).sin() + 0.2 * (5.3 * middle).sin());
        for (force, [stiffness, limit]) in forces.iter_mut().zip(springs) {
            *force = (*force + stiffness * moved).clamp(-limit, limit);
        }
    }
    let data = Measurements::series(t, v, f, None).unwrap();
    let fit = found(FitLaw::Maxwell, &data, Apparatus::default(), &[]);
    assert!((fit.deviation() - 0.01).abs() < 1e-3, "{}", fit.deviation());
    for (k, [stiffness, limit]) in springs.into_iter().enumerate() {
        let names = [["k1", "f1"], ["k2", "f2"], ["k3", "f3"]][k];
        for (name, truth) in names.into_iter().zip([stiffness, limit]) {
            let value = fit.value(name).unwrap();
            assert!(
                (value / truth - 1.0).abs() < 0.05,
                "{name}: {value} {truth}"
            );
        }
    }
}

/// Friction of 5 in the direction of the motion, on a constant force of 48.
#[test]
fn friction_on_a_large_offset_keeps_its_sign() {
    let velocities: Vec<f64> = (0..40).map(|k| 0.1 * (f64::from(k) - 19.5)).collect();
    let friction: Vec<f64> = velocities.iter().map(|v| 48.0 + 5.0 * v.signum()).collect();
    let log = FitColumns {
        velocities,
        friction,
        has_offset: true,
        ..FitColumns::default()
    };
    let found = log.prepared(Some(FitLaw::Coulomb)).unwrap();
    assert!(!found.is_signed_by_velocity);
    let machine = Apparatus {
        offset: true,
        ..Apparatus::default()
    };
    let model = FitLaw::Coulomb.model_on(&found.data, machine).unwrap();
    let fit = found
        .data
        .fit(model.as_ref(), &FitOptions::default())
        .unwrap();
    for (name, truth) in [("mu", 5.0), ("offset", 48.0)] {
        let value = fit.value(name).unwrap();
        assert!((value - truth).abs() < 1e-9, "{name}: {value}");
    }
}
