//! Curling rocks under each model: what is known in closed form, from independent integrations,
//! and what each model promises of the curl.

use tribos::slide::curling::{
    BackHeavy, CurlingModel, CurlingRock, Dry, Film, FilmRing, FrontBack, IceLaw, LeftRight,
    PivotSlide, ScratchGuide,
};
use tribos::slide::planar::{Launch, PlanarResult, PlanarSimulation, Resistance};
use tribos_tests::pucks::relative;

/// Hog line to tee, m.
const SHEET: f64 = 28.35;
/// Laws of ice rest; the fraction plays no part.
const STOP_FRACTION: f64 = 1e-4;

fn shot(model: &dyn CurlingModel, speed: f64, spin: f64) -> PlanarResult {
    let body = model.resistance(&CurlingRock::STANDARD).unwrap();
    let launch = Launch {
        velocity: [speed, 0.0],
        spin,
    };
    PlanarSimulation::new(&body, &launch, STOP_FRACTION)
        .unwrap()
        .to_end()
        .unwrap()
}

fn curl(model: &dyn CurlingModel, spin: f64) -> f64 {
    shot(model, 1.9866, spin).point.position[1]
}

#[test]
fn rocks_without_spin_stop_where_the_closed_form_says() {
    // dv/dt = −γ g v^α: x = v^(2−α)/((2−α) γ g), T = v^(1−α)/((1−α) γ g). The numbers are the
    // stop after 28.35 m and the 21.95 m from hog line to hog line.
    for (ice, speed, time, split, passing) in [
        (IceLaw::PENNER, 1.9866, 23.785, Some(14.047), Some(1.0953)),
        (IceLaw::DRAW, 2.0131, 25.917, Some(14.373), None),
    ] {
        let model = LeftRight { ice };
        let (beta, rate) = (1.0 - ice.alpha, ice.coefficient * 9.81);
        let exact = |v: f64| {
            [
                v.powf(1.0 + beta) / ((1.0 + beta) * rate),
                v.powf(beta) / (beta * rate),
            ]
        };
        let end = shot(&model, speed, 0.0).point;
        let [x, t] = exact(speed);
        assert!(relative(end.position[0], x) < 1e-12 && relative(end.time, t) < 1e-12);
        assert!(relative(x, SHEET) < 1e-4 && (t - time).abs() < 2e-3);
        // From the first hog line, 28.35 m before the tee, 21.95 m to the second.
        let body = model.resistance(&CurlingRock::STANDARD).unwrap();
        let launch = Launch {
            velocity: [speed, 0.0],
            spin: 0.0,
        };
        let times: Vec<f64> = (1..30_000).map(|k| 1e-3 * f64::from(k)).collect();
        let mut line = None;
        PlanarSimulation::new(&body, &launch, STOP_FRACTION)
            .unwrap()
            .follow(&times, |point| {
                if line.is_none() && point.position[0] >= 21.95 {
                    line = Some((point.time, point.velocity[0]));
                }
            })
            .unwrap();
        let (crossing, velocity) = line.unwrap();
        assert!(
            split.is_none_or(|split| (crossing - split).abs() < 3e-3),
            "{crossing}"
        );
        assert!(
            passing.is_none_or(|v| (velocity - v).abs() < 2e-3),
            "{velocity}"
        );
    }
}

#[test]
fn spinners_go_farther_and_dead_straight_on_pure_friction() {
    // An independent integration of the ring with steps of 2 ms, launched at 1.987 m/s.
    let model = LeftRight {
        ice: IceLaw::PENNER,
    };
    for (spin, distance, time) in [
        (0.5, 28.370, 23.87),
        (1.5, 28.418, 24.25),
        (3.0, 28.603, 25.19),
    ] {
        let end = shot(&model, 1.987, spin).point;
        assert!((end.position[0] - distance).abs() < 6e-3, "{:?}", end);
        assert!((end.time - time).abs() < 1.5e-2, "{:?}", end);
        assert_eq!(end.position[1], 0.0);
    }
}

#[test]
fn a_real_band_is_nearly_its_mean_ring() {
    let ice = IceLaw::PENNER;
    // 5 mm wide about 6.25 cm; the inertia is the same.
    let outer = 0.065;
    let band = CurlingRock {
        band_radius: outer,
        band_width: 0.005,
        inertia_ratio: 0.5 * (0.145 / outer) * (0.145 / outer),
        ..CurlingRock::STANDARD
    };
    let body = LeftRight { ice }.resistance(&band).unwrap();
    let launch = Launch {
        velocity: [1.9866, 0.0],
        spin: 3.0,
    };
    let end = PlanarSimulation::new(&body, &launch, STOP_FRACTION)
        .unwrap()
        .to_end()
        .unwrap()
        .point;
    let ring = shot(&LeftRight { ice }, 1.9866, 3.0).point;
    assert!(relative(end.position[0], ring.position[0]) < 2e-4);
    assert!(relative(end.time, ring.time) < 2e-3);
}

#[test]
fn rocks_that_lean_forward_curl_the_wrong_way_and_hardly() {
    let ice = IceLaw::PENNER;
    let dry = Dry {
        coefficient: IceLaw::DRY.coefficient,
    };
    for model in [&dry as &dyn CurlingModel, &FrontBack { ice }] {
        let [slow, fast] = [0.75, 3.0].map(|spin| curl(model, spin));
        assert!(fast < slow && slow < -1e-3 && fast > -0.03, "{model:?}");
        assert_eq!(curl(model, -3.0), -fast);
    }
}

#[test]
fn no_asymmetry_of_the_back_curls_a_metre_at_playing_spin() {
    let heavy = |back_to_front| BackHeavy {
        ice: IceLaw::PENNER,
        back_to_front,
    };
    // In proportion to the spin, and even with no friction at all in front below a metre.
    for ratio in [2.0, 10.0, 100.0, f64::INFINITY] {
        let [slow, draw] = [0.75, 1.5].map(|spin| curl(&heavy(ratio), spin));
        assert!(
            (1.9..2.2).contains(&(draw / slow)),
            "{ratio}: {slow} {draw}"
        );
        assert!(draw > 0.0 && draw < 0.5, "{ratio}: {draw}");
    }
    assert!(curl(&heavy(10.0), 4.2) > 1.0);
    // Without asymmetry it is the symmetric law.
    assert_eq!(curl(&heavy(1.0), 1.5), 0.0);
}

#[test]
fn a_dragged_film_curls_too_little() {
    let film = |front, back| Film {
        ice: IceLaw::PENNER,
        front,
        back,
    };
    let [slow, fast] = [0.75, 3.0].map(|spin| curl(&film(1.0, 0.0), spin));
    assert!(slow > 0.05 && fast < 0.6 && (3.8..4.2).contains(&(fast / slow)));
    assert_eq!(curl(&film(1.0, 0.0), -3.0), -fast);
    // A film that stays with the ice is the plain law.
    let plain = shot(
        &LeftRight {
            ice: IceLaw::PENNER,
        },
        1.9866,
        1.5,
    )
    .point;
    let still = shot(&film(0.0, 0.0), 1.9866, 1.5).point;
    assert!(relative(still.position[0], plain.position[0]) < 1e-5);
    assert!(still.position[1].abs() < 1e-6);
}

#[test]
fn the_rule_of_the_film_is_as_accurate_as_it_says() {
    let ice = IceLaw::PENNER;
    let film = Film {
        ice,
        front: 0.0,
        back: 0.0,
    };
    let rule = FilmRing::new(&film, &CurlingRock::STANDARD).unwrap();
    let exact = LeftRight { ice }
        .resistance(&CurlingRock::STANDARD)
        .unwrap();
    let error = |velocity| {
        let (a, b) = (rule.deceleration(velocity), exact.deceleration(velocity));
        (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max) / b[0].hypot(b[2])
    };
    for velocity in [
        [1.0, 0.0, 0.1],
        [0.3, 0.4, 0.4],
        [0.0, -1.0, 1.2],
        [1.0, 0.0, 0.9],
        [0.1, 0.0, 1.0],
    ] {
        assert!(
            error(velocity) < 1e-12,
            "{velocity:?}: {:e}",
            error(velocity)
        );
    }
    for rim in [0.95, 1.05] {
        assert!(error([1.0, 0.0, rim]) < 1e-6, "{rim}");
    }
    let near = (0..=100).map(|k| error([1.0, 0.0, 0.95 + 1e-3 * f64::from(k)]));
    let worst = near.fold(0.0, f64::max);
    assert!((1e-2..4e-2).contains(&worst), "{worst:e}");
}

#[test]
fn pivots_curl_less_the_faster_the_spin() {
    // A Runge–Kutta integration of its own, 720 points on the ring, steps of 2 ms.
    let model = PivotSlide {
        ice: IceLaw::PENNER,
        weight: PivotSlide::WEIGHT,
    };
    for (spin, expected) in [(0.75, 1.040), (1.5, 0.666), (3.0, 0.459)] {
        let value = curl(&model, spin);
        assert!((value - expected).abs() < 5e-3, "{spin}: {value}");
    }
}

#[test]
fn guiding_scratches_curl_a_metre_whatever_the_spin() {
    let model = ScratchGuide {
        ice: IceLaw::PENNER,
        strength: ScratchGuide::STRENGTH,
        onset: ScratchGuide::ONSET,
    };
    let curls = [0.75, 1.5, 3.0].map(|spin| curl(&model, spin));
    for value in curls {
        assert!((0.9..1.1).contains(&value), "{curls:?}");
    }
    assert!(curls[2] / curls[0] < 1.1);
    assert_eq!(curl(&model, -1.5), -curls[1]);
}
