#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/control.h"
#include "ui/widgets/key_diamond.h"

namespace stretch::ui {

/// A round bone of the figure. The figure stands in a box 180 wide and 232 high; x = 0 is its middle, y grows
/// downwards.
struct DiagramBone {
  ImVec2 from;
  float fromRadius = 1.0F;
  ImVec2 to;
  float toRadius = 1.0F;
};

/// A limb as the diagram shows it.
struct DiagramPart {
  std::string id = {}; ///< "left-arm": names the widget.
  std::vector<DiagramBone> bones = {};
  ImVec2 end = {}; ///< End of the limb: what a trail is drawn for.
  ImVec2 key = {}; ///< Place where its key is written.
  bool found = false;
  bool selected = false;
  bool lowConfidence = false;
  std::optional<ImU32> trail = {}; ///< Colour of the limb's trail.
  float moment = 0.0F;             ///< Strength of its strongest moment, of the clip's strongest; 0: none.
  bool hasWeight = false;          ///< Gives way by its own load: marked with a weight.
  std::string keyText = {};        ///< Shown at the limb.
  Help help = {};
};

/// A controller as the diagram shows it: a mark where it stands on the body.
struct DiagramController {
  std::string id = {}; ///< "left-hand": names the widget, "limb/left-hand".
  ImVec2 place = {};
  bool selected = false;
  KeyMark keys = KeyMark::none;
  Help help = {};
};

/// A body and what of it can be clicked.
struct DiagramFigure {
  std::vector<DiagramPart> parts;
  std::vector<DiagramController> controllers;
  bool leftIsOnTheRight = true; ///< True for a body that is seen from the front.
};

struct DiagramClick {
  std::optional<std::size_t> part;
  std::string controller;             ///< Empty: none.
  std::optional<std::size_t> hovered; ///< Part under the mouse,
  std::string hoveredController;      ///< or the controller that lies over it.
};

/// The figure, as wide as available. What was clicked; controllers lie over the parts.
[[nodiscard]] DiagramClick limbDiagram(const WidgetContext& context, const std::string& id,
                                       const DiagramFigure& body, float height);

/// The part under a point, for a diagram in this box; none beside the body.
[[nodiscard]] std::optional<std::size_t> partAt(const Rect& box, const std::vector<DiagramPart>& parts,
                                                const ImVec2& point);

} // namespace stretch::ui
