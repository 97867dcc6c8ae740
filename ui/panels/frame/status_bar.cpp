#include <algorithm>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/evaluate/pops.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

float hintWidth(const PanelContext& context, const KeyHint& hint) {
  const Theme& theme = context.theme;
  const float cap =
      std::max(theme.px(18.0F), std::ceil(textSize(theme.fonts.label, hint.key).x + theme.px(10.0F)));
  return cap + theme.px(6.0F) + textSize(theme.fonts.label, hint.does).x + theme.px(14.0F);
}

constexpr float afterText = 20.0F; ///< Points.

/// What texts leave free at the row's end while a tool runs: room for its first hints, which end it.
float roomForHints(const PanelContext& context) {
  constexpr std::size_t needed = 4;
  float room = context.theme.px(afterText);
  const std::vector<KeyHint>& hints = context.status.keyHints;
  for (std::size_t i = 0; i < std::min(needed, hints.size()); ++i) {
    room += hintWidth(context, hints[i]);
  }
  return room;
}

/// Draws text at the cursor, moves on and returns what the mouse does with it; nothing where the row is full.
Control statusText(PanelContext& context, const std::string& id, const std::string& text, ImU32 colour,
                   const Help& help, bool isButton = false) {
  const WidgetContext widgets = widgetsOf(context);
  const float width = std::min(textSize(context.theme.fonts.label, text).x + 2.0F,
                               ImGui::GetContentRegionAvail().x - roomForHints(context));
  if (width < context.theme.px(24.0F)) {
    return {};
  }
  const Control place = takePlace(widgets, id, {width, context.theme.rowHeight()}, isButton);
  drawText(widgets, context.theme.fonts.label, place.box, colour, text);
  const bool cut = textSize(context.theme.fonts.label, text).x > width;
  tooltip(widgets, cut ? Help{text, help.text, help.keyText} : help);
  ImGui::SameLine(0.0F, context.theme.px(afterText));
  return place;
}

std::string controllersText(const app::Session& session) {
  const std::vector<std::string>& ids = session.view().selection.controllers();
  std::string text;
  for (const std::string& id : ids) {
    text += (text.empty() ? "" : ", ") + app::controllerTitle(session.document(), id);
  }
  return capitalised(ids.size() > 4 ? std::to_string(ids.size()) + " controllers" : text) +
         (session.view().unkeyed.empty() ? "" : ", posed without a key");
}

std::string selectionText(const app::Session& session) {
  const app::ViewState& view = session.view();
  if (app::hasControllers(session)) {
    return controllersText(session);
  }
  if (!view.selection.locators().empty()) {
    return view.selection.locators().size() == 1
               ? "Locator " + view.selection.locators().front()
               : std::to_string(view.selection.locators().size()) + " locators";
  }
  const std::string keys =
      app::hasPickedKeys(session) ? app::selectionTitle(session.document(), view.pickedKeys) : std::string();
  if (view.selection.limbs().empty()) {
    return keys.empty() ? "Nothing selected" : capitalised(keys);
  }
  std::string text;
  for (const std::string& limb : view.selection.limbs()) {
    text += (text.empty() ? "" : ", ") + app::limbTitle(session.document(), limb);
  }
  if (!view.selection.spheres().empty()) {
    const bool one = view.selection.spheres().size() == 1;
    text += one ? ", sphere at frame " + shortNumber(view.selection.spheres().front(), 1)
                : ", " + std::to_string(view.selection.spheres().size()) + " spheres";
  }
  text += keys.empty() ? keys : ", " + keys;
  return capitalised(text);
}

// The panel tells them in full, below where a low window ends.
void popsPart(PanelContext& context) {
  const std::vector<app::LimbPop>& pops = context.character().pops();
  if (pops.empty()) {
    return;
  }
  const std::string text = std::to_string(pops.size()) + (pops.size() == 1 ? " warning" : " warnings");
  const Help help{"Warnings; a click goes to the next", capitalised(app::popWarning(pops.front())) + "."};
  const Control place =
      statusText(context, "status/warnings", text, context.theme.colours.warning, help, true);
  if (place.hovered) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  if (place.clicked) {
    request(context, command::warningNext);
  }
}

void selectionPart(PanelContext& context) {
  app::Session& session = context.character();
  if (context.status.modalText.empty()) { // which names its limb itself
    statusText(context, "status/selection", selectionText(session), context.theme.colours.text,
               {"What is selected", "", {}});
  }
  if (app::hasControllers(session)) {
    popsPart(context);
  }
  const rig::SolvedTrail* solved = app::solvedTrail(session, session.view().selection.trail());
  if (solved == nullptr) {
    return;
  }
  const TipLengths lengths = tipLengths(session, *solved);
  statusText(context, "status/tip", "tip " + lengthsText(lengths), context.theme.colours.quietText,
             {"Length of the limb at the trail's tip", "In the source clip, and as it is now.", {}});
}

void addHint(const PanelContext& context, std::vector<KeyHint>& hints, const char* commandId,
             const char* does) {
  const CommandInfo* info = findCommand(context, commandId);
  if (info != nullptr && info->enabled && !info->keyText.empty()) {
    hints.push_back({info->keyText, does});
  }
}

/// What the keys do outside of tools: the next steps with what is selected, from the real keys.
std::vector<KeyHint> usualHints(const PanelContext& context) {
  std::vector<KeyHint> hints;
  if (!context.status.busyText.empty()) {
    addHint(context, hints, command::workStop, "stop");
  }
  if (context.open.sequence() != nullptr) {
    addHint(context, hints, command::sequenceCompress, "compress");
    addHint(context, hints, command::fileExportClean, "export");
    addHint(context, hints, command::timePlay, "play");
    addHint(context, hints, command::palette, "all commands");
    return hints;
  }
  if (!hasViewedClip(context)) {
    addHint(context, hints, command::fileOpen, "open");
    addHint(context, hints, command::palette, "all commands");
    return hints;
  }
  const app::Session& session = context.character();
  const bool limbChosen = !session.view().selection.limbs().empty();
  if (app::hasControllers(session)) {
    addHint(context, hints, command::controllerMove, "move");
    addHint(context, hints, command::poseKey, "key");
    addHint(context, hints, command::poseWholeClip, "whole clip");
  } else if (!limbChosen) {
    const std::string first = keyOf(context, command::selectLeftArm);
    const std::size_t limbs = app::limbsByKey(session.document()).size();
    const std::size_t slots = command::limbSlots.size();
    const std::string last = keyOf(context, command::limbSlots[std::clamp<std::size_t>(limbs, 1, slots) - 1]);
    hints.push_back({first + ".." + last, "limb"});
    if (limbs < slots) {
      addHint(context, hints, command::controllerSlots[limbs], "hips");
    }
  } else {
    addHint(context, hints, command::rangeStart, "range start");
    addHint(context, hints, command::rangeEnd, "end");
    addHint(context, hints, command::trailExaggerate, "exaggerate");
  }
  if (app::selectedTrail(session) != nullptr) {
    addHint(context, hints, command::sphereNext, "next sphere");
    addHint(context, hints, command::trailApply, "apply");
  }
  addHint(context, hints, command::timePlay, "play");
  addHint(context, hints, command::palette, "all commands");
  return hints;
}

/// As many hints as fit, the first ones first, at the right end of the row.
void hintPart(PanelContext& context) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const std::vector<KeyHint> hints =
      context.status.keyHints.empty() ? usualHints(context) : context.status.keyHints;
  const float free = ImGui::GetContentRegionAvail().x;
  float width = 0.0F;
  std::size_t count = 0;
  while (count < hints.size() && width + hintWidth(context, hints[count]) <= free) {
    width += hintWidth(context, hints[count]);
    ++count;
  }
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  float x = corner.x + free - width + theme.px(14.0F);
  for (std::size_t i = 0; i < count; ++i) {
    const KeyHint& hint = hints[i];
    const float cap = keyCap(widgets, {x, corner.y + theme.px(4.0F)}, hint.key);
    const Rect text{{x + cap + theme.px(6.0F), corner.y},
                    {x + hintWidth(context, hint), corner.y + theme.rowHeight()}};
    context.items.add("status/hint/" + hint.key, {x, corner.y}, text.max);
    context.items.items.back().explained = true; // By itself.
    drawText(widgets, theme.fonts.label, text, theme.colours.quietText, hint.does);
    x += hintWidth(context, hint);
  }
  ImGui::Dummy({free, theme.rowHeight()});
}

void busyPart(PanelContext& context) {
  const Theme& theme = context.theme;
  const EditorStatus& status = context.status;
  if (status.busyText.empty()) {
    return;
  }
  statusText(context, "status/busy", status.busyText, theme.colours.accent,
             {"Work in progress", status.busyText, {}});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = theme.px(120.0F);
  const float middle = corner.y + theme.rowHeight() * 0.5F;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float half = theme.px(2.0F);
  list->AddRectFilled({corner.x, middle - half}, {corner.x + width, middle + half}, theme.colours.raised,
                      half);
  const float part = status.busyFraction < 0.0F ? 0.3F : status.busyFraction;
  list->AddRectFilled({corner.x, middle - half}, {corner.x + width * part, middle + half},
                      theme.colours.accent, half);
  ImGui::Dummy({width, theme.rowHeight()});
  ImGui::SameLine(0.0F, theme.px(20.0F));
}

void shadingPart(PanelContext& context) {
  if (context.ui.overlays.shadeAs != ShadeAs::exact) {
    statusText(context, "status/shade-as", "Shaded as in three.js and Godot", context.theme.colours.accent,
               {"Shaded as in three.js and Godot",
                "They turn normals by the joints' own matrices; View, Shade as three.js and Godot ends it.",
                {}});
  }
}

void sequencePart(PanelContext& context) {
  const app::SequenceSession& session = context.sequence();
  statusText(context, "status/selection",
             session.document().mesh->name + ", frame " + std::to_string(app::shownFrame(session)) + " of " +
                 std::to_string(session.document().mesh->frameCount()),
             context.theme.colours.text, {"What is shown", "", {}});
}

} // namespace

void drawStatusBar(PanelContext& context) {
  busyPart(context);
  if (!context.status.modalText.empty()) {
    statusText(context, "status/modal", context.status.modalText, context.theme.colours.accent,
               {"What is being done", "Enter keeps it, Esc restores.", {}});
  }
  if (context.open.sequence() != nullptr) {
    sequencePart(context);
  } else if (hasCharacter(context)) {
    shadingPart(context);
    selectionPart(context);
  } else {
    statusText(context, "status/selection", "No file is open", context.theme.colours.quietText,
               {"No file is open", "Drop one on the window.", {}});
  }
  hintPart(context);
}

} // namespace stretch::ui
