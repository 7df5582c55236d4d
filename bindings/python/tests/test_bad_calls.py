"""Calls that cannot be right end in an error that says why, and the interpreter lives on."""

import gc
import sys

import numpy as np
import pytest

import tribos

NAN, INF = float("nan"), float("inf")
PUCK = tribos.Friction(tribos.disk(0.04), mu=0.3)
BOX = tribos.Friction(tribos.box(0.3, 0.2), mu=0.3)
ICE = PUCK.limit_surface(1.7)
READ_ONLY = np.zeros(3)
READ_ONLY.flags.writeable = False

# What no length, coefficient or count is.
NO_NUMBERS = ["0.1", "x", None, [], [0.1, 0.2], {}, object(), 1j, NAN, INF, -INF]
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
    object(),
    {1, 2, 3},
    np.zeros(3, dtype="datetime64[s]"),
    np.zeros(3, dtype=object),
    np.zeros(3, dtype=[("x", float)]),
]
NO_LOADS = [-1.0, -INF, -1e-300, "x", None, 1j, object(), [[1.0], [2.0, 3.0]], [-1.0, 1.0]]
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


def calls() -> list[object]:
    """Every call with its name."""
    made: list[tuple[str, object]] = []

    def add(name: str, function: object, values: list[object]) -> None:
        made.extend((f"{name}({value!r})"[:80], (function, value)) for value in values)

    for maker in (tribos.disk, tribos.ring, tribos.hertz, tribos.punch, tribos.paraboloid, tribos.bar):
        add(maker.__name__, maker, NOT_POSITIVE)
    add("annulus outer", lambda x: tribos.annulus(0.03, x), [0.03, 0.02, *NOT_POSITIVE])
    add("annulus inner", lambda x: tribos.annulus(x, 0.04), [-0.01, 0.04, 0.05, *NO_NUMBERS])
    add("power", lambda x: tribos.power(0.1, x), [-1.5, 1e9, *NO_NUMBERS])
    add("polynomial", lambda x: tribos.polynomial(0.1, x), [[], [0.0], [-1.0], [1.0, -2.0], [NAN], ["a"]])
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
    meshes = [[[0, 1, 3]], [[0, 1, -1]], [[0, 1]], [], [[0.0, 1.0, 2.0]], [[0, 0, 1]], None, [["a"] * 3]]
    add("mesh triangles", lambda x: tribos.mesh(TRIANGLE, x, [1, 1, 1]), meshes)
    pressures = [[1, 1], [-1, 1, 1], [0, 0, 0], [NAN, 1, 1], None, "abc", [[1, 1, 1], [1, 1, 1]]]
    add("mesh pressure", lambda x: tribos.mesh(TRIANGLE, [[0, 1, 2]], x), pressures)
    places = [[], [[0, 0]], [[0, 0], [0, 0]], [[NAN, 0], [1, 0]], [[0, 0, 0], [1, 1, 1]], None]
    add("points", tribos.points, places)
    weights = [[1], [-1, 1, 1], [0, 0, 0], [NAN, 1, 1], [1, 0, 0], "abc"]
    add("weights", lambda x: tribos.points(TRIANGLE, x), weights)
    add("mu", lambda x: tribos.Friction(tribos.disk(1.0), mu=x), [-0.1, -1e-300, *NO_NUMBERS])
    exponents = [-1.0, -2.0, 1e9, *(value for value in NO_NUMBERS if value is not None)]
    add("alpha", lambda x: tribos.Friction(tribos.disk(1.0), mu=1.0, alpha=x), exponents)
    add("square alpha", lambda x: tribos.Friction(tribos.box(1, 1), mu=1.0, alpha=x), [-1.0, 11.0])
    add("tier", lambda x: tribos.Friction(tribos.disk(1.0), mu=1.0, tier=x), ["", "fast", "Table"])
    add("tier of a box", lambda x: tribos.Friction(tribos.box(1, 1), mu=1.0, tier=x), ["table"])
    add("patch", lambda x: tribos.Friction(x, mu=1.0), [None, "disk", 0.1, ICE, PUCK, object()])
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
    add("law on a bar", lambda x: tribos.Friction(tribos.bar(1.0), law=x), ["power:gamma=1,alpha=1"])
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
    add("surface of oil", lambda x: x.limit_surface(1.0), [tribos.Friction(tribos.disk(1.0), mu=1, alpha=1)])
    return [pytest.param(*call, id=name) for name, call in made]


CALLS = calls()


@pytest.mark.parametrize(("function", "value"), CALLS)
def test_a_bad_call_says_why(function, value) -> None:
    with pytest.raises(ValueError, match=r"\w+ \w+") as told:
        function(value)
    assert "object at 0x" not in str(told.value) or "object" in repr(value)


def test_there_are_enough_of_them() -> None:
    assert len(CALLS) >= 300


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
