#include "ui/shell/sequence_work.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/commands/command_ids.h"
#include "ui/shell/file_work.h"

namespace stretch::ui {

namespace {

bool hasSequence(const Shell& shell) {
  return shell.open.sequence() != nullptr;
}

Status ask(Shell& shell, FilePurpose purpose) {
  askForFile(shell, purpose);
  return Success{};
}

void exportTo(Shell& shell, const std::filesystem::path& path) {
  const Status done = app::exportResult(shell.open.sequence()->document(), path);
  if (done) {
    tell(shell, ToastKind::success, "Exported " + path.filename().string());
  }
  tellProblem(shell, done);
}

void loadModuli(Shell& shell, const std::filesystem::path& path) {
  const auto text = readText(path);
  if (!text) {
    tell(shell, ToastKind::error, path.filename().string() + " cannot be read");
    return;
  }
  const Result<skinning::SegmentModuli> moduli = skinning::parseModuli(*text);
  if (!moduli) {
    tell(shell, ToastKind::error, path.filename().string() + ": " + moduli.error().line());
    return;
  }
  app::SequenceSession& session = *shell.open.sequence();
  app::SequenceDocument changed = session.document();
  skinning::BodyStretchSettings& body = changed.settings.body;
  body.moduli.ranges = moduli->ranges;
  body.youngModulus = moduli->youngModulus ? moduli->youngModulus : body.youngModulus;
  session.edit(std::move(changed), "Load moduli");
}

void saveModuli(Shell& shell, const std::filesystem::path& path) {
  skinning::SegmentModuli moduli = shell.open.sequence()->document().settings.body.moduli;
  moduli.youngModulus = shell.open.sequence()->document().settings.body.youngModulus;
  const Status done = writeText(path, skinning::moduliText(moduli));
  if (done) {
    tell(shell, ToastKind::success, "Saved " + path.filename().string());
  }
  tellProblem(shell, done);
}

std::string resultText(const app::SequenceDocument& document) {
  return fmt::format("Compressed: RMSE {:.3g} %, {:.4g} bytes per frame",
                     document.result->compressed.metrics.rmsePercent,
                     app::exported(document)->clip.bytesPerFrame);
}

app::Command<Shell> moduliCommand(const char* id, const char* label, const char* help, FilePurpose purpose) {
  app::Command<Shell> made;
  made.id = id;
  made.label = label;
  made.help = help;
  made.enabled = hasSequence;
  made.run = [purpose](Shell& shell) { return ask(shell, purpose); };
  return made;
}

} // namespace

void showSequence(Shell& shell) {
  shell.ui.timeline.viewStart = 0.0;
  shell.ui.timeline.viewEnd = -1.0;
  // A body that lies along z is looked at from its side.
  const app::SequenceAnalysis& analysis = *shell.open.sequence()->document().analysis;
  const Vec3 size = analysis.high - analysis.low;
  shell.viewport.facingYawRadians = size.z > size.x ? 0.5 * pi : 0.0;
  shell.viewport.camera = lookFrom(Camera{}, ViewDirection::threeQuarter, shell.viewport.facingYawRadians);
  shell.viewport.framePending = true;
}

void updateSequence(Shell& shell) {
  app::SequenceSession* const session = shell.open.sequence();
  if (session == nullptr || !session->isCompressing()) {
    return;
  }
  const std::optional<Status> done = session->takeCompression();
  if (done && *done) {
    tell(shell, ToastKind::success, resultText(session->document()));
  } else if (done) {
    tellProblem(shell, *done);
  }
}

void answerSequenceFile(Shell& shell, const FileChoice& choice) {
  if (choice.purpose == FilePurpose::exportSequence) {
    exportTo(shell, choice.path);
  } else if (choice.purpose == FilePurpose::openModuli) {
    loadModuli(shell, choice.path);
  } else if (choice.purpose == FilePurpose::saveModuli) {
    saveModuli(shell, choice.path);
  }
}

std::vector<app::Command<Shell>> moduliCommands() {
  return {moduliCommand(command::moduliLoad, "Load moduli", "Reads Young's moduli by segment from JSON.",
                        FilePurpose::openModuli),
          moduliCommand(command::moduliSave, "Save moduli",
                        "Writes Young's moduli by segment as JSON, as `compress --moduli` reads them.",
                        FilePurpose::saveModuli)};
}

} // namespace stretch::ui
