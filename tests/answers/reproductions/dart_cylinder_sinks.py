"""DART 6.20 (dartpy): a flat cylinder of 8 cm radius at rest on a box sinks with the default detector (FCL), and with DART's own."""

import dartpy as dart
import numpy as np


def height(detector):
    world = dart.simulation.World()
    world.setTimeStep(1e-3)
    world.setGravity([0, 0, -9.81])
    world.setCollisionDetector(dart.simulation.CollisionDetectorType.__members__[detector])
    awake = world.getDeactivationOptions()
    awake.mEnabled = False
    world.setDeactivationOptions(awake)
    for name, shape, z in (("floor", dart.dynamics.BoxShape([10, 10, 1]), -0.5), ("puck", dart.dynamics.CylinderShape(0.08, 0.02), 0.01)):
        skeleton = dart.dynamics.Skeleton(name)
        make = skeleton.createWeldJointAndBodyNodePair if name == "floor" else skeleton.createFreeJointAndBodyNodePair
        _, body = make()
        place = dart.math.Isometry3(np.eye(3), [0, 0, z])
        if name == "puck":
            body.getParentJoint().setTransform(place)
            body.setInertia(dart.dynamics.Inertia(1.0, [0, 0, 0], np.diag([0.00176, 0.00176, 0.0032])))
        node = body.createShapeNode(shape)
        if name == "floor":
            node.setRelativeTransform(place)
        node.createCollisionAspect()
        node.createDynamicsAspect()
        world.addSkeleton(skeleton)
    for _ in range(500):
        world.step()
    return body.getTransform().translation()[2], len(world.getLastCollisionResult().getContacts())


for detector in ("FCL", "BULLET", "ODE", "DART"):
    print(detector, "height after 0.5 s (0.01 m at the start), contacts:", height(detector))
