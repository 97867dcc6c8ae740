#include "ui/panels/menus/context_menu.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "app/commands/table/selection.h"
#include "app/edits/pose/prop_file_edits.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/trail_colours.h"
#include "ui/panels/rows/shown_holds.h"
#include "ui/panels/rows/timeline_model.h"

namespace stretch::ui {

namespace {

using CommandIds = std::initializer_list<const char*>;

/// Entries by command id; an empty id is a separator.
struct MenuEntries {
  MenuTarget target;
  CommandIds ids;
};

constexpr CommandIds controllerEntries{command::controllerMove,
                                       command::controllerTurn,
                                       "",
                                       command::poseKey,
                                       command::poseDeleteKey,
                                       command::poseReset,
                                       command::poseWholeClip,
                                       "",
                                       command::poseCopy,
                                       command::posePaste,
                                       command::posePasteMirrored,
                                       command::poseMirror,
                                       "",
                                       command::holdPin,
                                       command::holdPinFeet,
                                       command::holdMatch,
                                       command::holdProp,
                                       command::propAdd,
                                       command::holdLetGo,
                                       command::holdRemove,
                                       "",
                                       command::controllersAll,
                                       command::controllersKeyed,
                                       "",
                                       command::viewFrameSelection,
                                       command::viewControllers};

constexpr CommandIds limbEntries{
    command::trailExaggerate, command::trailToggle,        command::weightToggle, "",
    command::holdPin,         command::holdPinFeet,        command::holdMatch,    command::holdProp,
    command::propAdd,         command::holdLetGo,          command::holdRemove,   "",
    command::copyTrail,       command::pasteTrail,         command::mirrorTrail,  "",
    command::trailDeleteAll,  command::viewFrameSelection, command::selectNone};

constexpr CommandIds viewportEntries{command::viewFrameAll,
                                     command::viewFrameSelection,
                                     "",
                                     command::viewFront,
                                     command::viewSide,
                                     command::viewTop,
                                     command::viewPerspective,
                                     "",
                                     command::viewControllers,
                                     command::viewSkeleton,
                                     command::viewWire,
                                     command::viewWeights,
                                     command::viewHeatMap,
                                     command::viewShadeAs,
                                     command::viewGhosts,
                                     command::viewGrid,
                                     command::viewSideBySide,
                                     "",
                                     command::viewNavigation};

/// What is done with the picked keys of graph and dope sheet, and at a frame beside them: above what a key
/// and a frame have everywhere.
constexpr CommandIds pickedEntries{command::keysDelete, command::keysCopy,
                                   command::keysPaste,  "",
                                   command::keysGrab,   command::keysScale,
                                   command::keysSnap,   "",
                                   command::keysAuto,   command::keysFlat,
                                   command::keysLinear, command::keysStepped,
                                   command::keysFree,   ""};
constexpr CommandIds besideKeysEntries{command::keysInsert, command::keysPaste, command::keysAll, ""};

/// After what is done with the one hold.
constexpr CommandIds holdEntryIds{"", command::holdPin,    command::holdPinFeet, command::holdMatch,
                                  "", command::rangeStart, command::rangeEnd,    command::rangeDefault};

CommandIds entriesOf(MenuTarget target) {
  using namespace command;
  static constexpr CommandIds trail{trailExaggerate,
                                    trailConnect,
                                    trailApply,
                                    trailFollow,
                                    trailBlend,
                                    "",
                                    trailRename,
                                    trailNextColour,
                                    "",
                                    trailSelectGroup,
                                    trailGroup,
                                    trailTakeApart,
                                    "",
                                    copyTrail,
                                    pasteTrail,
                                    mirrorTrail,
                                    "",
                                    trailToggle,
                                    viewFrameSelection,
                                    "",
                                    trailDelete};
  static constexpr CommandIds group{
      trailExaggerate, trailConnect,       trailApply, trailFollow,    trailBlend,  "",
      trailRename,     trailNextColour,    "",         trailTakeApart, mirrorTrail, "",
      trailToggle,     viewFrameSelection, "",         trailDelete};
  static constexpr CommandIds sphere{
      sphereGrab, sphereAlongBack, sphereAlongForward, "", spherePrevious, sphereNext, sphereAll,
      "",         sphereSmooth,    sphereReset,        "", editDelete};
  static constexpr CommandIds key{rangeStart,      rangeEnd,    rangeDefault, "",
                                  timePreviousKey, timeNextKey, "",           trailExaggerate,
                                  trailToggle,     sphereAdd,   "",           copyTrail};
  static constexpr CommandIds range{rangeStart, rangeEnd, rangeDefault, "", trailExaggerate, trailToggle};
  static constexpr CommandIds time{timePlay,   timeStart,    timeEnd, "",         rangeStart,
                                   rangeEnd,   rangeDefault, "",      clipRate24, clipRate25,
                                   clipRate30, clipRateOwn,  "",      clipLoop};
  static constexpr MenuEntries menus[] = {{MenuTarget::limb, limbEntries},
                                          {MenuTarget::trail, trail},
                                          {MenuTarget::group, group},
                                          {MenuTarget::sphere, sphere},
                                          {MenuTarget::controller, controllerEntries},
                                          {MenuTarget::hold, holdEntryIds},
                                          {MenuTarget::key, key},
                                          {MenuTarget::range, range},
                                          {MenuTarget::time, time}};
  for (const MenuEntries& menu : menus) {
    if (menu.target == target) {
      return menu.ids;
    }
  }
  return viewportEntries;
}

/// What is about a moment of the timeline: the playhead goes there when one of its entries is chosen.
bool isOfTime(MenuTarget target) {
  return target == MenuTarget::key || target == MenuTarget::range || target == MenuTarget::time;
}

/// Entries that act at the playhead.
bool actsAtPlayhead(std::string_view id) {
  using namespace command;
  constexpr std::array<std::string_view, 9> atPlayhead{rangeStart,  rangeEnd,        timePreviousKey,
                                                       timeNextKey, trailExaggerate, trailToggle,
                                                       sphereAdd,   keysInsert,      keysPaste};
  return std::find(atPlayhead.begin(), atPlayhead.end(), id) != atPlayhead.end();
}

/// "Go to this key": the one entry that is no command.
void goToEntry(PanelContext& context) {
  const UiState& ui = context.ui;
  const bool isKey = ui.menu.target == MenuTarget::key;
  const std::string text = isKey ? "Go to this key" : "Go to this frame";
  if (ImGui::MenuItem(text.c_str())) {
    context.character().view().frame = ui.menu.frame;
  }
  context.items.add("context/go-to", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  tooltip(widgetsOf(context),
          {text, "The playhead goes to frame " + shortNumber(ui.menu.frame, 1) + ".", {}});
}

std::string spheresText(const app::ViewState& view) {
  return view.selection.spheres().size() == 1
             ? "Sphere at frame " + shortNumber(view.selection.spheres().front(), 1)
             : std::to_string(view.selection.spheres().size()) + " spheres";
}

std::string controllersTitle(const app::Session& session) {
  const std::vector<std::string>& selected = session.view().selection.controllers();
  return selected.size() == 1 ? capitalised(app::controllerTitle(session.document(), selected.front()))
                              : std::to_string(selected.size()) + " controllers";
}

/// The hold that the menu is about; none after it was taken away.
std::optional<ShownHold> menuHold(const PanelContext& context) {
  const app::Session& session = context.character();
  for (const ShownHold& hold : shownHolds(session.document(), session.view().clip)) {
    if (barOfHold(hold.place) == context.ui.menu.hold) {
      return hold;
    }
  }
  return std::nullopt;
}

std::string holdText(const PanelContext& context) {
  const std::optional<ShownHold> hold = menuHold(context);
  return hold ? hold->title + ", " + shortNumber(hold->time.rangeFrames.x, 1) + " to " +
                    shortNumber(hold->time.rangeFrames.y, 1)
              : "Hold";
}

/// An entry that is no command.
bool plainEntry(PanelContext& context, const std::string& id, const char* text, const std::string& help) {
  const bool chosen = ImGui::MenuItem(text);
  context.items.add(id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  tooltip(widgetsOf(context), {text, help, {}});
  return chosen;
}

/// What is done with one hold: the working range becomes its range, it is taken away.
void holdEntries(PanelContext& context) {
  const std::optional<ShownHold> hold = menuHold(context);
  if (!hold) {
    return;
  }
  const Span working = shownSpan(context.character());
  if (plainEntry(context, "context/hold-range", "Hold over the working range",
                 "It holds from frame " + shortNumber(working.start, 1) + " to " +
                     shortNumber(working.end, 1) + ".")) {
    const Vec2 range(working.start, working.end);
    editHold(context, {true, true}, "Change the range of a hold", hold->place,
             [&](rig::HoldTime& time, double&) { time.rangeFrames = range; });
  }
  if (plainEntry(context, "context/hold-remove", "Take it away", hold->title + ": no longer held.")) {
    editOnce(context, "Take a hold away", app::takeHoldAway(context.character().document(), hold->place));
  }
}

/// What the menu is about.
std::string titleOf(const PanelContext& context, MenuTarget target) {
  if (target == MenuTarget::viewport) {
    return "View"; // Of a mesh sequence as well.
  }
  const app::Session& session = context.character();
  const app::ViewState& view = session.view();
  const rig::Trail* const trail = app::selectedTrail(session);
  switch (target) {
  case MenuTarget::limb:
    return view.selection.limbs().empty() ? "Limb"
                                          : limbHeading(session.document(), view.selection.limbs().back());
  case MenuTarget::trail:
    return trail == nullptr ? "Trail" : trailHeading(session.document(), *trail);
  case MenuTarget::group:
    return capitalised(app::groupTitle(session.document(), app::wholeGroupSelected(session)));
  case MenuTarget::sphere:
    return spheresText(view);
  case MenuTarget::controller:
    return controllersTitle(session);
  case MenuTarget::hold:
    return holdText(context);
  case MenuTarget::key:
    return "Key at frame " + shortNumber(context.ui.menu.frame, 1);
  case MenuTarget::range:
    return "Range, frame " + shortNumber(context.ui.menu.frame, 1);
  case MenuTarget::time:
    return "Frame " + shortNumber(context.ui.menu.frame, 1);
  case MenuTarget::viewport:
  case MenuTarget::nothing:
    break;
  }
  return "View";
}

void swatches(PanelContext& context) {
  const rig::Trail* const trail = app::selectedTrail(context.character());
  if (trail != nullptr && trailColours(context, *trail, "context/colour-")) {
    ImGui::CloseCurrentPopup();
  }
}

/// The title, what goes beside commands, and the commands.
void entries(PanelContext& context) {
  const MenuTarget target = context.ui.menu.target;
  const std::string title = titleOf(context, target);
  ImGui::PushFont(context.theme.fonts.label);
  ImGui::TextDisabled("%s", title.c_str());
  ImGui::PopFont();
  if (isOfTime(target)) {
    goToEntry(context);
  }
  if (target == MenuTarget::hold) {
    holdEntries(context);
  }
  const bool editsKeys = isOfTime(target) && context.ui.time.tab != BottomTab::timeline;
  std::vector<const char*> ids;
  if (editsKeys) {
    ids = target == MenuTarget::key ? pickedEntries : besideKeysEntries;
  }
  ids.insert(ids.end(), entriesOf(target).begin(), entriesOf(target).end());
  for (const char* id : ids) {
    if (id[0] == '\0') {
      ImGui::Separator();
    } else if (commandEntry(context, "context/", id) && isOfTime(target) && actsAtPlayhead(id)) {
      context.character().view().frame = context.ui.menu.frame; // The command runs after the panels.
    }
    if (std::string_view(id) == command::trailNextColour && target == MenuTarget::trail) {
      swatches(context);
    }
  }
}

/// The next window ends above what the menu is about, or begins below it where there is more room.
void placeMenu(const Theme& theme, const MenuPlace& place) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float gap = theme.px(4.0F);
  const float above = place.top - gap - theme.unit();
  const float below = screen.y - place.bottom - gap - theme.unit();
  const bool isAbove = above >= below;
  const float share = place.x / std::max(1.0F, screen.x); // The same of its width left of there: it stays
                                                          // inside.
  ImGui::SetNextWindowPos({place.x, isAbove ? place.top - gap : place.bottom + gap}, ImGuiCond_Always,
                          {share, isAbove ? 1.0F : 0.0F});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {FLT_MAX, isAbove ? above : below});
}

} // namespace

bool commandEntry(PanelContext& context, const std::string& prefix, const char* commandId) {
  const CommandInfo* info = findCommand(context, commandId);
  if (info == nullptr) {
    return false;
  }
  const std::string key = keyOf(context, commandId);
  const bool chosen =
      ImGui::MenuItem(info->label.c_str(), key.empty() ? nullptr : key.c_str(), info->checked, info->enabled);
  if (chosen) {
    request(context, commandId);
  }
  context.items.add(prefix + commandId, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), info->enabled);
  const std::string why = info->enabled ? "" : " Off: " + info->reason + ".";
  tooltip(widgetsOf(context), {info->label, info->help + why, key});
  return chosen;
}

void askForMenu(UiState& ui, MenuTarget target, const std::optional<MenuPlace>& place) {
  ui.menu.asked = target;
  ui.menu.place = place;
}

void drawContextMenu(PanelContext& context) {
  constexpr const char* name = "context-menu";
  UiState& ui = context.ui;
  if (const MenuTarget asked = std::exchange(ui.menu.asked, MenuTarget::nothing);
      asked != MenuTarget::nothing) {
    ui.menu.target = asked;
    ImGui::OpenPopup(name);
  }
  const Theme& theme = context.theme;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.unit(), theme.unit()));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(16.0F), theme.px(6.0F)));
  if (ui.menu.place) {
    placeMenu(theme, *ui.menu.place);
  }
  if (ImGui::BeginPopup(name)) {
    const ImVec2 corner = ImGui::GetWindowPos();
    context.items.add("context-menu", corner,
                      {corner.x + ImGui::GetWindowWidth(), corner.y + ImGui::GetWindowHeight()});
    context.items.items.back().explained = true; // By its entries.
    const bool isThere = context.open.character() != nullptr ||
                         (context.open.sequence() != nullptr && ui.menu.target == MenuTarget::viewport);
    if (!isThere || keyPressed(ImGuiKey_Escape)) {
      ImGui::CloseCurrentPopup();
    } else {
      entries(context);
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

} // namespace stretch::ui
