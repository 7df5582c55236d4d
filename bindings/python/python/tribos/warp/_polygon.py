"""Friction of boxes and polygons under uniform pressure."""

from __future__ import annotations

import warp as wp

from tribos.warp._edges import box_frame, box_friction, polygon_frame, polygon_friction, vec9
from tribos.warp._round import ordinary


@wp.func
def motion_of_centre(frame: wp.vec4, twist: wp.vec3) -> wp.vec3:
    """Velocity of the centroid and rim speed."""
    return wp.vec3(
        twist[0] - twist[2] * frame[1], twist[1] + twist[2] * frame[0], twist[2] * frame[2]
    )


@wp.func
def about_origin(frame: wp.vec4, unit: vec9) -> wp.vec3:
    """A reduced wrench about the origin of the coordinates."""
    torque = frame[2] * unit[2] + (frame[0] * unit[1] - frame[1] * unit[0])
    return wp.vec3(unit[0], unit[1], torque)


@wp.func
def slope_along(frame: wp.vec4, unit: vec9, direction: wp.vec3) -> wp.vec3:
    """∂wrench/∂twist, minus the Hessian of the power, times a direction, both about the origin."""
    at = motion_of_centre(frame, direction)
    x = unit[3] * at[0] + unit[4] * at[1] + unit[6] * at[2]
    y = unit[4] * at[0] + unit[5] * at[1] + unit[7] * at[2]
    n = unit[6] * at[0] + unit[7] * at[1] + unit[8] * at[2]
    return -wp.vec3(x, y, frame[2] * n + (frame[0] * y - frame[1] * x))


@wp.func
def box_wrench(twist: wp.vec3, limit: float, a: float, b: float) -> wp.vec3:
    """Coulomb friction of a box under uniform pressure, about its centre.

    Parameters
    ----------
    twist
        Velocity along x and y in m/s and spin in rad/s of the centre.
    limit
        mu times load, in N, at least 0.
    a, b
        Sides along x and y, in m. Without derivative.

    Returns
    -------
    vec3
        Force along x and y in N and torque in N m on the body; zero at rest.
    """
    frame = box_frame(a, b)
    motion = ordinary(motion_of_centre(frame, ordinary(twist)))
    if wp.length_sq(motion) == 0.0:
        return wp.vec3(0.0, 0.0, 0.0)
    return limit * about_origin(frame, box_friction(a, b, frame, motion, False))


@wp.func_grad(box_wrench)
def _adj_box_wrench(twist: wp.vec3, limit: float, a: float, b: float, adj_ret: wp.vec3) -> None:
    frame = box_frame(a, b)
    motion = motion_of_centre(frame, twist)
    size = wp.max(wp.max(wp.abs(motion[0]), wp.abs(motion[1])), wp.abs(motion[2]))
    if size > 0.0:
        unit = box_friction(a, b, frame, motion / size, True)
        wp.adjoint[twist] += (limit / size) * slope_along(frame, unit, adj_ret)
        wp.adjoint[limit] += wp.dot(about_origin(frame, unit), adj_ret)


@wp.func
def polygon_wrench(twist: wp.vec3, limit: float, corners: wp.array(dtype=wp.vec2)) -> wp.vec3:
    """Coulomb friction of a polygon under uniform pressure, about the origin of its corners.

    Parameters
    ----------
    twist
        Velocity along x and y in m/s and spin in rad/s of the origin.
    limit
        mu times load, in N, at least 0.
    corners
        In m, in either sense; a row of a table, ``corners[world]``, gives each world its own. A corner
        may be repeated, so that unlike polygons fill one table. Without derivative.

    Returns
    -------
    vec3
        Force along x and y in N and torque in N m on the body; zero at rest.
    """
    frame = polygon_frame(corners)
    motion = ordinary(motion_of_centre(frame, ordinary(twist)))
    if wp.length_sq(motion) == 0.0:
        return wp.vec3(0.0, 0.0, 0.0)
    return limit * about_origin(frame, polygon_friction(corners, frame, motion, False))


@wp.func_grad(polygon_wrench)
def _adj_polygon_wrench(
    twist: wp.vec3, limit: float, corners: wp.array(dtype=wp.vec2), adj_ret: wp.vec3
) -> None:
    frame = polygon_frame(corners)
    motion = motion_of_centre(frame, twist)
    size = wp.max(wp.max(wp.abs(motion[0]), wp.abs(motion[1])), wp.abs(motion[2]))
    if size > 0.0:
        unit = polygon_friction(corners, frame, motion / size, True)
        wp.adjoint[twist] += (limit / size) * slope_along(frame, unit, adj_ret)
        wp.adjoint[limit] += wp.dot(about_origin(frame, unit), adj_ret)


for _function in (motion_of_centre, about_origin, slope_along):
    _function.adj.skip_reverse_codegen = True
