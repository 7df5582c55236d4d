"""Contacts and manifolds against closed forms, balances and sums over points."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import pytest
import tribos

RADIUS, MASS = 0.03, 0.2
LAWS = {
    "smooth": tribos.ContactLaw(restitution=0.7),
    "sliding": tribos.ContactLaw(0.3, restitution=0.5),
    "rolling": tribos.ContactLaw(0.3, mu_rolling=0.1),
    "torsion": tribos.ContactLaw(0.3, mu_torsion=0.05, restitution=0.9),
    "all": tribos.ContactLaw(0.3, mu_rolling=0.1, mu_torsion=0.05),
    "disk": tribos.ContactLaw(0.3, patch=tribos.disk(0.4), restitution=0.3),
    "disk, rolling": tribos.ContactLaw(0.3, mu_rolling=0.1, patch=tribos.disk(0.4)),
    "ring": tribos.ContactLaw(0.3, patch=tribos.ring(0.4)),
    "hertz": tribos.ContactLaw(0.3, patch=tribos.hertz(0.4)),
    "punch": tribos.ContactLaw(0.3, patch=tribos.punch(0.4)),
    "annulus": tribos.ContactLaw(0.3, patch=tribos.annulus(0.2, 0.4)),
    "paraboloid": tribos.ContactLaw(0.3, patch=tribos.paraboloid(0.4)),
    "power": tribos.ContactLaw(0.3, mu_rolling=0.1, patch=tribos.power(0.4, 0.25)),
    "polynomial": tribos.ContactLaw(0.3, patch=tribos.polynomial(0.4, [1.0, -0.5])),
}


def spheres(rng: np.random.Generator, count: int) -> tribos.Spheres:
    return tribos.Spheres(
        rng.normal(size=(count, 3)),
        rng.normal(size=(count, 3)) * 50.0,
        mass=rng.uniform(0.1, 2.0, count),
        radius=rng.uniform(0.01, 0.05, count),
    )


def approaching(
    rng: np.random.Generator, count: int
) -> tuple[tribos.Spheres, tribos.Spheres, np.ndarray[Any, Any]]:
    """Spheres that touch and close at 0.5 to 3 m/s."""
    first, second = spheres(rng, count), spheres(rng, count)
    normal = rng.normal(size=(count, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    drift = np.sum((second.velocity - first.velocity) * normal, axis=1)
    closing = -rng.uniform(0.5, 3.0, count) - drift
    return first, second.moving(second.velocity + closing[:, None] * normal, second.spin), normal


def slip(hit: tribos.Collision, normal: Any) -> Any:
    """Velocity of the second surface against the first across the normal."""
    first, second = hit.first, hit.second
    spin = np.zeros(3)
    if isinstance(second, tribos.Spheres):
        spin = second.radius[..., None] * second.spin
    turning = first.radius[..., None] * first.spin + spin
    drift = second.velocity - first.velocity
    across = drift - np.sum(drift * normal, axis=-1, keepdims=True) * normal
    return across - np.cross(turning, normal)


@pytest.mark.parametrize("restitution", [0.0, 0.3, 1.0])
def test_head_on_collisions_follow_newton(restitution: float) -> None:
    rng = np.random.default_rng(1)
    masses = rng.uniform(0.1, 3.0, (2, 100))
    speeds = rng.uniform(0.1, 2.0, 100)
    velocity = np.zeros((100, 3))
    velocity[:, 0] = speeds
    hit = tribos.ContactLaw(0.5, restitution=restitution).collide(
        tribos.Spheres(velocity, mass=masses[0], radius=0.02),
        tribos.Spheres(mass=masses[1], radius=0.05),
        normal=[3.0, 0.0, 0.0],
    )
    total = masses.sum(axis=0)
    first = (masses[0] - restitution * masses[1]) / total * speeds
    second = (1.0 + restitution) * masses[0] / total * speeds
    np.testing.assert_allclose(hit.first.velocity[:, 0], first, rtol=1e-13, atol=1e-15)
    np.testing.assert_allclose(hit.second.velocity[:, 0], second, rtol=1e-13)
    np.testing.assert_allclose(hit.normal, masses[1] * second, rtol=1e-13)
    assert np.all(hit.sliding == 0.0)


@pytest.mark.parametrize("name", LAWS)
def test_momentum_and_angular_momentum_stay(name: str) -> None:
    first, second, normal = approaching(np.random.default_rng(2), 300)
    hit = LAWS[name].collide(first, second, normal=normal)
    arm = (first.radius + second.radius)[:, None] * normal

    def totals(a: tribos.Spheres, b: tribos.Spheres) -> tuple[Any, Any]:
        # About the first centre.
        angular = a.angular_momentum + b.angular_momentum + np.cross(arm, b.momentum)
        return a.momentum + b.momentum, angular

    assert isinstance(hit.second, tribos.Spheres)
    for before, after in zip(totals(first, second), totals(hit.first, hit.second)):
        np.testing.assert_allclose(after, before, atol=2e-14)


@pytest.mark.parametrize("name", LAWS)
def test_no_contact_makes_energy(name: str) -> None:
    first, second, normal = approaching(np.random.default_rng(3), 1000)
    hit = LAWS[name].collide(first, second, normal=normal)
    assert isinstance(hit.second, tribos.Spheres)
    before = first.energy + second.energy
    after = hit.first.energy + hit.second.energy
    assert np.all(after <= before * (1.0 + 1e-14))
    assert np.median(after / before) < 1.0 - 1e-3


@pytest.mark.parametrize("name", ["sliding", "rolling", "torsion", "all"])
def test_thresholds_hold_and_slipping_contacts_reach_them(name: str) -> None:
    law = LAWS[name]
    first, second, normal = approaching(np.random.default_rng(4), 500)
    hit = law.collide(first, second, normal=normal)
    lever = 1.0 / (1.0 / first.radius + 1.0 / second.radius)
    size = np.linalg.norm(hit.sliding, axis=1)
    bound = law.mu * hit.normal
    assert np.all(size <= bound * (1.0 + 1e-14))
    after = slip(hit, normal)
    speed = np.linalg.norm(after, axis=1)
    sticks = size < bound * (1.0 - 1e-9)
    # Both happen; what sticks does not slide, what slides is resisted fully and opposed.
    assert 20 < sticks.sum() < 480
    assert np.all(speed[sticks] < 1e-12)
    slides = ~sticks
    work = np.sum(hit.sliding * after, axis=1)[slides]
    np.testing.assert_allclose(work, -(bound * speed)[slides], rtol=1e-9, atol=1e-12)
    assert np.all(np.abs(hit.torsion) <= law.mu_torsion * hit.normal * lever * (1.0 + 1e-14))
    rolling = np.linalg.norm(hit.rolling, axis=1)
    assert np.all(rolling <= law.mu_rolling * hit.normal * lever * (1.0 + 1e-14))


def test_a_struck_billiard_ball_slides_as_long_as_coulomb_says() -> None:
    mu, gravity, speed, dt = 0.2, 9.81, 1.5, 1e-4
    cloth, table = tribos.ContactLaw(mu), tribos.Plates()
    ball = tribos.Spheres([speed, 0.0, 0.0], mass=MASS, radius=RADIUS)
    slides = 2.0 * speed / (7.0 * mu * gravity)
    history = []
    for _ in range(round(1.5 * slides / dt)):
        falling = ball.moving(ball.velocity - [0.0, 0.0, gravity * dt], ball.spin)
        ball = cloth.collide(falling, table, normal=[0.0, 0.0, -1.0], dt=dt).first
        history.append((ball.velocity[0], ball.spin[1]))
    velocity, spin = np.array(history).T
    time = dt * np.arange(1, len(history) + 1)
    early = time < slides - dt
    np.testing.assert_allclose(velocity[early], speed - mu * gravity * time[early], rtol=1e-12)
    np.testing.assert_allclose(velocity[~early][2:], 5.0 / 7.0 * speed, rtol=1e-12)
    np.testing.assert_allclose(spin[~early][2:] * RADIUS, 5.0 / 7.0 * speed, rtol=1e-12)


def test_an_oblique_impact_sticks_or_slips_as_walton_says() -> None:
    # A solid sphere on a wall: the impulse across is min(mu J, 2/7 m v).
    mu, restitution = 0.25, 0.8
    across = np.linspace(0.05, 10.0, 60)
    velocity = np.stack([across, 0 * across, -np.ones(60)], axis=1)
    ball = tribos.Spheres(velocity, mass=MASS, radius=RADIUS)
    law = tribos.ContactLaw(mu, restitution=restitution)
    hit = law.collide(ball, tribos.Plates(), normal=[0.0, 0.0, -2.0])
    normal = MASS * (1.0 + restitution)
    tangent = np.minimum(mu * normal, 2.0 / 7.0 * MASS * across)
    assert 0 < np.sum(tangent == mu * normal) < 60
    np.testing.assert_allclose(hit.first.velocity[:, 2], restitution, rtol=1e-14)
    np.testing.assert_allclose(hit.sliding[:, 0], tangent, rtol=1e-12)
    np.testing.assert_allclose(hit.first.velocity[:, 0], across - tangent / MASS, rtol=1e-12)
    spin = tangent * RADIUS / (0.4 * MASS * RADIUS**2)
    np.testing.assert_allclose(hit.first.spin[:, 1], spin, rtol=1e-12)


def test_a_top_is_braked_by_its_torsion_threshold_and_stops() -> None:
    spins = np.array([0.1, 0.3, 50.0])
    inertia, press = 0.4 * MASS * RADIUS**2, 0.1
    vectors = np.stack([0 * spins, 0 * spins, spins], axis=1)
    ball = tribos.Spheres([0.0, 0.0, -press], vectors, mass=MASS, radius=RADIUS)
    law = tribos.ContactLaw(mu_torsion=0.04)
    hit = law.collide(ball, tribos.Plates(), normal=[0.0, 0.0, -1.0])
    limit = 0.04 * MASS * press * RADIUS
    wanted = np.minimum(limit, inertia * spins)
    assert wanted[1] < limit == wanted[2]
    np.testing.assert_allclose(inertia * (spins - hit.first.spin[:, 2]), wanted, rtol=1e-12)


def test_a_coupled_contact_resists_along_the_motion_of_each_of_its_points() -> None:
    # Friction impulses must be those of dry points that move as the contact does in the end.
    mu, ratio = 0.3, 0.5
    law = tribos.ContactLaw(mu, patch=tribos.disk(ratio))
    rng = np.random.default_rng(5)
    count = 200
    velocity = rng.normal(size=(count, 3)) * [0.5, 0.5, 0.0] - [0.0, 0.0, 0.3]
    spin = rng.normal(size=(count, 3)) * [10.0, 10.0, 300.0]
    ball = tribos.Spheres(velocity, spin, mass=MASS, radius=RADIUS)
    hit = law.collide(ball, tribos.Plates(), normal=[0.0, 0.0, -1.0])
    # The lower surface of the ball against the plate.
    at_rest = slip(hit, np.array([0.0, 0.0, -1.0]))
    twist = -at_rest[:, :2]
    turn = hit.first.spin[:, 2]
    slides = (np.linalg.norm(twist, axis=1) > 1e-3) & (np.abs(turn) > 1.0)
    assert 20 < slides.sum()
    # Equal areas of a disk, in the rings' middles; a point next to the centre of rotation weighs 4e-5.
    rings, sectors = 200, 128
    r = ratio * RADIUS * np.sqrt((np.arange(rings) + 0.5) / rings)
    a = 2.0 * np.pi * np.arange(sectors) / sectors
    x, y = np.outer(r, np.cos(a)).ravel(), np.outer(r, np.sin(a)).ravel()
    u = twist[slides, 0, None] - turn[slides, None] * y
    v = twist[slides, 1, None] + turn[slides, None] * x
    speed = np.hypot(u, v)
    press = mu * hit.normal[slides]
    force_x, force_y = -press * np.mean(u / speed, axis=1), -press * np.mean(v / speed, axis=1)
    torque = -press * np.mean((x * v - y * u) / speed, axis=1)
    # The ball takes the opposite of the impulse on the plate; the normal leads downwards.
    np.testing.assert_allclose(-hit.sliding[slides, 0], force_x, atol=1e-3 * press.max())
    np.testing.assert_allclose(-hit.sliding[slides, 1], force_y, atol=1e-3 * press.max())
    on_ball = (turn - spin[:, 2])[slides] * 0.4 * MASS * RADIUS**2
    np.testing.assert_allclose(on_ball, torque, atol=1e-3 * press.max() * ratio * RADIUS)
    np.testing.assert_allclose(hit.torsion[slides], on_ball, atol=1e-15)


def test_torsion_of_a_patch_without_sliding_is_its_mean_radius() -> None:
    ratio = 0.5
    for patch, mean in [(tribos.disk(ratio), 2 / 3), (tribos.ring(ratio), 1.0)]:
        law = tribos.ContactLaw(0.3, patch=patch)
        assert law.mu_torsion == pytest.approx(0.3 * ratio * mean, rel=1e-13)


def test_cohesion_holds_up_to_its_strength() -> None:
    strength, dt = 2.0, 1e-3
    law = tribos.ContactLaw(cohesion=strength)
    pulls = np.array([0.5, 1.9, 2.5, 10.0])
    velocity = np.stack([0 * pulls, 0 * pulls, pulls * dt / MASS], axis=1)
    ball = tribos.Spheres(velocity, mass=MASS, radius=RADIUS)
    hit = law.collide(ball, tribos.Plates(), normal=[0.0, 0.0, -1.0], dt=dt)
    np.testing.assert_allclose(hit.normal, -np.minimum(pulls, strength) * dt, rtol=1e-12)
    rest = np.maximum(pulls - strength, 0.0) * dt / MASS
    np.testing.assert_allclose(hit.first.velocity[:, 2], rest, atol=1e-17)


def test_cohesion_within_its_range_pulls_or_resists() -> None:
    dt, strength = 1e-3, 2.0
    ball = tribos.Spheres(mass=1.0, radius=0.05)
    for attraction, speed in [("pull", -strength * dt), ("resistance", 0.0)]:
        law = tribos.ContactLaw(cohesion=strength, cohesion_range=1e-3, attraction=attraction)
        near, far = (
            law.collide(ball, tribos.Plates(), normal=[0, 0, -1], gap=gap, dt=dt).first.velocity[2]
            for gap in (5e-4, 2e-3)
        )
        assert (near, far) == (speed, 0.0)


def test_a_gap_closes_by_its_own_width() -> None:
    dt, gap = 1e-2, 1e-3
    ball = tribos.Spheres([[0, 0, -1.0], [0, 0, -0.05]], mass=MASS, radius=RADIUS)
    law = tribos.ContactLaw(0.3)
    hit = law.collide(ball, tribos.Plates(), normal=[0, 0, -1], gap=gap, dt=dt)
    np.testing.assert_allclose(hit.first.velocity[:, 2], [-gap / dt, -0.05], rtol=1e-13)


def test_a_piston_gives_way_along_its_normal_alone() -> None:
    ball = tribos.Spheres([1.0, 0.0, -2.0], mass=MASS, radius=RADIUS)
    piston = tribos.Plates([0.3, 0.0, 0.0], mass=0.5)
    hit = tribos.ContactLaw(0.4).collide(ball, piston, normal=[0, 0, -1])
    np.testing.assert_allclose(hit.first.velocity[2], -2.0 * MASS / (MASS + 0.5), rtol=1e-14)
    assert hit.second.velocity[0] == 0.3
    assert hit.second.velocity[2] == pytest.approx(hit.first.velocity[2], rel=1e-14)


def test_a_batch_is_its_elements_whatever_the_threads() -> None:
    first, second, normal = approaching(np.random.default_rng(6), 3000)
    law = LAWS["disk, rolling"]
    before = tribos.num_threads()
    whole = []
    for threads in (1, 3):
        tribos.set_num_threads(threads)
        whole.append(law.collide(first, second, normal=normal))
    tribos.set_num_threads(before)
    np.testing.assert_array_equal(whole[0].sliding, whole[1].sliding)
    for i in (0, 1234, 2999):
        one = law.collide(element(first, i), element(second, i), normal=normal[i])
        assert isinstance(one.normal, float)
        assert one.normal == whole[0].normal[i]
        np.testing.assert_array_equal(one.sliding, whole[0].sliding[i])
        np.testing.assert_array_equal(one.first.spin, whole[0].first.spin[i])


def element(balls: tribos.Spheres, i: int) -> tribos.Spheres:
    return tribos.Spheres(
        balls.velocity[i],
        balls.spin[i],
        mass=balls.mass[i],
        radius=balls.radius[i],
        inertia=balls.inertia[i],
    )


def test_arguments_are_broadcast() -> None:
    ball = tribos.Spheres(np.ones((4, 1, 3), np.float32), mass=[1.0, 2.0, 3.0], radius=0.1)
    assert ball.shape == (4, 3)
    hit = LAWS["all"].collide(ball, tribos.Plates(), normal=[-1, 0, 0])
    assert hit.normal.shape == (4, 3) and hit.first.velocity.shape == (4, 3, 3)
    away = LAWS["all"].collide(ball, tribos.Plates(), normal=[0, 0, -1])
    assert np.all(away.normal == 0.0)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: tribos.ContactLaw(-0.1), "sliding coefficient"),
        (lambda: tribos.ContactLaw(0.1, restitution=1.5), "restitution"),
        (lambda: tribos.ContactLaw(0.1, cohesion=-1.0), "cohesion strength"),
        (lambda: tribos.ContactLaw(0.1, mu_torsion=0.1, patch=tribos.disk(1.0)), "mu_torsion"),
        (lambda: tribos.ContactLaw(0.1, patch=tribos.box(1.0, 1.0)), "round"),
        (lambda: tribos.ContactLaw(0.1, attraction="glue"), "attraction"),
        (lambda: tribos.Spheres(mass=0.0, radius=1.0), "mass must be > 0"),
        (lambda: tribos.Spheres(mass=1.0, radius=np.inf), "radius"),
        (lambda: tribos.Spheres([1.0, 2.0], mass=1.0, radius=1.0), "shape"),
        (lambda: met(normal=[0.0, 0.0, 0.0]), "direction"),
        (lambda: met(gap=np.nan), "gap"),
        (lambda: met(gap=1e-3), "dt"),
        (lambda: met(gap=1e-3, dt=0.0), "time step"),
        (lambda: met(gap=-1.0), "centre"),
    ],
)
def test_what_has_no_meaning_is_refused(call: Any, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        call()


def met(normal: Any = (0, 0, -1), gap: float = 0.0, dt: float | None = None) -> tribos.Collision:
    ball = tribos.Spheres(mass=MASS, radius=RADIUS)
    return LAWS["sliding"].collide(ball, tribos.Plates(), normal=normal, gap=gap, dt=dt)


def test_a_motion_that_is_not_a_number_gives_none() -> None:
    ball = tribos.Spheres([[np.nan, 0, 0], [0, 0, -1.0]], mass=MASS, radius=RADIUS)
    hit = LAWS["all"].collide(ball, tribos.Plates(), normal=[0, 0, -1])
    assert np.isnan(hit.first.velocity[0]).any() and np.isfinite(hit.first.velocity[1]).all()


@pytest.mark.parametrize("name", LAWS)
def test_laws_and_bodies_survive_pickling(name: str) -> None:
    law = LAWS[name]
    again = pickle.loads(pickle.dumps(law))
    assert again == law and hash(again) == hash(law) and repr(again) == repr(law)
    assert eval(repr(law)) == law
    ball = tribos.Spheres([1.0, 2.0, 3.0], mass=1.0, radius=0.1)
    assert repr(pickle.loads(pickle.dumps(ball))) == repr(ball)
    with pytest.raises(AttributeError):
        ball.mass = 2.0  # type: ignore[assignment]


# Manifolds.

UP = np.array([0.0, 0.0, 1.0])


@pytest.mark.parametrize("name", LAWS)
def test_one_contact_of_a_manifold_is_a_collision(name: str) -> None:
    # Without restitution, which a manifold takes as an impact of its own.
    given = LAWS[name]
    law = tribos.ContactLaw(
        given.mu,
        mu_rolling=given.mu_rolling,
        mu_torsion=0.0 if given.patch else given.mu_torsion,
        patch=given.patch,
    )
    first, second, normal = approaching(np.random.default_rng(7), 1)
    hit = law.collide(first, second, normal=normal, dt=1e-3)
    pair = tribos.Manifold(law)
    for ball in (first, second):
        pair.add_sphere(
            mass=ball.mass[0],
            radius=ball.radius[0],
            velocity=ball.velocity[0],
            spin=ball.spin[0],
            inertia=ball.inertia[0],
        )
    contact = pair.add_contact(0, 1, normal=normal[0])
    assert pair.solve(1e-3, tolerance=1e-13).converged
    assert isinstance(hit.second, tribos.Spheres)
    np.testing.assert_allclose(pair.velocities, [hit.first.velocity[0], hit.second.velocity[0]])
    np.testing.assert_allclose(pair.spins, [hit.first.spin[0], hit.second.spin[0]], rtol=1e-9)
    assert pair.force(contact).normal == pytest.approx(hit.normal[0] / 1e-3, rel=1e-12)


def test_a_stack_bears_the_weight_above() -> None:
    stack = tribos.Manifold(tribos.ContactLaw(0.3), gravity=-9.81 * UP)
    table = stack.add_plate()
    below, contacts = table, []
    for mass in (1.0, 2.0, 3.0, 4.0):
        ball = stack.add_sphere(mass=mass, radius=0.05)
        if below == table:
            contacts.append(stack.add_contact(ball, table, normal=-UP))
        else:
            contacts.append(stack.add_contact(below, ball, normal=UP))
        below = ball
    for _ in range(3):
        report = stack.solve(1e-3, sweeps=2000, tolerance=1e-13)
    assert report.converged
    forces = [stack.force(contact).normal for contact in contacts]
    np.testing.assert_allclose(forces, 9.81 * np.array([10.0, 9.0, 7.0, 4.0]), rtol=1e-9)
    assert np.abs(stack.velocities).max() < 1e-11


def test_newtons_cradle_sends_the_last_ball_off() -> None:
    cradle = tribos.Manifold(tribos.ContactLaw(restitution=1.0))
    for i in range(5):
        cradle.add_sphere(mass=0.1, radius=0.01, velocity=[2.0 if i == 0 else 0.0, 0, 0])
    for i in range(4):
        cradle.add_contact(i, i + 1, normal=[1.0, 0.0, 0.0])
    cradle.solve(1e-4)
    np.testing.assert_allclose(cradle.velocities[:, 0], [0, 0, 0, 0, 2.0], atol=1e-14)


def test_a_ball_on_a_belt_follows_with_two_sevenths() -> None:
    belt = tribos.Manifold(tribos.ContactLaw(0.3), gravity=-9.81 * UP)
    ball, table = belt.add_sphere(mass=1.0, radius=0.05), belt.add_plate()
    belt.add_contact(ball, table, normal=-UP)
    belt.set_motion(table, [0.1, 0.0, 0.0])
    for _ in range(20):
        belt.solve(1e-3)
    assert belt.velocities[ball][0] == pytest.approx(0.1 * 2 / 7, rel=1e-12)


def test_a_full_manifold_says_so() -> None:
    many = tribos.Manifold(tribos.ContactLaw())
    for _ in range(64):
        many.add_sphere(mass=1.0, radius=0.1)
    with pytest.raises(ValueError, match="room for 64 bodies"):
        many.add_plate()
    for _ in range(256):
        many.add_contact(0, 1, normal=UP)
    with pytest.raises(ValueError, match="room for 256 contacts"):
        many.add_contact(0, 1, normal=UP)
    many.clear_contacts()
    assert many.add_contact(0, 1, normal=UP) == 0


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda m: m.add_contact(0, 0, normal=UP), "two different bodies"),
        (lambda m: m.add_contact(1, 0, normal=UP), "must be a sphere"),
        (lambda m: m.add_contact(0, 7, normal=UP), "no body 7"),
        (lambda m: m.add_contact(0, -1, normal=UP), "no body -1"),
        (lambda m: m.force(0), "no contact 0"),
        (lambda m: m.set_force(5, UP), "no body 5"),
        (lambda m: m.add_sphere(mass=-1.0, radius=1.0), "mass"),
        (lambda m: m.solve(-1.0), "time step"),
        (lambda m: m.solve(1.0, start="warm"), "start"),
        (lambda m: m.solve(1.0, sweeps=0), "sweeps"),
    ],
)
def test_a_manifold_refuses_what_it_has_not(call: Any, text: str) -> None:
    manifold = tribos.Manifold(tribos.ContactLaw())
    manifold.add_sphere(mass=1.0, radius=0.1)
    manifold.add_plate()
    with pytest.raises(ValueError, match=text):
        call(manifold)


def test_a_contact_has_no_force_before_the_first_step() -> None:
    pair = tribos.Manifold(tribos.ContactLaw())
    ball, wall = pair.add_sphere(mass=1.0, radius=0.1), pair.add_plate()
    contact = pair.add_contact(ball, wall, normal=UP)
    with pytest.raises(ValueError, match="not solved"):
        pair.force(contact)
    pair.solve(1.0)
    assert pair.force(contact).normal == 0.0


def test_copies_go_on_alike_and_pickles_within_the_tolerance() -> None:
    pile = tribos.Manifold(LAWS["disk, rolling"], gravity=-9.81 * UP)
    table = pile.add_plate()
    for x in (-0.05, 0.05):
        ball = pile.add_sphere(mass=1.0, radius=0.05, spin=[1.0, x, 3.0])
        pile.add_contact(ball, table, normal=-UP)
    pile.add_contact(1, 2, normal=[1.0, 0.0, 0.0])
    pile.set_force(2, [-3.0, 0.5, 0.0], [0.0, 0.0, 0.01])
    pile.solve(1e-3)
    twin, other = copy.deepcopy(pile), pickle.loads(pickle.dumps(pile))
    assert repr(other) == repr(pile)
    for manifold in (pile, twin, other):
        assert manifold.solve(1e-3, sweeps=2000, tolerance=1e-13).converged
    np.testing.assert_array_equal(twin.velocities, pile.velocities)
    np.testing.assert_array_equal(twin.spins, pile.spins)
    np.testing.assert_allclose(other.velocities, pile.velocities, atol=1e-11)
    # The copy is one of its own.
    twin.set_motion(0, [1.0, 0.0, 0.0])
    assert pile.velocities[0][0] == 0.0
