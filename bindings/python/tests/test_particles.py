"""Spheres and walls: closed forms of single balls, balances, the same bits for any number of threads."""

from __future__ import annotations

import math

import numpy as np
import pytest
import tribos
from tribos import cd

UP = (0.0, 0.0, 1.0)
FLOOR = cd.Wall(UP)
GRAVITY = (0.0, 0.0, -9.81)


@pytest.mark.parametrize("mu", [0.05, 0.2, 1.0])
def test_a_sliding_ball_ends_rolling_with_five_sevenths_of_its_speed(mu: float) -> None:
    radius, speed = 0.028, 1.5
    ball = cd.World(
        [[0, 0, radius]],
        radius,
        density=1700.0,
        velocities=[[speed, 0, 0]],
        walls=[FLOOR],
        laws=cd.Laws(sliding=mu),
        gravity=GRAVITY,
    )
    # Until it rolls, after 2 v/(7 mu g), it brakes with mu g.
    ball.step(20)
    if mu == 0.05:
        assert ball.velocities[0, 0] == pytest.approx(speed - mu * 9.81 * ball.time, rel=1e-12)
    ball.step(int(2 * speed / (7 * mu * 9.81) / 1e-3) + 20)
    assert ball.velocities[0, 0] == pytest.approx(5 / 7 * speed, rel=1e-12)
    assert ball.spins[0, 1] * radius == pytest.approx(ball.velocities[0, 0], rel=1e-12)
    mass = 1700.0 * 4 / 3 * math.pi * radius**3
    lost = 0.5 * mass * speed**2 * 2 / 7
    # Implicit steps count a part of it as lost along the normal and by damping.
    assert ball.energy.sliding + ball.energy.normal == pytest.approx(lost, rel=1e-10)
    assert abs(ball.energy.imbalance) < 1e-12 * lost
    # The floor, wall -1, carries the weight.
    contacts = ball.contacts
    assert contacts.pairs.tolist() == [[0, -1]] and len(contacts) == 1
    assert contacts.normals[0] == pytest.approx([0, 0, -1])
    assert contacts.forces[0, 2] == pytest.approx(-mass * 9.81, rel=1e-9)
    assert contacts.normal_forces[0] == pytest.approx(mass * 9.81, rel=1e-9)


def test_a_spinning_ball_is_braked_by_torsion_alone() -> None:
    radius, mu = 0.05, 0.01
    laws = cd.Laws(sliding=0.3, torsion=mu)
    ball = cd.World(
        [[0, 0, radius]],
        radius,
        density=1000.0,
        spins=[[0, 0, 9.0]],
        walls=[FLOOR],
        laws=laws,
        gravity=GRAVITY,
    )
    ball.step(100)
    # Torque mu m g r against the inertia 2/5 m r².
    braked = mu * 9.81 * radius / (0.4 * radius**2) * ball.time
    assert ball.spins[0] == pytest.approx([0, 0, 9.0 - braked], rel=1e-9)


def test_ivory_balls_hand_their_speed_on() -> None:
    row = cd.World(
        [[0, 0, 0], [0.1, 0, 0], [0.2, 0, 0]],
        0.05,
        density=1900.0,
        laws=cd.Laws(restitution=1.0),
    )
    row.velocities = [[2.0, 0, 0], [0, 0, 0], [0, 0, 0]]
    row.step()
    assert row.velocities[:, 0] == pytest.approx([0, 0, 2.0], abs=1e-9)
    row.spins = np.zeros((3, 3))
    assert not row.spins.any() and len(row) == 3 and "3 spheres" in repr(row)


def test_a_piston_sinks_under_its_load() -> None:
    lid = cd.Wall((0.0, 0.0, -1.0), place=-1.0, mass=2.0, force=4.0)
    world = cd.World([[0, 0, 0.1]], 0.1, walls=[FLOOR, lid])
    world.step(100)
    place, speed = world.walls[1]
    assert speed == pytest.approx(2.0 * world.time, rel=1e-12)
    assert place == pytest.approx(-1.0 + world.time**2, rel=1e-2)


def pile() -> cd.World:
    """Sixty-four balls that fall into a heap, periodic along x and y."""
    rng = np.random.default_rng(3)
    grid = np.stack(np.meshgrid(*[np.arange(4)] * 3), axis=-1).reshape(-1, 3) * 0.23 + 0.12
    return cd.World(
        grid + rng.uniform(-0.005, 0.005, grid.shape),
        0.1,
        density=2500.0,
        walls=[FLOOR],
        laws=cd.Laws(sliding=0.4, rolling=0.05, torsion=0.05, cohesion=5.0, cohesion_range=1e-3),
        wall_laws=cd.Laws(sliding=0.2),
        gravity=GRAVITY,
        period=(0.92, 0.92, None),
    )


def test_no_bit_depends_on_the_threads() -> None:
    made = []
    for threads in (1, 4):
        tribos.set_num_threads(threads)
        try:
            heap = pile()
            heap.step(150)
        finally:
            tribos.set_num_threads(None)
        made.append((heap.positions, heap.velocities, heap.spins, heap.contacts.forces))
    for one, other in zip(*made):
        assert np.array_equal(one, other)


def test_forces_balance_momentum() -> None:
    heap = pile()
    heap.step(199)
    before = heap.velocities
    heap.step()
    mass = 2500.0 * 4 / 3 * math.pi * 0.1**3
    dt, contacts = heap.last_step["dt"], heap.contacts
    assert heap.last_step["contacts"] == len(contacts) > 20 and heap.steps == 200
    total = np.zeros((64, 3))
    np.add.at(total, contacts.pairs[:, 0], -contacts.forces)
    among = contacts.pairs[:, 1] >= 0
    np.add.at(total, contacts.pairs[among, 1], contacts.forces[among])
    expected = mass * ((heap.velocities - before) / dt - np.array(GRAVITY))
    assert np.allclose(total, expected, atol=1e-9 * np.abs(total).max())


def test_what_cannot_be_is_refused_with_the_librarys_words() -> None:
    with pytest.raises(ValueError, match="sphere 0: the radius must be positive"):
        cd.World([[0, 0, 0]], -1.0)
    with pytest.raises(ValueError, match="the normal must have length 1"):
        cd.World([[0, 0, 0]], 1.0, walls=[cd.Wall((0.0, 0.0, 2.0))])
    with pytest.raises(ValueError, match="the longest step and the largest motion"):
        cd.World([[0, 0, 0]], 1.0, longest_step=0.0)
    with pytest.raises(ValueError, match="mu|friction"):
        cd.World([[0, 0, 0]], 1.0, laws=cd.Laws(sliding=-0.1))
    with pytest.raises(ValueError, match=r"velocities must have shape \(1, 3\)"):
        cd.World([[0, 0, 0]], 1.0, velocities=[[0, 0, 0], [1, 0, 0]])
    with pytest.raises(ValueError, match="radii must be a number or 2 numbers"):
        cd.World([[0, 0, 0], [3, 0, 0]], [1.0, 1.0, 1.0])
    with pytest.raises(ValueError, match="period"):
        cd.World([[0, 0, 0]], 1.0, period=(-1.0, None, None))
    same = cd.World([[0, 0, 0], [0, 0, 0]], 1.0)
    with pytest.raises(RuntimeError, match="sphere 0"):
        same.step()
