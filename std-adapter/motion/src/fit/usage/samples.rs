//! Fitted laws, and what their programs print, by formulas that are written here anew.

use super::{SHOWN_SPEEDS, SHOWN_STEP, SHOWN_VELOCITIES};
use std::f64::consts::PI;

pub(super) type Parameters = &'static [(&'static str, f64)];
type Reference = fn() -> Vec<[f64; 2]>;

/// A law with usual values, whether friction is a coefficient, and what its programs print.
pub(super) type Sample = (&'static str, Parameters, bool, Reference);

const BRISTLES: Parameters = &[
    ("fc", 1.0),
    ("fs", 1.5),
    ("vs", 0.02),
    ("s2", 0.4),
    ("s0", 1e5),
    ("s1", 31.0),
];
const ROCK: Parameters = &[
    ("mu0", 0.6),
    ("a", 0.01),
    ("b", 0.015),
    ("v0", 1e-6),
    ("eta", 0.5),
    ("dc", 1e-5),
];

pub(super) const SAMPLES: [Sample; 17] = [
    ("coulomb", &[("mu", 0.3)], true, || at(|_| 0.3)),
    ("viscous", &[("mu", 0.3), ("k", 0.25)], false, || {
        at(|v| 0.3 + 0.25 * v)
    }),
    (
        "stribeck",
        &[
            ("mu_s", 0.4),
            ("mu_d", 0.2),
            ("vs", 0.05),
            ("delta", 1.5),
            ("k", 0.1),
        ],
        true,
        || at(|v| 0.2 + 0.2 * (-(v / 0.05).powf(1.5)).exp() + 0.1 * v),
    ),
    ("tanh", &[("mu", 0.8), ("vt", 0.01)], true, || {
        at(|v| 0.8 * (v / 0.01).tanh())
    }),
    ("arctan", &[("mu", 0.8), ("vt", 0.01)], true, || {
        at(|v| 0.8 * v.atan2(0.01) / (0.5 * PI))
    }),
    (
        "rising",
        &[("mu_s", 0.04), ("mu_f", 0.12), ("vr", 0.04)],
        true,
        || at(|v| 0.12 - 0.08 * (-v / 0.04).exp()),
    ),
    ("power", &[("gamma", 0.01), ("alpha", -0.5)], true, || {
        at(|v| 0.01 / v.sqrt())
    }),
    // At the 10 N of its programs.
    ("amontons", &[("mu", 0.3), ("adhesion", 1.5)], false, || {
        at(|_| 4.5)
    }),
    (
        "elastic-plastic",
        &[("fc", 1.5), ("s0", 1e5)],
        false,
        || springs(&[[1e5, 1.5]]),
    ),
    ("dahl", &[("fc", 1.5), ("s0", 1e5)], false, || {
        bristles([1.5, 1.5, 1.0, 0.0, 1e5, 0.0])
    }),
    (
        "elasto-plastic",
        &[
            ("fc", 1.0),
            ("fs", 1.5),
            ("vs", 0.02),
            ("s2", 0.4),
            ("s0", 1e5),
            ("s1", 31.0),
            ("zba", 0.3),
        ],
        false,
        elasto_plastic,
    ),
    ("lugre", BRISTLES, false, || {
        bristles([1.0, 1.5, 0.02, 0.4, 1e5, 31.0])
    }),
    ("lugre", BRISTLES.split_at(4).0, false, || {
        at(|v| 1.0 + 0.5 * (-(v / 0.02).powi(2)).exp() + 0.4 * v)
    }),
    (
        "maxwell",
        &[("k1", 1e5), ("f1", 0.4), ("k2", 5e4), ("f2", 2.0)],
        false,
        || springs(&[[1e5, 0.4], [5e4, 2.0]]),
    ),
    ("rate-state", ROCK, true, || {
        rock(|age, limit, kept| limit + (age - limit) * kept)
    }),
    ("rate-state-slip", ROCK, true, || {
        rock(|age, limit, kept| limit * (age / limit).powf(kept))
    }),
    ("rate-state", ROCK.split_at(5).0, true, || {
        at(|v| {
            let q = 2e-6 * (-(0.6 + 0.015 * (1e-6 / v).ln()) / 0.01).exp();
            0.01 * (v / q).asinh() + 0.5 * v
        })
    }),
];

/// Friction at the shown speeds.
fn at(friction: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
    SHOWN_SPEEDS.map(|v| [v, friction(v)]).to_vec()
}

/// Friction in the shown steps.
fn along(mut step: impl FnMut(f64) -> f64) -> Vec<[f64; 2]> {
    SHOWN_VELOCITIES.map(|v| [v, step(v)]).to_vec()
}

/// Springs that slip: stiffness and force of each.
fn springs(elements: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut stretched = vec![0.0; elements.len()];
    along(|v| {
        let pulled = elements.iter().zip(&mut stretched).map(|(&[k, f], x)| {
            *x = (*x + v * SHOWN_STEP).clamp(-f / k, f / k);
            k * *x
        });
        pulled.sum()
    })
}

/// Mean force of LuGre's bristles by the rule of Runge and Kutta in small steps.
fn bristles([fc, fs, vs, s2, s0, s1]: [f64; 6]) -> Vec<[f64; 2]> {
    let mut z = 0.0;
    along(|v| {
        let steady = fc + (fs - fc) * (-(v / vs).powi(2)).exp();
        let rate = |z: f64| v - s0 * v.abs() * z / steady;
        let (parts, mut sum, start) = (20_000, 0.0, z);
        let h = SHOWN_STEP / f64::from(parts);
        for _ in 0..parts {
            let a = rate(z);
            let b = rate(z + 0.5 * h * a);
            let c = rate(z + 0.5 * h * b);
            let d = rate(z + h * c);
            let next = z + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
            // Simpson's rule with the cubic through both ends for the middle.
            let middle = 0.5 * (z + next) + h / 8.0 * (a - rate(next));
            sum += h / 6.0 * (z + 4.0 * middle + next);
            z = next;
        }
        s0 * sum / SHOWN_STEP + s1 * (z - start) / SHOWN_STEP + s2 * v
    })
}

/// The steps of elasto-plastic bristles, with the share of slip by a cosine.
fn elasto_plastic() -> Vec<[f64; 2]> {
    let mut z = 0.0_f64;
    along(|v| {
        let most = (1.0 + 0.5 * (-(v / 0.02).powi(2)).exp()) / 1e5;
        let share = ((z.abs() / most - 0.3) / 0.7).clamp(0.0, 1.0);
        let slips = if z * v > 0.0 {
            0.5 * (1.0 - (PI * share).cos())
        } else {
            0.0
        };
        let start = z;
        z = if slips == 0.0 {
            z + v * SHOWN_STEP
        } else {
            let limit = most * v.signum() / slips;
            limit + (z - limit) * (-slips * v.abs() * SHOWN_STEP / most).exp()
        };
        1e5 * z + 31.0 * (z - start) / SHOWN_STEP + 0.4 * v
    })
}

/// Rate and state from steady sliding at the reference speed; ages by their closed forms.
fn rock(later: fn(f64, f64, f64) -> f64) -> Vec<[f64; 2]> {
    let mut age = 10.0;
    along(|v| {
        let speed = v.abs();
        age = later(age, 1e-5 / speed, (-speed * SHOWN_STEP / 1e-5).exp());
        let exponent = (0.6 + 0.015 * (1e-6 * age / 1e-5).ln()) / 0.01;
        (0.01 * (0.5e6 * speed * exponent.exp()).asinh() + 0.5 * speed).copysign(v)
    })
}
