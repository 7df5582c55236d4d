"""Feet for MuJoCo Warp and Newton."""

from __future__ import annotations

import weakref
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import ArrayLike

from tribos._friction import Friction
from tribos.warp._feet import (
    FREE,
    Engine,
    Feet,
    add_friction,
    find_contacts,
    sum_loads,
)
from tribos.warp._given import GivenFoot, Name, check_options, check_pairs, given_foot, rolls_on

# Contacts of each geom of a foot with its floor that are kept; rounds for feet that move each other.
_CONTACTS = 8
_ROUNDS = 20


def attach(
    engine: Any,
    feet: Mapping[Name, Friction],
    floor: str | Mapping[Name, str],
    *,
    sites: Mapping[Name, str] | None = None,
    mu: ArrayLike | None = None,
) -> AttachedFeet:
    """Puts geoms of a MuJoCo Warp or Newton simulation on contact patches.

    Friction enters as a passive force, by the model's callback, which is chained: one that is there is
    called first. A step costs three launches more, without memory or reads by the host, so that it can be
    captured in a CUDA graph.

    Parameters
    ----------
    engine
        A Newton ``SolverMuJoCo``, or a tuple of a ``mujoco.MjModel``, which knows the names, and the
        MuJoCo Warp model and data made from it, in this order. The extra ``warp`` brings warp-lang alone: install
        mujoco-warp or newton as well.
    feet
        Dry friction of each foot, by the name of its geom, or by a tuple of names of geoms of one body
        that share a patch. Newton's geoms have the label of their shape with a number behind, ``"box_1"`` (see
        ``solver.mj_model.geom(i).name``): the label will do where it is that of one geom. Patches are a disk, ring, punch, Hertz contact or paraboloid, or a box or polygon under
        uniform pressure.
    floor
        Name of the geom that the feet stand on, or one for each foot.
    sites
        Sites that are the frames of patches, for feet whose geom's frame is not wanted.
    mu
        Coefficients of the worlds, of shape (worlds,) or (worlds, feet); None for those of the feet.

    Returns
    -------
    AttachedFeet
        Loads, friction and motions, and the coefficients, which may be changed. A context manager.

    Notes
    -----
    *Bodies* that stand on feet must hang on a free joint, without bodies that move against them. A foot's
    contacts are taken to keep its body from tilting, so that it moves in the plane of contact: a flat face,
    or three feet or more. A single foot that is a sphere may roll. Other round geoms, and a body with two
    feet or with a foot on its edge, are not what this step is for; feet of capsules and ellipsoids are
    refused.

    *Floors* may move. A free body gets the reaction and gives way; one on other joints gets the reaction,
    but gives way in the next step only. Conveyors (``surfacevel``) are not taken along.

    *Loads* are the normal forces of the step before, those of a foot's contacts alone: friction of a body
    that starts to touch begins one step late. Forces of actuators and of other contacts are those of the
    step before, too.

    *Contacts* of a foot with its floor are made frictionless while it is attached (``condim`` 1); as MuJoCo
    takes the larger ``condim`` of both geoms, those of the floor with others may be too.

    Raises
    ------
    ValueError
        For what is refused, in words; a model that has feet already is, too.

    Warns
    -----
    UserWarning
        For a box or disk that is more than 1.5 times larger or smaller than its box or cylinder, without a site.
    """
    return AttachedFeet(engine, feet, floor, sites=sites, mu=mu)


# Feet that are attached; the callback of their model keeps them alive.
_ATTACHED: weakref.WeakSet[AttachedFeet] = weakref.WeakSet()


class _Simulation(NamedTuple):
    """What names things, and what steps."""

    names: Any
    model: Any
    data: Any


class AttachedFeet:
    """Feet of a simulation, made by `attach`.

    Attributes
    ----------
    names : tuple
        The feet in the order of the arrays.
    mu, load : warp.array
        Coefficients, and loads in N, of shape (worlds, feet). The coefficients may be written.
    friction, twist : warp.array
        Force in N and torque in N m on each foot, and velocity in m/s and spin in rad/s before the step
        relative to the floor, in the patch's axes; vec3 of shape (worlds, feet).
    axes, centre : warp.array
        The patch's x, y and normal in the rows of mat33, and its origin in m, in the frame of the world.
    held : warp.array
        1 where friction holds the foot.
    """

    def __init__(
        self,
        engine: Any,
        feet: Mapping[Name, Friction],
        floor: str | Mapping[Name, str],
        *,
        sites: Mapping[Name, str] | None,
        mu: ArrayLike | None,
    ) -> None:
        self._simulation = _simulation(engine)
        if any(one._simulation.model is self._simulation.model for one in _ATTACHED):
            raise ValueError("the model has feet already: close them first")
        self.names = tuple(feet)
        if not self.names:
            raise ValueError("give at least one foot")
        model = self._simulation.names
        check_options(model)
        others = set(sites or {}) - set(self.names)
        if others:
            raise ValueError(f"sites are for feet, not for {sorted(map(str, others))}")
        given = [
            given_foot(model, name, friction, floor, (sites or {}).get(name))
            for name, friction in feet.items()
        ]
        check_pairs(given, self.names)
        rolls = [rolls_on(model, foot, given, name) for foot, name in zip(given, self.names)]
        self._feet = _arrays(self._simulation, given, rolls, mu)
        self._restore: list[tuple[Any, Any]] = []
        self._free_of_friction(given)
        callback = self._simulation.model.callback
        self._earlier = callback.passive
        callback.passive = self._step
        self._is_open = True
        _ATTACHED.add(self)

    def __getattr__(self, name: str) -> Any:
        if name in ("mu", "load", "friction", "twist", "axes", "centre", "held"):
            return getattr(self._feet, name)
        raise AttributeError(name)

    def __enter__(self) -> AttachedFeet:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        state = "" if self._is_open else ", closed"
        return f"<tribos.warp.AttachedFeet {list(self.names)}{state}>"

    def close(self) -> None:
        """Gives the contacts their own friction back; nothing more happens when it is called again."""
        if not self._is_open:
            return
        self._is_open = False
        _ATTACHED.discard(self)
        for array, values in self._restore:
            array.assign(values)
        callback = self._simulation.model.callback
        if callback.passive == self._step:
            callback.passive = self._earlier

    def _step(self, model: Any, data: Any) -> None:
        """The passive callback."""
        if self._earlier is not None:
            self._earlier(model, data)
        if not self._is_open:
            return
        engine, feet = _engine(model, data), self._feet
        device = data.qvel.device
        shape = feet.load.shape
        wp.launch(sum_loads, shape, [engine, feet], device=device)
        wp.launch(find_contacts, data.naconmax, [engine, feet], device=device)
        wp.launch(add_friction, shape[0], [engine, feet, data.qfrc_passive], device=device)

    def _free_of_friction(self, given: list[GivenFoot]) -> None:
        """Makes the contacts of the feet with their floors frictionless."""
        model, names = self._simulation.model, self._simulation.names
        # On a processor numpy() is a view.
        condim = model.geom_condim.numpy().copy()
        changed = condim.copy()
        pair_dim = model.pair_dim.numpy().copy()
        pairs = pair_dim.copy()
        for foot in given:
            for geom in foot.geoms:
                pair = np.array([geom, foot.floor])
                priority = names.geom_priority[pair]
                changed[pair[priority == priority.max()]] = 1
                both = np.sort(np.stack([names.pair_geom1, names.pair_geom2], 1), axis=1)
                pairs[: len(both)][(both == np.sort(pair)).all(1)] = 1
        for array, old, new in (
            (model.geom_condim, condim, changed),
            (model.pair_dim, pair_dim, pairs),
        ):
            if (old != new).any():
                self._restore.append((array, old))
                array.assign(new)


def _simulation(engine: Any) -> _Simulation:
    if isinstance(engine, tuple):
        parts, found = list(engine), f"({', '.join(type(one).__name__ for one in engine)})"
    else:
        parts = [getattr(engine, part, None) for part in ("mj_model", "mjw_model", "mjw_data")]
        found = repr(engine)
    # What only a model of MuJoCo, a model and data of MuJoCo Warp have.
    marks = ("names", "callback", "nworld")
    if len(parts) != 3 or not all(map(hasattr, parts, marks)):
        raise ValueError(
            "attach takes a Newton SolverMuJoCo that runs on MuJoCo Warp, or a tuple (MjModel, model of MuJoCo Warp, "
            f"data of MuJoCo Warp) in this order, not {found}"
        )
    return _Simulation(*parts)


def _arrays(
    simulation: _Simulation, given: list[GivenFoot], rolls: list[int], mu: ArrayLike | None
) -> Any:
    """The feet on the device of the data."""
    data = simulation.data
    worlds, count, device = data.nworld, len(given), data.qvel.device
    pairs = [(geom, foot.floor, k) for k, foot in enumerate(given) for geom in foot.geoms]
    most = max(1, max(len(foot.shape.corners) for foot in given))
    corners = np.zeros((count, most, 2), np.float32)
    for k, foot in enumerate(given):
        if foot.shape.corners:
            # The last corner again where there are no more.
            rows = foot.shape.corners + [foot.shape.corners[-1]] * (most - len(foot.shape.corners))
            corners[k] = rows
    slots = _CONTACTS * max(len(foot.geoms) for foot in given)
    feet = Feet()
    feet.count = count
    shared = [
        body
        for foot in given
        for body in (foot.bodies[0], foot.bodies[1] if foot.floor_kind == FREE else -1)
    ]
    shared = [body for body in shared if body >= 0]
    feet.sweeps = 1 if len(set(shared)) == len(shared) else _ROUNDS

    def array(values: Any, dtype: Any) -> Any:
        return wp.array(np.array(values), dtype=dtype, device=device)

    feet.geom = array([pair[0] for pair in pairs], int)
    feet.floor = array([pair[1] for pair in pairs], int)
    feet.foot = array([pair[2] for pair in pairs], int)
    feet.bodies = array([foot.bodies for foot in given], wp.vec2i)
    feet.floor_kind = array([foot.floor_kind for foot in given], int)
    feet.rolls = array(rolls, int)
    feet.frame = array([foot.frame for foot in given], wp.vec2i)
    feet.kind = array([foot.shape.kind for foot in given], int)
    feet.sides = array([foot.shape.sides for foot in given], wp.vec2)
    feet.corners = wp.array(corners, dtype=wp.vec2, device=device)
    feet.shape_frame = array([foot.shape.frame for foot in given], wp.vec4)
    feet.mu = wp.array(_coefficients(given, worlds, mu), dtype=float, device=device)
    for name, dtype in (
        ("load", float),
        ("friction", wp.vec3),
        ("twist", wp.vec3),
        ("axes", wp.mat33),
        ("centre", wp.vec3),
        ("held", int),
        ("pushed", wp.vec3),
        ("yielding", wp.mat33),
        ("contacts", int),
    ):
        setattr(feet, name, wp.zeros((worlds, count), dtype=dtype, device=device))
    for name in ("key", "contact", "row"):
        setattr(feet, name, wp.zeros((worlds, count, slots), dtype=int, device=device))
    return feet


def _coefficients(given: list[GivenFoot], worlds: int, mu: ArrayLike | None) -> Any:
    shape = (worlds, len(given))
    if mu is None:
        return np.broadcast_to(np.array([foot.mu for foot in given], np.float32), shape).copy()
    values = np.asarray(mu, np.float32)
    if values.ndim == 1:
        values = values[:, None]
    if not (np.isfinite(values).all() and (values >= 0.0).all()):
        raise ValueError("mu must be finite numbers, at least 0")
    try:
        return np.broadcast_to(values, shape).copy()
    except ValueError:
        raise ValueError(
            f"mu must have the shape ({worlds},) or {shape}, not {np.shape(mu)}"
        ) from None


_OF_MODEL = ("body_mass", "body_inertia", "body_dofadr", "body_rootid", "body_isdofancestor", "nv")
_OF_DATA = (
    "xpos",
    "xmat",
    "xipos",
    "ximat",
    "geom_xpos",
    "geom_xmat",
    "site_xpos",
    "site_xmat",
    "subtree_com",
    "cvel",
    "cdof",
    "qvel",
    "qfrc_applied",
    "qfrc_actuator",
    "qfrc_constraint",
    "xfrc_applied",
)


def _engine(model: Any, data: Any) -> Any:
    """The arrays as they are now: users may have replaced some."""
    engine = Engine()
    for name in _OF_MODEL:
        setattr(engine, name, getattr(model, name))
    for name in _OF_DATA:
        setattr(engine, name, getattr(data, name))
    engine.timestep = model.opt.timestep
    engine.gravity = model.opt.gravity
    contact = data.contact
    engine.contact_pos = contact.pos
    engine.contact_frame = contact.frame
    engine.contact_geom = contact.geom
    engine.contact_world = contact.worldid
    engine.contact_number = contact.geomcollisionid
    engine.contact_row = contact.efc_address
    engine.contact_count = data.nacon
    engine.force = data.efc.force
    return engine
