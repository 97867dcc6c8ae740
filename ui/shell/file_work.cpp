#include "ui/shell/file_work.h"

#include <algorithm>
#include <cctype>
#include <chrono>

#include <fmt/format.h>

#include "app/commands/selection.h"
#include "ui/panels/file_listing.h"
#include "ui/shell/autosave.h"
#include "ui/shell/input.h"
#include "ui/shell/recipe_work.h"
#include "ui/shell/sequence_work.h"
#include "ui/viewport/viewport_scene.h"

namespace stretch::ui {

namespace {

namespace fs = std::filesystem;

constexpr double autosaveAfterSeconds = 3.0;

void stampFile(FileWork& files, const fs::path& path) {
  files.stampedPath = path;
  files.stamp = stampOf(path);
  files.changeTold = false;
}

/// The name to show, of a folder with a slash at its end too.
std::string nameOf(const fs::path& path) {
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

/// Whether another program changed a file since we last read or wrote it.
bool changedByOthers(const FileWork& files, const fs::path& path) {
  return path == files.stampedPath && files.stamp && stampOf(path) != files.stamp;
}

void startLoading(Shell& shell, const std::vector<fs::path>& paths, std::optional<fs::path> restoreFrom) {
  if (shell.files.loading.valid()) {
    tell(shell, ToastKind::info, "Another file is being opened");
    return;
  }
  shell.files.loadingPaths = paths;
  shell.files.restoreFrom = std::move(restoreFrom);
  shell.files.loadingShare = std::make_shared<std::atomic<float>>(-1.0F);
  shell.files.loading = std::async(std::launch::async, [paths, share = shell.files.loadingShare] {
    return app::openAny(paths, [&share](double done) { *share = static_cast<float>(done); });
  });
  shell.ui.busyText = "Opening " + nameOf(paths.back());
  shell.ui.busyFraction = -1.0F;
}

void showNewFile(Shell& shell, const fs::path& path) {
  ViewportState& viewport = shell.viewport;
  const app::Document& document = shell.open.character()->document();
  viewport.shown = {};
  viewport.facingYawRadians = facingYaw(document, 0);
  viewport.camera = lookFrom(Camera{}, ViewDirection::threeQuarter, viewport.facingYawRadians);
  viewport.framePending = true;
  if (const auto text = readText(viewPath(path))) {
    readView(*text, document, shell.open.character()->view(), viewport.camera);
    viewport.framePending = false;
  }
}

void takeRestored(Shell& shell, app::Document document) {
  shell.open.character()->edit(std::move(document), "Restore unsaved work");
  tell(shell, ToastKind::success, "The unsaved work is back");
}

void takeSequence(Shell& shell) {
  shell.files.path = app::pathOf(shell.open.sequence()->document());
  shell.files.stampedPath.clear(); // Nothing is saved over a sequence: changes by others do not matter.
  shell.files.stamp.reset();
  rememberRecent(shell.ui, shell.files.path);
  showSequence(shell);
}

void takeDocument(Shell& shell) {
  FileWork& files = shell.files;
  const std::optional<fs::path> restoreFrom = std::exchange(files.restoreFrom, std::nullopt);
  const std::vector<std::string> warnings = shell.open.character()->document().warnings;
  files.path = files.loadingPaths.back();
  stampFile(files, files.path);
  rememberRecent(shell.ui, files.path);
  showNewFile(shell, files.path);
  if (!warnings.empty()) {
    tell(shell, ToastKind::warning,
         warnings.size() == 1 ? warnings.front()
                              : fmt::format("{} (and {} more)", warnings.front(), warnings.size() - 1));
  }
  if (restoreFrom) {
    Result<app::Document> restored = withAutosave(shell.open.character()->document(), *restoreFrom);
    removeAutosave(*restoreFrom);
    if (restored) {
      takeRestored(shell, std::move(restored).value());
    } else {
      tell(shell, ToastKind::error, restored.error().line());
    }
  } else {
    offerAutosave(shell, files.path);
  }
}

void takeLoaded(Shell& shell) {
  Result<app::Opened> loaded = shell.files.loading.get();
  shell.files.loading = {};
  shell.ui.busyText.clear();
  if (!loaded) {
    tell(shell, ToastKind::error,
         shell.files.loadingPaths.back().filename().string() + ": " + loaded.error().line());
    return;
  }
  closeFile(shell);
  shell.open.open(std::move(loaded).value());
  if (shell.open.character() != nullptr) {
    takeDocument(shell);
  } else {
    takeSequence(shell);
  }
}

void saved(Shell& shell, const fs::path& path, bool clean) {
  tell(shell, ToastKind::success,
       fmt::format("{} {}", clean ? "Exported" : "Saved", path.filename().string()));
  if (const std::size_t waiting = app::unappliedTrails(shell.open.character()->document()); waiting > 0) {
    tell(shell, ToastKind::warning,
         fmt::format("{} {} not applied: other programs play the file without {}. Enter applies the selected "
                     "one.",
                     waiting, waiting == 1 ? "trail is" : "trails are", waiting == 1 ? "it" : "them"));
  }
  if (clean) {
    return;
  }
  stampFile(shell.files, path);
  rememberRecent(shell.ui, path);
  removeAutosave(autosavePath(shell.files.path));
  shell.files.hasAutosave = false;
}

/// Goes on with what waited for the unsaved work to be settled.
void goOn(Shell& shell) {
  const AfterUnsaved after = std::exchange(shell.files.afterUnsaved, AfterUnsaved::nothing);
  if (after == AfterUnsaved::quit) {
    shell.quit = true;
  } else if (after == AfterUnsaved::open) {
    startLoading(shell, shell.files.pendingOpen, std::nullopt);
  }
}

void askAboutUnsaved(Shell& shell, AfterUnsaved after) {
  shell.files.afterUnsaved = after;
  shell.ui.unsavedOpen = true;
}

void answerUnsaved(Shell& shell, UnsavedChoice choice) {
  shell.ui.unsavedOpen = false;
  if (choice == UnsavedChoice::cancel) {
    shell.files.afterUnsaved = AfterUnsaved::nothing;
  } else if (choice == UnsavedChoice::discard) {
    goOn(shell);
  } else {
    saveFile(shell); // The rest follows once it is saved.
  }
}

void answerFile(Shell& shell, const FileChoice& choice) {
  if (shell.open.sequence() != nullptr && choice.purpose != FilePurpose::openModel) {
    answerSequenceFile(shell, choice);
    return;
  }
  if (shell.open.character() == nullptr && choice.purpose != FilePurpose::openModel) {
    return;
  }
  switch (choice.purpose) {
  case FilePurpose::openModel:
    openFile(shell, {choice.path});
    break;
  case FilePurpose::saveModel:
    saveFileAs(shell, choice.path, false);
    break;
  case FilePurpose::exportClean:
    saveFileAs(shell, choice.path, true);
    break;
  case FilePurpose::openRecipe:
    loadRecipeFile(shell, choice.path);
    break;
  case FilePurpose::saveRecipe:
    saveRecipeFile(shell, choice.path);
    break;
  case FilePurpose::saveFrames:
  case FilePurpose::exportSequence:
  case FilePurpose::openModuli:
  case FilePurpose::saveModuli:
    break;
  }
}

void answerRestore(Shell& shell, bool restore) {
  const fs::path autosave = std::exchange(shell.files.offeredAutosave, {});
  const fs::path source = std::exchange(shell.files.offeredSource, {});
  shell.ui.restoreOffer.clear();
  if (!restore) {
    removeAutosave(autosave);
  } else if (shell.open.character() != nullptr && source == shell.files.path) {
    Result<app::Document> restored = withAutosave(shell.open.character()->document(), autosave);
    removeAutosave(autosave);
    if (restored) {
      takeRestored(shell, std::move(restored).value());
    } else {
      tell(shell, ToastKind::error, restored.error().line());
    }
  } else {
    startLoading(shell, {source}, autosave);
  }
}

void takeAnswers(Shell& shell) {
  UiAnswers& answers = shell.ui.answers;
  if (answers.unsaved) {
    answerUnsaved(shell, *std::exchange(answers.unsaved, std::nullopt));
  }
  if (answers.file) {
    answerFile(shell, *std::exchange(answers.file, std::nullopt));
  }
  if (answers.restoreAutosave) {
    answerRestore(shell, *std::exchange(answers.restoreAutosave, std::nullopt));
  }
}

/// What a drop of several files stands for: a mesh and its cache together, else the first one, which may be
/// one of many frames.
std::vector<fs::path> droppedPaths(const std::vector<fs::path>& drops) {
  if (drops.size() == 2 && drops[0].extension() != drops[1].extension()) {
    return drops;
  }
  return {drops.front()};
}

/// Writes unsaved work aside, a few seconds after the last change.
void autosave(Shell& shell, double nowSeconds) {
  FileWork& files = shell.files;
  if (shell.open.character() == nullptr || shell.open.character()->isDragging()) {
    return;
  }
  const app::Document& document = shell.open.character()->document();
  if (!hasUnsavedWork(shell)) {
    if (files.hasAutosave) {
      removeAutosave(autosavePath(files.path));
      files.hasAutosave = false;
    }
    return;
  }
  const bool due = nowSeconds - files.lastAutosaveSeconds >= autosaveAfterSeconds;
  if (!due || (files.hasAutosave && app::sameDocument(files.autosaved, document))) {
    return;
  }
  files.lastAutosaveSeconds = nowSeconds;
  const Status written = writeText(autosavePath(files.path), autosaveText(document, files.path));
  if (!written && !files.hasAutosave) {
    tell(shell, ToastKind::warning, "Unsaved work is not kept aside: " + written.error().line());
  }
  files.autosaved = document;
  files.hasAutosave = true;
}

void tellForeignChange(Shell& shell) {
  FileWork& files = shell.files;
  if (!files.changeTold && changedByOthers(files, files.stampedPath)) {
    files.changeTold = true;
    tell(shell, ToastKind::warning,
         files.stampedPath.filename().string() + " was changed by another program");
  }
}

} // namespace

bool hasUnsavedWork(const Shell& shell) {
  return shell.open.character() != nullptr && !shell.open.character()->history().isSaved();
}

void openFile(Shell& shell, const std::vector<fs::path>& paths) {
  if (hasUnsavedWork(shell)) {
    shell.files.pendingOpen = paths;
    askAboutUnsaved(shell, AfterUnsaved::open);
    return;
  }
  startLoading(shell, paths, std::nullopt);
}

void askForFile(Shell& shell, FilePurpose given) {
  const bool whole = given == FilePurpose::saveModel || given == FilePurpose::exportClean;
  const FilePurpose purpose = shell.open.sequence() != nullptr && whole ? FilePurpose::exportSequence : given;
  FileDialogState& dialog = shell.ui.fileDialog;
  dialog = {};
  dialog.open = true;
  dialog.purpose = purpose;
  const bool saving = isSaving(purpose);
  std::error_code ignored;
  const fs::path near =
      shell.open.character() != nullptr ? shell.open.character()->proposedSavePath() : shell.files.path;
  dialog.folder =
      near.has_parent_path() ? fs::absolute(near.parent_path(), ignored) : fs::current_path(ignored);
  if (saving && shell.open.character() != nullptr) {
    fs::path proposed = near.filename();
    if (purpose == FilePurpose::exportClean) {
      proposed = near.stem().string() + "-clean.glb";
    } else if (purpose == FilePurpose::saveRecipe) {
      proposed = near.stem().string() + "-recipe.json";
    }
    dialog.typed = proposed.string();
  }
  if (shell.open.sequence() != nullptr && saving) {
    const std::string name = shell.open.sequence()->document().mesh->name;
    dialog.typed = name + (purpose == FilePurpose::saveModuli ? "-moduli.json" : ".glb");
  }
}

void saveFile(Shell& shell) {
  if (shell.open.sequence() != nullptr) {
    askForFile(shell, FilePurpose::exportSequence);
    return;
  }
  if (shell.open.character() == nullptr) {
    return;
  }
  const fs::path path = shell.open.character()->savePath();
  if (path.empty()) {
    askForFile(shell, FilePurpose::saveModel);
  } else if (changedByOthers(shell.files, path) && shell.files.changedSavePath.empty()) {
    shell.files.changedSavePath = path;
  } else {
    saveFileAs(shell, path, false);
  }
}

void saveFileAs(Shell& shell, const fs::path& path, bool clean) {
  if (shell.open.character() == nullptr) {
    return;
  }
  shell.files.changedSavePath.clear();
  const Status done = shell.open.character()->save(path, clean);
  if (!done) {
    tellProblem(shell, done);
    shell.files.afterUnsaved = AfterUnsaved::nothing;
    return;
  }
  saved(shell, path, clean);
  if (!clean) {
    goOn(shell);
  }
}

fs::path nextIncrement(const fs::path& path) {
  std::string stem = path.stem().string();
  const std::size_t dash = stem.rfind('-');
  const bool numbered = dash != std::string::npos && dash + 1 < stem.size() &&
                        std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(dash) + 1, stem.end(),
                                    [](unsigned char c) { return std::isdigit(c) != 0; });
  stem = numbered ? stem.substr(0, dash) : stem;
  fs::path next = path;
  std::error_code ignored;
  for (int number = 1; number < 100000; ++number) {
    next.replace_filename(fmt::format("{}-{:03}{}", stem, number, path.extension().string()));
    if (!fs::exists(next, ignored)) {
      break;
    }
  }
  return next;
}

void saveIncremental(Shell& shell) {
  if (shell.open.character() != nullptr) {
    saveFileAs(shell, nextIncrement(shell.open.character()->proposedSavePath()), false);
  }
}

void askToQuit(Shell& shell) {
  if (hasUnsavedWork(shell)) {
    askAboutUnsaved(shell, AfterUnsaved::quit);
  } else {
    shell.quit = true;
  }
}

void updateFileWork(Shell& shell, const InputQueue& input, double nowSeconds) {
  if (shell.files.loading.valid() &&
      shell.files.loading.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    takeLoaded(shell);
  } else if (shell.files.loading.valid()) {
    shell.ui.busyFraction = *shell.files.loadingShare;
  }
  updateSequence(shell);
  takeAnswers(shell);
  if (!input.drops.empty()) {
    openFile(shell, droppedPaths(input.drops));
  }
  if (input.closeAsked) {
    askToQuit(shell);
  }
  if (input.focusGained) {
    tellForeignChange(shell);
  }
  autosave(shell, nowSeconds);
}

void offerAutosave(Shell& shell, const fs::path& file) {
  if (const auto found = findAutosave(file)) {
    shell.files.offeredAutosave = found->file;
    shell.files.offeredSource = file.empty() ? found->source : file;
    shell.ui.restoreOffer = shell.files.offeredSource.string();
  }
}

void closeFile(Shell& shell) {
  FileWork& files = shell.files;
  if (shell.open.character() == nullptr) {
    return;
  }
  finishTool(*shell.open.character(), shell.tool, false);
  const std::string view = viewText(shell.open.character()->view(), shell.viewport.camera);
  tellProblem(shell, writeText(viewPath(files.path), view));
  if (!shell.open.character()->savePath().empty() && shell.open.character()->savePath() != files.path) {
    tellProblem(shell, writeText(viewPath(shell.open.character()->savePath()), view));
  }
  if (files.hasAutosave) {
    removeAutosave(autosavePath(files.path));
    files.hasAutosave = false;
  }
  files.autosaved = {};
}

std::string windowTitle(const Shell& shell) {
  if (shell.open.sequence() != nullptr) {
    return nameOf(shell.files.path) + " \xE2\x80\x93 Stretch-Engine";
  }
  if (shell.open.character() == nullptr) {
    return "Stretch-Engine";
  }
  const fs::path& path =
      shell.open.character()->savePath().empty() ? shell.files.path : shell.open.character()->savePath();
  return (hasUnsavedWork(shell) ? "\xE2\x97\x8F " : "") + path.filename().string() +
         " \xE2\x80\x93 Stretch-Engine";
}

} // namespace stretch::ui
