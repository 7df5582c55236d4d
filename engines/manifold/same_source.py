#!/usr/bin/env python3
"""Whether the compiler sees the same text in two builds.

    same_source.py BEFORE_BUILD OFF_BUILD [NAME.c ...]

Preprocesses the named sources of both compile_commands.json, or all of the library in src, and compares the results.
"""

import json
import re
import shlex
import subprocess
import sys
from pathlib import Path


def preprocessed(entry):
    """The source without comments, macros, line markers and white space."""
    words = shlex.split(entry["command"])
    output = words.index("-o")
    words = words[:output] + words[output + 2 :]
    words = [word for word in words if word != "-c"] + ["-E", "-P", "-w"]
    text = subprocess.run(words, cwd=entry["directory"], check=True, capture_output=True).stdout
    # Names that an engine's macro makes of the number of the line.
    return re.sub(rb"scope_exit\d+", b"scope_exit", b"".join(text.split()))


def entries(build, names):
    commands = json.loads((Path(build) / "compile_commands.json").read_text())
    by_name = {Path(entry["file"]).name: entry for entry in commands}
    if names:
        return {name: by_name[name] for name in names}
    return {n: e for n, e in by_name.items() if Path(e["file"]).parent.name == "src"}


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    before, off = (entries(build, sys.argv[3:]) for build in sys.argv[1:3])
    changed = [name for name, entry in before.items() if preprocessed(entry) != preprocessed(off[name])]
    if changed:
        sys.exit("without the switch the diff changes " + ", ".join(changed))
    print(f"without the switch the compiler sees the same text in {len(before)} sources")


if __name__ == "__main__":
    main()
