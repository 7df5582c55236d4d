"""Exudyn (pip install exudyn): its general contact, of spheres with each other and with triangles."""

import exudyn as exu
import numpy as np
from exudyn.itemInterface import MarkerBodyRigid, ObjectGround
from exudyn.rigidBodyUtilities import EulerParameters2RotationMatrix, RigidBodyInertia, RotationMatrix2EulerParameters

from ..scene import Unsupported, balls, refuse, sum_of

NAME, VERSION, LICENCE, KIND = "Exudyn", exu.__version__, "BSD-3-Clause", "mechanics"
# Contacts are springs: their stiffness in N/m, share of critical damping for 1 kg, speed in m/s below which friction is viscous, and inner steps.
SPRINGS = {"dt": 1e-3, "stiffness": 1e5, "damping": 5.0, "slip": 1e-3, "substeps": 20}
SETTINGS = {"default": SPRINGS, "stiff": {**SPRINGS, "stiffness": 1e7, "slip": 1e-5, "substeps": 200}}
HALF_FLOOR = 20.0  # m
LACKS = {
    "torsion": "Contacts have no torsional friction.",
    "anisotropic": "Friction is the same in all directions.",
}
MIDPOINT = exu.DynamicSolverType.ExplicitMidpoint


class Simulator:
    def __init__(self, scene, setting, dt):
        refuse(scene, LACKS)
        if any(body.shape.kind not in ("ball", "feet") for body in scene.bodies):
            raise Unsupported("General contact has spheres against spheres and triangles, not two faces.")
        self.system = exu.SystemContainer().AddSystem()
        self.bodies, self.dt, self.time = [], dt, 0.0
        contact = self.system.AddGeneralContact()
        contact.SetFrictionPairings(scene.mu * np.eye(1))
        contact.SetSearchTreeCellSize(numberOfCells=[1, 1, 1])
        contact.frictionProportionalZone = setting["slip"]
        # Two springs in series, two dampers side by side.
        stiffness = 2 * setting["stiffness"]
        damping = setting["damping"] * setting["stiffness"] ** 0.5
        if scene.has_floor:
            marker = self.system.AddMarker(MarkerBodyRigid(bodyNumber=self.system.AddObject(ObjectGround())))
            corners = [[x * HALF_FLOOR, y * HALF_FLOOR, 0.0] for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            contact.AddTrianglesRigidBodyBased(marker, stiffness, damping, 0, corners, [[0, 1, 2], [0, 2, 3]])
        for body in scene.bodies:
            turn = EulerParameters2RotationMatrix(body.pose)
            number = self.system.CreateRigidBody(
                referencePosition=list(np.add(body.place, turn @ body.com)), referenceRotationMatrix=turn, gravity=list(scene.gravity),
                inertia=RigidBodyInertia(mass=body.mass, inertiaTensor=np.diag(body.inertia)), nodeType=exu.NodeType.RotationRotationVector,
            )  # fmt: skip
            radius, places = balls(body.shape)
            for place in places:
                marker = self.system.AddMarker(MarkerBodyRigid(bodyNumber=number, localPosition=sum_of(place, body.com, -1.0)))
                contact.AddSphereWithMarker(marker, radius, stiffness, damping, 0)
            self.bodies.append(number)
        self.system.Assemble()
        self.solver = exu.SimulationSettings()
        self.solver.solution.file.write = False
        self.solver.timeIntegration.numberOfSteps = setting["substeps"]

    def set(self, body, velocity, spin):
        # Coordinates of spins lie along the axes of the body.
        speeds = self.system.systemData.GetODE2Coordinates_t(exu.ConfigurationType.Initial)
        speeds[6 * body : 6 * body + 6] = (*velocity, *(self.turn(body).T @ spin))
        self.system.systemData.SetODE2Coordinates_t(speeds, exu.ConfigurationType.Initial)

    def step(self):
        times = self.solver.timeIntegration
        times.startTime, times.endTime = self.time, self.time + self.dt
        self.time += self.dt
        self.system.SolveDynamic(self.solver, solverType=MIDPOINT, updateInitialValues=True)

    def turn(self, body):
        return self.output(body, "RotationMatrix").reshape(3, 3)

    def output(self, body, name):
        return np.array(self.system.GetObjectOutputBody(self.bodies[body], getattr(exu.OutputVariableType, name), [0, 0, 0], exu.ConfigurationType.Initial))

    def state(self, body):
        q = RotationMatrix2EulerParameters(self.turn(body))
        place, velocity, spin = (self.output(body, name) for name in ("Position", "Velocity", "AngularVelocity"))
        return tuple(tuple(map(float, part)) for part in (place, q, velocity, spin))
