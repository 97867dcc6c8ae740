#!/usr/bin/env python3
"""foreign.py PROGRAM RUNS|FIRST:END [FILE...]: files of other programs (FBX, BVH, VRM animation, Collada; without files, those in DATA/interchange of
STRETCH_DATA and arm.dae), damaged anywhere or in their values alone, through `info`, every fourth through `resave`, every eighth through `import-clip` onto the bundled boxer. The program answers 0, or 1 and
one line; it and the process that reads stay within memory and time, and neither files nor processes are left behind."""
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from damage import damaged

BYTES_FOR_ONE = 64
BYTES_FOR_ANY = 800 << 20
SECONDS = 130
ROOT = pathlib.Path(__file__).resolve().parents[2]
KINDS = (".fbx", ".bvh", ".vrma", ".dae")


def verb_of(rng, file):
    match rng.randrange(8):
        case 0: return ["import-clip", ROOT / "assets/dummy.glb", "--from", file, "-o", file + ".glb"]
        case 1 | 2: return ["resave", file, "-o", file + ".glb"]
        case _: return ["info", file]


def still_runs(session):
    try:
        os.killpg(session, 9)
    except ProcessLookupError:
        return False
    return True


def problem_of(program, words):
    child = subprocess.Popen([program, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)
    try:
        told = child.communicate(timeout=SECONDS)[1].decode(errors="replace")
    except subprocess.TimeoutExpired:
        os.killpg(child.pid, 9)
        return "takes too long", ""
    if still_runs(child.pid):
        return "a process of it still runs", ""
    if child.returncode == 0:
        return "", "read"
    if child.returncode != 1 or told.count("\n") != 1:
        return f"exit code {child.returncode}: {told[-300:]}", ""
    kind = "brought down" if "brought the reader" in told else "too expensive" if "more memory or time" in told else "refused"
    return "", kind


def main():
    program, runs = str(pathlib.Path(sys.argv[1]).resolve()), range(*map(int, sys.argv[2].split(":")))
    files = [pathlib.Path(name) for name in sys.argv[3:]]
    if not files and os.environ.get("STRETCH_DATA"):
        files = sorted(f for f in (pathlib.Path(os.environ["STRETCH_DATA"]) / "interchange").iterdir() if f.suffix in KINDS)
        files.append(pathlib.Path(__file__).resolve().parent / "arm.dae")
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
        problem, kind = problem_of(program, verb_of(rng, path))
        for made in (path, path + ".glb"):
            if os.path.exists(made):
                os.remove(made)
        return run, file.name, problem, kind

    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(int(os.environ.get("JOBS", "1"))) as pool:
        for run, name, problem, kind in pool.map(one, runs):
            counts[kind] = counts.get(kind, 0) + 1
            if problem:
                failed.append(f"run {run}, {name}: {problem}")
                print("FAILED:", failed[-1], flush=True)
            elif run % 1000 == 999:
                print(f"up to {run}", flush=True)
        if os.listdir(folder):
            failed.append(f"left behind: {os.listdir(folder)[:3]}")
            print("FAILED:", failed[-1])
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss << 10
    most = BYTES_FOR_ANY + BYTES_FOR_ONE * max(len(content) for _, content in contents) + (256 << 20)
    if peak > most:
        failed.append(f"{peak >> 20} MB")
        print("FAILED:", failed[-1])
    print(f"{len(runs)} damaged files: " + ", ".join(f"{count} {kind}" for kind, count in sorted(counts.items()) if kind) + f"; at most {peak >> 20} MB; {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
