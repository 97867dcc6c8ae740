#!/usr/bin/env python3
"""Exaggerates every limb of every biped, quadruped and other body of a data folder and has three.js and the Khronos validator read the result.

    check_exaggeration.py [--clips N|all] [--validate-every N] PROGRAM DUMP_VERTICES DATA_FOLDER [FILE...]

For each limb that reaches out, and a serpent's body, in the N clips in which it moves most (default 2), with the default range and with the whole clip,
scale 2 and scale 3 without Y:
- the limb's length at the tip, measured by three.js, against S times the source's (1e-4 of it), and against what was said;
- every vertex against the program's own, on frames of range and release (1e-4 of the height);
- every vertex outside range and release against the source (1e-6 of the height), and its acceleration from frame to frame
  against the source's (4e-6 of the height: the second difference of three such places);
- a limb whose length over the source's leaves [min(1, S) / 1.5, 1.5 max(1, S)] on a frame of range or release, and a vertex
  farther from its source place than 1.5 times the tip's displacement: only with a warning that names frames around it;
- an edge of the mesh more than 4 times as long as in the source and in the mesh itself, or 1.5 S times where that is more, half-way,
  at the tip and in the release: only with a warning that names the frame;
- no error or warning of the validator that the source did not have.
"""

import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import re
import statistics
import struct
import subprocess
import sys
import tempfile

from check_corpus import read_gltf

READERS = pathlib.Path(__file__).resolve().parent / "readers"
LENGTH_TOLERANCE = 1e-4
VERTEX_TOLERANCE = 1e-4
OUTSIDE_TOLERANCE = 1e-6
ACCELERATION_TOLERANCE = 4e-6
LOOK_ROOM = 1.5
LOOK_SLACK = 1.005  # two implementations measure the same picture
LONGEST_EDGE = 4.0
EDGE_SLACK = 1.0125  # two implementations
SEEN_EDGE = 0.005  # of the height: what is smaller is not seen to be torn
EDGE_WARNING = "an edge of the mesh is"
TRUNK = ("spine", "neck")
SETTINGS = (("scale 2", ["--scale", "2"], 2.0), ("scale 3 xz", ["--scale", "3", "--axes", "xz"], 3.0))
VERTICES_A_MESH = 150
FOLDERS = ("biped/*.glb", "quadruped/*.glb", "bodies/*-animations.glb")
RUNS_OUTSIDE = 6
LOOK_WARNINGS = ("times its own length", "points", "a vertex is", EDGE_WARNING, "above the head", "below")


def reaches_out(limb):
    """Whether it is an arm, a leg, a tail, a wing and the like, by its name, or a body that the head leads."""
    return "led_by" in limb or (limb["limb"] not in TRUNK and ".." not in limb["limb"])


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


class Reader:
    """One process of readers/serve.mjs."""

    def __init__(self):
        self.process = subprocess.Popen(["node", READERS / "serve.mjs"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, **request):
        self.process.stdin.write(json.dumps(request, default=str) + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        answer = json.loads(line) if line else {"error": "the reader ended"}
        if "error" in answer:
            raise RuntimeError(f"{request['file']}: {answer['error']}")
        return answer

    def measure(self, file, clip, times, nodes, step, keep=False):
        return self.ask(do="measure", file=file, clip=f"#{clip}", times=times, nodes=[f"#{node}" for node in nodes], step=step, keep=keep)

    def worse(self, file, source):
        return self.ask(do="validate", file=file, source=source)["worse"]


def clip_motion(program, file, clip, limb):
    """How far the limb's end travels from its base in a clip, by the program's own trail."""
    trail = json.loads(run(program, "trail", file, "--limb", limb, "--clip", f"#{clip}", "--json"))
    reach = [[p - q for p, q in zip(point, base)] for point, base in zip(trail["points"], trail["base"])]
    return max(math.dist(reach[0], other) for other in reach)


def points_of(frames, index):
    values = frames[index]
    return [values[i:i + 3] for i in range(0, len(values), 3)]


def misses(ours, theirs):
    """Largest distance of matching vertices at each time."""
    result = []
    for index in range(len(next(iter(theirs.values())))):
        result.append(max(math.dist(a, b) for key in theirs for a, b in zip(points_of(ours[key], index), points_of(theirs[key], index))))
    return result


def accelerations(vertices, index):
    """Second differences around a time, of every vertex."""
    result = []
    for frames in vertices.values():
        for a, b, c in zip(points_of(frames, index - 1), points_of(frames, index), points_of(frames, index + 1)):
            result.append([x - 2 * y + z for x, y, z in zip(a, b, c)])
    return result


def lengths(measured):
    base, end = measured["nodes"].values()
    return [math.dist(a, b) for a, b in zip(base, end)]


def outside_runs(last, start, stop):
    """Runs of three neighbouring frames outside the range and the release: those next to it and some farther away."""
    runs = [frame for frame in range(last - 1) if frame + 2 < start - 1e-3 or frame > stop + 1e-3]
    before = [frame for frame in runs if frame < start]
    after = [frame for frame in runs if frame > stop]
    near = before[-1:] + after[:1]
    return sorted(set(near + runs[:: max(1, len(runs) // RUNS_OUTSIDE)]))


def numbers(gltf, buffers, index):
    """The elements of an accessor, each a tuple."""
    accessor = gltf["accessors"][index]
    view = gltf["bufferViews"][accessor["bufferView"]]
    letter = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}[accessor["componentType"]]
    form = struct.Struct("<" + {"SCALAR": 1, "VEC3": 3}[accessor["type"]] * letter)
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    stride = view.get("byteStride", form.size)
    return [form.unpack_from(buffers[view["buffer"]], start + i * stride) for i in range(accessor["count"])]


def mesh_edges(file):
    """For each primitive as the readers name it: its edges with their lengths in the mesh."""
    gltf, buffers = read_gltf(file)
    edges = {}
    if any("compression" in name for name in gltf.get("extensionsRequired", [])):
        return edges  # packed geometry is not read here
    for node_index, node in enumerate(gltf["nodes"]):
        for place, primitive in enumerate(gltf["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []):
            if primitive.get("mode", 4) != 4 or "indices" not in primitive:
                continue
            corners = [index for (index,) in numbers(gltf, buffers, primitive["indices"])]
            positions = numbers(gltf, buffers, primitive["attributes"]["POSITION"])
            pairs = {tuple(sorted(pair)) for i in range(0, len(corners) - 2, 3)
                     for pair in ((corners[i], corners[i + 1]), (corners[i + 1], corners[i + 2]), (corners[i + 2], corners[i]))}
            edges[f"#{node_index} {node['mesh']}/{place}"] = [(a, b, math.dist(positions[a], positions[b])) for a, b in sorted(pairs)]
    return edges


def longest_edge(edges, before, after, height):
    """The most that an edge is longer than in the source and in its mesh."""
    scales = [math.dist(before[a], before[b]) / length for a, b, length in edges if length > 0.0]
    scale = statistics.median(scales) if scales else 0.0
    worst = 0.0
    for a, b, length in edges:
        if before[a] != after[a] or before[b] != after[b]:
            now = math.dist(after[a], after[b])
            own = max(math.dist(before[a], before[b]), scale * length)
            if now > SEEN_EDGE * height:
                worst = max(worst, now / max(own, 1e-9 * height))
    return worst


def names(warnings, what, frame):
    """Whether a warning of this kind names a stretch of frames that the frame lies in."""
    for warning in warnings:
        found = re.search(r"at frames? ([\d.]+)(?: to ([\d.]+))?", warning)
        if what in warning and found and float(found[1]) - 0.5 <= frame <= float(found[2] or found[1]) + 0.5:
            return True
    return False


class Case:
    """One exaggeration of one limb in one clip, and what is wrong with it."""

    def __init__(self, check, file, info, clip, limb, arguments, scale, folder):
        self.check, self.file, self.info, self.clip, self.limb, self.scale = check, file, info, clip, limb, scale
        self.problems = []
        self.output = folder / "out.glb"
        self.report = json.loads(run(check.program, "exaggerate", file, "-o", self.output, "--clip", f"#{clip}", "--limb", limb["limb"],
                                     "--json", *arguments))["trails"][0]
        self.fps = info["clips"][clip]["fps"]
        self.last = info["clips"][clip]["seconds"] * self.fps
        self.start, self.end = self.report["range"]
        self.stop = min(self.end + self.report["release"], self.last)
        self.step = max(1, max(mesh["vertices"] for mesh in info["meshes"]) // VERTICES_A_MESH)
        ends = [limb["joints"][0]["node"], limb["joints"][-1]["node"]]  # the one that leads is the last
        self.nodes = [] if limb["end"] == "estimated" else ends[::-1] if "led_by" in limb else ends
        self.warnings = self.report["warnings"]

    def measure(self, frames, step, nodes=()):
        """The same of source and output."""
        times = [frame / self.fps for frame in frames]
        reader = self.check.reader
        return (reader.measure(self.file, self.clip, times, list(nodes), step, keep=True),
                reader.measure(self.output, self.clip, times, list(nodes), step))

    def all(self):
        self.tip()
        self.inside()
        self.outside()
        self.look()
        self.edges()
        if self.check.validates():
            worse = self.check.reader.worse(self.output, self.file)
            self.problems += ["validator: " + ", ".join(worse)] if worse else []
        return self.problems

    def tip(self):
        """Limbs with an estimated end have no node to measure: their vertices are compared all the same."""
        if not self.nodes:
            return
        before, after = (lengths(measured)[0] for measured in self.measure([self.end], 0, self.nodes))
        if self.report["reached"] and abs(after - self.scale * before) > LENGTH_TOLERANCE * self.scale * before:
            self.problems.append(f"length {after:.6g} instead of {self.scale:g} x {before:.6g}")
        if abs(after - self.report["limb_length_after"]) > LENGTH_TOLERANCE * after:
            self.problems.append(f"length {after:.6g}, said {self.report['limb_length_after']:.6g}")
        if not self.report["reached"] and not self.warnings and not self.report.get("stopped"):
            self.problems.append("not reached, and nothing says why")

    def inside(self):
        frames = sorted({round(2 * (self.start + (self.stop - self.start) * i / 12)) / 2 for i in range(13)} | {self.end})
        times = [f"{frame / self.fps:.9g}" for frame in frames]
        ours = json.loads(run(self.check.dump, self.output, self.clip, self.step, *times))["vertices"]
        source, output = self.measure(frames, self.step)
        missed = misses(ours, output["vertices"])
        worst = max(range(len(frames)), key=lambda i: missed[i])
        if not missed[worst] <= VERTEX_TOLERANCE * self.info["height"]:
            self.problems.append(f"a vertex is {missed[worst] / self.info['height']:.2e} of the height off at frame {frames[worst]:g}")
        self.far_vertices(frames, misses(source["vertices"], output["vertices"]))

    def far_vertices(self, frames, moved):
        displacement = math.dist(*self.tips()) if self.nodes else moved[frames.index(self.end)]
        for frame, distance in zip(frames, moved):
            too_far = distance > LOOK_ROOM * LOOK_SLACK * displacement + 1e-3 * self.info["height"]
            if too_far and frame == round(frame) and not any(names(self.warnings, far, frame) for far in ("a vertex is", "is carried")):
                self.problems.append(f"a vertex is {distance:.4g} from its place at frame {frame:g}, the tip {displacement:.4g}, without a warning")

    def tips(self):
        return [list(measured["nodes"].values())[1][0] for measured in self.measure([self.end], 0, self.nodes)]

    def look(self):
        if not self.nodes:
            return
        frames = [frame for frame in range(int(self.last) + 1) if self.start - 1e-3 <= frame <= self.stop + 1e-3]
        if not frames:
            return
        before, after = (lengths(measured) for measured in self.measure(frames, 0, self.nodes))
        least, most = min(1.0, self.scale) / LOOK_ROOM / LOOK_SLACK, LOOK_ROOM * max(1.0, self.scale) * LOOK_SLACK
        for frame, a, b in zip(frames, before, after):
            if a > 1e-6 * self.info["height"] and not least <= b / a <= most and not names(self.warnings, "times its own length", frame):
                self.problems.append(f"the limb is {b / a:.3g} times its own length at frame {frame}, without a warning")

    def edges(self):
        frames = sorted({round((self.start + self.end) / 2), round(self.end), min(round((self.end + self.stop) / 2), int(self.last))})
        source, output = self.measure(frames, 1)
        for index, frame in enumerate(frames):
            worst = max((longest_edge(edges, points_of(source["vertices"][key], index), points_of(output["vertices"][key], index), self.info["height"])
                         for key, edges in self.check.edges.items()), default=0.0)
            if worst > EDGE_SLACK * max(LONGEST_EDGE, LOOK_ROOM * self.scale) and not names(self.warnings, EDGE_WARNING, frame):
                self.problems.append(f"an edge is {worst:.3g} times its length at frame {frame}, without a warning")

    def outside(self):
        runs = outside_runs(int(self.last + 1e-3), self.start, self.stop)
        frames = [frame + k for frame in runs for k in range(3)]
        if not frames:
            return
        source, output = self.measure(frames, self.step)
        missed = misses(source["vertices"], output["vertices"])
        worst = max(range(len(frames)), key=lambda i: missed[i])
        height = self.info["height"]
        if not missed[worst] <= OUTSIDE_TOLERANCE * height:
            self.problems.append(f"outside, a vertex moved by {missed[worst] / height:.2e} of the height at frame {frames[worst]}")
        for index in range(1, len(frames), 3):
            pairs = zip(accelerations(source["vertices"], index), accelerations(output["vertices"], index))
            miss = max(math.dist(a, b) for a, b in pairs)
            if not miss <= ACCELERATION_TOLERANCE * height:
                self.problems.append(f"outside, a vertex accelerates otherwise by {miss / height:.2e} of the height at frame {frames[index]}")


class Check:
    def __init__(self, program, dump, clips, validate_every):
        self.program, self.dump, self.clips, self.validate_every = program, dump, clips, validate_every
        self.reader = Reader()
        self.edges = {}
        self.asked = 0

    def validates(self):
        self.asked += 1
        return self.asked % self.validate_every == 0

    def file(self, file):
        info = json.loads(run(self.program, "info", file, "--json"))
        self.edges = mesh_edges(file)
        row = {"file": file.name, "cases": 0, "passed": 0, "look": 0, "other": 0}
        with tempfile.TemporaryDirectory() as folder:
            for limb in (limb for limb in info["limbs"] if reaches_out(limb)):
                moving = [(clip_motion(self.program, file, clip, limb["limb"]), clip) for clip in range(len(info["clips"]))]
                moving = sorted((motion, clip) for motion, clip in moving if motion > 0.05 * limb["rest_length"])
                for _, clip in moving if self.clips is None else moving[-self.clips:]:
                    self.limb_in_clip(file, info, clip, limb, pathlib.Path(folder), row)
        print(f"{row['file']}: {row['passed']} of {row['cases']} pass; {row['look']} warn of how they look, {row['other']} of something else", flush=True)
        return row

    def limb_in_clip(self, file, info, clip, limb, folder, row):
        whole = f"0:{info['clips'][clip]['seconds'] * info['clips'][clip]['fps']:.6f}"
        for range_label, range_arguments in (("default range", []), ("whole clip", ["--range", whole])):
            for setting, arguments, scale in SETTINGS:
                row["cases"] += 1
                label = f"{file.name} {clip} {info['clips'][clip]['name']} {limb['limb']} {range_label} {setting}"
                try:
                    case = Case(self, file, info, clip, limb, arguments + range_arguments, scale, folder)
                    problems = case.all()
                    look = any(what in warning for warning in case.warnings for what in LOOK_WARNINGS)
                    row["look"] += look
                    row["other"] += bool(case.warnings) and not look
                except RuntimeError as problem:
                    problems = [str(problem)]
                row["passed"] += not problems
                if problems:
                    print(f"FAIL {label}: {'; '.join(problems)}", flush=True)


def checked(file, *options):
    """A file's row; each process has a check, and so a reader, of its own."""
    if not hasattr(checked, "check"):
        checked.check = Check(*options)
    return checked.check.file(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("dump_vertices", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("files", nargs="*", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--clips", default="2", help="clips for each limb: those in which it moves most, or 'all' in which it moves")
    parser.add_argument("--validate-every", type=int, default=1, help="the validator takes the longest: only every N-th case")
    arguments = parser.parse_args()
    bodies = [file for folder in FOLDERS for file in sorted(arguments.data.glob(folder))]
    options = (arguments.program.resolve(), arguments.dump_vertices.resolve(), None if arguments.clips == "all" else int(arguments.clips),
               arguments.validate_every)
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
        rows = [row.result() for row in [pool.submit(checked, file, *options) for file in arguments.files or bodies]]
    cases, passed = (sum(row[key] for row in rows) for key in ("cases", "passed"))
    print(f"{passed} of {cases} pass")
    return 0 if passed == cases else 1


if __name__ == "__main__":
    sys.exit(main())
