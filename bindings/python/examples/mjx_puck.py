"""A puck in MJX that slides and spins: its travel on an exact patch and with MJX's own friction.

    python mjx_puck.py

A spinning puck travels farther, because friction of each part of its face opposes that part's own motion. All spins go side by
side (``vmap``); the last line is the derivative of the travel, through the whole simulation.
"""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp
import mujoco
import tribos
import tribos.mjx
from mujoco import mjx

RADIUS, MU, GRAVITY = 0.05, 0.3, 10.0  # m, -, m/s²
SPEED = 1.0  # m/s
STEP = 1e-3  # s
SETTLE, STEPS = 150, 1000

SCENE = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -{gravity}" cone="{cone}" iterations="6" ls_iterations="8"/>
  <worldbody>
    <geom name="ice" type="plane" size="9 9 0.1"/>
    <body pos="0 0 0.00985">
      <freejoint/>
      <geom name="puck" type="cylinder" size="{radius} 0.01" mass="0.17" condim="{condim}" priority="1"
            friction="{mu} 1e-6 0"/>
    </body>
  </worldbody>
</mujoco>
"""


def scene(cone: str, condim: int) -> Any:
    """A model of MuJoCo."""
    numbers = {"step": STEP, "gravity": GRAVITY, "radius": RADIUS, "mu": MU}
    return mujoco.MjModel.from_xml_string(SCENE.format(cone=cone, condim=condim, **numbers))


def thrower(model: Any, feet: tribos.mjx.Feet | None) -> Any:
    """The travel to rest by the spin, in m, as a function of JAX."""
    m = mjx.put_model(model)

    def step(d: Any) -> Any:
        return mjx.step(m, d) if feet is None else tribos.mjx.step(m, d, feet)

    def travel(spin: Any) -> Any:
        launch = jnp.array([SPEED, 0.0, 0.0, 0.0, 0.0, 0.0]).at[5].set(spin)

        def advance(d: Any, index: Any) -> Any:
            d = step(d.replace(qvel=jnp.where(index == SETTLE, launch, d.qvel)))
            return d, d.qpos[0]

        d = mjx.make_data(m)
        start = d if feet is None else feet.start(d)
        _, places = jax.lax.scan(advance, start, jnp.arange(SETTLE + STEPS))
        return places[-1] - places[SETTLE - 1]

    return travel


def main() -> None:
    puck = tribos.Friction(tribos.disk(RADIUS), mu=MU)
    model = scene("pyramidal", 1)
    feet = tribos.mjx.feet(model, {"puck": puck}, floor="ice")
    on_patch = thrower(model, feet)
    found = (
        on_patch,
        thrower(scene("elliptic", 4), None),
        thrower(scene("pyramidal", 4), None),
    )
    spins = [0.0, 5.0, 12.5, 25.0, 50.0]
    exact = tribos.slide(puck, SPEED, spins, gravity=GRAVITY)
    travels = [jax.jit(jax.vmap(travel))(jnp.array(spins)) for travel in found]
    print("spin rad/s   exact m     tribos.mjx   elliptic cone   pyramid")
    for index, spin in enumerate(spins):
        distance = float(exact.distance[index])
        errors = "".join(f"{float(one[index]) / distance - 1.0:+15.2%}" for one in travels)
        print(f"{spin:10.1f}{distance:10.4f}{errors}")
    slope = jax.jit(lambda spin: jax.jvp(on_patch, (spin,), (1.0,))[1])(12.5)
    by_spin = tribos.slide_jacobian(puck, SPEED, 12.5, gravity=GRAVITY).distance_by.spin
    print(f"travel by spin at 12.5 rad/s: {float(slope):.6f} m s, exact {float(by_spin):.6f} m s")


if __name__ == "__main__":
    main()
