"""MuJoCo Warp on the CPU, in single precision (pip install mujoco-warp)."""

from importlib.metadata import version
from types import SimpleNamespace

import warp

warp.config.log_level = warp.LOG_WARNING

import mujoco_warp  # noqa: E402

from . import mujoco  # noqa: E402

warp.set_device("cpu")
NAME, VERSION, LICENCE, KIND = "MuJoCo Warp", version("mujoco-warp"), "Apache-2.0", "gpu"
SETTINGS = {
    "default": {"dt": 2e-3},
    "elliptic": {"dt": 1e-3, "cone": "elliptic"},
    "elliptic, stiff": {"dt": 1e-3, "cone": "elliptic", "impratio": 100, "solref": "0.002 1"},
    "noslip": {"dt": 1e-3, "cone": "elliptic", "integrator": "implicitfast", "noslip_iterations": 10},
}
KEYS = ("qpos", "qvel", "xfrc_applied")


class Simulator(mujoco.Simulator):
    def __init__(self, scene, setting, dt):
        super().__init__(scene, setting, dt)
        self.warp_model = mujoco_warp.put_model(self.model)
        self.warp_data = mujoco_warp.put_data(self.model, self.data, nconmax=64, njmax=512)
        # Views of the arrays of the first and only world.
        self.data = SimpleNamespace(**{key: getattr(self.warp_data, key).numpy()[0] for key in KEYS})
        with warp.ScopedCapture() as capture:  # a recorded step runs many times as fast
            mujoco_warp.step(self.warp_model, self.warp_data)
        self.graph = capture.graph

    def step(self):
        warp.capture_launch(self.graph)

    def state(self, body):
        return tuple(tuple(map(float, part)) for part in super().state(body))

    def gravity(self, vector):
        self.warp_model.opt.gravity.numpy()[0] = vector
