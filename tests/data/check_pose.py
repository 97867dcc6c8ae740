#!/usr/bin/env python3
"""Poses every biped of a data folder by each of its controllers and has three.js and the Khronos validator read the result.

    check_pose.py PROGRAM DATA_FOLDER [FILE...]

In the clip in which the left arm moves most, a limb that is found, with keys on frames and between them:
- each controller that moves, alone: where it was asked to be, at every key (1e-4 of the height);
- hips lowered by a tenth of the height, and the spine bent: both feet where the source has them, at every frame and half frame (1e-4);
- a hand and a foot pinned while the hips move: at one place over the range, at every frame and half frame (1e-4);
- the second hand gripping the first, which moves: at the distance from it of one frame (1e-4);
- adjustments of nothing, saved clean: the bytes of the file saved without an edit;
- no error or warning of the validator that the source did not have.
"""

import json
import math
import pathlib
import sys
import tempfile

from check_exaggeration import Reader, clip_motion, run

TOLERANCE = 1e-4  # of the height
MOST_FRAMES = 24
MOVES = {"hips": [0.03, -0.12, 0.05], "body": [0.2, 0.05, -0.1], "spine-low": [0.05, 0, 0.1], "spine-top": [0.1, -0.1, 0.3],
         "head": [0.2, 0.3, 0.4], "left-hand": [-0.15, 0.2, 0.2], "right-hand": [0.1, 0.25, -0.1],
         "left-foot": [0.05, 0.1, 0.15], "right-foot": [0, 0.15, -0.1]}
UNCHANGED = [{"controller": "hips", "keys": [{"frame": 0, "move": [0, 0, 0]}]}, {"attribute": "left-arm.stretch", "keys": [{"frame": 0, "value": 0.4}]}]


class Character:
    def __init__(self, program, reader, file):
        self.program, self.reader, self.file = program, reader, file
        self.info = json.loads(run(program, "info", file, "--json"))
        self.height = self.info["height"]
        limbs = [limb["limb"] for limb in self.info["limbs"]]
        moving = "left-arm" if "left-arm" in limbs else limbs[0]
        self.clip = max(range(len(self.info["clips"])), key=lambda clip: clip_motion(program, file, clip, moving))
        clip = self.info["clips"][self.clip]
        self.fps, self.last = clip["fps"], min(int(clip["seconds"] * clip["fps"] + 1e-3), MOST_FRAMES)
        self.joints = {c["controller"]: c["joint"]["node"] for c in self.info["controllers"] if "controller" in c and "joint" in c}

    def pose(self, folder, adjustments, *more, **holds):
        recipe = folder / "recipe.json"
        recipe.write_text(json.dumps({"version": 1, "adjustments": adjustments, **holds}))
        output = folder / f"posed{self.file.suffix if self.file.suffix == '.gltf' else '.glb'}"
        report = run(self.program, "pose", self.file, "-o", output, "--recipe", recipe, "--clip", f"#{self.clip}", "--clean", "--json", *more)
        return output, json.loads(report)

    def places(self, file, node, frames):
        times = [frame / self.fps for frame in frames]
        return list(self.reader.measure(file, self.clip, times, [node], 1000)["nodes"].values())[0]

    def keys(self, **offset):
        frames = sorted({0, self.last / 2, self.last / 3 + 0.5, self.last} if self.last > 2 else {0, self.last})
        return [{"frame": frame, **offset} for frame in frames]


def controller_problems(character, folder, controller):
    node = character.joints.get("hips" if controller == "body" else controller)
    if node is None:
        return []
    output, report = character.pose(folder, [{"controller": controller, "keys": character.keys(move=MOVES[controller])}])
    keys = report["controllers"][0]["keys"]
    problems = [f"{controller}: {problem}" for problem in character.reader.worse(output, character.file)]
    for key, place in zip(keys, character.places(output, node, [key["frame"] for key in keys])):
        miss = math.dist(place, key["asked"]) / character.height
        if miss > TOLERANCE:
            problems.append(f"{controller} is {miss:.2e} of the height from where it was asked to be at frame {key['frame']:g}")
    return problems


def foot_problems(character, folder, adjustment, words):
    output, _ = character.pose(folder, [adjustment])
    frames = [half / 2 for half in range(2 * character.last + 1)]
    problems = []
    for foot in ("left-foot", "right-foot"):
        if foot in character.joints:
            node = character.joints[foot]
            before, after = character.places(character.file, node, frames), character.places(output, node, frames)
            miss = max(math.dist(a, b) for a, b in zip(before, after)) / character.height
            if miss > TOLERANCE:
                problems.append(f"{foot} slides by {miss:.2e} of the height with {words}")
    return problems


def half_frames(first, last):
    return [half / 2 for half in range(2 * first, 2 * last + 1)]


def pin_problems(character, folder, limb, controller):
    first, last = character.last // 4, max(character.last // 4 + 1, character.last * 3 // 4)
    if controller not in character.joints or "hips" not in character.joints:
        return []
    low = [{"controller": "hips", "keys": character.keys(move=[0.05, -0.05, 0.05])}]
    output, _ = character.pose(folder, low, pins=[{"limb": limb, "range": [first, last], "blend": [2, 2]}])
    places = character.places(output, character.joints[controller], half_frames(first, last))
    miss = max(math.dist(place, places[0]) for place in places) / character.height
    return [f"pinned {controller} strays by {miss:.2e} of the height"] if miss > TOLERANCE else []


def grip_problems(character, folder):
    if "left-hand" not in character.joints or "right-hand" not in character.joints:
        return []
    moved = [{"controller": "left-hand", "keys": character.keys(move=MOVES["left-hand"])}]
    grip = {"leader": "left-arm", "follower": "right-arm", "range": [0, character.last], "relation": 0}
    frames = half_frames(0, character.last)

    def distances(file):
        hands = [character.places(file, character.joints[hand], frames) for hand in ("left-hand", "right-hand")]
        return [math.dist(a, b) for a, b in zip(*hands)]

    # Both poses are written to one place: each is measured before the next.
    kept = distances(character.pose(folder, moved)[0])[0]
    gripped = distances(character.pose(folder, moved, grips=[grip])[0])
    miss = max(abs(distance - kept) for distance in gripped) / character.height
    return [f"the gripping hand strays by {miss:.2e} of the height"] if miss > TOLERANCE else []


def problems_of(character, folder):
    names = {c["controller"] for c in character.info["controllers"] if "controller" in c}
    problems = []
    for controller in MOVES:
        if controller in names:
            problems += controller_problems(character, folder, controller)
    if "hips" in names:
        legs = [limb["rest_length"] for limb in character.info["limbs"] if limb["limb"] == "left-leg"]
        down = 0.1 * character.height / legs[0] if legs else 0.1
        problems += foot_problems(character, folder, {"controller": "hips", "keys": [{"frame": 0, "move": [0, -down, 0]}]}, "lowered hips")
    if "spine-top" in names:
        bent = {"controller": "spine-top", "keys": [{"frame": 0, "move": [0, -0.15, 0.5], "turn": [45, 0, 0]}]}
        problems += foot_problems(character, folder, bent, "a bent spine")
    problems += pin_problems(character, folder, "left-arm", "left-hand") + pin_problems(character, folder, "right-leg", "right-foot")
    problems += grip_problems(character, folder)
    unchanged = [a for a in UNCHANGED if a.get("controller") in names or "left-hand" in names and "attribute" in a]
    if unchanged and character.file.suffix != ".gltf":
        output, _ = character.pose(folder, unchanged)
        unedited = folder / "unedited.glb"
        run(character.program, "resave", character.file, "-o", unedited)
        if output.read_bytes() != unedited.read_bytes():
            problems.append("adjustments of nothing change the file")
    return problems


def bipeds(program, folder):
    for file in sorted([*folder.glob("biped/**/*.gl*"), *folder.glob("vrm/*.vrm")]):
        info = json.loads(run(program, "info", file, "--json"))
        if info.get("clips") and info["limbs"]:
            yield file


def main():
    program, data = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    files = [pathlib.Path(file) for file in sys.argv[3:]] or list(bipeds(program, data))
    reader, bad = Reader(), 0
    for file in files:
        with tempfile.TemporaryDirectory() as folder:
            character = Character(program, reader, file)
            problems = problems_of(character, pathlib.Path(folder))
        print(f"{file.name}: {len(problems)} problems", flush=True)
        for problem in problems:
            print(f"  {problem}")
        bad += len(problems)
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
