"""What an engine is asked to build: a few rigid bodies under gravity, in SI units.

Every friction coefficient of a scene is the same one, between any two bodies and at the floor.
"""

from dataclasses import dataclass, field

FOOT = 0.01  # m, radius of a foot


@dataclass(frozen=True)
class Shape:
    """A shape about the body's own origin.

    kind: sizes
    box: half sides along x, y, z
    cylinder: radius, half its height along z
    ball: radius
    capsule: radius, half the length of its straight part along x
    feet: x and y of balls of radius FOOT with their centres in the plane z = 0 of the body
    """

    kind: str
    sizes: tuple
    is_rim: bool = False  # a cylinder that stands on the thin rim of its face, for engines that have faces


@dataclass(frozen=True)
class Body:
    """A rigid body."""

    name: str
    shape: Shape
    place: tuple  # of the shape's origin, m
    mass: float = 1.0  # kg
    inertia: tuple = (0.0, 0.0, 0.0)  # principal moments about the centre of mass, along the axes of the body, kg m^2
    com: tuple = (0.0, 0.0, 0.0)  # centre of mass from the shape's origin, m
    pose: tuple = (1.0, 0.0, 0.0, 0.0)  # quaternion w, x, y, z
    is_driven: bool = False  # moves with the velocity and spin that `set` gives it before every step


@dataclass(frozen=True)
class Scene:
    """Bodies, and a floor at z = 0 if there is one."""

    bodies: tuple
    mu: float
    gravity: tuple = (0.0, 0.0, -9.81)  # m/s^2
    has_floor: bool = True
    # Largest torsion torque over normal force, a length in m; 0 where points resist no spin.
    torsion: float = 0.0
    # Coefficient along y where that along x is `mu`, for the axes of the bodies; None where all directions are alike.
    mu_across: float | None = None
    # What an engine must be able to do beyond bodies on a floor: feet, capsule, driven, gravity, force, torsion, anisotropic.
    needs: frozenset = field(default_factory=frozenset)


def rotated(q, v):
    """A vector of the body in the axes of the world, for the quaternion w, x, y, z."""
    w, u = q[0], q[1:]
    t = [2 * c for c in cross(u, v)]
    return tuple(a + w * b + c for a, b, c in zip(v, t, cross(u, t)))


def inverse(q):
    return q[0], -q[1], -q[2], -q[3]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def sum_of(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def of_centre(place, q, velocity, spin, com):
    """State of the centre of mass from that of the body's origin."""
    arm = rotated(q, com)
    return sum_of(place, arm), tuple(q), sum_of(velocity, cross(spin, arm)), tuple(spin)


def of_origin(q, velocity, spin, com):
    """Velocity of the body's origin from that of the centre of mass."""
    return sum_of(velocity, cross(spin, rotated(q, com)), -1.0)


def balls(shape):
    """Radius and places of a ball, or of feet."""
    if shape.kind == "ball":
        return shape.sizes[0], [(0.0, 0.0, 0.0)]
    return FOOT, [(x, y, 0.0) for x, y in shape.sizes]


def parts(shape, **makers):
    """Shapes of a body as an engine makes them from their sizes, each with its place and pose in the body: capsules are made along z.

    A maker each of ball, box, cylinder and capsule.
    """
    if shape.kind in ("ball", "feet"):
        radius, places = balls(shape)
        return [(makers["ball"](radius), place, (1.0, 0.0, 0.0, 0.0)) for place in places]
    pose = (0.5**0.5, 0.0, 0.5**0.5, 0.0) if shape.kind == "capsule" else (1.0, 0.0, 0.0, 0.0)
    return [(makers[shape.kind](*shape.sizes), (0.0, 0.0, 0.0), pose)]


class Refused(Exception):
    """Why a run or a page cannot begin."""


class Unsupported(Exception):
    """Why an engine cannot hold a scene; the page has it as a footnote."""


def refuse(scene, lacks):
    """Raises if the scene needs what an engine lacks: need -> why."""
    for need in sorted(scene.needs & lacks.keys()):
        raise Unsupported(lacks[need])
