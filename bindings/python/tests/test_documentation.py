"""Examples in docstrings run and print what they say."""

import doctest
import importlib
import importlib.util
import pkgutil
import re

import pytest
import tribos

# Packages that few have, and examples do without.
OPTIONAL = ("ase", "dask", "jax", "matplotlib", "mujoco", "pandas", "pytest", "ray", "torch")
MISSING = [package for package in OPTIONAL if importlib.util.find_spec(package) is None]
# Modules that need several, by the beginning of their names.
NEEDED = {"mjx": ("jax", "mujoco", "mujoco.mjx"), "_mjx_": ("jax", "mujoco", "mujoco.mjx")}


def can_be_imported(module: str) -> bool:
    needed = next((all_ for name, all_ in NEEDED.items() if module.startswith(name)), ())
    return module not in MISSING and all(
        package.partition(".")[0] not in MISSING and importlib.util.find_spec(package)
        for package in needed
    )


MODULES = [
    found.name
    for found in pkgutil.iter_modules(tribos.__path__, "tribos.")
    if found.name not in ("tribos._native", "tribos.__main__")
    and can_be_imported(found.name.removeprefix("tribos."))
]


def needs_what_is_missing(test: doctest.DocTest) -> bool:
    code = "".join(example.source for example in test.examples)
    return any(re.search(rf"import [^\n]*\b(?<!\.){package}\b", code) for package in MISSING)


@pytest.mark.parametrize("name", ["tribos", *MODULES])
def test_examples_in_docstrings_run(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "Agg")
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    for test in doctest.DocTestFinder().find(importlib.import_module(name)):
        if not needs_what_is_missing(test):
            runner.run(test)
    assert runner.summarize(verbose=False).failed == 0


def test_every_public_name_has_a_docstring() -> None:
    assert len(tribos.__all__) > 50
    for name in tribos.__all__:
        thing = getattr(tribos, name)
        assert isinstance(thing, str) or thing.__doc__, name
