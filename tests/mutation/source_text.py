"""The text of a C++ source as mutants see it: what is code in it, and where an expression or a statement begins and ends."""

import re

OPENING = {"(": ")", "[": "]", "{": "}"}
CLOSING = {closing: opening for opening, closing in OPENING.items()}
COMMENT_OR_STRING = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#[^\n]*', re.S | re.M
)
# What an expression ends at, where it is not inside of brackets.
ENDS = re.compile(r"::|->|&&|\|\||<<=|>>=|[-+*/%&|^]=|[<>=!]=|<<|>>|[=;,?:(){}\[\]]|\b(?:return|throw|else|case|co_return)\b")
STOPS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", ";", ",", "?", ":", "return", "throw", "else", "case"}


def masked(text):
    """The text with comments, strings and directives blotted out; every character keeps its place."""

    def blot(match):
        found = match.group(0)
        if found[0] in "\"'":
            return found[0] + "_" * (len(found) - 2) + found[-1]
        blank = "_" if found.startswith("R") else " "
        return re.sub(r"[^\n]", blank, found)

    # A digit's separator is no quote.
    text = re.sub(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])", "_", text)
    return COMMENT_OR_STRING.sub(blot, text)


def names_of(code):
    """Members and functions that a source names: ".member" and "(function"."""
    members = {"." + name for name in re.findall(r"(?:\.|->)([A-Za-z_]\w*)", code)}
    return members | {"(" + name for name in re.findall(r"\b([A-Za-z_]\w*)\(", code)}


class Source:
    """A source, its masked twin, and which bracket belongs to which."""

    def __init__(self, text, names=frozenset()):
        self.text = text
        self.code = masked(text)
        self.partner = {}
        stack = []
        for place, character in enumerate(self.code):
            if character in OPENING:
                stack.append(place)
            elif character in CLOSING and stack:
                opening = stack.pop()
                self.partner[opening] = place
                self.partner[place] = opening
        self.starts = [0] + [match.end() for match in re.finditer("\n", text)]
        # Names in use: ".member" and "(function" of all sources, names of this one.
        self.names = names | set(re.findall(r"(?<![.>\w])[A-Za-z_]\w*", self.code)) | {"true", "false"}
        self.marks = [(match.start(), match.end(), match.group(0)) for match in ENDS.finditer(self.code)]

    def lines(self):
        return self.text.split("\n")

    def line_span(self, line):
        """Where the line of that number, from 0, begins and ends, without the spaces around its text."""
        whole = self.text.split("\n")[line]
        begin = self.starts[line] + len(whole) - len(whole.lstrip())
        return begin, self.starts[line] + len(whole.rstrip())

    def line_of(self, place):
        return self.text.count("\n", 0, place)

    def expression(self, begin, end):
        """The smallest expression that holds the span: up to brackets, commas, assignments and statements' ends. None where the
        span reaches over several, such as two entries of a list in braces."""
        begin, end = self._balanced(begin, end)
        inside = self._stops_in(begin, end)
        if inside & {",", ";", "return"} or any(mark.endswith("=") for mark in inside):
            opening = self.opening_around(begin)
            if opening is None or self.code[opening] != "(" or inside - {",", "?", ":"}:
                return None
            return self.expression(opening, self.partner[opening] + 1)
        stops = STOPS - {"?", ":"} if inside else STOPS
        left, right = self._left(begin, stops), self._right(end, stops)
        while left < begin and self.code[left].isspace():
            left += 1
        while right > end and self.code[right - 1].isspace():
            right -= 1
        return left, right

    def _balanced(self, begin, end):
        """The span, grown until each bracket in it has its partner in it."""
        while True:
            partners = [self.partner[place] for place in range(begin, end) if place in self.partner]
            grown = min([begin, *partners]), max([end, *(place + 1 for place in partners)])
            if grown == (begin, end):
                return grown
            begin, end = grown

    def _stops_in(self, begin, end):
        """What would end an expression within a span, outside of brackets."""
        found, skip = set(), begin
        for start, _, mark in self.marks:
            if begin <= start < end and start >= skip:
                if mark in OPENING:
                    skip = self.partner[start] + 1
                elif mark in STOPS:
                    found.add(mark)
        return found

    def opening_around(self, place):
        """The innermost bracket that is open at a place, or None."""
        around = [opening for opening, closing in self.partner.items() if opening < place <= closing and self.code[opening] in OPENING]
        return max(around, default=None)

    def _left(self, begin, stops):
        skip = None
        for start, stop, mark in reversed(self.marks):
            if start >= begin or (skip is not None and start > skip):
                continue
            if skip == start:
                skip = None
                continue
            if mark in CLOSING:
                partner = self.partner.get(start)
                # A block that ended before belongs to another statement.
                if partner is None or (mark == "}" and self._is_block(partner)):
                    return stop
                skip = partner
            elif mark in OPENING or mark in stops:
                return stop
        return 0

    def _right(self, end, stops):
        skip = None
        for start, _, mark in self.marks:
            if start < end or (skip is not None and start < skip):
                continue
            if skip == start:
                skip = None
                continue
            if mark in OPENING:
                if mark == "{" and self._is_block(start):
                    return start
                skip = self.partner.get(start)
                if skip is None:
                    return start
            elif mark in CLOSING or mark in stops:
                return start
        return len(self.code)

    def _is_block(self, opening):
        """Whether a brace opens statements, not a value: the line ends behind it and it is no lambda's."""
        before = self.code[max(0, opening - 400) : opening].rstrip()
        after = self.code[opening + 1 : opening + 200].split("\n")[0].strip()
        if after:
            return False
        if before.endswith(("else", "do", "try")) or before.endswith(("const", "noexcept")):
            return True
        if before.endswith(")"):
            inner = self.partner.get(opening - 1 - (len(self.code[:opening]) - len(self.code[:opening].rstrip())))
            return inner is None or not self.code[:inner].rstrip().endswith("]")
        return False

    def statement(self, begin):
        """The statement that begins there, with its semicolon or its block and what follows by else."""
        word = re.match(r"(if|for|while)\b[^(]*", self.code[begin:])
        if not word:
            place = begin
            while place < len(self.code) and self.code[place] != ";":
                if self.code[place] in CLOSING:
                    return None
                place = self.partner.get(place, place) + 1 if self.code[place] in OPENING else place + 1
            return (begin, place + 1) if place < len(self.code) else None
        closing = self.partner.get(begin + word.end())
        opening = self.code.find("{", closing or 0)
        if closing is None or opening < 0 or self.code[closing + 1 : opening].strip():
            return None
        end = self.partner[opening] + 1
        other = re.match(r"\s*else\s*(if\b)?", self.code[end:])
        if other and other.group(1):
            inner = self.statement(end + other.start(1))
            return (begin, inner[1]) if inner else None
        if other:
            end = self.partner.get(end + other.end(), end) + 1
        return begin, end
