//! Ways to compute dry friction of a flat patch with straight edges: force and torque for a twist.

mod hull;
mod shapes;

pub use shapes::{Reference, Shape, SlopedFriction, shapes};

use hull::Hull;
use tribos::fit::support::{ConvexQuartic, MeasuredPush};
use tribos_core::Real;
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::law::CoulombLaw;
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid};
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{Node, NodeBuffer, NodePatch, NodeSlice};
use tribos_core::patch::polygon::polygon_into;
use tribos_core::twist::{Twist, Wrench};

/// Divisions of a triangle's sides for which nodes are tried.
const DIVISIONS: [u32; 4] = [2, 5, 10, 20];
/// Sampled wrenches of the hulls.
const SAMPLES: [usize; 2] = [100, 1000];
/// Wrenches that a quartic is fitted to.
const LEARNT: usize = 400;
/// Nodes of one triangle that is not divided, and most nodes of a shape.
const NODES: usize = 7;
const MOST_NODES: usize = 20_000;
/// Slope of the linear pressure that is timed, of the mean pressure over the radius.
const SLOPE: [f64; 2] = [0.6, 0.3];
/// The closed form under linear pressure.
pub const SLOPED: &str = "closed, linear pressure";

/// Force and torque for a twist.
pub type Evaluated = Box<dyn Fn(&Twist<f64>) -> Wrench<f64>>;

/// A method for one shape: friction for μN = 1 about the centroid.
pub struct Method {
    /// Its kind.
    pub name: &'static str,
    /// Points that it sums over or searches.
    pub points: usize,
    /// Force and torque.
    pub wrench: Evaluated,
}

impl core::fmt::Debug for Method {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Method")
            .field("name", &self.name)
            .field("points", &self.points)
            .finish_non_exhaustive()
    }
}

/// All methods for a shape.
pub fn methods(shape: &Shape) -> Result<Vec<Method>, String> {
    let told = |error: &dyn core::fmt::Display| format!("{}: {error}", shape.name);
    let exact = ShapeFriction::new(shape.patch::<f64>(), 1.0).map_err(|error| told(&error))?;
    let single = ShapeFriction::new(shape.patch::<f32>(), 1.0).map_err(|error| told(&error))?;
    let edges = shape.corners.len();
    let arm = -exact.wrench(1.0, &Twist::new(0.0, 0.0, 1.0)).torque;
    let radius = exact.patch().radius();
    let ellipsoid = LimitEllipsoid::new(1.0, radius, arm / radius).map_err(|error| told(&error))?;
    let narrow = f32::from_f64;
    let mut all = Vec::new();
    let pushes: Vec<MeasuredPush> = hull::motions(LEARNT, radius)
        .map(|motion| MeasuredPush {
            motion,
            wrench: -exact.wrench(1.0, &motion),
        })
        .collect();
    let quartic = ConvexQuartic::fitted(&pushes).map_err(|error| told(&error))?;
    all.push(method("convex quartic", LEARNT, move |twist| {
        -quartic.push(twist)
    }));
    let with_jacobian = exact.clone();
    for samples in SAMPLES {
        let hull = Hull::of(&exact, samples);
        all.push(method("sampled hull", samples, move |twist| {
            hull.wrench(twist)
        }));
    }
    all.push(method("closed", edges, move |twist| {
        exact.wrench(1.0, twist)
    }));
    all.push(method("closed, with Jacobian", edges, move |twist| {
        let (wrench, jacobian) = with_jacobian.wrench_and_jacobian(1.0, twist);
        core::hint::black_box(jacobian);
        wrench
    }));
    let sloped = shape.sloped(SLOPE.map(|part| part / radius));
    all.push(method(SLOPED, edges, move |twist| {
        sloped.wrench(1.0, twist)
    }));
    all.push(method("closed, f32", edges, move |twist| {
        let (v, spin) = (twist.velocity, twist.spin);
        let wrench = single.wrench(1.0, &Twist::new(narrow(v.x), narrow(v.y), narrow(spin)));
        let [x, y] = [wrench.force.x, wrench.force.y].map(f64::from);
        Wrench::new(x, y, f64::from(wrench.torque))
    }));
    all.push(method("ellipsoid", 1, move |twist| ellipsoid.wrench(twist)));
    for divisions in DIVISIONS {
        let count = NODES * (edges - 2) * (divisions * divisions) as usize;
        if count > MOST_NODES {
            break;
        }
        let mut memory = vec![Node::default(); count];
        let mut buffer = NodeBuffer::new(&mut memory);
        match polygon_into(&mut buffer, &shape.corners, divisions) {
            // No corner sees the whole shape.
            Err(PatchError::Hidden) => break,
            filled => filled.map_err(|error| told(&error))?,
        }
        let count = buffer.nodes().len();
        let total = buffer.total_weight();
        memory.truncate(count);
        for node in &mut memory {
            node.weight /= total;
        }
        let law = CoulombLaw::new(1.0).map_err(|error| told(&error))?;
        // The nodes live as long as the program.
        let nodes = NodeSlice::new(memory.leak()).map_err(|error| told(&error))?;
        let friction = NodeFriction::new(law, nodes);
        all.push(method("nodes", count, move |twist| {
            friction.wrench(1.0, twist)
        }));
    }
    Ok(all)
}

fn method(
    name: &'static str,
    points: usize,
    wrench: impl Fn(&Twist<f64>) -> Wrench<f64> + 'static,
) -> Method {
    Method {
        name,
        points,
        wrench: Box::new(wrench),
    }
}
