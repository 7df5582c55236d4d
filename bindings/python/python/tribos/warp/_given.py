"""Feet as a MuJoCo model names them, checked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from tribos import _mujoco_checks
from tribos._friction import Friction
from tribos.warp._feet import FREE, MOVED, OF_BODY, OF_GEOM
from tribos.warp._forms import KINDS
from tribos.warp._search import BOX, POLYGON

Name = str | tuple[str, ...]

_OF_SITE = 2
# Three or more feet keep a body from tilting, whatever their geoms.
_TRIPOD = 3


class GivenShape(NamedTuple):
    """A patch: what it is, sides, corners, and centre, radius and 1/area."""

    kind: int
    sides: tuple[float, float]
    corners: list[list[float]]
    frame: tuple[float, float, float, float]


class GivenFoot(NamedTuple):
    """A foot, by numbers."""

    geoms: list[int]
    floor: int
    bodies: tuple[int, int]
    floor_kind: int
    frame: tuple[int, int]
    shape: GivenShape
    mu: float


def check_options(model: Any) -> None:
    import mujoco

    if model.opt.integrator == mujoco.mjtIntegrator.mjINT_RK4:
        raise ValueError(
            "the integrator RK4 evaluates forces within a step: choose Euler, implicit or implicitfast"
        )


def given_foot(
    model: Any, name: Name, friction: Friction, floor: str | Mapping[Name, str], site: str | None
) -> GivenFoot:
    if not isinstance(friction, Friction):
        raise ValueError(f"the friction of {name!r} must be a tribos.Friction, not {friction!r}")
    geoms = [_index(model, "geom", geom) for geom in ((name,) if isinstance(name, str) else name)]
    bodies = {int(model.geom_bodyid[geom]) for geom in geoms}
    if len(bodies) != 1:
        raise ValueError(f"the geoms of a foot must be of one body, those of {name!r} are not")
    if not isinstance(floor, str) and name not in floor:
        raise ValueError(f"floor has no entry for {name!r}")
    floor = floor if isinstance(floor, str) else floor[name]
    ground = _index(model, "geom", floor)
    body, other = bodies.pop(), int(model.geom_bodyid[ground])
    if model.body_weldid[body] == model.body_weldid[other]:
        why = _mujoco_checks.fixed(model, geoms[0])
        raise ValueError(f"foot {name!r} and its floor {floor!r} are of one body{why}")
    if not _is_free(model, body):
        raise ValueError(
            f"the body of foot {name!r} must hang on a free joint and have no moving parts: "
            "tribos.mujoco has feet of all bodies"
        )
    kind = 0
    if model.body_weldid[other] != 0:
        kind = int(FREE) if _is_free(model, other) else int(MOVED)
    elif model.body_mocapid[other] >= 0:
        kind = int(MOVED)
    if site is not None:
        frame = (_OF_SITE, _index(model, "site", site))
    else:
        frame = (int(OF_GEOM), geoms[0]) if len(geoms) == 1 else (int(OF_BODY), body)
    mu, shape = _mujoco_checks.coefficient(name, friction), _shape(name, friction)
    if frame[0] == OF_GEOM:
        _mujoco_checks.warn_of_size(model, name, friction.patch, geoms[0], ground)
    return GivenFoot(geoms, ground, (body, other), kind, frame, shape, mu)


def _is_free(model: Any, body: int) -> bool:
    """A body of a free joint that is all that the joint moves."""
    has_joint = model.body_dofnum[body] == 6 and model.body_jntnum[body] == 1
    alone = np.isclose(model.body_mass[body], model.body_subtreemass[body], rtol=1e-12)
    return bool(has_joint and alone and not (model.body_parentid[1:] == body).any())


def _shape(name: Name, friction: Friction) -> GivenShape:
    patch = friction.patch
    given = dict(patch._parameters)
    x, y = patch.centre
    if patch.kind in KINDS:
        return GivenShape(KINDS.index(patch.kind), (0.0, 0.0), [], (x, y, patch.radius, 0.0))
    if patch.kind == "box" and "centre" not in given:
        a, b = given["a"], given["b"]
        frame = (0.0, 0.0, patch.radius, patch.radius**2 / (a * b))
        return GivenShape(int(BOX), (a, b), [], frame)
    if patch.kind == "polygon" and set(given) == {"corners"}:
        corners = np.array(given["corners"])
        ahead = np.roll(corners, -1, axis=0)
        area = 0.5 * float(np.sum(corners[:, 0] * ahead[:, 1] - corners[:, 1] * ahead[:, 0]))
        frame = (x, y, patch.radius, patch.radius**2 / area)
        return GivenShape(int(POLYGON), (0.0, 0.0), corners.tolist(), frame)
    raise ValueError(
        f"foot {name!r}: Warp has disk, ring, punch, hertz and paraboloid, and box and polygon without "
        f"holes under uniform pressure, not {patch!r}"
    )


def check_pairs(given: list[GivenFoot], names: tuple[Name, ...]) -> None:
    seen: dict[tuple[int, int], Name] = {}
    for foot, name in zip(given, names):
        for geom in foot.geoms:
            other = seen.setdefault((geom, foot.floor), name)
            if other is not name:
                raise ValueError(f"feet {other!r} and {name!r} have a geom on the same floor")


def rolls_on(model: Any, foot: GivenFoot, given: list[GivenFoot], name: Name) -> int:
    """1 for a body that rolls on a single sphere."""
    import mujoco

    kinds = {int(model.geom_type[geom]) for geom in foot.geoms}
    shapes = mujoco.mjtGeom
    if sum(other.bodies[0] == foot.bodies[0] for other in given) >= _TRIPOD:
        return 0
    if kinds & {int(shapes.mjGEOM_CAPSULE), int(shapes.mjGEOM_ELLIPSOID)}:
        raise ValueError(
            f"foot {name!r} is a capsule or an ellipsoid, which may tilt: tribos.mujoco has such feet"
        )
    return int(kinds == {int(shapes.mjGEOM_SPHERE)} and len(foot.geoms) == 1)


def _index(model: Any, kind: str, name: object) -> int:
    import mujoco

    kinds = {"geom": mujoco.mjtObj.mjOBJ_GEOM, "site": mujoco.mjtObj.mjOBJ_SITE}
    index = mujoco.mj_name2id(model, kinds[kind], name) if isinstance(name, str) else -1
    if index < 0:
        count = model.ngeom if kind == "geom" else model.nsite
        names: list[str] = [mujoco.mj_id2name(model, kinds[kind], i) or "" for i in range(count)]
        # Newton adds the number of a shape to its label.
        parts = [one.rpartition("_") for one in names]
        labelled = [i for i, (label, _, end) in enumerate(parts) if label == name and end.isdigit()]
        if kind == "geom" and len(labelled) == 1:
            return labelled[0]
        known = ", ".join(repr(one) for one in names if one)
        raise ValueError(
            f"the model has no {kind} {name!r}; its named {kind}s are: {known or 'none'}"
        )
    return int(index)
