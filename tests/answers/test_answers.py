#!/usr/bin/env python3
"""The answers against brute force, the package's commands, its adapters as far as they need no engine.

python3 tests/answers/test_answers.py     # needs Python alone; LONG=1 draws ten cases an item
"""

import contextlib
import csv
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from brute import BRUTE  # noqa: E402
from friction_answers import __main__ as command  # noqa: E402
from friction_answers.answers import ANSWERS, DOUBLE  # noqa: E402
from friction_answers.cases import drawn, standard  # noqa: E402
from friction_answers.items import ITEMS  # noqa: E402
from friction_answers.table import answers, error  # noqa: E402

SEEDS = range(10 if os.environ.get("LONG") else 1)
# Of the grids and steps of brute force.
TOLERANCE = 4e-3


def said(*words):
    """What the command prints."""
    out = io.StringIO()
    with mock.patch.object(sys, "argv", ["friction-answers", *words]), contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
        command.main()
    return out.getvalue()


class Answers(unittest.TestCase):
    def test_random_cases_agree_with_brute_force(self):
        worst = {}
        for item in ANSWERS:
            for seed in SEEDS:
                case = drawn(item, seed)
                exact = {key: float(value) for key, value in ANSWERS[item](case, DOUBLE).items()}
                found = BRUTE[item](case)
                for quantity in exact:
                    off = error(exact, quantity, found[quantity])
                    worst[item] = max(worst.get(item, 0.0), off)
                    with self.subTest(item=item, seed=seed, quantity=quantity):
                        self.assertLess(off, TOLERANCE)
        if os.environ.get("LONG"):
            print(*(f"{item}: {off:.1e}" for item, off in worst.items()), sep="\n")

    def test_the_table_holds_what_doubles_compute(self):
        known = answers()
        for item in ANSWERS:
            for name, case in standard()[item].items():
                for quantity, value in ANSWERS[item](case, DOUBLE).items():
                    if quantity in known[item, name]:
                        with self.subTest(item=item, case=name, quantity=quantity):
                            self.assertLess(error(known[item, name], quantity, float(value)), 1e-9)

    def test_second_routes_agree_to_eleven_digits(self):
        with open(HERE / "v2" / "answers.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(len(rows), 60)
        for row in rows:
            with self.subTest(**row):
                self.assertLess(float(row["second"]), 2e-11)

    def test_the_problems_are_those_of_the_file(self):
        problems = json.loads((HERE / "v2" / "problems.json").read_text())
        for item, cases in problems.items():
            self.assertEqual(cases, standard()[item], item)

    def test_every_case_has_its_answers(self):
        known = answers()
        for item in ITEMS:
            for name in standard()[item]:
                self.assertIn((item, name), known)


# Bodies that nothing stops, at the speeds that they are given.
ICE = """
#include "engine.h"
#include <stdlib.h>
struct world { double state[13], dt; };
const char *fa_about(void) {
    return "{\\"name\\": \\"ice\\", \\"version\\": \\"1\\", \\"licence\\": \\"MIT\\", \\"kind\\": \\"games\\", \\"settings\\": {\\"default\\": {\\"dt\\": 0.01}}}";
}
void *fa_make(const fa_scene *scene, const char **why) {
    if (scene->torsion > 0) { *why = "Ice resists no spin."; return NULL; }
    struct world *made = calloc(1, sizeof *made);
    made->dt = scene->dt, made->state[3] = 1, made->state[2] = scene->bodies[0].place[2];
    return made;
}
void fa_drop(void *at) { free(at); }
void fa_set(void *at, int body, const double v[3], const double w[3]) {
    for (int i = 0; i < 3; ++i) ((struct world *)at)->state[7 + i] = v[i], ((struct world *)at)->state[10 + i] = w[i];
}
void fa_step(void *at) { for (int i = 0; i < 3; ++i) ((struct world *)at)->state[i] += ((struct world *)at)->state[7 + i] * ((struct world *)at)->dt; }
void fa_state(void *at, int body, double state[13]) { for (int i = 0; i < 13; ++i) state[i] = ((struct world *)at)->state[i]; }
void fa_gravity(void *at, const double gravity[3]) {}
void fa_force(void *at, int body, const double force[3]) {}
"""

# The same as a class.
ICE_CLASS = """
#include "engine.h"
struct Ice {
    std::array<double, 13> now{};
    double dt;
    Ice(const fa_scene &scene) : dt(scene.dt) { now[2] = scene.bodies[0].place[2], now[3] = 1; }
    void set(int, const double v[3], const double w[3]) { std::copy(v, v + 3, &now[7]), std::copy(w, w + 3, &now[10]); }
    void step() { for (int i = 0; i < 3; ++i) now[i] += now[7 + i] * dt; }
    std::array<double, 13> state(int) { return now; }
    void gravity(const double *) {}
    void force(int, const double *) {}
};
FA_ENGINE(Ice, R"({"name": "ice", "version": "1", "licence": "MIT", "kind": "games", "settings": {"default": {"dt": 0.01}}})", fa_lacks)
"""

# In Python, with a fault where a box is made.
ICE_THAT_FAILS = """
NAME, VERSION, LICENCE, KIND, SETTINGS = "ice", "1", "MIT", "games", {"default": {"dt": 0.05}}
class Simulator:
    def __init__(self, scene, setting, dt):
        if scene.bodies[0].shape.kind == "box": FAULT
    def set(self, body, velocity, spin): pass
    def step(self): pass
    def state(self, body): return (0, 0, 0), (1, 0, 0, 0), (0, 0, 0), (0, 0, 0)
"""


class Commands(unittest.TestCase):
    def test_an_engine_of_corners_turns_too_little(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "corners.json"
            said("run", "corners", "--items", "box", "wheel", "ball", "--quick", "--out", str(file))
            results = json.loads(file.read_text())
            page = Path(folder) / "page"
            said("page", str(file), "--out", str(page))
            self.assertEqual(sorted(path.name for path in page.iterdir()), ["engines.csv", "engines.md", "engines.svg"])
            with self.assertRaisesRegex(SystemExit, "results of corners and corners are both of Coulomb at corners, fine steps"):
                said("page", str(file), str(file), "--out", str(page))
        (run,) = results["runs"]
        found = {(case["item"], row["quantity"]): row for case in run["cases"] for row in case["rows"]}
        # Two points at the ends have twice the torque of the line between them.
        wheel = found["wheel", "turn_rad"]
        self.assertAlmostEqual(wheel["value"] / wheel["exact"], 0.5, delta=1e-3)
        self.assertEqual(found["box", "turn_rad"]["class"], "wrong")
        self.assertIn("ball", run["cannot"])

    def test_an_adapter_of_ones_own_runs_from_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            own = Path(folder) / "my_engine.py"
            corners = (HERE / "friction_answers" / "adapters" / "corners.py").read_text()
            own.write_text(corners.replace("from ..scene", "from friction_answers.scene"))
            self.assertIn("corners alone 50 %", said("run", str(own), "--items", "wheel"))
            own.write_text((HERE / "friction_answers" / "adapters" / "template.py").read_text())
            with self.assertRaisesRegex(SystemExit, "template|my_engine"):
                said("run", str(own), "--quick")

    @unittest.skipUnless(shutil.which("cc") and shutil.which("c++"), "needs cc and c++")
    def test_an_engine_in_c_runs_from_its_library(self):
        with tempfile.TemporaryDirectory() as folder:
            for compiler, text, reason in (("cc", ICE, "Ice resists no spin."), ("c++", ICE_CLASS, "Contacts have no torsional friction.")):
                source, library = Path(folder) / f"ice.{'cpp' if compiler == 'c++' else 'c'}", Path(folder) / f"{compiler}.so"
                source.write_text(text)
                subprocess.run([compiler, "-shared", "-fPIC", "-Wall", "-Werror", f"-I{HERE / 'friction_answers'}", source, "-o", library], check=True)
                text = said("run", str(library), "--items", "ball", "torsion")
                self.assertRegex(text, r"20 rolling_speed_m_s +1 ")
                self.assertIn(f"cannot: {reason}", text)
            with self.assertRaisesRegex(SystemExit, "the error of default is 12.9 %, more than 5 %"):
                said("run", str(library), "--items", "ball", "--case", "20", "--at-most", "5")
            source.with_suffix(".dll").write_text("no library")
            with self.assertRaisesRegex(SystemExit, "has not the functions of engine.h"):
                said("run", str(source.with_suffix(".dll")))
            with self.assertRaisesRegex(SystemExit, "no engine .*, compiled where it must be"):
                said("run", str(source.resolve()))
            with self.assertRaisesRegex(SystemExit, "there is no case 99, but 0, 5"):
                said("run", str(library), "--items", "box", "--case", "99")

    def test_a_case_that_ends_its_process_twice_is_left_out(self):
        with tempfile.TemporaryDirectory() as folder:
            own, file = Path(folder) / "own.py", Path(folder) / "own.json"
            for fault in ("__import__('os').abort()", "__import__('time').sleep(99)"):
                file.unlink(missing_ok=True)
                own.write_text(ICE_THAT_FAILS.replace("FAULT", fault))
                words = [sys.executable, "-m", "friction_answers", "run", own, "--items", "wheel", "box", "--quick", "--limit", "3", "--resume", "--out", file]
                codes = [subprocess.run(words, cwd=HERE, capture_output=True).returncode for _ in range(3)]
                self.assertEqual([code != 0 for code in codes], [True, True, False], fault)
                (run,) = json.loads(file.read_text())["runs"]
                self.assertEqual(run["cannot"], {"box 50": "fails: ends the process, by a crash or after 3 s"})
                self.assertEqual([(case["item"], len(case["rows"]) > 0) for case in run["cases"]], [("wheel", True), ("box", False)])
                # Another build is not what was played.
                own.write_text(own.read_text() + "\n")
                again = subprocess.run(words, cwd=HERE, capture_output=True, text=True)
                self.assertIn("the earlier results are of another build of this engine", again.stderr)

    def test_tables_of_both_versions_are_compared(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "results.csv"
            file.write_text("scene,spin_rad_s,quantity,value\\npuck,50,turn_rad,11.2\\n".replace("\\n", "\n"))
            self.assertIn("58.6 %", said("compare", str(file)))
            file.write_text("item,case,quantity,value\nwheel,10,turn_rad,0.6442\n")
            self.assertIn("50 %", said("compare", str(file)))
            file.write_text("item,case,quantity,value\nsled,10,turn_rad,0.6442\n")
            with self.assertRaises(SystemExit):
                said("compare", str(file))

    def test_random_cases_are_those_of_the_seed(self):
        once, again, other = (said("variants", "--seed", seed, "--items", "box") for seed in ("7", "7", "8"))
        self.assertEqual(once, again)
        self.assertNotEqual(once, other)

    def test_the_list_has_every_item(self):
        text = said("list")
        for item in ITEMS:
            self.assertIn(item, text)


class Adapters(unittest.TestCase):
    def test_each_is_small(self):
        for path in (HERE / "friction_answers" / "adapters").iterdir():
            with self.subTest(path=path.name):
                lines = path.read_text().splitlines() if path.is_file() else []
                # In C++ without includes and comments.
                code = [line for line in lines if line.strip() and not line.strip().startswith(("//", "#include"))]
                self.assertLessEqual(len(code), 80)
                self.assertLessEqual(max(map(len, code), default=0), 160)


if __name__ == "__main__":
    unittest.main()
