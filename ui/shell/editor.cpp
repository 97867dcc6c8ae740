#include "ui/shell/editor.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/commands/table/command_ids.h"
#include "ui/panels/context/panels.h"
#include "ui/shell/file_work.h"
#include "ui/shell/key_pane.h"
#include "ui/shell/playback.h"
#include "ui/shell/pose_library.h"
#include "ui/shell/shell_commands.h"
#include "ui/shell/style_work.h"
#include "ui/shell/tour.h"
#include "ui/shell/welcome_keys.h"
#include "ui/shell/window/gui.h"
#include "ui/viewport/viewport_pane.h"

namespace stretch::ui {

namespace {

constexpr double liveSeconds = 0.8; ///< Drawn on for this long after the last event: tooltips come up
                                    ///< meanwhile.

/// The parts of a running editor, in the order in which they are made.
struct Editor {
  Window window;
  Gui gui;
  std::unique_ptr<ViewportGpu> gpu;
  PosePictures poses;
  Shell shell;
  EditorHand* hand = nullptr;
  float scaleOption = 0.0F;
  double liveUntil = 0.0;
  bool worked = false; ///< Something went on beside the window in the frame before.
};

int failWith(const Error& error) {
  std::fprintf(stderr, "stretch-engine: %s\n", error.line().c_str());
  return 1;
}

void readUserFiles(Shell& shell) {
  const auto settings = readText(settingsPath());
  if (settings) {
    readSettings(*settings, shell.ui, shell.panes, shell.window);
  }
  loadStyles(shell.ui.trails);
  shell.ui.dialogs.navigationChoiceOpen = !settings;
  shell.ui.tour.pending = shell.ui.tour.pending || !settings;
  shell.commands = editorCommands();
  shell.keymap = app::Keymap(app::keyedCommands(shell.commands));
  if (const auto keys = readText(keysPath())) {
    tellProblem(shell, shell.keymap.readJson(*keys));
  }
}

void rememberWindow(Editor& editor) {
  Shell& shell = editor.shell;
  const WindowSize size = editor.window.size();
  const float scale = editor.window.contentScale();
  shell.window.maximised = glfwGetWindowAttrib(editor.window.handle(), GLFW_MAXIMIZED) == GLFW_TRUE;
  if (!shell.window.maximised) {
    shell.window.width = static_cast<int>(static_cast<float>(size.width) / scale);
    shell.window.height = static_cast<int>(static_cast<float>(size.height) / scale);
  }
}

void saveUserFiles(Editor& editor) {
  const Shell& shell = editor.shell;
  const Status settings = writeText(settingsPath(), settingsText(shell.ui, shell.panes, shell.window));
  if (!settings) {
    std::fprintf(stderr, "stretch-engine: %s\n", settings.error().line().c_str());
  }
}

void updateTheme(Editor& editor) {
  Shell& shell = editor.shell;
  const float screen = editor.scaleOption > 0.0F ? editor.scaleOption : editor.window.contentScale();
  const float wanted = screen * shell.ui.scale;
  if (shell.themeDirty || shell.theme.scale != wanted || shell.theme.kind != shell.ui.theme) {
    shell.theme = editor.gui.setTheme(shell.ui.theme, wanted);
    shell.themeDirty = false;
  }
}

void takeAnswers(Editor& editor) {
  Shell& shell = editor.shell;
  takeKeyAnswers(shell);
  UiAnswers& answers = shell.ui.answers;
  if (answers.overlap && shell.open.character() != nullptr) {
    tellProblem(shell, startExaggerating(shell, *std::exchange(answers.overlap, std::nullopt)));
  }
  bool changed = std::exchange(answers.themeChanged, false);
  if (answers.navigation) {
    shell.ui.navigation = *std::exchange(answers.navigation, std::nullopt);
    shell.ui.dialogs.navigationChoiceOpen = false;
    changed = true;
  }
  if (changed || std::exchange(answers.keepSettings, false)) {
    saveUserFiles(editor);
  }
}

/// Dialogs, text fields, open menus and lists.
bool widgetsTakeKeys(const Shell& shell) {
  return widgetsOwnKeys(shell) || ImGui::GetIO().WantTextInput ||
         ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

/// Undo and redo under the dialog of the reference, which changes the open clip at once.
bool reachesBehindDialog(const Shell& shell, const app::Chord& chord) {
  const std::string id = shell.keymap.commandOf(chord);
  return shell.ui.dialogs.reference.open && !ImGui::GetIO().WantTextInput &&
         (id == app::command::undo || id == app::command::redo);
}

/// Follows the operating system's layout, which may change at any time. Answers whether it did.
bool updateKeyboard(Shell& shell) {
  app::KeyboardLayout now = currentKeyboard();
  return std::exchange(shell.keyboard, now) != now;
}

void takeKeys(Editor& editor) {
  Shell& shell = editor.shell;
  shell.pressedKey.clear();
  for (KeyInput input : editor.window.input().keys) {
    input.press.chord.key = shell.keyboard.keyAt(input.press.chord.key);
    if (input.down) {
      hideTooltip();
    }
    const bool owned = widgetsTakeKeys(shell);
    if (!owned && input.down && (pressWelcomeKey(shell, input.press) || pressTourKey(shell, input.press))) {
      continue;
    }
    if (!owned || !input.down || reachesBehindDialog(shell, input.press.chord)) {
      dispatchKey(shell, input);
    } else if (input.down) {
      shell.pressedKey = app::chordText(input.press.chord);
    }
  }
}

/// A press outside of the viewport keeps what a running tool made.
void keepToolOnPress(Shell& shell) {
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left) && !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
    shell.ui.time.keys.pressTaken = false; // It ended over another pane.
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool outside = !shell.viewport.box.contains(mouse);
  if (isRunning(shell.tool) && outside && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    shell.ui.time.keys.pressTaken = std::holds_alternative<KeysTool>(shell.tool);
    finishTool(*shell.open.character(), shell.tool, true);
  }
}

/// Begins a pane's window; the caller ends it.
bool beginPane(const char* name, const Rect& rect, ImGuiWindowFlags extra = 0) {
  ImGui::SetNextWindowPos(rect.min);
  ImGui::SetNextWindowSize({std::max(rect.width(), 1.0F), std::max(rect.height(), 1.0F)});
  return ImGui::Begin(name, nullptr,
                      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoBringToFrontOnFocus | extra);
}

float drawMenu(PanelContext& context) {
  float height = 0.0F;
  if (ImGui::BeginMainMenuBar()) {
    drawMenuBar(context);
    height = ImGui::GetWindowSize().y;
    ImGui::EndMainMenuBar();
  }
  return height;
}

void drawSidePanes(PanelContext& context, const PanelSet& panels, const Shell& shell,
                   const PaneRects& rects) {
  if (shell.panes.leftOpen) {
    if (beginPane("left-pane", rects.left)) {
      panels.left(context);
    }
    ImGui::End();
  }
  if (shell.panes.rightOpen) {
    if (beginPane("right-pane", rects.right)) {
      panels.right(context);
    }
    ImGui::End();
  }
}

void drawBottomPanes(PanelContext& context, const PanelSet& panels, const Shell& shell,
                     const PaneRects& rects) {
  if (shell.panes.bottomOpen) {
    if (beginPane("bottom-pane", rects.bottom,
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
      panels.bottom(context);
    }
    ImGui::End();
  }
  if (beginPane("status-pane", rects.status,
                ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    drawStatusBar(context);
  }
  ImGui::End();
}

/// The bar of switches over the viewport; answers what is left for the picture.
Rect drawOverlayBar(PanelContext& context, const PanelSet& panels, const Rect& rect) {
  const float height = context.theme.rowHeight() + context.theme.unit();
  const Rect bar{rect.min, {rect.max.x, rect.min.y + height}};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.theme.unit(), 0.5F * context.theme.unit()});
  if (beginPane("viewport-bar", bar, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    panels.viewportBar(context);
  }
  ImGui::End();
  ImGui::PopStyleVar();
  return {{rect.min.x, rect.min.y + height}, rect.max};
}

void drawEverything(Editor& editor) {
  Shell& shell = editor.shell;
  const WindowSize size = editor.window.size();
  const EditorStatus status = statusOf(shell);
  PanelContext context{shell.open,      shell.ui,    shell.theme, shell.commandInfos,
                       shell.requested, shell.items, status};
  const PanelSet panels = panelSetOf(context);
  beginPanels(context);
  const float menuHeight = drawMenu(context);
  const auto width = static_cast<float>(size.width);
  const auto height = static_cast<float>(size.height);
  const PaneSizes sizes =
      sizesBeside(shell.panes, showsGraph(shell.open, shell.ui.time.tab), height / shell.theme.scale);
  const PaneRects rects = dividePanes(sizes, width, height, shell.theme.scale, menuHeight,
                                      shell.theme.rowHeight() + shell.theme.px(6.0F));
  drawSidePanes(context, panels, shell, rects);
  const double pixelsPerUnit = size.width > 0 ? static_cast<double>(size.framebufferWidth) / size.width : 1.0;
  ViewportContext viewport{context, shell.viewport, shell.tool};
  drawViewportPane(viewport, *editor.gpu, drawOverlayBar(context, panels, rects.viewport), pixelsPerUnit);
  drawBottomPanes(context, panels, shell, rects);
  drawTour(context, shell.viewport.box);
  drawSplitters(context, rects, shell.panes);
  drawDialogs(context);
}

void runRequested(Shell& shell) {
  const std::vector<std::string> requested = std::exchange(shell.requested, {});
  for (const std::string& id : requested) {
    runCommand(shell, id);
  }
}

/// Whether something goes on beside the window that it tells of.
bool worksBeside(const Shell& shell) {
  return isBusy(shell) || shell.beside.library.picture != nullptr || shell.ui.trails.clipStyle.working ||
         isReadingReference(shell.beside.reference) || shell.beside.reference.output.isPlaying();
}

/// What happens without a picture: files, keys, time. Answers whether something may look different.
bool update(Editor& editor) {
  Shell& shell = editor.shell;
  InputQueue& input = editor.window.input();
  const double now = clockSeconds();
  const bool works = worksBeside(shell);
  updateFileWork(shell, input, now);
  takeAnswers(editor);
  const bool otherKeyboard = updateKeyboard(shell);
  takeKeys(editor);
  const bool ended = std::exchange(editor.worked, works) && !works;
  const bool happened = ended || otherKeyboard || input.anything || shell.ui.time.timeline.playing ||
                        !shell.ui.toasts.empty() || isRunning(shell.tool) ||
                        shell.viewport.tipWatch.secondsLeft > 0.0F || editor.hand != nullptr;
  input.clear();
  editor.liveUntil = happened ? now + liveSeconds : editor.liveUntil;
  return works || now < editor.liveUntil;
}

void drawFrame(Editor& editor) {
  Shell& shell = editor.shell;
  const double began = clockSeconds();
  updateTheme(editor);
  describeCommands(shell);
  editor.gui.beginFrame(editor.window.input(), editor.hand != nullptr ? &editor.hand->mouse() : nullptr);
  play(shell, static_cast<double>(ImGui::GetIO().DeltaTime));
  updateReference(shell, began);
  updateTour(shell);
  updatePosePictures(editor.poses, shell.ui.body.library);
  keepToolOnPress(shell);
  editor.gpu->drewPicture = false;
  editor.gpu->paints = editor.hand == nullptr || editor.hand->paints();
  shell.ui.time.keys.hovered = false;
  drawEverything(editor);
  moveKeysTool(shell);
  runRequested(shell);
  editor.window.input().guiTakesKeys = widgetsTakeKeys(shell);
  editor.window.setTitle(windowTitle(shell));
  editor.gui.endFrame();
  if (editor.gpu->paints) {
    editor.gui.paint(shell.theme, editor.window.size());
  }
  if (editor.hand != nullptr) {
    editor.hand->afterFrame(shell, editor.window.size());
  }
  releaseTappedKeys(editor.window.input(), editor.window.handle());
  editor.window.present();
  if (editor.gpu->drewPicture && editor.hand == nullptr) {
    editor.gpu->governor.frameTook(clockSeconds() - began);
  }
}

double waitingTime(const Editor& editor) {
  if (editor.hand != nullptr || clockSeconds() < editor.liveUntil) {
    return 0.0;
  }
  // What only waits for work beside it draws now and then: drawn in software, a window takes the work's
  // processors.
  return worksBeside(editor.shell) ? 0.1 : 0.5;
}

void runLoop(Editor& editor) {
  Shell& shell = editor.shell;
  while (!shell.quit) {
    waitForEvents(waitingTime(editor));
    if (editor.hand != nullptr && !editor.hand->beforeFrame(shell, editor.window)) {
      break;
    }
    if (update(editor)) {
      drawFrame(editor);
    }
  }
  if (editor.hand != nullptr && editor.hand->abandons()) {
    return;
  }
  rememberWindow(editor);
  saveUserFiles(editor);
  closeFile(shell);
}

Result<Editor> openEditor(const EditorOptions& options) {
  Shell shell;
  readUserFiles(shell);
  const bool sized = options.width > 0 && options.height > 0;
  Result<Window> window = Window::open({.width = sized ? options.width : shell.window.width,
                                        .height = sized ? options.height : shell.window.height,
                                        .maximised = shell.window.maximised && !sized});
  if (!window) {
    return window.error();
  }
  Result<Gui> gui = Gui::create(*window);
  if (!gui) {
    return gui.error();
  }
  Result<std::unique_ptr<ViewportGpu>> gpu = createViewportGpu();
  if (!gpu) {
    return gpu.error();
  }
  return Editor{std::move(window).value(), std::move(gui).value(), std::move(gpu).value(), {},
                std::move(shell),          options.hand,           options.scale,          0.0};
}

} // namespace

int runEditor(const std::vector<std::filesystem::path>& files, const EditorOptions& options) {
  Result<Editor> editor = openEditor(options);
  if (!editor) {
    return failWith(editor.error());
  }
  if (options.hand != nullptr) {
    editor->shell.ui.dialogs.navigationChoiceOpen = false;
    editor->shell.ui.tour.pending = options.firstStart;
  }
  if (!files.empty()) {
    openFile(editor->shell, files);
  } else {
    editor->shell.files.offerAutosave({});
  }
  runLoop(*editor);
  return 0;
}

} // namespace stretch::ui
