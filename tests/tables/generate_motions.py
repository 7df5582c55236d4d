#!/usr/bin/env python3
"""Reference motions to rest and modes of bodies whose contact pressure is not uniform.

    python3 generate_motions.py make [--only tilted_cylinder ring_stops modes_pressure]

writes the CSV files next to this script; check_motions.py repeats the motions with an ODE solver.  Needs
Python 3.11+, mpmath 1.3.

Straight or curved, the motion reduces to integrals.  With v = s cos a, w = omega R = s sin a and
dtau = s^(alpha-1) dt (units mu g = R = 1) the angle a is autonomous, monotone, and tends to a zero a0 of g:
    d(ln s)/dtau = -f(a),  da/dtau = g(a),  d(heading)/dtau = -P(a)/cos a,
    f = F cos a + T sin a / C,  g = F sin a - T cos a / C,   P = lateral force, to the right.
Gauss-Legendre panels over a are halved towards a0 and towards v = w, where F and T are not smooth.  Close
enough to a0 everything is an exponential of tau, and the rest is added in closed form: the heading has no
limit when P(a0) > 0, a logarithmic spiral.
"""
import argparse

import mpmath as mp
from mpmath import mpf

from generate import Rule, deviation, read
from generate_pressures import family, write

DPS = 60
HALVINGS = 80                           # panels down to 2^-80 from a0 and from v = w
NODES = (26, 20)                        # the finer rule is written, the coarser one measures it

# ---------------------------------------------------------------- forces at v = cos a, w = sin a: F, P, T


def straight_force(q, alpha):
    """The family p_q, no lateral force."""
    quick = COULOMB.get(q) if alpha == 0 else None

    def force(a):
        co, si = max(mp.cos(a), mpf(0)), mp.sin(a)
        eps = co / si
        eps = mpf(1) if abs(eps - 1) < mpf(10) ** -45 else eps          # elliptic integrals are poor that close
        f, t = quick(eps) if quick else family(q, alpha, eps)[:2]
        return si ** alpha * f, mpf(0), si ** alpha * t
    return force


def coulomb_ring(eps):
    """F, T of the thin ring at alpha = 0: T(eps) = F(1/eps)."""
    m = min(eps, 1 / eps) ** 2
    if m == 1:
        return 2 / mp.pi, 2 / mp.pi
    k, e = mp.ellipk(m), mp.ellipe(m)
    if m == 0:
        return mpf(0), mpf(1)
    b, d = (e - (1 - m) * k) / m, (k - e) / m
    slow, fast = 2 / mp.pi * mp.sqrt(m) * b, 2 / mp.pi * (b + (1 - m) * d)
    return (slow, fast) if eps <= 1 else (fast, slow)


def coulomb_punch(eps):
    """F, T of the flat punch at alpha = 0."""
    if eps <= 1:
        return mp.pi / 4 * eps, mp.pi / 4 * (1 - eps ** 2 / 2)
    a, w = mp.asin(1 / eps), mp.sqrt(eps * eps - 1)
    return (eps * a + w / eps) / 2, (mpf(1) / 2 - eps ** 2 / 4) * a + w / 4


def coulomb_hertz(eps):
    """F, T under Hertz pressure at alpha = 0."""
    x = eps * eps
    if eps <= 1:
        return 3 * mp.pi / 8 * eps * (1 - x / 4), 3 * mp.pi / 16 * (1 - x + 3 * x * x / 8)
    a, w = mp.asin(1 / eps), mp.sqrt(x - 1)
    return (mpf(3) / 4 * eps * (1 - x / 4) * a + w * (mpf(3) / 8 / eps + 3 * eps / 16),
            (24 - 24 * x + 9 * x * x) / 64 * a + w * (18 - 9 * x) / 64)


COULOMB = {-1: coulomb_ring, -0.5: coulomb_punch, 0.5: coulomb_hertz}      # closed forms, quicker than 2F1


def coulomb_disk(eps):
    """F, T, G, eps G' of the uniform disk at alpha = 0, by elliptic integrals."""
    m = min(eps, 1 / eps) ** 2
    if m == 1:
        return 8 / (3 * mp.pi), 8 / (9 * mp.pi), 32 / (45 * mp.pi), -8 / (15 * mp.pi)
    k, e = mp.ellipk(m), mp.ellipe(m)
    b, d, n = (e - (1 - m) * k) / m, (k - e) / m, 1 - m
    db, dd_n = (d - b) / (2 * m), (b - n * d) / (2 * m)            # dB/dm, (1-m) dD/dm
    c = 4 / mp.pi
    if eps <= 1:
        f = c / 3 * eps * (2 * b + n * d)
        t = c / 9 * ((3 - m) * b + n * (3 - 2 * m) * d)
        g = c / 45 * ((9 - m) * b + 2 * n * (3 - m) * d)
        dg = c / 45 * (-b + (9 - m) * db + 2 * (2 * m - 4) * d + 2 * (3 - m) * dd_n)
        return f, t, g, 2 * m * dg
    f = c / 3 * (2 * b + n * d)
    t = c / 9 * eps * ((3 * m - 1) * b + n * d)
    inner = (9 * m - 1) * b + n * (1 + 3 * m) * d
    slope = 9 * b + (9 * m - 1) * db + (2 - 6 * m) * d + (1 + 3 * m) * dd_n
    return f, t, c / 45 * eps * inner, c / 45 * eps * (inner - 2 * m * slope)


def tilted_force(variant, kappa):
    """Uniform disk, Coulomb, under a tall body, kappa = 2 mu H/R: the pressure leans against the friction."""
    def force(a):
        f, t, g, eg = coulomb_disk(mp.cot(a))
        if variant == "front-back":
            return f, kappa * f * g, t
        along = f / (1 + kappa ** 2 * g * (g + eg))
        right = kappa * g * along
        return along, right, t + kappa * right * eg * mp.cot(a)
    return force


# ---------------------------------------------------------------- motion to rest


def all_panels(start, a0):
    """Panels from start to next to a0, none longer than its distance to where the integrands are singular."""
    rim = mp.pi / 4
    singular = {mpf(0), rim, mp.pi / 2, a0}

    def split(lo, hi):
        length = abs(hi - lo)
        if length < mpf(2) ** -HALVINGS:
            return [] if a0 in (lo, hi) else [(lo, hi)]
        gap = min(0 if (lo - p) * (hi - p) <= 0 else min(abs(lo - p), abs(hi - p)) for p in singular)
        if length <= gap:
            return [(lo, hi)]
        middle = (lo + hi) / 2
        return split(lo, middle) + split(middle, hi)

    cuts = [start] + [rim] * ((start - rim) * (a0 - rim) < 0) + [a0]
    return [panel for lo, hi in zip(cuts, cuts[1:]) for panel in split(lo, hi)]


class Motion:
    """Running totals along the path; `position` is complex, x + i y."""

    def __init__(self, force, c, alpha, v0, w0, rule):
        self.force, self.c, self.alpha, self.rule = force, mpf(c), mpf(alpha), rule
        self.ln_s, self.heading = mp.log(mp.hypot(mpf(v0), mpf(w0))), mpf(0)
        self.time, self.position, self.angle = mpf(0), mp.mpc(0), mpf(0)

    def rates(self, a):
        """f, g, heading rate."""
        co, si = mp.cos(a), mp.sin(a)
        along, right, torque = self.force(a)
        turn = right / co if right else mpf(0)
        return along * co + torque * si / self.c, along * si - torque * co / self.c, -turn

    def over(self, lo, hi):
        """What one panel adds: ln s, heading, time, position, angle."""
        half, mid = (hi - lo) / 2, (hi + lo) / 2
        at = [mid + half * x for x in self.rule.nodes]
        f, g, turn = zip(*(self.rates(a) for a in at))
        fade, bend = [-x / y for x, y in zip(f, g)], [x / y for x, y in zip(turn, g)]
        bent = any(turn)
        time, position, angle = mpf(0), mp.mpc(0), mpf(0)
        for i, a in enumerate(at):
            ln_s = self.ln_s + half * mp.fdot(self.rule.running[i], fade)
            psi = self.heading + half * mp.fdot(self.rule.running[i], bend) if bent else self.heading
            dt = self.rule.weights[i] * half / g[i] * mp.exp((1 - self.alpha) * ln_s)
            time += dt
            position += dt * mp.exp(ln_s) * mp.cos(a) * (mp.expj(psi) if bent else 1)
            angle += dt * mp.exp(ln_s) * mp.sin(a)
        total = half * mp.fdot(self.rule.weights, bend) if bent else mpf(0)
        return half * mp.fdot(self.rule.weights, fade), total, time, position, angle

    def advance(self, lo, hi):
        """Goes from angle lo to hi."""
        step = self.over(lo, hi)
        self.ln_s, self.heading = self.ln_s + step[0], self.heading + step[1]
        self.time, self.position, self.angle = self.time + step[2], self.position + step[3], self.angle + step[4]

    def settle(self, a0):
        """Closes the rest of the motion at constant a0."""
        f, _, turn = self.rates(a0)
        p = 1 - self.alpha
        self.time += mp.exp(p * self.ln_s) / (p * f)
        s2 = mp.exp((p + 1) * self.ln_s)
        self.position += s2 * mp.cos(a0) * mp.expj(self.heading) / ((p + 1) * f - mp.j * turn)
        self.angle += s2 * mp.sin(a0) / ((p + 1) * f)
        return turn / f                              # the heading turns by this per e-fold of s at the end


def settled_angle(force, c, bounds):
    """The stable zero of g for alpha < 1; bounds = C of the change to pure spinning, to pure sliding."""
    if c >= bounds[0]:
        return mp.pi / 2
    if c <= bounds[1]:
        return mpf(0)

    def g(a):
        along, _, torque = force(a)
        return along * mp.sin(a) - torque * mp.cos(a) / c

    if abs(g(mp.pi / 4)) < mpf(10) ** -50:
        return mp.pi / 4
    return mp.findroot(g, (mpf("0.02"), mp.pi / 2 - mpf("0.02")), solver="anderson",
                       tol=mpf(10) ** (10 - 2 * mp.mp.dps), maxsteps=200)


def heading_at(motion, lo, hi, ln_v):
    """Heading at the angle between lo and hi where the sliding speed is exp(ln_v)."""
    a = mp.findroot(lambda b: motion.ln_s + motion.over(lo, b)[0] + mp.log(mp.cos(b)) - ln_v,
                    (lo, hi), solver="anderson", tol=mpf(10) ** -70)
    return motion.heading + motion.over(lo, a)[1]


RULES = {}


def to_rest(force, c, alpha, v0, w0, bounds, nodes, percent=None):
    """The finished Motion, v/w at the end, heading where v = v0/100 (if asked), heading per e-fold at the end."""
    rule = RULES.setdefault(nodes, None) or RULES.__setitem__(nodes, Rule(nodes)) or RULES[nodes]
    motion, start = Motion(force, c, alpha, v0, w0, rule), mp.atan2(mpf(w0), mpf(v0))
    a0, marked = settled_angle(force, mpf(c), bounds), None
    if abs(start - a0) > mpf(10) ** -40:
        target = mp.log(mpf(v0) / 100)
        for lo, hi in all_panels(start, a0):
            if percent and marked is None:
                after = motion.ln_s + motion.over(lo, hi)[0] + mp.log(mp.cos(hi))
                marked = heading_at(motion, lo, hi, target) if after < target else None
            motion.advance(lo, hi)
    fold = motion.settle(a0)
    ratio = mp.inf if a0 == 0 else mpf(0) if a0 == mp.pi / 2 else mp.cot(a0)
    return motion, ratio, marked, fold


# ---------------------------------------------------------------- tilted cylinder

GRAVITY, RADIUS = 9.81, 0.08
CYLINDERS = [(0.2, 2.0, 1.0, 5.0), (0.2, 2.0, 1.0, 12.5), (0.2, 2.0, 1.0, 50.0),
             (0.3, 0.25, 1.0, 5.0), (0.3, 0.25, 1.0, 12.5), (0.3, 0.25, 1.0, 50.0),
             (0.2, 2.0, 0.1, 500.0), (0.3, 2.5, 0.1, 500.0)]          # mu, H/R, v0 m/s, spin0 rad/s
CYLINDER_COLUMNS = ["variant", "mu", "g", "R", "H_over_R", "v0", "spin0", "t_stop", "x", "y", "angle", "ratio_end",
                    "heading_percent", "heading_fold"]


def cylinder(variant, mu, height, v0, spin0, nodes):
    """t, x, y, angle in SI, final v/(omega R), heading at v0/100, heading per e-fold of speed at the end."""
    mu, height, r = mpf(mu), mpf(height), mpf(RADIUS)
    force = tilted_force(variant, 2 * mu * height)
    motion, ratio, marked, fold = to_rest(force, mpf(1) / 2, 0, v0, mpf(spin0) * r,
                                          (mp.inf, -mp.inf), nodes, percent=True)
    rate = mu * mpf(GRAVITY)
    return (motion.time / rate, motion.position.real / rate, motion.position.imag / rate,
            motion.angle / rate / r, ratio, marked, fold)


def measured(label, function, *args):
    """The finer result; prints its difference from the coarser rule."""
    with mp.workdps(DPS):
        fine, coarse = (function(*args, nodes) for nodes in NODES)
        worst = max(deviation(a, b) for a, b in zip(coarse, fine) if mp.isfinite(b))
        print(" ", label, [mp.nstr(x, 17) for x in fine], "coarser rule differs by", mp.nstr(worst, 2), flush=True)
        return [mp.nstr(x, 20) if mp.isfinite(x) else "inf" for x in fine]


def make_tilted_cylinder():
    rows = []
    for variant in ("front-back", "full"):
        for case in CYLINDERS:
            result = measured((variant, *case), cylinder, variant, *case)
            mu, height, v0, spin0 = case
            rows.append([variant] + [repr(x) for x in (mu, GRAVITY, RADIUS, height, v0, spin0)] + result)
    write("tilted_cylinder.csv", "tall solid cylinder (C = 1/2) sliding along +x and spinning counterclockwise, Coulomb "
          "friction, upright, to rest, SI; heading_percent = direction of motion (rad) when v = v0/100, heading_fold "
          "= limit of d(heading)/d(-ln speed); 20 digits", CYLINDER_COLUMNS, rows, script="generate_motions.py")


# ---------------------------------------------------------------- straight stops

LAUNCHES = [(1.0, 0.4), (1.0, 4.0), (0.01, 1.0)]
BODIES = [("ring", -1.0, 0.0, 1.0), ("hertz", 0.5, 0.0, 0.4), ("punch", -0.5, 0.0, 0.5),
          ("paraboloid", 1.0, 0.0, 0.5), ("ring", -1.0, -0.5, 2.69)]


def bounds(q, alpha):
    """C where the finite mode meets pure spinning, pure sliding."""
    s, q = mpf(alpha) + 1, mpf(q)
    return 1 / (s / 2 + 1 + q), s / (2 * (q + 2))


def straight(q, alpha, c, v0, w0, nodes):
    """Stop time, distance, angle, final ratio."""
    motion, ratio, _, _ = to_rest(straight_force(mpf(q), mpf(alpha)), c, alpha, v0, w0, bounds(q, alpha), nodes)
    return motion.time, motion.position.real, motion.angle, ratio


def make_ring_stops():
    rows = []
    for _, q, alpha, c in BODIES:
        for v0, w0 in LAUNCHES:
            rows.append([repr(x) for x in (q, alpha, c, v0, w0)]
                        + measured((q, alpha, c, v0, w0), straight, q, alpha, c, v0, w0))
    write("ring_stops.csv", "body with pressure ~ (1-r^2)^q (q = -1: thin ring), dv/dt=-F(v,w), dw/dt=-T(v,w)/C, "
          "C = inertia_ratio = I/(M R^2), w = omega R: stop time, distance = int v dt, angle = int w dt, final v/w, "
          "dimensionless (R = mu g = 1), 20 digits",
          ["q", "alpha", "inertia_ratio", "v0", "w0", "stop_time", "distance", "angle", "final_ratio"], rows,
          script="generate_motions.py")


# ---------------------------------------------------------------- modes

MODE_Q = [-1.0, -0.5, 0.5, 1.0]
MODE_ALPHA = [-0.9, -0.5, -0.19, 0.0, 0.5, 0.9, 2.0, 3.0]
MODE_C = [0.3, 0.5, 0.8, 1.0, 1.5, 2.69]


def mode(q, alpha, c):
    """eps0 with C F = eps T, from ln eps between far limits; None outside the bounds."""
    ends = bounds(q, alpha)
    if not min(ends) < mpf(c) < max(ends):
        return None

    def excess(x):
        e = mp.exp(x)
        f, t = family(q, alpha, e)[:2]
        return e * t / f - c

    if abs(excess(mpf(0))) < mpf(10) ** -40:
        return mpf(1)
    side = excess(mpf(0)) * excess(mpf(30)) < 0
    near = (mpf(0), mpf(30)) if side else (mpf(-30), mpf(0))
    return mp.exp(mp.findroot(excess, near, solver="anderson", tol=mpf(10) ** -90, maxsteps=400))


def make_modes_pressure():
    rows = []
    for q in MODE_Q:
        for alpha in MODE_ALPHA:
            for c in MODE_C:
                with mp.workdps(DPS):
                    root, ends = mode(q, alpha, c), bounds(q, alpha)
                rows.append([repr(x) for x in (q, alpha, c)] + [mp.nstr(x, 25) for x in ends]
                            + ["" if root is None else mp.nstr(root, 25)])
    write("modes_pressure.csv", "ratio eps0 = v/w that stays constant for inertia ratio C = I/(M R^2), pressure "
          "~ (1-r^2)^q (q = -1: thin ring); blank outside the bounds c_spinning = C(eps -> 0), c_sliding = "
          "C(eps -> inf); stable for alpha < 1, unstable beyond; dimensionless, 25 digits",
          ["q", "alpha", "C", "c_spinning", "c_sliding", "eps0"], rows, script="generate_motions.py")


NAMES = ["tilted_cylinder", "ring_stops", "modes_pressure"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=("make",))
    parser.add_argument("--only", nargs="+", choices=NAMES, default=NAMES)
    args = parser.parse_args()
    for name in args.only:
        globals()[f"make_{name}"]()


if __name__ == "__main__":
    main()
