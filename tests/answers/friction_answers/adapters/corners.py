"""Coulomb's law at corners, in small steps: what an engine of points would find whose solver and steps were perfect.

No engine: a flat body is carried by its four corners, a cylinder by eight points of its rim, a wheel by the ends of its line. What this misses of an
answer is the fault of the points, not of time steps.
"""

import math

from ..scene import Unsupported

NAME, VERSION, LICENCE, KIND = "Coulomb at corners", "1", "MIT OR Apache-2.0", "mechanics"
SETTINGS = {"fine steps": {"dt": 2e-4}}
SWEEPS, RIM = 20, 8


def points(body):
    """Places that bear the body, from its centre of mass, in its axes."""
    sizes, kind = body.shape.sizes, body.shape.kind
    if kind == "box":
        x, y, _ = sizes
        found = [(x, y), (-x, y), (-x, -y), (x, -y)]
    elif kind == "cylinder" and body.pose[0] == 1.0:
        found = [(sizes[0] * math.cos(math.tau * i / RIM), sizes[0] * math.sin(math.tau * i / RIM)) for i in range(RIM)]
    elif kind == "cylinder":
        found = [(0.0, sizes[1]), (0.0, -sizes[1])]
    else:
        raise Unsupported("only boxes and cylinders stand on corners")
    return [(x - body.com[0], y - body.com[1]) for x, y in found]


class Simulator:
    def __init__(self, scene, setting, dt):
        body = scene.bodies[0]
        flat = body.com[2] == -body.place[2] or body.pose[0] != 1.0
        if len(scene.bodies) > 1 or not scene.has_floor or scene.needs or not flat:
            raise Unsupported("one body that slides on the floor without leaning")
        self.points, self.dt, self.mu, self.g = points(body), dt, scene.mu, -scene.gravity[2]
        self.inertia = body.inertia[2] if body.pose[0] == 1.0 else body.inertia[0]
        xs = [sum(p[i] for p in self.points) / len(self.points) for i in (0, 1)]
        spread = [sum((p[i] - xs[i]) ** 2 for p in self.points) or 1.0 for i in (0, 1)]
        # Linear in the place, and balanced below the centre of mass.
        self.loads = [1 / len(self.points) - sum(xs[i] * (p[i] - xs[i]) / spread[i] for i in (0, 1)) for p in self.points]
        self.place, self.angle, self.v, self.w = [0.0, 0.0], 0.0, [0.0, 0.0], 0.0

    def set(self, _, velocity, spin):
        self.v, self.w = list(velocity[:2]), spin[2]

    def step(self):
        co, si = math.cos(self.angle), math.sin(self.angle)
        arms = [(co * x - si * y, si * x + co * y) for x, y in self.points]
        pushes = [[0.0, 0.0] for _ in arms]
        for _ in range(SWEEPS):
            for (x, y), push, load in zip(arms, pushes, self.loads):
                gain = 1 / (1 + (x * x + y * y) / self.inertia)
                wanted = [push[0] - gain * (self.v[0] - self.w * y), push[1] - gain * (self.v[1] + self.w * x)]
                most, size = self.mu * self.g * load * self.dt, math.hypot(*wanted)
                if size > most:
                    wanted = [wanted[0] * most / size, wanted[1] * most / size]
                change = wanted[0] - push[0], wanted[1] - push[1]
                push[:] = wanted
                self.v = [self.v[0] + change[0], self.v[1] + change[1]]
                self.w += (x * change[1] - y * change[0]) / self.inertia
        self.place = [a + b * self.dt for a, b in zip(self.place, self.v)]
        self.angle += self.w * self.dt

    def state(self, _):
        pose = (math.cos(self.angle / 2), 0.0, 0.0, math.sin(self.angle / 2))
        return (*self.place, 0.0), pose, (*self.v, 0.0), (0.0, 0.0, self.w)
