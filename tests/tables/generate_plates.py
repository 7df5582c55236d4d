"""Reference table of flat plates that slide and spin to rest: plates.csv.

    python3 generate_plates.py

Shares nothing with the program: in the laboratory frame, over tau with dt = |V| dtau, by DOP853 to a
relative tolerance of 1e-12 until |V| has fallen to 1e-11, where nothing is left of time and way; force and
torque by Gauss' rule with 48 points an edge over u, where the edge lies at t = h sinh(u) seen from the
centre of rotation and the integrals over the triangle between centre and edge are
du (n + tau sinh u) h^2/2 and du h^3 cosh^2(u)/3. Needs numpy and scipy.
"""

import numpy as np
from scipy.integrate import solve_ivp

NODES, WEIGHTS = np.polynomial.legendre.leggauss(48)
G = 9.81
SHAPES = {
    "box": [(-0.15, -0.05), (0.15, -0.05), (0.15, 0.05), (-0.15, 0.05)],
    "triangle": [(0.0, 0.0), (0.3, 0.0), (0.0, 0.2)],
    "ell": [(0.0, 0.0), (0.4, 0.0), (0.4, 0.1), (0.1, 0.1), (0.1, 0.4), (0.0, 0.4)],
}
LAUNCHES = [
    # shape, mu, speed, spin, orientation, radius of gyration (0: of the outline)
    ("box", 0.3, 1.0, 8.0, 0.0, 0.0),
    ("box", 0.3, 1.0, 8.0, 0.7, 0.0),
    ("box", 0.2, 0.8, -20.0, 1.2, 0.1),
    ("triangle", 0.3, 1.0, 5.0, 0.0, 0.0),
    ("triangle", 0.3, 0.0, 12.0, 0.3, 0.0),
    ("triangle", 0.5, 2.0, -9.0, 2.0, 0.12),
    ("ell", 0.3, 1.0, 5.0, -0.5, 0.0),
    ("ell", 0.1, 0.4, 6.0, 2.5, 0.2),
]


def centred(corners):
    """Corners about the centroid, area and polar radius of gyration."""
    p = np.array(corners)
    q = np.roll(p, -1, axis=0)
    cross = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    area = cross.sum() / 2
    p = p - ((p + q) * cross[:, None]).sum(axis=0) / (6 * area)
    q = np.roll(p, -1, axis=0)
    cross = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    polar = (cross * ((p * p).sum(1) + (p * q).sum(1) + (q * q).sum(1))).sum() / 12
    return p, area, np.sqrt(polar / area)


def wrench(corners, area, vx, vy, w):
    """Force and torque about the centroid for mu N = 1."""
    c = np.array([-vy / w, vx / w])
    p = corners - c
    q = np.roll(p, -1, axis=0)
    force, moment = np.zeros(2), 0.0
    for a, b in zip(p, q):
        edge = b - a
        length = np.hypot(*edge)
        tau = edge / length
        n = np.array([tau[1], -tau[0]])
        h, t0, t1 = a @ n, a @ tau, b @ tau
        if h == 0.0:
            continue
        u0, u1 = np.arcsinh(t0 / abs(h)), np.arcsinh(t1 / abs(h))
        u = (u0 + u1) / 2 + (u1 - u0) / 2 * NODES
        du = (u1 - u0) / 2 * WEIGHTS
        sign = np.sign(h)
        # dphi = du/cosh u, r = |h| cosh u, e = (n sign + tau sinh u)/cosh u.
        force += sign * (h * h / 2) * (sign * n * du.sum() + tau * (du * np.sinh(u)).sum())
        moment += sign * abs(h) ** 3 / 3 * (du * np.cosh(u) ** 2).sum()
    s = np.sign(w)
    # q = w z x rho.
    force = s * np.array([-force[1], force[0]]) / area
    moment = s * moment / area
    return -force[0], -force[1], -(moment + c[0] * force[1] - c[1] * force[0])


def run(shape, mu, speed, spin, orientation, gyration):
    corners, area, own = centred(SHAPES[shape])
    k = gyration or own

    def rate(_, y):
        t, px, py, angle, vx, vy, w = y
        a = orientation + angle
        cos, sin = np.cos(a), np.sin(a)
        fx, fy, torque = wrench(corners, area, cos * vx + sin * vy, cos * vy - sin * vx, w)
        size = np.sqrt(vx * vx + vy * vy + (w * k) ** 2)
        limit = mu * G
        return [size, size * vx, size * vy, size * w, size * limit * (cos * fx - sin * fy),
                size * limit * (sin * fx + cos * fy), size * limit * torque / k**2]

    y = np.array([0, 0, 0, 0, speed, 0, spin], float)
    done = lambda _, y: np.sqrt(y[4] ** 2 + y[5] ** 2 + (y[6] * k) ** 2) - 1e-11
    done.terminal = True
    end = solve_ivp(rate, (0, 1e3), y, method="DOP853", rtol=1e-12, atol=1e-14, events=done)
    t, px, py, angle, *_ = end.y[:, -1]
    return t, px, py, angle


if __name__ == "__main__":
    with open("plates.csv", "w") as table:
        table.write("# flat plates under Coulomb friction, g = 9.81, SI, to rest; by generate_plates.py\n")
        table.write("shape,mu,v0,spin0,orientation,gyration,t_stop,x,y,angle\n")
        for launch in LAUNCHES:
            row = launch + run(*launch)
            table.write(",".join(x if isinstance(x, str) else f"{float(x):.12g}" for x in row) + "\n")
            print(row, flush=True)
