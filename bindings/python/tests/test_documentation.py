"""Examples in docstrings run and print what they say."""

import doctest
import importlib
import pkgutil

import pytest

import tribos

OPTIONAL = {"tribos.ase": "ase", "tribos.jax": "jax", "tribos.mujoco": "mujoco", "tribos.torch": "torch"}
MODULES = ["tribos", *(found.name for found in pkgutil.iter_modules(tribos.__path__, "tribos."))]


@pytest.mark.parametrize("name", [name for name in MODULES if not name.endswith("_native")])
def test_examples_in_docstrings_run(name: str) -> None:
    if name in OPTIONAL:
        pytest.importorskip(OPTIONAL[name])
    failed, _tried = doctest.testmod(importlib.import_module(name), optionflags=doctest.ELLIPSIS)
    assert failed == 0


def test_every_public_name_has_a_docstring() -> None:
    for name in tribos.__all__:
        assert getattr(tribos, name).__doc__, name
