#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session.h"
#include "ui/render/picking/surface_picking.h"

namespace stretch::ui {

/// Part of the character that lies under the mouse.
struct LimbUnderMouse {
  std::string limb;   ///< Limb id; empty for none.
  bool atEnd = false; ///< On its hand, foot or head, which can be pulled.
  NodeIndex joint;    ///< That most of the place follows, whatever limb it is of.

  friend bool operator==(const LimbUnderMouse&, const LimbUnderMouse&) = default;
};

/// The surface that is picked from, kept while pose and view stay.
struct LimbHover {
  std::shared_ptr<const rig::MotionState> motion; ///< Motion by which the surface is posed.
  double frame = 0.0;
  bool original = false;
  bool inBindPose = false;  ///< Locators are shown.
  app::UnkeyedPose unkeyed; ///< Pose at the playhead without a key.
  PosedSurface surface;
  std::vector<int> limbOfNode;  ///< Index into allLimbs.
  std::vector<rig::Limb> limbs; ///< That limbOfNode was made for.
};

/// The limb whose flesh is in front under the mouse, by its skin weights; beside the character the nearest
/// bone on the screen, if one is near.
[[nodiscard]] LimbUnderMouse limbUnderMouse(app::Session& session, const View& view, const Vec2& mousePixels,
                                            LimbHover& hover);

} // namespace stretch::ui
