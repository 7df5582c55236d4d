"""Brax with its pipelines spring, positional and generalized, on the CPU, in single precision (pip install brax)."""

import importlib
import tempfile
from pathlib import Path

import brax
import jax
import numpy
from brax.io import mjcf

from ..scene import Unsupported
from . import mujoco

# A scene takes longer to compile than to run.
jax.config.update("jax_compilation_cache_dir", str(Path(tempfile.gettempdir()) / "friction_answers_jax"))
jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.5)
NAME, VERSION, LICENCE, KIND = "Brax", brax.__version__, "Apache-2.0", "gpu"
SETTINGS = {
    "default": {"dt": 5e-3, "pipeline": "generalized"},
    "generalized, small steps": {"dt": 1e-3, "pipeline": "generalized"},
    "spring": {"dt": 5e-3, "pipeline": "spring"},
    "positional": {"dt": 5e-3, "pipeline": "positional"},
}
PIPELINES = {name: importlib.import_module(f"brax.{name}.pipeline") for name in ("generalized", "spring", "positional")}
STEPS = {name: jax.jit(pipeline.step) for name, pipeline in PIPELINES.items()}
STARTS = {name: jax.jit(pipeline.init) for name, pipeline in PIPELINES.items()}


class Simulator(mujoco.Simulator):
    force = None  # but for its motors Brax has no forces from outside

    def __init__(self, scene, setting, dt):
        super().__init__(scene, setting, dt)
        if any(body.is_driven for body in scene.bodies):
            raise Unsupported("Brax has no kinematic bodies.")
        if "force" in scene.needs:
            raise Unsupported("Brax has no forces from outside but those of its motors.")
        if scene.torsion or scene.mu_across is not None:
            raise Unsupported("Brax has neither torsional friction nor a coefficient for each direction.")
        try:
            mjcf.validate_model(self.model)
        except NotImplementedError as error:
            raise Unsupported(f"Brax: {error}") from error
        self.system = mjcf.load_model(self.model)
        self.start, self.advance = STARTS[setting["pipeline"]], STEPS[setting["pipeline"]]
        self.running = None

    def set(self, body, velocity, spin):
        super().set(body, velocity, spin)
        self.running = None

    def step(self):
        if self.running is None:
            self.running = self.start(self.system, self.data.qpos, self.data.qvel)
        self.running = self.advance(self.system, self.running, numpy.zeros(0))  # no motors
        self.data.qpos[:], self.data.qvel[:] = self.running.q, self.running.qd

    def gravity(self, vector):
        self.system = self.system.replace(gravity=numpy.array(vector))
