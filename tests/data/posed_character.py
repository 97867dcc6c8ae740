"""A biped of the data folder, the program that poses it, and three.js that says where the result is."""

import base64
import json
import pathlib
import struct
import urllib.parse

from check_corpus import read_gltf
from check_exaggeration import clip_motion, run
from vectors import cross, dot, place, scaled, sub, unit

MOST_FRAMES = 24
BAT_LENGTH = 0.5  # of the height
IMAGE_TYPES = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg", ".webp": "image/webp"}
ZERO = [0.0, 0.0, 0.0]


def flat(frame, **offset):
    return {"frame": frame, "interpolation": "flat", **offset}


def with_a_bat(file, height, output):
    """The file with a node 'Bat', a thin box beside the character, and with a clip that stands still where it has none."""
    document, buffers = read_gltf(file)
    length = BAT_LENGTH * height
    corners = [(x * 0.03 * height, y * length, z * 0.03 * height) for x in (-1, 1) for y in (0, 1) for z in (-1, 1)]
    faces = [0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3]
    data = struct.pack("<24f36H2f6f", *(c for corner in corners for c in corner), *faces, 0.0, 1.0, *(2 * [0.5 * height, 0.0, 0.0]))
    for index, content in enumerate(buffers):
        buffer = document["buffers"][index]
        if "extensions" not in buffer and not buffer.get("uri", "").startswith("data:"):
            buffer["uri"] = "data:application/octet-stream;base64," + base64.b64encode(content).decode()
    for image in document.get("images", []):
        beside = file.parent / urllib.parse.unquote(image.get("uri", ""))
        if "uri" in image and not image["uri"].startswith("data:") and beside.is_file():
            image["uri"] = f"data:{IMAGE_TYPES[beside.suffix]};base64," + base64.b64encode(beside.read_bytes()).decode()
    document.setdefault("buffers", []).append(
        {"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()})
    views, accessors = document.setdefault("bufferViews", []), document.setdefault("accessors", [])
    first_view, first = len(views), len(accessors)
    for offset, size in ((0, 96), (96, 72), (168, 8), (176, 24)):
        views.append({"buffer": len(document["buffers"]) - 1, "byteOffset": offset, "byteLength": size})
    low, high = [min(c[i] for c in corners) for i in range(3)], [max(c[i] for c in corners) for i in range(3)]
    rounded = [[struct.unpack("<f", struct.pack("<f", value))[0] for value in bound] for bound in (low, high)]
    accessors += [{"bufferView": first_view, "componentType": 5126, "count": 8, "type": "VEC3", "min": rounded[0], "max": rounded[1]},
                  {"bufferView": first_view + 1, "componentType": 5123, "count": 36, "type": "SCALAR"},
                  {"bufferView": first_view + 2, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0.0], "max": [1.0]},
                  {"bufferView": first_view + 3, "componentType": 5126, "count": 2, "type": "VEC3"}]
    document["meshes"].append({"name": "Bat", "primitives": [{"attributes": {"POSITION": first}, "indices": first + 1}]})
    document["nodes"].append({"name": "Bat", "mesh": len(document["meshes"]) - 1, "translation": [0.5 * height, 0.0, 0.0]})
    document["scenes"][document.get("scene", 0)]["nodes"].append(len(document["nodes"]) - 1)
    if not document.get("animations"):
        target = {"node": len(document["nodes"]) - 1, "path": "translation"}
        document["animations"] = [{"name": "still", "samplers": [{"input": first + 2, "output": first + 3}],
                                   "channels": [{"sampler": 0, "target": target}]}]
    output.write_text(json.dumps(document))
    return output


class Character:
    """What the program finds in a file, which gets a clip and a bat in `folder` where it has no clip."""

    def __init__(self, program, reader, file, folder):
        self.program, self.reader, self.file = program, reader, file
        self.info = json.loads(run(program, "info", file, "--json"))
        if not self.info["clips"]:
            self.file = with_a_bat(file, self.info["height"], folder / f"{file.stem}.gltf")
            self.info = json.loads(run(program, "info", self.file, "--json"))
        self.gltf = read_gltf(self.file)[0]
        self.height = self.info["height"]
        self.limbs = {limb["limb"]: [joint["node"] for joint in limb["joints"]] for limb in self.info["limbs"]}
        self.whole = {limb["limb"] for limb in self.info["limbs"] if limb["end"] != "estimated"}
        moving = "left-arm" if "left-arm" in self.limbs else next(iter(self.limbs))
        self.clip = max(range(len(self.info["clips"])), key=lambda clip: clip_motion(program, self.file, clip, moving))
        clip = self.info["clips"][self.clip]
        self.fps, self.last = clip["fps"], min(int(clip["seconds"] * clip["fps"] + 1e-3), MOST_FRAMES)
        self.full = max(1, self.last // 2)  # the frame from which a pose is held
        self.controllers = {c["controller"]: c for c in self.info["controllers"] if "controller" in c}
        self.attributes = {c["attribute"] for c in self.info["controllers"] if "attribute" in c}
        self.joints = {name: c["joint"]["node"] for name, c in self.controllers.items() if "joint" in c}
        self.bones = sorted({joint["node"] for skin in self.info["joints"] for joint in skin} | {n for limb in self.limbs.values() for n in limb} | set(self.joints.values()))
        self.kept = {}

    def pose(self, folder, adjustments, *more, **lists):
        recipe = folder / "recipe.json"
        recipe.write_text(json.dumps({"version": 1, "adjustments": adjustments, **lists}))
        output = folder / f"posed{self.file.suffix if self.file.suffix == '.gltf' else '.glb'}"
        report = run(self.program, "pose", self.file, "-o", output, "--recipe", recipe, "--clip", f"#{self.clip}", "--clean", "--json", *more)
        return output, json.loads(report)

    def worlds(self, file, nodes, frames):
        """World matrices: for each node one at each frame."""
        wanted = [f"#{node}" for node in nodes]
        answer = self.reader.ask(do="measure", file=file, clip=f"#{self.clip}", times=[frame / self.fps for frame in frames], nodes=wanted, step=0,
                                 matrices=True)
        return dict(zip(nodes, answer["nodes"].values()))

    def source(self, frames):
        """World matrices of all bones in the source."""
        key = tuple(frames)
        if key not in self.kept:
            self.kept[key] = self.worlds(self.file, self.bones, frames)
        return self.kept[key]

    def places(self, file, node, frames):
        return [place(matrix) for matrix in self.worlds(file, [node], frames)[node]]

    def keys(self, **offset):
        frames = sorted({0, self.last / 2, self.last / 3 + 0.5, self.last} if self.last > 2 else {0, self.last})
        return [{"frame": frame, **offset} for frame in frames]

    def rising(self, **offset):
        """Keys from nothing to an offset that is held from the frame `full` on; rises as 3 u^2 - 2 u^3."""
        nothing = {name: ZERO if isinstance(value, list) else 0.0 for name, value in offset.items()}
        return [flat(0, **nothing), flat(self.full, **offset)]

    def held_frames(self):
        return [half / 2 for half in range(2 * self.full, 2 * self.last + 1)]

    def all_frames(self):
        return [half / 2 for half in range(2 * self.last + 1)]

    def space(self, folder, controller):
        """Where a controller stands at the frame `full`, and the world directions along which its moves count there."""
        step = 0.1 * self.height
        asked = []
        for move in ([step, 0, 0], [0, step, 0], [0, 0, step], [-step, 0, 0]):
            _, report = self.pose(folder, [{"controller": controller, "keys": [{"frame": self.full, "move": move}]}], units="metres")
            asked.append(report["controllers"][0]["keys"][0]["asked"])
        stands = scaled([a + b for a, b in zip(asked[0], asked[3])], 0.5)
        return stands, [unit(sub(point, stands)) for point in asked[:3]]

    def facing(self):
        """Left, up and forward of the body at the frame `full`, level."""
        worlds = self.source([self.full])
        pair = ("left-leg", "right-leg") if "left-leg" in self.limbs else ("left-arm", "right-arm")
        left = sub(*(place(worlds[self.limbs[limb][0]][0]) for limb in pair))
        left = unit([left[0], 0.0, left[2]])
        return left, [0.0, 1.0, 0.0], cross(left, [0.0, 1.0, 0.0])

    def along(self, axes, world):
        """A world vector as it counts along axes."""
        return [dot(axis, world) for axis in axes]

    def fingers(self, hand):
        """Chains of joints below a hand, without branches and without things that it holds, thumbs left out."""
        nodes, skinned = self.gltf["nodes"], {joint for skin in self.gltf.get("skins", []) for joint in skin["joints"]}

        def holds(node):
            return "mesh" in nodes[node] or any(holds(child) for child in nodes[node].get("children", []))

        def chains(node):
            children = [child for child in nodes[node].get("children", []) if child in skinned]
            if not children:
                return [[node]]
            return [[node] + rest if len(children) == 1 else rest for child in children for rest in chains(child)]

        found = [chain for child in nodes[hand].get("children", []) if child in skinned and not holds(child) for chain in chains(child)]
        return [chain for chain in found if len(chain) > 1 and "thumb" not in nodes[chain[0]].get("name", "").lower()]


def bipeds(program, folder):
    for file in sorted([*folder.glob("biped/**/*.gl*"), *folder.glob("vrm/*.vrm")]):
        if json.loads(run(program, "info", file, "--json"))["limbs"]:
            yield pathlib.Path(file)
