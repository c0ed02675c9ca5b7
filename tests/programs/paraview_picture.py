"""Whether a picture shows something: many colours, neither blank nor full.

  pvpython paraview_picture.py PICTURE.png
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def main():
    reader = vtkPNGReader()
    reader.SetFileName(sys.argv[1])
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3]
    colours = len(np.unique(pixels, axis=0))
    drawn = np.mean(np.any(pixels < 250, axis=1))
    assert colours > 500, f"{colours} colours"
    assert 0.05 < drawn < 0.95, f"{100 * drawn:.0f} % of the picture is drawn on"
    print(f"{sys.argv[1]}: {colours} colours, {100 * drawn:.0f} % drawn on")


if __name__ == "__main__":
    main()
