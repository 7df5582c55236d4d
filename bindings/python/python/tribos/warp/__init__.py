"""Friction in Warp kernels, with adjoints, and feet for MuJoCo Warp and Newton.

The functions are Warp functions in float32, for kernels of one's own, on processors and GPUs. A row costs no
memory, and a limit (mu times load), a radius or a body may be another in each.

>>> import numpy as np, tribos, warp as wp
>>> import tribos.warp as tw
>>> wp.config.log_level = wp.LOG_WARNING
>>> @wp.kernel
... def slow_down(twist: wp.array(dtype=wp.vec3), load: wp.array(dtype=float),
...               force: wp.array(dtype=wp.vec3)):
...     i = wp.tid()
...     force[i] = tw.disk_wrench(twist[i], 0.3 * load[i], 0.04)
>>> with wp.ScopedDevice("cpu"):
...     twist = wp.array([[1.0, 0.0, 20.0]], dtype=wp.vec3)
...     force = wp.zeros(1, dtype=wp.vec3)
...     wp.launch(slow_down, 1, [twist, wp.array([1.7], dtype=float)], [force])
>>> wanted = tribos.Friction(tribos.disk(0.04), mu=0.3).wrench([1.0, 0.0, 20.0], 1.7)
>>> bool(np.allclose(force.numpy()[0], wanted, rtol=1e-6))
True

========================  ==========================================================================
wrench of a motion        `disk_wrench`, `round_wrench`, `box_wrench`, `polygon_wrench`
nearest carried wrench    `disk_project`, `round_project`, `box_project`, `polygon_project`
implicit planar step      `disk_planar_friction`, `round_planar_friction`, `box_planar_friction`,
                          `polygon_planar_friction`
contact manifold          `manifold_friction`
whole simulations         `attach`
========================  ==========================================================================

Notes
-----
*Formulas* are those of the compiled kernel: its fitted terms, its searches, its logarithm of + − × ÷ alone.

*Accuracy*, of force limit and force limit times radius: wrenches 3.2e-7 (polygons whose centroid is as far
from the origin as they are large 1.1e-6), projections and steps on round patches 3.5e-7 (rings 1e-6),
on boxes and polygons 2e-6.

*Bits*: with contraction off in the module of the calling kernel, ``wp.set_module_options({"fuse_fp": False})``,
`round_wrench` and `manifold_friction` have the bits of the kernel in float32 and of the C headers, for ordinary
speeds. Projections and steps start from other polynomials than the kernel's and may differ in the last digit.

*Derivatives* are closed: by twist, push and wrench, limit, radius, length, mass, inertia and time step; not
by sides and corners. They are zero at rest, and finite at pure spin, pure sliding, on corners and at equal
speeds, where a ring's is infinite. A step that ends at rest has that of the friction that stops the body.
"""

from tribos.warp._attach import AttachedFeet, attach
from tribos.warp._forms import DISK, HERTZ, PARABOLOID, PUNCH, RING
from tribos.warp._manifold import CURVE_AREA, CURVE_ELLIPSOID, CURVE_POINTS, manifold_friction
from tribos.warp._polygon import box_wrench, polygon_wrench
from tribos.warp._project import disk_project, round_project
from tribos.warp._round import disk_wrench, round_wrench
from tribos.warp._shape import (
    box_planar_friction,
    box_project,
    polygon_planar_friction,
    polygon_project,
)
from tribos.warp._step import disk_planar_friction, round_planar_friction

__all__ = [
    "CURVE_AREA",
    "CURVE_ELLIPSOID",
    "CURVE_POINTS",
    "DISK",
    "HERTZ",
    "PARABOLOID",
    "PUNCH",
    "RING",
    "AttachedFeet",
    "attach",
    "box_planar_friction",
    "box_project",
    "box_wrench",
    "disk_planar_friction",
    "disk_project",
    "disk_wrench",
    "manifold_friction",
    "polygon_planar_friction",
    "polygon_project",
    "polygon_wrench",
    "round_planar_friction",
    "round_project",
    "round_wrench",
]
