#!/usr/bin/env python3
"""Exaggerates the liveliest clips of every body of a data folder in the built-in styles and has three.js look at what was saved.

    check_auto.py [--all-styles] PROGRAM DATA_FOLDER [FILE...]

For each file the two clips with the strongest moments, each in the styles in turn (--all-styles: in each of them):
- no limb's end and no vertex lower than the lowest of the source in the clip (FLOOR of the height), on every frame, of a
  body that is not in the air: one whose source's wings end far below the ground, y = 0, and its feet (FLIGHT of the height), on
  BEATS of the frames or more (StandingFloor::flies asks as well that they beat, and that no foot stands);
- no limb longer than the style's largest scale of its own length, or of the source's where that is more;
- a clip whose last pose is its first still closes (1 cm and 0.1 m/s of a person more than in the source);
- trails of one limb share no time, and each moment has a trail or says why not;
- of two trails that warn nothing is left unsaid: warnings are those that EXPLAINED names;
- the same command twice writes the same bytes (of the first clip of each file).
"""

import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

from check_exaggeration import Reader, points_of, run

FOLDERS = ("biped/*.glb", "quadruped/*.glb", "bodies/*-animations.glb", "hard/*.glb")
STYLES = ("Duck Amuck", "Fast and Furry-ous", "Tortoise Wins", "Piggy Bank", "Stop! Look!", "Opera", "Average", "Rubber hose", "Snappy", "Subtle", "Heavy")
CLIPS_A_FILE = 2
FLOOR = 0.01  # of the height: joints are looked at by the program, a vertex below them is not
FLIGHT = 0.1  # likewise
BEATS = 0.25
LENGTH_SLACK = 1.02
SEAM_METRES = 0.01
SEAM_SPEED = 0.1
LEAST_SECONDS = 1 / 120  # beside the seam: what keys are off, a ten thousandth of the height, makes no speed
PERSON = 1.75
VERTICES_A_MESH = 60
MOST_FRAMES = 90
EXPLAINED = (r"stays where it is", r"hangs on|stays behind|left behind", r"of the mesh")


def liveliest(program, file):
    """Indices of the clips with the strongest moments."""
    clips = json.loads(run(program, "moments", file, "--all-clips", "--json"))
    clips = clips["clips"] if isinstance(clips, dict) else clips
    strength = [max((moment["strength"] for moment in clip["moments"]), default=0.0) for clip in clips]
    order = sorted(range(len(clips)), key=lambda i: -strength[i])
    return [i for i in order if strength[i] > 0.0][:CLIPS_A_FILE]


def most_of(program, style):
    """The largest scale of each kind of limb, by the program's own description of the style."""
    return json.loads(run(program, "styles", "--style", style, "--json"))


def kind_of(limb):
    for word in ("arm", "leg"):
        if limb.endswith(word) or re.search(rf"{word}(-\d+)?$", limb):
            return word
    return "torso" if limb in ("spine", "neck") else "other"


class Case:
    def __init__(self, reader, program, file, info, clip, style, folder):
        self.reader, self.file, self.info, self.clip = reader, file, info, clip
        self.problems = []
        self.output = folder / "auto.glb"
        command = (program, "exaggerate", file, "-o", self.output, "--auto", "--style", style, "--clip", f"#{clip}", "--json")
        self.report = json.loads(run(*command))["clips"][0]
        self.style = most_of(program, style)
        facts = info["clips"][clip]
        self.fps, self.last = facts["fps"], int(facts["seconds"] * facts["fps"] + 1e-6)
        self.height = info["height"]

    def check(self):
        self.check_report()
        step = max(1, math.ceil(self.last / MOST_FRAMES))
        frames = list(range(0, self.last + 1, step))
        nodes = sorted({node for limb in self.info["limbs"] for node in (limb["joints"][0]["node"], limb["joints"][-1]["node"])})
        vertices = max(1, max((mesh["vertices"] for mesh in self.info["meshes"]), default=1) // VERTICES_A_MESH)
        times = [frame / self.fps for frame in frames]
        end = self.info["clips"][self.clip]["seconds"]
        self.beside_seam = max(0.25 / self.fps, LEAST_SECONDS)
        times += [self.beside_seam, end - self.beside_seam, end]
        before, after = (self.measure(file, times, nodes, vertices) for file in (self.file, self.output))
        self.metre = self.size_of(before) / PERSON
        self.check_floor(before, after, frames)
        self.check_lengths(before, after, frames)
        self.check_seam(before, after, len(frames))
        return self.problems

    def measure(self, file, times, nodes, vertices):
        """Places of nodes by their index, and of vertices."""
        measured = self.reader.measure(file, self.clip, times, nodes, vertices)
        return {"vertices": measured["vertices"], "nodes": dict(zip(nodes, measured["nodes"].values()))}

    def size_of(self, measured):
        """The largest extent at the first frame: the height says little of a snake."""
        points = [point for key in measured["vertices"] for point in points_of(measured["vertices"][key], 0)]
        return max([self.height] + [max(axis) - min(axis) for axis in zip(*points)])

    def check_report(self):
        by_limb = {}
        for trail in self.report["trails"]:
            by_limb.setdefault(trail["limb"], []).append(trail["range"])
            for warning in trail["warnings"]:
                if not any(re.search(pattern, warning) for pattern in EXPLAINED):
                    self.problems.append(f"warning: {warning}")
        for limb, ranges in by_limb.items():
            ranges.sort()
            for (_, first), (second, _) in zip(ranges, ranges[1:]):
                if second < first - 1e-6:
                    self.problems.append(f"two trails of {limb} overlap")
        for moment in self.report["moments"]:
            if not moment["exaggerated"] and not moment.get("why"):
                self.problems.append(f"nothing says why {moment['limb']} at {moment['start']:g} was left out")

    def check_floor(self, before, after, frames):
        lowest = math.inf
        found = math.inf
        for key in before["vertices"]:
            for index in range(len(frames)):
                lowest = min([lowest] + [point[1] for point in points_of(before["vertices"][key], index)])
                found = min([found] + [point[1] for point in points_of(after["vertices"][key], index)])
        for node in before["nodes"]:
            lowest = min([lowest] + [point[1] for point in before["nodes"][node]])
            found = min([found] + [point[1] for point in after["nodes"][node]])
        if not self.flies(before, frames) and found < lowest - FLOOR * self.height:
            self.problems.append(f"{(lowest - found) / self.height:.1%} of the height below the source's lowest place")

    def flies(self, before, frames):
        """Wings and legs by the last joint of each."""
        ends = {word: [before["nodes"][limb["joints"][-1]["node"]] for limb in self.info["limbs"] if word in limb["limb"]] for word in ("wing", "leg")}
        at = lambda word, index: min((points[index][1] for points in ends[word]), default=math.inf)
        below = sum(at("wing", index) < min(0.0, at("leg", index)) - FLIGHT * self.height for index in range(len(frames)))
        return below > 0 and below >= BEATS * len(frames)

    def check_lengths(self, before, after, frames):
        for limb in self.info["limbs"]:
            if limb["end"] == "estimated":
                continue
            first, last = (limb["joints"][i]["node"] for i in (0, -1))
            most = self.style[f"{kind_of(limb['limb'])}_most"]
            for index, frame in enumerate(frames):
                own = max(math.dist(before["nodes"][first][index], before["nodes"][last][index]), limb["rest_length"])
                now = math.dist(after["nodes"][first][index], after["nodes"][last][index])
                if now > LENGTH_SLACK * most * own + FLOOR * self.height:
                    self.problems.append(f"{limb['limb']} is {now / own:.2f} times its length at frame {frame}, of {most:g}")
                    break

    def check_seam(self, before, after, count):
        """Of the nodes that are measured; times are followed by one a little after the first, one before the last, and the last."""
        first, after_first, before_last, last = 0, count, count + 1, count + 2
        gap = lambda points: math.dist(points[first], points[last])
        if max((gap(points) for points in before["nodes"].values()), default=0.0) > FLOOR * self.height:
            return  # no loop, or one that travels
        turn = lambda points: math.dist([a - b for a, b in zip(points[last], points[before_last])],
                                        [a - b for a, b in zip(points[after_first], points[first])]) / self.beside_seam
        for node, points in after["nodes"].items():
            source = before["nodes"][node]
            if gap(points) - gap(source) > SEAM_METRES * self.metre:
                self.problems.append(f"the seam is {(gap(points) - gap(source)) / self.metre:.3f} m wider at node {node}")
            if turn(points) - turn(source) > SEAM_SPEED * self.metre:
                self.problems.append(f"the seam is {(turn(points) - turn(source)) / self.metre:.2f} m/s rougher at node {node}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--all-styles", action="store_true")
    parser.add_argument("program")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    arguments = parser.parse_args()
    files = arguments.files or sorted(file for folder in FOLDERS for file in arguments.data.glob(folder))
    reader, failed, cases, turn = Reader(), 0, 0, 0
    made = left = 0
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            try:
                info = json.loads(run(arguments.program, "info", file, "--json"))
            except RuntimeError as problem:
                print(f"{file.name}: not looked at: {problem}")
                continue
            for clip in liveliest(arguments.program, file) if info["clips"] else []:
                styles = STYLES if arguments.all_styles else [STYLES[turn % len(STYLES)]]
                for style in styles:
                    case = Case(reader, arguments.program, file, info, clip, style, pathlib.Path(folder))
                    problems = case.check()
                    cases += 1
                    made += sum(moment["exaggerated"] for moment in case.report["moments"])
                    left += sum(not moment["exaggerated"] for moment in case.report["moments"])
                    failed += bool(problems)
                    for problem in problems:
                        print(f"{file.name} {info['clips'][clip]['name']} in {style}: {problem}")
                turn += 1
    print(f"auto: {cases} clips in a style, {made} moments exaggerated, {left} left out and told why, {failed} clips with problems")
    return 1 if failed or cases == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
