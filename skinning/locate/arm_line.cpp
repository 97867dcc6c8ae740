#include "skinning/locate/arm_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "skinning/bind/voxel_ways.h"

namespace stretch::skinning {

namespace {

constexpr double unreached = std::numeric_limits<double>::max();
constexpr double cubesInSection = 2.0;
constexpr double upperPartOfArm = 0.55;

std::vector<double> waysFrom(const StandingBody& body, const std::vector<std::uint32_t>& cells) {
  std::vector<double> ways(body.cubes.cellCount(), unreached);
  CellQueue open;
  for (const std::uint32_t cell : cells) {
    ways[cell] = 0.0;
    open.emplace(0.0, cell);
  }
  spread(body.cubes, ways, open, [](std::size_t, std::size_t) {});
  return ways;
}

std::vector<std::uint32_t> middlePlane(const StandingBody& body, const LegLines& legs) {
  std::vector<std::uint32_t> middle;
  for (std::uint32_t cell = 0; cell < body.cubes.cellCount(); ++cell) {
    const Vec3 place = body.middleOf(cell);
    if (std::abs(place.x) < 1.5 * body.cubes.grid.size && !legs.isLeg[cell]) {
      middle.push_back(cell);
    }
  }
  return middle;
}

struct Tip {
  std::uint32_t cell = 0;
  double way = 0.0; ///< From the middle of the body.
};

Tip tipOf(const StandingBody& body, const LegLines& legs, const std::vector<double>& fromMiddle, double side,
          double longest) {
  constexpr double lowestHand = 0.6; // of the crotch's height
  Tip tip;
  for (std::uint32_t cell = 0; cell < body.cubes.cellCount(); ++cell) {
    const Vec3 place = body.middleOf(cell);
    const bool isArm = !legs.isLeg[cell] && side * place.x > 0.0 && place.y > lowestHand * legs.crotch;
    const bool isReached = fromMiddle[cell] != unreached && fromMiddle[cell] <= longest;
    if (isArm && isReached && fromMiddle[cell] > tip.way) {
      tip = {cell, fromMiddle[cell]};
    }
  }
  return tip;
}

// Means and sizes of what is gathered section by section.
class Sections {
public:
  Sections(std::size_t count, double step, double size)
      : sections_(count), counts_(count, 0.0), step_(step), cube_(size * size * size) {}
  void add(double way, const Vec3& place) {
    const auto section = static_cast<std::size_t>(std::max(way, 0.0) / step_);
    if (section < sections_.size()) {
      sections_[section].middle += place;
      counts_[section] += 1.0;
    }
  }
  [[nodiscard]] std::vector<ArmSection> filled() const {
    std::vector<ArmSection> filled;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      if (counts_[i] > 0.0) {
        filled.push_back({(static_cast<double>(i) + 0.5) * step_, sections_[i].middle / counts_[i],
                          std::sqrt(counts_[i] * cube_ / step_ / pi)});
      }
    }
    return filled;
  }

private:
  std::vector<ArmSection> sections_;
  std::vector<double> counts_;
  double step_;
  double cube_;
};

// The direction in which a heap of places is longest, the way that `start` points.
Vec3 outwardsAlong(const std::vector<Vec3>& places, const Vec3& centroid, const Vec3& start) {
  Mat3 spread(0.0);
  for (const Vec3& place : places) {
    spread += glm::outerProduct(place - centroid, place - centroid);
  }
  Vec3 axis = glm::length(start) > 0.0 ? start : Vec3(1.0, 0.0, 0.0);
  constexpr int rounds = 40;
  for (int round = 0; round < rounds && glm::length(spread * axis) > 0.0; ++round) {
    axis = glm::normalize(spread * axis);
  }
  return glm::dot(axis, start) < 0.0 ? -axis : axis;
}

} // namespace

std::vector<double> waysFromMiddle(const StandingBody& body, const LegLines& legs) {
  return waysFrom(body, middlePlane(body, legs));
}

ArmLine armLine(const StandingBody& body, const LegLines& legs, const std::vector<double>& fromMiddle,
                double side, double longest) {
  ArmLine line;
  const Tip tip = tipOf(body, legs, fromMiddle, side, longest);
  line.way = tip.way;
  if (tip.way <= 0.0) {
    return line;
  }
  const std::vector<double> fromTip = waysFrom(body, {tip.cell});
  const double size = body.cubes.grid.size;
  const double step = cubesInSection * size;
  Sections sections(static_cast<std::size_t>(line.way / step) + 1, step, size);
  for (std::uint32_t cell = 0; cell < body.cubes.cellCount(); ++cell) {
    if (legs.isLeg[cell] || fromTip[cell] >= line.way || fromMiddle[cell] > longest) {
      continue;
    }
    sections.add(fromTip[cell], body.middleOf(cell));
    line.cells.emplace_back(cell, fromTip[cell]);
    const bool isEnd = body.isBridge(cell) && fromTip[cell] > upperPartOfArm * line.way;
    if (isEnd && (line.ownPiece == 0.0 || fromTip[cell] < line.ownPiece)) {
      line.ownPiece = fromTip[cell];
    }
  }
  line.sections = sections.filled();
  return line;
}

std::vector<ArmSection> straightSections(const StandingBody& body, const ArmLine& arm, double way) {
  std::vector<Vec3> places;
  Vec3 centroid(0.0);
  for (const auto& [cell, fromTip] : arm.cells) {
    if (fromTip < way) {
      places.push_back(body.middleOf(cell));
      centroid += places.back();
    }
  }
  if (places.empty()) {
    return {};
  }
  centroid /= static_cast<double>(places.size());
  const Vec3 outwards = outwardsAlong(places, centroid, arm.sections.front().middle - centroid);
  double tip = 0.0;
  double end = 0.0;
  for (const Vec3& place : places) {
    tip = std::max(tip, glm::dot(place - centroid, outwards));
    end = std::min(end, glm::dot(place - centroid, outwards));
  }
  constexpr double straight = 0.8;
  if (tip - end < straight * way) {
    return {};
  }
  const double step = cubesInSection * body.cubes.grid.size;
  Sections sections(static_cast<std::size_t>((tip - end) / step) + 1, step, body.cubes.grid.size);
  for (const Vec3& place : places) {
    sections.add(tip - glm::dot(place - centroid, outwards), place);
  }
  return sections.filled();
}

} // namespace stretch::skinning
