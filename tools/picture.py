#!/usr/bin/python3
"""Draws one frame of a three-dimensional washer run, seen obliquely from above.

  tools/picture.py out/wash-3d wash.png [--frame 40] [--stress] [--azimuth -60] [--elevation 36]

Needs Debian's python3-h5py and python3-matplotlib; nothing else of Washtub does. Each piece of
cloth is the cubic surface through its nodes, in a colour of its own or coloured by its stress. The
agitator is drawn from the dimensions in case.toml, turned as in the frame; of the tub only floor
and far wall are shown. Surfaces are dense grids of points; the nearest in each pixel shows.
"""
import argparse
import tomllib
from pathlib import Path

import h5py
import numpy as np
from matplotlib import colormaps
from PIL import Image

WIDTH, HEIGHT = 1000, 620
FINE = 2  # pixels drawn per pixel saved, along each axis
POINTS = 640  # along an edge of a piece of cloth
PALETTE = [[.76, .27, .22], [.96, .74, .36], [.95, .92, .84], [.38, .63, .78],
           [.22, .36, .58], [.56, .73, .52], [.72, .55, .72], [.93, .58, .50]]
STEEL, FLOOR, WALL = np.array([[.86, .88, .91], [.90, .93, .96], [1.22, 1.28, 1.32]])
LIGHT = (-.30, -.25, .92)


def refine(v):
    """Cubic (Catmull-Rom) interpolation along the first axis, through all values."""
    n = POINTS // (len(v) - 1)
    v = np.concatenate([2 * v[:1] - v[1:2], v, 2 * v[-1:] - v[-2:-1]])
    a, b, c, d = v[:-3], v[1:-2], v[2:-1], v[3:]
    at = [b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * b - a - 3 * c + d)))
          for t in np.arange(n) / n]
    return np.concatenate([np.stack(at, axis=1).reshape(-1, *v.shape[1:]), v[-2:-1]])


def smooth(v):
    return refine(refine(v).swapaxes(0, 1)).swapaxes(0, 1)


def cloth(frame, by_stress):
    """Points [s, r, 3] of each piece, with its colour or the colour of each."""
    positions, stress = frame["cloth/positions"][:], frame["cloth/total"][:]
    for n, (first, along_r, along_s) in enumerate(frame["cloth/pieces"][:]):
        part = slice(first, first + along_r * along_s)
        value = smooth(stress[part].reshape(along_s, along_r, 1)) / np.percentile(stress, 98)
        by_value = colormaps["YlOrRd"](np.clip(value[..., 0], 0, 1))[..., :3]
        points = smooth(positions[part].reshape(along_s, along_r, 3))
        yield points, by_value if by_stress else np.array(PALETTE[n % len(PALETTE)])


def grid(x, y, z):
    return np.stack(np.broadcast_arrays(x, y, z), axis=2).astype(float)


def revolved(r, z, begin=0, end=2 * np.pi):
    turn = np.linspace(begin, end, 9 * POINTS)[:, None]
    return grid(r * np.cos(turn), r * np.sin(turn), z)


def agitator(a, angle):
    """Grids of the points of skirt, hub with cap, and fins."""
    t = np.linspace(0, 1, POINTS)
    hub, top, edge = a["hub_radius"], a["hub_height"], t[::20]
    skirt = np.array([[a["rim_radius"], a["rim_height"]],
                      [a["skirt_top_radius"], a["skirt_top_height"]]])
    yield revolved(skirt[0, 0] + 0 * edge, skirt[0, 1] * edge)
    yield revolved(*(skirt[0, :, None] + np.outer(skirt[1] - skirt[0], t)))
    yield revolved(hub + 0 * t, top * t)
    yield revolved(hub * np.cos(t * np.pi / 2), top + hub * np.sin(t * np.pi / 2))
    x, half = a["fin_radius"] * t[:, None], a["fin_half_thickness"]
    upper = np.interp(x, [hub, a["fin_radius"]], [a["fin_root_height"], a["fin_tip_height"]])
    across = (2 * t[::5] - 1) * half
    for k in range(int(a["fins"])):
        b = angle + 2 * np.pi * k / a["fins"]
        turn = [[np.cos(b), np.sin(b), 0], [-np.sin(b), np.cos(b), 0], [0, 0, 1]]
        for face in (grid(x, -half, upper * t), grid(x, half, upper * t), grid(x, across, upper),
                     grid(x[-1:], across, upper[-1] * t[:, None])):
            yield face @ turn


class Camera:
    """Looks along -view at a centre, where a metre is `scale` pixels; keeps the nearest heights."""

    def __init__(self, view, centre, scale, shape, distance=np.inf):
        right, self.shape, self.distance = np.cross([0, 0, 1], view), shape, distance
        right /= np.linalg.norm(right)
        self.axes, self.centre = np.stack([right, np.cross(view, right), view], axis=1), centre
        self.scale, self.nearest = scale, np.full(shape[0] * shape[1], -np.inf)

    def pixels(self, points):
        """Each point's pixel and its height towards the camera."""
        across, up, height = np.moveaxis((points - self.centre) @ self.axes, -1, 0)
        s = self.scale / (1 - height / self.distance)
        i = np.clip(self.shape[0] // 2 - np.rint(s * up), 0, self.shape[0] - 1).astype(int)
        j = np.clip(self.shape[1] // 2 + np.rint(s * across), 0, self.shape[1] - 1).astype(int)
        return i * self.shape[1] + j, height

    def see(self, points):
        at, height = self.pixels(points)
        np.maximum.at(self.nearest, at.ravel(), height.ravel())


def lit(sun, points, bias):
    """Share of the light that reaches each point: the mean over a patch of what the sun sees."""
    at, height = sun.pixels(points)
    steps = [di * sun.shape[1] + dj for di in range(-6, 7, 3) for dj in range(-6, 7, 3)]
    near = [sun.nearest[np.clip(at + step, 0, sun.nearest.size - 1)] for step in steps]
    return sum(n < height + bias for n in near)[..., None] / len(steps)


def draw(surfaces, options, radius, depth):
    a, e = np.radians([options.azimuth, options.elevation])
    view = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    back = revolved(radius, depth * np.linspace(0, 1, POINTS), a + np.pi / 2, a + 3 * np.pi / 2)
    floor = revolved(radius * np.linspace(0, 1, 3 * POINTS), 0)
    surfaces = [(back, WALL), (floor, FLOOR)] + surfaces
    shape, light = (FINE * HEIGHT, FINE * WIDTH), np.array(LIGHT) / np.linalg.norm(LIGHT)
    eye = Camera(view, [0, 0, .33 * depth], .35 * shape[1] / radius, shape, 6 * radius)
    sun = Camera(light, [0, 0, depth / 2], 260 / radius, (700, 700))
    for points, _ in surfaces:
        eye.see(points)
    for points, _ in surfaces[2:]:
        sun.see(points)
    image = np.ones((shape[0] * shape[1], 3))
    for points, colour in surfaces:
        at, height = eye.pixels(points)
        seen = height >= eye.nearest[at]
        normal = np.cross(np.gradient(points, axis=0), np.gradient(points, axis=1))[seen]
        normal /= np.linalg.norm(normal, axis=1, keepdims=True) + 1e-30
        normal *= np.where(normal @ view < 0, -1, 1)[:, None]
        direct = np.clip(normal @ light, 0, 1)[:, None] * lit(sun, points[seen], .03 * radius)
        bright = .60 + .08 * normal[:, 2:] + .36 * direct
        image[at[seen]] = np.clip(np.broadcast_to(colour, points.shape)[seen] * bright, 0, 1)
    fine = Image.fromarray((255 * image.reshape(*shape, 3)).astype(np.uint8))
    return fine.reduce(FINE)


def lengths(table):
    """The plain numbers of a table of case.toml, which has all lengths in m."""
    plain = {k: v for k, v in table.items() if not isinstance(v, dict)}
    return {k: float(str(v).split()[0]) for k, v in plain.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=Path)
    parser.add_argument("picture", type=Path)
    parser.add_argument("--frame", type=int, default=-1, help="number of the frame [the last]")
    parser.add_argument("--stress", action="store_true", help="colour the cloth by its stress")
    parser.add_argument("--azimuth", type=float, default=-60, help="[deg]")
    parser.add_argument("--elevation", type=float, default=36, help="[deg]")
    options = parser.parse_args()
    case = tomllib.loads((options.directory / "case.toml").read_text())
    if case["dimension"] != 3 or "washer" not in case:
        parser.error(f"{options.directory}: not a run of a three-dimensional [washer]")
    tub, stirrer = lengths(case["washer"]), lengths(case["washer"]["agitator"])
    path = sorted((options.directory / "frames").glob("*.h5"))[options.frame]
    with h5py.File(path) as frame:
        angle = frame.attrs["angle of agitator [rad]"]
        surfaces = [(part, STEEL) for part in agitator(stirrer, angle)]
        surfaces += list(cloth(frame, options.stress))
    drawn = draw(surfaces, options, tub["radius"], tub["depth"])
    drawn.save(options.picture, optimize=True)


if __name__ == "__main__":
    main()
