"""Answers of all standard cases, and errors against them."""

import csv
import math

from .cases import DATA
from .units import UNITS

CREEPS = ("creep_m_s", "sink_m", "drift_m")
# Largest errors of the classes: relative ones, and for what should be nothing m/s or m.
CLASSES = (("exact", 1e-3, 1e-6), ("good", 1e-2, 1e-4), ("fair", 1e-1, 1e-2))


def answers():
    """item, case -> quantity -> value."""
    found = {}
    with open(DATA / "v1" / "answers.csv", newline="") as file:
        for row in csv.DictReader(file):
            if not row["quantity"].startswith(("margin", "torque")):
                found.setdefault((row["scene"], row["spin_rad_s"]), {})[row["quantity"]] = float(row["value"])
    with open(DATA / "v2" / "answers.csv", newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault((row["item"], row["case"]), {})[row["quantity"]] = float(row["value"])
    return found


def corners():
    """item, case -> quantity -> value that Coulomb's law at corners gives; see the adapter `corners`."""
    found = {}
    with open(DATA / "v2" / "corners.csv", newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault((row["item"], row["case"]), {})[row["quantity"]] = float(row["value"])
    return found


def error(exact, quantity, value):
    """Relative error; of lengths relative to the longest of the case, of what should be nothing its size."""
    if not math.isfinite(value):
        return math.inf
    if exact[quantity] == 0.0 and quantity in CREEPS:
        return abs(value)
    scale = abs(exact[quantity])
    if UNITS[quantity] == "m":
        scale = math.hypot(exact.get("along_m", 0.0), exact.get("left_m", 0.0)) or scale
    elif UNITS[quantity] in ("m/s", "rad/s"):
        scale = max(abs(exact[key]) for key in exact if UNITS[key] == UNITS[quantity])
    return abs(value - exact[quantity]) / scale if scale else abs(value)


def class_of(quantity, wrong):
    """Name of the class of an error."""
    at = 2 if quantity in CREEPS else 1
    return next((row[0] for row in CLASSES if wrong <= row[at]), "wrong")
