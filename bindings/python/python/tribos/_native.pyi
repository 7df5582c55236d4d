"""Loops of the package `tribos`, which documents them."""

from collections.abc import Callable
from os import PathLike
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Film",
    "Friction",
    "Law",
    "LimitSurface",
    "Patch",
    "Potential",
    "Stop",
    "System",
    "World",
    "__version__",
    "command",
    "folder_scene",
    "host",
    "laws",
    "library_scenes",
    "num_threads",
    "run_at_once",
    "run_scene",
    "scene_of_file",
    "scene_of_settings",
    "scene_of_text",
    "set_num_threads",
    "vocabularies",
]
__version__: str

def command(arguments: list[str]) -> int: ...
def host(line: list[str], command: str | None, library: str | PathLike[str]) -> None: ...
def laws() -> list[dict[str, Any]]: ...
def num_threads() -> int: ...
def set_num_threads(count: int | None) -> None: ...
def folder_scene(folder: Path) -> dict[str, Any] | None: ...
def library_scenes() -> list[tuple[str, str, str]]: ...
def run_at_once(
    name: str, text: str
) -> tuple[dict[str, Any], list[str], NDArray[np.float64]] | None: ...
def run_scene(
    name: str,
    text: str,
    out: Path,
    *,
    resume: bool,
    anew: bool,
    checkpoint: float,
    frames: int | None,
    allow_large: bool,
    pictures: bool,
    threads: int | None,
    progress: Callable[[float | None, str], object] | None,
    stop: Stop | None,
) -> None: ...
def scene_of_file(path: str, overrides: list[str]) -> tuple[str, dict[str, Any]]: ...
def scene_of_settings(name: str, body: str, settings: list[str]) -> dict[str, Any]: ...
def scene_of_text(name: str, text: str, overrides: list[str]) -> tuple[str, dict[str, Any]]: ...
def vocabularies() -> list[dict[str, Any]]: ...
@final
class Film:
    @staticmethod
    def open(path: Path) -> Film | None: ...
    def steps(self) -> list[int]: ...
    def bodies(self) -> dict[str, Any]: ...
    def read(self, step: int) -> dict[str, Any]: ...

@final
class Potential:
    def __new__(cls, species: list[list[float]], mixing: str, shift: str) -> Potential: ...
    def evaluate(
        self,
        positions: ArrayLike,
        species: list[int],
        periods: tuple[float | None, float | None, float | None],
    ) -> tuple[float, NDArray[np.float64], list[list[float]]]: ...

@final
class Stop:
    def __new__(cls) -> Stop: ...
    def stop(self) -> None: ...

@final
class Friction:
    def __new__(cls, patch: Patch, law: Law, tier: str | None = None) -> Friction: ...
    def wrench(
        self, twists: ArrayLike, load: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def jacobian(
        self, twists: ArrayLike, load: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...

@final
class Law:
    def __new__(cls, text: str) -> Law: ...
    def text(self) -> str: ...
    def friction(self, speed: ArrayLike, out: NDArray[Any] | None = None) -> NDArray[Any]: ...
    def slope(self, speed: ArrayLike, out: NDArray[Any] | None = None) -> NDArray[Any]: ...

@final
class Patch:
    @staticmethod
    def round(text: str, radius: float) -> Patch: ...
    @staticmethod
    def polygon(loops: list[list[list[float]]], centre: tuple[float, float] | None) -> Patch: ...
    @staticmethod
    def bar(start: list[float], end: list[float]) -> Patch: ...
    @staticmethod
    def mesh(vertices: list[list[float]], triangles: list[list[int]]) -> Patch: ...
    @staticmethod
    def points(points: list[list[float]]) -> Patch: ...
    def radius(self) -> float: ...
    def centre(self) -> list[float]: ...

@final
class LimitSurface:
    def __new__(cls, patch: Patch) -> LimitSurface: ...
    def torque_limit(self, force_limit: float) -> float: ...
    def gauge(
        self, force_limit: ArrayLike, wrenches: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def support(
        self, force_limit: ArrayLike, twists: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def wrench(
        self, force_limit: ArrayLike, twists: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def normal(
        self, force_limit: ArrayLike, wrenches: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def scale_to_surface(
        self, force_limit: ArrayLike, wrenches: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def project(
        self,
        force_limit: ArrayLike,
        wrenches: ArrayLike,
        length: float | None = None,
        out: NDArray[Any] | None = None,
    ) -> NDArray[Any]: ...

@final
class System:
    def __new__(
        cls,
        potential: Potential,
        positions: ArrayLike,
        *,
        velocities: ArrayLike | None,
        species: list[int],
        masses: list[float],
        periods: tuple[float | None, float | None, float | None],
        thermostat: tuple[str, float, float],
        integrator: str,
        time_step: float,
        skin: float,
        seed: int,
        kept: Any,
    ) -> System: ...
    def step(self, count: int) -> None: ...
    def clock(self) -> tuple[float, int]: ...
    def positions(self) -> NDArray[np.float64]: ...
    def velocities(self) -> NDArray[np.float64]: ...
    def forces(self) -> NDArray[np.float64]: ...
    def energies(self) -> tuple[list[float], list[list[float]]]: ...
    def state(self) -> tuple[Any, ...]: ...

@final
class World:
    def __new__(
        cls,
        positions: ArrayLike,
        radii: list[float],
        *,
        densities: list[float],
        velocities: ArrayLike | None,
        spins: ArrayLike | None,
        pairs: tuple[list[float], bool],
        at_walls: tuple[list[float], bool],
        walls: list[Any],
        gravity: tuple[float, float, float],
        periods: tuple[float | None, float | None, float | None],
        longest_step: float,
        largest_motion: float,
        tolerance: float,
        sweeps: int,
        sleep_speed: float,
    ) -> World: ...
    def step(self, count: int) -> None: ...
    def clock(self) -> tuple[float, int]: ...
    def positions(self) -> NDArray[np.float64]: ...
    def velocities(self) -> NDArray[np.float64]: ...
    def spins(self) -> NDArray[np.float64]: ...
    def set(self, name: str, given: ArrayLike) -> None: ...
    def walls(self) -> list[tuple[float, float]]: ...
    def contacts(self) -> dict[str, Any]: ...
    def report(self) -> dict[str, Any]: ...
