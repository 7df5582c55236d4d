//! What is refused, and what is taken back.

use crate::table::*;
use rapier3d::prelude::*;
use tribos_rapier::{PairError, PatchContacts};

fn spinning() -> RigidBodyBuilder {
    lying(HALF_HEIGHT)
        .linvel(Vector::new(1.0, 0.0, 0.0))
        .angvel(Vector::new(0.0, 20.0, 0.0))
}

#[test]
fn the_wrong_order_and_feet_that_forces_do_not_move_are_refused() {
    let mut table = Table::level();
    let (_, foot) = table.put(spinning(), puck_shape(), None);
    let kinematic = RigidBodyBuilder::kinematic_velocity_based();
    let (_, driven) = table.world.insert(kinematic, puck_shape());
    let bare = table.world.insert_collider(puck_shape(), None);
    let gone = table.world.insert_collider(puck_shape(), None);
    table.world.remove_collider(gone);
    let ground = table.ground;
    let world = &mut table.world;
    let mut patches = PatchContacts::new();
    let mut insert = |foot, ground| {
        let patch = disk().unwrap();
        patches.insert(foot, ground, patch, &world.bodies, &mut world.colliders)
    };
    for fixed in [ground, driven, bare] {
        assert_eq!(insert(fixed, foot), Err(PairError::FootIsNotDynamic));
    }
    let missing = PairError::Missing { collider: gone };
    assert_eq!(insert(gone, ground), Err(missing));
    assert_eq!(insert(foot, gone), Err(missing));
    assert_eq!(insert(foot, foot), Err(PairError::OneBody));
    assert!(patches.is_empty());
}

#[test]
fn a_foot_that_becomes_fixed_is_the_engines() {
    let mut table = Table::level();
    let (body, _) = table.put(spinning(), puck_shape(), disk());
    table.steps(5);
    table.world.bodies[body].set_body_type(RigidBodyType::KinematicVelocityBased, true);
    table.world.bodies[body].set_linvel(Vector::X, true);
    table.steps(5);
    assert_eq!(table.world.bodies[body].linvel(), Vector::X);
}

/// What happens to the contact between the two halves of a step.
#[derive(Clone, Copy, Debug)]
enum Loss {
    Patch,
    Ground,
    Foot,
    Sleep,
    StepAnew,
    StepDropped,
    Exchanged,
}

#[test]
fn a_lent_force_is_always_taken_back() {
    for loss in [
        Loss::Patch,
        Loss::Ground,
        Loss::Foot,
        Loss::Sleep,
        Loss::StepAnew,
        Loss::StepDropped,
        Loss::Exchanged,
    ] {
        let mut table = Table::level();
        let (body, foot) = table.put(spinning(), puck_shape(), disk());
        let push = Vector::new(0.0, 0.0, 0.01);
        table.world.bodies[body].add_force(push, true);
        table.steps(5);
        let (ground, mut patches) = (table.ground, table.patches.clone());
        let world = &mut table.world;
        let before = world.bodies[body].linvel();
        let parameters = world.integration_parameters;
        patches.begin_step(
            world.gravity,
            &parameters,
            &mut world.bodies,
            &world.colliders,
        );
        assert_ne!(world.bodies[body].user_force(), push);
        match loss {
            Loss::Patch => assert!(patches.remove(foot, ground)),
            Loss::Ground => drop(world.remove_collider(ground)),
            Loss::Foot => drop(world.remove_collider(foot)),
            Loss::Sleep => world.bodies[body].sleep(),
            Loss::StepAnew => {
                patches.begin_step(
                    world.gravity,
                    &parameters,
                    &mut world.bodies,
                    &world.colliders,
                );
                patches.cancel_step(&mut world.bodies);
            }
            Loss::StepDropped => patches.cancel_step(&mut world.bodies),
            Loss::Exchanged => {
                patches.remove(foot, ground);
                let patch = ring().unwrap();
                patches
                    .insert(foot, ground, patch, &world.bodies, &mut world.colliders)
                    .unwrap();
            }
        }
        if !matches!(loss, Loss::StepAnew | Loss::StepDropped) {
            world.step_with_events(&patches, &());
            let bodies = &mut world.bodies;
            patches.finish_step(&parameters, bodies, &world.colliders, &world.narrow_phase);
        }
        assert_eq!(world.bodies[body].user_force(), push, "{loss:?}");
        assert_eq!(world.bodies[body].user_torque(), Vector::ZERO, "{loss:?}");
        if let Loss::StepDropped | Loss::StepAnew = loss {
            let after = world.bodies[body].linvel();
            assert!((after - before).length() < 1e-6, "{loss:?}");
        }
    }
}

#[test]
fn a_body_removed_in_the_middle_of_a_step_leaves_the_others_as_they_were() {
    let raft = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, -0.1, 0.0))
        .enabled_translations(true, false, true)
        .enabled_rotations(false, true, false)
        .can_sleep(false);
    let mut table = Table::on(raft, Vector::new(0.0, -GRAVITY, 0.0));
    let raft = table.world.colliders[table.ground].parent().unwrap();
    let (body, _) = table.put(spinning(), puck_shape(), disk());
    table.steps(5);
    let (world, patches) = (&mut table.world, &mut table.patches);
    let parameters = world.integration_parameters;
    patches.begin_step(
        world.gravity,
        &parameters,
        &mut world.bodies,
        &world.colliders,
    );
    assert_ne!(world.bodies[raft].user_force(), Vector::ZERO);
    world.remove_body(body);
    world.step_with_events(&*patches, &());
    patches.finish_step(
        &parameters,
        &mut world.bodies,
        &world.colliders,
        &world.narrow_phase,
    );
    assert_eq!(world.bodies[raft].user_force(), Vector::ZERO);
    assert_eq!(world.bodies[raft].user_torque(), Vector::ZERO);
}
