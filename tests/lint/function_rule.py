"""How long functions are, told by their braces: no compiler is needed, and a file that does not compile is read too."""

import re
from dataclasses import dataclass

from findings import Finding
from sources import code_files

LINES_AT_MOST = 60

# What holds braces that open no body: comments, strings (raw ones too) and characters. A digit before ' separates thousands.
SILENT = re.compile(
    r"//[^\n]*|/\*.*?\*/|R\"([^(\s]*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'", re.DOTALL
)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*$", re.MULTILINE)
# What opens a scope that functions stand in.
SCOPE = re.compile(r"^(?:template\s*<.*?>\s*)?(?:inline\s+)?(?:namespace|class|struct|union|enum|extern)\b", re.DOTALL)


def blanked(text):
    """The text with everything silent made blank, line for line and column for column."""

    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0))

    return DIRECTIVE.sub(blank, SILENT.sub(blank, text))


def is_function(head):
    """Whether what stands before a brace, since the last statement, is the head of a function's body."""
    return ")" in head and not SCOPE.match(head) and not re.search(r"=\s*$", head)


@dataclass(frozen=True)
class Function:
    """A function that stands in no other one, as places in the text of its file."""

    begin: int  # Where its signature begins.
    opening: int  # Its first brace
    closing: int  # and its last.

    def lines(self, text):
        return text.count("\n", 0, self.begin) + 1, text.count("\n", 0, self.closing) + 1


def function_spans(code):
    """Every function of a text whose silent parts are blank."""
    found, inside = [], []  # `inside`: for each open brace where a function began, or None for another scope.
    begin = 0
    for match in re.finditer(r"[{};]", code):
        head = code[begin : match.start()]
        if match.group(0) == "{":
            is_begin = all(outer is None for outer in inside) and is_function(head.strip())
            inside.append((begin + len(head) - len(head.lstrip()), match.start()) if is_begin else None)
        elif match.group(0) == "}" and inside:
            begun = inside.pop()
            if begun:
                found.append(Function(*begun, match.start()))
        begin = match.end()
    return found


def functions(text):
    """First and last line of every function that stands in no other one, signature included."""
    return [function.lines(text) for function in function_spans(blanked(text))]


def function_size(root):
    """Functions longer than a screen."""
    findings = []
    for file in code_files(root):
        for first, last in functions(file.path.read_text(encoding="utf-8")):
            lines = last - first + 1
            if lines > LINES_AT_MOST:
                findings.append(Finding(file.name, first, f"{lines} lines; a function has at most {LINES_AT_MOST}: split it"))
    return findings
