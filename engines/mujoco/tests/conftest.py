"""The plugin's library: build/libtribos_patch.so, or the file in the environment variable TRIBOS_PATCH."""

import os
import pathlib

import mujoco
import pytest

BUILT = pathlib.Path(__file__).parents[1] / "build" / "libtribos_patch.so"


@pytest.fixture(autouse=True, scope="session")
def plugin():
    path = pathlib.Path(os.environ.get("TRIBOS_PATCH", BUILT))
    assert path.exists(), f"no {path}: run make"
    mujoco.mj_loadPluginLibrary(str(path))
