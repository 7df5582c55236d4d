"""Pictures: limit surfaces with matplotlib, patches as SVG, tables for notebooks."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

if TYPE_CHECKING:
    from tribos._patches import Patch
    from tribos._surface import LimitSurface

# Longer side of an SVG in pixels, and its margin.
_SIDE = 160.0
_MARGIN = 10.0
# Length of a drawn normal, of the set's size.
_ARROW = 0.35


def pyplot() -> Any:
    """matplotlib's pyplot, or an ImportError that says how to install it."""
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        message = "plots need matplotlib, which is not installed: pip install tribos[plot]"
        raise ImportError(message) from error
    return plt


def axes(ax: Any, *, projection: str | None = None) -> Any:
    """The given axes, or new ones; in three dimensions with the projection ``"3d"``."""
    plt = pyplot()
    if ax is None:
        return plt.figure().add_subplot(projection=projection)
    if projection == "3d" and not hasattr(ax, "plot_surface"):
        raise ValueError(
            "ax must be in three dimensions: plt.figure().add_subplot(projection='3d')"
        )
    return ax


def plot_surface(
    surface: LimitSurface,
    ax: Any,
    wrenches: ArrayLike | None,
    normals: ArrayLike | None,
    resolution: int,
    options: dict[str, Any],
) -> Any:
    """See `LimitSurface.plot`."""
    if np.ndim(surface.force_limit) != 0:
        raise ValueError("plot a limit surface under one load, not under an array of loads")
    scale = np.array([1.0, 1.0, 0.0]) * float(surface.force_limit)
    scale[2] = float(surface.torque_limit)
    if not scale[0] > 0.0:
        raise ValueError("there is nothing to plot: the force limit is 0")
    drawn = axes(ax, projection="3d")
    # Rays in all directions, in units of the limits; a set without torque is a flat disk.
    count = max(int(resolution), 2)
    around = np.linspace(0.0, 2.0 * np.pi, 2 * count + 1)
    height = np.linspace(-0.5 * np.pi, 0.5 * np.pi, count + 1)[:, np.newaxis]
    rays = np.stack(
        np.broadcast_arrays(
            np.cos(height) * np.cos(around),
            np.cos(height) * np.sin(around),
            np.sin(height) + 0.0 * around,
        ),
        axis=-1,
    )
    shown = surface.scale_to_surface(rays * scale)
    style = {"alpha": 0.5, "linewidth": 0.2, "edgecolor": "0.4", "rstride": 1, "cstride": 1}
    x, y, z = np.moveaxis(shown, -1, 0)
    drawn.plot_surface(x, y, z, **{**style, **options})
    if wrenches is not None:
        places = np.asarray(wrenches, dtype=np.float64).reshape(-1, 3)
        drawn.scatter(*places.T, color="k", depthshade=False)
    if normals is not None:
        pushes = np.asarray(normals, dtype=np.float64).reshape(-1, 3)
        feet = surface.scale_to_surface(pushes)
        # Lengths of the axes differ: an arrow is upright where the picture has equal sides.
        arrows = surface.normal(pushes) * scale
        arrows *= _ARROW / np.linalg.norm(arrows, axis=-1, keepdims=True)
        # A head would be skewed by the axes: a dot marks the foot.
        drawn.quiver(*feet.T, *(arrows * scale).T, color="C3", arrow_length_ratio=0.0)
        drawn.scatter(*feet.T, color="C3", s=12.0, depthshade=False)
    drawn.set_xlabel("force x [N]")
    drawn.set_ylabel("force y [N]")
    drawn.set_zlabel("torque [N m]")
    return drawn


def svg(patch: Patch) -> str:
    """The outline of a patch with its centre of pressure, as a small SVG."""
    shapes, low, high = _shapes(patch)
    extent = np.maximum(high - low, 0.0)
    longest = max(float(extent.max()), 1e-300)
    factor = _SIDE / longest
    width, height = extent * factor + 2.0 * _MARGIN

    def at(place: Sequence[float]) -> tuple[float, float]:
        # y upwards.
        x = (place[0] - low[0]) * factor + _MARGIN
        y = (high[1] - place[1]) * factor + _MARGIN
        return round(float(x), 2), round(float(y), 2)

    parts = []
    paths = []
    for shape in shapes:
        if shape[0] == "loop":
            corners = " L ".join(f"{x} {y}" for x, y in map(at, shape[1]))
            paths.append(f"M {corners} Z")
            continue
        (x, y), radius = at((0.0, 0.0)), shape[1] * factor
        if shape[0] == "circle":
            r = round(radius, 2)
            right, left = round(x + r, 2), round(x - r, 2)
            paths.append(f"M {right} {y} A {r} {r} 0 1 0 {left} {y} A {r} {r} 0 1 0 {right} {y} Z")
        else:
            x, y = at(shape[2])
            parts.append(f'<circle cx="{x}" cy="{y}" r="{round(shape[1], 2)}" fill="#4c78a8"/>')
    if paths:
        parts.insert(
            0,
            f'<path d="{" ".join(paths)}" fill="#c6dbef" fill-rule="evenodd" stroke="#4c78a8" '
            'stroke-width="1.5" stroke-linejoin="round"/>',
        )
    x, y = at(patch.centre)
    parts.append(
        f'<path d="M {x - 5} {y} h 10 M {x} {y - 5} v 10" stroke="#d62728" stroke-width="1.5"/>'
    )
    title = escape(repr(patch))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.2f} {height:.2f}" role="img"><title>{title}</title>'
        f"{''.join(parts)}</svg>"
    )


def _shapes(patch: Patch) -> tuple[list[tuple[Any, ...]], Any, Any]:
    """Loops, circles about the origin and dots, and the corners of what holds them all."""
    from tribos._patches import outline

    given = dict(patch._parameters)
    loops = outline(patch)
    if loops:
        places = np.concatenate([np.asarray(loop) for loop in loops])
        shapes: list[tuple[Any, ...]] = [("loop", loop) for loop in loops]
        return shapes, places.min(axis=0), places.max(axis=0)
    if patch.kind == "points":
        places = np.asarray(given["positions"])
        weights = np.asarray(given.get("weights", np.ones(len(places))))
        sizes = 6.0 * np.sqrt(weights / weights.max())
        dots = [("dot", size, tuple(place)) for size, place in zip(sizes, places)]
        return list(dots), places.min(axis=0), places.max(axis=0)
    radius = patch.radius
    corner = np.array([radius, radius])
    circles: list[tuple[Any, ...]] = [("circle", radius)]
    if patch.kind == "annulus":
        circles.append(("circle", given["inner"]))
    elif patch.kind == "ring":
        circles.append(("circle", 0.985 * radius))
    return circles, -corner, corner


def html(title: str, rows: Sequence[tuple[str, str]], patch: Patch) -> str:
    """A table beside the picture of a patch."""
    body = "".join(
        f"<tr><th style='text-align:left'>{escape(name)}</th>"
        f"<td style='text-align:left'>{escape(value)}</td></tr>"
        for name, value in rows
    )
    return (
        "<div style='display:flex;gap:1.5em;align-items:center'>"
        f"<table><caption>{escape(title)}</caption>{body}</table>{svg(patch)}</div>"
    )


def short(value: Any, unit: str) -> str:
    """A number for people with its unit, or the range of an array."""
    array = np.asarray(value)
    if array.ndim == 0:
        return f"{float(array):.6g} {unit}"
    if array.size == 0:
        return f"none of shape {array.shape}"
    return f"{array.min():.6g} … {array.max():.6g} {unit}, shape {array.shape}"
