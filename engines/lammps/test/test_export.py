"""Powders and grains exported by `tribos export lammps` do in LAMMPS what they do in Tribos."""

import csv
import json
import math
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


# Some hundred grains on springs.
GRAINS = ["method=soft", "stiffness=2000", "restitution=0.5"]
NEEDS = unittest.skipUnless(
    TRIBOS.exists(), f"no {TRIBOS}: cargo build --release -p tribos-cli, or set TRIBOS_COMMAND")


def command(folder, *words):
    return subprocess.run([TRIBOS, *words], cwd=folder, check=True, capture_output=True, text=True).stdout


def exported(folder, scene, keys, ranks=1):
    """Columns of the series, the last frame and the data of a scene that LAMMPS runs."""
    sets = [word for key in [*GRAINS, *keys] for word in ("--set", key)]
    command(folder, "export", "lammps", scene, *sets, "--out", "theirs")
    folder = pathlib.Path(folder) / "theirs"
    launch.run(folder / "in.grains", ranks=ranks, folder=folder)
    lines = (folder / "series.txt").read_text().splitlines()
    names = [name.removeprefix("v_") for name in lines[1].split()[1:]]
    rows = [[float(word) for word in line.split()] for line in lines[2:]]
    series = {name: [row[at] for row in rows] for at, name in enumerate(names)}
    atoms = (folder / "grains.data").read_text().split("Atoms # sphere")[1].split("Velocities")[0]
    data = {int(row.split()[0]): row.split()[1:] for row in atoms.splitlines() if row}
    return series, launch.last_frame(folder / "end.dump"), data


def run_here(folder, scene, keys):
    sets = [word for key in [*GRAINS, *keys] for word in ("--set", key)]
    command(folder, "run", scene, *sets, "--out", "ours")
    return json.loads((pathlib.Path(folder) / "ours" / "summary.json").read_text())


def weight(data, kinds=("1",)):
    masses = [float(density) * math.pi / 6 * float(diameter) ** 3 for kind, diameter, density, *_ in data.values() if kind in kinds]
    return 9.81 * sum(masses)


def flow(times, below):
    """Rate and its standard error as `flow` of a summary has them: between a tenth and nine tenths of what flowed out."""
    begin = next(n for n, mass in enumerate(below) if mass > below[0] + 0.1 * (below[-1] - below[0]))
    end = next(n for n, mass in enumerate(below) if mass >= below[0] + 0.9 * (below[-1] - below[0]))
    at = [begin + part * (end - 1 - begin) // 8 for part in range(9)]
    rates = [(below[b] - below[a]) / (times[b] - times[a]) for a, b in zip(at, at[1:])]
    return (below[at[-1]] - below[at[0]]) / (times[at[-1]] - times[at[0]]), statistics.stdev(rates) / len(rates) ** 0.5


@NEEDS
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


@NEEDS
class ExportedGrains(unittest.TestCase):
    def test_a_hopper_flows_as_fast(self):
        keys = ["dimension=2", "count=300", "width=0.25", "orifice_width=0.07", "orifice_height=0.2", "duration=1.6", "sample_every=5"]
        with tempfile.TemporaryDirectory() as folder:
            sets = ["depth"]    # a plane has none
            keep = (launch.ROOT / "scenes" / "hopper.toml").read_text().splitlines()
            scene = pathlib.Path(folder) / "flat.toml"
            scene.write_text("\n".join(line for line in keep if line.split("=")[0].strip() not in sets))
            ours = run_here(folder, scene, keys)["flow"]
            series, end, data = exported(folder, scene, keys)
        rate, error = flow(series["time"], series["discharged"])
        print(f"hopper: {ours['rate']:.4g} ± {ours['error']:.2g} kg/s here, {rate:.4g} ± {error:.2g} in LAMMPS")
        self.assertLess(abs(rate - ours["rate"]), 2 * math.hypot(error, ours["error"]))
        # Nothing flows before the slot opens, and what has gone lies on the floor.
        shut = [mass for time, mass in zip(series["time"], series["discharged"]) if time < 0.5]
        self.assertEqual(max(shut), 0)
        self.assertGreater(series["discharged"][-1], 0.9 * weight(data) / 9.81)
        # The plane stays one, to the bit.
        self.assertEqual({float(row[4]) for row in end.values()}, {0})

    def test_a_settled_bed_on_glued_grains_weighs_what_it_weighs(self):
        keys = ["boundary_x=periodic", "boundary_y=periodic", "side_wall_speed_z=0", "count=150", "rough_floor=0.005",
                "duration=1.2"]
        with tempfile.TemporaryDirectory() as folder:
            ours = run_here(folder, "column", keys)
            series, end, data = exported(folder, "column", keys, ranks=2)
        bears = series["floor_force"][-1]
        self.assertAlmostEqual(bears / weight(data), 1, delta=2e-3)
        self.assertAlmostEqual(ours["floor_force"] / weight(data), 1, delta=2e-3)
        # The floor stays where it was, to the bit, and bears a part of the grains.
        glued = [tag for tag, row in data.items() if row[0] == "7"]
        self.assertGreater(len(glued), 30)
        for tag in glued:
            self.assertEqual([float(word) for word in end[tag][3:6]], [float(word) for word in data[tag][3:6]])
            self.assertEqual({float(word) for word in end[tag][6:]}, {0})

    def test_an_intruder_goes_its_way_and_a_piston_bears_its_stress(self):
        keys = ["boundary_z=walls", "wall_stress_z=200", "count=100", "intruder_radius=0.008",
                "intruder_position=0.03,0.03,0.012", "driven_velocity_z=0.8:0,0.9:0.05", "side_wall_speed_z=0", "duration=1.2",
                "sample_every=5"]
        with tempfile.TemporaryDirectory() as folder:
            run_here(folder, "column", keys)
            with open(pathlib.Path(folder) / "ours" / "series.csv") as lines:
                ours = [{name: float(word) for name, word in row.items()} for row in csv.DictReader(lines)]
            series, end, data = exported(folder, "column", keys)
        theirs = [dict(zip(series, row)) for row in zip(*series.values())]
        [intruder] = [end[tag] for tag, row in data.items() if row[0] == "8"]
        # 0.05 m/s from 0.9 s on, and half of that for the 0.1 s before.
        self.assertAlmostEqual(float(intruder[5]), 0.012 + 0.05 * 0.35, delta=1e-5)
        self.assertEqual([float(word) for word in intruder[3:5]], [0.03, 0.03])

        def mean(rows, column, times):
            return statistics.mean(row[column] for row in rows if times[0] < row["time"] < times[1])

        for who, rows in (("here", ours), ("in LAMMPS", theirs)):
            plate, pull = mean(rows, "plate_force", (0.5, 0.8)), mean(rows, "driven_force_z", (0.9, 1.2))
            print(f"plate {plate:.3g} N, intruder {pull:.3g} N {who}")
            # The plate bobs on the bed.
            self.assertAlmostEqual(plate / (200 * 0.06**2), 1, delta=0.2)
            self.assertLess(pull, -0.3)

    def test_a_drum_carries_its_grains_up(self):
        with tempfile.TemporaryDirectory() as folder:
            series, end, data = exported(folder, "drum", ["duration=1.5", "count=60"])
        places = [[float(word) for word in row[3:6]] for row in end.values()]
        # About y the lowest side moves towards small x, and the bed lies there.
        self.assertLess(statistics.mean(x for x, _, _ in places), 0.095)
        self.assertLess(max(math.hypot(x - 0.1, z - 0.1) for x, _, z in places), 0.1)


if __name__ == "__main__":
    unittest.main()
