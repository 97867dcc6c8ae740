"""A binary FBX read without a library: where its nodes are at a time. For nodes of translation, pre-rotation, rotation in the order x, y, z
and scale, and curves that are straight between their keys. It shares nothing with the program, nor with three.js, which pairs the keys of
x, y and z by their numbers where the three curves have keys at different times."""
import bisect
import math
import struct
import zlib

TICKS = 46186158000


def _node(data, at, wide):
    end, count, _ = struct.unpack_from("<QQQ" if wide else "<III", data, at)
    at += 24 if wide else 12
    length = data[at]
    name = data[at + 1:at + 1 + length].decode("latin1")
    at += 1 + length
    if end == 0:
        return None, at
    values = []
    for _ in range(count):
        kind = chr(data[at])
        at += 1
        if kind in "YCIFDL":
            form = "<" + {"Y": "h", "C": "b", "I": "i", "F": "f", "D": "d", "L": "q"}[kind]
            values.append(struct.unpack_from(form, data, at)[0])
            at += struct.calcsize(form)
        elif kind in "SR":
            size = struct.unpack_from("<I", data, at)[0]
            values.append(data[at + 4:at + 4 + size])
            at += 4 + size
        else:
            size, packed, stored = struct.unpack_from("<III", data, at)
            part = data[at + 12:at + 12 + stored]
            values.append(struct.unpack(f"<{size}{kind.replace(chr(108), chr(113))}", zlib.decompress(part) if packed else part))
            at += 12 + stored
    children = []
    while at < end:
        child, at = _node(data, at, wide)
        if child is None:
            break
        children.append(child)
    return (name, values, children), end


def _top(data):
    wide = struct.unpack_from("<I", data, 23)[0] >= 7500
    at, nodes = 27, {}
    while at < len(data):
        node, at = _node(data, at, wide)
        if node is None:
            break
        nodes[node[0]] = node[2]
    return nodes


def _value(curve, time):
    times, values = curve
    after = bisect.bisect_right(times, time)
    if after in (0, len(times)):
        return values[0 if after == 0 else -1]
    share = (time - times[after - 1]) / (times[after] - times[after - 1])
    return values[after - 1] + share * (values[after] - values[after - 1])


def _product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def _turn(degrees):
    matrix = [[float(i == j) for j in range(4)] for i in range(4)]
    for axis in range(3):
        c, s = math.cos(math.radians(degrees[axis])), math.sin(math.radians(degrees[axis]))
        i, j = (axis + 1) % 3, (axis + 2) % 3
        one = [[float(a == b) for b in range(4)] for a in range(4)]
        one[i][i], one[i][j], one[j][i], one[j][j] = c, -s, s, c
        matrix = _product(one, matrix)
    return matrix


class Fbx:
    """`names`, and `places(seconds)`: a world position for each of them, in the file's units."""

    def __init__(self, path):
        top = _top(path.read_bytes())
        objects = {node[1][0]: node for node in top["Objects"]}
        links = [link[1] for link in top["Connections"]]
        self.models = {key: node for key, node in objects.items() if node[0] == "Model"}
        self.names = {key: node[1][1].split(b"\0")[0].decode() for key, node in self.models.items()}
        self.parents = {link[1]: link[2] for link in links if link[0] == b"OO" and link[1] in self.models and link[2] in self.models}
        self.fixed = {key: self._properties(node) for key, node in self.models.items()}
        self.curves = {}
        of_node = {link[1]: (link[2], link[3].decode()) for link in links if link[0] == b"OP" and link[2] in self.models and link[1] in objects}
        for link in links:
            if link[0] == b"OP" and link[2] in of_node and objects.get(link[1], ("",))[0] == "AnimationCurve":
                parts = {child[0]: child[1] for child in objects[link[1]][2]}
                times = [tick / TICKS for tick in parts["KeyTime"][0]]
                self.curves[(*of_node[link[2]], link[3][-1:].decode())] = (times, parts["KeyValueFloat"][0])

    @staticmethod
    def _properties(model):
        found = {"Lcl Translation": (0, 0, 0), "PreRotation": (0, 0, 0), "Lcl Rotation": (0, 0, 0), "Lcl Scaling": (1, 1, 1)}
        for child in model[2]:
            for entry in child[2] if child[0] == "Properties70" else []:
                name = entry[1][0].decode()
                if name in found:
                    found[name] = tuple(entry[1][4:7])
        return found

    def _at(self, model, name, seconds):
        return [_value(self.curves[(model, name, axis)], seconds) if (model, name, axis) in self.curves else self.fixed[model][name][i]
                for i, axis in enumerate("XYZ")]

    def places(self, seconds):
        worlds = {}

        def world(model):
            if model not in worlds:
                local = _product(_turn(self.fixed[model]["PreRotation"]), _turn(self._at(model, "Lcl Rotation", seconds)))
                scale, place = self._at(model, "Lcl Scaling", seconds), self._at(model, "Lcl Translation", seconds)
                local = [[local[i][j] * scale[j] for j in range(3)] + [place[i]] for i in range(3)] + [[0, 0, 0, 1]]
                worlds[model] = _product(world(self.parents[model]), local) if model in self.parents else local
            return worlds[model]

        return {self.names[model]: [world(model)[i][3] for i in range(3)] for model in self.models}
