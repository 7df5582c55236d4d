"""Loops of the package `tribos`, which documents them."""

from typing import Any, final

from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Friction",
    "Law",
    "LimitSurface",
    "LuGre",
    "Patch",
    "Profiled",
    "RateState",
    "Slider",
    "__version__",
    "command",
    "launches",
    "laws",
    "num_threads",
    "planar_rollout",
    "planar_step",
    "set_num_threads",
]
__version__: str

def command(arguments: list[str]) -> int: ...
def launches(
    friction: Profiled, wanted: dict[str, float | int | None]
) -> list[tuple[tuple[float, float], float, float, float, float, float, float]]: ...
def laws() -> list[dict[str, Any]]: ...
def num_threads() -> int: ...
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
class Profiled:
    def __new__(cls, patch: Patch, law: Law) -> Profiled: ...
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
    def step(
        self, deflection: ArrayLike, velocity: ArrayLike, dt: ArrayLike
    ) -> NDArray[Any]: ...
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
