#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "app/commands/table/selection.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/trails/trail_sections.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

constexpr float remarkIndent = 3.0F; // units: below the text of the moment's toggle

/// The list of styles has the keys.
bool isListOpen() {
  return ImGui::IsPopupOpen("clip-style/style/list");
}

/// Left and right go to the style before and after, page up and down change the strength.
void takeStyleKeys(const PanelContext& context, ClipStyleState& state) {
  constexpr double step = 0.1;
  constexpr double most = 2.0;
  if (ImGui::GetIO().WantTextInput || isListOpen()) {
    return;
  }
  const int move = keyPressed(ImGuiKey_RightArrow, true) ? 1 : keyPressed(ImGuiKey_LeftArrow, true) ? -1 : 0;
  const int style = std::clamp(state.style + move, 0, static_cast<int>(context.ui.trails.styles.size()) - 1);
  const double change = keyPressed(ImGuiKey_PageUp, true)     ? step
                        : keyPressed(ImGuiKey_PageDown, true) ? -step
                                                              : 0.0;
  const double strength = std::clamp(std::round((state.strength + change) / step) * step, 0.0, most);
  state.changed = state.changed || style != state.style || (change != 0.0 && strength != state.strength);
  state.style = style;
  state.strength = change != 0.0 ? strength : state.strength;
}

void styleRows(PanelContext& context, ClipStyleState& state) {
  const WidgetContext widgets = widgetsOf(context);
  const Help help{
      "Style",
      "How far arms, legs and body are stretched, and how they come back. Left and right go through them.",
      {}};
  labelledRow(widgets, "Style", help);
  if (const int chosen =
          dropdown(widgets, "clip-style/style", styleChoices(context.ui.trails.styles), state.style, help);
      chosen >= 0) {
    state.style = chosen;
    state.changed = true;
  }
  takeStyleKeys(context, state);
  labelledRow(widgets, "Strength", {"Strength", "How much of the style's exaggeration.", {}});
  SliderSpec spec{.id = "clip-style/strength",
                  .minimum = 0.0,
                  .maximum = 2.0,
                  .step = 0.05,
                  .decimals = 0,
                  .suffix = " %",
                  .displayFactor = 100.0,
                  .defaultValue = 1.0};
  spec.help = {"Strength",
               "How much of the style's exaggeration. Drag, click and type, or press Page up and down.",
               {}};
  state.changed = slider(widgets, spec, state.strength).changed || state.changed;
}

/// What became of a moment; null while nothing did.
const app::AutoMoment* outcomeOf(const ClipStyleState& state, const rig::Moment& moment) {
  const auto found = std::ranges::find(state.made, moment, &app::AutoMoment::moment);
  return found == state.made.end() ? nullptr : &*found;
}

/// Whether all that is exaggerated goes along the ground, so that it is said once and not in each row.
bool allAreLevel(const ClipStyleState& state) {
  const auto isDone = [](const app::AutoMoment& made) { return made.trailId > 0; };
  return std::ranges::count_if(state.made, isDone) > 1 &&
         std::ranges::all_of(state.made, [&](const auto& made) { return !isDone(made) || made.isLevel; });
}

std::string outcomeText(const ClipStyleState& state, std::size_t place) {
  const app::AutoMoment* const made = outcomeOf(state, state.moments[place]);
  return !state.on[place] || made == nullptr ? std::string()
         : made->trailId > 0                 ? "\xC3\x97" + shortNumber(made->scale)
                                             : "left out";
}

void momentRow(PanelContext& context, ClipStyleState& state, std::size_t place) {
  const WidgetContext widgets = widgetsOf(context);
  const rig::Moment& moment = state.moments[place];
  const app::Document& document = context.character().document();
  const std::string limb =
      moment.limb == rig::wholeBody ? "Body" : capitalised(app::limbTitle(document, moment.limb));
  const std::string text = fmt::format("{}, {} {:g}\xE2\x80\x93{:g}", limb, rig::momentKindName(moment.kind),
                                       moment.startFrame, moment.tipFrame);
  const app::AutoMoment* const made = outcomeOf(state, moment);
  const bool isLeftOut = state.on[place] && made != nullptr && made->trailId <= 0;
  if (toggle(widgets, "clip-style/moment-" + std::to_string(place), text, state.on[place] && !isLeftOut,
             {text,
              isLeftOut ? "Left out for the reason below; it comes back where that goes."
                        : "Exaggerates this moment, or not.",
              {}},
             !isLeftOut)) {
    state.on[place] = !state.on[place];
    state.changed = true;
  }
  ImGui::SameLine();
  const std::string outcome = outcomeText(state, place);
  const float width = textSize(context.theme.fonts.label, outcome).x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float right = corner.x + ImGui::GetContentRegionAvail().x - context.theme.unit();
  drawText(widgets, context.theme.fonts.label,
           {{right - width, corner.y}, {right + 1.0F, corner.y + context.theme.rowHeight()}},
           context.theme.colours.quietText, outcome);
  ImGui::NewLine();
  const std::string remark =
      made == nullptr || !state.on[place]
          ? ""
          : app::remarkOn(made->trailId > 0, made->isLevel && !allAreLevel(state), made->why);
  if (!remark.empty()) {
    ImGui::Indent(remarkIndent * context.theme.unit());
    note(widgets, capitalised(remark));
    ImGui::Unindent(remarkIndent * context.theme.unit());
  }
}

void momentRows(PanelContext& context, ClipStyleState& state) {
  constexpr float mostRows = 9.0F;
  const float row = context.theme.rowHeight() + ImGui::GetStyle().ItemSpacing.y;
  const float rows = std::clamp(static_cast<float>(state.moments.size()), 1.0F, mostRows);
  ImGui::BeginChild("clip-style/moments", {0.0F, row * rows + context.theme.unit()});
  for (std::size_t i = 0; i < state.moments.size(); ++i) {
    momentRow(context, state, i);
  }
  ImGui::EndChild();
}

void styleButtons(PanelContext& context) {
  const float width = columnWidth(3);
  commandButton(context, {.command = command::styleTake, .text = "Take", .width = width});
  ImGui::SameLine();
  commandButton(context, {.command = command::styleImport, .text = "Import", .width = width});
  ImGui::SameLine();
  commandButton(context, {.command = command::styleExport, .text = "Export", .width = width});
}

std::string progressText(const ClipStyleState& state) {
  if (state.working || state.changed) {
    return "Working it out\xE2\x80\xA6";
  }
  const std::string nothing = whyNothing(state);
  const auto done = std::ranges::count_if(state.made, [](const auto& one) { return one.trailId > 0; });
  const std::string instead = state.replaced.empty()
                                  ? ""
                                  : fmt::format(", in place of {} earlier trail{}", state.replaced.size(),
                                                state.replaced.size() == 1 ? "" : "s");
  return fmt::format("{} of {} moments are exaggerated{}{}{}.", done, state.moments.size(),
                     allAreLevel(state) ? ", all along the ground" : "", instead,
                     nothing.empty() ? ". Space plays the clip" : ": " + nothing);
}

/// Index of the button that was clicked.
int clipButtons(PanelContext& context, const std::string& nothing) {
  const std::string off = nothing.empty() ? "" : " Off: " + nothing + ".";
  return dialogButtons(context, "clip-style",
                       {{.id = "", .text = "Cancel"},
                        {.id = "",
                         .text = "Exaggerate",
                         .help = {"Exaggerate", "Keeps the clip as it is shown, as one step." + off, {}},
                         .enabled = nothing.empty()}});
}

} // namespace

std::string whyNothing(const ClipStyleState& state) {
  if (state.working || state.changed || !state.trails.empty()) {
    return {};
  }
  if (state.made.empty()) {
    return "every moment is switched off";
  }
  const std::string& why = state.made.front().why;
  const bool isOfAll = std::ranges::all_of(state.made, [&](const auto& one) { return one.why == why; });
  return isOfAll ? why : "each row says why";
}

void drawClipStyleDialog(PanelContext& context) {
  ClipStyleState& state = context.ui.trails.clipStyle;
  bool shown = state.open && !context.ui.dialogs.file.open && context.open.character() != nullptr;
  if (!shown) {
    return;
  }
  if (!beginDialog(context,
                   {.id = "clip-style",
                    .icon = icon::magic,
                    .title = "Exaggerate the clip",
                    .width = 304.0F, // of the pane on the right: the picture stays in sight
                    .across = 1.0F,
                    .darkens = false},
                   shown)) {
    state.open = shown;
    return;
  }
  state.open = shown;
  styleRows(context, state);
  styleButtons(context);
  verticalSpace(widgetsOf(context), 4.0F);
  momentRows(context, state);
  const std::string nothing = whyNothing(state);
  note(widgetsOf(context), progressText(state));
  const bool entered = nothing.empty() && enterPressed() && !ImGui::GetIO().WantTextInput && !isListOpen();
  if (keyPressed(ImGuiKey_Space) && !ImGui::GetIO().WantTextInput) {
    request(context, command::timePlay);
  }
  const int clicked = clipButtons(context, nothing);
  state.accepted = state.accepted || entered || clicked == 1;
  state.open = state.open && clicked != 0;
  if (!state.open) {
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

} // namespace stretch::ui
