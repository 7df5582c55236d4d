"""A body on three balls in MuJoCo: a spinning one travels farther.

    python mujoco_three_ball.py

The body is one foot of three points, or three feet whose loads MuJoCo finds itself. Its centre of mass is as
low as the floor, such that the loads stay equal and the exact answer is that of `tribos.points`.
"""

from __future__ import annotations

import mujoco
import numpy as np
import tribos
import tribos.mujoco

MU, GRAVITY, GYRATION_SQ = 0.3, 10.0, 0.005  # -, m/s², m²
SPEED = 1.0  # m/s
ANGLES = np.radians([90.0, 210.0, 330.0])
BALLS = 0.1 * np.column_stack((np.cos(ANGLES), np.sin(ANGLES)))  # m
NAMES = ("a", "b", "c")


def scene(cone: str) -> str:
    balls = "".join(
        f'<geom name="{name}" type="sphere" size="0.01" pos="{x} {y} 0" mass="0"/>'
        for name, (x, y) in zip(NAMES, BALLS, strict=True)
    )
    return f"""
<mujoco>
  <option timestep="0.001" gravity="0 0 -{GRAVITY}" cone="{cone}"/>
  <default><geom friction="{MU} 0 0"/></default>
  <worldbody>
    <geom name="floor" type="plane" size="9 9 0.1"/>
    <body pos="0 0 0.01">
      <freejoint/>
      <inertial pos="0 0 -0.01" mass="1" diaginertia="0.003 0.003 {GYRATION_SQ}"/>
      {balls}
    </body>
  </worldbody>
</mujoco>"""


def simulated(spin: float, feet: dict, *, cone: str = "elliptic") -> float:
    """Travel to rest in MuJoCo, in m; without feet with its own friction."""
    model = mujoco.MjModel.from_xml_string(scene(cone))
    data = mujoco.MjData(model)
    attached = tribos.mujoco.attach(model, data, feet, floor="floor") if feet else None
    mujoco.mj_step(model, data, nstep=500)  # settles
    start = data.xipos[1].copy()
    data.qvel[:] = [SPEED, 0.0, 0.0, 0.0, 0.0, spin]
    mujoco.mj_step(model, data, nstep=2500)
    if attached is not None:
        attached.close()
    return float(np.linalg.norm(data.xipos[1] - start))


def exact(spin: float, *, dt: float = 5e-5) -> float:
    """Travel to rest of the equation of motion, in m, by the midpoint rule."""
    body = tribos.Friction(tribos.points(BALLS), mu=MU)
    per_mass = np.array([1.0, 1.0, 1.0 / GYRATION_SQ])

    def rate(twist: np.ndarray, angle: float) -> np.ndarray:
        cosine, sine = np.cos(angle), np.sin(angle)
        turned = np.array([[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]])
        return turned.T @ body.wrench(turned @ twist, load=GRAVITY) * per_mass

    place, twist = np.zeros(3), np.array([SPEED, 0.0, spin])
    while np.hypot(np.hypot(twist[0], twist[1]), 0.1 * twist[2]) > 5e-4:
        half = twist + 0.5 * dt * rate(twist, place[2])
        twist = twist + dt * rate(half, place[2] + 0.5 * dt * twist[2])
        place = place + dt * half
    return float(np.linalg.norm(place[:2]))


def main() -> None:
    one = {NAMES: tribos.Friction(tribos.points(BALLS), mu=MU)}
    each = {name: tribos.Friction(tribos.disk(1e-5), mu=MU) for name in NAMES}
    print("spin rad/s   exact m   one foot   three feet   elliptic cone   pyramid")
    for spin in (0.0, 3.0, 12.5, 50.0):
        travel = exact(spin)
        found = (
            simulated(spin, one),
            simulated(spin, each),
            simulated(spin, {}),
            simulated(spin, {}, cone="pyramidal"),
        )
        errors = "".join(f"{value / travel - 1.0:+13.2%}" for value in found)
        print(f"{spin:10.1f}{travel:10.4f}{errors}")


if __name__ == "__main__":
    main()
