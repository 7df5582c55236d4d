"""Objects that do not change."""

from __future__ import annotations

from typing import Any, NoReturn


class Frozen:
    """A base of classes whose attributes are set once, by `_keep`."""

    __slots__ = ()

    def _keep(self, **attributes: Any) -> None:
        for name, value in attributes.items():
            object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"a {type(self).__name__} does not change: make another one")

    def __delattr__(self, name: str) -> NoReturn:
        raise AttributeError(f"a {type(self).__name__} does not change: make another one")
