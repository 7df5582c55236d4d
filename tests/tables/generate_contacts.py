#!/usr/bin/env python3
"""Reference impulses of one contact between two spheres.

    python3 generate_contacts.py make

writes contacts.csv next to this script (half a minute).  Needs Python 3.11+, mpmath 1.3.

Nothing here knows effective masses, couplings or cases.  The bodies take up trial impulses by Newton's laws at the contact
point, their relative velocity is measured, and the impulse is what obeys the laws: along the normal the one of all candidates
that contradicts nothing; across it the limit of projected descent on the work of the impulses, with steps of half of what
would stop one motion alone; for the coupled set the nearest of the points of the limit surface, by golden section.
"""
import random
import sys

import mpmath as mp
from mpmath import mpf

from generate_pressures import family, write

DPS = 60
MOST_STEPS = 20000
DIGITS = 20


def vec(*x):
    return mp.matrix([mpf(c) for c in x])


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), mpf(0))


def cross(a, b):
    return vec(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def shortened(q, bound):
    size = mp.sqrt(dot(q, q))
    return q if size <= bound else q * (bound / size)


class Contact:
    def __init__(self, c):
        self.c = c
        d = vec(*c["d"])
        distance = mp.sqrt(dot(d, d))
        self.n = d / distance
        self.gap = distance - c["r"][0] - c["r"][1]
        reach = mpf(c["r"][0]) + c["r"][1]
        # The contact point divides the distance as the radii do.
        self.place = [self.n * (distance * c["r"][0] / reach), -self.n * (distance * c["r"][1] / reach)]
        self.r_eff = 1 / (1 / mpf(c["r"][0]) + 1 / mpf(c["r"][1]))

    def velocities(self, force, torque):
        """Normal, sliding, rolling and torsion velocity after an impulse on the second body."""
        c, points, spins = self.c, [], []
        for body, sign in ((0, -1), (1, 1)):
            v = vec(*c["v"][body]) + force * (sign * mpf(c["im"][body]))
            w = vec(*c["w"][body]) + (cross(self.place[body], force) + torque) * (sign * mpf(c["ii"][body]))
            points.append(v + cross(w, self.place[body]))
            spins.append(w)
        slip, turn = points[1] - points[0], spins[1] - spins[0]
        u, spin = dot(slip, self.n), dot(turn, self.n)
        return u, slip - self.n * u, turn - self.n * spin, spin

    def normal(self):
        c, zero = self.c, vec(0, 0, 0)
        u0 = self.velocities(zero, zero)[0]
        rate = self.velocities(self.n, zero)[0] - u0
        strength = mpf(c["strength"]) * c["dt"] if self.gap <= c["range"] else mpf(0)
        opening = max(self.gap, mpf(0)) / c["dt"]
        rebounds = c["e"] > 0 and u0 + opening < 0
        allowance = c["e"] * u0 if rebounds else opening
        # (impulse, velocity): closed, saturated; for a resistance at an open gap also standing still, and free.
        closed, still = (-allowance - u0) / rate, -u0 / rate
        candidates = [(closed, "closed")] if closed >= -strength else []
        if u0 - strength * rate > -allowance:
            candidates.append((-strength, "saturated"))
        if c["attraction"] == "resistance" and self.gap > 0 and not rebounds:
            candidates = [(closed, "closed")] if closed >= 0 else []
            if still < 0 and still > -strength:
                candidates.append((still, "held"))
            if still >= 0 and closed < 0:
                candidates.append((mpf(0), "free"))
            if still <= -strength:
                candidates.append((-strength, "saturated"))
        assert len(candidates) == 1, candidates
        return candidates[0] + (candidates[0][0] + strength,)

    def responses(self):
        """Velocity of each mode per impulse of its own."""
        zero = vec(0, 0, 0)
        axis = cross(self.n, vec(1, 0, 0) if abs(self.n[0]) < 0.9 else vec(0, 1, 0))
        axis = axis / mp.sqrt(dot(axis, axis))
        rest, pushed, turned = (self.velocities(*x) for x in ((zero, zero), (axis, zero), (zero, axis)))
        return dot(pushed[1] - rest[1], axis), dot(turned[2] - rest[2], axis)

    def thresholds(self):
        c = self.c
        r, branch, p = self.normal()
        limits = [c["mu"] * p, c["mu_t"] * p * self.r_eff, c["mu_n"] * p * self.r_eff]
        slide, turn = self.responses()
        force, torque, torsion = vec(0, 0, 0), vec(0, 0, 0), mpf(0)
        for _ in range(MOST_STEPS):
            _, slip, roll, spin = self.velocities(self.n * r + force, torque + self.n * torsion)
            before = force.copy(), torque.copy(), torsion
            force = shortened(force - slip / (2 * slide), limits[0])
            torque = shortened(torque - roll / (2 * turn), limits[1])
            torsion = max(min(torsion - spin / (2 * turn), limits[2]), -limits[2])
            moved = [dot(force - before[0], force - before[0]), dot(torque - before[1], torque - before[1]),
                     (torsion - before[2]) ** 2]
            if max(moved) < mpf(10) ** (-2 * DIGITS - 16):
                break
        else:
            raise RuntimeError("no convergence")
        sizes = [mp.sqrt(dot(force, force)), mp.sqrt(dot(torque, torque)), abs(torsion)]
        slips = "".join("-s"[size > limit * (1 - mpf(10) ** -18)] for size, limit in zip(sizes, limits))
        return r, force, torque, torsion, f"{branch} {slips}"

    def coupled(self):
        """As above with the exact set of a disk of radius mu_n r_eff, and without rolling."""
        c, zero = self.c, vec(0, 0, 0)
        r, branch, p = self.normal()
        radius = mpf(c["mu_n"]) * self.r_eff
        slide, turn = self.responses()
        _, slip, _, spin = self.velocities(self.n * r, zero)
        push, torque = slip / -slide, spin / -turn
        f, t = mp.sqrt(dot(push, push)), abs(torque)

        def point(angle):
            v, w = mp.cos(angle), mp.sin(angle)
            eps = v / w if w > 0 else mp.inf
            big_f, big_t = (mpf(1), mpf(0)) if eps == mp.inf else family(0, 0, eps)[:2]
            return big_f * c["mu"] * p, big_t * c["mu"] * p * radius, v, w / radius

        def beyond(angle):
            force, moment, v, w = point(angle)
            return -((f - force) * v + (t - moment) * w) / mp.hypot(v, w * radius)

        def distance(angle):
            force, moment, _, _ = point(angle)
            return (f - force) ** 2 * slide + (t - moment) ** 2 * turn

        if p == 0 or beyond(golden(beyond)) > 0:
            held = (zero, mpf(0)) if p == 0 else (push, torque)
            return r, held[0], zero, held[1], f"{branch} --"
        force, moment, _, _ = point(golden(distance))
        return r, push * (force / f), zero, mp.sign(torque) * moment, f"{branch} ss"


def golden(function):
    """The lowest point on [0, pi/2]."""
    share = (mp.sqrt(5) - 1) / 2
    low, high = mpf(0), mp.pi / 2
    left, right = high - share * (high - low), low + share * (high - low)
    at_left, at_right = function(left), function(right)
    while high - low > mpf(10) ** -(DIGITS + 6):
        if at_left < at_right:
            high, right, at_right = right, left, at_left
            left = high - share * (high - low)
            at_left = function(left)
        else:
            low, left, at_left = left, right, at_right
            right = low + share * (high - low)
            at_right = function(right)
    return (low + high) / 2


def cases():
    rng = random.Random(4)

    def dyadic(low, high):
        return round(rng.uniform(low, high) * 1024) / 1024

    def three(size):
        return [dyadic(-size, size) for _ in range(3)]

    for number in range(96):
        kind = "coupled" if number % 4 == 3 else "thresholds"
        r = [dyadic(0.25, 2), dyadic(0.25, 2) if number % 8 else 0.001953125]
        d = three(1)
        size = (sum(x * x for x in d)) ** 0.5
        gap = [0, 0.005, -0.01, 0.02][rng.randrange(4)]
        d = [x / size * (r[0] + r[1] + gap) for x in d]
        im = [round(1 / (4 * x ** 3) * 1024) / 1024 + 2 ** -10 for x in r]
        ii = [2.5 * m / x ** 2 for m, x in zip(im, r)]
        # Saturation wants a strong pull; everything else goes together.
        weak = rng.random() < 0.5
        yield {
            "kind": kind, "attraction": ["pull", "resistance"][rng.randrange(2)], "r": r, "d": d, "im": im, "ii": ii,
            "v": [three(1), three(1)], "w": [three(2), three(2)], "dt": [0.015625, 0.25][rng.randrange(2)],
            "strength": dyadic(0, 1) if weak else dyadic(8, 64), "range": 0.0078125, "e": [0, 0, 0.5][rng.randrange(3)],
            "mu": 2.0 ** rng.randrange(-4, 3), "mu_t": 2.0 ** rng.randrange(-5, 3), "mu_n": 2.0 ** rng.randrange(-4, 1),
        }


PAIRED = ["r", "im", "ii"]
SINGLE = ["dt", "strength", "range", "e", "mu", "mu_t", "mu_n"]
COLUMNS = (["kind", "attraction", "case"] + [f"{x}{i}" for x in PAIRED for i in "12"] + ["dx", "dy", "dz"]
           + [f"{x}{i}{a}" for x in "vw" for i in "12" for a in "xyz"] + SINGLE
           + ["n", "fx", "fy", "fz", "tx", "ty", "tz", "torsion"])


def make():
    rows = []
    for c in cases():
        contact = Contact(c)
        r, force, torque, torsion, case = getattr(contact, c["kind"])()
        numbers = [c[x][i] for x in PAIRED for i in (0, 1)] + c["d"] + [x for v in c["v"] + c["w"] for x in v]
        numbers = [repr(float(x)) for x in numbers + [c[x] for x in SINGLE]]
        found = [mp.nstr(x, DIGITS) for x in [r, *force, *torque, torsion]]
        rows.append([c["kind"], c["attraction"], case] + numbers + found)
    write("contacts.csv", "impulses on the second of two spheres; mu_n of a coupled row is R_c/r_eff, its set the exact "
          "one of the uniform disk; case: branch of the normal law, then slipping (s) or not of sliding, rolling, torsion",
          COLUMNS, rows, script="generate_contacts.py")


if __name__ == "__main__":
    if sys.argv[1:2] != ["make"]:
        sys.exit(__doc__)
    mp.mp.dps = DPS
    make()
