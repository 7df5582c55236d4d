"""Operations on patches that have a form, compiled by XLA for any device, one program a form and shapes."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from tribos._forms import sets, soft, step, xla
from tribos._forms.coulomb import ORDERS, Pressure
from tribos._forms.form import Form
from tribos._forms.polygon import Flat
from tribos._forms.round import Round
from tribos._friction import Friction
from tribos._patches import outline

#: The form of polygons; others have the names of their pressures.
FLAT = "flat"

_of_kind = partial(jax.jit, static_argnums=0)


def is_dry(friction: Friction) -> bool:
    """Whether friction does not depend on the speed."""
    law = friction.law
    return law.name == "coulomb" or (law.name == "power" and law.parameters["alpha"] == 0.0)


def kind_of(friction: Friction) -> str | None:
    """The form of a friction, None if it has none."""
    patch = friction.patch
    if not is_dry(friction):
        return None
    if patch.kind in ORDERS:
        return patch.kind
    is_flat = patch.kind in ("box", "polygon")
    return FLAT if is_flat and not {"holes", "centre"} & dict(patch._parameters).keys() else None


def size_of(friction: Friction) -> Any:
    """The numbers that the form of a friction is made from: its radius or its corners, in m."""
    patch = friction.patch
    return patch.radius if patch.kind in ORDERS else outline(patch)[0]


def _prepared(
    kind: str, size: Any, rows: Sequence[Any], numbers: Sequence[Any]
) -> tuple[Form, Any, list[Any]]:
    """The form, the leading axes of all arguments together, and the rows over them."""
    shapes = [row.shape[:-1] for row in rows]
    shapes += [number.shape for number in numbers if number is not None]
    whole = np.broadcast_shapes(*shapes, size.shape[:-2] if kind == FLAT else size.shape)
    form: Form = Flat(size) if kind == FLAT else Round(Pressure(kind), size)
    return form, whole, [jnp.broadcast_to(row, (*whole, 3)) for row in rows]


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
    form, whole, rows = _prepared(kind, size, (twists, pushes), numbers)
    limit = jnp.broadcast_to(mu * load, whole)
    return step.planar_step(xla, form, *rows, limit, mass, inertia, dt)
