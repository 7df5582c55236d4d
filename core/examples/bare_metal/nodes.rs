//! Contacts at nodes.

use tribos_core::Real;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::law::PowerLaw;
use tribos_core::patch::nodes::{NodeList, NodePatch};
use tribos_core::patch::polar::{self, PolarRule};
use tribos_core::patch::polygon::polygon;
use tribos_core::patch::tripod::tripod;
use tribos_core::twist::Twist;

/// All kinds of node patches.
pub fn all<R: Real>(a: R, b: R) -> Option<R> {
    let feet = [[a, b], [-a, b], [b, -a]];
    let disk = PolarRule::new(a, 2, 6).ok()?.with_rim_exponent(b).ok()?;
    let disk: NodeList<R, 12> = disk.nodes_tilted(a, b).ok()?;
    let ring: NodeList<R, 6> = polar::ring(a, 6).ok()?;
    let foot: NodeList<R, 28> = polygon(&feet, 2).ok()?;
    let stool = tripod(feet, [R::ZERO; 2]).ok()?;
    let mut sum = node_friction_sum(&disk, a, b)? + node_friction_sum(&ring, a, b)?;
    sum += node_friction_sum(&foot, a, b)? + node_friction_sum(&stool, a, b)?;
    Some(sum)
}

/// Wrench and Jacobian of one node patch.
fn node_friction_sum<R: Real>(patch: &impl NodePatch<R>, a: R, b: R) -> Option<R> {
    let friction = NodeFriction::new(PowerLaw::new(a, b).ok()?, patch);
    let twist = Twist::new(a, b, b);
    Some(friction.wrench(a, &twist).torque + friction.wrench_jacobian(a, &twist).m33)
}
