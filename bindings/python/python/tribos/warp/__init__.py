"""Friction in Warp kernels."""

from tribos.warp._forms import DISK, HERTZ, PARABOLOID, PUNCH, RING
from tribos.warp._polygon import box_wrench, polygon_wrench
from tribos.warp._round import disk_wrench, round_wrench
from tribos.warp._project import disk_project, round_project
from tribos.warp._step import disk_planar_friction, round_planar_friction
from tribos.warp._manifold import manifold_friction, CURVE_AREA, CURVE_POINTS, CURVE_ELLIPSOID
from tribos.warp._shape import box_project, box_planar_friction, polygon_project, polygon_planar_friction
from tribos.warp._attach import attach, AttachedFeet

