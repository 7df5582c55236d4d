//! A box that a spring draws by a point off its centre: it sticks, slips and turns. The steps against an integration of its
//! smooth phases with the events found between.

use super::*;
use nalgebra::SVector;

/// Place, angle, velocity and spin in the axes of the floor.
type State = SVector<f64, 6>;

/// Stiffness in N/m, speed of the spring's far end in m/s, and the point of the box that it draws, in m.
const SPRING: f64 = 200.0;
const DRAWN: f64 = 0.05;
const POINT: [f64; 2] = [0.02, 0.03];
/// Slips that are compared.
const SLIPS: usize = 4;

/// Time at which a slip begins and how far it goes: along, across, and the turn.
type Slip = [f64; 4];

/// The spring's wrench on the box, in the axes of the floor.
fn pull(time: f64, [x, y, angle]: [f64; 3]) -> Wrench<f64> {
    let (c, s) = (libm::cos(angle), libm::sin(angle));
    let arm = [c * POINT[0] - s * POINT[1], s * POINT[0] + c * POINT[1]];
    let force = [
        SPRING * (POINT[0] + DRAWN * time - x - arm[0]),
        SPRING * (POINT[1] - y - arm[1]),
    ];
    Wrench::new(force[0], force[1], arm[0] * force[1] - arm[1] * force[0])
}

/// The planar part of a vector, turned.
fn turned([x, y, normal]: [f64; 3], angle: f64) -> [f64; 3] {
    let (c, s) = (libm::cos(angle), libm::sin(angle));
    [c * x - s * y, s * x + c * y, normal]
}

fn twist_of([x, y, normal]: [f64; 3]) -> Twist<f64> {
    Twist::new(x, y, normal)
}

fn wrench_of([x, y, normal]: [f64; 3]) -> Wrench<f64> {
    Wrench::new(x, y, normal)
}

fn parts(wrench: &Wrench<f64>) -> [f64; 3] {
    [wrench.force.x, wrench.force.y, wrench.torque]
}

/// The steps of the kernel, of second order while the box slides: slips with the time at which each begins.
fn stepped(dt: f64) -> [Slip; SLIPS] {
    let (body, set, step) = (body::<f64>(), face::<f64>(), step_of::<f64>(dt));
    let (mut place, mut motion) = ([0.0; 3], [0.0; 3]);
    let mut slips = [[0.0; 4]; SLIPS];
    let (mut count, mut begun, mut was_at_rest) = (0, [0.0; 3], true);
    for n in 0.. {
        let time = f64::from(n) * dt;
        let half: [f64; 3] = core::array::from_fn(|k| place[k] + 0.5 * dt * motion[k]);
        let push = wrench_of(turned(parts(&pull(time + 0.5 * dt, half)), -half[2]));
        let before = twist_of(turned(motion, -half[2]));
        let after = body.step_sticking(&set, STRENGTH, &before, &push, step);
        let twist = [
            after.twist.velocity.x,
            after.twist.velocity.y,
            after.twist.spin,
        ];
        if was_at_rest && !after.is_at_rest {
            (slips[count][0], begun) = (time, place);
        }
        let next = turned(twist, half[2]);
        for k in 0..3 {
            place[k] += 0.5 * dt * (motion[k] + next[k]);
        }
        if !was_at_rest && after.is_at_rest {
            for k in 0..3 {
                slips[count][k + 1] = place[k] - begun[k];
            }
            count += 1;
            if count == SLIPS {
                break;
            }
        }
        (motion, was_at_rest) = (next, after.is_at_rest);
    }
    slips
}

/// Rate of the state of a box that slides.
fn rate(time: f64, state: &State, set: &BoxSet<f64>) -> State {
    let (place, motion) = (
        [state[0], state[1], state[2]],
        [state[3], state[4], state[5]],
    );
    let friction = set.wrench(&twist_of(turned(motion, -place[2])));
    let friction = wrench_of(turned(parts(&friction), place[2]));
    let all = pull(time, place) + friction;
    let inertia = body::<f64>().inertia();
    State::from([
        motion[0],
        motion[1],
        motion[2],
        all.force.x,
        all.force.y,
        all.torque / inertia,
    ])
}

/// Runge and Kutta's step by Dormand and Prince (J. Comput. Appl. Math. 6 (1980) 19), with its error.
fn dormand_prince(time: f64, state: &State, dt: f64, set: &BoxSet<f64>) -> (State, f64) {
    const A: [&[f64]; 7] = [
        &[],
        &[0.2],
        &[3.0 / 40.0, 9.0 / 40.0],
        &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
        &[
            19_372.0 / 6561.0,
            -25_360.0 / 2187.0,
            64_448.0 / 6561.0,
            -212.0 / 729.0,
        ],
        &[
            9017.0 / 3168.0,
            -355.0 / 33.0,
            46_732.0 / 5247.0,
            49.0 / 176.0,
            -5103.0 / 18_656.0,
        ],
        &[
            35.0 / 384.0,
            0.0,
            500.0 / 1113.0,
            125.0 / 192.0,
            -2187.0 / 6784.0,
            11.0 / 84.0,
        ],
    ];
    const C: [f64; 7] = [0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];
    const E: [f64; 7] = [
        71.0 / 57_600.0,
        0.0,
        -71.0 / 16_695.0,
        71.0 / 1920.0,
        -17_253.0 / 339_200.0,
        22.0 / 525.0,
        -1.0 / 40.0,
    ];
    let mut slopes = [State::zeros(); 7];
    let mut at = *state;
    for (stage, row) in A.iter().enumerate() {
        at = *state;
        for (slope, a) in slopes.iter().zip(*row) {
            at += slope * (a * dt);
        }
        slopes[stage] = rate(time + C[stage] * dt, &at, set);
    }
    let error: State = slopes
        .iter()
        .zip(E)
        .map(|(slope, e)| slope * (e * dt))
        .sum();
    (at, error.amax())
}

/// Error of one step of the integration, and the speed at which the rest of a slip is a straight line.
const TOLERANCE: f64 = 1e-12;
const SLOW: f64 = 1e-6;

/// The slips of the smooth motion: rest to the wrench on the surface of the static set, then sliding to rest.
fn integrated() -> [Slip; SLIPS] {
    let (body, set) = (body::<f64>(), face::<f64>());
    let (mut time, mut place) = (0.0, [0.0; 3]);
    core::array::from_fn(|_| {
        // The load at which the box lets go, by bisection.
        let local = |at: f64| wrench_of(turned(parts(&pull(at, place)), -place[2]));
        let (mut low, mut high) = (time, time + 10.0);
        assert!(set.gauge(&local(low)) < STRENGTH && set.gauge(&local(high)) > STRENGTH);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if set.gauge(&local(middle)) < STRENGTH {
                low = middle
            } else {
                high = middle
            }
        }
        let begun = (high, place);
        // It starts along what friction leaves of the push, nearest by kinetic energy.
        let push = local(high);
        let left = push - set.project_with_length(&push, body.gyration()).wrench;
        let start = turned(
            [left.force.x, left.force.y, left.torque / body.inertia()],
            place[2],
        );
        let first = 1e-8;
        let mut state = State::from([
            place[0],
            place[1],
            place[2],
            first * start[0],
            first * start[1],
            first * start[2],
        ]);
        time = high + first;
        let (mut dt, mut fastest) = (1e-7, 0.0_f64);
        let size = |state: &State| {
            (state[3] * state[3] + state[4] * state[4] + body.inertia() * state[5] * state[5])
                .sqrt()
        };
        loop {
            let speed = size(&state);
            fastest = fastest.max(speed);
            let slopes = rate(time, &state, &set);
            if speed < SLOW && fastest > 1e3 * SLOW {
                // To rest along a straight line.
                let left = speed / size(&slopes);
                place = core::array::from_fn(|k| state[k] + 0.5 * left * state[k + 3]);
                time += left;
                break;
            }
            // No step reaches the stop.
            let most = 0.5 * speed / size(&slopes);
            let own = if dt < most { dt } else { most };
            let (after, error) = dormand_prince(time, &state, own, &set);
            if error <= TOLERANCE {
                (state, time) = (after, time + own);
            }
            let factor = 0.9 * libm::pow(TOLERANCE / (error + 1e-18), 0.2);
            dt = own * factor.clamp(0.2, 4.0);
        }
        let (start, from) = begun;
        [
            start,
            place[0] - from[0],
            place[1] - from[1],
            place[2] - from[2],
        ]
    })
}

/// Farthest begin of a slip from the exact one, in s, and farthest end of a slip from its start, in m: a turn counts at 0.1 m.
fn off(found: &[Slip; SLIPS], exact: &[Slip; SLIPS]) -> [f64; 2] {
    let mut worst = [0.0_f64; 2];
    for ([time, x, y, turn], wanted) in found.iter().zip(exact) {
        let slip = [x - wanted[1], y - wanted[2], 0.1 * (turn - wanted[3])];
        worst[0] = worst[0].max((time - wanted[0]).abs());
        worst[1] = slip
            .iter()
            .fold(worst[1], |most, part| most.max(part.abs()));
    }
    worst
}

#[test]
fn a_box_on_a_spring_off_its_centre_sticks_and_slips_as_its_smooth_motion_does() {
    let exact = integrated();
    // It turns by more than 7 degrees in each of these slips, and goes by 2 cm.
    assert!(
        exact.iter().all(|slip| slip[3] < -0.12 && slip[1] > 0.02),
        "{exact:?}"
    );
    let steps = [4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4, 1.25e-4];
    let errors = steps.map(|dt| off(&stepped(dt), &exact));
    std::println!("{exact:?} {errors:?}");
    // The step in which it lets go and that in which it stops are of first order: of a step, and of the way in it.
    for ([time, slip], dt) in errors.iter().zip(steps) {
        assert!(*time < 2.0 * dt && *slip < DRAWN * dt, "{dt} {time} {slip}");
    }
    let order = |of: usize| libm::log2(errors[0][of] / errors[5][of]) / 5.0;
    assert!(order(0) > 0.85 && order(1) > 0.85, "{errors:?}");
}

/// Where μ_s > 3 μ_d the spring turns from pull to a push beyond μ_d N while the block slips: only static friction stops it
/// there. The period of the cycle is 2D/(kV) + (2/ω)(π − atan(ωD/(kV))), D = (μ_s − μ_d) N.
#[test]
fn a_block_that_slips_past_its_spring_is_caught_and_has_the_period_of_the_closed_form() {
    let (body, set) = (body::<f64>(), face::<f64>());
    for strength in [1.4, 2.9, 4.0, 7.0] {
        let drop = (strength - 1.0) * LIMIT;
        let (rate, omega) = (SPRING * DRAWN, SPRING.sqrt());
        let wanted = 2.0 * drop / rate
            + 2.0 / omega * (core::f64::consts::PI - libm::atan(omega * drop / rate));
        let mut errors = [0.0; 3];
        for (error, dt) in errors.iter_mut().zip([4e-3, 1e-3, 2.5e-4]) {
            let (mut x, mut v, mut starts) = (0.0_f64, 0.0_f64, std::vec::Vec::new());
            for n in 0.. {
                let time = f64::from(n) * dt;
                let stretch = DRAWN * (time + 0.5 * dt) - (x + 0.5 * dt * v);
                let (before, push) = (
                    Twist::new(v, 0.0, 0.0),
                    Wrench::new(SPRING * stretch, 0.0, 0.0),
                );
                let after = body.step_sticking(&set, strength, &before, &push, step_of(dt));
                assert!(
                    after.twist.velocity.x >= 0.0,
                    "{strength} {dt}: it slips back"
                );
                if v == 0.0 && !after.is_at_rest {
                    starts.push(time);
                }
                x += 0.5 * dt * (v + after.twist.velocity.x);
                v = after.twist.velocity.x;
                if starts.len() == 6 {
                    break;
                }
            }
            *error = ((starts[5] - starts[1]) / 4.0 - wanted).abs();
            assert!(*error < dt, "{strength} {dt}: {error}");
        }
        std::println!("{strength}: {wanted} {errors:?}");
    }
}
