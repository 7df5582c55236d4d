//! A foot: where its patch lies, what moves it, and what presses it.

use super::carry::{Joint, Joints};
use super::planar::{self, Limits};
use crate::model::Sets;
use crate::patch::Patch;
use nalgebra::{Matrix3, Matrix6, SVector, Vector3, Vector6};
use pyo3::prelude::*;

/// Share of its slip that friction takes back in a step from a body that it holds: what it knows a step late, of third
/// order in the step, carries the body no further than fifty times what one step of it does. A larger share would
/// move a body back visibly that a sudden push has moved in the step in which friction did not know of it.
const RETURN: f64 = 0.02;

/// What a foot is, from Python.
#[derive(FromPyObject)]
pub struct FootArguments<'py> {
    patch: Bound<'py, Patch>,
    mu: f64,
    geoms: Vec<i32>,
    floor: i32,
    freedoms: Vec<(usize, f64, usize)>,
    free: Vec<(usize, f64, f64, [f64; 3])>,
    bodies: [usize; 2],
    chains: [Vec<(usize, usize, usize, usize)>; 2],
}

/// A degree of freedom that moves a foot, or its floor.
pub struct DegreeOfFreedom {
    pub index: usize,
    /// 1 for the foot, −1 for the floor.
    sign: f64,
    /// Root of its tree.
    pub root: usize,
}

/// A body that moves freely.
pub struct Free {
    pub body: usize,
    sign: f64,
    mass: f64,
    inertia: [f64; 3],
}

/// A contact of a foot with its floor.
pub struct Contact {
    pub at: Vector3<f64>,
    /// From the floor to the foot.
    pub normal: Vector3<f64>,
    /// Distance less margin.
    pub gap: f64,
    /// Inverse of the solver's regularisation.
    pub stiffness: f64,
    /// Stiffness, damping and impedance of the solver's reference.
    pub spring: [f64; 3],
}

/// A normal force as the solver has it: stiffness · max(0, reference − row · acceleration).
struct Normal {
    /// Its part of lift and of tilt about x and y.
    row: Vector3<f64>,
    stiffness: f64,
    reference: f64,
}

/// A foot. Motions are those of its patch's centre in the patch's axes, relative to the floor: along x, along
/// y, spin about the normal; lift, tilt about x, tilt about y.
pub struct Foot {
    sets: Sets,
    mu: f64,
    /// Largest torque per force, in m.
    arm: f64,
    pub geoms: Vec<i32>,
    pub floor: i32,
    pub freedoms: Vec<DegreeOfFreedom>,
    pub free: Vec<Free>,
    /// The foot's and the floor's.
    pub bodies: [usize; 2],
    /// Their joints, the innermost first.
    chains: [Vec<Joint>; 2],
    /// The foot's body has all six motions by a joint of its own.
    is_afloat: bool,
    /// Sum of the normal forces of the last step, in N.
    pub load: f64,
    /// Axes of the patch in its columns: x, y, normal.
    pub axes: Matrix3<f64>,
    pub centre: Vector3<f64>,
    /// Motion by each degree of freedom.
    pub jacobian: Vec<Vector6<f64>>,
    normals: Vec<Normal>,
    /// Force on the foot, in the frame of the world.
    force: Vector3<f64>,
    /// Torque on it about its normal.
    torque: f64,
    pub twist: Vector3<f64>,
    /// Its mean motion over the step if no velocity changes.
    mean: Vector3<f64>,
    /// How far it has moved since friction holds it, in m, m and rad.
    slip: Vector3<f64>,
    pub is_held: bool,
    /// Steps so far in which a search for its friction stopped at its count.
    pub missed: u64,
}

impl FootArguments<'_> {
    pub fn foot(self) -> PyResult<Foot> {
        let sets = Sets::new(&self.patch.get().0)?;
        let freedoms = self.freedoms.into_iter();
        let free = self.free.into_iter();
        Ok(Foot {
            arm: planar::arm(&sets)?,
            sets,
            mu: self.mu,
            geoms: self.geoms,
            floor: self.floor,
            freedoms: freedoms
                .map(|(index, sign, root)| DegreeOfFreedom { index, sign, root })
                .collect(),
            free: free
                .map(|(body, sign, mass, inertia)| Free {
                    body,
                    sign,
                    mass,
                    inertia,
                })
                .collect(),
            bodies: self.bodies,
            is_afloat: matches!(self.chains[0][..], [(_, _, 3, 3)]),
            chains: self.chains.map(|chain| {
                chain
                    .into_iter()
                    .map(|(index, first, shifts, turns)| Joint {
                        index,
                        first,
                        shifts,
                        turns,
                    })
                    .collect()
            }),
            load: 0.0,
            axes: Matrix3::identity(),
            centre: Vector3::zeros(),
            jacobian: Vec::new(),
            normals: Vec::new(),
            force: Vector3::zeros(),
            torque: 0.0,
            twist: Vector3::zeros(),
            mean: Vector3::zeros(),
            slip: Vector3::zeros(),
            is_held: false,
            missed: 0,
        })
    }
}

impl Foot {
    /// What it can carry.
    pub fn limits(&self) -> Limits<'_> {
        Limits {
            sets: &self.sets,
            force: self.mu * self.load,
            arm: self.arm,
        }
    }

    /// Its motion for velocities or accelerations of all degrees of freedom.
    pub fn motion(&self, of: &[f64]) -> Vector6<f64> {
        let mut motion = Vector6::zeros();
        for (freedom, column) in self.freedoms.iter().zip(&self.jacobian) {
            motion += column * of[freedom.index];
        }
        motion
    }

    /// Friction on it in the patch's axes.
    pub fn friction(&self) -> Vector3<f64> {
        let force = self.axes.tr_mul(&self.force);
        Vector3::new(force.x, force.y, self.torque)
    }

    /// Takes friction in the patch's axes.
    pub fn take(&mut self, friction: &Vector3<f64>, is_held: bool) {
        self.force = self.axes.column(0) * friction.x + self.axes.column(1) * friction.y;
        self.torque = friction.z;
        self.is_held = is_held;
    }

    /// Forgets its contacts, and its friction.
    pub fn lift(&mut self) {
        self.load = 0.0;
        self.normals.clear();
        self.twist = Vector3::zeros();
        self.slip = Vector3::zeros();
        self.take(&Vector3::zeros(), false);
    }

    /// The load of the last step, given the acceleration that it ended with.
    pub fn update_load(&mut self, acceleration: &[f64]) {
        if self.normals.is_empty() {
            self.load = 0.0;
            return;
        }
        let motion = self.motion(acceleration);
        let up = motion.fixed_rows::<3>(3);
        let forces = self
            .normals
            .iter()
            .map(|normal| normal.stiffness * (normal.reference - normal.row.dot(&up)).max(0.0));
        self.load = forces.sum();
    }

    /// The patch's plane and centre from its contacts and its frame.
    pub fn place(&mut self, contacts: &[Contact], origin: &Vector3<f64>, frame: &Matrix3<f64>) {
        let mut sum = Vector3::zeros();
        let mut at = Vector3::zeros();
        for contact in contacts {
            sum += contact.normal;
            at += contact.at - origin;
        }
        let normal = sum.try_normalize(0.0).unwrap_or(contacts[0].normal);
        self.centre = origin + normal * (normal.dot(&at) / contacts.len() as f64);
        // The frame's axis next to the one along the normal is the patch's x.
        let along = frame.tr_mul(&normal);
        let next = (along.iamax() + 1) % 3;
        let x = (frame.column(next) - normal * along[next]).normalize();
        self.axes = Matrix3::from_columns(&[x, normal.cross(&x), normal]);
    }

    /// A motion in the patch's axes.
    fn in_axes(&self, shift: &Vector3<f64>, turn: &Vector3<f64>) -> Vector6<f64> {
        let (shift, turn) = (self.axes.tr_mul(shift), self.axes.tr_mul(turn));
        SVector::from([shift.x, shift.y, turn.z, shift.z, turn.x, turn.y])
    }

    /// Its motion by each degree of freedom, from MuJoCo's axes of these and centres of the trees.
    pub fn turn(&mut self, axes: &[[f64; 6]], centres: &[[f64; 3]]) {
        let mut jacobian = std::mem::take(&mut self.jacobian);
        jacobian.clear();
        jacobian.extend(self.freedoms.iter().map(|freedom| {
            let [a, b, c, u, v, w] = axes[freedom.index];
            let turn = Vector3::new(a, b, c);
            let lever = self.centre - Vector3::from(centres[freedom.root]);
            let shift = Vector3::new(u, v, w) + turn.cross(&lever);
            self.in_axes(&shift, &turn) * freedom.sign
        }));
        self.jacobian = jacobian;
    }

    /// Its normal forces, for the next step, and its twist.
    pub fn press(&mut self, contacts: &[Contact], velocity: &[f64]) {
        let motion = self.motion(velocity);
        let up = motion.fixed_rows::<3>(3);
        self.normals.clear();
        for contact in contacts {
            let moment = (contact.at - self.centre).cross(&contact.normal);
            let (x, y) = (self.axes.column(0), self.axes.column(1));
            let row = Vector3::new(1.0, moment.dot(&x), moment.dot(&y));
            let [k, b, impedance] = contact.spring;
            self.normals.push(Normal {
                row,
                stiffness: contact.stiffness,
                reference: -b * row.dot(&up) - k * impedance * contact.gap,
            });
        }
        self.twist = motion.fixed_rows::<3>(0).into_owned();
    }

    /// By how much the way of its body on its floor, in a time in which no velocity changes, is not straight:
    /// MuJoCo gives the joints whole turns, which carry what they hold in a circle and not along its tangent. It is
    /// that of the body's `origin`, which a free joint moves straight, such that feet of one body have one bend.
    fn bend(&self, joints: &Joints<'_>, dt: f64, origin: &Vector3<f64>) -> Vector3<f64> {
        let sides = self.chains.each_ref();
        let [own, under] = sides.map(|chain| joints.bend(chain, dt, origin));
        let way = self.axes.tr_mul(&(own - under));
        Vector3::new(way.x, way.y, 0.0)
    }

    /// Its mean motion over the step. What it has slipped, where friction holds it, grows by the way back over the
    /// step before, if there `was_step`.
    pub fn follow(&mut self, joints: &Joints<'_>, dt: f64, origin: &Vector3<f64>, was_step: bool) {
        if !self.is_held {
            self.slip = Vector3::zeros();
        } else if was_step {
            self.slip += self.twist * dt - self.bend(joints, -dt, origin);
        }
        self.mean = self.twist + self.bend(joints, dt, origin) / dt;
    }

    /// The motion of this foot by the velocity with which slip of the `first` foot of its body is taken back: slips
    /// of feet that differ would turn into forces between them.
    fn returned(&self, first: &Foot, dt: f64) -> Vector3<f64> {
        let slip = first.slip * (RETURN / dt);
        let turn = first.axes.column(2) * slip.z;
        let shift = first.axes.column(0) * slip.x
            + first.axes.column(1) * slip.y
            + turn.cross(&(self.centre - first.centre));
        self.in_axes(&shift, &turn).fixed_rows::<3>(0).into_owned()
    }

    /// The motion that friction has to end for rest, among the loaded `feet`. A body that stands on two floors, or
    /// lacks a motion, might not be able to take its slip back.
    pub fn unrest(&self, feet: &[&Foot], dt: f64) -> Vector3<f64> {
        let mut own = feet.iter().filter(|foot| foot.bodies[0] == self.bodies[0]);
        let is_on_one = own.clone().all(|foot| foot.bodies[1] == self.bodies[1]);
        match own.find(|foot| foot.is_held) {
            Some(first) if self.is_afloat && is_on_one => self.mean + self.returned(first, dt),
            _ => self.mean,
        }
    }

    /// Sum of stiffness · row rowᵀ of its normal forces.
    pub fn stiffness(&self) -> Matrix3<f64> {
        let mut sum = Matrix3::zeros();
        for normal in &self.normals {
            sum += normal.row * normal.row.transpose() * normal.stiffness;
        }
        sum
    }

    /// A root of the inverse mass of a free body, in the motions of the foot.
    pub fn mobility(&self, free: &Free, centre: &[f64; 3], axes: &[f64; 9]) -> Matrix6<f64> {
        let lever = self.centre - Vector3::from(*centre);
        let mut root = Matrix6::zeros();
        let shift = free.sign / free.mass.sqrt();
        for index in 0..3 {
            for (row, axis) in [(0, 0), (1, 1), (3, 2)] {
                root[(row, index)] = shift * self.axes[(index, axis)];
            }
            let axis = Vector3::new(axes[index], axes[3 + index], axes[6 + index]);
            let turn = self.in_axes(&axis.cross(&lever), &axis);
            root.set_column(
                3 + index,
                &(turn * (free.sign / free.inertia[index].sqrt())),
            );
        }
        root
    }
}
