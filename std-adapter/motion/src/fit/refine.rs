//! The motion between the points of a record: steps until the answer no longer depends on them.

use super::Measurements;
use super::abrupt::{is_stepped, jumps};
use super::jacobian::{DifferenceScale, Order};
use super::linearised::Linearised;
use super::minimise::{Minimum, OFFSET};
use super::parameter::{Between, Model, VelocityCourse};
use super::sample::WeightedData;
use super::search::{ProgressWatch, ROUGH, descents, problem};
use super::unknowns::Unknowns;

/// Change of a parameter, in standard errors, that more steps may still make.
const AGREE: f64 = 0.1;
/// Change, in standard errors, by another course of the velocity that is told.
const TOLD: f64 = 0.5;
/// Difference of the sums of squares, in variances, beyond which the data refute the worse course.
const REFUTED: f64 = 10.0;
/// The same difference where the sums of squares come from slopes alone.
const CLEAR: f64 = 100.0;
/// Share of the change by a refuted course that the better one may still miss.
const MISSED: f64 = 0.1;
/// Share of the change by jumps that the data have not decided.
const HIDDEN: f64 = 0.5;
/// Most intervals of a ramp that they do not resolve.
const RAMP: usize = 3;
/// Change of a parameter, over the parameter, that is rounding.
const NOTHING: f64 = 1e-4;
/// Factor from one number of steps to the next: errors shrink by its square.
const MORE: u32 = 4;
/// Most steps between two points.
const MOST: u32 = 64;
/// Most steps in a record.
const MOST_IN_ALL: usize = 20_000_000;

/// A change of one parameter, in its standard errors, by what the record leaves open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shift {
    /// Index of the parameter.
    pub parameter: usize,
    /// New value less old one.
    pub change: f64,
    /// The same over the standard error.
    pub errors: f64,
}

impl Shift {
    /// A share of it.
    fn part(self, share: f64) -> Self {
        Self {
            change: share * self.change,
            errors: share * self.errors,
            ..self
        }
    }
}

/// What another path would change, by the slopes on this one.
struct Change {
    /// The largest change of a parameter, if it counts.
    shift: Option<Shift>,
    /// Coordinates of the minimum there.
    place: Vec<f64>,
    /// The least sum of squares there.
    cost: f64,
}

/// The minima on the chosen path.
pub(super) struct Refined<'a> {
    /// The model on that path, if it is another than the given one.
    pub model: Option<Box<dyn Model + 'a>>,
    /// Different minima by rising cost.
    pub minima: Vec<(Minimum, usize)>,
    /// The path.
    pub path: Between,
    /// What more steps would still change, if that counts.
    pub by_steps: Option<Shift>,
    /// What another course between the points would change, if that counts.
    pub by_course: Option<Shift>,
}

/// A search whose model may be followed along other paths.
pub(super) struct Paths<'a, 'b> {
    pub model: &'a dyn Model,
    pub unknowns: &'b Unknowns<'a>,
    pub data: &'b Measurements,
    pub target: &'b WeightedData,
    pub lengths: &'b [DifferenceScale],
    pub watch: &'b ProgressWatch<'b>,
}

impl<'a> Paths<'a, '_> {
    /// Minima at which neither more steps nor another course between the points count any more, or what they change.
    pub fn refine(&self, minima: Vec<(Minimum, usize)>) -> Option<Refined<'a>> {
        let mut found = Refined {
            model: None,
            minima,
            path: Between::PLAIN,
            by_steps: None,
            by_course: None,
        };
        if self.model.along(Between::PLAIN).is_some() {
            if is_stepped(self.data.velocities()) {
                let jumps = Between {
                    steps: 1,
                    course: VelocityCourse::Jumps,
                };
                if let Some(other) = self.on(jumps, &found.minima, ROUGH)
                    && cost(&other.minima) < cost(&found.minima)
                {
                    found = other;
                    found.by_course = self.by_ramps(&found);
                }
            } else {
                let smooth = self.more_steps(&mut found, Some(VelocityCourse::Smooth));
                self.choose_course(&mut found, smooth);
            }
        }
        self.precise(&found)
    }

    /// What ramps that a few points hardly show may change, where the velocity stays between them.
    fn by_ramps(&self, found: &Refined<'a>) -> Option<Shift> {
        let jumps = jumps(self.data.velocities());
        let has_ramps = jumps.windows(2).any(|pair| pair[1] - pair[0] <= RAMP);
        let straight = has_ramps.then(|| self.shift(found, Between::PLAIN))??;
        Some(straight.part(MISSED)).filter(|shift| shift.errors > TOLD)
    }

    /// The same minima without the errors of a rough search.
    fn precise(&self, found: &Refined<'a>) -> Option<Refined<'a>> {
        Some(Refined {
            by_steps: found.by_steps,
            by_course: found.by_course,
            ..self.on(found.path, &found.minima, OFFSET)?
        })
    }

    /// Takes the course between the points, straight or smooth, that suits the data better, and tells what another one
    /// would change; `seen` is what the smooth one changes.
    fn choose_course(&self, found: &mut Refined<'a>, seen: Option<Change>) {
        let smooth = Self::beside(found, VelocityCourse::Smooth);
        let clear = cost(&found.minima) + CLEAR * self.variance(found);
        let mut told = seen.as_ref().and_then(|seen| seen.shift);
        if seen.is_some_and(|seen| seen.cost > clear) {
            told = told.map(|shift| shift.part(MISSED));
        } else if told.is_some()
            && let Some(mut other) = self.on(smooth, &found.minima, ROUGH)
        {
            self.more_steps(&mut other, None);
            if cost(&other.minima) < cost(&found.minima) {
                std::mem::swap(found, &mut other);
            }
            if cost(&other.minima) - cost(&found.minima) > REFUTED * self.variance(found) {
                told = told.map(|shift| shift.part(MISSED));
            }
        }
        let by_jumps = self.by_jumps(found);
        let counts = told.into_iter().chain(by_jumps);
        let counts = counts.filter(|shift| shift.errors > TOLD);
        found.by_course = counts.max_by(|a, b| a.errors.total_cmp(&b.errors));
    }

    /// Variance of a residual.
    fn variance(&self, found: &Refined<'a>) -> f64 {
        let freedoms = self.data.friction().len() - self.unknowns.sought.len();
        cost(&found.minima) / freedoms as f64
    }

    /// Takes jumps where the velocity changes abruptly, if the data ask for them, or tells what they would change.
    fn by_jumps(&self, found: &mut Refined<'a>) -> Option<Shift> {
        let count = jumps(self.data.velocities()).len();
        if count == 0 {
            return None;
        }
        let path = Between {
            steps: found.path.steps,
            course: VelocityCourse::Jumps,
        };
        let mut other = self.on(path, &found.minima, ROUGH)?;
        // The instant of each is a freedom (Akaike 1974).
        if cost(&other.minima) + 2.0 * count as f64 * self.variance(&other) < cost(&found.minima) {
            std::mem::swap(found, &mut other);
            self.more_steps(found, None);
            return self
                .shift(found, other.path)
                .map(|shift| shift.part(MISSED));
        }
        self.shift(found, path).map(|shift| shift.part(HIDDEN))
    }

    /// Another course with as many steps, but enough to follow a curve.
    fn beside(found: &Refined<'_>, course: VelocityCourse) -> Between {
        Between {
            steps: found.path.steps.max(MORE),
            course,
        }
    }

    /// Takes more steps until they no longer count; gives what another course beside would change then.
    fn more_steps(
        &self,
        found: &mut Refined<'a>,
        beside: Option<VelocityCourse>,
    ) -> Option<Change> {
        loop {
            let next = Between {
                steps: found.path.steps * MORE,
                ..found.path
            };
            let other = beside.map(|course| Self::beside(found, course));
            let [more, other] = self.changes(found, [Some(next), other]);
            found.by_steps = more.as_ref().and_then(|more| more.shift);
            let steps = next.steps as usize * self.data.friction().len();
            if found.by_steps.is_none() || next.steps > MOST || steps > MOST_IN_ALL {
                return other;
            }
            let places = self.foreseen(found, next, more);
            match self.on(next, places.as_deref().unwrap_or(&found.minima), ROUGH) {
                Some(finer) => *found = finer,
                None => return other,
            }
        }
    }

    /// The minima with the best one where the slopes foresee it on a path, if the sum of squares is smaller there.
    fn foreseen(
        &self,
        found: &Refined<'a>,
        path: Between,
        change: Option<Change>,
    ) -> Option<Vec<(Minimum, usize)>> {
        let model = self.model.along(path)?;
        let there = self.unknowns.with(model.as_ref());
        let squares = |q: &[f64]| {
            let residuals = self.target.residuals(&there, q)?;
            Some(residuals.iter().map(|r| r * r).sum::<f64>())
        };
        let mut minima = found.minima.clone();
        let best = &mut minima.first_mut()?.0.q;
        let place = change?.place;
        let is_lower = squares(&place)? < squares(best)?;
        if is_lower {
            *best = place;
        }
        Some(minima)
    }

    /// The minimum on the same path that a search from these coordinates finds, if it is lower.
    pub fn lower(&self, found: &Refined<'a>, place: Vec<f64>) -> Option<Refined<'a>> {
        let (best, _) = found.minima.first()?;
        let start = Minimum {
            q: place,
            ..best.clone()
        };
        let mut lower = self.on(found.path, &[(start, 1)], ROUGH)?;
        if cost(&lower.minima) >= best.cost {
            return None;
        }
        lower.by_course = found.by_course;
        if self.model.along(found.path).is_some() {
            self.more_steps(&mut lower, None);
        }
        self.precise(&lower)
    }

    /// The minima on another path, to a relative offset.
    fn on(&self, path: Between, from: &[(Minimum, usize)], offset: f64) -> Option<Refined<'a>> {
        let model = match path {
            Between::PLAIN => None,
            _ => Some(self.model.along(path)?),
        };
        let unknowns = self.unknowns.with(model.as_deref().unwrap_or(self.model));
        let places: Vec<Vec<f64>> = from.iter().map(|(end, _)| end.q.clone()).collect();
        let target = (self.target, offset);
        let ends = descents(&unknowns, target, self.lengths, &places, self.watch);
        let counted = ends.into_iter().zip(from);
        let mut minima: Vec<_> = counted
            .filter_map(|(end, (_, count))| Some((end?, *count)))
            .collect();
        minima.sort_by(|(a, _), (b, _)| a.cost.total_cmp(&b.cost));
        (!minima.is_empty()).then_some(Refined {
            model,
            minima,
            path,
            by_steps: None,
            by_course: None,
        })
    }

    /// The largest change, in standard errors, of a parameter on another path, if it counts.
    fn shift(&self, found: &Refined<'a>, path: Between) -> Option<Shift> {
        let [change] = self.changes(found, [Some(path)]);
        change?.shift
    }

    /// What other paths would change.
    fn changes<const N: usize>(
        &self,
        found: &Refined<'a>,
        paths: [Option<Between>; N],
    ) -> [Option<Change>; N] {
        let here = self
            .unknowns
            .with(found.model.as_deref().unwrap_or(self.model));
        let residuals = |q: &[f64]| self.target.residuals(&here, q);
        let problem = problem(&residuals, &here, self.target, self.lengths);
        let best = found.minima.first();
        let at = best.and_then(|(best, _)| Linearised::at(&problem, &best.q, Order::Second));
        let at = at.zip(best.map(|(best, _)| best.q.as_slice()));
        paths.map(|path| {
            let ((at, q), path) = at.as_ref().zip(path)?;
            self.change((&here, at, q), path)
        })
    }

    /// What another path would change, from the slopes at a minimum.
    fn change(
        &self,
        (here, at, q): (&Unknowns<'_>, &Linearised, &[f64]),
        path: Between,
    ) -> Option<Change> {
        let other = self.model.along(path)?;
        let moved = self
            .target
            .residuals(&self.unknowns.with(other.as_ref()), q)?;
        let cost = at.least(&moved);
        let mut change = moved;
        for (there, here) in change.iter_mut().zip(&at.residuals) {
            *there -= here;
        }
        let response = at.response(&change);
        let place = q.iter().zip(response.iter()).map(|(q, step)| q + step);
        let values = here.values(q);
        let slopes = here.slopes(&values);
        let covariance = &slopes * at.covariance(here) * slopes.transpose();
        let steps = &slopes * &response;
        let shifts = here.sought.iter().enumerate().map(|(k, &parameter)| {
            let error = covariance[(k, k)].sqrt() * at.deviation();
            Shift {
                parameter,
                change: steps[k],
                errors: (steps[k] / error).abs(),
            }
        });
        let counts = |shift: &Shift| {
            shift.errors > AGREE && shift.change.abs() > NOTHING * values[shift.parameter].abs()
        };
        let shifts = shifts.filter(|shift| shift.errors.is_finite() && counts(shift));
        Some(Change {
            shift: shifts.max_by(|a, b| a.errors.total_cmp(&b.errors)),
            place: place.collect(),
            cost,
        })
    }
}

fn cost(minima: &[(Minimum, usize)]) -> f64 {
    minima.first().map_or(f64::INFINITY, |(end, _)| end.cost)
}
