"""Arguments of any kind that numpy takes, and what comes back."""

import copy
import multiprocessing
import pickle
import threading

import numpy as np
import pytest
import tribos
from conftest import PATCHES
from tribos import _patches

PUCK = tribos.Friction(tribos.disk(0.04), mu=0.3)
BOX = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
RNG = np.random.default_rng(20261123)
TWISTS = RNG.normal(size=(6, 4, 3)) * [1.0, 1.0, 20.0]
LOADS = RNG.uniform(0.5, 3.0, size=(6, 4))


def one_by_one(friction: tribos.Friction, twists: np.ndarray, loads: np.ndarray) -> np.ndarray:
    result = np.empty(twists.shape)
    for index in np.ndindex(twists.shape[:-1]):
        result[index] = friction.wrench(twists[index].tolist(), float(loads[index]))
    return result


def test_a_batch_has_the_bits_of_single_calls() -> None:
    expected = one_by_one(BOX, TWISTS, LOADS)
    assert np.array_equal(BOX.wrench(TWISTS, LOADS), expected)


@pytest.mark.parametrize(
    ("twists", "loads"),
    [
        (TWISTS.tolist(), LOADS.tolist()),
        (np.asfortranarray(TWISTS), np.asfortranarray(LOADS)),
        (TWISTS[::-1][::-1], LOADS[::-1][::-1]),
        (np.concatenate((TWISTS, TWISTS), axis=-1)[..., :3], LOADS),
        (TWISTS.astype(">f8"), LOADS.astype(">f8")),
    ],
)
def test_lists_and_strides_are_taken(twists: object, loads: object) -> None:
    assert np.array_equal(BOX.wrench(twists, loads), BOX.wrench(TWISTS, LOADS))


def test_single_precision_is_taken_as_the_numbers_that_it_holds() -> None:
    twists = TWISTS.astype(np.float32)
    result = PUCK.wrench(twists, np.float32(1.5))
    assert result.dtype == np.float64
    assert np.array_equal(result, PUCK.wrench(twists.astype(np.float64), 1.5))


def test_leading_axes_are_broadcast() -> None:
    twists, loads = TWISTS[:, :1], LOADS[:1]
    result = PUCK.wrench(twists, loads)
    assert result.shape == (6, 4, 3)
    full = one_by_one(PUCK, np.broadcast_to(twists, (6, 4, 3)), np.broadcast_to(loads, (6, 4)))
    assert np.array_equal(result, full)
    assert PUCK.wrench([1.0, 0.0, 20.0], LOADS).shape == (6, 4, 3)
    assert PUCK.wrench(np.empty((0, 3)), 1.0).shape == (0, 3)
    assert PUCK.jacobian(np.empty((2, 0, 3)), np.ones((2, 1))).shape == (2, 0, 3, 3)


def test_a_number_comes_back_for_a_number() -> None:
    surface = PUCK.limit_surface(1.7)
    gauge = surface.gauge([0.1, 0.0, 0.001])
    assert isinstance(gauge, float)
    assert np.ndim(surface.gauge([[0.1, 0.0, 0.001]])) == 1


def test_results_go_to_the_given_array() -> None:
    expected = PUCK.wrench(TWISTS, LOADS)
    for dtype in (np.float64, np.float32):
        out = np.full(TWISTS.shape, 9.0, dtype=dtype)
        assert PUCK.wrench(TWISTS, LOADS, out=out) is out
        assert np.array_equal(out, expected.astype(dtype))
    strided = np.zeros((6, 4, 6))
    PUCK.wrench(TWISTS, LOADS, out=strided[..., ::2])
    assert np.array_equal(strided[..., ::2], expected)
    assert not strided[..., 1::2].any()


def test_the_array_for_results_may_be_an_argument() -> None:
    memory = np.zeros((25, 3))
    memory[1:] = TWISTS.reshape(-1, 3)
    expected = PUCK.wrench(memory[1:].copy(), 1.7)
    PUCK.wrench(memory[1:], 1.7, out=memory[:-1])
    assert np.array_equal(memory[:-1], expected)


def test_bits_do_not_depend_on_the_number_of_threads() -> None:
    twists = RNG.normal(size=(50_000, 3)) * [1.0, 1.0, 20.0]
    results = []
    for count in (1, 2, 5, None):
        tribos.set_num_threads(count)
        results.append(PUCK.wrench(twists, 1.7).tobytes())
    assert len(set(results)) == 1


def test_other_threads_run_during_a_batch() -> None:
    twists = RNG.normal(size=(400_000, 3))
    counts = [0]
    done = threading.Event()

    def count() -> None:
        while not done.is_set():
            counts[0] += 1

    other = threading.Thread(target=count)
    other.start()
    before = counts[0]
    BOX.jacobian(twists, 1.0)
    during = counts[0] - before
    done.set()
    other.join()
    assert during > 100


def wrench_in_child(queue: "multiprocessing.Queue[bytes]", twists: np.ndarray) -> None:
    queue.put(PUCK.wrench(twists, 1.7).tobytes())


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork")
def test_a_forked_process_has_threads_of_its_own() -> None:
    twists = RNG.normal(size=(50_000, 3))
    expected = PUCK.wrench(twists, 1.7).tobytes()
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=wrench_in_child, args=(queue, twists))
    child.start()
    assert queue.get(timeout=60) == expected
    child.join()


OBJECTS = [
    *PATCHES,
    tribos.Law("stribeck", mu_s=0.4, mu_d=0.2, vs=0.05),
    PUCK,
    tribos.Friction(tribos.ring(0.1), mu=0.2, alpha=0.5, tier="compact"),
    tribos.Friction(tribos.hertz(0.1), law="savkoor:mu0=0.1,mu_m=0.5,vm=0.1"),
]


def test_every_kind_of_patch_is_in_the_list() -> None:
    assert [patch.kind for patch in PATCHES] == _patches.MAKERS


@pytest.mark.parametrize("thing", OBJECTS, ids=repr)
def test_objects_are_copied_and_pickled(thing: object) -> None:
    for other in (pickle.loads(pickle.dumps(thing)), copy.deepcopy(thing)):
        assert other == thing
        assert hash(other) == hash(thing)
        assert repr(other) == repr(thing)


@pytest.mark.parametrize("thing", OBJECTS, ids=repr)
def test_a_repr_makes_the_same_object(thing: object) -> None:
    assert eval(repr(thing)) == thing


def test_a_limit_surface_is_pickled() -> None:
    surface = PUCK.limit_surface([1.0, 2.0])
    push = [0.1, 0.2, 0.003]
    for thing in (surface, surface.ellipsoid()):
        other = pickle.loads(pickle.dumps(thing))
        assert np.array_equal(other.gauge(push), thing.gauge(push))
        assert other == thing and hash(other) == hash(thing)
        assert repr(other) == repr(thing)


@pytest.mark.parametrize(
    ("thing", "name"),
    [(PUCK, "law"), (PUCK.patch, "kind"), (PUCK.law, "name"), (PUCK.limit_surface(1.0), "load")],
)
def test_objects_do_not_change(thing: object, name: str) -> None:
    before = repr(thing)
    with pytest.raises(AttributeError):
        setattr(thing, name, 1.0)
    with pytest.raises(AttributeError):
        delattr(thing, name)
    assert repr(thing) == before
