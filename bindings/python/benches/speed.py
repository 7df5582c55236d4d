"""Speed of calls from Python beside the kernel's own loops, in one interleaved run.

cargo build --release -p tribos-python --example batch
python bindings/python/benches/speed.py target/release/examples/batch
"""

import argparse
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import tribos

COUNT = 100_000
ROUNDS = 15
SIDE = 0.08


def quickest(work: Callable[[], object], repeats: int) -> float:
    """Seconds of the quickest of a few calls."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("batch", type=Path, help="the Rust program of examples/batch.rs")
    program = parser.parse_args().batch
    rng = np.random.default_rng(1)
    twists = rng.normal(size=(COUNT, 3)) * [1.0, 1.0, 20.0]
    patches = {"disk": tribos.disk(0.04), "square": tribos.box(SIDE, SIDE)}
    print("| patch | Rust batch, ns | array call, ns | ratio | two threads | one call, µs |")
    print("|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "twists"
        file.write_bytes(twists.tobytes())
        for name, patch in patches.items():
            friction = tribos.Friction(patch, mu=0.3)
            out = np.empty_like(twists)

            def array(friction: tribos.Friction = friction, out: np.ndarray = out) -> None:
                friction.wrench(twists, 1.7, out=out)

            def alone(friction: tribos.Friction = friction) -> None:
                for _ in range(1000):
                    friction.wrench(twists[0], 1.7)

            native, arrays, pairs, calls = [], [], [], []
            for _ in range(ROUNDS):
                told = subprocess.run(
                    [program, name, file, "20"], check=True, capture_output=True, text=True
                )
                native.append(float(told.stdout))
                tribos.set_num_threads(1)
                arrays.append(quickest(array, 20) / COUNT * 1e9)
                calls.append(quickest(alone, 5) / 1000 * 1e6)
                tribos.set_num_threads(2)
                pairs.append(quickest(array, 20) / COUNT * 1e9)
            ratio = statistics.median(a / n for a, n in zip(arrays, native, strict=True))
            gain = statistics.median(a / p for a, p in zip(arrays, pairs, strict=True))
            print(
                f"| {name} | {statistics.median(native):.1f} | {statistics.median(arrays):.1f} "
                f"| {ratio:.3f} | {gain:.2f} | {statistics.median(calls):.2f} |"
            )


if __name__ == "__main__":
    main()
