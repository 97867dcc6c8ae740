#pragma once

#include <vector>

#include "ui/panels/panel_context.h"
#include "ui/widgets/curve_view.h"

namespace stretch::ui {

/// Nodes of the selected limb, base first, its end last.
[[nodiscard]] std::vector<NodeIndex> graphNodes(const rig::Limb& limb);

/// The curves of one node, or of the limb's length, over the visible frames: as the character moves, with the
/// source clip as `before` where a trail changes it, and the clip's keys. Remembered in UiState::graph until
/// what they were made from changes. Rotations are Euler angles X, Y, Z in degrees without jumps.
[[nodiscard]] const std::vector<Curve>& graphCurves(PanelContext& context, const rig::Limb& limb,
                                                    const Span& frames);

/// Unit of the values in a channel, with a leading space.
[[nodiscard]] const char* graphUnit(GraphChannels channels);

/// Angles X, Y, Z (radians, applied in the order X, Y, Z about fixed axes) of a rotation, each chosen nearest
/// to `previous`.
[[nodiscard]] Vec3 eulerNear(const Quat& rotation, const Vec3& previous);

} // namespace stretch::ui
