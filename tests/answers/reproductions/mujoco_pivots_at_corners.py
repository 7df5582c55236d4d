"""MuJoCo: a box that spins on a plane stops after half of its angle, with any cone, step or number of iterations, since four corners carry it."""

import mujoco

MU, G, HALF, SPIN = 0.3, 9.81, 0.05, 12.5
# Torque of a square face under uniform pressure: mu m g times the mean distance of its elements from the middle.
EXACT = SPIN**2 / (2 * MU * G * 0.765196 * HALF / (2 * HALF**2 / 3))


def turned(cone, impratio, noslip, dt):
    model = mujoco.MjModel.from_xml_string(f"""
<mujoco>
  <option timestep="{dt}" cone="{cone}" impratio="{impratio}" noslip_iterations="{noslip}"/>
  <default><geom friction="{MU} 0 0"/></default>
  <worldbody>
    <geom type="plane" size="9 9 1"/>
    <body pos="0 0 0.01"><freejoint/><geom type="box" size="{HALF} {HALF} 0.01" mass="1"/></body>
  </worldbody>
</mujoco>""")
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=round(0.5 / dt))
    data.qvel[:] = [0, 0, 0, 0, 0, SPIN]
    angle = 0.0
    for _ in range(round(0.5 / dt)):
        mujoco.mj_step(model, data)
        angle += data.qvel[5] * dt
    return angle


print(f"exact: {EXACT:.4f} rad")
for case in (("pyramidal", 1, 0, 2e-3), ("elliptic", 1, 0, 1e-3), ("elliptic", 100, 10, 1e-3), ("elliptic", 100, 10, 1e-4)):
    print(*case, f"{turned(*case):.4f} rad")
