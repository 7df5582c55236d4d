"""What feet remember is saved, copied and reset with the simulation."""

import threading

import mujoco
import numpy as np
import pytest

from worlds import BOX, BOX_GEOM, DISK, FRICTIONLESS, GRAVITY, PUCK_GEOM, slide, state, world


def run(model, data, steps):
    mujoco.mj_step(model, data, nstep=steps)
    return np.concatenate((data.qpos, data.qvel, data.plugin_state))


def test_a_copy_goes_on_to_the_same_bits():
    model, data = world(BOX_GEOM, BOX)
    slide(model, data, 1.0, 20.0, steps=50)
    other = mujoco.MjData(model)
    slide(model, other, 0.3, -5.0, steps=10)  # has steps of its own behind it
    mujoco.mj_copyData(other, model, data)
    assert (run(model, other, 100) == run(model, data, 100)).all()


def test_a_copy_in_the_middle_of_a_step_goes_on_to_the_same_bits():
    model, data = world(BOX_GEOM, BOX)
    slide(model, data, 1.0, 20.0, steps=50)
    other = mujoco.MjData(model)
    mujoco.mj_step1(model, data)
    mujoco.mj_copyData(other, model, data)
    mujoco.mj_step2(model, data)
    mujoco.mj_step2(model, other)
    assert (run(model, other, 100) == run(model, data, 100)).all()


def test_a_saved_state_goes_on_to_the_same_bits():
    model, data = world(PUCK_GEOM, DISK)
    slide(model, data, 1.0, 20.0, steps=50)
    kind = mujoco.mjtState.mjSTATE_INTEGRATION
    saved = np.empty(mujoco.mj_stateSize(model, kind))
    mujoco.mj_getState(model, data, saved, kind)
    first = run(model, data, 300)
    mujoco.mj_setState(model, data, saved, kind)
    assert (run(model, data, 300) == first).all()
    other = mujoco.MjData(model)
    mujoco.mj_setState(model, other, saved, kind)
    assert (run(model, other, 300) == first).all()


def test_a_reset_forgets():
    model, data = world(PUCK_GEOM, DISK)
    first = slide(model, data, 1.0, 20.0)
    mujoco.mj_resetData(model, data)
    assert (data.plugin_state == 0.0).all()
    assert (slide(model, data, 1.0, 20.0) == first).all()


def test_evaluations_within_a_step_change_nothing():
    model, data = world(BOX_GEOM, BOX)
    slide(model, data, 1.0, 20.0, steps=50)
    other = mujoco.MjData(model)
    mujoco.mj_copyData(other, model, data)
    before = data.plugin_state.copy()
    for _ in range(3):
        mujoco.mj_forward(model, data)
        mujoco.mj_inverse(model, data)
    assert (data.plugin_state == before).all()
    assert data.qfrc_inverse == pytest.approx(np.zeros(model.nv), abs=1e-6)
    mujoco.mj_step(model, data)
    mujoco.mj_step(model, other)
    assert data.qpos == pytest.approx(other.qpos, abs=1e-12)


def test_threads_with_data_of_one_model_have_states_of_their_own():
    model, _ = world(BOX_GEOM, BOX)
    spins = (0.0, 5.0, 20.0, 50.0)

    def travelled(spin):
        return slide(model, mujoco.MjData(model), 1.0, spin, steps=300)

    alone = [travelled(spin) for spin in spins]
    found = [None] * len(spins)

    def work(index):
        found[index] = travelled(spins[index])

    threads = [threading.Thread(target=work, args=(index,)) for index in range(len(spins))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert (np.array(found) == np.array(alone)).all()


@pytest.mark.skipif(
    not hasattr(mujoco.mjtEnableBit, "mjENBL_SLEEP"), reason="this MuJoCo has no sleep"
)
def test_a_sleeping_body_keeps_its_load_and_wakes_with_it():
    pusher = f"""<body pos="-0.2 0 0.02"><joint name="push" type="slide" axis="1 0 0"/>
        <geom type="sphere" size="0.01" mass="1" {FRICTIONLESS}/></body>"""
    option = '><flag sleep="enable"/></option><option timestep="0.001"'
    box = BOX_GEOM.replace("0.05 0.05 0.01", "0.05 0.05 0.02")
    model, data = world(box, BOX, height=0.02, more=pusher, option=option)
    data.qvel[:] = 0.0
    mujoco.mj_step(model, data, nstep=1500)
    assert data.body_awake[1] == 0
    load, *_ = state(model, data)
    assert load == pytest.approx(
        0.2 * GRAVITY, rel=3e-3
    )  # it sleeps before it is at rest to the last bit
    place = data.qpos[:3].copy()
    mujoco.mj_step(model, data, nstep=200)
    assert (data.qpos[:3] == place).all()
    assert state(model, data)[0] == load
    # A blow wakes it; it slides to rest.
    data.qvel[6] = 1.0
    mujoco.mj_step(model, data, nstep=200)
    assert data.qpos[0] > place[0] + 1e-3
    mujoco.mj_step(model, data, nstep=3000)
    assert abs(data.qvel[0]) < 1e-9


def test_numbers_that_are_none_end_in_mujocos_own_reset():
    model, data = world(PUCK_GEOM, DISK)
    slide(model, data, 1.0, 20.0, steps=10)
    data.qvel[0] = np.nan
    mujoco.mj_step(model, data, nstep=10)
    assert np.isfinite(data.qpos).all()
    assert np.isfinite(data.plugin_state).all()
    mujoco.mj_step(model, data, nstep=400)
    assert state(model, data)[3]


def test_many_feet_do_not_disturb_each_other():
    more = "".join(
        f'<body pos="{0.3 * i} 1 0.01"><freejoint/><geom name="p{i}" {PUCK_GEOM}/></body>'
        for i in range(20)
    )
    from worlds import model_of

    bodies = f'<geom name="floor" type="plane" size="9 9 0.1"/>{more}'
    feet = {f"p{i}": {"geom": f"p{i}", "ground": "floor"} | DISK for i in range(20)}
    model = model_of(feet, bodies)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=200)
    start = data.qpos.reshape(20, 7)[:, 1].copy()
    spins = np.linspace(0.0, 50.0, 20)
    data.qvel.reshape(20, 6)[:, 1] = 1.0
    data.qvel.reshape(20, 6)[:, 5] = spins
    mujoco.mj_step(model, data, nstep=1000)
    paths = data.qpos.reshape(20, 7)[:, 1] - start
    model, data = world(PUCK_GEOM, DISK)
    for index in (0, 7, 19):
        mujoco.mj_resetData(model, data)
        path = slide(model, data, 1.0, spins[index], steps=1000, settle=200)
        # MuJoCo's solver stops at a tolerance for all bodies together.
        assert paths[index] == pytest.approx(path[0], rel=1e-5)
