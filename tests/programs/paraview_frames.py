"""Opens the frames of a small run in ParaView as a user does and holds what its readers make of
them against the run's history.csv and against the turning of the agitator.

  pvpython paraview_frames.py DIR DIMENSION
"""

import csv
import os
import sys
import tomllib

import numpy as np
from paraview import simple as pv
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

CLOTH_NODES = {"membrane stress [Pa]", "bending stress [Pa]", "total stress [Pa]"}
FLUID_CELLS = {"velocity [m/s]", "pressure [Pa]", "solid fraction"}
FRAME_NUMBERS = {
    "angle of tub [rad]",
    "angle of agitator [rad]",
    "edges of cloth",
    "edges through other pieces",
    "edges through their own piece",
}


def read_history(path):
    """Columns of history.csv by name."""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    values = np.array(rows[1:], dtype=float)
    return {name: values[:, i] for i, name in enumerate(rows[0])}


def leaves(data, name=""):
    """Every mesh in what a reader gives, with its name."""
    if data.IsA("vtkDataSet"):
        return [(name, data)]
    found = []
    walk = data.NewIterator()
    walk.InitTraversal()
    while not walk.IsDoneWithTraversal():
        about = walk.GetCurrentMetaData()
        title = about.Get(vtkCompositeDataSet.NAME()) if about else None
        found.append((title or "", walk.GetCurrentDataObject()))
        walk.GoToNextItem()
    return found


def arrays(attributes):
    return {attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())}


def values(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name))


def meshes(reader, time):
    """Blocks of the run at `time` [s] by name."""
    reader.UpdatePipeline(time)
    return dict(leaves(Fetch(reader)))


def check_names(blocks):
    assert set(blocks) == {"fluid", "cloth"}, sorted(blocks)
    assert arrays(blocks["cloth"].GetPointData()) == CLOTH_NODES
    assert arrays(blocks["cloth"].GetCellData()) == {"piece"}
    assert arrays(blocks["fluid"].GetCellData()) == FLUID_CELLS
    assert arrays(blocks["fluid"].GetFieldData()) == FRAME_NUMBERS


def piece_means(cloth, nodal):
    """Means over the area of every piece; a cell's area counts for its corners alike."""
    piece = values(cloth.GetCellData(), "piece")
    total, count = np.zeros(piece.max() + 1), np.zeros(piece.max() + 1)
    for cell, number in enumerate(piece):
        corners = cloth.GetCell(cell).GetPointIds()
        for i in range(corners.GetNumberOfIds()):
            total[number] += nodal[corners.GetId(i)]
            count[number] += 1
    return total / count


def check_cloth(cloth, history, row):
    """Stresses and heights, averaged here, are those of history.csv."""
    for part in ("total", "membrane", "bending"):
        column = "stress" if part == "total" else f"{part} stress"
        nodal = values(cloth.GetPointData(), f"{part} stress [Pa]")
        mean, expected = piece_means(cloth, nodal).mean(), history[f"{column} [Pa]"][row]
        assert abs(mean - expected) < 1e-5 * abs(expected) + 1e-8, (part, mean, expected)
    height = vtk_to_numpy(cloth.GetPoints().GetData())[:, 2]
    if "cloth height [m]" in history:
        expected = history["cloth height [m]"][row]
        assert abs(piece_means(cloth, height).mean() - expected) < 1e-6, expected
    else:
        assert np.all(height == 0)


def cell_centres(fluid):
    """Coordinates of all cells, in the order of the arrays: x fastest [m]."""
    n = np.array(fluid.GetDimensions()) - 1
    origin, spacing = fluid.GetOrigin(), fluid.GetSpacing()
    axes = [o + (np.arange(m) + 0.5) * h for o, m, h in zip(origin, n, spacing)]
    z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    return np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)


def check_box(fluid, path):
    """The cells fill the box of case.toml."""
    with open(path, "rb") as file:
        domain = tomllib.load(file)["domain"]
    lower, size = ([float(text.split()[0]) for text in domain[key]] for key in ("lower", "size"))
    assert list(np.array(fluid.GetDimensions()) - 1)[: len(lower)] == domain["cells"]
    for i, (start, length) in enumerate(zip(lower, size)):
        assert np.allclose(fluid.GetBounds()[2 * i : 2 * i + 2], [start, start + length], atol=1e-9)


def speed_at(history, row):
    """Speed of the agitator at a sample [rad/s], from the mean speeds before and after it."""
    time, speed = history["time [s]"], history["agitator speed [rad/s]"]
    before, after = time[row] - time[row - 1], time[row + 1] - time[row]
    return (speed[row] * after + speed[row + 1] * before) / (before + after)


def check_agitator(fluid, history, row):
    """Cells in the agitator turn with it: this pins the order of axes and of components."""
    x, solid = cell_centres(fluid), values(fluid.GetCellData(), "solid fraction")
    u = values(fluid.GetCellData(), "velocity [m/s]")
    middle = (np.array(fluid.GetBounds()[0::2]) + np.array(fluid.GetBounds()[1::2])) / 2
    radius = np.hypot(x[:, 0] - middle[0], x[:, 1] - middle[1])
    size = fluid.GetBounds()[1] - fluid.GetBounds()[0]
    inside = (solid > 0.999) & (radius < 0.25 * size)
    speed = speed_at(history, row)
    expected = speed * np.stack([middle[1] - x[:, 1], x[:, 0] - middle[0], 0 * radius], axis=1)
    assert np.count_nonzero(inside) >= 4
    error = abs(u[inside] - expected[inside]).max()
    assert error < 5e-4 * abs(speed) * size, error
    angle = values(fluid.GetFieldData(), "angle of agitator [rad]")[0]
    assert abs(angle - history["agitator angle [rad]"][row]) < 1e-7


def check_vertical(fluid):
    """The agitator's skirt is wider at the floor than at the surface."""
    n = np.array(fluid.GetDimensions()) - 1
    solid = values(fluid.GetCellData(), "solid fraction").reshape(n[2], -1).sum(axis=1)
    assert solid[0] > solid[-1], solid


def check_times(reader, history):
    """Frames are at times of the history. Returns the rows of the history."""
    times = np.array(reader.TimestepValues)
    assert len(times) == 5, times
    rows = [int(np.argmin(abs(history["time [s]"] - time))) for time in times]
    assert np.allclose(history["time [s]"][rows], times, rtol=0, atol=1e-8), times
    return times, rows


def check_other_readers(directory, time, blocks):
    """The readers ParaView offers for frames.xdmf itself give the same meshes."""
    index = os.path.join(directory, "frames.xdmf")
    same = sorted((m.GetNumberOfCells(), *m.GetBounds()) for m in blocks.values())
    readers = [pv.XDMFReader(FileNames=[index])]
    readers += [pv.Xdmf3ReaderS(FileName=[index]), pv.Xdmf3ReaderT(FileName=[index])]
    for reader in readers:
        reader.UpdatePipeline(time)
        found = sorted((m.GetNumberOfCells(), *m.GetBounds()) for _, m in leaves(Fetch(reader)))
        assert np.allclose(found, same), (type(reader).__name__, found, same)


def main():
    directory, dimension = os.path.abspath(sys.argv[1]), int(sys.argv[2])
    history = read_history(os.path.join(directory, "history.csv"))
    reader = pv.OpenDataFile(os.path.join(directory, "paraview.xdmf2"))
    assert type(reader).__name__ == "XDMFReader", type(reader).__name__
    times, rows = check_times(reader, history)
    for time, row in zip(times[1:], rows[1:]):
        blocks = meshes(reader, time)
        check_names(blocks)
        check_box(blocks["fluid"], os.path.join(directory, "case.toml"))
        check_cloth(blocks["cloth"], history, row)
        if row + 1 < len(history["time [s]"]):
            check_agitator(blocks["fluid"], history, row)
    if dimension == 3:
        check_vertical(blocks["fluid"])
    check_other_readers(directory, times[-1], blocks)
    print(f"{len(times)} frames, blocks {' and '.join(sorted(blocks))}: as they should be")


if __name__ == "__main__":
    main()
