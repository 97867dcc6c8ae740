#pragma once

#include <vector>

#include "app/session.h"
#include "core/scene/scene.h"
#include "ui/panels/state/ui_state.h"

namespace stretch::ui {

// Weights are shown of one joint at a time. It is chosen by hand, or goes with what is selected.

/// The joints that vertices of shown meshes can follow, each below the one it hangs on.
[[nodiscard]] std::vector<NodeIndex> weightedJoints(const Scene& scene);

/// How much what hangs on each node wholly follows the joint: 1 for the joint and for the things that it
/// carries, else 0.
[[nodiscard]] std::vector<float> sharesOf(const Scene& scene, NodeIndex joint);

/// From now on those of this joint, until something else is selected.
void showWeightsOf(WeightView& view, const app::Session& session, NodeIndex joint);

/// The joint whose weights are to be drawn. A limb that was selected since the last call brings its first
/// joint, a controller the joint that it is on. None while weights are not shown, and where no mesh follows a
/// joint.
[[nodiscard]] NodeIndex weightsShownOf(UiState& ui, const app::Session& session);

} // namespace stretch::ui
