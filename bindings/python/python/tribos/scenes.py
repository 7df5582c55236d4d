"""Scenes, one class a body: made by tools/scenes.py from the library's tables of keys.

Lengths, times and forces are in the units that each field names; "-" is a pure number or a word.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from tribos._scene import Scene


@dataclass(frozen=True, kw_only=True, slots=True)
class SliderScene(Scene):
    """A disk that slides and spins to rest."""

    BODY: ClassVar[str] = "disk"

    speed: float = 1.0
    """Initial sliding speed. *Unit*: m/s. *Value*: a finite number >= 0."""
    spin: float = 5.0
    """Initial spin, of either sign. *Unit*: rad/s. *Value*: a finite number."""
    coefficient: float | None = 0.3
    """Friction coefficient of the local law: mu for alpha = 0. *Unit*: (s/m)^alpha. *Value*: a
    finite number > 0."""
    alpha: float | None = 0.0
    """Exponent of the local law |v|^alpha, 0 for Coulomb. *Value*: a number > -1 and <= 128."""
    law: str | None = None
    """Local law in place of `coefficient` and `alpha`. *Value*: a law with its parameters, such as
    "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05"."""
    gravity: float = 9.81
    """Acceleration that presses the body down. *Unit*: m/s^2. *Value*: a finite number > 0."""
    radius: float = 0.08
    """Radius of the contact. *Unit*: m. *Value*: a finite number > 0."""
    mass: float = 0.1
    """Mass of the body. *Unit*: kg. *Value*: a finite number > 0."""
    inertia_ratio: float = 0.5
    """Inertia ratio C = I/(M R^2), 0.5 for a disk. *Value*: a finite number > 0."""
    stop_fraction: float = 0.0001
    """Fraction of their start below which both speeds count as rest, for alpha >= 1. *Value*: a
    number > 0 and <= 0.5."""
    time_step: float | None = None
    """Length of a step; if left out it is chosen from the motion. *Unit*: s. *Value*: a finite
    number > 0."""
    duration: float | None = None
    """End of the run; if left out it is rest. *Unit*: s. *Value*: a finite number > 0."""
    samples: int = 200
    """Number of recorded steps, where `time_step` is left out. *Value*: a whole number from 1 to
    1000000."""
    units: Literal["si", "dimensionless"] = "si"
    """Unit system. *Value*: one of "si", "dimensionless"."""
    stepper: Literal["exact", "verlet"] = "exact"
    """Method that follows the motion. *Value*: one of "exact", "verlet"."""


@dataclass(frozen=True, kw_only=True, slots=True)
class CylinderScene(Scene):
    """A tall cylinder that slides and spins to rest."""

    BODY: ClassVar[str] = "cylinder"

    speed: float = 1.0
    """Initial speed, along x. *Unit*: m/s. *Value*: a finite number >= 0."""
    spin: float = 5.0
    """Initial spin, > 0 counterclockwise. *Unit*: rad/s. *Value*: a finite number."""
    coefficient: float | None = 0.2
    """Friction coefficient of the local law: mu for alpha = 0. *Unit*: (s/m)^alpha. *Value*: a
    finite number > 0."""
    alpha: float = 0.0
    """Exponent of the local law |v|^alpha, 0 for Coulomb. *Value*: a number > -1 and <= 128."""
    law: str | None = None
    """Local law in place of `coefficient` and `alpha`. *Value*: a law with its parameters, such as
    "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05"."""
    radius: float = 0.08
    """Outer radius. *Unit*: m. *Value*: a finite number > 0."""
    height: float | None = 0.16
    """Height of the body; its centre of mass is half way up. *Unit*: m. *Value*: a finite number >=
    0."""
    gradient: Literal["all-round", "front-back"] = "all-round"
    """Directions in which the pressure may lean. *Value*: one of "all-round", "front-back"."""
    pressure: Literal["uniform", "ring", "flat-punch", "hertz", "paraboloid"] = "uniform"
    """Pressure at rest. *Value*: one of "uniform", "ring", "flat-punch", "hertz", "paraboloid"."""
    inertia_ratio: float = 0.5
    """Inertia ratio C = I/(M R^2), 0.5 for a solid, uniform cylinder. *Value*: a finite number >
    0."""
    tipping: Literal["refuse", "clamp"] = "refuse"
    """What to do where the body would tip. *Value*: one of "refuse", "clamp"."""
    gravity: float = 9.81
    """Acceleration that presses the body down. *Unit*: m/s^2. *Value*: a finite number > 0."""
    mass: float = 1.0
    """Mass of the body. *Unit*: kg. *Value*: a finite number > 0."""
    stop_fraction: float = 0.0001
    """Fraction of their start below which both speeds count as rest, for alpha >= 1. *Value*: a
    number > 0 and <= 0.5."""
    samples: int = 200
    """Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000."""


@dataclass(frozen=True, kw_only=True, slots=True)
class PipeScene(Scene):
    """An upright pipe that slides and spins to rest."""

    BODY: ClassVar[str] = "pipe"

    speed: float = 1.74
    """Initial speed, along x. *Unit*: m/s. *Value*: a finite number >= 0."""
    spin: float = 10.2
    """Initial spin, > 0 counterclockwise. *Unit*: rad/s. *Value*: a finite number."""
    coefficient: float | None = 0.2
    """Friction coefficient of the local law: mu for alpha = 0. *Unit*: (s/m)^alpha. *Value*: a
    finite number > 0."""
    alpha: float = 0.0
    """Exponent of the local law |v|^alpha, 0 for Coulomb. *Value*: a number > -1 and <= 128."""
    law: str | None = None
    """Local law in place of `coefficient` and `alpha`. *Value*: a law with its parameters, such as
    "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05"."""
    radius: float = 0.05
    """Outer radius. *Unit*: m. *Value*: a finite number > 0."""
    height: float | None = 0.15
    """Height of the body; its centre of mass is half way up. *Unit*: m. *Value*: a finite number >=
    0."""
    gradient: Literal["all-round", "front-back"] = "all-round"
    """Directions in which the pressure may lean. *Value*: one of "all-round", "front-back"."""
    inner_radius: float = 0.046
    """Inner radius of the pipe; the outer one for a thin ring. *Unit*: m. *Value*: a finite number
    >= 0."""
    tipping: Literal["refuse", "clamp"] = "refuse"
    """What to do where the body would tip. *Value*: one of "refuse", "clamp"."""
    gravity: float = 9.81
    """Acceleration that presses the body down. *Unit*: m/s^2. *Value*: a finite number > 0."""
    mass: float = 0.5
    """Mass of the body. *Unit*: kg. *Value*: a finite number > 0."""
    stop_fraction: float = 0.0001
    """Fraction of their start below which both speeds count as rest, for alpha >= 1. *Value*: a
    number > 0 and <= 0.5."""
    samples: int = 200
    """Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000."""


@dataclass(frozen=True, kw_only=True, slots=True)
class PlateScene(Scene):
    """A flat plate that slides and spins to rest."""

    BODY: ClassVar[str] = "plate"

    patch: str = "box:0.3x0.2"
    """Outline of the plate. *Value*: a patch such as "box:0.3x0.2", "polygon:FILE" or "disk"."""
    speed: float = 1.0
    """Initial speed, along x. *Unit*: m/s. *Value*: a finite number >= 0."""
    spin: float = 5.0
    """Initial spin, > 0 counterclockwise. *Unit*: rad/s. *Value*: a finite number."""
    orientation: float = 0.0
    """Angle from the direction of the launch to the outline's x axis, > 0 counterclockwise. *Unit*:
    rad. *Value*: a finite number."""
    coefficient: float = 0.3
    """Coulomb's friction coefficient. *Value*: a finite number > 0."""
    gyration_radius: float | None = None
    """Radius of gyration about the upright axis; that of a plate of uniform thickness if it is left
    out. *Unit*: m. *Value*: a finite number > 0."""
    gravity: float = 9.81
    """Acceleration that presses the plate down. *Unit*: m/s^2. *Value*: a finite number > 0."""
    mass: float = 0.5
    """Mass of the plate. *Unit*: kg. *Value*: a finite number > 0."""
    samples: int = 200
    """Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000."""


@dataclass(frozen=True, kw_only=True, slots=True)
class CurlingScene(Scene):
    """A curling rock."""

    BODY: ClassVar[str] = "curling"

    speed: float = 2.0
    """Initial speed, along x. *Unit*: m/s. *Value*: a finite number >= 0."""
    spin: float = 1.5
    """Initial spin, > 0 counterclockwise. *Unit*: rad/s. *Value*: a finite number."""
    radius: float = 0.0625
    """Outer radius of the running band. *Unit*: m. *Value*: a finite number > 0."""
    band_width: float = 0.0
    """Width of the band, 0 for a thin ring. *Unit*: m. *Value*: a finite number >= 0."""
    centre_height: float = 0.057
    """Height of the centre of mass. *Unit*: m. *Value*: a finite number >= 0."""
    inertia_ratio: float = 2.6912
    """Inertia ratio C = I/(M R^2) with R of the band; the default is that of a solid of 29 cm.
    *Value*: a finite number > 0."""
    gravity: float = 9.81
    """Acceleration that presses the rock down. *Unit*: m/s^2. *Value*: a finite number > 0."""
    mass: float = 20.0
    """Mass of the rock. *Unit*: kg. *Value*: a finite number > 0."""
    model: Literal["left-right", "dry", "front-back", "back-heavy", "film", "pivot-slide", "scratch-guide"] = (
        "left-right"
    )
    """Why the rock curls; see docs/curling.md. *Value*: one of "left-right", "dry", "front-back",
    "back-heavy", "film", "pivot-slide", "scratch-guide"."""
    coefficient: float | None = None
    """Friction coefficient of the ice; if left out that of the model: 0.007095 for dry, else 0.008.
    *Unit*: (s/m)^alpha. *Value*: a finite number > 0."""
    alpha: float | None = None
    """Exponent of the ice; if left out that of the model: 0 for dry, else -0.5. *Value*: a number >
    -1 and <= 0.9."""
    back_to_front: float | None = None
    """Friction at the back over that in front, of the model back-heavy. *Value*: a finite number >
    0."""
    film_front: float | None = None
    """Fraction of the band's rotation that the film takes in front, of the model film. *Value*: a
    number from 0 to 1."""
    film_back: float | None = None
    """Fraction of the band's rotation that the film takes at the back, of the model film. *Value*:
    a number from 0 to 1."""
    pivot: float | None = None
    """Weight of the pull, of the model pivot-slide. *Value*: a finite number >= 0."""
    scratch: float | None = None
    """Guiding force over load, of the model scratch-guide. *Value*: a finite number >= 0."""
    scratch_onset: float | None = None
    """Half the crossing angle from which scratches guide, of the model scratch-guide. *Unit*: rad.
    *Value*: a finite number > 0."""
    samples: int = 200
    """Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000."""


@dataclass(frozen=True, kw_only=True, slots=True)
class PowderScene(Scene):
    """A powder under a piston."""

    BODY: ClassVar[str] = "powder"

    width: float = 20.0
    """Side of the square base, periodic in x and y. *Unit*: R. *Value*: a finite number > 0."""
    height: float | None = 61.5
    """Height at which the deposit is cut and the piston starts, unless `count` is given. *Unit*: R.
    *Value*: a finite number > 0."""
    count: int | None = None
    """Number of spheres, in place of `height`. *Value*: a whole number from 1 to 1000000."""
    capture_radius: float = 3.0
    """Distance of centres at which a falling sphere is captured. *Unit*: R. *Value*: a finite
    number > 0."""
    radius_spread: float = 0.0
    """Spread of the radii, which are uniform from 1 - spread to 1 + spread. *Unit*: R. *Value*: a
    finite number >= 0."""
    seed: int = 1
    """Seed of the deposit's random numbers. *Value*: a whole number from 1 to 9007199254740992."""
    sliding: float = 0.3
    """Sliding coefficient mu: largest sliding force over P = F_n + F_coh. *Value*: a finite number
    >= 0."""
    rolling: float = 0.0
    """Rolling coefficient mu_t: largest rolling torque over P r_eff. *Value*: a finite number >=
    0."""
    torsion: float = 0.0
    """Torsion coefficient mu_n: largest torsion torque over P r_eff. *Value*: a finite number >=
    0."""
    coupling: Literal["independent", "ellipsoid", "exact"] = "independent"
    """How the thresholds of sliding and torsion depend on each other. *Value*: one of
    "independent", "ellipsoid", "exact"."""
    pressure: float = 0.0025
    """Pressure on the piston. *Unit*: F_coh/R^2. *Value*: a finite number > 0."""
    cohesion_range: float = 0.01
    """Gap d_c up to which cohesion acts. *Unit*: R. *Value*: a finite number >= 0."""
    attraction: Literal["pull", "resistance"] = "pull"
    """Cohesion at a gap: a constant pull, or a resistance to opening. *Value*: one of "pull",
    "resistance"."""
    restitution: float = 0.0
    """Coefficient of restitution: speed after an impact over speed before, at walls too. *Value*: a
    number from 0 to 1."""
    wall: Literal["full", "smooth", "none"] = "full"
    """Law at substrate and piston: that of spheres, cohesion only, or neither. *Value*: one of
    "full", "smooth", "none"."""
    piston_mass: float = 1000.0
    """Mass of the piston. *Unit*: rho R^3. *Value*: a finite number > 0."""
    solver: Literal["accelerated", "gauss-seidel"] = "accelerated"
    """Method for the contacts of a step. *Value*: one of "accelerated", "gauss-seidel"."""
    order: Literal["alternating", "fixed", "random"] = "alternating"
    """Order of the contacts in a sweep of gauss-seidel. *Value*: one of "alternating", "fixed",
    "random"."""
    stop: Literal["global", "local", "fixed"] = "global"
    """When gauss-seidel stops: by the change of all or of any contacts, or after `sweeps`. *Value*:
    one of "global", "local", "fixed"."""
    tolerance: float = 0.0001
    """Change of a sweep, relative to P, at which sweeps stop. *Value*: a number > 0 and <= 1."""
    sweeps: int = 1000
    """Most sweeps of a step, N_I; all of them with stop = "fixed". *Value*: a whole number from 1
    to 1000000."""
    warm_start: Literal["on", "off"] = "on"
    """Whether a step starts from the forces of the last one. *Value*: one of "on", "off"."""
    motion: float = 0.05
    """Largest distance that a sphere may move in a step. *Unit*: R. *Value*: a number > 0 and <=
    0.5."""
    time_step: float = 0.2
    """Longest time step. *Unit*: sqrt(rho R^4/F_coh). *Value*: a finite number > 0."""
    still_speed: float = 1e-07
    """Sleep threshold: slower groups that nothing touches are left alone; with 0 none is. *Unit*:
    sqrt(F_coh/rho)/R. *Value*: a finite number >= 0."""
    blocked: Literal["balance", "piston"] = "balance"
    """Criterion of the end: forces balance and the piston stands, or the piston stands. *Value*:
    one of "balance", "piston"."""
    steps: int = 200000
    """Steps after which a run ends that is not blocked before. *Value*: a whole number from 1 to
    1000000000."""
    duration: float | None = None
    """Time after which a run ends that is not blocked before; if left out there is no such bound.
    *Unit*: sqrt(rho R^4/F_coh). *Value*: a finite number > 0."""
    samples: int = 20
    """Steps from one line of the series to the next. *Value*: a whole number from 1 to
    1000000000."""


@dataclass(frozen=True, kw_only=True, slots=True)
class TipScene(Scene):
    """A tip turned on a substrate."""

    BODY: ClassVar[str] = "tip"

    spacing: float = 1.122462048309373
    """Distance of neighbours in the crystal; the default is that of the potential's minimum.
    *Unit*: sigma. *Value*: a number > 0.5 and <= 2."""
    columns: int = 28
    """Atoms along x in a layer of the substrate, periodic. *Value*: a whole number from 1 to
    1000."""
    rows: int = 28
    """Rows of atoms along y, an even number, periodic. *Value*: a whole number from 1 to 1000."""
    substrate_layers: int = 6
    """Layers of the substrate: two frozen, two with a thermostat, the rest free; at least 4.
    *Value*: a whole number from 1 to 100."""
    tip_layers: int = 6
    """Layers of the tip: two driven, two with a thermostat, the rest free; at least 4. *Value*: a
    whole number from 1 to 100."""
    side: int = 10
    """Atoms on a side of the tip's top layer. *Value*: a whole number from 1 to 300."""
    outline: Literal["hexagon", "disk", "cone"] = "hexagon"
    """Outline of the tip's layers. *Value*: one of "hexagon", "disk", "cone"."""
    orientation: float = 0.0
    """Angle by which the tip is turned out of registry. *Unit*: degree. *Value*: a number > -180
    and <= 180."""
    raise_: float = 0.0
    """Height of the driven layers above their place in the crystal. *Unit*: sigma. *Value*: a
    finite number."""
    lambda_: float = 0.017
    """Drive: force on each driven atom, see `reading`. *Unit*: eps/sigma^2. *Value*: a finite
    number."""
    reading: Literal["angular", "mean", "largest"] = "angular"
    """Meaning of lambda: the force at a distance of sigma from the axis, or the mean or largest
    force. *Value*: one of "angular", "mean", "largest"."""
    hold: Literal["plane", "level"] = "plane"
    """How driven layers are held: z of each atom fixed, or z common and free under `load`. *Value*:
    one of "plane", "level"."""
    load: float | None = None
    """Force on each driven atom towards the substrate; if left out it is 0. *Unit*: eps/sigma.
    *Value*: a finite number."""
    cutoff: float = 2.5
    """Cut-off radius of the Lennard-Jones potential. *Unit*: sigma. *Value*: a number > 1 and <=
    10."""
    shift: Literal["none", "energy", "force"] = "none"
    """How the potential is shifted at the cut-off. *Value*: one of "none", "energy", "force"."""
    adhesion: float = 1.0
    """Depth of the potential between tip and substrate. *Unit*: eps. *Value*: a finite number >
    0."""
    temperature: float = 0.1
    """Target temperature of the thermostats. *Unit*: eps/k_B. *Value*: a finite number >= 0."""
    thermostat: Literal["nose-hoover", "langevin", "none"] = "nose-hoover"
    """Thermostat of the bath layers. *Value*: one of "nose-hoover", "langevin", "none"."""
    relaxation: float = 0.5
    """Relaxation time of the Nose-Hoover thermostat. *Unit*: tau. *Value*: a finite number > 0."""
    friction: float = 1.0
    """Rate of the Langevin thermostat. *Unit*: 1/tau. *Value*: a finite number > 0."""
    spin: Literal["spared", "counts"] = "spared"
    """Whether the tip's common rotation is heat for its Nose-Hoover thermostat. *Value*: one of
    "spared", "counts"."""
    damping: float = 0.1
    """Damping rate gamma of the driven atoms: the force on each is -gamma m v. *Unit*: 1/tau.
    *Value*: a finite number >= 0."""
    equilibration: float = 50.0
    """Time before the drive is switched on. *Unit*: tau. *Value*: a finite number >= 0."""
    drive_time: float = 200.0
    """Time that the drive lasts. *Unit*: tau. *Value*: a finite number >= 0."""
    rest_time: float = 100.0
    """Time after the drive. *Unit*: tau. *Value*: a finite number >= 0."""
    time_step: float = 0.005
    """Time step of the integrator. *Unit*: tau. *Value*: a number > 0 and <= 0.05."""
    integrator: Literal["leap-frog", "velocity-verlet"] = "leap-frog"
    """Integrator, which says at what times velocities are kept. *Value*: one of "leap-frog",
    "velocity-verlet"."""
    skin: float = 0.3
    """Distance that neighbour lists reach beyond the cut-off. *Unit*: sigma. *Value*: a finite
    number > 0."""
    seed: int = 1
    """Seed of the first velocities and of noise. *Value*: a whole number from 1 to
    9007199254740992."""
    samples: int = 100
    """Steps from one line of the series to the next. *Value*: a whole number from 1 to
    1000000000."""


__all__ = [
    "CurlingScene",
    "CylinderScene",
    "PipeScene",
    "PlateScene",
    "PowderScene",
    "SliderScene",
    "TipScene",
]
