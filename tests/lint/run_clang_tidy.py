#!/usr/bin/env python3
"""Runs clang-tidy over every C++ source, several at a time.

    run_clang_tidy.py BUILD [--jobs N] [--seconds S] [FILE...]

BUILD is a build folder configured without unity and without precompiled headers; its compile_commands.json says how each file
is compiled. Files that share their options and repeat no local name are checked together, two dozen at a time, which parses
headers once instead of two dozen times. What came out clean is remembered in BUILD/clean, by the bytes of the file, of every header
of ours that it reaches, of its options and of the configuration; it is not checked again before one of these changes.

Files that are named are checked in that order. With --seconds what is not done after that time is left. The last line holds the counts.
Exit 0: clean, 1: findings, 77: clang-tidy is not installed, 75: the time was up, no findings so far.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass

from sources import INCLUDE

FILES_A_BATCH = 24
SKIPPED = 77
TIME_IS_UP = 75
FINDING = re.compile(r"^(/[^:\n]+):(\d+):(\d+): (?:warning|error): (.*)$", re.MULTILINE)
# Names that a source keeps to itself: types, functions and constants that begin in the first column, and test cases.
LOCAL_NAME = re.compile(
    r"^(?:static |constexpr |inline |const |template ?<.*> ?)*(?:struct|class|enum class|enum|using(?! namespace)) (\w+)(?!\w|::)"
    r"|^(?!TEST_CASE|return|using|namespace|else|if|for)[a-zA-Z][\w:<>,&*\[\] ]*?[ &*](\w+)(?:\(|\{| =|\[)",
    re.MULTILINE,
)


@dataclass(frozen=True)
class Source:
    file: pathlib.Path
    options: tuple  # What it is compiled with, without its own name and its output.
    key: str


def options_of(entry):
    """The options of a compile command, as clang understands them."""
    words = shlex.split(entry["command"])
    while words and not words[0].endswith(("c++", "g++", "clang++")):
        words.pop(0)
    options, rest = [], iter(words[1:])
    for word in rest:
        if word in ("-o", "-c"):
            next(rest, None)
        elif not word.startswith(("-W", "-O")):
            options.append(word)
    return tuple(options)


class Keys:
    """What a file's answer depends on: its bytes, those of the headers of ours that it reaches, options, configuration."""

    def __init__(self, root, common):
        self.root = root
        self.common = common
        self.digests = {}
        self.includes = {}

    def digest(self, name):
        if name not in self.digests:
            data = (self.root / name).read_bytes()
            self.digests[name] = hashlib.sha256(data).hexdigest()
            targets = (INCLUDE.match(line) for line in data.decode("utf-8").splitlines())
            names = {match.group(2) for match in targets if match and match.group(1) == '"'}
            self.includes[name] = sorted(name for name in names if (self.root / name).is_file())
        return self.digests[name]

    def key(self, name, options):
        reached, waiting = set(), [name]
        while waiting:
            current = waiting.pop()
            if current not in reached:
                reached.add(current)
                self.digest(current)
                waiting += self.includes[current]
        text = [self.common, *(option.replace(str(self.root), "") for option in options)]
        text += [f"{reach} {self.digest(reach)}" for reach in sorted(reached)]
        return hashlib.sha256("\n".join(text).encode()).hexdigest()


def configuration(root, program):
    """What every answer depends on: the program, its configuration, the versions of the packages."""
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=False).stdout
    text = [version, (root / ".clang-tidy").read_text(encoding="utf-8")]
    packages = root / "third_party" / "packages.txt"
    if packages.is_file() and shutil.which("dpkg-query"):
        names = [line for line in packages.read_text(encoding="utf-8").split("\n") if line and not line.startswith("#")]
        query = ["dpkg-query", "-W", *" ".join(names).split()]
        text.append(subprocess.run(query, capture_output=True, text=True, check=False).stdout)
    return hashlib.sha256("\n".join(text).encode()).hexdigest()


def local_names(text):
    return {first or second for first, second in LOCAL_NAME.findall(text)}


def batches_of(sources):
    """Sources with the same options and no local name in common, together."""
    open_batches = {}
    batches = []
    for source in sources:
        names = local_names(source.file.read_text(encoding="utf-8"))
        candidates = open_batches.setdefault(source.options, [])
        fitting = next((entry for entry in candidates if not names & entry[1]), None)
        if fitting is None:
            fitting = ([], set())
            candidates.append(fitting)
            batches.append(fitting[0])
        fitting[0].append(source)
        fitting[1].update(names)
        if len(fitting[0]) == FILES_A_BATCH:
            candidates.remove(fitting)
    return batches


class Tidy:
    def __init__(self, program, build, root, deadline):
        self.program = program
        self.build = build
        self.root = root
        self.deadline = deadline
        self.folder = build / "batches"
        self.clean = build / "clean"
        for folder in (self.folder, self.clean):
            folder.mkdir(parents=True, exist_ok=True)

    def is_clean(self, source):
        return (self.clean / source.key).exists()

    def check(self, batch):
        """Findings of a batch and how many of its files were checked."""
        if self.deadline is not None and time.monotonic() > self.deadline:
            return set(), 0
        joined, unasked = batch[0].file, []
        if len(batch) > 1:
            # Sources that include sources are what a batch is.
            unasked = ["--checks=-bugprone-suspicious-include"]
            joined = self.folder / f"{batch[0].key[:16]}.cpp"
            joined.write_text("".join(f'#include "{source.file}"\n' for source in batch), encoding="utf-8")
        sources_too = "/(core|rig|skinning|app|ui|assets|tests)/.*\\.(h|cpp)$"
        command = [self.program, "--quiet", f"--config-file={self.root / '.clang-tidy'}", f"--header-filter={sources_too}"]
        try:
            done = subprocess.run(
                [*command, *unasked, str(joined), "--", *batch[0].options],
                capture_output=True,
                text=True,
                cwd=self.build,
                check=False,
                timeout=None if self.deadline is None else max(1.0, self.deadline - time.monotonic()),
            )
        except subprocess.TimeoutExpired:
            return set(), 0
        findings = {match.group(0) for match in FINDING.finditer(done.stdout) if str(self.folder) not in match.group(1)}
        found_in = {match.group(1) for match in FINDING.finditer(done.stdout)}
        compiles = "[clang-diagnostic-error]" not in done.stdout
        # A finding in a header counts for all that may have drawn it in.
        if compiles and (findings or done.returncode == 0) and found_in <= {str(source.file) for source in batch}:
            for source in batch:
                if str(source.file) not in found_in:
                    (self.clean / source.key).touch()
            return findings, len(batch)
        if len(batch) > 1 and (not compiles or not findings):
            # Local names that cannot live together: apart.
            middle = len(batch) // 2
            first, second = self.check(batch[:middle]), self.check(batch[middle:])
            return first[0] | second[0], first[1] + second[1]
        if not findings:
            findings = {f"{joined}: clang-tidy failed: {(done.stderr or done.stdout).strip()[:400]}"}
        return findings, len(batch)


def all_sources(root, build, program, wanted):
    keys = Keys(root, configuration(root, program))
    sources = []
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        file = pathlib.Path(entry["file"])
        if not file.is_relative_to(root) or file.is_relative_to(build):
            continue
        name = str(file.relative_to(root))
        if wanted and name not in wanted:
            continue
        options = options_of(entry)
        source = Source(file, options, keys.key(name, options))
        if all(other.file != file for other in sources):
            sources.append(source)
    order = {name: place for place, name in enumerate(wanted)}
    return sorted(sources, key=lambda source: order.get(str(source.file.relative_to(root)), 0))


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--seconds", type=float)
    parser.add_argument("file", nargs="*")
    given = parser.parse_intermixed_args(arguments)
    program = shutil.which("clang-tidy")
    if program is None:
        print("skipped: clang-tidy is not installed")
        return SKIPPED
    root = pathlib.Path(__file__).resolve().parents[2]
    deadline = None if given.seconds is None else time.monotonic() + given.seconds
    tidy = Tidy(program, given.build.resolve(), root, deadline)
    sources = all_sources(root, tidy.build, program, given.file)
    waiting = [source for source in sources if not tidy.is_clean(source)]
    findings, checked = set(), 0
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for found, count in pool.map(tidy.check, batches_of(waiting)):
            for finding in sorted(found - findings):
                print(finding.replace(f"{root}/", "", 1), flush=True)
            findings |= found
            checked += count
    left = len(waiting) - checked
    print(f"{checked} of {len(waiting)} files checked, {len(sources) - len(waiting)} known to be clean, {len(findings)} findings")
    if findings:
        return 1
    return TIME_IS_UP if left else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
