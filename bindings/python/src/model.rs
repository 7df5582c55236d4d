//! Friction of a patch under a law over batches, and its limit surfaces.

use crate::arrays::{Column, Numbers, View, refused};
use pyo3::PyResult;
use tribos::friction::{Area, AreaFriction, LimitSurfaces};
use tribos_core::limit_surface::FrictionSet;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Loads and twists of a batch.
#[derive(Clone, Copy)]
pub struct Batch<'a> {
    /// Loads, in N.
    pub loads: View<'a, 1>,
    /// Velocities in m/s and spins in rad/s.
    pub twists: View<'a, 3>,
}

/// Loads for every element of a batch, none of them negative; one that is not a number gives results that
/// are none.
pub fn loads_over<'py>(loads: Numbers<'py>, batch: &[usize]) -> PyResult<Column<'py, 1>> {
    let loads = loads.over(batch)?;
    let negative = match loads.view()? {
        View::One([load]) => (load < 0.0).then_some(load),
        View::Each(loads) => loads
            .as_flattened()
            .iter()
            .copied()
            .find(|load| *load < 0.0),
    };
    match negative {
        Some(load) => Err(refused(format!("load must be >= 0, not {load}"))),
        None => Ok(loads),
    }
}

/// Number of elements that are computed together: in the cache, and enough for tables that go side by side.
const TOGETHER: usize = 64;

/// Wrenches of the elements from `from` on.
pub fn wrenches(friction: &AreaFriction, batch: Batch<'_>, from: usize, out: &mut [[f64; 3]]) {
    // One load for all is the usual case, and the quickest.
    if let (View::One([load]), View::Each(twists)) = (batch.loads, batch.twists) {
        let mut wrenches = [Wrench::ZERO; TOGETHER];
        for (rows, twists) in pieces(out, &twists[from..]) {
            let (twists, count) = (together(twists), rows.len());
            friction.wrench_batch(load, &twists[..count], &mut wrenches[..count]);
            for (row, wrench) in rows.iter_mut().zip(&wrenches) {
                *row = numbers(wrench);
            }
        }
        return;
    }
    for (index, row) in (from..).zip(out) {
        let [load] = batch.loads.at(index);
        *row = numbers(&friction.wrench(load, &twist_of(batch.twists.at(index))));
    }
}

/// Jacobians, row by row; they are symmetric, so that columns are rows.
pub fn jacobians(friction: &AreaFriction, batch: Batch<'_>, from: usize, out: &mut [[f64; 9]]) {
    if let (View::One([load]), View::Each(twists)) = (batch.loads, batch.twists) {
        let mut jacobians = [WrenchJacobian::zeros(); TOGETHER];
        for (rows, twists) in pieces(out, &twists[from..]) {
            let (twists, count) = (together(twists), rows.len());
            friction.jacobian_batch(load, &twists[..count], &mut jacobians[..count]);
            for (row, jacobian) in rows.iter_mut().zip(&jacobians) {
                row.copy_from_slice(jacobian.as_slice());
            }
        }
        return;
    }
    for (index, row) in (from..).zip(out) {
        let [load] = batch.loads.at(index);
        let jacobian = friction.wrench_jacobian(load, &twist_of(batch.twists.at(index)));
        row.copy_from_slice(jacobian.as_slice());
    }
}

/// Results and the rows of their twists, piece by piece.
fn pieces<'a, const N: usize>(
    out: &'a mut [[f64; N]],
    twists: &'a [[f64; 3]],
) -> impl Iterator<Item = (&'a mut [[f64; N]], &'a [[f64; 3]])> {
    let count = out.len().min(twists.len());
    let rows = out[..count].chunks_mut(TOGETHER);
    rows.zip(twists[..count].chunks(TOGETHER))
}

/// Rows as twists; zero after the last.
#[inline(always)]
fn together(rows: &[[f64; 3]]) -> [Twist<f64>; TOGETHER] {
    let mut twists = [Twist::ZERO; TOGETHER];
    for (twist, row) in twists.iter_mut().zip(rows) {
        *twist = twist_of(*row);
    }
    twists
}

/// A row as a twist.
#[inline(always)]
pub fn twist_of([x, y, spin]: [f64; 3]) -> Twist<f64> {
    Twist::new(x, y, spin)
}

/// A row as a wrench.
#[inline(always)]
pub fn wrench_of([x, y, torque]: [f64; 3]) -> Wrench<f64> {
    Wrench::new(x, y, torque)
}

/// A wrench as a row.
#[inline(always)]
pub fn numbers(wrench: &Wrench<f64>) -> [f64; 3] {
    [wrench.force.x, wrench.force.y, wrench.torque]
}

/// A twist as a row.
#[inline(always)]
pub fn twist_numbers(twist: &Twist<f64>) -> [f64; 3] {
    [twist.velocity.x, twist.velocity.y, twist.spin]
}

/// The limit surfaces of a patch, for every force limit.
pub struct Sets(pub LimitSurfaces);

impl Sets {
    /// Those of dry friction on `area`.
    pub fn new(area: &Area) -> PyResult<Self> {
        Ok(Self(area.limit_surfaces().map_err(refused)?))
    }

    /// What `work` makes of the surface of the force limit μN, in N.
    pub fn with<T>(
        &self,
        force_limit: f64,
        work: impl FnOnce(&dyn FrictionSet<f64>) -> T,
    ) -> PyResult<T> {
        self.0.under(force_limit, work).map_err(refused)
    }

    /// The ellipsoids with the same largest force, and the same largest torque about the origin.
    pub fn ellipsoids(&self) -> PyResult<Self> {
        Ok(Self(self.0.ellipsoid().map_err(refused)?))
    }
}
