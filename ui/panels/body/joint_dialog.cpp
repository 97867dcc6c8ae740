#include <algorithm>

#include "app/commands/table/selection.h"
#include "app/edits/body/limb_edits.h"
#include "rig/body/reading/detection.h"
#include "rig/body/reading/planned_body.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/fuzzy.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

/// The first click sets the base, the second the end, a third starts again.
void choose(JointPick& pick, NodeIndex node) {
  if (!pick.baseNode.exists() || pick.endNode.exists()) {
    pick.baseNode = node;
    pick.endNode = NodeIndex::none;
  } else {
    pick.endNode = node;
  }
  pick.message.clear();
}

bool isJoint(const Scene& scene, NodeIndex node) {
  return std::any_of(scene.skins.begin(), scene.skins.end(), [node](const Skin& skin) {
    return std::find(skin.joints.begin(), skin.joints.end(), node) != skin.joints.end();
  });
}

bool isBetween(const Scene& scene, const JointPick& pick, NodeIndex node) {
  return pick.baseNode.exists() && pick.endNode.exists() && isAncestorOrSelf(scene, pick.baseNode, node) &&
         isAncestorOrSelf(scene, node, pick.endNode);
}

void jointRow(PanelContext& context, NodeIndex node, int depth) {
  const Scene& scene = *context.character().document().scene;
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  JointPick& pick = context.ui.body.jointPick;
  const std::string name = nodeName(scene, node);
  const Control row = takePlace(widgets, "joints/" + std::to_string(node.value),
                                {ImGui::GetContentRegionAvail().x, theme.px(24.0F)});
  if (row.visible) {
    const bool end = node == pick.baseNode || node == pick.endNode;
    const bool inside = isBetween(scene, pick, node);
    const ThemeColours& colours = theme.colours;
    if (end || inside || row.hovered) {
      ImGui::GetWindowDrawList()->AddRectFilled(row.box.min, row.box.max,
                                                end      ? colours.accentQuiet
                                                : inside ? faded(colours.accentQuiet, 0.5F)
                                                         : colours.raised,
                                                theme.corner());
    }
    const float left = row.box.min.x + theme.unit() + theme.px(14.0F) * static_cast<float>(depth);
    drawText(widgets, theme.fonts.body,
             {{left, row.box.min.y}, {row.box.max.x - theme.px(60.0F), row.box.max.y}},
             end                    ? colours.accent
             : isJoint(scene, node) ? colours.text
                                    : colours.quietText,
             name);
    const char* role = node == pick.baseNode ? "base" : node == pick.endNode ? "end" : "";
    drawText(
        widgets, theme.fonts.label,
        {{row.box.max.x - theme.px(60.0F), row.box.min.y}, {row.box.max.x - theme.unit(), row.box.max.y}},
        colours.accent, role, 1.0F);
  }
  tooltip(widgets, {name, "Click the limb's first joint, then its end.", {}});
  if (row.clicked) {
    choose(pick, node);
  }
}

/// Nodes depth first with their depth, roots first; a file's node loops were refused when it was read.
std::vector<std::pair<NodeIndex, int>> treeRows(const Scene& scene) {
  std::vector<std::pair<NodeIndex, int>> rows;
  std::vector<std::pair<NodeIndex, int>> open;
  // The last one in is the first one out: the first sibling is put in last.
  const auto wait = [&open](const std::vector<NodeIndex>& siblings, int depth) {
    std::for_each(siblings.rbegin(), siblings.rend(),
                  [&](NodeIndex node) { open.emplace_back(node, depth); });
  };
  wait(scene.roots, 0);
  while (!open.empty()) {
    const auto [node, depth] = open.back();
    open.pop_back();
    rows.emplace_back(node, depth);
    wait(scene.nodes[at(node)].children, depth + 1);
  }
  return rows;
}

void tree(PanelContext& context) {
  const Scene& scene = *context.character().document().scene;
  const std::string& filter = context.ui.body.jointPick.filter;
  ImGui::BeginChild("joints/tree", {0.0F, ImGui::GetContentRegionAvail().y - context.theme.px(62.0F)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  for (const auto& [node, depth] : treeRows(scene)) {
    if (filter.empty() || fuzzyScore(filter, nodeName(scene, node))) {
      jointRow(context, node, filter.empty() ? depth : 0);
    }
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

std::string nodeReference(NodeIndex node) {
  std::string reference = "#";
  reference += std::to_string(node.value);
  return reference;
}

/// The chain between the two joints, known by their names where those are unique, else by their indices.
Result<rig::Limb> chainOf(const Scene& scene, const JointPick& pick) {
  Result<rig::Limb> byIndex =
      rig::chainLimb(scene, nodeReference(pick.baseNode), nodeReference(pick.endNode));
  if (!byIndex) {
    return byIndex;
  }
  const Result<rig::Limb> byName =
      rig::chainLimb(scene, nodeName(scene, pick.baseNode), nodeName(scene, pick.endNode));
  return byName && byName->joints == byIndex->joints && byName->endNode == byIndex->endNode ? byName
                                                                                            : byIndex;
}

rig::LimbPlace placeOf(const app::Document& document, const std::string& limbId) {
  const rig::Limb* const present = app::findLimb(document, limbId);
  if (present != nullptr) {
    return {present->kind, present->side, present->row};
  }
  return rig::placeInPlan(rig::planOf(document.body), limbId);
}

Result<app::Document> changedDocument(const app::Document& document, const JointPick& pick) {
  Result<rig::Limb> chain = chainOf(*document.scene, pick);
  if (!chain) {
    return chain.error();
  }
  if (pick.limbId.empty()) {
    return app::addChain(document, std::move(chain).value());
  }
  static_cast<rig::LimbPlace&>(*chain) = placeOf(document, pick.limbId);
  chain->id = pick.limbId;
  chain->reasons = {"chosen by hand"};
  return app::correctLimb(document, std::move(chain).value());
}

void useChain(PanelContext& context) {
  JointPick& pick = context.ui.body.jointPick;
  const Result<app::Document> changed = changedDocument(context.character().document(), pick);
  if (!changed) {
    pick.message = changed.error().line();
    return;
  }
  const bool adds = pick.limbId.empty();
  editOnce(context, adds ? "Add a chain" : "Choose a limb's joints", changed);
  if (adds && !context.character().document().chains.empty()) {
    app::selectLimb(context.character(), context.character().document().chains.back().id, false);
  } else if (!adds) {
    app::selectLimb(context.character(), pick.limbId, false);
  }
  pick = {};
  ImGui::CloseCurrentPopup();
}

std::string summary(const Scene& scene, const JointPick& pick) {
  if (!pick.baseNode.exists()) {
    return "Click the first joint: the shoulder, hip, or base.";
  }
  if (!pick.endNode.exists()) {
    return "From " + nodeName(scene, pick.baseNode) + ". Now click the end: the wrist, ankle, or tip.";
  }
  return "From " + nodeName(scene, pick.baseNode) + " to " + nodeName(scene, pick.endNode) + ".";
}

} // namespace

void drawJointDialog(PanelContext& context) {
  JointPick& pick = context.ui.body.jointPick;
  if (!hasCharacter(context)) {
    pick.open = false;
  }
  const std::string title =
      pick.limbId.empty()
          ? "Pick a chain"
          : "Joints of the " + (context.open.character() != nullptr
                                    ? app::limbTitle(context.character().document(), pick.limbId)
                                    : pick.limbId);
  if (!beginDialog(
          context,
          {.id = "joints", .icon = icon::skeleton, .title = title, .width = 480.0F, .height = 560.0F},
          pick.open)) {
    return;
  }
  textField(widgetsOf(context), "joints/filter", "Search a joint", pick.filter);
  tree(context);
  note(widgetsOf(context),
       pick.message.empty() ? summary(*context.character().document().scene, pick) : pick.message);
  const bool complete = pick.baseNode.exists() && pick.endNode.exists();
  const int clicked = dialogButtons(
      context, "joints", {{.id = "", .text = "Cancel"}, {.id = "", .text = "Use them", .enabled = complete}});
  if (clicked == 0) {
    pick = {};
    ImGui::CloseCurrentPopup();
  } else if (clicked == 1) {
    useChain(context);
  }
  endDialog();
}

} // namespace stretch::ui
