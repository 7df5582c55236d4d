"""Feet of bodies in MuJoCo Warp: loads from contacts, and friction as a passive force, in three launches.

One thread serves a foot, a contact, or a world: nothing is allocated, nothing is read by the host, and no
sum depends on the order of threads.
"""

from __future__ import annotations

import warp as wp

from tribos.warp._forms import PARABOLOID
from tribos.warp._project import round_projected
from tribos.warp._search import Shape, shape_projected
from tribos.warp._step import is_same, turns_about

# No derivatives, and the same digits on every device.
wp.set_module_options({"enable_backward": False, "fuse_fp": False})

# What a body is to a foot: fast to the world or moved by what is no free joint, or free.
FREE = wp.constant(1)
MOVED = wp.constant(2)
# Where the frame of a patch comes from.
OF_GEOM = wp.constant(0)
OF_BODY = wp.constant(1)
# Contacts of a geom whose number among them makes a key.
KEY = wp.constant(1024)
# Share of the radius by which a round patch may be off the axis of its body's inertia.
CENTRED = wp.constant(1e-5)


@wp.struct
class Engine:
    """Arrays of a model and its data."""

    timestep: wp.array(dtype=float)
    gravity: wp.array(dtype=wp.vec3)
    body_mass: wp.array2d(dtype=float)
    body_inertia: wp.array2d(dtype=wp.vec3)
    body_dofadr: wp.array(dtype=int)
    body_rootid: wp.array(dtype=int)
    body_isdofancestor: wp.array2d(dtype=int)
    nv: int
    xpos: wp.array2d(dtype=wp.vec3)
    xmat: wp.array2d(dtype=wp.mat33)
    xipos: wp.array2d(dtype=wp.vec3)
    ximat: wp.array2d(dtype=wp.mat33)
    geom_xpos: wp.array2d(dtype=wp.vec3)
    geom_xmat: wp.array2d(dtype=wp.mat33)
    site_xpos: wp.array2d(dtype=wp.vec3)
    site_xmat: wp.array2d(dtype=wp.mat33)
    subtree_com: wp.array2d(dtype=wp.vec3)
    cvel: wp.array2d(dtype=wp.spatial_vector)
    cdof: wp.array2d(dtype=wp.spatial_vector)
    qvel: wp.array2d(dtype=float)
    qfrc_applied: wp.array2d(dtype=float)
    qfrc_actuator: wp.array2d(dtype=float)
    qfrc_constraint: wp.array2d(dtype=float)
    xfrc_applied: wp.array2d(dtype=wp.spatial_vector)
    contact_pos: wp.array(dtype=wp.vec3)
    contact_frame: wp.array(dtype=wp.mat33)
    contact_geom: wp.array(dtype=wp.vec2i)
    contact_world: wp.array(dtype=int)
    contact_number: wp.array(dtype=int)
    contact_row: wp.array2d(dtype=int)
    contact_count: wp.array(dtype=int)
    force: wp.array2d(dtype=float)


@wp.struct
class Feet:
    """Feet of each world: what they are, and their state."""

    count: int
    sweeps: int
    # Geoms of feet and the floors that they stand on.
    geom: wp.array(dtype=int)
    floor: wp.array(dtype=int)
    foot: wp.array(dtype=int)
    # A foot: bodies of it and its floor, and what the floor's is; frame and patch.
    bodies: wp.array(dtype=wp.vec2i)
    floor_kind: wp.array(dtype=int)
    rolls: wp.array(dtype=int)
    frame: wp.array(dtype=wp.vec2i)
    kind: wp.array(dtype=int)
    sides: wp.array(dtype=wp.vec2)
    corners: wp.array2d(dtype=wp.vec2)
    shape_frame: wp.array(dtype=wp.vec4)
    # A world and a foot.
    mu: wp.array2d(dtype=float)
    load: wp.array2d(dtype=float)
    friction: wp.array2d(dtype=wp.vec3)
    twist: wp.array2d(dtype=wp.vec3)
    axes: wp.array2d(dtype=wp.mat33)
    centre: wp.array2d(dtype=wp.vec3)
    held: wp.array2d(dtype=int)
    pushed: wp.array2d(dtype=wp.vec3)
    yielding: wp.array2d(dtype=wp.mat33)
    # Contacts of a foot in the last step: how many, their keys, numbers and rows of forces.
    contacts: wp.array2d(dtype=int)
    key: wp.array3d(dtype=int)
    contact: wp.array3d(dtype=int)
    row: wp.array3d(dtype=int)


@wp.kernel
def sum_loads(engine: Engine, feet: Feet):
    """Loads are the sums of the normal forces of the step before, whose contacts are still known."""
    w, k = wp.tid()
    load = float(0.0)
    for i in range(wp.min(feet.contacts[w, k], feet.row.shape[2])):
        load += engine.force[w, feet.row[w, k, i]]
    feet.load[w, k] = load
    feet.contacts[w, k] = 0


@wp.kernel
def find_contacts(engine: Engine, feet: Feet):
    """Gives each contact to its foot."""
    c = wp.tid()
    if c >= engine.contact_count[0]:
        return
    row = engine.contact_row[c, 0]
    if row < 0:
        return
    geoms = engine.contact_geom[c]
    w = engine.contact_world[c]
    for i in range(feet.geom.shape[0]):
        a = feet.geom[i]
        b = feet.floor[i]
        if (geoms[0] == a and geoms[1] == b) or (geoms[0] == b and geoms[1] == a):
            k = feet.foot[i]
            place = wp.atomic_add(feet.contacts, w, k, 1)
            if place < feet.row.shape[2]:
                feet.key[w, k, place] = a * KEY + engine.contact_number[c]
                feet.contact[w, k, place] = c
                feet.row[w, k, place] = row


@wp.func
def sort_contacts(feet: Feet, w: int, k: int, count: int):
    """Contacts by their keys, whatever thread found them first."""
    for i in range(1, count):
        for back in range(i):
            j = i - back
            if feet.key[w, k, j] < feet.key[w, k, j - 1]:
                key = feet.key[w, k, j]
                contact = feet.contact[w, k, j]
                row = feet.row[w, k, j]
                feet.key[w, k, j] = feet.key[w, k, j - 1]
                feet.contact[w, k, j] = feet.contact[w, k, j - 1]
                feet.row[w, k, j] = feet.row[w, k, j - 1]
                feet.key[w, k, j - 1] = key
                feet.contact[w, k, j - 1] = contact
                feet.row[w, k, j - 1] = row


@wp.func
def patch_axes(matrix: wp.mat33, normal: wp.vec3) -> wp.mat33:
    """Rows x, y and normal; x is that axis of the frame which follows the one along the normal."""
    along = wp.vec3(
        wp.abs(wp.dot(wp.vec3(matrix[0, 0], matrix[1, 0], matrix[2, 0]), normal)),
        wp.abs(wp.dot(wp.vec3(matrix[0, 1], matrix[1, 1], matrix[2, 1]), normal)),
        wp.abs(wp.dot(wp.vec3(matrix[0, 2], matrix[1, 2], matrix[2, 2]), normal)),
    )
    following = int(1)
    if along[1] > along[0] and along[1] > along[2]:
        following = int(2)
    elif along[2] >= along[0]:
        following = int(0)
    axis = wp.vec3(matrix[0, following], matrix[1, following], matrix[2, following])
    x = wp.normalize(axis - wp.dot(axis, normal) * normal)
    y = wp.cross(normal, x)
    return wp.mat33(x[0], x[1], x[2], y[0], y[1], y[2], normal[0], normal[1], normal[2])


@wp.func
def turned(vector: wp.vec3, normal: wp.vec3, half: float) -> wp.vec3:
    """A vector turned about a normal by twice the angle whose tangent is given: no library's sine."""
    along = wp.dot(vector, normal) * normal
    across = vector - along
    per = 1.0 / (1.0 + half * half)
    cos = (1.0 - half * half) * per
    return along + cos * across + ((half + half) * per) * wp.cross(normal, across)


@wp.func
def turn_to_half_time(engine: Engine, feet: Feet, w: int, k: int, dt: float):
    """The patch as the body's spin will have turned it about the centre of mass in half a step."""
    body = feet.bodies[k][0]
    axes = feet.axes[w, k]
    normal = wp.vec3(axes[2, 0], axes[2, 1], axes[2, 2])
    # Half of the angle, for its tangent.
    half = 0.25 * dt * wp.dot(wp.spatial_top(engine.cvel[w, body]), normal)
    x = turned(wp.vec3(axes[0, 0], axes[0, 1], axes[0, 2]), normal, half)
    y = wp.cross(normal, x)
    feet.axes[w, k] = wp.mat33(x[0], x[1], x[2], y[0], y[1], y[2], normal[0], normal[1], normal[2])
    com = engine.xipos[w, body]
    feet.centre[w, k] = com + turned(feet.centre[w, k] - com, normal, half)


@wp.func
def inverse_inertia(engine: Engine, w: int, body: int, normal: wp.vec3, rolls: int) -> wp.mat33:
    """About the normal alone, where contacts keep the body from tilting, or of a body that rolls."""
    matrix = engine.ximat[w, body]
    inertia = engine.body_inertia[w % engine.body_inertia.shape[0], body]
    if rolls == 1:
        per = wp.diag(wp.vec3(1.0 / inertia[0], 1.0 / inertia[1], 1.0 / inertia[2]))
        return matrix * per * wp.transpose(matrix)
    own = wp.transpose(matrix) * normal
    return wp.outer(normal, normal) / wp.dot(own, wp.cw_mul(inertia, own))


@wp.func
def response(
    engine: Engine, feet: Feet, w: int, k: int, body: int, force: wp.vec3, torque: wp.vec3
) -> wp.vec3:
    """The acceleration at a foot of a free body under a force at its centre of mass and a torque."""
    axes = feet.axes[w, k]
    normal = wp.vec3(axes[2, 0], axes[2, 1], axes[2, 2])
    spin = inverse_inertia(engine, w, body, normal, feet.rolls[k]) * torque
    arm = feet.centre[w, k] - engine.xipos[w, body]
    mass = engine.body_mass[w % engine.body_mass.shape[0], body]
    at = axes * (force / mass + wp.cross(spin, arm))
    return wp.vec3(at[0], at[1], wp.dot(normal, spin))


@wp.func
def response_to_foot(
    engine: Engine, feet: Feet, w: int, k: int, body: int, j: int, wrench: wp.vec3
) -> wp.vec3:
    """The acceleration at a foot of a free body under the wrench of a foot on that body."""
    axes = feet.axes[w, j]
    force = wp.transpose(axes) * wp.vec3(wrench[0], wrench[1], 0.0)
    normal = wp.vec3(axes[2, 0], axes[2, 1], axes[2, 2])
    arm = feet.centre[w, j] - engine.xipos[w, body]
    return response(engine, feet, w, k, body, force, wrench[2] * normal + wp.cross(arm, force))


@wp.func
def motion_at(engine: Engine, feet: Feet, w: int, k: int, body: int) -> wp.vec3:
    """Velocity and spin of a body at a foot, in the axes of the patch.

    Tilting counts only for a body that rolls.
    """
    axes = feet.axes[w, k]
    normal = wp.vec3(axes[2, 0], axes[2, 1], axes[2, 2])
    motion = engine.cvel[w, body]
    spin = wp.spatial_top(motion)
    velocity = wp.spatial_bottom(motion) + wp.cross(
        spin, engine.xipos[w, body] - engine.subtree_com[w, engine.body_rootid[body]]
    )
    if feet.rolls[k] == 0:
        spin = wp.dot(spin, normal) * normal
    at = axes * (velocity + wp.cross(spin, feet.centre[w, k] - engine.xipos[w, body]))
    return wp.vec3(at[0], at[1], wp.dot(normal, spin))


@wp.func
def row_at(forces: wp.array2d(dtype=float), w: int, first: int) -> wp.vec3:
    return wp.vec3(forces[w, first], forces[w, first + 1], forces[w, first + 2])


@wp.func
def acceleration(
    engine: Engine, feet: Feet, w: int, k: int, body: int, passive: wp.array2d(dtype=float)
) -> wp.vec3:
    """The acceleration of a free body at a foot under all forces but friction."""
    first = engine.body_dofadr[body]
    # Actuators and constraints are those of the step before.
    force = (
        row_at(passive, w, first)
        + row_at(engine.qfrc_applied, w, first)
        + row_at(engine.qfrc_actuator, w, first)
        + row_at(engine.qfrc_constraint, w, first)
    )
    own = (
        row_at(passive, w, first + 3)
        + row_at(engine.qfrc_applied, w, first + 3)
        + row_at(engine.qfrc_actuator, w, first + 3)
        + row_at(engine.qfrc_constraint, w, first + 3)
    )
    arm = engine.xipos[w, body] - engine.xpos[w, body]
    torque = engine.xmat[w, body] * own - wp.cross(arm, force)
    applied = engine.xfrc_applied[w, body]
    mass = engine.body_mass[w % engine.body_mass.shape[0], body]
    gravity = engine.gravity[w % engine.gravity.shape[0]]
    force = force + wp.spatial_top(applied) + mass * gravity
    torque = torque + wp.spatial_bottom(applied)
    return response(engine, feet, w, k, body, force, torque)


@wp.func
def prepare(
    engine: Engine, feet: Feet, w: int, k: int, dt: float, passive: wp.array2d(dtype=float)
):
    """Frame, motion, acceleration and compliance of a foot that touches its floor."""
    count = wp.min(feet.contacts[w, k], feet.row.shape[2])
    sort_contacts(feet, w, k, count)
    place = wp.vec3(0.0, 0.0, 0.0)
    for i in range(count):
        place += engine.contact_pos[feet.contact[w, k, i]]
    place = place / float(count)
    first = feet.contact[w, k, 0]
    frame = engine.contact_frame[first]
    normal = wp.vec3(frame[0, 0], frame[0, 1], frame[0, 2])
    # From the floor to the foot.
    if engine.contact_geom[first][0] == feet.key[w, k, 0] // KEY:
        normal = -normal
    of = feet.frame[k]
    origin = wp.vec3(0.0, 0.0, 0.0)
    matrix = wp.identity(n=3, dtype=float)
    if of[0] == OF_GEOM:
        origin = engine.geom_xpos[w, of[1]]
        matrix = engine.geom_xmat[w, of[1]]
    elif of[0] == OF_BODY:
        origin = engine.xpos[w, of[1]]
        matrix = engine.xmat[w, of[1]]
    else:
        origin = engine.site_xpos[w, of[1]]
        matrix = engine.site_xmat[w, of[1]]
    feet.axes[w, k] = patch_axes(matrix, normal)
    feet.centre[w, k] = origin - wp.dot(origin - place, normal) * normal
    if feet.rolls[k] == 0:
        turn_to_half_time(engine, feet, w, k, dt)
    bodies = feet.bodies[k]
    twist = motion_at(engine, feet, w, k, bodies[0])
    pushed = acceleration(engine, feet, w, k, bodies[0], passive)
    if feet.floor_kind[k] != 0:
        twist = twist - motion_at(engine, feet, w, k, bodies[1])
    if feet.floor_kind[k] == FREE:
        pushed = pushed - acceleration(engine, feet, w, k, bodies[1], passive)
    feet.twist[w, k] = twist
    feet.pushed[w, k] = pushed
    yielding = wp.mat33(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    for i in range(3):
        unit = wp.vec3(0.0, 0.0, 0.0)
        unit[i] = 1.0
        column = response_to_foot(engine, feet, w, k, bodies[0], k, unit)
        if feet.floor_kind[k] == FREE:
            column = column + response_to_foot(engine, feet, w, k, bodies[1], k, unit)
        for j in range(3):
            yielding[j, i] = column[j]
    feet.yielding[w, k] = yielding


@wp.func
def of_others(engine: Engine, feet: Feet, w: int, k: int) -> wp.vec3:
    """The acceleration at a foot by the friction of all others."""
    total = wp.vec3(0.0, 0.0, 0.0)
    own = feet.bodies[k]
    floor_is_free = feet.floor_kind[k] == FREE
    for j in range(feet.count):
        if j != k and feet.contacts[w, j] > 0:
            other = feet.bodies[j]
            wrench = feet.friction[w, j]
            if own[0] == other[0]:
                total += response_to_foot(engine, feet, w, k, own[0], j, wrench)
            if own[0] == other[1]:
                total -= response_to_foot(engine, feet, w, k, own[0], j, wrench)
            if floor_is_free and own[1] == other[0]:
                total -= response_to_foot(engine, feet, w, k, own[1], j, wrench)
            if floor_is_free and own[1] == other[1]:
                total += response_to_foot(engine, feet, w, k, own[1], j, wrench)
    return total


@wp.func
def nearest(feet: Feet, k: int, needed: wp.vec3, limit: float, metric: wp.mat33) -> wp.vec3:
    """The wrench nearest to the needed one that a foot carries."""
    frame = feet.shape_frame[k]
    off = CENTRED * frame[2] * metric[0, 0]
    if feet.kind[k] <= PARABOLOID:
        is_centred = wp.abs(metric[0, 2]) + wp.abs(metric[1, 2]) <= off
        if is_centred and wp.abs(metric[0, 1]) <= CENTRED * metric[0, 0]:
            length = wp.sqrt(metric[2, 2] / metric[0, 0])
            return round_projected(feet.kind[k], needed, limit, frame[2], length)
    shape = Shape()
    shape.kind = feet.kind[k]
    shape.sides = feet.sides[k]
    shape.corners = feet.corners[k]
    return shape_projected(shape, frame, needed, limit, metric / metric[0, 0])


@wp.func
def carry(engine: Engine, feet: Feet, w: int, k: int, dt: float):
    """Friction of a foot over a step, beside that of all others."""
    twist = feet.twist[w, k]
    pushed = feet.pushed[w, k] + of_others(engine, feet, w, k)
    yielding = feet.yielding[w, k]
    metric = wp.inverse(yielding)
    limit = feet.mu[w, k] * wp.max(feet.load[w, k], 0.0)
    feet.held[w, k] = 0
    at_end = -(metric * (twist / dt + pushed))
    ended = nearest(feet, k, at_end, limit, metric)
    if is_same(ended, at_end):
        feet.held[w, k] = 1
        feet.friction[w, k] = ended
        return
    at_half = -(metric * (2.0 * twist / dt + pushed))
    midway = nearest(feet, k, at_half, limit, metric)
    after = twist + dt * (pushed + yielding * midway)
    if turns_about(twist, after):
        last = twist + dt * (pushed + yielding * ended)
        if wp.dot(ended, twist + last) <= 0.0:
            midway = ended
    feet.friction[w, k] = midway


@wp.func
def push_body(
    engine: Engine,
    w: int,
    body: int,
    is_free: bool,
    centre: wp.vec3,
    force: wp.vec3,
    torque: wp.vec3,
    passive: wp.array2d(dtype=float),
):
    """Adds a wrench at a point to the passive forces of a body."""
    if is_free:
        first = engine.body_dofadr[body]
        about = torque + wp.cross(centre - engine.xpos[w, body], force)
        own = wp.transpose(engine.xmat[w, body]) * about
        for i in range(3):
            passive[w, first + i] = passive[w, first + i] + force[i]
            passive[w, first + 3 + i] = passive[w, first + 3 + i] + own[i]
        return
    about = torque + wp.cross(centre - engine.subtree_com[w, engine.body_rootid[body]], force)
    for i in range(engine.nv):
        if engine.body_isdofancestor[body, i] != 0:
            axis = engine.cdof[w, i]
            gained = wp.dot(wp.spatial_top(axis), about) + wp.dot(wp.spatial_bottom(axis), force)
            passive[w, i] = passive[w, i] + gained


@wp.kernel
def add_friction(engine: Engine, feet: Feet, passive: wp.array2d(dtype=float)):
    """Friction of all feet of a world, solved in turn where they move each other."""
    w = wp.tid()
    dt = engine.timestep[w % engine.timestep.shape[0]]
    for k in range(feet.count):
        if feet.contacts[w, k] > 0:
            prepare(engine, feet, w, k, dt, passive)
        else:
            feet.friction[w, k] = wp.vec3(0.0, 0.0, 0.0)
            feet.held[w, k] = 0
    for _ in range(feet.sweeps):
        for k in range(feet.count):
            if feet.contacts[w, k] > 0:
                carry(engine, feet, w, k, dt)
    for k in range(feet.count):
        if feet.contacts[w, k] > 0:
            axes = wp.transpose(feet.axes[w, k])
            wrench = feet.friction[w, k]
            force = axes * wp.vec3(wrench[0], wrench[1], 0.0)
            torque = axes * wp.vec3(0.0, 0.0, wrench[2])
            centre = feet.centre[w, k]
            bodies = feet.bodies[k]
            push_body(engine, w, bodies[0], True, centre, force, torque, passive)
            if feet.floor_kind[k] != 0:
                is_free = feet.floor_kind[k] == FREE
                push_body(engine, w, bodies[1], is_free, centre, -force, -torque, passive)
