"""The path of a body under a pusher with a course of its own, by steps of equal length.

Steps are those of Runge and Kutta of fourth order. The rate of the pose is continuous, so that one step in which sticking
begins or ends has an error of second order, all others of fifth.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from tribos._forms.pushing import SEPARATING, Floor, PointContact, Push, length_of, push
from tribos._forms.space import Space

ENDS = ("done", "slipped", "separated")
"""How a path ends, by the numbers in `Journey.end`."""
DONE, SLIPPED, SEPARATED = range(len(ENDS))

# A stage starts from the step's start by so much of the last stage's change and of the mean one, counts so much in the mean,
# and is at this part of the step. The last stage is the end of the step.
_STAGES = (
    (0.0, 0.0, 1.0 / 6.0, 0.0),
    (0.5, 0.0, 1.0 / 3.0, 0.5),
    (0.5, 0.0, 1.0 / 3.0, 0.5),
    (1.0, 0.0, 1.0 / 6.0, 1.0),
    (0.0, 1.0, 0.0, 1.0),
)


class Journey(NamedTuple):
    """The path of a pushed body. From an early end on, the body rests and is not pushed."""

    time: Any
    """Times since the start, in s."""
    position: Any
    """Places of the patch's origin on the floor, in m, in rows of 2."""
    angle: Any
    """Turns counterclockwise, in rad."""
    contact: Any
    """Where the pusher touches the body, in the coordinates of the body, in m, in rows of 2."""
    push: Push
    """The pushes, in the coordinates of the body."""
    end: Any
    """Whole numbers: 0 done; 1 the pusher has come to the end of the side; 2 it has moved away from the body. Their
    names are in `ENDS`."""


class Pusher(NamedTuple):
    """What stays along a path."""

    contact: PointContact
    """The contact at the start."""
    side: tuple[Any, Any] | None
    """How far a straight side goes on from there, to the right and to the left, in m; None for a circle about the
    origin."""
    floor: Floor

    def push(self, space: Space, place: Any, velocity: Any) -> Push:
        """The push where the pusher is at this place of the body, in the coordinates of the body."""
        normal = self.contact.normal if self.side else -place
        return push(space, self.floor, PointContact(place, normal, self.contact.mu), velocity)

    def along(self, space: Space, place: Any) -> Any:
        """How far a place is to the left of the contact at the start."""
        nx, ny = self.contact.normal[..., 0], self.contact.normal[..., 1]
        off = place - self.contact.position
        return (nx * off[..., 1] - ny * off[..., 0]) / length_of(space, nx, ny)


class _State(NamedTuple):
    """Pose of the body, place of the pusher on the floor, time, how the path ended."""

    pose: Any
    pusher: Any
    time: Any
    end: Any

    def place(self, space: Space) -> Any:
        """Where the pusher is, in the coordinates of the body."""
        return turned(space, self.pusher - self.pose[..., :2], -self.pose[..., 2])


def follow(space: Space, pusher: Pusher, start: Any, velocities: Any, lengths: Any) -> Journey:
    """The state after each step, of arrays with the same leading axes; steps are rows of the first axis.

    Parameters
    ----------
    start
        Place and turn of the body.
    velocities
        Those of the pusher on the floor.
    lengths
        Of the steps, in s; 0 for a first row gives the start.
    """
    time, place = 0.0 * start[..., 0], turned(space, pusher.contact.position, start[..., 2])
    state = _State(start, start[..., :2] + place, time, space.where(time == time, DONE, DONE))

    def step(state: _State, row: tuple[Any, Any]) -> tuple[_State, Journey]:
        after, made = _stepped(space, pusher, state, *row)
        made = made.only(space, after.end == DONE)
        pose = after.pose
        at = (pose[..., :2], pose[..., 2], after.place(space), made)
        return after, Journey(after.time, *at, after.end)

    _, journey = space.course(step, state, (velocities, lengths))
    last: Journey = journey
    return last


def _stepped(
    space: Space, pusher: Pusher, state: _State, velocity: Any, length: Any
) -> tuple[_State, Push]:
    """The state after a step, and the push there."""
    change, made = _change(space, pusher, state, velocity, length)
    ahead = _moved(state, 1.0, change, velocity, length)
    end = space.where(made.mode == SEPARATING, SEPARATED, DONE)
    part = 1.0 + 0.0 * ahead.time
    if pusher.side:
        part, is_off = _part_on_side(space, pusher, pusher.side, state, ahead)
        end = space.where(is_off, SLIPPED, end)
    goes_on = state.end == DONE
    part = space.where(goes_on, part, 0.0 * part)
    after = _moved(state, part, change, velocity, length)
    return after._replace(end=space.where(goes_on, end, state.end)), made


def _change(
    space: Space, pusher: Pusher, state: _State, velocity: Any, length: Any
) -> tuple[Any, Push]:
    """The change of the pose in a step by the method of Runge and Kutta, and the push at its end."""

    def stage(now: tuple[Any, Any], weights: Any) -> tuple[tuple[Any, Any], Push]:
        last, mean = now
        of_last, of_mean, share, time = weights[0], weights[1], weights[2], weights[3]
        pose = state.pose + of_last * last + of_mean * mean
        there = _State(pose, state.pusher + (time * length)[..., None] * velocity, None, None)
        angle = pose[..., 2]
        made = pusher.push(space, there.place(space), turned(space, velocity, -angle))
        rate = made.twist
        floor = turned(space, rate[..., :2], angle)
        rate = space.stack([floor[..., 0], floor[..., 1], rate[..., 2]]) * length[..., None]
        return (rate, mean + share * rate), made

    none = 0.0 * state.pose
    rows = space.constant(_STAGES, none)
    (_, change), pushes = space.course(stage, (none, none), rows)
    return change, Push(*(part[-1] for part in pushes))


def _moved(state: _State, part: Any, change: Any, velocity: Any, length: Any) -> _State:
    """The state after a part of a step."""
    time = part * length
    return state._replace(
        pose=state.pose + (part + 0.0 * time)[..., None] * change,
        pusher=state.pusher + time[..., None] * velocity,
        time=state.time + time,
    )


def _part_on_side(
    space: Space, pusher: Pusher, side: tuple[Any, Any], before: _State, after: _State
) -> tuple[Any, Any]:
    """The part of a step in which the pusher is on its side, and whether it comes to its end."""
    right, left = side
    was, after_ = (pusher.along(space, state.place(space)) for state in (before, after))
    is_off = ((after_ > left) | (after_ < -right)) & (after_ != was)
    bound = space.where(after_ > left, left, -right)
    part = space.where(is_off, bound - was, 1.0) / space.where(is_off, after_ - was, 1.0)
    # One that starts at the end of a side may be beyond it by rounding.
    return space.where(part > 0.0, part, 0.0 * part), is_off


def turned(space: Space, vectors: Any, angle: Any) -> Any:
    """Vectors turned counterclockwise."""
    cos, sin = space.cos(angle), space.sin(angle)
    x, y = vectors[..., 0], vectors[..., 1]
    return space.stack([cos * x - sin * y, sin * x + cos * y])
