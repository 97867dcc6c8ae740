#include "app/bind/moved_joints.h"

#include <algorithm>
#include <utility>

#include "app/locators/build_rig.h"
#include "core/anim/sampling.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/detection.h"

namespace stretch::app {

namespace {

Quat turnOf(const Mat4& matrix) {
  return glm::normalize(toTransform(matrix).rotation);
}

const JointMove* findMove(const std::vector<JointMove>& moves, NodeIndex node) {
  const auto found = std::ranges::find(moves, node, &JointMove::node);
  return found == moves.end() ? nullptr : &*found;
}

Transform localOf(const Mat4& parent, const Mat4& world) {
  return toTransform(glm::inverse(parent) * world);
}

// What a joint's keys become. A key turns the mesh by its way from the bind pose; the same way from the new
// bind pose is the key between two fixed turns.
class JointKeys {
public:
  explicit JointKeys(const JointMove& move)
      : before_(glm::conjugate(turnOf(move.parentTo)) * turnOf(move.parentFrom)),
        after_(glm::conjugate(turnOf(move.from)) * turnOf(move.to)),
        restFrom_(localOf(move.parentFrom, move.from).translation),
        restTo_(localOf(move.parentTo, move.to).translation) {}

  void change(Track& track) const {
    const bool isCubic = track.interpolation == Interpolation::cubicSpline;
    const auto width = static_cast<std::size_t>(track.width);
    for (std::size_t i = 0; i * width < track.values.size(); ++i) {
      float* const value = track.values.data() + i * width;
      if (track.channel == Channel::rotation) {
        turn(value);
      } else if (track.channel == Channel::translation) {
        shift(value, isCubic && i % 3 != 1);
      }
    }
  }

private:
  void turn(float* value) const {
    const Quat made = before_ * Quat(value[3], value[0], value[1], value[2]) * after_;
    const double numbers[] = {made.x, made.y, made.z, made.w};
    std::ranges::transform(numbers, value, [](double number) { return static_cast<float>(number); });
  }
  void shift(float* value, bool isTangent) const {
    const Vec3 read(value[0], value[1], value[2]);
    const Vec3 made = isTangent ? before_ * read : restTo_ + before_ * (read - restFrom_);
    for (int axis = 0; axis < 3; ++axis) {
      value[axis] = static_cast<float>(made[axis]);
    }
  }

  Quat before_;
  Quat after_;
  Vec3 restFrom_;
  Vec3 restTo_;
};

bool isMovedBy(const JointMove& move) {
  constexpr double rounding = 1e-12;
  double largest = 0.0;
  double apart = 0.0;
  for (glm::length_t column = 0; column < 4; ++column) {
    largest = std::max(largest, glm::length(move.from[column]));
    apart = std::max(apart, glm::length(move.from[column] - move.to[column]));
  }
  return apart > rounding * largest;
}

std::vector<Track> movedTracks(const Clip& clip, const std::vector<JointMove>& moves) {
  std::vector<Track> tracks;
  for (const auto& track : clip.tracks) {
    const JointMove* const move = findMove(moves, track->node);
    if (move != nullptr && (track->channel == Channel::rotation || track->channel == Channel::translation)) {
      JointKeys(*move).change(tracks.emplace_back(*track));
    }
  }
  return tracks;
}

} // namespace

std::vector<JointMove> movesTo(const Scene& scene, const rig::Locators& locators) {
  const std::vector<NodeIndex> joints = jointsOfLocators(scene, locators);
  if (joints.empty()) {
    return {};
  }
  const std::vector<Mat4> from = rig::bindPoseWorlds(scene);
  std::vector<Mat4> to = from;
  std::vector<JointMove> moves;
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    const auto joint = std::ranges::find(joints, node);
    if (joint != joints.end()) {
      const rig::Locator& locator = locators.list[static_cast<std::size_t>(joint - joints.begin())];
      to[at(node)] = toMatrix(
          {locator.position, glm::normalize(locator.orientation), toTransform(from[at(node)]).scale});
    } else if (parent.exists()) {
      to[at(node)] = to[at(parent)] * glm::inverse(from[at(parent)]) * from[at(node)];
    }
    JointMove move{node, from[at(node)], to[at(node)]};
    if (parent.exists()) {
      move.parentFrom = from[at(parent)];
      move.parentTo = to[at(parent)];
    }
    if (isMovedBy(move)) {
      moves.push_back(move);
    }
  }
  return moves;
}

SkeletonToBind moved(SkeletonToBind skeleton, const std::vector<JointMove>& moves) {
  for (std::size_t i = 0; i < skeleton.nodes.size(); ++i) {
    if (const JointMove* const move = findMove(moves, skeleton.nodes[i])) {
      const Vec3 turned = Mat3(move->to) * glm::inverse(Mat3(move->from)) * skeleton.joints[i].forward;
      const double length = glm::length(turned);
      skeleton.joints[i].forward = length > 0.0 ? turned / length : Vec3(0.0);
      skeleton.worlds[i] = move->to;
      skeleton.joints[i].place = positionOf(move->to);
    }
  }
  return skeleton;
}

SharedClips withMovedJoints(const SharedClips& clips, const std::vector<JointMove>& moves) {
  if (clips == nullptr || moves.empty()) {
    return clips;
  }
  std::vector<Clip> changed = *clips;
  for (Clip& clip : changed) {
    for (Track& track : movedTracks(clip, moves)) {
      const int place = findTrack(clip, track.node, track.channel);
      clip.tracks[at(place)] = CopyOnWrite<Track>(std::move(track));
    }
  }
  return std::make_shared<const std::vector<Clip>>(std::move(changed));
}

void addMoves(const Document& document, const std::vector<JointMove>& moves, gltf::Edits& edits) {
  const Scene& scene = *document.scene;
  for (const JointMove& move : moves) {
    edits.movedNodes.push_back({move.node, localOf(move.parentTo, move.to)});
    for (std::size_t skin = 0; skin < scene.skins.size(); ++skin) {
      const std::vector<NodeIndex>& joints = scene.skins[skin].joints;
      for (std::size_t slot = 0; slot < joints.size(); ++slot) {
        if (joints[slot] == move.node) {
          edits.skinSlots.push_back(
              {static_cast<int>(skin), static_cast<int>(slot), move.node,
               glm::inverse(move.to) * move.from * scene.skins[skin].inverseBind[slot]});
        }
      }
    }
  }
  const std::vector<Clip>& clips = *sourceClipsOf(document);
  for (std::size_t clip = 0; clip < clips.size(); ++clip) {
    std::vector<Track> tracks = movedTracks(clips[clip], moves);
    if (!tracks.empty()) {
      edits.clips.push_back({static_cast<int>(clip), std::move(tracks)});
    }
  }
}

} // namespace stretch::app
