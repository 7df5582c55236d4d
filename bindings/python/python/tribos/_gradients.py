"""Derivatives of friction, of the planar step and of the way to rest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from tribos import _native
from tribos._checks import number, positive
from tribos._friction import Friction
from tribos._laws import Law
from tribos._patches import Patch

#: Surfaces and laws that are kept ready: making one takes up to some ms, its use some µs.
KEPT = 32


@lru_cache(maxsize=KEPT)
def derivatives_of(patch: Patch) -> _native.SurfaceDerivatives:
    """Derivatives of the limit surfaces of a patch."""
    return _native.SurfaceDerivatives(patch._handle)


@lru_cache(maxsize=KEPT)
def derivatives_of_ellipsoids(patch: Patch) -> _native.SurfaceDerivatives:
    """Derivatives of the ellipsoids with the same largest force and torque."""
    return _native.SurfaceDerivatives.of_ellipsoids(patch._handle)


@lru_cache(maxsize=KEPT)
def rest_map(friction: Friction) -> _native.RestMap:
    """How bodies on a round patch come to rest."""
    return _native.RestMap(friction.patch._handle, friction.law._handle)


class PlanarStepBy(NamedTuple):
    """Derivatives of three components by what a planar step depends on.

    Shapes (..., 3, 3) for twist and push, (..., 3) for the others; components are rows.
    """

    twists: Any
    pushes: Any
    load: Any
    mass: Any
    inertia: Any
    dt: Any


class PlanarStepJacobian(NamedTuple):
    """A planar step and its derivatives."""

    twists: Any
    """Motions after the step, in m/s and rad/s, of shape (..., 3); zero to the last bit at rest."""
    friction: Any
    """Mean friction over the step, in N and N m, of shape (..., 3)."""
    at_rest: Any
    """Whether friction holds the body, of shape (...)."""
    twists_by: PlanarStepBy
    """Derivatives of the motions after the step."""
    friction_by: PlanarStepBy
    """Derivatives of friction."""


class SlideBy(NamedTuple):
    """Derivatives of one number by what the way to rest depends on."""

    speed: Any
    spin: Any
    gravity: Any
    radius: Any


class SlideJacobian(NamedTuple):
    """The way to rest and its derivatives."""

    time: Any
    """Time from launch to rest, in s."""
    distance: Any
    """Distance covered, in m, with the sign of the speed."""
    angle: Any
    """Angle turned, in rad, with the sign of the spin."""
    time_by: SlideBy
    """Derivatives of the time."""
    distance_by: SlideBy
    """Derivatives of the distance."""
    angle_by: SlideBy
    """Derivatives of the angle."""


def planar_step_jacobian(
    friction: Friction,
    twists: ArrayLike,
    pushes: ArrayLike,
    load: ArrayLike,
    *,
    mass: ArrayLike,
    inertia: ArrayLike,
    dt: ArrayLike,
) -> PlanarStepJacobian:
    """The implicit step of `PlanarBody`, and its derivatives.

    Friction is the wrench, of those that the patch carries, nearest to the one that would end the
    motion within half the step (the implicit midpoint rule), or within the whole step where the
    motion would turn about; if the patch carries the latter, the body is at rest. The derivatives
    are those of the branch taken, by implicit differentiation.

    Parameters
    ----------
    friction
        Coulomb friction of a patch.
    twists
        Velocities in m/s and spins in rad/s, of shape (..., 3), along the axes of the patch.
    pushes
        All other forces in N and torques in N m, constant over the step, of shape (..., 3).
    load
        Normal force in N, at least 0.
    mass, inertia
        Mass in kg, and moment of inertia about the normal through the origin in kg m².
    dt
        Time of the step in s.

    Returns
    -------
    PlanarStepJacobian
        Twist, friction and rest after the step; derivatives by twists, pushes, load, mass, inertia, dt.

    Notes
    -----
    All derivatives are finite, at rest too: the motion after a step that ends at rest does not
    depend on anything, its derivatives are exactly zero, while friction balances push and momentum.
    Between branches the derivatives jump, as friction that sticks and slips does.

    Accuracy: 1e-9 of the largest entry.

    Examples
    --------
    >>> import tribos
    >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
    >>> body = {"mass": 0.17, "inertia": 1.36e-4, "dt": 0.01}
    >>> step = tribos.planar_step_jacobian(puck, [1.0, 0.0, 20.0], [0.0, 0.0, 0.0], 1.7, **body)
    >>> print(step.twists.round(4), step.twists_by.load.round(5))
    [ 0.9727  0.     19.6778] [-0.01605  0.      -0.19077]
    >>> held = tribos.planar_step_jacobian(puck, [0.0, 0.0, 0.0], [0.3, 0.0, 0.0], 1.7, **body)
    >>> bool(held.at_rest), float(abs(held.twists_by.pushes).max())
    (True, 0.0)
    """
    step = PlanarStep(friction)
    given = (twists, pushes, load, mass, inertia, dt)
    after, mean, rest, by = step.all(*given)
    return PlanarStepJacobian(after, mean, rest != 0.0, step.by(by, 0), step.by(by, 1))


def slide_jacobian(
    friction: Friction,
    speed: ArrayLike,
    spin: ArrayLike,
    *,
    inertia_ratio: float = 0.5,
    gravity: ArrayLike = 9.81,
    radius: ArrayLike | None = None,
) -> SlideJacobian:
    """Time, distance and angle until launched bodies are at rest, and their derivatives.

    Parameters
    ----------
    friction
        Coulomb friction, or ``mu * speed**alpha`` with ``alpha < 1``, on a round patch.
    speed, spin
        Speeds in m/s and spins in rad/s of the launch, of either sign.
    inertia_ratio
        ``I/(m * radius**2)``: 1/2 for a solid disk on its own face.
    gravity
        Acceleration that presses the body down, in m/s². Friction depends on ``mu * gravity``: a
        derivative by mu is ``gravity / mu`` times the one by gravity.
    radius
        Radius of the patch in m, for the derivative by it; None for its own.

    Returns
    -------
    SlideJacobian
        Time in s, distance in m, angle in rad; derivatives by speed, spin, gravity and radius.

    Notes
    -----
    The derivatives are smooth in every direction of the launch; for one at rest they are given as
    zero, although the time has a kink there.

    Accuracy: time, distance and angle 1e-13, derivatives 1e-9, on a thin ring next to
    ``speed = spin * radius`` less.

    Examples
    --------
    >>> import tribos
    >>> puck = tribos.Friction(tribos.disk(0.08), mu=0.3)
    >>> throw = tribos.slide_jacobian(puck, 1.0, 12.5)
    >>> print(throw.distance.round(4), throw.distance_by.spin.round(5))     # m, m s/rad
    0.2166 0.00789
    """
    slide = Slide(friction, positive("inertia_ratio", inertia_ratio))
    rows, by = slide.all(speed, spin, gravity, slide.own(radius))
    values = [rows[..., k] for k in range(3)]
    slopes = [SlideBy(*(by[..., k, j] for j in range(4))) for k in range(3)]
    return SlideJacobian(*values, *slopes)


def softened(mu: float, speed: float) -> Law:
    """A law of friction that is smooth at rest: ``mu * v / (v + speed)``.

    Coulomb friction has no derivative at rest: it jumps. This law has one, ``mu / speed`` per load,
    and tends to `mu` for ``v`` far above `speed`, from which it differs by the share
    ``speed / (v + speed)``. It is the catalogue's ``plateau`` with the exponent 0 and nothing left at
    rest, a substitute for numerical work and no law of nature: nothing sticks under it, and a body
    that is pushed creeps. It is a law of the local speed, for round patches and points.

    Parameters
    ----------
    mu
        Coefficient of friction of fast sliding, at least 0.
    speed
        The speed with half of the friction, in m/s.

    Examples
    --------
    >>> import tribos
    >>> law = tribos.softened(mu=0.3, speed=1e-3)
    >>> print(law.friction([0.0, 1e-3, 1.0]).round(4), law.slope(0.0))
    [0.     0.15   0.2997] 300.0
    >>> puck = tribos.Friction(tribos.disk(0.1), law=law)
    >>> print(puck.jacobian([0.0, 0.0, 0.0], load=1.0).diagonal().round(3))
    [-300.  -300.    -1.5]
    """
    width = positive("speed", speed)
    # The plateau's own speed has no effect where the exponent is 0; it may not be below the other.
    return Law("plateau", gamma=number("mu", mu), alpha=0.0, vp=width, vd=width, r=0.0)


class Operation:
    """A function of arrays with known derivatives, for programs that differentiate.

    Inputs and outputs are rows of three numbers or numbers, as `inputs` and `outputs` tell by 3 and 0;
    `smooth` are the outputs that have derivatives.
    """

    inputs: ClassVar[tuple[int, ...]]
    outputs: ClassVar[tuple[int, ...]]
    smooth: ClassVar[tuple[int, ...]] = (0,)

    def value(self, *given: Any) -> tuple[Any, ...]:
        """The outputs."""
        raise NotImplementedError

    def derivatives(self, *given: Any) -> tuple[tuple[Any, ...], list[list[Any]]]:
        """The outputs, and the derivatives of the smooth ones by each input."""
        raise NotImplementedError


def finite_derivatives(operation: Operation, *given: Any) -> tuple[Any, list[list[Any]]]:
    """Outputs and derivatives, with zero for those of a row in which one is infinite, as at rest.

    Zero is what they tend to on average over the senses of a motion around rest. An infinite one would
    make no numbers of the other rows' wherever derivatives are summed. Rows with an argument or an
    output that is not finite keep theirs.
    """
    values, by = operation.derivatives(*given)
    is_finite: Any = True
    for array, row in zip(given, operation.inputs, strict=True):
        is_finite = is_finite & _is_finite(array, row > 0)

    def kept(output: int, at: int, slope: Any) -> Any:
        slope = np.asarray(slope)
        axes = (operation.outputs[output] > 0) + (operation.inputs[at] > 0)
        is_known = is_finite & _is_finite(values[output], operation.outputs[output] > 0)
        is_kept = _is_finite(slope, axes) | ~np.asarray(is_known)
        return np.where(is_kept[(...,) + (None,) * axes], slope, 0.0)

    return values, [
        [kept(output, at, slope) for at, slope in enumerate(slopes)]
        for output, slopes in enumerate(by)
    ]


def _is_finite(array: Any, axes: int) -> Any:
    """Whether all numbers along the last axes are finite."""
    return np.isfinite(array).all(axis=tuple(range(-int(axes), 0)))


def _rows(given: Any) -> Any:
    """Numbers as rows of one."""
    return np.asarray(given)[..., None]


def _times(matrix: Any, row: Any) -> Any:
    return np.einsum("...ij,...j->...i", matrix, row)


@dataclass(frozen=True)
class Wrench(Operation):
    """Friction by twist and load, to which it is proportional."""

    friction: Friction
    inputs: ClassVar[tuple[int, ...]] = (3, 0)
    outputs: ClassVar[tuple[int, ...]] = (3,)

    def value(self, *given: Any) -> tuple[Any, ...]:
        return (self.friction.wrench(*given),)

    def derivatives(self, *given: Any) -> tuple[tuple[Any, ...], list[list[Any]]]:
        twists, _ = given
        unit = self.friction.wrench(twists, 1.0)
        return self.value(*given), [[self.friction.jacobian(*given), unit]]


@dataclass(frozen=True)
class OnSurface(Operation):
    """Something about the limit surface of a friction, for every load."""

    friction: Friction

    def __post_init__(self) -> None:
        # Laws without limit surface are refused here, not in the midst of another program's loop.
        _ = self.friction.mu

    def limits(self, load: Any) -> Any:
        """Force limits."""
        return self.friction.mu * np.asarray(load, dtype=np.float64)

    @property
    def surface(self) -> _native.LimitSurface:
        """The surfaces."""
        return self.friction.patch._limits()

    @property
    def slopes(self) -> _native.SurfaceDerivatives:
        """Their derivatives."""
        return derivatives_of(self.friction.patch)


@dataclass(frozen=True)
class Support(OnSurface):
    """The support function by twist and load, to which it is proportional."""

    inputs: ClassVar[tuple[int, ...]] = (3, 0)
    outputs: ClassVar[tuple[int, ...]] = (0,)

    def value(self, *given: Any) -> tuple[Any, ...]:
        twists, load = given
        return (self.surface.support(self.limits(load), twists),)

    def derivatives(self, *given: Any) -> tuple[tuple[Any, ...], list[list[Any]]]:
        twists, load = given
        gradient = np.negative(self.surface.wrench(self.limits(load), twists))
        by_load = self.surface.support(self.friction.mu, twists)
        return self.value(*given), [[gradient, by_load]]


@dataclass(frozen=True)
class Gauge(OnSurface):
    """The gauge by wrench and load, to which it is inversely proportional."""

    inputs: ClassVar[tuple[int, ...]] = (3, 0)
    outputs: ClassVar[tuple[int, ...]] = (0,)

    def value(self, *given: Any) -> tuple[Any, ...]:
        wrenches, load = given
        return (self.surface.gauge(self.limits(load), wrenches),)

    def derivatives(self, *given: Any) -> tuple[tuple[Any, ...], list[list[Any]]]:
        wrenches, load = given
        (gauge,) = self.value(*given)
        gradient = self.slopes.gauge_gradient(self.limits(load), wrenches)
        with np.errstate(divide="ignore", invalid="ignore"):
            by_load = -np.asarray(gauge) / np.asarray(load)
        # Without load it is infinite whatever the wrench, or 0 for none.
        is_held = np.asarray(load) != 0.0
        return (gauge,), [
            [np.where(_rows(is_held), gradient, 0.0), np.where(is_held, by_load, 0.0)]
        ]


@dataclass(frozen=True)
class Normal(OnSurface):
    """The normal by wrench; the load has no effect."""

    inputs: ClassVar[tuple[int, ...]] = (3,)
    outputs: ClassVar[tuple[int, ...]] = (3,)

    def value(self, *given: Any) -> tuple[Any, ...]:
        (wrenches,) = given
        return (self.surface.normal(1.0, wrenches),)

    def derivatives(self, *given: Any) -> tuple[tuple[Any, ...], list[list[Any]]]:
        (wrenches,) = given
        return self.value(*given), [[self.slopes.normal_jacobian(1.0, wrenches)]]


@dataclass(frozen=True)
class Project(OnSurface):
    """The nearest wrench of the set, by wrench and load."""

    length: float
    inputs: ClassVar[tuple[int, ...]] = (3, 0)
    outputs: ClassVar[tuple[int, ...]] = (3,)

    def value(self, *given: Any) -> tuple[Any, ...]:
        wrenches, load = given
        return (self.surface.project(self.limits(load), wrenches, self.length),)

    def derivatives(self, *given: Any) -> tuple[tuple[Any, ...], list[list[Any]]]:
        wrenches, load = given
        limits = self.limits(load)
        (nearest,) = self.value(*given)
        rate = self.slopes.project_jacobian(limits, wrenches, self.length)
        # Wrench and limit in proportion give the nearest wrench in proportion. Without load it grows
        # as the wrench that opposes the motion along the displacement.
        row = np.asarray(wrenches, dtype=np.float64)
        first = np.negative(self.surface.wrench(1.0, row / [1.0, 1.0, self.length**2]))
        with np.errstate(divide="ignore", invalid="ignore"):
            grows = (nearest - _times(rate, row)) / _rows(limits)
        by_load = self.friction.mu * np.where(_rows(limits) == 0.0, first, grows)
        return (nearest,), [[rate, by_load]]


@dataclass(frozen=True)
class PlanarStep(OnSurface):
    """A planar step by twist, push, load, mass, inertia and time; 1 at rest is its third output."""

    inputs: ClassVar[tuple[int, ...]] = (3, 3, 0, 0, 0, 0)
    outputs: ClassVar[tuple[int, ...]] = (3, 3, 0)
    smooth: ClassVar[tuple[int, ...]] = (0, 1)

    def all(self, *given: Any) -> tuple[Any, Any, Any, Any]:
        """Motion, friction, rest and the derivatives of the first two by ten numbers."""
        twists, pushes, load, mass, inertia, dt = given
        step = self.slopes.planar_step_jacobian
        return step(self.limits(load), twists, pushes, mass, inertia, dt)

    def by(self, by: Any, output: int) -> PlanarStepBy:
        """The derivatives of one output."""
        of = by[..., 3 * output : 3 * output + 3, :]
        load = self.friction.mu * of[..., 6]
        return PlanarStepBy(of[..., :3], of[..., 3:6], load, of[..., 7], of[..., 8], of[..., 9])

    def value(self, *given: Any) -> tuple[Any, ...]:
        twists, pushes, load, mass, inertia, dt = given
        limits = self.limits(load)
        bodies = {
            "force_limit": limits,
            "mass": mass,
            "inertia": inertia,
            "dt": dt,
            "strength": 1.0,
        }
        patch = self.friction.patch._handle
        return tuple(_native.planar_step(patch, self.surface, bodies, twists, pushes, 0.0))

    def derivatives(self, *given: Any) -> tuple[tuple[Any, ...], list[list[Any]]]:
        after, mean, rest, by = self.all(*given)
        return (after, mean, rest), [list(self.by(by, 0)), list(self.by(by, 1))]


@dataclass(frozen=True)
class Slide(Operation):
    """Time, distance and angle to rest by speed, spin, gravity and radius."""

    friction: Friction
    inertia_ratio: float
    inputs: ClassVar[tuple[int, ...]] = (0, 0, 0, 0)
    outputs: ClassVar[tuple[int, ...]] = (0, 0, 0)
    smooth: ClassVar[tuple[int, ...]] = (0, 1, 2)

    def __post_init__(self) -> None:
        rest_map(self.friction)

    def own(self, radius: Any) -> Any:
        """The radius, that of the patch for None."""
        return self.friction.patch.radius if radius is None else radius

    def all(self, *given: Any) -> tuple[Any, Any]:
        """Rows of time, distance, angle, and their derivatives."""
        speed, spin, gravity, radius = given
        rest_and_jacobian = rest_map(self.friction).rest_and_jacobian
        return rest_and_jacobian(speed, spin, gravity, radius, self.inertia_ratio)

    def value(self, *given: Any) -> tuple[Any, ...]:
        speed, spin, gravity, radius = given
        rows = rest_map(self.friction).rest(speed, spin, gravity, radius, self.inertia_ratio)
        return tuple(rows[..., k] for k in range(3))

    def derivatives(self, *given: Any) -> tuple[tuple[Any, ...], list[list[Any]]]:
        rows, by = self.all(*given)
        values = tuple(rows[..., k] for k in range(3))
        return values, [[by[..., k, j] for j in range(4)] for k in range(3)]


def length_of(friction: Friction, length: float | None) -> float:
    """The length that makes a force of a torque; None for the radius about the origin."""
    if length is not None:
        return positive("length", length)
    x, y = friction.patch.centre
    return friction.patch.radius + math.hypot(x, y)
