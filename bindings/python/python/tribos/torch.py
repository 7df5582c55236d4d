"""Friction, limit surfaces, planar steps and ways to rest in PyTorch programs, with derivatives.

The functions take and return tensors. On the processor the numbers come from the same compiled kernel as
those of numpy arrays, and ``backward`` uses its analytic derivatives.

>>> import torch, tribos, tribos.torch
>>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
>>> twist = torch.tensor([1.0, 0.0, 20.0], dtype=torch.float64, requires_grad=True)
>>> tribos.torch.support(puck, twist, 1.7).backward()
>>> print(twist.grad.numpy().round(4) + 0.0)                      # minus friction
[0.465  0.     0.0044]

Notes
-----
*Devices and second derivatives*: Coulomb friction of `tribos.disk`, `ring`, `punch`, `hertz`, `paraboloid`, and of `box`
and `polygon` under uniform pressure, has a form in PyTorch's own operations, which are those of `tribos.jax`. Tensors on
other devices are computed by it, in their own type; ``backward(create_graph=True)`` follows it on every device, so that
derivatives of every order are right. All else has tensors on the processor and first derivatives.

*Precision*: the kernel computes in float64; results have the type that the tensors have together, or
torch's default type for numbers. Derivatives that matter want float64.

*Constants*: friction, `length` and `inertia_ratio` have no derivatives. Friction depends on mu and load by their product: a derivative by mu is one by the load, of a `tribos.Friction`
with ``mu=1``.

*At rest* Coulomb friction jumps, and its derivative is infinite. A row whose derivative is infinite
passes zero on, so that it disturbs no other: gradients through a body at rest are zero.
`planar_step` has finite derivatives everywhere, and its motion after a step that ends at rest has a
derivative of exactly zero. `tribos.softened` has a law that is smooth at rest.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import torch  # type: ignore[import-not-found, unused-ignore]
from torch.autograd.function import (  # type: ignore[import-not-found, unused-ignore]
    once_differentiable,
)

from tribos import _gradients, _torch_forms
from tribos._checks import positive
from tribos._friction import Friction
from tribos._gradients import Operation, finite_derivatives, length_of
from tribos._planar import Step

__all__ = [
    "Slide",
    "Step",
    "gauge",
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


def wrench(friction: Friction, twists: Any, load: Any) -> Any:
    """Force and torque on the body, as `tribos.Friction.wrench`.

    Parameters
    ----------
    friction
        Friction of a patch under any law.
    twists
        Velocities in m/s and spins in rad/s, of shape (..., 3).
    load
        Normal force in N, at least 0, broadcast with the leading axes of the twists.
    """
    (made,) = _apply(_gradients.Wrench(friction), twists, load)
    return made


def support(friction: Friction, twists: Any, load: Any) -> Any:
    """What dry friction dissipates at each twist, in W, as `tribos.LimitSurface.support`."""
    (made,) = _apply(_gradients.Support(friction), twists, load)
    return made


def gauge(friction: Friction, wrenches: Any, load: Any) -> Any:
    """The least factor by which the limit surface must grow, as `tribos.LimitSurface.gauge`."""
    (made,) = _apply(_gradients.Gauge(friction), wrenches, load)
    return made


def normal(friction: Friction, wrenches: Any) -> Any:
    """The motion that each push causes, as `tribos.LimitSurface.normal`; the load has no effect."""
    (made,) = _apply(_gradients.Normal(friction), wrenches)
    return made


def project(friction: Friction, wrenches: Any, load: Any, *, length: float | None = None) -> Any:
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
        What makes a force of a torque, in m; None for the patch's radius.
    """
    (made,) = _apply(_gradients.Project(friction, length_of(friction, length)), wrenches, load)
    return made


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
) -> Step:
    """The implicit step of `tribos.PlanarBody`.

    Differentiable in all but the friction, at rest too; see `tribos.planar_step_jacobian`.

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
    """
    operation = _gradients.PlanarStep(friction)
    if angle is None:
        after, mean, rest = _apply(operation, twists, pushes, load, mass, inertia, dt)
        return Step(after, mean, rest > 0.5)
    to_patch = (_turned(twists, angle, -1.0), _turned(pushes, angle, -1.0))
    after, mean, rest = _apply(operation, *to_patch, load, mass, inertia, dt)
    return Step(_turned(after, angle, 1.0), _turned(mean, angle, 1.0), rest > 0.5)


def _turned(rows: Any, angle: Any, sense: float) -> Any:
    """Rows with their first two components turned about the normal."""
    rows, angle = torch.as_tensor(rows), torch.as_tensor(angle)
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
    """
    operation = _gradients.Slide(friction, positive("inertia_ratio", inertia_ratio))
    return Slide(*_apply(operation, speed, spin, gravity, operation.own(radius)))


def _apply(operation: Operation, *given: Any) -> tuple[Any, ...]:
    """The operation on tensors of one type."""
    made = [x for x in given if isinstance(x, torch.Tensor)]
    dtype = torch.get_default_dtype()
    if made:
        dtype = made[0].dtype
        for tensor in made[1:]:
            dtype = torch.promote_types(dtype, tensor.dtype)
        if not dtype.is_floating_point:
            dtype = torch.get_default_dtype()
    devices = {x.device for x in made}
    device = devices.pop() if devices else torch.device("cpu")
    if devices:
        raise ValueError(f"tensors must be on one device, not on {device} and {devices.pop()}")
    tensors = [torch.as_tensor(x, dtype=dtype, device=device) for x in given]
    results: tuple[Any, ...]
    if device.type != "cpu":
        if not _torch_forms.has_form(operation):
            raise ValueError(f"tensors must be on the processor for {operation!r}, not on {device}")
        results = _torch_forms.applied(operation, *tensors)
    elif _torch_forms.has_form(operation):
        results = _OperatedTwice.apply(operation, *tensors)
    else:
        results = _Operated.apply(operation, *tensors)
    return results


class _Operated(torch.autograd.Function):  # type: ignore[misc, unused-ignore]
    """An operation of the compiled kernel as a node of the graph."""

    @staticmethod
    def forward(ctx: Any, operation: Operation, *given: Any) -> tuple[Any, ...]:
        return _forward(ctx, operation, *given)

    @staticmethod
    @once_differentiable  # type: ignore[misc, untyped-decorator, unused-ignore]
    def backward(ctx: Any, *gradients: Any) -> tuple[Any, ...]:
        return _backward(ctx, *gradients)


class _OperatedTwice(torch.autograd.Function):  # type: ignore[misc, unused-ignore]
    """The same with a form, which derivatives of derivatives follow."""

    @staticmethod
    def forward(ctx: Any, operation: Operation, *given: Any) -> tuple[Any, ...]:
        return _forward(ctx, operation, *given)

    @staticmethod
    def backward(ctx: Any, *gradients: Any) -> tuple[Any, ...]:
        if not torch.is_grad_enabled():
            return _backward(ctx, *gradients)
        # Views, lest ways from one argument to another count.
        at = [x.view_as(x) for x in ctx.saved_tensors[: len(ctx.shapes)]]
        operation = ctx.operation
        made = _torch_forms.applied(operation, *at)
        outputs = [made[output] for output in operation.smooth]
        weights = [gradients[output] for output in operation.smooth]
        slopes = iter(
            torch.autograd.grad(
                outputs,
                [at[n] for n in ctx.needed],
                weights,
                create_graph=True,
                allow_unused=True,
            )
        )
        results: list[Any] = [None] * (1 + len(ctx.shapes))
        for n in ctx.needed:
            results[1 + n] = next(slopes)
        return tuple(results)


def _forward(ctx: Any, operation: Operation, *given: Any) -> tuple[Any, ...]:
    """The outputs; the arguments and derivatives are kept."""
    dtype = given[0].dtype
    arrays = [tensor.detach().numpy() for tensor in given]
    ctx.operation = operation
    ctx.needed = [at for at, is_needed in enumerate(ctx.needs_input_grad[1:]) if is_needed]
    slopes: list[Any] = []
    if ctx.needed:
        values, by = finite_derivatives(operation, *arrays)
        slopes = [by[output][at] for at in ctx.needed for output in operation.smooth]
    else:
        values = operation.value(*arrays)
    ctx.shapes = [tensor.shape for tensor in given]
    ctx.save_for_backward(*given, *(_tensor(slope, dtype) for slope in slopes))
    made = tuple(_tensor(value, dtype) for value in values)
    constant = [one for at, one in enumerate(made) if at not in operation.smooth]
    ctx.mark_non_differentiable(*constant)
    return made


def _backward(ctx: Any, *gradients: Any) -> tuple[Any, ...]:
    """Gradients by the derivatives that are kept."""
    operation = ctx.operation
    slopes = iter(ctx.saved_tensors[len(ctx.shapes) :])
    results: list[Any] = [None] * (1 + len(ctx.shapes))
    for at in ctx.needed:
        total: Any = 0.0
        for output in operation.smooth:
            i, j = "i" if operation.outputs[output] else "", "j" if operation.inputs[at] else ""
            formula = f"...{i}{j},...{i}->...{j}"
            total = total + torch.einsum(formula, next(slopes), gradients[output])
        results[1 + at] = total.sum_to_size(ctx.shapes[at])
    return tuple(results)


def _tensor(array: Any, dtype: Any) -> Any:
    return torch.as_tensor(np.asarray(array), dtype=dtype)
