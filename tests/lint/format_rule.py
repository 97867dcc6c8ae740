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
    marks = {file.name: mark(version, style.read_bytes() if style.exists() else b"", file.path.read_bytes()) for file in code_files(root)}
    memory = root / "build/formatted.json"
    known = json.loads(memory.read_text(encoding="utf-8")) if memory.exists() else {}
    files = [file for file in code_files(root) if known.get(file.name) != marks[file.name]]
    findings = []
    for first in range(0, len(files), FILES_A_RUN):
        findings += unformatted(program, files[first : first + FILES_A_RUN])
    if memory.parent.is_dir() and all(finding.line for finding in findings):
        unclean = {finding.file for finding in findings}
        memory.write_text(json.dumps({name: one for name, one in marks.items() if name not in unclean}), encoding="utf-8")
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
