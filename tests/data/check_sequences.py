#!/usr/bin/env python3
"""Compresses real mesh sequences and has three.js and the Khronos validator read the result; gives the program broken ones.

    check_sequences.py PROGRAM DUMP_VERTICES DATA_FOLDER

For each sequence, stretch option and encoding:
- every vertex of some frames, as three.js skins the file, against the program's own (1e-4 of the diagonal);
- the error of the written file against the source, as `compare` measures it, against what `compress` said of its own vertices;
- no error or warning of the validator.
Broken sequences: status 1, one line that names the place, and nothing written. Flawed but usable ones: a warning.
"""

import json
import math
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

READERS = pathlib.Path(__file__).resolve().parent / "readers"
VERTEX_TOLERANCE = 1e-4  # of the diagonal
ERROR_TOLERANCE = 5e-3  # RMSE, percent of the diagonal: what 16-bit rotations may cost
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
    if len(sys.argv) != 4:
        print(__doc__, file=sys.stderr)
        return 2
    check = Check(*map(pathlib.Path, sys.argv[1:]))
    with tempfile.TemporaryDirectory() as name:
        check.broken(pathlib.Path(name))
        check.proofs(pathlib.Path(name))
    print(f"{check.passed} passed, {check.failed} failed")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
