"""Time of friction in XLA beside the callback to the compiled kernel, in one run: the table of docs/gpus.md.

    python gpus.py

One thread of the processor, least of several runs; a callback is called as a program of JAX calls it.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from typing import Any

os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false")
os.environ.setdefault("RAYON_NUM_THREADS", "1")

import jax  # noqa: E402
import jax.numpy as jnp  # noqa: E402
import numpy as np  # noqa: E402
import tribos  # noqa: E402
import tribos.jax  # noqa: E402

jax.config.update("jax_enable_x64", True)
tribos.set_num_threads(1)

COUNT, STEPS = 4096, 1000
DISK = tribos.Friction(tribos.disk(0.04), mu=0.3)
BOX = tribos.Friction(tribos.box(0.3, 0.2), mu=0.3)
PUCK = {"mass": 0.17, "inertia": 1.36e-4, "dt": 1e-3}
CRATE = {"mass": 2.0, "inertia": 0.022, "dt": 1e-3}


def least(of: Callable[..., Any], *given: Any) -> float:
    """Seconds of the quickest call."""
    compiled = jax.jit(of)
    jax.block_until_ready(compiled(*given))
    best = np.inf
    for _ in range(9):
        start = time.perf_counter()
        jax.block_until_ready(compiled(*given))
        best = min(best, time.perf_counter() - start)
    return best


def programs(friction: tribos.Friction, body: dict[str, float], backend: str) -> dict[str, Any]:
    """Functions of twists."""
    load = 9.81 * body["mass"]

    def wrench(twists: Any) -> Any:
        return tribos.jax.wrench(friction, twists, load, backend=backend)

    def project(twists: Any) -> Any:
        return tribos.jax.project(friction, 3.0 * load * twists, load, backend=backend)

    def step(twists: Any) -> Any:
        none = jnp.zeros(3, twists.dtype)
        given = {**body, "backend": backend}
        return tribos.jax.planar_step(friction, twists, none, load, **given).twists

    def slope(twists: Any) -> Any:
        return jax.grad(lambda at: jnp.sum(wrench(at) * at[::-1]))(twists)

    return {"wrench": wrench, "gradient": slope, "project": project, "planar step": step}


def scanned(step: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Many steps of one body."""
    return lambda twist: jax.lax.scan(lambda at, _: (step(at), None), twist, length=STEPS)[0]


def main() -> None:
    drawn = np.random.default_rng(1).normal(size=(COUNT, 3)) * [1.0, 1.0, 20.0]
    print("f32, f64 by XLA; f32, f64 by callback")
    for name, friction, body in (("disk", DISK, PUCK), ("box", BOX, CRATE)):
        of = {backend: programs(friction, body, backend) for backend in ("xla", "callback")}
        types = (jnp.float32, jnp.float64)
        for what in of["xla"]:
            times = [
                least(of[backend][what], jnp.asarray(drawn, dtype)) / COUNT
                for backend in ("xla", "callback")
                for dtype in types
            ]
            print(f"{name} {what}, ns a row:", *(f"{1e9 * one:.3g}" for one in times))
        launch = jnp.array([1.0, 0.0, 20.0])
        runs = {backend: scanned(of[backend]["planar step"]) for backend in of}
        times = [
            least(runs[backend], launch.astype(dtype))
            for backend in ("xla", "callback")
            for dtype in types
        ]
        print(f"{name}, {STEPS} steps, ms:", *(f"{1e3 * one:.3g}" for one in times))
        slope = jax.grad(lambda twist, run=runs["xla"]: jnp.sum(run(twist)))
        times = [least(slope, launch.astype(dtype)) for dtype in types]
        print(f"{name}, their gradient, ms:", *(f"{1e3 * one:.3g}" for one in times))


if __name__ == "__main__":
    main()
