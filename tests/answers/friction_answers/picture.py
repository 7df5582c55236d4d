"""A picture of points on two logarithmic axes, as SVG."""

import math
from html import escape

WIDTH, HEIGHT, LEFT, BOTTOM, TOP, RIGHT = 1000, 640, 70, 60, 20, 20
COLOURS = ("#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#bbbbbb", "#222255", "#997700", "#994455")
MARKS = ("circle", "square", "diamond")


def ends(values):
    low = math.floor(math.log10(min(values)))
    return low, max(low + 1, math.ceil(math.log10(max(values))))


def scatter(rows):
    """Error over cost, a point a setting, the settings of an engine joined from quick to slow."""
    points = [(row, row.cost, row.overall()) for row in rows]
    points = [(row, x, y) for row, x, y in points if 0 < x < math.inf and 0 < y < math.inf]
    if not points:
        return '<svg xmlns="http://www.w3.org/2000/svg"/>\n'
    x0, x1 = ends([x for _, x, _ in points])
    y0, y1 = ends([100 * y for _, _, y in points])

    def px(x):
        return LEFT + (math.log10(x) - x0) / (x1 - x0) * (WIDTH - LEFT - RIGHT)

    def py(y):
        return HEIGHT - BOTTOM - (math.log10(100 * y) - y0) / (y1 - y0) * (HEIGHT - BOTTOM - TOP)

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
    ]
    for power in range(x0, x1 + 1):
        x = px(10.0**power)
        out.append(
            f'<path d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#dddddd"/><text x="{x:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{10.0**power:g}</text>'
        )
    for power in range(y0, y1 + 1):
        y = py(10.0 ** (power - 2))
        out.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#dddddd"/><text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{10.0**power:g} %</text>')
    out.append(f'<text x="{(LEFT + WIDTH) / 2}" y="{HEIGHT - 14}" text-anchor="middle">processor time over simulated time, one scene</text>')
    out.append(f'<text transform="translate(16 {HEIGHT / 2}) rotate(-90)" text-anchor="middle">error: mean of the five marks</text>')
    # Names cover no point either.
    taken = [(px(x) - 5, py(y) + 4, 10.0) for _, x, y in points]
    for i, engine in enumerate(dict.fromkeys(row.engine for row, _, _ in points)):
        colour = COLOURS[i % len(COLOURS)]
        own = sorted(((x, y, row) for row, x, y in points if row.engine == engine), key=lambda point: point[:2])
        path = " ".join(f"{px(x):.1f},{py(y):.1f}" for x, y, _ in own)
        out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-opacity="0.5"/>')
        for x, y, row in own:
            told = escape(f"{engine}, {row.setting}: {100 * y:.2g} %, cost {x:.2g}")
            out.append(f'<g fill="{colour}"><title>{told}</title>{mark(px(x), py(y), i // len(COLOURS))}</g>')
        x, y, _ = min(own, key=lambda point: point[1])
        out.append(name(engine, px(x), py(y), colour, taken))
    return "\n".join([*out, "</svg>"]) + "\n"


def mark(x, y, kind):
    if MARKS[kind % 3] == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5"/>'
    turn = f' transform="rotate(45 {x:.1f} {y:.1f})"' if MARKS[kind % 3] == "diamond" else ""
    return f'<rect x="{x - 5:.1f}" y="{y - 5:.1f}" width="10" height="10"{turn}/>'


def name(engine, x, y, colour, taken):
    """The engine's name beside its best point, or at the nearest height where it covers no other, with a line to the point."""
    width = 7.5 * len(engine)
    left = x + 9 if x + 9 + width < WIDTH - RIGHT else x - 9 - width

    def is_free(at):
        return all(abs(at - b) >= 14 or left >= a + w or a >= left + width for a, b, w in taken)

    heights = sorted((y + 4 + 7 * i for i in range(-60, 61)), key=lambda at: abs(at - y - 4))
    at = next((at for at in heights if TOP < at < HEIGHT - BOTTOM and is_free(at)), y + 4)
    taken.append((left, at, width))
    end = left if left > x else left + width
    lead = f'<path d="M{x:.1f} {y:.1f}L{end:.1f} {at - 4:.1f}" stroke="{colour}" stroke-opacity="0.4"/>' if abs(at - y - 4) > 7 else ""
    return f'{lead}<text x="{left:.1f}" y="{at:.1f}" fill="{colour}">{escape(engine)}</text>'
