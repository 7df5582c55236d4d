"""What sets, steps and fronts ask of the form of a patch."""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

from tribos._forms.space import Space


class Nearest(NamedTuple):
    """The points of a unit set nearest to wrenches, for those inside a point whose tangent proves it."""

    points: Any
    """Of shape (..., 3), on the surface."""
    normals: Any
    """Outward normals there, of shape (..., 3) and length 1."""
    beyond: Any
    """Wrench less point along the normal: above 0 outside, below 0 inside."""


class Ray(NamedTuple):
    """Where the rays of wrenches meet the surface of a unit set."""

    normals: Any
    """Outward normals there, of shape (..., 3) and length 1."""
    gauges: Any
    """Wrench per point on the surface, along the ray."""


class Form(Protocol):
    """A patch with its pressure under Coulomb's law with mu N = 1, of arrays that may be traced.

    Twists and wrenches of shape (..., 3) refer to the origin. Leading axes of twists, wrenches and arrays are broadcast.
    Nothing is prepared from the arrays outside of the methods, so that derivatives by the arrays are those of the methods.
    """

    @property
    def arrays(self) -> tuple[Any, ...]:
        """What the form depends on: a radius, corners."""

    def of(self, arrays: tuple[Any, ...]) -> Form:
        """The same form of other arrays."""

    def per(self, space: Space, length: Any) -> Form:
        """The form in another unit of length, one for each row."""

    def reach(self, space: Space) -> Any:
        """Radius about the centre of pressure and the centre's distance from the origin together."""

    def centre(self, space: Space) -> tuple[Any, Any]:
        """The centre of pressure."""

    def spin(self, space: Space) -> Any:
        """Torque of spinning about the centre of pressure."""

    def support(self, space: Space, twists: Any) -> Any:
        """Power of friction, the support function of the set, 0 at rest; its derivative is minus `wrench`."""

    def wrench(self, space: Space, twists: Any) -> Any:
        """Friction, minus the gradient of the support; 0 at rest, with derivatives 0. Its derivative is minus `hessian`."""

    def hessian(self, space: Space, twists: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
        """Second derivatives xx, xy, yy, xt, yt, tt of the support; 0 at rest."""

    def nearest(self, space: Space, wrenches: Any) -> Nearest:
        """The nearest points by |force|² + torque², without derivatives: lengths are in the unit that makes a force of a
        torque. *Domain*: any, zero included."""

    def ray(self, space: Space, wrenches: Any) -> Ray:
        """The points on rays, without derivatives. *Domain*: any but zero, where any finite numbers do."""
