"""Pictures: what is drawn lies where it should, and a missing matplotlib is named."""

from __future__ import annotations

import sys
import xml.etree.ElementTree as xml
from typing import Any

import numpy as np
import pytest
import tribos
from conftest import PATCHES

SVG = "{http://www.w3.org/2000/svg}"


def plt() -> Any:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    return pytest.importorskip("matplotlib.pyplot")


@pytest.mark.parametrize("patch", PATCHES, ids=lambda patch: str(patch.kind))
def test_a_plotted_surface_reaches_its_limits(patch: tribos.Patch) -> None:
    pyplot = plt()
    surface = tribos.LimitSurface(patch, mu=0.4, load=20.0)
    ax = surface.plot(resolution=16, color="C1")
    x, _, z = (np.array(limits) for limits in (ax.get_xlim(), ax.get_ylim(), ax.get_zlim()))
    assert 0.9 * surface.support([1.0, 0.0, 0.0]) < x[1] < 1.2 * 8.0
    assert 0.9 * surface.torque_limit < z[1]
    assert (ax.get_xlabel(), ax.get_zlabel()) == ("force x [N]", "torque [N m]")
    pyplot.close("all")


def test_wrenches_and_normals_are_drawn_into_given_axes() -> None:
    pyplot = plt()
    surface = tribos.LimitSurface(tribos.box(0.3, 0.2), mu=0.4, load=20.0)
    given = pyplot.figure().add_subplot(projection="3d")
    plain = len(surface.plot(given).collections)
    ax = surface.plot(given, wrenches=[[1, 2, 0.1]], normals=[[0, 8, 1], [5, 0, 0]])
    assert ax is given and len(ax.collections) == 2 * plain + 3
    with pytest.raises(ValueError, match="three dimensions"):
        surface.plot(pyplot.figure().add_subplot())
    with pytest.raises(ValueError, match="one load"):
        tribos.LimitSurface(tribos.disk(1.0), 0.4, [1.0, 2.0]).plot()
    with pytest.raises(ValueError, match="force limit is 0"):
        tribos.LimitSurface(tribos.disk(1.0), 0.0, 1.0).plot()
    pyplot.close("all")


def test_without_matplotlib_the_error_says_what_to_install(monkeypatch: Any) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    surface = tribos.LimitSurface(tribos.disk(1.0), 0.4, 1.0)
    with pytest.raises(ImportError, match=r"pip install tribos\[plot\]"):
        surface.plot()


@pytest.mark.parametrize("patch", PATCHES, ids=lambda patch: str(patch.kind))
def test_the_picture_of_a_patch_is_valid_and_within_its_frame(patch: tribos.Patch) -> None:
    root = xml.fromstring(patch._repr_svg_())
    assert root.tag == f"{SVG}svg" and root[0].text == repr(patch)
    width, height = (float(value) for value in root.attrib["viewBox"].split()[2:])
    assert 0.0 < width <= 181.0 and 0.0 < height <= 181.0
    for circle in root.iter(f"{SVG}circle"):
        x, y, r = (float(circle.attrib[name]) for name in ("cx", "cy", "r"))
        assert r > 0.0 and r <= x <= width - r and r <= y <= height - r
    shapes = len(list(root.iter(f"{SVG}path"))) + len(list(root.iter(f"{SVG}circle")))
    assert shapes >= 2


def test_the_centre_of_pressure_is_drawn_where_it_is() -> None:
    # 0.3 m are 160 pixels, margins 10; the picture's y leads downwards.
    box = tribos.box(0.3, 0.2, centre=(0.02, 0.01))
    root = xml.fromstring(box._repr_svg_())
    cross = list(root.iter(f"{SVG}path"))[-1].attrib["d"].split()
    x, y = float(cross[1]) + 5.0, float(cross[2])
    scale = 160.0 / 0.3
    assert x == pytest.approx(10.0 + (0.02 + 0.15) * scale, abs=0.02)
    assert y == pytest.approx(10.0 + (0.1 - 0.01) * scale, abs=0.02)


def test_tables_for_notebooks_name_the_limits() -> None:
    friction = tribos.Friction(tribos.disk(0.04), mu=0.3)
    text = friction._repr_html_()
    assert "tribos.Law(&#x27;coulomb&#x27;, mu=0.3)" in text and "0.04 m" in text
    xml.fromstring(text)
    surface = friction.limit_surface(load=[1.0, 2.0])
    text = surface._repr_html_()
    assert "0.3 … 0.6 N, shape (2,)" in text and "largest torque" in text
    xml.fromstring(text)
    assert "<svg" in text
