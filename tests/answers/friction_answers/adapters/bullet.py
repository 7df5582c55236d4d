"""Bullet (pip install pybullet)."""

import math
from importlib.metadata import version

import pybullet as bullet

from ..scene import FOOT, sum_of

NAME, VERSION, LICENCE, KIND = "Bullet", version("pybullet"), "Zlib", "games"
SETTINGS = {
    "default": {"dt": 1 / 240, "residual": 1e-7, "anchor": 0},
    "steps of 1 ms, residual 0": {"dt": 1e-3, "residual": 0.0, "anchor": 0},
    "steps of 1 ms, residual 0, 150 iterations": {"dt": 1e-3, "residual": 0.0, "anchor": 0, "iterations": 150},
    "friction anchors, steps of 1 ms, residual 0": {"dt": 1e-3, "residual": 0.0, "anchor": 1},
}
FREE = {"linearDamping": 0.0, "angularDamping": 0.0, "maxJointVelocity": 1e4}  # the last one bounds spin, too
X_FROM_Z = (0.0, math.sqrt(0.5), 0.0, math.sqrt(0.5))  # x, y, z, w


def shape_of(shape):
    sizes, make = shape.sizes, bullet.createCollisionShape
    if shape.kind == "feet":
        kinds, radii, places = [bullet.GEOM_SPHERE] * len(sizes), [FOOT] * len(sizes), [(x, y, 0.0) for x, y in sizes]
        return bullet.createCollisionShapeArray(shapeTypes=kinds, radii=radii, collisionFramePositions=places)
    if shape.kind == "box":
        return make(bullet.GEOM_BOX, halfExtents=sizes)
    if shape.kind == "ball":
        return make(bullet.GEOM_SPHERE, radius=sizes[0])
    kind, turn = (bullet.GEOM_CAPSULE, X_FROM_Z) if shape.kind == "capsule" else (bullet.GEOM_CYLINDER, (0, 0, 0, 1))
    return make(kind, radius=sizes[0], height=2 * sizes[1], collisionFrameOrientation=turn)


class Simulator:
    def __init__(self, scene, setting, dt):
        if not bullet.isConnected():
            bullet.connect(bullet.DIRECT)
        bullet.resetSimulation()
        iterations = setting.get("iterations", 50)
        bullet.setPhysicsEngineParameter(fixedTimeStep=dt, solverResidualThreshold=setting["residual"], numSolverIterations=iterations)
        self.gravity(scene.gravity)
        self.dt, self.driven, self.bodies = dt, {}, []
        # Coefficients of both bodies are multiplied: that of torsion, too, with that of friction of the other one.
        root = scene.mu**0.5
        material = {"lateralFriction": root, "spinningFriction": 0.5 * scene.torsion / root}
        if scene.mu_across is not None:
            material["anisotropicFriction"] = (1.0, scene.mu_across / scene.mu, 1.0)
        if scene.has_floor:
            floor = bullet.createMultiBody(0.0, bullet.createCollisionShape(bullet.GEOM_PLANE))
            bullet.changeDynamics(floor, -1, lateralFriction=root, spinningFriction=material["spinningFriction"])
        for body in scene.bodies:
            mass, q = 0.0 if body.is_driven else body.mass, (*body.pose[1:], body.pose[0])
            made = bullet.createMultiBody(mass, shape_of(body.shape), -1, body.place, q, body.com)
            bullet.changeDynamics(made, -1, **material, **FREE, frictionAnchor=setting["anchor"])
            if not body.is_driven:
                bullet.changeDynamics(made, -1, localInertiaDiagonal=body.inertia)
            self.bodies.append(made)

    def set(self, body, velocity, spin):
        bullet.resetBaseVelocity(self.bodies[body], velocity, spin)
        if bullet.getDynamicsInfo(self.bodies[body], -1)[0] == 0.0:
            self.driven[body] = velocity, spin

    def step(self):
        bullet.stepSimulation()
        for body, (velocity, spin) in self.driven.items():  # they have velocity, but stay
            place, q = bullet.getBasePositionAndOrientation(self.bodies[body])
            rate = math.hypot(*spin)
            turn = bullet.getQuaternionFromAxisAngle(spin if rate else (0.0, 0.0, 1.0), rate * self.dt)
            moved = bullet.multiplyTransforms(sum_of(place, velocity, self.dt), turn, (0.0,) * 3, q)
            bullet.resetBasePositionAndOrientation(self.bodies[body], *moved)
            self.set(body, velocity, spin)

    def state(self, body):
        place, (x, y, z, w) = bullet.getBasePositionAndOrientation(self.bodies[body])
        return place, (w, x, y, z), *bullet.getBaseVelocity(self.bodies[body])

    def gravity(self, vector):
        bullet.setGravity(*vector)

    def force(self, body, vector):
        bullet.applyExternalForce(self.bodies[body], -1, vector, self.state(body)[0], bullet.WORLD_FRAME)
