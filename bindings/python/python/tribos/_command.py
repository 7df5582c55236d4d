"""The command ``tribos``, and what the library says of this program."""

from __future__ import annotations

import shutil
import signal
import sys
from pathlib import Path

from tribos import _native


def script() -> str | None:
    """The file of the command ``tribos``: this script, the one beside the interpreter, or that on the PATH."""
    there = [Path(argument) for argument in sys.argv[:1] if Path(argument).stem == "tribos"]
    beside = Path(sys.executable).parent
    there += [beside / "tribos", beside / "tribos.exe"]
    found = next((str(path.absolute()) for path in there if path.is_file()), None)
    return found or shutil.which("tribos")


def host(line: list[str]) -> None:
    """Tells the library which program runs: locks, job scripts and kept results name it."""
    _native.host(line, script(), _native.__file__)


def main() -> None:
    """Run the command with this process' arguments and end with its exit code."""
    line = ["tribos", *sys.argv[1:]]
    host(line)
    # The command has its own way to end on Ctrl-C: its results stay, and it says how to go on.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(_native.command(line))
