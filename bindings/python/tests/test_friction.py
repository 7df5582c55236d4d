"""Friction and limit surfaces against tables of independent values."""

import numpy as np
import pytest
import tribos


@pytest.mark.parametrize(("tier", "bound"), [("exact", 8e-16), ("quadrature", 2e-9)])
def test_the_disk_is_right_to_its_tier(table, tier: str, bound: float) -> None:
    rows = table("uniform.csv")
    dry = rows["alpha"] == 0.0
    slide = rows["eps"][dry]
    disk = tribos.Friction(tribos.disk(1.0), mu=1.0, tier=tier)
    twists = np.stack((slide, 0.0 * slide, np.ones_like(slide)), axis=-1)
    wrench = disk.wrench(twists, 1.0)
    assert np.abs(wrench[:, 0] / -np.maximum(rows["F"][dry], 1e-300) - 1.0)[slide > 0].max() < bound
    assert np.abs(wrench[:, 2] / -rows["T"][dry] - 1.0).max() < bound


@pytest.mark.parametrize("older", ["table", "compact"])
def test_older_names_mean_the_exact_tier(older: str) -> None:
    twists = np.random.default_rng(9).normal(size=(20, 3))
    named, exact = (tribos.Friction(tribos.disk(1.0), mu=1.0, tier=t) for t in (older, "exact"))
    assert np.array_equal(named.wrench(twists, 1.0), exact.wrench(twists, 1.0))


def test_powers_of_the_speed_are_right(table) -> None:
    rows = table("uniform.csv")
    for alpha in np.unique(rows["alpha"]):
        here = rows["alpha"] == alpha
        slide = rows["eps"][here]
        disk = tribos.Friction(tribos.disk(1.0), mu=1.0, alpha=float(alpha))
        wrench = disk.wrench(np.stack((slide, 0.0 * slide, np.ones_like(slide)), axis=-1), 1.0)
        assert np.allclose(-wrench[:, 0], rows["F"][here], rtol=3e-15, atol=0.0), alpha
        assert np.allclose(-wrench[:, 2], rows["T"][here], rtol=3e-15, atol=0.0), alpha


def test_a_square_is_right(table) -> None:
    rows = table("polygons.csv")
    here = (rows["shape"] == "square") & (rows["slope_x"] == 0.0) & (rows["slope_y"] == 0.0)
    columns = ("velocity_x", "velocity_y", "spin")
    twists = np.stack([rows[name][here] for name in columns], axis=-1)
    expected = np.stack([rows[name][here] for name in ("force_x", "force_y", "torque")], axis=-1)
    square = tribos.Friction(tribos.box(2.0, 2.0), mu=1.0)
    assert np.abs(square.wrench(twists, 1.0) - expected).max() < 2e-14
    jacobian = square.jacobian(twists, 1.0)
    for at, name in {(0, 0): "xx", (0, 1): "xy", (1, 1): "yy", (0, 2): "xn", (2, 2): "nn"}.items():
        entries = rows[name][here]
        assert np.allclose(-jacobian[:, at[0], at[1]], entries, rtol=1e-11, atol=1e-11), name


ROUND = [
    tribos.disk(0.1),
    tribos.ring(0.1),
    tribos.annulus(0.05, 0.1),
    tribos.hertz(0.1),
    tribos.punch(0.1),
    tribos.paraboloid(0.1),
    tribos.power(0.1, 0.25),
    tribos.polynomial(0.1, [1.0, -0.5]),
]
POLYGONS = [
    tribos.box(0.2, 0.1),
    tribos.polygon([[0, 0], [0.3, 0], [0.1, 0.2]], centre=[0.12, 0.08]),
]
DRY = [
    tribos.bar(0.3),
    tribos.mesh([[0, 0], [0.1, 0], [0, 0.1]], [[0, 1, 2]], [1.0, 2.0, 0.5]),
]
POINTS = [tribos.points([[0, 0], [1, 0], [0, 1]])]


@pytest.mark.parametrize("patch", ROUND + POLYGONS + DRY + POINTS, ids=repr)
def test_a_patch_serves_a_law_or_says_what_does(patch: tribos.Patch) -> None:
    twists = np.random.default_rng(8).normal(size=(20, 3))
    served = {
        "coulomb:mu=0.3": True,
        "power:gamma=0.3,alpha=0.5": patch not in DRY,
        "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05": patch in ROUND + POINTS,
    }
    for law, is_served in served.items():
        if not is_served:
            with pytest.raises(ValueError, match="points"):
                tribos.Friction(patch, law=law)
            continue
        friction = tribos.Friction(patch, law=law)
        wrench = friction.wrench(twists, 10.0)
        assert (np.sum(wrench * twists, axis=-1) < 0.0).all(), law
        one_by_one = [friction.wrench(twist, 10.0) for twist in twists]
        assert np.array_equal(wrench, one_by_one), law


@pytest.mark.parametrize("patch", ROUND + POLYGONS + DRY + POINTS, ids=repr)
def test_a_limit_surface_is_made_of_friction(patch: tribos.Patch) -> None:
    rng = np.random.default_rng(5)
    twists = rng.normal(size=(200, 3))
    friction = tribos.Friction(patch, mu=0.5)
    surface = friction.limit_surface(10.0)
    wrench = friction.wrench(twists, 10.0)
    assert np.allclose(surface.wrench(twists), wrench, rtol=1e-12, atol=1e-13)
    assert np.allclose(surface.gauge(wrench), 1.0, rtol=0.0, atol=1e-9)
    assert np.allclose(surface.support(twists), -np.sum(wrench * twists, axis=-1), rtol=1e-12)
    carried = surface.project(3.0 * wrench)
    assert surface.contains(carried).all()
    assert np.array_equal(surface.project(carried), carried)
    assert np.allclose(surface.scale_to_surface(0.2 * wrench), wrench, rtol=1e-8, atol=1e-9)


def test_the_normal_is_the_motion_under_a_push() -> None:
    surface = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4).limit_surface([10.0, 20.0])
    rng = np.random.default_rng(6)
    pushes = rng.normal(size=(50, 2, 3)) * [1.0, 1.0, 0.1]
    motion = surface.normal(pushes)
    balance = pushes / surface.gauge(pushes)[..., None]
    assert np.allclose(surface.wrench(motion), -balance, rtol=1e-10, atol=1e-11)


@pytest.mark.parametrize("patch", [*ROUND, POLYGONS[0], POINTS[0]], ids=repr)
def test_wrenches_together_are_wrenches_alone_under_one_load_and_under_many(patch) -> None:
    rng = np.random.default_rng(7)
    pushes = (
        rng.normal(size=(150, 3)) * [5.0, 5.0, 0.2] * rng.choice([0.1, 1.0, 9.0], size=(150, 1))
    )
    pushes[3], pushes[4, 0] = 0.0, np.nan
    loads = np.resize([0.0, 0.5, 7.0, 7.0, 300.0], 150)
    exact = tribos.Friction(patch, mu=0.5).limit_surface
    for of in (exact, lambda load: exact(load).ellipsoid()):
        for load in (7.0, loads):
            surface = of(load)
            for ask in ("gauge", "normal", "project"):
                together = getattr(surface, ask)(pushes)
                for k, one in enumerate(np.broadcast_to(load, 150)):
                    alone = getattr(of(float(one)), ask)(pushes[k])
                    assert np.array_equal(together[k], alone, equal_nan=True)


def test_a_radius_follows_the_load() -> None:
    loads, spin = np.array([0.5, 4.0, 30.0]), [0.0, 0.0, 1.0]
    ball = tribos.LoadedFriction("hertz:modulus=2e6,radius=0.01", mu=0.3)
    radii = np.cbrt(0.75 * loads * 0.01 / 2e6)
    assert np.allclose(ball.radius(loads), radii, rtol=1e-15)
    # A Hertzian patch turns against 3 pi/16 of mu N a.
    torques = -3.0 * np.pi / 16.0 * 0.3 * loads * radii
    assert np.allclose(ball.wrench(spin, loads)[:, 2], torques, rtol=1e-14)
    # An adhesive sphere at the pull-off has 4^(-1/3) of the radius without load (Johnson, Kendall and Roberts 1971).
    gel = tribos.LoadedFriction("jkr:modulus=1e5,radius=0.01,work=0.05", mu=1.0)
    off = -1.5 * np.pi * 0.05 * 0.01
    assert gel.radius(off) / gel.radius(0.0) == pytest.approx(0.25 ** (1 / 3), rel=1e-6)
    assert gel.radius(1.001 * off) == 0.0
    # The slope by the load is the difference quotient.
    twist, h = [0.02, 0.01, 7.0], 1e-4
    for area in (
        ball,
        gel,
        tribos.LoadedFriction("finger:scale=3e-3,exponent=0.2", mu=0.5, pressure="disk"),
    ):
        quotient = (area.wrench(twist, loads + h) - area.wrench(twist, loads - h)) / (2.0 * h)
        assert np.allclose(area.slope_by_load(twist, loads), quotient, rtol=1e-6, atol=1e-10)
    fixed = tribos.LoadedFriction(0.02, mu=0.3, pressure="disk")
    alone = tribos.Friction(tribos.disk(0.02), mu=0.3)
    assert np.allclose(fixed.wrench(twist, loads), alone.wrench(twist, loads), rtol=4e-15)
    for text in (
        "hertz:modulus=2e6",
        "hertz:modulus=-1,radius=1",
        "ball",
        "finger:scale=1,exponent=0.5",
        "0",
    ):
        with pytest.raises(ValueError):
            tribos.LoadedFriction(text, mu=0.3)


def test_steps_on_moving_surfaces() -> None:
    wood = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
    crate = tribos.PlanarBody(wood, mass=2.0, inertia=0.02)
    everywhere = [[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]]
    rng = np.random.default_rng(8)
    twists, pushes = rng.normal(size=(2, 40, 3)) * [1.0, 1.0, 5.0]
    # A belt under the whole body is a floor at rest for one who moves with the belt.
    belt = np.array([0.4, -0.2, 0.0])
    moved = crate.step(twists, pushes, 0.01, surface=[(everywhere, belt)])
    still = crate.step(twists - belt, pushes, 0.01)
    assert np.allclose(moved.twists, still.twists + belt, atol=1e-12)
    assert np.array_equal(moved.at_rest, still.at_rest)
    # Halves of the body on two belts are two feet.
    half = tribos.Friction(tribos.box(0.3, 0.1), mu=0.4)
    speeds = [[0.5, 0.0, 0.0], [-0.5, 0.0, 0.0]]
    feet = tribos.feet(
        [(half, 9.81, (0.0, y), 0.0, speed) for y, speed in zip((0.05, -0.05), speeds, strict=True)]
    )
    borders = [[[0, 0], [1, 0]], [[1, 0], [0, 0]]]
    on_belts = crate.step(twists, pushes, 0.01, surface=list(zip(borders, speeds, strict=True)))
    on_feet = feet.step(twists, pushes, 0.01, mass=2.0, inertia=0.02)
    assert np.allclose(on_belts.twists, on_feet.twists, atol=1e-11)
    for wrong in ({"angle": 0.1}, {"load": [1.0, 2.0]}):
        with pytest.raises(ValueError):
            crate.step(twists, pushes, 0.01, surface=[(everywhere, belt)], **wrong)
