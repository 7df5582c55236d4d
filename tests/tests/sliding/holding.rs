//! Bodies on their patches: what friction holds rests for ever, what it does not stops where it should.

use nalgebra::{Vector2, Vector3};
use tribos_core::contact::{
    Cohesion, ContactBody, ContactFriction, ContactGeometry, IndependentFriction, NormalLaw,
    SphereBody, TimeStep, WallBody,
};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::manifold::{ContactSystem, InitialGuess, SolverSettings};
use tribos_core::patch::nodes::NodeList;
use tribos_core::planar::{PlanarBody, PointContacts};
use tribos_core::real::Real;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_core::twist::{Twist, Wrench};

/// Steps of the scenes in which nothing may move.
const STEPS: usize = 1_000_000;

fn push<R: Real>(x: f64, y: f64, torque: f64) -> Wrench<R> {
    Wrench::new(R::from_f64(x), R::from_f64(y), R::from_f64(torque))
}

fn at_rest<R: Real>() -> Twist<R> {
    Twist::ZERO
}

/// A puck on a slope just below the angle at which it slides, with and without a torque.
fn held_on_a_slope<R: Real>() {
    let [mass, radius, weight] = [0.17, 0.04, 0.17 * 9.81];
    let puck = PlanarBody::new(R::from_f64(mass), R::from_f64(0.5 * mass * radius * radius));
    let puck = puck.expect("positive");
    let limit = 0.3 * weight;
    let set = RoundLimitSurface::new(CoulombDisk, R::from_f64(limit), R::from_f64(radius))
        .expect("valid");
    let dt = TimeStep::new(R::from_f64(1.0 / 60.0)).expect("positive");
    for (along, torque) in [(0.9999, 0.0), (0.0, 0.9999), (0.6, 0.6)] {
        let direction = 0.7_f64;
        let held = push(
            along * limit * direction.cos(),
            along * limit * direction.sin(),
            torque * limit * radius * 2.0 / 3.0,
        );
        let mut twist = at_rest::<R>();
        for _ in 0..STEPS {
            let step = puck.step(&set, &twist, &held, dt);
            twist = step.twist;
            assert!(step.is_at_rest && twist == at_rest(), "{twist:?}");
        }
        // As much beyond the limit as before below it, and it moves.
        let beyond = R::from_f64(1.0002) / set.gauge(&held);
        let more = held * beyond;
        assert!(!puck.step(&set, &twist, &more, dt).is_at_rest);
    }
}

#[test]
fn a_puck_held_on_a_slope_does_not_creep_in_a_million_steps() {
    held_on_a_slope::<f64>();
    held_on_a_slope::<f32>();
}

/// A square box of side 0.2 m and 1 kg; friction carries 3 N.
fn box_on_the_floor() -> (PlanarBody<f64>, PointContacts<f64, NodeList<f64, 224>, 224>) {
    let corners = [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]];
    let points: NodeList<f64, 224> = NodeList::polygon(&corners, 4).expect("a square");
    let body = PlanarBody::new(1.0, 0.2 * 0.2 / 6.0).expect("positive");
    (body, PointContacts::new(points, 3.0).expect("it fits"))
}

#[test]
fn a_box_held_by_its_foot_does_not_creep_in_a_million_steps() {
    let (body, mut foot) = box_on_the_floor();
    let dt = TimeStep::new(1.0 / 60.0).expect("positive");
    let held = push(2.0, -1.5, 0.1);
    let mut twist = at_rest();
    for _ in 0..STEPS {
        let step = body.step_on_points(&mut foot, &twist, &held, dt);
        twist = step.twist;
        assert!(step.is_at_rest && twist == at_rest());
    }
    let pushed = push(2.5, -1.8, 0.0); // 3.08 N
    assert!(
        !body
            .step_on_points(&mut foot, &twist, &pushed, dt)
            .is_at_rest
    );
}

#[test]
fn a_box_stops_after_the_same_way_in_every_direction() {
    let dt = 1.0 / 250.0;
    for n in 0..48 {
        let angle = core::f64::consts::TAU * f64::from(n) / 48.0;
        let (sin, cos) = angle.sin_cos();
        let (body, mut foot) = box_on_the_floor();
        let mut twist = Twist::new(cos, sin, 0.0);
        let mut place = Vector2::new(0.0, 0.0);
        let mut time = 0.0;
        while twist != at_rest() {
            let step = TimeStep::new(dt).expect("positive");
            let after = body.step_on_points(&mut foot, &twist, &Wrench::ZERO, step);
            place += (twist.velocity + after.twist.velocity) * (0.5 * dt);
            twist = after.twist;
            time += dt;
            assert!(time < 1.0);
        }
        // v²/(2 μ g) with a deceleration of 3 m/s2; the last step is of first order.
        let along = place.x * cos + place.y * sin;
        let across = place.y * cos - place.x * sin;
        assert!(
            (along - 1.0 / 6.0).abs() < 3.0 * dt * dt,
            "{angle}: {along}"
        );
        assert!(across.abs() < 1e-13, "{angle}: {across}");
        assert!((time - 1.0 / 3.0).abs() <= dt, "{angle}: {time}");
    }
}

/// Travel and time to rest of a puck in steps of `dt`; in its last step, which is of first order, the
/// share of the friction that it needs tells the time.
fn thrown(dt: f64, speed: f64, spin: f64) -> [f64; 2] {
    let radius = 0.08;
    let puck = PlanarBody::new(1.0, 0.5 * radius * radius).expect("positive");
    let set = RoundLimitSurface::new(CoulombDisk, 3.0, radius).expect("valid");
    let step = TimeStep::new(dt).expect("positive");
    let (mut twist, mut way, mut time) = (Twist::new(speed, 0.0, spin), 0.0, 0.0);
    loop {
        let after = puck.step(&set, &twist, &Wrench::ZERO, step);
        if after.is_at_rest {
            let share = set.gauge(&after.friction);
            return [way + 0.5 * twist.velocity.x * share * dt, time + share * dt];
        }
        way += 0.5 * dt * (twist.velocity.x + after.twist.velocity.x);
        twist = after.twist;
        time += dt;
    }
}

#[test]
fn spin_down_ends_where_and_when_it_should_to_second_order() {
    for (speed, spin) in [
        (0.0, 40.0),
        (1.0, 0.0),
        (1.0, 5.0),
        (1.0, 12.5),
        (0.5, 40.0),
    ] {
        let slider = Slider::new(
            CoulombDisk,
            SliderParameters {
                deceleration: 3.0,
                radius: 0.08,
                inertia_ratio: 0.5,
            },
        )
        .expect("valid");
        let rest = slider
            .to_rest(&SliderState::launched(speed, spin))
            .expect("it stops");
        let errors = [60.0, 240.0, 960.0].map(|rate| {
            let [way, time] = thrown(1.0 / rate, speed, spin);
            [
                (way - rest.motion.distance).abs() / (0.5 * 0.08),
                (time - rest.motion.time).abs() / rest.motion.time,
            ]
        });
        println!("{speed} m/s, {spin} rad/s: {errors:?}");
        // A tenth of the square of the step in units of v/(μg), 1/3 s.
        for (rate, error) in [60.0, 240.0, 960.0].into_iter().zip(errors) {
            let bound = 0.1 * (3.0_f64 / rate).powi(2) + 1e-13;
            assert!(error[0] < bound && error[1] < bound, "{rate} Hz: {error:?}");
        }
    }
}

/// A ball between two plates that press it, under its weight: what a gripper holds.
fn pinched<R: Real, F: ContactFriction<R>>(friction: F, margin: f64) {
    let real = R::from_f64;
    let law = NormalLaw::new(Cohesion::NONE, R::ZERO).expect("valid");
    let mut grip = ContactSystem::<R, F, 3, 2>::new(law, friction);
    let (mass, radius, mu) = (0.5, 0.05, 0.5);
    let vector = |x, y, z| Vector3::new(real(x), real(y), real(z));
    let still = vector(0.0, 0.0, 0.0);
    let ball = grip.push_sphere(SphereBody {
        velocity: still,
        spin: still,
        inv_mass: real(1.0 / mass),
        inv_inertia: real(2.5 / (mass * radius * radius)),
    });
    let ball = ball.expect("room");
    // Two pads that each carry half the weight, times the margin.
    let press = margin * 0.5 * mass * 9.81 / mu;
    for side in [1.0, -1.0] {
        let inv_mass = real(1.0);
        let plate = WallBody {
            velocity: still,
            inv_mass,
        };
        let plate = grip.push_plate(plate).expect("room");
        grip.set_force(plate, vector(press * side, 0.0, 0.0), still)
            .expect("it is there");
        let touch = ContactGeometry::plate(real(radius), &vector(side, 0.0, 0.0), real(radius));
        grip.push_contact(ball, plate, touch.expect("valid"))
            .expect("room");
    }
    grip.set_gravity(vector(0.0, 0.0, -9.81));
    let step = TimeStep::new(real(1.0 / 240.0)).expect("positive");
    let stop = SolverSettings {
        max_iterations: 40,
        tolerance: real(1e-6),
    };
    let mut moved = Vector3::new(R::ZERO, R::ZERO, R::ZERO);
    let mut fastest = R::ZERO;
    for n in 0..STEPS {
        grip.solve(step, InitialGuess::Last, stop);
        let body = grip.body(ball).expect("it is there");
        let rolled = body.angular_velocity() * real(radius);
        let motion = [body.velocity(), rolled].map(|v| v.x.hypot(v.y).hypot(v.z));
        // After the pads have been pressed on.
        if n >= 100 {
            fastest = motion
                .into_iter()
                .fold(fastest, |a, b| if b > a { b } else { a });
        }
        moved += body.velocity() * step.dt() + rolled * step.dt();
    }
    // Where both modes stick the update may alternate between neighbouring impulses.
    let weight = real(9.81) * step.dt();
    println!(
        "margin {margin}: {:?} of g dt at most, moved {moved:?} m",
        fastest / weight
    );
    assert!(fastest <= R::EPSILON * weight, "{fastest:?}");
    assert!(
        moved.z.abs() < real(1e-11) && moved.x.abs() < real(1e-8),
        "{moved:?}"
    );
}

#[test]
fn a_pinched_ball_does_not_creep_in_a_million_steps() {
    for margin in [1.01, 1.03, 1.05, 20.0, 95.0] {
        let sliding = IndependentFriction::sliding(0.5).expect("valid");
        pinched::<f64, _>(sliding, margin);
        let all = IndependentFriction::all(0.5, 0.01, 0.01).expect("valid");
        pinched::<f64, _>(all, margin);
        let sliding = IndependentFriction::sliding(0.5).expect("valid");
        pinched::<f32, _>(sliding, margin);
    }
}
