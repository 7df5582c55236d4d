"""Quasi-static pushes: the motion of a body under a pusher of given velocity, and its path.

Friction on the floor balances the pusher at every moment: nothing has inertia. Let u be the velocity of the pusher
and p the place where it touches the body.

*It sticks.* The contact moves with u, so that the spin w alone is unknown, and the force acts at p, so that friction
has no torque about p. This torque is the derivative by w of the dissipation D(u + w x (r - p)), which is convex: the
motion is the one that dissipates least among all that follow the pusher, the zero of a function that rises with w.
As D is a norm, D(0) >= D(w) >= |w| D(1) - D(0) there, with D(1) that of the rotation about p; so |w| L <= 2 |u| with
the lever L = D(1)/D(unit velocity).

*It slides* where the force of that motion is beyond the friction cone: the force is then on the cone's edge, the
motion is the limit surface's normal there (Goyal, Ruina, Papadopoulos, Wear 143 (1991) 307), and the body takes the
velocity of the pusher along the contact's normal.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

from tribos._forms.space import Space

MODES = ("sticking", "sliding left", "sliding right", "separating")
"""What a contact does, by the numbers in `Push.mode`."""
STICKING, SLIDING_LEFT, SLIDING_RIGHT, SEPARATING = range(len(MODES))

# The search for the spin ends with a step below this, by type: the next one would be below rounding.
_FINEST = {"float32": 1e-4, "float64": 1e-8}
# At most so many; 6 were seen on compact patches, 16 on rings and on boxes of 1 : 1000.
_MOST_STEPS = 40
# Steps with derivatives that follow: each makes one more derivative of the solution exact.
_EXACT_DERIVATIVES = 2
# Bound of spin times lever over the pusher's speed.
_FASTEST = 2.0


class PointContact(NamedTuple):
    """Where a pusher touches a body, as `tribos.PointContact`, of arrays that may be traced."""

    position: Any
    """Places in the coordinates of the body's patch, in m, of shape (..., 2)."""
    normal: Any
    """Directions into the body, of shape (..., 2), of any length but 0."""
    mu: Any
    """Coefficient of friction between pusher and body, at least 0, of shape (...)."""


class Push(NamedTuple):
    """What a pusher with a given velocity does."""

    mode: Any
    """Whole numbers: 0 sticking; 1, 2 the pusher slides to the left, to the right along the body; 3 it moves
    away and the body rests. Their names are in `MODES`."""
    twist: Any
    """Motion of the body in m/s and rad/s, of shape (..., 3)."""
    contact_velocity: Any
    """Velocity of the body at the contact, in m/s, of shape (..., 2)."""
    slip: Any
    """Velocity of the pusher past the body, in m/s, of shape (..., 2)."""
    wrench: Any
    """What the pusher exerts, about the origin, in N and N m, of shape (..., 3)."""

    def only(self, space: Space, touches: Any) -> Push:
        """The push where the pusher touches the body, else none."""

        def kept(rows: Any, other: Any) -> Any:
            return space.where(touches[..., None], rows, other)

        nothing = space.constant(0.0, self.slip)
        return Push(
            space.where(touches, self.mode, SEPARATING),
            kept(self.twist, nothing),
            kept(self.contact_velocity, nothing),
            kept(self.slip, self.slip + self.contact_velocity),
            kept(self.wrench, nothing),
        )


class Floor(Protocol):
    """Dry friction of the body on the floor."""

    @property
    def limit(self) -> Any:
        """The largest force, in N."""

    def wrench(self, twists: Any) -> Any:
        """Friction at motions, over the largest force."""

    def changing(self, twists: Any, rates: Any) -> tuple[Any, Any]:
        """The same, and its rate where the motions have these rates."""

    def normal(self, wrenches: Any) -> Any:
        """The motions that pushes cause, of any length."""

    def still(self) -> Floor:
        """The same without derivatives."""


class _Contact(NamedTuple):
    """Contact and pusher in components: place, unit normal into the body, coefficient, velocity."""

    px: Any
    py: Any
    nx: Any
    ny: Any
    mu: Any
    ux: Any
    uy: Any

    @property
    def approach(self) -> Any:
        """Speed of the pusher along the normal."""
        return self.nx * self.ux + self.ny * self.uy


def push(space: Space, floor: Floor, contact: PointContact, velocity: Any) -> Push:
    """The motion under a pusher: arrays with their leading axes broadcast together."""
    given = _components(space, contact, velocity)
    is_pushed = given.approach > 0.0
    # A pusher that moves away is computed as one that moves straight on, and counts for nothing.
    at = given._replace(
        ux=space.where(is_pushed, given.ux, space.still(given.nx)),
        uy=space.where(is_pushed, given.uy, space.still(given.ny)),
    )
    stuck, opposed = _sticking(space, floor, at)
    fx, fy = -floor.limit * opposed[..., 0], -floor.limit * opposed[..., 1]
    pressing, friction = fx * at.nx + fy * at.ny, fy * at.nx - fx * at.ny
    is_left = friction > 0.0
    slides = space.abs(friction) > at.mu * pressing
    edge, edge_wrench = _sliding(space, floor, at, space.where(is_left, at.mu, -at.mu))

    twist = space.where(slides[..., None], edge, stuck)
    at_contact = space.stack(_velocity_at(twist, at))
    slip = space.stack([at.ux, at.uy]) - at_contact
    made = Push(
        mode=space.where(slides, space.where(is_left, SLIDING_LEFT, SLIDING_RIGHT), STICKING),
        twist=twist,
        contact_velocity=at_contact,
        slip=space.where(slides[..., None], slip, space.constant(0.0, slip)),
        wrench=space.where(slides[..., None], edge_wrench, _wrench_at(space, at, fx, fy)),
    ).only(space, is_pushed)
    # A pusher that moves away does so with its own velocity.
    own = space.stack([given.ux, given.uy])
    slip = space.where(is_pushed[..., None], made.slip, own)
    # What is no number, or no direction, pushes nothing and has no motion.
    nothing = sum(0.0 * part for part in given)
    return made._replace(slip=slip, twist=made.twist + nothing[..., None])


def _components(space: Space, contact: PointContact, velocity: Any) -> _Contact:
    nx, ny = contact.normal[..., 0], contact.normal[..., 1]
    length = length_of(space, nx, ny)
    px, py = contact.position[..., 0], contact.position[..., 1]
    parts = (px, py, nx / length, ny / length, contact.mu, velocity[..., 0], velocity[..., 1])
    # One shape for all.
    together = space.stack(parts)
    return _Contact(*(together[..., k] for k in range(len(parts))))


def length_of(space: Space, x: Any, y: Any) -> Any:
    """Length of a vector, without overflow of its square."""
    longest = space.still(space.where(space.abs(x) > space.abs(y), space.abs(x), space.abs(y)))
    x, y = x / longest, y / longest
    return longest * space.sqrt(x * x + y * y)


def _sticking(space: Space, floor: Floor, at: _Contact) -> tuple[Any, Any]:
    """The motion that dissipates least among those in which the contact follows the pusher, and friction at it."""
    # Spins in units of the pusher's speed over the lever; the lever is a unit and has no derivatives.
    lever, spin, slope = _search(
        space, floor.still(), _Contact(*(space.still(part) for part in at))
    )
    speed, line = _line(space, at, lever)

    def step(spin: Any, _: Any) -> tuple[Any, tuple[Any, Any]]:
        twist = line.at(spin)
        friction = floor.wrench(twist)
        return spin + _power(friction, line.turn) / slope, (twist, friction)

    # Steps with the slope held: each makes one more derivative of the zero exact.
    none = space.constant([0.0] * (1 + _EXACT_DERIVATIVES), lever)
    _, (twists, frictions) = space.course(step, spin, none)
    return twists[-1] * speed[..., None], frictions[-1]


class _Line(NamedTuple):
    """Motions that carry the contact at unit velocity, by the spin."""

    ahead: Any
    turn: Any

    def at(self, spin: Any) -> Any:
        return self.ahead + spin[..., None] * self.turn


def _line(space: Space, at: _Contact, lever: Any) -> tuple[Any, _Line]:
    """The pusher's speed, and the motions that follow it, over that speed."""
    speed = length_of(space, at.ux, at.uy)
    ahead = space.stack([at.ux / speed, at.uy / speed, space.constant(0.0, speed)])
    return speed, _Line(ahead, space.stack([at.py / lever, -at.px / lever, 1.0 / lever]))


def _search(space: Space, floor: Floor, at: _Contact) -> tuple[Any, Any, Any]:
    """Lever, spin and slope of the torque at the motion that dissipates least."""
    one = space.constant(1.0, at.px) + 0.0 * at.px
    about = space.stack([at.py, -at.px, one])
    ahead = space.stack([at.ux, at.uy, 0.0 * one])
    both = space.first_axis(space.stack([about, ahead]), len(about.shape))
    turning, sliding = floor.wrench(both)
    lever = -_power(turning, about)
    _, line = _line(space, at, lever)
    # An ellipsoid that has the lever would have this zero.
    start = _power(sliding, line.turn)
    finest = _FINEST[space.type_of(start)]

    def step(state: Any) -> Any:
        spin, low, high, _, _ = state
        # The torque about the contact that the spin needs, over lever and force limit, rises from -1 to 1.
        friction, change = floor.changing(line.at(spin), line.turn)
        torque, slope = -_power(friction, line.turn), -_power(change, line.turn)
        low, high = space.where(torque < 0.0, spin, low), space.where(torque < 0.0, high, spin)
        newton = spin - torque / slope
        is_within = (newton > low - finest) & (newton < high + finest)
        after = space.where(is_within, newton, 0.5 * (low + high))
        return after, low, high, slope, space.abs(after - spin)

    def is_done(state: Any) -> Any:
        return state[-1] <= finest

    state = (start, -_FASTEST * one, _FASTEST * one, one, one)
    spin, _, _, slope, _ = space.loop(step, state, _MOST_STEPS, is_done)
    return lever, spin, slope


def _sliding(space: Space, floor: Floor, at: _Contact, share: Any) -> tuple[Any, Any]:
    """Motion and push under a force with this share of friction to the left, and the pusher's approach."""
    fx, fy = at.nx - share * at.ny, at.ny + share * at.nx
    force = _wrench_at(space, at, fx, fy)
    twist = floor.normal(force)
    vx, vy = _velocity_at(twist, at)
    ahead = vx * at.nx + vy * at.ny
    # An edge that moves the contact back is beyond every pusher.
    factor = at.approach / space.where(ahead > 0.0, ahead, space.constant(1.0, ahead))
    # On the surface along the force: the gauge is power over dissipation.
    given, spent = _power(force, twist), -_power(floor.wrench(twist), twist)
    return twist * factor[..., None], force * (floor.limit * spent / given)[..., None]


def _power(wrench: Any, twist: Any) -> Any:
    """Power of a wrench at a motion."""
    given = wrench * twist
    return given[..., 0] + given[..., 1] + given[..., 2]


def _wrench_at(space: Space, at: _Contact, fx: Any, fy: Any) -> Any:
    """A force at the contact with its torque about the origin."""
    return space.stack([fx, fy, at.px * fy - at.py * fx])


def _velocity_at(twist: Any, at: _Contact) -> tuple[Any, Any]:
    """Velocity of the body at the contact."""
    spin = twist[..., 2]
    return twist[..., 0] - spin * at.py, twist[..., 1] + spin * at.px
