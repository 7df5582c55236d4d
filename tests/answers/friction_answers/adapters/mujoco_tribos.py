"""MuJoCo with the plugin tribos.patch, which bears faces as areas (make -C engines/mujoco; TRIBOS_PATCH names the library)."""

import os
from pathlib import Path

import mujoco

from ..scene import refuse
from . import mujoco as plain

NAME, VERSION, LICENCE, KIND = "MuJoCo with tribos.patch", mujoco.__version__, "MIT OR Apache-2.0", "mechanics"
SETTINGS = {"default": {"dt": 1e-3, "cone": "elliptic"}, "steps of 0.2 ms": {"dt": 2e-4, "cone": "elliptic"}}
BUILT = Path(__file__).resolve().parents[4] / "engines" / "mujoco" / "build" / "libtribos_patch.so"
mujoco.mj_loadPluginLibrary(os.environ.get("TRIBOS_PATCH", str(BUILT)))
POINT = 1e-5  # m, radius of the patch of a ball


def patch(scene):
    """Kind and size of the patch that bears the first body."""
    body = scene.bodies[0]
    kind, sizes = body.shape.kind, body.shape.sizes
    if kind == "box":
        return "box", f"{sizes[0]} {sizes[1]}"
    if kind == "cylinder" and body.pose[0] == 1.0:
        return "ring" if body.shape.is_rim else "disk", f"{sizes[0]}"
    if kind == "cylinder":
        # Its line of contact lies along the axis of the cylinder.
        return "box", f"{sizes[1]} {POINT}"
    return "disk", f"{POINT}"


class Simulator(plain.Simulator):
    def text(self, scene, setting, dt):
        lacks = {"anisotropic": "Its patches have one coefficient.", "capsule": "Its capsule has two pads.", "torsion": "Its points have no torsion."}
        refuse(scene, lacks)
        whole = super().text(scene, setting, dt)
        if len(scene.bodies) > 2 or (len(scene.bodies) > 1 and not scene.bodies[1].is_driven):
            # Two grounds of one body, or bodies on bodies, are MuJoCo's own.
            return whole
        first, rest = whole.split(f'<body name="{scene.bodies[0].name}"')
        body, rest = rest.split("</body>", 1)
        if scene.has_floor:
            ground = "floor"
        else:
            ground, rest = "plate", rest.replace("<geom ", '<geom name="plate" ', 1)
        kind, size = patch(scene)
        instances, used = "", ""
        for i in range(body.count("<geom ")):
            # Its own contacts bear it without friction.
            geom = f'<geom name="foot{i}" priority="1" '
            body = body.replace("<geom ", "<GEOM" + geom[5:], 1)
            keys = {"geom": f"foot{i}", "ground": ground, "patch": kind, "size": size, "mu": scene.mu}
            config = "".join(f'<config key="{key}" value="{value}"/>' for key, value in keys.items())
            instances += f'<instance name="foot{i}">{config}</instance>'
            used += f'<plugin instance="foot{i}"/>'
        body = body.replace("<GEOM", "<geom").replace('condim="3"', 'condim="1"').replace("<inertial", f"{used}<inertial")
        extension = f'<extension><plugin plugin="tribos.patch">{instances}</plugin></extension>'
        return first.replace("<mujoco>", f"<mujoco>{extension}") + f'<body name="{scene.bodies[0].name}"{body}</body>{rest}'
