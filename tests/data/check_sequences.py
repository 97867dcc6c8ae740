#!/usr/bin/env python3
"""Compresses real mesh sequences and has three.js and the Khronos validator read the result; gives the program broken ones.

    check_sequences.py PROGRAM DUMP_VERTICES [DATA_FOLDER]

For each sequence, stretch option and encoding:
- every vertex of some frames, as three.js skins the file, against the program's own (1e-4 of the diagonal);
- the error of the written file against the source, as `compare` measures it, against what `compress` said of its own vertices;
- no error or warning of the validator.
For the sequences that the check makes itself (own_sequences.py), and each of the data folder:
- the error over every vertex and frame, as three.js skins the file and the source's files say, against what `compress` said;
- of the own ones every corner of every triangle with its texture coordinates, normal and material, colours and images byte for
  byte, and a picture of the clip beside one of the source.
For bodies of the data folder that part into pieces that move alike:
- no joint sticks out of the body in the bind pose by more than a tenth of its thickness.
With STRETCH_PICTURES naming a folder the pictures are kept there. Without a data folder only the own sequences are checked.
Broken sequences: status 1, one line that names the place, and nothing written. Flawed but usable ones: a warning.
"""

import json
import math
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

from check_compressed import differing_pixels
from own_sequences import FPS, MAKERS, write_positions
from sticking_joints import farthest_out

READERS = pathlib.Path(__file__).resolve().parent / "readers"
VERTEX_TOLERANCE = 1e-4  # of the diagonal
ERROR_TOLERANCE = 5e-3  # RMSE, percent of the diagonal: what 16-bit rotations may cost
INDEPENDENT_TOLERANCE = 2e-3  # of the error itself, and INDEPENDENT_SLACK percent of the diagonal
# What three.js may be apart beyond that: it takes quantised rotations as they are, a little off unit length, and vertices at one place
# cannot be told apart by their place.
INDEPENDENT_SLACK = 4e-4
CORNER_TOLERANCE = 1e-4
PIXELS_THAT_DIFFER = 0.03
STICKING_OUT = 0.1  # of the body's thickness
FRAMES_LOOKED_AT = 9
PACKED = ["--quantise", "--quantise-mesh", "--meshopt"]
VERTEX_STEP = 5


def run(*command):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300, check=False)


def output_of(*command):
    done = run(*command)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


def flat(vertices):
    """Per time, all numbers of all primitives one after the other."""
    times = len(next(iter(vertices.values())))
    return [[number for key in sorted(vertices) for number in vertices[key][time]] for time in range(times)]


def largest_distance(a, b):
    if len(a) != len(b):
        return math.inf
    return max(math.dist(a[i : i + 3], b[i : i + 3]) for i in range(0, len(a), 3))


def diagonal(numbers):
    return math.dist(*[[pick(numbers[axis::3]) for axis in range(3)] for pick in (min, max)])


def obj_frames(folder):
    """Positions of every frame of a folder, in the order of the numbers in the names."""
    files = sorted(folder.glob("*.obj"), key=lambda file: int(re.findall(r"\d+", file.stem)[-1]))
    lines = lambda file: (line.split() for line in file.read_text().splitlines() if line.startswith("v "))
    return [[tuple(map(float, words[1:4])) for words in lines(file)] for file in files]


def cache_frames(cache):
    content = cache.read_bytes()
    points, _, _, samples = struct.unpack("<iffi", content[16:32])
    numbers = struct.unpack(f"<{3 * points * samples}f", content[32 : 32 + 12 * points * samples])
    return [[numbers[3 * (k * points + v) : 3 * (k * points + v) + 3] for v in range(points)] for k in range(samples)]


def morph_frames(file, clip, rate):
    """Frames of a glTF's clip, as three.js shows the source."""
    info = json.loads(file.read_text())
    sampler = info["animations"][clip]["samplers"][0]
    count = round(info["accessors"][sampler["input"]]["max"][0] * rate) + 1
    times = ",".join(f"{k / rate:.9g}" for k in range(count))
    shown = json.loads(output_of("node", READERS / "measure.mjs", file, "--clip", f"#{clip}", "--times", times, "--vertices", 1))["vertices"]
    return [[tuple(frame[i : i + 3]) for i in range(0, len(frame), 3)] for frame in flat(shown)]


def glb_json(file):
    content = file.read_bytes()
    length = struct.unpack("<I", content[12:16])[0]
    return json.loads(content[20 : 20 + length]), content[28 + length :]


def rounded(corner):
    place, uv, normal, material = corner
    steps = lambda numbers: None if numbers is None else tuple(round(n / (10 * CORNER_TOLERANCE)) for n in numbers)
    return (steps(place), material), uv, normal


def near(a, b):
    return (a is None) == (b is None) and (a is None or max(abs(x - y) for x, y in zip(a, b)) <= CORNER_TOLERANCE)


def corner_problems(wanted, found, has_normals):
    """Every corner of the source in the clip with all that it has, and no other."""
    pool = {}
    for corner in found:
        key, uv, normal = rounded(corner)
        pool.setdefault(key, []).append((uv, normal))
    missing = 0
    for corner in wanted:
        key, uv, normal = rounded(corner)
        matches = [c for c in pool.get(key, []) if near(c[0], uv) and (not has_normals or near(c[1], normal))]
        if matches:
            pool[key].remove(matches[0])
        else:
            missing += 1
    left = sum(map(len, pool.values()))
    return [f"{missing} corners of {len(wanted)} are not in the clip, {left} are not in the source"] if missing or left else []


class Check:
    def __init__(self, program, dump, data):
        self.program, self.dump, self.data = program, dump, data
        self.passed, self.failed = 0, 0

    def tell(self, label, problems):
        if problems:
            self.failed += 1
            print(f"FAIL {label}: {'; '.join(problems)}", flush=True)
        else:
            self.passed += 1

    def independent_reader(self, output, report, problems):
        info = json.loads(output_of(self.program, "info", output, "--json"))
        seconds = info["clips"][0]["seconds"]
        times = [f"{seconds * i / (FRAMES_LOOKED_AT - 1):.9g}" for i in range(FRAMES_LOOKED_AT)]
        theirs = json.loads(output_of("node", READERS / "measure.mjs", output, "--clip", "#0", "--times", ",".join(times),
                                      "--vertices", VERTEX_STEP))["vertices"]
        ours = json.loads(output_of(self.dump, output, 0, VERTEX_STEP, *times))["vertices"]
        theirs, ours = flat(theirs), flat(ours)
        size = diagonal(ours[0])
        worst = max(largest_distance(a, b) for a, b in zip(theirs, ours)) / size
        if not worst <= VERTEX_TOLERANCE:
            problems.append(f"three.js puts a vertex {worst:.2e} of the diagonal elsewhere")
        validated = run("node", READERS / "validate.mjs", output)
        if validated.returncode != 0:
            problems.append("validator: " + validated.stdout.strip().replace("\n", ", "))

    def compressed(self, words, label, arguments, folder):
        output = folder / "compressed.glb"
        problems = []
        try:
            report = json.loads(output_of(self.program, "compress", *words, "-o", output, "--json", *arguments))
            written = json.loads(output_of(self.program, "compare", *words, output, "--json"))
            if abs(written["rmse_percent"] - report["rmse_percent"]) > ERROR_TOLERANCE:
                problems.append(f"the file is {written['rmse_percent']:.4f} % off, said {report['rmse_percent']:.4f} %")
            self.independent_reader(output, report, problems)
        except (RuntimeError, subprocess.TimeoutExpired) as problem:
            problems.append(str(problem))
        self.tell(label, problems)

    def independent_error(self, output, frames, report, folder, problems, *flags):
        positions = folder / "positions.f32"
        write_positions(frames, positions)
        theirs = json.loads(output_of("node", READERS / "sequence.mjs", output, positions, len(frames[0]), FPS, *flags))
        if theirs["unmatched"]:
            problems.append(f"{theirs['unmatched']} vertices of the clip lie on none of the source")
        for key, said in (("rmse_percent", report["file"]["rmse_percent"]), ("largest_percent", report["file"]["largest_percent"])):
            if abs(theirs[key] - said) > INDEPENDENT_TOLERANCE * said + INDEPENDENT_SLACK:
                problems.append(f"{key} is {theirs[key]:.6f}, said {said:.6f}")
        return theirs

    def looks(self, own, output, theirs, problems):
        bind = own.frames[0]
        wanted = [(bind[v], uv, normal, material) for v, uv, normal, material in own.corners]
        problems += corner_problems(wanted, theirs["corners"], own.corners[0][2] is not None)
        described, binary = glb_json(output)
        for material in described.get("materials", []):
            surface = material["pbrMetallicRoughness"]
            factor = surface.get("baseColorFactor", [1.0] * 4)
            if material["name"] not in own.colours or not near(factor, own.colours[material["name"]]):
                problems.append(f"the colour of {material['name']} is {factor}")
            image = None
            if "baseColorTexture" in surface:
                source = described["textures"][surface["baseColorTexture"]["index"]]["source"]
                view = described["bufferViews"][described["images"][source]["bufferView"]]
                image = binary[view.get("byteOffset", 0) :][: view["byteLength"]]
            if image != own.images.get(material["name"]):
                problems.append(f"the image of {material['name']} is another one")
        if len(described.get("materials", [])) != len(own.colours):
            problems.append("the materials are not those of the source")

    def pictures(self, name, own, output, folder, problems):
        kept = pathlib.Path(os.environ.get("STRETCH_PICTURES", folder))
        files = [kept / f"{name.replace(' ', '_')}-{which}.png" for which in ("source", "clip")]
        frame = len(own.frames) // 2
        look = ["--frame", frame, "--size", "480x360"]
        output_of(self.program, "render", *own.words, "-o", files[0], "--look", "material", *look)
        output_of(self.program, "render", *own.words, "-o", files[1], "--over", output, "--look", "material", *look)
        far = differing_pixels(*files)
        if far > PIXELS_THAT_DIFFER:
            problems.append(f"{100 * far:.1f} % of the picture differ from the source's")

    def own_sequences(self, folder):
        for name, make in MAKERS.items():
            problems, home = [], folder / name.replace(" ", "_")
            home.mkdir()
            own = make(home)
            for packing in ([], ["--quantise"]):
                output = home / "clip.glb"
                try:
                    report = json.loads(output_of(self.program, "compress", *own.words, "-o", output, "--json", "--fps", FPS, *own.arguments, *packing))
                    theirs = self.independent_error(output, own.frames, report, home, problems, "--corners")
                    self.looks(own, output, theirs, problems)
                    self.independent_reader(output, report, problems)
                    if not packing:
                        self.pictures(name, own, output, home, problems)
                except (RuntimeError, subprocess.TimeoutExpired) as problem:
                    problems.append(str(problem))
            self.tell(name, problems)

    def errors_of_data(self, folder):
        """Every sequence of the data folder, measured from its own files."""
        worm, meshes = self.data / "worm", self.data / "mesh-sequence"
        sequences = {"wolf": ([meshes / "wolf"], lambda: obj_frames(meshes / "wolf")),
                     "dem-bones": ([meshes / "dem-bones" / "frames"], lambda: obj_frames(meshes / "dem-bones" / "frames"))}
        morph = meshes / "morph" / "MorphStressTest.gltf"
        sequences["morph"] = ([morph], lambda: morph_frames(morph, 0, FPS))  # a glTF keeps its times, whatever --fps
        for cache in sorted(worm.glob("*.pc2")):
            base = worm / ("worm_half_swim_base.obj" if "half" in cache.name else "worm_base.obj")
            sequences[cache.stem] = ([base, cache], lambda cache=cache: cache_frames(cache))
        for name, (words, frames) in sequences.items():
            self.error_of_data(name, words, frames(), ["--stretch", "measured"], folder)
            self.error_of_data(name, words, frames(), ["--stretch", "measured", "--key-tolerance", "0.3%"], folder)
            if "worm" not in name:  # These branch or are in several parts: limb by limb.
                self.error_of_data(name, words, frames(), ["--stretch", "elastic", "--joints", "tree"], folder)

    def error_of_data(self, name, words, frames, arguments, folder):
        problems, output = [], folder / "compressed.glb"
        try:
            report = json.loads(output_of(self.program, "compress", *words, "-o", output, "--json", "--fps", FPS, "--bones", 20, *arguments))
            self.independent_error(output, frames, report, folder, problems)
        except (RuntimeError, subprocess.TimeoutExpired) as problem:
            problems.append(str(problem))
        self.tell(f"{name} {' '.join(arguments)}, measured from its files", problems)

    def refused(self, label, words, expected, folder):
        output = folder / "refused.glb"
        done = run(self.program, "compress", *words, "-o", output, "--bones", 10)
        lines = done.stderr.strip().splitlines()
        problems = []
        if done.returncode != 1 or len(lines) != 1:
            problems.append(f"status {done.returncode}, {len(lines)} lines")
        if expected not in done.stderr:
            problems.append(f"no word about '{expected}': {done.stderr.strip()}")
        if output.exists():
            problems.append("a file was written")
        self.tell(label, problems)

    def warned(self, label, words, expected, folder):
        done = run(self.program, "compress", *words, "-o", folder / "warned.glb", "--bones", 10, "--stretch", "measured")
        told = [line for line in done.stderr.splitlines() if line.startswith("warning:") and expected in line]
        self.tell(label, [] if done.returncode == 0 and told else [f"status {done.returncode}: {done.stderr.strip()}"])

    def proofs(self, folder):
        worm = self.data / "worm"
        sequences = {
            "worm_crawl": [worm / "worm_base.obj", worm / "worm_crawl.pc2"],
            "dem-bones": [self.data / "mesh-sequence" / "dem-bones" / "frames"],
        }
        for name, words in sequences.items():
            for stretch in ("none", "elastic", "measured"):
                for encoding in ([], ["--quantise"], PACKED):
                    arguments = ["--bones", 20, "--stretch", stretch, "--skip", 5, *encoding]
                    self.compressed(words, " ".join([name, stretch, *encoding]), arguments, folder)

        wolf = [self.data / "mesh-sequence" / "wolf"]
        for joints in ("tree", "free"):
            for encoding in ([], PACKED):
                arguments = ["--bones", 20, "--stretch", "measured", "--joints", joints, *encoding]
                self.compressed(wolf, " ".join(["wolf", joints, *encoding]), arguments, folder)

    def joints_in_bodies(self, folder):
        sequences, output = self.data / "mesh-sequence", folder / "joints.glb"
        for name in ("wolf", "morph/MorphStressTest.gltf"):
            for bones in (8, 12, 30):
                output_of(self.program, "compress", sequences / name, "-o", output, "--bones", bones)
                far = farthest_out(output)
                self.tell(f"joints of {name}, {bones} bones", [f"one sticks out by {far:.2f} of the thickness"] if far > STICKING_OUT else [])

    def broken(self, folder):
        worm, frames = self.data / "worm", self.data / "mesh-sequence" / "dem-bones" / "frames"
        few = sorted(frames.glob("*.obj"))[:3]

        def copied(name, edit):
            target = folder / name
            target.mkdir()
            for file in few:
                shutil.copy(file, target)
            edit(target / few[1].name)
            return [target]

        def without_last_vertex(file):
            lines = file.read_text().splitlines()
            del lines[max(i for i, line in enumerate(lines) if line.startswith("v "))]
            file.write_text("\n".join(lines))

        def with_nan(file):
            file.write_text(file.read_text().replace("v ", "v nan ", 1))

        self.refused("another vertex count", copied("count", without_last_vertex), few[1].name, folder)
        self.refused("not a number", copied("nan", with_nan), "finite", folder)
        (folder / "empty").mkdir()
        self.refused("an empty folder", [folder / "empty"], "no .obj or .ply", folder)
        cache = (worm / "worm_gravity.pc2").read_bytes()
        for name, content, expected in (
            ("cut.pc2", cache[:-1000], "cut short"),
            ("no_header.pc2", cache[:20], "no PC2"),
            ("nan.pc2", cache[:-12] + struct.pack("<3f", math.nan, 0, 0), "finite"),
            ("other.pc2", (worm / "worm_half_swim.pc2").read_bytes(), "points"),
        ):
            (folder / name).write_bytes(content)
            self.refused(name, [worm / "worm_base.obj", folder / name], expected, folder)
        self.refused("a folder that is not there", [folder / "none"], "none", folder)
        self.warned("the half-resolution body", [worm / "worm_half_swim_base.obj", worm / "worm_half_swim.pc2"], "boundary", folder)


def main():
    if len(sys.argv) not in (3, 4):
        print(__doc__, file=sys.stderr)
        return 2
    paths = [pathlib.Path(word) for word in sys.argv[1:]]
    check = Check(paths[0], paths[1], paths[2] if len(paths) > 2 else None)
    with tempfile.TemporaryDirectory() as name:
        check.own_sequences(pathlib.Path(name))
        if check.data is not None:
            check.broken(pathlib.Path(name))
            check.errors_of_data(pathlib.Path(name))
            check.proofs(pathlib.Path(name))
            check.joints_in_bodies(pathlib.Path(name))
    print(f"{check.passed} passed, {check.failed} failed")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
