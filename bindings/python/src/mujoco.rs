//! Friction of feet in a MuJoCo simulation: all of a step but the calls of MuJoCo itself.
//!
//! The load of a foot is the sum of its normal forces of the last step. MuJoCo's arrays of these are
//! gone when its passive forces are asked for, but each is D·max(0, a_ref − a) with the normal
//! acceleration a that the solver found, which is kept.

mod carry;
mod foot;
mod planar;

use crate::arrays::refused;
use carry::Joints;
use foot::{Contact, Foot, FootArguments};
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use planar::{Limits, Rows, Solution, Step};
use pyo3::prelude::*;

/// Where MuJoCo's arrays begin in the memory of a simulation.
#[derive(FromPyObject)]
struct Places {
    velocity: usize,
    acceleration: usize,
    /// Passive forces.
    force: usize,
    /// Axes of the degrees of freedom, angular and linear.
    axes: usize,
    /// Centres of mass of the trees.
    centres: usize,
    /// Origins of the bodies.
    origins: usize,
    /// Anchors of the joints.
    anchors: usize,
    /// Orientations of the bodies' inertias.
    inertias: usize,
    /// Position and orientation of each foot's frame.
    frames: Vec<[usize; 2]>,
    /// Degrees of freedom.
    freedoms: usize,
    /// Bodies.
    bodies: usize,
    /// Joints.
    joints: usize,
}

/// Places of the fields in a contact of MuJoCo's: of numbers, the last two of integers of half the size.
#[derive(FromPyObject)]
struct Layout {
    width: usize,
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
    /// Feet that move each other.
    groups: Vec<Vec<usize>>,
    /// The simulation's memory.
    memory: Py<PyArray1<f64>>,
    places: Places,
    layout: Layout,
    /// The feet's Jacobians, and the inverse mass times them, where some body does not move freely.
    mass: Option<Mass>,
    time: f64,
    contacts: Vec<Contact>,
}

type Mass = (Py<PyArray2<f64>>, Py<PyArray2<f64>>);
type Triple = [f64; 3];
type FootState = (f64, Triple, Triple, [Triple; 3], Triple, bool, u64);

#[pymethods]
impl MujocoFeet {
    #[new]
    fn new(
        feet: Vec<FootArguments<'_>>,
        memory: Py<PyArray1<f64>>,
        places: Places,
        layout: Layout,
        mass: Option<Mass>,
    ) -> PyResult<Self> {
        let feet: Vec<Foot> = feet
            .into_iter()
            .map(FootArguments::foot)
            .collect::<PyResult<_>>()?;
        Ok(Self {
            groups: groups(&feet),
            feet,
            memory,
            places,
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

    /// Adds this step's friction to the passive forces, from the contacts, the stiffness and the springs of
    /// their rows. True if it did not, but wants the mass to be solved and `push` to be called.
    fn step(
        &mut self,
        py: Python<'_>,
        time: f64,
        dt: f64,
        contacts: PyReadonlyArray1<'_, i64>,
        stiffness: &Bound<'_, PyArray1<f64>>,
        springs: &Bound<'_, PyArray2<f64>>,
    ) -> PyResult<bool> {
        if time < self.time {
            self.lift();
        }
        let was_step = time > self.time;
        self.time = time;
        let constraints = Constraints {
            layout: &self.layout,
            contacts: contacts.as_slice().map_err(refused)?,
            stiffness,
            springs,
        };
        let mut memory = self.memory.bind(py).readwrite();
        let memory = memory.as_slice_mut().map_err(refused)?;
        let view = View::new(memory, &self.places);
        let joints = view.joints();
        let mut is_loaded = false;
        for (foot, &[place, turn]) in self.feet.iter_mut().zip(&self.places.frames) {
            foot.update_load(view.acceleration);
            self.contacts.clear();
            constraints.contacts(foot, &mut self.contacts);
            if self.contacts.is_empty() {
                foot.lift();
                continue;
            }
            let [origin]: &[Triple; 1] = first(memory, place);
            let [frame]: &[[f64; 9]; 1] = first(memory, turn);
            let frame = Matrix3::from_row_slice(frame);
            foot.place(&self.contacts, &(*origin).into(), &frame);
            foot.turn(view.axes, view.centres);
            foot.press(&self.contacts, view.velocity);
            let origin = Vector3::from(view.origins[foot.bodies[0]]);
            foot.follow(&joints, dt, &origin, was_step);
            is_loaded |= foot.load > 0.0;
        }
        if !is_loaded {
            for foot in &mut self.feet {
                foot.take(&Vector3::zeros(), false);
            }
            return Ok(false);
        }
        if let Some((rows, _)) = &self.mass {
            let mut rows = rows.bind(py).readwrite();
            write(
                &self.feet,
                view.velocity.len(),
                rows.as_slice_mut().map_err(refused)?,
            );
            return Ok(true);
        }
        add_friction(
            &mut self.feet,
            &self.groups,
            memory,
            &self.places,
            (None, dt),
        )?;
        Ok(false)
    }

    /// The rest of `step`, with the mass solved.
    fn push(&mut self, py: Python<'_>, dt: f64) -> PyResult<()> {
        let Some((_, solved)) = &self.mass else {
            return Ok(());
        };
        let solved = solved.bind(py).readonly();
        let mut memory = self.memory.bind(py).readwrite();
        let memory = memory.as_slice_mut().map_err(refused)?;
        let solved = Some(solved.as_slice().map_err(refused)?);
        add_friction(
            &mut self.feet,
            &self.groups,
            memory,
            &self.places,
            (solved, dt),
        )
    }

    /// Of a foot: load, friction on it, its twist before the step, axes, centre, whether it is held, and how many
    /// searches for its friction stopped at their count.
    fn state(&self, foot: usize) -> PyResult<FootState> {
        let foot = self.feet.get(foot).ok_or_else(|| refused("no such foot"))?;
        Ok((
            foot.load,
            foot.friction().into(),
            foot.twist.into(),
            foot.axes.into(),
            foot.centre.into(),
            foot.is_held,
            foot.missed,
        ))
    }
}

/// MuJoCo's arrays.
struct View<'a> {
    velocity: &'a [f64],
    acceleration: &'a [f64],
    axes: &'a [[f64; 6]],
    centres: &'a [Triple],
    origins: &'a [Triple],
    anchors: &'a [Triple],
    inertias: &'a [[f64; 9]],
}

impl<'a> View<'a> {
    fn new(memory: &'a [f64], places: &Places) -> Self {
        let &Places {
            freedoms,
            bodies,
            joints,
            ..
        } = places;
        Self {
            velocity: &memory[places.velocity..][..freedoms],
            acceleration: &memory[places.acceleration..][..freedoms],
            axes: memory[places.axes..][..6 * freedoms].as_chunks().0,
            centres: memory[places.centres..][..3 * bodies].as_chunks().0,
            origins: memory[places.origins..][..3 * bodies].as_chunks().0,
            anchors: memory[places.anchors..][..3 * joints].as_chunks().0,
            inertias: memory[places.inertias..][..9 * bodies].as_chunks().0,
        }
    }

    fn joints(&self) -> Joints<'a> {
        Joints {
            anchors: self.anchors,
            axes: self.axes,
            velocity: self.velocity,
        }
    }
}

/// MuJoCo's contacts and rows of constraints.
struct Constraints<'a> {
    layout: &'a Layout,
    contacts: &'a [i64],
    /// Of each row: the inverse of its regularisation.
    stiffness: &'a Bound<'a, PyArray1<f64>>,
    /// Of each row: stiffness, damping, impedance and its derivative of its reference.
    springs: &'a Bound<'a, PyArray2<f64>>,
}

impl Constraints<'_> {
    /// The contacts of a foot with its floor that the solver has.
    fn contacts(&self, foot: &Foot, out: &mut Vec<Contact>) {
        let layout = self.layout;
        for contact in self.contacts.chunks_exact(layout.width) {
            let integer = |at: usize| {
                let [a, b, c, d, e, f, g, h] = contact[at / 2].to_ne_bytes();
                i32::from_ne_bytes(if at.is_multiple_of(2) {
                    [a, b, c, d]
                } else {
                    [e, f, g, h]
                })
            };
            let number = |at: usize| f64::from_bits(contact[at].cast_unsigned());
            let vector = |at: usize| Vector3::new(number(at), number(at + 1), number(at + 2));
            // MuJoCo's normal is from the first geom to the second.
            let [first, second] = [integer(layout.geoms), integer(layout.geoms + 1)];
            let sign = if first == foot.floor && foot.geoms.contains(&second) {
                1.0
            } else if second == foot.floor && foot.geoms.contains(&first) {
                -1.0
            } else {
                continue;
            };
            let row = usize::try_from(integer(layout.row)).unwrap_or(usize::MAX);
            let spring = [0, 1, 2].map(|column| self.springs.get_owned([row, column]));
            if let (Some(stiffness), [Some(k), Some(b), Some(impedance)]) =
                (self.stiffness.get_owned([row]), spring)
            {
                out.push(Contact {
                    at: vector(layout.position),
                    normal: vector(layout.frame) * sign,
                    gap: number(layout.distance) - number(layout.margin),
                    stiffness,
                    spring: [k, b, impedance],
                });
            }
        }
    }
}

/// Rows of a fixed number at the place `at`.
fn first<const N: usize>(memory: &[f64], at: usize) -> &[[f64; N]; 1] {
    let (rows, _) = memory[at..][..N].as_chunks();
    rows.as_array().expect("one row")
}

/// The feet's Jacobians as rows of `count` numbers, six a foot.
fn write(feet: &[Foot], count: usize, rows: &mut [f64]) {
    rows.fill(0.0);
    for (foot, rows) in feet.iter().zip(rows.chunks_exact_mut(6 * count)) {
        for (freedom, column) in foot.freedoms.iter().zip(&foot.jacobian) {
            for (row, value) in rows.chunks_exact_mut(count).zip(column) {
                row[freedom.index] = *value;
            }
        }
    }
}

/// Feet by groups with degrees of freedom of the same trees, directly or by way of others.
fn groups(feet: &[Foot]) -> Vec<Vec<usize>> {
    let mut groups: Vec<(Vec<usize>, Vec<usize>)> = Vec::new();
    for (index, foot) in feet.iter().enumerate() {
        let mut roots: Vec<usize> = foot.freedoms.iter().map(|freedom| freedom.root).collect();
        let mut members = Vec::new();
        groups.retain_mut(|(others, trees)| {
            let is_other = !trees.iter().any(|tree| roots.contains(tree));
            if !is_other {
                members.append(others);
                roots.append(trees);
            }
            is_other
        });
        members.push(index);
        groups.push((members, roots));
    }
    groups.into_iter().map(|(members, _)| members).collect()
}

/// Solves the step for each group of feet and adds their friction to the passive forces.
fn add_friction(
    feet: &mut [Foot],
    groups: &[Vec<usize>],
    memory: &mut [f64],
    places: &Places,
    (solved, dt): (Option<&[f64]>, f64),
) -> PyResult<()> {
    let mut loaded = Vec::new();
    for group in groups {
        loaded.clear();
        for &foot in group {
            if feet[foot].load > 0.0 {
                loaded.push(foot);
            } else {
                feet[foot].take(&Vector3::zeros(), false);
            }
        }
        if loaded.is_empty() {
            continue;
        }
        let solution = solution(feet, &loaded, &View::new(memory, places), (solved, dt))?;
        let force = &mut memory[places.force..][..places.freedoms];
        let found = solution.friction.iter().zip(&solution.is_held);
        let found = found.zip(&solution.is_missed);
        for (&foot, ((friction, is_held), is_missed)) in loaded.iter().zip(found) {
            let foot = &mut feet[foot];
            foot.take(friction, *is_held);
            foot.missed += u64::from(*is_missed);
            for (freedom, column) in foot.freedoms.iter().zip(&foot.jacobian) {
                force[freedom.index] += column.fixed_rows::<3>(0).dot(friction);
            }
        }
    }
    Ok(())
}

/// Friction of those of the feet that are `loaded`.
fn solution(
    feet: &[Foot],
    loaded: &[usize],
    view: &View<'_>,
    (solved, dt): (Option<&[f64]>, f64),
) -> PyResult<Solution> {
    let feet: Vec<&Foot> = loaded.iter().map(|&foot| &feet[foot]).collect();
    let mobility = match solved {
        None => free_mobility(&feet, view),
        Some(solved) => solved_mobility(&feet, loaded, solved, view.velocity.len()),
    };
    let compliance = compliance(&feet, &mobility);
    let last: Rows = feet.iter().map(|foot| foot.friction()).collect();
    let velocity: Rows = feet.iter().map(|foot| foot.unrest(&feet, dt)).collect();
    let mut acceleration: Rows = Vec::with_capacity(feet.len());
    for (row, foot) in compliance.chunks_exact(feet.len()).zip(&feet) {
        let motion = foot.motion(view.acceleration);
        let whole = motion.fixed_rows::<3>(0).into_owned();
        let own = row.iter().zip(&last);
        acceleration.push(own.fold(whole, |left, (block, friction)| left - block * friction));
    }
    let limits: Vec<Limits<'_>> = feet.iter().map(|foot| foot.limits()).collect();
    let step = Step {
        limits: &limits,
        compliance: &compliance,
        velocity: &velocity,
        acceleration: &acceleration,
        dt,
    };
    step.solve(&last)
}

/// Acceleration of each foot, row by row, that unit wrenches on each foot give, where all bodies move freely.
fn free_mobility(feet: &[&Foot], view: &View<'_>) -> Vec<Matrix6<f64>> {
    let roots: Vec<Vec<(usize, Matrix6<f64>)>> = feet
        .iter()
        .map(|foot| {
            let free = foot.free.iter();
            free.map(|free| {
                let body = free.body;
                (
                    body,
                    foot.mobility(free, &view.centres[body], &view.inertias[body]),
                )
            })
            .collect()
        })
        .collect();
    let mut all = Vec::with_capacity(feet.len() * feet.len());
    for first in &roots {
        for second in &roots {
            let mut block = Matrix6::zeros();
            for (body, left) in first {
                for (_, right) in second.iter().filter(|(other, _)| other == body) {
                    block += left * right.transpose();
                }
            }
            all.push(block);
        }
    }
    all
}

/// The same with the inverse mass times the Jacobians of all feet, those `loaded` among them.
fn solved_mobility(
    feet: &[&Foot],
    loaded: &[usize],
    solved: &[f64],
    count: usize,
) -> Vec<Matrix6<f64>> {
    let mut all = Vec::with_capacity(feet.len() * feet.len());
    for foot in feet {
        for second in loaded {
            let rows = &solved[6 * second * count..][..6 * count];
            let mut block = Matrix6::zeros();
            for (freedom, column) in foot.freedoms.iter().zip(&foot.jacobian) {
                let row = Vector6::from_fn(|k, _| rows[k * count + freedom.index]);
                block += column * row.transpose();
            }
            all.push(block);
        }
    }
    all
}

/// Acceleration in the contact planes that unit friction gives while the normal forces respond: the
/// mobility less what the normals' springs take, P − M K (1 + N K)⁻¹ Mᵀ in its blocks P in the plane, N along
/// the normals, M between them, and the springs' stiffness K.
fn compliance(feet: &[&Foot], mobility: &[Matrix6<f64>]) -> Vec<Matrix3<f64>> {
    let part = |block: &Matrix6<f64>, row: usize, column: usize| -> Matrix3<f64> {
        block.fixed_view::<3, 3>(3 * row, 3 * column).into_owned()
    };
    let count = feet.len();
    let springs: Vec<Matrix3<f64>> = feet.iter().map(|foot| foot.stiffness()).collect();
    if let ([block], [spring]) = (mobility, springs.as_slice()) {
        let system = Matrix3::identity() + part(block, 1, 1) * spring;
        let plane = part(block, 0, 0);
        let taken = system
            .try_inverse()
            .map(|inverse| part(block, 0, 1) * spring * inverse * part(block, 1, 0));
        return vec![plane - taken.unwrap_or_default()];
    }
    // The same for all feet at once, by elimination.
    let size = 3 * count;
    let at = |i: usize, j: usize| &mobility[i * count + j];
    let mut rows = nalgebra::DMatrix::zeros(size, size);
    let mut given = nalgebra::DMatrix::zeros(size, size);
    for i in 0..count {
        for (j, spring) in springs.iter().enumerate() {
            let mut block = part(at(i, j), 1, 1) * spring;
            if i == j {
                block += Matrix3::identity();
            }
            rows.fixed_view_mut::<3, 3>(3 * i, 3 * j).copy_from(&block);
            given
                .fixed_view_mut::<3, 3>(3 * i, 3 * j)
                .copy_from(&part(at(i, j), 1, 0));
        }
    }
    let found = rows.lu().solve(&given);
    let mut all = Vec::with_capacity(count * count);
    for i in 0..count {
        for j in 0..count {
            let mut block = part(at(i, j), 0, 0);
            for (k, spring) in springs.iter().enumerate() {
                if let Some(found) = &found {
                    let found = found.fixed_view::<3, 3>(3 * k, 3 * j);
                    block -= part(at(i, k), 0, 1) * (spring * found);
                }
            }
            all.push(block);
        }
    }
    all
}
