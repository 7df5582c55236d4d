//! Motions, forces and vectors.

use nalgebra::Vector3;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Motion of a rigid patch in its plane. Units: length/time and 1/time, in any consistent set.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_twist_f64 {
    /// Sliding velocity of the patch centre, first component.
    pub x: f64,
    /// Sliding velocity of the patch centre, second component.
    pub y: f64,
    /// Angular velocity about the normal; positive turns the first axis towards the second.
    pub spin: f64,
}

/// Force and torque on a patch in its plane. Units: force, and force x length.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_wrench_f64 {
    /// Force at the patch centre, first component.
    pub x: f64,
    /// Force at the patch centre, second component.
    pub y: f64,
    /// Torque about the normal.
    pub torque: f64,
}

/// Derivatives d(force x, force y, torque)/d(velocity x, velocity y, spin).
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_jacobian_f64 {
    /// `rows[i][j]`: component i of the wrench per component j of the twist.
    pub rows: [[f64; 3]; 3],
}

/// A vector in three dimensions.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_vector_f64 {
    /// First component.
    pub x: f64,
    /// Second component.
    pub y: f64,
    /// Third component.
    pub z: f64,
}

impl From<tribos_twist_f64> for Twist<f64> {
    #[inline(always)]
    fn from(t: tribos_twist_f64) -> Self {
        Self::new(t.x, t.y, t.spin)
    }
}

impl From<Twist<f64>> for tribos_twist_f64 {
    #[inline(always)]
    fn from(t: Twist<f64>) -> Self {
        Self {
            x: t.velocity.x,
            y: t.velocity.y,
            spin: t.spin,
        }
    }
}

impl From<tribos_wrench_f64> for Wrench<f64> {
    #[inline(always)]
    fn from(w: tribos_wrench_f64) -> Self {
        Self::new(w.x, w.y, w.torque)
    }
}

impl From<Wrench<f64>> for tribos_wrench_f64 {
    #[inline(always)]
    fn from(w: Wrench<f64>) -> Self {
        Self {
            x: w.force.x,
            y: w.force.y,
            torque: w.torque,
        }
    }
}

impl From<WrenchJacobian<f64>> for tribos_jacobian_f64 {
    #[inline(always)]
    fn from(j: WrenchJacobian<f64>) -> Self {
        // The kernel stores columns, the header rows.
        Self {
            rows: j.transpose().into(),
        }
    }
}

impl From<tribos_vector_f64> for Vector3<f64> {
    #[inline(always)]
    fn from(v: tribos_vector_f64) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl From<Vector3<f64>> for tribos_vector_f64 {
    #[inline(always)]
    fn from(v: Vector3<f64>) -> Self {
        Self {
            x: v.x,
            y: v.y,
            z: v.z,
        }
    }
}
