#!/usr/bin/env python3
"""Exaggerates every limb of every biped of a data folder and has three.js and the Khronos validator read the result.

    check_exaggeration.py PROGRAM DUMP_VERTICES DATA_FOLDER [FILE...]

For each arm and leg that moves, with the default range and with the whole clip, scale 2 and scale 3 without Y:
- the limb's length at the tip, measured by three.js, against S times the source's (1e-4 of it), and against what was said;
- every vertex against the program's own, on frames of range and release (1e-4 of the height);
- every vertex outside range and release against the source (1e-6 of the height);
- no error or warning of the validator that the source did not have.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

READERS = pathlib.Path(__file__).resolve().parent / "readers"
LENGTH_TOLERANCE = 1e-4
VERTEX_TOLERANCE = 1e-4
OUTSIDE_TOLERANCE = 1e-6
LIMBS = ("left-arm", "right-arm", "left-leg", "right-leg")
SETTINGS = (("scale 2", ["--scale", "2"], 2.0), ("scale 3 xz", ["--scale", "3", "--axes", "xz"], 3.0))
CLIPS_A_FILE = 2
VERTICES_A_MESH = 150


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


def distance(a, b):
    return math.dist(a, b)


def clip_motion(program, file, clip, limb):
    """How far the limb's end travels from its base in a clip, by the program's own trail."""
    trail = json.loads(run(program, "trail", file, "--limb", limb, "--clip", f"#{clip}", "--json"))
    reach = [[p - q for p, q in zip(point, base)] for point, base in zip(trail["points"], trail["base"])]
    return max(distance(reach[0], other) for other in reach)


def measure(file, clip, times, nodes, step):
    command = ["node", READERS / "measure.mjs", file, "--clip", f"#{clip}", "--times", ",".join(f"{t:.9g}" for t in times)]
    if nodes:
        command += ["--nodes", ",".join(f"#{node}" for node in nodes)]
    if step:
        command += ["--vertices", step]
    return json.loads(run(*command))


def largest_miss(ours, theirs):
    """Largest distance of matching vertices, and the index of the time at which it is."""
    worst, when = 0.0, 0
    for key, frames in theirs.items():
        for index, (a, b) in enumerate(zip(ours[key], frames)):
            for i in range(0, len(b), 3):
                miss = math.dist(a[i:i + 3], b[i:i + 3])
                if not miss <= worst:
                    worst, when = miss, index
    return worst, when


def length(measured, base, end):
    nodes = list(measured["nodes"].values())
    return [distance(a, b) for a, b in zip(nodes[base], nodes[end])]


class Check:
    def __init__(self, program, dump, data):
        self.program, self.dump, self.data = program, dump, data
        self.passed, self.failed, self.warned = 0, 0, 0

    def tell(self, label, problems):
        if problems:
            self.failed += 1
            print(f"FAIL {label}: {'; '.join(problems)}", flush=True)
        else:
            self.passed += 1

    def one(self, file, info, clip, limb, label, arguments, scale, folder):
        output = folder / "out.glb"
        report = json.loads(run(self.program, "exaggerate", file, "-o", output, "--clip", f"#{clip}", "--limb", limb["limb"], "--json",
                                *arguments))["trails"][0]
        fps, last = info["clips"][clip]["fps"], info["clips"][clip]["seconds"]
        start, end = report["range"]
        stop = min(end + report["release"], last * fps)
        inside = sorted({round(2 * (start + (stop - start) * i / 12)) / 2 for i in range(13)} | {end})
        outside = [frame for frame in range(int(last * fps) + 1) if frame > stop + 1e-3 or frame < start - 1e-3]
        outside = outside[:: max(1, len(outside) // 6)]
        problems = []
        self.lengths(file, output, clip, limb, report, scale, end / fps, problems)
        step = max(1, max(mesh["vertices"] for mesh in info["meshes"]) // VERTICES_A_MESH)
        times = [frame / fps for frame in inside]
        ours = json.loads(run(self.dump, output, clip, step, *[f"{t:.9g}" for t in times]))["vertices"]
        miss, when = largest_miss(ours, measure(output, clip, times, [], step)["vertices"])
        if miss > VERTEX_TOLERANCE * info["height"]:
            problems.append(f"a vertex is {miss / info['height']:.2e} of the height off at frame {inside[when]:g}")
        if outside:
            times = [frame / fps for frame in outside]
            miss, when = largest_miss(measure(file, clip, times, [], step)["vertices"], measure(output, clip, times, [], step)["vertices"])
            if miss > OUTSIDE_TOLERANCE * info["height"]:
                problems.append(f"outside, a vertex moved by {miss / info['height']:.2e} of the height at frame {outside[when]}")
        validated = subprocess.run(["node", READERS / "validate.mjs", output, file], capture_output=True, text=True, check=False)
        if validated.returncode != 0:
            problems.append("validator: " + validated.stdout.strip().replace("\n", ", "))
        self.warned += bool(report["warnings"])
        self.tell(label, problems)

    def lengths(self, file, output, clip, limb, report, scale, tip_time, problems):
        """Limbs with an estimated end have no node to measure: their vertices are compared all the same."""
        if limb["end"] == "estimated":
            return
        nodes = [limb["joints"][0]["node"], limb["joints"][-1]["node"]]
        before = length(measure(file, clip, [tip_time], nodes, 0), 0, 1)[0]
        after = length(measure(output, clip, [tip_time], nodes, 0), 0, 1)[0]
        if report["reached"] and abs(after - scale * before) > LENGTH_TOLERANCE * scale * before:
            problems.append(f"length {after:.6g} instead of {scale:g} x {before:.6g}")
        if abs(after - report["limb_length_after"]) > LENGTH_TOLERANCE * after:
            problems.append(f"length {after:.6g}, said {report['limb_length_after']:.6g}")
        if not report["reached"] and not report["warnings"]:
            problems.append("not reached, and no warning says so")

    def file(self, file):
        info = json.loads(run(self.program, "info", file, "--json"))
        limbs = [limb for limb in info["limbs"] if limb["limb"] in LIMBS]
        with tempfile.TemporaryDirectory() as name:
            for limb in limbs:
                moving = [(clip_motion(self.program, file, clip, limb["limb"]), clip) for clip in range(len(info["clips"]))]
                moving = sorted((motion, clip) for motion, clip in moving if motion > 0.05 * limb["rest_length"])
                for _, clip in moving[-CLIPS_A_FILE:]:
                    whole = f"0:{info['clips'][clip]['seconds'] * info['clips'][clip]['fps']:.6f}"
                    for range_label, range_arguments in (("default range", []), ("whole clip", ["--range", whole])):
                        for setting, arguments, scale in SETTINGS:
                            label = f"{file.name} {info['clips'][clip]['name']} {limb['limb']} {range_label} {setting}"
                            try:
                                self.one(file, info, clip, limb, label, arguments + range_arguments, scale, pathlib.Path(name))
                            except RuntimeError as problem:
                                self.tell(label, [str(problem)])


def main():
    if len(sys.argv) < 4:
        print(__doc__, file=sys.stderr)
        return 2
    check = Check(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]))
    files = [pathlib.Path(name) for name in sys.argv[4:]] or sorted((check.data / "biped").glob("*.glb"))
    for file in files:
        if file.name != "valid-avatar-Asian_M_1_Busi.glb":  # needs meshopt, which is refused
            check.file(file)
    print(f"{check.warned} of {check.passed + check.failed} carry a warning about how they look")
    print(f"{check.passed} passed, {check.failed} failed")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
