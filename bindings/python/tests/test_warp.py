"""Friction in Warp kernels, on the processor: against the kernel in float64, its derivatives, and the C header."""

from __future__ import annotations

import ctypes
import math
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import pytest
import tribos

wp = pytest.importorskip("warp")

wp.config.kernel_cache_dir = str(Path(tempfile.gettempdir()) / "tribos-warp-kernels")
wp.config.log_level = wp.LOG_WARNING
wp.config.optimization_level = 0

import tribos.warp as tw  # noqa: E402
from tribos.warp._logarithm import log_part  # noqa: E402

wp.set_module_options({"fuse_fp": False})

ROUND = ("disk", "ring", "punch", "hertz", "paraboloid")
# An L about a point beside its centroid, in float32.
CORNERS = np.float32(
    [[-0.04, -0.03], [0.06, -0.03], [0.06, 0.0], [-0.01, 0.0], [-0.01, 0.05], [-0.04, 0.05]]
)
LIMIT, RADIUS = float(np.float32(0.3)), float(np.float32(0.04))
A, B = float(np.float32(0.1)), float(np.float32(0.06))
MASS, INERTIA, STEP = (float(np.float32(x)) for x in (0.17, 1.5e-4, 0.02))
WEIGHT = np.array([1.0, 2.0, 30.0])
BOX, POLYGON = 5, 6


@wp.kernel
def wrenches(
    patch: int,
    twist: wp.array(dtype=wp.vec3),
    limit: wp.array(dtype=float),
    size: wp.array(dtype=float),
    corners: wp.array(dtype=wp.vec2),
    out: wp.array(dtype=wp.vec3),
):
    i = wp.tid()
    if patch == 5:
        out[i] = tw.box_wrench(twist[i], limit[i], A, B)
    elif patch == 6:
        out[i] = tw.polygon_wrench(twist[i], limit[i], corners)
    elif patch == 0:
        out[i] = tw.disk_wrench(twist[i], limit[i], size[i])
    else:
        out[i] = tw.round_wrench(patch, twist[i], limit[i], size[i])


@wp.kernel
def projections(
    patch: int,
    wrench: wp.array(dtype=wp.vec3),
    limit: wp.array(dtype=float),
    size: wp.array(dtype=float),
    length: wp.array(dtype=float),
    corners: wp.array(dtype=wp.vec2),
    out: wp.array(dtype=wp.vec3),
):
    i = wp.tid()
    if patch == 5:
        out[i] = tw.box_project(wrench[i], limit[i], A, B, length[i])
    elif patch == 6:
        out[i] = tw.polygon_project(wrench[i], limit[i], corners, length[i])
    else:
        out[i] = tw.round_project(patch, wrench[i], limit[i], size[i], length[i])


@wp.kernel
def steps(
    patch: int,
    twist: wp.array(dtype=wp.vec3),
    push: wp.array(dtype=wp.vec3),
    limit: wp.array(dtype=float),
    size: wp.array(dtype=float),
    mass: wp.array(dtype=float),
    inertia: wp.array(dtype=float),
    dt: wp.array(dtype=float),
    corners: wp.array(dtype=wp.vec2),
    out: wp.array(dtype=wp.vec3),
):
    i = wp.tid()
    if patch == 5:
        out[i] = tw.box_planar_friction(
            twist[i], push[i], limit[i], A, B, mass[i], inertia[i], dt[i]
        )
    elif patch == 6:
        out[i] = tw.polygon_planar_friction(
            twist[i], push[i], limit[i], corners, mass[i], inertia[i], dt[i]
        )
    else:
        out[i] = tw.round_planar_friction(
            patch, twist[i], push[i], limit[i], size[i], mass[i], inertia[i], dt[i]
        )


@wp.kernel
def manifolds(
    impulse: wp.array(dtype=wp.vec3), of: wp.array2d(dtype=float), out: wp.array(dtype=wp.vec3)
):
    i = wp.tid()
    out[i] = tw.manifold_friction(
        impulse[i], of[i, 0], of[i, 1], of[i, 2], of[i, 3], of[i, 4], tw.CURVE_AREA
    )


@wp.kernel(enable_backward=False)
def logarithms(z: wp.array(dtype=float), out: wp.array(dtype=float)):
    i = wp.tid()
    out[i] = log_part(z[i])


def on_device(values, dtype=float):
    return wp.array(np.array(values, np.float32), dtype=dtype, device="cpu", requires_grad=True)


def patch_of(kind, radius=RADIUS):
    if kind == BOX:
        return tribos.box(A, B)
    if kind == POLYGON:
        return tribos.polygon(CORNERS.astype(float))
    return getattr(tribos, ROUND[kind])(radius)


def lever(kind):
    patch = patch_of(kind)
    return patch.radius + math.hypot(*patch.centre)


def run(kernel, kind, *arguments, extra=True):
    """Values, and derivatives of the weighted sum by each array."""
    given = [on_device(x, wp.vec3 if np.ndim(x) == 2 else float) for x in arguments]
    count = len(arguments[0])
    out = wp.zeros(count, dtype=wp.vec3, device="cpu", requires_grad=True)
    corners = wp.array(CORNERS, dtype=wp.vec2, device="cpu")
    with wp.Tape() as tape:
        wp.launch(kernel, count, [kind, *given, corners], [out], device="cpu")
    tape.backward(grads={out: on_device(np.tile(WEIGHT, (count, 1)), wp.vec3)})
    return out.numpy().astype(float), [x.grad.numpy().astype(float) for x in given]


def spread(count, seed=0):
    """Twists over six decades, and those of kinks."""
    rng = np.random.default_rng(seed)
    twists = rng.normal(size=(count, 3)) * 10 ** rng.uniform(-3, 3, (count, 3))
    twists[:, 2] /= RADIUS
    special = [
        [0, 0, 0],
        [1, 0, 0],
        [0, -1, 0],
        [0, 0, 3],
        [1, 0, 25],
        [0.6, 0.8, -25],
        [1e-30, 0, 0],
        [1e-12, 0, 7],
        [1, 1, 1e-9],
        # Rotation about a corner and a point of an edge.
        *(np.array([y, -x, 1.0]) for x, y in ([A / 2, B / 2], [0, B / 2], [0.06, -0.03], [0, 0])),
    ]
    twists[: len(special)] = special
    return np.float32(twists).astype(float)


@pytest.mark.parametrize("kind", [0, 1, 2, 3, 4, BOX, POLYGON])
def test_a_wrench_is_that_of_the_kernel_and_so_are_its_derivatives(kind):
    twists = spread(20_000)
    count = len(twists)
    friction = tribos.Friction(patch_of(kind), mu=LIMIT)
    found, (slope, by_limit, by_radius) = run(
        wrenches, kind, twists, np.full(count, LIMIT), np.full(count, RADIUS)
    )
    units = LIMIT * np.array([1.0, 1.0, lever(kind)])
    wanted = friction.wrench(twists, 1.0)
    # Beside its centroid a polygon's motion rounds with the distance of the origin.
    bound = 6e-7 if kind == POLYGON else 3.2e-7
    assert (np.abs(found - wanted) / units).max() < bound
    assert (found[0] == 0).all()
    for derivative in (slope, by_limit, by_radius):
        assert np.isfinite(derivative).all() and (derivative[0] == 0).all()
    jacobian = friction.jacobian(twists, 1.0)
    moves = np.isfinite(jacobian).all((1, 2)) & np.any(twists, axis=1)
    scale = np.diag([1.0, 1.0, 1.0 / lever(kind)])
    size = np.abs(scale @ jacobian[moves] @ scale).max((1, 2))
    error = np.abs((slope[moves] - np.einsum("nij,i->nj", jacobian[moves], WEIGHT)) @ scale)
    error = error.max(1) / (size * WEIGHT[2] * lever(kind))
    # Next to equal speeds a ring's slope grows as ln z, and a punch's as √z: rounding of z shows.
    rim, speed = np.abs(twists[:, 2]) * RADIUS, np.hypot(*twists[:, :2].T)
    apart = np.abs(rim - speed) > 1e-2 * (rim + speed) if kind in (1, 2) else rim + speed >= 0
    assert error[apart[moves]].max() < 6e-6
    assert np.abs(by_limit - wanted @ WEIGHT / LIMIT).max() < 1e-5
    if kind < BOX:
        step = 1e-6
        ahead, behind = (
            tribos.Friction(patch_of(kind, RADIUS * (1 + s)), mu=LIMIT).wrench(twists, 1.0)
            for s in (step, -step)
        )
        change = (ahead - behind) @ WEIGHT / (2 * step * RADIUS)
        # Where it is smooth: not next to equal speeds.
        apart = np.abs(rim - speed) > 0.1 * (rim + speed)
        assert np.abs(by_radius - change)[apart].max() < 2e-5 * np.abs(change).max()


def test_no_row_is_lost():
    """Values and derivatives of 50,000 rows in each kind of friction are numbers."""
    twists = spread(50_000, seed=1)
    for kind in (0, 1, 3, BOX):
        found, derivatives = run(
            wrenches, kind, twists, np.full(len(twists), LIMIT), np.full(len(twists), RADIUS)
        )
        assert np.isfinite(found).all()
        assert all(np.isfinite(one).all() for one in derivatives)


def test_the_logarithm_needs_no_library():
    z = np.float32(
        np.concatenate([np.geomspace(2.0**-126, 1, 10_000), 1 - np.geomspace(1e-7, 0.3)])
    )
    out = wp.zeros(len(z), dtype=float, device="cpu")
    wp.launch(logarithms, len(z), [wp.array(z, dtype=float, device="cpu")], [out], device="cpu")
    wanted = np.log(z.astype(float))
    error = np.abs(out.numpy() - wanted)
    assert (error <= 4 * 2.0**-23 * np.maximum(np.abs(wanted), 1 - z.astype(float))).all()


@pytest.mark.parametrize("kind", [0, 1, 3, BOX, POLYGON])
def test_a_projection_is_that_of_the_kernel(kind):
    rng = np.random.default_rng(2)
    count = 4000
    given = rng.normal(size=(count, 3)) * 10 ** rng.uniform(-1.5, 1.5, (count, 1)) * LIMIT
    given[:, 2] *= RADIUS
    given[:4] = [[0, 0, 0], [1, 0, 0], [0, 0, 0.3], [0, 0.1, 0]]
    given = np.float32(given).astype(float)
    length = float(np.float32(0.03))
    rows = [np.full(count, x) for x in (LIMIT, RADIUS, length)]
    found, (slope, *others) = run(projections, kind, given, *rows)
    surface = tribos.Friction(patch_of(kind), mu=LIMIT).limit_surface(1.0)
    wanted = surface.project(given, length=length)
    units = LIMIT * np.array([1.0, 1.0, lever(kind)])
    bound = 3.5e-7 if kind in (0, 3) else 1e-6 if kind == 1 else 2e-6
    assert (np.abs(found - wanted) / units).max() < bound
    # Inside, the bits stay.
    inside = (wanted == given).all(1)
    assert inside.sum() > 500 and (found[inside] == given[inside]).all()
    jacobian = surface.project_jacobian(given, length=length)
    jacobian = jacobian[1] if isinstance(jacobian, tuple) else jacobian
    error = np.abs(slope - np.einsum("nij,i->nj", jacobian, WEIGHT)) * [RADIUS, RADIUS, 1]
    assert np.quantile(error.max(1), 0.995) < 3e-5
    assert all(np.isfinite(one).all() for one in (slope, *others))


def stepped(kind, twists, pushes, **changes):
    own = dict(limit=LIMIT, radius=RADIUS, mass=MASS, inertia=INERTIA, dt=STEP)
    own = {name: value * (1 + changes.get(name, 0.0)) for name, value in own.items()}
    friction = tribos.Friction(patch_of(kind, own["radius"]), mu=own["limit"])
    body = tribos.PlanarBody(friction, own["mass"], own["inertia"], load=1.0)
    return body.step(twists, pushes, dt=own["dt"])


@pytest.mark.parametrize("kind", [0, 3, BOX, POLYGON])
def test_a_planar_step_is_that_of_the_kernel(kind):
    rng = np.random.default_rng(3)
    count = 4000
    near = np.exp(-8 * rng.uniform(size=(count, 1)))
    twists = np.float32(rng.normal(size=(count, 3)) * near * [1, 1, 25]).astype(float)
    pushes = rng.normal(size=(count, 3)) * rng.uniform(size=(count, 1)) * [0.2, 0.2, 0.008]
    pushes = np.float32(pushes).astype(float)
    twists[:50] = 0.0
    rows = [np.full(count, x) for x in (LIMIT, RADIUS, MASS, INERTIA, STEP)]
    found, slopes = run(steps, kind, twists, pushes, *rows)
    wanted = stepped(kind, twists, pushes)
    units = LIMIT * np.array([1.0, 1.0, lever(kind)])
    bound = 3.5e-7 if kind < BOX else 2e-6
    assert (np.abs(found - wanted.friction) / units).max() < bound
    held = wanted.at_rest
    assert 500 < held.sum() < count - 500
    assert all(np.isfinite(slope).all() for slope in slopes)
    names = ("limit", "radius", "mass", "inertia", "dt")
    h = 1e-6
    for name, slope in zip(names, slopes[2:]):
        if name == "radius" and kind >= BOX:
            continue
        own = dict(zip(names, (LIMIT, RADIUS, MASS, INERTIA, STEP)))[name]
        ends = [stepped(kind, twists, pushes, **{name: s}).friction @ WEIGHT for s in (h, -h)]
        change = (ends[0] - ends[1]) / (2 * h * own)
        error = np.abs(slope - change) / np.abs(change).max()
        assert np.quantile(error, 0.995) < 1e-5, name
    for which, slope in enumerate(slopes[:2]):
        for part in range(3):
            shift = 1e-6 * np.maximum(np.abs((twists, pushes)[which][:, part]), 1e-3)
            ends = []
            for sign in (1, -1):
                moved = [twists.copy(), pushes.copy()]
                moved[which][:, part] += sign * shift
                ends.append(stepped(kind, *moved).friction @ WEIGHT)
            change = (ends[0] - ends[1]) / (2 * shift)
            error = np.abs(slope[:, part] - change) / np.abs(change).max()
            assert np.quantile(error, 0.995) < 1e-5, (which, part)


MANIFOLD = """
#include "tribos_manifold_friction.h"
void rows(int n, const float *given, const float *of, float *out)
{
	const float curve[3] = TRIBOS_CURVE_AREA;
	for (int i = 0; i < n; ++i) {
		const float *p = of + 5 * i;
		float a = given[3 * i], b = given[3 * i + 1], c = given[3 * i + 2];
		tribos_manifold_friction(p[2], p[3], p[0], p[1], p[4], curve, &a, &b, &c);
		out[3 * i] = a;
		out[3 * i + 1] = b;
		out[3 * i + 2] = c;
	}
}
"""
ROUNDS = """
#include "tribos_kernel.h"
void rows(int n, const float *given, const float *of, float *out)
{
	for (int i = 0; i < n; ++i) {
		const tribos_kernel_twist_f32 twist = { given[3 * i], given[3 * i + 1], given[3 * i + 2] };
		const tribos_kernel_wrench_f32 found =
			tribos_kernel_round_wrench_f32((int)of[0], twist, of[1], of[2]);
		out[3 * i] = found.x;
		out[3 * i + 1] = found.y;
		out[3 * i + 2] = found.torque;
	}
}
"""


def by_header(folder, source, given, of):
    """What a C header gives for rows, compiled without contraction."""
    header = Path(__file__).parents[2] / "c" / "include"
    needed = header / source.split('"')[1]
    compiler = shutil.which("cc")
    if compiler is None or not needed.exists():
        pytest.skip(f"needs a C compiler and {needed.name}")
    (folder / "rows.c").write_text(source)
    flags = ["-O1", "-ffp-contract=off", "-shared", "-fPIC", f"-I{header}"]
    command = [compiler, *flags, "rows.c", "-o", "rows.so", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    out = np.empty_like(given)
    pointers = [x.ctypes.data_as(ctypes.c_void_p) for x in (given, of, out)]
    ctypes.CDLL(str(folder / "rows.so")).rows(len(given), *pointers)
    return out


def test_round_wrenches_have_the_bits_of_the_c_header(tmp_path):
    twists = np.float32(spread(50_000, seed=5))
    corners = wp.array(CORNERS, dtype=wp.vec2, device="cpu")
    out = wp.zeros(len(twists), dtype=wp.vec3, device="cpu")
    rows = [on_device(np.full(len(twists), x)) for x in (LIMIT, RADIUS)]
    for kind in range(5):
        of = np.float32([kind, LIMIT, RADIUS])
        wanted = by_header(tmp_path, ROUNDS, twists, of)
        given = [kind, on_device(twists, wp.vec3), *rows, corners]
        wp.launch(wrenches, len(twists), given, [out], device="cpu")
        # As numbers: zeros may differ in sign.
        assert (out.numpy() == wanted).all()


def test_a_manifold_has_the_bits_of_the_c_header(tmp_path):
    rng = np.random.default_rng(4)
    count = 20_000
    impulse = np.float32(rng.normal(size=(count, 3)) * 10 ** rng.uniform(-1, 1, (count, 1)))
    low, high = [0.1, 0.05, 0.3, 0.3, 0.7], [2.0, 1.0, 3.0, 30.0, 1.0]
    of = np.float32(rng.uniform(low, high, (count, 5)))
    impulse[:3] = [[0, 0, 0], [5, 0, 0], [0, 0, 5]]
    of[3:5, 0], of[5:7, 1] = 0.0, 0.0
    wanted = by_header(tmp_path, MANIFOLD, impulse, of)
    given, rows = on_device(impulse, wp.vec3), on_device(of)
    out = wp.zeros(count, dtype=wp.vec3, device="cpu", requires_grad=True)
    with wp.Tape() as tape:
        wp.launch(manifolds, count, [given, rows], [out], device="cpu")
    same = out.numpy().view(np.int32) == wanted.view(np.int32)
    assert same.all(), (out.numpy()[~same.all(1)], wanted[~same.all(1)])
    tape.backward(grads={out: on_device(np.ones((count, 3)), wp.vec3)})
    assert np.isfinite(given.grad.numpy()).all() and np.isfinite(rows.grad.numpy()).all()
