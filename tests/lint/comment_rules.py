"""Rules about comments in headers."""

import re

from allowances import allowed, at_most
from findings import Finding
from sources import ROOMS, code_files

# What hides the noun: the reader learns at the end of the sentence what it is about.
HIDING = re.compile(r"^(What|Whose|Where|Of|As|The same)\b(?! follows)")
COMMENT = re.compile(r"(?P<before>.*?)//[/!]?<? ?(?P<text>.*)")


def openings(file):
    """Line and first words of every comment; one that goes on over lines opens once."""
    found, is_going_on = [], False
    for number, line in enumerate(file.lines(), start=1):
        match = COMMENT.match(line)
        if match and not (is_going_on and not match["before"].strip()):
            found.append((number, match["text"]))
        is_going_on = match is not None
    return found


def comment_openings(root):
    """Comments of public headers that open with a word that hides what they are about: fewer with every change, never more."""
    exceptions = allowed(root, "comment-openings")
    by_room = {room: [] for room in ROOMS}
    for file in code_files(root):
        if file.suffix == ".h" and file.room in by_room:
            by_room[file.room] += [(file.name, number, text) for number, text in openings(file) if HIDING.match(text)]
    findings = []
    for room, found in by_room.items():
        limit = at_most(exceptions, room, 0)
        if len(found) > limit:
            findings += [Finding(name, number, f"opens with '{text[:40]}': open with the thing or the verb ({len(found)} in {room}, at most {limit})") for name, number, text in found]
    return findings
