#include "ui/panels/body/weight_view.h"

#include <algorithm>
#include <set>

#include "app/edits/pose/adjustment_edits.h"
#include "app/locators/build_rig.h"
#include "rig/controllers/controller.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::ui {

namespace {

// The joint that a bind leaf stands for.
NodeIndex ownJoint(const Scene& scene, NodeIndex node) {
  while (node.exists() && scene.nodes[at(node)].isBindLeaf) {
    node = scene.nodes[at(node)].parent;
  }
  return node;
}

// Of controllers and locators one kind alone is ever selected.
const std::vector<std::string>& chosenHandles(const app::ViewState& view) {
  return view.selection.locators().empty() ? view.selection.controllers() : view.selection.locators();
}

NodeIndex jointOfSelection(const app::Session& session) {
  const app::Document& document = session.document();
  const app::ViewState& view = session.view();
  if (!view.selection.locators().empty()) {
    const std::vector<NodeIndex> joints = app::jointsOfLocators(*document.scene, document.locators);
    const auto named = [&](NodeIndex joint) {
      return document.scene->nodes[at(joint)].name == view.selection.locators().back();
    };
    const auto found = std::ranges::find_if(joints, named);
    return found == joints.end() ? NodeIndex::none : *found;
  }
  if (!view.selection.controllers().empty()) {
    const Result<rig::Controller> controller =
        rig::controllerNamed(*document.scene, app::allLimbs(document), document.body.hips,
                             app::controllersOf(document), view.selection.controllers().back());
    return controller ? controller->node : NodeIndex::none;
  }
  const rig::Limb* const limb =
      view.selection.limbs().empty() ? nullptr : app::findLimb(document, view.selection.limbs().back());
  return limb == nullptr || limb->joints.empty() ? NodeIndex::none : limb->joints.front();
}

} // namespace

std::vector<NodeIndex> weightedJoints(const Scene& scene) {
  std::set<NodeIndex> used;
  for (const NodeIndex node : skinning::drawnMeshNodes(scene)) {
    const int skin = scene.nodes[at(node)].skin;
    for (const NodeIndex joint : skin >= 0 ? scene.skins[at(skin)].joints : std::vector<NodeIndex>()) {
      used.insert(ownJoint(scene, joint));
    }
  }
  std::vector<NodeIndex> joints;
  for (const NodeIndex node : parentsFirst(scene)) {
    if (used.contains(node)) {
      joints.push_back(node);
    }
  }
  return joints;
}

std::vector<float> sharesOf(const Scene& scene, NodeIndex joint) {
  const std::vector<NodeIndex> joints = weightedJoints(scene);
  const std::set<NodeIndex> others(joints.begin(), joints.end());
  std::vector<float> shares(scene.nodes.size(), 0.0F);
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    const bool isCarried = !others.contains(node) && parent.exists() && shares[at(parent)] > 0.0F;
    shares[at(node)] = node == joint || isCarried ? 1.0F : 0.0F;
  }
  return shares;
}

void showWeightsOf(WeightView& view, const app::Session& session, NodeIndex joint) {
  view.joint = joint;
  view.limbs = session.view().selection.limbs();
  view.controllers = chosenHandles(session.view());
}

NodeIndex weightsShownOf(UiState& ui, const app::Session& session) {
  WeightView& view = ui.body.weights;
  if (!ui.overlays.weights) {
    return NodeIndex::none;
  }
  const std::vector<NodeIndex> joints = weightedJoints(*session.document().scene);
  const auto isWeighted = [&](NodeIndex node) { return std::ranges::find(joints, node) != joints.end(); };
  if (view.limbs != session.view().selection.limbs() || view.controllers != chosenHandles(session.view())) {
    const NodeIndex selected = jointOfSelection(session);
    showWeightsOf(view, session, isWeighted(selected) ? selected : view.joint);
  }
  if (!isWeighted(view.joint)) {
    view.joint = joints.empty() ? NodeIndex::none : joints.front();
  }
  return view.joint;
}

} // namespace stretch::ui
