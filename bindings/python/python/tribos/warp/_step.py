"""The implicit planar step on round patches."""

from __future__ import annotations

import warp as wp

from tribos.warp._forms import DISK
from tribos.warp._meridian import approximation
from tribos.warp._project import round_projected, round_projected_adjoint

# By how much friction must be exceeded to be exceeded beyond all rounding.
BEYOND = wp.constant(1.01)
vec9 = wp.types.vector(length=9, dtype=wp.float32)


@wp.func
def stopping_wrench(
    twist: wp.vec3, push: wp.vec3, mass: float, inertia: float, time: float
) -> wp.vec3:
    """The friction that brings the body to rest within a time."""
    heavy = mass / time
    return -wp.vec3(
        heavy * twist[0] + push[0], heavy * twist[1] + push[1], inertia / time * twist[2] + push[2]
    )


@wp.func
def moved(twist: wp.vec3, force: wp.vec3, mass: float, inertia: float, time: float) -> wp.vec3:
    """The motion after a time under a force."""
    rate = time / mass
    return wp.vec3(
        twist[0] + rate * force[0], twist[1] + rate * force[1], twist[2] + time / inertia * force[2]
    )


@wp.func
def is_same(a: wp.vec3, b: wp.vec3) -> bool:
    return a[0] == b[0] and a[1] == b[1] and a[2] == b[2]


@wp.func
def turns_about(before: wp.vec3, after: wp.vec3) -> bool:
    """True if velocity or spin have another sense."""
    return before[0] * after[0] + before[1] * after[1] < 0.0 or before[2] * after[2] < 0.0


@wp.func
def is_beyond(wrench: wp.vec3, force: float, torque: float) -> bool:
    """True if friction with these largest force and torque can surely not be the wrench."""
    most = BEYOND * force
    planar = wrench[0] * wrench[0] + wrench[1] * wrench[1]
    return planar > most * most or wp.abs(wrench[2]) > BEYOND * torque


@wp.func
def gives_power(twist: wp.vec3, push: wp.vec3, ended: wp.vec3, body: wp.vec3) -> bool:
    """True if friction that opposes the motion at the end would drive the body over the step."""
    at_last = moved(twist, push + ended, body[0], body[1], body[2])
    return wp.dot(ended, twist + at_last) > 0.0


@wp.func
def step_adjoint(
    twist: wp.vec3, back: wp.vec3, by_length: float, body: wp.vec3, share: float
) -> vec9:
    """Adjoints of twist, push, mass, inertia and the time step, of those of the needed wrench.

    `share` is that of the step after which friction opposes the motion.
    """
    mass = body[0]
    inertia = body[1]
    time = share * body[2]
    length = wp.sqrt(inertia / mass)
    along = back[0] * twist[0] + back[1] * twist[1]
    return vec9(
        -(mass / time) * back[0],
        -(mass / time) * back[1],
        -(inertia / time) * back[2],
        -back[0],
        -back[1],
        -back[2],
        -along / time - 0.5 * by_length * length / mass,
        -back[2] * twist[2] / time + 0.5 * by_length * length / inertia,
        share * (mass * along + inertia * back[2] * twist[2]) / (time * time),
    )


@wp.func
def round_step(
    pressure: int, twist: wp.vec3, push: wp.vec3, limit: float, radius: float, body: wp.vec3
) -> wp.vec4:
    """Friction, and the share of the step after which it opposes the motion; 0 at rest."""
    length = wp.sqrt(body[1] / body[0])
    at_end = stopping_wrench(twist, push, body[0], body[1], body[2])
    spinning = approximation(pressure, False)
    is_far = is_beyond(at_end, limit, limit * radius * spinning[0])
    ended = at_end
    if not is_far:
        ended = round_projected(pressure, at_end, limit, radius, length)
        if is_same(ended, at_end):
            return wp.vec4(at_end[0], at_end[1], at_end[2], 0.0)
    half = stopping_wrench(twist, push, body[0], body[1], 0.5 * body[2])
    midway = round_projected(pressure, half, limit, radius, length)
    after = moved(twist, push + midway, body[0], body[1], body[2])
    if turns_about(twist, after):
        if is_far:
            ended = round_projected(pressure, at_end, limit, radius, length)
        if not gives_power(twist, push, ended, body):
            return wp.vec4(ended[0], ended[1], ended[2], 1.0)
    return wp.vec4(midway[0], midway[1], midway[2], 0.5)


@wp.func
def round_planar_friction(
    pressure: int,
    twist: wp.vec3,
    push: wp.vec3,
    limit: float,
    radius: float,
    mass: float,
    inertia: float,
    dt: float,
) -> wp.vec3:
    """Friction over a step of a body that moves in a plane on a round patch about its centre of mass.

    The step is implicit: a body that friction can hold stops, and stays at rest to the last bit. The
    motion at its end is twist + dt (push + friction)/(mass, mass, inertia).

    Parameters
    ----------
    pressure
        `DISK`, `RING`, `PUNCH`, `HERTZ` or `PARABOLOID`.
    twist
        Velocity in m/s and spin in rad/s before the step.
    push
        All other force in N and torque in N m.
    limit
        mu times load, in N.
    radius
        In m.
    mass, inertia
        In kg and kg m², about the axis of spin.
    dt
        The time step, in s.

    Returns
    -------
    vec3
        Mean force in N and torque in N m on the body.
    """
    body = wp.vec3(mass, inertia, dt)
    step = round_step(pressure, twist, push, limit, radius, body)
    return wp.vec3(step[0], step[1], step[2])


@wp.func_grad(round_planar_friction)
def _adj_round_planar_friction(
    pressure: int,
    twist: wp.vec3,
    push: wp.vec3,
    limit: float,
    radius: float,
    mass: float,
    inertia: float,
    dt: float,
    adj_ret: wp.vec3,
) -> None:
    body = wp.vec3(mass, inertia, dt)
    step = round_step(pressure, twist, push, limit, radius, body)
    share = step[3]
    back = adj_ret
    by_length = float(0.0)
    if share > 0.0:
        needed = stopping_wrench(twist, push, mass, inertia, share * dt)
        length = wp.sqrt(inertia / mass)
        found = round_projected_adjoint(pressure, needed, limit, radius, length, adj_ret)
        back = wp.vec3(found[0], found[1], found[2])
        by_length = found[5]
        wp.adjoint[limit] += found[3]
        wp.adjoint[radius] += found[4]
    made = step_adjoint(twist, back, by_length, body, wp.where(share > 0.0, share, 1.0))
    wp.adjoint[twist] += wp.vec3(made[0], made[1], made[2])
    wp.adjoint[push] += wp.vec3(made[3], made[4], made[5])
    wp.adjoint[mass] += made[6]
    wp.adjoint[inertia] += made[7]
    wp.adjoint[dt] += made[8]


@wp.func
def disk_planar_friction(
    twist: wp.vec3,
    push: wp.vec3,
    limit: float,
    radius: float,
    mass: float,
    inertia: float,
    dt: float,
) -> wp.vec3:
    """`round_planar_friction` on a disk under uniform pressure."""
    return round_planar_friction(DISK, twist, push, limit, radius, mass, inertia, dt)


for _function in (
    stopping_wrench,
    moved,
    is_same,
    turns_about,
    is_beyond,
    gives_power,
    step_adjoint,
    round_step,
):
    _function.adj.skip_reverse_codegen = True
