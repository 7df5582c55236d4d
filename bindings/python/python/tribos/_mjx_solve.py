"""Friction of feet that move each other, in one implicit time step of a JAX program.

The rules are those of MuJoCo's plugin ``tribos.patch`` (engines/mujoco/src/step.c). Searches are projected gradient steps on
all feet at once, with the momentum of Nesterov, in place of its sweeps over one foot after another: one graph to compile, and
as many feet a pass as a device takes. Derivatives are those of the implicit function theorem.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

import jax
import jax.numpy as jnp
import numpy as np
from numpy.typing import NDArray

# Rounds of a search, at most.
ROUNDS = 200
# Share of the largest compliance that is added to all, such that a mechanism that lacks motions has an inverse; and share of the
# largest response of friction below which forces between feet are not sought. In float64 and in float32.
FLOOR = {"float64": 1e-12, "float32": 1e-6}
BETWEEN = 1e-4
# Change of friction at which searches end, and velocity that counts as none, in units of what the largest friction changes in a
# step. float32 resolves friction to some 1e-6.
TOLERANCE = {"float64": 1e-9, "float32": 4e-6}
STILL = {"float64": 1e-6, "float32": 2e-5}
# The same for velocities of feet against each other, which a body takes that tilts on its contacts' springs.
GIVE = 1e-3
# By how much the matrix of the implicit derivative is kept from being singular where friction between feet is undetermined.
LIFTED = {"float64": 1e-9, "float32": 1e-5}


class Sets(Protocol):
    """All friction that each of n feet can carry."""

    def nearest(self, wrenches: Any, lengths: Any) -> Any:
        """The friction nearest to wrenches (n, 3), where torques are divided by lengths (n,); the same bits if it is one."""

    @property
    def lengths(self) -> Any:
        """The only lengths (n,) with which `nearest` can be asked, NaN where any will do."""

    @property
    def limits(self) -> Any:
        """Force limits (n,), in N."""

    @property
    def arms(self) -> Any:
        """Largest torques per force (n,), in m."""


class Groups(NamedTuple):
    """Feet that move each other, by their indices: an array (groups, size) for each size."""

    classes: tuple[NDArray[np.int64], ...]
    """Indices of feet; every foot is in one of them."""

    @property
    def order(self) -> NDArray[np.int64]:
        """Where each foot stands in the classes one after another."""
        return np.argsort(np.concatenate([one.ravel() for one in self.classes]))

    def join(self, parts: list[Any]) -> Any:
        """Rows of feet (n, …) from those of each class (groups, size, …)."""
        flat = [part.reshape((-1,) + part.shape[2:]) for part in parts]
        return (
            jnp.concatenate(flat)[self.order] if len(flat) > 1 or flat[0].shape[0] > 1 else flat[0]
        )

    def total(self, x: Any) -> Any:
        """Sums over the feet of each group, at each of its feet."""
        made = [x[one].sum(axis=1, keepdims=True) for one in self.classes]
        return self.join(
            [jnp.broadcast_to(m, c.shape) for m, c in zip(made, self.classes, strict=True)]
        )

    def any(self, mask: Any) -> Any:
        """Whether something is true of any foot of each group, at each of its feet."""
        made = [mask[one].any(axis=1, keepdims=True) for one in self.classes]
        return self.join(
            [jnp.broadcast_to(m, c.shape) for m, c in zip(made, self.classes, strict=True)]
        )


class Found(NamedTuple):
    """Friction of a step."""

    friction: Any
    """On each foot (n, 3), in N, N and N m."""
    response: Any
    """Acceleration of each foot by the friction of all, (n, 3)."""
    is_held: Any
    """The foot is at rest on its ground at the end of the step."""
    is_missed: Any
    """A search for the friction of its group ended at its count."""


class Compliance(NamedTuple):
    """Acceleration of feet by wrenches on them: matrices (groups, 3 size, 3 size) of each class."""

    groups: Groups
    blocks: tuple[Any, ...]

    def times(self, wrenches: Any) -> Any:
        """Accelerations (n, 3) by wrenches (n, 3)."""
        parts = []
        for one, block in zip(self.groups.classes, self.blocks, strict=True):
            moved = jnp.einsum("gij,gj->gi", block, wrenches[one].reshape(one.shape[0], -1))
            parts.append(moved.reshape(*one.shape, 3))
        return self.groups.join(parts)

    def own(self) -> Any:
        """The blocks of each foot, (n, 3, 3)."""
        parts = []
        for one, block in zip(self.groups.classes, self.blocks, strict=True):
            count, size = one.shape
            pairs = block.reshape(count, size, 3, size, 3)
            parts.append(jnp.stack([pairs[:, k, :, k, :] for k in range(size)], axis=1))
        return self.groups.join(parts)


class Metric(NamedTuple):
    """Isotropic compliances of feet that are together above the true one."""

    rates: Any
    """Wrench per acceleration, (n, 3)."""
    bounds: Any
    """Acceleration per force, (n,)."""
    lengths: Any
    """What makes a force of a torque, in m, (n,)."""
    left: Any
    """Distance from the solution in units of the last step, for feet alone; 1 for others."""


def solve(
    sets: Sets, compliance: Compliance, velocity: Any, rate: Any, start: Any, dt: Any
) -> Found:
    """Friction such that each foot is at rest at the end of the step where the patches can carry that; otherwise friction opposes
    the motion at half time, or at the end where a foot turns about.

    Parameters
    ----------
    velocity, rate
        Motion of the feet on their grounds before the step and its rate without friction, (n, 3), in m/s and rad/s, m/s² and
        rad/s².
    start
        Friction that searches begin with, (n, 3).
    dt
        Length of the step, in s.
    """
    dtype = str(velocity.dtype)
    compliance = _floored(compliance, sets.arms, FLOOR[dtype])
    metric = jax.tree.map(jax.lax.stop_gradient, _metric(compliance, sets.lengths))
    # Friction that ends the step at rest.
    at_end = rate + velocity / dt
    rest = _rest(sets, compliance, at_end)
    is_still = _stills(sets, compliance, metric, rest, at_end)
    first, start = jax.lax.stop_gradient((rest, start))
    search = _Search(sets, compliance, metric)

    def searched(state: Any, task: _Task) -> Any:
        at, known = state
        found, missed = search.friction(at, rate + task.per_time * velocity, known, task)
        # First whether feet can carry what brings them to rest; then friction of the motion at half time; then that of its end,
        # for motions that would turn about.
        holds = is_still & ~compliance.groups.any((found != first).any(axis=-1))
        goes_on = _turns_about(sets, compliance, found, velocity, rate, dt)
        known = jnp.where(task.share > 0.0, known | ~goes_on, holds)
        return (start, known), (found, missed, known)

    # One search for all three, in a loop: JAX would compile it as often as it stands in the text.
    tasks = _Task(
        per_time=jnp.array([1.0, 2.0, 1.0], velocity.dtype) / dt,
        share=jnp.array([0.0, 1.0, 1.0], velocity.dtype),
        rounds=jnp.array([1, ROUNDS, ROUNDS]),
    )
    nothing = jnp.zeros(start.shape[0], bool)
    _, (frictions, missed, known) = jax.lax.scan(searched, (first, nothing), tasks)
    midway, ended = frictions[1], frictions[2]
    is_rest = known[0]
    gains = compliance.groups.total(_power(compliance, ended, velocity, rate, dt)) > 0.0
    is_late = ~known[1] & ~gains
    friction = _where(is_late, ended, midway)
    friction = _where(is_rest, rest, _without_gain(compliance, friction, velocity, rate, dt))
    # Where it stands.
    response = compliance.times(friction)
    after = velocity + dt * (rate + response)
    none = STILL[dtype] * metric.bounds * sets.limits * dt
    is_slow = (_norm(after) <= none) & (jnp.abs(after[:, 2]) * sets.arms <= none)
    is_missed = ~is_rest & (missed[1] | (missed[2] & is_late))
    return Found(friction, response, (is_rest | is_slow) & (sets.limits > 0.0), is_missed)


def _where(mask: Any, a: Any, b: Any) -> Any:
    return jnp.where(mask[:, None], a, b)


def _norm(rows: Any) -> Any:
    """Length of the first two components; its derivative is not used."""
    return jnp.sqrt(jax.lax.stop_gradient(rows[:, 0] ** 2 + rows[:, 1] ** 2))


def _diagonal(rows: Any) -> Any:
    """Matrices with these diagonals."""
    return rows[..., :, None] * jnp.eye(rows.shape[-1], dtype=rows.dtype)


def _floored(compliance: Compliance, arms: Any, share: float) -> Compliance:
    blocks = []
    for one, block in zip(compliance.groups.classes, compliance.blocks, strict=True):
        arm_sq = arms[one] ** 2
        scale = jnp.stack([jnp.ones_like(arm_sq), jnp.ones_like(arm_sq), 1.0 / arm_sq], axis=-1)
        trace = jnp.diagonal(block, axis1=-2, axis2=-1).reshape(*one.shape, 3) / scale
        floor = share * trace.sum(axis=-1, keepdims=True) * scale
        blocks.append(block + _diagonal(floor.reshape(one.shape[0], -1)))
    return Compliance(compliance.groups, tuple(blocks))


def _metric(compliance: Compliance, fixed: Any) -> Metric:
    own = compliance.own()
    xx, yy, xy = own[:, 0, 0], own[:, 1, 1], own[:, 0, 1]
    largest = 0.5 * (xx + yy) + jnp.sqrt((0.5 * (xx - yy)) ** 2 + xy * xy)
    lengths = jnp.where(np.isnan(fixed), jnp.sqrt(largest / own[:, 2, 2]), np.nan_to_num(fixed))
    lengths = lengths.astype(own.dtype)
    one = jnp.ones_like(lengths)
    scale = jnp.stack([one, one, lengths], axis=-1)
    least, most = _eigenvalues(own * scale[:, :, None] * scale[:, None, :])
    condition = jnp.sqrt(most / jnp.maximum(least, jnp.finfo(most.dtype).eps * most))
    left = jnp.minimum(condition, condition * condition - 1.0)
    bounds, lefts = [], []
    for feet, block in zip(compliance.groups.classes, compliance.blocks, strict=True):
        count, size = feet.shape
        pairs = block.reshape(count, size, 3, size, 3)
        pairs = pairs * scale[feet][:, :, :, None, None] * scale[feet][:, None, None, :, :]
        norms = jnp.sqrt((pairs * pairs).sum(axis=(2, 4)))
        # The norm of a row of blocks bounds the largest eigenvalue (Gershgorin, for blocks).
        others = norms.sum(axis=-1) - jnp.diagonal(norms, axis1=-2, axis2=-1)
        bounds.append(most[feet] + others)
        lefts.append(left[feet] if size == 1 else jnp.ones_like(bounds[-1]))
    bound = compliance.groups.join(bounds)
    rates = jnp.stack([one, one, lengths**2], axis=-1) / bound[:, None]
    return Metric(rates, bound, lengths, compliance.groups.join(lefts))


def _eigenvalues(m: Any) -> tuple[Any, Any]:
    """Least and largest eigenvalue of symmetric matrices (n, 3, 3), by the angle of the trigonometric form of the roots."""
    mean = jnp.trace(m, axis1=-2, axis2=-1) / 3.0
    off = m - mean[:, None, None] * jnp.eye(3, dtype=m.dtype)
    size = jnp.sqrt((off * off).sum(axis=(-2, -1)) / 6.0)
    unit = off / jnp.where(size > 0.0, size, 1.0)[:, None, None]
    x, y, z = unit[:, 0, 0], unit[:, 1, 1], unit[:, 2, 2]
    xy, xz, yz = unit[:, 0, 1], unit[:, 0, 2], unit[:, 1, 2]
    determinant = x * y * z + 2.0 * xy * xz * yz - x * yz * yz - y * xz * xz - z * xy * xy
    angle = jnp.arccos(jnp.clip(0.5 * determinant, -1.0, 1.0)) / 3.0
    third = 2.0 * np.pi / 3.0
    return mean + 2.0 * size * jnp.cos(angle + third), mean + 2.0 * size * jnp.cos(angle)


def inverse3(m: Any) -> Any:
    """Inverse of symmetric matrices (…, 3, 3), by their cofactors."""
    a, b, c = m[..., 0, 0], m[..., 0, 1], m[..., 0, 2]
    d, e, f = m[..., 1, 1], m[..., 1, 2], m[..., 2, 2]
    x, y, z = d * f - e * e, c * e - b * f, b * e - c * d
    parts = ((x, y, z), (y, a * f - c * c, b * c - a * e), (z, b * c - a * e, a * d - b * b))
    rows = jnp.stack([jnp.stack(row, axis=-1) for row in parts], axis=-2)
    return rows / (a * x + b * y + c * z)[..., None, None]


def _rest(sets: Sets, compliance: Compliance, wanted: Any) -> Any:
    """Friction that takes an acceleration. Of the many that do where feet belong to one body, it is the one with the least sum of
    squares in units of each foot's limit."""
    limits, parts = sets.limits, []
    units = jnp.stack([limits, limits, limits * sets.arms], axis=-1)
    for one, block in zip(compliance.groups.classes, compliance.blocks, strict=True):
        count, size = one.shape
        right = -wanted[one].reshape(count, -1)
        if size == 1:
            inverse = inverse3(block)
            found = jnp.einsum("gij,gj->gi", inverse, right)
            left = right - jnp.einsum("gij,gj->gi", block, found)
            found = found + jnp.einsum("gij,gj->gi", inverse, left)
        else:
            found = _least(block, units[one].reshape(count, -1), right)
        parts.append(found.reshape(count, size, 3))
    return compliance.groups.join(parts)


def _least(block: Any, unit: Any, right: Any) -> Any:
    """The least x with block x = right, in these units: Tikhonov's solution, improved three times. Accelerations that friction
    hardly changes, those of feet of one body against each other, stay as they are."""
    scale = jax.lax.stop_gradient(jnp.diagonal(block, axis1=-2, axis2=-1) * unit * unit).max(
        axis=-1
    )
    scale = jnp.where(scale > 0.0, scale, 1.0)[:, None]
    scaled = block * unit[:, :, None] * unit[:, None, :] / scale[:, :, None]
    lifted = scaled + BETWEEN * jnp.eye(unit.shape[-1], dtype=unit.dtype)
    factor = jnp.linalg.inv(lifted)
    right = right * unit / scale
    found = jnp.zeros_like(right)
    for _ in range(4):
        left = right - jnp.einsum("gij,gj->gi", scaled, found)
        found = found + jnp.einsum("gij,gj->gi", factor, left)
    return found * unit


def _stills(sets: Sets, compliance: Compliance, metric: Metric, friction: Any, wanted: Any) -> Any:
    """Whether friction brings all feet of a group to rest."""
    still = STILL[str(friction.dtype)]
    friction, wanted = jax.lax.stop_gradient((friction, wanted))
    limits = jax.lax.stop_gradient(sets.limits)
    units = jnp.stack([limits, limits, limits * sets.arms], axis=-1)
    left = wanted + compliance.times(friction)
    moved = compliance.times(units * units * left) * units
    full = metric.bounds * limits
    scaled = left * units / jnp.where(limits > 0.0, limits, 1.0)[:, None]
    is_left = jnp.maximum(_norm(scaled), jnp.abs(scaled[:, 2])) > GIVE * full
    is_moved = jnp.maximum(_norm(moved), jnp.abs(moved[:, 2])) > still * (
        full * limits
    ) ** 2 / jnp.where(limits > 0.0, limits, 1.0)
    # What has no load has no friction either.
    is_beyond = (limits == 0.0) & (friction != 0.0).any(axis=-1)
    return ~compliance.groups.any(is_beyond | ((is_left | is_moved) & (limits > 0.0)))


class _Task(NamedTuple):
    """What a search is for."""

    per_time: Any
    """Motions are to end after the inverse of this time."""
    share: Any
    """1; 0 where friction is brought to the sets as it is."""
    rounds: Any
    """Rounds, at most."""


class _Search(NamedTuple):
    """Searches for the friction of a motion."""

    sets: Sets
    compliance: Compliance
    metric: Metric

    def friction(self, start: Any, wanted: Any, is_known: Any, task: _Task) -> tuple[Any, Any]:
        """Friction in the sets with the least energy, where the acceleration to take is `wanted`; and whether the search ended at
        its count. Groups that are known are left out."""

        def excess(friction: Any) -> Any:
            return friction - self._step(friction, wanted, task)

        def search(_: Any, start: Any) -> Any:
            return self._descend(start, wanted, is_known, task)

        found, missed = jax.lax.custom_root(excess, start, search, self._tangent, has_aux=True)
        return found, missed > 0.5

    def _step(self, at: Any, wanted: Any, task: _Task) -> Any:
        """A gradient step in the metric, brought back to the sets."""
        motion = task.share * (wanted + self.compliance.times(at))
        return self.sets.nearest(at - motion * self.metric.rates, self.metric.lengths)

    def _descend(self, start: Any, wanted: Any, is_known: Any, task: _Task) -> tuple[Any, Any]:
        groups, metric = self.compliance.groups, self.metric
        largest = jnp.maximum(self.sets.limits.max(), jnp.finfo(wanted.dtype).tiny)
        tolerance = TOLERANCE[str(wanted.dtype)] * largest

        def goes_on(state: Any) -> Any:
            _, _, _, is_open, count = state
            return is_open.any() & (count < task.rounds)

        def round_(state: Any) -> Any:
            at, ahead, weight, is_open, count = state
            found = self._step(ahead, wanted, task)
            change = _where(is_open, found - at, 0.0)
            uphill = groups.total(((ahead - found) * change / metric.rates).sum(axis=-1)) > 0.0
            found = _where(is_open, found, at)
            # Weights of Nesterov, anew where they lead uphill (O'Donoghue and Candès, Found. Comput. Math. 15 (2015) 715).
            grown = 0.5 * (1.0 + jnp.sqrt(1.0 + 4.0 * weight * weight))
            momentum = jnp.where(uphill, 0.0, (weight - 1.0) / grown)
            moved = jnp.maximum(_norm(change), jnp.abs(change[:, 2]) / metric.lengths)
            is_open = is_open & groups.any(moved * metric.left > tolerance)
            weight = jnp.where(uphill, 1.0, grown)
            return found, found + momentum[:, None] * change, weight, is_open, count + 1

        state = (start, start, jnp.ones_like(start[:, 0]), ~is_known, 0)
        found, _, _, is_open, _ = jax.lax.while_loop(goes_on, round_, state)
        # Whatever comes with a root has a derivative, which truth values have not.
        return found, is_open.astype(found.dtype)

    def _tangent(self, rule: Any, right: Any) -> Any:
        """Solves the linearised condition for each group: feet of other groups do not move its feet."""
        parts, lift = [], LIFTED[str(right.dtype)]
        widest = max(one.shape[1] for one in self.compliance.groups.classes)
        basis = np.zeros((3 * widest, *right.shape))
        for one in self.compliance.groups.classes:
            for k in range(one.shape[1]):
                for axis in range(3):
                    basis[3 * k + axis, one[:, k], axis] = 1.0
        columns = jax.vmap(rule)(jnp.asarray(basis, right.dtype))
        for one in self.compliance.groups.classes:
            count, size = one.shape
            matrix = jnp.moveaxis(columns[: 3 * size, one], 0, -1).reshape(
                count, 3 * size, 3 * size
            )
            matrix = matrix + lift * jnp.eye(3 * size, dtype=right.dtype)
            found = jnp.linalg.solve(matrix, right[one].reshape(count, 3 * size, 1))
            parts.append(found.reshape(count, size, 3))
        return self.compliance.groups.join(parts)


def _turns_about(
    sets: Sets, compliance: Compliance, friction: Any, velocity: Any, rate: Any, dt: Any
) -> Any:
    """Whether a foot's velocity or spin in a group has another sense at the end."""
    friction, u, rate = jax.lax.stop_gradient((friction, velocity, rate))
    after = u + dt * (rate + compliance.times(friction))
    arm_sq = sets.arms**2
    speed_sq = u[:, 0] ** 2 + u[:, 1] ** 2 + arm_sq * u[:, 2] ** 2
    # Reversals of motions slower than this share of the speed are rounding.
    least = -((1e-9 if u.dtype == jnp.float64 else 1e-6) ** 2) * speed_sq
    slides = u[:, 0] * after[:, 0] + u[:, 1] * after[:, 1]
    turns = (slides < least) | (arm_sq * u[:, 2] * after[:, 2] < least)
    return compliance.groups.any(turns & (sets.limits > 0.0))


def _power(compliance: Compliance, friction: Any, velocity: Any, rate: Any, dt: Any) -> Any:
    """Twice the power that friction of each foot gives to the mean motion."""
    friction, velocity, rate = jax.lax.stop_gradient((friction, velocity, rate))
    after = velocity + dt * (rate + compliance.times(friction))
    return ((velocity + after) * friction).sum(axis=-1)


def _without_gain(compliance: Compliance, friction: Any, velocity: Any, rate: Any, dt: Any) -> Any:
    """Less friction, along itself, where a search that stopped at its count would have it give power."""
    groups = compliance.groups
    total = groups.total(_power(compliance, friction, velocity, rate, dt))
    own = dt * groups.total(
        jax.lax.stop_gradient((compliance.times(friction) * friction).sum(axis=-1))
    )
    share = jnp.where(
        own > 0.0, jnp.maximum(1.0 - total / jnp.where(own > 0.0, own, 1.0), 0.0), 0.0
    )
    return friction * jnp.where(total > 0.0, share, 1.0)[:, None]
