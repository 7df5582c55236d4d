"""The kernel of Tribos by its Python package (bindings/python): a flat body by its exact friction step, balls by contact dynamics."""

import math

import tribos
from tribos import cd

from ..scene import Unsupported, balls

NAME, VERSION, LICENCE, KIND = "Tribos", tribos.__version__, "MIT OR Apache-2.0", "mechanics"
SETTINGS = {"default": {"dt": 1 / 240}, "steps of 1 ms": {"dt": 1e-3}}


def patch(body):
    """The face about the centre of mass, which is its centre of pressure."""
    kind, sizes, (x, y, _) = body.shape.kind, body.shape.sizes, body.com
    if kind == "box":
        return tribos.polygon([(i * sizes[0] - x, j * sizes[1] - y) for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1))], centre=(0.0, 0.0))
    if kind == "feet":
        a, b, c = ((foot[0] - x, foot[1] - y) for foot in sizes)
        return tribos.points([a, b, c], [p[0] * q[1] - q[0] * p[1] for p, q in ((b, c), (c, a), (a, b))])
    if body.pose[0] != 1.0:
        return tribos.bar(2 * sizes[1])
    return (tribos.ring if body.shape.is_rim else tribos.disk)(sizes[0])


def turned(vector, angle):
    """Turns the first two numbers."""
    (x, y, *more), sin, cos = vector, math.sin(angle), math.cos(angle)
    return [cos * x - sin * y, sin * x + cos * y, *more]


class Simulator:
    def __init__(self, scene, setting, dt):
        self.scene, self.dt, self.world = scene, dt, None
        free = [body for body in scene.bodies if not body.is_driven]
        if free[0].shape.kind == "ball":
            radius, _ = balls(free[0].shape)
            laws = cd.Laws(sliding=scene.mu, torsion=scene.torsion / radius)
            walls = [cd.Wall((0.0, 0.0, 1.0))] if scene.has_floor else []
            options = {"density": 0.75 / (math.pi * radius**3), "walls": walls, "laws": laws, "gravity": scene.gravity}
            self.world = cd.World([body.place for body in free], radius, longest_step=dt, largest_motion=1.0, **options)
            return
        body, is_upright = free[0], free[0].pose[0] == 1.0
        leans = is_upright and abs(body.place[2] + body.com[2]) > 1e-9 and "gravity" not in scene.needs
        if len(free) > 1 or leans:
            raise Unsupported("It holds one flat body, whose pressure stays as it is, or balls.")
        friction = tribos.Friction(patch(body), mu=scene.mu if scene.mu_across is None else (scene.mu, scene.mu_across))
        self.body = tribos.PlanarBody(friction, body.mass, body.inertia[2 if is_upright else 0], gravity=-scene.gravity[2])
        self.place, self.twist, self.grounds = [body.place[0] + body.com[0], body.place[1] + body.com[1], 0.0], [0.0] * 3, {}
        self.gravity(scene.gravity)

    def set(self, body, velocity, spin):
        if self.world:
            velocities, spins = self.world.velocities, self.world.spins
            velocities[body], spins[body] = velocity, spin
            self.world.velocities, self.world.spins = velocities, spins
        elif self.scene.bodies[body].is_driven:
            self.grounds[body] = [*velocity[:2], spin[2]]
        else:
            self.twist = [*velocity[:2], spin[2]]

    def gravity(self, vector):
        self.pushes, self.load = [self.body.mass * vector[0], self.body.mass * vector[1], 0.0], -self.body.mass * vector[2]

    def step(self):
        if self.world:
            self.world.step()
            return
        before, grounds = self.twist, list(self.grounds.values())
        x, y, angle = (at + self.dt * v for at, v in zip(self.place, before))
        if len(grounds) == 2:
            # Belts that meet at y = 0, in the axes of the body.
            border = [turned([along - x, -y], -angle) for along in (-1.0, 1.0)]
            surface = [(border, turned(grounds[0], -angle)), (border[::-1], turned(grounds[1], -angle))]
            step = self.body.step(turned(before, -angle), turned(self.pushes, -angle), self.dt, surface=surface)
            after = turned(step.twists, angle)
        else:
            u, v, spin = grounds[0] if grounds else [0.0] * 3
            ground = [u - spin * y, v + spin * x, spin]
            step = self.body.step([a - b for a, b in zip(before, ground)], self.pushes, self.dt, angle=angle, load=self.load)
            after = step.twists + ground
        self.twist = [float(part) for part in after]
        self.place = [at + 0.5 * self.dt * (a + b) for at, a, b in zip(self.place, before, self.twist)]

    def state(self, body):
        if self.world:
            return self.world.positions[body], (1.0, 0.0, 0.0, 0.0), self.world.velocities[body], self.world.spins[body]
        (x, y, angle), (u, v, spin) = self.place, self.twist
        return (x, y, 0.0), (math.cos(0.5 * angle), 0.0, 0.0, math.sin(0.5 * angle)), (u, v, 0.0), (0.0, 0.0, spin)
