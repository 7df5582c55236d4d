"""Genesis, its rigid solver on the CPU, in single precision (pip install genesis-world torch)."""

import genesis

from ..scene import Unsupported, inverse, of_centre, of_origin, rotated
from .mujoco import geoms

genesis.init(backend=genesis.cpu, logging_level="error")
NAME, VERSION, LICENCE, KIND = "Genesis", genesis.__version__, "Apache-2.0", "gpu"
SETTINGS = {
    "default": {"dt": 1e-2},
    "signorini": {"dt": 2e-3, "friction_cone": "elliptic"},
}


class Simulator:
    def __init__(self, scene, setting, dt):
        if scene.mu_across is not None:
            raise Unsupported("A geometry has one coefficient of friction for all directions.")
        options = {"friction_cone": getattr(genesis.friction_cone, setting["friction_cone"])} if "friction_cone" in setting else {}
        self.scene = genesis.Scene(
            sim_options=genesis.options.SimOptions(dt=dt, gravity=scene.gravity),
            rigid_options=genesis.options.RigidOptions(enable_torsional_friction=bool(scene.torsion), **options),
            show_viewer=False,
        )
        material = {"friction": scene.mu, "friction_torsional": scene.torsion}
        if scene.has_floor:
            self.scene.add_entity(genesis.morphs.Plane(), genesis.materials.Rigid(**material))
        self.bodies = []
        for body in scene.bodies:
            numbers = {key: " ".join(map(str, getattr(body, key))) for key in ("place", "pose", "com", "inertia")}
            text = (
                f'<mujoco><worldbody><body name="{body.name}" pos="{numbers["place"]}" quat="{numbers["pose"]}">'
                f'<freejoint/><inertial pos="{numbers["com"]}" mass="{body.mass}" diaginertia="{numbers["inertia"]}"/>'
                f"{''.join(geoms(body.shape, ''))}</body></worldbody></mujoco>"
            )
            still = {"gravity_compensation": 1.0} if body.is_driven else {}
            morph = genesis.morphs.MJCF(file=text, default_armature=None)
            self.bodies.append(self.scene.add_entity(morph, genesis.materials.Rigid(**material, **still)))
        self.scene.build()
        self.com, self.forces = [body.com for body in scene.bodies], {}

    def set(self, body, velocity, spin):
        q = tuple(self.bodies[body].get_quat().tolist())
        # The joint has the velocity of the body's origin and the spin in the body's axes.
        self.bodies[body].set_dofs_velocity((*of_origin(q, velocity, spin, self.com[body]), *rotated(inverse(q), spin)))

    def step(self):
        for body, vector in self.forces.items():
            self.bodies[body].base_link.apply_external_force(vector, ref=genesis.link_ref_frame.link_COM)
        self.scene.step()

    def state(self, body):
        made = self.bodies[body]
        parts = (made.get_pos(), made.get_quat(), made.get_vel(), made.get_ang())
        return of_centre(*(tuple(part.tolist()) for part in parts), self.com[body])

    def gravity(self, vector):
        self.scene.sim.set_gravity(vector)

    def force(self, body, vector):
        self.forces[body] = vector
