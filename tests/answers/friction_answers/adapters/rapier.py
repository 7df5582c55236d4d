"""Rapier (pip install rapier3d), in single precision."""

import math
from importlib.metadata import version

import rapier3d as rapier

from ..scene import FOOT, Unsupported

NAME, VERSION, LICENCE, KIND = "Rapier", version("rapier3d"), "Apache-2.0", "games"
COULOMB = rapier.FrictionModel.COULOMB
# Contacts that are recycled lose a cylinder on a cylinder.
SETTINGS = {
    "default": {"dt": 1 / 60},
    "no recycling": {"dt": 1e-3, "contact_recycling": False},
    "coulomb, no recycling": {"dt": 1 / 240, "contact_recycling": False, "friction_model": COULOMB},
}


def colliders(shape):
    """Colliders of a shape, each with its place."""
    sizes, make = shape.sizes, rapier.Collider
    if shape.kind == "feet":
        return [make.ball(FOOT).translation((x, y, 0.0)) for x, y in sizes]
    if shape.kind == "box":
        return [make.cuboid(*sizes)]
    if shape.kind == "cylinder":
        return [make.cylinder(sizes[1], sizes[0]).rotation((0.5 * math.pi, 0.0, 0.0))]
    if shape.kind == "capsule":
        return [make.capsule_x(sizes[1], sizes[0])]
    return [make.ball(*sizes)]


class Simulator:
    def __init__(self, scene, setting, dt):
        if scene.torsion:
            raise Unsupported("Contacts have no torsional friction.")
        if scene.mu_across is not None:
            raise Unsupported("Friction is the same in all directions.")
        self.world = rapier.PhysicsWorld(gravity=scene.gravity)
        for key, value in {**setting, "dt": dt}.items():
            setattr(self.world.integration_parameters, key, value)
        if scene.has_floor:
            self.add(rapier.RigidBody.fixed(), [rapier.Collider.halfspace((0.0, 0.0, 1.0))], scene.mu)
        self.bodies = [self.build(body, scene.mu) for body in scene.bodies]

    def build(self, body, mu):
        made = rapier.RigidBody.kinematic_velocity_based() if body.is_driven else rapier.RigidBody.dynamic()
        made = made.position(rapier.Isometry3(body.place, rapier.Rotation3(*body.pose)))
        made = made.can_sleep(False).gyroscopic_forces(True).allow_fast_rotation(True)
        made = made.additional_mass_properties(rapier.MassProperties(body.com, body.mass, body.inertia))
        return self.add(made, colliders(body.shape), mu)

    def add(self, body, shapes, mu):
        """Friction is the mean of both coefficients."""
        handle = self.world.rigid_bodies.insert(body)
        for shape in shapes:
            shape = shape.density(0.0).friction(mu).restitution(0.0)
            self.world.colliders.insert_with_parent(shape, handle, self.world.rigid_bodies)
        body = self.world.rigid_bodies[handle]
        body.recompute_mass_properties_from_colliders(self.world.colliders)
        return body

    def set(self, body, velocity, spin):
        self.bodies[body].linvel, self.bodies[body].angvel = velocity, spin

    def step(self):
        self.world.step()

    def state(self, body):
        body = self.bodies[body]
        q = body.rotation
        return tuple(body.center_of_mass), (q.w, q.i, q.j, q.k), tuple(body.linvel), tuple(body.angvel)

    def gravity(self, vector):
        self.world.gravity = vector

    def force(self, body, vector):
        self.bodies[body].reset_forces()
        self.bodies[body].add_force(vector)
