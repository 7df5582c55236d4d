"""Motion on exact patches."""

import math

import mujoco
import numpy as np
import pytest

from worlds import (
    BOX,
    BOX_GEOM,
    DISK,
    FRICTIONLESS,
    GRAVITY,
    PUCK_GEOM,
    box_nodes,
    disk_nodes,
    missed,
    model_of,
    slide,
    state,
    travel,
    world,
    wrench,
)


@pytest.mark.parametrize("spin", [0.0, 5.0, 12.5, 50.0])
@pytest.mark.parametrize(
    ("geom", "keys", "nodes", "gyration_sq"),
    [
        (PUCK_GEOM, DISK, disk_nodes(0.05), 0.05**2 / 2.0),
        (BOX_GEOM, BOX, box_nodes(0.05, 0.05), 2.0 * 0.05**2 / 3.0),
    ],
)
def test_travel_to_rest_is_that_of_the_equation_of_motion(geom, keys, nodes, gyration_sq, spin):
    model, data = world(geom, keys)
    path = slide(model, data, 1.0, spin)
    assert state(model, data)[3]
    exact = travel(nodes, 0.3, gyration_sq, 1.0, spin)[0]
    # MuJoCo's positions are late by half a step's path; what is left is of second order.
    late = 0.5 * 1e-3 * 1.0
    assert path[0] + late == pytest.approx(exact, rel=5e-4)


@pytest.mark.parametrize("integrator", ["Euler", "implicit", "implicitfast"])
@pytest.mark.parametrize("jacobian", ["dense", "sparse"])
def test_a_sliding_box_meets_the_friction_of_its_patch(integrator, jacobian):
    model, data = world(BOX_GEOM, BOX, option=f'integrator="{integrator}" jacobian="{jacobian}"')
    slide(model, data, 1.0, 20.0, steps=50)
    turn = 2.0 * math.atan2(data.qpos[6], data.qpos[3])
    before = data.qvel[[0, 1, 5]].copy()
    mujoco.mj_step(model, data)
    load, force, torque, is_held = state(model, data)
    assert not is_held
    assert load == pytest.approx(0.2 * GRAVITY, rel=1e-3)
    # Friction is that at half time.
    mean = 0.5 * (before + data.qvel[[0, 1, 5]])
    middle = turn + 0.5e-3 * mean[2]
    cosine, sine = math.cos(middle), math.sin(middle)
    to_box = np.array([[cosine, sine], [-sine, cosine]])
    exact = wrench(box_nodes(0.05, 0.05), 0.3, load, [*(to_box @ mean[:2]), mean[2]])
    assert to_box @ force[:2] == pytest.approx(exact[:2], rel=2e-3, abs=3e-4)
    assert torque == pytest.approx(exact[2], rel=2e-3)


@pytest.mark.parametrize(
    ("geom", "height"),
    [(PUCK_GEOM, 0.01), (BOX_GEOM, 0.01), (BOX_GEOM.replace("0.01", "0.03"), 0.03)],
)
@pytest.mark.parametrize("share", [0.9, 0.99, 1.01, 1.1])
def test_on_a_tilted_floor_a_body_slides_beyond_the_angle_of_friction_alone(geom, height, share):
    angle = math.atan(0.3 * share)
    model, data = world(
        geom,
        DISK,
        height=height / math.cos(angle),
        floor=f'type="plane" size="9 9 0.1" euler="0 {math.degrees(angle)} 0"',
    )
    data.qpos[3:7] = [math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0]
    mujoco.mj_step(model, data, nstep=800)
    start, speed = data.qpos[:3].copy(), data.qvel[:3].copy()
    mujoco.mj_step(model, data, nstep=500)
    if share < 1.0:
        assert np.abs(data.qpos[:3] - start).max() < 1e-10
        assert state(model, data)[3]
    else:
        gained = np.linalg.norm(data.qvel[:3] - speed) / 0.5
        expected = GRAVITY * (math.sin(angle) - 0.3 * math.cos(angle))
        assert gained == pytest.approx(expected, rel=1e-3)


def test_a_push_below_the_limit_moves_nothing_and_one_above_it_what_is_left():
    model, data = world(PUCK_GEOM, DISK)
    weight = 0.2 * GRAVITY
    mujoco.mj_step(model, data, nstep=400)
    data.qfrc_applied[1] = 0.95 * 0.3 * weight
    mujoco.mj_step(model, data, nstep=600)  # leans back
    start = data.qpos[:2].copy()
    mujoco.mj_step(model, data, nstep=600)
    assert np.abs(data.qpos[:2] - start).max() < 1e-12
    data.qfrc_applied[1] = 1.5 * 0.3 * weight
    mujoco.mj_step(model, data, nstep=100)
    before = data.qvel[1]
    mujoco.mj_step(model, data, nstep=100)
    assert (data.qvel[1] - before) / 0.1 == pytest.approx(0.5 * 0.3 * GRAVITY, rel=1e-3)


def test_a_tall_body_that_is_pushed_suddenly_is_held_in_the_next_step():
    geom = f'type="box" size="0.05 0.05 0.15" mass="1" {FRICTIONLESS}'
    model, data = world(geom, BOX, height=0.15)
    mujoco.mj_step(model, data, nstep=1500)
    # At its foot, where it does not tilt the body; in the first step the foot does not know of it.
    push = 0.3 * 0.3 * GRAVITY
    data.xfrc_applied[1, [0, 4]] = [push, -0.15 * push]
    speeds = []
    for _ in range(6):
        mujoco.mj_step(model, data)
        assert state(model, data)[3]
        speeds.append(data.qvel[0] - 0.15 * data.qvel[4])
    # A fiftieth of the way of the first step is taken back in each of the next; the contacts' springs take what is
    # left of the tilt.
    back = -0.02 * speeds[0] * 0.98 ** np.arange(5)
    left = np.abs(speeds[1:] - back) / speeds[0]
    assert left[:2].max() < 0.03
    assert left[2:].max() < 1e-3


def cart(gear):
    bodies = f"""
        <body><joint name="cart" type="slide" axis="1 0 0"/>
          <geom name="cart" type="box" size="1 1 0.05" mass="2"/></body>
        <body pos="0 0 0.06"><freejoint/>
          <geom name="foot" type="box" size="0.05 0.05 0.01" mass="0.5" {FRICTIONLESS}/></body>"""
    more = f'<actuator><motor joint="cart" gear="{gear}"/></actuator>'
    model = model_of({"foot": {"geom": "foot", "ground": "cart"} | DISK}, bodies, more=more)
    data = mujoco.MjData(model)
    data.ctrl[:] = 1.0
    return model, data


def test_a_moving_ground_takes_a_body_along():
    model, data = cart(5.0)
    mujoco.mj_step(model, data, nstep=300)
    offset = data.qpos[1] - data.qpos[0]
    mujoco.mj_step(model, data, nstep=300)
    assert data.qpos[1] - data.qpos[0] == pytest.approx(offset, abs=1e-10)
    assert state(model, data)[3]
    # Both are driven as one body.
    assert data.qacc[0] == pytest.approx(5.0 / 2.5, rel=1e-7)


def test_a_ground_that_is_drawn_away_receives_the_reaction():
    model, data = cart(20.0)
    mujoco.mj_step(model, data, nstep=300)
    assert not state(model, data)[3]
    assert data.qacc[1] == pytest.approx(0.3 * GRAVITY, rel=1e-3)
    assert data.qacc[0] == pytest.approx((20.0 - 0.3 * 0.5 * GRAVITY) / 2.0, rel=1e-3)


@pytest.mark.skipif(mujoco.mj_version() < 4000000, reason="MuJoCo has conveyors since 4.0")
@pytest.mark.parametrize("is_turned", [False, True])
def test_a_conveyor_takes_a_body_along(is_turned):
    # Geoms are in the order of the bodies: the ground before the foot, and after it.
    belt = '<geom name="floor" type="box" size="9 9 0.1" pos="0 0 -0.1" surfacevel="0.2 -0.1 0 0 0 0.5"/>'
    body = f'<body pos="0 0 0.01"><freejoint/><geom name="foot" {PUCK_GEOM}/></body>'
    if is_turned:
        belt = f"<body>{belt}</body>"
    bodies = body + belt if is_turned else belt + body
    model = model_of({"foot": {"geom": "foot", "ground": "floor"} | DISK}, bodies)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=400)
    x, y = data.qpos[:2]
    # The surface turns about the geom's own centre.
    expected = [0.2 - 0.5 * y, -0.1 + 0.5 * x, 0.5]
    assert data.qvel[[0, 1, 5]] == pytest.approx(expected, abs=1e-3)
    assert state(model, data)[3]


TABLE = '<geom name="floor" type="cylinder" size="0.5 0.02" mass="100" {more}/>'


def feet_of(places):
    legs = "".join(
        f'<geom name="foot{i}" type="cylinder" size="0.03 0.01" pos="{x} {y} 0" mass="0.2" {FRICTIONLESS}/>'
        for i, (x, y) in enumerate(places)
    )
    keys = {"ground": "floor", "patch": "disk", "size": 0.03, "mu": 0.3}
    return legs, {f"foot{i}": {"geom": f"foot{i}"} | keys for i in range(len(places))}


def against_floor(model, data):
    """Place of the last body on the floor, and the angle by which it is turned there."""
    mujoco.mj_kinematics(model, data)
    floor = data.geom("floor")
    turn = floor.xmat.reshape(3, 3).T
    x = turn @ data.xmat[-1].reshape(3, 3)[:, 0]
    return np.array([*(turn @ (data.xpos[-1] - floor.xpos))[:2], math.atan2(x[1], x[0])])


@pytest.mark.parametrize(
    "places",
    [
        [(0.0, 0.0)],
        [(0.04, 0.0), (-0.04, 0.04), (-0.04, -0.04)],
        [(x, y) for x in (0.04, -0.04) for y in (0.04, -0.04)],
    ],
)
@pytest.mark.parametrize(
    ("floor", "tilt", "drive", "wanted"),
    [
        # Half, and 0.95, of the rate at which it would slip.
        ('<joint name="a" type="hinge" axis="0 0 1"/>', 0.0, "velocity", lambda t: [1.94]),
        ('<joint name="a" type="hinge" axis="0 0 1"/>', 0.0, "velocity", lambda t: [3.68]),
        # Tilted against its axis; with its axis; to and fro.
        ('<joint name="a" type="hinge" axis="0.1 0 1"/>', 0.0, "velocity", lambda t: [2.0]),
        ('<joint name="a" type="hinge" axis="0 0 1"/>', 6.0, "velocity", lambda t: [2.0]),
        (
            '<joint name="a" type="hinge" axis="0 0 1"/>',
            0.0,
            "position",
            lambda t: [math.sin(3.0 * t)],
        ),
        # Rocking about an axis below it; shaken while it turns.
        (
            '<joint name="a" type="hinge" axis="1 0 0" pos="0 0 -0.3"/>',
            0.0,
            "position",
            lambda t: [0.15 * math.sin(math.pi * t)],
        ),
        (
            '<joint name="a" type="slide" axis="1 0 0"/><joint name="b" type="hinge" axis="0 0 1"/>',
            0.0,
            "position",
            lambda t: [0.05 * math.sin(3.0 * t), math.sin(3.0 * t)],
        ),
    ],
)
def test_what_rests_on_a_moving_floor_stays(places, floor, tilt, drive, wanted):
    legs, feet = feet_of(places)
    tilted = math.radians(tilt)
    x, z = 0.2, 0.0299
    at = (x * math.cos(tilted) + z * math.sin(tilted), z * math.cos(tilted) - x * math.sin(tilted))
    bodies = f"""
        <body euler="0 {tilt} 0">{floor}{TABLE.format(more="")}</body>
        <body pos="{at[0]} 0 {at[1]}" euler="0 {tilt} 0"><freejoint/>{legs}</body>"""
    gain = 'kp="2e4" kv="2e3"' if drive == "position" else 'kv="2e3"'
    count = floor.count("<joint")
    drives = "".join(f'<{drive} joint="{name}" {gain}/>' for name in "ab"[:count])
    model = model_of(feet, bodies, more=f"<actuator>{drives}</actuator>")
    model.opt.timestep = 2e-3
    data = mujoco.MjData(model)

    def steps(count):
        for _ in range(count):
            data.ctrl[:] = np.array(wanted(data.time)) * min(1.0, data.time / 2.0)
            mujoco.mj_step(model, data)

    steps(2000)
    places, start = [], against_floor(model, data)
    settled = [missed(model, data, name) for name in feet]
    for _ in range(20):
        steps(250)
        places.append(against_floor(model, data) - start)
    # The first order of the step would carry it by 3 to 15 mm. Contacts' springs let it sway; feet whose
    # heights differ by less than a micrometre are not held against each other.
    assert np.abs(places)[:, :2].max() < 2e-5
    assert np.abs(places)[:, 2].max() < 1e-4
    assert [missed(model, data, name) for name in feet] == settled


def test_a_body_that_is_pinched_too_weakly_falls_and_else_hangs_still():
    text = f"""
        <body pos="-0.03 0 0" gravcomp="1"><joint name="left" type="slide" axis="1 0 0" damping="20"/>
          <geom name="left" type="box" size="0.01 0.02 0.02" mass="0.2" {FRICTIONLESS}/></body>
        <body pos="0.03 0 0" gravcomp="1"><joint name="right" type="slide" axis="-1 0 0" damping="20"/>
          <geom name="right" type="box" size="0.01 0.02 0.02" mass="0.2" {FRICTIONLESS}/></body>
        <body><freejoint/><geom name="held" type="box" size="0.02 0.02 0.05" mass="0.1"/></body>"""
    finger = {"ground": "held", "patch": "disk", "size": 0.005, "mu": 1.0}
    feet = {name: {"geom": name} | finger for name in ("left", "right")}
    more = '<actuator><motor joint="left"/><motor joint="right"/></actuator>'
    model = model_of(feet, text, gravity="0 0 0", more=more)
    for share in (2.0, 20.0, 95.0, 0.8):
        data = mujoco.MjData(model)
        model.opt.gravity[2] = 0.0
        data.ctrl[:] = share * 0.1 * GRAVITY / 2.0
        mujoco.mj_step(model, data, nstep=300)  # closes
        model.opt.gravity[2] = -GRAVITY
        mujoco.mj_step(model, data, nstep=3 if share < 1.0 else 500)
        place, speed = data.qpos[4], data.qvel[4]
        loads = []
        for _ in range(30):
            mujoco.mj_step(model, data)
            loads.append([state(model, data, name)[0] for name in feet])
        load = np.mean(loads, axis=0)
        if share < 1.0:
            # The fingers press a little less while the body turns, and the rest of the weight accelerates it.
            assert load == pytest.approx(share * 0.1 * GRAVITY / 2.0, rel=5e-2)
            assert (data.qvel[4] - speed) / 0.03 == pytest.approx(
                load.sum() / 0.1 - GRAVITY, rel=1e-2
            )
            continue
        assert abs(data.qpos[4] - place) < 2e-10
        states = [state(model, data, name) for name in ("left", "right")]
        # Friction acts on the fingers: both together carry the weight.
        assert sum(force[2] for _, force, _, _ in states) == pytest.approx(-0.1 * GRAVITY, rel=1e-5)
        assert all(is_held for *_, is_held in states)


def test_a_table_on_four_feet_stands_still_and_slides_by_the_law():
    places = {"a": (0.3, 0.2), "b": (-0.3, 0.2), "c": (-0.3, -0.2), "d": (0.3, -0.2)}
    legs = "".join(
        f'<geom name="{name}" type="cylinder" size="0.02 0.01" pos="{x} {y} 0" mass="0.1" {FRICTIONLESS}/>'
        for name, (x, y) in places.items()
    )
    bodies = f"""
        <geom name="floor" type="plane" size="9 9 0.1"/>
        <body pos="0 0 0.01"><freejoint/>{legs}
          <geom name="top" type="box" size="0.35 0.25 0.01" pos="0.05 0.02 0.05" mass="2"/></body>"""
    foot = {"ground": "floor", "patch": "disk", "size": 0.02, "mu": 0.3}
    feet = {name: {"geom": name} | foot for name in places}
    for share in (0.95, 1.2):
        angle = math.atan(0.3 * share)
        gravity = f"{GRAVITY * math.sin(angle)} 0 {-GRAVITY * math.cos(angle)}"
        model = model_of(feet, bodies, gravity=gravity)
        data = mujoco.MjData(model)
        mujoco.mj_step(model, data, nstep=600)
        start, speed = data.qpos[:3].copy(), data.qvel[0]
        mujoco.mj_step(model, data, nstep=200)
        if share < 1.0:
            assert np.abs(data.qpos[:3] - start).max() < 1e-9
            assert all(state(model, data, name)[3] for name in places)
        else:
            expected = GRAVITY * (math.sin(angle) - 0.3 * math.cos(angle))
            assert (data.qvel[0] - speed) / 0.2 == pytest.approx(expected, rel=1e-2)


def test_a_stack_moves_as_one_body_until_its_top_is_left_behind():
    bodies = f"""
        <geom name="floor" type="plane" size="9 9 0.1"/>
        <body pos="0 0 0.01"><freejoint/>
          <geom name="low" type="box" size="0.1 0.1 0.01" mass="0.4" {FRICTIONLESS}/></body>
        <body pos="0 0 0.03"><freejoint/>
          <geom name="top" type="box" size="0.05 0.05 0.01" mass="0.2" {FRICTIONLESS}/></body>"""
    feet = {
        "low": {"geom": "low", "ground": "floor", "patch": "box", "size": "0.1 0.1", "mu": 0.2},
        "top": {"geom": "top", "ground": "low", "patch": "box", "size": "0.05 0.05", "mu": 0.3},
    }
    model = model_of(feet, bodies)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=400)
    # Weights are 6 N below and 2 N above: 1.2 N hold the stack, 0.6 N the top.
    for push, low, top in ((1.1, 0.0, 0.0), (2.4, 2.0, 2.0), (4.4, (4.4 - 1.2 - 0.6) / 0.4, 3.0)):
        data.qfrc_applied[0] = push
        mujoco.mj_step(model, data, nstep=20)
        before = data.qvel.copy()
        mujoco.mj_step(model, data, nstep=40)
        rates = (data.qvel - before) / 0.04
        assert rates[[0, 6]] == pytest.approx([low, top], rel=2e-2, abs=2e-3)
        assert state(model, data, "low")[3] == (push < 1.2)
        assert state(model, data, "top")[3] == (top == low)


def test_a_lifted_foot_has_no_friction():
    model, data = world(PUCK_GEOM, DISK, height=1.0)
    data.qvel[:] = [1.0, 0.0, 0.0, 0.0, 0.0, 3.0]
    mujoco.mj_step(model, data, nstep=20)
    assert data.qvel[0] == 1.0
    assert state(model, data)[0] == 0.0


def test_a_ball_on_a_puck_adds_its_weight_to_the_load():
    ball = '<body pos="0 0 0.0399"><freejoint/><geom type="sphere" size="0.02" mass="0.1"/></body>'
    model, data = world(PUCK_GEOM, DISK, more=ball)
    mujoco.mj_step(model, data, nstep=500)
    load, *_, is_held = state(model, data)
    assert load == pytest.approx(0.3 * GRAVITY, rel=1e-3)
    assert is_held


def test_several_geoms_are_one_foot_in_the_frame_of_a_site():
    bodies = f"""
        <geom name="floor" type="plane" size="9 9 0.1"/>
        <body pos="0 0 0.0099"><freejoint/><site name="sole" pos="0.01 0 0" euler="0 0 30"/>
          <geom name="heel" type="box" size="0.02 0.03 0.01" pos="-0.05 0 0" mass="0.5" {FRICTIONLESS}/>
          <geom name="toe" type="box" size="0.02 0.03 0.01" pos="0.07 0 0" mass="0.5" {FRICTIONLESS}/></body>"""
    keys = {
        "geom": "heel toe",
        "ground": "floor",
        "site": "sole",
        "patch": "box",
        "size": "0.08 0.03",
        "mu": 0.3,
    }
    model = model_of({"sole": keys}, bodies)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=300)
    assert state(model, data, "sole")[0] == pytest.approx(GRAVITY, rel=1e-3)
    # It turns about the middle of the patch from the largest torque of the patch on.
    data.qfrc_applied[5] = 1.02 * abs(wrench(box_nodes(0.08, 0.03), 0.3, GRAVITY, [0, 0, 1.0])[2])
    mujoco.mj_step(model, data, nstep=20)
    assert not state(model, data, "sole")[3]
    data.qfrc_applied[5] *= 0.9 / 1.02
    mujoco.mj_step(model, data, nstep=200)
    assert state(model, data, "sole")[3]
