"""Fits against noiseless laws, general least squares and the command's own numbers."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tribos

DATA = Path(__file__).parents[3] / "scenes" / "data"
COMMAND = "import sys, tribos._command as c; sys.argv[0] = 'tribos'; c.main()"
STRIBECK = {"mu_s": 0.4, "mu_d": 0.2, "vs": 0.05, "delta": 1.5, "k": 0.1}


def stribeck(v: Any, mu_s: float, mu_d: float, vs: float, delta: float, k: float) -> Any:
    return mu_d + (mu_s - mu_d) * np.exp(-((v / vs) ** delta)) + k * v


SPEEDS = np.geomspace(1e-3, 2.0, 40)
PROGRAMS = DATA.parents[1] / "std-adapter" / "motion" / "src" / "fit" / "usage" / "programs.md"


@pytest.fixture(scope="module")
def unknown() -> tribos.SupportFit:
    """The fit of the file's pushes without a known support."""
    return tribos.fit_support(DATA / "pushes.csv")


def test_noiseless_laws_come_back() -> None:
    found = tribos.fit("stribeck", {"v": SPEEDS, "f": stribeck(SPEEDS, **STRIBECK)})
    for name, value in STRIBECK.items():
        assert found[name] == pytest.approx(value, rel=1e-8)
    assert found.converged and found.deviation < 1e-12 and found.freedoms == 35
    found = tribos.fit("power", {"v": SPEEDS, "f": 0.3 * SPEEDS**-0.25})
    assert found.parameters == pytest.approx({"gamma": 0.3, "alpha": -0.25}, rel=1e-10)
    found = tribos.fit("lugre", {"v": SPEEDS, "f": lugre_steady(SPEEDS)})
    wanted = {"fc": 1.0, "fs": 1.5, "vs": 0.01, "s2": 0.4}
    assert found.parameters == pytest.approx(wanted, rel=1e-7)
    mu0, a, b, v0 = 0.6, 0.010, 0.015, 1e-6
    speeds = np.geomspace(1e-8, 1e-3, 30)
    data = {"v": speeds, "f": mu0 + (a - b) * np.log(speeds / v0)}
    found = tribos.fit("rate-state", data, fixed={"v0": v0, "eta": 0.0, "a": a})
    assert found["b"] == pytest.approx(b, rel=1e-8)
    assert found["mu0"] == pytest.approx(mu0, rel=1e-10)


def lugre_steady(v: Any) -> Any:
    return 1.0 + 0.5 * np.exp(-((v / 0.01) ** 2)) + 0.4 * v


def test_programs_of_fitted_laws_have_friction_of_the_law(capsys: Any) -> None:
    laws = PROGRAMS.read_text(encoding="utf-8").split("\n## ")[1:]
    for law in laws:
        program, wanted = (
            law.split(f"```{kind}\n")[1].split("```")[0] for kind in ("python", "text")
        )
        # Programs print for people; here all digits count.
        exec(program.replace(":.9f", ":.17g"), {})
        told = np.loadtxt(capsys.readouterr().out.replace(" m/s:", "").splitlines())
        assert told == pytest.approx(np.loadtxt(wanted.splitlines()), rel=1e-12), law
    assert len(laws) >= 15


@pytest.mark.parametrize("weighted", [False, True])
def test_values_and_errors_are_those_of_general_least_squares(weighted: bool) -> None:
    optimize = pytest.importorskip("scipy.optimize")
    rng = np.random.default_rng(1)
    sigma = 1e-3 * (1.0 + SPEEDS)
    friction = stribeck(SPEEDS, **STRIBECK) + sigma * rng.normal(size=SPEEDS.size)
    data = {"v": SPEEDS, "f": friction}
    if weighted:
        data["sigma"] = sigma
    found = tribos.fit("stribeck", data)
    values, covariance = optimize.curve_fit(
        stribeck,
        SPEEDS,
        friction,
        p0=list(STRIBECK.values()),
        sigma=sigma if weighted else None,
        absolute_sigma=weighted,
        ftol=1e-15,
        xtol=1e-15,
        gtol=1e-15,
    )
    np.testing.assert_allclose(list(found.parameters.values()), values, rtol=1e-6)
    errors = np.sqrt(np.diag(covariance))
    np.testing.assert_allclose(list(found.errors.values()), errors, rtol=1e-5)
    np.testing.assert_allclose(found.covariance, covariance, rtol=1e-5)
    left = friction - found.predictions
    scatter = np.sqrt(np.sum((left / (sigma if weighted else 1.0)) ** 2) / 35.0)
    assert found.deviation == pytest.approx(scatter, rel=1e-10)
    assert found.is_weighted is weighted


def test_predictions_are_the_laws() -> None:
    found = tribos.fit("stribeck", {"v": SPEEDS, "f": stribeck(SPEEDS, **STRIBECK)})
    speeds = np.array([[0.01, 0.5], [3.0, 20.0]])
    np.testing.assert_allclose(found.predict(speeds), stribeck(speeds, **STRIBECK), rtol=1e-7)
    np.testing.assert_allclose(found.law.friction(speeds), found.predict(speeds), rtol=1e-14)
    assert isinstance(found.predict(0.5), float)
    with pytest.raises(ValueError, match="speeds alone"):
        found.predict([0.0, 0.1], times=[0.0, 1.0])


def test_a_record_over_time_is_followed_as_a_general_integrator_does() -> None:
    integrate = pytest.importorskip("scipy.integrate")
    found = tribos.fit("lugre", DATA / "joint.csv")
    p = found.parameters
    time = np.linspace(0.0, 0.5, 2001)
    velocity = 0.02 * np.sin(12.0 * time)

    def rate(t: float, state: Any) -> Any:
        v = np.interp(t, time, velocity)
        level = p["fc"] + (p["fs"] - p["fc"]) * np.exp(-((v / p["vs"]) ** 2))
        return v - p["s0"] * abs(v) * state / level

    solved = integrate.solve_ivp(
        rate, (0.0, 0.5), [0.0], t_eval=time, rtol=1e-8, atol=1e-12, max_step=5e-4, method="LSODA"
    )
    z = solved.y[0]
    slope = np.array([rate(t, state) for t, state in zip(time, z)])
    wanted = p["s0"] * z + p["s1"] * slope + p["s2"] * velocity
    made = found.predict(velocity, times=time)
    np.testing.assert_allclose(made, wanted, atol=2e-3 * np.abs(wanted).max())
    with pytest.raises(ValueError, match="times as well"):
        found.predict(velocity)


def test_a_fit_gives_the_commands_numbers() -> None:
    path = DATA / "bearing.csv"
    call = [sys.executable, "-c", COMMAND, "fit", "--law", "stribeck", str(path)]
    told = subprocess.run(call, check=True, capture_output=True, text=True).stdout
    line = next(line for line in told.splitlines() if line.startswith("as a law"))
    text = line.split()[-1].partition(":")[2]
    values = {key: float(value) for key, value in (item.split("=") for item in text.split(","))}
    assert tribos.fit("stribeck", path).parameters == values


@pytest.mark.parametrize("known", [True, False])
def test_a_support_gives_the_commands_numbers(
    known: bool, tmp_path: Path, unknown: tribos.SupportFit
) -> None:
    patch = ["--patch", "box:0.2x0.1"] if known else []
    call = [sys.executable, "-c", COMMAND, "fit", "--support", str(DATA / "pushes.csv"), *patch]
    subprocess.run([*call, "--out", str(tmp_path / "out")], check=True, capture_output=True)
    told = json.loads((tmp_path / "out" / "summary.json").read_text())
    found = unknown
    if known:
        found = tribos.fit_support(DATA / "pushes.csv", tribos.box(0.2, 0.1))
    assert list(found.centre_of_pressure) == told["centre_of_pressure"]
    assert (found.force_limit, found.length) == (told["force_limit"], told["length"])
    assert len(found.pressure) == told["points"]
    angles = {m["name"]: (m["median_angle_deg"], m["mean_angle_deg"]) for m in told["models"]}
    assert found.angles == angles
    # The file says what it was made from.
    assert found.centre_of_pressure == pytest.approx((0.02, -0.005), abs=4e-4)
    assert found.force_limit == pytest.approx(4.0, rel=0.01)


def pushes(surface: tribos.LimitSurface, count: int) -> Any:
    rng = np.random.default_rng(2)
    motion = rng.uniform(-1.0, 1.0, (count, 3)) * [1.0, 1.0, 15.0]
    return np.hstack((motion, -surface.wrench(motion)))


SUPPORTS = [
    tribos.polygon([[-0.1, -0.05], [0.1, -0.05], [0.0, 0.1]]),
    tribos.bar(0.2),
    tribos.mesh([[0.0, 0.0], [0.1, 0.0], [0.0, 0.1]], [[0, 1, 2]], [1.0, 1.0, 1.0]),
    tribos.points([[-0.04, -0.02], [0.06, -0.03], [-0.02, 0.07]], [1.0, 2.0, 1.0]),
]


@pytest.mark.parametrize("patch", SUPPORTS, ids=lambda patch: str(patch.kind))
def test_a_known_support_foretells_its_own_pushes(patch: tribos.Patch) -> None:
    found = tribos.fit_support(pushes(tribos.LimitSurface(patch, 0.5, 8.0), 40), patch)
    assert found.angles["known"][0] < 1e-3
    # A grid of cells stands for the support: 1/24 of its width.
    assert found.force_limit == pytest.approx(4.0, rel=0.02)
    np.testing.assert_allclose(found.centre_of_pressure, patch.centre, atol=2e-3)
    # The fitted pressure is a patch as any other.
    surface = found.limit_surface()
    assert surface.force_limit == found.force_limit
    np.testing.assert_allclose(found.patch.centre, found.centre_of_pressure, atol=1e-15)


def test_loads_of_known_feet_come_back() -> None:
    feet = SUPPORTS[-1]
    found = tribos.fit_support(pushes(tribos.LimitSurface(feet, 1.0, 4.0), 60), feet)
    np.testing.assert_allclose(found.pressure[:, 2], [1.0, 2.0, 1.0], rtol=1e-3)
    places = dict(feet._parameters)["positions"]
    np.testing.assert_array_equal(found.pressure[:, :2], places)


def test_tables_of_all_kinds_give_one_fit(tmp_path: Path, unknown: tribos.SupportFit) -> None:
    friction = stribeck(SPEEDS, **STRIBECK) * (1.0 + 1e-3 * np.sin(40.0 * SPEEDS))
    table = {"f": friction, "v": SPEEDS, "sigma": 1e-3 * np.ones(SPEEDS.size)}
    wanted = tribos.fit("stribeck", table).parameters
    structured = np.zeros(SPEEDS.size, dtype=[("v", float), ("f", float), ("sigma", float)])
    for name, column in table.items():
        structured[name] = column
    path = tmp_path / "data.csv"
    rows = zip(*(table[name] for name in ("f", "v", "sigma")))
    lines = [",".join(repr(float(x)) for x in row) for row in rows]
    path.write_text("\n".join(["# friction of a bearing", "f, v, sigma", *lines, ""]))
    for same in (structured, path, str(path)):
        assert tribos.fit("stribeck", same).parameters == wanted
    pandas = pytest.importorskip("pandas")
    assert tribos.fit("stribeck", pandas.DataFrame(table)).parameters == wanted
    frame = pandas.read_csv(DATA / "pushes.csv", comment="#")
    assert tribos.fit_support(frame).force_limit == unknown.force_limit
    with pytest.raises(ValueError, match="no column dtheta"):
        tribos.fit_support(frame.drop(columns="dtheta"))


def test_forces_are_divided_by_the_load() -> None:
    friction = stribeck(SPEEDS, **STRIBECK)
    whole = tribos.fit("stribeck", {"v": SPEEDS, "f": 12.5 * friction}, load=12.5)
    assert whole["mu_s"] == pytest.approx(STRIBECK["mu_s"], rel=1e-8)


def test_fixed_parameters_stay_and_have_no_error() -> None:
    data = {"v": SPEEDS, "f": stribeck(SPEEDS, **STRIBECK)}
    found = tribos.fit("stribeck", data, fixed={"delta": 2.0, "k": 0.1})
    assert found["delta"] == 2.0 and found.errors["delta"] == 0.0
    states = {estimate.name: estimate.state for estimate in found.estimates}
    assert states["k"] == "fixed" and states["vs"] == "determined"
    assert found.covariance.shape == (3, 3)


def test_what_the_data_do_not_determine_is_said() -> None:
    # One speed tells a coefficient for every exponent.
    found = tribos.fit("power", {"v": [1.0, 1.0, 1.0], "f": [0.3, 0.31, 0.29]})
    alpha = found.estimates[1]
    assert alpha.name == "alpha" and alpha.state == "not determined" and np.isnan(alpha.error)
    assert "not determined" in repr(found)


def test_a_fit_reads_well(unknown: tribos.SupportFit) -> None:
    text = repr(tribos.fit("stribeck", DATA / "bearing.csv"))
    assert "<stribeck fitted to 40 points>" in text
    assert "0.14981      ± 0.00024" in text and "[m/s] Stribeck speed" in text
    text = repr(unknown)
    assert "centre at (19.91, -5.07) mm" in text and "quartic       1.97   2.48" in text


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: tribos.fit("glue", {"v": [1.0], "f": [1.0]}), "law to fit"),
        (
            lambda: tribos.fit("power", {"v": [1.0], "g": [1.0]}),
            "no column for f .*the columns are 1 `v`, 2 `g`",
        ),
        (lambda: tribos.fit("power", [1.0, 2.0]), "a table with the columns v, f"),
        (lambda: tribos.fit("power", {"v": [1.0, 2.0], "f": [1.0]}), "different lengths"),
        (lambda: tribos.fit("power", {"v": [1.0, 0.0], "f": [1.0, 1.0]}), "1 points cannot"),
        (lambda: tribos.fit("power", {"v": [1.0, 2.0], "f": [-1.0, -1.0]}), "turn its sign"),
        (lambda: tribos.fit("power", {"v": [1.0], "f": [0.3]}), "1 points cannot determine 2"),
        (lambda: fit_power(fixed={"beta": 1.0}), "no parameter `beta`"),
        (lambda: fit_power(fixed={"alpha": -3.0}), "`alpha` must be"),
        (lambda: fit_power(starts=0), "starts"),
        (lambda: fit_power(load=0.0), "load must be > 0"),
        (lambda: tribos.fit("dahl", {"v": [1, 1, 2], "f": [1, 1, 1]}), "with a column t"),
        (lambda: tribos.fit_support(np.ones((5, 6))), "at least 10"),
        (lambda: tribos.fit_support(np.ones((20, 5))), "shape"),
        (lambda: tribos.fit_support(np.zeros((20, 6))), "push 0: the motion must not be zero"),
        (lambda: tribos.fit_support(np.ones((20, 6)), tribos.disk(0.1)), "a support is"),
    ],
)
def test_what_cannot_be_fitted_is_refused(call: Any, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        call()


def fit_power(**options: Any) -> tribos.LawFit:
    return tribos.fit("power", {"v": [1.0, 2.0, 3.0], "f": [0.3, 0.2, 0.1]}, **options)


def test_a_wrong_line_of_a_file_is_named(tmp_path: Path) -> None:
    path = tmp_path / "data.csv"
    path.write_text("# comment\nv,f\n1,0.3\n2,abc\n")
    with pytest.raises(ValueError, match=r"data\.csv:4: .*abc"):
        tribos.fit("power", path)
    path.write_text("v,f\n1,0.3,7\n")
    with pytest.raises(ValueError, match=r"data\.csv:2: 3 cells between commas instead of 2"):
        tribos.fit("power", path)
    path.write_text("")
    with pytest.raises(ValueError, match=r"data\.csv:1: no column for v"):
        tribos.fit("power", path)
    with pytest.raises(FileNotFoundError):
        tribos.fit("power", tmp_path / "nowhere.csv")


def reciprocating(strokes: int, rows: int = 200) -> dict[str, Any]:
    """Strokes of 0.3 with an offset of 0.02, to and fro."""
    sign = np.repeat(np.where(np.arange(strokes) % 2 == 0, 1.0, -1.0), rows)
    return {"t": 0.01 * np.arange(sign.size), "v": 0.01 * sign, "f": 0.3 * sign + 0.02}


def test_strokes_have_their_numbers_whatever_tells_of_the_motion() -> None:
    data = reciprocating(12)
    found = tribos.strokes(data)
    assert len(found) == 12 and found.divided_by == "velocity" and found.run_in == 0
    assert found.summary["mean"] == pytest.approx(0.3, rel=1e-12)
    assert found.summary["offset"] == pytest.approx(0.02, rel=1e-9)
    np.testing.assert_array_equal(found.rows, 200 * np.column_stack((range(12), range(1, 13))))
    np.testing.assert_allclose(found.mean, 0.3 + 0.02 * found.direction, rtol=1e-12)
    np.testing.assert_allclose(found.resistance[:200], 0.32)
    assert np.isnan(found.peak[0]) and not np.isnan(found.peak[1:]).any()
    assert "12 strokes, divided by the velocity" in repr(found)
    position = np.cumsum(data["v"]) * 0.01
    moved = tribos.strokes({"t": data["t"], "x": position, "f": data["f"]})
    assert len(moved) == 12 and moved.divided_by == "position"
    signs = tribos.strokes({"t": data["t"], "f": data["f"]})
    assert len(signs) == 12 and signs.divided_by == "sign of the friction" and signs.notes
    load = np.full(data["t"].size, 5.0)
    forces = {**data, "f": 5.0 * data["f"], "load": load}
    assert tribos.strokes(forces).summary == pytest.approx(found.summary, nan_ok=True)
    with pytest.raises(ValueError, match="both given"):
        tribos.strokes(forces, load=5.0)


def test_strokes_are_those_of_the_command() -> None:
    file = DATA / "tribometer.csv"
    line = [sys.executable, "-c", COMMAND, "fit", "--strokes", str(file), "--load", "20"]
    told = subprocess.run([*line, "--format", "json"], capture_output=True, text=True, check=True)
    wanted = json.loads(told.stdout)
    found = tribos.strokes(file, load=20.0)
    for name, value in wanted["summary"].items():
        assert found.summary[name] == value
    assert found.run_in == wanted["run_in"]["after"] and list(found.notes) == wanted["notes"]
    means = [stroke["mean"] for stroke in wanted["strokes"]]
    np.testing.assert_array_equal(found.mean, means)


def test_logs_are_read_as_they_are(tmp_path: Path) -> None:
    wanted = fit_power()
    path = tmp_path / "log.txt"
    lines = ["Rig 7", "Geschwindigkeit [mm/s];Bemerkung;Reibwert", "1000;;0,3", "2000;x;0,2"]
    path.write_text("\n".join([*lines, "2500;;", "3000;;0,1"]), encoding="utf-16")
    found = tribos.fit("power", path)
    assert found.parameters == pytest.approx(wanted.parameters)
    assert found.dropped == {"with an empty cell": 1}
    assert 'v from "Geschwindigkeit [mm/s]" in mm/s' in found.read[0]
    seen = tribos.look(path)
    assert [column["role"] for column in seen.columns] == ["v", None, "f"]
    assert seen.columns[1]["words"] == 1 and seen.rows == 4 and seen.trouble is None
    assert "decimal commas" in repr(seen)


def test_tables_with_other_names_and_units_are_the_same_tables() -> None:
    wanted = fit_power()
    table = {
        "Speed [mm/s]": [1e3, 2e3, np.nan, 3e3],
        "COF": [0.3, 0.2, 9.0, 0.1],
        "note": list("abcd"),
    }
    found = tribos.fit("power", table)
    assert found.parameters == pytest.approx(wanted.parameters) and found.dropped == {"with NaN": 1}
    table = {"a": [1e3, 2e3, 3e3], "b": [-0.3, -0.2, -0.1]}
    found = tribos.fit("power", table, columns={"v": 1, "f": "-b"}, units={"v": "mm/s"})
    assert found.parameters == pytest.approx(wanted.parameters)
    with pytest.raises(ValueError, match="columns v: there is no column `c`"):
        tribos.fit("power", table, columns={"v": "c", "f": "b"})
    assert wanted.read == () and wanted.dropped == {}
