#!/usr/bin/env python3
"""Shows each rule that holds what was won a tree that keeps it and trees that break it."""

import unittest

import allowances
import comment_rules
import shape_rules
import size_rules
from self_test import LintTest


class FolderSize(LintTest):
    rule = staticmethod(size_rules.folder_size)

    def folder(self, count):
        return {f"rig/motion/part_{number}.h": "#pragma once\n" for number in range(count)}

    def test_forty_files_of_code_fit_and_others_do_not_count(self):
        self.kept(self.rule, self.folder(40) | {"rig/motion/notes.md": "a\n", "rig/motion/deeper/a.h": "\n"})

    def test_one_more_is_found(self):
        self.broken(self.rule, self.folder(41), "rig/motion: 41 files of code; at most 40")

    def test_an_exception_holds_its_own_figure(self):
        exception = {"tests/lint/allowed/folder-size.txt": "# why\n42 rig/motion: is being cut\n"}
        self.kept(self.rule, self.folder(42) | exception)
        self.broken(self.rule, self.folder(43) | exception, "rig/motion: 43 files of code; at most 42")

    def test_an_exception_without_a_reason_is_refused(self):
        exception = {"tests/lint/allowed/folder-size.txt": "42 rig/motion\n"}
        with self.assertRaises(allowances.Malformed):
            self.findings(self.rule, exception)


class ProductLines(LintTest):
    rule = staticmethod(size_rules.product_lines)
    page = {"docs/size.md": "**At most 1,003 lines** in the product.\n"}

    def test_lines_within_the_figure_are_kept_and_tests_do_not_count(self):
        self.kept(self.rule, self.page | {"rig/a.cpp": "\n" * 1000, "ui/a.h": "\n" * 3, "tests/a.cpp": "\n" * 9})

    def test_a_line_more_is_found(self):
        self.broken(self.rule, self.page | {"rig/a.cpp": "\n" * 1004}, "docs/size.md: the product has 1,004 lines, 1 more")

    def test_a_page_without_a_figure_is_found(self):
        self.broken(self.rule, {"docs/size.md": "Small.\n"}, "docs/size.md: says no figure")


class ReadmeWords(LintTest):
    rule = staticmethod(size_rules.readme_words)

    def test_targets_of_links_are_no_words(self):
        self.kept(self.rule, {"README.md": "word " * 599 + "[link](docs/a_page.md)\n"})

    def test_a_word_more_is_found(self):
        self.broken(self.rule, {"README.md": "word " * 601}, "README.md: 601 words; at most 600")


class RoomsNamed(LintTest):
    rule = staticmethod(size_rules.rooms_named)
    code = {"rig/ik/a.h": "\n", "rig/hold/a.h": "\n", "rig/a.h": "\n", "tests/rig/a.cpp": "\n"}

    def test_rows_name_a_folder_and_those_beside_it(self):
        self.kept(self.rule, self.code | {"ARCHITECTURE.md": "| `rig/ik`, `hold` | shapes; values |\n| `rig/` | the limb |\n"})

    def test_rooms_that_are_missing_or_gone_are_found(self):
        text = "| `rig/ik`, `tail` | shapes |\n| `rig/` | the limb |\n"
        self.broken(self.rule, self.code | {"ARCHITECTURE.md": text}, "ARCHITECTURE.md: does not say what rig/hold", "ARCHITECTURE.md: names rig/tail")

    def test_a_map_of_many_pages_is_found(self):
        text = "| `rig/ik`, `hold` | shapes |\n| `rig/` | the limb |\n" + "word " * 1600
        self.broken(self.rule, self.code | {"ARCHITECTURE.md": text}, "ARCHITECTURE.md: 160")


class StructMembers(LintTest):
    rule = staticmethod(shape_rules.struct_members)

    def struct(self, *members):
        return {"rig/a.h": "namespace n {\nstruct Pose {\n" + "\n".join(members) + "\n};\n}\n"}

    def test_functions_aliases_and_types_are_no_members(self):
        members = [f"  double m{number} = 0.0;" for number in range(24)]
        others = [
            "  std::map<int, std::vector<double>> map{{1, {2.0}}}; // a member",
            "  using Map = int;",
            "  enum class Side { left, right };",
            "  struct Part { int a; int b; };",
            "  static int count;",
            "  bool empty() const { int x = 1; return x; }",
            "  bool operator==(const Pose&) const = default;",
        ]
        self.kept(self.rule, self.struct(*members, *others))

    def test_the_twenty_sixth_is_found(self):
        members = [f"  double m{number};" for number in range(22)]
        extra = ["  int a, b;", "  std::function<void(int, int)> call;", "  std::vector<int> list{1, 2};"]
        self.broken(self.rule, self.struct(*members, *extra), "rig/a.h:2: Pose has 26 members")
        self.broken(self.rule, {"rig/a.h": self.struct(*members, *extra)["rig/a.h"].replace("struct Pose", "class Pose final : Base")}, "rig/a.h:2:")


class Parameters(LintTest):
    rule = staticmethod(shape_rules.parameter_count)

    def test_six_are_kept_whatever_stands_in_them(self):
        self.kept(self.rule, {"rig/a.cpp": "void f(int a, std::map<int, int> b, int c, int d, int e, std::function<void(int, int)> f) {\n}\n"})
        self.kept(self.rule, {"rig/a.cpp": "A::A(int a) : b_(1, 2, 3, 4, 5, 6, 7) {\n}\nint A::operator()(int a) const {\n}\n"})

    def test_seven_are_found(self):
        self.broken(self.rule, {"rig/a.cpp": "\nvoid A::f(int a, int b, int c, int d,\n int e, int f, int g) const {\n}\n"}, "rig/a.cpp:2: 7 parameters")
        self.broken(self.rule, {"rig/a.cpp": "A::A(int a, int b, int c, int d, int e, int f, int g) : a_(a) {\n}\n"}, "rig/a.cpp:1: 7")


class KindSwitches(LintTest):
    rule = staticmethod(shape_rules.kind_switches)
    kind = {"rig/limb.h": "enum class LimbKind { arm, leg };\n"}
    switch = "int f(LimbKind kind) {\n  switch (kind) {\n    case rig::LimbKind::arm:\n      return 1;\n  }\n}\n"

    def test_other_switches_are_kept(self):
        other = "int f(Side s) {\n  switch (s) {\n    case Side::left: return 1;\n  }\n}\n"
        self.kept(self.rule, self.kind | {"rig/a.cpp": other, "ui/a.cpp": other.replace("Side", "ToastKind"), "ui/a.h": "enum class ToastKind { a };\n"})

    def test_a_switch_over_a_kind_is_found_outside_its_table(self):
        self.broken(self.rule, self.kind | {"app/a.cpp": self.switch}, "app/a.cpp:2: switches over LimbKind")
        allowed = {"tests/lint/allowed/kind-switches.txt": "1 rig/table.cpp: the table\n"}
        self.kept(self.rule, self.kind | allowed | {"rig/table.cpp": self.switch})
        self.broken(self.rule, self.kind | allowed | {"rig/table.cpp": self.switch * 2}, "rig/table.cpp:2:", "rig/table.cpp:8:")


class SettingsJson(LintTest):
    rule = staticmethod(shape_rules.settings_json)
    schema = {"app/schema/a_schema.cpp": '{.name = "blend_in", .help = "x"}\n'}

    def test_the_schema_and_other_keys_are_kept(self):
        self.kept(self.rule, self.schema | {"app/schema/a_json.cpp": 'json["blend_in"]\n', "app/a.cpp": 'json["version"]; find("blend_in");\n'})

    def test_a_setting_by_hand_is_found(self):
        for text in ('json["blend_in"] = 1;\n', 'if (json.contains("blend_in")) {}\n', 'json.value("blend_in", 0.0);\n'):
            self.broken(self.rule, self.schema | {"app/recipe/a.cpp": text}, "app/recipe/a.cpp: JSON of settings by hand (blend_in)")


class SameBodies(LintTest):
    rule = staticmethod(shape_rules.same_bodies)
    body = "  double sum = 0.0;\n  for (double value : values) {\n    sum += value;\n  }\n  if (sum > limit) {\n    return limit;\n  }\n  return sum;\n}\n"

    def test_bodies_that_differ_are_kept(self):
        first = "double cut(const std::vector<double>& values) {\n" + self.body
        second = first.replace("sum += value", "sum -= value").replace("cut", "other")
        short = "int f() {\n  return 1;\n}\nint g() {\n  return 1;\n}\n"
        self.kept(self.rule, {"rig/a.cpp": first, "rig/b.cpp": second, "rig/c.cpp": short})

    def test_a_copy_under_other_names_is_found(self):
        first = "double cut(const std::vector<double>& values) {\n" + self.body
        second = first.replace("values", "lengths").replace("value ", "length ").replace("value;", "length;").replace("sum", "total").replace("cut", "within")
        self.broken(self.rule, {"rig/a.cpp": first, "skinning/b.cpp": "// Of lengths.\n" + second}, "skinning/b.cpp:2: has the body of rig/a.cpp:1")


class CommentOpenings(LintTest):
    rule = staticmethod(comment_rules.comment_openings)

    def test_comments_that_open_with_the_thing_are_kept(self):
        text = "/// Frames at which the foot stands,\n/// What goes on is no opening.\nint a; // Whatever is left.\n"
        self.kept(self.rule, {"rig/a.h": text, "rig/a.cpp": "// What a source says.\n"})

    def test_openings_that_hide_their_noun_are_found(self):
        for opening in ("What", "Whose", "Where", "Of", "As", "The same"):
            self.broken(self.rule, {"rig/a.h": f"/// {opening} a limb has.\n"}, "rig/a.h:1: opens with")
            self.broken(self.rule, {"rig/a.h": f"int a; ///< {opening} a limb has.\n"}, "rig/a.h:1: opens with")

    def test_a_room_keeps_its_figure(self):
        allowed = {"tests/lint/allowed/comment-openings.txt": "1 rig: the last ones\n"}
        self.kept(self.rule, allowed | {"rig/a.h": "// What it is.\n"})
        self.broken(self.rule, allowed | {"rig/a.h": "// What it is.\nint a; // What it was.\n"}, "rig/a.h:1:", "rig/a.h:2:")


if __name__ == "__main__":
    unittest.main()
