"""Rules about pointers from comments and pages to pages."""

import pathlib
import re

from findings import Finding
from sources import text_files

COMMENT_MARK = re.compile(r"^\s*(///?<?|#+|\*|-)?\s*")
CODE_POINTER = re.compile(r"(?<![\w./(-])docs/(?P<page>[\w/-]+\.md)(?P<rest>, (?=[A-Z]))?")
PAGE_POINTER = re.compile(r"\]\((?P<page>[\w./-]+\.md)\)(?P<rest>, (?=[A-Z]))?")
HEADING = re.compile(r"^#+ +(.*\S)\s*$")
UNSHIPPED = re.compile(r"\bspec/[\w-]+\.md|(?<![\w/])(commands|characters|editor|eye|bodies)\.md\b")
NUMBERED = re.compile(r"\b[Ss]ection (\d|\")")


class Flow:
    """The text of a file as one line, so that a pointer may go on in the next line of a comment."""

    def __init__(self, lines):
        self.text = ""
        self.starts = []
        for line in lines:
            self.starts.append(len(self.text))
            self.text += COMMENT_MARK.sub("", line, count=1) + " "

    def line_at(self, offset):
        return sum(1 for start in self.starts if start <= offset)


def headings_of(page):
    lines = page.read_text(encoding="utf-8").splitlines()
    headings = [match.group(1) for match in map(HEADING.match, lines) if match]
    return headings + [heading.split(":", 1)[0] for heading in headings]


def problem_of(pointer, page, text):
    """What is wrong with a pointer to `page`; empty where it lands."""
    if not page.is_file():
        return f"points to {pointer['page']}, which does not exist"
    if not pointer["rest"]:
        return ""
    there = text[pointer.end() :]
    for heading in headings_of(page):
        if re.match(re.escape(heading) + r"(?!\w)", there):
            return ""
    return f"{pointer['page']} has no section \"{there[:30].strip()}...\""


def pointers(root):
    """Pointers that land nowhere: `docs/PAGE.md` and `docs/PAGE.md, Heading` in comments, links between pages."""
    docs = pathlib.Path(root) / "docs"
    findings = []
    for file in text_files(root):
        if file.name.startswith("tests/lint/"):  # Bad examples.
            continue
        flow = Flow(file.lines())
        is_page = file.suffix == ".md"
        for pattern, folder in ((CODE_POINTER, docs), (PAGE_POINTER, file.path.parent if is_page else None)):
            for pointer in pattern.finditer(flow.text) if folder else ():
                problem = problem_of(pointer, folder / pointer["page"], flow.text)
                if problem:
                    findings.append(Finding(file.name, flow.line_at(pointer.start()), problem))
        for pattern in (UNSHIPPED, NUMBERED):
            for match in pattern.finditer(flow.text):
                findings.append(
                    Finding(file.name, flow.line_at(match.start()), f'"{match.group(0)}": no page of docs/ by name and heading')
                )
    return sorted(findings, key=lambda finding: (finding.file, finding.line))
