"""ODE as Panda3D has it (pip install panda3d), in single precision."""

from importlib.metadata import version
from itertools import combinations

from panda3d import core, ode

from ..scene import Unsupported, parts, refuse, rotated

NAME, VERSION, LICENCE, KIND = "ODE (Panda3D)", version("panda3d"), "BSD-3-Clause", "games"
SETTINGS = {
    "default": {"dt": 1 / 90, "cfm": 1e-5, "iterations": 20},
    "steps of 1 ms, 100 iterations, softness 1e-7": {"dt": 1e-3, "cfm": 1e-7, "iterations": 100},
}
APPROX = ode.OdeSurfaceParameters.MFContactApprox1  # else friction would have a bound in N
ALONG = ode.OdeSurfaceParameters.MFContactFDir1 | ode.OdeSurfaceParameters.MFContactMu2


SHAPES = {
    "ball": ode.OdeSphereGeom,
    "box": lambda *half: ode.OdeBoxGeom(*(2 * size for size in half)),
    "cylinder": lambda radius, half: ode.OdeCylinderGeom(radius, 2 * half),
    "capsule": lambda radius, half: ode.OdeCappedCylinderGeom(radius, 2 * half),
}


class Simulator:
    def __init__(self, scene, setting, dt):
        refuse(scene, {"torsion": "Contacts have no torsional friction."})
        if [body.shape.kind for body in scene.bodies].count("cylinder") > 1:
            raise Unsupported("Cylinders do not touch cylinders.")
        self.world, self.group, self.scene, self.dt = ode.OdeWorld(), ode.OdeJointGroup(), scene, dt
        self.bodies, groups = [], []
        ode.OdeUtil.randSetSeed(0)  # of the order in which contacts are solved
        self.world.setCfm(setting["cfm"])
        self.world.setQuickStepNumIterations(setting["iterations"])
        self.gravity(scene.gravity)
        self.surface = ode.OdeSurfaceParameters(APPROX, scene.mu)
        if scene.mu_across is not None:
            self.surface.setMode(APPROX | ALONG)
            self.surface.setMu2(scene.mu_across)
        if scene.has_floor:
            groups.append([ode.OdePlaneGeom(0.0, 0.0, 1.0, 0.0)])
        for body in scene.bodies:
            made, mass = ode.OdeBody(self.world), ode.OdeMass()
            mass.setParameters(body.mass, 0.0, 0.0, 0.0, *body.inertia, 0.0, 0.0, 0.0)
            made.setMass(mass)
            made.setPosition(*(a + b for a, b in zip(body.place, rotated(body.pose, body.com))))
            made.setQuaternion(core.LQuaternionf(*body.pose))
            made.setGravityMode(not body.is_driven)
            groups.append([])
            for geom, place, q in parts(body.shape, **SHAPES):
                groups[-1].append(geom)
                geom.setBody(made)
                geom.setOffsetPosition(*(a - b for a, b in zip(place, body.com)))
                geom.setOffsetQuaternion(core.LQuaternionf(*q))
            self.bodies.append(made)
        self.pairs = [(a, b) for one, other in combinations(groups, 2) for a in one for b in other]

    def set(self, body, velocity, spin):
        self.bodies[body].setLinearVel(*velocity)
        self.bodies[body].setAngularVel(*spin)

    def step(self):
        for one, other in self.pairs:
            found = ode.OdeUtil.collide(one, other, 16)
            for i in range(found.getNumContacts()):
                contact = ode.OdeContact()
                contact.setGeom(found.getContactGeom(i))
                contact.setSurface(self.surface)
                if self.scene.mu_across is not None:
                    contact.setFdir1(core.LVecBase3f(*rotated(self.state(0)[1], (1.0, 0.0, 0.0))))
                ode.OdeContactJoint(self.world, self.group, contact).attach(*(geom.getBody() if geom.hasBody() else None for geom in (one, other)))
        self.world.quickStep(self.dt)
        self.group.empty()

    def state(self, body):
        made = self.bodies[body]
        return tuple(map(tuple, (made.getPosition(), made.getQuaternion(), made.getLinearVel(), made.getAngularVel())))

    def gravity(self, vector):
        self.world.setGravity(*vector)

    def force(self, body, vector):
        self.bodies[body].addForce(*vector)
