"""Draws the pictures that explain, beside those that the commands draw: python3 docs/pictures/explain.py"""

from math import cos, hypot, pi, sin
from pathlib import Path

BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#555555"


class Drawing:
    """An SVG picture on a white card, with y upwards."""

    def __init__(self, width, height):
        self.height = height
        self.lines = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="15">',
            f'<rect width="{width}" height="{height}" fill="white"/>',
        ]

    def place(self, x, y):
        return f"{x:.1f},{self.height - y:.1f}"

    def path(self, points, colour, width=2.0, fill="none", dash=""):
        path = " ".join(self.place(*point) for point in points)
        dash = f' stroke-dasharray="{dash}"' if dash else ""
        self.lines.append(
            f'<polyline points="{path}" stroke="{colour}" stroke-width="{width}" fill="{fill}"{dash}/>'
        )

    def circle(self, x, y, radius, colour, fill="none"):
        x, y = self.place(x, y).split(",")
        self.lines.append(
            f'<circle cx="{x}" cy="{y}" r="{radius}" stroke="{colour}" stroke-width="2" fill="{fill}"/>'
        )

    def arrow(self, x, y, dx, dy, colour, width=1.5):
        size, head = hypot(dx, dy), 3.0 * width
        ux, uy = dx / size, dy / size
        self.path([(x, y), (x + dx - head * ux, y + dy - head * uy)], colour, width)
        base = (x + dx - 2 * head * ux, y + dy - 2 * head * uy)
        sides = [(base[0] - s * head * uy, base[1] + s * head * ux) for s in (1, -1)]
        corners = " ".join(self.place(*point) for point in [(x + dx, y + dy), *sides])
        self.lines.append(f'<polygon points="{corners}" fill="{colour}"/>')

    def text(self, x, y, text, colour=GREY, anchor="middle"):
        x, y = self.place(x, y).split(",")
        self.lines.append(
            f'<text x="{x}" y="{y}" text-anchor="{anchor}" fill="{colour}">{text}</text>'
        )

    def write(self, name):
        (Path(__file__).parent / name).write_text("\n".join([*self.lines, "</svg>", ""]))


def elements():
    """Places on the unit disk, each for the same area."""
    for ring in range(1, 5):
        radius = (ring - 0.5) / 4
        for k in range(6 * ring - 3):
            angle = 2 * pi * k / (6 * ring - 3)
            yield radius * cos(angle), radius * sin(angle)


def spin():
    """Friction on the elements of a disk that slides to the right, without spin and with it."""
    drawing, radius = Drawing(720, 400), 125
    for middle, rim, title, force in (
        (180, 0.0, "slides", 1.0),
        (540, 2.0, "slides, and its rim is twice as fast", 0.483844),
    ):
        drawing.text(middle, 372, title)
        drawing.circle(middle, 215, radius + 8, GREY, "#f3f3f3")
        for x, y in elements():
            u, v = 1.0 - rim * y, rim * x
            size = hypot(u, v)
            at = (middle + radius * x, 215 + radius * y)
            drawing.arrow(*at, -24 * u / size, -24 * v / size, BLUE)
        drawing.arrow(middle, 55, -140 * force, 0, ORANGE, 4)
        drawing.text(middle, 22, f"force against sliding: {100 * force:.0f} %", ORANGE)
        drawing.arrow(middle + 20, 55, 60, 0, GREEN, 3)
        drawing.text(middle + 90, 50, "v", GREEN, "start")
    drawing.write("spin.svg")


def soles():
    """The sole of foot.md from above: at the start, and at rest after both throws."""
    drawing, scale = Drawing(720, 400), 1100.0
    for forward, turned, colour, label, at in (
        (0.0, 0.0, GREY, "start", (40, 255)),
        (0.1153, 0.989, ORANGE, "elliptic cone: 0.989 rad", (425, 270)),
        (0.1242, 1.650, BLUE, "exact: 1.650 rad", (384, 70)),
    ):
        corners = []
        for x, y in ((0.12, 0.05), (-0.12, 0.05), (-0.12, -0.05), (0.12, -0.05), (0.12, 0.05)):
            x, y = x * cos(turned) - y * sin(turned), x * sin(turned) + y * cos(turned)
            corners.append((170 + scale * (forward + x), 190 + scale * y))
        drawing.path(corners, colour, 2.5, dash="" if turned else "6 5")
        drawing.circle(170 + scale * forward, 190, 3, colour, colour)
        drawing.text(*at, label, colour, "start")
    drawing.write("soles.svg")


def ball():
    """The path of ball.md: a parabola while the ball slips, then a straight line."""
    drawing, scale = Drawing(720, 200), 3000.0
    deceleration, speed = 0.2 * 9.81, (1.0, 0.0)
    slip = (1.0, 25.0 * 0.028575)
    size = hypot(*slip)
    end = 2 / 7 * size / deceleration
    path = []
    for k in range(41):
        t = end * k / 40
        fall = [0.5 * deceleration * t * t * s / size for s in slip]
        path.append((40 + scale * (speed[0] * t - fall[0]), 155 + scale * (speed[1] * t - fall[1])))
    rolled = [v - 2 / 7 * s for v, s in zip(speed, slip)]
    last = path[-1]
    drawing.path([path[0], (640, 155)], GREY, 1.5, dash="6 5")
    drawing.path(path, BLUE, 3)
    drawing.path([last, (last[0] + 160 * rolled[0], last[1] + 160 * rolled[1])], GREEN, 3)
    drawing.circle(*last, 4, GREEN, GREEN)
    drawing.text(45, 166, "where the cue pointed", GREY, "start")
    drawing.text(200, 110, "slips", BLUE)
    drawing.text(560, 112, "rolls", GREEN)
    drawing.text(
        last[0] - 20,
        last[1] - 40,
        f"{1e3 * (last[0] - 40) / scale:.0f} mm on, {1e3 * (155 - last[1]) / scale:.0f} mm aside",
    )
    drawing.write("ball.svg")


def vehicle():
    """Friction on the wheels of vehicle.md: at the spin of a differential drive, and where it is in balance."""
    drawing, scale = Drawing(720, 400), 480.0
    for middle, turn, title, torque in (
        (180, 0.8, "0.80 rad/s, as by the formula", "friction brakes it with 42 N m"),
        (540, 0.2 * 0.25 / (0.2**2 + 0.25**2), "0.49 rad/s", "friction has no torque"),
    ):
        drawing.text(middle, 384, title)
        drawing.text(middle, 8, torque, ORANGE)
        x, y = 0.26 * scale, 0.2 * scale
        drawing.path(
            [(middle + a * x, 200 + b * y) for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1))],
            GREY,
            1.5,
            "#f3f3f3",
        )
        for x in (-0.2, 0.2):
            for y in (-0.25, 0.25):
                at = (middle + scale * x, 200 + scale * y)
                rolls = 0.2 if y < 0 else -0.2
                u, v = -turn * y - rolls, turn * x
                size = hypot(u, v)
                drawing.path([(at[0] - 26, at[1]), (at[0] + 26, at[1])], GREY, 17)
                drawing.path([(middle, 200), at], GREY, 1.2, dash="6 5")
                drawing.arrow(at[0], at[1] - 22, 220 * rolls, 0, GREEN, 2)
                drawing.arrow(*at, -44 * u / size, -44 * v / size, BLUE, 3)
        drawing.circle(middle, 200, 4, ORANGE, ORANGE)
    drawing.text(360, 68, "rolls", GREEN)
    drawing.text(360, 330, "friction", BLUE)
    drawing.write("vehicle.svg")


spin()
soles()
ball()
vehicle()
