"""A character of the data folder as a mesh alone, and where its artist put the joints."""

import base64
import json
import struct

from check_corpus import read_gltf

IDENTITY = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]


def product(a, b):
    """Of two matrices of 16 numbers, column by column."""
    return [sum(a[4 * k + row] * b[4 * column + k] for k in range(4)) for column in range(4) for row in range(4)]


def inverse_affine(m):
    a = [[m[4 * column + row] for column in range(3)] for row in range(3)]
    cofactor = [[a[(i + 1) % 3][(j + 1) % 3] * a[(i + 2) % 3][(j + 2) % 3] - a[(i + 1) % 3][(j + 2) % 3] * a[(i + 2) % 3][(j + 1) % 3]
                 for j in range(3)] for i in range(3)]
    determinant = sum(a[0][j] * cofactor[0][j] for j in range(3))
    back = [[cofactor[j][i] / determinant for j in range(3)] for i in range(3)]
    place = [-sum(back[row][k] * m[12 + k] for k in range(3)) for row in range(3)]
    return [x for column in range(3) for x in (back[0][column], back[1][column], back[2][column], 0.0)] + place + [1.0]


def local_matrix(node):
    if "matrix" in node:
        return [float(x) for x in node["matrix"]]
    x, y, z, w = node.get("rotation", [0.0, 0.0, 0.0, 1.0])
    s = node.get("scale", [1.0, 1.0, 1.0])
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [v for c in range(3) for v in (rows[0][c] * s[c], rows[1][c] * s[c], rows[2][c] * s[c], 0.0)] + list(node.get("translation", [0, 0, 0])) + [1.0]


def rest_worlds(nodes):
    parents = {child: index for index, node in enumerate(nodes) for child in node.get("children", [])}
    worlds = {}

    def world(index):
        if index not in worlds:
            above = world(parents[index]) if index in parents else IDENTITY
            worlds[index] = product(above, local_matrix(nodes[index]))
        return worlds[index]

    return [world(index) for index in range(len(nodes))], parents


def inverse_binds(document, buffers, skin):
    accessor = document["accessors"][skin["inverseBindMatrices"]]
    view = document["bufferViews"][accessor["bufferView"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    stride = view.get("byteStride", 64)
    return [list(struct.unpack_from("<16f", buffers[view["buffer"]], start + stride * i)) for i in range(accessor["count"])]


def placed_skins(document, buffers, worlds, parents):
    """For each skin the matrix from its bind space to the world; and the place of every joint in the bind pose."""
    placements, places = [], {}
    for skin in document.get("skins", []):
        joints, binds = skin["joints"], inverse_binds(document, buffers, skin)
        top = next(i for i, joint in enumerate(joints) if parents.get(joint) not in joints)
        placement = product(worlds[joints[top]], binds[top])
        placements.append(placement)
        for joint, bind in zip(joints, binds):
            places.setdefault(joint, product(placement, inverse_affine(bind))[12:15])
    return placements, places


def unskinned(file, output):
    """Writes the meshes of a file where its bind pose has them, without a skeleton; answers the places of its joints by node. Of a file with
    skins only what they move; of one without, its meshes where its nodes stand at rest."""
    document, buffers = read_gltf(file)
    worlds, parents = rest_worlds(document["nodes"])
    placements, places = placed_skins(document, buffers, worlds, parents)
    nodes = []
    for index, node in enumerate(document["nodes"]):
        if "mesh" in node and (not placements or "skin" in node):
            nodes.append({"mesh": node["mesh"], "matrix": placements[node["skin"]] if placements else worlds[index]})
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            for name in ("JOINTS_0", "WEIGHTS_0", "JOINTS_1", "WEIGHTS_1"):
                primitive["attributes"].pop(name, None)
            primitive.pop("material", None)
    for index, content in enumerate(buffers):
        document["buffers"][index]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(content).decode()
    kept = {key: document[key] for key in ("asset", "buffers", "bufferViews", "accessors", "meshes")}
    output.write_text(json.dumps({**kept, "nodes": nodes, "scenes": [{"nodes": list(range(len(nodes)))}], "scene": 0}))
    return places or {index: world[12:15] for index, world in enumerate(worlds)}
