#include "tests/support/ui/editor_stage.h"

#include <chrono>
#include <cstdlib>
#include <thread>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/commands/table/key.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/recording_device.h"
#include "ui/panels/context/panels.h"
#include "ui/shell/file_work.h"
#include "ui/shell/key_pane.h"
#include "ui/shell/playback.h"
#include "ui/shell/shell_commands.h"
#include "ui/shell/style_work.h"
#include "ui/shell/tour.h"
#include "ui/shell/welcome_keys.h"

namespace stretch::test {

using namespace ui;

namespace {

constexpr float windowWidth = 1440.0F;
constexpr float windowHeight = 860.0F;

void drawPane(const char* name, const Rect& box, PanelContext& context, void (*draw)(PanelContext&)) {
  ImGui::SetNextWindowPos(box.min);
  ImGui::SetNextWindowSize({std::max(1.0F, box.width()), std::max(1.0F, box.height())});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  draw(context);
  ImGui::End();
}

PaneRects rectsOf(const Shell& shell) {
  return dividePanes(sizesBeside(shell.panes, showsGraph(shell.open, shell.ui.time.tab), windowHeight),
                     windowWidth, windowHeight, 1.0F, 28.0F, 32.0F);
}

/// Where the picture would stand between the panes.
Rect pictureIn(const Shell& shell) {
  return rectsOf(shell).viewport;
}

void drawPanes(Shell& shell, PanelContext& context) {
  if (ImGui::BeginMainMenuBar()) {
    drawMenuBar(context);
    ImGui::EndMainMenuBar();
  }
  const PaneRects rects = rectsOf(shell);
  const PanelSet panels = panelSetOf(context);
  if (shell.panes.leftOpen) {
    drawPane("left", rects.left, context, panels.left);
  }
  if (shell.panes.rightOpen) {
    drawPane("right", rects.right, context, panels.right);
  }
  if (shell.panes.bottomOpen) {
    drawPane("bottom", rects.bottom, context, panels.bottom);
  }
  drawPane("status", rects.status, context, drawStatusBar);
  drawTour(context, rects.viewport);
  drawSplitters(context, rects, shell.panes);
  drawDialogs(context);
}

/// A line without a folder that is another one on each machine, or each time.
std::string withoutFolder(std::string line, const std::string& folder, const std::string& name) {
  const std::size_t at = line.find(folder);
  return at == std::string::npos ? line : line.replace(at, folder.size(), name);
}

std::string toolText(const Shell& shell) {
  EditorStatus status;
  describeTool(shell.tool, status);
  return status.modalText;
}

} // namespace

EditorStage::EditorStage() : gui_(ImGui::CreateContext(&PanelDriver::fonts())) {
  static_cast<void>(recordedSound()); // Nothing is heard.
  for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"}) {
    std::filesystem::create_directories(folder / variable);
    setenv(variable, (folder / variable).c_str(), 1);
  }
  std::filesystem::current_path(folder / "HOME"); // Where a sequence that has no folder is exported to.
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {windowWidth, windowHeight};
  io.DeltaTime = 1.0F / 60.0F;
  io.MousePos = {700.0F, 5.0F};
  for (const int key :
       {ImGuiKey_Enter, ImGuiKey_Escape, ImGuiKey_DownArrow, ImGuiKey_UpArrow, ImGuiKey_LeftArrow,
        ImGuiKey_RightArrow, ImGuiKey_PageUp, ImGuiKey_PageDown, ImGuiKey_Space, ImGuiKey_Tab}) {
    io.KeyMap[key] = key + 1;
  }
  shell.theme = PanelDriver::sharedTheme();
  applyStyle(shell.theme);
  shell.commands = editorCommands();
  shell.keymap = app::Keymap(app::keyedCommands(shell.commands));
  frames(2);
}

EditorStage::~EditorStage() {
  std::filesystem::current_path(startedIn_);
  ImGui::DestroyContext(gui_);
}

void EditorStage::update(const InputQueue& input) {
  updateFileWork(shell, input, now_);
}

void EditorStage::frame() {
  now_ += 1.0 / 60.0;
  update({});
  describeCommands(shell);
  status_ = statusOf(shell);
  ImGui::NewFrame();
  play(shell, 1.0 / 60.0);
  updateReference(shell, now_);
  updateTour(shell);
  shell.ui.time.keys.hovered = false;
  shell.viewport.box = pictureIn(shell);
  shell.viewport.view = makeView(shell.viewport.camera, {800.0, 600.0, 1.0});
  PanelContext context{shell.open,      shell.ui,    shell.theme, shell.commandInfos,
                       shell.requested, shell.items, status_};
  beginPanels(context);
  drawPanes(shell, context);
  moveKeysTool(shell);
  for (const std::string& id : std::exchange(shell.requested, {})) {
    runCommand(shell, id);
  }
  takeKeyAnswers(shell);
  ImGui::Render();
}

void EditorStage::frames(int count) {
  for (int i = 0; i < count; ++i) {
    frame();
  }
}

void EditorStage::settle() {
  constexpr int most = 20000;
  int waited = 0;
  const auto isWorking = [&] {
    return isBusy(shell) || shell.ui.trails.clipStyle.working || shell.beside.library.picture != nullptr ||
           isReadingReference(shell.beside.reference);
  };
  while (isWorking() && waited < most) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    update({});
    updateReference(shell, now_);
    ++waited;
  }
  REQUIRE(waited < most);
  frames(waited > 0 ? 2 : 0);
}

void EditorStage::press(const std::string& chord) {
  KeyInput input;
  INFO(chord);
  const auto parsed = app::parseChord(chord);
  REQUIRE(parsed);
  input.press.chord = *parsed;
  if (widgetsOwnKeys(shell)) {
    shell.pressedKey = app::chordText(*parsed);
    frame();
    shell.pressedKey.clear();
  } else if (!pressWelcomeKey(shell, input.press) && !pressTourKey(shell, input.press)) {
    dispatchKey(shell, input);
    input.down = false;
    dispatchKey(shell, input);
  }
  frames(2);
}

void EditorStage::type(const std::string& text) {
  ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
  frames(2);
}

void EditorStage::pressWidgetKey(int imguiKey) {
  ImGui::GetIO().KeysDown[imguiKey + 1] = true;
  frame();
  ImGui::GetIO().KeysDown[imguiKey + 1] = false;
  frames(2);
}

void EditorStage::click(const std::string& widget) {
  const Item* const found = shell.items.find(widget);
  INFO("widget " << widget);
  REQUIRE(found != nullptr);
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = found->centre();
  frames(2);
  io.MouseDown[0] = true;
  frame();
  io.MouseDown[0] = false;
  frames(30); // So that the next click is no double click.
}

void EditorStage::run(const std::string& command) {
  shell.requested.push_back(command);
  frames(2);
}

void EditorStage::drop(const std::vector<std::filesystem::path>& files) {
  InputQueue input;
  input.drops = files;
  update(input);
  frames(2);
}

void EditorStage::openBoxer() {
  const std::filesystem::path file = folder / "dummy.glb";
  std::filesystem::copy_file(STRETCH_SOURCE_DIR "/assets/dummy.glb", file,
                             std::filesystem::copy_options::skip_existing);
  openFile(shell, {file});
  frames(2);
  settle();
  frames(2);
}

void EditorStage::askToClose() {
  InputQueue input;
  input.closeAsked = true;
  update(input);
  frames(2);
}

Lines EditorStage::lines() {
  Lines lines;
  if (shell.open.character() != nullptr) {
    addSession(lines, *shell.open.character());
  }
  if (const app::SequenceSession* const sequence = shell.open.sequence()) {
    ++lines["undo : " + sequence->history().undoLabel()];
    ++lines[fmt::format("sequence : frame {:.4g} , look {} , original {} , skinned {}",
                        sequence->view().frame, static_cast<int>(sequence->view().look),
                        sequence->view().showOriginal, sequence->view().showSkinned)];
  }
  addView(lines, shell.ui);
  const Camera& camera = shell.viewport.camera;
  ++lines[fmt::format(
      "camera : at {:.3f} {:.3f} {:.3f} , {:.3f} away , turned {:.3f} {:.3f} , {} , through '{}'",
      camera.target.x, camera.target.y, camera.target.z, camera.distance, camera.yawRadians,
      camera.pitchRadians, static_cast<int>(camera.projection), shell.viewport.look.name)];
  ++lines[fmt::format("camera : to frame all {} , selection {} , {} views kept", shell.viewport.framePending,
                      shell.viewport.frameSelectionPending, shell.viewport.look.kept.size())];
  ++lines[fmt::format("panes : {} {} {}", shell.panes.leftOpen, shell.panes.rightOpen,
                      shell.panes.bottomOpen)];
  ++lines["tool : " + toolText(shell)];
  ++lines["title : " + windowTitle(shell)];
  ++lines[fmt::format("question : {} , quit {}", static_cast<int>(shell.files.question().kind), shell.quit)];
  ++lines[fmt::format("tour : {}", shell.ui.tour.step)];
  const DialogStates& dialogs = shell.ui.dialogs;
  const std::pair<const char*, bool> open[] = {{"palette", dialogs.palette.open},
                                               {"keys", dialogs.keys.open},
                                               {"settings", dialogs.settingsOpen},
                                               {"about", dialogs.aboutOpen},
                                               {"history", dialogs.history.open},
                                               {"clash of ranges", dialogs.rangeClash.has_value()},
                                               {"clips of a file", !dialogs.clipPick.file.empty()},
                                               {"what a dropped file is for", !dialogs.dropped.path.empty()},
                                               {"retime", shell.ui.time.retime.open},
                                               {"joints", shell.ui.body.jointPick.open},
                                               {"style of the clip", shell.ui.trails.clipStyle.open},
                                               {"pose library", shell.ui.body.library.open}};
  for (const auto& [name, isOpen] : open) {
    lines[std::string("open : ") + name] += isOpen ? 1 : 0;
  }
  const FileDialogState& files = shell.ui.dialogs.file;
  if (files.open) {
    ++lines[fmt::format("dialog of files : for {} , typed '{}'", static_cast<int>(files.purpose),
                        files.typed)];
  }
  const PoseLibraryState& library = shell.ui.body.library;
  for (const app::LibraryPose& pose : library.poses) {
    ++lines["pose of the library : " + pose.name];
  }
  ++lines[fmt::format("library : {} chosen , {:.2f} of it , mirrored {} , typed '{}' , can be taken {} : {}",
                      library.chosen, library.amount, library.mirrored, library.typedName, library.reaches,
                      library.remark)];
  Lines placed;
  for (const auto& [line, count] : lines) {
    placed[withoutFolder(withoutFolder(line, folder.path().string(), "FOLDER"), STRETCH_SOURCE_DIR,
                         "SOURCE")] += count;
  }
  return placed;
}

} // namespace stretch::test
