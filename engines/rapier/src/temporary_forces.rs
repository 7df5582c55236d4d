//! Forces and velocity offsets that are applied to bodies for one step.

use crate::reduced::accelerate;
use rapier3d::prelude::*;

/// A body with its temporary changes.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct TemporaryForces {
    body: RigidBodyHandle,
    /// Changes of the linear and angular velocity.
    offset: [Vector; 2],
    /// Force and torque that the user had set.
    user: [Vector; 2],
}

impl TemporaryForces {
    /// Adds a force, a torque and an offset, and notes them in `lent`.
    pub(crate) fn lend(
        bodies: &mut RigidBodySet,
        handle: RigidBodyHandle,
        force: [Vector; 2],
        offset: [Vector; 2],
        lent: &mut Vec<Self>,
    ) {
        let Some(body) = bodies.get_mut(handle) else {
            return;
        };
        let user = [body.user_force(), body.user_torque()];
        body.add_force(force[0], false);
        body.add_torque(force[1], false);
        accelerate(body, &offset, 1.0);
        lent.push(Self {
            body: handle,
            offset,
            user,
        });
    }

    /// Restores the user's forces and removes the velocity offsets. Removed bodies are ignored.
    pub(crate) fn restore_forces(self, bodies: &mut RigidBodySet) {
        let Some(body) = bodies.get_mut(self.body) else {
            return;
        };
        body.reset_forces(false);
        body.reset_torques(false);
        body.add_force(self.user[0], false);
        body.add_torque(self.user[1], false);
        // A body that fell asleep is at rest.
        if !body.is_sleeping() {
            accelerate(body, &self.offset, -1.0);
        }
    }
}
