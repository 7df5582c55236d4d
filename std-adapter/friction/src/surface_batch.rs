//! Many questions at once to the limit surfaces of an area.

use super::surface::BoxedDryFriction;
use std::fmt;
use tribos_core::contact::TimeStep;
use tribos_core::limit_surface::{FrictionSet, Projection, RoundLimitSurface};
use tribos_core::planar::{PlanarBody, PlanarStep};
use tribos_core::twist::{Twist, Wrench};

/// The limit surfaces of an area, one for each element of a batch ([`super::LimitSurfaces::under_each`]).
///
/// Answers have the bits of calls on the surface of each element. On round patches elements go side by side; elsewhere
/// equal force limits in a row share a surface. Slices are as long as that of the force limits.
pub struct SurfaceBatch<'a>(Surfaces<'a>);

enum Surfaces<'a> {
    /// The surface under the force limit 1, and the limits.
    Round(Box<UnitSurface<'a>>, &'a [f64]),
    Runs(Runs<'a>),
}

type UnitSurface<'a> = RoundLimitSurface<f64, &'a dyn BoxedDryFriction<f64>>;

/// Numbers of elements, and the surface of each.
pub type Runs<'a> = Vec<(usize, Box<dyn FrictionSet<f64> + 'a>)>;

impl fmt::Debug for SurfaceBatch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = match &self.0 {
            Surfaces::Round(_, limits) => limits.len(),
            Surfaces::Runs(runs) => runs.iter().map(|(count, _)| count).sum(),
        };
        write!(f, "SurfaceBatch of {count}")
    }
}

impl<'a> SurfaceBatch<'a> {
    pub(super) fn of_round(unit: UnitSurface<'a>, limits: &'a [f64]) -> Self {
        Self(Surfaces::Round(Box::new(unit), limits))
    }

    pub(super) fn of_runs(runs: Runs<'a>) -> Self {
        Self(Surfaces::Runs(runs))
    }

    /// [`FrictionSet::gauge`] of wrenches.
    pub fn gauge_batch(&self, wrenches: &[Wrench<f64>], gauges: &mut [f64]) {
        match &self.0 {
            Surfaces::Round(unit, limits) => unit.gauge_batch(limits, wrenches, gauges),
            Surfaces::Runs(runs) => {
                for ((wrench, gauge), set) in wrenches.iter().zip(gauges).zip(each(runs)) {
                    *gauge = set.gauge(wrench);
                }
            }
        }
    }

    /// [`FrictionSet::twist_normal_to`] of pushes.
    pub fn twist_normal_to_batch(&self, pushes: &[Wrench<f64>], twists: &mut [Twist<f64>]) {
        match &self.0 {
            Surfaces::Round(unit, _) => unit.twist_normal_to_batch(pushes, twists),
            Surfaces::Runs(runs) => {
                for ((push, twist), set) in pushes.iter().zip(twists).zip(each(runs)) {
                    *twist = set.twist_normal_to(push);
                }
            }
        }
    }

    /// [`FrictionSet::project_with_length`] of wrenches; no length for the radius.
    pub fn project_batch(
        &self,
        length: Option<f64>,
        wrenches: &[Wrench<f64>],
        projections: &mut [Projection<f64>],
    ) {
        match &self.0 {
            Surfaces::Round(unit, limits) => {
                let length = length.unwrap_or(unit.radius());
                unit.project_batch(length, limits, wrenches, projections);
            }
            Surfaces::Runs(runs) => {
                for ((wrench, nearest), set) in wrenches.iter().zip(projections).zip(each(runs)) {
                    *nearest = set.project_with_length(wrench, length.unwrap_or(set.radius()));
                }
            }
        }
    }

    /// [`PlanarBody::step`] of bodies with their time steps; one for all, or one for each.
    pub fn step_batch(
        &self,
        bodies: &[(PlanarBody<f64>, TimeStep<f64>)],
        twists: &[Twist<f64>],
        pushes: &[Wrench<f64>],
        steps: &mut [PlanarStep<f64>],
    ) {
        match (&self.0, bodies) {
            (Surfaces::Round(unit, limits), [(body, dt)]) => {
                body.step_batch_under_loads(unit, limits, twists, pushes, *dt, steps);
            }
            (Surfaces::Round(unit, limits), bodies) => {
                let given = twists.chunks(1).zip(pushes.chunks(1)).zip(limits.chunks(1));
                let given = given.zip(steps.chunks_mut(1)).zip(bodies);
                for ((((twist, push), limit), step), (body, dt)) in given {
                    body.step_batch_under_loads(unit, limit, twist, push, *dt, step);
                }
            }
            (Surfaces::Runs(runs), bodies) => {
                let given = twists.iter().zip(pushes).zip(steps);
                for (((twist, push), step), ((body, dt), set)) in
                    given.zip(bodies.iter().cycle().zip(each(runs)))
                {
                    *step = body.step(set, twist, push, *dt);
                }
            }
        }
    }
}

/// The surface of each element.
fn each<'b>(runs: &'b Runs<'_>) -> impl Iterator<Item = &'b dyn FrictionSet<f64>> {
    runs.iter()
        .flat_map(|(count, set)| std::iter::repeat_n(&**set, *count))
}
