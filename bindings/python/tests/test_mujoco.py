"""Exact patches in MuJoCo."""

from __future__ import annotations

import copy
import math

import numpy as np
import pytest

mujoco = pytest.importorskip("mujoco")

import tribos  # noqa: E402
import tribos.mujoco  # noqa: E402

GRAVITY = 10.0


def world(
    shape: str,
    *,
    height: float = 0.01,
    option: str = "",
    floor: str = 'type="plane" size="9 9 0.1"',
    more: str = "",
):
    """A body on a floor."""
    text = f"""
    <mujoco>
      <option timestep="0.001" gravity="0 0 -{GRAVITY}" {option}/>
      <worldbody>
        <geom name="floor" {floor}/>
        <body name="body" pos="0 0 {height}"><freejoint/><geom name="foot" {shape} mass="0.2"/></body>
        {more}
      </worldbody>
    </mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    return model, mujoco.MjData(model)


PUCK = 'type="cylinder" size="0.05 0.01"'
BOX = 'type="box" size="0.05 0.05 0.01"'
DISK = tribos.Friction(tribos.disk(0.05), mu=0.3)


@pytest.fixture(autouse=True)
def no_callback_is_left():
    yield
    left = mujoco.get_mjcb_passive()
    mujoco.set_mjcb_passive(None)
    assert left is None


def travel(friction, gyration_sq, speed, spin, gravity=GRAVITY, dt=1e-4):
    """Path, sideways path and angle to rest by the equation of motion, with the midpoint rule."""
    per_mass = np.array([1.0, 1.0, 1.0 / gyration_sq])

    def rate(twist, angle):
        cosine, sine = math.cos(angle), math.sin(angle)
        turn = np.array([[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]])
        return turn.T @ friction.wrench(turn @ twist, load=gravity) * per_mass

    place, twist = np.zeros(3), np.array([speed, 0.0, spin])
    while np.hypot(np.hypot(twist[0], twist[1]), 0.05 * twist[2]) > 1e-3:
        half = twist + 0.5 * dt * rate(twist, place[2])
        twist = twist + dt * rate(half, place[2] + 0.5 * dt * twist[2])
        place = place + dt * half
    return place


def slide(model, data, speed, spin, steps=1500):
    """Path of the body to rest, once it has settled."""
    mujoco.mj_step(model, data, nstep=400)
    start = data.qpos[:3].copy()
    data.qvel[:6] = [speed, 0.0, 0.0, 0.0, 0.0, spin]
    mujoco.mj_step(model, data, nstep=steps)
    return data.qpos[:3] - start


@pytest.mark.parametrize("spin", [0.0, 12.5, 50.0])
@pytest.mark.parametrize(
    ("shape", "patch", "gyration_sq"),
    [
        (PUCK, tribos.disk(0.05), 0.05**2 / 2.0),
        (BOX, tribos.box(0.1, 0.1), 2.0 * 0.05**2 / 3.0),
    ],
)
def test_travel_to_rest_is_that_of_the_equation_of_motion(shape, patch, gyration_sq, spin):
    friction = tribos.Friction(patch, mu=0.3)
    model, data = world(shape)
    with tribos.mujoco.attach(model, data, {"foot": friction}, floor="floor") as feet:
        path = slide(model, data, 1.0, spin)
        assert feet["foot"].is_held
    exact = travel(friction, gyration_sq, 1.0, spin)[0]
    # MuJoCo's positions are late by half a step's path; what is left is of second order.
    late = 0.5 * 1e-3 * 1.0
    assert path[0] == pytest.approx(exact, rel=3.2e-3)
    assert path[0] + late == pytest.approx(exact, rel=3e-4)


@pytest.mark.parametrize("integrator", ["Euler", "implicit", "implicitfast"])
def test_a_sliding_puck_meets_the_friction_of_its_patch(integrator):
    model, data = world(PUCK, option=f'integrator="{integrator}"')
    with tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor") as feet:
        slide(model, data, 1.0, 20.0, steps=50)
        state = feet["foot"]
        assert not state.is_held
        assert state.load == pytest.approx(0.2 * GRAVITY, rel=1e-3)
        # Friction is that at half time: between those of the step's begin and end.
        exact = DISK.wrench(state.twist, load=state.load)
        assert state.friction == pytest.approx(exact, rel=2e-2, abs=1e-4)
        assert state.axes[2] == pytest.approx([0.0, 0.0, 1.0], abs=1e-3)


def test_the_frame_of_a_box_turns_with_it_and_a_site_can_replace_it():
    model, data = world(
        BOX, more='<site name="corner" pos="0.3 0 0" euler="0 0 30"/>', option='integrator="Euler"'
    )
    data.qpos[2] -= 1e-4
    data.qpos[3:7] = [math.cos(math.pi / 8), 0.0, 0.0, math.sin(math.pi / 8)]
    friction = {"foot": tribos.Friction(tribos.box(0.1, 0.1), mu=0.3)}
    with tribos.mujoco.attach(model, data, friction, floor="floor") as feet:
        assert feet["foot"].axes[0] == pytest.approx([math.sqrt(0.5), math.sqrt(0.5), 0.0])
    sites = {"foot": "corner"}
    with tribos.mujoco.attach(model, data, friction, floor="floor", sites=sites) as feet:
        turn = math.radians(30.0)
        assert feet["foot"].axes[0] == pytest.approx([math.cos(turn), math.sin(turn), 0.0])
        assert feet["foot"].centre == pytest.approx([0.3, 0.0, 0.0], abs=1e-3)


FINGERS = """
    <mujoco>
      <option timestep="0.002"/>
      <worldbody>
        <body pos="-0.03 0 0" gravcomp="1"><joint name="left" type="slide" axis="1 0 0" damping="20"/>
          <geom name="left" type="box" size="0.01 0.02 0.02" mass="0.2"/></body>
        <body pos="0.03 0 0" gravcomp="1"><joint name="right" type="slide" axis="-1 0 0" damping="20"/>
          <geom name="right" type="box" size="0.01 0.02 0.02" mass="0.2"/></body>
        <body><freejoint/><geom name="held" {shape} mass="0.1"/></body>
      </worldbody>
      <actuator><motor joint="left"/><motor joint="right"/></actuator>
    </mujoco>"""


@pytest.mark.parametrize(
    "shape", ['type="capsule" size="0.02 0.05"', 'type="box" size="0.02 0.02 0.05"']
)
@pytest.mark.parametrize("margin", [2.0, 20.0, 95.0])
def test_a_pinched_body_does_not_creep(shape, margin):
    model = mujoco.MjModel.from_xml_string(FINGERS.format(shape=shape))
    data = mujoco.MjData(model)
    data.ctrl[:] = margin * 0.1 * 9.81 / 2.0
    finger = tribos.Friction(tribos.disk(0.005), mu=1.0)
    with tribos.mujoco.attach(model, data, {"left": finger, "right": finger}, floor="held") as feet:
        mujoco.mj_step(model, data, nstep=500)
        start = data.qpos[4]
        mujoco.mj_step(model, data, nstep=1000)
        assert abs(data.qpos[4] - start) < 2e-10
        # Both fingers together carry the weight, whatever each of them does.
        states = [feet["left"], feet["right"]]
        lift = sum(state.friction @ (state.axes * [[1], [1], [0]])[:, 2] for state in states)
        assert lift == pytest.approx(-0.1 * 9.81, rel=1e-5)
        assert all(state.is_held for state in states)


ANGLES = np.radians([90.0, 210.0, 330.0])
PLACES = 0.1 * np.column_stack((np.cos(ANGLES), np.sin(ANGLES)))
BALLS = ("a", "b", "c")


def three_balls():
    geoms = "".join(
        f'<geom name="{name}" type="sphere" size="0.01" pos="{x} {y} 0" mass="0"/>'
        for name, (x, y) in zip(BALLS, PLACES, strict=True)
    )
    text = f"""
    <mujoco>
      <option timestep="0.001" gravity="0 0 -{GRAVITY}"/>
      <worldbody>
        <geom name="floor" type="plane" size="9 9 0.1"/>
        <body pos="0 0 0.01"><freejoint/>
          <inertial pos="0 0 -0.01" mass="1" diaginertia="0.003 0.003 0.005"/>{geoms}</body>
      </worldbody>
    </mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    return model, mujoco.MjData(model)


@pytest.mark.parametrize("spin", [3.0, 12.5])
@pytest.mark.parametrize("is_one", [True, False])
def test_a_body_on_three_balls_moves_as_one_on_three_points(spin, is_one):
    points = tribos.Friction(tribos.points(PLACES), mu=0.3)
    model, data = three_balls()
    small = tribos.Friction(tribos.disk(1e-5), mu=0.3)
    feet = {BALLS: points} if is_one else dict.fromkeys(BALLS, small)
    with tribos.mujoco.attach(model, data, feet, floor="floor"):
        path = slide(model, data, 1.0, spin)
    exact = travel(points, 0.005, 1.0, spin)
    assert path[0] == pytest.approx(exact[0], rel=4e-3)
    assert path[1] == pytest.approx(exact[1], abs=1e-4)


def test_two_simulations_run_beside_each_other_with_their_own_states():
    first, second = world(PUCK), world(PUCK)
    third = (first[0], mujoco.MjData(first[0]))
    alone = []
    for model, data, spin in ((*first, 10.0), (*second, 30.0), (*third, 20.0)):
        with tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor"):
            alone.append(slide(model, data, 1.0, spin, steps=100)[0])
        mujoco.mj_resetData(model, data)
    with (
        tribos.mujoco.attach(*first, {"foot": DISK}, floor="floor") as feet,
        tribos.mujoco.attach(*second, {"foot": DISK}, floor="floor"),
    ):
        mujoco.mj_forward(*third)
        runs = [(*first, 10.0), (*second, 30.0), (*third, 20.0)]
        for _ in range(400):
            for model, data, _ in runs:
                mujoco.mj_step(model, data)
        starts = [data.qpos[0] for _, data, _ in runs]
        for _, data, spin in runs:
            data.qvel[:] = [1.0, 0.0, 0.0, 0.0, 0.0, spin]
        for _ in range(100):
            for model, data, _ in runs:
                mujoco.mj_step(model, data)
        found = [data.qpos[0] - start for (_, data, _), start in zip(runs, starts, strict=True)]
        assert feet.state("foot", third[1]).twist[2] != feet["foot"].twist[2]
    assert found == pytest.approx(alone, rel=1e-12)


def test_close_gives_the_model_and_the_callback_back():
    calls = []
    model, data = world(PUCK)
    model.geom_condim[:] = [3, 4]
    before = model.geom_condim.copy()
    own = lambda *_: calls.append(1)  # noqa: E731
    mujoco.set_mjcb_passive(own)
    feet = tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor")
    assert model.geom_condim.tolist() == [1, 1]
    mujoco.mj_step(model, data)
    assert len(calls) == 2, "a callback of before is still called"
    feet.close()
    feet.close()
    assert (model.geom_condim == before).all()
    assert mujoco.get_mjcb_passive() is own
    mujoco.set_mjcb_passive(None)
    assert "closed" in repr(feet)
    with pytest.raises(ValueError, match="closed"):
        feet["foot"]


def test_only_steps_of_the_model_with_data_of_its_own_have_feet():
    model, data = world(PUCK)
    more = '<body pos="0 1 1"><freejoint/><geom size="0.1"/></body>'
    (larger, strange), (_, alone) = world(PUCK, more=more), world(PUCK, more=more)
    with pytest.raises(ValueError, match="another model"):
        tribos.mujoco.attach(model, strange, {"foot": DISK}, floor="floor")
    assert model.geom_condim.tolist() == [3, 3]
    mujoco.mj_step(larger, alone, nstep=100)
    with tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor") as feet:
        for other in (strange, mujoco.MjData(model)):
            with pytest.raises(ValueError, match="made no step"):
                feet.state("foot", other)
        mujoco.mj_step(larger, strange, nstep=100)
        assert (strange.qpos == alone.qpos).all()
        # A copy of the model has contacts without friction, and no feet.
        mujoco.mj_step(model, data, nstep=400)
        data.qvel[:] = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]
        mujoco.mj_step(copy.copy(model), data, nstep=10)
        assert data.qvel[0] == pytest.approx(1.0, abs=1e-9)


def test_models_can_be_compiled_in_a_pause():
    model, data = world(PUCK)
    with tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor") as feet:
        with tribos.mujoco.paused():
            world(BOX)
        slide(model, data, 1.0, 0.0, steps=10)
        assert feet["foot"].friction[0] == pytest.approx(-0.3 * 0.2 * GRAVITY, rel=1e-2)


@pytest.mark.parametrize("places", [[(0.0, 0.0)], [(0.04, 0.0), (-0.04, 0.04), (-0.04, -0.04)]])
@pytest.mark.parametrize(
    ("joint", "rate"),
    [
        ('axis="0 0 1"', 1.94),  # half of the rate at which it would slip
        ('axis="0 0 1"', 3.68),  # 0.95 of it
        ('axis="0.1 0 1"', 2.0),  # tilted against its axis
    ],
)
def test_what_rests_on_a_turning_floor_stays(joint, rate, places):
    names = [f"foot{i}" for i in range(len(places))]
    radius = 0.05 if len(places) == 1 else 0.03
    legs = "".join(
        f'<geom name="{name}" type="cylinder" size="{radius} 0.01" pos="{x} {y} 0" mass="0.2"/>'
        for name, (x, y) in zip(names, places, strict=True)
    )
    patch = tribos.Friction(tribos.disk(radius), mu=0.3)
    model = mujoco.MjModel.from_xml_string(
        f"""
        <mujoco>
          <option timestep="0.002" gravity="0 0 -{GRAVITY}"/>
          <worldbody>
            <body><joint name="axle" type="hinge" {joint}/>
              <geom name="floor" type="cylinder" size="0.5 0.02" mass="100"/></body>
            <body pos="0.2 0 0.0299"><freejoint/>{legs}</body>
          </worldbody>
          <actuator><velocity joint="axle" kv="2e3"/></actuator>
        </mujoco>"""
    )
    data = mujoco.MjData(model)

    def place():
        mujoco.mj_kinematics(model, data)
        turn = data.geom("floor").xmat.reshape(3, 3).T
        x = turn @ data.xmat[-1].reshape(3, 3)[:, 0]
        return np.array([*(turn @ data.xpos[-1])[:2], math.atan2(x[1], x[0])])

    with tribos.mujoco.attach(model, data, dict.fromkeys(names, patch), floor="floor") as feet:
        for share in np.linspace(0.0, 1.0, 1000):
            data.ctrl[:] = share * rate
            mujoco.mj_step(model, data)
        mujoco.mj_step(model, data, nstep=1000)
        start, shifts = place(), []
        for _ in range(20):
            mujoco.mj_step(model, data, nstep=500)
            shifts.append(place() - start)
        assert all(feet[name].is_held and feet[name].missed == 0 for name in names)
    # The first order of the step would carry it by 15 mm and more; contacts' springs let it sway.
    assert np.abs(shifts).max() < 2e-5


@pytest.mark.skipif(mujoco.mj_version() < 4000000, reason="MuJoCo has conveyors since 4.0")
def test_a_conveyor_takes_a_body_along():
    belt = 'type="box" size="9 9 0.1" pos="0 0 -0.1" surfacevel="0.2 -0.1 0 0 0 0.5"'
    model, data = world(PUCK, floor=belt)
    with tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor") as feet:
        mujoco.mj_step(model, data, nstep=400)
        x, y = data.qpos[:2]
        # The surface turns about the geom's own centre.
        expected = [0.2 - 0.5 * y, -0.1 + 0.5 * x, 0.5]
        assert data.qvel[[0, 1, 5]] == pytest.approx(expected, abs=1e-3)
        assert feet["foot"].is_held


@pytest.mark.parametrize("jacobian", ["dense", "sparse"])
def test_a_sliding_ball_rolls_at_last_without_loss(jacobian):
    model, data = world('type="sphere" size="0.05"', height=0.05, option=f'jacobian="{jacobian}"')
    ball = tribos.Friction(tribos.hertz(1e-4), mu=0.3)
    with tribos.mujoco.attach(model, data, {"foot": ball}, floor="floor") as feet:
        slide(model, data, 1.0, 0.0, steps=400)
        assert feet["foot"].is_held
        # Five sevenths of its speed, up to MuJoCo's overlap, which makes the lever shorter.
        lever = data.qpos[2] - feet["foot"].centre[2]
        assert lever == pytest.approx(0.05, rel=1e-2)
        rolling = 1.0 / (1.0 + 0.4 * (0.05 / lever) ** 2)
        assert data.qvel[0] == pytest.approx(rolling, rel=1e-5)
        # It rolls on without a loss.
        speed = data.qvel[0]
        mujoco.mj_step(model, data, nstep=300)
        assert data.qvel[0] == pytest.approx(speed, rel=1e-9)


def test_a_body_rests_again_after_a_reset():
    model, data = world(PUCK)
    with tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor") as feet:
        first = slide(model, data, 1.0, 20.0)
        mujoco.mj_resetData(model, data)
        mujoco.mj_forward(model, data)
        assert slide(model, data, 1.0, 20.0) == pytest.approx(first, rel=1e-6, abs=1e-9)
        assert feet["foot"].is_held


@pytest.mark.skipif(
    not hasattr(mujoco.mjtEnableBit, "mjENBL_SLEEP"), reason="this MuJoCo has no sleep"
)
def test_a_sleeping_body_wakes_with_its_load():
    flag = '><flag sleep="enable"/></option><option timestep="0.001"'
    model, data = world(PUCK, option=flag)
    with tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor") as feet:
        mujoco.mj_step(model, data, nstep=1500)
        assert data.body_awake[1] == 0
        mujoco.mj_step(model, data, nstep=200)
        data.qvel[0] = 1.0
        mujoco.mj_step(model, data)
        assert feet["foot"].load == pytest.approx(0.2 * GRAVITY, rel=3e-3)
        assert data.qvel[0] == pytest.approx(1.0 - 0.3 * GRAVITY * 1e-3, abs=1e-5)


def test_friction_of_mujocos_own_ends_the_step():
    model, data = world(PUCK)
    with tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor"):
        mujoco.mj_step(model, data, nstep=200)
        model.geom_condim[:] = 3
        with pytest.raises(ValueError, match="condim was changed after the feet were made"):
            mujoco.mj_step(model, data)


def test_a_lifted_foot_has_no_friction():
    model, data = world(PUCK, height=1.0)
    with tribos.mujoco.attach(model, data, {"foot": DISK}, floor="floor") as feet:
        data.qvel[:] = [1.0, 0.0, 0.0, 0.0, 0.0, 3.0]
        mujoco.mj_step(model, data, nstep=20)
        assert data.qvel[0] == 1.0
        assert feet["foot"].load == 0.0


def test_what_cannot_be_attached_is_refused():
    model, data = world(PUCK, more='<site name="s"/>')
    attach = tribos.mujoco.attach
    with pytest.raises(ValueError, match="no geom 'fot'; its named geoms are: 'floor', 'foot'"):
        attach(model, data, {"fot": DISK}, floor="floor")
    with pytest.raises(ValueError, match="no geom 'ground'.*'floor', 'foot'"):
        attach(model, data, {"foot": DISK}, floor="ground")
    with pytest.raises(ValueError, match="no site 'x'.*'s'"):
        attach(model, data, {"foot": DISK}, floor="floor", sites={"foot": "x"})
    with pytest.raises(ValueError, match="one body"):
        attach(model, data, {("foot", "floor"): DISK}, floor="floor")
    with pytest.raises(ValueError, match="no entry"):
        attach(model, data, {"foot": DISK}, floor={})
    with pytest.raises(ValueError, match="limit surface"):
        law = tribos.Law("stribeck", mu_s=0.4, mu_d=0.2, vs=0.05)
        attach(model, data, {"foot": tribos.Friction(tribos.disk(0.05), law=law)}, floor="floor")
    with pytest.raises(ValueError, match=r"tribos\.Friction"):
        attach(model, data, {"foot": 0.3}, floor="floor")
    with pytest.raises(ValueError, match=r"'foot' and \('foot',\) have a geom on the same floor"):
        attach(model, data, {"foot": DISK, ("foot",): DISK}, floor="floor")
    more = """<geom name="shelf" size="1" pos="0 9 0"/>
        <body mocap="true"><geom name="hand" size="1" pos="0 0 9"/></body>"""
    fixed, held = world(PUCK + '/><geom name="lid" size="0.01"', more=more)
    for name, floor, why in (
        ("shelf", "floor", "foot 'shelf' and its floor 'floor' are of one body"),
        ("lid", "foot", "foot 'lid' and its floor 'foot' are of one body"),
        ("hand", "floor", "foot 'hand' (never moves|and its floor 'floor' are of one body)"),
    ):
        with pytest.raises(ValueError, match=why):
            attach(fixed, held, {name: DISK}, floor=floor)
    assert (fixed.geom_condim == 3).all()
    with attach(model, data, {"foot": DISK}, floor="floor") as feet:
        with pytest.raises(ValueError, match="already"):
            attach(model, data, {"foot": DISK}, floor="floor")
        with pytest.raises(KeyError, match="fot"):
            feet["fot"]
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    with pytest.raises(ValueError, match="RK4"):
        attach(model, data, {"foot": DISK}, floor="floor")
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_EULER
    flags = mujoco.mjtDisableBit
    for name in ("PASSIVE", "SPRING", "DAMPER"):
        model.opt.disableflags |= int(getattr(flags, f"mjDSBL_{name}", 0))
    with pytest.raises(ValueError, match="disabled"):
        attach(model, data, {"foot": DISK}, floor="floor")
    assert model.geom_condim.tolist() == [3, 3]


def test_a_stack_moves_as_one_body_until_its_top_is_left_behind():
    text = f"""
    <mujoco>
      <option timestep="0.001" gravity="0 0 -{GRAVITY}"/>
      <worldbody>
        <geom name="floor" type="plane" size="9 9 0.1"/>
        <body pos="0 0 0.01"><freejoint/>
          <geom name="low" type="box" size="0.1 0.1 0.01" mass="0.4"/></body>
        <body pos="0 0 0.03"><freejoint/>
          <geom name="top" type="box" size="0.05 0.05 0.01" mass="0.2"/></body>
      </worldbody>
    </mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    feet = {
        "low": tribos.Friction(tribos.box(0.2, 0.2), mu=0.2),
        "top": tribos.Friction(tribos.box(0.1, 0.1), mu=0.3),
    }
    with tribos.mujoco.attach(model, data, feet, floor={"low": "floor", "top": "low"}) as stack:
        mujoco.mj_step(model, data, nstep=400)
        # Weights are 6 N below and 2 N above: 1.2 N hold the stack, 0.6 N the top.
        for push, low, top in (
            (1.1, 0.0, 0.0),
            (2.4, 2.0, 2.0),
            (4.4, (4.4 - 1.2 - 0.6) / 0.4, 3.0),
        ):
            data.qfrc_applied[0] = push
            mujoco.mj_step(model, data, nstep=20)
            before = data.qvel.copy()
            mujoco.mj_step(model, data, nstep=40)
            rates = (data.qvel - before) / 0.04
            assert rates[[0, 6]] == pytest.approx([low, top], rel=2e-2, abs=2e-3)
            assert stack["low"].is_held == (push < 1.2)
            assert stack["top"].is_held == (top == low)
