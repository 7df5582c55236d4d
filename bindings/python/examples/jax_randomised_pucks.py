"""Domain randomisation: 4,096 pucks, each with friction, radius, mass and launch of its own, slide to rest in one program.

    python jax_randomised_pucks.py

All step together in one compiled scan, in single precision, under exact friction of the whole face. Three of them are
compared with `tribos.slide`, which has the way to rest without steps.
"""

from __future__ import annotations

import time

import jax
import jax.numpy as jnp
import numpy as np
import tribos
import tribos.jax

COUNT, STEPS, DT = 4096, 600, 0.005  # s
GRAVITY = 9.81  # m/s²
PUCK = tribos.Friction(tribos.disk(1.0), mu=1.0)  # radius and coefficient are arrays


def drawn(key: jax.Array) -> dict[str, jax.Array]:
    """Coefficients, radii in m, masses in kg, speeds in m/s and spins in rad/s."""
    ranges = {"mu": (0.15, 0.5), "radius": (0.03, 0.08), "mass": (0.1, 1.0)}
    ranges |= {"speed": (0.5, 2.0), "spin": (-60.0, 60.0)}
    keys = jax.random.split(key, len(ranges))
    pairs = zip(keys, ranges.items(), strict=True)
    return {
        name: jax.random.uniform(one, (COUNT,), jnp.float32, *ends) for one, (name, ends) in pairs
    }


@jax.jit
def travels(puck: dict[str, jax.Array]) -> tuple[jax.Array, jax.Array]:
    """Distances to rest in m, and whether all have come to it."""
    mass, radius = puck["mass"], puck["radius"]
    body = {"mass": mass, "inertia": 0.5 * mass * radius**2, "dt": DT}
    own = {"mu": puck["mu"], "radius": radius}

    def step(state: tuple[jax.Array, jax.Array], _: None) -> tuple[object, None]:
        twists, travel = state
        after = tribos.jax.planar_step(PUCK, twists, jnp.zeros(3), mass * GRAVITY, **body, **own)
        return (after.twists, travel + 0.5 * DT * (twists[:, 0] + after.twists[:, 0])), None

    launch = jnp.stack([puck["speed"], jnp.zeros(COUNT), puck["spin"]], axis=-1)
    (twists, travel), _ = jax.lax.scan(step, (launch, jnp.zeros(COUNT)), length=STEPS)
    return travel, jnp.all(twists == 0.0)


def main() -> None:
    pucks = drawn(jax.random.key(0))
    travel, rest = jax.block_until_ready(travels(pucks))
    start = time.perf_counter()
    travel, rest = jax.block_until_ready(travels(pucks))
    each = (time.perf_counter() - start) / (COUNT * STEPS)
    low, middle, high = np.percentile(travel, [5, 50, 95])
    print(f"{COUNT} pucks, all at rest: {rest}; {1e9 * each:.0f} ns a puck and step")
    print(f"travel: {middle:.3f} m in the middle, 90 % within {low:.3f} to {high:.3f} m")
    for at in (0, 1, 2):
        mu, radius, _, speed, spin = (float(column[at]) for column in pucks.values())
        puck = tribos.Friction(tribos.disk(radius), mu=mu)
        exact = tribos.slide(puck, speed, spin, gravity=GRAVITY).distance
        print(f"travel {travel[at]:.5f} m, exact {exact:.5f} m: {travel[at] / exact - 1.0:+.4%}")


if __name__ == "__main__":
    main()
