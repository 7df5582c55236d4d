//! Records with a known truth: random parameters, motion, sampling and noise.

use crate::course::{VelocityCourse, log_uniform, normal, uniform};
use crate::truth::Truth;
use tribos_base::random::Random;
use tribos_motion::fit::{Apparatus, FitError, FitLaw, Measurements};

/// What is fitted to what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Steady sliding.
    Steady,
    /// Steady sliding under loads that differ.
    Load,
    /// A record, with an inertia and an offset where the law has no memory.
    Record,
    /// A record of the load point of a spring that is given.
    Spring,
    /// The same with the spring unknown.
    SpringSought,
}

/// All cases of the study.
pub const CASES: [(FitLaw, Form); 24] = [
    (FitLaw::Coulomb, Form::Steady),
    (FitLaw::Viscous, Form::Steady),
    (FitLaw::Viscous, Form::Record),
    (FitLaw::Stribeck, Form::Steady),
    (FitLaw::Stribeck, Form::Record),
    (FitLaw::Stribeck, Form::Load),
    (FitLaw::Tanh, Form::Steady),
    (FitLaw::Arctan, Form::Steady),
    (FitLaw::Rising, Form::Steady),
    (FitLaw::Power, Form::Steady),
    (FitLaw::Amontons, Form::Load),
    (FitLaw::LuGre, Form::Steady),
    (FitLaw::RateState, Form::Steady),
    (FitLaw::ElasticPlastic, Form::Record),
    (FitLaw::Dahl, Form::Record),
    (FitLaw::ElastoPlastic, Form::Record),
    (FitLaw::LuGre, Form::Record),
    (FitLaw::Maxwell, Form::Record),
    (FitLaw::RateState, Form::Record),
    (FitLaw::RateStateSlip, Form::Record),
    (FitLaw::RateState, Form::Spring),
    (FitLaw::RateState, Form::SpringSought),
    (FitLaw::RateStateSlip, Form::Spring),
    (FitLaw::RateStateSlip, Form::SpringSought),
];

/// A record, and what is true of it.
#[derive(Debug)]
pub struct Record {
    pub data: Measurements,
    pub apparatus: Apparatus,
    pub fixed: Vec<(String, f64)>,
    /// Values of all parameters, in the order of the model.
    pub truth: Vec<f64>,
}

/// Friction and the largest speed of a trade: joints in N, N m and mN, coefficients, rock.
const SCALES: [[f64; 2]; 5] = [
    [10.0, 0.1],
    [0.03, 100.0],
    [1e-3, 1e-3],
    [0.3, 1.0],
    [0.6, 1e-4],
];

struct Scale {
    force: f64,
    speed: f64,
    rows: usize,
    noise: f64,
}

impl Scale {
    fn of(random: &mut Random, rows: Option<usize>) -> Self {
        let [force, speed] = SCALES[(random.unit() * SCALES.len() as f64) as usize];
        let range = if random.unit() < 0.95 {
            [200.0, 2000.0]
        } else {
            [2000.0, 20_000.0]
        };
        let chosen = log_uniform(random, range) as usize;
        Self {
            force: force * log_uniform(random, [0.3, 3.0]),
            speed: speed * log_uniform(random, [0.3, 3.0]),
            rows: rows.unwrap_or(chosen),
            noise: log_uniform(random, [0.003, 0.05]),
        }
    }
}

/// One record of a case; `rows` replaces the random number.
pub fn record(case: (FitLaw, Form), seed: u64, rows: Option<usize>) -> Result<Record, FitError> {
    let mut random = Random::new(seed, 17);
    let scale = Scale::of(&mut random, rows);
    match case {
        (law, Form::Steady | Form::Load) => steady(&mut random, law, case.1, &scale),
        (law, Form::Record) if !law.has_memory() => driven(&mut random, law, &scale),
        (FitLaw::RateState | FitLaw::RateStateSlip, _) => rock(&mut random, case, &scale),
        (law, _) => joint(&mut random, law, &scale),
    }
}

/// Parameters of a law of the speed.
fn curve(random: &mut Random, law: FitLaw, s: &Scale) -> Vec<f64> {
    let f = s.force;
    let drag = f / s.speed;
    match law {
        FitLaw::Coulomb => vec![f],
        FitLaw::Viscous => vec![f, drag * log_uniform(random, [0.05, 2.0])],
        FitLaw::Stribeck => {
            let rest = f * uniform(random, [1.2, 2.5]);
            let speed = s.speed * log_uniform(random, [0.02, 0.2]);
            let k = drag * log_uniform(random, [0.1, 1.0]);
            vec![rest, f, speed, uniform(random, [0.6, 2.5]), k]
        }
        FitLaw::Tanh | FitLaw::Arctan => vec![f, s.speed * log_uniform(random, [0.02, 0.5])],
        FitLaw::Rising => {
            vec![
                f * uniform(random, [0.2, 0.8]),
                f,
                s.speed * log_uniform(random, [0.05, 0.5]),
            ]
        }
        FitLaw::Power => {
            let alpha = uniform(random, [-0.7, 1.0]);
            vec![f / libm::pow(s.speed, alpha), alpha]
        }
        FitLaw::Amontons => vec![f, f * uniform(random, [-0.5, 2.0])],
        FitLaw::LuGre => {
            let speed = s.speed * log_uniform(random, [0.02, 0.2]);
            let drag = drag * log_uniform(random, [0.1, 1.0]);
            vec![f, f * uniform(random, [1.2, 2.5]), speed, drag]
        }
        _ => {
            let b = f * log_uniform(random, [0.01, 0.05]);
            vec![
                f,
                f * log_uniform(random, [0.01, 0.05]),
                b,
                0.1 * s.speed,
                0.0,
            ]
        }
    }
}

/// Friction at a speed, per load.
fn along(law: FitLaw, p: &[f64], v: f64, load: f64) -> f64 {
    match law {
        FitLaw::Coulomb => p[0],
        FitLaw::Viscous => p[0] + p[1] * v,
        FitLaw::Stribeck => p[1] + (p[0] - p[1]) * libm::exp(-libm::pow(v / p[2], p[3])) + p[4] * v,
        FitLaw::Tanh => p[0] * libm::tanh(v / p[1]),
        FitLaw::Arctan => p[0] * libm::atan(v / p[1]) * std::f64::consts::FRAC_2_PI,
        FitLaw::Rising => p[1] - (p[1] - p[0]) * libm::exp(-v / p[2]),
        FitLaw::Power => p[0] * libm::pow(v, p[1]),
        FitLaw::Amontons => p[0] + p[1] / load,
        FitLaw::LuGre => p[0] + (p[1] - p[0]) * libm::exp(-(v / p[2]) * (v / p[2])) + p[3] * v,
        _ => p[0] + (p[1] - p[2]) * libm::log(v / p[3]) + p[4] * v,
    }
}

fn steady(random: &mut Random, law: FitLaw, form: Form, s: &Scale) -> Result<Record, FitError> {
    let truth = curve(random, law, s);
    let is_one_way = random.unit() < 0.5 || law == FitLaw::RateState;
    let low = log_uniform(random, [1e-3, 0.02]);
    let is_even = random.unit() < 0.3;
    let mut speed = || {
        let size = if is_even {
            uniform(random, [low, 1.0])
        } else {
            log_uniform(random, [low, 1.0])
        };
        s.speed
            * if is_one_way || random.unit() < 0.5 {
                size
            } else {
                -size
            }
    };
    let speeds: Vec<f64> = (0..s.rows).map(|_| speed()).collect();
    let load: Vec<f64> = (0..s.rows)
        .map(|_| log_uniform(random, [1.0, 20.0]))
        .collect();
    let has_load = form == Form::Load;
    let exact: Vec<f64> = speeds
        .iter()
        .zip(&load)
        .map(|(v, load)| {
            let load = if has_load { *load } else { 1.0 };
            along(law, &truth, v.abs(), load).copysign(*v) * load
        })
        .collect();
    let (friction, sigma) = noisy(random, exact, s.noise);
    let mut data = Measurements::steady(speeds, friction, sigma)?;
    if has_load {
        data = data.with_load(load)?;
    }
    let mut fixed = Vec::new();
    if law == FitLaw::RateState {
        fixed.push(("v0".into(), truth[3]));
    }
    Ok(Record {
        data,
        apparatus: Apparatus::default(),
        fixed,
        truth,
    })
}

/// With noise of a share of the mean friction; its deviation is told in one of four records.
fn noisy(random: &mut Random, exact: Vec<f64>, share: f64) -> (Vec<f64>, Option<Vec<f64>>) {
    let mean = exact.iter().map(|f| f.abs()).sum::<f64>() / exact.len() as f64;
    let deviation = share * mean;
    let sigma = (random.unit() < 0.25).then(|| vec![deviation; exact.len()]);
    (
        exact
            .into_iter()
            .map(|f| f + deviation * normal(random))
            .collect(),
        sigma,
    )
}

/// Times of samples in cycles, of which stretches are missing in one of three records.
fn samples(random: &mut Random, rows: usize, cycles: f64) -> Vec<f64> {
    let is_even = random.unit() < 0.7;
    let step = cycles / rows as f64;
    let jitter = if is_even { 0.0 } else { 0.3 };
    let mut times: Vec<f64> = (0..rows)
        .map(|k| step * (k as f64 + 0.5 + jitter * (random.unit() - 0.5)))
        .collect();
    if random.unit() < 0.33 {
        for _ in 0..1 + (2.0 * random.unit()) as usize {
            let from = 1 + (random.unit() * 0.8 * times.len() as f64) as usize;
            let length = (uniform(random, [0.02, 0.08]) * rows as f64) as usize;
            times.drain(from..from + length);
        }
    }
    times
}

/// A law without memory on a drive with an inertia and an offset.
fn driven(random: &mut Random, law: FitLaw, s: &Scale) -> Result<Record, FitError> {
    let mut truth = curve(random, law, s);
    let cycles = uniform(random, [2.0, 10.0]);
    let course = VelocityCourse::both_ways(random, cycles);
    let times = samples(random, s.rows, cycles);
    let v = |t: f64| s.speed * course.velocity(t);
    let h = 1e-4 * cycles / s.rows as f64;
    let times: Vec<f64> = times.into_iter().filter(|t| v(*t) != 0.0).collect();
    let velocities: Vec<f64> = times.iter().map(|t| v(*t)).collect();
    let slopes: Vec<f64> = times
        .iter()
        .map(|t| (v(t + h) - v(t - h)) / (2.0 * h))
        .collect();
    let steepest = slopes.iter().fold(1e-300, |most: f64, a| a.abs().max(most));
    let inertia = s.force / steepest * log_uniform(random, [0.05, 2.0]);
    let offset = s.force * uniform(random, [-0.3, 0.3]);
    let exact = velocities
        .iter()
        .zip(&slopes)
        .map(|(v, a)| along(law, &truth, v.abs(), 1.0).copysign(*v) + inertia * a + offset);
    let (friction, sigma) = noisy(random, exact.collect(), s.noise);
    let data =
        Measurements::series(times, velocities, friction, sigma)?.with_acceleration(slopes)?;
    truth.extend([inertia, offset]);
    let apparatus = Apparatus {
        inertia: true,
        offset: true,
        spring: false,
    };
    Ok(Record {
        data,
        apparatus,
        fixed: Vec::new(),
        truth,
    })
}

/// Bristles and springs that yield, drawn to and fro.
fn joint(random: &mut Random, law: FitLaw, s: &Scale) -> Result<Record, FitError> {
    let cycles = uniform(random, [2.0, 10.0]);
    let period = log_uniform(random, [0.1, 10.0]);
    let course = VelocityCourse::both_ways(random, cycles);
    let stroke = s.speed * period / std::f64::consts::PI;
    // Rows of one cycle in which the state changes: resolved finely or coarsely.
    let bend = stroke * log_uniform(random, [0.003, 0.1]);
    let f = s.force;
    let (truth, values): (Truth, Vec<f64>) = match law {
        FitLaw::ElasticPlastic => (Truth::ElasticPlastic([f, f / bend]), vec![f, f / bend]),
        FitLaw::Dahl => (Truth::Dahl([f, f / bend]), vec![f, f / bend]),
        FitLaw::Maxwell => {
            let mut p = [0.0; 6];
            let mut yields = bend;
            for k in 0..3 {
                p[2 * k + 1] = f * uniform(random, [0.2, 0.5]);
                p[2 * k] = p[2 * k + 1] / yields;
                yields *= uniform(random, [2.0, 5.0]);
            }
            (Truth::Maxwell(p), p.to_vec())
        }
        _ => {
            let [speed, drag] = [[0.02, 0.3], [0.05, 0.5]].map(|range| log_uniform(random, range));
            let damping = f / s.speed * log_uniform(random, [0.03, 0.5]);
            let rest = f * uniform(random, [1.1, 1.8]);
            let share = uniform(random, [0.3, 0.8]);
            let p = [
                f,
                rest,
                speed * s.speed,
                drag * f / s.speed,
                f / bend,
                damping,
                share,
            ];
            let is_lugre = law == FitLaw::LuGre;
            let used = if is_lugre { 6 } else { 7 };
            (Truth::Bristles(p, is_lugre), p[..used].to_vec())
        }
    };
    let times = samples(random, s.rows, cycles);
    let share = uniform(random, [-0.9, 0.9]);
    over_time(
        random,
        (truth, values),
        &course,
        [s.speed, period, s.noise],
        (times, share),
    )
}

/// Fewest samples at a speed that is held.
const HELD: f64 = 10.0;

/// Rate and state, forward.
fn rock(random: &mut Random, (law, form): (FitLaw, Form), s: &Scale) -> Result<Record, FitError> {
    let cycles = uniform(random, [2.0, 6.0]);
    let period = log_uniform(random, [1.0, 100.0]);
    let hold = HELD * cycles / s.rows as f64;
    let course = VelocityCourse::forward(random, cycles, hold);
    let times = samples(random, s.rows, cycles);
    let distance: f64 = times
        .windows(2)
        .map(|t| (t[1] - t[0]) * course.velocity(t[0]))
        .sum();
    let dc = s.speed * period * distance * log_uniform(random, [0.003, 0.04]);
    let mu = s.force;
    let [a, b] = [(); 2].map(|()| mu * log_uniform(random, [0.006, 0.03]));
    let eta = if random.unit() < 0.5 {
        0.0
    } else {
        0.3 * a / s.speed * random.unit()
    };
    let v0 = 0.1 * s.speed;
    let is_slip = law == FitLaw::RateStateSlip;
    let mut values = vec![mu, a, b, v0, eta, dc];
    let mut fixed = vec![("v0".to_owned(), v0)];
    let truth = if form == Form::Record {
        Truth::RateState([mu, a, b, v0, eta, dc], is_slip)
    } else {
        // Stiff enough to slide without sticking.
        let critical = (b - a).max(0.3 * a) / dc;
        let stiffness = critical * log_uniform(random, [2.0, 20.0]);
        values = vec![mu, a, b, v0, dc, stiffness];
        if form == Form::Spring {
            fixed.push(("spring".into(), stiffness));
        }
        Truth::Sprung([mu, a, b, v0, 0.0, dc], is_slip, stiffness)
    };
    // The noise is small against the direct effect.
    let noise = (0.3 * a / mu).min(s.noise * log_uniform(random, [0.02, 0.2]));
    let mut made = over_time(
        random,
        (truth, values),
        &course,
        [s.speed, period, noise],
        (times, 0.0),
    )?;
    made.fixed = fixed;
    made.apparatus.spring = form != Form::Record;
    Ok(made)
}

/// The record of a law with a state; `times` in cycles.
fn over_time(
    random: &mut Random,
    (law, truth): (Truth, Vec<f64>),
    course: &VelocityCourse,
    [speed, period, noise]: [f64; 3],
    (times, share): (Vec<f64>, f64),
) -> Result<Record, FitError> {
    let v = |t: f64| speed * course.velocity(t / period);
    let times: Vec<f64> = times.iter().map(|t| t * period).collect();
    let mut state = law.first(v(times[0]), share);
    let (mut velocities, mut exact) = (Vec::new(), Vec::new());
    let mut before = times[0];
    for &time in &times {
        state = law.advance(state, [before, time], v);
        before = time;
        velocities.push(v(time));
        exact.push(law.friction(state, v(time)));
    }
    let (friction, sigma) = noisy(random, exact, noise);
    let data = Measurements::series(times, velocities, friction, sigma)?;
    Ok(Record {
        data,
        apparatus: Apparatus::default(),
        fixed: Vec::new(),
        truth,
    })
}
