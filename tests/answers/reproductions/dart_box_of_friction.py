"""DART 6.20 has a cone (NsgsFrictionSolver) beside the default box of friction: deceleration of a cube by direction of launch."""

import math

import dartpy as dart
import numpy as np


def slowed(direction, solver, mu=0.5, g=9.81, n=100, dt=1e-3):
    world = dart.simulation.World()
    world.setTimeStep(dt)
    world.setGravity([0, 0, -g])
    if solver:
        world.getConstraintSolver().setBoxedLcpSolver(solver())
    for name, shape, z in (("floor", dart.dynamics.BoxShape([9, 9, 1]), -0.5), ("cube", dart.dynamics.BoxShape([0.1] * 3), 0.05)):
        skeleton = dart.dynamics.Skeleton(name)
        make = skeleton.createWeldJointAndBodyNodePair if name == "floor" else skeleton.createFreeJointAndBodyNodePair
        joint, body = make()
        node = body.createShapeNode(shape)
        node.createCollisionAspect()
        node.createDynamicsAspect().setFrictionCoeff(mu)
        place = dart.math.Isometry3(np.eye(3), [0, 0, z])
        node.setRelativeTransform(place) if name == "floor" else joint.setTransform(place)
        world.addSkeleton(skeleton)
    body.setInertia(dart.dynamics.Inertia(1.0, [0, 0, 0], np.eye(3) / 600))
    joint.setLinearVelocity([math.cos(direction), math.sin(direction), 0])
    for _ in range(n):
        world.step()
    return (1 - np.linalg.norm(body.getLinearVelocity()[:2])) / (n * dt * g)


for solver in (None, dart.constraint.NsgsFrictionSolver):
    print(solver, "mu found by direction (0.5):", [f"{slowed(math.radians(a), solver):.3f}" for a in (0, 15, 30, 45)])
