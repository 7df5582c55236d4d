"""The end of a time step."""

from __future__ import annotations

from typing import Any, NamedTuple


class Step(NamedTuple):
    """The end of a time step of many bodies."""

    twists: Any
    """Motions after the step, in m/s and rad/s, of shape (..., 3); of bodies at rest those of their surface, zero of a floor
    that does not move, to the last bit."""
    friction: Any
    """Mean friction over the step, in N and N m, of shape (..., 3)."""
    at_rest: Any
    """Whether friction holds the body, of shape (...)."""
