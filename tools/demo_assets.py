#!/usr/bin/env python3
"""Make what scenes/demo.xml is made of: chess pieces and their board (PLY), and a photographer's
studio (OpenEXR); and the vase of scenes/gallery.

Run as `tools/demo_assets.py [FOLDER]` (default: scenes). Only Python's own library is needed; the
files are in the repository, so this runs only when someone wants other ones.
"""

import math
import os
import struct
import sys

from demo_studio import environment, write_exr

SEGMENTS = 48  # around the axis

# Chess pieces: profiles turned around the y axis.


def curve(points, steps):
    """A Catmull-Rom spline through (radius, height) points, as points with tangents."""
    first = [2 * a - b for a, b in zip(points[0], points[1])]
    last = [2 * a - b for a, b in zip(points[-1], points[-2])]
    p = [first] + [list(q) for q in points] + [last]
    out = []
    for i in range(1, len(p) - 2):
        for s in range(steps + (i == len(p) - 3)):
            t = s / steps
            place, tangent = [], []
            for a, b, c, d in zip(p[i - 1], p[i], p[i + 1], p[i + 2]):
                k1, k2, k3 = (c - a) / 2, a - 2.5 * b + 2 * c - d / 2, (d - a) / 2 + 1.5 * (b - c)
                place.append(b + t * (k1 + t * (k2 + t * k3)))
                tangent.append(k1 + t * (2 * k2 + 3 * t * k3))
            out.append((place, tangent))
    return out


def arc(height, radius, start, end, steps):
    """Part of a circle about (0, height): degrees from straight down, counter-clockwise."""
    out = []
    for s in range(steps + 1):
        a = math.radians(start + (end - start) * s / steps)
        out.append(
            (
                [max(radius * math.sin(a), 0.0), height - radius * math.cos(a)],
                [math.cos(a), math.sin(a)],
            )
        )
    return out


def foot(r):
    """Underside, base and bead, which all pieces share; r is the radius of the base."""
    return [
        curve([(0, 0), (0.94 * r, 0)], 1),
        curve([(0.94 * r, 0), (r, 0.025), (1.01 * r, 0.06), (0.95 * r, 0.10)], 3),
        curve([(0.95 * r, 0.10), (0.84 * r, 0.115)], 1),
        curve([(0.84 * r, 0.115), (0.88 * r, 0.14), (0.80 * r, 0.175)], 3),
    ]


def collar(r, height, width):
    """A ring that stands out from a stem of radius r."""
    return [
        curve([(r, height), (r + width, height + 0.02)], 2),
        curve(
            [
                (r + width, height + 0.02),
                (r + 1.08 * width, height + 0.035),
                (r + width, height + 0.05),
            ],
            3,
        ),
        curve([(r + width, height + 0.05), (r, height + 0.075)], 2),
    ]


def pawn():
    return (
        foot(0.34)
        + [curve([(0.272, 0.175), (0.19, 0.26), (0.125, 0.42), (0.10, 0.60)], 5)]
        + collar(0.10, 0.60, 0.105)
        + [arc(0.825, 0.178, 34.2, 180, 16)]
    )


def bishop():
    return (
        foot(0.36)
        + [curve([(0.288, 0.175), (0.20, 0.30), (0.13, 0.55), (0.105, 0.86)], 6)]
        + collar(0.105, 0.86, 0.10)
        + collar(0.105, 0.935, 0.06)
        + [
            curve([(0.105, 1.01), (0.17, 1.10), (0.175, 1.18), (0.13, 1.32), (0.045, 1.44)], 4),
            arc(1.478, 0.058, 51, 180, 8),
        ]
    )


def queen():
    return (
        foot(0.40)
        + [curve([(0.32, 0.175), (0.22, 0.32), (0.145, 0.62), (0.115, 1.10)], 6)]
        + collar(0.115, 1.10, 0.12)
        + collar(0.115, 1.175, 0.07)
        + [
            curve([(0.115, 1.25), (0.13, 1.34), (0.17, 1.46), (0.235, 1.56)], 4),
            curve([(0.235, 1.56), (0.225, 1.585), (0.20, 1.585)], 2),
            curve([(0.20, 1.585), (0.13, 1.65), (0.045, 1.685)], 4),
            arc(1.735, 0.066, 43, 180, 8),
        ]
    )


def vase():
    """Thrown on a wheel: belly, neck, lip, and the inside as far as one can look."""
    return [
        curve([(0, 0), (0.34, 0)], 1),
        curve([(0.34, 0), (0.37, 0.03), (0.36, 0.07)], 3),
        curve(
            [
                (0.36, 0.07),
                (0.52, 0.30),
                (0.66, 0.62),
                (0.64, 0.92),
                (0.46, 1.20),
                (0.30, 1.42),
                (0.28, 1.60),
                (0.36, 1.78),
            ],
            6,
        ),
        curve([(0.36, 1.78), (0.375, 1.80), (0.355, 1.805)], 3),
        curve([(0.355, 1.805), (0.27, 1.62), (0.28, 1.42), (0.42, 1.20)], 4),
    ]


def revolve(strokes):
    """Vertices (position, normal, uv) and triangles; smooth along a stroke, sharp between two."""
    vertices, triangles = [], []
    total = sum(math.dist(a[0], b[0]) for s in strokes for a, b in zip(s, s[1:]))
    length = 0.0
    for stroke in strokes:
        rings = []
        for i, ((r, y), (dr, dy)) in enumerate(stroke):
            if i > 0:
                length += math.dist(stroke[i - 1][0], (r, y))
            scale = math.hypot(dr, dy)
            nr, ny = dy / scale, -dr / scale  # to the right of the way up: outwards
            rings.append((len(vertices), r < 1e-9))
            for s in range(SEGMENTS + 1):
                a = 2 * math.pi * (s % SEGMENTS) / SEGMENTS
                c, n = math.cos(a), -math.sin(a)
                vertices.append((r * c, y, r * n, nr * c, ny, nr * n, s / SEGMENTS, length / total))
        for (low, low_pole), (high, high_pole) in zip(rings, rings[1:]):
            for s in range(SEGMENTS):
                if not low_pole:
                    triangles.append((low + s, low + s + 1, high + s))
                if not high_pole:
                    triangles.append((low + s + 1, high + s + 1, high + s))
    return vertices, triangles


def board(parity):
    """The dark (0) or light (1) squares of a chess board, each 1 x 1, centred on the origin."""
    vertices, triangles = [], []
    for x in range(-4, 4):
        for z in range(-4, 4):
            if (x + z) % 2 == parity:
                n = len(vertices)
                for du, dv in ((0, 0), (0, 1), (1, 1), (1, 0)):
                    vertices.append((x + du, 0, z + dv, 0, 1, 0, du, dv))
                triangles += [(n, n + 1, n + 2), (n, n + 2, n + 3)]
    return vertices, triangles


def write_ply(path, vertices, triangles):
    names = ("x", "y", "z", "nx", "ny", "nz", "u", "v")
    header = ["ply", "format binary_little_endian 1.0", "element vertex %d" % len(vertices)]
    header += ["property float " + name for name in names]
    header += ["element face %d" % len(triangles)]
    header += ["property list uchar ushort vertex_indices", "end_header", ""]
    with open(path, "wb") as file:
        file.write("\n".join(header).encode())
        for vertex in vertices:
            file.write(struct.pack("<8f", *vertex))
        for triangle in triangles:
            file.write(struct.pack("<B3H", 3, *triangle))


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else "scenes"
    for name, piece in (("pawn", pawn), ("bishop", bishop), ("queen", queen)):
        write_ply(os.path.join(folder, name + ".ply"), *revolve(piece()))
    write_ply(os.path.join(folder, "gallery", "vase.ply"), *revolve(vase()))
    for parity, name in enumerate(("squares_dark", "squares_light")):
        write_ply(os.path.join(folder, name + ".ply"), *board(parity))
    write_exr(os.path.join(folder, "studio.exr"), environment(512, 256))


main()
