"""Time of whole runs against LAMMPS' own pair granular with the same springs, dashpots and coefficients.

    python engines/lammps/test/bench.py [ROUNDS]

4,114 grains between periodic sides on a plane with friction, at rest and flowing down a slope of 22 degrees. The styles
run by turns; what is compared is processor time, not time on the clock.
"""

import pathlib
import resource
import statistics
import sys
import tempfile

import launch

STEPS = 1000
START = """
units lj
atom_style sphere
comm_modify vel yes
boundary p p f
variable k equal 2e4
variable c equal 2*0.2*sqrt(0.5*v_k)
"""
BOX = """
region box block 0 12 0 12 0 40
create_box 1 box
lattice sc 0.75
region fill block 0 12 0 12 1 34
create_atoms 1 region fill
set group all diameter 1.0
set group all density 1.909859317102744
velocity all create 1.0 87287 loop geom
"""
GRANULAR = "hooke $k $c tangential linear_history $(v_k*2/7) 0.2857142857142857 0.5 damping velocity twisting marshall"
STYLES = {
    "granular": f"pair_style granular\npair_coeff * * {GRANULAR}\n"
                f"fix wall all wall/gran granular {GRANULAR} zplane 0 NULL\n",
}
for coupling in ("exact", "ellipsoid", "separate"):
    law = f"hooke $k damping 0.2 sliding 0.5 coupling {coupling}"
    STYLES[coupling] = (f"plugin load ${{plugin}}\npair_style gran/tribos\npair_coeff * * {law}\n"
                        f"fix wall all wall/gran/tribos {law} zlo 0\n")
RUN = """
neighbor 0.2 bin
neigh_modify delay 0 every 1
timestep 0.001
fix move all nve/sphere
fix weight all gravity 1.0 chute {slope}
thermo 100000
run {steps}
"""


def seconds(script, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    launch.run(script, folder=folder)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    with tempfile.TemporaryDirectory() as folder:
        for slope in (0, 22):
            start = START + BOX + STYLES["granular"] + RUN.format(slope=slope, steps=15000)
            launch.run(start + "write_data start.data nocoeff\n", folder=folder)
            times = {style: [] for style in STYLES}
            for _ in range(rounds):
                for style, law in STYLES.items():
                    script = START + "read_data start.data\n" + law + RUN.format(slope=slope, steps=STEPS)
                    times[style].append(seconds(script, folder))
            print(f"slope {slope} degrees, {STEPS} steps: processor time, s (least, median), over granular (of both)")
            least, median = min(times["granular"]), statistics.median(times["granular"])
            for style, taken in times.items():
                own = min(taken), statistics.median(taken)
                print(f"  {style:10} {own[0]:6.2f} {own[1]:6.2f}   {own[0] / least:5.2f} {own[1] / median:5.2f}", flush=True)


if __name__ == "__main__":
    main()
