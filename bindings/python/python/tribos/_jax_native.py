"""Operations on patches that have a form, compiled by XLA for any device, one program a form and shapes."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from tribos._forms import sets, soft, step, xla
from tribos._forms.form import Form
from tribos._forms.of_friction import FLAT, form_of

_of_kind = partial(jax.jit, static_argnums=0)


def _prepared(
    kind: str, size: Any, rows: Sequence[Any], numbers: Sequence[Any]
) -> tuple[Form, Any, list[Any]]:
    """The form, the leading axes of all arguments together, and the rows over them."""
    shapes = [row.shape[:-1] for row in rows]
    shapes += [number.shape for number in numbers if number is not None]
    whole = np.broadcast_shapes(*shapes, size.shape[:-2] if kind == FLAT else size.shape)
    return form_of(kind, size), whole, [jnp.broadcast_to(row, (*whole, 3)) for row in rows]


@_of_kind
def wrench(kind: str, size: Any, twists: Any, mu: Any, load: Any, speed: Any) -> Any:
    form, whole, (twists,) = _prepared(kind, size, (twists,), (mu, load, speed))
    return soft.wrench(xla, form, twists, jnp.broadcast_to(mu * load, whole), speed)


@_of_kind
def support(kind: str, size: Any, twists: Any, mu: Any, load: Any, speed: Any) -> Any:
    form, whole, (twists,) = _prepared(kind, size, (twists,), (mu, load, speed))
    return soft.support(xla, form, twists, jnp.broadcast_to(mu * load, whole), speed)


@_of_kind
def jacobian(kind: str, size: Any, twists: Any, mu: Any, load: Any, speed: Any) -> Any:
    form, whole, (twists,) = _prepared(kind, size, (twists,), (mu, load, speed))
    return soft.jacobian(xla, form, twists, jnp.broadcast_to(mu * load, whole), speed)


@_of_kind
def gauge(kind: str, size: Any, wrenches: Any, mu: Any, load: Any) -> Any:
    form, whole, (wrenches,) = _prepared(kind, size, (wrenches,), (mu, load))
    return sets.gauge(xla, form, wrenches, jnp.broadcast_to(mu * load, whole))


@_of_kind
def normal(kind: str, size: Any, wrenches: Any) -> Any:
    form, _, (wrenches,) = _prepared(kind, size, (wrenches,), ())
    return sets.normal(xla, form, wrenches)


@_of_kind
def project(kind: str, size: Any, wrenches: Any, mu: Any, load: Any, length: Any) -> Any:
    form, whole, (wrenches,) = _prepared(kind, size, (wrenches,), (mu, load, length))
    length = form.reach(xla) if length is None else length
    return sets.project(xla, form, wrenches, jnp.broadcast_to(mu * load, whole), length)[0]


@_of_kind
def planar_step(
    kind: str,
    size: Any,
    twists: Any,
    pushes: Any,
    mu: Any,
    load: Any,
    mass: Any,
    inertia: Any,
    dt: Any,
) -> Any:
    numbers = (mu, load, mass, inertia, dt)
    form, whole, (twists, pushes) = _prepared(kind, size, (twists, pushes), numbers)
    limit = jnp.broadcast_to(mu * load, whole)
    return step.planar_step(xla, form, twists, pushes, limit, mass, inertia, dt)
