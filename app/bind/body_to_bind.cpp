#include "app/bind/body_to_bind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "app/locators/build_rig.h"
#include "core/anim/sampling.h"
#include "core/scene/morphs.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/evidence/name_evidence.h"
#include "rig/body/evidence/own_names.h"
#include "rig/body/reading/detection.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

bool holdsAnyMesh(const Scene& scene, NodeIndex node) {
  return scene.nodes[at(node)].mesh >= 0;
}

// The joints of the skins that meshes use; of all skins where none does.
std::set<NodeIndex> jointsOfSkins(const Scene& scene) {
  std::set<int> used;
  for (const NodeIndex node : skinning::drawnMeshNodes(scene)) {
    if (scene.nodes[at(node)].skin >= 0) {
      used.insert(scene.nodes[at(node)].skin);
    }
  }
  std::set<NodeIndex> joints;
  for (std::size_t skin = 0; skin < scene.skins.size(); ++skin) {
    if (used.empty() || used.contains(static_cast<int>(skin))) {
      joints.insert(scene.skins[skin].joints.begin(), scene.skins[skin].joints.end());
    }
  }
  return joints;
}

// A joint beyond the limbs that nothing hangs on but rigid meshes: it holds a prop.
bool isSocket(const Document& document, NodeIndex joint) {
  const Scene& scene = *document.scene;
  const rig::Body& biped = document.body;
  const std::vector<NodeIndex>& children = scene.nodes[at(joint)].children;
  return joint != biped.head && !isOfLimb(biped, joint) && !children.empty() &&
         std::ranges::all_of(children, [&](NodeIndex child) {
           return holdsAnyMesh(scene, child) && scene.nodes[at(child)].skin < 0;
         });
}

// Legs may hang beside the hips, and feet from the root: what a limb needs is the body's, wherever it hangs.
bool isOfBody(const Scene& scene, const rig::Body& body, NodeIndex joint) {
  const auto carries = [&](NodeIndex node) { return node.exists() && isAncestorOrSelf(scene, node, joint); };
  return carries(body.hips) || std::ranges::any_of(body.limbs, [&](const rig::Limb& limb) {
           return carries(limb.joints.front()) || carries(limb.endNode);
         });
}

// Handles for inverse kinematics stand where joints of limbs stand, and would take their weights. One that a
// limb hangs on is a joint, whatever it is called.
bool isHandle(const Document& document, const std::string& name, NodeIndex joint) {
  const Scene& scene = *document.scene;
  const bool carriesLimb = std::ranges::any_of(document.body.limbs, [&](const rig::Limb& limb) {
    return isAncestorOrSelf(scene, joint, limb.joints.front());
  });
  return rig::body::readName(name).control && !carriesLimb && !isOfLimb(document.body, joint);
}

std::set<NodeIndex> jointsToBind(const Document& document) {
  const Scene& scene = *document.scene;
  const std::set<NodeIndex> followed = followedJoints(scene);
  const NodeIndex hips = document.body.hips;
  std::set<NodeIndex> joints = jointsOfSkins(scene);
  if (joints.empty() && hips.exists()) {
    for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
      if (!holdsAnyMesh(scene, NodeIndex(node))) {
        joints.insert(NodeIndex(node));
      }
    }
  }
  const std::vector<std::string> names = rig::body::ownNames(scene);
  std::erase_if(joints, [&](NodeIndex joint) {
    return scene.nodes[at(joint)].isBindLeaf || isSocket(document, joint) ||
           isHandle(document, names[at(joint)], joint) ||
           (hips.exists() && !isOfBody(scene, document.body, joint) &&
            (!followed.contains(joint) || isAncestorOrSelf(scene, joint, hips)));
  });
  return joints;
}

Mat4 toWorldOf(const Scene& scene, const rig::body::BindPose& pose, const std::vector<Mat4>& rest,
               NodeIndex node) {
  const int skin = scene.nodes[at(node)].skin;
  return skin >= 0 ? pose.placements[at(skin)] : rest[at(node)];
}

void addPrimitive(const Scene& scene, NodeIndex node, const Primitive& primitive, const Mat4& toWorld,
                  BodyToBind& body) {
  const Node& holder = scene.nodes[at(node)];
  const Mesh& mesh = scene.meshes[at(holder.mesh)];
  const auto first = static_cast<std::uint32_t>(body.positions.size());
  for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
    body.positions.emplace_back(
        transformPoint(toWorld, morphedPlace(mesh, primitive, holder.morphWeights, v)));
  }
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    body.triangles.push_back(
        {first + primitive.indices[i], first + primitive.indices[i + 1], first + primitive.indices[i + 2]});
  }
}

// Where a joint stands in the bind pose. Exporters leave matrices of joints that nothing follows unset: one
// that would lie far from where it lies at rest, as seen from the joint above, stands as at rest.
Mat4 bindWorld(const Mat4& bind, const Mat4& atRest, const Vec3& parent, double height) {
  constexpr double times = 3.0;
  constexpr double partOfHeight = 0.1;
  const double most = times * glm::distance(positionOf(atRest), parent) + partOfHeight * height;
  return glm::distance(positionOf(bind), parent) > most ? atRest : bind;
}

bool hangsOn(const std::vector<skinning::BindJoint>& joints, int joint, int carrier) {
  while (joint >= 0 && joint != carrier) {
    joint = joints[at(joint)].parent;
  }
  return joint >= 0;
}

// A foot that hangs on the root, apart from the shin, is bound as the end of its leg.
void joinLimbs(const std::vector<rig::Limb>& limbs, const std::map<NodeIndex, int>& places,
               std::vector<skinning::BindJoint>& joints) {
  for (const rig::Limb& limb : limbs) {
    std::vector<NodeIndex> chain = limb.joints;
    chain.push_back(limb.endNode);
    int above = -1;
    for (const NodeIndex node : chain) {
      const auto found = places.find(node);
      if (found == places.end()) {
        continue;
      }
      const int joint = found->second;
      if (above >= 0 && !hangsOn(joints, joint, above) && !hangsOn(joints, above, joint)) {
        joints[at(joint)].parent = above;
      }
      above = joint;
    }
  }
}

// A joint whose joints above are all controls hangs on the joint that stands where the lowest of them stands:
// rigs keep a copy of the skeleton to deform by. Of several there, on one that others hang on. What carries
// the hips hangs on nothing.
void hangOnCopies(const Document& document, const std::vector<Mat4>& worlds, SkeletonToBind& skeleton) {
  const Scene& scene = *document.scene;
  const double same = 1e-3 * document.body.height;
  if (!document.body.hips.exists()) {
    return; // joints of a mesh that is no body stand where they were fitted
  }
  std::vector<bool> carries(skeleton.joints.size(), false);
  for (const skinning::BindJoint& joint : skeleton.joints) {
    if (joint.parent >= 0) {
      carries[at(joint.parent)] = true;
    }
  }
  for (std::size_t i = 0; i < skeleton.joints.size(); ++i) {
    skinning::BindJoint& joint = skeleton.joints[i];
    if (isAncestorOrSelf(scene, skeleton.nodes[i], document.body.hips)) {
      continue;
    }
    for (NodeIndex above = scene.nodes[at(skeleton.nodes[i])].parent; joint.parent < 0 && above.exists();
         above = scene.nodes[at(above)].parent) {
      for (std::size_t other = 0; other < skeleton.joints.size(); ++other) {
        const bool stands = glm::distance(skeleton.joints[other].place, positionOf(worlds[at(above)])) < same;
        if (stands && !hangsOn(skeleton.joints, static_cast<int>(other), static_cast<int>(i)) &&
            (joint.parent < 0 || (carries[other] && !carries[at(joint.parent)]))) {
          joint.parent = static_cast<int>(other);
        }
      }
    }
  }
}

// The local axis that most bones run along to the only joint that hangs on them; none where they do not
// agree.
std::optional<Vec3> axisOfBones(const SkeletonToBind& skeleton) {
  std::vector<int> children(skeleton.joints.size(), 0);
  for (const skinning::BindJoint& joint : skeleton.joints) {
    if (joint.parent >= 0) {
      ++children[at(joint.parent)];
    }
  }
  std::array<int, 6> votes{}; // by axis, forwards and backwards
  int voters = 0;
  for (const skinning::BindJoint& joint : skeleton.joints) {
    if (joint.parent < 0 || children[at(joint.parent)] != 1) {
      continue;
    }
    constexpr double leastCosine = 0.95;
    const Vec3 way = joint.place - skeleton.joints[at(joint.parent)].place;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      const double along = glm::dot(way, Vec3(skeleton.worlds[at(joint.parent)][axis]));
      const double whole = glm::length(way) * glm::length(Vec3(skeleton.worlds[at(joint.parent)][axis]));
      votes[2 * axis] += along > leastCosine * whole ? 1 : 0;
      votes[2 * axis + 1] += along < -leastCosine * whole ? 1 : 0;
    }
    ++voters;
  }
  constexpr int fewest = 4;
  constexpr double most = 0.7; // of those that have a say
  const auto best = std::ranges::max_element(votes) - votes.begin();
  if (voters < fewest || votes[static_cast<std::size_t>(best)] < most * voters) {
    return {};
  }
  Vec3 axis(0.0);
  axis[static_cast<glm::length_t>(best / 2)] = best % 2 == 0 ? 1.0 : -1.0;
  return axis;
}

// 1 where a joint's bone runs along its axis, -1 where it runs the other way, as those of one side do where
// they are the mirror image of the other side's. A joint that several hang on, or none, goes by that above
// it.
double signOf(const std::vector<skinning::BindJoint>& joints, const std::vector<int>& onlyChild,
              std::size_t joint) {
  constexpr double aligned = 0.9; // cosine
  int above = static_cast<int>(joint);
  for (std::size_t steps = 0; above >= 0 && steps < joints.size(); ++steps) {
    const skinning::BindJoint& bone = joints[at(above)];
    const Vec3 way =
        onlyChild[at(above)] < 0 ? Vec3(0.0) : joints[at(onlyChild[at(above)])].place - bone.place;
    const double along = glm::dot(way, bone.forward);
    if (std::abs(along) > aligned * glm::length(way)) {
      return along > 0.0 ? 1.0 : -1.0;
    }
    above = bone.parent;
  }
  return 1.0;
}

// Exporters whose bones run along an axis of their own say so where the next joint does not.
void addDirections(SkeletonToBind& skeleton) {
  const std::optional<Vec3> axis = axisOfBones(skeleton);
  if (!axis) {
    return;
  }
  std::vector<skinning::BindJoint>& joints = skeleton.joints;
  std::vector<int> onlyChild(joints.size(), -1);
  std::vector<int> children(joints.size(), 0);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Vec3 along = Mat3(skeleton.worlds[i]) * *axis;
    const double length = glm::length(along);
    joints[i].forward = length > 0.0 ? along / length : Vec3(0.0);
    if (const int parent = joints[i].parent; parent >= 0) {
      ++children[at(parent)];
      onlyChild[at(parent)] = children[at(parent)] == 1 ? static_cast<int>(i) : -1;
    }
  }
  const std::vector<skinning::BindJoint> alongAxis = joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    joints[i].forward *= signOf(alongAxis, onlyChild, i);
  }
}

} // namespace

bool isOfLimb(const rig::Body& body, NodeIndex joint) {
  return std::ranges::any_of(body.limbs, [&](const rig::Limb& limb) {
    return limb.endNode == joint || std::ranges::find(limb.joints, joint) != limb.joints.end();
  });
}

std::set<NodeIndex> followedJoints(const Scene& scene) {
  std::set<NodeIndex> followed;
  for (const NodeIndex node : skinning::drawnMeshNodes(scene)) {
    if (scene.nodes[at(node)].skin < 0) {
      continue;
    }
    const Skin& skin = scene.skins[at(scene.nodes[at(node)].skin)];
    for (const Primitive& primitive : scene.meshes[at(scene.nodes[at(node)].mesh)].primitives) {
      for (const VertexInfluences& vertex : primitive.influences) {
        for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
          if (vertex.weights[i] > 0.0F && vertex.joints[i] < skin.joints.size()) {
            followed.insert(skin.joints[vertex.joints[i]]);
          }
        }
      }
    }
  }
  return followed;
}

SkeletonToBind ownSkeleton(const Document& document) {
  const Scene& scene = *document.scene;
  const std::set<NodeIndex> wanted = jointsToBind(document);
  const std::vector<Mat4> worlds = rig::bindPoseWorlds(scene);
  const std::vector<Mat4> rest = worldMatrices(scene, restPose(scene));
  SkeletonToBind skeleton;
  std::map<NodeIndex, int> places;
  for (const NodeIndex node : parentsFirst(scene)) {
    if (!wanted.contains(node)) {
      continue;
    }
    NodeIndex parent = scene.nodes[at(node)].parent;
    while (parent.exists() && !places.contains(parent)) {
      parent = scene.nodes[at(parent)].parent;
    }
    places[node] = static_cast<int>(skeleton.nodes.size());
    Mat4 world = worlds[at(node)];
    if (parent.exists()) {
      const Mat4& above = skeleton.worlds[at(places[parent])];
      world = bindWorld(world, above * glm::inverse(rest[at(parent)]) * rest[at(node)], positionOf(above),
                        document.body.height);
    }
    skeleton.nodes.push_back(node);
    skeleton.worlds.push_back(world);
    skeleton.joints.push_back({positionOf(world), parent.exists() ? places[parent] : -1});
  }
  joinLimbs(document.body.limbs, places, skeleton.joints);
  hangOnCopies(document, worlds, skeleton);
  addDirections(skeleton);
  return skeleton;
}

SkeletonToBind skeletonOf(const rig::Locators& locators, const Scene& scene,
                          const std::vector<NodeIndex>& meshes) {
  const std::vector<gltf::SkeletonJoint> joints = jointsAt(locators);
  const NodeIndex carrier = gltf::carrierOfSkeleton(scene, meshes);
  SkeletonToBind skeleton;
  skeleton.added = gltf::skeletonNodes(scene, joints, carrier);
  skeleton.worlds = gltf::skeletonWorlds(scene, joints, carrier);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    skeleton.nodes.emplace_back(scene.nodes.size() + i);
    skeleton.joints.push_back({joints[i].place, joints[i].parent});
  }
  return skeleton;
}

std::vector<NodeIndex> meshNodesToBind(const Scene& scene, const std::vector<NodeIndex>& joints) {
  const auto isCarried = [&](NodeIndex node) {
    return std::ranges::any_of(joints, [&](NodeIndex joint) {
      return at(joint) < scene.nodes.size() && isAncestorOrSelf(scene, joint, node);
    });
  };
  std::vector<NodeIndex> nodes;
  for (const NodeIndex node : skinning::drawnMeshNodes(scene)) {
    if (!scene.meshes[at(scene.nodes[at(node)].mesh)].primitives.empty() &&
        (scene.nodes[at(node)].skin >= 0 || !isCarried(node))) {
      nodes.push_back(node);
    }
  }
  return nodes;
}

BodyToBind bodyToBind(const Scene& scene, const std::vector<NodeIndex>& nodes) {
  const rig::body::BindPose pose = rig::body::placeBindPose(scene);
  const std::vector<Mat4> rest = worldMatrices(scene, restPose(scene));
  BodyToBind body;
  for (const NodeIndex node : nodes) {
    const Mat4 toWorld = toWorldOf(scene, pose, rest, node);
    body.meshes.push_back({node, scene.nodes[at(node)].skin, toWorld, body.positions.size()});
    for (const Primitive& primitive : scene.meshes[at(scene.nodes[at(node)].mesh)].primitives) {
      addPrimitive(scene, node, primitive, toWorld, body);
    }
  }
  return body;
}

} // namespace stretch::app
