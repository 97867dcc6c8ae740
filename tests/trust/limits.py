#!/usr/bin/env python3
"""limits.py PROGRAM: small files that ask for much. Each is read, or refused in one line, within the memory and the time that docs/trust.md states:
at most 64 bytes for each byte of the file and what it names, and 800 MB, of files of other programs 500; of time
ten seconds of a processor, and on a slow machine eight times what it takes to pack 128 MB of zeros and to unpack them."""
import json
import math
import os
import pathlib
import resource
import struct
import subprocess
import sys
import tempfile
import time
import zlib

BYTES_FOR_ONE = 64
BYTES_FOR_ANY = 800 << 20
BYTES_FOR_FOREIGN = 500 << 20  # 400 of its reader, and the program itself
SECONDS = 10
TIMES_THE_YARDSTICK = 8
ROOT = pathlib.Path(__file__).resolve().parents[2]


def glb(gltf, binary=b""):
    gltf = {"asset": {"version": "2.0"}, **gltf}
    if binary:
        gltf.setdefault("buffers", [{"byteLength": len(binary)}])
    text = json.dumps(gltf, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    if binary:
        chunks += struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def view(length, **more):
    return {"buffer": 0, "byteLength": length, **more}


def triangles(count):
    return {"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 0, "COLOR_0": 0}}] * count}]}


def png(width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    packer = zlib.compressobj(9)
    row = b"\0" * (1 + (width + 7) // 8)
    rows = b"".join(packer.compress(row) for _ in range(height)) + packer.flush()
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 1, 0, 0, 0, 0)) + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


def textured(pictures, images):
    binary = b"".join(pictures)
    offsets = [sum(map(len, pictures[:i])) for i in range(len(pictures))]
    views = [view(len(one), byteOffset=at) for one, at in zip(pictures, offsets)]
    return glb({"bufferViews": views, "images": [{"bufferView": i % len(pictures), "mimeType": "image/png"} for i in range(images)],
                "textures": [{"source": i} for i in range(images)],
                "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in range(images)]}, binary)


def chain(depth):
    nodes = [{"children": [i + 1]} for i in range(depth)] + [{}]
    return glb({"scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes, "skins": [{"joints": list(range(depth)), "skeleton": 0}]})


def star(pairs):
    """Very many limbs, each with a counterpart, on one joint."""
    nodes = [{"children": list(range(1, 4 * pairs + 1, 2))}]
    for i in range(2 * pairs):
        side, along = 1 - 2 * (i % 2), i // 2
        nodes += [{"translation": [side * (0.1 + along % 97 / 97), along % 89 / 89, along % 83 / 83 - 0.5], "children": [2 * i + 2]},
                  {"translation": [side * 0.3, -0.2, 0.05]}]
    return glb({"scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes})


def long_clip(seconds, keys=2):
    times = struct.pack("<2f", 0.0, seconds)
    values = struct.pack("<6f", 0, 0, 0, 1, 1, 1)
    positions = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    return glb({"scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 2}}]}],
                "bufferViews": [view(8), view(24, byteOffset=8), view(36, byteOffset=32)],
                "accessors": [{"bufferView": 0, "componentType": 5126, "count": keys, "type": "SCALAR", "min": [0], "max": [seconds]},
                              {"bufferView": 1, "componentType": 5126, "count": keys, "type": "VEC3"},
                              {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
                "animations": [{"samplers": [{"input": 0, "output": 1}], "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]},
               times + values + positions)


def packed(mode, count, stride, length):
    extension = {"buffer": 0, "byteLength": length, "byteStride": stride, "count": count, "mode": mode}
    return glb({"extensionsUsed": ["EXT_meshopt_compression"], "extensionsRequired": ["EXT_meshopt_compression"],
                "buffers": [{"byteLength": length}, {"byteLength": count * stride, "extensions": {"EXT_meshopt_compression": {"fallback": True}}}],
                "bufferViews": [{"buffer": 1, "byteLength": count * stride, "extensions": {"EXT_meshopt_compression": extension}}] * 200},
               b"\xa0" + b"\0" * (length - 1))


def fbx_bomb(count):
    """A binary FBX whose only mesh unpacks to so many numbers."""
    def node(start, name, values=b"", number=0, children=()):
        head = 13 + len(name)
        body, at = b"", start + head + len(values)
        for child in children:
            made = child(at)
            body, at = body + made, at + len(made)
        body += bytes(13) if children else b""
        return struct.pack("<IIIB", start + head + len(values) + len(body), number, len(values), len(name)) + name + values + body
    packer = zlib.compressobj(9)
    zeros = b"".join(packer.compress(bytes(1 << 20)) for _ in range(count >> 17)) + packer.flush()
    text = lambda value: b"S" + struct.pack("<I", len(value)) + value
    vertices = lambda at: node(at, b"Vertices", b"d" + struct.pack("<III", count, 1, len(zeros)) + zeros, 1)
    polygons = lambda at: node(at, b"PolygonVertexIndex", b"i" + struct.pack("<IIIiii", 3, 0, 12, 0, 1, -3), 1)
    mesh = lambda at: node(at, b"Geometry", b"L" + struct.pack("<q", 2) + text(b"g\0\1Geometry") + text(b"Mesh"), 3, (vertices, polygons))
    model = lambda at: node(at, b"Model", b"L" + struct.pack("<q", 1) + text(b"m\0\1Model") + text(b"Mesh"), 3, (lambda at: node(at, b"Version", b"I" + struct.pack("<i", 232), 1),))
    link = lambda a, b: lambda at: node(at, b"C", text(b"OO") + b"L" + struct.pack("<q", a) + b"L" + struct.pack("<q", b), 3)
    parts = (lambda at: node(at, b"FBXHeaderExtension", b"", 0, (lambda at: node(at, b"FBXVersion", b"I" + struct.pack("<i", 7400), 1),)),
             lambda at: node(at, b"Objects", b"", 0, (mesh, model)), lambda at: node(at, b"Connections", b"", 0, (link(1, 0), link(2, 1))))
    whole = b"Kaydara FBX Binary  \0\x1a\0" + struct.pack("<I", 7400)
    for part in parts:
        whole += part(len(whole))
    return whole + bytes(13)


def hostile():
    """Names of files, what is in them, and the verbs that read them."""
    zeros = [{"componentType": 5126, "count": 1 << 24, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}]
    yield "zeros.glb", glb({"accessors": zeros, **triangles(50)})
    yield "count.glb", glb({"accessors": [{**zeros[0], "count": (1 << 53) - 1}], **triangles(1)})
    million = bytes(12 << 16)
    yield "shared.glb", glb({"bufferViews": [view(len(million))], "accessors": [{**zeros[0], "bufferView": 0, "count": 1 << 16}], **triangles(2000)}, million)
    yield "accessors.glb", glb({"bufferViews": [view(len(million))],
                                "accessors": [{**zeros[0], "bufferView": 0, "count": 1 << 16}] * 5000}, million)
    targets = {"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "targets": [{"POSITION": 0}] * 20000}]}]}
    yield "targets.glb", glb({"accessors": [{**zeros[0], "count": 1 << 20}], **targets})
    for kind, stride in (("ATTRIBUTES", 256), ("TRIANGLES", 4), ("INDICES", 4)):
        yield f"packed_{kind.lower()}.glb", packed(kind, 3 << 14, stride, 1 << 16)
    yield "pixels.glb", textured([png(30000, 30000)], 1)
    yield "pictures.glb", textured([png(4096, 4096 - i) for i in range(24)], 24)
    yield "picture_again.glb", textured([png(64, 64) + bytes(4 << 20)], 5000)
    yield "chain.glb", chain(50000)
    yield "star.glb", star(700)
    yield "deep.gltf", b'{"asset":{"version":"2.0"},"extras":' + b"[" * 1000000 + b"]" * 1000000 + b"}"
    yield "lists.gltf", b'{"asset":{"version":"2.0"},"extras":[' + b"[]," * 2000000 + b"0]}"
    members = b",".join(b'"%d":%d' % (i, i) for i in range(300000))
    yield "members.gltf", b'{"asset":{"version":"2.0"},"extras":{' + members + b"}}"
    yield "members.json", b'{"version":1,"trails":{' + members + b"}}"
    for seconds in (1e5, 2e5, 1e6, 1e9, 3e38):
        yield f"clip_{seconds:g}.glb", long_clip(seconds)
    person = b"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    yield "frames.bvh", person + b"End Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 2000000000\nFrame Time: 0.01\n0 0 0\n"
    yield "deep.bvh", person + b"JOINT b\n{\nOFFSET 0 1 0\nCHANNELS 0\n" * 300000
    yield "bomb.fbx", fbx_bomb(3 << 25)
    yield "recipe.json", b'{"version":1,"trails":' + b"[" * 500000 + b"]" * 500000 + b"}"
    yield "range.json", b'{"version":1,"trails":[{"limb":"left-arm","range":[0,1e12],"scale":2}]}'
    yield "base.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    yield "cache.pc2", b"POINTCACHE2\0" + struct.pack("<iiffi", 1, 3, 0.0, 1.0, 0x7FFFFFFF)
    yield "cache.mdd", struct.pack(">ii", 0x7FFFFFFF, 3)
    yield "huge.ply", b"ply\nformat ascii 1.0\nelement vertex 9000000000000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"
    yield "rows.ply", (b"ply\nformat binary_little_endian 1.0\nelement vertex 900000000000\nproperty list uchar uchar none\n"
                       b"end_header\n" + b"\0" * 2000000)
    yield "corners.ply", (b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                          b"property list uint int vertex_indices\nend_header\n0 0 0\n4000000000 0 0\n")
    yield "materials.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n" + b"".join(b"usemtl m%d\nf 1/1 2/1 3/1\n" % i for i in range(60000))


def commands(program, file, folder):
    if file.suffix == ".json":
        return [[program, "exaggerate", ROOT / "assets/dummy.glb", "-o", folder / "out.glb", "--recipe", file]]
    if file.suffix in (".pc2", ".mdd"):
        return [[program, "compress", folder / "base.obj", file, "-o", folder / "out.glb"]]
    if file.suffix in (".obj", ".ply"):
        frames = folder / file.stem
        frames.mkdir()
        for name in ("frame-1", "frame-2"):
            (frames / (name + file.suffix)).write_bytes(file.read_bytes())
        return [[program, "compress", frames, "-o", folder / "out.glb", "--bones", "1"]]
    verbs = [[program, "info", file, "--json"], [program, "check", file], [program, "resave", file, "-o", folder / "out.glb"]]
    if file.name.startswith("clip"):
        verbs.append([program, "compress", file, "-o", folder / "out.glb"])
    return verbs


def yardstick():
    """Processor seconds of a work that any machine does as fast as it is: packing and memory that is touched for the first time."""
    began = time.process_time()
    packer = zlib.compressobj(9)
    packed = b"".join(packer.compress(bytes(1 << 20)) for _ in range(128)) + packer.flush()
    zlib.decompress(packed)
    return time.process_time() - began


def run(command, most):
    """Exit code, what was told, peak of memory in bytes, seconds; ended after twice the seconds that it may take."""
    ended = 2 * math.ceil(most)
    with tempfile.TemporaryFile() as told:
        child = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=told,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (ended, ended)))
        _, status, usage = os.wait4(child.pid, 0)
        told.seek(0)
        return os.waitstatus_to_exitcode(status), told.read().decode(errors="replace"), usage.ru_maxrss << 10, usage.ru_utime + usage.ru_stime


def problems_of(name, size, command, most, shown):
    code, told, peak, seconds = run(command, most)
    if shown:
        print(f"{name:24} {command[1]:10} {size / 1e6:7.2f} MB {peak / 1e6:8.0f} MB {seconds:6.2f} s  {code}  {told.strip()[:100]}")
    problems = []
    if code not in (0, 1):
        problems.append(f"exit code {code}: {told[-200:]}")
    if code == 1 and command[1] != "check" and told.count("\n") != 1:
        problems.append(f"told in {told.count(chr(10))} lines")
    if peak > BYTES_FOR_ONE * size + (BYTES_FOR_FOREIGN if name.endswith((".fbx", ".bvh")) else BYTES_FOR_ANY):
        problems.append(f"{peak / 1e6:.0f} MB for a file of {size / 1e6:.2f} MB")
    if seconds > most:
        problems.append(f"{seconds:.1f} seconds, and {most:.1f} would do")
    return [f"{name}, {command[1]}: {problem}" for problem in problems]


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    shown = "--show" in sys.argv
    failed = []
    most = max(SECONDS, TIMES_THE_YARDSTICK * yardstick())
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        count = 0
        for name, content in hostile():
            file = folder / name
            file.write_bytes(content)
            for command in commands(program, file, folder):
                count += 1
                failed += problems_of(name, len(content), command, most, shown)
    for problem in failed:
        print("FAILED:", problem)
    print(f"{count} runs on small files that ask for much, {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
