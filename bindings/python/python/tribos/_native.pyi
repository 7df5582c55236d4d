"""Loops of the package `tribos`, which documents them."""

from collections.abc import Sequence
from typing import Any, final

from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Friction",
    "Law",
    "LimitSurface",
    "MujocoFeet",
    "Patch",
    "__version__",
    "command",
    "laws",
    "num_threads",
    "set_num_threads",
]
__version__: str

def command(arguments: list[str]) -> int: ...
def laws() -> list[dict[str, Any]]: ...
def num_threads() -> int: ...
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
class MujocoFeet:
    def __new__(
        cls,
        feet: Sequence[object],
        memory: NDArray[Any],
        places: object,
        layout: object,
        mass: tuple[NDArray[Any], NDArray[Any]] | None,
    ) -> MujocoFeet: ...
    def lift(self) -> None: ...
    def step(
        self,
        time: float,
        dt: float,
        contacts: NDArray[Any],
        stiffness: NDArray[Any],
        springs: NDArray[Any],
    ) -> bool: ...
    def push(self, dt: float) -> None: ...
    def state(
        self, foot: int
    ) -> tuple[float, list[float], list[float], list[list[float]], list[float], bool]: ...
