"""Mesh sequences that the checks make themselves, each with what a viewer has to find again in the compressed clip.

Every maker writes its files into a folder and answers an Own: what to name on the command line, the positions of every frame
and what the mesh looks like, corner by corner.
"""

import dataclasses
import json
import math
import pathlib
import struct
import zlib

FRAMES = 24
FPS = 30.0


@dataclasses.dataclass
class Own:
    words: list  # what names the sequence on a command line
    frames: list  # positions [(x, y, z)] of every vertex, frame by frame
    corners: list  # (vertex, (u, v) with v downwards or None, normal or None, material), three for each triangle
    colours: dict  # base colour factor by material
    images: dict  # bytes of the base colour image by material
    arguments: list  # of compress


def png(width, height, colour_at):
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in colour_at(x, y)) for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


CHECKERS = png(64, 32, lambda x, y: (220, 40 + 3 * x, 40) if (x // 8 + y // 8) % 2 else (30, 60, 90 + 5 * y))


def write_obj(folder, name, own, texture_corners, normals):
    """Numbered OBJ frames with one MTL. `texture_corners`: (u, v upwards) of each corner; `normals`: of each corner, frame by frame."""
    folder.mkdir()
    lines = []
    for material, colour in own.colours.items():
        lines += [f"newmtl {material}", "Kd " + " ".join(f"{c:g}" for c in colour[:3])]
        if material in own.images:
            (folder / f"{material}.png").write_bytes(own.images[material])
            lines.append(f"map_Kd {material}.png")
    (folder / "look.mtl").write_text("\n".join(lines) + "\n")
    for k, frame in enumerate(own.frames):
        lines = ["mtllib look.mtl"] + [f"v {x:.7g} {y:.7g} {z:.7g}" for x, y, z in frame]
        lines += [f"vt {u:.7g} {v:.7g}" for u, v in texture_corners]
        lines += [f"vn {x:.7g} {y:.7g} {z:.7g}" for x, y, z in (normals[k] if normals else [])]
        used = None
        for first in range(0, len(own.corners), 3):
            material = own.corners[first][3]
            if material != used:
                lines.append(f"usemtl {material}")
                used = material
            words = []
            for corner in range(first, first + 3):
                vt = corner + 1 if texture_corners else ""
                words.append(f"{own.corners[corner][0] + 1}/{vt}/{corner + 1}" if normals else f"{own.corners[corner][0] + 1}/{vt}")
            lines.append("f " + " ".join(words))
        (folder / f"{name}_{k}.obj").write_text("\n".join(lines) + "\n")


def box_surface(cells):
    """The outside of unit cubes at integer places: vertices, and quads of (four vertices, outward axis)."""
    places, quads = {}, []
    for cell in sorted(cells):
        for axis in range(3):
            for sign in (-1, 1):
                beside = tuple(c + (sign if i == axis else 0) for i, c in enumerate(cell))
                if beside in cells:
                    continue
                u, v = (axis + 1) % 3, (axis + 2) % 3
                ring = [(0, 0), (1, 0), (1, 1), (0, 1)] if sign > 0 else [(0, 0), (0, 1), (1, 1), (1, 0)]
                quad = []
                for du, dv in ring:
                    place = list(cell)
                    place[axis] += 1 if sign > 0 else 0
                    place[u] += du
                    place[v] += dv
                    quad.append(places.setdefault(tuple(place), len(places)))
                quads.append((quad, tuple(float(sign) if i == axis else 0.0 for i in range(3))))
    return list(places), quads


def triangles_of(quads):
    return [(corners, normal) for quad, normal in quads for corners in ((quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3]))]


def smooth(t):
    t = min(1.0, max(0.0, t))
    return t * t * (3.0 - 2.0 * t)


def tube_with_arms(folder):
    """A trunk that sways and two arms that wave: it branches, and is one surface."""
    cells = {(x, y, z) for x in range(-1, 2) for y in range(-8, 9) for z in range(-1, 2)}
    cells |= {(x, y, 0) for y in (5, 6) for x in range(-9, 10)}
    places, quads = box_surface(cells)

    def moved(place, time):
        x, y, z = (float(c) for c in place)
        arm = smooth((abs(x - 0.5) - 2.0) / 2.0) * 0.8 * math.sin(2.0 * math.pi * time + (0.0 if x < 0 else 1.3))
        arm *= 0.0 if time == 0.0 else 1.0
        away, up = abs(x - 0.5) - 2.0, y - 6.0
        if away > 0.0:
            side = 1.0 if x > 0.5 else -1.0
            x, y = 0.5 + side * (2.0 + away * math.cos(arm) - up * math.sin(arm)), 6.0 + away * math.sin(arm) + up * math.cos(arm)
        sway = 0.5 * math.sin(2.0 * math.pi * time) * smooth((y + 8.0) / 17.0)
        return (x * math.cos(sway) + y * math.sin(sway), y * math.cos(sway) - x * math.sin(sway), z)

    frames = [[moved(place, k / (FRAMES - 1)) for place in places] for k in range(FRAMES)]
    corners = [(v, None, None, "skin") for corners, _ in triangles_of(quads) for v in corners]
    own = Own([folder / "arms"], frames, corners, {"skin": (0.8, 0.5, 0.3, 1.0)}, {}, ["--stretch", "measured", "--bones", 12])
    write_obj(folder / "arms", "arms", own, [], None)
    return own


def flag(folder):
    """A waving sheet with a texture and a seam down its middle: one place, two texture coordinates."""
    columns, rows = 25, 13
    corners, textures = [], []
    for j in range(rows - 1):
        for i in range(columns - 1):
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)):
                across = (i + a) / (columns - 1)
                u = 0.5 * across if i < columns // 2 else 1.0 - 0.5 * across
                v = (j + b) / (rows - 1)
                textures.append((u, v))
                corners.append(((j + b) * columns + i + a, (u, 1.0 - v), None, "cloth"))

    def frame(time):
        wave = lambda i: 0.6 * (i / columns) * (math.sin(0.5 * i - 6.2832 * time) - (math.sin(0.5 * i) if time == 0.0 else 0.0))
        return [(0.2 * i, 0.2 * j, wave(i) * (1.0 + 0.03 * j)) for j in range(rows) for i in range(columns)]

    own = Own([folder / "flag"], [frame(k / (FRAMES - 1)) for k in range(FRAMES)], corners, {"cloth": (1.0, 1.0, 1.0, 1.0)},
              {"cloth": CHECKERS}, ["--stretch", "measured", "--bones", 10])
    write_obj(folder / "flag", "flag", own, textures, None)
    return own


def hard_box(folder):
    """A long box that bends, with a normal for each side and two colours: nothing of it is smooth."""
    cells = {(x, y, z) for x in range(24) for y in range(4) for z in range(4)}
    places, quads = box_surface(cells)
    triangles = triangles_of(quads)

    def bent(place, normal, turn):
        x, y, z = (float(c) for c in place)
        if abs(turn) < 1e-9:
            return (x, y, z), normal
        radius, angle = 24.0 / turn, turn * x / 24.0
        c, s = math.cos(angle), math.sin(angle)
        return ((radius - y) * s, radius - (radius - y) * c, z), (normal[0] * c - normal[1] * s, normal[0] * s + normal[1] * c, normal[2])

    turns = [1.2 * k / (FRAMES - 1) for k in range(FRAMES)]
    frames = [[bent(place, (0.0, 0.0, 0.0), turn)[0] for place in places] for turn in turns]
    normals = [[bent(places[v], normal, turn)[1] for corners, normal in triangles for v in corners] for turn in turns]
    material = lambda normal: "ends" if normal[0] else "sides"
    corners = [(v, None, normal, material(normal)) for ring, normal in triangles for v in ring]
    own = Own([folder / "box"], frames, corners, {"sides": (0.2, 0.5, 0.7, 1.0), "ends": (0.9, 0.8, 0.1, 1.0)}, {},
              ["--stretch", "elastic", "--bones", 8])
    write_obj(folder / "box", "box", own, [], normals)
    return own


def morphing_sheet(folder):
    """A glTF whose clip moves morph targets of a textured sheet."""
    columns, rows = 17, 9
    place = [(0.25 * i, 0.25 * j, 0.0) for j in range(rows) for i in range(columns)]
    texture = [(i / (columns - 1), j / (rows - 1)) for j in range(rows) for i in range(columns)]
    targets = [[(0.0, 0.0, math.sin(0.7 * i)) for _ in range(rows) for i in range(columns)],
               [(-0.02 * i * j, 0.0, 0.05 * i * j) for j in range(rows) for i in range(columns)]]
    ring = [(j * columns + i, j * columns + i + 1, (j + 1) * columns + i + 1, (j + 1) * columns + i)
            for j in range(rows - 1) for i in range(columns - 1)]
    indices = [v for a, b, c, d in ring for v in (a, b, c, a, c, d)]
    weights = [(math.sin(6.0 * k / (FRAMES - 1)), k / (FRAMES - 1)) for k in range(FRAMES)]
    frames = [[tuple(p[a] + w[0] * targets[0][n][a] + w[1] * targets[1][n][a] for a in range(3)) for n, p in enumerate(place)] for w in weights]

    data, views, accessors = bytearray(), [], []

    def add(numbers, kind, width, form="f", bounds=False):
        while len(data) % 4:
            data.append(0)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": struct.calcsize(form) * len(numbers)})
        data.extend(struct.pack(f"<{len(numbers)}{form}", *numbers))
        accessor = {"bufferView": len(views) - 1, "componentType": 5126 if form == "f" else 5123, "count": len(numbers) // width, "type": kind}
        if bounds:
            stored = struct.unpack(f"<{len(numbers)}{form}", struct.pack(f"<{len(numbers)}{form}", *numbers))
            accessor |= {"min": [min(stored[a::width]) for a in range(width)], "max": [max(stored[a::width]) for a in range(width)]}
        accessors.append(accessor)
        return len(accessors) - 1

    flat = lambda points: [c for p in points for c in p]
    primitive = {"attributes": {"POSITION": add(flat(place), "VEC3", 3, bounds=True), "NORMAL": add([0.0, 0.0, 1.0] * len(place), "VEC3", 3),
                                "TEXCOORD_0": add(flat(texture), "VEC2", 2)},
                 "indices": add(indices, "SCALAR", 1, "H"), "material": 0,
                 "targets": [{"POSITION": add(flat(target), "VEC3", 3, bounds=True)} for target in targets]}
    times = add([k / FPS for k in range(FRAMES)], "SCALAR", 1, bounds=True)
    values = add(flat(weights), "SCALAR", 1)
    while len(data) % 4:
        data.append(0)
    views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(CHECKERS)})
    data.extend(CHECKERS)
    (folder / "sheet.bin").write_bytes(data)
    (folder / "sheet.gltf").write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "sheet", "mesh": 0}],
        "meshes": [{"name": "sheet", "primitives": [primitive], "weights": [0.0, 0.0]}],
        "materials": [{"name": "cloth", "doubleSided": True, "pbrMetallicRoughness": {"baseColorFactor": [1.0, 0.9, 0.8, 1.0], "baseColorTexture": {"index": 0},
                       "metallicFactor": 0.25, "roughnessFactor": 0.5}}],
        "textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": 33071, "wrapT": 33071}],
        "images": [{"bufferView": len(views) - 1, "mimeType": "image/png"}],
        "animations": [{"name": "Billow", "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
                        "samplers": [{"input": times, "output": values, "interpolation": "LINEAR"}]}],
        "buffers": [{"uri": "sheet.bin", "byteLength": len(data)}], "bufferViews": views, "accessors": accessors}))
    corners = [(v, texture[v], (0.0, 0.0, 1.0), "cloth") for v in indices]
    return Own([folder / "sheet.gltf"], frames, corners, {"cloth": (1.0, 0.9, 0.8, 1.0)}, {"cloth": CHECKERS}, ["--stretch", "measured", "--bones", 8])


MAKERS = {"a tube with two arms": tube_with_arms, "a flag with a seam": flag, "a box with hard edges": hard_box, "a morphing sheet": morphing_sheet}


def write_positions(frames, file):
    """Single precision, little endian, x y z of every vertex, frame after frame: what readers/sequence.mjs takes."""
    numbers = [c for frame in frames for p in frame for c in p]
    pathlib.Path(file).write_bytes(struct.pack(f"<{len(numbers)}f", *numbers))
