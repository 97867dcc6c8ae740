#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "rig/corners/bind_corners.h"
#include "tests/support/recorded.h"
#include "tests/support/rig/moving_creatures.h"
#include "tests/support/rig/rekeyed_clip.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// Vertices follow up to `most` joints more, which are near in the list of the skin.
void shareVertices(Scene& scene, Row& row, std::uint32_t most) {
  const auto slots = static_cast<std::uint32_t>(scene.skins.front().joints.size());
  for (Mesh& mesh : scene.meshes) {
    for (Primitive& primitive : mesh.primitives) {
      for (VertexInfluences& vertex : primitive.influences) {
        double left = 1.0;
        const std::uint32_t more = row.below(most + 1);
        for (std::uint32_t i = 1; i <= more; ++i) {
          const double weight = left * row.between(0.1, 0.5);
          const std::uint32_t slot = (vertex.joints[0] + 1 + row.below(4)) % slots;
          vertex.joints[i] = static_cast<std::uint16_t>(slot);
          vertex.weights[i] = static_cast<float>(weight);
          left -= weight;
        }
        vertex.weights[0] = static_cast<float>(left);
      }
    }
  }
}

std::string cornerPlaceText(const Vec3& place) {
  return fmt::format(" {:.4f} {:.4f} {:.4f}", place.x, place.y, place.z);
}

std::string boundText(const gltf::BoundMesh& bound) {
  std::string text = fmt::format("  mesh on skin {}\n", bound.skin);
  for (const std::vector<VertexInfluences>& primitive : bound.influences) {
    std::map<int, double> weights;
    std::map<std::size_t, int> counts;
    double squares = 0.0;
    for (const VertexInfluences& vertex : primitive) {
      std::size_t count = 0;
      for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
        const auto weight = static_cast<double>(vertex.weights[i]);
        weights[vertex.joints[i]] += weight;
        squares += weight * weight * static_cast<double>(i + 1);
        count += weight > 0.0 ? 1 : 0;
      }
      ++counts[count];
    }
    text += fmt::format("    squares {:.3f} , influences", squares);
    for (const auto& [count, vertices] : counts) {
      text += fmt::format(" {} : {} ,", count, vertices);
    }
    text += " slots";
    for (const auto& [slot, sum] : weights) {
      text += sum > 0.0 ? fmt::format(" {} : {:.3f} ,", slot, sum) : "";
    }
    text += "\n";
  }
  return text;
}

std::string cornersText(const std::string& title, MovingBiped moving, const std::vector<Trail>& trails,
                        Row& row, std::uint32_t shared, std::size_t mostInfluences) {
  if (shared > 0) {
    shareVertices(moving.scene, row, shared);
  }
  const Rekeyed rekeyed = rekeyedOf(moving, trails);
  CornerOptions options;
  options.mostInfluences = mostInfluences;
  options.height = moving.body.height;
  for (const double frame : {0.0, 6.0, 9.0, 12.0, 15.0}) {
    options.moments.push_back(atFrame(moving, rekeyed.motion, frame));
  }
  gltf::Edits edits;
  const CornerFit fit = addBindCorners(moving.scene, {{0, rekeyed.keys.stretches}}, options, edits);
  std::string text = fmt::format(
      "{}: {} joints , {} corners , {} vertices , {} fitted , median {:.5f} , 99 of 100 {:.5f} , "
      "worst {:.5f}\n",
      title, fit.joints, fit.corners, fit.vertices, fit.fitted, fit.median, fit.percentile99, fit.worst);
  for (const gltf::AddedNode& node : edits.addedNodes) {
    text += fmt::format("  {} under {}", node.name, node.parent.value) +
            cornerPlaceText(node.rest.translation) + "\n";
  }
  Vec3 followed(0.0);
  for (const gltf::AddedSlot& slot : edits.addedSlots) {
    followed += Vec3(slot.inverseBind[3]) * (1.0 + 0.1 * slot.node.value + slot.skin);
  }
  text += fmt::format("  {} slots more ,", edits.addedSlots.size()) + cornerPlaceText(followed) + "\n";
  for (const gltf::BoundMesh& bound : edits.boundMeshes) {
    text += boundText(bound);
  }
  for (const gltf::ClipTracks& clip : edits.clips) {
    for (const Track& track : clip.tracks) {
      double sum = 0.0;
      for (std::size_t i = 0; i < track.values.size(); ++i) {
        sum += static_cast<double>(track.values[i]) * static_cast<double>(1 + i % 3);
      }
      text += fmt::format("  clip {} moves {} : {} keys , {:.3f}\n", clip.clip, track.node.value,
                          track.times.size(), sum);
    }
  }
  return text;
}

} // namespace

TEST_CASE("The corners of stretched limbs and what follows them are as they were looked at") {
  std::string text;
  Row row(6);
  SyntheticBiped body = namedBody({.fingers = false});
  body.tubes = true;
  MovingBiped tubes = still(body);
  addPunch(tubes, Interpolation::linear);
  SyntheticBiped rigidBody = namedBody({.fingers = false});
  rigidBody.withSkin = false;
  rigidBody.rigid = true;
  MovingBiped rigid = still(rigidBody);
  addPunch(rigid, Interpolation::linear);
  Trail longer = connectedTrail("left-arm", 0, 12, 2.0);
  longer.settings.volume = 0.0;
  const Trail keeping = connectedTrail("left-arm", 0, 12, 2.0);
  const Trail leg = connectedTrail("left-leg", 3, 12, 1.6);
  const Trail trunk = connectedTrail("spine", 6, 12, 1.5);
  for (const std::size_t most : {8, 4, 2}) {
    for (const std::uint32_t shared : {0U, 1U, 3U}) {
      const std::string title = fmt::format("at most {} , shared with {}", most, shared);
      text += cornersText(title + " , longer", tubes, {longer}, row, shared, most);
      text += cornersText(title + " , keeping its volume", tubes, {keeping}, row, shared, most);
      text += cornersText(title + " , leg and trunk", tubes, {leg, trunk}, row, shared, most);
    }
  }
  text += cornersText("rigid parts, longer", rigid, {longer}, row, 0, 8);
  text += cornersText("rigid parts", rigid, {keeping, leg}, row, 0, 4);
  text += cornersText("horse", pawingHorse(), {connectedTrail("front-left-leg", 0, 12, 2.0)}, row, 2, 4);
  const std::string difference = differenceFromRecord("corners", text, 5e-4);
  INFO(difference);
  CHECK(difference.empty());
}
