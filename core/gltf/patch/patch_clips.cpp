#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/type_ptr.hpp>

#include "core/anim/track_names.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/patch_parts.h"
#include "core/gltf/source/animation_target.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

using Pointer = Json::json_pointer;

const char* outputType(Channel channel) {
  if (channel == Channel::weights) {
    return "SCALAR";
  }
  return channel == Channel::rotation ? "VEC4" : "VEC3";
}

// Animation works on translation, rotation and scale: a matrix gives way to them.
void splitMatrix(NodeIndex node, Journal& journal) {
  const Pointer pointer = Pointer("/nodes") / at(node);
  const std::vector<double> numbers = numbersOf(journal.json().at(pointer), "matrix");
  if (numbers.size() != 16) {
    return;
  }
  const Transform parts = toTransform(glm::make_mat4(numbers.data()));
  journal.erase(pointer / "matrix");
  journal.set(pointer / "translation", {parts.translation.x, parts.translation.y, parts.translation.z});
  journal.set(pointer / "rotation", {parts.rotation.x, parts.rotation.y, parts.rotation.z, parts.rotation.w});
  journal.set(pointer / "scale", {parts.scale.x, parts.scale.y, parts.scale.z});
}

class ClipPatch {
public:
  ClipPatch(Journal& journal, AppendedData& data) : journal_(journal), data_(data) {}

  void add(int clip, const Track& track) {
    const Pointer animation = Pointer("/animations") / static_cast<std::size_t>(clip);
    const auto width = static_cast<std::size_t>(track.channel == Channel::weights ? 1 : track.width);
    const std::size_t output =
        data_.add(AppendedData::Use::animation, outputType(track.channel), width, track.values, false);
    Json sampler = {
        {"input", inputOf(track.times)}, {"interpolation", nameOf(track.interpolation)}, {"output", output}};
    const std::size_t index = journal_.append(animation / "samplers", std::move(sampler));
    point(animation, track, index);
    if (track.channel != Channel::weights) {
      splitMatrix(track.node, journal_);
    }
  }

private:
  std::size_t inputOf(const std::vector<float>& times) {
    const auto known = inputs_.find(times);
    if (known != inputs_.end()) {
      return known->second;
    }
    const std::size_t accessor = data_.add(AppendedData::Use::animation, "SCALAR", 1, times, true);
    inputs_.emplace(times, accessor);
    return accessor;
  }

  // A file that names a target twice in one animation is not opened.
  void point(const Pointer& animation, const Track& track, std::size_t sampler) {
    const std::string path = nameOf(track.channel);
    const Target target{track.node.value, path};
    ChannelOfTarget& known = channelsOf(animation);
    if (const auto driving = known.find(target); driving != known.end()) {
      journal_.set(animation / "channels" / driving->second / "sampler", sampler);
    } else {
      Json channel = {{"sampler", sampler}, {"target", {{"node", track.node.value}, {"path", path}}}};
      known[target] = journal_.append(animation / "channels", std::move(channel));
    }
  }

  using Target = std::pair<int, std::string>;
  using ChannelOfTarget = std::map<Target, std::size_t>;

  // The channels of an animation by what they drive, told once: a clip may have thousands.
  ChannelOfTarget& channelsOf(const Pointer& animation) {
    const auto [known, isNew] = channels_.try_emplace(animation.to_string());
    if (isNew) {
      const Json& json = journal_.json().at(animation);
      for (std::size_t i = 0; i < sizeOf(json, "channels"); ++i) {
        const AnimationTarget driven = animationTarget(*find(element(json, "channels", i), "target"));
        known->second[{driven.node.value, driven.path}] = i;
      }
    }
    return known->second;
  }

  Journal& journal_;
  AppendedData& data_;
  std::map<std::vector<float>, std::size_t> inputs_;
  std::map<std::string, ChannelOfTarget> channels_; // by the animation's place
};

// Extras that are no object are someone else's: they stay as they are.
void noteRate(const ClipTracks& clip, Journal& journal) {
  const Pointer extras = Pointer("/animations") / static_cast<std::size_t>(clip.clip) / "extras";
  const bool has = journal.json().contains(extras);
  if (!(clip.framesPerSecond > 0.0) || (has && !journal.json().at(extras).is_object())) {
    return;
  }
  if (!has) {
    journal.set(extras, Json::object());
  }
  journal.set(extras / "stretch_engine", {{"frames_per_second", clip.framesPerSecond}});
}

} // namespace

void patchClips(const std::vector<ClipTracks>& clips, Journal& journal, AppendedData& data) {
  ClipPatch patch(journal, data);
  for (const ClipTracks& clip : clips) {
    for (const Track& track : clip.tracks) {
      patch.add(clip.clip, track);
    }
    noteRate(clip, journal);
  }
}

} // namespace stretch::gltf
