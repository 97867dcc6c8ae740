#!/usr/bin/env python3
"""Saves an exaggerated limb of every character of a data folder in each form of a stretch, and has an evaluator that is not ours compare them.

    check_forms.py PROGRAM DATA_FOLDER [FILE...]

For each file the arm, leg or the like that moves most, in the clip in which it does, three times as long, saved without the work. At up to 9 moments of range and release, all vertices, of
three.js's nodes and skinning in JavaScript (readers/forms.mjs), which takes every set of influences:
- `volume` with eight influences against `scale`: 1e-5 of the height;
- normals of `volume` against `translation`: 1 degree;
- `volume` with four influences against `scale`: no farther than the program tells, with a tenth more between the moments that it looks at;
- what `check --engine three` forecasts of `scale` against three.js's own skinning (readers/shading.mjs): as many vertices shaded wrongly as there are, each
  taken for a degree more or less, and none that is worse by more than a degree;
- no error or warning of the Khronos validator that the source did not have.
Prints one row a file: nodes that are new, vertices that are fitted, distances in percent of the height, degrees, vertices shaded wrongly as forecast and as three.js does.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

from check_exaggeration import Reader, clip_motion, reaches_out, run

READERS = pathlib.Path(__file__).resolve().parent / "readers"
PLACES = 1e-5
DEGREES = 1.0
MOMENTS = 9
FOLDERS = ("biped/*.glb", "biped/*/*.glb", "quadruped/*.glb", "bodies/*-animations.glb", "vrm/*.vrm")
FORMS = {"scale": [], "translation": ["--form", "translation"], "volume": ["--form", "volume"], "four": ["--form", "volume", "--influences", "4"]}


def compared(file, other, clip, height, times):
    done = subprocess.run(["node", READERS / "forms.mjs", file, other, str(clip), str(height), *times], capture_output=True, text=True, timeout=600, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"forms.mjs: {done.stderr.strip().splitlines()[-1] if done.stderr.strip() else 'failed'}")
    return json.loads(done.stdout)


WRONG = re.compile(r"at frame (?P<frame>[\d.]+) (?P<wrong>\d+) of the .* at worst (?P<worst>\d+) degrees")


def forecast_of(program, file, clip):
    """Frame, vertices shaded wrongly there, and the worst angle at any frame; nothing where none is forecast."""
    answer = subprocess.run([program, "check", file, "--engine", "three", "--json"], capture_output=True, text=True, check=False).stdout
    findings = json.loads(answer)["engines"][0]["findings"]
    told = [WRONG.search(one["what"]) for one in findings if one["id"] == "shading-plain-matrix" and one["clip"] == clip]
    if None in told:
        raise RuntimeError("what is told of shading reads otherwise")
    return (float(told[0]["frame"]), int(told[0]["wrong"]), float(told[0]["worst"])) if told else None


def shaded(file, clip, times):
    done = subprocess.run(["node", READERS / "shading.mjs", file, str(clip), *map(str, times)], capture_output=True, text=True, timeout=600, check=True)
    return json.loads(done.stdout)


class Check:
    def __init__(self, program):
        self.program, self.reader, self.failed, self.four = program, Reader(), 0, []

    def saved(self, file, info, folder):
        """Reports of the file in each form, and the clip, frames and limb."""
        moving = [(clip_motion(self.program, file, clip, limb["limb"]), clip, limb["limb"])
                  for limb in info["limbs"] if reaches_out(limb) for clip in range(min(len(info["clips"]), 4))]
        _, clip, limb = max(moving)
        command = [self.program, "exaggerate", file, "--clip", f"#{clip}", "--limb", limb, "--scale", "3", "--clean", "--json"]
        return {name: json.loads(run(*command, "-o", folder / f"{name}.glb", *options)) for name, options in FORMS.items()}, clip, limb

    def shading(self, file, info, clip, times):
        """What is forecast, and three.js's own at its frame and at all the moments."""
        forecast = forecast_of(self.program, file, info["clips"][clip]["name"])
        at = [] if forecast is None else [forecast[0] / info["clips"][clip]["fps"]]
        return forecast, shaded(file, clip, [*at, *times])

    @staticmethod
    def agree(forecast, seen):
        worst = max(frame["worst"] for frame in seen)
        if forecast is None:
            return worst <= 21
        fewest, most = seen[0]["over"][2], seen[0]["over"][0]
        return fewest <= forecast[1] <= most and worst <= forecast[2] + 1.5

    def file(self, file, folder):
        info = json.loads(run(self.program, "info", file, "--json"))
        if not info["clips"] or not any(reaches_out(limb) for limb in info["limbs"]):
            return
        reports, clip, limb = self.saved(file, info, folder)
        trail, fps = reports["scale"]["trails"][0], info["clips"][clip]["fps"]
        start, stop = trail["range"][0] / fps, min((trail["range"][1] + trail["release"]) / fps, info["clips"][clip]["seconds"])
        times = [str(start + (stop - start) * i / (MOMENTS - 1)) for i in range(MOMENTS)]
        ask = lambda a, b: compared(folder / f"{a}.glb", folder / f"{b}.glb", clip, info["height"], times)
        places, normals, four = ask("volume", "scale")["places"], ask("volume", "translation")["normals"], ask("four", "scale")["places"]
        forecast, seen = self.shading(folder / "scale.glb", info, clip, times)
        told = {name: reports[name]["form"]["miss_percent_of_height"] for name in ("volume", "four")}
        worse = [line for name in FORMS for line in self.reader.worse(folder / f"{name}.glb", file)]
        fitted = reports["volume"]["form"]["fitted_vertices"]
        good = {"places": places <= PLACES, "normals": normals["exact"] <= DEGREES,
                "four": four <= PLACES + 1.1 * told["four"]["worst"] / 100, "validator": not worse, "shading": self.agree(forecast, seen)}
        self.failed += not all(good.values())
        self.four.append(told["four"]["percentile_99"])
        wrong = " ".join(name for name, holds in good.items() if not holds)
        form = reports["volume"]["form"]
        print(f"{'FAIL ' + wrong + ' ' if wrong else ''}{file.name}: {limb}, {form['corners']} corners, {form['vertices']} vertices, {fitted} beyond 8: {100 * places:.4f} %, "
              f"{normals['exact']:.2f} degrees; four: 99th {told['four']['percentile_99']:.3f} %, worst {told['four']['worst']:.3f} %, seen {100 * four:.3f} %; "
              f"shaded wrongly: {0 if forecast is None else forecast[1]}, three.js {seen[0]['over'][1]}" + "".join(f"\n  {line}" for line in worse), flush=True)


def main():
    program, data, *files = map(pathlib.Path, sys.argv[1:])
    check = Check(program.resolve())
    with tempfile.TemporaryDirectory() as folder:
        for file in files or sorted({file for pattern in FOLDERS for file in data.glob(pattern)}):
            try:
                check.file(file, pathlib.Path(folder))
            except (RuntimeError, subprocess.TimeoutExpired) as problem:
                check.failed += 1
                print(f"FAIL {file.name}: {problem}", flush=True)
    print(f"four influences: {sum(value <= 0.5 for value in check.four)} of {len(check.four)} files within 0.5 % at the 99th percentile")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
