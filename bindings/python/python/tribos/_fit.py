"""Parameters of laws from measurements, and the pressure under a foot from pushes."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, positive
from tribos._laws import Law
from tribos._log import Log, column, names_of, read, read_pushes, roles
from tribos._patches import Patch, outline, points
from tribos._surface import LimitSurface

Array = NDArray[np.float64]
_PUSHES = ("dx", "dy", "dtheta", "fx", "fy", "torque")


@dataclass(frozen=True)
class Estimate:
    """One fitted parameter.

    Attributes
    ----------
    name, unit, meaning : str
        Description of the parameter.
    value : float
        Its value.
    error : float
        Its standard error; 0 if it was fixed, NaN where the data give none.
    state : str
        ``"determined"``, ``"fixed"``, ``"at its bound"`` or ``"not determined"``.
    trades_with : tuple of str
        Parameters with which the data determine only a combination.
    interval : tuple of float
        Ends of the interval that covers the true value in 95 of 100 cases; infinite where the data do not
        bound it.
    """

    name: str
    unit: str
    meaning: str
    value: float
    error: float
    state: str
    trades_with: tuple[str, ...] = ()
    interval: tuple[float, float] = (-np.inf, np.inf)


@dataclass(frozen=True, eq=False)
class LawFit:
    """A law fitted to measurements.

    Attributes
    ----------
    name : str
        The law's name in `fit`.
    estimates : tuple of Estimate
        All parameters.
    covariance : numpy.ndarray
        Covariance of the parameters with the state ``"determined"``, in their order.
    predictions : numpy.ndarray
        Friction of each point.
    deviation : float
        Standard deviation of the residuals, in the unit of friction; with a column sigma the square
        root of the reduced χ².
    freedoms : int
        Number of points minus number of free parameters.
    is_weighted : bool
        Whether there was a column sigma.
    converged : bool
        Whether rounding alone limited further descent.
    starts, at_best : int
        Starts from which a search was possible, and those that ended at the best minimum.
    error_factor : float
        Factor, at least 1, by which errors and intervals were enlarged because residuals follow each other
        over time.
    warnings : tuple of str
        What to know before the numbers are used.
    read : tuple of str
        What was understood of data that are not in columns of SI named v, f and the like.
    dropped : dict of str to int
        Numbers of rows that were left out, by reason.
    """

    name: str
    estimates: tuple[Estimate, ...]
    covariance: Any = field(repr=False)
    predictions: Any = field(repr=False)
    deviation: float
    freedoms: int
    is_weighted: bool
    converged: bool
    starts: int
    at_best: int
    is_record: bool
    is_per_load: bool
    has_spring: bool
    error_factor: float
    warnings: tuple[str, ...]
    _spec: str | None = field(repr=False)
    read: tuple[str, ...] = ()
    dropped: dict[str, int] = field(default_factory=dict)

    @property
    def parameters(self) -> dict[str, float]:
        """Values by name."""
        return {estimate.name: estimate.value for estimate in self.estimates}

    @property
    def errors(self) -> dict[str, float]:
        """Standard errors by name; 0 if fixed, NaN where the data give none."""
        return {estimate.name: estimate.error for estimate in self.estimates}

    def __getitem__(self, name: str) -> float:
        return self.parameters[name]

    @property
    def intervals(self) -> dict[str, tuple[float, float]]:
        """Intervals of 95 % by name."""
        return {estimate.name: estimate.interval for estimate in self.estimates}

    @property
    def rms(self) -> float:
        """Root mean square of the residuals, in the unit of friction; with a column sigma over it."""
        return float(self.deviation * np.sqrt(self.freedoms / len(self.predictions)))

    @property
    def law(self) -> Law:
        """The fitted law of steady sliding, as a law of the local speed; ValueError where there is none."""
        if self._spec is None:
            raise ValueError(f"no law of the speed is like {self.name}")
        name, _, rest = self._spec.partition(":")
        pairs = (pair.split("=") for pair in rest.split(",") if pair)
        return Law(name, **{key: float(value) for key, value in pairs})

    def usage(self, target: str) -> str:
        """The fitted law as text: ``"rust"``, ``"c"``, ``"python"``, ``"scene"``, ``"mujoco"``, ``"newton"``, ``"gazebo"``."""
        return _native.fit_usage(self.name, list(self.parameters.items()), self.is_per_load, target)

    def predict(self, speeds: ArrayLike, times: ArrayLike | None = None) -> Any:
        """Friction of the fitted law alone, per load if loads were known, without inertia and offset.

        Parameters
        ----------
        speeds
            Velocities in m/s, none 0; or, with times, those of a record, which begins in steady sliding.
        times
            Rising times of the record, in s: for laws that were fitted to a record over time.
        """
        if (times is not None) != self.is_record:
            wanted = "times as well" if self.is_record else "speeds alone"
            raise ValueError(f"this fit predicts from {wanted}")
        velocities = np.asarray(speeds, dtype=np.float64)
        moments = None if times is None else column("times", times).tolist()
        machine = ("inertia", "offset")
        values = [estimate.value for estimate in self.estimates if estimate.name not in machine]
        flat = velocities.ravel().tolist()
        made = _native.predict_law(self.name, flat, moments, values, self.has_spring)
        return np.array(made).reshape(velocities.shape)[()]

    def __repr__(self) -> str:
        width = max(len(estimate.name) for estimate in self.estimates)
        lines = [f"<{self.name} fitted to {len(self.predictions)} points>"]
        for estimate in self.estimates:
            value, how = _told(estimate)
            unit = f"[{estimate.unit}]"
            lines.append(
                f"  {estimate.name:<{width}}  {value:<12} {how:<16} {unit} {estimate.meaning}"
            )
        lines.extend(f"  warning: {warning}" for warning in self.warnings)
        what = "square root of reduced chi²" if self.is_weighted else "residuals"
        end = "" if self.converged else "; the search did not converge"
        lines.append(
            f"  {what} {self.deviation:.4g} over {self.freedoms} degrees of freedom; "
            f"{self.at_best} of {self.starts} starts agree{end}"
        )
        return "\n".join(lines)


@dataclass(frozen=True, eq=False)
class SupportFit:
    """The pressure under a foot from pushes, and how well models foretell motions.

    Attributes
    ----------
    angles : dict of str to tuple of float
        Median and mean angle in degrees between foretold and measured motions, of the models
        ``"known"`` (the given patch), ``"pressure"``, ``"ellipsoid"`` and ``"quartic"``; fitted ones
        are cross-validated in 5 parts.
    pressure : numpy.ndarray
        Points of the foot with x and y in m and the friction limit of the point, ``mu`` times its load,
        in N, of shape (n, 3).
    centre_of_pressure : tuple of float
        In m.
    force_limit : float
        Sum of the points' friction limits, in N.
    length : float
        By which spins are multiplied in angles, in m.
    """

    angles: dict[str, tuple[float, float]]
    pressure: Any = field(repr=False)
    centre_of_pressure: tuple[float, float]
    force_limit: float
    length: float

    @property
    def patch(self) -> Patch:
        """The fitted pressure as a patch of points."""
        return points(self.pressure[:, :2], self.pressure[:, 2])

    def limit_surface(self) -> LimitSurface:
        """The limit surface of the fitted pressure."""
        return LimitSurface(self.patch, 1.0, self.force_limit)

    def __repr__(self) -> str:
        x, y = self.centre_of_pressure
        lines = [
            f"<pressure on {len(self.pressure)} points: centre at ({1e3 * x:.4g}, {1e3 * y:.4g}) mm, "
            f"force limit {self.force_limit:.5g} N>",
            "  model       median   mean angle between foretold and measured motion [deg]",
        ]
        for name, (median, mean) in self.angles.items():
            lines.append(f"  {name:<11} {median:6.2f} {mean:6.2f}")
        return "\n".join(lines)


@dataclass(frozen=True, eq=False)
class Compared:
    """A law on data that it shares with others.

    Attributes
    ----------
    fit : LawFit
        Its fit to all points.
    akaike : float
        Akaike's criterion less that of the best law.
    foretold : float
        Root mean square of residuals of points that the fit has not seen, in five parts; NaN where that would
        take too long.
    is_told_apart : bool
        Whether the data tell this law from the best one.
    """

    fit: LawFit
    akaike: float
    foretold: float
    is_told_apart: bool


def fit(
    law: str,
    data: Any,
    *,
    columns: Mapping[str, str | int] | None = None,
    units: Mapping[str, str] | None = None,
    skip: int = 0,
    load: float | None = None,
    slowest: float = 0.0,
    inertia: bool = False,
    offset: bool = False,
    spring: float | str | None = None,
    fixed: Mapping[str, float] | None = None,
    starts: int = 16,
) -> LawFit:
    """Fit a law of friction to measurements by nonlinear least squares.

    Parameters
    ----------
    law
        ``"coulomb"``, ``"viscous"``, ``"stribeck"``, ``"tanh"``, ``"arctan"``, ``"rising"``, ``"power"``,
        ``"amontons"``, ``"elastic-plastic"``, ``"dahl"``, ``"elasto-plastic"``, ``"lugre"``, ``"maxwell"``,
        ``"rate-state"`` or ``"rate-state-slip"``.
    data
        A table with the columns ``v`` and ``f``: friction of steady sliding at velocities in m/s; or ``t``,
        ``v`` and ``f``: a record over time in s; either with ``sigma``, the standard deviation of f, ``load``
        in N, ``a`` in m/s². A mapping of columns, a structured array, a data frame, or the path of a
        file with commas, semicolons, tabs or blanks between columns. Usual names in English and German
        and units in names, such as ``"Speed [mm/s]"``, are understood: `look` shows how. Rows without a
        number, rows whose time does not rise, and rows at rest under laws of sliding are dropped.
    columns
        Names or numbers from 1 of columns, such as ``{"t": "Time", "f": "-Fx"}``: a minus changes the
        sign, ``"none"`` leaves a column out.
    units
        Units of columns, before those in their names, such as ``{"v": "mm/s"}``.
    skip
        Lines at the beginning of a file that are left out.
    load
        Load in N at which f was measured as a force: parameters are then coefficients.
    slowest
        Speed in m/s up to which rows count as rest, and are left out under laws of sliding.
    inertia, offset
        Whether an inertia that is accelerated, and a constant force, are fitted as well.
    spring
        Under rate and state, v is the speed of the load point, and between it and the contact lies a spring:
        its stiffness per load in 1/m, or ``"fit"``.
    fixed
        Parameters that keep these values.
    starts
        Number of starts of the search.

    Notes
    -----
    Reference problems of NIST are reproduced to 8 digits of the parameters and 6 of their errors. The
    same data give the same bits.

    Examples
    --------
    >>> import tribos
    >>> speeds = [0.25, 0.5, 1.0, 2.0, 4.0]
    >>> found = tribos.fit("power", {"v": speeds, "f": [0.016, 0.0113, 0.008, 0.0057, 0.004]})
    >>> {name: round(value, 3) for name, value in found.parameters.items()}
    {'gamma': 0.008, 'alpha': -0.499}
    """
    usual = (("a",) if inertia else ()) + (("load",) if law == "amontons" else ())
    log = read(data, roles(usual), columns, units, skip)
    machine, keep = _machine(inertia, offset, spring, fixed)
    made = _native.fit_law(
        law, _columns(log, load, slowest, machine), machine, keep, _count(starts)
    )
    return _law_fit(made, log, machine)


def compare(
    data: Any,
    *,
    columns: Mapping[str, str | int] | None = None,
    units: Mapping[str, str] | None = None,
    skip: int = 0,
    load: float | None = None,
    slowest: float = 0.0,
    inertia: bool = False,
    offset: bool = False,
    fixed: Mapping[str, float] | None = None,
    starts: int = 16,
) -> list[Compared]:
    """Fit all laws that the data admit; the best comes first by Akaike's criterion.

    Parameters
    ----------
    data, columns, units, skip, load, slowest, inertia, offset, fixed, starts
        As in `fit`; a parameter that is kept concerns the laws that have it.

    Examples
    --------
    >>> import tribos
    >>> v = [0.01 * k for k in range(1, 41)]
    >>> f = [0.2 + 0.5 * x + 0.001 * (-1) ** k for k, x in enumerate(v)]
    >>> tribos.compare({"v": v, "f": f})[0].fit.name
    'viscous'
    """
    log = read(data, roles(("a",) if inertia else ()), columns, units, skip)
    machine, keep = _machine(inertia, offset, None, fixed)
    found, _ = _native.fit_all_laws(
        _columns(log, load, slowest, machine), machine, keep, _count(starts)
    )
    return [
        Compared(
            _law_fit(made, log, machine), made["akaike"], made["foretold"], made["is_told_apart"]
        )
        for made in found
    ]


def _count(starts: int) -> int:
    count = int(starts)
    if not 0 < count <= 10_000:
        raise ValueError(f"starts must be a whole number from 1 to 10000, not {starts!r}")
    return count


def _machine(
    inertia: bool, offset: bool, spring: float | str | None, fixed: Mapping[str, float] | None
) -> tuple[tuple[bool, bool, bool], list[tuple[str, float]]]:
    """What is fitted beside the law, and parameters that are kept."""
    keep = [(str(name), number(name, value)) for name, value in (fixed or {}).items()]
    if isinstance(spring, str) and spring != "fit":
        raise ValueError(f'spring must be a stiffness per load in 1/m or "fit", not {spring!r}')
    if spring is not None and not isinstance(spring, str):
        keep.append(("spring", positive("spring", spring)))
    return (bool(inertia), bool(offset), spring is not None), keep


def _columns(
    log: Log, load: float | None, slowest: float, machine: tuple[bool, bool, bool]
) -> dict[str, Any]:
    """Columns by role, with a load that is given as one, and how they are to be taken."""
    rest = number("slowest", slowest)
    if rest < 0.0:
        raise ValueError(f"slowest must be >= 0, not {slowest!r}")
    table: dict[str, Any] = {
        name: log.columns[name].tolist() if name in log.columns else None
        for name in ("t", "v", "f", "sigma", "a", "load")
    }
    if load is not None:
        if table["load"] is not None:
            raise ValueError("a column load and load are both given; leave one out")
        table["load"] = [positive("load", load)] * len(log.columns["f"])
    return {**table, "rest": rest, "inertia": machine[0], "offset": machine[1]}


def estimates_of(rows: list[dict[str, Any]]) -> tuple[Estimate, ...]:
    """Fitted parameters."""
    tuples = ("trades_with", "interval")
    made: list[dict[str, Any]] = [
        {**row, **{key: tuple(row[key]) for key in tuples}} for row in rows
    ]
    return tuple(Estimate(**row) for row in made)


def _law_fit(made: dict[str, Any], log: Log, machine: tuple[bool, bool, bool]) -> LawFit:
    free = sum(row["state"] == "determined" for row in made["estimates"])
    counts = zip(("at rest", "without a load"), made["left_out"], strict=True)
    left_out = {why: count for why, count in counts if count}
    return LawFit(
        name=made["name"],
        estimates=estimates_of(made["estimates"]),
        covariance=np.array(made["covariance"]).reshape(free, free),
        predictions=np.array(made["predictions"]),
        deviation=made["deviation"],
        freedoms=made["freedoms"],
        is_weighted=made["is_weighted"],
        converged=made["converged"],
        starts=made["starts"],
        at_best=made["at_best"],
        is_record="t" in log.columns,
        is_per_load=made["is_per_load"],
        has_spring=machine[2],
        error_factor=made["error_factor"],
        warnings=tuple(made["warnings"]),
        _spec=made["law"],
        read=log.brief,
        dropped={**log.dropped, **left_out},
    )


def fit_support(pushes: Any, patch: Patch | None = None) -> SupportFit:
    """Fit the pressure under a foot to quasi-static pushes, and compare models.

    Parameters
    ----------
    pushes
        At least 10 pushes in the coordinates of the body: motions ``dx``, ``dy``, ``dtheta`` in m and
        rad, of which the direction counts, and the wrenches ``fx``, ``fy``, ``torque`` of the pusher on
        the body in N and N m. An array of shape (n, 6) in this order, or a table with these columns as in
        `fit`.
    patch
        The support, if it is known: a polygon, box, bar, mesh or points. None for points on a grid
        around the origin.

    Examples
    --------
    >>> import numpy as np
    >>> import tribos
    >>> tile = tribos.box(0.2, 0.1)
    >>> floor = tribos.Friction(tile, mu=0.4).limit_surface(load=10.0)
    >>> i = np.arange(40.0)
    >>> motions = np.column_stack((np.sin(0.7 * i), np.cos(0.7 * i), 15 * np.sin(1.3 * i)))
    >>> pushes = np.hstack((motions, -floor.wrench(motions)))
    >>> found = tribos.fit_support(pushes, tile)
    >>> round(found.force_limit, 1), found.angles["known"][0] < 1e-6       # N; degrees
    (4.0, True)
    """
    if isinstance(pushes, (list, tuple)) or (
        isinstance(pushes, np.ndarray) and pushes.dtype.names is None
    ):
        rows = np.asarray(pushes, dtype=np.float64)
        if rows.ndim != 2 or rows.shape[1] != 6:
            raise ValueError(f"pushes must have shape (n, 6), not {rows.shape}")
    elif isinstance(pushes, (str, os.PathLike)):
        rows = read_pushes(pushes)
    else:
        rows = _rows(pushes, _PUSHES)
    if patch is not None and not isinstance(patch, Patch):
        raise ValueError(f"the patch must be made by tribos.box and the like, not {patch!r}")
    loops = [] if patch is None else outline(patch)
    handle = None if patch is None else patch._handle
    made = _native.fit_support(rows.tolist(), handle, loops)
    x, y = made["centre_of_pressure"]
    return SupportFit(
        angles={name: (median, mean) for name, median, mean in made["models"]},
        pressure=np.array(made["pressure"]).reshape(-1, 3),
        centre_of_pressure=(x, y),
        force_limit=made["force_limit"],
        length=made["length"],
    )


def _rows(table: Any, names: tuple[str, ...]) -> Array:
    """The columns of these names side by side."""
    there = names_of(table, names)
    missing = [name for name in names if name not in there]
    if missing:
        raise ValueError(
            f"there is no column {', '.join(missing)}; the columns are {', '.join(there) or 'none'}"
        )
    return np.column_stack([column(name, table[name]) for name in names])


def _told(estimate: Estimate) -> tuple[str, str]:
    """Value and error, with two digits of the error."""
    if estimate.state != "determined" or not estimate.error > 0.0:
        return f"{estimate.value:.6g}", estimate.state if estimate.error != 0.0 else "fixed"
    size = abs(estimate.value) if estimate.value else estimate.error
    digits = int(np.floor(np.log10(size)) - np.floor(np.log10(estimate.error))) + 2
    return f"{estimate.value:.{min(max(digits, 1), 15)}g}", f"± {estimate.error:.2g}"
