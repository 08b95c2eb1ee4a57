#!/usr/bin/env python3
"""Writes a small capture without any code of Gridscope: an example to copy for a grid of your own.

    python3 captures/write_foreign.py OUT.gridcap [--reserved 0|1|2]

What a foreign capture needs is geometry, a grid and rays; captures/FORMAT.md describes every entry. This program makes all three from nothing: a
tetrahedron above a floor, a grid that a simple test of bounding boxes fills, and a picture of parallel rays that look down. numpy and the
standard library are all it takes.
"""

import argparse
import io
import json
import zipfile

import numpy as np

BLANK = 0xFFFFFFFF  # a slot without a reference


def make_triangles():
    """World-space triangles, (n, 3 corners, xyz), float32. With no `instances` entry they are one instance, number 0."""
    floor = [[(0, 0, 0), (4, 0, 0), (4, 0, 4)], [(0, 0, 0), (4, 0, 4), (0, 0, 4)]]
    a, b, c, top = (1, 0.5, 1), (3, 0.5, 1), (2, 0.5, 3), (2, 2.5, 1.75)
    return np.array(floor + [[a, b, c], [a, b, top], [b, c, top], [c, a, top]], dtype="<f4")


def make_grid(triangles, origin, cell_edge, cells, capacity, reserved):
    """The grid's texels, uint32, in the axis order (z, y, x), the x axis stretched.

    Cell (i, j, k) owns texels x = i * stride ... i * stride + stride - 1 of row [k, j]: first its `capacity` slots, filled from the front,
    then the reserved texels. A reference is instance * 65536 + triangle of that instance.
    """
    stride = capacity + reserved
    grid = np.full((cells[2], cells[1], cells[0] * stride), BLANK, dtype="<u4")
    refused = np.zeros((cells[2], cells[1], cells[0]), dtype="<u4")
    for number, triangle in enumerate(triangles):
        # Our overlap test: the bounding box. Put your own here.
        low = np.clip(np.floor((triangle.min(axis=0) - origin) / cell_edge).astype(int), 0, np.array(cells) - 1)
        high = np.clip(np.floor((triangle.max(axis=0) - origin) / cell_edge).astype(int), 0, np.array(cells) - 1)
        for k in range(low[2], high[2] + 1):
            for j in range(low[1], high[1] + 1):
                for i in range(low[0], high[0] + 1):
                    slots = grid[k, j, i * stride:i * stride + capacity]
                    free = np.flatnonzero(slots == BLANK)
                    if len(free):
                        slots[free[0]] = 0 << 16 | number
                    else:
                        refused[k, j, i] += 1

    # Reserved texels. 2: static and dynamic references refused; 1: a flag, not 0 where the cell refused one; 0: there are none.
    if reserved == 2:
        grid[:, :, capacity::stride] = refused
        grid[:, :, capacity + 1::stride] = 0
    if reserved == 1:
        grid[:, :, capacity::stride] = refused != 0
    return grid


def make_rays(width, height):
    """A picture of rays that start above the scene and look down, slightly askew: (height, width, xyz), first row at the top."""
    x, z = np.meshgrid(np.linspace(0.05, 3.95, width), np.linspace(3.95, 0.05, height))
    origin = np.stack([x, np.full_like(x, 3.5), z], axis=-1).astype("<f4")
    direction = np.broadcast_to(np.array([0.1, -1.0, 0.05]), origin.shape).copy()
    direction /= np.linalg.norm(direction, axis=-1, keepdims=True)  # of length 1: a ray parameter is a distance
    return origin, direction.astype("<f4")


def write_capture(path, manifest, arrays):
    """Writes a ZIP file of manifest.json and NAME.npy for each array; the manifest lists every array's type and shape."""
    manifest["entries"] = {name + ".npy": {"dtype": array.dtype.str, "shape": list(array.shape)} for name, array in arrays.items()}
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("manifest.json", json.dumps(manifest, indent=1))
        for name, array in arrays.items():
            data = io.BytesIO()
            np.save(data, np.ascontiguousarray(array), allow_pickle=False)
            archive.writestr(name + ".npy", data.getvalue())


def main():
    parser = argparse.ArgumentParser(description="Write a small foreign capture.")
    parser.add_argument("out", help="the .gridcap file to write")
    parser.add_argument("--reserved", type=int, choices=(0, 1, 2), default=2, help="reserved texels of a cell")
    options = parser.parse_args()

    origin, cell_edge, cells, capacity = np.array([-0.5, -0.5, -0.5]), 0.5, (10, 8, 10), 4
    triangles = make_triangles()
    ray_origin, ray_direction = make_rays(32, 24)

    # The grid's shape is all that the manifest must say. Everything else has a default: see FORMAT.md.
    manifest = {
        "format": "gridscope capture",
        "version": 1,
        "writer": "write_foreign.py",
        "note": "a grid made in Python",
        "grid": {
            "origin": origin.tolist(),       # low corner of cell (0, 0, 0), world space
            "cellEdge": cell_edge,           # world units
            "cellCount": list(cells),        # x, y, z
            "capacity": capacity,            # slots of a cell
            "reserved": options.reserved,    # texels behind them
            "stretchAxis": "x",              # the axis along which a cell's slots lie
        },
    }
    arrays = {
        "triangles": triangles,
        "grid": make_grid(triangles, origin, cell_edge, cells, capacity, options.reserved),
        "rays_origin": ray_origin,
        "rays_direction": ray_direction,
    }
    write_capture(options.out, manifest, arrays)


if __name__ == "__main__":
    main()
