"""friction-answers: reference answers for simulators of friction."""

import argparse
import csv
import json
import os
import signal
import sys
from pathlib import Path

from .answers import ANSWERS, DOUBLE
from .cases import drawn
from .items import ITEMS
from .page import MARKS, Row, page, read, short
from .page import told as told_mark
from .run import LIMIT, run
from .scene import Refused
from .table import CLASSES, answers, class_of, error
from .units import UNITS

CLASS_NAMES = [*(name for name, _, _ in CLASSES), "wrong"]
EPILOG = """examples:
  friction-answers run mujoco --quick
  friction-answers run mujoco --setting elliptic --items puck box --out mujoco.json
  friction-answers run my_engine.py --seed 7
  friction-answers run ./libmy_engine.so --at-most 5
  friction-answers compare results.csv
  friction-answers variants --seed 7 --items box belts
  friction-answers page *.json --out page
  friction-answers all --out everything
"""


def listed(args):
    marks = dict.fromkeys(item.mark for item in ITEMS.values())
    known = answers()
    for mark in marks:
        print(f"{mark}:")
        for item in (item for item in ITEMS.values() if item.mark == mark):
            cases = {case: exact for (name, case), exact in known.items() if name == item.name}
            print(f"  {item.name:16} {item.title}; cases {', '.join(cases)}; {', '.join(next(iter(cases.values())))}")


def played(args):
    def told(text, end="\n"):
        print(text, file=sys.stderr, end=end, flush=True)

    if args.out and not Path(args.out).resolve().parent.is_dir():
        sys.exit(f"friction-answers: there is no folder {Path(args.out).parent} for {Path(args.out).name}")

    def kept(results):
        if args.out:
            written(args.out, json.dumps(results, indent=1))

    if args.resume and not args.out:
        sys.exit("friction-answers: --resume goes on with the results of --out")
    earlier = read(Path(args.out)) if args.resume and Path(args.out).exists() else None
    results = run(args.engine, args.setting, args.items, args.seed, "last" if args.quick else args.case, told, kept, earlier, args.limit)
    summary(results)
    if args.out:
        print(f"written to {args.out}")
    if not any(case["rows"] for one in results["runs"] for case in one["cases"]):
        sys.exit("friction-answers: no case gave a result")
    wrong = {one["setting"]: 100 * Row(results, one).overall() for one in results["runs"]}
    if args.at_most is not None and max(wrong.values()) > args.at_most:
        sys.exit(f"friction-answers: the error of {max(wrong, key=wrong.get)} is {max(wrong.values()):.3g} %, more than {args.at_most:g} %")


def summary(results):
    print(f"{results['engine']} {results['version']}")
    for one in results["runs"]:
        print(f"\n{one['setting']}: {one['options']}")
        for case in one["cases"]:
            for row in case["rows"]:
                print(told_row(case["item"], case["case"], row))
        for item, reason in one["cannot"].items():
            print(f"  {item:16} {'' if reason.startswith('fails') else 'cannot: '}{reason}")
        classes = [row["class"] for case in one["cases"] for row in case["rows"]]
        print("  " + ", ".join(f"{classes.count(name)} {name}" for name in CLASS_NAMES))
        row = Row(results, one)
        print(
            "  "
            + ", ".join(f"{mark} {told_mark(mark, row.median(mark))}" for mark in MARKS)
            + f"; error {short(100 * row.overall())} %, cost {row.cost:.2g} s a simulated s, cases {row.count().replace('¹', ', one of each problem')}"
        )


def told_row(item, case, row):
    never = "never stops" if row["quantity"] == "stop_s" else "not finite"
    wrong = never if row["error"] is None else told_error(row["quantity"], row["error"], row["exact"])
    points = f"  corners alone {told_error(row['quantity'], row['corners'], row['exact'])}" if "corners" in row else ""
    numbers = f"{row['value']:<12.6g} exact {row['exact']:<12.6g}"
    return f"  {item:16} {case:>8} {row['quantity']:18} {numbers} {wrong:>12}  {row['class']}{points}"


def told_error(quantity, wrong, exact):
    """In the unit of the quantity where it should be nothing and has no scale."""
    has_scale = exact != 0.0 or quantity in ("left_m", "along_m")
    return f"{100 * wrong:.3g} %" if has_scale else f"{wrong:.2g} {UNITS[quantity]}"


def compared(args):
    """CSV with item (or scene), case (or spin_rad_s), quantity, value."""
    known, found = answers(), 0
    try:
        file = open(args.results, newline="")
    except OSError as reason:
        sys.exit(f"friction-answers: {reason}")
    with file:
        for line, row in enumerate(csv.DictReader(file), 2):
            try:
                item, case = row.get("item") or row["scene"], row.get("case") or row["spin_rad_s"]
                quantity, value = row["quantity"], float(row["value"])
            except (KeyError, TypeError, ValueError) as reason:
                sys.exit(f"{args.results}:{line}: {reason}; a line has item, case, quantity and a number as value")
            key = next((key for key in known if key[0] == item and alike(key[1], case)), None)
            if key is None or quantity not in known[key]:
                what = f"no quantity {quantity} of {item} {case}" if key else f"no case {case} of {item}" if item in ITEMS else f"no item {item}"
                print(f"{args.results}:{line}: {what}; `friction-answers list` has all", file=sys.stderr)
                continue
            found += 1
            wrong = error(known[key], quantity, value)
            told = {"error": wrong if wrong < float("inf") else None, "class": class_of(quantity, wrong)}
            print(told_row(*key, {"quantity": quantity, "value": value, "exact": known[key][quantity]} | told))
    if not found:
        sys.exit("nothing to compare")


def alike(case, given):
    """Whether two names of a case are the same number, or the same word."""
    try:
        return float(case) == float(given)
    except ValueError:
        return case == given


def varied(args):
    """Random cases with their answers, as JSON."""
    made = []
    for name in args.items or ANSWERS:
        if name not in ANSWERS:
            sys.exit(f"no item {name}; `friction-answers list` has all")
        case = drawn(name, args.seed)
        made.append({"item": name, "case": case, "answers": {key: float(x) for key, x in ANSWERS[name](case, DOUBLE).items()}})
    print(json.dumps(made, indent=1))


def paged(args):
    results = [read(Path(path)) for path in args.results]
    if all(one["seed"] is not None for one in results):
        sys.exit("friction-answers: these are results of random cases; a page needs those of the standard ones, without --seed")
    page(results, Path(args.out))
    print(f"written to {Path(args.out) / 'engines.md'}")


def all_run(args):
    from .everything import ENGINES, everything

    unknown = [name for name in args.engines if name not in ENGINES]
    if unknown:
        sys.exit(f"no engine {unknown[0]}; there are {', '.join(ENGINES)}")
    stems = [Path(name).stem for name in [*(args.engines or ENGINES), *args.also]]
    twice = [stem for stem in stems if stems.count(stem) > 1]
    if twice:
        sys.exit(f"two engines would write {twice[0]}.json")
    everything(Path(args.out), args.engines, args.also, args.quick, args.limit, lambda text: print(text, file=sys.stderr, flush=True))


def written(path, text):
    """Never half of it."""
    beside = f"{path}.part"
    Path(beside).write_text(text + "\n")
    os.replace(beside, path)


def limited(command):
    command.add_argument("--limit", type=float, default=LIMIT, metavar="S", help=f"an engine's process ends at a case that takes longer, {LIMIT:g} s without")


def main():
    parser = argparse.ArgumentParser(prog="friction-answers", description=__doc__, epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--version", action="version", version="friction-answers 2.0.0")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    commands.add_parser("list", help="the problems and their cases").set_defaults(do=listed)
    one = commands.add_parser("run", help="run an engine through the problems")
    one.add_argument(
        "engine", help="an adapter of the package, or one of your own: Python (start from adapters/template.py) or a shared library with the functions of engine.h"
    )
    one.add_argument("--setting", action="append", default=[], help="one of the adapter's settings; may be repeated; all without it")
    one.add_argument("--items", nargs="+", default=[], choices=list(ITEMS), metavar="ITEM")
    one.add_argument("--seed", type=int, help="random cases of this seed in place of the standard ones")
    which = one.add_mutually_exclusive_group()
    which.add_argument("--case", help="the case of this name alone, as `friction-answers list` has it")
    which.add_argument("--quick", action="store_true", help="the last case of each item")
    one.add_argument("--at-most", type=float, metavar="PERCENT", help="fail if the error of a setting, the mean of its marks, is larger")
    limited(one)
    one.add_argument("--out", help="results as JSON")
    one.add_argument("--resume", action="store_true", help="go on with the results of --out, without a case that ended the process twice")
    one.set_defaults(do=played)
    one = commands.add_parser("compare", help="errors of a table that your simulator wrote")
    one.add_argument("results", help="CSV with item, case, quantity, value")
    one.set_defaults(do=compared)
    one = commands.add_parser("variants", help="random cases with their answers, as JSON")
    one.add_argument("--seed", type=int, required=True)
    one.add_argument("--items", nargs="+", default=[])
    one.set_defaults(do=varied)
    one = commands.add_parser("page", help="a page and its picture from results")
    one.add_argument("results", nargs="+")
    one.add_argument("--out", required=True, help="folder")
    one.set_defaults(do=paged)
    one = commands.add_parser("all", help="install every engine beside the results, run it, and make the page")
    one.add_argument("--engines", nargs="+", default=[], metavar="ENGINE", help="these alone")
    one.add_argument("--also", nargs="+", default=[], metavar="ENGINE", help="as for run, with this Python: your own beside them")
    one.add_argument("--quick", action="store_true", help="one case of each item")
    limited(one)
    one.add_argument("--out", required=True, help="folder")
    one.set_defaults(do=all_run)
    args = parser.parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        args.do(args)
    except BrokenPipeError:
        sys.stderr.close()
    except Refused as reason:
        sys.exit(f"friction-answers: {reason}")
    except KeyboardInterrupt:
        print("\nfriction-answers: stopped; what was played is kept in --out: `run --resume` goes on there, or the same `all`", file=sys.stderr)
        sys.exit(130)


if __name__ == "__main__":
    main()
