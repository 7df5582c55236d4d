"""Sides of outlines in JAX programs: how far a contact may slide along them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import jax
import jax.numpy as jnp

from tribos._forms.pushing import PointContact

# A contact with this angle to an edge's normal, in rad, is on that edge.
_PARALLEL = {"float64": 1e-9, "float32": 1e-5}


def reach_on(loops: Sequence[Any], at: PointContact) -> tuple[Any, Any]:
    """How far the side that a contact is on goes on, to the right and to the left, in m.

    Without ends where the contact's normal is not that of the nearest edge, as of a flat pusher at a corner.

    Parameters
    ----------
    loops
        Corners of shape (..., n, 2), the outer loop first, in either sense; a loop of two is a bar.
    at
        The contact.
    """
    starts, ends = _edges(loops)
    edges, off = ends - starts, at.position[..., None, :] - starts
    # Corners that repeat are an edge along no direction.
    is_point = jnp.all(edges == 0.0, axis=-1)
    length = jnp.hypot(jnp.where(is_point, 1.0, edges[..., 0]), edges[..., 1])
    along = edges / length[..., None]
    length = jnp.where(is_point, 0.0, length)
    place = jnp.sum(along * off, axis=-1)
    beyond = jnp.maximum(jnp.maximum(-place, place - length), 0.0)
    distance = jax.lax.stop_gradient(jnp.hypot(_cross(along, off), beyond))
    distance = jnp.where(is_point, jnp.inf, distance)
    finest = _PARALLEL[str(distance.dtype)]
    # The inward normal is the edge turned to the left.
    normal = jax.lax.stop_gradient(at.normal / jnp.linalg.norm(at.normal, axis=-1, keepdims=True))
    normal = normal[..., None, :]
    is_on = (jnp.abs(jnp.sum(along * normal, axis=-1)) <= finest) & (_cross(along, normal) > 0.0)
    is_on &= distance <= jnp.min(distance, axis=-1, keepdims=True) + finest * length
    which = jnp.argmin(jnp.where(is_on, distance, jnp.inf), axis=-1, keepdims=True)

    def kept(reach: Any) -> Any:
        chosen = jnp.take_along_axis(reach, which, axis=-1)[..., 0]
        return jnp.where(jnp.any(is_on, axis=-1), chosen, jnp.inf)

    # Looking along the normal, the edge leads to the right.
    return kept(length - place), kept(place)


def _edges(loops: Sequence[Any]) -> tuple[Any, Any]:
    """Starts and ends of edges that have the body to their left."""
    starts, ends = [], []
    for number, loop in enumerate(loops):
        following = jnp.roll(loop, -1, axis=-2)
        is_left = (jnp.sum(_cross(loop, following), axis=-1) >= 0.0) == (number == 0)
        is_left = is_left[..., None, None]
        starts.append(jnp.where(is_left, loop, following))
        ends.append(jnp.where(is_left, following, loop))
    return jnp.concatenate(starts, axis=-2), jnp.concatenate(ends, axis=-2)


def _cross(a: Any, b: Any) -> Any:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
