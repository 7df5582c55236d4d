"""Derivatives in PyTorch against finite differences."""

import numpy as np
import pytest
import tribos

torch = pytest.importorskip("torch")

import tribos.torch as tt  # noqa: E402

FRICTIONS = [
    tribos.Friction(tribos.disk(0.1), mu=0.5),
    tribos.Friction(tribos.box(0.2, 0.1), mu=0.5),
]
TWISTS = [[1.0, 0.3, 12.0], [0.1, -0.4, -3.0]]
PUSHES = [[3.0, 4.0, 0.1], [-9.0, 1.0, 0.2]]
BODY = {"mass": 2.0, "inertia": 0.006, "dt": 0.01}


def doubles(*given):
    return tuple(torch.tensor(x, dtype=torch.float64, requires_grad=True) for x in given)


def check(of, *given, eps: float = 1e-6, tol: float = 1e-6) -> None:
    assert torch.autograd.gradcheck(of, doubles(*given), eps=eps, atol=tol, rtol=tol)


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_everything_has_the_slopes_of_differences(friction: tribos.Friction) -> None:
    loads = [10.0, 7.0]
    check(lambda twists, load: tt.wrench(friction, twists, load), TWISTS, loads)
    check(lambda twists, load: tt.wrench(friction, twists, load), TWISTS, 3.0)
    check(lambda twists, load: tt.support(friction, twists, load), TWISTS, loads)
    check(lambda wrenches, load: tt.gauge(friction, wrenches, load), PUSHES, loads)
    check(lambda wrenches: tt.normal(friction, wrenches), PUSHES, tol=1e-5)
    double = (2 * np.array(PUSHES)).tolist()
    check(lambda wrenches, load: tt.project(friction, wrenches, load, length=0.03), double, loads)


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_a_planar_step_has_the_slopes_of_differences(friction: tribos.Friction) -> None:
    def step(twists, push, load, mass, inertia, dt):
        return tt.planar_step(friction, twists, push, load, mass=mass, inertia=inertia, dt=dt)[:2]

    check(step, TWISTS, PUSHES, [10.0, 7.0], 2.0, 0.006, 0.01, eps=1e-7, tol=1e-5)
    at_rest = tt.planar_step(friction, *doubles([1e-3, 0.0, 0.0], [1.0, 0.0, 0.01]), 10.0, **BODY)
    assert at_rest.at_rest
    assert np.array_equal(at_rest.twists.detach(), np.zeros(3))


def test_a_step_into_rest_passes_no_gradient_on() -> None:
    twist, push = doubles([1e-3, 0.0, 0.0], [1.0, 0.0, 0.01])
    tt.planar_step(FRICTIONS[0], twist, push, 10.0, **BODY).twists.sum().backward()
    assert not twist.grad.any() and not push.grad.any()


def test_a_turned_box_has_the_slopes_of_differences() -> None:
    def step(twists, pushes, angle):
        return tt.planar_step(FRICTIONS[1], twists, pushes, 10.0, angle=angle, **BODY)[:2]

    check(step, TWISTS, PUSHES, [0.3, -1.0], eps=1e-7, tol=1e-5)


def test_a_slide_has_the_slopes_of_differences() -> None:
    disk = tribos.Friction(tribos.disk(0.08), mu=0.3)

    def way(speed, spin, gravity, radius):
        return tuple(tt.slide(disk, speed, spin, gravity=gravity, radius=radius))

    check(way, [1.0, 2.0], [11.0, -5.0], 10.0, 0.08, eps=1e-5)


def test_a_gradient_through_a_hundred_steps_is_that_of_differences() -> None:
    def travelled(start):
        twist, way = start, 0.0
        for _ in range(100):
            after = tt.planar_step(
                FRICTIONS[0], twist, torch.zeros(3, dtype=torch.float64), 5.0, **BODY
            ).twists
            way = way + 0.005 * (twist + after)
            twist = after
        return way

    check(travelled, [4.0, 1.0, 60.0], eps=1e-5, tol=1e-5)


def test_types_are_those_of_the_tensors() -> None:
    twist = torch.tensor(TWISTS, requires_grad=True)
    made = tt.wrench(FRICTIONS[0], twist, 10.0)
    assert made.dtype == torch.float32
    exact = FRICTIONS[0].wrench(np.array(TWISTS, dtype=np.float32), 10.0)
    assert np.array_equal(made.detach().numpy(), exact.astype(np.float32))
    made.sum().backward()
    assert twist.grad.dtype == torch.float32
    assert tt.wrench(FRICTIONS[0], TWISTS, 10.0).dtype == torch.get_default_dtype()
