"""Springs that migrate between ranks and survive restart files."""

import pathlib
import tempfile
import unittest

import launch

# Two grains that stick together by cohesion, bent and twisted by their spins, fly through the box.
FLYING = """
plugin load ${plugin}
units si
atom_style sphere
comm_modify vel yes
newton ${newton}
processors * 1 1
boundary p p p
region box block -4 4 -2 2 -2 2
create_box 1 box
pair_style gran/tribos
pair_coeff * * hooke 100 damping 0.1 sliding 0.5 coupling exact torsion 0.5 torsion/spring inertia rolling 0.3 cohesion 1 0.01
create_atoms 1 single -0.3 0 -0.4
create_atoms 1 single 0.3 0 0.4
set group all diameter 1.0 density 1.909859317102744
velocity all set 4 0 0
set atom 1 omega 0.3 0.1 0.2
set atom 2 omega -0.1 0.3 0.4
timestep 0.002
neighbor 0.05 bin
neigh_modify delay 0 every 1
fix 1 all nve/sphere
dump d all custom ${steps} dump id xu yu zu omegax omegay omegaz
dump_modify d format float %.17g sort id
run ${steps}
"""

# A small packing under a piston, with walls, all modes and a restart.
START = """
plugin load ${plugin}
units si
atom_style sphere
atom_modify sort 0 0
comm_modify vel yes
newton on
boundary p f f
region box block 0 4 0 4 0 8
create_box 2 box
lattice sc 1.0
region fill block 0 4 0.5 3.5 0.5 6.2
create_atoms 1 region fill
set group all diameter 0.9 density 2.0
set type 1 type/fraction 2 0.5 1234
set type 2 diameter 1.0
velocity all create 1e22 87287 loop geom
pair_style gran/tribos
pair_coeff * * hertz 5e3 damping 0.2 sliding 0.5 rolling 0.1
"""
RUN = """
fix 1 all nve/sphere
fix g all gravity 1.0 vector 0.3 0 -1
fix w all wall/gran/tribos hertz 5e3 damping 0.2 sliding 0.5 rolling 0.1 ylo 0 yhi EDGE zlo 0 velocity 0.1 0 0 zhi 7 piston 20 10
timestep 0.001
neigh_modify delay 0 every 1
thermo 1000
thermo_style custom step ke f_w[4][1] f_w[4][2] f_w[4][5]
thermo_modify format float %.17g
"""
DUMP = """
dump d all custom 4000 {name} id x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz
dump_modify d format float %.17g sort id first no
"""
WHOLE = START + RUN + "restart 2000 part.*\n" + DUMP.format(name="whole") + "run 4000\n"
REST = "plugin load ${plugin}\nread_restart part.2000\ncomm_modify vel yes\n" + RUN + DUMP.format(name="rest") + "run 2000\n"


class Migration(unittest.TestCase):
    def test_a_strained_pair_flies_the_same_way_over_any_number_of_ranks(self):
        frames = {}
        for ranks, newton in ((1, "on"), (1, "off"), (2, "on"), (2, "off")):
            with tempfile.TemporaryDirectory() as folder:
                launch.run(FLYING, ranks=ranks, folder=folder, newton=newton, steps=3000)
                frame = launch.last_frame(folder + "/dump")
            frames[ranks, newton] = [float(word) for row in frame.values() for word in row]
        one = frames.pop((1, "on"))
        # It has crossed the box several times, turned and kept its springs: the two are still together.
        self.assertGreater(one[0], 20)
        self.assertLess(sum((a - b) ** 2 for a, b in zip(one[:3], one[6:9])) ** 0.5, 1.01)
        # Places across a periodic side round otherwise.
        for case, other in frames.items():
            self.assertLess(max(abs(a - b) for a, b in zip(one, other)), 1e-11, case)


class Restart(unittest.TestCase):
    def test_a_restarted_run_has_the_same_digits(self):
        for ranks in (1, 2) if launch.LONG else (1,):
            with tempfile.TemporaryDirectory() as folder:
                whole = launch.run(WHOLE, ranks=ranks, folder=folder)
                rest = launch.run(REST, ranks=ranks, folder=folder)
                folder = pathlib.Path(folder)
                frames = [launch.last_frame(folder / name) for name in ("whole", "rest")]
            self.assertEqual(launch.thermo(whole)[-1], launch.thermo(rest)[-1])
            self.assertEqual(frames[0], frames[1])
            # The piston has moved and bears the grains.
            step, _, place, _, push = launch.thermo(whole)[-1]
            self.assertEqual(step, 4000)
            self.assertLess(place, 6.9)
            self.assertGreater(push, 1)


class Ranks(unittest.TestCase):
    def test_a_packing_goes_on_the_same_way_on_other_numbers_of_ranks(self):
        short = REST.replace("run 2000", "run 60").replace("custom 4000", "custom 1")
        numbers = (1, 2, 4) if launch.LONG else (1, 2)
        frames = {}
        with tempfile.TemporaryDirectory() as folder:
            launch.run(WHOLE.replace("run 4000", "run 2000"), folder=folder)
            for ranks in numbers:
                launch.run(short, ranks=ranks, folder=folder)
                frames[ranks] = launch.last_frame(folder + "/rest")
        kinds = {"places": (0, 3), "velocities": (3, 6), "spins": (6, 9), "forces": (9, 12), "torques": (12, 15)}
        for kind, (first, end) in kinds.items():
            values = {ranks: [float(word) for row in frame.values() for word in row[first:end]]
                      for ranks, frame in frames.items()}
            largest = max(map(abs, values[1]))
            for ranks in numbers[1:]:
                off = max(abs(a - b) for a, b in zip(values[1], values[ranks])) / largest
                print(f"{kind} on {ranks} ranks differ from those on 1 by {off:.1e} of the largest after 60 steps")
                self.assertLess(off, 1e-11, (kind, ranks))


if __name__ == "__main__":
    unittest.main()
