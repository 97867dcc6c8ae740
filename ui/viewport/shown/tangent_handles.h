#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/commands/trail/spheres.h"
#include "ui/panels/state/ui_state.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

/// A tangent handle as it stands in the picture: long enough on the screen to be taken.
struct ShownTangent {
  app::TangentHandle handle;
  Vec3 tipWorld{0.0};
};

/// Those of the selected sphere, and what they were made from.
struct ShownTangents {
  std::vector<ShownTangent> handles;
  std::shared_ptr<const rig::MotionState> motion;
  double sphereFrame = 0.0;
};

/// Makes them again where the trail or the selected sphere is another; none of a trail that is not drawn.
/// `view` decides how long they are.
void updateTangents(app::Session& session, const ViewportOverlays& overlays, const View& view,
                    ShownTangents& shown);

/// The handle whose tip lies under the mouse; none where the mouse is nearer to the sphere itself.
[[nodiscard]] std::optional<std::size_t> pickTangent(const View& view, const ShownTangents& shown,
                                                     const Vec2& mousePixels);

} // namespace stretch::ui
