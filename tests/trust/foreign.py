#!/usr/bin/env python3
"""foreign.py PROGRAM RUNS [FILE...]: damaged files of other programs (FBX, BVH, Collada; without files, those in DATA/interchange of STRETCH_DATA). The
program answers 0, or 1 and one line; it and the process that reads stay within memory and time, and nothing is left behind."""
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

BYTES_FOR_ONE = 64
BYTES_FOR_ANY = 800 << 20
SECONDS = 130


def damaged(content, rng):
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


def problem_of(program, file, size):
    child = subprocess.Popen([program, "resave", file, "-o", file + ".glb"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)
    try:
        told = child.communicate(timeout=SECONDS)[1].decode(errors="replace")
    except subprocess.TimeoutExpired:
        child.kill()
        return "takes too long", ""
    if child.returncode == 0:
        return "", "read"
    if child.returncode != 1 or told.count("\n") != 1:
        return f"exit code {child.returncode}: {told[-300:]}", ""
    kind = "brought down" if "brought the reader" in told else "too expensive" if "more memory or time" in told else "refused"
    return "", kind


def main():
    program, runs = str(pathlib.Path(sys.argv[1]).resolve()), int(sys.argv[2])
    files = [pathlib.Path(name) for name in sys.argv[3:]]
    if not files and os.environ.get("STRETCH_DATA"):
        files = sorted(f for f in (pathlib.Path(os.environ["STRETCH_DATA"]) / "interchange").iterdir() if f.suffix in (".fbx", ".bvh", ".dae"))
    if not files:
        print("skipped: no files; STRETCH_DATA names none")
        return 77
    contents = [(file, file.read_bytes()) for file in files]
    counts, failed = {}, []

    def one(run):
        rng = random.Random(run)
        file, content = contents[run % len(contents)]
        content = damaged(content, rng)
        path = os.path.join(folder, f"{run}{file.suffix}")
        pathlib.Path(path).write_bytes(content)
        problem, kind = problem_of(program, path, len(content))
        for made in (path, path + ".glb"):
            if os.path.exists(made):
                os.remove(made)
        return run, file.name, problem, kind

    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(int(os.environ.get("JOBS", "1"))) as pool:
        for run, name, problem, kind in pool.map(one, range(runs)):
            counts[kind] = counts.get(kind, 0) + 1
            if problem:
                failed.append(f"run {run}, {name}: {problem}")
        if os.listdir(folder):
            failed.append(f"left behind: {os.listdir(folder)[:3]}")
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss << 10
    most = BYTES_FOR_ANY + BYTES_FOR_ONE * max(len(content) for _, content in contents) + (256 << 20)
    if peak > most:
        failed.append(f"{peak >> 20} MB")
    for line in failed:
        print("FAILED:", line)
    print(f"{runs} damaged files: " + ", ".join(f"{count} {kind}" for kind, count in sorted(counts.items()) if kind) + f"; at most {peak >> 20} MB; {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
