"""The plugin against the reference answers."""

import json
import os
import pathlib
import subprocess
import sys

from conftest import library

ANSWERS = pathlib.Path(__file__).parents[3] / "tests" / "answers"
# Largest relative errors at steps of 1 ms; half a step of the first speed is 0.3 % of the shortest way.
FACES = {
    "puck": 3e-3, "ring": 3e-3, "box": 3e-3, "plank": 3e-3, "bar": 3e-3, "tripod": 3e-3, "wheel": 1e-3, "spin_down": 3e-3, "turntable_slips": 5e-3,
}  # fmt: skip
# Largest creep, m/s.
HELD = {"incline_holds": 1e-6, "turntable_holds": 1e-6}


def test_faces_stop_where_they_should_and_hold(tmp_path):
    out = tmp_path / "results.json"
    words = [
        sys.executable,
        "-m",
        "friction_answers",
        "run",
        "mujoco_tribos",
        "--setting",
        "default",
        "--quick",
        "--items",
        *FACES,
        *HELD,
        "--out",
        out,
    ]
    found = os.environ | {"PYTHONPATH": str(ANSWERS), "TRIBOS_PATCH": str(library())}
    subprocess.run(words, check=True, env=found, cwd=tmp_path, capture_output=True)
    (run,) = json.loads(out.read_text(encoding="utf-8"))["runs"]
    assert run["cannot"] == {}
    for case in run["cases"]:
        rows = [
            row
            for row in case["rows"]
            if row["quantity"] not in ("stop_s", "distance_m" if case["item"] in HELD else "")
        ]
        assert rows
        for row in rows:
            assert row["error"] <= (FACES | HELD)[case["item"]], (case["item"], row)
