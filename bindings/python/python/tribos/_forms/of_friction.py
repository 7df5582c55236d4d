"""Which friction has a form, and what it is made from."""

from __future__ import annotations

from typing import Any

from tribos._forms.coulomb import ORDERS, Pressure
from tribos._forms.form import Form
from tribos._forms.polygon import Flat
from tribos._forms.round import Round
from tribos._friction import Friction
from tribos._patches import outline

#: The form of polygons; others have the names of their pressures.
FLAT = "flat"


def is_dry(friction: Friction) -> bool:
    """Whether friction does not depend on the speed."""
    law = friction.law
    return law.name == "coulomb" or (law.name == "power" and law.parameters["alpha"] == 0.0)


def kind_of(friction: Friction) -> str | None:
    """The form of a friction, None if it has none."""
    patch = friction.patch
    if not is_dry(friction):
        return None
    if patch.kind in ORDERS:
        return patch.kind
    is_flat = patch.kind in ("box", "polygon")
    return FLAT if is_flat and not {"holes", "centre"} & dict(patch._parameters).keys() else None


def size_of(friction: Friction) -> Any:
    """The numbers that the form of a friction is made from: its radius or its corners, in m."""
    patch = friction.patch
    return patch.radius if patch.kind in ORDERS else outline(patch)[0]


def form_of(kind: str, size: Any) -> Form:
    """The form of a kind and of an array of radii or corners."""
    form: Form = Flat(size) if kind == FLAT else Round(Pressure(kind), size)
    return form
