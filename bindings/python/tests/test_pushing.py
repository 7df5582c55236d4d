"""Pushes against brute force over motions, balances of power, the command, and closed forms."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
import tribos

TABLE = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4).limit_surface(load=20.0)
PUCK = tribos.Friction(tribos.disk(0.05), mu=0.3).limit_surface(load=2.0)
FINGER = tribos.PointContact([0.05, -0.1], [0.0, 1.0], mu=0.3)
# The scene push-box of the command.
SCENE = (TABLE, FINGER, [0.0, 0.02])


def nodes(patch: tribos.Patch, count: int) -> tuple[Any, Any]:
    """Middles of equal areas of a box or a disk."""
    part = (np.arange(count) + 0.5) / count
    if patch.kind == "box":
        given = dict(patch._parameters)
        x, y = np.meshgrid((part - 0.5) * given["a"], (part - 0.5) * given["b"])
        return x.ravel(), y.ravel()
    r, a = np.meshgrid(patch.radius * np.sqrt(part), 2.0 * np.pi * part)
    return (r * np.cos(a)).ravel(), (r * np.sin(a)).ravel()


def motion_under(surface: tribos.LimitSurface, wrench: Any) -> Any:
    """The motion under a push: where power over dissipation is largest, by brute force.

    The dissipation is a mean over points; candidates are spread over the half sphere of motions and drawn
    together about the best one.
    """
    x, y = nodes(surface.patch, 60)
    radius = surface.patch.radius
    unit = np.array([1.0, 1.0, 1.0 / radius])
    rng = np.random.default_rng(0)
    best, width = np.array(wrench) * unit, 3.0
    best /= np.linalg.norm(best)
    for _ in range(16):
        tried = best + width * rng.normal(size=(150, 3))
        tried = np.vstack((best, tried / np.linalg.norm(tried, axis=1, keepdims=True)))
        u = tried[:, 0, None] - tried[:, 2, None] / radius * y
        v = tried[:, 1, None] + tried[:, 2, None] / radius * x
        share = tried @ (np.array(wrench) * unit) / np.mean(np.hypot(u, v), axis=1)
        best, width = tried[np.argmax(share)], 0.5 * width
    return best * unit


@pytest.mark.parametrize(
    ("surface", "contact"),
    [
        (PUCK, tribos.PointContact([-0.05, 0.0], [1.0, 0.0], mu=0.5)),
        (PUCK, tribos.PointContact([0.03, -0.04], [-3.0, 4.0], mu=0.2)),
        (TABLE, FINGER),
        (TABLE, tribos.PointContact([-0.15, 0.06], [1.0, 0.0], mu=0.8)),
    ],
)
def test_the_motion_cone_is_that_of_brute_force(
    surface: tribos.LimitSurface, contact: tribos.PointContact
) -> None:
    cone = tribos.motion_cone(surface, contact)
    x, y = contact.position
    normal = contact.normal / np.linalg.norm(contact.normal)
    tangent = np.array([-normal[1], normal[0]])
    for side, edge, angle in [(-1, cone.right, cone.angles[0]), (1, cone.left, cone.angles[1])]:
        force = normal + side * float(contact.mu) * tangent
        motion = motion_under(surface, [*force, x * force[1] - y * force[0]])
        velocity = motion[:2] + motion[2] * np.array([-y, x])
        found = np.arctan2(velocity @ tangent, velocity @ normal)
        assert found == pytest.approx(angle, abs=3e-3)
        turn = motion[2] / np.linalg.norm(motion[:2])
        assert edge.twist[2] / np.linalg.norm(edge.twist[:2]) == pytest.approx(turn, rel=2e-2)
        assert surface.gauge(edge.wrench) == pytest.approx(1.0, abs=1e-13)


def random_pushes(count: int) -> tuple[tribos.PointContact, Any, tribos.Push]:
    rng = np.random.default_rng(1)
    # Points of the lower side.
    places = np.stack([rng.uniform(-0.15, 0.15, count), np.full(count, -0.1)], axis=1)
    contact = tribos.PointContact(places, [0.0, 1.0], mu=rng.uniform(0.0, 1.0, count))
    velocity = rng.normal(size=(count, 2)) + [0.0, 0.7]
    return contact, velocity, tribos.push(TABLE, contact, velocity)


def test_power_of_the_pusher_goes_to_the_floor_and_the_contact() -> None:
    _, velocity, moved = random_pushes(400)
    force = moved.wrench[:, :2]
    given = np.sum(force * velocity, axis=1)
    rubbed = np.sum(force * moved.slip, axis=1)
    np.testing.assert_allclose(given, TABLE.support(moved.twist) + rubbed, atol=1e-12)
    assert np.all(rubbed >= -1e-15)


def test_each_mode_is_what_its_name_says() -> None:
    contact, velocity, moved = random_pushes(400)
    modes = moved.mode
    assert set(modes) == {"sticking", "sliding left", "sliding right", "separating"}
    x, y = contact.position.T
    at = moved.twist[:, :2] + moved.twist[:, 2:] * np.stack([-y, x], axis=1)
    np.testing.assert_allclose(at, moved.contact_velocity, atol=1e-13)
    np.testing.assert_allclose(moved.slip, velocity - moved.contact_velocity, atol=1e-13)
    # Left of the inward normal (0, 1) is -x.
    share = -moved.wrench[:, 0] / np.where(moved.wrench[:, 1] > 0.0, moved.wrench[:, 1], np.nan)
    sticks = modes == "sticking"
    assert np.all(moved.slip[sticks] == 0.0)
    assert np.all(np.abs(share[sticks]) <= contact.mu[sticks] * (1.0 + 1e-12))
    for name, sign in [("sliding left", 1.0), ("sliding right", -1.0)]:
        those = modes == name
        assert np.all(-sign * moved.slip[those, 0] > 0.0)
        np.testing.assert_allclose(moved.slip[those, 1], 0.0, atol=1e-13)
        np.testing.assert_allclose(share[those], sign * contact.mu[those], atol=1e-12)
    leaves = modes == "separating"
    assert np.all(velocity[leaves, 1] <= 0.0) and np.all(velocity[~leaves, 1] > 0.0)
    assert np.all(moved.twist[leaves] == 0.0) and np.all(moved.wrench[leaves] == 0.0)


def test_a_push_through_the_centre_of_pressure_turns_nothing() -> None:
    contact = tribos.PointContact([0.0, -0.1], [0.0, 1.0], mu=0.3)
    moved = tribos.push(TABLE, contact, [0.0, 0.02])
    assert moved.mode == "sticking"
    np.testing.assert_allclose(moved.twist, [0.0, 0.02, 0.0], atol=1e-15)
    np.testing.assert_allclose(moved.wrench, [0.0, 8.0, 0.0], atol=1e-12)


def test_pushes_are_broadcast_over_contacts_velocities_and_loads() -> None:
    places = [[[-0.05, -0.1]], [[0.0, -0.1]], [[0.05, -0.1]]]
    contact = tribos.PointContact(places, [0.0, 1.0], mu=0.3)
    surface = tribos.LimitSurface(tribos.box(0.3, 0.2), 0.4, [10.0, 20.0])
    moved = tribos.push(surface, contact, [0.001, 0.02])
    assert moved.mode.shape == (3, 2) and moved.twist.shape == (3, 2, 3)
    one = tribos.push(TABLE, FINGER, [0.001, 0.02])
    np.testing.assert_array_equal(moved.twist[2, 1], one.twist)
    assert moved.mode[2, 1] == one.mode
    # Motions do not depend on the load, pushes are proportional to it.
    np.testing.assert_allclose(moved.wrench[:, 1], 2.0 * moved.wrench[:, 0], rtol=1e-9)
    np.testing.assert_allclose(moved.twist[:, 1], moved.twist[:, 0], rtol=1e-9, atol=1e-12)
    assert tribos.motion_cone(surface, contact).angles.shape == (3, 2, 2)


def test_a_path_is_that_of_a_general_integrator() -> None:
    integrate = pytest.importorskip("scipy.integrate")
    velocity, start = np.array([0.001, 0.02]), (0.2, -0.1, 0.3)

    def turned(vector: Any, angle: float) -> Any:
        c, s = np.cos(angle), np.sin(angle)
        return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])

    at_start = np.array(start[:2]) + turned(FINGER.position, start[2])

    def rate(time: float, state: Any) -> Any:
        place = turned(at_start + velocity * time - state[:2], -state[2])
        contact = tribos.PointContact(place, [0.0, 1.0], mu=0.3)
        twist = tribos.push(TABLE, contact, turned(velocity, -state[2])).twist
        return [*turned(twist[:2], state[2]), twist[2]]

    path = tribos.push_along(TABLE, FINGER, velocity, 5.0, start=start, samples=10)
    solved = integrate.solve_ivp(rate, (0.0, 5.0), start, rtol=1e-7, atol=1e-9, max_step=0.25)
    assert path.end == "done" and len(path.time) == 11
    np.testing.assert_allclose(path.position[-1], solved.y[:2, -1], atol=1e-6)
    assert path.angle[-1] == pytest.approx(solved.y[2, -1], abs=1e-5)
    # The contact is where the pusher is.
    for i in (3, 10):
        there = path.position[i] + turned(path.contact[i], path.angle[i])
        np.testing.assert_allclose(there, at_start + velocity * path.time[i], atol=1e-14)


def test_paths_end_where_the_side_ends_or_the_pusher_leaves() -> None:
    slippery = tribos.PointContact([0.05, -0.1], [0.0, 1.0], mu=0.0)
    path = tribos.push_along(TABLE, slippery, [0.0, 0.02], 100.0, side=(0.01, 0.01))
    assert path.end == "slipped" and path.time[-1] < 100.0
    np.testing.assert_allclose(path.contact[-1], [0.04, -0.1], atol=1e-7)
    left = tribos.PointContact([-0.05, 0.0], [1.0, 0.0], mu=0.1)
    path = tribos.push_along(PUCK, left, [0.01, 0.004], 1000.0, tolerance=1e-5)
    assert path.end == "separated"
    radii = np.linalg.norm(path.contact, axis=1)
    np.testing.assert_allclose(radii, 0.05, atol=1e-4)


def test_a_contact_finds_the_normal_of_its_side() -> None:
    ell = tribos.polygon([[0, 0], [0, 4], [1, 4], [1, 1], [4, 1], [4, 0]])
    for place, normal in [([2.5, 1.0], [0, -1]), ([1.0, 3.0], [-1, 0]), ([3.0, -0.1], [0, 1])]:
        np.testing.assert_array_equal(tribos.PointContact.on(ell, place, 0.3).normal, normal)
    hole = [[1, 1], [2, 1], [2, 2], [1, 2]]
    frame = tribos.polygon([[0, 0], [3, 0], [3, 3], [0, 3]], holes=[hole])
    np.testing.assert_array_equal(tribos.PointContact.on(frame, [1.5, 1.1], 0.3).normal, [0, -1])
    np.testing.assert_array_equal(
        tribos.PointContact.on(PUCK.patch, [0, 0.05], 0.3).normal, [0, -0.05]
    )
    with pytest.raises(ValueError, match="no sides"):
        tribos.PointContact.on(tribos.points([[0, 0], [1, 0]]), [0, 0], 0.3)


def test_a_path_knows_the_side_that_it_is_on() -> None:
    slippery = tribos.PointContact([0.12, -0.1], [0.0, 1.0], mu=0.0)
    path = tribos.push_along(TABLE, slippery, [0.01, 0.01], 100.0, samples=10)
    assert path.end == "slipped"
    np.testing.assert_allclose(path.contact[-1], [0.15, -0.1], atol=1e-7)
    # Another normal is that of a flat pusher at a corner: it goes on beyond.
    corner = tribos.PointContact([0.15, -0.1], [-0.1, 1.0], mu=0.0)
    path = tribos.push_along(TABLE, corner, [0.01, 0.01], 2.0, samples=10)
    assert path.end == "done"


def test_the_command_gives_the_same_push() -> None:
    program = "import sys, tribos._command as c; sys.argv[0] = 'tribos'; c.main()"
    call = [sys.executable, "-c", program, "push", "push-box", "--format", "json"]
    told = json.loads(subprocess.run(call, check=True, capture_output=True).stdout)
    moved = tribos.push(*SCENE)
    names = ("velocity_x", "velocity_y", "spin")
    np.testing.assert_array_equal(moved.twist, [told[name] for name in names])
    np.testing.assert_array_equal(moved.wrench, [told[n] for n in ("force_x", "force_y", "torque")])
    angles = tribos.motion_cone(TABLE, FINGER).angles
    np.testing.assert_array_equal(angles, [told["motion_cone_right"], told["motion_cone_left"]])
    path = tribos.push_along(*SCENE, 10.0)
    assert path.angle[-1] == told["end_angle"] and path.steps == told["steps"]
    np.testing.assert_array_equal(path.position[-1], [told["end_x"], told["end_y"]])
    assert TABLE.torque_limit == pytest.approx(told["yaw_limit"], rel=1e-13)
    corners = [[-0.15, -0.1], [0.15, -0.1], [0.15, 0.1], [-0.15, 0.1]]
    foot = tribos.any_pressure(corners, [0.0, 0.0], 0.4, 20.0)
    limit = foot.torque_limits([0.0, 0.0]).outer[1]
    assert limit == pytest.approx(told["yaw_limit_of_any_pressure"], rel=1e-14)


FENCE = tribos.LineContact([-0.08, -0.1], [0.08, -0.1], mu=0.4)


def test_a_fence_holds_motions_whose_pushes_it_can_give() -> None:
    rng = np.random.default_rng(3)
    twists = rng.normal(size=(500, 3)) * [0.3, 1.0, 4.0] + [0.0, 0.5, 0.0]
    grip = FENCE.grip(TABLE, twists)
    assert 20 < grip.is_stable.sum() < 480
    np.testing.assert_allclose(grip.wrench, -TABLE.wrench(twists), rtol=1e-12)
    # The push is a sum with positive shares of the edges at both ends, or it is not.
    optimize = pytest.importorskip("scipy.optimize")
    edges = []
    for x, y in (FENCE.first, FENCE.second):
        for side in (-0.4, 0.4):
            edges.append([side, 1.0, x * 1.0 - y * side])
    for wrench, stable in zip(grip.wrench[:80], grip.is_stable[:80]):
        _, missing = optimize.nnls(np.array(edges).T, wrench)
        assert (missing < 1e-9) == stable
    one = FENCE.grip(TABLE, [0.0, 1.0, 0.0])
    assert one.is_stable and one.place == pytest.approx(0.5) and abs(one.friction) < 1e-12


def test_the_boundary_of_stable_motions_is_at_the_edges() -> None:
    boundary = FENCE.stable_boundary(TABLE, 8)
    assert boundary.shape == (32, 3)
    grip = FENCE.grip(TABLE, boundary)
    at_edge = np.abs(np.abs(grip.friction) - 0.4) < 1e-9
    at_end = np.minimum(np.abs(grip.place), np.abs(grip.place - 1.0)) < 1e-9
    assert np.all(at_edge | at_end)


# Torque limits.


def test_two_feet_carry_the_torque_that_the_force_leaves() -> None:
    # Each foot carries half of the load; forces across the line between them.
    a, limit = 0.1, 0.5 * 60.0
    feet = tribos.LimitSurface(tribos.points([[-a, 0.0], [a, 0.0]]), mu=0.5, load=60.0)
    forces = np.linspace(0.0, 0.95 * limit, 20)
    found = feet.torque_limits(np.stack([0.0 * forces, forces], axis=1))
    wanted = a * (limit - forces)
    np.testing.assert_allclose(found, np.stack([-wanted, wanted], axis=1), atol=1e-9)
    assert np.isnan(feet.torque_limits([0.0, 1.01 * limit])).all()


def test_torque_limits_are_on_the_surface() -> None:
    sole = tribos.polygon(
        [[-0.06, -0.04], [0.18, -0.05], [0.18, 0.05], [-0.06, 0.04]], centre=(0.08, 0.01)
    )
    floor = tribos.LimitSurface(sole, mu=0.6, load=[500.0, 700.0])
    forces = np.array([[200.0, 0.0], [0.0, -150.0], [100.0, 250.0]])[:, None]
    limits = floor.torque_limits(forces)
    assert limits.shape == (3, 2, 2)
    for side in (0, 1):
        spread = np.broadcast_to(forces, (3, 2, 2))
        wrench = np.concatenate([spread, limits[..., side, None]], axis=-1)
        np.testing.assert_allclose(floor.gauge(wrench), 1.0, atol=1e-13)
    assert np.all(limits[..., 0] < limits[..., 1])
    # A ring without spin slides alike everywhere; beside half of the force it carries what its gauge says.
    ring = tribos.LimitSurface(tribos.ring(0.05), mu=0.5, load=20.0)
    low, high = ring.torque_limits([[0.0, 0.0], [3.0, 4.0], [8.0, 6.0001]]).T
    np.testing.assert_allclose(high[0], 0.5, atol=1e-12)
    assert ring.gauge([3.0, 4.0, high[1]]) == pytest.approx(1.0, abs=1e-12)
    assert np.array_equal(low[:2], -high[:2]) and np.isnan([low[2], high[2]]).all()
    with pytest.raises(ValueError, match="ellipsoid"):
        PUCK.ellipsoid().torque_limits([0.1, 0.0])


SOLE = np.array([[-0.06, -0.04], [0.18, -0.05], [0.18, 0.05], [-0.06, 0.04]])


@pytest.mark.parametrize("force", [(0.0, 0.0), (200.0, 0.0), (-90.0, 250.0)])
def test_any_pressure_carries_what_a_linear_programme_finds(force: tuple[float, float]) -> None:
    optimize = pytest.importorskip("scipy.optimize")
    centre, mu, load, many = (0.05, 0.01), 0.6, 700.0, 256
    foot = tribos.any_pressure(SOLE, centre, mu, load)
    angle = 2.0 * np.pi * np.arange(many) / many
    direction = np.stack([np.cos(angle), np.sin(angle)])
    # Unknowns: forces at the corners along fixed directions, which lose 1 - cos(pi/256) of friction,
    # and the corners' loads.
    x, y = SOLE.T
    fx, fy = np.tile(direction[0], 4), np.tile(direction[1], 4)
    torque = np.repeat(x, many) * fy - np.repeat(y, many) * fx
    nothing = np.zeros(4)
    equal = np.array(
        [
            np.append(fx, nothing),
            np.append(fy, nothing),
            np.append(0.0 * fx, np.ones(4)),
            np.append(0.0 * fx, x),
            np.append(0.0 * fx, y),
        ]
    )
    wanted = [*force, load, load * centre[0], load * centre[1]]
    within = np.hstack([np.kron(np.eye(4), np.ones(many)), -mu * np.eye(4)])
    found = []
    for sign in (1.0, -1.0):
        cost = np.append(sign * torque, nothing)
        solved = optimize.linprog(cost, within, nothing, equal, wanted)
        found.append(sign * solved.fun)
    limits = foot.torque_limits(force)
    loss = 2e-4 * foot.force_limit * foot.radius
    np.testing.assert_allclose(limits.carried, found, atol=loss)
    np.testing.assert_allclose(limits.outer, limits.carried, atol=1e-9 * foot.force_limit)
    assert limits.outer[0] <= found[0] + 1e-9 and limits.outer[1] >= found[1] - 1e-9
    for torque_limit, share in zip(limits.carried, foot.gauge_bounds(wrenches(force, limits))):
        assert share == pytest.approx(1.0, abs=1e-8), torque_limit


def wrenches(force: tuple[float, float], limits: tribos.TorqueLimits) -> Any:
    return [[*force, torque] for torque in limits.carried]


def test_support_of_any_pressure_is_the_best_of_all_triangles() -> None:
    centre, rng = np.array([0.05, 0.01]), np.random.default_rng(4)
    foot = tribos.any_pressure(SOLE, centre, 0.6, 700.0)
    for twist in rng.normal(size=(50, 3)) * [1.0, 1.0, 10.0]:
        speed = np.hypot(twist[0] - twist[2] * SOLE[:, 1], twist[1] + twist[2] * SOLE[:, 0])
        best = 0.0
        for out in range(4):
            three = [i for i in range(4) if i != out]
            shares = np.linalg.solve(np.vstack([SOLE[three].T, np.ones(3)]), [*centre, 1.0])
            if shares.min() >= 0.0:
                best = max(best, float(shares @ speed[three]))
        assert foot.support(twist) == pytest.approx(420.0 * best, rel=1e-12)
        assert -foot.wrench(twist) @ twist == pytest.approx(420.0 * best, rel=1e-12)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: cone([0.0, 0.0]), "normal must not be zero"),
        (lambda: tribos.PointContact([0.0, np.nan], [0.0, 1.0], 0.3), "position must be finite"),
        (lambda: tribos.PointContact([0.0, 0.0], [0.0, 1.0], -0.3), "mu must be >= 0"),
        (lambda: tribos.PointContact([0.0, 0.0, 0.0], [0.0, 1.0], 0.3), "shape"),
        (lambda: tribos.push(TABLE, FINGER, [np.inf, 0.0]), "velocity"),
        (lambda: tribos.push(tribos.LimitSurface(TABLE.patch, 0.0, 1.0), FINGER, [0, 1]), "> 0"),
        (lambda: tribos.push_along(*SCENE, -1.0), "duration"),
        (lambda: tribos.push_along(*SCENE, 1.0, side="flat"), "round"),
        (lambda: tribos.push_along(*SCENE, 1.0, samples=0), "samples"),
        (lambda: tribos.LineContact([0.0, 0.0], [0.0, 0.0], 0.3), "apart"),
        (lambda: tribos.any_pressure(SOLE, [1.0, 0.0], 0.6, 1.0), "convex hull"),
        (lambda: tribos.any_pressure(SOLE, [0.0, 0.0], -0.6, 1.0), ">= 0"),
    ],
)
def test_what_pushes_nothing_is_refused(call: Any, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        call()


def cone(normal: Any) -> tribos.MotionCone:
    return tribos.motion_cone(TABLE, tribos.PointContact([0.0, 0.0], normal, 0.3))


def test_contacts_and_feet_survive_pickling() -> None:
    foot = tribos.any_pressure(SOLE, [0.05, 0.01], 0.6, 700.0)
    for thing in (FINGER, FENCE, foot):
        again = pickle.loads(pickle.dumps(thing))
        assert repr(again) == repr(thing)
    assert pickle.loads(pickle.dumps(foot)) == foot and hash(foot) == hash(foot)
    moved = pickle.loads(pickle.dumps(tribos.push(*SCENE)))
    assert moved.mode == "sliding left"
