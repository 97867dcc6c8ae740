#include <map>
#include <set>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/commands/keys/keys.h"
#include "app/commands/table/selection.h"
#include "app/files/saved_work.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/recorded.h"
#include "tests/support/refusal.h"
#include "ui/viewport/tools.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// A tool as it begins on the boxer.
struct Beginning {
  const char* name;
  Status (*start)(app::Session&, Tool&);
};

void addPunch(app::Session& session) {
  session.edit(test::withNewTrail(session.document(), {.startFrame = 2.0, .endFrame = 12.0}), "Exaggerate");
  app::selectTrail(session, session.document().trails.front().id);
}

Status startOnKeys(app::Session& session, Tool& tool, bool scales) {
  app::selectLimb(session, "left-arm", false);
  const std::vector<app::KeyRow> rows = app::rowsOfSelection(session);
  app::pickKeys(session, app::keysBetween(session.document(), 0, rows, 4.0, 11.0), false);
  app::KeysModal modal;
  modal.kind = scales ? app::KeysModal::Kind::scale : app::KeysModal::Kind::move;
  modal.aboutFrame = 6.0;
  return startKeys(session, tool, modal);
}

Status startOnControllers(app::Session& session, Tool& tool, app::PullMotion motion) {
  session.view().frame = 8.0;
  app::selectControllers(session, {"left-hand", "right-hand"});
  return startControllerTool(session, tool, {motion, {}, {400.0, 300.0}, false});
}

const Beginning beginnings[] = {
    {"exaggerate",
     [](app::Session& session, Tool& tool) {
       session.view().rangeEnd = 10.0;
       app::selectLimb(session, "left-arm", false);
       return startExaggerate(session, tool);
     }},
    {"grab a sphere",
     [](app::Session& session, Tool& tool) {
       addPunch(session);
       session.view().selection.editTrails().spheres = {
           app::placedSpheres(session, session.view().selection.trail())[1].frame};
       return startGrab(session, tool, {});
     }},
    {"move keys", [](app::Session& session, Tool& tool) { return startOnKeys(session, tool, false); }},
    {"scale keys", [](app::Session& session, Tool& tool) { return startOnKeys(session, tool, true); }},
    {"move controllers", [](app::Session& session,
                            Tool& tool) { return startOnControllers(session, tool, app::PullMotion::move); }},
    {"turn controllers", [](app::Session& session,
                            Tool& tool) { return startOnControllers(session, tool, app::PullMotion::turn); }},
};

std::vector<std::string> keysToTry() {
  std::vector<std::string> keys{"Tab",      "Shift+Tab",  "Left",      "Right",   "Up",      "Down",
                                "Shift+Up", "Ctrl+Right", "Backspace", ".",       "-",       ",",
                                "0",        "7",          "Space",     "Shift+X", "Shift+Y", "Shift+Z"};
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    keys.emplace_back(1, letter);
  }
  return keys;
}

std::string toolText(const Tool& tool) {
  EditorStatus status;
  describeTool(tool, status);
  return status.modalText.empty() ? "over" : status.modalText;
}

std::string hintsText(const Tool& tool) {
  EditorStatus status;
  describeTool(tool, status);
  std::string text;
  for (const KeyHint& hint : status.keyHints) {
    text += " " + hint.key + " = " + hint.does + " ,";
  }
  return text;
}

std::set<std::string> workLines(const app::Session& session) {
  const gltf::Json work = app::workOf(session.document());
  std::set<std::string> lines;
  if (work.is_structured()) {
    const gltf::Json flat = work.flatten();
    for (const auto& [path, value] : flat.items()) {
      if (!path.starts_with("/limbs")) {
        lines.insert(path + " " + value.dump());
      }
    }
  }
  return lines;
}

/// The key, then "2", then Enter: what the tool says after each, and what is different at the end from where
/// nothing but Enter is pressed.
std::string pressedText(const Beginning& beginning, const std::string& key,
                        const std::set<std::string>& plain) {
  app::Session session{test::boxer()};
  Tool tool;
  REQUIRE(beginning.start(session, tool));
  std::string text;
  for (const std::string& pressed : {key, std::string("2"), std::string("Enter")}) {
    const Status done = pressToolKey(session, tool, {*app::parseChord(pressed), 0});
    text += "   " + toolText(tool) + (done ? "" : " , " + done.error().line()) + "\n";
  }
  for (const std::string& line : workLines(session)) {
    text += plain.contains(line) ? "" : "   + " + line + "\n";
  }
  return text + "   step : " + session.history().undoLabel() + "\n";
}

} // namespace

TEST_CASE("What each key does in each tool is as it was looked at") {
  std::string text;
  for (const Beginning& beginning : beginnings) {
    app::Session session{test::boxer()};
    Tool tool;
    const Status started = beginning.start(session, tool);
    INFO(beginning.name << ": " << test::refusal(started));
    REQUIRE(started);
    text += fmt::format("{} : {}\n  hints{}\n", beginning.name, toolText(tool), hintsText(tool));
    REQUIRE(pressToolKey(session, tool, {*app::parseChord("Enter"), 0}));
    const std::set<std::string> plain = workLines(session);
    for (const std::string& line : plain) {
      text += "  " + line + "\n";
    }
    std::map<std::string, std::string> firstOf; // of what is done: the key that did it first
    for (const std::string& key : keysToTry()) {
      const std::string done = pressedText(beginning, key, plain);
      const auto [known, isNew] = firstOf.try_emplace(done, key);
      text += "  " + key + (isNew ? "\n" + done : " : as " + known->second + "\n");
    }
  }
  const std::string difference = test::differenceFromRecord("keys-in-tools", text, 1e-4);
  INFO(difference);
  CHECK(difference.empty());
}
