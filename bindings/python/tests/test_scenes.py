"""Scenes: the library's keys, defaults and refusals."""

from __future__ import annotations

import dataclasses
import pickle
import runpy
from pathlib import Path

import numpy as np
import pytest
import tribos
from tribos import _native, scenes
from tribos._scene import earlier_names, subclasses, vocabulary

LIBRARY = {name: text for name, text, _ in _native.library_scenes()}


def test_the_classes_are_those_of_the_librarys_tables() -> None:
    made = runpy.run_path(str(Path(__file__).parent.parent / "tools" / "scenes.py"))
    there = Path(scenes.__file__).read_text(encoding="utf-8")
    assert there == made["generated"](), "python tools/scenes.py writes it"
    assert sorted(kind.BODY for kind in subclasses()) == sorted(vocabulary())


@pytest.mark.parametrize("name", LIBRARY)
def test_a_file_is_read_to_the_same_values_and_back(name: str) -> None:
    _, values = _native.scene_of_text(name, LIBRARY[name], [])
    scene = tribos.scene(name)
    assert scene.values() == values
    again = type(scene).from_toml(scene.to_toml())
    assert again == scene and again.values() == values
    assert pickle.loads(pickle.dumps(scene)) == scene
    assert tribos.Scene.from_toml(scene.to_toml()) == scene


@pytest.mark.parametrize("kind", subclasses())
def test_the_default_scene_is_that_of_the_library(kind: type[tribos.Scene]) -> None:
    scene = kind()
    for field, key in vocabulary()[kind.BODY].items():
        assert getattr(scene, field) == key["default"], field
    field = dataclasses.fields(scene)[0].name
    with pytest.raises(dataclasses.FrozenInstanceError):
        setattr(scene, field, 1)


def test_refusals_are_the_librarys_words_with_file_and_line(tmp_path: Path) -> None:
    with pytest.raises(ValueError) as refused:
        tribos.SliderScene(speed=-1.0, samples=0, integrator="euler")  # type: ignore[arg-type]
    lines = str(refused.value).splitlines()
    assert lines[0] == "SliderScene: `speed` must be a finite number >= 0, not -1"
    assert len(lines) == 3 and "`integrator` must be one of" in lines[2]
    text = 'body = "curling"\nspeed = -2\nspinn = 1.5'
    with pytest.raises(ValueError) as refused:
        tribos.Scene.from_toml(text, name="rock.toml")
    assert str(refused.value).startswith("rock.toml:2: `speed` must be a finite number >= 0")
    assert "rock.toml:3: unknown key `spinn`; did you mean `spin`?" in str(refused.value)
    file = tmp_path / "rock.toml"
    file.write_text(text)
    with pytest.raises(ValueError, match=r"rock\.toml:2: `speed`"):
        tribos.CurlingScene.read(file)
    with pytest.raises(ValueError, match="override: unknown key `rollling`; did you mean"):
        tribos.scene("compaction-small", rollling=1)
    with pytest.raises(ValueError, match="is not a TipScene"):
        tribos.TipScene.from_toml(LIBRARY["disk"])
    with pytest.raises(OSError, match="cannot read the scene"):
        tribos.Scene.read(tmp_path / "nowhere.toml")
    with pytest.raises(ValueError, match="compaction-small"):
        tribos.scene("compaction")
    with pytest.raises(TypeError, match="spinn"):
        tribos.SliderScene(spinn=1.0)  # type: ignore[call-arg]


def test_keys_that_stand_for_each_other_are_given_once() -> None:
    law = tribos.SliderScene(law="coulomb:mu=0.2")
    assert "gamma" not in law.to_toml() and "law" in law.values()
    with pytest.raises(ValueError, match="law"):
        tribos.SliderScene(law="coulomb:mu=0.2", gamma=0.5)
    counted = tribos.PowderScene(count=100)
    assert counted.height is None and "height" not in counted.to_toml()
    # Without a dimension gravity, radius and mass are 1.
    pure = tribos.SliderScene(units="dimensionless")
    assert (pure.gravity, pure.radius, pure.mass) == (1.0, 1.0, 1.0)
    # The exponent of the ice follows from its model, unless it is given.
    assert tribos.CurlingScene(model="dry").values()["alpha"] == 0.0
    given = tribos.CurlingScene(model="front-back", alpha=-0.25)
    assert given.values()["alpha"] == -0.25
    assert tribos.CurlingScene.from_toml(given.to_toml()) == given


def test_keys_that_are_words_of_python_have_an_underscore() -> None:
    tip = tribos.TipScene(lambda_=0.02, raise_=0.1)
    assert "lambda = 0.02" in tip.to_toml() and tip.values()["raise"] == 0.1
    assert tribos.scene("tip-reversible", lambda_=0.02).values()["lambda"] == 0.02


@pytest.mark.parametrize("kind", subclasses())
def test_earlier_names_of_fields_are_deprecated_and_mean_the_same(kind: type[tribos.Scene]) -> None:
    for was, now in earlier_names(kind.BODY).items():
        default = getattr(kind(), now)
        with pytest.warns(DeprecationWarning, match=f"`{was}` is called `{now}` now"):
            assert kind(**{was: default}) == kind(**{now: default})
        with pytest.warns(DeprecationWarning):
            assert getattr(kind(), was) == default
        with pytest.warns(DeprecationWarning), pytest.raises(ValueError, match="alone"):
            kind(**{was: default, now: default})


def test_numbers_of_numpy_are_numbers() -> None:
    scene = tribos.PowderScene(seed=np.int64(3), pressure=np.float32(0.5))  # type: ignore[arg-type]
    assert scene.seed == 3 and type(scene.seed) is int
    assert scene.pressure == 0.5 and type(scene.pressure) is float
