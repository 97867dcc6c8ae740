#!/usr/bin/env python3
"""Says how many pixels of two pictures differ so that one sees it, and fails where more than one in two hundred do.

    differs.py KEPT.png NEW.png     exit 0: alike, 1: not
"""

import sys

import png

SEEN = 48  # Of 255, in the channel that differs most.
PERCENT_AT_MOST = 0.5


def differing(kept, new):
    """Per cent of the pixels; all where the sizes differ."""
    if (kept.width, kept.height) != (new.width, new.height):
        return 100.0
    count = 0
    for old, row in zip(kept.rows, new.rows):
        if old != row:
            count += sum(
                max(abs(old[i] - row[i]), abs(old[i + 1] - row[i + 1]), abs(old[i + 2] - row[i + 2])) > SEEN for i in range(0, len(row), 3)
            )
    return 100.0 * count / (kept.width * kept.height)


def main(arguments):
    percent = differing(*(png.read(path) for path in arguments))
    print(f"{percent:.2f} % of the pixels differ, at most {PERCENT_AT_MOST} %")
    return 1 if percent > PERCENT_AT_MOST else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
