"""What the scenes of all bodies have in common."""

from __future__ import annotations

import dataclasses
import functools
import json
import keyword
import os
import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from tribos import _native

if TYPE_CHECKING:
    from collections.abc import Iterator

S = TypeVar("S", bound="Scene")
T = TypeVar("T")


@functools.cache
def vocabulary() -> dict[str, dict[str, Any]]:
    """The library's keys of each body, by the names of the fields."""
    return {
        known["body"]: {field_name(key["name"]): key for key in known["keys"]}
        for known in _native.vocabularies()
    }


def field_name(key: str) -> str:
    """The field of a key: a key that is a word of Python has an underscore behind."""
    return key + "_" if keyword.iskeyword(key) else key


@functools.cache
def earlier_names(body: str) -> dict[str, str]:
    """The fields of a body by the names that earlier versions had for them."""
    keys = vocabulary().get(body, {}).items()
    return {field_name(key["was"]): field for field, key in keys if key["was"] is not None}


def present_names(body: str, settings: Mapping[str, T]) -> dict[str, T]:
    """Settings by the present names of their fields."""
    named: dict[str, T] = {}
    for name, value in settings.items():
        now = earlier_names(body).get(name, name)
        if now != name:
            warnings.warn(f"`{name}` is called `{now}` now", DeprecationWarning, stacklevel=3)
            if now in settings:
                raise ValueError(f"give `{now}` alone; `{name}` is its earlier name")
        named[now] = value
    return named


def toml_value(value: object) -> str:
    """A value of a field as TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if hasattr(value, "item") and not isinstance(value, (int, float)):
        value = value.item()
    if isinstance(value, float):
        return repr(float(value))
    if isinstance(value, int):
        return str(int(value))
    return json.dumps(str(value), ensure_ascii=False)


def overrides_of(settings: Mapping[str, object]) -> list[str]:
    """Settings as the library's overrides."""
    return [f"{key.rstrip('_')}={toml_value(value)}" for key, value in settings.items()]


class Named(type):
    """The class of the scenes' classes: it takes fields by their earlier names too."""

    def __call__(cls, *args: Any, **fields: Any) -> Any:
        return super().__call__(*args, **present_names(getattr(cls, "BODY", ""), fields))


class Scene(metaclass=Named):
    """A scene of any body: an immutable dataclass whose fields are the keys of its files.

    A field that is None is off, or chosen from the others, as its documentation says. All values are checked
    when a scene is made, by the rules that files are read by; `dataclasses.replace` makes a changed one. Fields
    by names of earlier versions are taken and given with a `DeprecationWarning`.
    """

    __slots__ = ()

    BODY: ClassVar[str]

    def __post_init__(self) -> None:
        settings = [f"{key}={value}" for key, value in self._settings()]
        name = type(self).__name__
        values = _native.scene_of_settings(name, self.BODY, settings)
        for field, key in vocabulary()[self.BODY].items():
            given = getattr(self, field)
            if given is not None and key["name"] in values:
                object.__setattr__(self, field, values[key["name"]])

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            now = earlier_names(self.BODY).get(name)
            if now is None:
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            warnings.warn(f"`{name}` is called `{now}` now", DeprecationWarning, stacklevel=2)
            return getattr(self, now)

    def _settings(self) -> Iterator[tuple[str, str]]:
        """Keys that a file has to give for this scene, with their values as TOML."""
        for field, key in vocabulary()[self.BODY].items():
            value = getattr(self, field)
            if value is None:
                continue
            is_default = value == key["default"]
            if key["unless"] is not None:
                others = (getattr(self, field_name(other)) for other in key["unless"])
                stands_in = any(other is not None for other in others)
                is_left_out = is_default and stands_in
            elif key["unit_with"] is not None:
                other, word = key["unit_with"]
                is_left_out = is_default and getattr(self, field_name(other)) == word
            else:
                is_left_out = is_default and not key["needed"]
            if not is_left_out:
                yield key["name"], toml_value(value)

    def to_toml(self) -> str:
        """The scene as the text of a file that `from_toml` and the command read.

        Examples
        --------
        >>> import tribos
        >>> print(tribos.SliderScene(law="coulomb:mu=0.2", mass=0.2).to_toml())
        body = "disk"
        speed = 1.0
        spin = 5.0
        law = "coulomb:mu=0.2"
        gravity = 9.81
        radius = 0.08
        mass = 0.2
        inertia_ratio = 0.5
        <BLANKLINE>
        """
        lines = [f"{key} = {value}\n" for key, value in self._settings()]
        return f'body = "{self.BODY}"\n' + "".join(lines)

    @classmethod
    def from_toml(cls: type[S], text: str, *, name: str = "scene", **overrides: object) -> S:
        """Read the text of a scene file.

        Parameters
        ----------
        text
            The text.
        name
            Name of the file in refusals.
        **overrides
            Keys that replace those of the text.

        Raises
        ------
        ValueError
            Everything that is wrong with the text, each with its line.
        """
        return cls._of(*_native.scene_of_text(name, text, overrides_of(overrides)))

    @classmethod
    def read(cls: type[S], path: str | os.PathLike[str], **overrides: object) -> S:
        """Read a scene file, with keys that replace those of the file."""
        return cls._of(*_native.scene_of_file(os.fspath(path), overrides_of(overrides)))

    @classmethod
    def _of(cls: type[S], body: str, values: Mapping[str, Any]) -> S:
        """The scene of values in force, by present or earlier names."""
        made = next((kind for kind in subclasses() if kind.BODY == body), None)
        if made is None or not issubclass(made, cls):
            raise ValueError(f'body = "{body}" is not a {cls.__name__}')
        keys = vocabulary()[body]
        fields = {
            field: values.get(key["name"], values.get(key["was"], key["default"]))
            for field, key in keys.items()
        }
        # What is chosen from other fields stays so.
        chosen = {field for field, key in keys.items() if key["default"] is None}
        least = {field: None if field in chosen else value for field, value in fields.items()}
        try:
            there = made(**least).values()
        except ValueError:
            there = {}
        for field in chosen:
            if there.get(keys[field]["name"]) != fields[field]:
                least[field] = fields[field]
        return made(**least)

    def values(self) -> dict[str, Any]:
        """Keys and values in force, as the summaries of runs have them; None for what is off."""
        settings = [f"{key}={value}" for key, value in self._settings()]
        values: dict[str, Any] = _native.scene_of_settings(type(self).__name__, self.BODY, settings)
        return values

    def replace(self: S, **changes: object) -> S:
        """The scene with other values of some fields."""
        return dataclasses.replace(self, **present_names(self.BODY, changes))  # type: ignore[type-var]


def subclasses() -> list[type[Scene]]:
    """The classes of all bodies."""
    from tribos import scenes

    return [getattr(scenes, name) for name in scenes.__all__]


def scene(name: str, **overrides: object) -> Scene:
    """A scene that comes with the program.

    Parameters
    ----------
    name
        Its name: one of ``tribos scene list``.
    **overrides
        Keys that replace those of the scene.

    Examples
    --------
    >>> import tribos
    >>> tribos.scene("compaction-small", mu_rolling=1).mu_rolling
    1.0
    """
    known = {name: text for name, text, _ in _native.library_scenes()}
    if name not in known:
        names = ", ".join(known)
        raise ValueError(f"no scene comes with the program as {name!r}; there are {names}")
    return Scene.from_toml(known[name], name=name, **overrides)
