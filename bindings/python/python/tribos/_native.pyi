"""Loops of the package `tribos`, which documents them."""

from collections.abc import Callable, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "AnyPressure",
    "ContactLaw",
    "Film",
    "Floor",
    "Friction",
    "Law",
    "LimitSurface",
    "LoadedFriction",
    "LuGre",
    "Manifold",
    "MujocoFeet",
    "PackingFile",
    "Patch",
    "Potential",
    "PowerLawProfile",
    "RateState",
    "RestMap",
    "Slider",
    "Stop",
    "SurfaceDerivatives",
    "System",
    "World",
    "__version__",
    "command",
    "fit_all_laws",
    "fit_law",
    "fit_laws",
    "fit_support",
    "fit_usage",
    "fit_track",
    "folder_scene",
    "host",
    "launches",
    "laws",
    "library_scenes",
    "line_boundary",
    "line_grip",
    "log_columns",
    "log_places",
    "look_at",
    "motion_cone",
    "nearest_side",
    "num_threads",
    "planar_rollout",
    "planar_step",
    "predict_law",
    "push_along",
    "push_modes",
    "pushes",
    "read_file",
    "read_pushes",
    "run_at_once",
    "run_scene",
    "scene_of_file",
    "scene_of_settings",
    "scene_of_text",
    "set_num_threads",
    "strokes_of",
    "vocabularies",
]
__version__: str

_Wanted = list[tuple[str, bool, bool]]
_Given = tuple[list[tuple[str, str]], list[tuple[str, str]], int]

def command(arguments: list[str]) -> int: ...
def fit_all_laws(
    columns: dict[str, Any],
    machine: tuple[bool, bool, bool],
    fixed: list[tuple[str, float]],
    starts: int,
) -> tuple[list[dict[str, Any]], list[tuple[str, str]]]: ...
def fit_law(
    law: str,
    columns: dict[str, Any],
    machine: tuple[bool, bool, bool],
    fixed: list[tuple[str, float]],
    starts: int,
) -> dict[str, Any]: ...
def fit_laws() -> list[list[str]]: ...
def fit_support(
    pushes: list[list[float]], patch: Patch | None, loops: list[list[list[float]]]
) -> dict[str, Any]: ...
def fit_usage(
    law: str, parameters: list[tuple[str, float]], is_per_load: bool, target: str
) -> str: ...
def fit_track(
    columns: tuple[list[float], list[float], list[float], list[float] | None],
    law: str,
    patch: str,
    fixed: list[tuple[str, float]],
    surroundings: tuple[float, float, float | None, float | None],
    choice: tuple[int, float | None, float | None, int],
) -> dict[str, Any]: ...
def launches(
    friction: PowerLawProfile, wanted: dict[str, float | int | None]
) -> list[tuple[tuple[float, float], float, float, float, float, float, float]]: ...
def host(line: list[str], command: str | None, library: str | PathLike[str]) -> None: ...
def laws() -> list[dict[str, Any]]: ...
def line_boundary(
    surface: LimitSurface, force_limit: float, ends: list[float], count: int
) -> list[list[float]]: ...
def line_grip(
    surface: LimitSurface, force_limit: ArrayLike, ends: list[float], twists: ArrayLike
) -> NDArray[Any]: ...
def log_columns(
    columns: list[tuple[str, list[float]]], wanted: _Wanted, given: _Given
) -> dict[str, Any]: ...
def log_places(names: list[str], wanted: _Wanted, given: _Given) -> list[int]: ...
def look_at(path: str, wanted: _Wanted, given: _Given) -> tuple[str, str]: ...
def motion_cone(
    surface: LimitSurface, force_limit: ArrayLike, contacts: ArrayLike
) -> NDArray[Any]: ...
def nearest_side(loops: list[list[list[float]]], at: list[float]) -> list[list[float]]: ...
def strokes_of(
    columns: tuple[
        list[float], list[float], list[float] | None, list[float] | None, list[float] | None
    ],
    middle: float,
    shortest_rest: float,
) -> dict[str, Any]: ...
def num_threads() -> int: ...
def predict_law(
    law: str,
    velocities: list[float],
    times: list[float] | None,
    values: list[float],
    spring: bool,
) -> list[float]: ...
def push_along(
    surface: LimitSurface,
    force_limit: float,
    at: list[float],
    side: list[float] | None,
    start: list[float],
    velocity: list[float],
    duration: float,
    samples: int,
    tolerance: float,
) -> tuple[NDArray[Any], str, int]: ...
def push_modes() -> list[str]: ...
def pushes(surface: LimitSurface, force_limit: ArrayLike, contacts: ArrayLike) -> NDArray[Any]: ...
def planar_rollout(
    patch: Patch,
    surface: LimitSurface,
    bodies: dict[str, Any],
    twists: ArrayLike,
    pushes: ArrayLike,
    poses: ArrayLike,
) -> list[NDArray[Any]]: ...
def planar_step(
    patch: Patch,
    surface: LimitSurface,
    bodies: dict[str, Any],
    twists: ArrayLike,
    pushes: ArrayLike,
    angle: ArrayLike,
    out: NDArray[Any] | None = None,
) -> list[NDArray[Any]]: ...
def set_num_threads(count: int | None) -> None: ...
def folder_scene(folder: Path) -> dict[str, Any] | None: ...
def library_scenes() -> list[tuple[str, str, str]]: ...
def read_file(path: str, wanted: _Wanted, given: _Given) -> dict[str, Any]: ...
def read_pushes(path: str, given: _Given) -> list[list[float]]: ...
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
class AnyPressure:
    def __new__(
        cls, corners: list[list[float]], centre: list[float], force_limit: float
    ) -> AnyPressure: ...
    def radius(self) -> float: ...
    def support(self, twists: ArrayLike) -> NDArray[Any]: ...
    def wrench(self, twists: ArrayLike) -> NDArray[Any]: ...
    def torque_limits(self, forces: ArrayLike) -> NDArray[Any]: ...
    def gauge_bounds(self, wrenches: ArrayLike) -> NDArray[Any]: ...

@final
class ContactLaw:
    def __new__(
        cls,
        coefficients: list[float],
        patch: Patch | None,
        restitution: float,
        cohesion: list[float],
        attraction: str,
    ) -> ContactLaw: ...
    def mu_torsion(self) -> float: ...
    def spheres(self, rows: ArrayLike, dt: float) -> NDArray[Any]: ...
    def plate(self, rows: ArrayLike, dt: float) -> NDArray[Any]: ...

@final
class Manifold:
    def __new__(cls, law: ContactLaw) -> Manifold: ...
    def copy(self) -> Manifold: ...
    def add_sphere(self, ball: tuple[list[float], list[float], float, float]) -> int: ...
    def add_plate(self, velocity: list[float], inv_mass: float) -> int: ...
    def add_contact(
        self,
        first: int,
        second: int,
        normal: list[float],
        gap: float,
        radii: tuple[float, float | None],
    ) -> int: ...
    def set_contact(
        self, contact: int, normal: list[float], gap: float, radii: tuple[float, float | None]
    ) -> None: ...
    def clear_contacts(self) -> None: ...
    def set_gravity(self, gravity: list[float]) -> None: ...
    def set_force(self, body: int, force: list[float], torque: list[float]) -> None: ...
    def motion(self, body: int) -> tuple[list[float], list[float]]: ...
    def set_motion(self, body: int, velocity: list[float], spin: list[float]) -> None: ...
    def force(self, contact: int) -> tuple[float, list[float], list[float], float] | None: ...
    def solve(
        self, dt: float, start: str, sweeps: int, tolerance: float
    ) -> tuple[int, float, bool]: ...

@final
class Floor:
    @staticmethod
    def under(
        patch: Patch, mu: float, load: float, surfaces: list[tuple[list[list[float]], list[float]]]
    ) -> Floor: ...
    @staticmethod
    def feet(feet: list[tuple[Any, ...]]) -> Floor: ...
    def patch(self) -> Patch: ...
    def limit(self) -> float: ...
    def count(self) -> int: ...
    def wrench(self, twists: ArrayLike, out: NDArray[Any] | None = None) -> Any: ...
    def jacobian(self, twists: ArrayLike, out: NDArray[Any] | None = None) -> Any: ...
    def steady_motion(
        self, push: list[float]
    ) -> tuple[list[float], list[float], int | None, int]: ...
    def step(
        self,
        twists: ArrayLike,
        pushes: ArrayLike,
        body: tuple[float, float, float],
        out: NDArray[Any] | None,
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]: ...

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
class LoadedFriction:
    def __new__(cls, pressure: str, law: Law, radius: str) -> LoadedFriction: ...
    def radius(self, load: float) -> list[float]: ...
    def wrench(
        self, twists: ArrayLike, load: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def slope_by_load(
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
    def named(text: str, radius: float) -> Patch: ...
    @staticmethod
    def polygon(loops: list[list[list[float]]], centre: tuple[float, float] | None) -> Patch: ...
    @staticmethod
    def mesh(vertices: list[list[float]], triangles: list[list[int]]) -> Patch: ...
    @staticmethod
    def points(points: list[list[float]]) -> Patch: ...
    def anisotropic(self, mu: tuple[float, float], axis: float) -> Patch: ...
    def radius(self) -> float: ...
    def centre(self) -> list[float]: ...

@final
class LimitSurface:
    def __new__(cls, patch: Patch) -> LimitSurface: ...
    def ellipsoid(self) -> LimitSurface: ...
    def torque_limit(self, force_limit: float) -> float: ...
    def torque_limits(
        self, force_limit: ArrayLike, forces: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
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
class RestMap:
    def __new__(cls, patch: Patch, law: Law) -> RestMap: ...
    def rest(
        self,
        speed: ArrayLike,
        spin: ArrayLike,
        gravity: ArrayLike,
        radius: ArrayLike,
        inertia_ratio: ArrayLike,
    ) -> NDArray[Any]: ...
    def rest_and_jacobian(
        self,
        speed: ArrayLike,
        spin: ArrayLike,
        gravity: ArrayLike,
        radius: ArrayLike,
        inertia_ratio: ArrayLike,
    ) -> tuple[NDArray[Any], NDArray[Any]]: ...

@final
class SurfaceDerivatives:
    def __new__(cls, patch: Patch) -> SurfaceDerivatives: ...
    @staticmethod
    def of_ellipsoids(patch: Patch) -> SurfaceDerivatives: ...
    def gauge_gradient(
        self, force_limit: ArrayLike, wrenches: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def gauge_hessian(
        self, force_limit: ArrayLike, wrenches: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def normal_jacobian(
        self, force_limit: ArrayLike, wrenches: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def project_jacobian(
        self,
        force_limit: ArrayLike,
        wrenches: ArrayLike,
        length: float | None = None,
        out: NDArray[Any] | None = None,
    ) -> NDArray[Any]: ...
    def support_hessian(
        self, force_limit: ArrayLike, twists: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def planar_step_jacobian(
        self,
        force_limit: ArrayLike,
        twists: ArrayLike,
        pushes: ArrayLike,
        mass: ArrayLike,
        inertia: ArrayLike,
        dt: ArrayLike,
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], NDArray[Any]]: ...

@final
class PowerLawProfile:
    def __new__(cls, patch: Patch, law: Law) -> PowerLawProfile: ...
    def alpha(self) -> float: ...
    def modes(
        self, inertia_ratio: float, initial_ratio: float | None = None, lean: float = 0.0
    ) -> tuple[tuple[float, float], list[tuple[float, str]], tuple[str, float] | None]: ...

@final
class Slider:
    def __new__(cls, patch: Patch, law: Law, tier: str | None = None) -> Slider: ...
    def to_rest(
        self,
        speed: ArrayLike,
        spin: ArrayLike,
        inertia_ratio: ArrayLike,
        gravity: ArrayLike,
    ) -> NDArray[Any]: ...
    def advance(
        self,
        speed: ArrayLike,
        spin: ArrayLike,
        times: ArrayLike,
        inertia_ratio: ArrayLike,
        gravity: ArrayLike,
    ) -> NDArray[Any]: ...

@final
class LuGre:
    def __new__(cls, parameters: list[float]) -> LuGre: ...
    def largest_deflection(self) -> float: ...
    def passive_up_to(self) -> float: ...
    def step(self, deflection: ArrayLike, velocity: ArrayLike, dt: ArrayLike) -> NDArray[Any]: ...
    def force(
        self, deflection: ArrayLike, velocity: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def rate(
        self, deflection: ArrayLike, velocity: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def steady_force(
        self, velocity: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...

@final
class RateState:
    def __new__(cls, parameters: list[float], evolution: str) -> RateState: ...
    def friction(
        self, speed: ArrayLike, age: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def slope(
        self, speed: ArrayLike, age: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def step(
        self, age: ArrayLike, speed: ArrayLike, dt: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def steady_age(self, speed: ArrayLike, out: NDArray[Any] | None = None) -> NDArray[Any]: ...
    def steady_friction(
        self, speed: ArrayLike, out: NDArray[Any] | None = None
    ) -> NDArray[Any]: ...
    def critical_stiffness(self, load: float, speed: float | None = None) -> float: ...
    def minimum(self) -> float | None: ...

@final
class MujocoFeet:
    def __new__(cls, simulation: object, feet: Sequence[object]) -> MujocoFeet: ...
    @staticmethod
    def arrays() -> list[tuple[str, str]]: ...
    def step(
        self,
        time: float,
        dt: float,
        contacts: tuple[int, int],
        stiffness: NDArray[Any],
        springs: NDArray[Any],
    ) -> None: ...
    def state(
        self, foot: int
    ) -> tuple[float, list[float], list[float], list[list[float]], list[float], bool, int]: ...

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
class PackingFile:
    def __new__(
        cls,
        path: str,
        columns: str | None,
        periods: tuple[float | None, ...] | None,
    ) -> PackingFile: ...
    def arrays(self) -> dict[str, Any]: ...
    def about(self) -> list[tuple[str, str]]: ...
    def write(self, path: str) -> list[str]: ...

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
