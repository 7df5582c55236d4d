"""MJX 3.17.0: a body on three balls that slides and spins at 140 rad/s becomes NaN. No contact is needed: free in space its wobble grows without end.

Euler takes the gyroscopic torque from the start of a step, in MuJoCo as in MJX: a step of dt multiplies the spin across the axis by sqrt(1 + (wobble dt)^2),
with wobble = (upright/level - 1) spin. In MuJoCo 4.0.0 integrator="implicitfast" has the gyroscopic derivatives of a free body, and damps the wobble. In MJX it
lacks them and changes nothing. MuJoCo with Euler ends as badly, a million metres away; nan here if it restarts. RK4 keeps the wobble in both.
"""

import math

import jax
import mujoco
from mujoco import mjx

SPIN, UPRIGHT, LEVEL, DT = -140.625, 0.01016, 0.55 * 0.01016, 1e-3
FEET = ((0, -0.1), (0.0866025403784439, 0.05), (-0.0866025403784439, 0.05))
SLID = 19.2529074227849  # m: three_ball, -140.625 of v1/answers.csv


def scene(integrator, is_free):
    balls = "".join(f'<geom type="sphere" size="0.01" pos="{x} {y} 0" mass="0"/>' for x, y in FEET)
    return mujoco.MjModel.from_xml_string(f"""
<mujoco>
  <option timestep="{DT}" cone="elliptic" integrator="{integrator}" gravity="0 0 {0 if is_free else -9.8}"/>
  <default><geom friction="0.9 0 0"/></default>
  <worldbody>
    {"" if is_free else '<geom type="plane" size="99 99 1"/>'}
    <body pos="0 0 0.01"><freejoint/><inertial pos="0 0 {0 if is_free else 0.01}" mass="1" diaginertia="{LEVEL} {LEVEL} {UPRIGHT}"/>{balls}</body>
  </worldbody>
</mujoco>""")


def in_mujoco(model, launch, settled, steps):
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=settled)
    data.qvel[:], start = launch, data.qpos[0]
    mujoco.mj_step(model, data, nstep=steps)
    has_restarted = data.time < (settled + steps - 1) * DT
    return math.nan if has_restarted else data.qpos[0] - start, math.hypot(*data.qvel[3:5])


def in_mjx(model, launch, settled, steps):
    device, data = mjx.put_model(model, impl="jax"), mjx.put_data(model, mujoco.MjData(model), impl="jax")
    advance = jax.jit(lambda data, n: jax.lax.fori_loop(0, n, lambda _, data: mjx.step(device, data), data))
    data = advance(data, settled)
    start, data = float(data.qpos[0]), advance(data.replace(qvel=jax.numpy.array(launch)), steps)
    return float(data.qpos[0]) - start, math.hypot(*map(float, data.qvel[3:5]))


growth = (1 + ((UPRIGHT / LEVEL - 1) * SPIN * DT) ** 2) ** (0.5 / DT)
print(f"exact: spin across the axis, free, 1 s after 1 rad/s: 1 rad/s; Euler's growth makes that {growth:.1f}. On the floor: {SLID:.3f} m")
for integrator in ("Euler", "implicitfast", "RK4"):
    for name, run in (("MuJoCo", in_mujoco), ("MJX", in_mjx)):
        _, across = run(scene(integrator, True), [0.0, 0, 0, 1, 0, SPIN], 0, round(1 / DT))
        along, _ = run(scene(integrator, False), [15.0, 0, 0, 0, 0, SPIN], round(0.5 / DT), 4476)
        print(f"{name}, {integrator}: free {across:.4g} rad/s, on the floor {along:.5g} m", flush=True)
