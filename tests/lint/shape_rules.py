"""Rules about the shape of code: members of a struct, parameters of a function, switches over kinds, bodies written twice."""

import re

from allowances import allowed, at_most
from findings import Finding
from function_rule import blanked, function_spans
from sources import ROOMS, code_files

MEMBERS_AT_MOST = 25
PARAMETERS_AT_MOST = 6
SAME_LINES_MORE_THAN = 6

STRUCT = re.compile(r"\b(?:struct|class) +(?:alignas *\([^)]*\) *)?(?P<name>[\w:]+)(?: +final)?(?: *:[^{;]*)?\s*$")
NO_MEMBER = re.compile(r"^(using|friend|static|typedef|enum|struct|class|template|return)\b")
ACCESS = re.compile(r"^(?:(?:public|private|protected) *:\s*)+")
KIND = re.compile(r"\benum class (\w+Kind)\b")
KIND_SWITCH = re.compile(r"\bswitch *\([^{]*\{\s*case +(?:\w+::)*(?P<kind>\w*Kind)::\w+")
SCHEMA_FOLDER = "app/schema/"
SETTING_NAME = re.compile(r'\.name = "(\w+)"')
JSON_KEY = re.compile(r'\[ *"(\w+)" *\]|\.(?:contains|at|find|value)\( *"(\w+)"')
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
WORD = re.compile(r"[A-Za-z_]\w*")
DECLARED = re.compile(r"(?:[\w>\]] +|[&*>] *)(?P<name>[a-z]\w*)(?= *(?:[={;:,)(]))")


def text_of(file):
    return file.path.read_text(encoding="utf-8")


def line_of(text, place):
    return text.count("\n", 0, place) + 1


def split_at_top(text, separator=","):
    """The parts of a list, cut where no bracket is open."""
    parts, depth = [""], 0
    for sign in text:
        depth += (sign in "(<[{") - (sign in ")>]}")
        if sign == separator and depth == 0:
            parts.append("")
        else:
            parts[-1] += sign
    return [part.strip() for part in parts if part.strip()]


def without_brackets(text, opening, closing):
    """The text without what stands between brackets of a sort, and without these."""
    kept, depth = "", 0
    for sign in text:
        depth += sign == opening
        if depth == 0:
            kept += sign
        depth -= sign == closing and depth > 0
    return kept


def members_of(statement):
    """How many members of data a statement of a struct declares."""
    plain = ACCESS.sub("", without_brackets(statement, "<", ">").split("=", 1)[0].strip())
    if not plain or "(" in plain or NO_MEMBER.match(plain) or "operator" in statement:
        return 0
    return len(split_at_top(plain))


def structs(code):
    """Name, place and number of members of every struct and class of a text whose silent parts are blank."""
    found, inside = [], []  # `inside`: for each open brace [name, place, members] of a struct, or None.
    statement = ""
    for place, sign in enumerate(code):
        if sign == "{":
            struct = STRUCT.search(statement)
            is_enum = re.search(r"\benum +(class|struct)\b", statement)
            inside.append([struct["name"], place, 0, ""] if struct and not is_enum else [None, place, 0, statement])
            statement = ""
        elif sign == "}" and inside:
            name, begun, count, head = inside.pop()
            if name:
                found.append((name, begun, count))
            # An initialiser is a part of its statement; a function's body ends one.
            is_initialiser = name is None and not head.rstrip().endswith((")", "const", "override", "noexcept", "final"))
            statement = head if is_initialiser else ""
        elif sign == ";":
            if inside and inside[-1][0]:
                inside[-1][2] += members_of(statement)
            statement = ""
        else:
            statement += sign
    return found


def struct_members(root):
    """Structs that hold more than one reader keeps in mind."""
    exceptions = allowed(root, "struct-members")
    findings = []
    for file in code_files(root):
        code = blanked(text_of(file))
        for name, place, count in structs(code):
            limit = at_most(exceptions, name, MEMBERS_AT_MOST)
            if count > limit:
                findings.append(Finding(file.name, line_of(code, place), f"{name} has {count} members; at most {limit}: split it by subject"))
    return findings


def parameters_of(head):
    """The parameters of a function's head; those that a constructor's initialisers are given do not count."""
    head = re.sub(r"\boperator *\(\)", "operatorCall", head)
    place = re.search(r"[\w>)\]=+*/<-] *\(", head)
    if place is None:
        return []
    begin = place.end()
    depth = 1
    for end in range(begin, len(head)):
        depth += (head[end] == "(") - (head[end] == ")")
        if depth == 0:
            return split_at_top(head[begin:end])
    return []


def parameter_count(root):
    """Functions with more parameters than a caller keeps in order."""
    exceptions = allowed(root, "parameters")
    findings = []
    for file in code_files(root):
        code = blanked(text_of(file))
        for function in function_spans(code):
            head = code[function.begin : function.opening]
            count = len(parameters_of(head))
            name = re.search(r"([\w~:]+) *\(", head)
            limit = at_most(exceptions, name.group(1) if name else "", PARAMETERS_AT_MOST)
            if count > limit:
                findings.append(Finding(file.name, line_of(code, function.begin), f"{count} parameters; at most {limit}: make a struct of them"))
    return findings


def kind_switches(root):
    """Switches over a kind of thing outside the table of that kind: the next kind would have to find them all."""
    exceptions = allowed(root, "kind-switches")
    files = [file for file in code_files(root) if file.room in ROOMS]
    # A kind that the interface alone knows has its table where it is drawn.
    kinds = {kind for file in files if file.room != "ui" for kind in KIND.findall(text_of(file))}
    findings = []
    for file in files:
        code = blanked(text_of(file))
        found = [match for match in KIND_SWITCH.finditer(code) if match["kind"] in kinds]
        if len(found) > at_most(exceptions, file.name, 0):
            findings += [
                Finding(file.name, line_of(code, match.start()), f"switches over {match['kind']}: make it a column of the table of that kind")
                for match in found
            ]
    return findings


def settings_json(root):
    """JSON of a setting that is read or written beside the schema, which describes it once."""
    exceptions = allowed(root, "settings-json")
    files = [file for file in code_files(root) if file.room in ROOMS]
    settings = {name for file in files if file.name.startswith(SCHEMA_FOLDER) for name in SETTING_NAME.findall(text_of(file))}
    findings = []
    for file in files:
        if file.name.startswith(SCHEMA_FOLDER) or file.room not in ("app", "ui"):
            continue
        code = COMMENT.sub("", text_of(file))
        found = [match for match in JSON_KEY.finditer(code) if (match.group(1) or match.group(2)) in settings]
        if len(found) > at_most(exceptions, file.name, 0):
            names = ", ".join(sorted({match.group(1) or match.group(2) for match in found}))
            findings.append(Finding(file.name, 0, f"JSON of settings by hand ({names}): the schema reads and writes it"))
    return findings


def body_of(text, code, function):
    """The lines of a function's body, in which names that it declares itself do not count."""
    code = code[function.begin : function.closing]
    names = {}
    for match in DECLARED.finditer(code):
        names.setdefault(match["name"], f"${len(names)}")
    body = COMMENT.sub("", text[function.opening + 1 : function.closing])
    lines = (" ".join(line.split()) for line in body.splitlines())
    return "\n".join(WORD.sub(lambda word: names.get(word.group(0), word.group(0)), line) for line in lines if line)


def same_bodies(root):
    """Functions of the product that are one another under another name."""
    exceptions = allowed(root, "same-bodies")
    seen, findings = {}, []
    for file in code_files(root):
        if file.room not in ROOMS:
            continue
        text = text_of(file)
        code = blanked(text)
        for function in function_spans(code):
            body = body_of(text, code, function)
            if body.count("\n") + 1 <= SAME_LINES_MORE_THAN:
                continue
            place = f"{file.name}:{line_of(text, function.begin)}"
            first = seen.setdefault(body, place)
            if first != place and file.name not in exceptions:
                findings.append(Finding(file.name, line_of(text, function.begin), f"has the body of {first}: one function for both"))
    return findings
