//! Synthetic pushes with a known pressure.

use super::*;
use tribos_base::random::Random;
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::patch::outline::Polygon;

/// A motion in any direction, turning about places near and far.
fn motion(random: &mut Random) -> Twist<f64> {
    let mut part = || 2.0 * random.unit() - 1.0;
    Twist::new(part(), part(), 15.0 * part())
}

/// Pushes of feet with the friction limits 1, 2 and 1 N, with an error of so much of the force in each part.
fn pushes_of_feet(noise: f64) -> (Vec<Node<f64>>, Vec<MeasuredPush>) {
    let feet = [[-0.04, -0.02, 1.0], [0.06, -0.03, 2.0], [-0.02, 0.07, 1.0]];
    let feet = feet.map(|[x, y, weight]| Node { x, y, weight }).to_vec();
    let mut random = Random::new(1, 0);
    let one = |_| {
        let motion = motion(&mut random);
        let mut push = Wrench::ZERO;
        for Node { x, y, weight } in &feet {
            let (u, v) = (
                motion.velocity.x - motion.spin * y,
                motion.velocity.y + motion.spin * x,
            );
            let share = weight / u.hypot(v);
            push += Wrench::new(share * u, share * v, share * (x * v - y * u));
        }
        let mut error = |scale: f64| noise * scale * (2.0 * random.unit() - 1.0);
        let wrench = push + Wrench::new(error(4.0), error(4.0), error(0.3));
        MeasuredPush { motion, wrench }
    };
    let pushes = (0..60).map(one).collect();
    (feet, pushes)
}

fn named<'a>(fit: &'a SupportFit, name: &str) -> &'a Score {
    fit.models.iter().find(|score| score.name == name).unwrap()
}

#[test]
fn the_loads_of_known_feet_come_back() {
    let (feet, pushes) = pushes_of_feet(0.0);
    let fit = SupportFit::at(&pushes, &feet).unwrap();
    for (found, foot) in fit.pressure.iter().zip(&feet) {
        assert!((found.weight / foot.weight - 1.0).abs() < 1e-3, "{found:?}");
    }
    let [x, y] = fit.centre_of_pressure;
    assert!(
        (x - 0.015).abs() < 1e-5 && (y + 0.0025).abs() < 1e-5,
        "{x} {y}"
    );
    assert!(named(&fit, "known").median < 1e-3);
    assert!(named(&fit, "pressure").median < 0.1);
    assert!(named(&fit, "quartic").median < named(&fit, "ellipsoid").median);
}

#[test]
fn an_unknown_foot_has_its_centre_of_pressure_and_noise_spoils_little() {
    for (noise, off, angle) in [(0.0, 1e-3, 3.0), (0.05, 4e-3, 8.0)] {
        let (_, pushes) = pushes_of_feet(noise);
        let fit = SupportFit::new(&pushes, None).unwrap();
        let [x, y] = fit.centre_of_pressure;
        assert!((x - 0.015).hypot(y + 0.0025) < off, "{noise}: {x} {y}");
        assert!((fit.force_limit - 4.0).abs() < 0.2, "{noise}");
        let found = named(&fit, "pressure").median;
        assert!(found < angle, "{noise}: {found}");
        assert_eq!(fit, SupportFit::new(&pushes, None).unwrap());
    }
}

#[test]
fn a_leaning_pressure_has_its_centre() {
    let corners = [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]];
    let leaning = Polygon::new(corners).unwrap();
    let leaning = leaning.with_centre_of_pressure([0.02, -0.005]).unwrap();
    let friction = ShapeFriction::new(leaning, 0.5).unwrap();
    let mut random = Random::new(2, 0);
    let one = |_| {
        let motion = motion(&mut random);
        let wrench = -friction.wrench(8.0, &motion);
        MeasuredPush { motion, wrench }
    };
    let pushes: Vec<MeasuredPush> = (0..80).map(one).collect();
    let patch = "box:0.2x0.1".parse().unwrap();
    let fit = SupportFit::new(&pushes, Some(&patch)).unwrap();
    let [x, y] = fit.centre_of_pressure;
    assert!((x - 0.02).hypot(y + 0.005) < 1e-3, "{x} {y}");
    assert!((fit.force_limit - 4.0).abs() < 0.04);
    // The fitted pressure foretells better than the uniform one.
    assert!(named(&fit, "pressure").median < 0.5 * named(&fit, "known").median);
}

#[test]
fn a_quartic_answers_motions_with_the_pushes_that_cause_them() {
    let (_, pushes) = pushes_of_feet(0.0);
    let quartic = ConvexQuartic::fitted(&pushes).unwrap();
    let motion = Twist::new(0.3, -0.7, 4.0);
    let push = quartic.push(&motion);
    let row = &rows(
        &[MeasuredPush {
            motion,
            wrench: push,
        }],
        quartic.length,
    )[0];
    assert!(off(&quartic.form, row) < 1e-6);
    // It lies on the surface: twice the motion needs the same push.
    let same = quartic.push(&(motion * 2.0));
    assert!((same.force - push.force).norm() < 1e-12);
}

#[test]
fn what_cannot_be_used_is_refused() {
    let (feet, pushes) = pushes_of_feet(0.0);
    let told = |pushes: &[MeasuredPush]| SupportFit::new(pushes, None).unwrap_err().to_string();
    assert!(told(&pushes[..9]).contains("at least 10"));
    let mut wrong = pushes.clone();
    wrong[3].motion = Twist::ZERO;
    assert!(told(&wrong).contains("must not be zero"));
    wrong[3].motion = Twist::new(f64::NAN, 0.0, 0.0);
    assert!(told(&wrong).contains("must be finite"));
    let straight: Vec<MeasuredPush> = pushes
        .iter()
        .map(|push| MeasuredPush {
            wrench: Wrench::new(1.0, 0.0, 0.0),
            ..*push
        })
        .collect();
    assert!(told(&straight).contains("torque"));
    let disk = "disk".parse().unwrap();
    assert!(SupportFit::new(&pushes, Some(&disk)).is_err());
    let none: Vec<Node<f64>> = feet.iter().map(|f| Node { weight: 0.0, ..*f }).collect();
    assert!(SupportFit::at(&pushes, &none).is_err());
}
