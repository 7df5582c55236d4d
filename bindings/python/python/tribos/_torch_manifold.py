"""Friction of contact manifolds in PyTorch programs."""

from __future__ import annotations

from typing import Any

from tribos._arguments import axes_of, check_sign
from tribos._forms import torch as space
from tribos._forms.manifold import ARGUMENTS, SIGNS, terms_in
from tribos._forms.manifold import manifold_friction as _form
from tribos._torch_arguments import tensor, together


def manifold_friction(
    impulses: Any,
    twist: Any,
    force: Any,
    lever: Any,
    *,
    k: Any,
    kt: Any,
    slip: Any = 1.0,
    curve: Any = "area",
    steps: int = 2,
) -> tuple[Any, Any]:
    """What friction of a contact manifold carries of the impulses that would stop it: the nearest by energy.

    As ``tribos_manifold_friction`` of the C header. Derivatives by all arguments but `steps`, of first and second
    order, are those of the nearest point, finite everywhere.

    Parameters
    ----------
    impulses, twist
        Tangential impulses in N s, of shape (..., 2), and angular ones in N m s, of shape (...).
    force, lever
        Largest tangential impulse, mu times the sum of normal ones, in N s, and the contacts' mean distance from the
        friction centre in m, at least 0.
    k, kt
        Inverse effective masses in 1/kg, above 0, and 1/(kg m²), at least 0.
    slip
        Dynamic over static coefficient, above 0 and at most 1.
    curve
        ``"area"`` for faces, ``"points"`` for rings and feet at corners, ``"ellipsoid"``, or its three coefficients.
    steps
        Newton steps; 2 give 5e-4 of the limits for ratios of the energies of 0.01 to 100, 3 give 1e-5.

    Examples
    --------
    >>> import torch, tribos.torch
    >>> p, twist = tribos.torch.manifold_friction(
    ...     torch.tensor([1.0, 0.0]), 0.05, 0.5, 0.1, k=1.0, kt=100.0
    ... )
    >>> print([round(float(x), 3) for x in (p[0], twist)])
    [0.445, 0.018]
    """
    name = "tribos.torch.manifold_friction"
    given = (impulses, twist, force, lever, k, kt, slip, *terms_in(name, curve, steps))
    for key, x in zip(ARGUMENTS, given):
        if key in SIGNS:
            check_sign(name, key, x, above=SIGNS[key])
    own, dtype, device = together(name, given)
    p, *numbers = (tensor(x, dtype, device) for x in given)
    if p.shape[-1:] != (2,):
        raise ValueError(f"{name}: impulses must have shape (..., 2), not {tuple(p.shape)}")
    shapes = {key: tuple(x.shape) for key, x in zip(ARGUMENTS[1:], numbers)}
    axes = axes_of(name, {ARGUMENTS[0]: tuple(p.shape[:-1]), **shapes})
    twist, force, lever, k, kt, slip, *terms = numbers
    p, twist = p.broadcast_to((*axes, 2)), twist.broadcast_to(axes)
    limits = {"slip": slip, "curve": (terms[0], terms[1], terms[2]), "steps": steps}
    made = _form(space, p, twist, force, lever, k=k, kt=kt, **limits)
    return made[0].to(own), made[1].to(own)
