#!/usr/bin/env python3
"""Plays the recipes of the three evaluations on the bundled clips and has three.js and the Khronos validator read the result.

    check_evaluations.py PROGRAM

At every frame and half frame of the saved files:
- swing: the left hand, and the right one until it lets go, as far from three points of the bat as in the source (1 % of its length);
- swing: both feet where the source has them (0.5 % of the height);
- leap: no vertex of the body deeper in the floor or in a block than in the source (0.5 % of the height);
- leap: the hands on the ledge and the feet on the platform where the source has them (0.5 % of the height);
- no error or warning of the validator that the source did not have.
"""

import json
import math
import pathlib
import sys
import tempfile

from check_exaggeration import Reader, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
FPS = 24
LETS_GO = 44
OF_BAT = 0.01
OF_HEIGHT = 0.005
BLOCKS = (((-0.6, 0, 1.8), (0.6, 0.42, 2.1)), ((-0.6, 0, 3.2), (0.6, 0.85, 3.75)), ((-0.8, 0, 4.6), (0.8, 0.30, 6.4)))
STANDING = {"LeftHand": (46, 50), "RightHand": (46, 50), "LeftFoot": (64, 76), "RightFoot": (64, 76)}


def half_frames(first, last):
    return [half / 2 for half in range(2 * first, 2 * last + 1)]


def nodes_of(file):
    raw = file.read_bytes()
    length = int.from_bytes(raw[12:16], "little")
    return {node.get("name"): index for index, node in enumerate(json.loads(raw[20:20 + length])["nodes"])}


def points(flat):
    return [flat[i:i + 3] for i in range(0, len(flat), 3)]


def depth(point):
    deepest = max(0.0, -point[1])
    for low, high in BLOCKS:
        if all(a < x < b for a, x, b in zip(low, point, high)):
            deepest = max(deepest, min(high[1] - point[1], point[2] - low[2], high[2] - point[2]))
    return deepest


class Played:
    """A file as three.js plays it: places of named nodes, vertices of one node."""

    def __init__(self, reader, file, frames, joints, step):
        nodes = nodes_of(file)
        answer = reader.measure(file, 0, [frame / FPS for frame in frames], [nodes[joint] for joint in joints], step)
        self.places = dict(zip(joints, answer["nodes"].values()))
        self.vertices = {key.split()[0][1:]: value for key, value in answer["vertices"].items()}
        self.nodes = nodes

    def of(self, node):
        return self.vertices[str(self.nodes[node])]


def swing_problems(reader, source, made, height):
    frames = half_frames(0, 88)
    joints = ["LeftHand", "RightHand", "LeftFoot", "RightFoot"]
    before, after = (Played(reader, file, frames, joints, 40) for file in (source, made))
    bat = points(before.of("Bat")[0])
    length = max(math.dist(a, b) for a in bat for b in bat)
    marks = (0, len(bat) // 2, len(bat) - 1)
    problems = []
    for i, frame in enumerate(frames):
        for hand in ("LeftHand", "RightHand"):
            if hand == "RightHand" and frame > LETS_GO:
                continue
            away = [[math.dist(p.places[hand][i], points(p.of("Bat")[i])[mark]) for mark in marks] for p in (before, after)]
            off = max(abs(a - b) for a, b in zip(*away))
            if off > OF_BAT * length:
                problems.append(f"{hand} is {off / length:.3f} of the bat from its place at frame {frame:g}")
        for foot in ("LeftFoot", "RightFoot"):
            slid = math.dist(before.places[foot][i], after.places[foot][i]) / height
            if slid > OF_HEIGHT:
                problems.append(f"{foot} slides by {slid:.4f} of the height at frame {frame:g}")
    return problems


def leap_problems(reader, source, made, height):
    frames = half_frames(28, 80)
    before, after = (Played(reader, file, frames, list(STANDING), 3) for file in (source, made))
    body = max(before.vertices, key=lambda node: len(before.vertices[node][0]))
    problems = []
    for i, frame in enumerate(frames):
        was, now = (max(depth(point) for point in points(p.vertices[body][i])) for p in (before, after))
        if now - was > OF_HEIGHT * height:
            problems.append(f"the body is {now - was:.3f} deeper in floor or block than in the source at frame {frame:g}")
        for joint, (first, last) in STANDING.items():
            slid = math.dist(before.places[joint][i], after.places[joint][i]) / height
            if first <= frame <= last and slid > OF_HEIGHT:
                problems.append(f"{joint} slides by {slid:.4f} of the height at frame {frame:g}")
    return problems


def problems_of(program, reader, clip, recipe, folder):
    source = ROOT / "assets" / clip
    made = folder / f"{recipe}.glb"
    run(program, "exaggerate", source, "-o", made, "--recipe", ROOT / "docs" / "recipes" / f"{recipe}.json")
    height = json.loads(run(program, "info", source, "--json"))["height"]
    check = {"swing": swing_problems, "leap": leap_problems}.get(recipe.split("-")[1])
    return reader.worse(made, source) + (check(reader, source, made, height) if check else [])


def main():
    program, reader, bad = pathlib.Path(sys.argv[1]).resolve(), Reader(), 0
    for clip, action in (("dummy.glb", "punch"), ("dummy_swing.glb", "swing"), ("dummy_leap.glb", "leap")):
        for version in ("simple", "refined"):
            with tempfile.TemporaryDirectory() as folder:
                problems = problems_of(program, reader, clip, f"{version}-{action}", pathlib.Path(folder))
            print(f"{version}-{action}: {len(problems)} problems", flush=True)
            for problem in problems[:10]:
                print(f"  {problem}")
            bad += len(problems)
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
