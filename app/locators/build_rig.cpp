#include "app/locators/build_rig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "app/edits/body/limb_edits.h"
#include "app/edits/pose/prop_file_edits.h"
#include "app/locators/fit_locators.h"
#include "core/anim/sampling.h"
#include "core/gltf/patch/added_skeleton.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/added_file.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/limb_assembly.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

// Nodes, and a skin that names them as joints: no mesh uses it yet.
gltf::Edits skeletonAt(const Scene& scene, const rig::Locators& locators) {
  const NodeIndex carrier = gltf::carrierOfSkeleton(scene, skinning::drawnMeshNodes(scene));
  const std::vector<gltf::SkeletonJoint> joints = jointsAt(locators);
  gltf::Edits edits;
  edits.addedNodes = gltf::skeletonNodes(scene, joints, carrier);
  gltf::AddedSkin skin;
  for (const Mat4& world : gltf::skeletonWorlds(scene, joints, carrier)) {
    skin.joints.emplace_back(scene.nodes.size() + skin.joints.size());
    skin.inverseBind.push_back(glm::inverse(world));
  }
  edits.addedSkins.push_back(std::move(skin));
  return edits;
}

Status checkUnrigged(const Document& document, const rig::Locators& locators) {
  if (const std::vector<std::string> missing = rig::missingLocators(locators); !missing.empty()) {
    return Error{fmt::format("there is no locator for {}", fmt::join(missing, ", ")), "", "set it by hand"};
  }
  if (document.body.isBiped) {
    return Error{"the character has a skeleton already", "", "locators correct its limbs; no joint is made"};
  }
  if (!jointsOfLocators(*document.scene, locators).empty()) {
    return Error{"the character has the joints of these locators already", "",
                 "bind with them: its joints go where locators were moved"};
  }
  if (!document.addedFiles.empty()) {
    return Error{"props from other files are added to it", "", "build the rig before props are added"};
  }
  return Success{};
}

// Joints that can be taken out again are the last nodes, in the order of the locators.
std::optional<std::size_t> firstBuiltNode(const Document& document) {
  const std::vector<rig::Locator>& list = document.locators.list;
  const std::vector<Node>& nodes = document.scene->nodes;
  if (list.empty() || nodes.size() < list.size()) {
    return std::nullopt;
  }
  const std::size_t first = nodes.size() - list.size();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (nodes[first + i].name != list[i].name) {
      return std::nullopt;
    }
  }
  return first;
}

bool isRigUsed(const Document& document, std::size_t first) {
  const Scene& scene = *document.scene;
  const bool isBound = std::ranges::any_of(scene.nodes, [&](const Node& node) {
    const auto& skins = scene.skins;
    return node.mesh >= 0 && node.skin >= 0 &&
           std::ranges::any_of(skins[at(node.skin)].joints,
                               [&](NodeIndex joint) { return at(joint) >= first; });
  });
  const bool isMoved = std::ranges::any_of(*document.clips, [&](const Clip& clip) {
    return std::ranges::any_of(clip.tracks, [&](const auto& track) { return at(track->node) >= first; });
  });
  return isBound || isMoved || !document.trails.empty() || !document.adjustments.empty() ||
         !document.holds.empty() || !document.weights.empty();
}

// The limbs that locators correct, with the locators of their base, middle and end.
struct CorrectedLimb {
  const char* id;
  std::array<const char*, 3> locators;
};

constexpr std::array correctedLimbs = std::to_array<CorrectedLimb>({
    {"left-arm", {"leftUpperArm", "leftLowerArm", "leftHand"}},
    {"right-arm", {"rightUpperArm", "rightLowerArm", "rightHand"}},
    {"left-leg", {"leftUpperLeg", "leftLowerLeg", "leftFoot"}},
    {"right-leg", {"rightUpperLeg", "rightLowerLeg", "rightFoot"}},
});

bool isMoved(const rig::Locators& before, const rig::Locators& after, const CorrectedLimb& limb,
             double height) {
  constexpr double least = 0.005; // of the height
  return std::ranges::any_of(limb.locators, [&](const char* name) {
    const rig::Locator* const from = rig::findLocator(before, name);
    const rig::Locator* const to = rig::findLocator(after, name);
    return from != nullptr && to != nullptr && glm::distance(from->position, to->position) > least * height;
  });
}

NodeIndex nearestJoint(const Scene& scene, const std::vector<Mat4>& worlds, const Vec3& place) {
  const std::set<NodeIndex> skinned = skinJoints(scene);
  NodeIndex nearest;
  double distance = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const NodeIndex node(i);
    const double away = glm::distance(positionOf(worlds[i]), place);
    if ((skinned.empty() || skinned.contains(node)) && !scene.nodes[i].isBindLeaf && away < distance) {
      nearest = node;
      distance = away;
    }
  }
  return nearest;
}

Result<Document> withLimbAt(const Document& document, const rig::Locators& locators,
                            const CorrectedLimb& corrected) {
  const Scene& scene = *document.scene;
  const std::vector<Mat4> worlds = rig::bindPoseWorlds(scene);
  std::vector<NodeIndex> nodes;
  for (const char* name : corrected.locators) {
    nodes.push_back(nearestJoint(scene, worlds, rig::findLocator(locators, name)->position));
    const bool isBelow = nodes.size() < 2 || (nodes.back() != nodes[nodes.size() - 2] &&
                                              isAncestorOrSelf(scene, nodes[nodes.size() - 2], nodes.back()));
    if (!isBelow) {
      return Error{fmt::format("the joint nearest to it, {}, does not hang on {}",
                               scene.nodes[at(nodes.back())].name,
                               scene.nodes[at(nodes[nodes.size() - 2])].name),
                   name, "move the locator to a joint of the limb"};
    }
  }
  const rig::Limb* const limb = findLimb(document, corrected.id);
  return correctLimb(document, rig::body::makeLimb(
                                   *limb, {nodes[0], nodes[1]},
                                   {.node = nodes[2], .position = positionOf(worlds[at(nodes[2])])}, worlds));
}

} // namespace

std::vector<gltf::SkeletonJoint> jointsAt(const rig::Locators& locators) {
  std::vector<gltf::SkeletonJoint> joints;
  std::map<std::string, int, std::less<>> places;
  for (const rig::Locator& locator : rig::inOrder(locators).list) {
    const std::string_view parent = rig::parentLocator(locators, locator.name);
    places[locator.name] = static_cast<int>(joints.size());
    joints.push_back({locator.name, parent.empty() ? -1 : places.find(parent)->second, locator.position,
                      locator.orientation});
  }
  return joints;
}

Result<Document> withRigAt(const Document& document, const rig::Locators& locators) {
  if (Status possible = checkUnrigged(document, locators); !possible) {
    return possible.error();
  }
  const Scene& scene = *document.scene;
  Result<gltf::Source> source = gltf::patched(*document.source, skeletonAt(scene, locators));
  if (!source) {
    return source.error();
  }
  Result<std::shared_ptr<const Scene>> rigged = gltf::sceneWith(*source, {});
  if (!rigged) {
    return rigged.error();
  }
  Document built = document;
  built.source = std::make_shared<const gltf::Source>(std::move(source).value());
  built.scene = std::move(rigged).value();
  built.locators = locators;
  built.body = bodyOfSource(built);
  return built;
}

namespace {

// The one joint of the name; none where there are several.
NodeIndex jointNamed(const Scene& scene, const std::set<NodeIndex>& joints, const std::string& name) {
  NodeIndex found;
  for (const NodeIndex joint : joints) {
    if (scene.nodes[at(joint)].name == name) {
      if (found.exists()) {
        return NodeIndex::none;
      }
      found = joint;
    }
  }
  return found;
}

// The nearest of the joints above a node.
NodeIndex jointAbove(const Scene& scene, const std::vector<NodeIndex>& joints, NodeIndex node) {
  do {
    node = scene.nodes[at(node)].parent;
  } while (node.exists() && std::ranges::find(joints, node) == joints.end());
  return node;
}

bool hangAsLocators(const Scene& scene, const rig::Locators& locators, const std::vector<NodeIndex>& joints) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string_view parent = rig::parentLocator(locators, locators.list[i].name);
    const NodeIndex above = jointAbove(scene, joints, joints[i]);
    const std::string name = above.exists() ? scene.nodes[at(above)].name : std::string();
    if (name != parent) {
      return false;
    }
  }
  return true;
}

// Of the way from the first to the farthest joint: what places may differ by and be the same.
constexpr double samePlace = 1e-4;

bool restInBindPose(const Scene& scene, const std::vector<NodeIndex>& joints) {
  const std::vector<Mat4> bind = rig::bindPoseWorlds(scene);
  const std::vector<Mat4> rest = worldMatrices(scene, restPose(scene));
  double size = 0.0;
  double apart = 0.0;
  for (const NodeIndex joint : joints) {
    size = std::max(size, glm::distance(positionOf(bind[at(joint)]), positionOf(bind[at(joints.front())])));
    apart = std::max(apart, glm::distance(positionOf(bind[at(joint)]), positionOf(rest[at(joint)])));
  }
  return apart <= samePlace * size;
}

} // namespace

std::vector<NodeIndex> jointsOfLocators(const Scene& scene, const rig::Locators& locators) {
  const std::set<NodeIndex> ofSkins = skinJoints(scene);
  std::vector<NodeIndex> joints;
  for (const rig::Locator& locator : locators.list) {
    joints.push_back(jointNamed(scene, ofSkins, locator.name));
    if (!joints.back().exists()) {
      return {};
    }
  }
  const bool areThose = hangAsLocators(scene, locators, joints) && restInBindPose(scene, joints);
  return areThose ? joints : std::vector<NodeIndex>();
}

bool isRigBuilt(const Document& document) {
  return !document.locators.empty() && !jointsOfLocators(*document.scene, document.locators).empty();
}

bool areLocatorsMoved(const Document& document) {
  constexpr double sameTurn = 1e-4; // radians, about
  const rig::Locators& locators = document.locators;
  const std::vector<NodeIndex> joints =
      locators.empty() ? std::vector<NodeIndex>() : jointsOfLocators(*document.scene, locators);
  const std::vector<Mat4> worlds =
      joints.empty() ? std::vector<Mat4>() : rig::bindPoseWorlds(*document.scene);
  double size = 0.0;
  double apart = 0.0;
  double turned = 0.0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const rig::Locator& locator = locators.list[i];
    const Mat4& world = worlds[at(joints[i])];
    const Quat turn = toTransform(world).rotation;
    size = std::max(size, glm::distance(locator.position, locators.list.front().position));
    apart = std::max(apart, glm::distance(locator.position, positionOf(world)));
    turned = std::max(turned, 1.0 - std::abs(glm::dot(turn, glm::normalize(locator.orientation))));
  }
  return apart > samePlace * size || turned > sameTurn * sameTurn;
}

Result<Document> withoutRig(const Document& document) {
  const std::optional<std::size_t> first = firstBuiltNode(document);
  if (!first) {
    return Error{"no rig was built from locators", "", "build it first"};
  }
  if (isRigUsed(document, *first)) {
    return Error{"something uses the rig: a bound mesh, a clip, trails, adjustments or holds", "",
                 "undo or delete that first"};
  }
  gltf::Source source = *document.source;
  gltf::takeOutSkeleton(*first, *source.json);
  Document back = document;
  Result<std::shared_ptr<const Scene>> scene = gltf::sceneWith(source, {});
  if (!scene) {
    return scene.error();
  }
  back.source = std::make_shared<const gltf::Source>(std::move(source));
  back.scene = std::move(scene).value();
  back.limbsCorrected = false;
  back.chains.clear();
  back.body = bodyOfSource(back);
  return back;
}

Result<Document> withLimbsAt(const Document& document, const rig::Locators& locators) {
  const Result<FittedLocators> found = fitLocators(document);
  if (!found) {
    return found.error();
  }
  Document corrected = document;
  for (const CorrectedLimb& limb : correctedLimbs) {
    if (findLimb(document, limb.id) == nullptr ||
        !isMoved(found->locators, locators, limb, document.body.height)) {
      continue;
    }
    Result<Document> next = withLimbAt(corrected, locators, limb);
    if (!next) {
      return next.error();
    }
    corrected = std::move(*next);
  }
  return corrected;
}

} // namespace stretch::app
