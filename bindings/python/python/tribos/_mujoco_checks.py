"""What feet of MuJoCo, MJX and MuJoCo Warp check alike."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tribos._friction import Friction
from tribos._patches import Patch

# Sizes of a patch and of its geom that differ by more are taken for an error.
_FACTOR = 1.5


def coefficient(name: object, friction: Friction) -> float:
    """The coefficient of a foot's friction; ValueError for other laws than Coulomb's."""
    try:
        return friction.mu
    except ValueError as error:
        raise ValueError(f"foot {name!r}: {error}; feet take Coulomb friction (mu=...)") from None


def fixed(model: Any, geom: int) -> str:
    """Why a geom is fixed to the world, as the end of a message; empty if it is not."""
    import mujoco

    body = int(model.geom_bodyid[geom])
    if model.body_weldid[body] != 0:
        return ""
    if body == 0:
        return ": the geom is of the world itself"
    name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, body) or body
    return f": body {name!r} has no joint, so that it is fixed to the world"


def warn_of_size(model: Any, name: object, patch: Patch, geom: int, ground: int) -> None:
    """A UserWarning for a box or disk that is much larger or smaller than its box or cylinder.

    A box that stands on a plane is taken to stand as in the model's first configuration; elsewhere the face that fits best counts.
    """
    import mujoco

    kind, size = model.geom_type[geom], model.geom_size[geom]
    given = dict(patch._parameters)
    if patch.kind == "disk" and kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        own, others = np.array([given["radius"]]), [size[:1]]
        words = "radius {} m", "cylinder of radius {} m"
    elif patch.kind == "box" and kind == mujoco.mjtGeom.mjGEOM_BOX:
        own = np.array([given["a"], given["b"]])
        # Of the frame's axes the one after that along the normal is the patch's x.
        others = [2.0 * size[[(up + 1) % 3, (up + 2) % 3]] for up in range(3)]
        if model.geom_type[ground] == mujoco.mjtGeom.mjGEOM_PLANE:
            normal = _axes(model, ground)[:, 2]
            others = [others[int(np.argmax(np.abs(normal @ _axes(model, geom))))]]
        words = "sides {} m", "box, whose face has full sides {} m"
    else:
        return
    ratios = [np.exp(np.abs(np.log(own / other)).max()) for other in others]
    best = int(np.argmin(ratios))
    if ratios[best] > _FACTOR:
        found, wanted = (" x ".join(f"{x:g}" for x in sizes) for sizes in (own, others[best]))
        geom_name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_GEOM, geom)
        warnings.warn(
            f"foot {name!r}: the patch has {words[0].format(found)}, geom {geom_name!r} is a {words[1].format(wanted)}"
            + ("; geoms have half lengths, tribos.box has full sides" if len(own) == 2 else ""),
            UserWarning,
            stacklevel=2,
        )


def _axes(model: Any, geom: int) -> NDArray[np.float64]:
    """The axes of a geom in the columns, in the first configuration."""
    import mujoco

    turn, product = np.array(model.geom_quat[geom], float), np.empty(4)
    body = int(model.geom_bodyid[geom])
    while body > 0:
        mujoco.mju_mulQuat(product, model.body_quat[body], turn)
        turn, body = product.copy(), int(model.body_parentid[body])
    made = np.empty(9)
    mujoco.mju_quat2Mat(made, turn)
    return made.reshape(3, 3)
