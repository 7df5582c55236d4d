"""Scenes, one class a body: made by tools/scenes.py from the library's tables of keys.

Lengths, times and forces are in the units that each field names; "-" is a pure number or a word.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from tribos._scene import Scene


@dataclass(frozen=True, kw_only=True, slots=True)
class SliderScene(Scene):
    """A disk that slides and spins to rest.

    Parameters
    ----------
    speed
        Initial sliding speed. *Unit*: m/s. *Value*: a finite number >= 0.
    spin
        Initial spin, of either sign. *Unit*: rad/s. *Value*: a finite number.
    gamma
        Friction coefficient of the local law: mu for alpha = 0. *Unit*: (s/m)^alpha. *Value*: a
        finite number > 0.
    alpha
        Exponent of the local law |v|^alpha, 0 for Coulomb. *Value*: a number > -1 and <= 128.
    law
        Local law in place of `gamma` and `alpha`. *Value*: a law with its parameters, such as
        "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05".
    gravity
        Acceleration that presses the body down. *Unit*: m/s^2. *Value*: a finite number > 0.
    radius
        Radius of the contact. *Unit*: m. *Value*: a finite number > 0.
    mass
        Mass of the body. *Unit*: kg. *Value*: a finite number > 0.
    inertia_ratio
        Inertia ratio C = I/(M R^2), 0.5 for a disk. *Value*: a finite number > 0.
    stop_fraction
        Fraction of their start below which both speeds count as rest, for alpha >= 1. *Value*: a
        number > 0 and <= 0.5.
    time_step
        Length of a step; if left out it is chosen from the motion. *Unit*: s. *Value*: a finite
        number > 0.
    duration
        End of the run; if left out it is rest. *Unit*: s. *Value*: a finite number > 0.
    samples
        Number of recorded steps, where `time_step` is left out. *Value*: a whole number from 1 to
        1000000.
    units
        Unit system. *Value*: one of "si", "dimensionless".
    integrator
        Method that follows the motion. *Value*: one of "exact", "verlet".
    """

    BODY: ClassVar[str] = "disk"

    speed: float = 1.0
    spin: float = 5.0
    gamma: float | None = 0.3
    alpha: float | None = 0.0
    law: str | None = None
    gravity: float = 9.81
    radius: float = 0.08
    mass: float = 0.1
    inertia_ratio: float = 0.5
    stop_fraction: float = 0.0001
    time_step: float | None = None
    duration: float | None = None
    samples: int = 200
    units: Literal["si", "dimensionless"] = "si"
    integrator: Literal["exact", "verlet"] = "exact"


@dataclass(frozen=True, kw_only=True, slots=True)
class CylinderScene(Scene):
    """A tall cylinder that slides and spins to rest.

    Parameters
    ----------
    speed
        Initial speed, along x. *Unit*: m/s. *Value*: a finite number >= 0.
    spin
        Initial spin, > 0 counterclockwise. *Unit*: rad/s. *Value*: a finite number.
    gamma
        Friction coefficient of the local law: mu for alpha = 0. *Unit*: (s/m)^alpha. *Value*: a
        finite number > 0.
    alpha
        Exponent of the local law |v|^alpha, 0 for Coulomb. *Value*: a number > -1 and <= 128.
    law
        Local law in place of `gamma` and `alpha`. *Value*: a law with its parameters, such as
        "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05".
    radius
        Outer radius. *Unit*: m. *Value*: a finite number > 0.
    height
        Height of the body; its centre of mass is half way up. *Unit*: m. *Value*: a finite number
        >= 0.
    pressure_gradient
        Directions in which the pressure may lean. *Value*: one of "all-round", "front-back".
    pressure
        Pressure at rest. *Value*: one of "uniform", "ring", "flat-punch", "hertz", "paraboloid".
    inertia_ratio
        Inertia ratio C = I/(M R^2), 0.5 for a solid, uniform cylinder. *Value*: a finite number >
        0.
    on_tipping
        What to do where the body would tip. *Value*: one of "refuse", "clamp".
    gravity
        Acceleration that presses the body down. *Unit*: m/s^2. *Value*: a finite number > 0.
    mass
        Mass of the body. *Unit*: kg. *Value*: a finite number > 0.
    stop_fraction
        Fraction of their start below which both speeds count as rest, for alpha >= 1. *Value*: a
        number > 0 and <= 0.5.
    samples
        Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000.
    """

    BODY: ClassVar[str] = "cylinder"

    speed: float = 1.0
    spin: float = 5.0
    gamma: float | None = 0.2
    alpha: float = 0.0
    law: str | None = None
    radius: float = 0.08
    height: float | None = 0.16
    pressure_gradient: Literal["all-round", "front-back"] = "all-round"
    pressure: Literal["uniform", "ring", "flat-punch", "hertz", "paraboloid"] = "uniform"
    inertia_ratio: float = 0.5
    on_tipping: Literal["refuse", "clamp"] = "refuse"
    gravity: float = 9.81
    mass: float = 1.0
    stop_fraction: float = 0.0001
    samples: int = 200


@dataclass(frozen=True, kw_only=True, slots=True)
class PipeScene(Scene):
    """An upright pipe that slides and spins to rest.

    Parameters
    ----------
    speed
        Initial speed, along x. *Unit*: m/s. *Value*: a finite number >= 0.
    spin
        Initial spin, > 0 counterclockwise. *Unit*: rad/s. *Value*: a finite number.
    gamma
        Friction coefficient of the local law: mu for alpha = 0. *Unit*: (s/m)^alpha. *Value*: a
        finite number > 0.
    alpha
        Exponent of the local law |v|^alpha, 0 for Coulomb. *Value*: a number > -1 and <= 128.
    law
        Local law in place of `gamma` and `alpha`. *Value*: a law with its parameters, such as
        "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05".
    radius
        Outer radius. *Unit*: m. *Value*: a finite number > 0.
    height
        Height of the body; its centre of mass is half way up. *Unit*: m. *Value*: a finite number
        >= 0.
    pressure_gradient
        Directions in which the pressure may lean. *Value*: one of "all-round", "front-back".
    inner_radius
        Inner radius of the pipe; the outer one for a thin ring. *Unit*: m. *Value*: a finite number
        >= 0.
    on_tipping
        What to do where the body would tip. *Value*: one of "refuse", "clamp".
    gravity
        Acceleration that presses the body down. *Unit*: m/s^2. *Value*: a finite number > 0.
    mass
        Mass of the body. *Unit*: kg. *Value*: a finite number > 0.
    stop_fraction
        Fraction of their start below which both speeds count as rest, for alpha >= 1. *Value*: a
        number > 0 and <= 0.5.
    samples
        Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000.
    """

    BODY: ClassVar[str] = "pipe"

    speed: float = 1.74
    spin: float = 10.2
    gamma: float | None = 0.2
    alpha: float = 0.0
    law: str | None = None
    radius: float = 0.05
    height: float | None = 0.15
    pressure_gradient: Literal["all-round", "front-back"] = "all-round"
    inner_radius: float = 0.046
    on_tipping: Literal["refuse", "clamp"] = "refuse"
    gravity: float = 9.81
    mass: float = 0.5
    stop_fraction: float = 0.0001
    samples: int = 200


@dataclass(frozen=True, kw_only=True, slots=True)
class PlateScene(Scene):
    """A flat plate that slides and spins to rest.

    Parameters
    ----------
    patch
        Outline of the plate. *Value*: a patch such as "box:0.3x0.2", "polygon:FILE" or "bar:0.2".
    speed
        Initial speed, along x. *Unit*: m/s. *Value*: a finite number >= 0.
    spin
        Initial spin, > 0 counterclockwise. *Unit*: rad/s. *Value*: a finite number.
    orientation
        Angle from the direction of the launch to the outline's x axis, > 0 counterclockwise.
        *Unit*: rad. *Value*: a finite number.
    mu
        Coulomb's friction coefficient. *Value*: a finite number > 0.
    mu_across
        Friction coefficient across an axis of the outline, `mu` being that along it; the same if it
        is left out. *Value*: a finite number > 0.
    axis
        Angle from the x axis of the outline to that axis. *Unit*: rad. *Value*: a finite number.
    gyration_radius
        Radius of gyration about the upright axis; that of a plate of uniform thickness if it is
        left out. *Unit*: m. *Value*: a finite number > 0.
    gravity
        Acceleration that presses the plate down. *Unit*: m/s^2. *Value*: a finite number > 0.
    mass
        Mass of the plate. *Unit*: kg. *Value*: a finite number > 0.
    samples
        Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000.
    """

    BODY: ClassVar[str] = "plate"

    patch: str = "box:0.3x0.2"
    speed: float = 1.0
    spin: float = 5.0
    orientation: float = 0.0
    mu: float = 0.3
    mu_across: float | None = None
    axis: float = 0.0
    gyration_radius: float | None = None
    gravity: float = 9.81
    mass: float = 0.5
    samples: int = 200


@dataclass(frozen=True, kw_only=True, slots=True)
class CurlingScene(Scene):
    """A curling rock.

    Parameters
    ----------
    speed
        Initial speed, along x. *Unit*: m/s. *Value*: a finite number >= 0.
    spin
        Initial spin, > 0 counterclockwise. *Unit*: rad/s. *Value*: a finite number.
    radius
        Outer radius of the running band. *Unit*: m. *Value*: a finite number > 0.
    band_width
        Width of the band, 0 for a thin ring. *Unit*: m. *Value*: a finite number >= 0.
    centre_height
        Height of the centre of mass. *Unit*: m. *Value*: a finite number >= 0.
    inertia_ratio
        Inertia ratio C = I/(M R^2) with R of the band; the default is that of a solid of 29 cm.
        *Value*: a finite number > 0.
    gravity
        Acceleration that presses the rock down. *Unit*: m/s^2. *Value*: a finite number > 0.
    mass
        Mass of the rock. *Unit*: kg. *Value*: a finite number > 0.
    model
        Why the rock curls; see docs/curling.md. *Value*: one of "left-right", "dry", "front-back",
        "back-heavy", "film", "pivot-slide", "scratch-guide".
    gamma
        Friction coefficient of the ice; if left out that of the model: 0.007095 for dry, else
        0.008. *Unit*: (s/m)^alpha. *Value*: a finite number > 0.
    alpha
        Exponent of the ice; if left out that of the model: 0 for dry, else -0.5. *Value*: a number
        > -1 and <= 0.9.
    back_to_front
        Friction at the back over that in front, of the model back-heavy. *Value*: a finite number >
        0.
    film_front
        Fraction of the band's rotation that the film takes in front, of the model film. *Value*: a
        number from 0 to 1.
    film_back
        Fraction of the band's rotation that the film takes at the back, of the model film. *Value*:
        a number from 0 to 1.
    pivot_weight
        Weight of the pull, of the model pivot-slide. *Value*: a finite number >= 0.
    scratch_strength
        Guiding force over load, of the model scratch-guide. *Value*: a finite number >= 0.
    scratch_onset_angle
        Half the crossing angle from which scratches guide, of the model scratch-guide. *Unit*: rad.
        *Value*: a finite number > 0.
    samples
        Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000.
    """

    BODY: ClassVar[str] = "curling"

    speed: float = 2.0
    spin: float = 1.5
    radius: float = 0.0625
    band_width: float = 0.0
    centre_height: float = 0.057
    inertia_ratio: float = 2.6912
    gravity: float = 9.81
    mass: float = 20.0
    model: Literal["left-right", "dry", "front-back", "back-heavy", "film", "pivot-slide", "scratch-guide"] = (
        "left-right"
    )
    gamma: float | None = None
    alpha: float | None = None
    back_to_front: float | None = None
    film_front: float | None = None
    film_back: float | None = None
    pivot_weight: float | None = None
    scratch_strength: float | None = None
    scratch_onset_angle: float | None = None
    samples: int = 200


@dataclass(frozen=True, kw_only=True, slots=True)
class SpringScene(Scene):
    """A body on a spring that is pulled.

    Parameters
    ----------
    friction_law
        What resists the body. *Value*: one of "dry", "rate-state", "lugre".
    mass
        Mass of the body; 0 for a quasi-static one under rate and state. *Unit*: kg. *Value*: a
        finite number >= 0.
    load
        Load of the body on the floor. *Unit*: N. *Value*: a finite number > 0.
    stiffness
        Stiffness of the spring. *Unit*: N/m. *Value*: a finite number > 0.
    pull_speed
        Speed of the end of the spring. *Unit*: m/s. *Value*: a finite number > 0.
    pull_time
        How long it is pulled; with holds, before the first and after each. *Unit*: s. *Value*: a
        finite number > 0.
    hold_time
        How long the end of the spring stands still first; it never does if left out. *Unit*: s.
        *Value*: a finite number > 0.
    hold_count
        Number of holds. *Value*: a whole number from 1 to 1000.
    hold_time_ratio
        Duration of each hold over that of the one before. *Value*: a finite number > 0.
    mu_static
        Static coefficient, of dry friction, of a contact not older than `ageing_cutoff_time`.
        *Value*: a finite number >= 0.
    mu_dynamic
        Dynamic coefficient, of dry friction. *Value*: a finite number >= 0.
    ageing_rate
        Growth of the static coefficient for each e-fold of the time of rest, of dry friction.
        *Value*: a finite number >= 0.
    ageing_cutoff_time
        Time of rest from which it grows, of dry friction. *Unit*: s. *Value*: a finite number > 0.
    law
        Law of the speed in place of dry friction. *Value*: a law with its parameters, such as
        "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05".
    mu_reference
        Coefficient of steady sliding with `reference_speed`, of rate and state. *Value*: a finite
        number >= 0.
    a
        Direct effect a of the speed, of rate and state. *Value*: a finite number > 0.
    b
        Effect b of the age, of rate and state. *Value*: a finite number >= 0.
    reference_speed
        Reference speed, of rate and state. *Unit*: m/s. *Value*: a finite number > 0.
    slip_distance
        Memory length D_c, of rate and state. *Unit*: m. *Value*: a finite number > 0.
    radiation_damping
        Viscous term of the inertial branch, of rate and state. *Unit*: s/m. *Value*: a finite
        number >= 0.
    evolution
        How the age evolves, of rate and state: Dieterich's ageing law or Ruina's slip law. *Value*:
        one of "ageing", "slip".
    start_speed
        Speed of the steady sliding that rate and state starts from; 0.9 `pull_speed` if left out.
        *Unit*: m/s. *Value*: a finite number > 0.
    coulomb_force
        Coulomb force of the bristles. *Unit*: N. *Value*: a finite number > 0.
    static_force
        Static force of the bristles. *Unit*: N. *Value*: a finite number > 0.
    stribeck_speed
        Stribeck speed of the bristles. *Unit*: m/s. *Value*: a finite number > 0.
    bristle_stiffness
        Stiffness of the bristles. *Unit*: N/m. *Value*: a finite number > 0.
    bristle_damping
        Damping of the bristles. *Unit*: N s/m. *Value*: a finite number >= 0.
    viscous_damping
        Viscous damping beside the bristles. *Unit*: N s/m. *Value*: a finite number >= 0.
    tolerance
        Error of a step, in units of the motion's scales; dry friction needs none. *Value*: a number
        > 0 and <= 0.01.
    samples
        Number of intervals of time in the series, for each pull and each hold. *Value*: a whole
        number from 1 to 1000000.
    """

    BODY: ClassVar[str] = "spring"

    friction_law: Literal["dry", "rate-state", "lugre"] = "dry"
    mass: float = 1.0
    load: float = 9.81
    stiffness: float = 100.0
    pull_speed: float = 0.05
    pull_time: float = 20.0
    hold_time: float | None = None
    hold_count: int = 1
    hold_time_ratio: float = 10.0
    mu_static: float = 0.5
    mu_dynamic: float = 0.3
    ageing_rate: float = 0.0
    ageing_cutoff_time: float = 1.0
    law: str | None = None
    mu_reference: float | None = None
    a: float | None = None
    b: float | None = None
    reference_speed: float | None = None
    slip_distance: float | None = None
    radiation_damping: float | None = None
    evolution: Literal["ageing", "slip"] | None = None
    start_speed: float | None = None
    coulomb_force: float | None = None
    static_force: float | None = None
    stribeck_speed: float | None = None
    bristle_stiffness: float | None = None
    bristle_damping: float | None = None
    viscous_damping: float | None = None
    tolerance: float = 1e-09
    samples: int = 400


@dataclass(frozen=True, kw_only=True, slots=True)
class InclineScene(Scene):
    """A block on an incline.

    Parameters
    ----------
    patch
        Contact of the block with the incline: box:AxB, polygon:FILE, bar:L, or a round patch such
        as disk. *Value*: a patch such as "box:0.3x0.2", "polygon:FILE" or "disk".
    radius
        Radius of a round patch. *Unit*: m. *Value*: a finite number > 0.
    mass
        Mass of the block. *Unit*: kg. *Value*: a finite number > 0.
    gravity
        Acceleration by gravity. *Unit*: m/s^2. *Value*: a finite number > 0.
    mu_static
        Static coefficient of a contact not older than `ageing_cutoff_time`. *Value*: a finite
        number >= 0.
    mu_dynamic
        Dynamic coefficient. *Value*: a finite number >= 0.
    ageing_rate
        Growth of the static coefficient for each e-fold of the time of rest. *Value*: a finite
        number >= 0.
    ageing_cutoff_time
        Time of rest from which it grows. *Unit*: s. *Value*: a finite number > 0.
    start_angle
        Angle of the incline at the start. *Unit*: rad. *Value*: a finite number >= 0.
    tilt_rate
        Rate at which it is raised, 0 for a fixed one. *Unit*: rad/s. *Value*: a finite number >= 0.
    end_angle
        Angle at which the raising ends. *Unit*: rad. *Value*: a number > 0 and <=
        1.5707963267948966.
    duration
        End of the run. *Unit*: s. *Value*: a finite number > 0.
    samples
        Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000.
    """

    BODY: ClassVar[str] = "incline"

    patch: str = "disk"
    radius: float = 0.05
    mass: float = 1.0
    gravity: float = 9.81
    mu_static: float = 0.5
    mu_dynamic: float = 0.3
    ageing_rate: float = 0.0
    ageing_cutoff_time: float = 1.0
    start_angle: float = 0.0
    tilt_rate: float = 0.05
    end_angle: float = 1.0
    duration: float = 12.0
    samples: int = 400


@dataclass(frozen=True, kw_only=True, slots=True)
class TurntableScene(Scene):
    """A body on a turntable.

    Parameters
    ----------
    patch
        Contact of the body with the table, its x axis outward: box:AxB, polygon:FILE, bar:L, or a
        round patch such as disk. *Value*: a patch such as "box:0.3x0.2", "polygon:FILE" or "disk".
    radius
        Radius of a round patch. *Unit*: m. *Value*: a finite number > 0.
    mass
        Mass of the body. *Unit*: kg. *Value*: a finite number > 0.
    gyration_radius
        Radius of gyration of the body about its upright axis. *Unit*: m. *Value*: a finite number >
        0.
    gravity
        Acceleration by gravity. *Unit*: m/s^2. *Value*: a finite number > 0.
    mu_static
        Static coefficient. *Value*: a finite number > 0.
    mu_dynamic
        Dynamic coefficient. *Value*: a finite number >= 0.
    distance
        Distance of the body from the axis of the table. *Unit*: m. *Value*: a finite number > 0.
    table_angular_acceleration
        Angular acceleration of the table. *Unit*: rad/s^2. *Value*: a finite number > 0.
    table_radius
        Radius of the table, where the run ends. *Unit*: m. *Value*: a finite number > 0.
    duration
        End of the run, if the body stays on the table. *Unit*: s. *Value*: a finite number > 0.
    time_step
        Longest step of the sliding body; its error makes it shorter. *Unit*: s. *Value*: a finite
        number > 0.
    samples
        Number of intervals of time in the series. *Value*: a whole number from 1 to 1000000.
    """

    BODY: ClassVar[str] = "turntable"

    patch: str = "disk"
    radius: float = 0.03
    mass: float = 0.2
    gyration_radius: float = 0.02
    gravity: float = 9.81
    mu_static: float = 0.4
    mu_dynamic: float = 0.3
    distance: float = 0.2
    table_angular_acceleration: float = 1.0
    table_radius: float = 0.5
    duration: float = 10.0
    time_step: float = 0.0005
    samples: int = 400


@dataclass(frozen=True, kw_only=True, slots=True)
class ClampScene(Scene):
    """A clamped body under a load that swings.

    Parameters
    ----------
    patch
        Contact of each pad: box:AxB, polygon:FILE, bar:L, or a round patch such as disk. *Value*: a
        patch such as "box:0.3x0.2", "polygon:FILE" or "disk".
    radius
        Radius of a round patch. *Unit*: m. *Value*: a finite number > 0.
    load
        Load of both pads. *Unit*: N. *Value*: a finite number > 0.
    mu_first
        Friction coefficient of the first pad. *Value*: a finite number > 0.
    mu_second
        Friction coefficient of the second pad. *Value*: a finite number > 0.
    stiffness_first
        Stiffness of the first pad along the contact. *Unit*: N/m. *Value*: a finite number > 0.
    stiffness_second
        Stiffness of the second pad along the contact. *Unit*: N/m. *Value*: a finite number > 0.
    torsion_lever_squared
        Torsional stiffness of a pad over its stiffness; half the squared radius of a disk if left
        out. *Unit*: m^2. *Value*: a finite number > 0.
    force_mean
        Mean of the force. *Unit*: N. *Value*: a finite number.
    force_amplitude
        Amplitude of the force. *Unit*: N. *Value*: a finite number.
    torque_mean
        Mean of the torque. *Unit*: N m. *Value*: a finite number.
    torque_amplitude
        Amplitude of the torque, in phase with the force. *Unit*: N m. *Value*: a finite number.
    amplitude_growth
        Growth of both amplitudes from cycle to cycle, as a share of the first. *Value*: a finite
        number >= 0.
    period
        Duration of a cycle. *Unit*: s. *Value*: a finite number > 0.
    cycles
        Number of cycles. *Value*: a whole number from 1 to 10000.
    samples
        Number of intervals of time in the series, for each cycle. *Value*: a whole number from 1 to
        1000000.
    """

    BODY: ClassVar[str] = "clamp"

    patch: str = "disk"
    radius: float = 0.01
    load: float = 20.0
    mu_first: float = 0.3
    mu_second: float = 0.5
    stiffness_first: float = 20000.0
    stiffness_second: float = 10000.0
    torsion_lever_squared: float | None = None
    force_mean: float = 0.0
    force_amplitude: float = 11.0
    torque_mean: float = 0.0
    torque_amplitude: float = 0.0
    amplitude_growth: float = 0.0
    period: float = 1.0
    cycles: int = 5
    samples: int = 200


@dataclass(frozen=True, kw_only=True, slots=True)
class PowderScene(Scene):
    """A powder under a piston.

    Parameters
    ----------
    width
        Side of the square base, periodic in x and y. *Unit*: R. *Value*: a finite number > 0.
    height
        Height at which the deposit is cut and the piston starts, unless `count` or `initial_state`
        is given. *Unit*: R. *Value*: a finite number > 0.
    count
        Number of spheres, in place of `height`. *Value*: a whole number from 1 to 1000000.
    initial_state
        Spheres to start from in place of a deposit: a file (XYZ, a table, LAMMPS, VTK, MercuryDPM
        and others; see `tribos packing`), or the folder of a run, whose last state goes on.
        *Value*: the path of a file or a folder.
    columns
        Columns of a table that `initial_state` names, or arrays of a file of VTK, where the file
        does not say them: names in their order, `-` for one that is not read, `NAME=COLUMN` or
        `NAME=all:VALUE`. *Value*: columns such as "x,y,z,radius", "-,x,y,z,radius=all:0.5" or
        "radius=R [mm]".
    capture_radius
        Distance of centres at which a falling sphere is captured, at least the largest diameter.
        *Unit*: R. *Value*: a finite number > 0.
    radius_spread
        Spread of the radii, which are uniform from 1 - spread to 1 + spread. *Unit*: R. *Value*: a
        number >= 0 and < 1.
    size_distribution
        Distribution of the radii about their mean, in place of `radius_spread`. *Value*: a
        distribution such as "uniform:0.2", "normal:0.1", "lognormal:0.3" or "table:FILE.csv".
    seed
        Seed of the deposit's random numbers. *Value*: a whole number from 1 to 9007199254740992.
    mu
        Sliding coefficient mu: largest sliding force over P = F_n + F_coh. *Value*: a finite number
        >= 0.
    mu_rolling
        Rolling coefficient mu_t: largest rolling torque over P r_eff; a length in Chrono and
        MuJoCo. *Value*: a finite number >= 0.
    mu_torsion
        Torsion coefficient mu_n: largest torsion torque over P r_eff; a length in Chrono and
        MuJoCo. *Value*: a finite number >= 0.
    coupling
        How the thresholds of sliding and torsion depend on each other. *Value*: one of
        "independent", "ellipsoid", "exact".
    second_fraction
        Share of the spheres that are of a second material, chosen at random; those of
        `initial_state` that have materials keep them. *Value*: a number from 0 to 1.
    second_density
        Density of the second material; that of the first if it is left out. *Unit*: rho. *Value*: a
        finite number > 0.
    mu_second
        Sliding coefficient of the second material; that of the first if it is left out. *Value*: a
        finite number >= 0.
    mu_mixed
        Sliding coefficient between the two materials; the geometric mean of theirs if it is left
        out. *Value*: a finite number >= 0.
    pressure
        Pressure on the piston. *Unit*: F_coh/R^2. *Value*: a finite number > 0.
    gravity
        Acceleration of the spheres, downwards; the piston has its pressure alone. *Unit*:
        F_coh/(rho R^3). *Value*: a finite number >= 0.
    cohesion_range
        Gap d_c up to which cohesion acts. *Unit*: R. *Value*: a finite number >= 0.
    attraction
        Cohesion at a gap: a constant pull, or a resistance to opening. *Value*: one of "pull",
        "resistance".
    restitution
        Coefficient of restitution: speed after an impact over speed before, at walls too. *Value*:
        a number from 0 to 1.
    wall_contact
        Law at substrate and piston: that of spheres, cohesion only, or neither. *Value*: one of
        "full", "smooth", "none".
    piston_mass
        Mass of the piston. *Unit*: rho R^3. *Value*: a finite number > 0.
    method
        Rigid spheres with constraint forces, or soft ones with springs and dashpots. *Value*: one
        of "contact-dynamics", "soft".
    stiffness
        Stiffness of soft contacts: the overlap under the force F_coh is R over this number. *Unit*:
        F_coh/R. *Value*: a finite number > 0.
    damping_ratio
        Damping ratio of soft contacts in all modes, unless `restitution` is above 0. *Value*: a
        finite number >= 0.
    normal_law
        Elastic force of soft contacts: linear in the overlap, or Hertz's with the modulus
        `stiffness`/R. *Value*: one of "linear", "hertz".
    steps_per_collision
        Least number of steps of a collision of soft contacts. *Value*: a number > 2 and <= 10000.
    solver
        Method for the contacts of a step. *Value*: one of "accelerated", "gauss-seidel".
    sweep_order
        Order of the contacts in a sweep of gauss-seidel. *Value*: one of "alternating", "fixed",
        "random".
    stop_rule
        When gauss-seidel stops: by the change of all or of any contacts, or after `max_iterations`.
        *Value*: one of "global", "local", "fixed".
    tolerance
        Change of a sweep, relative to P, at which sweeps stop. *Value*: a number > 0 and <= 1.
    max_iterations
        Most sweeps of a step, N_I; all of them with stop_rule = "fixed". *Value*: a whole number
        from 1 to 1000000.
    warm_start
        Share of the last step's forces that a step starts from; "on" is 1, "off" is 0. *Value*: a
        number from 0 to 1, or "on" or "off".
    max_displacement
        Largest distance that a sphere may move in a step; soft contacts divide it into stable ones.
        *Unit*: R. *Value*: a number > 0 and <= 0.5.
    max_time_step
        Longest time step. *Unit*: sqrt(rho R^4/F_coh). *Value*: a finite number > 0.
    still_speed
        Sleep threshold: slower groups that nothing touches are left alone; with 0 none is. *Unit*:
        sqrt(F_coh/rho)/R. *Value*: a finite number >= 0.
    blocked_criterion
        Criterion of the end: forces balance and the piston stands, or the piston stands. *Value*:
        one of "balance", "piston".
    max_steps
        Steps after which a run ends that is not blocked before. *Value*: a whole number from 1 to
        1000000000.
    duration
        Time after which a run ends that is not blocked before; if left out there is no such bound.
        *Unit*: sqrt(rho R^4/F_coh). *Value*: a finite number > 0.
    sample_every
        Steps from one line of the series to the next. *Value*: a whole number from 1 to 1000000000.
    """

    BODY: ClassVar[str] = "powder"

    width: float = 20.0
    height: float | None = 61.5
    count: int | None = None
    initial_state: str | None = None
    columns: str | None = None
    capture_radius: float = 3.0
    radius_spread: float = 0.0
    size_distribution: str | None = None
    seed: int = 1
    mu: float = 0.3
    mu_rolling: float = 0.0
    mu_torsion: float = 0.0
    coupling: Literal["independent", "ellipsoid", "exact"] = "independent"
    second_fraction: float = 0.0
    second_density: float | None = None
    mu_second: float | None = None
    mu_mixed: float | None = None
    pressure: float = 0.0025
    gravity: float = 0.0
    cohesion_range: float = 0.01
    attraction: Literal["pull", "resistance"] = "pull"
    restitution: float = 0.0
    wall_contact: Literal["full", "smooth", "none"] = "full"
    piston_mass: float = 1000.0
    method: Literal["contact-dynamics", "soft"] = "contact-dynamics"
    stiffness: float | None = None
    damping_ratio: float | None = None
    normal_law: Literal["linear", "hertz"] | None = None
    steps_per_collision: float | None = None
    solver: Literal["accelerated", "gauss-seidel"] = "accelerated"
    sweep_order: Literal["alternating", "fixed", "random"] = "alternating"
    stop_rule: Literal["global", "local", "fixed"] = "global"
    tolerance: float = 0.0001
    max_iterations: int = 1000
    warm_start: float | str = "on"
    max_displacement: float = 0.05
    max_time_step: float = 0.2
    still_speed: float = 1e-07
    blocked_criterion: Literal["balance", "piston"] = "balance"
    max_steps: int = 200000
    duration: float | None = None
    sample_every: int = 20


@dataclass(frozen=True, kw_only=True, slots=True)
class GrainsScene(Scene):
    """Grains in a box.

    Parameters
    ----------
    width
        Length of the box along x. *Unit*: m. *Value*: a finite number > 0.
    depth
        Length of the box along y; as long as `width` if it is left out. A two-dimensional box has
        none. *Unit*: m. *Value*: a finite number > 0.
    height
        Height of the box: where the plate above starts, or the period; a floor alone does not use
        it. If it is left out, a plate starts at the highest grain. *Unit*: m. *Value*: a finite
        number > 0.
    boundary_x
        What bounds the box along x. *Value*: one of "periodic", "walls".
    boundary_y
        What bounds the box along y. *Value*: one of "periodic", "walls".
    boundary_z
        What bounds the box along z: a floor, floor and plate, or nothing. *Value*: one of "floor",
        "walls", "periodic".
    dimension
        3, or 2 for spheres that stay in the plane y = 0 and spin about y. *Value*: a whole number
        from 2 to 3.
    container
        What holds the grains: the box, a hopper in it, or a drum of diameter `width` about y.
        *Value*: one of "box", "hopper", "drum".
    orifice_width
        Width of the slot of the hopper. *Unit*: m. *Value*: a finite number > 0.
    orifice_height
        Height of the slot above the floor. *Unit*: m. *Value*: a finite number > 0.
    hopper_angle
        Angle of the plates of the hopper with the horizontal. *Unit*: degree. *Value*: a number >=
        0 and < 90.
    open_time
        Time at which the slot is opened. *Unit*: s. *Value*: a finite number >= 0.
    drum_angular_velocity
        Rate of rotation of the drum. *Unit*: rad/s. *Value*: a finite number, or a ramp such as
        "0:0, 0.5:1e3, 1:0".
    count
        Number of grains, unless `initial_state` has them. *Value*: a whole number from 1 to
        1000000.
    initial_state
        Grains to start from in place of random ones: a file (XYZ, a table, LAMMPS, VTK, MercuryDPM
        and others; see `tribos packing`), or the folder of a run, whose last state goes on.
        *Value*: the path of a file or a folder.
    columns
        Columns of a table that `initial_state` names, or arrays of a file of VTK, where the file
        does not say them: names in their order, `-` for one that is not read, `NAME=COLUMN` or
        `NAME=all:VALUE`. *Value*: columns such as "x,y,z,radius", "-,x,y,z,radius=all:0.5" or
        "radius=R [mm]".
    radius
        Mean radius of the grains. *Unit*: m. *Value*: a finite number > 0.
    radius_spread
        Spread of the radii, in mean radii: they are uniform from 1 - spread to 1 + spread. *Value*:
        a number >= 0 and < 1.
    size_distribution
        Distribution of the radii about their mean, in place of `radius_spread`. *Value*: a
        distribution such as "uniform:0.2", "normal:0.1", "lognormal:0.3" or "table:FILE.csv".
    density
        Density of the grains; those of `initial_state` that have one keep it. *Unit*: kg/m^3.
        *Value*: a finite number > 0.
    seed
        Seed of the random start. *Value*: a whole number from 1 to 9007199254740992.
    initial_spacing
        Distance of neighbours at the start, in diameters of the largest grain; the rest is random.
        *Value*: a number > 1 and <= 100.
    initial_height
        Height above the floor from which random grains are placed upwards. *Unit*: m. *Value*: a
        finite number >= 0.
    materials
        Materials by name, up to 6, as `glass: mu=0.5, density=2500; steel: mu=0.2, density=7800,
        share=0.3, radius=1.5`: the n-th is type n of `initial_state`. `share` of the grains, drawn
        at random, are of a material, the rest of the first; `radius` is in mean radii. `mu`,
        `mu_rolling`, `mu_torsion`, `restitution`, `cohesion`, `density`, `stiffness`,
        `young_modulus` and `poisson_ratio` are those of the scene where they are left out. *Value*:
        materials such as "glass: mu=0.5, density=2500; steel: mu=0.2, density=7800, share=0.3".
    pairs
        What holds between two `materials`, or at walls, as `glass-steel: mu=0.3, restitution=0.5;
        steel-walls: mu=0.1`: coefficients, `restitution` and `cohesion` are the geometric means of
        both and springs in series where they are left out, and at walls those of two grains of the
        material. *Value*: pairs such as "glass-steel: mu=0.3, restitution=0.5; steel-walls:
        mu=0.1".
    second_fraction
        Share of the grains that are of a second material, chosen at random; those of
        `initial_state` that have materials keep them. *Value*: a number from 0 to 1.
    second_radius
        Radius of these, in mean radii of the others. *Value*: a number > 0 and <= 100.
    second_density
        Density of the second material; that of the first if it is left out. *Unit*: kg/m^3.
        *Value*: a finite number > 0.
    mu_second
        Sliding coefficient of the second material; that of the first if it is left out. *Value*: a
        finite number >= 0.
    mu_mixed
        Sliding coefficient between the two materials; the geometric mean of theirs if it is left
        out. *Value*: a finite number >= 0.
    rough_floor
        Radius of grains glued to the floor in a square lattice, side by side, with their centres in
        its plane. *Unit*: m. *Value*: a finite number > 0.
    rough_lid
        Radius of grains glued to the plate above in the same way, which move with it. *Unit*: m.
        *Value*: a finite number > 0.
    fixed_kinds
        Types of `initial_state` whose grains stay where they are in the box, whatever pushes them:
        rough bottoms and obstacles. Those that `rough_floor` glues are of type 7. *Value*: a whole
        number from 1 to 9, or types such as "2, 3".
    driven_kinds
        Types of `initial_state` whose grains move as one body with the driven velocity and
        rotation. The intruder is of type 8. *Value*: a whole number from 1 to 9, or types such as
        "2, 3".
    intruder_radius
        Radius of an intruder, a sphere that moves with the driven velocity through the grains.
        *Unit*: m. *Value*: a finite number > 0.
    intruder_position
        Place of its centre at the start. *Unit*: m. *Value*: three numbers such as "0, 0, 0.1".
    driven_velocity_x
        Velocity of driven grains along x. *Unit*: m/s. *Value*: a finite number, or a ramp such as
        "0:0, 0.5:1e3, 1:0".
    driven_velocity_y
        Velocity of driven grains along y. *Unit*: m/s. *Value*: a finite number, or a ramp such as
        "0:0, 0.5:1e3, 1:0".
    driven_velocity_z
        Velocity of driven grains along z. *Unit*: m/s. *Value*: a finite number, or a ramp such as
        "0:0, 0.5:1e3, 1:0".
    driven_angular_velocity
        Rate of rotation of the driven grains as one body, right-handed about an axis through the
        mean of their centres: an impeller. *Unit*: rad/s. *Value*: a finite number, or a ramp such
        as "0:0, 0.5:1e3, 1:0".
    driven_axis
        Direction of this axis. *Value*: three numbers such as "0, 0, 0.1".
    mesh
        Walls of triangles beside those of the box: an STL file, as text or binary, with the
        coordinates of the box. *Value*: the path of a file or a folder.
    mesh_scale
        Factor from the lengths of `mesh` to those of the box, such as 0.001 for millimetres.
        *Value*: a finite number > 0.
    mesh_velocity
        Velocity of the mesh. *Unit*: m/s. *Value*: three numbers such as "0, 0, 0.1".
    mesh_angular_velocity
        Rate of rotation of the mesh, right-handed about its axis. *Unit*: rad/s. *Value*: a finite
        number.
    mesh_axis
        Direction of the axis of this rotation. *Value*: three numbers such as "0, 0, 0.1".
    mesh_centre
        A point of the axis at the start, which moves with the mesh; torques on it are about this
        point. *Unit*: m. *Value*: three numbers such as "0, 0, 0.1".
    cohesion
        Cohesion F_coh: largest pull of a contact. *Unit*: N. *Value*: a finite number >= 0.
    surface_energy
        Surface energy gamma of the grains, from which cohesion follows in place of `cohesion`: 4 pi
        gamma r_eff, or 3 pi gamma r_eff with `adhesion` = "jkr"; r_eff is half the mean radius, for
        all pairs and at walls. *Unit*: J/m^2. *Value*: a finite number > 0.
    adhesion
        Whose pull-off force follows from `surface_energy`: of stiff and small grains (Derjaguin,
        Muller, Toporov), or of soft and large ones (Johnson, Kendall, Roberts). *Value*: one of
        "dmt", "jkr".
    cohesion_range
        Gap up to which cohesion acts. *Unit*: m. *Value*: a finite number >= 0.
    attraction
        Cohesion at a gap: a constant pull, or a resistance to opening. *Value*: one of "pull",
        "resistance".
    restitution
        Coefficient of restitution: speed after an impact over speed before, at walls too. *Value*:
        a number from 0 to 1.
    mu
        Sliding coefficient mu: largest sliding force over P = F_n + F_coh. *Value*: a finite number
        >= 0.
    mu_rolling
        Rolling coefficient mu_t: largest rolling torque over P r_eff; a length in Chrono and
        MuJoCo. *Value*: a finite number >= 0.
    mu_torsion
        Torsion coefficient mu_n: largest torsion torque over P r_eff; a length in Chrono and
        MuJoCo. *Value*: a finite number >= 0.
    coupling
        How the thresholds of sliding and torsion depend on each other. *Value*: one of
        "independent", "ellipsoid", "exact".
    wall_contact
        Law at walls: that of grains, cohesion only, or neither. *Value*: one of "full", "smooth",
        "none".
    gravity
        Gravity, downwards; 0 where nothing bears the grains, as in a sheared box. *Unit*: m/s^2.
        *Value*: a finite number >= 0, or a ramp such as "0:0, 0.5:1e3, 1:0".
    gravity_angle
        Angle by which gravity leans from -z towards x. *Unit*: degree. *Value*: a finite number, or
        a ramp such as "0:0, 0.5:1e3, 1:0".
    wall_stress_x
        Stress on the wall at the far end of x, which moves as a piston; where x is periodic, on the
        box. *Unit*: Pa. *Value*: a finite number >= 0, or a ramp such as "0:0, 0.5:1e3, 1:0".
    wall_stress_y
        Stress on the wall at the far end of y, which moves as a piston; where y is periodic, on the
        box. *Unit*: Pa. *Value*: a finite number >= 0, or a ramp such as "0:0, 0.5:1e3, 1:0".
    wall_stress_z
        Stress on the plate above, which moves as a piston without weight; where z is periodic, on
        the box. *Unit*: Pa. *Value*: a finite number >= 0, or a ramp such as "0:0, 0.5:1e3, 1:0".
    piston_mass
        Mass of every piston, and of each axis of a box under a stress; that of all grains together
        if it is left out. *Unit*: kg. *Value*: a finite number > 0.
    wall_velocity_x
        Speed of the wall at the far end of x along x, or at which the period along x grows;
        negative compresses. *Unit*: m/s. *Value*: a finite number, or a ramp such as "0:0, 0.5:1e3,
        1:0".
    wall_velocity_y
        Speed of the wall at the far end of y along y, or at which the period along y grows;
        negative compresses. *Unit*: m/s. *Value*: a finite number, or a ramp such as "0:0, 0.5:1e3,
        1:0".
    wall_velocity_z
        Speed of the plate above along z, or at which the period along z grows; negative compresses.
        *Unit*: m/s. *Value*: a finite number, or a ramp such as "0:0, 0.5:1e3, 1:0".
    lid_speed_x
        Speed of the plate above along x, which shears the grains. *Unit*: m/s. *Value*: a finite
        number, or a ramp such as "0:0, 0.5:1e3, 1:0".
    shear_rate
        Rate at which a box without walls along x and z is sheared: speed along x over height along
        z. *Unit*: 1/s. *Value*: a finite number.
    inertial_number
        Inertial number I of a slow deformation, in place of a rate: the box is sheared at I
        sqrt(P/density)/(2 radius) under P = `wall_stress_z`; without that key z is shortened at
        this rate, of its length at the start, under P = `wall_stress_x`. *Value*: a number > 0 and
        <= 10.
    side_wall_speed_z
        Speed of the walls along x and y upwards, which mobilizes their friction; negative
        downwards. *Unit*: m/s. *Value*: a finite number, or a ramp such as "0:0, 0.5:1e3, 1:0".
    shake_amplitude
        Amplitude with which the box is shaken: all walls that are neither piston nor moved
        otherwise. *Unit*: m. *Value*: a finite number >= 0.
    shake_frequency
        Frequency of the shaking. *Unit*: 1/s. *Value*: a finite number >= 0.
    shake_axis
        Direction of the shaking. *Value*: one of "x", "y", "z".
    ramp_period
        Time after which all ramps start again; without it they are followed once. *Unit*: s.
        *Value*: a finite number > 0.
    method
        Rigid grains with constraint forces, or soft ones with springs and dashpots. *Value*: one of
        "contact-dynamics", "soft".
    stiffness
        Stiffness of soft contacts: force over overlap. *Unit*: N/m. *Value*: a finite number > 0.
    young_modulus
        Young's modulus of the grains, in place of `stiffness`: contacts are Hertz's with E* =
        young_modulus/(2 (1 - poisson_ratio^2)). *Unit*: Pa. *Value*: a finite number > 0.
    poisson_ratio
        Poisson's ratio beside `young_modulus`. *Value*: a number > -1 and <= 0.5.
    damping_ratio
        Damping ratio of soft contacts in all modes, unless `restitution` is above 0. *Value*: a
        finite number >= 0.
    normal_law
        Elastic force of soft contacts: linear in the overlap, or Hertz's with the modulus
        `stiffness`/`radius`. *Value*: one of "linear", "hertz".
    steps_per_collision
        Least number of steps of a collision of soft contacts. *Value*: a number > 2 and <= 10000.
    tolerance
        Change of a sweep, relative to P, at which sweeps stop. *Value*: a number > 0 and <= 1.
    max_iterations
        Most sweeps of a step. *Value*: a whole number from 1 to 1000000.
    max_displacement
        Largest distance that a grain may move in a step, in mean radii; soft contacts divide it
        into stable ones. *Value*: a number > 0 and <= 0.5.
    max_time_step
        Longest time step; if it is left out, the time in which gravity moves a grain by
        `max_displacement` from rest, and at most a hundredth of `duration`. *Unit*: s. *Value*: a
        finite number > 0.
    duration
        Time after which the run ends. *Unit*: s. *Value*: a finite number > 0.
    rest_speed
        Speed below which the grains are at rest: the run ends once their root mean square speed was
        lower for 100 steps. *Unit*: m/s. *Value*: a finite number > 0.
    max_steps
        Steps after which a run ends in any case. *Value*: a whole number from 1 to 1000000000.
    sample_every
        Steps from one line of the series to the next. *Value*: a whole number from 1 to 1000000000.
    average_from
        Time from which on means over time are taken; for each column the time after which it has
        settled if it is left out. *Unit*: s. *Value*: a finite number >= 0.
    """

    BODY: ClassVar[str] = "grains"

    width: float = 0.1
    depth: float | None = None
    height: float | None = None
    boundary_x: Literal["periodic", "walls"] = "periodic"
    boundary_y: Literal["periodic", "walls"] = "periodic"
    boundary_z: Literal["floor", "walls", "periodic"] = "floor"
    dimension: int = 3
    container: Literal["box", "hopper", "drum"] = "box"
    orifice_width: float = 0.05
    orifice_height: float = 0.1
    hopper_angle: float = 45.0
    open_time: float = 0.0
    drum_angular_velocity: float | str = 1.0
    count: int | None = 100
    initial_state: str | None = None
    columns: str | None = None
    radius: float = 0.005
    radius_spread: float = 0.0
    size_distribution: str | None = None
    density: float = 2500.0
    seed: int = 1
    initial_spacing: float = 1.2
    initial_height: float = 0.0
    materials: str | None = None
    pairs: str | None = None
    second_fraction: float = 0.0
    second_radius: float = 1.0
    second_density: float | None = None
    mu_second: float | None = None
    mu_mixed: float | None = None
    rough_floor: float | None = None
    rough_lid: float | None = None
    fixed_kinds: float | str = "7"
    driven_kinds: float | str = "8"
    intruder_radius: float | None = None
    intruder_position: str | None = None
    driven_velocity_x: float | str = 0.0
    driven_velocity_y: float | str = 0.0
    driven_velocity_z: float | str = 0.0
    driven_angular_velocity: float | str = 0.0
    driven_axis: str = "0, 0, 1"
    mesh: str | None = None
    mesh_scale: float = 1.0
    mesh_velocity: str = "0, 0, 0"
    mesh_angular_velocity: float = 0.0
    mesh_axis: str = "0, 0, 1"
    mesh_centre: str = "0, 0, 0"
    cohesion: float = 0.0
    surface_energy: float | None = None
    adhesion: Literal["dmt", "jkr"] | None = None
    cohesion_range: float = 0.0
    attraction: Literal["pull", "resistance"] = "pull"
    restitution: float = 0.0
    mu: float = 0.5
    mu_rolling: float = 0.0
    mu_torsion: float = 0.0
    coupling: Literal["independent", "ellipsoid", "exact"] = "independent"
    wall_contact: Literal["full", "smooth", "none"] = "full"
    gravity: float | str = 9.81
    gravity_angle: float | str = 0.0
    wall_stress_x: float | str | None = None
    wall_stress_y: float | str | None = None
    wall_stress_z: float | str | None = None
    piston_mass: float | None = None
    wall_velocity_x: float | str | None = None
    wall_velocity_y: float | str | None = None
    wall_velocity_z: float | str | None = None
    lid_speed_x: float | str = 0.0
    shear_rate: float | None = None
    inertial_number: float | None = None
    side_wall_speed_z: float | str = 0.0
    shake_amplitude: float = 0.0
    shake_frequency: float = 25.0
    shake_axis: Literal["x", "y", "z"] = "z"
    ramp_period: float | None = None
    method: Literal["contact-dynamics", "soft"] = "contact-dynamics"
    stiffness: float | None = None
    young_modulus: float | None = None
    poisson_ratio: float | None = None
    damping_ratio: float | None = None
    normal_law: Literal["linear", "hertz"] | None = None
    steps_per_collision: float | None = None
    tolerance: float = 0.0001
    max_iterations: int = 1000
    max_displacement: float = 0.05
    max_time_step: float | None = None
    duration: float = 1.0
    rest_speed: float | None = None
    max_steps: int = 10000000
    sample_every: int = 50
    average_from: float | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class GasScene(Scene):
    """A gas of spheres that cools.

    Parameters
    ----------
    count
        Number of spheres. *Value*: a whole number from 1 to 1000000.
    packing_fraction
        Packing fraction: share of the cube that the spheres fill. *Value*: a number > 0 and <= 0.6.
    restitution
        Coefficient of restitution: normal speed after a collision over that before. *Value*: a
        number from 0 to 1.
    tangential_restitution
        Tangential restitution, from -1 (smooth) to 1; if left out spheres are smooth, or stop under
        friction. *Value*: a number > -1 and <= 1.
    mu
        Sliding coefficient mu that limits the tangential impulse; if left out there is no such
        limit. *Value*: a finite number >= 0.
    rotational_temperature
        Temperature of the spins at the start. *Unit*: T0. *Value*: a finite number >= 0.
    contact_time
        Contact time t_c: a collision sooner after a sphere's last one loses no energy; 0 for none.
        *Unit*: R sqrt(m/T0). *Value*: a finite number >= 0.
    seed
        Seed of the places and velocities at the start. *Value*: a whole number from 1 to
        9007199254740992.
    mixing_collisions
        Collisions a sphere without loss, before the run, that mix the start. *Value*: a finite
        number >= 0.
    collisions
        Collisions a sphere after which a run ends; one of a pair counts for both. *Value*: a finite
        number > 0.
    duration
        Time after which a run ends if it has not before; if left out there is no such bound.
        *Unit*: R sqrt(m/T0). *Value*: a finite number > 0.
    sample_every
        Collisions a sphere from one line of the series to the next. *Value*: a finite number > 0.
    method
        How the motion is computed. *Value*: one of "events", "contact-dynamics", "soft".
    max_displacement
        Largest distance that a sphere may move in a time step. *Unit*: R. *Value*: a number > 0 and
        <= 1.
    stiffness
        Stiffness of soft contacts: a head-on collision at a relative speed of 1 overlaps by
        1/sqrt(2 stiffness). *Unit*: T0/R^2. *Value*: a finite number > 0.
    normal_law
        Elastic force of soft contacts: linear in the overlap, or Hertz's with the modulus
        `stiffness`/R. *Value*: one of "linear", "hertz".
    steps_per_collision
        Least number of steps of a collision of soft contacts. *Value*: a number > 2 and <= 10000.
    """

    BODY: ClassVar[str] = "gas"

    count: int = 1000
    packing_fraction: float = 0.05
    restitution: float = 0.9
    tangential_restitution: float | None = None
    mu: float | None = None
    rotational_temperature: float = 0.0
    contact_time: float = 0.0
    seed: int = 1
    mixing_collisions: float = 20.0
    collisions: float = 30.0
    duration: float | None = None
    sample_every: float = 0.5
    method: Literal["events", "contact-dynamics", "soft"] = "events"
    max_displacement: float | None = None
    stiffness: float | None = None
    normal_law: Literal["linear", "hertz"] | None = None
    steps_per_collision: float | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class TipScene(Scene):
    """A tip turned or slid on a substrate.

    Parameters
    ----------
    potential
        Potential of all atoms. With a metal lengths are in A, energies in eV, times in ps,
        temperatures in K and forces in eV/A where other keys say sigma, eps, tau, eps/k_B and
        eps/sigma. *Value*: "lennard-jones", "sutton-chen:Cu" or another metal, or "eam:FILE".
    spacing
        Distance of neighbours in a Lennard-Jones crystal, at most 2; the default is that of the
        potential's minimum. A metal's follows from its potential, see `lattice_expansion`. *Unit*:
        sigma. *Value*: a number > 0.5 and <= 10.
    lattice_expansion
        Part by which the crystals of a metal are wider than at zero temperature and pressure.
        *Value*: a number > -0.2 and <= 0.2.
    face
        Face of the substrate's crystal that is parallel to its layers; close-packed rows are along
        x. *Value*: one of "fcc111", "fcc100", "fcc110".
    tip_face
        Face of the tip's crystal that is parallel to its layers. *Value*: one of "fcc111",
        "fcc100", "fcc110".
    substrate_columns
        Atoms along x in a layer of the substrate, periodic. *Value*: a whole number from 1 to 1000.
    substrate_rows
        Rows of atoms along y, an even number for fcc111, periodic. *Value*: a whole number from 1
        to 1000.
    substrate_layers
        Layers of the substrate: two frozen, two with a thermostat, the rest free. *Value*: a whole
        number from 4 to 100.
    tip_layers
        Layers of the tip: two driven, two with a thermostat, the rest free. *Value*: a whole number
        from 4 to 100.
    tip_side_atoms
        Atoms on a side of the tip's top layer, or from its middle to its rim. *Value*: a whole
        number from 1 to 300.
    outline
        Outline of the tip's layers. *Value*: one of "hexagon", "disk", "cone".
    tip_orientation
        Angle by which the tip's close-packed rows are turned out of those of the substrate. *Unit*:
        degree. *Value*: a number > -180 and <= 180.
    raise_
        Height of the driven layers above their place in the crystal. *Unit*: sigma. *Value*: a
        finite number.
    drive
        What moves the tip: a torque on the driven layers, or a support that pulls them through a
        spring. *Value*: one of "torque", "slide".
    speed
        Speed of the support. *Unit*: sigma/tau. *Value*: a finite number > 0.
    drive_angle
        Direction in which the support moves, from the close-packed rows of the substrate along x.
        *Unit*: degree. *Value*: a number > -360 and <= 360.
    stiffness
        Stiffness of the spring between the support and the driven layers. *Unit*: eps/sigma^2.
        *Value*: a finite number > 0.
    stroke
        Way of the support from one turning point to the next; if left out it does not turn. *Unit*:
        sigma. *Value*: a finite number > 0.
    lambda_
        Torque: force on each driven atom, see `reading`. *Unit*: eps/sigma^2. *Value*: a finite
        number.
    reading
        Meaning of lambda: the force at a distance of sigma from the axis, or the mean or largest
        force. *Value*: one of "angular", "mean", "largest".
    driven_constraint
        How driven layers are held: z of each atom fixed, or z common and free under `load`.
        *Value*: one of "plane", "level".
    load
        Force on each driven atom towards the substrate; if left out it is 0. *Unit*: eps/sigma.
        *Value*: a finite number.
    cutoff
        Cut-off radius of the Lennard-Jones potential; a metal has its own. *Unit*: sigma. *Value*:
        a number > 1 and <= 10.
    shift
        How the Lennard-Jones potential is shifted at the cut-off. *Value*: one of "none", "energy",
        "force".
    adhesion_energy
        Depth of the Lennard-Jones potential between tip and substrate. *Unit*: eps. *Value*: a
        finite number > 0.
    temperature
        Target temperature of the thermostats. *Unit*: eps/k_B. *Value*: a finite number >= 0.
    thermostat
        Thermostat of the bath layers. *Value*: one of "nose-hoover", "langevin", "none".
    thermostat_time
        Relaxation time of the Nose-Hoover thermostat. *Unit*: tau. *Value*: a finite number > 0.
    langevin_rate
        Rate of the Langevin thermostat. *Unit*: 1/tau. *Value*: a finite number > 0.
    spin
        Whether the tip's common motion is heat for its thermostat: the rotation of a turned tip
        (Nose-Hoover only), the velocity of a slid one. *Value*: one of "spared", "counts".
    drive_damping_rate
        Damping rate gamma of the driven atoms: the force on each is -gamma m v, with v relative to
        the support of a slid tip. *Unit*: 1/tau. *Value*: a finite number >= 0.
    equilibration
        Time before the drive is switched on. *Unit*: tau. *Value*: a finite number >= 0.
    drive_time
        Time that the drive lasts. *Unit*: tau. *Value*: a finite number >= 0.
    rest_time
        Time after the drive. *Unit*: tau. *Value*: a finite number >= 0.
    time_step
        Time step of the integrator. *Unit*: tau. *Value*: a number > 0 and <= 0.05.
    integrator
        Integrator, which says at what times velocities are kept. *Value*: one of "leap-frog",
        "velocity-verlet".
    skin
        Distance that neighbour lists reach beyond the cut-off. *Unit*: sigma. *Value*: a finite
        number > 0.
    seed
        Seed of the first velocities and of noise. *Value*: a whole number from 1 to
        9007199254740992.
    sample_every
        Steps from one line of the series to the next. *Value*: a whole number from 1 to 1000000000.
    """

    BODY: ClassVar[str] = "tip"

    potential: str = "lennard-jones"
    spacing: float = 1.122462048309373
    lattice_expansion: float = 0.0
    face: Literal["fcc111", "fcc100", "fcc110"] = "fcc111"
    tip_face: Literal["fcc111", "fcc100", "fcc110"] = "fcc111"
    substrate_columns: int = 28
    substrate_rows: int = 28
    substrate_layers: int = 6
    tip_layers: int = 6
    tip_side_atoms: int = 10
    outline: Literal["hexagon", "disk", "cone"] = "hexagon"
    tip_orientation: float = 0.0
    raise_: float = 0.0
    drive: Literal["torque", "slide"] = "torque"
    speed: float | None = None
    drive_angle: float | None = None
    stiffness: float | None = None
    stroke: float | None = None
    lambda_: float | None = 0.017
    reading: Literal["angular", "mean", "largest"] = "angular"
    driven_constraint: Literal["plane", "level"] = "plane"
    load: float | None = None
    cutoff: float = 2.5
    shift: Literal["none", "energy", "force"] = "none"
    adhesion_energy: float = 1.0
    temperature: float = 0.1
    thermostat: Literal["nose-hoover", "langevin", "none"] = "nose-hoover"
    thermostat_time: float = 0.5
    langevin_rate: float = 1.0
    spin: Literal["spared", "counts"] = "spared"
    drive_damping_rate: float = 0.1
    equilibration: float = 50.0
    drive_time: float = 200.0
    rest_time: float = 100.0
    time_step: float = 0.005
    integrator: Literal["leap-frog", "velocity-verlet"] = "leap-frog"
    skin: float = 0.3
    seed: int = 1
    sample_every: int = 100


__all__ = [
    "ClampScene",
    "CurlingScene",
    "CylinderScene",
    "GasScene",
    "GrainsScene",
    "InclineScene",
    "PipeScene",
    "PlateScene",
    "PowderScene",
    "SliderScene",
    "SpringScene",
    "TipScene",
    "TurntableScene",
]
