"""Rules about the text of single files."""

import re

from findings import Finding
from sources import code_files, text_files

LINES_AT_MOST = 600
# Spelled apart, so that this file passes its own rule.
OPEN_ENDS = re.compile(r"\b(" + "|".join(["TO" + "DO", "FIX" + "ME", "XX" + "X", "HA" + "CK"]) + r")\b")
MACHINE_PATH = re.compile(r"(?<![\w.])/(home|root|Users|work)/\w")

# "One a bone", "frames a second": a stranger reads it twice.
COUNTED = "bone|joint|limb|trail|key|frame|sample|vertex|triangle|face|node|skin|track|channel|segment|mesh|image|request|room"
DISTRIBUTIVE = re.compile(
    rf"\b[Oo]ne an? ({COUNTED})\b|\b([Ff]rames|[Ss]amples|[Ll]engths|[Mm]etres) a (second|unit)\b|\b([Bb]ytes|[Kk]eys|[Nn]umbers) a (frame|vertex)\b"
)

# What makes two runs differ, refused where motion and files are made.
UNREPEATABLE = re.compile(
    r"\b(std::chrono|system_clock|steady_clock|high_resolution_clock|random_device|std::rand|srand|std::time|gettimeofday)\b"
)
OPTION_NAME = re.compile(r'\bTEST_CASE\(\s*"-')
# A name may go on in the next line.
SPLIT_NAME = re.compile(r'TEST_CASE\(\s*(?:"[^"]*"\s+)*"[^"]*;')
REPEATABLE_ROOMS = ("core", "rig", "skinning")


def file_size(root):
    """Files longer than a reader keeps in mind."""
    findings = []
    for file in text_files(root):
        count = len(file.lines())
        if count > LINES_AT_MOST:
            findings.append(Finding(file.name, 0, f"{count} lines; at most {LINES_AT_MOST}: split it"))
    return findings


def matching_lines(files, pattern, message):
    return [
        Finding(file.name, number, message)
        for file in files
        for number, text in enumerate(file.lines(), start=1)
        if pattern.search(text)
    ]


def open_ends(root):
    """Marks of unfinished work."""
    return matching_lines(text_files(root), OPEN_ENDS, "unfinished: finish it or take it out")


def distributive(root):
    """One of something for each of something else, said with a bare article."""
    files = [file for file in text_files(root) if not file.name.startswith("tests/lint/")]
    return matching_lines(files, DISTRIBUTIVE, "say 'for each ...' or 'per ...'")


def machine_paths(root):
    """Paths that only one machine has."""
    return matching_lines(text_files(root), MACHINE_PATH, "names a folder of one machine")


def pragma_once(root):
    """Headers that can be included twice."""
    return [
        Finding(file.name, 0, "has no #pragma once")
        for file in code_files(root)
        if file.suffix == ".h" and "#pragma once" not in file.lines()
    ]


def test_names(root):
    """Names of tests that CTest takes for two: it asks for each half, finds no test, and passes. And those that the program takes for an option."""
    findings = []
    for file in code_files(root):
        text = file.path.read_text(encoding="utf-8")
        for match in SPLIT_NAME.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            findings.append(Finding(file.name, line, "CTest splits a name at ';': take another sign"))
        for match in OPTION_NAME.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            findings.append(Finding(file.name, line, "a name that begins with '-' is taken for an option: begin with a word"))
    return findings


def clocks_and_chance(root):
    """Clocks and random numbers below the interface, where two runs have to give the same bytes."""
    files = [file for file in code_files(root) if file.room in REPEATABLE_ROOMS]
    return matching_lines(files, UNREPEATABLE, "two runs would differ: take the time or the seed as an argument")
