"""Bodies whose mass is above the ground: friction at the ground shifts the pressure, which shifts friction.

With the height h of the centre of mass and the friction F under the load N, the centre of pressure lies at -h F/N from below the centre of mass. Both
faces are linear in that place, so that F follows from two linear equations.
"""

from . import numbers as mp
from .motion import END, Extrapolation, Slide

# A foot this many tolerances slower than the others rests: its velocity is a difference with that error.
RESTS = 1000
NODES, GRADE = 192, 4


class Standing:
    """`parts` gives three wrenches per coefficient and load: of the own pressure, and what a unit of the centre of pressure along x and y adds."""

    def __init__(self, mu, height):
        self.lever = mu * height

    def shift(self, own, x, y):
        """Of the centre of pressure."""
        k = self.lever
        a11, a12, a21, a22 = 1 + k * x[0], k * y[0], k * x[1], 1 + k * y[1]
        det = a11 * a22 - a12 * a21
        return -k * (own[0] * a22 - own[1] * a12) / det, -k * (a11 * own[1] - a21 * own[0]) / det

    def wrench(self, vx, vy, spin):
        own, x, y = self.parts(vx, vy, spin)
        sx, sy = self.shift(own, x, y)
        return tuple(a + sx * b + sy * c for a, b, c in zip(own, x, y))


class TallFace(Standing):
    """A disk under linear pressure: the integrals of `PolygonFace` along its rim, with nodes close where the rim is slowest."""

    def __init__(self, mu, height, radius, gyration_sq):
        super().__init__(mu, height)
        self.radius, self.gyration_sq = radius, gyration_sq
        two_pi = 4 * mp.asin(mp.real("1"))
        self.angles = []
        for i in range(NODES):
            s = (mp.real(repr(float(i))) + mp.real("0.5")) / NODES
            up, down = s**GRADE, (1 - s) ** GRADE
            slope = GRADE * up * down / (s * (1 - s)) / (up + down) ** 2
            angle = two_pi * up / (up + down)
            self.angles.append((mp.cos(angle), mp.sin(angle), two_pi * radius * slope / NODES))

    def parts(self, vx, vy, spin):
        cx, cy = -vy / spin, vx / spin
        away = mp.sqrt(cx * cx + cy * cy)
        co, si = (cx / away, cy / away) if away else (1, 0)
        gx = gy = xgx = xgy = ygx = ygy = r_sum = xr_sum = yr_sum = 0
        for cosine, sine, arc in self.angles:
            nx, ny = co * cosine - si * sine, si * cosine + co * sine
            x, y = self.radius * nx, self.radius * ny
            px, py = x - cx, y - cy
            r = mp.sqrt(px * px + py * py) * arc
            far = (px * nx + py * ny) * r
            gx, gy = gx + nx * r, gy + ny * r
            xgx, xgy, ygx, ygy = xgx + nx * x * r, xgy + ny * x * r, ygx + nx * y * r, ygy + ny * y * r
            r_sum, xr_sum, yr_sum = r_sum + far / 3, xr_sum + far * px / 4, yr_sum + far * py / 4
        # Over the area, and a unit of the centre of pressure is a slope of 4/R^2.
        unit = (1 if spin > 0 else -1) / (2 * mp.asin(mp.real("1")) * self.radius**2)
        made = []
        for hx, hy, about, size in (
            (gx, gy, r_sum, unit),
            (xgx - r_sum, xgy, cx * r_sum + xr_sum, 4 * unit / self.radius**2),
            (ygx, ygy - r_sum, cy * r_sum + yr_sum, 4 * unit / self.radius**2),
        ):
            fx, fy = size * hy, -size * hx
            made.append((fx, fy, -size * about + cx * fy - cy * fx))
        return made

    def scale(self, vx, vy, spin):
        return mp.sqrt(vx * vx + vy * vy + self.gyration_sq * spin * spin)


class Feet(Standing):
    """Three points, whose loads follow from statics."""

    def __init__(self, mu, height, feet, gyration_sq):
        super().__init__(mu, height)
        self.mu, self.height, self.feet, self.gyration_sq = mu, height, feet, gyration_sq
        (ax, ay), (bx, by), (cx, cy) = feet
        twice = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        # Share of each foot, and its gradient in the centre of pressure.
        self.shares = []
        for (px, py), (qx, qy) in ((feet[1], feet[2]), (feet[2], feet[0]), (feet[0], feet[1])):
            self.shares.append(((px * qy - py * qx) / twice, (py - qy) / twice, (qx - px) / twice))

    def parts(self, vx, vy, spin):
        made = [[0, 0, 0] for _ in range(3)]
        for (x, y), shares in zip(self.feet, self.shares):
            ux, uy = vx - spin * y, vy + spin * x
            size = mp.sqrt(ux * ux + uy * uy)
            wrench = (-ux / size, -uy / size, (y * ux - x * uy) / size)
            made = [[a + share * b for a, b in zip(part, wrench)] for part, share in zip(made, shares)]
        return made

    def speeds(self, vx, vy, spin):
        return [mp.sqrt((vx - spin * y) ** 2 + (vy + spin * x) ** 2) for x, y in self.feet]

    def scale(self, vx, vy, spin):
        """Small where a foot nearly rests: its friction turns quickly there."""
        return 1 / sum(1 / speed for speed in self.speeds(vx, vy, spin))


class Pivot:
    """A body that turns about one of its feet, which friction holds, until it rests."""

    def __init__(self, face, g, foot):
        self.face, self.g, self.foot = face, g, foot
        px, py = face.feet[foot]
        self.arm = (-px, -py)  # from the foot to the centre of mass

    def turning(self, spin):
        """Angular acceleration and whether the foot is held: torque about the foot, linear in the acceleration."""
        face, (dx, dy) = self.face, self.arm
        px, py = face.feet[self.foot]
        constant, slope, friction = 0, 0, []
        for j, ((x, y), (share, gx, gy)) in enumerate(zip(face.feet, face.shares)):
            # Load per weight: fixed + rate * acceleration.
            fixed = share + face.height / self.g * spin * spin * (gx * dx + gy * dy)
            rate = -face.height / self.g * (gy * dx - gx * dy)
            if j == self.foot:
                own = (fixed, rate)
                continue
            length = mp.sqrt((x - px) ** 2 + (y - py) ** 2)
            strength = (-1 if spin > 0 else 1) * face.mu * self.g
            constant, slope = constant + strength * length * fixed, slope + strength * length * rate
            friction.append((-(y - py) / length * strength, (x - px) / length * strength, fixed, rate))
        rate = constant / (face.gyration_sq + dx * dx + dy * dy - slope)
        fx, fy = -rate * dy - spin * spin * dx, rate * dx - spin * spin * dy
        for ux, uy, fixed, load in friction:
            fx, fy = fx - ux * (fixed + load * rate), fy - uy * (fixed + load * rate)
        limit = face.mu * self.g * (own[0] + own[1] * rate)
        return rate, fx * fx + fy * fy <= limit * limit

    def is_held(self, spin):
        """The force on the foot is a quadratic in the spin and its limit is one: both ends decide."""
        return self.turning(spin)[1] and self.turning(spin * mp.real("1e-20"))[1]

    def to_rest(self, state, way):
        """Over the spin, from now to nothing."""
        _, _, spin, x, y, angle, time = state

        def slope(here):
            rate = self.turning(here[0] if here[0] * spin > 0 else spin * mp.real("1e-30"))[0]
            return [-spin, -spin * here[0] / rate, -spin / rate]

        solver, left, here = Extrapolation(slope, *way), mp.real("1"), [spin, mp.real("0"), mp.real("0")]
        rate = abs(self.turning(spin)[0])
        while left > mp.real(END):
            here, _ = solver.step(here, left, [abs(spin), spin * spin / rate, abs(spin) / rate])
            left -= solver.taken
        dx, dy = self.arm
        for sign, a in ((-1, angle), (1, angle + here[1])):
            co, si = mp.cos(a), mp.sin(a)
            x, y = x + sign * (co * dx - si * dy), y + sign * (si * dx + co * dy)
        return [x, y, angle + here[1], time + here[2]]


class SlideOnFeet(Slide):
    """One of whose feet may come to rest before the others."""

    def end(self, state):
        vx, vy, spin, _, _, angle, _ = state
        co, si = mp.cos(angle), mp.sin(angle)
        speeds = self.face.speeds(co * vx + si * vy, co * vy - si * vx, spin)
        pivot = Pivot(self.face, self.strength / self.face.mu, speeds.index(min(speeds)))
        rests = min(speeds) < RESTS * self.way[1] * max(speeds) and pivot.is_held(spin)
        return pivot.to_rest(state, self.way) if rests else None
