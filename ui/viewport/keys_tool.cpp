#include "ui/viewport/keys_tool.h"

#include <cmath>
#include <utility>

#include "app/commands/keys/keys.h"

namespace stretch::ui {

Status previewKeys(app::Session& session, const KeysTool& tool) {
  const int clip = session.view().clip;
  const bool scales = tool.modal.kind == app::KeysModal::Kind::scale;
  Result<app::EditedKeys> edited =
      scales ? app::scaleKeys(session.atBegin(), clip, tool.picked, app::scaleOf(tool.modal))
             : app::moveKeys(session.atBegin(), clip, tool.picked, app::moveOf(tool.modal));
  if (!edited) {
    return edited.error();
  }
  session.preview(std::move(edited->document));
  app::pickKeys(session, edited->picked, false);
  return Success{};
}

Status startKeys(app::Session& session, Tool& tool, const app::KeysModal& modal) {
  KeysTool started{modal, app::pickedKeys(session), std::nullopt};
  if (started.picked.empty()) {
    return Error{"no key is picked", "", "click a key in the graph, or draw a box around some"};
  }
  const bool scales = modal.kind == app::KeysModal::Kind::scale;
  session.begin((scales ? "Scale " : "Move ") + app::selectionTitle(session.document(), started.picked));
  tool = std::move(started);
  return Success{};
}

Status moveKeysMouse(app::Session& session, Tool& tool, const Vec2& at) {
  auto* const keys = std::get_if<KeysTool>(&tool);
  if (keys == nullptr) {
    return Success{};
  }
  const Vec2 from = keys->from.value_or(at);
  app::KeysModal& modal = keys->modal;
  const Vec2 last(modal.mouseFrames, modal.mouseValue);
  modal.mouseFrames = at.x - from.x;
  modal.mouseValue = at.y - from.y;
  const double arm = from.x - modal.aboutFrame;
  modal.mouseFactor = std::abs(arm) > 0.5 ? (at.x - modal.aboutFrame) / arm : 1.0 + 0.1 * (at.x - from.x);
  if (!keys->from) {
    keys->from = at;
    return Success{};
  }
  return last == Vec2(modal.mouseFrames, modal.mouseValue) ? Status(Success{}) : previewKeys(session, *keys);
}

} // namespace stretch::ui
