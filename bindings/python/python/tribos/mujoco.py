"""Exact friction of contact patches in MuJoCo simulations.

MuJoCo's own friction acts at points of contact. Here named geoms stand on a *patch* instead: a
disk, a polygon, a Hertz contact, …, with the force and torque of the integral over it, and with a
state of rest that does not creep. MuJoCo keeps the normal forces; friction enters as a passive
force.

>>> import mujoco, tribos, tribos.mujoco
>>> model = mujoco.MjModel.from_xml_string('''
... <mujoco>
...   <option timestep="0.001" gravity="0 0 -10"/>
...   <worldbody>
...     <geom name="ice" type="plane" size="5 5 0.1"/>
...     <body pos="0 0 0.01">
...       <freejoint/>
...       <geom name="puck" type="cylinder" size="0.05 0.01" mass="0.17"/>
...     </body>
...   </worldbody>
... </mujoco>''')
>>> data = mujoco.MjData(model)
>>> puck = tribos.Friction(tribos.disk(0.05), mu=0.3)
>>> with tribos.mujoco.attach(model, data, {"puck": puck}, floor="ice") as feet:
...     mujoco.mj_step(model, data, nstep=200)         # the puck settles
...     data.qvel[:] = [1, 0, 0, 0, 0, 50]             # m/s, rad/s
...     mujoco.mj_step(model, data, nstep=1000)
...     feet["puck"].is_held
True
>>> round(float(data.qpos[0]), 3)                      # m
0.392

How it works
------------
Contacts of the geoms with their floor are made frictionless while the feet are attached. In each
step the load of a foot is the sum of its normal forces of the step before, and friction is that of
an implicit step: the wrench that would bring the foot to rest relative to its floor, against its
momentum and all other forces, brought to the nearest point of the limit surface in the metric of
the effective masses. A foot that friction can hold therefore stands still exactly; on a floor that
moves it is brought to where the floor will be at the end of the step, by the whole turns of the
floor's joints, and what it has slipped meanwhile is taken back, a fiftieth in each step. Several
feet of one body are solved together. Reactions act on the floor.

MuJoCo runs its callbacks when it compiles a model, and fails where they are Python's: compile
models before feet are attached, or within `paused`.

The step is of second order in the time step for velocities; MuJoCo's positions are of first order.
Friction of a body that starts to touch begins one step late.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from types import TracebackType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import mujoco
from tribos import _native
from tribos._friction import Friction

__all__ = ["Feet", "FootState", "attach", "paused"]

Name = str | tuple[str, ...]


class FootState(NamedTuple):
    """A foot in the last step.

    Attributes
    ----------
    load
        Sum of its normal forces, in N, of the step before.
    friction
        Force in N along the patch's x and y, torque in N m about its normal, on the foot.
    twist
        Velocity in m/s and spin in rad/s relative to the floor, before the step, in the same axes.
    axes
        The patch's x, y and normal in the rows, in the frame of the world; the normal points from
        the floor to the foot.
    centre
        Origin of the patch, in m, in the frame of the world.
    is_held
        Friction holds the foot: it stands still on its floor.
    missed
        Steps since it was attached in which a search for its friction stopped at its count: it is in
        its limit surface and gives no power all the same, but may be another than that of the
        motion.
    """

    load: float
    friction: NDArray[np.float64]
    twist: NDArray[np.float64]
    axes: NDArray[np.float64]
    centre: NDArray[np.float64]
    is_held: bool
    missed: int


def attach(
    model: Any,
    data: Any,
    feet: Mapping[Name, Friction],
    floor: str | Mapping[Name, str],
    *,
    sites: Mapping[Name, str] | None = None,
) -> Feet:
    """Puts geoms of a MuJoCo model on contact patches, until `Feet.close`.

    Parameters
    ----------
    model, data
        A `mujoco.MjModel` and its `mujoco.MjData`. `mujoco.mj_forward` is called once, such that
        the loads are known. Other data of the same model have the same feet.
    feet
        Dry friction of each foot, by the name of its geom, or by a tuple of names of geoms of one
        body that share a patch.
    floor
        Name of the geom that the feet stand on, or one for each foot. It may be tilted and may
        move.
    sites
        Sites that are the frames of patches, for feet whose geom's frame is not wanted.

    Returns
    -------
    Feet
        A context manager.

    Notes
    -----
    The patch lies in the plane of contact. Its origin is that of its frame, projected along the
    normal. Its frame is that of the geom (of the body for several geoms, or of the site given in
    sites): of the frame's axes x, y, z, x, … the one after that along the normal is the patch's x.
    A foot whose frame stands upright has its patch's x along the frame's x.

    MuJoCo's contacts have the larger ``condim`` of their geoms, or that of the geom of higher
    priority: contacts of feet and floors with each other and with geoms of ``condim="1"`` are
    frictionless, too.

    Raises
    ------
    ValueError
        For names that the model does not have, geoms of one foot on several bodies, laws without a
        limit surface, the integrator RK4, disabled passive forces, and a model that has feet
        already.

    Examples
    --------
    See the documentation of `tribos.mujoco`.
    """
    return Feet(model, data, feet, floor, sites=sites)


@contextmanager
def paused() -> Iterator[None]:
    """A context without MuJoCo's callback for passive forces, for models to be compiled in.

    Examples
    --------
    >>> import mujoco, tribos.mujoco
    >>> with tribos.mujoco.paused():
    ...     model = mujoco.MjModel.from_xml_string("<mujoco/>")
    """
    current = mujoco.get_mjcb_passive()
    mujoco.set_mjcb_passive(None)
    try:
        yield
    finally:
        mujoco.set_mjcb_passive(current)


class Feet:
    """Feet of a model, made by `attach`; ``feet[name]`` is the `FootState` of one of them."""

    __slots__ = ("_data", "_given", "_model", "_names", "_restore", "_states")

    def __init__(
        self,
        model: Any,
        data: Any,
        feet: Mapping[Name, Friction],
        floor: str | Mapping[Name, str],
        *,
        sites: Mapping[Name, str] | None = None,
    ) -> None:
        self._model, self._data = model, data
        self._names = tuple(feet)
        self._restore: list[tuple[NDArray[Any], int, int]] = []
        self._states: dict[int, _State] = {}
        if not self._names:
            raise ValueError("give at least one foot")
        if model._address in _FEET:
            raise ValueError("the model has feet already: close them first")
        _check_options(model)
        others = set(sites or {}) - set(self._names)
        if others:
            raise ValueError(f"sites are for feet, not for {sorted(map(str, others))}")
        self._given = [
            _given(model, name, friction, floor, (sites or {}).get(name))
            for name, friction in feet.items()
        ]
        _layout()
        self._free_of_friction()
        _FEET[model._address] = self
        _install()
        try:
            mujoco.mj_forward(model, data)
        except BaseException:
            self.close()
            raise

    def __getitem__(self, name: Name) -> FootState:
        return self.state(name)

    def state(self, name: Name, data: Any = None) -> FootState:
        """A foot in the last step of data; None for those that it was attached with."""
        if name not in self._names:
            raise KeyError(f"no foot {name!r}: there are {list(self._names)}")
        chosen = self._data if data is None else data
        native = self._state_of(chosen).native
        index = self._names.index(name)
        load, friction, twist, axes, centre, is_held, missed = native.state(index)
        arrays = (np.array(friction), np.array(twist), np.array(axes), np.array(centre))
        return FootState(load, *arrays, is_held, missed)

    def close(self) -> None:
        """Gives the contacts their own friction back; nothing more happens when it is called again."""
        if _FEET.get(self._model._address) is not self:
            return
        del _FEET[self._model._address]
        for array, index, value in self._restore:
            array[index] = value
        self._restore.clear()
        for state in self._states.values():
            _STATES.pop(id(state.data), None)
        self._states.clear()
        if not _FEET:
            _uninstall()

    def __enter__(self) -> Feet:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def __repr__(self) -> str:
        is_open = _FEET.get(self._model._address) is self
        return f"<tribos.mujoco.Feet {list(self._names)}{'' if is_open else ', closed'}>"

    def _free_of_friction(self) -> None:
        """Makes the contacts of the feet with their floors frictionless."""
        model = self._model
        for foot in self._given:
            for geom in foot.geoms:
                pair = [geom, foot.floor]
                priority = model.geom_priority[pair]
                for one in np.array(pair)[priority == priority.max()]:
                    self._set(model.geom_condim, int(one))
                pairs = zip(model.pair_geom1.tolist(), model.pair_geom2.tolist(), strict=True)
                for index, found in enumerate(pairs):
                    if sorted(found) == sorted(pair):
                        self._set(model.pair_dim, index)

    def _set(self, array: NDArray[Any], index: int) -> None:
        if array[index] != 1:
            self._restore.append((array, index, int(array[index])))
            array[index] = 1

    def _state_of(self, data: Any) -> _State:
        state = self._states.get(data._address)
        if state is None:
            state = self._states[data._address] = _State(self._model, data, self._given)
            _STATES[id(data)] = state
        return state


class _Given(NamedTuple):
    """A foot, as the compiled half takes it."""

    patch: _native.Patch
    mu: float
    geoms: list[int]
    floor: int
    frame: tuple[int, int]
    freedoms: list[tuple[int, float, int]]
    free: list[tuple[int, float, float, list[float]]]
    bodies: tuple[int, int]
    chains: tuple[list[tuple[int, int, int, int]], ...]
    is_free: bool


class _Places(NamedTuple):
    """Where arrays begin in the memory of a simulation, in numbers of 8 bytes, and their sizes."""

    velocity: int
    acceleration: int
    force: int
    axes: int
    centres: int
    origins: int
    anchors: int
    inertias: int
    frames: list[tuple[int, int]]
    freedoms: int
    bodies: int
    joints: int


class _Layout(NamedTuple):
    """Places of fields in MuJoCo's contacts: in numbers of 8 bytes, the last two of 4."""

    width: int
    distance: int
    position: int
    frame: int
    margin: int
    geoms: int
    row: int


class _State:
    """The feet of one MjData."""

    __slots__ = ("_mass", "_options", "_views", "data", "is_lifted", "native")

    def __init__(self, model: Any, data: Any, given: list[_Given]) -> None:
        self._mass: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None
        if not all(foot.is_free for foot in given):
            shape = (6 * len(given), model.nv)
            self._mass = (np.zeros(shape), np.zeros(shape))
        self.data = data
        self._options = model.opt
        self._views: dict[int, NDArray[np.int64]] = {}
        self.is_lifted = True
        frames = (
            (data.geom_xpos, data.geom_xmat),
            (data.xpos, data.xmat),
            (data.site_xpos, data.site_xmat),
        )
        rows = [
            array[row] for foot in given for table, row in [foot.frame] for array in frames[table]
        ]
        memory, places = _memory(
            data,
            [
                data.qvel,
                data.qacc,
                data.qfrc_passive,
                data.cdof,
                data.subtree_com,
                data.xpos,
                data.xanchor,
                data.ximat,
                *rows,
            ],
        )
        velocity, acceleration, force, axes, centres, origins, anchors, inertias, *others = places
        self.native = _native.MujocoFeet(
            given,
            memory,
            _Places(
                velocity,
                acceleration,
                force,
                axes,
                centres,
                origins,
                anchors,
                inertias,
                frames=list(zip(others[::2], others[1::2], strict=True)),
                freedoms=model.nv,
                bodies=model.nbody,
                joints=model.njnt,
            ),
            _layout(),
            self._mass,
        )

    def push(self, model: Any, data: Any) -> None:
        """Adds the friction of this step to the passive forces."""
        count = data.ncon
        native = self.native
        if not count:
            if not self.is_lifted:
                native.lift()
                self.is_lifted = True
            return
        self.is_lifted = False
        view = self._views.get(count)
        if view is None:
            view = self._views[count] = _view(data.contact)
        step = self._options.timestep
        if native.step(data.time, step, view, data.efc_D, data.efc_KBIP):
            assert self._mass is not None
            mujoco.mj_solveM(model, data, self._mass[1], self._mass[0])
            native.push(step)


def _memory(data: Any, arrays: list[NDArray[Any]]) -> tuple[NDArray[np.float64], list[int]]:
    """One array over the memory that MuJoCo's arrays are parts of, and where in it each begins."""
    starts = [_address(array) for array in arrays]
    first = min(starts)
    size = max(start + array.nbytes for start, array in zip(starts, arrays, strict=True)) - first
    if size > data.nbuffer or any((start - first) % 8 for start in starts):
        raise RuntimeError("the arrays of this version of MuJoCo are not in one piece of memory")
    lowest = arrays[starts.index(first)]
    whole = np.lib.stride_tricks.as_strided(lowest, shape=(size // 8,), strides=(8,))
    return whole, [(start - first) // 8 for start in starts]


def _view(contact: Any) -> NDArray[np.int64]:
    """MuJoCo's contacts as words of 8 bytes. They begin where the memory of a step begins, which does not
    move; their number is that of this step."""
    distance = contact.dist
    size = len(distance) * distance.strides[0] // 8
    whole = np.lib.stride_tricks.as_strided(distance, shape=(size,), strides=(8,))
    return whole.view(np.int64)


def _layout() -> _Layout:
    """The fields' places, from a contact of a tiny model."""
    global _LAYOUT
    if _LAYOUT is None:
        with paused():
            model = mujoco.MjModel.from_xml_string(_TWO_SPHERES)
            data = mujoco.MjData(model)
            mujoco.mj_forward(model, data)
        contact = data.contact
        start = _address(contact.dist)
        fields = (contact.dist, contact.pos, contact.frame, contact.includemargin)
        places = [_address(field) - start for field in fields]
        indices = [_address(field) - start for field in (contact.geom, contact.efc_address)]
        width = contact.dist.strides[0]
        if min(places + indices) < 0 or max(places + indices) >= width or width % 8:
            raise RuntimeError("the contacts of this version of MuJoCo are laid out in another way")
        _LAYOUT = _Layout(width // 8, *(at // 8 for at in places), *(at // 4 for at in indices))
    return _LAYOUT


_LAYOUT: _Layout | None = None
_TWO_SPHERES = """
<mujoco>
  <worldbody>
    <geom size="1"/>
    <body><freejoint/><geom size="1" pos="1 0 0"/></body>
  </worldbody>
</mujoco>
"""


def _address(array: NDArray[Any]) -> int:
    address: int = array.__array_interface__["data"][0]
    return address


def _check_options(model: Any) -> None:
    if model.opt.integrator == mujoco.mjtIntegrator.mjINT_RK4:
        raise ValueError(
            "the integrator RK4 evaluates forces within a step: choose Euler, implicit or implicitfast"
        )
    flags = mujoco.mjtDisableBit
    # One flag before MuJoCo 3.3.4, and a pair since.
    names = ("PASSIVE",) if hasattr(flags, "mjDSBL_PASSIVE") else ("SPRING", "DAMPER")
    if all(model.opt.disableflags & int(getattr(flags, f"mjDSBL_{name}")) for name in names):
        raise ValueError("passive forces are disabled in the model's options")


def _given(
    model: Any, name: Name, friction: Friction, floor: str | Mapping[Name, str], site: str | None
) -> _Given:
    if not isinstance(friction, Friction):
        raise ValueError(f"the friction of {name!r} must be a tribos.Friction, not {friction!r}")
    geoms = [_index(model, "geom", geom) for geom in ((name,) if isinstance(name, str) else name)]
    bodies = {int(model.geom_bodyid[geom]) for geom in geoms}
    if len(bodies) != 1:
        raise ValueError(f"the geoms of a foot must be of one body, those of {name!r} are not")
    if not isinstance(floor, str) and name not in floor:
        raise ValueError(f"floor has no entry for {name!r}")
    ground = _index(model, "geom", floor if isinstance(floor, str) else floor[name])
    if ground in geoms:
        raise ValueError(f"{name!r} cannot be its own floor")
    (body,) = bodies
    other = int(model.geom_bodyid[ground])
    if site is not None:
        frame = (2, _index(model, "site", site))
    else:
        frame = (0, geoms[0]) if len(geoms) == 1 else (1, body)
    sides = ((body, 1.0), (other, -1.0))
    signs: dict[int, float] = {}
    for side, sign in sides:
        for freedom in _freedoms(model, side):
            signs[freedom] = signs.get(freedom, 0.0) + sign
    roots = model.body_rootid[model.dof_bodyid]
    moving = [(side, sign) for side, sign in sides if _freedoms(model, side)]
    return _Given(
        patch=friction.patch._handle,
        mu=friction.mu,
        geoms=geoms,
        floor=ground,
        frame=frame,
        freedoms=[(index, sign, int(roots[index])) for index, sign in signs.items() if sign],
        free=[
            (side, sign, float(model.body_mass[side]), model.body_inertia[side].tolist())
            for side, sign in moving
        ],
        bodies=(body, other),
        chains=tuple(_joints(model, side) for side, _ in sides),
        is_free=all(_is_free(model, side) for side, _ in moving),
    )


def _freedoms(model: Any, body: int) -> list[int]:
    """Degrees of freedom that move a body."""
    found: list[int] = []
    while body:
        start = int(model.body_dofadr[body])
        found.extend(range(start, start + int(model.body_dofnum[body])))
        body = int(model.body_parentid[body])
    return found


def _joints(model: Any, body: int) -> list[tuple[int, int, int, int]]:
    """Joints that carry a body, from the innermost on: index, first freedom, how many shift and turn."""
    kinds = {
        int(getattr(mujoco.mjtJoint, f"mjJNT_{name}")): counts for name, counts in _FREEDOMS.items()
    }
    found: list[tuple[int, int, int, int]] = []
    while body:
        start = int(model.body_jntadr[body])
        for joint in reversed(range(start, start + int(model.body_jntnum[body]))):
            first = int(model.jnt_dofadr[joint])
            found.append((joint, first, *kinds[int(model.jnt_type[joint])]))
        body = int(model.body_parentid[body])
    return found


_FREEDOMS = {"FREE": (3, 3), "BALL": (0, 3), "SLIDE": (1, 0), "HINGE": (0, 1)}


def _is_free(model: Any, body: int) -> bool:
    """Whether a body moves as a free rigid body, alone in its tree."""
    if model.body_dofnum[body] != 6 or model.body_jntnum[body] != 1:
        return False
    start = model.body_dofadr[body]
    return bool(
        np.count_nonzero(model.body_rootid == model.body_rootid[body]) == 1
        and not model.dof_armature[start : start + 6].any()
        and model.body_mass[body] > 0.0
    )


def _index(model: Any, kind: str, name: object) -> int:
    kinds = {"geom": mujoco.mjtObj.mjOBJ_GEOM, "site": mujoco.mjtObj.mjOBJ_SITE}
    index = mujoco.mj_name2id(model, kinds[kind], name) if isinstance(name, str) else -1
    if index < 0:
        count = model.ngeom if kind == "geom" else model.nsite
        names: Iterable[str | None] = (
            mujoco.mj_id2name(model, kinds[kind], index) for index in range(count)
        )
        known = ", ".join(repr(one) for one in names if one)
        raise ValueError(
            f"the model has no {kind} {name!r}; its named {kind}s are: {known or 'none'}"
        )
    return int(index)


# Feet by their model's address; states by the identity of their data, which they keep alive.
_FEET: dict[int, Feet] = {}
_STATES: dict[int, _State] = {}
_EARLIER: list[Any] = []


def _push(model: Any, data: Any) -> None:
    """MuJoCo's callback for passive forces."""
    for earlier in _EARLIER:
        earlier(model, data)
    state = _STATES.get(id(data))
    if state is None:
        feet = _FEET.get(model._address)
        if feet is None:
            return
        state = feet._state_of(data)
    state.push(model, data)


def _install() -> None:
    current = mujoco.get_mjcb_passive()
    if current is not _push:
        _EARLIER[:] = [] if current is None else [current]
        mujoco.set_mjcb_passive(_push)


def _uninstall() -> None:
    if mujoco.get_mjcb_passive() is _push:
        mujoco.set_mjcb_passive(_EARLIER[0] if _EARLIER else None)
    _EARLIER.clear()
