#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/pose/posing.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/files/save.h"
#include "tests/support/app/random_edits.h"

using namespace stretch;
using namespace stretch::app;

namespace {

// STRETCH_UNDO_STEPS asks for more than what every run of the tests does.
int wantedSteps() {
  const char* const asked = std::getenv("STRETCH_UNDO_STEPS");
  return asked == nullptr ? 400 : std::atoi(asked);
}

Document swing() {
  const Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy_swing.glb");
  REQUIRE(opened);
  return *opened;
}

/// Somebody who does whatever can be done.
class Anybody {
public:
  Anybody(OpenDocument& open, unsigned seed) : open_(open), dice_(seed) {}

  /// One command or one edit; answers its name.
  std::string act() {
    lookElsewhere();
    if (dice_.below(3) == 0) {
      session().edit(test::randomEdit(session().document(), dice_), "Edit");
      return "edit";
    }
    const auto index = static_cast<std::size_t>(dice_.below(static_cast<int>(commands_.size())));
    const DocumentCommand& command = commands_[index];
    if (!isEnabled(command, open_)) {
      return {};
    }
    const std::size_t before = session().history().labels().size();
    static_cast<void>(run(command, open_));
    return session().history().labels().size() > before ? command.id : std::string();
  }

private:
  Session& session() { return *open_.character(); }

  static std::vector<DocumentCommand> commandsButTheHistory() {
    std::vector<DocumentCommand> commands = documentCommands();
    std::erase_if(commands, [](const DocumentCommand& command) {
      return command.id == command::undo || command.id == command::redo;
    });
    return commands;
  }

  // Another frame, limb, controller, trail or row of keys is looked at.
  void lookElsewhere() {
    ViewState& view = session().view();
    const Document& document = session().document();
    const auto anyOf = [&](const auto& list) -> const auto& {
      return list[static_cast<std::size_t>(dice_.below(static_cast<int>(list.size())))];
    };
    switch (dice_.below(8)) {
    case 0:
      view.frame = dice_.below(static_cast<int>(lastFrame(document, view.clip)) + 1);
      break;
    case 1:
      selectLimb(session(), anyOf(document.body.limbs).id, dice_.below(2) == 0);
      break;
    case 2:
      selectController(session(), anyOf(controllersOf(document).controllers).id, dice_.below(2) == 0);
      break;
    case 3:
      selectTrail(session(), document.trails.empty() ? 0 : anyOf(document.trails).id);
      break;
    case 4:
      view.keyRows = keyedRows(document, view.clip);
      view.pickedClip = view.clip;
      view.pickedKeys = keysBetween(document, view.clip, view.keyRows, view.frame - 3.0, view.frame + 3.0);
      break;
    default:
      break;
    }
  }

  OpenDocument& open_;
  test::Dice dice_;
  std::vector<DocumentCommand> commands_ = commandsButTheHistory();
};

} // namespace

TEST_CASE("commands and edits of every kind are undone one by one, and done again, to the very documents",
          "[undo]") {
  OpenDocument open;
  open.open(swing());
  Session& session = *open.character();
  Anybody anybody(open, 20261);
  std::vector<Document> states{session.document()};
  std::set<std::string> kinds;
  for (int i = 0; i < wantedSteps(); ++i) {
    kinds.insert(anybody.act());
    REQUIRE_FALSE(session.isDragging());
    if (session.history().labels().size() > states.size()) {
      states.push_back(session.document());
    }
    CHECK(sameDocument(session.document(), states.back()));
  }
  if (std::getenv("STRETCH_UNDO_STEPS") != nullptr) {
    WARN(states.size() - 1 << " steps of " << kinds.size() << " kinds, " << session.history().bytes()
                           << " bytes");
  }
  CHECK(static_cast<int>(states.size()) > wantedSteps() / 4);
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    REQUIRE(session.undo());
    REQUIRE(sameDocument(session.document(), states[i - 1]));
  }
  CHECK_FALSE(session.undo());
  for (std::size_t i = 1; i < states.size(); ++i) {
    REQUIRE(session.redo());
    REQUIRE(sameDocument(session.document(), states[i]));
  }
  CHECK_FALSE(session.redo());
}
