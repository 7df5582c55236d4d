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

from tribos import _command, _native, _patches, cd, md, scenes
from tribos._any_pressure import AnyPressure, TorqueLimits, any_pressure
from tribos._contact import Collision, ContactLaw, Plates, Spheres
from tribos._fit import Compared, Estimate, LawFit, SupportFit, compare, fit, fit_support
from tribos._floor import Feet, SteadyMotion, feet
from tribos._friction import Friction
from tribos._gradients import (
    PlanarStepBy,
    PlanarStepJacobian,
    SlideBy,
    SlideJacobian,
    planar_step_jacobian,
    slide_jacobian,
    softened,
)
from tribos._inverse import Launch, inverse
from tribos._laws import Law, laws
from tribos._loaded import LoadedFriction
from tribos._log import Look, look
from tribos._manifold import ContactForce, Manifold, SolverReport
from tribos._modes import FixedPoint, Modes, modes
from tribos._packing import Packing, read_packing
from tribos._patches import *  # noqa: F403 - every patch
from tribos._planar import PlanarBody, Rollout
from tribos._push import (
    ConeEdge,
    Grip,
    Journey,
    LineContact,
    MotionCone,
    PointContact,
    Push,
    motion_cone,
    push,
    push_along,
)
from tribos._run import Run, open_run, resume, run
from tribos._scene import Scene, scene
from tribos._slide import Motion, Rest, slide, slide_path
from tribos._state import LuGre, RateState
from tribos._states import Frame, Frames, State
from tribos._step import Step
from tribos._strokes import Strokes, strokes
from tribos._surface import LimitSurface
from tribos._sweep import cases, run_case, sweep
from tribos._threads import num_threads, set_num_threads
from tribos._track import TrackFit, fit_track
from tribos.scenes import *  # noqa: F403 - the scene of every body

__version__: str = _native.__version__

_command.host(["python", *getattr(sys, "argv", [])])

__all__ = [
    "AnyPressure",
    "Collision",
    "Compared",
    "ConeEdge",
    "ContactForce",
    "ContactLaw",
    "Estimate",
    "Feet",
    "FixedPoint",
    "Frame",
    "Frames",
    "Friction",
    "Grip",
    "Journey",
    "Launch",
    "Law",
    "LawFit",
    "LimitSurface",
    "LineContact",
    "LoadedFriction",
    "Look",
    "LuGre",
    "Manifold",
    "Modes",
    "Motion",
    "MotionCone",
    "Packing",
    "PlanarBody",
    "PlanarStepBy",
    "PlanarStepJacobian",
    "Plates",
    "PointContact",
    "Push",
    "RateState",
    "Rest",
    "Rollout",
    "Run",
    "Scene",
    "SlideBy",
    "SlideJacobian",
    "SolverReport",
    "Spheres",
    "State",
    "SteadyMotion",
    "Step",
    "Strokes",
    "SupportFit",
    "TorqueLimits",
    "TrackFit",
    "any_pressure",
    "cases",
    "cd",
    "compare",
    "feet",
    "fit",
    "fit_support",
    "fit_track",
    "inverse",
    "laws",
    "look",
    "md",
    "modes",
    "motion_cone",
    "num_threads",
    "open_run",
    "planar_step_jacobian",
    "push",
    "push_along",
    "read_packing",
    "resume",
    "run",
    "run_case",
    "scene",
    "set_num_threads",
    "slide",
    "slide_jacobian",
    "slide_path",
    "softened",
    "strokes",
    "sweep",
]
__all__ += _patches.__all__
__all__ += scenes.__all__
