"""The project's text files, as the rules of the lint read them."""

import pathlib
import re
from dataclasses import dataclass

ROOMS = ("core", "rig", "skinning", "app", "ui")
FOLDERS = (*ROOMS, "assets", "tests", "third_party", "docs", ".ci")
CODE = {".cpp", ".h"}
TEXT = CODE | {".py", ".mjs", ".cmake", ".sh", ".md", ".frag", ".vert", ".geom", ".glsl"}
NO_SUFFIX = {"run", "test"}
SKIPPED_FOLDERS = {"node_modules", "__pycache__"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


@dataclass(frozen=True)
class Include:
    line: int
    quoted: bool
    target: str


@dataclass(frozen=True)
class SourceFile:
    """A file and its path from the root, with '/' between its parts."""

    path: pathlib.Path
    name: str

    @property
    def room(self):
        """The first folder of the path; empty for a file that stands in the root."""
        return self.name.split("/", 1)[0] if "/" in self.name else ""

    @property
    def suffix(self):
        return self.path.suffix

    def lines(self):
        return self.path.read_text(encoding="utf-8").splitlines()

    def includes(self):
        """Every #include line of a C++ file."""
        found = []
        for number, text in enumerate(self.lines(), start=1):
            match = INCLUDE.match(text)
            if match:
                found.append(Include(number, match.group(1) == '"', match.group(2)))
        return found


def is_text(path):
    return path.suffix in TEXT or path.name in NO_SUFFIX or path.name == "CMakeLists.txt"


def text_files(root):
    """The project's own text files below `root`, sorted; builds and downloaded packages are left out."""
    root = pathlib.Path(root)
    candidates = [path for path in root.iterdir() if path.is_file()]
    for folder in FOLDERS:
        candidates += (root / folder).rglob("*")
    files = []
    for path in candidates:
        parts = path.relative_to(root).parts
        if is_text(path) and path.is_file() and not SKIPPED_FOLDERS.intersection(parts):
            files.append(SourceFile(path, "/".join(parts)))
    return sorted(files, key=lambda file: file.name)


def code_files(root):
    return [file for file in text_files(root) if file.suffix in CODE]
