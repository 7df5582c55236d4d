"""Where feet stand in a state of MJX, how they move, and how they respond to forces."""

from __future__ import annotations

from typing import Any, NamedTuple

import jax.numpy as jnp
import numpy as np
from mujoco import mjx
from numpy.typing import NDArray

from tribos._mjx_solve import Compliance, Groups

# Motions of a foot: along x, along y, spin; lift, tilts about x and y.
PLANE, SPRINGS = slice(0, 3), slice(3, 6)


class Links(NamedTuple):
    """What feet are in a model, as arrays over n feet."""

    geoms: tuple[tuple[int, ...], ...]
    """Geoms of each foot."""
    grounds: tuple[tuple[int, ...], ...]
    """Geoms that it stands on."""
    bodies: NDArray[np.int64]
    """Bodies of the foot and of its ground, (n, 2)."""
    frames: NDArray[np.int64]
    """Index of the frame of its patch among all geoms, bodies and sites of the model, (n,)."""
    senses: NDArray[np.float64]
    """1 for the degrees of freedom that move the foot, -1 for those that move its ground, 0 for others, (n, nv)."""
    roots: NDArray[np.int64]
    """Root of the tree of each degree of freedom, (nv,)."""
    free: NDArray[np.int64]
    """Bodies that move freely: alone in their trees, on a free joint without armature and damping."""
    free_freedoms: NDArray[np.int64]
    """Their degrees of freedom, one body after another."""
    freedoms: NDArray[np.int64]
    """The other ones."""
    groups: Groups
    """Feet that move each other."""


class Touch(NamedTuple):
    """Contacts of each foot with its ground in the step that was made last."""

    load: Any
    """Sum of the normal forces, in N, (n,)."""
    normal: Any
    """Sum of the normals from the ground to the foot, (n, 3)."""
    position: Any
    """Mean position, in m, (n, 3)."""
    is_touching: Any
    """(n,)"""
    senses: Any
    """Of the contacts: 1 or -1, the sense of MuJoCo's normal, and 0 for those of other feet, (n, contacts)."""


class Place(NamedTuple):
    """Where patches lie."""

    axes: Any
    """The patch's x, y and normal in the rows, (n, 3, 3)."""
    centre: Any
    """In m, (n, 3)."""


def touch(links: Links, d: Any) -> Touch:
    """The contacts of the last step."""
    contact = d._impl.contact
    rows = np.nonzero(contact.dim == 1)[0]
    pairs = contact.geom[rows]
    senses = []
    for geoms, grounds in zip(links.geoms, links.grounds, strict=True):
        of = [jnp.isin(pairs[:, side], jnp.array(geoms)) for side in range(2)]
        on = [jnp.isin(pairs[:, side], jnp.array(grounds)) for side in range(2)]
        senses.append((of[1] & on[0]) * 1.0 - (of[0] & on[1]) * 1.0)
    is_active = contact.dist[rows] < contact.includemargin[rows]
    sense = jnp.where(is_active, jnp.stack(senses), 0.0).astype(d.qvel.dtype)
    is_own = jnp.abs(sense)
    count = is_own.sum(axis=-1)
    force = d._impl.efc_force[contact.efc_address[rows]]
    return Touch(
        load=jnp.maximum(is_own @ force, 0.0),
        normal=sense @ contact.frame[rows, 0],
        position=is_own @ contact.pos[rows] / jnp.maximum(count, 1.0)[:, None],
        is_touching=count > 0.0,
        senses=sense,
    )


def carried(links: Links, touch: Touch, before: Any, after: Any) -> Touch:
    """The contacts in a later state: points go with their feet, normals with their grounds."""
    foot, ground = links.bodies.T
    turned = jnp.einsum("nij,nkj->nik", after.xmat[ground], before.xmat[ground])
    lever = jnp.einsum("nji,nj->ni", before.xmat[foot], touch.position - before.xpos[foot])
    position = after.xpos[foot] + jnp.einsum("nij,nj->ni", after.xmat[foot], lever)
    return touch._replace(normal=jnp.einsum("nij,nj->ni", turned, touch.normal), position=position)


def place(links: Links, touch: Touch, d: Any) -> Place:
    """The plane, centre and axes of each patch."""
    origins = jnp.concatenate([d.geom_xpos, d.xpos, d.site_xpos])[links.frames]
    frames = jnp.concatenate([d.geom_xmat, d.xmat, d.site_xmat])[links.frames]
    upright = jnp.array([0.0, 0.0, 1.0], origins.dtype)
    normal = _unit(jnp.where(touch.is_touching[:, None], touch.normal, upright))
    # The origin of the frame, brought along the normal to the mean height of the contacts.
    height = (normal * (touch.position - origins)).sum(axis=-1)
    centre = origins + normal * height[:, None]
    # The frame's axis after the one along the normal is the patch's x.
    along = jnp.einsum("nij,ni->nj", frames, normal)
    following = (jnp.argmax(jnp.abs(along), axis=-1) + 1) % 3
    x = jnp.take_along_axis(frames, following[:, None, None], axis=2)[:, :, 0]
    x = _unit(x - normal * (x * normal).sum(axis=-1, keepdims=True))
    return Place(jnp.stack([x, jnp.cross(normal, x), normal], axis=1), centre)


def _unit(vectors: Any) -> Any:
    square = (vectors * vectors).sum(axis=-1, keepdims=True)
    # Normals of a foot between two faces may cancel.
    return vectors / jnp.sqrt(jnp.where(square > 0.0, square, 1.0))


def jacobian(links: Links, place: Place, d: Any) -> Any:
    """Motions of each foot on its ground by the degrees of freedom, (n, 6, nv)."""
    # MuJoCo's axes are angular and linear, the latter at the centre of mass of the tree.
    turn = d.cdof[None, :, :3] * links.senses[:, :, None].astype(d.cdof.dtype)
    shift = d.cdof[None, :, 3:] * links.senses[:, :, None].astype(d.cdof.dtype)
    shift = shift + jnp.cross(turn, place.centre[:, None, :] - d.subtree_com[links.roots][None])
    shift, turn = (jnp.einsum("nik,njk->nij", place.axes, one) for one in (shift, turn))
    return jnp.concatenate([shift[:, :2], turn[:, 2:], shift[:, 2:], turn[:, :2]], axis=1)


def stiffness(touch: Touch, place: Place, d: Any) -> Any:
    """Of the contacts' normal forces in lift and tilts, (n, 3, 3)."""
    contact = d._impl.contact
    rows = np.nonzero(contact.dim == 1)[0]
    normals = touch.senses[:, :, None] * contact.frame[rows, 0][None]
    levers = contact.pos[rows][None] - place.centre[:, None, :]
    moments = jnp.einsum("nck,nik->nci", jnp.cross(levers, normals), place.axes[:, :2])
    own = jnp.abs(touch.senses)
    parts = jnp.concatenate([own[:, :, None], moments], axis=-1)
    stiff = d._impl.efc_D[contact.efc_address[rows]] * own
    return jnp.einsum("nc,nci,ncj->nij", stiff, parts, parts)


def compliance(m: Any, links: Links, touch: Touch, place: Place, d: Any) -> tuple[Compliance, Any]:
    """Acceleration of feet in their planes by friction on each, with the springs of their contacts; and the motions by the degrees
    of freedom."""
    rows, stiff = jacobian(links, place, d), stiffness(touch, place, d)
    solved = _solved(m, links, rows, d)
    blocks = []
    for one in links.groups.classes:
        count, size = one.shape
        mobility = jnp.einsum("gaij,gbkj->gaibk", rows[one], solved[one])
        flat = (count, 3 * size, 3 * size)
        plane = mobility[:, :, PLANE, :, PLANE].reshape(flat)
        across = mobility[:, :, PLANE, :, SPRINGS].reshape(flat)
        lifts = mobility[:, :, SPRINGS, :, SPRINGS].reshape(flat)
        # P - M K (1 + N K)^-1 M^T in the blocks P in the plane, N along the normals, M between them, K of the springs.
        springs = jnp.einsum("gaij,ab->gaibj", stiff[one], jnp.eye(size, dtype=rows.dtype)).reshape(
            flat
        )
        system = jnp.eye(3 * size, dtype=rows.dtype) + lifts @ springs
        forces = springs @ jnp.linalg.solve(system, jnp.swapaxes(across, -1, -2))
        found = plane - across @ forces
        found = 0.5 * (found + jnp.swapaxes(found, -1, -2))
        # Feet without contact have no friction; any number is a compliance of theirs.
        lone = jnp.repeat(jnp.where(touch.is_touching[one], 0.0, 1.0), 3, axis=-1)
        blocks.append(found + lone[:, :, None] * jnp.eye(3 * size, dtype=rows.dtype))
    return Compliance(links.groups, tuple(blocks)), rows


def _solved(m: Any, links: Links, rows: Any, d: Any) -> Any:
    """Accelerations of the degrees of freedom by unit wrenches: the inverse mass times rows (n, 6, nv)."""
    made = jnp.zeros_like(rows)
    free, index = links.free, links.free_freedoms
    if free.size:
        given = rows[:, :, index].reshape(*rows.shape[:2], free.size, 6)
        found = _free_solved(m, free, given, d)
        made = made.at[:, :, index].set(found.reshape(*rows.shape[:2], -1))
    rest = links.freedoms
    if rest.size:
        # Euler's and the implicit integrators take the damping of joints at the end of the step.
        mass = mjx.full_m(m, d)[np.ix_(rest, rest)] + jnp.diag(m.opt.timestep * m.dof_damping[rest])
        # Data without a step or `mjx.forward` have no masses yet, nor contacts.
        mass = mass + jnp.diag(jnp.where(jnp.diag(mass) > 0.0, 0.0, 1.0))
        given = rows[:, :, rest].reshape(-1, rest.size).T
        found = jnp.linalg.solve(mass, given).T
        made = made.at[:, :, rest].set(found.reshape(*rows.shape[:2], -1))
    return made


def _free_solved(m: Any, free: NDArray[np.int64], rows: Any, d: Any) -> Any:
    """The same for bodies that move freely, rows of (n, 6, bodies, 6): Newton and Euler about the centre of mass."""
    lever, turn = d.xipos[free] - d.xpos[free], d.xmat[free]
    force, torque = rows[..., :3], jnp.einsum("bij,nkbj->nkbi", turn, rows[..., 3:])
    torque = torque - jnp.cross(lever, force)
    inertia = d.ximat[free]
    moment = jnp.einsum("bji,nkbj->nkbi", inertia, torque) / m.body_inertia[free]
    spin = jnp.einsum("bij,nkbj->nkbi", inertia, moment)
    shift = force / m.body_mass[free][:, None] - jnp.cross(spin, lever)
    return jnp.concatenate([shift, jnp.einsum("bji,nkbj->nkbi", turn, spin)], axis=-1)
