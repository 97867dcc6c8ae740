"""The usual operators: what a line of the product can become by one small fault."""

import re

NAMES = [
    ("left", "right"), ("Left", "Right"), ("start", "end"), ("Start", "End"), ("begin", "end"), ("Begin", "End"),
    ("first", "last"), ("First", "Last"), ("first", "second"), ("front", "back"), ("lower", "upper"), ("Lower", "Upper"),
    ("base", "tip"), ("Base", "Tip"), ("from", "to"), ("From", "To"), ("in", "out"), ("In", "Out"), ("inner", "outer"),
    ("before", "after"), ("parent", "child"), ("leader", "follower"), ("minimum", "maximum"), ("width", "height"), ("a", "b"),
    ("translation", "scale"), ("rows", "columns"), ("source", "target"),
]
OTHER = {}
for one, two in NAMES:
    OTHER.setdefault(one, []).append(two)
    OTHER.setdefault(two, []).append(one)
for one, two in (("x", "y"), ("y", "z"), ("z", "x"), ("true", "false"), ("false", "true")):
    OTHER.setdefault(one, []).append(two)
OPERAND = r"-?(?:[A-Za-z_][\w]*(?:::|\.|->)?)*[\w.]+"
WHOLE_WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\w")


def candidates(source, line):
    """Changes of a line as (operator, begin, end, text): what of the source becomes what. Text None: the statement is gone."""
    begin, end = source.line_span(line)
    code = source.code[begin:end]
    if not code.strip() or skipped(code) or is_constant(source, begin):
        return []
    found = []
    for finder in (edges, equalities, logic, terms, signs, factors, numbers, sides, clamps, conditions, removals):
        found += [(name, begin + a, begin + b, text) for name, a, b, text in finder(source, begin, code)]
    return found


def skipped(code):
    """What holds no expression that runs, or one that only the compiler sees."""
    return bool(re.match(r"(?:#|static_assert|constexpr|using|case|template|namespace|struct|class|enum|public|private|default)\b", code)) or (
        code in ("{", "}", "};", "});", "else {", "} else {")
    )


def is_constant(source, place):
    """Whether a place lies in what the compiler calculates: an entry of a constexpr table, a function that is constexpr."""
    opening = source.opening_around(place)
    while opening is not None:
        begin = max(source.code.rfind(mark, 0, opening) for mark in ";{}")
        if re.search(r"\bconstexpr\b", source.code[begin + 1 : opening]):
            return True
        opening = source.opening_around(opening)
    return False


def edges(source, begin, code):
    for match in re.finditer(r" (<|<=|>|>=) ", code):
        sign = match.group(1)
        other = sign[0] if len(sign) == 2 else sign + "="
        yield "edge", match.start(1), match.end(1), other


def equalities(source, begin, code):
    for match in re.finditer(r" (==|!=) ", code):
        yield "inverted", match.start(1), match.end(1), "!=" if match.group(1) == "==" else "=="
    for match in re.finditer(r"(?<![\w)])!(?=[\w(])", code):
        yield "inverted", match.start(), match.end(), ""


def operand_after(source, place):
    """The end of the operand that begins there: a name with its calls and members, or a bracket."""
    code = source.code
    start = place
    if code[place] in "-!":
        place += 1
    while place < len(code):
        if code[place] in "([{" and place in source.partner:
            place = source.partner[place] + 1
        elif code[place].isalnum() or code[place] in "_.":
            place += 1
        elif code.startswith("::", place) or code.startswith("->", place):
            place += 2
        else:
            break
        if place < len(code) and code[place] in " \n":
            break
    return place if place > start else None


def logic(source, begin, code):
    for match in re.finditer(r"&&|\|\|", code):
        if not code.endswith("&& other") and code[match.start() - 1 : match.start()] == " ":
            yield "logic", match.start(), match.end(), "||" if match.group(0) == "&&" else "&&"


def terms(source, begin, code):
    for match in re.finditer(r" (\+|-|\*|/|%) ", code):
        end = operand_after(source, begin + match.end())
        if end:
            yield "term dropped", match.start(), end - begin, ""
    for match in re.finditer(r" (&&|\|\|)\s", code):
        # The whole comparison behind it, up to the next of its kind.
        _, end = source.expression(begin + match.end(), begin + match.end() + 1)
        following = re.search(r"&&|\|\|", flat(source, begin + match.end(), end))
        stop = begin + match.end() + following.start() if following else end
        yield "member missing", match.start(), stop - begin, " " if following else ""


def flat(source, begin, end):
    """The code of a span with what stands in brackets blotted out."""
    code = list(source.code[begin:end])
    place = begin
    while place < end:
        partner = source.partner.get(place)
        if partner is not None and place < partner < end:
            for inner in range(place, partner + 1):
                code[inner - begin] = "_"
            place = partner
        place += 1
    return "".join(code)


def signs(source, begin, code):
    for match in re.finditer(r" (\+|-) ", code):
        yield "sign", match.start(1), match.end(1), "-" if match.group(1) == "+" else "+"
    for match in re.finditer(r"(?:(?<=[(,{\[?:] )|(?<=[(\[{])|(?<== )|(?<=return ))-(?=[\w(])", code):
        yield "sign", match.start(), match.end(), ""
    for match in re.finditer(r" (\+|-)= ", code):
        yield "sign", match.start(1), match.end(1), "-" if match.group(1) == "+" else "+"


def factors(source, begin, code):
    for match in re.finditer(r" (\*|/) ", code):
        yield "factor", match.start(1), match.end(1), "/" if match.group(1) == "*" else "*"


def numbers(source, begin, code):
    for match in re.finditer(r"(?<![\w.])(\d+)(\.\d+)?(e-?\d+)?(?=[fFuUL]*\b)", code):
        whole, part, power = match.groups()
        if power:
            text = f"{whole}{part or ''}e{int(power[1:]) + 2}"
        elif part:
            value = float(whole + part)
            text = "1.0" if value == 0 else "0.0" if value == 1 else repr(value * 2)
        else:
            text = str(int(whole) + 1) if int(whole) < 2 else str(int(whole) - 1)
        yield "number", match.start(), match.end(), text


def sides(source, begin, code):
    """A name's other side, where that is a name of the same file, or a member or a function of some file."""
    for match in re.finditer(r"[A-Za-z_]\w*", code):
        name = match.group(0)
        before, behind = code[: match.start()], code[match.end() :]
        declares = re.search(r"(?:[\w>][&*>]*) $", before) and not re.search(r"\b(?:return|else|case|throw) $", before)
        if (declares and re.match(r" = |;|\(|\{|,|\)| :", behind)) or (name in ("begin", "end") and behind.startswith("()")):
            continue  # The name of a declaration; a container's end.
        for word in WHOLE_WORD.finditer(name):
            if word.group(0) not in OTHER or (word.group(0) in ("in", "to", "from", "a", "b", "x", "y", "z") and word.group(0) != name):
                continue
            for other in OTHER[word.group(0)]:
                swapped = name[: word.start()] + other + name[word.end() :]
                kind = "." if code[: match.start()].endswith((".", "->")) else "(" if code[match.end() :].startswith("(") else ""
                if kind + swapped in source.names:
                    yield "sides", match.start(), match.end(), swapped


def clamps(source, begin, code):
    for match in re.finditer(r"(?:std|glm)::(clamp|min|max|abs)\(", code):
        closing = source.partner.get(begin + match.end() - 1)
        if closing is None:
            continue
        inner = source.text[begin + match.end() : closing]
        flattened = flat(source, begin + match.end(), closing)
        parts = []
        for part in re.finditer(r"[^,]+", flattened):
            parts.append(inner[part.start() : part.end()].strip())
        name = match.group(1)
        if name in ("min", "max"):
            other = source.text[begin + match.start() : begin + match.start() + 5] + ("max" if name == "min" else "min")
            yield "clamp lost", match.start(), match.end() - 1, other
        for part in parts[:1] if name in ("clamp", "abs") else parts[:2]:
            yield "clamp lost", match.start(), closing + 1 - begin, f"({part})"


def conditions(source, begin, code):
    match = re.match(r"(?:\} else )?(?:if|while) \(", code)
    if match:
        closing = source.partner.get(begin + match.end() - 1)
        inner = source.text[begin + match.end() : closing] if closing else ";"
        if ";" not in inner and " = " not in inner:
            yield "inverted", match.end(), closing - begin, f"!({inner})"


def is_guard(source, brace):
    """Whether a block is that of an if: what leaves it early would else leave a function without its value."""
    head = source.code[:brace].rstrip()
    opening = source.partner.get(len(head) - 1) if head.endswith(")") else None
    return opening is not None and bool(re.search(r"\bif $", source.code[:opening]))


def removals(source, begin, code):
    """A call or an assignment that is gone; a guard that lets through what it should refuse."""
    before = source.code[:begin].rstrip()
    if before and before[-1] not in ";{}":
        return
    leaves = re.match(r"(return\b|continue;|break;)", code)
    if leaves:
        span = source.statement(begin)
        if before.endswith("{") and is_guard(source, len(before) - 1) and span and source.code[span[1] :].lstrip().startswith("}"):
            error = "rror" in source.code[begin : span[1]]
            yield "error swallowed" if error else "early return", 0, span[1] - begin, None
        return
    if re.match(r"[\w.:>\[\]()*-]+\.reserve\(", code):
        return  # memory asked for beforehand: without it everything behaves as it did
    if re.match(r"[\w.:>\[\]()*-]+(?:\([^;]*|\s*[-+*/|&]?=[^=][^;]*)", code) and not re.match(r"(if|for|while|switch|return|else)\b", code):
        span = source.statement(begin)
        if span:
            yield "statement gone", 0, span[1] - begin, None
