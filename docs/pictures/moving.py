#!/usr/bin/env python3
"""Joins two numbered series of pictures into one that moves, the first beside the second.

    moving.py OUTPUT.png FRAMES_PER_SECOND LEFT_PREFIX RIGHT_PREFIX
"""

import glob
import sys

import png


def main(arguments):
    output, rate, left, right = arguments
    pairs = list(zip(sorted(glob.glob(f"{left}-*.png")), sorted(glob.glob(f"{right}-*.png")), strict=True))
    pictures = [png.beside(png.read(a), png.read(b)) for a, b in pairs]
    with open(output, "wb") as file:
        file.write(png.moving(pictures, int(rate)))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
