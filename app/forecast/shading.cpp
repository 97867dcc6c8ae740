#include "app/forecast/shading.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "core/math/rotation.h"
#include "rig/motion/evaluate.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

constexpr double wrongDegrees = 20.0;
constexpr double mostVertices = 2e7; // looked at in one clip

// Corners move without scaling: normals turn with the joint alone.
void forgetCorners(const Scene& scene, FrameState& frame) {
  for (const BindChain& chain : scene.bindChains) {
    if (!chain.corners.empty()) {
      frame.stretch[at(chain.joint)] = Mat3(1.0);
    }
  }
}

struct WrongShading {
  std::vector<std::size_t> vertices;
  std::size_t moved = 0;
  double worstDegrees = 0.0;
};

WrongShading wrongShadingOf(const Scene& scene, FrameState frame, const std::vector<Vec3>& places,
                            const std::vector<Vec3>& atRest, double height) {
  constexpr double still = 1e-4; // of the height
  forgetCorners(scene, frame);
  const std::vector<Vec3> exact = skinning::skinnedNormals(scene, frame);
  const std::vector<Vec3> plain = skinning::skinnedNormals(scene, frame, skinning::NormalMatrix::plain);
  WrongShading wrong;
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (glm::length(places[v] - atRest[v]) <= still * height) {
      continue;
    }
    ++wrong.moved;
    const double degrees = angleBetween(exact[v], plain[v]) * 180.0 / pi;
    wrong.worstDegrees = std::max(wrong.worstDegrees, degrees);
    if (degrees > wrongDegrees) {
      wrong.vertices.push_back(v);
    }
  }
  return wrong;
}

std::string mostFrequentLimb(const Document& document, const std::vector<std::size_t>& vertices) {
  constexpr std::size_t mostAsked = 200; // each is found by counting through the meshes
  std::map<std::string, std::size_t> counts;
  const std::size_t step = std::max<std::size_t>(1, vertices.size() / mostAsked);
  for (std::size_t i = 0; i < vertices.size(); i += step) {
    ++counts[limbOfNode(document, skinning::strongestNode(*document.scene, vertices[i]))];
  }
  const auto most = std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; });
  return most == counts.end() ? std::string() : most->first;
}

} // namespace

std::string limbOfNode(const Document& document, NodeIndex node) {
  const Scene& scene = *document.scene;
  for (NodeIndex above = node; above.exists(); above = scene.nodes[at(above)].parent) {
    for (const rig::Limb& limb : document.body.limbs) {
      if (limb.endNode == above || std::ranges::find(limb.joints, above) != limb.joints.end()) {
        return limb.id;
      }
    }
  }
  return {};
}

Bounds restBox(const Document& document) {
  Bounds box;
  const FrameState rest = frameOf(*document.scene, restPose(*document.scene), 0.0);
  for (const Vec3& place : skinning::skinnedPositions(*document.scene, rest)) {
    box.add(place);
  }
  return box;
}

ClipLooks clipLooks(const Document& document, int clipIndex) {
  const Scene& scene = *document.scene;
  const Clip& clip = clipOf(document, clipIndex);
  const std::vector<Vec3> atRest =
      skinning::skinnedPositions(scene, frameOf(scene, restPose(scene), 0.0));
  const double most = std::max(2.0, mostVertices / std::max(1.0, static_cast<double>(atRest.size())));
  const double step = std::max(1.0, std::ceil(lastFrame(clip) / most));
  ClipLooks looks{.clip = clipIndex};
  std::vector<std::size_t> wrongVertices;
  for (double frame = 0.0; frame <= lastFrame(clip); frame += step) {
    const FrameState state = rig::sampledFrame(scene, clip, frame / clip.framesPerSecond);
    const std::vector<Vec3> places = skinning::skinnedPositions(scene, state);
    std::ranges::for_each(places, [&](const Vec3& place) { looks.box.add(place); });
    WrongShading wrong = wrongShadingOf(scene, state, places, atRest, document.body.height);
    looks.worstDegrees = std::max(looks.worstDegrees, wrong.worstDegrees);
    if (wrong.vertices.size() > looks.wronglyShaded || frame <= 0.0) {
      looks.wronglyShaded = wrong.vertices.size();
      looks.moved = wrong.moved;
      looks.frame = frame;
      wrongVertices = std::move(wrong.vertices);
    }
  }
  looks.limb = mostFrequentLimb(document, wrongVertices);
  return looks;
}

} // namespace stretch::app
