"""Start of an adapter for an engine of your own: copy this file, fill in what raises, and run `friction-answers run your_file.py --quick`.

`scene.py` of the package says what a scene holds, and has helpers: `parts` (shapes by kind), `of_centre`, `of_origin`, `rotated`, `refuse`.
Restitution, damping and sleep are off; friction between any two bodies is `scene.mu`, whatever the rule by which the engine combines coefficients. An
engine without a shape refuses it.

Check first, in this order: `--items collide` (masses, inertia, frames of spins), `--items oblique`, `--items box --case 0` (0.1667 m, or less by
half a step at 1 m/s), then `--quick`.
"""

from friction_answers.scene import Unsupported  # noqa: F401

NAME, VERSION, LICENCE, KIND = "my engine", "0.1", "MIT", "mechanics"  # or "games", "gpu": the table of the page
# The engine's own defaults first, step included, then what makes it best. `dt` is the length of a step in s; other keys are yours.
SETTINGS = {"default": {"dt": 1 / 240}}


class Simulator:
    def __init__(self, scene, setting, dt):
        """Builds the floor z = 0 if `scene.has_floor`, and each of `scene.bodies` at rest; `setting` is an entry of SETTINGS, `dt` its step.

        Raise `Unsupported("why")` for what the engine has not; `scene.needs` names it: feet, capsule, driven, gravity, force, torsion, anisotropic.
        """
        raise NotImplementedError

    def set(self, body, velocity, spin):
        """Velocity of the centre of mass, m/s, and spin, rad/s, of the body of this number, along the axes of the world.

        Of driven bodies, which nothing stops, it is called anew before every step.
        """
        raise NotImplementedError

    def step(self):
        """One step of dt."""
        raise NotImplementedError

    def state(self, body):
        """Centre of mass (x, y, z), quaternion (w, x, y, z), velocity of the centre of mass, spin, along the axes of the world."""
        raise NotImplementedError

    def gravity(self, vector):
        """Gravity from now on, m/s^2 (only scenes that need `gravity`)."""
        raise NotImplementedError

    def force(self, body, vector):
        """Force on a centre of mass in the next step, N (only scenes that need `force`)."""
        raise NotImplementedError
