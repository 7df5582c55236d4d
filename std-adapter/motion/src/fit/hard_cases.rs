//! Data of extreme scale, odd values or many points.

use super::*;
use tribos_base::random::Random;
use tribos_core::law::{
    Bristle, DryFriction, LocalLaw, LuGre, LuGreParameters, Stribeck, StribeckParameters,
};

fn found(law: FitLaw, data: &Measurements) -> Result<Fit, FitError> {
    data.fit(law.model(data)?.as_ref(), &FitOptions::default())
}

/// 0.3 √v with a scatter of 1 %, in some unit of force.
fn root(unit: f64, sigma: Option<f64>) -> Measurements {
    let speeds: Vec<f64> = (1..=40).map(|k| 0.1 * f64::from(k)).collect();
    let scatter = |k: usize| 1.0 + 0.01 * ((k * 7 % 11) as f64 / 5.0 - 1.0);
    let friction = speeds.iter().enumerate();
    let friction = friction.map(|(k, v)| unit * (0.3 * v.sqrt() * scatter(k)));
    let sigma = sigma.map(|sigma| vec![unit * sigma; speeds.len()]);
    Measurements::steady(speeds.clone(), friction.collect(), sigma).unwrap()
}

#[test]
fn a_fit_does_not_depend_on_the_unit_of_force() {
    for sigma in [None, Some(0.003)] {
        let one = found(FitLaw::Power, &root(1.0, sigma)).unwrap();
        let error = |fit: &Fit, k: usize| match fit.parameters[k].known {
            Uncertainty::StandardError(error) => error,
            ref other => panic!("{other:?}"),
        };
        // Powers of two and of ten, to where squares overflow and vanish.
        for unit in [
            2.0_f64.powi(900),
            2.0_f64.powi(-900),
            1e200,
            1e-160,
            1e-280,
            1e280,
        ] {
            let scaled = found(FitLaw::Power, &root(unit, sigma)).unwrap();
            let [gamma, alpha] = [0, 1].map(|k| scaled.parameters[k].value);
            assert!(
                (gamma / unit / one.parameters[0].value - 1.0).abs() < 1e-9,
                "{unit:e}"
            );
            assert!((alpha - one.parameters[1].value).abs() < 1e-9, "{unit:e}");
            assert!(
                (error(&scaled, 0) / unit / error(&one, 0) - 1.0).abs() < 1e-6,
                "{unit:e}"
            );
            assert!(
                (error(&scaled, 1) / error(&one, 1) - 1.0).abs() < 1e-6,
                "{unit:e}"
            );
            let deviation = scaled.deviation() / if sigma.is_some() { 1.0 } else { unit };
            assert!((deviation / one.deviation() - 1.0).abs() < 1e-6, "{unit:e}");
            assert!(
                scaled.converged && scaled.at_best == scaled.starts,
                "{scaled:?}"
            );
        }
    }
}

#[test]
fn magnitudes_beyond_the_domain_are_refused() {
    for (v, f) in [(1.0, 1e-295), (1.0, 1e300), (1e-300, 1.0), (1e300, 1.0)] {
        let refused = Measurements::steady(vec![1.0, v, 2.0], vec![f; 3], None);
        assert!(matches!(refused, Err(FitError::Whole(words)) if words.contains("unit")));
    }
}

/// Numbers of all magnitudes, alike now and then.
fn odd(random: &mut Random) -> f64 {
    const USUAL: [f64; 6] = [1.0, 0.0, 1e-300, 1e300, f64::MIN_POSITIVE, 5e-324];
    match random.unit() {
        u if u < 0.3 => USUAL[(u / 0.3 * USUAL.len() as f64) as usize],
        u if u < 0.6 => 10.0_f64.powf(600.0 * (u - 0.45) / 0.3),
        u => (u - 0.6) / 0.4,
    }
}

#[test]
fn odd_data_end_in_a_fit_or_a_refusal() {
    let laws = [
        FitLaw::Stribeck,
        FitLaw::LuGre,
        FitLaw::Power,
        FitLaw::RateState,
        FitLaw::RateStateSlip,
    ];
    let options = FitOptions {
        starts: 3,
        ..FitOptions::default()
    };
    let (mut fits, mut refusals) = (0, 0);
    for seed in 0..400 {
        let mut random = Random::new(seed, 5);
        let count = 1 + (12.0 * random.unit()) as usize;
        let mut column = || (0..count).map(|_| odd(&mut random)).collect::<Vec<f64>>();
        let (mut v, mut f, sigma, mut t) = (column(), column(), column(), column());
        match seed % 4 {
            0 => f = vec![f[0]; count],
            1 => v = vec![v[0]; count],
            _ => {}
        }
        let sigma = (seed % 3 == 0).then_some(sigma);
        let steady = Measurements::steady(v.clone(), f.clone(), sigma.clone());
        t.sort_by(f64::total_cmp);
        let record = Measurements::series(t, v, f, sigma);
        for data in [steady, record].into_iter().flatten() {
            for law in laws {
                let ended = law
                    .model(&data)
                    .and_then(|model| data.fit(model.as_ref(), &options));
                match ended {
                    Ok(_) => fits += 1,
                    Err(_) => refusals += 1,
                }
            }
        }
    }
    // Some of either kind, or nothing was tried.
    assert!(fits > 100 && refusals > 100, "{fits} {refusals}");
}

/// As the model of a law, but always with all points.
struct Whole<'a>(Box<dyn Model + 'a>);

impl Model for Whole<'_> {
    fn parameters(&self) -> &[FitParameter] {
        self.0.parameters()
    }
    fn reference(&self, parameter: usize) -> Option<f64> {
        self.0.reference(parameter)
    }
    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        self.0.predict(values)
    }
    fn start(&self, unit: &[f64]) -> Vec<f64> {
        self.0.start(unit)
    }
    fn is_linear(&self, parameter: usize) -> bool {
        self.0.is_linear(parameter)
    }
    fn above(&self, parameter: usize) -> Option<usize> {
        self.0.above(parameter)
    }
    fn limits(&self, parameter: usize) -> [f64; 2] {
        self.0.limits(parameter)
    }
    fn along(&self, path: Between) -> Option<Box<dyn Model + '_>> {
        Some(Box::new(Whole(self.0.along(path)?)))
    }
}

/// Checks that a search on a sample, refined on all points, finds the minimum of searches on all points.
fn assert_same_minimum(law: FitLaw, data: &Measurements) {
    let sampled = found(law, data).unwrap();
    assert!(
        sampled.searched < data.friction().len(),
        "{}",
        sampled.searched
    );
    let options = FitOptions {
        starts: 2,
        ..FitOptions::default()
    };
    let whole = Whole(law.model(data).unwrap());
    let all = data.fit(&whole, &options).unwrap();
    assert_eq!(all.searched, data.friction().len());
    assert!((sampled.cost / all.cost - 1.0).abs() < 1e-9);
    for (a, b) in sampled.parameters.iter().zip(&all.parameters) {
        let Uncertainty::StandardError(error) = b.known else {
            panic!("{b:?}")
        };
        assert!((a.value - b.value).abs() < 1e-5 * error, "{a:?} {b:?}");
    }
    assert_eq!(found(law, data).unwrap(), sampled);
}

#[test]
fn many_points_end_at_the_minimum_of_searches_on_all_of_them() {
    let law = Stribeck::new(StribeckParameters {
        dry: DryFriction::new(0.15, 0.08).unwrap(),
        speed: 0.02,
        exponent: 1.5,
        viscous: 0.1,
    })
    .unwrap();
    let mut random = Random::new(3, 0);
    let speeds: Vec<f64> = (0..20_000)
        .map(|_| 10.0_f64.powf(-3.0 * random.unit()))
        .collect();
    let friction = speeds.iter();
    let friction = friction
        .map(|&v| law.friction(v) + 0.01 * (random.unit() - 0.5))
        .collect();
    assert_same_minimum(
        FitLaw::Stribeck,
        &Measurements::steady(speeds, friction, None).unwrap(),
    );
}

#[test]
fn a_long_record_ends_at_the_minimum_of_searches_on_all_of_it() {
    let joint = LuGre::new(LuGreParameters {
        coulomb_force: 1.0,
        static_force: 1.5,
        stribeck_speed: 0.01,
        stiffness: 1e4,
        bristle_damping: 30.0,
        viscous_damping: 10.0,
    })
    .unwrap();
    let mut random = Random::new(4, 0);
    let times: Vec<f64> = (0..4200).map(|k| 0.002 * f64::from(k)).collect();
    let velocities: Vec<f64> = times.iter().map(|t| 0.03 * (5.0 * t).sin()).collect();
    let (mut bristle, mut forces) = (Bristle::RELAXED, vec![0.0]);
    for (t, v) in times.windows(2).zip(velocities.windows(2)) {
        bristle = joint.step(bristle, 0.5 * (v[0] + v[1]), t[1] - t[0]).0;
        forces.push(joint.force(bristle, v[1]) + 0.02 * (random.unit() - 0.5));
    }
    let data = Measurements::series(times, velocities, forces, None).unwrap();
    assert_same_minimum(FitLaw::LuGre, &data);
}
