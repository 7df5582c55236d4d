#!/usr/bin/env python3
"""The scenes in Drake (pip install drake), as CSV: contact at points, and hydroelastic contact of faces."""

import math
import sys
import time
from importlib.metadata import version

from scenes import FOOT, MASS, SCENES, SETTLE, THROWN, creep, follow, print_results, roll

try:
    from pydrake.geometry import (
        AddCompliantHydroelasticProperties,
        AddContactMaterial,
        AddRigidHydroelasticProperties,
        Box,
        Cylinder,
        ProximityProperties,
        Sphere,
    )
    from pydrake.math import RigidTransform, RollPitchYaw
    from pydrake.multibody.math import SpatialVelocity
    from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, ContactModel, CoulombFriction
    from pydrake.multibody.tree import RotationalInertia, SpatialInertia
    from pydrake.systems.analysis import Simulator as DrakeSimulator
    from pydrake.systems.framework import DiagramBuilder
except ImportError:
    sys.exit("Drake is not installed")

STEP = 0.001  # s
MODULUS = 1e7  # Pa
# Flat faces touch in one point in Drake's point contact, which has no torque: faces are for the hydroelastic one.
WAYS = {"points": ContactModel.kPoint, "hydroelastic": ContactModel.kHydroelastic}


def shapes(scene):
    """Name, shape and place of each."""
    if scene.feet:
        for i, (x, y) in enumerate(scene.feet):
            yield f"foot{i}", Sphere(FOOT), [x, y, 0.0]
    elif scene.name == "ball":
        yield "ball", Sphere(scene.radius), [0.0, 0.0, 0.0]
    elif scene.half_sides:
        x, y = scene.half_sides
        yield "foot", Box(2 * x, 2 * y, 2 * scene.half_height), [0.0, 0.0, 0.0]
    else:
        yield "foot", Cylinder(scene.radius, 2 * scene.half_height), [0.0, 0.0, 0.0]


def properties(scene, is_floor):
    made = ProximityProperties()
    AddContactMaterial(
        dissipation=1.0, friction=CoulombFriction(scene.mu, scene.mu), properties=made
    )
    if is_floor:
        AddRigidHydroelasticProperties(0.5, made)
    else:
        AddCompliantHydroelasticProperties(0.01, MODULUS, made)
    return made


class Simulator:
    dt = STEP

    def __init__(self, scene, contact):
        self.is_ball = scene.name == "ball"
        builder = DiagramBuilder()
        self.plant, _ = AddMultibodyPlantSceneGraph(builder, STEP)
        self.plant.set_contact_model(contact)
        self.plant.mutable_gravity_field().set_gravity_vector([0.0, 0.0, -scene.gravity])
        middle = scene.radius if self.is_ball else scene.half_height
        self.low = 0.0 if self.is_ball else scene.height - middle
        level, _, upright = [0.4 * MASS * scene.radius**2] * 3 if self.is_ball else scene.inertia
        inertia = SpatialInertia.MakeFromCentralInertia(
            MASS, [0.0, 0.0, self.low], RotationalInertia(level, level, upright)
        )
        self.body = self.plant.AddRigidBody("body", inertia)
        floor = RigidTransform([0.0, 0.0, -0.5])
        self.plant.RegisterCollisionGeometry(
            self.plant.world_body(), floor, Box(100.0, 100.0, 1.0), "floor", properties(scene, True)
        )
        for name, form, place in shapes(scene):
            self.plant.RegisterCollisionGeometry(
                self.body, RigidTransform(place), form, name, properties(scene, False)
            )
        self.plant.SetDefaultFloatingBaseBodyPose(self.body, RigidTransform([0.0, 0.0, middle]))
        self.plant.Finalize()
        self.simulator = DrakeSimulator(builder.Build())
        self.context = self.plant.GetMyMutableContextFromRoot(self.simulator.get_mutable_context())
        self.simulator.AdvanceTo(SETTLE)

    def launch(self, speed, spin):
        turn = [0, spin, 0] if self.is_ball else [0, 0, spin]
        velocity = SpatialVelocity(w=turn, v=[speed, 0, 0])
        self.plant.SetFreeBodySpatialVelocity(self.context, self.body, velocity)

    def step(self):
        self.simulator.AdvanceTo(self.simulator.get_context().get_time() + STEP)

    def pose(self):
        pose = self.plant.EvalBodyPoseInWorld(self.context, self.body)
        x, y, _ = pose.multiply([0.0, 0.0, self.low])
        return x, y, RollPitchYaw(pose.rotation()).yaw_angle()

    def motion(self):
        velocity = self.plant.EvalBodySpatialVelocityInWorld(self.context, self.body)
        x, y, _ = velocity.translational()
        return math.hypot(x, y), velocity.rotational()[2]


def cost(scene, contact):
    """Least time of a step of a sliding body, in µs."""
    least = math.inf
    for _ in range(3):
        simulator = Simulator(scene, contact)
        simulator.launch(1.0, scene.spins[-1])
        start = time.process_time()
        for _ in range(100):
            simulator.step()
        least = min(least, (time.process_time() - start) / 100)
    return 1e6 * least


def results():
    for way, contact in WAYS.items():
        rows = []
        for name in THROWN:
            scene = SCENES[name]
            if bool(scene.feet) == (contact == ContactModel.kPoint):
                for spin in scene.spins:
                    rows += follow(scene, spin, Simulator(scene, contact))
        if contact == ContactModel.kPoint:
            for spin in SCENES["ball"].spins:
                rows += roll(SCENES["ball"], spin, Simulator(SCENES["ball"], contact))
            rows += creep(lambda hold, grip: hold.in_drake(grip))
        measured = "tripod" if contact == ContactModel.kPoint else "puck"
        rows.append(["cost", "50", "step_us", f"{cost(SCENES[measured], contact):.3g}"])
        yield way, False, rows


if __name__ == "__main__":
    print_results(f"Drake {version('drake')}, BSD-3-Clause, steps of {1e3 * STEP:g} ms", results())
