#include "ui/shell/shell.h"

#include "app/commands/table/frames.h"
#include "ui/panels/context/panel_support.h"
#include "ui/shell/file_work.h"
#include "ui/shell/tour.h"

namespace stretch::ui {

namespace {

/// What is being made of a sequence beside the window.
void describeWork(const app::SequenceSession& session, EditorStatus& status) {
  const std::string& name = session.document().mesh->name;
  if (session.isCompressing()) {
    status.busyText = "Compressing " + name;
    status.busyFraction = static_cast<float>(session.compressedShare());
  } else if (session.isExporting()) {
    status.busyText = "Exporting " + name;
    status.busyFraction = static_cast<float>(session.exportedShare());
  } else {
    status.busyText = "Encoding " + name;
    status.busyFraction = static_cast<float>(session.encodedShare());
  }
}

} // namespace

bool hasPicture(const Shell& shell) {
  return shell.open.character() != nullptr || shell.open.sequence() != nullptr;
}

bool showsClip(const Shell& shell) {
  const app::Session* const session = shell.open.character();
  return session != nullptr && app::hasClip(session->document(), session->view().clip);
}

EditorStatus statusOf(const Shell& shell) {
  EditorStatus status;
  status.question = shell.files.question();
  status.fileName = openFileName(shell);
  status.unsaved = app::wouldLoseWork(shell.open);
  status.pressedKey = shell.pressedKey;
  describeTool(shell.tool, status);
  status.tour = tourCard(shell);
  const app::SequenceSession* const sequence = shell.open.sequence();
  if (shell.files.isOpening()) {
    status.busyText = "Opening " + shell.files.openingName();
    status.busyFraction = shell.files.openingShare();
  } else if (shell.beside.clipImport.job != nullptr) {
    status.busyText = "Importing " + shell.beside.clipImport.file.filename().string();
    status.busyFraction = static_cast<float>(shell.beside.clipImport.job->share());
  } else if (sequence != nullptr && sequence->isWorking()) {
    describeWork(*sequence, status);
  } else if (shell.beside.fitting.job != nullptr) {
    status.busyText = "Fitting locators";
    status.busyFraction = static_cast<float>(shell.beside.fitting.job->share());
  } else if (shell.beside.film.job != nullptr) {
    status.busyText =
        "Drawing " + shell.beside.film.path.filename().string() + ", " + shell.beside.film.drawn;
    status.busyFraction = static_cast<float>(shell.beside.film.job->share());
  } else if (shell.beside.reference.reading != nullptr) {
    status.busyText =
        "Reading " + std::filesystem::path(shell.beside.reference.soundOf.value_or("")).filename().string();
  } else if (shell.beside.reference.images.isReading() && shell.beside.reference.shown == nullptr) {
    status.busyText = "Reading the reference images";
  } else if (shell.beside.binding.job != nullptr) {
    status.busyText = "Binding the mesh";
    status.busyFraction = static_cast<float>(shell.beside.binding.job->share());
  }
  return status;
}

bool isBusy(const Shell& shell) {
  return !statusOf(shell).busyText.empty();
}

void tell(Shell& shell, ToastKind kind, const std::string& text) {
  tell(shell.ui, kind, text);
}

void refuse(Shell& shell, const std::string& why) {
  shell.refused = why;
  tell(shell, ToastKind::info, why);
}

void tellProblem(Shell& shell, const Status& status) {
  tellProblem(shell.ui, shell.open, status);
}

} // namespace stretch::ui
