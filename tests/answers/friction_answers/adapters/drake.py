"""Drake (pip install drake)."""

from importlib.metadata import version

import pydrake.all as drake

from ..scene import of_centre, of_origin, parts, refuse, sum_of

NAME, VERSION, LICENCE, KIND = "Drake", version("drake"), "BSD-3-Clause", "mechanics"
LACKS = {"torsion": "Points have no torsional friction.", "anisotropic": "Friction is the same in all directions."}
FINE = {"contact_surface_representation": "triangle", "stiction_tolerance": 1e-6}
SETTINGS = {
    "points (default)": {"dt": 1e-3, "config": {}},
    "hydroelastic faces": {"dt": 1e-3, "config": FINE, "modulus": 1e8, "hint": 0.01},
    "hydroelastic faces, finer": {"dt": 1e-3, "config": FINE, "modulus": 1e8, "hint": 0.004},
}


def place_of(origin, q):
    return drake.RigidTransform(drake.Quaternion(*q), origin)


SHAPES = {
    "ball": drake.Sphere,
    "box": lambda *half: drake.Box(*(2 * size for size in half)),
    "cylinder": lambda radius, half: drake.Cylinder(radius, 2 * half),
    "capsule": lambda radius, half: drake.Capsule(radius, 2 * half),
}


class Simulator:
    def __init__(self, scene, setting, dt):
        refuse(scene, LACKS)
        self.scene, self.dt, self.steps, self.bodies, self.planes, self.forces = scene, dt, 0, [], {}, {}
        builder = drake.DiagramBuilder()
        config = drake.MultibodyPlantConfig(time_step=dt, **setting["config"])
        self.plant, _ = drake.AddMultibodyPlant(config, builder)
        self.plant.mutable_gravity_field().set_gravity_vector(scene.gravity)
        if scene.has_floor:
            self.attach(self.plant.world_body(), [(drake.HalfSpace(), (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))], setting, True)
        for body in scene.bodies:
            group = self.plant.AddModelInstance(body.name)
            inertia = drake.SpatialInertia.MakeFromCentralInertia(body.mass, body.com, drake.RotationalInertia(*body.inertia))
            made = self.plant.AddRigidBody(body.name, group, inertia)
            self.attach(made, parts(body.shape, **SHAPES), setting, body.is_driven)
            self.plant.set_gravity_enabled(group, not body.is_driven)
            at = place_of(body.place, body.pose)
            if body.is_driven:  # in its plane, or it sinks and tilts by more than faces press in
                frame = self.plant.AddFrame(drake.FixedOffsetFrame(body.name, self.plant.world_frame(), at))
                self.planes[len(self.bodies)] = self.plant.AddJoint(drake.PlanarJoint(body.name, frame, made.body_frame(), (0.0,) * 3))
            else:
                self.plant.SetDefaultFloatingBaseBodyPose(made, at)
            self.bodies.append(made)
        self.plant.Finalize()
        self.clock = drake.Simulator(builder.Build())
        self.context = self.plant.GetMyMutableContextFromRoot(self.clock.get_mutable_context())

    def attach(self, body, shapes, setting, is_hard):
        for i, (shape, place, q) in enumerate(shapes):
            made, mu = drake.ProximityProperties(), self.scene.mu
            drake.AddContactMaterial(friction=drake.CoulombFriction(mu, mu), properties=made)
            has_face = "modulus" in setting and not isinstance(shape, drake.Sphere)
            if has_face and is_hard:
                drake.AddRigidHydroelasticProperties(0.5, made)
            elif has_face:
                drake.AddCompliantHydroelasticProperties(setting["hint"], setting["modulus"], made)
            self.plant.RegisterCollisionGeometry(body, place_of(place, q), shape, f"{body.name()}{i}", made)

    def set(self, body, velocity, spin):
        if body in self.planes:
            self.planes[body].set_translational_velocity(self.context, velocity[:2])
            return self.planes[body].set_angular_velocity(self.context, spin[2])
        motion = drake.SpatialVelocity(spin, of_origin(self.state(body)[1], velocity, spin, self.scene.bodies[body].com))
        self.plant.SetFreeBodySpatialVelocity(self.context, self.bodies[body], motion)

    def step(self):
        self.steps += 1
        self.clock.AdvanceTo((self.steps - 0.5) * self.dt)  # its updates are at whole steps

    def state(self, body):
        pose = self.plant.EvalBodyPoseInWorld(self.context, self.bodies[body])
        motion = self.plant.EvalBodySpatialVelocityInWorld(self.context, self.bodies[body])
        found = pose.translation(), pose.rotation().ToQuaternion().wxyz(), motion.translational(), motion.rotational()
        return of_centre(*(tuple(map(float, part)) for part in found), self.scene.bodies[body].com)

    def gravity(self, vector):
        """A finished model keeps its gravity: what differs is a force."""
        change = sum_of(vector, self.scene.gravity, -1.0)
        for i, body in enumerate(self.scene.bodies):
            self.force(i, tuple(body.mass * g for g in change))

    def force(self, body, vector):
        made = self.forces.setdefault(body, drake.ExternallyAppliedSpatialForce())
        made.body_index, made.p_BoBq_B = self.bodies[body].index(), self.scene.bodies[body].com
        made.F_Bq_W = drake.SpatialForce((0.0,) * 3, vector)
        self.plant.get_applied_spatial_force_input_port().FixValue(self.context, list(self.forces.values()))
