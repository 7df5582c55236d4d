"""MuJoCo (pip install mujoco)."""

import mujoco

from ..scene import balls, inverse, of_centre, of_origin, rotated

NAME, VERSION, LICENCE, KIND = "MuJoCo", mujoco.__version__, "Apache-2.0", "mechanics"
NOSLIP = {"dt": 1e-3, "cone": "elliptic", "integrator": "implicitfast", "noslip_iterations": 10}
SETTINGS = {
    "default": {"dt": 2e-3},
    "elliptic": {"dt": 1e-3, "cone": "elliptic"},
    "elliptic, implicitfast, noslip": NOSLIP,
    "elliptic, implicitfast, noslip, solref 0.005": NOSLIP | {"solref": "0.005 1"},
    "elliptic, implicitfast, noslip, solref 0.005 2": NOSLIP | {"solref": "0.005 2"},
    "elliptic, implicitfast, noslip, solref 0.005 2, converged": NOSLIP | {"solref": "0.005 2", "tolerance": 1e-12, "iterations": 200},
    "elliptic, steps of 0.2 ms": {"dt": 2e-4, "cone": "elliptic"},
    "elliptic, stiff, noslip": {"dt": 2e-4, "cone": "elliptic", "impratio": 100, "noslip_iterations": 10, "solref": "0.0005 1"},
}
PLAIN = ("cone", "impratio", "noslip_iterations", "integrator", "tolerance", "iterations")


def geoms(shape, friction):
    if shape.kind in ("feet", "ball"):
        radius, places = balls(shape)
        return [f'<geom type="sphere" size="{radius}" pos="{x} {y} {z}" {friction}/>' for x, y, z in places]
    turn = 'euler="0 90 0"' if shape.kind == "capsule" else ""
    return [f'<geom type="{shape.kind}" size="{" ".join(map(str, shape.sizes))}" {turn} {friction}/>']


class Simulator:
    def __init__(self, scene, setting, dt):
        self.model = mujoco.MjModel.from_xml_string(self.text(scene, setting, dt))
        self.data = mujoco.MjData(self.model)
        self.com = [body.com for body in scene.bodies]

    def text(self, scene, setting, dt):
        condim = 4 if scene.torsion else 3
        friction = f'friction="{scene.mu} {scene.torsion} 0" condim="{condim}" mass="0" '
        if "solref" in setting:
            friction += f'solref="{setting["solref"]}"'
        parts = []
        for body in scene.bodies:
            parts.append(
                f'<body name="{body.name}" pos="{" ".join(map(str, body.place))}" quat="{" ".join(map(str, body.pose))}" '
                f'gravcomp="{int(body.is_driven)}"><freejoint/><inertial pos="{" ".join(map(str, body.com))}" mass="{body.mass}" '
                f'diaginertia="{" ".join(map(str, body.inertia))}"/>{"".join(geoms(body.shape, friction))}</body>'
            )
        floor = f'<geom name="floor" type="plane" size="99 99 0.1" {friction}/>' if scene.has_floor else ""
        pair = ""
        if scene.mu_across is not None:
            # The first tangent of a floor's contacts is along y.
            parts[0] = parts[0].replace("<geom ", '<geom name="box" ')
            pair = f'<contact><pair geom1="floor" geom2="box" condim="3" friction="{scene.mu_across} {scene.mu} 0 0 0"/></contact>'
        option = " ".join(f'{key}="{setting[key]}"' for key in PLAIN if key in setting)
        gravity = " ".join(map(str, scene.gravity))
        return f'<mujoco><option timestep="{dt}" gravity="{gravity}" {option}/><worldbody>{floor}{"".join(parts)}</worldbody>{pair}</mujoco>'

    def set(self, body, velocity, spin):
        q = self.data.qpos[7 * body + 3 : 7 * body + 7]
        # The joint has the velocity of the body's origin and the spin in the body's axes.
        self.data.qvel[6 * body : 6 * body + 3] = of_origin(q, velocity, spin, self.com[body])
        self.data.qvel[6 * body + 3 : 6 * body + 6] = rotated(inverse(q), spin)

    def step(self):
        before = self.data.time
        mujoco.mj_step(self.model, self.data)
        if self.data.time < before:  # it starts anew
            raise RuntimeError("the simulation diverges")

    def state(self, body):
        place, q = self.data.qpos[7 * body : 7 * body + 3], self.data.qpos[7 * body + 3 : 7 * body + 7]
        v = self.data.qvel[6 * body : 6 * body + 6]
        return of_centre(place, q, v[:3], rotated(q, v[3:]), self.com[body])

    def gravity(self, vector):
        self.model.opt.gravity[:] = vector

    def force(self, body, vector):
        self.data.xfrc_applied[body + 1, :3] = vector
