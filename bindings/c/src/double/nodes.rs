//! Contacts at points, and quadrature rules that represent an area by points.
//!
//! Each call validates all nodes, which takes a third longer than the kernel itself on a desktop
//! processor. A node at rest contributes no friction.

use super::law::{Local, tribos_coulomb_f64, tribos_power_f64, tribos_stribeck_f64};
use super::vectors::{tribos_jacobian_f64, tribos_twist_f64, tribos_wrench_f64};
use crate::memory::{answer, read, slice, slice_mut};
use crate::status::tribos_status;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::patch::nodes::{Node, NodeBuffer, NodePatch, NodeSlice, Nodes};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::patch::polygon::polygon_into;

/// One point of a contact.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_node_f64 {
    /// First coordinate relative to the reference point of twist and wrench; finite.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
    /// Share of the load in any unit, not negative: only ratios of weights matter.
    pub weight: f64,
}

/// A point of the contact plane.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_point_f64 {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
}

/// A pressure on a disk, p = (1 - r^2/R^2)^q (1 + tilt x/R), represented by rings of nodes.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_disk_rule_f64 {
    /// Radius R, positive and finite.
    pub radius: f64,
    /// Number of rings, 1 to 1024.
    pub rings: u32,
    /// Nodes on each ring, 1 to 1024.
    pub angles: u32,
    /// Exponent q, -1 < q <= 64: -1/2 flat punch, 0 uniform, 1/2 Hertz.
    pub rim_exponent: f64,
    /// First component of the tilt, for the contact of a braking body; 0 for no tilt.
    pub tilt_x: f64,
    /// Second component of the tilt. A pressure that is negative at a node is refused.
    pub tilt_y: f64,
}

// The kernel's nodes and points have the same layout.
const _: () = {
    assert!(size_of::<Node<f64>>() == size_of::<tribos_node_f64>());
    assert!(align_of::<Node<f64>>() == align_of::<tribos_node_f64>());
    assert!(core::mem::offset_of!(Node<f64>, y) == core::mem::offset_of!(tribos_node_f64, y));
    assert!(
        core::mem::offset_of!(Node<f64>, weight) == core::mem::offset_of!(tribos_node_f64, weight)
    );
    assert!(size_of::<[f64; 2]>() == size_of::<tribos_point_f64>());
};

/// A law at nodes in the caller's memory.
type Friction<'a, L> = NodeFriction<<L as Local>::Law, NodeSlice<'a, f64>>;

#[inline(always)]
unsafe fn friction_of<'a, L: Local + Copy>(
    law: *const L,
    nodes: *const tribos_node_f64,
    count: usize,
) -> Result<Friction<'a, L>, tribos_status> {
    let nodes = slice(nodes.cast::<Node<f64>>(), count)?;
    Ok(NodeFriction::new(read(law)?.law()?, NodeSlice::new(nodes)?))
}

/// Wrench of Coulomb friction at `count` nodes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_nodes_coulomb_wrench_f64(
    law: *const tribos_coulomb_f64,
    nodes: *const tribos_node_f64,
    count: usize,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || {
        let friction = friction_of(law, nodes, count)?;
        Ok(friction.wrench(load, &read(twist)?.into()).into())
    })
}

/// Jacobian of Coulomb friction at `count` nodes. Special values: a node at rest contributes the law's
/// slope at rest if that is not negative, hence nothing under dry friction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_nodes_coulomb_jacobian_f64(
    law: *const tribos_coulomb_f64,
    nodes: *const tribos_node_f64,
    count: usize,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || {
        let friction = friction_of(law, nodes, count)?;
        Ok(friction.wrench_jacobian(load, &read(twist)?.into()).into())
    })
}

/// Wrench of the power law at `count` nodes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_nodes_power_wrench_f64(
    law: *const tribos_power_f64,
    nodes: *const tribos_node_f64,
    count: usize,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || {
        let friction = friction_of(law, nodes, count)?;
        Ok(friction.wrench(load, &read(twist)?.into()).into())
    })
}

/// Jacobian of the power law at `count` nodes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_nodes_power_jacobian_f64(
    law: *const tribos_power_f64,
    nodes: *const tribos_node_f64,
    count: usize,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || {
        let friction = friction_of(law, nodes, count)?;
        Ok(friction.wrench_jacobian(load, &read(twist)?.into()).into())
    })
}

/// Wrench of the Stribeck curve at `count` nodes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_nodes_stribeck_wrench_f64(
    law: *const tribos_stribeck_f64,
    nodes: *const tribos_node_f64,
    count: usize,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || {
        let friction = friction_of(law, nodes, count)?;
        Ok(friction.wrench(load, &read(twist)?.into()).into())
    })
}

/// Jacobian of the Stribeck curve at `count` nodes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_nodes_stribeck_jacobian_f64(
    law: *const tribos_stribeck_f64,
    nodes: *const tribos_node_f64,
    count: usize,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || {
        let friction = friction_of(law, nodes, count)?;
        Ok(friction.wrench_jacobian(load, &read(twist)?.into()).into())
    })
}

/// Nodes of a uniform pressure on a simple polygon in which one corner sees the whole interior. The
/// 7 (corners - 2) divisions^2 nodes are written to `nodes`, which has room for `capacity`; `filled` is
/// their number. After TRIBOS_STATUS_FULL and other refusals the content of `nodes` is undefined.
/// Accuracy: moments up to degree 5 to rounding; friction of a square 1.2e-2, 2.8e-3, 6.8e-4 of the
/// load with 56, 224, 896 nodes while the centre of rotation lies inside.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_polygon_nodes_f64(
    corners: *const tribos_point_f64,
    count: usize,
    divisions: u32,
    nodes: *mut tribos_node_f64,
    capacity: usize,
    filled: *mut usize,
) -> tribos_status {
    answer(filled, || {
        let corners = slice(corners.cast::<[f64; 2]>(), count)?;
        let mut list = NodeBuffer::new(slice_mut(nodes.cast::<Node<f64>>(), capacity)?);
        polygon_into(&mut list, corners, divisions)?;
        Ok(list.nodes().len())
    })
}

/// Nodes of a pressure on a disk: rings x angles of them, written as by tribos_polygon_nodes_f64.
/// Accuracy: Coulomb friction under uniform pressure 3.7e-3 with 8 x 16 nodes, 9.4e-4 with 16 x 32
/// while the centre of rotation lies inside; outside, the error falls geometrically.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_nodes_f64(
    rule: *const tribos_disk_rule_f64,
    nodes: *mut tribos_node_f64,
    capacity: usize,
    filled: *mut usize,
) -> tribos_status {
    answer(filled, || {
        let given = read(rule)?;
        let rule = PolarQuadrature::new(given.radius, given.rings, given.angles)?
            .with_rim_exponent(given.rim_exponent)?;
        let mut list = NodeBuffer::new(slice_mut(nodes.cast::<Node<f64>>(), capacity)?);
        rule.nodes_into(&mut list, |x, y| {
            1.0 + (given.tilt_x * x + given.tilt_y * y) / given.radius
        })?;
        Ok(list.nodes().len())
    })
}

/// Nodes of three feet that carry a body whose centre of mass lies above `centre`: `feet` points to
/// three points, `nodes` to room for three nodes, whose positions are relative to `centre`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_tripod_nodes_f64(
    feet: *const tribos_point_f64,
    centre: *const tribos_point_f64,
    nodes: *mut tribos_node_f64,
) -> tribos_status {
    answer(nodes.cast::<[Node<f64>; 3]>(), || {
        let feet = read(feet.cast::<[[f64; 2]; 3]>())?;
        let stool = Nodes::tripod(feet, read(centre.cast::<[f64; 2]>())?)?;
        <[Node<f64>; 3]>::try_from(stool.nodes()).map_err(|_| tribos_status::Count)
    })
}
