"""Friction in Warp kernels."""

from tribos.warp._forms import DISK, HERTZ, PARABOLOID, PUNCH, RING
from tribos.warp._polygon import box_wrench, polygon_wrench
from tribos.warp._round import disk_wrench, round_wrench
from tribos.warp._project import disk_project, round_project
from tribos.warp._step import disk_planar_friction, round_planar_friction
from tribos.warp._shape import box_project, box_planar_friction, polygon_project, polygon_planar_friction

__all__ = ["DISK", "HERTZ", "PARABOLOID", "PUNCH", "RING", "disk_wrench", "round_wrench", "box_wrench", "polygon_wrench", "disk_project", "round_project",
"disk_planar_friction", "round_planar_friction", "box_project", "box_planar_friction", "polygon_project", "polygon_planar_friction"]
