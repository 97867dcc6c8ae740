#include "app/evaluate/trail_look.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/evaluate/seen.h"
#include "core/anim/frames.h"
#include "core/math/bounds.h"
#include "core/math/rotation.h"
#include "rig/limb.h"
#include "rig/motion/evaluate.h"
#include "rig/motion/part_motion.h"

namespace stretch::app {

namespace {

constexpr double room = 1.5;
constexpr double farthestTurn = 120.0 * pi / 180.0; // beyond it an arm or a leg looks torn out and put back
constexpr double clearBend = 15.0 * pi / 180.0;     // of a joint: less is as good as straight
constexpr double longestEdge = 4.0;                 // times its length, on a limb that is hardly longer
constexpr double placeMargin = 0.02;                // of the height
constexpr double farthestJump = 0.25;               // of the limb's length, within a frame

std::vector<double> framesOf(const rig::MotionState& motion, const rig::SolvedTrail& trail) {
  const double fps = motion.framesPerSecond;
  const double last = wholeFrameAtMost(std::min(trail.windowEndSeconds, motion.endSeconds) * fps);
  std::vector<double> frames;
  for (double frame = std::max(0.0, wholeFrameAtLeast(trail.windowStartSeconds * fps)); frame <= last;
       frame += 1.0) {
    frames.push_back(frame);
  }
  return frames;
}

double distanceBetween(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 between = a - b;
  return std::sqrt(static_cast<double>(glm::dot(between, between)));
}

std::vector<bool> movedBy(const Scene& scene, const rig::SolvedTrail& trail) {
  std::vector<bool> moved(scene.nodes.size(), false);
  for (const NodeIndex node : withSubtrees(scene, rig::touchedNodes(trail.limb, trail.topology))) {
    moved[at(node)] = true;
  }
  return moved;
}

} // namespace

void Finding::add(double frame, double value, double badness) {
  first = first < 0.0 ? frame : first;
  last = frame;
  if (badness > worstBadness) {
    worstBadness = badness;
    worst = value;
    worstFrame = frame;
  }
}

std::string Finding::frames() const {
  return first == last ? fmt::format("at frame {:g}", first)
                       : fmt::format("at frames {:g} to {:g} (worst at {:g})", first, last, worstFrame);
}

bool Findings::any() const {
  return firstFrame() >= 0.0;
}

double Findings::firstFrame() const {
  double first = -1.0;
  for (const Finding* const one : each()) {
    first = one->any() && (first < 0.0 || one->first < first) ? one->first : first;
  }
  return first;
}

double Findings::lastFrame() const {
  double last = -1.0;
  for (const Finding* const one : each()) {
    last = std::max(last, one->last);
  }
  return last;
}

std::vector<double> Findings::worstFrames() const {
  std::vector<double> frames;
  for (const Finding* const one : each()) {
    if (one->any()) {
      frames.push_back(one->worstFrame);
    }
  }
  return frames;
}

TrailLook::TrailLook(std::shared_ptr<ClipFacts> facts, const rig::SolvedTrail& trail, LookAt what)
    : facts_(std::move(facts)), moved_(movedBy(*facts_->document().scene, trail)),
      surface_(what == LookAt::limbAndMesh ? facts_->character().surfaceOf(moved_) : nullptr) {
  if (surface_ != nullptr) {
    nodes_ = surface_->part.nodes();
  }
  if (isArm(trail.limb)) {
    findHead();
  }
  const StandingFloor& standing = facts_->standing();
  lowestEnd_ = isArm(trail.limb)   ? standing.floor
               : isLeg(trail.limb) ? standingEnd(facts_->document(), trail.limb, *facts_->places(), standing)
                                   : std::nullopt;
  if (!lowestEnd_ && !standing.flies) {
    lowestPlace_ = facts_->lowestPlace();
  }
}

void TrailLook::findHead() {
  const Document& document = facts_->document();
  const rig::BindPlaces& places = *facts_->places();
  const NodeIndex joint = document.body.head;
  if (!joint.exists() || !document.body.hips.exists()) {
    return;
  }
  const Mat4& world = places.worlds[at(joint)];
  if (glm::determinant(Mat3(world)) == 0.0) {
    return;
  }
  Bounds box;
  for (const NodeIndex node : withSubtrees(*document.scene, {joint})) {
    const Bounds& mesh = places.meshes[at(node)];
    if (!mesh.empty()) {
      box.add(mesh.low);
      box.add(mesh.high);
    }
  }
  if (box.empty()) {
    box.add(positionOf(world));
  }
  Head head{joint, glm::inverse(world), 0.5 * (box.low + box.high), 0.5 * (box.high - box.low), 0.0};
  head.aboveHips = head.top(world) - positionOf(places.worlds[at(document.body.hips)]).y;
  if (head.aboveHips > 0.0) {
    head_ = head;
    nodes_.push_back(joint);
  }
}

double TrailLook::Head::top(const Mat4& jointWorld) const {
  const Mat4 moved = jointWorld * fromBind;
  const Vec3 up(moved[0].y, moved[1].y, moved[2].y);
  return transformPoint(moved, centre).y + glm::length(up * half);
}

// One trail on its frames.
class TrailLook::Walk {
public:
  Walk(const TrailLook& look, const rig::MotionState& alone)
      : look_(look), document_(look.facts_->document()), alone_(alone), trail_(alone.trails.front()),
        part_(*document_.scene, clipOf(document_, look.facts_->clip()), alone, look.nodes_) {
    if (trail_.settings.stopAt) {
      unstopped_ = alone;
      unstopped_->trails.front().settings.stopAt.reset();
      unstoppedPart_.emplace(*document_.scene, clipOf(document_, look.facts_->clip()), *unstopped_,
                             look.nodes_);
    }
    step(trail_.tipSeconds);
    findings_.tipDisplacement =
        glm::length(rig::leadingPosition(trail_.limb, after_) - rig::leadingPosition(trail_.limb, before_));
  }

  [[nodiscard]] Findings all() {
    for (const double frame : framesOf(alone_, trail_)) {
      lookAt(frame);
    }
    return findings_;
  }

  [[nodiscard]] std::optional<double> foundAt(const std::vector<double>& firstFrames) {
    const std::vector<double> frames = framesOf(alone_, trail_);
    for (const double frame : firstFrames) {
      if (std::ranges::binary_search(frames, frame) && isFoundAt(frame)) {
        return frame;
      }
    }
    const auto found = std::ranges::find_if(frames, [&](double frame) { return isFoundAt(frame); });
    return found == frames.end() ? std::nullopt : std::optional(*found);
  }

private:
  void lookAt(double frame) {
    lookAtPose(frame);
    lookAtSurface(frame);
  }

  // The mesh costs most: it is looked at last.
  [[nodiscard]] bool isFoundAt(double frame) {
    lookAtPose(frame);
    if (!findings_.any()) {
      lookAtSurface(frame);
    }
    return findings_.any();
  }

  void lookAtPose(double frame) {
    lookAtStop(frame);
    step(frame / alone_.framesPerSecond);
    lookAtLimb(frame);
    lookAtPlaces(frame);
  }

  void step(double seconds) {
    part_.source(seconds, before_);
    after_ = before_;
    part_.move(after_);
  }

  [[nodiscard]] double height() const { return document_.body.height; }

  void lookAtLimb(double frame) {
    const Vec3 reachBefore = reachOf(trail_.limb, before_);
    const Vec3 reachAfter = reachOf(trail_.limb, after_);
    if (!(glm::length(reachBefore) > 0.0)) {
      return;
    }
    const double scale = trail_.settings.scale;
    const double ratio = glm::length(reachAfter) / glm::length(reachBefore);
    const double least = std::min(1.0, scale) / room;
    const double most = room * std::max(1.0, scale);
    if (ratio < least || ratio > most) {
      findings_.lengths.add(frame, ratio, std::max(least / std::max(ratio, 1e-9), ratio / most));
    }
    const double turn = angleBetween(reachBefore, reachAfter);
    if (turn > farthestTurn) {
      findings_.turns.add(frame, turn, turn);
    }
    lookAtBends(frame);
  }

  // Each joint seen from the bone that carries it, in whose frame it is a hinge.
  void lookAtBends(double frame) {
    if (!rig::hasElbowOrKnee(trail_.limb)) {
      return;
    }
    const std::vector<Vec3> before = rig::limbPoints(trail_.limb, before_);
    const std::vector<Vec3> after = rig::limbPoints(trail_.limb, after_);
    for (std::size_t i = 1; i + 1 < before.size(); ++i) {
      const std::size_t bone = at(trail_.limb.joints[i - 1]);
      const auto bendIn = [&](const std::vector<Vec3>& points, const FrameState& pose) {
        const Vec3 first = points[i] - points[i - 1];
        const Vec3 second = points[i + 1] - points[i];
        const Vec3 axis = glm::cross(first, second);
        const double length = glm::length(axis);
        return length > 0.0 ? glm::inverse(rotationOf(pose.worlds[bone])) * axis *
                                  (angleBetween(first, second) / length)
                            : Vec3(0.0);
      };
      const Vec3 was = bendIn(before, before_);
      const Vec3 is = bendIn(after, after_);
      const double other = std::min(glm::length(was), glm::length(is));
      if (other > clearBend && glm::dot(was, is) < 0.0) {
        findings_.bends.add(frame, glm::length(is), glm::length(is));
      }
    }
  }

  // How far the limb's end is carried from its place in the source.
  [[nodiscard]] double carried(const rig::PartMotion& part, double frame) {
    part.source(frame / alone_.framesPerSecond, before_);
    after_ = before_;
    part.move(after_);
    return glm::length(rig::leadingPosition(trail_.limb, after_) -
                       rig::leadingPosition(trail_.limb, before_));
  }

  // What the stop makes of the way from one frame to the next, beyond what it would be without it.
  void lookAtStop(double frame) {
    if (!unstoppedPart_ || frame < 1.0) {
      return;
    }
    const double jump = std::abs(carried(part_, frame) - carried(part_, frame - 1.0));
    const double free = std::abs(carried(*unstoppedPart_, frame) - carried(*unstoppedPart_, frame - 1.0));
    if (jump - free > farthestJump * trail_.limb.restLength) {
      findings_.jumps.add(frame, jump, jump);
    }
  }

  void lookAtPlaces(double frame) {
    const double margin = placeMargin * height();
    if (look_.lowestEnd_) {
      const double below = *look_.lowestEnd_ - rig::endPosition(trail_.limb, after_).y;
      const double belowBefore = *look_.lowestEnd_ - rig::endPosition(trail_.limb, before_).y;
      if (below > margin && belowBefore <= margin) {
        findings_.ends.add(frame, below, below);
      }
    }
    if (look_.lowestPlace_) {
      lookAtLowest(frame, margin);
    }
    if (look_.head_) {
      lookAtElbows(frame, margin);
    }
  }

  void lookAtLowest(double frame, double margin) {
    double below = 0.0;
    for (const Vec3& point : rig::limbPoints(trail_.limb, after_)) {
      below = std::max(below, *look_.lowestPlace_ - point.y);
    }
    if (below > margin) {
      findings_.lows.add(frame, below, below);
    }
  }

  // Of a body that stands: one that lies or stands on its head has everything above the head.
  void lookAtElbows(double frame, double margin) {
    const Head& head = *look_.head_;
    const double top = head.top(before_.worlds[at(head.joint)]);
    const double aboveHips = top - positionOf(before_.worlds[at(document_.body.hips)]).y;
    if (aboveHips < 0.5 * head.aboveHips) {
      return;
    }
    for (std::size_t i = 1; i < trail_.limb.joints.size(); ++i) {
      const std::size_t joint = at(trail_.limb.joints[i]);
      const double above = positionOf(after_.worlds[joint]).y - top;
      if (above > margin && positionOf(before_.worlds[joint]).y <= top) {
        findings_.elbows.add(frame, above, above);
      }
    }
  }

  [[nodiscard]] const skinning::SurfacePart& surface() const { return look_.surface_->part; }

  void lookAtSurface(double frame) {
    if (look_.surface_ == nullptr || surface().movedCount() == 0) {
      return;
    }
    to_ = surface().posed(after_);
    from_ = surface().posed(before_);
    lookAtVertices(frame);
    lookAtEdges(frame);
    lookAtGround(frame);
  }

  void lookAtGround(double frame) {
    ClipFacts& facts = *look_.facts_;
    if (facts.standing().flies) {
      return;
    }
    const double margin = placeMargin * height();
    const std::optional<Vec3> lowest = surface().lowest(to_, facts.groundAtMost() - margin);
    if (lowest && facts.ground() - lowest->y > margin && surface().lowest(from_)->y - lowest->y > margin) {
      const double below = facts.ground() - lowest->y;
      findings_.floors.add(frame, below, below);
    }
  }

  // A head reaches out beyond the end of its neck, and goes as much farther as it is away from the neck's
  // base: by a stretch, which takes it along, as by a turn. Its lever is that; 1 on other limbs.
  void lookAtVertices(double frame) {
    const Vec3 base = positionOf(before_.worlds[at(trail_.limb.joints.front())]);
    const double length = glm::distance(base, rig::leadingPosition(trail_.limb, before_));
    const bool hasHead = trail_.limb.kind == rig::LimbKind::neck && length > 0.0;
    const double most = std::max(room * findings_.tipDisplacement, 1e-4 * height());
    double farthest = most; // in lengths of its lever
    double carried = 0.0;
    const auto moves = surface().farthestMoves(from_, to_);
    std::vector<double> bounds(surface().slots().size(), 0.0);
    for (const auto& [bound, slot] : moves) {
      bounds[slot] = bound;
    }
    for (const auto& [ofSlot, slot] : moves) {
      if (ofSlot <= farthest) {
        break; // no lever makes it farther
      }
      for (const std::uint32_t vertex : surface().followersOf(slot)) {
        double bound = 0.0;
        for (const skinning::SurfacePart::Influence& one : surface().influencesOf(vertex)) {
          bound += std::abs(static_cast<double>(one.weight)) * bounds[one.slot];
        }
        if (bound <= farthest) {
          continue;
        }
        const glm::vec3 source = surface().place(vertex, from_);
        const double distance = distanceBetween(surface().place(vertex, to_), source);
        const double lever = hasHead ? std::max(1.0, glm::distance(base, Vec3(source)) / length) : 1.0;
        const double beside = distance / lever;
        carried = beside > farthest ? distance : carried;
        farthest = std::max(farthest, beside);
      }
    }
    if (farthest > most) {
      const double end =
          glm::length(rig::leadingPosition(trail_.limb, after_) - rig::leadingPosition(trail_.limb, before_));
      (farthest > room * end ? findings_.vertices : findings_.swings).add(frame, carried, farthest);
    }
  }

  void lookAtEdges(double frame) {
    const double most = std::max(longestEdge, room * trail_.settings.scale);
    double worst = 0.0;
    for (const std::uint32_t i : look_.surface_->edges.among(surface(), to_, most)) {
      const auto lengthIn = [&](const skinning::SurfacePart::Posed& posed) {
        const auto [moved, other] = surface().edges()[i];
        return distanceBetween(surface().place(moved, posed), surface().place(other, posed));
      };
      const double inBind = look_.surface_->edges.lengths()[i];
      const double after = lengthIn(to_);
      if (after <= BoundSurface::visibleLength * height() || after <= most * inBind) {
        continue;
      }
      const double own = std::max(inBind, lengthIn(from_));
      if (after > most * own) {
        worst = std::max(worst, after / std::max(own, 1e-9 * height()));
      }
    }
    if (worst > 0.0) {
      findings_.edges.add(frame, worst, worst);
    }
  }

  const TrailLook& look_;
  const Document& document_;
  const rig::MotionState& alone_;
  const rig::SolvedTrail& trail_;
  rig::PartMotion part_;
  std::optional<rig::MotionState> unstopped_; // without the stop, of a trail that has one
  std::optional<rig::PartMotion> unstoppedPart_;
  Findings findings_;
  FrameState before_;
  FrameState after_;
  skinning::SurfacePart::Posed from_; // of the surface in `before_`
  skinning::SurfacePart::Posed to_;   // and in `after_`
};

Findings TrailLook::findings(const rig::MotionState& alone) const {
  return Walk(*this, alone).all();
}

std::optional<double> TrailLook::foundAt(const rig::MotionState& alone,
                                         const std::vector<double>& likely) const {
  return Walk(*this, alone).foundAt(likely);
}

} // namespace stretch::app
