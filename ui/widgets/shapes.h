#pragma once

#include <vector>

#include <imgui.h>

namespace stretch::ui {

/// A rounded limb of a drawn figure: two circles and what lies between their tangents. Screen pixels.
struct TaperedCapsule {
  ImVec2 from;
  ImVec2 to;
  float fromRadius = 1.0F;
  float toRadius = 1.0F;
};

void addCapsule(ImDrawList& list, const TaperedCapsule& capsule, ImU32 colour);

/// Whether the point is inside the capsule grown by `margin`.
[[nodiscard]] bool isInside(const TaperedCapsule& capsule, const ImVec2& point, float margin);

void addDiamond(ImDrawList& list, const ImVec2& centre, float radius, ImU32 colour);

/// A polyline in dashes that go on over its corners.
void addDashedPolyline(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 colour, float thickness,
                       float dash, float gap);

} // namespace stretch::ui
