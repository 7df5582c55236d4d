//! Synthetic strokes whose numbers are known.

use super::*;
use crate::fit::residual_tests::tests::normal;
use tribos_base::random::Random;

const STEP: f64 = 0.01;
const SPEED: f64 = 0.01;
/// Rows of a stroke.
const ROWS: usize = 400;

/// A record that is made row by row.
#[derive(Default)]
struct MadeRecord {
    t: Vec<f64>,
    v: Vec<f64>,
    f: Vec<f64>,
}

impl MadeRecord {
    fn push(&mut self, v: f64, f: f64) {
        self.t.push(STEP * self.t.len() as f64);
        self.v.push(v);
        self.f.push(f);
    }

    fn noisy(mut self, speed: f64, friction: f64, seed: u64) -> Self {
        let mut random = Random::new(seed, 0);
        for (v, f) in self.v.iter_mut().zip(&mut self.f) {
            *v += speed * normal(&mut random);
            *f += friction * normal(&mut random);
        }
        self
    }

    fn record(&self) -> StrokeRecord {
        let record = StrokeRecord::new(self.t.clone(), self.f.clone()).unwrap();
        record.with_velocities(self.v.clone()).unwrap()
    }

    fn strokes(&self) -> Strokes {
        Strokes::new(&self.record(), &StrokeOptions::default()).unwrap()
    }
}

/// Strokes to and fro at constant speed: the mean of each, a static peak that decays over ten rows, an offset.
fn reciprocating(means: impl IntoIterator<Item = f64>, peak: f64, offset: f64) -> MadeRecord {
    let mut made = MadeRecord::default();
    for (k, mean) in means.into_iter().enumerate() {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        for i in 0..ROWS {
            let extra = peak * (-(i as f64) / 10.0).exp();
            made.push(sign * SPEED, sign * (mean + extra) + offset);
        }
    }
    made
}

fn close(found: f64, wanted: f64, within: f64) {
    assert!(
        (found - wanted).abs() <= within,
        "{found} for {wanted} ± {within}"
    );
}

#[test]
fn strokes_to_and_fro_have_their_numbers() {
    let made = reciprocating([0.3; 20], 0.0, 0.0);
    let found = made.strokes();
    assert_eq!(found.strokes.len(), 20);
    assert_eq!(found.friction_sign, FrictionSign::Along);
    assert_eq!(found.divided_by, DividedBy::Velocity);
    assert_eq!(found.run_in, RunIn::None);
    for (k, stroke) in found.strokes.iter().enumerate() {
        assert_eq!(stroke.number, k + 1);
        assert_eq!(stroke.rows, k * ROWS..(k + 1) * ROWS);
        close(stroke.start, STEP * (k * ROWS) as f64, 1e-12);
        close(stroke.duration, STEP * (ROWS - 1) as f64, 1e-9);
        close(
            stroke.length.unwrap(),
            SPEED * STEP * (ROWS - 1) as f64,
            1e-12,
        );
        close(stroke.mean_speed.unwrap(), SPEED, 1e-12);
        close(stroke.mean, 0.3, 1e-12);
        close(stroke.deviation, 0.0, 1e-12);
        assert_eq!(stroke.direction.sign() > 0.0, k % 2 == 0);
        assert_eq!(stroke.stick_slip, StickSlip::default());
    }
    close(found.summary.mean, 0.3, 1e-12);
    close(found.summary.offset.unwrap(), 0.0, 1e-12);
    close(
        found.summary.distance.unwrap(),
        20.0 * SPEED * STEP * 399.0,
        1e-9,
    );
}

#[test]
fn mean_peak_and_offset_come_back_from_noise_with_their_errors() {
    let (mut beyond, runs) = (0, 40);
    for seed in 0..runs {
        // Strokes scatter by 0.004 beside the noise of their rows.
        let mut random = Random::new(seed, 1);
        let means: Vec<f64> = (0..31).map(|_| 0.3 + 0.004 * normal(&mut random)).collect();
        let made = reciprocating(means, 0.1, 0.02).noisy(0.05 * SPEED, 0.002, seed);
        let found = made.strokes();
        assert_eq!(found.strokes.len(), 31, "{seed}");
        let summary = found.summary;
        close(summary.offset.unwrap(), 0.02, 0.004);
        close(summary.deviation.unwrap(), 0.004, 0.0025);
        // The median of the first three rows is the second one.
        close(summary.static_peak.unwrap(), 0.3905, 0.004);
        close(found.noise, 0.002, 2e-4);
        let error = summary.standard_error.unwrap();
        assert!(error > 4e-4 && error < 2e-3, "{error}");
        beyond += usize::from((summary.mean - 0.3).abs() > 2.0 * error);
        // The record begins within the first stroke: it has no start.
        assert_eq!(found.strokes[0].static_peak, None);
        let peak = found.strokes[1].static_peak.unwrap();
        close(peak.time, STEP * ROWS as f64, 3.0 * STEP);
    }
    // 5 % of 40 are two.
    assert!(beyond <= 6, "{beyond}");
}

#[test]
fn friction_may_have_any_sign() {
    let made = reciprocating([0.3; 12], 0.05, 0.0);
    let wanted = made.strokes();
    let turned = |change: fn(f64) -> f64| MadeRecord {
        t: made.t.clone(),
        v: made.v.clone(),
        f: made.f.iter().map(|f| change(*f)).collect(),
    };
    for (change, sign) in [
        ((|f| -f) as fn(f64) -> f64, FrictionSign::Against),
        (f64::abs, FrictionSign::Unsigned),
        (|f| -f.abs(), FrictionSign::Unsigned),
    ] {
        let found = turned(change).strokes();
        assert_eq!(found.friction_sign, sign);
        assert_eq!(found.strokes, wanted.strokes);
        assert_eq!(found.summary, wanted.summary);
        assert!(found.notes().iter().any(|note| note.contains("sign")));
    }
}

#[test]
fn noise_at_rest_and_slow_turns_make_no_strokes() {
    // A sine with dwells of 100 rows at both ends, under noise of 2 % of the largest speed.
    let mut made = MadeRecord::default();
    for k in 0..10 {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        for i in 0..ROWS {
            let v = SPEED * (std::f64::consts::PI * i as f64 / ROWS as f64).sin();
            made.push(sign * v, sign * 0.3);
        }
        for _ in 0..100 {
            made.push(0.0, sign * 0.2);
        }
    }
    let found = made.noisy(0.02 * SPEED, 1e-3, 5).strokes();
    assert_eq!(found.strokes.len(), 10);
    for stroke in &found.strokes {
        // The ends of a sine below the threshold, 12 % here, are the rest: 1 % of the way.
        close(
            stroke.length.unwrap(),
            2.0 / std::f64::consts::PI * SPEED * 4.0,
            5e-4,
        );
        close(stroke.mean, 0.3, 5e-4);
        assert!(!stroke.is_cut_off);
    }
}

#[test]
fn springs_that_turn_round_and_drives_that_settle_are_no_friction_and_no_strokes() {
    // The machine's springs take two fifths of a stroke, with a peak at their end; the drive settles by
    // two short moves to and fro in a rest.
    let mut made = MadeRecord::default();
    for k in 0..12 {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        for i in 0..ROWS {
            let part = i as f64 / (0.4 * ROWS as f64);
            let friction = if part < 1.0 { -0.3 + 0.6 * part } else { 0.3 };
            made.push(sign * SPEED, sign * friction);
        }
        for i in 0..60 {
            let v = match i {
                20..24 => -0.2 * SPEED,
                40..44 => 0.2 * SPEED,
                _ => 0.0,
            };
            made.push(sign * v, sign * 0.3);
        }
    }
    let found = made.strokes();
    assert_eq!(found.strokes.len(), 12);
    for stroke in &found.strokes {
        close(stroke.mean, 0.3, 1e-12);
        close(stroke.length.unwrap(), SPEED * STEP * 399.0, 1e-12);
    }
}

/// Starts of one direction, each after a rest that keeps half of the friction, with a peak that grows with its number.
fn starts(count: usize) -> MadeRecord {
    let mut made = MadeRecord::default();
    for k in 0..count {
        for _ in 0..150 {
            made.push(0.0, 0.15);
        }
        for i in 0..20 {
            made.push(
                0.0,
                0.15 + (0.25 + 0.01 * k as f64) * f64::from(i + 1) / 20.0,
            );
        }
        for i in 0..ROWS {
            let extra = (0.1 + 0.01 * k as f64) * (-(i as f64) / 10.0).exp();
            made.push(SPEED, 0.3 + extra);
        }
    }
    made
}

#[test]
fn starts_and_stops_have_a_static_peak_each() {
    let found = starts(6).noisy(1e-5, 1e-3, 1).strokes();
    assert_eq!(found.strokes.len(), 6);
    assert!(!found.sticks && found.summary.offset.is_none());
    for (k, stroke) in found.strokes.iter().enumerate() {
        close(
            stroke.static_peak.unwrap().value,
            0.4 + 0.01 * k as f64,
            0.006,
        );
        close(stroke.mean, 0.3, 1e-3);
    }
    // A rest that is too short for the options divides nothing.
    let options = StrokeOptions {
        shortest_rest: 3.0,
        ..StrokeOptions::default()
    };
    let one = Strokes::new(&starts(6).record(), &options).unwrap();
    assert_eq!(one.strokes.len(), 1);
}

/// A saw-tooth: rises of 90 rows, falls of 5, between 0.2 and 0.2 + drop; the velocity of the drive or of the body.
fn saw_tooth(teeth: usize, drop: f64, is_body: bool) -> MadeRecord {
    let mut made = MadeRecord::default();
    for _ in 0..teeth {
        for i in 0..90 {
            let v = if is_body { 0.0 } else { SPEED };
            made.push(v, 0.2 + drop * f64::from(i) / 89.0);
        }
        for i in 0..5 {
            made.push(
                20.0 * SPEED.min(0.05),
                0.2 + drop * (1.0 - f64::from(i + 1) / 6.0),
            );
        }
    }
    if !is_body {
        made.v.fill(SPEED);
    }
    made
}

#[test]
fn stick_slip_has_its_fall_and_period() {
    for (drop, noise) in [(0.1, 0.0), (0.1, 1e-3), (0.05, 2e-3)] {
        let found = saw_tooth(30, drop, false).noisy(0.0, noise, 3).strokes();
        let slips = found.strokes[0].stick_slip;
        assert_eq!(slips.slips, 30, "{drop} {noise}");
        close(slips.drop.unwrap(), drop, 0.01 * drop + 0.3 * noise);
        close(slips.period.unwrap(), 95.0 * STEP, 0.02 * STEP + 0.5 * STEP);
        assert_eq!(found.summary.slips, 30);
    }
    // Where the velocity is that of the body, sticks are no rests.
    let found = saw_tooth(30, 0.1, true).noisy(1e-5, 1e-3, 3).strokes();
    assert!(found.sticks);
    // The stroke begins with the first slip, whose stick came before.
    assert_eq!((found.strokes.len(), found.summary.slips), (1, 29));
}

#[test]
fn noise_waves_and_drifts_are_no_stick_slip() {
    let mut random = Random::new(9, 0);
    let (mut low_pass, mut walk) = (0.0, 0.0);
    let mut made = [(); 4].map(|()| MadeRecord::default());
    for i in 0..100_000 {
        low_pass = 0.95 * low_pass + 0.01 * normal(&mut random);
        walk += 1e-4 * normal(&mut random);
        let wave = 0.05 * (i as f64 / 15.0).sin();
        let all = [0.01 * normal(&mut random), low_pass, wave, walk];
        for (made, extra) in made.iter_mut().zip(all) {
            made.push(SPEED, 0.3 + extra);
        }
    }
    let slips = made.map(|made| made.strokes().summary.slips);
    assert_eq!(slips, [0; 4]);
}

#[test]
fn a_run_in_ends_where_it_has_decayed() {
    let mut unsettled = 0;
    for seed in 0..40 {
        let mut random = Random::new(seed, 0);
        let scatter = 0.003;
        let mut mean =
            |k: usize| 0.3 + 0.1 * (-(k as f64) / 5.0).exp() + scatter * normal(&mut random);
        let found = reciprocating((0..60).map(&mut mean), 0.0, 0.01).strokes();
        let after = found.run_in.after();
        if !matches!(found.run_in, RunIn::Settled { .. }) {
            unsettled += 1;
            continue;
        }
        // 0.1 exp(−k/5) is the scatter at k = 17.5.
        assert!((9..=36).contains(&after), "{seed}: {after}");
        close(found.summary.mean, 0.3, 0.003);
        close(found.summary.offset.unwrap(), 0.01, 0.002);
        assert_eq!(found.summary.strokes, 60 - after);
    }
    // By chance the end scatters least in one of fifty series.
    assert!(unsettled <= 3, "{unsettled} of 40");
}

#[test]
fn strokes_that_only_scatter_have_no_run_in_and_a_drift_has_no_end() {
    let (mut others, mut settled) = (0, 0);
    for seed in 0..200 {
        let mut random = Random::new(seed, 2);
        let means: Vec<f64> = (0..40).map(|_| 0.3 + 0.01 * normal(&mut random)).collect();
        let numbers: Vec<usize> = (1..=40).collect();
        others += usize::from(run_in::run_in(&means, &numbers) != RunIn::None);
        let drifting: Vec<f64> = means
            .iter()
            .zip(0..)
            .map(|(m, k)| m + 0.003 * f64::from(k))
            .collect();
        let told = run_in::run_in(&drifting, &numbers);
        settled += usize::from(!matches!(told, RunIn::NotSettled { .. }));
        assert_eq!(run_in::run_in(&means[..7], &numbers[..7]), RunIn::TooFew);
    }
    println!("{others} false run-ins and {settled} missed drifts of 200");
    assert!(others <= 10 && settled <= 4, "{others} {settled} of 200");
}

#[test]
fn positions_alone_give_the_same_strokes() {
    let made = reciprocating([0.3; 10], 0.1, 0.0);
    let path = made.record().path().unwrap();
    let mut random = Random::new(4, 0);
    for noise in [0.0, 1e-5, 1e-4] {
        // A stroke is 0.04 m long; at 1e-4 m of noise one row's difference is as large as the speed.
        let noisy = path
            .iter()
            .map(|x| x + noise * normal(&mut random))
            .collect();
        let record = StrokeRecord::new(made.t.clone(), made.f.clone()).unwrap();
        let record = record.with_positions(noisy).unwrap();
        let found = Strokes::new(&record, &StrokeOptions::default()).unwrap();
        assert_eq!(found.divided_by, DividedBy::Position);
        assert_eq!(found.strokes.len(), 10, "{noise}");
        close(found.summary.mean, 0.3, 1e-3);
        close(
            found.strokes[4].length.unwrap(),
            0.04,
            0.02 * 0.04 + 4.0 * noise,
        );
    }
    // Encoders whose steps are longer than the way of a row, up to that of twenty.
    for step in [5e-4, 2e-3] {
        let steps = path.iter().map(|x| (x / step).floor() * step).collect();
        let record = StrokeRecord::new(made.t.clone(), made.f.clone()).unwrap();
        let record = record.with_positions(steps).unwrap();
        let found = Strokes::new(&record, &StrokeOptions::default()).unwrap();
        assert_eq!(found.strokes.len(), 10, "{step}");
    }
}

#[test]
fn a_set_velocity_of_several_speeds_is_no_rounding() {
    let mut made = MadeRecord::default();
    for k in 0..10 {
        let speed = if k < 6 { SPEED } else { 0.1 * SPEED };
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        for _ in 0..ROWS {
            made.push(sign * speed, sign * 0.3);
        }
    }
    assert_eq!(made.strokes().strokes.len(), 10);
}

#[test]
fn the_sign_of_friction_divides_where_the_motion_is_unknown() {
    let made = reciprocating([0.3; 8], 0.0, 0.0).noisy(0.0, 0.01, 6);
    let record = StrokeRecord::new(made.t.clone(), made.f.clone()).unwrap();
    let found = Strokes::new(&record, &StrokeOptions::default()).unwrap();
    assert_eq!(found.divided_by, DividedBy::FrictionSign);
    assert_eq!((found.strokes.len(), found.summary.distance), (8, None));
    close(found.summary.mean, 0.3, 2e-3);
    let constant = StrokeRecord::new(made.t.clone(), vec![0.3; made.t.len()]).unwrap();
    let found = Strokes::new(&constant, &StrokeOptions::default()).unwrap();
    assert_eq!(
        (found.divided_by, found.strokes.len()),
        (DividedBy::Nothing, 1)
    );
    close(found.summary.mean, 0.3, 1e-12);
}

#[test]
fn odd_records_are_measured_or_refused() {
    // Two rows, ten rows, one stroke, zeros, wild rows.
    let of = |v: Vec<f64>, f: Vec<f64>| {
        let t = (0..v.len()).map(|i| i as f64).collect();
        let record = StrokeRecord::new(t, f)?.with_velocities(v)?;
        Strokes::new(&record, &StrokeOptions::default())
    };
    let two = of(vec![1.0; 2], vec![0.3; 2]).unwrap();
    assert_eq!((two.strokes.len(), two.summary.mean), (1, 0.3));
    assert_eq!(two.summary.standard_error, None);
    let ten = of(
        [[1.0; 5], [-1.0; 5]].concat(),
        [[0.3; 5], [-0.3; 5]].concat(),
    )
    .unwrap();
    assert_eq!((ten.strokes.len(), ten.run_in), (2, RunIn::TooFew));
    let none = of(vec![0.0; 10], vec![0.3; 10]).unwrap_err();
    assert!(none.to_string().contains("nothing moves"), "{none}");
    let zero = of(vec![1.0; 10], vec![0.0; 10]).unwrap();
    assert_eq!((zero.summary.mean, zero.summary.slips), (0.0, 0));
    let mut wild = reciprocating([0.3; 10], 0.0, 0.0);
    wild.v[1000] = 100.0 * SPEED;
    assert_eq!(wild.strokes().strokes.len(), 10);
    for fault in [f64::NAN, f64::INFINITY, 1e200] {
        assert!(of(vec![fault; 2], vec![0.3; 2]).is_err());
        assert!(of(vec![1.0; 2], vec![fault; 2]).is_err());
    }
    assert!(StrokeRecord::new(vec![0.0], vec![0.3]).is_err());
    let record = two_rows().per_load(&[0.0, 1.0]);
    assert!(record.unwrap_err().to_string().contains("load"));
    for (middle, shortest_rest) in [(0.0, 0.0), (1.1, 0.0), (f64::NAN, 0.0), (0.5, -1.0)] {
        let options = StrokeOptions {
            middle,
            shortest_rest,
        };
        assert!(Strokes::new(&two_rows(), &options).is_err());
    }
}

fn two_rows() -> StrokeRecord {
    StrokeRecord::new(vec![0.0, 1.0], vec![0.3, 0.3]).unwrap()
}

#[test]
fn a_stroke_that_the_record_cuts_off_is_left_out() {
    let whole = reciprocating([0.3; 11], 0.0, 0.0);
    let part = MadeRecord {
        t: whole.t[300..4200].to_vec(),
        v: whole.v[300..4200].to_vec(),
        f: whole.f[300..4200].to_vec(),
    };
    let found = part.strokes();
    let cut_off = found
        .strokes
        .iter()
        .filter(|s| s.is_cut_off)
        .map(|s| s.number);
    assert_eq!(cut_off.collect::<Vec<_>>(), [1, 11]);
    assert_eq!(found.summary.strokes, 9);
    assert!(found.notes()[0].contains("2 strokes"));
}

#[test]
fn a_hundred_thousand_rows_take_a_moment_and_the_same_bits() {
    let made = reciprocating([0.3; 250], 0.1, 0.01).noisy(1e-4, 1e-3, 8);
    let record = made.record();
    let start = std::time::Instant::now();
    let found = Strokes::new(&record, &StrokeOptions::default()).unwrap();
    let took = start.elapsed().as_secs_f64();
    println!("{took:.4} s");
    assert!(took < 0.5, "{took} s");
    assert_eq!(found.strokes.len(), 250);
    let again = made.strokes();
    assert_eq!(again.strokes, found.strokes);
    assert_eq!(again.summary, found.summary);
}
