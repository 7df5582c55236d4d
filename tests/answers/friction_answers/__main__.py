"""friction-answers: reference answers for simulators of friction."""

import argparse
import csv
import json
import os
import sys
from pathlib import Path

from .answers import ANSWERS, DOUBLE
from .cases import drawn
from .items import ITEMS
from .run import run
from .table import answers, class_of, error
from .units import UNITS

EPILOG = """examples:
  friction-answers run mujoco --quick
  friction-answers run mujoco --setting elliptic --items puck box --out mujoco.json
  friction-answers run my_engine.py --seed 7
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
            cases = [case for name, case in known if name == item.name]
            print(f"  {item.name:16} {item.title}; cases {', '.join(cases)}")


def played(args):
    def told(text):
        print(text, file=sys.stderr, flush=True)

    results = run(args.engine, args.setting, args.items, args.seed, args.quick, told)
    summary(results)
    if args.out:
        written(args.out, json.dumps(results, indent=1, default=str))
        print(f"written to {args.out}")


def summary(results):
    print(f"{results['engine']} {results['version']}")
    for one in results["runs"]:
        print(f"\n{one['setting']}: {one['options']}")
        for case in one["cases"]:
            for row in case["rows"]:
                wrong = "stops" if row["error"] is None else told_error(row["quantity"], row["error"])
                print(f"  {case['item']:16} {case['case']:>8} {row['quantity']:18} {row['value']:<12.6g} exact {row['exact']:<12.6g} {wrong:>12}  {row['class']}")
        for item, reason in one["cannot"].items():
            print(f"  {item:16} cannot: {reason}")


def told_error(quantity, wrong):
    unit = UNITS[quantity]
    return f"{wrong:.2g} {unit}" if class_of(quantity, 0.01) != class_of("along_m", 0.01) else f"{100 * wrong:.3g} %"


def compared(args):
    """CSV with item (or scene), case (or spin_rad_s), quantity, value."""
    known = answers()
    found = 0
    with open(args.results, newline="") as file:
        for row in csv.DictReader(file):
            key = row.get("item") or row.get("scene"), row.get("case") or f"{float(row['spin_rad_s']):g}"
            if key not in known or row["quantity"] not in known[key]:
                print(f"no answer for {' '.join(key)} {row['quantity']}; `friction-answers list` has the cases", file=sys.stderr)
                continue
            found += 1
            exact, value = known[key], float(row["value"])
            wrong = error(exact, row["quantity"], value)
            print(f"{key[0]:16} {key[1]:>8} {row['quantity']:18} {value:<12.6g} exact {exact[row['quantity']]:<12.6g} {told_error(row['quantity'], wrong)}")
    if not found:
        sys.exit("nothing to compare")


def varied(args):
    """Random cases with their answers, as JSON."""
    made = []
    for name in args.items or ANSWERS:
        if name not in ANSWERS:
            sys.exit(f"{name} has no random cases")
        case = drawn(name, args.seed)
        made.append({"item": name, "case": case, "answers": {key: float(x) for key, x in ANSWERS[name](case, DOUBLE).items()}})
    print(json.dumps(made, indent=1))


def paged(args):
    from .page import page

    page([json.loads(Path(path).read_text()) for path in args.results], Path(args.out))


def all_run(args):
    from .everything import ENGINES, everything

    unknown = [name for name in args.engines if name not in ENGINES]
    if unknown:
        sys.exit(f"no engine {unknown[0]}; there are {', '.join(ENGINES)}")
    everything(Path(args.out), args.engines, args.quick, lambda text: print(text, file=sys.stderr, flush=True))


def written(path, text):
    """Never half of it."""
    beside = f"{path}.part"
    Path(beside).write_text(text + "\n")
    os.replace(beside, path)


def main():
    parser = argparse.ArgumentParser(prog="friction-answers", description=__doc__, epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    commands.add_parser("list", help="the problems and their cases").set_defaults(do=listed)
    one = commands.add_parser("run", help="run an engine through the problems")
    one.add_argument("engine", help="an adapter of the package, or a file of your own (start from adapters/template.py)")
    one.add_argument("--setting", action="append", default=[], help="one of the adapter's settings; may be repeated; all without it")
    one.add_argument("--items", nargs="+", default=[], choices=list(ITEMS), metavar="ITEM")
    one.add_argument("--seed", type=int, help="random cases of this seed in place of the standard ones")
    one.add_argument("--quick", action="store_true", help="one case of each item")
    one.add_argument("--out", help="results as JSON")
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
    one.add_argument("--engines", nargs="+", default=[], metavar="ENGINE")
    one.add_argument("--quick", action="store_true", help="one case of each item")
    one.add_argument("--out", required=True, help="folder")
    one.set_defaults(do=all_run)
    args = parser.parse_args()
    try:
        args.do(args)
    except BrokenPipeError:
        sys.stderr.close()


if __name__ == "__main__":
    main()
