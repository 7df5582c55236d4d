"""Genesis, its rigid solver on the CPU, in single precision (pip install genesis-world torch)."""

import genesis

from ..scene import Unsupported, cross, rotated, sum_of
from .mujoco import geoms

genesis.init(backend=genesis.cpu, logging_level="error")
IS_FOR_GPUS = True
NAME, VERSION, LICENCE = "Genesis", genesis.__version__, "Apache-2.0"
SETTINGS = {
    "default": {"dt": 1e-2},
    "signorini": {"dt": 2e-3, "friction_cone": genesis.friction_cone.elliptic},
}


class Simulator:
    def __init__(self, scene, setting, dt):
        if scene.mu_across is not None:
            raise Unsupported("A geometry has one coefficient of friction for all directions.")
        options = {key: value for key, value in setting.items() if key != "dt"}
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
        self.driven = {i: ((0.0,) * 3,) * 2 for i, body in enumerate(scene.bodies) if body.is_driven}

    def set(self, body, velocity, spin):
        if body in self.driven:
            self.driven[body] = velocity, spin
        _, _, arm = self.frame(body)
        self.bodies[body].set_dofs_velocity((*sum_of(velocity, cross(spin, arm), -1.0), *spin))

    def frame(self, body):
        place, q = self.bodies[body].get_pos().tolist(), tuple(self.bodies[body].get_quat().tolist())
        return place, q, rotated(q, self.com[body])

    def step(self):
        for body, motion in self.driven.items():
            self.set(body, *motion)
        for body, vector in self.forces.items():
            self.bodies[body].base_link.apply_external_force(vector, ref=genesis.link_ref_frame.link_COM)
        self.scene.step()

    def state(self, body):
        place, q, arm = self.frame(body)
        spin = tuple(self.bodies[body].get_ang().tolist())
        return sum_of(place, arm), q, sum_of(self.bodies[body].get_vel().tolist(), cross(spin, arm)), spin

    def gravity(self, vector):
        self.scene.sim.set_gravity(vector)

    def force(self, body, vector):
        self.forces[body] = vector
