#!/usr/bin/env python3
"""Draws the bundled punch, its arm three times as long, in each form of a stretch by three.js (readers/pictures.mjs, in Chromium with no screen) and by
`render`, through one camera.

    check_pictures.py PROGRAM [--sheet OUT.png]

- Outlines: what three.js covers and what `render` covers have as much in common as OVERLAP says of what either covers, in each form.
- Shading: where the key light falls on it, a white figure's brightness in our pictures follows from the normals in three.js's, by a formula with ten
  numbers that fits the form `translation`. Where three.js's normals of `scale` and `volume` are over 20 degrees apart, it tells what
  `render --shade-as three` shows of `scale` and of `volume`, and does not tell what `render` shows of `scale` exactly.

With --sheet, a picture of the three forms, ours above three.js's. Exit code 77 where Chromium is missing (Debian's package `chromium`).
"""

import argparse
import copy
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

from check_corpus import read_gltf
from check_exaggeration import READERS, run
from check_readers import glb_of
from vectors import angle, cross, dot, sub, unit

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/pictures"))
import png  # noqa: E402

FORMS = {"scale": ["--form", "scale"], "translation": ["--form", "translation"], "volume": ["--form", "volume", "--influences", "4"]}
FRAME, FPS = 27, 24
EYE, TARGET, FIELD = (-4.0, 2.2, 2.0), (0.0, 0.92, 0.72), 0.5
WIDTH, HEIGHT = 640, 400
SHOWN = (160, 40, 430, 310)  # on the sheet: left, top, width, height
KEY = (-0.55, 1.15, 0.75)  # where the key light of `render` is
LIT = 0.3  # cosine from which a surface casts no shadow on itself
OVERLAP = 0.98
WRONG_DEGREES = 20.0
TOLD = 0.5  # of how far off the formula is where the shading is another one


def with_camera(document, colour):
    """The document with a camera in front of the punch, and one colour for all of the figure, or its own (None)."""
    document = copy.deepcopy(document)
    right, up, back = camera_axes()
    document["cameras"] = [{"type": "perspective", "name": "beside", "perspective": {"yfov": FIELD, "znear": 0.05, "zfar": 100.0}}]
    document["nodes"].append({"name": "beside", "camera": 0, "matrix": [*right, 0, *up, 0, *back, 0, *EYE, 1]})
    document["scenes"][0]["nodes"].append(len(document["nodes"]) - 1)
    if colour is not None:
        for material in document["materials"]:
            material.clear()
            material["pbrMetallicRoughness"] = {"baseColorFactor": [colour] * 3 + [1], "metallicFactor": 0, "roughnessFactor": 1}
        for mesh in document["meshes"]:
            for primitive in mesh["primitives"]:
                primitive["attributes"].pop("COLOR_0", None)
    return document


class Pictures:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        for form, options in FORMS.items():
            run(program, "exaggerate", ROOT / "assets/dummy.glb", "-o", folder / f"{form}.glb", "--limb", "left-arm", "--range", "21:27", "--scale", "3", "--clean", *options)
            document, buffers = read_gltf(folder / f"{form}.glb")
            for name, colour in (("own", None), ("white", 1.0), ("black", 0.0)):
                (folder / f"{form}-{name}.glb").write_bytes(glb_of(with_camera(document, colour), buffers[0]))

    def ours(self, form, colour, shading):
        output = self.folder / f"ours-{form}-{colour}-{shading}.png"
        run(self.program, "render", self.folder / f"{form}-{colour}.glb", "-o", output, "--frame", FRAME, "--fps", FPS, "--camera", "beside", "--size", f"{WIDTH}x{HEIGHT}",
            "--no-trails", "--shade-as", shading)
        return png.read(output)

    def by_three(self, browser):
        """Pictures by form and whether they show normals."""
        output = lambda form, normals: str(self.folder / f"three-{form}-{normals}.png")
        jobs = [{"file": str(self.folder / f"{form}-own.glb"), "clip": 0, "time": FRAME / FPS, "width": WIDTH, "height": HEIGHT, "normals": normals,
                 "output": output(form, normals)} for form in FORMS for normals in (True, False)]
        done = subprocess.run(["node", READERS / "pictures.mjs", browser], input=json.dumps(jobs), capture_output=True, text=True, timeout=600, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"pictures.mjs: {done.stderr.strip()}")
        return {(job["file"].rsplit("/", 1)[1].split("-")[0], job["normals"]): png.read(job["output"]) for job in jobs}


def camera_axes():
    """Right, up and back, which a camera's normals are told in."""
    back = unit(sub(EYE, TARGET))
    right = unit(cross((0.0, 1.0, 0.0), back))
    return right, cross(back, right), back


def brightness(picture):
    """Row by row, of 255."""
    return [row[i] for row in picture.rows for i in range(0, len(row), 3)]


def covered(values):
    """Pixels that are at least half as much above 0 as the one beside them that is most."""
    found = set()
    for i, value in enumerate(values):
        if value > 8 and WIDTH < i < len(values) - WIDTH - 1:
            found |= {i} if 2 * value >= max(values[i + dx + dy * WIDTH] for dx in (-1, 0, 1) for dy in (-1, 0, 1)) else set()
    return found


def covered_by_ours(white, black):
    """Where a figure's own colour shows."""
    return covered([a - b for a, b in zip(brightness(white), brightness(black))])


def normals_of(picture):
    """By pixel, where there is a figure; the background is black, and no normal that a camera sees is."""
    colours = [row[i:i + 3] for row in picture.rows for i in range(0, len(row), 3)]
    return {i: unit([value / 127.5 - 1 for value in colours[i]]) for i in covered([colour[2] for colour in colours])}


def inner(pixels):
    """Those whose neighbours are covered as well: no edge is among them."""
    return {i for i in pixels if all(i + dx + dy * WIDTH in pixels for dx in (-1, 0, 1) for dy in (-1, 0, 1))}


def lit(normal):
    return max(0.0, dot(normal, [dot(axis, unit(KEY)) for axis in camera_axes()]))


def terms(normal):
    x, y, z = normal
    return (1.0, x, y, z, x * x, y * y, x * y, y * z, z * x, lit(normal))


def fitted(samples):
    """The numbers of the formula that tells a brightness from a normal, by least squares."""
    count = len(terms((0, 0, 1)))
    rows = [[0.0] * (count + 1) for _ in range(count)]
    for normal, value in samples:
        told = (*terms(normal), value)
        for a in range(count):
            for b in range(count + 1):
                rows[a][b] += told[a] * told[b]
    for a in range(count):
        pivot = max(range(a, count), key=lambda row: abs(rows[row][a]))
        rows[a], rows[pivot] = rows[pivot], rows[a]
        for row in range(count):
            if row != a:
                factor = rows[row][a] / rows[a][a]
                rows[row] = [value - factor * other for value, other in zip(rows[row], rows[a])]
    return [rows[a][count] / rows[a][a] for a in range(count)]


def off_by(formula, normals, seen, pixels):
    """Root of the mean square of what the formula misses."""
    return math.sqrt(sum((sum(a * b for a, b in zip(formula, terms(normals[i]))) - seen[i]) ** 2 for i in pixels) / len(pixels))


class Check:
    def __init__(self):
        self.failed = 0

    def row(self, good, told):
        self.failed += not good
        print(("" if good else "FAIL ") + told, flush=True)


def compared(check, pictures, three):
    normals = {form: normals_of(three[form, True]) for form in FORMS}
    white = {form: pictures.ours(form, "white", "three") for form in FORMS}
    outlines = {form: covered_by_ours(white[form], pictures.ours(form, "black", "three")) for form in FORMS}
    for form in FORMS:
        both, either = outlines[form] & normals[form].keys(), outlines[form] | normals[form].keys()
        check.row(len(both) >= OVERLAP * len(either), f"{form}: {len(normals[form])} pixels by three.js, {len(outlines[form])} by render, {100 * len(both) / len(either):.2f} % of both in common")
    places = {form: inner(outlines[form] & normals[form].keys()) for form in FORMS}
    seen = {form: brightness(white[form]) for form in FORMS}
    exact = {form: brightness(pictures.ours(form, "white", "exact")) for form in ("scale", "volume")}
    formula = fitted([(normals["translation"][i], seen["translation"][i]) for i in places["translation"] if lit(normals["translation"][i]) > LIT])
    both_lit = [i for i in places["scale"] & places["volume"] if min(lit(normals["volume"][i]), lit(normals["scale"][i])) > LIT]
    wrong = [i for i in both_lit if math.degrees(angle(normals["scale"][i], normals["volume"][i])) > WRONG_DEGREES]
    as_three, as_exact, of_volume = (off_by(formula, normals[form], picture, wrong)
                                     for form, picture in (("scale", seen["scale"]), ("scale", exact["scale"]), ("volume", seen["volume"])))
    told = f"{len(wrong)} lit pixels of scale turned over {WRONG_DEGREES:.0f} degrees by three.js: its normals tell ours shaded as three within {as_three:.1f} of 255, "
    check.row(len(wrong) > 300 and as_three <= TOLD * as_exact and of_volume <= TOLD * as_exact,
              f"{told}ours shaded exactly within {as_exact:.1f}, volume within {of_volume:.1f}")


def on_grey(picture):
    """three.js's picture with the background of ours, about."""
    return png.Picture(picture.width, picture.height, tuple(bytes(v for i in range(0, len(row), 3) for v in (row[i:i + 3] if any(row[i:i + 3]) else (40, 40, 46))) for row in picture.rows))


def sheet(pictures, three, output):
    rows = ()
    for line in ([pictures.ours(form, "own", "exact") for form in FORMS], [on_grey(three[form, False]) for form in FORMS]):
        parts = [png.cropped(picture, *SHOWN) for picture in line]
        rows += png.beside(png.beside(parts[0], parts[1]), parts[2]).rows
    output.write_bytes(png.still(png.Picture(3 * SHOWN[2], len(rows), rows)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--sheet", type=pathlib.Path)
    arguments = parser.parse_args()
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    if browser is None:
        print("skipped: pictures by three.js need Chromium")
        return 77
    check = Check()
    with tempfile.TemporaryDirectory() as folder:
        pictures = Pictures(arguments.program.resolve(), pathlib.Path(folder))
        three = pictures.by_three(browser)
        compared(check, pictures, three)
        if arguments.sheet:
            sheet(pictures, three, arguments.sheet)
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
