"""The plugin's library: build/libtribos_patch.so, or the file in the environment variable TRIBOS_PATCH."""

import os
import pathlib

import mujoco
import pytest

BUILT = pathlib.Path(__file__).parents[1] / "build" / "libtribos_patch.so"


def library():
    return pathlib.Path(os.environ.get("TRIBOS_PATCH", BUILT)).resolve()


@pytest.fixture(autouse=True, scope="session")
def plugin():
    assert library().exists(), f"no {library()}: run make"
    mujoco.mj_loadPluginLibrary(str(library()))
