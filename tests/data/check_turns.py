#!/usr/bin/env python3
"""No joint of a leg turns about itself between two frames because the hips or the feet are moved.

    check_turns.py [--table] PROGRAM DATA_FOLDER [FILE...]

Every clip of every biped is posed with the hips 8 % of the height lower, 8 % higher, and each foot lifted by 8 %, over the whole clip. From one frame
to the next no joint of a leg may turn in the world by more than twice what it turns in the source plus 5 degrees. The keys are read and evaluated
here, by the rules of glTF, so that no code of the program judges itself. --table prints the worst of each file. What is known and not mended yet
is a count for each file, which may fall and never rise.
"""

import argparse
import bisect
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

from check_corpus import read_gltf
from posed_character import bipeds

OFFSET = 0.08  # of the height
ALLOWED_FACTOR, ALLOWED_DEGREES = 2.0, 5.0
# Turns too far that are known: short legs whose length an offset of 8 % of the height halves, knees that the clip bends backwards, thighs that spin.
KNOWN = {"CesiumMan": 2, "Knight": 1237, "boxman": 16, "mannequiny-0.3.0": 15, "robot": 18}
SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
FORMATS = {5120: ("b", 127.0), 5121: ("B", 255.0), 5122: ("h", 32767.0), 5123: ("H", 65535.0), 5126: ("f", None)}


def accessor_rows(document, buffers, index):
    accessor = document["accessors"][index]
    size, (letter, scale) = SIZES[accessor["type"]], FORMATS[accessor["componentType"]]
    width = size * struct.calcsize(letter)
    if "bufferView" not in accessor:
        return [[0.0] * size] * accessor["count"]
    view = document["bufferViews"][accessor["bufferView"]]
    data, start = buffers[view["buffer"]], view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    stride = view.get("byteStride", width)
    rows = [struct.unpack_from(f"<{size}{letter}", data, start + i * stride) for i in range(accessor["count"])]
    return [[max(-1.0, value / scale) for value in row] for row in rows] if scale and accessor.get("normalized") else [list(row) for row in rows]


def multiplied(a, b):
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx, aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz]


def unit(q):
    length = math.sqrt(sum(x * x for x in q)) or 1.0
    return [x / length for x in q]


def mixed(a, b, share):
    cosine = sum(x * y for x, y in zip(a, b))
    if cosine < 0.0:
        b, cosine = [-x for x in b], -cosine
    if cosine > 0.9999999:
        return unit([x + share * (y - x) for x, y in zip(a, b)])
    angle = math.acos(min(1.0, cosine))
    first, second = math.sin((1 - share) * angle) / math.sin(angle), math.sin(share * angle) / math.sin(angle)
    return [first * x + second * y for x, y in zip(a, b)]


class Turns:
    """World rotations of joints in one clip of a file, by the rules of glTF; scales that are not even are left out of it."""

    def __init__(self, file, clip):
        self.document, self.buffers = read_gltf(file)
        nodes = self.document["nodes"]
        self.parents = {child: i for i, node in enumerate(nodes) for child in node.get("children", [])}
        self.rests = [node.get("rotation", [0.0, 0.0, 0.0, 1.0]) for node in nodes]
        self.tracks = {}
        animation = self.document["animations"][clip]
        for channel in animation["channels"]:
            target = channel["target"]
            if target.get("path") == "rotation" and "node" in target:
                sampler = animation["samplers"][channel["sampler"]]
                times = [row[0] for row in accessor_rows(self.document, self.buffers, sampler["input"])]
                self.tracks[target["node"]] = (sampler.get("interpolation", "LINEAR"), times,
                                               accessor_rows(self.document, self.buffers, sampler["output"]))

    def local(self, node, time):
        if node not in self.tracks:
            return self.rests[node]
        kind, times, rows = self.tracks[node]
        at = max(0, min(len(times) - 1, bisect.bisect_right(times, time) - 1))
        spline = kind == "CUBICSPLINE"
        value = (lambda i: rows[3 * i + 1]) if spline else (lambda i: rows[i])
        if time <= times[0] or at == len(times) - 1 or kind == "STEP":
            return unit(value(at if time > times[0] else 0))
        span = times[at + 1] - times[at]
        share = (time - times[at]) / span
        if not spline:
            return mixed(unit(value(at)), unit(value(at + 1)), share)
        squared, cubed = share * share, share ** 3
        out, into = rows[3 * at + 2], rows[3 * (at + 1)]
        return unit([(2 * cubed - 3 * squared + 1) * a + (cubed - 2 * squared + share) * span * o + (3 * squared - 2 * cubed) * b + (cubed - squared) * span * i
                     for a, b, o, i in zip(value(at), value(at + 1), out, into)])

    def world(self, node, time):
        turn = self.local(node, time)
        while node in self.parents:
            node = self.parents[node]
            turn = multiplied(self.local(node, time), turn)
        return unit(turn)

    def steps(self, node, times):
        """Degrees from each time to the next."""
        turns = [self.world(node, time) for time in times]
        return [math.degrees(2 * math.acos(min(1.0, abs(sum(x * y for x, y in zip(a, b)))))) for a, b in zip(turns, turns[1:])]


def cases(info):
    limbs = {limb["limb"] for limb in info["limbs"]}
    yield "hips lower", {"controller": "hips", "keys": [{"frame": 0, "move": [0, -OFFSET * info["height"], 0]}]}
    yield "hips higher", {"controller": "hips", "keys": [{"frame": 0, "move": [0, OFFSET * info["height"], 0]}]}
    for side in ("left", "right"):
        if f"{side}-leg" in limbs:
            yield f"{side} foot lifted", {"controller": f"{side}-foot", "keys": [{"frame": 0, "move": [0, OFFSET * info["height"], 0]}]}


def clip_findings(program, file, info, clip, folder):
    joints = [joint["node"] for limb in info["limbs"] if limb["limb"].endswith("-leg") for joint in limb["joints"]]
    seconds, fps = info["clips"][clip]["seconds"], info["clips"][clip]["fps"]
    times = [frame / fps for frame in range(int(seconds * fps + 1e-3) + 1)]
    source = Turns(file, clip)
    before = {joint: source.steps(joint, times) for joint in joints}
    for name, adjustment in cases(info):
        recipe, output = folder / "recipe.json", folder / "posed.glb"
        recipe.write_text(json.dumps({"version": 1, "units": "metres", "adjustments": [adjustment]}))
        done = subprocess.run([program, "pose", file, "-o", output, "--recipe", recipe, "--clip", f"#{clip}", "--clean", "--json"], capture_output=True, text=True)
        if done.returncode != 0:
            yield 0.0, 0.0, f"{name}: {done.stderr.strip()}"
            continue
        posed = Turns(output, clip)
        for joint in joints:
            for i, (was, now) in enumerate(zip(before[joint], posed.steps(joint, times))):
                if now > ALLOWED_FACTOR * was + ALLOWED_DEGREES:
                    yield now, was, f"{info['clips'][clip]['name']}, {name}: node {joint} turns by {now:.0f} degrees after frame {i}, {was:.0f} in the source"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--table", action="store_true")
    parser.add_argument("program")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    arguments = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as temporary:
        for file in arguments.files or bipeds(arguments.program, arguments.data):
            info = json.loads(subprocess.run([arguments.program, "info", file, "--json"], capture_output=True, text=True, check=True).stdout)
            found = [finding for clip in range(len(info["clips"])) for finding in clip_findings(arguments.program, file, info, clip, pathlib.Path(temporary))]
            known = KNOWN.get(file.stem, 0)
            failed = failed or len(found) > known
            print(f"{file.name}: {len(info['clips'])} clips, {len(found)} turns too far, {known} known")
            if arguments.table or len(found) > known:
                for _, _, text in sorted(found, reverse=True)[:8]:
                    print(f"  {text}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
