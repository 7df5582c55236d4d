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


def dot(space: Space, a: Any, b: Any) -> Any:
    """The sum of the products of components."""
    x, y, z = (one * other for one, other in zip(space.parts(a), space.parts(b), strict=True))
    return x + y + z


def scaled(space: Space, factor: Any, rows: Any) -> Any:
    """Rows times a number each; None for none of either."""
    if factor is None or rows is None:
        return None
    # By components: what sums products of stacked ones would compute each three times.
    return space.stack([factor * part for part in space.parts(rows)])


def is_none(space: Space, rows: Any) -> Any:
    """Whether all three components are 0."""
    x, y, z = space.parts(space.still(rows))
    return (x == 0.0) & (y == 0.0) & (z == 0.0)


def support(space: Space, form: Form, twists: Any) -> Any:
    """Power of friction over the force limit; 0 at rest, with derivatives 0."""

    def value(twists: Any, *arrays: Any) -> Any:
        return dot(space, _push(space, form.of(arrays), twists), twists)

    def rule(at: Any, by: Any) -> Any:
        # By Euler's relation the push's own change along the twist is none.
        here = form.of(at[1:])
        push = _push(space, here, at[0])
        along = None if by[0] is None else dot(space, push, by[0])
        changed = _push_by_arrays(space, here, at[0], by[1:])
        grown = None if changed is None else dot(space, changed, at[0])
        return dot(space, push, at[0]), _sum(along, grown)

    made: Any = space.ruled(value, rule)(twists, *form.arrays)
    return made


def gauge(space: Space, form: Form, wrenches: Any, limit: Any) -> Any:
    """The least factor by which the set under a force limit must grow to hold wrenches.

    0 for none, infinite without a limit, both with derivatives 0; NaN under a negative one.
    """
    nothing = is_none(space, wrenches)
    _, gauges = _on_rays(space, form, wrenches, nothing)
    has_none = limit == 0.0
    made = gauges / space.where(has_none, 1.0, not_negative(space, limit))
    infinite = space.constant(float("inf"), made)
    return space.where(nothing, 0.0, space.where(has_none, infinite, made))


def normal(space: Space, form: Form, wrenches: Any) -> Any:
    """The motion that pushes cause, with |velocity|² + (spin reach)² = 1; 0 for none, with derivatives 0."""
    nothing = is_none(space, wrenches)
    x, y, spin = space.parts(_on_rays(space, form, wrenches, nothing)[0])
    share = space.where(nothing, 0.0, 1.0 + 0.0 * x)
    return space.stack((share * x, share * y, share * spin / form.reach(space)))


def project(space: Space, form: Form, wrenches: Any, limit: Any, length: Any) -> tuple[Any, Any]:
    """The nearest wrenches of the set by |force|² + (torque/length)², and whether the given ones are in it."""
    x, y, torque = space.parts(wrenches)
    scaled = space.stack((x, y, torque / length))
    points, inside = nearest(space, form.per(space, length), scaled, limit)
    near = space.parts(points)
    kept = (
        space.where(inside, a, b) for a, b in zip((x, y, torque), (*near[:2], near[2] * length))
    )
    return space.stack(tuple(kept)), inside


def nearest(space: Space, form: Form, wrenches: Any, limit: Any) -> tuple[Any, Any]:
    """The same by |force|² + torque²; for wrenches in the set any numbers."""
    points, normals, beyond = _nearest(space, form)(
        wrenches, not_negative(space, limit), *form.arrays
    )
    width = COLLAR * space.epsilon(beyond) * space.still(dot(space, normals, points))
    return points, space.still(beyond) <= width


def not_negative(space: Space, limit: Any) -> Any:
    """A force limit, NaN for one below 0."""
    return space.where(limit >= 0.0, limit, space.constant(float("nan"), limit))


def _push(space: Space, form: Form, twists: Any) -> Any:
    """The gradient of the support."""
    return -form.wrench(space, twists)


def _push_by_arrays(space: Space, form: Form, normals: Any, by: Any) -> Any:
    """The change of the push at fixed motions along tangents of the form's arrays, None for none."""
    if all(rate is None for rate in by):
        return None
    return space.pushed(lambda *at: _push(space, form.of(at), normals), form.arrays, by)


def _sum(*terms: Any) -> Any:
    """The sum of those that are not None."""
    return sum(term for term in terms if term is not None)


def _on_rays(space: Space, form: Form, wrenches: Any, nothing: Any) -> tuple[Any, Any]:
    """Normals in the unit of the form's reach, and gauges under the force limit 1."""
    reach = form.reach(space)
    x, y, torque = space.parts(wrenches)
    safe = space.stack((space.where(nothing, 1.0, x), y, torque / reach))
    form = form.per(space, reach)
    normals, gauges = _rays(space, form)(safe, *form.arrays)
    return normals, gauges


def _rays(space: Space, form: Form) -> Callable[..., tuple[Any, Any]]:
    """Normals and gauges by wrenches and the form's arrays."""

    def value(wrenches: Any, *arrays: Any) -> tuple[Any, Any]:
        normals, gauges = form.of(arrays).ray(space, wrenches)
        return normals, gauges

    def rule(at: Any, by: Any) -> Any:
        normals, gauges = solution(*at)
        here = form.of(at[1:])
        push = _push(space, here, normals)
        by_arrays = _push_by_arrays(space, here, normals, by[1:])
        moved = _sum(by[0], scaled(space, -gauges, by_arrays))
        rate = dot(space, normals, moved) / dot(space, normals, push)
        across = moved - scaled(space, rate, push)
        turned = _turned(space, here, normals, across, gauges, 0.0)[0]
        return (normals, gauges), (turned, rate)

    solution = space.ruled(value, rule)
    return solution


def _nearest(space: Space, form: Form) -> Callable[..., tuple[Any, Any, Any]]:
    """Nearest points, normals and distances by wrenches, force limits and the form's arrays."""

    def value(wrenches: Any, limit: Any, *arrays: Any) -> tuple[Any, Any, Any]:
        # Without a limit the nearest point is 0, along the wrench itself.
        some = ~(limit == 0.0)
        unit = space.where(some, limit, 1.0)[..., None]
        found = form.of(arrays).nearest(space, wrenches / unit)
        size = space.sqrt(dot(space, wrenches, wrenches))
        along = wrenches / space.where(size == 0.0, 1.0, size)[..., None]
        return (
            scaled(space, limit, found.points),
            space.where(some[..., None], found.normals, along),
            space.where(some, limit * found.beyond, size),
        )

    def rule(at: Any, by: Any) -> Any:
        points, normals, beyond = solution(*at)
        limit = at[1]
        here = form.of(at[2:])
        by_arrays = scaled(space, limit, _push_by_arrays(space, here, normals, by[2:]))
        grown = _sum(0.0 * points, scaled(space, by[1], _push(space, here, normals)), by_arrays)
        moved = -grown if by[0] is None else by[0] - grown
        # Inside nothing is asked for.
        outside = space.where(beyond <= 0.0, 1.0, beyond)
        turned, along = _turned(space, here, normals, moved, limit, outside)
        return (points, normals, beyond), (grown + along, turned, dot(space, normals, moved))

    solution = space.ruled(value, rule)
    return solution


def _turned(
    space: Space, form: Form, normals: Any, moved: Any, scale: Any, distance: Any
) -> tuple[Any, Any]:
    """(distance + scale H)⁻¹ of the part of `moved` across the normals, and scale H of that."""
    xx, xy, yy, xt, yt, tt = (scale * part for part in form.hessian(space, normals))
    x, y, z = space.parts(moved - scaled(space, dot(space, normals, moved), normals))
    trace = xx + yy + tt
    minors = (xx * yy - xy * xy) + (xx * tt - xt * xt) + (yy * tt - yt * yt)
    per = 1.0 / (distance * (distance + trace) + minors)
    first = xx * x + xy * y + xt * z, xy * x + yy * y + yt * z, xt * x + yt * y + tt * z
    widened = distance + trace
    turned = tuple(per * (widened * a - b) for a, b in zip((x, y, z), first, strict=True))
    # On the part across (scale H)² = trace scale H - minors.
    along = tuple(per * (distance * b + minors * a) for a, b in zip((x, y, z), first, strict=True))
    return space.stack(turned), space.stack(along)
