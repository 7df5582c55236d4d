"""Friction, radius and launch of a body that was filmed while it slides."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tribos import _native, _patches
from tribos._checks import number, positive
from tribos._fit import Array, Estimate, _told, estimates_of
from tribos._friction import Friction
from tribos._laws import Law
from tribos._log import read

_MOST_STARTS = 10_000


@dataclass(frozen=True, eq=False)
class TrackFit:
    """A motion fitted to a film.

    Attributes
    ----------
    estimates : tuple of Estimate
        All parameters: those of the law, ``R`` (or ``ratio`` without the angle), and the launch at the first
        frame, ``x0``, ``y0``, ``vx``, ``vy``, ``angle0``, ``spin``.
    law : Law
        The fitted law.
    patch : str
        The patch, as it was given.
    rms, rms_angle : float
        Root mean squares of the residuals of a coordinate in m, and of the angle in rad (None without it).
    rows, freedoms : int
        Frames that were taken, and readings minus free parameters.
    dropped : tuple of int
        Frames of which a reading was left out.
    converged : bool
        Whether rounding alone limited further descent.
    starts, at_best : int
        Starts from which a search was possible, and those that ended at the best minimum.
    times, residuals, speeds : numpy.ndarray
        Of the frames: times in s, readings less fitted motion of shape (2 or 3, n), and fitted speeds in m/s.
    ratio : float
        ``v/(|spin| R)`` at the first frame.
    rest_time : float or None
        Time of the film at which the body stops sliding, in s.
    warnings : tuple of str
        What the film does not tell, and what is odd about it.
    """

    estimates: tuple[Estimate, ...]
    law: Law
    patch: str
    rms: float
    rms_angle: float | None
    rows: int
    freedoms: int
    dropped: tuple[int, ...]
    converged: bool
    starts: int
    at_best: int
    times: Any = field(repr=False)
    residuals: Any = field(repr=False)
    speeds: Any = field(repr=False)
    ratio: float
    rest_time: float | None
    warnings: tuple[str, ...]
    _radius: float | None = field(repr=False, default=None)

    @property
    def parameters(self) -> dict[str, float]:
        """Values by name."""
        return {estimate.name: estimate.value for estimate in self.estimates}

    @property
    def intervals(self) -> dict[str, tuple[float, float]]:
        """Intervals of 95 % by name; infinite or 0 where the film sets no bound."""
        return {estimate.name: estimate.interval for estimate in self.estimates}

    @property
    def errors(self) -> dict[str, float]:
        """Standard errors by name; 0 if fixed, NaN where the film gives none."""
        return {estimate.name: estimate.error for estimate in self.estimates}

    def __getitem__(self, name: str) -> float:
        return self.parameters[name]

    @property
    def radius(self) -> float:
        """The radius of a round patch, in m: fitted, or fixed. ValueError where there is none."""
        found = self.parameters.get("R", self._radius)
        if found is None:
            raise ValueError(
                "without a column angle the film tells no radius; give fixed={'R': metres}"
            )
        return found

    @property
    def friction(self) -> Friction:
        """The fitted friction, for `slide_path` and `slide`; of round patches."""
        name, _, rest = self.patch.partition(":")
        if name == "annulus":
            radius = self.radius
            return Friction(_patches.annulus(float(rest) * radius, radius), law=self.law)
        if rest or name not in ("disk", "ring", "hertz", "punch", "paraboloid"):
            raise ValueError(
                f"a friction is made for disk, ring, annulus, hertz, punch and paraboloid, not {self.patch}"
            )
        return Friction(getattr(_patches, name)(self.radius), law=self.law)

    @property
    def launch(self) -> dict[str, float]:
        """``speed`` and ``spin`` at the first frame, as `slide_path` takes them; without the angle the spin is > 0."""
        values = self.parameters
        speed = math.hypot(values["vx"], values["vy"])
        spin = values["spin"] if "spin" in values else speed / (self.ratio * self.radius)
        return {"speed": speed, "spin": spin}

    def __repr__(self) -> str:
        width = max(len(estimate.name) for estimate in self.estimates)
        lines = [f"<motion of a {self.patch} fitted to {self.rows} frames>"]
        for estimate in self.estimates:
            value, how = _told(estimate)
            low, high = self.intervals[estimate.name]
            lines.append(
                f"  {estimate.name:<{width}}  {value:<12} {how:<16} {low:.5g} to {high:.5g} "
                f"[{estimate.unit}] {estimate.meaning}"
            )
        angle = "" if self.rms_angle is None else f" and {math.degrees(self.rms_angle):.3g} deg"
        lines.append(
            f"  residuals {1e3 * self.rms:.4g} mm{angle}; {self.at_best} of {self.starts} starts agree"
        )
        lines.extend(f"  {warning}" for warning in self.warnings)
        return "\n".join(lines)


def fit_track(
    data: Any,
    *,
    law: str = "coulomb",
    patch: str = "disk",
    fixed: Mapping[str, float] | None = None,
    gravity: float = 9.81,
    inertia_ratio: float = 0.5,
    columns: Mapping[str, str | int] | None = None,
    units: Mapping[str, str] | None = None,
    skip: int = 0,
    frame_rate: float | None = None,
    scale: float | None = None,
    start: float | None = None,
    stop: float | None = None,
    noise_position: float | None = None,
    noise_angle: float | None = None,
    starts: int = 8,
) -> TrackFit:
    """Fit friction, radius and launch to a film of a body that slides on a level floor.

    Parameters
    ----------
    data
        A table with the columns ``t``, ``x``, ``y`` and perhaps ``angle`` (s, m, m, rad), as in `fit`.
    law
        ``"coulomb"``, ``"viscous"``, ``"stribeck"`` or ``"power"``.
    patch
        As the command writes it: ``"disk"``, ``"ring"``, ``"annulus:0.8"``, ``"hertz"``, ``"punch"``,
        ``"box:0.1x0.06"``. The radius of a round one is found.
    fixed
        Parameters that keep these values, such as ``{"R": 0.03}``.
    gravity, inertia_ratio
        In m/s²; ``I/(m R**2)`` of a round body.
    columns, units, skip
        As in `fit`: ``units={"x": "mm", "y": "mm", "angle": "deg"}``.
    frame_rate, scale
        Frames per second where t is a number of a frame; metres per pixel where x and y are pixels.
    start, stop
        The first and last time that are used, in s.
    noise_position, noise_angle
        Standard deviations of a coordinate in m and of the angle in rad; None to take them from the residuals.
    starts
        Number of starts of the search.

    Notes
    -----
    Without the angle the film tells the ratio ``v/(|spin| R)`` in place of radius and spin. At most 5 % of the
    frames are left out as outliers, beyond 6 standard deviations.

    Examples
    --------
    >>> import numpy as np
    >>> import tribos
    >>> puck = tribos.Friction(tribos.disk(0.03), mu=0.2)
    >>> t = np.arange(60) / 60.0
    >>> path = tribos.slide_path(puck, 1.5, 40.0, t)
    >>> film = {"t": t, "x": path.distance, "y": 0.0 * t, "angle": path.angle}
    >>> found = tribos.fit_track(film)
    >>> round(found["mu"], 4), round(found["R"], 4)
    (0.2, 0.03)
    >>> again = tribos.slide_path(found.friction, **found.launch, times=t)
    >>> bool(np.abs(again.distance - path.distance).max() < 1e-5)
    True
    """
    wanted = [(name, name != "angle", False) for name in ("t", "x", "y", "angle")]
    table = read(data, wanted, columns, units, skip).columns
    factors = {}
    if frame_rate is not None:
        factors["t"] = 1.0 / positive("frame_rate", frame_rate)
    if scale is not None:
        factors["x"] = factors["y"] = positive("scale", scale)
    film = {name: values * factors.get(name, 1.0) for name, values in table.items()}
    count = int(starts)
    if not 0 < count <= _MOST_STARTS:
        raise ValueError(f"starts must be a whole number from 1 to {_MOST_STARTS}, not {starts!r}")
    keep = [(str(name), number(name, value)) for name, value in (fixed or {}).items()]
    noise = [
        None if value is None else positive(name, value)
        for name, value in (("noise_position", noise_position), ("noise_angle", noise_angle))
    ]
    made = _native.fit_track(
        (
            film["t"].tolist(),
            film["x"].tolist(),
            film["y"].tolist(),
            film["angle"].tolist() if "angle" in film else None,
        ),
        law,
        patch,
        keep,
        (
            positive("gravity", gravity),
            positive("inertia_ratio", inertia_ratio),
            noise[0],
            noise[1],
        ),
        (0, start, stop, count),
    )
    estimates = estimates_of(made.pop("estimates"))
    residuals: Array = np.array(made.pop("residuals")).reshape(-1, made["rows"])
    return TrackFit(
        estimates=estimates,
        law=Law(made.pop("law")),
        patch=patch,
        dropped=tuple(made.pop("dropped")),
        warnings=tuple(made.pop("warnings")),
        times=np.array(made.pop("times")),
        speeds=np.array(made.pop("speeds")),
        residuals=residuals,
        _radius=dict(keep).get("R"),
        **made,
    )
