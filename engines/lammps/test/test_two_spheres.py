"""Two spheres, and a sphere on a wall, that slide and spin steadily under 600 N."""

import math
import subprocess
import tempfile
import unittest

import friction
import launch

# The centres rest; the spheres spin about y, which makes them slide along x, and in opposite senses about the normal.
# They are so heavy that nothing slows down.
SPHERES = """
plugin load ${plugin}
units si
atom_style sphere
comm_modify vel yes
newton ${newton}
boundary f f f
region box block -1 1 -1 1 -1 1
create_box 1 box
pair_style gran/tribos
pair_coeff * * ${law} sliding 0.3 coupling ${coupling}
create_atoms 1 single 0 0 $(-0.5+0.5*v_overlap)
create_atoms 1 single 0 0 $(0.5-0.5*v_overlap)
set group all diameter 1.0 density 1e15
set atom 1 omega 0 ${roll} ${spin}
set atom 2 omega 0 ${roll} $(-v_spin)
timestep 1e-7
fix 1 all nve/sphere
dump d all custom 5000 dump id fx fy fz tqx tqy tqz
dump_modify d format float %.17g sort id
run 5000
"""

WALL = """
plugin load ${plugin}
units si
atom_style sphere
comm_modify vel yes
newton ${newton}
boundary f f f
region box block -1 1 -1 1 -1 1
create_box 1 box
pair_style gran/tribos
pair_coeff * * hooke 1e7
create_atoms 1 single 0 0 $(0.5-v_overlap)
set group all diameter 1.0 density 1e15
set atom 1 omega 0 0 ${spin}
timestep 1e-7
fix 1 all nve/sphere
fix w all wall/gran/tribos hooke 1e7 sliding 0.3 coupling ${coupling} zlo 0 velocity ${speed} 0 0
dump d all custom 5000 dump id fx fy fz tqx tqy tqz
dump_modify d format float %.17g sort id
run 5000
"""

MU, LOAD, STIFFNESS = 0.3, 600.0, 1e7
R_EFF = 0.25
OVERLAP = LOAD / STIFFNESS
EXPECTED = {
    "exact": friction.by_kernel,
    "ellipsoid": friction.by_ellipsoid,
    "separate": friction.by_separate_limits,
}
# Rim speed over sliding speed.
RATIOS = [0.0, 0.3, 0.8, 1.5, 6.0]


def forces(script, **variables):
    """Forces and torques on all atoms, as numbers, and as they are written."""
    with tempfile.TemporaryDirectory() as folder:
        launch.run(script, folder=folder, **variables)
        frame = launch.last_frame(folder + "/dump")
    return {atom: [float(word) for word in row] for atom, row in frame.items()}, frame


class SteadySliding(unittest.TestCase):
    def between_spheres(self, ratio, coupling="exact", law="hooke 1e7", overlap=OVERLAP, **variables):
        """Force and torque on the second sphere, what is expected of its motion, and the digits."""
        lever = 0.5 - 0.5 * overlap
        roll = 5.0
        # Surfaces: second against first.
        speed = -2 * lever * roll
        radius = math.sqrt(R_EFF * overlap)
        spin = ratio * abs(speed) / radius
        found, digits = forces(SPHERES, law=law, overlap=overlap, coupling=coupling, roll=roll, spin=-spin / 2,
                               **{"newton": "on", **variables})
        fx, fy, fz, _, _, torque = found[2]
        self.assertLess(abs(fz - LOAD), 1e-8 * LOAD)
        self.assertEqual(fy, 0)
        return (fx, torque), (MU, radius, fz, speed, spin), digits

    def assert_near(self, found, expected, motion):
        _, radius, load, _, _ = motion
        self.assertLess(abs(found[0] - expected[0]), 1e-8 * MU * load, (found, expected))
        self.assertLess(abs(found[1] - expected[1]), 1e-8 * MU * load * radius, (found, expected))

    def test_friction_is_that_of_the_kernel_on_any_number_of_ranks_to_the_same_digits(self):
        for ratio in RATIOS:
            found, motion, digits = self.between_spheres(ratio)
            self.assert_near(found, friction.by_kernel(*motion), motion)
            others = [(1, "off")]
            if launch.LONG:
                others += [(2, "on"), (2, "off")]
            if ratio == 0.8:
                others += [(4, "on"), (4, "off")] if launch.LONG else [(2, "on")]
            for ranks, newton in others:
                _, _, same = self.between_spheres(ratio, ranks=ranks, newton=newton)
                self.assertEqual(digits, same, (ranks, newton))

    def test_friction_is_the_integral_over_the_disk(self):
        for ratio in (0.3, 0.8):
            found, motion, _ = self.between_spheres(ratio)
            self.assert_near(found, friction.by_quadrature(*motion), motion)

    def test_the_other_couplings_follow_their_own_sets(self):
        for coupling in ("ellipsoid", "separate"):
            for ratio in RATIOS[1:]:
                found, motion, _ = self.between_spheres(ratio, coupling=coupling)
                self.assert_near(found, EXPECTED[coupling](*motion), motion)

    def test_the_projection_on_the_ellipsoid_is_that_of_the_kernel(self):
        program = launch.kernel("ellipse_distance.cpp")
        off = float(subprocess.run([program], check=True, capture_output=True, text=True).stdout)
        print(f"the nearest points of an ellipse differ by {off:.1e} from those of the kernel")
        self.assertLess(off, 1e-13)

    def test_hertz_spheres_slide_as_hooke_spheres_under_the_same_load(self):
        # The same overlap carries 600 N: E = 3/4 F/(sqrt(r_eff) overlap^1.5).
        modulus = 0.75 * LOAD / (math.sqrt(R_EFF) * OVERLAP**1.5)
        found, motion, _ = self.between_spheres(0.8, law=f"hertz {modulus!r}")
        self.assert_near(found, friction.by_kernel(*motion), motion)

    def test_cohesion_adds_to_the_load_of_the_thresholds(self):
        # A pull of 300 N and an overlap that pushes with 900 N: 600 N in all, thresholds of 900 N.
        overlap = 900 / STIFFNESS
        found, motion, _ = self.between_spheres(0.8, law="hooke 1e7 cohesion 300 0", overlap=overlap)
        mu, radius, _, speed, spin = motion
        self.assert_near(found, friction.by_kernel(mu, radius, 900.0, speed, spin), motion)

    def test_a_given_torsion_threshold_is_that_of_a_disk_of_constant_radius(self):
        # mu_n P r_eff = 2/3 mu P a
        mu_torsion = 0.002
        found, motion, _ = self.between_spheres(0.8, law=f"hooke 1e7 torsion {mu_torsion}")
        mu, _, load, speed, spin = motion
        radius = mu_torsion * R_EFF / (2 / 3 * mu)
        self.assert_near(found, friction.by_kernel(mu, radius, load, speed, spin), motion)

    def test_a_sphere_on_a_wall(self):
        for ratio in RATIOS:
            speed, radius = 5.0, math.sqrt(0.5 * OVERLAP)
            spin = ratio * speed / radius
            case = dict(newton="on", coupling="exact", overlap=OVERLAP, speed=speed, spin=spin)
            found, digits = forces(WALL, **case)
            if launch.LONG or ratio == 0.8:
                self.assertEqual(digits, forces(WALL, ranks=2, **case)[1])
            fx, fy, fz, _, _, torque = found[1]
            # The first body is the sphere, and the wall moves against it. The plane of the contact turns with the mean
            # spin of both, and the spring lags by this angle where it slips over this length; errors are of second order.
            slip = MU * LOAD / (2 / 7 * STIFFNESS)
            lag = 0.5 * abs(spin) * slip / speed
            self.assertLess(abs(fy), lag * MU * fz + 1e-8)
            expected = friction.by_kernel(MU, radius, fz, -speed, spin)
            tolerance = (1e-8 + lag**2) * MU * fz
            self.assertLess(abs(fx - expected[0]), tolerance)
            self.assertLess(abs(torque - expected[1]), tolerance * radius)


if __name__ == "__main__":
    unittest.main()
