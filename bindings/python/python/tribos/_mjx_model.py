"""Feet of a MuJoCo model, as MJX needs them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import mujoco
import numpy as np

from tribos import _mujoco_checks, _patches
from tribos._checks import number
from tribos._friction import Friction
from tribos._mjx_place import Links
from tribos._mjx_solve import Groups

Name = str | tuple[str, ...]
# Attributes of the plugin, in the order in which it registers them; and the numbers of its state.
KEYS = ("geom", "ground", "site", "patch", "size", "corners", "mu", "mu_s", "ageing_b", "ageing_t0")
PLUGIN_STATE = 15
# Keys of friction at rest, which MJX does not have.
AT_REST = KEYS[7:]
ROUND = {
    "disk": _patches.disk,
    "ring": _patches.ring,
    "hertz": _patches.hertz,
    "punch": _patches.punch,
}


class Given(NamedTuple):
    """A foot as it is asked for."""

    name: Name
    friction: Friction
    geoms: tuple[str, ...]
    grounds: tuple[str, ...]
    site: str


def of_model(model: Any) -> list[Given]:
    """The feet of the instances of the plugin ``tribos.patch`` in a model."""
    made = []
    for index in range(model.nplugin):
        texts = bytes(model.plugin_attr[model.plugin_attradr[index] :]).split(b"\0")[: len(KEYS)]
        keys = dict(zip(KEYS, (text.decode() for text in texts), strict=False))
        # Other plugins may be in the model, and names of plugins are not.
        if (
            model.plugin_statenum[index] == PLUGIN_STATE
            and keys.get("ground")
            and keys.get("patch")
        ):
            made.append(of_keys(keys))
    if not made:
        raise ValueError(
            "the model has no instance of the plugin tribos.patch: give the feet, as a list of dicts with its keys "
            "or as a mapping of geoms and tribos.Friction"
        )
    return made


def of_keys(keys: Mapping[str, Any]) -> Given:
    """A foot from the plugin's keys."""
    unknown = set(keys) - {*KEYS, "name"}
    if unknown:
        raise ValueError(f"a foot has the keys {', '.join(KEYS)} and name, not {sorted(unknown)}")
    geoms, grounds = (_names(keys, key) for key in ("geom", "ground"))
    name = str(keys.get("name") or " ".join(geoms))
    try:
        if keys.get("mu") in (None, ""):
            raise ValueError("mu is missing: give the coefficient of friction")
        if any(keys.get(key) not in (None, "") for key in AT_REST):
            raise ValueError(f"{', '.join(AT_REST)} are the plugin's alone: leave them out")
        mu = number("mu", float(keys["mu"]) if isinstance(keys["mu"], str) else keys["mu"])
        return Given(
            name, Friction(_patch(keys), mu=mu), geoms, grounds, str(keys.get("site") or "")
        )
    except ValueError as error:
        raise ValueError(f"foot {name!r}: {error}") from error


def of_mapping(
    feet: Mapping[Name, Friction],
    floor: str | Mapping[Name, str],
    sites: Mapping[Name, str] | None,
) -> list[Given]:
    """Feet as `tribos.mujoco.attach` takes them."""
    others = set(sites or {}) - set(feet)
    if others:
        raise ValueError(f"sites are for feet, not for {sorted(map(str, others))}")
    made = []
    for name, friction in feet.items():
        if not isinstance(friction, Friction):
            raise ValueError(
                f"the friction of {name!r} must be a tribos.Friction, not {friction!r}"
            )
        _mujoco_checks.coefficient(name, friction)
        if not isinstance(floor, str) and name not in floor:
            raise ValueError(f"floor has no entry for {name!r}")
        ground = floor if isinstance(floor, str) else floor[name]
        geoms = (name,) if isinstance(name, str) else name
        made.append(Given(name, friction, geoms, (ground,), (sites or {}).get(name, "")))
    return made


def link(model: Any, feet: Sequence[Given]) -> Links:
    """What feet are in a model.

    Raises
    ------
    ValueError
        For names that the model does not have, geoms of a foot or ground on several bodies, contacts with friction of MuJoCo's own,
        feet that no joint moves on their floor, geoms that belong to two feet on one ground, and the integrator RK4.
    """
    if model.opt.integrator == mujoco.mjtIntegrator.mjINT_RK4:
        raise ValueError(
            "the integrator RK4 evaluates forces within a step: choose Euler or implicitfast"
        )
    if len({foot.name for foot in feet}) != len(feet):
        raise ValueError("names of feet must differ")
    geoms, grounds, bodies, frames = [], [], [], []
    for foot in feet:
        own = tuple(_index(model, "geom", name) for name in foot.geoms)
        under = tuple(_index(model, "geom", name) for name in foot.grounds)
        pair = (_body(model, foot, "geom", own), _body(model, foot, "ground", under))
        if pair[0] == pair[1]:
            why = _mujoco_checks.fixed(model, own[0])
            raise ValueError(f"foot {foot.name!r} and its ground are of one body{why}")
        _check_contacts(model, own, under)
        if len(own) == 1 and not foot.site:
            _mujoco_checks.warn_of_size(model, foot.name, foot.friction.patch, own[0], under[0])
        geoms.append(own)
        grounds.append(under)
        bodies.append(pair)
        frames.append(_frame(model, foot, own, pair[0]))
    _check_claims(feet, geoms, grounds)
    senses = np.stack([_moves(model, foot) - _moves(model, ground) for foot, ground in bodies])
    for foot, row in zip(feet, senses, strict=True):
        if not row.any():
            raise ValueError(
                f"foot {foot.name!r} never moves on its ground: neither body has a joint"
            )
    roots = model.body_rootid[model.dof_bodyid]
    free = _free_bodies(model)
    free_freedoms = (model.body_dofadr[free][:, None] + np.arange(6)).ravel()
    return Links(
        geoms=tuple(geoms),
        grounds=tuple(grounds),
        bodies=np.array(bodies),
        frames=np.array(frames),
        senses=senses,
        roots=roots,
        free=free,
        free_freedoms=free_freedoms,
        freedoms=np.setdiff1d(np.arange(model.nv), free_freedoms),
        groups=_groups(senses, roots),
    )


def _names(keys: Mapping[str, Any], key: str) -> tuple[str, ...]:
    given = keys.get(key) or ""
    names = tuple(given.split()) if isinstance(given, str) else tuple(given)
    if not names:
        raise ValueError(
            f"{key} is missing: give the name of a geom, or of several separated by spaces"
        )
    if len(set(names)) != len(names):
        raise ValueError(f"{key} names a geom twice: {' '.join(names)}")
    return names


def _numbers(keys: Mapping[str, Any], key: str) -> list[float]:
    given = keys.get(key)
    if given is None or isinstance(given, str):
        return [float(text) for text in (given or "").split()]
    return [float(x) for x in np.ravel(given)]


def _patch(keys: Mapping[str, Any]) -> _patches.Patch:
    """The patch of the keys patch, size and corners."""
    kind, size, corners = keys.get("patch"), _numbers(keys, "size"), _numbers(keys, "corners")
    if kind in ("polygon", "points"):
        if size or len(corners) % 2 or not corners:
            raise ValueError(f"patch {kind!r} has corners, pairs x y in m, and no size")
        places = np.reshape(corners, (-1, 2))
        return _patches.polygon(places) if kind == "polygon" else _patches.points(places)
    if corners:
        raise ValueError(f'corners are for patches "polygon" and "points", not for {kind!r}')
    if kind in ROUND and len(size) == 1:
        return ROUND[kind](size[0])
    if kind == "annulus" and len(size) == 2:
        return _patches.annulus(*size)
    if kind == "box" and len(size) == 2:
        return _patches.box(2.0 * size[0], 2.0 * size[1])
    known = ("disk", "annulus", "ring", "hertz", "punch", "box", "polygon", "points")
    if kind not in known:
        raise ValueError(f"patch must be one of {', '.join(known)}, not {kind!r}")
    raise ValueError(
        f"size of patch {kind!r} is one radius, or two lengths for annulus and box, not {size}"
    )


def _index(model: Any, kind: str, name: object) -> int:
    kinds = {"geom": mujoco.mjtObj.mjOBJ_GEOM, "site": mujoco.mjtObj.mjOBJ_SITE}
    index = mujoco.mj_name2id(model, kinds[kind], name) if isinstance(name, str) else -1
    if index < 0:
        count = model.ngeom if kind == "geom" else model.nsite
        names: Iterable[str | None] = (
            mujoco.mj_id2name(model, kinds[kind], at) for at in range(count)
        )
        known = ", ".join(repr(one) for one in names if one)
        raise ValueError(
            f"the model has no {kind} {name!r}; its named {kind}s are: {known or 'none'}"
        )
    return int(index)


def _body(model: Any, foot: Given, key: str, geoms: tuple[int, ...]) -> int:
    """The body of a side; bodies that no joint moves against each other are one."""
    bodies = {int(model.body_weldid[model.geom_bodyid[geom]]) for geom in geoms}
    if len(bodies) != 1:
        raise ValueError(f"the geoms of {key} of foot {foot.name!r} must be of one body")
    return bodies.pop()


def _frame(model: Any, foot: Given, geoms: tuple[int, ...], body: int) -> int:
    """The frame of the patch, counted over geoms, bodies and sites."""
    if foot.site:
        site = _index(model, "site", foot.site)
        if model.body_weldid[model.site_bodyid[site]] != body:
            raise ValueError(f"site {foot.site!r} is not on the body of foot {foot.name!r}")
        return int(model.ngeom + model.nbody + site)
    return geoms[0] if len(geoms) == 1 else int(model.ngeom + model.geom_bodyid[geoms[0]])


def _dimension(model: Any, a: int, b: int) -> int:
    """The dimension of contacts of two geoms, by MuJoCo's rule; 0 where they have none."""
    for first, second, dimension in zip(
        model.pair_geom1, model.pair_geom2, model.pair_dim, strict=True
    ):
        if {int(first), int(second)} == {a, b}:
            return int(dimension)
    types, affinities = model.geom_contype, model.geom_conaffinity
    if not (types[a] & affinities[b]) and not (types[b] & affinities[a]):
        return 0
    first, second = model.geom_priority[[a, b]]
    condim = model.geom_condim
    return int(max(condim[a], condim[b]) if first == second else condim[a if first > second else b])


def _check_contacts(model: Any, geoms: tuple[int, ...], grounds: tuple[int, ...]) -> None:
    for geom in geoms:
        for ground in grounds:
            one, other = (
                mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_GEOM, at) for at in (geom, ground)
            )
            dimension = _dimension(model, geom, ground)
            if dimension == 0:
                raise ValueError(
                    f'geoms "{one}" and "{other}" never touch: their contype and conaffinity exclude each other, and '
                    "there is no contact pair"
                )
            if dimension != 1:
                raise ValueError(
                    f'contacts of geoms "{one}" and "{other}" have friction of MuJoCo\'s own (condim {dimension}): give '
                    f'"{one}" condim="1" and a higher priority than "{other}", or both condim="1", or a contact pair with '
                    'condim="1"'
                )


def _check_claims(feet: Sequence[Given], geoms: list[Any], grounds: list[Any]) -> None:
    claims: dict[frozenset[int], Name] = {}
    for foot, own, under in zip(feet, geoms, grounds, strict=True):
        for geom in own:
            for ground in under:
                other = claims.setdefault(frozenset((geom, ground)), foot.name)
                if other != foot.name:
                    raise ValueError(
                        f"feet {other!r} and {foot.name!r} have the friction of the same geoms"
                    )


def _moves(model: Any, body: int) -> Any:
    """1 for each degree of freedom that moves a body."""
    row = np.zeros(model.nv)
    while body > 0:
        first = model.body_dofadr[body]
        row[first : first + model.body_dofnum[body]] = 1.0
        body = int(model.body_parentid[body])
    return row


def _free_bodies(model: Any) -> Any:
    made = []
    for body in range(1, model.nbody):
        own = slice(model.body_dofadr[body], model.body_dofadr[body] + 6)
        is_one = model.body_dofnum[body] == 6 and model.body_jntnum[body] == 1
        is_alone = (model.body_rootid == model.body_rootid[body]).sum() == 1
        if (
            is_one
            and is_alone
            and not (model.dof_armature[own].any() or model.dof_damping[own].any())
        ):
            made.append(body)
    return np.array(made, int)


def _groups(senses: Any, roots: Any) -> Groups:
    """Feet with degrees of freedom of the same trees, directly or by way of others."""
    trees = np.stack(
        [(senses[:, roots == root] != 0.0).any(axis=1) for root in np.unique(roots)], axis=1
    )
    joined = trees @ trees.T
    for _ in range(len(joined)):
        joined = joined @ joined
    found: dict[int, list[tuple[int, ...]]] = {}
    for row in np.unique(joined, axis=0):
        feet = tuple(int(at) for at in np.flatnonzero(row))
        found.setdefault(len(feet), []).append(feet)
    return Groups(tuple(np.array(found[size]) for size in sorted(found)))
