"""Whether every C++ file is as clang-format leaves it. The rule is skipped where clang-format is not installed."""

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
    files = code_files(root)
    findings = []
    for first in range(0, len(files), FILES_A_RUN):
        findings += unformatted(program, files[first : first + FILES_A_RUN])
    return findings


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
