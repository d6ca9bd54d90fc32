# Reads an 8-bit grey PNG without any library but zlib, independent of what wrote it.
import struct
import zlib


def read_grey_png(path):
    """width, height, rows of bytes"""
    data = open(path, "rb").read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        chunk = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", chunk[:10])
            assert (depth, color) == (8, 0), "not 8-bit grey"
        if kind == b"IDAT":
            packed += chunk
        at += 12 + length
    return width, height, unfiltered(zlib.decompress(packed), width, height)


def unfiltered(data, width, height):
    """Undo PNG's filters, one byte a pixel (PNG specification, section 9)."""
    rows, above = [], bytearray(width)
    for y in range(height):
        line = data[y * (width + 1):(y + 1) * (width + 1)]
        kind, row = line[0], bytearray(line[1:])
        for x in range(width):
            a, b, c = (row[x - 1] if x else 0), above[x], (above[x - 1] if x else 0)
            row[x] = (row[x] + (0, a, b, (a + b) // 2, paeth(a, b, c))[kind]) & 255
        rows.append(row)
        above = row
    return rows


def paeth(a, b, c):
    p = a + b - c
    return min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
