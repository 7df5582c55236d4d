"""Feet at rest are held by static friction, and slide under the kinetic one."""

import math

import mujoco
import numpy as np
import pytest

from worlds import BOX_GEOM, FRICTIONLESS, GRAVITY, model_of, state, world

STATIC = {"patch": "box", "size": "0.05 0.05", "mu": 0.3, "mu_s": 0.45}
LOAD = 0.2 * GRAVITY  # N
HEIGHT = 0.01  # of the centre of mass, m


def push(data, x, *, torque=0.0):
    """Pushes the box at its foot, so that it does not tip: N, N m."""
    data.xfrc_applied[1, [0, 4, 5]] = x, -HEIGHT * x, torque


def pushed(keys, x, *, torque=0.0, timestep=0.001, grow=4000, steps=1000):
    """How far a push that grows and then stays moves a box, whether friction holds it, and its speed."""
    model, data = world(BOX_GEOM, keys, option='integrator="implicitfast"')
    model.opt.timestep = timestep
    mujoco.mj_step(model, data, nstep=500)
    start = data.qpos.copy()
    for step in range(grow + steps):
        share = min(1, step / grow)
        push(data, share * x, torque=share * torque)
        mujoco.mj_step(model, data)
    return np.linalg.norm(data.qpos[:2] - start[:2]), state(model, data)[3], data.qvel[0]


@pytest.mark.parametrize("timestep", [0.0005, 0.002, 0.005])
def test_a_push_between_both_limits_holds_at_rest_and_drives_in_motion(timestep):
    moved, held, _ = pushed(STATIC, 0.38 * LOAD, timestep=timestep)
    assert held and moved < 1e-8
    moved, held, _ = pushed(STATIC | {"mu_s": 0.3}, 0.38 * LOAD, timestep=timestep)
    assert not held and moved > 1e-3


@pytest.mark.parametrize("timestep", [0.001, 0.004])
def test_a_box_lets_go_at_its_static_limit(timestep):
    for share in (0.999, 1.001):
        _, held, speed = pushed(STATIC, share * 0.45 * LOAD, timestep=timestep, steps=200)
        assert held == (share < 1)
        if not held:
            # What is left over kinetic friction speeds it up, from one of the last steps of growth on.
            wanted = (share * 0.45 - 0.3) * GRAVITY * 200 * timestep
            assert abs(speed / wanted - 1) < 0.03
    # Turned: the arm of the box is 0.3826 of its side.
    arm = 0.1 * (math.sqrt(2) + math.log(1 + math.sqrt(2))) / 6
    for share in (0.999, 1.001):
        torque = share * 0.45 * LOAD * arm
        assert pushed(STATIC, 0, torque=torque, timestep=timestep, steps=100)[1] == (share < 1)


def test_a_box_that_slides_is_not_caught_and_one_that_stops_is():
    model, data = world(BOX_GEOM, STATIC, option='integrator="implicitfast"')
    mujoco.mj_step(model, data, nstep=500)
    # Let go, then pushed between both limits: it goes on.
    for step in range(600):
        push(data, (0.46 * min(1, step / 200) if step < 220 else 0.38) * LOAD)
        mujoco.mj_step(model, data)
        # Friction knows the push of the step before, and the velocity that its growth has left.
        assert abs(step - 195) < 3 or state(model, data)[3] == (step < 195), step
    # Without push it comes to rest, and the same push holds again.
    push(data, 0)
    mujoco.mj_step(model, data, nstep=2000)
    assert state(model, data)[3]
    place = data.qpos[0]
    for step in range(1000):
        push(data, 0.38 * LOAD * min(1, step / 200))
        mujoco.mj_step(model, data)
    assert state(model, data)[3] and abs(data.qpos[0] - place) < 1e-8


def test_what_rests_longer_holds_more():
    ageing = {"mu_s": 0.32, "ageing_b": 0.02, "ageing_t0": 0.1}
    model, data = world(BOX_GEOM, STATIC | ageing, option='integrator="implicitfast"')
    at = model.plugin_stateadr[0] + 14
    mujoco.mj_step(model, data, nstep=1500)
    rested = data.plugin_state[at]
    assert 1.3 < rested < 1.5
    # A push that grows to 0.34 of the load, and from there by 0.01 of it a second.
    mu = 0.0
    while state(model, data)[3]:
        time = data.time - 1.5
        mu = 0.34 * min(1, time / 0.5) + 0.01 * max(0, time - 0.5)
        rested = data.plugin_state[at]
        push(data, mu * LOAD)
        mujoco.mj_step(model, data)
    # Load and push are those of the step before.
    assert abs(mu - (0.32 + 0.02 * math.log(rested / 0.1))) < 1e-3
    assert data.plugin_state[at] == 0


def test_four_feet_of_a_table_hold_together():
    corners = [(x, y) for x in (-0.2, 0.2) for y in (-0.15, 0.15)]
    feet = {
        f"f{i}": {
            "geom": f"f{i}",
            "ground": "floor",
            "patch": "disk",
            "size": 0.01,
            "mu": 0.3,
            "mu_s": 0.45,
        }
        for i in range(4)
    }
    geoms = "".join(
        f'<geom name="f{i}" type="cylinder" size="0.01 0.01" pos="{x} {y} -0.04" mass="0.01" {FRICTIONLESS}/>'
        for i, (x, y) in enumerate(corners)
    )
    bodies = f"""<geom name="floor" type="plane" size="9 9 0.1"/>
      <body name="table" pos="0 0 0.05"><freejoint/>{geoms}
        <geom type="box" size="0.22 0.17 0.01" mass="0.96" contype="0" conaffinity="0"/></body>"""
    for share, holds in ((0.98, True), (1.02, False)):
        model = model_of(feet, bodies, option='integrator="implicitfast"')
        data = mujoco.MjData(model)
        mujoco.mj_step(model, data, nstep=800)
        place = data.qpos.copy()
        for step in range(600):
            # At the height of the feet, so that nothing tips.
            data.qfrc_applied[0] = share * 0.45 * 10 * min(1, step / 200)
            data.qfrc_applied[4] = -0.05 * data.qfrc_applied[0]
            mujoco.mj_step(model, data)
        held = all(state(model, data, name)[3] for name in feet)
        assert held == holds, share
        assert (np.linalg.norm(data.qpos[:2] - place[:2]) < 1e-4) == holds


def test_equal_coefficients_have_the_bits_of_one():
    results = []
    for keys in (
        STATIC | {"mu_s": ""},
        STATIC | {"mu_s": 0.3},
        {key: STATIC[key] for key in ("patch", "size", "mu")},
    ):
        model, data = world(BOX_GEOM, keys, option='integrator="implicitfast"')
        data.qvel[:2], data.qvel[5] = (0.5, 0.1), 4
        mujoco.mj_step(model, data, nstep=1500)
        results.append(data.qpos.copy())
    assert all(np.array_equal(results[0], other) for other in results)
