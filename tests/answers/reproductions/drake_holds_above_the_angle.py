"""Drake 1.51.1: a cube above the angle of friction (mu 0.5, slope 1.1 of the angle), contact at points: the default approximation holds it."""

import math

import pydrake.all as d


def run(approximation, dt=1e-3, seconds=1.0, mu=0.5, g=9.81):
    builder = d.DiagramBuilder()
    plant, _ = d.AddMultibodyPlant(d.MultibodyPlantConfig(time_step=dt, discrete_contact_approximation=approximation), builder)
    angle = 1.1 * math.atan(mu)
    plant.mutable_gravity_field().set_gravity_vector([g * math.sin(angle), 0.0, -g * math.cos(angle)])
    body = plant.AddRigidBody("cube", d.SpatialInertia.SolidBoxWithMass(1.0, 0.1, 0.1, 0.1))
    friction = d.CoulombFriction(mu, mu)
    plant.RegisterCollisionGeometry(plant.world_body(), d.RigidTransform(), d.HalfSpace(), "floor", friction)
    plant.RegisterCollisionGeometry(body, d.RigidTransform(), d.Box(0.1, 0.1, 0.1), "cube", friction)
    plant.SetDefaultFloatingBaseBodyPose(body, d.RigidTransform([0.0, 0.0, 0.05]))
    plant.Finalize()
    simulator = d.Simulator(builder.Build())
    simulator.AdvanceTo(seconds)
    context = plant.GetMyContextFromRoot(simulator.get_context())
    exact = 0.5 * g * (math.sin(angle) - mu * math.cos(angle)) * seconds**2
    return plant.EvalBodyPoseInWorld(context, body).translation()[0], exact


for approximation in ("lagged", "similar", "sap", "tamsi"):
    print(approximation, "slid, exact (m): {:.4f} {:.4f}".format(*run(approximation)))
