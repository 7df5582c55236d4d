#!/usr/bin/env python3
"""The scenes in MuJoCo (pip install mujoco), as CSV.

With engines/mujoco/build/libtribos_patch.so, or the library that TRIBOS_PATCH_PLUGIN names, its repair runs too.
"""

import math
import os
import sys
import time
from pathlib import Path

import numpy as np
from scenes import FOOT, MASS, SCENES, SETTLE, THROWN, creep, follow, print_results, roll

try:
    import mujoco
except ImportError:
    sys.exit("MuJoCo is not installed")

STEP = 0.001  # s
HERE = Path(__file__).resolve().parent
PLUGIN = Path(
    os.environ.get("TRIBOS_PATCH_PLUGIN", HERE.parent / "mujoco" / "build" / "libtribos_patch.so")
)
# Way -> cone, whether the plugin acts.
WAYS = {
    "elliptic cone": ("elliptic", False),
    "pyramidal cone": ("pyramidal", False),
    "plugin tribos.patch": ("elliptic", True),
}
PATCHES = {
    "puck": "disk",
    "spin_down": "disk",
    "tall": "disk",
    "ring": "ring",
    "box": "box",
    "plank": "box",
    "bar": "box",
}


def geoms(scene):
    """Name and XML of the body's shapes, about the place of the shape's middle."""
    if scene.feet:
        for i, (x, y) in enumerate(scene.feet):
            yield f"foot{i}", f'type="sphere" size="{FOOT}" pos="{x} {y} 0"'
    elif scene.name == "ball":
        yield "foot", f'type="sphere" size="{scene.radius}"'
    elif scene.half_sides:
        x, y = scene.half_sides
        yield "foot", f'type="box" size="{x} {y} {scene.half_height}"'
    else:
        yield "foot", f'type="cylinder" size="{scene.radius} {scene.half_height}"'


def patch(scene, geom):
    """The plugin's instance for a foot."""
    kind = "disk" if scene.feet else PATCHES[scene.name]
    size = f"{scene.radius}"
    if scene.feet:
        size = "1e-5"
    elif kind == "box":
        size = " ".join(map(str, scene.half_sides))
    keys = {"geom": geom, "ground": "floor", "patch": kind, "size": size, "mu": scene.mu}
    config = "".join(f'<config key="{key}" value="{value}"/>' for key, value in keys.items())
    return f'<instance name="{geom}">{config}</instance>'


def model(scene, cone, repaired):
    shapes = list(geoms(scene))
    middle = scene.radius if scene.name == "ball" else scene.half_height
    inertia = [0.4 * MASS * scene.radius**2] * 3 if scene.name == "ball" else scene.inertia
    low = 0.0 if scene.name == "ball" else scene.height - middle
    own = 'condim="1" priority="1"' if repaired else ""
    body = "".join(f'<geom name="{name}" mass="0" {own} {xml}/>' for name, xml in shapes)
    instances = "".join(patch(scene, name) for name, _ in shapes) if repaired else ""
    used = "".join(f'<plugin instance="{name}"/>' for name, _ in shapes) if repaired else ""
    extension = (
        f'<extension><plugin plugin="tribos.patch">{instances}</plugin></extension>'
        if repaired
        else ""
    )
    return mujoco.MjModel.from_xml_string(f"""
<mujoco>
  {extension}
  <option timestep="{STEP}" gravity="0 0 -{scene.gravity}" cone="{cone}"/>
  <default><geom friction="{scene.mu} 0 0"/></default>
  <worldbody>
    <geom name="floor" type="plane" size="99 99 0.1"/>
    <body pos="0 0 {middle}">
      <freejoint/>
      <inertial pos="0 0 {low}" mass="{MASS}" diaginertia="{" ".join(map(str, inertia))}"/>
      {used}{body}
    </body>
  </worldbody>
</mujoco>""")


class Simulator:
    dt = STEP

    def __init__(self, scene, cone, repaired):
        self.is_ball = scene.name == "ball"
        self.model = model(scene, cone, repaired)
        self.data = mujoco.MjData(self.model)
        mujoco.mj_step(self.model, self.data, nstep=round(SETTLE / STEP))

    def launch(self, speed, spin):
        self.data.qvel[:] = [speed, 0, 0, 0, spin, 0] if self.is_ball else [speed, 0, 0, 0, 0, spin]

    def step(self):
        mujoco.mj_step(self.model, self.data)

    def has_failed(self):
        """MuJoCo starts anew where a simulation diverges."""
        return any(warning.number for warning in self.data.warning[-3:])

    def pose(self):
        w, x, y, z = self.data.qpos[3:7]
        return *self.data.xipos[1][:2], math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))

    def motion(self):
        speed = float(np.hypot(*self.data.qvel[:2]))
        return speed, self.data.qvel[5]


def cost(scene, cone, repaired):
    """Least time of a step of a sliding puck, in µs."""
    least = math.inf
    for _ in range(20):
        simulator = Simulator(scene, cone, repaired)
        simulator.launch(1.0, 50.0)
        start = time.process_time()
        mujoco.mj_step(simulator.model, simulator.data, nstep=200)
        least = min(least, (time.process_time() - start) / 200)
    return 1e6 * least


def results():
    for way, (cone, repaired) in WAYS.items():
        if repaired:
            if not PLUGIN.exists():
                print("the plugin is not built: make -C engines/mujoco", file=sys.stderr)
                continue
            mujoco.mj_loadPluginLibrary(str(PLUGIN))
        rows = []
        for name in THROWN:
            scene = SCENES[name]
            for spin in scene.spins:
                rows += follow(scene, spin, Simulator(scene, cone, repaired))
        if not repaired:
            for spin in SCENES["ball"].spins:
                rows += roll(SCENES["ball"], spin, Simulator(SCENES["ball"], cone, False))
            rows += creep(lambda hold, grip, cone=cone: hold.in_mujoco(grip, (cone, 1, 0)))
        rows.append(["cost", "50", "step_us", f"{cost(SCENES['puck'], cone, repaired):.3g}"])
        yield way, repaired, rows


if __name__ == "__main__":
    # Simulations that diverge are counted, not logged.
    mujoco.set_mju_user_warning(lambda message: None)
    print_results(f"MuJoCo {mujoco.__version__}, Apache-2.0, steps of {1e3 * STEP:g} ms", results())
