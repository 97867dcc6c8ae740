#!/usr/bin/env python3
"""No joint of a leg turns about itself between two frames because the hips or the feet are moved.

    check_turns.py [--table] PROGRAM DATA_FOLDER [FILE...]

Every clip of every biped is posed with the hips 8 % of the height lower, 8 % higher, and each foot lifted by 8 %, over the whole clip. From one frame
to the next no joint of a leg may turn in the world by more than twice what it turns in the source plus 5 degrees. The keys are read and evaluated
here, by the rules of glTF, so that no code of the program judges itself. --table prints the worst of each file. What is known and not mended yet
is a count for each file, which may fall and never rise. Turns that the ends of the leg force are counted apart: its bones would turn so
far though the plane of the leg did not turn about the line from base to end, or the end is as near to the base as the bones' lengths allow.
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
NEAR = 0.03  # of the leg's length: an end this near to the nearest that the bones allow is held there
# Turns too far that are known and that the ends do not force: knees that the clip bends backwards, legs of which an offset of 8 % of the height takes half
# the length, so that their plane is carried over a line that turns three times as fast.
KNOWN = {"CesiumMan": 2, "Knight": 36, "mannequiny-0.3.0": 9}
# Turns too far that the ends force, as the offset asks more of the legs than they have: as many as are known, so that no more are made.
KNOWN_FORCED = {"Knight": 1201, "robot": 18, "boxman": 16, "mannequiny-0.3.0": 8}
SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
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


def turned(q, v):
    x, y, z, w = multiplied(multiplied(q, [*v, 0.0]), [-q[0], -q[1], -q[2], q[3]])
    return [x, y, z]


def between(a, b):
    """Degrees between two directions."""
    length = math.hypot(*a) * math.hypot(*b) or 1.0
    return math.degrees(math.acos(max(-1.0, min(1.0, sum(x * y for x, y in zip(a, b)) / length))))


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
        self.tracks, self.others = {}, {}
        animation = self.document["animations"][clip]
        for channel in animation["channels"]:
            target = channel["target"]
            if target.get("path") in ("rotation", "translation", "scale") and "node" in target:
                sampler = animation["samplers"][channel["sampler"]]
                times = [row[0] for row in accessor_rows(self.document, self.buffers, sampler["input"])]
                track = (sampler.get("interpolation", "LINEAR"), times, accessor_rows(self.document, self.buffers, sampler["output"]))
                if target["path"] == "rotation":
                    self.tracks[target["node"]] = track
                else:
                    self.others[target["node"], target["path"]] = track

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

    def moved(self, node, time):
        """Place of a node in the world; sizes that are not even are taken by their mean."""
        chain = [node]
        while chain[-1] in self.parents:
            chain.append(self.parents[chain[-1]])
        place, turn, size = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0], 1.0
        for step in reversed(chain):
            place = [p + size * m for p, m in zip(place, turned(turn, self.row(step, "translation", [0.0, 0.0, 0.0], time)))]
            turn = multiplied(turn, self.local(step, time))
            size *= sum(self.row(step, "scale", [1.0, 1.0, 1.0], time)) / 3.0
        return place

    def row(self, node, path, usual, time):
        if (node, path) not in self.others:
            return self.document["nodes"][node].get(path, usual)
        kind, times, rows = self.others[node, path]
        at = max(0, min(len(times) - 1, bisect.bisect_right(times, time) - 1))
        value = (lambda i: rows[3 * i + 1]) if kind == "CUBICSPLINE" else (lambda i: rows[i])
        if time <= times[0] or at == len(times) - 1 or kind == "STEP":
            return value(at if time > times[0] else 0)
        share = (time - times[at]) / (times[at + 1] - times[at])
        return [a + share * (b - a) for a, b in zip(value(at), value(at + 1))]

    def steps(self, node, times):
        """Degrees from each time to the next."""
        turns = [self.world(node, time) for time in times]
        return [math.degrees(2 * math.acos(min(1.0, abs(sum(x * y for x, y in zip(a, b)))))) for a, b in zip(turns, turns[1:])]


def scaled(v, factor):
    return [factor * x for x in v]


def direction(a, b):
    way = [y - x for x, y in zip(a, b)]
    return scaled(way, 1.0 / (math.hypot(*way) or 1.0))


def carried(vector, line, new_line):
    """A vector turned as the smallest turn of one unit line to another turns it."""
    x, y, z = (line[1] * new_line[2] - line[2] * new_line[1], line[2] * new_line[0] - line[0] * new_line[2], line[0] * new_line[1] - line[1] * new_line[0])
    return turned(unit([x, y, z, 1.0 + sum(a * b for a, b in zip(line, new_line))]), vector)


class Leg:
    """Where base, knee and end of a leg are at each time."""

    def __init__(self, posed, joints, times):
        self.joints = joints
        self.points = [[posed.moved(joint, time) for joint in joints] for time in times]

    def forces(self, joint, step, allowed):
        """Whether the ends make the bone of a joint turn by more than allowed from one time to the next, though the plane of the leg does not turn
        about the line between them."""
        bone = min(self.joints.index(joint), len(self.joints) - 2)
        lines, bones = [], []
        for points in self.points[step:step + 2]:
            lengths = [math.dist(a, b) for a, b in zip(points, points[1:])]
            if math.dist(points[0], points[-1]) <= 2 * max(lengths) - sum(lengths) + NEAR * sum(lengths):
                return True
            lines.append(direction(points[0], points[-1]))
            bones.append(direction(points[bone], points[bone + 1]))
        kept = carried(bones[0], *lines)
        along = sum(a * b for a, b in zip(bones[1], lines[1]))
        across = [a - sum(x * y for x, y in zip(kept, lines[1])) * b for a, b in zip(kept, lines[1])]
        side = math.sqrt(max(0.0, 1.0 - along * along)) / (math.hypot(*across) or 1.0)
        return between(bones[0], [along * a + side * b for a, b in zip(lines[1], across)]) > allowed


def cases(info):
    limbs = {limb["limb"] for limb in info["limbs"]}
    yield "hips lower", {"controller": "hips", "keys": [{"frame": 0, "move": [0, -OFFSET * info["height"], 0]}]}
    yield "hips higher", {"controller": "hips", "keys": [{"frame": 0, "move": [0, OFFSET * info["height"], 0]}]}
    for side in ("left", "right"):
        if f"{side}-leg" in limbs:
            yield f"{side} foot lifted", {"controller": f"{side}-foot", "keys": [{"frame": 0, "move": [0, OFFSET * info["height"], 0]}]}


def clip_findings(program, file, info, clip, folder):
    legs = [[joint["node"] for joint in limb["joints"]] for limb in info["limbs"] if limb["limb"].endswith("-leg")]
    joints = [joint for leg in legs for joint in leg]
    seconds, fps = info["clips"][clip]["seconds"], info["clips"][clip]["fps"]
    times = [frame / fps for frame in range(int(seconds * fps + 1e-3) + 1)]
    source = Turns(file, clip)
    before = {joint: source.steps(joint, times) for joint in joints}
    for name, adjustment in cases(info):
        recipe, output = folder / "recipe.json", folder / "posed.glb"
        recipe.write_text(json.dumps({"version": 1, "units": "metres", "adjustments": [adjustment]}))
        done = subprocess.run([program, "pose", file, "-o", output, "--recipe", recipe, "--clip", f"#{clip}", "--clean", "--json"], capture_output=True, text=True)
        if done.returncode != 0:
            yield 0.0, False, f"{name}: {done.stderr.strip()}"
            continue
        posed = Turns(output, clip)
        made = {}
        for joint in joints:
            for i, (was, now) in enumerate(zip(before[joint], posed.steps(joint, times))):
                allowed = ALLOWED_FACTOR * was + ALLOWED_DEGREES
                if now > allowed:
                    leg = next(leg for leg in legs if joint in leg)
                    made.setdefault(leg[0], None)
                    made[leg[0]] = made[leg[0]] or Leg(posed, leg, times)
                    yield now, made[leg[0]].forces(joint, i, allowed), f"{info['clips'][clip]['name']}, {name}: node {joint} turns by {now:.0f} degrees after frame {i}, {was:.0f} in the source"


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
            free = [finding for finding in found if not finding[1]]
            known = KNOWN.get(file.stem, 0)
            forced, known_forced = len(found) - len(free), KNOWN_FORCED.get(file.stem, 0)
            failed = failed or len(free) > known or forced > known_forced
            print(f"{file.name}: {len(info['clips'])} clips, {len(free)} turns too far, {known} known; {forced} more that the ends force, {known_forced} known", flush=True)
            if arguments.table or len(free) > known:
                for _, _, text in sorted(free, reverse=True)[:8]:
                    print(f"  {text}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
