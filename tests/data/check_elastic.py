#!/usr/bin/env python3
"""Gives the limbs of every biped of a data folder weight and has three.js and the Khronos validator read the result.

    check_elastic.py PROGRAM DUMP_VERTICES DATA_FOLDER [FILE...]

For idle, walk, run, jump and kick, the clips in which the hips or hands move most, and one with a trail on top:
- every vertex against the program's own, at frames and half frames (1e-4 of the height);
- a foot that stands, by three.js, where it stood in the source (1e-3 of the height);
- limbs between half and twice their length, and as long as the report says, least and most, by three.js (1e-3);
- in idle, walk, run, jump and kick no vertex lower than the lowest of the source at that time, and where the source touches the ground the result does too
  (CONTACT_TOLERANCE of the body, along whichever axis it is largest: a dragon's tail of two and a half times its height sags too);
- no vertex that is thrown harder from frame to frame than the hardest of the source (by half of it, and 2e-3 of the height):
  nothing jitters;
- no error or warning of the validator that the source did not have.
"""

import json
import math
import pathlib
import sys
import tempfile

from check_exaggeration import FOLDERS, VERTEX_TOLERANCE, VERTICES_A_MESH, Reader, accelerations, clip_motion, misses, run, reaches_out

FOOT_TOLERANCE = 1e-3
LENGTH_TOLERANCE = 1e-3  # of what was said
CONTACT_TOLERANCE = 5e-3
CLIP_WORDS = ("idle", "walk", "run", "jump", "kick")
FEWEST_FRAMES_A_SECOND = 24
LONGEST_MEASURED = 400  # frames
JITTER_ROOM = 1.5
JITTER_SLACK = 2e-3
CLIPS_A_FILE = 5
IN_THE_AIR = ("fly", "glide", "flap")  # names of clips in which feet that rest do not stand


def standing_frames(program, file, clip, limb, height):
    """Frames at which the limb's end rests: it moves less than a thousandth of the height over seven frames, near its lowest."""
    trail = json.loads(run(program, "trail", file, "--limb", limb, "--clip", f"#{clip}", "--range", "0:100000", "--json"))
    points = {round(frame, 3): point for frame, point in zip(trail["frames"], trail["points"]) if abs(frame - round(frame)) < 1e-3}
    lowest = min(point[1] for point in points.values())
    frames = []
    for frame, point in points.items():
        around = [points.get(frame + d) for d in (-3, -2, -1, 1, 2, 3)]
        if None not in around and point[1] - lowest < 0.01 * height and all(math.dist(point, p) < 1e-3 * height for p in around):
            frames.append(frame)
    return frames[:: max(1, len(frames) // 6)]


def named_clips(info):
    """For each word the first clip that is named by it and moves."""
    clips = []
    for word in CLIP_WORDS:
        fitting = [i for i, clip in enumerate(info["clips"]) if word in clip["name"].lower() and clip["seconds"] > 0.1]
        clips += fitting[:1]
    return clips


def largest_extent(shapes):
    """Of the vertices of all meshes, along the axis on which it is largest."""
    return max(max(max(shape[axis::3]) for shape in shapes) - min(min(shape[axis::3]) for shape in shapes) for axis in range(3))


class Check:
    def __init__(self, program, dump, data):
        self.program, self.dump, self.data = program, dump, data
        self.reader = Reader()
        self.passed, self.failed, self.worst, self.worst_foot = 0, 0, 0.0, 0.0
        self.worst_length, self.worst_drop, self.worst_contact, self.limbs_measured = 0.0, 0.0, 0.0, 0

    def feet(self, file, output, info, clip, limbs, problems):
        fps, height = info["clips"][clip]["fps"], info["height"]
        if any(word in info["clips"][clip]["name"].lower() for word in IN_THE_AIR):
            return
        for limb in limbs:
            if "leg" not in limb["limb"] or limb["end"] == "estimated":
                continue
            frames = standing_frames(self.program, file, clip, limb["limb"], height)
            if not frames:
                continue
            node, times = limb["joints"][-1]["node"], [frame / fps for frame in frames]
            before = list(self.reader.measure(file, clip, times, [node], 0, keep=True)["nodes"].values())[0]
            after = list(self.reader.measure(output, clip, times, [node], 0)["nodes"].values())[0]
            for frame, a, b in zip(frames, before, after):
                miss = math.dist(a, b) / height
                self.worst_foot = max(self.worst_foot, miss)
                if miss > FOOT_TOLERANCE:
                    problems.append(f"{limb['limb']}: the foot that stands is {miss:.2e} of the height off at frame {frame:g}")
                    break

    def limb_lengths(self, file, output, info, clip, limbs, report, problems):
        """Least and most that three.js sees of each limb, bone by bone added up, over the source's."""
        fps, last = info["clips"][clip]["fps"], info["clips"][clip]["seconds"]
        steps = max(1, math.ceil(FEWEST_FRAMES_A_SECOND / fps))
        times = [i / (fps * steps) for i in range(int(last * fps * steps + 1e-3) + 1)]
        if len(times) > LONGEST_MEASURED:
            return
        for said in report:
            limb = next((limb for limb in limbs if limb["limb"] == said["limb"]), None)
            if limb is None or limb["end"] == "estimated":
                continue
            nodes = [joint["node"] for joint in limb["joints"]]
            ratios = []
            places = [list(self.reader.measure(name, clip, times, nodes, 0, keep=keep)["nodes"].values()) for name, keep in ((file, True), (output, False))]
            for k in range(len(times)):
                sums = [sum(math.dist(a[k], b[k]) for a, b in zip(nodes_of, nodes_of[1:])) for nodes_of in places]
                ratios.append(sums[1] / sums[0])
            self.limbs_measured += 1
            for key, seen in (("shortest", min(ratios)), ("longest", max(ratios))):
                miss = abs(seen - said[key])
                self.worst_length = max(self.worst_length, miss)
                if miss > LENGTH_TOLERANCE:
                    problems.append(f"{said['limb']}: {key} {said[key]:.4f} was said, three.js sees {seen:.4f}")

    def ground(self, file, output, info, clip, problems):
        """The lowest vertex, frame by frame, beside that of the source."""
        fps, last = info["clips"][clip]["fps"], info["clips"][clip]["seconds"]
        frames = range(0, int(last * fps + 1e-3) + 1, max(1, int(last * fps) // 40))
        times = [frame / fps for frame in frames]
        lowest = []
        for name, keep in ((file, True), (output, False)):
            vertices = list(self.reader.measure(name, clip, times, [], 1, keep=keep)["vertices"].values())
            lowest.append([min(min(shape[k][1::3]) for shape in vertices) for k in range(len(times))])
            if keep:
                size = largest_extent([shape[0] for shape in vertices])
        floor = min(lowest[0])
        for frame, before, after in zip(frames, *lowest):
            drop = (before - after) / size
            touches = before - floor < CONTACT_TOLERANCE * size
            self.worst_drop = max(self.worst_drop, drop)
            self.worst_contact = max(self.worst_contact, -drop if touches else 0.0)
            if drop > CONTACT_TOLERANCE or (touches and -drop > CONTACT_TOLERANCE):
                problems.append(f"frame {frame}: the lowest point is {abs(drop):.2e} of the body {'lower' if drop > 0 else 'higher'} than the source's")
                break

    def jitter(self, file, output, info, clip, step, problems):
        fps = info["clips"][clip]["fps"]
        times = [frame / fps for frame in range(min(90, int(info["clips"][clip]["seconds"] * fps) + 1))]
        if len(times) < 3:
            return
        hardest = []
        for name, keep in ((file, True), (output, False)):
            vertices = self.reader.measure(name, clip, times, [], 4 * step, keep=keep)["vertices"]
            hardest.append(max(math.hypot(*a) for index in range(1, len(times) - 1) for a in accelerations(vertices, index)) / info["height"])
        if hardest[1] > JITTER_ROOM * hardest[0] + JITTER_SLACK:
            problems.append(f"a vertex jerks by {hardest[1]:.2e} of the height a frame, {hardest[0]:.2e} in the source")

    def one(self, file, info, clip, limbs, extra, folder):
        output, problems = folder / "out.glb", []
        if extra:
            recipe = folder / "recipe.json"
            recipe.write_text(json.dumps({"version": 1, "clip": f"#{clip}", "trails": [{"limb": limbs[0]["limb"], "scale": 1.5}],
                                          "elastic": [{"limb": limb["limb"]} for limb in limbs]}))
            report = json.loads(run(self.program, "exaggerate", file, "-o", output, "--recipe", recipe, "--json"))
        else:
            report = json.loads(run(self.program, "elastic", file, "-o", output, "--clip", f"#{clip}", "--json"))
        if not extra:
            self.limb_lengths(file, output, info, clip, limbs, report["elastic"], problems)
            if clip in named_clips(info):  # an elbow on which a body lies may still sink in
                self.ground(file, output, info, clip, problems)
        for limb in report["elastic"]:
            if not 0.5 <= limb["shortest"] <= limb["longest"] <= 2.0:
                problems.append(f"{limb['limb']}: {limb['shortest']:.3g} to {limb['longest']:.3g} times its length")
        fps, last = info["clips"][clip]["fps"], info["clips"][clip]["seconds"]
        step = max(1, max(mesh["vertices"] for mesh in info["meshes"]) // VERTICES_A_MESH)
        halves = int(2 * last * fps)
        times = [half / (2 * fps) for half in range(0, halves + 1, max(1, halves // 24))]
        ours = json.loads(run(self.dump, output, clip, step, *[f"{t:.9g}" for t in times]))["vertices"]
        miss = max(misses(ours, self.reader.measure(output, clip, times, [], step)["vertices"])) / info["height"]
        self.worst = max(self.worst, miss)
        if miss > VERTEX_TOLERANCE:
            problems.append(f"a vertex is {miss:.2e} of the height off")
        if not extra:
            self.feet(file, output, info, clip, limbs, problems)
            self.jitter(file, output, info, clip, step, problems)
        problems += [f"validator: {line}" for line in self.reader.worse(output, file)]
        label = f"{file.name} {info['clips'][clip]['name']}{' with a trail' if extra else ''}"
        self.failed += bool(problems)
        self.passed += not problems
        if problems:
            print(f"FAIL {label}: {'; '.join(problems)}", flush=True)

    def file(self, file):
        info = json.loads(run(self.program, "info", file, "--json"))
        limbs = [limb for limb in info["limbs"] if reaches_out(limb) and "led_by" not in limb]
        if not limbs:
            return
        moving = sorted((clip_motion(self.program, file, clip, limbs[0]["limb"]), clip) for clip in range(len(info["clips"])))
        with tempfile.TemporaryDirectory() as name:
            for clip in sorted({clip for _, clip in moving[-CLIPS_A_FILE:]} | set(named_clips(info))):
                self.one(file, info, clip, limbs, False, pathlib.Path(name))
            if moving:
                self.one(file, info, moving[-1][1], limbs, True, pathlib.Path(name))


def main():
    if len(sys.argv) < 4:
        print(__doc__, file=sys.stderr)
        return 2
    check = Check(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]))
    files = [pathlib.Path(name) for name in sys.argv[4:]] or [file for folder in FOLDERS for file in sorted(check.data.glob(folder))]
    for file in files:
        if file.name != "valid-avatar-Asian_M_1_Busi.glb":  # needs meshopt, which is refused
            check.file(file)
    print(f"vertices {check.worst:.2e}, standing feet {check.worst_foot:.2e}, below the source {check.worst_drop:.2e}, contacts "
          f"{check.worst_contact:.2e} of the height at most; lengths of {check.limbs_measured} limbs {check.worst_length:.2e}")
    print(f"{check.passed} passed, {check.failed} failed")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
