"""The plugin before the benchmark of friction, where spheres are all of the problem."""

import os
import pathlib
import sys
import unittest

import launch

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "tests" / "answers"))
# Largest errors: of rolling, of a twist, and of collisions, which critical dashpots cannot end without a rebound.
LARGEST = {"ball": 2e-3, "back_spin": 2e-3, "torsion": 1e-3, "collide": 0.1}
SETTINGS = {"gran/tribos": LARGEST, "gran/tribos, strong dashpots": LARGEST | {"collide": 2e-3}}


class Answers(unittest.TestCase):
    def test_spheres_roll_and_twist_as_they_should(self):
        os.environ["TRIBOS_LAMMPS_PLUGIN"] = str(launch.plugin())
        from friction_answers.run import run

        results = run("lammps", list(SETTINGS), list(LARGEST))
        self.assertEqual([one["setting"] for one in results["runs"]], list(SETTINGS))
        for one in results["runs"]:
            self.assertEqual({case["item"] for case in one["cases"]}, set(LARGEST))
            for case in one["cases"]:
                for row in case["rows"]:
                    if row["quantity"] not in ("stop_s", "slide_s"):
                        with self.subTest(setting=one["setting"], item=case["item"], case=case["case"], **row):
                            self.assertLess(row["error"], SETTINGS[one["setting"]][case["item"]])


if __name__ == "__main__":
    unittest.main()
