"""Exact answers of the problems, in the numbers in use: doubles, or more digits with `numbers.use_digits`.

Each function takes a case and the columns and tolerance of an integrator, and gives quantities by name.
"""

from . import numbers as mp
from .faces import BarFace, PolygonFace, RoundFace, with_load_below
from .items import THROWN
from .motion import Slide, over, root
from .standing import Feet, SlideOnFeet, TallFace

DOUBLE = (7, "1e-13")


def number(case, *keys):
    """Parameters as numbers in use: their shortest decimals."""
    return [mp.real(repr(case[key])) for key in keys]


def face_of(case):
    """The face of a thrown body."""
    if "end_1_x" in case:
        return BarFace(*number(case, "end_1_x"))
    if "corner_1_x" in case:
        corners = [tuple(number(case, f"corner_{i}_x", f"corner_{i}_y")) for i in (1, 2, 3, 4)]
        if "offset_x" not in case:
            return PolygonFace(corners)
        ox, oy = number(case, "offset_x", "offset_y")
        uniform = PolygonFace(corners).gyration_sq
        return with_load_below([(x - ox, y - oy) for x, y in corners], uniform)
    if "foot_1_x" in case:
        feet = [tuple(number(case, f"foot_{i}_x", f"foot_{i}_y")) for i in (1, 2, 3)]
        return Feet(*number(case, "mu", "height"), feet, *number(case, "gyration_sq"))
    if case["height"]:
        return TallFace(*number(case, "mu", "height", "radius", "gyration_sq"))
    return RoundFace(*number(case, "radius", "gyration_sq"), is_ring=case.get("is_ring", False))


def thrown(case, way):
    mu, g, speed, spin = number(case, "mu", "g", "speed", "spin")
    if case["spin"] == 0 and "offset_x" not in case:
        zero = mp.real("0")
        return {"along_m": speed**2 / (2 * mu * g), "left_m": zero, "turn_rad": zero, "stop_s": speed / (mu * g)}
    face = face_of(case)
    along, left, turn, stop = (SlideOnFeet if "foot_1_x" in case else Slide)(face, mu * g, way).to_rest(speed, spin)
    return {"along_m": along, "left_m": left, "turn_rad": turn, "stop_s": stop}


def spun(slowing, spin):
    return {"turn_rad": spin * abs(spin) / (2 * slowing), "stop_s": abs(spin) / slowing}


def disk_spins(case, _):
    """Torque 2/3 mu m g R."""
    mu, g, r, k, spin = number(case, "mu", "g", "radius", "gyration_sq", "spin")
    return spun(2 * mu * g * r / 3 / k, spin)


def wheel(case, _):
    """Uniform load on a line of length L that turns about its middle: torque mu m g L/4."""
    mu, g, r, half, spin = number(case, "mu", "g", "radius", "half_width", "spin")
    return spun(mu * g * half / 2 / ((3 * r * r + 4 * half * half) / 12), spin)


def torsion(case, _):
    """Torque c m g on a ball."""
    c, g, r, spin = number(case, "torsion", "g", "radius", "spin")
    return spun(c * g / (2 * r * r / 5), spin)


def rolls(case, _):
    """A ball slides until v = w r, and rolls from there with 5/7 v + 2/7 w r (Euler)."""
    mu, g, r, v, w = number(case, "mu", "g", "radius", "speed", "spin")
    slip = v - w * r
    time = 2 * abs(slip) / (7 * mu * g)
    end = (5 * v + 2 * w * r) / 7
    return {"rolling_speed_m_s": end, "along_m": (v + end) / 2 * time + end * time, "slide_s": time}


def slope(case, _):
    """Rest, or uniform acceleration."""
    mu, g, angle, time = number(case, "mu", "g", "angle", "seconds")
    pull = g * (mp.sin(angle) - mu * mp.cos(angle))
    if pull <= 0:
        return {"creep_m_s": mp.real("0")}
    return {"along_m": pull * time * time / 2}


def vibration(case, _):
    """Sticking and slipping under the pull g sin + a sin(w t), from event to event.

    While it slips down, the velocity has the integral of pull - mu g cos in closed form; roots of it are found to all digits.
    """
    mu, g, angle, a, frequency, end = number(case, "mu", "g", "angle", "swing", "frequency", "seconds")
    w = 4 * mp.asin(mp.real("1")) * frequency
    steady, held = g * mp.sin(angle), mu * g * mp.cos(angle)
    if steady + a <= held and a - steady <= held:
        return {"creep_m_s": mp.real("0")}
    place, period = mp.real("0"), 1 / frequency

    def starts(way):
        """Phase, in time, at which the pull first exceeds friction that way, if it does."""
        sine = (way * held - steady) / a
        if abs(sine) >= 1:
            return None
        first = mp.asin(sine) / w if way > 0 else (period / 2 - mp.asin(sine) / w) % period
        return first % period

    moment = mp.real("0")
    while True:
        ways = [(moment + (phase - moment) % period, way) for way in (1, -1) if (phase := starts(way)) is not None]
        begin, way = min(ways)
        if begin >= end:
            break
        # v(t) = (steady - way held)(t - begin) - a/w (cos w t - cos w begin)
        drift = steady - way * held

        def speed(t, begin=begin, drift=drift):
            return drift * (t - begin) - a / w * (mp.cos(w * t) - mp.cos(w * begin))

        def moved(t, begin=begin, drift=drift):
            s = t - begin
            return drift * s * s / 2 - a / w * ((mp.sin(w * t) - mp.sin(w * begin)) / w - mp.cos(w * begin) * s)

        # It slips until the speed is nothing again: past the moment at which the pull falls to friction.
        low = begin + ((period / 2 - 2 * ((begin + period / 4) % period - period / 4)) % period if way > 0 else period / 8)
        high = low
        while speed(high) * way > 0 and high < end:
            low, high = high, high + period / 64
        if high >= end and speed(end) * way > 0:
            place = place + moved(end)
            break
        stop = root(speed, low, high)
        place = place + moved(min(stop, end))
        moment = stop
        if stop >= end:
            break
        # At once the other way, if the pull is that strong.
        pull = steady + a * mp.sin(w * stop)
        if abs(pull) > held:
            raise NotImplementedError("it slips both ways without a rest")
    return {"along_m": place}


def tower(_, __):
    return {"sink_m": mp.real("0"), "creep_m_s": mp.real("0")}


def held(_, __):
    return {"creep_m_s": mp.real("0")}


def stack(case, _):
    """The lower block is slowed by 3 mu g and the upper one sped up by mu g until they go together."""
    mu, g, v = number(case, "mu", "g", "speed")
    time = v / (4 * mu * g)
    both = v / 4
    together = both * both / (2 * mu * g)
    return {"lower_m": (v + both) / 2 * time + together, "upper_m": both / 2 * time + together}


def skate(case, way):
    """Friction of largest dissipation in the ellipse mu1, mu2: v2 = c v1^k with k = (mu2/mu1)^2, and quadrature over v1.

    With u = v1/v01 the deceleration of v1 is g mu1^2 u v01/s, s = sqrt((mu1 v1)^2 + (mu2 v2)^2): dx = -v1 s du/(g mu1^2 u).
    """
    m1, m2, g, v, direction = number(case, "mu", "mu_across", "g", "speed", "direction")
    v1, v2, k = v * mp.cos(direction), v * mp.sin(direction), (m2 / m1) ** 2

    def slopes(state):
        u = state[0]
        across = v2 * power(u, k)
        s = mp.sqrt((m1 * v1 * u) ** 2 + (m2 * across) ** 2)
        rate = -s / (g * m1 * m1)
        return [mp.real("-1"), -v1 * rate, -across / u * rate]

    size = v * v / (g * m1)
    u, along, left = over(slopes, [mp.real("1"), mp.real("0"), mp.real("0")], 1 - mp.real("1e-13"), [1, size, size], way)
    # The rest goes straight along x.
    return {"along_m": along + (v1 * u) ** 2 / (2 * m1 * g), "left_m": left}


def oblique(case, _):
    """Friction knows no direction."""
    mu, g, v, direction = number(case, "mu", "g", "speed", "direction")
    way = v * v / (2 * mu * g)
    return {"along_m": way * mp.cos(direction), "left_m": way * mp.sin(direction)}


def power(x, k):
    return x**k


def collide(case, _):
    """Rigid balls without restitution: normal impulse m v_n/2, tangential one at most mu of it, or what ends the slip.

    The line of centres leans by the angle; slip of the first along the tangent is v_t + w r, and a unit of impulse changes it by 2 (1/m + r^2/I) = 7/m.
    """
    mu, r, v, angle, w = number(case, "mu", "radius", "speed", "angle", "spin")
    co, si = mp.cos(angle), mp.sin(angle)
    normal = v * co / 2
    # Tangent to the left of the normal: v = v co n - v si t; the contact lies at r n, where the spin gives w r t.
    slip = -v * si + w * r
    impulse = -slip / 7
    if abs(impulse) > mu * normal:
        impulse = -mu * normal if slip > 0 else mu * normal
    turn = impulse * 5 / (2 * r)
    first_n, first_t = v * co - normal, -v * si + impulse
    return {
        "along_m_s": first_n * co - first_t * si,
        "left_m_s": first_n * si + first_t * co,
        "spin_rad_s": w + turn,
        "other_along_m_s": normal * co + impulse * si,
        "other_left_m_s": normal * si - impulse * co,
        "other_spin_rad_s": turn,
    }


class Halves:
    """A rectangle across the line y = 0 between two belts of opposite velocities along x."""

    def __init__(self, half_x, half_y, speed):
        self.corners = [(half_x, half_y), (-half_x, half_y), (-half_x, -half_y), (half_x, -half_y)]
        self.speed, self.gyration_sq = speed, (half_x**2 + half_y**2) / 3
        # Below this spin doubles take the torque as linear in it: far centres of rotation cancel digits.
        self.slow = abs(speed) / mp.sqrt(self.gyration_sq) / 2000 if mp.are_doubles() else 0

    def torque(self, angle, spin):
        """Of both halves, which symmetry makes equal, about the middle."""
        co, si = mp.cos(angle), mp.sin(angle)
        turned = [(co * x - si * y, si * x + co * y) for x, y in self.corners]
        upper = []
        for (ax, ay), (bx, by) in zip(turned, turned[1:] + turned[:1]):
            if ay > 0:
                upper.append((ax, ay))
            if (ay > 0) != (by > 0):
                upper.append((ax + (bx - ax) * ay / (ay - by), mp.real("0")))
        mx, my = centroid(upper)
        face = PolygonFace([(x - mx, y - my) for x, y in upper], (mx, my))

        def at(spin):
            return face.wrench(-self.speed, mp.real("0"), spin)[2]

        still = -my if self.speed > 0 else my
        if spin == 0:
            return still
        if abs(spin) < self.slow:
            return still + (at(self.slow) - at(-self.slow)) / 2 * spin / self.slow
        return at(spin)


def centroid(corners):
    edges = list(zip(corners, corners[1:] + corners[:1]))
    crosses = [a[0] * b[1] - a[1] * b[0] for a, b in edges]
    area = sum(crosses) / 2
    return tuple(sum(c * (a[i] + b[i]) for c, (a, b) in zip(crosses, edges)) / 6 / area for i in (0, 1))


def belts(case, way):
    mu, g, x, y, speed, seconds = number(case, "mu", "g", "half_x", "half_y", "speed", "seconds")
    face = Halves(x, y, speed)

    def turning(angle, spin):
        return mu * g * face.torque(angle, spin) / face.gyration_sq

    def in_time(state):
        angle, spin = state
        return [spin, turning(angle, spin)]

    def in_angle(state):
        """Over s with angle = -s^2, which is smooth at the start: spin, time, s."""
        spin, _, s = state
        slow = -2 * s / spin
        return [turning(-s * s, spin) * slow, slow, mp.real("1")]

    # A corner that crosses the line is a kink: the motion is taken up anew there.
    kink = mp.sqrt(mp.atan(y / x))
    start = turning(mp.real("0"), mp.real("0"))
    s = kink * mp.real(way[1]) ** (mp.real("1") / 2)
    spin, time, _ = over(in_angle, [-mp.sqrt(-2 * start) * s, s * mp.sqrt(-2 / start), s], kink - s, [1, 1, 1], way)
    state, left = ([-kink * kink, spin], seconds - time) if time < seconds else ([mp.real("0"), mp.real("0")], seconds)
    angle, _ = over(in_time, state, left, [1, 10], way)
    return {"turn_rad": angle, "drift_m": mp.real("0")}


def turntable(case, way):
    """A puck on a table that turns, at first with it: it never spins relative to the table, so friction is that of a point."""
    mu, g, distance, rate, seconds = number(case, "mu", "g", "distance", "rate", "seconds")
    k = mu * g
    excess = rate * rate * distance - k
    if excess <= 0:
        return {"distance_m": distance, "creep_m_s": mp.real("0")}

    def slopes(state):
        x, y, vx, vy = state
        ux, uy = vx + rate * y, vy - rate * x
        slip = mp.sqrt(ux * ux + uy * uy)
        return [vx, vy, -k * ux / slip, -k * uy / slip]

    # The first moments by their series: it slips outwards, and the Coriolis force bends that.
    begin = mp.real(way[1]) ** (mp.real("1") / 2) / rate
    out, bent = excess * begin, -2 * rate * excess / (2 + k / excess) * begin**2
    r, co, si = distance + out * begin / 2, mp.cos(rate * begin), mp.sin(rate * begin)
    state = [r * co, r * si, out * co - (bent + rate * r) * si, out * si + (bent + rate * r) * co]
    x, y, _, _ = over(slopes, state, seconds - begin, [distance, distance, rate, rate], way, begin)
    return {"distance_m": mp.sqrt(x * x + y * y)}


ANSWERS = {
    **dict.fromkeys((*THROWN, "eccentric"), thrown),
    "spin_down": disk_spins,
    "top": disk_spins,
    "wheel": wheel,
    "torsion": torsion,
    "ball": rolls,
    "back_spin": rolls,
    "incline_holds": slope,
    "incline_slides": slope,
    "vibration_holds": vibration,
    "vibration_slips": vibration,
    "tower": tower,
    "capsule": held,
    "stack": stack,
    "oblique": oblique,
    "skate": skate,
    "collide": collide,
    "belts": belts,
    "turntable_holds": turntable,
    "turntable_slips": turntable,
}
