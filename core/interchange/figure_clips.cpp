#include "core/interchange/figure_clips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <assimp/scene.h>

#include "core/gltf/json/json.h"
#include "core/interchange/assimp_values.h"
#include "core/math/finite.h"

namespace stretch::interchange {

namespace {

using gltf::Json;

constexpr double nearShare = 1e-4; // Of the height: how far sampled motion may be from the file's.

template <typename Value>
struct ForeignKeys {
  std::vector<double> times; // Seconds, strictly increasing.
  std::vector<Value> values;
};

Vec3 between(const Vec3& a, const Vec3& b, double share) {
  return glm::mix(a, b, share);
}
Quat between(const Quat& a, const Quat& b, double share) {
  return glm::slerp(a, b, share);
}

template <typename Value>
Value valueAt(const ForeignKeys<Value>& keys, double time) {
  const auto after = std::ranges::upper_bound(keys.times, time);
  const auto index = static_cast<std::size_t>(after - keys.times.begin());
  if (index == 0 || index == keys.times.size()) {
    return index == 0 ? keys.values.front() : keys.values.back();
  }
  const double share = (time - keys.times[index - 1]) / (keys.times[index] - keys.times[index - 1]);
  return between(keys.values[index - 1], keys.values[index], share);
}

bool isSound(const Vec3& v) {
  return isFinite(v);
}
bool isSound(const Quat& q) {
  return std::isfinite(glm::dot(q, q)) && glm::dot(q, q) > 1e-12;
}
Vec3 settled(const Vec3& v, const Vec3& /*last*/) {
  return v;
}
Quat settled(const Quat& q, const Quat& last) {
  const Quat unit = glm::normalize(q);
  return glm::dot(unit, last) < 0.0 ? -unit : unit;
}

// Keys of the library, without those that are no numbers or do not come after the one before.
template <typename Value, typename Key, typename Convert>
ForeignKeys<Value> keysOf(const Key* keys, unsigned count, double secondsOfTick, const Convert& convert,
                          const Value& otherwise) {
  ForeignKeys<Value> made;
  for (unsigned i = 0; i < count; ++i) {
    const double time = keys[i].mTime * secondsOfTick;
    const Value value = convert(keys[i].mValue);
    if (std::isfinite(time) && isSound(value) && (made.times.empty() || time > made.times.back())) {
      made.values.push_back(settled(value, made.values.empty() ? value : made.values.back()));
      made.times.push_back(time);
    }
  }
  if (made.times.empty()) {
    made = {{0.0}, {otherwise}};
  }
  return made;
}

struct Driven {
  ForeignKeys<Vec3> translation;
  ForeignKeys<Quat> rotation;
  ForeignKeys<Vec3> scale;
};

Driven drivenBy(const aiNodeAnim& channel, const aiNode& node, double secondsOfTick) {
  const Transform rest = toTransform(restOf(node));
  return {keysOf<Vec3>(channel.mPositionKeys, channel.mNumPositionKeys, secondsOfTick, vectorOf,
                       rest.translation),
          keysOf<Quat>(channel.mRotationKeys, channel.mNumRotationKeys, secondsOfTick, quaternionOf,
                       rest.rotation),
          keysOf<Vec3>(channel.mScalingKeys, channel.mNumScalingKeys, secondsOfTick, vectorOf, rest.scale)};
}

Transform poseAt(const Driven& driven, double time) {
  return {valueAt(driven.translation, time), valueAt(driven.rotation, time), valueAt(driven.scale, time)};
}

// The same values all the time.
template <typename Value>
bool isStill(const std::vector<Value>& values, double tolerance) {
  return std::ranges::all_of(values, [&](const Value& value) {
    const auto apart = value - values.front();
    return glm::dot(apart, apart) <= tolerance * tolerance;
  });
}

bool isSimilarity(const Transform& t, const Mat4& matrix) {
  const Mat4 again = toMatrix(t);
  double apart = 0.0;
  for (int column = 0; column < 3; ++column) {
    apart = std::max(apart, glm::length(again[column] - matrix[column]));
  }
  const double size = std::abs(t.scale.x) + 1e-12;
  return apart < 1e-6 * size &&
         std::abs(t.scale.y - t.scale.x) + std::abs(t.scale.z - t.scale.x) < 1e-5 * size;
}

using NodesByName = std::unordered_map<std::string_view, const aiNode*>;

// Of nodes with one name the first on the way down.
NodesByName nodesByName(const aiNode& root) {
  NodesByName nodes;
  std::vector<const aiNode*> open{&root};
  while (!open.empty()) {
    const aiNode* const node = open.back();
    open.pop_back();
    nodes.try_emplace(node->mName.C_Str(), node);
    for (unsigned child = node->mNumChildren; child-- > 0;) {
      open.push_back(node->mChildren[child]);
    }
  }
  return nodes;
}

// One animation of the library as a glTF animation.
class ClipMaker {
public:
  ClipMaker(const aiAnimation& from, const aiScene& scene, const Figure& figure, GlbParts& parts,
            ClipNotes& notes)
      : from_(from), scene_(scene), figure_(figure), parts_(parts), notes_(notes),
        secondsOfTick_(from.mTicksPerSecond > 0.0 ? 1.0 / from.mTicksPerSecond : 1.0 / 25.0) {
    const NodesByName nodes = nodesByName(*scene.mRootNode);
    for (unsigned c = 0; c < from.mNumChannels; ++c) {
      const aiNodeAnim& channel = *from.mChannels[c];
      if (const auto node = nodes.find(channel.mNodeName.C_Str()); node != nodes.end()) {
        driven_.try_emplace(node->second, drivenBy(channel, *node->second, secondsOfTick_));
      }
    }
    // A clip that begins before 0 is brought to it: glTF has no such time.
    for (const auto& [node, driven] : driven_) {
      noteGaps(driven.translation);
      noteGaps(driven.rotation);
      start_ = std::min({start_, driven.translation.times.front(), driven.rotation.times.front(),
                         driven.scale.times.front()});
    }
    animation_ = {{"channels", Json::array()}, {"samplers", Json::array()}};
    // Collada counts in thousandths of a second, which are no frames.
    if (const double rate = std::round(1e3 / secondsOfTick_) / 1e3; rate < 1000.0) {
      const double whole = std::round(rate);
      animation_["extras"] = {
          {"stretch_engine", {{"frames_per_second", std::abs(rate - whole) < 1e-4 * rate ? whole : rate}}}};
    }
  }

  void name(const std::string& name) { animation_["name"] = name; }

  void addMotion() {
    const std::vector<Mat4> worlds = restWorlds(figure_);
    for (std::size_t i = 0; i < figure_.nodes.size(); ++i) {
      const FigureNode& node = figure_.nodes[i];
      const double size =
          node.parent < 0 ? 1.0 : toTransform(worlds[static_cast<std::size_t>(node.parent)]).scale.y;
      addNode(i, std::abs(size) > 1e-9 ? std::abs(size) : 1.0);
    }
  }

  void addWeights(const std::vector<int>& meshNodes) {
    for (unsigned c = 0; c < from_.mNumMorphMeshChannels; ++c) {
      const aiMeshMorphAnim& channel = *from_.mMorphMeshChannels[c];
      const std::string name =
          std::string(channel.mName.C_Str()).substr(0, std::string_view(channel.mName.C_Str()).find('*'));
      for (std::size_t m = 0; m < meshNodes.size(); ++m) {
        const int node = meshNodes[m];
        const bool isMeant = node >= 0 && (name == scene_.mMeshes[m]->mName.C_Str() ||
                                           name == figure_.nodes[static_cast<std::size_t>(node)].name);
        if (isMeant && scene_.mMeshes[m]->mNumAnimMeshes > 0) {
          addWeightTrack(channel, static_cast<std::size_t>(node), scene_.mMeshes[m]->mNumAnimMeshes);
          break;
        }
      }
    }
  }

  void finish() {
    if (!animation_["channels"].empty()) {
      parts_.add("animations", animation_);
      ++notes_.clips;
    }
  }

private:
  [[nodiscard]] const Driven* drivenOf(const aiNode& node) const {
    const auto found = driven_.find(&node);
    return found == driven_.end() ? nullptr : &found->second;
  }

  // Keys under the name of the node itself stand for its whole chain of pivots.
  [[nodiscard]] bool standsForChain(const FigureNode& node) const {
    return drivenOf(*node.chain.back()) != nullptr;
  }

  [[nodiscard]] Mat4 localAt(const FigureNode& node, double time) const {
    std::set<const aiNode*> replaced;
    const auto replace = [&](const FigureNode& one) {
      if (standsForChain(one)) {
        replaced.insert(one.chain.begin(), one.chain.end() - 1);
      }
    };
    replace(node);
    if (node.shedsScale) {
      replace(figure_.nodes[static_cast<std::size_t>(node.parent)]);
    }
    return localOf(figure_, node, [&](const aiNode& element) {
      const Driven* const driven = drivenOf(element);
      return replaced.contains(&element) ? Mat4(1.0)
             : driven != nullptr         ? toMatrix(poseAt(*driven, time))
                                         : restOf(element);
    });
  }

  void addNode(std::size_t index, double size) {
    const FigureNode& node = figure_.nodes[index];
    std::vector<const Driven*> all;
    for (const aiNode* const element : node.chain) {
      if (const Driven* const driven = drivenOf(*element)) {
        all.push_back(driven);
      }
    }
    const bool sheds = node.shedsScale && parentScales(node);
    if (all.empty() && !sheds) {
      return;
    }
    const Transform rest = toTransform(localOf(figure_, node, restOf));
    const std::optional<Driven> plain =
        all.size() == 1 && !sheds ? asPlain(node, *all.front()) : std::nullopt;
    const Driven made = plain ? *plain : sampled(node, all, size);
    addTrack(index, "translation", made.translation, 1e-7 * figure_.height / size);
    addTrack(index, "rotation", made.rotation, 1e-7);
    if (!isStill(made.scale.values, 1e-5) || glm::length(made.scale.values.front() - rest.scale) > 1e-5) {
      addTrack(index, "scale", made.scale, 1e-6);
    }
  }

  // With pivots the scale is an element of its own.
  bool parentScales(const FigureNode& node) const {
    bool scales = false;
    for (const aiNode* const element : figure_.nodes[static_cast<std::size_t>(node.parent)].chain) {
      const Driven* const own = drivenOf(*element);
      const std::vector<Vec3> values =
          own != nullptr ? own->scale.values : std::vector<Vec3>{toTransform(restOf(*element)).scale};
      scales = scales || !isStill(values, 1e-6) || glm::length(values.front() - Vec3(1.0)) > 1e-6;
      for (const Vec3& one : values) {
        notes_.hasUnevenShed =
            notes_.hasUnevenShed || std::abs(one.x - one.y) + std::abs(one.y - one.z) > 1e-4;
      }
    }
    return scales;
  }

  // Keys of one element with nothing but a similarity before it, and nothing behind, stay keys.
  std::optional<Driven> asPlain(const FigureNode& node, const Driven& driven) const {
    Mat4 first(1.0);
    bool isBehind = false;
    const bool isWhole = standsForChain(node);
    for (const aiNode* const element : node.chain) {
      if (drivenOf(*element) != nullptr) {
        isBehind = true;
      } else if (isBehind && restOf(*element) != Mat4(1.0)) {
        return std::nullopt;
      } else if (!isBehind && !isWhole) {
        first = first * restOf(*element);
      }
    }
    first[3] = Vec4(node.lengths * Vec3(first[3]), 1.0);
    const Mat4 whole = node.before * first;
    const Transform parts = toTransform(whole);
    if (!isSimilarity(parts, whole)) {
      return std::nullopt;
    }
    Driven made = driven;
    for (Vec3& value : made.translation.values) {
      value = transformPoint(whole, node.lengths * value);
    }
    for (Quat& value : made.rotation.values) {
      value = parts.rotation * value;
    }
    for (Vec3& value : made.scale.values) {
      value *= parts.scale.x;
    }
    return made;
  }

  void insertTimes(const Driven& driven, std::set<double>& times) const {
    times.insert(driven.translation.times.begin(), driven.translation.times.end());
    times.insert(driven.rotation.times.begin(), driven.rotation.times.end());
    times.insert(driven.scale.times.begin(), driven.scale.times.end());
  }

  Driven sampled(const FigureNode& node, const std::vector<const Driven*>& all, double size) const {
    std::set<double> times;
    for (const Driven* const driven : all) {
      insertTimes(*driven, times);
    }
    if (node.shedsScale) {
      for (const aiNode* const element : figure_.nodes[static_cast<std::size_t>(node.parent)].chain) {
        if (const Driven* const parent = drivenOf(*element)) {
          insertTimes(*parent, times);
        }
      }
    }
    Driven made;
    const Allowed allowed{nearShare * figure_.height / size, nearShare};
    for (auto time = times.begin(); time != times.end(); ++time) {
      const Transform pose = toTransform(localAt(node, *time));
      if (time != times.begin()) {
        constexpr int mostHalvings = 3; // Of one frame.
        addBetween(node, lastOf(made), {*time, pose}, allowed, mostHalvings, made);
      }
      push(*time, pose, made);
    }
    return made;
  }

  struct Allowed {
    double length = 0.0;
    double angle = 0.0;
  };

  struct PoseAt {
    double time = 0.0;
    Transform pose;
  };

  static PoseAt lastOf(const Driven& made) {
    return {made.translation.times.back(),
            {made.translation.values.back(), made.rotation.values.back(), made.scale.values.back()}};
  }

  static void push(double time, const Transform& pose, Driven& made) {
    const Quat turn =
        made.rotation.values.empty() ? pose.rotation : settled(pose.rotation, made.rotation.values.back());
    made.translation.times.push_back(time);
    made.rotation.times.push_back(time);
    made.scale.times.push_back(time);
    made.translation.values.push_back(pose.translation);
    made.rotation.values.push_back(turn);
    made.scale.values.push_back(pose.scale);
  }

  // Keys between two that are there, where the motion is not what glTF makes of those.
  void addBetween(const FigureNode& node, const PoseAt& start, const PoseAt& end, const Allowed& allowed,
                  int halvings, Driven& made) const {
    if (halvings == 0 || isStraight(node, start, end, allowed)) {
      return;
    }
    const int left = halvings - (end.time - start.time < 1.001 * secondsOfTick_ ? 1 : 0);
    const double time = middleOf(start.time, end.time);
    const PoseAt middle{time, toTransform(localAt(node, time))};
    addBetween(node, start, middle, allowed, left, made);
    push(middle.time, middle.pose, made);
    addBetween(node, middle, end, allowed, left, made);
  }

  // On a whole frame of the file where one is between.
  [[nodiscard]] double middleOf(double startTime, double endTime) const {
    const double middle = 0.5 * (startTime + endTime);
    const double frame = std::round(middle / secondsOfTick_) * secondsOfTick_;
    return frame > startTime + 1e-3 * secondsOfTick_ && frame < endTime - 1e-3 * secondsOfTick_ ? frame
                                                                                                : middle;
  }

  bool isStraight(const FigureNode& node, const PoseAt& from, const PoseAt& to,
                  const Allowed& allowed) const {
    const Transform& start = from.pose;
    const Transform& end = to.pose;
    for (const double share : {0.25, 0.5, 0.75}) {
      const Transform is = toTransform(localAt(node, from.time + share * (to.time - from.time)));
      const double turn = std::abs(glm::dot(is.rotation, glm::slerp(start.rotation, end.rotation, share)));
      const bool isNear = glm::length(is.translation - glm::mix(start.translation, end.translation, share)) <=
                              allowed.length &&
                          2.0 * std::acos(std::min(1.0, turn)) <= allowed.angle &&
                          glm::length(is.scale - glm::mix(start.scale, end.scale, share)) <= allowed.angle;
      if (!isNear) {
        return false;
      }
    }
    return true;
  }

  static void append(const Vec3& v, std::vector<float>& values) {
    values.insert(values.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
  }
  static void append(const Quat& q, std::vector<float>& values) {
    values.insert(values.end(), {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                                 static_cast<float>(q.w)});
  }
  static double apartOf(const Vec3& a, const Vec3& b) { return glm::length(a - b); }
  static double apartOf(const Quat& a, const Quat& b) {
    return glm::length(glm::dot(a, b) < 0.0 ? a + b : a - b);
  }

  // One key where nothing moves: the character that the clip is for may rest elsewhere.
  template <typename Value>
  void addTrack(std::size_t node, const char* path, const ForeignKeys<Value>& keys, double tolerance) {
    const bool still = isStill(keys.values, tolerance);
    std::vector<float> times;
    std::vector<float> values;
    for (std::size_t i = 0; i < (still ? 1 : keys.times.size()); ++i) {
      const auto time = static_cast<float>(keys.times[i] - start_);
      if (times.empty() || time > times.back()) {
        times.push_back(time);
        append(keys.values[i], values);
      }
    }
    addChannel(node, path, times, values, values.size() / times.size() == 4 ? "VEC4" : "VEC3");
  }

  // In the keys of the file: those that are made of them lie closer.
  template <typename Value>
  void noteGaps(const ForeignKeys<Value>& keys) {
    constexpr double moving = 1e-4;
    for (std::size_t i = 1; i < keys.times.size(); ++i) {
      const bool isWide = keys.times[i] - keys.times[i - 1] > 1.5 * secondsOfTick_;
      notes_.hasGaps = notes_.hasGaps || (isWide && apartOf(keys.values[i], keys.values[i - 1]) > moving);
    }
  }

  void addChannel(std::size_t node, const char* path, const std::vector<float>& times,
                  const std::vector<float>& values, const char* type) {
    const std::size_t input = parts_.addFloats(times, "SCALAR", true);
    const std::size_t output = parts_.addFloats(values, type);
    animation_["channels"].push_back(
        {{"sampler", animation_["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation_["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", "LINEAR"}});
  }

  void addWeightTrack(const aiMeshMorphAnim& channel, std::size_t node, std::size_t targets) {
    std::vector<float> times;
    std::vector<float> values;
    for (unsigned k = 0; k < channel.mNumKeys; ++k) {
      const aiMeshMorphKey& key = channel.mKeys[k];
      const auto time = static_cast<float>(key.mTime * secondsOfTick_ - start_);
      if (!std::isfinite(time) || time < 0.0F || (!times.empty() && time <= times.back())) {
        continue;
      }
      std::vector<float> weights(targets);
      for (unsigned v = 0; v < key.mNumValuesAndWeights; ++v) {
        if (key.mValues[v] < targets && std::isfinite(key.mWeights[v])) {
          weights[key.mValues[v]] = static_cast<float>(key.mWeights[v]);
        }
      }
      times.push_back(time);
      values.insert(values.end(), weights.begin(), weights.end());
    }
    if (!times.empty()) {
      // One number for each target and key: the accessor counts them all.
      addChannel(node, "weights", times, values, "SCALAR");
    }
  }

  const aiAnimation& from_;
  const aiScene& scene_;
  const Figure& figure_;
  GlbParts& parts_;
  ClipNotes& notes_;
  double secondsOfTick_;
  double start_ = 0.0;
  std::map<const aiNode*, Driven> driven_;
  Json animation_;
};

/// The name that the clip has in its file; where a program gave it to a file's only clip since nobody had,
/// the file's, which tells more of one clip among others. A program that passes a clip on writes it between
/// bars, after its armature's name and before that of its layer.
std::string clipName(const aiAnimation& clip, unsigned clips, const std::string& fileName) {
  constexpr std::array<std::string_view, 8> givenByPrograms{
      "", "Motion", "mixamo.com", "Take 001", "Take 01", "Default Take", "Unreal Take", "Animation"};
  const std::string_view name = clip.mName.C_Str();
  const std::size_t bar = name.find('|');
  const std::string_view part = bar == std::string_view::npos ? name : name.substr(bar + 1);
  const bool isGiven =
      std::ranges::find(givenByPrograms, part.substr(0, part.find('|'))) != givenByPrograms.end();
  return isGiven && clips == 1 ? fileName : std::string(name);
}

} // namespace

ClipNotes addClips(const aiScene& scene, const Figure& figure, const std::vector<int>& meshNodes,
                   const std::string& fileName, GlbParts& parts) {
  ClipNotes notes;
  for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
    ClipMaker clip(*scene.mAnimations[a], scene, figure, parts, notes);
    clip.name(clipName(*scene.mAnimations[a], scene.mNumAnimations, fileName));
    clip.addMotion();
    clip.addWeights(meshNodes);
    clip.finish();
  }
  return notes;
}

} // namespace stretch::interchange
