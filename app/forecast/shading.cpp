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

struct WrongShading {
  std::vector<std::size_t> vertices;
  std::size_t moved = 0;
  double worstDegrees = 0.0;
};

bool scalesUnequally(const Mat3& matrix) {
  constexpr double seen = 0.02;
  const Mat3 products = glm::transpose(matrix) * matrix;
  const double mean = (products[0][0] + products[1][1] + products[2][2]) / 3.0;
  double most = 0.0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      most = std::max(most, std::abs(products[column][row] - (row == column ? mean : 0.0)));
    }
  }
  return most > seen * mean;
}

// Whether each node's mesh is on a joint that scales unequally, or below the joint of one.
std::vector<bool> stretchedNodes(const Scene& scene, const FrameState& frame) {
  std::vector<bool> stretched(scene.nodes.size(), false);
  for (const Skin& skin : scene.skins) {
    const std::vector<Mat4> matrices = skinMatrices(skin, frame);
    for (std::size_t slot = 0; slot < matrices.size(); ++slot) {
      stretched[at(skin.joints[slot])] =
          stretched[at(skin.joints[slot])] || scalesUnequally(Mat3(matrices[slot]));
    }
  }
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    stretched[at(node)] = stretched[at(node)] || (parent.exists() && stretched[at(parent)]);
  }
  return stretched;
}

// One for each drawn vertex, in their order: whether it follows a stretched node, by normals of the file.
std::vector<bool> movedVertices(const Scene& scene, const std::vector<bool>& stretched) {
  std::vector<bool> moved;
  for (const NodeIndex node : skinning::drawnMeshNodes(scene)) {
    const Node& holder = scene.nodes[at(node)];
    for (const Primitive& primitive : scene.meshes[at(holder.mesh)].primitives) {
      for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
        bool follows = false;
        for (std::size_t i = 0; holder.skin >= 0 && primitive.hasNormals && !primitive.influences.empty() &&
                                i < VertexInfluences::capacity;
             ++i) {
          const VertexInfluences& vertex = primitive.influences[v];
          const std::vector<NodeIndex>& joints = scene.skins[at(holder.skin)].joints;
          follows = follows || (vertex.weights[i] > 0.0F && vertex.joints[i] < joints.size() &&
                                stretched[at(joints[vertex.joints[i]])]);
        }
        moved.push_back(follows);
      }
    }
  }
  return moved;
}

WrongShading wrongShadingOf(const Scene& scene, const FrameState& shown) {
  const FrameState frame = skinning::turningFrame(scene, shown);
  const std::vector<bool> stretched = stretchedNodes(scene, frame);
  if (std::ranges::find(stretched, true) == stretched.end()) {
    return {};
  }
  const std::vector<bool> moved = movedVertices(scene, stretched);
  const std::vector<Vec3> exact = skinning::skinnedNormals(scene, frame);
  const std::vector<Vec3> plain = skinning::skinnedNormals(scene, frame, skinning::NormalMatrix::plain);
  WrongShading wrong;
  for (std::size_t v = 0; v < moved.size(); ++v) {
    if (!moved[v]) {
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
  constexpr std::size_t mostAsked = 200;
  std::map<std::string, std::size_t> counts;
  const std::vector<NodeIndex> nodes = skinning::strongestNodes(*document.scene);
  const std::size_t step = std::max<std::size_t>(1, vertices.size() / mostAsked);
  for (std::size_t i = 0; i < vertices.size(); i += step) {
    ++counts[limbOfNode(document, nodes[vertices[i]])];
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
  const double most = std::max(2.0, mostVertices / std::max(1.0, static_cast<double>(vertexCount(scene))));
  const double step = std::max(1.0, std::ceil(lastFrame(clip) / most));
  ClipLooks looks{.clip = clipIndex};
  std::vector<std::size_t> wrongVertices;
  for (double frame = 0.0; frame <= lastFrame(clip); frame += step) {
    const FrameState state = rig::sampledFrame(scene, clip, frame / clip.framesPerSecond);
    const std::vector<Vec3> places = skinning::skinnedPositions(scene, state);
    std::ranges::for_each(places, [&](const Vec3& place) { looks.box.add(place); });
    WrongShading wrong = wrongShadingOf(scene, state);
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
