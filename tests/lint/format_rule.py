"""Whether every C++ file is as clang-format leaves it. The rule is skipped where clang-format is not installed.

Files that were clean are remembered in the build folder, where there is one, by what they, the style and the program were."""

import hashlib
import json
import pathlib
import shutil
import subprocess

from findings import Finding
from sources import code_files

FILES_A_RUN = 40


class Unavailable(Exception):
    """The rule cannot be checked on this machine."""


def formatting(root):
    """C++ files that clang-format would change."""
    program = shutil.which("clang-format")
    if program is None:
        raise Unavailable("clang-format is not installed")
    version = subprocess.run([program, "--version"], capture_output=True, check=False).stdout
    root = pathlib.Path(root)
    style = root / ".clang-format"
    rules = style.read_bytes() if style.exists() else b""
    marks = {file: mark(version, rules, file.path.read_bytes()) for file in code_files(root)}
    memory = root / "build/formatted.json"
    known = json.loads(memory.read_text(encoding="utf-8")) if memory.exists() else {}
    files = [file for file, now in marks.items() if known.get(file.name) != now]
    findings = []
    for first in range(0, len(files), FILES_A_RUN):
        findings += unformatted(program, files[first : first + FILES_A_RUN])
    if memory.parent.is_dir() and all(finding.line for finding in findings):
        unclean = {finding.file for finding in findings}
        clean = {file.name: now for file, now in marks.items() if file.name not in unclean}
        whole = memory.with_suffix(".new")  # A run that is stopped leaves no half of it.
        whole.write_text(json.dumps(clean), encoding="utf-8")
        whole.replace(memory)
    return findings


def mark(*parts):
    return hashlib.sha256(b"".join(hashlib.sha256(part).digest() for part in parts)).hexdigest()


def unformatted(program, files):
    paths = {str(file.path): file for file in files}
    done = subprocess.run(
        [program, "--style=file", "--dry-run", *paths], capture_output=True, text=True, check=False
    )
    lines = {}
    for text in done.stderr.splitlines():
        path, _, rest = text.partition(":")
        if path in paths and "[-Wclang-format-violations]" in rest:
            lines.setdefault(path, int(rest.split(":", 1)[0]))
    if done.returncode != 0:
        return [Finding(files[0].name, 0, f"clang-format failed: {done.stderr.strip()[:200]}")]
    return [Finding(paths[path].name, line, "run clang-format -i on it") for path, line in lines.items()]
