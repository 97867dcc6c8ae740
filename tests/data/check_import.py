#!/usr/bin/env python3
"""Imports clips of one character to another and measures by three.js how the other one moves.

    check_import.py [--pictures FOLDER] [--only TEXT] PROGRAM DATA_FOLDER

From the program come only the clip that it wrote and the limbs that `info --json` names. For each pair:
- slide: how far a foot strays over the ground, of the target's height, while the same foot of the source stands: slower than a quarter of
  the leg's length a second for a tenth of a second, within 0.25 % of its height around its place, without the first and the last thirtieth of
  a second (at most 0.5);
- under: how much farther the lowest vertex gets below the floor than the source's does, of the height;
- angle: of the bones of arms and legs against the source's, degrees: the median over frames and bones, and the 95th percentile. Feet that are
  put down turn legs;
- reach: the straight distance from shoulder to hand, of the arm's length, against the source's: the largest difference;
- told: what the program itself tells of the clip: feet that stand slide at most 0.5 % of the height, hands that
  work together are at most 0.02 widths of the shoulders off, hands that touch are at most 3.57 cm off at 1.7 m and no farther than as mapped, at most
  5.94 % of forearms to feet are inside trunk and head, or as many as in the source, and no more than one in a hundred more than as mapped, and nothing is farther below the floor than as mapped or in the source by 1.5 % of the height;
- the first and last key of the source are the new clip's, the validator finds nothing that the file did not have, and the file's own parts
  stand as they were.
--pictures draws a contact sheet of each source and of each result.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from check_corpus import read_gltf
from check_exaggeration import Reader, run
from vectors import angle, sub

STANDS = 0.25  # leg lengths in each second
LARGEST_SLIDE = 0.005  # of the height
STANDS_WITHIN = 0.0025  # of the height
ARRIVING = 2  # of the sixty samples in each second, at either end of a stand: the foot comes to rest and sets off
MOST_HANDS = 0.02  # widths of the shoulders
MOST_CONTACT = 3.57  # cm at 1.7 m: what R2ET (CVPR 2023) is said to reach on its own set, as the next
MOST_INSIDE = 5.94  # % of forearms to feet
MORE_INSIDE = 1.0  # a hand that is brought to what it touches sinks in a little
MORE_BELOW = 1.5  # % of the height: arms that are moved out of the trunk stay above the floor
SHORT_ARMS = ("biped/boxman.glb",)  # do not reach before the chest together
TOUCHING = 0.5  # cm at 1.7 m: what is nearer than this touches
LATEST = 1e-3  # seconds
HUMAN = "biped/human-addon-animations.glb"
PAIRS = [
    (HUMAN, "Throw Object", "biped/mannequiny-0.3.0.glb"),
    (HUMAN, "Fighting Left Jab", "assets/dummy.glb"),
    (HUMAN, "Dance Charleston", "biped/Knight.glb"),
    (HUMAN, "Run Anime", "biped/CesiumMan.glb"),
    (HUMAN, "Jumping Jacks", "vrm/cryptovoxels.vrm"),
    (HUMAN, "Bow", "biped/robot.glb"),
    (HUMAN, "Victory", "biped/boxman.glb"),
    (HUMAN, "Crawl RM", "biped/rpg-lowpoly-skeleton.glb"),
    ("biped/mannequiny-0.3.0.glb", "fight_kick", HUMAN),
    ("biped/CesiumMan.glb", "#0", HUMAN),
    ("biped/Knight.glb", "Walking_A", "biped/CesiumMan.glb"),
    ("biped/robot.glb", "Robot_Punch", "assets/dummy.glb"),
    ("biped/rpg-lowpoly-skeleton.glb", "attack1", "vrm/debug_robot.vrm"),
    ("vrm/test.vrma", "#0", HUMAN),
    ("biped/Knight.glb", "1H_Melee_Attack_Slice_Diagonal", HUMAN),
    ("biped/Knight.glb", "2H_Melee_Attack_Chop", "biped/mannequiny-0.3.0.glb"),
    ("biped/boxman.glb", "open_door_standing_left", "assets/dummy.glb"),
    ("interchange/mixamo-walking.fbx", "#0", "assets/dummy.glb"),
    ("interchange/boxing-toes.bvh", "#0", "assets/dummy.glb"),
]


class Motion:
    """A clip of a character, as three.js plays it."""

    def __init__(self, program, reader, file, clip, times=None):
        self.info = json.loads(run(program, "info", file, "--json"))
        names = [entry["name"] for entry in self.info["clips"]]
        self.clip = int(clip[1:]) if clip.startswith("#") else names.index(clip)
        self.height = self.info["height"]
        self.limbs = {limb["limb"]: limb for limb in self.info["limbs"]}
        document, buffers = read_gltf(pathlib.Path(file))
        self.ends = key_ends(document, self.clip)
        self.times = times or [self.ends[0] + i / 60 for i in range(int((self.ends[1] - self.ends[0]) * 60 + 1e-6) + 1)]
        self.feet = {leg: foot(document, self.limbs[leg]["joints"][-1]["node"]) for leg in ("left-leg", "right-leg")}
        nodes = sorted({joint["node"] for limb in self.limbs.values() for joint in limb["joints"]} | {n for pair in self.feet.values() for n in pair})
        answer = reader.measure(file, self.clip, self.times, nodes, 7)
        self.places = {int(name.split()[0][1:]): values for name, values in answer["nodes"].items()}
        self.lowest = [min((min(frames[i][1::3]) for frames in answer["vertices"].values()), default=0.0) for i in range(len(self.times))]

    def bones(self, limb, frame):
        points = [self.places[joint["node"]][frame] for joint in self.limbs[limb]["joints"]]
        return [sub(b, a) for a, b in zip(points, points[1:])]

    def hips(self, frame):
        left, right = (self.places[self.limbs[leg]["joints"][0]["node"]][frame] for leg in ("left-leg", "right-leg"))
        return sub(left, right)

    def stood(self, leg, point):
        """The place of the foot's ankle (0) or toes (1)."""
        return self.places[self.feet[leg][point]]


def key_ends(document, clip):
    samplers = document["animations"][clip]["samplers"]
    inputs = [document["accessors"][sampler["input"]] for sampler in samplers]
    return min(a["min"][0] for a in inputs), max(a["max"][0] for a in inputs)


def foot(document, ankle):
    """The ankle, and the joint of the toes if there is one."""
    joints = {joint for skin in document.get("skins", []) for joint in skin["joints"]}
    toes = [child for child in document["nodes"][ankle].get("children", []) if not joints or child in joints]
    return [ankle] + toes[:1]


def stands(places, times, leg, height):
    result, first = [], 0
    while first + 1 < len(places):
        last = first
        while (last + 1 < len(places) and math.dist(places[last + 1], places[last]) <= STANDS * leg * (times[last + 1] - times[last])
               and math.dist(places[last + 1], places[first]) <= STANDS_WITHIN * height):
            last += 1
        if last > first and times[last] - times[first] >= 0.1:
            result.append((first, last))
        first = last + 1
    return result


def level(a, b):
    return math.hypot(a[0] - b[0], a[2] - b[2])


def slides(source, own):
    """The strays of the feet of all stands."""
    found = []
    for leg in (leg for leg in source.feet if all(m.limbs[leg]["end"] != "estimated" for m in (source, own))):
        point = min(len(source.feet[leg]), len(own.feet[leg])) - 1
        for first, last in stands(source.stood(leg, point), source.times, source.limbs[leg]["rest_length"], source.height):
            here = own.stood(leg, point)
            first, last = first + ARRIVING, last - ARRIVING
            found.append(max(level(here[i], here[first]) for i in range(first, last + 1)) / own.height)
    return found


def turned(vector, yaw):
    c, s = math.cos(yaw), math.sin(yaw)
    return [c * vector[0] + s * vector[2], vector[1], c * vector[2] - s * vector[0]]


def angles(source, own):
    found = []
    a, b = source.hips(0), own.hips(0)
    yaw = math.atan2(-b[2], b[0]) - math.atan2(-a[2], a[0])
    yaw = round(yaw / (math.pi / 2)) * math.pi / 2
    for limb in ("left-arm", "right-arm", "left-leg", "right-leg"):
        if limb in source.limbs and limb in own.limbs:
            for frame in range(len(source.times)):
                pairs = zip(source.bones(limb, frame), own.bones(limb, frame))
                found += [math.degrees(angle(turned(u, yaw), v)) for u, v in pairs]
    return sorted(found)


def span(motion, limb, frame):
    joints = motion.limbs[limb]["joints"]
    return math.dist(*(motion.places[joints[i]["node"]][frame] for i in (0, -1))) / motion.limbs[limb]["rest_length"]


def reach(source, own):
    arms = [arm for arm in ("left-arm", "right-arm") if all(arm in m.limbs and m.limbs[arm]["end"] != "estimated" for m in (source, own))]
    return max((abs(span(source, arm, i) - span(own, arm, i)) for arm in arms for i in range(len(source.times))), default=0.0)


def only_added(before, after):
    """Everything of the file stands in the new one, but for nodes whose matrix gave way to its parts."""
    lists = ("accessors", "animations", "images", "materials", "meshes", "skins", "textures", "cameras", "scenes")
    same = all(after.get(key, [])[:len(before.get(key, []))] == before.get(key, []) for key in lists)
    nodes = all(a == b for a, b in zip(before["nodes"], after["nodes"]) if "matrix" not in a)
    return same and nodes and len(before["nodes"]) == len(after["nodes"])


def worse_than_goal(report, target):
    """What of the told figures is worse than it may be."""
    problems = []
    source, own = report["source"], report["result"]
    if own["slide_percent"] is not None and own["slide_percent"] > 100 * LARGEST_SLIDE:
        problems.append(f"a foot slides by {own['slide_percent']:.2f} % as told, the source's by {source['slide_percent']}")
    if own["hands_widths"] is not None and not str(target).endswith(SHORT_ARMS) and own["hands_widths"] > MOST_HANDS:
        problems.append(f"hands that work together are {own['hands_widths']:.3f} widths of the shoulders off")
    mapped = report["mapped"]
    if own["contact_cm"] is not None and own["contact_cm"] > min(MOST_CONTACT, max(mapped["contact_cm"], TOUCHING)):
        problems.append(f"hands that touch are {own['contact_cm']:.2f} cm off, as mapped {mapped['contact_cm']:.2f}")
    if own["inside_percent"] is not None:
        goal = max(MOST_INSIDE, source["inside_percent"] or 0.0)
        if own["inside_percent"] > mapped["inside_percent"] + MORE_INSIDE or own["inside_percent"] > goal:
            problems.append(f"{own['inside_percent']:.2f} % of forearms to feet are inside, as mapped {mapped['inside_percent']:.2f}")
    if own["floor_percent"] is not None and own["floor_percent"] > max(mapped["floor_percent"], source["floor_percent"] or 0.0) + MORE_BELOW:
        problems.append(f"{own['floor_percent']:.2f} % of the height below the floor, as mapped {mapped['floor_percent']:.2f}")
    return problems


def told_only(program, source, clip, target, output):
    """Sources that three.js does not open as glTF: by the program's own figures."""
    made = json.loads(run(program, "import-clip", target, "-o", output, "--from", source, "--from-clip", clip, "--clean", "--json"))["clips"][0]
    return made["report"], worse_than_goal(made["report"], target)


def told_row(title, report):
    figures = ("slide_percent", "contact_cm", "inside_percent", "deepest_percent", "held_percent", "floor_percent", "hands_widths")
    parts = (", ".join("-" if report[whose][figure] is None else f"{report[whose][figure]:.2f}" for whose in ("source", "mapped", "result")) for figure in figures)
    return f"| {title} | {' | '.join(parts)} |"


def draw(program, file, clip, frames, picture):
    step = max(1, frames // 6)
    run(program, "render", file, "-o", picture, "--clip", clip, "--sheet", "--frames", f"0:{frames - 1}:{step}", "--size", "230x230")


def check(program, reader, data, folder, pair, pictures):
    source, clip, target = pair
    source, target = (pathlib.Path(name) if name.startswith("assets/") else data / name for name in (source, target))
    output = folder / f"{target.stem}-of-{source.stem}.glb"
    report = json.loads(run(program, "import-clip", target, "-o", output, "--from", source, "--from-clip", clip, "--clean", "--json"))
    made = report["clips"][0]
    first = Motion(program, reader, source, clip)
    second = Motion(program, reader, output, "#" + str(len(json.loads(run(program, "info", output, "--json"))["clips"]) - 1), first.times)
    strays, off = slides(first, second), angles(first, second)
    result = {"stands": len(strays), "slide": 100 * max(strays, default=0.0), "reach": 100 * reach(first, second), "way": made["way"],
              "under": 100 * (max(0.0, -min(second.lowest)) / second.height - max(0.0, -min(first.lowest)) / first.height),
              "median": off[len(off) // 2], "angle": off[int(0.95 * (len(off) - 1))], "keys": made["keys"]}
    problems = reader.worse(output, target) + (worse_than_goal(made["report"], target) if "report" in made else [])
    result["report"] = made.get("report")
    if result["slide"] > 100 * LARGEST_SLIDE:
        problems.append(f"a foot slides by {result['slide']:.2f} % of the height")
    if max(abs(a - b) for a, b in zip(first.ends, second.ends)) > LATEST:
        problems.append(f"keys from {second.ends} instead of {first.ends}")
    if not only_added(read_gltf(target)[0], read_gltf(output)[0]):
        problems.append("something else of the file is changed")
    if pictures:
        draw(program, source, clip, made["frames"], pictures / f"{output.stem}-1-source.png")
        draw(program, output, made["name"], made["frames"], pictures / f"{output.stem}-2-own.png")
    return result, problems


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--pictures", type=pathlib.Path)
    parser.add_argument("--only", default="", help="pairs whose names hold this")
    parser.add_argument("program")
    parser.add_argument("data", type=pathlib.Path)
    arguments = parser.parse_args()
    if arguments.pictures:
        arguments.pictures.mkdir(parents=True, exist_ok=True)
    reader, bad, told = Reader(), 0, []
    with tempfile.TemporaryDirectory() as name:
        for pair in PAIRS:
            if arguments.only not in " ".join(pair):
                continue
            title = f"{pathlib.Path(pair[0]).stem}, {pair[1]} | {pathlib.Path(pair[2]).stem}"
            if pathlib.Path(pair[0]).suffix in (".fbx", ".bvh"):
                source, target = (pathlib.Path(name) if name.startswith("assets/") else arguments.data / name for name in (pair[0], pair[2]))
                report, problems = told_only(arguments.program, source, pair[1], target, pathlib.Path(name) / "foreign.glb")
                bad += bool(problems)
                told.append(told_row(title, report))
                print("\n".join(f"BAD {title}: {problem}" for problem in problems) or f"{title}: as told within the goals")
                continue
            try:
                result, problems = check(arguments.program, reader, arguments.data, pathlib.Path(name), pair, arguments.pictures)
            except (RuntimeError, subprocess.CalledProcessError) as problem:
                result, problems = None, [str(getattr(problem, "stderr", None) or problem)]
            bad += bool(problems)
            for problem in problems:
                print(f"BAD {title}: {problem}")
            if result:
                print("| {} | {stands} | {slide:.2f} | {under:.1f} | {median:.1f}, {angle:.1f} | {reach:.1f} |".format(title, **result))
                if result["report"]:
                    told.append(told_row(title, result["report"]))
    print("\nAs told (source, mapped, result): slide, contact, inside, deepest, held, floor, hands")
    print("\n".join(told))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
