//! Friction of feet in a MuJoCo simulation: all of a step but the calls of MuJoCo itself.
//!
//! The load of a foot is the sum of its normal forces of the last step. MuJoCo's arrays of these are
//! gone when its passive forces are asked for, but each is D·max(0, a_ref − a) with the normal
//! acceleration a that the solver found, which is kept.

mod planar;

use crate::arrays::refused;
use crate::model::{Sets, sets};
use crate::patch::Patch;
use nalgebra::{DMatrix, DVector, Matrix3, Matrix6, SVector, Vector3, Vector6};
use numpy::{
    PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods,
};
use planar::{Limits, Step, arm};
use pyo3::prelude::*;

/// Arrays of a simulation that stay where they are.
#[derive(FromPyObject)]
struct Arrays {
    velocity: Py<PyArray1<f64>>,
    acceleration: Py<PyArray1<f64>>,
    force: Py<PyArray1<f64>>,
    /// Axes of the degrees of freedom, angular and linear.
    axes: Py<PyArray2<f64>>,
    /// Centres of mass of the trees.
    centres: Py<PyArray2<f64>>,
    /// Orientations of the bodies' inertias.
    inertias: Py<PyArray2<f64>>,
}

/// A degree of freedom that moves a foot, or its floor.
struct Freedom {
    index: usize,
    /// 1 for the foot, −1 for the floor.
    sign: f64,
    /// Root of its tree.
    root: usize,
}

/// A body that moves freely.
struct Free {
    body: usize,
    sign: f64,
    mass: f64,
    inertia: [f64; 3],
}

/// A normal force as the solver has it.
struct Normal {
    /// Its row in the frame of the world: velocity at the patch's centre, and spin.
    row: Vector6<f64>,
    /// Its row in the patch's frame: lift, and tilt about x and y.
    tilt: Vector3<f64>,
    /// Inverse of the regularisation.
    stiffness: f64,
    reference: f64,
}

impl Normal {
    fn force(&self, acceleration: &Vector6<f64>) -> f64 {
        self.stiffness * (self.reference - self.row.dot(acceleration)).max(0.0)
    }
}

/// A contact in MuJoCo's list.
struct Contact {
    at: Vector3<f64>,
    /// From the floor to the foot.
    normal: Vector3<f64>,
    /// Distance less margin.
    gap: f64,
    row: usize,
}

struct Foot {
    sets: Box<dyn Sets>,
    mu: f64,
    arm: f64,
    geoms: Vec<i32>,
    floor: i32,
    /// Which of the frames' arrays, and which row of it.
    frame: [usize; 2],
    freedoms: Vec<Freedom>,
    free: Vec<Free>,
    // In this step.
    load: f64,
    /// Axes of the patch in its columns: x, y, normal.
    axes: Matrix3<f64>,
    centre: Vector3<f64>,
    /// Motion at the centre by each degree of freedom.
    jacobian: Vec<Vector6<f64>>,
    normals: Vec<Normal>,
    /// Force on the foot and torque about its normal.
    force: Vector3<f64>,
    torque: f64,
    twist: Vector3<f64>,
    is_held: bool,
}

impl Foot {
    /// Motion at the centre for velocities or accelerations of all degrees of freedom.
    fn motion(&self, of: &[f64]) -> Vector6<f64> {
        let rows = self.freedoms.iter().zip(&self.jacobian);
        rows.map(|(freedom, column)| column * of[freedom.index])
            .sum()
    }

    /// Forgets its contacts, and its friction.
    fn lift(&mut self) {
        self.load = 0.0;
        self.normals.clear();
        self.force = Vector3::zeros();
        self.torque = 0.0;
        self.twist = Vector3::zeros();
        self.is_held = false;
    }

    /// The patch's plane and centre from its contacts and its frame.
    fn place(&mut self, contacts: &[Contact], origin: Vector3<f64>, frame: &Matrix3<f64>) {
        let sum: Vector3<f64> = contacts.iter().map(|contact| contact.normal).sum();
        let normal = sum.try_normalize(0.0).unwrap_or(contacts[0].normal);
        let count = contacts.len() as f64;
        let height = contacts
            .iter()
            .map(|at| normal.dot(&(at.at - origin)))
            .sum::<f64>()
            / count;
        self.centre = origin + normal * height;
        // The frame's axis next to the one along the normal is the patch's x.
        let along = normal.transpose() * frame;
        let next = (along.iamax_full().1 + 1) % 3;
        let axis = frame.column(next) - normal * along[next];
        let x = axis.normalize();
        self.axes = Matrix3::from_columns(&[x, normal.cross(&x), normal]);
    }

    /// The motion of its centre by each degree of freedom.
    fn turn(&mut self, axes: &[[f64; 6]], centres: &[[f64; 3]]) {
        let centre = self.centre;
        self.jacobian.clear();
        self.jacobian.extend(self.freedoms.iter().map(|freedom| {
            let [a, b, c, u, v, w] = axes[freedom.index];
            let turn = Vector3::new(a, b, c);
            let shift = Vector3::new(u, v, w)
                + turn.cross(&(centre - Vector3::from(centres[freedom.root])));
            stacked(&shift, &turn) * freedom.sign
        }));
    }

    /// Its normal forces' rows.
    fn press(&mut self, contacts: &[Contact], velocity: &[f64], rows: &Rows<'_>) {
        let motion = self.motion(velocity);
        self.normals.clear();
        for contact in contacts {
            let moment = (contact.at - self.centre).cross(&contact.normal);
            let row = stacked(&contact.normal, &moment);
            let [k, b, impedance, _] = rows.springs[contact.row];
            self.normals.push(Normal {
                row,
                tilt: Vector3::new(
                    1.0,
                    moment.dot(&self.axes.column(0)),
                    moment.dot(&self.axes.column(1)),
                ),
                stiffness: rows.stiffness[contact.row],
                reference: -b * row.dot(&motion) - k * impedance * contact.gap,
            });
        }
        self.twist = in_plane(&self.axes, &motion);
    }

    /// Sum of D r rᵀ of its normal forces.
    fn stiffness(&self) -> Matrix3<f64> {
        let normals = self.normals.iter();
        normals
            .map(|normal| normal.tilt * normal.tilt.transpose() * normal.stiffness)
            .sum()
    }

    /// Rows of the patch's frame in that of the world: x, y, turn; lift, tilt about x and y.
    fn rows(&self) -> Matrix6<f64> {
        let [x, y, n] = [0, 1, 2].map(|index| self.axes.column(index).into_owned());
        let none = Vector3::zeros();
        Matrix6::from_columns(&[
            stacked(&x, &none),
            stacked(&y, &none),
            stacked(&none, &n),
            stacked(&n, &none),
            stacked(&none, &x),
            stacked(&none, &y),
        ])
    }

    /// A root of the inverse mass of a free body, at the centre.
    fn mobility(&self, free: &Free, centre: &[f64; 3], axes: &[f64; 9]) -> Matrix6<f64> {
        let lever = self.centre - Vector3::from(*centre);
        let mut root = Matrix6::zeros();
        for index in 0..3 {
            root[(index, index)] = free.sign / free.mass.sqrt();
            let axis = Vector3::new(axes[index], axes[3 + index], axes[6 + index]);
            let turn = stacked(&axis.cross(&lever), &axis);
            let scale = free.sign / free.inertia[index].sqrt();
            root.set_column(3 + index, &(turn * scale));
        }
        root
    }
}

/// Velocity and spin in one column.
fn stacked(linear: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6<f64> {
    let ([x, y, z], [a, b, c]) = ((*linear).into(), (*angular).into());
    SVector::from([x, y, z, a, b, c])
}

/// Motion along the patch's x and y and about its normal.
fn in_plane(axes: &Matrix3<f64>, motion: &Vector6<f64>) -> Vector3<f64> {
    let (velocity, spin) = (motion.fixed_rows::<3>(0), motion.fixed_rows::<3>(3));
    Vector3::new(
        axes.column(0).dot(&velocity),
        axes.column(1).dot(&velocity),
        axes.column(2).dot(&spin),
    )
}

/// MuJoCo's rows of constraints.
struct Rows<'a> {
    stiffness: &'a [f64],
    /// Stiffness, damping, impedance and its derivative.
    springs: &'a [[f64; 4]],
}

/// What a foot is, from Python.
#[derive(FromPyObject)]
struct Given<'py> {
    patch: Bound<'py, Patch>,
    mu: f64,
    geoms: Vec<i32>,
    floor: i32,
    frame: [usize; 2],
    freedoms: Vec<(usize, f64, usize)>,
    free: Vec<(usize, f64, f64, [f64; 3])>,
}

impl Given<'_> {
    fn foot(self) -> PyResult<Foot> {
        let sets = sets(&self.patch.get().0)?;
        let freedoms = self.freedoms.into_iter();
        let free = self.free.into_iter();
        Ok(Foot {
            arm: arm(sets.as_ref())?,
            sets,
            mu: self.mu,
            geoms: self.geoms,
            floor: self.floor,
            frame: self.frame,
            freedoms: freedoms
                .map(|(index, sign, root)| Freedom { index, sign, root })
                .collect(),
            free: free
                .map(|(body, sign, mass, inertia)| Free {
                    body,
                    sign,
                    mass,
                    inertia,
                })
                .collect(),
            load: 0.0,
            axes: Matrix3::identity(),
            centre: Vector3::zeros(),
            jacobian: Vec::new(),
            normals: Vec::new(),
            force: Vector3::zeros(),
            torque: 0.0,
            twist: Vector3::zeros(),
            is_held: false,
        })
    }
}

/// Places of the fields in a contact of MuJoCo's, in units of their size.
#[derive(FromPyObject)]
struct Layout {
    distance: usize,
    position: usize,
    frame: usize,
    margin: usize,
    geoms: usize,
    row: usize,
}

/// Feet of one simulation.
#[pyclass(module = "tribos._native")]
pub struct MujocoFeet {
    feet: Vec<Foot>,
    arrays: Arrays,
    /// Positions and orientations that the patches' frames are taken from.
    frames: Vec<(Py<PyArray2<f64>>, Py<PyArray2<f64>>)>,
    layout: Layout,
    /// The feet's Jacobians, and the inverse mass times them, where some body does not move freely.
    mass: Option<(Py<PyArray2<f64>>, Py<PyArray2<f64>>)>,
    time: f64,
    contacts: Vec<Contact>,
}

#[pymethods]
impl MujocoFeet {
    #[new]
    fn new(
        feet: Vec<Given<'_>>,
        arrays: Arrays,
        frames: Vec<(Py<PyArray2<f64>>, Py<PyArray2<f64>>)>,
        layout: Layout,
        mass: Option<(Py<PyArray2<f64>>, Py<PyArray2<f64>>)>,
    ) -> PyResult<Self> {
        Ok(Self {
            feet: feet.into_iter().map(Given::foot).collect::<PyResult<_>>()?,
            arrays,
            frames,
            layout,
            mass,
            time: f64::NEG_INFINITY,
            contacts: Vec::new(),
        })
    }

    /// All feet leave their floors.
    fn lift(&mut self) {
        self.feet.iter_mut().for_each(Foot::lift);
    }

    /// The loads of the last step and the contacts of this one. True if the mass must be solved before
    /// `push`.
    fn land(
        &mut self,
        py: Python<'_>,
        time: f64,
        contacts: (PyReadonlyArray2<'_, f64>, PyReadonlyArray2<'_, i32>),
        stiffness: PyReadonlyArray1<'_, f64>,
        springs: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<bool> {
        if time < self.time {
            self.lift();
        }
        self.time = time;
        let rows = Rows {
            stiffness: stiffness.as_slice().map_err(refused)?,
            springs: springs.as_slice().map_err(refused)?.as_chunks().0,
        };
        let fields = Fields {
            width: contacts.0.shape()[1],
            numbers: contacts.0.as_slice().map_err(refused)?,
            indices: contacts.1.as_slice().map_err(refused)?,
            layout: &self.layout,
        };
        let arrays = &self.arrays;
        let velocity = arrays.velocity.bind(py).readonly();
        let acceleration = arrays.acceleration.bind(py).readonly();
        let (axes, centres) = (
            arrays.axes.bind(py).readonly(),
            arrays.centres.bind(py).readonly(),
        );
        let (axes, centres) = (chunks(&axes)?, chunks(&centres)?);
        let (velocity, acceleration) = (
            velocity.as_slice().map_err(refused)?,
            acceleration.as_slice().map_err(refused)?,
        );
        let mut is_loaded = false;
        for foot in &mut self.feet {
            let last = foot.motion(acceleration);
            foot.load = foot.normals.iter().map(|normal| normal.force(&last)).sum();
            self.contacts.clear();
            fields.contacts(foot, rows.stiffness.len(), &mut self.contacts);
            if self.contacts.is_empty() {
                foot.lift();
                continue;
            }
            let [table, row] = foot.frame;
            let (places, turns) = &self.frames[table];
            let (places, turns) = (places.bind(py).readonly(), turns.bind(py).readonly());
            let origin: [f64; 3] = chunks(&places)?[row];
            let frame: [f64; 9] = chunks(&turns)?[row];
            foot.place(
                &self.contacts,
                origin.into(),
                &Matrix3::from_row_slice(&frame),
            );
            foot.turn(axes, centres);
            foot.press(&self.contacts, velocity, &rows);
            is_loaded |= foot.load > 0.0;
        }
        let Some((rows, _)) = self.mass.as_ref().filter(|_| is_loaded) else {
            return Ok(false);
        };
        let mut rows = rows.bind(py).readwrite();
        let count = velocity.len();
        let rows = rows.as_slice_mut().map_err(refused)?;
        rows.fill(0.0);
        for (foot, rows) in self.feet.iter().zip(rows.chunks_exact_mut(6 * count)) {
            for (freedom, column) in foot.freedoms.iter().zip(&foot.jacobian) {
                for (row, value) in rows.chunks_exact_mut(count).zip(column) {
                    row[freedom.index] = *value;
                }
            }
        }
        Ok(true)
    }

    /// Adds this step's friction to the passive forces.
    fn push(&mut self, py: Python<'_>, dt: f64) -> PyResult<()> {
        let loaded: Vec<usize> = (0..self.feet.len())
            .filter(|&foot| self.feet[foot].load > 0.0)
            .collect();
        for foot in &mut self.feet {
            if !(foot.load > 0.0) {
                foot.force = Vector3::zeros();
                foot.torque = 0.0;
                foot.is_held = false;
            }
        }
        if loaded.is_empty() {
            return Ok(());
        }
        let mobility = self.mobility(py, &loaded)?;
        let feet: Vec<&Foot> = loaded.iter().map(|&foot| &self.feet[foot]).collect();
        let compliance = compliance(&feet, &mobility);
        let acceleration = self.arrays.acceleration.bind(py).readonly();
        let acceleration = acceleration.as_slice().map_err(refused)?;
        let each = |of: &dyn Fn(&Foot) -> Vector3<f64>| {
            let mut all = DVector::zeros(3 * feet.len());
            for (index, foot) in feet.iter().enumerate() {
                all.fixed_rows_mut::<3>(3 * index).copy_from(&of(foot));
            }
            all
        };
        let last = each(&|foot| {
            let force = foot.axes.transpose() * foot.force;
            Vector3::new(force.x, force.y, foot.torque)
        });
        let velocity = each(&|foot| foot.twist);
        let whole = each(&|foot| in_plane(&foot.axes, &foot.motion(acceleration)));
        let limits: Vec<Limits<'_>> = feet
            .iter()
            .map(|foot| Limits {
                sets: foot.sets.as_ref(),
                force: foot.mu * foot.load,
                arm: foot.arm,
            })
            .collect();
        let step = Step {
            limits: &limits,
            acceleration: &(whole - &compliance * &last),
            compliance: &compliance,
            velocity: &velocity,
            dt,
        };
        let solution = step.solve(&last)?;
        drop((limits, feet));
        let mut force = self.arrays.force.bind(py).readwrite();
        let force = force.as_slice_mut().map_err(refused)?;
        for (index, &foot) in loaded.iter().enumerate() {
            let foot = &mut self.feet[foot];
            let friction = solution.friction.fixed_rows::<3>(3 * index);
            foot.is_held = solution.is_held[index];
            foot.force = foot.axes.column(0) * friction.x + foot.axes.column(1) * friction.y;
            foot.torque = friction.z;
            let wrench = stacked(&foot.force, &(foot.axes.column(2) * friction.z));
            for (freedom, column) in foot.freedoms.iter().zip(&foot.jacobian) {
                force[freedom.index] += column.dot(&wrench);
            }
        }
        Ok(())
    }

    /// Of a foot: load, friction on it, its twist before the step, axes in columns, centre, and whether
    /// it is held.
    #[expect(clippy::type_complexity, reason = "a tuple for Python")]
    fn state(
        &self,
        foot: usize,
    ) -> PyResult<(f64, [f64; 3], [f64; 3], [[f64; 3]; 3], [f64; 3], bool)> {
        let foot = self.feet.get(foot).ok_or_else(|| refused("no such foot"))?;
        let force = foot.axes.transpose() * foot.force;
        Ok((
            foot.load,
            [force.x, force.y, foot.torque],
            foot.twist.into(),
            foot.axes.into(),
            foot.centre.into(),
            foot.is_held,
        ))
    }
}

impl MujocoFeet {
    /// Acceleration of the feet, in their frames, that unit wrenches on them give: six rows a foot.
    fn mobility(&self, py: Python<'_>, loaded: &[usize]) -> PyResult<DMatrix<f64>> {
        let mut whole = DMatrix::zeros(6 * loaded.len(), 6 * loaded.len());
        let turns: Vec<Matrix6<f64>> = loaded.iter().map(|&foot| self.feet[foot].rows()).collect();
        if let Some((_, solved)) = &self.mass {
            let solved = solved.bind(py).readonly();
            let count = solved.shape()[1];
            let solved = solved.as_slice().map_err(refused)?;
            for (j, &second) in loaded.iter().enumerate() {
                let rows = &solved[6 * second * count..];
                for (i, &first) in loaded.iter().enumerate() {
                    let foot = &self.feet[first];
                    let mut block = Matrix6::zeros();
                    for (freedom, column) in foot.freedoms.iter().zip(&foot.jacobian) {
                        let row = Vector6::from_fn(|k, _| rows[k * count + freedom.index]);
                        block += column * row.transpose();
                    }
                    let block = turns[i].transpose() * block * turns[j];
                    whole.fixed_view_mut::<6, 6>(6 * i, 6 * j).copy_from(&block);
                }
            }
            return Ok(whole);
        }
        let arrays = &self.arrays;
        let (centres, axes) = (
            arrays.centres.bind(py).readonly(),
            arrays.inertias.bind(py).readonly(),
        );
        let (centres, axes) = (chunks(&centres)?, chunks(&axes)?);
        let roots: Vec<Vec<(usize, Matrix6<f64>)>> = loaded
            .iter()
            .zip(&turns)
            .map(|(&foot, turn)| {
                let foot = &self.feet[foot];
                let free = foot.free.iter();
                free.map(|free| {
                    let root = foot.mobility(free, &centres[free.body], &axes[free.body]);
                    (free.body, turn.transpose() * root)
                })
                .collect()
            })
            .collect();
        for (i, first) in roots.iter().enumerate() {
            for (j, second) in roots.iter().enumerate() {
                let mut block = Matrix6::zeros();
                for (body, left) in first {
                    for (_, right) in second.iter().filter(|(other, _)| other == body) {
                        block += left * right.transpose();
                    }
                }
                whole.fixed_view_mut::<6, 6>(6 * i, 6 * j).copy_from(&block);
            }
        }
        Ok(whole)
    }
}

/// Acceleration in the contact planes that unit friction gives while the normal forces respond: the
/// mobility less what the normals' springs take.
fn compliance(feet: &[&Foot], mobility: &DMatrix<f64>) -> DMatrix<f64> {
    let count = feet.len();
    let part = |rows: usize, columns: usize| {
        DMatrix::from_fn(3 * count, 3 * count, |i, j| {
            mobility[(
                6 * (i / 3) + 3 * rows + i % 3,
                6 * (j / 3) + 3 * columns + j % 3,
            )]
        })
    };
    let (plane, mixed, normal) = (part(0, 0), part(0, 1), part(1, 1));
    let mut stiffness = DMatrix::zeros(3 * count, 3 * count);
    for (index, foot) in feet.iter().enumerate() {
        let block = foot.stiffness();
        stiffness
            .fixed_view_mut::<3, 3>(3 * index, 3 * index)
            .copy_from(&block);
    }
    // (1 + N K)⁻¹ Mᵀ, in the mobility's blocks P, M, N and the stiffness K.
    let mut system = normal * &stiffness;
    for index in 0..3 * count {
        system[(index, index)] += 1.0;
    }
    match system.lu().solve(&mixed.transpose()) {
        Some(given) => plane - mixed * (stiffness * given),
        None => plane,
    }
}

/// MuJoCo's list of contacts.
struct Fields<'a> {
    /// Numbers a contact.
    width: usize,
    numbers: &'a [f64],
    indices: &'a [i32],
    layout: &'a Layout,
}

impl Fields<'_> {
    /// The contacts of a foot with its floor that have one of `count` rows in the solver.
    fn contacts(&self, foot: &Foot, count: usize, out: &mut Vec<Contact>) {
        let layout = self.layout;
        let indices = self.indices.chunks_exact(2 * self.width);
        for (numbers, indices) in self.numbers.chunks_exact(self.width).zip(indices) {
            let [first, second] = [indices[layout.geoms], indices[layout.geoms + 1]];
            // MuJoCo's normal is from the first geom to the second.
            let sign = if first == foot.floor && foot.geoms.contains(&second) {
                1.0
            } else if second == foot.floor && foot.geoms.contains(&first) {
                -1.0
            } else {
                continue;
            };
            let row = usize::try_from(indices[layout.row]).unwrap_or(usize::MAX);
            if row < count {
                out.push(Contact {
                    at: Vector3::from_row_slice(&numbers[layout.position..][..3]),
                    normal: Vector3::from_row_slice(&numbers[layout.frame..][..3]) * sign,
                    gap: numbers[layout.distance] - numbers[layout.margin],
                    row,
                });
            }
        }
    }
}

/// The rows of an array.
fn chunks<'a, const N: usize>(array: &'a PyReadonlyArray2<'_, f64>) -> PyResult<&'a [[f64; N]]> {
    if array.shape()[1] != N {
        return Err(refused(format!("arrays must have {N} columns")));
    }
    Ok(array.as_slice().map_err(refused)?.as_chunks().0)
}
