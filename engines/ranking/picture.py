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
