use super::*;

fn start(outcome: &TurntableSummary) -> Option<SlipStart> {
    let (time, rate) = (outcome.release_time?, outcome.release_rate?);
    Some(SlipStart { time, rate })
}

#[test]
fn a_small_body_lets_go_where_its_whole_acceleration_meets_friction() {
    for (mu, arm, spin_up) in [(0.4, 0.2, 1.0), (0.1, 0.4, 2.0), (0.9, 0.01, 300.0)] {
        let scene = TurntableScene {
            radius: 1e-6,
            gyration_radius: 1e-9,
            mu_static: mu,
            mu_dynamic: 0.05,
            distance: arm,
            table_angular_acceleration: spin_up,
            ..TurntableScene::default()
        };
        let release = start(&scene.run().unwrap().outcome).unwrap();
        // r √(Ω⁴ + α²) = μ_s g
        let limit: f64 = mu * 9.81 / arm;
        let expected = (limit * limit - spin_up * spin_up).sqrt().sqrt();
        assert!(
            (release.rate / expected - 1.0).abs() < 1e-9,
            "{release:?} {expected}"
        );
    }
}

/// A thin ring carries |F|, |T| with its elliptic integrals; near pure torque the limit is R μ m g.
#[test]
fn the_torque_of_the_spin_up_lets_a_wide_body_go_earlier() {
    let narrow = TurntableScene {
        gyration_radius: 1e-9,
        table_angular_acceleration: 5.0,
        ..TurntableScene::default()
    };
    let rates = [1e-9, 0.03, 0.1, 0.15].map(|gyration_radius| {
        let scene = TurntableScene {
            gyration_radius,
            ..narrow.clone()
        };
        scene.run().unwrap().outcome.release_rate.unwrap()
    });
    assert!(rates.windows(2).all(|pair| pair[1] < pair[0]), "{rates:?}");
    // I α above the torque (2/3) R μ_s m g that a disk carries: it turns at once.
    let wide = TurntableScene {
        gyration_radius: (2.0 / 3.0 * 0.03 * 0.4 * 9.81 / 5.0_f64).sqrt() * 1.001,
        ..narrow
    };
    assert_eq!(wide.run().unwrap().outcome.release_rate.unwrap(), 0.0);
}

#[test]
fn it_rests_on_the_table_to_the_bit_until_it_lets_go() {
    let result = TurntableScene::default().run().unwrap();
    let release = start(&result.outcome).unwrap();
    let held = result.rows.iter().filter(|row| row[0] <= release.time);
    assert!(held.clone().count() > 100);
    for row in held {
        let [_, _, x, y, vx, vy, spin, angle, ..] = *row;
        assert_eq!([x, y, vx, vy, spin, angle], [0.2, 0.0, 0.0, 0.0, 0.0, 0.0]);
    }
}

/// Without friction the path in the room is the tangent of the circle.
#[test]
fn almost_without_friction_it_leaves_along_the_tangent() {
    let scene = TurntableScene {
        mu_dynamic: 1e-9,
        time_step: 1e-4,
        samples: 2000,
        ..TurntableScene::default()
    };
    let result = scene.run().unwrap();
    let release = start(&result.outcome).unwrap();
    let turned = 0.5 * scene.table_angular_acceleration * release.time * release.time;
    let start = rotated(Vector2::new(scene.distance, 0.0), turned);
    let speed = rotated(Vector2::new(0.0, release.rate * scene.distance), turned);
    let mut seen = 0;
    for row in result.rows.iter().filter(|row| row[0] > release.time) {
        let room = start + speed * (row[0] - release.time);
        assert!(
            (Vector2::new(row[8], row[9]) - room).norm() < 1e-6,
            "{row:?} {room}"
        );
        seen += 1;
    }
    assert!(seen > 10);
}

/// A body without size on a quick table, by explicit midpoint steps of 2 µs in the room.
fn followed(scene: &TurntableScene, release: SlipStart) -> f64 {
    let dt = 2e-6;
    let pull = scene.mu_dynamic * scene.gravity;
    let mut time = release.time;
    let mut x = Vector2::new(scene.distance, 0.0);
    let mut v = Vector2::new(0.0, release.rate * scene.distance);
    let slowed = |time: f64, x: Vector2<f64>, v: Vector2<f64>| {
        let slip = v - Vector2::new(-x.y, x.x) * (scene.table_angular_acceleration * time);
        slip * (-pull / slip.norm().max(f64::MIN_POSITIVE))
    };
    while x.norm() < scene.table_radius {
        let half = slowed(time, x, v) * (0.5 * dt);
        let a = slowed(time + 0.5 * dt, x + v * (0.5 * dt), v + half);
        x += (v + a * (0.5 * dt)) * dt;
        v += a * dt;
        time += dt;
    }
    time
}

#[test]
fn a_body_leaves_a_quick_table_when_an_independent_integration_says_at_any_step() {
    let quick = TurntableScene {
        mu_static: 0.2,
        mu_dynamic: 0.05,
        radius: 1e-7,
        gyration_radius: 1e-9,
        distance: 0.05,
        table_angular_acceleration: 50.0,
        duration: 5.0,
        ..TurntableScene::default()
    };
    let release = start(&quick.run().unwrap().outcome).unwrap();
    let expected = followed(&quick, release);
    for (time_step, samples) in [(5e-4, 400), (1e-2, 400), (0.5, 7)] {
        let scene = TurntableScene {
            time_step,
            samples,
            ..quick.clone()
        };
        let left = scene.run().unwrap().outcome.leave_time.unwrap();
        assert!(
            (left - expected).abs() < 1e-5,
            "{time_step}: {left} {expected}"
        );
    }
}

#[test]
fn without_friction_a_body_keeps_its_straight_path_on_a_table_of_any_speed() {
    for spin_up in [1.0, 1e3, 1e5] {
        let scene = TurntableScene {
            mu_dynamic: 0.0,
            mu_static: 0.03 * spin_up,
            table_angular_acceleration: spin_up,
            time_step: 0.1,
            ..TurntableScene::default()
        };
        let outcome = scene.run().unwrap().outcome;
        let (release, left) = (start(&outcome), outcome.leave_time);
        // √(R² − r²) along the tangent, at Ω r.
        let (release, left) = (release.unwrap(), left.unwrap());
        let way = (0.5_f64 * 0.5 - 0.2 * 0.2).sqrt();
        let expected = release.time + way / (release.rate * scene.distance);
        assert!((left / expected - 1.0).abs() < 1e-12, "{left} {expected}");
    }
    // A table that starts with a jerk leaves the body where it is in the room.
    let jerked = TurntableScene {
        mu_dynamic: 0.0,
        mu_static: 0.01,
        table_angular_acceleration: 40.0,
        time_step: 0.1,
        ..TurntableScene::default()
    };
    let result = jerked.run().unwrap();
    assert_eq!(result.outcome.release_rate.unwrap(), 0.0);
    for row in &result.rows {
        assert_eq!(row[8..], [0.2, 0.0]);
    }
}

#[test]
fn a_wide_body_has_the_same_path_at_steps_of_any_length() {
    let left = |time_step: f64| {
        let scene = TurntableScene {
            time_step,
            samples: 1,
            patch: "box:0.06x0.02".parse().unwrap(),
            ..TurntableScene::default()
        };
        scene.run().unwrap().outcome
    };
    let fine = left(1e-5);
    for time_step in [4e-3, 1.0] {
        let coarse = left(time_step);
        for (a, b) in [(coarse.x, fine.x), (coarse.y, fine.y)] {
            assert!((a - b).abs() < 1e-6, "{coarse:?} {fine:?}");
        }
    }
}
