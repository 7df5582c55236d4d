"""Friction of contact manifolds in JAX programs."""

from __future__ import annotations

from functools import partial
from typing import Any

import jax
import jax.numpy as jnp

from tribos._arguments import axes_of, check_sign
from tribos._forms import xla
from tribos._forms.manifold import ARGUMENTS, SIGNS, terms_in
from tribos._forms.manifold import manifold_friction as _form


def manifold_friction(
    impulses: Any,
    twist: Any,
    force: Any,
    lever: Any,
    *,
    k: Any,
    kt: Any,
    slip: Any = 1.0,
    curve: Any = "area",
    steps: int = 2,
) -> tuple[Any, Any]:
    """What friction of a contact manifold carries of the impulses that would stop it: the nearest by energy.

    As ``tribos_manifold_friction`` of the C header. Derivatives by all arguments but `steps`, of first and second
    order, are those of the nearest point, finite everywhere.

    Parameters
    ----------
    impulses, twist
        Tangential impulses in N s, of shape (..., 2), and angular ones in N m s, of shape (...).
    force, lever
        Largest tangential impulse, mu times the sum of normal ones, in N s, and the contacts' mean distance from the
        friction centre in m, at least 0.
    k, kt
        Inverse effective masses in 1/kg, above 0, and 1/(kg m²), at least 0.
    slip
        Dynamic over static coefficient, above 0 and at most 1.
    curve
        ``"area"`` for faces, ``"points"`` for rings and feet at corners, ``"ellipsoid"``, or its three coefficients.
    steps
        Newton steps; 2 give 5e-4 of the limits for ratios of the energies of 0.01 to 100, 3 give 1e-5.

    Examples
    --------
    >>> import jax, tribos.jax
    >>> p, twist = tribos.jax.manifold_friction(
    ...     jax.numpy.array([1.0, 0.0]), 0.05, 0.5, 0.1, k=1.0, kt=100.0
    ... )
    >>> print([round(float(x), 3) for x in (p[0], twist)])
    [0.445, 0.018]
    """
    name = "tribos.jax.manifold_friction"
    given = (twist, force, lever, k, kt, slip, *terms_in(name, curve, steps))
    for key, x in zip(ARGUMENTS[1:], given):
        if key in SIGNS:
            check_sign(name, key, x, above=SIGNS[key])
    rows = jnp.asarray(impulses)
    if rows.shape[-1:] != (2,):
        raise ValueError(f"{name}: impulses must have shape (..., 2), not {rows.shape}")
    own = rows.dtype if jnp.issubdtype(rows.dtype, jnp.floating) else jnp.result_type(float)
    # Half precision has too few digits to compute with.
    dtype = jnp.dtype(jnp.float32) if jnp.dtype(own).itemsize < 4 else own
    numbers = [jnp.asarray(x, dtype) for x in given]
    shapes = {key: x.shape for key, x in zip(ARGUMENTS[1:], numbers)}
    axes_of(name, {ARGUMENTS[0]: rows.shape[:-1], **shapes})
    made = _carried(steps, rows.astype(dtype), *numbers)
    return made[0].astype(own), made[1].astype(own)


@partial(jax.jit, static_argnums=0)
def _carried(
    steps: int, p: Any, twist: Any, force: Any, lever: Any, k: Any, kt: Any, slip: Any, *curve: Any
) -> tuple[Any, Any]:
    axes = jnp.broadcast_shapes(p.shape[:-1], *(x.shape for x in (twist, force, lever, k, kt)))
    axes = jnp.broadcast_shapes(axes, slip.shape, *(term.shape for term in curve))
    p, twist = jnp.broadcast_to(p, (*axes, 2)), jnp.broadcast_to(twist, axes)
    terms = (curve[0], curve[1], curve[2])
    return _form(xla, p, twist, force, lever, k=k, kt=kt, slip=slip, curve=terms, steps=steps)
