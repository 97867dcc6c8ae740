#include "rig/retarget/retarget.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/anim/frames.h"
#include "core/anim/sampling.h"
#include "core/math/finite.h"
#include "core/math/rotation.h"
#include "rig/ik/two_bone.h"
#include "rig/retarget/body_poser.h"
#include "rig/retarget/footing.h"
#include "rig/retarget/joined_hands.h"
#include "rig/retarget/joint_pairs.h"
#include "rig/retarget/thin_keys.h"
#include "rig/trail/release.h"

namespace stretch::rig {

namespace {

constexpr std::size_t mostFrames = 200000;

// Frames of the source, its first and last key among them, and close enough that a pose between two of them
// is what a player makes of them.
std::vector<double> timesOf(const Clip& clip) {
  constexpr double leastRate = 24.0;
  const double rate =
      clip.framesPerSecond * std::max(1.0, std::ceil(leastRate / clip.framesPerSecond - 1e-6));
  const double length = clip.endSeconds - clip.startSeconds;
  std::vector<double> times;
  if (!(length * rate < static_cast<double>(mostFrames))) {
    return times;
  }
  const auto whole = static_cast<std::size_t>(wholeFrameAtMost(length * rate));
  for (std::size_t i = 0; i <= whole; ++i) {
    times.push_back(clip.startSeconds + static_cast<double>(i) / rate);
  }
  if (clip.endSeconds - times.back() > frameTolerance / rate) {
    times.push_back(clip.endSeconds);
  }
  if (times.size() > 1) {
    times.back() = clip.endSeconds;
  }
  return times;
}

Vec3 levelPart(const Vec3& vector) {
  return {vector.x, 0.0, vector.z};
}

// A leg over the clip.
struct LegPath {
  std::vector<Vec3> sourceAnkles;
  std::vector<Vec3> sourceBalls;
  FootMotion foot;
  std::vector<double> heights; // of the ankle
  std::vector<Vec3> bases;     // of the leg
  std::vector<Vec3> ankles;    // where the ankle goes
};

class Retargeting {
public:
  Retargeting(const Skeleton& from, const Clip& clip, const Skeleton& to, Correction correction)
      : from_(from), clip_(clip), to_(to), correction_(correction), pairs_(pairJoints(from, to)),
        poser_(to, pairs_.pairs), times_(timesOf(clip)), ratio_(legLength(to) / legLength(from)),
        sourceShoulders_(shoulderWidth(from)), ownShoulders_(shoulderWidth(to)) {}

  Result<Retargeted> run(const std::function<bool(double)>& proceed, const ShiftArms& shiftArms) {
    const Error stopped{"stopped before the clip was brought over", clip_.name, "import it again"};
    if (times_.empty()) {
      return Error{"the clip is too long", clip_.name, "give a shorter one"};
    }
    const auto goesOn = [&](double from, double to, std::size_t frame) {
      const double share = static_cast<double>(frame) / static_cast<double>(times_.size());
      return !proceed || proceed(from + (to - from) * share);
    };
    for (std::size_t frame = 0; frame < times_.size(); ++frame) {
      if (!goesOn(0.0, 0.3, frame)) {
        return stopped;
      }
      follow(times_[frame]);
    }
    holdFeet();
    if (shiftArms && correction_ != Correction::none) {
      armShifts_ = shiftArms(followed([&](double share) { return !proceed || proceed(0.3 + 0.3 * share); }));
    }
    std::vector<BodyPose> poses;
    poses.reserve(times_.size());
    for (std::size_t frame = 0; frame < times_.size(); ++frame) {
      if (!goesOn(0.6, 0.9, frame)) {
        return stopped;
      }
      poses.push_back(posed(frame, armShifts_.empty() ? ArmShifts() : armShifts_[frame]));
    }
    return finished(poses);
  }

private:
  static double legLength(const Skeleton& skeleton) {
    return 0.5 * (skeleton.legs[leftSide].length + skeleton.legs[rightSide].length);
  }

  static Vec3 midOf(const Skeleton& skeleton, const std::vector<Mat4>& worlds) {
    return 0.5 * (positionOf(worlds[at(skeleton.legs[leftSide].limb.joints.front())]) +
                  positionOf(worlds[at(skeleton.legs[rightSide].limb.joints.front())]));
  }

  // Above the floor.
  static double ankleHeight(const Skeleton& skeleton) {
    return 0.5 * (endPosition(skeleton.legs[leftSide].limb, skeleton.bind).y +
                  endPosition(skeleton.legs[rightSide].limb, skeleton.bind).y) -
           skeleton.groundHeight;
  }

  // A place of the source beside the character: about what stands on the ground below the body, both in
  // their bind poses.
  [[nodiscard]] Vec3 scaled(const Vec3& place, double sourceHeight, double ownHeight) const {
    Vec3 origin = midOf(from_, from_.bind);
    Vec3 ownOrigin = midOf(to_, to_.bind);
    origin.y = sourceHeight;
    ownOrigin.y = ownHeight;
    return ownOrigin + ratio_ * (pairs_.world * (place - origin));
  }

  [[nodiscard]] Quat turnOf(const std::vector<Mat4>& worlds, NodeIndex joint) const {
    return rotationOf(worlds[at(joint)]) * glm::inverse(from_.bindTurns[at(joint)]);
  }

  [[nodiscard]] std::vector<Quat> turnsOf(const std::vector<Mat4>& worlds) const {
    std::vector<Quat> turns;
    turns.reserve(pairs_.pairs.size());
    for (const JointPair& pair : pairs_.pairs) {
      Quat turn = turnOf(worlds, pair.from);
      if (pair.standsOn) {
        turn = standingTurn(turn, *pair.standsOn, worlds);
      }
      if (pair.share > 0.0) {
        turn = glm::slerp(turn, turnOf(worlds, pair.towards), pair.share);
      }
      turns.push_back(glm::normalize(pairs_.world * turn * glm::inverse(pairs_.world) * pair.stance *
                                     to_.bindTurns[at(pair.joint)]));
    }
    return turns;
  }

  // A foot that the source lacks follows its shin in the air, and is as level as in the bind pose on the
  // ground.
  [[nodiscard]] Quat standingTurn(const Quat& turn, std::size_t side, const std::vector<Mat4>& worlds) const {
    constexpr double clear = 0.3; // of the leg
    const SkeletonLeg& leg = from_.legs[side];
    const double rise = endPosition(leg.limb, worlds).y - endPosition(leg.limb, from_.bind).y;
    const Quat level = glm::normalize(Quat(turn.w, 0.0, turn.y, 0.0));
    const bool isUpsideDown = turn.w * turn.w + turn.y * turn.y < 0.01;
    return isUpsideDown ? turn : glm::slerp(level, turn, smoothstep(rise / (clear * leg.length)));
  }

  void follow(double time) {
    const std::vector<Mat4> source = worldMatrices(*from_.scene, samplePose(*from_.scene, clip_, time));
    turns_.push_back(turnsOf(source));
    const BodyPose own = poser_.pose(turns_.back(), Vec3(0.0), {});
    const Vec3 shift =
        scaled(midOf(from_, source), ankleHeight(from_), ankleHeight(to_)) - midOf(to_, own.worlds);
    carried_.push_back(shift);
    if (sourceShoulders_ && ownShoulders_) {
      hands_.push_back(joinedHands(from_, source, *sourceShoulders_));
    }
    for (const std::size_t side : {leftSide, rightSide}) {
      followLeg(side, source, own.worlds, shift);
    }
  }

  void followLeg(std::size_t side, const std::vector<Mat4>& source, const std::vector<Mat4>& own,
                 const Vec3& shift) {
    const SkeletonLeg& followed = from_.legs[side];
    const SkeletonLeg& leg = to_.legs[side];
    LegPath& path = legs_[side];
    const Vec3 ankle = endPosition(followed.limb, source);
    const Vec3 ball = followed.ball(source);
    const Vec3 base = positionOf(own[at(leg.limb.joints.front())]) + shift;
    const Vec3 sourceLeg = ankle - positionOf(source[at(followed.limb.joints.front())]);
    const Vec3 toAnkle = endPosition(leg.limb, own) - leg.ball(own);
    path.sourceAnkles.push_back(ankle);
    path.sourceBalls.push_back(ball);
    path.foot.ankles.push_back(levelPart(ratio_ * (pairs_.world * ankle)));
    path.foot.balls.push_back(levelPart(ratio_ * (pairs_.world * ball)));
    path.foot.toAnkle.push_back(levelPart(toAnkle));
    path.foot.wanted.push_back(levelPart(base + ratio_ * (pairs_.world * sourceLeg)));
    path.bases.push_back(base);
    path.heights.push_back(ankleHeightOf(side, ankle, ball, toAnkle));
  }

  // The foot stands on what is nearer to the floor in the source, its ball or its heel; with both alike, both
  // say the same.
  [[nodiscard]] double ankleHeightOf(std::size_t side, const Vec3& ankle, const Vec3& ball,
                                     const Vec3& toAnkle) const {
    const SkeletonLeg& followed = from_.legs[side];
    const SkeletonLeg& leg = to_.legs[side];
    const double ankleRest = endPosition(followed.limb, from_.bind).y - from_.groundHeight;
    const double ballRest = followed.ball(from_.bind).y - from_.groundHeight;
    const double byAnkle =
        endPosition(leg.limb, to_.bind).y - to_.groundHeight + ratio_ * (ankle.y - ankleRest);
    if (ankle.y - ankleRest < ball.y - ballRest) {
      return byAnkle;
    }
    const double byBall = leg.ball(to_.bind).y - to_.groundHeight + ratio_ * (ball.y - ballRest) + toAnkle.y;
    constexpr double clear = 0.15; // of the leg: from this height on, toes that hang down touch nothing
    const double lifted = smoothstep((ball.y - ballRest) / (clear * followed.length));
    return byBall + lifted * (byAnkle - byBall);
  }

  // Feet keep their places where they stand, and the body comes down as far as a leg asks that would not
  // reach the ground.
  void holdFeet() {
    constexpr double leastLeg = 0.25; // of the height
    constexpr double shuffled = 0.15; // of the leg
    std::vector<double> down(times_.size(), 0.0);
    for (const std::size_t side : {leftSide, rightSide}) {
      LegPath& path = legs_[side];
      // However short it is: a foot does not stand less for it.
      const double leg = std::max(from_.legs[side].length, leastLeg * from_.height);
      path.foot.ankleStands = standsOf(path.sourceAnkles, times_, leg);
      path.foot.ballStands = standsOf(path.sourceBalls, times_, leg);
      path.foot.shuffle = shuffled * to_.legs[side].length;
      path.foot.heldAnkles = groundedIn(path.sourceAnkles);
      path.foot.heldBalls = groundedIn(path.sourceBalls);
      path.foot.ankles = heldInPlace(path.foot.ankles, path.foot.heldAnkles);
      path.foot.balls = heldInPlace(path.foot.balls, path.foot.heldBalls);
      path.ankles = plantedAnkles(path.foot);
      const std::vector<bool> isStanding = standingFrames(path.foot);
      for (std::size_t frame = 0; frame < times_.size(); ++frame) {
        path.ankles[frame].y = path.heights[frame];
        down[frame] = std::max(down[frame], isStanding[frame] ? missingReach(side, frame) : 0.0);
      }
    }
    constexpr double easeSeconds = 0.12;
    const double step =
        times_.size() < 2 ? 1.0 : (times_.back() - times_.front()) / static_cast<double>(times_.size() - 1);
    lowered_ = easedAbove(down, static_cast<std::size_t>(std::ceil(easeSeconds / step)));
  }

  [[nodiscard]] std::vector<Stand> groundedIn(const std::vector<Vec3>& places) const {
    const double length = times_.back() - times_.front();
    const double rate = length > 0.0 ? static_cast<double>(times_.size() - 1) / length : 1.0;
    return standingIn(places, rate, from_.height);
  }

  // How far the base of the leg has to come down for its foot to reach its place.
  [[nodiscard]] double missingReach(std::size_t side, std::size_t frame) const {
    constexpr double straight = 0.9995; // of the length: a little bend tells the knee where to go
    const double reach = straight * to_.legs[side].length;
    const Vec3 way = legs_[side].bases[frame] - legs_[side].ankles[frame];
    const double across = glm::length(levelPart(way));
    if (across >= reach || way.y <= 0.0) {
      return 0.0;
    }
    return std::max(0.0, way.y - std::sqrt(reach * reach - across * across));
  }

  [[nodiscard]] FollowedClip followed(const std::function<bool(double)>& proceed) const {
    const auto worlds = [this](std::size_t frame, const ArmShifts& shifts) {
      return posed(frame, shifts).worlds;
    };
    FollowedClip followed{times_, pairs_.world, {}, worlds, proceed};
    for (const JoinedHands& hands : hands_) {
      followed.joined.push_back(hands.share);
    }
    return followed;
  }

  [[nodiscard]] BodyPose posed(std::size_t frame, const ArmShifts& shifts) const {
    if (correction_ == Correction::none) {
      return poser_.pose(turns_[frame], carried_[frame], {});
    }
    const Vec3 shift = carried_[frame] - Vec3(0.0, lowered_[frame], 0.0);
    std::vector<Quat> turns = turns_[frame];
    const BodyPose straight = poser_.pose(turns, shift, {});
    FootPlaces feet;
    for (const std::size_t side : {leftSide, rightSide}) {
      const Vec3 front = to_.axes[2]; // Where knees go.
      feet[side] = bend(to_.legs[side].limb, straight.worlds, legs_[side].ankles[frame], front, turns);
    }
    if (!hands_.empty()) {
      joinHands(hands_[frame], straight.worlds, turns);
    }
    BodyPose pose = poser_.pose(turns, shift, feet);
    bool isShifted = false;
    for (const std::size_t side : {leftSide, rightSide}) {
      isShifted =
          (to_.arms[side] && shiftArm(to_.arms[side]->limb, pose.worlds, shifts[side], turns)) || isShifted;
    }
    return isShifted ? poser_.pose(turns, shift, feet) : pose;
  }

  // Whether there was anything to do.
  bool shiftArm(const Limb& arm, const std::vector<Mat4>& worlds, const ArmShift& shift,
                std::vector<Quat>& turns) const {
    if (shift.wrist == Vec3(0.0) && shift.swivel == 0.0) {
      return false;
    }
    const std::vector<Vec3> points = bonesOf(arm, worlds);
    const Vec3 back = -to_.axes[2]; // Where elbows go.
    const Vec3 wrist = bend(arm, worlds, points.back() + shift.wrist, back, turns);
    const Vec3 line = wrist - points.front();
    const double far = glm::length(line);
    for (const NodeIndex joint : arm.joints) {
      turn(joint, far > 0.0 ? axisAngle(line / far, shift.swivel) : Quat(1.0, 0.0, 0.0, 0.0), turns);
    }
    return true;
  }

  // Hands that work together in the source are as many shoulder widths apart here, about the middle between
  // them or the nearest place that both arms reach.
  void joinHands(const JoinedHands& hands, const std::vector<Mat4>& worlds, std::vector<Quat>& turns) const {
    const Vec3 left = endPosition(to_.arms[leftSide]->limb, worlds);
    const Vec3 right = endPosition(to_.arms[rightSide]->limb, worlds);
    const Vec3 wanted = *ownShoulders_ * (pairs_.world * hands.leftToRight);
    const Vec3 half = 0.5 * ((1.0 - hands.share) * (right - left) + hands.share * wanted);
    const Vec3 middle = 0.5 * (left + right);
    if (glm::length(middle - half - left) <= retargetTolerance * to_.height) {
      return;
    }
    const Vec3 reached =
        middleInReach({ballOf(leftSide, worlds, half), ballOf(rightSide, worlds, -half)}, middle);
    const Vec3 back = -to_.axes[2]; // Where elbows go.
    (void)bend(to_.arms[leftSide]->limb, worlds, reached - half, back, turns);
    (void)bend(to_.arms[rightSide]->limb, worlds, reached + half, back, turns);
  }

  // Where something may be that the hand holds at an offset from itself.
  [[nodiscard]] Ball ballOf(std::size_t side, const std::vector<Mat4>& worlds, const Vec3& offset) const {
    constexpr double straight = 0.9995; // of the length: a little bend tells the elbow where to go
    const std::vector<Vec3> points = bonesOf(to_.arms[side]->limb, worlds);
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      length += glm::length(points[i + 1] - points[i]);
    }
    return {points.front() + offset, straight * length};
  }

  // Turns the bones of a limb so that its end comes to the target; answers where it comes to. `usualBend`:
  // where its middle joint goes in the bind pose.
  Vec3 bend(const Limb& limb, const std::vector<Mat4>& worlds, const Vec3& target, const Vec3& usualBend,
            std::vector<Quat>& turns) const {
    const std::vector<Vec3> points = bonesOf(limb, worlds);
    const NodeIndex first = limb.joints.front();
    if (limb.joints.size() == 1) {
      turn(first, shortestArc(points.back() - points.front(), target - points.front()), turns);
      const Vec3 way = target - points.front();
      const double far = glm::length(way);
      return far > 0.0 ? points.front() + way * (glm::length(points.back() - points.front()) / far) : target;
    }
    TwoBoneProblem problem;
    problem.base = points.front();
    problem.joint = points[1];
    problem.end = points.back();
    problem.target = target;
    problem.usualBend = rotationOf(worlds[at(first)]) * glm::inverse(to_.bindTurns[at(first)]) * usualBend;
    problem.stretchSwitch = 0.0;
    problem.isExact = true;
    const TwoBoneShape shape = solveTwoBone(problem);
    turn(first, shape.turns[0], turns);
    for (std::size_t i = 1; i < limb.joints.size(); ++i) {
      turn(limb.joints[i], shape.turns[1], turns);
    }
    return shape.end;
  }

  // The limb's points as its bones alone have them: a foot that does not hang on the shin is elsewhere.
  [[nodiscard]] std::vector<Vec3> bonesOf(const Limb& limb, const std::vector<Mat4>& worlds) const {
    std::vector<Vec3> points = limbPoints(limb, worlds);
    const Mat4& bindOfLast = to_.bind[at(limb.joints.back())];
    points.back() = transformPoint(worlds[at(limb.joints.back())],
                                   transformPoint(glm::inverse(bindOfLast), endPosition(limb, to_.bind)));
    return points;
  }

  void turn(NodeIndex joint, const Quat& by, std::vector<Quat>& turns) const {
    const int pair = poser_.pairOf(joint);
    if (pair >= 0) {
      turns[at(pair)] = glm::normalize(by * turns[at(pair)]);
    }
  }

  [[nodiscard]] Result<Retargeted> finished(const std::vector<BodyPose>& poses) const {
    for (const BodyPose& pose : poses) {
      if (!std::ranges::all_of(pose.worlds, [](const Mat4& world) { return isFinite(world); })) {
        return Error{"the clip cannot be brought to this character", clip_.name,
                     "its joints, or those of the character, are scaled to nothing"};
      }
    }
    std::vector<float> times;
    times.reserve(times_.size());
    for (const double time : times_) {
      times.push_back(static_cast<float>(time));
    }
    Retargeted result{clip_, pairs_.left};
    result.clip.sourceIndex = -1;
    result.clip.tracks.clear();
    for (Track& track : poser_.tracks(times, poses, retargetTolerance * to_.height)) {
      result.clip.tracks.emplace_back(std::move(track));
    }
    return result;
  }

  const Skeleton& from_;
  const Clip& clip_;
  const Skeleton& to_;
  Correction correction_;
  JointPairs pairs_;
  BodyPoser poser_;
  std::vector<double> times_;
  double ratio_ = 1.0;
  std::optional<double> sourceShoulders_; // their width; nothing without two arms
  std::optional<double> ownShoulders_;
  std::vector<std::vector<Quat>> turns_; // of the pairs, at every frame
  std::vector<Vec3> carried_;            // how far the body is moved
  std::vector<ArmShifts> armShifts_;     // at every frame; empty: none
  std::vector<JoinedHands> hands_;       // at every frame; empty where one of both lacks an arm
  std::array<LegPath, 2> legs_;
  std::vector<double> lowered_;
};

} // namespace

Result<Retargeted> retarget(const Skeleton& from, const Clip& clip, const Skeleton& to,
                            const std::function<bool(double)>& proceed, Correction correction,
                            const ShiftArms& shiftArms) {
  return Retargeting(from, clip, to, correction).run(proceed, shiftArms);
}

} // namespace stretch::rig
