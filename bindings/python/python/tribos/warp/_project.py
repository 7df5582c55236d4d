"""The nearest wrench that the friction of a round patch carries."""

from __future__ import annotations

import warp as wp

from tribos.warp._forms import DISK
from tribos.warp._meridian import COLLAR, gauge_bound, round_nearest, vec6
from tribos.warp._round import unit_round_jacobian


@wp.func
def pulled_back(hessian: wp.mat33, metric: wp.mat33, motion: wp.vec3, given: wp.vec3) -> wp.vec3:
    """(M + D″)⁻¹ D″ times a vector: the transposed derivative of a projection with the motion M⁻¹(x − p).

    D″ is that of a motion of length 1 in its direction and vanishes along it, so that a term added there
    changes nothing; it keeps the matrix regular next to the surface.
    """
    size = wp.length(motion)
    along = metric * (motion / size)
    stiff = hessian[0, 0] + hessian[1, 1] + hessian[2, 2]
    whole = size * metric + hessian + (stiff / wp.length_sq(along)) * wp.outer(along, along)
    # D″ of the direction is D″ of the motion times its size, and M counts as often.
    return wp.inverse(whole) * (hessian * given)


@wp.func
def round_projected(
    pressure: int, wrench: wp.vec3, limit: float, radius: float, length: float
) -> wp.vec3:
    """The projection."""
    if limit <= 0.0:
        return wp.vec3(0.0, 0.0, 0.0)
    force = wp.sqrt(wrench[0] * wrench[0] + wrench[1] * wrench[1]) / limit
    torque = wp.abs(wrench[2]) / radius / limit
    if gauge_bound(pressure, force, torque) < 1.0 - 2.0 * COLLAR:
        return wrench
    at = round_nearest(pressure, force, torque, length / radius)
    if at[5] <= COLLAR * at[4]:
        return wrench
    share = float(0.0)
    if force > 0.0:
        share = at[2] / force
    turn = limit * radius * at[3]
    return wp.vec3(share * wrench[0], share * wrench[1], wp.where(wrench[2] < 0.0, -turn, turn))


@wp.func
def round_projected_adjoint(
    pressure: int, wrench: wp.vec3, limit: float, radius: float, length: float, adj: wp.vec3
) -> vec6:
    """Adjoints of wrench, limit, radius and length."""
    if limit <= 0.0:
        return vec6(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    inside = vec6(adj[0], adj[1], adj[2], 0.0, 0.0, 0.0)
    force = wp.sqrt(wrench[0] * wrench[0] + wrench[1] * wrench[1]) / limit
    torque = wp.abs(wrench[2]) / radius / limit
    if gauge_bound(pressure, force, torque) < 1.0 - 2.0 * COLLAR:
        return inside
    lever = length / radius
    at = round_nearest(pressure, force, torque, lever)
    if at[5] <= COLLAR * at[4]:
        return inside
    given = wp.vec3(wrench[0] / limit, wrench[1] / limit, wrench[2] / radius / limit)
    axis = wp.vec2(0.0, 0.0)
    if force > 0.0:
        axis = wp.vec2(given[0] / force, given[1] / force)
    sign = wp.where(wrench[2] < 0.0, -1.0, 1.0)
    point = wp.vec3(at[2] * axis[0], at[2] * axis[1], sign * at[3])
    normal = wp.vec3(at[0] * axis[0], at[0] * axis[1], sign * at[1])
    lever_sq = lever * lever
    metric = wp.diag(wp.vec3(1.0, 1.0, lever_sq))
    # given − point = M motion, with the motion along the normal.
    motion = (at[5] / wp.dot(normal, metric * normal)) * normal
    hessian = -unit_round_jacobian(pressure, wp.normalize(normal))
    own = wp.vec3(limit * adj[0], limit * adj[1], limit * radius * adj[2])
    back = pulled_back(hessian, metric, motion, own)
    by_lever = -back[2] * 2.0 * lever * motion[2]
    by_limit = (wp.dot(point, own) - wp.dot(back, given)) / limit
    by_radius = limit * point[2] * adj[2] - (back[2] * given[2] + by_lever * lever) / radius
    return vec6(
        back[0] / limit,
        back[1] / limit,
        back[2] / (limit * radius),
        by_limit,
        by_radius,
        by_lever / radius,
    )


@wp.func
def round_project(
    pressure: int, wrench: wp.vec3, limit: float, radius: float, length: float
) -> wp.vec3:
    """The wrench nearest to a given one that Coulomb friction of a round patch carries.

    Parameters
    ----------
    pressure
        `DISK`, `RING`, `PUNCH`, `HERTZ` or `PARABOLOID`.
    wrench
        Force in N and torque in N m about the centre.
    limit
        mu times load, in N. Nothing is carried at 0 or below.
    radius
        In m.
    length
        Torque over this length, in m, counts as force: the radius of gyration of a body.

    Returns
    -------
    vec3
        The wrench itself, to the last bit, where friction carries it.
    """
    return round_projected(pressure, wrench, limit, radius, length)


@wp.func_grad(round_project)
def _adj_round_project(
    pressure: int,
    wrench: wp.vec3,
    limit: float,
    radius: float,
    length: float,
    adj_ret: wp.vec3,
) -> None:
    back = round_projected_adjoint(pressure, wrench, limit, radius, length, adj_ret)
    wp.adjoint[wrench] += wp.vec3(back[0], back[1], back[2])
    wp.adjoint[limit] += back[3]
    wp.adjoint[radius] += back[4]
    wp.adjoint[length] += back[5]


@wp.func
def disk_project(wrench: wp.vec3, limit: float, radius: float, length: float) -> wp.vec3:
    """The wrench nearest to a given one that a disk carries; `round_project` has the parameters."""
    return round_project(DISK, wrench, limit, radius, length)


for _function in (pulled_back, round_projected, round_projected_adjoint):
    _function.adj.skip_reverse_codegen = True
