#include "ui/shell/file_work.h"

#include "ui/shell/fit_work.h"

#include <fmt/format.h>

#include "app/commands/pose/hold.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/place_trails.h"
#include "app/evaluate/hand_place.h"
#include "app/files/bundled_folder.h"
#include "app/files/user_files.h"
#include "app/files/user_styles.h"
#include "app/recipe/recipe.h"
#include "app/recipe/replay.h"
#include "app/reference/reference_edits.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/added_file.h"
#include "core/interchange/file_kind.h"
#include "ui/panels/files/file_listing.h"
#include "ui/shell/clip_import.h"
#include "ui/shell/sequence_work.h"
#include "ui/shell/shell_commands.h"
#include "ui/shell/style_work.h"
#include "ui/shell/tour.h"
#include "ui/viewport/viewport_scene.h"

namespace stretch::ui {

namespace {

namespace fs = std::filesystem;

void showCharacter(Shell& shell) {
  ViewportState& viewport = shell.viewport;
  app::Session& session = *shell.open.character();
  viewport.shown = {};
  shell.beside.reference.kept.clear();
  viewport.look.through.reset();
  viewport.look.name.clear();
  viewport.look.kept = {};
  viewport.look.facingYawRadians = facingYaw(session.document(), 0);
  viewport.camera = lookFrom(Camera{}, ViewDirection::threeQuarter, viewport.look.facingYawRadians);
  viewport.framePending = true;
  if (const auto text = readText(viewPath(shell.files.path()))) {
    ViewBookmark now{viewport.camera};
    readView(*text, session.document(), session.view(), now, viewport.look.kept);
    takeReferences(shell, *text);
    viewport.camera = now.camera;
    viewport.look.name = now.through;
    session.followSelection();
    viewport.framePending = false;
  }
}

/// Ends a tool, and remembers how the character was looked at.
void leaveCharacter(Shell& shell) {
  app::Session& session = *shell.open.character();
  finishTool(session, shell.tool, false);
  closePoseLibrary(shell);
  closeClipStyle(shell);
  forgetReference(shell);
  keepView(shell);
}

/// What was seen of the time of the file before says nothing about this one.
void forgetViewOfTime(UiState& ui) {
  const TimelineState fresh;
  ui.time.timeline.viewStart = fresh.viewStart;
  ui.time.timeline.viewEnd = fresh.viewEnd;
  ui.time.timeline.playing = false;
  ui.time.gesture = {};
  ui.time.graph.fitPending = true;
  ui.time.picks.reset();
  ui.time.picksAt.clear();
}

/// The window's user, for the file work.
class WindowUser : public app::FileUser {
public:
  explicit WindowUser(Shell& shell) : shell_(shell) {}

  app::OpenDocument& open() override { return shell_.open; }
  [[nodiscard]] app::SavedForm form() const override { return shell_.ui.savedForm; }
  void tell(app::Tone tone, const std::string& text) override { ui::tell(shell_, tone, text); }
  void closing() override {
    shell_.ui.toasts.clear(); // They were about this file.
    shell_.beside.styling.kept.clear();
    if (shell_.open.character() != nullptr) {
      leaveCharacter(shell_);
    }
  }
  void opened() override {
    keepRecent(shell_.files.path());
    forgetViewOfTime(shell_.ui);
    if (shell_.open.character() != nullptr) {
      showCharacter(shell_);
      offerTour(shell_);
    } else {
      showSequence(shell_);
    }
  }
  void saved(const fs::path& path) override { keepRecent(path); }
  void quit() override { shell_.quit = true; }

private:
  // At once: whoever is cut off finds his files again.
  void keepRecent(const fs::path& path) {
    rememberRecent(shell_.ui, path);
    shell_.ui.answers.keepSettings = true;
  }

  Shell& shell_;
};

void answerCharacterFile(Shell& shell, const FileChoice& choice) {
  WindowUser user(shell);
  switch (choice.purpose) {
  case FilePurpose::saveModel:
    shell.files.saveAs(user, choice.path);
    break;
  case FilePurpose::exportClean:
    shell.files.exportClean(user, choice.path);
    break;
  case FilePurpose::openRecipe:
    loadRecipeFile(shell, choice.path);
    break;
  case FilePurpose::openProp:
    addPropFile(shell, choice.path);
    break;
  case FilePurpose::openClip:
    askForClip(shell, choice.path);
    break;
  case FilePurpose::saveRecipe:
    saveRecipeFile(shell, choice.path);
    break;
  case FilePurpose::openStyle:
    importStyle(shell, choice.path);
    break;
  case FilePurpose::saveStyle:
    exportStyle(shell, choice.path);
    break;
  case FilePurpose::saveFilm:
    startFilm(shell, choice.path);
    break;
  case FilePurpose::openReferenceImages:
    referToImages(shell, choice.path);
    break;
  case FilePurpose::openReferenceSound:
    referToSound(shell, choice.path);
    break;
  case FilePurpose::openModel:
  case FilePurpose::exportSequence:
  case FilePurpose::openModuli:
  case FilePurpose::saveModuli:
  case FilePurpose::openSkeleton:
    break;
  }
}

void answerFile(Shell& shell, const FileChoice& choice) {
  if (choice.purpose == FilePurpose::openModel) {
    openFile(shell, {choice.path});
  } else if (shell.open.sequence() != nullptr) {
    answerSequenceFile(shell, choice);
  } else if (shell.open.character() != nullptr) {
    answerCharacterFile(shell, choice);
  }
}

/// The question for a name is the dialog that asks for a file: closed without a name, it is cancelled.
void askForName(Shell& shell, bool wasAsked) {
  if (shell.files.question().kind != app::FileQuestion::Kind::name) {
    return;
  }
  if (!wasAsked) {
    askForFile(shell, FilePurpose::saveModel);
  } else if (!shell.ui.dialogs.file.open) {
    WindowUser user(shell);
    shell.files.answer(user, app::FileAnswer::cancel);
  }
}

void takeAnswers(Shell& shell) {
  UiAnswers& answers = shell.ui.answers;
  if (answers.question) {
    WindowUser user(shell);
    shell.files.answer(user, *std::exchange(answers.question, std::nullopt));
  }
  if (answers.drop) {
    const DropAnswer answer = *std::exchange(answers.drop, std::nullopt);
    answerFile(shell, {answer.purpose, answer.file});
  }
  if (answers.clip) {
    importClip(shell, *std::exchange(answers.clip, std::nullopt));
  }
  if (answers.file) {
    answerFile(shell, *std::exchange(answers.file, std::nullopt));
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

/// A file that was dropped: one that a hand of the open character could hold, or that has clips, is asked
/// about, another is opened.
void takeDrop(Shell& shell, const std::vector<fs::path>& drops) {
  finishWhatIsDragged(shell);
  const bool isAsked =
      shell.files.question().kind != app::FileQuestion::Kind::none || shell.files.isOpening();
  const app::Session* const character = shell.open.character();
  const std::vector<fs::path> paths = droppedPaths(drops);
  if (!isAsked && showsClip(shell) && takeDroppedReference(shell, drops)) {
    return;
  }
  DroppedFile dropped{paths.front()};
  if (!isAsked && character != nullptr && paths.size() == 1) {
    // A file of another program is not read to ask: it may be a clip.
    const bool isForeign = interchange::isForeignName(paths.front().extension().string());
    dropped.canBeHeld =
        !isForeign && !app::handsForProp(*character).empty() && gltf::looksLikeThing(paths.front());
    dropped.hasClips = isForeign || !app::factsOf(paths.front()).clips.empty();
  }
  if (dropped.canBeHeld || dropped.hasClips) {
    shell.ui.dialogs.dropped = dropped;
  } else {
    openFile(shell, paths);
  }
}

/// Of the name and name-2, name-3 and so on the first that nothing in the folder has.
std::string freeName(const fs::path& folder, const fs::path& name) {
  const std::string stem = name.stem().string();
  const std::string extension = name.extension().string();
  std::error_code ignored;
  fs::path free = name;
  for (int number = 2; number < 1000 && fs::exists(folder / free, ignored); ++number) {
    free = fmt::format("{}-{}{}", stem, number, extension);
  }
  return free.string();
}

std::string proposedName(const Shell& shell, FilePurpose purpose) {
  if (const app::SequenceSession* const sequence = shell.open.sequence()) {
    return sequence->document().mesh->name + (purpose == FilePurpose::saveModuli ? "-moduli.json" : ".glb");
  }
  const app::Session* const character = shell.open.character();
  if (character == nullptr) {
    return {};
  }
  const fs::path near = character->proposedSavePath();
  return purpose == FilePurpose::exportClean  ? near.stem().string() + "-clean.glb"
         : purpose == FilePurpose::saveStyle  ? app::fileOfName({}, chosenStyle(shell).name).string()
         : purpose == FilePurpose::saveRecipe ? near.stem().string() + "-recipe.json"
         : purpose == FilePurpose::saveFilm   ? near.stem().string() + ".mp4"
                                              : near.filename().string();
}

} // namespace

void keepView(Shell& shell) {
  const app::Session& session = *shell.open.character();
  app::ViewState kept = session.view();
  const Vec2 range = session.rangeByHand().value_or(Vec2(0.0, -1.0)); // The trail's follows from the trail.
  kept.rangeStart = range.x;
  kept.rangeEnd = range.y;
  const std::string view = viewText(kept, {shell.viewport.camera, shell.viewport.look.name},
                                    shell.viewport.look.kept, app::referencesToJson(session.document()));
  tellProblem(shell, writeText(viewPath(shell.files.path()), view));
  if (!session.savePath().empty() && session.savePath() != shell.files.path()) {
    tellProblem(shell, writeText(viewPath(session.savePath()), view));
  }
}

void openFile(Shell& shell, const std::vector<fs::path>& paths) {
  WindowUser user(shell);
  shell.files.openFile(user, paths);
}

void askForFile(Shell& shell, FilePurpose purpose) {
  if (shell.open.sequence() != nullptr &&
      (purpose == FilePurpose::saveModel || purpose == FilePurpose::exportClean)) {
    purpose = FilePurpose::exportSequence;
  }
  FileDialogState& dialog = shell.ui.dialogs.file;
  dialog = {};
  dialog.open = true;
  dialog.purpose = purpose;
  std::error_code ignored;
  const app::Session* const character = shell.open.character();
  const fs::path near = character != nullptr ? character->proposedSavePath() : shell.files.path();
  dialog.folder =
      near.has_parent_path() ? fs::absolute(near.parent_path(), ignored) : fs::current_path(ignored);
  if (isSaving(purpose)) {
    const std::string name = proposedName(shell, purpose);
    // The open file itself is meant to be written over.
    const bool isOpenFile =
        character != nullptr && purpose == FilePurpose::saveModel && !character->savePath().empty();
    dialog.typed = isOpenFile ? name : freeName(dialog.folder, name);
    dialog.remark = purpose == FilePurpose::saveFilm ? "Draws " + filmedText(shell) : std::string();
  }
}

Status openBundled(Shell& shell, const std::string& name) {
  const std::optional<fs::path> folder = app::bundledFolder();
  if (!folder) {
    return Error{"the bundled clips are not there", name, "install the program again"};
  }
  openFile(shell, {*folder / name});
  return Success{};
}

void saveFile(Shell& shell) {
  if (shell.open.sequence() != nullptr) {
    askForFile(shell, FilePurpose::exportSequence);
    return;
  }
  WindowUser user(shell);
  shell.files.save(user);
}

void saveIncremental(Shell& shell) {
  WindowUser user(shell);
  shell.files.saveIncremental(user);
}

void askToQuit(Shell& shell) {
  if (shell.beside.film.job != nullptr) {
    shell.ui.dialogs.lostFilm = shell.beside.film.path.filename().string();
    return;
  }
  WindowUser user(shell);
  shell.files.quit(user);
}

void updateFileWork(Shell& shell, const InputQueue& input, double nowSeconds) {
  WindowUser user(shell);
  updateSequence(shell);
  updateBinding(shell);
  updateFilm(shell);
  updateFitting(shell);
  updateClipImport(shell);
  updateClipStyle(shell);
  updatePoseLibrary(shell);
  takeAnswers(shell);
  if (!input.drops.empty()) {
    takeDrop(shell, input.drops);
  }
  if (std::exchange(shell.ui.answers.quitWithoutFilm, false)) {
    shell.beside.film = {};
    askToQuit(shell);
  }
  if (input.closeAsked) {
    askToQuit(shell);
  }
  if (input.focusGained) {
    shell.files.returned(user);
  }
  shell.files.update(user, nowSeconds);
  if (app::Session* const character = shell.open.character()) {
    character->view().keyPlaces = shell.ui.savedForm.keys;
  }
  askForName(shell, shell.nameAsked);
  shell.nameAsked = shell.files.question().kind == app::FileQuestion::Kind::name;
}

void closeFile(Shell& shell) {
  WindowUser user(shell);
  shell.files.close(user);
}

std::string windowTitle(const Shell& shell) {
  std::string program = "Stretch-Engine";
  if (shell.open.isEmpty()) {
    return program;
  }
  return (app::wouldLoseWork(shell.open) ? "\xE2\x97\x8F " : "") + openFileName(shell) + " \xE2\x80\x93 " +
         program;
}

std::string openFileName(const Shell& shell) {
  if (shell.open.isEmpty()) {
    return {};
  }
  const app::Session* const character = shell.open.character();
  const bool isSaved = character != nullptr && !character->savePath().empty();
  return app::shownName(isSaved ? character->savePath() : shell.files.path());
}

void saveRecipeFile(Shell& shell, const std::filesystem::path& path) {
  const gltf::Json json =
      app::recipeToJson(shell.open.character()->document(), shell.open.character()->view().clip);
  const Status done = writeText(path, json.dump(2, ' ', false, gltf::Json::error_handler_t::replace) + "\n");
  tellProblem(shell, done);
  if (done) {
    tell(shell, ToastKind::success, "Saved the recipe " + path.filename().string());
  }
}

void addPropFile(Shell& shell, const std::filesystem::path& path) {
  app::Session& session = *shell.open.character();
  const std::vector<std::string> hands = app::handsForProp(session);
  Result<app::AddedProp> added =
      app::putIntoHands(session.document(), {path, hands, session.view().clip, session.view().frame, {}});
  if (!added) {
    tell(shell, ToastKind::error, added.error().line());
    return;
  }
  session.edit(std::move(added->document), "Add a prop");
  std::vector<std::string> arms;
  arms.reserve(hands.size());
  for (const std::string& hand : hands) {
    arms.push_back(app::limbTitle(session.document(), hand));
  }
  tell(shell, ToastKind::success, fmt::format("{} is held by the {}", added->node, app::listed(arms)));
  for (const std::string& warning : added->warnings) {
    tell(shell, ToastKind::warning, warning);
  }
}

namespace {

/// "2 trails from the recipe", "3 things from the recipe" where there are others among them.
std::string replayedText(const app::Recipe& recipe) {
  std::size_t count = 0;
  app::eachList(recipe, [&](const auto& things) { count += things.size(); });
  const bool areTrails = count > 0 && count == recipe.trails.size();
  return fmt::format("{} {}{} from the recipe", count, areTrails ? "trail" : "thing", count == 1 ? "" : "s");
}

} // namespace

void loadRecipeFile(Shell& shell, const std::filesystem::path& path) {
  app::Document document = shell.open.character()->document();
  const Result<app::Recipe> recipe =
      app::loadRecipe(path, document, shell.open.character()->view().clip); // whatever it was made from
  if (!recipe) {
    tell(shell, ToastKind::error, recipe.error().line());
    return;
  }
  Result<app::PlacedTrails> changed = app::withRecipe(document, *recipe);
  if (!changed) {
    tell(shell, ToastKind::error, changed.error().line());
    return;
  }
  shell.open.character()->edit(std::move(changed->document), "Replay a recipe");
  tell(shell, ToastKind::success, replayedText(*recipe));
  tellGaveWay(shell, document);
}

} // namespace stretch::ui
