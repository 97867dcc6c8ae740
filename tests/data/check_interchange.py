#!/usr/bin/env python3
"""check_interchange.py PROGRAM DATA: files of other programs (DATA/interchange), made glTF by the program, against three.js's own
readers of FBX and BVH: joints within a thousandth of the height at every key, vertices at rest and in three frames. Where
three.js reads otherwise the reason stands beside, and where it is wrong an FBX read by fbx_curves.py decides."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from fbx_curves import Fbx

HERE = pathlib.Path(__file__).resolve().parent
MOST = 1e-3
PICTURE = {"cmu-91_48.fbx": "three.js pairs the keys of x, y and z by number; fbx_curves.py decides",
           "maya_anim_pivot_rotate_7700_ascii.fbx": "three.js turns nothing where only one axis has a curve",
           "maya_anim_no_inherit_scale_7700_ascii.fbx": "three.js lets the scale be inherited once a clip plays",
           "maya_anim_layers_7500_binary.fbx": "layers are not blended by either; three.js plays another one"}
VERTICES = {"blender_293_half_skinned_7400_binary.fbx": "three.js draws vertices without weights at the origin",
            "maya_anim_no_inherit_scale_7700_ascii.fbx": "has no mesh", "maya_anim_layers_7500_binary.fbx": "another layer is played",
            "maya_anim_pivot_rotate_7700_ascii.fbx": "as for the joints"}
Z_UP = {"max_transformed_skin_7500_binary.fbx"}
REFUSED = {"maya_cube_big_endian_7500_binary.fbx": "big endian", "max2009_cube_anim_6100_binary.fbx": "version 6.1"}
WARNED = {"boxing-toes.bvh": "3070", "maya_anim_layers_7500_binary.fbx": "layers", "maya_auto_clamp_7700_binary.fbx": "bend or step between keys",
          "maya_anim_extrapolation_7700_binary.fbx": "beyond their keys", "blender_293_half_skinned_7400_binary.fbx": "2 vertices",
          "cmu-input.bvh": "names no unit"}


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


def by_curves(file, glb, rate):
    """Worst joint of every frame as a share of the height, by the FBX's own curves."""
    fbx = Fbx(file)
    own = json.loads(run("node", HERE / "readers/foreign.mjs", "--places", glb, rate).stdout)
    metres, worst, height = 0.01, 0.0, 0.0
    for frame, places in enumerate(own["frames"]):
        theirs = fbx.places(frame / rate)
        pairs = [(place, [metres * v for v in theirs[name]]) for name, place in zip(own["nodes"], places) if name in theirs]
        height = height or max(max(p[0][a] for p in pairs) - min(p[0][a] for p in pairs) for a in range(3))
        worst = max(worst, max(sum((a - b) ** 2 for a, b in zip(*pair)) ** 0.5 for pair in pairs))
    return worst / height, len(own["frames"])


def check(program, file, folder):
    """Problems of one file, and its row of the table."""
    glb = folder / (file.name + ".glb")
    made = run(program, "resave", file, "-o", glb)
    if file.name in REFUSED:
        told = made.stderr.strip()
        fine = made.returncode == 1 and "\n" not in told and REFUSED[file.name] in told
        return [] if fine else [f"is not refused in one line: {told}"], (file.name, "", "", "", "", "refused: " + told.split(": ")[-1].split(";")[0])
    if made.returncode != 0:
        return [made.stderr.strip()], (file.name, "", "", "", "", made.stderr.strip())
    problems = []
    warnings = json.loads(run(program, "info", file, "--json").stdout)["warnings"]
    if file.name in WARNED and not any(WARNED[file.name] in line for line in warnings):
        problems.append(f"no warning says '{WARNED[file.name]}'")
    found = run("node", HERE / "readers/foreign.mjs", file, glb, "z-up" if file.name in Z_UP else "y-up")
    if found.returncode != 0:
        return [f"three.js: {found.stderr.strip().splitlines()[-1]}"], (file.name, "", "", "", "", "")
    found = json.loads(found.stdout)
    looked = [found["rest"]] + found["clips"]
    joints = max(one["worst"] for one in looked)
    frames, note = sum(clip["frames"] for clip in found["clips"]), PICTURE.get(file.name, "")
    if "fbx_curves" in note:
        joints, frames = by_curves(file, glb, 30)
    if found["missing"]:
        problems.append(f"lacks {found['missing'][:3]}")
    if joints > MOST and (not note or "fbx_curves" in note):
        problems.append(f"a joint is {100 * joints:.3f} % of the height off")
    vertices = found["vertices"]
    if vertices is not None and vertices > MOST and file.name not in VERTICES:
        problems.append(f"a vertex is {100 * vertices:.3f} % of the height off")
    note = "; ".join(text for text in (note, VERTICES.get(file.name, "") if vertices is not None else "") if text)
    shown = "" if vertices is None else f"{100 * vertices:.4f}"
    return problems, (file.name, str(found["joints"]), str(frames), f"{100 * joints:.4f}", shown, note)


def main():
    program, data = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    files = sorted(file for file in (data / "interchange").iterdir() if re.fullmatch(r"\.(fbx|bvh|dae)", file.suffix))
    failed = 0
    print("| file | joints | keys | joints, % of the height | vertices, % | |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as place:
        for file in files:
            problems, row = check(program, file, pathlib.Path(place))
            print("| " + " | ".join(row) + " |")
            failed += 1 if problems else 0
            for problem in problems:
                print(f"FAILED: {file.name}: {problem}")
    print(f"{len(files)} files of other programs, {failed} failed")
    return 1 if failed or not files else 0


if __name__ == "__main__":
    sys.exit(main())
