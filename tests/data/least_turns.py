#!/usr/bin/env python3
"""How many of the turns that check_turns.py counts any choice of a leg's plane would leave.

    least_turns.py PROGRAM FILE...

Base, knee and end of a leg fix its bones but for one angle, that of its plane about the line from base to end. For each clip and case of
check_turns.py that angle is chosen anew at every frame, within a quarter turn of what the program made and in steps of 2.5 degrees, so that the bones
turn too far as little as can be: by dynamic programming over the whole clip. What is left then no rule could spare. Needs numpy.
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

import numpy

from check_turns import ALLOWED_DEGREES, ALLOWED_FACTOR, Leg, Turns, cases, direction, multiplied

ANGLES = numpy.radians(numpy.arange(-90.0, 90.1, 2.5))
SLACK = 0.2  # degrees: what the steps of the angle may miss


def turned_about(lines, worlds):
    """World rotations of a bone at each frame, turned about the leg's line by each angle: frames x angles x 4."""
    half = ANGLES[None, :, None] / 2.0
    turns = numpy.concatenate([lines[:, None, :] * numpy.sin(half), numpy.broadcast_to(numpy.cos(half), (len(lines), len(ANGLES), 1))], axis=-1)
    parts = multiplied(numpy.moveaxis(turns, -1, 0), numpy.moveaxis(worlds[:, None, :], -1, 0))
    return numpy.stack(parts, axis=-1)


def between_all(before, now):
    """Degrees from each rotation to each other one."""
    return numpy.degrees(2.0 * numpy.arccos(numpy.clip(numpy.abs(before @ now.T), 0.0, 1.0)))


def least(rotations, allowed):
    """The number of turns too far on the way of angles on which they are too far by the least squares."""
    frames = len(next(iter(rotations.values())))
    stays = 1e-4 * numpy.degrees(ANGLES) ** 2
    goes = 1e-2 * numpy.degrees(ANGLES[:, None] - ANGLES[None, :]) ** 2
    cost, back = stays.copy(), []
    for frame in range(frames - 1):
        step = goes.copy()
        for joint, turns in rotations.items():
            step += numpy.maximum(0.0, between_all(turns[frame], turns[frame + 1]) - allowed[joint][frame]) ** 2
        total = cost[:, None] + step
        back.append(total.argmin(axis=0))
        cost = total.min(axis=0) + stays
    way = [int(cost.argmin())]
    for before in reversed(back):
        way.append(int(before[way[-1]]))
    way.reverse()
    return sum(bool(between_all(turns[i][[way[i]]], turns[i + 1][[way[i + 1]]])[0, 0] > allowed[joint][i] + SLACK)
               for joint, turns in rotations.items() for i in range(frames - 1))


def of_clip(program, file, info, clip, folder):
    """Turns too far of the bones of legs as the program made them, and the least number of them."""
    legs = [[joint["node"] for joint in limb["joints"]] for limb in info["limbs"] if limb["limb"].endswith("-leg")]
    times = [frame / info["clips"][clip]["fps"] for frame in range(int(info["clips"][clip]["seconds"] * info["clips"][clip]["fps"] + 1e-3) + 1)]
    source = Turns(file, clip)
    made = spared = 0
    for _, adjustment in cases(info):
        recipe, output = folder / "recipe.json", folder / "posed.glb"
        recipe.write_text(json.dumps({"version": 1, "units": "metres", "adjustments": [adjustment]}))
        subprocess.run([program, "pose", file, "-o", output, "--recipe", recipe, "--clip", f"#{clip}", "--clean"], capture_output=True, check=True)
        posed = Turns(output, clip)
        for leg in legs:
            allowed = {joint: [ALLOWED_FACTOR * turn + ALLOWED_DEGREES for turn in source.steps(joint, times)] for joint in leg[:2]}
            count = sum(now > most for joint in leg[:2] for now, most in zip(posed.steps(joint, times), allowed[joint]))
            if count > 0:
                lines = numpy.array([direction(points[0], points[-1]) for points in Leg(posed, leg, times).points])
                rotations = {joint: turned_about(lines, numpy.array([posed.world(joint, time) for time in times])) for joint in leg[:2]}
                made, spared = made + count, spared + count - min(count, least(rotations, allowed))
    return made, made - spared


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        for file in arguments.files:
            info = json.loads(subprocess.run([arguments.program, "info", file, "--json"], capture_output=True, text=True, check=True).stdout)
            counts = [of_clip(arguments.program, file, info, clip, pathlib.Path(temporary)) for clip in range(len(info["clips"]))]
            print(f"{file.name}: {sum(made for made, _ in counts)} turns too far, {sum(left for _, left in counts)} whatever the planes of the legs", flush=True)


if __name__ == "__main__":
    main()
