#include <algorithm>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/keys/rate_edits.h"
#include "core/scene/scene.h"
#include "rig/body/reading/planned_body.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/menus/context_menu.h"
#include "ui/panels/time/transport.h"
#include "ui/widgets/button.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

std::size_t jointCount(const Scene& scene) {
  std::vector<NodeIndex> joints;
  for (const Skin& skin : scene.skins) {
    joints.insert(joints.end(), skin.joints.begin(), skin.joints.end());
  }
  std::sort(joints.begin(), joints.end());
  return static_cast<std::size_t>(std::unique(joints.begin(), joints.end()) - joints.begin());
}

std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) {
    text.insert(at - 3, "\xE2\x80\x89"); // thin space
  }
  return text;
}

void fileSummary(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const app::Document& document = context.character().document();
  const Scene& scene = *document.scene;
  valueRow(widgets, "Mesh", grouped(vertexCount(scene)) + " vertices");
  const std::string joints = scene.skins.empty() ? "no skin" : grouped(jointCount(scene)) + " joints";
  valueRow(widgets, "Rig",
           joints + ", " + shortNumber(document.body.height) +
               (document.body.isBiped ? " m tall" : " m large"),
           {.title = capitalised(planOf(document.body).title),
            .text = "The size in the bind pose is what tolerances are measured against."});
}

/// Which body it is, and why; another one can be chosen.
void planRow(PanelContext& context) {
  const rig::Body& body = context.character().document().body;
  std::vector<Choice> choices;
  int selected = -1;
  for (const rig::BodyPlan& plan : rig::bodyPlans()) {
    selected = plan.id == body.plan ? static_cast<int>(choices.size()) : selected;
    choices.push_back({.text = capitalised(plan.title),
                       .help = {capitalised(plan.title), "Its limbs are looked for in the skeleton.", {}}});
  }
  std::string reasons;
  for (const std::string& reason : body.planReasons) {
    reasons += (reasons.empty() ? "" : "; ") + reason;
  }
  const Help help{"Body plan", "Which limbs the body has: " + reasons + ".", {}};
  labelledRow(widgetsOf(context), "Body", help);
  const int chosen = dropdown(widgetsOf(context), "rig/plan", choices, selected, help);
  if (chosen >= 0 && chosen != selected) {
    request(context, command::planPrefix + rig::bodyPlans()[static_cast<std::size_t>(chosen)].id);
  }
}

std::string rateText(const PanelContext& context) {
  const app::Session& session = context.character();
  const double own = app::ownRate(session.document(), session.view().clip);
  const bool isOwn = own == app::clipOf(session.document(), session.view().clip).framesPerSecond;
  return isOwn ? "Frame 0 is the time 0. The rate is guessed from the key times."
               : "Frame 0 is the time 0. You work at a rate of your choice; the clip's own is " +
                     shortNumber(own) + " fps.";
}

void clipRows(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const Clip& clip = app::clipOf(context.character().document(), context.character().view().clip);
  valueRow(widgets, "Clip",
           std::to_string(frameCount(clip)) + " frames, " + shortNumber(clip.framesPerSecond) + " fps",
           {.title = shortNumber(clip.endSeconds) + " seconds", .text = rateText(context)});
  clipChooser(context, "rig/clip", 0.0F); // As wide as the panel: names of clips are long.
}

std::string jointsText(const Scene& scene, const rig::Limb& limb) {
  const std::string first = limb.joints.empty() ? "?" : nodeName(scene, limb.joints.front());
  return first + " \xE2\x86\x92 " + nodeName(scene, limb.endNode);
}

ImU32 confidenceColour(const ThemeColours& colours, double confidence) {
  return confidence >= 0.8 ? colours.success : confidence >= 0.6 ? colours.warning : colours.error;
}

void openCorrection(PanelContext& context, const rig::Limb& limb) {
  JointPick pick;
  pick.open = true;
  pick.limbId = limb.kind == rig::LimbKind::chain ? std::string() : limb.id;
  pick.baseNode = limb.joints.empty() ? NodeIndex::none : limb.joints.front();
  pick.endNode = limb.endNode;
  context.ui.body.jointPick = pick;
}

void drawLimbRow(const PanelContext& context, const Control& row, const rig::Limb& limb, bool selected) {
  const Theme& theme = context.theme;
  const ThemeColours& colours = theme.colours;
  const WidgetContext widgets = widgetsOf(context);
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (selected || row.hovered) {
    list->AddRectFilled(row.box.min, row.box.max, selected ? colours.accentQuiet : colours.raised,
                        theme.corner());
  }
  const float split = row.box.min.x + theme.px(88.0F);
  drawText(widgets, theme.fonts.body, {{row.box.min.x + theme.unit(), row.box.min.y}, {split, row.box.max.y}},
           selected ? colours.accent : colours.text, limbHeading(context.character().document(), limb.id));
  const float numberLeft = row.box.max.x - theme.px(40.0F);
  const std::string joints = jointsText(*context.character().document().scene, limb);
  const Rect jointsBox{{split + theme.unit(), row.box.min.y}, {numberLeft - theme.px(4.0F), row.box.max.y}};
  if (textSize(theme.fonts.label, joints).x <= jointsBox.width()) { // cut names would only be noise: the
                                                                    // reasons have them
    drawText(widgets, theme.fonts.label, jointsBox, colours.quietText, joints);
  }
  drawText(widgets, theme.fonts.label,
           {{numberLeft, row.box.min.y}, {row.box.max.x - theme.px(4.0F), row.box.max.y}},
           confidenceColour(colours, limb.confidence), shortNumber(limb.confidence * 100.0, 0) + " %", 1.0F);
}

void limbReasons(PanelContext& context, const rig::Limb& limb) {
  const WidgetContext widgets = widgetsOf(context);
  ImGui::Indent(context.theme.px(12.0F));
  verticalSpace(widgets, 4.0F);
  const Scene& scene = *context.character().document().scene;
  std::string joints;
  for (const NodeIndex joint : limb.joints) {
    joints += (joints.empty() ? "" : ", ") + nodeName(scene, joint);
  }
  note(widgets, joints + " \xE2\x86\x92 " + nodeName(scene, limb.endNode) + "; " +
                    shortNumber(limb.restLength, 3) + " m at rest");
  for (const std::string& reason : limb.reasons) {
    note(widgets, "\xE2\x80\xA2 " + reason);
  }
  verticalSpace(widgets, 4.0F);
  ButtonSpec correct;
  correct.id = "rig/correct/" + limb.id;
  correct.icon = icon::pencil;
  correct.text = "Choose its joints";
  correct.help = {"Correct this limb", "Choose the first joint and the end from the skeleton.", {}};
  if (button(widgets, correct)) {
    openCorrection(context, limb);
  }
  verticalSpace(widgets, 6.0F);
  ImGui::Unindent(context.theme.px(12.0F));
}

void limbRow(PanelContext& context, const rig::Limb& limb) {
  const WidgetContext widgets = widgetsOf(context);
  app::Session& session = context.character();
  const std::vector<std::string>& limbs = session.view().selection.limbs();
  const bool selected = std::find(limbs.begin(), limbs.end(), limb.id) != limbs.end();
  const float chevron = context.theme.rowHeight();
  const float width = ImGui::GetContentRegionAvail().x - chevron;
  const Control row = takePlace(widgets, "rig/limb/" + limb.id, {width, context.theme.rowHeight()});
  if (row.visible) {
    drawLimbRow(context, row, limb, selected);
  }
  tooltip(widgets, {limbHeading(session.document(), limb.id),
                    "How sure the program is of its joints: " + shortNumber(limb.confidence * 100.0, 0) +
                        " %. Click selects the limb.",
                    {}});
  if (row.clicked) {
    app::selectLimb(session, limb.id, ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl);
  }
  if (row.hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Right)) {
    if (!selected) {
      app::selectLimb(session, limb.id, false);
    }
    askForMenu(context.ui, MenuTarget::limb);
  }
  ImGui::SameLine(0.0F, 0.0F);
  const bool expanded = context.ui.body.expandedLimb == limb.id;
  ButtonSpec more;
  more.id = "rig/why/" + limb.id;
  more.icon = expanded ? icon::chevronDown : icon::chevronRight;
  more.fallback = expanded ? "-" : "+";
  more.emphasis = Emphasis::quiet;
  more.width = chevron;
  more.help = {"Why these joints", "Shows the reasons, and lets you choose other joints.", {}};
  if (button(widgets, more)) {
    context.ui.body.expandedLimb = expanded ? std::string() : limb.id;
  }
  if (expanded) {
    limbReasons(context, limb);
  }
}

void limbList(PanelContext& context) {
  const app::Document& document = context.character().document();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.theme.unit(), context.theme.px(1.0F)));
  for (const rig::Limb& limb : document.body.limbs) {
    limbRow(context, limb);
  }
  for (const rig::Limb& chain : document.chains) {
    limbRow(context, chain);
  }
  ImGui::PopStyleVar();
  if (document.body.limbs.empty() && document.chains.empty()) {
    note(widgetsOf(context), "No limb was found. Pick a chain: its first joint, then its end.");
  }
}

void limbTools(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  verticalSpace(widgets, 4.0F);
  const float width = columnWidth(2);
  commandButton(context,
                {.command = command::pickChain, .icon = icon::plus, .text = "Chain", .width = width});
  ImGui::SameLine();
  commandButton(
      context,
      {.command = command::detectAgain, .icon = icon::refresh, .text = "Find again", .width = width});
}

} // namespace

void drawRigPanel(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  panelTitle(widgets, icon::cube, "Character");
  if (!hasCharacter(context)) {
    emptyState(widgets, icon::folderOpen, "No character yet",
               "Drop a .glb, .gltf or .vrm file here, or open one.");
    commandButton(context, {.command = command::fileOpen,
                            .icon = icon::folderOpen,
                            .text = "Open a file",
                            .emphasis = Emphasis::primary,
                            .width = ImGui::GetContentRegionAvail().x});
    return;
  }
  fileSummary(context);
  if (hasViewedClip(context)) {
    clipRows(context);
  } else {
    notice(widgets, NoticeKind::warning,
           "The file has no animation: there is no motion to exaggerate. Import a clip, or open a file with "
           "one.");
  }
  if (section(widgets, "rig/limbs", "Limbs found", context.ui.closedSections)) {
    planRow(context);
    limbList(context);
    limbTools(context);
  }
  const app::Document& document = context.character().document();
  std::vector<std::string> warnings = document.warnings;
  warnings.insert(warnings.end(), document.body.warnings.begin(), document.body.warnings.end());
  if (!warnings.empty() &&
      section(widgets, "rig/warnings", "Warnings (" + std::to_string(warnings.size()) + ")",
              context.ui.closedSections)) {
    for (const std::string& warning : warnings) {
      notice(widgets, NoticeKind::warning, warning);
    }
  }
}

} // namespace stretch::ui
