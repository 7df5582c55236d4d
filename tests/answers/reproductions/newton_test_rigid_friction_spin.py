"""A test in the form of newton/tests: a box that slides and spins stops where Coulomb's law on its face says.

The stopping distance of a box that slides straight is right whatever carries the box. With spin it is not: points at the corners have 1.85
times the torque of the face, and the box turns too little. Travel and angle are the reference answers of item `box`, spins 5 and 25.
"""

import unittest

import newton
import numpy as np
import warp as wp
from newton.tests.unittest_utils import add_function_test, get_test_devices

MU, GRAVITY, HALF, HALF_HEIGHT, SPEED = 0.3, -10.0, 0.05, 0.01, 1.0
# Spin, rad/s: travel, m, and angle until rest, rad.
ANSWERS = {5.0: (0.170176815381355, 1.12726859648442), 25.0: (0.259099547639324, 6.63724362402432)}
DT, SETTLE, SLIDE = 1.0 / 1200.0, 480, 1200  # s, steps
TRAVEL_TOL, ANGLE_TOL = 0.05, 0.1

SOLVERS = {
    "xpbd": lambda model: newton.solvers.SolverXPBD(model, iterations=10),
    "vbd": lambda model: newton.solvers.SolverVBD(model, iterations=10),
    "mujoco_warp": lambda model: newton.solvers.SolverMuJoCo(model, use_mujoco_contacts=False, cone="elliptic", impratio=10.0),
}


def test_friction_spinning_box(test, device, solver_fn):
    builder = newton.ModelBuilder(gravity=(0.0, 0.0, GRAVITY))
    vars(builder.default_shape_cfg).update(mu=MU, density=0.0, mu_torsional=0.0, mu_rolling=0.0, ke=1.0e6)
    builder.add_ground_plane()
    upright = 2.0 * HALF * HALF / 3.0
    for i in range(len(ANSWERS)):
        # The centre of mass lies in the plane of contact, so that nothing leans.
        body = builder.add_body(
            xform=wp.transform((0.0, 2.0 * i, HALF_HEIGHT), wp.quat_identity()),
            mass=1.0,
            com=(0.0, 0.0, -HALF_HEIGHT),
            inertia=wp.diag(wp.vec3(0.55 * upright, 0.55 * upright, upright)),
            lock_inertia=True,
        )
        builder.add_shape_box(body, hx=HALF, hy=HALF, hz=HALF_HEIGHT)
    builder.color()
    model = builder.finalize(device=device)
    solver, pipeline = solver_fn(model), newton.CollisionPipeline(model)
    now, new, control, contacts = model.state(), model.state(), model.control(), pipeline.contacts()

    def simulate(steps):
        nonlocal now, new
        turned = np.zeros(len(ANSWERS))
        for _ in range(steps):
            now.clear_forces()
            pipeline.collide(now, contacts)
            solver.step(now, new, control, contacts, DT)
            now, new = new, now
            turned += now.body_qd.numpy()[:, 5] * DT
        return turned

    simulate(SETTLE)
    start, launch = now.body_q.numpy().copy(), now.body_qd.numpy()
    launch[:] = 0.0
    launch[:, 0], launch[:, 5] = SPEED, list(ANSWERS)
    now.body_qd.assign(launch)
    if isinstance(solver, newton.solvers.SolverMuJoCo):
        newton.eval_ik(model, now, now.joint_q, now.joint_qd)
    turned = simulate(SLIDE)
    travelled = np.linalg.norm(now.body_q.numpy()[:, :2] - start[:, :2], axis=1)
    for i, (spin, (travel, angle)) in enumerate(ANSWERS.items()):
        off = travelled[i] / travel - 1.0, turned[i] / angle - 1.0
        told = f"spin {spin}: travel {travelled[i]:.4f} m ({off[0]:+.1%}), angle {turned[i]:.3f} rad ({off[1]:+.1%})"
        with test.subTest(spin=spin):
            test.assertLess(abs(off[0]), TRAVEL_TOL, told)
            test.assertLess(abs(off[1]), ANGLE_TOL, told)


class TestRigidFrictionSpin(unittest.TestCase):
    pass


for name, solver_fn in SOLVERS.items():
    add_function_test(TestRigidFrictionSpin, f"test_friction_spinning_box_{name}", test_friction_spinning_box, devices=get_test_devices(), solver_fn=solver_fn)

if __name__ == "__main__":
    unittest.main(verbosity=2)
