"""PhysX by SAPIEN 3.0.3: a box that spins on a plane stops after half of its angle, with any number of iterations, since four corners carry it."""

import math

import sapien
from sapien import Pose, physx

MU, G, HALF, SPIN = 0.3, 9.81, 0.05, 12.5
# Torque of a square face under uniform pressure: mu m g times the mean distance of its elements from the middle.
EXACT = SPIN**2 / (2 * MU * G * 0.765196 * HALF / (2 * HALF**2 / 3))


def turned(dt, iterations):
    physx.set_scene_config(gravity=(0.0, 0.0, -G))
    system = physx.PhysxCpuSystem()
    system.timestep = dt
    scene, material, made = sapien.Scene([system]), physx.PhysxMaterial(MU, MU, 0.0), []
    plane = physx.PhysxCollisionShapePlane(material), Pose(q=(math.sqrt(0.5), 0.0, -math.sqrt(0.5), 0.0)), physx.PhysxRigidStaticComponent(), Pose()
    box = physx.PhysxCollisionShapeBox((HALF, HALF, 0.01), material), Pose(), physx.PhysxRigidDynamicComponent(), Pose((0.0, 0.0, 0.01))
    for shape, shape.local_pose, component, place in (plane, box):
        component.attach(shape)
        entity = sapien.Entity().add_component(component)
        entity.pose = place
        scene.add_entity(entity)
        made.append(component)
    body = made[1]
    body.linear_damping = body.angular_damping = body.sleep_threshold = 0.0
    body.solver_position_iterations = iterations
    for _ in range(round(0.5 / dt)):
        system.step()
    body.angular_velocity = (0.0, 0.0, SPIN)
    angle = 0.0
    for _ in range(round(0.5 / dt)):
        system.step()
        angle += body.angular_velocity[2] * dt
    return angle


print(f"exact: {EXACT:.4f} rad")
for dt, iterations in ((1e-2, 10), (1e-3, 10), (1e-3, 100)):
    print(f"steps of {dt:g} s, {iterations} iterations: {turned(dt, iterations):.4f} rad")
