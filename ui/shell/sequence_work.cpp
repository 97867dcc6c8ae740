#include "ui/shell/sequence_work.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ui/panels/command_ids.h"
#include "ui/shell/file_work.h"
#include "ui/shell/user_files.h"

namespace stretch::ui {

namespace {

bool alwaysEnabled(const app::SequenceSession& /*session*/) {
  return true;
}
bool hasResult(const app::SequenceSession& session) {
  return session.document.result != nullptr;
}
bool hasSequence(const Shell& shell) {
  return shell.sequence != nullptr;
}

Status goTo(Shell& shell, double frame) {
  shell.sequence->view.frame = std::clamp(frame, 0.0, app::lastFrame(*shell.sequence));
  return Success{};
}

Status askForExport(Shell& shell) {
  askForFile(shell, FilePurpose::exportSequence);
  return Success{};
}

Status switchOriginal(Shell& shell) {
  shell.sequence->view.showOriginal = !shell.sequence->view.showOriginal;
  return Success{};
}

Status switchSkinned(Shell& shell) {
  shell.sequence->view.showSkinned = !shell.sequence->view.showSkinned;
  return Success{};
}

Status compressNow(Shell& shell) {
  return app::startCompression(*shell.sequence);
}

Status cancelCompression(Shell& shell) {
  shell.sequence->job->cancel();
  return Success{};
}

Status ask(Shell& shell, FilePurpose purpose) {
  askForFile(shell, purpose);
  return Success{};
}

void exportTo(Shell& shell, const std::filesystem::path& path) {
  const Status done = app::exportResult(shell.sequence->document, path);
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
  skinning::BodyStretchSettings& body = shell.sequence->document.settings.body;
  body.moduli.ranges = moduli->ranges;
  if (moduli->youngModulus) {
    body.youngModulus = moduli->youngModulus;
    shell.ui.sequencePanel.young = fmt::format("{}", *moduli->youngModulus);
  }
}

void saveModuli(Shell& shell, const std::filesystem::path& path) {
  skinning::SegmentModuli moduli = shell.sequence->document.settings.body.moduli;
  moduli.youngModulus = shell.sequence->document.settings.body.youngModulus;
  const Status done = writeText(path, skinning::moduliText(moduli));
  if (done) {
    tell(shell, ToastKind::success, "Saved " + path.filename().string());
  }
  tellProblem(shell, done);
}

std::string resultText(const app::SequenceDocument& document) {
  return fmt::format("Compressed: RMSE {:.3g} %, {:.4g} bytes per frame",
                     document.result->compressed.metrics.rmsePercent, app::exported(document).bytesPerFrame);
}

} // namespace

void showSequence(Shell& shell, app::SequenceDocument document) {
  shell.session.reset();
  shell.sequence = std::make_unique<app::SequenceSession>();
  shell.sequence->document = std::move(document);
  shell.ui.sequencePanel = {};
  shell.ui.timeline.viewStart = 0.0;
  shell.ui.timeline.viewEnd = -1.0;
  // A body that lies along z is looked at from its side.
  const Vec3 size = shell.sequence->document.analysis->high - shell.sequence->document.analysis->low;
  shell.viewport.facingYawRadians = size.z > size.x ? 0.5 * pi : 0.0;
  shell.viewport.camera = lookFrom(Camera{}, ViewDirection::threeQuarter, shell.viewport.facingYawRadians);
  shell.viewport.framePending = true;
}

void updateSequence(Shell& shell) {
  if (shell.sequence == nullptr || shell.sequence->job == nullptr) {
    return;
  }
  shell.ui.busyText = "Compressing " + shell.sequence->document.mesh->name;
  shell.ui.busyFraction = static_cast<float>(shell.sequence->job->share());
  const std::optional<Status> done = app::takeCompression(*shell.sequence);
  if (shell.sequence->job == nullptr) {
    shell.ui.busyText.clear();
  }
  if (done && *done) {
    tell(shell, ToastKind::success, resultText(shell.sequence->document));
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

std::vector<app::Command<Shell>> sequenceCommands() {
  return {
      {command::sequenceCompress,
       "Compress the sequence",
       "Makes a skinned clip of the mesh sequence, with the settings of the panel.",
       {"Ctrl+Enter"},
       [](const Shell& shell) { return hasSequence(shell) && shell.sequence->job == nullptr; },
       compressNow},
      {command::sequenceCancel,
       "Cancel the compression",
       "Stops it; what was compressed before stays.",
       {},
       [](const Shell& shell) { return hasSequence(shell) && shell.sequence->job != nullptr; },
       cancelCompression},
      {command::sequenceOriginal,
       "Show the original sequence",
       "Shows the meshes as they were simulated, in red.",
       {},
       hasSequence,
       switchOriginal},
      {command::sequenceSkinned,
       "Show the skinned result",
       "Shows what the compressed clip makes of them, in green.",
       {},
       [](const Shell& shell) { return hasSequence(shell) && hasResult(*shell.sequence); },
       switchSkinned},
      {command::moduliLoad,
       "Load moduli",
       "Reads Young's moduli by segment from JSON.",
       {},
       hasSequence,
       [](Shell& shell) { return ask(shell, FilePurpose::openModuli); }},
      {command::moduliSave,
       "Save moduli",
       "Writes Young's moduli by segment as JSON, as `compress --moduli` reads them.",
       {},
       hasSequence,
       [](Shell& shell) { return ask(shell, FilePurpose::saveModuli); }},
  };
}

const std::vector<SequenceMeaning>& sequenceMeanings() {
  static const std::vector<SequenceMeaning> meanings{
      {command::timeStart, alwaysEnabled, [](Shell& shell) { return goTo(shell, 0.0); }},
      {command::timeEnd, alwaysEnabled,
       [](Shell& shell) { return goTo(shell, app::lastFrame(*shell.sequence)); }},
      {command::timeBack, alwaysEnabled,
       [](Shell& shell) { return goTo(shell, std::ceil(shell.sequence->view.frame) - 1.0); }},
      {command::timeForward, alwaysEnabled,
       [](Shell& shell) { return goTo(shell, std::floor(shell.sequence->view.frame) + 1.0); }},
      {command::fileSave, hasResult, askForExport},
      {command::fileSaveAs, hasResult, askForExport},
      {command::fileExportClean, hasResult, askForExport},
      {command::trailShowOriginal, alwaysEnabled, switchOriginal},
  };
  return meanings;
}

} // namespace stretch::ui
