#include "app/commands/keys/keys.h"

#include <set>
#include <utility>

#include "app/commands/pose/posing.h"
#include "app/commands/table/frames.h"

namespace stretch::app {

void pickKeys(Session& session, const KeySelection& selection, bool add) {
  ViewState& view = session.view();
  view.pickedKeys = add && view.pickedClip == view.clip ? joined(view.pickedKeys, selection) : selection;
  view.pickedClip = view.clip;
}

const KeySelection& pickedKeys(const Session& session) {
  static const KeySelection none;
  const ViewState& view = session.view();
  return view.pickedClip == view.clip ? view.pickedKeys : none;
}

bool hasPickedKeys(const Session& session) {
  return session.view().pickedClip == session.view().clip && !session.view().pickedKeys.empty();
}

Status editKeys(Session& session, Result<EditedKeys> edited, const std::string& verb) {
  if (!edited) {
    return edited.error();
  }
  const KeySelection& named = edited->picked.empty() ? session.view().pickedKeys : edited->picked;
  const std::string label = verb + " " + selectionTitle(session.document(), named);
  const KeySelection picked = edited->picked;
  session.edit(std::move(edited->document), label);
  pickKeys(session, picked, false);
  return Success{};
}

std::vector<KeyRow> rowsOfSelection(const Session& session) {
  const Document& document = session.document();
  if (!hasClip(document, session.view().clip)) {
    return {};
  }
  std::vector<std::string> limbs = session.view().selection.limbs();
  std::set<NodeIndex> nodes;
  for (const rig::Controller& controller : selectedControllers(session)) {
    limbs.push_back(controller.limb);
    nodes.insert(controller.node);
  }
  const bool isAnySelected = !limbs.empty();
  for (const std::string& id : limbs) {
    if (const rig::Limb* const limb = findLimb(document, id)) {
      nodes.insert(limb->joints.begin(), limb->joints.end());
      nodes.insert(limb->endNode);
    }
  }
  std::vector<KeyRow> rows = keyedRows(document, session.view().clip);
  std::erase_if(rows, [&](const KeyRow& row) {
    return isAnySelected && (row.isOffset() || nodes.count(row.node) == 0);
  });
  return rows;
}

} // namespace stretch::app
