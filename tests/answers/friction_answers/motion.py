"""Motions to rest, or over a time, by extrapolation."""

from . import numbers as mp

END = "1e-17"  # of the initial velocities: below it the motion is uniformly decelerated


class Extrapolation:
    """Gragg's midpoint rule with 2, 4, 6, ... sub-steps, extrapolated to none (Gragg, Bulirsch & Stoer)."""

    def __init__(self, slope, columns, tolerance):
        self.slope, self.columns, self.tolerance = slope, columns, tolerance
        self.taken = 0

    def midpoint(self, state, first, h, n):
        sub = h / n
        before, here = state, [y + sub * d for y, d in zip(state, first)]
        for _ in range(n - 1):
            before, here = here, [y + 2 * sub * d for y, d in zip(before, self.slope(here))]
        return [(b + y + sub * d) / 2 for b, y, d in zip(before, here, self.slope(here))]

    def step(self, state, h, weights):
        """The state after a step of at most h, which `taken` has, and the next step's length."""
        first = self.slope(state)
        while True:
            table = []
            for k in range(self.columns):
                row = [self.midpoint(state, first, h, 2 * (k + 1))]
                for j in range(k):
                    ratio = mp.real(str(k + 1)) ** 2 / (k - j) ** 2 - 1
                    row.append([a + (a - b) / ratio for a, b in zip(row[j], table[-1][j])])
                table.append(row)
            error = max(abs(a - b) / w for a, b, w in zip(table[-1][-1], table[-1][-2], weights))
            factor = (self.tolerance / (error + mp.real("1e-40"))) ** (mp.real("1") / (2 * self.columns - 1))
            factor = min(max(factor * 9 / 10, mp.real("0.1")), mp.real("3"))
            if error <= self.tolerance:
                self.taken = h
                return table[-1][-1], h * factor
            h *= factor


class Slide:
    """A body on a face that slides and spins: its velocity and spin relative to the ground, which moves as `ground` says.

    The time runs in units of the face's scale, in which friction changes slowly up to rest.
    """

    def __init__(self, face, strength, way):
        """`strength` is mu g, `way` the columns and the tolerance of the extrapolation."""
        self.face, self.strength, self.way = face, strength, (way[0], mp.real(way[1]))

    def acceleration(self, vx, vy, spin, angle):
        co, si = mp.cos(angle), mp.sin(angle)
        fx, fy, torque = self.face.wrench(co * vx + si * vy, co * vy - si * vx, spin)
        k = self.strength
        return k * (co * fx - si * fy), k * (si * fx + co * fy), k * torque / self.face.gyration_sq

    def slope(self, state):
        vx, vy, spin, _, _, angle, _ = state
        co, si = mp.cos(angle), mp.sin(angle)
        scale = self.face.scale(co * vx + si * vy, co * vy - si * vx, spin)
        return [scale * d for d in (*self.acceleration(vx, vy, spin, angle), vx, vy, spin, 1)]

    def size(self, state):
        vx, vy, spin = state[:3]
        return mp.sqrt(vx * vx + vy * vy + self.face.gyration_sq * spin * spin)

    def end(self, _):
        """Displacement, angle and time until rest, where the rest of the motion is another one."""

    def to_rest(self, speed, spin):
        """Displacement along and to the left, angle and time until rest."""
        zero = mp.real("0")
        state = [speed, zero, spin, zero, zero, zero, zero]
        start = self.size(state)
        time = start / self.strength
        arm = mp.sqrt(self.face.gyration_sq)
        units = [time * start, time * start, time * start / arm, time]
        solver = Extrapolation(self.slope, *self.way)
        h = mp.real("0.01") / self.strength
        while self.size(state) > mp.real(END) * start:
            size = self.size(state)
            state, h = solver.step(state, h, [size, size, size / arm, *units])
            early = self.end(state)
            if early:
                return early
        ax, ay, turn = self.acceleration(*state[:3], state[5])
        slowing = -(state[0] * ax + state[1] * ay + self.face.gyration_sq * state[2] * turn) / self.size(state)
        return [*state[3:6], state[6] + self.size(state) / slowing]


def over(slope, state, seconds, units, way, first=None):
    """The state after a time of an autonomous smooth motion."""
    solver = Extrapolation(slope, way[0], mp.real(way[1]))
    left, h = seconds, first or seconds / 50
    while left > 0:
        state, h_next = solver.step(state, min(h, left), units)
        left -= solver.taken
        h = h_next
    return state


def root(function, low, high):
    """Zero of a function between two places of different signs, to the last digits (bisection, then secants)."""
    f_low = function(low)
    for _ in range(10):
        middle = (low + high) / 2
        f = function(middle)
        if (f < 0) == (f_low < 0):
            low, f_low = middle, f
        else:
            high = middle
    a, b, fa, fb = low, high, function(low), function(high)
    for _ in range(12):
        if fa == fb:
            break
        a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
        fb = function(b)
    return b
