"""Wrong input says what is wrong and what would be valid."""

import unittest

import launch

START = """
plugin load ${plugin}
units lj
atom_style sphere
boundary f f f
region box block 0 4 0 4 0 4
create_box 2 box
create_atoms 1 single 1 1 1
create_atoms 2 single 2 1 1
set group all diameter 1.0 density 1.0
"""
LAW = "pair_style gran/tribos\npair_coeff * * hooke 100 sliding 0.5\n"
GHOSTS = "comm_modify vel yes\n"

CASES = [
    ("pair_style gran/tribos 3", "takes no arguments, but got '3'"),
    ("pair_style gran/tribos\npair_coeff * *", "is missing after 'the types or the fix style': hooke K or hertz E"),
    ("pair_style gran/tribos\npair_coeff * * hook 3", "unknown normal force 'hook': expected hooke K or hertz E"),
    ("pair_style gran/tribos\npair_coeff * * hooke -3", "'hooke -3': expected a positive number"),
    ("pair_style gran/tribos\npair_coeff * * hooke 3e", "'hooke 3e': expected a positive number"),
    ("pair_style gran/tribos\npair_coeff * * hooke 3 sliding nan", "'sliding nan': expected a number of 0 or more"),
    ("pair_style gran/tribos\npair_coeff * * hooke 3 sliding", "a number is missing after 'sliding'"),
    ("pair_style gran/tribos\npair_coeff * * hooke 3 coupling full", "unknown coupling 'full': expected exact, ellipsoid"),
    ("pair_style gran/tribos\npair_coeff * * hooke 3 friction 0.5", "unknown keyword 'friction': expected one of damping"),
    ("pair_style gran/tribos\npair_coeff * * hooke 3 cohesion 1", "a number is missing after 'cohesion F'"),
    ("pair_style gran/tribos\npair_coeff * * hooke 3 torsion 0.1", "needs a sliding threshold"),
    ("pair_style gran/tribos\npair_coeff 1 1 hooke 3\npair_coeff 2 2 hooke 4\n" + GHOSTS + "run 0",
     "no pair_coeff for types 1 2"),
    (LAW + "run 0", "use 'comm_modify vel yes'"),
    (LAW + "fix w all wall/gran/tribos hooke 3", "no wall; give one of xlo"),
    (LAW + "fix w all wall/gran/tribos hooke 3 zlo", "the position of wall zlo is missing: a number or EDGE"),
    (LAW + "fix w all wall/gran/tribos hooke 3 zlo low", "'zlo low': expected a finite number"),
    (LAW + "fix w all wall/gran/tribos hooke 3 zlo 0 zlo 1", "wall zlo is given twice"),
    (LAW + "fix w all wall/gran/tribos hooke 3 zlo 0 speed 1", "unknown option 'speed' of wall zlo"),
    (LAW + "fix w all wall/gran/tribos hooke 3 zhi 4 piston 1 0", "the mass must be positive"),
    (LAW + "fix w all wall/gran/tribos hooke 3 zhi EDGE piston 1 1", "cannot move and stay at the EDGE"),
    (LAW + "fix w all wall/gran/tribos hooke 3 region", "the ID after 'region' is missing"),
    (LAW + "fix w all wall/gran/tribos hooke 3 region slope", "there is no region slope"),
    (LAW + "variable r equal 1+time\nregion b sphere 1 1 1 v_r\nfix w all wall/gran/tribos hooke 3 region b",
     "region b changes its shape"),
    (LAW + "fix w all wall/gran/tribos hooke 3 zlo 0 velocity 0 0 v_lift", "there is no equal-style variable lift"),
    (LAW + "fix w all TRIBOS/HISTORY 3", "is made by pair style gran/tribos"),
    ("pair_style hybrid gran/tribos gran/tribos", "There can be one pair style gran/tribos only"),
]
PERIODIC = START.replace("boundary f f f", "boundary f f p") + LAW + GHOSTS + "fix w all wall/gran/tribos hooke 3 zlo 0\nrun 0\n"


class Errors(unittest.TestCase):
    def assert_says(self, script, message):
        said = launch.run(script, check=False)
        self.assertIn("ERROR", said, script)
        self.assertIn(message, said.replace("\n", " "), script)

    def test_wrong_words_are_refused_with_what_would_be_valid(self):
        for lines, message in CASES:
            with self.subTest(lines):
                self.assert_says(START + lines + "\n", message)

    def test_a_wall_across_a_periodic_axis_is_refused(self):
        self.assert_says(PERIODIC, "a wall across z, but the box is periodic there")

    def test_what_is_right_runs(self):
        launch.run(START + LAW + GHOSTS + "fix w all wall/gran/tribos hooke 3 zlo 0 velocity 1 0 0 zhi 4 piston 1 5\nrun 1\n")


if __name__ == "__main__":
    unittest.main()
