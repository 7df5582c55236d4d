//! The pressure under a foot from quasi-static pushes.
//!
//! A push is a motion and the wrench that it took. Friction of a point that carries the load N and moves with
//! the velocity q is μN q/|q|: the wrench is linear in the loads of all points of the foot, whose distribution
//! is the non-negative one with the least squares. Beside it stand the models that planners use: the ellipsoid and
//! the convex quartic of Zhou, Paolini, Bagnell, Mason, ICRA 2016, page 372, both fitted to the same pushes.
//!
//! A model is judged by the motion that it foretells for a wrench, the normal of its limit surface: by the angle
//! to the measured one, with the spin in units of a length ([`SupportFit::length`]). Fitted models are
//! cross-validated in 5 parts: push i belongs to part i mod 5, and is foretold by a model of the other four.

mod convex_form;
pub(super) mod nnls;
mod nodes;
mod points;

use super::FitError;
use convex_form::ConvexForm;
use nalgebra::Vector3;
use points::Points;
use tribos_core::Real;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::patch::nodes::{Node, NodeSlice};
use tribos_core::twist::{Twist, Wrench};
use tribos_friction::{Area, FrictionError, Patch, points_of};

/// A measured push: a motion of the body, of which the direction alone counts, and the wrench on it.
///
/// *Units*: m, rad; N, N m, about the origin of the body's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredPush {
    /// Displacement or velocity of the origin, and turn or spin.
    pub motion: Twist<f64>,
    /// The wrench that the pusher exerts.
    pub wrench: Wrench<f64>,
}

/// Angles between the motions that a model foretells and the measured ones. A motion that is not found is farther off than
/// all others, and there is no mean then.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// `known`, `pressure`, `ellipsoid` or `quartic`.
    pub name: &'static str,
    /// Median in degrees.
    pub median: f64,
    /// Mean in degrees; NaN if the motion under some push is not found.
    pub mean: f64,
}

/// A fitted pressure, and how well it and other models foretell motions.
#[derive(Clone, Debug, PartialEq)]
pub struct SupportFit {
    /// The models, fitted ones cross-validated.
    pub models: Vec<Score>,
    /// Loads times μ at points of the foot, in N; those without load are left out.
    pub pressure: Vec<Node<f64>>,
    /// Centre of pressure, in m.
    pub centre_of_pressure: [f64; 2],
    /// Sum of the loads times μ, in N.
    pub force_limit: f64,
    /// Length by which torques are divided and spins multiplied, in m: the ratio of what nine tenths of the
    /// torques and of the forces do not exceed.
    pub length: f64,
}

/// Parts of the cross-validation.
const PARTS: usize = 5;
/// Pushes below which nothing is fitted.
const FEWEST: usize = 10;
/// Part of the torques and forces that give the length.
const USUAL: f64 = 0.9;

impl SupportFit {
    /// Fits the pressure under a foot to pushes, and compares models.
    ///
    /// *Domain*: at least 10 pushes, finite, each with a motion and a wrench, some with a torque. `known` is the support if it is
    /// known, in the coordinates of the pushes: a box, a polygon, a bar, a mesh or points.
    /// Without a support the points lie on a grid over the disc of 2.2 lengths around the origin.
    ///
    /// ```
    /// use tribos::fit::support::{MeasuredPush, SupportFit};
    /// use tribos::friction::Area;
    /// use tribos::prelude::*;
    /// let tile: Patch = "box:0.2x0.1".parse()?; // m
    /// let floor = Area::named(&tile, 1.0, None)?.limit_surface(4.0)?; // μN in N
    /// let pushes: Vec<MeasuredPush> = (0..40)
    ///     .map(|i| {
    ///         let (a, b) = (0.7 * f64::from(i), 1.3 * f64::from(i));
    ///         let motion = Twist::new(a.sin(), a.cos(), 15.0 * b.sin());
    ///         MeasuredPush { motion, wrench: -floor.wrench(&motion) }
    ///     })
    ///     .collect();
    /// let fit = SupportFit::new(&pushes, Some(&tile))?;
    /// assert!(fit.centre_of_pressure.iter().all(|x| x.abs() < 1e-3)); // m
    /// assert!((fit.force_limit - 4.0).abs() < 0.04);
    /// let [known, pressure, ..] = &fit.models[..] else { return Ok(()) };
    /// assert!(known.median < 1e-6 && pressure.median < 1.0); // degrees
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(pushes: &[MeasuredPush], known: Option<&Patch>) -> Result<Self, FitError> {
        let length = checked(pushes)?;
        match known {
            None => judged(pushes, length, &nodes::disc(length), None),
            Some(patch @ Patch::Flat(flat)) => {
                let surface = Area::named(patch, 1.0, None)?.limit_surface(1.0)?;
                fit_support_within(pushes, &flat.loops()?, surface)
            }
            Some(Patch::Points(file)) => Self::at(pushes, &points_of(file)?),
            Some(other) => Err(FitError::Pushes(format!(
                "a support is a box, a polygon, a bar, a mesh or points, not {other}"
            ))),
        }
    }

    /// As [`SupportFit::new`], for a foot that stands on these points; only ratios of weights matter.
    ///
    /// *Domain*: points finite, weights not negative, one of them positive.
    pub fn at(pushes: &[MeasuredPush], points: &[Node<f64>]) -> Result<Self, FitError> {
        let length = checked(pushes)?;
        NodeSlice::new(points)
            .map_err(|error| FrictionError::from(tribos_core::Error::from(error)))?;
        let places: Vec<[f64; 2]> = points.iter().map(|node| [node.x, node.y]).collect();
        let loads = points.iter().map(|node| node.weight).collect();
        let scaled = places
            .iter()
            .map(|place| place.map(|x| x / length))
            .collect();
        let truth = Points::new(scaled, loads);
        judged(pushes, length, &places, Some(Box::new(truth)))
    }
}

/// As [`SupportFit::new`], for a support with these loops of corners, of which two make a bar, and this limit
/// surface.
#[doc(hidden)]
pub fn fit_support_within(
    pushes: &[MeasuredPush],
    loops: &[Vec<[f64; 2]>],
    surface: Box<dyn FrictionSet<f64>>,
) -> Result<SupportFit, FitError> {
    let length = checked(pushes)?;
    let truth = Box::new(Exact { surface, length });
    judged(pushes, length, &nodes::of(loops), Some(truth))
}

/// The convex quartic fitted to pushes, for comparisons.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct ConvexQuartic {
    form: ConvexForm,
    length: f64,
}

impl ConvexQuartic {
    /// As in [`SupportFit::new`].
    pub fn fitted(pushes: &[MeasuredPush]) -> Result<Self, FitError> {
        let length = checked(pushes)?;
        let form = ConvexForm::fitted(4, &rows(pushes, length)).ok_or_else(not_found)?;
        Ok(Self { form, length })
    }

    /// The push that causes a motion.
    pub fn push(&self, motion: &Twist<f64>) -> Wrench<f64> {
        let motion = Vector3::new(
            motion.velocity.x,
            motion.velocity.y,
            motion.spin * self.length,
        );
        let push = self.form.wrench(&(motion / size(&motion)));
        Wrench::new(push.x, push.y, push.z * self.length)
    }
}

/// A push in units of the length: the motion of length 1.
#[derive(Clone, Copy, Debug)]
struct Row {
    motion: Vector3<f64>,
    wrench: Vector3<f64>,
}

/// Foretells motions.
trait Model {
    /// A normal of the limit surface under a wrench, both in units of the length.
    fn motion(&self, wrench: &Vector3<f64>) -> Vector3<f64>;
}

/// A patch under uniform pressure, exact.
struct Exact {
    surface: Box<dyn FrictionSet<f64>>,
    length: f64,
}

impl Model for Exact {
    fn motion(&self, wrench: &Vector3<f64>) -> Vector3<f64> {
        let push = Wrench::new(wrench.x, wrench.y, wrench.z * self.length);
        let motion = self.surface.twist_normal_to(&push);
        let spin = motion.spin * self.length;
        Vector3::new(motion.velocity.x, motion.velocity.y, spin)
    }
}

/// The length of valid pushes.
fn checked(pushes: &[MeasuredPush]) -> Result<f64, FitError> {
    if pushes.len() < FEWEST {
        let given = pushes.len();
        return Err(FitError::Pushes(format!(
            "{given} pushes are too few for a fit; give at least {FEWEST}"
        )));
    }
    for (push, MeasuredPush { motion, wrench }) in pushes.iter().enumerate() {
        let parts = [
            (
                "motion",
                [motion.velocity.x, motion.velocity.y, motion.spin],
            ),
            ("wrench", [wrench.force.x, wrench.force.y, wrench.torque]),
        ];
        for (name, part) in parts {
            let message = if !part.iter().all(|x| x.is_finite()) {
                format!("the {name} must be finite")
            } else if part == [0.0; 3] {
                format!("the {name} must not be zero: a push moves the body and takes a force")
            } else {
                continue;
            };
            return Err(FitError::Push { push, message });
        }
    }
    let usual = |of: fn(&MeasuredPush) -> f64| {
        let mut all: Vec<f64> = pushes.iter().map(of).collect();
        all.sort_by(f64::total_cmp);
        let at = (USUAL * all.len() as f64) as usize;
        all.get(at).copied().unwrap_or(f64::NAN)
    };
    let force = usual(|push| Real::hypot(push.wrench.force.x, push.wrench.force.y));
    let length = usual(|push| push.wrench.torque.abs()) / force;
    if length > 0.0 && length.is_finite() {
        Ok(length)
    } else {
        Err(FitError::Pushes(
            "a tenth of the pushes at least must have a torque, and most of them a force".into(),
        ))
    }
}

fn rows(pushes: &[MeasuredPush], length: f64) -> Vec<Row> {
    let row = |MeasuredPush { motion, wrench }: &MeasuredPush| {
        let motion = Vector3::new(motion.velocity.x, motion.velocity.y, motion.spin * length);
        Row {
            motion: motion / size(&motion),
            wrench: Vector3::new(wrench.force.x, wrench.force.y, wrench.torque / length),
        }
    };
    pushes.iter().map(row).collect()
}

fn size(v: &Vector3<f64>) -> f64 {
    Real::hypot(Real::hypot(v.x, v.y), v.z)
}

/// Scores of all models, and the pressure of all pushes.
fn judged(
    pushes: &[MeasuredPush],
    length: f64,
    places: &[[f64; 2]],
    truth: Option<Box<dyn Model>>,
) -> Result<SupportFit, FitError> {
    let rows = rows(pushes, length);
    let mut models: Vec<Score> = truth
        .iter()
        .map(|truth| score("known", rows.iter().map(|row| off(&**truth, row))))
        .collect();
    let places: Vec<[f64; 2]> = places
        .iter()
        .map(|place| place.map(|x| x / length))
        .collect();
    let pressure = |rows: &[Row]| boxed(Points::fitted(&places, rows));
    let ellipsoid = |rows: &[Row]| boxed(ConvexForm::fitted(2, rows));
    let quartic = |rows: &[Row]| boxed(ConvexForm::fitted(4, rows));
    models.push(score("pressure", crossed(&rows, &pressure)?.into_iter()));
    models.push(score("ellipsoid", crossed(&rows, &ellipsoid)?.into_iter()));
    models.push(score("quartic", crossed(&rows, &quartic)?.into_iter()));
    let pressure = Points::fitted(&places, &rows).ok_or_else(not_found)?;
    let pressure = pressure.nodes(length);
    let force_limit: f64 = pressure.iter().map(|node| node.weight).sum();
    let mean = |of: fn(&Node<f64>) -> f64| {
        let moments = pressure.iter().map(|node| node.weight * of(node));
        moments.sum::<f64>() / force_limit
    };
    Ok(SupportFit {
        models,
        centre_of_pressure: [mean(|node| node.x), mean(|node| node.y)],
        pressure,
        force_limit,
        length,
    })
}

/// A model, or why there is none.
type Fitted = Result<Box<dyn Model>, FitError>;

fn boxed<M: Model + 'static>(model: Option<M>) -> Fitted {
    model
        .map(|model| Box::new(model) as Box<dyn Model>)
        .ok_or_else(not_found)
}

fn not_found() -> FitError {
    FitError::Pushes(
        "the search for the least squares did not end: the motions are too much alike; give pushes in more directions"
            .into(),
    )
}

/// Angles of all pushes, each foretold by a model of the parts that it does not belong to.
fn crossed(rows: &[Row], fitted: &dyn Fn(&[Row]) -> Fitted) -> Result<Vec<f64>, FitError> {
    let mut angles = Vec::with_capacity(rows.len());
    for part in 0..PARTS {
        let is_in = |i: usize| i % PARTS == part;
        let others = rows.iter().enumerate().filter(|(i, _)| !is_in(*i));
        let model = fitted(&others.map(|(_, row)| *row).collect::<Vec<Row>>())?;
        let mine = rows.iter().enumerate().filter(|(i, _)| is_in(*i));
        angles.extend(mine.map(|(_, row)| off(&*model, row)));
    }
    Ok(angles)
}

/// Angle between the measured motion and the one foretold, in degrees.
fn off(model: &dyn Model, row: &Row) -> f64 {
    let motion = model.motion(&row.wrench);
    let motion = motion / size(&motion);
    // Half of it is the angle between one of two vectors of the same length and their sum.
    let tangent = size(&(motion - row.motion)) / size(&(motion + row.motion));
    2.0 * Real::atan(tangent).to_degrees()
}

fn score(name: &'static str, angles: impl Iterator<Item = f64>) -> Score {
    let mut angles: Vec<f64> = angles.map(f64::abs).collect();
    angles.sort_by(f64::total_cmp);
    let (count, half) = (angles.len(), angles.len() / 2);
    let middle = if count.is_multiple_of(2) {
        0.5 * (angles[half - 1] + angles[half])
    } else {
        angles[half]
    };
    Score {
        name,
        median: middle,
        mean: angles.iter().sum::<f64>() / count as f64,
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;
