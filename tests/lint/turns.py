#!/usr/bin/env python3
"""Says which C++ sources are to be checked one by one when there is no time for all: first those that changed of late, then the fifth
of the rest whose turn it is.

    turns.py ROOT     names of sources from ROOT, a line for each, the most urgent first

A clean clone does not remember what was checked. So "of late" is read from the history: since the last day before the newest commit. The
fifth is chosen by the number of commits: five commits in a row have every source checked.
"""

import pathlib
import subprocess
import sys
import zlib

from sources import code_files

TURNS = 5
SECONDS_OF_LATE = 24 * 3600


def git(root, *arguments):
    done = subprocess.run(["git", "-C", str(root), *arguments], capture_output=True, text=True, check=False)
    return done.stdout.split("\n") if done.returncode == 0 else []


def changed_of_late(root):
    """Files that the last day of the history changed; all that a shallow clone shows when it holds no commit before."""
    newest = next(iter(git(root, "log", "-1", "--format=%ct")), "")
    if not newest:
        return []
    before = next(iter(git(root, "log", "-1", "--format=%H", f"--before=@{int(newest) - SECONDS_OF_LATE}")), "")
    return [name for name in git(root, "diff", "--name-only", before, "HEAD") if name] if before else []


def source_of(name, files):
    """The source that a changed file is checked by: itself, else the source of that header, else one that includes it."""
    if name.endswith(".cpp"):
        return name if name in files else None
    own = name.removesuffix(".h") + ".cpp"
    if own in files:
        return own
    including = (other for other, file in files.items() if any(include.target == name for include in file.includes()))
    return next(including, None)


def turn_of(name):
    return zlib.crc32(name.encode()) % TURNS


def chosen(files, changed, turn):
    """Names of sources, those of changed files first, and of these the ones whose turn it is; `files` by name."""
    urgent = (source_of(name, files) for name in changed if name.endswith((".cpp", ".h")))
    names = sorted((name for name in urgent if name), key=lambda name: (turn_of(name) - turn) % TURNS)
    names += [name for name in sorted(files) if turn_of(name) == turn % TURNS]
    return list(dict.fromkeys(names))


def main(arguments):
    root = pathlib.Path(arguments[0])
    files = {file.name: file for file in code_files(root) if file.suffix == ".cpp"}
    turn = int(next(iter(git(root, "rev-list", "--count", "HEAD")), "0") or 0)
    print("\n".join(chosen(files, changed_of_late(root), turn)))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
