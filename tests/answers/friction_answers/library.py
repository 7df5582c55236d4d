"""An engine that is a shared library with the functions of engine.h."""

import json
from ctypes import CDLL, POINTER, Structure, byref, c_char_p, c_double, c_int, c_void_p
from itertools import chain
from types import SimpleNamespace

from .scene import Refused, Unsupported

SHAPES = ("box", "cylinder", "ball", "capsule", "feet")
Vector, State = c_double * 3, c_double * 13


class CBody(Structure):
    _fields_ = [
        *((name, c_int) for name in ("kind", "is_driven", "is_rim")),
        ("sizes", c_double * 6), ("place", Vector), ("pose", c_double * 4), ("mass", c_double), ("inertia", Vector), ("com", Vector),
    ]  # fmt: skip


class CScene(Structure):
    _fields_ = [
        *((name, c_double) for name in ("mu", "mu_across", "torsion")), ("gravity", Vector), ("dt", c_double),
        *((name, c_int) for name in ("has_floor", "setting", "count")), ("bodies", POINTER(CBody)),
    ]  # fmt: skip


def about(library):
    """What the library says of itself; Refused says what is wrong with it."""
    text = library.fa_about()
    try:
        found = json.loads(text or b"")
        names = {name.upper(): found[name] for name in ("name", "version", "licence", "kind")}
        settings = {name: {"dt": options["dt"], **options} for name, options in found["settings"].items()}
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise Refused(f"fa_about gives {(text or b'nothing').decode(errors='replace')}: {error!r}; engine.h says what it has to be") from error
    return names, settings


def engine(path):
    """The adapter of a library at this path."""
    library = CDLL(path)
    library.fa_about.restype, library.fa_make.restype = c_char_p, c_void_p
    library.fa_make.argtypes = POINTER(CScene), POINTER(c_char_p)
    for name, more in {"drop": (), "set": (c_int, Vector, Vector), "step": (), "state": (c_int, State), "gravity": (Vector,), "force": (c_int, Vector)}.items():
        function = getattr(library, f"fa_{name}")
        function.argtypes, function.restype = (c_void_p, *more), None
    names, settings = about(library)

    class Simulator:
        def __init__(self, scene, setting, dt):
            bodies = (CBody * len(scene.bodies))(*map(c_body, scene.bodies))
            across = -1.0 if scene.mu_across is None else scene.mu_across
            number = next(i for i, one in enumerate(settings.values()) if one is setting)
            made = CScene(scene.mu, across, scene.torsion, Vector(*scene.gravity), dt, scene.has_floor, number, len(bodies), bodies)
            why = c_char_p()
            self.world = library.fa_make(byref(made), byref(why))
            if not self.world:
                raise Unsupported((why.value or b"fa_make gives no world, and no reason.").decode(errors="replace"))

        def __del__(self):
            if getattr(self, "world", None):
                library.fa_drop(self.world)

        def set(self, body, velocity, spin):
            library.fa_set(self.world, body, Vector(*velocity), Vector(*spin))

        def step(self):
            library.fa_step(self.world)

        def state(self, body):
            got = State()
            library.fa_state(self.world, body, got)
            return tuple(got[:3]), tuple(got[3:7]), tuple(got[7:10]), tuple(got[10:])

        def gravity(self, vector):
            library.fa_gravity(self.world, Vector(*vector))

        def force(self, body, vector):
            library.fa_force(self.world, body, Vector(*vector))

    return SimpleNamespace(**names, SETTINGS=settings, Simulator=Simulator)


def c_body(body):
    shape = body.shape
    sizes = tuple(chain(*shape.sizes)) if shape.kind == "feet" else shape.sizes
    kind = SHAPES.index(shape.kind)
    pose = (c_double * 4)(*body.pose)
    numbers = ((c_double * 6)(*sizes), Vector(*body.place), pose, body.mass, Vector(*body.inertia), Vector(*body.com))
    return CBody(kind, body.is_driven, shape.is_rim, *numbers)
