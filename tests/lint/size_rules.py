"""Rules about how large things are: folders, the product, the pages at the front; and whether the map shows every room."""

import collections
import pathlib
import re

from allowances import allowed, at_most
from findings import Finding
from sources import ROOMS, code_files, text_files

FILES_AT_MOST = 40
README_WORDS_AT_MOST = 600
MAP = "ARCHITECTURE.md"
MAP_WORDS_AT_MOST = 1600
# The first cell of a row of the map: a folder, then others beside it by their last names.
MAP_ROW = re.compile(r"^\| (`[^|]*`) \|", re.MULTILINE)
NAMED = re.compile(r"`([\w/]+)`")
CODE = {".cpp", ".h", ".py", ".mjs", ".frag", ".vert", ".geom", ".glsl"}
PRODUCT = re.compile(r"^\*\*At most ([\d,]+) lines\*\*", re.MULTILINE)
SIZE_PAGE = "docs/size.md"
# What a reader of a page does not read as a word: where a link leads, a picture's file, the marks of a table.
TARGET = re.compile(r"\]\([^)]*\)|<[^>]*>")
WORD = re.compile(r"[\w./'-]*\w[\w./'-]*")


def folder_size(root):
    """Folders with more files of code than a reader finds his way in. Scripts, pictures and data are no code."""
    exceptions = allowed(root, "folder-size")
    counts = collections.Counter(file.name.rpartition("/")[0] for file in text_files(root) if file.suffix in CODE)
    return [
        Finding(folder, 0, f"{count} files of code; at most {limit}: give its subjects folders")
        for folder, count in sorted(counts.items())
        if count > (limit := at_most(exceptions, folder, FILES_AT_MOST))
    ]


def product_lines(root):
    """More lines in the rooms of the product than docs/size.md allows."""
    page = pathlib.Path(root, SIZE_PAGE)
    said = PRODUCT.search(page.read_text(encoding="utf-8")) if page.is_file() else None
    if said is None:
        return [Finding(SIZE_PAGE, 0, "says no figure: '**At most N lines**'")]
    figure = int(said.group(1).replace(",", ""))
    count = sum(len(file.lines()) for file in code_files(root) if file.room in ROOMS)
    if count <= figure:
        return []
    return [Finding(SIZE_PAGE, 0, f"the product has {count:,} lines, {count - figure:,} more than it allows: cut, or say there why it grew")]


def words_of(text):
    return WORD.findall(TARGET.sub("]", text))


def readme_words(root):
    """A front page that nobody reads to its end."""
    count = len(words_of(pathlib.Path(root, "README.md").read_text(encoding="utf-8")))
    if count <= README_WORDS_AT_MOST:
        return []
    return [Finding("README.md", 0, f"{count} words; at most {README_WORDS_AT_MOST}: what is told belongs to docs/")]


def rooms_on(text):
    """Every folder that the map names."""
    rooms = set()
    for cell in MAP_ROW.findall(text):
        first, *beside = [name.rstrip("/") for name in NAMED.findall(cell)]
        parent = first.rpartition("/")[0]
        rooms.add(first)
        rooms.update(f"{parent}/{name}" if parent else name for name in beside)
    return rooms


def rooms_named(root):
    """Folders of the product that the map does not show, rooms that it shows and that are gone, a map of more than two pages."""
    text = pathlib.Path(root, MAP).read_text(encoding="utf-8")
    named = rooms_on(text)
    folders = {file.name.rpartition("/")[0] for file in code_files(root) if file.room in ROOMS}
    findings = [Finding(MAP, 0, f"does not say what {folder} holds") for folder in sorted(folders - named)]
    gone = sorted(name for name in named if not pathlib.Path(root, name).is_dir())
    findings += [Finding(MAP, 0, f"names {name}, which is gone") for name in gone]
    count = len(words_of(text))
    if count > MAP_WORDS_AT_MOST:
        findings.append(Finding(MAP, 0, f"{count} words; at most {MAP_WORDS_AT_MOST}"))
    return findings
