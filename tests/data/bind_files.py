"""glTF files as the checks of binding need them: without their weights, cut into pieces, of any number of vertices."""

import json
import pathlib
import struct


class Glb:
    """A .glb whose JSON and bytes are changed and written again."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        size = struct.unpack_from("<I", data, 20 + length)[0] if len(data) > 20 + length else 0
        self.bytes = bytearray(data[28 + length:28 + length + size])

    def write(self, path):
        self.json["buffers"][0]["byteLength"] = len(self.bytes)
        text = json.dumps(self.json).encode()
        text += b" " * (-len(text) % 4)
        blob = bytes(self.bytes) + b"\0" * (-len(self.bytes) % 4)
        total = 12 + 8 + len(text) + 8 + len(blob)
        pathlib.Path(path).write_bytes(struct.pack("<III", 0x46546C67, 2, total) + struct.pack("<I4s", len(text), b"JSON") + text
                                       + struct.pack("<I4s", len(blob), b"BIN\0") + blob)
        return path

    def values(self, accessor):
        """Rows of an accessor that is neither sparse nor compressed."""
        entry = self.json["accessors"][accessor]
        view = self.json["bufferViews"][entry["bufferView"]]
        letter, size = {5120: ("b", 1), 5121: ("B", 1), 5122: ("h", 2), 5123: ("H", 2), 5125: ("I", 4), 5126: ("f", 4)}[entry["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[entry["type"]]
        start = view.get("byteOffset", 0) + entry.get("byteOffset", 0)
        stride = view.get("byteStride", size * width)
        return [struct.unpack_from(f"<{width}{letter}", self.bytes, start + i * stride) for i in range(entry["count"])]

    def add(self, rows, letter, component, kind, bounds=False):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        start = len(self.bytes)
        for row in rows:
            self.bytes += struct.pack(f"<{len(row)}{letter}", *row)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": start, "byteLength": len(self.bytes) - start})
        entry = {"bufferView": len(self.json["bufferViews"]) - 1, "componentType": component, "count": len(rows), "type": kind}
        if bounds:
            entry["min"], entry["max"] = [min(c) for c in zip(*rows)], [max(c) for c in zip(*rows)]
        self.json["accessors"].append(entry)
        return len(self.json["accessors"]) - 1

    def skinned_primitives(self):
        meshes = {node["mesh"] for node in self.json["nodes"] if "skin" in node}
        return [primitive for mesh in sorted(meshes) for primitive in self.json["meshes"][mesh]["primitives"]]

    def triangles(self, primitive):
        corners = [row[0] for row in self.values(primitive["indices"])] if "indices" in primitive else list(range(len(self.values(primitive["attributes"]["POSITION"]))))
        return [tuple(corners[i:i + 3]) for i in range(0, len(corners) - 2, 3)]

    def set_shape(self, primitive, attributes, triangles):
        """Rows by attribute, in the place of the primitive's own; what is not given goes."""
        kinds = {"POSITION": ("f", 5126, "VEC3"), "NORMAL": ("f", 5126, "VEC3"), "JOINTS_0": ("H", 5123, "VEC4"), "WEIGHTS_0": ("f", 5126, "VEC4")}
        primitive["attributes"] = {name: self.add(rows, *kinds[name], bounds=name == "POSITION") for name, rows in attributes.items()}
        primitive["indices"] = self.add([(i,) for triangle in triangles for i in triangle], "I", 5125, "SCALAR")
        primitive.pop("material", None)


def character_file(data, name):
    """Of the test data, else the bundled one."""
    return next(iter(data.glob(f"biped/{name}.glb")), pathlib.Path(__file__).parents[2] / "assets" / f"{name}.glb")


def without_weights(source, target):
    """The skin stays: it says where the joints are."""
    file = Glb(source)
    for mesh in file.json["meshes"]:
        for primitive in mesh["primitives"]:
            for name in [name for name in primitive["attributes"] if name.startswith(("JOINTS_", "WEIGHTS_"))]:
                del primitive["attributes"][name]
    return file.write(target)


def cut(source, target, height):
    """Holes of a thirtieth of the height all over, and what is left parted into slices along the height, each a shell of its own."""
    file = Glb(source)
    for primitive in file.skinned_primitives():
        names = ("POSITION", "JOINTS_0", "WEIGHTS_0")
        rows = {name: file.values(primitive["attributes"][name]) for name in names}
        points = rows["POSITION"]
        wanted, made, triangles = {}, {name: [] for name in names}, []
        low = min(point[1] for point in points)
        tall = max(point[1] for point in points) - low
        holes = points[::max(1, len(points) // 25)]
        for triangle in file.triangles(primitive):
            middle = [sum(points[i][axis] for i in triangle) / 3 for axis in range(3)]
            if any(sum((a - b) ** 2 for a, b in zip(middle, hole)) < (height / 60) ** 2 for hole in holes):
                continue
            piece = int(4 * (middle[1] - low) / tall)
            corners = []
            for i in triangle:
                if (piece, i) not in wanted:
                    wanted[piece, i] = len(made["POSITION"])
                    for name in names:
                        made[name].append(rows[name][i])
                    point = list(points[i])
                    point[1] += 1e-3 * height * piece  # apart
                    made["POSITION"][-1] = tuple(point)
                corners.append(wanted[piece, i])
            triangles.append(corners)
        file.set_shape(primitive, made, triangles)
    return file.write(target)


def refined(source, target, vertices):
    """Triangles cut in four, all over, then in three as far as needed: at least so many vertices, without weights."""
    file = Glb(source)
    primitives = file.skinned_primitives()
    shapes = [[file.values(p["attributes"]["POSITION"]), file.triangles(p)] for p in primitives]
    while 2.5 * sum(len(points) for points, _ in shapes) < vertices:
        shapes = [in_four(points, triangles) for points, triangles in shapes]
    missing = vertices - sum(len(points) for points, _ in shapes)
    for shape in shapes:
        points, triangles = shape
        count = max(0, min(missing, len(triangles)))
        for k in range(count):
            a, b, c = triangles[k]
            points.append(tuple(sum(points[i][axis] for i in (a, b, c)) / 3 for axis in range(3)))
            d = len(points) - 1
            triangles[k] = (a, b, d)
            triangles += [(b, c, d), (c, a, d)]
        missing -= count
    for primitive, (points, triangles) in zip(primitives, shapes):
        file.set_shape(primitive, {"POSITION": points}, triangles)
    return file.write(target), sum(len(points) for points, _ in shapes)


def in_four(points, triangles):
    points, middles, made = list(points), {}, []

    def middle(i, j):
        key = (min(i, j), max(i, j))
        if key not in middles:
            middles[key] = len(points)
            points.append(tuple((a + b) / 2 for a, b in zip(points[i], points[j])))
        return middles[key]

    for a, b, c in triangles:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        made += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return [points, made]
