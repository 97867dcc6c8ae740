#include "rig/corners/vertex_split.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "core/scene/bind_chains.h"
#include "rig/corners/enclosing_corners.h"
#include "rig/corners/few_weights.h"

namespace stretch::rig {

namespace {

constexpr double unseen = 1e-7; // a weight that no place tells
// Misses of a fit, in heights, from which a vertex gets corners of its own.
constexpr double missOfEight = 5e-6;
constexpr double missOfFewer = 4e-3;    // influences
constexpr std::size_t mostCorners = 64; // of a joint

} // namespace

VertexSplit::VertexSplit(const MovedMesh& mesh, std::map<NodeIndex, CornerSet>& sets,
                         const CornerOptions& options)
    : mesh_(mesh), options_(options), slots_(mesh.joints.size()) {
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    const auto found = sets.find(mesh.joints[slot]);
    slots_[slot].corners = found == sets.end() ? nullptr : &found->second;
    slots_[slot].isGivenUp = std::ranges::any_of(sets, [&](const auto& set) {
      return std::ranges::find(set.second.givenUp, mesh.joints[slot]) != set.second.givenUp.end();
    });
    const std::size_t made = found == sets.end() ? 0 : found->second.made.size();
    for (std::size_t corner = 0; corner < made; ++corner) {
      const std::map<int, int>& slotOf = found->second.made[corner].slotOf;
      if (const auto own = slotOf.find(mesh.skin); own != slotOf.end()) {
        made_[static_cast<std::uint16_t>(own->second)] = {static_cast<std::uint16_t>(slot),
                                                          static_cast<int>(corner), 0.0};
      }
    }
  }
}

// Whether the joint gets corners that the file has not.
bool VertexSplit::isNew(std::uint16_t slot) const {
  return slot < slots_.size() && slots_[slot].corners != nullptr && slots_[slot].corners->made.empty();
}

const VertexSplit::Slot& VertexSplit::prepared(std::uint16_t index) {
  Slot& slot = slots_[index];
  if (!slot.matrices.empty() || options_.moments.empty()) {
    return slot;
  }
  const NodeIndex joint = mesh_.joints[index];
  for (const FrameState& moment : options_.moments) {
    const Mat4& world = moment.worlds[at(joint)];
    slot.matrices.push_back(world * mesh_.inverseBind[index]);
    std::vector<Vec3>& offsets = slot.offsets.emplace_back();
    const Mat3 stretch = moment.stretch.empty() ? Mat3(1.0) : moment.stretch[at(joint)];
    for (std::size_t k = 0; slot.corners != nullptr && k < slot.corners->places.size(); ++k) {
      const Vec3& corner = slot.corners->places[k];
      offsets.push_back(transformVector(world, stretch * corner - corner));
    }
  }
  return slot;
}

// What a vertex follows: the new corners around it in the place of their joints, and all else as the file has
// it, whose weights may have been fitted.
std::vector<CornerInfluence> VertexSplit::partsOf(const VertexInfluences& vertex,
                                                  const VertexInfluences& written, const Vec3& place) const {
  std::vector<CornerInfluence> parts;
  const auto add = [&](const CornerInfluence& part) {
    if (!(part.weight < unseen)) {
      parts.push_back(part);
    }
  };
  for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
    const std::uint16_t slot = vertex.joints[i];
    if (!isNew(slot)) {
      continue;
    }
    const auto weight = static_cast<double>(vertex.weights[i]);
    const std::vector<double> shares = affineCoordinates(slots_[slot].corners->enclosingPlaces(),
                                                         transformPoint(mesh_.inverseBind[slot], place));
    double ofJoint = 1.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      ofJoint -= shares[k];
      add({slot, static_cast<int>(k), weight * shares[k]});
    }
    add({slot, -1, weight * ofJoint});
  }
  for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
    const auto corner = made_.find(written.joints[i]);
    CornerInfluence part =
        corner == made_.end() ? CornerInfluence{written.joints[i], -1, 0.0} : corner->second;
    part.weight = static_cast<double>(written.weights[i]);
    if (part.slot < slots_.size() && !slots_[part.slot].isGivenUp && !isNew(part.slot)) {
      add(part);
    }
  }
  return parts;
}

VertexSplit::Answer VertexSplit::of(const VertexInfluences& asRead, const VertexInfluences* onCorners,
                                    const Vec3& place) {
  const VertexInfluences vertex = withoutRepeats(asRead);
  Answer answer;
  answer.parts = partsOf(vertex, onCorners == nullptr ? vertex : withoutRepeats(*onCorners), place);
  answer.isMoved = std::ranges::any_of(answer.parts, [&](const auto& part) { return isNew(part.slot); });
  if (answer.parts.size() > options_.mostInfluences) {
    std::vector<CornerInfluence> exact = answer.parts;
    fit(answer, vertex, place);
    const double most = options_.mostInfluences < VertexInfluences::capacity ? missOfFewer : missOfEight;
    if (answer.miss > most * options_.height && putOnOwnCorners(exact, place)) {
      answer = {std::move(exact), true, false, 0.0};
    }
  }
  std::ranges::stable_sort(answer.parts, std::ranges::greater(), &CornerInfluence::weight);
  return answer;
}

// Gives a vertex corners where it stands, each in the place of those around it, where few enough are left.
bool VertexSplit::putOnOwnCorners(std::vector<CornerInfluence>& parts, const Vec3& place) {
  struct Whole {
    double weight = 0.0;
    std::size_t parts = 0;
  };
  std::map<std::uint16_t, Whole> wholes;
  for (const CornerInfluence& part : parts) {
    wholes[part.slot].weight += part.weight;
    ++wholes[part.slot].parts;
  }
  const auto ownPlace = [&](std::uint16_t slot) { return transformPoint(mesh_.inverseBind[slot], place); };
  std::erase_if(wholes, [&](const auto& whole) {
    return whole.second.parts < 2 || ownCorner(whole.first, ownPlace(whole.first)) < 0;
  });
  std::size_t least = parts.size();
  for (const auto& [slot, whole] : wholes) {
    least -= whole.parts - 1;
  }
  for (const auto& [slot, whole] : wholes) {
    if (least > options_.mostInfluences || parts.size() <= options_.mostInfluences) {
      break;
    }
    const int own = ownCorner(slot, ownPlace(slot));
    std::vector<Vec3>& places = slots_[slot].corners->places;
    places.resize(std::max(places.size(), at(own) + 1), ownPlace(slot));
    std::erase_if(parts, [joint = slot](const CornerInfluence& part) { return part.slot == joint; });
    parts.push_back({slot, own, whole.weight});
  }
  return least <= options_.mostInfluences;
}

// The joint's corner at a place in its space, or the next one, which is to be made there; -1: too many, or
// the file has its own.
int VertexSplit::ownCorner(std::uint16_t index, const Vec3& own) const {
  constexpr double samePlace = 1e-6; // of the height, above the rounding of places in files
  const CornerSet* const set = slots_[index].corners;
  if (set == nullptr) {
    return -1;
  }
  const auto found = std::ranges::find_if(set->places, [&](const Vec3& corner) {
    return glm::length(corner - own) <= samePlace * options_.height;
  });
  const bool isFull = !set->made.empty() || set->places.size() >= mostCorners;
  return found == set->places.end() && isFull ? -1 : static_cast<int>(found - set->places.begin());
}

// Every offered corner of the joints that a vertex follows, and they themselves; corners that it has.
std::vector<CornerInfluence> VertexSplit::candidatesOf(const VertexInfluences& vertex,
                                                       const std::vector<CornerInfluence>& exact) const {
  std::vector<CornerInfluence> candidates;
  for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
    const std::uint16_t slot = vertex.joints[i];
    if (!(vertex.weights[i] > 0.0F) || slot >= slots_.size()) {
      continue;
    }
    const CornerSet* const set = slots_[slot].corners;
    const int corners = set == nullptr ? 0 : static_cast<int>(set->offered);
    for (int corner = -1; corner < corners; ++corner) {
      candidates.push_back({slot, corner, 0.0});
    }
  }
  for (const CornerInfluence& part : exact) {
    const CornerSet* const set = slots_[part.slot].corners;
    if (set != nullptr && part.corner >= static_cast<int>(set->offered)) {
      candidates.push_back({part.slot, part.corner, 0.0});
    }
  }
  return candidates;
}

// Normals turn with the joints: a joint should keep its share of the vertex, where there is room for that.
void VertexSplit::addShading(const std::vector<CornerInfluence>& exact,
                             const std::vector<CornerInfluence>& candidates, MissProducts& products) const {
  constexpr double shareAsHeights = 0.05; // a vertex wholly on another joint misses by so much
  if (options_.mostInfluences < VertexInfluences::capacity) {
    return;
  }
  std::map<std::uint16_t, double> shares;
  for (const CornerInfluence& part : exact) {
    shares[part.slot] += part.weight;
  }
  const double length = shareAsHeights * options_.height;
  const double scale = length * length * static_cast<double>(options_.moments.size());
  for (const auto& [slot, share] : shares) {
    for (std::size_t a = 0; a < candidates.size(); ++a) {
      for (std::size_t b = 0; b < candidates.size(); ++b) {
        products.products[a * candidates.size() + b] += scale *
                                                        ((candidates[a].slot == slot ? 1.0 : 0.0) - share) *
                                                        ((candidates[b].slot == slot ? 1.0 : 0.0) - share);
      }
    }
  }
}

void VertexSplit::fit(Answer& answer, const VertexInfluences& vertex, const Vec3& place) {
  std::vector<CornerInfluence> candidates = candidatesOf(vertex, answer.parts);
  const auto placeOf = [&](const CornerInfluence& part, std::size_t moment) {
    const Slot& slot = prepared(part.slot);
    const Vec3 ofJoint = transformPoint(slot.matrices[moment], place);
    return part.corner < 0 ? ofJoint : ofJoint + slot.offsets[moment][at(part.corner)];
  };
  std::vector<Vec3> differences(options_.moments.size() * candidates.size());
  MissProducts products{candidates.size(), std::vector<double>(candidates.size() * candidates.size(), 0.0)};
  for (std::size_t moment = 0; moment < options_.moments.size(); ++moment) {
    Vec3 wanted(0.0);
    for (const CornerInfluence& part : answer.parts) {
      wanted += part.weight * placeOf(part, moment);
    }
    Vec3* const misses = differences.data() + moment * candidates.size();
    for (std::size_t a = 0; a < candidates.size(); ++a) {
      misses[a] = placeOf(candidates[a], moment) - wanted;
      for (std::size_t b = 0; b <= a; ++b) {
        products.products[a * candidates.size() + b] += glm::dot(misses[a], misses[b]);
      }
    }
  }
  for (std::size_t a = 0; a < candidates.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      products.products[b * candidates.size() + a] = products.at(a, b);
    }
  }
  addShading(answer.parts, candidates, products);
  std::vector<std::size_t> exact;
  for (std::size_t a = 0; a < candidates.size(); ++a) {
    if (std::ranges::any_of(answer.parts, [&](const CornerInfluence& part) {
          return part.slot == candidates[a].slot && part.corner == candidates[a].corner;
        })) {
      exact.push_back(a);
    }
  }
  const std::vector<double> weights = fewWeights(products, exact, options_.mostInfluences);
  for (std::size_t moment = 0; moment < options_.moments.size(); ++moment) {
    Vec3 miss(0.0);
    for (std::size_t a = 0; a < candidates.size(); ++a) {
      miss += weights[a] * differences[moment * candidates.size() + a];
    }
    answer.miss = std::max(answer.miss, glm::length(miss));
  }
  for (std::size_t a = 0; a < candidates.size(); ++a) {
    candidates[a].weight = weights[a];
  }
  std::erase_if(candidates, [](const CornerInfluence& part) { return part.weight < unseen; });
  answer.parts = std::move(candidates);
  answer.isFitted = true;
}

} // namespace stretch::rig
