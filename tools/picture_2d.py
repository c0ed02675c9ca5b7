#!/usr/bin/python3
"""Draws frames of two-dimensional runs: a row for each run, cloth over the speed of the water.

  tools/picture_2d.py wash.png out/stiff out/soft --frames 9 11 13 15 [--labels "Be 1.9e-5" ...]

Needs Debian's python3-h5py and python3-matplotlib; nothing else of Washtub does.
"""
import argparse
import tomllib
from pathlib import Path

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def metres(text):
    value, unit = text.split()
    assert unit == "m", text  # the resolved case is in SI
    return float(value)


def box(directory):
    """Extent of the domain as [left, right, lower, upper] in m."""
    domain = tomllib.loads((directory / "case.toml").read_text())["domain"]
    x, y = (metres(v) for v in domain["lower"][:2])
    return [x, x + metres(domain["size"][0]), y, y + metres(domain["size"][1])]


def threads(frame):
    positions = frame["cloth/positions"][:]
    for first, along_r, along_s in frame["cloth/pieces"][:]:
        yield positions[first:first + along_r * along_s, :2]


def draw(axes, directory, number, top_speed):
    with h5py.File(directory / "frames" / f"frame_{number:06d}.h5") as frame:
        speed = np.linalg.norm(frame["fluid/velocity"][0], axis=-1)
        solid = frame["fluid/solid"][0] > 0.5
        extent, time = box(directory), frame.attrs["time [s]"]
        axes.imshow(np.where(solid, np.nan, speed), origin="lower", extent=extent, cmap="Blues",
                    vmin=0, vmax=top_speed)
        for n, points in enumerate(threads(frame)):
            axes.plot(*points.T, color=pyplot.cm.Dark2(n % 8), linewidth=1.4)
    axes.set_facecolor(".55")
    axes.set(xticks=[], yticks=[], title=f"{time:.2f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("picture", type=Path)
    parser.add_argument("runs", type=Path, nargs="+")
    parser.add_argument("--frames", type=int, nargs="+", default=[0])
    parser.add_argument("--labels", nargs="+")
    parser.add_argument("--speed", type=float, default=2.5, help="of the darkest blue [m/s]")
    arguments = parser.parse_args()
    rows, columns = len(arguments.runs), len(arguments.frames)
    figure, grid = pyplot.subplots(rows, columns, figsize=(2.6 * columns, 2.75 * rows),
                                   squeeze=False, layout="constrained")
    for row, run in enumerate(arguments.runs):
        for column, number in enumerate(arguments.frames):
            draw(grid[row, column], run, number, arguments.speed)
        grid[row, 0].set_ylabel((arguments.labels or [r.name for r in arguments.runs])[row])
    figure.savefig(arguments.picture, dpi=80)


main()
