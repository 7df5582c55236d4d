"""Friction of a face under Coulomb's law: the wrench per coefficient and load, about the centre of mass, in the body's axes.

Each face has `wrench(vx, vy, spin)`, the force along x and y and the torque, and `scale(vx, vy, spin)`, a speed that becomes small
where the wrench changes quickly.
"""

from . import numbers as mp


class PolygonFace:
    """Pressure 1 + a x + b y, over its mean, on a polygon with its corners in order; x and y from the centroid.

    With rho the place from the centre of rotation, r = |rho|, the force is the integral of p rho/r, turned by a right angle, and the
    torque about the centre that of p r. By the divergence theorem both are line integrals of r and r t along the edges.
    """

    def __init__(self, corners, middle=(0, 0), slope=(0, 0)):
        """`middle` is the centroid of the corners as seen from the centre of mass."""
        self.edges = list(zip(corners, corners[1:] + corners[:1]))
        self.middle, self.slope = middle, slope
        self.area = sum(a[0] * b[1] - a[1] * b[0] for a, b in self.edges) / 2
        polar = sum((a[0] * b[1] - a[1] * b[0]) * (a[0] ** 2 + a[0] * b[0] + b[0] ** 2 + a[1] ** 2 + a[1] * b[1] + b[1] ** 2) for a, b in self.edges)
        self.gyration_sq = polar / 12 / self.area

    def wrench(self, vx, vy, spin):
        mx, my = self.middle
        # Velocity of the centroid, and the centre of rotation from there.
        vx, vy = vx - spin * my, vy + spin * mx
        cx, cy = -vy / spin, vx / spin
        # Integrals of grad r, x grad r, y grad r, of r, x r, y r, with x and y from the centroid.
        plain, first, second = [0, 0], [0, 0], [0, 0]
        r_sum = xr_sum = yr_sum = 0
        for (ax, ay), (bx, by) in self.edges:
            ax, ay, bx, by = ax - cx, ay - cy, bx - cx, by - cy
            length = mp.sqrt((bx - ax) ** 2 + (by - ay) ** 2)
            if length == 0:
                continue
            tx, ty = (bx - ax) / length, (by - ay) / length
            nx, ny, far = ty, -tx, ax * ty - ay * tx
            t0, t1 = ax * tx + ay * ty, bx * tx + by * ty
            r0, r1 = mp.sqrt(ax * ax + ay * ay), mp.sqrt(bx * bx + by * by)
            integral = (t1 * r1 - t0 * r0) / 2
            if far != 0:
                integral += far * far * (mp.asinh(t1 / abs(far)) - mp.asinh(t0 / abs(far))) / 2
            along = (r1**3 - r0**3) / 3  # of t r
            # Of rho r on the edge: rho = far n + t tangent.
            rx, ry = far * nx * integral + along * tx, far * ny * integral + along * ty
            plain[0], plain[1] = plain[0] + nx * integral, plain[1] + ny * integral
            first[0], first[1] = first[0] + nx * (cx * integral + rx), first[1] + ny * (cx * integral + rx)
            second[0], second[1] = second[0] + nx * (cy * integral + ry), second[1] + ny * (cy * integral + ry)
            r_sum = r_sum + far * integral / 3
            xr_sum, yr_sum = xr_sum + far * rx / 4, yr_sum + far * ry / 4
        first[0], second[1] = first[0] - r_sum, second[1] - r_sum
        a, b = self.slope
        gx = plain[0] + a * first[0] + b * second[0]
        gy = plain[1] + a * first[1] + b * second[1]
        about = r_sum + a * (cx * r_sum + xr_sum) + b * (cy * r_sum + yr_sum)
        sense = (1 if spin > 0 else -1) / self.area
        fx, fy = sense * gy, -sense * gx
        torque = -sense * about + cx * fy - cy * fx
        return fx, fy, torque + mx * fy - my * fx

    def scale(self, vx, vy, spin):
        return mp.sqrt(vx * vx + vy * vy + self.gyration_sq * spin * spin)


def with_load_below(corners, gyration_sq):
    """The polygon whose linear pressure is balanced below the centre of mass, from which its corners are seen.

    The moments of the pressure about the centroid are second moments of area times its slope.
    """
    edges = list(zip(corners, corners[1:] + corners[:1]))
    crosses = [a[0] * b[1] - a[1] * b[0] for a, b in edges]
    area = sum(crosses) / 2
    mx = sum(c * (a[0] + b[0]) for c, (a, b) in zip(crosses, edges)) / 6 / area
    my = sum(c * (a[1] + b[1]) for c, (a, b) in zip(crosses, edges)) / 6 / area
    own = [(x - mx, y - my) for x, y in corners]
    edges = list(zip(own, own[1:] + own[:1]))
    crosses = [a[0] * b[1] - a[1] * b[0] for a, b in edges]
    xx = sum(c * (a[0] ** 2 + a[0] * b[0] + b[0] ** 2) for c, (a, b) in zip(crosses, edges)) / 12 / area
    yy = sum(c * (a[1] ** 2 + a[1] * b[1] + b[1] ** 2) for c, (a, b) in zip(crosses, edges)) / 12 / area
    xy = sum(c * (a[0] * b[1] + 2 * a[0] * a[1] + 2 * b[0] * b[1] + b[0] * a[1]) for c, (a, b) in zip(crosses, edges)) / 24 / area
    det = xx * yy - xy * xy
    face = PolygonFace(own, (mx, my), ((-mx * yy + my * xy) / det, (mx * xy - my * xx) / det))
    if gyration_sq is not None:
        face.gyration_sq = gyration_sq
    return face


class BarFace:
    """Uniform pressure on a line along x about the origin."""

    def __init__(self, half):
        self.half, self.gyration_sq = half, half * half / 3

    def wrench(self, vx, vy, spin):
        u0, u1 = vy - spin * self.half, vy + spin * self.half
        q0, q1 = mp.sqrt(vx * vx + u0 * u0), mp.sqrt(vx * vx + u1 * u1)
        angle = mp.asinh(u1 / abs(vx)) - mp.asinh(u0 / abs(vx)) if vx != 0 else 0
        length = 2 * self.half * spin
        across = (q1 - q0) / length
        moment = ((u1 * q1 - u0 * q0) - vx * vx * angle) / 2 / length
        return -vx * angle / length, -across, -(moment - vy * across) / spin

    scale = PolygonFace.scale


class RoundFace:
    """A disk or a thin ring about the origin under uniform pressure, by complete elliptic integrals."""

    def __init__(self, radius, gyration_sq, is_ring=False):
        self.radius, self.gyration_sq, self.is_ring = radius, gyration_sq, is_ring

    def wrench(self, vx, vy, spin):
        speed, rim = mp.sqrt(vx * vx + vy * vy), abs(spin) * self.radius
        force, torque = (ring if self.is_ring else disk)(speed, rim)
        sense = 1 if spin > 0 else -1
        if speed == 0:
            return 0, 0, -sense * self.radius * torque
        return -force * vx / speed, -force * vy / speed, -sense * self.radius * torque

    scale = PolygonFace.scale


def elliptic(m):
    """K, E, B = (E - (1 - m) K)/m and D = (K - E)/m of the parameter m below 1, by the arithmetic-geometric mean."""
    a, b, power, d_sum = mp.real("1"), mp.sqrt(1 - m), mp.real("0.5"), 0
    c_sq = m
    # K - E = K sum of 2^(n-1) c_n^2, whose terms fall quadratically.
    for _ in range(9):
        d_sum = d_sum + power * c_sq
        a, b, c_sq, power = (a + b) / 2, mp.sqrt(a * b), ((a - b) / 2) ** 2, 2 * power
    k = mp.asin(mp.real("1")) / a
    d = k * (d_sum / m) if m else k / 2
    return k, k - m * d, k - d, d


def ring(speed, rim):
    """Force and torque over the largest ones: that of the force at v/w is that of the torque at w/v."""
    lesser, greater = min(speed, rim), max(speed, rim)
    m = (lesser / greater) ** 2
    half_pi = mp.asin(mp.real("1"))
    if m == 1:
        less = more = 1 / half_pi
    else:
        _, _, b, d = elliptic(m)
        less, more = lesser / greater * b / half_pi, (b + (1 - m) * d) / half_pi
    return (less, more) if speed < rim else (more, less)


def disk(speed, rim):
    """Force over mu N and torque over mu N R, in the integrals B, C = (D - B)/m and D, no terms of which cancel."""
    half_pi = mp.asin(mp.real("1"))
    lesser, greater = min(speed, rim), max(speed, rim)
    h = lesser / greater
    m = h * h
    if m == 1:
        return 4 / (3 * half_pi), 4 / (9 * half_pi)
    _, _, b, d = elliptic(m)
    phi = 2 / (3 * half_pi) * (2 * b + (1 - m) * d)
    theta = (phi + (1 - m) * 2 / (3 * half_pi) * (third(m, b, d) - d)) / 3
    if speed > rim:
        return phi, h * theta
    return h * phi, 2 * (1 - m) / 3 * phi + m * theta


def third(m, b, d):
    """C, by the trapezoidal rule where D - B cancels; its error is of the order (m/16)^16."""
    if m > mp.real("0.1"):
        return (d - b) / m
    total, step = 0, mp.asin(mp.real("1")) / 16
    for i in range(1, 32, 2):
        sine, cosine = mp.sin(i * step), mp.cos(i * step)
        root = mp.sqrt(1 - m * sine * sine)
        total = total + sine * sine * cosine * cosine / (root * root * root)
    return total * step
