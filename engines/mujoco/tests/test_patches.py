"""Every kind of patch has the friction of its own integral."""

import mujoco
import numpy as np
import pytest

from worlds import FRICTIONLESS, GRAVITY, disk_nodes, model_of, state, world, wrench

RADIUS = 0.05
ANGLES = 2.0 * np.pi * (np.arange(720) + 0.5) / 720
RIM = RADIUS * np.column_stack((np.cos(ANGLES), np.sin(ANGLES)))
EVEN = np.full(720, 1.0 / 720)
# A triangle, with points in the middles of 400 equal parts of each of its two triangles over one side.
TRIANGLE = np.array([[0.06, -0.03], [-0.02, 0.05], [-0.04, -0.02]])
FEET = np.array([[0.05, 0.0], [-0.03, 0.04], [-0.03, -0.04]])


def triangle_nodes(corners, count=120):
    """Middles of count² triangles of equal area."""
    points = []
    for i in range(count):
        for j in range(count - i):
            points.append((i + 1.0 / 3.0, j + 1.0 / 3.0))
            if i + j < count - 1:
                points.append((i + 2.0 / 3.0, j + 2.0 / 3.0))
    u, v = np.array(points).T / count
    a, b, c = corners
    places = a + u[:, None] * (b - a) + v[:, None] * (c - a)
    return places, np.full(len(places), 1.0 / len(places))


def text(points):
    return " ".join(f"{number:.17g}" for number in np.ravel(points))


PATCHES = {
    "disk": ({"size": RADIUS}, disk_nodes(RADIUS)),
    "annulus": ({"size": f"0.03 {RADIUS}"}, disk_nodes(RADIUS, inner=0.03)),
    "hertz": ({"size": RADIUS}, disk_nodes(RADIUS, power=0.5)),
    "punch": ({"size": RADIUS}, disk_nodes(RADIUS, power=-0.5)),
    "ring": ({"size": RADIUS}, (RIM, EVEN)),
    "polygon": ({"corners": text(TRIANGLE)}, triangle_nodes(TRIANGLE)),
    "points": ({"corners": text(FEET)}, (FEET, np.full(3, 1.0 / 3.0))),
}


@pytest.mark.parametrize("kind", PATCHES)
@pytest.mark.parametrize("spin", [2.0, 12.5, 40.0])
def test_friction_is_the_integral_over_the_patch(kind, spin):
    keys, nodes = PATCHES[kind]
    # A heavy body hardly turns or slows down in a step: friction is that of its motion.
    plate = f'type="box" size="0.5 0.5 0.01" mass="100" {FRICTIONLESS}'
    model, data = world(plate, {"patch": kind, "mu": 0.3} | keys)
    mujoco.mj_step(model, data, nstep=300)
    data.qvel[:6] = [0.6, -0.3, 0.0, 0.0, 0.0, spin]
    before = 2.0 * np.arctan2(data.qpos[6], data.qpos[3])
    mean = 0.5 * data.qvel[[0, 1, 5]]
    mujoco.mj_step(model, data)
    mean = mean + 0.5 * data.qvel[[0, 1, 5]]
    load, force, torque, is_held = state(model, data)
    assert load == pytest.approx(100.0 * GRAVITY, rel=1e-3)
    assert not is_held
    # In the axes of the patch at the step's begin.
    cosine, sine = np.cos(before), np.sin(before)
    to_patch = np.array([[cosine, sine], [-sine, cosine]])
    exact = wrench(nodes, 0.3, load, [*(to_patch @ mean[:2]), mean[2]])
    largest = 0.3 * load
    assert to_patch @ force[:2] == pytest.approx(exact[:2], abs=1e-3 * largest)
    assert torque == pytest.approx(exact[2], abs=1e-3 * largest * RADIUS)


def test_a_body_on_three_points_turns_beyond_its_limit_alone():
    plate = f'type="box" size="0.05 0.05 0.01" mass="1" {FRICTIONLESS}'
    model, data = world(plate, {"patch": "points", "mu": 0.3, "corners": text(FEET)})
    mujoco.mj_step(model, data, nstep=300)
    # A couple below its limit moves nothing, one above it turns the body.
    limit = 0.3 * GRAVITY * np.linalg.norm(FEET, axis=1).mean()
    data.qfrc_applied[5] = 0.9 * limit
    mujoco.mj_step(model, data, nstep=400)  # the first step does not know the couple yet
    place = data.qpos.copy()
    mujoco.mj_step(model, data, nstep=300)
    assert state(model, data)[3]
    assert np.abs(data.qpos - place).max() < 1e-10
    data.qfrc_applied[5] = 1.2 * limit
    mujoco.mj_step(model, data, nstep=30)
    assert not state(model, data)[3]
    assert data.qvel[5] > 0.0


def test_without_coefficient_nothing_is_slowed_down():
    keys = {"geom": "foot", "ground": "floor", "patch": "disk", "size": RADIUS, "mu": 0}
    bodies = f"""<geom name="floor" type="plane" size="9 9 0.1"/>
        <body pos="0 0 0.01"><freejoint/><geom name="foot" type="cylinder" size="0.05 0.01" {FRICTIONLESS}/></body>"""
    model = model_of({"foot": keys}, bodies)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=300)
    data.qvel[:6] = [1.0, 0.0, 0.0, 0.0, 0.0, 5.0]
    mujoco.mj_step(model, data, nstep=300)
    assert data.qvel[0] == pytest.approx(1.0, abs=1e-12)
    assert data.qvel[5] == pytest.approx(5.0, abs=1e-12)
