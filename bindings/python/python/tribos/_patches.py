"""Contact patches: shape and pressure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from tribos import _native
from tribos._checks import number, pair, positive, table
from tribos._frozen import Frozen
from tribos._plot import svg

Pair = Sequence[float]
Parameters = tuple[tuple[str, Any], ...]

__all__ = [
    "Patch",
    "annulus",
    "anisotropic",
    "bar",
    "bolts",
    "box",
    "disk",
    "ellipse",
    "hertz",
    "hertz_ellipse",
    "mesh",
    "paraboloid",
    "points",
    "polygon",
    "polynomial",
    "power",
    "punch",
    "ring",
    "worn_annulus",
]

MAKERS = __all__[1:]
"""The functions that make patches."""


class Patch(Frozen):
    """A contact patch: its shape and how it spreads the load.

    Made by `disk`, `ring`, `annulus`, `worn_annulus`, `hertz`, `punch`, `paraboloid`, `power`, `polynomial`, `ellipse`,
    `hertz_ellipse`, `polygon`, `box`, `bar`, `mesh`, `points`, `bolts` and `anisotropic`. Immutable, comparable and
    picklable.

    Attributes
    ----------
    kind : str
        The name of its maker.
    radius : float
        Distance of the farthest point from the centre of pressure, in m.
    centre : tuple of float
        The centre of pressure, in m, in the coordinates that twist and wrench refer to.
    """

    __slots__ = ("_handle", "_parameters", "_surfaces", "kind")

    kind: str
    _parameters: Parameters
    _handle: _native.Patch
    _surfaces: _native.LimitSurface | None

    def __init__(self, kind: str, parameters: Parameters, native: _native.Patch) -> None:
        self._keep(kind=kind, _parameters=parameters, _handle=native, _surfaces=None)

    def _limits(self) -> _native.LimitSurface:
        """The limit surfaces of this patch for every force limit, made once."""
        if self._surfaces is None:
            surfaces = _native.LimitSurface(self._handle)
            self._keep(_surfaces=surfaces)
            return surfaces
        return self._surfaces

    @property
    def radius(self) -> float:
        """Distance of the farthest point from the centre of pressure, in m."""
        return self._handle.radius()

    @property
    def centre(self) -> tuple[float, float]:
        """The centre of pressure, in m, in the coordinates that twist and wrench refer to."""
        x, y = self._handle.centre()
        return x, y

    def __repr__(self) -> str:
        given = ", ".join(f"{name}={_short(value)}" for name, value in self._parameters)
        return f"tribos.{self.kind}({given})"

    def _repr_svg_(self) -> str:
        """The outline with the centre of pressure, for notebooks."""
        return svg(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, (self.kind, self._parameters)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Patch):
            return NotImplemented
        return (self.kind, self._parameters) == (other.kind, other._parameters)

    def __hash__(self) -> int:
        return hash((self.kind, self._parameters))


def outline(patch: Patch) -> list[list[list[float]]]:
    """Loops of corners in m: of straight edges the outer one first, of a bar both ends, of a mesh its
    triangles; none for points and patches with an axis."""
    given = dict(patch._parameters)
    if patch.kind == "anisotropic":
        return outline(given["patch"])
    if patch.kind in ("ellipse", "hertz_ellipse"):
        turns = np.linspace(0.0, 2.0 * np.pi, 96, endpoint=False)
        return [
            np.stack([given["a"] * np.cos(turns), given["b"] * np.sin(turns)], axis=-1).tolist()
        ]
    if patch.kind == "box":
        x, y = 0.5 * given["a"], 0.5 * given["b"]
        return [[[-x, -y], [x, -y], [x, y], [-x, y]]]
    if patch.kind == "bar":
        half = 0.5 * given["length"]
        return [[[-half, 0.0], [half, 0.0]]]
    if patch.kind == "polygon":
        loops = (given["corners"], *given.get("holes", ()))
        return [[list(corner) for corner in loop] for loop in loops]
    if patch.kind == "mesh":
        places = given["vertices"]
        return [[list(places[index]) for index in corners] for corners in given["triangles"]]
    return []


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"<{len(value)} rows>"


def _made(kind: str, parameters: Parameters) -> Patch:
    """The patch of a maker's name and arguments."""
    made: Patch = globals()[kind](**dict(parameters))
    return made


def _round(kind: str, text: str, radius: float, **others: Any) -> Patch:
    length = positive("radius", radius)
    parameters = (("radius", length), *others.items())
    return Patch(kind, parameters, _native.Patch.named(text, length))


def disk(radius: float) -> Patch:
    """A disk under uniform pressure.

    Parameters
    ----------
    radius
        Its radius, in m.

    Examples
    --------
    >>> import tribos
    >>> tribos.disk(0.04)
    tribos.disk(radius=0.04)
    """
    return _round("disk", "disk", radius)


def ring(radius: float) -> Patch:
    """A ring with all of its load on the rim, evenly: a cup, a curling stone, a billiard puck.

    Parameters
    ----------
    radius
        Its radius, in m.
    """
    return _round("ring", "ring", radius)


def annulus(inner: float, outer: float) -> Patch:
    """Uniform pressure between two radii.

    Parameters
    ----------
    inner, outer
        Radii, in m, with ``0 <= inner < outer``. Where they differ by less than 1e-3 or so of the
        outer one, use `ring`.

    Examples
    --------
    >>> import tribos
    >>> tribos.annulus(0.03, 0.04)
    tribos.annulus(inner=0.03, outer=0.04)
    """
    small, large = number("inner", inner), positive("outer", outer)
    native = _native.Patch.named(f"annulus:{small / large!r}", large)
    return Patch("annulus", (("inner", small), ("outer", large)), native)


def worn_annulus(inner: float, outer: float) -> Patch:
    """The pressure ``1/r`` between two radii, as the facing of a clutch or a thrust bearing wears to; for dry friction.

    Parameters
    ----------
    inner, outer
        Radii, in m, with ``0 <= inner < outer``.

    Examples
    --------
    >>> import tribos
    >>> clutch = tribos.Friction(tribos.worn_annulus(0.06, 0.10), mu=0.35)
    >>> round(-float(clutch.wrench([0.0, 0.0, 20.0], load=4000.0)[2]), 6)   # mu F (r_o + r_i)/2, in N m
    112.0
    """
    small, large = number("inner", inner), positive("outer", outer)
    native = _native.Patch.named(f"worn-annulus:{small / large!r}", large)
    return Patch("worn_annulus", (("inner", small), ("outer", large)), native)


def hertz(radius: float) -> Patch:
    """The pressure of elastic spheres, which falls as ``sqrt(1 - (r/radius)**2)`` (Hertz 1882).

    Parameters
    ----------
    radius
        Radius of the contact, in m.
    """
    return _round("hertz", "hertz", radius)


def punch(radius: float) -> Patch:
    """The pressure under a rigid flat punch on an elastic half space, ``1/sqrt(1 - (r/radius)**2)``.

    Parameters
    ----------
    radius
        Radius of the contact, in m.
    """
    return _round("punch", "punch", radius)


def paraboloid(radius: float) -> Patch:
    """The pressure ``1 - (r/radius)**2``.

    Parameters
    ----------
    radius
        Radius of the contact, in m.
    """
    return _round("paraboloid", "paraboloid", radius)


def power(radius: float, order: float) -> Patch:
    """The pressure ``(1 - (r/radius)**2)**order``.

    Parameters
    ----------
    radius
        Radius of the contact, in m.
    order
        Above -1; 0 is the disk, 1/2 Hertz' pressure, -1/2 that of a punch.
    """
    exponent = number("order", order)
    return _round("power", f"power:{exponent!r}", radius, order=exponent)


def polynomial(radius: float, coefficients: Sequence[float]) -> Patch:
    """The pressure ``sum(a[k] * (r/radius)**(2*k))``, nowhere negative.

    Parameters
    ----------
    radius
        Radius of the contact, in m.
    coefficients
        ``a[0], a[1], …``; only their ratios count.
    """
    values = tuple(number("coefficients", a) for a in coefficients)
    if not values:
        raise ValueError("coefficients must not be empty")
    text = ",".join(repr(a) for a in values)
    return _round("polynomial", f"polynomial:{text}", radius, coefficients=values)


def polygon(
    corners: ArrayLike, *, holes: Sequence[ArrayLike] = (), centre: Pair | None = None
) -> Patch:
    """A polygon, with holes if there are any, under uniform or linear pressure.

    Parameters
    ----------
    corners
        Corners in m, of shape (n, 2), in either sense.
    holes
        Corners of each hole.
    centre
        Centre of pressure, in m: the pressure is linear with this centre. None for uniform pressure.

    Examples
    --------
    >>> import tribos
    >>> foot = tribos.polygon([[0, 0], [0.25, 0.02], [0.25, 0.1], [0, 0.08]])
    >>> tuple(round(x, 4) for x in foot.centre)
    (0.125, 0.05)
    """
    outer = table("corners", corners, 2)
    inner = tuple(table("holes", hole, 2) for hole in holes)
    at = None if centre is None else pair("centre", centre)
    native = _native.Patch.polygon([loop.tolist() for loop in (outer, *inner)], at)
    parameters: Parameters = (("corners", _frozen(outer)),)
    if inner:
        parameters += (("holes", tuple(_frozen(hole) for hole in inner)),)
    if at is not None:
        parameters += (("centre", at),)
    return Patch("polygon", parameters, native)


def box(a: float, b: float, *, centre: Pair | None = None) -> Patch:
    """A rectangle about the origin under uniform or linear pressure.

    Parameters
    ----------
    a, b
        Its sides along x and y, in m.
    centre
        Centre of pressure, in m, as in `polygon`.

    Examples
    --------
    >>> import tribos
    >>> tribos.box(0.3, 0.2, centre=(0.02, 0.0))
    tribos.box(a=0.3, b=0.2, centre=(0.02, 0.0))
    """
    x, y = 0.5 * positive("a", a), 0.5 * positive("b", b)
    at = None if centre is None else pair("centre", centre)
    native = _native.Patch.polygon([[[-x, -y], [x, -y], [x, y], [-x, y]]], at)
    parameters: Parameters = (("a", 2.0 * x), ("b", 2.0 * y))
    if at is not None:
        parameters += (("centre", at),)
    return Patch("box", parameters, native)


def bar(length: float) -> Patch:
    """A straight line along x about the origin, with its load spread evenly.

    Parameters
    ----------
    length
        Its length, in m.
    """
    along = positive("length", length)
    return Patch("bar", (("length", along),), _native.Patch.named(f"bar:{along!r}", along))


def mesh(vertices: ArrayLike, triangles: ArrayLike, pressure: ArrayLike) -> Patch:
    """Triangles with a pressure at each vertex, linear in between.

    Parameters
    ----------
    vertices
        Positions in m, of shape (n, 2).
    triangles
        Indices of vertices, of shape (m, 3).
    pressure
        Pressure at each vertex, of shape (n,); only ratios count.
    """
    places = table("vertices", vertices, 2)
    values = table("pressure", np.reshape(np.asarray(pressure), (-1, 1)), 1)
    indices = np.asarray(triangles)
    if indices.ndim != 2 or indices.shape[1] != 3 or indices.dtype.kind not in "iu":
        raise ValueError("triangles must be integers of shape (m, 3)")
    if len(values) != len(places):
        raise ValueError(f"pressure must have one value a vertex: {len(places)}, not {len(values)}")
    if indices.size and (indices.min() < 0 or indices.max() >= len(places)):
        raise ValueError(f"triangles must index the {len(places)} vertices, from 0 on")
    rows = np.hstack((places, values))
    native = _native.Patch.mesh(rows.tolist(), indices.tolist())
    parameters: Parameters = (
        ("vertices", _frozen(places)),
        ("triangles", tuple(map(tuple, indices.tolist()))),
        ("pressure", tuple(values[:, 0].tolist())),
    )
    return Patch("mesh", parameters, native)


def points(positions: ArrayLike, weights: ArrayLike | None = None) -> Patch:
    """Points of contact, each with a share of the load: feet, spikes, a sampled pressure.

    Parameters
    ----------
    positions
        Positions in m, of shape (n, 2).
    weights
        Shares of the load, of shape (n,); only ratios count. None for equal ones.

    Examples
    --------
    >>> import tribos
    >>> chair = tribos.points([[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]])
    >>> round(float(chair.radius), 4)
    0.2828
    """
    places = table("positions", positions, 2)
    shares = np.ones(len(places)) if weights is None else np.asarray(weights)
    values = table("weights", np.reshape(shares, (-1, 1)), 1)
    if len(values) != len(places):
        raise ValueError(f"weights must have one value a point: {len(places)}, not {len(values)}")
    native = _native.Patch.points(np.hstack((places, values)).tolist())
    parameters: Parameters = (("positions", _frozen(places)),)
    if weights is not None:
        parameters += (("weights", tuple(values[:, 0].tolist())),)
    return Patch("points", parameters, native)


def bolts(count: int, radius: float) -> Patch:
    """Bolts that share the load evenly on a circle about the origin, the first one on the x axis.

    Parameters
    ----------
    count
        How many, at least 2.
    radius
        Radius of their circle, in m.

    Examples
    --------
    >>> import tribos
    >>> flange = tribos.Friction(tribos.bolts(6, 0.05), mu=0.15)
    >>> round(-float(flange.wrench([0.0, 0.0, 1.0], load=60e3)[2]), 6)    # N m
    450.0
    """
    length, many = positive("radius", radius), int(count)
    native = _native.Patch.named(f"bolts:{many}x{length!r}", 1.0)
    return Patch("bolts", (("count", many), ("radius", length)), native)


def ellipse(a: float, b: float) -> Patch:
    """An ellipse about the origin under uniform pressure.

    Parameters
    ----------
    a, b
        Semi-axes along x and y, in m, of which one is at most 1e6 times the other one.
    """
    return _elliptic("ellipse", "ellipse", a, b)


def hertz_ellipse(a: float, b: float) -> Patch:
    """An ellipse under the pressure of curved elastic bodies, ``sqrt(1 - rho**2)``: a wheel on a rail, a ball in its race.

    Parameters
    ----------
    a, b
        Semi-axes along x and y, in m, of which one is at most 1e6 times the other one.

    Examples
    --------
    >>> import tribos
    >>> ball = tribos.Friction(tribos.hertz_ellipse(1.2e-3, 0.2e-3), mu=0.08)
    >>> round(-1e3 * float(ball.wrench([0.0, 0.0, 30.0], load=400.0)[2]), 3)    # 3/8 mu Q a E(e), in mN m
    14.94
    """
    return _elliptic("hertz_ellipse", "hertz-ellipse", a, b)


def _elliptic(kind: str, text: str, a: float, b: float) -> Patch:
    x, y = positive("a", a), positive("b", b)
    return Patch(kind, (("a", x), ("b", y)), _native.Patch.named(f"{text}:{x!r}x{y!r}", 1.0))


def anisotropic(patch: Patch, mu: Pair, axis: float = 0.0) -> Patch:
    """A patch under friction that differs along two axes, which are fixed to it.

    `Friction` makes it of two coefficients; the larger one is the coefficient of its friction.

    Parameters
    ----------
    patch
        A polygon, box, bar, mesh, points, bolts, ellipse, disk, hertz, punch or paraboloid.
    mu
        Coefficients along the axis and across it, both above 0; only their ratio counts.
    axis
        Angle from x to the axis, in rad.
    """
    along, across = pair("mu", mu)
    angle = number("axis", axis)
    native = patch._handle.anisotropic((along, across), angle)
    parameters: Parameters = (("patch", patch), ("mu", (along, across)), ("axis", angle))
    return Patch("anisotropic", parameters, native)


def feet_patch(feet: tuple[Any, ...]) -> Patch:
    """Several feet as one patch."""
    native = _native.Floor.feet([(foot[0]._handle, *foot[1:]) for foot in feet]).patch()
    return Patch("feet_patch", (("feet", feet),), native)


def _frozen(rows: np.ndarray[Any, np.dtype[np.float64]]) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(row) for row in rows.tolist())
