#include <algorithm>

#include "app/document.h"
#include "app/things/thing.h"

namespace stretch::app {

namespace {

template <typename Values>
std::size_t bytesOf(const Values& values) {
  return values.size() * sizeof(typename Values::value_type);
}

// What each of the values holds beside itself, and they themselves.
template <typename Values, typename Inner>
std::size_t bytesOf(const Values& values, const Inner& inner) {
  std::size_t bytes = bytesOf(values);
  for (const auto& value : values) {
    bytes += inner(value);
  }
  return bytes;
}

std::size_t bytesOfTrack(const Track& track) {
  return sizeof track + bytesOf(track.times) + bytesOf(track.values);
}

bool standsAt(const std::vector<Clip>& clips, std::size_t clip, std::size_t track, const void* identity) {
  return clip < clips.size() && track < clips[clip].tracks.size() &&
         clips[clip].tracks[track].identity() == identity;
}

// An edited key makes new lists of tracks; of the tracks only those that were edited are new.
std::size_t bytesOfClips(const std::shared_ptr<const std::vector<Clip>>& clips,
                         const std::shared_ptr<const std::vector<Clip>>& other) {
  if (clips == other || clips == nullptr) {
    return 0;
  }
  std::size_t bytes =
      bytesOf(*clips, [](const Clip& clip) { return bytesOf(clip.tracks) + clip.name.size(); });
  for (std::size_t clip = 0; clip < clips->size(); ++clip) {
    const std::vector<CopyOnWrite<Track>>& tracks = (*clips)[clip].tracks;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      const bool isShared = other != nullptr && standsAt(*other, clip, i, tracks[i].identity());
      bytes += isShared ? 0 : bytesOfTrack(*tracks[i]);
    }
  }
  return bytes;
}

std::size_t bytesOfLimbs(const std::vector<rig::Limb>& limbs) {
  return bytesOf(limbs, [](const rig::Limb& limb) {
    return limb.id.size() + bytesOf(limb.joints) +
           bytesOf(limb.reasons, [](const std::string& reason) { return reason.size(); });
  });
}

struct HeldBytes : IgnoredParts {
  std::size_t bytes = 0;

  template <typename Entries, typename Each>
  void list(const Entries& entries, bool /*needsOne*/, const Each& /*each*/) {
    bytes += bytesOf(entries);
  }
  template <typename Values>
  void rest(const Values& values) {
    bytes += bytesOf(values);
  }
};

std::size_t bytesOfThings(const Document& document) {
  HeldBytes held;
  eachList(document, [&](const auto& list) {
    held.bytes += bytesOf(list);
    for (const auto& thing : list) {
      visitParts(thing, held);
    }
  });
  return held.bytes;
}

// A prop from a file of its own makes another scene.
std::size_t bytesOfScene(const std::shared_ptr<const Scene>& scene,
                         const std::shared_ptr<const Scene>& other) {
  if (scene == other || scene == nullptr) {
    return 0;
  }
  constexpr std::size_t bytesOfVertex = 64;
  std::size_t bytes = 0;
  for (const Mesh& mesh : scene->meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      bytes += primitive.positions.size() * bytesOfVertex + bytesOf(primitive.indices);
    }
  }
  return bytes;
}

// A clip from another file makes another source.
std::size_t bytesOfSource(const std::shared_ptr<const gltf::Source>& source,
                          const std::shared_ptr<const gltf::Source>& other) {
  if (source == other || source == nullptr) {
    return 0;
  }
  return bytesOf(source->buffers, [](const std::vector<std::uint8_t>& buffer) { return buffer.size(); });
}

} // namespace

std::size_t bytesBeyond(const Document& document, const Document& other) {
  std::size_t bytes = sizeof document + bytesOfClips(document.clips, other.clips) +
                      bytesOfScene(document.scene, other.scene) +
                      bytesOfSource(document.source, other.source);
  bytes += bytesOf(document.followingKeys, [](const FollowingKeys& keys) { return bytesOf(keys.keys); });
  const auto textBytes = [](const std::string& text) { return text.size(); };
  bytes += bytesOf(document.warnings, textBytes);
  bytes += bytesOf(document.selectionSets, [&](const SelectionSet& set) {
    return set.name.size() + bytesOf(set.limbs, textBytes) + bytesOf(set.controllers, textBytes);
  });
  bytes += bytesOf(document.references, [](const Reference& reference) {
    return reference.images.file.size() + reference.sound.file.size();
  });
  return bytes + bytesOfLimbs(document.body.limbs) + bytesOfLimbs(document.chains) + bytesOfThings(document) +
         bytesOf(document.loopingClips) + bytesOf(document.rates);
}

} // namespace stretch::app
