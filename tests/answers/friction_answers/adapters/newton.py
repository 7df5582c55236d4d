"""Newton on the CPU, in single precision (pip install newton mujoco mujoco-warp)."""

import warp

warp.config.enable_backward, warp.config.log_level = False, warp.LOG_WARNING  # halves the time to compile
import newton  # noqa: E402

from ..scene import FOOT, Unsupported, rotated, sum_of  # noqa: E402

NAME, VERSION, LICENCE, KIND = "Newton", newton.__version__, "Apache-2.0", "gpu"
SPARSE = newton.solvers.SolverKamino.Config(dynamics_solver="dvi", sparse_dynamics=True, sparse_jacobian=True)
SETTINGS = {
    "default": {"dt": 1 / 600, "solver": "XPBD"},
    "small steps": {"dt": 1 / 2400, "solver": "XPBD", "iterations": 20},
    "VBD": {"dt": 1 / 600, "solver": "VBD"},
    "VBD, small steps": {"dt": 1 / 2400, "solver": "VBD", "friction_epsilon": 1e-4},
    "VBD, stiff contacts": {"dt": 1 / 2400, "solver": "VBD", "friction_epsilon": 1e-4, "shape": {"ke": 1e6, "kd": 0.0}},
    "Kamino": {"dt": 1 / 600, "solver": "Kamino"},
    "MuJoCo": {"dt": 1 / 600, "solver": "MuJoCo"},
    "MuJoCo, elliptic": {"dt": 1 / 600, "solver": "MuJoCo", "cone": "elliptic", "impratio": 100.0},
    "Steel": {"dt": 1 / 600, "solver": "Steel"},
    "SemiImplicit": {"dt": 1 / 2400, "solver": "SemiImplicit", "angular_damping": 0.0},
    "SemiImplicit, stiff": {"dt": 1 / 2400, "solver": "SemiImplicit", "angular_damping": 0.0, "shape": {"ke": 1e5, "kd": 200.0, "kf": 1e4}},
    "Featherstone": {"dt": 1 / 2400, "solver": "Featherstone", "angular_damping": 0.0},
}
for one in SETTINGS.values():
    one["engine"] = f"Newton {one['solver']}"
TYPES = {"ball": "SPHERE", "feet": "SPHERE", "box": "BOX", "cylinder": "CYLINDER", "capsule": "CAPSULE"}


class Simulator:
    def __init__(self, scene, setting, dt):
        solver, options = setting["solver"], {key: setting[key] for key in setting if key not in ("dt", "solver", "engine", "shape")}
        if solver == "Kamino":
            options["config"] = SPARSE
        make = getattr(newton.solvers, f"Solver{solver}")
        if scene.mu_across is not None or (scene.torsion and solver not in ("XPBD", "MuJoCo")):
            raise Unsupported("Newton has one coefficient for all directions, and torsion only in XPBD and MuJoCo.")
        builder = newton.ModelBuilder(gravity=scene.gravity)
        make.register_custom_attributes(builder)
        vars(builder.default_shape_cfg).update(mu=scene.mu, mu_torsional=scene.torsion, mu_rolling=0.0, **setting.get("shape", {}))
        more = {"mujoco:condim": 4} if scene.torsion and solver == "MuJoCo" else {}
        if scene.has_floor:
            builder.add_ground_plane()
        for i, body in enumerate(scene.bodies):
            given = {"mass": body.mass, "com": body.com, "inertia": warp.diag(warp.vec3(body.inertia))}
            pose = warp.transform(body.place, (*body.pose[1:], body.pose[0]))
            builder.add_body(xform=pose, is_kinematic=body.is_driven, lock_inertia=True, **given)
            kind, sizes, geo = body.shape.kind, body.shape.sizes, newton.GeoType[TYPES[body.shape.kind]]
            for x, y in sizes if kind == "feet" else ((0.0, 0.0),):
                place = warp.transform((x, y, 0.0), warp.quat_rpy(0.0, 0.5 * warp.pi * (kind == "capsule"), 0.0))
                size = (FOOT, 0.0, 0.0) if kind == "feet" else (*sizes, 0.0, 0.0)[:3]
                builder.add_shape(body=i, type=geo, scale=size, xform=place, custom_attributes=more)
        builder.color()
        self.model, self.dt, self.bodies, self.driven = builder.finalize(device="cpu"), dt, scene.bodies, {}
        self.solver, self.control = make(self.model, **options), self.model.control()
        self.states, self.contacts, self.graphs = [self.model.state(), self.model.state()], self.model.contacts(), []
        for old, new in (self.states, self.states[::-1]):  # recorded steps run many times as fast
            with warp.ScopedCapture(device="cpu") as capture:
                self.model.collide(old, self.contacts)
                self.solver.step(old, new, self.control, self.contacts, dt)
            self.graphs.append(capture.graph)

    def set(self, body, velocity, spin):
        if self.bodies[body].is_driven:
            self.driven[body] = velocity, spin
        for speeds in (self.states[0].body_qd, self.states[0].joint_qd):  # both of the centre of mass
            speeds.numpy().reshape(-1, 6)[body] = (*velocity, *spin)

    def step(self):
        warp.capture_launch(self.graphs[0])
        self.graphs, self.states = self.graphs[::-1], self.states[::-1]
        self.states[0].clear_forces()
        for body, (velocity, spin) in self.driven.items():  # Newton leaves it to its user to move them
            self.set(body, velocity, spin)
            q, turn = self.states[0].body_q.numpy()[body], warp.quat_rpy(0.0, 0.0, spin[2] * self.dt)
            q[:] = (*sum_of(q[:3], velocity, self.dt), *(turn * warp.quat(q[3:])))
            self.states[0].joint_q.numpy()[7 * body : 7 * body + 7] = q

    def state(self, body):
        *place, x, y, z, w = self.states[0].body_q.numpy()[body].tolist()
        v = tuple(self.states[0].body_qd.numpy()[body].tolist())
        return sum_of(place, rotated((w, x, y, z), self.bodies[body].com)), (w, x, y, z), v[:3], v[3:]

    def gravity(self, vector):
        self.model.set_gravity(vector)
        self.solver.notify_model_changed(newton.ModelFlags.MODEL_PROPERTIES)

    def force(self, body, vector):
        self.states[0].body_f.numpy()[body, :3] = vector
