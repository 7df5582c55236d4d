"""The page: error against cost of each engine and setting, marks, what is worst and whose fault it is."""

import csv
import io
import json
import math
import statistics

from .items import ITEMS
from .picture import scatter
from .scene import Refused
from .table import class_of

MARKS = tuple(dict.fromkeys(item.mark for item in ITEMS.values()))
SIGNS = {"exact": "●", "good": "◕", "fair": "◑", "wrong": "○"}
CORNERS = "Coulomb at corners"
KINDS = {"mechanics": "Engines for robots and mechanics", "games": "Engines for games", "gpu": "Engines for GPUs, here on a processor,"}
OURS = "With friction of whole faces, by the authors of this page"
# A block that sank by half its height was not held, m.
FALLS = 0.05
# Where a body stops tells less than how far it came.
UNCOUNTED = ("stop_s", "slide_s")


class Row:
    """An engine in one setting."""

    def __init__(self, results, run):
        self.version, self.licence, self.kind = results["version"], results["licence"], results["kind"]
        self.setting, self.options, self.cannot = run["setting"], run["options"], run["cannot"]
        self.engine = self.options.get("engine", results["engine"])
        self.cases, self.adapter = run["cases"], results.get("adapter")
        self.is_ours, self.is_full = "tribos" in self.engine.lower(), results.get("only") is None
        self.is_done = results["is_done"]
        costs = [case["cost"] for case in self.cases if case["cost"]]
        self.cost = statistics.median(costs) if costs else math.nan
        self.random = None  # its error on random cases

    def errors(self, mark):
        """The worst error of each case of a mark, with its row; infinite where the engine stopped."""
        found = []
        for case in (case for case in self.cases if case["mark"] == mark):
            rows = [row for row in case["rows"] if row["quantity"] not in UNCOUNTED]
            if mark == "holds":
                fell = any(row["quantity"] == "sink_m" and (row["error"] is None or row["error"] > FALLS) for row in rows)
                rows = [] if fell else [row for row in rows if row["quantity"] == "creep_m_s"]
            if not rows:
                found.append((math.inf, case, None))
                continue
            worst = max(rows, key=lambda row: math.inf if row["error"] is None else row["error"])
            found.append((math.inf if worst["error"] is None else worst["error"], case, worst))
        return found

    def median(self, mark):
        """Over the problems, each of which counts by the median of its cases."""
        problems = {}
        for wrong, case, _ in self.errors(mark):
            problems.setdefault(case["item"], []).append(wrong)
        return statistics.median(map(statistics.median, problems.values())) if problems else None

    def overall(self):
        """Mean of the medians, each mark alike and at most 1; creep in m/s, as a part of the speed of 1 m/s at which bodies are launched."""
        medians = [self.median(mark) for mark in MARKS]
        some = [min(wrong, 1.0) for wrong in medians if wrong is not None]
        return statistics.mean(some) if some else math.nan

    def rank(self):
        """By the larger error of both sets of cases, so that no setting is best that fits the list; engines that can show fewer marks come last."""
        return sum(self.median(mark) is None for mark in MARKS), max(self.overall(), self.random or 0.0)

    def count(self):
        """Cases that were played, and those of them that failed."""
        failed = sum(math.isinf(wrong) for mark in MARKS for wrong, _, _ in self.errors(mark))
        return f"{len(self.cases)}{'' if self.is_full else '¹'}" + (f", {failed} fail" if failed else "") + ("" if self.is_done else ", then it stopped")

    def worst(self, mark):
        return max(self.errors(mark), key=lambda found: found[0], default=None)


def told(mark, wrong):
    if wrong is None:
        return "–"
    if math.isinf(wrong):
        return "fails"
    if mark == "holds":
        factor, unit = next(found for limit, *found in ((1e-3, 1e6, "µm/s"), (1, 1e3, "mm/s"), (math.inf, 1, "m/s")) if wrong < limit)
        return f"{short(wrong * factor)} {unit}"
    return f"{short(100 * wrong)} %"


def short(value):
    """Two digits."""
    if value < 1e-3:
        return "<0.001" if value > 0 else "0"
    return f"{value:.2g}" if value < 99.5 else f"{value:.0f}"


def cell(row, mark):
    wrong = row.median(mark)
    if wrong is None:
        return "–"
    return f"{SIGNS[class_of('creep_m_s' if mark == 'holds' else 'along_m', wrong)]} {told(mark, wrong)}"


def fault(row):
    """Whether corners under Coulomb's law err as much."""
    if not row.get("corners") or not row["error"]:
        return ""
    return f"; corners alone {100 * row['corners']:.2g} %" + (": the points" if 0.7 < row["corners"] / row["error"] < 1.4 else "")


def footnote(row, mark):
    wrong, case, worst = row.worst(mark)
    where = f"{case['item']} {case['case']}"
    if worst is None:
        return f"{mark}: {where} {row.cannot.get(where, 'falls')}"
    got = f"{worst['quantity']} {worst['value']:.4g} for {worst['exact']:.4g}"
    return f"{mark}: {where}, {got} ({told(mark, wrong)}{fault(worst)})"


def read(path):
    """Results of `run` from a file; Refused says why it has none."""
    try:
        results = json.loads(path.read_text())
        missing = {"engine", "kind", "seed", "is_done", "runs"} - results.keys()
    except (OSError, ValueError, AttributeError) as reason:
        raise Refused(f"{path} has no results of `friction-answers run`: {reason}") from reason
    if missing:
        raise Refused(f"{path} has no results of this version of `friction-answers run`: {', '.join(sorted(missing))} is missing")
    return results


def best_of(rows):
    """Each engine's setting of the least overall error."""
    engines = {}
    for row in rows:
        if row.engine not in engines or row.rank() < engines[row.engine].rank():
            engines[row.engine] = row
    return sorted(engines.values(), key=Row.rank)


def head(columns):
    return [f"| {' | '.join(columns)} |", "|" + "---|" * len(columns)]


def marks_table(rows):
    lines = head(["engine", "setting", *MARKS, "error", "random", "cost", "cases"])
    for row in rows:
        cells = [row.engine, row.setting, *(cell(row, mark) for mark in MARKS), f"{short(100 * row.overall())} %"]
        cells += ["–" if row.random is None else f"{short(100 * row.random)} %", f"{row.cost:.2g}", row.count()]
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def table(rows):
    """Each problem in each setting, with its worst case, as CSV: errors relative, creep in m/s."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["engine", "version", "setting", "mark", "item", "cases", "median_error", "worst_error", "worst_case", "quantity", "value", "exact", "cost"])
    for row in rows:
        problems = {}
        for mark in MARKS:
            for found in row.errors(mark):
                problems.setdefault((mark, found[1]["item"]), []).append(found)
        for (mark, item), found in problems.items():
            wrong, case, worst = max(found, key=lambda one: one[0])
            numbers = [worst["quantity"], f"{worst['value']:.5g}", f"{worst['exact']:.6g}"] if worst else ["fails", "", ""]
            costs = [case["cost"] for _, case, _ in found if case["cost"]]
            cost = f"{statistics.median(costs):.2g}" if costs else ""
            median = statistics.median(wrong for wrong, _, _ in found)
            writer.writerow([row.engine, row.version, row.setting, mark, item, len(found), f"{median:.2g}", f"{wrong:.2g}", case["case"], *numbers, cost])
    return out.getvalue()


def page(results, out, missing=None):
    """Writes engines.md, engines.svg and engines.csv; Refused says which results exclude each other."""
    rows = [Row(one, run) for one in results if one["seed"] is None for run in one["runs"]]
    random = [Row(one, run) for one in results if one["seed"] is not None for run in one["runs"]]
    for some in (rows, random):
        names = {}
        for row in some:
            other = names.setdefault((row.engine, row.setting), row)
            if other is not row:
                raise Refused(f"results of {other.adapter} and {row.adapter} are both of {row.engine}, {row.setting}: leave one away, or name the engines apart")
    drawn = {(row.engine, row.setting): row.overall() for row in random}
    for row in rows:
        row.random = drawn.get((row.engine, row.setting))
    out.mkdir(parents=True, exist_ok=True)
    (out / "engines.csv").write_text(table(rows))
    (out / "engines.svg").write_text(scatter([row for row in rows if row.engine != CORNERS and not row.rank()[0]]))
    (out / "engines.md").write_text("\n".join(text(results, rows, missing or {})) + "\n")


def text(results, rows, missing):
    best = best_of(rows)
    yield "# Simulators against exact answers\n"
    yield "![Error against cost of each engine and setting, both on logarithmic scales](engines.svg)\n"
    yield (
        "Pressure on rigid faces is a choice: here it is uniform, as on a soft or worn face. Engines of points put the load on corners, and a box on four "
        "corners turns half as far: the row *Coulomb at corners* is what a perfect solver of points would find, and a third is what it misses in *turns*. "
        "*holds*, *releases* and *rolls* are the engine's own.\n"
    )
    yield (
        "Each mark has the median over its problems, and of each problem the median over its cases, of the worst quantity. *error* is their mean, each at "
        "most 100 %, creep as a part of 1 m/s; *random* is the error on a random case of each problem, to which nobody has tuned. Best is the setting, of those "
        "tried, whose larger error of both is least. *Cost*: processor time over simulated time, median over the cases, one scene at a time, the language's call "
        "included. ● within 0.1 % (holds: 1 µm/s), ◕ 1 % (0.1 mm/s), ◑ 10 % (1 cm/s), ○ beyond; – not to be had. ¹ One case of each problem. Engines without one "
        "of the marks come last and are not in the picture. `friction-answers list` has the problems.\n"
    )
    first = {}
    for row in rows:
        first.setdefault(row.engine, row)
    plain = sorted((row for row in first.values() if row.engine != CORNERS), key=Row.rank)
    for title, shown in (("at their best", best), ("as they come", plain)):
        for kind, name in KINDS.items():
            some = [row for row in shown if row.kind == kind and not row.is_ours]
            if some:
                yield f"## {name} {title}\n"
                yield from marks_table(some)
                yield ""
    ours = [row for row in best if row.is_ours]
    if ours:
        yield f"## {OURS}\n"
        yield from marks_table(ours)
        yield ""
    best = [row for row in best if row.engine != CORNERS]
    yield "## What to set\n"
    for row in best:
        options = ", ".join(f"{key} = {value}" for key, value in row.options.items() if key != "engine")
        yield f"- **{row.engine}** {row.version} ({row.licence}): {options}"
    yield "\n## Where each is worst\n"
    yield (
        "*Corners alone* is Coulomb's law at the corners of the face in steps of 0.2 ms: what an engine of points finds with a perfect solver. Where it errs as "
        "much, the points are at fault, no step or solver.\n"
    )
    for row in best:
        notes = [footnote(row, mark) for mark in MARKS if row.errors(mark)]
        yield f"- **{row.engine}**, {row.setting}: {'. '.join(notes)}."
        reasons = {}
        for item, reason in row.cannot.items():
            reasons.setdefault(reason, []).append(item)
        for reason, items in reasons.items():
            yield f"  - {', '.join(items)}: {reason}"
    if missing:
        yield "\n## Not run\n"
        yield from (f"- {name}: {reason}" for name, reason in missing.items())
    yield "\n## Machine\n"
    for machine in dict.fromkeys(f"{one['machine']['processor']}, {one['machine']['cores']} cores, Python {one['machine']['python']}" for one in results):
        yield f"- {machine}"
