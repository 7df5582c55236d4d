"""Feet in MuJoCo Warp, on the processor: travel and rest against the exact motion, refusals in words."""

from __future__ import annotations

import tempfile
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import tribos

wp = pytest.importorskip("warp")
mujoco = pytest.importorskip("mujoco")
mjw = pytest.importorskip("mujoco_warp")

wp.config.kernel_cache_dir = str(Path(tempfile.gettempdir()) / "tribos-warp-kernels")
wp.config.log_level = wp.LOG_WARNING
wp.config.optimization_level = 0

import tribos.warp as tw  # noqa: E402

MU, GRAVITY, STEP = 0.3, 9.81, 0.004
SPINS = np.array([0.0, 5.0, 12.5, 25.0, 50.0])
LEGS = 0.1 * np.array([[np.cos(a), np.sin(a)] for a in (0.0, 2 * np.pi / 3, 4 * np.pi / 3)])
SETTLED, LAUNCHED = 40, 200

# No others touch: Warp compiles searches for each pair of shapes that could.
# Two bodies that spin, a ball, three legs with the centre of mass on the floor, and a disc on a slab.
SCENE = f"""
<mujoco>
  <option timestep="{STEP}" gravity="0 0 {-GRAVITY}" solver="CG"/>
  <default><geom contype="0"/></default>
  <worldbody>
    <geom name="ice" type="plane" size="50 50 0.1" contype="1"/>
    <body pos="0 0 0.01"><freejoint/>
      <geom name="puck" type="cylinder" size="0.05 0.01" mass="0.17"/></body>
    <body pos="0 5 0.01"><freejoint/>
      <geom name="box" type="box" size="0.05 0.03 0.01" mass="0.17"/></body>
    <body pos="0 10 0.05"><freejoint/>
      <geom name="ball" type="sphere" size="0.05" mass="1"/></body>
    <body pos="0 15 0.03"><freejoint/>
      <geom type="cylinder" size="0.12 0.01" pos="0 0 -0.03" mass="1" contype="0" conaffinity="0"/>
      {"".join(f'<geom name="leg{i}" type="sphere" size="0.01" pos="{x} {y} -0.02" mass="0"/>' for i, (x, y) in enumerate(LEGS))}
    </body>
    <body pos="0 20 0.02"><freejoint/>
      <geom name="slab" type="box" size="0.5 0.5 0.02" mass="1" contype="2"/></body>
    <body pos="0 20 0.05"><freejoint/>
      <geom name="disc" type="cylinder" size="0.05 0.01" mass="0.5" conaffinity="2"/></body>
  </worldbody>
</mujoco>
"""
PUCK, BOX, BALL, TABLE, SLAB, DISC = range(6)
PATCHES = {"puck": tribos.disk(0.05), "box": tribos.box(0.1, 0.06)}
FEET = {
    **{name: tribos.Friction(patch, mu=MU) for name, patch in PATCHES.items()},
    "ball": tribos.Friction(tribos.hertz(0.001), mu=MU),
    **{f"leg{i}": tribos.Friction(tribos.hertz(1e-4), mu=MU) for i in range(3)},
    "slab": tribos.Friction(tribos.box(1.0, 1.0), mu=0.0),
    "disc": tribos.Friction(tribos.disk(0.05), mu=MU),
}
FLOORS = {name: "slab" if name == "disc" else "ice" for name in FEET}


def exact(patch, mass, inertia, spins):
    """Travel until rest, from steps of 0.1 ms."""
    body = tribos.PlanarBody(tribos.Friction(patch, mu=MU), mass, inertia, load=mass * GRAVITY)
    twists = np.stack([np.ones_like(spins), 0 * spins, spins], axis=1)
    poses = body.rollout(twists, np.zeros((len(spins), 8000, 3)), 1e-4).poses
    return np.hypot(*np.asarray(poses)[:, -1, :2].T)


def launched():
    names = mujoco.MjModel.from_xml_string(SCENE)
    given = mujoco.MjData(names)
    mujoco.mj_forward(names, given)
    with wp.ScopedDevice("cpu"):
        model, data = mjw.put_model(names), mjw.put_data(names, given, nworld=len(SPINS))
        feet = tw.attach((names, model, data), FEET, FLOORS)
        for _ in range(SETTLED):
            mjw.step(model, data)
        start, loads = data.qpos.numpy().copy(), feet.load.numpy().copy()
        motion = np.zeros((len(SPINS), 6, 6), np.float32)
        motion[:, [PUCK, BOX, BALL, TABLE, DISC], 0] = 1.0
        motion[:, [PUCK, BOX, TABLE, DISC], 5] = SPINS[:, None]
        data.qvel.assign(motion.reshape(len(SPINS), -1))
        for _ in range(LAUNCHED):
            mjw.step(model, data)
    shift = (data.qpos.numpy() - start).reshape(len(SPINS), 6, 7)[:, :, :2]
    return names, loads, np.hypot(*shift.T).T, data.qvel.numpy().reshape(-1, 6, 6), feet


@pytest.fixture(scope="module")
def launch():
    return launched()


def test_loads_come_from_the_contacts_of_each_foot(launch):
    _, loads, _, _, feet = launch
    wanted = {"puck": 0.17, "box": 0.17, "ball": 1.0, "slab": 1.5, "disc": 0.5}
    wanted |= {f"leg{i}": 1 / 3 for i in range(3)}
    masses = np.array([wanted[name] for name in feet.names])
    assert np.abs(loads / (masses * GRAVITY) - 1).max() < 2e-3


@pytest.mark.parametrize("name", ["puck", "box", "legs"])
def test_travel_is_exact_but_for_half_a_step_of_the_position(launch, name):
    names, _, travel, _, _ = launch
    number = {"puck": PUCK, "box": BOX, "legs": TABLE}[name]
    patch = tribos.points(LEGS) if name == "legs" else PATCHES[name]
    mass, inertia = names.body_mass[number + 1], names.body_inertia[number + 1].max()
    wanted = exact(patch, mass, inertia, SPINS)
    error = travel[:, number] - wanted
    assert (np.abs(error) < 0.5 * STEP + 1e-3 * wanted).all(), error


def test_bodies_stop_and_a_ball_rolls_on(launch):
    _, _, _, velocity, feet = launch
    held = dict(zip(feet.names, feet.held.numpy().T))
    assert held["puck"].all() and held["box"].all() and held["ball"].all()
    assert np.abs(velocity[:, [PUCK, BOX]][:, :, [0, 1, 5]]).max() < 1e-5
    # 5/7 of the launch for an arm of the radius; the ball is pressed in a little.
    assert np.abs(velocity[:, BALL, 0] - 5 / 7).max() < 3e-3
    assert np.abs(velocity[:, BALL, 4] * 0.05 - velocity[:, BALL, 0]).max() < 5e-3


def test_a_floor_gets_the_reaction(launch):
    _, _, _, velocity, feet = launch
    momentum = velocity[:, SLAB, 0] + 0.5 * velocity[:, DISC, 0]
    assert np.abs(momentum - 0.5).max() < 1e-3
    # Both move as one in the end.
    apart = velocity[:, SLAB][:, [0, 5]] - velocity[:, DISC][:, [0, 5]]
    assert np.abs(apart[:, 0]).max() < 3e-3 and np.abs(apart[:, 1]).max() < 3e-3


def attached(feet, floor="ice", scene=SCENE, **others):
    names = mujoco.MjModel.from_xml_string(scene)
    with wp.ScopedDevice("cpu"):
        model = mjw.put_model(names)
        data = mjw.put_data(names, mujoco.MjData(names), nworld=2)
        return model, tw.attach((names, model, data), feet, floor, **others)


def test_what_is_not_meant_is_refused_in_words():
    disk, puck = FEET["disc"], {"puck": FEET["disc"]}
    for words, feet, others in (
        ("no geom 'puk'", {"puk": disk}, {}),
        ("are of one body", {"slab": disk}, {"floor": "slab"}),
        ("not of one body|of one body, those", {("puck", "box"): disk}, {}),
        ("not tribos.annulus", {"puck": tribos.Friction(tribos.annulus(0.1, 0.2), mu=0.1)}, {}),
        (
            "has no limit surface",
            {"puck": tribos.Friction(tribos.disk(0.1), mu=0.1, alpha=0.5)},
            {},
        ),
        ("must be a tribos.Friction", {"puck": 0.3}, {}),
        ("at least one foot", {}, {}),
        ("shape", puck, {"mu": [1.0, 2.0, 3.0]}),
        ("at least 0", puck, {"mu": [1.0, -2.0]}),
        ("sites are for feet", puck, {"sites": {"box": "a"}}),
        ("integrator", puck, {"scene": SCENE.replace("<option", '<option integrator="RK4"')}),
        (
            "free joint",
            puck,
            {"scene": SCENE.replace("<freejoint/>", '<joint type="slide" axis="1 0 0"/>', 1)},
        ),
        (
            "capsule",
            puck,
            {"scene": SCENE.replace('"puck" type="cylinder"', '"puck" type="capsule"')},
        ),
    ):
        with pytest.raises(ValueError, match=words):
            attached(feet, **others)
    with pytest.raises(ValueError, match="SolverMuJoCo"):
        tw.attach(None, puck, "ice")


def test_the_parts_of_a_solver_are_taken():
    names = mujoco.MjModel.from_xml_string(SCENE)
    with wp.ScopedDevice("cpu"):
        model = mjw.put_model(names)
        data = mjw.put_data(names, mujoco.MjData(names), nworld=2)
        solver = SimpleNamespace(mj_model=names, mjw_model=model, mjw_data=data)
        feet = tw.attach(solver, {"puck": FEET["disc"]}, "ice")
    assert feet.names == ("puck",) and feet.load.shape == (2, 1)
    assert model.geom_condim.numpy()[:2].tolist() == [1, 1] and model.callback.passive is not None
    feet.close()


def test_closed_feet_leave_the_model_as_it_was():
    model, feet = attached({"puck": FEET["disc"]}, mu=[0.1, 0.2])
    assert np.allclose(feet.mu.numpy(), [[0.1], [0.2]])
    assert model.geom_condim.numpy()[:2].tolist() == [1, 1]
    feet.close()
    feet.close()
    assert model.geom_condim.numpy()[:2].tolist() == [3, 3] and model.callback.passive is None


def test_feet_are_attached_once_and_to_what_they_are_for():
    names = mujoco.MjModel.from_xml_string(SCENE.replace('name="puck"', 'name="puck_11"'))
    viscous = tribos.Friction(tribos.disk(0.05), mu=0.3, alpha=0.5)
    with wp.ScopedDevice("cpu"):
        model, data = mjw.put_model(names), mjw.make_data(names)
        engine, disk = (names, model, data), FEET["disc"]
        # A label of Newton's is that of the geom with a number behind.
        with tw.attach(engine, {"puck": disk}, "ice"):
            with pytest.raises(ValueError, match="feet already: close them first"):
                tw.attach(engine, {"box": FEET["box"]}, "ice")
        tw.attach(engine, {"puck_11": disk}, "ice").close()
        assert model.callback.passive is None
        with pytest.raises(ValueError, match=r"in this order, not \(MjModel, Data, Model\)"):
            tw.attach((names, data, model), {"puck": disk}, "ice")
        with pytest.raises(ValueError, match="in this order"):
            tw.attach((model, names, data), {"puck": disk}, "ice")
        with pytest.raises(ValueError, match="no geom 'leg'"):
            tw.attach(engine, {"leg": disk}, "ice")
        with pytest.raises(ValueError, match=r"feet take Coulomb friction \(mu="):
            tw.attach(engine, {"puck": viscous}, "ice")
        with pytest.warns(UserWarning, match="radius 0.01 m, geom 'puck_11' is a cylinder"):
            tw.attach(engine, {"puck": tribos.Friction(tribos.disk(0.01), mu=MU)}, "ice").close()
