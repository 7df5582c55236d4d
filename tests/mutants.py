#!/usr/bin/env python3
"""Faults in the kernel, and which of its tests notices them.

`cargo mutants` lists the faults: another operator, a constant in place of a function's answer. A share of them is
put into a copy of the tree, all at once: each function asks the environment of its process which fault it has. So
the tests are compiled once, and run once for each fault.

Each fault is shown to the properties of the subjects, then to the kernel's own tests and to those against
independent sources; the pinned digests are asked apart, since they are our own output. A fault that none of them
notices is a hole in the tests, or changes nothing that is promised: the latter are listed in mutants.txt, and any other
fails the run.
"""

import argparse
import json
import os
import re
import resource
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
UNCHANGED = Path(__file__).with_name("mutants.txt")
# Which fault a process has; 0 is none.
SWITCH = """
extern crate std;

#[doc(hidden)]
#[allow(missing_docs)]
pub mod fault {
    use core::sync::atomic::{AtomicU32, Ordering::Relaxed};

    static PRESENT: AtomicU32 = AtomicU32::new(u32::MAX);

    #[inline]
    pub fn present() -> u32 {
        match PRESENT.load(Relaxed) {
            u32::MAX => read(),
            number => number,
        }
    }

    #[cold]
    #[inline(never)]
    fn read() -> u32 {
        let number = std::env::var("FAULT").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
        PRESENT.store(number, Relaxed);
        number
    }
}
"""
# Tests of the kernel: package, target, and what to run of it.
SUITES = {
    "judges": ("tribos-subjects", "every_subject", ["input_breaks_a_property"]),
    "pins": ("tribos-subjects", "every_subject", ["every_subject_has_the_pinned_bits"]),
    "own": ("tribos-core", "tribos_core", []),
    "laws": ("tribos-tests", "laws", []),
    "contacts": ("tribos-tests", "contacts", []),
    "sliding": ("tribos-tests", "sliding", []),
}
# The suite that notices most faults of a room; `laws` for the rest.
NEAREST = {
    "contacts": {"contact", "limit_surface", "manifold", "manifold_friction"},
    "sliding": {"bond", "holding", "modes", "planar", "presliding", "slider"},
}
# A test that takes so many times as long as without a fault, and some seconds, does not end.
PATIENCE, LEAST = 4, 10


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("share", nargs="?", default="7/64", help="which of the faults: k/n for every n-th from k on")
    arguments.add_argument("--tree", type=Path, default=ROOT / "target/mutants", help="where the copy is compiled")
    arguments.add_argument("--only", help="faults whose names match this regular expression")
    arguments.add_argument("--jobs", type=int, default=1, help="how many faults are tried at once")
    wanted = arguments.parse_args()
    tree = wanted.tree.resolve()
    copied(tree)
    faults = compilable(tree, [fault for fault in drawn(wanted.share) if re.search(wanted.only or "", fault["name"])])
    suites = built(tree)
    with ThreadPoolExecutor(wanted.jobs) as pool:
        sys.exit(judged(faults, pool.map(lambda fault: noticed(suites, fault), faults)))


def judged(faults, answers):
    """Prints what noticed each fault, and the sums; gives whether there is a hole."""
    told, holes = Counter(), []
    known = {line for line in UNCHANGED.read_text().splitlines() if line.startswith("core/")}
    for fault, seen in zip(faults, answers):
        if seen[0] == "nothing":
            if lasting(fault) in known:
                seen = "unchanged", "changes nothing that is promised"
            else:
                holes.append(fault)
        told[seen[0]] += 1
        print(f"{seen[0]:9} {fault['name']}  [{seen[1]}]", flush=True)
    summary(told, holes)
    return bool(holes)


def summary(told, holes):
    """How many faults each kind of test notices; pins are asked about what the others miss."""
    total = sum(told.values()) - told["unchanged"]
    physics = total - told["pins"] - len(holes)
    print(f"{total} faults that change something; {told['unchanged']} that do not")
    print(f"  {physics} noticed by physics, {told['judges']} of them by the properties of the subjects")
    print(f"  {told['pins']} by the pinned bits alone")
    print(f"  {len(holes)} by nothing")
    for fault in holes:
        print(lasting(fault))


def drawn(share):
    """The faults of a share."""
    command = ["cargo", "mutants", "--list", "--json", "--no-config", "--file", "core/src/**"]
    command += ["--exclude-re", "::fmt|impl (Debug|Display|Format)", "--shard", share, "--sharding", "round-robin"]
    listed = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    faults = [fault | {"number": number} for number, fault in enumerate(json.loads(listed.stdout), 1)]
    print(f"{len(faults)} faults are drawn")
    return faults


def lasting(fault):
    """A name that lasts while other lines come and go: file, fault, and the line of code with its place."""
    what = fault["name"].split(": ", 1)[1]
    first, last = fault["span"]["start"], fault["span"]["end"]
    line = (ROOT / fault["file"]).read_text().split("\n")[first["line"] - 1]
    if first["line"] == last["line"]:
        start, end = first["column"] - 1, last["column"] - 1
        line = f"{line[:start]}«{line[start:end]}»{line[end:]}"
    return f"{fault['file']}: {what}: {line.strip()}"


def copied(tree):
    """Copies the files that differ: what is compiled stays so."""
    names = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True)
    for name in names.stdout.split("\0"):
        if (ROOT / name).is_file():
            put(tree / name, (ROOT / name).read_bytes())


def put(path, content):
    if path.is_file() and path.read_bytes() == content:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def compilable(tree, faults):
    """Puts those faults into the copy that compile."""
    inside = [fault for fault in faults if body(fault)]
    print(f"{len(faults) - len(inside)} have no function that could ask: constants, and what is made by the compiler")
    root = "core/src/lib.rs"
    put(tree / root, ((ROOT / root).read_text() + SWITCH).encode())
    files = {fault["file"] for fault in inside}
    while True:
        owners = {name: switched(tree, name, [fault for fault in inside if fault["file"] == name]) for name in files}
        command = ["cargo", "check", "--quiet", "-p", "tribos-core", "--message-format", "json"]
        checked = subprocess.run(command, cwd=tree, env=environment(tree), capture_output=True, text=True)
        if checked.returncode == 0:
            print(f"{len(inside)} compile", flush=True)
            return inside
        wrong = set()
        for line in checked.stdout.splitlines():
            message = json.loads(line).get("message") or {}
            for span in message["spans"] if message.get("level") == "error" else []:
                wrong |= {
                    number
                    for first, last, number in owners.get(span["file_name"], [])
                    if first <= span["line_start"] and span["line_end"] <= last
                }
        if not wrong:
            sys.exit(checked.stderr)
        inside = [fault for fault in inside if fault["number"] not in wrong]


def environment(tree):
    return os.environ | {"CARGO_TARGET_DIR": str(tree / "target")}


def body(fault):
    """From where to where the body of a fault's function is, if it runs at run time."""
    text = (ROOT / fault["file"]).read_text()
    at = offsets(text)
    function = fault.get("function")
    if not function:
        return None
    # Documentation and attributes stand before the signature.
    begin = at(function["span"]["start"])
    head = re.compile(r"(?:\s*(?:///[^\n]*\n|#\[[^\n]*\]\n))*").match(text, begin).end()
    opening = text.index("{", head)
    if re.search(r"\bconst\s+fn\b|->\s*impl\b", text[head:opening]):
        return None
    return opening, at(function["span"]["end"])


def offsets(text):
    starts = [0]
    for line in text.split("\n"):
        starts.append(starts[-1] + len(line) + 1)
    return lambda place: starts[place["line"] - 1] + place["column"] - 1


def switched(tree, name, faults):
    """Writes a file with its faults; gives first line, last line and number of each."""
    text = (ROOT / name).read_text()
    at = offsets(text)
    out, done, owners = "", 0, []
    for place in sorted({body(fault) for fault in faults}):
        opening, last = place
        out += text[done : opening + 1]
        for fault in faults:
            if body(fault) != place:
                continue
            start, end = (at(fault["span"][side]) for side in ["start", "end"])
            wrong = text[opening:start] + fault["replacement"] + text[end:last]
            first = out.count("\n") + 2
            out += f"\nif crate::fault::present() == {fault['number']} {{ return {wrong} }}\n"
            owners.append((first, out.count("\n"), fault["number"]))
        done = opening + 1
    put(tree / name, (out + text[done:]).encode())
    return owners


def built(tree):
    """Compiles the tests, which pass without a fault; gives command, folder and seconds of each suite."""
    command = ["cargo", "test", "--no-run", "--quiet", "--no-default-features", "--message-format", "json", "--lib"]
    for package in sorted({package for package, _, _ in SUITES.values()}):
        command += ["-p", package]
    for target in sorted({target for _, target, _ in SUITES.values()} - {"tribos_core"}):
        command += ["--test", target]
    made = subprocess.run(command, cwd=tree, env=environment(tree), check=True, stdout=subprocess.PIPE, text=True)
    programs = {}
    for line in made.stdout.splitlines():
        message = json.loads(line)
        if message.get("executable"):
            programs[message["target"]["name"]] = message["executable"], Path(message["manifest_path"]).parent
    suites = {}
    for name, (_, target, tests) in SUITES.items():
        program, folder = programs[target]
        before = seconds()
        failed = run([program, *tests], folder, 0, None)
        if failed:
            sys.exit(f"{name} fails without a fault: {failed}")
        suites[name] = [program, *tests], folder, seconds() - before
        print(f"{name} takes {suites[name][2]:.0f} s", flush=True)
    return suites


def seconds():
    """What the processes that have ended cost."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def noticed(suites, fault):
    """The first suite that notices a fault, pins last, and its test."""
    room = fault["file"].split("/")[2].removesuffix(".rs")
    nearest = next((suite for suite, rooms in NEAREST.items() if room in rooms), "laws")
    order = sorted(suites, key=lambda name: (name != "judges", name != "own", name == "pins", name != nearest))
    for name in order:
        command, folder, usual = suites[name]
        failed = run(command, folder, fault["number"], usual)
        if failed:
            return name, failed
    return "nothing", ""


def run(command, folder, number, usual):
    """The first test that fails, or how the process ends; nothing if all pass."""
    limit = usual and int(PATIENCE * usual + LEAST)

    def bounded():
        if limit:
            resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))

    with subprocess.Popen(
        [*command, "--test-threads=1"],
        cwd=folder,
        env=os.environ | {"FAULT": str(number)},
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        preexec_fn=bounded,
    ) as process:
        for line in process.stdout:
            if line.endswith("FAILED\n"):
                process.kill()
                return line.split()[1]
    if process.returncode < 0:
        return "does not end" if -process.returncode in (9, 24) else f"signal {-process.returncode}"
    return "" if process.returncode == 0 else f"status {process.returncode}"


if __name__ == "__main__":
    main()
