//! What is lent to the engine for one step: forces, and offsets of the velocities.

use crate::pair::Handles;
use crate::reduced::accelerate;
use rapier3d::prelude::*;

/// What to take back after the step, for the foot and the ground.
#[derive(Debug)]
pub(crate) struct Handed {
    lent: [Option<Lent>; 2],
}

#[derive(Debug)]
struct Lent {
    /// Changes of the linear and angular velocity.
    offset: [Vector; 2],
    /// Force and torque that the user had set.
    user: [Vector; 2],
}

impl Handed {
    /// Adds forces, torques and offsets to those bodies that are `moved`.
    pub(crate) fn over(
        bodies: &mut RigidBodySet,
        handles: Handles,
        moved: [bool; 2],
        forces: [[Vector; 2]; 2],
        offsets: [[Vector; 2]; 2],
    ) -> Self {
        let handles = [Some(handles.0), handles.1];
        let lent = [0, 1].map(|i| {
            let handle = handles[i].filter(|_| moved[i])?;
            let body = bodies.get_mut(handle)?;
            let user = [body.user_force(), body.user_torque()];
            body.add_force(forces[i][0], false);
            body.add_torque(forces[i][1], false);
            accelerate(body, &offsets[i], 1.0);
            Some(Lent {
                offset: offsets[i],
                user,
            })
        });
        Self { lent }
    }

    /// Leaves the forces as the user had set them, and the velocities without offset.
    pub(crate) fn taken_back(&self, bodies: &mut RigidBodySet, handles: Handles) {
        for (handle, lent) in [Some(handles.0), handles.1].into_iter().zip(&self.lent) {
            let Some(lent) = lent else { continue };
            let Some(body) = handle.and_then(|handle| bodies.get_mut(handle)) else {
                continue;
            };
            body.reset_forces(false);
            body.reset_torques(false);
            body.add_force(lent.user[0], false);
            body.add_torque(lent.user[1], false);
            // A body that fell asleep was stopped.
            if !body.is_sleeping() {
                accelerate(body, &lent.offset, -1.0);
            }
        }
    }
}
