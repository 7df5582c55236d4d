"""Friction, limit surfaces, planar steps and ways to rest in JAX programs, with derivatives.

The functions take and return JAX arrays and work under ``jit``, ``vmap``, ``grad``, ``jacfwd``,
``jacrev`` and ``scan``. The numbers come from the same compiled kernel as those of numpy arrays, by
``jax.pure_callback``, on the processor; derivatives are the analytic ones, of first order.

>>> import jax, tribos, tribos.jax
>>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
>>> def power(twist):
...     return twist @ tribos.jax.wrench(puck, twist, 1.7)
>>> slope = jax.jit(jax.grad(power))(jax.numpy.array([1.0, 0.0, 20.0]))
>>> print([round(float(x), 4) + 0.0 for x in slope])
[-0.465, 0.0, -0.0044]

Notes
-----
*Precision*: the kernel computes in float64. JAX rounds arguments and results to float32 unless 64-bit
numbers are on: ``jax.config.update("jax_enable_x64", True)`` is advised where derivatives matter.

*Static arguments*: friction, `length` and `inertia_ratio` are not arrays and have no derivatives.
They are hashable, and may be ``static_argnums`` of ``jit``.

*A coefficient or a radius for each row*: friction depends on mu and load by their product, so that
a `Friction` with ``mu=1`` takes ``mu * load`` as its load, and has the derivative by mu. Equal shapes
of other sizes are one patch of size 1 whose spins and torques are scaled:

>>> disk = tribos.Friction(tribos.disk(1.0), mu=1.0)
>>> def sized(twist, mu, radius, load):
...     size = jax.numpy.array([1.0, 1.0, radius])
...     return tribos.jax.wrench(disk, twist * size, mu * load) * size
>>> bool(jax.numpy.allclose(sized(jax.numpy.array([1.0, 0.0, 20.0]), 0.3, 0.04, 1.7),
...                         puck.wrench([1.0, 0.0, 20.0], 1.7), rtol=1e-5))
True

*At rest* Coulomb friction jumps, and its derivative is infinite. A row whose derivative is infinite
passes zero on, so that it disturbs no other row of a batch: gradients through a body at rest are
zero, through `wrench` and `gauge` too. `planar_step` has finite derivatives everywhere, because an
implicit step smooths the jump, and its motion after a step that ends at rest has a derivative of
exactly zero; so a body that has come to rest passes no gradient on, which is right but may surprise
an optimiser. Where slopes through rest are needed, `tribos.softened` has a law that is smooth.

*Cost*: a callback costs 0.1 to 0.3 ms a call, whatever it computes; per item the kernel's time and
that of three copies. Many items a call cost little more than those of numpy arrays. The first call
with a friction and with shapes takes tens of milliseconds, in which JAX compiles it; a derivative
outside of ``jit`` takes some milliseconds in every call.
"""

from __future__ import annotations

from functools import partial
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax.custom_derivatives import SymbolicZero

from tribos import _gradients
from tribos._checks import positive
from tribos._forms.pushed_path import Journey
from tribos._forms.pushing import PointContact, Push
from tribos._friction import Friction
from tribos._gradients import Operation, finite_derivatives, length_of
from tribos._jax_pushing import push, push_along
from tribos._planar import Step

__all__ = [
    "Journey",
    "PointContact",
    "Push",
    "Slide",
    "Step",
    "gauge",
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
    """What dry friction dissipates at each twist, in W, as `tribos.LimitSurface.support`.

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
    (made,) = _apply(_gradients.Support(friction), twists, load)
    return made


def gauge(friction: Friction, wrenches: Any, load: Any) -> Any:
    """The least factor by which the limit surface must grow, as `tribos.LimitSurface.gauge`.

    It has a kink at the zero wrench, and zero as the derivative there.
    """
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
    operation = _gradients.PlanarStep(friction)
    if angle is None:
        after, mean, rest = _apply(operation, twists, pushes, load, mass, inertia, dt)
        return Step(after, mean, rest > 0.5)
    to_patch = (_turned(twists, angle, -1.0), _turned(pushes, angle, -1.0))
    after, mean, rest = _apply(operation, *to_patch, load, mass, inertia, dt)
    return Step(_turned(after, angle, 1.0), _turned(mean, angle, 1.0), rest > 0.5)


def _turned(rows: Any, angle: Any, sense: float) -> Any:
    """Rows with their first two components turned about the normal."""
    rows, angle = jnp.asarray(rows), jnp.asarray(angle)
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
    operation = _gradients.Slide(friction, positive("inertia_ratio", inertia_ratio))
    return Slide(*_apply(operation, speed, spin, gravity, operation.own(radius)))


def _apply(operation: Operation, *given: Any) -> tuple[Any, ...]:
    """The operation on arrays whose leading axes have one rank and whose type is one."""
    # Numbers of Python take the type of the arrays.
    typed = [x if isinstance(x, (bool, int, float)) else jnp.asarray(x) for x in given]
    dtype = jnp.result_type(float, *typed)
    arrays = [jnp.asarray(x, dtype) for x in typed]
    for array, row in zip(arrays, operation.inputs, strict=True):
        if row and array.shape[-1:] != (row,):
            raise ValueError(f"twists and wrenches must have shape (..., {row}), not {array.shape}")
    ranks = [array.ndim - (row > 0) for array, row in zip(arrays, operation.inputs, strict=True)]
    missing = [(1,) * (max(ranks) - rank) for rank in ranks]
    aligned = [
        array.reshape(more + array.shape) for array, more in zip(arrays, missing, strict=True)
    ]
    made: tuple[Any, ...] = _compiled(operation, *aligned)
    return made


def _axes(operation: Operation, given: tuple[Any, ...]) -> tuple[int, ...]:
    """The leading axes of arguments together."""
    rows = zip(given, operation.inputs, strict=True)
    return np.broadcast_shapes(*(array.shape[:-1] if row else array.shape for array, row in rows))


def _called(
    operation: Operation, of: Any, rows: list[tuple[int, ...]], given: tuple[Any, ...]
) -> tuple[Any, ...]:
    """What a function of numpy arrays makes, in the arguments' type and over all their leading axes."""
    dtype = given[0].dtype

    def call(*arrays: Any) -> tuple[Any, ...]:
        numbers = [np.asarray(array) for array in arrays]
        axes = _axes(operation, tuple(numbers))
        made = zip(of(*numbers), rows, strict=True)
        return tuple(np.broadcast_to(np.asarray(one, dtype), axes + row) for one, row in made)

    axes = _axes(operation, given)
    results = tuple(
        jax.ShapeDtypeStruct(axes + row, dtype)  # type: ignore[no-untyped-call, unused-ignore]
        for row in rows
    )
    made: tuple[Any, ...] = jax.pure_callback(call, results, *given, vmap_method="expand_dims")
    return made


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _operate(operation: Operation, *given: Any) -> tuple[Any, ...]:
    rows = [(row,) * (row > 0) for row in operation.outputs]
    return _called(operation, operation.value, rows, given)


@partial(jax.custom_jvp, nondiff_argnums=(0, 1))
def _slopes(
    operation: Operation, pairs: tuple[tuple[int, int], ...], *given: Any
) -> tuple[Any, ...]:
    """The outputs, and derivatives of pairs of an output and an input."""

    def every(*arrays: Any) -> list[Any]:
        values, by = finite_derivatives(operation, *arrays)
        return [*values, *(by[output][at] for output, at in pairs)]

    rows = [(row,) * (row > 0) for row in operation.outputs]
    for output, at in pairs:
        rows.append(tuple(n for n in (operation.outputs[output], operation.inputs[at]) if n))
    return _called(operation, every, rows, given)


def _refuse(*_: Any) -> Any:
    raise NotImplementedError(
        "tribos.jax has first derivatives only: difference them for second ones, "
        "or take jax.lax.stop_gradient of the inner one"
    )


_slopes.defjvp(_refuse)


def _rule(
    operation: Operation, given: tuple[Any, ...], tangents: tuple[Any, ...]
) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """Values, and the derivatives in a direction: linear in it, so that reverse mode transposes them."""
    moving = [at for at, tangent in enumerate(tangents) if not isinstance(tangent, SymbolicZero)]
    pairs = [(output, at) for output in operation.smooth for at in moving]
    found = _slopes(operation, tuple(pairs), *given)
    count = len(operation.outputs)
    values = found[:count]
    rates = [jnp.zeros_like(value) for value in values]
    for (output, at), matrix in zip(pairs, found[count:], strict=True):
        i, j = "i" if operation.outputs[output] else "", "j" if operation.inputs[at] else ""
        rates[output] = rates[output] + jnp.einsum(
            f"...{i}{j},...{j}->...{i}", matrix, tangents[at]
        )
    return tuple(values), tuple(rates)


_operate.defjvp(_rule, symbolic_zeros=True)
# Without it every call outside of a compiled function would compile its callback anew.
_compiled = jax.jit(_operate, static_argnums=0)
