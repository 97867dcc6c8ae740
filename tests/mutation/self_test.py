#!/usr/bin/env python3
"""Plants faults in a small made-up tree and asks whether the measure tells the dead from the living."""

import contextlib
import io
import pathlib
import tempfile
import unittest

import draw
import operators
import table
import trials
from mutants import Mutant, Tree, read_mutants
from plant import Planting, planted
from source_text import Source

HERE = pathlib.Path(__file__).resolve().parent

LIMB = """namespace stretch {
// The longer of two limbs, in metres.
double longer(double a, double b) {
  if (a < b) { // a comment with (brackets
    return b;
  }
  return a;
}
void count(int& calls) {
  calls += 1;
}
int frames(int first, int last) {
  return last - first + 1;
}
const int rates[] = {24, 30};
int rate(int which) {
  return rates[which];
}
constexpr int most = 3;
static_assert(most == 3);
}
"""
# A program whose only argument says what it asks for.
TEST = """#include <cstring>
namespace stretch { double longer(double, double); int frames(int, int); int rate(int); void count(int&); }
int main(int, char** arguments) {
  if (std::strcmp(arguments[1], "longer") == 0) return stretch::longer(1.0, 2.0) == 2.0 ? 0 : 1;
  if (std::strcmp(arguments[1], "rate") == 0) return stretch::rate(0) == 24 ? 0 : 1;
  if (std::strcmp(arguments[1], "hang") == 0) while (stretch::frames(1, 2) != 2) {}
  int calls = 0;
  stretch::count(calls);
  return 0;
}
"""


def tree_of(folder, files):
    for name, text in files.items():
        path = pathlib.Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return Tree(folder, ("core",))


class WhatALineBecomes(unittest.TestCase):
    def becomes(self, line):
        source = Source(line, frozenset({".right", ".left"}))
        made = {}
        for name, begin, end, text in operators.candidates(source, 0):
            made.setdefault(name, set()).add("gone" if text is None else line[:begin] + text + line[end:])
        return made

    def test_a_comparison_moves_at_its_edge(self):
        self.assertIn("return a <= b;", self.becomes("return a < b;")["edge"])

    def test_the_frame_that_is_counted_in_is_dropped(self):
        self.assertIn("return last - first;", self.becomes("return last - first + 1;")["term dropped"])

    def test_a_member_goes_missing_from_a_comparison(self):
        self.assertIn("return a.x == b.x;", self.becomes("return a.x == b.x && a.y == b.y;")["member missing"])

    def test_a_clamp_is_lost(self):
        self.assertIn("x = (value);", self.becomes("x = std::clamp(value, 0.0, 1.0);")["clamp lost"])

    def test_sides_are_swapped_where_the_other_one_is_known(self):
        self.assertIn("x = limb.right;", self.becomes("x = limb.left;")["sides"])
        self.assertNotIn("sides", self.becomes("x = limb.upper;"))

    def test_a_guard_lets_through_and_a_function_keeps_its_value(self):
        source = Source("int f(int a) {\n  if (a < 0) {\n    return 0;\n  }\n  return a;\n}\nint g() {\n  return 1;\n}\n")
        gone = [line for line in range(9) if any(text is None for _, _, _, text in operators.candidates(source, line))]
        self.assertEqual(gone, [2])

    def test_an_entry_of_a_constant_table_is_left_alone(self):
        source = Source("constexpr auto table = make({\n    {1, 2},\n    more(3, 4),\n});\nconst int other = make({\n    {1, 2}});\n")
        self.assertEqual([bool(operators.candidates(source, line)) for line in range(6)], [False, False, False, False, False, True])

    def test_a_template_is_no_comparison(self):
        self.assertNotIn("edge", self.becomes("std::vector<int> all;"))

    def test_memory_asked_for_beforehand_is_left_alone(self):
        self.assertEqual(self.becomes("points.reserve(count);"), {})
        self.assertIn("statement gone", self.becomes("points.clear();"))

    def test_what_only_the_compiler_sees_is_left_alone(self):
        for line in ("static_assert(most == 3);", "case 1:", "constexpr int most = 3;", "// a < b", "#if a < b"):
            self.assertEqual(self.becomes(line), {}, line)


class WhereItStands(unittest.TestCase):
    def mutant(self, line, becomes, text=LIMB):
        with tempfile.TemporaryDirectory() as folder:
            return tree_of(folder, {"core/moved/limb.cpp": text}).locate(Mutant("core/limb.cpp", line, becomes, number=5))

    def test_a_file_that_moved_is_found_by_the_line(self):
        self.assertEqual(self.mutant("return b;", "return a;").file, "core/moved/limb.cpp")

    def test_a_line_that_is_gone_is_told(self):
        self.assertIsNone(self.mutant("return c;", "return a;"))

    def test_an_expression_is_written_twice_and_keeps_its_lines(self):
        mutant = self.mutant("if (a < b) { // a comment with (brackets", "if (a <= b) { // a comment with (brackets")
        text, spans, out = planted(Source(LIMB), [mutant])
        self.assertIn("if ((::stretch::mutant(5) ? (a <= b) : (a < b))) {", text)
        self.assertEqual((text.count("\n"), out), (LIMB.count("\n"), []))

    def test_a_condition_stays_one_where_a_part_of_it_is_left(self):
        for line, changed, planted_as in (
            ("x = held || other;", "x = held;", "x = (::stretch::mutant(5) ? bool(held) : (held || other));"),
            ("x = f(a || b) + c;", "x = f(a || b) - c;", "x = (::stretch::mutant(5) ? (f(a || b) - c) : (f(a || b) + c));"),
        ):
            text, _, _ = planted(Source(line), [self.mutant(line, changed, line)])
            self.assertEqual(text, planted_as)

    def test_a_change_over_two_brackets_takes_both(self):
        for line, changed, region in (
            ("x = 2.0 / ((a + b) / c + (d + e) / f);", "x = 2.0 / ((b + b) / c + (e + e) / f);", "(a + b) / c + (d + e) / f"),
            ("call(a, b, c);", "call(a, c, b);", "call(a, b, c)"),
            ("x = a ? b : c;", "x = a ? c : b;", "a ? b : c"),
        ):
            source, mutant = Source(line), self.mutant(line, changed, line)
            self.assertEqual(line[slice(*source.expression(mutant.begin, mutant.end))], region)

    def test_entries_of_a_list_in_braces_are_left_alone(self):
        mutant = self.mutant("f({a, b});", "f({b, a});", "f({a, b});")
        self.assertIsNone(Source("f({a, b});").expression(mutant.begin, mutant.end))

    def test_a_statement_that_is_gone_is_written_once(self):
        text, _, _ = planted(Source(LIMB), [self.mutant("calls += 1;", "")])
        self.assertIn("if (::stretch::mutant(5)) {  } else { calls += 1; }", text)

    def test_mutants_of_one_expression_stand_in_one_another(self):
        mutants = [self.mutant("return last - first + 1;", line) for line in ("return last - first;", "return last + first + 1;")]
        mutants[1].number = 6
        text, _, _ = planted(Source(LIMB), mutants)
        self.assertIn("mutant(5)", text)
        self.assertIn("mutant(6)", text)
        self.assertEqual(text.count("(last - first + 1)"), 1)


class WhatIsDrawn(unittest.TestCase):
    def drawn(self, text, under=()):
        with tempfile.TemporaryDirectory() as folder:
            tree = tree_of(folder, {"core/limb.cpp": text, "core/gltf/limb.cpp": text})
            return [(one.file, *one.key) for one in draw.drawn(tree, "1", "core", 4, under=under)]

    def test_the_same_seed_draws_the_same(self):
        self.assertEqual(self.drawn(LIMB), self.drawn(LIMB))

    def test_a_line_that_comes_in_front_changes_nothing(self):
        self.assertEqual(self.drawn(LIMB), self.drawn("// one more\n" + LIMB))

    def test_a_folder_alone_is_drawn_from(self):
        self.assertEqual({file for file, *_ in self.drawn(LIMB, under=["core/gltf"])}, {"core/gltf/limb.cpp"})
        self.assertEqual({file for file, *_ in self.drawn(LIMB)}, {"core/limb.cpp", "core/gltf/limb.cpp"})


class TheWholeWay(unittest.TestCase):
    """One mutant of each fate, planted at once, built once."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        root = pathlib.Path(self.folder.name)
        self.tree = tree_of(root, {"core/limb.cpp": LIMB, "test.cpp": TEST})
        wanted = [
            ("return b;", "return a;"),  # dies
            ("calls += 1;", ""),  # lives
            ("return last - first + 1;", "return last - first;"),  # hangs
            ("return a;", "return nowhere;"),  # does not compile
            ("const int rates[] = {24, 30};", "const int rates[] = {25, 30};"),  # in a table: dies
            ("constexpr int most = 3;", "constexpr int most = 4;"),  # the compiler's: does not compile
        ]
        mutants = [self.tree.locate(Mutant("core/limb.cpp", *pair, number=number)) for number, pair in enumerate(wanted)]
        self.planting = Planting(self.tree, root / "build", HERE / "mutant.h")
        self.planting.plant(mutants)
        self.planting.copied_beside("test.cpp")
        self.program = root / "build/test_core"
        sources = [str(self.planting.copy / name) for name in ("core/limb.cpp", "test.cpp")]
        self.planting.build(["c++", "-std=c++20", "-include", str(HERE / "mutant.h"), *sources, "-o", str(self.program)])
        self.mutants = self.planting.mutants

    def tearDown(self):
        self.folder.cleanup()

    def test_each_mutant_has_its_fate(self):
        self.assertEqual(sorted(one.becomes for one in self.planting.dropped), ["constexpr int most = 4;", "return nowhere;"])
        names = ("longer", "hang", "else", "rate")
        cases = [trials.Case(name, [str(self.program), name], self.folder.name, ["core"]) for name in names]
        cases = trials.traced(cases, self.folder.name + "/notes", 1)
        self.assertEqual([sorted(case.passes) for case in cases], [[0, 4], [1, 2, 4], [1, 4], [4]])
        for case in cases:
            case.seconds = -1.6  # So that what hangs is given a second.
        fates = {one.number: trials.tried(one, cases, 60) for one in self.mutants}
        self.assertEqual([fates[number][0] for number in (0, 1, 2, 4)], ["killed", "alive", "killed", "killed"])
        unasked = [case for case in cases if case.name == "longer"]
        self.assertEqual(trials.tried(self.mutants[1], unasked, 60)[0], "unreached")

    def test_a_room_under_its_goal_is_told(self):
        one = self.mutants[0]
        for fate, equivalent, missed in (("alive", {}, 1), ("killed", {}, 0), ("alive", {one.key: "the same"}, 0)):
            with contextlib.redirect_stdout(io.StringIO()):
                self.assertEqual(table.told([one], {one.number: (fate, "")}, equivalent, []), missed)


class TheData(unittest.TestCase):
    def test_each_mutant_of_the_data_says_what_it_is(self):
        for name in ("written.jsonl", "equivalent.jsonl"):
            for mutant in read_mutants(HERE / name):
                self.assertTrue(mutant.says.endswith("."), mutant)
                self.assertNotEqual(mutant.line, mutant.becomes)


if __name__ == "__main__":
    unittest.main()
