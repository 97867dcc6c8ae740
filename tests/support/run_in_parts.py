#!/usr/bin/env python3
"""Runs the cases of test programs some dozens to a process, where a case takes less time than its process takes to begin.

    run_in_parts.py PROGRAM... [--except FILE] [--jobs N] [--cases N] [--seconds S]

Left out are the cases that are marked [slow], and those that stand in FILE as CTest names them, ROOM:CASE. A part that fails, or that is not
done after S seconds, is run again case by case, so that the case is named; what the part said is told before. A case that says "nothing ran"
is counted as skipped. The last line holds the counts.
Exit 0: all passed, 1: one failed, or there was none to run, 75: none failed, but one took longer than S seconds.
"""

import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass

TIME_IS_UP = 75
# A sanitizer that is told to go on tells of its finding in words alone.
FINDING = re.compile(r"runtime error: |ERROR: \w+Sanitizer")
SIGN = re.compile(r'[\\,"\[\]]')  # of the program's own patterns
NOTHING_RAN = re.compile(r"^ *nothing ran: ", re.MULTILINE)
CASES_RUN = re.compile(r"^(?:All tests passed \(.* in|test cases: +)\s*(\d+)", re.MULTILINE)


@dataclass(frozen=True)
class Outcome:
    passed: bool
    in_time: bool
    output: str


@dataclass
class Told:
    """Names of cases, and how many had nothing to run on."""

    failed: list
    late: list
    skipped: int


def cases_of(program, left_out):
    """The names of the cases that are not slow and not left out, in the program's order."""
    listed = subprocess.run([program, "--list-test-names-only", "~[slow]"], capture_output=True, text=True, check=False)
    room = program.name.removeprefix("test_")
    return [name for name in listed.stdout.split("\n") if name and f"{room}:{name}" not in left_out]


def parts_of(program, left_out, at_most):
    """Cases of one file stand together and take alike long: each part has some of every file."""
    cases = cases_of(program, left_out)
    count = -(-len(cases) // at_most)
    return [(program, cases[first::count]) for first in range(count)]


def run(program, names, seconds):
    with tempfile.NamedTemporaryFile("w", prefix="cases-", suffix=".txt", encoding="utf-8") as listing:
        listing.write("".join(SIGN.sub(r"\\\g<0>", name) + "\n" for name in names))
        listing.flush()
        try:
            done = subprocess.run(
                [program, "--input-file", listing.name],
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                errors="replace",
                timeout=seconds,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return Outcome(False, False, "")
    # A name that the program does not know again is no failure to it.
    counted = CASES_RUN.search(done.stdout)
    whole = counted is not None and int(counted.group(1)) == len(names)
    return Outcome(done.returncode == 0 and whole and not FINDING.search(done.stdout), True, done.stdout)


def told_of(program, part, seconds):
    """What a part says that fails is told at once: its cases, which run again one by one, can be cut off."""
    outcome = run(program, part, seconds)
    skipped = len(NOTHING_RAN.findall(outcome.output))
    if outcome.passed:
        return Told([], [], skipped)
    print(f"a part of {len(part)} cases did not pass", outcome.output, sep="\n", flush=True)
    alone = [(name, run(program, [name], seconds)) for name in part]
    failed = [name for name, each in alone if not each.passed and each.in_time]
    late = [name for name, each in alone if not each.in_time]
    if not failed and not late and outcome.in_time:
        failed = ["cases that pass each by itself"]
    for name in failed:
        print(f"failed: {name}", flush=True)
    for name in late:
        print(f"too long: {name}", flush=True)
    return Told(failed, late, sum(len(NOTHING_RAN.findall(each.output)) for _, each in alone))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, nargs="+", metavar="PROGRAM")
    parser.add_argument("--except", type=pathlib.Path, dest="left_out", metavar="FILE")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--cases", type=int, default=40, help="how many share a process")
    parser.add_argument("--seconds", type=float, default=600, help="for each process")
    options = parser.parse_args()
    left_out = set(options.left_out.read_text(encoding="utf-8").split("\n")) if options.left_out else set()
    of_programs = [parts_of(program.resolve(), left_out, options.cases) for program in options.programs]
    parts = [part for each in of_programs for part in each]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        told = list(pool.map(lambda part: told_of(*part, options.seconds), parts))
    failed, late, skipped = (sum(counts) for counts in zip((0, 0, 0), *((len(each.failed), len(each.late), each.skipped) for each in told)))
    passed = sum(len(cases) for _, cases in parts) - failed - late - skipped
    print(f"{passed} passed, {failed} failed, {skipped} skipped, {late} took too long")
    if failed or not all(of_programs):
        return 1
    return TIME_IS_UP if late else 0


if __name__ == "__main__":
    sys.exit(main())
