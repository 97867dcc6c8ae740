#pragma once

#include <string>
#include <vector>

#include "ui/panels/context/panel_context.h"
#include "ui/widgets/curve_view.h"

namespace stretch::ui {

/// Subject that the graph can show: a joint, a controller or an attribute, or all joints at once.
struct GraphSubject {
  std::string title;
  std::vector<NodeIndex> nodes = {}; ///< Joints; none: the controller.
  std::string controller = {};
  std::string limb = {}; ///< Limb whose length is shown.
  bool isOne = true;     ///< A joint alone: what the character does is drawn over its curves.
};

/// The selected controllers with the attributes of their limbs, the joints of the first selected limb, then
/// all joints of the selected limbs, and every one that is animated. Empty where nothing is selected.
[[nodiscard]] std::vector<GraphSubject> graphSubjects(const PanelContext& context);

/// Returns the channels of the subject that are drawn.
[[nodiscard]] GraphChannels graphChannels(const PanelContext& context, const GraphSubject& subject);

/// The rows of keys that the graph shows of a subject.
[[nodiscard]] std::vector<app::KeyRow> graphRows(const PanelContext& context, const GraphSubject& subject);

/// The curves over the visible frames, remembered in TimePanes::graph until what they were made from changes.
/// Rotations are angles X, Y, Z in degrees without jumps.
[[nodiscard]] const std::vector<Curve>& graphCurves(PanelContext& context, const GraphSubject& subject,
                                                    const Span& frames);

/// Unit of the values of a subject, with a leading space.
[[nodiscard]] const char* graphUnit(const PanelContext& context, const GraphSubject& subject);

} // namespace stretch::ui
