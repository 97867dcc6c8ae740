#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "skinning/bind/bone_lines.h"
#include "skinning/bind/skeleton_ways.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// Takes from every vertex what it follows of bones that are near across a gap and far along the skeleton:
/// the other leg, the hand on the thigh.
void dropStrangers(std::span<const glm::vec3> positions, const std::vector<BoneLine>& lines,
                   const SkeletonWays& ways, std::vector<Influences>& weights);

/// A patch of the surface that follows a joint which is no relative of those that all of its neighbours
/// follow was reached across a gap: it gets what its neighbours have.
void takeInPatches(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& welded,
                   const std::vector<BindJoint>& joints, std::vector<Influences>& weights);

} // namespace stretch::skinning
