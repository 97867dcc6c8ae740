#!/usr/bin/env python3
"""Opens and saves every real file of a data folder with the built program and compares the result with the source.

    check_corpus.py PROGRAM DATA_FOLDER

Valid files: JSON equal in content and in the order of its keys, binary data equal, .glb -> .gltf -> .glb and the other way.
Malformed files: refused with exactly one line and nothing written; those that break only what files in use are known to break
open with a message. With --tolerant more of them may open. Never a crash, a hang or a file left behind.
"""

import base64
import json
import pathlib
import resource
import struct
import subprocess
import sys
import tempfile
import urllib.parse

SECONDS_AT_MOST = 60
BYTES_AT_MOST = 8 << 30
VALID_FOLDERS = ["biped", "vrm", "quadruped", "interpolation", "mesh-sequence/morph"]
SUFFIXES = {".glb", ".gltf", ".vrm", ".vrma"}
# Files that require compression: they open as any other and are saved as they are. What `info` has to find in them.
COMPRESSED = {"valid-avatar-Asian_M_1_Busi.glb": {"extension": "EXT_meshopt_compression", "vertices": 32044, "limbs": 6}}

# Codes of the Khronos validator for what characters in use get wrong: such files open with a warning.
# Tangents are not read; normals are repaired, with a warning.
TOLERATED = {"ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE", "SKIN_SKELETON_INVALID", "ACCESSOR_VECTOR3_NON_UNIT", "ACCESSOR_INVALID_SIGN"}


def run(program, *arguments):
    """Exit status and both outputs of the program, with bounded time and memory."""

    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (BYTES_AT_MOST, BYTES_AT_MOST))

    try:
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=SECONDS_AT_MOST, preexec_fn=limit)
    except subprocess.TimeoutExpired:
        return None, "", "took too long"
    return done.returncode, done.stdout, done.stderr


def read_gltf(path):
    """JSON and the bytes of all buffers."""
    raw = path.read_bytes()
    binary = None
    if raw[:4] == b"glTF":
        offset, chunks = 12, {}
        while offset + 8 <= len(raw):
            length, kind = struct.unpack_from("<I4s", raw, offset)
            chunks.setdefault(kind, raw[offset + 8 : offset + 8 + length])
            offset += 8 + length
        document = json.loads(chunks[b"JSON"])
        binary = chunks.get(b"BIN\0")
    else:
        document = json.loads(raw)
    buffers = []
    for index, buffer in enumerate(document.get("buffers", [])):
        uri = buffer.get("uri")
        if uri is None:
            content = binary if index == 0 and binary is not None else b""
        elif uri.startswith("data:"):
            content = base64.b64decode(uri.split(",", 1)[1])
        else:
            beside = path.parent / urllib.parse.unquote(uri)
            content = beside.read_bytes() if beside.is_file() else b""
        buffers.append(content[: buffer["byteLength"]])
    return document, buffers


def without_home(document):
    """The JSON without the place of the first buffer, which changes between .glb and .gltf; key order kept."""
    copy = json.loads(json.dumps(document))
    if copy.get("buffers"):
        copy["buffers"][0].pop("uri", None)
    return copy


def differences(source, result):
    source_json, source_buffers = read_gltf(source)
    result_json, result_buffers = read_gltf(result)
    found = []
    if json.dumps(without_home(source_json)) != json.dumps(without_home(result_json)):
        found.append("the JSON differs")
    if source_buffers != result_buffers:
        found.append("the binary data differs")
    for image in source_json.get("images", []):
        uri = image.get("uri", "data:")
        if not uri.startswith("data:"):
            name = urllib.parse.unquote(uri)
            original, copied = source.parent / name, result.parent / name
            if original.is_file() and (not copied.is_file() or original.read_bytes() != copied.read_bytes()):
                found.append(f"the image {name} was not carried along")
    return found


def check_round_trips(program, file, folder):
    """Problems of FILE -> .glb, FILE -> .gltf and both back again."""
    problems = []
    for first, second in [("glb", "gltf"), ("gltf", "glb")]:
        once = folder / f"once_{first}" / f"model.{first}"
        twice = folder / f"twice_{second}" / f"model.{second}"
        for source, target in [(file, once), (once, twice)]:
            target.parent.mkdir(exist_ok=True)
            status, _, errors = run(program, "resave", source, "-o", target)
            if status != 0:
                return problems + [f"{source.name} -> {target.name}: exit status {status}: {errors.strip()}"]
            problems += [f"{source.name} -> {target.name}: {what}" for what in differences(file, target)]
    return problems


def check_valid(program, file):
    with tempfile.TemporaryDirectory() as folder:
        problems = check_round_trips(program, file, pathlib.Path(folder))
    return problems + (check_compressed(program, file, COMPRESSED[file.name]) if file.name in COMPRESSED else [])


def check_compressed(program, file, expected):
    """Problems of what `info` finds in a file that requires compression."""
    status, output, errors = run(program, "info", file, "--json")
    if status != 0:
        return [f"info: exit status {status}: {errors.strip()}"]
    info = json.loads(output)
    found = {
        "extension": next((use["name"] for use in info["extensions"] if use["name"] == expected["extension"] and use["shown"]), None),
        "vertices": sum(mesh["vertices"] for mesh in info["meshes"]),
        "limbs": len(info["limbs"]),
    }
    return [f"info finds {key} {found[key]} instead of {expected[key]}" for key in expected if found[key] != expected[key]]


def check_refused(status, errors, folder):
    problems = []
    if status != 1:
        problems.append(f"exit status {status}: {errors.strip()[:200]}")
    if len(errors.strip().splitlines()) != 1:
        problems.append(f"{len(errors.strip().splitlines())} lines of error instead of one")
    if list(folder.iterdir()):
        problems.append("left files behind")
    return problems


def check_opened_with_message(program, file):
    status, output, errors = run(program, "check", file, "--json")
    if status not in (0, 1):
        return [f"check: exit status {status}: {errors.strip()[:200]}"]
    found = json.loads(output).get("problems", [])
    if status != int(any(problem["severity"] == "error" for problem in found)):
        return [f"check: exit status {status} with the problems {found}"]
    return [] if found else ["was opened without a message"]


def check_malformed(program, file, codes):
    """`codes` are the errors of the Khronos validator; None where it could not read the file at all."""
    problems = []
    for options in ([], ["--tolerant"]):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            status, _, errors = run(program, "resave", file, "-o", folder / "out.glb", *options)
            if status != 0:
                problems += check_refused(status, errors, folder)
                if codes is not None and codes <= TOLERATED:
                    problems.append("should open, but was refused: " + errors.strip())
                continue
            if not (folder / "out.glb").is_file():
                problems.append("says that it saved, but wrote nothing")
            elif codes is None or codes - TOLERATED:
                problems += check_opened_with_message(program, file) if options else ["should be refused, but was opened"]
            elif codes:
                problems += check_opened_with_message(program, file)
    return problems


def expectations(invalid):
    """Each file with the validator's error codes; the table lists codes of warnings beside those of errors."""
    for line in (invalid / "EXPECTED.tsv").read_text().splitlines()[1:]:
        columns = line.split("\t")
        if not columns[4].isdigit():
            yield invalid / columns[0], None
        else:
            codes = {code.split(":")[0] for code in columns[6].split()} if int(columns[4]) else set()
            yield invalid / columns[0], codes


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    program, data = sys.argv[1], pathlib.Path(sys.argv[2])
    checked, failed = 0, 0
    jobs = [(file, check_valid, ()) for folder in VALID_FOLDERS for file in sorted((data / folder).rglob("*")) if file.suffix in SUFFIXES]
    jobs += [(file, check_malformed, (codes,)) for file, codes in expectations(data / "invalid")]
    for file, test, arguments in jobs:
        problems = test(program, file, *arguments)
        checked += 1
        failed += bool(problems)
        for problem in problems:
            print(f"{file.relative_to(data)}: {problem}")
    print(f"{checked} files checked, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
