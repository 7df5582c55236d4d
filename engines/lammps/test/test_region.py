"""Walls that are surfaces of regions, and walls whose speed or load follows a variable."""

import math
import pathlib
import tempfile
import unittest

import launch

LAW = "hooke 1e4 damping 0.2 sliding 0.5 coupling exact rolling 0.1"
# A ball that slides, spins and rolls on a wall.
BALL = """
plugin load ${{plugin}}
units si
atom_style sphere
atom_modify map array
comm_modify vel yes
boundary f f f
region box block -10 10 -10 10 -10 10
create_box 1 box
create_atoms 1 single {place}
set group all diameter 1.0 density 2.0
velocity all set {velocity}
set group all omega {spin}
pair_style gran/tribos
pair_coeff * * hooke 1e4 damping 0.2 sliding 0.5
timestep 1e-4
fix move all nve/sphere
fix weight all gravity {gravity}
"""
WRITE = """
dump d all custom 10000000 {name} id x y z vx vy vz omegax omegay omegaz
dump_modify d format float %.17g sort id first no
run {steps}
write_dump all custom {name} id x y z vx vy vz omegax omegay omegaz modify format float %.17g
"""


def ball(walls, steps, place="0 0 0.5", velocity="1 0.3 0", spin="0.3 0.1 2", gravity="1.0 vector 0 0 -1", more=""):
    """Place, velocity and spin after so many steps, and what was printed."""
    script = BALL.format(place=place, velocity=velocity, spin=spin, gravity=gravity)
    with tempfile.TemporaryDirectory() as folder:
        said = launch.run(script + walls + more + WRITE.format(name="end", steps=steps), folder=folder)
        [row] = launch.last_frame(folder + "/end").values()
    return [float(word) for word in row], said


class Regions(unittest.TestCase):
    def assert_near(self, one, other, bound):
        self.assertLess(max(abs(a - b) for a, b in zip(one, other)), bound, (one, other))

    def test_a_face_of_a_region_is_the_plane(self):
        plane, _ = ball(f"fix w all wall/gran/tribos {LAW} zlo 0\n", 10000)
        for shape in ("block -20 20 -20 20 -20 0 side out", "block -20 20 -20 20 0 20", "plane 0 0 0 0 0 1",
                      "prism -20 20 -20 20 -20 0 0 5 0 side out"):
            region, _ = ball(f"region r {shape} units box\nfix w all wall/gran/tribos {LAW} region r\n", 10000)
            self.assert_near(plane, region, 1e-12)

    def test_a_ball_rests_in_a_turning_drum_whose_surface_it_follows(self):
        # Its surface moves with that of the drum: 1.5 rad/s * 2 = 6 rad/s * 0.5, and nothing slips.
        walls = ("variable angle equal 1.5*time\nregion drum cylinder y 0 0 2 INF INF side in units box "
                 f"rotate v_angle 0 0 0 0 1 0\nfix w all wall/gran/tribos {LAW.replace(' rolling 0.1', '')} region drum\n")
        end, _ = ball(walls, 20000, place="0 0 -1.5", velocity="0 0 0", spin="0 6 0")
        # The drum begins to turn with the second step.
        self.assert_near(end[:2] + end[3:6] + end[6:], [0, 0, 0, 0, 0, 0, 6, 0], 2e-3)
        still, _ = ball(walls.replace("1.5*time", "0*time"), 20000, place="0 0 -1.5", velocity="0 0 0", spin="0 6 0")
        self.assertGreater(abs(still[0]), 0.1)

    def test_a_ball_that_sticks_to_a_curved_wall_keeps_its_springs(self):
        # In a round trough it rolls to and fro without slipping: the angle obeys 7/5 (R - r) a'' = -g sin a.
        walls = ("region trough cylinder y 0 0 2 INF INF side in units box\n"
                 f"fix w all wall/gran/tribos hooke 1e5 damping 0.2 sliding 0.9 region trough\n")
        start, distance = 0.1, 1.5
        period = 2 * math.pi * math.sqrt(7 / 5 * distance / 1.0)
        place = f"{distance * math.sin(start)} 0 {-distance * math.cos(start)}"
        end, _ = ball(walls, round(period / 1e-4), place=place, velocity="0 0 0", spin="0 0 0")
        # The period of an amplitude of 0.1 is longer by 1/16 of its square.
        self.assertAlmostEqual(end[0] / (distance * math.sin(start)), 1, delta=0.01)
        self.assertLess(abs(end[3]), 0.02 * start * distance)

    def test_a_plate_ends_at_its_edge(self):
        # A ball on the end of a shelf falls off about its edge; one in the middle stays.
        for x, stays in ((-0.1, True), (0.1, False)):
            walls = f"region shelf block -5 0 -5 5 -0.001 0 side out units box\nfix w all wall/gran/tribos {LAW} region shelf\n"
            end, _ = ball(walls, 20000, place=f"{x} 0 0.5", velocity="0 0 0", spin="0 0 0")
            self.assertEqual(end[2] > 0.49, stays, end)

    def test_a_restarted_run_goes_on_in_the_drum(self):
        law = ("variable angle equal 1.5*time\nregion drum cylinder y 0 0 2 INF INF side in units box "
               "rotate v_angle 0 0 0 0 1 0\nvariable lift equal 0.02*time\n"
               f"fix w all wall/gran/tribos {LAW} region drum ylo -3 velocity 0 0 v_lift\n")
        place = dict(place="0.1 0 -1.5", velocity="0 -1 0", spin="0 0 1")
        fixes = "fix move all nve/sphere\nfix weight all gravity 1.0 vector 0 0 -1\n"
        with tempfile.TemporaryDirectory() as folder:
            script = BALL.format(gravity="1.0 vector 0 0 -1", **place)
            launch.run(script + law + "restart 20000 part.*\n" + WRITE.format(name="whole", steps=32000), folder=folder)
            rest = "plugin load ${plugin}\nread_restart part.20000\ncomm_modify vel yes\n" + fixes + law
            launch.run(rest + WRITE.format(name="rest", steps=12000), folder=folder)
            frames = [launch.last_frame(pathlib.Path(folder) / name)[1] for name in ("whole", "rest")]
        # The time of a restarted run, which the angle follows, rounds otherwise.
        whole, rest = ([float(word) for word in frame] for frame in frames)
        self.assert_near(whole, rest, 1e-11)
        self.assertLess(whole[1], -1)


class Variables(unittest.TestCase):
    def test_a_wall_follows_its_speed_and_a_piston_its_load(self):
        # z = A sin(w t), and F/M t^3/6 under a load that grows with time.
        walls = ("variable swing equal 0.2*3*cos(3*time)\nvariable push equal 5*time\n"
                 f"fix w all wall/gran/tribos {LAW} zlo -2 velocity 0.5 0 v_swing zhi 9 piston v_push 2\n"
                 "thermo 10000\nthermo_style custom step f_w[1][1] f_w[1][2] f_w[2][1] f_w[2][2]\n"
                 "thermo_modify format float %.12g\n")
        _, said = ball(walls, 10000, place="0 0 5", velocity="0 0 0", spin="0 0 0", gravity="0.0 vector 0 0 -1")
        _, place, speed, high, closing = launch.thermo(said)[-1]
        self.assertAlmostEqual(place, -2 + 0.2 * math.sin(3), delta=1e-7)
        self.assertAlmostEqual(speed, 0.6 * math.cos(3), delta=1e-12)
        self.assertAlmostEqual(high, 9 - 5 / 2 / 6, delta=2e-4)
        self.assertAlmostEqual(closing, -5 / 2 / 2, delta=4e-4)


if __name__ == "__main__":
    unittest.main()
