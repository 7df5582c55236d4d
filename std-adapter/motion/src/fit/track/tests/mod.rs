mod bound;
mod filmed;
mod laws;
mod odd;
mod spin;

use super::*;
use crate::fit::Uncertainty;
use filmed::{DISK, Filmed, GRAVITY};
use nalgebra::{DVector as Vector, Matrix3, Vector3};
use tribos_base::random::Random;

/// What many fits came to.
#[derive(Debug, Default)]
struct Tally {
    /// Relative errors of μ, of R, and of μ by a parabola through the first half second.
    mu: Vec<f64>,
    radius: Vec<f64>,
    parabola: Vec<f64>,
    /// Intervals that contain the truth, of how many, by parameter.
    covered: std::collections::BTreeMap<&'static str, [usize; 2]>,
    /// Standard errors within which the truth lies, of μ.
    pulls: Vec<f64>,
    /// Least possible standard errors of μ over μ, and deviations of the linear estimate over them.
    bounds: Vec<f64>,
    linear: Vec<f64>,
    seconds: Vec<f64>,
    frames: Vec<f64>,
    agreed: usize,
    failed: usize,
}

fn truths(body: &Filmed) -> [(&'static str, f64); 9] {
    [
        ("mu", body.mu),
        ("R", body.radius),
        ("ratio", body.speed / (body.spin.abs() * body.radius)),
        ("x0", 0.3),
        ("y0", -0.2),
        ("vx", body.speed * body.direction.cos()),
        ("vy", body.speed * body.direction.sin()),
        ("angle0", 0.7),
        ("spin", body.spin),
    ]
}

impl Tally {
    /// Random films, of bodies that spin as [`Filmed::random`] has it times `spinning`.
    fn of(count: usize, seed: u64, has_angle: bool, spinning: f64) -> Self {
        let mut random = Random::new(seed, 0);
        let mut tally = Self::default();
        for _ in 0..count {
            let mut body = Filmed::random(&mut random);
            body.spin *= spinning;
            let track = DISK.film(&body, &mut random, has_angle);
            tally.add(&body, &track);
        }
        tally
    }

    fn add(&mut self, body: &Filmed, track: &Track) {
        let begun = processor_seconds();
        let fit = match fit_track(track, &TrackOptions::default()) {
            Ok(fit) => fit,
            Err(error) => {
                println!("{body:?}: {error}");
                self.failed += 1;
                return;
            }
        };
        self.seconds.push(processor_seconds() - begun);
        let [bound, linear] = bound::of_mu(body, track).unwrap_or([f64::INFINITY, f64::NAN]);
        self.bounds.push(bound);
        self.linear.push(linear);
        self.frames.push(track.times().len() as f64);
        self.agreed += usize::from(fit.at_best >= 2);
        for (name, truth) in truths(body) {
            let Some(estimate) = fit.estimate(name) else {
                continue;
            };
            let [low, high] = estimate.interval;
            let entry = self.covered.entry(name).or_default();
            entry[0] += usize::from(low <= truth && truth <= high);
            entry[1] += 1;
            match (name, &estimate.known) {
                ("mu", known) => {
                    self.mu.push((estimate.value / truth - 1.0).abs());
                    if let Uncertainty::StandardError(error) = known {
                        self.pulls.push((estimate.value - truth) / error);
                    }
                }
                ("R", _) => self.radius.push((estimate.value / truth - 1.0).abs()),
                _ => {}
            }
        }
        self.parabola.push(parabola(body, track) / body.mu - 1.0);
    }
}

/// Time of the processor that this process has used, by ticks of Linux; 0 elsewhere.
fn processor_seconds() -> f64 {
    const TICKS_PER_SECOND: f64 = 100.0;
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields = stat
        .rsplit(')')
        .next()
        .unwrap_or_default()
        .split_whitespace();
    let ticks = fields
        .skip(11)
        .take(2)
        .filter_map(|field| field.parse::<f64>().ok());
    ticks.sum::<f64>() / TICKS_PER_SECOND
}

/// μ from x = x₀ + v t − μ g t²/2 along the path, through the first half of the frames.
fn parabola(body: &Filmed, track: &Track) -> f64 {
    let (cos, sin) = (body.direction.cos(), body.direction.sin());
    let frames = (track.times().len() - 10) / 2;
    let times: Vec<f64> = track
        .times()
        .iter()
        .take(frames.max(5))
        .map(|t| t - 1.5)
        .collect();
    let way: Vec<f64> = track
        .x()
        .iter()
        .zip(track.y())
        .map(|(x, y)| cos * x + sin * y)
        .collect();
    // Normal equations of 1, t, t².
    let sum = |k: i32, values: &[f64]| -> f64 {
        times.iter().zip(values).map(|(t, x)| t.powi(k) * x).sum()
    };
    let ones = vec![1.0; way.len()];
    let matrix = Matrix3::from_fn(|i, j| sum((i + j) as i32, &ones));
    let wanted = Vector3::from_fn(|i, _| sum(i as i32, &way));
    let found = matrix
        .try_inverse()
        .map_or(Vector3::zeros(), |inverse| inverse * wanted);
    -2.0 * found[2] / GRAVITY
}

fn quantile(values: &[f64], share: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted
        .get((share * sorted.len().saturating_sub(1) as f64) as usize)
        .copied()
        .unwrap_or(f64::NAN)
}

impl Tally {
    fn print(&self, what: &str) {
        let [mu, radius, parabola] = [&self.mu, &self.radius, &self.parabola].map(|all| {
            let sizes: Vec<f64> = all.iter().map(|x| x.abs()).collect();
            [0.5, 0.9, 0.95, 1.0].map(|share| (1e4 * quantile(&sizes, share)).round() / 100.0)
        });
        println!(
            "{what}: {} films, {} failed, 2 or more starts agree in {}",
            self.mu.len(),
            self.failed,
            self.agreed
        );
        println!(
            "  |error| in % at 50, 90, 95, 100 % of films: mu {mu:?}, R {radius:?}, parabola {parabola:?}"
        );
        println!(
            "  parabola: median {:.2} %",
            100.0 * quantile(&self.parabola, 0.5)
        );
        let within = |all: &[f64], bound: f64| {
            100.0 * all.iter().filter(|x| **x <= bound).count() as f64 / all.len() as f64
        };
        println!(
            "  mu within 2 %: {:.1} % of films; R within 15 %: {:.1} %",
            within(&self.mu, 0.02),
            within(&self.radius, 0.15)
        );
        for (name, [inside, of]) in &self.covered {
            println!(
                "  95 % interval of {name}: {:.1} % of {of}",
                100.0 * *inside as f64 / *of as f64
            );
        }
        let told = |list: &[f64]| -> Vec<f64> {
            let pairs = list.iter().zip(&self.bounds);
            pairs.filter(|(_, b)| **b < 0.01).map(|(x, _)| *x).collect()
        };
        let over: Vec<f64> = self
            .mu
            .iter()
            .zip(&self.bounds)
            .map(|(x, b)| x / b)
            .collect();
        println!(
            "  bound of mu below 1 %: {:.1} % of films, of which mu is within 2 % in {:.1} %, R within 15 % in {:.1} %; \
             median |error| over bound {:.3} (normal: 0.674)",
            within(&self.bounds, 0.01),
            within(&told(&self.mu), 0.02),
            within(&told(&self.radius), 0.15),
            quantile(&over, 0.5)
        );
        let missed = self.linear.iter().filter(|x| x.abs() > 1.96).count();
        println!("  the linear estimate at the truth misses mu in {missed} of them");
        let rms = (self.pulls.iter().map(|x| x * x).sum::<f64>() / self.pulls.len() as f64).sqrt();
        println!("  pull of mu: rms {rms:.3}");
        println!(
            "  frames {:?}, seconds of the processor {:?}",
            [0.0, 0.5, 1.0].map(|s| quantile(&self.frames, s)),
            [0.5, 0.95, 1.0].map(|s| quantile(&self.seconds, s))
        );
    }
}

/// Ten films with the angle: the medians are far within 2 % and 15 %, and few intervals miss.
#[test]
fn films_of_disks_give_coefficient_and_radius_back() {
    let tally = Tally::of(10, 11, true, 1.0);
    assert_eq!(tally.failed, 0);
    assert!(
        quantile(&tally.mu, 0.5) < 0.005 && quantile(&tally.mu, 0.8) < 0.02,
        "{:?}",
        tally.mu
    );
    assert!(quantile(&tally.radius, 0.5) < 0.05, "{:?}", tally.radius);
    let sizes: Vec<f64> = tally.parabola.iter().map(|x| x.abs()).collect();
    assert!(quantile(&sizes, 0.5) > 0.05, "{sizes:?}");
    let [inside, of] = tally
        .covered
        .values()
        .fold([0, 0], |[a, b], [c, d]| [a + c, b + d]);
    assert!(inside as f64 > 0.88 * of as f64, "{inside} of {of}");
    assert!(tally.agreed >= 9);
}

#[test]
#[ignore = "750 films: cargo test -p tribos-motion --lib hundreds_of_films -- --ignored --nocapture"]
fn hundreds_of_films() {
    let count = std::env::var("FILMS")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(250);
    let seed = std::env::var("SEED")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(7);
    Tally::of(count, seed, true, 1.0).print("with the angle");
    Tally::of(count, seed + 1, false, 1.0).print("without the angle");
    Tally::of(count, seed + 1, false, 0.0).print("without the angle, of bodies that do not spin");
}
