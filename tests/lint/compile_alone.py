#!/usr/bin/env python3
"""Compiles every C++ source by itself with clang++, to no output: a second compiler's warnings, and headers that a source reads
only because another one of its room was compiled before it.

    compile_alone.py BUILD [--jobs N] [--seconds S] [FILE...]

BUILD is a build folder configured without unity and without precompiled headers. Files that are named are compiled in that
order. With --seconds no further one is begun after that time. The last line holds the counts.
Exit 0: clean, 1: findings, 75: the time was up, no findings so far, 77: no clang++ of version 16 or later (earlier ones cannot read the standard library's headers).
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

from run_clang_tidy import SKIPPED, TIME_IS_UP, options_of

OLDEST = 16
FINDING = re.compile(r"^([^:\n]+:\d+):\d+: (?:fatal )?(?:warning|error): (.*)$", re.MULTILINE)


def compiler():
    for name in ("clang++", *(f"clang++-{version}" for version in range(OLDEST, 30))):
        program = shutil.which(name)
        if program:
            said = subprocess.run([program, "-dumpversion"], capture_output=True, text=True, check=False).stdout
            if int(said.split(".")[0]) >= OLDEST:
                return program
    return None


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--seconds", type=float)
    parser.add_argument("file", nargs="*")
    given = parser.parse_intermixed_args(arguments)
    program = compiler()
    if program is None:
        print(f"skipped: clang++ {OLDEST} or later is not installed")
        return SKIPPED
    root = pathlib.Path(__file__).resolve().parents[2]
    build = given.build.resolve()
    deadline = None if given.seconds is None else time.monotonic() + given.seconds
    entries = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        file = pathlib.Path(entry["file"])
        name = str(file.relative_to(root)) if file.is_relative_to(root) else ""
        if name and not file.is_relative_to(build) and (not given.file or name in given.file):
            warnings = [word for word in entry["command"].split() if word.startswith("-W")]
            entries[name] = (*options_of(entry), *warnings, "-Wno-unknown-warning-option", "-Werror")

    def findings_of(name):
        """Nothing where the time is up."""
        if deadline is not None and time.monotonic() > deadline:
            return None
        command = [program, *entries[name], "-fsyntax-only", str(root / name)]
        done = subprocess.run(command, capture_output=True, text=True, cwd=build, check=False)
        found = {f"{match.group(1)}: {match.group(2)}" for match in FINDING.finditer(done.stderr)}
        return found or ({f"{name}: {done.stderr.strip()[:400]}"} if done.returncode else set())

    findings, done = set(), 0
    order = {name: place for place, name in enumerate(given.file)}
    names = sorted(entries, key=lambda name: (order.get(name, 0), name))
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for found in pool.map(findings_of, names):
            if found is None:
                continue
            done += 1
            for finding in sorted(found - findings):
                print(finding.replace(f"{root}/", "", 1), flush=True)
            findings |= found
    print(f"{done} of {len(entries)} files compiled, {len(findings)} findings")
    if findings:
        return 1
    return TIME_IS_UP if done < len(entries) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
