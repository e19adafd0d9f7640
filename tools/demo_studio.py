"""The studio of scenes/demo.xml: soft boxes in a dark room, as an OpenEXR map; for demo_assets.py."""

import math
import struct
import zlib


def box(direction, towards, up, half_width, half_height, softness):
    """1 where a direction meets a soft box that faces the origin, falling to 0 around it."""

    def dot(a, b):
        return sum(x * y for x, y in zip(a, b))

    def unit(a):
        n = math.sqrt(dot(a, a))
        return [x / n for x in a]

    w = unit(towards)
    u = unit([up[1] * w[2] - up[2] * w[1], up[2] * w[0] - up[0] * w[2], up[0] * w[1] - up[1] * w[0]])
    v = [w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]]
    z = dot(direction, w)
    if z <= 0.0:
        return 0.0
    value = 1.0
    for axis, half in ((u, half_width), (v, half_height)):
        t = (half + softness - abs(dot(direction, axis) / z)) / softness
        t = min(max(t, 0.0), 1.0)
        value *= t * t * (3.0 - 2.0 * t)
    return value


def studio(direction):
    """Radiance from a direction; y is up, the camera looks along -z."""
    y = direction[1]
    sky = max(y, 0.0)
    ground = max(-y, 0.0)
    color = [
        0.030 + 0.060 * sky - 0.015 * ground,
        0.034 + 0.075 * sky - 0.017 * ground,
        0.045 + 0.105 * sky - 0.022 * ground,
    ]
    lights = (
        # towards, up, half width and height (tangents), softness, radiance
        ((0.95, 0.40, -0.45), (0, 1, 0), 0.10, 0.60, 0.05, (3.0, 4.2, 6.4)),  # strip, right
        ((-0.30, 0.55, -0.95), (0, 1, 0), 0.60, 0.10, 0.05, (3.6, 3.2, 2.8)),  # rim, behind
        ((0.50, 0.35, 1.00), (0, 1, 0), 0.26, 0.20, 0.12, (0.9, 0.9, 1.0)),  # fill, front
    )
    for towards, up, half_width, half_height, softness, radiance in lights:
        weight = box(direction, towards, up, half_width, half_height, softness)
        color = [c + weight * r for c, r in zip(color, radiance)]
    return color


def environment(width, height):
    """Rows of (r, g, b), in the mapping of Mitsuba 3: column centres, rows from pole to pole."""
    rows = []
    for j in range(height):
        theta = math.pi * j / (height - 1)
        row = []
        for i in range(width):
            phi = 2 * math.pi * (i + 0.5) / width
            row.append(
                studio(
                    (
                        math.sin(phi) * math.sin(theta),
                        math.cos(theta),
                        -math.cos(phi) * math.sin(theta),
                    )
                )
            )
        rows.append(row)
    return rows


def write_exr(path, rows):
    """Scan lines of halves with ZIP compression, 16 lines a chunk (openexr.com, file layout)."""
    height, width = len(rows), len(rows[0])

    def attribute(name, kind, data):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data

    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(n + b"\0" + struct.pack("<iB3xii", 1, 0, 1, 1) for n in (b"B", b"G", b"R"))
    header = struct.pack("<ii", 20000630, 2)
    header += attribute("channels", "chlist", channels + b"\0")
    header += attribute("compression", "compression", b"\3")
    header += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window)
    header += attribute("lineOrder", "lineOrder", b"\0")
    header += attribute("pixelAspectRatio", "float", struct.pack("<f", 1.0))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0.0, 0.0))
    header += attribute("screenWindowWidth", "float", struct.pack("<f", 1.0)) + b"\0"
    chunks = []
    for y in range(0, height, 16):
        raw = b"".join(
            struct.pack("<%de" % width, *(pixel[c] for pixel in row))
            for row in rows[y : y + 16]
            for c in (2, 1, 0)
        )
        data = raw[0::2] + raw[1::2]
        data = data[:1] + bytes((b - a + 128) & 255 for a, b in zip(data, data[1:]))
        packed = zlib.compress(data, 9)
        packed = packed if len(packed) < len(raw) else raw
        chunks.append(struct.pack("<ii", y, len(packed)) + packed)
    offset = len(header) + 8 * len(chunks)
    with open(path, "wb") as file:
        file.write(header)
        for chunk in chunks:
            file.write(struct.pack("<Q", offset))
            offset += len(chunk)
        file.write(b"".join(chunks))
