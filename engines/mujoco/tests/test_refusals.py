"""Setups without sense are refused, with a message that says what and where."""

import mujoco
import pytest

from worlds import BOX_GEOM, DISK, FRICTIONLESS, PUCK_GEOM, model_of, world


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        (
            {"geom": "fot"},
            r'"foot": the model has no geom "fot"; its named geoms are: "floor", "foot"',
        ),
        ({"geom": ""}, "geom is missing"),
        ({"geom": "foot foot"}, 'geom names geom "foot" twice'),
        ({"ground": "ice"}, 'no geom "ice".*"floor", "foot"'),
        ({"ground": "foot"}, "of one body"),
        ({"geom": "foot floor"}, r'the geoms of geom must be of one body: "foot" and "floor"'),
        ({"site": "s"}, 'no site "s"; its named sites are: none'),
        ({"patch": ""}, "patch is missing"),
        ({"patch": "square"}, 'patch must be one of "disk".*not "square"'),
        ({"size": ""}, r"radius in m, > 0 and finite"),
        ({"size": "-0.05"}, "radius in m"),
        ({"size": "nan"}, "radius in m"),
        ({"size": "0.05 0.05"}, "radius in m"),
        ({"size": "5cm"}, 'not "5cm"'),
        ({"corners": "0 0 1 0 1 1"}, "corners are for"),
        ({"patch": "box"}, "two half lengths"),
        ({"patch": "box", "size": "0.05 0"}, "two half lengths"),
        ({"patch": "annulus"}, "inner and outer radius"),
        ({"patch": "annulus", "size": "0.05 0.05"}, 'patch "ring"'),
        ({"patch": "polygon"}, "leave out size"),
        ({"patch": "polygon", "size": "", "corners": "0 0 1 0"}, "three or more pairs"),
        ({"patch": "polygon", "size": "", "corners": "0 0 1 0 1 1 2"}, "three or more pairs"),
        (
            {"patch": "polygon", "size": "", "corners": "0 0 1 1 1 0 0 1"},
            "corners do not make a patch: edges must not touch",
        ),
        ({"patch": "polygon", "size": "", "corners": "0 0 1 0 2 0"}, "corners do not make a patch"),
        (
            {"patch": "polygon", "size": "", "corners": "0 0 1 0 nan 1"},
            "corners do not make a patch",
        ),
        ({"patch": "points", "size": "", "corners": "0 0"}, "two or more pairs"),
        ({"patch": "points", "size": "", "corners": "1 0 1 0"}, "in one place"),
        ({"mu": ""}, "mu must be one number >= 0"),
        ({"mu": -0.1}, 'mu must be one number >= 0 and finite, not "-0.1"'),
        ({"mu": "nan"}, "mu must be"),
        ({"mu": "inf"}, "mu must be"),
        ({"mu": "0.3 0.3"}, "mu must be"),
        (
            {"mu_s": 0.2},
            'mu_s, the coefficient at rest, must be one number >= mu and finite, not "0.2"',
        ),
        ({"mu_s": "inf"}, "mu_s, the coefficient at rest"),
        ({"mu_s": "0.4 0.5"}, "mu_s, the coefficient at rest"),
        ({"ageing_b": 0.02}, "both ageing_b and ageing_t0"),
        ({"ageing_t0": 1}, "both ageing_b and ageing_t0"),
        ({"ageing_b": -0.02, "ageing_t0": 1}, "ageing_b must be one number >= 0"),
        ({"ageing_b": 0.02, "ageing_t0": 0}, "ageing_t0 must be one time in s, > 0"),
        ({"colour": "red"}, "colour"),
    ],
)
def test_attributes_without_sense_are_refused(keys, message):
    with pytest.raises(ValueError, match=message):
        world(PUCK_GEOM, DISK | keys)


def test_friction_of_mujocos_own_is_refused():
    with pytest.raises(
        ValueError, match=r'"foot" and "floor".*\(condim 3\): give "foot" condim="1"'
    ):
        world('type="cylinder" size="0.05 0.01" mass="0.2"', DISK)
    # Without priority the larger condim counts.
    with pytest.raises(ValueError, match="condim 3"):
        world('type="cylinder" size="0.05 0.01" mass="0.2" condim="1"', DISK)
    pair = '<contact><pair geom1="floor" geom2="foot" condim="{}"/></contact>'
    bodies = """<geom name="floor" type="plane" size="9 9 0.1"/>
        <body><freejoint/><geom name="foot" type="cylinder" size="0.05 0.01"/></body>"""
    feet = {"foot": {"geom": "foot", "ground": "floor"} | DISK}
    with pytest.raises(ValueError, match="condim 4"):
        model_of(feet, bodies, more=pair.format(4))
    model_of(feet, bodies, more=pair.format(1))


def test_geoms_that_never_touch_are_refused():
    with pytest.raises(ValueError, match="never touch"):
        world(PUCK_GEOM + ' contype="2" conaffinity="2"', DISK)


def test_a_foot_that_cannot_move_is_refused():
    bodies = f"""<geom name="floor" type="plane" size="9 9 0.1"/>
        <body><geom name="foot" {PUCK_GEOM}/></body>"""
    with pytest.raises(ValueError, match=r'"foot" and ground "floor" are of one body'):
        model_of({"foot": {"geom": "foot", "ground": "floor"} | DISK}, bodies)


def test_two_feet_of_the_same_geoms_are_refused():
    foot = {"geom": "foot", "ground": "floor"} | DISK
    bodies = f"""<geom name="floor" type="plane" size="9 9 0.1"/>
        <body pos="0 0 0.01"><freejoint/><geom name="foot" {PUCK_GEOM}/></body>
        <body pos="0 0 1"><freejoint/><geom name="other" {BOX_GEOM}/></body>"""
    with pytest.raises(
        ValueError, match='"foot" and ground "floor" have the friction of instance "one" already'
    ):
        model_of({"one": foot, "two": foot | {"mu": 0.1}}, bodies)
    # The other way round is the same pair.
    first = {"geom": "foot", "ground": "other"} | DISK
    second = {"geom": "other", "ground": "foot"} | DISK
    with pytest.raises(ValueError, match="already"):
        model_of({"one": first, "two": second}, bodies)
    # Other grounds are other feet.
    model_of({"one": foot, "two": first}, bodies)


def test_options_without_an_implicit_step_are_refused():
    with pytest.raises(ValueError, match="RK4"):
        world(PUCK_GEOM, DISK, option='integrator="RK4"')
    flags = '><flag spring="disable" damper="disable"/></option><option timestep="0.001"'
    with pytest.raises(ValueError, match="passive forces are disabled"):
        world(PUCK_GEOM, DISK, option=flags)


def test_changes_of_a_running_model_are_refused():
    model, data = world(PUCK_GEOM, DISK)
    mujoco.mj_step(model, data, nstep=200)
    model.geom_condim[:] = 3
    with pytest.raises(mujoco.FatalError, match="condim was changed after the feet were made"):
        mujoco.mj_step(model, data)
    model.geom_condim[:] = 1
    mujoco.mj_step(model, data)
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    with pytest.raises(mujoco.FatalError, match="RK4"):
        mujoco.mj_step(model, data)
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_EULER
    flags = model.opt.disableflags
    for name in ("PASSIVE", "SPRING", "DAMPER"):
        model.opt.disableflags |= int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{name}", 0))
    with pytest.raises(mujoco.FatalError, match="without its passive forces"):
        mujoco.mj_step(model, data)
    model.opt.disableflags = flags
    mujoco.mj_step(model, data)


def test_an_instance_for_another_geom_of_the_same_name_prefix_is_not_taken():
    bodies = f"""<geom name="floor" type="plane" size="9 9 0.1"/>
        <body pos="0 0 0.01"><freejoint/><geom name="foot1" type="box" size="0.1 0.1 0.01" {FRICTIONLESS}/></body>"""
    with pytest.raises(ValueError, match='no geom "foot"'):
        model_of({"foot": {"geom": "foot", "ground": "floor"} | DISK}, bodies)


CHILD = f"""
    <mujoco>
      <extension><plugin plugin="tribos.patch"><instance name="puck">
        <config key="geom" value="puck"/><config key="ground" value="table"/>
        <config key="patch" value="disk"/><config key="size" value="0.05"/><config key="mu" value="0.3"/>
      </instance></plugin></extension>
      <worldbody>
        <geom name="table" type="plane" size="2 2 0.1"/>
        <body name="puck" pos="0 0 0.01"><freejoint/><plugin instance="puck"/><geom name="puck" {PUCK_GEOM}/></body>
      </worldbody>
    </mujoco>"""


def test_a_model_can_be_attached_to_another():
    parent = mujoco.MjSpec.from_string(
        '<mujoco><extension><plugin plugin="tribos.patch"/></extension><worldbody/></mujoco>'
    )
    child = mujoco.MjSpec.from_string(CHILD)
    parent.attach(child, prefix="left/", frame=parent.worldbody.add_frame())
    model = parent.compile()
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=300)
    assert data.plugin_state[0] == pytest.approx(0.2 * 9.81, rel=1e-2)


def test_an_instance_without_name_is_told_by_its_number():
    text = CHILD.replace('<instance name="puck">', "").replace("</instance>", "")
    start, end = text.index("<config"), text.rindex("/>", 0, text.index("</plugin>")) + 2
    configs, text = text[start:end], text[:start] + text[end:]
    text = text.replace(
        '<plugin instance="puck"/>', f'<plugin plugin="tribos.patch">{configs}</plugin>'
    )
    mujoco.MjModel.from_xml_string(text)
    with pytest.raises(ValueError, match="tribos.patch, instance 0: mu must be"):
        mujoco.MjModel.from_xml_string(text.replace('value="0.3"', 'value="-1"'))
