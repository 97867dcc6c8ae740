#include "skinning/locate/creature/creature_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "skinning/bind/voxel_ways.h"
#include "skinning/locate/creature/creature_ends.h"
#include "skinning/locate/creature/joints_along.h"

namespace stretch::skinning {

namespace {

Vec3 mirrorOf(const Vec3& place) {
  return {-place.x, place.y, place.z};
}

constexpr double tailBehind = 0.1;  // the hips, of the height
constexpr double usualHeight = 0.6; // of a trunk that shows nothing of itself

// A body with its ends taken apart.
class Reader {
public:
  Reader(const StandingBody& body, int rows)
      : body_(body), ways_(waysFromCentre(body)), ends_(creatureEnds(body, ways_, rows)),
        branches_(branchesOf(body, ways_, ends_.all())),
        isTrunk_(trunkCells(body.cubes.cellCount(), branches_, ends_.middle.size())), facing_(facing()),
        back_(ends_.legs.empty() ? usualHeight : backHeight()) {}

  [[nodiscard]] CreatureShape shape() const {
    CreatureShape shape;
    shape.legRows = static_cast<int>(ends_.legs.size());
    constexpr int mostRows = 8; // no plan has more, so that its number says enough
    if (ends_.legs.empty() || shape.legRows > mostRows) {
      return shape;
    }
    addLegs(shape);
    addOthers(shape);
    addTrunk(shape);
    return shape;
  }

private:
  // All but what branches off at the sides; the first ones lie in the middle.
  static std::vector<bool> trunkCells(std::size_t cells, const std::vector<BodyBranch>& branches,
                                      std::size_t inMiddle) {
    std::vector<bool> isTrunk(cells, true);
    for (std::size_t i = inMiddle; i < branches.size(); ++i) {
      for (const std::uint32_t cell : branches[i].cells) {
        isTrunk[cell] = false;
      }
    }
    return isTrunk;
  }

  struct Slab {
    double low = 0.0;
    double high = 0.0;
    double middle = 0.0;
    double halfWidth = 0.0;
    double count = 0.0;
  };

  [[nodiscard]] double size() const { return body_.cubes.grid.size; }
  [[nodiscard]] Vec3 at(std::uint32_t cell) const { return body_.middleOf(cell); }

  [[nodiscard]] const BodyBranch& branchOf(const BodyEnd& end) const {
    return *std::ranges::find(branches_, end.cell, &BodyBranch::tip);
  }

  // How far each cell is from a tip: by the way inside, or along an axis of the body.
  [[nodiscard]] std::vector<double> fromTip(const BodyEnd& end, std::optional<int> axis) const {
    std::vector<double> from(ways_.size());
    for (std::uint32_t cell = 0; cell < from.size(); ++cell) {
      from[cell] = axis ? std::abs(at(cell)[*axis] - at(end.cell)[*axis]) : ways_[end.cell] - ways_[cell];
    }
    return from;
  }

  [[nodiscard]] std::vector<BranchSection> sections(const BodyEnd& end) const {
    return sectionsOf(body_, branchOf(end).cells, fromTip(end, {}));
  }

  // Of each section what goes before its middle.
  [[nodiscard]] std::vector<BranchSection> leadingSections(const BodyEnd& end) const {
    constexpr double whole = 0.8;
    constexpr double spread = 0.6; // of its length: sections lie straight across
    const bool isSpread = std::abs(at(end.cell).x - end.root.x) > spread * end.length;
    const std::vector<double> fromTip = this->fromTip(end, isSpread ? std::optional(0) : std::nullopt);
    std::vector<std::uint32_t> cells = branchOf(end).cells;
    for (int halving = 0; halving < 2; ++halving) {
      std::map<std::size_t, std::pair<double, double>> depths;
      const auto section = [&](std::uint32_t cell) {
        return static_cast<std::size_t>(fromTip[cell] / (2.0 * size()));
      };
      for (const std::uint32_t cell : cells) {
        auto& [sum, count] = depths[section(cell)];
        sum += at(cell).z;
        count += 1.0;
      }
      std::erase_if(cells, [&](std::uint32_t cell) {
        const auto& [sum, count] = depths[section(cell)];
        const double rounding = 1e-6 * size();
        return facing_ * (at(cell).z - sum / count) < -rounding;
      });
    }
    std::vector<BranchSection> all = sectionsOf(body_, cells, fromTip);
    // Where the wing grows on the body only a part of it is the wing's.
    const auto widest = std::max_element(all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end(),
                                         [](const auto& a, const auto& b) { return a.radius < b.radius; });
    all.erase(
        std::find_if(widest, all.end(), [&](const auto& one) { return one.radius < whole * widest->radius; }),
        all.end());
    return all;
  }

  // The trunk across, at a place along it.
  [[nodiscard]] Slab slabAt(double z) const {
    constexpr double thick = 0.03;
    Slab slab{std::numeric_limits<double>::max(), 0.0, 0.0, 0.0, 0.0};
    for (std::uint32_t cell = 0; cell < body_.ownCells; ++cell) {
      const Vec3 place = at(cell);
      if (isTrunk_[cell] && std::abs(place.z - z) < std::max(thick, 1.5 * size())) {
        slab.halfWidth = std::max(slab.halfWidth, std::abs(place.x));
        if (std::abs(place.x) < 2.0 * size()) {
          slab.low = std::min(slab.low, place.y);
          slab.high = std::max(slab.high, place.y);
        }
        slab.middle += place.y;
        slab.count += 1.0;
      }
    }
    slab.middle /= std::max(slab.count, 1.0);
    return slab;
  }

  // How far feet reach forward of their shins.
  [[nodiscard]] double feetForward() const {
    constexpr double shin = 0.12;
    double forward = 0.0;
    for (const EndPair& pair : ends_.legs) {
      for (const BodyEnd& end : {pair.left, pair.right}) {
        double z = 0.0;
        double count = 0.0;
        Bounds foot;
        for (const std::uint32_t cell : branchOf(end).cells) {
          const Vec3 place = at(cell);
          if (std::abs(place.y - shin) < 2.0 * size()) {
            z += place.z;
            count += 1.0;
          } else if (place.y < 0.5 * shin) {
            foot.add(place);
          }
        }
        if (count > 0.0 && !foot.empty()) {
          forward += foot.high.z + foot.low.z - 2.0 * z / count;
        }
      }
    }
    return forward / std::max<double>(1.0, 2.0 * static_cast<double>(ends_.legs.size()));
  }

  // What lies behind and before the legs of what is no leg or wing, all of it and the outer eighth.
  struct Overhang {
    std::array<double, 2> beyond{1.0, 1.0};
    std::array<double, 2> caps{1.0, 1.0};
    std::array<double, 2> heights{0.0, 0.0}; ///< Sums over the caps.
  };
  [[nodiscard]] Overhang overhang() const {
    constexpr double outer = 0.12;
    double legs = 0.0;
    for (const EndPair& pair : ends_.legs) {
      legs += 0.5 * (pair.left.root.z + pair.right.root.z) / static_cast<double>(ends_.legs.size());
    }
    Bounds box;
    for (std::uint32_t cell = 0; cell < body_.ownCells; ++cell) {
      if (isTrunk_[cell]) {
        box.add(at(cell));
      }
    }
    Overhang overhang;
    for (std::uint32_t cell = 0; cell < body_.ownCells; ++cell) {
      const Vec3 place = at(cell);
      if (!isTrunk_[cell]) {
        continue;
      }
      const std::size_t side = place.z > legs ? 1 : 0;
      overhang.beyond[side] += 1.0;
      if (std::min(box.high.z - place.z, place.z - box.low.z) < outer * (box.high.z - box.low.z)) {
        overhang.caps[side] += 1.0;
        overhang.heights[side] += place.y;
      }
    }
    return overhang;
  }

  // 1 where the body faces +Z, else -1.
  [[nodiscard]] double facing() const {
    constexpr std::size_t few = 2; // pairs of legs, of which feet and heads tell; spiders tell by abdomens
    constexpr double mostOfFeet = 0.1;
    const Overhang over = overhang();
    const double feet = std::clamp(feetForward(), -mostOfFeet, mostOfFeet) / mostOfFeet;
    const double heights = over.heights[1] / over.caps[1] - over.heights[0] / over.caps[0];
    const double vote = ends_.legs.size() > few
                            ? std::log(over.beyond[0] / over.beyond[1])
                            : feet + heights + 0.5 * std::log(over.caps[1] / over.caps[0]);
    return vote < 0.0 ? -1.0 : 1.0;
  }

  // Between the legs: over the shoulders the neck may rise.
  [[nodiscard]] double backHeight() const {
    double z = 0.0;
    for (const EndPair& pair : ends_.legs) {
      z += 0.5 * (sections(pair.left).back().middle.z + sections(pair.right).back().middle.z);
    }
    const Slab slab = slabAt(z / static_cast<double>(ends_.legs.size()));
    return slab.low <= slab.high ? slab.high : slab.count > 0.0 ? slab.middle : usualHeight;
  }

  // A leg hangs under the trunk, and goes on in it to its hip, or sprawls beside it.
  [[nodiscard]] std::vector<Vec3> legLine(const BodyEnd& end, bool isFront) const {
    const Vec3 tip = at(end.cell);
    const bool hangs = end.root.y - tip.y > std::abs(end.root.x - tip.x);
    std::vector<Vec3> line = hangs ? hangingLine(end, isFront) : sprawlingLine(sections(end));
    std::ranges::reverse(line);
    line.push_back(tip);
    return line;
  }

  // The middles of a leg, layer by layer from the ground up, as long as it is apart from all else.
  [[nodiscard]] std::vector<Vec3> freeMiddles(const BodyEnd& end) const {
    std::vector<bool> isOwn(ways_.size(), false);
    for (const std::uint32_t cell : branchOf(end).cells) {
      isOwn[cell] = true;
    }
    std::vector<Vec3> middles;
    for (const std::vector<SliceRegion>& layer : body_.layers) {
      const SliceRegion* leg = nullptr;
      std::ptrdiff_t most = 0;
      for (const SliceRegion& region : layer) {
        const auto own = std::ranges::count_if(region.cells, [&](std::uint32_t cell) { return isOwn[cell]; });
        leg = own > most ? &region : leg;
        most = std::max(own, most);
      }
      if (leg != nullptr && leg->low.x * leg->high.x < 0.0) {
        break;
      }
      if (leg != nullptr) {
        middles.push_back(leg->middle);
      }
    }
    return middles;
  }

  // From the tip inwards.
  [[nodiscard]] std::vector<Vec3> hangingLine(const BodyEnd& end, bool isFront) const {
    constexpr double hipHeight = 0.75; // of the back's
    constexpr double shoulderHeight = 0.68;
    const Vec3 root = sections(end).back().middle;
    const double hip = (isFront ? shoulderHeight : hipHeight) * back_;
    std::vector<Vec3> line = freeMiddles(end);
    std::erase_if(line, [&](const Vec3& middle) { return middle.y > hip - 2.0 * size(); });
    const Vec3 top = line.empty() ? root : line.back();
    line.emplace_back(top.x, hip, 0.5 * (top.z + root.z));
    return line;
  }

  [[nodiscard]] std::vector<Vec3> sprawlingLine(const std::vector<BranchSection>& all) const {
    constexpr double grown = 1.8;
    std::vector<double> radii;
    radii.reserve(all.size());
    for (const BranchSection& section : all) {
      radii.push_back(section.radius);
    }
    std::ranges::nth_element(radii, radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2));
    const double usual = radii[radii.size() / 2];
    std::vector<Vec3> line;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i > all.size() / 2 && all[i].radius > grown * usual) {
        break;
      }
      line.push_back(all[i].middle);
    }
    return withinTrunk(std::move(line));
  }

  // What sticks out on a side turns inside of the trunk.
  [[nodiscard]] static std::vector<Vec3> withinTrunk(std::vector<Vec3> line, bool straightAcross = false) {
    const double inwards = straightAcross ? 0.6 : 0.35; // of how far the middle of the body is away
    const Vec3 base = line.back();
    const Vec3 along =
        straightAcross ? Vec3(-base.x, 0.0, 0.0) : base - line[line.size() - 1 - line.size() / 4];
    if (glm::length(along) > 0.0) {
      line.push_back(base + inwards * std::abs(base.x) * glm::normalize(along));
    }
    return line;
  }

  // Both lines of a pair, or their mean where they mirror each other.
  void addPair(CreatureShape& shape, CreaturePart part, int row, std::vector<Vec3> left,
               std::vector<Vec3> right) const {
    constexpr std::size_t count = 33;
    constexpr double same = 0.1;
    left = evenly(left, count);
    right = evenly(right, count);
    double apart = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      apart = std::max(apart, glm::distance(left[i], mirrorOf(right[i])));
    }
    if (apart < same) {
      for (std::size_t i = 0; i < count; ++i) {
        left[i] = 0.5 * (left[i] + mirrorOf(right[i]));
        right[i] = mirrorOf(left[i]);
      }
    }
    const int side = facing_ > 0.0 ? 1 : -1;
    shape.limbs.push_back({part, side, row, left});
    shape.limbs.push_back({part, -side, row, right});
  }

  void addLegs(CreatureShape& shape) const {
    const auto rows = static_cast<int>(ends_.legs.size());
    for (int i = 0; i < rows; ++i) {
      const EndPair& pair = ends_.legs[static_cast<std::size_t>(i)];
      const int row = facing_ > 0.0 ? rows - i : i + 1;
      const bool isFront = row < rows;
      addPair(shape, CreaturePart::leg, row, legLine(pair.left, isFront), legLine(pair.right, isFront));
    }
  }

  [[nodiscard]] Vec3 baseOf(const CreatureShape& shape, int row) const {
    Vec3 sum(0.0);
    for (const CreatureLimb& limb : shape.limbs) {
      if (limb.part == CreaturePart::leg && limb.row == row) {
        sum += 0.5 * limb.line.front();
      }
    }
    return sum;
  }

  // The cell in the middle of the body that is farthest forward or backward.
  [[nodiscard]] std::uint32_t farthest(double way) const {
    constexpr double beside = 0.15;
    std::uint32_t best = 0;
    double most = -std::numeric_limits<double>::max();
    for (std::uint32_t cell = 0; cell < body_.ownCells; ++cell) {
      const Vec3 place = at(cell);
      const double reach = way * facing_ * place.z - 0.2 * std::abs(place.x);
      if (isTrunk_[cell] && std::abs(place.x) < beside && reach > most) {
        most = reach;
        best = cell;
      }
    }
    return best;
  }

  // From a place on the trunk to a tip, by the middles of the sections between.
  [[nodiscard]] std::vector<BranchSection> outTo(std::uint32_t tip, const Vec3& base, double way) const {
    std::vector<double> fromTip(ways_.size(), std::numeric_limits<double>::max());
    CellQueue open;
    fromTip[tip] = 0.0;
    open.emplace(0.0, tip);
    spread(body_.cubes, fromTip, open, [](std::size_t, std::size_t) {});
    const std::int32_t nearest = body_.cubes.cellNear(base, 8);
    const double longest = nearest == VoxelBody::outside ? glm::distance(at(tip), base)
                                                         : fromTip[static_cast<std::size_t>(nearest)];
    std::vector<std::uint32_t> cells;
    for (std::uint32_t cell = 0; cell < body_.cubes.cellCount(); ++cell) {
      if (isTrunk_[cell] && fromTip[cell] < longest && way * facing_ * (at(cell).z - base.z) > -0.1) {
        cells.push_back(cell);
      }
    }
    std::vector<BranchSection> all = sectionsOf(body_, cells, fromTip);
    for (BranchSection& section : all) {
      section.middle.x = 0.0;
    }
    std::ranges::reverse(all);
    return all;
  }

  void addTrunk(CreatureShape& shape) const {
    constexpr double overBelly = 0.6;
    const auto onTrunk = [&](double z) {
      const Slab slab = slabAt(z);
      const bool isHollow = slab.low > slab.high; // in the middle
      const double height = isHollow ? slab.middle : glm::mix(slab.low, slab.high, overBelly);
      return Vec3(0.0, slab.count > 0.0 ? height : usualHeight, z);
    };
    const std::uint32_t snout = farthest(1.0);
    const std::uint32_t rear = farthest(-1.0); // of a tail, where it reaches out behind
    const double hind = baseOf(shape, shape.legRows).z;
    const double front = shape.legRows > 1 ? baseOf(shape, 1).z : chestOf(shape, hind, at(snout).z);
    const Vec3 hips = onTrunk(hind);
    const Vec3 chest = onTrunk(front);
    addLine(shape, CreaturePart::spine, {hips, onTrunk(0.5 * (front + hind)), chest});
    std::vector<Vec3> neck{chest};
    for (const BranchSection& section : outTo(snout, chest, 1.0)) {
      neck.push_back(section.middle);
    }
    neck.emplace_back(0.0, at(snout).y, at(snout).z);
    addLine(shape, CreaturePart::neck, neck);
    constexpr double clearly = 1.4;
    const double forward = std::abs(at(snout).z - hind);
    const double up = 1.0 - ends_.legs.front().left.root.y;
    shape.trunkLies = forward > clearly * up;
    shape.trunkStands = up > clearly * forward;
    if (!hasTail(hind)) {
      return;
    }
    std::vector<Vec3> tail{hips};
    for (const BranchSection& section : outTo(rear, hips, -1.0)) {
      tail.push_back(section.middle);
    }
    tail.emplace_back(0.0, at(rear).y, at(rear).z);
    addLine(shape, CreaturePart::tail, tail);
  }

  [[nodiscard]] bool hasTail(double hips) const {
    return std::ranges::any_of(
        ends_.middle, [&](const BodyEnd& end) { return facing_ * (hips - at(end.cell).z) > tailBehind; });
  }

  // Where wings or arms begin, else not quite halfway to the head.
  [[nodiscard]] double chestOf(const CreatureShape& shape, double hips, double snout) const {
    constexpr double usual = 0.4;
    for (const CreatureLimb& limb : shape.limbs) {
      if (limb.part == CreaturePart::wing || limb.part == CreaturePart::arm) {
        return limb.line.front().z;
      }
    }
    return glm::mix(hips, snout, usual);
  }

  static void addLine(CreatureShape& shape, CreaturePart part, const std::vector<Vec3>& line) {
    shape.limbs.push_back({part, 0, 0, line});
  }

  // Along the edge that goes before: feathers and skin hang behind the bones of a wing.
  [[nodiscard]] std::vector<Vec3> sideLine(const BodyEnd& end, CreaturePart part) const {
    std::vector<Vec3> line;
    for (const BranchSection& section : part == CreaturePart::wing ? leadingSections(end) : sections(end)) {
      line.push_back(section.middle);
    }
    if (line.empty()) {
      line.push_back(end.root);
    }
    line = withinTrunk(std::move(line), part == CreaturePart::wing);
    std::ranges::reverse(line);
    line.push_back(at(end.cell));
    return line;
  }

  void addOthers(CreatureShape& shape) const {
    const double legs = ends_.legs.empty() ? 0.0 : ends_.legs.front().length();
    const double head = baseOf(shape, 1).z;
    for (const EndPair& pair : ends_.others) {
      const bool isAtHead =
          facing_ * (0.5 * (at(pair.left.cell).z + at(pair.right.cell).z) - head) > 0.0 && shape.legRows > 2;
      const CreaturePart part = isAtHead               ? CreaturePart::feeler
                                : pair.length() > legs ? CreaturePart::wing
                                                       : CreaturePart::arm;
      addPair(shape, part, 0, sideLine(pair.left, part), sideLine(pair.right, part));
    }
  }

  const StandingBody& body_;
  std::vector<double> ways_;
  CreatureEnds ends_;
  std::vector<BodyBranch> branches_;
  std::vector<bool> isTrunk_;
  double facing_ = 1.0;
  double back_ = usualHeight; // backHeight()
};

} // namespace

CreatureShape creatureShape(const StandingBody& body, int legRows) {
  return Reader(body, legRows).shape();
}

Result<CreatureShape> shapeOfMesh(std::span<const Vec3> positions, const std::vector<Triangle>& triangles,
                                  int legRows, UpAxis up, const Proceed& proceed) {
  const Result<StandingBody> body = standingIn(positions, triangles, up, proceed);
  if (!body) {
    return body.error();
  }
  CreatureShape shape = creatureShape(*body, legRows);
  for (CreatureLimb& limb : shape.limbs) {
    for (Vec3& place : limb.line) {
      place = body->upright.toScene(place);
    }
  }
  return shape;
}

} // namespace stretch::skinning
