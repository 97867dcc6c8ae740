#!/usr/bin/env python3
"""every_verb.py PROGRAM RUNS|FIRST:END [FILE...]: glTF files (without files, the bundled clips), each damaged anywhere, in values of its text or in numbers of its
data, each through one verb, by `batch`. A command answers 0, or 1 and one line, within memory and time; nothing else may come of a damaged file."""
import json
import os
import pathlib
import random
import resource
import shlex
import subprocess
import sys
import tempfile

from damage import damaged, numbers_of_data, numbers_of_text

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = 40
SECONDS = 300
MEMORY = 3 << 30
RECIPES = ROOT / "docs/recipes"
# Verbs and how often one is drawn: what takes long is drawn less.
VERBS = {
    "info FILE --json": 3, "info FILE": 2, "check FILE": 4, "check FILE --engine all": 1, "resave FILE -o OUT": 4, "resave FILE -o OUT": 1, "moments FILE --json": 3, "moments FILE --all-clips": 1,
    "trail FILE --limb left-arm": 3, "trail FILE --limb right-leg --range 2:9": 1, "exaggerate FILE -o OUT --limb left-arm --scale 2": 3,
    "exaggerate FILE -o OUT --limb right-leg --scale 1.5 --axes yz": 2, f"exaggerate FILE -o OUT --recipe {RECIPES}/refined-punch.json": 2, "exaggerate FILE -o OUT --auto": 1,
    "exaggerate FILE -o OUT --limb neck --scale 2 --form translation": 1, f"pose FILE -o OUT --recipe {RECIPES}/low-guard.json": 3, f"pose {ROOT}/assets/dummy.glb -o OUT --prop FILE": 1,
    "elastic FILE -o OUT": 1, f"import-clip {ROOT}/assets/dummy.glb -o OUT --from FILE": 2, f"import-clip FILE -o OUT --from {ROOT}/assets/dummy_swing.glb": 2, "styles --take FILE -o OUT": 1,
    "bind FILE -o OUT --keep-joints": 1, "bind FILE -o OUT": 1, "rig FILE -o OUT --locators-only": 1, f"compare FILE {ROOT}/assets/dummy.glb": 1, "compare FILE FILE": 1,
    "compress FILE -o OUT --bones 4": 1, "render FILE -o OUT --size 96x54": 1,
}
TAKES_ALL = {"check", "compress", "compare"}  # without an option for files that break the specification
ENDINGS = {"rig": ".json", "styles": ".json", "render": ".png"}


def command_of(rng, file):
    words = rng.choices(list(VERBS), VERBS.values())[0]
    if rng.randrange(2) and words.split()[0] not in TAKES_ALL:
        words += " --tolerant"
    return words.replace("OUT", f"{file}.out" + ENDINGS.get(words.split()[0], ".glb")).replace("FILE", shlex.quote(str(file)))


def damage(content, rng):
    """Mostly one that leaves the file to be read, which leads further."""
    if not content.startswith(b"glTF") or rng.randrange(6) == 0:
        return damaged(content, rng)
    return numbers_of_data(content, rng) if rng.randrange(2) else numbers_of_text(content, rng)


def answers_of(program, commands, seconds):
    """What each command of a list answered, by its line; those without an answer had none within the seconds."""
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as listed, tempfile.TemporaryFile() as answers:
        listed.write("\n".join(commands) + "\n")
        listed.flush()
        child = subprocess.Popen([program, "batch", listed.name, "--json-lines"], stdout=answers, stderr=subprocess.DEVNULL, start_new_session=True,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY)))
        try:
            child.wait(seconds)
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, 9)
            child.wait()
        answers.seek(0)
        return {answer["line"]: answer for answer in map(json.loads, answers.read().splitlines())}


def problem_of(answer):
    if answer is None:
        return "no answer"
    if answer["exit"] == 0:
        return ""
    told = answer.get("error", "").strip()
    if answer["exit"] != 1 or not told or "\n" in told:
        return f"exit code {answer['exit']}: {told[-300:]}"
    return ""


def block_failures(program, folder, runs, contents):
    commands = {}
    for line, run in enumerate(runs, 1):
        rng = random.Random(run)
        file, content = contents[run % len(contents)]
        path = folder / f"{run}{file.suffix}"
        path.write_bytes(damage(content, rng))
        commands[line] = (run, file.name, command_of(rng, path))
    answers = answers_of(program, [command for _, _, command in commands.values()], SECONDS)
    late = [line for line in commands if line not in answers]
    for line in late:  # a command that was cut off by one before it is no finding
        answers.update({line: answer for answer in answers_of(program, [commands[line][2]], SECONDS // 5).values()})
    counts = [answers[line]["exit"] if line in answers else None for line in commands]
    failures = [f"run {run}, {name}: {command}: {problem_of(answers.get(line))}" for line, (run, name, command) in commands.items() if problem_of(answers.get(line))]
    for made in folder.iterdir():
        made.unlink()
    return failures, counts


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    bounds = [int(word) for word in sys.argv[2].split(":")]
    first, end = bounds if len(bounds) == 2 else (0, bounds[0])
    files = [pathlib.Path(name) for name in sys.argv[3:]] or sorted((ROOT / "assets").glob("*.glb"))
    contents = [(file, file.read_bytes()) for file in files]
    failed, read, refused = [], 0, 0
    with tempfile.TemporaryDirectory() as place:
        for begin in range(first, end, BLOCK):
            failures, counts = block_failures(program, pathlib.Path(place), range(begin, min(begin + BLOCK, end)), contents)
            failed += failures
            read += counts.count(0)
            refused += counts.count(1)
            for failure in failures:
                print("FAILED:", failure, flush=True)
            if begin // BLOCK % 25 == 24:
                print(f"up to {begin + BLOCK}: {read} read, {refused} refused", flush=True)
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss >> 10
    print(f"{end - first} damaged files: {read} read, {refused} refused in one line; at most {peak} MB; {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
