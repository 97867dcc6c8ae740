#!/usr/bin/env python3
"""Shows each rule of the lint a tree that keeps it and trees that break it."""

import pathlib
import shutil
import tempfile
import unittest

import command_line
import format_rule
import include_rules
import pointer_rules
import text_rules


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

    def test_clocks_and_chance_are_found_below_the_interface(self):
        self.kept(text_rules.clocks_and_chance, {"ui/a.cpp": "std::chrono::steady_clock::now();\n"})
        self.broken(text_rules.clocks_and_chance, {"rig/a.cpp": "std::random_device seed;\n"}, "rig/a.cpp:1:")


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


if __name__ == "__main__":
    unittest.main()
