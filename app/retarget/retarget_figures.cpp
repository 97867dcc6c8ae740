#include "app/retarget/retarget_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/retarget/body_touch.h"
#include "core/anim/frames.h"
#include "core/anim/sampling.h"
#include "core/gltf/json/json.h"
#include "rig/retarget/joined_hands.h"
#include "rig/retarget/standing.h"

namespace stretch::app {

namespace {

constexpr double mostMeasured = 20000.0;
constexpr double touchingAt = 0.01; // of the height

// A point of a foot: the ankle, or the ball.
struct FootPoint {
  std::size_t side = 0;
  bool isBall = false;
  std::vector<rig::Stand> stands; // of the source's
};

struct TouchTime {
  double seconds = 0.0;
  std::array<bool, 2> trunk{false, false}; // the source's hands at its trunk or head
  bool hands = false;                      // at each other
};

FrameState shownAt(const PlayedClip& played, double seconds) {
  const Scene& scene = *played.skeleton.scene;
  return frameOf(scene, samplePose(scene, played.clip, seconds), seconds);
}

Vec3 placeOf(const FootPoint& point, const rig::Skeleton& skeleton, const std::vector<Mat4>& worlds) {
  const rig::SkeletonLeg& leg = skeleton.legs[point.side];
  return point.isBall ? leg.ball(worlds) : rig::endPosition(leg.limb, worlds);
}

// Stands without the frames of others, of three frames at least: a heel that turns about a ball that stands
// does not slide.
std::vector<rig::Stand> without(const std::vector<rig::Stand>& stands,
                                const std::vector<rig::Stand>& others) {
  constexpr std::size_t fewest = 3;
  std::vector<rig::Stand> kept;
  for (const rig::Stand& stand : stands) {
    std::size_t first = stand.first;
    const auto keep = [&](std::size_t past) {
      if (past >= first + fewest) {
        kept.push_back({first, past - 1});
      }
    };
    for (const rig::Stand& other : others) {
      if (other.last >= first && other.first <= stand.last) {
        keep(other.first);
        first = other.last + 1;
      }
    }
    keep(stand.last + 1);
  }
  return kept;
}

class RetargetMeasuring {
public:
  explicit RetargetMeasuring(const PlayedClip& source)
      : source_(source), touch_(source.skeleton), shoulders_(rig::shoulderWidth(source.skeleton)) {
    const std::size_t last = static_cast<std::size_t>(std::min(mostMeasured, lastFrame(source.clip)));
    for (std::size_t frame = 0; frame <= last; ++frame) {
      times_.push_back(static_cast<double>(frame) / source.clip.framesPerSecond);
    }
    findStands();
    findTouch();
    findJoinedHands();
  }

  [[nodiscard]] RetargetFigures of(const PlayedClip& played) const {
    RetargetFigures figures;
    figures.slide = slideOf(played);
    figures.hands = handsOf(played);
    const BodyTouch touch(played.skeleton);
    if (touch.hasSurface()) {
      measureTouch(played, touch, figures);
    }
    if (vertexCount(*played.skeleton.scene) > 0) {
      figures.below = belowFloor(*played.skeleton.scene, played.clip);
      figures.floor = figures.below.depth / played.skeleton.height;
    }
    return figures;
  }

private:
  [[nodiscard]] std::vector<std::vector<Vec3>> feetOf(const PlayedClip& played) const {
    std::vector<std::vector<Vec3>> feet(points_.size());
    for (const double seconds : times_) {
      const FrameState frame = shownAt(played, seconds);
      for (std::size_t i = 0; i < points_.size(); ++i) {
        feet[i].push_back(placeOf(points_[i], played.skeleton, frame.worlds));
      }
    }
    return feet;
  }

  void findStands() {
    points_ = {{rig::leftSide, false, {}},
               {rig::leftSide, true, {}},
               {rig::rightSide, false, {}},
               {rig::rightSide, true, {}}};
    const std::vector<std::vector<Vec3>> feet = feetOf(source_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      points_[i].stands = rig::standingIn(feet[i], source_.clip.framesPerSecond, source_.skeleton.height);
    }
    for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
      points_[2 * side].stands = without(points_[2 * side].stands, points_[2 * side + 1].stands);
    }
  }

  void findTouch() {
    constexpr std::size_t most = 24;
    const std::size_t step = (times_.size() + most - 1) / most;
    const double near = touchingAt * source_.skeleton.height;
    for (std::size_t frame = 0; frame < times_.size(); frame += step) {
      TouchTime time{times_[frame]};
      if (touch_.hasSurface()) {
        const HandDistances distances = touch_.handsAt(shownAt(source_, time.seconds));
        for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
          time.trunk[side] = distances.toTrunk[side].value_or(near) < near;
        }
        time.hands = distances.toOther.value_or(near) < near;
      }
      touchTimes_.push_back(time);
    }
  }

  void findJoinedHands() {
    constexpr double fully = 0.99; // of the share
    for (std::size_t frame = 0; shoulders_ && frame < times_.size(); ++frame) {
      const rig::JoinedHands hands =
          rig::joinedHands(source_.skeleton, shownAt(source_, times_[frame]).worlds, *shoulders_);
      if (hands.share > fully) {
        joined_.emplace_back(times_[frame], glm::length(hands.leftToRight));
      }
    }
  }

  [[nodiscard]] std::optional<double> slideOf(const PlayedClip& played) const {
    std::optional<double> slide;
    std::vector<std::vector<Vec3>> feet = feetOf(played);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (Vec3& place : feet[i]) {
        place.y = 0.0;
      }
      for (const rig::Stand& stand : points_[i].stands) {
        slide = std::max(slide.value_or(0.0), rig::wanderIn(feet[i], stand) / played.skeleton.height);
      }
    }
    return slide;
  }

  [[nodiscard]] std::optional<double> handsOf(const PlayedClip& played) const {
    const std::optional<double> width = rig::shoulderWidth(played.skeleton);
    std::optional<double> farthest;
    for (const auto& [seconds, apart] : joined_) {
      if (width) {
        const rig::JoinedHands hands =
            rig::joinedHands(played.skeleton, shownAt(played, seconds).worlds, *width);
        farthest = std::max(farthest.value_or(0.0), std::abs(glm::length(hands.leftToRight) - apart));
      }
    }
    return farthest;
  }

  void measureTouch(const PlayedClip& played, const BodyTouch& touch, RetargetFigures& figures) const {
    double share = 0.0;
    double deepest = 0.0;
    double distance = 0.0;
    std::size_t touches = 0;
    std::optional<double> held;
    const auto add = [&](bool isTouching, const std::optional<double>& far) {
      if (isTouching && far) {
        distance += *far;
        ++touches;
      }
    };
    for (const TouchTime& time : touchTimes_) {
      const FrameState frame = shownAt(played, time.seconds);
      const Inside inside = touch.insideAt(frame);
      share += inside.share;
      deepest = std::max(deepest, inside.deepest);
      held = std::max(held, inside.heldDeepest); // Nothing is less than any depth.
      if (time.trunk[0] || time.trunk[1] || time.hands) {
        const HandDistances hands = touch.handsAt(frame);
        add(time.trunk[rig::leftSide], hands.toTrunk[rig::leftSide]);
        add(time.trunk[rig::rightSide], hands.toTrunk[rig::rightSide]);
        add(time.hands, hands.toOther);
      }
    }
    figures.inside = share / static_cast<double>(touchTimes_.size());
    figures.deepest = deepest / played.skeleton.height;
    figures.held = held ? std::optional(*held / played.skeleton.height) : std::nullopt;
    if (touches > 0) {
      figures.contact = distance / static_cast<double>(touches) / played.skeleton.height;
    }
  }

  const PlayedClip& source_;
  BodyTouch touch_;
  std::optional<double> shoulders_;
  std::vector<double> times_;
  std::vector<FootPoint> points_;
  std::vector<TouchTime> touchTimes_;
  std::vector<std::pair<double, double>> joined_; // seconds, widths of the shoulders
};

// A figure as it is told.
struct ToldFigure {
  const char* key;
  const char* words;
  const char* unit;
  std::optional<double> RetargetFigures::*value;
  double factor;
  double seen; ///< What is less than this above the source's is not seen.
};

constexpr double percent = 100.0;
constexpr double tallCentimetres = 170.0;
constexpr std::array<ToldFigure, 7> toldFigures{
    {{"slide_percent", "feet that stand slide", "% of the height", &RetargetFigures::slide, percent, 0.005},
     {"contact_cm", "hands that touch are off by", "cm at 1.7 m", &RetargetFigures::contact, tallCentimetres,
      0.021},
     {"inside_percent", "inside trunk and head are", "% of forearms, hands, shins and feet",
      &RetargetFigures::inside, percent, 0.02},
     {"deepest_percent", "arms or legs are inside trunk or head by up to", "% of the height",
      &RetargetFigures::deepest, percent, 0.01},
     {"held_percent", "what the hands hold is inside trunk or head by up to", "% of the height",
      &RetargetFigures::held, percent, 0.05},
     {"floor_percent", "the body is below the floor by up to", "% of the height", &RetargetFigures::floor,
      percent, 0.005},
     {"hands_widths", "hands that work together are off by", "widths of the shoulders",
      &RetargetFigures::hands, 1.0, 0.05}}};

gltf::Json figuresToJson(const RetargetFigures& figures) {
  gltf::Json json;
  for (const ToldFigure& told : toldFigures) {
    const std::optional<double>& value = figures.*told.value;
    json[told.key] = value ? gltf::Json(told.factor * *value) : gltf::Json();
  }
  json["slide_cm"] = figures.slide ? gltf::Json(tallCentimetres * *figures.slide) : gltf::Json();
  return json;
}

} // namespace

RetargetReport retargetReport(const PlayedClip& source, const PlayedClip& mapped, const PlayedClip& result) {
  const RetargetMeasuring measuring(source);
  return {measuring.of(source), measuring.of(mapped), measuring.of(result)};
}

gltf::Json reportToJson(const RetargetReport& report) {
  return {{"source", figuresToJson(report.source)},
          {"mapped", figuresToJson(report.mapped)},
          {"result", figuresToJson(report.result)}};
}

std::vector<std::string> reportLines(const RetargetReport& report) {
  std::vector<std::string> lines;
  for (const ToldFigure& told : toldFigures) {
    const auto textOf = [&](const RetargetFigures& figures) {
      const std::optional<double>& value = figures.*told.value;
      return value ? fmt::format("{:.2f}", told.factor * *value) : std::string("none");
    };
    if (report.result.*told.value) {
      lines.push_back(fmt::format("{} {} {} (as mapped {}, source {})", told.words, textOf(report.result),
                                  told.unit, textOf(report.mapped), textOf(report.source)));
    }
  }
  return lines;
}

std::vector<std::string> worseLines(const RetargetReport& report) {
  std::vector<std::pair<double, std::string>> found;
  for (const ToldFigure& told : toldFigures) {
    const double result = (report.result.*told.value).value_or(0.0);
    const double source = (report.source.*told.value).value_or(0.0);
    if (result > source + told.seen) {
      found.emplace_back((result - source) / told.seen,
                         fmt::format("{} {:.2g} {} ({:.2g} in the source)", told.words, told.factor * result,
                                     told.unit, told.factor * source));
    }
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, &std::pair<double, std::string>::first);
  std::vector<std::string> lines;
  lines.reserve(found.size());
  for (auto& [excess, line] : found) {
    lines.push_back(std::move(line));
  }
  return lines;
}

} // namespace stretch::app
