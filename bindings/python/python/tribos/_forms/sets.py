"""Limit surfaces of forms: support, gauge, normal and nearest wrench, with derivatives of every order.

What a search finds has the derivatives of the equations that it solves. With g the push and H the second derivatives of
the support at a normal n of length 1, and k = mu N:

    on a ray       x = c g(n)              n·dx = D dc + c n·dg,         c H dn = P (dx - c dg)
    nearest        y = k g(n) + l n        dl = n·b,  (l + k H) dn = P b,    b = dy - g dk - k dg

where P leaves the part across n and dg is the change of g by the form's arrays. H n = 0, so that on that part
(l + k H)⁻¹ = (l + t - k H)/(l² + l t + d), t and d the sums of k H's diagonal and of its principal minors.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tribos._forms.form import Form
from tribos._forms.space import Space

#: A wrench whose gauge exceeds 1 by no more than so many rounding errors counts as carried, as in the kernel.
COLLAR = 64.0


def parts(rows: Any) -> tuple[Any, Any, Any]:
    """The three components of twists or wrenches."""
    return rows[..., 0], rows[..., 1], rows[..., 2]


def dot(a: Any, b: Any) -> Any:
    """The sum of the products of components."""
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def is_none(rows: Any) -> Any:
    """Whether all three components are 0."""
    x, y, z = parts(rows)
    return (x == 0.0) & (y == 0.0) & (z == 0.0)


def gauge(space: Space, form: Form, wrenches: Any, limit: Any) -> Any:
    """The least factor by which the set under a force limit must grow to hold wrenches.

    0 for none, infinite without a limit, both with derivatives 0; NaN under a negative one.
    """
    nothing = is_none(wrenches)
    _, gauges = _on_rays(space, form, wrenches, nothing)
    has_none = limit == 0.0
    made = gauges / space.where(has_none, 1.0, _not_negative(space, limit))
    infinite = space.constant(float("inf"), made)
    return space.where(nothing, 0.0, space.where(has_none, infinite, made))


def normal(space: Space, form: Form, wrenches: Any) -> Any:
    """The motion that pushes cause, with |velocity|² + (spin reach)² = 1; 0 for none, with derivatives 0."""
    nothing = is_none(wrenches)
    x, y, spin = parts(_on_rays(space, form, wrenches, nothing)[0])
    share = space.where(nothing, 0.0, 1.0 + 0.0 * x)
    return space.stack((share * x, share * y, share * spin / form.reach(space)))


def project(space: Space, form: Form, wrenches: Any, limit: Any, length: Any) -> tuple[Any, Any]:
    """The nearest wrenches of the set by |force|² + (torque/length)², and whether the given ones are in it."""
    x, y, torque = parts(wrenches)
    scaled = space.stack((x, y, torque / length))
    points, inside = nearest(space, form.per(space, length), scaled, limit)
    near = parts(points)
    kept = (
        space.where(inside, a, b) for a, b in zip((x, y, torque), (*near[:2], near[2] * length))
    )
    return space.stack(tuple(kept)), inside


def nearest(space: Space, form: Form, wrenches: Any, limit: Any) -> tuple[Any, Any]:
    """The same by |force|² + torque²; for wrenches in the set any numbers."""
    points, normals, beyond = _nearest(space, form)(
        wrenches, _not_negative(space, limit), *_moving(space, form)
    )
    width = COLLAR * space.epsilon(beyond) * space.still(dot(normals, points))
    return points, space.still(beyond) <= width


def _not_negative(space: Space, limit: Any) -> Any:
    return space.where(limit >= 0.0, limit, space.constant(float("nan"), limit))


def _moving(space: Space, form: Form) -> list[Any]:
    """The form's arrays that derivatives may be asked by."""
    return [array for array in form.arrays if space.moves(array)]


def _with(space: Space, form: Form, moving: tuple[Any, ...]) -> Form:
    """The form with others in the place of those."""
    given = iter(moving)
    return form.of(tuple(next(given) if space.moves(a) else a for a in form.arrays))


def _push(space: Space, form: Form, twists: Any) -> Any:
    """The gradient of the support."""
    return -form.wrench(space, twists)


def _push_by_arrays(space: Space, form: Form, normals: Any, by: Any) -> Any:
    """The change of the push at fixed motions along tangents of the form's moving arrays."""
    moving = tuple(_moving(space, form))
    if not moving:
        return 0.0
    return space.pushed(lambda *at: _push(space, _with(space, form, at), normals), moving, by)


def _on_rays(space: Space, form: Form, wrenches: Any, nothing: Any) -> tuple[Any, Any]:
    """Normals in the unit of the form's reach, and gauges under the force limit 1."""
    reach = form.reach(space)
    x, y, torque = parts(wrenches)
    safe = space.stack((space.where(nothing, 1.0, x), y, torque / reach))
    form = form.per(space, reach)
    normals, gauges = _rays(space, form)(safe, *_moving(space, form))
    return normals, gauges


def _rays(space: Space, form: Form) -> Callable[..., tuple[Any, Any]]:
    """Normals and gauges by wrenches and the form's moving arrays."""

    def value(wrenches: Any, *moving: Any) -> tuple[Any, Any]:
        normals, gauges = _with(space, form, moving).ray(space, wrenches)
        return normals, gauges

    def rule(at: Any, by: Any) -> Any:
        normals, gauges = solution(*at)
        here = _with(space, form, at[1:])
        power = here.support(space, normals)
        moved = by[0] - gauges[..., None] * _push_by_arrays(space, here, normals, by[1:])
        rate = dot(normals, moved) / power
        across = moved - rate[..., None] * _push(space, here, normals)
        turned = _turned(space, here, normals, across, gauges, 0.0)[0]
        return (normals, gauges), (turned, rate)

    solution = space.ruled(value, rule)
    return solution


def _nearest(space: Space, form: Form) -> Callable[..., tuple[Any, Any, Any]]:
    """Nearest points, normals and distances by wrenches, force limits and the form's moving arrays."""

    def value(wrenches: Any, limit: Any, *moving: Any) -> tuple[Any, Any, Any]:
        # Without a limit the nearest point is 0, along the wrench itself.
        some = ~(limit == 0.0)
        unit = space.where(some, limit, 1.0)[..., None]
        found = _with(space, form, moving).nearest(space, wrenches / unit)
        size = space.sqrt(dot(wrenches, wrenches))
        along = wrenches / space.where(size == 0.0, 1.0, size)[..., None]
        return (
            limit[..., None] * found.points,
            space.where(some[..., None], found.normals, along),
            space.where(some, limit * found.beyond, size),
        )

    def rule(at: Any, by: Any) -> Any:
        points, normals, beyond = solution(*at)
        limit = at[1]
        here = _with(space, form, at[2:])
        push = _push(space, here, normals)
        grown = push * by[1][..., None]
        grown = grown + limit[..., None] * _push_by_arrays(space, here, normals, by[2:])
        moved = by[0] - grown
        # Inside nothing is asked for.
        outside = space.where(beyond <= 0.0, 1.0, beyond)
        turned, along = _turned(space, here, normals, moved, limit, outside)
        return (points, normals, beyond), (grown + along, turned, dot(normals, moved))

    solution = space.ruled(value, rule)
    return solution


def _turned(
    space: Space, form: Form, normals: Any, moved: Any, scale: Any, distance: Any
) -> tuple[Any, Any]:
    """(distance + scale H)⁻¹ of the part of `moved` across the normals, and scale H of that."""
    xx, xy, yy, xt, yt, tt = (scale * part for part in form.hessian(space, normals))
    x, y, z = parts(moved - normals * dot(normals, moved)[..., None])
    trace = xx + yy + tt
    minors = (xx * yy - xy * xy) + (xx * tt - xt * xt) + (yy * tt - yt * yt)
    per = 1.0 / (distance * (distance + trace) + minors)
    first = xx * x + xy * y + xt * z, xy * x + yy * y + yt * z, xt * x + yt * y + tt * z
    widened = distance + trace
    turned = tuple(per * (widened * a - b) for a, b in zip((x, y, z), first, strict=True))
    # On the part across (scale H)² = trace scale H - minors.
    along = tuple(per * (distance * b + minors * a) for a, b in zip((x, y, z), first, strict=True))
    return space.stack(turned), space.stack(along)
