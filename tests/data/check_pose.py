#!/usr/bin/env python3
"""Poses every biped of a data folder by each of its controllers and has three.js and the Khronos validator read the result.

    check_pose.py [--pictures FOLDER] PROGRAM DATA_FOLDER [FILE...]

In the clip in which the left arm moves most (one that stands still is added to a file without any), a limb that is found, with keys on
frames and between them:
- each controller that moves, alone: where it was asked to be, at every key (1e-4 of the height);
- the poses of pose_cases.py, among them the spine bent by 45 degrees, a hand on the other shoulder and a fist: ends where they were asked to
  be, feet that stay at every frame and half frame (1e-4), turns (1e-3 radians), and no joint that accelerates more than 1.5 times as much as the
  source and the offset together. --pictures draws each from the front and from the side;
- a hand and a foot pinned while the hips move: at one place over the range, at every frame and half frame (1e-4) and at any other time (1e-3);
- the second hand gripping the first, which moves: at the distance from it of one frame (the same);
- both hands on a bat while the left one moves: where each was on it, at every frame and half frame (2e-4);
- adjustments of nothing, saved clean: the bytes of the file saved without an edit;
- no error or warning of the validator that the source did not have.
"""

import argparse
import math
import pathlib
import random
import sys
import tempfile

import pose_cases
from check_exaggeration import Reader, run
from posed_character import Character, bipeds, with_a_bat
from vectors import place, seen_from

TOLERANCE = 1e-4  # of the height
AT_ANY_TIME = 1e-3
MOVES = {"hips": [0.03, -0.12, 0.05], "body": [0.2, 0.05, -0.1], "spine-low": [0.05, 0, 0.1], "spine-top": [0.1, -0.1, 0.3],
         "head": [0.2, 0.3, 0.4], "left-hand": [-0.15, 0.2, 0.2], "right-hand": [0.1, 0.25, -0.1],
         "left-foot": [0.05, 0.1, 0.15], "right-foot": [0, 0.15, -0.1]}
UNCHANGED = [{"controller": "hips", "keys": [{"frame": 0, "move": [0, 0, 0]}]}, {"attribute": "left-arm.stretch", "keys": [{"frame": 0, "value": 0.4}]}]


def controller_problems(character, folder, controller):
    node = character.joints.get("hips" if controller == "body" else controller)
    if node is None:
        return []
    output, report = character.pose(folder, [{"controller": controller, "keys": character.keys(move=MOVES[controller])}])
    keys = report["controllers"][0]["keys"]
    problems = [f"{controller}: {problem}" for problem in character.reader.worse(output, character.file)]
    for key, there in zip(keys, character.places(output, node, [key["frame"] for key in keys])):
        miss = math.dist(there, key["asked"]) / character.height
        if miss > TOLERANCE:
            problems.append(f"{controller} is {miss:.2e} of the height from where it was asked to be at frame {key['frame']:g}")
    return problems


def draw(character, case, output, pictures):
    for view in ("front", "side"):
        picture = pictures / f"{character.file.stem}-{case.name.replace(' ', '-')}-{view}.png"
        run(character.program, "render", output, "-o", picture, "--clip", f"#{character.clip}", "--frame", character.full, "--view", view, "--size", "480x480")


def case_problems(character, folder, maker, pictures):
    case = maker(character, folder)
    if case is None:
        return []
    output, _ = character.pose(folder, case.adjustments, **case.lists)
    if pictures:
        draw(character, case, output, pictures)
    return [f"{case.name}: {problem}" for problem in case.check(output) + pose_cases.spikes(character, output)]


def half_frames(first, last):
    return [half / 2 for half in range(2 * first, 2 * last + 1)]


def any_frames(first, last):
    """Where a player of another rate asks: 60 and 144 pictures a second of a clip of 24, and times by chance."""
    chance = random.Random(3)
    return [first] + [first + i * step for step in (24 / 60, 24 / 144) for i in range(int((last - first) / step))] + [
        chance.uniform(first, last) for _ in range(100)]


def pin_problems(character, folder, limb, controller):
    first, last = character.last // 4, max(character.last // 4 + 1, character.last * 3 // 4)
    if controller not in character.joints or "hips" not in character.joints:
        return []
    low = [{"controller": "hips", "keys": character.keys(move=[0.05, -0.05, 0.05])}]
    output, _ = character.pose(folder, low, pins=[{"limb": limb, "range": [first, last], "blend": [2, 2]}])
    problems = []
    for frames, tolerance in ((half_frames(first, last), TOLERANCE), (any_frames(first, last), AT_ANY_TIME)):
        places = character.places(output, character.joints[controller], frames)
        miss = max(math.dist(there, places[0]) for there in places) / character.height
        problems += [f"pinned {controller} strays by {miss:.2e} of the height, more than {tolerance}"] if miss > tolerance else []
    return problems


def grip_problems(character, folder):
    if "left-hand" not in character.joints or "right-hand" not in character.joints:
        return []
    moved = [{"controller": "left-hand", "keys": character.keys(move=MOVES["left-hand"])}]
    grip = {"leader": "left-arm", "follower": "right-arm", "range": [0, character.last], "relation": 0}

    def distances(file, frames):
        hands = [character.places(file, character.joints[hand], frames) for hand in ("left-hand", "right-hand")]
        return [math.dist(a, b) for a, b in zip(*hands)]

    # Both poses are written to one place: each is measured before the next.
    kept = distances(character.pose(folder, moved)[0], [0])[0]
    gripped = character.pose(folder, moved, grips=[grip])[0]
    problems = []
    for frames, tolerance in ((half_frames(0, character.last), TOLERANCE), (any_frames(0, character.last), AT_ANY_TIME)):
        miss = max(abs(distance - kept) for distance in distances(gripped, frames)) / character.height
        problems += [f"the gripping hand strays by {miss:.2e} of the height, more than {tolerance}"] if miss > tolerance else []
    return problems


def bat_problems(plain, folder, pictures):
    if "left-hand" not in plain.joints or "right-hand" not in plain.joints:
        return []
    character = Character(plain.program, plain.reader, with_a_bat(plain.file, plain.height, folder / "with_a_bat.gltf"), folder)
    bat = next(index for index, node in enumerate(character.gltf["nodes"]) if node.get("name") == "Bat")
    hands = [character.joints["left-hand"], character.joints["right-hand"]]
    both = {"node": "Bat", "bound_at": 0, "hands": {limb: [{"frame": 0, "value": 1}] for limb in ("left-arm", "right-arm")}}
    moved = [{"controller": "left-hand", "keys": character.keys(move=[0.1, 0.1, 0.1])},
             {"controller": "hips", "keys": character.keys(move=[0.05, -0.05, 0.05])}]
    case = pose_cases.Case("both hands on a bat", moved, None)
    output, _ = character.pose(folder, moved, props=[both])
    if pictures:
        draw(plain, case, output, pictures)
    worlds = character.worlds(output, [bat] + hands, half_frames(0, character.last))
    problems = [f"the bat: {problem}" for problem in character.reader.worse(output, character.file)]
    for hand, name in zip(hands, ("left-hand", "right-hand")):
        seen = [seen_from(thing, place(end)) for thing, end in zip(worlds[bat], worlds[hand])]
        miss = max(math.dist(seen[0], there) for there in seen) / character.height
        # What carries the hand, the arm and the bat are keyed apart: each may be off by a third of the tolerance, in turn.
        problems += [f"{name} strays on the bat by {miss:.2e} of the height"] if miss > 2 * TOLERANCE else []
    return problems


def unchanged_problems(character, folder):
    unchanged = [a for a in UNCHANGED if a.get("controller") in character.controllers or a.get("attribute") in character.attributes]
    if not unchanged or character.file.suffix == ".gltf":
        return []
    output, _ = character.pose(folder, unchanged)
    unedited = folder / "unedited.glb"
    run(character.program, "resave", character.file, "-o", unedited)
    return ["adjustments of nothing change the file"] if output.read_bytes() != unedited.read_bytes() else []


def problems_of(character, folder, pictures):
    problems = []
    for controller in MOVES:
        if controller in character.controllers:
            problems += controller_problems(character, folder, controller)
    for maker in pose_cases.CASES:
        problems += case_problems(character, folder, maker, pictures)
    problems += pin_problems(character, folder, "left-arm", "left-hand") + pin_problems(character, folder, "right-leg", "right-foot")
    problems += grip_problems(character, folder) + bat_problems(character, folder, pictures)
    return problems + unchanged_problems(character, folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("files", nargs="*", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--pictures", type=pathlib.Path, help="where to draw the poses")
    arguments = parser.parse_args()
    if arguments.pictures:
        arguments.pictures.mkdir(parents=True, exist_ok=True)
    program, reader, bad = arguments.program.resolve(), Reader(), 0
    for file in arguments.files or list(bipeds(program, arguments.data)):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            problems = problems_of(Character(program, reader, file, folder), folder, arguments.pictures)
        print(f"{file.name}: {len(problems)} problems", flush=True)
        for problem in problems:
            print(f"  {problem}")
        bad += len(problems)
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
