"""Damages files of other programs: bytes anywhere, or values alone, which leaves a file whole enough to be looked at further."""
import json
import re
import struct

SIZES = {b"C": 1, b"B": 1, b"Y": 2, b"I": 4, b"F": 4, b"L": 8, b"D": 8}
ITEMS = {b"f": 4, b"d": 8, b"i": 4, b"l": 8, b"b": 1}
NUMBERS = {b"C": "<b", b"B": "<b", b"Y": "<h", b"I": "<i", b"F": "<f", b"L": "<q", b"D": "<d", b"f": "<f", b"d": "<d", b"i": "<i", b"l": "<q", b"b": "<b"}
ODD = (0, 1, -1, 2, 3, 7, 100, 65535, 2**31 - 1, -2**31, 2**63 - 1, -2**63)
ODD_REAL = (0.0, -1.0, 1e-30, 1e9, 1e30, -1e30, float("inf"), float("nan"))
ODD_TEXT = (b"0", b"-1", b"1", b"2", b"1e30", b"-1e30", b"nan", b"1e-30", b"99999999999", b"2147483647", b"", b"x")


def anywhere(content, rng):
    content = bytearray(content)
    for _ in range(rng.choice((1, 1, 1, 2, 4, 16))):
        place = rng.randrange(min(len(content), rng.choice((400, 4000, len(content), len(content), len(content)))))
        size = rng.choice((1, 1, 2, 4, 8, 64))
        match rng.randrange(6):
            case 0: content[place] ^= 1 << rng.randrange(8)
            case 1: content[place:place + size] = bytes(rng.randrange(256) for _ in range(size))
            case 2: del content[place:place + size]
            case 3: content[place:place] = content[(start := rng.randrange(len(content))):start + size]
            case 4: content[place:place + 4] = rng.choice((b"\xff\xff\xff\xff", b"\0\0\0\x80", b"\xff\xff\xff\x7f", b"9999", b"-1  "))
            case 5: content = content[:max(place, 64)]
        if len(content) < 64:
            break
    return bytes(content)


def fbx_values(content):
    """Kind and place of each number of a binary FBX, and place and size of each string; packed arrays are left out."""
    wide = struct.unpack_from("<I", content, 23)[0] >= 7500
    head, form = (25, "<QQQB") if wide else (13, "<IIIB")
    numbers, texts, nodes = [], [], [(27, len(content))]
    while nodes:
        at, end = nodes.pop()
        while at + head <= end:
            stop, count, length, name = struct.unpack_from(form, content, at)
            if stop == 0:
                break
            at += head + name
            nodes.append((at + length, stop))
            for _ in range(count):
                kind, at = content[at:at + 1], at + 1
                if kind in SIZES:
                    numbers.append((kind, at))
                    at += SIZES[kind]
                elif kind in ITEMS:
                    items, packed, size = struct.unpack_from("<III", content, at)
                    at += 12
                    if not packed:
                        numbers += [(kind, at + ITEMS[kind] * item) for item in range(min(items, 40))]
                    at += size
                else:
                    size = struct.unpack_from("<I", content, at)[0]
                    texts.append((at + 4, size))
                    at += 4 + size
            at = stop
    return numbers, texts


def binary_values(content, rng):
    numbers, texts = fbx_values(content)
    content = bytearray(content)
    for _ in range(rng.choice((1, 1, 2, 4, 16))):
        kind, place = rng.choice(numbers)
        size = struct.calcsize(NUMBERS[kind])
        others = [at for other, at in numbers if other == kind]
        if rng.randrange(4) == 0:  # a word in the place of another of its length, as far as there is one
            at, length = rng.choice(texts)
            same = [where for where, other in texts if other == length]
            where = rng.choice(same)
            content[at:at + length] = content[where:where + length]
        elif rng.randrange(2):  # a number in the place of another, such as the parent of a node
            where = rng.choice(others)
            content[place:place + size] = content[where:where + size]
        elif NUMBERS[kind][1] in "fd":
            value = rng.choice(ODD_REAL)
            content[place:place + size] = struct.pack(NUMBERS[kind], value if size == 8 or abs(value) < 1e38 or value != value else 3e38)
        else:
            bits = 8 * size
            content[place:place + size] = struct.pack(NUMBERS[kind], (rng.choice(ODD) + (1 << (bits - 1))) % (1 << bits) - (1 << (bits - 1)))
    return bytes(content)


def text_values(content, rng):
    words = [(found.start(), found.end()) for found in re.finditer(rb"[-+.\w]+", content)]
    if len(content) > 300000:  # the head of a file of motion tells more than one of its numbers
        words = words[:rng.choice((60, 400, len(words)))]
    chosen = sorted((rng.randrange(len(words)) for _ in range(rng.choice((1, 1, 2, 4, 16)))), reverse=True)
    changed = bytearray(content)
    for one in dict.fromkeys(chosen):
        start, end = words[one]
        is_number = re.fullmatch(rb"[-+]?[\d.][-+.\deE]*", content[start:end])
        other = words[rng.randrange(len(words))]
        changed[start:end] = rng.choice(ODD_TEXT) if is_number and rng.randrange(3) else content[other[0]:other[1]]
    return bytes(changed)


def values(content, rng):
    """The file with some of its numbers and words replaced."""
    if content.startswith(b"Kaydara FBX Binary") and content[21:23] == b"\x1a\0":
        return binary_values(content, rng)
    if content.startswith(b"glTF"):
        length = struct.unpack_from("<I", content, 12)[0]
        text = text_values(content[20:20 + length], rng)
        text += b" " * (-len(text) % 4)
        return struct.pack("<4sII", b"glTF", 2, len(content) - length + len(text)) + struct.pack("<I", len(text)) + content[16:20] + text + content[20 + length:]
    return text_values(content, rng)


def parts_of_glb(content):
    """Its text as JSON, and its data."""
    length = struct.unpack_from("<I", content, 12)[0]
    return json.loads(content[20:20 + length]), bytearray(content[28 + length:])


def glb_of(document, data):
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def numbers_of_data(content, rng):
    """A .glb with some values of one accessor replaced by odd ones or by others of its own."""
    document, data = parts_of_glb(content)
    accessor = rng.choice([one for one in document["accessors"] if "bufferView" in one])
    view = document["bufferViews"][accessor["bufferView"]]
    start, end = view.get("byteOffset", 0) + accessor.get("byteOffset", 0), view.get("byteOffset", 0) + view["byteLength"]
    size = {5120: 1, 5121: 1, 5122: 2, 5123: 2}.get(accessor["componentType"], 4)
    for _ in range(rng.choice((1, 1, 4, 16))):
        place, other = (start + size * rng.randrange(max(1, (end - start) // size)) for _ in range(2))
        value = rng.choice(ODD_REAL[:6] if rng.randrange(8) else ODD_REAL)
        if accessor["componentType"] == 5126 and rng.randrange(2):
            data[place:place + 4] = struct.pack("<f", value)
        else:
            data[place:place + size] = data[other:other + size]
    return glb_of(document, data)


def leaves_of(thing, name=""):
    """Each number of a JSON document: what holds it, where there, and under which name."""
    for key, value in thing.items() if isinstance(thing, dict) else enumerate(thing):
        called = key if isinstance(key, str) else name
        if isinstance(value, (dict, list)):
            yield from leaves_of(value, called)
        elif isinstance(value, (int, float)):
            yield thing, key, called


def numbers_of_text(content, rng):
    """A .glb with some numbers of its text replaced by another under the same name, or by an odd one."""
    document, data = parts_of_glb(content)
    leaves = list(leaves_of(document))
    names = sorted({name for _, _, name in leaves})
    for _ in range(rng.choice((1, 1, 2, 4))):
        chosen = rng.choice(names)  # names, not numbers, are drawn alike: most numbers are lengths and offsets
        same = [(thing, key) for thing, key, name in leaves if name == chosen]
        (thing, key), (other, where) = rng.choice(same), rng.choice(same)
        odd = rng.choice(ODD) if isinstance(thing[key], int) else rng.choice(ODD_REAL[:6])
        thing[key] = other[where] if rng.randrange(3) else odd
    return glb_of(document, data)


def damaged(content, rng):
    return anywhere(content, rng) if rng.randrange(3) == 0 else values(content, rng)
