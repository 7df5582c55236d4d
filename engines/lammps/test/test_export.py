"""Powders exported by `tribos export lammps` end at the porosity of Tribos' own soft particles."""

import json
import os
import pathlib
import statistics
import subprocess
import tempfile
import unittest

import launch

TRIBOS = pathlib.Path(os.environ.get("TRIBOS_COMMAND", launch.ROOT / "target" / "release" / "tribos"))
# Some 64 spheres under a piston.
SMALL = ["width=10", "height=30", "piston_mass=250"]


def command(folder, *words):
    subprocess.run([TRIBOS, *words], cwd=folder, check=True, capture_output=True)


@unittest.skipUnless(TRIBOS.exists(), f"no {TRIBOS}: cargo build --release -p tribos-cli, or set TRIBOS_COMMAND")
class ExportedPowder(unittest.TestCase):
    def test_the_porosity_is_within_the_scatter_of_seeds(self):
        ours, theirs = [], []
        for seed in (1, 2, 3):
            with tempfile.TemporaryDirectory() as folder:
                sets = [word for key in [*SMALL, f"seed={seed}"] for word in ("--set", key)]
                command(folder, "run", "compaction-soft", *sets, "--out", "ours")
                command(folder, "export", "lammps", "compaction-soft", *sets, "--out", "theirs")
                folder = pathlib.Path(folder)
                launch.run(folder / "theirs" / "in.powder", folder=folder / "theirs")
                summary = json.loads((folder / "ours" / "summary.json").read_text())
                ours.append(summary["porosity_final"])
                theirs.append(float((folder / "theirs" / "porosity.txt").read_text()))
        differences = [b - a for a, b in zip(ours, theirs)]
        print(f"porosity: ours {ours}, LAMMPS {theirs}")
        # The same deposits: pairs differ much less than seeds do.
        self.assertLess(max(map(abs, differences)), 0.5 * statistics.stdev(ours))


if __name__ == "__main__":
    unittest.main()
