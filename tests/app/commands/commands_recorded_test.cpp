#include <map>
#include <set>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/group_edits.h"
#include "app/files/saved_work.h"
#include "app/open_document.h"
#include "app/things/place.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/recorded.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// Something open, and the pose or trail that was copied before.
struct Start {
  const char* name;
  void (*prepare)(Session&);
};

void addTrail(Session& session, const test::WantedTrail& wanted) {
  session.edit(test::withNewTrail(session.document(), wanted), "Exaggerate");
}

void withTrail(Session& session) {
  addTrail(session, {.startFrame = 2.0, .endFrame = 12.0});
  selectTrail(session, session.document().trails.front().id);
  session.view().frame = 6.0;
}

void withGroup(Session& session) {
  addTrail(session, {"left-arm", 2.0, 12.0, 2.0, true});
  addTrail(session, {"right-arm", 2.0, 12.0, 2.0, true});
  const std::vector<int> both{session.document().trails[0].id, session.document().trails[1].id};
  session.edit(*groupTrails(session.document(), both), "Group");
  selectGroup(session, both.front());
  session.view().frame = 12.0;
}

void withThings(Session& session) {
  const Result<Placed> made = place(session.document(), test::oneOfEach(0, 0.5), Entry::request);
  REQUIRE(made);
  session.edit(made->document, "Place");
  selectLimb(session, "right-arm", false);
  session.view().frame = 8.0;
}

const Start starts[] = {
    {"nothing selected", [](Session& session) { session.view().frame = 5.0; }},
    {"a limb selected",
     [](Session& session) {
       selectLimb(session, "left-arm", false);
       session.view().frame = 4.0;
       session.view().rangeStart = 2.0;
       session.view().rangeEnd = 14.0;
     }},
    {"a trail selected", withTrail},
    {"a sphere selected, a trail copied",
     [](Session& session) {
       withTrail(session);
       session.view().copiedTrail = session.document().trails.front();
       session.view().selection.editTrails().spheres = {7.0};
     }},
    {"a group selected", withGroup},
    {"things of every kind", withThings},
    {"controllers posed",
     [](Session& session) {
       withThings(session);
       selectControllers(session, {"left-hand", "right-elbow"});
     }},
    {"keys picked",
     [](Session& session) {
       selectLimb(session, "left-arm", false);
       const std::vector<KeyRow> rows = rowsOfSelection(session);
       session.view().keyRows = rows;
       pickKeys(session, keysBetween(session.document(), 0, rows, 4.0, 11.0), false);
     }},
    {"after an undo",
     [](Session& session) {
       withTrail(session);
       session.undo();
     }},
};

std::vector<std::string> workLines(const Session& session) {
  const gltf::Json work = workOf(session.document());
  std::vector<std::string> lines;
  if (work.is_structured()) {
    const gltf::Json flat = work.flatten();
    for (const auto& [path, value] : flat.items()) {
      if (!path.starts_with("/limbs")) { // as found, in every work
        lines.push_back(path + " " + value.dump());
      }
    }
  }
  return lines;
}

std::vector<std::string> viewLines(const Session& session) {
  const ViewState& view = session.view();
  const Selection& selection = view.selection;
  std::vector<std::string> lines{
      fmt::format("clip {} , frame {:.4f} , range {:.3f} {:.3f}", view.clip, view.frame, view.rangeStart,
                  view.rangeEnd),
      fmt::format("auto-key {} , whole clip {} , original {} , locators {} , mirror {}", view.autoKey,
                  view.wholeClip, view.showOriginal, view.showLocators, view.mirrorLocators),
      fmt::format("limbs {} , trail {} , controllers {}", listed(selection.limbs()), selection.trail(),
                  listed(selection.controllers())),
      fmt::format("trail copied {} , pose copied {} , keys copied {} , keys picked {} , unkeyed {}",
                  view.copiedTrail.has_value(), view.copiedPose.has_value(), view.copiedKeys.has_value(),
                  keyCount(view.pickedKeys), view.unkeyed.empty() ? "none" : "some")};
  std::string spheres = "spheres";
  for (const double frame : selection.spheres()) {
    spheres += fmt::format(" {:.3f}", frame);
  }
  lines.push_back(spheres);
  return lines;
}

/// Lines that are there now and were not, and those that were and are not; the first of them where they are
/// many.
std::string changeText(const std::vector<std::string>& before, const std::vector<std::string>& now) {
  constexpr std::size_t most = 12;
  std::string text;
  const auto add = [&](const char* mark, const std::vector<std::string>& some,
                       const std::vector<std::string>& others) {
    const std::set<std::string> known(others.begin(), others.end());
    std::size_t count = 0;
    for (const std::string& line : some) {
      if (!known.contains(line)) {
        text += ++count <= most ? fmt::format("   {} {}\n", mark, line) : "";
      }
    }
    text += count > most ? fmt::format("   {} {} in all\n", mark, count) : "";
  };
  add("+", now, before);
  add("-", before, now);
  return text;
}

std::string runText(const DocumentCommand& command, const Start& start) {
  OpenDocument open{Opened{Document(test::twoPunches())}};
  Session& session = *open.character();
  start.prepare(session);
  if (!isEnabled(command, open)) {
    return fmt::format("  off: {}\n", whyOff(command, open));
  }
  std::string text =
      fmt::format("  {}{}\n", labelNow(command, open), isChecked(command, open) ? " , on" : "");
  const std::vector<std::string> work = workLines(session);
  const std::vector<std::string> view = viewLines(session);
  const std::size_t steps = session.history().position();
  const Status done = run(command, open);
  text += done ? "" : "   refused: " + done.error().line() + "\n";
  if (session.history().position() != steps) {
    text += fmt::format("   step {} : {}\n", session.history().position(), session.history().undoLabel());
  }
  return text + changeText(view, viewLines(session)) + changeText(work, workLines(session)) +
         (isChecked(command, open) ? "   on now\n" : "");
}

} // namespace

TEST_CASE("What every command does in each state of the work is as it was looked at") {
  std::string text;
  for (const DocumentCommand& command : documentCommands()) {
    if (!command.run) {
      continue;
    }
    text += command.id;
    for (const std::string& key : command.keys) {
      text += " , " + key;
    }
    text += "\n";
    std::map<std::string, std::string> firstOf; // of what is done: the start where it was done first
    for (const Start& start : starts) {
      const std::string done = runText(command, start);
      const auto [known, isNew] = firstOf.try_emplace(done, start.name);
      text +=
          fmt::format(" {}{}\n{}", start.name, isNew ? "" : " : as with " + known->second, isNew ? done : "");
    }
  }
  const std::string difference = test::differenceFromRecord("commands", text, 1e-4);
  INFO(difference);
  CHECK(difference.empty());
}
