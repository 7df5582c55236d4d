"""Runs an engine through the problems."""

import importlib
import math
import os
import platform
import sys
import time

from .answers import ANSWERS, DOUBLE
from .cases import drawn, standard
from .items import ITEMS
from .scene import Unsupported
from .table import answers, class_of, error

COST = ("puck", "25")


def adapter(name):
    """The module of an engine: one of the package's, or a path to one's own."""
    if name.endswith(".py"):
        spec = importlib.util.spec_from_file_location("friction_answers.adapters.own", name)
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module
        spec.loader.exec_module(module)
        return module
    return importlib.import_module(f"friction_answers.adapters.{name}")


def cases_of(item, seed):
    """Case name -> parameters and answers: the standard ones, or one drawn by a seed."""
    if seed is not None:
        if item not in ANSWERS:
            return {}
        case = drawn(item, seed)
        return {f"seed {seed}": (case, ANSWERS[item](case, DOUBLE))}
    exact = answers()
    return {name: (case, exact[item, name]) for name, case in standard()[item].items()}


def rest_time(case, exact):
    """About how long the case lasts."""
    if "seconds" in case:
        return case["seconds"]
    if "slide_s" in exact:
        return exact["slide_s"]
    if "stop_s" in exact:
        return exact["stop_s"]
    # Two bodies, or two coefficients: until the slowest friction has stopped everything.
    return case.get("speed", 1.0) / (min(case["mu"], case.get("mu_across", case["mu"])) * case.get("g", 9.81))


def play(engine, setting, item, case, exact):
    """Rows of a case, and the processor time per simulated second."""
    options = engine.SETTINGS[setting]
    scene = item.scene(case)
    sim = Timed(engine.Simulator(scene, options, options["dt"]), scene)
    got = item.measure(sim, options["dt"], case, rest_time(case, exact))
    rows = []
    for quantity, value in got.items():
        if quantity in exact:
            wrong = error(exact, quantity, value)
            rows.append({
                "quantity": quantity, "value": value, "exact": exact[quantity],
                "error": wrong if math.isfinite(wrong) else None, "class": class_of(quantity, wrong),
            })  # fmt: skip
    return rows, sim.seconds / (sim.steps * options["dt"])


class Timed:
    """A simulator whose steps are counted and timed, in seconds of the processor, and whose driven bodies are set anew before each."""

    def __init__(self, sim, scene):
        self.sim, self.scene, self.steps, self.seconds, self.driven = sim, scene, 0, 0.0, {}
        self.state = sim.state
        self.gravity, self.force = getattr(sim, "gravity", None), getattr(sim, "force", None)

    def set(self, body, velocity, spin):
        if self.scene.bodies[body].is_driven:
            self.driven[body] = velocity, spin
        self.sim.set(body, velocity, spin)

    def step(self):
        for body, motion in self.driven.items():
            self.sim.set(body, *motion)
        start = time.process_time()
        self.sim.step()
        self.seconds += time.process_time() - start
        self.steps += 1


def run(name, settings=(), items=(), seed=None, quick=False, told=lambda text: None):
    """Results of an engine, as JSON has them."""
    engine = adapter(name)
    results = {
        "engine": engine.NAME, "version": engine.VERSION, "licence": engine.LICENCE, "adapter": name, "seed": seed,
        "gpu": getattr(engine, "IS_FOR_GPUS", False),
        "machine": {"system": platform.platform(), "processor": processor(), "cores": os.cpu_count(), "python": platform.python_version()},
        "runs": [],
    }  # fmt: skip
    for setting in settings or engine.SETTINGS:
        runs = {"setting": setting, "options": engine.SETTINGS[setting], "cases": [], "cannot": {}}
        for item in (ITEMS[name] for name in items or ITEMS):
            cases = cases_of(item.name, seed)
            for case_name in list(cases)[-1:] if quick else cases:
                case, exact = cases[case_name]
                began = time.perf_counter()
                try:
                    rows, cost = play(engine, setting, item, case, exact)
                except Unsupported as reason:
                    runs["cannot"][item.name] = str(reason)
                    break
                except Exception as failure:  # An engine that stops is a result.
                    rows, cost = [], None
                    runs["cannot"][f"{item.name} {case_name}"] = f"fails: {first_sentence(failure)}"
                runs["cases"].append({"item": item.name, "mark": item.mark, "case": case_name, "rows": rows, "cost": cost})
                told(f"{engine.NAME}, {setting}: {item.name} {case_name}, {time.perf_counter() - began:.1f} s")
        results["runs"].append(runs)
    return results


def first_sentence(failure):
    return str(failure).strip().split("\n")[0].split(". ")[0][:120] or type(failure).__name__


def processor():
    try:
        with open("/proc/cpuinfo") as file:
            return next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor()
