#!/usr/bin/env pvpython
"""Draws one moment of a run with ParaView: the cloth coloured by its stress, the solids, the speed
of the water on a plane through the middle, and the box.

  pvpython tools/paraview_picture.py DIR picture.png [--time 3.2] [--size 1280x960]
                                     [--stress total] [--largest 4e5] [--no-slice]

DIR is the output directory of `washtub run`. Without a display it starts itself under xvfb-run.
"""

import argparse
import os
import shutil
import sys

import numpy as np
from paraview import simple as pv
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy

SOLID = "solid fraction"
VELOCITY = "velocity [m/s]"


def arguments():
    about = "Draws one moment of a run: cloth, solids, speed of the water and box."
    parser = argparse.ArgumentParser(prog="paraview_picture.py", description=about)
    parser.add_argument("directory", metavar="DIR", help="output directory of washtub run")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("--time", type=float, help="[s], the nearest frame is drawn [the last one]")
    parser.add_argument("--size", default="1280x960", help="in pixels [1280x960]")
    parser.add_argument("--stress", choices=["membrane", "bending", "total"], default="total")
    parser.add_argument("--largest", type=float, help="end of the scale [Pa] [98 %% of nodes]")
    parser.add_argument("--no-slice", action="store_true", help="leave the water's speed out (3-D)")
    return parser.parse_args()


def ensure_display():
    """Lends a virtual display to a ParaView that draws through X, as Debian's does."""
    if os.environ.get("DISPLAY") or sys.platform != "linux":
        return
    xvfb = shutil.which("xvfb-run")
    if xvfb is None:
        sys.exit("paraview_picture.py: there is no display; install the packages xvfb and xauth")
    # A server that resets when its last client leaves would refuse the one that comes just then.
    server = "-screen 0 1280x1024x24 -nolisten tcp -noreset"
    os.execv(xvfb, [xvfb, "-a", "-s", server, "pvpython", os.path.abspath(__file__), *sys.argv[1:]])


def open_run(directory):
    """The reader of the run's frames."""
    index = os.path.abspath(os.path.join(directory, "frames.xdmf"))
    if not os.path.exists(index):
        sys.exit(f"paraview_picture.py: {index} is missing: is {directory} the output of a run?")
    return pv.XDMFReader(FileNames=[index])


def go_to(reader, asked):
    """Moves the view to the frame nearest to the time asked for [s]; returns its time."""
    times = np.atleast_1d(np.array(reader.TimestepValues, dtype=float))
    time = float(times[-1] if asked is None else times[np.argmin(abs(times - asked))])
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = time
    reader.UpdatePipeline(time)
    return time


def block(reader, name):
    """One mesh of the run, or None where the run has none of that name."""
    names = reader.GridStatus.Available
    if name not in names:
        return None
    extract = pv.ExtractBlock(Input=reader, Selectors=[f"/Root/{name}"])
    return pv.MergeBlocks(Input=extract, MergePoints=0) if name == "cloth" else extract


def show(source, view, **properties):
    """Shows a source with its own display properties."""
    display = pv.Show(source, view)
    for name, value in properties.items():
        setattr(display, name, value)
    return display


def rounded(largest):
    """A number of two figures for the end of a colour scale."""
    return float(f"{largest:.1e}") or 1.0


def add_legend(display, view, array, title, x):
    """A colour bar at the right edge, its left side at `x` (share of the view's width)."""
    table = pv.GetColorTransferFunction(array)
    bar = pv.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%g", "%g"
    bar.TitleFontSize, bar.LabelFontSize = 15, 13
    bar.WindowLocation, bar.Position = "Any Location", [x, 0.06]
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.36, 14
    display.SetScalarBarVisibility(view, True)


def show_cloth(cloth, view, stress, largest, dimension):
    """Pieces coloured by stress from 0 to `largest` [Pa]."""
    array = f"{stress} stress [Pa]"
    if largest is None:
        values = vtk_to_numpy(Fetch(cloth).GetPointData().GetArray(array))
        largest = rounded(np.percentile(values, 98))
    surface = cloth
    if dimension == 3:
        surface = pv.GenerateSurfaceNormals(Input=pv.ExtractSurface(Input=cloth), FeatureAngle=180)
    display = show(surface, view, Representation="Surface", LineWidth=5.0, Ambient=0.15)
    pv.ColorBy(display, ("POINTS", array))
    table = pv.GetColorTransferFunction(array)
    table.ApplyPreset("Plasma (matplotlib)", True)
    table.RescaleTransferFunction(0.0, largest)
    add_legend(display, view, array, array, 0.9)


def show_solids(fluid, view, dimension):
    """Surface where half of a cell is solid, seen from the water only, so that one looks into a
    tub; in plane cases the area within it."""
    points = pv.CellDatatoPointData(Input=fluid)
    if dimension == 2:
        solid = pv.Clip(Input=points, ClipType="Scalar", Scalars=["POINTS", SOLID], Value=0.5)
        solid.Invert = 0
    else:
        solid = pv.Contour(Input=points, ContourBy=["POINTS", SOLID], Isosurfaces=[0.5])
    display = show(solid, view, Representation="Surface", Ambient=0.15)
    display.DiffuseColor = [0.75, 0.78, 0.8]
    pv.ColorBy(display, None)
    if dimension == 2:
        display.Position = [0, 0, 1e-6]  # over the water
    else:
        display.BackfaceRepresentation = "Cull Backface"


def show_speed(fluid, view, dimension):
    """Speed of the water, on a vertical plane through the middle of the box in 3-D."""
    source = pv.CellDatatoPointData(Input=fluid)
    if dimension == 3:
        plane = pv.Slice(Input=source)
        plane.SliceType.Origin, plane.SliceType.Normal = middle(fluid), [0, 1, 0]
        source = pv.Clip(Input=plane, ClipType="Scalar", Scalars=["POINTS", SOLID], Value=0.5)
    display = show(source, view, Representation="Surface", Opacity=0.6 if dimension == 3 else 1.0)
    pv.ColorBy(display, ("POINTS", VELOCITY, "Magnitude"))
    table = pv.GetColorTransferFunction(VELOCITY)
    table.ApplyPreset("Linear Blue (8_31f)", True)
    table.RescaleTransferFunction(0.0, rounded(source.PointData[VELOCITY].GetRange(-1)[1]))
    add_legend(display, view, VELOCITY, "speed [m/s]", 0.02)


def bounds(fluid):
    """Lower and upper corner of the box [m]."""
    b = np.array(fluid.GetDataInformation().GetBounds())
    return b[0::2], b[1::2]


def middle(fluid):
    lower, upper = bounds(fluid)
    return list((lower + upper) / 2)


def is_plane(fluid):
    """Whether the run is a plane case: one layer of cells."""
    return Fetch(fluid).GetBlock(0).GetDimensions()[2] == 2


def place_camera(view, fluid, dimension):
    """Looks at the whole box: from above and in front in 3-D, straight down in 2-D."""
    lower, upper = bounds(fluid)
    centre, size = (lower + upper) / 2, float(np.linalg.norm(upper - lower))
    way = np.array([0.45, -1.0, 0.75]) if dimension == 3 else np.array([0, 0, 1.0])
    view.CameraFocalPoint = list(centre)
    view.CameraPosition = list(centre + way / np.linalg.norm(way) * 2 * size)
    view.CameraViewUp = [0, 0, 1] if dimension == 3 else [0, 1, 0]
    view.CameraParallelProjection = int(dimension == 2)
    pv.ResetCamera(view)
    pv.GetActiveCamera().Zoom(1.3 if dimension == 2 else 1.1)


def make_view(size):
    view = pv.CreateView("RenderView")
    view.ViewSize = size
    view.OrientationAxesVisibility = 0
    view.KeyLightElevation, view.FillLightKFRatio = 30, 1.5
    for name in ("UseColorPaletteForBackground", "BackgroundColorMode"):
        if name in view.ListProperties():
            setattr(view, name, 0 if name.startswith("Use") else "Single Color")
    view.Background = [1, 1, 1]
    return view


def write_time(view, time):
    label = show(pv.Text(Text=f"t = {time:.3f} s"), view, WindowLocation="Any Location")
    label.Position, label.Color, label.FontSize = [0.02, 0.94], [0.1, 0.1, 0.1], 18


def draw(options, size):
    """The view of the run at the time asked for."""
    reader = open_run(options.directory)
    time = go_to(reader, options.time)
    view = make_view(size)
    view.ViewTime = time
    fluid, cloth = block(reader, "fluid"), block(reader, "cloth")
    fluid.UpdatePipeline(time)
    dimension = 2 if is_plane(fluid) else 3
    show_solids(fluid, view, dimension)
    if dimension == 2 or not options.no_slice:
        show_speed(fluid, view, dimension)
    if cloth is not None:
        cloth.UpdatePipeline(time)
        show_cloth(cloth, view, options.stress, options.largest, dimension)
    outline = show(pv.Outline(Input=fluid), view, AmbientColor=[0.5, 0.5, 0.5])
    outline.DiffuseColor = [0.5, 0.5, 0.5]
    write_time(view, time)
    place_camera(view, fluid, dimension)
    return view


def main():
    options = arguments()
    ensure_display()
    try:
        size = [int(n) for n in options.size.split("x")]
        width, height = size
    except ValueError:
        sys.exit(f"paraview_picture.py: --size {options.size}: expected a size such as 1280x960")
    view = draw(options, [width, height])
    pv.SaveScreenshot(options.picture, view, ImageResolution=[width, height])
    print(options.picture)


if __name__ == "__main__":
    main()
