#include <algorithm>
#include <cfloat>
#include <iterator>
#include <string>
#include <vector>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "rig/plan/body_plan.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/menus/context_menu.h"
#include "ui/widgets/icons.h"

namespace stretch::ui {

namespace {

/// A menu's entries by command id; an empty id is a separator.
struct Menu {
  const char* title;
  std::vector<const char*> commands;
};

void recentFiles(PanelContext& context) {
  if (context.ui.recentFiles.empty() || !ImGui::BeginMenu("Open recent")) {
    return;
  }
  for (const std::filesystem::path& path : context.ui.recentFiles) {
    if (ImGui::MenuItem(path.filename().string().c_str())) {
      context.ui.answers.file = FileChoice{FilePurpose::openModel, path};
    }
    tooltip(widgetsOf(context), {path.filename().string(), path.parent_path().string(), {}});
  }
  ImGui::EndMenu();
}

/// A triangle at the edge beyond which an open menu that scrolls goes on.
void markMore(const Theme& theme, bool below) {
  const ImVec2 corner = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  const float strip = theme.px(18.0F);
  const float top = below ? corner.y + size.y - strip : corner.y;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(corner, {corner.x + size.x, corner.y + size.y});
  const float edge = theme.px(1.0F);
  list.AddRectFilled({corner.x + edge, top + (below ? 0.0F : edge)},
                     {corner.x + size.x - edge, top + strip - (below ? edge : 0.0F)}, theme.colours.raised);
  const ImVec2 middle(corner.x + 0.5F * size.x, top + 0.5F * strip);
  const float half = theme.px(5.0F);
  const float point = below ? 0.6F * half : -0.6F * half;
  list.AddTriangleFilled({middle.x - half, middle.y - point}, {middle.x + half, middle.y - point},
                         {middle.x, middle.y + point}, theme.colours.text);
  list.PopClipRect();
}

void drawMenu(PanelContext& context, const Menu& menu, bool withRecent) {
  // One that is taller than the window would cover its own title, and so be closed at once: it scrolls
  // instead.
  const float below = ImGui::GetIO().DisplaySize.y - ImGui::GetFrameHeight() - 2.0F * context.theme.unit();
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {FLT_MAX, below});
  const bool open = ImGui::BeginMenu(menu.title);
  context.items.add(std::string("menu/") + menu.title, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  if (!open) {
    return;
  }
  bool first = true;
  for (const char* id : menu.commands) {
    if (id[0] == '\0') {
      ImGui::Separator();
    } else {
      commandEntry(context, "menu/", id);
    }
    if (first && withRecent) {
      recentFiles(context);
    }
    first = false;
  }
  if (ImGui::GetScrollY() < ImGui::GetScrollMaxY()) {
    markMore(context.theme, true);
  }
  if (ImGui::GetScrollY() > 0.0F) {
    markMore(context.theme, false);
  }
  if (keyPressed(ImGuiKey_Escape)) {
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndMenu();
}

/// What is open, whether it holds work that no file has, and the button that saves it: at the bar's right
/// end, where they are seen in full screen as well.
void openFileName(PanelContext& context) {
  const EditorStatus& status = context.status;
  const Theme& theme = context.theme;
  if (status.fileName.empty()) {
    return;
  }
  const WidgetContext widgets = widgetsOf(context);
  // In a narrow window the button's picture says enough, and the name has the room.
  const bool isNarrow = ImGui::GetContentRegionAvail().x < theme.px(170.0F);
  const float saveWidth = isNarrow ? theme.rowHeight() : theme.px(72.0F);
  const float gap = theme.unit();
  const float markWidth = status.unsaved ? theme.px(14.0F) : 0.0F;
  const float free = ImGui::GetContentRegionAvail().x - saveWidth - 2.0F * gap; // One at the window's edge.
  const float width =
      std::min(free, textSize(theme.fonts.body, status.fileName).x + markWidth + theme.px(4.0F));
  if (free < 0.0F) {
    return;
  }
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + free - width);
  const Control place = takePlace(widgets, "menu-bar/file", {width, ImGui::GetFrameHeight()}, false);
  if (status.unsaved) {
    ImGui::GetWindowDrawList()->AddCircleFilled({place.box.min.x + theme.px(5.0F), place.box.centre().y},
                                                theme.px(4.0F), theme.colours.accent);
  }
  drawText(widgets, theme.fonts.body, {{place.box.min.x + markWidth, place.box.min.y}, place.box.max},
           theme.colours.text, cutInMiddle(theme.fonts.body, status.fileName, width - markWidth));
  tooltip(
      widgets,
      {status.fileName, status.unsaved ? "Holds work that is not saved yet." : "Everything is saved.", {}});
  ImGui::SameLine(0.0F, gap);
  commandButton(context, {.command = command::fileSave,
                          .icon = icon::save,
                          .text = isNarrow ? " " : "Save",
                          .emphasis = status.unsaved ? Emphasis::primary : Emphasis::normal,
                          .width = saveWidth});
}

/// Copies and pastes the pose where no trail can be copied or pasted.
void editMenu(PanelContext& context) {
  using namespace command;
  const auto isOn = [&](const char* id) {
    const CommandInfo* const info = findCommand(context, id);
    return info != nullptr && info->enabled;
  };
  const bool isPosing = isOn(poseCopy) && !isOn(copyTrail) && !isOn(pasteTrail);
  drawMenu(context,
           isPosing
               ? Menu{"Edit", {undo, redo, history, "", poseCopy, posePaste, posePasteMirrored, "", settings}}
               : Menu{"Edit", {undo, redo, history, "", copyTrail, pasteTrail, mirrorTrail, "", settings}},
           false);
}

void poseMenu(PanelContext& context) {
  using namespace command;
  drawMenu(context,
           {"Pose",
            {controllerMove,
             controllerTurn,
             "",
             controllerNext,
             controllerPrevious,
             controllersAll,
             controllersKeyed,
             "",
             poseKey,
             poseDeleteKey,
             poseAutoKey,
             poseWholeClip,
             "",
             poseReset,
             poseResetRange,
             poseResetRig,
             poseResetRigRange,
             "",
             poseMirror,
             poseCopy,
             poseCopyOffsets,
             posePaste,
             posePasteMirrored,
             poseLibrary,
             poseKeep,
             poseTween,
             "",
             poseCurlMore,
             poseCurlLess,
             "",
             poseKeyAutomatic,
             poseKeyFlat,
             poseKeyLinear,
             poseKeyStepped,
             poseKeyFree}},
           false);
}

/// The limbs that the character has keys for; a biped's where none is open.
std::vector<const char*> limbMenuEntries(const PanelContext& context) {
  constexpr std::size_t ofBiped = 6;
  const app::Session* const character = context.open.character();
  const std::size_t limbs = character == nullptr ? ofBiped : app::limbsByKey(character->document()).size();
  const std::size_t shown = std::min(limbs, command::limbSlots.size());
  return {command::limbSlots.begin(), command::limbSlots.begin() + static_cast<std::ptrdiff_t>(shown)};
}

void drawLimbMenu(PanelContext& context) {
  using namespace command;
  std::vector<const char*> entries = limbMenuEntries(context);
  for (const char* const id : {selectAllLimbs, selectNone, "", selectionKeep, selectionNext, selectionRename,
                               selectionForget, "", weightToggle, weightAll, weightRemove, "", holdPin,
                               holdPinFeet, holdMatch, holdProp, holdLetGo, holdRemove}) {
    entries.push_back(id);
  }
  drawMenu(context, {"Limb", std::move(entries)}, false);
}

void drawRigMenu(PanelContext& context) {
  using namespace command;
  std::vector<std::string> plans;
  for (const rig::BodyPlan& plan : rig::bodyPlans()) {
    plans.push_back(planPrefix + plan.id);
  }
  std::vector<const char*> entries{
      pickChain,    detectAgain, "",      locatorsFit, locatorsReset, locatorsMirror,
      locatorsSnap, rigBuild,    rigBack, "",          bindMesh,      ""};
  std::ranges::transform(plans, std::back_inserter(entries), &std::string::c_str);
  drawMenu(context, {"Rig", std::move(entries)}, false);
}

} // namespace

namespace {

void drawTrailMenu(PanelContext& context) {
  using namespace command;
  drawMenu(context,
           {"Trail",
            {clipExaggerate,
             styleTake,
             styleImport,
             styleExport,
             "",
             trailToggle,
             trailExaggerate,
             trailConnect,
             trailFollow,
             trailApply,
             trailApplyAll,
             "",
             trailBlend,
             trailShowOriginal,
             "",
             trailGroup,
             trailTakeApart,
             trailSelectGroup,
             "",
             spherePrevious,
             sphereNext,
             sphereAdd,
             sphereReset,
             sphereSmooth,
             "",
             trailDelete,
             trailDeleteAll}},
           false);
}

void drawKeysMenu(PanelContext& context) {
  using namespace command;
  drawMenu(context, {"Keys", {keysInsert, keysDelete,  keysCopy,      keysPaste,  keysAll, "",
                              keysGrab,   keysScale,   keysSnap,      keysRetime, "",      keysAuto,
                              keysFlat,   keysLinear,  keysStepped,   keysFree,   "",      graphIsolate,
                              "",         keysRestore, keysRestoreAll}},
           false);
}

void viewMenu(PanelContext& context) {
  using namespace command;
  Menu menu{"View", {viewFrameSelection, viewFrameAll, viewBest,        "",           viewFront,
                     viewSide,           viewTop,      viewPerspective, viewCamera,   viewSafeFrame,
                     reference,          "",           viewControllers, viewSkeleton, viewWire,
                     viewJointNames,     viewWeights,  viewHeatMap,     viewShadeAs,  viewGhosts,
                     viewFrameNumbers,   viewGrid,     viewReference,   viewCube,     viewSideBySide}};
  menu.commands.insert(menu.commands.end(), {"", showTimeline, showGraph, showDopeSheet});
  drawMenu(context, menu, false);
}

} // namespace

void drawMenuBar(PanelContext& context) {
  using namespace command;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.theme.unit(), context.theme.unit()));
  constexpr float wideWindow = 720.0F; // Design pixels: the menus, the file's name and Save have room.
  const float gap = ImGui::GetIO().DisplaySize.x < context.theme.px(wideWindow) ? 7.0F : 16.0F;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.theme.px(gap), context.theme.px(8.0F)));
  drawMenu(context,
           {"File",
            {fileOpen, bundledPunch, bundledSwing, bundledLeap, "", fileSave, fileSaveAs, fileSaveIncremental,
             fileExportClean, fileFilm, "", clipImport, propAdd, "", recipeLoad, recipeSave, "", fileQuit}},
           true);
  editMenu(context);
  drawLimbMenu(context);
  drawRigMenu(context);
  poseMenu(context);
  drawTrailMenu(context);
  drawKeysMenu(context);
  drawMenu(context,
           {"Time", {timePlay,    timeBack,       timeForward,  timeFarBack, timeFarForward, timePreviousKey,
                     timeNextKey, momentPrevious, momentNext,   warningNext, timeStart,      timeEnd,
                     "",          rangeStart,     rangeEnd,     "",          timeEveryFrame, timeOnTwos,
                     "",          clipChoose,     clipPrevious, clipNext,    clipRate24,     clipRate25,
                     clipRate30,  clipRateOwn}},
           false);
  viewMenu(context);
  drawMenu(context, {"Help", {palette, keys, tour, about}}, false);
  openFileName(context);
  ImGui::PopStyleVar(2);
}

} // namespace stretch::ui
