#!/usr/bin/env python3
"""Draws characters as their artists bound them and as `bind` does at the same joints, for a person to compare.

    bind_pictures.py PROGRAM DATA_FOLDER OUTPUT_FOLDER [NAME...]

Of each character: one pose with a raised arm, a bent knee, a twisted trunk and an arm across it, from in front and at an angle; and
an arm stretched 1.8 times over the first clip. NAME-artist-*.png and NAME-bound-*.png are to look the same.
"""

import json
import pathlib
import sys
import tempfile

from bind_files import character_file, without_weights
from check_bind import GOALS
from check_exaggeration import run

POSE = {"version": 1, "adjustments": [
    {"controller": "spine-top", "keys": [{"frame": 0, "turn": [0, 55, 0]}]},
    {"controller": "right-hand", "keys": [{"frame": 0, "move": [-0.2, 1.5, 0.1]}]},
    {"controller": "left-hand", "keys": [{"frame": 0, "move": [-0.3, 0.5, 0.6]}]},
    {"controller": "left-foot", "keys": [{"frame": 0, "move": [0.05, 0.55, 0.35]}]}]}


def draw(program, source, stem, folder):
    recipe, posed, stretched = folder / "pose.json", folder / "posed.glb", folder / "stretched.glb"
    recipe.write_text(json.dumps(POSE))
    run(program, "pose", source, "-o", posed, "--in-place", "--recipe", recipe)
    for view in ("front", "three-quarter"):
        run(program, "render", posed, "-o", f"{stem}-{view}.png", "--frame", "0", "--size", "480x540", "--view", view)
    run(program, "exaggerate", source, "-o", stretched, "--in-place", "--clean", "--limb", "left-arm", "--scale", "1.8")
    run(program, "render", stretched, "-o", f"{stem}-stretched.png", "--sheet", "--size", "1200x900")


def main():
    if len(sys.argv) < 4:
        print(__doc__, file=sys.stderr)
        return 2
    program, data, output, wanted = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), sys.argv[4:]
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for character in GOALS:
            if wanted and not any(character.startswith(part) for part in wanted):
                continue
            source, bare, bound = character_file(data, character), folder / "bare.glb", folder / "bound.glb"
            without_weights(source, bare)
            run(program, "bind", bare, "-o", bound, "--in-place", "--keep-joints")
            draw(program, source, output / f"{character}-artist", folder)
            draw(program, bound, output / f"{character}-bound", folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
