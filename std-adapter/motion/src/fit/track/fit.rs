//! The search: several starts, noise and outliers, errors and intervals.

use super::super::error::FitError;
use super::super::halton::halton;
use super::super::minimise::{Minimum, OFFSET};
use super::super::parameter::Model;
use super::super::unknowns::Unknowns;
use super::body::Body;
use super::errors::Errors;
use super::film::Track;
use super::model::{TrackModel, Turning};
use super::profile::intervals;
use super::scan::widened;
use super::shown::Shown;
use super::weighted::{Noise, ROUGH, Weighted, first_noise};
use super::words;
use super::{TrackFit, TrackOptions};

/// Standard deviations beyond which a reading is an outlier, and the largest share of frames that may be.
const OUTLYING: f64 = 6.0;
const MOST_OUTLIERS: f64 = 0.05;
/// Rounds of noise and outliers; each changes less than the one before.
const MOST_ROUNDS: usize = 6;
/// Relative change of the noise that changes no result.
const SETTLED: f64 = 0.01;
/// Extent over noise below which a body rests: white noise of a thousand readings reaches 7.
const RESTING: f64 = 9.0;
/// Sums of squares that differ by less than this many variances of a residual belong to the same minimum.
const SAME: f64 = 0.01;
/// Shares of the extent and of the turn that the first search takes for noise at least: coarse sums have fewer minima.
const COARSE: f64 = 0.02;
/// Minima that are compared at last.
const MOST_MINIMA: usize = 4;
/// Variances of a residual by which a minimum of the first search may lie above the best to be compared.
const ALIKE: f64 = 25.0;
/// Dimensions in which starts are spread.
const SPREAD: usize = 3;

/// Fits a body's motion to the frames.
pub(super) fn fit(film: &Track, options: &TrackOptions) -> Result<TrackFit, FitError> {
    let track = film.between(options.skip, options.from, options.to);
    let body = Body::new(
        &options.patch,
        options.law,
        options.gravity,
        options.inertia_ratio,
    )?;
    if track.times().is_empty() {
        return Err(FitError::Track(
            "no frames are left; check --skip, --from and --to against the times".into(),
        ));
    }
    if track.angle().is_none() && !body.is_round() {
        return Err(FitError::Track(
            "a body with straight edges needs the column angle, the direction of its first axis"
                .into(),
        ));
    }
    let noise = first_noise(&track);
    refuse_rest(&track, noise)?;
    let model = TrackModel::new(&track, &body);
    // Without the angle a known radius is for the report alone.
    let is_spare = |name: &str| model.turning == Turning::Ratio && name == "R";
    let fixed = options.fixed.iter().filter(|(name, _)| !is_spare(name));
    let radius = options
        .fixed
        .iter()
        .find(|(name, _)| is_spare(name))
        .map(|(_, radius)| *radius);
    let fixed: Vec<(String, f64)> = fixed.cloned().collect();
    let unknowns = Unknowns::new(&model, &fixed)?;
    let noise = Noise {
        position: options.noise_position.unwrap_or(noise.position),
        angle: options.noise_angle.unwrap_or(noise.angle),
    };
    let mut film = Weighted::new(&model, unknowns, noise);
    let (points, free) = (film.readings(), film.unknowns.sought.len());
    if points <= free {
        return Err(FitError::TooFew { points, free });
    }
    let minima = from_all_starts(&mut film, &track, options.starts)?;
    let distinct = Distinct::new(&minima, points - free);
    let (starts, at_best) = (minima.len(), distinct.at_best);
    let settled = settle(&mut film, distinct.places, options)?;
    result(&film, &track, &settled, [starts, at_best], options, radius)
}

/// Refuses frames in which nothing moves.
fn refuse_rest(track: &Track, noise: Noise) -> Result<(), FitError> {
    let rests =
        track.extent() <= RESTING * noise.position && turned(track) <= RESTING * noise.angle;
    // Without third differences the noise is an assumption.
    const FEWEST: usize = 4;
    if track.extent() == 0.0 || (rests && track.times().len() >= FEWEST) {
        return Err(FitError::Track(
            "the body rests in all of these frames; take frames in which it slides (--from, --to)"
                .into(),
        ));
    }
    Ok(())
}

/// Minima of the robust sum by rising cost: first under a coarse noise, then under that of the film.
fn from_all_starts(
    film: &mut Weighted<'_>,
    track: &Track,
    starts: usize,
) -> Result<Vec<Minimum>, FitError> {
    let noise = film.noise;
    film.noise = Noise {
        position: noise.position.max(COARSE * track.extent()),
        angle: noise.angle.max(COARSE * turned(track)),
    };
    let places = (0..starts.max(1)).map(|index| {
        let mut values = film.model.start(&halton(index, SPREAD));
        for (value, fixed) in values.iter_mut().zip(&film.unknowns.fixed) {
            *value = fixed.unwrap_or(*value);
        }
        film.unknowns.coordinates(&values)
    });
    let coarse = film.minima(&places.collect::<Vec<_>>(), ROUGH);
    film.noise = noise;
    let places: Vec<Vec<f64>> = coarse.into_iter().map(|end| end.q).collect();
    let minima = film.minima(&places, ROUGH);
    if minima.is_empty() {
        Err(FitError::NoStart)
    } else {
        Ok(minima)
    }
}

/// Angle from the first frame to the last, in rad.
fn turned(track: &Track) -> f64 {
    let ends = track
        .angle()
        .and_then(|angle| angle.first().zip(angle.last()));
    ends.map_or(0.0, |(first, last)| (last - first).abs())
}

/// One of each minimum that the frames hardly distinguish from the best.
struct Distinct {
    places: Vec<Vec<f64>>,
    /// Number of searches that ended at the best.
    at_best: usize,
}

impl Distinct {
    fn new(sorted: &[Minimum], freedoms: usize) -> Self {
        let least = sorted.first().map_or(0.0, |best| best.cost);
        let variance = least / freedoms as f64;
        let mut last = f64::NEG_INFINITY;
        let (mut places, mut at_best) = (Vec::new(), 0);
        for end in sorted {
            let is_new = end.cost > last + SAME * variance;
            if is_new && end.cost <= least + ALIKE * variance && places.len() < MOST_MINIMA {
                places.push(end.q.clone());
                last = end.cost;
            }
            at_best += usize::from(end.cost <= least + SAME * variance);
        }
        Self { places, at_best }
    }
}

/// The minima after noise and outliers have settled.
struct Settled {
    /// The best first.
    minima: Vec<Minimum>,
    /// Whether more frames than may be left out lie far from the best motion.
    is_misfit: bool,
}

/// Estimates the noise and leaves frames out by turns.
fn settle(
    film: &mut Weighted<'_>,
    places: Vec<Vec<f64>>,
    options: &TrackOptions,
) -> Result<Settled, FitError> {
    let given = |noise: Noise| Noise {
        position: options.noise_position.unwrap_or(noise.position),
        angle: options.noise_angle.unwrap_or(noise.angle),
    };
    let mut places = places;
    let mut is_misfit = false;
    for round in 0..MOST_ROUNDS {
        let minima = film.minima(&places, ROUGH);
        let best = minima.first().ok_or(FitError::NoStart)?;
        places = minima.iter().map(|end| end.q.clone()).collect();
        let raw = film
            .raw(&film.unknowns.values(&best.q))
            .ok_or(FitError::NoStart)?;
        let before = (film.noise, film.is_kept.clone());
        // Medians are not moved by what is far off.
        let limit = given(film.robust_noise(&raw));
        is_misfit = leave_out(film, &raw, limit);
        film.is_robust = false;
        let paid = Errors::new(film, &best.q, 1.0)
            .ok_or(FitError::NoStart)?
            .paid;
        film.noise = given(film.mean_noise(&raw, paid));
        let change = |a: f64, b: f64| (a / b - 1.0).abs();
        let is_settled = before.1 == film.is_kept
            && change(before.0.position, film.noise.position) < SETTLED
            && change(before.0.angle, film.noise.angle) < SETTLED;
        if is_settled && round > 0 {
            break;
        }
    }
    // The weights of the last search are those of the result.
    let minima = film.minima(&places, OFFSET);
    Ok(Settled { minima, is_misfit })
}

/// Leaves out readings far from the motion, if they are few; whether they are not.
fn leave_out(film: &mut Weighted<'_>, raw: &[f64], noise: Noise) -> bool {
    let frames = film.model.frames();
    let at = |i: usize| raw.get(i).copied().unwrap_or(0.0);
    let is_near = |i: usize| {
        let far = libm::hypot(at(i), at(i + frames));
        let is_placed = at(i).abs().max(at(i + frames).abs()) <= OUTLYING * noise.position;
        (
            is_placed && far.is_finite(),
            at(i + 2 * frames).abs() <= OUTLYING * noise.angle,
        )
    };
    let (placed, turned): (Vec<bool>, Vec<bool>) = (0..frames).map(is_near).unzip();
    let out = placed
        .iter()
        .zip(&turned)
        .filter(|(p, t)| !**p || !**t)
        .count();
    let most = (MOST_OUTLIERS * frames as f64).max(1.0);
    let is_misfit = out as f64 > most;
    if !is_misfit {
        film.is_kept = [placed, turned];
    }
    is_misfit
}

/// Errors, intervals and words.
fn result(
    film: &Weighted<'_>,
    track: &Track,
    settled: &Settled,
    [starts, at_best]: [usize; 2],
    options: &TrackOptions,
    radius: Option<f64>,
) -> Result<TrackFit, FitError> {
    let best = settled.minima.first().ok_or(FitError::NoStart)?;
    let unknowns = &film.unknowns;
    let freedoms = film.readings().saturating_sub(unknowns.sought.len()).max(1);
    let is_known = options.noise_position.is_some()
        && (options.noise_angle.is_some() || track.angle().is_none());
    // A noise that is given for one kind of reading is not scaled by the other.
    let variance = if options.noise_position.or(options.noise_angle).is_some() {
        1.0
    } else {
        best.cost / freedoms as f64
    };
    let errors = Errors::new(film, &best.q, variance).ok_or(FitError::NoStart)?;
    let is_given = [options.noise_position, options.noise_angle].map(|noise| noise.is_some());
    let quantiles = errors.quantiles(film, is_given);
    let rises: Vec<f64> = quantiles.iter().map(|t| t * t * variance).collect();
    let rise = rises.iter().copied().fold(0.0, f64::max);
    // Other minima that the frames do not exclude widen the intervals.
    let alike = settled
        .minima
        .iter()
        .filter(|end| end.cost <= best.cost + rise);
    let alike: Vec<&Minimum> = alike.collect();
    let scanned = widened(film, &alike, &rises, || {
        intervals(film, &alike, &errors.covariance, &rises)
    });
    // The simplest motion that the frames allow, or the nearest to them.
    let unspun = scanned.unspun.as_deref();
    let unspun = unspun.and_then(|place| Shown::unspun(film, place, variance));
    let shown = unspun.unwrap_or_else(|| Shown::least(film, best, errors));
    let values = shown.values();
    let parameters = shown.estimates(film, &scanned.intervals, &quantiles);
    let raw = film.raw(&values).ok_or(FitError::NoStart)?;
    let frames = film.model.frames();
    let dropped = (0..frames).filter(|&i| !film.is_kept[0][i] || !film.is_kept[1][i]);
    let (rms_position, rms_angle) = scatter(film, &raw);
    let mut fit = TrackFit {
        law: options.law.spec(&values),
        parameters,
        frames,
        dropped: dropped.collect(),
        freedoms,
        starts,
        at_best,
        converged: shown.minimum.converged,
        rms_position,
        rms_angle,
        residuals: raw.iter().map(|r| -r).collect(),
        speeds: film.model.speed_at_frames(&values).unwrap_or_default(),
        ratio: 0.0,
        rest_time: None,
        track: track.clone(),
        warnings: Vec::new(),
    };
    let [speed, rim] = film.model.speeds(&values);
    fit.ratio = speed / rim;
    fit.rest_time = words::rest(film.model, &values, track);
    // Those with spin are in the intervals of one without.
    let others = alike.iter().skip(1).filter(|_| !shown.is_unspun);
    let others = others.map(|end| unknowns.values(&end.q));
    fit.warnings = words::warnings(&words::SeenMotion {
        fit: &fit,
        film,
        others: others.collect(),
        is_misfit: settled.is_misfit,
        radius,
        is_unspun: shown.is_unspun,
        chi_squared: is_known.then_some(shown.minimum.cost / freedoms as f64),
        correlations: shown.entangled(),
    });
    Ok(fit)
}

/// Root mean squares of what is left of the frames that are used: of a coordinate and of the angle.
fn scatter(film: &Weighted<'_>, raw: &[f64]) -> (f64, Option<f64>) {
    let frames = film.model.frames();
    let mean = |from: usize, to: usize, kind: usize| {
        let used = (from..to.min(raw.len())).filter(|i| film.is_kept[kind][i % frames]);
        let squares: Vec<f64> = used.map(|i| raw[i] * raw[i]).collect();
        (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
    };
    let angle = (raw.len() > 2 * frames).then(|| mean(2 * frames, raw.len(), 1));
    (mean(0, 2 * frames, 0), angle)
}
