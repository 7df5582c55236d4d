"""Exact friction of contact patches in MJX simulations.

MJX, MuJoCo in JAX, has friction at points of contact. Here named geoms stand on a *patch* instead: a disk, a box, a
polygon, a Hertz contact, …, with the force and torque of the integral over it, and with a state of rest that does not creep.
All is JAX: ``jit``, ``vmap`` over worlds, ``scan``, derivatives, on every device.

>>> import jax, mujoco, tribos, tribos.mjx
>>> from mujoco import mjx
>>> model = mujoco.MjModel.from_xml_string('''
... <mujoco>
...   <option timestep="0.002" gravity="0 0 -10" iterations="4" ls_iterations="8"/>
...   <worldbody>
...     <geom name="ice" type="plane" size="5 5 0.1"/>
...     <body pos="0 0 0.01">
...       <freejoint/>
...       <geom name="puck" type="cylinder" size="0.05 0.01" mass="0.17" condim="1" priority="1"/>
...     </body>
...   </worldbody>
... </mujoco>''')
>>> puck = tribos.Friction(tribos.disk(0.05), mu=0.3)
>>> feet = tribos.mjx.feet(model, {"puck": puck}, floor="ice")
>>> m = mjx.put_model(model)
>>> @jax.jit
... def thrown(spin):
...     d = feet.start(mjx.make_data(m))
...     step = lambda d, _: (tribos.mjx.step(m, d, feet), None)
...     d, _ = jax.lax.scan(step, d, None, length=100)              # the puck settles
...     d = d.replace(qvel=d.qvel.at[0].set(1.0).at[5].set(spin))   # m/s, rad/s
...     return jax.lax.scan(step, d, None, length=500)[0]
>>> d = thrown(50.0)
>>> print(f"{d.qpos[0]:.2f} m", bool(feet.state(d)["puck"].is_held))
0.39 m True

How it works
------------
Contacts of feet with their ground have no friction in MuJoCo (``condim="1"``). In each step the load of a foot is the sum of
its normal forces of the step before, and friction is that of an implicit step: the wrench that would bring the foot to rest
relative to its ground, against its momentum and all other forces, brought to the nearest point of the limit surface in the
metric of the effective masses. A foot that friction can hold therefore stands still. Grounds may be tilted and may move, and
receive the reaction; feet that move each other are solved together. The rules are those of MuJoCo's plugin ``tribos.patch``.

Friction acts by ``qfrc_applied``; what feet remember from step to step is in ``plugin_state``. Forces of your own belong in
``xfrc_applied``, in actuators, or, with `step` but not with `apply`, in ``qfrc_applied`` as well.

Derivatives
-----------
Those by the implicit function theorem, for forward and reverse mode, by the state, by parameters of the model, `mu` and
`radius`. A body at rest passes zero on, no NaN. Reverse mode needs ``<option iterations="1" ls_iterations="8"/>``: MJX's solver is
a loop of unknown length otherwise; in float32 a cylinder that spins may hop then, a box does not. Forward mode takes any number.
Derivatives through a thousand steps scatter by some percent in float32.

Limits
------
Not here, but in the plugin: what a body slips on a floor that turns under it is not taken back, of first order in the step;
conveyors (``surfacevel``) take nothing along. Geoms may be of any kind, spheres and capsules as well: the whole body with all its
joints is in the effective masses, so that they roll on their patch.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import mujoco
import numpy as np
from mujoco import mjx
from numpy.typing import NDArray

import tribos.jax
from tribos import _mjx_model, _mjx_place, _mjx_solve
from tribos._arguments import check_sign
from tribos._forms import of_friction
from tribos._friction import Friction
from tribos._gradients import length_of
from tribos._mjx_model import Name

__all__ = ["Feet", "FootState", "apply", "feet", "step"]


class FootState(NamedTuple):
    """A foot in the last step, with the leading axes of the data."""

    load: Any
    """Sum of its normal forces, in N, of the step before."""
    friction: Any
    """Force in N along the patch's x and y, torque in N m about its normal, on the foot, (…, 3)."""
    twist: Any
    """Velocity in m/s and spin in rad/s relative to the ground, before the step, in the same axes, (…, 3)."""
    is_held: Any
    """Friction holds the foot: it stands still on its ground."""
    missed: Any
    """Steps in which the search for its friction ended at its count: friction gives no power all the same, but may be another than
    that of the motion."""


# Numbers of a foot in `plugin_state`: load, friction, twist, acceleration by the friction of all feet, held, missed.
LOAD, FRICTION, TWIST, RESPONSE, HELD, MISSED = 0, slice(1, 4), slice(4, 7), slice(7, 10), 10, 11
SIZE = 12


class Feet:
    """Feet of a model, made by `feet`."""

    __slots__ = ("_arms", "_links", "_mus", "_names", "_patches", "_size")

    def __init__(self, model: Any, given: Sequence[_mjx_model.Given]) -> None:
        self._links = _mjx_model.link(model, given)
        self._names = tuple(foot.name for foot in given)
        self._mus = np.array([foot.friction.mu for foot in given])
        self._patches = _alike([foot.friction for foot in given])
        arms = np.zeros(len(given))
        for at, foot in enumerate(given):
            arms[at] = abs(Friction(foot.friction.patch, mu=1.0).wrench([0.0, 0.0, 1.0], 1.0)[2])
        self._arms = arms
        self._size = int(model.nv)

    @property
    def names(self) -> tuple[Name, ...]:
        """Names of the feet, in the order of `mu` and `radius`."""
        return self._names

    def start(self, d: Any) -> Any:
        """Data in which no foot remembers anything: to begin with, and after a reset.

        A reset of positions leaves contacts of before, as everywhere in MJX: `mujoco.mjx.forward` makes new ones, after which feet
        have friction in the first step.
        """
        if not isinstance(d, mjx.Data):
            raise ValueError(f"start takes data of MJX, from mjx.make_data(m), not {_kind(d)}")
        shape = (*d.qpos.shape[:-1], SIZE * len(self._names))
        return d.replace(plugin_state=jnp.zeros(shape, d.qpos.dtype))

    def state(self, d: Any) -> dict[Name, FootState]:
        """The feet in the last step, by their names."""
        rows = _rows(self, d)
        made = {}
        for at, name in enumerate(self._names):
            row = rows[..., at, :]
            made[name] = FootState(
                load=row[..., LOAD],
                friction=row[..., FRICTION],
                twist=row[..., TWIST],
                is_held=row[..., HELD] > 0.5,
                missed=row[..., MISSED],
            )
        return made

    def _each(self, key: str, given: Any) -> Any:
        """An array (n,) of numbers that are given for all feet or for each; NaN for those that are negative and traced."""
        count, shape = len(self._names), jnp.shape(given)
        if shape not in ((), (count,)):
            raise ValueError(
                f"{key}: a number, or one for each foot ({count}), not {shape}; for worlds use jax.vmap"
            )
        if not isinstance(given, jax.core.Tracer):
            # A concrete array of JAX is known, too.
            check_sign("tribos.mjx", key, np.asarray(given), above=key == "radius")
        made = jnp.broadcast_to(jnp.asarray(given), shape or (count,))
        return jnp.where(made < 0.0, jnp.nan, made)

    def _mu(self, given: Any) -> Any:
        return self._mus if given is None else self._each("mu", given)

    def _radius(self, given: Any) -> Any:
        if given is None:
            return None
        others = [one for one in self._patches if "radius" not in one.sizes]
        # One number is for all feet; of an array the numbers of round feet are read.
        if others and (len(others) == len(self._patches) or jnp.ndim(given) == 0):
            name = self._names[others[0].members[0]]
            raise ValueError(
                f"radius= is not for {others[0].friction.patch!r} of foot {name!r}, but for disk, ring, punch, hertz "
                "and paraboloid; where only some feet are round, give one for each foot: those of others are not read"
            )
        return self._each("radius", given)

    def __repr__(self) -> str:
        return f"<tribos.mjx.Feet {list(self._names)}>"


def feet(
    model: Any,
    feet: Mapping[Name, Friction] | Sequence[Mapping[str, Any]] | None = None,
    floor: str | Mapping[Name, str] | None = None,
    *,
    sites: Mapping[Name, str] | None = None,
) -> Feet:
    """Feet of a MuJoCo model on contact patches.

    Parameters
    ----------
    model
        A `mujoco.MjModel`, the one that ``mjx.put_model`` takes.
    feet
        None for the instances of the plugin ``tribos.patch`` in the model; or a list of dicts with the plugin's keys (geom, ground,
        site, patch, size, corners, mu; name), for models that are loaded without the plugin; or dry friction of each foot by the
        name of its geom, or by a tuple of names, as in `tribos.mujoco.attach`.
    floor
        With such a mapping: name of the geom that the feet stand on, or one for each foot.
    sites
        With such a mapping: sites that are the frames of patches.

    Returns
    -------
    Feet
        Constants of a JAX program: functions close over them.

    Raises
    ------
    ValueError
        For names that the model does not have, contacts that have friction of MuJoCo's own, geoms of one foot on several bodies,
        laws without a limit surface, the integrator RK4, feet that no joint moves on their floor, and geoms with two feet.

    Warns
    -----
    UserWarning
        For a box or disk that is more than 1.5 times larger or smaller than its box or cylinder, without a site.

    Examples
    --------
    >>> import mujoco, tribos.mjx
    >>> model = mujoco.MjModel.from_xml_string('''
    ... <mujoco><worldbody>
    ...   <geom name="table" type="plane" size="1 1 0.1" condim="1"/>
    ...   <body pos="0 0 0.01"><freejoint/><geom name="box" type="box" size="0.1 0.05 0.01" condim="1"/></body>
    ... </worldbody></mujoco>''')
    >>> keys = {"geom": "box", "ground": "table", "patch": "box", "size": "0.1 0.05", "mu": 0.3}
    >>> tribos.mjx.feet(model, [keys])
    <tribos.mjx.Feet ['box']>
    """
    if not isinstance(model, mujoco.MjModel):
        raise ValueError(
            f"feet takes a mujoco.MjModel, the one that mjx.put_model takes, not {_kind(model)}"
        )
    if feet is None:
        given = _mjx_model.of_model(model)
    elif isinstance(feet, Mapping):
        if floor is None:
            raise ValueError("floor is missing: the geom that the feet stand on")
        given = _mjx_model.of_mapping(feet, floor, sites)
    else:
        given = [_mjx_model.of_keys(keys) for keys in feet]
    if not given:
        raise ValueError("give at least one foot")
    return Feet(model, given)


def step(m: Any, d: Any, feet: Feet, *, mu: Any = None, radius: Any = None) -> Any:
    """A step of MJX with the friction of feet: ``mjx.step`` after `apply`, where ``qfrc_applied`` remains yours.

    Parameters
    ----------
    m, d
        Model and data of MJX; the data from `Feet.start`.
    feet
        From `feet`.
    mu, radius
        As for `apply`.
    """
    _check_call("step", m, d, feet)
    own = d.qfrc_applied
    d = apply(m, d, feet, mu=mu, radius=radius)
    return mjx.step(m, d.replace(qfrc_applied=d.qfrc_applied + own)).replace(qfrc_applied=own)


def apply(m: Any, d: Any, feet: Feet, *, mu: Any = None, radius: Any = None) -> Any:
    """Data whose ``qfrc_applied`` is the friction of the feet in the step to come: call it before each ``mjx.step``.

    Parameters
    ----------
    m, d
        Model and data of MJX; the data from `Feet.start`, after ``mjx.step`` or ``mjx.forward``.
    feet
        From `feet`.
    mu
        Coefficients of friction in place of the feet's own: a number for all, or one for each foot, in the order of `Feet.names`; may
        be traced, so that each world has its own by ``vmap``. Negative ones are refused, or give NaN where they are traced.
    radius
        Radii in m of disk, ring, punch, hertz and paraboloid in place of the feet's own, in the same way. Where only some feet
        have such patches it is one for each foot, and those of others are not read.

    Raises
    ------
    ValueError
        For arguments of other types or in another order, data of several worlds, and `mu` and `radius` of other shapes or signs.
    """
    _check_call("apply", m, d, feet)
    mu, radius = feet._mu(mu), feet._radius(radius)
    links, dt = feet._links, m.opt.timestep
    state = _rows(feet, d)
    # Contacts, springs and effective masses of the step before, in the axes that go with the patch.
    touch = _mjx_place.touch(links, d)
    before = _mjx_place.place(links, touch, d)
    compliance, rows = _mjx_place.compliance(m, links, touch, before, d)
    rate = (rows @ d.qacc)[:, _mjx_place.PLANE] - state[:, RESPONSE]
    # The same feet where the step begins.
    now = mjx.com_pos(m, mjx.kinematics(m, d))
    after = _mjx_place.place(links, _mjx_place.carried(links, touch, d, now), now)
    rows = _mjx_place.jacobian(links, after, now)[:, _mjx_place.PLANE]
    velocity = rows @ d.qvel
    rate = _turned(rate, before.axes, after.axes)
    sets = _Sets.of(feet, touch, mu, radius, d.qvel.dtype)
    found = _mjx_solve.solve(sets, compliance, velocity, rate, state[:, FRICTION], dt)
    parts = [
        touch.load[:, None],
        found.friction,
        velocity,
        found.response,
        found.is_held[:, None].astype(state.dtype),
        (state[:, MISSED] + found.is_missed)[:, None],
    ]
    remembered = jnp.where(touch.is_touching[:, None], jnp.concatenate(parts, axis=-1), 0.0)
    remembered = remembered.at[:, MISSED].set(parts[-1][:, 0])
    friction = jnp.einsum("nij,ni->j", rows, found.friction)
    return d.replace(qfrc_applied=friction, plugin_state=remembered.reshape(-1))


def _kind(given: Any) -> str:
    """What is given, in few words."""
    where = "MJX" if isinstance(given, (mjx.Model, mjx.Data)) else type(given).__module__
    return f"{type(given).__name__} of {where}"


def _check_call(name: str, m: Any, d: Any, feet: Any) -> None:
    """Whether the arguments are what they should be, of one world."""
    wanted = (mjx.Model, mjx.Data, Feet)
    if not all(isinstance(one, kind) for one, kind in zip((m, d, feet), wanted, strict=True)):
        raise ValueError(
            f"{name} takes a model and data of MJX and feet, from mjx.put_model(model), feet.start(mjx.make_data(m)) "
            f"and tribos.mjx.feet(model, ...), in this order, not {_kind(m)}, {_kind(d)} and {_kind(feet)}"
        )
    if d.qpos.ndim != 1:
        raise ValueError(
            f"{name} takes the data of one world, not of {d.qpos.shape[:-1]}: for several use jax.vmap"
        )


def _turned(rates: Any, before: Any, after: Any) -> Any:
    """Accelerations in a patch's plane and about its normal, in the axes of the step to come."""
    world = jnp.einsum("nij,ni->nj", before[:, :2], rates[:, :2])
    return jnp.concatenate([jnp.einsum("nij,nj->ni", after[:, :2], world), rates[:, 2:]], axis=-1)


def _rows(feet: Feet, d: Any) -> Any:
    """What feet remember, (…, n, SIZE)."""
    if not hasattr(d._impl, "efc_force"):
        raise ValueError(
            "tribos.mjx needs MJX's implementation in JAX: mjx.put_model(model, impl='jax')"
        )
    count = len(feet._names)
    if d.plugin_state.shape[-1] != SIZE * count:
        raise ValueError("the data have no room for the feet's state: begin with d = feet.start(d)")
    return d.plugin_state.reshape(*d.plugin_state.shape[:-1], count, SIZE)


class _Alike(NamedTuple):
    """Feet whose patches are computed together."""

    friction: Friction
    """Of one of them, with the coefficient 1."""
    members: NDArray[np.int64]
    """Indices of the feet."""
    sizes: Mapping[str, NDArray[np.float64]]
    """Their radii or corners; none where the kernel is called back."""


def _alike(frictions: Sequence[Friction]) -> list[_Alike]:
    """Feet by the kinds of their patches."""
    kinds: dict[Any, list[int]] = {}
    for at, friction in enumerate(frictions):
        kinds.setdefault(of_friction.kind_of(friction) or friction.patch, []).append(at)
    made = []
    for kind, members in kinds.items():
        unit = Friction(frictions[members[0]].patch, mu=1.0)
        sizes: dict[str, Any] = {}
        if kind == of_friction.FLAT:
            corners = [list(of_friction.size_of(frictions[at])) for at in members]
            most = max(map(len, corners))
            # Repeated corners count once.
            sizes["corners"] = np.array([one + one[-1:] * (most - len(one)) for one in corners])
        elif isinstance(kind, str):
            sizes["radius"] = np.array([of_friction.size_of(frictions[at]) for at in members])
        made.append(_Alike(unit, np.array(members), sizes))
    return made


class _Sets(NamedTuple):
    """The friction that each foot can carry."""

    patches: Sequence[_Alike]
    limits: Any
    arms: Any
    radius: Any

    @classmethod
    def of(cls, feet: Feet, touch: _mjx_place.Touch, mu: Any, radius: Any, dtype: Any) -> _Sets:
        given = jnp.asarray(mu, dtype)
        arms = jnp.asarray(feet._arms, dtype)
        if radius is not None:
            radius = jnp.asarray(radius, dtype)
            for one in feet._patches:
                if "radius" in one.sizes:
                    share = radius[one.members] / one.sizes["radius"]
                    arms = arms.at[one.members].multiply(jax.lax.stop_gradient(share))
        limits = jnp.where(touch.is_touching, given * touch.load, 0.0)
        return cls(feet._patches, limits, arms, radius)

    @property
    def lengths(self) -> Any:
        """Lengths that the kernel takes, which are constants of its calls; NaN where any length will do."""
        made = np.full(len(self.arms), np.nan)
        for one in self.patches:
            if not one.sizes:
                made[one.members] = length_of(one.friction, None)
        return made

    def nearest(self, wrenches: Any, lengths: Any) -> Any:
        made = []
        for friction, at, sizes in self.patches:
            given: dict[str, Any] = dict(sizes, length=lengths[at]) if sizes else {}
            if self.radius is not None and "radius" in sizes:
                given["radius"] = self.radius[at]
            made.append(tribos.jax.project(friction, wrenches[at], self.limits[at], **given))
        if len(made) == 1:
            return made[0]
        order = np.argsort(np.concatenate([one.members for one in self.patches]))
        return jnp.concatenate(made)[order]
