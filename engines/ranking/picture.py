"""The picture of docs/engines.md: by how much each set-up misses the place of rest."""

import math
from xml.sax.saxutils import escape

WIDTH, LEFT, RIGHT, TOP, ROW = 640, 216, 24, 66, 27  # px
LEAST, MOST = 1e-4, 100.0  # %
OURS, THEIRS = "#1f6fb4", "#c2410c"


def x_of(error):
    """Where an error in % lies; whatever diverges stands at the end."""
    share = math.log(min(max(error, LEAST), MOST) / LEAST) / math.log(MOST / LEAST)
    return LEFT + share * (WIDTH - LEFT - RIGHT)


def text(x, y, words, anchor="start", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{escape(words)}</text>'


def disk(x, y, colour):
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" fill="{colour}" fill-opacity="0.6"/>'


def triangle(x, y, colour):
    corners = f"{x - 5:.1f},{y + 4:.1f} {x + 5:.1f},{y + 4:.1f} {x:.1f},{y - 5:.1f}"
    return f'<polygon points="{corners}" fill="none" stroke="{colour}" stroke-width="1.6"/>'


def drawn(rows, bad):
    """Of rows of name, whether repaired, errors of bodies on faces and on feet, in %."""
    bottom = TOP + ROW * len(rows)
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {bottom + 50}" '
        f'width="{WIDTH}" height="{bottom + 50}" font-family="sans-serif" font-size="12.5" fill="#222">',
        f'<rect width="{WIDTH}" height="{bottom + 50}" fill="#fff"/>',
        f'<rect x="{x_of(bad):.1f}" y="{TOP}" width="{x_of(MOST) - x_of(bad):.1f}" '
        f'height="{bottom - TOP}" fill="#fde8dc"/>',
    ]
    for power in range(round(math.log10(LEAST)), round(math.log10(MOST)) + 1):
        x, value = x_of(10.0**power), f"{10.0**power:g}" if power > -4 else "0.0001"
        out.append(f'<path d="M{x:.1f} {TOP}V{bottom}" stroke="#ddd"/>')
        out.append(text(x, bottom + 18, value, "middle"))
    axis = "distance from the exact place of rest, % of the displacement"
    out.append(text((LEFT + WIDTH - RIGHT) / 2, bottom + 38, axis, "middle"))
    out += [disk(24, 18, OURS), text(36, 22, "friction of this library")]
    out += [disk(204, 18, THEIRS), text(216, 22, "as the engine is")]
    out += [disk(24, 42, "#555"), text(36, 46, "bodies on faces, mean of five spins")]
    out += [triangle(288, 42, "#555"), text(300, 46, "bodies on three points")]
    out.append(text(WIDTH - RIGHT, 46, "diverges at the right rim", "end"))
    for index, (name, is_ours, faces, feet) in enumerate(rows):
        y, colour = TOP + ROW * (index + 0.5), OURS if is_ours else THEIRS
        out.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#eee"/>')
        out.append(text(LEFT - 12, y + 4, name, "end", ' font-size="12"'))
        out += [disk(x_of(error), y, colour) for error in faces]
        out += [triangle(x_of(error), y, colour) for error in feet]
    out.append(f'<path d="M{LEFT} {TOP}V{bottom}H{WIDTH - RIGHT}" fill="none" stroke="#888"/>')
    return "\n".join([*out, "</svg>", ""])


def stops(lanes, alone, ours):
    """Where a thrown body stops: lanes of spin, exact travel, that of both set-ups, in m."""
    row, left, right, top = 34, 96, 30, 58
    bottom, most = top + row * len(lanes), 0.65  # m
    height = bottom + 50

    def x(travel):
        return left + travel / most * (WIDTH - left - right)

    def ring(at, y):
        return (
            f'<circle cx="{at:.1f}" cy="{y:.1f}" r="9" fill="none" stroke="#222" stroke-width="2"/>'
        )

    def full(at, y, colour):
        return f'<circle cx="{at:.1f}" cy="{y:.1f}" r="5.5" fill="{colour}"/>'

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
        f'height="{height}" font-family="sans-serif" font-size="12.5" fill="#222">',
        f'<rect width="{WIDTH}" height="{height}" fill="#fff"/>',
        *[ring(24, 20), text(40, 24, "exact place of rest")],
        *[full(198, 20, THEIRS), text(210, 24, alone), full(378, 20, OURS), text(390, 24, ours)],
    ]
    for tenths in range(7):
        at = x(0.1 * tenths)
        out.append(f'<path d="M{at:.1f} {top}V{bottom}" stroke="#ddd"/>')
        out.append(text(at, bottom + 18, f"{0.1 * tenths:g}", "middle"))
    out.append(text((left + WIDTH - right) / 2, bottom + 38, "travel, m", "middle"))
    for index, (spin, exact, theirs, mended) in enumerate(lanes):
        y = top + row * (index + 0.5)
        out.append(text(left - 12, y + 4, f"{spin} rad/s", "end"))
        out.append(f'<path d="M{left} {y:.1f}H{x(exact):.1f}" stroke="#bbb"/>')
        out += [full(x(theirs), y, THEIRS), ring(x(exact), y), full(x(mended), y, OURS)]
    out.append(f'<path d="M{left} {top}V{bottom}H{WIDTH - right}" fill="none" stroke="#888"/>')
    return "\n".join([*out, "</svg>", ""])
