"""Who may include whom: the arrows between the rooms, and where the libraries stay."""

import re

from findings import Finding
from sources import code_files

# A room and what it may include. The arrows of the house; everything not named here is refused.
ARROWS = {
    "core": {"core"},
    "rig": {"core", "rig"},
    "skinning": {"core", "skinning"},
    "app": {"core", "rig", "skinning", "app"},
    "ui": {"core", "rig", "skinning", "app", "ui"},
    "assets": {"core", "assets"},
}
# The one file that joins the program without a screen with the editor.
JOINING_FILE = "app/main.cpp"

# What stays apart within a room: who, what it may not include, and why.
LAYERS = [
    (r"core/base/", r"core/(?!base/)", "core/base knows nothing but itself"),
    (r"core/(?!gltf/|interchange/)", r"core/gltf/", "values know no file format"),
    (r"core/interchange/", r"core/gltf/(?!json/|source/)", "what makes a glTF does not read one"),
    (r"core/(?!interchange/|gltf/read/)", r"core/interchange/", "only what reads a file asks for its format"),
    (r"rig/(?!rekey/|corners/)", r"rig/(rekey|corners)/", "motion does not know that it is keyed"),
    (r"rig/(body|trail|ik|reach|adjust)/", r"rig/motion/", "a part of the motion does not know the whole"),
    (r"rig/(body|trail|ik|reach)/", r"rig/adjust/", "how a limb reaches its goal does not ask who set it"),
    (r"skinning/(sequence|geometry|elastic|weights|body|fit)/", r"skinning/(compress|export)/", "a step does not know the whole"),
    (r"app/(?!batch/|main\.cpp)", r"app/batch/", "only the program reaches the verbs"),
    (r"app/(schema|weight|evaluate|edits|recipe)/", r"app/(commands/|session\.h|history\.h)", "edits do not know who asks"),
    (r"ui/render/", r"(ui/(?!render/)|app/)", "pictures are drawn from values of core"),
    (r"ui/widgets/", r"(ui/(?!widgets/)|app/|rig/|skinning/)", "a widget knows no document"),
    (r"ui/panels/", r"ui/(?!panels/|widgets/)", "a panel draws and asks"),
    (r"ui/(?!shell/)", r"ui/shell/", "the shell joins the others, and nobody needs it"),
]

# A library, the includes that belong to it, and the files that may have them.
LIBRARIES = [
    ("OpenGL", r"(epoxy|GL|EGL|GLES\d?)/", r"ui/(render|shell)/|tests/(support/)?ui(_driver)?/|tests/bench/speed/minimal_gl\.cpp"),
    ("GLFW", r"GLFW/", r"ui/shell/|tests/support/ui_driver/|tests/bench/speed/minimal_gl\.cpp"),
    ("Dear ImGui", r"im(gui|stb|plot)[^/]*\.h$|misc/|backends/", r"ui/(widgets|panels|viewport|shell)/|tests/(support/)?ui(_driver)?/|tests/bench/"),
    ("font libraries", r"(fontconfig/|ft2build\.h$|freetype)", r"ui/(render|widgets|shell)/.*\.cpp$"),
    ("OpenMesh, Embree and Eigen", r"(OpenMesh|embree\d?|Eigen)/", r"(tests/(support/)?)?skinning/"),
    ("assimp", r"assimp/", r"(tests/)?core/interchange/|tests/support/core/foreign_scene\.h"),
    ("tinygltf", r"tiny_gltf", r"(core/gltf/write/new_file\.cpp|tests/.*\.cpp)$"),
    ("stb", r"(stb_|stb/)", r"(core/(gltf|interchange)/.*\.cpp|ui/render/.*\.cpp|tests/.*\.cpp)$"),
    ("CLI11", r"CLI/", r"app/batch/|tests/(app|bench)/"),
    ("Catch2", r"catch2/", r"tests/"),
]
# Heavy headers that no other room may meet, not even through a header of the room that owns them.
HIDDEN = [("skinning", "OpenMesh, Embree and Eigen", re.compile(r"(OpenMesh|embree\d?|Eigen)/"))]


def include_direction(root):
    """Arrows between rooms that run the wrong way."""
    findings = []
    for file in code_files(root):
        allowed = ARROWS.get(file.room)
        if allowed is None:
            continue
        for include in file.includes():
            target = include.target.split("/", 1)[0] if include.quoted and "/" in include.target else file.room
            if file.name == JOINING_FILE and target == "ui":
                continue
            if target not in allowed:
                message = f"{file.room}/ may not include {target}/: {include.target}"
                findings.append(Finding(file.name, include.line, message))
    return findings


def room_layers(root):
    """Arrows within a room that run the wrong way."""
    findings = []
    for file in code_files(root):
        for include in file.includes():
            for who, whom, why in LAYERS:
                if include.quoted and re.match(who, file.name) and re.match(whom, include.target):
                    findings.append(Finding(file.name, include.line, f"may not include {include.target}: {why}"))
    return findings


def place_of(name):
    """The folder that a file belongs to; one that stands in the room itself is a place with its header."""
    parts = name.split("/")
    return "/".join(parts[:-1]) if len(parts) > 2 else name.rsplit(".", 1)[0]


def include_circles(root):
    """Files, and folders of a room, that include each other in a circle."""
    files = {file.name: file for file in code_files(root) if file.room in ARROWS}
    arrows, places = {}, {}
    for name, file in files.items():
        for include in file.includes():
            if include.quoted and include.target in files and name != JOINING_FILE:
                arrows.setdefault(name, {})[include.target] = (name, include)
                here, there = place_of(name), place_of(include.target)
                if here != there:
                    places.setdefault(here, {}).setdefault(there, (name, include))
    findings = []
    for graph in (arrows, places):
        for circle in circles(graph):
            arrow, include = graph[circle[0]][circle[1]]
            findings.append(Finding(arrow, include.line, "a circle of includes: " + " -> ".join(circle)))
    return findings


def circles(graph):
    """One circle for each knot of a graph: a list of nodes that ends where it begins. `graph`: node to nodes."""
    found, done = [], set()
    for start in sorted(graph):
        if start in done:
            continue
        path = way_back(graph, start)
        if path:
            found.append(path)
            done.update(path)
        done.add(start)
    return found


def way_back(graph, start):
    """The shortest way from a node to itself; empty without one."""
    before, waiting = {}, [start]
    while waiting:
        node = waiting.pop(0)
        for further in sorted(graph.get(node, ())):
            if further == start:
                path = [start, node]
                while path[-1] != start:
                    path.append(before[path[-1]])
                return path[::-1]
            if further not in before:
                before[further] = node
                waiting.append(further)
    return []


def library_place(root):
    """Libraries outside the files that keep them from the rest of the house."""
    findings = []
    for file in code_files(root):
        for include in file.includes():
            for library, pattern, places in LIBRARIES:
                if not include.quoted and re.match(pattern, include.target) and not re.match(places, file.name):
                    findings.append(Finding(file.name, include.line, f"{library} may not be included here"))
    return findings + hidden_libraries(root)


def hidden_libraries(root):
    files = {file.name: file for file in code_files(root)}
    findings = []
    for room, library, pattern in HIDDEN:
        reaching = headers_that_reach(files, pattern)
        for file in files.values():
            if file.room not in ARROWS or file.room == room:
                continue
            for include in file.includes():
                if include.quoted and include.target in reaching:
                    findings.append(Finding(file.name, include.line, f"{include.target} draws in {library}"))
    return findings


def headers_that_reach(files, pattern):
    """Names of the headers that include what `pattern` matches, directly or through others."""
    includes = {name: file.includes() for name, file in files.items() if file.suffix == ".h"}
    reaching = {name for name, lines in includes.items() if any(pattern.match(line.target) for line in lines)}
    grown = True
    while grown:
        further = {
            name
            for name, lines in includes.items()
            if name not in reaching and any(line.quoted and line.target in reaching for line in lines)
        }
        grown = bool(further)
        reaching |= further
    return reaching
