#include "skinning/locate/trunk_joints.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>

namespace stretch::skinning {

namespace {

struct TrunkSection {
  double height = 0.0;
  Vec3 middle{0.0};
  double area = 0.0;
};

TrunkSection trunkSection(const StandingBody& body, std::size_t layer, double halfWidth) {
  TrunkSection section{body.layerHeight(layer), {}, 0.0};
  double count = 0.0;
  for (const SliceRegion& region : body.layers[layer]) {
    for (const std::uint32_t cell : region.cells) {
      const Vec3 place = body.middleOf(cell);
      if (std::abs(place.x) < halfWidth && !body.isBridge(cell)) {
        section.middle += place;
        count += 1.0;
      }
    }
  }
  section.middle /= std::max(count, 1.0);
  section.area = count * body.cubes.grid.size * body.cubes.grid.size;
  return section;
}

std::vector<TrunkSection> trunkSections(const StandingBody& body, double from, double halfWidth) {
  std::vector<TrunkSection> sections;
  for (std::size_t layer = body.layerAt(from); layer < body.layers.size(); ++layer) {
    const TrunkSection section = trunkSection(body, layer, halfWidth);
    if (section.area > 0.0) {
      sections.push_back(section);
    }
  }
  return sections;
}

Vec3 trunkMiddle(const std::vector<TrunkSection>& sections, double height) {
  const auto found = std::ranges::lower_bound(sections, height, {}, &TrunkSection::height);
  const TrunkSection& near = found == sections.end() ? sections.back() : *found;
  return {near.middle.x, height, near.middle.z};
}

// The middle of all that is above a height, as of a head.
Vec3 middleAbove(const std::vector<TrunkSection>& sections, double height) {
  Vec3 sum(0.0);
  double area = 0.0;
  for (const TrunkSection& section : sections) {
    if (section.height >= height) {
      sum += section.area * Vec3(section.middle.x, section.height, section.middle.z);
      area += section.area;
    }
  }
  return area > 0.0 ? sum / area : Vec3(0.0, height, 0.0);
}

// The narrowest section between the shoulders and the head's widest part: one above which the body grows
// again, as it does not below what sticks up from a head, where there is such a one.
std::size_t narrowestOver(const std::vector<TrunkSection>& sections, double shoulders) {
  constexpr double neckPart = 0.6; // of what is above the shoulders
  constexpr double grows = 1.1;
  std::size_t narrowest = 0;
  bool hasNeck = false;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const double height = sections[i].height;
    const bool isBetween = height > shoulders && height < shoulders + neckPart * (1.0 - shoulders);
    const bool isFirst = sections[narrowest].height <= shoulders;
    const bool isNeck = std::any_of(sections.begin() + static_cast<std::ptrdiff_t>(i), sections.end(),
                                    [&](const auto& above) { return above.area > grows * sections[i].area; });
    const bool isBetter = isNeck == hasNeck ? sections[i].area < sections[narrowest].area : isNeck;
    if (isBetween && (isFirst || isBetter)) {
      narrowest = i;
      hasNeck = isNeck;
    }
  }
  return narrowest;
}

// Where the neck begins: downwards it grows.
std::size_t baseOf(const std::vector<TrunkSection>& sections, std::size_t narrowest, double shoulders) {
  constexpr double grown = 1.6;
  std::size_t base = narrowest;
  while (base > 0 && sections[base - 1].height > shoulders &&
         sections[base - 1].area < grown * sections[narrowest].area) {
    --base;
  }
  return base;
}

double largestArea(const std::vector<TrunkSection>& sections) {
  return std::ranges::max_element(sections, {}, &TrunkSection::area)->area;
}

} // namespace

TrunkJoints trunkJoints(const StandingBody& body, double crotch, double shoulderHeight, double halfWidth) {
  constexpr double neckBelowBase = 0.005;
  constexpr double headOverNarrowest = 0.012;
  constexpr double shortestNeck = 0.02;
  constexpr double shows = 0.5; // of the largest section
  const std::vector<TrunkSection> sections = trunkSections(body, crotch, halfWidth);
  TrunkJoints joints;
  if (sections.empty()) {
    return joints;
  }
  const std::size_t narrowest = narrowestOver(sections, shoulderHeight);
  const double neck = sections[baseOf(sections, narrowest, shoulderHeight)].height - neckBelowBase;
  const double head = std::max(sections[narrowest].height + headOverNarrowest, neck + shortestNeck);
  const double sure = sections[narrowest].area < shows * largestArea(sections) ? 0.7 : 0.4;
  joints.hips = {trunkMiddle(sections, crotch), 0.8};
  joints.neck = {trunkMiddle(sections, neck), sure};
  // On the way to the middle of the head: a section there may hold the chin or a collar.
  const Vec3 top = middleAbove(sections, head);
  const double part = top.y > neck ? (head - neck) / (top.y - neck) : 0.0;
  joints.head = {glm::mix(joints.neck.place, top, std::clamp(part, 0.0, 1.0)), sure};
  return joints;
}

double depthForHeight(const StandingBody& body, double crotch, double halfWidth) {
  Vec3 sum(0.0);
  Vec3 squares(0.0);
  double count = 0.0;
  for (std::uint32_t cell = 0; cell < body.ownCells; ++cell) {
    const Vec3 place = body.middleOf(cell);
    if (std::abs(place.x) < halfWidth && place.y >= crotch) {
      sum += place;
      squares += place * place;
      count += 1.0;
    }
  }
  const Vec3 mean = sum / std::max(count, 1.0);
  const Vec3 spread = squares / std::max(count, 1.0) - mean * mean;
  return spread.y > 0.0 ? std::sqrt(std::max(spread.z, 0.0) / spread.y) : 0.0;
}

double hipHeightOf(double crotch, double neckHeight) {
  constexpr double overCrotch = 0.03;
  constexpr double smallHead = 0.77;
  constexpr double ofNeck = 0.59;
  constexpr double atMost = 0.61;
  constexpr double intoPelvis = 0.65; // legs of bare bones are followed up between the pelvis's blades
  if (crotch > intoPelvis * neckHeight) {
    return ofNeck * neckHeight;
  }
  if (neckHeight < smallHead) {
    return crotch + overCrotch;
  }
  return std::min(0.75 * (crotch + overCrotch) + 0.25 * ofNeck * neckHeight, atMost * neckHeight);
}

} // namespace stretch::skinning
