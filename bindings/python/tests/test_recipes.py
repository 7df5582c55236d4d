"""Programs in Python on the pages of the book and in the README run as printed, and print what follows them."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
REPOSITORY = Path(os.environ.get("TRIBOS_REPOSITORY", HERE.parents[2]))
# From a source archive the README alone.
PAGES = {"package": HERE.parent / "README.md", "README": REPOSITORY / "README.md"}
PAGES |= {page.stem: page for page in sorted((REPOSITORY / "docs").glob("*.md"))}

OPTIONAL = ("ase", "dask", "jax", "matplotlib", "mujoco", "pandas", "ray", "scipy", "torch", "warp")
BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\n```text\n(.*?)^```$)?", re.MULTILINE | re.DOTALL)


def programs() -> list[object]:
    found = []
    for name, page in PAGES.items():
        if not page.exists():
            continue
        text = page.read_text(encoding="utf-8")
        for number, (code, printed) in enumerate(BLOCK.findall(text), 1):
            found.append(pytest.param(code, printed, id=f"{name}-{number}"))
    return found


@pytest.mark.parametrize(("code", "printed"), programs())
def test_a_recipe_runs_as_printed(code: str, printed: str, tmp_path: Path) -> None:
    for package in OPTIONAL:
        if re.search(rf"\b(import|from) (tribos\.)?{package}\b", code):
            pytest.importorskip(package)
    if "frame=True" in code:
        pytest.importorskip("pandas")
    if (REPOSITORY / "scenes").exists():
        (tmp_path / "scenes").symlink_to(REPOSITORY / "scenes")
    program = tmp_path / "recipe.py"
    program.write_text(code, encoding="utf-8")
    # A program of its own: Ray and JAX keep what others in a process have chosen.
    ended = subprocess.run([sys.executable, program], cwd=tmp_path, capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    # What a page leaves out, times of the clock for one, is any text.
    expected = ".*?".join(re.escape(part) for part in printed.split("…"))
    assert re.fullmatch(expected, ended.stdout, re.DOTALL), ended.stdout
