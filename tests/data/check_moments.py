#!/usr/bin/env python3
"""Asks the program for the moments of every clip of a data folder whose name says what happens, and of the bundled ones.

    check_moments.py PROGRAM DATA_FOLDER

- An action (punch, kick, jab, throw, attack, slash, chop, wave ...): the strongest moment is on a limb that does it, and its tip within two
  frames of where the limb's end, by the evaluator here, comes to rest after its fastest frame, or one that is nearly as fast.
- An idle clip: none above 1. A walk or a run: its strongest moments are cycles.
- A bundled clip: each punch, the swing, the leap and the landing, within one frame of what its makers keyed.

What is known not to be met is counted below; the counts may only fall.
"""

import argparse
import bisect
import json
import math
import pathlib
import struct
import sys

from check_corpus import read_gltf, run

TIP_FRAMES, IDLE_AT_MOST, KEYED_FRAMES = 2, 1.0, 1
NEARLY = 0.8
KNOWN = {}
ARMS, LEGS = "left-arm right-arm", "left-leg right-leg"
# The limbs that do what the clip's name says.
ACTIONS = {
    "biped/Knight.glb": {
        "1H_Melee_Attack_Chop": "right-arm", "1H_Melee_Attack_Slice_Diagonal": "right-arm", "1H_Melee_Attack_Slice_Horizontal": "right-arm",
        "1H_Melee_Attack_Stab": "right-arm", "2H_Melee_Attack_Chop": ARMS, "2H_Melee_Attack_Slice": ARMS, "2H_Melee_Attack_Spin": ARMS,
        "2H_Melee_Attack_Stab": ARMS, "Block_Attack": "left-arm", "Dualwield_Melee_Attack_Chop": ARMS, "Dualwield_Melee_Attack_Slice": ARMS,
        "Dualwield_Melee_Attack_Stab": ARMS, "Spellcast_Shoot": "right-arm", "Throw": "right-arm", "Unarmed_Melee_Attack_Kick": "right-leg",
        "Unarmed_Melee_Attack_Punch_A": "right-arm", "Unarmed_Melee_Attack_Punch_B": "right-arm", "Cheer": ARMS},
    "biped/mannequiny-0.3.0.glb": {"fight_punch": "left-arm", "fight_kick": "right-leg"},
    "biped/human-addon-animations.glb": {
        "Fighting Left Jab": "left-arm", "Fighting Right Jab": "right-arm", "Throw Object": "right-arm", "Greeting": "right-arm",
        "Victory Fist Pump": "right-arm"},
    "biped/robot.glb": {"Robot_Punch": "right-arm", "Robot_Wave": "right-arm", "Robot_ThumbsUp": "right-arm"},
    "biped/rpg-lowpoly-skeleton.glb": {"attack1": ARMS, "attack2": ARMS},
    "hard/quaternius-orc.glb": {
        "CharacterArmature|Punch": "right-arm", "CharacterArmature|Weapon": "left-arm", "CharacterArmature|Wave": "left-arm"},
    "hard/quaternius-mech-Mike.glb": {"Kick": "right-leg", "Punch": "right-arm", "SwordSlash": "right-arm", "Hello": "left-arm"},
    "hard/gdbot.glb": {"simple_punch": "left-arm"},
    "hard/kaiju-animations.glb": {"Attack": ARMS},
    "hard/quaternius-Donkey.glb": {"AnimalArmature|Attack_Kick": "hind-left-leg hind-right-leg"},
    "hard/quaternius-Trex.glb": {"Armature|TRex_Attack": "neck spine"},
}
IDLE, GAITS = ("idle",), ("walk", "run", "sprint", "gallop", "crawl")
NOT_IDLE = ("_to_", "toidle", "drop_", "jump_", "hitreact")  # On the way to rest, or hit.
NOT_GAITS = ("drop_", "jump", "runningjump")
# Limb, kind, first frame and tip, as the makers keyed them: assets/dummy/punch.cpp, swing.cpp, leap.cpp.
BUNDLED = {
    "dummy.glb": [("left-arm", "stroke", 21, 27), ("right-arm", "stroke", 40, 43)],
    "dummy_swing.glb": [("right-arm", "stroke", 34, 44)],
    "dummy_leap.glb": [("right-leg", "stroke", 31, 43), ("body", "landing", 63, 68)],
}


def quaternion(a, b, share):
    """From a to b on the shorter arc."""
    dot = sum(x * y for x, y in zip(a, b))
    b = [-y for y in b] if dot < 0.0 else b
    angle = math.acos(min(1.0, abs(dot)))
    if angle < 1e-5:
        return [x + (y - x) * share for x, y in zip(a, b)]
    sine = math.sin(angle)
    return [(math.sin((1.0 - share) * angle) * x + math.sin(share * angle) * y) / sine for x, y in zip(a, b)]


def matrix(translation, rotation, scale):
    x, y, z, w = rotation
    length = math.sqrt(x * x + y * y + z * z + w * w) or 1.0
    x, y, z, w = x / length, y / length, z / length, w / length
    columns = [[1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
               [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
               [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]]
    return [[c * s for c in column] for column, s in zip(columns, scale)], list(translation)


def times(a, b):
    """Product of two (columns, translation)."""
    def turn(v):
        return [sum(a[0][k][i] * v[k] for k in range(3)) for i in range(3)]
    return [turn(column) for column in b[0]], [x + y for x, y in zip(turn(b[1]), a[1])]


class Player:
    """Where the nodes of a file are while a clip plays."""

    def __init__(self, file):
        self.document, self.buffers = read_gltf(file)
        self.parents = {child: i for i, node in enumerate(self.document["nodes"]) for child in node.get("children", [])}

    def numbers(self, index):
        accessor = self.document["accessors"][index]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        letter, size, unit = {5126: ("f", 4, 1.0), 5120: ("b", 1, 127.0), 5121: ("B", 1, 255.0), 5122: ("h", 2, 32767.0),
                              5123: ("H", 2, 65535.0)}[accessor["componentType"]]
        view = self.document["bufferViews"][accessor["bufferView"]]
        stride, start = view.get("byteStride", width * size), view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        rows = [struct.unpack_from("<" + width * letter, self.buffers[view["buffer"]], start + i * stride) for i in range(accessor["count"])]
        return [[max(-1.0, value / unit) for value in row] if unit > 1.0 else list(row) for row in rows]

    def choose(self, clip):
        animation = self.document["animations"][clip]
        self.tracks = {}
        for channel in animation["channels"]:
            target = channel["target"]
            if target.get("path") in ("translation", "rotation", "scale") and "node" in target:
                sampler = animation["samplers"][channel["sampler"]]
                keys = [row[0] for row in self.numbers(sampler["input"])]
                self.tracks[target["node"], target["path"]] = keys, self.numbers(sampler["output"]), sampler.get("interpolation", "LINEAR")
        self.end = max((track[0][-1] for track in self.tracks.values()), default=0.0)

    def value(self, node, path, seconds):
        standing = {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]}[path]
        if (node, path) not in self.tracks:
            return self.document["nodes"][node].get(path, standing)
        keys, values, kind = self.tracks[node, path]
        stride, shift = (3, 1) if kind == "CUBICSPLINE" else (1, 0)
        after = bisect.bisect_right(keys, seconds)
        if after == 0 or after == len(keys):
            return values[stride * max(0, after - 1) + shift]
        before, width = after - 1, keys[after] - keys[after - 1]
        share = (seconds - keys[before]) / width
        a, b = values[stride * before + shift], values[stride * after + shift]
        if kind == "STEP":
            return a
        if kind == "CUBICSPLINE":
            t, out, into = share, values[stride * before + 2], values[stride * after]
            return [(2 * t**3 - 3 * t**2 + 1) * p + (t**3 - 2 * t**2 + t) * width * m + (3 * t**2 - 2 * t**3) * q + (t**3 - t**2) * width * n
                    for p, m, q, n in zip(a, out, b, into)]
        return quaternion(a, b, share) if path == "rotation" else [p + (q - p) * share for p, q in zip(a, b)]

    def end_of(self, limb, seconds):
        """Where a limb ends: at its last joint, or in the middle of what hangs on that where the file has no joint there."""
        last = limb["joints"][-1]["node"]
        nodes = self.document["nodes"][last].get("children", []) if limb["end"] == "estimated" else []
        places = [self.place(node, seconds) for node in nodes or [last]]
        return [sum(axis) / len(places) for axis in zip(*places)]

    def place(self, node, seconds):
        world = None
        while node is not None:
            here = self.document["nodes"][node]
            if "matrix" in here and not any((node, path) in self.tracks for path in ("translation", "rotation", "scale")):
                m = here["matrix"]
                own = [m[0:3], m[4:7], m[8:11]], m[12:15]
            else:
                own = matrix(*(self.value(node, path, seconds) for path in ("translation", "rotation", "scale")))
            world = own if world is None else times(own, world)
            node = self.parents.get(node)
        return world[1]


def resting_frames(player, limb, rate):
    """The frames at which the limb's end, seen from its base, is slow or has turned after frames that are its fastest or nearly so, as
    of a hand that is raised to wave and dropped."""
    base = limb["joints"][0]["node"]
    count = int(2 * player.end * rate + 1.001)
    places = [[a - b for a, b in zip(player.end_of(limb, i / (2 * rate)), player.place(base, i / (2 * rate)))] for i in range(count)]
    steps = [[b - a for a, b in zip(p, q)] for p, q in zip(places, places[1:])]
    speeds = [math.sqrt(sum(x * x for x in step)) for step in steps]
    smooth = [sum(speeds[max(0, i - 1):i + 2]) / len(speeds[max(0, i - 1):i + 2]) for i in range(len(speeds))]
    found = []
    fastest = max(smooth)
    for peak in range(len(smooth)):
        if smooth[peak] < NEARLY * fastest or smooth[peak] < max(smooth[max(0, peak - 1):peak + 2]):
            continue
        at = peak
        while at < len(steps) and smooth[at] > 0.25 * smooth[peak]:
            if sum(a * b for a, b in zip(steps[at], steps[peak])) < -0.2 * speeds[at] * speeds[peak]:
                break
            at += 1
        found.append(at / 2)
    return found


class Check:
    def __init__(self, program):
        self.program, self.rows, self.missed, self.problems, self.clips = program, [], {}, [], 0

    def ask(self, verb, *words):
        status, output, told = run(self.program, verb, *words, "--json", "--tolerant")
        if status != 0:
            raise RuntimeError(told.strip())
        return json.loads(output)

    def miss(self, kind, text):
        self.missed.setdefault(kind, []).append(text)

    def action(self, name, player, info, index, clip, wanted):
        strongest = clip["moments"][0] if clip["moments"] else None
        right = strongest is not None and strongest["limb"] in wanted.split()
        apart = None
        if strongest is not None and strongest["limb"] != "body":
            limb = next(limb for limb in info["limbs"] if limb["limb"] == strongest["limb"])
            player.choose(index)
            apart = min((strongest["tip"] - frame for frame in resting_frames(player, limb, clip["fps"])), key=abs)
        self.rows.append((name, clip["clip"], wanted, strongest, apart))
        if not right:
            self.miss("limb", f"{name} {clip['clip']}")
        elif abs(apart) > TIP_FRAMES:
            self.miss("tip", f"{name} {clip['clip']}, by {apart:g} frames")

    def file(self, file, name, actions):
        info = self.ask("info", file)
        player = Player(file)
        for index, clip in enumerate(self.ask("moments", file, "--all-clips")):
            title = clip["clip"].lower()
            self.clips += 1
            if clip["clip"] in actions:
                self.action(name, player, info, index, clip, actions[clip["clip"]])
            elif any(word in title for word in IDLE) and not any(word in title for word in NOT_IDLE):
                if clip["moments"] and max(m["strength"] for m in clip["moments"]) > IDLE_AT_MOST:
                    self.miss("idle", f"{name} {clip['clip']}")
            elif any(word in title for word in GAITS) and not any(word in title for word in NOT_GAITS):
                if clip["moments"] and clip["moments"][0]["kind"] != "cycle":
                    self.miss("cycle", f"{name} {clip['clip']}")

    def bundled(self, assets):
        for name, wanted in BUNDLED.items():
            moments = self.ask("moments", assets / name)["moments"]
            for limb, kind, start, tip in wanted:
                if not any(m["limb"] == limb and m["kind"] == kind and abs(m["start"] - start) <= KEYED_FRAMES and
                           abs(m["tip"] - tip) <= KEYED_FRAMES for m in moments):
                    self.problems.append(f"{name}: no {kind} of the {limb} from {start} to {tip}")

    def tell(self):
        for name, clip, wanted, strongest, apart in self.rows:
            said = "none" if strongest is None else f"{strongest['limb']:15} {strongest['start']:g} to {strongest['tip']:g}, {strongest['strength']:.1f}"
            print(f"{pathlib.Path(name).stem:24.24} {clip:34.34} {said:38} {'' if apart is None else f'{apart:+g}'}")
        for kind, missed in self.missed.items():
            print(f"{kind}: {len(missed)}, known {KNOWN.get(kind, 0)}: {'; '.join(missed)}")
            if len(missed) > KNOWN.get(kind, 0):
                self.problems.append(f"{kind}: {len(missed)} clips, and {KNOWN.get(kind, 0)} are known")
        for problem in self.problems:
            print("FAILED:", problem)
        print(f"{self.clips} clips, {len(self.rows)} of them actions, {len(self.problems)} problems")
        return 1 if self.problems else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    arguments = parser.parse_args()
    check = Check(arguments.program)
    folders = ("biped", "hard", "bodies", "quadruped")
    for file in sorted(file for folder in folders for file in (arguments.data / folder).rglob("*.glb")):
        name = str(file.relative_to(arguments.data))
        document, _ = read_gltf(file)
        if document.get("animations"):
            check.file(file, name, ACTIONS.get(name, {}))
    check.bundled(pathlib.Path(__file__).resolve().parents[2] / "assets")
    return check.tell()


if __name__ == "__main__":
    sys.exit(main())
