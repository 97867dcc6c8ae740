#include "ui/widgets/shapes.h"

#include <algorithm>
#include <cmath>

namespace stretch::ui {

void addCapsule(ImDrawList& list, const TaperedCapsule& capsule, ImU32 colour) {
  const float dx = capsule.to.x - capsule.from.x;
  const float dy = capsule.to.y - capsule.from.y;
  const float length = std::hypot(dx, dy);
  if (length <= std::abs(capsule.fromRadius - capsule.toRadius)) {
    const bool fromLarger = capsule.fromRadius >= capsule.toRadius;
    list.AddCircleFilled(fromLarger ? capsule.from : capsule.to,
                         std::max(capsule.fromRadius, capsule.toRadius), colour);
    return;
  }
  // The outer tangents touch both circles at the same angle from the axis.
  const float axis = std::atan2(dy, dx);
  const float tangent = std::acos((capsule.fromRadius - capsule.toRadius) / length);
  constexpr float turn = 6.28318531F;
  list.PathArcTo(capsule.from, capsule.fromRadius, axis + tangent, axis + turn - tangent, 24);
  list.PathArcTo(capsule.to, capsule.toRadius, axis - tangent, axis + tangent, 24);
  list.PathFillConvex(colour);
}

bool isInside(const TaperedCapsule& capsule, const ImVec2& point, float margin) {
  const float dx = capsule.to.x - capsule.from.x;
  const float dy = capsule.to.y - capsule.from.y;
  const float squared = dx * dx + dy * dy;
  const float along =
      squared > 0.0F ? ((point.x - capsule.from.x) * dx + (point.y - capsule.from.y) * dy) / squared : 0.0F;
  const float t = std::clamp(along, 0.0F, 1.0F);
  const float distance = std::hypot(point.x - capsule.from.x - dx * t, point.y - capsule.from.y - dy * t);
  return distance <= capsule.fromRadius + (capsule.toRadius - capsule.fromRadius) * t + margin;
}

void addDiamond(ImDrawList& list, const ImVec2& centre, float radius, ImU32 colour) {
  list.AddQuadFilled({centre.x, centre.y - radius}, {centre.x + radius, centre.y},
                     {centre.x, centre.y + radius}, {centre.x - radius, centre.y}, colour);
}

void addDashedPolyline(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 colour, float thickness,
                       float dash, float gap) {
  float phase = 0.0F;
  const float period = dash + gap;
  for (std::size_t i = 1; i < points.size() && period > 0.0F; ++i) {
    const ImVec2 a = points[i - 1];
    const ImVec2 b = points[i];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const auto at = [&](float s) {
      return ImVec2(a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length);
    };
    float s = 0.0F;
    while (s < length) {
      const bool on = phase < dash;
      const float step = std::min(length - s, (on ? dash : period) - phase);
      if (on) {
        list.AddLine(at(s), at(s + step), colour, thickness);
      }
      s += std::max(step, 0.01F);
      phase += step;
      phase = phase >= period - 0.01F ? 0.0F : phase;
    }
  }
}

} // namespace stretch::ui
