"""Bullet: a box that spins on a plane stops after half of its angle, at any step, since four corners carry it."""

import pybullet as bullet

MU, G, HALF, SPIN = 0.3, 9.81, 0.05, 12.5
# Torque of a square face under uniform pressure: mu m g times the mean distance of its elements from the middle.
EXACT = SPIN**2 / (2 * MU * G * 0.765196 * HALF / (2 * HALF**2 / 3))


def turned(dt):
    bullet.connect(bullet.DIRECT)
    bullet.setGravity(0, 0, -G)
    bullet.setPhysicsEngineParameter(fixedTimeStep=dt, solverResidualThreshold=0.0)
    floor = bullet.createMultiBody(0, bullet.createCollisionShape(bullet.GEOM_PLANE))
    shape = bullet.createCollisionShape(bullet.GEOM_BOX, halfExtents=[HALF, HALF, 0.01])
    box = bullet.createMultiBody(1.0, shape, basePosition=[0, 0, 0.01])
    bullet.changeDynamics(floor, -1, lateralFriction=1.0)
    bullet.changeDynamics(box, -1, lateralFriction=MU, linearDamping=0, angularDamping=0)
    for _ in range(round(0.5 / dt)):
        bullet.stepSimulation()
    bullet.resetBaseVelocity(box, [0, 0, 0], [0, 0, SPIN])
    angle = 0.0
    for _ in range(round(0.5 / dt)):
        bullet.stepSimulation()
        angle += bullet.getBaseVelocity(box)[1][2] * dt
    bullet.disconnect()
    return angle


print(f"exact: {EXACT:.4f} rad")
for dt in (1 / 240, 1e-3, 1e-4):
    print(f"steps of {dt:.2g} s: {turned(dt):.4f} rad")
