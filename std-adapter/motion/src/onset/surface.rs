//! The onset surface as a table, beside limit surfaces.

use super::Bond;
use super::nodes::{CentredNodes, spread};
use rayon::prelude::*;
use tribos_core::bond::{BondLaw, Bonds, FailureMode, SlipOnset};
use tribos_core::limit_surface::FrictionSet;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};
use tribos_friction::{Area, FrictionError, OwnedNodes, Patch};

/// The contact that bonds hold.
///
/// ```
/// use tribos::onset::OnsetContact;
/// let usual = OnsetContact::default();
/// assert_eq!((usual.coefficient, usual.load, usual.radius, usual.strain), (1.0, 1.0, 1.0, 1e-6));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnsetContact {
    /// Static friction coefficient: the largest force of a bond, per load.
    pub coefficient: f64,
    /// Load, in N.
    pub load: f64,
    /// Radius of a round patch, in m.
    pub radius: f64,
    /// Strain x0 of the bonds, in m; it scales displacements and no force.
    pub strain: f64,
    /// Direction of the sideways displacement, in degrees from the first axis.
    pub heading: f64,
    /// Centre of pressure of a box or a polygon, in m.
    pub centre: Option<[f64; 2]>,
}

impl Default for OnsetContact {
    fn default() -> Self {
        Self {
            coefficient: 1.0,
            load: 1.0,
            radius: 1.0,
            strain: 1e-6,
            heading: 0.0,
            centre: None,
        }
    }
}

/// The onset along one ray of displacements.
///
/// ```
/// use tribos::friction::Patch;
/// use tribos::onset::{Bond, OnsetContact, OnsetPoint, OnsetSurface};
/// let surface = OnsetSurface::new(&Patch::Ring, Bond::OneStrength, &OnsetContact::default(), 3)?;
/// let [pushed, _, turned]: &[OnsetPoint] = surface.points() else { panic!("three") };
/// assert!((pushed.onset.push.force.x - 1.0).abs() < 1e-12); // N
/// assert!((turned.onset.push.torque - 1.0).abs() < 1e-12); // N m: all bonds have the full arm
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnsetPoint {
    /// Angle in degrees of the displacement between pushed (0) and turned (90), with the reach of the patch as
    /// its arm.
    pub share: f64,
    /// Displacement and push, about the centre of pressure, in m, rad, N and N m.
    pub onset: SlipOnset<f64>,
    /// The push over the one that dry friction with the static coefficient carries along its ray: at most 1.
    pub of_limit: f64,
    /// The push over the one that steady sliding meets along its ray; `None` if the bonds do not
    /// re-form.
    pub static_over_dynamic: Option<f64>,
}

/// Limits of an onset surface.
///
/// ```
/// use tribos::friction::Patch;
/// use tribos::onset::{Bond, OnsetContact, OnsetSurface, OnsetSummary};
/// let surface = OnsetSurface::new(&Patch::Disk, Bond::Plastic, &OnsetContact::default(), 3)?;
/// let summary: OnsetSummary = surface.summary();
/// assert!((summary.arm_ratio() - 2.0 / 3.0).abs() < 1e-12);
/// assert_eq!(summary.static_over_dynamic, Some(1.0));
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnsetSummary {
    /// Force F_s at the onset of a pure push, in N.
    pub force: f64,
    /// Torque T_s at the onset of a pure rotation about the centre of pressure, in N m.
    pub torque: f64,
    /// Distance R of the farthest point from the centre of pressure, in m.
    pub reach: f64,
    /// Static over dynamic force of a pure push; `None` if the bonds do not re-form or hold.
    pub static_over_dynamic: Option<f64>,
}

impl OnsetSummary {
    /// T_s/(F_s R)
    pub fn arm_ratio(&self) -> f64 {
        self.torque / (self.force * self.reach)
    }
}

/// The pushes at which a contact lets go, from a pure push to a pure rotation.
///
/// *Accuracy*: for the uniform disk 1e-5 of the force limit; bonds that yield and bonds of one strength
/// are exact to rounding. Polygons 1e-4, smooth laws better.
///
/// ```
/// use tribos::friction::Patch;
/// use tribos::onset::{OnsetContact, OnsetSurface};
/// let bonds = "re-forming:n=64".parse()?;
/// let surface = OnsetSurface::new(&Patch::Disk, bonds, &OnsetContact::default(), 5)?;
/// let ratios: Vec<f64> = surface.points().iter().filter_map(|p| p.static_over_dynamic).collect();
/// assert!((ratios[0] - 1.5119).abs() < 1e-4); // pushed
/// assert!(ratios[4] < 1.4); // turned: bonds at different radii do not break together
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct OnsetSurface {
    points: Vec<OnsetPoint>,
    summary: OnsetSummary,
}

/// What every ray of a surface needs.
struct RaySetup<'a> {
    bonds: Bonds<f64, super::AnyBond, OwnedNodes>,
    contact: &'a OnsetContact,
    centre: [f64; 2],
    reach: f64,
    limit: &'a dyn FrictionSet<f64>,
    dynamic: Option<&'a dyn FrictionSet<f64>>,
}

impl OnsetSurface {
    /// Most points of a surface.
    pub const MOST_POINTS: usize = 10_000;

    /// The onset along `points` rays, at least 2.
    pub fn new(
        patch: &Patch,
        bond: Bond,
        contact: &OnsetContact,
        points: usize,
    ) -> Result<Self, FrictionError> {
        if !(2..=Self::MOST_POINTS).contains(&points) {
            let most = Self::MOST_POINTS;
            let reason = format!("the number of points must be from 2 to {most}, not {points}");
            return Err(FrictionError::Syntax(reason));
        }
        check(contact)?;
        let law = bond.with(contact.coefficient, contact.strain)?;
        let CentredNodes {
            nodes,
            centre,
            reach,
        } = spread(patch, contact.radius, contact.centre)?;
        let area = Area::named(patch, contact.radius, contact.centre)?;
        let limit = area.limit_surface(contact.coefficient * contact.load)?;
        let dynamic: Option<Box<dyn FrictionSet<f64>>> = match law.plateau() {
            0.0 => None,
            held => Some(area.limit_surface(held * contact.load)?),
        };
        let mut bonds = Bonds::new(law, nodes)?;
        if patch.has_axis() {
            bonds = bonds.with_rim(contact.radius)?;
        }
        let rays = RaySetup {
            bonds,
            contact,
            centre,
            reach,
            limit: &*limit,
            dynamic: dynamic.as_deref(),
        };
        let points = rays.points(points)?;
        let summary = rays.summary(&points);
        Ok(Self { points, summary })
    }

    /// The onsets, from a pure push to a pure rotation.
    pub fn points(&self) -> &[OnsetPoint] {
        &self.points
    }

    /// Its limits.
    pub fn summary(&self) -> OnsetSummary {
        self.summary
    }
}

/// Refuses what the kernel does not see or would call by another name.
fn check(contact: &OnsetContact) -> Result<(), FrictionError> {
    for (what, given) in [
        ("static coefficient", contact.coefficient),
        ("load", contact.load),
        ("radius", contact.radius),
        ("strain of the bonds", contact.strain),
    ] {
        if !(given > 0.0 && given.is_finite()) {
            let reason = format!("the {what} must be positive and finite, not {given}");
            return Err(FrictionError::Syntax(reason));
        }
    }
    if !contact.heading.is_finite() {
        let reason = format!(
            "the heading must be a finite number of degrees, not {}",
            contact.heading
        );
        return Err(FrictionError::Syntax(reason));
    }
    Ok(())
}

impl RaySetup<'_> {
    /// The onsets along rays at equal angles, found on all cores.
    fn points(&self, count: usize) -> Result<Vec<OnsetPoint>, FrictionError> {
        let share = |i: usize| 90.0 * i as f64 / (count - 1) as f64;
        let (bonds, load) = (&self.bonds, self.contact.load);
        let directions: Vec<Twist<f64>> = (0..count).map(|i| self.direction(share(i))).collect();
        let onsets: Vec<Option<SlipOnset<f64>>> = directions
            .par_iter()
            .map(|direction| bonds.onset(load, direction))
            .collect();
        let found = onsets.into_iter().zip(directions).enumerate();
        found
            .map(|(i, (onset, direction))| match onset {
                Some(onset) if onset.release == FailureMode::Holds => Err(FrictionError::Syntax(format!(
                    "where the bonds let go along the ray of {} degrees is not known: they hold as far as the \
                     search goes, some 4e8 strains",
                    share(i)
                ))),
                Some(onset) => Ok(self.compared_with_limit(share(i), onset, &direction)),
                None => Err(FrictionError::Syntax(format!(
                    "along the ray of {} degrees the onset is out of the range of numbers: take units in which \
                     lengths and loads are nearer to 1",
                    share(i)
                ))),
            })
            .collect()
    }

    /// The direction of displacement at an angle in degrees between pushed and turned.
    fn direction(&self, share: f64) -> Twist<f64> {
        let (slide, turn) = unit(share);
        let (x, y) = unit(self.contact.heading);
        Twist::new(slide * x, slide * y, turn / self.reach)
    }

    /// An onset beside the limit surfaces.
    fn compared_with_limit(
        &self,
        share: f64,
        mut onset: SlipOnset<f64>,
        direction: &Twist<f64>,
    ) -> OnsetPoint {
        if onset.release == FailureMode::Yields {
            // What yielding bonds hold is known exactly.
            onset.push = self.at_centre(&-self.limit.wrench(&self.at_origin_twist(direction)));
        }
        let push = self.at_origin(&onset.push);
        OnsetPoint {
            share,
            onset,
            of_limit: self.limit.gauge(&push),
            static_over_dynamic: self.dynamic.map(|set| set.gauge(&push)),
        }
    }

    fn summary(&self, points: &[OnsetPoint]) -> OnsetSummary {
        let push = |point: Option<&OnsetPoint>| point.map(|point| point.onset.push);
        let (first, last) = (push(points.first()), push(points.last()));
        OnsetSummary {
            force: first.map_or(f64::NAN, |push| Real::hypot(push.force.x, push.force.y)),
            torque: last.map_or(f64::NAN, |push| push.torque),
            reach: self.reach,
            static_over_dynamic: match self.bonds.law().plateau() {
                0.0 => None,
                held => Some(self.bonds.law().largest_force() / held),
            },
        }
    }

    /// A wrench about the centre of pressure, about the origin of the patch.
    fn at_origin(&self, wrench: &Wrench<f64>) -> Wrench<f64> {
        let [x, y] = self.centre;
        let (force, torque) = (wrench.force, wrench.torque);
        Wrench::new(force.x, force.y, torque + (x * force.y - y * force.x))
    }

    /// The other way round.
    fn at_centre(&self, wrench: &Wrench<f64>) -> Wrench<f64> {
        let [x, y] = self.centre;
        let (force, torque) = (wrench.force, wrench.torque);
        Wrench::new(force.x, force.y, torque - (x * force.y - y * force.x))
    }

    /// A motion of the centre of pressure as one of the origin of the patch.
    fn at_origin_twist(&self, twist: &Twist<f64>) -> Twist<f64> {
        let [x, y] = self.centre;
        let (velocity, spin) = (twist.velocity, twist.spin);
        Twist::new(velocity.x + spin * y, velocity.y - spin * x, spin)
    }
}

/// Cosine and sine of an angle in degrees, exact at right angles.
fn unit(degrees: f64) -> (f64, f64) {
    let turns = (degrees / 90.0).rem_euclid(4.0);
    match turns {
        0.0 => (1.0, 0.0),
        1.0 => (0.0, 1.0),
        2.0 => (-1.0, 0.0),
        3.0 => (0.0, -1.0),
        _ => {
            let angle = 0.5 * std::f64::consts::PI * turns;
            (Real::cos(angle), Real::sin(angle))
        }
    }
}
