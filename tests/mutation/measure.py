#!/usr/bin/env python3
"""Measures what the tests notice: plants faults in a copy of the product and tells those that no test turns red.

Needs a build with its tests (./test); links their objects with the planted rooms, so that only these are compiled anew.
docs/testing.md says how to read the table."""

import argparse
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import draw
import table
import trials
from mutants import ROOMS, Tree, read_mutants
from plant import Planting

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# Written mutants may lag behind a change of the product, a few of them.
GONE_AT_MOST = 0.05


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the tree whose faults are made")
    parser.add_argument("--build", type=pathlib.Path, help="a build with tests (build/release)")
    parser.add_argument("--drawn", type=int, default=300, help="mutants drawn by chance, as many in each room (300)")
    parser.add_argument("--seed", default="1", help="of the draw")
    parser.add_argument("--try", dest="first", type=int, help="try the first N of each room's drawn ones only")
    parser.add_argument("--room", action="append", choices=ROOMS, help="only mutants of this room; may be repeated")
    parser.add_argument("--under", action="append", metavar="FOLDER", help="drawn ones only in files whose path begins so; may be repeated")
    parser.add_argument("--written-only", action="store_true", help="none drawn")
    parser.add_argument("--drawn-only", action="store_true", help="none written by hand")
    parser.add_argument("--windows", action="store_true", help="the scripts that drive the window too, minutes each")
    parser.add_argument("--tests", action="append", metavar="LABEL", help="only tests of this label, such as rig; may be repeated")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--budget", type=float, default=120, help="seconds of tests for one mutant (120)")
    parser.add_argument("--living", action="store_true", help="only what lived in the last run; the dead stay dead")
    parser.add_argument("--reuse", action="store_true", help="known traces stay, though a test program was built anew")
    parser.add_argument("--no-build", action="store_true", help="what is planted already stands")
    parser.add_argument("--build-only", action="store_true", help="stop when the programs stand; plan.json tells what would be tried")
    parser.add_argument("--check", action="store_true", help="only tell written mutants whose line is gone; 1 where they are many")
    return parser.parse_args()


def read_json(path, otherwise):
    return json.loads(path.read_text()) if path.exists() else otherwise


class Measure:
    def __init__(self, asked):
        self.asked = asked
        self.root = asked.root.resolve()
        self.build = (asked.build or self.root / "build/release").resolve()
        self.folder = self.root / "build/mutation"
        self.folder.mkdir(parents=True, exist_ok=True)
        self.tree = Tree(self.root)
        self.rooms = asked.room or list(ROOMS)  # What is planted; the others stand as the build has them.
        self.equivalent = {one.key: one.says for one in read_mutants(HERE / "equivalent.jsonl")}
        self.gone = []

    # What is tried.

    def mutants(self):
        """Numbered, so that a mutant keeps its number in later runs; more are drawn than asked for, as some will not compile."""
        refused = {tuple(key) for key in read_json(self.folder / "refused.json", [])}
        found = []
        for room in self.rooms:
            found += draw.drawn(self.tree, self.asked.seed, room, self.asked.drawn // len(ROOMS) * 5 // 4, refused, self.asked.under or ())
        for mutant in read_mutants(HERE / "written.jsonl"):
            if mutant.room not in self.rooms:
                continue
            located = self.tree.locate(mutant)
            (found if located else self.gone).append(located or mutant)
        numbers = read_json(self.folder / "numbers.json", {})
        for mutant in found:
            key = "|".join((mutant.file, str(mutant.nth), mutant.operator, mutant.line, mutant.becomes))
            mutant.number = numbers.setdefault(key, len(numbers))
        (self.folder / "numbers.json").write_text(json.dumps(numbers))
        return found

    def planted(self, mutants):
        """Those that stand in the planted tree, built; and the written ones that do not compile."""
        planting = Planting(self.tree, self.folder, HERE / "mutant.h")
        refused = {tuple(key) for key in read_json(self.folder / "refused.json", [])}
        if not self.asked.no_build:  # Written ones have another go: what errs may be mended, or have been another's.
            refused -= {mutant.key for mutant in mutants if mutant.operator == "written"}
        planting.plant([mutant for mutant in mutants if mutant.key not in refused])
        planting.copied_beside("CMakeLists.txt", "third_party", "assets", "package")
        if not self.asked.no_build:
            libraries = self.folder / "libraries"
            if not (libraries / "build.ninja").exists():
                subprocess.run(
                    ["cmake", "-S", planting.copy, "-B", libraries, "-G", "Ninja", "-DSTRETCH_TESTS=OFF", "-DCMAKE_BUILD_TYPE=Release",
                     f"-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG -w -fmax-errors=0 -include {HERE / 'mutant.h'}"],
                    check=True, stdout=subprocess.DEVNULL,
                )
            planting.build(["ninja", "-C", str(libraries), "-k", "0", "-j", str(self.asked.jobs), *(f"stretch_{room}" for room in self.rooms)])
        refused |= {mutant.key for mutant in planting.dropped}
        (self.folder / "refused.json").write_text(json.dumps(sorted(refused)))
        return planting, [mutant for mutant in mutants if mutant.key in refused and mutant.operator == "written"]

    def linked(self):
        """The programs of the build, linked with the planted rooms: from where they are to where the planted one is."""
        told = subprocess.run(["ninja", "-C", self.build, "-t", "targets", "all"], capture_output=True, text=True, check=True).stdout
        found = re.findall(r"^([^/\s]\S*): CXX_EXECUTABLE_LINKER", told, re.M)
        targets = [target for target in found if not target.endswith(".cmake")]
        programs = {}
        planted = rf"^libstretch_({'|'.join(self.rooms)})\.a$"
        # The clips that come with the program lie where its programs look for them, two folders above the tests'.
        bundled = self.folder / "assets"
        if not bundled.exists():
            bundled.symlink_to(self.root / "assets")

        def link(target):
            command = subprocess.run(["ninja", "-C", self.build, "-t", "commands", "-s", target], capture_output=True, text=True, check=True).stdout
            words = next(part for part in command.strip().split("\n")[-1].split(" && ") if " -o " in part).split()
            out = self.folder / "programs" / target
            out.parent.mkdir(parents=True, exist_ok=True)
            if not (self.build / target).exists() or not any(re.match(planted, word) for word in words):
                return
            words[words.index("-o") + 1] = str(out)
            words = [re.sub(planted, rf"{self.folder}/libraries/libstretch_\1.a", word) for word in words]
            inputs = [self.build / word for word in words if word.endswith((".a", ".o"))]
            note = out.with_suffix(".command")
            same = note.exists() and note.read_text() == " ".join(words)
            if not same or not out.exists() or any(path.exists() and path.stat().st_mtime > out.stat().st_mtime for path in inputs):
                subprocess.run(" ".join(words), shell=True, cwd=self.build, check=True)
                note.write_text(" ".join(words))
            programs[os.path.realpath(self.build / target)] = out

        with ThreadPoolExecutor(self.asked.jobs) as pool:
            list(pool.map(link, targets))
        return programs

    # What the tests pass.

    def traces(self, programs):
        """The tests with what each passes; kept between runs as long as programs and planted rooms are the same."""
        stamp = hashlib.sha256()
        for room in self.rooms:
            stamp.update((self.folder / f"libraries/libstretch_{room}.a").read_bytes())
        rooms = stamp.hexdigest()
        known = read_json(self.folder / "traces.json", {})
        cases = trials.cases_of(self.build, programs, self.asked.windows)
        if self.asked.tests:
            cases = [case for case in cases if set(case.labels) & set(self.asked.tests)]
        marks = {}

        def mark(case):
            if self.asked.reuse:
                return rooms
            for word in case.command:
                if word not in marks and word.startswith(str(self.folder)):
                    marks[word] = hashlib.sha256(pathlib.Path(word).read_bytes()).hexdigest()
            return rooms + "".join(marks.get(word, "") for word in case.command)

        fresh = [
            case for case in cases
            if case.name not in known or not (known[case.name]["mark"] == mark(case) or (self.asked.reuse and known[case.name]["mark"].startswith(rooms)))
        ]
        if fresh:
            print(f"tracing {len(fresh)} of {len(cases)} tests", flush=True)
            # In parts, so that a run that is stopped keeps what it has.
            for first in range(0, len(fresh), 100):
                for case in trials.traced(fresh[first : first + 100], self.folder / "notes", self.asked.jobs):
                    known[case.name] = {"mark": mark(case), "seconds": case.seconds, "passes": sorted(case.passes)}
                (self.folder / "traces.json").write_text(json.dumps(known))
        ready = []
        for case in cases:
            trace = known.get(case.name)
            if trace and trace["mark"].startswith(rooms):
                case.seconds, case.passes = trace["seconds"], frozenset(trace["passes"])
                ready.append(case)
        left = sorted({case.name for case in cases} - {case.name for case in ready})
        if left:
            print(f"left out, as they do not pass without a mutant: {len(left)}: {'; '.join(left[:8])}", flush=True)
        return ready

    # The trial.

    def chosen(self, mutants):
        """As many of each room's drawn ones as asked for, and the written ones."""
        counts, picked = {}, []
        limit = self.asked.drawn // len(ROOMS) if self.asked.first is None else self.asked.first
        for mutant in mutants:
            if mutant.operator == "written":
                if not self.asked.drawn_only:
                    picked.append(mutant)
                continue
            counts[mutant.room] = counts.get(mutant.room, 0) + 1
            if counts[mutant.room] <= limit and not self.asked.written_only:
                picked.append(mutant)
        return picked

    def trial(self, mutants, cases):
        results = read_json(self.folder / "results.json", {})
        waiting = [one for one in mutants if one.key not in self.equivalent]
        if self.asked.living:
            waiting = [one for one in waiting if results.get(str(one.number), ["alive"])[0] != "killed"]
        began = time.monotonic()
        telling = threading.Lock()  # Trials end side by side, and write one file.

        def attempt(mutant):
            outcome = trials.tried(mutant, cases, self.asked.budget)
            with telling:
                results[str(mutant.number)] = list(outcome)
                print(f"{time.monotonic() - began:6.0f} s  {mutant.number:4} {outcome[0]:12} {mutant.file}: {mutant.operator}", flush=True)
                (self.folder / "results.json").write_text(json.dumps(results))

        with ThreadPoolExecutor(self.asked.jobs) as pool:
            list(pool.map(attempt, waiting))
        return {one.number: tuple(results.get(str(one.number), ["untried", ""])) for one in mutants}

    def plan(self, mutants, programs):
        """Writes what another machine needs to know to try the same: the mutants that count, and the programs."""
        told = [{"number": one.number, "room": one.room, "place": self.tree.source(one.file).line_of(one.begin) + 1, **one.as_data()}
                for one in mutants if one.key not in self.equivalent]
        data = {"mutants": told, "programs": {pathlib.Path(name).name: str(path) for name, path in programs.items()}}
        (self.folder / "plan.json").write_text(json.dumps(data, indent=1))

    def run(self):
        mutants = self.mutants()
        for mutant in self.gone:
            print(f"{mutant.file}: no line \"{mutant.line}\": {mutant.says}")
        if self.asked.check:
            return 1 if len(self.gone) > GONE_AT_MOST * len(read_mutants(HERE / "written.jsonl")) else 0
        planting, refused = self.planted(mutants)
        print(f"{len(planting.mutants)} mutants stand, {len(planting.dropped)} do not compile", flush=True)
        programs = self.linked()
        standing = self.chosen(planting.mutants)
        if self.asked.build_only:
            self.plan(standing, programs)
            return 0
        cases = self.traces(programs)
        results = self.trial(standing, cases)
        return table.told(standing, results, self.equivalent, refused)


if __name__ == "__main__":
    sys.exit(Measure(options()).run())
