#include "app/bind/held_pieces.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <set>

#include <fmt/core.h>

#include "app/named.h"
#include "skinning/bind/stiff_shells.h"
#include "skinning/bind/welded.h"

namespace stretch::app {

namespace {

struct Hand {
  std::string limb;
  std::size_t joint = 0;
  std::vector<bool> isOfHand; // all below it, and it itself where it is no forearm
  std::vector<bool> isFinger; // below it, and part of a chain: a single joint may be that of a thing
  double span = 0.0;          // how far finger joints stand from each other and from the hand
};

double longestSide(const std::vector<Vec3>& points) {
  Vec3 low = points.front();
  Vec3 high = points.front();
  for (const Vec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  const Vec3 sides = high - low;
  return std::max({sides.x, sides.y, sides.z});
}

std::optional<Hand> handOf(const rig::Limb& limb, const SkeletonToBind& skeleton) {
  const NodeIndex node = limb.endNode.exists() ? limb.endNode : limb.joints.back();
  const auto found = std::ranges::find(skeleton.nodes, node);
  if (found == skeleton.nodes.end()) {
    return {};
  }
  const std::vector<skinning::BindJoint>& joints = skeleton.joints;
  Hand hand{limb.id, static_cast<std::size_t>(found - skeleton.nodes.begin()),
            std::vector<bool>(joints.size(), false), std::vector<bool>(joints.size(), false)};
  std::vector<bool> carries(joints.size(), false);
  for (const skinning::BindJoint& joint : joints) {
    if (joint.parent >= 0) {
      carries[at(joint.parent)] = true;
    }
  }
  std::vector<Vec3> fingers;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    int above = static_cast<int>(i);
    while (above >= 0 && at(above) != hand.joint) {
      above = joints[at(above)].parent;
    }
    hand.isOfHand[i] = above >= 0 && (i != hand.joint || limb.endNode.exists());
    hand.isFinger[i] = above >= 0 && i != hand.joint && (carries[i] || at(joints[i].parent) != hand.joint);
    if (hand.isFinger[i] || (i == hand.joint && limb.endNode.exists())) {
      fingers.push_back(joints[i].place);
    }
  }
  hand.span = fingers.size() > 1 ? longestSide(fingers) : 0.0;
  return hand.span > 0.0 ? std::optional(std::move(hand)) : std::nullopt;
}

bool holds(const Hand& hand, const std::vector<std::size_t>& piece, const BodyToBind& body,
           const std::vector<skinning::Influences>& rows) {
  std::size_t ofFingers = 0;
  std::vector<Vec3> points;
  for (const std::size_t vertex : piece) {
    const std::uint16_t joint = rows[vertex].bones[0];
    if (!hand.isOfHand[joint]) {
      return false;
    }
    ofFingers += hand.isFinger[joint] ? 1 : 0;
    points.emplace_back(body.positions[vertex]);
  }
  constexpr double longer = 2.0; // than the fingers reach: no glove
  return 2 * ofFingers > piece.size() && longestSide(points) > longer * hand.span;
}

// The vertices of each mesh as a whole, then those of each piece that nothing joins to the rest.
std::vector<std::vector<std::size_t>> piecesOf(const BodyToBind& body) {
  std::vector<std::vector<std::size_t>> pieces(body.meshes.size());
  const std::vector<std::size_t> numbers =
      skinning::shellsOf(skinning::weldedVertices(body.positions), body.triangles);
  for (std::size_t vertex = 0, mesh = 0; vertex < numbers.size(); ++vertex) {
    while (mesh + 1 < body.meshes.size() && vertex >= body.meshes[mesh + 1].firstVertex) {
      ++mesh;
    }
    const std::size_t piece = body.meshes.size() + numbers[vertex];
    pieces.resize(std::max(pieces.size(), piece + 1));
    pieces[piece].push_back(vertex);
    if (!body.meshes.empty()) {
      pieces[mesh].push_back(vertex);
    }
  }
  return pieces;
}

// Where in its skin the joint stands that a vertex follows wholly; -1: it follows several, or none.
int wholeSlot(const VertexInfluences& influences) {
  constexpr float whole = 0.999F;
  const std::array<float, VertexInfluences::capacity>& weights = influences.weights;
  const float sum = std::accumulate(weights.begin(), weights.end(), 0.0F);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0.0F && weights[i] >= whole * sum) {
      return influences.joints[i];
    }
  }
  return -1;
}

// The joint that each vertex of the body follows wholly, as its file has it; -1: several, or none.
std::vector<int> wholeFollowers(const Scene& scene, const SkeletonToBind& skeleton, const BodyToBind& body) {
  std::vector<int> placeOf(scene.nodes.size(), -1);
  for (std::size_t i = 0; i < skeleton.nodes.size(); ++i) {
    placeOf[at(skeleton.nodes[i])] = static_cast<int>(i);
  }
  std::vector<int> followed(body.positions.size(), -1);
  for (const MeshToBind& mesh : body.meshes) {
    std::size_t vertex = mesh.firstVertex;
    for (const Primitive& primitive : scene.meshes[at(scene.nodes[at(mesh.node)].mesh)].primitives) {
      for (std::size_t i = 0; i < primitive.positions.size(); ++i, ++vertex) {
        const bool hasWeights = mesh.skin >= 0 && i < primitive.influences.size();
        const int slot = hasWeights ? wholeSlot(primitive.influences[i]) : -1;
        followed[vertex] = slot < 0 ? -1 : placeOf[at(scene.skins[at(mesh.skin)].joints[at(slot)])];
      }
    }
  }
  return followed;
}

// Joints at the end of a row that no limb goes through: of an eye, a shield, a hat. What hangs from nothing
// is no part of the body, as the joint is to which an exporter gives vertices without weights.
std::vector<bool> endJoints(const Document& document, const SkeletonToBind& skeleton) {
  std::vector<bool> ends(skeleton.joints.size(), !document.body.limbs.empty());
  for (std::size_t i = 0; i < skeleton.joints.size(); ++i) {
    const NodeIndex node = skeleton.nodes[i];
    const int parent = skeleton.joints[i].parent;
    ends[i] = ends[i] && parent >= 0 && node != document.body.head && !isOfLimb(document.body, node);
    if (parent >= 0) {
      ends[at(parent)] = false;
    }
  }
  return ends;
}

void follow(std::size_t joint, const std::vector<std::size_t>& piece,
            std::vector<skinning::Influences>& rows) {
  for (const std::size_t vertex : piece) {
    rows[vertex] = {};
    rows[vertex].bones[0] = static_cast<std::uint16_t>(joint);
    rows[vertex].weights[0] = 1.0F;
  }
}

} // namespace

std::vector<std::string> keepThings(const Document& document, const SkeletonToBind& skeleton,
                                    const BodyToBind& body, std::vector<skinning::Influences>& rows) {
  const std::vector<int> followed = wholeFollowers(*document.scene, skeleton, body);
  const std::vector<bool> ends = endJoints(document, skeleton);
  const std::vector<std::vector<std::size_t>> pieces = piecesOf(body);
  std::set<int> joints;
  std::size_t vertices = 0;
  for (std::size_t i = body.meshes.size(); i < pieces.size(); ++i) {
    const int joint = pieces[i].empty() ? -1 : followed[pieces[i].front()];
    const auto isOfJoint = [&](std::size_t vertex) { return followed[vertex] == joint; };
    const auto isMoved = [&](std::size_t vertex) {
      return rows[vertex].bones[0] != at(joint) || rows[vertex].weights[0] < 1.0F;
    };
    if (joint >= 0 && ends[at(joint)] && std::ranges::all_of(pieces[i], isOfJoint) &&
        std::ranges::any_of(pieces[i], isMoved)) {
      follow(at(joint), pieces[i], rows);
      joints.insert(joint);
      vertices += pieces[i].size();
    }
  }
  if (joints.empty()) {
    return {};
  }
  const std::string first = nodeTitle(document, skeleton.nodes[at(*joints.begin())]);
  const std::string others = joints.size() > 1 ? fmt::format(" or one of {} others", joints.size() - 1) : "";
  return {fmt::format("{} vertices of things that followed \"{}\"{} alone go on following it", vertices,
                      first, others)};
}

std::vector<std::string> holdPieces(const Document& document, const SkeletonToBind& skeleton,
                                    const BodyToBind& body, std::vector<skinning::Influences>& rows) {
  std::vector<Hand> hands;
  for (const rig::Limb& limb : document.body.limbs) {
    if (std::optional<Hand> hand = rig::isArm(limb) ? handOf(limb, skeleton) : std::nullopt) {
      hands.push_back(std::move(*hand));
    }
  }
  std::vector<std::string> told;
  if (hands.empty()) {
    return told;
  }
  for (const std::vector<std::size_t>& piece : piecesOf(body)) {
    const auto hand =
        std::ranges::find_if(hands, [&](const Hand& one) { return holds(one, piece, body, rows); });
    if (hand == hands.end()) {
      continue;
    }
    follow(hand->joint, piece, rows);
    told.push_back(fmt::format("a thing of {} vertices that the {} holds follows \"{}\" as one piece",
                               piece.size(), hand->limb, nodeTitle(document, skeleton.nodes[hand->joint])));
  }
  return told;
}

} // namespace stretch::app
