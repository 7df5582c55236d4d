"""Friction, limit surfaces, planar steps and ways to rest in JAX programs, with derivatives.

The functions take and return JAX arrays and work under ``jit``, ``vmap``, ``grad``, ``jacfwd``, ``jacrev``,
``hessian`` and ``scan``.

>>> import jax, tribos, tribos.jax
>>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
>>> def power(twist):
...     return twist @ tribos.jax.wrench(puck, twist, 1.7)
>>> slope = jax.jit(jax.grad(power))(jax.numpy.array([1.0, 0.0, 20.0]))
>>> print([round(float(x), 4) + 0.0 for x in slope])
[-0.465, 0.0, -0.0044]

Coefficients, sizes and loads may be arrays, one for each row, and have derivatives:

>>> mu = jax.numpy.array([0.2, 0.4])
>>> forces = tribos.jax.wrench(puck, jax.numpy.array([1.0, 0.0, 0.0]), 1.7, mu=mu, radius=0.05)
>>> print([round(float(x), 4) for x in forces[:, 0]])
[-0.34, -0.68]

Notes
-----
*Backends*: Coulomb friction of `tribos.disk`, `ring`, `punch`, `hertz`, `paraboloid`, and of `box` and
`polygon` under uniform pressure, is made of XLA's own operations: on every device, with derivatives of
every order. All else, and `slide`, is computed by the compiled kernel on the processor by
``jax.pure_callback``, with first derivatives. ``backend="xla"`` refuses what would be called back,
``"callback"`` calls back: on the processor that is quicker, up to four times in float64, for planar steps
and projections of thousands of polygons at once, whose searches in XLA go on until the last row has ended.

*Precision*: results have the type of the twists or wrenches; all other arguments are rounded to it.
float16 and bfloat16 are computed in float32. Unless ``jax.config.update("jax_enable_x64", True)`` is
set, arrays of numpy in float64 become float32, as everywhere in JAX. Friction is right to 2e-15 of the
largest force and torque in float64 (disk, punch, Hertz, paraboloid 6e-16) and 3e-7 in float32 (ring
6e-7), Jacobians to 2e-15 and 1e-6 of their largest entry (a ring next to equal speeds 5e-14 and 2e-5).
XLA contracts products and sums: the bits are not those of the kernel, and may differ between devices.

*Keywords* of all functions with a form: ``mu`` takes the place of the friction's own coefficient;
``radius`` (round patches) and ``corners`` of shape (..., n, 2) in m (`box`, `polygon`; in either sense,
repeated ones count once, so that unlike polygons make one array) that of the patch's. Leading axes of all
arguments are broadcast together. The friction is hashable and may be a ``static_argnums`` of ``jit``;
frictions of one kind share one compiled program whatever their numbers are.

*At rest* Coulomb friction jumps, and its derivative is infinite. Values and derivatives of every order of
a row at rest are zero, so that it disturbs no other row of a batch. At exactly equal speeds of sliding
and of a disk's rim the second derivative is infinite as a logarithm is, of a ring the first one: large
numbers stand in for them. `planar_step` has finite derivatives everywhere, because an implicit step
smooths the jump, and its motion after a step that ends at rest has a derivative of exactly zero; so a
body that has come to rest passes no gradient on, which is right but may surprise an optimiser. NaN gives
NaN in its row alone, and so does an infinite twist or wrench. Negative loads and coefficients
are refused where they are numbers or arrays of numpy, and by the kernel; NaN comes of them in XLA.

*Softening*: ``soft`` is a speed in m/s. With D the power of dry friction over ``mu * load``, a speed,
softened friction is D/sqrt(D² + soft²) times dry friction: minus the gradient of the convex potential
``mu * load * (sqrt(D² + soft²) - soft)``, which `support` then is, on every patch. At rest its Jacobian is
-mu load/soft diag(1, 1, T²) about the centre of pressure, T the torque of spinning over mu load in m (2/3
of the radius of a disk), and its second derivatives are 0. Nothing sticks then: a body that is pushed
creeps.

*Cost*: a call outside of ``jit`` takes some 10 µs, and 0.1 to 1 s for the first one with a kind of patch
and shapes, in which XLA compiles it. A callback costs 0.1 to 0.3 ms a call, whatever it computes. Under
``scan`` reverse mode is quicker with ``jax.checkpoint`` of the step.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import jax.numpy as jnp

from tribos import _gradients, _jax_callback, _jax_native
from tribos._arguments import axes_of, friction_in
from tribos._checks import positive
from tribos._forms.pushed_path import Journey
from tribos._forms.pushing import PointContact, Push
from tribos._friction import Friction
from tribos._gradients import length_of
from tribos._jax_arguments import Call
from tribos._jax_manifold import manifold_friction
from tribos._jax_pushing import push, push_along
from tribos._step import Step

__all__ = [
    "Journey",
    "PointContact",
    "Push",
    "Slide",
    "Step",
    "gauge",
    "jacobian",
    "manifold_friction",
    "normal",
    "planar_step",
    "project",
    "push",
    "push_along",
    "slide",
    "support",
    "wrench",
]


class Slide(NamedTuple):
    """A way to rest."""

    time: Any
    """Time from launch to rest, in s."""
    distance: Any
    """Distance covered, in m, with the sign of the speed."""
    angle: Any
    """Angle turned, in rad, with the sign of the spin."""


def wrench(
    friction: Friction,
    twists: Any,
    load: Any,
    *,
    mu: Any = None,
    radius: Any = None,
    corners: Any = None,
    soft: Any = None,
    backend: str = "auto",
) -> Any:
    """Force and torque on the body, as `tribos.Friction.wrench`.

    Parameters
    ----------
    friction
        Friction of a patch under any law.
    twists
        Velocities in m/s and spins in rad/s, of shape (..., 3).
    load
        Normal force in N, at least 0, broadcast with the leading axes of the twists.
    mu, radius, corners
        In the place of the friction's own: see the notes on keywords.
    soft
        A speed in m/s; None for dry friction: see the notes on softening.
    backend
        ``"auto"``, ``"xla"`` or ``"callback"``.

    Examples
    --------
    Softened friction is proportional to slow motions.

    >>> import jax, tribos, tribos.jax
    >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
    >>> slow = jax.numpy.array([1e-5, 0.0, 0.0])
    >>> print(f"{tribos.jax.wrench(puck, slow, 1.7, soft=1e-3)[0]:.5f}")
    -0.00510
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners, "soft": soft}
    call = Call("wrench", friction, twists, backend=backend, **sizes)
    rows, load = call.rows("twists", twists), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Wrench(call.friction)
        return call.own(_jax_callback.applied(operation, rows, call.under(load))[0])
    return call.own(_jax_native.wrench(call.kind, call.size, rows, call.mu, load, call.soft))


def jacobian(
    friction: Friction,
    twists: Any,
    load: Any,
    *,
    mu: Any = None,
    radius: Any = None,
    corners: Any = None,
    soft: Any = None,
    backend: str = "auto",
) -> Any:
    """Derivatives of `wrench` by the twist, of shape (..., 3, 3), symmetric; 0 at rest without softening.

    The same as ``jax.jacfwd`` of `wrench` for each row, in one evaluation. Arguments as of `wrench`.

    Examples
    --------
    >>> import jax, tribos, tribos.jax
    >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
    >>> at_rest = tribos.jax.jacobian(puck, jax.numpy.zeros(3), 1.7, soft=1e-3)
    >>> print([round(float(x), 4) for x in at_rest.diagonal()])       # -510 (1, 1, (2/3 0.04 m)²)
    [-510.0, -510.0, -0.3627]
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners, "soft": soft}
    call = Call("jacobian", friction, twists, backend=backend, **sizes)
    rows, load = call.rows("twists", twists), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Wrench(call.friction)
        return call.own(_jax_callback.slope(operation, rows, call.under(load)))
    return call.own(_jax_native.jacobian(call.kind, call.size, rows, call.mu, load, call.soft))


def support(
    friction: Friction,
    twists: Any,
    load: Any,
    *,
    mu: Any = None,
    radius: Any = None,
    corners: Any = None,
    soft: Any = None,
    backend: str = "auto",
) -> Any:
    """What dry friction dissipates at each twist, in W, as `tribos.LimitSurface.support`.

    Arguments as of `wrench`; with `soft` the potential of softened friction.

    Examples
    --------
    Its gradient is minus friction.

    >>> import jax, tribos, tribos.jax
    >>> box = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
    >>> twist = jax.numpy.array([0.1, 0.2, 1.0])
    >>> slope = jax.grad(tribos.jax.support, argnums=1)(box, twist, 20.0)
    >>> print([round(float(x), 3) for x in slope])
    [3.595, 6.721, 0.163]
    >>> print(-box.wrench(twist, 20.0).round(3))
    [3.595 6.721 0.163]
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners, "soft": soft}
    call = Call("support", friction, twists, backend=backend, **sizes)
    rows, load = call.rows("twists", twists), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Support(call.friction)
        return call.own(_jax_callback.applied(operation, rows, call.under(load))[0])
    return call.own(_jax_native.support(call.kind, call.size, rows, call.mu, load, call.soft))


def gauge(
    friction: Friction,
    wrenches: Any,
    load: Any,
    *,
    mu: Any = None,
    radius: Any = None,
    corners: Any = None,
    backend: str = "auto",
) -> Any:
    """The least factor by which the limit surface must grow, as `tribos.LimitSurface.gauge`.

    It has a kink at the zero wrench, and zero as the derivative there. Keywords as of `wrench`.
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners}
    call = Call("gauge", friction, wrenches, backend=backend, **sizes)
    rows, load = call.rows("wrenches", wrenches), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Gauge(call.friction)
        return call.own(_jax_callback.applied(operation, rows, call.under(load))[0])
    return call.own(_jax_native.gauge(call.kind, call.size, rows, call.mu, load))


def normal(
    friction: Friction,
    wrenches: Any,
    *,
    radius: Any = None,
    corners: Any = None,
    backend: str = "auto",
) -> Any:
    """The motion that each push causes, as `tribos.LimitSurface.normal`; mu and load have no effect.

    Keywords as of `wrench`.
    """
    call = Call("normal", friction, wrenches, radius=radius, corners=corners, backend=backend)
    rows = call.rows("wrenches", wrenches)
    if call.kind is None:
        return call.own(_jax_callback.applied(_gradients.Normal(friction), rows)[0])
    return call.own(_jax_native.normal(call.kind, call.size, rows))


def project(
    friction: Friction,
    wrenches: Any,
    load: Any,
    *,
    length: Any = None,
    mu: Any = None,
    radius: Any = None,
    corners: Any = None,
    backend: str = "auto",
) -> Any:
    """The nearest wrench that friction carries, as `tribos.LimitSurface.project`.

    Parameters
    ----------
    friction
        Coulomb friction of a patch.
    wrenches
        Of shape (..., 3), in N and N m.
    load
        Normal force in N, at least 0.
    length
        What makes a force of a torque, in m; None for the patch's radius. An array of its own where the
        patch has a form.
    mu, radius, corners, backend
        As of `wrench`.

    Notes
    -----
    Differentiable in all arguments but the friction, to every order. Wrenches within 64 rounding errors of
    the limit surface stay as they are.
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners}
    call = Call("project", friction, wrenches, backend=backend, **sizes)
    rows, load = call.rows("wrenches", wrenches), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Project(call.friction, length_of(call.friction, length))
        return call.own(_jax_callback.applied(operation, rows, call.under(load))[0])
    if length is not None:
        length = call.number("length", length, above=True)
    return call.own(_jax_native.project(call.kind, call.size, rows, call.mu, load, length))


def planar_step(
    friction: Friction,
    twists: Any,
    pushes: Any,
    load: Any,
    *,
    mass: Any,
    inertia: Any,
    dt: Any,
    angle: Any = None,
    mu: Any = None,
    radius: Any = None,
    corners: Any = None,
    backend: str = "auto",
) -> Step:
    """The implicit step of `tribos.PlanarBody`.

    Differentiable in all but the friction, at rest too, where the patch has a form to every order; see
    `tribos.planar_step_jacobian`.

    Parameters
    ----------
    friction
        Coulomb friction of a patch.
    twists, pushes
        Velocities in m/s and spins in rad/s; other forces in N and torques in N m; (..., 3).
    load
        Normal force in N, at least 0.
    mass, inertia, dt
        In kg, kg m² and s.
    angle
        Angle in rad by which the patch is turned against the axes of twists and pushes; None for 0.
    mu, radius, corners, backend
        As of `wrench`.

    Examples
    --------
    How far a puck slides does not depend on its mass.

    >>> import jax, tribos, tribos.jax
    >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
    >>> def distance(mass):
    ...     def step(state, _):
    ...         twists, x = state
    ...         body = {"mass": mass, "inertia": 8e-4 * mass, "dt": 0.01}
    ...         after = tribos.jax.planar_step(puck, twists, jax.numpy.zeros(3), 9.81 * mass, **body)
    ...         return (after.twists, x + 0.005 * (twists[0] + after.twists[0])), None
    ...     start = (jax.numpy.array([1.0, 0.0, 20.0]), 0.0)
    ...     return jax.lax.scan(step, start, length=60)[0][1]
    >>> print(f"{jax.jit(distance)(0.17):.3f}", bool(abs(jax.grad(distance)(0.17)) < 1e-5))
    0.199 True
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners}
    call = Call("planar_step", friction, twists, backend=backend, **sizes)
    rows = [call.rows("twists", twists), call.rows("pushes", pushes)]
    load = call.number("load", load)
    given = {"mass": mass, "inertia": inertia, "dt": dt}
    body = [call.number(key, x, above=True) for key, x in given.items()]
    if angle is not None:
        angle = jnp.asarray(angle, call.type)
        call.meet("angle", angle.shape)
        rows = [_turned(row, angle, -1.0) for row in rows]
    if call.kind is None:
        operation = _gradients.PlanarStep(call.friction)
        made = _jax_callback.applied(operation, *rows, call.under(load), *body)
        after, mean, rest = made[0], made[1], made[2] > 0.5
    else:
        numbers = (call.mu, load, *body)
        after, mean, rest = _jax_native.planar_step(call.kind, call.size, *rows, *numbers)
    if angle is not None:
        after, mean = (_turned(row, angle, 1.0) for row in (after, mean))
    return Step(call.own(after), call.own(mean), rest)


def _turned(rows: Any, angle: Any, sense: float) -> Any:
    """Rows with their first two components turned about the normal."""
    cos, sin = jnp.cos(angle), sense * jnp.sin(angle)
    x, y = rows[..., 0], rows[..., 1]
    parts = (cos * x - sin * y, sin * x + cos * y, rows[..., 2] + 0.0 * cos)
    return jnp.stack(parts, axis=-1)


def slide(
    friction: Friction,
    speed: Any,
    spin: Any,
    *,
    inertia_ratio: float = 0.5,
    gravity: Any = 9.81,
    radius: Any = None,
) -> Slide:
    """Time, distance and angle until launched bodies are at rest, as `tribos.slide_jacobian`.

    Differentiable in speed, spin, gravity and radius.

    Examples
    --------
    >>> import jax, tribos, tribos.jax
    >>> puck = tribos.Friction(tribos.disk(0.08), mu=0.3)
    >>> def distance(spin):
    ...     return tribos.jax.slide(puck, 1.0, spin).distance
    >>> print(f"{distance(12.5):.4f} {jax.grad(distance)(12.5):.5f}")
    0.2166 0.00789
    """
    ratio = positive("inertia_ratio", inertia_ratio)
    operation = _gradients.Slide(friction_in("tribos.jax.slide", friction), ratio)
    # Numbers of Python take the type of the arrays.
    given = {
        key: x if isinstance(x, (bool, int, float)) else jnp.asarray(x)
        for key, x in (
            ("speed", speed),
            ("spin", spin),
            ("gravity", gravity),
            ("radius", operation.own(radius)),
        )
    }
    axes_of("tribos.jax.slide", {key: jnp.shape(x) for key, x in given.items()})
    dtype = jnp.result_type(float, *given.values())
    arrays = (jnp.asarray(x, dtype) for x in given.values())
    return Slide(*_jax_callback.applied(operation, *arrays))
