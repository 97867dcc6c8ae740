"""A mutant: one fault, told by the line's text and what stands in its place, and its span in today's source."""

import dataclasses
import json
import pathlib
import re

from source_text import Source, masked, names_of

ROOMS = ("core", "rig", "skinning", "app", "ui")
DECLARATION = re.compile(r"(?:const|constexpr|static|using|struct|class|enum|namespace|template|typedef|auto|public|private|case|default)\b")


@dataclasses.dataclass
class Mutant:
    """file: from the root; line: its text without the spaces around; becomes: what stands in its place; "": nothing, the whole
    statement is gone; says: the fault in a sentence; nth: which of several lines with that text, from 1."""

    file: str
    line: str
    becomes: str
    says: str = ""
    operator: str = "written"
    nth: int = 1
    begin: int = 0  # The span in the source that changes, found by locate().
    end: int = 0
    text: str = ""  # What it becomes.
    number: int = -1

    @property
    def room(self):
        return self.file.split("/")[0]

    @property
    def key(self):
        """What it is known by when the file moves."""
        return (self.line, self.becomes)

    def as_data(self):
        data = {"file": self.file, "line": self.line, "becomes": self.becomes, "says": self.says}
        if self.nth != 1:
            data["nth"] = self.nth
        if self.operator != "written":
            data["operator"] = self.operator
        return data


def read_mutants(path):
    """Mutants of a file that holds one JSON object a line; empty lines and lines that begin with # are passed."""
    mutants = []
    for line in pathlib.Path(path).read_text(encoding="utf-8").split("\n"):
        if line.strip() and not line.startswith("#"):
            mutants.append(Mutant(**json.loads(line)))
    return mutants


class Tree:
    """Sources of the product, read once."""

    def __init__(self, root, rooms=ROOMS):
        self.root = pathlib.Path(root)
        self.rooms = rooms
        self.sources = {}
        self.names = frozenset(name for file in self.files() for name in names_of(masked(self.text(file))))

    def text(self, file):
        return (self.root / file).read_text(encoding="utf-8")

    def files(self, room=None):
        rooms = [room] if room else self.rooms
        return sorted(
            str(path.relative_to(self.root)) for one in rooms for path in (self.root / one).rglob("*.cpp") if path.name != "main.cpp"
        )

    def source(self, file):
        if file not in self.sources:
            self.sources[file] = Source(self.text(file), self.names)
        return self.sources[file]

    def lines_with(self, file, text):
        return [number for number, line in enumerate(self.source(file).lines()) if line.strip() == text]

    def locate(self, mutant):
        """The mutant with its span in the tree; None where its line's text is gone. A file that moved is searched in its room."""
        candidates = [mutant.file] if (self.root / mutant.file).exists() else []
        for file in candidates + [file for file in self.files(mutant.room) if file != mutant.file]:
            found = self.lines_with(file, mutant.line)
            if len(found) >= mutant.nth:
                return self._spanned(dataclasses.replace(mutant, file=file), found[mutant.nth - 1])
        return None

    def _spanned(self, mutant, line):
        source = self.source(mutant.file)
        begin, end = source.line_span(line)
        if mutant.becomes == "":
            span = source.statement(begin)
            return dataclasses.replace(mutant, begin=begin, end=span[1] if span else end, text="")
        same = 0
        old, new = mutant.line, mutant.becomes
        while same < min(len(old), len(new)) and old[same] == new[same]:
            same += 1
        tail = 0
        while tail < min(len(old), len(new)) - same and old[-1 - tail] == new[-1 - tail]:
            tail += 1
        # A name or a number changes as a whole.
        while same > 0 and re.match(r"\w", old[same - 1]):
            same -= 1
        while tail > 0 and re.match(r"\w", old[len(old) - tail]):
            tail -= 1
        return dataclasses.replace(mutant, begin=begin + same, end=end - tail, text=new[same : len(new) - tail])
