//! Friction of a patch under a law: the kernel's own types behind one table of functions a batch.

use crate::arrays::{Column, Numbers, View, refused};
use crate::patch::{Nodes, Shape};
use pyo3::PyResult;
use tribos::friction::{self, Law, Patch, Tier};
use tribos_core::coupling::flat::{
    DryPatch, FlatFriction, FlatPower, FlatPowerFriction, PowerPatch,
};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::round::{PolynomialTable, RoundTable64};
use tribos_core::coupling::{
    Annulus, Coupling, Dry, DryCoupling, PatchFriction, closed, table::Coulomb,
};
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface, PatchSurface};
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

/// Friction of a contact at one motion.
pub trait Contact: Send + Sync {
    /// The wrench on the patch.
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64>;
    /// Its derivative.
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64>;

    /// The wrenches of some twists under one load, to the same bits.
    #[inline]
    fn wrench_batch(&self, load: f64, twists: &[Twist<f64>], wrenches: &mut [Wrench<f64>]) {
        for (wrench, twist) in wrenches.iter_mut().zip(twists) {
            *wrench = self.wrench(load, twist);
        }
    }

    /// Their derivatives.
    #[inline]
    fn jacobian_batch(
        &self,
        load: f64,
        twists: &[Twist<f64>],
        jacobians: &mut [WrenchJacobian<f64>],
    ) {
        for (jacobian, twist) in jacobians.iter_mut().zip(twists) {
            *jacobian = self.jacobian(load, twist);
        }
    }
}

/// Number of elements that are computed together: in the cache, and enough for tables that go side by side.
const TOGETHER: usize = 64;

/// The same for batches; compiled for each type of the kernel.
pub trait Model: Contact {
    /// Wrenches of the elements from `from` on.
    fn wrenches(&self, batch: Batch<'_>, from: usize, out: &mut [[f64; 3]]);
    /// Jacobians, row by row.
    fn jacobians(&self, batch: Batch<'_>, from: usize, out: &mut [[f64; 9]]);
}

impl<C: Contact> Model for C {
    fn wrenches(&self, batch: Batch<'_>, from: usize, out: &mut [[f64; 3]]) {
        // One load for all is the usual case, and the quickest.
        if let (View::One([load]), View::Each(twists)) = (batch.loads, batch.twists) {
            let mut wrenches = [Wrench::ZERO; TOGETHER];
            for (rows, twists) in pieces(out, &twists[from..]) {
                let (twists, count) = (together(twists), rows.len());
                self.wrench_batch(load, &twists[..count], &mut wrenches[..count]);
                for (row, wrench) in rows.iter_mut().zip(&wrenches) {
                    *row = numbers(wrench);
                }
            }
            return;
        }
        for (index, row) in (from..).zip(out) {
            let [load] = batch.loads.at(index);
            *row = numbers(&self.wrench(load, &twist_of(batch.twists.at(index))));
        }
    }

    fn jacobians(&self, batch: Batch<'_>, from: usize, out: &mut [[f64; 9]]) {
        if let (View::One([load]), View::Each(twists)) = (batch.loads, batch.twists) {
            let mut jacobians = [WrenchJacobian::zeros(); TOGETHER];
            for (rows, twists) in pieces(out, &twists[from..]) {
                let (twists, count) = (together(twists), rows.len());
                self.jacobian_batch(load, &twists[..count], &mut jacobians[..count]);
                for (row, jacobian) in rows.iter_mut().zip(&jacobians) {
                    row.copy_from_slice(jacobian.as_slice());
                }
            }
            return;
        }
        for (index, row) in (from..).zip(out) {
            let [load] = batch.loads.at(index);
            let jacobian = self.jacobian(load, &twist_of(batch.twists.at(index)));
            // Symmetric: columns are rows.
            row.copy_from_slice(jacobian.as_slice());
        }
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

struct Round<C>(PatchFriction<f64, C>);

impl<C: Coupling<f64> + Send + Sync> Contact for Round<C> {
    #[inline]
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64> {
        self.0.wrench(load, twist)
    }
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.0.wrench_jacobian(load, twist)
    }
    #[inline]
    fn wrench_batch(&self, load: f64, twists: &[Twist<f64>], wrenches: &mut [Wrench<f64>]) {
        self.0.wrench_batch(load, twists, wrenches);
    }
    #[inline]
    fn jacobian_batch(
        &self,
        load: f64,
        twists: &[Twist<f64>],
        jacobians: &mut [WrenchJacobian<f64>],
    ) {
        self.0.jacobian_batch(load, twists, jacobians);
    }
}

impl<P: DryPatch<f64> + Send + Sync> Contact for FlatFriction<f64, P> {
    #[inline]
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64> {
        FlatFriction::wrench(self, load, twist)
    }
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.wrench_and_jacobian(load, twist).1
    }
}

impl<P: PowerPatch<f64> + Send + Sync> Contact for FlatPowerFriction<f64, P> {
    #[inline]
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64> {
        FlatPowerFriction::wrench(self, load, twist)
    }
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.wrench_and_jacobian(load, twist).1
    }
}

/// Points under any law of the local speed.
struct AtPoints(NodeFriction<friction::AnyLaw<f64>, Nodes>);

impl Contact for AtPoints {
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64> {
        self.0.wrench(load, twist)
    }
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.0.wrench_jacobian(load, twist)
    }
}

/// Makes the kernel's type of a power of the speed on a round patch.
struct Boxed {
    coefficient: f64,
    radius: f64,
}

impl friction::Visitor<f64> for Boxed {
    type Output = PyResult<Box<dyn Model>>;
    fn visit<P: friction::RoundPower<f64> + 'static>(self, friction: P) -> Self::Output {
        let friction = PatchFriction::new(friction, self.coefficient, self.radius);
        Ok(Box::new(Round(friction.map_err(refused)?)))
    }
}

/// Friction of `shape` under `law`; `tier` for round patches alone.
pub fn model(shape: &Shape, law: &Law, tier: Option<Tier>) -> PyResult<Box<dyn Model>> {
    law.made::<f64>().map_err(refused)?;
    if let Shape::Round(patch, radius) = shape {
        return round(patch, *radius, law, tier);
    }
    if tier.is_some() {
        return Err(refused(
            "tier is for round patches: leave it out for straight edges and points, which have one \
             way of evaluation each",
        ));
    }
    let power = law.power_of_speed();
    if let (Shape::Points(points), false) = (shape, matches!(power, Some([_, 0.0]))) {
        let law = law.made().map_err(refused)?;
        let nodes = points.nodes().clone();
        return Ok(Box::new(AtPoints(NodeFriction::new(law, nodes))));
    }
    match power {
        Some([mu, 0.0]) => dry(shape, mu),
        Some([gamma, alpha]) => of_power(shape, gamma, alpha),
        None => Err(refused(format!(
            "{} is not served on straight edges: Coulomb's law is, and on polygons powers of the \
             speed; or put points on the patch with tribos.points",
            law.name()
        ))),
    }
}

fn round(patch: &Patch, radius: f64, law: &Law, tier: Option<Tier>) -> PyResult<Box<dyn Model>> {
    let tier = Tier::serving::<f64>(patch, law, tier).map_err(refused)?;
    match (tier, law.power_of_speed()) {
        (Tier::Table | Tier::Compact, Some([coefficient, alpha])) => {
            let visitor = Boxed {
                coefficient,
                radius,
            };
            friction::visit(patch, alpha, tier, visitor).map_err(refused)?
        }
        _ => {
            let friction = friction::Friction::<f64>::new(patch, law, Some(tier));
            let friction = friction.map_err(refused)?.with_radius(radius);
            Ok(Box::new(Round(friction.map_err(refused)?)))
        }
    }
}

fn dry(shape: &Shape, mu: f64) -> PyResult<Box<dyn Model>> {
    fn boxed<P: DryPatch<f64> + Send + Sync + 'static>(
        patch: P,
        mu: f64,
    ) -> PyResult<Box<dyn Model>> {
        Ok(Box::new(FlatFriction::new(patch, mu).map_err(refused)?))
    }
    match shape.clone() {
        Shape::Round(..) => Err(refused(friction::Refusal::NoAxis)),
        Shape::Polygon(patch) => boxed(patch, mu),
        Shape::Leaning(patch) => boxed(patch, mu),
        Shape::Bar(patch) => boxed(patch, mu),
        Shape::Mesh(patch) => boxed(patch, mu),
        Shape::Points(patch) => boxed(patch, mu),
    }
}

fn of_power(shape: &Shape, gamma: f64, alpha: f64) -> PyResult<Box<dyn Model>> {
    let power = FlatPower::new(alpha).map_err(refused)?;
    match shape.clone() {
        Shape::Polygon(patch) => {
            let made = FlatPowerFriction::new(patch, gamma, power).map_err(refused)?;
            Ok(Box::new(made))
        }
        Shape::Leaning(patch) => {
            let made = FlatPowerFriction::new(patch, gamma, power).map_err(refused)?;
            Ok(Box::new(made))
        }
        _ => Err(refused(
            "on bars and meshes friction is Coulomb's: give mu alone, or use a polygon or points",
        )),
    }
}

/// Work with a limit surface.
pub type Work<'a> = &'a mut dyn FnMut(&dyn FrictionSet<f64>);

/// The limit surface of a patch for every force limit.
pub trait Sets: Send + Sync {
    /// Hands the surface of the force limit μN, in N, to `work`.
    fn with(&self, force_limit: f64, work: Work<'_>) -> PyResult<()>;

    /// The lowest and the highest torque with a force, in N m, NaN for a force that is not carried; for
    /// straight edges and points.
    fn torque_limits(&self, _force_limit: f64, _force: [f64; 2]) -> PyResult<[f64; 2]> {
        Err(refused(
            "torque limits are for straight edges and points: on a round patch use the gauge",
        ))
    }
}

struct RoundSets<C> {
    coupling: C,
    radius: f64,
}

impl<C: DryCoupling<f64> + Send + Sync> Sets for RoundSets<C> {
    fn with(&self, force_limit: f64, work: Work<'_>) -> PyResult<()> {
        let surface = LimitSurface::new(&self.coupling, force_limit, self.radius);
        work(&surface.map_err(refused)?);
        Ok(())
    }
}

struct FlatSets<P>(P);

impl<P: DryPatch<f64> + Send + Sync> Sets for FlatSets<P> {
    fn with(&self, force_limit: f64, work: Work<'_>) -> PyResult<()> {
        work(&PatchSurface::new(&self.0, force_limit).map_err(refused)?);
        Ok(())
    }

    fn torque_limits(&self, force_limit: f64, force: [f64; 2]) -> PyResult<[f64; 2]> {
        let surface = PatchSurface::new(&self.0, force_limit).map_err(refused)?;
        Ok(surface.torque_limits(force).unwrap_or([f64::NAN; 2]))
    }
}

struct EllipsoidSets {
    radius: f64,
    /// The largest torque per force limit and radius.
    spin_torque: f64,
}

impl Sets for EllipsoidSets {
    fn with(&self, force_limit: f64, work: Work<'_>) -> PyResult<()> {
        let surface = Ellipsoid::new(force_limit, self.radius, self.spin_torque);
        work(&surface.map_err(refused)?);
        Ok(())
    }
}

/// The ellipsoids with the same largest force, and the same largest torque about the origin.
pub fn ellipsoids(sets: &dyn Sets) -> PyResult<Box<dyn Sets>> {
    let mut made = None;
    sets.with(1.0, &mut |set| {
        let radius = set.radius();
        let spin_torque = set.support(&Twist::new(0.0, 0.0, 1.0)) / radius;
        made = Some(EllipsoidSets {
            radius,
            spin_torque,
        });
    })?;
    let made = made.ok_or_else(|| refused("there is no limit surface"))?;
    Ok(Box::new(made))
}

/// The limit surfaces of dry friction on `shape`.
pub fn sets(shape: &Shape) -> PyResult<Box<dyn Sets>> {
    match shape.clone() {
        Shape::Round(patch, radius) => round_sets(&patch, radius),
        Shape::Polygon(patch) => Ok(Box::new(FlatSets(patch))),
        Shape::Leaning(patch) => Ok(Box::new(FlatSets(patch))),
        Shape::Bar(patch) => Ok(Box::new(FlatSets(patch))),
        Shape::Mesh(patch) => Ok(Box::new(FlatSets(patch))),
        Shape::Points(patch) => Ok(Box::new(FlatSets(patch))),
    }
}

fn round_sets(patch: &Patch, radius: f64) -> PyResult<Box<dyn Sets>> {
    fn boxed<C: DryCoupling<f64> + Send + Sync + 'static>(
        coupling: C,
        radius: f64,
    ) -> PyResult<Box<dyn Sets>> {
        Ok(Box::new(RoundSets { coupling, radius }))
    }
    match patch {
        Patch::Disk => boxed(Coulomb, radius),
        Patch::Ring => boxed(closed::Ring, radius),
        Patch::Hertz => boxed(closed::Hertz, radius),
        Patch::Punch => boxed(closed::FlatPunch, radius),
        Patch::Annulus(inner) => boxed(Annulus::new(Coulomb, *inner).map_err(refused)?, radius),
        Patch::Polynomial(coefficients) => {
            let pressure = friction::polynomial(coefficients).map_err(refused)?;
            let table = PolynomialTable::new(0.0, &pressure).map_err(refused)?;
            boxed(Dry::new(table).map_err(refused)?, radius)
        }
        _ => {
            let pressure = patch.pressure().ok_or(friction::Refusal::NoAxis);
            let table = RoundTable64::new(0.0, pressure.map_err(refused)?).map_err(refused)?;
            boxed(Dry::new(table).map_err(refused)?, radius)
        }
    }
}
