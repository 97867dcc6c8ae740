#!/usr/bin/env python3
"""Cuts a part out of a picture, in place: crop.py PICTURE.png X Y WIDTH HEIGHT"""

import sys

import png


def main(arguments):
    path, place = arguments[0], [int(number) for number in arguments[1:]]
    data = png.still(png.cropped(png.read(path), *place))
    with open(path, "wb") as file:
        file.write(data)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
