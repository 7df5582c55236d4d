"""A cube launched on a floor stops after v^2 / (2 mu g) with one friction model of Rapier, not with the other."""

import math

import rapier3d as rapier


def run(model, direction, angle, mu=0.5, g=9.81, dt=1 / 240):
    world = rapier.PhysicsWorld(gravity=(0, 0, -g))
    p = world.integration_parameters
    p.dt, p.friction_model = dt, model
    floor = world.rigid_bodies.insert(rapier.RigidBody.fixed())
    world.colliders.insert_with_parent(rapier.Collider.halfspace((0, 0, 1)).friction(mu), floor, world.rigid_bodies)
    handle = world.rigid_bodies.insert(rapier.RigidBody.dynamic().translation((0, 0, 0.05)).can_sleep(False))
    world.colliders.insert_with_parent(rapier.Collider.cuboid(0.05, 0.05, 0.05).density(1000).friction(mu), handle, world.rigid_bodies)
    for _ in range(round(0.5 / dt)):
        world.step()
    body = world.rigid_bodies[handle]
    c, s = math.cos(direction), math.sin(direction)
    pull = math.sin(angle) * g
    world.gravity = (c * pull, s * pull, -g * math.cos(angle))
    body.linvel = (c, s, 0)
    n = round(0.1 / dt)
    for _ in range(n):
        world.step()
    v = body.linvel
    slowed = (1 - math.hypot(v[0], v[1])) / (n * dt)
    return (slowed + pull) / (g * math.cos(angle))


for model in (rapier.FrictionModel.SIMPLIFIED, rapier.FrictionModel.COULOMB):
    for angle in (0.0, 0.2, 0.4):
        print(model, f"slope {angle}", "mu found by direction:", [f"{run(model, math.radians(d), angle):.3f}" for d in (0, 30, 45, 60, 90)])
