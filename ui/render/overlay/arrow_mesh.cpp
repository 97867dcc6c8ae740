#include "ui/render/overlay/arrow_mesh.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace stretch::ui {

namespace {

constexpr int sides = 24;

// A ring around an axis.
struct Frame {
  Vec3 along;
  Vec3 across;
  Vec3 over;

  [[nodiscard]] Vec3 spoke(int side) const {
    const double angle = 2.0 * pi * side / sides;
    return std::cos(angle) * across + std::sin(angle) * over;
  }
};

Frame frameAlong(const Vec3& along) {
  const Vec3 helper = std::abs(along.y) < 0.9 ? Vec3(0.0, 1.0, 0.0) : Vec3(1.0, 0.0, 0.0);
  const Vec3 across = glm::normalize(glm::cross(helper, along));
  return {along, across, glm::cross(along, across)};
}

struct Corner {
  Vec3 position;
  Vec3 normal;
};

class Mesher {
public:
  Mesher(const View& view, const glm::vec4& color, std::vector<SolidVertex>& vertices)
      : view_(view), color_(color), vertices_(vertices) {}

  void triangle(const Corner& a, const Corner& b, const Corner& c) {
    for (const Corner& corner : {a, b, c}) {
      vertices_.push_back({glm::vec3(corner.position - view_.eye), glm::vec3(corner.normal), color_});
    }
  }

  void cylinder(const Vec3& from, const Vec3& to, const Frame& frame, double radius) {
    for (int side = 0; side < sides; ++side) {
      const Vec3 here = frame.spoke(side);
      const Vec3 next = frame.spoke(side + 1);
      const Corner a{from + radius * here, here};
      const Corner b{from + radius * next, next};
      const Corner c{to + radius * next, next};
      triangle(a, b, c);
      triangle(a, c, {to + radius * here, here});
    }
  }

  void cone(const Vec3& base, const Vec3& tip, const Frame& frame, double radius) {
    const double slope = radius / std::max(glm::length(tip - base), 1e-12);
    for (int side = 0; side < sides; ++side) {
      const Vec3 here = frame.spoke(side);
      const Vec3 next = frame.spoke(side + 1);
      const Vec3 outHere = glm::normalize(here + slope * frame.along);
      const Vec3 outNext = glm::normalize(next + slope * frame.along);
      triangle({base + radius * here, outHere}, {base + radius * next, outNext},
               {tip, glm::normalize(outHere + outNext)});
      triangle({base, -frame.along}, {base + radius * next, -frame.along},
               {base + radius * here, -frame.along});
    }
  }

private:
  const View& view_;
  glm::vec4 color_;
  std::vector<SolidVertex>& vertices_;
};

void addArrow(const View& view, const Arrow& arrow, std::vector<SolidVertex>& vertices) {
  const double length = glm::length(arrow.to - arrow.from);
  if (!(length > 0.0)) {
    return;
  }
  const double unitsPerPoint = unitsPerPixel(view, arrow.from) * view.viewport.pixelsPerPoint;
  const Frame frame = frameAlong((arrow.to - arrow.from) / length);
  const double headLength = std::min(static_cast<double>(arrow.headPoints) * unitsPerPoint, length);
  const Vec3 neck = arrow.to - headLength * frame.along;
  Mesher mesher(view, arrow.color, vertices);
  const auto shaft = [&] {
    mesher.cylinder(arrow.from, neck, frame, 0.5 * static_cast<double>(arrow.widthPoints) * unitsPerPoint);
  };
  const auto head = [&] { mesher.cone(neck, arrow.to, frame, 0.38 * headLength); };
  // Without a depth test the order decides: the half that points at the viewer comes last.
  if (glm::dot(frame.along, view.forward) > 0.0) {
    head();
    shaft();
  } else {
    shaft();
    head();
  }
}

} // namespace

std::vector<SolidVertex> arrowMeshes(const View& view, std::span<const Arrow> arrows) {
  std::vector<const Arrow*> farthestFirst;
  for (const Arrow& arrow : arrows) {
    farthestFirst.push_back(&arrow);
  }
  const auto distance = [&](const Arrow* arrow) {
    return glm::dot(0.5 * (arrow->from + arrow->to) - view.eye, view.forward);
  };
  std::stable_sort(farthestFirst.begin(), farthestFirst.end(),
                   [&](const Arrow* a, const Arrow* b) { return distance(a) > distance(b); });
  std::vector<SolidVertex> vertices;
  for (const Arrow* arrow : farthestFirst) {
    addArrow(view, *arrow, vertices);
  }
  return vertices;
}

} // namespace stretch::ui
