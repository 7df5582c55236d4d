"""A test in the form of Genesis' tests (pytest): a box that slides and spins stops where Coulomb's law on its face says.

Travel and angle are the reference answers of item `box`, spins 5 and 25. Corners carry the box with 1.85 times the torque of its face.
"""

import genesis as gs
import numpy as np
import pytest

MU, GRAVITY, HALF, HALF_HEIGHT, SPEED = 0.3, -10.0, 0.05, 0.01, 1.0
DT, SETTLE, SLIDE = 2e-3, 250, 500  # s, steps


@pytest.fixture(scope="module", autouse=True)
def backend():
    gs.init(backend=gs.cpu, logging_level="error")


@pytest.mark.parametrize("cone", ["pyramidal", "elliptic"])
@pytest.mark.parametrize("spin, travel, angle", [(5.0, 0.170176815381355, 1.12726859648442), (25.0, 0.259099547639324, 6.63724362402432)])
def test_spinning_box_stops(cone, spin, travel, angle):
    scene = gs.Scene(
        sim_options=gs.options.SimOptions(dt=DT, gravity=(0.0, 0.0, GRAVITY)),
        rigid_options=gs.options.RigidOptions(friction_cone=getattr(gs.friction_cone, cone)),
        show_viewer=False,
    )
    scene.add_entity(gs.morphs.Plane(), material=gs.materials.Rigid(friction=MU))
    box = scene.add_entity(
        gs.morphs.Box(size=(2 * HALF, 2 * HALF, 2 * HALF_HEIGHT), pos=(0.0, 0.0, HALF_HEIGHT)), material=gs.materials.Rigid(friction=MU, rho=5000.0)
    )
    scene.build()
    for _ in range(SETTLE):
        scene.step()
    start = box.get_pos().cpu().numpy()
    box.set_dofs_velocity(np.array([SPEED, 0.0, 0.0, 0.0, 0.0, spin]))
    turned = 0.0
    for _ in range(SLIDE):
        scene.step()
        turned += float(box.get_ang()[2]) * DT
    way = np.linalg.norm((box.get_pos().cpu().numpy() - start)[:2])
    told = f"travel {way:.4f} m ({way / travel - 1:+.1%}), angle {turned:.3f} rad ({turned / angle - 1:+.1%})"
    assert abs(way / travel - 1) < 0.05 and abs(turned / angle - 1) < 0.1, told
