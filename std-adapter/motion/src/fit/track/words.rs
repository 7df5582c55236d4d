//! What a fit of a film says beside its numbers.

use super::TrackFit;
use super::film::Track;
use super::model::{TrackModel, Turning};
use super::untold;
use super::weighted::{Weighted, first_noise};
use nalgebra::{Matrix3, Vector3};

/// Standard deviations beyond which something is more than chance.
const BEYOND: f64 = 6.0;
/// Halvings of the time of rest.
const HALVINGS: usize = 50;
/// Doublings of the film's length within which a body comes to rest.
const DOUBLINGS: usize = 12;
/// Frames that are named at most.
const NAMED: usize = 5;

/// What the words are made from.
pub(super) struct SeenMotion<'a> {
    pub fit: &'a TrackFit,
    pub film: &'a Weighted<'a>,
    /// Values at other minima that the frames do not exclude.
    pub others: Vec<Vec<f64>>,
    pub is_misfit: bool,
    /// Whether the motion is one without spin that the frames do not exclude.
    pub is_unspun: bool,
    /// The radius that was given with a film without the angle.
    pub radius: Option<f64>,
    /// Reduced χ², where the noise was given.
    pub chi_squared: Option<f64>,
    pub correlations: Vec<(&'static str, &'static str, f64)>,
}

/// All that is to be said.
pub(super) fn warnings(seen: &SeenMotion<'_>) -> Vec<String> {
    let mut words = seen.fit.track.notes().to_vec();
    words.extend(hand(seen));
    words.extend(outliers(seen));
    words.extend(untold::unspun(seen));
    words.extend(untold::trade(seen));
    words.extend(untold::ambiguities(seen));
    words.extend(end_of_film(seen));
    words.extend(bend(seen));
    words.extend(quality(seen));
    words
}

/// Readings that were left out, or too many that are far off.
fn outliers(seen: &SeenMotion<'_>) -> Vec<String> {
    let fit = seen.fit;
    let mut words = Vec::new();
    if !fit.dropped.is_empty() {
        let times = fit.dropped.iter().take(NAMED);
        let times = times.filter_map(|&i| fit.track.times().get(i).map(|t| format!("{t:.4}")));
        let times: Vec<String> = times.collect();
        let more = if fit.dropped.len() > NAMED {
            ", ..."
        } else {
            ""
        };
        words.push(format!(
            "{} of {} frames lie more than 6 standard deviations off and are left out (t = {}{more} s)",
            fit.dropped.len(),
            fit.frames,
            times.join(", ")
        ));
    }
    if seen.is_misfit {
        words.push(
            "more than 5 % of the frames lie far from this motion: the law, the patch or some of the frames are \
             not those of a body that slides freely; look at residuals.csv, and choose frames with --from and --to"
                .into(),
        );
    }
    words
}

/// A film that ends while the body slides.
fn end_of_film(seen: &SeenMotion<'_>) -> Option<String> {
    let fit = seen.fit;
    let speed = fit.speeds.last().copied().filter(|speed| *speed > 0.0)?;
    let stop = match fit.rest_time {
        Some(time) => format!("by this fit it stops at t = {time:.4} s"),
        None => "by this fit it does not stop".into(),
    };
    Some(format!(
        "the film ends while the body still slides at {speed:.4} m/s; {stop}: the way to rest would narrow all errors"
    ))
}

/// A path that is not straight although the body is round.
fn bend(seen: &SeenMotion<'_>) -> Option<String> {
    let (fit, frames) = (seen.fit, seen.fit.frames);
    if seen.film.model.turning == Turning::Edges {
        return None;
    }
    let [x, y] = ["vx", "vy"].map(|name| fit.value(name).unwrap_or(0.0));
    let speed = libm::hypot(x, y);
    let (x, y) = (x / speed, y / speed);
    let from = ["x0", "y0"].map(|name| fit.value(name).unwrap_or(0.0));
    let mut sums = (Matrix3::zeros(), Vector3::zeros());
    let mut reach: f64 = 0.0;
    let along = |i: usize| {
        let (dx, dy) = (fit.track.x()[i] - from[0], fit.track.y()[i] - from[1]);
        x * dx + y * dy
    };
    let used = || (0..frames).filter(|i| !fit.dropped.contains(i));
    for i in used() {
        reach = reach.max(along(i));
    }
    for i in used() {
        let s = along(i) / reach;
        let aside = x * fit.residuals[frames + i] - y * fit.residuals[i];
        let powers = Vector3::new(1.0, s, s * s);
        sums.0 += powers * powers.transpose();
        sums.1 += powers * aside;
    }
    let inverse = sums.0.try_inverse()?;
    let curvature = (inverse * sums.1)[2];
    let error = inverse[(2, 2)].sqrt() * fit.rms_position;
    if curvature.abs() <= BEYOND * error {
        return None;
    }
    // The depth of the bow over the whole way.
    let bow = 1e3 * curvature.abs() / 4.0;
    let side = if curvature > 0.0 { "left" } else { "right" };
    Some(format!(
        "the path bends to the {side}, with a bow of {bow:.2} mm: a flat round body runs straight on a level floor; a \
         tall or leaning body, a load off its centre or a tilted table does not, and is not in this fit"
    ))
}

/// Frames at the beginning in which the body becomes faster.
fn hand(seen: &SeenMotion<'_>) -> Option<String> {
    /// Windows of a film, and fewest frames of one.
    const WINDOWS: usize = 30;
    const FEWEST: usize = 4;
    /// Faster by less than this share is not yet a hand.
    const FASTER: f64 = 1.15;
    let track = &seen.fit.track;
    let width = (track.times().len() / WINDOWS).max(FEWEST);
    let mean = |column: &[f64]| column.iter().sum::<f64>() / column.len() as f64;
    let starts: Vec<usize> = (0..track.times().len() / width)
        .map(|k| k * width)
        .collect();
    let centre = |at: usize| {
        [track.times(), track.x(), track.y()]
            .map(|column| column.get(at..at + width).map_or(f64::NAN, mean))
    };
    let noise = first_noise(track).position * (2.0 / width as f64).sqrt();
    let speeds = starts.windows(2).map(|pair| {
        let ([t, x, y], [later, there, aside]) = (centre(pair[0]), centre(pair[1]));
        [
            libm::hypot(there - x, aside - y) / (later - t),
            noise / (later - t),
        ]
    });
    let speeds: Vec<[f64; 2]> = speeds.collect();
    let [first, _] = *speeds.first()?;
    let fastest = (0..speeds.len()).max_by(|&a, &b| speeds[a][0].total_cmp(&speeds[b][0]))?;
    let [most, error] = speeds[fastest];
    if most <= FASTER * first || most - first <= BEYOND * error {
        return None;
    }
    let released = track.times().get(starts[fastest])?;
    Some(format!(
        "the body becomes faster until t = {released:.4} s: a hand may still hold it; give --from {released:.4} or later"
    ))
}

/// The search and its residuals.
fn quality(seen: &SeenMotion<'_>) -> Vec<String> {
    let fit = seen.fit;
    let mut words = Vec::new();
    if let Some(chi_squared) = seen.chi_squared {
        let allowed = 1.0 + BEYOND * (2.0 / fit.freedoms as f64).sqrt();
        if chi_squared > allowed {
            words.push(format!(
                "residuals are larger than the given noise allows (reduced chi^2 {chi_squared:.2}): the law, the patch or \
                 the noise is wrong"
            ));
        }
    }
    if is_correlated(fit) {
        words.push(
            "residuals follow each other from frame to frame: the law or the patch does not fit, or the tracker's errors \
             are not independent; the errors here are too small then"
                .into(),
        );
    }
    if fit.at_best == 1 && fit.starts > 1 {
        words.push("only one start ended at the best minimum; try more --starts".into());
    }
    if !fit.converged {
        words.push("the search did not converge: standard errors are rough".into());
    }
    words
}

/// Whether neighbouring residuals of a coordinate are correlated beyond chance.
fn is_correlated(fit: &TrackFit) -> bool {
    /// Correlation below which errors change little.
    const VISIBLE: f64 = 0.3;
    /// Residuals this small against the track are rounding.
    const ROUNDING: f64 = 1e-7;
    let frames = fit.frames;
    if fit.rms_position <= ROUNDING * fit.track.extent() {
        return false;
    }
    let used: Vec<usize> = (0..frames).filter(|i| !fit.dropped.contains(i)).collect();
    let of = |offset: usize| {
        let at = |i: usize| fit.residuals.get(offset + i).copied().unwrap_or(0.0);
        let pairs: f64 = used.windows(2).map(|pair| at(pair[0]) * at(pair[1])).sum();
        let squares: f64 = used.iter().map(|&i| at(i) * at(i)).sum();
        pairs / squares
    };
    let bound = (BEYOND / (frames as f64).sqrt()).max(VISIBLE);
    (0..fit.residuals.len())
        .step_by(frames.max(1))
        .any(|offset| of(offset) > bound)
}

/// Time at which the body stops sliding, on the clock of the film; none if it does not soon.
pub(super) fn rest(model: &TrackModel<'_>, values: &[f64], track: &Track) -> Option<f64> {
    let (first, last) = track.times().first().zip(track.times().last())?;
    let slides = |time: f64| {
        let place = model.motion(values, &[time]);
        place.is_some_and(|place| place.iter().any(|place| place.speed > 0.0))
    };
    let mut high = (last - first).max(f64::MIN_POSITIVE);
    let mut doublings = 0;
    while slides(high) {
        high *= 2.0;
        doublings += 1;
        if doublings > DOUBLINGS {
            return None;
        }
    }
    let mut low = 0.0;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if slides(middle) {
            low = middle
        } else {
            high = middle
        }
    }
    Some(first + high)
}
