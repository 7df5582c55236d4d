"""Friction, limit surfaces, planar steps and ways to rest in PyTorch programs, with derivatives.

The functions take and return tensors; their names and keywords are those of `tribos.jax`.

>>> import torch, tribos, tribos.torch
>>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
>>> twist = torch.tensor([1.0, 0.0, 20.0], dtype=torch.float64, requires_grad=True)
>>> tribos.torch.support(puck, twist, 1.7).backward()
>>> print(twist.grad.numpy().round(4) + 0.0)                      # minus friction
[0.465  0.     0.0044]

Coefficients, sizes and loads may be tensors, one for each environment, and have derivatives:

>>> mu = torch.tensor([0.2, 0.4])
>>> forces = tribos.torch.wrench(puck, torch.tensor([1.0, 0.0, 0.0]), 1.7, mu=mu, radius=0.05)
>>> print([round(float(x), 4) for x in forces[:, 0]])
[-0.34, -0.68]

Notes
-----
*Backends*: ``"kernel"`` is the compiled kernel, on the processor; ``backward`` uses its analytic derivatives. ``"tensors"``
is PyTorch's own operations, the forms of `tribos.jax`: Coulomb friction of `tribos.disk`, `ring`, `punch`, `hertz`,
`paraboloid`, and of `box` and `polygon` under uniform pressure, on every device, with derivatives of every order. ``"auto"``
takes the kernel for tensors on the processor and the forms on devices and for `radius`, `corners`
and `soft`. ``backward(create_graph=True)`` follows the form with either. All else, and `slide`, has tensors on the processor
and first derivatives.

*Precision*: results have the type that the tensors have together (those without axes count where there are no others),
or torch's default type for numbers; derivatives that matter want float64. The kernel computes in float64, forms in the
tensors' type: friction is right to 2e-15 of the largest force and torque in float64 and 3e-7 in float32 (ring 6e-7).
float16 and bfloat16 are computed in float32.

*Keywords* of all functions with a form: ``mu`` takes the place of the friction's own coefficient; ``radius`` (round
patches) and ``corners`` of shape (..., n, 2) in m (`box`, `polygon`; in either sense, repeated ones count once, so that
unlike polygons make one tensor) that of the patch's. Leading axes of all arguments are broadcast together.

*At rest* Coulomb friction jumps, and its derivative is infinite. Values and derivatives of a row at rest are zero, so that
it disturbs no other row of a batch. `planar_step` has finite derivatives everywhere, and its motion after a step that ends
at rest has a derivative of exactly zero. NaN gives NaN in its row alone. Negative loads and coefficients
are refused where they are numbers or arrays of numpy, and by the kernel; NaN comes of them in forms, and of sizes, masses and time steps
that are not above 0.

*Softening*: ``soft`` is a speed in m/s. With D the power of dry friction over ``mu * load``, a speed, softened friction is
D/sqrt(D² + soft²) times dry friction, see `tribos.jax`. `tribos.softened` has another law that is smooth at rest.

*Cost*: forms are hundreds of small operations: a call takes some 0.3 ms for a wrench, 2 ms for a step of round patches and
60 ms of polygons, whose searches go on until the last row has ended, however few the rows are; a call of the kernel 0.05 ms.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import torch  # type: ignore[import-not-found, unused-ignore]

from tribos import _gradients, _torch_forms, _torch_kernel
from tribos._arguments import friction_in
from tribos._checks import positive
from tribos._friction import Friction
from tribos._gradients import length_of
from tribos._step import Step
from tribos._torch_arguments import Call, rest_arguments
from tribos._torch_manifold import manifold_friction

__all__ = [
    "Slide",
    "Step",
    "gauge",
    "jacobian",
    "manifold_friction",
    "normal",
    "planar_step",
    "project",
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
        ``"auto"``, ``"tensors"`` or ``"kernel"``: see the notes on backends.

    Examples
    --------
    Softened friction is proportional to slow motions.

    >>> import torch, tribos, tribos.torch
    >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
    >>> slow = torch.tensor([1e-5, 0.0, 0.0])
    >>> print(f"{float(tribos.torch.wrench(puck, slow, 1.7, soft=1e-3)[0]):.5f}")
    -0.00510
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners, "soft": soft}
    call = Call("wrench", friction, twists, load, backend=backend, **sizes)
    rows, load = call.rows("twists", twists), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Wrench(call.friction)
        return call.own(_torch_kernel.applied(operation, rows, call.under(load))[0])
    return call.own(_torch_forms.wrench(call.kind, call.size, rows, call.under(load), call.soft))


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

    In one evaluation, for each row. Arguments as of `wrench`; it has derivatives in turn where the patch has a form.

    Examples
    --------
    >>> import torch, tribos, tribos.torch
    >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
    >>> at_rest = tribos.torch.jacobian(puck, torch.zeros(3), 1.7, soft=1e-3)
    >>> print([round(float(x), 4) for x in at_rest.diagonal()])       # -510 (1, 1, (2/3 0.04 m)²)
    [-510.0, -510.0, -0.3627]
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners, "soft": soft}
    call = Call("jacobian", friction, twists, load, backend=backend, **sizes)
    rows, load = call.rows("twists", twists), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Wrench(call.friction)
        return call.own(_torch_kernel.slope(operation, rows, call.under(load)))
    return call.own(_torch_forms.jacobian(call.kind, call.size, rows, call.under(load), call.soft))


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

    >>> import torch, tribos, tribos.torch
    >>> box = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
    >>> twist = torch.tensor([0.1, 0.2, 1.0], requires_grad=True)
    >>> tribos.torch.support(box, twist, 20.0).backward()
    >>> print([round(float(x), 3) for x in twist.grad])
    [3.595, 6.721, 0.163]
    >>> print(-box.wrench([0.1, 0.2, 1.0], 20.0).round(3))
    [3.595 6.721 0.163]
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners, "soft": soft}
    call = Call("support", friction, twists, load, backend=backend, **sizes)
    rows, load = call.rows("twists", twists), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Support(call.friction)
        return call.own(_torch_kernel.applied(operation, rows, call.under(load))[0])
    return call.own(_torch_forms.support(call.kind, call.size, rows, call.under(load), call.soft))


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
    call = Call("gauge", friction, wrenches, load, backend=backend, **sizes)
    rows, load = call.rows("wrenches", wrenches), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Gauge(call.friction)
        return call.own(_torch_kernel.applied(operation, rows, call.under(load))[0])
    return call.own(_torch_forms.gauge(call.kind, call.size, rows, call.under(load)))


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
    sizes = {"radius": radius, "corners": corners}
    call = Call("normal", friction, wrenches, backend=backend, **sizes)
    rows = call.rows("wrenches", wrenches)
    if call.kind is None:
        return call.own(_torch_kernel.applied(_gradients.Normal(friction), rows)[0])
    return call.own(_torch_forms.normal(call.kind, call.size, rows))


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
    Differentiable in all arguments but the friction; where the patch has a form to every order. Wrenches within 64 rounding errors of
    the limit surface stay as they are.
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners}
    call = Call("project", friction, wrenches, load, length=length, backend=backend, **sizes)
    rows, load = call.rows("wrenches", wrenches), call.number("load", load)
    if call.kind is None:
        operation = _gradients.Project(call.friction, length_of(call.friction, length))
        return call.own(_torch_kernel.applied(operation, rows, call.under(load))[0])
    if length is not None:
        length = call.number("length", length, above=True)
    return call.own(_torch_forms.project(call.kind, call.size, rows, call.under(load), length))


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

    >>> import torch, tribos, tribos.torch
    >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
    >>> def distance(mass):
    ...     twists, x = torch.tensor([1.0, 0.0, 20.0]), 0.0
    ...     body = {"mass": mass, "inertia": 8e-4 * mass, "dt": 0.01}
    ...     for _ in range(60):
    ...         after = tribos.torch.planar_step(puck, twists, torch.zeros(3), 9.81 * mass, **body)
    ...         twists, x = after.twists, x + 0.005 * (twists[0] + after.twists[0])
    ...     return x
    >>> mass = torch.tensor(0.17, requires_grad=True)
    >>> found = distance(mass)
    >>> (slope,) = torch.autograd.grad(found, mass)
    >>> print(f"{found.item():.3f}", bool(abs(slope) < 1e-5))
    0.199 True
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners}
    given = {"mass": mass, "inertia": inertia, "dt": dt}
    everything = (twists, pushes, load, mass, inertia, dt, angle)
    call = Call("planar_step", friction, *everything, backend=backend, **sizes)
    rows = [call.rows("twists", twists), call.rows("pushes", pushes)]
    load = call.number("load", load)
    body = [call.number(key, x, above=True) for key, x in given.items()]
    if angle is not None:
        angle = call.angle(angle)
        rows = [_turned(row, angle, -1.0) for row in rows]
    if call.kind is None:
        operation = _gradients.PlanarStep(call.friction)
        made = _torch_kernel.applied(operation, *rows, call.under(load), *body)
        after, mean, rest = made[0], made[1], made[2] > 0.5
    else:
        limit = call.under(load)
        numbers = (limit, *body)
        after, mean, rest = _torch_forms.planar_step(call.kind, call.size, *rows, *numbers)
    if angle is not None:
        after, mean = (_turned(row, angle, 1.0) for row in (after, mean))
    return Step(call.own(after), call.own(mean), rest)


def _turned(rows: Any, angle: Any, sense: float) -> Any:
    """Rows with their first two components turned about the normal."""
    cos, sin = torch.cos(angle), sense * torch.sin(angle)
    x, y = rows[..., 0], rows[..., 1]
    parts = (cos * x - sin * y, sin * x + cos * y, rows[..., 2] + 0.0 * cos)
    return torch.stack(parts, dim=-1)


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
    >>> import torch, tribos, tribos.torch
    >>> puck = tribos.Friction(tribos.disk(0.08), mu=0.3)
    >>> spin = torch.tensor(12.5, requires_grad=True)
    >>> distance = tribos.torch.slide(puck, 1.0, spin).distance
    >>> distance.backward()
    >>> print(f"{distance.item():.4f} {spin.grad.item():.5f}")
    0.2166 0.00789
    """
    name = "tribos.torch.slide"
    ratio = positive("inertia_ratio", inertia_ratio)
    operation = _gradients.Slide(friction_in(name, friction), ratio)
    given = {"speed": speed, "spin": spin, "gravity": gravity, "radius": operation.own(radius)}
    tensors, own = rest_arguments(name, given)
    return Slide(*(made.to(own) for made in _torch_kernel.applied(operation, *tensors)))
