#!/usr/bin/env python3
"""Make the picture that scenes/textures.xml sets a roughness with: fingerprints on polished metal.

Run as `tools/texture_assets.py [FOLDER]` (default: scenes). Only Python's own library is needed; the
file is in the repository, so this runs only when someone wants another one.
"""

import math
import os
import random
import struct
import sys
import zlib

WIDTH, HEIGHT = 1024, 512  # the whole of a sphere: twice around as pole to pole
CLEAN = 0.03  # alpha, as all numbers here
GREASE = 0.26
SCRATCH = 0.14


def write_gray_png(path, rows):
    """Rows of bytes, 8 bits a pixel."""

    def chunk(name, data):
        body = name + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    lines = b"".join(b"\0" + bytes(row) for row in rows)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        file.write(chunk(b"IHDR", header))
        file.write(chunk(b"IDAT", zlib.compress(lines, 9)))
        file.write(chunk(b"IEND", b""))


def fade(t):
    t = min(max(t, 0.0), 1.0)
    return t * t * (3 - 2 * t)


class Print:
    """A fingertip: ridges around a core, as far as the skin touched."""

    def __init__(self, dice, x, y):
        self.x, self.y = x, y
        self.turn = dice.uniform(-0.7, 0.7)
        self.size = dice.uniform(50, 64)  # half its width, in pixels at the equator
        self.pressure = dice.uniform(0.55, 1.0)
        self.wave = [dice.uniform(0, 2 * math.pi) for _ in range(3)]

    def at(self, x, y):
        stretch = math.sin(math.pi * (self.y + 0.5) / HEIGHT)
        dx = (x - self.x + WIDTH / 2) % WIDTH - WIDTH / 2
        dx *= stretch
        dy = y - self.y
        c, s = math.cos(self.turn), math.sin(self.turn)
        u, v = (c * dx + s * dy) / self.size, (c * dy - s * dx) / (1.35 * self.size)
        rim = math.hypot(u, v)
        if rim >= 1:
            return 0.0
        # Loops above the core, flatter arches below; a little wavy, as skin is.
        core = math.hypot(u * 1.15, (v + 0.15) * (0.75 if v < -0.15 else 0.5))
        wavy = 0.25 * math.sin(5 * u + self.wave[0]) + 0.3 * math.sin(4 * v + self.wave[1])
        phase = 8.5 * core + wavy
        ridge = fade(0.5 + 0.9 * math.sin(2 * math.pi * phase * 0.85))
        touch = fade((1 - rim) / 0.35) * (0.8 + 0.2 * math.sin(3 * u - 2 * v + self.wave[2]))
        return ridge * touch * self.pressure


def scratch_line(dice, rows):
    """A fine arc, as polishing leaves."""
    x, y = dice.uniform(0, WIDTH), dice.uniform(0.2 * HEIGHT, 0.8 * HEIGHT)
    angle, bend = dice.uniform(0, 2 * math.pi), dice.uniform(-0.008, 0.008)
    depth = dice.uniform(0.3, 1.0)
    for _ in range(dice.randint(40, 160)):
        x, y, angle = x + math.cos(angle), y + math.sin(angle), angle + bend
        if 0 <= y < HEIGHT:
            row, column = rows[int(y)], int(x) % WIDTH
            row[column] = max(row[column], CLEAN + depth * (SCRATCH - CLEAN))


def fingerprints(seed):
    dice = random.Random(seed)
    rows = [[CLEAN] * WIDTH for _ in range(HEIGHT)]
    for _ in range(90):
        scratch_line(dice, rows)
    for i in range(10):
        x = WIDTH * (i + dice.uniform(0.1, 0.9)) / 10
        tip = Print(dice, x, dice.uniform(0.28, 0.74) * HEIGHT)
        reach = int(1.4 * tip.size) + 2
        wide = int(reach / math.sin(math.pi * (tip.y + 0.5) / HEIGHT)) + 2
        for y in range(int(tip.y) - reach, int(tip.y) + reach):
            for column in range(int(x) - wide, int(x) + wide):
                grease = CLEAN + (GREASE - CLEAN) * tip.at(column % WIDTH, y)
                rows[y][column % WIDTH] = max(rows[y][column % WIDTH], grease)
    return [[round(255 * value) for value in row] for row in rows]


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else "scenes"
    path = os.path.join(folder, "fingerprints.png")
    write_gray_png(path, fingerprints(7))
    print(path)


if __name__ == "__main__":
    main()
