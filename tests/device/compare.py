"""Compares the device code with the host's library, bit by bit, on rows that the library draws.

`compare.py HOST.so DEVICE.ptx` does so on the first GPU, by CUDA's driver and with nothing to install: 10⁷ rows of each
function and precision, and how many the GPU does in a second. With `--driver libdevice.so`, the translated code in place
of the driver (driver.c), no GPU is needed. Status 1 if a row differs (with `--expect-difference` if none does), 2 without
a GPU.
"""

import argparse
import ctypes
import os
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from typing import NoReturn

BLOCK = 128  # threads
CHUNK = 1 << 18  # rows, of one seed
TIMED, LAUNCHES = 1 << 21, 10  # rows and launches that speed is measured with
NO_GPU = 2
REALS = {"f32": ctypes.c_float, "f64": ctypes.c_double}


class Host:
    """The library: the functions, the rows and the comparison."""

    def __init__(self, path: str) -> None:
        self.library = ctypes.CDLL(path)
        self.library.names.restype = ctypes.c_char_p
        for count in (self.library.inputs, self.library.outputs):
            count.argtypes, count.restype = [ctypes.c_uint64], ctypes.c_uint64
        for kind in REALS:
            self._declare(kind)

    def _declare(self, kind: str) -> None:
        whole, place = ctypes.c_uint64, ctypes.c_void_p
        self.draw(kind).argtypes = [whole, whole, place, whole]
        self.differing(kind).argtypes, self.differing(kind).restype = (
            [place, place, whole, whole],
            whole,
        )
        for name in self.names():
            self.library[f"{name}_{kind}"].argtypes = [place, place, whole]

    def names(self) -> list[str]:
        """The functions, in the order of the list."""
        return self.library.names().decode().split()

    def draw(self, kind: str):
        """Fills a table with rows."""
        return self.library[f"draw_{kind}"]

    def differing(self, kind: str):
        """Counts rows that differ."""
        return self.library[f"differing_{kind}"]

    def rows(self, function: int, kind: str, seed: int, rows: int):
        """Inputs, and the host's answers."""
        inputs = (REALS[kind] * (rows * self.library.inputs(function)))()
        answers = (REALS[kind] * (rows * self.library.outputs(function)))()
        self.draw(kind)(function, seed, inputs, len(inputs))
        self.library[f"{self.names()[function]}_{kind}"](inputs, answers, rows)
        return inputs, answers


class Device:
    """The first GPU with the module, by CUDA's driver or what stands in for it."""

    def __init__(self, driver: ctypes.CDLL, module: bytes) -> None:
        self.driver, self.module = driver, ctypes.c_void_p()
        device, context, name = ctypes.c_int(), ctypes.c_void_p(), ctypes.create_string_buffer(100)
        try:
            self.call("cuInit", ctypes.c_uint(0))
            self.call("cuDeviceGet", ctypes.byref(device), ctypes.c_int(0))
        except RuntimeError as error:
            no_gpu(error)
        self.call("cuDeviceGetName", name, ctypes.c_int(len(name)), device)
        self.call("cuDevicePrimaryCtxRetain", ctypes.byref(context), device)
        self.call("cuCtxSetCurrent", context)
        self.call("cuModuleLoadData", ctypes.byref(self.module), ctypes.c_char_p(module))
        self.name = name.value.decode()

    def call(self, function: str, *arguments) -> None:
        """Calls the driver, whose functions all return a code."""
        code = self.driver[function](*arguments)
        if code:
            text = ctypes.c_char_p(b"")
            self.driver.cuGetErrorString(code, ctypes.byref(text))
            raise RuntimeError(f"{function}: {(text.value or b'an error without a name').decode()} ({code})")

    def memory(self, numbers) -> ctypes.c_uint64:
        """Memory of the device for a table."""
        place = ctypes.c_uint64()
        self.call("cuMemAlloc_v2", ctypes.byref(place), ctypes.c_size_t(ctypes.sizeof(numbers)))
        return place

    def answers(self, program: str, rows: int, inputs, answers, launches: int = 1) -> float:
        """Fills `answers`, and says how many seconds a launch takes."""
        function, (read, written) = ctypes.c_void_p(), map(self.memory, (inputs, answers))
        self.call(
            "cuModuleGetFunction",
            ctypes.byref(function),
            self.module,
            ctypes.c_char_p(program.encode()),
        )
        self.call("cuMemcpyHtoD_v2", read, inputs, ctypes.c_size_t(ctypes.sizeof(inputs)))
        # What a program does not write differs from every answer.
        ctypes.memset(answers, 0xA5, ctypes.sizeof(answers))
        self.call("cuMemcpyHtoD_v2", written, answers, ctypes.c_size_t(ctypes.sizeof(answers)))
        given = [read, written, ctypes.c_uint64(rows)]
        pointers = (ctypes.c_void_p * 3)(*(ctypes.addressof(one) for one in given))
        grid = [ctypes.c_uint(size) for size in (-(-rows // BLOCK), 1, 1, BLOCK, 1, 1, 0)]
        self.call("cuCtxSynchronize")
        start = time.perf_counter()
        for _ in range(launches):
            self.call("cuLaunchKernel", function, *grid, ctypes.c_void_p(), pointers, ctypes.c_void_p())
        self.call("cuCtxSynchronize")
        seconds = (time.perf_counter() - start) / launches
        self.call("cuMemcpyDtoH_v2", answers, written, ctypes.c_size_t(ctypes.sizeof(answers)))
        for place in (read, written):
            self.call("cuMemFree_v2", place)
        return seconds


def compared(host: Host, device: Device, function: int, kind: str, rows: int) -> int:
    """The number of rows that differ. While the device works the host's threads prepare further rows."""
    program, width = f"{host.names()[function]}_{kind}", host.library.outputs(function)
    sizes = [min(CHUNK, rows - first) for first in range(0, rows, CHUNK)]
    differ, threads = 0, os.cpu_count() or 1
    with ThreadPoolExecutor(threads) as pool:
        for start in range(0, len(sizes), threads):
            group = list(enumerate(sizes[start : start + threads], start))
            prepared = [pool.submit(host.rows, function, kind, seed, size) for seed, size in group]
            for (_, size), one in zip(group, prepared):
                inputs, wanted = one.result()
                found = type(wanted)()
                device.answers(program, size, inputs, found)
                differ += host.differing(kind)(wanted, found, len(wanted), width)
    return differ


def speed(host: Host, device: Device, function: int, kind: str) -> float:
    """Rows a second, copies aside."""
    inputs, answers = host.rows(function, kind, 0, TIMED)
    seconds = device.answers(f"{host.names()[function]}_{kind}", TIMED, inputs, answers, LAUNCHES)
    return TIMED / seconds


def no_gpu(why: Exception) -> NoReturn:
    """Ends the program."""
    print(f"no GPU: {why}")
    sys.exit(NO_GPU)


def driver(path: str | None) -> ctypes.CDLL:
    """CUDA's driver, or the library in its place."""
    if path:
        return ctypes.CDLL(os.path.abspath(path))
    try:
        return ctypes.CDLL("libcuda.so.1")
    except OSError as error:
        no_gpu(error)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("host", help="libtribos_device.so")
    parser.add_argument("module", help="tribos_device.ptx")
    parser.add_argument("--driver", help="a library in place of CUDA's driver")
    parser.add_argument("--rows", type=int, default=10**7, help="of each function and precision")
    parser.add_argument("--expect-difference", action="store_true", help="for code that rounds otherwise")
    options = parser.parse_args()
    host = Host(os.path.abspath(options.host))
    with open(options.module, "rb") as module:
        device = Device(driver(options.driver), module.read())
    print(f"{device.name}: {options.rows} rows of each")
    total, start = 0, time.perf_counter()
    for function, name in enumerate(host.names()):
        for kind in REALS:
            differ = compared(host, device, function, kind, options.rows)
            fast = "" if options.driver else f", {speed(host, device, function, kind):.3g} rows a second"
            print(f"{name:>15} {kind}: {differ} differ{fast}", flush=True)
            total += differ
    print(f"{total} rows differ from the host's; {time.perf_counter() - start:.0f} s")
    sys.exit((total > 0) != options.expect_difference)


if __name__ == "__main__":
    main()
