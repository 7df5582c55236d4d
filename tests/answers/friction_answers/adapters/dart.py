"""DART (pip install dartpy)."""

from importlib.metadata import version

import numpy as np
from dartpy import constraint, dynamics, simulation
from dartpy.math import Isometry3, Quaternion

from ..scene import of_origin, parts, refuse

NAME, VERSION, LICENCE, KIND = "DART", version("dartpy"), "BSD-2-Clause", "mechanics"
NSGS = {"dt": 1e-3, "solver": "NsgsFrictionSolver"}
SETTINGS = {"default": {"dt": 1e-3}, "NSGS": NSGS}
SETTINGS |= {f"NSGS, contacts by {name}": {**NSGS, "detector": name.upper()} for name in ("Bullet", "ODE")}
AWAKE = simulation.DeactivationOptions()
AWAKE.mEnabled = False


def pose(place, q):
    return Isometry3(Quaternion(*q).to_rotation_matrix(), place)


SHAPES = {
    "ball": dynamics.SphereShape,
    "box": lambda *half: dynamics.BoxShape([2 * size for size in half]),
    "cylinder": lambda radius, half: dynamics.CylinderShape(radius, 2 * half),
    "capsule": lambda radius, half: dynamics.CapsuleShape(radius, 2 * half),
}


class Simulator:
    def __init__(self, scene, setting, dt):
        lacks = {"torsion": "Contacts have no torsional friction.", "anisotropic": "Not in DART's Python package."}
        # The default collision detector, FCL, takes balls for capsules, and gives one contact of a face on a plane.
        floor = dynamics.PlaneShape((0.0, 0.0, 1.0), 0.0), (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)
        if "detector" not in setting:
            lacks["capsule"] = "The default collision detector has no capsules."
            floor = dynamics.BoxShape((200.0, 200.0, 1.0)), (0.0, 0.0, -0.5), (1.0, 0.0, 0.0, 0.0)
        refuse(scene, lacks)
        self.world, self.bodies = simulation.World(), []
        self.world.setTimeStep(dt)
        self.world.setDeactivationOptions(AWAKE)
        self.gravity(scene.gravity)
        if "detector" in setting:
            self.world.setCollisionDetector(simulation.CollisionDetectorType.__members__[setting["detector"]])
        if "solver" in setting:
            self.world.getConstraintSolver().setBoxedLcpSolver(getattr(constraint, setting["solver"])())
        if scene.has_floor:
            self.add(dynamics.Skeleton.createWeldJointAndBodyNodePair, [floor], scene.mu)
        for body in scene.bodies:
            joint, made = self.add(dynamics.Skeleton.createFreeJointAndBodyNodePair, parts(body.shape, **SHAPES), scene.mu)
            made.setInertia(dynamics.Inertia(body.mass, body.com, np.diag(body.inertia)))
            joint.setTransform(pose(body.place, body.pose))
            joint.setActuatorType(dynamics.VELOCITY if body.is_driven else dynamics.FORCE)
            self.bodies.append((joint, made))

    def add(self, create, shapes, mu):
        skeleton = dynamics.Skeleton(f"{self.world.getNumSkeletons()}")
        joint, body = create(skeleton)
        for shape, place, q in shapes:
            node = body.createShapeNode(shape)
            node.setRelativeTransform(pose(place, q))
            node.createCollisionAspect()
            node.createDynamicsAspect().setFrictionCoeff(mu)
        self.world.addSkeleton(skeleton)
        return joint, body

    def set(self, body, velocity, spin):
        joint, made = self.bodies[body]
        joint.setAngularVelocity(spin)
        joint.setLinearVelocity(of_origin(self.state(body)[1], velocity, spin, made.getLocalCOM()))
        if joint.isKinematic():
            joint.setCommands(joint.getVelocities())

    def step(self):
        self.world.step()

    def state(self, body):
        _, made = self.bodies[body]
        q = made.getTransform().quaternion().wxyz()
        return tuple(tuple(map(float, part)) for part in (made.getCOM(), q, made.getCOMLinearVelocity(), made.getAngularVelocity()))

    def gravity(self, vector):
        self.world.setGravity(vector)

    def force(self, body, vector):
        self.bodies[body][1].setExtForce(vector, self.bodies[body][1].getLocalCOM(), False, True)
