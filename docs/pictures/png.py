"""PNG pictures of eight bits for each channel, read and written with the standard library alone; moving ones (APNG) too."""

import struct
import zlib
from dataclasses import dataclass

SIGNATURE = b"\x89PNG\r\n\x1a\n"


@dataclass(frozen=True)
class Picture:
    width: int
    height: int
    rows: tuple  # Bytes of each row, three for each pixel: red, green, blue.


def chunks(data):
    place = len(SIGNATURE)
    while place < len(data):
        (length,) = struct.unpack(">I", data[place : place + 4])
        yield data[place + 4 : place + 8], data[place + 8 : place + 8 + length]
        place += length + 12


def unfiltered(kind, row, before, step):
    """A row as it was before its filter; `before` is the row above."""
    row = bytearray(row)
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        above = before[i]
        corner = before[i - step] if i >= step else 0
        if kind == 1:
            row[i] = (row[i] + left) & 255
        elif kind == 2:
            row[i] = (row[i] + above) & 255
        elif kind == 3:
            row[i] = (row[i] + (left + above) // 2) & 255
        elif kind == 4:
            guess = left + above - corner
            nearest = min((abs(guess - left), 0, left), (abs(guess - above), 1, above), (abs(guess - corner), 2, corner))
            row[i] = (row[i] + nearest[2]) & 255
    return bytes(row)


def read(path):
    data = open(path, "rb").read()
    parts = list(chunks(data))
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    if depth != 8 or colour not in (2, 6) or interlaced:
        raise ValueError(f"{path}: a PNG of eight bits for each channel in red, green and blue is read here, no other")
    step = 4 if colour == 6 else 3
    raw = zlib.decompress(b"".join(body for name, body in parts if name == b"IDAT"))
    stride = width * step
    before, rows = bytes(stride), []
    for y in range(height):
        begin = y * (stride + 1)
        kind, row = raw[begin], raw[begin + 1 : begin + 1 + stride]
        before = unfiltered(kind, row, before, step) if kind else row
        rows.append(before if step == 3 else b"".join(before[i : i + 3] for i in range(0, stride, 4)))
    return Picture(width, height, tuple(rows))


def cropped(picture, x, y, width, height):
    return Picture(width, height, tuple(row[3 * x : 3 * (x + width)] for row in picture.rows[y : y + height]))


def still(picture):
    """The bytes of a PNG; each row is kept as what differs from the one above."""
    before, rows = bytes(3 * picture.width), []
    for row in picture.rows:
        rows.append(b"\2" + bytes((value - above) & 255 for value, above in zip(row, before)))
        before = row
    head = chunk(b"IHDR", struct.pack(">IIBBBBB", picture.width, picture.height, 8, 2, 0, 0, 0))
    return SIGNATURE + head + chunk(b"IDAT", zlib.compress(b"".join(rows), 9)) + chunk(b"IEND", b"")


def beside(left, right):
    """Two pictures of one height as one."""
    return Picture(left.width + right.width, left.height, tuple(a + b for a, b in zip(left.rows, right.rows)))


def chunk(name, body):
    return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))


def palette_of(pictures, count):
    """The colours that are most in use, of those that differ in the upper six bits of a channel."""
    uses = {}
    for picture in pictures:
        for row in picture.rows:
            coarse = bytes(value & 0xFC for value in row)
            for i in range(0, len(coarse), 3):
                colour = coarse[i : i + 3]
                uses[colour] = uses.get(colour, 0) + 1
    return sorted(uses, key=lambda colour: (-uses[colour], colour))[:count]


class Nearest:
    """The nearest colour of a palette, by its index."""

    def __init__(self, palette):
        self.palette = palette
        self.known = {colour: index for index, colour in enumerate(palette)}

    def index(self, colour):
        found = self.known.get(colour)
        if found is None:
            found = min(range(len(self.palette)), key=lambda i: sum((a - b) ** 2 for a, b in zip(self.palette[i], colour)))
            self.known[colour] = found
        return found

    def row(self, row):
        coarse = bytes(value & 0xFC for value in row)
        return bytes(self.index(coarse[i : i + 3]) for i in range(0, len(coarse), 3))


def moving(pictures, frames_per_second):
    """The bytes of an APNG that goes on for ever. Pixels that stay as they were are left transparent."""
    width, height = pictures[0].width, pictures[0].height
    palette = palette_of(pictures[:: max(1, len(pictures) // 8)], 255)
    nearest = Nearest(palette)
    same = len(palette)
    out = [SIGNATURE, chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0))]
    out.append(chunk(b"PLTE", b"".join(palette) + b"\0\0\0"))
    out.append(chunk(b"tRNS", b"\xff" * same + b"\0"))
    out.append(chunk(b"acTL", struct.pack(">II", len(pictures), 0)))
    shown, number = None, 0
    for picture in pictures:
        rows = [nearest.row(row) for row in picture.rows]
        drawn = rows if shown is None else [bytes(same if a == b else b for a, b in zip(old, new)) for old, new in zip(shown, rows)]
        body = zlib.compress(b"".join(b"\0" + row for row in drawn), 9)
        blend = 0 if shown is None else 1
        out.append(chunk(b"fcTL", struct.pack(">IIIIIHHBB", number, width, height, 0, 0, 1, frames_per_second, 0, blend)))
        number += 1
        if shown is None:
            out.append(chunk(b"IDAT", body))
        else:
            out.append(chunk(b"fdAT", struct.pack(">I", number) + body))
            number += 1
        shown = rows
    return b"".join([*out, chunk(b"IEND", b"")])
