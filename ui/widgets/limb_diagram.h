#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/control.h"
#include "ui/widgets/key_diamond.h"

namespace stretch::ui {

/// Parts of the drawn body, in the order of a biped's limbs.
enum class BodyPart { leftArm, rightArm, leftLeg, rightLeg, spine, neck };
inline constexpr int bodyPartCount = 6;

struct BodyPartState {
  bool found = false;
  bool selected = false;
  bool lowConfidence = false;
  std::optional<ImU32> trail = {}; ///< Colour of the limb's trail.
  bool hasWeight = false;          ///< Gives way by its own load: marked with a weight.
  std::string id = {};             ///< "left-arm": names the widget.
  std::string keyText = {};        ///< Shown at the limb.
  Help help = {};
};

/// A controller as the diagram shows it: a mark where it stands on the body.
struct DiagramController {
  std::string id = {}; ///< "left-hand": names the widget, "limb/left-hand". One that the figure has no
                       ///< place for is not shown.
  bool selected = false;
  KeyMark keys = KeyMark::none;
  Help help = {};
};

struct DiagramClick {
  std::optional<BodyPart> part;
  std::string controller; ///< Empty: none.
};

/// A body seen from the front, as wide as available: the character's left is on the right. What was clicked;
/// controllers lie over the parts.
[[nodiscard]] DiagramClick limbDiagram(const WidgetContext& context, const std::string& id,
                                       const std::array<BodyPartState, bodyPartCount>& parts,
                                       const std::vector<DiagramController>& controllers, float height);

/// The part under a point, for a diagram in this box; none beside the body.
[[nodiscard]] std::optional<BodyPart> bodyPartAt(const Rect& box, const ImVec2& point);

/// A point well inside the part, for a diagram in this box.
[[nodiscard]] ImVec2 bodyPartCentre(const Rect& box, BodyPart part);

} // namespace stretch::ui
