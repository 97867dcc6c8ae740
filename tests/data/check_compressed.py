#!/usr/bin/env python3
"""Packs characters as exporters do (Draco, meshopt, quantised; readers/pack.mjs) and compares what the program makes of them.

    check_compressed.py PROGRAM DATA_FOLDER

For CesiumMan and the bundled character, each packed file against the plain one:
- the same limbs, joint by joint, as long (1e-4 of the height) and as sure;
- the left arm three times as long: every vertex that three.js shows of the packed output lies on one of the plain output, at
  the tip of the trail and outside it (CODEC_TOLERANCES, of the height; the order of vertices is the packer's);
- the packed data of the output are the packed file's, byte for byte, and the validator has no complaint that it had not before;
- pictures of both outputs at the tip differ at few pixels.
"""

import json
import math
import pathlib
import statistics
import struct
import subprocess
import sys
import tempfile
import time
import zlib

from check_corpus import read_gltf
from check_exaggeration import READERS, Reader, points_of, run

# Draco keeps weights as they are; the others round them to 8 bits, which moves a vertex by up to 1/255 of its stretch.
CODEC_TOLERANCES = {"draco": 5e-4, "draco-sequential": 5e-4, "meshopt": 4e-3, "quantised": 4e-3}
PIXELS_THAT_DIFFER = 0.01
LEVELS_THAT_DIFFER = 24
SAMPLED_VERTICES = 120


def pixels_of(file):
    """Rows of bytes of a PNG with 8 bits for each channel, and bytes for each pixel."""
    raw = file.read_bytes()
    width, height, _, kind = struct.unpack(">IIBB", raw[16:26])
    channels = {0: 1, 2: 3, 6: 4}[kind]
    packed, offset = b"", 8
    while offset < len(raw):
        length, name = struct.unpack(">I4s", raw[offset : offset + 8])
        packed += raw[offset + 8 : offset + 8 + length] if name == b"IDAT" else b""
        offset += length + 12
    content, stride = zlib.decompress(packed), width * channels
    rows, above = [], bytes(stride)
    for y in range(height):
        method, row = content[y * (stride + 1)], bytearray(content[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for i in range(stride):
            left, corner = (row[i - channels], above[i - channels]) if i >= channels else (0, 0)
            if method == 1:
                row[i] = (row[i] + left) & 255
            elif method == 2:
                row[i] = (row[i] + above[i]) & 255
            elif method == 3:
                row[i] = (row[i] + (left + above[i]) // 2) & 255
            elif method == 4:
                guess = left + above[i] - corner
                nearest = min((abs(guess - left), 0, left), (abs(guess - above[i]), 1, above[i]), (abs(guess - corner), 2, corner))
                row[i] = (row[i] + nearest[2]) & 255
        rows.append(bytes(row))
        above = row
    return rows, channels


def differing_pixels(a, b):
    """Share of the pixels whose colours differ by more than a few levels."""
    (rows_a, channels), (rows_b, _) = pixels_of(a), pixels_of(b)
    count = sum(
        any(abs(row_a[x + k] - row_b[x + k]) > LEVELS_THAT_DIFFER for k in range(channels))
        for row_a, row_b in zip(rows_a, rows_b)
        for x in range(0, len(row_a), channels)
    )
    return count / (len(rows_a) * len(rows_a[0]) / channels)


def opening_seconds(program, file):
    times = []
    for _ in range(5):
        start = time.perf_counter()
        run(program, "info", file, "--json")
        times.append(time.perf_counter() - start)
    return statistics.median(times)


class Character:
    """A plain character and what the program makes of it: what packed versions are compared with."""

    def __init__(self, program, file, folder, reader):
        self.program, self.file, self.folder, self.reader = program, file, folder, reader
        self.info = json.loads(run(program, "info", file, "--json"))
        self.report, self.output = self.stretched(file)
        fps = self.info["clips"][0]["fps"]
        self.tip = self.report["range"][1]
        self.times = [self.tip / fps, self.info["clips"][0]["seconds"]]
        self.vertices = self.vertices_of(self.output, 1)
        self.picture = self.picture_of(self.output)

    def stretched(self, file):
        output = self.folder / f"{file.stem}-stretched.glb"
        report = run(self.program, "exaggerate", file, "-o", output, "--limb", "left-arm", "--scale", "3", "--json")
        return json.loads(report)["trails"][0], output

    def picture_of(self, file):
        picture = self.folder / f"{file.stem}.png"
        run(self.program, "render", file, "-o", picture, "--frame", str(self.tip), "--size", "480x480")
        return picture

    def vertices_of(self, file, step):
        """All vertices of all meshes at each of the times."""
        measured = self.reader.measure(file, 0, self.times, [], step)
        return [[point for mesh in measured["vertices"].values() for point in points_of(mesh, index)] for index in range(len(self.times))]

    def problems(self, packed, tolerance):
        info = json.loads(run(self.program, "info", packed, "--json"))
        _, output = self.stretched(packed)
        found = self.limb_problems(info) + self.byte_problems(packed, output)
        found += [f"the validator: {worse}" for worse in self.reader.worse(output, packed)]
        step = max(1, len(self.vertices[0]) // SAMPLED_VERTICES)
        for seconds, ours, theirs in zip(self.times, self.vertices_of(output, step), self.vertices):
            miss = max(min(math.dist(a, b) for b in theirs) for a in ours) / self.info["height"]
            print(f"  {packed.name} at {seconds:.3f} s: vertices within {miss:.2e} of the height")
            if not miss <= tolerance:
                found.append(f"a vertex is {miss:.2e} of the height beside the plain one's at {seconds:.3f} s")
        share = differing_pixels(self.picture, self.picture_of(output))
        seconds = opening_seconds(self.program, packed), opening_seconds(self.program, self.file)
        print(f"  {packed.name}: {share:.2%} of the pixels differ; info takes {seconds[0]:.3f} s, of the plain file {seconds[1]:.3f} s")
        return found + ([f"{share:.2%} of the pixels differ"] if share > PIXELS_THAT_DIFFER else [])

    def limb_problems(self, info):
        if len(info["limbs"]) != len(self.info["limbs"]):
            return ["other limbs"]
        found = []
        for ours, theirs in zip(info["limbs"], self.info["limbs"]):
            same = [joint["name"] for joint in ours["joints"]] == [joint["name"] for joint in theirs["joints"]]
            longer = abs(ours["rest_length"] - theirs["rest_length"]) > 1e-4 * self.info["height"]
            if not same or longer or abs(ours["confidence"] - theirs["confidence"]) > 0.02:
                found.append(f"another {theirs['limb']}")
        return found

    @staticmethod
    def byte_problems(packed, output):
        (before, old), (after, new) = read_gltf(packed), read_gltf(output)
        found = [] if new[0][: len(old[0])] == old[0] and new[1:] == old[1:] else ["packed data changed"]
        if before["meshes"] != after["meshes"] or before["bufferViews"] != after["bufferViews"][: len(before["bufferViews"])]:
            found.append("meshes or buffer views changed")
        return found


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    program, data = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    files = [data / "biped/CesiumMan.glb", pathlib.Path(__file__).resolve().parents[2] / "assets/dummy.glb"]
    reader, failed, count = Reader(), 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run("node", READERS / "pack.mjs", folder, *files)
        for file in files:
            character = Character(program, file, folder, reader)
            for packing, tolerance in CODEC_TOLERANCES.items():
                problems = character.problems(folder / f"{file.stem}-{packing}.glb", tolerance)
                count += 1
                failed += bool(problems)
                for problem in problems:
                    print(f"FAIL {file.stem}-{packing}.glb: {problem}")
    print(f"{count - failed} of {count} packed characters pass")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
