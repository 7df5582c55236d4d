"""Examples in docstrings run and print what they say."""

import doctest
import importlib
import importlib.util
import pkgutil
import re

import pytest
import tribos

# Packages that few have, and examples do without.
OPTIONAL = (
    "ase",
    "dask",
    "jax",
    "matplotlib",
    "mujoco",
    "pandas",
    "pytest",
    "ray",
    "torch",
    "warp",
)
MISSING = [package for package in OPTIONAL if importlib.util.find_spec(package) is None]


def can_be_imported(module: str) -> bool:
    try:
        importlib.import_module(module)
    except ImportError as error:
        # MJX is a part of MuJoCo's package, which may be there without it.
        if (error.name or "").partition(".")[0] not in OPTIONAL:
            raise
        return False
    return True


MODULES = [
    found.name
    for found in pkgutil.walk_packages(tribos.__path__, "tribos.", onerror=lambda _: None)
    if found.name not in ("tribos._native", "tribos.__main__") and can_be_imported(found.name)
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
