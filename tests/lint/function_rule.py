"""How long functions are, told by their braces: no compiler is needed, and a file that does not compile is read too."""

import re

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


def functions(text):
    """First and last line of every function that stands in no other one, signature included."""
    code = blanked(text)
    found, inside = [], []  # `inside`: for each open brace the first line of a function, or 0 for another scope.
    begin = 0
    for match in re.finditer(r"[{};]", code):
        head = code[begin : match.start()].strip()
        if match.group(0) == "{":
            first = 0
            if not any(inside) and is_function(head):
                start = begin + len(code[begin : match.start()]) - len(code[begin : match.start()].lstrip())
                first = code.count("\n", 0, start) + 1
            inside.append(first)
        elif match.group(0) == "}" and inside:
            first = inside.pop()
            if first:
                found.append((first, code.count("\n", 0, match.start()) + 1))
        begin = match.end()
    return found


def function_size(root):
    """Functions longer than a screen."""
    findings = []
    for file in code_files(root):
        for first, last in functions(file.path.read_text(encoding="utf-8")):
            lines = last - first + 1
            if lines > LINES_AT_MOST:
                findings.append(Finding(file.name, first, f"{lines} lines; a function has at most {LINES_AT_MOST}: split it"))
    return findings
