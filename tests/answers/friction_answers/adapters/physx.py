"""PhysX 5 as SAPIEN has it, on the CPU (pip install sapien), in single precision."""

import math

import sapien
from sapien import Pose, physx

from ..scene import FOOT, Unsupported, sum_of

NAME, VERSION, LICENCE, KIND = "PhysX (SAPIEN)", sapien.__version__, "BSD-3-Clause, SAPIEN MIT", "games"
SETTINGS = {"default": {"dt": 1e-2}, "steps of 1/240 s": {"dt": 1 / 240}, "steps of 1 ms": {"dt": 1e-3}}
SETTINGS |= {"steps of 2 ms, no velocity iterations": {"dt": 2e-3, "solver_velocity_iterations": 0}}
UPRIGHT = Pose(q=(math.sqrt(0.5), 0.0, -math.sqrt(0.5), 0.0))  # planes and cylinders are about x


def shapes(shape, material):
    """Shapes of a body, each with its place. A cylinder is a prism of about 32 sides."""
    if shape.kind == "feet":
        return [(physx.PhysxCollisionShapeSphere(FOOT, material), Pose([x, y, 0.0])) for x, y in shape.sizes]
    kind = "Sphere" if shape.kind == "ball" else shape.kind.capitalize()
    made = getattr(physx, f"PhysxCollisionShape{kind}")(*([shape.sizes] if kind == "Box" else shape.sizes), material)
    return [(made, UPRIGHT if shape.kind == "cylinder" else Pose())]


class Simulator:
    def __init__(self, scene, setting, dt):
        if scene.mu_across is not None:
            raise Unsupported("Friction is the same in all directions.")
        # A scene keeps its gravity for good: each body is accelerated at each step instead.
        physx.set_scene_config(gravity=(0.0,) * 3)
        self.system, self.driven, self.pull = physx.PhysxCpuSystem(), {}, scene.gravity
        self.dt = self.system.timestep = dt
        self.scene = sapien.Scene([self.system])
        material = physx.PhysxMaterial(scene.mu, scene.mu, 0.0)
        if scene.has_floor:
            self.add([(physx.PhysxCollisionShapePlane(material), UPRIGHT)], Pose(), physx.PhysxRigidStaticComponent())
        self.bodies = []
        for body in scene.bodies:
            place = Pose(body.place, body.pose)
            made = self.add(shapes(body.shape, material), place, physx.PhysxRigidDynamicComponent())
            for shape in made.collision_shapes:
                shape.min_patch_radius = scene.torsion / scene.mu
            made.mass, made.inertia, made.cmass_local_pose = body.mass, body.inertia, Pose(body.com)
            made.linear_damping = made.angular_damping = made.sleep_threshold = 0.0
            made.solver_velocity_iterations = setting.get("solver_velocity_iterations", 1)
            made.max_angular_velocity, made.kinematic = 1e4, body.is_driven
            self.bodies.append(made)

    def add(self, parts, place, component):
        for shape, shape.local_pose in parts:
            component.attach(shape)
        entity = sapien.Entity().add_component(component)
        entity.pose = place
        self.scene.add_entity(entity)
        return component

    def set(self, body, velocity, spin):
        if self.bodies[body].kinematic:
            self.driven[body] = velocity, spin
        else:
            self.bodies[body].linear_velocity, self.bodies[body].angular_velocity = velocity, spin

    def step(self):
        for body, (velocity, spin) in self.driven.items():
            place, rate = self.bodies[body].entity_pose, math.hypot(*spin)
            sin, cos = math.sin(0.5 * rate * self.dt), math.cos(0.5 * rate * self.dt)
            turn = Pose(q=(cos, *(sin * w / (rate or 1.0) for w in spin)))
            self.bodies[body].set_kinematic_target(Pose(sum_of(place.p, velocity, self.dt), (turn * place).q))
        for body in (body for body in self.bodies if not body.kinematic):
            body.add_force_torque(self.pull, (0.0,) * 3, "acceleration")
        self.system.step()

    def state(self, body):
        made = self.bodies[body]
        at = made.entity_pose * made.cmass_local_pose
        return tuple(tuple(map(float, part)) for part in (at.p, at.q, made.linear_velocity, made.angular_velocity))

    def gravity(self, vector):
        self.pull = vector

    def force(self, body, vector):
        self.bodies[body].add_force_torque(vector, (0.0,) * 3)
