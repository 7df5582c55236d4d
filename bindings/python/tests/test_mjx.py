"""Exact friction of patches in MJX.

TRIBOS_LONG=1: a capsule between fingers, and derivatives of the place where a puck comes to rest.
"""

from types import SimpleNamespace

import numpy as np
import pytest
import tribos
from conftest import takes_long

jax = pytest.importorskip("jax")
mujoco = pytest.importorskip("mujoco")
mjx = pytest.importorskip("mujoco.mjx")

import jax.numpy as jnp  # noqa: E402
import tribos.mjx  # noqa: E402
import tribos.mujoco  # noqa: E402
from tribos import _mjx_model, _mjx_solve  # noqa: E402

MU, GRAVITY, SPEED, DT = 0.3, 10.0, 1.0, 2e-3  # -, m/s², m/s, s
SPINS = np.array([0.0, 5.0, 12.5, 25.0, 50.0])  # rad/s
DISK = tribos.Friction(tribos.disk(0.05), mu=MU)
BOX = tribos.Friction(tribos.box(0.1, 0.1), mu=MU)
LEG = tribos.Friction(tribos.disk(0.01), mu=MU)
LEGS = {"a": (0.06, 0.0), "b": (-0.03, 0.05), "c": (-0.04, -0.05)}  # m

# Bodies far apart that touch the ice alone, one of each kind: MJX compiles one model.
WORLD = f"""
<mujoco>
  <option timestep="{DT}" gravity="0 0 -{GRAVITY}" iterations="6" ls_iterations="8"/>
  <default><geom condim="1" contype="0"/></default>
  <worldbody>
    <geom name="ice" type="plane" size="99 99 0.1" contype="1" conaffinity="0"/>
    <body pos="0 0 0.00985"><freejoint/><geom name="puck" type="cylinder" size="0.05 0.01" mass="0.17"/></body>
    <body pos="0 9 0.00985"><freejoint/><geom name="box" type="box" size="0.05 0.05 0.01" mass="0.2"/></body>
    <body pos="0 -9 0.0099"><freejoint/>{
    "".join(
        f'<geom name="{name}" type="cylinder" size="0.01 0.01" pos="{x} {y} 0" mass="0.1"/>'
        for name, (x, y) in LEGS.items()
    )
}</body>
  </worldbody>
</mujoco>"""
FEET = {"puck": DISK, "box": BOX} | dict.fromkeys(LEGS, LEG)
SETTLE, STEPS = 80, 450


@pytest.fixture(scope="module")
def wide():
    """Numbers of 64 bits."""
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", False)


@pytest.fixture(scope="module")
def thrown(wide):
    """States after each step of bodies that are thrown at five spins once they have settled."""
    model = mujoco.MjModel.from_xml_string(WORLD)
    m, feet = mjx.put_model(model), tribos.mjx.feet(model, FEET, floor="ice")

    def run(spin):
        launch = jnp.tile(jnp.array([SPEED, 0.0, 0.0, 0.0, 0.0, 0.0]).at[5].set(spin), 3)

        def step(d, index):
            d = d.replace(qvel=jnp.where(index == SETTLE, launch, d.qvel))
            d = tribos.mjx.step(m, d, feet)
            return d, (d.qpos, d.qvel)

        start = feet.start(mjx.make_data(m))
        return jax.lax.scan(step, start, jnp.arange(SETTLE + STEPS))

    last, (places, velocities) = jax.jit(jax.vmap(run))(jnp.array(SPINS))
    return SimpleNamespace(
        model=model, feet=feet, state=feet.state(last), places=places, velocities=velocities
    )


def travels(thrown, body):
    return np.array(thrown.places[:, -1, 7 * body] - thrown.places[:, SETTLE - 1, 7 * body])


def test_a_puck_and_a_box_travel_as_far_as_they_should(thrown):
    ratio = thrown.model.body_inertia[1, 2] / (0.17 * 0.05**2)
    puck = tribos.slide(DISK, SPEED, SPINS, gravity=GRAVITY, inertia_ratio=ratio).distance
    body = tribos.PlanarBody(BOX, 0.2, thrown.model.body_inertia[2, 2], gravity=GRAVITY)
    twists = np.stack([np.full(5, SPEED), np.zeros(5), SPINS], axis=-1)
    rollout = body.rollout(twists, np.zeros((5, 9000, 3)), 1e-4)
    assert np.all(rollout.twists[:, -1] == 0.0)
    for found, exact in (
        (travels(thrown, 0), puck),
        (travels(thrown, 1), rollout.poses[:, -1, 0]),
    ):
        # MuJoCo's positions are late by half a step of the first speed.
        assert np.abs(found + 0.5 * DT * SPEED - exact) == pytest.approx(0.0, abs=2e-4 * exact[0])


def test_what_has_come_to_rest_stays(thrown):
    for name, state in thrown.state.items():
        # The fastest tripod still turns.
        assert state.is_held[: 5 if name in ("puck", "box") else 4].all(), name
        assert not state.missed.any(), name
    moved = np.abs(thrown.places[:, -1] - thrown.places[:, -20])
    # The tripod's tilt on its contacts still dies out.
    assert moved[:4, [0, 1, 7, 8]].max() < 2e-9 and moved[:4, [14, 15]].max() < 1e-8
    weights = [0.17 * GRAVITY, 0.2 * GRAVITY, 0.1 * GRAVITY, 0.1 * GRAVITY, 0.1 * GRAVITY]
    loads = [float(state.load[0]) for state in thrown.state.values()]
    assert loads == pytest.approx(weights, rel=2e-3)


def test_a_tripod_moves_as_with_the_feet_of_mujoco(thrown):
    # Of the same rules in C; the compiled step solves one foot after another.
    model = mujoco.MjModel.from_xml_string(WORLD)
    data = mujoco.MjData(model)
    places = []
    with tribos.mujoco.attach(model, data, FEET, floor="ice"):
        for index in range(SETTLE + STEPS):
            if index == SETTLE:
                data.qvel[:] = np.tile([SPEED, 0.0, 0.0, 0.0, 0.0, SPINS[2]], 3)
            mujoco.mj_step(model, data)
            places.append(data.qpos.copy())
    assert np.abs(np.array(places) - thrown.places[2])[:, 14:].max() < 1e-6


class Disks:
    """Sets of disks, for `_mjx_solve.solve`."""

    def __init__(self, limits, radii):
        self.limits, self.radii = jnp.asarray(limits), jnp.asarray(radii)
        self.arms = 2.0 / 3.0 * self.radii
        self.lengths = np.full(len(radii), np.nan)
        self.unit = tribos.Friction(tribos.disk(1.0), mu=1.0)

    def nearest(self, wrenches, lengths):
        sizes = {"length": lengths, "radius": self.radii}
        return tribos.jax.project(self.unit, wrenches, self.limits, **sizes)


@pytest.fixture(scope="module")
def solved(wide):
    """Two disks of one body and one of another: their compliance, and a function that gives what is found for a motion with the
    derivatives of the sum of `along` times friction."""
    random = np.random.default_rng(7)
    root = random.normal(size=(6, 6))
    blocks = (jnp.eye(3)[None] * 2.0, jnp.array(root @ root.T + np.eye(6))[None])
    groups = _mjx_solve.Groups((np.array([[2]]), np.array([[0, 1]])))
    compliance = _mjx_solve.Compliance(groups, blocks)

    def part(velocity, rate, limits, along):
        sets = Disks(limits, RADII)
        found = _mjx_solve.solve(sets, compliance, velocity, rate, jnp.zeros((3, 3)), 1e-2)
        return (along * found.friction).sum(), found

    return compliance, jax.jit(jax.value_and_grad(part, argnums=(0, 1, 2), has_aux=True))


LIMITS, RADII = np.array([3.0, 1.0, 2.0]), [1.0, 0.5, 2.0]
ANY = np.ones((3, 3))


def test_friction_of_feet_that_slide_opposes_their_motion_at_half_time(solved):
    compliance, solve = solved
    random = np.random.default_rng(5)
    for speed in (0.3, 3.0):
        velocity, rate = speed * random.normal(size=(3, 3)), random.normal(size=(3, 3))
        found = solve(velocity, rate, LIMITS, ANY)[0][1]
        motion = velocity + 0.5e-2 * (rate + compliance.times(found.friction))
        assert not found.is_missed.any() and not found.is_held.any()
        for at, radius in enumerate(RADII):
            disk = tribos.Friction(tribos.disk(radius), mu=1.0)
            exact = disk.wrench(motion[at], LIMITS[at])
            assert found.friction[at] == pytest.approx(exact, abs=1e-6 * LIMITS[at])


def test_derivatives_of_friction_are_those_of_differences_and_finite_at_rest(solved):
    _, solve = solved
    random = np.random.default_rng(3)
    along, velocity, rate = random.normal(size=(3, 3, 3))
    given = [velocity, rate, LIMITS]
    slopes = solve(*given, along)[1]
    step = 1e-4
    for at in range(3):
        way = random.normal(size=given[at].shape)
        ends = [
            float(solve(*given[:at], given[at] + move * way, *given[at + 1 :], along)[0][0])
            for move in (step, -step)
        ]
        slope = (ends[0] - ends[1]) / (2.0 * step)
        assert float((slopes[at] * way).sum()) == pytest.approx(slope, rel=1e-4)
    # At rest friction takes the push; feet without load have none.
    (_, held), slopes = solve(np.zeros((3, 3)), 0.1 * rate, np.full(3, 9.0), along)
    assert held.is_held.all()
    assert held.response == pytest.approx(-0.1 * rate, abs=1e-9)
    (_, free), others = solve(velocity, rate, np.zeros(3), along)
    assert not free.is_held.any() and not free.friction.any()
    assert all(np.isfinite(part).all() for part in (*slopes, *others))


def one(geom='condim="1"', floor='condim="1"', more=""):
    return mujoco.MjModel.from_xml_string(f"""
    <mujoco>
      {more}
      <worldbody>
        <geom name="ice" type="plane" size="1 1 0.1" {floor}/>
        <body><freejoint/><geom name="puck" type="cylinder" size="0.05 0.01" {geom}/></body>
        <body><geom name="post" size="0.1" condim="1"/><site name="top"/></body>
      </worldbody>
    </mujoco>""")


KEYS = {"geom": "puck", "ground": "ice", "patch": "disk", "size": 0.05, "mu": 0.3}


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"geom": "pcuk"}, "no geom 'pcuk'; its named geoms are: 'ice', 'puck', 'post'"),
        ({"geom": ""}, "geom is missing"),
        ({"geom": "puck puck"}, "twice"),
        ({"geom": "puck post"}, "must be of one body"),
        ({"ground": "puck"}, "of one body"),
        ({"geom": "post"}, "of one body"),
        ({"site": "top"}, "not on the body"),
        ({"patch": "square"}, "patch must be one of disk"),
        ({"size": ""}, "size of patch 'disk'"),
        ({"patch": "polygon"}, "no size"),
        ({"corners": "0 0 1 0 1 1"}, "corners are for"),
        ({"mu": -0.1}, "mu"),
        ({"colour": "red"}, "colour"),
    ],
)
def test_feet_without_sense_are_refused(changed, message):
    with pytest.raises(ValueError, match=message):
        tribos.mjx.feet(one(), [KEYS | changed])


def test_models_without_sense_are_refused():
    with pytest.raises(ValueError, match=r'\(condim 3\): give "puck" condim="1" and a higher'):
        tribos.mjx.feet(one(geom=""), [KEYS])
    with pytest.raises(ValueError, match="never touch"):
        tribos.mjx.feet(one(geom='condim="1" contype="2" conaffinity="2"'), [KEYS])
    with pytest.raises(ValueError, match="RK4"):
        tribos.mjx.feet(one(more='<option integrator="RK4"/>'), [KEYS])
    with pytest.raises(ValueError, match="the same geoms"):
        tribos.mjx.feet(one(), [KEYS, KEYS | {"name": "again"}])
    with pytest.raises(ValueError, match="no instance of the plugin"):
        tribos.mjx.feet(one())
    with pytest.raises(ValueError, match="floor is missing"):
        tribos.mjx.feet(one(), {"puck": DISK})
    model = one()
    feet = tribos.mjx.feet(model, [KEYS])
    with pytest.raises(ValueError, match=r"feet\.start"):
        tribos.mjx.apply(mjx.put_model(model), mjx.make_data(model), feet)


def test_the_plugins_own_elements_are_read():
    # As MuJoCo has them where the plugin is loaded, after an instance of another plugin.
    texts = (
        b"5\0puck\0table\0\0disk\0000.05\0\0000.3\0\0\0\0"
        b"heel toe\0table\0sole\0box\0000.1 0.2\0\0000.5\0\0\0\0"
    )
    model = SimpleNamespace(
        nplugin=3,
        plugin_attr=np.frombuffer(texts, np.int8),
        plugin_attradr=[0, 2, texts.index(b"heel")],
        plugin_statenum=[0, 15, 15],
    )
    puck, sole = _mjx_model.of_model(model)
    assert puck == ("puck", DISK, ("puck",), ("table",), "")
    assert sole[2:] == (("heel", "toe"), ("table",), "sole")
    assert sole.friction.patch == tribos.box(0.2, 0.4) and sole.friction.mu == 0.5


CAPSULE = """
<mujoco>
  <option timestep="0.002" iterations="20" ls_iterations="20"/>
  <default><geom condim="1"/></default>
  <worldbody>
    <body pos="-0.03 0 0" gravcomp="1"><joint name="left" type="slide" axis="1 0 0" damping="20"/>
      <geom name="left" type="box" size="0.01 0.02 0.02" mass="0.2"/></body>
    <body pos="0.03 0 0" gravcomp="1"><joint name="right" type="slide" axis="-1 0 0" damping="20"/>
      <geom name="right" type="box" size="0.01 0.02 0.02" mass="0.2"/></body>
    <body><freejoint/><geom name="capsule" type="capsule" size="0.02 0.05" mass="0.1"/></body>
  </worldbody>
  <actuator><motor joint="left"/><motor joint="right"/></actuator>
</mujoco>"""


@takes_long
def test_a_capsule_between_two_fingers_hangs_still_or_falls(wide):
    model = mujoco.MjModel.from_xml_string(CAPSULE)
    finger = tribos.Friction(tribos.disk(0.005), mu=1.0)
    feet = tribos.mjx.feet(model, {"left": finger, "right": finger}, floor="capsule")
    m = mjx.put_model(model)

    def run(margin):
        d = mjx.make_data(m).replace(ctrl=jnp.full(2, margin * 0.1 * 9.81 / 2.0))

        def step(d, _):
            d = tribos.mjx.step(m, d, feet)
            return d, d.qpos[4]

        return jax.lax.scan(step, feet.start(d), None, length=1500)

    last, heights = jax.jit(jax.vmap(run))(jnp.array([2.0, 20.0, 95.0, 0.8]))
    held = np.stack([state.is_held for state in feet.state(last).values()])
    assert np.array_equal(held, [[True, True, True, False]] * 2)
    # From the first touch on, which is known a step late.
    assert np.abs(heights[:3]).max() < 2e-4
    assert np.abs(heights[:3, 500] - heights[:3, -1]).max() < 1e-12
    assert heights[3, -1] < -1.0


@takes_long
@pytest.mark.parametrize("mode", [jax.jacfwd, jax.jacrev])
def test_the_resting_place_has_the_derivatives_of_the_exact_slider(wide, mode):
    # MJX has derivatives in reverse mode with one iteration.
    text = (
        WORLD.split('<body pos="0 9')[0]
        .replace('iterations="6"', 'iterations="1"')
        .replace(f'"{DT}"', '"1e-3"')
    )
    model = mujoco.MjModel.from_xml_string(text + "</worldbody></mujoco>")
    m, feet = mjx.put_model(model), tribos.mjx.feet(model, {"puck": DISK}, floor="ice")
    ready = mujoco.MjData(model)
    with tribos.mujoco.attach(model, ready, {"puck": DISK}, floor="ice"):
        mujoco.mj_step(model, ready, nstep=SETTLE)
    place = jnp.array(ready.qpos)

    def travel(given):
        spin, mu = given
        d = mjx.make_data(m)
        d = d.replace(qpos=place, qvel=d.qvel.at[0].set(SPEED).at[5].set(spin))
        step = jax.checkpoint(lambda d, _: (tribos.mjx.step(m, d, feet, mu=mu), None))
        return jax.lax.scan(step, feet.start(mjx.forward(m, d)), None, length=600)[0].qpos[0]

    by_spin, by_mu = jax.jit(mode(travel))(jnp.array([12.5, MU]))
    exact = tribos.slide_jacobian(
        DISK,
        SPEED,
        12.5,
        gravity=GRAVITY,
        inertia_ratio=model.body_inertia[1, 2] / (0.17 * 0.05**2),
    )
    assert by_spin == pytest.approx(exact.distance_by.spin, rel=3e-3)
    # The travel is inversely proportional to mu.
    assert by_mu == pytest.approx(-exact.distance / MU, rel=3e-3)


def test_a_foot_from_each_door_is_braked_by_its_load():
    model = mujoco.MjModel.from_xml_string(
        WORLD.split('<body pos="0 9')[0] + "</worldbody></mujoco>"
    )
    m = mjx.put_model(model)
    doors = [tribos.mjx.feet(model, {"puck": DISK}, "ice"), tribos.mjx.feet(model, [KEYS])]

    def friction(speed, mu):
        d = mjx.make_data(m)
        d = mjx.forward(m, d.replace(qvel=d.qvel.at[0].set(speed)))
        made = [tribos.mjx.apply(m, feet.start(d), feet) for feet in doors]
        last = tribos.mjx.apply(m, doors[0].start(d), doors[0], mu=mu, radius=jnp.array([0.02]))
        states = [feet.state(d)["puck"] for d, feet in zip([*made, last], [*doors, doors[0]])]
        return [one.load for one in states], [one.friction for one in states]

    loads, found = jax.jit(friction)(1.0, -0.1)
    assert loads[0] > 1.0
    for load, one in zip(loads[:2], found):
        assert np.allclose(one / load, [-MU, 0.0, 0.0], atol=1e-5)
    # Negative numbers that are traced are not seen before.
    assert np.isnan(found[2]).any()


def test_arguments_without_sense_are_refused():
    model, spec = one(), tribos.Friction(tribos.box(0.1, 0.1), mu=MU)
    feet, boxes = tribos.mjx.feet(model, [KEYS]), tribos.mjx.feet(model, {"puck": spec}, "ice")
    m = mjx.put_model(model)
    d = feet.start(mjx.make_data(m))
    many = jax.tree.map(lambda x: jnp.stack([x, x]), d)
    step, viscous = tribos.mjx.step, tribos.Friction(tribos.disk(0.05), mu=0.3, alpha=0.5)
    for words, call in (
        (r"feet takes a mujoco\.MjModel", lambda: tribos.mjx.feet(m, [KEYS])),
        (r"start takes data of MJX", lambda: feet.start(mujoco.MjData(model))),
        (r"in this order, not MjModel", lambda: step(model, d, feet)),
        (r"in this order, not Data of MJX, Model of MJX", lambda: step(d, m, feet)),
        (r"one world, not of \(2,\): for several use jax\.vmap", lambda: step(m, many, feet)),
        (r"each foot \(1\), not \(64,\)", lambda: step(m, d, feet, mu=jnp.ones(64))),
        (r"radius: a number, or one", lambda: step(m, d, feet, radius=np.ones((1, 1)))),
        (r"mu must be >= 0", lambda: step(m, d, feet, mu=jnp.array(-0.1))),
        (r"radius must be > 0", lambda: step(m, d, feet, radius=0.0)),
        (r"not for tribos\.box.* of foot 'puck'", lambda: step(m, d, boxes, radius=0.1)),
        (
            r"body 2 has no joint, so that it is fixed",
            lambda: tribos.mjx.feet(model, {"post": DISK}, "ice"),
        ),
        (r"mu is missing", lambda: tribos.mjx.feet(model, [KEYS | {"mu": None}])),
        (r"plugin's alone", lambda: tribos.mjx.feet(model, [KEYS | {"mu_s": 0.4}])),
        (
            r"feet take Coulomb friction \(mu=",
            lambda: tribos.mjx.feet(model, {"puck": viscous}, "ice"),
        ),
        (
            r"give mu= to the function of tribos\.jax",
            lambda: jax.jit(lambda x: tribos.Friction(tribos.disk(0.1), mu=x).mu)(0.3),
        ),
    ):
        with pytest.raises(ValueError, match=words):
            call()


@pytest.mark.parametrize(
    ("geom", "patch", "words"),
    [
        ("cylinder", tribos.disk(0.1), r"radius 0\.1 m, geom 'foot' is a cylinder of radius 0\.05"),
        ("box", tribos.box(0.05, 0.03), r"sides 0\.05 x 0\.03 m.*full sides 0\.1 x 0\.06"),
        ("box", tribos.box(0.1, 0.05), None),
        ("box", tribos.disk(0.005), None),
        ("cylinder", tribos.disk(0.04), None),
        # On its side: y and z are its face.
        ('box" euler="0 90 0', tribos.box(0.06, 0.02), None),
    ],
)
def test_a_patch_of_another_size_than_its_geom_is_told_of(geom, patch, words):
    size = "0.05 0.03 0.01" if geom.startswith("box") else "0.05 0.01"
    model = mujoco.MjModel.from_xml_string(f"""
    <mujoco><worldbody>
      <geom name="ice" type="plane" size="1 1 0.1" condim="1"/>
      <body><freejoint/><geom name="foot" type="{geom}" size="{size}" condim="1"/><site name="s"/></body>
    </worldbody></mujoco>""")
    foot = {"foot": tribos.Friction(patch, mu=MU)}
    if words is None:
        tribos.mjx.feet(model, foot, "ice")
        return
    with pytest.warns(UserWarning, match=words):
        tribos.mjx.feet(model, foot, "ice")
    with (
        pytest.warns(UserWarning, match=words),
        tribos.mujoco.attach(model, mujoco.MjData(model), foot, "ice"),
    ):
        pass
    tribos.mjx.feet(model, foot, "ice", sites={"foot": "s"})
