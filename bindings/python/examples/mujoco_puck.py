"""A puck in MuJoCo that slides and spins: its travel on an exact patch and with MuJoCo's own friction.

    python mujoco_puck.py

A spinning puck travels farther, because friction of each part of its face opposes that part's own
motion. The exact travel is the integral of the equation of motion with `tribos.Friction`.
"""

from __future__ import annotations

import mujoco
import numpy as np
import tribos
import tribos.mujoco

RADIUS, MU, GRAVITY = 0.05, 0.3, 10.0  # m, -, m/s²
SPEED = 1.0  # m/s
STEP = 1e-3  # s

SCENE = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -{gravity}" cone="{cone}"/>
  <default><geom friction="{mu} 1e-6 0" condim="4"/></default>
  <worldbody>
    <geom name="ice" type="plane" size="9 9 0.1"/>
    <body pos="0 0 0.01">
      <freejoint/>
      <geom name="puck" type="cylinder" size="{radius} 0.01" mass="0.17"/>
    </body>
  </worldbody>
</mujoco>
"""


def simulated(spin: float, cone: str, *, is_exact: bool) -> float:
    """Travel to rest in MuJoCo, in m."""
    text = SCENE.format(step=STEP, gravity=GRAVITY, cone=cone, mu=MU, radius=RADIUS)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    puck = {"puck": tribos.Friction(tribos.disk(RADIUS), mu=MU)}
    feet = tribos.mujoco.attach(model, data, puck, floor="ice") if is_exact else None
    mujoco.mj_step(model, data, nstep=500)  # settles
    start = data.qpos[0]
    data.qvel[:] = [SPEED, 0.0, 0.0, 0.0, 0.0, spin]
    mujoco.mj_step(model, data, nstep=2000)
    if feet is not None:
        feet.close()
    return float(data.qpos[0] - start)


def exact(spin: float, *, steps: int = 20_000) -> float:
    """Travel to rest of the equation of motion, in m, by Runge and Kutta's method of fourth order."""
    puck = tribos.Friction(tribos.disk(RADIUS), mu=MU)
    per_mass = np.array([1.0, 1.0, 2.0 / RADIUS**2])
    dt = 1.0 / steps

    def rate(twist: np.ndarray) -> np.ndarray:
        return puck.wrench(twist, load=GRAVITY) * per_mass

    twist, travel = np.array([SPEED, 0.0, spin]), 0.0
    while twist[0] > 1e-4:
        a = rate(twist)
        b = rate(twist + 0.5 * dt * a)
        c = rate(twist + 0.5 * dt * b)
        d = rate(twist + dt * c)
        after = twist + dt / 6.0 * (a + 2.0 * b + 2.0 * c + d)
        travel += 0.5 * dt * (twist[0] + after[0]) - dt * dt / 12.0 * (d[0] - a[0])
        twist = after
    return travel


def main() -> None:
    print("spin rad/s   exact m   tribos.mujoco   elliptic cone   pyramid")
    for spin in (0.0, 5.0, 12.5, 25.0, 50.0):
        travel = exact(spin)
        found = (
            simulated(spin, "elliptic", is_exact=True),
            simulated(spin, "elliptic", is_exact=False),
            simulated(spin, "pyramidal", is_exact=False),
        )
        errors = "".join(f"{one / travel - 1.0:+15.2%}" for one in found)
        print(f"{spin:10.1f}{travel:10.4f}{errors}")


if __name__ == "__main__":
    main()
