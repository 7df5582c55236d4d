"""A capsule between two fingers in MuJoCo: how far it slips in ten seconds.

    python mujoco_capsule.py

Friction could carry many times the weight. MuJoCo's soft contacts let the capsule creep all the
same; on exact patches it stands still.
"""

from __future__ import annotations

import mujoco
import tribos
import tribos.mujoco

MASS, GRAVITY, MU = 0.1, 9.81, 1.0  # kg, m/s², -

SCENE = """
<mujoco>
  <option timestep="0.002" cone="{cone}" noslip_iterations="{noslip}"/>
  <default><geom friction="{mu} 0.005 0.0001" condim="4"/></default>
  <worldbody>
    <body pos="-0.03 0 0" gravcomp="1">
      <joint name="left" type="slide" axis="1 0 0" damping="20"/>
      <geom name="left" type="box" size="0.01 0.02 0.02" mass="0.2"/>
    </body>
    <body pos="0.03 0 0" gravcomp="1">
      <joint name="right" type="slide" axis="-1 0 0" damping="20"/>
      <geom name="right" type="box" size="0.01 0.02 0.02" mass="0.2"/>
    </body>
    <body>
      <freejoint/>
      <geom name="capsule" type="capsule" size="0.02 0.05" mass="{mass}"/>
    </body>
  </worldbody>
  <actuator><motor joint="left"/><motor joint="right"/></actuator>
</mujoco>
"""


def slip(
    margin: float, *, cone: str = "elliptic", noslip: int = 0, is_exact: bool = False
) -> float:
    """Fall of the capsule between 1 s and 10 s, in m, where friction can carry `margin` times its weight."""
    text = SCENE.format(cone=cone, noslip=noslip, mu=MU, mass=MASS)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    data.ctrl[:] = margin * MASS * GRAVITY / (2.0 * MU)
    finger = tribos.Friction(tribos.disk(0.005), mu=MU)
    fingers = {"left": finger, "right": finger}
    feet = tribos.mujoco.attach(model, data, fingers, floor="capsule") if is_exact else None
    mujoco.mj_step(model, data, nstep=500)
    start = data.qpos[4]
    mujoco.mj_step(model, data, nstep=4500)
    if feet is not None:
        feet.close()
    return float(start - data.qpos[4])


def main() -> None:
    print("margin   tribos.mujoco   elliptic cone   with noslip   pyramid")
    for margin in (2.0, 20.0, 95.0):
        found = (
            slip(margin, is_exact=True),
            slip(margin),
            slip(margin, noslip=10),
            slip(margin, cone="pyramidal"),
        )
        print(f"{margin:6.0f}" + "".join(f"{one:14.1e} m" for one in found))


if __name__ == "__main__":
    main()
