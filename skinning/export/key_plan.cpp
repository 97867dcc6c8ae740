#include "skinning/export/key_plan.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/base/check.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "skinning/export/posed_probes.h"

namespace stretch::skinning {
namespace {

/// Bytes of a time, and about those of the JSON that describes times which nothing else shares.
constexpr std::size_t bytesOfTime = 4;
constexpr std::size_t bytesOfOwnTimes = 230;

Quat quatOf(const Vec4& v) {
  return glm::normalize(Quat(v.w, v.x, v.y, v.z));
}

/// As readers interpolate: rotations along the shorter arc.
Vec4 between(Channel channel, const Vec4& a, const Vec4& b, double share) {
  if (channel != Channel::rotation) {
    return glm::mix(a, b, share);
  }
  const Quat q = glm::slerp(quatOf(a), quatOf(b), share);
  return {q.x, q.y, q.z, q.w};
}

/// The samplers of a clip with a key for every frame.
std::vector<ClipCourse> coursesOf(const gltf::Source& source, const Clip& clip, std::size_t frames) {
  const gltf::Json& animation = (*source.json)["animations"][0];
  std::vector<ClipCourse> courses(animation["samplers"].size());
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    ClipCourse& course =
        courses[animation["channels"][at(track->sourceChannel)]["sampler"].get<std::size_t>()];
    check(track->times.size() == frames, "a key for every frame");
    course.channel = track->channel;
    course.nodes.push_back(at(track->node));
    course.values.clear();
    const auto width = static_cast<std::size_t>(track->width);
    for (std::size_t k = 0; k < frames; ++k) {
      Vec4 value(0.0);
      for (std::size_t i = 0; i < width; ++i) {
        value[static_cast<glm::length_t>(i)] = static_cast<double>(track->values[k * width + i]);
      }
      course.values.push_back(value);
    }
  }
  return courses;
}

/// Bytes of the value of each sampler.
std::vector<std::size_t> valueBytesOf(const gltf::Source& source) {
  const gltf::Json& json = source.json;
  std::vector<std::size_t> bytes;
  for (const gltf::Json& sampler : json["animations"][0]["samplers"]) {
    const gltf::Json& accessor = json["accessors"][sampler["output"].get<std::size_t>()];
    const std::size_t numbers = accessor["type"] == "VEC4" ? 4 : 3;
    constexpr int floats = 5126;
    bytes.push_back(numbers * (accessor["componentType"] == floats ? 4 : 2));
  }
  return bytes;
}

class KeyThinner {
public:
  KeyThinner(PosedProbes probes, std::vector<std::size_t> valueBytes, double bound)
      : probes_(std::move(probes)), valueBytes_(std::move(valueBytes)), bound_(bound) {
    std::vector<std::size_t> every(probes_.frameCount());
    std::iota(every.begin(), every.end(), std::size_t{0});
    plan_.assign(probes_.courses().size(), every);
  }

  [[nodiscard]] const KeyPlan& plan() const { return plan_; }

  /// Courses that can stand still within a share of the bound, the least harmful first. False when stopped;
  /// so the others.
  bool holdStill(double share, const Proceed& proceed) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t c = 0; c < plan_.size(); ++c) {
      order.emplace_back(harmOfStanding(c, share * bound_), c);
      if (proceed && !proceed(static_cast<double>(c) / static_cast<double>(plan_.size()))) {
        return false;
      }
    }
    std::ranges::sort(order);
    for (const auto& [harm, course] : order) {
      if (harm <= share * bound_ && harmOfStanding(course, share * bound_) <= share * bound_) {
        const PosedProbes::Group group = probes_.groupOf({course});
        const std::size_t frame = middleFrame(course);
        for (std::size_t k = 0; k < probes_.frameCount(); ++k) {
          probes_.set(k, group, {probes_.courses()[course].values[frame]});
        }
        plan_[course] = {frame};
      }
    }
    return true;
  }

  /// Leaves out keys of courses that share theirs.
  bool thin(const std::vector<std::vector<std::size_t>>& shared, const Proceed& proceed) {
    constexpr std::array<double, 9> shares{0.05, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 1.0};
    std::vector<PosedProbes::Group> groups;
    groups.reserve(shared.size());
    for (const std::vector<std::size_t>& courses : shared) {
      groups.push_back(probes_.groupOf(moving(courses)));
    }
    for (std::size_t s = 0; s < shares.size(); ++s) {
      for (const PosedProbes::Group& group : groups) {
        if (!group.courses.empty()) {
          thinOnce(group, shares[s] * bound_);
        }
      }
      if (proceed && !proceed(static_cast<double>(s + 1) / static_cast<double>(shares.size()))) {
        return false;
      }
    }
    for (const PosedProbes::Group& group : groups) {
      restoreWhereNothingIsSaved(group);
    }
    return true;
  }

  /// Of values, times and what describes them; courses with all keys share their times.
  [[nodiscard]] std::size_t bytes() const {
    std::map<std::vector<std::size_t>, std::size_t> times;
    std::size_t sum = 0;
    for (std::size_t c = 0; c < plan_.size(); ++c) {
      if (plan_[c].size() > 1) {
        sum += plan_[c].size() * valueBytes_[c];
        times[plan_[c]] = plan_[c].size() * bytesOfTime + bytesOfOwnTimes;
      }
    }
    return std::accumulate(times.begin(), times.end(), sum,
                           [](std::size_t total, const auto& one) { return total + one.second; });
  }

private:
  [[nodiscard]] std::vector<std::size_t> moving(const std::vector<std::size_t>& courses) const {
    std::vector<std::size_t> found;
    std::ranges::copy_if(courses, std::back_inserter(found),
                         [&](std::size_t c) { return plan_[c].size() > 1; });
    return found;
  }

  /// The frame whose value lies nearest to the mean.
  [[nodiscard]] std::size_t middleFrame(std::size_t course) const {
    const std::vector<Vec4>& values = probes_.courses()[course].values;
    const Vec4 mean =
        std::accumulate(values.begin(), values.end(), Vec4(0.0)) / static_cast<double>(values.size());
    const auto nearest = std::ranges::min_element(values, [&](const Vec4& a, const Vec4& b) {
      return glm::distance(a, mean) < glm::distance(b, mean);
    });
    return static_cast<std::size_t>(nearest - values.begin());
  }

  [[nodiscard]] double harmOfStanding(std::size_t course, double enough) const {
    const PosedProbes::Group group = probes_.groupOf({course});
    const std::vector<Vec4> value{probes_.courses()[course].values[middleFrame(course)]};
    double harm = 0.0;
    for (std::size_t k = 0; k < probes_.frameCount() && harm <= enough; ++k) {
      harm = std::max(harm, probes_.farthest(k, group, value, enough));
    }
    return harm;
  }

  [[nodiscard]] std::vector<Vec4> valuesBetween(const PosedProbes::Group& group, std::size_t from,
                                                std::size_t to, std::size_t frame) const {
    const double share = static_cast<double>(frame - from) / static_cast<double>(to - from);
    std::vector<Vec4> values;
    for (const std::size_t c : group.courses) {
      const ClipCourse& course = probes_.courses()[c];
      values.push_back(between(course.channel, course.values[from], course.values[to], share));
    }
    return values;
  }

  [[nodiscard]] bool canSpan(const PosedProbes::Group& group, std::size_t from, std::size_t to,
                             double bound) const {
    for (std::size_t k = from + 1; k < to; ++k) {
      if (probes_.farthest(k, group, valuesBetween(group, from, to, k), bound) > bound) {
        return false;
      }
    }
    return true;
  }

  /// One way over the keys; of two neighbours at most one goes.
  void thinOnce(const PosedProbes::Group& group, double bound) {
    std::vector<std::size_t> keys = plan_[group.courses.front()];
    for (std::size_t j = 1; j + 1 < keys.size(); ++j) {
      if (!canSpan(group, keys[j - 1], keys[j + 1], bound)) {
        continue;
      }
      for (std::size_t k = keys[j - 1] + 1; k < keys[j + 1]; ++k) {
        probes_.set(k, group, valuesBetween(group, keys[j - 1], keys[j + 1], k));
      }
      keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(j));
    }
    for (const std::size_t c : group.courses) {
      plan_[c] = keys;
    }
  }

  void restoreWhereNothingIsSaved(const PosedProbes::Group& group) {
    const std::size_t frames = probes_.frameCount();
    std::size_t perKey = 0;
    for (const std::size_t c : group.courses) {
      perKey += valueBytes_[c];
    }
    if (group.courses.empty() ||
        plan_[group.courses.front()].size() * (perKey + bytesOfTime) + bytesOfOwnTimes < frames * perKey) {
      return;
    }
    std::vector<std::size_t> every(frames);
    std::iota(every.begin(), every.end(), std::size_t{0});
    for (std::size_t k = 0; k < frames; ++k) {
      std::vector<Vec4> values;
      for (const std::size_t c : group.courses) {
        values.push_back(probes_.courses()[c].values[k]);
      }
      probes_.set(k, group, values);
    }
    for (const std::size_t c : group.courses) {
      plan_[c] = every;
    }
  }

  PosedProbes probes_;
  std::vector<std::size_t> valueBytes_;
  double bound_;
  KeyPlan plan_;
};

/// Courses that may share their keys: each by itself, those of a bone and its stretch, all of them.
std::vector<std::vector<std::vector<std::size_t>>> waysToShare(const Scene& scene,
                                                               const std::vector<ClipCourse>& courses) {
  std::vector<std::vector<std::size_t>> own;
  std::vector<std::size_t> all;
  std::map<std::size_t, std::vector<std::size_t>> ofBone;
  for (std::size_t c = 0; c < courses.size(); ++c) {
    const std::size_t node = courses[c].nodes.front();
    const Node& n = scene.nodes[node];
    const bool isStretch = courses[c].channel != Channel::translation && n.name.starts_with("stretch_");
    ofBone[isStretch ? at(n.parent) : node].push_back(c);
    own.push_back({c});
    all.push_back(c);
  }
  std::vector<std::vector<std::size_t>> bones;
  bones.reserve(ofBone.size());
  for (const auto& [node, group] : ofBone) {
    bones.push_back(group);
  }
  return {own, bones, {all}};
}

} // namespace

std::optional<KeyPlan> planKeys(const gltf::Source& everyKey, std::size_t frames, double bound,
                                const std::vector<std::size_t>& also, const Proceed& proceed) {
  gltf::Problems problems;
  const Scene scene = gltf::importScene(everyKey, problems, gltf::Pictures::headers);
  const std::vector<Clip> clips = gltf::importClips(everyKey, scene, problems);
  check(!problems.hasErrors(), "what this program writes, it can read");
  if (clips.empty()) {
    return KeyPlan{}; // nothing moves
  }
  const std::vector<ClipCourse> courses = coursesOf(everyKey, clips.front(), frames);
  const KeyThinner start(PosedProbes(scene, courses, frames, also), valueBytesOf(everyKey), bound);
  KeyThinner best = start;
  constexpr std::array<double, 3> standing{0.0, 0.4, 0.8};
  const auto ways = waysToShare(scene, courses);
  const auto trials = static_cast<double>(standing.size() * (ways.size() + 1));
  double done = 0.0;
  const Proceed part = [&](double share) { return !proceed || proceed((done + share) / trials); };
  for (const double share : standing) {
    KeyThinner still = start;
    if (!still.holdStill(share, part)) {
      return std::nullopt;
    }
    done += 1.0;
    for (const auto& way : ways) {
      KeyThinner tried = still;
      if (!tried.thin(way, part)) {
        return std::nullopt;
      }
      done += 1.0;
      if (tried.bytes() < best.bytes()) {
        best = tried;
      }
    }
  }
  return best.plan();
}

} // namespace stretch::skinning
