//! The plugin, and when its systems run.

use crate::friction::PatchFriction;
use crate::gather::{Groups, gather_feet};
use crate::group::Bodies;
use crate::patch::FrictionPatch;
use avian3d::dynamics::integrator::IntegrationSystems;
use avian3d::dynamics::solver::constraint_graph::ConstraintGraph;
use avian3d::dynamics::solver::schedule::{SolverSystems, SubstepSchedule, SubstepSolverSystems};
use avian3d::prelude::*;
use bevy::prelude::*;
use tribos_core::contact::TimeStep;

/// Gives the colliders with a [`FrictionPatch`] their friction. Add it after
/// [`PhysicsPlugins`](avian3d::PhysicsPlugins), whose schedules it extends.
///
/// # Panics
///
/// Adding it panics if Avian's schedules are missing.
#[derive(Clone, Copy, Debug, Default)]
pub struct FrictionPatchPlugin;

impl Plugin for FrictionPatchPlugin {
    fn build(&self, app: &mut App) {
        assert!(
            app.get_schedule(SubstepSchedule).is_some(),
            "FrictionPatchPlugin extends Avian's schedules: add PhysicsPlugins before it"
        );
        app.init_resource::<Groups>();
        app.add_systems(
            PhysicsSchedule,
            (
                gather_feet
                    .after(SolverSystems::PrepareContactConstraints)
                    .before(SolverSystems::PreSubstep),
                report
                    .after(SolverSystems::Substep)
                    .before(SolverSystems::Restitution),
            )
                .ambiguous_with_all(),
        );
        app.add_systems(
            SubstepSchedule,
            (
                begin
                    .after(IntegrationSystems::Velocity)
                    .before(SubstepSolverSystems::WarmStart),
                resist
                    .after(SubstepSolverSystems::SolveConstraints)
                    .before(IntegrationSystems::Position),
                end.after(IntegrationSystems::Position)
                    .before(SubstepSolverSystems::Relax),
            )
                .ambiguous_with_all(),
        );
    }
}

fn begin(
    mut groups: ResMut<Groups>,
    mut bodies: Bodies,
    constraints: Res<ConstraintGraph>,
    time: Res<Time>,
) {
    let dt = time.delta_secs();
    for group in &mut groups.0 {
        // A body that is gone has no friction.
        let _ = group.begin(&mut bodies, &constraints, dt);
    }
}

fn resist(
    mut groups: ResMut<Groups>,
    mut bodies: Bodies,
    constraints: Res<ConstraintGraph>,
    time: Res<Time>,
) {
    let Ok(dt) = TimeStep::new(time.delta_secs()) else {
        return;
    };
    for group in &mut groups.0 {
        let _ = group.resist(&mut bodies, &constraints, dt);
    }
}

fn end(mut groups: ResMut<Groups>, mut bodies: Bodies) {
    for group in &mut groups.0 {
        group.end(&mut bodies);
    }
}

/// Writes the friction of the step to the components. Feet of sleeping bodies keep theirs.
fn report(
    mut groups: ResMut<Groups>,
    constraints: Res<ConstraintGraph>,
    mut frictions: Query<(&mut PatchFriction, Option<&ColliderOf>, Has<FrictionPatch>)>,
    sleeping: Query<(), With<Sleeping>>,
) {
    for (mut friction, body, is_foot) in &mut frictions {
        let sleeps = is_foot && body.is_some_and(|of| sleeping.contains(of.body));
        if !sleeps {
            friction.set_if_neq(PatchFriction::default());
        }
    }
    for group in &mut groups.0 {
        group.relaxed(&constraints);
        for (collider, friction) in group.report() {
            if let Ok((mut to, ..)) = frictions.get_mut(collider) {
                *to = friction;
            }
        }
    }
}
