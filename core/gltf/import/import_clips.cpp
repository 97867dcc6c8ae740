#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/core.h>

#include "core/anim/track_names.h"
#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/animation_target.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

std::size_t morphTargetsOf(const Scene& scene, NodeIndex node) {
  const int mesh = scene.nodes[at(node)].mesh;
  return mesh < 0 ? 0 : scene.meshes[static_cast<std::size_t>(mesh)].morphWeights.size();
}

class ClipImport {
public:
  ClipImport(const Source& source, const Scene& scene, std::size_t index, DecodeBudget& budget,
             Problems& problems)
      : source_(source), scene_(scene), json_(element(source.json, "animations", index)),
        where_(at("animations", index)), budget_(budget), problems_(problems) {}

  Clip run(int sourceIndex) {
    Clip clip;
    clip.name = shownName(json_);
    clip.sourceIndex = sourceIndex;
    for (std::size_t i = 0; i < sizeOf(json_, "channels"); ++i) {
      if (std::optional<Track> track = trackOf(i)) {
        clip.tracks.emplace_back(*std::move(track));
      }
    }
    setEndsFromKeys(clip);
    clip.framesPerSecond = notedRate().value_or(guessFramesPerSecond(clip.tracks));
    return clip;
  }

private:
  // What this program noted where re-keyed clips tell another rate than they had.
  [[nodiscard]] std::optional<double> notedRate() const {
    const Json* noted = findPath(json_, {"extras", "stretch_engine", "frames_per_second"});
    const double rate = noted != nullptr && noted->is_number() ? noted->get<double>() : 0.0;
    return rate >= 1.0 && rate <= 1000.0 ? std::optional(rate) : std::nullopt;
  }

  [[nodiscard]] std::string channelPlace(std::size_t index) const { return at(where_ + ".channels", index); }

  std::optional<Track> trackOf(std::size_t index) {
    const Json& json = element(json_, "channels", index);
    const int sampler = indexOr(json, "sampler");
    if (sampler < 0 || static_cast<std::size_t>(sampler) >= sizeOf(json_, "samplers")) {
      problems_.error(channelPlace(index) + ".sampler", "refers to a sampler that is not there");
      return std::nullopt;
    }
    Track track;
    track.sourceChannel = static_cast<int>(index);
    if (!readTarget(*find(json, "target"), index, track) ||
        !readKeys(static_cast<std::size_t>(sampler), index, track)) {
      return std::nullopt;
    }
    return track;
  }

  // False for a channel that drives nothing we know (or repeats another, which is an error).
  bool readTarget(const Json& target, std::size_t index, Track& track) {
    const AnimationTarget driven = animationTarget(target);
    const std::string& path = driven.path;
    const std::optional<Channel> channel = channelNamed(path);
    track.node = driven.node;
    if (!channel || !track.node.exists() || at(track.node) >= scene_.nodes.size()) {
      problems_.warning(channelPlace(index),
                        driven.isPointer
                            ? fmt::format("drives '{}', which is not shown", path.substr(0, 100))
                            : fmt::format("drives '{}' of no node and is not shown", path.substr(0, 100)));
      return false;
    }
    track.channel = *channel;
    if (!targets_.insert({track.node, track.channel}).second) {
      problems_.error(channelPlace(index),
                      fmt::format("animates the {} of nodes[{}] a second time", path, track.node.value));
      return false;
    }
    const std::size_t targets = morphTargetsOf(scene_, track.node);
    if (track.channel == Channel::weights && targets == 0) {
      problems_.warning(channelPlace(index),
                        "drives morph weights of a node without morph targets and is not shown");
      return false;
    }
    if (track.channel != Channel::weights && scene_.nodes[at(track.node)].matrix) {
      problems_.warning(channelPlace(index), "animates a node that has a matrix; its parts are used");
    }
    const int vectorWidth = track.channel == Channel::rotation ? 4 : 3;
    track.width = track.channel == Channel::weights ? static_cast<int>(targets) : vectorWidth;
    return true;
  }

  Interpolation interpolationOf(const Json& sampler, const std::string& place) {
    const std::string name = textOr(sampler, "interpolation", "LINEAR");
    const std::optional<Interpolation> known = interpolationNamed(name);
    if (!known) {
      problems_.warning(place + ".interpolation", "is unknown; taken as LINEAR");
    }
    return known.value_or(Interpolation::linear);
  }

  bool readKeys(std::size_t samplerIndex, std::size_t channelIndex, Track& track) {
    const Json& sampler = element(json_, "samplers", samplerIndex);
    const std::string place = at(where_ + ".samplers", samplerIndex);
    track.interpolation = interpolationOf(sampler, place);
    const int input = indexOr(sampler, "input");
    const int output = indexOr(sampler, "output");
    const std::optional<std::size_t> keys = keysOf(input, place);
    if (!keys || !isOutput(*keys, output, channelIndex, track, place)) {
      return false;
    }
    if (input != timesInput_) { // most exporters give all tracks of a clip the same times
      times_ = readFloats(source_, input);
      timesInput_ = input;
    }
    track.times = times_;
    track.values = readFloats(source_, output);
    if (!std::ranges::all_of(track.values, [](float value) { return std::isfinite(value); })) {
      problems_.error(place + ".output", "holds values that are no finite numbers");
      return false;
    }
    warnOfStride(sampler, place);
    return repairTimes(track.times, input, place);
  }

  // How many keys there are; nothing where the accessor cannot hold their times.
  std::optional<std::size_t> keysOf(int accessor, const std::string& place) {
    const std::optional<AccessorShape> shape = shapeOf(source_, accessor);
    if (!shape || shape->type != "SCALAR" || shape->component != ComponentType::float32) {
      problems_.error(place + ".input", "is not an accessor of float scalars");
      return std::nullopt;
    }
    return shape->count;
  }

  bool isOutput(std::size_t keys, int output, std::size_t channelIndex, const Track& track,
                const std::string& place) {
    const std::optional<AccessorShape> shape = shapeOf(source_, output);
    const bool isVector = track.channel != Channel::weights;
    const std::string vectorType = track.width == 4 ? "VEC4" : "VEC3";
    const bool isInteger = shape && shape->component != ComponentType::float32;
    const bool mayBeInteger = shape && shape->isNormalized && shape->component != ComponentType::uint32 &&
                              (track.channel == Channel::rotation || track.channel == Channel::weights);
    if (!shape || shape->type != (isVector ? vectorType : "SCALAR") || (isInteger && !mayBeInteger)) {
      problems_.error(place + ".output",
                      fmt::format("its accessor has a type that {} cannot use", channelPlace(channelIndex)));
      return false;
    }
    const std::size_t perKey = (track.interpolation == Interpolation::cubicSpline ? 3U : 1U) *
                               (isVector ? 1U : static_cast<std::size_t>(track.width));
    if (shape->count != keys * perKey) {
      problems_.error(place + ".output", fmt::format("has {} values for {} keys, which need {}", shape->count,
                                                     keys, keys * perKey));
      return false;
    }
    if (!budget_.take(keys + shape->count * static_cast<std::size_t>(shape->width))) {
      problems_.error(place, "the animations decode to more data than the program takes into memory");
      return false;
    }
    return true;
  }

  void warnOfStride(const Json& sampler, const std::string& place) {
    for (const char* end : {"input", "output"}) {
      const Json& accessor =
          element(source_.json, "accessors", static_cast<std::size_t>(indexOr(sampler, end)));
      const int view = indexOr(accessor, "bufferView");
      if (view >= 0 && find(element(source_.json, "bufferViews", static_cast<std::size_t>(view)),
                            "byteStride") != nullptr) {
        problems_.warning(place, "reads a strided buffer view, which glTF does not allow");
        return;
      }
    }
  }

  [[nodiscard]] bool hasData(int accessor) const {
    const Json& json = element(source_.json, "accessors", static_cast<std::size_t>(accessor));
    return find(json, "bufferView") != nullptr || find(json, "sparse") != nullptr;
  }

  // Keys at one time are moved apart by the smallest step, so that the value still jumps there.
  bool repairTimes(std::vector<float>& times, int input, const std::string& place) {
    const bool isFinite = std::ranges::all_of(times, [](float time) { return std::isfinite(time); });
    if (!isFinite || !std::is_sorted(times.begin(), times.end())) {
      problems_.error(place + ".input", "its key times go backwards or are no numbers");
      return false;
    }
    if (times.front() < 0.0F) {
      problems_.violation(place + ".input", "has key times before 0");
    }
    if (std::adjacent_find(times.begin(), times.end()) == times.end()) {
      return true;
    }
    // An accessor without data is all zeros, which glTF does not forbid here.
    if (hasData(input)) {
      problems_.violation(place + ".input", "has several keys at the same time", "they are moved apart");
    } else {
      problems_.warning(place + ".input", "has no data: all its keys are at 0");
    }
    for (std::size_t i = 1; i < times.size(); ++i) {
      times[i] = std::max(times[i], std::nextafter(times[i - 1], std::numeric_limits<float>::max()));
    }
    return true;
  }

  const Source& source_;
  const Scene& scene_;
  const Json& json_;
  std::string where_;
  DecodeBudget& budget_;
  Problems& problems_;
  std::set<std::pair<NodeIndex, Channel>> targets_;
  int timesInput_ = -1;
  std::vector<float> times_; // of the accessor timesInput_
};

} // namespace

std::vector<Clip> importClips(const Source& source, const Scene& scene, Problems& problems) {
  DecodeBudget budget(source);
  std::vector<Clip> clips;
  for (std::size_t i = 0; i < sizeOf(source.json, "animations"); ++i) {
    clips.push_back(ClipImport(source, scene, i, budget, problems).run(static_cast<int>(i)));
  }
  return clips;
}

} // namespace stretch::gltf
