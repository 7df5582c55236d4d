"""What the forms need of an array library."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol


class Space(Protocol):
    """Operations on arrays of one library. Arithmetic is that of the arrays' own operators."""

    def where(self, mask: Any, a: Any, b: Any) -> Any:
        """`a` where the mask holds, else `b`."""

    def sqrt(self, x: Any) -> Any:
        """Square root."""

    def log(self, x: Any) -> Any:
        """Natural logarithm."""

    def abs(self, x: Any) -> Any:
        """Absolute value; its derivative at 0 is 0."""

    def stack(self, parts: Sequence[Any]) -> Any:
        """Arrays side by side along a new last axis, after broadcasting."""

    def parts(self, rows: Any) -> Sequence[Any]:
        """The entries along the last axis one by one, cheap to transpose: the inverse of `stack`."""

    def first_axis(self, x: Any, rank: int) -> Any:
        """The last axis as the first one, before `rank` others: axes of length 1 where there are fewer."""

    def total(self, x: Any) -> Any:
        """Sum along the first axis."""

    def largest(self, x: Any) -> Any:
        """The largest along the first axis."""

    def following(self, x: Any) -> Any:
        """Each entry's successor along the first axis, the first after the last."""

    def constant(self, c: Any, like: Any) -> Any:
        """A number or a table in the type of an array, on its device."""

    def type_of(self, x: Any) -> str:
        """ "float32" or "float64"."""

    def still(self, x: Any) -> Any:
        """The same without derivatives."""

    def apart(self, x: Any) -> Any:
        """The same, not to be computed again at each use."""

    def epsilon(self, x: Any) -> float:
        """The distance from 1 to the next number of a type."""

    def loop(
        self,
        step: Callable[[Any], Any],
        state: Any,
        count: int,
        is_done: Callable[[Any], Any] | None = None,
    ) -> Any:
        """The state after so many steps, or before as soon as all of `is_done` holds; without derivatives."""

    def pushed(
        self, of: Callable[..., Any], arguments: Sequence[Any], tangents: Sequence[Any]
    ) -> Any:
        """The rate of a function's value along tangents of its arguments; differentiable in turn."""

    def ruled(self, value: Callable[..., Any], rule: Callable[..., Any]) -> Callable[..., Any]:
        """A function with its own first derivative.

        `rule(arguments, tangents)` gives the values and their rates, linear in the tangents, which are None for arguments
        that do not change; it is made of operations of the space, so that it can be differentiated in turn. Where `value` is a search it is the only source
        of derivatives: a library without rules takes the value without derivatives, and adds half the sum of the rates at
        the arguments and at the arguments without derivatives, along arguments less their values, which is exact to second
        order.
        """
