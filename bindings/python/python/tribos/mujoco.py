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
The step is that of MuJoCo's plugin ``tribos.patch``, for a model without the plugin and for every
version of MuJoCo. Contacts of the geoms with their floor are made frictionless while the feet are
attached. In each step the load of a foot is the sum of its normal forces of the step before, and
friction is that of an implicit step: the wrench that would bring the foot to rest relative to its
floor, against its momentum and all other forces, brought to the nearest point of the limit surface
in the metric of the effective masses. A foot that friction can hold therefore stands still exactly; on a floor that
moves it is brought to where the floor will be at the end of the step, by the whole turns of the
floor's joints, and what it has slipped meanwhile is taken back, a fiftieth in each step. Feet that
move each other are solved together. Reactions act on the floor. Conveyors (``surfacevel``, MuJoCo 4)
take bodies along.

MuJoCo runs its callbacks when it compiles a model, and fails where they are Python's: compile
models before feet are attached, or within `paused`.

The step is of second order in the time step for velocities; MuJoCo's positions are of first order.
Friction of a body that starts to touch begins one step late.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from tribos import _mujoco_checks, _native
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
        limit surface, the integrator RK4, disabled passive forces, feet that no joint moves on their
        floor, two feet with a geom on the same floor, a model that has feet already, and data of
        another model.

    Warns
    -----
    UserWarning
        For a box or disk that is more than 1.5 times larger or smaller than its box or cylinder, without
        a site.

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
        self._state_of(data)
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
        """A foot in the last step of data; None for those that it was attached with.

        Raises
        ------
        KeyError
            For a name that is no foot's.
        ValueError
            For feet that are closed, and for data that made no step with them.
        """
        if name not in self._names:
            raise KeyError(f"no foot {name!r}: there are {list(self._names)}")
        state = self._states.get((self._data if data is None else data)._address)
        if state is None:
            raise ValueError("the feet are closed, or these data made no step with them")
        index = self._names.index(name)
        load, friction, twist, axes, centre, is_held, missed = state.native.state(index)
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
        return state


class _Given(NamedTuple):
    """A foot, as the compiled half takes it."""

    name: str
    patch: _native.Patch
    mu: float
    geoms: list[int]
    floor: int
    bodies: tuple[int, int]
    frame: tuple[int, int]


class _Simulation(NamedTuple):
    """A simulation, by the addresses of its parts."""

    arrays: list[int]
    solve: int
    model: int
    data: int
    awake: int
    counts: tuple[int, int, int]
    layout: tuple[int, ...]


class _State:
    """The feet of one MjData, which stays alive with its model as long as they do."""

    __slots__ = ("_contacts", "_data", "_model", "native")

    def __init__(self, model: Any, data: Any, given: list[_Given]) -> None:
        if any(getattr(data.model, size, 0) != getattr(model, size, 0) for size in _SIZES):
            raise ValueError("the data are of another model")
        self._model, self._data = model, data
        self._contacts = 0
        simulation = _Simulation(
            arrays=[_array(model, data, *array) for array in _native.MujocoFeet.arrays()],
            solve=_solver(),
            model=model._address,
            data=data._address,
            # MuJoCo's bodies sleep since 3.4.
            awake=_array(model, data, "int", "body_awake") if hasattr(data, "body_awake") else 0,
            counts=(model.nv, model.nbody, model.ngeom),
            layout=_layout(has_surfaces=bool(getattr(model, "flg_surfacevel", False))),
        )
        self.native = _native.MujocoFeet(simulation, given)

    def push(self) -> None:
        """Adds the friction of this step to the passive forces."""
        data, step = self._data, self._model.opt.timestep
        count = data.ncon
        # Contacts begin where the memory of a step begins, which does not move.
        if count and not self._contacts:
            self._contacts = _address(data.contact.dist)
        self.native.step(data.time, step, (self._contacts, count), data.efc_D, data.efc_KBIP)


# Sizes of a model that those of the arrays of its data come from; MuJoCo 3.2.0 has no nC.
_SIZES = ("nv", "nbody", "njnt", "ngeom", "nsite", "nM", "nC")


def _array(model: Any, data: Any, kind: str, name: str) -> int:
    """The address of one of MuJoCo's arrays."""
    array = getattr(model if hasattr(model, name) else data, name)
    if array.dtype != (np.int32 if "int" in kind else np.float64) or not array.flags.c_contiguous:
        raise RuntimeError(f"this version of MuJoCo has {name} in another form")
    return _address(array)


@cache
def _solver() -> int:
    """The address of MuJoCo's solution for the mass."""
    library = Path(mujoco._functions.__file__)
    if os.name == "nt":
        library = library.with_name("mujoco.dll")
    address = ctypes.cast(ctypes.CDLL(str(library)).mj_solveM, ctypes.c_void_p).value
    assert address is not None
    return address


@cache
def _layout(*, has_surfaces: bool) -> tuple[int, ...]:
    """How wide MuJoCo's contacts are and where in them the fields lie, from a contact of a tiny model."""
    with paused():
        model = mujoco.MjModel.from_xml_string(_TWO_SPHERES)
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
    contact, width = data.contact, int(data.contact.dist.strides[0])
    start = _address(contact.dist)
    names = ("dist", "pos", "frame", "includemargin", "geom", "dim", "efc_address")
    places = [_address(getattr(contact, name)) - start for name in names]
    places.append(_address(contact.surfacevel) - start if has_surfaces else -1)
    if min(places[:-1]) < 0 or max(places) >= width:
        raise RuntimeError("the contacts of this version of MuJoCo are laid out in another way")
    return (width, *places)


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
    # Bodies that no joint moves against each other are one.
    body_of = model.body_weldid[model.geom_bodyid]
    bodies = {int(body_of[geom]) for geom in geoms}
    if len(bodies) != 1:
        raise ValueError(f"the geoms of a foot must be of one body, those of {name!r} are not")
    if not isinstance(floor, str) and name not in floor:
        raise ValueError(f"floor has no entry for {name!r}")
    floor = floor if isinstance(floor, str) else floor[name]
    ground = _index(model, "geom", floor)
    if body_of[ground] in bodies:
        why = _mujoco_checks.fixed(model, geoms[0])
        raise ValueError(f"foot {name!r} and its floor {floor!r} are of one body{why}")
    mu = _mujoco_checks.coefficient(name, friction)
    if site is not None:
        frame = (2, _index(model, "site", site))
    else:
        frame = (0, geoms[0]) if len(geoms) == 1 else (1, int(model.geom_bodyid[geoms[0]]))
    if frame[0] == 0:
        _mujoco_checks.warn_of_size(model, name, friction.patch, geoms[0], ground)
    return _Given(
        name=repr(name),
        patch=friction.patch._handle,
        mu=mu,
        geoms=geoms,
        floor=ground,
        bodies=(bodies.pop(), int(body_of[ground])),
        frame=frame,
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


# Feet by the address of their model, which they keep alive.
_FEET: dict[int, Feet] = {}
_EARLIER: list[Any] = []


def _push(model: Any, data: Any) -> None:
    """MuJoCo's callback for passive forces."""
    for earlier in _EARLIER:
        earlier(model, data)
    feet = _FEET.get(model._address)
    if feet is not None:
        feet._state_of(data).push()


def _install() -> None:
    current = mujoco.get_mjcb_passive()
    if current is not _push:
        _EARLIER[:] = [] if current is None else [current]
        mujoco.set_mjcb_passive(_push)


def _uninstall() -> None:
    if mujoco.get_mjcb_passive() is _push:
        mujoco.set_mjcb_passive(_EARLIER[0] if _EARLIER else None)
    _EARLIER.clear()
