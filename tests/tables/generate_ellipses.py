"""Reference table of dry friction of ellipses: ellipses.csv.

    python3 generate_ellipses.py make          from chords through the centre of rotation, 25 digits
    python3 generate_ellipses.py check [rows]  some of them again, by area integrals with 15 digits

`make` sums moments of the pressure along chords over the chords' angle; all that is lost in the torque of a far centre
of rotation is in the digits that it has in excess. `check` knows neither chords nor a centre of rotation: it integrates
p q/|q| over the area, in polar coordinates of the stretched disk.
"""

import sys
from mpmath import mp, mpf, sqrt, gamma, pi, cos, sin, asin, atan2, quad, hypot

mp.dps = 50
ORDERS = {"punch": mpf(-1) / 2, "uniform": mpf(0), "hertz": mpf(1) / 2, "paraboloid": mpf(1)}
# Semi-axes along x and y.
SIZES = [(1.0, 1.0), (1.0, 0.75), (0.5, 1.0), (1.0, 0.1), (1.0, 0.01), (1.0, 0.001)]
# Centres of rotation in semi-axes: far, in the ellipse, on its edge, next to it.
PLACES = [(0.0, 0.0), (1e-9, -1e-9), (0.5, 0.0), (-0.125, 0.375), (0.0, -0.875), (0.75, 0.625),
          (1.0, 0.0), (0.0, 1.0), (0.6, -0.8), (0.600001, 0.8), (0.5999, 0.8), (-1.0009765625, 0.0), (0.0, 1.0009765625),
          (0.25, 1.5), (0.875, 8.0), (1.125, -0.5), (3.0, 2.0), (-2.0, 300.0), (50.0, 40.0), (1e5, 1e6)]


def motions(a, b):
    yield (0.25, -0.5, 0.0)
    yield (1.0, 0.0, 0.0)
    yield (-0.75, 0.25, -1e-12)
    for index, (x, y) in enumerate(PLACES):
        spin = -2.0 if index % 3 == 1 else 0.5
        x, y = a * x, b * y
        yield (spin * y, -spin * x, spin)


def by_chords(order, a, b, motion):
    """Force, torque and second derivatives of the power (xx, xy, yy, xn, yn, nn) per muN."""
    vx, vy, spin = map(mpf, motion)
    a, b = mpf(a), mpf(b)
    if spin == 0:
        return sliding(order, a, b, vx, vy)
    cx, cy = -vy / spin, vx / spin
    dx, dy = cx / a, cy / b
    d = hypot(dx, dy)
    start = atan2(dy, dx)
    width = pi / 2 if d <= 1 else asin(1 / d)
    chord = sqrt(pi) * gamma(order + 1) / gamma(order + mpf(3) / 2) * (order + 1) / pi

    def at(turn):
        if d <= 1:
            x, scale = turn, mpf(1)
            root_sq = 1 - (d * sin(x)) ** 2
        else:
            # Angles between the tangents, without the roots at their ends.
            x = asin(sin(turn) / d)
            root_sq = cos(turn) ** 2
            scale = cos(turn) / (d * cos(x))
        nu = (cos(start + x), sin(start + x))
        n = (a * nu[0], b * nu[1])
        size = hypot(*n)
        n = (n[0] / size, n[1] / size)
        # Load on the chord, its middle and its mean square about the middle, all from the centre of rotation.
        zeroth = chord * sqrt(root_sq) ** (2 * order + 1) * size
        middle = -(dx * nu[0] + dy * nu[1]) * size
        second = root_sq / (2 * order + 3) * size ** 2 + middle ** 2
        weight = scale / size ** 2
        w = (n[0], n[1], n[1] * cx - n[0] * cy)
        out = [weight * zeroth * part for part in (
            n[1] * middle, -n[0] * middle, -second,
            w[0] * w[0], w[0] * w[1], w[1] * w[1], w[0] * w[2], w[1] * w[2], w[2] * w[2])]
        return out

    edges = breaks(a, b, d, start, width)
    total = [mpf(0)] * 9
    for low, high in zip(edges, edges[1:]):
        for node, weight in gauss():
            values = at((low + high) / 2 + (high - low) / 2 * node)
            total = [t + (high - low) / 2 * weight * value for t, value in zip(total, values)]
    sense = 1 if spin > 0 else -1
    fx, fy, torque = (sense * part for part in total[:3])
    hessian = [part / abs(spin) for part in total[3:]]
    return [fx, fy, torque + cx * fy - cy * fx] + hessian


def breaks(a, b, d, start, width):
    """Panels that become finer towards the ends and the chord along the minor axis."""
    limit = pi / 2
    peak = pi / 2 - start if a >= b else -start
    while peak > pi / 2:
        peak -= pi
    while peak < -pi / 2:
        peak += pi
    places = [-limit, limit]
    if abs(peak) <= width:
        places.append(asin(min(max(d * sin(peak), -1), 1)) if d > 1 else peak)
    finer = set(places + [mpf(0)])
    for place in places:
        for k in range(48):
            for side in (-1, 1):
                near = place + side * mpf(2) ** (-k) * mpf("1.3")
                if -limit < near < limit:
                    finer.add(near)
    return sorted(finer)


RULE = []


def gauss(count=24):
    """Nodes and weights on [-1, 1]: Newton's method on the recurrence."""
    for k in range(0 if RULE else count):
        x = cos(pi * (k + mpf(3) / 4) / (count + mpf(1) / 2))
        for _ in range(8):
            before, here = mpf(1), x
            for n in range(1, count):
                before, here = here, ((2 * n + 1) * x * here - n * before) / (n + 1)
            slope = count * (x * here - before) / (x * x - 1)
            x -= here / slope
        RULE.append((x, 2 / ((1 - x * x) * slope ** 2)))
    return RULE


def sliding(order, a, b, vx, vy):
    speed = hypot(vx, vy)
    ex, ey = vx / speed, vy / speed
    # <(e . x)^2> = (a^2 ex^2 + b^2 ey^2) <x^2> of the disk.
    mean = 1 / (2 * (order + 2))
    along = (a * a * ex * ex + b * b * ey * ey) * mean
    return [-ex, -ey, mpf(0), ey * ey / speed, -ex * ey / speed, ex * ex / speed, mpf(0), mpf(0), along / speed]


def by_area(order, a, b, motion):
    vx, vy, spin = map(mpf, motion)

    def at(r, angle):
        x, y = a * r * cos(angle), b * r * sin(angle)
        qx, qy = vx - spin * y, vy + spin * x
        q = hypot(qx, qy)
        if q == 0:
            return (mpf(0),) * 3
        return -qx / q, -qy / q, -(x * qy - y * qx) / q

    out = []
    for index in range(3):
        # u = (1 - r^2)^(q + 1) spreads the load evenly.
        out.append(quad(lambda u, angle: at(sqrt(1 - u ** (1 / (order + 1))), angle)[index],
                        [0, 1], [0, pi / 2, pi, 3 * pi / 2, 2 * pi]) / (2 * pi))
    return out


def rows():
    for a, b in SIZES:
        for pressure, order in ORDERS.items():
            for motion in motions(a, b):
                yield pressure, order, a, b, motion


def make():
    with open("ellipses.csv", "w") as out:
        out.write("# Dry friction of ellipses per muN, and the second derivatives of its power: generate_ellipses.py make\n")
        out.write("pressure,a,b,velocity_x,velocity_y,spin,force_x,force_y,torque,xx,xy,yy,xn,yn,nn\n")
        for pressure, order, a, b, motion in rows():
            found = by_chords(order, a, b, motion)
            numbers = [repr(x) for x in (a, b, *motion)] + [mp.nstr(x, 25) for x in found]
            out.write(",".join([pressure] + numbers) + "\n")


def check(count):
    # With the centre of rotation outside the integrand is smooth.
    outside = [row for row in rows() if row[4][2] and 1.2 < hypot(row[4][1] / row[2], row[4][0] / row[3]) / abs(row[4][2]) < 500]
    for pressure, order, a, b, motion in outside[::5][:count]:
        mp.dps = 50
        chords = by_chords(order, a, b, motion)[:3]
        mp.dps = 15
        area = by_area(order, a, b, motion)
        print(pressure, a, b, motion, mp.nstr(max(abs(x - y) for x, y in zip(chords, area)), 3), flush=True)


if __name__ == "__main__":
    if sys.argv[1:2] == ["make"]:
        make()
    elif sys.argv[1:2] == ["check"]:
        check(int(sys.argv[2]) if len(sys.argv) > 2 else 8)
    else:
        sys.exit(__doc__)
