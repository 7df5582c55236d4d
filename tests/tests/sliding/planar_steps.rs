//! What friction may do in one step of a body in the plane, however large the step is: hold it, slow
//! it down, turn it, but neither drive it nor send it back.

use nalgebra::Vector2;
use tribos_core::Real;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombRing};
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface};
use tribos_core::patch::nodes::{Node, NodeList};
use tribos_core::planar::{PlanarBody, PlanarStep, PointContacts};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const RADIUS: f64 = 0.04;
const LIMIT: f64 = 0.5;
const STEP: f64 = 0.01;

/// A body, its motion and the push on it.
struct Case {
    body: PlanarBody<f64>,
    twist: Twist<f64>,
    push: Wrench<f64>,
}

/// A direction in the plane and a part of turning, of length 1.
fn direction(rng: &mut Lcg) -> [f64; 3] {
    let part = rng.unit() * std::f64::consts::FRAC_PI_2;
    let heading = rng.unit() * std::f64::consts::TAU;
    let sign = if rng.unit() < 0.5 { -1.0 } else { 1.0 };
    let (turn, slide) = match rng.bits() % 8 {
        0 => (0.0, 1.0),
        1 => (1.0, 0.0),
        _ => part.sin_cos(),
    };
    [slide * heading.cos(), slide * heading.sin(), sign * turn]
}

/// Motions that friction ends in a thousandth of a step to in a hundred steps, most in one or two;
/// pushes, if any, up to three times what friction carries, many along or against the motion.
fn case(rng: &mut Lcg, is_pushed: bool) -> Case {
    let mass = rng.log_between(0.05, 5.0);
    let gyration = RADIUS * rng.log_between(0.05, 20.0);
    let body = PlanarBody::new(mass, mass * gyration * gyration).expect("positive");
    let steps = if rng.unit() < 0.7 {
        rng.between(0.2, 2.5)
    } else {
        rng.log_between(1e-3, 1e2)
    };
    let speed = steps * STEP * LIMIT / mass;
    let [x, y, n] = direction(rng);
    // Turning counts by what friction's torque stops.
    let spin = speed * mass * RADIUS / body.inertia();
    let twist = Twist::new(speed * x, speed * y, spin * n);
    let size = match rng.bits() % 4 {
        _ if !is_pushed => 0.0,
        0 => rng.between(0.9, 1.1),
        1 => rng.log_between(1e-6, 1.0),
        _ => rng.between(0.0, 3.0),
    };
    let [fx, fy, torque] = match rng.bits() % 3 {
        0 => [x, y, n],
        1 => [-x, -y, -n],
        _ => direction(rng),
    };
    let push = Wrench {
        force: Vector2::new(fx, fy) * (size * LIMIT),
        torque: torque * size * LIMIT * RADIUS,
    };
    Case { body, twist, push }
}

/// Inner product of two motions by kinetic energy.
fn kinetic(body: &PlanarBody<f64>, a: &Twist<f64>, b: &Twist<f64>) -> f64 {
    body.mass() * a.velocity.dot(&b.velocity) + body.inertia() * a.spin * b.spin
}

/// What is seen of many steps.
struct WorstCases {
    given: Worst,
    reversed: Worst,
    turned: Worst,
    gained: Worst,
}

impl WorstCases {
    fn new() -> Self {
        Self {
            given: Worst::of("power of friction at the mean motion, of force limit times speed"),
            reversed: Worst::of("motion against the one before, of its square, without push"),
            turned: Worst::of("velocity or spin with another sense, of its square, without push"),
            gained: Worst::of("kinetic energy gained, of the largest, without push"),
        }
    }

    /// One step; `is_round` for a set that neither favours a direction nor turns by force.
    fn see(&mut self, case: &Case, step: &PlanarStep<f64>, is_round: bool) {
        let Case { body, twist, push } = case;
        let after = &step.twist;
        let place = || format!("{body:?} {twist:?} {push:?}: {step:?}");
        // The motion that friction acts on: the mean one, and none if the body is brought to rest.
        let share = if step.is_at_rest { 0.0 } else { 0.5 };
        let met = Twist {
            velocity: (twist.velocity + after.velocity) * share,
            spin: share * (twist.spin + after.spin),
        };
        let scale = LIMIT * (twist.speed() + after.speed())
            + LIMIT * RADIUS * (twist.spin.abs() + after.spin.abs())
            // What friction changes in a step, of which a slow motion is the rest.
            + LIMIT * LIMIT * STEP * (1.0 / body.mass() + RADIUS * RADIUS / body.inertia());
        let given = step.friction.power(&met).max(0.0);
        self.given
            .see(if scale == 0.0 { 0.0 } else { given / scale }, place);
        if *push != Wrench::ZERO {
            return;
        }
        let before = kinetic(body, twist, twist);
        let product = kinetic(body, twist, after);
        self.reversed.see((-product).max(0.0) / before, place);
        let gain = kinetic(body, after, after) - before;
        self.gained.see(gain.max(0.0) / before, place);
        if is_round {
            let (v, w) = (twist.velocity.dot(&after.velocity), twist.spin * after.spin);
            let of = |x: f64, square: f64| {
                if square == 0.0 {
                    0.0
                } else {
                    (-x).max(0.0) / square
                }
            };
            self.turned.see(of(v, twist.velocity.norm_squared()), place);
            self.turned.see(of(w, twist.spin * twist.spin), place);
        }
    }

    fn assert_sound(&self) {
        self.given.assert_within(&tolerance::STEP_POWER);
        self.reversed.assert_within(&tolerance::STEP_REVERSAL);
        self.turned.assert_within(&tolerance::STEP_REVERSAL);
        self.gained.assert_within(&tolerance::STEP_REVERSAL);
    }
}

fn see_set<S: FrictionSet<f64>>(seen: &mut WorstCases, set: &S, seed: u64, count: usize) {
    let mut rng = Lcg::new(seed);
    let dt = TimeStep::new(STEP).expect("positive");
    for n in 0..count {
        let case = case(&mut rng, n % 2 == 0);
        let step = case.body.step(set, &case.twist, &case.push, dt);
        seen.see(&case, &step, true);
    }
}

#[test]
fn friction_of_round_patches_takes_power_or_none_and_reverses_nothing() {
    let mut seen = WorstCases::new();
    let surface = "valid limits";
    let disk = RoundLimitSurface::new(CoulombDisk, LIMIT, RADIUS).expect(surface);
    see_set(&mut seen, &disk, 51, 400_000);
    let ring = RoundLimitSurface::new(CoulombRing, LIMIT, RADIUS).expect(surface);
    see_set(&mut seen, &ring, 52, 100_000);
    let ball = RoundLimitSurface::new(CoulombHertz, LIMIT, RADIUS).expect(surface);
    see_set(&mut seen, &ball, 53, 100_000);
    let ellipsoid = LimitEllipsoid::new(LIMIT, RADIUS, 0.6).expect(surface);
    see_set(&mut seen, &ellipsoid, 54, 100_000);
    seen.assert_sound();
}

/// One to eight points about a centre that is not the centre of mass.
fn points(rng: &mut Lcg) -> NodeList<f64, 8> {
    let [x0, y0] = [(); 2].map(|()| RADIUS * rng.between(-1.5, 1.5));
    let mut points = NodeList::new();
    for _ in 0..1 + rng.bits() % 8 {
        let [x, y] = [(); 2].map(|()| RADIUS * rng.between(-1.0, 1.0));
        let node = Node {
            x: x0 + x,
            y: y0 + y,
            weight: rng.between(0.05, 1.0),
        };
        points.push(node).expect("room");
    }
    points
}

#[test]
fn friction_of_feet_off_the_centre_takes_power_or_none_and_reverses_nothing() {
    let mut rng = Lcg::new(55);
    let dt = TimeStep::new(STEP).expect("positive");
    let mut seen = WorstCases::new();
    for n in 0..100_000 {
        let mut foot: PointContacts<f64, _, 8> =
            PointContacts::new(points(&mut rng), LIMIT).expect("valid");
        let mut case = case(&mut rng, n % 2 == 0);
        // Two steps, the second with the forces of the first.
        for _ in 0..2 {
            let step = case
                .body
                .step_on_points(&mut foot, &case.twist, &case.push, dt);
            seen.see(&case, &step, false);
            if step.is_at_rest {
                break;
            }
            case.twist = step.twist;
        }
    }
    seen.given.assert_within(&tolerance::STEP_POWER);
    seen.reversed.assert_within(&tolerance::STEP_REVERSAL);
    seen.gained.assert_within(&tolerance::STEP_REVERSAL);
}

#[test]
fn a_free_body_stops_within_the_time_that_friction_needs() {
    let dt = TimeStep::new(STEP).expect("positive");
    let set = RoundLimitSurface::new(CoulombDisk, LIMIT, RADIUS).expect("valid limits");
    let mut rng = Lcg::new(56);
    for _ in 0..2_000 {
        let Case { body, twist, push } = case(&mut rng, false);
        let mut now = twist;
        let energy = |twist: &Twist<f64>| kinetic(&body, twist, twist);
        let mut steps = 0;
        while energy(&now) > 0.0 && steps < 100_000 {
            let step = body.step(&set, &now, &push, dt);
            assert!(step.is_at_rest || energy(&step.twist) < energy(&now));
            now = step.twist;
            steps += 1;
        }
        // Sliding alone takes momentum/μN, spinning alone I ω/(2/3 μN R), both together no longer
        // than the two after each other.
        let alone = body.mass() * twist.speed() / LIMIT
            + body.inertia() * twist.spin.abs() / (LIMIT * RADIUS * 2.0 / 3.0);
        assert!(
            f64::from(steps) * STEP <= alone + 3.0 * STEP,
            "{twist:?}: {steps}"
        );
        assert!(now.speed() == 0.0 && Real::abs(now.spin) == 0.0);
    }
}

#[test]
fn under_a_load_that_is_none_only_rest_without_push_has_an_answer() {
    let body = PlanarBody::new(0.17, 1.36e-4).expect("positive");
    let set = RoundLimitSurface::new(CoulombDisk, LIMIT, RADIUS).expect("valid limits");
    let dt = TimeStep::new(STEP).expect("positive");
    let twists = [Twist::ZERO, Twist::ZERO, Twist::new(1.0, 0.0, 3.0)];
    let pushes = [Wrench::ZERO, Wrench::new(0.1, 0.0, 0.0), Wrench::ZERO];
    let blank = PlanarStep {
        twist: Twist::new(7.0, 7.0, 7.0),
        friction: Wrench::ZERO,
        is_at_rest: false,
    };
    for (load, together) in [(f64::NAN, 3), (f64::NAN, 1), (-1.0, 3), (-1.0, 1)] {
        let mut steps = [blank; 3];
        let given = twists.chunks(together).zip(pushes.chunks(together));
        for ((twists, pushes), steps) in given.zip(steps.chunks_mut(together)) {
            body.step_batch_under_loads(&set, &[load; 3], twists, pushes, dt, steps);
        }
        let [rests, others @ ..] = steps;
        let is_still = rests.twist == Twist::ZERO && rests.friction == Wrench::ZERO;
        assert!(rests.is_at_rest && is_still, "{load}: {rests:?}");
        for PlanarStep {
            twist,
            friction,
            is_at_rest,
        } in others
        {
            let [u, f] = [twist.velocity, friction.force];
            let numbers = [u.x, u.y, twist.spin, f.x, f.y, friction.torque];
            let has_none = numbers.iter().all(|x| x.is_nan());
            assert!(has_none && !is_at_rest, "{load}: {numbers:?}");
        }
    }
}
