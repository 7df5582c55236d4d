"""Friction in Warp kernels."""

from tribos.warp._forms import DISK, HERTZ, PARABOLOID, PUNCH, RING
from tribos.warp._polygon import box_wrench, polygon_wrench
from tribos.warp._round import disk_wrench, round_wrench

__all__ = ["DISK", "HERTZ", "PARABOLOID", "PUNCH", "RING", "disk_wrench", "round_wrench", "box_wrench", "polygon_wrench"]
