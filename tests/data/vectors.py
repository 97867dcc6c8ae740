"""Vectors of three numbers, and rotations by rotation vectors (axis times angle, radians)."""

import math


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def scaled(a, factor):
    return [x * factor for x in a]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.hypot(*a)
    return scaled(a, 1.0 / length) if length > 0.0 else [0.0, 0.0, 0.0]


def across(a, unit_line):
    """The part of a vector at right angles to a line."""
    return sub(a, scaled(unit_line, dot(a, unit_line)))


def angle(a, b):
    return math.atan2(math.hypot(*cross(a, b)), dot(a, b))


def rotated(rotation_vector, a):
    """Rodrigues' formula."""
    turn = math.hypot(*rotation_vector)
    if turn == 0.0:
        return a
    axis = scaled(rotation_vector, 1.0 / turn)
    along = scaled(axis, dot(axis, a) * (1.0 - math.cos(turn)))
    return add(add(scaled(a, math.cos(turn)), scaled(cross(axis, a), math.sin(turn))), along)


def columns(matrix):
    """The directions of the axes of a world matrix of 16 numbers, column by column."""
    return [unit(matrix[start:start + 3]) for start in (0, 4, 8)]


def place(matrix):
    return matrix[12:15]


def turn_between(before, after):
    """The angle by which the axes of one world matrix are turned against another's."""
    trace = sum(dot(a, b) for a, b in zip(columns(before), columns(after)))
    return math.acos(max(-1.0, min(1.0, 0.5 * (trace - 1.0))))


def turn_miss(before, rotation_vector, after):
    """By how much the axes of `after` are off those of `before` turned by a rotation vector; radians, about."""
    return max(math.dist(rotated(rotation_vector, a), b) for a, b in zip(columns(before), columns(after)))


def seen_from(matrix, point):
    """A point along the axes of a world matrix, from its place."""
    return [dot(axis, sub(point, place(matrix))) for axis in columns(matrix)]


def skew(matrix):
    """How far the axes of a world matrix are from being at right angles: the largest cosine between two."""
    x, y, z = columns(matrix)
    return max(abs(dot(x, y)), abs(dot(y, z)), abs(dot(z, x)))
