#include "ui/shell/sequence_work.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/commands/table/command_ids.h"
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

void takeSkeleton(Shell& shell, const std::filesystem::path& path) {
  app::SequenceSession& session = *shell.open.sequence();
  Result<app::SequenceDocument> changed = app::withSkeleton(session.document(), path);
  if (!changed) {
    tell(shell, ToastKind::error, changed.error().line());
    return;
  }
  session.edit(std::move(changed).value(), "Take the bones of " + path.filename().string());
}

/// What the file shows when it is read back, not what was meant to be in it.
std::string exportText(const app::WrittenClip& written) {
  const skinning::EncodedClip& clip = written.clip->clip;
  const std::size_t bytes = clip.source.buffers.front().size() + clip.bytesOfJson;
  return fmt::format("Exported {}: {:.4g} kB, read back it is off by {:.3g} %, at most {:.3g} %",
                     written.path.filename().string(), static_cast<double>(bytes) / 1000.0,
                     written.metrics.rmsePercent, written.metrics.largestPercent);
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

std::string resultText(const app::SequenceSession& session) {
  return fmt::format("Compressed: RMSE {:.3g} %, {:.4g} bytes per frame",
                     session.document().result->compressed.metrics.rmsePercent,
                     session.clip() == nullptr ? 0.0 : session.clip()->clip.bytesPerFrame);
}

app::Command<Shell> fileCommand(const char* id, const char* label, const char* help, FilePurpose purpose) {
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
  shell.ui.time.timeline.viewStart = 0.0;
  shell.ui.time.timeline.viewEnd = -1.0;
  // A body that lies along z is looked at from its side.
  const app::SequenceAnalysis& analysis = *shell.open.sequence()->document().analysis;
  const Vec3 size = analysis.high - analysis.low;
  shell.viewport.look.facingYawRadians = size.z > size.x ? 0.5 * pi : 0.0;
  shell.viewport.camera =
      lookFrom(Camera{}, ViewDirection::threeQuarter, shell.viewport.look.facingYawRadians);
  shell.viewport.framePending = true;
}

void updateSequence(Shell& shell) {
  app::SequenceSession* const session = shell.open.sequence();
  if (session == nullptr) {
    return;
  }
  const std::optional<Status> done = session->takeCompression();
  if (done && *done) {
    tell(shell, ToastKind::success, resultText(*session));
  } else if (done) {
    tellProblem(shell, *done);
  }
  const std::optional<Result<app::WrittenClip>> written = session->takeExport();
  if (written && *written) {
    tell(shell, ToastKind::success, exportText(**written));
  } else if (written) {
    tellProblem(shell, written->error());
  }
  session->keepClip();
}

void answerSequenceFile(Shell& shell, const FileChoice& choice) {
  if (choice.purpose == FilePurpose::exportSequence) {
    tellProblem(shell, shell.open.sequence()->startExport(choice.path));
  } else if (choice.purpose == FilePurpose::openModuli) {
    loadModuli(shell, choice.path);
  } else if (choice.purpose == FilePurpose::saveModuli) {
    saveModuli(shell, choice.path);
  } else if (choice.purpose == FilePurpose::openSkeleton) {
    takeSkeleton(shell, choice.path);
  }
}

std::vector<app::Command<Shell>> sequenceFileCommands() {
  return {fileCommand(command::skeletonTake, "Take the bones of a file",
                      "Takes the names, parents and places of the bones of a .glb's skin; their motion and "
                      "the weights are fitted. They have to stand where the first frame does, in its units.",
                      FilePurpose::openSkeleton),
          fileCommand(command::moduliLoad, "Load moduli", "Reads Young's moduli by segment from JSON.",
                      FilePurpose::openModuli),
          fileCommand(command::moduliSave, "Save moduli",
                      "Writes Young's moduli by segment as JSON, as `compress --moduli` reads them.",
                      FilePurpose::saveModuli)};
}

} // namespace stretch::ui
