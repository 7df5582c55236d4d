"""Final motion: what is left of sliding and spinning just before rest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from tribos import _native
from tribos._checks import number, positive
from tribos._friction import Friction


@dataclass(frozen=True)
class FixedPoint:
    """A ratio of sliding to spinning that a body keeps."""

    ratio: float
    """``speed / (|spin| * radius)``: 0 for pure spinning, infinite for pure sliding."""
    stability: str
    """``"stable"``, ``"semistable"`` or ``"unstable"``: whether ratios nearby come to it."""


@dataclass(frozen=True)
class Modes:
    """The final motion of a body that nothing but friction acts on."""

    final_mode: str | None
    """What dominates just before rest: ``"sliding"``, ``"spinning"``, or ``"together"`` where both
    fade in a fixed ratio; None where it depends on an initial ratio that was not given."""
    final_ratio: float | None
    """The ratio ``speed / (|spin| * radius)`` in the limit of rest; None with `final_mode`."""
    fixed_points: tuple[FixedPoint, ...]
    """All fixed points of the ratio, in rising order; the first is 0, the last infinite."""
    inertia_interval: tuple[float, float]
    """The open interval of ``I/(m * radius**2)`` in which there is a fixed point between them."""
    rests_in_finite_time: bool
    """True for ``alpha < 1``."""


def modes(
    friction: Friction,
    inertia_ratio: float = 0.5,
    *,
    initial_ratio: float | None = None,
    lean: float = 0.0,
) -> Modes:
    """The final motion of bodies that slide and spin to rest.

    Parameters
    ----------
    friction
        Coulomb friction, or ``mu * speed**alpha``, on a round patch; mu has no influence.
    inertia_ratio
        ``I/(m * radius**2)``, above 0 and finite: 1/2 for a solid disk on its own face.
    initial_ratio
        ``speed / (|spin| * radius)`` at the launch, from 0 to infinity. It decides between two
        stable ends, which there are for ``alpha > 1``.
    lean
        Lean of a tall body under dry friction, from 0 to 1: ``mu * height / (radius * <r²>)`` with
        the mean square ``<r²>`` of the distance from the centre in radii, 1/2 for a disk.

    Examples
    --------
    >>> import tribos
    >>> puck = tribos.Friction(tribos.disk(0.08), mu=0.3)
    >>> last = tribos.modes(puck, 0.5)
    >>> last.final_mode, round(last.final_ratio, 9)
    ('together', 0.653001789)
    >>> last.inertia_interval == (0.25, 2 / 3)
    True
    >>> tribos.modes(puck, 1.0).final_mode                 # a hoop only spins in the end
    'spinning'
    """
    initial = None if initial_ratio is None else _ratio(initial_ratio)
    part = number("lean", lean)
    if not 0.0 <= part <= 1.0:
        raise ValueError(f"lean must be from 0 to 1, not {lean!r}")
    handle = profiled(friction)
    inertia = positive("inertia_ratio", inertia_ratio)
    interval, points, last = handle.modes(inertia, initial, part)
    mode, ratio = (None, None) if last is None else last
    return Modes(
        final_mode=mode,
        final_ratio=ratio,
        fixed_points=tuple(FixedPoint(*point) for point in points),
        inertia_interval=interval,
        rests_in_finite_time=handle.alpha() < 1.0,
    )


def _ratio(value: float) -> float:
    """A number from 0 to infinity."""
    ratio = math.inf if value == math.inf else number("initial_ratio", value)
    if not ratio >= 0.0:
        raise ValueError(f"initial_ratio must be from 0 to infinity, not {value!r}")
    return ratio


def profiled(friction: Friction) -> _native.PowerLawProfile:
    """The friction as final motion and launches are computed from it."""
    if not isinstance(friction, Friction):
        raise ValueError(f"friction must be a tribos.Friction, not {friction!r}")
    return _made(friction)


@lru_cache(maxsize=64)
def _made(friction: Friction) -> _native.PowerLawProfile:
    return _native.PowerLawProfile(friction.patch._handle, friction.law._handle)
