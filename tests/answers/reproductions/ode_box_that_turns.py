"""ODE by Panda3D 1.10.16: a box thrown with a slow spin turns an eighth of its angle, since friction at its corners is a pyramid of world axes."""

from panda3d import core, ode

MU, G, HALF, DT = 0.3, 10.0, 0.05, 1e-3
EXACT = 1.127  # rad at 1 m/s and 5 rad/s


def turned(spin, axis):
    """Thrown along an axis of the world, with its sides along it."""
    world, group = ode.OdeWorld(), ode.OdeJointGroup()
    world.setGravity(0, 0, -G)
    world.setCfm(1e-7)
    world.setQuickStepNumIterations(100)
    surface = ode.OdeSurfaceParameters(ode.OdeSurfaceParameters.MFContactApprox1, MU)
    body, mass = ode.OdeBody(world), ode.OdeMass()
    inertia = 2 * HALF**2 / 3
    mass.setParameters(1.0, 0, 0, 0, 0.55 * inertia, 0.55 * inertia, inertia, 0, 0, 0)
    body.setMass(mass)
    turn = core.LQuaternionf()
    turn.setFromAxisAngle(axis, core.LVector3f(0, 0, 1))
    body.setPosition(0, 0, 0)
    body.setQuaternion(turn)
    floor, box = ode.OdePlaneGeom(0, 0, 1, 0), ode.OdeBoxGeom(2 * HALF, 2 * HALF, 0.02)
    box.setBody(body)
    box.setOffsetPosition(0, 0, 0.01)
    angle = 0.0
    for i in range(1500):
        if i == 500:
            along = turn.xform(core.LVector3f(1, 0, 0))
            body.setLinearVel(along)
            body.setAngularVel(0, 0, spin)
        found = ode.OdeUtil.collide(floor, box, 8)
        for j in range(found.getNumContacts()):
            contact = ode.OdeContact()
            contact.setGeom(found.getContactGeom(j))
            contact.setSurface(surface)
            ode.OdeContactJoint(world, group, contact).attach(None, body)
        world.quickStep(DT)
        group.empty()
        angle += body.getAngularVel()[2] * DT if i >= 500 else 0.0
    return angle


for axis in (0, 45):
    print(f"thrown at {axis} degrees: turns {turned(5.0, axis):.4f} rad, exactly {EXACT} rad")
