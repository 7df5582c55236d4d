//! Residuals of a film over its noise, and the frames that are left out.

use super::super::jacobian::{DifferenceScale, Order};
use super::super::minimise::{Minimum, OFFSET, Problem, Stall, minimise};
use super::super::parameter::{Model, Range};
use super::super::unknowns::Unknowns;
use super::film::Track;
use super::model::TrackModel;
use nalgebra::DMatrix;

/// Standard deviations of the readings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Noise {
    /// Of x and of y, in m.
    pub position: f64,
    /// In rad.
    pub angle: f64,
}

/// Offset of a search for the sum of squares alone, which is then good to its square.
pub(super) const ROUGH: f64 = 1e-3;
/// Normal deviates beyond which a robust fit counts the distance instead of its square (Huber 1964).
const HUBER: f64 = 3.0;
/// Ratio of a normal standard deviation to its median absolute deviation.
const NORMAL: f64 = 1.482_602_218_505_602;
/// Variance of x₃ − 3 x₂ + 3 x₁ − x₀ over that of x.
const THIRD_DIFFERENCE: f64 = 20.0;
/// Least noise relative to the extent of the track, and of angles in rad: residuals below are rounding.
const LEAST_NOISE: f64 = 1e-9;
/// Noise over the extent of a track whose readings show none.
const ASSUMED_NOISE: f64 = 1e-4;

/// A film and its model, with weights.
pub(super) struct Weighted<'a> {
    pub model: &'a TrackModel<'a>,
    pub unknowns: Unknowns<'a>,
    measured: Vec<f64>,
    /// Whether position and angle of each frame are used.
    pub is_kept: [Vec<bool>; 2],
    pub noise: Noise,
    /// Whether large residuals count by their size alone.
    pub is_robust: bool,
}

impl<'a> Weighted<'a> {
    pub fn new(model: &'a TrackModel<'a>, unknowns: Unknowns<'a>, noise: Noise) -> Self {
        let frames = model.frames();
        Self {
            model,
            unknowns,
            measured: model.measured(),
            is_kept: [vec![true; frames], vec![true; frames]],
            noise,
            is_robust: true,
        }
    }

    /// 0 of a coordinate, 1 of an angle.
    pub fn kind(&self, reading: usize) -> usize {
        usize::from(reading >= 2 * self.model.frames())
    }

    /// Weight of a reading.
    fn weight(&self, reading: usize) -> f64 {
        let frames = self.model.frames();
        let kind = self.kind(reading);
        let noise = [self.noise.position, self.noise.angle][kind];
        let is_kept = self.is_kept[kind].get(reading % frames);
        if is_kept == Some(&true) {
            1.0 / noise
        } else {
            0.0
        }
    }

    /// Prediction less reading of all readings, in m and rad.
    pub fn raw(&self, values: &[f64]) -> Option<Vec<f64>> {
        let predicted = self.model.predict(values)?;
        let pairs = predicted.iter().zip(&self.measured);
        Some(pairs.map(|(p, m)| p - m).collect())
    }

    fn residuals(&self, unknowns: &Unknowns<'_>, q: &[f64]) -> Option<Vec<f64>> {
        let mut residuals = self.raw(&unknowns.values(q))?;
        for (i, r) in residuals.iter_mut().enumerate() {
            *r *= self.weight(i);
            if self.is_robust && r.abs() > HUBER {
                *r = (HUBER * (2.0 * r.abs() - HUBER)).sqrt().copysign(*r);
            }
        }
        Some(residuals)
    }

    /// √Σ (reading/σ)².
    pub fn size(&self) -> f64 {
        let weighted = self.measured.iter().enumerate();
        let squares = weighted.map(|(i, m)| m * m * self.weight(i) * self.weight(i));
        squares.sum::<f64>().sqrt()
    }

    /// Readings that are used.
    pub fn readings(&self) -> usize {
        self.readings_of(0) + self.readings_of(1)
    }

    /// Readings of coordinates (0) or of angles (1) that are used.
    pub fn readings_of(&self, kind: usize) -> usize {
        let used = (0..self.measured.len()).filter(|&i| self.weight(i) > 0.0);
        used.filter(|&i| self.kind(i) == kind).count()
    }

    /// Place of the ratio v/(|ω|R) among the unknowns, where it is sought.
    pub fn ratio(&self) -> Option<usize> {
        let parameters = self.model.parameters();
        let mut sought = self.unknowns.sought.iter();
        sought.position(|&j| parameters[j].name == "ratio")
    }

    /// Lengths over which predictions change.
    pub fn lengths(&self, unknowns: &Unknowns<'_>) -> Vec<DifferenceScale> {
        let parameters = self.model.parameters();
        let length = |&j: &usize| match parameters[j].range {
            Range::Positive => DifferenceScale::Fold,
            _ => {
                let scale = self.model.scale(parameters[j].name);
                let is_usable = scale > 0.0 && scale.is_finite();
                DifferenceScale::Own {
                    least: if is_usable { scale } else { 1.0 },
                }
            }
        };
        unknowns.sought.iter().map(length).collect()
    }

    /// Bounds of the coordinates: positive parameters stay within a factor of a thousand of the first guess.
    pub fn bounds(&self, unknowns: &Unknowns<'_>) -> Vec<[f64; 2]> {
        /// Logarithm of the factor.
        const REACH: f64 = 6.907_755_278_982_137;
        let parameters = self.model.parameters();
        let first = self.model.start(&[]);
        let bound = |(&j, own): (&usize, [f64; 2])| match parameters[j].range {
            Range::Positive => {
                let middle = libm::log(first[j]);
                [middle - REACH, middle + REACH]
            }
            _ => own,
        };
        unknowns
            .sought
            .iter()
            .zip(unknowns.bounds())
            .map(bound)
            .collect()
    }

    /// Searches from a place until a step would change the residuals by this fraction of their length; `unknowns` may
    /// have more parameters fixed than the fit.
    pub fn minimum(&self, unknowns: &Unknowns<'_>, place: &[f64], offset: f64) -> Option<Minimum> {
        let grain = f64::EPSILON * self.size();
        let problem = Problem {
            residuals: &|q: &[f64]| self.residuals(unknowns, q),
            bounds: self.bounds(unknowns),
            lengths: self.lengths(unknowns),
            floor: grain * grain,
            offset,
            stall: Stall::of(offset),
        };
        minimise(&problem, place, &mut |_| ())
    }

    /// Minima from several places, by rising cost.
    pub fn minima(&self, places: &[Vec<f64>], offset: f64) -> Vec<Minimum> {
        let ends = places
            .iter()
            .filter_map(|place| self.minimum(&self.unknowns, place, offset));
        let mut minima: Vec<Minimum> = ends.collect();
        minima.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        minima
    }

    /// Residuals and their derivatives.
    pub fn slopes(&self, unknowns: &Unknowns<'_>, q: &[f64]) -> Option<(Vec<f64>, DMatrix<f64>)> {
        let problem = Problem {
            residuals: &|q: &[f64]| self.residuals(unknowns, q),
            bounds: self.bounds(unknowns),
            lengths: self.lengths(unknowns),
            floor: 0.0,
            offset: OFFSET,
            stall: Stall::of(OFFSET),
        };
        let here = self.residuals(unknowns, q)?;
        let slopes = problem.slopes(q, &here, Order::Fourth)?;
        Some((here, slopes))
    }

    /// Noise from the medians of residuals, of all frames.
    pub fn robust_noise(&self, raw: &[f64]) -> Noise {
        let (position, angle) = raw.split_at((2 * self.model.frames()).min(raw.len()));
        self.floored(Noise {
            position: NORMAL * median_size(position),
            angle: NORMAL * median_size(angle),
        })
    }

    /// Noise from the squares of residuals of the frames that are used; positions and angles have `paid` for as many
    /// parameters.
    pub fn mean_noise(&self, raw: &[f64], paid: [f64; 2]) -> Noise {
        let mut squares = [0.0; 2];
        for (i, r) in raw.iter().enumerate() {
            if self.weight(i) > 0.0 {
                squares[self.kind(i)] += r * r;
            }
        }
        let mean = |kind: usize| {
            let left = (self.readings_of(kind) as f64 - paid[kind]).max(1.0);
            (squares[kind] / left).sqrt()
        };
        self.floored(Noise {
            position: mean(0),
            angle: mean(1),
        })
    }

    fn floored(&self, noise: Noise) -> Noise {
        let extent = self.model.scale("x0");
        Noise {
            position: noise
                .position
                .max(LEAST_NOISE * extent)
                .max(f64::MIN_POSITIVE),
            angle: noise.angle.max(LEAST_NOISE),
        }
    }
}

/// Noise of a track from third differences, which a smooth motion hardly has.
pub(super) fn first_noise(track: &Track) -> Noise {
    let third = |values: &[f64]| -> Vec<f64> {
        let fours = values.windows(4);
        fours.map(|w| w[3] - w[0] - 3.0 * (w[2] - w[1])).collect()
    };
    let of = |differences: &[f64]| NORMAL * median_size(differences) / THIRD_DIFFERENCE.sqrt();
    let positions = [third(track.x()), third(track.y())].concat();
    let angles = third(track.angle().unwrap_or_default());
    let least = ASSUMED_NOISE * track.extent();
    Noise {
        position: of(&positions).max(least).max(f64::MIN_POSITIVE),
        angle: of(&angles).max(ASSUMED_NOISE),
    }
}

/// Median of absolute values; 0 of none.
fn median_size(values: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = values.iter().map(|x| x.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
}
