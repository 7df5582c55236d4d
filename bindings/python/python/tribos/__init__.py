"""Solid friction of bodies that slide and spin at once, exact, on numpy arrays.

>>> import tribos
>>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)      # radius in m
>>> wrench = puck.wrench([1.0, 0.0, 20.0], load=1.7)       # m/s, m/s, rad/s; N
>>> print(wrench.round(5))                                 # N, N, N m
[-0.465   -0.      -0.00435]

A *twist* is ``(velocity_x, velocity_y, spin)`` in m/s and rad/s, a *wrench* is ``(force_x, force_y,
torque)`` in N and N m, on the body. Both are the last axis of an array; all axes before it are
broadcast. Any consistent set of units serves.
"""

import sys

from tribos import _command, _native, cd, md
from tribos._friction import Friction
from tribos._laws import Law, laws
from tribos._patches import (
    Patch,
    annulus,
    bar,
    box,
    disk,
    hertz,
    mesh,
    paraboloid,
    points,
    polygon,
    polynomial,
    power,
    punch,
    ring,
)
from tribos._run import Run, open_run, resume, run
from tribos._scene import Scene, scene
from tribos._states import Frame, Frames, State
from tribos._surface import LimitSurface
from tribos._sweep import cases, run_case, sweep
from tribos._threads import num_threads, set_num_threads
from tribos.scenes import (
    CurlingScene,
    CylinderScene,
    PipeScene,
    PlateScene,
    PowderScene,
    SliderScene,
    TipScene,
)

__version__: str = _native.__version__

_command.host(["python", *getattr(sys, "argv", [])])

__all__ = [
    "CurlingScene",
    "CylinderScene",
    "Frame",
    "Frames",
    "Friction",
    "Law",
    "LimitSurface",
    "Patch",
    "PipeScene",
    "PlateScene",
    "PowderScene",
    "Run",
    "Scene",
    "SliderScene",
    "State",
    "TipScene",
    "annulus",
    "bar",
    "box",
    "cases",
    "cd",
    "disk",
    "hertz",
    "laws",
    "md",
    "mesh",
    "num_threads",
    "open_run",
    "paraboloid",
    "points",
    "polygon",
    "polynomial",
    "power",
    "punch",
    "resume",
    "ring",
    "run",
    "run_case",
    "scene",
    "set_num_threads",
    "sweep",
]
