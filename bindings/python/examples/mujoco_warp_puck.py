"""Spinning pucks in MuJoCo Warp: their travel on an exact patch and with the engine's own friction.

    python mujoco_warp_puck.py

All launches are worlds of one simulation. `mujoco_puck.py` is the same in MuJoCo.
"""

from __future__ import annotations

import mujoco
import mujoco_warp as mjw
import numpy as np
import tribos
import tribos.warp
import warp as wp

RADIUS, MU, GRAVITY = 0.05, 0.3, 10.0  # m, -, m/s²
SPEED = 1.0  # m/s
STEP = 1e-3  # s
SPINS = np.array([0.0, 5.0, 12.5, 25.0, 50.0])  # rad/s

SCENE = f"""
<mujoco>
  <option timestep="{STEP}" gravity="0 0 -{GRAVITY}" cone="elliptic"/>
  <default><geom friction="{MU}"/></default>
  <worldbody>
    <geom name="ice" type="plane" size="9 9 0.1"/>
    <body pos="0 0 0.01">
      <freejoint/>
      <geom name="puck" type="cylinder" size="{RADIUS} 0.01" mass="0.17"/>
    </body>
  </worldbody>
</mujoco>
"""
PUCK = tribos.Friction(tribos.disk(RADIUS), mu=MU)


def simulated(*, is_exact: bool, steps: int = 1000) -> np.ndarray:
    """Travel to rest in MuJoCo Warp, in m."""
    names = mujoco.MjModel.from_xml_string(SCENE)
    given = mujoco.MjData(names)
    mujoco.mj_forward(names, given)
    model, data = mjw.put_model(names), mjw.put_data(names, given, nworld=len(SPINS))
    if is_exact:
        tribos.warp.attach((names, model, data), {"puck": PUCK}, "ice")
    for _ in range(200):  # settles
        mjw.step(model, data)
    start = data.qpos.numpy()[:, :2].copy()
    launch = np.zeros((len(SPINS), 6), np.float32)
    launch[:, 0], launch[:, 5] = SPEED, SPINS
    data.qvel.assign(launch)
    for _ in range(steps):
        mjw.step(model, data)
    return np.hypot(*(data.qpos.numpy()[:, :2] - start).T)


def exact() -> np.ndarray:
    """Travel to rest of the equation of motion, in m."""
    body = tribos.PlanarBody(PUCK, 1.0, 0.5 * RADIUS**2, load=GRAVITY)
    twists = np.stack([np.full(len(SPINS), SPEED), 0 * SPINS, SPINS], axis=1)
    poses = body.rollout(twists, np.zeros((len(SPINS), 20_000, 3)), 5e-5).poses
    return np.hypot(*np.asarray(poses)[:, -1, :2].T)


def main() -> None:
    travel = exact()
    with wp.ScopedDevice("cpu"):
        found = [simulated(is_exact=True), simulated(is_exact=False)]
    print("spin rad/s   exact m   tribos.warp   elliptic cone")
    for spin, one, patch, cone in zip(SPINS, travel, *found):
        print(f"{spin:10.1f}{one:10.4f}{patch / one - 1:+14.2%}{cone / one - 1:+16.2%}")


if __name__ == "__main__":
    main()
