"""Writes the files of this folder by VTK 9: two spheres with the arrays of four programs, in VTK's modes.

pip install vtk; python generate.py
"""

from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

HERE = Path(__file__).parent
POSITIONS = [[0.5, 0.5, 0.5], [1.5, 0.5, 0.75]]
RADII = np.array([0.5, 0.25])
VELOCITIES = np.array([[1.0, 0, 0], [0, -0.5, 0]])
SPINS = np.array([[0, 0, 2.0], [0, 1, 0]])
DENSITIES = np.array([2000.0, 3000.0])
TYPES = np.array([0, 1], np.int32)
ARRAYS = {
    "mercury": {"Velocity": VELOCITIES, "AngularVelocity": SPINS, "Radius": RADII, "speciesType": TYPES},
    "yade": {"radii": RADII, "linVelVec": VELOCITIES, "angVelVec": SPINS, "materialId": TYPES},
    "lethe": {"Type": TYPES.astype(float), "Diameter": 2 * RADII, "Velocity": VELOCITIES, "Omega": SPINS},
    "liggghts": {
        "type": TYPES + 1,
        "v": VELOCITIES,
        "radius": RADII.astype(np.float32),
        "omega": SPINS,
        "density": DENSITIES,
    },
}


def spheres(program, is_grid):
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    cells = vtk.vtkCellArray()
    for at, position in enumerate(POSITIONS):
        points.InsertNextPoint(*position)
        cells.InsertNextCell(1)
        cells.InsertCellPoint(at)
    made = vtk.vtkUnstructuredGrid() if is_grid else vtk.vtkPolyData()
    made.SetPoints(points)
    made.SetCells(vtk.VTK_VERTEX, cells) if is_grid else made.SetVerts(cells)
    for name, values in ARRAYS[program].items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
        array.SetName(name)
        made.GetPointData().AddArray(array)
    return made


def xml(name, mode, header=32, is_big=False):
    is_grid = name.endswith("vtu")
    writer = vtk.vtkXMLUnstructuredGridWriter() if is_grid else vtk.vtkXMLPolyDataWriter()
    writer.SetInputData(spheres(name.split("-")[0].split(".")[0], is_grid))
    writer.SetFileName(str(HERE / name))
    writer.SetHeaderTypeToUInt64() if header == 64 else writer.SetHeaderTypeToUInt32()
    writer.SetByteOrderToBigEndian() if is_big else writer.SetByteOrderToLittleEndian()
    if "ascii" in mode:
        writer.SetDataModeToAscii()
    elif "inline" in mode:
        writer.SetDataModeToBinary()
    else:
        writer.SetDataModeToAppended()
    writer.SetEncodeAppendedData(1 if "base64" in mode else 0)
    if "zlib" in mode:
        writer.SetCompressorTypeToZLib()
        # Several blocks an array.
        writer.SetBlockSize(32)
    else:
        writer.SetCompressorTypeToNone()
    writer.Write()


def legacy(name, is_binary, version, is_grid):
    writer = vtk.vtkUnstructuredGridWriter() if is_grid else vtk.vtkPolyDataWriter()
    writer.SetInputData(spheres(name.split("-")[0], is_grid))
    writer.SetFileName(str(HERE / name))
    writer.SetFileTypeToBinary() if is_binary else writer.SetFileTypeToASCII()
    writer.SetFileVersion(version)
    writer.Write()


xml("mercury.vtu", "ascii", 64)
xml("yade-inline-zlib.vtu", "inline zlib", 64)
xml("yade-appended-raw.vtu", "raw")
xml("lethe-appended-base64-zlib.vtu", "base64 zlib")
xml("lethe-appended-raw-zlib.vtu", "raw zlib", 64)
xml("liggghts-appended-base64.vtp", "base64", 64)
xml("liggghts-big-endian.vtp", "inline", is_big=True)
legacy("liggghts-ascii.vtk", False, 42, False)
legacy("liggghts-binary.vtk", True, 51, False)
legacy("lethe-binary.vtk", True, 42, True)
