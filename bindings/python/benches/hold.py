"""How far bodies creep in ten seconds that friction holds, in MuJoCo and, where it is installed, Drake.

pip install mujoco drake
python bindings/python/benches/hold.py

The cases are published complaints about simulators, in the order of `tests/examples/hold.rs`, where
the same loads rest on patches of this library. Coulomb's friction holds each of them for ever.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import mujoco
import numpy as np

GRAVITY = 9.81  # m/s²
STEP = 2e-3  # s
SETTLE, SECONDS = 1.0, 10.0  # s
HALF = np.array([0.05, 0.05, 0.025])  # half sides of the block in m
MASS = 1.0  # kg
FOOT = 1e-3  # m, radius of a foot in Drake
CAPSULE = 0.045  # kg
# Time constants of MuJoCo's contacts: the default, and the shortest at this step. Under the default a
# hard grip squeezes the capsule out.
SOFT, STIFF = 0.02, 2.0 * STEP  # s
HARD_GRIP = 30.0  # N

# Ways to run MuJoCo: cone, ratio of frictional to normal impedance, sweeps against slip.
MUJOCO = {
    "pyramid": ("pyramidal", 1, 0),
    "elliptic": ("elliptic", 1, 0),
    "impratio 10": ("elliptic", 10, 0),
    "noslip 10": ("elliptic", 10, 10),
}


@dataclass(frozen=True)
class Block:
    """A block on a plane: friction, tangential and normal force in N, amplitude of a torque in N m."""

    mu: float
    push: float
    load: float
    torque: float = 0.0

    def wrench(self, time: float) -> np.ndarray:
        """Force and torque in the plane's frame; the torque has a period of 1 s."""
        turn = self.torque * math.sin(2.0 * math.pi * time)
        return np.array([self.push, 0.0, -self.load, 0.0, 0.0, turn])


def incline(mu: float, share: float) -> Block:
    """On an incline with a `share` of the tangent at which it slides."""
    angle = math.atan(share * mu)
    weight = MASS * GRAVITY
    return Block(mu, weight * math.sin(angle), weight * math.cos(angle))


def turned(mu: float, share: float) -> Block:
    """Turned forth and back by a `share` of what four corners carry."""
    weight = MASS * GRAVITY
    return Block(mu, 0.0, weight, share * mu * weight * math.hypot(HALF[0], HALF[1]))


CASES: dict[str, float | Block] = {
    "capsule pinched with 12 N (mujoco#3328)": 12.0,
    "capsule pinched with 60 N (mujoco#3328)": 60.0,
    "block on a shallow ramp (newton#1138, mujoco#3349)": incline(1.0, math.tan(math.radians(2.0))),
    "cube pressed on a wall with 20 N (genesis#2872)": Block(1.0, MASS * GRAVITY, 20.0),
    "block at 99 % of its angle": incline(0.5, 0.99),
    "block at 99.9 % of its angle": incline(0.5, 0.999),
    "block under a cyclic torque of 90 %": turned(0.5, 0.9),
}

PLANE = """
<mujoco>
  <option timestep="{step}" gravity="0 0 0" cone="{cone}" impratio="{ratio}" noslip_iterations="{noslip}"/>
  <default><geom friction="{mu} 0.005 0.0001"/></default>
  <worldbody>
    <geom type="plane" size="9 9 0.1"/>
    <body pos="0 0 {height}">
      <freejoint/>
      <geom type="box" size="{sides}" mass="{mass}"/>
    </body>
  </worldbody>
</mujoco>
"""

PINCH = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -{gravity}" cone="{cone}" impratio="{ratio}" noslip_iterations="{noslip}"/>
  <default><geom friction="0.7 0.005 0.0001" solref="{time} 1"/></default>
  <worldbody>
    <body pos="-0.014 0 0" gravcomp="1">
      <joint name="left" type="slide" axis="1 0 0" damping="20"/>
      <geom type="box" size="0.01 0.02 0.02" mass="0.2"/>
    </body>
    <body pos="0.014 0 0" gravcomp="1">
      <joint name="right" type="slide" axis="-1 0 0" damping="20"/>
      <geom type="box" size="0.01 0.02 0.02" mass="0.2"/>
    </body>
    <body euler="90 0 0">
      <freejoint/>
      <geom type="capsule" size="0.004 0.015" mass="{mass}"/>
    </body>
  </worldbody>
  <actuator><motor joint="left"/><motor joint="right"/></actuator>
</mujoco>
"""


def creep(step: Callable[[], None], place: Callable[[], np.ndarray]) -> float:
    """Displacement in ten seconds after the body has settled, in m (or rad)."""
    for _ in range(round(SETTLE / STEP)):
        step()
    start = place()
    for _ in range(round(SECONDS / STEP)):
        step()
    return float(np.linalg.norm(place() - start))


def in_mujoco(case: float | Block, way: tuple[str, int, int]) -> float:
    """Creep in MuJoCo, in m; in rad where a torque acts."""
    cone, ratio, noslip = way
    keys = {"step": STEP, "cone": cone, "ratio": ratio, "noslip": noslip, "gravity": GRAVITY}
    if isinstance(case, Block):
        sides = " ".join(map(str, HALF))
        text = PLANE.format(**keys, mu=case.mu, height=HALF[2], sides=sides, mass=MASS)
    else:
        time = SOFT if case < HARD_GRIP else STIFF
        text = PINCH.format(**keys, mass=CAPSULE, time=time)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    joint = model.nq - 7  # of the free body, which is the last

    def step() -> None:
        if isinstance(case, Block):
            data.xfrc_applied[1] = case.wrench(data.time)
        else:
            data.ctrl[:] = case * min(1.0, 2.0 * data.time / SETTLE)
        mujoco.mj_step(model, data)

    def place() -> np.ndarray:
        pose = data.qpos[joint:].copy()
        if isinstance(case, Block) and case.torque:
            return np.array([2.0 * math.atan2(pose[6], pose[3])])
        return pose[2:3] if not isinstance(case, Block) else pose[:2]

    return creep(step, place)


def in_drake(case: float | Block) -> float:
    """Creep in Drake with point contacts and its default discrete solver, in m or rad."""
    from pydrake.geometry import Box, Capsule, HalfSpace, Sphere
    from pydrake.math import RigidTransform, RollPitchYaw
    from pydrake.multibody.math import SpatialForce
    from pydrake.multibody.plant import (
        AddMultibodyPlantSceneGraph,
        CoulombFriction,
        ExternallyAppliedSpatialForce,
    )
    from pydrake.multibody.tree import FixedOffsetFrame, PrismaticJoint, SpatialInertia
    from pydrake.systems.analysis import Simulator
    from pydrake.systems.framework import DiagramBuilder

    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, STEP)
    is_block = isinstance(case, Block)
    mu = case.mu if isinstance(case, Block) else 0.7
    friction = CoulombFriction(mu, mu)
    plant.mutable_gravity_field().set_gravity_vector([0.0, 0.0, 0.0 if is_block else -GRAVITY])
    identity = RigidTransform()

    def body(name: str, mass: float, shape: object, sides: np.ndarray) -> object:
        inertia = SpatialInertia.SolidBoxWithMass(mass, *(2.0 * sides))
        made = plant.AddRigidBody(name, inertia)
        plant.RegisterCollisionGeometry(made, identity, shape, name, friction)
        return made

    if is_block:
        plant.RegisterCollisionGeometry(
            plant.world_body(), identity, HalfSpace(), "floor", friction
        )
        free = plant.AddRigidBody("free", SpatialInertia.SolidBoxWithMass(MASS, *(2.0 * HALF)))
        # A face touches in one point there: four feet carry a torque.
        for x, y in ((1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)):
            corner = np.array([x * HALF[0], y * HALF[1], FOOT - HALF[2]])
            foot = RigidTransform(corner)
            plant.RegisterCollisionGeometry(free, foot, Sphere(FOOT), f"foot {x} {y}", friction)
        start = RigidTransform([0.0, 0.0, HALF[2]])
    else:
        for name, side in (("left", -1.0), ("right", 1.0)):
            sides = np.array([0.01, 0.02, 0.02])
            pad = body(name, 0.2, Box(*(2.0 * sides)), sides)
            at = RigidTransform([side * 0.0139, 0.0, 0.0])
            frame = plant.AddFrame(FixedOffsetFrame(name, plant.world_frame(), at))
            plant.AddJoint(
                PrismaticJoint(name, frame, pad.body_frame(), [-side, 0.0, 0.0], damping=20.0)
            )
        free = body("free", CAPSULE, Capsule(0.004, 0.03), np.array([0.004, 0.004, 0.019]))
        start = RigidTransform(RollPitchYaw(math.pi / 2.0, 0.0, 0.0), [0.0, 0.0, 0.0])
    plant.SetDefaultFloatingBaseBodyPose(free, start)
    plant.Finalize()
    diagram = builder.Build()
    simulator = Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    forces = plant.get_applied_spatial_force_input_port()

    def applied(name: str, wrench: np.ndarray) -> ExternallyAppliedSpatialForce:
        force = ExternallyAppliedSpatialForce()
        force.body_index = plant.GetBodyByName(name).index()
        force.F_Bq_W = SpatialForce(tau=wrench[3:], f=wrench[:3])
        return force

    def step() -> None:
        time = simulator.get_context().get_time()
        if isinstance(case, Block):
            forces.FixValue(context, [applied("free", case.wrench(time))])
        elif time == 0.0:
            gravity = np.array([0.0, 0.0, 0.2 * GRAVITY, 0.0, 0.0, 0.0])
            push = np.array([case, 0.0, 0.0, 0.0, 0.0, 0.0])
            pads = [applied("left", gravity + push), applied("right", gravity - push)]
            forces.FixValue(context, pads)
        simulator.AdvanceTo(time + STEP)

    def place() -> np.ndarray:
        pose = plant.EvalBodyPoseInWorld(context, free)
        if isinstance(case, Block) and case.torque:
            return np.array([RollPitchYaw(pose.rotation()).yaw_angle()])
        return pose.translation()[2:3] if not is_block else pose.translation()[:2]

    return creep(step, place)


def engines(*, with_drake: bool) -> Iterator[tuple[str, Callable[[float | Block], float]]]:
    """Each engine's name and its creep in a case."""
    for name, way in MUJOCO.items():
        yield name, lambda case, way=way: in_mujoco(case, way)
    if with_drake:
        yield "Drake", in_drake


def has_drake() -> bool:
    """Whether Drake is installed."""
    try:
        import pydrake.multibody.plant  # noqa: F401
    except ImportError:
        return False
    return True


def told(case: float | Block, creep: float) -> str:
    """The speed in µm/s, or that the capsule falls out of its pads of 2 cm."""
    is_lost = not isinstance(case, Block) and creep > 0.02
    return "falls" if is_lost else f"{creep / SECONDS * 1e6:.3g}"


def main() -> None:
    """Print a table."""
    argparse.ArgumentParser(description=__doc__.splitlines()[0]).parse_args()
    chosen = list(engines(with_drake=has_drake()))
    print("Creep in µm/s (µrad/s under a torque), MuJoCo unless another engine is named.")
    print("| case | " + " | ".join(name for name, _ in chosen) + " |")
    print("|---" * (len(chosen) + 1) + "|")
    for name, case in CASES.items():
        speeds = [told(case, found(case)) for _, found in chosen]
        print(f"| {name} | " + " | ".join(speeds) + " |", flush=True)


if __name__ == "__main__":
    main()
