#include "app/bind/bind_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "app/bind/body_to_bind.h"
#include "app/bind/held_pieces.h"
#include "app/edits/body/limb_edits.h"
#include "app/locators/build_rig.h"
#include "app/named.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/added_file.h"
#include "skinning/bind/bind_weights.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

// The slots of a skin by the joints of a skeleton: of the joint itself, else of the nearest one above it that
// the skin has, else the first.
std::vector<std::uint16_t> slotsOf(const Scene& scene, const Skin& skin, const SkeletonToBind& skeleton) {
  std::map<NodeIndex, std::uint16_t> bySkin;
  for (std::size_t slot = 0; slot < skin.joints.size(); ++slot) {
    bySkin.try_emplace(skin.joints[slot], static_cast<std::uint16_t>(slot));
  }
  std::vector<std::uint16_t> slots;
  for (NodeIndex node : skeleton.nodes) {
    while (node.exists() && !bySkin.contains(node)) {
      node = scene.nodes[at(node)].parent;
    }
    slots.push_back(node.exists() ? bySkin[node] : std::uint16_t{0});
  }
  return slots;
}

VertexInfluences inSlots(const skinning::Influences& row, const std::vector<std::uint16_t>& slots) {
  VertexInfluences vertex;
  std::size_t count = 0;
  for (std::size_t i = 0; i < skinning::Influences::capacity && row.weights[i] > 0.0F; ++i) {
    const std::uint16_t slot = slots.empty() ? row.bones[i] : slots[row.bones[i]];
    const std::span<const std::uint16_t> known = std::span(vertex.joints).first(count);
    const auto place = static_cast<std::size_t>(std::ranges::find(known, slot) - known.begin());
    vertex.weights[place] += row.weights[i];
    if (place == count) {
      vertex.joints[count++] = slot;
    }
  }
  return vertex;
}

bool isSame(const Mat4& a, const Mat4& b) {
  constexpr double rounding = 1e-4;
  double largest = 0.0;
  double difference = 0.0;
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      largest = std::max(largest, std::abs(a[column][row]));
      difference = std::max(difference, std::abs(a[column][row] - b[column][row]));
    }
  }
  return difference <= rounding * largest;
}

class Binding {
public:
  Binding(const Scene& scene, const SkeletonToBind& skeleton, const BodyToBind& body,
          const std::vector<skinning::Influences>& rows)
      : scene_(scene), skeleton_(skeleton), body_(body), rows_(rows) {}

  gltf::Edits edits(gltf::Edits edits) {
    edits.addedNodes = skeleton_.added;
    for (const MeshToBind& mesh : body_.meshes) {
      const bool hasSkin = mesh.skin >= 0;
      const std::vector<std::uint16_t> slots =
          hasSkin ? slotsOf(scene_, scene_.skins[at(mesh.skin)], skeleton_) : std::vector<std::uint16_t>();
      edits.boundMeshes.push_back({mesh.node, hasSkin ? mesh.skin : skinFor(mesh.toWorld, edits.addedSkins),
                                   influences(mesh, slots)});
      if (hasSkin) {
        mendMatrices(mesh, edits);
      }
    }
    return edits;
  }

private:
  // Meshes that stand alike share a skin.
  int skinFor(const Mat4& toWorld, std::vector<gltf::AddedSkin>& skins) {
    const auto known = std::ranges::find(placements_, toWorld);
    if (known == placements_.end()) {
      gltf::AddedSkin skin;
      skin.joints = skeleton_.nodes;
      for (const Mat4& joint : skeleton_.worlds) {
        skin.inverseBind.push_back(glm::inverse(joint) * toWorld);
      }
      skins.push_back(std::move(skin));
      placements_.push_back(toWorld);
      return static_cast<int>(scene_.skins.size() + skins.size()) - 1;
    }
    return static_cast<int>(scene_.skins.size()) + static_cast<int>(known - placements_.begin());
  }

  // Exporters leave matrices of joints that nothing follows unset: those that are followed now say where the
  // joint was taken to stand.
  void mendMatrices(const MeshToBind& mesh, gltf::Edits& edits) const {
    const Skin& skin = scene_.skins[at(mesh.skin)];
    std::set<std::uint16_t> followed;
    for (const std::vector<VertexInfluences>& vertices : edits.boundMeshes.back().influences) {
      for (const VertexInfluences& vertex : vertices) {
        followed.insert(vertex.joints.begin(), vertex.joints.end());
      }
    }
    for (std::size_t i = 0; i < skeleton_.nodes.size(); ++i) {
      const auto slot =
          static_cast<std::size_t>(std::ranges::find(skin.joints, skeleton_.nodes[i]) - skin.joints.begin());
      const Mat4 wanted = glm::inverse(skeleton_.worlds[i]) * mesh.toWorld;
      const bool isMended = std::ranges::any_of(edits.skinSlots, [&](const gltf::SkinSlot& known) {
        return known.skin == mesh.skin && known.slot == static_cast<int>(slot);
      });
      if (slot < skin.joints.size() && !isMended && followed.contains(static_cast<std::uint16_t>(slot)) &&
          !isSame(wanted, skin.inverseBind[slot])) {
        edits.skinSlots.push_back({mesh.skin, static_cast<int>(slot), skeleton_.nodes[i], wanted});
      }
    }
  }

  [[nodiscard]] std::vector<std::vector<VertexInfluences>>
  influences(const MeshToBind& mesh, const std::vector<std::uint16_t>& slots) const {
    std::vector<std::vector<VertexInfluences>> ofPrimitives;
    std::size_t next = mesh.firstVertex;
    for (const Primitive& primitive : scene_.meshes[at(scene_.nodes[at(mesh.node)].mesh)].primitives) {
      std::vector<VertexInfluences>& vertices = ofPrimitives.emplace_back();
      for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
        vertices.push_back(inSlots(rows_[next++], slots));
      }
    }
    return ofPrimitives;
  }

  const Scene& scene_;
  const SkeletonToBind& skeleton_;
  const BodyToBind& body_;
  const std::vector<skinning::Influences>& rows_;
  std::vector<Mat4> placements_;
};

// A bound mesh no longer follows its own node: motion of that node is told.
std::vector<std::string> lostMotion(const Document& document, const BodyToBind& body,
                                    const std::vector<gltf::AddedNode>& added) {
  const Scene& scene = *document.scene;
  std::vector<std::string> warnings;
  for (const MeshToBind& mesh : body.meshes) {
    const NodeIndex carrier = added.empty() ? NodeIndex::none : added.front().parent;
    for (NodeIndex node = mesh.skin >= 0 ? NodeIndex::none : mesh.node; node.exists() && node != carrier;
         node = scene.nodes[at(node)].parent) {
      const bool isMoved = std::ranges::any_of(*document.clips, [&](const Clip& clip) {
        return std::ranges::any_of(clip.tracks, [&](const auto& track) {
          return track->node == node && track->channel != Channel::weights;
        });
      });
      if (isMoved) {
        warnings.push_back(fmt::format("{} is moved by a clip, which no longer moves its mesh {}",
                                       nodeTitle(document, node), nodeTitle(document, mesh.node)));
      }
    }
  }
  return warnings;
}

// Joints of limbs that no vertex follows; where the file has weights, those that vertices followed before.
std::vector<std::string> idleJoints(const Document& document, const SkeletonToBind& skeleton,
                                    const std::vector<skinning::Influences>& rows) {
  std::set<NodeIndex> followed;
  for (const skinning::Influences& row : rows) {
    for (std::size_t i = 0; i < skinning::Influences::capacity && row.weights[i] > 0.0F; ++i) {
      followed.insert(skeleton.nodes[row.bones[i]]);
    }
  }
  const std::set<NodeIndex> before = followedJoints(*document.scene);
  std::vector<std::string> warnings;
  for (const rig::Limb& limb : document.body.limbs) {
    for (const NodeIndex node : rig::jointsAndEnd(limb)) {
      const bool isNeeded = before.contains(node) || (before.empty() && node != limb.endNode);
      if (isNeeded && followed.insert(node).second) { // a joint of two limbs is told once
        warnings.push_back(
            fmt::format("no vertex follows \"{}\" of the {}: no part of the mesh is nearest to its bone",
                        nodeTitle(document, node), limb.id));
      }
    }
  }
  return warnings;
}

Result<std::vector<NodeIndex>> unboundMeshes(const Document& document) {
  std::vector<NodeIndex> nodes = meshNodesToBind(*document.scene, {});
  for (const NodeIndex node : nodes) {
    if (document.scene->nodes[at(node)].skin >= 0) {
      return Error{fmt::format("its mesh {} is bound to a skeleton already", nodeTitle(document, node)), "",
                   "bind it again at the file's own joints (--keep-joints)"};
    }
  }
  return nodes;
}

Status checkRequest(const Document& document, const BindRequest& request) {
  if (!document.addedFiles.empty()) {
    return Error{"props from other files are added to it", "", "bind the mesh before props are added"};
  }
  const std::vector<std::string> missing =
      request.locators ? rig::missingLocators(*request.locators) : std::vector<std::string>();
  if (!missing.empty()) {
    return Error{fmt::format("there is no locator for {}", missing.front()), "", "set it by hand"};
  }
  return Success{};
}

} // namespace

namespace {

struct JointsAndMeshes {
  SkeletonToBind skeleton;
  std::vector<NodeIndex> meshes;
  std::vector<JointMove> moves;
};

Result<JointsAndMeshes> jointsAndMeshes(const Document& document, const BindRequest& request) {
  const Scene& scene = *document.scene;
  JointsAndMeshes made;
  const bool areThere = request.locators && !jointsOfLocators(scene, *request.locators).empty();
  if (!request.locators || areThere) {
    made.skeleton = ownSkeleton(document);
    made.meshes = meshNodesToBind(scene, made.skeleton.nodes);
    made.moves = areThere ? movesTo(scene, *request.locators) : std::vector<JointMove>();
    made.skeleton = moved(std::move(made.skeleton), made.moves);
    return made;
  }
  Result<std::vector<NodeIndex>> unbound = unboundMeshes(document);
  if (!unbound) {
    return unbound.error();
  }
  made.meshes = std::move(unbound).value();
  made.skeleton = skeletonOf(*request.locators, scene, made.meshes);
  return made;
}

Error nothingToBind(const Document& document, const BodyToBind& body) {
  const Scene& scene = *document.scene;
  const bool hasTriangles =
      std::ranges::any_of(scene.meshes, [](const Mesh& mesh) { return !mesh.primitives.empty(); });
  if (scene.skins.empty() && hasTriangles && !document.body.limbs.empty()) {
    return {"its meshes are rigid pieces that follow their nodes, and need no weights", "",
            "exaggerate it as it is, or join the pieces into one mesh first"};
  }
  return body.triangles.empty()
             ? Error{"the file shows no mesh with triangles", "", "give a file with a body"}
             : Error{"the file has no skeleton to bind to", "", "give locators"};
}

} // namespace

Result<BoundMeshes> bindMeshes(const Document& document, const BindRequest& request,
                               const skinning::Proceed& proceed) {
  if (Status possible = checkRequest(document, request); !possible) {
    return possible.error();
  }
  const Scene& scene = *document.scene;
  Result<JointsAndMeshes> found = jointsAndMeshes(document, request);
  if (!found) {
    return found.error();
  }
  const SkeletonToBind& skeleton = found->skeleton;
  const BodyToBind body = bodyToBind(scene, found->meshes);
  if (body.triangles.empty() || skeleton.nodes.empty()) {
    return nothingToBind(document, body);
  }
  Result<skinning::BoundBody> bound =
      request.way == BindWay::surface
          ? skinning::bindWeightsOnSurface(body.positions, body.triangles, skeleton.joints)
          : skinning::bindWeights(body.positions, body.triangles, skeleton.joints, {}, proceed);
  if (!bound) {
    return bound.error();
  }
  std::vector<std::string> held;
  if (skeleton.added.empty()) {
    held = keepThings(document, skeleton, body, bound->influences);
    std::ranges::move(holdPieces(document, skeleton, body, bound->influences), std::back_inserter(held));
  }
  gltf::Edits moving;
  addMoves(document, found->moves, moving);
  Result<gltf::Source> source = gltf::patched(
      *document.source, Binding(scene, skeleton, body, bound->influences).edits(std::move(moving)));
  if (!source) {
    return source.error();
  }
  std::vector<std::string> warnings = lostMotion(document, body, skeleton.added);
  if (skeleton.added.empty()) {
    const std::vector<std::string> idle = idleJoints(document, skeleton, bound->influences);
    warnings.insert(warnings.end(), idle.begin(), idle.end());
    warnings.insert(warnings.end(), held.begin(), held.end());
  }
  return BoundMeshes{std::make_shared<const gltf::Source>(std::move(source).value()),
                     std::move(found->moves),
                     {skeleton.nodes.size(), body.meshes.size(), body.positions.size(), bound->cubes,
                      bound->bytes, std::move(warnings)}};
}

Result<Document> withBoundMeshes(Document document, const BoundMeshes& bound) {
  Result<std::shared_ptr<const Scene>> scene = gltf::sceneWith(*bound.source, {});
  if (!scene) {
    return scene.error();
  }
  document.source = bound.source;
  document.scene = std::move(scene).value();
  document.clips = withMovedJoints(document.clips, bound.moves);
  document.sourceClips = withMovedJoints(document.sourceClips, bound.moves);
  return document.limbsCorrected ? document : detectLimbsAgain(document);
}

} // namespace stretch::app
