"""Writes python/tribos/scenes.py from the library's tables of keys; a test holds the two together.

python tools/scenes.py
"""

from __future__ import annotations

import sys
import textwrap
from pathlib import Path
from typing import Any

from tribos import _native
from tribos._scene import field_name

NAMES = {"disk": "SliderScene"}
WIDTH = 100

HEAD = '''"""Scenes, one class a body: made by tools/scenes.py from the library's tables of keys.

Lengths, times and forces are in the units that each field names; "-" is a pure number or a word.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from tribos._scene import Scene
'''


def class_name(body: str) -> str:
    """The name of a body's class."""
    return NAMES.get(body, body.capitalize() + "Scene")


def hint(key: dict[str, Any]) -> str:
    """The type of a field."""
    words = ", ".join(f'"{word}"' for word in key["words"])
    kind = {"number": "float", "count": "int", "text": "str", "ramp": "float | str", "word": f"Literal[{words}]"}
    can_be_off = key["default"] is None or key["unless"] is not None
    alternatives = [kind[key["kind"]]] + ["None"] * (can_be_off or key["name"] == "height")
    return " | ".join(alternatives)


def field(key: dict[str, Any]) -> str:
    """A field with its default."""
    name, default = field_name(key["name"]), key["default"]
    value = f'"{default}"' if isinstance(default, str) else repr(default)
    line = f"    {name}: {hint(key)} = {value}\n"
    if len(line) > WIDTH:
        line = f"    {name}: {hint(key)} = (\n        {value}\n    )\n"
    return line


def meaning(key: dict[str, Any]) -> str:
    """A field's documentation, in its class'."""
    unit = "" if key["unit"] == "-" else f" *Unit*: {key['unit']}."
    text = f"{key['meaning']}{unit} *Value*: {key['values']}.".replace("\\", "\\\\")
    filled = textwrap.fill(
        text,
        WIDTH,
        initial_indent="        ",
        subsequent_indent="        ",
        break_long_words=False,
    )
    return f"    {field_name(key['name'])}\n{filled}\n"


def generated() -> str:
    """The module's text."""
    parts = [HEAD]
    names = []
    for known in _native.vocabularies():
        name = class_name(known["body"])
        names.append(name)
        parts.append(
            f"\n\n@dataclass(frozen=True, kw_only=True, slots=True)\nclass {name}(Scene):\n"
            f'    """{known["title"]}.\n\n    Parameters\n    ----------\n'
            f'{"".join(map(meaning, known["keys"]))}    """\n\n'
            f'    BODY: ClassVar[str] = "{known["body"]}"\n\n'
        )
        parts.append("".join(map(field, known["keys"])))
    listed = "".join(f'    "{name}",\n' for name in sorted(names))
    parts.append(f"\n\n__all__ = [\n{listed}]\n")
    return "".join(parts)


if __name__ == "__main__":
    place = Path(__file__).parent.parent / "python" / "tribos" / "scenes.py"
    place.write_text(generated(), encoding="utf-8")
    sys.stdout.write(f"{place}\n")
