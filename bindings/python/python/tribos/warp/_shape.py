"""Projection on the limit surface of boxes and polygons, and the implicit planar step on them."""

from __future__ import annotations

import warp as wp

from tribos.warp._edges import box_frame, polygon_frame
from tribos.warp._meridian import vec6
from tribos.warp._project import pulled_back
from tribos.warp._search import (
    Shape,
    arm_of,
    box_shape,
    hessian_of,
    in_arms,
    polygon_shape,
    power_at,
    shape_motion,
    shape_projected,
)
from tribos.warp._step import (
    gives_power,
    is_beyond,
    is_same,
    moved,
    step_adjoint,
    stopping_wrench,
    turns_about,
)


@wp.func
def metric_of(length: float) -> wp.mat33:
    return wp.diag(wp.vec3(1.0, 1.0, length * length))


@wp.func
def shape_projected_adjoint(
    shape: Shape, frame: wp.vec4, wrench: wp.vec3, limit: float, length: float, adj: wp.vec3
) -> vec6:
    """Adjoints of wrench, limit and length."""
    if limit <= 0.0:
        return vec6(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    arm = arm_of(shape, frame)
    x = wp.vec3(wrench[0] / limit, wrench[1] / limit, wrench[2] / limit / arm)
    metric = in_arms(metric_of(length), arm)
    at = shape_motion(shape, frame, arm, x, metric)
    if at[3] == 0.0:
        return vec6(adj[0], adj[1], adj[2], 0.0, 0.0, 0.0)
    motion = wp.vec3(at[0], at[1], at[2])
    power = power_at(shape, frame, arm, wp.normalize(motion))
    own = wp.vec3(limit * adj[0], limit * adj[1], limit * arm * adj[2])
    back = pulled_back(hessian_of(power), metric, motion, own)
    point = wp.vec3(power[0], power[1], power[2])
    by_limit = (wp.dot(point, own) - wp.dot(back, x)) / limit
    by_length = -back[2] * 2.0 * length / (arm * arm) * motion[2]
    return vec6(back[0] / limit, back[1] / limit, back[2] / (limit * arm), by_limit, by_length, 0.0)


@wp.func
def shape_step(
    shape: Shape, frame: wp.vec4, twist: wp.vec3, push: wp.vec3, limit: float, body: wp.vec3
) -> wp.vec4:
    """Friction, and the share of the step after which it opposes the motion; 0 at rest."""
    metric = metric_of(wp.sqrt(body[1] / body[0]))
    at_end = stopping_wrench(twist, push, body[0], body[1], body[2])
    is_far = is_beyond(at_end, limit, limit * arm_of(shape, frame))
    ended = at_end
    if not is_far:
        ended = shape_projected(shape, frame, at_end, limit, metric)
        if is_same(ended, at_end):
            return wp.vec4(at_end[0], at_end[1], at_end[2], 0.0)
    half = stopping_wrench(twist, push, body[0], body[1], 0.5 * body[2])
    midway = shape_projected(shape, frame, half, limit, metric)
    after = moved(twist, push + midway, body[0], body[1], body[2])
    if turns_about(twist, after):
        if is_far:
            ended = shape_projected(shape, frame, at_end, limit, metric)
        if not gives_power(twist, push, ended, body):
            return wp.vec4(ended[0], ended[1], ended[2], 1.0)
    return wp.vec4(midway[0], midway[1], midway[2], 0.5)


@wp.func
def box_project(wrench: wp.vec3, limit: float, a: float, b: float, length: float) -> wp.vec3:
    """The nearest wrench that a box carries, about its centre.

    `round_project` has the parameters, `box_wrench` the sides a and b, which have no derivative.
    """
    return shape_projected(box_shape(a, b), box_frame(a, b), wrench, limit, metric_of(length))


@wp.func_grad(box_project)
def _adj_box_project(
    wrench: wp.vec3, limit: float, a: float, b: float, length: float, adj_ret: wp.vec3
) -> None:
    frame = box_frame(a, b)
    back = shape_projected_adjoint(box_shape(a, b), frame, wrench, limit, length, adj_ret)
    wp.adjoint[wrench] += wp.vec3(back[0], back[1], back[2])
    wp.adjoint[limit] += back[3]
    wp.adjoint[length] += back[4]


@wp.func
def polygon_project(
    wrench: wp.vec3, limit: float, corners: wp.array(dtype=wp.vec2), length: float
) -> wp.vec3:
    """The nearest wrench that a polygon carries, about the origin of its corners.

    `round_project` has the parameters, `polygon_wrench` the corners, which have no derivative.
    """
    frame = polygon_frame(corners)
    return shape_projected(polygon_shape(corners), frame, wrench, limit, metric_of(length))


@wp.func_grad(polygon_project)
def _adj_polygon_project(
    wrench: wp.vec3,
    limit: float,
    corners: wp.array(dtype=wp.vec2),
    length: float,
    adj_ret: wp.vec3,
) -> None:
    frame = polygon_frame(corners)
    back = shape_projected_adjoint(polygon_shape(corners), frame, wrench, limit, length, adj_ret)
    wp.adjoint[wrench] += wp.vec3(back[0], back[1], back[2])
    wp.adjoint[limit] += back[3]
    wp.adjoint[length] += back[4]


@wp.func
def box_planar_friction(
    twist: wp.vec3,
    push: wp.vec3,
    limit: float,
    a: float,
    b: float,
    mass: float,
    inertia: float,
    dt: float,
) -> wp.vec3:
    """Friction over a step of a body on a box about its centre of mass.

    `round_planar_friction` has the parameters, `box_wrench` the sides a and b, which have no derivative.
    """
    body = wp.vec3(mass, inertia, dt)
    step = shape_step(box_shape(a, b), box_frame(a, b), twist, push, limit, body)
    return wp.vec3(step[0], step[1], step[2])


@wp.func_grad(box_planar_friction)
def _adj_box_planar_friction(
    twist: wp.vec3,
    push: wp.vec3,
    limit: float,
    a: float,
    b: float,
    mass: float,
    inertia: float,
    dt: float,
    adj_ret: wp.vec3,
) -> None:
    body = wp.vec3(mass, inertia, dt)
    frame = box_frame(a, b)
    step = shape_step(box_shape(a, b), frame, twist, push, limit, body)
    share = step[3]
    back = adj_ret
    by_length = float(0.0)
    if share > 0.0:
        needed = stopping_wrench(twist, push, mass, inertia, share * dt)
        length = wp.sqrt(inertia / mass)
        found = shape_projected_adjoint(box_shape(a, b), frame, needed, limit, length, adj_ret)
        back = wp.vec3(found[0], found[1], found[2])
        by_length = found[4]
        wp.adjoint[limit] += found[3]
    made = step_adjoint(twist, back, by_length, body, wp.where(share > 0.0, share, 1.0))
    wp.adjoint[twist] += wp.vec3(made[0], made[1], made[2])
    wp.adjoint[push] += wp.vec3(made[3], made[4], made[5])
    wp.adjoint[mass] += made[6]
    wp.adjoint[inertia] += made[7]
    wp.adjoint[dt] += made[8]


@wp.func
def polygon_planar_friction(
    twist: wp.vec3,
    push: wp.vec3,
    limit: float,
    corners: wp.array(dtype=wp.vec2),
    mass: float,
    inertia: float,
    dt: float,
) -> wp.vec3:
    """Friction over a step of a body on a polygon, whose corners are about the centre of mass.

    `round_planar_friction` has the parameters, `polygon_wrench` the corners, which have no derivative.
    """
    body = wp.vec3(mass, inertia, dt)
    step = shape_step(polygon_shape(corners), polygon_frame(corners), twist, push, limit, body)
    return wp.vec3(step[0], step[1], step[2])


@wp.func_grad(polygon_planar_friction)
def _adj_polygon_planar_friction(
    twist: wp.vec3,
    push: wp.vec3,
    limit: float,
    corners: wp.array(dtype=wp.vec2),
    mass: float,
    inertia: float,
    dt: float,
    adj_ret: wp.vec3,
) -> None:
    body = wp.vec3(mass, inertia, dt)
    frame = polygon_frame(corners)
    step = shape_step(polygon_shape(corners), frame, twist, push, limit, body)
    share = step[3]
    back = adj_ret
    by_length = float(0.0)
    if share > 0.0:
        needed = stopping_wrench(twist, push, mass, inertia, share * dt)
        length = wp.sqrt(inertia / mass)
        found = shape_projected_adjoint(
            polygon_shape(corners), frame, needed, limit, length, adj_ret
        )
        back = wp.vec3(found[0], found[1], found[2])
        by_length = found[4]
        wp.adjoint[limit] += found[3]
    made = step_adjoint(twist, back, by_length, body, wp.where(share > 0.0, share, 1.0))
    wp.adjoint[twist] += wp.vec3(made[0], made[1], made[2])
    wp.adjoint[push] += wp.vec3(made[3], made[4], made[5])
    wp.adjoint[mass] += made[6]
    wp.adjoint[inertia] += made[7]
    wp.adjoint[dt] += made[8]


for _function in (metric_of, shape_projected_adjoint, shape_step):
    _function.adj.skip_reverse_codegen = True
