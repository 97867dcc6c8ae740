"""What a rule still allows: tests/lint/allowed/RULE.txt, a line for each exception: a figure, what it counts for, and the reason.

    30 Settings: cut by subject when its readers are

A figure falls with the code and never rises by itself: raising one is a change that says why.
"""

import pathlib
import re
from dataclasses import dataclass

LINE = re.compile(r"^(?P<figure>\d+) (?P<name>\S+): (?P<reason>\S.*)$")


@dataclass(frozen=True)
class Allowance:
    figure: int
    reason: str


class Malformed(Exception):
    """A line of a list that says no figure, no name or no reason."""


def allowed(root, rule):
    """The exceptions of a rule by what they count for; none where the tree has no list."""
    path = pathlib.Path(root, "tests", "lint", "allowed", f"{rule}.txt")
    if not path.is_file():
        return {}
    found = {}
    for number, text in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if not text.strip() or text.startswith("#"):
            continue
        match = LINE.match(text)
        if match is None:
            raise Malformed(f"{path.name}:{number}: give 'FIGURE NAME: REASON'")
        found[match["name"]] = Allowance(int(match["figure"]), match["reason"])
    return found


def at_most(exceptions, name, limit):
    return exceptions[name].figure if name in exceptions else limit
