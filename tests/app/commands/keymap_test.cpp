#include <catch2/catch.hpp>

#include <set>

#include "app/commands/table/document_commands.h"
#include "app/commands/table/keymap.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/key_tables.h"

using namespace stretch::app;
namespace test = stretch::test;
using stretch::gltf::Json;

TEST_CASE("Keys are read and written by the same names") {
  for (const Key key : test::allKeys()) {
    const Chord chord{key, true, true, false};
    INFO(chordText(chord));
    CHECK(parseChord(chordText(chord)) == chord);
  }
  CHECK(parseChord("ctrl+shift+z") == Chord{Key{'Z'}, true, true, false});
  CHECK(parseChord("Alt+,") == Chord{Key::comma, false, false, true});
  CHECK(parseChord("?") == Chord{Key::slash, false, true, false});
  CHECK(chordText({Key::slash, false, true, false}) == "?");
  CHECK_FALSE(parseChord(""));
  CHECK_FALSE(parseChord("Ctrl+"));
  CHECK_FALSE(parseChord("Hyper+X"));
  CHECK_FALSE(parseChord("Banana"));
}

TEST_CASE("No key of a document command is bound twice, and every command has help") {
  const auto commands = documentCommands();
  CHECK(test::keyProblems(keyedCommands(commands)).empty());
  std::set<std::string> ids;
  for (const auto& command : commands) {
    INFO(command.id);
    CHECK(ids.insert(command.id).second);
    CHECK_FALSE(command.label.empty());
    CHECK(command.help.size() > 10);
    CHECK(command.help.back() == '.');
    CHECK((command.enabled || command.enabledOnSequence));
    CHECK(static_cast<bool>(command.enabled) == static_cast<bool>(command.run));
    CHECK(static_cast<bool>(command.enabledOnSequence) == static_cast<bool>(command.runOnSequence));
  }
}

TEST_CASE("A key bound twice is told with both names") {
  const auto problems = test::keyProblems({{"a", {"Ctrl+K"}}, {"b", {"ctrl+k"}}, {"c", {"Nonsense"}}});
  REQUIRE(problems.size() == 2);
  CHECK(problems[0] == "Ctrl+K is bound to a and to b");
}

TEST_CASE("Changing a key takes it from the command that had it and tells which") {
  Keymap keymap({{"a", {"K", "F5"}}, {"b", {"L"}}});
  const auto loser = keymap.rebind("b", parseChord("K"));
  REQUIRE(loser);
  CHECK(*loser == "a");
  CHECK(keymap.commandOf({Key{'K'}}) == "b");
  CHECK(keymap.commandOf({Key{'L'}}).empty());
  CHECK(keymap.commandOf({static_cast<Key>(static_cast<int>(Key::f1) + 4)}) == "a");
  CHECK_FALSE(keymap.rebind("z", parseChord("K")));

  SECTION("a command can be left without a key") {
    REQUIRE(keymap.rebind("b", std::nullopt));
    CHECK(keymap.chordsOf("b").empty());
  }
  SECTION("and everything put back") {
    keymap.resetToDefaults();
    CHECK(keymap.commandOf({Key{'K'}}) == "a");
  }
  SECTION("changed keys survive the file") {
    Keymap read({{"a", {"K", "F5"}}, {"b", {"L"}}});
    REQUIRE(read.readJson(keymap.toJson()));
    CHECK(read.commandOf({Key{'K'}}) == "b");
    CHECK(read.toJson() == keymap.toJson());
  }
}

TEST_CASE("What is no file of keys is refused") {
  Keymap keymap({{"a", {"K"}}, {"b", {"L"}}});
  CHECK_FALSE(keymap.readJson("not json"));
  CHECK_FALSE(keymap.readJson("[]"));
  CHECK(keymap.commandOf({Key{'K'}}) == "a");
  CHECK_FALSE(keymap.isChanged());
}

TEST_CASE("What is not understood in a file of keys is told and written again, the rest is taken") {
  for (const char* const entry : {R"("z": ["N"])", R"("b": ["Banana"])", R"("b": "N")"}) {
    CAPTURE(entry);
    Keymap keymap({{"a", {"K"}}, {"b", {"L"}}, {"c", {}}});
    const auto read = keymap.readJson(R"({"keys": {"a": ["M"], )" + std::string(entry) + "}}");
    REQUIRE_FALSE(read);
    CHECK(read.error().where == std::string(1, entry[1]));
    CHECK(keymap.commandOf({Key{'M'}}) == "a");
    CHECK(keymap.commandOf({Key{'L'}}) == "b");
    REQUIRE(keymap.rebind("c", parseChord("P")));
    const Json written = Json::parse(keymap.toJson())["keys"];
    CHECK(written.size() == 3);
    CHECK(written[std::string(1, entry[1])] == Json::parse("{" + std::string(entry) + "}").front());
    CHECK(Json::parse(keymap.toJson(true))["keys"].size() == 3);
    REQUIRE(keymap.rebind("b", parseChord("Q")));
    Keymap again({{"a", {"K"}}, {"b", {"L"}}, {"c", {}}});
    CHECK(static_cast<bool>(again.readJson(keymap.toJson())) == (entry[1] == 'b'));
    CHECK(again.commandOf({Key{'Q'}}) == "b");
  }
  Keymap keymap(std::vector<KeyedCommand>{{"a", {"K"}}});
  const auto read = keymap.readJson(R"({"keys": {"y": ["N"], "z": ["N"]}})");
  REQUIRE_FALSE(read);
  CHECK(read.error().what == "2 entries are not understood");
  keymap.resetToDefaults();
  CHECK(Json::parse(keymap.toJson())["keys"].empty());
}

TEST_CASE("What a file of keys says of a command that nobody understands goes with the key that it loses") {
  const auto fresh = [] { return Keymap({{"a", {"K"}}, {"b", {"L"}}, {"c", {}}}); };
  Keymap keymap = fresh();
  REQUIRE_FALSE(keymap.readJson(R"({"keys": {"b": ["Banana"], "c": "N"}})"));
  const auto loser = keymap.rebind("a", parseChord("L"));
  REQUIRE(loser);
  REQUIRE(*loser == "b");
  const Json written = Json::parse(keymap.toJson())["keys"];
  CHECK(written["b"] == Json::array());
  CHECK(written["c"] == "N"); // had no part in it
  Keymap again = fresh();
  CHECK_FALSE(again.readJson(keymap.toJson()));
  CHECK(again.commandOf({Key{'L'}}) == "a");
  CHECK(again.chordsOf("b").empty());
}
