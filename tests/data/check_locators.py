#!/usr/bin/env python3
"""Takes the skeletons from the characters of a data folder and measures how far the locators that the program fits to the bare meshes are from
where the artists put the joints.


- Every character: each joint within 5 % of the height of the artist's, the mean of them within 2.5 % (LOOSER says which may be farther).
- The same body lying, upside down, turned, in units of 1e-4 and 1e5: the same joints.
- A mesh of 200,000 triangles and one of 500,000 in SECONDS_AT_MOST.
- A file without a mesh, a triangle, a plane: one line, nothing written, by rig and by bind.
- Bodies that are no bipeds are read as what they are: the limbs that the program finds in the artist's skeleton, each joint against the locator of the same limb
  that stands for it, in the mean within 5 % of the largest extent; what is not clear is refused in one line. With --plan biped they are told to be none; the dummy is bound however it lies and whatever its units are.
- rig builds joints in which the program finds all six limbs; moved locators given back are where the joints then are.

"""

import argparse
import json
import math
import pathlib
import struct
import sys
import tempfile
import time

from check_corpus import read_gltf, run
from unskinned import placed_skins, rest_worlds, unskinned

EACH, MEAN = 5.0, 2.5  # percent of the height
SECONDS_AT_MOST = 30
ARM, LEG = ("UpperArm", "LowerArm", "Hand"), ("UpperLeg", "LowerLeg", "Foot")
CHARACTERS = ["biped/CesiumMan.glb", "biped/mannequiny-0.3.0.glb", "biped/human-addon-animations.glb", "biped/Knight.glb",
              "biped/rpg-lowpoly-skeleton.glb", "biped/boxman.glb", "biped/robot.glb", "biped/kenney-platformer-character/character.glb",
              "vrm/cryptovoxels.vrm", "bodies/model-human.glb", "hard/gdbot.glb", "hard/lumberjack.glb", "hard/quaternius-orc.glb", "hard/rigify-222-character.glb"]
SKELETONS = {"bodies/model-human.glb": "bodies/rig-human.glb"}
CREATURES = ["quadruped/Fox.glb", "hard/quaternius-Donkey.glb", "bodies/dragon-animations.glb", "bodies/bird-animations.glb", "hard/quaternius-Trex.glb",
             "bodies/spider-animations.glb", "hard/quaternius-Spider.glb"]
CREATURE_MEAN = 5.0  # percent of the largest extent
UNCLEAR = ["bodies/snake-animations.glb", "hard/quaternius-Bee.glb"]
# Names of locators by limb; % stands for the side.
TRUNK = {"spine": ["hips", "spine", "chest"], "neck": ["chest", "neck", "head"]}
WING = {"%-wing": ["%Wing1", "%Wing2", "%Wing3", "%Wing4"]}
LOCATORS_OF = {
    "quadruped": {**TRUNK, **WING, "front-%-leg": ["%Shoulder", "%Elbow", "%Wrist", "%FrontPaw"], "hind-%-leg": ["%Hip", "%Knee", "%Hock", "%HindPaw"],
                  "tail": ["tail1", "tail2", "tail3", "tail4"]},
    "bird": {**TRUNK, **WING, "%-leg": ["%Hip", "%Knee", "%Ankle", "%Foot"], "%-arm": ["%UpperArm", "%LowerArm", "%Hand"], "tail": ["tail1", "tail2", "tail3"]},
    "spider": {"spine": ["thorax", "head"], "tail": ["abdomen1", "abdomen2"],
               **{f"%-leg{'' if row == 1 else -row}": [f"%Leg{row}{joint}" for joint in ("Base", "Knee", "Ankle", "Foot")] for row in range(1, 5)}}}
# What the fit does not reach: (each, mean) in percent of the height.
LOOSER = {"rpg-lowpoly-skeleton": (6.0, MEAN), "character": (5.5, MEAN), "robot": (6.0, MEAN), "gdbot": (8.5, 4.5), "lumberjack": (9.0, 5.0),
          "quaternius-orc": (6.5, 4.5), "rigify-222-character": (6.5, 3.5)}


def info_of(program, file):
    status, output, told = run(program, "info", file, "--json", "--tolerant")
    if status != 0:
        raise RuntimeError(told)
    return json.loads(output)


def artists_joints(program, skeleton, places):
    """Places by the names of locators, of the limbs that the program finds in the character as it came."""
    info = info_of(program, skeleton)
    joints = {}
    for limb in info["limbs"]:
        nodes = [joint["node"] for joint in limb["joints"]]
        side, _, kind = limb["limb"].partition("-")
        if kind in ("arm", "leg"):
            for name, node in zip(ARM if kind == "arm" else LEG, nodes):
                joints[side + name] = places.get(node)
        elif limb["limb"] == "neck":
            joints["neck"], joints["head"] = places.get(nodes[0]), places.get(nodes[-1])
    controllers = {c["controller"]: c for c in info["controllers"] if "controller" in c}
    if "joint" in controllers.get("hips", {}):
        joints["hips"] = places.get(controllers["hips"]["joint"]["node"])
    return {name: place for name, place in joints.items() if place is not None and any(place)}


def mesh_and_joints(program, data, name, folder):
    file = data / name if not isinstance(name, pathlib.Path) else name
    mesh = folder / f"{file.stem}.gltf"
    places = unskinned(file, mesh)
    skeleton = file
    if str(name) in SKELETONS:
        skeleton = data / SKELETONS[str(name)]
        document, buffers = read_gltf(skeleton)
        places = placed_skins(document, buffers, *rest_worlds(document["nodes"]))[1]
    # In the mesh's own units, which those of its scene may not be.
    return mesh, artists_joints(program, skeleton, places), info_of(program, mesh)["height"]


def fitted(program, mesh, output):
    status, _, told = run(program, "rig", mesh, "-o", output, "--locators-only", "--tolerant")
    if status != 0 or "no biped" in told:
        raise RuntimeError(f"{mesh.name}: {told}")
    return {entry["name"]: entry["position"] for entry in json.loads(output.read_text())["locators"]}


def misses(joints, locators, height):
    return {name: 100.0 * math.dist(place, locators[name]) / height for name, place in joints.items()}


def moved_copy(mesh, output, matrix):
    document = json.loads(mesh.read_text())
    document["nodes"].append({"children": document["scenes"][0]["nodes"], "matrix": matrix})
    document["scenes"][0]["nodes"] = [len(document["nodes"]) - 1]
    output.write_text(json.dumps(document))
    return output


def times(matrix, place):
    return [sum(matrix[4 * k + row] * place[k] for k in range(3)) + matrix[12 + row] for row in range(3)]


MOVES = {"lying": [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1], "upside down": [-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
         "turned": [0.6, 0, -0.8, 0, 0, 1, 0, 0, 0.8, 0, 0.6, 0, 5, 1, -3, 1],
         "units of 1e-4": [1e-4, 0, 0, 0, 0, 1e-4, 0, 0, 0, 0, 1e-4, 0, 0, 0, 0, 1], "units of 1e5": [1e5, 0, 0, 0, 0, 1e5, 0, 0, 0, 0, 1e5, 0, 0, 0, 0, 1]}


def finer(mesh, output, at_least):
    """The mesh with each triangle cut in four until there are so many."""
    document, buffers = read_gltf(mesh)
    positions, faces = [], []
    for primitive in document["meshes"][0]["primitives"]:
        first = len(positions)
        positions += accessor(document, buffers, primitive["attributes"]["POSITION"], "3f")
        faces += [first + index[0] for index in accessor(document, buffers, primitive["indices"], None)]
    faces = [tuple(faces[i:i + 3]) for i in range(0, len(faces), 3)]
    while len(faces) < at_least:
        middles, cut = {}, []
        for face in faces:
            mids = []
            for a, b in ((0, 1), (1, 2), (2, 0)):
                edge = tuple(sorted((face[a], face[b])))
                if edge not in middles:
                    middles[edge] = len(positions)
                    positions.append(tuple(0.5 * (p + q) for p, q in zip(positions[edge[0]], positions[edge[1]])))
                mids.append(middles[edge])
            cut += [(face[0], mids[0], mids[2]), (face[1], mids[1], mids[0]), (face[2], mids[2], mids[1]), tuple(mids)]
        faces = cut
    write_mesh(output, positions, faces, document["nodes"][0].get("matrix"))
    return len(positions), len(faces)


def accessor(document, buffers, index, form):
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    form = form or {5121: "B", 5123: "H", 5125: "I"}[accessor["componentType"]]
    size = struct.calcsize("<" + form)
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    return [struct.unpack_from("<" + form, buffers[view["buffer"]], start + i * view.get("byteStride", size)) for i in range(accessor["count"])]


def write_mesh(output, positions, faces, matrix=None):
    binary = b"".join(struct.pack("<3f", *p) for p in positions) + b"".join(struct.pack("<3I", *f) for f in faces)
    split = 12 * len(positions)
    output.with_suffix(".bin").write_bytes(binary)
    low, high = ([f(p[i] for p in positions) for i in range(3)] for f in (min, max))
    low, high = ([struct.unpack("<f", struct.pack("<f", x))[0] for x in bound] for bound in (low, high))
    output.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, **({"matrix": matrix} if matrix else {})}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(binary), "uri": output.with_suffix(".bin").name}],
        "bufferViews": [{"buffer": 0, "byteLength": split}, {"buffer": 0, "byteOffset": split, "byteLength": len(binary) - split}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(positions), "type": "VEC3", "min": low, "max": high},
                      {"bufferView": 1, "componentType": 5125, "count": 3 * len(faces), "type": "SCALAR"}]}))


def table_row(name, misses_of):
    worst = max(misses_of, key=misses_of.get)
    mean = sum(misses_of.values()) / len(misses_of)
    return mean, misses_of[worst], f"| {name} | {len(misses_of)} | {mean:.1f} | {misses_of[worst]:.1f} | {worst} |"


def character_problems(program, data, name, folder, rows):
    mesh, joints, height = mesh_and_joints(program, data, name, folder)
    of_each = misses(joints, fitted(program, mesh, folder / "locators.json"), height)
    mean, worst, row = table_row(mesh.stem, of_each)
    rows.append(row)
    each_goal, mean_goal = LOOSER.get(mesh.stem, (EACH, MEAN))
    problems = [f"{mesh.stem}: {joint} is {miss:.1f} % of the height off" for joint, miss in of_each.items() if miss > each_goal]
    return problems + ([f"{mesh.stem}: the mean is {mean:.2f} % of the height off"] if mean > mean_goal else [])


def move_problems(program, dummy, folder):
    mesh, joints, height = mesh_and_joints(program, None, dummy, folder)
    problems = []
    for what, matrix in MOVES.items():
        unit = math.hypot(*matrix[:3])
        locators = fitted(program, moved_copy(mesh, folder / "moved.gltf", matrix), folder / "moved.json")
        of_each = misses({joint: times(matrix, place) for joint, place in joints.items()}, locators, unit * height)
        problems += [f"{what}: {joint} is {miss:.1f} % of the height off" for joint, miss in of_each.items() if miss > EACH]
    return problems


def size_problems(program, dummy, folder):
    problems = []
    mesh, joints, height = mesh_and_joints(program, None, dummy, folder)
    for triangles in (200_000, 500_000):
        fine = folder / "fine.gltf"
        vertices, faces = finer(mesh, fine, triangles)
        start = time.monotonic()
        locators = fitted(program, fine, folder / "fine.json")
        seconds = time.monotonic() - start
        print(f"{vertices} vertices, {faces} triangles: {seconds:.1f} s")
        worst = max(misses(joints, locators, height).values())
        if seconds > SECONDS_AT_MOST or worst > EACH:
            problems.append(f"{faces} triangles: {seconds:.1f} s, {worst:.1f} % of the height off")
    return problems


def refusal_problems(program, folder):
    cases = {"a triangle": [(0, 1, 2)], "a plane": [(0, 1, 2), (0, 2, 3)]}
    problems = []
    for what, faces in cases.items():
        write_mesh(folder / "odd.gltf", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], faces)
        problems += refused(program, folder / "odd.gltf", folder / "refused.glb", what)
    (folder / "empty.gltf").write_text(json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{}]}))
    return problems + refused(program, folder / "empty.gltf", folder / "refused.glb", "no mesh")


def refused(program, file, output, what):
    problems = []
    for verb in ("rig", "bind"):
        status, _, told = run(program, verb, file, "-o", output)
        if status != 1 or told.count("\n") != 1 or "by hand" not in told or output.exists():
            problems.append(f"{verb}, {what}: status {status}, told {told!r}, written {output.exists()}")
    return problems


def nearest_pairs(some, more):
    """Of two rows of places the shorter one paired with places of the longer one in their order, as near as may be."""
    if len(some) > len(more):
        return [(b, a) for a, b in nearest_pairs(more, some)]
    if not some:
        return []
    best, pairs = math.inf, []
    for first in range(len(more) - len(some) + 1):
        rest = nearest_pairs(some[1:], more[first + 1 :])
        cost = math.dist(some[0], more[first]) + sum(math.dist(*pair) for pair in rest)
        if cost < best:
            best, pairs = cost, [(some[0], more[first]), *rest]
    return pairs


def extent(mesh):
    document, buffers = read_gltf(mesh)
    places = []
    for node in document["nodes"]:
        for primitive in document["meshes"][node["mesh"]]["primitives"]:
            places += [times(node["matrix"], place) for place in accessor(document, buffers, primitive["attributes"]["POSITION"], "3f")]
    return max(max(axis) - min(axis) for axis in zip(*places))


def creature_problems(program, data, name, folder, rows):
    file, mesh = data / name, folder / "creature.gltf"
    places = unskinned(file, mesh)
    info = json.loads(run(program, "info", file, "--json", "--tolerant")[1])
    plan, output = info["plan"], folder / "creature.json"
    status, _, told = run(program, "rig", mesh, "-o", output, "--locators-only", "--tolerant")
    if status != 0:
        return [f"{name}: {told}"]
    fitted_to = json.loads(output.read_text())
    if fitted_to["plan"] != plan:
        return [f"{name}: a {plan} is fitted as a {fitted_to['plan']}"]
    locators = {entry["name"]: entry["position"] for entry in fitted_to["locators"]}
    artists = {limb["limb"]: [places[joint["node"]] for joint in limb["joints"] if joint["node"] in places] for limb in info["limbs"]}
    size, of_each, problems = extent(mesh), {}, []
    for limb, names in LOCATORS_OF[plan].items():
        for side in ("left", "right") if "%" in limb else ("",):
            row = [locators[one.replace("%", side)] for one in names if one.replace("%", side) in locators]
            joints = [place for place in artists.get(limb.replace("%", side), []) if any(place)]
            if joints and not row:
                problems.append(f"{name}: no locators of {limb.replace('%', side)}")
            for number, (joint, place) in enumerate(nearest_pairs(joints, row)):
                of_each[f"{limb.replace('%', side)} {number + 1}"] = 100.0 * math.dist(joint, place) / size
    mean, _, row = table_row(f"{file.stem} ({plan})", of_each)
    rows.append(row)
    bound = folder / "creature.glb"
    run(program, "bind", mesh, "-o", bound, "--tolerant")
    found = json.loads(run(program, "info", bound, "--json")[1])
    lacking = {limb for limb in artists if limb not in {one["limb"] for one in found["limbs"]}}
    if found["plan"] != plan or lacking:
        problems.append(f"{name}: bound, it is a {found['plan']} without {sorted(lacking)}")
    return problems + ([f"{name}: the mean is {mean:.2f} % of the size off"] if mean > CREATURE_MEAN else [])


def doubt_problems(program, data, folder):
    problems = []
    for name in [*CREATURES, *UNCLEAR]:
        mesh = folder / "other.gltf"
        unskinned(data / name, mesh)
        status, _, told = run(program, "rig", mesh, "-o", folder / "other.glb", "--tolerant", "--plan", "biped")
        if "no biped" not in told and "neither two legs nor two arms" not in told and "no two legs" not in told:
            problems.append(f"{name}: taken for a biped, status {status}, told {told!r}")
    for name in UNCLEAR:
        unskinned(data / name, mesh)
        for verb in ("rig", "bind"):
            status, _, told = run(program, verb, mesh, "-o", folder / "unclear.glb", "--tolerant")
            if status != 1 or told.count("\n") != 1 or "--plan" not in told:
                problems.append(f"{verb}, {name}: not refused in a line that names --plan: status {status}, told {told!r}")
    return problems


def bind_problems(program, dummy, folder):
    """However the dummy lies and whatever its units are, it is bound, and its limbs are found in the result."""
    mesh, _, _ = mesh_and_joints(program, None, dummy, folder)
    problems = []
    for what, matrix in MOVES.items():
        output = folder / "bound.glb"
        status, _, told = run(program, "bind", moved_copy(mesh, folder / "moved.gltf", matrix), "-o", output)
        limbs = json.loads(run(program, "info", output, "--json")[1])["limbs"] if status == 0 else []
        if len(limbs) != 6:
            problems.append(f"bind, {what}: status {status}, told {told!r}, {len(limbs)} limbs")
        output.unlink(missing_ok=True)
    return problems


def building_problems(program, dummy, folder):
    mesh, _, _ = mesh_and_joints(program, None, dummy, folder)
    fitted(program, mesh, folder / "given.json")
    given = json.loads((folder / "given.json").read_text())
    for entry in given["locators"]:
        entry["position"] = [x + 0.01 for x in entry["position"]]
    (folder / "given.json").write_text(json.dumps(given))
    output = folder / "rigged.glb"
    status, _, told = run(program, "rig", mesh, "-o", output, "--locators", folder / "given.json")
    if status != 0:
        return [told]
    limbs = {limb["limb"] for limb in json.loads(run(program, "info", output, "--json")[1])["limbs"]}
    document, _ = read_gltf(output)
    worlds, _ = rest_worlds(document["nodes"])
    places = {node.get("name"): world[12:15] for node, world in zip(document["nodes"], worlds)}
    problems = [f"rig: {e['name']} is not where its locator is" for e in given["locators"] if math.dist(places[e["name"]], e["position"]) > 1e-5]
    return problems + ([] if len(limbs) == 6 else [f"rig: only {sorted(limbs)} are found in what was built"])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    dummy = pathlib.Path(__file__).resolve().parents[2] / "assets" / "dummy.glb"
    problems, rows = [], []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for character in [dummy, *CHARACTERS]:
            problems += character_problems(program, arguments.data, character, folder, rows)
        for creature in CREATURES:
            problems += creature_problems(program, arguments.data, creature, folder, rows)
        problems += move_problems(program, dummy, folder)
        problems += refusal_problems(program, folder)
        problems += doubt_problems(program, arguments.data, folder)
        problems += bind_problems(program, dummy, folder)
        problems += building_problems(program, dummy, folder)
        problems += size_problems(program, dummy, folder)
    print("\n".join(["| character | joints | mean % | worst % | which |", "|---|---|---|---|---|", *rows]))
    for problem in problems:
        print(problem)
    print(f"{len(rows)} characters, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
