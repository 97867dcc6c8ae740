"""Runs tests over mutants: which test passes which mutant's place, and which mutants a test turns red."""

import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import time

MEMORY = 6 << 30


@dataclasses.dataclass
class Case:
    """A test: its name, its command, and what it took and passed when nothing was wrong."""

    name: str
    command: list
    folder: str
    labels: list
    seconds: float = 0.0
    passes: frozenset = frozenset()

    @property
    def is_catch(self):
        return pathlib.Path(self.command[0]).name.startswith("test_") and len(self.command) == 2


def cases_of(build, programs, windows):
    """Every test that CTest knows, with the planted programs in the place of its own."""
    told = subprocess.run(["ctest", "--test-dir", str(build), "--show-only=json-v1"], capture_output=True, text=True, check=True).stdout
    cases = []
    for test in json.loads(told)["tests"]:
        properties = {one["name"]: one["value"] for one in test["properties"]}
        labels = properties.get("LABELS", [])
        command = [str(programs.get(os.path.realpath(word), word)) for word in test.get("command", [])]
        ours = any(os.path.realpath(word) in programs for word in test.get("command", []))
        if ours and "lint" not in labels and (windows or "slow" not in labels):
            cases.append(Case(test["name"], command, properties.get("WORKING_DIRECTORY", str(build)), labels))
    return cases


def run(command, folder, environment, seconds):
    """The exit status, 0 for what passed, and the seconds it took. What hangs, crashes or eats memory has not passed."""
    began = time.monotonic()
    process = subprocess.Popen(
        command, cwd=folder, env={**os.environ, **environment}, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL, start_new_session=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY)),
    )
    try:
        status = process.wait(timeout=seconds)
    except subprocess.TimeoutExpired:
        status = -1
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()
    return status, time.monotonic() - began


def traced(cases, folder, jobs):
    """The cases that pass without a mutant, with what they took and passed; those that did not are left out."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)

    def trace(numbered):
        number, case = numbered
        note = folder / str(number)
        note.unlink(missing_ok=True)
        status, seconds = run(case.command, case.folder, {"MUTANT": "-1", "MUTANT_TRACE": str(note)}, 900)
        passes = frozenset(int(line) for line in note.read_text().split()) if note.exists() else frozenset()
        note.unlink(missing_ok=True)
        return dataclasses.replace(case, seconds=seconds, passes=passes) if status == 0 else None

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return [case for case in pool.map(trace, enumerate(cases)) if case]


def batches(mutant, cases, batch=8):
    """The tests that pass a mutant's place, its own room's and the quick ones first; cases of one program share a process."""
    near = [case for case in cases if mutant.number in case.passes]
    near.sort(key=lambda case: (mutant.room not in case.labels, case.seconds * (1 + len(case.passes) / 20)))
    waiting = []
    for case in near:
        same = waiting and waiting[-1][0].is_catch and case.is_catch and waiting[-1][0].command[0] == case.command[0]
        # The first few run alone: most mutants die there.
        if same and sum(len(one) for one in waiting) > 3 and len(waiting[-1]) < batch and sum(one.seconds for one in waiting[-1]) < 4:
            waiting[-1].append(case)
        else:
            waiting.append([case])
    return waiting


def tried(mutant, cases, budget):
    """("killed", by whom), ("unreached", ""), ("alive", "") or ("alive so far", tests left) when the budget of seconds is spent."""
    groups = batches(mutant, cases)
    if not groups:
        return "unreached", ""
    began = time.monotonic()
    for number, group in enumerate(groups):
        if time.monotonic() - began > budget:
            return "alive so far", f"{sum(len(one) for one in groups[number:])} tests left"
        command = group[0].command
        if len(group) > 1:
            command = [command[0], ",".join(f'{case.command[1]}' for case in group), "--abort"]
        limit = 20 + 12 * sum(case.seconds for case in group)
        status, _ = run(command, group[0].folder, {"MUTANT": str(mutant.number)}, limit)
        if status != 0:
            return "killed", group[0].name if len(group) == 1 else f"one of {len(group)} from: {group[0].name}"
    return "alive", f"{sum(len(one) for one in groups)} tests pass it"
