#!/usr/bin/env python3
"""Shows each rule of the lint a tree that keeps it and trees that break it."""

import pathlib
import shutil
import tempfile
import unittest

import command_line
import format_rule
import function_rule
import include_rules
import pointer_rules
import run_clang_tidy
import sources
import text_rules
import turns


class LintTest(unittest.TestCase):
    def findings(self, rule, files):
        """What a rule finds in a tree of files given by name and text."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return [str(finding) for finding in rule(folder)]

    def kept(self, rule, files):
        self.assertEqual(self.findings(rule, files), [])

    def broken(self, rule, files, *beginnings):
        found = self.findings(rule, files)
        self.assertEqual(len(found), len(beginnings), found)
        for line, beginning in zip(found, beginnings):
            self.assertTrue(line.startswith(beginning), line)


class IncludeDirection(LintTest):
    rule = staticmethod(include_rules.include_direction)

    def test_arrows_of_the_house_are_kept(self):
        self.kept(
            self.rule,
            {
                "core/a.cpp": '#include "core/a.h"\n#include <vector>\n',
                "rig/a.cpp": '#include "core/a.h"\n#include "rig/a.h"\n',
                "app/a.cpp": '#include "core/a.h"\n#include "rig/a.h"\n#include "skinning/a.h"\n',
                "ui/a.cpp": '#include "app/a.h"\n#include "core/a.h"\n',
                "app/main.cpp": '#include "ui/a.h"\n',
            },
        )

    def test_core_knows_nobody(self):
        for room in ("rig", "skinning", "app", "ui", "tests"):
            self.broken(self.rule, {"core/x/a.h": f'\n#include "{room}/a.h"\n'}, "core/x/a.h:2: core/ may not include")

    def test_rig_and_skinning_do_not_know_each_other(self):
        self.broken(self.rule, {"rig/a.cpp": '#include "skinning/a.h"\n'}, "rig/a.cpp:1:")
        self.broken(self.rule, {"skinning/a.cpp": '#include "rig/a.h"\n'}, "skinning/a.cpp:1:")

    def test_only_main_joins_app_with_ui(self):
        self.broken(self.rule, {"app/batch/a.cpp": '#include "ui/render/a.h"\n'}, "app/batch/a.cpp:1:")
        self.broken(self.rule, {"rig/a.cpp": '  #  include "app/a.h"\n'}, "rig/a.cpp:1:")


class RoomLayers(LintTest):
    rule = staticmethod(include_rules.room_layers)

    def test_layers_of_the_house_are_kept(self):
        self.kept(
            self.rule,
            {
                "app/batch/a.cpp": '#include "app/batch/verb.h"\n#include "app/recipe/recipe.h"\n',
                "app/main.cpp": '#include "app/batch/verb.h"\n#include "ui/shell/editor.h"\n',
                "core/gltf/a.cpp": '#include "core/scene/scene.h"\n#include "core/base/check.h"\n',
                "ui/panels/a.cpp": '#include "ui/widgets/button.h"\n#include "app/session.h"\n',
                "ui/shell/a.cpp": '#include "ui/render/view/camera.h"\n#include "ui/panels/context/panels.h"\n',
            },
        )

    def test_nothing_but_the_program_reaches_the_verbs(self):
        for place in ("recipe/recipe", "files/saved_work", "schema/trail_json", "document"):
            self.broken(self.rule, {f"app/{place}.cpp": '#include "app/batch/options.h"\n'}, f"app/{place}.cpp:1:")

    def test_parts_do_not_know_the_whole(self):
        for file, target in (
            ("core/base/a.h", "core/math/types.h"),
            ("core/scene/a.h", "core/gltf/source/source.h"),
            ("rig/motion/a.cpp", "rig/rekey/rekey.h"),
            ("rig/trail/a.cpp", "rig/motion/motion.h"),
            ("skinning/fit/a.cpp", "skinning/compress/compress.h"),
            ("app/edits/a.cpp", "app/session.h"),
            ("ui/render/a.cpp", "ui/widgets/theme.h"),
            ("ui/render/b.cpp", "app/document.h"),
            ("ui/widgets/a.cpp", "app/document.h"),
            ("ui/panels/a.cpp", "ui/render/view/camera.h"),
            ("ui/batch/a.cpp", "ui/shell/editor.h"),
        ):
            self.broken(self.rule, {file: f'#include "{target}"\n'}, f"{file}:1: may not include {target}")


class IncludeCircles(LintTest):
    rule = staticmethod(include_rules.include_circles)

    def test_a_house_without_a_circle_is_kept(self):
        self.kept(
            self.rule,
            {
                "core/a/a.h": '#include "core/b/b.h"\n',
                "core/a/c.h": '#include "core/a/a.h"\n',
                "core/b/b.h": "",
                "app/document.cpp": '#include "app/document.h"\n',
                "app/document.h": "",
            },
        )

    def test_a_circle_of_files_is_found(self):
        files = {
            "core/a/a.h": '#include "core/a/b.h"\n',
            "core/a/b.h": '\n#include "core/a/c.h"\n',
            "core/a/c.h": '#include "core/a/a.h"\n',
        }
        self.broken(self.rule, files, "core/a/a.h:1: a circle of includes: core/a/a.h -> core/a/b.h -> core/a/c.h -> core/a/a.h")

    def test_a_circle_of_folders_is_found(self):
        files = {
            "rig/a/one.cpp": '#include "rig/b/two.h"\n',
            "rig/a/three.h": "",
            "rig/b/two.h": "",
            "rig/b/four.cpp": '#include "rig/a/three.h"\n',
        }
        self.broken(self.rule, files, "rig/a/one.cpp:1: a circle of includes: rig/a -> rig/b -> rig/a")

    def test_a_file_that_stands_in_its_room_is_a_place_of_its_own(self):
        files = {
            "app/document.h": "",
            "app/document.cpp": '#include "app/files/work.h"\n',
            "app/files/work.h": '#include "app/document.h"\n',
        }
        self.broken(self.rule, files, "app/document.cpp:1: a circle of includes: app/document -> app/files")


class FunctionSize(LintTest):
    rule = staticmethod(function_rule.function_size)

    def body(self, head, lines):
        return f"{head} {{\n" + "  step();\n" * (lines - 2) + "}\n"

    def test_functions_of_sixty_lines_are_kept(self):
        self.kept(self.rule, {"core/a.cpp": self.body("int count(int a)", 60) * 2})
        self.kept(self.rule, {"core/a.h": self.body("namespace a", 70) + self.body("class B", 70)})

    def test_longer_ones_are_found_wherever_they_stand(self):
        for head in (
            "int count(int a)",
            "Reader::Reader(int a) : a_(a)",
            'TEST_CASE("it holds (always)")',
            "template <typename T>\nT largest(const T& a) noexcept",
            "auto read(int a) -> Result",
        ):
            lines = 61 - head.count("\n")
            self.broken(self.rule, {"rig/a.cpp": "\n" + self.body(head, lines)}, "rig/a.cpp:2: 61 lines")
            inside = "namespace a {\nstruct B {\n" + self.body(head, lines) + "};\n} // namespace a\n"
            self.broken(self.rule, {"rig/a.h": inside}, "rig/a.h:3: 61 lines")

    def test_braces_that_are_text_do_not_count(self):
        text = 'void a() {\n  // }\n  f("}", \'}\', R"(\n}\n)");\n' + "  g(1'000, {2});\n" * 57 + "}\n"
        self.broken(self.rule, {"core/a.cpp": text}, "core/a.cpp:1: 63 lines")


class LibraryPlace(LintTest):
    rule = staticmethod(include_rules.library_place)

    def test_libraries_in_their_places_are_kept(self):
        self.kept(
            self.rule,
            {
                "ui/render/a.cpp": "#include <epoxy/gl.h>\n#include <stb_image_write.h>\n",
                "ui/panels/a.cpp": "#include <imgui.h>\n",
                "ui/shell/a.cpp": "#include <GLFW/glfw3.h>\n#include <imgui_impl_glfw.h>\n",
                "skinning/a.cpp": "#include <Eigen/Core>\n#include <embree3/rtcore.h>\n",
                "core/gltf/a.cpp": "#include <stb/stb_image.h>\n",
            },
        )

    def test_graphics_stay_in_ui(self):
        for line in ("epoxy/gl.h", "GLFW/glfw3.h", "imgui.h", "imgui_internal.h"):
            self.broken(self.rule, {"app/a.cpp": f"#include <{line}>\n"}, "app/a.cpp:1:")

    def test_panels_draw_no_opengl_and_the_renderer_no_widgets(self):
        self.broken(self.rule, {"ui/panels/a.cpp": "#include <epoxy/gl.h>\n"}, "ui/panels/a.cpp:1: OpenGL")
        self.broken(self.rule, {"ui/render/a.cpp": "#include <imgui.h>\n"}, "ui/render/a.cpp:1: Dear ImGui")

    def test_pictures_are_read_in_sources_only(self):
        self.broken(self.rule, {"core/gltf/a.h": "#include <stb/stb_image.h>\n"}, "core/gltf/a.h:1:")
        self.broken(self.rule, {"rig/a.cpp": "#include <tiny_gltf.h>\n"}, "rig/a.cpp:1:")

    def test_geometry_libraries_stay_in_skinning(self):
        self.broken(self.rule, {"rig/a.cpp": "#include <Eigen/Core>\n"}, "rig/a.cpp:1:")

    def test_geometry_libraries_reach_no_other_room_through_headers(self):
        files = {
            "skinning/inner.h": "#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>\n",
            "skinning/outer.h": '#include "skinning/inner.h"\n',
            "skinning/a.cpp": '#include "skinning/outer.h"\n',
        }
        self.kept(self.rule, files)
        self.broken(self.rule, files | {"app/a.cpp": '#include "skinning/outer.h"\n'}, "app/a.cpp:1: skinning/outer.h")


class Text(LintTest):
    def test_long_files_are_found(self):
        self.kept(text_rules.file_size, {"core/a.cpp": "\n" * 600, "build/a.cpp": "\n" * 900})
        self.broken(text_rules.file_size, {"core/a.cpp": "\n" * 601}, "core/a.cpp: 601 lines")

    def test_marks_of_unfinished_work_are_found(self):
        self.kept(text_rules.open_ends, {"core/a.cpp": "// methodology, todos\n"})
        for mark in ("TO" + "DO", "FIX" + "ME"):
            self.broken(text_rules.open_ends, {"ui/a.cpp": f"\n// {mark}: later\n"}, "ui/a.cpp:2:")

    def test_one_for_each_is_said_in_full(self):
        self.kept(text_rules.distributive, {"core/a.h": "/// One for each bone; one a user names. 24 frames per second.\n"})
        for text in ("One a bone", "one a vertex", "24 frames a second", "Bytes a frame"):
            self.broken(text_rules.distributive, {"core/a.h": f"/// {text}\n"}, "core/a.h:1:")

    def test_folders_of_one_machine_are_found(self):
        self.kept(text_rules.machine_paths, {"README.md": "see docs/home/index and $HOME/x\n"})
        self.broken(text_rules.machine_paths, {"README.md": "run /ho" + "me/someone/x\n"}, "README.md:1:")

    def test_headers_need_their_guard(self):
        self.kept(text_rules.pragma_once, {"core/a.h": "#pragma once\n", "core/a.cpp": "\n"})
        self.broken(text_rules.pragma_once, {"core/a.h": "#ifndef A\n#endif\n"}, "core/a.h:")

    def test_names_that_ctest_splits_are_found(self):
        self.kept(text_rules.test_names, {"tests/core/a_test.cpp": 'TEST_CASE("one, two") { run(); }\n'})
        self.broken(text_rules.test_names, {"tests/core/a_test.cpp": 'TEST_CASE("one; two") {\n'}, "tests/core/a_test.cpp:1:")
        self.broken(text_rules.test_names, {"tests/core/a_test.cpp": '\nTEST_CASE(\n  "one "\n  "two; three") {\n'}, "tests/core/a_test.cpp:2:")
        self.broken(text_rules.test_names, {"tests/core/a_test.cpp": 'TEST_CASE(\n    "--loops marks all") {\n'}, "tests/core/a_test.cpp:1:")

    def test_clocks_and_chance_are_found_below_the_interface(self):
        self.kept(text_rules.clocks_and_chance, {"ui/a.cpp": "std::chrono::steady_clock::now();\n"})
        self.broken(text_rules.clocks_and_chance, {"rig/a.cpp": "std::random_device seed;\n"}, "rig/a.cpp:1:")


class ClangTidyRun(unittest.TestCase):
    """What run_clang_tidy.py remembers, and what it checks together; clang-tidy itself is not needed."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.write("core/a.h", "int a();\n")
        self.write("core/b.h", '#include "core/a.h"\n')
        self.write("core/c.cpp", '#include "core/b.h"\n')
        self.write("core/d.cpp", "int d() { return 4; }\n")

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def key(self, name, options=("-DA",), configuration="1"):
        return run_clang_tidy.Keys(self.root, configuration).key(name, options)

    def test_a_file_is_checked_again_when_anything_that_it_reaches_changes(self):
        before = self.key("core/c.cpp")
        self.assertEqual(self.key("core/c.cpp"), before)
        other = self.key("core/d.cpp")
        self.write("core/a.h", "int a(int);\n")
        self.assertNotEqual(self.key("core/c.cpp"), before)
        self.assertEqual(self.key("core/d.cpp"), other)

    def test_a_file_is_checked_again_with_other_options_or_another_configuration(self):
        before = self.key("core/d.cpp")
        self.assertNotEqual(self.key("core/d.cpp", options=("-DB",)), before)
        self.assertNotEqual(self.key("core/d.cpp", configuration="2"), before)

    def test_sources_that_share_a_local_name_or_differ_in_options_are_checked_apart(self):
        self.write("core/e.cpp", "double d(int x) {\n  return x;\n}\n")
        sources = [
            run_clang_tidy.Source(self.root / name, options, "")
            for name, options in (("core/c.cpp", ()), ("core/d.cpp", ()), ("core/e.cpp", ()), ("core/a.h", ("-DA",)))
        ]
        batches = [[source.file.name for source in batch] for batch in run_clang_tidy.batches_of(sources)]
        self.assertEqual(batches, [["c.cpp", "d.cpp"], ["e.cpp"], ["a.h"]])


class Turns(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        root = pathlib.Path(folder.name)
        for name in ("core/a.cpp", "core/a.h", "core/b.cpp", "core/c.cpp", "core/d.cpp", "core/e.h"):
            (root / name).parent.mkdir(exist_ok=True)
            (root / name).write_text('#include "core/e.h"\n' if name == "core/d.cpp" else "\n", encoding="utf-8")
        self.files = {file.name: file for file in sources.code_files(root) if file.suffix == ".cpp"}

    def test_five_turns_reach_every_source_once(self):
        reached = [name for turn in range(turns.TURNS) for name in turns.chosen(self.files, [], turn)]
        self.assertEqual(sorted(reached), sorted(self.files))

    def test_what_changed_comes_first_a_header_by_a_source_that_reads_it(self):
        changed = ["core/e.h", "docs/a.md", "core/gone.cpp", "core/a.h"]
        for turn in range(turns.TURNS):
            self.assertEqual(sorted(turns.chosen(self.files, changed, turn)[:2]), ["core/a.cpp", "core/d.cpp"])

    def test_of_many_changed_ones_others_are_first_in_every_turn(self):
        files = {f"core/{number}.cpp": None for number in range(50)}
        first = {turns.chosen(files, list(files), turn)[0] for turn in range(turns.TURNS)}
        self.assertEqual(len(first), turns.TURNS)


class Pointers(LintTest):
    rule = staticmethod(pointer_rules.pointers)
    pages = {"docs/rig.md": "# The rig\n\n## Bind leaves\n\n## The work: what is kept\n"}

    def test_pointers_that_land_are_kept(self):
        good = {
            "rig/a.h": "/// Leaves (docs/rig.md, Bind\n/// leaves): one for each joint. See docs/rig.md.\n",
            "app/a.cpp": "// docs/rig.md, The work\n",
            "README.md": "[the rig](docs/rig.md), Bind leaves\n",
            "docs/a.md": "[rig.md](rig.md), The rig; a scheme of rig.md\n",
        }
        self.kept(self.rule, self.pages | good)

    def test_missing_pages_and_headings_are_found(self):
        for text in ("/// docs/body.md\n", "/// docs/rig.md, Leaves\n", "/// docs/rig.md, Bind\n/// leaf\n", "/// docs/rig.md, Bind leavesmen\n"):
            self.broken(self.rule, self.pages | {"rig/a.h": "\n" + text}, "rig/a.h:2: ")
        self.broken(self.rule, self.pages | {"docs/a.md": "[x](body.md)\n"}, "docs/a.md:1: points to body.md")

    def test_pages_that_are_not_shipped_are_found(self):
        for text in ("spec/rig.md, Parts", "`commands.md`, info", "section 7", 'Section "Words"'):
            self.broken(self.rule, self.pages | {"rig/a.h": f"/// {text}\n"}, "rig/a.h:1: ")


class Examples(unittest.TestCase):
    options = {"info": {"--help", "--json"}, "exaggerate": {"--help", "--limb"}}

    def test_examples_stand_in_code_blocks_and_may_go_on_in_the_next_line(self):
        text = "./run info prose\n\n    ./run info A.glb # a comment\n```\nstretch-engine exaggerate A.glb \\\n  --limb neck\n```\n"
        expected = [["info", "A.glb"], ["exaggerate", "A.glb", "--limb", "neck"]]
        self.assertEqual(command_line.examples_of(text), expected)

    def test_unknown_verbs_and_options_are_found(self):
        for good in (["info", "A.glb", "--json"], ["A.glb"]):
            self.assertEqual(command_line.problem_with(good, self.options), "")
        self.assertIn("no verb", command_line.problem_with(["inform", "A.glb"], self.options))
        self.assertIn("--limb", command_line.problem_with(["info", "A.glb", "--limb", "neck"], self.options))


@unittest.skipIf(shutil.which("clang-format") is None, "clang-format is not installed")
class Formatting(LintTest):
    def test_unformatted_code_is_found(self):
        style = {".clang-format": "BasedOnStyle: LLVM\n"}
        self.kept(format_rule.formatting, style | {"core/a.cpp": "int a = 1;\n"})
        self.broken(format_rule.formatting, style | {"core/a.cpp": "int a = 1;\nint   b=2;\n"}, "core/a.cpp:2:")

    def test_what_was_clean_is_looked_at_again_when_it_or_the_style_changes(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("build", "core"):
                (root / name).mkdir()
            source, style = root / "core/a.cpp", root / ".clang-format"

            def count(code, column_limit):
                source.write_text(code, encoding="utf-8")
                style.write_text(f"BasedOnStyle: LLVM\nColumnLimit: {column_limit}\n", encoding="utf-8")
                return len(format_rule.formatting(folder))

            self.assertEqual([count("int a = 1;\n", 80), count("int a = 1;\n", 80)], [0, 0])
            self.assertEqual([count("int   a = 1;\n", 80), count("int   a = 1;\n", 80)], [1, 1])
            self.assertEqual([count("int a = 1 + 2;\n", 80), count("int a = 1 + 2;\n", 12)], [0, 1])


if __name__ == "__main__":
    unittest.main()
