"""Arguments of functions of tensors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import torch  # type: ignore[import-not-found, unused-ignore]

from tribos import _arguments
from tribos._friction import Friction


class Call(_arguments.Call):
    """A call of a function of tensors, which have one type and device together."""

    MODULE = "tribos.torch"
    BACKENDS = ("auto", "tensors", "kernel")
    OPERATIONS = "tensors"

    def __init__(
        self, name: str, friction: Friction, *given: Any, length: Any = None, **keywords: Any
    ) -> None:
        self.has_length = isinstance(length, torch.Tensor)
        super().__init__(name, friction, (*given, length), **keywords)
        if self.kind is None and self.has_length:
            raise ValueError(
                f"{self.name}: length must be a number for {self.friction!r} with the kernel; tensors go with "
                f"{_arguments.WITH_FORM}, without backend='kernel'"
            )
        if self.kind is None and self.device.type != "cpu":
            raise ValueError(
                f"{self.name}: tensors must be on the processor, not on {self.device}, for {self.friction!r} "
                f"with backend={keywords.get('backend', 'auto')!r}; {_arguments.WITH_FORM} is computed on every "
                "device with backend='auto'"
            )

    def _types(self, given: tuple[Any, ...]) -> tuple[Any, Any]:
        result, computed, self.device = together(self.name, given)
        return result, computed

    def _array(self, given: Any) -> Any:
        return tensor(given, self.type, self.device)

    def _chooses_kernel(self, given: list[str]) -> bool:
        return self.device.type == "cpu" and not given and not self.has_length

    def angle(self, given: Any) -> Any:
        """Angles of any sign."""
        made = self._array(given)
        self.meet("angle", tuple(made.shape))
        return made

    def _above_zero(self, made: Any) -> Any:
        return torch.where(made > 0.0, made, torch.full_like(made, torch.nan))

    def own(self, made: Any) -> Any:
        return made.to(self.result)


def together(name: str, given: Sequence[Any]) -> tuple[Any, Any, Any]:
    """The type of results, that of what is computed, and the device; PyTorch's default type for numbers."""
    tensors = [x for x in given if isinstance(x, torch.Tensor)]
    for x in tensors:
        if x.is_complex():
            raise ValueError(f"{name}: arguments must be real numbers, not {x.dtype}")
    devices = list(dict.fromkeys(x.device for x in tensors))
    if len(devices) > 1:
        raise ValueError(
            f"{name}: tensors must be on one device, not on {devices[0]} and {devices[1]}"
        )
    floats = [x for x in tensors if x.is_floating_point()]
    # As in PyTorch tensors of numbers count where there are no others.
    types = [x.dtype for x in floats if x.ndim] or [x.dtype for x in floats]
    result = types[0] if types else torch.get_default_dtype()
    for one in types[1:]:
        result = torch.promote_types(result, one)
    # Half precision has too few digits to compute with.
    computed = torch.float32 if torch.finfo(result).bits < 32 else result
    return result, computed, devices[0] if devices else torch.device("cpu")


def tensor(given: Any, dtype: Any, device: Any) -> Any:
    """A tensor; numbers and arrays are copied, so that what is kept for derivatives does not change."""
    if isinstance(given, torch.Tensor):
        return given.to(dtype=dtype, device=device)
    return torch.tensor(given, dtype=dtype, device=device)


def rest_arguments(name: str, given: Mapping[str, Any]) -> tuple[list[Any], Any]:
    """Numbers in tensors on the processor, whose axes fit, and the type of results."""
    result, computed, device = together(name, list(given.values()))
    if device.type != "cpu":
        raise ValueError(f"{name}: tensors must be on the processor, not on {device}")
    tensors = {key: tensor(x, computed, device) for key, x in given.items()}
    _arguments.axes_of(name, {key: tuple(x.shape) for key, x in tensors.items()})
    return list(tensors.values()), result
