"""Spinning pucks in Newton: their travel on an exact patch and with the solver's own friction.

    python newton_puck.py

Each launch is a world of one `newton.Model`. `tribos.warp.attach` finds the MuJoCo Warp model in the
solver; Newton needs no contact settings of its own for it.
"""

from __future__ import annotations

import newton
import numpy as np
import tribos
import tribos.warp
import warp as wp

RADIUS, MU, GRAVITY = 0.05, 0.3, 10.0  # m, -, m/s²
SPEED = 1.0  # m/s
STEP = 1e-3  # s
SPINS = np.array([0.0, 5.0, 12.5, 25.0, 50.0])  # rad/s
PUCK = tribos.Friction(tribos.disk(RADIUS), mu=MU)


def worlds() -> newton.Model:
    """A puck on ice in each world."""
    contact = newton.ModelBuilder.ShapeConfig(density=1000.0, mu=MU, mu_torsional=0.0)
    one = newton.ModelBuilder(gravity=(0.0, 0.0, -GRAVITY))
    body = one.add_body(xform=wp.transform(wp.vec3(0.0, 0.0, 0.01), wp.quat_identity()))
    one.add_shape_cylinder(body, radius=RADIUS, half_height=0.01, cfg=contact, label="puck")
    many = newton.ModelBuilder(gravity=(0.0, 0.0, -GRAVITY))
    many.add_ground_plane(cfg=contact, label="ice")
    many.replicate(one, len(SPINS))
    return many.finalize()


def simulated(*, is_exact: bool, steps: int = 1000) -> np.ndarray:
    """Travel to rest in Newton, in m."""
    model = worlds()
    solver = newton.solvers.SolverMuJoCo(model, cone="elliptic")
    if is_exact:
        geoms = [solver.mj_model.geom(i).name for i in range(solver.mj_model.ngeom)]
        ice, puck = sorted(geoms)
        tribos.warp.attach(solver, {puck: PUCK}, ice)
    now, after, control = model.state(), model.state(), model.control()
    start = now.joint_q.numpy()
    for number in range(200 + steps):
        if number == 200:  # it has settled
            start = now.joint_q.numpy().copy()
            launch = np.zeros((len(SPINS), 6), np.float32)
            launch[:, 0], launch[:, 5] = SPEED, SPINS
            now.joint_qd.assign(launch.ravel())
            newton.eval_fk(model, now.joint_q, now.joint_qd, now)
        now.clear_forces()
        solver.step(now, after, control, None, STEP)
        now, after = after, now
    shift = (now.joint_q.numpy() - start).reshape(len(SPINS), 7)
    return np.hypot(shift[:, 0], shift[:, 1])


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
