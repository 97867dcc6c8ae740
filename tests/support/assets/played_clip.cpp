#include "tests/support/assets/played_clip.h"

#include <algorithm>
#include <array>

#include <catch2/catch.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "tests/support/assets/dummy_fixture.h"

namespace stretch::assets {

namespace {

/// A segment of the body between two joints, and its share of the mass.
struct Segment {
  const char* from;
  const char* to;
  double share;
};

constexpr std::array<Segment, 11> segments{{{"Hips", "Spine2", 0.30},
                                            {"Spine2", "Neck", 0.20},
                                            {"Neck", "Head", 0.08},
                                            {"LeftArm", "LeftForeArm", 0.028},
                                            {"LeftForeArm", "LeftHand", 0.022},
                                            {"RightArm", "RightForeArm", 0.028},
                                            {"RightForeArm", "RightHand", 0.022},
                                            {"LeftUpLeg", "LeftLeg", 0.10},
                                            {"LeftLeg", "LeftFoot", 0.06},
                                            {"RightUpLeg", "RightLeg", 0.10},
                                            {"RightLeg", "RightFoot", 0.06}}};

bool isArm(const std::string& joint) {
  return joint.find("Arm") != std::string::npos || joint.find("Hand") != std::string::npos ||
         joint.find("Shoulder") != std::string::npos;
}

double distanceToRod(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double length = glm::dot(along, along);
  const double share = length > 0.0 ? std::clamp(glm::dot(point - from, along) / length, 0.0, 1.0) : 0.0;
  return glm::length(point - (from + share * along));
}

} // namespace

PlayedClip::PlayedClip(const std::string& name) {
  Result<gltf::Loaded> loaded = gltf::load(bundledPath(name));
  REQUIRE(loaded.ok());
  REQUIRE(loaded->warnings.empty());
  loaded_ = std::move(loaded).value();
}

int PlayedClip::lastFrame() const {
  return static_cast<int>(frameCount(clip())) - 1;
}

std::vector<Mat4> PlayedClip::worlds(double frame) const {
  return worldMatrices(scene(), samplePose(scene(), clip(), frame / clip().framesPerSecond));
}

Vec3 PlayedClip::at(const std::string& node, double frame, const Vec3& point) const {
  return Vec3(worlds(frame)[stretch::at(nodeNamed(scene(), node))] * Vec4(point, 1.0));
}

Vec3 PlayedClip::centreOfMass(double frame) const {
  Vec3 sum(0.0);
  for (const Segment& segment : segments) {
    sum += 0.5 * segment.share * (at(segment.from, frame) + at(segment.to, frame));
  }
  return sum;
}

std::vector<Vec3> PlayedClip::vertices(double frame, Skinned which) const {
  const std::vector<Mat4> posed = worlds(frame);
  const Skin& skin = scene().skins[0];
  std::vector<Mat4> matrices;
  for (std::size_t joint = 0; joint < skin.joints.size(); ++joint) {
    matrices.push_back(posed[stretch::at(skin.joints[joint])] * skin.inverseBind[joint]);
  }
  std::vector<Vec3> skinned;
  for (const Primitive& primitive : scene().meshes[0].primitives) {
    for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
      const VertexInfluences& influences = primitive.influences[v];
      const NodeIndex heaviest = skin.joints[influences.joints[0]];
      if (which == Skinned::withoutArms && isArm(scene().nodes[stretch::at(heaviest)].name)) {
        continue;
      }
      Vec3 position(0.0);
      for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
        position += static_cast<double>(influences.weights[i]) *
                    Vec3(matrices[influences.joints[i]] * Vec4(Vec3(primitive.positions[v]), 1.0));
      }
      skinned.push_back(position);
    }
  }
  return skinned;
}

Vec3 PlayedClip::lowest(double frame) const {
  const std::vector<Vec3> skinned = vertices(frame, Skinned::all);
  return *std::min_element(skinned.begin(), skinned.end(),
                           [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
}

double PlayedClip::depthInBox(double frame, const Vec3& low, const Vec3& high) const {
  double deepest = 0.0;
  for (const Vec3& vertex : vertices(frame, Skinned::all)) {
    const Vec3 inside = glm::min(vertex - low, high - vertex);
    deepest = std::max(deepest, std::min({inside.x, inside.y, inside.z}));
  }
  return deepest;
}

double PlayedClip::depthInBody(double frame, const Vec3& from, const Vec3& to, double radius) const {
  double deepest = 0.0;
  for (const Vec3& vertex : vertices(frame, Skinned::withoutArms)) {
    deepest = std::max(deepest, radius - distanceToRod(vertex, from, to));
  }
  return deepest;
}

Vec3 gloveMiddle(bool isLeft) {
  return {isLeft ? 0.083 : -0.083, -0.073, 0.028};
}

} // namespace stretch::assets
