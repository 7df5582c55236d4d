"""Runs an engine through the problems."""

import faulthandler
import hashlib
import importlib
import importlib.util
import json
import math
import os
import platform
import sys
import time
import traceback
from pathlib import Path

from .answers import ANSWERS, DOUBLE
from .cases import drawn, standard
from .items import ITEMS
from .library import engine as library
from .page import KINDS
from .scene import Refused, Unsupported
from .table import answers, class_of, corners, error

OWN = (".py", ".so", ".dylib", ".dll")
LIMIT = 900.0  # of a case, s
CALLED = {"only": "choice of cases", "file": "build of this engine"}


def adapter(name):
    """The module of an engine: one of the package's, or a path to one's own."""
    if Path(name).suffix in OWN:
        if not Path(name).is_file():
            raise Refused(f"there is no file {name}")
        if Path(name).suffix != ".py":
            try:
                return library(str(Path(name).resolve()))
            except (OSError, AttributeError) as error:
                raise Refused(f'{name} has not the functions of engine.h (in C++, extern "C"), or is not linked with the engine: {error}') from error
        spec = importlib.util.spec_from_file_location("friction_answers.adapters.own", name)
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module
        spec.loader.exec_module(module)
        return module
    known = sorted(path.stem for path in (Path(__file__).parent / "adapters").glob("*.py") if path.stem not in ("__init__", "template"))
    if (Path(__file__).parent / "adapters" / f"{name}.cpp").is_file():
        raise Refused(f"{name} is built from its sources: `friction-answers all --engines {name}`, or run the library that adapters/CMakeLists.txt makes")
    if name not in known:
        raise Refused(f"no engine {name}; there are {', '.join(known)}, or a file of your own, compiled where it must be, that ends in {', '.join(OWN)}")
    try:
        return importlib.import_module(f"friction_answers.adapters.{name}")
    except ImportError as error:
        raise Refused(f"{name} is not installed here: {error}; `friction-answers all` installs it, or see its adapter's first line") from error


def check(name, engine):
    """Refuses an adapter that does not say what the page needs of it."""
    for said in ("NAME", "VERSION", "LICENCE", "KIND", "SETTINGS", "Simulator"):
        if not hasattr(engine, said):
            raise Refused(f"{name} has no {said}; adapters/template.py has all that an adapter says")
    if engine.KIND not in KINDS:
        raise Refused(f"{name} is of kind {engine.KIND!r}; there are {', '.join(KINDS)}")
    steps = [one.get("dt") for one in engine.SETTINGS.values()]
    if not steps or not all(isinstance(dt, int | float) and 0 < dt < math.inf for dt in steps):
        raise Refused(f"{name} must have one setting or more, each with dt, a number above 0, in s")


def digest(name):
    """Of one's own file, so that results of an earlier one are not taken for it."""
    return hashlib.sha256(Path(name).read_bytes()).hexdigest()[:16] if Path(name).suffix in OWN else None


def cases_of(item, seed, only):
    """Case name -> parameters and answers: the standard ones, all or but one, or one drawn by a seed."""
    if seed is not None:
        case = drawn(item, seed)
        return {f"seed {seed}": (case, ANSWERS[item](case, DOUBLE))}
    exact = answers()
    cases = {name: (case, exact[item, name]) for name, case in standard()[item].items()}
    last = list(cases)[-1]
    return {name: case for name, case in cases.items() if only in (None, name) or (only == "last" and name == last)}


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


def play(engine, setting, item, case, exact, points):
    """Rows of a case, and the processor time per simulated second."""
    options = engine.SETTINGS[setting]
    scene = item.scene(case)
    sim = Timed(engine.Simulator(scene, options, options["dt"]), scene)
    got = item.measure(sim, options["dt"], case, rest_time(case, exact))
    rows = []
    # A body that is nowhere has no time of rest either.
    is_lost = any(math.isnan(value) for quantity, value in got.items() if quantity != "stop_s")
    for quantity, value in got.items():
        if quantity in exact:
            wrong = math.inf if is_lost else error(exact, quantity, value)
            row = {"quantity": quantity, "value": value, "exact": exact[quantity], "class": class_of(quantity, wrong)}
            row["error"] = wrong if math.isfinite(wrong) else None
            if quantity in points:
                row["corners"] = error(exact, quantity, points[quantity])
            rows.append(row)
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


def run(name, settings=(), items=(), seed=None, only=None, told=lambda text, end="\n": None, kept=lambda results: None, earlier=None, limit=LIMIT):
    """Results of an engine, as JSON has them; `only` is the name of a case, or "last" for one of each item. `kept` gets them before and after each case.

    `earlier` are results of the same options to go on with; a case that ended their process twice is left out as failed. A case that takes longer than
    `limit`, in s, ends this process.
    """
    if not 0.0 < limit <= 1e6:
        raise Refused(f"a limit is above 0 and at most 1e6 s, not {limit:g} s")
    engine = adapter(name)
    check(name, engine)
    for setting in settings:
        if setting not in engine.SETTINGS:
            raise Refused(f"{name} has no setting {setting}; there are {', '.join(engine.SETTINGS)}")
    named = [case for item in items or ITEMS for case in standard()[item]]
    if only not in (None, "last", *named):
        raise Refused(f"there is no case {only}, but {', '.join(dict.fromkeys(named))}")
    about = {
        "engine": engine.NAME, "version": engine.VERSION, "licence": engine.LICENCE, "kind": engine.KIND, "adapter": Path(name).name, "file": digest(name),
        "seed": seed, "only": only,
    }  # fmt: skip
    machine = {"system": platform.platform(), "processor": processor(), "cores": os.cpu_count(), "python": platform.python_version()}
    results = (earlier or about | {"machine": machine, "runs": []}) | {"is_done": False}
    results.setdefault("stops", {})
    for key in about:
        if results.get(key) != about[key]:
            was, now = ("one of each problem" if found == "last" else found or "all" for found in (results.get(key), about[key]))
            raise Refused(f"the earlier results are of another {CALLED.get(key, key)}, {was}, not {now}: remove them or give another --out")
    try:
        for setting in settings or engine.SETTINGS:
            one = run_of(setting, engine.SETTINGS[setting], results["runs"])
            for item in (ITEMS[name] for name in items or ITEMS):
                try:
                    play_item(engine, one, item, cases_of(item.name, seed, only), results, limit, told, kept)
                except Unsupported as reason:
                    one["cannot"][item.name] = str(reason)
                    told(" cannot")
        results["is_done"] = True
    finally:
        kept(results)
    return results


def run_of(setting, options, runs):
    """The run of a setting among those of the results, where it may have to be begun."""
    options = json.loads(json.dumps(options, default=str))
    for one in runs:
        if one["setting"] == setting:
            if one["options"] != options:
                raise Refused(f"the earlier results have other options of {setting}")
            return one
    runs.append({"setting": setting, "options": options, "cases": [], "cannot": {}})
    return runs[-1]


def play_item(engine, one, item, cases, results, limit, told, kept):
    """The cases of an item that a run has not; `stops` of the results counts the processes that a case has ended."""
    points = corners()
    for name, (case, exact) in cases.items():
        if any((old["item"], old["case"]) == (item.name, name) for old in one["cases"]):
            continue
        at = f"{one['setting']}: {item.name} {name}"
        stops = results["stops"].get(at, 0)
        results["stops"][at] = stops + 1
        kept(results)
        began = time.perf_counter()
        told(f"{engine.NAME}, {at} …", end="")
        rows, cost, failure = [], None, None
        faulthandler.dump_traceback_later(limit, exit=True, file=sys.__stderr__)
        try:
            if stops < 2:
                rows, cost = play(engine, one["setting"], item, case, exact, points.get((item.name, name), {}))
            else:
                failure = f"ends the process, by a crash or after {limit:g} s"
        except Unsupported:
            raise
        except Exception as error:  # An engine that stops is a result.
            if isinstance(error, NotImplementedError) and not error.args:  # as in the template
                raise Refused(f"the adapter lacks a function: {where(error)}") from error
            failure = f"{type(error).__name__}: {first_sentence(error)} ({where(error)})"
        finally:
            faulthandler.cancel_dump_traceback_later()
            del results["stops"][at]
        if failure:
            one["cannot"][f"{item.name} {name}"] = f"fails: {failure}"
        one["cases"].append({"item": item.name, "mark": item.mark, "case": name, "rows": rows, "cost": cost})
        told(" left out" if stops >= 2 else f" {time.perf_counter() - began:.1f} s")


def first_sentence(failure):
    return str(failure).strip().split("\n")[0].split(". ")[0][:120]


def where(failure):
    """File and line of the adapter, or of the last call."""
    frames = traceback.extract_tb(failure.__traceback__)
    own = [frame for frame in frames if "friction_answers" not in frame.filename or "adapters" in frame.filename]
    frame = own[0] if own else frames[-1]
    return f"{Path(frame.filename).name}:{frame.lineno}"


def processor():
    try:
        with open("/proc/cpuinfo") as file:
            return next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor()
