//! A periodic cell whose lengths follow speeds or stresses: what rigid and soft spheres share, and the cell of rigid ones.
//!
//! Rigid spheres resist at once, so that the speed of an axis under a stress is an unknown of the contact problem beside
//! the impulses. Images across a border move with it, and what pushes them pushes the axis:
//!
//! ```text
//! M (L'⁺ − L'⁻) = Σ f dt + (Σ m (v − v_flow)²/L − P V/L) dt
//! ```
//!
//! with the forces f along the axis of the contacts across its border, M the mass of a piston, V the volume. In balance
//! it is the law of [soft spheres](crate::soft): the force across a border is that across any plane. A speed that changes does not
//! move the spheres by itself, their contacts do.

use super::energy::kinetic_energy;
use super::error::WorldError;
use super::residual::Coefficients;
use super::setup::keeps_motion;
use super::spheres::Spheres;
use super::world::World;
use nalgebra::Vector3;
use tribos_base::space::{PeriodicBox, SpaceError};
use tribos_core::contact::{ContactFriction, SphereBody};

/// What the length of a periodic axis follows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum AxisControl {
    /// Nothing: it stays.
    #[default]
    Fixed,
    /// A speed L'; negative compresses.
    Speed(f64),
    /// A stress, positive in compression.
    Stress(f64),
}

/// How a periodic cell is deformed.
///
/// ```
/// use tribos::cd::{AxisControl, CellControl, WorldMaterials, solid};
/// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
/// use tribos::kernel::nalgebra::Vector3;
/// use tribos::soft::{SoftSetup, SoftWorld, Stiffness};
/// use tribos::space::PeriodicBox;
/// let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, IndependentFriction::none());
/// // 27 spheres of radius 1 in rows, pressed to touch their neighbours by 1 kPa along each axis.
/// let mut setup = SoftSetup::new(laws, Stiffness::Linear(1e5));
/// setup.space = PeriodicBox::new([Some(6.15); 3])?;
/// for site in 0..27 {
///     let place = [1, 3, 9].map(|stride| 1.0 + 2.05 * f64::from(site / stride % 3));
///     setup = setup.sphere(Vector3::from(place), 1.0, solid(1.0, 1.0));
/// }
/// setup.cell = Some(CellControl { axes: [AxisControl::Stress(1e3); 3], shear_rate: 0.0, mass: 30.0 });
/// let mut world = SoftWorld::new(setup)?;
/// while world.state().time < 1.0 {
///     world.step()?;
/// }
/// // Each of the nine contacts across a face carries a ninth of P L².
/// let [length, ..] = world.state().space.lengths().map(|length| length.unwrap_or(0.0));
/// let overlap = 2.0 - length / 3.0;
/// assert!((1e5 * overlap - 1e3 * length * length / 9.0).abs() < 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CellControl {
    /// Controls of the axes x, y, z; of those that repeat.
    pub axes: [AxisControl; 3],
    /// Speed along x over height along z.
    pub shear_rate: f64,
    /// Mass M of every axis under a stress.
    pub mass: f64,
}

impl CellControl {
    /// Refuses controls of axes that do not repeat, or without numbers.
    pub(crate) fn check(&self, space: &PeriodicBox) -> Result<(), WorldError> {
        for (axis, (control, length)) in self.axes.iter().zip(space.lengths()).enumerate() {
            let given = match control {
                AxisControl::Fixed => continue,
                AxisControl::Speed(given) | AxisControl::Stress(given) => *given,
            };
            if !given.is_finite() || length.is_none() {
                return Err(WorldError::Cell { axis, given });
            }
        }
        let [along, _, height] = space.lengths();
        let rate = self.shear_rate;
        if !rate.is_finite() || (rate != 0.0 && (along.is_none() || height.is_none())) {
            return Err(WorldError::Shear { rate });
        }
        let follows = |control: &AxisControl| matches!(control, AxisControl::Stress(_));
        if self.axes.iter().any(follows) && !(self.mass > 0.0 && self.mass.is_finite()) {
            return Err(WorldError::CellMass { given: self.mass });
        }
        Ok(())
    }

    /// Speeds of the axes that have one given.
    pub(crate) fn given_speeds(&self) -> [f64; 3] {
        self.axes.map(|axis| match axis {
            AxisControl::Speed(given) => given,
            AxisControl::Fixed | AxisControl::Stress(_) => 0.0,
        })
    }

    /// Whether an axis may change its length.
    pub(crate) fn deforms(&self) -> bool {
        self.axes != [AxisControl::Fixed; 3]
    }
}

/// Velocity of the flow at a place of a cell: uniform strain, and shear about the middle of its height.
pub(crate) fn flow(
    space: &PeriodicBox,
    speeds: &[f64; 3],
    shear_rate: f64,
    x: &Vector3<f64>,
) -> Vector3<f64> {
    let mut flow = Vector3::zeros();
    for (axis, length) in space.lengths().into_iter().enumerate() {
        if let Some(length) = length {
            flow[axis] = x[axis] / length * speeds[axis];
        }
    }
    let middle = 0.5 * space.lengths()[2].unwrap_or(0.0);
    flow.x += shear_rate * (x.z - middle);
    flow
}

/// The box after a time, with its images as far along x as the shear has moved them.
pub(crate) fn stretched(
    space: &PeriodicBox,
    speeds: &[f64; 3],
    along: f64,
    dt: f64,
) -> Result<PeriodicBox, SpaceError> {
    let mut lengths = space.lengths();
    for (length, speed) in lengths.iter_mut().zip(speeds) {
        *length = length.map(|length| length + speed * dt);
    }
    let offset = space.offset() + along;
    let offset = lengths[0].map_or(0.0, |length| offset.rem_euclid(length));
    Ok(PeriodicBox::new(lengths)?.sheared(offset))
}

/// Lets spheres that left the cell go on as their images inside; the change of their energy.
pub(crate) fn carry_on(
    (space, speeds, faster): (&PeriodicBox, &[f64; 3], f64),
    (spheres, positions): (&mut [SphereBody<f64>], &mut [Vector3<f64>]),
    listed_at: &mut [Vector3<f64>],
) -> f64 {
    let jumps = space.lengths().map(|length| length.unwrap_or(0.0));
    let mut work = 0.0;
    for (body, (sphere, x)) in spheres.iter_mut().zip(positions).enumerate() {
        let apart = *x - space.wrap(x);
        if apart == Vector3::zeros() {
            continue;
        }
        let periods = periods(&apart, space);
        if periods == [0.0; 3] {
            continue;
        }
        let jump = Vector3::new(
            periods[0] * jumps[0] + periods[2] * space.offset(),
            periods[1] * jumps[1],
            periods[2] * jumps[2],
        );
        *x -= jump;
        if let Some(listed) = listed_at.get_mut(body) {
            *listed -= jump;
        }
        let old = sphere.velocity;
        sphere.velocity -= image_velocity(&periods, speeds, faster);
        let energy = |velocity| kinetic_energy(sphere, velocity, &sphere.spin);
        work += energy(&sphere.velocity) - energy(&old);
    }
    work
}

/// Whole periods between a place and its image, from their distance.
pub(super) fn periods(apart: &Vector3<f64>, space: &PeriodicBox) -> [f64; 3] {
    let [x, y, z] = space.lengths();
    let count = |distance: f64, length: Option<f64>| {
        length.map_or(0.0, |length| (distance / length).round())
    };
    let levels = count(apart.z, z);
    [
        count(apart.x - levels * space.offset(), x),
        count(apart.y, y),
        levels,
    ]
}

/// Velocity of the image that many periods away, against the sphere itself.
pub(super) fn image_velocity(periods: &[f64; 3], speeds: &[f64; 3], faster: f64) -> Vector3<f64> {
    let [x, y, z] = periods;
    Vector3::new(x * speeds[0] + z * faster, y * speeds[1], z * speeds[2])
}

/// Vector from a sphere to the nearest image of another, and the velocity of that image against the other itself.
pub(crate) fn image(
    space: &PeriodicBox,
    speeds: &[f64; 3],
    shear_rate: f64,
    [a, b]: [&Vector3<f64>; 2],
) -> (Vector3<f64>, Vector3<f64>) {
    let near = space.displacement(a, b);
    let periods = periods(&(b - a - near), space);
    let faster = shear_rate * space.lengths()[2].unwrap_or(0.0);
    (near, -image_velocity(&periods, speeds, faster))
}

/// Moves all spheres alike, along the axes that may change their lengths, so that their centre of mass has the velocity of the
/// uniform strain there, as if the low ends of the axes rested; the change of their energy. No contact feels it, and else spheres
/// that an end overtakes would carry it away.
fn stay(
    cell: &CellState,
    control: Option<CellControl>,
    (spheres, positions): (&mut [SphereBody<f64>], &[Vector3<f64>]),
) -> f64 {
    let lengths = cell.space.lengths();
    let (mut whole, mut wanted) = (0.0, Vector3::zeros());
    let mut momentum = Vector3::zeros();
    for (sphere, x) in spheres.iter().zip(positions) {
        let mass = 1.0 / sphere.inv_mass;
        whole += mass;
        momentum += sphere.velocity * mass;
        wanted += x * mass;
    }
    let mut work = 0.0;
    for axis in 0..3 {
        let is_free = control.is_some_and(|control| control.axes[axis] != AxisControl::Fixed);
        if let (true, Some(length)) = (is_free && whole > 0.0, lengths[axis]) {
            let flow = wanted[axis] / length * cell.speeds[axis];
            let shift = (flow - momentum[axis]) / whole;
            work += shift * (momentum[axis] + 0.5 * shift * whole);
            for sphere in spheres.iter_mut() {
                sphere.velocity[axis] += shift;
            }
        }
    }
    work
}

/// A cell in motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellState {
    /// The box now, with its images as far along x as a shear has moved them.
    pub space: PeriodicBox,
    /// Speeds at which its lengths change.
    pub speeds: [f64; 3],
}

/// The axes of a cell in a contact problem: the images of spheres across its borders move with them.
#[derive(Clone, Debug, Default)]
pub struct CellBody {
    /// Speeds of the lengths in the absence of contacts.
    pub free: [f64; 3],
    /// Inverse masses; 0 of an axis that keeps its speed.
    pub inv_mass: [f64; 3],
    /// Speed along x of the images one period higher.
    pub faster: f64,
    /// Whole periods from each image to its sphere, in the order of the images.
    pub periods: Vec<[f64; 3]>,
    /// Speeds that follow from the current impulses.
    pub speeds: [f64; 3],
}

impl CellBody {
    /// Velocity of an image relative to its sphere.
    pub(super) fn image(&self, periods: &[f64; 3]) -> Vector3<f64> {
        -image_velocity(periods, &self.speeds, self.faster)
    }

    /// The axes with the speeds alone that no contact changes.
    pub(super) fn driven(&self) -> Self {
        let driven = |axis: usize| match self.inv_mass[axis] {
            0.0 => self.free[axis],
            _ => 0.0,
        };
        Self {
            speeds: [0, 1, 2].map(driven),
            faster: self.faster,
            ..Self::default()
        }
    }

    /// The largest motion of an image.
    pub(super) fn fastest(&self) -> f64 {
        self.speeds.iter().map(|speed| speed.abs()).sum()
    }

    /// An impulse on an image.
    pub(super) fn push(&mut self, periods: &[f64; 3], impulse: &Vector3<f64>) {
        for (axis, speed) in self.speeds.iter_mut().enumerate() {
            *speed -= periods[axis] * impulse[axis] * self.inv_mass[axis];
        }
    }
}

impl<F: ContactFriction<f64>> Spheres<F> {
    /// Brings the speeds of the cell and the velocities of the images to what follows from the impulses.
    pub(super) fn follow_cell(&mut self) {
        let Some(mut cell) = self.cell.take() else {
            return;
        };
        cell.speeds = self.cell_speeds(&cell);
        self.cell = Some(cell);
        self.move_images();
    }

    /// Gives the images of a cell that deforms the velocities that follow from its speeds.
    pub(super) fn move_images(&mut self) {
        if let Some(cell) = &self.cell {
            for ((_, velocity), periods) in self.images.iter_mut().zip(&cell.periods) {
                *velocity = cell.image(periods);
            }
        }
    }

    /// Speeds of the cell that follow from the impulses.
    pub(super) fn cell_speeds(&self, cell: &CellBody) -> [f64; 3] {
        let mut pushed = CellBody {
            speeds: cell.free,
            inv_mass: cell.inv_mass,
            ..CellBody::default()
        };
        for ((pair, _), periods) in self.images.iter().zip(&cell.periods) {
            if let Some(link) = self.pairs.get(*pair as usize) {
                let contact = &link.contact;
                pushed.push(periods, &contact.impulse().linear(contact.normal()));
            }
        }
        pushed.speeds
    }
}

impl<F: ContactFriction<f64> + Coefficients> World<F> {
    /// Sets what the axes of the cell follow from the next step on. *Domain*: controls of periodic axes, finite; otherwise
    /// the next step fails.
    pub fn set_axes(&mut self, axes: [AxisControl; 3]) {
        if let Some(cell) = &mut self.setup.cell {
            cell.axes = axes;
        }
    }

    /// The axes at the start of a step, with what loads and motion make of their speeds without contacts; none of a cell
    /// that keeps its lengths.
    pub(super) fn cell_body(&self, dt: f64) -> Result<Option<CellBody>, WorldError> {
        let (Some(cell), Some(CellState { space, speeds })) = (&self.setup.cell, &self.state.cell)
        else {
            return Ok(None);
        };
        cell.check(space)?;
        let mut body = CellBody {
            faster: cell.shear_rate * space.lengths()[2].unwrap_or(0.0),
            speeds: *speeds,
            ..CellBody::default()
        };
        let mut moving = Vector3::zeros();
        for (sphere, x) in self.state.spheres.iter().zip(&self.state.positions) {
            if !keeps_motion(sphere) {
                let own = sphere.velocity - flow(space, speeds, cell.shear_rate, x);
                moving += own.component_mul(&own) / sphere.inv_mass;
            }
        }
        let lengths = space.lengths().map(|length| length.unwrap_or(1.0));
        let volume = lengths.iter().product::<f64>();
        for (axis, control) in cell.axes.iter().enumerate() {
            (body.free[axis], body.inv_mass[axis]) = match control {
                AxisControl::Fixed => (0.0, 0.0),
                AxisControl::Speed(speed) => (*speed, 0.0),
                AxisControl::Stress(stress) => {
                    let push = (moving[axis] - stress * volume) / lengths[axis];
                    (speeds[axis] + push * dt / cell.mass, 1.0 / cell.mass)
                }
            };
        }
        Ok(Some(body))
    }

    /// The largest speed at which the cell moves images, and its largest acceleration under its loads.
    pub(super) fn cell_motion(&self) -> [f64; 2] {
        let (Some(cell), Some(state)) = (&self.setup.cell, &self.state.cell) else {
            return [0.0; 2];
        };
        let lengths = state.space.lengths().map(|length| length.unwrap_or(1.0));
        let volume = lengths.iter().product::<f64>();
        let mut motion = [0.0; 2];
        for ((control, length), speed) in cell.axes.iter().zip(lengths).zip(state.speeds) {
            let (speed, pull) = match control {
                AxisControl::Fixed => (0.0, 0.0),
                AxisControl::Speed(speed) => (*speed, 0.0),
                AxisControl::Stress(stress) => (speed, stress * volume / length / cell.mass),
            };
            motion[0] += speed.abs();
            motion[1] += pull.abs();
        }
        motion
    }

    /// Takes over the speeds of the contact problem, moves the images, and lets spheres that left the cell go on as their images.
    pub(super) fn drift_cell(&mut self, dt: f64) -> Result<(), WorldError> {
        let (Some(state), Some(body)) = (&mut self.state.cell, &self.problem.cell) else {
            return Ok(());
        };
        state.speeds = body.speeds;
        let images = body.faster.abs() + body.speeds.iter().map(|speed| speed.abs()).sum::<f64>();
        self.drift += images * dt;
        let step = self.state.steps;
        state.space = stretched(&state.space, &body.speeds, body.faster * dt, dt)
            .map_err(|cause| WorldError::Neighbours { step, cause })?;
        let cell = *state;
        let state = &mut self.state;
        state.shear_offset = cell.space.offset();
        let bodies = (&mut state.spheres[..], &mut state.positions[..]);
        let images = (&cell.space, &cell.speeds, body.faster);
        let work = carry_on(images, bodies, &mut self.listed_at);
        state.energy.cross(0.0, work);
        let work = stay(
            &cell,
            self.setup.cell,
            (&mut state.spheres, &state.positions),
        );
        state.energy.cross(0.0, work);
        Ok(())
    }
}
