"""Feet in Newton's SolverMuJoCo, on the processor: travel against the exact motion.

TRIBOS_LONG=1, as Warp compiles all of Newton's kernels; that a solver's parts are found is tested with MuJoCo Warp.
"""

from __future__ import annotations

import tempfile
import warnings
from pathlib import Path

import numpy as np
import pytest
import tribos
from conftest import LONG

if not LONG:
    pytest.skip("takes long: TRIBOS_LONG=1", allow_module_level=True)
wp = pytest.importorskip("warp")
newton = pytest.importorskip("newton")
pytest.importorskip("mujoco_warp")

wp.config.kernel_cache_dir = str(Path(tempfile.gettempdir()) / "tribos-warp-kernels")
wp.config.log_level = wp.LOG_WARNING
wp.config.optimization_level = 0

import tribos.warp as tw  # noqa: E402

MU, STEP = 0.3, 0.004
SPINS = np.array([0.0, 5.0, 12.5, 25.0, 50.0])
PATCHES = [tribos.disk(0.05), tribos.box(0.1, 0.06)]


def worlds():
    """A puck and a box in each of five worlds, with Newton's own contact settings."""
    one = newton.ModelBuilder()
    shape = newton.ModelBuilder.ShapeConfig(density=1000.0)
    for name, y in (("puck", 0.0), ("box", 5.0)):
        at = wp.transform(wp.vec3(0.0, y, 0.01), wp.quat_identity())
        body = one.add_body(xform=at, label=name)
        if name == "puck":
            one.add_shape_cylinder(body, radius=0.05, half_height=0.01, cfg=shape, label=name)
        else:
            one.add_shape_box(body, hx=0.05, hy=0.03, hz=0.01, cfg=shape, label=name)
    many = newton.ModelBuilder()
    many.add_ground_plane(label="ice")
    many.replicate(one, len(SPINS))
    return many.finalize()


def test_travel_is_exact_but_for_half_a_step_of_the_position():
    with wp.ScopedDevice("cpu"), warnings.catch_warnings():
        # Newton asks for another version of MuJoCo.
        warnings.simplefilter("ignore")
        model = worlds()
        solver = newton.solvers.SolverMuJoCo(model)
        names = solver.mj_model
        geoms = [names.geom(i).name for i in range(names.ngeom)]
        named = {key: next(g for g in geoms if key in g) for key in ("ice", "puck", "box")}
        given = {
            named[key]: tribos.Friction(patch, mu=MU)
            for key, patch in zip(("puck", "box"), PATCHES)
        }
        feet = tw.attach(solver, given, named["ice"])
        now, after = model.state(), model.state()
        control = model.control()

        def run(state, other, count):
            for _ in range(count):
                state.clear_forces()
                solver.step(state, other, control, None, STEP)
                state, other = other, state
            return state, other

        now, after = run(now, after, 40)
        start = now.joint_q.numpy().reshape(len(SPINS), 2, 7).copy()
        motion = np.zeros((len(SPINS), 2, 6), np.float32)
        motion[:, :, 0], motion[:, :, 5] = 1.0, SPINS[:, None]
        now.joint_qd.assign(motion.ravel())
        newton.eval_fk(model, now.joint_q, now.joint_qd, now)
        loads = feet.load.numpy()
        now, after = run(now, after, 200)
        end = now.joint_q.numpy().reshape(len(SPINS), 2, 7)
    travel = np.hypot(*(end - start)[:, :, :2].T)
    for number, patch in enumerate(PATCHES):
        mass, inertia = names.body_mass[number + 1], names.body_inertia[number + 1].max()
        weight = 9.81 * mass
        assert np.abs(loads[:, number] / weight - 1).max() < 2e-3
        body = tribos.PlanarBody(tribos.Friction(patch, mu=MU), mass, inertia, load=weight)
        twists = np.stack([np.ones_like(SPINS), 0 * SPINS, SPINS], axis=1)
        poses = np.asarray(body.rollout(twists, np.zeros((len(SPINS), 8000, 3)), 1e-4).poses)
        wanted = np.hypot(*poses[:, -1, :2].T)
        error = travel[number] - wanted
        assert (np.abs(error) < 0.5 * STEP + 1e-3 * wanted).all(), error
    assert feet.held.numpy().all()
    feet.close()
