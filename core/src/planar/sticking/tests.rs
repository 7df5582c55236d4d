//! Static friction above kinetic friction, judged by the definition of the set and by motions that are integrated here.

extern crate std;

mod stick_slip;

use crate::contact::TimeStep;
use crate::coupling::coulomb::CoulombDisk;
use crate::law::{RestTime, StaticAgeing};
use crate::limit_surface::{FrictionSet, RoundLimitSurface, ShapeLimitSurface};
use crate::patch::nodes::{Node, Nodes};
use crate::patch::outline::{Edge, Polygon};
use crate::planar::{PlanarBody, PlanarStep, PointContacts};
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// Steps from a microsecond to a second.
const STEPS: [f64; 5] = [1e-6, 1e-4, 1e-2, 0.1, 1.0];
/// Static above kinetic friction.
const STRENGTH: f64 = 1.4;
/// Kinetic friction of the box, in N.
const LIMIT: f64 = 4.0;

type BoxSet<R> = ShapeLimitSurface<R, Polygon<R, [Edge<R>; 4]>>;

/// A box of 1 kg, 20 by 10 cm.
fn body<R: Real>() -> PlanarBody<R> {
    let inertia = (0.1 * 0.1 + 0.05 * 0.05) / 3.0;
    PlanarBody::new(R::ONE, R::from_f64(inertia)).unwrap()
}

/// Its face under even pressure.
fn face<R: Real>() -> BoxSet<R> {
    let corners = [[0.1, 0.05], [-0.1, 0.05], [-0.1, -0.05], [0.1, -0.05]];
    let corners = corners.map(|corner| corner.map(R::from_f64));
    ShapeLimitSurface::new(Polygon::new(corners).unwrap(), R::from_f64(LIMIT)).unwrap()
}

/// A number of −1 … 1 that golden angles and their like spread evenly.
fn part(i: u32, k: f64) -> f64 {
    2.0 * (f64::from(i) * k).fract() - 1.0
}

/// Motions in all directions, of which many turn.
fn motions<R: Real>(count: u32) -> impl Iterator<Item = Twist<R>> {
    (0..count).map(|i| {
        let [x, y] = [part(i, 0.754_877_666_25), part(i, 0.569_840_290_99)].map(R::from_f64);
        Twist::new(x, y, R::from_f64(20.0 * part(i, 0.819_172_513_4)))
    })
}

fn step_of<R: Real>(dt: f64) -> TimeStep<R> {
    TimeStep::new(R::from_f64(dt)).unwrap()
}

/// Twice the kinetic energy.
fn energy<R: Real>(body: &PlanarBody<R>, twist: &Twist<R>) -> R {
    let speed = twist.speed();
    body.mass() * speed * speed + body.inertia() * twist.spin * twist.spin
}

fn lets_go_at<R: Real>(margin: f64) {
    let (body, set, strength) = (body::<R>(), face::<R>(), R::from_f64(STRENGTH));
    for motion in motions::<R>(200) {
        // What friction carries while the box slides so is on the surface of the set by definition.
        let limit = set.wrench(&motion) * -strength;
        for dt in STEPS.map(step_of::<R>) {
            let [below, above] = [1.0 - margin, 1.0 + margin].map(|load| {
                let push = limit * R::from_f64(load);
                let step = body.step_sticking(&set, strength, &Twist::ZERO, &push, dt);
                (step, push)
            });
            let (held, push) = below;
            assert!(
                held.is_at_rest && held.twist == Twist::ZERO,
                "{motion:?} {dt:?}"
            );
            assert_eq!(held.friction, -push);
            // Beyond, the step is that of kinetic friction.
            let (slides, push) = above;
            assert!(!slides.is_at_rest && energy(&body, &slides.twist) > R::ZERO);
            assert_eq!(slides, body.step(&set, &Twist::ZERO, &push, dt));
        }
    }
}

#[test]
fn a_box_lets_go_at_its_static_limit_at_any_step() {
    lets_go_at::<f64>(1e-9);
    lets_go_at::<f32>(2e-5);
}

#[test]
fn a_box_that_slides_along_is_never_caught() {
    let (body, set) = (body::<f64>(), face::<f64>());
    for (i, motion) in (0..).zip(motions::<f64>(100)) {
        let kinetic = -set.wrench(&motion);
        for dt in STEPS.map(step_of::<f64>) {
            // A push just beyond the static limit, then one between both limits.
            let start = kinetic * (STRENGTH * (1.0 + 1e-12));
            let mut twist = body
                .step_sticking(&set, STRENGTH, &Twist::ZERO, &start, dt)
                .twist;
            let share = [1e-6, 0.1, 0.5, 0.999][i % 4];
            let push = kinetic * (1.0 + share * (STRENGTH - 1.0));
            assert!(
                body.step_sticking(&set, STRENGTH, &Twist::ZERO, &push, dt)
                    .is_at_rest
            );
            for _ in 0..100 {
                let after = body.step_sticking(&set, STRENGTH, &twist, &push, dt);
                assert!(!after.is_at_rest, "{motion:?} {share} {dt:?}");
                assert_eq!(after, body.step(&set, &twist, &push, dt));
                twist = after.twist;
            }
        }
    }
}

/// Whatever the motion and the push: a body that gains from what sliding friction leaves of the push is not caught, one that
/// is caught stays, and one that is not has the step of kinetic friction.
#[test]
fn only_motions_against_the_push_are_caught() {
    let (body, set) = (body::<f64>(), face::<f64>());
    let [mut caught, mut driven, mut reversed] = [0; 3];
    for (i, direction) in (0..).zip(motions::<f64>(4000)) {
        let scale = libm::exp(-6.0 - 6.0 * part(i, 0.324_717_957_2));
        let motion = direction * scale;
        let share = 1.2 + 0.5 * part(i, 0.618_033_988_75);
        // Along the motion, against it, or anyhow.
        let about = [
            direction,
            -direction,
            motions(4001).nth(i as usize + 1).unwrap(),
        ];
        let push = set.wrench(&about[i as usize % 3]) * -share;
        let dt = step_of::<f64>(STEPS[i as usize % 5]);
        let (sticking, kinetic) = (
            body.step_sticking(&set, STRENGTH, &motion, &push, dt),
            body.step(&set, &motion, &push, dt),
        );
        let left = push - set.project_with_length(&push, body.gyration()).wrench;
        let drive = left.power(&motion);
        if drive
            > 1e-12 * (push.force.norm() * motion.speed() + push.torque.abs() * motion.spin.abs())
        {
            assert!(!sticking.is_at_rest, "{motion:?} {push:?} {dt:?}");
            driven += 1;
        }
        if sticking == kinetic {
            continue;
        }
        assert!(sticking.is_at_rest && share < STRENGTH * (1.0 + 1e-12));
        caught += 1;
        let next = body.step_sticking(&set, STRENGTH, &sticking.twist, &push, dt);
        assert!(next.is_at_rest);
        let turned = kinetic.twist.velocity.dot(&motion.velocity) * body.mass()
            + kinetic.twist.spin * motion.spin * body.inertia();
        reversed += u32::from(turned <= 0.0);
    }
    assert!(
        caught > 100 && driven > 1000 && reversed > caught / 2,
        "{caught} {driven} {reversed}"
    );
}

#[test]
fn a_block_thrown_against_its_push_stops_and_stays() {
    let (body, set) = (body::<f64>(), face::<f64>());
    // 5 N drive it back: more than 4 N in motion, less than 5.6 N at rest.
    let push = Wrench::new(5.0, 0.0, 0.0);
    for dt in [1e-5, 1e-3, 1e-2] {
        let (mut twist, mut time, step) = (Twist::new(-0.3, 0.0, 0.0), 0.0, step_of(dt));
        while twist != Twist::ZERO {
            let next = body
                .step_sticking(&set, STRENGTH, &twist, &push, step)
                .twist;
            assert!(next.velocity.x > twist.velocity.x && next.velocity.x <= 0.0);
            (twist, time) = (next, time + dt);
        }
        // 0.3 m/s at (5 + 4) N/kg.
        assert!((time - 0.3 / 9.0).abs() <= dt, "{time} {dt}");
        assert!((0..1000).all(|_| {
            body.step_sticking(&set, STRENGTH, &twist, &push, step)
                .is_at_rest
        }));
        // A push beyond the static limit turns the block back without a stop.
        let (mut twist, push) = (Twist::new(-0.3, 0.0, 0.0), push * (STRENGTH * 0.8 * 1.001));
        while twist.velocity.x < 0.1 {
            let after = body.step_sticking(&set, STRENGTH, &twist, &push, step);
            assert!(!after.is_at_rest || body.step(&set, &twist, &push, step).is_at_rest);
            twist = after.twist;
        }
    }
}

/// Bits of a twist.
fn bits(twist: &Twist<f64>) -> [u64; 3] {
    [twist.velocity.x, twist.velocity.y, twist.spin].map(f64::to_bits)
}

/// A push that swings between both ends of 99 % of the static limit.
fn held_under_vibration(steps: u32) {
    let (body, set, dt) = (body::<f64>(), face::<f64>(), step_of::<f64>(1e-3));
    let motion = Twist::new(0.3, -0.2, 5.0);
    let most = set.wrench(&motion) * (0.99 * STRENGTH);
    let mut twist = Twist::ZERO;
    for i in 0..steps {
        let swing = if i % 2 == 0 { 1.0 } else { -1.0 };
        let share = swing * (1.0 - 0.01 * f64::from(i % 7));
        let step = body.step_sticking(&set, STRENGTH, &twist, &(most * share), dt);
        twist = step.twist;
        assert!(step.is_at_rest && bits(&twist) == [0; 3], "{i}");
    }
}

#[test]
fn vibration_below_the_static_limit_moves_nothing() {
    held_under_vibration(100_000);
}

#[test]
#[ignore = "a minute: cargo test --release -p tribos-core ten_million_swings -- --ignored"]
fn ten_million_swings_below_the_static_limit_move_nothing() {
    held_under_vibration(10_000_000);
}

#[test]
fn without_push_energy_falls_and_equal_coefficients_are_the_kinetic_step() {
    let (body, set) = (body::<f64>(), face::<f64>());
    let motions: std::vec::Vec<_> = motions::<f64>(300).collect();
    for (i, motion) in motions.iter().enumerate() {
        for dt in STEPS.map(step_of::<f64>) {
            let free = body.step_sticking(&set, STRENGTH, motion, &Wrench::ZERO, dt);
            assert_eq!(free, body.step(&set, motion, &Wrench::ZERO, dt));
            assert!(energy(&body, &free.twist) < energy(&body, motion));
            let push = set.wrench(&motions[(i + 7) % motions.len()]) * (0.2 * i as f64 / 30.0);
            for twist in [*motion, *motion * 1e-4, Twist::ZERO] {
                let kinetic = body.step(&set, &twist, &push, dt);
                for strength in [1.0, 0.3, 0.0, -1.0] {
                    assert_eq!(
                        body.step_sticking(&set, strength, &twist, &push, dt),
                        kinetic
                    );
                }
            }
        }
    }
}

#[test]
fn not_a_number_stays_and_infinite_strength_holds_all() {
    let (body, set, dt) = (body::<f64>(), face::<f64>(), step_of::<f64>(1e-3));
    let is_nan = |step: PlanarStep<f64>| step.twist.speed().is_nan() && step.twist.spin.is_nan();
    let push = Wrench::new(1e6, 0.0, 1.0);
    for twist in [Twist::ZERO, Twist::new(1.0, 0.0, 1.0)] {
        assert!(is_nan(body.step_sticking(
            &set,
            f64::NAN,
            &twist,
            &push,
            dt
        )));
    }
    let nan = Wrench::new(f64::NAN, f64::NAN, f64::NAN);
    assert!(is_nan(body.step_sticking(
        &set,
        STRENGTH,
        &Twist::ZERO,
        &nan,
        dt
    )));
    assert!(
        body.step_sticking(&set, f64::INFINITY, &Twist::ZERO, &push, dt)
            .is_at_rest
    );
}

#[test]
fn a_foot_of_points_lets_go_at_its_static_limit() {
    let body = body::<f64>();
    let legs = [[0.1, 0.05], [-0.1, 0.05], [-0.1, -0.05], [0.1, -0.05]];
    let legs = Nodes::new(legs.map(|[x, y]| Node { x, y, weight: 1.0 })).unwrap();
    let mut foot = PointContacts::<f64, _, 4>::new(legs, LIMIT).unwrap();
    // A torque of four legs that are √0.0125 m away.
    let most = STRENGTH * LIMIT * 0.0125_f64.sqrt();
    for dt in STEPS.map(step_of::<f64>) {
        let mut at_rest = |share: f64, twist: &Twist<f64>| {
            let push = Wrench::new(0.0, 0.0, share * most);
            body.step_sticking_on_points(&mut foot, STRENGTH, twist, &push, dt)
                .is_at_rest
        };
        assert!(at_rest(1.0 - 1e-7, &Twist::ZERO) && !at_rest(1.0 + 1e-7, &Twist::ZERO));
        // Turned against the push it is caught, turned along it not.
        assert!(
            at_rest(0.9, &Twist::new(0.0, 0.0, -1e-9))
                && !at_rest(0.9, &Twist::new(0.0, 0.0, 1e-9))
        );
    }
}

/// Friction grows by B ln(t/t₀): the longer a push that rises takes, the later the puck lets go.
#[test]
fn what_rests_longer_holds_more() {
    let puck = PlanarBody::new(1.0, 4e-3).unwrap();
    let set = RoundLimitSurface::new(CoulombDisk, LIMIT, 0.1).unwrap();
    let law = StaticAgeing::new(0.42, 0.03, 1.0).unwrap();
    for (rate, dt) in [(0.1, 1e-3), (0.01, 1e-2), (0.001, 0.1)] {
        let (mut rest, mut twist, step) = (RestTime::ZERO, Twist::ZERO, step_of(dt));
        let (mut count, load) = (0, 10.0);
        while twist == Twist::ZERO {
            let push = Wrench::new(rate * f64::from(count) * dt, 0.0, 0.0);
            let strength = |age| law.mu_static(age) / 0.4;
            twist = puck
                .step_ageing(&set, strength, &mut rest, &twist, &push, step)
                .twist;
            count += 1;
        }
        assert_eq!(rest, RestTime::ZERO);
        // The root of rate × t = load × (A + B ln t) by a fixed point.
        let root = (0..200).fold(1.0, |t: f64, _| {
            load * (0.42 + 0.03 * libm::log(t.max(1.0))) / rate
        });
        let time = f64::from(count - 1) * dt;
        assert!((time - root).abs() < 1.5 * dt, "{time} {root} {rate}");
        // A motion begins a new rest, whatever the caller kept.
        rest.time = 1e9;
        let push = Wrench::new(0.0, 0.0, 0.0);
        let stop = puck.step_ageing(&set, |age| 1.1 + age.time, &mut rest, &twist, &push, step);
        assert!(stop.is_at_rest && rest == RestTime::ZERO);
        puck.step_ageing(&set, |_| 1.1, &mut rest, &stop.twist, &push, step);
        assert_eq!(rest.time, dt);
    }
}
