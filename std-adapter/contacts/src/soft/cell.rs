//! A periodic cell that deforms: its lengths follow speeds or stresses, and it is sheared along x over z.
//!
//! A uniform strain moves a place x with the speed x L'/L of its share of the length L. A change of L' changes the
//! velocity of every sphere by its share, as in the cell of Parrinello and Rahman (J. Appl. Phys. 52 (1981) 7182). An
//! axis under a stress P, positive in compression, follows
//!
//! ```text
//! M L'' = (σ − P) V/L,     σ V = Σ f l + Σ m (v − v_flow)²
//! ```
//!
//! with the force f and the distance l of each contact along the axis, and the mass M of a piston (the cell of
//! Agnolin and Roux, Phys. Rev. E 76 (2007) 061302, on each axis). Velocities are those in the room: a sphere
//! that leaves the cell goes on as its image inside, with the velocity of the image.

use super::world::SoftWorld;
use crate::cd::{WorldError, keeps_motion, kinetic_energy};
use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;
use tribos_core::contact::ContactFriction;

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
/// use tribos::cd::{WorldMaterials, solid};
/// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
/// use tribos::kernel::nalgebra::Vector3;
/// use tribos::soft::{AxisControl, CellControl, SoftSetup, SoftWorld, Stiffness};
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

/// Loads of the contacts on a cell.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct CellLoads {
    /// Σ f l along each axis.
    pub virial: Vector3<f64>,
    /// Σ f · (velocity of the second body's image against itself).
    pub crossing: f64,
}

impl CellControl {
    /// Refuses controls of axes that do not repeat, or without numbers.
    pub(super) fn check(&self, space: &PeriodicBox) -> Result<(), WorldError> {
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

    /// Whether an axis may change its length.
    fn deforms(&self) -> bool {
        self.axes != [AxisControl::Fixed; 3]
    }
}

/// Velocity of the flow at a place of a cell: uniform strain, and shear about the middle of its height.
pub(super) fn flow(
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

impl<F: ContactFriction<f64>> SoftWorld<F> {
    /// Sets what the axes of the cell follow from the next step on. *Domain*: controls of periodic axes, finite; otherwise
    /// the next step fails.
    pub fn set_axes(&mut self, axes: [AxisControl; 3]) {
        if let Some(cell) = &mut self.setup.cell {
            cell.axes = axes;
        }
    }

    /// Brings the speeds of the axes to what they follow.
    pub(super) fn impose_speeds(&mut self) -> Result<(), WorldError> {
        let Some(cell) = self.setup.cell else {
            return Ok(());
        };
        cell.check(&self.state.space)?;
        for (axis, control) in cell.axes.into_iter().enumerate() {
            match control {
                AxisControl::Fixed => self.change_speed(axis, 0.0),
                AxisControl::Speed(speed) => self.change_speed(axis, speed),
                AxisControl::Stress(_) => {}
            }
        }
        Ok(())
    }

    /// A new speed of an axis, which every sphere shares.
    fn change_speed(&mut self, axis: usize, speed: f64) {
        let state = &mut self.state;
        let (Some(length), change) = (state.space.lengths()[axis], speed - state.speeds[axis])
        else {
            return;
        };
        if change == 0.0 {
            return;
        }
        state.speeds[axis] = speed;
        let spheres = state.spheres.iter_mut().zip(&state.positions);
        for (sphere, x) in spheres.filter(|(sphere, _)| !keeps_motion(sphere)) {
            let share = x[axis] / length * change;
            let old = sphere.velocity[axis];
            sphere.velocity[axis] = old + share;
            state.energy.work += share * (old + 0.5 * share) / sphere.inv_mass;
        }
    }

    /// What the loads of half a step do to the axes under a stress: forces times `time`, motion and stress times `half`.
    pub(super) fn kick_cell(&mut self, time: f64, half: f64) {
        let Some(cell) = self.setup.cell else {
            return;
        };
        self.state.energy.work -= self.cell_loads.crossing * time;
        if !cell.deforms() {
            return;
        }
        let state = &self.state;
        let mut moving = Vector3::zeros();
        let spheres = state.spheres.iter().zip(&state.positions);
        for (sphere, x) in spheres.filter(|(sphere, _)| !keeps_motion(sphere)) {
            let own = sphere.velocity - flow(&state.space, &state.speeds, cell.shear_rate, x);
            moving += own.component_mul(&own) / sphere.inv_mass;
        }
        let lengths = state.space.lengths().map(|length| length.unwrap_or(1.0));
        let volume = lengths.iter().product::<f64>();
        for (axis, control) in cell.axes.into_iter().enumerate() {
            if let AxisControl::Stress(stress) = control {
                let inside = self.cell_loads.virial[axis] * time + moving[axis] * half;
                let push = (inside - stress * volume * half) / lengths[axis];
                self.change_speed(axis, self.state.speeds[axis] + push / cell.mass);
            }
        }
    }

    /// Moves the images, and lets spheres that left the cell go on as their images.
    pub(super) fn drift_cell(&mut self, dt: f64) -> Result<(), WorldError> {
        let Some(cell) = self.setup.cell else {
            return Ok(());
        };
        let state = &mut self.state;
        let mut lengths = state.space.lengths();
        let faster = cell.shear_rate * lengths[2].unwrap_or(0.0);
        let mut images = faster.abs();
        for (length, speed) in lengths.iter_mut().zip(state.speeds) {
            *length = length.map(|length| length + speed * dt);
            images += speed.abs();
        }
        self.image_drift += images * dt;
        let step = state.steps;
        let space =
            PeriodicBox::new(lengths).map_err(|cause| WorldError::Neighbours { step, cause })?;
        let offset = state.space.offset() + faster * dt;
        let offset = lengths[0].map_or(0.0, |length| offset.rem_euclid(length));
        state.space = space.sheared(offset);

        let jumps = [lengths[0], lengths[1], lengths[2]].map(|length| length.unwrap_or(0.0));
        for (body, sphere) in state.spheres.iter_mut().enumerate() {
            let x = &mut state.positions[body];
            let inside = state.space.wrap(x);
            let apart = *x - inside;
            if apart == Vector3::zeros() {
                continue;
            }
            let periods = periods(&apart, &state.space);
            if periods == [0.0; 3] {
                continue;
            }
            let jump = Vector3::new(
                periods[0] * jumps[0] + periods[2] * state.space.offset(),
                periods[1] * jumps[1],
                periods[2] * jumps[2],
            );
            *x -= jump;
            if let Some(listed) = self.listed_at.get_mut(body) {
                *listed -= jump;
            }
            let old = sphere.velocity;
            sphere.velocity -= image_velocity(&periods, &state.speeds, faster);
            let energy = |velocity| kinetic_energy(sphere, velocity, &sphere.spin);
            state.energy.work += energy(&sphere.velocity) - energy(&old);
        }
        Ok(())
    }

    /// Loads of the pairs on the cell.
    pub(super) fn load_cell(
        &self,
        loads: &mut CellLoads,
        bodies: [usize; 2],
        force: &Vector3<f64>,
        branch: &Vector3<f64>,
    ) {
        if let Some(cell) = &self.setup.cell {
            let [a, b] = bodies.map(|body| &self.state.positions[body]);
            let (_, border) = image(
                &self.state.space,
                &self.state.speeds,
                cell.shear_rate,
                [a, b],
            );
            loads.virial += force.component_mul(branch);
            loads.crossing += force.dot(&border);
        }
    }

    /// Adds the flow of the cell to the velocities of the spheres.
    pub(super) fn add_flow(&mut self) {
        let Some(cell) = self.setup.cell else {
            return;
        };
        let state = &mut self.state;
        for (control, speed) in cell.axes.iter().zip(&mut state.speeds) {
            if let AxisControl::Speed(given) = control {
                *speed = *given;
            }
        }
        for (sphere, x) in state.spheres.iter_mut().zip(&state.positions) {
            sphere.velocity += flow(&state.space, &state.speeds, cell.shear_rate, x);
        }
    }
}

/// Whole periods between a place and its image, from their distance.
fn periods(apart: &Vector3<f64>, space: &PeriodicBox) -> [f64; 3] {
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
fn image_velocity(periods: &[f64; 3], speeds: &[f64; 3], faster: f64) -> Vector3<f64> {
    let [x, y, z] = periods;
    Vector3::new(x * speeds[0] + z * faster, y * speeds[1], z * speeds[2])
}

/// Vector from a sphere to the nearest image of another, and the velocity of that image against the other itself.
pub(super) fn image(
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
