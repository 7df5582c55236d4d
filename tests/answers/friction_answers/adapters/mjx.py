"""MJX, MuJoCo in JAX, on the CPU, in single precision (pip install mujoco-mjx)."""

import tempfile
from importlib.metadata import version
from pathlib import Path

import jax
from mujoco import mjx

from ..scene import Unsupported
from . import mujoco

# A scene takes longer to compile than to run.
jax.config.update("jax_compilation_cache_dir", str(Path(tempfile.gettempdir()) / "friction_answers_jax"))
jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.5)
NAME, VERSION, LICENCE, KIND = "MJX", version("mujoco-mjx"), "Apache-2.0", "gpu"
SETTINGS = {
    "default": {"dt": 2e-3},
    "elliptic": {"dt": 1e-3, "cone": "elliptic"},
    "elliptic, stiff": {"dt": 1e-3, "cone": "elliptic", "impratio": 100, "solref": "0.002 1"},
}


@jax.jit
def step(model, data, gravity, qpos, qvel, force):
    model = model.replace(opt=model.opt.replace(gravity=gravity))
    return mjx.step(model, data.replace(qpos=qpos, qvel=qvel, xfrc_applied=force))


class Simulator(mujoco.Simulator):
    def __init__(self, scene, setting, dt):
        super().__init__(scene, setting, dt)
        try:
            self.jax_model = mjx.put_model(self.model, impl="jax")
        except NotImplementedError as error:
            raise Unsupported(f"MJX: {error}") from error
        self.jax_data = mjx.put_data(self.model, self.data, impl="jax")

    def step(self):
        data = self.data
        now = data.qpos, data.qvel, data.xfrc_applied
        self.jax_data = step(self.jax_model, self.jax_data, self.model.opt.gravity, *now)
        data.qpos[:], data.qvel[:] = self.jax_data.qpos, self.jax_data.qvel
