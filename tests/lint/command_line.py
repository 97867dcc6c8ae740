#!/usr/bin/env python3
"""Holds the documentation against the built program.

    command_line.py PROGRAM ROOT          every verb has help with an example; examples name only verbs and options that exist;
                                          the version names the build
    command_line.py PROGRAM ROOT --run    runs every example of the README and of the page about the command line, in order, in a
                                          folder of its own
"""

import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

OPTION = re.compile(r"^\s+(?:-\w,)?(--[a-z][\w-]*)")
EXAMPLE = re.compile(r"^(?:\$ )?(?:\./run|(?:\S*/)?stretch-engine)\s+(.+)$")
SECONDS_AT_MOST = 240
TYPED_PAGES = ("README.md", "docs/command-line.md")  # What a reader types from top to bottom.


def output_of(program, *arguments, folder=None):
    done = subprocess.run(
        [program, *arguments], capture_output=True, text=True, timeout=SECONDS_AT_MOST, cwd=folder, check=False
    )
    return done.returncode, done.stdout, done.stderr


def verbs_of(program):
    """Names of the verbs as the program's own help lists them."""
    status, text, _ = output_of(program, "--help")
    if status != 0 or "Subcommands:" not in text:
        return []
    listed = text.split("Subcommands:", 1)[1]
    return re.findall(r"^  ([a-z][\w-]*)", listed, re.MULTILINE)


def examples_of(text):
    """The arguments of every example command that stands in a code block."""
    joined = re.sub(r"\\\n\s*", " ", text)
    examples, fenced = [], False
    for line in joined.splitlines():
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif fenced or line.startswith("    "):
            match = EXAMPLE.match(line.strip())
            if match:
                examples.append(shlex.split(match.group(1), comments=True))
    return [words for words in examples if words]


def problem_with(example, options):
    """Why an example cannot work, or nothing. An example that starts with a file opens the editor."""
    verb = example[0]
    if verb not in options:
        return "" if re.search(r"\.(glb|gltf|vrm)$|^FILE", verb) else f"there is no verb {verb}"
    unknown = [word for word in example if word.startswith("--") and word.split("=")[0] not in options[verb]]
    return f"{verb} has no {' '.join(unknown)}" if unknown else ""


def check_help(program, verbs):
    """Options of each verb by its help, and what is wrong with the help."""
    options, problems = {}, []
    for verb in verbs:
        status, text, _ = output_of(program, verb, "--help")
        options[verb] = {match.group(1) for match in map(OPTION.match, text.splitlines()) if match}
        if status != 0 or "Usage:" not in text or "--help" not in options[verb]:
            problems.append(f"{verb} --help: exit {status}, no help on standard output")
        undescribed = re.findall(r"^\s+(?:-\w,)?--[\w-]+ *$(?!\n {20})", text, re.MULTILINE)
        problems += [f"{verb}: {option.strip()} says nothing about itself" for option in undescribed]
    return options, problems


def check_help_examples(program, options):
    """Each verb's help ends with an example of it that can work."""
    problems = []
    for verb in options:
        _, text, _ = output_of(program, verb, "--help")
        _, _, shown = text.partition("\nExample")
        examples = [shlex.split(m.group(1)) for m in map(EXAMPLE.match, map(str.strip, shown.splitlines())) if m]
        if not any(example[0] == verb for example in examples):
            problems.append(f"{verb} --help: shows no example")
        for example in examples:
            problem = problem_with(example, options)
            problems += [f"{verb} --help: {' '.join(example)}: {problem}"] if problem else []
    return problems


def check_version(program, root):
    """The version is the project's, and says of what commit and by which compiler."""
    declared = re.search(r"VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text(encoding="utf-8").split("project(")[1])
    _, text, _ = output_of(program, "--version")
    if not re.fullmatch(rf"stretch-engine {re.escape(declared.group(1))} \(.*\w+ [\d.]+, \w+\)\n", text):
        return [f"--version: {text.strip()} does not name the build of {declared.group(1)}"]
    return []


def check_examples(root, options):
    problems = []
    documents = [root / "README.md", *sorted((root / "docs").glob("*.md"))]
    for document in documents:
        for example in examples_of(document.read_text(encoding="utf-8")):
            problem = problem_with(example, options)
            if problem:
                problems.append(f"{document.relative_to(root)}: {' '.join(example)}: {problem}")
    return problems


def run_examples(program, root, verbs):
    """Runs the examples of each page one after another, as a reader would who types them all."""
    problems = []
    for page in TYPED_PAGES:
        examples = [e for e in examples_of((root / page).read_text(encoding="utf-8")) if e[0] in verbs]
        problems += [] if examples else [f"{page}: holds no example"]
        with tempfile.TemporaryDirectory() as folder:
            for name in ("assets", "docs"):
                pathlib.Path(folder, name).symlink_to(root / name, target_is_directory=True)
            for example in examples:
                status, _, message = output_of(program, *example, folder=folder)
                if status != 0:
                    problems.append(f"{page}: {' '.join(example)}: exit {status}: {message.strip()}")
    return problems


def main(arguments):
    if len(arguments) not in (2, 3) or arguments[2:] not in ([], ["--run"]):
        print(__doc__, file=sys.stderr)
        return 2
    program, root = (pathlib.Path(path).resolve() for path in arguments[:2])
    verbs = verbs_of(program)
    if not verbs:
        print("--help lists no verbs")
        return 1
    if len(arguments) == 3:
        problems = run_examples(program, root, verbs)
    else:
        options, problems = check_help(program, verbs)
        problems += check_help_examples(program, options) + check_version(program, root)
        problems += check_examples(root, options)
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
