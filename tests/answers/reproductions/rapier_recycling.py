"""Rapier 0.36.1: a puck that friction must hold on a turning (kinematic) table leaves it while contact_recycling is on (the default)."""

import math

import rapier3d as rapier


def run(recycling, model, dt=1 / 240, rate=2.97):
    world = rapier.PhysicsWorld(gravity=(0, 0, -9.81))
    p = world.integration_parameters
    p.contact_recycling, p.dt, p.friction_model = recycling, dt, model
    bodies = []
    for make, radius, half, place in (
        (rapier.RigidBody.kinematic_velocity_based, 2.0, 0.05, (0, 0, -0.05)),
        (rapier.RigidBody.dynamic, 0.04, 0.01, (0.3, 0, 0.01)),
    ):
        handle = world.rigid_bodies.insert(make().translation(place).can_sleep(False))
        shape = rapier.Collider.cylinder(half, radius).rotation((math.pi / 2, 0, 0)).friction(0.3)
        world.colliders.insert_with_parent(shape, handle, world.rigid_bodies)
        bodies.append(world.rigid_bodies[handle])
    for _ in range(round(0.5 / dt)):
        world.step()
    table, puck = bodies
    x, y, _ = puck.translation
    table.angvel = puck.angvel = (0, 0, rate)
    puck.linvel = (-rate * y, rate * x, 0)
    for _ in range(round(1 / dt)):
        world.step()
    x, y, z = puck.translation
    return f"{math.hypot(x, y):.4f} m from the axis, middle at z {z:.4f} m"


for model in (rapier.FrictionModel.SIMPLIFIED, rapier.FrictionModel.COULOMB):
    for recycling in (True, False):
        print(model, f"recycling {recycling}: from 0.3 m, 0.0100 m to", run(recycling, model))
