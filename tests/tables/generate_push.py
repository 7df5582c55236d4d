"""Reference table of quasi-static pushes of a box: pushes.csv.

    python3 generate_push.py > pushes.csv       a minute or two; needs numpy and scipy

The floor is summed over 960 x 640 nodes of a box of 0.3 m x 0.2 m (muN = 1), under linear pressure. A pusher touches the
lower side. A sticking contact moves with the pusher, and the body turns such that the least power is
dissipated; the force is the sum of the friction. If that force leaves the friction cone, the contact slides: its slip is the
one for which the force lies on the cone's edge. No limit surface, gauge or normal is computed. The nodes are good for
1e-5.
"""

import numpy
from scipy.optimize import brentq, minimize_scalar

A, B = 0.3, 0.2
NX, NY = 960, 640
X, Y = numpy.meshgrid(((numpy.arange(NX) + 0.5) / NX - 0.5) * A, ((numpy.arange(NY) + 0.5) / NY - 0.5) * B)
CASES = [
    # contact x, pusher's mu, velocity, centre of pressure
    (0.0, 0.3, (0.0, 1.0), (0.0, 0.0)),
    (0.02, 0.3, (0.0, 1.0), (0.0, 0.0)),
    (0.05, 0.3, (0.0, 1.0), (0.0, 0.0)),
    (0.05, 0.6, (0.0, 1.0), (0.0, 0.0)),
    (0.05, 0.05, (0.0, 1.0), (0.0, 0.0)),
    (-0.1, 0.5, (0.3, 1.0), (0.0, 0.0)),
    (-0.1, 0.5, (-0.6, 1.0), (0.0, 0.0)),
    (0.12, 0.2, (1.0, 1.0), (0.0, 0.0)),
    (0.12, 0.9, (0.4, 0.8), (0.0, 0.0)),
    (0.03, 0.4, (-0.2, 1.0), (0.02, 0.01)),
    (0.03, 0.4, (0.5, 1.0), (0.02, 0.01)),
    (-0.06, 0.25, (-1.0, 0.3), (-0.02, -0.01)),
    (-0.06, 1.5, (0.9, 0.4), (-0.02, -0.01)),
    (0.149, 0.1, (0.1, 2.0), (0.03, 0.0)),
]


def pressure(cx, cy):
    """Linear, with its centre there: the second moments of a box are a^2/12 and b^2/12."""
    k = 1 + 12 * cx / A**2 * X + 12 * cy / B**2 * Y
    return k / k.sum()


def friction(p, vx, vy, w):
    """What the pusher has to exert: force and torque about the origin, and the power."""
    ux, uy = vx - w * Y, vy + w * X
    speed = numpy.hypot(ux, uy)
    fx, fy = (p * ux / speed).sum(), (p * uy / speed).sum()
    return fx, fy, (p * (X * uy - Y * ux) / speed).sum(), (p * speed).sum()


def turning(p, at, velocity):
    """The motion with this velocity of the contact that dissipates least."""
    def motion(w):
        return velocity[0] + w * at[1], velocity[1] - w * at[0], w
    size = numpy.hypot(*velocity)
    found = minimize_scalar(lambda w: friction(p, *motion(w))[3], bounds=(-60 * size, 60 * size), method="bounded",
                            options={"xatol": 1e-10})
    # The torque about the contact, which the minimum makes zero, has the digits.
    def torque(w):
        fx, fy, t, _ = friction(p, *motion(w))
        return t - at[0] * fy + at[1] * fx
    w = found.x
    w = brentq(torque, w - 0.05 * size, w + 0.05 * size, xtol=1e-12)
    return motion(w), friction(p, *motion(w))


print("# Quasi-static pushes of a box of 0.3 x 0.2 at its lower side, muN = 1: generate_push.py")
print("contact_x,mu,pusher_x,pusher_y,centre_x,centre_y,slip,velocity_x,velocity_y,spin,force_x,force_y,torque")
for x, mu, u, centre in CASES:
    p, at = pressure(*centre), (x, -B / 2)

    def slipped(slip):
        # Slip to the right of x is positive here; the pusher slides past the contact.
        return turning(p, at, (u[0] - slip, u[1]))

    motion, (fx, fy, torque, _) = slipped(0.0)
    slip = 0.0
    if abs(fx) > mu * fy:
        side = numpy.sign(fx)
        def beyond(slip):
            fx, fy = slipped(slip)[1][:2]
            return fx - side * mu * fy
        far = side * 0.1
        while numpy.sign(beyond(far)) == numpy.sign(beyond(0.0)):
            far *= 2
        slip = brentq(beyond, *sorted((0.0, far)), xtol=1e-9)
        motion, (fx, fy, torque, _) = slipped(slip)
    row = [x, mu, *u, *centre, slip, *motion, fx, fy, torque]
    print(",".join(repr(float(v)) for v in row), flush=True)
