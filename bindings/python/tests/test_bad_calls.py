"""Calls that cannot be right end in an error that says why, and the interpreter lives on."""

import gc
import sys
from collections.abc import Callable

import numpy as np
import pytest
import tribos

NAN, INF = float("nan"), float("inf")
PUCK = tribos.Friction(tribos.disk(0.04), mu=0.3)
BOX = tribos.Friction(tribos.box(0.3, 0.2), mu=0.3)
ICE = PUCK.limit_surface(1.7)
READ_ONLY = np.zeros(3)
READ_ONLY.flags.writeable = False


class Something:
    """No kind of argument, with the same name in every process."""

    def __repr__(self) -> str:
        return "something"


SOMETHING = Something()
# What no length, coefficient or count is.
NO_NUMBERS = ["0.1", "x", None, [], [0.1, 0.2], {}, SOMETHING, 1j, NAN, INF, -INF]
NOT_POSITIVE = [0.0, -0.0, -1.0, -1e-300, *NO_NUMBERS]
# What no array of twists or wrenches is.
NO_ROWS = [
    None,
    "abc",
    1.0,
    [],
    [1.0, 2.0],
    [1.0, 2.0, 3.0, 4.0],
    [[1.0, 2.0], [3.0]],
    np.zeros((3, 2)),
    np.zeros((3, 0)),
    ["a", "b", "c"],
    [1j, 0.0, 0.0],
    [None, 0.0, 0.0],
    SOMETHING,
    {1, 2, 3},
    np.zeros(3, dtype="datetime64[s]"),
    np.zeros(3, dtype=object),
    np.zeros(3, dtype=[("x", float)]),
]
NO_LOADS = [-1.0, -INF, -1e-300, "x", None, 1j, SOMETHING, [[1.0], [2.0, 3.0]], [-1.0, 1.0]]
NO_OUTPUTS = [
    [0.0, 0.0, 0.0],
    3.0,
    "out",
    np.zeros(2),
    np.zeros((3, 1)),
    np.zeros(3, dtype=int),
    np.zeros(3, dtype=complex),
    np.zeros(3, dtype=bool),
    READ_ONLY,
]
TRIANGLE = [[0, 0], [1, 0], [0, 1]]
BOOK = tribos.LimitSurface(tribos.box(0.3, 0.2), mu=0.4, load=20.0)
FINGER = tribos.PointContact([0.05, -0.1], [0.0, 1.0], mu=0.3)
CRATE = tribos.PlanarBody(BOX, mass=8.0, inertia=0.17)
BALL = tribos.Spheres(mass=1.0, radius=0.1)
RUBBER = tribos.ContactLaw(mu=0.5)
BRISTLES = {"coulomb_force": 4.0, "static_force": 6.0, "stribeck_speed": 1e-3, "stiffness": 1e5}
GRANITE = {"mu": 0.6, "a": 0.01, "b": 0.015, "reference_speed": 1e-6, "slip_distance": 1e-5}


def calls() -> list[object]:
    """Every call with its name."""
    made: list[tuple[str, object]] = []

    def add(name: str, function: object, values: list[object]) -> None:
        made.extend((f"{name}({value!r})"[:80], (function, value)) for value in values)

    for maker in (
        tribos.disk,
        tribos.ring,
        tribos.hertz,
        tribos.punch,
        tribos.paraboloid,
        tribos.bar,
    ):
        add(maker.__name__, maker, NOT_POSITIVE)
    add("annulus outer", lambda x: tribos.annulus(0.03, x), [0.03, 0.02, *NOT_POSITIVE])
    add("annulus inner", lambda x: tribos.annulus(x, 0.04), [-0.01, 0.04, 0.05, *NO_NUMBERS])
    add("power", lambda x: tribos.power(0.1, x), [-1.5, 1e9, *NO_NUMBERS])
    add(
        "polynomial",
        lambda x: tribos.polynomial(0.1, x),
        [[], [0.0], [-1.0], [1.0, -2.0], [NAN], ["a"]],
    )
    add("box", lambda x: tribos.box(0.3, x), NOT_POSITIVE)
    centres = [(0.2, 0.0), (0.06, 0.0), (NAN, 0.0), (0.0,), (0.0, 0.0, 0.0), "ab", 3.0]
    add("box centre", lambda x: tribos.box(0.3, 0.2, centre=x), centres)
    corners = [
        None,
        [],
        [[0, 0]],
        [[0, 0], [1, 0]],
        [[0, 0], [1, 0], [2, 0]],
        [[0, 0], [1, 1], [1, 0], [0, 1]],
        [[0, 0], [1, 0], [NAN, 1]],
        [[0, 0], [1, 0], [INF, 1]],
        [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
        [0, 1, 2],
        "square",
        [[0, 0], [1, 0], [0, "a"]],
    ]
    add("polygon", tribos.polygon, corners)
    add("hole", lambda x: tribos.polygon([[0, 0], [4, 0], [0, 4]], holes=[x]), corners)
    meshes = [
        [[0, 1, 3]],
        [[0, 1, -1]],
        [[0, 1]],
        [],
        [[0.0, 1.0, 2.0]],
        [[0, 0, 1]],
        None,
        [["a"] * 3],
    ]
    add("mesh triangles", lambda x: tribos.mesh(TRIANGLE, x, [1, 1, 1]), meshes)
    pressures = [[1, 1], [-1, 1, 1], [0, 0, 0], [NAN, 1, 1], None, "abc", [[1, 1, 1], [1, 1, 1]]]
    add("mesh pressure", lambda x: tribos.mesh(TRIANGLE, [[0, 1, 2]], x), pressures)
    places = [[], [[0, 0]], [[0, 0], [0, 0]], [[NAN, 0], [1, 0]], [[0, 0, 0], [1, 1, 1]], None]
    add("points", tribos.points, places)
    weights = [[1], [-1, 1, 1], [0, 0, 0], [NAN, 1, 1], [1, 0, 0], "abc"]
    add("weights", lambda x: tribos.points(TRIANGLE, x), weights)
    # Two coefficients along two axes are numbers; the lists here are not.
    mu = [value for value in NO_NUMBERS if value != [0.1, 0.2]]
    pairs = [[0.1, 0.0], [-0.1, 0.2], [0.1, NAN], [0.1, 0.2, 0.3]]
    add("mu", lambda x: tribos.Friction(tribos.disk(1.0), mu=x), [-0.1, -1e-300, *mu, *pairs])
    exponents = [-1.0, -2.0, 1e9, *(value for value in NO_NUMBERS if value is not None)]
    add("alpha", lambda x: tribos.Friction(tribos.disk(1.0), mu=1.0, alpha=x), exponents)
    add("square alpha", lambda x: tribos.Friction(tribos.box(1, 1), mu=1.0, alpha=x), [-1.0, 11.0])
    add("tier", lambda x: tribos.Friction(tribos.disk(1.0), mu=1.0, tier=x), ["", "fast", "Table"])
    add("tier of a box", lambda x: tribos.Friction(tribos.box(1, 1), mu=1.0, tier=x), ["table"])
    add("patch", lambda x: tribos.Friction(x, mu=1.0), [None, "disk", 0.1, ICE, PUCK, SOMETHING])
    laws = [
        "",
        "none",
        "coulomb",
        "coulomb:mu=-1",
        "coulomb:mu=nan",
        "coulomb:mu=1,mu=1",
        "stribeck:mu_s=0.4",
        "stribeck:mu_s=0.1,mu_d=0.2,vs=0.1",
        "lugre-bristles",
        "power:gamma=1,alpha=-1",
        3,
        None,
    ]
    add("law", tribos.Law, laws)
    add("friction law", lambda x: tribos.Friction(tribos.disk(1.0), law=x), laws)
    add("law parameter", lambda x: tribos.Law("coulomb", mu=x), [-1.0, *NO_NUMBERS])
    add(
        "law on a bar", lambda x: tribos.Friction(tribos.bar(1.0), law=x), ["power:gamma=1,alpha=1"]
    )
    for name, friction in (("puck", PUCK), ("box", BOX)):
        add(f"{name} wrench", lambda x, f=friction: f.wrench(x, 1.0), NO_ROWS)
        add(f"{name} load", lambda x, f=friction: f.wrench([1.0, 0.0, 0.0], x), NO_LOADS)
    add("jacobian", lambda x: PUCK.jacobian(x, 1.0), NO_ROWS)
    add("out", lambda x: PUCK.wrench([1.0, 0.0, 0.0], 1.0, out=x), NO_OUTPUTS)
    add("surface load", PUCK.limit_surface, [NAN, INF, *NO_LOADS])
    for method in ("gauge", "normal", "project", "support", "wrench", "scale_to_surface"):
        add(method, getattr(ICE, method), NO_ROWS)
    add("length", lambda x: ICE.project([1.0, 0.0, 0.0], length=x), [0.0, -1.0, NAN, INF])
    wide = [np.zeros((4, 3)), np.zeros((2, 2, 3))]
    add("axes", lambda x: PUCK.wrench(x, [1.0, 2.0, 3.0]), wide)
    add("threads", tribos.set_num_threads, [0, -1, 10**9])
    of_motion(add)
    of_contacts(add)
    of_scenes(add)
    add(
        "surface of oil",
        lambda x: x.limit_surface(1.0),
        [tribos.Friction(tribos.disk(1.0), mu=1, alpha=1)],
    )
    return [pytest.param(*call, id=name) for name, call in made]


def of_motion(add: Callable[..., None]) -> None:
    """Throws, launches, steps."""
    for name in ("inertia_ratio", "gravity"):
        add(
            f"slide {name}",
            lambda x, n=name: tribos.slide(PUCK, 1.0, 1.0, **{n: x}),
            [-1.0, "x", None, 1j],
        )
    speeds = ["x", None, 1j, [[1.0], [1.0, 2.0]], SOMETHING]
    add("slide speed", lambda x: tribos.slide(PUCK, x, 1.0), speeds)
    add("slide of", lambda x: tribos.slide(x, 1.0, 1.0), [None, "puck", tribos.disk(1.0), ICE, BOX])
    viscous = tribos.Friction(tribos.disk(1.0), mu=1.0, alpha=1.0)
    add("slide without rest", lambda x: tribos.slide(x, 1.0, 1.0), [viscous])
    add("slide axes", lambda x: tribos.slide(PUCK, x, [1.0, 2.0, 3.0]), [[1.0, 2.0]])
    throw = {"max_speed": 3.0, "max_spin": 10.0}
    add("inverse x", lambda x: tribos.inverse(PUCK, x, 0.0, 0.0, **throw), [1e3, *NO_NUMBERS])
    add(
        "inverse turns",
        lambda x: tribos.inverse(PUCK, 1.0, 0.0, 0.0, turns=x, **throw),
        ["", "all", None],
    )
    limits = [-1.0, 0.0, *NO_NUMBERS]
    add(
        "inverse speed",
        lambda x: tribos.inverse(PUCK, 1.0, 0.0, 0.0, max_speed=x, max_spin=1.0),
        limits,
    )
    add("modes", lambda x: tribos.modes(PUCK, x), NOT_POSITIVE)
    add("mass", lambda x: tribos.PlanarBody(BOX, x, 1.0), NOT_POSITIVE[:5] + ["x", None, 1j])
    add("dt", lambda x: CRATE.step(np.zeros(3), np.zeros(3), x), [0.0, -1.0, NAN, INF, "x", None])
    add("twists of a step", lambda x: CRATE.step(x, np.zeros(3), 0.1), NO_ROWS)
    add("pushes of a step", lambda x: CRATE.step(np.zeros(3), x, 0.1), NO_ROWS)
    pushes = [np.zeros(3), np.zeros((4, 2)), None, "x"]
    add("rollout", lambda x: CRATE.rollout(np.zeros(3), x, 0.1), pushes)
    for name in BRISTLES:
        add(
            f"LuGre {name}",
            lambda x, n=name: tribos.LuGre(**{**BRISTLES, n: x}),
            [-1.0, NAN, "x", None],
        )
    for name in GRANITE:
        # An older contact may be stronger or weaker.
        first = {"mu": [], "b": [NAN]}.get(name, [-1.0])
        values = [*first, "x", None]
        add(
            f"rate and state {name}",
            lambda x, n=name: tribos.RateState(**{**GRANITE, n: x}),
            values,
        )
    add("softened", lambda x: tribos.softened(0.3, x), NOT_POSITIVE)


def of_contacts(add: Callable[..., None]) -> None:
    """Fingers, contacts, fits."""
    add(
        "normal of a finger",
        lambda x: tribos.PointContact([0.0, 0.0], x, mu=0.3),
        [[0.0, 0.0], "x", None],
    )
    add(
        "mu of a finger",
        lambda x: tribos.PointContact([0.0, 0.0], [0.0, 1.0], mu=x),
        [-0.1, NAN, "x"],
    )
    add("pushed", lambda x: tribos.push(x, FINGER, [0.0, 1.0]), [None, BOX, 3.0])
    add(
        "velocity of a push",
        lambda x: tribos.push(BOOK, FINGER, x),
        ["x", None, [1.0], [1.0, 2.0, 3.0]],
    )
    add("cone", lambda x: tribos.motion_cone(BOOK, x), [None, "x", [0.0, 0.0]])
    durations = [-1.0, NAN, INF, "x", None]
    add("duration", lambda x: tribos.push_along(BOOK, FINGER, [0.0, 0.02], x), durations)
    add("contact mu", lambda x: tribos.ContactLaw(mu=x), [-0.1, NAN, INF, "x", None])
    add("restitution", lambda x: tribos.ContactLaw(restitution=x), [-0.1, 1.1, NAN, "x", None])
    add("coupled", lambda x: tribos.ContactLaw(mu=0.5, patch=x), ["disk", tribos.box(1.0, 1.0)])
    add("sphere mass", lambda x: tribos.Spheres(mass=x, radius=0.1), [0.0, -1.0, NAN, "x", None])
    add("sphere radius", lambda x: tribos.Spheres(mass=1.0, radius=x), [0.0, -1.0, NAN, "x", None])
    normals = [[0.0, 0.0, 0.0], [1.0, 0.0], "x", None, [NAN, 0.0, 1.0]]
    add("normal", lambda x: RUBBER.collide(BALL, BALL, normal=x), normals)
    add(
        "steps of a manifold",
        lambda x: tribos.Manifold(RUBBER).solve(x),
        [0.0, -1.0, NAN, "x", None],
    )
    add(
        "body",
        lambda x: tribos.Manifold(RUBBER).set_force(x, (0.0, 0.0, 0.0)),
        [0, -1, 7, "x", None],
    )
    columns = [{}, {"v": [1.0]}, {"v": [1.0, 2.0], "f": [1.0]}, None, 3.0, {"v": ["a"], "f": ["b"]}]
    add("fit", lambda x: tribos.fit("power", x), columns)
    add(
        "fitted law",
        lambda x: tribos.fit(x, {"v": [1.0, 2.0, 3.0], "f": [1.0, 1.0, 1.0]}),
        ["", "no", None],
    )
    add("strokes", tribos.strokes, [*columns, {"t": [0.0, 0.0], "f": [1.0, 1.0]}])
    record = {"t": [0.0, 1.0, 2.0], "v": [1.0, 1.0, 1.0], "f": [1.0, 1.0, 1.0]}
    add("steady part", lambda x: tribos.strokes(record, middle=x), [0.0, 1.1, NAN, "x", None])
    add("rest", lambda x: tribos.strokes(record, shortest_rest=x), [-1.0, NAN, INF, "x", None])
    rows = [None, [], np.zeros((3, 5)), np.zeros((10, 6)), np.full((10, 6), NAN), "none.csv"]
    add("pushes of a fit", tribos.fit_support, rows)


def of_scenes(add: Callable[..., None]) -> None:
    """Scenes, runs, sweeps."""
    values = [-1.0, NAN, INF, "x", [], {}]
    for name in ("radius", "mass", "gamma"):
        add(f"scene {name}", lambda x, n=name: tribos.SliderScene(**{n: x}), values)
    texts = [
        "",
        "x",
        "body = 'cube'",
        "radius = 1",
        "body = 'disk'\nradius = -1",
        "body = 'disk'\nradus = 1",
    ]
    add("scene text", tribos.SliderScene.from_toml, texts[1:])
    add("named scene", tribos.scene, ["", "none", "compaction"])
    add("run threads", lambda x: tribos.run("disk", threads=x), [0, -1, "x"])
    add("run", tribos.run, ["none", 3, None, PUCK])
    add("swept key", lambda x: tribos.sweep("disk", x), [{"spn": [1.0]}, {"spin": []}])
    add("seeds", lambda x: tribos.sweep("compaction-small", {"mu_rolling": [0]}, seeds=x), [0, -1])


CALLS = calls()


@pytest.mark.parametrize(("function", "value"), CALLS)
def test_a_bad_call_says_why(function, value) -> None:
    # Files that are not there and words in place of a whole number have errors of Python's own.
    with pytest.raises((ValueError, TypeError, OSError), match=r"\w+ \w+") as told:
        function(value)
    assert "object at 0x" not in str(told.value) or "object" in repr(value)


def test_there_are_enough_of_them() -> None:
    assert len(CALLS) >= 600


@pytest.mark.parametrize("value", [NAN, INF, -INF, 1e308, 5e-324, -0.0])
def test_every_number_has_an_answer(value: float) -> None:
    for at in range(3):
        twist = np.zeros(3)
        twist[at] = value
        for friction in (PUCK, BOX):
            wrench = friction.wrench(twist, 1.7)
            assert np.isnan(wrench).any() or np.isfinite(wrench).all()
            assert not np.isnan(value) or np.isnan(wrench).all()


def memory() -> int:
    """Memory of this process, in bytes."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * 4096


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")
def test_calls_leave_nothing_behind() -> None:
    twist, twists, out = np.array([1.0, 0.0, 20.0]), np.ones((50, 3)), np.empty((50, 3))

    def work(count: int) -> None:
        for _ in range(count):
            PUCK.wrench(twist, 1.7)
            PUCK.wrench(twists, 1.7, out=out)
            ICE.gauge([0.1, 0.0, 0.0])
            try:
                PUCK.wrench(None, 1.7)
            except ValueError:
                pass

    work(2_000)
    gc.collect()
    before = memory()
    work(20_000)
    gc.collect()
    # One object of 50 bytes a call would be 4 MB.
    assert memory() - before < 2_000_000
