//! The feet of one body on the ground: the kernel's step for one foot with an exact limit surface,
//! elements of area for any others.

use crate::elements::Elements;
use crate::ended::Ended;
use crate::foot::Foot;
use crate::footprint::SurfaceAside;
use crate::surface::{Motion, Surface};
use crate::symmetric::times;
use tribos_core::contact::TimeStep;
use tribos_core::limit_surface::LimitEllipsoid;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};

/// A body on its feet. See the [crate's example](crate).
#[derive(Debug)]
pub struct Standing<'a> {
    body: &'a PlanarBody<f32>,
    coupled: Option<&'a [f64; 6]>,
    on: FootSolver<'a>,
}

#[derive(Debug)]
enum FootSolver<'a> {
    /// One foot with its exact limit surface.
    Exact {
        surface: Exact<'a>,
        limit: f32,
        axis: [f64; 2],
    },
    Elements(Box<Elements<'a>>),
    /// Nothing resists.
    Nothing,
}

/// A limit surface about the centre of mass.
#[derive(Debug)]
pub(crate) enum Exact<'a> {
    Prepared(&'a Surface),
    Moved(SurfaceAside),
}

impl Exact<'_> {
    fn surface(&self) -> &Surface {
        match self {
            Self::Prepared(surface) => surface,
            Self::Moved(kept) => kept.surface(),
        }
    }
}

impl<'a> Standing<'a> {
    /// `body` on `feet`. `coupled` has the components xx, xy, yy, xn, yn, nn of the mass matrix of the
    /// relative motion if friction moves the ground as well, by x, y and the rotation about the normal.
    pub fn new(
        body: &'a PlanarBody<f32>,
        coupled: Option<&'a [f64; 6]>,
        feet: &[Foot<'a>],
    ) -> Self {
        Self::with_surface(body, coupled, feet, None)
    }

    /// The same with the surface that was [kept](Self::surface_aside) from a step before, where it is that of the foot.
    pub fn with_surface(
        body: &'a PlanarBody<f32>,
        coupled: Option<&'a [f64; 6]>,
        feet: &[Foot<'a>],
        kept: Option<&SurfaceAside>,
    ) -> Self {
        let on = match (feet, coupled) {
            ([foot], None) => FootSolver::alone(foot, kept),
            _ => None,
        };
        let on = on.unwrap_or_else(|| FootSolver::Elements(Box::new(Elements::of(feet))));
        Self { body, coupled, on }
    }

    /// The surface of a foot alone whose middle is not below the centre of mass.
    pub fn surface_aside(&self) -> Option<SurfaceAside> {
        match &self.on {
            FootSolver::Exact {
                surface: Exact::Moved(kept),
                ..
            } => Some(kept.clone()),
            _ => None,
        }
    }

    /// The mean push that makes `change` of the motion in a time `dt`.
    pub(crate) fn push(&self, change: &Twist<f32>, dt: f32) -> Wrench<f32> {
        push(self.body, self.coupled, change, dt)
    }

    /// The mass matrix of the relative motion.
    fn mass(&self) -> [f64; 6] {
        let [mass, inertia] = [self.body.mass(), self.body.inertia()].map(f64::from);
        let alone = [mass, 0.0, mass, 0.0, 0.0, inertia];
        self.coupled.copied().unwrap_or(alone)
    }

    /// `body` on points in the plane, each given by its place from the centre of mass in metres and its
    /// friction limit in newtons: where a foot lies on several materials.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::planar::PlanarBody;
    /// use tribos_core::twist::{Twist, Wrench};
    /// use tribos_feet::Standing;
    /// // The left runner of a sledge is on snow, the right one on gravel.
    /// let sledge = PlanarBody::new(20.0, 2.0)?;
    /// let points = [([0.0, 0.2], 5.0), ([0.0, -0.2], 50.0)];
    /// let standing = Standing::on_points(&sledge, &points);
    /// let dt = TimeStep::new(1.0 / 60.0)?;
    /// let end = standing.step(&Twist::new(2.0, 0.0, 0.0), &Wrench::ZERO, dt).ok_or("not finite")?;
    /// assert!(end.twist.velocity.x < 2.0 && end.twist.spin < 0.0); // it turns to the right
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn on_points(body: &'a PlanarBody<f32>, points: &[([f64; 2], f32)]) -> Self {
        Self {
            body,
            coupled: None,
            on: FootSolver::Elements(Box::new(Elements::of_points(points))),
        }
    }

    /// The motion after `dt` from `before` under a constant push. `None` for a motion that is not finite.
    pub fn step(
        &self,
        before: &Twist<f32>,
        push: &Wrench<f32>,
        dt: TimeStep<f32>,
    ) -> Option<Ended> {
        self.step_sticking(1.0, before, push, dt)
    }

    /// The same with friction that is `strength` = mu_s/mu_d times that of the feet while the body rests.
    ///
    /// A body at rest, whose motion is exactly zero, stays while the static friction holds it, and slides under that of the
    /// feet beyond, in the same step ([`PlanarBody::step_sticking`]). A body that moves is caught where friction of the feet
    /// brings it to rest, and one on a single foot also where it turns back under a push that static friction holds.
    /// *Domain*: `strength` is finite; less than 1 counts as 1. `None` for NaN.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::planar::PlanarBody;
    /// use tribos_core::twist::{Twist, Wrench};
    /// use tribos_feet::{Foot, Footprint, Standing};
    /// let (stool, disk) = (PlanarBody::new(5.0, 0.1)?, Footprint::disk(0.02)?);
    /// let feet = [[0.2, 0.0], [-0.1, 0.17], [-0.1, -0.17]].map(|place| Foot::new(&disk, 6.0, place)); // N, m
    /// let (standing, dt) = (Standing::new(&stool, None, &feet), TimeStep::new(1.0 / 60.0)?);
    /// // 18 N in motion, 27 N at rest.
    /// let [held, slides] = [26.0, 28.0].map(|force| {
    ///     standing.step_sticking(1.5, &Twist::ZERO, &Wrench::new(force, 0.0, 0.0), dt)
    /// });
    /// assert!(held.is_some_and(|end| end.is_at_rest()));
    /// let speed = slides.ok_or("not finite")?.twist.velocity.x;
    /// assert!((speed - (28.0 - 18.0) / 5.0 / 60.0).abs() < 1e-5); // m/s
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn step_sticking(
        &self,
        strength: f32,
        before: &Twist<f32>,
        push: &Wrench<f32>,
        dt: TimeStep<f32>,
    ) -> Option<Ended> {
        if strength.is_nan() {
            return None;
        }
        let step = match &self.on {
            FootSolver::Elements(elements) => {
                let held = (strength > 1.0 && *before == Twist::ZERO)
                    .then(|| self.held(elements, strength, push, dt));
                return match held.flatten() {
                    Some(held) => Some(held),
                    None => elements.step(&self.mass(), before, push, dt.dt()),
                };
            }
            FootSolver::Exact {
                surface,
                limit,
                axis,
            } => {
                let surface = surface.surface();
                let motion = Motion { before, push, dt };
                surface.step([*limit, strength], *axis, self.body, motion)?
            }
            FootSolver::Nothing => {
                let nothing = LimitEllipsoid::new(0.0, 1.0, 1.0).ok()?;
                self.body.step(&nothing, before, push, dt)
            }
        };
        Some(Ended {
            twist: step.twist,
            friction: step.friction,
            holds: step.is_at_rest,
            all: Vec::new(),
        })
    }

    /// A body at rest on several feet, if static friction holds it: under a push and with a mass that are `strength` times
    /// smaller the motion without friction is the same, and so is what holds it.
    fn held(
        &self,
        elements: &Elements<'_>,
        strength: f32,
        push: &Wrench<f32>,
        dt: TimeStep<f32>,
    ) -> Option<Ended> {
        let mass = self.mass().map(|part| part / f64::from(strength));
        let reduced = *push * (1.0 / strength);
        let mut end = elements.step(&mass, &Twist::ZERO, &reduced, dt.dt())?;
        if !end.holds {
            return None;
        }
        for foot in &mut end.all {
            foot.wrench = foot.wrench * strength;
        }
        end.friction = -*push;
        Some(end)
    }

    /// The fraction of a step until rest, for a step that began with `before` and ended at rest.
    pub(crate) fn share(&self, ended: &Ended, before: &Twist<f32>) -> f32 {
        let friction = &ended.friction;
        match &self.on {
            FootSolver::Exact {
                surface,
                limit,
                axis,
            } => surface.surface().share(*limit, *axis, friction),
            FootSolver::Elements(elements) => {
                let share = -friction.power(before) / elements.dissipation(before);
                // No friction under no load: no fraction.
                if share > 0.0 { share.min(1.0) } else { 0.0 }
            }
            FootSolver::Nothing => 0.0,
        }
    }
}

/// The mean push that makes `change` of the motion of a body in `dt` seconds; `coupled` is the mass matrix
/// of the relative motion where the ground moves as well, as in [`Standing::new`].
pub(crate) fn push(
    body: &PlanarBody<f32>,
    coupled: Option<&[f64; 6]>,
    change: &Twist<f32>,
    dt: f32,
) -> Wrench<f32> {
    if let Some(mass) = coupled {
        let change = [change.velocity.x, change.velocity.y, change.spin].map(f64::from);
        let [x, y, torque] = times(mass, &change).map(|x| (x / f64::from(dt)) as f32);
        return Wrench::new(x, y, torque);
    }
    Wrench {
        force: change.velocity * (body.mass() / dt),
        torque: change.spin * (body.inertia() / dt),
    }
}

impl<'a> FootSolver<'a> {
    /// A foot alone, if the kernel has its exact limit surface.
    fn alone(foot: &Foot<'a>, kept: Option<&SurfaceAside>) -> Option<Self> {
        let (limit, axis) = (foot.limit, foot.axis);
        if limit == 0.0 {
            return Some(Self::Nothing);
        }
        Some(Self::Exact {
            surface: foot.footprint.surface_about(foot.place, axis, kept)?,
            limit,
            axis,
        })
    }
}
