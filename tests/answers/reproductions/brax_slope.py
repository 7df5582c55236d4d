"""Brax 0.14.2: in pipeline spring a cube below its angle of friction creeps down a slope, 4 to 13 cm/s in steps of 5 ms and 0.7 to 2 cm/s in steps of 1 ms.

brax.spring.collisions.resolve gives each contact the impulse that would end its slip if it were alone, the slip times a corner's effective mass, and takes the
mean over the contacts. A corner of a cube has a quarter of its mass, so a step ends a quarter of the slip, and the cube keeps 3 g sin(angle) dt, and more where
the uphill corners reach their limit. The same mean lets it sink. An argument names another pipeline: generalized creeps at 1.4 mm/s; in positional the cube is
at 1.9 m/s after a second at 0.9 of the angle in steps of 1 ms, and hops in steps of 5 ms.
"""

import importlib
import math
import sys

import jax
from brax.io import mjcf

MU, G, HALF = 0.5, 9.81, 0.05
NAME = sys.argv[1] if len(sys.argv) > 1 else "spring"
pipeline = importlib.import_module(f"brax.{NAME}.pipeline")
start, step = jax.jit(pipeline.init), jax.jit(pipeline.step)

for dt in (5e-3, 1e-3):
    flat = mjcf.loads(f"""
<mujoco>
  <option timestep="{dt}" gravity="0 0 -{G}"/>
  <default><geom friction="{MU} 0 0"/></default>
  <worldbody>
    <geom type="plane" size="9 9 1"/>
    <body pos="0 0 {HALF}"><freejoint/><geom type="box" size="{HALF} {HALF} {HALF}" mass="1"/></body>
  </worldbody>
</mujoco>""")
    settled = start(flat, flat.init_q, jax.numpy.zeros(6))
    for _ in range(round(0.5 / dt)):
        settled = step(flat, settled, jax.numpy.zeros(0))
    for share in (0.5, 0.9, 0.99, 1.01, 1.1):
        angle = share * math.atan(MU)
        slope = flat.replace(gravity=jax.numpy.array([G * math.sin(angle), 0, -G * math.cos(angle)]))
        state, places = settled, []
        for _ in range(round(1 / dt)):
            state = step(slope, state, jax.numpy.zeros(0))
            places.append(float(state.q[0]))
        slid, creep, sunk = places[-1] - float(settled.q[0]), 2 * (places[-1] - places[len(places) // 2 - 1]), HALF - float(state.q[2])
        # In the first second.
        exact = max(0.0, G * (math.sin(angle) - MU * math.cos(angle)) / 2)
        quarter = f"; 3 g sin(angle) dt: {3 * G * math.sin(angle) * dt:.4f} m/s" if NAME == "spring" and exact == 0 else ""
        print(
            f"{NAME}, {dt} s, {share} of the angle: slid {slid:.4f} m, exactly {exact:.4f} m; {creep:.4f} m/s in the second half; sunk {sunk:.4f} m{quarter}",
            flush=True,
        )
