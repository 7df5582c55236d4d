//! State that is put aside and taken up again: the same bits.

use crate::table::*;
use rapier3d::prelude::*;
use tribos_rapier::{Patch, PatchContacts};

/// A disk, a polygon and a body on two feet, thrown; a disk at rest under a push.
fn game() -> (Table, Vec<RigidBodyHandle>) {
    let mut table = Table::level();
    let thrown = |z: f32| {
        RigidBodyBuilder::dynamic()
            .translation(Vector::new(0.0, HALF_HEIGHT, z))
            .linvel(Vector::new(1.0, 0.0, 0.1))
            .angvel(Vector::new(0.0, 12.5, 0.0))
    };
    let corners = [[-0.05, -0.05], [0.05, -0.05], [0.05, 0.05], [-0.05, 0.05]];
    let square = Patch::polygon(MU, &corners, 2).ok();
    let cube = ColliderBuilder::cuboid(0.05, HALF_HEIGHT, 0.05);
    let (first, _) = table.put(thrown(0.0), puck_shape(), disk());
    let (second, _) = table.put(thrown(1.0), cube, square);
    let (third, _) = table.put(thrown(2.0), puck_shape(), ring());
    let aside = puck_shape().translation(Vector::new(0.2, 0.0, 0.0));
    let foot = table.world.insert_collider(aside, Some(third));
    table.give(foot, disk().unwrap());
    let (rest, _) = table.put(
        RigidBodyBuilder::dynamic().translation(Vector::new(0.0, HALF_HEIGHT, 3.0)),
        puck_shape(),
        disk(),
    );
    let push = 0.5 * MU * table.world.bodies[rest].mass() * GRAVITY;
    table.world.bodies[rest].add_force(Vector::X * push, true);
    (table, vec![first, second, third, rest])
}

/// The bits of all places and velocities after 90 steps, with the contacts put through `saved` after
/// each 10th of them.
fn played(saved: impl Fn(PatchContacts) -> PatchContacts) -> Vec<u32> {
    let (mut table, bodies) = game();
    for step in 0..90 {
        if step % 10 == 9 {
            table.patches = saved(std::mem::take(&mut table.patches));
        }
        table.steps(1);
    }
    let numbers = |&body: &RigidBodyHandle| {
        let body = &table.world.bodies[body];
        let (v, w, x) = (body.linvel(), body.angvel(), body.translation());
        [v.x, v.z, w.y, x.x, x.z].map(f32::to_bits)
    };
    bodies.iter().flat_map(numbers).collect()
}

#[test]
fn a_clone_goes_on_to_the_same_bits() {
    let whole = played(|patches| patches);
    assert_eq!(played(|patches| patches.clone()), whole);
    // Contacts made anew have forgotten the loads.
    let anew = played(|_| PatchContacts::new());
    assert_ne!(anew, whole);
}

#[cfg(feature = "serde-serialize")]
#[test]
fn what_was_serialised_goes_on_to_the_same_bits() {
    let through_text = |patches: PatchContacts| {
        let text = serde_json::to_string(&patches).unwrap();
        serde_json::from_str(&text).unwrap()
    };
    assert_eq!(played(through_text), played(|patches| patches));
}

#[cfg(feature = "serde-serialize")]
#[test]
fn contacts_restored_in_the_middle_of_a_step_take_back_what_was_lent() {
    let (mut table, bodies) = game();
    table.steps(5);
    let (world, patches) = (&mut table.world, &mut table.patches);
    let forces = bodies.iter().map(|&body| world.bodies[body].user_force());
    let forces: Vec<Vector> = forces.collect();
    let parameters = world.integration_parameters;
    patches.begin_step(
        world.gravity,
        &parameters,
        &mut world.bodies,
        &world.colliders,
    );
    let text = serde_json::to_string(&*patches).unwrap();
    let mut restored: PatchContacts = serde_json::from_str(&text).unwrap();
    world.step_with_events(&restored, &());
    restored.finish_step(
        &parameters,
        &mut world.bodies,
        &world.colliders,
        &world.narrow_phase,
    );
    for (&body, force) in bodies.iter().zip(forces) {
        assert_eq!(world.bodies[body].user_force(), force);
    }
}
