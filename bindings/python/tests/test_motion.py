"""Bodies that slide, rest, are thrown to a pose and pushed; laws with a state."""

from __future__ import annotations

import csv
import dataclasses
import itertools
import json
import math
import pickle
import subprocess
import sys
from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tribos

TABLES = Path(__file__).resolve().parents[3] / "tests" / "tables"
# Patches of radius 1 by the order q of their pressure (1 - r²)^q.
PATCHES = {
    -1.0: tribos.ring(1.0),
    -0.5: tribos.punch(1.0),
    0.0: tribos.disk(1.0),
    0.5: tribos.hertz(1.0),
    1.0: tribos.paraboloid(1.0),
}
PUCK = tribos.Friction(tribos.disk(0.08), mu=0.3)
GRAVITY = 9.81
SHAPES = {
    "disk": tribos.disk(0.1),
    "ring": tribos.ring(0.1),
    "annulus": tribos.annulus(0.05, 0.1),
    "box": tribos.box(0.3, 0.1),
    "leaning": tribos.box(0.3, 0.1, centre=(0.02, 0.01)),
    "bar": tribos.bar(0.3),
    "points": tribos.points([[0.1, 0.1], [-0.1, 0.1], [-0.1, -0.1], [0.1, -0.1]]),
    "mesh": tribos.mesh([[-0.1, -0.1], [0.1, -0.1], [0.0, 0.1]], [[0, 1, 2]], [1.0, 2.0, 1.0]),
}
ZERO = np.zeros(3)


def table(name: str) -> list[dict[str, str]]:
    path = TABLES / name
    if not path.exists():
        pytest.skip("the tables of the repository are not here")
    with path.open() as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


@pytest.fixture(autouse=True)
def all_threads() -> Any:
    yield
    tribos.set_num_threads(None)


def crates(shape: str = "box", count: int = 300) -> tuple[tribos.PlanarBody, Any, Any]:
    """Bodies of many masses and loads, some slow and some fast, with pushes of which some hold."""
    rng = np.random.default_rng(7)
    mass = rng.uniform(0.5, 5.0, count)
    inertia = mass * rng.uniform(0.05, 0.2, count) ** 2
    load = mass * GRAVITY * rng.uniform(0.2, 2.0, count)
    friction = tribos.Friction(SHAPES[shape], mu=0.4)
    body = tribos.PlanarBody(friction, mass, inertia, load=load)
    scale = 10.0 ** rng.uniform(-4, 0, (count, 1))
    twists = scale * rng.normal(size=(count, 3)) * [1.0, 1.0, 10.0]
    pushes = rng.normal(size=(count, 3)) * [3.0, 3.0, 0.2]
    return body, twists, pushes


# Sliding to rest


def test_a_default_disk_stops_where_the_documentation_says() -> None:
    rest = tribos.slide(PUCK, 1.0, 5.0)
    assert rest.time == pytest.approx(0.369017132104558, rel=1e-13)
    assert isinstance(rest.time, float) and isinstance(rest.ratio, float)


def test_rests_are_those_of_the_high_precision_table() -> None:
    groups: defaultdict[tuple[float, float], list[dict[str, str]]] = defaultdict(list)
    for row in table("rests.csv"):
        if row["stop_time"]:
            groups[float(row["q"]), float(row["alpha"])].append(row)
    assert sum(map(len, groups.values())) > 100
    for (order, alpha), rows in groups.items():
        friction = tribos.Friction(PATCHES[order], mu=1.0, alpha=alpha)
        names = ("inertia_ratio", "v0", "w0", "stop_time", "distance", "angle")
        inertia, speed, spin, *stops = np.array([[float(r[n]) for n in names] for r in rows]).T
        rest = tribos.slide(friction, speed, spin, inertia_ratio=inertia, gravity=1.0)
        np.testing.assert_allclose(rest[:3], stops, rtol=2e-13)


def test_paths_pass_through_the_states_of_the_table() -> None:
    rows = [row for row in table("rests.csv") if row["speed"] and float(row["q"]) == 0.0]
    assert len(rows) > 20
    for row in rows:
        value = {name: float(text) for name, text in row.items() if text}
        friction = tribos.Friction(PATCHES[0.0], mu=1.0, alpha=value["alpha"])
        body: dict[str, Any] = {"inertia_ratio": value["inertia_ratio"], "gravity": 1.0}
        path = tribos.slide_path(friction, value["v0"], value["w0"], value["time"], **body)
        wanted = [value[n] for n in ("speed", "spin", "distance_then", "angle_then")]
        np.testing.assert_allclose(path[1:], wanted, rtol=1e-11)


def test_pure_motions_have_their_closed_forms() -> None:
    speed, spin, mu = np.array([0.1, 1.0, 3.0]), np.array([1.0, 20.0, 300.0]), 0.3
    slides = tribos.slide(PUCK, speed, 0.0)
    np.testing.assert_allclose(slides.distance, speed**2 / (2 * mu * GRAVITY), rtol=1e-14)
    np.testing.assert_allclose(slides.time, speed / (mu * GRAVITY), rtol=1e-14)
    assert np.all(slides.ratio == np.inf) and np.all(slides.angle == 0.0)
    # The torque 2/3 mu N R stops a disk.
    turn = 2.0 / 3.0 * mu * GRAVITY / (0.5 * 0.08)
    spins = tribos.slide(PUCK, 0.0, spin)
    np.testing.assert_allclose(spins.time, spin / turn, rtol=1e-13)
    np.testing.assert_allclose(spins.angle, spin**2 / (2 * turn), rtol=1e-13)
    assert np.all(spins.ratio == 0.0) and np.all(spins.distance == 0.0)
    # dv/dt = -k v^alpha ends at v0^(1 - alpha)/(k (1 - alpha)).
    oiled = tribos.Friction(tribos.hertz(0.01), mu=mu, alpha=0.5)
    stop = np.sqrt(speed) / (0.5 * mu * GRAVITY)
    np.testing.assert_allclose(tribos.slide(oiled, speed, 0.0).time, stop, rtol=1e-13)


def test_signs_mirror_the_motion_to_the_bit() -> None:
    rest = tribos.slide(PUCK, [1.0, -1.0, 1.0, -1.0], [5.0, 5.0, -5.0, -5.0])
    assert len(set(rest.time)) == 1 and len(set(rest.ratio)) == 1
    assert np.array_equal(np.sign(rest.distance), [1, -1, 1, -1])
    assert np.array_equal(np.sign(rest.angle), [1, 1, -1, -1])
    assert len(set(abs(rest.distance))) == 1 and len(set(abs(rest.angle))) == 1
    path = tribos.slide_path(PUCK, [1.0, -1.0], 5.0, 0.1)
    assert path.speed[0] == -path.speed[1] > 0 and path.distance[0] == -path.distance[1] > 0


def test_launches_that_are_not_finite_give_nan_and_harm_no_other() -> None:
    bad = [math.nan, math.inf, -math.inf]
    speed = np.array([1.0, *bad, 1.0, 1.0, 1.0])
    spin = np.array([5.0, 5.0, 5.0, 5.0, *bad])
    rest = np.array(tribos.slide(PUCK, speed, spin))
    assert np.isnan(rest[:, 1:]).all()
    assert np.array_equal(rest[:, 0], tribos.slide(PUCK, 1.0, 5.0))
    path = np.array(tribos.slide_path(PUCK, speed, spin, 0.1)[1:])
    assert np.isnan(path[:, 1:]).all() and np.isfinite(path[:, 0]).all()
    assert np.isnan(tribos.slide_path(PUCK, 1.0, 5.0, math.nan)[1:]).all()


def test_a_body_at_rest_stays() -> None:
    rest = tribos.slide(PUCK, 0.0, 0.0)
    assert rest[:3] == (0.0, 0.0, 0.0) and math.isnan(rest.ratio)


def test_a_batch_is_its_launches_one_by_one_whatever_the_threads() -> None:
    rng = np.random.default_rng(1)
    speed, spin = rng.uniform(0, 3, (40, 1)), rng.uniform(-50, 50, 5)
    inertia = rng.uniform(0.3, 0.7, (40, 1))
    whole = []
    for threads in (1, 3):
        tribos.set_num_threads(threads)
        whole.append(np.array(tribos.slide(PUCK, speed, spin, inertia_ratio=inertia)))
    assert np.array_equal(whole[0], whole[1])
    for i, k in itertools.product((0, 17, 39), range(5)):
        one = tribos.slide(PUCK, speed[i, 0], spin[k], inertia_ratio=inertia[i, 0])
        assert np.array_equal(whole[0][:, i, k], one)
    path = tribos.slide_path(PUCK, 1.0, 5.0, np.linspace(0, 0.4, 9)[:, None], gravity=[9.81, 1.62])
    assert path.time.shape == path.speed.shape == (9, 2)
    then = tribos.slide_path(PUCK, 1.0, 5.0, path.time[3, 1], gravity=1.62)
    assert path.speed[3, 1] == then.speed


def test_a_path_ends_at_its_rest() -> None:
    rest = tribos.slide(PUCK, 1.0, 5.0)
    path = tribos.slide_path(PUCK, 1.0, 5.0, [0.0, rest.time * 0.999, rest.time * 1.001, 1e9])
    assert path.speed[0] == 1.0 and path.spin[0] == 5.0
    assert 0.0 < path.speed[1] < 2e-3
    assert np.all(path.speed[2:] == 0.0) and np.all(path.spin[2:] == 0.0)
    np.testing.assert_allclose(path.distance[2:], rest.distance, rtol=1e-13)
    assert np.all(np.diff(path.distance[:3]) > 0.0)


def test_an_array_of_gravities_varies_the_deceleration() -> None:
    mu = np.array([0.1, 0.3, 0.7])
    rest = tribos.slide(PUCK, 1.0, 5.0, gravity=GRAVITY * mu / 0.3)
    for one, time in zip(mu, rest.time, strict=True):
        other = tribos.Friction(tribos.disk(0.08), mu=one)
        assert tribos.slide(other, 1.0, 5.0).time == pytest.approx(time, rel=1e-13)


@pytest.mark.parametrize(
    ("friction", "given", "reason"),
    [
        (tribos.Friction(tribos.disk(0.1), mu=0.3, alpha=1.0), {}, "never comes to rest.*alpha <"),
        (tribos.Friction(tribos.box(0.1, 0.1), mu=0.3), {}, "only a round patch"),
        (
            tribos.Friction(tribos.disk(0.1), law="stribeck:mu_s=0.4,mu_d=0.2,vs=0.1"),
            {},
            "not a power of the speed",
        ),
        (PUCK, {"inertia_ratio": 0.0}, "inertia ratio"),
        (PUCK, {"gravity": [9.81, -1.0]}, "deceleration"),
        (PUCK, {"spin": "fast"}, "spin must be real numbers"),
        ("disk", {}, "must be a tribos.Friction"),
    ],
)
def test_what_cannot_slide_to_rest_is_refused_with_the_reason(
    friction: Any, given: dict[str, Any], reason: str
) -> None:
    with pytest.raises(ValueError, match=reason):
        tribos.slide(friction, **{"speed": 1.0, "spin": 2.0, **given})


def test_viscous_bodies_have_paths_without_rest() -> None:
    oiled = tribos.Friction(tribos.disk(0.1), mu=0.3, alpha=1.0)
    times = np.array([0.1, 1.0])
    path = tribos.slide_path(oiled, 1.0, 0.0, times)
    np.testing.assert_allclose(path.speed, np.exp(-0.3 * GRAVITY * times), rtol=1e-13)
    with pytest.raises(ValueError, match="times"):
        tribos.slide_path(PUCK, 1.0, 0.0, [0.1, -0.1])


# Final motion


def test_fixed_points_are_those_of_the_high_precision_table() -> None:
    finite = 0
    for row in table("modes_pressure.csv"):
        order, alpha, inertia = (float(row[name]) for name in ("q", "alpha", "C"))
        if order not in PATCHES:
            continue
        friction = tribos.Friction(PATCHES[order], mu=1.0, alpha=alpha)
        modes = tribos.modes(friction, inertia)
        ends = sorted(float(row[name]) for name in ("c_spinning", "c_sliding"))
        np.testing.assert_allclose(modes.inertia_interval, ends, rtol=1e-13)
        between = modes.fixed_points[1:-1]
        assert len(between) == bool(row["eps0"])
        assert [modes.fixed_points[i].ratio for i in (0, -1)] == [0.0, math.inf]
        assert modes.rests_in_finite_time == (alpha < 1.0)
        if row["eps0"]:
            finite += 1
            assert between[0].ratio == pytest.approx(float(row["eps0"]), rel=1e-11)
            assert between[0].stability == ("stable" if alpha < 1.0 else "unstable")
    assert finite > 20


def test_a_body_ends_in_its_final_mode() -> None:
    for inertia, mode in ((0.2, "sliding"), (0.5, "together"), (0.8, "spinning")):
        last = tribos.modes(PUCK, inertia)
        rest = tribos.slide(PUCK, [1.0, 0.2], [2.0, 30.0], inertia_ratio=inertia)
        assert last.final_mode == mode and last.final_ratio is not None
        np.testing.assert_allclose(rest.ratio, last.final_ratio, rtol=1e-12)


def test_two_stable_ends_need_a_start() -> None:
    cubic = tribos.Friction(tribos.disk(0.1), mu=0.3, alpha=3.0)
    unknown = tribos.modes(cubic, 0.5)
    assert (unknown.final_mode, unknown.final_ratio) == (None, None)
    border = unknown.fixed_points[1].ratio
    ends = [tribos.modes(cubic, 0.5, initial_ratio=k * border).final_mode for k in (0.9, 1.1)]
    assert ends == ["spinning", "sliding"]
    viscous = tribos.Friction(tribos.disk(0.1), mu=0.3, alpha=1.0)
    assert tribos.modes(viscous, 0.5).final_mode is None
    assert tribos.modes(viscous, 0.5, initial_ratio=0.7).final_ratio == 0.7


def test_a_start_is_a_ratio() -> None:
    ends = [tribos.modes(PUCK, initial_ratio=ratio).final_mode for ratio in (0.0, 2.0, math.inf)]
    assert ends == ["spinning", "together", "sliding"]
    for bad in (-1.0, math.nan, "fast"):
        with pytest.raises(ValueError, match="initial_ratio must be"):
            tribos.modes(PUCK, initial_ratio=bad)  # type: ignore[arg-type]


def test_a_tall_body_settles_at_a_larger_ratio() -> None:
    flat, tall = (tribos.modes(PUCK, 0.5, lean=lean).final_ratio for lean in (0.0, 0.8))
    assert flat is not None and tall is not None and tall > flat
    for lean in (-0.1, 1.1, math.nan):
        with pytest.raises(ValueError, match="lean"):
            tribos.modes(PUCK, 0.5, lean=lean)


# Launches to a pose


def test_a_launch_comes_to_rest_at_the_wanted_pose() -> None:
    rng = np.random.default_rng(3)
    for order, alpha in ((0.0, 0.0), (0.5, -0.5), (-1.0, 0.5)):
        friction = tribos.Friction(PATCHES[order], mu=0.4, alpha=alpha)
        for _ in range(5):
            x, y, angle = rng.normal(size=3)
            limits: dict[str, Any] = {"max_speed": 1e3, "max_spin": 1e3}
            (throw,) = tribos.inverse(friction, x, y, angle, turns="exact", **limits)
            rest = tribos.slide(friction, throw.speed, throw.spin)
            along = np.array(throw.velocity) / throw.speed * rest.distance
            np.testing.assert_allclose([*along, rest.angle], [x, y, angle], rtol=1e-12)
            assert rest.time == pytest.approx(throw.time, rel=1e-12)


def test_a_throw_is_found_again() -> None:
    rest = tribos.slide(PUCK, 1.3, -7.0)
    found = tribos.inverse(
        PUCK, 0.0, rest.distance, rest.angle, turns="exact", max_speed=2.0, max_spin=10.0
    )
    assert len(found) == 1
    assert found[0].twist == pytest.approx((0.0, 1.3, -7.0), abs=1e-11)
    assert found[0].energy_per_mass == pytest.approx(0.5 * (1.3**2 + 0.5 * (7 * 0.08) ** 2))


def test_every_number_of_turns_is_listed_once_by_energy() -> None:
    wanted: dict[str, Any] = {"max_speed": 3.0, "max_spin": 60.0, "symmetry": 4}
    found = tribos.inverse(PUCK, 1.0, 0.2, 0.3, **wanted)
    quarters = sorted((throw.angle - 0.3) / (math.pi / 2) for throw in found)
    np.testing.assert_allclose(np.diff(quarters), 1.0, atol=1e-9)
    energies = [throw.energy_per_mass for throw in found]
    assert energies == sorted(energies) and len(found) > 8
    assert all(throw.speed <= 3.0 and abs(throw.spin) <= 60.0 for throw in found)
    few = tribos.inverse(PUCK, 1.0, 0.2, 0.3, most=3, **wanted)
    assert sorted(abs(t.turns) for t in few) == sorted(abs(t.turns) for t in found)[:3]


def test_the_command_finds_the_same_launches() -> None:
    found = tribos.inverse(PUCK, 1.2, 0.3, 1.57, max_speed=3.0, max_spin=100.0)
    given: dict[str, Any] = {"x": 1.2, "y": 0.3, "angle": 1.57, "coefficient": 0.3, "radius": 0.08}
    given |= {"inertia-ratio": 0.5, "max-speed": 3, "max-spin": 100, "format": "json"}
    words = [word for name, value in given.items() for word in (f"--{name}", str(value))]
    run = "import sys; from tribos._command import main; sys.exit(main())"
    done = subprocess.run(
        [sys.executable, "-c", run, "inverse", *words], capture_output=True, text=True, check=True
    )
    rows = json.loads(done.stdout)
    assert len(rows) == len(found)
    for row, throw in zip(rows, found, strict=True):
        assert [row["vx"], row["vy"], row["spin"]] == list(throw.twist)
        assert (row["time"], row["turns"]) == (throw.time, throw.turns)


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        ({"x": 10.0}, "out of reach: 10.000000 m away.*limits are 3 m/s"),
        ({"max_spin": 1e6}, "lower the largest spin"),
        ({"max_speed": -1.0}, "the largest speed must be finite and not negative"),
        ({"turns": "any"}, "turns must be 'modulo' or 'exact'"),
        ({"symmetry": 0}, "symmetry must be from 1"),
        ({"most": 1.5}, "most must be a whole number"),
        ({"angle": math.nan}, "angle must be a finite number"),
        ({"friction": tribos.Friction(tribos.disk(0.1), mu=0.3, alpha=1.5)}, "alpha < 1"),
    ],
)
def test_poses_out_of_reach_are_refused_with_the_reason(given: dict[str, Any], reason: str) -> None:
    wanted = {"friction": PUCK, "x": 1.0, "y": 0.0, "angle": 0.0}
    wanted |= {"max_speed": 3.0, "max_spin": 60.0}
    with pytest.raises(ValueError, match=reason):
        tribos.inverse(**{**wanted, **given})


# Steps of bodies that are pushed


@pytest.mark.parametrize("shape", SHAPES)
def test_a_step_obeys_newton_and_loses_energy(shape: str) -> None:
    body, twists, pushes = crates(shape)
    dt = 0.01
    step = body.step(twists, pushes, dt)
    rates = np.stack([body.mass, body.mass, body.inertia], axis=-1)
    change = rates * (step.twists - twists) / dt
    np.testing.assert_allclose(change, pushes + step.friction, atol=1e-9)
    # Friction is one that the patch carries.
    surface = tribos.LimitSurface(SHAPES[shape], 0.4, body.load)
    assert (surface.gauge(step.friction) <= 1.0 + 1e-9).all()
    # Its work over the step, and without a push all change of energy, is negative.
    sliding = ~step.at_rest
    power = (step.friction * (twists + step.twists)).sum(-1)
    assert (power[sliding] <= 1e-12).all()
    free = body.step(twists, ZERO, dt)
    assert (body.energy(free.twists) <= body.energy(twists)).all()
    assert free.at_rest.any() and sliding.any() and step.at_rest.any()


@pytest.mark.parametrize("shape", SHAPES)
def test_what_friction_holds_rests_to_the_bit(shape: str) -> None:
    friction = tribos.Friction(SHAPES[shape], mu=0.4)
    body = tribos.PlanarBody(friction, 2.0, 0.02)
    push = np.array([[3.0, 4.0, 0.0], [0.0, 0.0, 0.1], [7.7, 0.0, 0.0], [8.0, 0.0, 0.0]])
    step = body.step(np.zeros((4, 3)), push, 0.1)  # it carries 7.848 N
    if shape in ("leaning", "mesh"):  # a force through the origin turns them
        push, step = push[1:2], body.step(ZERO, push[1:2], 0.1)
        assert step.at_rest.all()
    else:
        assert step.at_rest.tolist() == [True, True, True, False]
    assert np.array_equal(step.friction[step.at_rest], -push[step.at_rest])
    assert np.array_equal(step.twists[step.at_rest], 0.0 * push[step.at_rest])


def test_a_step_of_pure_sliding_has_its_closed_form() -> None:
    body = tribos.PlanarBody(PUCK, mass=[0.2, 2.0], inertia=[1e-3, 1e-2])
    step = body.step([1.0, 0.0, 0.0], ZERO, 0.01)
    wanted = [1.0 - 0.3 * GRAVITY * 0.01, 0.0, 0.0]
    np.testing.assert_allclose(step.twists, [wanted, wanted], atol=1e-15)
    assert step.at_rest.dtype == bool and not step.at_rest.any()


@pytest.mark.parametrize("shape", ["disk", "box", "leaning", "points"])
def test_a_turned_body_is_one_seen_from_turned_axes(shape: str) -> None:
    body, twists, pushes = crates(shape)
    angle = np.linspace(-7.0, 7.0, len(twists))
    turn = np.zeros((len(twists), 3, 3))
    turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
    turn[:, 1, 0] = np.sin(angle)
    turn[:, 0, 1], turn[:, 2, 2] = -np.sin(angle), 1.0
    flat = body.step(twists, pushes, 0.01)
    turned = [(turn @ rows[..., None])[..., 0] for rows in (twists, pushes, *flat[:2])]
    step = body.step(turned[0], turned[1], 0.01, angle=angle)
    np.testing.assert_allclose(step.twists, turned[2], atol=1e-9)
    np.testing.assert_allclose(step.friction, turned[3], atol=1e-8)
    assert np.array_equal(step.at_rest, flat.at_rest)
    other = body.step(turned[0], turned[1], 0.01)
    assert (abs(other.twists - step.twists).max() > 1e-3) == (shape != "disk")


@pytest.mark.parametrize("shape", ["disk", "box", "points"])
def test_bodies_together_are_bodies_alone_whatever_the_threads(shape: str) -> None:
    body, twists, pushes = crates(shape)
    turned = np.linspace(-3.0, 3.0, len(twists))
    whole, courses = [], []
    for threads in (1, 3):
        tribos.set_num_threads(threads)
        whole.append(body.step(twists, pushes, 0.01, angle=turned))
        courses.append(body.rollout(twists, np.repeat(pushes[:, None], 20, axis=1), 0.01))
    for one, two in (*zip(*whole, strict=True), *zip(*courses, strict=True)):
        assert np.array_equal(one, two)
    for k in range(0, len(twists), 29):
        alone = tribos.PlanarBody(body.friction, body.mass[k], body.inertia[k], load=body.load[k])
        step = alone.step(twists[k], pushes[k], 0.01, angle=turned[k])
        assert np.array_equal(step.twists, whole[0].twists[k])
        assert np.array_equal(step.friction, whole[0].friction[k])
        assert step.at_rest is bool(whole[0].at_rest[k])


@pytest.mark.parametrize("shape", ["disk", "hertz", "box"])
def test_bodies_alike_are_bodies_alone_under_one_load_and_under_many(shape: str) -> None:
    _, twists, pushes = crates("disk", 150)
    patch = tribos.hertz(0.1) if shape == "hertz" else SHAPES[shape]
    body = tribos.PlanarBody(tribos.Friction(patch, mu=0.4), 2.0, 0.02)
    angle = np.linspace(-3.0, 3.0, len(twists))
    loads = np.resize([0.0, 2.0, 20.0, 20.0, 500.0], len(twists))
    many = np.repeat(pushes[:, None], 5, axis=1)
    for load in (20.0, loads):
        step = body.step(twists, pushes, 0.01, angle=angle, load=load)
        course = body.rollout(twists, many, 0.01, load=load)
        assert step.at_rest.any() and not step.at_rest.all()
        for k, one in enumerate(np.broadcast_to(load, len(twists))):
            alone = body.step(twists[k], pushes[k], 0.01, angle=angle[k], load=float(one))
            path = body.rollout(twists[k], many[k], 0.01, load=float(one))
            for got, wanted in (*zip(step, alone, strict=True), *zip(course, path, strict=True)):
                assert np.array_equal(got[k], wanted)


def test_arguments_broadcast() -> None:
    body = tribos.PlanarBody(PUCK, mass=np.array([[1.0], [2.0]]), inertia=0.01)
    dt = np.array([0.01, 0.02, 0.03])
    step = body.step([1.0, 0.0, 2.0], ZERO, dt, load=10.0)
    assert step.twists.shape == (2, 3, 3) and step.at_rest.shape == (2, 3)
    for i, k in itertools.product(range(2), range(3)):
        one = tribos.PlanarBody(PUCK, float(body.mass[i, 0]), 0.01, load=10.0)
        assert np.array_equal(one.step([1.0, 0.0, 2.0], ZERO, dt[k]).twists, step.twists[i, k])
    with pytest.raises(ValueError, match="broadcast.*twists.*mass"):
        body.step(np.zeros((4, 5, 3)), ZERO, 0.01)


def test_out_may_be_the_twists_themselves() -> None:
    body, twists, pushes = crates()
    wanted = body.step(twists, pushes, 0.01).twists
    step = body.step(twists, pushes, 0.01, out=twists)
    assert step.twists is twists and np.array_equal(twists, wanted)
    single = np.zeros(twists.shape, dtype=np.float32)
    body.step(wanted, pushes, 0.01, out=single)
    assert single.any()


def test_nan_stays_with_its_body() -> None:
    body, twists, pushes = crates("disk", 4)
    clean = body.step(twists, pushes, 0.01)
    twists[1, 0] = pushes[2, 2] = np.nan
    step = body.step(twists, pushes, 0.01)
    assert np.isnan(step.twists[1:3]).any(axis=1).all() and not step.at_rest[1:3].any()
    assert np.array_equal(step.twists[[0, 3]], clean.twists[[0, 3]])


@pytest.mark.parametrize("shape", ["disk", "leaning"])
def test_a_rollout_is_a_loop_of_steps_to_the_bit(shape: str) -> None:
    body, twists, _ = crates(shape, 8)
    pushes = np.random.default_rng(5).normal(size=(8, 30, 3)) * [5.0, 5.0, 0.3]
    dt = 0.02
    pose = np.random.default_rng(6).normal(size=(8, 3))
    course = body.rollout(twists, pushes, dt, poses=pose)
    assert course.twists.shape == course.poses.shape == (8, 30, 3)
    assert course.at_rest.shape == (8, 30) and course.at_rest.any()
    for k in range(30):
        angle = pose[:, 2] + 0.5 * dt * twists[:, 2]
        step = body.step(twists, pushes[:, k], dt, angle=angle)
        pose = pose + 0.5 * dt * (twists + step.twists)
        twists = step.twists
        assert np.array_equal(course.twists[:, k], twists)
        assert np.array_equal(course.poses[:, k], pose)
        assert np.array_equal(course.at_rest[:, k], step.at_rest)


def test_the_end_of_a_rollout_is_the_rest() -> None:
    rest = tribos.slide(PUCK, 1.0, 5.0)
    body = tribos.PlanarBody(PUCK, 1.0, 0.5 * 0.08**2)
    for dt in (1e-3, 1e-4):
        course = body.rollout([1.0, 0.0, 5.0], np.zeros((int(0.4 / dt), 3)), dt)
        stop = (np.argmax(course.at_rest) + 1) * dt
        assert abs(stop - rest.time) < 2 * dt
        pose = course.poses[-1]
        np.testing.assert_allclose(pose, [rest.distance, 0.0, rest.angle], atol=dt * 0.05)
        assert np.array_equal(course.twists[-1], ZERO)


@pytest.mark.parametrize("shape", ["box", "triangle", "ell"])
def test_plates_that_turn_rest_where_the_table_says(shape: str) -> None:
    outlines = {
        "box": [(-0.15, -0.05), (0.15, -0.05), (0.15, 0.05), (-0.15, 0.05)],
        "triangle": [(0.0, 0.0), (0.3, 0.0), (0.0, 0.2)],
        "ell": [(0.0, 0.0), (0.4, 0.0), (0.4, 0.1), (0.1, 0.1), (0.1, 0.4), (0.0, 0.4)],
    }
    corners = np.array(outlines[shape])
    corners = corners - tribos.polygon(corners).centre
    rows = [row for row in table("plates.csv") if row["shape"] == shape]
    assert len(rows) > 1
    patch = tribos.polygon(corners)
    for text in rows:
        row = {name: float(value) for name, value in text.items() if name != "shape"}
        gyration = row["gyration"] or polar_gyration(corners)
        body = tribos.PlanarBody(tribos.Friction(patch, mu=row["mu"]), 1.0, gyration**2)
        start, pose = [row["v0"], 0.0, row["spin0"]], [0.0, 0.0, row["orientation"]]
        errors = []
        for steps in (1000, 2000):
            pushes = np.zeros((steps + steps // 20, 3))
            course = body.rollout(start, pushes, row["t_stop"] / steps, poses=pose)
            wanted = np.add(pose, [row[name] for name in ("x", "y", "angle")])
            errors.append(np.abs(course.poses[-1] - wanted).max())
            assert course.at_rest[-1] and not course.at_rest[steps - 5]
        # Of second order in the step.
        assert errors[1] < 1e-7 and 3.5 < errors[0] / errors[1] < 6.0


def polar_gyration(corners: Any) -> float:
    """Radius of gyration of an outline about its centre, which is the origin."""
    x, y = corners.T
    nx, ny = np.roll(corners, -1, axis=0).T
    cross = x * ny - nx * y
    second = (cross * (x * x + x * nx + nx * nx + y * y + y * ny + ny * ny)).sum() / 12.0
    return math.sqrt(second / (0.5 * cross.sum()))


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        ({"mass": 0.0}, "mass"),
        ({"mass": [1.0, -1.0]}, "mass"),
        ({"inertia": math.nan}, "inertia must be > 0"),
        ({"mass": 1e-300, "inertia": 1e300}, "radius of gyration"),
        ({"load": -1.0}, "load must be >= 0"),
        ({"load": math.nan}, "load must be >= 0 and finite"),
        ({"friction": tribos.Friction(tribos.disk(0.1), mu=1.0, alpha=0.5)}, "no limit surface"),
        ({"friction": 0.3}, "must be a tribos.Friction"),
    ],
)
def test_bodies_that_make_no_sense_are_refused(given: dict[str, Any], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        tribos.PlanarBody(**{"friction": PUCK, "mass": 1.0, "inertia": 0.01, **given})


def test_steps_that_make_no_sense_are_refused() -> None:
    body = tribos.PlanarBody(PUCK, 1.0, 0.01)
    for dt in (0.0, -0.1, math.inf, math.nan):
        with pytest.raises(ValueError, match="time step"):
            body.step(ZERO, ZERO, dt)
    with pytest.raises(ValueError, match=r"twists must have shape \(\.\.\., 3\)"):
        body.step([1.0, 2.0], ZERO, 0.01)
    with pytest.raises(ValueError, match="steps, 3"):
        body.rollout(ZERO, ZERO, 0.01)
    with pytest.raises(AttributeError, match="immutable"):
        body.mass = 2.0
    with pytest.raises(ValueError, match="read-only"):
        tribos.PlanarBody(PUCK, [1.0, 2.0], 0.01).mass[0] = 3.0
    assert body.rollout(ZERO, np.zeros((0, 3)), 0.01).twists.shape == (0, 3)
    assert body.step(np.zeros((0, 3)), ZERO, 0.01).at_rest.shape == (0,)


# Laws with a state

JOINT = tribos.LuGre(
    coulomb_force=4.0,
    static_force=6.0,
    stribeck_speed=0.1,
    stiffness=1e5,
    bristle_damping=700.0,
    viscous_damping=0.4,
)
ROCK: dict[str, Any] = {
    "mu": 0.6,
    "a": 0.01,
    "b": 0.015,
    "reference_speed": 1e-6,
    "slip_distance": 1e-5,
}


def test_bristles_hold_a_block_without_creep() -> None:
    # Pulled ever harder, but slowly, to a force f: dx = dz/(1 - z/z_s), x = -z_s log(1 - f/f_s).
    dt, pull = 1e-4, np.array([1.0, 3.0, 5.0])
    place, velocity, deflection = np.zeros(3), np.zeros(3), np.zeros(3)
    held = None
    for step in range(40_000):
        force_now = pull * math.sin(0.5 * math.pi * min(1.0, step / 20_000)) ** 2
        deflection, force = JOINT.step(deflection, velocity, dt)
        velocity = velocity + dt * (force_now - force)
        place = place + dt * velocity
        if step == 30_000:
            held = place
    assert held is not None
    np.testing.assert_allclose(held, -6e-5 * np.log(1.0 - pull / 6.0), rtol=1e-3)
    np.testing.assert_allclose(place, held, atol=1e-12)
    np.testing.assert_allclose(deflection, pull / 1e5, rtol=1e-9)


def test_bristles_slide_steadily_with_the_force_of_the_formula() -> None:
    velocity = np.array([-1.0, -0.05, 0.05, 1.0])
    carried = 4.0 + 2.0 * np.exp(-((velocity / 0.1) ** 2))
    wanted = np.sign(velocity) * carried + 0.4 * velocity
    np.testing.assert_allclose(JOINT.steady_force(velocity), wanted, rtol=1e-14)
    deflection, _ = JOINT.step(0.0, velocity, 10.0)
    np.testing.assert_allclose(deflection, np.sign(velocity) * carried / 1e5, rtol=1e-14)
    np.testing.assert_allclose(JOINT.force(deflection, velocity), wanted, rtol=1e-12)
    np.testing.assert_allclose(JOINT.rate(deflection, velocity), 0.0, atol=1e-15)


def test_a_step_of_bristles_is_the_sum_of_small_ones() -> None:
    rng = np.random.default_rng(2)
    start, velocity = rng.uniform(-6e-5, 6e-5, 50), rng.normal(size=50) * 0.01
    whole, mean = JOINT.step(start, velocity, 5e-3)
    deflection, impulse = start, 0.0
    for _ in range(500):
        # The midpoint rule on the differential equation.
        half = deflection + 5e-6 * JOINT.rate(deflection, velocity)
        impulse = impulse + 1e-5 * JOINT.force(half, velocity)
        deflection = deflection + 1e-5 * JOINT.rate(half, velocity)
    np.testing.assert_allclose(whole, deflection, rtol=1e-3, atol=1e-10)
    np.testing.assert_allclose(mean, impulse / 5e-3, rtol=1e-3, atol=1e-3)
    assert (abs(whole) <= JOINT.largest_deflection).all()
    assert JOINT.step(1e-5, 0.0, 1.0) == (1e-5, 1.0)  # at rest it is a spring


def test_rate_and_state_keeps_its_formula() -> None:
    # V, θ, μ and its slope in 40 digits, above and below the transition.
    exact = np.array(
        [
            (1e-6, 10.0, 0.6000019999999999, 10002.0),
            (1e-3, 0.01, 0.5674612236050893, 12.0),
            (1e-33, 1e3, 0.047380344358062154, 9.998466823052081e30),
            (1e-30, 1.0, 0.013531921056797524, 8.748046244687522e27),
            (10.0, 1e-6, 20.51940952174521, 2.001),
        ]
    )
    rock = tribos.RateState(**ROCK, viscous=2.0)
    speed, age, mu, slope = exact.T
    np.testing.assert_allclose(rock.friction(speed, age), mu, rtol=1e-13)
    np.testing.assert_allclose(rock.slope(speed, age), slope, rtol=1e-13)
    assert rock.friction(0.0, 1.0) == 0.0
    assert np.isnan(rock.friction(1.0, -1.0)) and np.isnan(rock.step(-1.0, 1e-6, 1.0))
    assert np.isnan(rock.friction(math.nan, 1.0)) and np.isnan(rock.step(1.0, math.nan, 1.0))


@pytest.mark.parametrize("evolution", ["ageing", "slip"])
def test_ages_follow_their_differential_equation(evolution: str) -> None:
    rock = tribos.RateState(**ROCK, evolution=evolution)
    age, speed = np.array([1.0, 10.0, 50.0]), np.array([[1e-6], [3e-6]])
    theta = np.broadcast_to(age, (2, 3))
    for _ in range(2000):

        def rate(theta: Any) -> Any:
            slid = speed * theta / 1e-5
            return 1.0 - slid if evolution == "ageing" else -slid * np.log(slid)

        theta = theta + 0.005 * rate(theta + 0.0025 * rate(theta))
    np.testing.assert_allclose(rock.step(age, speed, 10.0), theta, rtol=1e-5)
    held = rock.step(2.0, 0.0, 5.0)
    assert held == (7.0 if evolution == "ageing" else 2.0)
    np.testing.assert_allclose(rock.step(age, 1e-6, 1e4), 10.0, rtol=1e-12)
    assert rock.steady_age(1e-6) == pytest.approx(10.0, rel=1e-15)


def test_steady_rock_weakens_to_its_minimum_and_a_soft_spring_sticks() -> None:
    rock = tribos.RateState(**ROCK, viscous=2.0)
    speeds = np.geomspace(1e-6, 1e-4, 9)
    wanted = 0.6 - 0.005 * np.log(speeds / 1e-6) + 2.0 * speeds
    np.testing.assert_allclose(rock.steady_friction(speeds), wanted, rtol=1e-12)
    assert rock.slowest_speed == pytest.approx(0.005 / 2.0, rel=1e-9)
    assert rock.critical_stiffness(10.0) == pytest.approx(10.0 * 0.005 / 1e-5)
    assert rock.critical_stiffness(10.0, 1e-2) < 0.0
    assert tribos.RateState(**ROCK).slowest_speed is None


def test_laws_with_a_state_refuse_what_makes_no_sense() -> None:
    with pytest.raises(ValueError, match="static force"):
        tribos.LuGre(coulomb_force=2.0, static_force=1.0, stribeck_speed=1.0, stiffness=1.0)
    with pytest.raises(ValueError, match="stiffness must be a finite number"):
        tribos.LuGre(coulomb_force=1.0, static_force=1.0, stribeck_speed=1.0, stiffness=math.nan)
    with pytest.raises(ValueError, match="dt must be >= 0"):
        JOINT.step(0.0, 1.0, [0.1, -0.1])
    with pytest.raises(ValueError, match="evolution must be"):
        tribos.RateState(**ROCK, evolution="fast")
    with pytest.raises(ValueError, match="direct effect a"):
        tribos.RateState(**{**ROCK, "a": 0.0})


def test_everything_is_frozen_and_picklable() -> None:
    body = tribos.PlanarBody(PUCK, [1.0, 2.0], 0.01)
    again = pickle.loads(pickle.dumps(body))
    push = np.array([9.0, 0.0, 0.0])
    assert np.array_equal(again.step(ZERO, push, 0.1).twists, body.step(ZERO, push, 0.1).twists)
    (throw,) = tribos.inverse(PUCK, 1, 0, 0, turns="exact", max_speed=5, max_spin=5)
    last = tribos.modes(PUCK)
    rest = tribos.slide(PUCK, 1.0, 5.0)
    rock = tribos.RateState(**ROCK, evolution="slip")
    for one in (throw, last, rest, JOINT, rock):
        assert pickle.loads(pickle.dumps(one)) == one
        assert type(one).__name__ in repr(one)
    for law in (JOINT, rock):
        assert eval(repr(law)) == law and hash(eval(repr(law))) == hash(law)
    with pytest.raises(dataclasses.FrozenInstanceError):
        throw.spin = 1.0  # type: ignore[misc]
    with pytest.raises(AttributeError):
        rest.time = 1.0  # type: ignore[misc]


FEET = tribos.Friction(tribos.points([[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]), mu=0.3)


@pytest.mark.parametrize("dt", [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7])
@pytest.mark.parametrize("inertia", [0.3, 0.003])
def test_a_step_on_four_feet_has_no_more_friction_than_they_carry(dt, inertia):
    body = tribos.PlanarBody(FEET, mass=5.0, inertia=inertia, load=50.0)
    surface = FEET.limit_surface(load=50.0)
    twists = np.random.default_rng(0).normal(size=(2000, 3)) * [3.0, 3.0, 30.0]
    step = body.step(twists, np.zeros(3), dt=dt)
    assert surface.gauge(step.friction).max() < 1.0 + 1e-9
    assert (body.energy(step.twists) <= body.energy(twists) * (1.0 + 1e-12)).all()


def test_static_friction_holds_until_it_is_exceeded_and_equal_coefficients_change_no_bit() -> None:
    crate = tribos.Friction(tribos.box(0.4, 0.3), mu=0.5)
    rng = np.random.default_rng(4)
    twists, pushes = rng.normal(size=(40, 3)), 40.0 * rng.normal(size=(40, 3))
    plain = tribos.PlanarBody(crate, mass=8.0, inertia=0.17, load=80.0)
    same = tribos.PlanarBody(crate, mass=8.0, inertia=0.17, load=80.0, mu_s=0.5)
    assert np.array_equal(
        plain.step(twists, pushes, 0.01).twists, same.step(twists, pushes, 0.01).twists
    )
    # 40 N in motion, 56 N at rest, whatever the step.
    stuck = tribos.PlanarBody(crate, mass=8.0, inertia=0.17, load=80.0, mu_s=0.7)
    share = np.array([[1.0 - 1e-9, 0.0, 0.0], [1.0 + 1e-9, 0.0, 0.0]])
    for dt in (1e-5, 1e-2, 1.0):
        step = stuck.step(np.zeros((2, 3)), 56.0 * share, dt)
        assert list(step.at_rest) == [True, False]
        assert np.isclose(step.twists[1, 0], 16.0 / 8.0 * dt)
    with pytest.raises(ValueError, match="mu_s must be at least"):
        tribos.PlanarBody(crate, mass=8.0, inertia=0.17, mu_s=0.4)
