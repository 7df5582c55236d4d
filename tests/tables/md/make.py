#!/usr/bin/env python3
"""Potential tables, inputs and LAMMPS results for the forces of atoms.

    python3 make.py [--lmp lmp]     (seconds; LAMMPS with EXTRA-PAIR and MANYBODY)

Reads *.data here; writes alloy500.data, synthetic.eam.alloy, synthetic.eam, in.NAME, NAME.csv and
totals.csv. Results have %.17g digits.
"""
import argparse
import math
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent

LJ = "pair_coeff * * 1.0 1.0"
BINARY = "pair_coeff 1 1 1.0 1.0 2.5\npair_coeff 2 2 0.5 0.88 2.5"
KOB_ANDERSEN = (
    "pair_coeff 1 1 1.0 1.0 2.5\npair_coeff 1 2 1.5 0.8 2.0\npair_coeff 2 2 0.5 0.88 2.2"
)
CUT = "pair_style lj/cut 2.5"
LINEAR = "pair_style lj/smooth/linear 2.5"
SHIFT = "\npair_modify shift yes"

# name: data file, units, boundary, lines of the potential.
CASES = {
    "fcc500_none": ("fcc500", "lj", "p p p", f"{CUT}\n{LJ}"),
    "fcc500_energy": ("fcc500", "lj", "p p p", f"{CUT}{SHIFT}\n{LJ}"),
    "fcc500_force": ("fcc500", "lj", "p p p", f"{LINEAR}\n{LJ}"),
    "slab576_none": ("slab576", "lj", "p p f", f"{CUT}\n{LJ}"),
    "slab576_force": ("slab576", "lj", "p p f", f"{LINEAR}\n{LJ}"),
    "binary500_geometric": (
        "binary500", "lj", "p p p", f"{CUT}\npair_modify mix geometric\n{BINARY}"),
    "binary500_arithmetic": (
        "binary500", "lj", "p p p", f"{CUT}\npair_modify mix arithmetic shift yes\n{BINARY}"),
    "binary500_sixthpower": (
        "binary500", "lj", "p p p", f"{LINEAR}\npair_modify mix sixthpower\n{BINARY}"),
    "binary500_kobandersen": ("binary500", "lj", "p p p", f"{CUT}{SHIFT}\n{KOB_ANDERSEN}"),
    "alloy500_setfl": (
        "alloy500", "metal", "p p p",
        "pair_style eam/alloy\npair_coeff * * synthetic.eam.alloy Aa Bb"),
    "alloy500_funcfl": (
        "alloy500", "metal", "p p p", "pair_style eam\npair_coeff * * synthetic.eam"),
}

TOTALS = ["pe", "ke", "press", "pxx", "pyy", "pzz", "pxy", "pxz", "pyz", "vol"]

CUTOFF = 4.5
KNOTS = 300
# Depth and width of the pair energy [eV, 1/A], decay of the density, cost of embedding [eV].
ELEMENTS = {"Aa": (0.35, 1.9, 4.0, 1.6), "Bb": (0.25, 1.6, 5.0, 1.1)}
NEAREST = 2.55
# Where the tables of F end: about the mean density of the atoms in setfl; beyond all of them in
# funcfl, since LAMMPS' energy has a jump of slope * drho behind the end of that.
DENSEST = {"setfl": 13.0, "funcfl": 40.0}


def taper(r):
    """From 1 to 0 over the last angstrom, smooth to the second derivative."""
    x = min(max(r - (CUTOFF - 1.0), 0.0), 1.0)
    return (1 - x) ** 3 * (1 + 3 * x + 6 * x * x)


def density(name, r):
    return math.exp(-ELEMENTS[name][2] * (r / NEAREST - 1)) * taper(r)


def pair_energy(a, b, r):
    depth = math.sqrt(ELEMENTS[a][0] * ELEMENTS[b][0])
    width = 0.5 * (ELEMENTS[a][1] + ELEMENTS[b][1])
    part = math.exp(-width * (r - NEAREST))
    return depth * (part * part - 2 * part) * taper(r)


def embedding(name, rho):
    return -ELEMENTS[name][3] * (math.sqrt(rho + 0.01) - 0.1)


def charge(r):
    return 6.0 * math.exp(-0.9 * r) * taper(r)


def table(values):
    values = [repr(float(value)) for value in values]
    return "".join(" ".join(values[k:k + 5]) + "\n" for k in range(0, len(values), 5))


def potentials():
    names = list(ELEMENTS)
    dr = CUTOFF / (KNOTS - 1)
    rs = [k * dr for k in range(KNOTS)]

    def densities(kind):
        drho = DENSEST[kind] / (KNOTS - 1)
        grids = f"{KNOTS} {drho!r} {KNOTS} {dr!r} {CUTOFF!r}\n"
        return [k * drho for k in range(KNOTS)], grids

    rhos, grids = densities("setfl")
    text = "Synthetic: formulas in make.py\nno real metal\n\n2 Aa Bb\n" + grids
    for number, name in enumerate(names, 101):
        text += f"{number} {60.0 + number} 3.6 fcc\n"
        text += table(embedding(name, rho) for rho in rhos)
        text += table(density(name, r) for r in rs)
    for i, a in enumerate(names):
        for b in names[:i + 1]:
            text += table(r * pair_energy(a, b, r) for r in rs)
    (HERE / "synthetic.eam.alloy").write_text(text)
    rhos, grids = densities("funcfl")
    text = "Synthetic: formulas in make.py\n101 161.0 3.6 fcc\n" + grids
    text += table(embedding("Aa", rho) for rho in rhos)
    text += table(charge(r) for r in rs) + table(density("Aa", r) for r in rs)
    (HERE / "synthetic.eam").write_text(text)


def alloy():
    """The places of fcc500.data at the size of a metal, every third atom of the second type."""
    lines = (HERE / "fcc500.data").read_text().split("Velocities")[0].splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith("Atoms")) + 2
    scale = 3.615 / 1.56
    length = repr(scale * 7.8)
    text = "alloy500.data\n\n500 atoms\n2 atom types\n\n"
    text += "".join(f"0.0 {length} {axis}lo {axis}hi\n" for axis in "xyz")
    text += "\nMasses\n\n1 161.0\n2 162.0\n\nAtoms # atomic\n\n"
    for line in lines[start:]:
        if line.strip():
            number, _, *place = line.split()
            kind = 2 if int(number) % 3 == 0 else 1
            text += f"{number} {kind} " + " ".join(repr(scale * float(x)) for x in place) + "\n"
    (HERE / "alloy500.data").write_text(text)


def script(data, units, boundary, potential):
    return f"""units {units}
atom_style atomic
boundary {boundary}
read_data {data}.data
{potential}
neighbor 0.5 bin
thermo_style custom step {' '.join(TOTALS)}
thermo_modify norm no format float %.17g
dump f all custom 1 ${{out}} id fx fy fz
dump_modify f sort id format float %.17g
run 0
"""


def run(lmp, name, case):
    (HERE / f"in.{name}").write_text(script(*case))
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "forces"
        command = [lmp, "-in", f"in.{name}", "-var", "out", str(out), "-log", "none"]
        log = subprocess.run(command, cwd=HERE, check=True, capture_output=True, text=True).stdout
        rows = out.read_text().split("ITEM: ATOMS id fx fy fz")[-1].split("\n")
    version = log.splitlines()[0]
    rows = [",".join(row.split()) for row in rows if row.strip()]
    text = f"# {version}, in.{name}\nid,fx,fy,fz\n" + "\n".join(rows) + "\n"
    (HERE / f"{name}.csv").write_text(text)
    lines = log.splitlines()
    head = next(k for k, line in enumerate(lines) if line.split()[:2] == ["Step", "PotEng"])
    return version, lines[head + 1].split()[1:]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--lmp", default="lmp")
    lmp = parser.parse_args().lmp
    potentials()
    alloy()
    rows = []
    for name, case in CASES.items():
        version, totals = run(lmp, name, case)
        rows.append(",".join([name, *totals]))
    header = ",".join(["name", *TOTALS])
    text = f"# {version}: totals of in.NAME, in its units\n{header}\n" + "\n".join(rows) + "\n"
    (HERE / "totals.csv").write_text(text)


main()
