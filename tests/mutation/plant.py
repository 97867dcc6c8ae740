"""Plants every mutant at once in a copy of the tree, behind a switch; what does not compile is taken out."""

import os
import pathlib
import re
import shutil
import subprocess

from mutants import DECLARATION
from operators import flat
from source_text import masked

ERROR = re.compile(r"^(?P<file>[^\s:]+\.(?:cpp|h)):(?P<line>\d+):\d+: (?:fatal )?error: ", re.M)
MENTION = re.compile(r"(?:^|from )(?P<file>[^\s:]+\.cpp):(?P<line>\d+)[:,]", re.M)


def one_line(text):
    """Code without comments, on one line: the lines behind it keep their numbers."""
    kept = "".join(" " if blank.isspace() else character for character, blank in zip(text, masked(text)))
    return " ".join(kept.split("\n"))


def region_of(source, mutant):
    """What is written twice for a mutant: (begin, end, whether it is a statement). None where it cannot be planted."""
    if mutant.text == "" and mutant.becomes == "":
        if DECLARATION.match(source.code[mutant.begin : mutant.end]):
            return None
        return mutant.begin, mutant.end, True
    span = source.expression(mutant.begin, mutant.end)
    return (*span, False) if span and source.code[span[0] : span[1]].strip() else None


def grown(source, regions):
    """Groups of mutants whose regions lie in one another, each as (begin, end, statement, mutants); and those that clash."""
    groups, clashing = [], []
    for begin, end, statement, mutant in sorted(regions, key=lambda one: (one[0], -one[1], not one[2])):
        last = groups[-1] if groups else None
        if last and begin < last[1]:
            if end <= last[1]:
                last[3].append(mutant)
            else:
                clashing.append(mutant)
        else:
            groups.append([begin, end, statement, [mutant]])
    return groups, clashing


def planted(source, mutants):
    """The text with all mutants in it, the span of lines of each, and the mutants that could not be planted."""
    regions, out = [], []
    for mutant in mutants:
        region = region_of(source, mutant)
        if region:
            regions.append((*region, mutant))
        else:
            out.append(mutant)
    groups, clashing = grown(source, regions)
    text = source.text
    spans = []
    for begin, end, statement, inside in reversed(groups):
        spans.append((source.line_of(begin), source.line_of(end), inside))
        text = text[:begin] + switch(source, begin, end, statement, inside) + text[end:]
    return text, spans, out + clashing


def is_condition(source, begin, end):
    """Whether an expression is true or false, whatever its parts are: a part alone, as an std::optional, must not give the whole its type."""
    code = flat(source, begin, end)
    return "?" not in code and re.search(r"&&|\|\|", code) is not None


def switch(source, begin, end, statement, mutants):
    """A region of code with all of its mutants and itself; the lines of what was there keep their numbers."""
    written = ""
    asks = not statement and is_condition(source, begin, end)
    for mutant in mutants:
        changed = one_line(source.text[begin : mutant.begin] + mutant.text + source.text[mutant.end : end])
        asked = f"::stretch::mutant({mutant.number})"
        written += f"if ({asked}) {{ {changed} }} else " if statement else f"{asked} ? {'bool' if asks else ''}({changed}) : "
    original = source.text[begin:end]
    if statement:
        return f"{written}{{ {original} }}"
    # A comment at the end of the last line would swallow what closes it.
    last = source.code[begin:end].rsplit("\n", 1)[-1]
    ends_in_comment = "//" in original.rsplit("\n", 1)[-1] and "//" not in last
    return f"({written}({one_line(original) if ends_in_comment else original}))"


class Planting:
    """The copied tree, its build and the mutants that stand in it."""

    def __init__(self, tree, folder, header, jobs=2):
        self.tree = tree
        self.folder = pathlib.Path(folder)
        self.copy = self.folder / "tree"
        self.header = pathlib.Path(header)
        self.jobs = jobs
        self.spans = {}
        self.dropped = []
        self.mutants = []

    def plant(self, mutants):
        """Writes the copy; what could not be planted is in dropped."""
        self.mutants = list(mutants)
        names = [str(path.relative_to(self.tree.root)) for room in self.tree.rooms for path in (self.tree.root / room).rglob("*") if path.is_file()]
        for name in names:
            self._put(name)
        for room in self.tree.rooms:
            for path in (self.copy / room).rglob("*"):
                if path.is_file() and not (self.tree.root / path.relative_to(self.copy)).exists():
                    path.unlink()

    def copied_beside(self, *names):
        for name in names:
            for path in [self.tree.root / name] if (self.tree.root / name).is_file() else (self.tree.root / name).rglob("*"):
                if path.is_file():
                    self._put(str(path.relative_to(self.tree.root)))

    def _put(self, name):
        target = self.copy / name
        mine = [mutant for mutant in self.mutants if mutant.file == name]
        if mine:
            text, self.spans[name], out = planted(self.tree.source(name), mine)
            self._drop(out)
            content = text.encode()
        else:
            self.spans.pop(name, None)
            content = (self.tree.root / name).read_bytes()
        if not target.exists() or target.read_bytes() != content:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
            shutil.copymode(self.tree.root / name, target)

    def _drop(self, mutants):
        known = {id(mutant) for mutant in self.dropped}
        gone = {id(mutant): mutant for mutant in mutants if id(mutant) not in known}
        self.dropped += gone.values()
        self.mutants = [mutant for mutant in self.mutants if id(mutant) not in gone]

    def build(self, command, rounds=12):
        """Runs the build until it passes; mutants on lines that err are taken out. Raises where an error is nobody's."""
        for _ in range(rounds):
            run = subprocess.run(command, capture_output=True, text=True)
            if run.returncode == 0:
                return
            files = self._taken_out(run.stdout + run.stderr)
            if not files:
                raise RuntimeError("the planted tree does not build:\n" + (run.stdout + run.stderr)[-6000:])
            for name in files:
                self._put(name)
        raise RuntimeError("the planted tree does not build after taking out what errs")

    def _taken_out(self, output):
        """Drops the mutants of lines that are told; an error further down in a file is the mutant's above it, one that is
        nobody's takes all of its file."""
        files = set()
        for block in re.split(r"(?=^In file included from |^\S+: In )", output, flags=re.M):
            told = {(self._name(match["file"]), int(match["line"]) - 1) for match in ERROR.finditer(block)}
            if not told:
                continue
            places = told | {(self._name(match["file"]), int(match["line"]) - 1) for match in MENTION.finditer(block)}
            exact = self._at(places, 0)
            whole = [(name, span[2]) for name, _ in told for span in self.spans.get(name, [])]
            for name, inside in exact or self._at(told, 40) or whole:
                self._drop(inside)
                files.add(name)
        return files

    def _at(self, places, above):
        found = []
        for name, line in places:
            near = [span for span in self.spans.get(name, []) if span[0] <= line <= span[1] + above]
            if near:
                found.append((name, max(near, key=lambda span: span[0])[2]))
        return found

    def _name(self, path):
        try:
            return str(pathlib.Path(os.path.realpath(path)).relative_to(self.copy.resolve()))
        except ValueError:
            return path
