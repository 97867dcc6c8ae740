#!/usr/bin/env python3
"""Exaggerates a limb of every biped of a data folder and asks three readers where its vertices are at the keys: the program itself, three.js,
and Blender where it is installed (`blender` with `python3-numpy`).

    check_readers.py PROGRAM DUMP_VERTICES DATA_FOLDER [FILE...]

For each file the arm or leg that moves most, in the clip in which it does, three times as long, saved without the work. At keys of range and
release that the tracks share, up to 9 of them, every corner of every triangle is within 1e-5 of the character's height of where the program itself has it. Where a
reader is farther away, it has to be as far from the source, by its own way of reading that: Blender takes one weight of a joint that a vertex
names twice.
"""

import collections
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

from check_corpus import read_gltf
from check_exaggeration import Reader, clip_motion, numbers, run, reaches_out

TOLERANCE = 1e-5
SOURCE_SLACK = 2.0  # a limb three times as long shows more of it
TIMES = 9
BLENDER_SCRIPT = pathlib.Path(__file__).resolve().parent / "readers" / "blender_positions.py"


def glb_of(gltf, binary):
    """The bytes of a GLB."""
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def with_one_clip(file, clip, output):
    """The same GLB with one of its clips alone, and each node with a mesh marked by its index."""
    gltf, buffers = read_gltf(file)
    gltf["animations"] = [gltf["animations"][clip]]
    for index, node in enumerate(gltf["nodes"]):
        if "mesh" in node:
            node["extras"] = {"check_node": index}
    output.write_bytes(glb_of(gltf, buffers[0]))
    return gltf, buffers


def key_times(gltf, buffers, start, stop):
    """Times between two moments at which the most turning tracks have a key, at most TIMES of them. Between keys Blender turns another way."""
    animation, shared = gltf["animations"][0], collections.Counter()
    for channel in animation["channels"]:
        if channel["target"]["path"] == "rotation":
            keys = [time for (time,) in numbers(gltf, buffers, animation["samplers"][channel["sampler"]]["input"])]
            shared.update(time for time in keys if start - 1e-4 <= time <= stop + 1e-4 and len(keys) > 2)
    times = sorted(time for time, count in shared.items() if count == max(shared.values()))
    step = max(1, math.ceil(len(times) / TIMES))
    return times[::step]


def corners_of(gltf, buffers, vertices):
    """For each node with a mesh: at each time the corners of its triangles, of what a reader says of vertices by "#node mesh/primitive"."""
    result = {}
    for index, node in enumerate(gltf["nodes"]):
        if "mesh" not in node:
            continue
        for place, primitive in enumerate(gltf["meshes"][node["mesh"]]["primitives"]):
            name = f"#{index} {node['mesh']}/{place}"
            if name not in vertices or primitive.get("mode", 4) != 4:
                continue
            frames = vertices[name]
            order = [corner for (corner,) in numbers(gltf, buffers, primitive["indices"])] if "indices" in primitive else range(len(frames[0]) // 3)
            for moment, frame in enumerate(frames):
                result.setdefault(str(index), [[] for _ in frames])[moment] += [frame[3 * corner:3 * corner + 3] for corner in order]
    return result


def farthest(ours, theirs):
    """The largest distance of corners at all times; infinite where they are not as many."""
    worst = 0.0
    for node, moments in ours.items():
        for mine, other in zip(moments, theirs.get(node, [[]] * len(moments))):
            if len(mine) != len(other):
                return math.inf
            worst = max([worst, *(math.dist(a, b) for a, b in zip(mine, other))])
    return worst


def by_blender(file, times):
    # Blender's Python looks for its home along PATH: the system's it is.
    done = subprocess.run([shutil.which("blender"), "--background", "--factory-startup", "--python-exit-code", "1", "--python", BLENDER_SCRIPT, "--", file, *map(str, times)],
                          capture_output=True, text=True, timeout=600, check=False, env={**os.environ, "PATH": os.defpath})
    line = next((line for line in done.stdout.splitlines() if line.startswith("POSITIONS ")), None)
    if line is None:
        raise RuntimeError("Blender: " + " | ".join((done.stdout + done.stderr).strip().splitlines()[-4:]))
    moments = json.loads(line[len("POSITIONS "):])
    return {node: [[moment[node][i:i + 3] for i in range(0, len(moment[node]), 3)] for moment in moments] for node in moments[0]}


class Check:
    def __init__(self, program, dump):
        self.program, self.dump, self.reader = program, dump, Reader()
        self.blender = shutil.which("blender") is not None
        self.failed = 0

    def exaggerated(self, file, info, folder):
        """The file with its most moving limb three times as long, and seconds of range and release."""
        moving = [(clip_motion(self.program, file, clip, limb["limb"]), clip, limb["limb"])
                  for limb in info["limbs"] if reaches_out(limb) for clip in range(len(info["clips"]))]
        _, clip, limb = max(moving)
        report = json.loads(run(self.program, "exaggerate", file, "-o", folder / "out.glb", "--clip", f"#{clip}", "--limb", limb, "--scale", "3", "--clean", "--json"))
        trail, fps = report["trails"][0], info["clips"][clip]["fps"]
        start, end = trail["range"]
        return clip, limb, start / fps, min((end + trail["release"]) / fps, info["clips"][clip]["seconds"])

    def distances(self, file, gltf, buffers, times):
        """How far each of the other readers is from the program at these times."""
        ours = corners_of(gltf, buffers, json.loads(run(self.dump, file, 0, 1, *times))["vertices"])
        theirs = self.reader.measure(file, 0, [float(time) for time in times], [], 1)["vertices"]
        found = {"three.js": farthest(ours, corners_of(gltf, buffers, theirs))}
        if self.blender:
            found["Blender"] = farthest(ours, by_blender(file, times))
        return found

    def file(self, file, folder):
        info = json.loads(run(self.program, "info", file, "--json"))
        if not info["clips"]:
            print(f"{file.name}: has no clip")
            return
        clip, limb, start, stop = self.exaggerated(file, info, folder)
        gltf, buffers = with_one_clip(folder / "out.glb", clip, folder / "one.glb")
        times = key_times(gltf, buffers, start, stop)
        texts = [f"{time:.9g}" for time in times]
        found, known = self.distances(folder / "one.glb", gltf, buffers, texts), []
        if max(found.values()) > TOLERANCE * info["height"]:
            source = self.distances(folder / "source.glb", *with_one_clip(file, clip, folder / "source.glb"), texts)
            known = [name for name in found if TOLERANCE * info["height"] < found[name] <= SOURCE_SLACK * source[name]]
        told = ", ".join(f"{name} {distance / info['height']:.1e}" for name, distance in found.items())
        good = all(distance <= TOLERANCE * info["height"] or name in known for name, distance in found.items())
        self.failed += not good
        as_source = f" ({', '.join(known)}: as far apart in the source)" if known else ""
        print(f"{'' if good else 'FAIL '}{file.name}: {limb} in clip {clip} at {len(times)} keys: {told} of the height{as_source}", flush=True)


def main():
    program, dump, data, *files = map(pathlib.Path, sys.argv[1:])
    check = Check(program.resolve(), dump.resolve())
    if not check.blender:
        print("Blender is not installed: three.js alone is asked")
    with tempfile.TemporaryDirectory() as folder:
        for file in files or sorted([*(data / "biped").glob("*.glb"), *(data / "biped").glob("*/*.glb")]):
            try:
                check.file(file, pathlib.Path(folder))
            except RuntimeError as problem:
                check.failed += 1
                print(f"FAIL {file.name}: {problem}")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
