"""MuJoCo Warp 4.0.0, as MuJoCo: a cylinder as high as wide that slides and spins on its face hops, lands on its rim, gets up on it and falls over.

Two causes. Slip pushes bodies up: contacts of 0.02 s, the default, bear 86 N at launch where the cylinder weighs 9.8 N, and it is in the air by the third step.
And its three contacts lie on the rim at 120 degrees, the first at the lowest point, so that they run round with the lean: it rolls on one of them, and a body
that spins on one point rises, as a spinning egg does. Three balls fixed under the rim keep it upright, as do contacts of 0.2 s: it then turns as far as points
on the rim let it.
"""

import math

import mujoco
import mujoco_warp
import numpy as np
import warp

MU, G, R, H, UPRIGHT, DT = 0.2, 9.81, 0.08, 0.08, 0.0032, 1e-3
EXACT = 40.7699124478181  # rad: tall, 50 of v1/answers.csv, pressure linear over the face
warp.config.log_level = warp.LOG_WARNING
warp.set_device("cpu")


def scene(shape, solref):
    angles = (0, 2 * math.pi / 3, 4 * math.pi / 3)
    balls = "".join(f'<geom type="sphere" size="0.002" pos="{R * math.cos(a)} {R * math.sin(a)} {0.002 - H}" mass="0"/>' for a in angles)
    geoms = balls if shape == "balls" else f'<geom type="cylinder" size="{R} {H}" mass="0"/>'
    level = 0.5 * UPRIGHT + H**2 / 3
    model = mujoco.MjModel.from_xml_string(f"""<mujoco>
      <option timestep="{DT}" cone="elliptic" gravity="0 0 -{G}"/><default><geom friction="{MU} 0 0" solref="{solref}"/></default>
      <worldbody><geom type="plane" size="9 9 1"/>
        <body pos="0 0 {H}"><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="{level} {level} {UPRIGHT}"/>{geoms}</body></worldbody>
    </mujoco>""")
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=round(0.5 / DT))
    data.qvel[:] = [1, 0, 0, 0, 0, 50]
    return model, data


def turned(step, qpos, qvel):
    angle = lean = 0.0
    for _ in range(round(3 / DT)):
        step()
        turn = np.zeros(9)
        mujoco.mju_quat2Mat(turn, np.array(qpos[3:7], dtype=float))
        angle, lean = angle + turn[6:] @ qvel[3:] * DT, max(lean, math.acos(max(-1, min(1, turn[8]))))
    return f"turns {angle:.1f} rad, leans by {math.degrees(lean):.0f} degrees"


def on_warp(model, data):
    its, state = mujoco_warp.put_model(model), mujoco_warp.put_data(model, data, nconmax=16, njmax=64)
    with warp.ScopedCapture() as capture:
        mujoco_warp.step(its, state)
    return turned(lambda: warp.capture_launch(capture.graph), state.qpos.numpy()[0], state.qvel.numpy()[0])


print(f"exact: {EXACT:.2f} rad, upright")
for shape, solref in (("cylinder", "0.02 1"), ("cylinder", "0.2 1"), ("balls", "0.02 1")):
    model, data = scene(shape, solref)
    print(f"{shape}, solref {solref}: MuJoCo Warp {on_warp(model, data)}; MuJoCo {turned(lambda: mujoco.mj_step(model, data), data.qpos, data.qvel)}")
model, data = scene("cylinder", "0.02 1")
for i in range(1, 701):
    mujoco.mj_step(model, data)
    force, loads = np.zeros(6), []
    for j, contact in enumerate(data.contact):
        mujoco.mj_contactForce(model, data, j, force)
        x, y, _ = contact.pos - data.qpos[:3]
        loads.append(f"{force[0]:.0f} N at {math.degrees(math.atan2(y, x)):.0f} degrees of the rim")
    if i in (1, 3) or (i % 100 == 0 and loads):
        print(f"MuJoCo, step {i}, {1e3 * (data.qpos[2] - H):.2f} mm up:", ", ".join(loads) or "in the air")
