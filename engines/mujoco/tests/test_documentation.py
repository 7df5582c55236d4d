"""What the pages print runs as printed, and so does the program in C."""

import contextlib
import io
import pathlib
import re
import subprocess

import mujoco
import pytest

from conftest import library

HERE = pathlib.Path(__file__).resolve().parents[1]
PAGE = HERE.parents[1] / "docs" / "mujoco.md"


def block(page, language):
    return re.search(rf"```{language}\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)


def printed(code):
    """What a program prints that names files of this folder."""
    code = re.sub(r'"[^"]*libtribos_patch.so"', repr(str(library())), code)
    code = re.sub(r'"[^"]*examples/puck.xml"', repr(str(HERE / "examples" / "puck.xml")), code)
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(compile(code, "page", "exec"), {})
    return said.getvalue().strip()


def test_the_program_of_the_readme_prints_what_follows_it():
    page = HERE / "README.md"
    found = block(page, "python")
    after = page.read_text(encoding="utf-8")[found.end() :]
    assert after.startswith(f"\n\nprints `{printed(found.group(1))}`")


def test_the_program_of_the_page_prints_what_follows_it():
    found = block(PAGE, "py")
    after = PAGE.read_text(encoding="utf-8")[found.end() :]
    assert after.startswith(f"\n\n```text\n{printed(found.group(1))}\n```")


def test_the_model_of_the_page_compiles():
    model = mujoco.MjModel.from_xml_string(block(PAGE, "xml").group(1))
    assert model.nplugin == 1


def test_the_program_in_c_prints_the_table():
    host = library().parent / "host"
    if not host.exists():
        pytest.skip("the program is not built: make host")
    examples = [HERE / "examples" / name for name in ("puck.xml", "cone.xml")]
    said = subprocess.run([host, library(), *examples], capture_output=True, text=True, check=True)
    page = PAGE.read_text(encoding="utf-8")
    # Another version of MuJoCo may have other digits of its own friction.
    assert all(line[: line.index("%")] in page for line in said.stdout.splitlines()[1:5])
    rows = [re.findall(r"[-+]?[\d.]+", line) for line in said.stdout.splitlines()[1:5]]
    assert [float(row[0]) for row in rows] == [0.0, 5.0, 12.5, 50.0]
    # Half a step of the first speed is 0.30 % of the shortest way.
    assert all(abs(float(row[2])) <= 0.31 for row in rows)
    assert said.stdout.splitlines()[5].startswith("time of a step")
