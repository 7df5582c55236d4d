#!/usr/bin/env python3
"""The scenes in Bullet (pip install pybullet), as CSV."""

import math
import sys
import time
from importlib.metadata import version

from scenes import FOOT, MASS, SCENES, SETTLE, THROWN, follow, print_results, roll

try:
    import pybullet as bullet
except ImportError:
    sys.exit("pybullet is not installed")

STEP = 1 / 240  # s


def shape(scene):
    if scene.name == "ball":
        return bullet.createCollisionShape(bullet.GEOM_SPHERE, radius=scene.radius)
    if scene.half_sides:
        return bullet.createCollisionShape(
            bullet.GEOM_BOX, halfExtents=[*scene.half_sides, scene.half_height]
        )
    if scene.feet:
        return bullet.createCollisionShapeArray(
            shapeTypes=[bullet.GEOM_SPHERE] * 3,
            radii=[FOOT] * 3,
            collisionFramePositions=[[x, y, 0.0] for x, y in scene.feet],
        )
    return bullet.createCollisionShape(
        bullet.GEOM_CYLINDER, radius=scene.radius, height=2 * scene.half_height
    )


class Simulator:
    dt = STEP

    def __init__(self, scene):
        self.is_ball = scene.name == "ball"
        bullet.resetSimulation()
        bullet.setGravity(0, 0, -scene.gravity)
        bullet.setTimeStep(STEP)
        floor = bullet.createMultiBody(0, bullet.createCollisionShape(bullet.GEOM_PLANE))
        middle = scene.radius if self.is_ball else scene.half_height
        low = 0.0 if self.is_ball else scene.height - middle
        self.body = bullet.createMultiBody(
            MASS,
            shape(scene),
            basePosition=[0, 0, middle + low],
            baseInertialFramePosition=[0, 0, low],
        )
        # Coefficients multiply.
        bullet.changeDynamics(floor, -1, lateralFriction=1)
        inertia = [0.4 * MASS * scene.radius**2] * 3 if self.is_ball else scene.inertia
        bullet.changeDynamics(
            self.body,
            -1,
            lateralFriction=scene.mu,
            spinningFriction=0,
            rollingFriction=0,
            linearDamping=0,
            angularDamping=0,
            localInertiaDiagonal=inertia,
        )
        for _ in range(round(SETTLE / STEP)):
            bullet.stepSimulation()

    def launch(self, speed, spin):
        turn = [0, spin, 0] if self.is_ball else [0, 0, spin]
        bullet.resetBaseVelocity(self.body, [speed, 0, 0], turn)

    def step(self):
        bullet.stepSimulation()

    def pose(self):
        (x, y, _), turn = bullet.getBasePositionAndOrientation(self.body)
        return x, y, bullet.getEulerFromQuaternion(turn)[2]

    def motion(self):
        (x, y, _), (_, _, spin) = bullet.getBaseVelocity(self.body)
        return math.hypot(x, y), spin


def cost(scene):
    """Least time of a step of a sliding puck, in µs."""
    least = math.inf
    for _ in range(20):
        simulator = Simulator(scene)
        simulator.launch(1.0, 50.0)
        start = time.process_time()
        for _ in range(40):
            bullet.stepSimulation()
        least = min(least, (time.process_time() - start) / 40)
    return 1e6 * least


def results():
    rows = []
    for name in THROWN:
        for spin in SCENES[name].spins:
            rows += follow(SCENES[name], spin, Simulator(SCENES[name]))
    for spin in SCENES["ball"].spins:
        rows += roll(SCENES["ball"], spin, Simulator(SCENES["ball"]))
    rows.append(["cost", "50", "step_us", f"{cost(SCENES['puck']):.3g}"])
    yield "as it is", False, rows


if __name__ == "__main__":
    bullet.connect(bullet.DIRECT)
    print_results(f"Bullet (pybullet {version('pybullet')}), zlib, steps of 1/240 s", results())
