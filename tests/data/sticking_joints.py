"""Joints that stick out of a body: how far, in the body's thickness, in the bind pose of a skinned glTF."""

import math

from check_corpus import read_gltf
from check_turns import accessor_rows

INSIDE = 0.5  # winding number


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def mesh_of(document, buffers):
    places, triangles = [], []
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            accessor = document["accessors"][primitive["indices"]]
            view = document["bufferViews"][accessor["bufferView"]]
            start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            size = {5121: 1, 5123: 2, 5125: 4}[accessor["componentType"]]
            raw = buffers[view["buffer"]][start:start + size * accessor["count"]]
            indices = [len(places) + int.from_bytes(raw[i:i + size], "little") for i in range(0, len(raw), size)]
            triangles += [indices[i:i + 3] for i in range(0, len(indices), 3)]
            places += accessor_rows(document, buffers, primitive["attributes"]["POSITION"])
    return places, triangles


def bind_place(matrix):
    """Where the joint of an inverse bind matrix (16 numbers, column by column) stands: minus the inverse of its turn, times its way."""
    columns, way = [matrix[0:3], matrix[4:7], matrix[8:11]], matrix[12:15]
    size = dot(columns[0], cross(columns[1], columns[2]))
    return [-dot(cross(columns[(i + 1) % 3], columns[(i + 2) % 3]), way) / size for i in range(3)]


def thickness(places, triangles):
    """The diameter of a rod of the same volume and surface."""
    volume = area = 0.0
    for triangle in triangles:
        a, b, c = (places[i] for i in triangle)
        normal = cross(minus(b, a), minus(c, a))
        volume, area = volume + dot(a, normal) / 6, area + math.hypot(*normal) / 2
    return 4 * abs(volume) / area


def winding(places, triangles, point):
    total = 0.0
    for triangle in triangles:
        a, b, c = (minus(places[i], point) for i in triangle)
        la, lb, lc = math.hypot(*a), math.hypot(*b), math.hypot(*c)
        total += math.atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb)
    return abs(total) / (2 * math.pi)


def from_triangle(point, a, b, c):
    normal = cross(minus(b, a), minus(c, a))
    size = dot(normal, normal)
    corners = ((a, b), (b, c), (c, a))
    if size > 0 and all(dot(cross(minus(to, at), minus(point, at)), normal) >= 0 for at, to in corners):
        return abs(dot(minus(point, a), normal)) / math.sqrt(size)
    nearest = math.inf
    for at, to in corners:
        way = minus(to, at)
        share = max(0.0, min(1.0, dot(minus(point, at), way) / (dot(way, way) or 1.0)))
        nearest = min(nearest, math.dist(point, [x + share * y for x, y in zip(at, way)]))
    return nearest


def farthest_out(file):
    """How far the joint that sticks out farthest is from the surface, in the body's thickness; 0 where all lie inside."""
    document, buffers = read_gltf(file)
    places, triangles = mesh_of(document, buffers)
    skin = document["skins"][0]
    joints = [bind_place(row) for row in accessor_rows(document, buffers, skin["inverseBindMatrices"])]
    outside = [joint for joint in joints if winding(places, triangles, joint) < INSIDE]
    return max((min(from_triangle(joint, *(places[i] for i in t)) for t in triangles) for joint in outside), default=0.0) / thickness(places, triangles)
